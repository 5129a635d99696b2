"""The commands, their options, and what they say."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal, TypeVar

import typer

from restitution.cli import experimenting, solving
from restitution.cli.asking import answer, worker_of
from restitution.cli.experimenting import (
    ExperimentFormat,
    Experimenting,
    ExperimentKind,
    Planning,
)
from restitution.cli.files import hint, parse, pointed, read, say, shown_name
from restitution.cli.output import (
    Format,
    MarkingFormat,
    Marks,
    PictureFormat,
    RefusedError,
    SheetFormat,
    Stage,
    interruptible,
    nothing,
    progress,
    silent,
    write_file,
)
from restitution.cli.solving import TIME_LIMIT, Solving, seconds_of
from restitution.cli.statuses import UNANSWERED, UNREADABLE
from restitution.counting import counted
from restitution.errors import RestitutionError, StatementError

if TYPE_CHECKING:
    from restitution.export.sheet import Entry, Options
    from restitution.problem import Problem


_HELP = """Exact, worked solutions of oblique elastic impacts.

State a question in a file, say ball.impact, one fact a line:

\b
    wall W: along i
    sphere P: mass 2, velocity 5i - 3j
    P hits W: e = 1/3
    find velocity(P), impulse

and solve it:

\b
    restitution solve ball.impact

More statements to learn from: restitution examples. Everything a statement may
say: restitution language.
"""

_SOLVE = """Solve questions and write down the working.

\b
    restitution solve ball.impact
    restitution solve ball.impact --format html --output ball.html
    restitution solve *.impact --format json > answers.jsonl
    restitution examples corner | restitution solve -
    restitution solve ball.impact --as restitution-parallel

With --as, the answers that a mistake leads to.

A file that cannot be read does not stop the others. Exit status: 0; 1 if an
item has no answer; 2 if a file could not be read. A "show" that is refuted
is answered; so is one that is not decided, with a warning.
"""

_DRAW = """Draw the impacts of a question to scale.

Before and after each impact, and the path through walls.

\b
    restitution draw ball.impact -o ball.svg
    restitution draw ball.impact -o ball.png --event 2
    restitution examples corner | restitution draw - -o corner.pdf

PNG and PDF need the extra "pdf": pip install 'restitution[pdf]'.
"""

_SHEET = """Set questions on a sheet to print.

Their wording, diagrams, room for working, and worked solutions if wanted.

\b
    restitution sheet *.impact -o sheet.pdf
    restitution sheet *.impact -o answers.pdf --solutions
    restitution sheet ball.impact -o ball.html
    restitution sheet *.impact -o scheme.pdf --scheme
    restitution sheet *.impact -o test.pdf --variants 3 --seed 7
    restitution sheet --experiment -o wall.pdf --trials 10

The fifth writes test-1.pdf, test-1-scheme.pdf and so on: the same questions
with other numbers. The last is a worksheet of the experiment that finds e at a
wall: what to do, a table, axes, questions. PDF needs the extra "pdf": pip
install 'restitution[pdf]'.
"""

_PLAY = """Play the motion of a question in the browser.

One page, to be opened by any browser, that needs nothing else: play and pause,
step from impact to impact, slow motion, components before and after.

\b
    restitution play ball.impact
    restitution play ball.impact -o ball.html --open
    restitution examples corner | restitution play - -o corner.html
    restitution play ball.impact --as restitution-parallel

With --as, the motion of a mistake is played beside the true one, and what is
wrong with it is told. Letters are at values that the page tells.
"""

_SERVE = """Open the page: state an impact, see it, play with it.

\b
    restitution serve
    restitution serve --port 9000 --no-browser

Needs the extra "web": pip install 'restitution[web]'. Ctrl-C ends it.
"""

_CHECK = """Read statements without solving them.

What is wrong with them is said, with its place, and the line as it might be meant.

\b
    restitution check ball.impact
    restitution check ball.impact --json

In JSON each mistake has the edits that would mend it.
"""

_TRACE = """Print a stage of a question on its way to the answers.

For developers and the curious: the statement as it was read, the equations that
its parts ask of the story, or the lines of the working with their moves.

\b
    restitution trace ball.impact --stage tree
    restitution trace ball.impact --stage equations
    restitution examples corner | restitution trace - --stage derivation
"""

_MISTAKES = """List the mistakes that students make, or tell of one.

\b
    restitution mistakes
    restitution mistakes momentum-sign
    restitution solve ball.impact --as momentum-sign
    restitution play ball.impact --as momentum-sign

Each is a law, or a result, that is altered.
"""

_MARK = """Mark a working of a question, line by line.

\b
    restitution mark ball.impact working.txt
    restitution mark ball.impact working.txt --letters letters.txt --hints 3
    restitution mark ball.impact scripts/ --csv > marks.csv
    restitution mark ball.impact --answer "speed(P) = 4.51"

A step a line, as on paper; a line (a) opens a part. A letters file has a line
for each letter: v: component of A along i after. Exit status: 0 marked; 1 the
question has no answer; 2 something cannot be read.
"""

_PRACTISE = """Practise: a question in words, your working read and marked, the next question.

\b
    restitution practise
    restitution practise wall-forward --level 2 --seed 7
    restitution practise --topics
    restitution practise --state mine.json
    restitution practise spheres-vectors --seed 3 -o question.impact
    restitution practise --like ball.impact --seed 1 -o another.impact

The same topic, level and seed give the same question everywhere. With --state,
the file holds what was done: it chooses the next question by that. Ctrl-C ends.
"""

_EXPERIMENT = """Find e from what was measured, with its uncertainty, and check the model.

\b
    restitution experiment angles.csv --angle-error 1
    restitution experiment angles.csv --from-normal
    restitution experiment pucks.csv --kind spheres --speed-error 0.02
    restitution experiment video.csv --format json
    restitution experiment angles.csv -o report.html
    restitution experiment angles.csv -o law.svg
    restitution experiment --plan --e 0.7 --angle-error 1 --trials 10

The table has a header: alpha, beta (degrees to the wall), perhaps u, v; or
u_A_x, u_A_y, u_B_x, ... v_B_y, perhaps m_A, m_B, line; or t, x, y, perhaps
body, trial, wall. An error stands beside, as alpha_error. Needs the extra
"experiment": pip install 'restitution[experiment]'. With --plan, at which angles
to measure, and how well e will be known. Exit status: 0 fitted; 1
these data give no value of e; 2 they cannot be read.
"""

_EXAMPLES = """List the examples, or print one.

\b
    restitution examples
    restitution examples corner
    restitution examples corner | restitution solve -
"""

app = typer.Typer(
    help=_HELP,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        typer.echo(f"restitution {version('restitution')}")
        raise typer.Exit


@app.callback()
def _everywhere(
    version: Annotated[
        bool,
        typer.Option(
            "--version", callback=_print_version, is_eager=True, help="Print the version and exit."
        ),
    ] = False,
) -> None:
    pass


# --- solve ------------------------------------------------------------------------------------

_Files = Annotated[
    list[str],
    typer.Argument(metavar="FILE...", help="Files that hold a statement; - is standard input."),
]


@contextmanager
def _refusing() -> Iterator[None]:
    """What is refused is told with the usage of the command."""
    try:
        yield
    except RefusedError as error:
        raise typer.BadParameter(error.message, param_hint=error.option) from None


_Marks = Annotated[
    Marks,
    typer.Option("--marks", help="Marks as in Further Mechanics 1, in M4, as Cambridge, or none."),
]
_TimeLimit = Annotated[float, typer.Option(metavar="SECONDS", help="For each file; 0 is no limit.")]
_Mistake = Annotated[
    str | None,
    typer.Option(
        "--as", metavar="ID", help="In the world of a mistake; restitution mistakes lists them."
    ),
]
_F = TypeVar("_F", bound=StrEnum)


@app.command(help=_SOLVE)
def solve(
    context: typer.Context,
    files: _Files,
    form: Annotated[
        Format, typer.Option("--format", "-f", help="How to write the solution down.")
    ] = Format.text,
    output: Annotated[
        str | None,
        typer.Option(
            "--output", "-o", metavar="PATH", help="A file, or a folder to hold a file for each."
        ),
    ] = None,
    part: Annotated[
        str | None, typer.Option(metavar="LABEL", help="Only this part of the question.")
    ] = None,
    answers_only: Annotated[
        bool, typer.Option("--answers-only", help="Leave the working out.")
    ] = False,
    marks: _Marks = Marks.fm1,
    working: Annotated[
        bool, typer.Option("--working", help="The working as data too, with --format json.")
    ] = False,
    route: Annotated[
        int,
        typer.Option(metavar="N", min=1, max=3, help="The N-th best way, where there are several."),
    ] = 1,
    check: Annotated[
        bool, typer.Option("--check", help="Follow every line of the working, and say so.")
    ] = False,
    mistake: _Mistake = None,
    time_limit: _TimeLimit = TIME_LIMIT,
    debug: Annotated[bool, typer.Option("--debug", hidden=True)] = False,
) -> None:
    """Solve every file, writing what is said of each as soon as it is known."""
    if debug:
        os.environ["RESTITUTION_DEBUG"] = "1"
    asked = Solving(
        tuple(files),
        form,
        output,
        part,
        answers_only,
        time_limit,
        marks,
        working,
        route,
        check,
        mistake,
    )
    with _refusing():
        status = solving.solve(asked, context.obj)
    raise typer.Exit(status)


# --- draw, sheet ------------------------------------------------------------------------------


@app.command(help=_DRAW)
def draw(
    context: typer.Context,
    file: Annotated[
        str,
        typer.Argument(metavar="FILE", help="A file that holds a statement; - is standard input."),
    ],
    output: Annotated[
        str,
        typer.Option(
            "--output", "-o", metavar="PATH", help="The picture; - is standard output (SVG)."
        ),
    ] = "-",
    form: Annotated[
        PictureFormat | None,
        typer.Option("--format", "-f", help="Else the ending of the output's name tells it."),
    ] = None,
    event: Annotated[
        int | None,
        typer.Option("--event", metavar="N", min=1, help="Only the N-th event of the story."),
    ] = None,
    time_limit: _TimeLimit = TIME_LIMIT,
) -> None:
    """Draw the impacts of one file."""
    from restitution.export.job import Drawing

    form = _form_of(output, form, PictureFormat, PictureFormat.svg)
    with interruptible(), worker_of(context.obj) as worker:
        done = answer(worker, file, Drawing(event), _limit(time_limit))
        for message in done.messages:
            say(message)
        if done.content is None:
            raise typer.Exit(done.status)
        content = done.content.encode()
        if form is not PictureFormat.svg:
            from restitution.drawing.convert import converted

            kind: Literal["png", "pdf"] = "png" if form is PictureFormat.png else "pdf"
            content = _content_or_exit(lambda: converted(done.content, kind))
        with _refusing():
            write_file(output, content, [file])
    raise typer.Exit(done.status)


@app.command(help=_SHEET)
def sheet(
    context: typer.Context,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="PATH", help="The sheet; - is standard output.")
    ],
    files: Annotated[
        list[str] | None,
        typer.Argument(metavar="FILE...", help="Files that hold a statement; - is standard input."),
    ] = None,
    form: Annotated[
        SheetFormat | None,
        typer.Option("--format", "-f", help="Else the ending of the output's name tells it."),
    ] = None,
    title: Annotated[str | None, typer.Option(metavar="TEXT", help="What stands above.")] = None,
    solutions: Annotated[
        bool, typer.Option("--solutions", help="Worked solutions behind the questions.")
    ] = False,
    diagrams: Annotated[
        bool, typer.Option("--diagrams/--no-diagrams", help="With pictures, or without.")
    ] = True,
    space: Annotated[
        float | None,
        typer.Option(
            metavar="CM",
            min=0,
            max=100,
            help="Room for working after each part; else a centimetre for each mark, and none"
            " with --solutions.",
        ),
    ] = None,
    marks: _Marks = Marks.fm1,
    scheme: Annotated[
        bool, typer.Option("--scheme", help="The mark scheme behind the questions.")
    ] = False,
    variants: Annotated[
        int | None,
        typer.Option(
            metavar="N",
            min=1,
            max=100,
            help="N versions with other numbers, each a file, and a file for its mark scheme.",
        ),
    ] = None,
    seed: Annotated[
        int, typer.Option(metavar="S", min=0, help="Which versions, with --variants.")
    ] = 1,
    experiment: Annotated[
        bool,
        typer.Option("--experiment", help="A worksheet of the experiment with a wall; no files."),
    ] = False,
    trials: Annotated[
        int | None,
        typer.Option(metavar="N", help="Rows of its table, with --experiment; else 8."),
    ] = None,
    time_limit: _TimeLimit = TIME_LIMIT,
) -> None:
    """Set the questions of all files on one sheet."""
    from restitution.export.sheet import Options

    form = _form_of(output, form, SheetFormat, SheetFormat.pdf)
    if experiment:
        if files or scheme or variants is not None:
            message = "a worksheet takes no files, no --scheme and no --variants"
            raise typer.BadParameter(message, param_hint="--experiment")
        _write_worksheet(output, form, title, solutions, trials)
        raise typer.Exit
    if trials is not None:
        raise typer.BadParameter("this needs --experiment", param_hint="--trials")
    if not files:
        raise typer.BadParameter("a file is missing, or --experiment", param_hint="FILE...")
    options = Options(solutions, diagrams, space, marks.value, scheme)
    if variants is not None and output == "-":
        raise typer.BadParameter("versions need a file each", param_hint="--variants")
    worst = 0
    with interruptible(), worker_of(context.obj) as worker:
        from restitution.export.job import Setting

        def entries_of(options: Options, version: int | None) -> list[Entry]:
            nonlocal worst
            entries = []
            shown = progress(files) if len(files) > 1 else silent
            with shown(output == "-") as each:
                for file in each(files):
                    task = Setting(form.value, options, version)
                    done = answer(worker, file, task, _limit(time_limit))
                    worst = max(worst, done.status)
                    if done.content is not None:
                        entries.append(done.content)
                    for message in done.messages:
                        if version in (None, seed) or done.status:
                            say(message)
            return entries

        if variants is None:
            entries = entries_of(options, None)
            if not entries:
                raise typer.Exit(worst)
            _write_sheet(output, entries, title, options, form, files)
        for number in range(1, (variants or 0) + 1):
            entries = entries_of(replace(options, scheme=True), seed + number - 1)
            if not entries:
                raise typer.Exit(worst)
            named = f"{title or _TITLE}, version {number}"
            plain = replace(options, scheme=False)
            _write_sheet(_numbered(output, f"-{number}"), entries, named, plain, form, files)
            named, path = f"{named}: mark scheme", _numbered(output, f"-{number}-scheme")
            _write_sheet(path, entries, named, replace(plain, scheme=True), form, files)
    raise typer.Exit(worst)


def _write_worksheet(
    output: str, form: SheetFormat, title: str | None, solutions: bool, trials: int | None
) -> None:
    """The worksheet of the experiment with a wall."""
    from restitution.experiments.worksheet import USUAL_TRIALS, worksheet
    from restitution.render.document.html import to_html
    from restitution.render.document.typst import to_pdf

    try:
        rows = USUAL_TRIALS if trials is None else trials
        document = worksheet(rows, solutions=solutions, title=title)
    except StatementError as error:
        raise typer.BadParameter(error.message, param_hint="--trials") from None
    pdf = form is SheetFormat.pdf
    content = _content_or_exit(lambda: to_pdf(document)) if pdf else to_html(document).encode()
    with _refusing():
        write_file(output, content, [])


_TITLE = "Oblique impacts"


def _numbered(output: str, ending: str) -> str:
    """The name of a file with an ending before its suffix."""
    path = Path(output)
    return str(path.with_name(f"{path.stem}{ending}{path.suffix}"))


def _write_sheet(
    output: str,
    entries: list[Entry],
    title: str | None,
    options: Options,
    form: SheetFormat,
    files: list[str],
) -> None:
    """One sheet, put together and written."""
    from restitution.export.sheet import to_html, to_pdf

    if form is SheetFormat.pdf:
        content = _content_or_exit(lambda: to_pdf(entries, title, options))
    else:
        content = to_html(entries, title, options).encode()
    with _refusing():
        write_file(output, content, files)


# --- play -------------------------------------------------------------------------------------


@app.command(help=_PLAY)
def play(
    context: typer.Context,
    file: Annotated[
        str,
        typer.Argument(metavar="FILE", help="A file that holds a statement; - is standard input."),
    ],
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="PATH",
            help="The page; - is standard output. Else ball-motion.html for ball.impact, here.",
        ),
    ] = None,
    part: Annotated[
        str | None, typer.Option(metavar="LABEL", help="Only this part of the question.")
    ] = None,
    show: Annotated[bool, typer.Option("--open", help="Open the page in the browser.")] = False,
    mistake: _Mistake = None,
    time_limit: _TimeLimit = TIME_LIMIT,
) -> None:
    """Write the page that plays the motion of one file."""
    from restitution.export.job import Playing

    named = output is not None
    if output is None:
        stem = "standard-input" if file == "-" else Path(file).name.removesuffix(".impact")
        output = f"{stem}-motion.html"
    if mistake is not None:
        with _refusing():
            solving.require_mistake(mistake)
    if show and output == "-":
        raise typer.BadParameter("a page that is opened needs a file", param_hint="--open")
    with interruptible(), worker_of(context.obj) as worker:
        done = answer(worker, file, Playing(part, mistake), _limit(time_limit))
        for message in done.messages:
            say(message)
        if done.content is None:
            raise typer.Exit(done.status)
        with _refusing():
            write_file(output, done.content.encode(), [file])
    if not named:
        say(f"{shown_name(output)}: written; open it in a browser")
    if show:
        import webbrowser

        webbrowser.open(Path(output).resolve().as_uri())
    raise typer.Exit(done.status)


def _limit(seconds: float) -> float | None:
    with _refusing():
        return seconds_of(seconds)


def _form_of(output: str, form: _F | None, known: type[_F], otherwise: _F) -> _F:
    """The form asked for, or that of a name's ending."""
    if form is not None:
        return form
    if output == "-":
        return otherwise
    ending = Path(output).suffix.removeprefix(".").lower()
    try:
        return known(ending)
    except ValueError:
        forms = ", ".join(f".{each.value}" for each in known)
        raise typer.BadParameter(
            f"{output}: the name should end in one of {forms}, or --format be given",
            param_hint="--output",
        ) from None


def _content_or_exit(make: Callable[[], bytes]) -> bytes:
    """The bytes that ``make`` returns; where it raises, a message and the end of the command."""
    try:
        return make()
    except RestitutionError as error:
        say(error.message)
        raise typer.Exit(UNANSWERED) from None


# --- the page ----------------------------------------------------------------------------------


@app.command(help=_SERVE)
def serve(
    host: Annotated[
        str,
        typer.Option(
            metavar="ADDRESS", help="Where to listen: this machine alone, or 0.0.0.0 for all."
        ),
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="0 takes any that is free.")] = 8765,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")
    ] = True,
    workers: Annotated[
        int | None,
        typer.Option(
            metavar="N", min=1, max=256, help="Processes that solve; else one more than processors."
        ),
    ] = None,
    time_limit: Annotated[
        float, typer.Option(metavar="SECONDS", min=0.5, max=600, help="For each question.")
    ] = 10.0,
    trusted: Annotated[
        list[str] | None,
        typer.Option(
            "--trusted-host",
            metavar="NAME",
            help="A name under which the page is asked for, beside those of this machine.",
        ),
    ] = None,
) -> None:
    """Serve the page."""
    try:
        from restitution.web import Settings
        from restitution.web.serving import serve as run
    except ModuleNotFoundError as error:
        missing = (error.name or "").partition(".")[0]
        if missing == "restitution":
            raise
        say(f"the page needs {missing}: pip install 'restitution[web]'")
        raise typer.Exit(UNREADABLE) from None
    names = tuple(name.lower() for name in trusted or ())
    settings = Settings(time_limit=time_limit, hosts=names)
    if workers is not None:
        settings = replace(settings, workers=workers)
    try:
        run(host, port, settings, say, browser)
    except RestitutionError as error:
        say(error.message)
        raise typer.Exit(UNREADABLE) from None


# --- experiment -------------------------------------------------------------------------------


@app.command(help=_EXPERIMENT)
def experiment(
    data: Annotated[
        str | None, typer.Argument(metavar="DATA.csv", help="A table; - is standard input.")
    ] = None,
    kind: Annotated[
        ExperimentKind | None, typer.Option("--kind", help="Else the columns tell it.")
    ] = None,
    angle_error: Annotated[
        float | None,
        typer.Option(metavar="DEGREES", help="Standard error of each angle; else the scatter."),
    ] = None,
    speed_error: Annotated[
        float | None,
        typer.Option(metavar="M/S", help="Standard error of each speed or component."),
    ] = None,
    from_normal: Annotated[
        bool, typer.Option("--from-normal", help="Angles are from the normal, not the wall.")
    ] = False,
    form: Annotated[
        ExperimentFormat, typer.Option("--format", "-f", help="How to write the result down.")
    ] = ExperimentFormat.text,
    output: Annotated[
        str | None,
        typer.Option(
            "--output",
            "-o",
            metavar="PATH",
            help="A report too (.html, .pdf), or the picture of the law (.svg, .png).",
        ),
    ] = None,
    plan: Annotated[
        bool, typer.Option("--plan", help="Plan angles and trials at a wall; takes no table.")
    ] = False,
    e: Annotated[
        float | None, typer.Option("--e", metavar="E", help="What is expected, with --plan.")
    ] = None,
    trials: Annotated[
        int | None, typer.Option("--trials", metavar="N", help="With --plan; else 10.")
    ] = None,
    seed: Annotated[
        int | None, typer.Option("--seed", metavar="S", help="Of the simulation, with --plan.")
    ] = None,
) -> None:
    """Find e from one table, or plan how to measure it."""
    with _refusing():
        if plan:
            others = (data, kind, speed_error, from_normal or None, output)
            planning = Planning(e, angle_error, trials, seed, form)
            raise typer.Exit(experimenting.plan(planning, others))
        experimenting.require_no_plan(e, trials, seed)
    if data is None:
        raise typer.BadParameter("a table is missing, or --plan", param_hint="DATA.csv")
    asked = Experimenting(
        data,
        None if kind is None else kind.value,
        angle_error,
        speed_error,
        from_normal,
        form,
        output,
    )
    with interruptible(), _refusing():
        status = experimenting.experiment(asked)
    raise typer.Exit(status)


# --- practise ---------------------------------------------------------------------------------


@app.command(help=_PRACTISE)
def practise(
    topic: Annotated[
        str | None, typer.Argument(metavar="[TOPIC]", help="Else the next one for you.")
    ] = None,
    level: Annotated[
        int | None, typer.Option(min=1, max=4, help="1, the easiest, to 4; else what suits you.")
    ] = None,
    seed: Annotated[
        int | None, typer.Option(metavar="N", min=0, help="Which question; else any.")
    ] = None,
    mistake: Annotated[
        str | None, typer.Option(metavar="ID", help="One in which this mistake shows most.")
    ] = None,
    topics: Annotated[bool, typer.Option("--topics", help="List the topics.")] = False,
    like: Annotated[
        str | None,
        typer.Option(metavar="FILE", help="Vary the numbers of this statement."),
    ] = None,
    output: Annotated[
        str | None,
        typer.Option(
            "--output", "-o", metavar="FILE", help="Write the statement; - is standard output."
        ),
    ] = None,
    state: Annotated[
        str | None, typer.Option(metavar="FILE", help="Where what you did is kept.")
    ] = None,
) -> None:
    """Ask questions, and mark what is typed."""
    from restitution.cli import practising

    if topics:
        practising.list_topics()
        return
    if like is not None and (topic is not None or level is not None):
        raise typer.BadParameter(
            "a question like another has its topic and its level", param_hint="--like"
        )
    asked = practising.Practising(topic, level, seed, like, output, state, mistake)
    with _refusing(), interruptible():
        status = practising.practise(asked)
    raise typer.Exit(status)


# --- check, examples, language ----------------------------------------------------------------


def _complete_mistake(incomplete: str) -> list[str]:
    from restitution.explaining.misconceptions import MISCONCEPTIONS

    return [name for name in MISCONCEPTIONS if name.startswith(incomplete)]


@app.command(help=_CHECK)
def check(
    files: _Files,
    json: Annotated[
        bool, typer.Option("--json", help="One object in JSON for each file, one a line.")
    ] = False,
) -> None:
    """Read every file, and count what it says."""
    from restitution.export import contract

    worst = 0
    with interruptible():
        for file in files:
            text = b""
            try:
                text = read(file)
                problem = parse(text)
            except RestitutionError as error:
                worst = UNREADABLE
                if json:
                    typer.echo(contract.to_json(contract.checked(shown_name(file), None, error)))
                    continue
                for message in pointed(file, text, error):
                    say(message)
                continue
            if json:
                typer.echo(contract.to_json(contract.checked(shown_name(file), problem, None)))
                continue
            for note in problem.notes:
                say("\n".join([f"{shown_name(file)}: warning: {note}", *hint(text, note)]))
            typer.echo(f"{shown_name(file)}: {_summary(problem)}")
    raise typer.Exit(worst)


@app.command(help=_MISTAKES)
def mistakes(
    name: Annotated[
        str | None,
        typer.Argument(metavar="[ID]", help="Tell of this one.", autocompletion=_complete_mistake),
    ] = None,
) -> None:
    """List the mistakes, or tell of one."""
    from restitution.cli.files import terminal_width
    from restitution.explaining.listing import about_mistake, all_mistakes

    try:
        columns = terminal_width()
        text = all_mistakes(columns) if name is None else about_mistake(name, columns)
    except StatementError as error:
        say(error.message)
        raise typer.Exit(UNREADABLE) from None
    typer.echo(text, nl=False)


@app.command(help=_MARK)
def mark(
    context: typer.Context,
    question: Annotated[
        str, typer.Argument(metavar="QUESTION", help="A statement; - is standard input.")
    ],
    working: Annotated[
        str | None,
        typer.Argument(
            metavar="[WORKING]", help="A script, a folder of scripts, or - for standard input."
        ),
    ] = None,
    part: Annotated[
        str | None, typer.Option(metavar="LABEL", help="The part that the working is of.")
    ] = None,
    letters: Annotated[
        str | None, typer.Option(metavar="FILE", help="What the letters of the working mean.")
    ] = None,
    answers: Annotated[
        list[str] | None,
        typer.Option("--answer", metavar="TEXT", help="An answer alone; may be repeated."),
    ] = None,
    hints: Annotated[
        int, typer.Option(metavar="0..4", min=0, max=4, help="How much is said of a line.")
    ] = 1,
    form: Annotated[
        MarkingFormat, typer.Option("--format", "-f", help="How to write the marking down.")
    ] = MarkingFormat.text,
    csv: Annotated[bool, typer.Option("--csv", help="A table: a row for each script.")] = False,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="PATH", help="- is standard output.")
    ] = "-",
    time_limit: _TimeLimit = TIME_LIMIT,
) -> None:
    """Mark the workings of one question."""
    from restitution.cli.marking import Scripts
    from restitution.cli.marking import mark as marked
    from restitution.export.marking import Workings

    columns = min(shutil.get_terminal_size().columns, 100)
    kind: Literal["text", "json", "html", "csv"] = "csv" if csv else form.value
    task = Workings((), tuple(answers or ()), part, "", hints, kind, columns)
    with _refusing(), interruptible(), worker_of(context.obj) as worker:
        done = marked(worker, Scripts(question, working, letters, task), _limit(time_limit))
        for message in done.messages:
            say(message)
        if done.content is not None:
            write_file(output, done.content.encode(), [question])
    raise typer.Exit(done.status)


@app.command(help=_TRACE)
def trace(
    context: typer.Context,
    file: Annotated[
        str,
        typer.Argument(metavar="FILE", help="A file that holds a statement; - is standard input."),
    ],
    stage: Annotated[Stage, typer.Option(help="Which stage to print.")] = Stage.derivation,
    time_limit: _TimeLimit = TIME_LIMIT,
) -> None:
    """Print a stage of one file."""
    from restitution.export.job import Tracing

    with interruptible(), worker_of(context.obj) as worker:
        done = answer(worker, file, Tracing(stage.value), _limit(time_limit))
    for message in done.messages:
        say(message)
    if done.content is not None:
        typer.echo(done.content, nl=False)
    raise typer.Exit(done.status)


def _summary(problem: Problem) -> str:
    from restitution.problem import Find, Show

    steps = [step for _, step in problem.steps()]
    counts = [
        (len(problem.spheres), "sphere"),
        (len(problem.walls), "wall"),
        (len(problem.points), "point"),
        (len(problem.events), "event"),
    ]
    asked = sum(
        len(step.items) if isinstance(step, Find) else 1
        for step in steps
        if isinstance(step, Find | Show)
    )
    parts = ", ".join(counted(number, noun) for number, noun in counts if number)
    question = f"{counted(asked, 'item')} asked" if asked else "nothing is asked"
    return f"reads well: {parts}; {question}" if parts else f"reads well: {question}"


def _complete_example(incomplete: str) -> list[str]:
    from restitution import examples

    return [name for name in examples.names() if name.startswith(incomplete)]


@app.command("examples", help=_EXAMPLES)
def show_examples(
    name: Annotated[
        str | None,
        typer.Argument(metavar="[NAME]", help="Print this one.", autocompletion=_complete_example),
    ] = None,
) -> None:
    """List the examples by topic, name and title, or print one."""
    from restitution import examples
    from restitution.examples.topics import TOPICS

    if name is None:
        longest = max(len(each) for each in examples.names())
        for topic, names in TOPICS.items():
            typer.echo(topic)
            for each in names:
                typer.echo(f"  {each:<{longest}}  {examples.title(each)}")
        return
    try:
        typer.echo(examples.text(name), nl=False)
    except StatementError as error:
        say(error.message)
        raise typer.Exit(UNREADABLE) from None


@app.command()
def language() -> None:
    """Print the reference of the language."""
    text = _reference()
    if sys.stdout.isatty():
        from rich.console import Console
        from rich.markdown import Markdown

        console = Console()
        with console.pager(styles=True) if shutil.which("less") else nothing():
            console.print(Markdown(text), width=min(console.width, 100))
    else:
        typer.echo(text, nl=False)


def _reference() -> str:
    """The page ``docs/language.md``, which a wheel carries inside the package."""
    package = Path(__file__).parents[1]
    inside = package / "language" / "reference.md"
    checkout = package.parents[1] / "docs" / "language.md"
    return (inside if inside.exists() else checkout).read_text(encoding="utf-8")
