"""Times, places and distances that are asked: their last lines."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.exact import is_zero
from restitution.explaining.lines.derivation import Move, numbers_in
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    AtTime,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    letters,
)
from restitution.planning.formulas.whereabouts import are_apart, last_move, standing, without_walls
from restitution.planning.journeys.distances import distance, sized
from restitution.planning.journeys.instants import piece, place_then
from restitution.planning.journeys.places import (
    coordinate,
    coordinate_moved,
    flight_time,
    leg_line,
    place,
    time_of,
)
from restitution.planning.journeys.steady import time_at_one_pace, write_steady_ways
from restitution.planning.writing.desk import NotPlannedError, Source, chain
from restitution.planning.writing.forms import swept, tree_of
from restitution.planning.writing.one_fraction import added_up
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def goals(scene: Scene, asked: Expression) -> list[sp.Expr]:
    """What has to be known for a time or a place.

    What a wall does to a component follows from the component before it, and is written when the
    working comes to that wall.
    """
    match asked:
        case Quantity("distance", (Name(a), Name(b)), AtTime(time)) if (
            {a, b} <= set(scene.model.story.spheres)
            and (met := piece(scene, a, time)) == piece(scene, b, time)
            and met
            and are_apart(scene, met)
        ):
            both = [scene.velocity(body, met) for body in (a, b)]
            return [without_walls(scene, sp.sympify(x, strict=True)) for v in both for x in v]
    value = scene.value(asked)
    parts = list(value) if isinstance(value, Vector) else [value]
    match asked:
        case Quantity("time", (), int(number)):
            parts += _on_the_way(scene, number)
        case Quantity("position", (Name(body),), int(stage)) | Quantity(
            "along", (Quantity("position", (Name(body),), int(stage)), _)
        ):
            parts += _off_from_rest(scene, body, stage)
        case Quantity("distance", places):
            for place_ in places:
                match place_:
                    case Quantity("position", (Name(body),), int(stage)):
                        parts += _off_from_rest(scene, body, stage)
    return [without_walls(scene, sp.sympify(part, strict=True)) for part in parts]


def _off_from_rest(scene: Scene, body: str, stage: int) -> list[sp.Expr]:
    """The velocity by which a sphere comes to a place from where it was struck at rest.

    Its direction is the line of centres: where that tells the place, its letter would stay open.
    """
    since = last_move(scene, body, stage) if stage else 0
    if not since or len(scene.spheres(since)) != len(scene.bodies(since)) or stage == since:
        return []
    if scene.last_event(body, since - 1) or any(scene.initial(body).value):
        return []
    own = list(scene.velocity(body, since))
    return [] if any(scene.model.identically_zero(part) for part in own) else own


def _on_the_way(scene: Scene, number: int) -> list[sp.Expr]:
    """The velocities by which spheres come to an impact, where their centres are apart then.

    The time of that is known by numbers, and says nothing of the letters that it comes of.
    """
    bodies = scene.bodies(number)
    if not number or len(scene.spheres(number)) != len(bodies) or not are_apart(scene, number):
        return []
    own: list[sp.Expr] = []
    for body in bodies:
        since = last_move(scene, body, number)
        own += [*scene.velocity(body, since), *_on_the_way(scene, since)]
    return own


def write(scene: Scene, asked: Expression) -> tuple[int, Any]:
    """Writes what a time, a place or a distance is; returns the last line, and the value.

    Raises NotPlannedError where there is no plan, and where the data say it already.
    """
    match asked:
        case Quantity("time", (), int(number)):
            source = time_at_one_pace(scene, number) or _time(scene, number)
        case Quantity("along", (Quantity("position", (Name(body),), int(stage)), Unit(axis))):
            source = coordinate(scene, body, stage, axis)
            if not any(isinstance(ref, int) for ref in source.refs):
                source = coordinate_moved(scene, body, stage, axis)
        case Quantity("position", (Name(body),), int(stage)):
            source = place(scene, body, stage)
        case Quantity("position", (Name(body),), AtTime()):
            source = place_then(scene, asked, body)
        case Quantity("distance", (_, _)):
            source = distance(scene, asked)
        case Binary("-", Quantity("time", (), int(late)), Quantity("time", (), int(early))):
            source = _duration(scene, asked, late, early)
        case _:
            raise NotPlannedError("no plan for a place of that kind")
    _check(scene, asked, source.value)
    lines = numbers_in(source.refs)
    if not lines:
        raise NotPlannedError("what is asked is given")
    known = scene.desk.known(asked)
    standing_ = () if known is None or known.value == source.value else numbers_in(known.refs)
    if len(standing_) == 1:
        lines = [_write_put(scene, asked, standing_[0], source)]
    elif len(lines) > 1:
        relation = chain(asked, (tree_of(source.value), None))
        lines = [scene.desk.write(Move("put"), source.refs, relation)]
        scene.desk.know(asked, source.value, lines)
    return lines[0], source.value


def _write_put(scene: Scene, asked: Expression, line: int, put: Source) -> int:
    """The line of what stands in a line, with the letters put in that have been found since.

    A tangent that is given goes into a tangent: its sine and its cosine are not needed. Where the
    value takes an identity, the letters are put in first.
    """
    own, last = (scene.desk.last_link(line).right, tree_of(put.value))
    lines = (ref for ref in numbers_in(put.refs) if ref != line)
    facts = [ref for n in lines for ref in scene.desk.line(n).premises if isinstance(ref, str)]
    pool = (line, *facts, *put.refs)
    values: dict[Expression, Expression] = {}
    for name in sorted(letters(own) - letters(last)):
        value, refs = scene.put(scene.scalar(Letter(name)))
        if refs:
            values[Letter(name)] = tree_of(value)
    between = swept(exchanged(own, values))
    for relation in (
        chain(asked, (last, None)),
        chain(asked, (between, None), (last, "rearrange")),
        chain(asked, (between, None), (last, "identity")),
    ):
        premises = scene.judge.needed(Move("put"), pool, relation)
        if premises is not None:
            number = scene.desk.write(Move("put"), premises, relation)
            scene.desk.know(asked, put.value, (number,))
            return number
    raise NotPlannedError("a value that does not follow by what is put in")


def _time(scene: Scene, number: int) -> Source:
    """The time of an event, with the ways to it on which a component is the same taken together."""
    write_steady_ways(scene, number)
    return time_of(scene, number)


def _check(scene: Scene, asked: Expression, value: Any) -> None:
    """The value has to be that of the story."""
    own, in_data = scene.value(asked), scene.model.in_data
    pairs = zip(own, value, strict=True) if isinstance(value, Vector) else [(own, value)]
    sizes = [(sized(scene, in_data(a)), sized(scene, in_data(b))) for a, b in pairs]
    if not all(_are_equal(scene, *two) for two in sizes):
        raise NotPlannedError("another piece of the path than the lines say")


def _are_equal(scene: Scene, one: sp.Expr, other: sp.Expr) -> bool:
    """Whether two values are the same, or their squares where a root has a sign of its own.

    The root of sin² α/cos² α is not tan α for all α, but for those of the question.
    """
    if _vanishes(scene, one - other):
        return True
    if not any(x.is_Pow and x.exp == sp.Rational(1, 2) for x in sp.preorder_traversal(one)):
        return False
    alike = scene.model.sign(one) == scene.model.sign(other)
    return alike and _vanishes(scene, one**2 - other**2)


def _vanishes(scene: Scene, gap: sp.Expr) -> bool:
    """Whether two values are the same; numbers of degrees may be in sines or in cosines."""
    return scene.model.identically_zero(gap) or (not gap.free_symbols and is_zero(gap))


def _duration(scene: Scene, asked: Expression, late: int, early: int) -> Source:
    """The time between two events: of one way, or of several, at one pace or added up."""
    if early and (steady := time_at_one_pace(scene, late, early)) is not None:
        return steady
    tree, value, refs = flight_time(scene, early, late)
    known = standing(scene, asked)
    if known is not None:
        return known
    premises = tuple(dict.fromkeys((*leg_line(scene, late), *refs)))
    relation = added_up(scene, asked, tree, value)
    line = scene.desk.write(Move("put"), premises, relation)
    return scene.desk.know(asked, value, (line,))
