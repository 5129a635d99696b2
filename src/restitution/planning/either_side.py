"""Lines of centres that may be on either side of **i**: one side is worked out, the other mirrored.

Both spheres start along **i**, or are at rest, and nothing that is given tells one side from the
other. So there are two solutions, of which one is the other seen in a mirror.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from restitution.components import Model, model, protected_letters
from restitution.exact import tidy
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
from restitution.planning.desk import Desk, NotPlannedError, together
from restitution.planning.forms import tree_of
from restitution.planning.frames import Frame
from restitution.planning.impacts import whole_direction
from restitution.solve.solution import ItemResult, PartSolution, Solution
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.planning.scene import Scene


def on_one_side(
    solution: Solution, part: PartSolution, models: Sequence[Model], desk: Desk
) -> tuple[Model, ...]:
    """Of solutions that are mirrored two by two, those with the line of centres beside **j**.

    None where they are not.
    """
    facts = tuple(each for each in desk.facts if desk.holds(each.id))
    numbers = on_either_side(Derivation(facts, (), (), desk.events))
    if len(models) < 2 or len(numbers) != 1:
        return ()
    (number,) = numbers
    own = [each for each in models if each.sign(each.frames[number].n.y) > 0]
    if 2 * len(own) != len(models):
        return ()
    if any(each.sign(each.frames[number].n.x) <= 0 for each in own):
        return ()
    given = _is_given(desk, number)
    if given is not None:
        in_numbers = all(x.is_number for each in own for x in each.frames[number].n)
        return tuple(own) if in_numbers else ()
    protected = protected_letters(part.part)
    turned = frozenset({number})
    return tuple(
        model(solution.problem, part.part, e.branch, part.roles, protected, turned, acute=True)
        for e in own
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


def write_other_side(scene: Scene, result: ItemResult, name: str, solutions: int) -> None:
    """What was found of a direction or a vector, or the same on the other side of **i**.

    ``solutions`` is how many there are on one side. Raises NotPlannedError for other values that
    differ from one side to the other.
    """
    end = scene.desk.ends[-1]
    if result.kind not in ("value", "vector", "direction") or end.item != name:
        return
    number = next(iter(scene.model.frames))
    alone = len(scene.desk.relation(end.line).options) == 1
    link = scene.desk.last_link(end.line) if alone else None
    if link is not None and _has_a_side(scene, link):
        other = _mirrored(scene, link)
        if other == link.right:
            return
        relation = Relation(((link,), (replace(link, right=other),)))
        line = scene.desk.write(Move("define", "either-side", number), (end.line,), relation)
        scene.desk.ends[-1] = replace(end, line=line, answer=relation)
    elif len(result.distinct) > solutions and len(end.answer.options) == 1:
        raise NotPlannedError("a value that is another one on the other side")


def write_sides(scene: Scene, number: int) -> int | None:
    """The two directions that a line of centres may have; None where they are not told so."""
    own = scene.model.frames[number]
    if own.angle is None:
        return None
    centres = Quantity("line_of_centres", (), number)
    frame = scene.frame(number)
    (n, refs) = scene.put(own.n)
    whole, _ = whole_direction(Vector(*map(tidy, n)))
    links = [
        Link(centres, "parallel to", tree_of(each)) for each in (whole, Vector(whole.x, -whole.y))
    ]
    relation = Relation(((links[0],), (links[1],)))
    move = Move("define", "either-side", number)
    return scene.desk.write(move, together(frame.told, refs), relation)


def _has_a_side(scene: Scene, link: Link) -> bool:
    """Whether a line is about a direction or a vector, which a mirror turns."""
    match _meant(scene, link.left):
        case Quantity("direction", (Name(),)) | Quantity("velocity" | "line_of_centres"):
            return True
        case Quantity("impulse", arguments):
            return bool(arguments)
    return False


def _meant(scene: Scene, subject: Expression) -> Expression:
    """What a letter of the working stands for."""
    if isinstance(subject, Letter):
        for each in scene.desk.lines:
            if isinstance(each.relation, Meaning) and each.relation.letter == subject.name:
                return each.relation.quantity
    return subject


def _mirrored(scene: Scene, link: Link) -> Expression:
    """The right side of a link, mirrored along **i**."""
    match _meant(scene, link.left):
        case Quantity("direction", (Name(),)):
            return link.right.operand if isinstance(link.right, Negate) else Negate(link.right)
    value = scene.vector(link.right)
    return tree_of(Vector(value.x, -value.y))


__all__ = [
    "angle_of_centres",
    "frame_on_one_side",
    "on_one_side",
    "write_other_side",
    "write_sides",
]
