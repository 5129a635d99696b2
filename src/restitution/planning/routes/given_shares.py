"""A kinetic energy, a speed or a time that the statement gives by one before it."""

from __future__ import annotations

from typing import Any

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import (
    Binary,
    Expression,
    Quantity,
    has_quantity,
    letters,
    quantities_in,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import product, tree_of
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.vector import Vector

_KINDS = ENERGIES | {"speed", "time"}


def write_given_share(scene: Scene, asked: Quantity, *, early: bool = False) -> int | None:
    """The line of what is asked, by the given fact of which it is the one side; None of another.

    What stands on the other side is of the data, as the kinetic energy before the impact. The fact
    has told what is open already, or nothing else is asked, or it is an ``early`` item, above it.
    """
    if asked.kind not in _KINDS:
        return None
    used = {ref for line in scene.desk.lines for ref in line.premises}
    for equation in scene.given:
        other = _other_side(equation, asked)
        waits = equation.fact.id not in used and len(scene.solution.items) > 1
        if other is None or (waits and not early):
            continue
        mark = scene.desk.mark()
        line = _write(scene, equation, asked, other)
        if line is not None:
            return line
        scene.desk.back(mark)
    return None


def write_given_value(scene: Scene, asked: Quantity) -> int | None:
    """The line of a number that is asked and is given as such: the fact; None of all else."""
    for equation in scene.given:
        own = equation.link
        if own.left != asked or own.sign != "=" or has_quantity(own.right) or letters(own.right):
            continue
        if isinstance(scene.value(own.right), Vector):
            continue
        return scene.judge.write((Move("fact"),), equation.refs, Relation(((own,),)))
    return None


def _other_side(given: GivenEquation, asked: Quantity) -> Expression | None:
    """What a given equation says that a quantity is, in other quantities; None if it does not."""
    for left, right in ((given.link.left, given.link.right), (given.link.right, given.link.left)):
        match left:
            case Quantity() if left == asked:
                other = right
            case Binary("/", above, below) if above == asked:
                other = product(right, below)
            case Binary("-", late, early) if late == asked:
                other = Binary("+", early, right)
            case _:
                continue
        inside = list(quantities_in(other))
        if inside and asked not in inside and all(node.kind in _KINDS for node in inside):
            return other
    return None


def _write(scene: Scene, given: GivenEquation, asked: Quantity, other: Expression) -> int | None:
    """The value of a quantity by those of the quantities on the other side of a given equation."""
    values: dict[Expression, Expression] = {}
    refs: list[Ref] = []
    inside = dict.fromkeys(quantities_in(other))
    for quantity in inside:
        try:
            own = formula(scene, quantity)
            if scene.unknown(own.value):
                return None
            line = write_formula(scene, own)
        except NotPlannedError:
            return None
        values[quantity] = scene.desk.last_link(line).right
        refs.append(line)
    put = rebuilt(other, lambda node: values.get(node, node))
    value: Any = tidy(scene.scalar(put))
    if scene.unknown(value):
        return None
    relation = chain(asked, (put, None), (tree_of(value), "rearrange"))
    premises = scene.judge.enough(Move("put"), (*given.refs, *refs), relation)
    if premises is None:
        return None
    line = scene.desk.write(Move("put"), premises, relation)
    scene.desk.know(asked, value, (line,))
    return line


__all__ = ["write_given_share", "write_given_value"]
