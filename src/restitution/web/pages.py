"""The pages and the files that belong to them."""

from __future__ import annotations

import hashlib
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from starlette.requests import Request
from starlette.responses import HTMLResponse
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

from restitution import examples
from restitution.web.words import vocabulary

_FOLDERS = {
    "player": Path(str(files("restitution.export.player"))),
    "": Path(str(files("restitution.web"))) / "static",
}

_FIRST = "two-spheres-with-vectors"
"""The example that a first visit shows."""


def _digest() -> str:
    """A name for just these files: what it names can be kept for ever."""
    seen = hashlib.sha256()
    for folder in _FOLDERS.values():
        for path in sorted(folder.rglob("*")):
            if path.suffix in {".js", ".css", ".svg", ".woff2"}:
                seen.update(path.read_bytes())
    return seen.hexdigest()[:12]


def _told() -> dict[str, Any]:
    """What the page has to know of the language, and of what this server can do."""
    return {"words": vocabulary(), "sheet": find_spec("typst") is not None}


def routes() -> list[BaseRoute]:
    """The pages; all addresses in them are relative, so that they may stand under any path."""
    static = f"static/{_digest()}"
    environment = Environment(
        loader=PackageLoader("restitution.web"),
        autoescape=select_autoescape(default=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )

    def page(name: str, **more: Any) -> Route:
        text = environment.get_template(f"{name}.html").render(static=static, here=name, **more)

        async def show(request: Request) -> HTMLResponse:
            return HTMLResponse(text)

        return Route("/" if name == "solve" else f"/{name}", show, name=name)

    return [
        page("solve", told=_told(), example=examples.text(_FIRST).partition("\n#=")[0].strip()),
        page("lab"),
        *(
            Mount(f"/{static}" + (f"/{name}" if name else ""), StaticFiles(directory=folder))
            for name, folder in _FOLDERS.items()
        ),
    ]
