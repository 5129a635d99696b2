"""Solve questions."""

from __future__ import annotations

import os
from typing import Annotated

import typer

from restitution.cli import solving
from restitution.cli.commands.options import Files, MarkStyle, Mistake, TimeLimit, refusing
from restitution.cli.output import (
    Format,
    Marks,
)
from restitution.cli.solving import TIME_LIMIT, Solving

SOLVE = """Solve questions and write down the working.

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


def solve(
    context: typer.Context,
    files: Files,
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
    marks: MarkStyle = Marks.fm1,
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
    mistake: Mistake = None,
    time_limit: TimeLimit = TIME_LIMIT,
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
    with refusing():
        status = solving.solve(asked, context.obj)
    raise typer.Exit(status)
