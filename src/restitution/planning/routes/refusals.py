"""Items without an answer: the lines up to what cannot be, and a note that says why."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.errors import (
    ContradictionError,
    ImpossibleError,
    MissingError,
    RestitutionError,
    StatementError,
    TimeLimitError,
    UnboundedError,
    UnsupportedError,
)
from restitution.explaining.lines.derivation import NoteKind, Ref, numbers_in
from restitution.expression.tree import Letter, letters
from restitution.oracle import Oracle
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import Desk, NotPlannedError
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.problem import Range, Value
from restitution.solving.equations.coefficients import COEFFICIENTS
from restitution.solving.equations.solution import ItemResult
from restitution.solving.story.letters import roles

_KINDS: tuple[tuple[type[RestitutionError], NoteKind], ...] = (
    (MissingError, "missing"),
    (ContradictionError, "contradiction"),
    (UnboundedError, "unbounded"),
    (ImpossibleError, "impossible"),
    (TimeLimitError, "unsolved"),
    (UnsupportedError, "unsolved"),
    (StatementError, "unsolved"),
)


def note_of(desk: Desk, result: ItemResult, name: str, premises: Sequence[Ref] = ()) -> None:
    """Notes that an item has no answer, in the words of the solver.

    ``premises`` are the lines that show it.
    """
    error = result.error
    assert error is not None
    kind: NoteKind = next((kind for own, kind in _KINDS if isinstance(error, own)), "missing")
    reason = error.because or error.message
    if reason.endswith("?"):
        reason = reason.rpartition(";")[0]  # without what may have been meant
    desk.note(name, kind, reason, premises=tuple(premises))


def write_refusal(
    scene: Scene, solver: Solver, result: ItemResult, write: Callable[[], None], name: str
) -> None:
    """Writes what leads to a coefficient that cannot be, where that is why there is no answer.

    ``write`` writes the item as if there were one: of a coefficient that is asked, its value is
    what cannot be.
    """
    desk = scene.desk
    standing = solver.mark()
    empty = isinstance(result.item, Range) and isinstance(result.error, ContradictionError)
    if (empty or isinstance(result.error, ImpossibleError)) and not scene.others:
        try:
            premises = _impossible(scene, solver, result, write)
        except NotPlannedError:
            premises = None
        if premises is not None:
            desk.note(name, "impossible", COEFFICIENTS, premises=_enough(scene, name, premises))
            return
        solver.back(standing)
    note_of(desk, result, name)


def _enough(scene: Scene, name: str, premises: tuple[Ref, ...]) -> tuple[Ref, ...]:
    """A value and the bound that it breaks, with what its letters are where that takes it."""
    note = replace(scene.desk.new_note(name, "impossible", COEFFICIENTS), premises=premises)
    if scene.judge.excludes(note):
        return premises
    lines = [scene.desk.last_link(ref).right for ref in numbers_in(premises)]
    for ref in background(scene, {name for tree in lines for name in letters(tree)}):
        more = replace(note, premises=(*premises, ref))
        if scene.judge.excludes(more):
            return more.premises
    return premises


def _impossible(
    scene: Scene, solver: Solver, result: ItemResult, write: Callable[[], None]
) -> tuple[Ref, ...] | None:
    """What says that a coefficient is what none can be; None where that is not the reason."""
    asked = result.item.expression if isinstance(result.item, Range | Value) else None
    broken = dict(_beyond(scene))
    if isinstance(asked, Letter) and asked.name in broken:
        write()
        end = scene.desk.ends.pop()
        return end.line, broken[asked.name]
    for name, bound in broken.items():
        solver.determine([scene.model.unknowns.letter(name)])
        known = scene.desk.known(Letter(name))
        lines = [] if known is None else numbers_in(known.refs)
        if len(lines) == 1 and len(scene.desk.relation(lines[0]).options) == 1:
            return lines[0], bound
    for number in range(1, scene.events + 1):
        fact = scene.facts.get(f"e {number}")
        if fact is None:
            continue
        value = scene.scalar(fact.relation.only[0].right)
        bound = "" if value.free_symbols else _broken(f"restitution({number})", value, scene)
        if bound:
            return fact.id, bound
    return None


def _beyond(scene: Scene) -> Iterator[tuple[str, str]]:
    """The letters of coefficients that are worked out to what none can be, each with its bound."""
    for symbol, value in scene.model.final.items():
        role = scene.model.unknowns.roles.get(symbol.name)
        if role is None or role.kind != "restitution":
            continue
        bound = _broken(symbol.name, sp.sympify(value, strict=True), scene)
        if bound:
            yield symbol.name, bound


def _broken(name: str, value: sp.Expr, scene: Scene) -> str:
    """The bound that a value breaks for all that its letters may be; nothing if it breaks none."""
    oracle = Oracle(roles(scene.problem))
    if proved_sign(oracle, value - 1) == 1:
        return f"{name} <= 1"
    return f"{name} >= 0" if proved_sign(oracle, value) == -1 else ""
