"""Problem → Solution: every part in turn, every item with its answers."""

from __future__ import annotations

from collections.abc import Iterator

from restitution import work
from restitution.errors import TimeLimitError, require
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.language.checking import check
from restitution.problem import Compare, Find, Given, Part, Problem, Relation, Show
from restitution.solving.asked_letters import in_asked_letters
from restitution.solving.equations.part import Desk
from restitution.solving.equations.solution import PartSolution, Solution
from restitution.solving.obtuse import with_hints
from restitution.solving.open_directions import with_open_directions
from restitution.solving.out_of_order import events_out_of_order
from restitution.solving.passed import walls_passed
from restitution.solving.printed_terms import in_printed_terms, refused
from restitution.solving.signed_components import with_note_of_signs
from restitution.solving.story.unsaid import with_unsaid
from restitution.solving.worker import Worker, asks


def solve(problem: Problem, time_limit: float | None = None) -> Solution:
    """Solves every part of a problem, within ``time_limit`` seconds (None or 0 is no limit).

    What cannot be answered carries its own error in the result, so that one item takes no other
    with it. Where the time runs out, items already solved are kept, and the others carry a
    TimeLimitError; the limit holds in any thread. Raises StatementError for a problem that makes no
    sense (a body that is not there, a number where a vector is needed), as reading its text would
    have done, and ValueError for a negative limit.
    """
    require(problem, Problem, "solve")
    time_limit = work.seconds_of(time_limit)
    check(problem)
    limit = None if time_limit is None else f"no answer within the time limit of {time_limit:g} s"
    error = None if limit is None else TimeLimitError(limit)
    with work.limited(time_limit, error=error) as spent:
        solution = _without_open_directions(problem) or _solved(with_unsaid(problem))
        other = in_printed_terms(solution)
        again = None if other is None else _solved(other)
        if again is not None and refused(again) < refused(solution):
            solution = again
        return with_note_of_signs(with_hints(solution, _solved, spent.used), _solved)


def _without_open_directions(problem: Problem) -> Solution | None:
    """The solution without letters for directions that are found; None where it lacks an answer."""
    open_ = with_open_directions(problem)
    solution = None if open_ is None else _solved(with_unsaid(open_))
    return solution if solution is not None and not refused(solution) else None


def _solved(problem: Problem) -> Solution:
    parts: dict[str | None, PartSolution] = {}
    warnings = list(problem.warnings)
    carried: frozenset[str] = frozenset()
    relations: dict[str, Part] = {}
    asking = [part for part in problem.parts if asks(part)]
    if not asking:
        warnings.append("nothing is asked: a line such as 'find velocity(A)' would ask for it")
    # The motion alone is solved too, to be drawn.
    for part in asking or problem.parts[-1:]:
        worker = Worker(Desk(problem, part, carried))
        parts[part.label] = in_asked_letters(problem, worker.solve(), _solved)
        warnings += [warning for warning in worker.warnings if warning not in warnings]
        warnings += walls_passed(problem, parts[part.label])
        late = events_out_of_order(problem, parts[part.label])
        warnings += [warning for warning in late if warning not in warnings]
        met = _met_again(parts[part.label], relations)
        warnings += met.values()
        # A letter is met again once; later parts take it as this one does.
        relations = {letter: earlier for letter, earlier in relations.items() if letter not in met}
        relations |= _under_own_facts(parts[part.label])
        carried = carried | worker.asked_of_all()
    return Solution(problem, parts, tuple(warnings))


def _under_own_facts(part: PartSolution) -> dict[str, Part]:
    """The letters found from the facts of a part alone, each with the part.

    One whose value is itself such a fact, as in ``given k = 3``, is not found.
    """
    relations = _facts(part.part)
    if part.part.label is None or not relations:
        return {}
    data = {name for relation in relations for name in _letters_with_values(relation)}
    claims = all(isinstance(item.item, Show) for item in part.items)
    return {
        name: part.part
        for name in _solved_letters(part)
        if name not in data and not (claims and _is_in_letters(part, name))
    }


def _is_in_letters(part: PartSolution, name: str) -> bool:
    """Whether a letter has a value in other letters: a claim about it shows a relation only."""
    values = (branch.values.get(name) for branch in part.branches)
    return any(value is not None and value.free_symbols for value in values)


def _facts(part: Part) -> set[Relation]:
    """What is given in a part alone."""
    steps = (step for step in part.steps if isinstance(step, Given))
    return {relation for step in steps for relation in step.relations}


def _letters_with_values(relation: Relation) -> Iterator[str]:
    """The letters for which a relation itself gives a value, as ``e = 1/2`` does."""
    if not isinstance(relation, Compare) or set(relation.operators) != {"="}:
        return
    operands = relation.operands
    if any(not has_quantity(operand) and not letters(operand) for operand in operands):
        yield from (operand.name for operand in operands if isinstance(operand, Letter))


def _solved_letters(part: PartSolution) -> list[str]:
    names = dict.fromkeys(name for branch in part.branches for name in branch.values)
    return [name for name in names if not name.startswith("_")]


def _met_again(part: PartSolution, relations: dict[str, Part]) -> dict[str, str]:
    """Notes of the letters in the answers of a part that had a value in an earlier one only.

    A part in which the facts of the earlier one are given again has its relation too; one that is
    asked in terms of a letter, or a claim that names it, says itself that it has it.
    """
    given = _facts(part.part)
    steps = (step for step in part.part.steps if isinstance(step, Find | Show))
    named = {name for step in steps for name in step.in_terms_of or ()}
    met = {name for item in part.items for answer in item.answers for name in answer.letters}
    return {
        letter: f"{letter} was found in part ({relations[letter].label}) from what is given in "
        f"that part alone; {_in_terms_of(part.part.label)} {letter}"
        for letter in sorted(met & relations.keys() - {*named, *_solved_letters(part)})
        if not _facts(relations[letter]) <= given
    }


def _in_terms_of(part: str | None) -> str:
    return f"part ({part}) is in terms of"


def is_in_terms(note: str, part: str) -> bool:
    """Whether a note says that a part has a letter which an earlier part found for itself alone."""
    return f"; {_in_terms_of(part)} " in note
