"""All that a page shows of one solved problem, as plain data: see `Pieces`.

Mathematics and words are trees, as `restitution.render.markup` describes them. One solve serves all
pieces, and a piece that cannot be made leaves the others as they are.
"""

from __future__ import annotations

import time
import traceback
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any, TypeVar

from restitution.drawing import figure
from restitution.drawing.svg import to_svg
from restitution.errors import RestitutionError, TimeLimitError
from restitution.export.answers import condition_of, is_equal, layout_of
from restitution.export.pictures import chosen
from restitution.export.player.data import is_hurried, of_solution
from restitution.export.units import Units
from restitution.records import dataclass
from restitution.render.document.cells import inline, rows
from restitution.render.document.html import to_tree
from restitution.render.markup import Tree, together
from restitution.render.mathml import mathematics
from restitution.wording import asked, question
from restitution.wording.document import document_of
from restitution.work import limited
from restitution.workings import explain, to_latex
from restitution.workings.naming.instances import instances
from restitution.workings.rendering.document import chain
from restitution.workings.rendering.explanation import Explanation
from restitution.workings.rendering.principles import about
from restitution.workings.rendering.steps import Row, Step

if TYPE_CHECKING:
    from restitution.drawing.scene import Scene
    from restitution.export.objects import (
        AnswersContent,
        ExplainedObject,
        PartContent,
        PictureObject,
        PicturesObject,
        RowContent,
        SolvedObject,
        StepContent,
    )
    from restitution.expression.tree import Expression
    from restitution.solving.equations.solution import (
        Answer,
        ItemResult,
        PartSolution,
        Rejected,
        Solution,
    )

_T = TypeVar("_T")

# Shares of the time for all pieces that each may take of what is left.
_PICTURES = 0.5
_WORKING = 0.6
_EXACT = 0.5
_OVER = "there was no time left for it"


@dataclass(frozen=True)
class Pieces:
    """The pieces of a page; without any, those of a problem that could not be solved.

    `beside` has them as an object of JSON. A row is a ``tr``, or a list of several where the line
    is long.
    """

    question: Tree | None = None
    pictures: Sequence[PictureObject] = ()
    pictures_error: str | None = None
    figure: PictureObject | None = None
    working: Sequence[PartContent] = ()
    working_error: str | None = None
    latex: str | None = None
    motion: dict[str, Any] | None = None
    motion_error: str | None = None
    warnings: Sequence[str] = ()

    def beside(self, answer: SolvedObject) -> ExplainedObject:
        """The pieces beside the answers, as an object of JSON."""
        return {
            "answer": answer,
            "question": self.question,
            "pictures": list(self.pictures),
            "pictures_error": self.pictures_error,
            "figure": self.figure,
            "working": list(self.working),
            "working_error": self.working_error,
            "latex": self.latex,
            "motion": self.motion,
            "motion_error": self.motion_error,
            "warnings": list(self.warnings),
        }


@dataclass(frozen=True)
class Shown:
    """The pieces; whether one was broken off; and the tracebacks of failures of the program.

    ``left_out`` says, in the warnings too, of which there is less for lack of time and no error.
    """

    pieces: Pieces
    tired: bool
    fault: str
    left_out: Sequence[str] = ()


def shown(
    solution: Solution,
    seconds: float | None = None,
    early: Callable[[Pieces], None] = lambda _: None,
) -> Shown:
    """The pieces of a page, made within so many ``seconds`` (None is no limit).

    ``early`` is given those that come before the working: question, answers, pictures.
    """
    clock = _Clock(seconds)
    worded = clock.spare("question", lambda: to_tree(document_of(question(solution.problem))))
    names = clock.spare("wording of the items", lambda: _names(solution))
    pictures, undrawn = clock.piece("pictures", _PICTURES, lambda: pictured(solution))
    figured, _ = clock.piece("figure", _PICTURES, lambda: _figure(solution))
    unworked = _without_steps(solution, names or {})
    first = Pieces(
        worded,
        () if pictures is None else pictures["pictures"],
        undrawn if pictures is None else pictures["pictures_error"],
        figured,
        unworked,
    )
    early(first)
    explanation, unexplained = clock.piece("working", _WORKING, lambda: explain(solution))
    shown_parts: list[PartContent] | None = None
    latex: str | None = None
    if explanation is not None:
        shown_parts, unshown = clock.piece(
            "working", 1.0, lambda: _worked(solution, explanation, names or {})
        )
        unexplained = unexplained or unshown
        latex = clock.spare("LaTeX", lambda: to_latex(explanation))
        lettered = clock.spare(
            "lettering of the pictures",
            lambda: pictured(solution, letters=explanation.letters),
        )
        if lettered is not None and lettered["pictures"]:
            pictures = lettered
    motion, unmoved = clock.piece(
        "motion", 1.0, lambda: of_solution(solution, seconds=clock.share(_EXACT))
    )
    tired = clock.tired or (motion is not None and is_hurried(motion))
    warnings = solution.warnings if explanation is None else explanation.warnings
    pieces = replace(
        first,
        pictures=first.pictures if pictures is None else pictures["pictures"],
        working=unworked if shown_parts is None else shown_parts,
        working_error=unexplained,
        latex=latex,
        motion=motion,
        motion_error=unmoved,
        warnings=list(dict.fromkeys([*warnings, *clock.left_out])),
    )
    return Shown(pieces, tired, "\n".join(clock.faults), clock.left_out)


class _Clock:
    """What is left of the time, and what became of each piece."""

    def __init__(self, seconds: float | None) -> None:
        self.tired = False
        self.faults: list[str] = []
        self.left_out: list[str] = []
        self._end = None if seconds is None else time.monotonic() + seconds

    def share(self, part: float) -> float | None:
        """Part of what is left, in seconds."""
        return None if self._end is None else max(self._end - time.monotonic(), 0.0) * part

    def piece(self, name: str, part: float, make: Callable[[], _T]) -> tuple[_T | None, str | None]:
        """A piece, made in its part of the time left; and the reason why it, or some of it, is not.

        What makes it may have given up only some of it when the time was over, and gone on.
        """
        limit = self.share(part)
        out_of_time = TimeLimitError(_OVER)
        if limit is not None and limit <= 0.01:
            self.tired = True
            return None, out_of_time.message
        try:
            with limited(limit, error=out_of_time) as own:
                piece = make()
        except RestitutionError as error:
            self.tired = self.tired or error.kind == TimeLimitError.kind
            return None, error.message
        except Exception:  # noqa: BLE001 - the other pieces are right without it
            self.faults.append(traceback.format_exc())
            return None, "it could not be made, by a fault of the program"
        if own.broken:
            self.tired = True
            self.left_out.append(f"something of the {name} is left out: there was no time for it")
            return piece, "there was no time left for all of it"
        return piece, None

    def spare(self, name: str, make: Callable[[], _T]) -> _T | None:
        """A piece that a page can do without, in all the time left."""
        piece, reason = self.piece(name, 1.0, make)
        if piece is None and reason == _OVER:
            self.left_out.append(f"the {name} is left out: there was no time for it")
        return piece


def pictured(
    solution: Solution,
    event: int | None = None,
    letters: Mapping[Expression, str] | None = None,
) -> PicturesObject:
    """The pictures of a solved problem, or that of one event, or the reason why there is none.

    ``letters`` are those of the working, if it is known.
    """
    try:
        scenes = chosen(solution, event, letters)
        return {"pictures": [_picture(scene) for scene in scenes], "pictures_error": None}
    except RestitutionError as error:
        return {"pictures": [], "pictures_error": error.message}


def _figure(solution: Solution) -> PictureObject | None:
    """What the question tells, and nothing of its answers."""
    scene = figure(solution)
    return None if scene is None else _picture(scene)


def _picture(scene: Scene) -> PictureObject:
    """One picture."""
    return {
        "event": scene.event,
        "title": scene.title,
        "description": scene.description,
        "svg": to_svg(scene),
    }


# What each item asks, in words; one that has none is shown as it was typed.
_Names = Mapping[tuple[str | None, int], Tree]


def _names(solution: Solution) -> _Names:
    """What each item asks, in words, by part and number; nothing for those that have none."""
    return {
        (label, number): together(inline(name))
        for label, names in asked(solution.problem).items()
        for number, name in enumerate(names)
    }


def _worked(solution: Solution, explanation: Explanation, names: _Names) -> list[PartContent]:
    """The worked solution part by part, each line by itself."""
    units = Units(solution)
    return [
        {
            "label": part.label,
            "marks": part.marks,
            "asked": list(part.asked),
            "answers": _answers(solution.parts[part.label], names, units),
            "steps": [_step(step) for step in part.steps],
        }
        for part in explanation.parts
    ]


def _without_steps(solution: Solution, names: _Names) -> list[PartContent]:
    units = Units(solution)
    return [
        {
            "label": label,
            "marks": 0,
            "asked": [item.text for item in part.items],
            "answers": _answers(part, names, units),
            "steps": [],
        }
        for label, part in solution.parts.items()
    ]


def _answers(part: PartSolution, names: _Names, units: Units) -> list[AnswersContent]:
    return [
        {
            "item": names.get((part.part.label, number), ["code", {}, item.text]),
            "values": [_value(item, answer) for answer in item.distinct],
            "unit": units.of(item) or None,
            "equal": is_equal(item),
            "holds": item.holds,
            "undecided": item.undecided,
            "counterexample": None
            if item.counterexample is None
            else [mathematics(instance) for instance in instances(item.counterexample)],
            "error": None if item.error is None else item.error.message,
            "rejected": [
                {"value": _value(item, root), "reason": root.reason} for root in item.rejected
            ],
        }
        for number, item in enumerate(part.items)
    ]


def _value(item: ItemResult, answer: Answer | Rejected) -> Tree:
    layout, condition = layout_of(item, answer), condition_of(answer)
    if layout is None:
        return answer.display
    value = mathematics(layout)
    if condition is None:
        return value
    # The words stand outside the mathematics, so that a line may end between them.
    pieces = (word if isinstance(word, str) else mathematics(word) for word in condition)
    return ["span", {}, value, ["span", {"class": "condition"}, ", for\u00a0", *pieces]]


def _step(step: Step) -> StepContent:
    return {
        "kind": step.kind,
        "principle": step.principle,
        "sign": step.sign,
        "about": about(step),
        "said": together(inline(step.words)) if step.words else None,
        "mark": step.mark,
        "event": step.event,
        "item": step.item,
        "rows": [_row(row) for row in step.rows],
    }


def _row(row: Row) -> RowContent:
    lines = rows(chain(row))
    return {"row": lines[0] if len(lines) == 1 else lines, "mark": row.mark}
