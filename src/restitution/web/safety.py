"""What guards the pages: who may ask, and headers that tell a browser what it may do with them."""

from __future__ import annotations

from collections.abc import Collection

from starlette.datastructures import Headers, MutableHeaders
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

_POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self'",
        "img-src 'self' blob: data:",
        "font-src 'self'",
        "connect-src 'self'",
        "base-uri 'none'",
        "form-action 'self'",
        "frame-ancestors 'none'",
        "require-trusted-types-for 'script'",
        "trusted-types 'none'",
    )
)

_HEADERS = {
    "Content-Security-Policy": _POLICY,
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Referrer-Policy": "no-referrer",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Permissions-Policy": "camera=(), geolocation=(), microphone=(), payment=(), usb=()",
}

LOOPBACK = ("localhost", "127.0.0.1", "::1")
"""The names of this machine to itself."""


def guarded(app: ASGIApp, hosts: Collection[str]) -> ASGIApp:
    """The application with these headers on every response; what says nothing else is not kept.

    Where ``hosts`` are given, a request under another name is refused: a page from elsewhere
    whose name was bent to this address (DNS rebinding) learns nothing.
    """

    async def serve(scope: Scope, receive: Receive, send: Send) -> None:
        if scope["type"] != "http":
            await app(scope, receive, send)
            return

        async def sent(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in _HEADERS.items():
                    headers[name] = value
                headers.setdefault("Cache-Control", "no-store")
            await send(message)

        name = host_name(Headers(scope=scope).get("host", ""))
        if not hosts or name in hosts:
            await app(scope, receive, sent)
            return
        refusal = "this server is not asked under that name; start it with --trusted-host NAME"
        refused = JSONResponse({"error": {"kind": "host", "message": refusal}}, 421)
        await refused(scope, receive, sent)

    return serve


def host_name(host: str) -> str:
    """The name in a Host header, without its port and the brackets of an IPv6 address."""
    name = host.rsplit(":", 1)[0] if host.rpartition(":")[2].isdecimal() else host
    return name.strip("[]").rstrip(".").lower()
