"""One angle by two names: the later one is the earlier one, or what that leaves of 180°."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    Link,
    Meaning,
    Move,
    MoveId,
    Ref,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    is_quantity,
    walk,
)
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import swept, tree_of
from restitution.planning.writing.scene import Scene


def write_same_angle(scene: Scene, asked: Quantity, letter: str, meaning: Ref) -> int | None:
    """The line that an angle is another one that has a tangent; None where it is none."""
    for other, tree, named in (*_others(scene, asked), *_without_letters(scene, asked)):
        bodies = tuple(sorted(_bodies(asked) | _bodies(other)))
        event = max(_stages(asked), default=0)
        match asked, other:
            case (
                Quantity("angle", (_, Quantity("line_of_centres", (), int(impact)))),
                Quantity("angle", (_, Name())),
            ):
                event = impact
        relation = chain(Letter(letter), (tree, None))
        move = Move("define", "difference", event, bodies)
        pool = [*_components(scene, bodies, event), meaning, *named]
        refs = scene.judge.needed(move, pool, relation, (meaning, *named))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    return None


_Other = tuple[Quantity, Expression, tuple[Ref, ...]]
"""Another angle, how lines write it, and what says what its letter stands for."""


def _others(scene: Scene, asked: Quantity) -> Iterator[_Other]:
    """The angles of the same velocity that have a letter, and a tangent in some line."""
    for line in scene.desk.lines:
        own = line.relation
        if not isinstance(own, Meaning) or own.angle is not None:
            continue
        if not isinstance(own.quantity, Quantity) or not scene.desk.holds(line.number):
            continue
        letter = Letter(own.letter)
        if _is_alike(asked, own.quantity) and _tangent(scene, letter):
            yield own.quantity, letter, (line.number,)
    for ref, fact in scene.facts.items():
        match fact.relation.options:
            case ((Link(Quantity() as quantity, "=", Letter() as letter),),) if (
                ref.startswith("let ") and _is_alike(asked, quantity) and _tangent(scene, letter)
            ):
                yield quantity, letter, (ref,)


def _without_letters(scene: Scene, asked: Quantity) -> Iterator[_Other]:
    """The angles of the same velocity of which a line has the tangent, without a letter."""
    for line in reversed(scene.desk.lines):
        match line.relation:
            case Relation(((Link(Apply("tan", Quantity() as other), "="), *_),)):
                if _is_alike(asked, other) and _tangent(scene, other) == line.number:
                    yield other, other, ()


def _is_alike(asked: Quantity, other: Quantity) -> bool:
    """Whether one angle may be the other: they are of one velocity, by different lines."""
    kinds = {_kind(asked), _kind(other)}
    return other != asked and kinds in _ALIKE and bool(_moving(asked) & _moving(other))


_ALIKE = (
    {"two", "line"},
    {"two", "fixed"},
    {"direction", "fixed"},
    {"direction", "line"},
    {"line", "fixed"},
)


def _kind(angle: Quantity) -> str:
    """Between what an angle is: two velocities, one and the line of centres, or a direction."""
    match angle:
        case Quantity("direction", (Name(),), int()):
            return "direction"
        case Quantity("angle", (Quantity("velocity"), Quantity("velocity"))):
            return "two"
        case Quantity("angle", (Quantity("velocity"), Quantity("line_of_centres"))):
            return "line"
        case Quantity("angle", (Quantity("velocity"), Name() | Unit())):
            return "fixed"
    return "other"


def _moving(angle: Quantity) -> set[tuple[str, int]]:
    """The bodies between whose velocities an angle lies, each with the event before it."""
    match angle:
        case Quantity("direction", (Name(body),), int(stage)):
            return {(body, stage)}
    return {
        (node.arguments[0].name, node.stage)
        for node in walk(angle)
        if is_quantity(node, "velocity")
        and isinstance(node.arguments[0], Name)
        and isinstance(node.stage, int)
    }


def _bodies(angle: object) -> set[str]:
    return {body for body, _ in _moving(angle)} if isinstance(angle, Quantity) else set()


def _stages(angle: Quantity) -> set[int]:
    return {stage for _, stage in _moving(angle)} or {0}


def _tangent(scene: Scene, angle: Expression) -> int | None:
    """The line in force that gives the tangent of an angle, or of its letter."""
    tree = Apply("tan", angle)
    for line in reversed(scene.desk.lines):
        if isinstance(line.relation, Meaning) or len(line.relation.options) != 1:
            continue
        first = line.relation.only[0]
        if scene.desk.holds(line.number) and first.left == tree and first.sign == "=":
            return line.number
    return None


def tangent_by_the_same(scene: Scene, letter: str, line: int) -> int | None:
    """The tangent of an angle, by the line that it is another one."""
    known = _tangent(scene, scene.desk.last_link(line).right)
    if known is None:
        return None
    right = scene.desk.last_link(known).right
    value, put = scene.put(scene.scalar(right))
    steps: list[tuple[Expression, MoveId | None]] = [(right, None)]
    if put:
        worths: dict[Expression, Expression] = {}
        for node in (node for node in walk(right) if isinstance(node, Apply)):
            worths[node] = tree_of(scene.put(scene.scalar(node))[0])
            own = _tangent(scene, node.argument) if isinstance(node.argument, Letter) else None
            put = put if node.function != "tan" or own is None else (own, *put)
        final, between = tree_of(tidy(value)), swept(exchanged(right, worths))
        steps = [(between, None), (final, "rearrange")]
        if between == right:
            steps = [(final, None)]  # values of letters are put in
    relation = chain(Apply("tan", Letter(letter)), *steps)
    premises = scene.judge.needed(Move("put"), (known, line, *put), relation)
    return None if premises is None else scene.desk.write(Move("put"), premises, relation)


def angle_by_the_same(scene: Scene, line: int) -> int | None:
    """The line that an angle is another one, with the value of that; None where it is open."""
    link = scene.desk.last_link(line)
    for own in reversed(scene.desk.lines):
        if own.move.id != "inverse" or not scene.desk.holds(own.number):
            continue
        value = scene.desk.last_link(own.number)
        if value.left == link.right and value.sign == "=":
            relation = chain(link.left, (value.right, None))
            refs = scene.judge.enough(Move("put"), (line, own.number), relation)
            return None if refs is None else scene.desk.write(Move("put"), refs, relation)
    return None


def by_the_first_letter(scene: Scene, line: int) -> tuple[Letter, tuple[Ref, ...]] | None:
    """The letter of the angle that another one is, by the line that has the value of both.

    With it what it rests on. The lines with the second letter are not printed.
    """
    desk = scene.desk
    own, hidden = desk.line(line), [line]
    if own.move.id == "inverse" and (lines := numbers_in(own.premises)):
        hidden.append(lines[0])
    last = desk.line(hidden[-1])
    for ref in numbers_in(last.premises) if last.move.id == "put" else ():
        if desk.line(ref).move.record != "difference":
            continue
        link = desk.last_link(ref)
        if not (isinstance(link.right, Letter) and isinstance(link.left, Letter)):
            continue
        for number in (*hidden, ref):
            desk.lines[number - 1] = replace(desk.line(number), shown="silent")
        rest = own.premises if own == last else (line,)
        return link.right, together((other for other in rest if other != ref), (ref,))
    return None


def _components(scene: Scene, bodies: tuple[str, ...], event: int) -> Iterator[Ref]:
    """What is known of the components of bodies after an event, and of the lines they are along."""
    for fact in scene.facts:
        kind, _, name = fact.partition(" ")
        if (kind == "velocity" and name in bodies) or kind == "wall" or fact == f"axis {event}":
            yield fact
    letters_ = {component.symbol.name for component in scene.model.components.values()}
    worths: dict[str, int] = {}
    for line in scene.desk.lines:
        if not scene.desk.holds(line.number):
            continue
        if isinstance(line.relation, Meaning):
            if line.relation.letter in letters_:
                yield line.number
        elif len(line.relation.options) == 1 and line.move.id != "law":
            left = line.relation.only[0].left
            if isinstance(left, Letter) and left.name in letters_:
                worths[left.name] = line.number  # with the values that are put in last
        elif line.move.record in ("unchanged", "restitution-wall"):
            yield line.number
    yield from worths.values()


__all__ = [
    "angle_by_the_same",
    "by_the_first_letter",
    "tangent_by_the_same",
    "write_same_angle",
]
