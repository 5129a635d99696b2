"""A class at the page: many clients, each of whom opens it, types, and asks, within some time."""

from __future__ import annotations

import asyncio
import json
import random
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import httpx


@dataclass
class Report:
    """What became of everyone: answers by statement, seconds, and how often they were told to wait.

    ``lost`` says of each request without an answer what came instead.
    """

    answers: list[tuple[str, Any]] = field(default_factory=list)
    seconds: list[float] = field(default_factory=list)
    checks: list[float] = field(default_factory=list)
    health: list[float] = field(default_factory=list)
    waits: int = 0
    lost: list[str] = field(default_factory=list)


async def crowd(
    address: str,
    statements: Mapping[str, str],
    names: Sequence[str],
    within: float,
    own: float = 2 / 3,
    *,
    idle: int = 0,
    leaving: int = 0,
) -> Report:
    """A client for each of the names of statements, all of them begun ``within`` so many seconds.

    Beside them so many connections stay ``idle`` in the midst of a header, and so many clients ask
    and are ``leaving`` at once.

    A share of them adds a comment of its own, so that nobody else asks just the same; the others
    have what the whole class was told to type. Health is asked for four times a second throughout.
    """
    report = Report()
    draw = random.Random(17)
    # A connection for each question: one that is kept may be let go by the server, after 5 s, just
    # as the next question goes into it, which on a busy machine does happen.
    limits = httpx.Limits(max_connections=None, max_keepalive_connections=0)
    async with httpx.AsyncClient(base_url=address, timeout=120, limits=limits) as client:
        beside = [asyncio.create_task(_idle(address)) for _ in range(idle)]
        beside.append(asyncio.create_task(_probe(client, report)))
        gone = [
            _gone(address, draw.uniform(0, within), f"{statements[names[0]]}\n# gone: {number}\n")
            for number in range(leaving)
        ]
        students = []
        for number, name in enumerate(names):
            text = statements[name]
            if draw.random() < own:
                text += f"\n# {number}\n"
            students.append(_student(client, draw.uniform(0, within), name, text, report))
        await asyncio.gather(*students, *gone)
        for each in beside:
            each.cancel()
        ended = await asyncio.gather(*beside, return_exceptions=True)
        report.lost += [repr(each) for each in ended if isinstance(each, Exception)]
    return report


async def _idle(address: str) -> None:
    """Somebody who begins a header and never ends it, and comes back when that is over."""
    while True:
        reader, writer = await _connected(address)
        try:
            writer.write(b"POST /api/explain HTTP/1.1\r\nHost: localhost\r\nX-")
            with suppress(ConnectionError):
                await reader.read()
        finally:
            writer.close()


async def _gone(address: str, start: float, text: str) -> None:
    """A client that asks and does not wait."""
    await asyncio.sleep(start)
    _, writer = await _connected(address)
    body = json.dumps({"statement": text}).encode()
    head = (
        "POST /api/explain HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n"
        f"Content-Length: {len(body)}\r\n\r\n"
    )
    writer.write(head.encode() + body)
    await writer.drain()
    writer.close()


async def _connected(address: str) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
    host, port = address.removeprefix("http://").split(":")
    return await asyncio.open_connection(host, int(port))


async def _student(
    client: httpx.AsyncClient, start: float, name: str, text: str, report: Report
) -> None:
    await asyncio.sleep(start)
    try:
        page = await client.get("/")
        page.raise_for_status()
        half = text[: len(text) // 2]
        for typed in (half, text):
            began = time.perf_counter()
            await _asked(client, "check", typed, report)
            report.checks.append(time.perf_counter() - began)
        began = time.perf_counter()
        answer = await _asked(client, "explain", text, report)
        report.seconds.append(time.perf_counter() - began)
        report.answers.append((name, answer.json()))
    except (httpx.HTTPError, ValueError) as error:
        report.lost.append(f"{name}: {error!r}")


async def _asked(client: httpx.AsyncClient, what: str, text: str, report: Report) -> httpx.Response:
    """The answer, after as many refusals as there are."""
    while True:
        reply = await client.post(f"/api/{what}", json={"statement": text})
        if reply.status_code != 503:
            return reply.raise_for_status()
        report.waits += 1
        await asyncio.sleep(int(reply.headers["Retry-After"]))


async def _probe(client: httpx.AsyncClient, report: Report) -> None:
    while True:
        began = time.perf_counter()
        (await client.get("/health")).raise_for_status()
        report.health.append(time.perf_counter() - began)
        await asyncio.sleep(0.25)
