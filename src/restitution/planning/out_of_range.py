"""Parts in which the equations give a letter only values that it cannot have."""

from __future__ import annotations

from dataclasses import replace

from restitution.components.letters import protected_letters
from restitution.components.telling import model
from restitution.errors import ImpossibleError
from restitution.explaining.lines.derivation import Ref, Relation, numbers_in
from restitution.expression.tree import Letter, letters
from restitution.planning.axes.by_changes import frame_at
from restitution.planning.routes.order import Solver
from restitution.planning.unfinished import require_followed
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import UNPLANNED, Desk
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.solving.equations.setting import out_of_range
from restitution.solving.equations.solution import Branch, PartSolution, Solution


def write_out_of_range(
    solution: Solution, part: PartSolution, desk: Desk, names: list[str]
) -> Desk | None:
    """The desk with all values that a letter would have, and a note of that for each item.

    None where no item has such a reason, and where there is no plan for these values. Of one
    value of a coefficient the items are written, as far as they do not rest on it.
    """
    branches = part.beyond or (part.branches if len(part.branches) > 1 else ())
    errors = [item.error for item in part.items]
    if not branches or not all(isinstance(error, ImpossibleError) for error in errors):
        return None
    part = replace(part, beyond=branches)
    for name in _letters_out_of_range(part):
        draft = desk.fork()
        try:
            premises = _values(solution, part, draft, name, names[0])
        except UNPLANNED:
            continue
        if premises is not None:
            reason = next(error.because or error.message for error in errors if error is not None)
            for letter in names:
                draft.note(letter, "impossible", reason, premises=premises)
            return draft
    return None


def _letters_out_of_range(part: PartSolution) -> list[str]:
    """The letters that are out of their ranges each time."""

    def wrong(branch: Branch) -> set[str]:
        return {
            name
            for name in branch.values
            if out_of_range(name, branch.sample[name], part.roles.get(name)) is not None
        }

    return sorted(set.intersection(*map(wrong, part.beyond)))


def _values(
    solution: Solution, part: PartSolution, desk: Desk, name: str, item: str
) -> tuple[Ref, ...] | None:
    """The line of the values of a letter, and what excludes them; None where nothing does."""
    problem, protected = solution.problem, protected_letters(part.part)
    models = tuple(
        model(problem, part.part, branch, part.roles, protected, paths=desk.paths)
        for branch in part.beyond
    )
    own = replace(part, branches=part.beyond[:1])
    others = models if len(models) > 1 else ()
    scene = Scene(
        problem, part.part, own, models[0], desk, others, find_frame=frame_at, out_of_range=True
    )
    desk.item = item
    start, splits = len(desk.lines), len(desk.splits)
    Solver(scene).determine([models[0].unknowns.letter(name)])
    require_true(scene.model, desk.lines[start:], desk.lines, desk.facts)
    require_followed(scene, desk.lines[start:])
    if len(desk.splits) > splits:
        line, _ = desk.splits[splits]
        desk.splits = desk.splits[:splits]
    else:
        known = desk.known(Letter(name))
        lines = [] if known is None else numbers_in(known.refs)
        if len(lines) != 1:
            return None
        (line,) = lines
    if desk.line(line).move.id == "reject":
        # What is rejected is impossible as well.
        line = next(
            ref
            for ref in desk.line(line).premises
            if isinstance(ref, int) and _has_options(desk, ref)
        )
    note = desk.new_note(item, "impossible", "")
    relation = desk.relation(line)
    names = {name}.union(*(letters(e.right) for links in relation.options for e in links))
    own_bounds = background(scene, {name})
    for bounds in ((), *((bound,) for bound in own_bounds), own_bounds, background(scene, names)):
        if scene.judge.excludes(replace(note, premises=(line, *bounds))):
            return (line, *bounds)
    return None


def _has_options(desk: Desk, number: int) -> bool:
    """Whether a line has several values of a letter."""
    relation = desk.line(number).relation
    return isinstance(relation, Relation) and len(relation.options) > 1
