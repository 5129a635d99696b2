"""Lines of centres that may be on either side of **i**: one side is worked out, the other mirrored.

Both spheres start along **i**, or are at rest, and nothing that is given tells one side from the
other. So there are two solutions, of which one is the other seen in a mirror.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from restitution.components import Model, model, protected_letters
from restitution.explaining.derivation import Derivation, Link, Meaning, Move, Relation
from restitution.explaining.trials import on_either_side
from restitution.expression.tree import (
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
)
from restitution.planning.desk import Desk, NotPlannedError
from restitution.planning.forms import tree_of
from restitution.planning.frames import Frame
from restitution.solve.solution import Answer, ItemResult, PartSolution, Solution
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.planning.scene import Scene


def on_one_side(
    solution: Solution, part: PartSolution, models: Sequence[Model], desk: Desk
) -> Model | None:
    """The solution of two mirrored ones in which the line of centres is on the side of **j**.

    None where there are no two such solutions.
    """
    if len(models) != 2:
        return None
    facts = tuple(each for each in desk.facts if desk.holds(each.id))
    numbers = on_either_side(Derivation(facts, (), (), desk.events))
    if len(numbers) != 1:
        return None
    (number,) = numbers
    own = next((each for each in models if each.sign(each.frames[number].n.y) > 0), None)
    if own is None or own.sign(own.frames[number].n.x) <= 0:
        return None
    given = _is_given(desk, number)
    if given is not None:
        numbers_only = all(each.is_number for each in own.frames[number].n)
        return own if numbers_only else None
    protected = protected_letters(part.part)
    return model(
        solution.problem,
        part.part,
        own.branch,
        part.roles,
        protected,
        frozenset({number}),
        acute=True,
    )


def _angle(number: int) -> Quantity:
    return Quantity("angle", (Quantity("line_of_centres", (), number), Unit("i")))


def _is_given(desk: Desk, number: int) -> str | None:
    """The fact that gives the angle to **i**."""
    for fact in desk.facts:
        if fact.kind == "given" and desk.holds(fact.id) and len(fact.relation.options) == 1:
            first = fact.relation.only[0]
            if first.left == _angle(number) and first.sign == "=":
                return fact.id
    return None


def angle_of_centres(scene: Scene, number: int) -> Expression | None:
    """The angle of a line of centres from **i**, as it is given or by its letter; None without."""
    own = scene.model.frames[number]
    if own.angle is not None:
        return Letter(own.angle.name)
    given = _is_given(scene.desk, number)
    fact = scene.facts.get(f"axis {number}" if given is None else given)
    if fact is None:
        return None
    (link,) = fact.relation.only
    return link.right if isinstance(link.right, Letter | Degrees) else None


def frame_on_one_side(scene: Scene, number: int) -> Frame | None:
    """The frame of such a line of centres, by the angle that it makes with **i**."""
    own = scene.model.frames[number]
    centres = Quantity("line_of_centres", (), number)
    given = _is_given(scene.desk, number)
    if own.angle is None and given is None:
        return None
    if own.angle is None:
        return Frame(number, None, centres, None, own.n, own.n.turned_left(), (str(given),), 1)
    meaning = Meaning(own.angle.name, _angle(number), angle="acute")
    line = scene.desk.write(Move("let"), (), meaning)
    return Frame(number, None, centres, None, own.n, own.n.turned_left(), (line,), 1)


def write_other_side(scene: Scene, result: ItemResult, name: str) -> None:
    """What was found of a direction or a vector, or the same on the other side of **i**."""
    if (
        result.kind not in ("value", "vector", "direction")
        or len(result.distinct) != 2
        or len(scene.others) > 1
    ):
        return
    end = scene.desk.ends[-1]
    if end.item != name or len(end.answer.options) != 1:
        return
    link = scene.desk.last_link(end.line)
    number = next(iter(scene.model.frames))
    if not _is_mirrored(result.distinct):
        raise NotPlannedError("answers of which one is not the other, mirrored")
    relation = Relation(((link,), (replace(link, right=_mirrored(scene, link)),)))
    line = scene.desk.write(Move("define", "either-side", number), (end.line,), relation)
    scene.desk.ends[-1] = replace(end, line=line, answer=relation)


def _is_mirrored(answers: Sequence[Answer]) -> bool:
    """Whether there are two values, of which one is the other mirrored."""
    first, second = (each.value for each in answers)
    if isinstance(first, Vector) and isinstance(second, Vector):
        return bool(sp.expand(first.x - second.x) == 0 and sp.expand(first.y + second.y) == 0)
    return not isinstance(first, Vector | tuple)


def _mirrored(scene: Scene, link: Link) -> Expression:
    """The right side of a link, mirrored along **i**."""
    subject = link.left
    meanings = {
        each.relation.letter: each.relation.quantity
        for each in scene.desk.lines
        if isinstance(each.relation, Meaning)
    }
    if isinstance(subject, Letter):
        subject = meanings.get(subject.name, subject)
    match subject:
        case Quantity("direction", (Name(),)):
            return link.right.operand if isinstance(link.right, Negate) else Negate(link.right)
    value = scene.vector(link.right)
    return tree_of(Vector(value.x, -value.y))


__all__ = ["angle_of_centres", "frame_on_one_side", "on_one_side", "write_other_side"]
