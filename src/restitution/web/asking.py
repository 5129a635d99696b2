"""What a request asks for, read with care: anything at all may come in."""

from __future__ import annotations

import json
from collections.abc import Mapping
from typing import Any

from starlette.requests import Request


class RefusedError(Exception):
    """A request that is not answered: its HTTP status, what kind of mistake, and a sentence."""

    def __init__(self, status: int, kind: str, message: str) -> None:
        super().__init__(message)
        self.status = status
        self.kind = kind
        self.message = message


async def asked(
    request: Request, optional: Mapping[str, type], longest: int, largest: int
) -> dict[str, Any]:
    """The object that a request holds: its statement, and what else it may hold, of that type.

    ``longest`` is in characters of the statement, ``largest`` in bytes of the request. Raises
    RefusedError.
    """
    kind = request.headers.get("content-type", "").split(";")[0].strip().lower()
    if kind != "application/json":
        raise RefusedError(415, "content type", "send JSON, with Content-Type: application/json")
    found = _object(await _body(request, largest))
    if "statement" not in found:
        raise RefusedError(400, "malformed", 'the object has no "statement"')
    for name, value in found.items():
        wanted = str if name == "statement" else optional.get(name)
        if wanted is None:
            known = ", ".join(f'"{each}"' for each in ("statement", *optional))
            raise RefusedError(400, "malformed", f"{_short(name)} is not known; known: {known}")
        # In Python a truth value is a number too.
        if not isinstance(value, wanted) or (wanted is int and isinstance(value, bool)):
            raise RefusedError(400, "malformed", f'"{name}" has to be {_NAMES[wanted]}')
        if isinstance(value, str) and not value.isascii() and not _is_text(value):
            raise RefusedError(400, "malformed", f'"{name}" holds half of a character')
    length = len(found["statement"])
    if length > longest:
        raise RefusedError(
            413, "too large", f"a statement has at most {longest} characters, this one {length}"
        )
    return found


_NAMES = {str: "a text", int: "a whole number", bool: "true or false"}


async def _body(request: Request, largest: int) -> bytes:
    """The body, read no further than it may be long."""
    too_large = RefusedError(413, "too large", f"a request has at most {largest} bytes")
    told = request.headers.get("content-length", "0")
    if not told.isdecimal() or int(told[:20]) > largest:
        raise too_large
    body = bytearray()
    async for chunk in request.stream():
        body += chunk
        if len(body) > largest:
            raise too_large
    return bytes(body)


def _object(body: bytes) -> dict[str, Any]:
    try:
        found = json.loads(body.decode("utf-8"))
    except UnicodeDecodeError:
        raise RefusedError(400, "malformed", "the request is not UTF-8") from None
    except (ValueError, RecursionError):
        raise RefusedError(400, "malformed", "the request is not JSON") from None
    if not isinstance(found, dict):
        raise RefusedError(400, "malformed", 'send an object: {"statement": "…"}')
    return found


def _is_text(value: str) -> bool:
    try:
        value.encode("utf-8")
    except UnicodeEncodeError:
        return False
    return True


def _short(name: str) -> str:
    return json.dumps(name if len(name) <= 40 else name[:39] + "…")
