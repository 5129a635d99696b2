"""The pages and the files that belong to them."""

from __future__ import annotations

from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from restitution import examples
from restitution.web.files import digest, files_of, imported, stored
from restitution.web.words import vocabulary

_FOLDERS = {
    "player": Path(str(files("restitution.export.player"))),
    "": Path(str(files("restitution.web"))) / "static",
}

_HTML = "text/html; charset=utf-8"
_FOR_EVER = "public, max-age=31536000, immutable"
_ASK = "no-cache"  # a browser asks each time whether what it keeps is still so

_FIRST = "two-spheres-with-vectors"
"""The example that a first visit shows."""


def _told() -> dict[str, Any]:
    """What the page has to know of the language, and of what this server can do."""
    return {"words": vocabulary(), "sheet": find_spec("typst") is not None}


def routes() -> list[Route]:
    """The pages; all addresses in them are relative, so that they may stand under any path."""
    found = files_of(_FOLDERS)
    name = digest(found)
    environment = Environment(
        loader=PackageLoader("restitution.web"),
        autoescape=select_autoescape(default=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    # Fetched at once, and not each after the one that needs it.
    environment.globals["modules"] = lambda main: imported(found, main)

    def written(template: str, up: str = "", **more: Any) -> bytes:
        static = f"{up}static/{name}"
        page = environment.get_template(f"{template}.html")
        return page.render(static=static, here=template, home=up or "./", **more).encode()

    def page(template: str, **more: Any) -> Route:
        kept = stored(written(template, **more), _HTML)

        async def show(request: Request) -> Response:
            return kept.reply(request, _ASK)

        return Route("/" if template == "solve" else f"/{template}", show)

    async def file(request: Request) -> Response:
        path = request.path_params["path"]
        if path not in found:
            return await missing(request)
        # A page that was opened before an upgrade asks by the old name: better these than none.
        current = request.path_params["digest"] == name
        return found[path].reply(request, _FOR_EVER if current else _ASK)

    async def missing(request: Request) -> Response:
        up = "../" * (request.url.path.count("/") - 1)
        return stored(written("missing", up), _HTML).reply(request, "no-store", 404)

    async def without_slash(request: Request) -> Response:
        return Response(status_code=308, headers={"Location": "../lab"})

    return [
        page("solve", told=_told(), example=examples.statement(_FIRST).strip()),
        page("lab"),
        Route("/lab/", without_slash),
        Route("/static/{digest}/{path:path}", file),
        Route("/{path:path}", missing),
    ]
