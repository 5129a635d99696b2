"""Angles of velocities to walls and lines of centres.

Their tangents by components where the sense is open, and components by speeds.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from restitution.explaining.data.offset_angles import named_angles
from restitution.explaining.data.paths_and_lines import in_degrees
from restitution.explaining.definitions.senses import oriented
from restitution.explaining.lines.derivation import Event, Link
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.explaining.lines.trees import settled
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    walk,
)


def to_walls(step: Step, event: Event | None) -> Iterator[Link]:
    """The tangent of an angle to a wall: to a parallel one, or where a sense is open.

    Also to another wall that is parallel to the line of centres, or perpendicular to it; and to a
    line of centres, where the sense along that is open.
    """
    if event is None:
        return
    yield from _to_other_walls(step, event)
    if not event.wall:
        yield from _to_the_line(step, event)
        return
    own, axis = Name(event.bodies[1]), Quantity("line_of_centres", (), event.number)
    for meaning in step.lets:
        match meaning.quantity:
            case Quantity(
                "angle", (Quantity("velocity", _, int(stage)) as velocity, Name() as wall)
            ):
                pass
            case _:
                continue
        directions = [
            step.world.directions.get(Quantity("direction", (name,))) for name in (own, wall)
        ]
        if stage not in (event.number, event.number - 1) or (
            wall != own and (None in directions or directions[0] != directions[1])
        ):
            continue
        along, across = (Quantity(kind, (velocity, axis)) for kind in COMPONENTS)
        sizes: list[tuple[Expression, Expression]]
        sizes = [(own, Apply("abs", own)) for own in (along, across)]
        for above, below in product(*sizes):
            yield Link(Apply("tan", meaning.quantity), "=", Binary("/", above, below))
    for angle in _given_angles(step, event, own):
        along, across = (Quantity(kind, (angle.arguments[0], axis)) for kind in COMPONENTS)
        yield Link(Apply("tan", angle), "=", Binary("/", along, Apply("abs", across)))


def _to_the_line(step: Step, event: Event) -> Iterator[Link]:
    """The tangent of an angle to a line of centres, by the size of the component along it."""
    axis = Quantity("line_of_centres", (), event.number)
    for meaning in step.lets:
        match meaning.quantity:
            case Quantity("angle", (Quantity("velocity", _, int()) as velocity, own)) if (
                own == axis
            ):
                along, across = (Quantity(kind, (velocity, axis)) for kind in COMPONENTS)
                size = Apply("abs", along)
                yield Link(Apply("tan", meaning.quantity), "=", Binary("/", across, size))


def _given_angles(step: Step, event: Event, wall: Name) -> Iterator[Quantity]:
    """The angles to the wall of an impact, after it, that a cited fact names."""
    for link in step.links:
        for node in walk(link.left):
            match node:
                case Quantity("angle", (Quantity("velocity", _, int(stage)), Name() as other)):
                    if stage == event.number and other == wall:
                        yield node


def _to_other_walls(step: Step, event: Event) -> Iterator[Link]:
    """The tangent of an angle to a wall of another event, by the components of this one."""
    axis = Quantity("line_of_centres", (), event.number)
    if axis not in step.world.directions:
        return
    normal = step.world.pointing(axis)
    for tree in step.world.directions:
        match tree:
            case Quantity("direction", (Name() as wall,)) if wall.name not in event.bodies:
                direction = step.world.pointing(tree)
            case _:
                continue
        if not (isinstance(normal, Plane) and isinstance(direction, Plane)):
            continue
        dot = normal.x * direction.x + normal.y * direction.y
        cross = normal.x * direction.y - normal.y * direction.x
        if not (dot.vanishes or cross.vanishes) or (event.wall and dot.vanishes):
            continue  # of a wall parallel to the own one the directions alone tell
        for body in step.move.bodies:
            velocity = Quantity("velocity", (Name(body),), event.number)
            along, across = (Quantity(kind, (velocity, axis)) for kind in COMPONENTS)
            above, below = (along, across) if dot.vanishes else (across, along)
            angle = Apply("tan", Quantity("angle", (velocity, wall)))
            for size in (below, Apply("abs", below)):
                yield Link(angle, "=", Binary("/", above, size))


def to_slanted_centres(step: Step, event: Event | None) -> Iterator[Link]:
    """The tangent of the angle of a path to a line of centres, both told in degrees from **i**.

    A path at 30° makes 75° with a line at −45°, which is the tangent of its components there. A
    line of centres by an offset is told by the letter of its angle, which has a value.
    """
    if event is None or event.wall:
        return
    axis = Quantity("line_of_centres", (), event.number)
    turns = [in_degrees(e.right) for e in step.links if e.left == axis and e.sign != "!="]
    for meaning, own in named_angles(step.lets, step.links, step.setting):
        named = (e for e in step.links if e.left == Letter(meaning.letter) and e.sign == "=")
        turns += [own.turn(e.right) for e in named] if own.axis == axis else []
    for link in step.links:
        match link:
            case Link(Quantity("direction", (Name(body),), int(stage)), "=", right) if (
                stage == event.number and body in step.move.bodies
            ):
                path = in_degrees(right)
            case _:
                continue
        velocity = Quantity("velocity", (Name(body),), stage)
        along, across = (Quantity(kind, (velocity, axis)) for kind in COMPONENTS)
        for turn in turns:
            size = None if turn is None or path is None else (path - turn) % 180
            if size is None or size % 90 == 0:
                continue
            acute = size < 90
            angle = Degrees(size if acute else 180 - size)
            above = across if acute else Negate(across)
            yield Link(Apply("tan", angle), "=", Binary("/", above, along))


def by_angles(step: Step, event: Event | None) -> Iterator[Link]:
    """A component as the speed times the cosine, or the sine, of the angle to a line.

    The angle is one of at most 90°, so that this is the size of the component.
    """
    if event is None:
        return
    if event.wall and step.keeps_speeds(event):
        speeds = (Quantity("speed", (Name(event.bodies[0]),), event.number - n) for n in (0, 1))
        yield Link(next(speeds), "=", next(speeds))
    axis = Quantity("line_of_centres", (), event.number)
    lines: list[tuple[Expression, str, str]] = [(axis, "along", "across")]
    if event.wall:
        lines.append((Name(event.bodies[1]), "across", "along"))
    for body in step.move.bodies:
        for stage in (event.number, event.number - 1):
            velocity = Quantity("velocity", (Name(body),), stage)
            speed = Quantity("speed", (Name(body),), stage)
            for line, beside, away in lines:
                angle = Quantity("angle", (velocity, line))
                for ratio, kind in (("cos", beside), ("sin", away)):
                    component = Quantity(kind, (velocity, axis))
                    sign = _sign(step, component)
                    if sign is not None:
                        size = component if sign >= 0 else Negate(component)
                        yield Link(Binary("*", speed, Apply(ratio, angle)), "=", size)
            yield from _by_the_other(step, event, body, stage)


def _by_the_other(step: Step, event: Event, body: str, stage: int) -> Iterator[Link]:
    """The speed by the angle to the velocity of the other sphere, which is along the line."""
    axis = Quantity("line_of_centres", (), event.number)
    own, speed = (Quantity(kind, (Name(body),), stage) for kind in ("velocity", "speed"))
    for other in () if event.wall else event.bodies:
        velocity = Quantity("velocity", (Name(other),), stage)
        if other == body or _sign(step, Quantity("across", (velocity, axis))) != 0:
            continue
        sense = _sign(step, Quantity("along", (velocity, axis)))
        component: Expression = Quantity("along", (own, axis))
        if sense:
            size = component if sense > 0 else Negate(component)
            for pair in ((own, velocity), (velocity, own)):
                angle = Apply("cos", Quantity("angle", pair))
                yield Link(Binary("*", speed, angle), "=", size)


def _sign(step: Step, component: Quantity) -> int | None:
    """The sign of a component, with what is cited put in; None where it is open."""
    try:
        value = step.rules().put_into(step.world.value(settled(component, step.setting.events)))
    except NotComparableError:
        return None
    if isinstance(value, Plane):
        return None
    own = step.world.reduced(value)
    return 0 if own.vanishes else oriented(step, own)


__all__ = ["by_angles", "to_slanted_centres", "to_walls"]
