"""The angle that a path makes with a wall or a line of centres, where both are told from **i**."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from restitution.explaining.lines.derivation import Fact
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Polar,
    Unit,
    is_binary,
    letters,
    negated,
    unsigned,
    walk,
)


def turn_of_path(velocity: Fact | None) -> Expression | None:
    """The angle from **i** of a velocity of the data, in degrees or in letters; None without one.

    A velocity along **i** or **j** has one too.
    """
    return None if velocity is None else turn_of_vector(velocity.relation.only[-1].right)


def turn_of_vector(right: Expression) -> Expression | None:
    """The angle from **i** of a vector by an angle, or along **i** or **j**; None of another."""
    match right:
        case Polar(_, angle, None, None):
            return angle if _is_plain(angle) else _worked_out(angle)
    units = {node.axis for node in walk(right) if isinstance(node, Unit)}
    if units not in ({"i"}, {"j"}) or any(isinstance(node, Polar) for node in walk(right)):
        return None
    back = isinstance(right, Negate) or _is_behind(right)
    if back is None:
        return None
    turn = Fraction(180 if back else 0) if units == {"i"} else Fraction(-90 if back else 90)
    return Negate(Degrees(-turn)) if turn < 0 else Degrees(turn)


def _worked_out(angle: Expression) -> Expression | None:
    """A sum of degrees as one number, as 132° for 180° − 48°; None of another angle."""
    if not all(isinstance(node, Degrees) or is_binary(node, "+", "-") for node in walk(angle)):
        return None
    size = degrees_of(angle)
    return Negate(Degrees(-size)) if size < 0 else Degrees(size)


def _is_behind(velocity: Expression) -> bool | None:
    """Whether a multiple of **i** or **j** is a negative one; None of what is no plain multiple."""
    match velocity:
        case Unit():
            return False
        case Binary("*", factor, Unit()):
            return isinstance(factor, Negate)
    return None


def turn_of_line(line: Fact | None) -> Expression | None:
    """The angle from **i** at which a wall or a line of centres is given; None without one."""
    right = None if line is None else line.relation.only[-1].right
    match unsigned(right) if right is not None else None:
        case Degrees() | Letter():
            return right
    return None


def _is_plain(angle: Expression) -> bool:
    """Whether an angle is a number of degrees or a letter, with either sign."""
    return isinstance(unsigned(angle), Degrees | Letter)


def angle_between(path: Expression, line: Expression) -> Expression | None:
    """The angle of a path in degrees with a line in degrees, as it is worked out: 80° − 25°.

    Up to a right angle, and one of degrees alone where nothing has to be worked out.
    """
    turns = in_degrees(path), in_degrees(line)
    if turns[0] is None or turns[1] is None:
        return None
    return next(
        tree
        for tree in _differences(path, line)
        if 0 <= (value := degrees_of(tree)) <= 90 and value == _least(turns[0] - turns[1])
    )


def angles_between(path: Expression, line: Expression) -> Iterator[Expression]:
    """What the angle of a path with a line may be, where one of both is a letter."""
    if path == line:
        yield Degrees(Fraction(0))
    elif letters(path) or letters(line):
        yield from _differences(path, line)


def _differences(path: Expression, line: Expression) -> Iterator[Expression]:
    for first, second in ((path, line), (line, path)):
        yield _less(first, second)
    for first, second in ((path, line), (line, path)):
        yield Binary("-", STRAIGHT_ANGLE, _less(first, second))
    yield Binary("-", _less(path, line), STRAIGHT_ANGLE)
    yield Binary("-", _less(line, path), STRAIGHT_ANGLE)
    yield Binary("-", Degrees(Fraction(360)), _less(path, line))


def _less(first: Expression, second: Expression) -> Expression:
    """One angle less another: without the other where it is 0, and a sum where it is negative."""
    if second == Degrees(Fraction(0)):
        return first
    if first == Degrees(Fraction(0)):
        return negated(second)
    if isinstance(second, Negate):
        return Binary("+", first, second.operand)
    return Binary("-", first, second)


def in_degrees(angle: Expression) -> Fraction | None:
    """An angle as a number of degrees; None where it is none."""
    match angle:
        case Degrees(value):
            return value
        case Negate(Degrees(value)):
            return -value
    return None


def degrees_of(tree: Expression) -> Fraction:
    """What a sum or a difference of degrees comes to."""
    match tree:
        case Degrees(value):
            return value
        case Negate(operand):
            return -degrees_of(operand)
        case Binary("+", left, right):
            return degrees_of(left) + degrees_of(right)
        case Binary("-", left, right):
            return degrees_of(left) - degrees_of(right)
    raise ValueError(tree)


def _least(turn: Fraction) -> Fraction:
    """The acute angle, or the right one, of two lines between which there is a turn."""
    rest = turn % 180
    return min(rest, 180 - rest)


__all__ = [
    "angle_between",
    "angles_between",
    "degrees_of",
    "in_degrees",
    "turn_of_line",
    "turn_of_path",
    "turn_of_vector",
]
