"""A solution to its derivation: part by part, item by item."""

from __future__ import annotations

import sympy as sp

from restitution.components import model, protected_letters
from restitution.errors import MissingError
from restitution.explaining.derivation import Derivation, Meaning
from restitution.explaining.facts import events_of, facts_of, staged
from restitution.explaining.follower import with_identities, with_ranges, without_spare
from restitution.expression.tree import Apply, Binary, Expression, Negate, Number, letters, walk
from restitution.oracle import Oracle
from restitution.planning import place_trees
from restitution.planning.axes import found_frame
from restitution.planning.cases import joined, without_idle
from restitution.planning.checking import require_true
from restitution.planning.desk import Desk, NotPlannedError
from restitution.planning.either_side import on_one_side, write_other_side
from restitution.planning.extrema import only_answer, write_extremum
from restitution.planning.forms import UnwrittenError
from restitution.planning.gathering import gathered, numbered_anew
from restitution.planning.items import write_item
from restitution.planning.open_lines import write_open_lines
from restitution.planning.order import Solver
from restitution.planning.ranges import relation_of, write_range
from restitution.planning.refusals import note_of, note_unwritten, write_refusal
from restitution.planning.scene import Scene
from restitution.planning.shows import write_show
from restitution.problem import (
    Extremum,
    Range,
    Show,
    Value,
    trees,
)
from restitution.solve.letters import roles
from restitution.solve.solution import ItemResult, PartSolution, Solution


def plan(solution: Solution, route: int = 1, *, partial: bool = False) -> Derivation:
    """The working of a question as a derivation.

    ``route`` chooses among the cheapest ways to what is asked, the best being 1; where there are
    fewer it is the last. Raises NotPlannedError for what is not planned, with the reason; of a
    ``partial`` working an item that is not planned has a note, and the others have their lines.
    """
    problem = solution.problem
    _require_plain(solution)
    desk = Desk(events_of(problem), facts_of(problem), route)
    try:
        for part in solution.parts.values():
            desk = _write_part(solution, part, desk, partial)
    except UnwrittenError as error:
        raise NotPlannedError(f"no line says {error}") from error
    whole = pruned(
        Derivation(
            desk.facts,
            tuple(desk.lines),
            tuple(desk.ends),
            desk.events,
            tuple(desk.cases),
            tuple(dict.fromkeys(desk.others)),
            tuple(desk.notes),
        )
    )
    oracle = Oracle(roles(problem))
    whole = without_idle(whole)
    for mended in (with_ranges, with_identities, without_spare):
        whole = mended(whole, oracle)
    return gathered(whole)


def _require_plain(solution: Solution) -> None:
    """Refuses what no one would work out line by line: long stories, and data that are tangles."""
    problem = solution.problem
    if len(events_of(problem)) > _MOST_EVENTS:
        raise NotPlannedError("a story of many events")
    if sum(len(each.items) for each in solution.parts.values()) > _MOST_ITEMS:
        raise NotPlannedError("a question of many items")
    for tree in trees(problem):
        nodes = list(walk(tree))
        if len(nodes) > _MOST_NODES or sum(isinstance(e, Apply) for e in nodes) > _MOST_FUNCTIONS:
            raise NotPlannedError("an expression that is too long for a line")
        for node in nodes:
            if isinstance(node, Number) and max(node.value.as_integer_ratio()) > _LARGEST:
                raise NotPlannedError("a number that is too long for a line")
            if isinstance(node, Binary) and node.op == "^" and not _is_plain_power(node):
                raise NotPlannedError("a power that no line would hold")


def _is_plain_power(node: Binary) -> bool:
    exponent = node.right.operand if isinstance(node.right, Negate) else node.right
    return isinstance(exponent, Number) and exponent.value <= _MOST_POWER


def _require_closed(desk: Desk, name: str) -> None:
    """Refuses an item whose answer holds a letter that only the working knows."""
    own = {each.relation.letter for each in desk.lines if isinstance(each.relation, Meaning)}
    for each in desk.ends:
        if each.item != name or each.shown:
            continue  # what is shown of two bodies may be said in the letters of both
        for links in each.answer.options:
            if any(own & letters(link.right) for link in links):
                raise NotPlannedError(f"{each.item} is open")


def pruned(derivation: Derivation) -> Derivation:
    """The same working without lines on which no item rests, numbered anew."""
    lines = {each.number: each for each in derivation.lines}
    pending = [each.line for each in derivation.items] + [e.line for e in derivation.cases]
    pending += [line for each in derivation.notes for line in each.lines]
    kept: set[int] = set()
    while pending:
        number = pending.pop()
        if number not in kept:
            kept.add(number)
            pending += [ref for ref in lines[number].premises if isinstance(ref, int)]
    return numbered_anew(derivation, [each for each in derivation.lines if each.number in kept])


def _write_part(solution: Solution, part: PartSolution, desk: Desk, partial: bool) -> Desk:
    """The desk with the lines of a part; of a ``partial`` one, of the items that have a plan."""
    if not part.items:
        return desk
    problem = solution.problem
    desk.part = part.part.label
    if not part.branches or all(isinstance(each.error, MissingError) for each in part.items):
        for index, each in enumerate(part.items, 1):
            if each.error is None:
                raise NotPlannedError("no solution")
            note_of(desk, each, f"{desk.part or ''}{index}")
        return desk
    protected = protected_letters(part.part)
    models = [model(problem, part.part, each, part.roles, protected) for each in part.branches]
    drafts = []
    one_side = on_one_side(solution, part, models, desk)
    models = list(one_side) or models
    for told in models:
        draft = desk.fork()
        others = tuple(models) if len(models) > 1 else ()
        scene = Scene(problem, part.part, part, told, draft, others, find_frame=found_frame)
        _write_items(scene, partial, one_side=len(one_side))
        drafts.append(draft)
    if len(drafts) == 1:
        return drafts[0]
    try:
        return joined(desk, drafts)
    except NotPlannedError:
        if not partial:
            raise
    for index, each in enumerate(part.items, 1):
        note_unwritten(desk, each, f"{desk.part or ''}{index}")
    return desk


def _write_items(scene: Scene, partial: bool, *, one_side: int) -> None:
    solver = Solver(scene)
    problem, part = scene.problem, scene.solution
    label = part.part.label
    for index, ((item, now), result) in enumerate(
        zip(problem.asked(part.part), part.items, strict=True), 1
    ):
        name = f"{label or ''}{index}"
        scene.desk.item = name

        def write(
            item: object = item, result: ItemResult = result, now: int = now, name: str = name
        ) -> None:
            _write_item(scene, solver, item, result, now, name)

        standing, start = solver.mark(), len(scene.desk.lines)
        try:
            if result.error is None:
                write_open_lines(scene)
                write()
                if one_side:
                    write_other_side(scene, result, name, one_side)
            else:
                write_refusal(scene, solver, result, write, name)
            lines = scene.desk.lines
            require_true(scene.model, lines[start:], lines, scene.desk.facts)
            _require_closed(scene.desk, name)
        except (NotPlannedError, UnwrittenError):
            if not partial:
                raise
            solver.back(standing)
            note_unwritten(scene.desk, result, name)


def _write_item(
    scene: Scene, solver: Solver, item: object, result: ItemResult, now: int, name: str
) -> None:
    """The lines of one item, and its end."""
    problem = scene.problem
    match item:
        case Show():
            write_show(scene, solver, item, result, now, name)
        case Range():
            asked = staged(problem, item.expression, now)
            if item.percentage:
                raise NotPlannedError("a percentage")
            write_range(scene, solver, asked, relation_of(asked, result), name)
        case Extremum():
            asked = staged(problem, item.expression, now)
            answer = only_answer(result)
            over = item.over
            write_extremum(scene, solver, item.kind, asked, over, answer, answer.value, name)
        case Value():
            asked = staged(problem, item.expression, now)
            write_item(scene, solver, asked, name)
            if place_trees.serves(asked):
                _require_form(scene, result)
            _require_found(scene, asked)


def _require_found(scene: Scene, asked: Expression) -> None:
    """Refuses an answer with a letter that the solution finds."""
    own = letters(asked)
    found = {each.name for each in scene.model.final if each not in scene.free} - own
    for links in scene.desk.ends[-1].answer.options:
        if any(found & letters(link.right) for link in links):
            raise NotPlannedError(f"an answer with {', '.join(sorted(found))}")


def _require_form(scene: Scene, result: ItemResult) -> None:
    """Refuses a place or a length whose ratios of angles are not those of the answer."""
    end = scene.desk.ends[-1]
    values = {each.value for each in result.answers}
    if len(values) != 1 or len(end.answer.options) != 1 or result.kind != "value":
        return
    (value,) = values
    kinds = {each.function for each in walk(end.answer.only[0].right) if isinstance(each, Apply)}
    if kinds & _NAMES != {type(each).__name__ for each in value.atoms(*_RATIOS)}:
        raise NotPlannedError("an answer in another form")


_RATIOS = (sp.sin, sp.cos, sp.tan)
_NAMES = {"sin", "cos", "tan"}
# A longer story is no exam question, and every pair of its events would be looked at.
_MOST_EVENTS = 12
_MOST_ITEMS = 40
# Data of exam questions stay far below these.
_MOST_NODES, _MOST_FUNCTIONS, _MOST_POWER, _LARGEST = 60, 6, 6, 10**12
