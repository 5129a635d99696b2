"""The sides of a chain while its row is laid out, and what is asked of one."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    Rounded,
    has_quantity,
    has_unit_vector,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import negative
from restitution.render import layout as lay
from restitution.workings.naming.plain_angles import has_plain_angles, of_plain_angles
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.row_sides import turned_side
from restitution.workings.naming.sources import is_displacement, is_time


@dataclass
class Draft:
    """A chain while its row is laid out: the sides as trees and as layouts, with their signs."""

    line: Line
    links: tuple[Link, ...]
    trees: list[Expression]
    in_figures: frozenset[int]
    sides: list[lay.Layout]
    signs: list[str]
    #: Exact values behind figures, by the numbers of their sides: none stands in the end.
    idle: dict[int, lay.Layout]
    #: Sides with figures put in, which are still to be worked out.
    worked: list[lay.Layout]
    #: Sides in which angles of the one before are joined by a formula, with a calculator.
    joined: list[lay.Layout]


def is_value(tree: Expression) -> bool:
    """Whether a side names one quantity, whose dimension is known."""
    return isinstance(tree, Letter | Quantity) or is_time(tree) or is_displacement(tree)


def is_multiple(side: lay.Layout) -> bool:
    """Whether a side is a number, or one before letters and their powers."""
    if isinstance(side, lay.Sum) and len(side.terms) == 1:
        side = side.terms[0][1]  # a negative one
    factors = side.factors if isinstance(side, lay.Product) else (side,)
    open_ = lay.Sum | lay.Fraction | lay.Brackets | lay.Number | lay.Function | lay.Product
    return isinstance(factors[0], lay.Number) and not any(
        isinstance(factor, open_) for factor in factors[1:]
    )


def is_made_of_figures(tree: Expression) -> bool:
    """Whether a side has numbers alone."""
    return not (has_quantity(tree) or letters(tree) or has_plain_angles(tree))


def is_rounded_below(trees: Sequence[Expression], n: int) -> bool:
    """Whether a side has figures in it, and the next one is a number of degrees alone."""
    rounded = any(isinstance(node, Rounded) for node in walk(trees[n - 1]))
    number = of_plain_angles(trees[n]) and not has_unit_vector(trees[n])
    return rounded and number and not has_quantity(trees[n])


def sign_of(link: Link) -> str:
    """The sign of a link as it is printed."""
    return lay.SIGNS.get(link.sign, link.sign)


def is_by_axis(derivation: Derivation, line: Line) -> bool:
    """Whether a ratio is that of a line of centres which a line tells, and of no components."""
    above = derivation.lines_in(line.premises)
    return any(
        isinstance(own.relation, Relation)
        and is_quantity(own.relation.options[0][0].left, "line_of_centres")
        for own in above
    )


def tangent_left_out(derivation: Derivation, line: Line, link: Link) -> Expression | None:
    """The given sum or difference of angles of which a row is the tangent, if it is left out.

    None where the row has the tangent of an angle on a side.
    """
    if line.move.record != "sum-of-angles" or not isinstance(link.left, Binary):
        return None
    if link.left.op != "/" or isinstance(link.right, Apply):
        return None
    for ref in line.premises:
        fact = derivation.fact(ref)
        if fact is not None and fact.kind == "given" and len(fact.relation.options) == 1:
            match fact.relation.only:
                case (Link(Binary("+" | "-") as angle, "="),):
                    return angle
    return None


def unrationalised(naming: Naming, ratio: Expression) -> lay.Layout:
    """A quotient by a root as it stands, where its layout would have a whole number below."""
    own, whole = unsigned(ratio), naming.layout(ratio)
    match own:
        case Binary("/", Number() as above, below) | Binary(
            "/", Letter() | Binary("*") as above, Apply("sqrt") as below
        ) if not letters(below):
            quotient = lay.Fraction(naming.layout(above), naming.layout(below))
            return quotient if own is ratio else lay.negative(quotient)
    return whole


def as_printed(naming: Naming, right: Expression, side: lay.Layout) -> Expression | None:
    """A side as it is printed: that of a component away from a wall has the other sign.

    None where it is printed in another form.
    """
    own = naming.layout(right)
    other = turned_side(own) or lay.negative(own)
    return {own: right, other: negative(right)}.get(side)
