"""The command line: ``restitution solve FILE`` and its kin.

Only words and files here: no physics, no algebra. Whatever is heavy is loaded in the process that
solves, or when it is needed.

Exit status: 0; 1 where an item has no answer; 2 where a file could not be read or the command was
not understood; 130 after Ctrl-C.
"""

from __future__ import annotations

import io
import os
import sys
from typing import TYPE_CHECKING, Any

from restitution.cli.statuses import CLOSED, INTERRUPTED, REPORT, UNANSWERED
from restitution.cli.worker import new_worker
from restitution.garbage import collect_seldom

if TYPE_CHECKING:
    from restitution.killable import Worker


def main() -> None:
    """Run the command that the arguments of this process name, and exit with its status."""
    collect_seldom()
    worker: Worker | None = None
    _open_what_is_closed()
    _watch_output()
    try:
        for stream in (sys.stdout, sys.stderr):
            # What cannot be encoded is replaced: an answer is never lost to an alphabet.
            if hasattr(stream, "reconfigure"):
                stream.reconfigure(errors="replace")
        if sys.argv[1:2] in (["solve"], ["draw"], ["sheet"], ["play"]) and not {
            "-h",
            "--help",
        } & set(sys.argv):
            # It loads the algebra while the arguments and the files are read here.
            worker = new_worker()
        from restitution.cli.solving import run_plainly

        if not run_plainly(sys.argv[1:], worker):
            from restitution.cli.commands.app import app

            app(prog_name="restitution", obj=worker)
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        sys.exit(INTERRUPTED)
    except BrokenPipeError:
        _forget_output()  # whoever was reading has gone
        sys.exit(UNANSWERED)
    except OutputError as error:
        _forget_output()
        reason = "it is closed" if 1 in CLOSED else error.strerror
        sys.stderr.write(f"standard output: cannot be written: {reason}\n")
        sys.exit(UNANSWERED)
    except Exception:
        if os.environ.get("RESTITUTION_DEBUG"):
            raise
        sys.stderr.write(f"internal error: a fault of the program; {REPORT}\n")
        sys.exit(UNANSWERED)
    finally:
        if worker is not None:
            worker.close()


def _open_what_is_closed() -> None:
    """Puts something in the place of standard streams that are closed.

    Else the next file that is opened would take their place, and be written to. From a closed
    input nothing can be read, and to a closed output nothing written; messages that nobody can
    see are lost.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        try:
            os.fstat(number)
        except OSError:
            CLOSED.add(number)
            # Each open the wrong way round, so that its use is an error; not so messages.
            flags = os.O_RDONLY if number == 1 else os.O_WRONLY
            opened = os.open(os.devnull, flags)
            if opened != number:
                os.dup2(opened, number)
                os.close(opened)
        if getattr(sys, name) is None:
            mode = "r" if number == 0 else "w"
            setattr(sys, name, open(number, mode, encoding="utf-8", closefd=False))  # noqa: SIM115


class OutputError(OSError):
    """Standard output cannot be written to, and it is not that its reader has gone."""


class _Output(io.FileIO):
    """Standard output, which tells its own failures from those of other files."""

    def write(self, data: Any, /) -> int:
        try:
            return super().write(data)
        except BrokenPipeError:
            raise
        except OSError as error:
            raise OutputError(error.errno, error.strerror) from None


def _watch_output() -> None:
    try:
        watched = sys.stdout.fileno() == 1 and not sys.stdout.isatty()
    except (AttributeError, OSError, ValueError):
        return  # it is something else, put there from outside
    if watched:
        raw = _Output(1, "w", closefd=False)
        kept = sys.stdout.encoding
        sys.stdout = io.TextIOWrapper(io.BufferedWriter(raw), encoding=kept, errors="replace")


def _forget_output() -> None:
    """What standard output still holds goes nowhere, and the process ends in peace."""
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, 1)
    os.close(nowhere)
