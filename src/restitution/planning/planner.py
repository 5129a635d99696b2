"""A solution to its derivation: part by part, item by item."""

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import replace
from functools import partial

from restitution.components.letters import protected_letters
from restitution.components.telling import model
from restitution.errors import MissingError, UnboundedError
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of, staged
from restitution.explaining.data.unused import spare_facts
from restitution.explaining.lines.derivation import Derivation, Line, Meaning, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Number,
    Quantity,
    is_binary,
    letters,
    unsigned,
    walk,
)
from restitution.planning.angles.angles_at_walls import write_angles_at_walls
from restitution.planning.angles.data_angles import with_angles_given
from restitution.planning.axes.by_changes import frame_at, write_axis
from restitution.planning.axes.offsets import given_by_offsets, open_angles, paths_beside
from restitution.planning.axes.open_lines import write_open_lines
from restitution.planning.axes.opposite_impulses import (
    write_impulse_by_its_size,
    write_impulse_of_an_open_line,
    write_opposite_impulse,
)
from restitution.planning.cases import joined
from restitution.planning.clashes import write_clash
from restitution.planning.earlier_cases import recall_case
from restitution.planning.early import Early, above_event, early_items, terms
from restitution.planning.ends_required import (
    require_answer,
    require_form,
    require_found,
    require_letters,
)
from restitution.planning.finishing import finished
from restitution.planning.idle_facts import with_facts_that_agree, write_idle_facts
from restitution.planning.inequalities.forms_of_ranges import (
    is_in_a_form,
    write_form,
    write_forms,
)
from restitution.planning.inequalities.over_offsets import write_by_offset
from restitution.planning.inequalities.ranges import (
    general_answer,
    only_answer,
    relation_of,
    write_range,
)
from restitution.planning.missed_walls import write_missed_wall
from restitution.planning.open_clashes import write_open_clash
from restitution.planning.out_of_range import write_out_of_range
from restitution.planning.routes.back_through_walls import write_back_through_walls
from restitution.planning.routes.before_impulses import write_before_impulses
from restitution.planning.routes.before_slanting_impacts import write_before_slanting_impacts
from restitution.planning.routes.coefficients_given import with_coefficients_given
from restitution.planning.routes.directions_of_others import write_velocities_of_others
from restitution.planning.routes.items import write_item
from restitution.planning.routes.late_facts import write_with_facts
from restitution.planning.routes.order import Solver
from restitution.planning.routes.refusals import note_of, write_refusal
from restitution.planning.routes.shown_above import write_by_a_shown_result
from restitution.planning.shows.kept_letters import write_in_its_letters
from restitution.planning.unfinished import (
    answer_of,
    end_where_standing,
    note_unwritten,
    require_followed,
    write_unfinished,
)
from restitution.planning.unreached import write_unreached
from restitution.planning.writing import place_trees
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import UNPLANNED, Desk, NotPlannedError
from restitution.planning.writing.either_side import as_one, on_one_side, write_other_side
from restitution.planning.writing.given_terms import standing_ties, turn_round
from restitution.planning.writing.scene import Scene
from restitution.problem import (
    Extremum,
    Item,
    Problem,
    Range,
    Show,
    Value,
    trees,
)
from restitution.solving.equations.solution import Answer, ItemResult, PartSolution, Solution


def plan(solution: Solution, route: int = 1, *, partial: bool = False) -> Derivation:
    """The working of a question as a derivation.

    ``route`` chooses among the cheapest ways to what is asked, the best being 1; where there are
    fewer it is the last. Raises NotPlannedError for what is not planned, with the reason. A
    ``partial`` working has everything: where there is no plan equations are solved together in one
    line, and what cannot even be reached so has a note with its answer.
    """
    problem = solution.problem
    desk = Desk(events_of(problem), facts_of(problem), route)
    written: Desk | None = None
    if paths := paths_beside(solution, desk):
        with suppress(*UNPLANNED):
            written = _written(solution, replace(desk, paths=paths), partial=False)
    desk = written or _written(solution, desk, partial)
    whole = finished(problem, desk)
    agreeing = with_facts_that_agree(solution, desk, spare_facts(whole))
    return whole if agreeing is desk else finished(problem, agreeing)


def _written(solution: Solution, desk: Desk, partial: bool) -> Desk:
    """The desk with the lines of all parts."""
    problem = solution.problem
    for part in solution.parts.values():
        try:
            _require_plain(solution)
            desk = _write_part(solution, part, desk, partial)
        except UNPLANNED as error:
            if not partial:
                raise _not_planned(error) from error
            desk = _noted(problem, part, desk)
    return desk


def _not_planned(error: Exception) -> NotPlannedError:
    if isinstance(error, NotPlannedError):
        return error
    return NotPlannedError(f"no line says {error}")


def _noted(problem: Problem, part: PartSolution, desk: Desk) -> Desk:
    """The desk with a note for each item of a part."""
    desk.part = part.part.label
    asked = problem.asked(part.part)
    for index, ((item, now), result) in enumerate(zip(asked, part.items, strict=True), 1):
        claim = answer_of(problem, item, result, now)
        note_unwritten(desk, result, _name(part, index), claim=claim)
    return desk


def _require_plain(solution: Solution) -> None:
    """Refuses what no one would work out line by line: long stories, and data that are tangles."""
    problem = solution.problem
    if len(events_of(problem)) > _MOST_EVENTS:
        raise NotPlannedError("a story of many events")
    if sum(len(part.items) for part in solution.parts.values()) > _MOST_ITEMS:
        raise NotPlannedError("a question of many items")
    for tree in trees(problem):
        nodes = list(walk(tree))
        if len(nodes) > _MOST_NODES or sum(isinstance(e, Apply) for e in nodes) > _MOST_FUNCTIONS:
            raise NotPlannedError("an expression that is too long for a line")
        for node in nodes:
            if isinstance(node, Number) and max(node.value.as_integer_ratio()) > _LARGEST:
                raise NotPlannedError("a number that is too long for a line")
            if is_binary(node, "^") and not _is_plain_power(node):
                raise NotPlannedError("a power that no line would hold")


def _is_plain_power(node: Binary) -> bool:
    exponent = unsigned(node.right)
    return isinstance(exponent, Number) and exponent.value <= _MOST_POWER


def _require_closed(desk: Desk, name: str) -> None:
    """Refuses an item whose answer holds a letter that only the working knows."""
    own = {line.relation.letter for line in desk.lines if isinstance(line.relation, Meaning)}
    for end in desk.ends:
        if end.item != name or end.shown:
            continue  # what is shown of two bodies may be said in the letters of both
        for links in end.answer.options:
            between = {link.left for link in links[1:]}
            if any(own & letters(link.right) for link in links if link.right not in between):
                raise NotPlannedError(f"{end.item} is open")


def _write_part(solution: Solution, part: PartSolution, desk: Desk, partial: bool) -> Desk:
    """The desk with the lines of a part; of a ``partial`` one, as far as there are any."""
    if not part.items:
        return desk
    desk.part, desk.apart = part.part.label, len(part.branches) > 1
    if (above := above_event(solution.problem, part)) is not None:
        return _write_above_event(solution, part, above, desk, partial)
    names = _names(part)
    if (refuted := _without_answers(solution, part, desk, names)) is not None:
        return refuted
    early, ended = _write_early(solution, part, desk)
    whole: tuple[Desk, int] | None = None
    if early is not desk:
        left = [name for name in names if name not in ended]
        with suppress(*UNPLANNED):
            whole = _as_far(solution, part, early, left, partial)
    if whole is None or whole[1]:
        plain = _as_far(solution, part, desk, names, partial)
        whole = plain if whole is None or plain[1] < whole[1] else whole
    own = [end for end in whole[0].ends if end.item in names]
    others = [end for end in whole[0].ends if end.item not in names]
    whole[0].ends = [*others, *sorted(own, key=lambda end: names.index(end.item))]
    return whole[0]


_REFUSING = (
    write_clash,
    write_open_clash,
    write_out_of_range,
    write_unreached,
    write_missed_wall,
    write_idle_facts,
)


def _without_answers(
    solution: Solution, part: PartSolution, desk: Desk, names: list[str]
) -> Desk | None:
    """The desk with why the items of a part have no answers; None for a part with a solution.

    ``names`` are those of the items.
    """
    for write in _REFUSING:
        if (refuted := write(solution, part, desk, names)) is not None:
            return refuted
    if part.branches and not all(isinstance(item.error, MissingError) for item in part.items):
        return None
    for name, item in zip(names, part.items, strict=True):
        if item.error is None:
            raise NotPlannedError("no solution")
        note_of(desk, item, name)
    return desk


def _write_above_event(
    solution: Solution, part: PartSolution, early: Early, desk: Desk, partial: bool
) -> Desk:
    """The desk with the items above an event that cannot happen, and why the others have no end."""
    named = list(zip(_names(part), part.items, strict=True))
    left = replace(part, items=tuple(result for _, result in named if result.error is not None))
    above = [name for name, result in named if result.error is None]
    desk.apart, withheld = len(early.part.branches) > 1, desk.withheld
    desk.withheld = early.late
    desk, _ = _as_far(solution, part, desk, above, partial, early)
    desk.withheld = withheld
    names = [name for name, result in named if result.error is not None]
    if not names:
        return desk  # nothing is asked of what cannot happen
    refused = _without_answers(solution, left, desk, names)
    assert refused is not None
    return refused


def _as_far(
    solution: Solution,
    part: PartSolution,
    desk: Desk,
    names: list[str],
    partial: bool,
    early: Early | None = None,
) -> tuple[Desk, int]:
    """The desk with these items of a part, and how far their ways are from a plan of each."""
    if not names:
        return desk, 0
    statuses = dict.fromkeys(names, _PLANNED)
    in_terms = _in_given_terms(solution, part, desk, dict(statuses))
    if in_terms is not None:
        return in_terms, 0
    if not partial:
        return joined(desk, _drafts(solution, part, desk, statuses, _PLANNED, early=early)), 0
    for least in (_PLANNED, _SOLVED):
        statuses = {name: max(status, least) for name, status in statuses.items()}
        before = None
        while statuses != before:
            # Every solution is written in the way in which the last one could be.
            before = dict(statuses)
            drafts = _drafts(solution, part, desk, statuses, _NOTED, early=early)
            if len(drafts) == 1:
                return drafts[0], sum(statuses.values())
        try:
            return joined(desk, drafts), sum(statuses.values())
        except NotPlannedError:
            continue
    statuses = dict.fromkeys(names, _NOTED)
    drafts = _drafts(solution, part, desk, statuses, _NOTED, early=early)
    return drafts[0], sum(statuses.values())


def _write_early(solution: Solution, part: PartSolution, desk: Desk) -> tuple[Desk, set[str]]:
    """The desk with the items that hold without facts below them, and the names of these items.

    Where the facts say more of an answer, its lines stand, and the item is written once more.
    """
    ended: set[str] = set()
    for early in early_items(solution, part):
        names = [_name(part, index) for index in early.items]
        own = {_name(part, index) for index in early.ended}
        draft = None
        for count in range(len(names), 0, -1):
            statuses = dict.fromkeys(names[:count], _PLANNED)
            withheld = desk.fork()
            withheld.withheld = early.late
            with suppress(*UNPLANNED):
                (draft,) = _drafts(solution, part, withheld, statuses, _PLANNED, early=early)
                break
        if draft is None:
            break
        written = {end.item: end for end in draft.ends if end.item in names}
        draft.early |= {name: end for name, end in written.items() if name not in own}
        draft.ends = [end for end in draft.ends if end.item not in draft.early]
        draft.withheld = frozenset()
        desk, ended = draft, ended | (own & written.keys())
        if len(written) < len(names):
            break
    return desk, ended


def _in_given_terms(
    solution: Solution, part: PartSolution, desk: Desk, statuses: dict[str, int]
) -> Desk | None:
    """The desk with a part whose answers are in letters that the solution has by others.

    None where none is, or where there is no plan in these letters.
    """
    if len(part.branches) != 1 or not (protected_letters(part.part) or desk.ends):
        return None
    try:
        drafts = _drafts(solution, part, desk, statuses, _PLANNED, turned=True)
    except UNPLANNED:
        return None
    return drafts[0] if drafts else None


def _name(part: PartSolution, index: int) -> str:
    """The name of an item: the label of its part, and its number there."""
    return f"{part.part.label or ''}{index}"


def _names(part: PartSolution) -> list[str]:
    """The names of the items of a part."""
    return [_name(part, index) for index, _ in enumerate(part.items, 1)]


def _drafts(
    solution: Solution,
    part: PartSolution,
    desk: Desk,
    statuses: dict[str, int],
    last: int,
    turned: bool = False,
    early: Early | None = None,
) -> list[Desk]:
    """Each solution of a part on a desk of its own, with the items that ``statuses`` names.

    With ``turned`` only those whose letters are turned round to be those of the answers; with
    ``early`` the part is that without the facts below these items.
    """
    problem, own = solution.problem, part.part
    stated = problem
    if early is not None:
        stated, part = early.problem, early.part
    protected = protected_letters(part.part)
    models = [
        model(stated, part.part, branch, part.roles, protected, question=problem, paths=desk.paths)
        for branch in part.branches
    ]
    if turned:
        changed = [
            turn_round(branch_model, protected | standing_ties(desk, branch_model))
            for branch_model in models
        ]
        if not all(changed):
            return []
    drafts = []
    one_side = on_one_side(solution, part, models, desk) if early is None else ()
    models = list(one_side) or as_one(part, models, desk)
    for model_ in models:
        draft = desk.fork()
        own_letters = model_.unknowns
        draft.take_letters({name: own_letters.letter(name) for name in own_letters.roles})
        others = tuple(models) if len(models) > 1 else ()
        scene = Scene(problem, own, part, model_, draft, others, find_frame=frame_at)
        scene.of_offsets = given_by_offsets(scene)
        scene.kept = open_angles(scene)
        scene.free |= scene.kept
        scene.sided, scene.turned = len(one_side), turned
        recall_case(scene)
        _write_items(scene, statuses, last)
        drafts.append(draft)
    return drafts


def _write_items(scene: Scene, statuses: dict[str, int], last: int) -> None:
    """Writes the items of a part, each in its way, or in the next one that goes.

    Raises NotPlannedError where one cannot be written in the ``last`` way.
    """
    problem, part = scene.problem, scene.solution
    # What is given may be put in before the first is written.
    scene.desk.item = next(iter(statuses))
    idle = write_angles_at_walls(scene)
    solver = Solver(scene)
    solver.equations.used |= idle
    solver.resume(scene.desk.waiting)
    _write_axes_asked(scene)
    whole = scene, solver
    for index, ((item, now), result) in enumerate(zip(problem.asked(scene.part), part.items), 1):
        name = _name(part, index)
        if name not in statuses:
            continue
        scene.desk.item = name
        scene, solver = whole
        written = False
        while not written:
            standing, start = solver.mark(), len(scene.desk.lines)
            solver.resort = statuses[name] >= _SOLVED
            try:
                if statuses[name] == _NOTED:
                    write_unfinished(scene, solver, item, result, now, name)
                else:
                    _write_end(scene, solver, item, result, now, name)
                lines = scene.desk.lines
                if not is_in_a_form(scene.desk, name):
                    require_true(scene.model, lines[start:], lines, scene.desk.facts)
                _require_short(lines[start:])
                if solver.resort or scene.turned:
                    require_followed(scene, lines[start:])
                _require_closed(scene.desk, name)
                written = True
                if scene is not whole[0]:
                    scene.desk.forget_components(standing.desk)
            except UNPLANNED:
                solver.back(standing)
                if statuses[name] == _PLANNED and _write_conditional(
                    scene, solver, item, result, now, name
                ):
                    break
                in_its_letters = _in_letters_of(scene, index)
                if in_its_letters is not None:
                    scene, solver = in_its_letters, Solver(in_its_letters)
                    continue
                scene, solver = whole
                if statuses[name] >= last:
                    raise
                statuses[name] += 1
    scene, solver = whole
    end_where_standing(scene.desk, statuses)
    scene.desk.waiting = dict(solver.waiting) if scene.desk.withheld else {}


def _write_conditional(
    scene: Scene, solver: Solver, item: Item | Show, result: ItemResult, now: int, name: str
) -> bool:
    """Writes a value where its condition holds, under that; False for any other item."""
    if not isinstance(item, Value) or result.error is not None or scene.others:
        return False
    (answer, *more) = result.distinct
    return not more and write_form(
        scene,
        solver,
        lambda: _write_end(scene, solver, item, result, now, name),
        answer,
        name,
    )


def _write_axes_asked(scene: Scene) -> None:
    """The normals of slanting walls of the data that are asked: unit vectors are along them."""
    for number, frame in scene.model.frames.items():
        slanting = frame.wall is not None and frame.n.x != 0 and frame.n.y != 0
        if not slanting or f"axis {number}" not in scene.facts:
            continue
        if Quantity("line_of_centres", (), number) in scene.asked_alone:
            with suppress(*UNPLANNED):
                write_axis(scene, number)


def _in_letters_of(scene: Scene, index: int) -> Scene | None:
    """The part in the letters in which one item is asked, where the others are asked in others.

    None where these letters are those of the part anyway.
    """
    wanted = terms(scene.part, index)
    if not wanted or scene.turned or scene.others or scene.desk.withheld:
        return None
    (branch,) = scene.solution.branches
    own = model(
        scene.problem,
        scene.part,
        branch,
        scene.solution.roles,
        frozenset(wanted),
        paths=scene.desk.paths,
    )
    if not turn_round(own, frozenset(wanted)):
        return None
    turned = Scene(
        scene.problem,
        scene.part,
        scene.solution,
        own,
        scene.desk,
        turned=True,
        find_frame=frame_at,
    )
    turned.of_offsets = given_by_offsets(turned)
    return turned


def _require_short(lines: Iterable[Line]) -> None:
    """Refuses a line that is a tangle: none of those that people write comes near to that."""
    for line in lines:
        for tree in () if isinstance(line.relation, Meaning) else line.relation.trees:
            if len(walk(tree)) > _MOST_IN_A_LINE:
                raise NotPlannedError(f"line {line.number} is too long")


def _write_end(
    scene: Scene, solver: Solver, item: Item | Show, result: ItemResult, now: int, name: str
) -> None:
    """The lines of one item and its end, or why it has none."""

    def write() -> None:
        _write_item(scene, solver, item, result, now, name)

    if result.error is None:
        write_velocities_of_others(scene, solver)
        if isinstance(item, Value):
            # An impulse by vectors needs no line of centres, and tells one that is open.
            asked = staged(scene.problem, item.expression, now)
            write_impulse_by_its_size(scene, asked)
            write_opposite_impulse(scene, asked)
            write_impulse_of_an_open_line(scene, asked)
        write_open_lines(scene)
        write_back_through_walls(scene)
        write_before_impulses(scene)
        write_before_slanting_impacts(scene)
        write()
        if scene.sided:
            write_other_side(scene, result, name)
    elif isinstance(result.error, UnboundedError):
        write_unfinished(scene, solver, item, result, now, name)
    else:
        write_refusal(scene, solver, result, write, name)


def _write_item(
    scene: Scene, solver: Solver, item: Item | Show, result: ItemResult, now: int, name: str
) -> None:
    """The lines of one item, and its end."""
    problem = scene.problem
    match item:
        case Show():
            from restitution.planning.shows.forward import write_show

            write = partial(write_show, scene, solver, item, result, now, name)
            if result.holds is True:
                write_in_its_letters(scene, solver, item, write)
            else:  # with no letter that may take its value what fails would not be seen
                write()
        case Range():
            asked = with_angles_given(scene, staged(problem, item.expression, now))
            if item.percentage:
                raise NotPlannedError("a percentage")
            if result.error is not None:
                write_item(scene, solver, asked, name)  # the one value, which cannot be
                return
            relation = relation_of(asked, result)
            if not _write_one_value(scene, solver, asked, relation, name):
                write = partial(_write_range, scene, solver, asked, relation, result, name)
                with_coefficients_given(scene, solver, write)
        case Extremum():
            from restitution.planning.inequalities.extrema import write_extremum

            asked = with_angles_given(scene, staged(problem, item.expression, now))
            over = item.over

            def write_answer(answer: Answer) -> None:
                write_extremum(scene, solver, item.kind, asked, over, answer, answer.value, name)

            if len(result.distinct) > 1:
                write_forms(scene, solver, write_answer, result.distinct, name)
            else:
                whole = partial(write_answer, only_answer(result))
                with_coefficients_given(scene, solver, whole)
        case Value():
            asked = with_angles_given(scene, staged(problem, item.expression, now))
            if not (
                write_with_facts(scene, solver, name)
                or write_by_a_shown_result(scene, solver, asked, name)
            ):
                write_item(scene, solver, asked, name)
            if scene.kept:
                write_by_offset(scene, name)
            if place_trees.serves(asked):
                require_form(scene, result)
            require_found(scene, asked)
            require_answer(scene, result)
            require_letters(scene, result)


def _write_range(
    scene: Scene,
    solver: Solver,
    asked: Expression,
    relation: Relation,
    result: ItemResult,
    name: str,
) -> None:
    """A range, of several forms perhaps under the condition of the one that has letters."""
    answer = general_answer(result)

    def write() -> None:
        write_range(scene, solver, asked, relation, name)

    if answer is None or not write_form(scene, solver, write, answer, name):
        write()


def _write_one_value(
    scene: Scene, solver: Solver, asked: Expression, relation: Relation, name: str
) -> bool:
    """Ends the range of what has one value only by that value; False for any other."""
    if len(relation.options) > 1 or relation.only[0].sign != "=":
        return False
    mark = solver.mark()
    try:
        write_item(scene, solver, asked, name)
        require_found(scene, asked)
    except NotPlannedError:
        solver.back(mark)
        return False
    return True


# The ways in which an item may be written, in this order: by a plan; by a plan in which equations
# that no shape fits are solved in one line; as far as it goes, with a note of the answer.
_PLANNED, _SOLVED, _NOTED = range(3)

# A longer story is no exam question, and every pair of its events would be looked at.
_MOST_EVENTS = 12
_MOST_ITEMS = 40
# Data of exam questions stay far below these.
_MOST_NODES, _MOST_FUNCTIONS, _MOST_POWER, _LARGEST = 60, 6, 6, 10**12
# The longest side of a line in the statements of the tests has 81 nodes.
_MOST_IN_A_LINE = 160
