"""What a sphere strikes first on its way: another wall, or another sphere.

Of walls and of spheres that move uniformly from known places it is told that they are not in the
way, as conditions, in letters or in numbers.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Literal

from restitution.exact.symbols import expression_of, symbols_in
from restitution.expression.evaluate import Scalar
from restitution.expression.tree import Name
from restitution.problem import Wall
from restitution.shapes import Segment
from restitution.solving.story import contacts
from restitution.solving.story.conditions import AnyOf, Condition
from restitution.solving.story.state import State
from restitution.solving.story.unknowns import Letters, proved_sign
from restitution.vector import Vector

_ON_IT: tuple[tuple[int, int, tuple[Condition, ...]], ...] = ((0, 0, ()),)
"""The side of a wall that centres without a radius touch."""


def nothing_first(
    state: State,
    name: str,
    target: Wall | None,
    start: Vector,
    velocity: Vector,
    flight: Scalar,
    number: int,
    partners: tuple[str, ...] = (),
) -> None:
    """No other wall or sphere whose place is known is struck before."""
    radius = state.radius(name)
    left = state.latest(name, number - 1)
    at_partner = [
        event.bodies
        for partner in partners
        if partner != name and (event := state.latest(partner, number - 1)) is not None
    ]
    _no_sphere_first(state, name, partners, flight, number, at_wall=target is not None)
    for wall in state.walls.values():
        shape = wall.shape
        if wall is target or shape.point is None:
            continue
        if left is not None and wall.name in left.bodies:
            continue  # it has just left that wall
        through = state.read_vector(shape.point, "")
        along = state.wall_direction(Name(wall.name))
        normal = along.turned_left()
        gap, speed = normal.dot(start - through), normal.dot(velocity)
        if state.field.is_zero(speed):
            continue
        reason = f"{name} strikes {wall.name} first"
        # A sphere that is at the wall is struck there before the wall is; a point is reached so.
        relation: Literal[">", ">="] = (
            ">="
            if (target is None and not partners)
            or any(wall.name in bodies for bodies in at_partner)
            else ">"
        )
        # It comes to the wall's line after ``ahead`` ÷ ``whole``.
        may_vanish = _may_vanish(state, speed)
        whole = state.rational(speed * speed) if may_vanish else 1
        for side, away, unless in (
            sides_of_wall(state, gap, speed) if radius is not None else _ON_IT
        ):
            reach = 0 if radius is None else radius * state.size(normal)
            ahead, gone = (
                state.rational(-value * speed if may_vanish else -value / speed)
                for value in (gap - side * reach, gap - away * reach)
            )
            options = [
                *unless,
                Condition(-gone, ">=", reason, "place"),
                Condition(ahead - flight * whole, relation, reason, "place"),
            ]
            if isinstance(shape, Segment):
                share = state.rational(((start - through) * whole + velocity * ahead).dot(along))
                options.append(Condition(-share, ">=", reason, "place"))
                options.append(Condition(share - along.dot(along) * whole, ">=", reason, "place"))
            state.conditions.append(AnyOf(tuple(options), reason))


def sides_of_wall(
    state: State, gap: Scalar, speed: Scalar
) -> tuple[tuple[int, int, tuple[Condition, ...]], ...]:
    """On which side of a wall a sphere comes to it, and on which it is where it moves away.

    Where letters leave the side open, it comes from that from which it moves. Where they leave the
    speed towards the wall open as well, these are both sides, each with the condition that it does
    not come from there.
    """
    side = proved_sign(state, gap)
    if side:
        return ((side, side, ()),)
    sense = proved_sign(state, speed)
    if sense is not None:
        return ((-sense or 1, sense or 1, ()),)
    return tuple((one, -one, (Condition(one * speed, ">=", "", "place"),)) for one in (-1, 1))


def _may_vanish(state: State, speed: Scalar) -> bool:
    """Whether letters let a sphere move parallel to a wall, or stay: nothing divides by it then."""
    unknowns = state.unknowns
    return isinstance(unknowns, Letters) and not unknowns.proved_sign(expression_of(speed))


def _no_sphere_first(
    state: State,
    name: str,
    partners: tuple[str, ...],
    flight: Scalar,
    number: int,
    *,
    at_wall: bool,
) -> None:
    """No sphere is struck before that moves uniformly from a known place.

    Nor is one struck in the instant of an impact ``at_wall`` that is nearer to the wall.
    """
    own = state.place(name, number - 1)
    if own is None:
        return
    left = state.latest(name, number - 1)
    for other, track in state.tracks.items():
        known = state.place(other, number - 1)
        if other == name or other in partners or known is None:
            continue
        latest = state.latest(other, number - 1)
        if left is not None and left is latest:
            continue  # they have just left each other
        if track.places[-1][0] != (0 if latest is None else latest.number):
            continue  # nobody knows where it has been since
        v, w = state.velocity(name, number - 1), state.velocity(other, number - 1)
        if state.field.exact:
            for start, unless in _starts(state, own[1], known[1]):
                gap = known[0] + w * (start - known[1]) - own[0] - v * (start - own[1])
                duration = own[1] + flight - start
                towards = v if at_wall else None
                _no_contact_within(state, name, other, gap, v - w, duration, unless, towards)
            continue
        state.needs_numbers = True
        start = later(state, own[1], known[1])
        gap = known[0] + w * (start - known[1]) - own[0] - v * (start - own[1])
        reason = f"{name} strikes {other} first"
        order = _order(state, name, other, gap, v - w)
        if order is not None and state.still(gap):
            # They are still in contact, and one of them was struck.
            state.conditions.append(Condition(order.dot(w - v), ">=", reason, "place"))
            continue
        touch = _first_touch(state, state.radius(name), gap, v - w)
        if touch is not None:
            spare = start + touch - (own[1] + flight)
            in_front = at_wall and order is not None and state.sign(v.dot(order)) == 1
            state.conditions.append(Condition(spare, ">" if in_front else ">=", reason, "place"))


def _order(state: State, name: str, other: str, gap: Vector, approach: Vector) -> Vector | None:
    """From one point sphere to another on a line that they keep to, as they lay when they met."""
    order = state.contact_lines.get((name, other))
    if order is None or state.radius(name) is not None:
        return None
    across = (state.rational(order.cross(vector)) for vector in (gap, approach))
    return order if all(map(state.field.is_zero, across)) else None


def _first_touch(
    state: State, radius: Scalar | None, gap: Vector, approach: Vector
) -> Scalar | None:
    """After how long two spheres are first in contact, in numbers; None where they pass by."""
    reach = 0 if radius is None else 2 * radius
    ga, ww = gap.dot(approach), approach.dot(approach)
    if state.sign(ga) != 1:
        return None
    under = ga * ga - ww * (gap.dot(gap) - reach * reach)
    side = state.sign(under)
    if side == -1 or (side == 0 and radius is not None):
        return None
    touch = (ga - (state.field.sqrt(under) if side == 1 else 0)) / ww
    return touch if state.sign(touch) != -1 else None


def _starts(state: State, a: Scalar, b: Scalar) -> Iterator[tuple[Scalar, tuple[Condition, ...]]]:
    """The later of two times in letters, each with the condition that it is not the later one."""
    sign = proved_sign(state, a - b)
    if sign is None or sign >= 0:
        yield a, () if sign is not None else (Condition(b - a, ">", "", "place"),)
    if sign is None or sign < 0:
        yield b, () if sign is not None else (Condition(a - b, ">=", "", "place"),)


def _no_contact_within(
    state: State,
    name: str,
    other: str,
    gap: Vector,
    approach: Vector,
    duration: Scalar,
    unless: tuple[Condition, ...],
    towards: Vector | None,
) -> None:
    """Two spheres, a gap apart at first, do not touch within a time, as conditions in letters.

    They do not where they separate or pass by, and where at the end they still approach and are
    two radii apart. Who goes ``towards`` a wall may not touch at the end either who is in front.
    """
    values = (*gap, *approach, duration)
    if not any(symbols_in(expression_of(x)) for x in values):
        return  # a telling in numbers sees it
    if contacts.rests_on(values, ()):
        return  # it is told again with what is found
    reason = f"{name} strikes {other} first"
    cross, end = gap.cross(approach), gap - approach * duration
    radius = state.radius(name)
    options = [*unless, Condition(-gap.dot(approach), ">=", reason, "place")]
    order = _order(state, name, other, gap, approach)
    ends: list[tuple[Condition, ...]] = [(Condition(end.dot(approach), ">=", reason, "place"),)]
    if order is not None and towards is not None:
        behind = Condition(-order.dot(towards), ">=", reason, "place")
        ends.append((Condition(end.dot(approach), ">", reason, "place"), behind))
    if order is not None:
        # Without a gap they are still in contact: then their order tells whether they approach.
        options[-1:] = [
            Condition(-gap.dot(approach), ">", reason, "place"),
            Condition(-order.dot(approach), ">=", reason, "place"),
        ]
    elif radius is None:
        options.append(Condition(cross, "!=", reason, "place"))
    else:
        reach = 4 * radius * radius
        passing = cross * cross - reach * approach.dot(approach)
        options.append(Condition(passing, ">=", reason, "place"))
        options.append(Condition(reach - gap.dot(gap), ">", reason, "place"))
        ends.append((Condition(end.dot(end) - reach, ">=", reason, "place"),))
    options = [replace(option, value=state.rational(option.value)) for option in options]
    left_open: list[Condition] = []
    for option in options:
        holds = _is_met(state, option)
        if holds:
            return
        if holds is None:
            left_open.append(option)
    for at_end in ends:
        some = [replace(option, value=state.rational(option.value)) for option in at_end]
        if not any(_is_met(state, option) for option in some):
            state.conditions.append(AnyOf((*left_open, *some), reason))


def _is_met(state: State, condition: Condition) -> bool | None:
    """Whether a condition holds for all letters, or for none; None where it depends on them."""
    sign = proved_sign(state, condition.value)
    if sign is None:
        return None
    return {">": sign > 0, ">=": sign >= 0, "!=": sign != 0}[condition.relation]


def later(state: State, a: Scalar, b: Scalar) -> Scalar:
    """The later of two times; the first where the letters decide."""
    sign = state.sign(a - b)
    return a if sign is None or sign >= 0 else b
