"""Solving one problem and writing it down, as work for a process of its own.

What goes in and what comes out are plain values, so that the one who asks needs no algebra.
"""

from __future__ import annotations

import gc
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from importlib import import_module
from typing import TYPE_CHECKING, Any, Literal, TypeAlias

from restitution.errors import RestitutionError, StatementError, TimeLimitError
from restitution.export.algebra import without_tensors
from restitution.expression.tree import Binary, Name, Number, Quantity
from restitution.garbage import collect_seldom
from restitution.problem import Find, Impact, Part, Problem, Sphere, Value, Wall
from restitution.records import compile_what_is_used, dataclass
from restitution.work import confirm, limited

if TYPE_CHECKING:
    from restitution.explaining.lines.marks import Style
    from restitution.export.marking import Workings
    from restitution.export.objects import (
        DrawnObject,
        ExplainedObject,
        SolvedObject,
        WorkedObject,
    )
    from restitution.export.sheet import Options
    from restitution.export.trace import Stage
    from restitution.solving.equations.solution import Solution
    from restitution.workings.rendering.explanation import Explanation

Format = Literal["text", "markdown", "latex", "html", "json"]

# Shares of the time limit: what is solved by then is kept, and what is left is given up, so that
# there is time to write down the rest.
_FIRST = 0.6
_WRITING = 0.3
_WRITTEN = 0.8  # by then a working is written, or given up: from one checkpoint to the next is far
_LETTERS = 0.6  # for the plan of the working whose letters pictures have
_SHOWING = 0.9  # by then all pieces of a page are made, or given up


@dataclass(frozen=True)
class Writing:
    """A solution to be written down, ``width`` characters wide.

    ``part`` is the label of the one part wanted, or None for all; ``styled`` is text with bold type
    for a terminal. ``marks`` is the style of marks; ``working`` adds the derivation of each part to
    JSON. ``route`` chooses among the ways to the answers, and ``check`` has each line followed.
    ``mistake`` is the id of a mistake, or of one of its variants, in whose world it is solved.
    """

    form: Format = "text"
    part: str | None = None
    answers_only: bool = False
    width: int = 80
    styled: bool = False
    marks: Style = "fm1"
    working: bool = False
    route: int = 1
    check: bool = False
    mistake: str | None = None


@dataclass(frozen=True)
class Drawing:
    """Pictures to be drawn as one SVG: that of one event, or all (None)."""

    event: int | None = None


@dataclass(frozen=True)
class Playing:
    """Its motion to be played on a page: that of the part with a label, or of all parts (None).

    With a ``mistake``, an id, the altered motion is played beside it.
    """

    part: str | None = None
    mistake: str | None = None


@dataclass(frozen=True)
class Setting:
    """A question to be set on a sheet, with ``seed`` one like it with other numbers."""

    options: Options
    seed: int | None = None


@dataclass(frozen=True)
class Tracing:
    """A stage of the problem on its way to the answers, to be printed."""

    stage: Stage


@dataclass(frozen=True)
class Marking:
    """Workings of the question to be marked."""

    workings: Workings


@dataclass(frozen=True)
class Picturing:
    """Pictures to be drawn, each by itself: that of one event, or all (None)."""

    event: int | None = None


@dataclass(frozen=True)
class Showing:
    """Everything that a page shows: answers, wording, pictures, working, motion.

    ``early`` is given the same without working and motion, as soon as that is there.
    """

    early: Callable[[ExplainedObject], None] | None = None


Task: TypeAlias = Writing | Drawing | Playing | Setting | Tracing | Picturing | Showing | Marking


@dataclass(frozen=True)
class Job:
    """A problem to be solved, and what to make of it: ``limit`` in seconds."""

    file: str
    problem: Problem
    task: Task = Writing()
    limit: float | None = None


@dataclass(frozen=True)
class Reply:
    """The result of a job: its content, whether everything has an answer, and why an item has none.

    ``content`` is a text (SVG for pictures, HTML for a motion), the entry of a sheet, or plain data
    for a page.
    ``fault`` is the traceback of a failure of the program while it wrote the working; ``tired``
    tells that a piece of work was broken off, and that the process should end. ``notes`` tell what
    is no warning: that a working was followed. ``unreadable`` tells that what came with the
    question (letters, an answer) cannot be read.
    """

    content: Any
    answered: bool
    errors: tuple[RestitutionError, ...] = ()
    warnings: tuple[str, ...] = ()
    fault: str = ""
    tired: bool = False
    notes: tuple[str, ...] = ()
    unreadable: bool = False


def prepare() -> None:
    """Load what the work needs: before it is asked whether there is time to rehearse."""
    # Loading makes many objects and no garbage.
    gc.disable()
    without_tensors()
    for module in (
        *("export.answers", "export.contract", "render.document.text", "solving.showing"),
        "workings",
    ):
        import_module(f"restitution.{module}")

    # What was loaded stays: no need to look through it again for garbage.
    gc.freeze()
    gc.enable()
    collect_seldom()


_SELDOM = (
    *("explaining.following.agreeing", "planning.inequalities.extrema", "planning.shows.forward"),
    *("render.document.html", "solving.equations.clash", "solving.story.alteration"),
    "workings.refuted",
)


def load_what_few_need() -> None:
    """Load what only some questions need, where there is time."""
    for module in _SELDOM:
        import_module(f"restitution.{module}")


def rehearse() -> None:
    """Solve and explain a tiny question: the algebra's first steps are slow ones.

    They fill what SymPy keeps, and load what it loads late. The next question takes half the time.
    Classes that such a question has values of will have more of them.
    """
    half = Binary("/", Number(Fraction(1)), Number(Fraction(2)))
    speed = Value(Quantity("speed", (Name("P"),)), text="speed(P)")
    serve(
        Job(
            "rehearsal",
            Problem(
                spheres=(Sphere("P", mass=2, velocity=(3, -4)),),
                walls=(Wall("W", along=(1, 0)),),
                parts=(Part(None, (Impact("P", "W", e=half), Find((speed,)))),),
            ),
        )
    )
    load_what_few_need()
    compile_what_is_used()


def stopped(limit: float | None) -> TimeLimitError:
    """The error of a solve that took too long."""
    return TimeLimitError(f"no answer within the time limit of {limit or 0:g} s")


def unwritten(limit: float | None) -> TimeLimitError:
    """The error of a working that took longer than what solving had left of the time."""
    return TimeLimitError(f"the time limit of {limit or 0:g} s was near while it was written")


def hurried(limit: float | None, while_: str) -> str:
    """The warning that something may be missing, as the clock broke off a piece of the work."""
    return f"the time limit of {limit or 0:g} s was near while {while_}: something may be left out"


def serve(job: Job) -> Reply:
    """Solve, and make what is wanted. Raises RestitutionError where nothing at all can be said."""
    from restitution.export import contract
    from restitution.solving import solve

    if isinstance(job.task, Tracing):
        from restitution.export.trace import trace

        with limited(job.limit, error=stopped(job.limit)):
            return Reply(trace(job.problem, job.task.stage), True)
    began = time.monotonic()
    with limited(
        None if job.limit is None else job.limit * _FIRST, error=stopped(job.limit)
    ) as limit:
        problem, unvaried = _varied(job)
        solution = solve(problem)
    label = job.task.part if isinstance(job.task, Writing | Playing) else None
    reply = contract.solved(job.file, solution, label)
    errors = _errors(solution, label)
    tired = limit.broken
    late = [hurried(job.limit, "it was solved")] if tired else []
    reply["warnings"] += late
    answered = contract.all_answered(reply)
    match job.task:
        case Writing(mistake=str(mistake)):
            from restitution.export.altered import written

            columns = None if job.task.form == "json" else job.task.width
            text = written(reply, solution, mistake, job.limit, part=job.task.part, columns=columns)
            return Reply(text, True, errors, tuple(reply["warnings"]), tired=tired)
        case Writing("json", working=False, check=False):
            return Reply(contract.to_json(reply) + "\n", answered, tired=tired)
        case Writing("json"):
            explained = _explained(solution, job.task, job.limit, began)
            reply["warnings"] += explained.why_not
            written_down: SolvedObject | WorkedObject = reply
            if job.task.working:
                derivations = (
                    {} if explained.value is None else contract.derivations(explained.value)
                )
                written_down = contract.with_derivations(reply, derivations)
            return Reply(
                contract.to_json(written_down) + "\n",
                answered and explained.sound,
                fault=explained.fault,
                tired=tired or explained.value is None,
                notes=explained.notes,
            )
        case Writing():
            text, explained = _written(solution, job.task, job.limit, began)
            return Reply(
                text if text.endswith("\n") else text + "\n",
                answered and explained.sound,
                errors,
                (*(e for e in reply["warnings"] if e not in explained.proved), *explained.why_not),
                explained.fault,
                tired or bool(explained.why_not or explained.fault),
                explained.notes,
            )
        case Marking(workings):
            from restitution.export.marking import written as marked

            try:
                text, left_out = marked(solution, workings, _left(job.limit, began, _SHOWING))
            except StatementError as error:  # in the letters, or in what is said to be an answer
                return Reply(None, False, (error,), unreadable=True)
            unmarked = tuple(
                TimeLimitError(f"{name}: not marked within the time limit of {job.limit or 0:g} s")
                for name in left_out
            )
            tired |= bool(left_out)
            return Reply(text, not left_out, unmarked, tuple(reply["warnings"]), tired=tired)
        case Drawing(event):
            from restitution.export.pictures import picture

            svg = picture(solution, event, _left(job.limit, began, _LETTERS))
            return Reply(svg, answered, errors, tuple(reply["warnings"]), tired=tired)
        case Playing(part, mistake):
            from restitution.export.player import play
            from restitution.export.player.data import is_hurried

            budget = None if job.limit is None else job.limit * _WRITING
            played = play(solution, part, seconds=budget, as_=mistake)
            tired = tired or is_hurried(played.data)
            return Reply(played.html, answered, errors, tuple(reply["warnings"]), tired=tired)
        case Setting(options):
            from restitution.export.sheet import entry

            one = entry(solution, options)
            # No working says so on a sheet without solutions.
            false = [words for words, _ in solution.refutations()]
            warnings = [*reply["warnings"], *false]
            return Reply(one, answered, errors, tuple(warnings), tired=tired, notes=unvaried)
        case Picturing(event):
            from restitution.export.working import pictured
            from restitution.workings.pictures import letters_of_working

            letters = letters_of_working(solution, _left(job.limit, began, _LETTERS))
            drawn: DrawnObject = {**reply, **pictured(solution, event, letters)}
            return Reply(drawn, answered, errors, tuple(reply["warnings"]), tired=tired)
        case Showing(early):
            from restitution.export.working import Pieces, shown

            left = _left(job.limit, began, _SHOWING)

            def seen(pieces: Pieces) -> None:
                if early is not None:
                    early(pieces.beside(reply))

            page = shown(solution, left, seen)
            reply["warnings"] += page.left_out
            warnings = [*page.pieces.warnings, *late]
            content = replace(page.pieces, warnings=warnings).beside(reply)
            return Reply(
                content, answered, errors, tuple(warnings), page.fault, tired or page.tired
            )


def _left(limit: float | None, began: float, share: float) -> float | None:
    """The seconds for writing: what solving has left of a share, and never less than its own."""
    if limit is None:
        return None
    return max(limit * share - (time.monotonic() - began), limit * _WRITING)


def _varied(job: Job) -> tuple[Problem, tuple[str, ...]]:
    """The problem of a job, or one like it, and what was not varied."""
    seed = job.task.seed if isinstance(job.task, Setting) else None
    if seed is None:
        return job.problem, ()
    from restitution.language import parse
    from restitution.practice.questions.varying import variant

    varied = variant(job.problem, seed)
    return parse(varied.statement), varied.notes


def _errors(solution: Solution, label: str | None) -> tuple[RestitutionError, ...]:
    errors = [solution.error]
    for part, item in solution.items():
        if label is None or part.part.label == label:
            errors.append(item.error)
    unique = {str(error): error for error in errors if error is not None}
    return tuple(unique.values())


@dataclass(frozen=True)
class _Explained:
    """What came of the working: its text or value, why there is none, and a fault's traceback.

    ``notes`` tell whether it was followed, and that there is no other way, where that was asked;
    ``sound`` is False for a fault, and where it was not followed to its end. ``proved`` are
    warnings of the solution that the working makes needless, as its lines are the proof.
    """

    value: Any = None
    why_not: tuple[str, ...] = ()
    fault: str = ""
    notes: tuple[str, ...] = ()
    sound: bool = True
    proved: frozenset[str] = frozenset()


def _explained(
    solution: Solution,
    task: Writing,
    whole: float | None,
    began: float,
    make: Callable[[Explanation], Any] = lambda explanation: explanation,
) -> _Explained:
    """The working, or what ``make`` makes of it, in what is left of the time."""
    try:
        with limited(_left(whole, began, _WRITTEN), error=unwritten(whole)):
            from restitution.workings import explain

            explanation = explain(
                solution, task.part, marks=task.marks, route=task.route, check=task.check
            )
            content = make(explanation)
            confirm()
    except RestitutionError as error:
        why = f"here are the answers without their working: {error.message}"
        return _Explained(why_not=(why,), sound=not task.check)
    except Exception:  # noqa: BLE001 - whatever it is, the answers stand
        # The answers are right without their working: they are given, and the fault told.
        return _Explained(fault=traceback.format_exc(), sound=False)
    notes: tuple[str, ...] = ()
    with suppress(RestitutionError), limited(_left(whole, began, _WRITTEN)):
        notes = _of_the_way(solution, task, explanation)
    proved = frozenset(solution.warnings) - frozenset(explanation.warnings)
    if not task.check:
        return _Explained(content, notes=notes, proved=proved)
    followed = explanation.followed is True
    notes = (*notes, _FOLLOWED[followed])
    return _Explained(content, notes=notes, sound=followed, proved=proved)


def _of_the_way(solution: Solution, task: Writing, explanation: Explanation) -> tuple[str, ...]:
    """What to say where another way was asked for, and there is none."""
    from restitution.workings import explain

    better = task.route - 1
    if not better or str(explain(solution, task.part, marks=task.marks, route=better)) != str(
        explanation
    ):
        return ()
    return (f"there is no further way: this is that of --route {better}",)


_FOLLOWED = {
    True: "every line of the working was followed exactly",
    False: "a line of the working could not be followed",
}


def _written(
    solution: Solution, task: Writing, whole: float | None, began: float
) -> tuple[str, _Explained]:
    """The working as text, or the answers alone; and what came of the working."""
    from restitution.export.answers import answers

    assert task.form != "json"
    explained = _Explained()
    if not task.answers_only:
        explained = _explained(
            solution, task, whole, began, lambda explanation: _working(explanation, task)
        )
        if explained.value is not None:
            return explained.value, explained
    return answers(solution, task.form, task.part), explained


def _working(explanation: Explanation, task: Writing) -> str:
    from restitution.workings import to_text

    if task.form == "text":
        return to_text(explanation, task.width, task.styled)
    from restitution.workings import illustrated, to_html, to_latex, to_markdown

    match task.form:
        case "markdown":
            return to_markdown(illustrated(explanation))
        case "latex":
            return to_latex(explanation)
        case _:
            return to_html(illustrated(explanation))
