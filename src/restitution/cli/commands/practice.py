"""Practise, mark a working, and tell of mistakes."""

from __future__ import annotations

import shutil
from typing import Annotated, Literal

import typer

from restitution.cli.asking import worker_of
from restitution.cli.commands.options import TimeLimit, limit, refusing
from restitution.cli.files import say
from restitution.cli.output import (
    MarkingFormat,
    interruptible,
    write_file,
)
from restitution.cli.solving import TIME_LIMIT
from restitution.cli.statuses import UNREADABLE
from restitution.errors import StatementError

PRACTISE = """Practise: a question in words, your working read and marked, the next question.

\b
    restitution practise
    restitution practise wall-forward --level 2 --seed 7
    restitution practise --topics
    restitution practise --state mine.json
    restitution practise spheres-vectors --seed 3 -o question.impact
    restitution practise --like ball.impact
    restitution practise --like ball.impact --seed 1 -o another.impact

The same topic, level and seed give the same question everywhere. With --state,
the file holds what was done: it chooses the next question by that. Ctrl-C ends.
"""

MISTAKES = """List the mistakes that students make, or tell of one.

\b
    restitution mistakes
    restitution mistakes momentum-sign
    restitution solve ball.impact --as momentum-sign
    restitution play ball.impact --as momentum-sign

Each is a law, or a result, that is altered.
"""

MARK = """Mark a working of a question, line by line.

\b
    restitution mark ball.impact working.txt
    restitution mark ball.impact working.txt --letters letters.txt --hints 3
    restitution mark ball.impact scripts/ --csv > marks.csv
    restitution mark ball.impact --answer "speed(P) = 4.51"

A step a line, as on paper; a line (a) opens a part. A letters file has a line
for each letter: v: component of A along i after. Exit status: 0 marked; 1 the
question has no answer; 2 something cannot be read.
"""


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
        typer.Option(metavar="FILE", help="One like this statement, with other numbers."),
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
    if like is not None and state is not None:
        raise typer.BadParameter("a question like another is kept in no file", param_hint="--state")
    asked = practising.Practising(topic, level, seed, like, output, state, mistake)
    with refusing(), interruptible():
        status = practising.practise(asked)
    raise typer.Exit(status)


def _complete_mistake(incomplete: str) -> list[str]:
    from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS

    return [name for name in MISCONCEPTIONS if name.startswith(incomplete)]


def mistakes(
    name: Annotated[
        str | None,
        typer.Argument(
            metavar="[ID]",
            help="Tell of this one, by id or title.",
            autocompletion=_complete_mistake,
        ),
    ] = None,
) -> None:
    """List the mistakes, or tell of one."""
    from restitution.cli.files import terminal_width
    from restitution.explaining.mistakes.listing import about_mistake, all_mistakes

    try:
        columns = terminal_width()
        text = all_mistakes(columns) if name is None else about_mistake(name, columns)
    except StatementError as error:
        say(error.message)
        raise typer.Exit(UNREADABLE) from None
    typer.echo(text, nl=False)


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
        MarkingFormat | None,
        typer.Option("--format", "-f", help="How to write the marking down; else text."),
    ] = None,
    csv: Annotated[bool, typer.Option("--csv", help="A table: a row for each script.")] = False,
    output: Annotated[
        str, typer.Option("--output", "-o", metavar="PATH", help="- is standard output.")
    ] = "-",
    time_limit: TimeLimit = TIME_LIMIT,
) -> None:
    """Mark the workings of one question."""
    from restitution.cli.marking import Scripts
    from restitution.cli.marking import mark as marked
    from restitution.export.marking import Workings

    columns = min(shutil.get_terminal_size().columns, 100)
    if csv and form is not None:
        raise typer.BadParameter("a table has a form of its own", param_hint="--csv / --format")
    kind: Literal["text", "json", "html", "csv"] = (
        "csv" if csv else (form or MarkingFormat.text).value
    )
    task = Workings((), tuple(answers or ()), part, "", hints, kind, columns)
    with refusing(), interruptible(), worker_of(context.obj) as worker:
        done = marked(worker, Scripts(question, working, letters, task), limit(time_limit))
        for message in done.messages:
            say(message)
        if done.content is not None:
            write_file(output, done.content.encode(), [question])
    raise typer.Exit(done.status)
