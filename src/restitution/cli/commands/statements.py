"""Read statements, trace them, and print examples and the reference."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from restitution.cli.asking import answer, worker_of
from restitution.cli.commands.options import Files, TimeLimit, limit
from restitution.cli.files import hint, parse, pointed, read, say, shown_name
from restitution.cli.output import (
    Stage,
    interruptible,
    nothing,
)
from restitution.cli.solving import TIME_LIMIT
from restitution.cli.statuses import UNREADABLE
from restitution.counting import counted
from restitution.errors import RestitutionError, StatementError

if TYPE_CHECKING:
    from restitution.problem import Problem

CHECK = """Read statements without solving them.

What is wrong with them is said, with its place, and the line as it might be meant.

\b
    restitution check ball.impact
    restitution check ball.impact --json

In JSON each mistake has the edits that would mend it.
"""

TRACE = """Print a stage of a question on its way to the answers.

For developers and the curious: the statement as it was read, the equations that
its parts ask of the story, or the lines of the working with their moves.

\b
    restitution trace ball.impact --stage tree
    restitution trace ball.impact --stage equations
    restitution examples corner | restitution trace - --stage derivation
"""

EXAMPLES = """List the examples, or print one.

\b
    restitution examples
    restitution examples corner
    restitution examples corner | restitution solve -
"""


def check(
    files: Files,
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


def trace(
    context: typer.Context,
    file: Annotated[
        str,
        typer.Argument(metavar="FILE", help="A file that holds a statement; - is standard input."),
    ],
    stage: Annotated[Stage, typer.Option(help="Which stage to print.")] = Stage.derivation,
    time_limit: TimeLimit = TIME_LIMIT,
) -> None:
    """Print a stage of one file."""
    from restitution.export.job import Tracing

    with interruptible(), worker_of(context.obj) as worker:
        done = answer(worker, file, Tracing(stage.value), limit(time_limit))
    for message in done.messages:
        say(message)
    if done.content is not None:
        typer.echo(done.content, nl=False)
    raise typer.Exit(done.status)


def _summary(problem: Problem) -> str:
    from restitution.problem import count_of_items

    counts = [
        (len(problem.spheres), "sphere"),
        (len(problem.walls), "wall"),
        (len(problem.points), "point"),
        (len(problem.events), "event"),
    ]
    asked = sum(count_of_items(step) for _, step in problem.steps())
    parts = ", ".join(counted(number, noun) for number, noun in counts if number)
    question = f"{counted(asked, 'item')} asked" if asked else "nothing is asked"
    return f"reads well: {parts}; {question}" if parts else f"reads well: {question}"


def _complete_example(incomplete: str) -> list[str]:
    from restitution import examples

    return [name for name in examples.names() if name.startswith(incomplete)]


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
        longest = max(len(name) for name in examples.names())
        for topic, names in TOPICS.items():
            typer.echo(topic)
            for example in names:
                typer.echo(f"  {example:<{longest}}  {examples.title(example)}")
        return
    try:
        typer.echo(examples.text(name), nl=False)
    except StatementError as error:
        say(error.message)
        raise typer.Exit(UNREADABLE) from None


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
    package = Path(__file__).parents[2]
    inside = package / "language" / "reference.md"
    checkout = package.parents[1] / "docs" / "language.md"
    return (inside if inside.exists() else checkout).read_text(encoding="utf-8")
