"""The application: pages, the API, and what guards them."""

from __future__ import annotations

from collections.abc import AsyncIterator
from contextlib import AsyncExitStack, asynccontextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from starlette.applications import Starlette
from starlette.exceptions import HTTPException
from starlette.types import ASGIApp

from restitution.web import api, gallery, pages
from restitution.web.pool import pool
from restitution.web.replies import Replies
from restitution.web.safety import guarded
from restitution.web.settings import Settings

_CLERKS = 1


def create_app(settings: Settings | None = None) -> ASGIApp:
    """An ASGI application; its processes begin and end with it."""
    chosen = settings or Settings()

    @asynccontextmanager
    async def life(app: Starlette) -> AsyncIterator[None]:
        async with AsyncExitStack() as stack:
            solvers, clerks = [
                await stack.enter_async_context(pool(number, chosen.waiting, chosen.patience))
                for number in (chosen.workers, _CLERKS)
            ]
            desk = Path(stack.enter_context(TemporaryDirectory(prefix="restitution-")))
            app.state.staff = api.Staff(chosen, solvers, clerks, Replies(chosen.kept), desk)
            yield

    app = Starlette(
        # The pages come last, as they answer whatever is asked.
        routes=[*api.routes(), *gallery.routes(), *pages.routes()],
        exception_handlers={HTTPException: api.refused, Exception: api.failed},
        lifespan=life,
    )
    app.router.redirect_slashes = False  # a redirection would not know the path that it is under
    return guarded(app, chosen.hosts)
