"""The command ``experiment``: e from a table of what was measured."""

from __future__ import annotations

from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from restitution.cli.files import first_bytes, printable, say, shown_name, terminal_width
from restitution.cli.output import RefusedError, put, write_file
from restitution.cli.statuses import UNANSWERED, UNREADABLE
from restitution.errors import RestitutionError, StatementError
from restitution.records import dataclass

if TYPE_CHECKING:
    from restitution.experiments.records import Kind
    from restitution.experiments.whole import Experiment


class ExperimentKind(StrEnum):
    """What was measured."""

    wall = "wall"
    spheres = "spheres"
    tracks = "tracks"


class ExperimentFormat(StrEnum):
    """How the result is written down."""

    text = "text"
    json = "json"


@dataclass(frozen=True)
class Experimenting:
    """What the command was asked for. ``output`` is the path of a report or a picture."""

    data: str
    kind: Kind | None = None
    angle_error: float | None = None
    speed_error: float | None = None
    from_normal: bool = False
    form: ExperimentFormat = ExperimentFormat.text
    output: str | None = None


@dataclass(frozen=True)
class Planning:
    """What a plan was asked for; what was left out is None."""

    e: float | None
    angle_error: float | None
    trials: int | None
    seed: int | None
    form: ExperimentFormat = ExperimentFormat.text


def plan(asked: Planning, others: Sequence[object]) -> int:
    """Print a plan, and give the exit status. Raises RefusedError.

    ``others`` are the arguments that have no meaning for a plan: None if they were not given.
    """
    if any(option is not None for option in others):
        message = "a plan takes --e, --angle-error, --trials, --seed and --format alone, no table"
        raise RefusedError(message, "--plan")
    if asked.e is None:
        raise RefusedError("a plan needs the e that is expected: --e 0.7", "--plan")
    from restitution.experiments import experiment_plan

    try:
        result = experiment_plan(
            asked.e,
            angle_error=1.0 if asked.angle_error is None else asked.angle_error,
            trials=10 if asked.trials is None else asked.trials,
            seed=1 if asked.seed is None else asked.seed,
        )
    except RestitutionError as error:
        say(error.message)
        return UNREADABLE
    put(
        f"{result.json()}\n"
        if asked.form is ExperimentFormat.json
        else result.text(terminal_width())
    )
    return 0


def require_no_plan(e: float | None, trials: int | None, seed: int | None) -> None:
    """Raises RefusedError for options of a plan where none is asked for."""
    given = {"--e": e, "--trials": trials, "--seed": seed}
    for option, value in given.items():
        if value is not None:
            raise RefusedError("this has a meaning with --plan alone", option)


def experiment(asked: Experimenting) -> int:
    """Does what was asked, and gives the exit status. Raises RefusedError."""
    form = _form_of(asked.output)
    try:
        result = _result(asked)
    except StatementError as error:
        _tell(asked.data, error)
        return UNREADABLE
    except RestitutionError as error:
        _tell(asked.data, error)
        return UNANSWERED
    for fault in result.table.faults:
        say(f"{shown_name(asked.data)}: left out: {printable(str(fault))}")
    if asked.form is ExperimentFormat.json:
        put(f"{result.json()}\n")
    else:
        put(result.text(terminal_width()))
    return _write_file(asked, result, form)


def _result(asked: Experimenting) -> Experiment:
    from restitution.experiments import experiment
    from restitution.experiments.rows import MAX_BYTES

    return experiment(
        first_bytes(asked.data, MAX_BYTES + 1),
        kind=asked.kind,
        angle_error=asked.angle_error,
        speed_error=asked.speed_error,
        from_normal=asked.from_normal,
    )


def _tell(file: str, error: RestitutionError) -> None:
    place = "".join(f":{n}" for n in (error.line, error.column) if n is not None)
    say(f"{shown_name(file)}{place}: {printable(error.message)}")
    for other in getattr(error, "others", ()):
        say(f"{shown_name(file)}: {printable(str(other))}")


_Form = Literal["html", "pdf", "svg", "png"]
_FORMS: tuple[_Form, ...] = ("html", "pdf", "svg", "png")


def _form_of(path: str | None) -> _Form:
    """What the ending of a name says: a report, or the plot of the law."""
    ending = ".html" if path is None else Path(path).suffix.lower()
    for form in _FORMS:
        if ending == f".{form}":
            return form
    message = "the name of a report ends in .html or .pdf, that of a picture in .svg or .png"
    raise RefusedError(f"{path}: {message}", "--output")


def _write_file(asked: Experimenting, result: Experiment, form: _Form) -> int:
    if asked.output is None:
        return 0
    try:
        content = _content(result, form)
    except RestitutionError as error:
        say(error.message)
        return UNANSWERED
    write_file(asked.output, content, [asked.data])
    return 0


def _content(result: Experiment, form: _Form) -> bytes:
    if form == "html" or form == "pdf":
        from restitution.experiments.report import report

        return report(result, form)
    from restitution.drawing.convert import converted
    from restitution.experiments.plots import law_plot

    svg = law_plot(result)
    return converted(svg, form) if form == "png" else svg.encode()
