"""The quantities of a story: what ``speed(P, 2)``, ``deflection(A)`` or ``impulse`` is worth."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from restitution import law
from restitution.errors import ImpossibleError, StatementError, UnsupportedError
from restitution.expression.evaluate import Angle, Scalar, Value
from restitution.expression.quantities import KINDS
from restitution.expression.tree import AtTime, Expression, Name, Quantity, letters, line_and_column
from restitution.problem import Arrival, Impact
from restitution.shapes import Circle
from restitution.solving.story.happenings import Happening
from restitution.solving.story.state import State
from restitution.vector import Vector

_RULE = "a body at rest has no direction of motion"
_TIMES = ("before", "after")


def stage_number(state: State, tree: Quantity, now: int, name: str | None) -> int:
    """After how many events a quantity is meant, ``now`` events being told where it stands."""
    stage = tree.stage
    if stage is None:
        return now
    if isinstance(stage, int):
        if stage > len(state.happenings):
            raise _error(
                tree,
                f"event {stage} is asked for, and {len(state.happenings)} "
                f"{'is' if len(state.happenings) == 1 else 'are'} told",
            )
        return stage
    if stage == "before":
        latest = state.latest(name, now) if name is not None else None
        if latest is None:
            raise _error(tree, f"no event of {name} is told yet")
        return latest.number - 1
    raise _error(tree, "a time has no meaning here")


def event_of(state: State, tree: Quantity, now: int, name: str | None = None) -> Happening:
    """The event that a quantity speaks of: the latest, that of a body, or by number."""
    if isinstance(tree.stage, int):
        if not 1 <= tree.stage <= len(state.happenings):
            raise _error(
                tree,
                f"event {tree.stage} is asked for, and {len(state.happenings)} "
                f"{'is' if len(state.happenings) == 1 else 'are'} told",
            )
        happening = state.happenings[tree.stage - 1]
        if name is not None and name not in happening.bodies:
            raise _error(tree, f"{name} has no part in event {tree.stage}")
        return happening
    if name is not None:
        latest = state.latest(name, now)
    else:
        latest = state.happenings[now - 1] if now else None
    if latest is None:
        about = "no event" if name is None else f"no event of {name}"
        raise _error(tree, f"{about} is told before this line")
    return latest


def quantity(state: State, tree: Quantity, now: int) -> Value:
    """The value of a quantity asked for after ``now`` events."""
    kind, arguments = tree.kind, tree.arguments
    defined = KINDS[kind].written_out(arguments, tree.stage, now) if kind in KINDS else None
    if defined is not None:
        return state.evaluator(now).value(defined)
    body = arguments[0].name if arguments and isinstance(arguments[0], Name) else None
    match kind:
        case "velocity":
            return state.velocity(_sphere(state, tree, body), stage_number(state, tree, now, body))
        case "speed":
            v = state.velocity(_sphere(state, tree, body), stage_number(state, tree, now, body))
            return state.size(v)
        case "direction":
            if body in state.walls:
                assert isinstance(arguments[0], Name)
                return state.wall_direction(arguments[0])
            v = state.velocity(_sphere(state, tree, body), stage_number(state, tree, now, body))
            return Angle(v.x, v.y, lambda: state.field.arctan2(v.y, v.x))
        case "along" | "across":
            v = state.evaluator(now).vector(arguments[0])
            d = state.direction(arguments[1], now)
            if kind == "across":
                d = d.turned_left()
            length = state.size(d)
            if state.field.is_zero(length):
                raise _error(tree, "the zero vector has no direction")
            return v.dot(d) / length
        case "angle":
            return _angle(state, arguments[0], arguments[1], now)
        case "deflection":
            name = _sphere(state, tree, body)
            event = event_of(state, tree, now, name)
            reasons = [f"{name} is at rest {when} the impact, and {_RULE}" for when in _TIMES]
            return angle_between(state, event.before[name], event.after[name], reasons)
        case "impulse":
            if body is not None:
                return impulse_on(
                    state, _sphere(state, tree, body), event_of(state, tree, now, body)
                )
            return _impulse_size(state, event_of(state, tree, now))
        case "energy":
            names = [_sphere(state, tree, body)] if arguments else list(state.spheres)
            stage = stage_number(state, tree, now, body)
            return _add(state, (_energy(state, name, stage) for name in names))
        case "energy_lost":
            return energy_lost(state, event_of(state, tree, now))
        case "total_energy_lost":
            upto = stage_number(state, tree, now, None)
            return _add(
                state, (energy_lost(state, happening) for happening in state.happenings[:upto])
            )
        case "momentum":
            names = [_sphere(state, tree, body)] if arguments else list(state.spheres)
            stage = stage_number(state, tree, now, body)
            total = Vector(state.field.zero, state.field.zero)
            for name in names:
                total = total + state.velocity(name, stage) * state.mass(name)
            return total
        case "line_of_centres":
            event = event_of(state, tree, now)
            if event.centres is None:
                raise _error(tree, _without_a_line(state, event))
            along = event.oriented()
            return along / state.size(along)
        case "mass":
            return state.mass(_sphere(state, tree, body))
        case "time":
            return _time(state, tree)
        case "position":
            name = _sphere(state, tree, body)
            return _position_at(state, name, tree, now)
        case "distance":
            one, other = (point_of(state, argument, tree, now) for argument in arguments)
            return state.size(one - other)
        case "dot":
            a, b = (state.evaluator(now).vector(argument) for argument in arguments)
            return a.dot(b)
    raise UnsupportedError(f"the quantity {kind} is not known here", *line_and_column(tree.place))


def _without_a_line(state: State, event: Happening) -> str:
    """That an event has no line of centres, and how that of the last impact before it is named."""
    earlier = [
        happening
        for happening in state.happenings[: event.number - 1]
        if happening.centres is not None
    ]
    if not earlier:
        return "this event has no line of centres"
    return (
        f"event {event.number} has no line of centres; that of the impact before it is "
        f"line_of_centres({earlier[-1].number})"
    )


def angle_between(
    state: State, a: Vector, b: Vector, reasons: Sequence[str] = (_RULE, _RULE)
) -> Angle:
    """The angle between two vectors, 0 to 180°.

    Raises ImpossibleError where one of them is zero, with the reason that belongs to it.
    """
    for vector, reason in zip((a, b), reasons, strict=True):
        if state.field.is_zero(vector.x) and state.field.is_zero(vector.y):
            raise ImpossibleError(reason)
    x, y = a.dot(b), state.field.abs(a.cross(b))
    return Angle(x, y, lambda: state.field.arctan2(y, x))


def reason_of_rest(tree: Expression) -> str:
    """Why a body at rest has no direction; the body is the one whose velocity the tree names."""
    match tree:
        case Quantity("velocity" | "momentum", (Name(body),)):
            return f"{body} is at rest, and {_RULE}"
    return _RULE


def reason_without_direction(tree: Expression, relation: str) -> str:
    """Why a fact of directions does not hold of a zero vector, which the tree is."""
    match tree:
        case Quantity("velocity" | "momentum", (Name(body),)):
            return f"{body} would be at rest, and nothing is {relation} a body at rest"
    return f"nothing is {relation} the zero vector"


def _angle(state: State, left: Expression, right: Expression, now: int) -> Angle:
    a, b = (
        _tangent_at_its_hit(state, one, other) or state.direction(one, now)
        for one, other in ((left, right), (right, left))
    )
    angle = angle_between(state, a, b, [reason_of_rest(left), reason_of_rest(right)])
    if not (is_line(state, left) or is_line(state, right)):
        return angle
    x = state.field.abs(angle.x)
    return Angle(x, angle.y, lambda: state.field.arctan2(angle.y, x))


def _tangent_at_its_hit(state: State, wall: Expression, velocity: Expression) -> Vector | None:
    """The tangent of a circular wall where a body gets the velocity of which an angle speaks.

    Of the velocity at the start it is where the body first hits that wall. None of anything else:
    then it is where the wall was struck last.
    """
    match wall, velocity:
        case Name(name), Quantity("velocity", (Name(body),), int(stage)) if name in state.walls:
            if not isinstance(state.walls[name].shape, Circle):
                return None
            hits = [
                happening for happening in state.happenings if {name, body} <= set(happening.bodies)
            ]
            before = [happening for happening in hits if happening.number <= stage]
            hit = before[-1] if before else next(iter(hits), None)
            return None if hit is None or hit.centres is None else hit.centres.turned_left()
    return None


def is_line(state: State, tree: Expression) -> bool:
    """Walls and lines of centres are lines: the angle to one is at most 90°."""
    if isinstance(tree, Name):
        return tree.name in state.walls
    return isinstance(tree, Quantity) and (
        tree.kind == "line_of_centres"
        or (
            tree.kind == "direction"
            and isinstance(tree.arguments[0], Name)
            and tree.arguments[0].name in state.walls
        )
    )


def impulse_on(state: State, name: str, event: Happening) -> Vector:
    """The impulse on a body in an event: a vector, in N s."""
    if isinstance(event.step, Arrival):
        return Vector(state.field.zero, state.field.zero)
    if event.altered and name in state.spheres:
        change: Vector = (event.after[name] - event.before[name]) * state.mass(name)
        return change
    assert event.impulse is not None
    total = event.impulse
    if event.impulse_mass is not None:
        total = total * state.mass(event.impulse_mass)
    if isinstance(event.step, Impact) and name == event.step.first:
        return -total
    return total


def _impulse_size(state: State, event: Happening) -> Scalar:
    vector = impulse_on(state, event.bodies[-1], event)
    if event.centres is None or event.unknown_line:
        return state.size(vector)
    return state.field.abs(vector.dot(event.centres)) / state.size(event.centres)


def _energy(state: State, name: str, stage: int) -> Scalar:
    v = state.velocity(name, stage)
    return state.mass(name) * (v.x * v.x + v.y * v.y) / 2


def energy_lost(state: State, event: Happening) -> Scalar:
    """Kinetic energy of all spheres lost in an event, in J."""
    step = event.step
    by_law = not event.unknown_line and not event.altered
    if isinstance(step, Impact) and event.centres is not None and by_law:
        u1 = event.before[step.first]
        m1 = state.mass(step.first)
        if step.second in state.walls:
            zero = Vector(state.field.zero, state.field.zero)
            return m1 * state.rational(
                law.kinetic_energy_lost(u1, zero, 1, 0, event.centres, event.e)
            )
        m2, u2 = state.mass(step.second), event.before[step.second]
        return m1 * m2 * law.kinetic_energy_lost(u1, u2, m2, m1, event.centres, event.e)
    total = state.field.zero
    for name in event.bodies:
        if name in state.spheres:
            u, v = event.before[name], event.after[name]
            total = total + state.mass(name) * (u.dot(u) - v.dot(v)) / 2
    return total


def _add(state: State, values: Iterable[Scalar]) -> Scalar:
    total = state.field.zero
    for value in values:
        total = total + value
    return total


def _time(state: State, tree: Quantity) -> Scalar:
    if not isinstance(tree.stage, int):
        raise _error(tree, "time needs the number of an event")
    if tree.stage == 0:
        return state.field.zero
    event = event_of(state, tree, len(state.happenings))
    if event.time is None:
        return state.unknowns.hidden(
            f"t_{event.number}", f"the distance between {' and '.join(event.bodies)}", "positive"
        )
    return event.time


def _position_at(state: State, name: str, tree: Quantity, now: int) -> Vector:
    stage = tree.stage
    if isinstance(stage, AtTime):
        # Of a time about which nothing is known but its letter, "now" is all that can be said.
        later = bool(letters(stage.time) & state.open_times)
        return _position_when(state, name, state.evaluator(now).scalar(stage.time), now, later)
    n = stage_number(state, tree, now, name)
    known = state.place(name, n)
    if known is None:
        return _missing_place(state, name)
    event = state.happenings[n - 1] if n else None
    if event is None or name in event.bodies:
        return known[0]
    if event.time is None:
        return _missing_place(state, name)
    where, when = known
    moved: Vector = where + state.velocity(name, n) * (event.time - when)
    return moved


def _position_when(state: State, name: str, t: Scalar, now: int, later: bool) -> Vector:
    """The place at a time: on the piece of the path that the time belongs to.

    ``later`` tells that this is the piece after all events told so far.
    """
    places = [place for place in state.tracks[name].places if place[0] <= now]
    if not places or any(where is None for _, where, _ in places):
        return _missing_place(state, name)
    chosen = places[-1] if later else places[0]
    for place in () if later else places[1:]:
        if _is_reached(state, name, place, t):
            chosen = place
    n, where, when = chosen
    moved: Vector = where + state.velocity(name, n) * (t - when)
    return moved


def _is_reached(state: State, name: str, place: tuple[int, Vector, Scalar], t: Scalar) -> bool:
    """Whether the event at a place of a path comes at a time or before it.

    Where its own time is not known, the place after it is what says so.
    Raises UnsupportedError where letters decide.
    """
    number, _, when = place
    sign = state.sign(t - when)
    if sign is not None:
        return sign >= 0
    if any(symbol.name.startswith("_") for symbol in when.free_symbols):
        return True
    raise UnsupportedError(
        f"the letters decide whether {name} has its event {number} before then: "
        f"'given time({number}) < …', or '>', says which"
    )


def _missing_place(state: State, name: str) -> Vector:
    phrase = f"the position of {name} at any time"
    return Vector(
        state.unknowns.hidden(f"p_{name}x", phrase, "real"),
        state.unknowns.hidden(f"p_{name}y", phrase, "real"),
    )


def point_of(state: State, argument: Expression, tree: Quantity, now: int) -> Vector:
    """A point, or the centre of a sphere at the stage of the quantity."""
    if isinstance(argument, Name) and argument.name in state.spheres:
        return _position_at(
            state,
            argument.name,
            Quantity("position", (argument,), tree.stage, place=tree.place),
            now,
        )
    return state.evaluator(now).vector(argument)


def _sphere(state: State, tree: Quantity, name: str | None) -> str:
    if name is None or name not in state.spheres:
        raise _error(tree, f"{tree.kind}(…) needs the name of a sphere")
    return name


def _error(tree: Quantity, message: str) -> StatementError:
    return StatementError(message, *line_and_column(tree.place))
