"""Set questions on a sheet."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from restitution.cli.asking import answer, worker_of
from restitution.cli.commands.options import (
    MarkStyle,
    TimeLimit,
    content_or_exit,
    form_of,
    limit,
    refusing,
)
from restitution.cli.files import say
from restitution.cli.output import (
    Marks,
    SheetFormat,
    interruptible,
    progress,
    silent,
    write_file,
)
from restitution.cli.solving import TIME_LIMIT
from restitution.errors import StatementError

if TYPE_CHECKING:
    from restitution.export.sheet import Entry, Options
    from restitution.render.document import Document

SHEET = """Set questions on a sheet to print.

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
            " with --solutions or the mark scheme.",
        ),
    ] = None,
    marks: MarkStyle = Marks.fm1,
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
        int | None,
        typer.Option(metavar="S", min=0, help="Which versions, with --variants; else from 1 on."),
    ] = None,
    experiment: Annotated[
        bool,
        typer.Option("--experiment", help="A worksheet of the experiment with a wall; no files."),
    ] = False,
    trials: Annotated[
        int | None,
        typer.Option(metavar="N", help="Rows of its table, with --experiment; else 8."),
    ] = None,
    time_limit: TimeLimit = TIME_LIMIT,
) -> None:
    """Set the questions of all files on one sheet."""
    from restitution.export.sheet import DEFAULT_TITLE, Options

    form = form_of(output, form, SheetFormat, SheetFormat.pdf)
    if experiment:
        if files or scheme or variants is not None:
            message = "a worksheet takes no files, no --scheme and no --variants"
            raise typer.BadParameter(message, param_hint="--experiment")
        _write_worksheet(output, form, title, solutions, trials)
        raise typer.Exit
    if trials is not None:
        raise typer.BadParameter("this needs --experiment", param_hint="--trials")
    if seed is not None and variants is None:
        raise typer.BadParameter("this needs --variants", param_hint="--seed")
    seed = 1 if seed is None else seed
    if not files:
        raise typer.BadParameter("a file is missing, or --experiment", param_hint="FILE...")
    options = Options(solutions, diagrams, space, marks.value, scheme)
    if variants is not None and output == "-":
        raise typer.BadParameter("versions need a file each", param_hint="--variants")
    worst = 0
    with interruptible(), worker_of(context.obj) as worker:
        from restitution.export.job import Setting

        def entries_of(options: Options, number: int | None = None) -> list[Entry | None]:
            """The questions; those of a version keep their numbers where one is left out."""
            nonlocal worst
            entries: list[Entry | None] = []
            version = None if number is None else seed + number - 1
            shown = progress(files) if len(files) > 1 else silent
            with shown(output == "-") as progressing:
                for place, file in enumerate(progressing(files), 1):
                    task = Setting(options, version)
                    done = answer(worker, file, task, limit(time_limit))
                    worst = max(worst, done.status)
                    if done.content is not None or number is not None:
                        entries.append(done.content)
                    lead = f"version {number}: question {place} left out: "
                    for line, message in enumerate(done.messages):
                        left_out = number is not None and done.content is None and line == 0
                        if version in (None, seed) or done.status:
                            say(lead + message if left_out else message)
            return entries

        if variants is None:
            entries = entries_of(options)
            if not entries:
                raise typer.Exit(worst)
            _write_sheet(output, entries, title, options, form, files)
        for number in range(1, (variants or 0) + 1):
            entries = entries_of(replace(options, scheme=True), number)
            if not any(entries):
                raise typer.Exit(worst)
            named = f"{title or DEFAULT_TITLE}, version {number}"
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

    try:
        rows = USUAL_TRIALS if trials is None else trials
        document = worksheet(rows, solutions=solutions, title=title)
    except StatementError as error:
        raise typer.BadParameter(error.message, param_hint="--trials") from None
    _write(output, document, form, [])


def _numbered(output: str, ending: str) -> str:
    """The name of a file with an ending before its suffix."""
    path = Path(output)
    return str(path.with_name(f"{path.stem}{ending}{path.suffix}"))


def _write_sheet(
    output: str,
    entries: list[Entry | None],
    title: str | None,
    options: Options,
    form: SheetFormat,
    files: list[str],
) -> None:
    """One sheet, put together and written."""
    from restitution.export.sheet import to_document

    _write(output, to_document(entries, title, options), form, files)


def _write(output: str, document: Document, form: SheetFormat, files: list[str]) -> None:
    """A document in its form; ``files`` are those that it was made of."""
    from restitution.render.document.html import to_html
    from restitution.render.document.typst import to_pdf

    pdf = form is SheetFormat.pdf
    content = content_or_exit(lambda: to_pdf(document)) if pdf else to_html(document).encode()
    with refusing():
        write_file(output, content, files)
