"""Velocities that are given by others: **v**_A = 2**v**_B is worked out as soon as the other is."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.derivation import Move
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Expression, Name, Quantity, walk
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.velocity_formulas import velocity_formula
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.vectors import common_velocity


def write_related(scene: Scene, asked: Expression) -> None:
    """Writes the velocities in something asked, where others tell them."""
    bodies = {node.name for node in walk(asked) if isinstance(node, Name)}
    if not isinstance(asked, Quantity):
        return
    for equation in scene.given:
        match equation.link.left:
            case Quantity("velocity", (Name(body),), int(stage)) as velocity if (
                body in bodies or not bodies
            ):
                pass
            case _:
                continue
        others = list(_others(scene, equation))
        if equation.link.sign != "=" or common_velocity(equation) is not None or not others:
            continue
        if scene.desk.known(velocity) is not None or stage not in scene.model.frames:
            continue
        mark = scene.desk.mark()
        try:
            _write(scene, equation, velocity, others)
        except NotPlannedError:
            scene.desk.back(mark)


def _others(scene: Scene, given: GivenEquation) -> Iterator[Quantity]:
    """The velocities after an impact of which a given one is made."""
    for node in walk(given.link.right):
        match node:
            case Quantity("velocity", _, int(stage)) if stage in scene.model.frames:
                yield node


def _write(scene: Scene, given: GivenEquation, velocity: Quantity, others: list[Quantity]) -> None:
    values: dict[Expression, Expression] = {}
    lines: list[int] = []
    for other in others:
        own = velocity_formula(scene, other)
        if any(scene.unknown(part) for part in own.value):
            raise NotPlannedError("a velocity by one that is open")
        lines.append(write_formula(scene, own))
        values[other] = scene.desk.last_link(lines[-1]).right
    value, _ = scene.put(scene.vector(given.link.right))
    right = exchanged(given.link.right, values)
    relation = chain(velocity, (right, None), (tree_of(value), "rearrange"))
    premises = scene.judge.needed(Move("put"), (*given.refs, *lines), relation)
    if premises is None:
        raise NotPlannedError("a velocity by another one")
    line = scene.desk.write(Move("put"), premises, relation)
    scene.desk.know(velocity, value, (line,))


__all__ = ["write_related"]
