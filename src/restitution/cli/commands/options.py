"""Options that several commands have, and how they are refused."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from enum import StrEnum
from pathlib import Path
from typing import Annotated, TypeVar

import typer

from restitution.cli.files import say
from restitution.cli.output import (
    Marks,
    RefusedError,
)
from restitution.cli.solving import seconds_of
from restitution.cli.statuses import UNANSWERED
from restitution.errors import RestitutionError

Files = Annotated[
    list[str],
    typer.Argument(metavar="FILE...", help="Files that hold a statement; - is standard input."),
]


@contextmanager
def refusing() -> Iterator[None]:
    """What is refused is told with the usage of the command."""
    try:
        yield
    except RefusedError as error:
        raise typer.BadParameter(error.message, param_hint=error.option) from None


MarkStyle = Annotated[
    Marks,
    typer.Option("--marks", help="Marks as in Further Mechanics 1, in M4, as Cambridge, or none."),
]
TimeLimit = Annotated[float, typer.Option(metavar="SECONDS", help="For each file; 0 is no limit.")]
Mistake = Annotated[
    str | None,
    typer.Option(
        "--as",
        metavar="ID",
        help="In the world of a mistake, by its id; restitution mistakes lists them.",
    ),
]
_F = TypeVar("_F", bound=StrEnum)


def limit(seconds: float) -> float | None:
    """The time limit as it was typed; None where there is none."""
    with refusing():
        return seconds_of(seconds)


def form_of(output: str, form: _F | None, known: type[_F], otherwise: _F) -> _F:
    """The form asked for, or that of a name's ending."""
    if form is not None:
        return form
    if output == "-":
        return otherwise
    ending = Path(output).suffix.removeprefix(".").lower()
    try:
        return known(ending)
    except ValueError:
        forms = ", ".join(f".{known_form.value}" for known_form in known)
        raise typer.BadParameter(
            f"{output}: the name should end in one of {forms}, or --format be given",
            param_hint="--output",
        ) from None


def content_or_exit(make: Callable[[], bytes]) -> bytes:
    """The bytes that ``make`` returns; where it raises, a message and the end of the command."""
    try:
        return make()
    except RestitutionError as error:
        say(error.message)
        raise typer.Exit(UNANSWERED) from None
