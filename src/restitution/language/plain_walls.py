"""Walls that are told by a turn from a direction, as what that comes to: a vector or an angle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    letters,
    rational,
)
from restitution.problem import Problem, Wall

_HALF_TURN = 180


def with_plain_walls(problem: Problem) -> Problem:
    """The problem with walls told plainly: ``1 at 90° from 3i + 4j`` is (-4, 3).

    What is turned from another wall is told by the direction of that, where it has one. What comes
    to no plain direction stays.
    """
    known = {wall.name: wall for wall in problem.walls}
    walls = [replace(wall, along=_plain(wall.along, known, ())) for wall in problem.walls]
    if all(
        own is wall.along for own, wall in zip((w.along for w in walls), problem.walls, strict=True)
    ):
        return problem
    return replace(problem, walls=type(problem.walls)(walls))


def _plain(tree: Expression, walls: Mapping[str, Wall], above: tuple[str, ...]) -> Expression:
    match tree:
        case Polar(Number(size), angle, origin, None) if size > 0 and origin is not None:
            base = _base(origin, walls, above)
        case Quantity("direction", (Name(name),), _) if name in walls:
            return _base(tree, walls, above) or tree
        case _:
            return tree
    if base is None:
        return tree
    if isinstance(base, Degrees) and isinstance(angle, Degrees):
        turned = (base.value + angle.value) % _HALF_TURN
        return Unit("j") if turned == 90 else Degrees(turned) if turned else Unit("i")
    if isinstance(base, Degrees) and isinstance(angle, Letter):
        return angle if base.value == 0 else Binary("+", base, angle, place=tree.place)
    if not isinstance(angle, Degrees) or abs(angle.value) != 90:
        return tree
    parts = _numbers(base)
    if parts is None:
        return tree
    x, y = parts
    return _vector(-y, x) if angle.value > 0 else _vector(y, -x)


def _vector(x: Fraction, y: Fraction) -> Expression:
    """A vector as people write it: ``-4i + 3j``."""
    first, second = _times(abs(x), Unit("i")), _times(abs(y), Unit("j"))
    if x == 0 or y == 0:
        alone, sign = (second, y) if x == 0 else (first, x)
        return Negate(alone) if sign < 0 else alone
    return Binary("+" if y > 0 else "-", Negate(first) if x < 0 else first, second)


def _times(size: Fraction, unit: Unit) -> Expression:
    return unit if size == 1 else Binary("*", rational(size), unit)


def _base(
    origin: Expression, walls: Mapping[str, Wall], above: tuple[str, ...]
) -> Expression | None:
    """From what a direction is turned: an angle, or a vector; None where that is told nowhere."""
    match origin:
        case Unit("i"):
            return Degrees(Fraction(0))
        case Unit("j"):
            return Degrees(Fraction(90))
        case Negate(Unit() as unit):
            return _base(unit, walls, above)
        case Quantity("direction", (Name(name),), _):
            wall = walls.get(name)
            if wall is None or wall.along is None or name in above:
                return None
            own = _plain(wall.along, walls, (*above, name))
            return _base(own, walls, above) if isinstance(own, Unit | Negate) else own
    return origin


def _numbers(tree: Expression) -> tuple[Fraction, Fraction] | None:
    """The components of a vector in numbers; None of another one."""
    if letters(tree) or has_quantity(tree):
        return None
    import sympy as sp  # who only reads a statement needs no algebra

    from restitution.expression.evaluate import in_letters
    from restitution.vector import Vector

    try:
        value = in_letters(tree)
    except RestitutionError:
        return None
    if not isinstance(value, Vector):
        return None
    x, y = (sp.sympify(part, strict=True) for part in value)
    if not (x.is_Rational and y.is_Rational):
        return None
    return Fraction(int(x.p), int(x.q)), Fraction(int(y.p), int(y.q))


__all__ = ["with_plain_walls"]
