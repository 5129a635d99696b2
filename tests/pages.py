"""What tests of pages in a real browser share."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page

SCREENS = ((320, 640), (360, 740), (1280, 800), (1920, 1080))
"""Widths and heights, from a small phone to a projector."""


@contextmanager
def minding(page: Page, own: str) -> Iterator[list[str]]:
    """What the console says in the meantime. In the end nothing may be left that it said, and
    nobody but ``own`` may have been asked for anything."""
    said: list[str] = []
    asked: list[str] = []
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))
    yield said
    assert said == []
    assert [url for url in asked if not url.startswith((own, "blob:", "data:"))] == []


def accessible(page: Page) -> None:
    """Axe finds nothing to blame in the page as it stands."""
    found = Axe().run(page)
    assert found.violations_count == 0, found.generate_report()


def still(page: Page) -> None:
    """Lets some frames be drawn, in which what changes by itself would have changed."""
    page.evaluate(
        """async () => {
          for (let n = 0; n < 6; n += 1) await new Promise(requestAnimationFrame);
        }"""
    )


def too_wide(page: Page) -> bool:
    """Whether the page has to be scrolled sideways."""
    still(page)
    return page.evaluate("() => document.documentElement.scrollWidth > innerWidth")


def enlarge_text(page: Page) -> None:
    """Text of twice its size."""
    page.evaluate("() => { document.documentElement.style.fontSize = '200%'; }")
