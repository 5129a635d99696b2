"""``restitution solve``: its options as a value, and the work.

A command in its usual form is read here as it stands. The library that reads every other form, and
that writes help and complaints, takes longer to load than a statement takes to be read.
"""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from restitution.cli.asking import answer, worker_of
from restitution.cli.files import say, terminal_width
from restitution.cli.output import (
    Format,
    Marks,
    RefusedError,
    interruptible,
    progress,
    silent,
    target_of,
)
from restitution.records import dataclass

if TYPE_CHECKING:
    from restitution.killable import Worker

TIME_LIMIT = 10.0
"""Seconds for each file, where nothing else is said."""

_LONG = {"-f": "--format", "-o": "--output"}
_FIELDS = {
    "--format": "form",
    "--output": "output",
    "--part": "part",
    "--time-limit": "time_limit",
    "--marks": "marks",
    "--route": "route",
    "--as": "mistake",
}
_SWITCHES = {"--answers-only": "answers_only", "--working": "working", "--check": "check"}
_ROUTES = ("1", "2", "3")
_SECONDS = re.compile(r"[0-9]{1,9}(\.[0-9]{1,9})?", re.ASCII)


@dataclass(frozen=True)
class Solving:
    """What ``restitution solve`` is asked to do."""

    files: Sequence[str]
    form: Format = Format.text
    output: str | None = None
    part: str | None = None
    answers_only: bool = False
    time_limit: float = TIME_LIMIT
    marks: Marks = Marks.fm1
    working: bool = False
    route: int = 1
    check: bool = False
    mistake: str | None = None


def plainly(arguments: Sequence[str]) -> Solving | None:
    """What the arguments of ``solve`` ask for, in their usual form; None for any other.

    Usual are files, switches such as ``--answers-only``, and options that are given once, with
    their value as the next argument. What is None is not wrong: it is read by somebody else.
    """
    files: list[str] = []
    values: dict[str, Any] = {}
    left = iter(arguments)
    for argument in left:
        name = _LONG.get(argument, argument)
        if name in _FIELDS:
            value = _value(name, next(left, ""))
            if value is None or _FIELDS[name] in values:
                return None
            values[_FIELDS[name]] = value
        elif name in _SWITCHES:
            values[_SWITCHES[name]] = True
        elif _is_plain(name):
            files.append(name)
        else:
            return None
    return Solving(tuple(files), **values) if files else None


def _value(option: str, text: str) -> Any:
    """The value of an option, or None."""
    if option == "--format":
        return Format(text) if text in set(Format) else None
    if option == "--marks":
        return Marks(text) if text in set(Marks) else None
    if option == "--route":
        return int(text) if text in _ROUTES else None
    if option == "--time-limit":
        return float(text) if _SECONDS.fullmatch(text) else None
    return text if _is_plain(text) else None


def _is_plain(text: str) -> bool:
    """Whether a text is no option, and the same in every encoding."""
    return text == "-" or (text[:1] not in ("", "-") and not re.search("[\ud800-\udfff]", text))


def seconds_of(limit: float) -> float | None:
    """A limit as it was typed, in seconds: None for 0. Raises RefusedError."""
    if not 0 <= limit < 1e6:
        raise RefusedError("a number of seconds, 0 for no limit", "--time-limit")
    return limit or None


def require_together(asked: Solving) -> None:
    """Raises RefusedError for options that do not go together."""
    if asked.working and asked.form is not Format.json:
        raise RefusedError(
            f"the working as data needs --format json; {asked.form.value} has it in words",
            "--working",
        )
    if asked.mistake is not None:
        require_mistake(asked.mistake)
        if asked.form not in (Format.text, Format.json):
            raise RefusedError("the world of a mistake is written as text or json", "--format")
        for option, wanted in (("--working", asked.working), ("--check", asked.check)):
            if wanted:
                raise RefusedError("with --as there is no working", option)
    if asked.answers_only:
        for option, wanted in (("--working", asked.working), ("--check", asked.check)):
            if wanted:
                raise RefusedError("with --answers-only there is no working", option)


def require_mistake(name: str) -> str:
    """The id of a mistake, from its id or title. Raises RefusedError for one that is not there."""
    from restitution.errors import StatementError
    from restitution.explaining.mistakes.misconceptions import misconception, mistake_id

    try:
        misconception(name)
    except StatementError as error:
        raise RefusedError(error.message, "--as") from None
    return mistake_id(name)


def solve(asked: Solving, early: Worker | None) -> int:
    """Solve every file, writing what is said of each as soon as it is known; the exit status.

    Raises RefusedError, before anything is done, for options that do not go together.
    """
    from restitution.export.job import Writing

    require_together(asked)
    files = list(asked.files)
    limit = seconds_of(asked.time_limit)
    target = target_of(asked.output, files, asked.form)
    styled = target.to_terminal and os.environ.get("TERM") != "dumb"
    task = Writing(
        asked.form.value,
        asked.part,
        asked.answers_only,
        terminal_width(),
        styled,
        asked.marks.value,
        asked.working,
        asked.route,
        asked.check,
        None if asked.mistake is None else require_mistake(asked.mistake),
    )
    worst = 0
    with interruptible(), worker_of(early) as worker, target.written():
        shown = progress(files) if len(files) > 1 else silent
        with shown(target.to_terminal) as progressing:
            for file in progressing(files):
                done = answer(worker, file, task, limit)
                worst = max(worst, done.status)
                target.write(file, done.content or "", several=len(files) > 1)
                for message in done.messages:
                    say(message)
    return worst


def run_plainly(arguments: Sequence[str], worker: Worker | None) -> bool:
    """Does what the arguments of a command ask for, and exits; False where it is not done here."""
    # Windows has patterns of names filled in by whoever reads all forms; so are completions made.
    elsewhere = sys.platform == "win32" or "_RESTITUTION_COMPLETE" in os.environ
    asked = None if elsewhere or arguments[:1] != ["solve"] else plainly(arguments[1:])
    if asked is None:
        return False
    try:
        status = solve(asked, worker)
    except RefusedError:
        return False  # nothing was done yet, and it is told with the usage
    sys.exit(status)
