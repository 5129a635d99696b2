"""Angles that right angles bound, by the signs of components or of a scalar product."""

from __future__ import annotations

from typing import Literal

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Letter,
    Negate,
    Quantity,
    Unit,
    has_quantity,
    is_zero,
)

Order = Literal["<", ">", "<=", ">="]
_WEAK: dict[Order, Order] = {"<": "<=", ">": ">=", "<=": "<=", ">=": ">="}
_AGAINST: dict[Order, Order] = {"<": ">", ">": "<", "<=": ">=", ">=": "<="}


def signs_behind(derivation: Derivation, line: Line) -> tuple[tuple[Quantity, Order], ...]:
    """The signs of a scalar product, or of components along **i** and **j**, that bound an angle.

    None of a line that rests on anything else, as a ratio of the angle.
    """
    if line.move.id != "compare" or not isinstance(line.relation, Relation):
        return ()
    angles = [side for side in trees_of(line.relation) if has_quantity(side)]
    if not all(isinstance(angle, Quantity) and angle.kind in ANGLES for angle in angles):
        return ()
    weak = all(link.sign in ("<=", ">=") for link in line.relation.options[0])
    signs: list[tuple[Quantity, Order]] = []
    for ref in line.premises:
        own = derivation.line(ref)
        if own is None or not isinstance(own.relation, Relation):
            continue
        sign = _sign(derivation, own.relation)
        if sign is None:
            return ()
        signs.append((sign[0], _WEAK[sign[1]]) if weak and _is_a_value(own.relation) else sign)
    return tuple(signs)


def _is_a_value(relation: Relation) -> bool:
    """Whether a line gives a value, which may be zero at an end."""
    return relation.options[0][0].sign == "="


def _sign(derivation: Derivation, relation: Relation) -> tuple[Quantity, Order] | None:
    """The sign that a line gives a component or a product: it compares it, or shows its value."""
    order: Order
    match relation.options:
        case ((Link(subject, ("<" | ">" | "<=" | ">=") as order, right),),) if is_zero(right):
            pass
        case ((Link(subject, "="), *_) as links,):
            order = "<" if isinstance(links[-1].right, Negate) else ">"
        case _:
            return None
    if isinstance(subject, Letter) and subject.name in derivation.meanings:
        meaning = derivation.meanings[subject.name]
        if isinstance(meaning.sense, Negate):
            order = _AGAINST[order]
        subject = meaning.quantity
    match subject:
        case Quantity("dot"):
            return subject, order
        case Quantity("along", (Quantity("velocity"), Unit())):
            return subject, order
        case Quantity(
            "along" | "across" as kind,
            (Quantity("velocity") as velocity, Quantity("line_of_centres", (), int(event))),
        ):
            fact = derivation.fact(f"axis {event}")
            axis = None if fact is None else fact.relation.only[0].right
            if isinstance(axis, Negate):
                axis, order = axis.operand, _AGAINST[order]
            if not isinstance(axis, Unit):
                return None
            if kind == "across":
                # At 90° anticlockwise from **i** is **j**, and from **j** the opposite of **i**.
                order = order if axis.axis == "i" else _AGAINST[order]
                axis = Unit("j" if axis.axis == "i" else "i")
            return Quantity("along", (velocity, axis)), order
    return None


__all__ = ["Order", "signs_behind"]
