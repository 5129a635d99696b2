"""The quantities of a story: what ``speed(P, 2)``, ``deflection(A)`` or ``impulse`` is worth."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from restitution import law
from restitution.errors import ImpossibleError, StatementError, UnsupportedError
from restitution.expression.evaluate import Angle, Scalar, Value
from restitution.expression.tree import AtTime, Expression, Name, Quantity, letters, line_and_column
from restitution.problem import Arrival, Impact
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.solving.story import Happening, Story


def stage_number(story: Story, tree: Quantity, now: int, name: str | None) -> int:
    """After how many events a quantity is meant, ``now`` events being told where it stands."""
    stage = tree.stage
    if stage is None:
        return now
    if isinstance(stage, int):
        if stage > len(story.happenings):
            raise _error(
                tree,
                f"event {stage} is asked for, and {len(story.happenings)} "
                f"{'is' if len(story.happenings) == 1 else 'are'} told",
            )
        return stage
    if stage == "before":
        latest = story.latest(name, now) if name is not None else None
        if latest is None:
            raise _error(tree, f"no event of {name} is told yet")
        return latest.number - 1
    raise _error(tree, "a time has no meaning here")


def event_of(story: Story, tree: Quantity, now: int, name: str | None = None) -> Happening:
    """The event that a quantity speaks of: the latest, that of a body, or by number."""
    if isinstance(tree.stage, int):
        if not 1 <= tree.stage <= len(story.happenings):
            raise _error(
                tree,
                f"event {tree.stage} is asked for, and {len(story.happenings)} "
                f"{'is' if len(story.happenings) == 1 else 'are'} told",
            )
        happening = story.happenings[tree.stage - 1]
        if name is not None and name not in happening.bodies:
            raise _error(tree, f"{name} has no part in event {tree.stage}")
        return happening
    if name is not None:
        latest = story.latest(name, now)
    else:
        latest = story.happenings[now - 1] if now else None
    if latest is None:
        about = "no event" if name is None else f"no event of {name}"
        raise _error(tree, f"{about} is told before this line")
    return latest


def quantity(story: Story, tree: Quantity, now: int) -> Value:
    """The value of a quantity asked for after ``now`` events."""
    kind, arguments = tree.kind, tree.arguments
    evaluator = story.evaluator(now)
    body = arguments[0].name if arguments and isinstance(arguments[0], Name) else None
    match kind:
        case "velocity":
            return story.velocity(_sphere(story, tree, body), stage_number(story, tree, now, body))
        case "speed":
            v = story.velocity(_sphere(story, tree, body), stage_number(story, tree, now, body))
            return story.size(v)
        case "direction":
            if body in story.walls:
                assert isinstance(arguments[0], Name)
                return story.wall_direction(arguments[0])
            v = story.velocity(_sphere(story, tree, body), stage_number(story, tree, now, body))
            return Angle(v.x, v.y, lambda: story.field.arctan2(v.y, v.x))
        case "along" | "across":
            v = evaluator.vector(arguments[0])
            d = story.direction(arguments[1], now)
            if kind == "across":
                d = d.turned_left()
            length = story.size(d)
            if story.field.is_zero(length):
                raise _error(tree, "the zero vector has no direction")
            return v.dot(d) / length
        case "angle":
            return _angle(story, arguments[0], arguments[1], now)
        case "deflection":
            name = _sphere(story, tree, body)
            event = event_of(story, tree, now, name)
            return angle_between(story, event.before[name], event.after[name])
        case "impulse":
            if body is not None:
                return impulse_on(
                    story, _sphere(story, tree, body), event_of(story, tree, now, body)
                )
            return _impulse_size(story, event_of(story, tree, now))
        case "energy":
            names = [_sphere(story, tree, body)] if arguments else list(story.spheres)
            stage = stage_number(story, tree, now, body)
            return _add(story, (_energy(story, name, stage) for name in names))
        case "energy_lost":
            return energy_lost(story, event_of(story, tree, now))
        case "total_energy_lost":
            upto = stage_number(story, tree, now, None)
            return _add(
                story, (energy_lost(story, happening) for happening in story.happenings[:upto])
            )
        case "momentum":
            names = [_sphere(story, tree, body)] if arguments else list(story.spheres)
            stage = stage_number(story, tree, now, body)
            total = Vector(story.field.zero, story.field.zero)
            for name in names:
                total = total + story.velocity(name, stage) * story.mass(name)
            return total
        case "line_of_centres":
            event = event_of(story, tree, now)
            if event.centres is None:
                raise _error(tree, "this event has no line of centres")
            along = event.oriented()
            return along / story.size(along)
        case "mass":
            return story.mass(_sphere(story, tree, body))
        case "time":
            return _time(story, tree)
        case "position":
            name = _sphere(story, tree, body)
            return _position_at(story, name, tree, now)
        case "distance":
            one, other = (point_of(story, argument, tree, now) for argument in arguments)
            return story.size(one - other)
        case "dot":
            return evaluator.vector(arguments[0]).dot(evaluator.vector(arguments[1]))
    raise UnsupportedError(f"the quantity {kind} is not known here", *line_and_column(tree.place))


def angle_between(story: Story, a: Vector, b: Vector) -> Angle:
    """The angle between two vectors, 0 to 180°."""
    for each in (a, b):
        if story.field.is_zero(each.x) and story.field.is_zero(each.y):
            raise ImpossibleError("a body at rest has no direction of motion")
    x, y = a.dot(b), story.field.abs(a.cross(b))
    return Angle(x, y, lambda: story.field.arctan2(y, x))


def _angle(story: Story, left: Expression, right: Expression, now: int) -> Angle:
    a, b = story.direction(left, now), story.direction(right, now)
    angle = angle_between(story, a, b)
    if not (is_line(story, left) or is_line(story, right)):
        return angle
    x = story.field.abs(angle.x)
    return Angle(x, angle.y, lambda: story.field.arctan2(angle.y, x))


def is_line(story: Story, tree: Expression) -> bool:
    """Walls and lines of centres are lines: the angle to one is at most 90°."""
    if isinstance(tree, Name):
        return tree.name in story.walls
    return isinstance(tree, Quantity) and (
        tree.kind == "line_of_centres"
        or (
            tree.kind == "direction"
            and isinstance(tree.arguments[0], Name)
            and tree.arguments[0].name in story.walls
        )
    )


def impulse_on(story: Story, name: str, event: Happening) -> Vector:
    """The impulse on a body in an event: a vector, in N s."""
    if isinstance(event.step, Arrival):
        return Vector(story.field.zero, story.field.zero)
    if event.altered and name in story.spheres:
        change: Vector = (event.after[name] - event.before[name]) * story.mass(name)
        return change
    assert event.impulse is not None
    total = event.impulse
    if event.impulse_mass is not None:
        total = total * story.mass(event.impulse_mass)
    if isinstance(event.step, Impact) and name == event.step.first:
        return -total
    return total


def _impulse_size(story: Story, event: Happening) -> Scalar:
    vector = impulse_on(story, event.bodies[-1], event)
    if event.centres is None or event.unknown_line:
        return story.size(vector)
    return story.field.abs(vector.dot(event.centres)) / story.size(event.centres)


def _energy(story: Story, name: str, stage: int) -> Scalar:
    v = story.velocity(name, stage)
    return story.mass(name) * (v.x * v.x + v.y * v.y) / 2


def energy_lost(story: Story, event: Happening) -> Scalar:
    """Kinetic energy of all spheres lost in an event, in J."""
    step = event.step
    by_law = not event.unknown_line and not event.altered
    if isinstance(step, Impact) and event.centres is not None and by_law:
        u1 = event.before[step.first]
        m1 = story.mass(step.first)
        if step.second in story.walls:
            zero = Vector(story.field.zero, story.field.zero)
            return m1 * story.rational(
                law.kinetic_energy_lost(u1, zero, 1, 0, event.centres, event.e)
            )
        m2, u2 = story.mass(step.second), event.before[step.second]
        return m1 * m2 * law.kinetic_energy_lost(u1, u2, m2, m1, event.centres, event.e)
    total = story.field.zero
    for name in event.bodies:
        if name in story.spheres:
            u, v = event.before[name], event.after[name]
            total = total + story.mass(name) * (u.dot(u) - v.dot(v)) / 2
    return total


def _add(story: Story, values: Iterable[Scalar]) -> Scalar:
    total = story.field.zero
    for value in values:
        total = total + value
    return total


def _time(story: Story, tree: Quantity) -> Scalar:
    if not isinstance(tree.stage, int):
        raise _error(tree, "time needs the number of an event")
    if tree.stage == 0:
        return story.field.zero
    event = event_of(story, tree, len(story.happenings))
    if event.time is None:
        return story.unknowns.hidden(
            f"t_{event.number}", f"where the bodies of event {event.number} are", "positive"
        )
    return event.time


def _position_at(story: Story, name: str, tree: Quantity, now: int) -> Vector:
    stage = tree.stage
    if isinstance(stage, AtTime):
        # Of a time about which nothing is known but its letter, "now" is all that can be said.
        later = bool(letters(stage.time) & story.open_times)
        return _position_when(story, name, story.evaluator(now).scalar(stage.time), now, later)
    n = stage_number(story, tree, now, name)
    known = story.place(name, n)
    if known is None:
        return _missing_place(story, name)
    event = story.happenings[n - 1] if n else None
    if event is None or name in event.bodies:
        return known[0]
    if event.time is None:
        return _missing_place(story, name)
    where, when = known
    moved: Vector = where + story.velocity(name, n) * (event.time - when)
    return moved


def _position_when(story: Story, name: str, t: Scalar, now: int, later: bool) -> Vector:
    """The place at a time: on the piece of the path that the time belongs to.

    ``later`` tells that this is the piece after all events told so far.
    """
    places = [place for place in story.tracks[name].places if place[0] <= now]
    if not places or any(where is None for _, where, _ in places):
        return _missing_place(story, name)
    chosen = places[-1] if later else places[0]
    for each in () if later else places[1:]:
        sign = story.sign(t - each[2])
        if sign is not None and sign >= 0:
            chosen = each
    n, where, when = chosen
    moved: Vector = where + story.velocity(name, n) * (t - when)
    return moved


def _missing_place(story: Story, name: str) -> Vector:
    phrase = f"where {name} is"
    return Vector(
        story.unknowns.hidden(f"p_{name}x", phrase, "real"),
        story.unknowns.hidden(f"p_{name}y", phrase, "real"),
    )


def point_of(story: Story, argument: Expression, tree: Quantity, now: int) -> Vector:
    """A point, or the centre of a sphere at the stage of the quantity."""
    if isinstance(argument, Name) and argument.name in story.spheres:
        return _position_at(
            story,
            argument.name,
            Quantity("position", (argument,), tree.stage, place=tree.place),
            now,
        )
    return story.evaluator(now).vector(argument)


def _sphere(story: Story, tree: Quantity, name: str | None) -> str:
    if name is None or name not in story.spheres:
        raise _error(tree, f"{tree.kind}(…) needs the name of a sphere")
    return name


def _error(tree: Quantity, message: str) -> StatementError:
    return StatementError(message, *line_and_column(tree.place))
