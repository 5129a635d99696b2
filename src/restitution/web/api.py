"""The API: a statement in, JSON out."""

from __future__ import annotations

import asyncio
import gzip
import hashlib
import json
import logging
import time
from collections.abc import AsyncIterator, Awaitable, Callable, Mapping
from dataclasses import field
from pathlib import Path
from typing import Any

from starlette.exceptions import HTTPException
from starlette.requests import ClientDisconnect, Request
from starlette.responses import JSONResponse, Response, StreamingResponse
from starlette.routing import Route

from restitution.experiments.records import KINDS
from restitution.killable import LostError
from restitution.records import dataclass
from restitution.web import work
from restitution.web.asking import Kind, RefusedError, asked
from restitution.web.files import unpacks
from restitution.web.pool import BusyError, Pool
from restitution.web.replies import Replies
from restitution.web.settings import Settings
from restitution.web.work import Payload

_log = logging.getLogger(__name__)

_METHODS = ["GET", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"]

_CHECKING = 5.0
"""Seconds for reading a statement: its length is limited, so that it takes far less."""


@dataclass(frozen=True)
class Staff:
    """Processes that do the work: ``clerks`` read statements while ``solvers`` are busy.

    In the folder ``desk`` lies what is finished of work under way.
    """

    settings: Settings
    solvers: Pool
    clerks: Pool
    replies: Replies
    desk: Path


@dataclass(frozen=True)
class _Begun:
    """A reply of which the first part is there: what a page shows before the working."""

    early: bytes
    rest: asyncio.Future[Payload]


@dataclass(frozen=True)
class _Task:
    """A function of `work`: it takes what it is about, a limit, and what else may be told.

    Of that, by name: its type, or the texts of which it is one, and what it is unless it is told.
    A reply that is not ``kept`` is forgotten at once: it holds what a student typed.
    """

    function: Callable[..., Payload]
    optional: Mapping[str, tuple[Kind, Any]] = field(default_factory=dict)
    about: str = "statement"
    kept: bool = True


_STYLES = ("fm1", "m4", "caie", "none")

_OF_A_TABLE: Mapping[str, tuple[Kind, Any]] = {
    "kind": (KINDS, None),
    "angle_error": (int | float, None),
    "speed_error": (int | float, None),
    "from_normal": (bool, False),
}

_TASKS = {
    "solve": _Task(
        work.solved, {"part": (str, None), "working": (bool, False), "marks": (_STYLES, "fm1")}
    ),
    "draw": _Task(work.drawn, {"event": (int, None)}),
    "sheet": _Task(
        work.on_a_sheet,
        {
            "solutions": (bool, False),
            "diagrams": (bool, True),
            "title": (str, None),
            "room": (bool, True),
            "marks": (_STYLES, "fm1"),
        },
    ),
    "simulate": _Task(work.simulated, about="scene"),
    "statement": _Task(work.put_as_a_question, about="impact"),
    "mark": _Task(
        work.marked,
        {
            "working": (str, ""),
            "part": (str, None),
            "letters": (dict, None),
            "hints": (int | dict, 0),
        },
        kept=False,
    ),
    "mistake": _Task(work.played_mistake, {"mistake": (str, ""), "part": (str, None)}),
    "practise": _Task(work.to_practise, about="wanted", kept=False),
    "progress": _Task(work.progress, about="record", kept=False),
    "experiment": _Task(work.experiment, _OF_A_TABLE, about="data", kept=False),
    "report": _Task(work.report, _OF_A_TABLE, about="data", kept=False),
}


_READ: Mapping[str, Callable[[str], Payload]] = {"check": work.checked, "outline": work.outlined}

_EXPLAINING = _Task(work.explained)

_UNASKED = 0.08
"""Seconds in which much work is done: until then nobody looks what is finished of it."""

_OFTEN = 0.1
"""The share of the time so far after which somebody looks again."""

_SELDOM = 0.1
"""Seconds between two looks, at most."""


def routes() -> list[Route]:
    """The routes of the API."""
    return [
        Route("/health", _health),
        *(Route(f"/api/{name}", _reading(read), methods=["POST"]) for name, read in _READ.items()),
        Route("/api/explain", _explain, methods=["POST"]),
        *(Route(f"/api/{name}", _doing(task), methods=["POST"]) for name, task in _TASKS.items()),
        Route("/api/{path:path}", _unknown, methods=_METHODS),
    ]


async def refused(request: Request, error: Exception) -> Response:
    """A request that the framework refuses."""
    assert isinstance(error, HTTPException)
    kind, message = {
        404: ("not found", f"there is nothing at {request.url.path}"),
        405: ("method", f"{request.url.path} does not take {request.method}"),
    }.get(error.status_code, ("malformed", error.detail))
    return refusal(error.status_code, kind, message, error.headers or {})


async def failed(request: Request, error: Exception) -> Response:
    """A failure of the program; what it was stands in the log of the server."""
    return refusal(500, "internal", "the server failed at this; please report it", {})


def refusal(status: int, kind: str, message: str, headers: Mapping[str, str]) -> Response:
    """A request that is not answered, as JSON."""
    return JSONResponse({"error": {"kind": kind, "message": message}}, status, headers)


async def _health(request: Request) -> Response:
    return JSONResponse({"status": "ok"})


async def _unknown(request: Request) -> Response:
    if request.path_params["path"] in {"explain", *_READ, *_TASKS}:
        raise HTTPException(405, headers={"Allow": "POST"})
    raise HTTPException(404)


def _reading(read: Callable[[str], Payload]) -> Callable[[Request], Awaitable[Response]]:
    """The handler of a request that only reads a statement."""

    async def do(request: Request) -> Response:
        staff: Staff = request.app.state.staff

        async def reply() -> Payload:
            about = await asked(request, "statement", {}, staff.settings)
            reply_ = staff.clerks.run(read, about["statement"], limit=_CHECKING)
            return await _while_wanted(request, reply_)

        return await _answered(request, reply)

    return do


def _doing(task: _Task) -> Callable[[Request], Awaitable[Response]]:
    kinds = {name: kind for name, (kind, _) in task.optional.items()}

    async def do(request: Request) -> Response:
        staff: Staff = request.app.state.staff

        async def reply() -> Payload:
            asked_for = await asked(request, task.about, kinds, staff.settings)
            others = tuple(asked_for.get(name, usual) for name, (_, usual) in task.optional.items())
            key = (task.function.__name__, json.dumps(asked_for, sort_keys=True))
            about = asked_for[task.about]
            if not task.kept:
                return await _while_wanted(request, _worked(staff, task, about, others))
            reply_ = staff.replies.get(key, lambda: _worked(staff, task, about, others))
            return await _while_wanted(request, reply_)

        return await _answered(request, reply)

    return do


async def _explain(request: Request) -> Response:
    staff: Staff = request.app.state.staff
    task = _EXPLAINING

    async def reply() -> Payload | _Begun:
        about = await asked(request, task.about, {"early": bool}, staff.settings)
        statement = about[task.about]
        early = staff.desk / hashlib.sha256(statement.encode()).hexdigest()

        async def once() -> Payload:
            try:
                return await _worked(staff, task, statement, (str(early),))
            finally:
                early.unlink(missing_ok=True)

        reply_ = staff.replies.get((task.function.__name__, statement), once)
        if not about.get("early"):
            return await _while_wanted(request, reply_)
        rest = asyncio.ensure_future(_while_wanted(request, reply_))
        began = time.monotonic()
        try:
            await asyncio.wait({rest}, timeout=_UNASKED)
            while not rest.done():
                if early.exists():
                    return _Begun(early.read_bytes(), rest)
                look = min(_OFTEN * (time.monotonic() - began), _SELDOM)
                await asyncio.wait({rest}, timeout=look)
        except asyncio.CancelledError:
            rest.cancel()
            raise
        return await rest

    return await _answered(request, reply)


async def _worked(staff: Staff, task: _Task, about: Any, others: tuple[Any, ...]) -> Payload:
    """The work done; where its process was lost, what can be said without it."""
    limit = staff.settings.time_limit
    try:
        return await staff.solvers.run(task.function, about, limit, *others, limit=limit)
    except TimeoutError:
        message, late = f"no answer within the time limit of {limit:g} s", True
    except LostError as error:
        if error.details:
            _log.error("%s\n%s", error, error.details)
        message, late = f"internal error: {error}", False
    job = (about, task.function, message, late, others)
    return await staff.clerks.run(work.given_up, *job, limit=_CHECKING)


async def _answered(request: Request, reply: Callable[[], Awaitable[Payload | _Begun]]) -> Response:
    try:
        answer = await reply()
        if isinstance(answer, _Begun):
            # A proxy is not to wait for all of it.
            return StreamingResponse(_lines(request, answer), headers={"X-Accel-Buffering": "no"})
    except RefusedError as error:
        return refusal(error.status, error.kind, error.message, {})
    except BusyError as error:
        message = f"many are asking just now; please ask again in {error.again} s"
        return refusal(503, "busy", message, {"Retry-After": str(error.again)})
    except ClientDisconnect:
        return Response(status_code=400)  # nobody reads it
    except asyncio.CancelledError:
        # The server ends, and waits no longer: whoever asked is told so.
        message = "the server is ending; please ask again"
        return refusal(503, "busy", message, {"Retry-After": "2"})
    except (TimeoutError, LostError) as error:
        _log.error("a statement could not be read: %r", error)
        return refusal(500, "internal", "this statement could not be read; please report it", {})
    if answer.fault:
        _log.error("%s", answer.fault)
    if not answer.packed:
        return Response(answer.content, answer.status, media_type=answer.kind)
    headers = {"Vary": "Accept-Encoding"}
    if not unpacks(request):
        return Response(gzip.decompress(answer.content), answer.status, headers, answer.kind)
    headers["Content-Encoding"] = "gzip"
    return Response(answer.content, answer.status, headers, answer.kind)


async def _lines(request: Request, begun: _Begun) -> AsyncIterator[bytes]:
    """The reply in two lines: what is ready at once, then the whole, or why it does not come."""
    yield begun.early + b"\n"

    async def rest() -> Payload:
        return await begun.rest

    try:
        reply = await _answered(request, rest)
    finally:
        begun.rest.cancel()
    packed = reply.headers.get("Content-Encoding") == "gzip"
    yield gzip.decompress(bytes(reply.body)) if packed else bytes(reply.body)


async def _while_wanted(request: Request, making: Awaitable[Payload]) -> Payload:
    """The result of the work, which is given up when the client has gone."""
    doing = asyncio.ensure_future(making)
    leaving = asyncio.ensure_future(_gone(request))
    try:
        await asyncio.wait({doing, leaving}, return_when=asyncio.FIRST_COMPLETED)
        if not doing.done():
            raise ClientDisconnect
        return await doing
    finally:
        leaving.cancel()
        doing.cancel()


async def _gone(request: Request) -> None:
    while (await request.receive())["type"] != "http.disconnect":
        pass
