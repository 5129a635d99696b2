"""The program to which every command belongs, and its own help."""

from __future__ import annotations

from typing import Annotated

import typer

from restitution.cli.commands.experiments import EXPERIMENT, experiment
from restitution.cli.commands.page import SERVE, serve
from restitution.cli.commands.pictures import DRAW, PLAY, draw, play
from restitution.cli.commands.practice import MARK, MISTAKES, PRACTISE, mark, mistakes, practise
from restitution.cli.commands.sheets import SHEET, sheet
from restitution.cli.commands.solutions import SOLVE, solve
from restitution.cli.commands.statements import (
    CHECK,
    EXAMPLES,
    TRACE,
    check,
    language,
    show_examples,
    trace,
)

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

_BY_ENDING = {"md": "markdown", "tex": "latex", "txt": "text"}
"""Formats by the endings of the names of their files."""

app = typer.Typer(
    help=_HELP,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    context_settings={
        "help_option_names": ["-h", "--help"],
        "token_normalize_func": lambda name: _BY_ENDING.get(name, name),
    },
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


# In the order of the help.
app.command(help=SOLVE)(solve)
app.command(help=DRAW)(draw)
app.command(help=SHEET)(sheet)
app.command(help=PLAY)(play)
app.command(help=SERVE)(serve)
app.command(help=EXPERIMENT)(experiment)
app.command(help=PRACTISE)(practise)
app.command(help=CHECK)(check)
app.command(help=MISTAKES)(mistakes)
app.command(help=MARK)(mark)
app.command(help=TRACE)(trace)
app.command("examples", help=EXAMPLES)(show_examples)
app.command()(language)
