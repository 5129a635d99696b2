"""The application: pages, the API, and what guards them."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from importlib import import_module

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.middleware import Middleware
from starlette.middleware.gzip import GZipMiddleware
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import ASGIApp

from restitution.export.job import prepare
from restitution.web import api, gallery, pages, simulating
from restitution.web.pool import Pool
from restitution.web.replies import Replies
from restitution.web.safety import guarded
from restitution.web.settings import Settings

_CLERKS = 1


def create_app(settings: Settings | None = None) -> ASGIApp:
    """An ASGI application; its processes begin and end with it."""
    chosen = settings or Settings()

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        solvers = Pool(chosen.workers, chosen.waiting, chosen.patience, prepare, _LOADED)
        clerks = Pool(_CLERKS, chosen.waiting, chosen.patience, _read, _LOADED)
        app.state.staff = api.Staff(chosen, solvers, clerks, Replies(chosen.kept))
        try:
            yield
        finally:
            solvers.close()
            clerks.close()

    guards = [Middleware(GZipMiddleware, minimum_size=800, compresslevel=5)]
    if chosen.hosts:
        hosts = list(chosen.hosts)
        guards.insert(0, Middleware(TrustedHostMiddleware, allowed_hosts=hosts, www_redirect=False))
    app = Starlette(
        routes=[*pages.routes(), *gallery.routes(), *api.routes(), *simulating.routes()],
        middleware=guards,
        exception_handlers={HTTPException: _refused, Exception: _failed},
        lifespan=life,
    )
    return guarded(app)


_LOADED = (
    "restitution.web.work",
    "restitution.export.working",
    "restitution.export.sheet",
    "restitution.solve",
    "restitution.explain",
)
"""What the processes begin with."""


def _read() -> None:
    import_module("restitution.web.work")


_KINDS = {404: "not found", 405: "method"}


async def _refused(request: Request, error: Exception) -> Response:
    assert isinstance(error, HTTPException)
    path = request.url.path
    said = {
        404: f"there is nothing at {path}",
        405: f"{path} does not take {request.method}",
    }.get(error.status_code, error.detail)
    kind = _KINDS.get(error.status_code, "malformed")
    return api.refusal(error.status_code, kind, said, error.headers or {})


async def _failed(request: Request, error: Exception) -> Response:
    """A failure of the program; what it was stands in the log of the server."""
    message = "the server failed at this; please report it, with the statement"
    return api.refusal(500, "internal", message, {})
