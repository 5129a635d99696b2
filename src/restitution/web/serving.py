"""Running the page on this machine."""

from __future__ import annotations

import errno
import logging
import os
import signal
import socket
import sys
import threading
import time
import webbrowser
from collections.abc import Callable, Collection
from contextlib import suppress
from dataclasses import replace
from typing import Any, NoReturn

import uvicorn
from starlette.types import ASGIApp

from restitution.errors import UnsupportedError
from restitution.web.app import create_app
from restitution.web.door import Door, at
from restitution.web.safety import LOOPBACK
from restitution.web.settings import Settings

_PARTING = 3
"""Seconds that requests under way may still take when the server is told to end."""

_LATER = 5.0
"""Seconds by which a connection outlives the time for its request: the application tells first."""

_FILES = 8192
"""Open files that are wished for, each connection being one."""


def serve(
    host: str, port: int, settings: Settings, say: Callable[[str], None], browser: bool
) -> None:
    """Serve the page until the process is told to end, by Ctrl-C or SIGTERM; then exit with 0.

    Once it can be asked for, ``say`` is told its address, and the browser opened if wanted. On an
    address of this machine alone it answers only to the names of this machine, and to those in
    ``settings.hosts``; on any other to these, or where there are none, to every name.

    Raises UnsupportedError where nothing can be served at that address.
    """
    if host in LOOPBACK:
        settings = replace(settings, hosts=(*LOOPBACK, *settings.hosts))
    _wish_for_files()
    with listening(host, port) as door:
        server = uvicorn.Server(config(create_app(settings), settings))
        address = address_of(door)

        def greet() -> None:
            while not server.started:
                time.sleep(0.02)
            say(f"The page is at {address} (Ctrl-C ends it).")
            if host not in LOOPBACK:
                say(reach(door, settings.hosts))
            if browser:
                webbrowser.open(address)

        threading.Thread(target=greet, daemon=True).start()
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, _end)  # uvicorn heeds them itself, and passes them on in the end
        # Whoever ends the server need not be told which requests were under way.
        quiet = logging.getLogger("uvicorn.error")
        quiet.addFilter(lambda _: not server.should_exit)
        server.run([door])


def config(app: ASGIApp, settings: Settings) -> uvicorn.Config:
    """How the application is served, wherever that is."""
    files = _files()
    backlog = min(512, files // 8)
    # So many may be accepted before the door has seen the first: files never run out.
    most = files - 4 * backlog - 64
    door = Door(settings.connections, most, settings.arriving + _LATER)
    return uvicorn.Config(
        app,
        http=at(door),
        backlog=backlog,
        ws="none",
        lifespan="on",
        log_level="warning",
        access_log=False,
        server_header=False,
        proxy_headers=False,
        timeout_graceful_shutdown=_PARTING,
    )


def _files() -> int:
    """How many files this process may have open."""
    try:
        import resource
    except ImportError:  # not on Windows, where an event loop knows no more than 512
        return 512
    soft, _ = resource.getrlimit(resource.RLIMIT_NOFILE)
    return _FILES if soft == resource.RLIM_INFINITY else min(soft, _FILES)


def _wish_for_files() -> None:
    """Let this process have more files open, as far as the system allows that."""
    try:
        import resource
    except ImportError:
        return
    soft, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    wanted = _FILES if hard == resource.RLIM_INFINITY else min(hard, _FILES)
    if soft != resource.RLIM_INFINITY and soft < wanted:
        with suppress(ValueError, OSError):
            resource.setrlimit(resource.RLIMIT_NOFILE, (wanted, hard))


def address_of(door: socket.socket) -> str:
    """Where a browser on this machine finds what listens there."""
    host, port = door.getsockname()[:2]
    if host in ("0.0.0.0", "::"):
        host = "localhost"
    return f"http://[{host}]:{port}/" if ":" in host else f"http://{host}:{port}/"


def reach(door: socket.socket, hosts: Collection[str]) -> str:
    """Who can reach what listens on more than this machine's own address, and under what name."""
    host, port = door.getsockname()[:2]
    if host in ("0.0.0.0", "::"):
        host = _outward(door.family)
    names = hosts or ([f"[{host}]" if ":" in host else host] if host else [])
    where = f", at {' or '.join(f'http://{name}:{port}/' for name in names)}" if names else ""
    return f"Everybody who can reach this machine over its network can use it{where}."


def _outward(family: socket.AddressFamily) -> str | None:
    """The address of this machine in its network, as far as the system tells; nothing is sent."""
    beyond = "192.0.2.1" if family == socket.AF_INET else "2001:db8::1"  # kept free for examples
    with socket.socket(family, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect((beyond, 9))
        except OSError:
            return None
        address: str = probe.getsockname()[0]
        return address


def listening(host: str, port: int) -> socket.socket:
    """A socket that listens there. Raises UnsupportedError where that cannot be."""
    try:
        family, kind, protocol, _, place = socket.getaddrinfo(
            host, port, type=socket.SOCK_STREAM, flags=socket.AI_PASSIVE
        )[0]
        # With its protocol said: else asyncio does not send small replies at once.
        door = socket.socket(family, kind, protocol)
        try:
            if os.name != "nt":
                door.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            door.bind(place)
            door.listen()
        except BaseException:
            door.close()
            raise
        return door
    except (OSError, UnicodeError) as error:
        number = getattr(error, "errno", None)
        if number == errno.EADDRINUSE:
            hint = "another program listens there: choose another with --port, or 0 for any"
        elif number == errno.EACCES:
            hint = "the system does not allow it: choose a port above 1023 with --port"
        else:
            hint = f"it is no address of this machine ({getattr(error, 'strerror', error)})"
        raise UnsupportedError(f"cannot serve at {host}, port {port}: {hint}") from None


def _end(number: int, frame: Any) -> NoReturn:
    sys.exit(0)
