"""Lines of centres that may be on either side of **i**: one side is worked out, the other mirrored.

Both spheres start along **i**, or are at rest, and nothing that is given tells one side from the
other. So there are two solutions, of which one is the other seen in a mirror.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import sympy as sp

from restitution.components.frames import Frame as Resolved
from restitution.components.letters import protected_letters
from restitution.components.models import Model
from restitution.components.telling import model
from restitution.explaining.following.trials import on_either_side
from restitution.explaining.lines.derivation import (
    Derivation,
    Fact,
    Link,
    Meaning,
    Move,
    MoveId,
    Ref,
    Relation,
)
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    negated,
    walk,
)
from restitution.planning.writing.desk import Desk, NotPlannedError, chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.unit_vectors import plain_direction
from restitution.problem import trees
from restitution.records import dataclass
from restitution.solving.equations.solution import ItemResult, PartSolution, Solution
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.planning.writing.scene import Scene


def on_one_side(
    solution: Solution, part: PartSolution, models: Sequence[Model], desk: Desk
) -> tuple[Model, ...]:
    """The solutions with the line of centres beside **j**, where all are mirrored two by two.

    None where they are not.
    """
    facts = tuple(fact for fact in desk.facts if desk.holds(fact.id))
    numbers = on_either_side(Derivation(facts, (), (), desk.events))
    if len(models) < 2 or len(numbers) != 1:
        return ()
    (number,) = numbers
    own = [
        branch_model
        for branch_model in models
        if branch_model.sign(_line(branch_model.frames[number]).y) > 0
    ]
    if 2 * len(own) != len(models):
        return ()
    if any(other.sign(_line(other.frames[number]).x) <= 0 for other in own):
        return ()
    if _given_angle(desk, number, own[0].frames[number].wall) is not None:
        in_numbers = all(x.is_number for other in own for x in other.frames[number].n)
        return tuple(own) if in_numbers else ()
    if any(_is_turned(facts, body) for body in desk.events[0].bodies):
        return tuple(own)  # the change of velocity is known
    protected = protected_letters(part.part)
    turned = frozenset({number})
    return tuple(
        model(solution.problem, part.part, e.branch, part.roles, protected, turned, acute=True)
        for e in own
    )


def as_one(part: PartSolution, models: list[Model], desk: Desk) -> list[Model]:
    """The solutions, or the one that is written for all, where they are one seen in mirrors.

    Of a velocity at the start nothing is told, it is in front of a straight wall, and each
    item has one answer. It is taken to move in the senses of **i** and **j**, or of the normal
    of a slanting wall and of that turned to the left.
    """
    if len(models) < 2 or any(len(item.distinct) != 1 for item in part.items):
        return models
    chosen = [own for own in models if _comes_as_it_is_drawn(own, desk)]
    if len(chosen) != 1:
        return models
    (own,) = chosen
    for frame in own.frames.values():
        for body in (e for e in own.happening(frame.number).bodies if e in own.story.spheres):
            for direction in (frame.n, frame.n.turned_left()):
                first, *others = (e.branch.story.velocity(body, 0).dot(direction) for e in models)
                if any(own.sign(first**2 - other**2) != 0 for other in others):
                    return models
    return chosen


def _comes_as_it_is_drawn(own: Model, desk: Desk) -> bool:
    """Whether bodies of which nothing is told come so to their first walls."""
    seen: set[str] = set()
    for number, frame in sorted(own.frames.items()):
        bodies = [body for body in own.happening(number).bodies if body in own.story.spheres]
        for body in bodies:
            if body in seen or any(fact.id == f"velocity {body}" for fact in desk.facts):
                continue
            seen.add(body)
            if frame.wall is None or not all(part.is_number for part in frame.n):
                return False
            velocity = own.branch.story.velocity(body, 0)
            parts: Iterable[sp.Expr] = velocity
            if 0 not in frame.n:
                axis = next(fact for fact in desk.facts if fact.id == f"axis {number}")
                n = own.story.evaluator(number).direction(axis.relation.only[0].right)
                parts = velocity.dot(n), velocity.dot(n.turned_left())
            if any(own.sign(part) <= 0 for part in parts):
                return False
    return bool(seen)


def _is_turned(facts: Sequence[Fact], body: str) -> bool:
    """Whether a speed and a deflection of a sphere are given."""
    given = {
        fact.relation.only[0].left
        for fact in facts
        if fact.kind == "given" and len(fact.relation.options) == 1
        if fact.relation.only[0].sign == "="
    }
    kinds = {
        tree.kind for tree in given if isinstance(tree, Quantity) and Name(body) in tree.arguments
    }
    return {"speed", "deflection"} <= kinds


def _line(frame: Resolved) -> Vector:
    """The direction whose side is open: of a wall its own, else of the line of centres."""
    return frame.n if frame.wall is None else frame.t


def _angle(number: int, wall: str | None) -> Quantity:
    line = Quantity("line_of_centres", (), number) if wall is None else Name(wall)
    return Quantity("angle", (line, Unit("i")))


@dataclass(frozen=True)
class _Given:
    """The fact that gives the angle to **i**: of the line itself, or of the impulse on a body."""

    fact: str
    angle: Expression
    body: str | None = None


def _given_angle(desk: Desk, number: int, wall: str | None) -> _Given | None:
    """The fact that gives the angle to **i**."""
    asked = _angle(number, wall)
    forms: dict[Expression, str | None] = {asked: None, _reversed(asked): None}
    if wall is None:
        for body in desk.events[number - 1].bodies:
            pushed = Quantity("angle", (Quantity("impulse", (Name(body),), number), Unit("i")))
            forms |= {pushed: body, _reversed(pushed): body}
    for fact in desk.facts:
        if fact.kind == "given" and desk.holds(fact.id) and len(fact.relation.options) == 1:
            first = fact.relation.only[0]
            if first.left in forms and first.sign == "=":
                return _Given(fact.id, first.right, forms[first.left])
    return None


def _by_the_impulse(scene: Scene, number: int, given: _Given) -> int:
    """The angle of a line of centres by that of an impulse, which is along it."""
    assert given.body is not None
    sides: list[tuple[Expression, MoveId | None]] = [(given.angle, None)]
    if given.body == scene.bodies(number)[0]:
        # The line is from the first sphere to the second, as the impulse on that.
        rest = Binary("-", STRAIGHT_ANGLE, given.angle)
        sides = [(rest, None), (tree_of(scene.value(rest), angle=True), "rearrange")]
    move = Move("law", "across-the-impulse", number, (given.body,))
    return scene.desk.write(move, (given.fact,), chain(_angle(number, None), *sides))


def _reversed(angle: Quantity) -> Quantity:
    return replace(angle, arguments=tuple(reversed(angle.arguments)))


def angle_of_centres(scene: Scene, number: int) -> Expression | None:
    """The angle of a line of centres from **i**, as it is given or by its letter; None without."""
    own = scene.model.frames[number]
    if own.angle is not None:
        return Letter(own.angle.name)
    given = _given_angle(scene.desk, number, own.wall)
    fact = scene.facts.get(f"axis {number}")
    if given is not None:
        if given.body is not None and given.body == scene.bodies(number)[0]:
            return tree_of(scene.value(Binary("-", STRAIGHT_ANGLE, given.angle)), angle=True)
        angle = given.angle
    elif fact is not None:
        angle = fact.relation.only[0].right
    else:
        return None
    return angle if isinstance(angle, Letter | Degrees) else None


def frame_on_one_side(scene: Scene, number: int) -> Frame | None:
    """The frame of such a line of centres, by the angle that it makes with **i**."""
    own = scene.model.frames[number]
    centres = Quantity("line_of_centres", (), number)
    if not scene.sided:
        return None
    given = _given_angle(scene.desk, number, own.wall)
    ref: Ref
    if own.angle is not None:
        asked = _angle(number, own.wall)
        turned = _reversed(asked)
        if any(node == turned for tree in trees(scene.problem) for node in walk(tree)):
            asked = turned  # as the question says it
        meaning = Meaning(own.angle.name, asked, angle="acute")
        ref = scene.desk.write(Move("let"), (), meaning)
    elif given is None:
        return None
    elif given.body is None:
        ref = given.fact
    else:
        ref = _by_the_impulse(scene, number, given)
    # Of a wall, the direction is into it.
    n, sign = (own.n, 1) if own.wall is None else (-own.n, -1)
    return Frame(number, own.wall, centres, None, n, n.turned_left(), (ref,), sign)


def write_other_side(scene: Scene, result: ItemResult, name: str) -> None:
    """What was found of a direction or a vector, or the same on the other side of **i**.

    Raises NotPlannedError for other values that differ from one side to the other.
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
    elif len(result.distinct) > scene.sided and len(end.answer.options) == 1:
        raise NotPlannedError("a value that is another one on the other side")


def write_sides(scene: Scene, number: int) -> int | None:
    """The two directions that a line of centres may have; None where they are not told so."""
    own = scene.model.frames[number]
    if not scene.sided:
        return None
    line: Quantity = Quantity("line_of_centres", (), number)
    if own.wall is not None:
        line = Quantity("direction", (Name(own.wall),))
    frame = scene.frame(number)
    (n, refs) = scene.put(_line(own))
    whole = plain_direction(n)
    links = [
        Link(line, "parallel to", tree_of(vector)) for vector in (whole, Vector(whole.x, -whole.y))
    ]
    relation = Relation(((links[0],), (links[1],)))
    move = Move("define", "either-side", number)
    return scene.desk.write(move, together(frame.sources, refs), relation)


def _has_a_side(scene: Scene, link: Link) -> bool:
    """Whether a line is about a direction or a vector, which a mirror turns."""
    match scene.desk.meant(link.left):
        case Quantity("direction", (Name(),)) | Quantity("velocity" | "line_of_centres"):
            return True
        case Quantity("impulse", arguments):
            return bool(arguments)
    return False


def _mirrored(scene: Scene, link: Link) -> Expression:
    """The right side of a link, mirrored along **i**."""
    match scene.desk.meant(link.left):
        case Quantity("direction", (Name(),), int()):
            return negated(link.right)
    value = scene.vector(link.right)
    return tree_of(Vector(value.x, -value.y))


__all__ = [
    "angle_of_centres",
    "frame_on_one_side",
    "on_one_side",
    "write_other_side",
    "write_sides",
]
