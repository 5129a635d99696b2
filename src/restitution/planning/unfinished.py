"""Items without a plan: what of them can be written, and a note with the answer."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from restitution.explaining.derivation import Line, Link, Meaning, Ref, Relation
from restitution.explaining.facts import links_of, staged
from restitution.expression.tree import Expression, Letter, Quantity, has_quantity, letters, walk
from restitution.planning.checking import require_true
from restitution.planning.desk import Desk, NotPlannedError
from restitution.planning.expressions import write_expression
from restitution.planning.forms import UnwrittenError, tree_of
from restitution.planning.impacts import momentum, rebound, restitution, unchanged
from restitution.planning.items import determine, goals
from restitution.planning.order import Solver
from restitution.planning.ranges import relation_of
from restitution.planning.refusals import note_of
from restitution.planning.roots import written_law
from restitution.planning.scene import Scene
from restitution.problem import Item, Problem, Range, Show, Value, trees_of_relation
from restitution.solve.solution import ItemResult


def write_unfinished(
    scene: Scene, solver: Solver, item: Item | Show, result: ItemResult, now: int, name: str
) -> None:
    """Writes what an item speaks of, as far as there is a plan, and notes its answer."""
    trees = [staged(scene.problem, each, now) for each in _trees(item)]
    premises: tuple[int, ...] = ()
    # Of several solutions only the principles are the same.
    for write in (_laws,) if scene.others else (_values, _components, _laws):
        standing, start = solver.mark(), len(scene.desk.lines)
        try:
            premises = tuple(dict.fromkeys(write(scene, solver, trees)))
            lines = scene.desk.lines
            require_true(scene.model, lines[start:], lines, scene.desk.facts)
            require_followed(scene, lines[start:])
        except (NotPlannedError, UnwrittenError):
            premises = ()
        if premises:
            break
        solver.back(standing)
    claim = answer_of(scene.problem, item, result, now)
    note_unwritten(scene.desk, result, name, premises, claim)


def require_followed(scene: Scene, lines: Iterable[Line]) -> None:
    """Raises NotPlannedError for a line that does not follow by its move."""
    for each in lines:
        if isinstance(each.relation, Meaning):
            continue
        if not scene.judge.follows(each.move, each.premises, each.relation):
            raise NotPlannedError(f"line {each.number} does not follow")


def note_unwritten(
    desk: Desk,
    result: ItemResult,
    name: str,
    premises: Sequence[int] = (),
    claim: Relation | None = None,
) -> None:
    """Notes that the way to an item is not written out: its answer, or why it has none.

    ``premises`` are the lines from which the way would go on; ``claim`` is the answer as lines say
    it, where they can.
    """
    if result.error is not None:
        note_of(desk, result, name)
        return
    outcome = {True: "shown", False: "not true", None: "not decided"}[result.holds]
    answers = " or ".join(each.display for each in result.distinct)
    reason = outcome if result.kind == "show" else answers
    desk.note(name, "unwritten", reason, premises=tuple(premises), claim=claim)


def answer_of(problem: Problem, item: Item | Show, result: ItemResult, now: int) -> Relation | None:
    """The answer of an item as a relation; None where no line could say it."""
    if any(each.condition for each in result.distinct):
        return None
    try:
        match item:
            case Show(relation, None) if result.holds:
                links = links_of(problem, relation, now)
                return Relation((links,)) if links else None
            case Range(expression):
                return relation_of(staged(problem, expression, now), result)
            case Value(expression):
                asked = staged(problem, expression, now)
                trees = [tree_of(each.value, angle=each.angle) for each in result.distinct]
                return Relation(tuple((Link(asked, "=", each),) for each in trees))
    except (NotPlannedError, UnwrittenError):
        pass
    return None


def _trees(item: Item | Show) -> Iterator[Expression]:
    """What an item speaks of."""
    if not isinstance(item, Show):
        yield item.expression
        return
    yield from trees_of_relation(item.relation)
    if item.subject is not None:
        yield item.subject.expression


def _values(scene: Scene, solver: Solver, trees: Sequence[Expression]) -> Iterator[int]:
    """The lines that say what the expressions come to."""
    for tree in trees:
        if has_quantity(tree):
            determine(scene, solver, tree)
            yield write_expression(scene, tree)[0]
        else:
            yield from _found(scene, solver, tree)


def _components(scene: Scene, solver: Solver, trees: Sequence[Expression]) -> Iterator[int]:
    """The lines that say what everything is of which the quantities are made."""
    for tree in trees:
        yield from _found(scene, solver, tree)
        for each in walk(tree):
            if isinstance(each, Quantity):
                own = goals(scene, each)
                solver.determine(own)
                for goal in own:
                    yield from _lines(scene, scene.put(goal)[1])


def _found(scene: Scene, solver: Solver, tree: Expression) -> Iterator[int]:
    """The lines that say what letters are that are worked out."""
    for name in sorted(letters(tree)):
        symbol = scene.model.unknowns.letter(name)
        if symbol in scene.model.final:
            solver.determine([symbol])
            known = scene.desk.known(Letter(name))
            yield from () if known is None else _lines(scene, known.refs)


def _lines(scene: Scene, refs: Sequence[Ref]) -> Iterator[int]:
    for each in refs:
        if isinstance(each, int) and not isinstance(scene.desk.line(each).relation, Meaning):
            yield each


def _laws(scene: Scene, solver: Solver, trees: Sequence[Expression]) -> Iterator[int]:
    """The principles of each impact."""
    del solver, trees
    for number, own in sorted(scene.model.frames.items()):
        frame = scene.frame(number)
        if own.wall is None:
            for record, write in (("momentum", momentum), ("restitution", restitution)):
                yield written_law(scene, record, number) or write(scene, frame)
        else:
            for body in scene.spheres(number):
                yield from _lines(scene, unchanged(scene, body, frame).refs)
                yield from _lines(scene, rebound(scene, body, frame).refs)


__all__ = ["note_unwritten", "require_followed", "write_unfinished"]
