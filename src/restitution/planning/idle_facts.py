"""Facts that hold anyway: the quantities in them are worked out.

A fact may leave the letters open for which it was given, or be given beside what fixes all of them.
"""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import replace

from restitution.components.letters import protected_letters
from restitution.components.telling import model
from restitution.errors import MissingError, RestitutionError
from restitution.explaining.lines.derivation import Fact, Note, NoteKind, Ref
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Letter, has_quantity, letters
from restitution.planning.axes.by_changes import frame_at
from restitution.planning.clashes import write_worths
from restitution.planning.routes.order import Solver
from restitution.planning.unfinished import require_followed
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import UNPLANNED, Desk, together
from restitution.planning.writing.scene import Scene
from restitution.problem import Value
from restitution.solving.equations.solution import PartSolution, Solution


def write_idle_facts(
    solution: Solution, part: PartSolution, desk: Desk, names: list[str]
) -> Desk | None:
    """The desk with the lines by which a fact holds anyway, and a note of that for each item.

    None where the items are no letters that are open, and where no fact of them holds anyway.
    """
    errors = [item.error for item in part.items]
    if len(part.branches) != 1 or not all(isinstance(error, MissingError) for error in errors):
        return None
    open_ = _letters_asked(part) - part.branches[0].values.keys()
    if not open_ or len(open_) < len(names):
        return None
    reason = next(error.because or error.message for error in errors if error is not None)
    problem, own = solution.problem, part.part
    story = model(
        problem,
        own,
        part.branches[0],
        part.roles,
        protected_letters(own),
        question=problem,
        paths=desk.paths,
    )
    for given in Scene(problem, own, part, story, desk, find_frame=frame_at).given:
        sides = (given.link.left, given.link.right)
        if given.link.sign != "=" or not open_ & letters(sides[1]) | letters(sides[0]):
            continue
        draft = desk.fork()
        scene = Scene(problem, own, part, story, draft, find_frame=frame_at)
        try:
            note = _holding_anyway(scene, given.fact, names[0], "missing", reason)
        except (*UNPLANNED, RestitutionError):
            continue
        if note is not None:
            for name in names:
                draft.note(name, note.kind, note.reason, premises=note.premises)
            return draft
    return None


def _letters_asked(part: PartSolution) -> set[str]:
    """The letters that the items of a part ask for by themselves."""
    return {
        item.item.expression.name
        for item in part.items
        if isinstance(item.item, Value) and isinstance(item.item.expression, Letter)
    }


def with_facts_that_agree(solution: Solution, desk: Desk, spare: Iterable[Fact]) -> Desk:
    """The desk with the lines by which given facts that no answer needs are seen to hold.

    ``spare`` are these facts; one without a plan has no lines.
    """
    problem = solution.problem
    parts = [part for part in solution.parts.values() if part.items]
    for fact in spare:
        part = next((e for e in parts if e.part.label == fact.part), parts[-1])
        if len(part.branches) != 1:
            continue
        protected = protected_letters(part.part)
        story = model(
            problem,
            part.part,
            part.branches[0],
            part.roles,
            protected,
            question=problem,
            paths=desk.paths,
        )
        name = f"{part.part.label or ''}{len(part.items)}"
        draft = desk.fork()
        draft.part = part.part.label
        scene = Scene(problem, part.part, part, story, draft, find_frame=frame_at)
        if not _is_compared(fact):
            continue
        with suppress(*UNPLANNED, RestitutionError):
            note = _holding_anyway(scene, fact, name, "agreeing")
            if note is not None:
                order = [end.item for end in draft.ends]
                draft.notes.append(replace(note, place=order.index(name)))
                desk = draft
    return desk


def _holding_anyway(
    scene: Scene, fact: Fact, name: str, kind: NoteKind, reason: str = ""
) -> Note | None:
    """The lines of the quantity in a fact, where they agree with it; None where they do not."""
    desk = scene.desk
    desk.item, desk.withheld = name, frozenset({fact.id})
    start = len(desk.lines)
    refs: tuple[Ref, ...] = together(write_worths(scene, Solver(scene), fact.relation))
    desk.withheld = frozenset()
    if not any(isinstance(ref, int) for ref in refs):
        return None
    require_true(scene.model, desk.lines[start:], desk.lines, desk.facts)
    require_followed(scene, desk.lines[start:])
    note = desk.new_note(name, kind, reason, premises=(*refs, fact.id))
    return note if scene.judge.holds_anyway(note) else None


def _is_compared(fact: Fact) -> bool:
    """Whether a fact compares quantities: others tell a direction, or what happens."""
    links = [link for links in fact.relation.options for link in links]
    return (
        len(links) == 1
        and links[0].sign in ("=", "<", "<=", ">", ">=")
        and any(map(has_quantity, trees_of(fact.relation)))
    )


__all__ = ["with_facts_that_agree", "write_idle_facts"]
