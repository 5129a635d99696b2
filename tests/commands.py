"""The command as a test runs it: in this process, which has loaded all, or as one of its own."""

from __future__ import annotations

import gc
import io
import os
import subprocess
import sys
from collections.abc import Mapping
from contextlib import chdir
from functools import cache
from pathlib import Path
from unittest import mock

from restitution.cli import main
from restitution.export import job

COMMAND = (sys.executable, "-m", "restitution")
"""What begins the command as a process of its own."""

_SOLVING = ("solve", "draw", "sheet", "play")

Outcome = tuple[int, str, str]
"""The exit status, and what is written to standard output and to standard error."""


def run(*arguments: object, stdin: bytes = b"", cwd: Path | None = None) -> Outcome:
    """The outcome of a command that runs in this process.

    What solves is a process of its own here too: a copy of this one, so that nothing is loaded
    again. Streams that are closed or full, signals and the environment need ``run_process``.
    """
    _load()
    output, messages = io.BytesIO(), io.BytesIO()
    streams = {
        "argv": ["restitution", *_with_time(arguments)],
        "stdin": io.TextIOWrapper(io.BytesIO(stdin), encoding="utf-8"),
        "stdout": io.TextIOWrapper(output, encoding="utf-8", newline=""),
        "stderr": io.TextIOWrapper(messages, encoding="utf-8", newline=""),
    }
    thresholds = gc.get_threshold()
    status: object = 0
    with mock.patch.multiple(sys, **streams), chdir(cwd or Path.cwd()):
        try:
            main()
        except SystemExit as end:
            status = end.code
        finally:
            gc.set_threshold(*thresholds)
            for name in ("stdout", "stderr"):
                streams[name].flush()
    return _checked(int(status or 0), output.getvalue(), messages.getvalue())


@cache
def _load() -> None:
    """Load what solves, by solving: copies of this process have it then."""
    job.rehearse()


def run_process(
    *arguments: object,
    stdin: bytes = b"",
    cwd: Path | None = None,
    env: Mapping[str, str] | None = None,
) -> Outcome:
    """The outcome of a command that is a process of its own."""
    done = subprocess.run(
        [*COMMAND, *_with_time(arguments)],
        input=stdin,
        capture_output=True,
        check=False,
        timeout=100,
        cwd=cwd,
        env={**os.environ, **(env or {})},
    )
    return _checked(done.returncode, done.stdout, done.stderr)


def _with_time(arguments: tuple[object, ...]) -> list[str]:
    """The arguments, with time enough that nothing is left out for want of it."""
    words = [*map(str, arguments)]
    limited = any(each.startswith("--time-limit") for each in words)
    if words and words[0] in _SOLVING and not limited:
        words[1:1] = ["--time-limit", "50"]
    return words


def _checked(status: int, output: bytes, messages: bytes) -> Outcome:
    assert b"Traceback" not in messages, messages.decode()
    return status, output.decode(), messages.decode()
