"""The Lab's part of the API: scenes to motions, impacts to questions."""

from __future__ import annotations

import json
from collections.abc import Awaitable, Callable
from typing import Any

from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from restitution.errors import RestitutionError
from restitution.web.api import Staff


def routes() -> list[Route]:
    """Where the Lab asks."""
    return [
        Route("/api/simulate", _doing(simulated, "scene"), methods=["POST"]),
        Route("/api/statement", _doing(question, "impact"), methods=["POST"]),
    ]


def simulated(scene: Any) -> str:
    """The motion of a scene as JSON; in a process of its own."""
    from restitution.export import lab

    return json.dumps(lab.simulated(scene), ensure_ascii=False, allow_nan=False)


def question(impact: Any) -> str:
    """The statement of a question as JSON; in a process of its own."""
    from restitution.export import lab

    return json.dumps({"statement": lab.question(impact)}, ensure_ascii=False)


def _doing(function: Callable[[Any], str], what: str) -> Callable[[Request], Awaitable[Response]]:
    async def do(request: Request) -> Response:
        staff: Staff = request.app.state.staff
        told = json.loads(await request.body())
        try:
            made = await staff.solvers.run(function, told[what], limit=10)
        except RestitutionError as error:
            return JSONResponse({"error": {"kind": error.kind, "message": error.message}}, 400)
        return Response(made, media_type="application/json")

    return do
