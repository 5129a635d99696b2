"""The examples, for a gallery: what they are, and a small picture of each."""

from __future__ import annotations

import asyncio
import json
import logging

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from restitution import examples
from restitution.examples.topics import TOPICS
from restitution.killable import LostError
from restitution.web.api import Staff, refusal
from restitution.web.files import stored
from restitution.web.pool import BusyError
from restitution.web.work import Payload

_log = logging.getLogger(__name__)
_SVG = "image/svg+xml"
_FOR_A_DAY = "public, max-age=86400"

_PLACEHOLDER = """\
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 40 26" width="40mm" height="26mm" fill="none"\
 stroke="#888" stroke-width=".4"><path d="M12 18h16"/><circle cx="20" cy="14.6" r="3.2"\
 stroke-dasharray="1 .7"/></svg>
"""
"""Stands where no picture can be made."""


def routes() -> list[Route]:
    """``examples.json``, and ``thumbnails/NAME.svg`` for each."""
    # Few at a time: whoever asks for a solution goes first.
    pencil = asyncio.Semaphore(2)

    async def picture(request: Request) -> Response:
        staff: Staff = request.app.state.staff
        name = request.path_params["name"]
        if name not in examples.names():
            raise HTTPException(404)

        async def thumbnail() -> Payload:
            async with pencil:
                return await _thumbnail(staff, name)

        try:
            picture_ = await staff.replies.get((pictured.__name__, name), thumbnail)
        except BusyError as error:
            return refusal(503, "busy", "please ask again", {"Retry-After": str(error.again)})
        kept = "no-store" if picture_.tired else _FOR_A_DAY  # another time more may come of it
        return stored(picture_.content, picture_.kind).reply(request, kept)

    table = stored(_table(), "application/json")

    async def show_table(request: Request) -> Response:
        return table.reply(request, _FOR_A_DAY)

    return [Route("/examples.json", show_table), Route("/thumbnails/{name}.svg", picture)]


def pictured(name: str) -> Payload:
    """In a process of its own: the small picture of an example, or a placeholder for it."""
    from restitution.drawing import thumbnail
    from restitution.drawing.svg import to_svg
    from restitution.errors import RestitutionError
    from restitution.language import parse
    from restitution.solving import solve

    try:
        scene = thumbnail(solve(parse(examples.text(name))))
    except RestitutionError:
        scene = None
    svg = _PLACEHOLDER if scene is None else to_svg(scene)
    return Payload(svg.encode(), _SVG)


async def _thumbnail(staff: Staff, name: str) -> Payload:
    try:
        return await staff.solvers.run(pictured, name, limit=staff.settings.time_limit)
    except (TimeoutError, LostError) as error:
        _log.error("no picture of %s: %r\n%s", name, error, getattr(error, "details", ""))
        return Payload(_PLACEHOLDER.encode(), _SVG, tired=True)


def _table() -> bytes:
    rows = [
        {
            "name": name,
            "title": examples.title(name),
            "topic": topic,
            "statement": examples.statement(name),
        }
        for topic, names in TOPICS.items()
        for name in names
    ]
    return json.dumps({"examples": rows}, ensure_ascii=False).encode()
