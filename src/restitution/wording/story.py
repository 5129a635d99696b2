"""The events of a statement as sentences."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from restitution.expression.dimensions import IMPULSE
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    is_rest,
)
from restitution.problem import Arrival, Impact, Kick, bodies_of
from restitution.render import layout as lay
from restitution.wording import values
from restitution.wording.scene import Scene, is_mirrored
from restitution.wording.setting import course, exact
from restitution.wording.structure import Emphasis, Sentence, Words
from restitution.wording.words import names, sentence, words

_E = Letter("e")


def event_sentences(scene: Scene, number: int) -> Iterator[Sentence]:
    """The sentences for one event."""
    event = scene.events[number - 1]
    then = " then" if number > 1 else ""
    match event:
        case Impact():
            yield from _impact(scene, number, event, then)
        case Kick(body, Polar() as impulse):
            size = values.value(scene.style, impulse.size, IMPULSE)
            direction = course(scene, impulse)
            yield sentence(
                Emphasis(body), then, " receives an impulse of magnitude ", size, " ", direction
            )
        case Kick(body, impulse):
            size = values.value(scene.style, impulse, IMPULSE)
            yield sentence(Emphasis(body), then, " receives an impulse of ", size)
        case Arrival(body, target):
            yield sentence(Emphasis(body), then, " reaches ", values.point(target))


def _impact(scene: Scene, number: int, event: Impact, then: str) -> Iterator[Sentence]:
    pair = frozenset(bodies_of(event))
    again = any(
        isinstance(event, Impact) and frozenset(bodies_of(event)) == pair
        for event in scene.events[: number - 1]
    )
    first, second = Emphasis(event.first), Emphasis(event.second)
    tail = " again" if again else ""
    if scene.is_wall(event.second):
        yield sentence(first, f"{then} hits ", second, tail)
    else:
        line: Words = ()
        if event.along is not None and not _common_line(scene):
            line = _line_of_centres(scene, number, event.along)
        yield sentence(first, f"{then} collides with ", second, tail, line)
        if event.along is not None and _common_line(scene) and number == _collisions(scene)[0]:
            yield sentence(
                "in each collision the line joining the centres is ",
                values.lies_along(scene.style, event.along),
            )
        if event.offset is not None:
            yield _offset(scene, event, event.offset)
    yield from _restitution(scene, number, event)


def _line_of_centres(scene: Scene, number: int, along: Expression) -> Words:
    """Along what the line of centres of a collision is: a direction, or the path of one sphere."""
    match along:
        case Quantity("velocity", (Name(body),), None | int() as stage):
            events = scene.events[(number if stage is None else stage + 1) - 1 : number]
            if not any(body in bodies_of(event) for event in events[:-1]):
                return words(
                    " when ", Emphasis(body), " is moving along the line joining their centres"
                )
    return words(" when the line joining their centres is ", values.lies_along(scene.style, along))


def _collisions(scene: Scene) -> list[int]:
    return [
        number
        for number, event in enumerate(scene.events, 1)
        if isinstance(event, Impact) and not scene.is_wall(event.second)
    ]


def _common_line(scene: Scene) -> bool:
    """Whether several collisions all have the same line of centres."""
    lines = [getattr(scene.events[number - 1], "along", None) for number in _collisions(scene)]
    return len(lines) > 1 and len(set(lines)) == 1


# --- the coefficient of restitution ---------------------------------------------------------------


def _restitution(scene: Scene, number: int, event: Impact) -> Iterator[Sentence]:
    impacts = {n: event for n, event in enumerate(scene.events, 1) if isinstance(event, Impact)}
    value = lay.from_tree(event.e or _E)
    if len(impacts) > 1 and len({impact.e or _E for impact in impacts.values()}) == 1:
        if number == min(impacts):
            noun = "collision" if len(_collisions(scene)) == len(impacts) else "impact"
            yield sentence(f"the coefficient of restitution in each {noun} is ", value)
        return
    pair = frozenset(bodies_of(event))
    before = [
        impact.e or _E
        for n, impact in impacts.items()
        if n < number and frozenset(bodies_of(impact)) == pair
    ]
    if before and before[-1] == (event.e or _E):
        return
    now = "now " if before else ""
    between = words("the coefficient of restitution between ", names(bodies_of(event)))
    yield sentence(between, f" is {now}", value)


# --- centres on parallel lines --------------------------------------------------------------------


def _offset(scene: Scene, event: Impact, offset: Expression) -> Sentence:
    """How far off centre an impact is; positive with B to the left of A's path."""
    first, second = Emphasis(event.first), Emphasis(event.second)
    size, side = offset, "left"
    if isinstance(offset, Negate):
        size, side = offset.operand, "right"
    paths = _paths(scene, event)
    if isinstance(size, Number) and size.value == 0:
        if paths == "struck at rest":
            return sentence(
                "the line along which the centre of ",
                first,
                " moves has distance ",
                lay.from_tree(size),
                " from the centre of ",
                second,
            )
        return sentence(
            "relative to ",
            second,
            ", the line along which the centre of ",
            first,
            " approaches has distance ",
            lay.from_tree(size),
            " from the centre of ",
            second,
        )
    length = values.length(scene.style, size)
    either = is_mirrored(scene)
    if paths == "struck at rest":
        return sentence(
            "the centre of ",
            second,
            " is at a distance ",
            length,
            " from " if either else f" to the {side} of ",
            "the line along which the centre of ",
            first,
            " moves",
        )
    if paths == "parallel":
        return sentence(
            "before they collide the centres of ",
            first,
            " and ",
            second,
            " move along parallel lines a distance ",
            length,
            " apart",
            *(() if either else (", that of ", second, f" on the {side} as seen by ", first)),
        )
    return sentence(
        "the centre of ",
        second,
        " is at a distance ",
        length,
        f" to the {side} of the line along which the centre of ",
        first,
        " approaches it, relative to ",
        second,
    )


def _paths(scene: Scene, event: Impact) -> str:
    """How the two paths lie, as far as the velocities given at the start tell."""
    speeds: Mapping[str, Any] = {sphere.name: sphere.velocity for sphere in scene.problem.spheres}
    if sum(body in bodies_of(one) for one in scene.events for body in bodies_of(event)) > 2:
        return ""
    if is_rest(speeds[event.second]):
        return "struck at rest"
    one, other = exact(speeds[event.first]), exact(speeds[event.second])
    if one is None or other is None or one.cross(other) != 0:
        return ""
    return "parallel" if (one - other).dot(one).is_positive else ""
