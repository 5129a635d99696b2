"""The page, served on a free port of this machine while tests ask it."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager

import uvicorn
from starlette.types import ASGIApp

from restitution.web import Settings, create_app
from restitution.web.serving import address_of, config, listening


@contextmanager
def serving(settings: Settings, app: ASGIApp | None = None) -> Iterator[str]:
    """The address of the page, or of another application, without a slash at its end."""
    with listening("127.0.0.1", 0) as door:
        server = uvicorn.Server(config(app or create_app(settings), settings))
        thread = threading.Thread(target=server.run, args=([door],))
        thread.start()
        try:
            while not server.started:
                assert thread.is_alive(), "the server did not start"
                time.sleep(0.02)
            yield address_of(door).rstrip("/")
        finally:
            server.should_exit = True
            thread.join(20)
