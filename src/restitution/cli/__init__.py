"""The command line: ``restitution solve FILE`` and its kin.

Only words and files here: no physics, no algebra. Whatever is heavy is loaded in the process that
solves, or when it is needed.

Exit status: 0; 1 where an item has no answer; 2 where a file could not be read or the command was
not understood; 130 after Ctrl-C.
"""

from __future__ import annotations

import gc
import os
import sys
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from restitution.killable import Worker

UNANSWERED = 1
UNREADABLE = 2
INTERRUPTED = 130

REPORT = "please report this, with the statement"


def main() -> None:
    """Run the command that the arguments of this process name, and exit with its status."""
    # Loading makes many objects and no garbage: looking for it at every turn takes a tenth of the
    # time until the first answer.
    gc.set_threshold(50_000, 20, 20)
    worker: Worker | None = None
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
            worker = _early_worker()
        from restitution.cli.commands import app

        app(prog_name="restitution", obj=worker)
    except KeyboardInterrupt:
        sys.stderr.write("interrupted\n")
        sys.exit(INTERRUPTED)
    except Exception as error:
        if os.environ.get("RESTITUTION_DEBUG"):
            raise
        said = " ".join(f"{type(error).__name__}: {error}".split())[:200]
        sys.stderr.write(f"internal error: {said}; {REPORT}\n")
        sys.exit(UNANSWERED)
    finally:
        if worker is not None:
            worker.close()


def _early_worker() -> Worker:
    from restitution.export.job import prepare, serve
    from restitution.killable import Worker

    return Worker(serve, prepare)
