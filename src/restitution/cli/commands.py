"""The commands, their options, and what they say."""

from __future__ import annotations

import os
import shutil
import sys
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, TextIO

import typer

from restitution.cli import INTERRUPTED, REPORT, UNANSWERED, UNREADABLE
from restitution.errors import RestitutionError, StatementError

if TYPE_CHECKING:
    from restitution.export.job import Job, Reply
    from restitution.killable import Worker
    from restitution.problem import Problem


class Format(StrEnum):
    """How a solution is written down."""

    text = "text"
    markdown = "markdown"
    latex = "latex"
    html = "html"
    json = "json"


_ENDINGS = {
    Format.text: ".txt",
    Format.markdown: ".md",
    Format.latex: ".tex",
    Format.html: ".html",
    Format.json: ".json",
}

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

_SOLVE = """Solve the questions in FILES and write down the working.

\b
    restitution solve ball.impact
    restitution solve ball.impact --format html --output ball.html
    restitution solve *.impact --format json > answers.jsonl
    restitution examples corner | restitution solve -

A file that cannot be read does not stop the others. Exit status: 0; 1 if an
item has no answer; 2 if a file could not be read. A "show" that is refuted
is answered.
"""

_CHECK = """Read FILES without solving them, and say what is wrong with them.

\b
    restitution check ball.impact
"""

_EXAMPLES = """List the examples that come with the program, or print one.

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
    time_limit: Annotated[
        float, typer.Option(metavar="SECONDS", help="For each file; 0 is no limit.")
    ] = 10.0,
    debug: Annotated[bool, typer.Option("--debug", hidden=True)] = False,
) -> None:
    """Solve every file, writing what is said of each as soon as it is known."""
    if debug:
        os.environ["RESTITUTION_DEBUG"] = "1"
    if not 0 <= time_limit < 1e6:
        raise typer.BadParameter("a number of seconds, 0 for no limit", param_hint="--time-limit")
    target = _target(output, files, form)
    styled = target.to_terminal and os.environ.get("TERM") != "dumb"
    wanted = _Wanted(form, part, answers_only, time_limit or None, _width(), styled)
    worst = 0
    with _interruptible(), _worker(context.obj) as worker, target.written():
        progress = _progress(files) if len(files) > 1 else _silent
        with progress(target.to_terminal) as each:
            for file in each(files):
                written = _solve_file(worker, file, wanted)
                worst = max(worst, written.status)
                target.write(file, written.text, several=len(files) > 1)
                for message in written.messages:
                    _say(message)
    raise typer.Exit(worst)


def _worker(early: Worker | None) -> Worker:
    """The process that was started with the command, or one of its own."""
    from restitution.export.job import prepare, serve
    from restitution.killable import Worker

    return early or Worker(serve, prepare)


@dataclass(frozen=True)
class _Wanted:
    format: Format
    part: str | None
    answers_only: bool
    limit: float | None
    width: int
    styled: bool


@dataclass(frozen=True)
class _Written:
    """What is said of one file, on standard output and on standard error."""

    status: int
    text: str = ""
    messages: tuple[str, ...] = ()


def _solve_file(worker: Worker, file: str, wanted: _Wanted) -> _Written:
    from restitution.export import contract
    from restitution.export.job import Job, Writing

    json = wanted.format is Format.json
    text = b""
    try:
        text = _read(file)
        problem = _parse(text)
        _require_part(problem, wanted.part)
    except RestitutionError as error:
        line = contract.to_json(contract.unreadable(_name(file), error)) + "\n" if json else ""
        return _Written(UNREADABLE, line, tuple(_pointed(file, text, error)))
    task = Writing(
        wanted.format.value, wanted.part, wanted.answers_only, wanted.width, wanted.styled
    )
    job = Job(_name(file), problem, task, wanted.limit)
    try:
        reply = _ask(worker, job)
    except RestitutionError as error:
        line = (
            contract.to_json(contract.unfinished(job.file, problem, error, wanted.part)) + "\n"
            if json
            else ""
        )
        return _Written(UNANSWERED, line, tuple(_pointed(file, text, error)))
    messages = [f"{job.file}: warning: {warning}" for warning in reply.warnings]
    for missing in reply.errors:
        messages += _pointed(file, text, missing)
    if reply.fault:
        messages.append(
            reply.fault
            if _debugging()
            else f"{job.file}: internal error: {reply.fault.splitlines()[-1]}; {REPORT}"
        )
    return _Written(0 if reply.answered else UNANSWERED, reply.content, tuple(messages))


def _ask(worker: Worker, job: Job) -> Reply:
    """The reply to a job; whatever else happens, as a RestitutionError."""
    from restitution.errors import UnsupportedError
    from restitution.export.job import stopped
    from restitution.killable import LostError

    try:
        reply: Reply = worker.ask(job, job.limit)
    except TimeoutError:
        raise stopped(job.limit) from None
    except LostError as error:
        if _debugging() and error.details:
            _say(error.details)
        raise UnsupportedError(f"internal error: {_one_line(error)}; {REPORT}") from None
    if reply.tired:
        worker.close()
    return reply


def _require_part(problem: Problem, label: str | None) -> None:
    labels = [part.label for part in problem.parts if part.label is not None]
    if label is not None and label not in labels:
        known = f"its parts are {', '.join(labels)}" if labels else "the statement has no parts"
        raise StatementError(f"there is no part {label!r}: {known}")


# --- check, examples, language ----------------------------------------------------------------


@app.command(help=_CHECK)
def check(files: _Files) -> None:
    """Read every file, and count what it says."""
    worst = 0
    with _interruptible():
        for file in files:
            text = b""
            try:
                text = _read(file)
                problem = _parse(text)
            except RestitutionError as error:
                worst = UNREADABLE
                for message in _pointed(file, text, error):
                    _say(message)
                continue
            for warning in problem.warnings:
                _say(f"{_name(file)}: warning: {warning}")
            typer.echo(f"{_name(file)}: {_summary(problem)}")
    raise typer.Exit(worst)


def _summary(problem: Problem) -> str:
    from restitution.problem import Arrival, Find, Impact, Kick, Show

    steps = [step for _, step in problem.steps()]
    counts = [
        (len(problem.spheres), "sphere"),
        (len(problem.walls), "wall"),
        (len(problem.points), "point"),
        (sum(isinstance(step, Impact | Kick | Arrival) for step in steps), "event"),
    ]
    asked = sum(
        len(step.items) if isinstance(step, Find) else 1
        for step in steps
        if isinstance(step, Find | Show)
    )
    said = ", ".join(_counted(number, noun) for number, noun in counts if number)
    question = f"{_counted(asked, 'item')} asked" if asked else "nothing is asked"
    return f"reads well: {said}; {question}" if said else f"reads well: {question}"


def _counted(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"


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
    """List the examples by name and title, or print one."""
    from restitution import examples

    if name is None:
        names = examples.names()
        longest = max(len(each) for each in names)
        for each in names:
            typer.echo(f"{each:<{longest}}  {_title(examples.text(each))}")
        return
    try:
        typer.echo(examples.text(name), nl=False)
    except StatementError as error:
        _say(error.message)
        raise typer.Exit(UNREADABLE) from None


def _title(text: str) -> str:
    lines = (line for line in text.splitlines() if line.startswith("title "))
    return next(lines, "title ").removeprefix("title ").strip()


@app.command()
def language() -> None:
    """Print the reference of the language in which questions are stated."""
    text = _reference()
    if sys.stdout.isatty():
        from rich.console import Console
        from rich.markdown import Markdown

        console = Console()
        with console.pager(styles=True) if shutil.which("less") else _nothing():
            console.print(Markdown(text), width=min(console.width, 100))
    else:
        typer.echo(text, nl=False)


def _reference() -> str:
    """The page ``docs/language.md``, which a wheel carries inside the package."""
    package = Path(__file__).parents[1]
    inside = package / "language" / "reference.md"
    checkout = package.parents[1] / "docs" / "language.md"
    return (inside if inside.exists() else checkout).read_text(encoding="utf-8")


# --- reading ----------------------------------------------------------------------------------


def _read(file: str) -> bytes:
    """The bytes of a file, no more than one beyond what a statement may have.

    Raises StatementError where there is nothing to read.
    """
    from restitution.expression.limits import MAX_TEXT_BYTES

    try:
        if file == "-":
            return sys.stdin.buffer.read(MAX_TEXT_BYTES + 1)
        with Path(file).open("rb") as stream:
            return stream.read(MAX_TEXT_BYTES + 1)
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise StatementError(f"cannot be read: {reason}{_hint(file)}") from None


def _hint(file: str) -> str:
    from restitution import examples

    name = Path(file).name.removesuffix(".impact")
    if name in examples.names():
        return f"; did you mean: restitution examples {name} | restitution solve -"
    return ""


def _parse(text: bytes) -> Problem:
    from restitution.errors import UnsupportedError
    from restitution.language import parse

    try:
        return parse(text)
    except RestitutionError:
        raise
    except Exception as error:
        if _debugging():
            raise
        name = f"{type(error).__name__}: {_one_line(error)}"
        raise UnsupportedError(f"internal error: {name}; {REPORT}") from None


# --- messages ---------------------------------------------------------------------------------


def _pointed(file: str, text: bytes, error: RestitutionError) -> Iterator[str]:
    """The message of an error and of those beside it, with the place in the text."""
    yield "\n".join(_with_place(file, text, error))
    for other in getattr(error, "others", ()):
        yield "\n".join(_with_place(file, text, other))


def _with_place(file: str, text: bytes, error: RestitutionError) -> Iterator[str]:
    place = "".join(f":{n}" for n in (error.line, error.column) if n is not None)
    plain = error.kind == "time limit" or (error.line is None and error.kind == "syntax")
    kind = "" if plain else f"{error.kind}: "
    yield f"{_name(file)}{place}: {kind}{_printable(error.message)}"
    if error.line is None:
        return
    lines = text.decode("utf-8", errors="replace").removeprefix("\ufeff")
    # The same three ends of a line as the language knows, and no others.
    numbered = lines.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    if not 0 < error.line <= len(numbered):
        return
    line = numbered[error.line - 1]
    column = error.column or 0
    first = max(0, column - _SHOWN // 2) if len(line) > _SHOWN else 0
    shown = _printable(line[first : first + _SHOWN])
    yield f"{error.line:>5} | {shown.rstrip()}"
    if column:
        before = shown[: column - 1 - first]
        yield f"      | {' ' * sum(_columns(each) for each in before)}^"


_SHOWN = 72


def _columns(character: str) -> int:
    """How many columns of a terminal a character takes."""
    from unicodedata import combining, east_asian_width

    if combining(character):
        return 0
    return 2 if east_asian_width(character) in "WF" else 1


def _printable(text: str) -> str:
    """Without what a terminal would take for a command."""
    return "".join(
        each if each.isprintable() else " " if each.isspace() else "\N{REPLACEMENT CHARACTER}"
        for each in text
    )


def _name(file: str) -> str:
    return _printable(os.fsencode(file).decode("utf-8", errors="replace"))


def _one_line(error: BaseException) -> str:
    return _printable(" ".join(str(error).split()))[:200]


def _say(message: str) -> None:
    typer.echo(message, err=True)


def _debugging() -> bool:
    return bool(os.environ.get("RESTITUTION_DEBUG"))


def _width() -> int:
    if not sys.stdout.isatty():
        return 80
    return max(40, min(shutil.get_terminal_size().columns, 120))


# --- where it goes ----------------------------------------------------------------------------


@dataclass
class _Target:
    """Standard output, a file, or a folder with a file for each; opened when there is a text."""

    format: Format
    path: Path | None = None
    folder: bool = False
    stream: TextIO | None = None

    @property
    def to_terminal(self) -> bool:
        return self.path is None and sys.stdout.isatty()

    def write(self, file: str, text: str, *, several: bool) -> None:
        """Add what is said of one file. Exits with a message where that cannot be written."""
        if not text:
            return
        if several and not self.folder and self.format in (Format.text, Format.markdown):
            text = (
                f"{'=' * 3} {_name(file)} {'=' * 3}\n\n{text}\n"
                if (self.format is Format.text)
                else f"<!-- {_name(file)} -->\n\n{text}\n"
            )
        try:
            if self.path is None:
                _put(text)
            elif self.folder:
                self.path.mkdir(parents=True, exist_ok=True)
                _in_folder(self.path, file, self.format).write_text(text, encoding="utf-8")
            else:
                if self.stream is None:
                    self.stream = self.path.open("w", encoding="utf-8")
                self.stream.write(text)
                self.stream.flush()
        except BrokenPipeError:
            raise
        except OSError as error:
            _say(f"{error.filename or self.path}: cannot be written: {error.strerror}")
            raise typer.Exit(UNANSWERED) from None

    @contextmanager
    def written(self) -> Iterator[None]:
        try:
            yield
        finally:
            if self.stream is not None:
                self.stream.close()


def _put(text: str) -> None:
    """To standard output, in UTF-8 unless it is a terminal, which knows its own encoding."""
    if not sys.stdout.isatty() and hasattr(sys.stdout, "buffer"):
        sys.stdout.flush()
        sys.stdout.buffer.write(text.encode("utf-8", errors="replace"))
        sys.stdout.buffer.flush()
    else:
        sys.stdout.write(text)
        sys.stdout.flush()


def _target(output: str | None, files: list[str], form: Format) -> _Target:
    """Where the solutions go. Raises BadParameter for what would be lost or unusable."""
    if output is None or output == "-":
        target = _Target(form)
    else:
        folder = output.endswith(("/", os.sep)) or Path(output).is_dir()
        target = _Target(form, Path(output), folder)
    if not target.folder and len(files) > 1 and form in (Format.html, Format.latex):
        raise typer.BadParameter(
            f"several files as {form.value} need a folder: --output FOLDER/",
            param_hint="--output",
        )
    if target.path is not None:
        named = [_in_folder(target.path, file, form) for file in files] if target.folder else []
        for path in named or [target.path]:
            if named.count(path) > 1:
                raise typer.BadParameter(
                    f"{path} would be written more than once", param_hint="--output"
                )
            if any(_same_file(path, file) for file in files):
                raise typer.BadParameter(
                    f"{path} is one of the statements: it would be overwritten",
                    param_hint="--output",
                )
    return target


def _in_folder(folder: Path, file: str, form: Format) -> Path:
    stem = "standard-input" if file == "-" else Path(file).name.removesuffix(".impact")
    return folder / (stem + _ENDINGS[form])


def _same_file(path: Path, file: str) -> bool:
    try:
        return path.samefile(file)
    except (OSError, ValueError):
        return False


_Each = Callable[[Iterable[str]], Iterator[str]]


@contextmanager
def _silent(to_terminal: bool) -> Iterator[_Each]:
    yield iter


def _progress(files: list[str]) -> Any:
    """How far it has come, on standard error, if somebody is looking there."""

    @contextmanager
    def shown(to_terminal: bool) -> Iterator[_Each]:
        from rich.console import Console
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn

        # Drawn by hand and not by a thread, so that a process can be forked at any time.
        progress = Progress(
            TextColumn("{task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            console=Console(stderr=True),
            auto_refresh=False,
            transient=True,
            redirect_stdout=False,
            redirect_stderr=False,
        )
        task = progress.add_task("", total=len(files))

        def each(names: Iterable[str]) -> Iterator[str]:
            for name in names:
                progress.update(task, description=Path(_name(name)).name)
                progress.start()
                progress.refresh()
                try:
                    yield name
                finally:
                    progress.stop()
                progress.advance(task)

        yield each

    return shown if sys.stderr.isatty() else _silent


@contextmanager
def _nothing() -> Iterator[None]:
    yield


@contextmanager
def _interruptible() -> Iterator[None]:
    """Ctrl-C ends the command with one word."""
    try:
        yield
    except KeyboardInterrupt:
        _say("interrupted")
        raise typer.Exit(INTERRUPTED) from None
