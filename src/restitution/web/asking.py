"""What a request asks for, read with care: anything at all may come in."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Mapping
from types import UnionType
from typing import Any

from starlette.requests import Request

from restitution.web.settings import Settings


class RefusedError(Exception):
    """A request that is not answered: its HTTP status, what kind of mistake, and a sentence."""

    def __init__(self, status: int, kind: str, message: str) -> None:
        super().__init__(message)
        self.status = status
        self.kind = kind
        self.message = message


Kind = type | UnionType | tuple[str, ...]
"""What something that is told has to be: of a type, of one of two, or one of several texts."""


async def asked(
    request: Request, about: str, optional: Mapping[str, Kind], settings: Settings
) -> dict[str, Any]:
    """The object that a request holds: what it is ``about``, and what else it may hold.

    A statement is a text, so is a table of data; anything else that it may be about is an object.
    Raises RefusedError.
    """
    kind = request.headers.get("content-type", "").split(";")[0].strip().lower()
    if kind != "application/json":
        raise RefusedError(415, "content type", "send JSON, with Content-Type: application/json")
    kinds: dict[str, Kind] = {about: str if about in _TEXTS else dict, **optional}
    fields = _object(await _body(request, settings), about)
    if about not in fields:
        raise RefusedError(400, "malformed", f'the object has no "{about}"')
    for name, value in fields.items():
        wanted = kinds.get(name)
        if wanted is None:
            known = ", ".join(f'"{kind}"' for kind in kinds)
            raise RefusedError(400, "malformed", f"{_short(name)} is not known; known: {known}")
        if isinstance(wanted, tuple):
            if value not in wanted:
                known = ", ".join(f'"{word}"' for word in wanted)
                raise RefusedError(400, "malformed", f'"{name}" has to be one of {known}')
            continue
        # In Python a truth value is a number too.
        if not isinstance(value, wanted) or (isinstance(value, bool) and wanted is not bool):
            raise RefusedError(400, "malformed", f'"{name}" has to be {_NAMES[wanted]}')
    length = len(fields["statement"]) if about == "statement" else 0
    if length > settings.longest:
        message = f"a statement has at most {settings.longest} characters, this one {length}"
        raise RefusedError(413, "too large", message)
    return fields


_TEXTS = ("statement", "data")

_NAMES: Mapping[type | UnionType, str] = {
    str: "a text",
    int: "a whole number",
    int | float: "a number",
    bool: "true or false",
    dict: "an object",
    int | dict: "a whole number or an object",
}


async def _body(request: Request, settings: Settings) -> bytes:
    """The body, read no further than it may be long."""
    largest = settings.largest
    too_large = RefusedError(413, "too large", f"a request has at most {largest} bytes")
    length = request.headers.get("content-length", "0")
    if not length.isdecimal() or int(length[:20]) > largest:
        raise too_large
    body = bytearray()
    try:
        async with asyncio.timeout(settings.arriving):
            async for chunk in request.stream():
                body += chunk
                if len(body) > largest:
                    raise too_large
    except TimeoutError:
        raise RefusedError(408, "too slow", "the request did not come in whole") from None
    return bytes(body)


def _object(body: bytes, about: str) -> dict[str, Any]:
    try:
        content = json.loads(body.decode("utf-8"), parse_constant=_no_number)
        # Half of a character, which JSON lets through, is in no text.
        json.dumps(content, ensure_ascii=False).encode("utf-8")
    except UnicodeError:
        raise RefusedError(400, "malformed", "the request is not UTF-8") from None
    except (ValueError, RecursionError):
        raise RefusedError(400, "malformed", "the request is not JSON") from None
    if not isinstance(content, dict):
        raise RefusedError(400, "malformed", f'send an object: {{"{about}": …}}')
    return content


def _no_number(name: str) -> None:
    raise ValueError(f"{name} is not JSON")


def _short(name: str) -> str:
    return json.dumps(name if len(name) <= 40 else name[:39] + "…")
