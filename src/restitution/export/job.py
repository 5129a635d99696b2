"""Solving one problem and writing it down, as work for a process of its own.

What goes in and what comes out are plain values, so that the one who asks needs no algebra.
"""

from __future__ import annotations

import gc
import traceback
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from restitution.errors import RestitutionError, TimeLimitError
from restitution.problem import Problem

if TYPE_CHECKING:
    from restitution.solve.solution import Solution

Format = Literal["text", "markdown", "latex", "html", "json"]

# Shares of the time limit: what is solved by then is kept, and what is left is given up piece
# by piece, so that there is time to write down the rest.
_FIRST = 0.6
_AGAIN = 0.08
_WRITING = 0.3


@dataclass(frozen=True)
class Job:
    """A problem, what is wanted of it, and how: ``limit`` in seconds, ``width`` in characters.

    ``part`` is the label of the one part wanted, or None for all; ``styled`` is text with bold type
    for a terminal.
    """

    file: str
    problem: Problem
    form: Format = "text"
    part: str | None = None
    answers_only: bool = False
    width: int = 80
    limit: float | None = None
    styled: bool = False


@dataclass(frozen=True)
class Reply:
    """What was written, whether everything asked has an answer, and why an item has none.

    ``fault`` is the traceback of a failure of the program while it wrote the working; ``tired``
    tells that a piece of work was broken off, and that the process should end.
    """

    text: str
    answered: bool
    errors: tuple[RestitutionError, ...] = ()
    warnings: tuple[str, ...] = ()
    fault: str = ""
    tired: bool = False


def prepare() -> None:
    """Load what the work needs."""
    import restitution.explain
    import restitution.export.answers
    import restitution.solve  # noqa: F401

    # What was loaded stays: no need to look through it again for garbage.
    gc.freeze()


def stopped(limit: float | None) -> TimeLimitError:
    """The error of a solve that took too long."""
    return TimeLimitError(f"no answer within the time limit of {limit or 0:g} s")


def serve(job: Job) -> Reply:
    """Solve and write down. Raises RestitutionError where nothing at all can be said."""
    from restitution.export import contract
    from restitution.killable import soft_limit
    from restitution.solve import solve

    first = None if job.limit is None else job.limit * _FIRST
    with soft_limit(first, (job.limit or 0) * _AGAIN, stopped(job.limit)):
        solution = solve(job.problem)
    content = contract.solved(job.file, solution, job.part)
    errors = _errors(solution, job.part)
    tired = any(error.kind == TimeLimitError.kind for error in errors)
    answered = contract.all_answered(content)
    if job.form == "json":
        return Reply(contract.to_json(content) + "\n", answered, tired=tired)
    text, note, fault = _written(solution, job)
    return Reply(
        text if text.endswith("\n") else text + "\n",
        answered and not fault,
        errors,
        (*content["warnings"], *note),
        fault,
        tired or bool(note or fault),
    )


def _errors(solution: Solution, label: str | None) -> tuple[RestitutionError, ...]:
    found = [solution.error]
    for part, item in solution.items():
        if label is None or part.part.label == label:
            found.append(item.error)
    unique = {str(error): error for error in found if error is not None}
    return tuple(unique.values())


def _written(solution: Solution, job: Job) -> tuple[str, tuple[str, ...], str]:
    """The working, or the answers alone; why not the working; and the traceback of a fault."""
    from restitution.export.answers import answers
    from restitution.killable import soft_limit

    assert job.form != "json"
    note: tuple[str, ...] = ()
    fault = ""
    if not job.answers_only:
        limit = None if job.limit is None else job.limit * _WRITING
        try:
            with soft_limit(limit, limit or 0, stopped(job.limit)):
                return _working(solution, job), (), ""
        except RestitutionError as error:
            note = (f"here are the answers without their working: {error.message}",)
        except Exception:  # noqa: BLE001 - whatever it is, the answers stand
            # The answers are right without their working: they are given, and the fault told.
            fault = traceback.format_exc()
    return answers(solution, job.form, job.part), note, fault


def _working(solution: Solution, job: Job) -> str:
    from restitution.explain import explain, to_html, to_latex, to_markdown, to_text

    explanation = explain(solution, job.part)
    match job.form:
        case "markdown":
            return to_markdown(explanation)
        case "latex":
            return to_latex(explanation)
        case "html":
            return to_html(explanation)
        case _:
            return to_text(explanation, job.width, job.styled)
