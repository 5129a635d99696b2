"""What the data, and lines, say of places, times and velocities: without a line of its own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import substituted
from restitution.explaining.lines.derivation import Line, Link, Ref, Relation
from restitution.expression.tree import AtTime, Binary, Expression, Name, Quantity, has_quantity
from restitution.planning.formulas.resolving import along_axis
from restitution.planning.writing.desk import NotPlannedError, Source, together
from restitution.planning.writing.place_trees import (
    AXES,
    Axis,
    coordinate_tree,
    place_tree,
    time_tree,
)
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def source_of(scene: Scene, value: Any, refs: Sequence[Ref] = ()) -> Source:
    """A value with what stands on the desk put in, and all that it rests on."""
    own, more = scene.put(value)
    return Source(own, together(refs, more))


def standing(scene: Scene, tree: Expression) -> Source | None:
    """What a line, or a fact, gives for a quantity, with everything put in; None without one."""
    source = scene.desk.known(tree)
    return None if source is None else source_of(scene, source.value, source.refs)


def last_move(scene: Scene, body: str, number: int) -> int:
    """The last event before another one in which a body took part; 0 for the start.

    A point that it reaches later than the other event, of which it has no part, is not before it.
    """
    latest = scene.model.story.latest(body, number - 1)
    while latest is not None and _is_reached_later(scene, body, latest.number, number):
        latest = scene.model.story.latest(body, latest.number - 1)
    return 0 if latest is None else latest.number


def _is_reached_later(scene: Scene, body: str, arrival: int, number: int) -> bool:
    """Whether a body comes to a point only after an event that is told below that."""
    kinds = {event.number: event.kind for event in scene.desk.events}
    if kinds.get(arrival) != "arrival" or number not in kinds or body in scene.bodies(number):
        return False
    gap = scene.value(Binary("-", time_tree(number), time_tree(arrival)))
    return scene.model.sign(scene.model.in_data(gap)) < 0


def velocity(scene: Scene, body: str, stage: int, axis: Axis) -> Source:
    """The component of a velocity along an axis, after so many events."""
    source = along_axis(scene, body, stage, axis)
    own = source_of(scene, source.value, source.whole)
    letters_ = {component.symbol for component in scene.model.components.values()}
    if letters_ & own.value.free_symbols:
        raise NotPlannedError(f"the velocity of {body} after event {stage} is open")
    return own


def start(scene: Scene) -> tuple[int, tuple[Ref, ...]]:
    """The event at which the clock starts, and the fact that says so."""
    fact = scene.facts.get("start")
    if fact is None:
        raise NotPlannedError("the clock does not start")
    (own,) = fact.relation.only
    assert isinstance(own.left, Quantity)
    assert isinstance(own.left.stage, int)
    return own.left.stage, (fact.id,)


def contact_of(scene: Scene, number: int) -> Iterator[Link]:
    """What the fact of a contact says of the place of an event."""
    for fact in scene.desk.facts:
        if fact.id == f"contact {number}":
            yield from fact.relation.only


def of_contact(scene: Scene, body: str, number: int, axis: Axis) -> Source | None:
    """A coordinate that the place of an event gives at once: of an aligned wall, or of a point."""
    refs: tuple[Ref, ...] = (f"contact {number}",)
    for own in contact_of(scene, number):
        if own.left == coordinate_tree(body, number, axis):
            return source_of(scene, scene.scalar(own.right), refs)
        if own.left == place_tree(body, number) and not has_quantity(own.right):
            place = scene.value(own.right)
            return source_of(scene, part_of(place, axis), refs)
    return None


def of_contact_tree(scene: Scene, body: str, number: int, axis: Axis) -> Expression | None:
    """A coordinate, or the place, that a contact gives, as it is told."""
    for own in contact_of(scene, number):
        if own.left in (place_tree(body, number), coordinate_tree(body, number, axis)):
            return own.right
    return None


def part_of(place: Any, axis: Axis) -> sp.Expr:
    """The coordinate of a place along an axis."""
    x, y = place
    return sp.sympify(x if axis == "i" else y, strict=True)


def partner_of(scene: Scene, body: str, number: int) -> str | None:
    """The other sphere of an impact of two."""
    others = [other for other in scene.bodies(number) if other != body]
    if len(others) != 1 or others[0] not in scene.model.story.spheres:
        return None
    return others[0]


def offset_at(scene: Scene, body: str, stage: int, axis: Axis) -> sp.Expr:
    """How far, along an axis, a centre is ahead of the one that it touches."""
    own = next(contact_of(scene, stage))
    match own.right:
        case Binary("+" | "-" as sign, Quantity("position"), offset):
            length = part_of(scene.value(offset), axis)
            return length if (sign == "+") == (own.left == place_tree(body, stage)) else -length
    return sp.Integer(0)


def are_apart(scene: Scene, stage: int) -> bool:
    """Whether the centres of two spheres are not in one place when they touch."""
    own = next(contact_of(scene, stage), None)
    return own is not None and not isinstance(own.right, Quantity)


def rests(scene: Scene, body: str, stage: int) -> bool:
    """Whether a body is at rest until an event."""
    own, _ = scene.put(scene.velocity(body, last_move(scene, body, stage)))
    return all(scene.model.in_data(value) == 0 for value in own)


def hide_place_of_rest(scene: Scene, body: str, since: int, number: int) -> None:
    """Takes the place of who rests off paper, where a line above says that it stays there."""
    own = scene.desk.line(number)

    def is_of_this_rest(line: Line) -> bool:
        if not isinstance(line.relation, Relation) or line.move.record != "straight-line":
            return False
        if line.shown != "line" or not scene.desk.holds(line.number):
            return False
        match line.relation.only[0]:
            case Link(Quantity("position", (Name(name),), int(stage))) if name == body:
                return last_move(scene, body, stage) == since < stage
            case Link(Quantity("position", (Name(name),), AtTime())) if name == body:
                return line.move.event == (since or None)
        return False

    if rests(scene, body, since + 1) and any(map(is_of_this_rest, scene.desk.lines[: number - 1])):
        scene.desk.lines[number - 1] = replace(own, shown="silent")


def keeps_still(scene: Scene, body: str, since: int, axis: Axis) -> bool:
    """Whether a body does not move along an axis after an event."""
    pace = scene.model.in_data(part_of(scene.velocity(body, since), axis))
    return bool(pace == 0)


def tidied(scene: Scene, place: Any) -> Vector:
    """A place with what stands on the desk put in."""
    own, _ = scene.put(place)
    return Vector(*(tidy(component) for component in own))


def value_of_velocity(scene: Scene, body: str, stage: int, axis: Axis) -> sp.Expr:
    """A component of a velocity, in letters."""
    return tidy(part_of(scene.velocity(body, stage), axis))


def value_of_coordinate(scene: Scene, body: str, stage: int, axis: Axis) -> sp.Expr:
    """A coordinate of a body at an event, in letters."""
    return tidy(part_of(scene.value(place_tree(body, stage)), axis))


def without_walls(scene: Scene, value: sp.Expr) -> sp.Expr:
    """A value with the components after walls put in by those before them."""
    changes: dict[sp.Basic, sp.Expr] = {}
    for law in scene.model.laws:
        if scene.model.frames[law.number].wall is not None:
            body = scene.bodies(law.number)[0]
            symbol = scene.model.components[law.number, body].symbol
            changes[symbol] = substituted(symbol - law.residual, changes)
    return substituted(value, changes)


def axis_for(scene: Scene, body: str, number: int) -> Axis | None:
    """The direction in which it is known how far a body goes: the shorter one to write."""
    since = last_move(scene, body, number)
    chosen: list[tuple[int, Axis]] = []
    for axis in AXES:
        if of_contact(scene, body, number, axis) is None:
            continue
        pace = value_of_velocity(scene, body, since, axis)
        if pace == 0:
            continue
        open_ = len(scene.unknown(pace))
        place = value_of_coordinate(scene, body, since, axis)
        open_ += len(scene.unknown(place))
        chosen.append((1000 * open_ + sp.count_ops(pace), axis))
    return min(chosen)[1] if chosen else None


def axis_of_approach(scene: Scene, number: int, body: str, other: str) -> Axis:
    """The direction in which two bodies come nearer to each other: one in which both are known."""
    gaps: list[tuple[int, int, Axis]] = []
    for axis in AXES:
        paces = [value_of_velocity(scene, sphere, number - 1, axis) for sphere in (body, other)]
        gap = tidy(paces[0] - paces[1])
        if gap != 0:
            open_ = sum(len(scene.unknown(without_walls(scene, pace))) for pace in paces)
            gaps.append((open_, sp.count_ops(gap), axis))
    if not gaps:
        raise NotPlannedError("two bodies that do not approach")
    return min(gaps)[-1]
