"""Nobody keeps others from the page by connecting and asking for nothing, or by going away."""

from __future__ import annotations

import asyncio
import json
import os
import shlex
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path

import httpx
import pytest
from loops import completed
from serving import serving
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.types import ASGIApp

from restitution.web import Settings, pool
from restitution.web.work import Payload

BODY = (
    b"POST /api/check HTTP/1.1\r\nHost: x\r\nContent-Type: application/json\r\n"
    b"Content-Length: 100000\r\n\r\n"
)
HALF = b"GET / HTTP/1.1\r\nHost: x\r\nX-"
LONG = 30
"""Seconds after which a test gives up to wait; nothing is asserted of how long anything lasts."""


def connected(address: str, first: bytes = b"") -> socket.socket:
    """A connection on which something was sent."""
    host, port = address.removeprefix("http://").split(":")
    connection = socket.create_connection((host, int(port)), timeout=LONG)
    connection.sendall(first)
    return connection


def rest(connection: socket.socket) -> bytes:
    """What comes until the other side has closed it."""
    said = b""
    with connection:
        try:
            while piece := connection.recv(65536):
                said += piece
        except ConnectionResetError:
            pass
    return said


def is_open(connection: socket.socket) -> bool:
    """Whether the other side still holds it."""
    connection.setblocking(False)
    try:
        return connection.recv(1, socket.MSG_PEEK) != b""
    except BlockingIOError:
        return True
    except ConnectionResetError:
        return False


@pytest.fixture
def soon(monkeypatch: pytest.MonkeyPatch) -> None:
    """No connection outlives the time for its request."""
    monkeypatch.setattr("restitution.web.serving._LATER", 0.0)


# --- a deadline -----------------------------------------------------------------------------------


@pytest.mark.usefixtures("soon")
def test_a_header_that_does_not_end_is_refused() -> None:
    with serving(Settings(arriving=0.3), plain) as address:
        said = rest(connected(address, HALF))
        head, _, content = said.partition(b"\r\n\r\n")
        assert head.startswith(b"HTTP/1.1 408 ")
        error = json.loads(content)["error"]
        assert error == {"kind": "too slow", "message": "the request did not come in whole"}
        # Whoever has asked for nothing is answered nothing: browsers connect in advance.
        assert rest(connected(address)) == b""


@pytest.mark.usefixtures("soon")
def test_a_header_that_comes_letter_by_letter_is_refused() -> None:
    with serving(Settings(arriving=0.3), plain) as address:
        first = b"GET / HTTP/1.1\r\nHost: x\r\n\r\n"
        connection = connected(address, first)
        assert connection.recv(12).endswith(b" 200")
        assert dripped(connection, b"GET / HTTP/1.1\r\nHost: x\r\nX-Long: ")


def dripped(connection: socket.socket, first: bytes) -> bool:
    """Whether the other side ends it while letters keep coming."""
    end = time.monotonic() + LONG
    with connection:
        try:
            connection.sendall(first)
            while time.monotonic() < end:
                connection.sendall(b"a")
                time.sleep(0.02)
        except (BrokenPipeError, ConnectionResetError):
            return True
    return False


@pytest.mark.parametrize(
    "head", [BODY, BODY.replace(b"POST /api/check", b"GET /")], ids=["wanted", "unwanted"]
)
def test_a_body_that_does_not_end_is_refused(served_briefly: str, head: bytes) -> None:
    """The page at ``/`` is sent without a look at the body; its connection still ends."""
    assert dripped(connected(served_briefly), head)


def test_a_body_that_stays_away_is_told(served_briefly: str) -> None:
    with connected(served_briefly, BODY + b"{") as connection:
        assert connection.recv(65536).startswith(b"HTTP/1.1 408 ")


@pytest.fixture(scope="module")
def served_briefly() -> Iterator[str]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("restitution.web.serving._LATER", 1.0)
        with serving(Settings(workers=1, arriving=0.5)) as address:
            yield address


@pytest.mark.usefixtures("soon")
def test_a_reply_that_nobody_reads_does_not_take_a_place_for_ever() -> None:
    app = replying(PlainTextResponse(b"a" * 30_000_000))
    with serving(Settings(arriving=0.3, connections=1), app) as address:
        deaf = connected(address, b"GET / HTTP/1.1\r\nHost: x\r\n\r\n")
        assert deaf.recv(12).endswith(b" 200")
        while httpx.get(address, timeout=LONG).status_code == 503:
            time.sleep(0.05)
        deaf.close()


# --- a limit --------------------------------------------------------------------------------------


async def plain(scope, receive, send) -> None:
    """An application without a life of its own."""
    if scope["type"] == "lifespan":
        while (message := await receive())["type"]:
            await send({"type": f"{message['type']}.complete"})
            if message["type"] == "lifespan.shutdown":
                return
    await PlainTextResponse("well")(scope, receive, send)


def replying(response: Response) -> ASGIApp:
    async def app(scope, receive, send) -> None:
        chosen = plain if scope["type"] == "lifespan" else response
        await chosen(scope, receive, send)

    return app


def test_the_longest_idle_go_for_those_who_come() -> None:
    with serving(Settings(connections=20), plain) as address, ExitStack() as stack:
        half = [stack.enter_context(connected(address, HALF)) for _ in range(50)]
        assert httpx.get(address, timeout=LONG).text == "well"
        assert [is_open(each) for each in half] == [False] * 31 + [True] * 19
        # One of those that are left comes to its end after all, and is answered.
        half[-1].setblocking(True)
        half[-1].sendall(b"Late: 1\r\nConnection: close\r\n\r\n")
        assert rest(half[-1]).endswith(b"well")


def test_whoever_finds_no_place_is_told_to_come_again() -> None:
    door = asyncio.Event()
    loops = []

    async def patient(scope, receive, send) -> None:
        if scope["type"] == "lifespan" or Request(scope).url.path == "/quick":
            await plain(scope, receive, send)
            return
        loops.append(asyncio.get_running_loop())
        await door.wait()
        await plain(scope, receive, send)

    with serving(Settings(connections=5), patient) as address, ExitStack() as stack:
        whole = b"GET / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n"
        busy = [stack.enter_context(connected(address, whole)) for _ in range(5)]
        while len(loops) < 5:
            time.sleep(0.01)
        for _ in range(3):  # and those who are told so take no place
            refused = httpx.get(f"{address}/quick", timeout=LONG)
            assert refused.status_code == 503
            assert int(refused.headers["Retry-After"]) >= 1
            assert refused.headers["Connection"] == "close"
            assert "Content-Security-Policy" in refused.headers
            assert refused.json()["error"]["kind"] == "busy"
        loops[0].call_soon_threadsafe(door.set)
        assert all(rest(each).endswith(b"well") for each in busy)
        while (reply := httpx.get(f"{address}/quick", timeout=LONG)).status_code == 503:
            time.sleep(0.01)  # until their ends have been noticed
        assert reply.text == "well"


@pytest.mark.skipif(sys.platform == "win32", reason="limits of POSIX")
def test_many_idle_connections_harm_nobody_where_files_are_few() -> None:
    serve = [sys.executable, "-m", "restitution", "serve", "--no-browser", "--port", "0"]
    command = f"ulimit -n 256; exec {shlex.join([*serve, '--workers', '1'])}"
    with subprocess.Popen(["sh", "-c", command], stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        address = process.stderr.readline().partition("at ")[2].partition("/ (")[0]
        with ExitStack() as stack:
            for _ in range(600):
                stack.enter_context(connected(address, HALF))
            text = "sphere P: velocity 3i\nfind speed(P)\n"
            reply = httpx.post(f"{address}/api/solve", json={"statement": text}, timeout=100)
            assert reply.json()["error"] is None
        process.terminate()
        _, more = process.communicate(timeout=20)
    assert more == ""


@pytest.mark.skipif(sys.platform == "win32", reason="limits of POSIX")
def test_the_server_takes_the_files_that_it_may_have() -> None:
    code = (
        "import resource as r; from restitution.web import serving as s;"
        "_, hard = r.getrlimit(r.RLIMIT_NOFILE); r.setrlimit(r.RLIMIT_NOFILE, (200, hard));"
        "s._wish_for_files(); print(r.getrlimit(r.RLIMIT_NOFILE)[0], hard)"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    soft, hard = map(int, done.stdout.split())
    assert soft == (8192 if hard < 0 else min(hard, 8192))


# --- those who go away ----------------------------------------------------------------------------


def marking(begun: Path) -> Payload:
    """Leaves a file where it has begun."""
    begun.touch()
    return Payload(str(os.getpid()).encode())


def waiting(begun: Path, door: Path) -> Payload:
    """The same, and lasts until there is another file."""
    made = marking(begun)
    while not door.exists():
        time.sleep(0.01)
    return made


def test_nobody_works_for_those_who_have_gone(monkeypatch, tmp_path) -> None:
    monkeypatch.setattr(pool, "_LOADED", "json")
    monkeypatch.setattr(pool, "_ABANDONED", 100.0)
    monkeypatch.setattr(pool, "_LOOKED", 50.0)
    begun, door = tmp_path / "begun", tmp_path / "door"

    async def story() -> None:
        async with pool.pool(1, 50, 100) as work:
            running = asyncio.create_task(work.run(waiting, begun, door, limit=90))
            while not begun.exists():
                await asyncio.sleep(0.01)
            queued = [
                asyncio.create_task(work.run(marking, tmp_path / str(number), limit=90))
                for number in range(50)
            ]
            await asyncio.sleep(0)
            last = asyncio.create_task(work.run(marking, tmp_path / "last", limit=90))
            for each in (running, *queued):
                each.cancel()
            # It had no place, and finds one as soon as the others are missed.
            await asyncio.sleep(0)
            door.touch()
            pid = (await last).content
            assert not list(tmp_path.glob("[0-9]*"))
            # What had begun was let end: its process is still there.
            assert (await work.run(marking, tmp_path / "after", limit=90)).content == pid

    completed(story())


def test_what_goes_on_for_nobody_ends(monkeypatch, tmp_path) -> None:
    monkeypatch.setattr(pool, "_LOADED", "json")
    monkeypatch.setattr(pool, "_ABANDONED", 0.0)
    begun = tmp_path / "begun"

    async def story() -> None:
        async with pool.pool(1, 5, 100) as work:
            running = asyncio.create_task(work.run(waiting, begun, tmp_path / "no", limit=90))
            while not begun.exists():
                await asyncio.sleep(0.01)
            running.cancel()
            assert (await work.run(marking, tmp_path / "next", limit=90)).content

    completed(story())
