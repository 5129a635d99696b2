"""The API: a statement in, JSON out."""

from __future__ import annotations

import json
from typing import Any

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from restitution.web import work
from restitution.web.pool import Pool
from restitution.web.settings import Settings


async def _health(request: Request) -> Response:
    return JSONResponse({"status": "ok"})


async def _solve(request: Request) -> Response:
    settings: Settings = request.app.state.settings
    pool: Pool = request.app.state.pool
    told: Any = json.loads(await request.body())
    made = await pool.run(
        work.solved, told["statement"], settings.time_limit, limit=settings.time_limit
    )
    return Response(made, media_type="application/json")


def routes() -> list[Route]:
    """Where the API is found."""
    return [
        Route("/health", _health),
        Route("/api/solve", _solve, methods=["POST"]),
    ]
