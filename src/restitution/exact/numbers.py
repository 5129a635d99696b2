"""Numbers without letters: surds denested, denominators rational, a common factor in front."""

from __future__ import annotations

from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, S

from restitution.exact.nodes import in_front
from restitution.exact.rules import CONVENTION, Rule, improved
from restitution.exact.simplicity import HALF, TOUCHED, TRIGONOMETRIC, UNREADABLE, cost, node_count
from restitution.exact.surds import rationalised
from restitution.work import remembered, spend


def tidy_number(value: Expr) -> Expr:
    """A number without letters: surds denested, denominators rational, common factor in front."""
    spend()
    if value.is_Rational or value.is_Atom:
        return value
    plain = rationalised(value)
    if plain is not None:
        return _content_out(plain)
    if value.has(*TRIGONOMETRIC):
        value = sympy.expand_trig(value)
    if not all(isinstance(x, Rational | Add | Mul | Pow) for x in sympy.preorder_traversal(value)):
        return tidy_parts(value)
    value = _denest(value)
    whole = _content_out(rational_below(value))
    return improved(NUMBERS, whole)


def rational_below(value: Expr) -> Expr:
    """A number expanded, without roots in denominators of up to four terms."""
    plain = rationalised(value)
    return sympy.expand(sympy.radsimp(value, max_terms=4)) if plain is None else plain


@remembered(2048)
def denested(value: Expr) -> Expr:
    """Roots inside roots undone where that leaves none; else the number as it is."""
    plain = sympy.sqrtdenest(value)
    return value if is_nested(plain) else plain


def is_nested(value: Expr) -> bool:
    """Whether a root stands under a root."""
    return any(
        isinstance(node, Pow) and not node.exp.is_Integer and node.base.has(Pow)
        for node in sympy.preorder_traversal(value)
    )


def _denest(value: Expr) -> Expr:
    """Each root simplified, the innermost first."""
    return value if value.is_Atom or not value.has(Pow) else _denest_inside(value)


@remembered(2048)
def _denest_inside(value: Expr) -> Expr:
    value = value.func(*[_denest(argument) for argument in value.args])
    if not isinstance(value, Pow) or not isinstance(value.exp, Rational) or value.exp.q == 1:
        return value
    base = value.base
    if base.is_Rational:
        return value
    base = _content_out(rational_below(base))
    if value.exp.q != 2:
        return Pow(base, value.exp)
    if base.is_negative:
        return Pow(base, value.exp)
    content, rest = base.as_coeff_Mul()
    if base.is_Rational:
        root = sympy.sqrt(base)
    else:
        # √(p/q · R) = √(pq R)/q, with the squares in pq taken out.
        content = Rational(content)
        top = sympy.sqrt(Integer(content.p * content.q)) / content.q
        coefficient, surd = top.as_coeff_Mul()
        inside = rest if surd is S.One else sympy.expand(surd**2 * rest)
        root = coefficient * denested(sympy.sqrt(inside))
    power = root ** (2 * value.exp)
    return sympy.expand(power) if value.exp.p > 1 else power


def _content_out(value: Expr) -> Expr:
    """``3/8 + 3*sqrt(5)/8`` as ``3*(1 + sqrt(5))/8``; a positive term is left inside."""
    if not isinstance(value, Add):
        return value
    content, rest = value.primitive()
    if rest.could_extract_minus_sign() and all(
        term.could_extract_minus_sign() for term in Add.make_args(rest)
    ):
        content, rest = -content, -rest
    return in_front(content, rest)


def _is_sum_of_nested_roots(value: Expr) -> bool:
    inside = value.as_coeff_Mul()[1]
    return isinstance(inside, Add) and is_nested(inside)


def _one_root(value: Expr) -> Expr:
    """A sum of roots of roots as the root of its square, where that is plain."""
    squared = _content_out(rational_below(_denest(sympy.expand(value**2))))
    if is_nested(squared) or squared.is_positive is not True:
        return value
    root = _denest(sympy.sqrt(squared))
    if not isinstance(root.as_coeff_Mul()[1], Pow):
        return value
    return -root if value.is_negative else root


def _nested_roots(value: Expr) -> set[Pow]:
    return {x for x in value.atoms(Pow) if x.exp in (HALF, -HALF) and x.base.has(Pow)}


def _over_its_root(value: Expr) -> Expr:
    """``(34 + 19√3)√(11 − 4√3)/146`` as ``(2 + √3)/(2√(11 − 4√3))``, where that is shorter."""
    root = sympy.sqrt(_nested_roots(value).pop().base)
    factor = sympy.expand(value / root)
    if not isinstance(factor, Add) or factor.has(root.base):
        return value
    above = _content_out(rational_below(factor * root.base))
    return above / root if cost(above) + 2 < cost(_content_out(factor)) else value


def tidy_parts(value: Expr) -> Expr:
    """A number that contains functions: its arguments are tidied."""
    if value.is_Atom:
        return value
    arguments = [_inside(argument) for argument in value.args]
    return value.func(*arguments) if tuple(arguments) != value.args else value


@remembered(2048)
def _inside(value: Any) -> Any:
    """A number that stands in a function, tidied; as it is where no step can read it."""
    if not isinstance(value, Expr) or value.is_Atom or node_count(value, TOUCHED) >= TOUCHED:
        return value
    try:
        return tidy_number(value)
    except UNREADABLE:
        return value


NUMBERS = (
    Rule(
        "a root of a root below the line",
        lambda value: not value.free_symbols and len(_nested_roots(value)) == 1,
        _over_its_root,
        CONVENTION,
    ),
    Rule("roots of roots as one root", _is_sum_of_nested_roots, _one_root),
)
"""What is done with a number whose roots are undone as far as they can be."""
