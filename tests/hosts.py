"""A bare page of the server's own kind on which one module of the page is tried by itself."""

from __future__ import annotations

import re
from typing import Any

import httpx
from playwright.sync_api import Page, Route

from restitution.web.words import vocabulary

_HTML = """<!DOCTYPE html><html lang="en"><head><meta charset="utf-8"><title>{name}</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="stylesheet" href="{static}/base.css"><link rel="stylesheet" href="{static}/{name}.css">
</head><body><main><h1>{name}</h1><h2>A panel</h2><div id="here"></div></main></body></html>"""


def static_of(served: str) -> str:
    """Where the page's files are, relative to it."""
    found = re.search(r"static/\w+", httpx.get(served + "/", timeout=100).text)
    assert found
    return found[0]


def hosted(page: Page, served: str, name: str, function: str) -> None:
    """Shows ``static/solve/NAME.js`` on a page with its style; what it tells is in ``window.told``.

    ``function`` is the one that mounts it; every call that it makes is kept with its name.
    """
    static = static_of(served)
    policy = httpx.get(served, timeout=100).headers["Content-Security-Policy"]

    def host(route: Route) -> None:
        body = _HTML.format(name=name, static=static)
        guards = {"Content-Security-Policy": policy}
        route.fulfill(body=body, content_type="text/html; charset=utf-8", headers=guards)

    page.route(f"{served}/host", host)
    page.goto(f"{served}/host")
    page.evaluate(
        """async ([address, name, words]) => {
          window.told = [];
          const hear = (what) => (...said) => window.told.push([what, ...said]);
          const module = await import(address);
          module[name](document.getElementById("here"),
            { words, onChoose: hear("chosen"), onStatement: hear("statement") });
        }""",
        [f"{served}/{static}/solve/{name}.js", function, vocabulary()],
    )


def told(page: Page) -> list[list[Any]]:
    """What the module has told."""
    found: list[list[Any]] = page.evaluate("window.told")
    return found
