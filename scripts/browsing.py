"""The page as the command serves it, and a browser to look at it with."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

BROWSERS = ("chromium", "chromium-browser", "google-chrome")

# Without a sandbox it runs in containers too; it opens nothing but pages of this package.
ARGUMENTS = ("--no-sandbox",)


def browser() -> str | None:
    """Where the machine's own Chromium is, if it has one."""
    return next(filter(None, map(shutil.which, BROWSERS)), None)


@contextmanager
def page() -> Iterator[str]:
    """The address of the page, without a slash at its end, while it is served on a free port."""
    command = [sys.executable, "-m", "restitution", "serve", "--no-browser", "--port", "0"]
    with subprocess.Popen(command, stderr=subprocess.PIPE, text=True) as server:
        try:
            assert server.stderr is not None
            said = server.stderr.readline()
            found = re.search(r"http://\S+", said)
            if found is None:
                raise SystemExit(f"the page could not be served: {said}{server.stderr.read()}")
            yield found[0].rstrip("/")
        finally:
            server.terminate()
