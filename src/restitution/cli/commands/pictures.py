"""Draw the impacts of a question, and play its motion."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import typer

from restitution.cli import solving
from restitution.cli.asking import answer, worker_of
from restitution.cli.commands.options import (
    Mistake,
    TimeLimit,
    content_or_exit,
    form_of,
    limit,
    refusing,
)
from restitution.cli.files import say, shown_name
from restitution.cli.output import (
    PictureFormat,
    interruptible,
    write_file,
)
from restitution.cli.solving import TIME_LIMIT

DRAW = """Draw the impacts of a question to scale.

Before and after each impact, and the path through walls.

\b
    restitution draw ball.impact -o ball.svg
    restitution draw ball.impact -o ball.png --event 2
    restitution examples corner | restitution draw - -o corner.pdf

PNG and PDF need the extra "pdf": pip install 'restitution[pdf]'.
"""

PLAY = """Play the motion of a question in the browser.

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
    time_limit: TimeLimit = TIME_LIMIT,
) -> None:
    """Draw the impacts of one file."""
    from restitution.export.job import Drawing

    form = form_of(output, form, PictureFormat, PictureFormat.svg)
    with interruptible(), worker_of(context.obj) as worker:
        done = answer(worker, file, Drawing(event), limit(time_limit))
        for message in done.messages:
            say(message)
        if done.content is None:
            raise typer.Exit(done.status)
        content = done.content.encode()
        if form is not PictureFormat.svg:
            from restitution.drawing.convert import converted

            kind: Literal["png", "pdf"] = "png" if form is PictureFormat.png else "pdf"
            content = content_or_exit(lambda: converted(done.content, kind))
        with refusing():
            write_file(output, content, [file])
    raise typer.Exit(done.status)


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
    mistake: Mistake = None,
    time_limit: TimeLimit = TIME_LIMIT,
) -> None:
    """Write the page that plays the motion of one file."""
    from restitution.export.job import Playing

    named = output is not None
    if output is None:
        stem = "standard-input" if file == "-" else Path(file).name.removesuffix(".impact")
        output = f"{stem}-motion.html"
    if mistake is not None:
        with refusing():
            mistake = solving.require_mistake(mistake)
    if show and output == "-":
        raise typer.BadParameter("a page that is opened needs a file", param_hint="--open")
    with interruptible(), worker_of(context.obj) as worker:
        done = answer(worker, file, Playing(part, mistake), limit(time_limit))
        for message in done.messages:
            say(message)
        if done.content is None:
            raise typer.Exit(done.status)
        with refusing():
            write_file(output, done.content.encode(), [file])
    if not named:
        say(f"{shown_name(output)}: written; open it in a browser")
    if show:
        import webbrowser

        webbrowser.open(Path(output).resolve().as_uri())
    raise typer.Exit(done.status)
