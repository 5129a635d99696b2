"""Open the page."""

from __future__ import annotations

from dataclasses import replace
from typing import Annotated

import typer

from restitution.cli.files import say
from restitution.cli.statuses import UNREADABLE
from restitution.errors import RestitutionError

SERVE = """Open the page: state an impact, see it, play with it.

\b
    restitution serve
    restitution serve --port 9000 --no-browser

Needs the extra "web": pip install 'restitution[web]'. Ctrl-C ends it.
"""


def serve(
    host: Annotated[
        str,
        typer.Option(
            metavar="ADDRESS", help="Where to listen: this machine alone, or 0.0.0.0 for all."
        ),
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="0 takes any that is free.")] = 8765,
    browser: Annotated[
        bool, typer.Option("--browser/--no-browser", help="Open the page in the browser.")
    ] = True,
    workers: Annotated[
        int | None,
        typer.Option(
            metavar="N", min=1, max=256, help="Processes that solve; else one more than processors."
        ),
    ] = None,
    time_limit: Annotated[
        float, typer.Option(metavar="SECONDS", min=0.5, max=600, help="For each question.")
    ] = 10.0,
    trusted: Annotated[
        list[str] | None,
        typer.Option(
            "--trusted-host",
            metavar="NAME",
            help="A name under which the page is asked for, beside those of this machine.",
        ),
    ] = None,
) -> None:
    """Serve the page."""
    try:
        from restitution.web import Settings
        from restitution.web.serving import serve as run
    except ModuleNotFoundError as error:
        missing = (error.name or "").partition(".")[0]
        if missing == "restitution":
            raise
        say(f"the page needs {missing}: pip install 'restitution[web]'")
        raise typer.Exit(UNREADABLE) from None
    names = tuple(name.lower() for name in trusted or ())
    settings = Settings(time_limit=time_limit, hosts=names)
    if workers is not None:
        settings = replace(settings, workers=workers)
    try:
        run(host, port, settings, say, browser)
    except RestitutionError as error:
        say(error.message)
        raise typer.Exit(UNREADABLE) from None
