"""From its end: a velocity that is known behind walls gives the one before each of them.

So no letters for the components at the start are carried from wall to wall.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.expression.tree import Expression, Letter, Name, Quantity
from restitution.planning.axes.open_lines import tried
from restitution.planning.formulas.assembling import put_together
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.scalar_products import by_scalar_product
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import negative, product, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.vectors import velocity_given
from restitution.vector import Vector


def write_back_through_walls(scene: Scene) -> None:
    """The velocities before walls that slant, where the one behind the last of them is given."""
    for body in scene.model.story.spheres:
        events = [n for n in range(1, scene.events + 1) if body in scene.bodies(n)]
        if events and _are_known(scene, body, events):
            tried(scene, partial(_write, scene, body, events))


def _are_known(scene: Scene, body: str, events: list[int]) -> bool:
    """Whether all is known but the velocity at the start, and walls are straight and one slants."""
    frames = [scene.model.frames.get(number) for number in events]
    if any(own is None or own.wall is None or own.by_values for own in frames):
        return False
    if not all(x.is_number for own in frames if own is not None for x in own.n):
        return False
    if all(0 in own.n for own in frames if own is not None):
        return False
    if any(scene.unknown(scene.coefficient(number).value) for number in events):
        return False
    early = scene.velocity(body, 0)
    return all(part.is_Symbol and scene.unknown(part) for part in early)


def _write(scene: Scene, body: str, events: list[int]) -> bool:
    given = velocity_given(scene, body, events[-1])
    if given is None or not all(part.is_number for part in given[1]):
        return False
    source = Source(given[1], given[2])
    for number, stage in zip(reversed(events), (*reversed(events[:-1]), 0), strict=True):
        source = _before(scene, body, number, stage, source)
    take_start(scene, body, source)
    return True


def take_start(scene: Scene, body: str, source: Source) -> None:
    """The letters of a velocity at the start, by a line that says what it is."""
    if f"velocity {body}" not in scene.facts:
        # No letters are printed for a velocity that the statement leaves open.
        for letter, part in zip(scene.velocity(body, 0), source.value, strict=True):
            scene.desk.know(Letter(letter.name), part, source.refs)
        return
    data = scene.initial(body)
    link = chain(tree_of(data.value), (tree_of(source.value), None))
    whole = scene.judge.write((Move("put"),), (*source.refs, *data.refs), link)
    if whole is None:
        raise NotPlannedError("the letters of a velocity by its components")
    for letter, part in zip(data.value, source.value, strict=True):
        relation = chain(tree_of(letter), (tree_of(part), None))
        line = scene.judge.write((Move("put"), Move("rearrange")), (whole,), relation)
        if line is None:
            raise NotPlannedError("the letters of a velocity by its components")
        scene.desk.know(Letter(letter.name), part, (line,))


def _before(scene: Scene, body: str, number: int, stage: int, late: Source) -> Source:
    """The velocity before a wall by that after it: both laws, and its components put together."""
    frame = scene.frame(number)
    across = _component(scene, body, frame, "across", number, late)
    along = _component(scene, body, frame, "along", number, late)
    e = scene.coefficient(number)
    if e.value == 0:
        raise NotPlannedError("a velocity that a wall takes away")
    beside, towards = (frame.component(kind, body, stage) for kind in ("across", "along"))
    stays = _law(
        scene,
        Move("law", "unchanged", number, (body,)),
        chain(beside, (tree_of(across.value), None)),
        together(across.whole, frame.refs),
    )
    law = _law(
        scene,
        Move("law", "restitution-wall", number, (body,)),
        chain(tree_of(along.value), (negative(product(tree_of(e.value), towards)), None)),
        together(along.whole, e.refs, frame.refs),
    )
    value = tidy(-along.value / e.value)
    turned = scene.desk.write(Move("rearrange"), (law,), chain(towards, (tree_of(value), None)))
    parts = Source(value, (turned,)), Source(across.value, (stays,))
    for component, part in zip((towards, beside), parts, strict=True):
        scene.desk.know(component, part.value, part.refs)
    whole = put_together(body, stage, frame, parts)
    if stage == 0:
        whole = replace(whole, refs=together(whole.refs, frame.unit_free))
    line = write_formula(scene, whole)
    vector = Vector(*(tidy(expanded(part)) for part in whole.value))
    scene.desk.know(Quantity("velocity", (Name(body),), stage), vector, (line,))
    return Source(vector, (line,))


def _law(scene: Scene, move: Move, relation: Relation, pool: tuple[Ref, ...]) -> int:
    refs = scene.judge.needed(move, pool, relation)
    if refs is None:
        raise NotPlannedError("a law for the velocity before a wall")
    return scene.desk.write(move, refs, relation)


def _component(
    scene: Scene, body: str, frame: Frame, kind: str, stage: int, velocity: Source
) -> Source:
    direction = frame.n if kind == "along" else frame.t
    quantity: Expression = frame.component(kind, body, stage)
    if frame.is_slanted:
        assert isinstance(quantity, Quantity)
        return by_scalar_product(scene, quantity, velocity, frame, direction)
    return Source(tidy(velocity.value.dot(direction)), velocity.refs, frame.refs)
