"""Distances that are a coordinate of a line above: nothing is worked out for them."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, Literal, TypeAlias

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Derivation, Line, Link, Ref, Relation
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Pair,
    Quantity,
    Stage,
    Unit,
    unsigned,
)
from restitution.vector import Vector

_Axis: TypeAlias = Literal["i", "j"]
_Known: TypeAlias = Mapping[tuple[Expression, _Axis], sp.Expr]
_AXES: tuple[tuple[_Axis, _Axis], ...] = (("i", "j"), ("j", "i"))


def axis_restated(derivation: Derivation, line: Line) -> Unit | None:
    """The axis of the coordinate, or of the displacement, that a distance says once more.

    None of a distance that takes one step or more, and of any other line.
    """
    match line.relation if line.move.record == "distance" else None:
        case Relation(((Link(Quantity("distance") as own, "=", distance),),)):
            pass
        case _:
            return None
    for cited in derivation.lines_in(line.premises):
        match cited.relation:
            case Relation(
                ((Link(Binary("-", Quantity("along", (Quantity("position"), axis)), _)), *_),)
            ) as displacement if isinstance(axis, Unit):
                if unsigned(displacement.only[-1].right) == distance:
                    return axis
    return _axis_of_a_coordinate(derivation, line, own, _value(distance))


def _axis_of_a_coordinate(
    derivation: Derivation, line: Line, own: Quantity, distance: Any
) -> Unit | None:
    """The axis in which one end is at 0, and the other as far from there as a line says.

    In the other one both have the same coordinate. Where lines say both places there is a
    difference to be taken.
    """
    known = dict(_coordinates(derivation, line.premises))
    ends = [_place(end, own.stage) for end in own.arguments]
    lines = [ref for ref in line.premises if isinstance(ref, int)]
    if len({place for (place, _), _ in _coordinates(derivation, lines)} & {*ends}) != 1:
        return None
    for axis, other in _AXES:
        along = [_coordinate(known, end, axis) for end in ends]
        beside = [_coordinate(known, end, other) for end in ends]
        if None in (*along, *beside) or beside[0] != beside[1] or 0 not in along:
            continue
        if distance in (*along, *(-value for value in along if value is not None)):
            return Unit(axis)
    return None


def _place(end: Expression, stage: Stage) -> Expression:
    """An end of a distance, as lines and facts name a place."""
    return Quantity("position", (end,), stage) if isinstance(end, Name) else end


def _coordinate(known: _Known, place: Expression, axis: _Axis) -> sp.Expr | None:
    """A coordinate of a place that is known; a point has it at all times."""
    if isinstance(place, Pair):
        own = _value(place)
        return _part(own, axis) if isinstance(own, Vector) else None
    value = known.get((place, axis))
    if value is None and isinstance(place, Quantity):
        return known.get((Quantity("position", place.arguments), axis))
    return value


def _coordinates(
    derivation: Derivation, refs: Iterable[Ref]
) -> Iterator[tuple[tuple[Expression, _Axis], sp.Expr]]:
    """The coordinates of places that lines and facts say."""
    for ref in refs:
        cited = derivation.cited(ref)
        relation = None if cited is None else cited.relation
        if not isinstance(relation, Relation) or len(relation.options) > 1:
            continue
        value = _value(relation.only[-1].right)
        match relation.only[0].left:
            case Quantity("along", (Quantity("position") as place, Unit(axis))) if (
                value is not None
            ):
                yield (place, axis), value
            case Quantity("position") as place if isinstance(value, Vector):
                yield from (((place, axis), _part(value, axis)) for axis, _ in _AXES)


def _part(place: Vector, axis: _Axis) -> sp.Expr:
    return sp.sympify(place.x if axis == "i" else place.y, strict=True)


def _value(tree: Expression) -> Any:
    """The value of a tree in letters; None where it has none by itself."""
    try:
        return in_letters(tree)
    except RestitutionError:
        return None


__all__ = ["axis_restated"]
