"""The application: pages, the API, and what guards them."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from starlette.applications import Starlette

from restitution.web import api, pages
from restitution.web.pool import Pool
from restitution.web.settings import Settings


def create_app(settings: Settings | None = None) -> Starlette:
    """An ASGI application; its processes begin and end with it."""
    chosen = settings or Settings()

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        app.state.settings = chosen
        app.state.pool = Pool(chosen.workers, chosen.waiting)
        try:
            yield
        finally:
            app.state.pool.close()

    return Starlette(routes=[*pages.routes(), *api.routes()], lifespan=life)
