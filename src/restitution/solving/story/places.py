"""Places and times: when a sphere comes to a wall, to a point, to another sphere, and where.

Between events every sphere moves uniformly, so the times follow from linear equations, or from a
quadratic one where spheres have size or a wall is a circle. What has to be so for an event to
happen as told (in order, on the wall, nothing struck before) becomes a condition of the story.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import sympy as sp

from restitution.errors import ImpossibleError
from restitution.exact import tidy
from restitution.expression.evaluate import Scalar
from restitution.expression.tree import Name, Place, has_quantity, line_and_column
from restitution.problem import Arrival, Compare, Given, Impact, Wall
from restitution.render.layout import from_sympy
from restitution.render.text import to_text
from restitution.shapes import Circle, Segment
from restitution.solving.algebra.neat import neat
from restitution.solving.story import contacts
from restitution.solving.story.conditions import Condition, Equation
from restitution.solving.story.obstacles import later, nothing_first, sides_of_wall
from restitution.solving.story.state import State
from restitution.solving.story.unknowns import Letters
from restitution.vector import Vector


def _lose(state: State, number: int, *names: str) -> None:
    """After an event at an unknown time nothing more is known of where these spheres are.

    Where the text gives no place, the first impact alone has one: it is where places and times
    are counted from, and what follows is not held to it.
    """
    for name in names:
        state.tracks[name].places.append((number, None, None))


def time_to_point(state: State, number: int, name: str, point: Vector, step: Arrival) -> Scalar:
    """When a sphere's centre comes to a point."""
    known = state.place(name, number - 1)
    velocity = state.velocity(name, number - 1)
    there = step.target.name if isinstance(step.target, Name) else "that point"
    if known is None:
        time = state.unknowns.hidden(f"t_{number}", f"the time of event {number}", "positive")
    else:
        displacement = point - known[0]
        if state.still(velocity):
            raise ImpossibleError(
                f"{name} is at rest and reaches nothing", *line_and_column(step.place)
            )
        flight = state.rational(displacement.dot(velocity) / velocity.dot(velocity))
        _off(
            state,
            displacement.cross(velocity),
            f"{name} does not pass through {there}",
            step.place,
        )
        _flight(state, name, flight, number, f"{name} moves away from {there}")
        if state.field.exact and contacts.rests_on((*known[0], *velocity), ()):
            state.needs_numbers = True  # it is told again with what is found
        else:
            nothing_first(state, name, None, known[0], velocity, flight, number)
        time = known[1] + flight
    state.tracks[name].places.append((number, point, time))
    return time


def _off(state: State, value: Scalar, reason: str, place: Place | None) -> None:
    if not state.field.is_zero(value):
        state.equations.append(Equation(value, reason, place))


def _flight(state: State, name: str, flight: Scalar, number: int, reason: str) -> None:
    """A time of flight must be positive."""
    state.conditions.append(Condition(flight, ">", reason, "time"))


def time_to_wall(state: State, number: int, name: str, wall: Wall) -> Scalar | None:
    """When a sphere comes to a wall; None where nothing is known of places."""
    known = state.place(name, number - 1)
    velocity = state.velocity(name, number - 1)
    radius = state.radius(name)
    if known is not None and not state.implied and _is_at(state, number, name, wall):
        state.tracks[name].places.append((number, *known))
        return known[1]
    shape = wall.shape
    if isinstance(shape, Circle):
        return _time_to_circle(state, number, name, wall, known, velocity, radius)
    if known is None or state.implied:
        _lose(state, number, name)
        return None
    if shape.point is None:
        time = state.unknowns.hidden(
            f"t_{number}", f"the place of the wall {wall.name}", "positive"
        )
        where = known[0] + velocity * (time - known[1])
        _flight(state, name, time - known[1], number, "times must be in order")
        state.tracks[name].places.append((number, where, time))
        return time
    through = state.read_vector(shape.point, f"the place of {wall.name}")
    along = state.wall_direction(Name(wall.name))
    normal = along.turned_left()
    gap = normal.dot(known[0] - through)
    speed = normal.dot(velocity)
    if state.field.is_zero(speed):
        raise ImpossibleError(f"{name} moves parallel to {wall.name} and does not reach it")
    if radius is not None:
        side = _side_of_wall(state, number, name, wall, gap, speed)
        gap = gap - side * radius * state.size(normal)
    flight = state.rational(-gap / speed)
    _flight(state, name, flight, number, f"{name} moves away from {wall.name}")
    where = known[0] + velocity * flight
    if state.field.exact:
        where = state.neat(where)
    if isinstance(shape, Segment):
        share = state.rational((where - through).dot(along))
        reason = f"{name} does not meet {wall.name} between its ends"
        shares = share, along.dot(along) - share
        if state.field.exact and where.x.is_number and where.y.is_number:
            reason = _off_the_wall(name, wall.name, where, shares) or reason
        state.conditions += [
            Condition(share, ">", reason, "place", end_of=wall.name) for share in shares
        ]
    nothing_first(state, name, wall, known[0], velocity, flight, number)
    time = known[1] + flight
    state.tracks[name].places.append((number, where, time))
    return time


def _off_the_wall(name: str, wall: str, where: Vector, shares: tuple[sp.Expr, ...]) -> str:
    """Where a sphere comes to the line of a wall, if not between its ends; empty if it does."""
    least = min(shares)
    if least > 0:
        return ""
    there = ", ".join(to_text(from_sympy(tidy(value))) for value in where)
    if least == 0:
        return f"{name} meets {wall} only at its end ({there}), and not between its ends"
    between = f"{name} does not meet {wall} between its ends"
    return f"{between}: it comes to the line of {wall} at ({there}), beyond them"


def _is_at(state: State, number: int, name: str, wall: Wall) -> bool:
    """Whether a sphere's latest event is that it came to this wall."""
    left = state.latest(name, number - 1)
    return (
        left is not None
        and isinstance(left.step, Arrival)
        and isinstance(left.step.target, Name)
        and left.step.target.name == wall.name
    )


def _side_of_wall(
    state: State, number: int, name: str, wall: Wall, gap: Scalar, speed: Scalar
) -> Scalar:
    """The side from which a sphere strikes a wall; where it is open, an unknown that is 1 or −1."""
    known = sides_of_wall(state, gap, speed)
    key, reason = f"s_{number}", f"{name} moves away from {wall.name}"
    if len(known) == 1:
        chosen = None if state.field.exact else getattr(state.unknowns, "values", {}).get(f"_{key}")
        if chosen is not None:
            state.conditions.append(Condition(chosen * known[0][0], ">", reason, "time"))
        return known[0][0]
    side = state.unknowns.hidden(key, f"the side of {wall.name} on which {name} is", "real")
    state.equations.append(Equation(side * side - 1, reason))
    state.conditions.append(Condition(-side * speed, ">", reason, "time"))
    return side


def _time_to_circle(
    state: State,
    number: int,
    name: str,
    wall: Wall,
    known: tuple[Vector, Scalar] | None,
    velocity: Vector,
    radius: Scalar | None,
) -> Scalar | None:
    circle = state.circle(wall.name)
    centre, size = circle.centre, circle.radius
    if known is None:
        return None
    out = known[0] - centre
    square = state.rational(out.dot(out))
    inside = _side_of_circle(state, square - size * size, name, wall)
    reach = size
    if radius is not None:
        reach = size + radius if inside == 1 else size - radius
        if inside != 1:
            state.conditions.append(
                Condition(reach, ">", f"{name} is too large to move inside {wall.name}", "place")
            )
    excess = state.rational(square - reach * reach)
    if radius is not None and not state.field.is_zero(excess):
        apart = excess if inside == 1 else -excess
        reason = f"{name} overlaps {wall.name} at the start"
        state.conditions.append(Condition(apart, ">=", reason, "place"))
    vv, ov = velocity.dot(velocity), out.dot(velocity)
    if state.still(velocity):
        raise ImpossibleError(f"{name} is at rest and does not reach {wall.name}")
    left = state.latest(name, number - 1)
    where: Vector | None = None
    if state.field.is_zero(excess) or (left is not None and wall.name in left.bodies):
        flight = -2 * ov / vv
    elif contacts.is_sought(state, number, vv, ov, excess):
        contact = contacts.with_circle(
            state, number, name, wall.name, out, reach, inside != 1, velocity
        )
        flight, where = contact.flight, centre + contact.centres
        if contact.velocity is not None:
            state.arriving[number, name] = velocity = contact.velocity
    else:
        under = state.rational(ov * ov - vv * excess)
        state.conditions.append(Condition(under, ">", f"{name} passes by {wall.name}", "place"))
        depth = state.real_root(under, f"{name} passes by {wall.name}")
        flight = (-ov - depth) / vv if inside == 1 else (-ov + depth) / vv
    flight = state.rational(flight)
    _flight(state, name, flight, number, f"{name} moves away from {wall.name}")
    if where is None:
        where = known[0] + velocity * flight
    if state.field.exact:
        where = state.neat(where)
    nothing_first(state, name, wall, known[0], velocity, flight, number)
    time = known[1] + flight
    state.tracks[name].places.append((number, where, time))
    return time


def _side_of_circle(state: State, excess: Scalar, name: str, wall: Wall) -> int | None:
    """The sign of the square of a distance from the centre less that of the radius.

    Where letters leave both sides open, a sphere is inside, as a condition.
    """
    unknowns = state.unknowns
    if not isinstance(unknowns, Letters):
        return state.sign(excess)
    given = [*state.conditions, *_facts_of_letters(state)]
    side = unknowns.proved_sign(sp.sympify(excess, strict=True), given)
    if side is None:
        reason = f"{name} is outside {wall.name}"
        state.conditions.append(Condition(-excess, ">=", reason, "place"))
    return side


def _facts_of_letters(state: State) -> Iterator[Condition]:
    """The inequalities between letters alone that hold in the whole statement."""
    parts = state.problem.parts
    for part in parts:
        for step in part.steps if part.label is None or len(parts) == 1 else ():
            for relation in step.relations if isinstance(step, Given) else ():
                if not isinstance(relation, Compare) or any(map(has_quantity, relation.operands)):
                    continue
                values = [state.read(operand, "a fact") for operand in relation.operands]
                for (a, b), sign in zip(pairwise(values), relation.operators, strict=True):
                    if sign in ("<", "<="):
                        yield Condition(b - a, ">" if sign == "<" else ">=", "", "fact")
                    elif sign in (">", ">="):
                        yield Condition(a - b, sign, "", "fact")


def meeting_time(state: State, number: int) -> Scalar | None:
    """The time of an event of bodies whose places are known; None where they are not."""
    for track in state.tracks.values():
        if track.places and track.places[-1][0] == number:
            return track.places[-1][2]
    return None


_TIME = sp.Symbol("t")


def _apart(state: State, start: Scalar, gap: Vector, approach: Vector) -> str:
    """When two spheres have equal coordinates, where that is never at once; empty with letters."""
    numbers = [sp.sympify(value, strict=True) for value in (start, *gap, *approach)]
    if not state.field.exact or any(number.free_symbols for number in numbers):
        return ""
    when: list[str] = []
    for name, distance, speed in zip("xy", gap, approach, strict=True):
        if speed == 0:
            never = distance != 0
            return f": their {name}-coordinates are never equal" if never else ""
        time = tidy(sp.sympify(start + distance / speed, strict=True))
        apart = sp.expand(distance - speed * (_TIME - start))
        if sp.sign(apart.subs(_TIME, 0) or apart.coeff(_TIME)) < 0:
            apart = -apart
        gap_then, instant = (to_text(from_sympy(value)) for value in (apart, time))
        when.append(
            f"their {name}-coordinates differ by {gap_then}, which is 0 only at t = {instant}"
        )
    return f": at time t {when[0]}, and {when[1]}"


def meeting(
    state: State, number: int, step: Impact, approach: Vector
) -> tuple[Scalar | None, Vector | None]:
    """When two spheres with known places meet, and the line of centres if they have size."""
    one, other = (state.place(name, number - 1) for name in (step.first, step.second))
    if state.implied:
        _lose(state, number, step.first, step.second)
        return None, None
    if one is None or other is None:
        return _meeting_half_known(state, number, step, one, other), None
    v1, v2 = (state.velocity(name, number - 1) for name in (step.first, step.second))
    start = later(state, one[1], other[1])
    p1, p2 = one[0] + v1 * (start - one[1]), other[0] + v2 * (start - other[1])
    gap = p2 - p1
    if state.field.exact:
        gap = state.neat(gap)
    r = state.radius(step.first)
    at_contact: tuple[Vector, Vector] | None = None  # where that is not worked out by the path
    if state.still(approach):
        raise ImpossibleError(
            f"{step.first} and {step.second} are at rest relative to each other: they keep their "
            "distance, and do not collide",
            *line_and_column(step.place),
        )
    c = None
    if r is None:
        missed = f"{step.first} and {step.second} do not meet{_apart(state, start, gap, approach)}"
        flight = _flight_over(state, gap, approach, missed, step)
    elif step.along is not None:
        along = state.direction(step.along, number - 1)
        length = state.size(along)
        sign = _side(state, number, step, approach.dot(along))
        reach = along * (sign * 2 * r / length)
        missed = f"{step.first} and {step.second} do not meet on that line of centres"
        flight = _flight_over(state, gap - reach, approach, missed, step)
    elif (
        step.offset is None
        and state.still(v2)
        and contacts.is_sought(state, number, *approach, *one[0])
    ):
        start, p2 = one[1], other[0]
        contact = contacts.with_sphere(state, number, step, one[0], v1, p2)
        flight, c = contact.flight, contact.centres
        if contact.velocity is not None:
            state.arriving[number, step.first] = v1 = contact.velocity
        at_contact = p2 - c, p2
    else:
        flight, c = _first_contact(state, gap, approach, r, step)
    flight = state.rational(flight)
    _require_flight(state, flight, step)
    time = start + flight
    for name, known, v in ((step.first, one, v1), (step.second, other, v2)):
        where = known[0] + v * (time - known[1])
        if at_contact is not None:
            where = at_contact[name == step.second]
        partners = (step.first, step.second)
        nothing_first(state, name, None, known[0], v, time - known[1], number, partners)
        state.tracks[name].places.append((number, state.neat(where), time))
    return time, c


def _flight_over(
    state: State, displacement: Vector, approach: Vector, missed: str, step: Impact
) -> Scalar:
    """The time in which spheres come closer by a displacement, which is along their approach."""
    # Only the part along the approach is ever covered: what is left beside it is a miss.
    flight = displacement.dot(approach) / approach.dot(approach)
    _off(state, state.rational(displacement.cross(approach)), missed, step.place)
    return flight


def _first_contact(
    state: State, gap: Vector, approach: Vector, r: Scalar, step: Impact
) -> tuple[Scalar, Vector]:
    """When two spheres are first two radii apart, and their line of centres then."""
    passed = f"{step.first} passes {step.second} without touching it"
    # |gap − approach t| = 2r is a quadratic in t: at its later root they would part.
    ga, ww = gap.dot(approach), approach.dot(approach)
    under = ga * ga - ww * (gap.dot(gap) - 4 * r * r)
    if state.field.exact:
        under = neat(under)
    state.conditions.append(Condition(under, ">", passed, "place"))
    flight = (ga - state.real_root(under, passed)) / ww
    return flight, state.neat(gap - approach * flight)


def _require_flight(state: State, flight: Scalar, step: Impact) -> None:
    """Spheres that separate do not meet; in contact, or at one place, they collide there.

    Those that have met may still be in contact, as e was 0, when one of them is struck.
    """
    separating = f"{step.first} and {step.second} are separating"
    if state.field.exact and flight.is_negative:
        raise ImpossibleError(separating)
    met = (step.first, step.second) in state.contact_lines
    together = met or state.field.is_zero(flight)
    state.conditions.append(Condition(flight, ">=" if together else ">", separating, "time"))


def _side(state: State, number: int, step: Impact, towards: Scalar) -> Scalar:
    """On which side of the first sphere the second is, along the given line: 1 or −1.

    It is the sign of ``towards``; where that depends on the letters, an unknown whose square is 1.
    Which of its values goes with which letters is decided in numbers.
    """
    reason = f"{step.first} and {step.second} are separating"
    sign = state.sign(towards)
    key = f"s_{number}"
    if state.field.exact and sign is None:
        side = state.unknowns.hidden(key, f"the order of {step.first} and {step.second}", "real")
        state.equations.append(Equation(side * side - 1, reason))
        return side
    chosen = getattr(state.unknowns, "values", {}).get(f"_{key}")
    if chosen is not None and not state.field.exact:
        state.needs_numbers = True
        state.conditions.append(Condition(chosen * towards, ">", reason, "time"))
    return sign or 1


def _meeting_half_known(
    state: State,
    number: int,
    step: Impact,
    one: tuple[Vector, Scalar] | None,
    other: tuple[Vector, Scalar] | None,
) -> Scalar | None:
    if one is None and other is None:
        placed = any(track.places for track in state.tracks.values())
        fixed = any(wall.shape.is_placed for wall in state.problem.walls)
        if number == 1 and not placed and not fixed:
            state.implied = True
            return state.field.zero
        return None
    known = one if one is not None else other
    assert known is not None
    time = state.unknowns.hidden(f"t_{number}", f"the time of event {number}", "positive")
    return time


def place_after_meeting(
    state: State,
    number: int,
    step: Impact,
    c: Vector,
    closing: Scalar,
    unknown: bool,
    time: Scalar | None,
) -> None:
    """Where the other centre is, when one is known."""
    tracks = state.tracks[step.first], state.tracks[step.second]
    if time is None or any(t.places and t.places[-1][0] == number for t in tracks):
        return
    r = state.radius(step.first)
    if r is None:
        apart = Vector(state.field.zero, state.field.zero)
    else:
        oriented = c if unknown else c * closing
        sign = state.sign(closing) if not unknown else 1
        if sign in (1, -1) and not unknown:
            oriented = c * sign
        apart = oriented * (2 * r / state.size(oriented))
        if state.field.exact:
            apart = state.neat(apart)
    one, other = (state.place(name, number - 1) for name in (step.first, step.second))
    if one is not None:
        v = state.velocity(step.first, number - 1)
        where = one[0] + v * (time - one[1])
    elif other is not None:
        v = state.velocity(step.second, number - 1)
        where = other[0] + v * (time - other[1]) - apart
    else:
        where = Vector(state.field.zero, state.field.zero)
    tracks[0].places.append((number, where, time))
    tracks[1].places.append((number, where + apart, time))
