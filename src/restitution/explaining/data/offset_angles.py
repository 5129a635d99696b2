"""The angle between a line of centres and the path of a sphere that meets another off centre."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction

import sympy as sp

from restitution.explaining.data.paths_and_lines import in_degrees, turn_of_vector
from restitution.explaining.data.setting import Setting
from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.derivation import Line, Link, Meaning, Relation
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    unsigned,
)
from restitution.oracle import Oracle, compared
from restitution.oracle.roles import Role
from restitution.records import dataclass


@dataclass(frozen=True)
class OffsetAngle:
    """A line of centres by an offset: the ``path``, and the sine of the acute angle with it.

    ``right`` tells that the line of centres is to the right of the path.
    """

    axis: Expression
    path: Expression
    sine: Expression
    right: bool

    def at(self, letter: str) -> Polar:
        """The direction of the line of centres by a letter for the angle."""
        own: Expression = Letter(letter)
        return Polar(Number(Fraction(1)), Negate(own) if self.right else own, self.path)

    def turn(self, size: Expression) -> Fraction | None:
        """The angle from **i** of the line of centres, in degrees, by the ``size`` of that angle.

        None where the path has no such angle, or the size is no number of degrees.
        """
        path = turn_of_vector(self.path)
        turns = [None if tree is None else in_degrees(tree) for tree in (path, size)]
        if turns[0] is None or turns[1] is None:
            return None
        return turns[0] - turns[1] if self.right else turns[0] + turns[1]


def offset_angle(link: Link, roles: Mapping[str, Role]) -> OffsetAngle | None:
    """The angle of a line of centres that is given by an offset.

    None of any other line, where the first sphere does not move along the path and in its sense,
    and where the offset is not certain to be on one side.
    """
    match link:
        case Link(
            Quantity("line_of_centres") as axis,
            "=",
            Polar(_, Apply("arcsin", Binary("/", beside, apart)), path),
        ) if path is not None:
            pass
        case _:
            return None
    right = isinstance(beside, Negate)
    beside = unsigned(beside)
    world, oracle = World(roles), Oracle(roles)

    def is_positive(tree: Expression) -> bool:
        value = world.expression(world.scalar(tree), roles)
        return oracle.proves(compared(value, ">", sp.Integer(0)))

    try:
        if not is_positive(beside) or not _is_onward(path, world, oracle, roles):
            return None
    except NotComparableError:
        return None
    return OffsetAngle(axis, path, Binary("/", beside, apart), right)


def _is_onward(path: Expression, world: World, oracle: Oracle, roles: Mapping[str, Role]) -> bool:
    """Whether the first sphere itself moves along its path relative to the second, and onward."""
    match path:
        case Binary("-", own, _):
            one, other = world.value(own), world.value(path)
        case _:
            return True
    if not isinstance(one, Plane) or not isinstance(other, Plane):
        return False
    across = world.reduced(one.x * other.y - one.y * other.x)
    along = world.expression(one.x * other.x + one.y * other.y, roles)
    return across.vanishes and oracle.proves(compared(along, ">", sp.Integer(0)))


def angle_with_the_path(
    angle: Expression, links: Sequence[Link], roles: Mapping[str, Role]
) -> OffsetAngle | None:
    """The line of centres by an offset, where an angle is that with its path; else None."""
    match angle:
        case Quantity("angle", (one, other)):
            pass
        case _:
            return None
    world, oracle = World(roles), Oracle(roles)
    for axis, tree in ((one, other), (other, one)):
        given = {link.left: link.right for link in links if link.sign == "="}
        for link in links:
            own = offset_angle(link, roles) if link.left == axis else None
            if own is None:
                continue
            try:
                velocity, path = world.direction(given.get(tree, tree)), world.direction(own.path)
                if velocity is None or path is None:
                    continue
                across = world.reduced(velocity.x * path.y - velocity.y * path.x)
                along = world.expression(velocity.x * path.x + velocity.y * path.y, roles)
            except NotComparableError:
                continue
            if across.vanishes and oracle.proves(compared(along, ">", sp.Integer(0))):
                return own
    return None


def named_angles(
    lets: Sequence[Meaning], links: Sequence[Link], setting: Setting
) -> Iterator[tuple[Meaning, OffsetAngle]]:
    """The letters for the acute angle of a path with the line of centres that an offset gives."""
    for meaning in lets:
        match meaning:
            case Meaning(
                _,
                Quantity(
                    "angle",
                    (
                        Quantity("velocity", (Name(body),), 0),
                        Quantity("line_of_centres", (), int(number)) as axis,
                    ),
                ),
                angle="acute",
            ):
                pass
            case _:
                continue
        event = setting.event(number)
        if event is None or body not in event.bodies:
            continue
        for link in links:
            own = offset_angle(link, setting.roles) if link.left == axis else None
            if own is not None and (
                event.bodies[0] == body or _goes_along(body, own.path, links, setting.roles)
            ):
                yield meaning, own


def _goes_along(
    body: str, path: Expression, links: Sequence[Link], roles: Mapping[str, Role]
) -> bool:
    """Whether the other sphere moves along the path of the first, in either sense, as is cited."""
    world = World(roles)
    for link in links:
        if link.left == Quantity("velocity", (Name(body),), 0) and link.sign == "=":
            own, other = world.direction(link.right), world.direction(path)
            if own is not None and other is not None:
                return world.reduced(own.x * other.y - own.y * other.x).vanishes
    return False


def letter_of_offset(line: Line) -> str | None:
    """The letter for the angle of a line of centres with a path, in the line of its sine."""
    if line.move.record != "scalar-angle" or not isinstance(line.relation, Relation):
        return None
    if line.shown == "silent":
        return None
    by_fact = any(str(ref).partition(" ")[0] == "axis" for ref in line.premises)
    match line.relation.options[0][0].left:
        case Apply("sin", Letter(name)) if by_fact:
            return name
    return None


__all__ = ["OffsetAngle", "angle_with_the_path", "letter_of_offset", "named_angles", "offset_angle"]
