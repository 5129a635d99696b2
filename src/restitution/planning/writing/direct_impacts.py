"""Impacts with a wall that are known to be direct: no line says that a component is zero."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.definitions.ties import tie_of
from restitution.explaining.lines.derivation import Derivation, Event, Line, Link, Relation
from restitution.expression.tree import Expression, Name, Quantity, is_quantity, is_zero


def with_direct_impacts(derivation: Derivation) -> Derivation:
    """The same working without the components along a wall of who comes straight at it.

    That is given, or the line of the radius is that of the velocity. What comes out as zero stays.
    """
    hidden: set[int] = set()
    for event in derivation.events:
        zeros = [line for line in derivation.lines if _is_nothing_along(line, event)]
        early = [line for line in zeros if line.move.record != "unchanged"]
        if any(_comes_straight(derivation, event, line) for line in early):
            hidden |= {line.number for line in zeros}
    hidden -= {end.line for end in derivation.items}
    return replace(
        derivation,
        lines=tuple(
            replace(line, shown="silent") if line.number in hidden else line
            for line in derivation.lines
        ),
    )


def _is_nothing_along(line: Line, event: Event) -> bool:
    """Whether a line says that a component along a wall is zero, before an impact or after it."""
    if not event.wall or line.move.event != event.number or not isinstance(line.relation, Relation):
        return False
    if (
        line.move.record not in ("component", "perpendicular", "unchanged")
        or len(line.relation.options) > 1
    ):
        return False
    links = line.relation.only
    left = links[0].left
    return is_quantity(left, "across") and is_zero(links[-1].right)


def _comes_straight(derivation: Derivation, event: Event, line: Line) -> bool:
    """Whether a velocity is given as perpendicular to the wall, or as a multiple of its radius."""
    assert isinstance(line.relation, Relation)
    component = line.relation.only[0].left
    assert isinstance(component, Quantity)
    velocity = component.arguments[0]
    part = derivation.asked.get(line.item or "")
    for fact in derivation.facts:
        if fact.kind == "given" and fact.part in (None, part) and len(fact.relation.options) == 1:
            tie = tie_of(fact.relation.only[0])
            walls = (velocity, Name(event.bodies[1]))
            if tie is not None and tie[2] == "perpendicular to" and set(tie[:2]) == set(walls):
                return True
    given = derivation.fact(f"velocity {event.bodies[0]}")
    radius = _radius(derivation, event)
    if given is None or not isinstance(velocity, Quantity) or velocity.stage != 0:
        return False
    return radius is not None and given.relation.only[-1].right == radius


def _radius(derivation: Derivation, event: Event) -> Expression | None:
    """The vector to which a line says that the radius at an impact is parallel."""
    axis = Quantity("line_of_centres", (), event.number)
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(left, "parallel to", vector),),)) if left == axis:
                return vector
    return None


__all__ = ["with_direct_impacts"]
