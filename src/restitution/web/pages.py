"""The pages and the files that belong to them."""

from __future__ import annotations

from collections.abc import Awaitable, Callable
from importlib.resources import files
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from restitution.examples.topics import TOPICS
from restitution.practice.questions.topics import TOPICS as PRACTICE
from restitution.web.files import digest, files_of, imported, stored
from restitution.web.guides import GUIDES
from restitution.web.words import vocabulary

_FOLDERS = {
    "player": Path(str(files("restitution.export.player"))),
    "": Path(str(files("restitution.web"))) / "static",
}

_HTML = "text/html; charset=utf-8"
_FOR_EVER = "public, max-age=31536000, immutable"
_ASK = "no-cache"  # a browser asks each time whether what it keeps is still so

GHOST = """\
title Two spheres collide
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find velocity(A), velocity(B)
"""
"""A whole statement, which an empty editor shows in grey."""

_KINDS = {
    "wall": "One wall",
    "walls": "Two walls",
    "spheres": "Two spheres",
    "chain": "Spheres, then a wall",
}
"""What may happen in a question that the form writes."""


def _form() -> dict[str, Any]:
    """What the page has to know of the language, and of what this server can do."""
    return {"words": vocabulary(), "sheet": find_spec("typst") is not None}


def _topics() -> list[tuple[str, list[tuple[str, str]]]]:
    """The topics of practice by group, in order: the id and the title of each."""
    groups: dict[str, list[tuple[str, str]]] = {}
    for topic in PRACTICE:
        groups.setdefault(topic.group, []).append((topic.id, topic.title))
    return list(groups.items())


def routes() -> list[Route]:
    """The pages; all addresses in them are relative, so that they may stand under any path."""
    files = files_of(_FOLDERS)
    name = digest(files)
    environment = Environment(
        loader=PackageLoader("restitution.web"),
        autoescape=select_autoescape(default=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    # Fetched at once, and not each after the one that needs it.
    environment.globals["modules"] = lambda main: imported(files, main)

    def written(template: str, up: str = "", **more: Any) -> bytes:
        static = f"{up}static/{name}"
        page = environment.get_template(f"{template}.html")
        return page.render(static=static, here=template, home=up or "./", **more).encode()

    def page(template: str, **more: Any) -> Route:
        kept = stored(written(template, **more), _HTML)

        async def show(request: Request) -> Response:
            return kept.reply(request, _ASK)

        return Route("/" if template == "solve" else f"/{template}", show)

    def guide(address: str) -> Route:
        title, content = GUIDES[address].rendered()
        more = {"title": title, "content": content, "name": address, "guides": GUIDES}
        kept = stored(written("guide", "../", **more), _HTML)

        async def show(request: Request) -> Response:
            return kept.reply(request, _ASK)

        return Route(f"/guides/{address}", show)

    async def file(request: Request) -> Response:
        path = request.path_params["path"]
        if path not in files:
            return await missing(request)
        # A page that was opened before an upgrade asks by the old name: better these than none.
        current = request.path_params["digest"] == name
        return files[path].reply(request, _FOR_EVER if current else _ASK)

    async def missing(request: Request) -> Response:
        up = "../" * (request.url.path.count("/") - 1)
        return stored(written("missing", up), _HTML).reply(request, "no-store", 404)

    def without_slash(name: str) -> Callable[[Request], Awaitable[Response]]:
        async def redirect(request: Request) -> Response:
            return Response(status_code=308, headers={"Location": f"../{name}"})

        return redirect

    return [
        page(
            "solve",
            told=_form(),
            ghost=GHOST.strip(),
            kinds=_KINDS,
            topics={topic: names[0] for topic, names in TOPICS.items()},
        ),
        page("lab"),
        Route("/lab/", without_slash("lab")),
        page("practise", groups=_topics()),
        Route("/practise/", without_slash("practise")),
        page("experiment", served={"sheet": find_spec("typst") is not None}),
        Route("/experiment/", without_slash("experiment")),
        *map(guide, GUIDES),
        Route("/static/{digest}/{path:path}", file),
        Route("/{path:path}", missing),
    ]
