"""The rules of the textbook form, in the order in which they are tried.

Those of numbers stand with `numbers`: what is written here rests on them.
"""

from __future__ import annotations

import sympy

from restitution.exact import bars, orientation, roots, trigonometry
from restitution.exact.nodes import is_multiple_of_sum, multiplied_in
from restitution.exact.numbers import NUMBERS
from restitution.exact.plain_angles import has_plain_angles, merged
from restitution.exact.rules import CONVENTION, Rule
from restitution.exact.simplicity import SEARCHED, TRIGONOMETRIC, node_count
from restitution.exact.symbols import atoms_in
from restitution.exact.trigonometry import InOneAngle

AT_FIRST = (Rule("plain angles merged", has_plain_angles, merged, CONVENTION),)

GIVEN = (
    Rule("bars inside bars", bars.has_bars_inside, bars.without_bars_inside, CONVENTION),
    Rule("a square over a size", bars.has_square_beside_size, bars.with_one_size, CONVENTION),
)
"""What is done with each node of an expression that has sizes."""


def _has_angles_made_of_others(value: sympy.Expr) -> bool:
    functions = (*TRIGONOMETRIC, sympy.atan, sympy.acos, sympy.asin)
    if all(function.args[0].is_Symbol for function in atoms_in(value, *functions)):
        return False
    return node_count(sympy.expand_trig(value), SEARCHED) < SEARCHED


SUMS_OF_ANGLES = Rule(
    "sines of sums of angles", _has_angles_made_of_others, sympy.expand_trig, CONVENTION
)
"""What gives an expression a second form, whose textbook form may be the shorter one."""

IN_LETTERS = (
    Rule(
        "tangents for cotangents",
        trigonometry.has_cotangents_alone,
        trigonometry.in_tangents,
        CONVENTION,
    ),
)
"""What is done before letters stand for functions."""

PRODUCTS_OF_ROOTS = (
    Rule("roots joined", roots.has_two_roots, roots.with_roots_joined, CONVENTION),
)

UNDER_ROOTS = (
    Rule("terms over a square", roots.has_squares_below, roots.over_a_square, CONVENTION),
)


def _form(name: str) -> Rule:
    return Rule(name, lambda value: name in value.forms, lambda value: value.as_(name))


OF_AN_ANGLE = (
    Rule("as it stands", lambda _: True, lambda value: value.value),
    _form("a sine over a cosine"),
    _form("squares of cosines by sines"),
    _form("squares of sines by cosines"),
    _form("one degree"),
    Rule("in the tangent", lambda value: bool(value.quotients_in_tangents), InOneAngle.as_tangents),
)
"""The forms of an expression in the sine, cosine and tangent of one angle (`InOneAngle`)."""

OF_ALL_ANGLES = (
    Rule(
        "a tangent below each term",
        trigonometry.is_sum_over_product,
        trigonometry.over_terms,
        1.0,
    ),
)

WITH_ROOTS = (
    Rule("a cosine into a root", roots.has_tangent_under_root, roots.into_root),
    Rule("a root divided", roots.has_sum_under_root_and_below, roots.divided_roots, CONVENTION),
)
"""What is done when roots stand where letters stood for them."""

SIGNS = (
    Rule(
        "over its own root", orientation.stands_over_its_root, orientation.over_its_root, CONVENTION
    ),
    Rule(
        "minuses below",
        orientation.has_minuses_below,
        orientation.without_minuses_below,
        CONVENTION,
    ),
    Rule("squares forward", orientation.is_turned_square, orientation.square_forward, CONVENTION),
)
"""How sums are turned in each node of the form that was chosen."""

TWO_ANGLES = (
    Rule(
        "the sine of a sum",
        trigonometry.is_of_two_angles,
        trigonometry.of_two_angles,
        CONVENTION,
    ),
)

MULTIPLIED_IN = (Rule("a number multiplied in", is_multiple_of_sum, multiplied_in),)
"""What is done to the form that was chosen; then all is done once more, and the shorter is taken.

With `PRODUCTS_OF_ROOTS`.
"""

RULES = (
    *AT_FIRST,
    *GIVEN,
    SUMS_OF_ANGLES,
    *IN_LETTERS,
    *PRODUCTS_OF_ROOTS,
    *UNDER_ROOTS,
    *OF_AN_ANGLE,
    *OF_ALL_ANGLES,
    *WITH_ROOTS,
    *SIGNS,
    *TWO_ANGLES,
    *MULTIPLIED_IN,
    *NUMBERS,
)
