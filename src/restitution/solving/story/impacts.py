"""Impacts as a story tells them: the line of centres, the law, what it does to velocities.

What the law needs and the text leaves open becomes a hidden unknown; that the bodies approach, and
that e lies in [0, 1], become conditions.
"""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import sympy as sp

from restitution import law
from restitution.errors import ImpossibleError
from restitution.expression.evaluate import Scalar
from restitution.expression.tree import Name, line_and_column
from restitution.problem import Impact
from restitution.shapes import Circle, Line
from restitution.solving.story import bodies, contacts, missing, places
from restitution.solving.story.conditions import Condition, Equation
from restitution.solving.story.happenings import Happening
from restitution.solving.story.orders import order_kept, same_line
from restitution.solving.story.state import State
from restitution.vector import Vector


def impact(state: State, number: int, step: Impact) -> Happening:
    """An impact with a wall or of two spheres, as event ``number``."""
    if step.second in state.walls:
        return _impact_with_wall(state, number, step)
    return _impact_of_spheres(state, number, step)


def _coefficient(state: State, number: int, step: Impact) -> Scalar:
    e = state.letter("e") if step.e is None else state.evaluator(number - 1).scalar(step.e)
    reason = "a coefficient of restitution lies in [0, 1]"
    one = state.field.number(Fraction(1))
    if bodies.coefficient_outside(step):
        state.conditions.append(Condition(-one, ">=", reason, "coefficient"))
        if state.field.exact:
            state.fault = state.fault or bodies.impossible_coefficient(step)
        return e
    if state.of_statement and e.free_symbols and (e.is_negative or (e - 1).is_positive):
        raise bodies.impossible_coefficient(step)
    state.conditions.append(Condition(e, ">=", reason, "coefficient"))
    state.conditions.append(Condition(one - e, ">=", reason, "coefficient"))
    return e


def _approach(
    state: State,
    key: tuple[str, str],
    u: Vector,
    c: Vector,
    closing: Scalar,
    unknown: bool,
    what: str,
    own: Scalar = None,
) -> None:
    """The bodies must approach; if they met before on the same line, from the same side.

    ``own`` is the first body's component along c where nothing else tells which side the
    second is on: A hits B, so B lies on the side to which A moves.
    """
    earlier = state.contact_lines.get(key) or _of_who_met(state, key)
    if not unknown and earlier is None and own is not None and not state.field.is_zero(own):
        state.conditions.append(Condition(own * closing, ">", what, "approach"))
    elif unknown:
        state.conditions.append(Condition(closing, ">", what, "approach"))
    elif earlier is not None and same_line(state, earlier, c) and _held(state, key, u, c):
        state.conditions.append(Condition(u.dot(earlier), ">", what, "approach"))
    else:
        state.conditions.append(Condition(closing, "!=", what, "approach"))
    oriented = c if unknown else c * closing
    state.contact_lines[key] = oriented
    state.contact_lines[key[1], key[0]] = -oriented


def _of_who_met(state: State, key: tuple[str, str]) -> Vector | None:
    """From which side a sphere came to a straight wall with which another one has met.

    No sphere passes such a wall, so those that meet are on one side of it. None without one.
    """
    name, wall = key
    if wall not in state.walls or not isinstance(state.walls[wall].shape, Line):
        return None
    together = {name}
    for event in reversed(state.happenings):
        spheres = set(event.bodies) & set(state.spheres)
        together |= spheres if spheres & together else set()
    sides = (state.contact_lines.get((sphere, wall)) for sphere in sorted(together))
    return next((side for side in sides if side is not None), None)


def _held(state: State, key: tuple[str, str], u: Vector, c: Vector) -> bool:
    """Whether two bodies that met are still in the same order along their line.

    They are if nothing happened to either since, if one is a wall, or if they move, one
    relative to the other, along that line alone: else they may have passed each other.
    """
    if key[1] in state.walls:
        return True
    last = next(
        number
        for number, event in reversed(list(enumerate(state.happenings)))
        if set(event.bodies) == set(key)
    )
    between = state.happenings[last + 1 :]
    if not any(set(event.bodies) & set(key) for event in between):
        return True
    return same_line(state, u, c)


def _impact_with_wall(state: State, number: int, step: Impact) -> Happening:
    name, wall = step.first, state.walls[step.second]
    u = state.velocity(name, number - 1)
    if state.spheres[name].mass is not None:
        state.mass(name)  # no matter for the velocity, but it has to be positive
    e = _coefficient(state, number, step)
    time = places.time_to_wall(state, number, name, wall)
    zero = Vector(state.field.zero, state.field.zero)
    unknown = False
    shape = wall.shape
    if isinstance(shape, Circle):
        state.contact_lines.pop((name, wall.name), None)  # it may be struck on its other side
        known = state.place(name, number)
        if known is not None and state.tracks[name].places[-1][0] == number:
            c = known[0] - state.read_vector(shape.centre, "")
        else:
            phrase = f"the place where {name} strikes {wall.name}"
            c = Vector(
                state.unknowns.hidden(f"n_{number}x", phrase, "real"),
                state.unknowns.hidden(f"n_{number}y", phrase, "real"),
            )
            state.equations.append(Equation(c.dot(c) - 1, phrase, kind="direction"))
    elif isinstance(shape, Line) and shape.along is None and wall.name in state.normals:
        c = state.normals[wall.name]
    elif isinstance(shape, Line) and shape.along is None and state.frame_matters():
        # The change of velocity itself is along the normal: linear in what is unknown.
        phrase = missing.direction_of(wall.name)
        c = Vector(
            state.unknowns.hidden(f"k_{number}x", phrase, "real"),
            state.unknowns.hidden(f"k_{number}y", phrase, "real"),
        )
        unknown = True
        state.normals[wall.name] = c
    else:
        c = -state.wall_direction(Name(wall.name)).turned_left()
    u = state.arriving.get((number, name), u)
    closing = state.rational(u.dot(c))
    if state.still(u):
        what = f"{name} is at rest, and does not hit {wall.name}"
    else:
        what = f"{name} is moving away from {wall.name}, or along it"
    if state.of_statement and not unknown and state.field.is_zero(closing):
        raise ImpossibleError(what, *line_and_column(step.place))
    is_open = time is None and not unknown and not isinstance(shape, Circle)
    order = list(order_kept(state, number, step, c, u)) if is_open else []
    _approach(state, (name, wall.name), u, c, closing, unknown, what)
    state.conditions += order
    altered = _altered(state, number, step, {name: u}, c, closing, e, unknown)
    if altered is not None:
        v = altered[name]
        push = state.neat(u - v)
    elif unknown:
        v, push = state.neat(u - c), c
        state.equations.append(
            Equation(c.dot(c) - (1 + e) * closing, "Newton's experimental law", kind="law")
        )
    elif state.in_frames:
        v, push = u, None  # the frame tells what comes after
    else:
        on_wall = law.impulse(u, zero, 1, 0, c, e)
        v = state.neat(law.after_impulse(u, zero, 1, 0, on_wall)[0])
        push = state.neat(on_wall)
    return Happening(
        number,
        step,
        {name: state.velocity(name, number - 1)},
        {name: v},
        centres=c,
        closing=closing,
        e=e,
        impulse=push,
        impulse_mass=name,
        time=time,
        unknown_line=unknown,
        altered=altered is not None,
    )


def _impact_of_spheres(state: State, number: int, step: Impact) -> Happening:
    first, second = step.first, step.second
    u1, u2 = state.velocity(first, number - 1), state.velocity(second, number - 1)
    m1, m2 = state.mass(first), state.mass(second)
    e = _coefficient(state, number, step)
    approach = u1 - u2
    time, geometric = places.meeting(state, number, step, approach)
    sought = state.arriving.get((number, first))
    if sought is not None:
        approach = sought
    unknown = False
    if step.along is not None:
        c = state.direction(step.along, number - 1)
        if state.of_statement:
            line = f"the line of centres of {first} and {second}"
            bodies.require_direction(c, line, step.along, step.place)
    elif step.offset is not None:
        c = _by_offset(state, number, step, approach)
    elif geometric is not None:
        c = geometric
    else:
        c = _open_line(state, number, step, approach)
        unknown = True
    by_impulse = unknown and not is_sloped(state, number, approach)
    closing = state.rational(approach.dot(c))
    what = f"{first} and {second} are separating along the line of centres"
    if state.still(approach):
        what = f"{first} and {second} are at rest relative to each other, and do not collide"
    placed = time is not None and places.meeting_time(state, number) is not None
    own = state.rational(u1.dot(c)) if step.along is not None and not placed else None
    if state.of_statement and (own is not None or state.still(approach)):
        _require_approach(state, step, c, own, closing, what)
    is_open = step.along is not None and not placed
    order = list(order_kept(state, number, step, c, approach)) if is_open else []
    _approach(state, (first, second), approach, c, closing, unknown, what, own)
    state.conditions += order
    altered = _altered(state, number, step, {first: u1, second: u2}, c, closing, e, unknown)
    if altered is not None:
        v1, v2 = altered[first], altered[second]
        push = state.neat((v2 - u2) * m2)
    elif by_impulse:
        # The impulse itself is along the line of centres: linear in what is unknown.
        v1, v2 = state.neat(u1 - c / m1), state.neat(u2 + c / m2)
        push = c
        state.equations.append(
            Equation(
                c.dot(c) * (m1 + m2) - (1 + e) * closing * m1 * m2,
                "Newton's experimental law",
                kind="law",
            )
        )
    elif state.in_frames:
        v1, v2, push = u1, u2, None  # the frame tells what comes after
    elif sought is not None:
        v1, v2, push = contacts.velocities_after(state, number, step, sought, c, e)
    else:
        # Inverse masses matter up to a factor: m2 and m1 serve, and keep fractions out.
        on_2 = law.impulse(u1, u2, m2, m1, c, e)
        v1, v2 = (state.neat(v) for v in law.after_impulse(u1, u2, m2, m1, on_2))
        push = state.neat(on_2 * (m1 * m2))
    places.place_after_meeting(state, number, step, c, closing, unknown, time)
    return Happening(
        number,
        step,
        {first: u1, second: u2},
        {first: v1, second: v2},
        centres=c,
        closing=closing,
        e=e,
        impulse=push,
        time=time if time is not None else places.meeting_time(state, number),
        unknown_line=unknown,
        altered=altered is not None,
    )


def _open_line(state: State, number: int, step: Impact, approach: Vector) -> Vector:
    """A line of centres of which nothing is known: the impulse itself, or a direction by its slope.

    Spheres approach along their line, so every possible one is ``approach`` turned by less than a
    right angle: the slope to it may be any number.
    """
    phrase = f"the line of centres of {step.first} and {step.second}"
    if is_sloped(state, number, approach):
        slope = state.unknowns.hidden(f"{SLOPE[1:]}{number}", phrase, "real")
        return state.neat(approach + approach.turned_left() * slope)
    return Vector(
        state.unknowns.hidden(f"k_{number}x", phrase, "real"),
        state.unknowns.hidden(f"k_{number}y", phrase, "real"),
    )


SLOPE = "_slope_"
"""How the names of slopes begin: of an open line of centres to the approach."""


def is_sloped(state: State, number: int, approach: Vector) -> bool:
    """Whether an open line of centres is told by its slope to the approach."""
    after = state.sloped_after
    return (
        after is not None
        and number > after
        and state.problem.altered_at(number) is None
        and not state.still(approach)
    )


def _altered(
    state: State,
    number: int,
    step: Impact,
    before: Mapping[str, Vector],
    c: Vector,
    closing: Scalar,
    e: Scalar,
    unknown: bool,
) -> Mapping[str, Vector] | None:
    """The velocities after an impact at which other laws hold; None where the laws do."""
    altered = state.problem.altered_at(number)
    if altered is None or state.in_frames:
        return None
    if not unknown:
        sign = state.sign(closing)
        c = c * closing if sign is None else c * state.field.number(Fraction(sign or 1))
    from restitution.solving.story.alteration import AlteredLaws

    laws = AlteredLaws(state, altered, step, before, c, e)
    laws.require_senses()
    state.altered_laws[number] = laws
    if not unknown:
        return laws.velocities()
    after, equations = laws.velocities_on_unknown_line()
    state.equations += equations
    return after


def _require_approach(
    state: State, step: Impact, c: Vector, own: Scalar, closing: Scalar, what: str
) -> None:
    """Raises ImpossibleError where two spheres are proved not to approach on their line.

    Where they would if the names were exchanged, that is suggested.
    """
    first, second = step.first, step.second
    if state.field.is_zero(closing):
        if "relative" not in what:
            what = f"{first} and {second} move alike along the line of centres"
            what += ", and do not collide"
    elif (first, second) in state.contact_lines or not (own * closing).is_negative:
        return
    elif (closing * (closing - own)).is_positive:
        what += f": {second} is the faster; did you mean '{second} hits {first}'?"
    raise ImpossibleError(what, *line_and_column(step.place))


def _by_offset(state: State, number: int, step: Impact, approach: Vector) -> Vector:
    """The line of centres makes arcsin(d/2r) with the relative path."""
    assert step.offset is not None
    d = state.evaluator(number - 1).scalar(step.offset)
    r = state.radius(step.first)
    if r is None:
        r = state.unknowns.hidden("r", f"the radius of {step.first}", "positive")
    under = 4 * r * r - d * d
    if state.field.exact:
        under = sp.expand(under)
    what = f"the offset must be less than 2r, or {step.first} passes {step.second}"
    if state.field.is_zero(under):
        raise ImpossibleError(what)
    state.conditions.append(Condition(under, ">", what, "place"))
    c = approach * state.real_root(under, what) + approach.turned_left() * d
    return state.neat(c)
