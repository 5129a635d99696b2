"""Take pictures of every page as phone, laptop and projector show it, in light and dark.

    uv run python scripts/screenshots.py FOLDER [VIEW ...]

Without views it takes all. Pictures are named VIEW-SIZE-SCHEME.png, and ``index.html`` shows them
side by side. It serves the page itself, on a free port.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from html import escape
from pathlib import Path
from typing import Literal
from urllib.parse import urlencode

import browsing
from playwright.sync_api import Browser, Page, ViewportSize, sync_playwright

from restitution import examples

SIZES: dict[str, ViewportSize] = {
    "phone": {"width": 360, "height": 740},
    "laptop": {"width": 1280, "height": 800},
    "projector": {"width": 1920, "height": 1080},
}
SCHEMES: tuple[Literal["light", "dark"], ...] = ("light", "dark")

View = Callable[[Page, str], None]


def main(arguments: list[str]) -> None:
    """Take the pictures that were asked for."""
    if not arguments:
        raise SystemExit(__doc__)
    folder = Path(arguments[0])
    wanted = arguments[1:] or list(VIEWS)
    unknown = [name for name in wanted if name not in VIEWS]
    if unknown:
        raise SystemExit(f"there is no view {unknown[0]!r}, only {', '.join(VIEWS)}")
    folder.mkdir(parents=True, exist_ok=True)
    with browsing.page() as address, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=browsing.browser(), args=browsing.ARGUMENTS
        )
        names = [
            taken(browser, address, folder, view, size, scheme)
            for view in wanted
            for size in SIZES
            for scheme in SCHEMES
        ]
        browser.close()
    figures = "\n".join(
        f'<figure><img src="{escape(name)}" width="600"><figcaption>{escape(name)}</figcaption>'
        "</figure>"
        for name in names
    )
    (folder / "index.html").write_text(f"<!DOCTYPE html>\n{figures}\n", encoding="utf-8")


def taken(
    browser: Browser,
    address: str,
    folder: Path,
    view: str,
    size: str,
    scheme: Literal["light", "dark"],
) -> str:
    """Take one picture of the whole page, and return its name."""
    page = browser.new_page(
        viewport=SIZES[size], color_scheme=scheme, reduced_motion="reduce", device_scale_factor=1
    )
    name = f"{view}-{size}-{scheme}.png"
    try:
        VIEWS[view](page, address)
        page.wait_for_load_state("networkidle")
        page.screenshot(path=folder / name, full_page=True)
    finally:
        page.close()
    print(name, flush=True)
    return name


# --- what is to be seen ---------------------------------------------------------------------------


def at(page: Page, address: str, statement: str) -> None:
    """Solve with a statement in it."""
    page.goto(f"{address}/#{urlencode({'statement': statement})}")
    page.wait_for_load_state("networkidle")


def of_example(name: str) -> View:
    """Solve with an example in it."""
    return lambda page, address: at(page, address, examples.statement(name))


def mistaken(page: Page, address: str) -> None:
    """Solve with mistakes in the statement."""
    at(page, address, "wall W: along i\nsphere P: velocty 5i - 3j\nP hits V\nfind speed(P)\n")


def opened(button: str) -> View:
    """Solve with what a button opens."""

    def view(page: Page, address: str) -> None:
        at(page, address, examples.statement("corner"))
        page.get_by_role("button", name=button).click()

    return view


def at_path(path: str) -> View:
    """A page as it opens."""

    def view(page: Page, address: str) -> None:
        page.goto(f"{address}/{path}")
        page.wait_for_load_state("networkidle")

    return view


def in_the_lab(scene: str, impacts: int = 0) -> View:
    """The Lab with a prepared scene, at its start or at an impact."""

    def view(page: Page, address: str) -> None:
        page.goto(f"{address}/lab#scene={scene}")
        page.wait_for_load_state("networkidle")
        for _ in range(impacts):
            page.keyboard.press("ArrowRight")

    return view


VIEWS: dict[str, View] = {
    "start": lambda page, address: at(page, address, ""),
    "vectors": of_example("two-spheres-with-vectors"),
    "corner": of_example("corner"),
    "rejected": of_example("rejected-root"),
    "parts": of_example("collide-again"),
    "mistakes": mistaken,
    "examples": opened("Examples"),
    "form": opened("Fill in a form"),
    "practise": at_path("practise"),
    "experiment": at_path("experiment"),
    "guides": at_path("guides"),
    "lab": in_the_lab("snooker"),
    "lab-impact": in_the_lab("snooker", 1),
    "lab-corner": in_the_lab("corner", 1),
    "lab-newton": in_the_lab("newton", 2),
    "lab-angles": in_the_lab("angles", 2),
    "lab-gas": in_the_lab("gas", 9),
    "lab-break": in_the_lab("break", 12),
}


if __name__ == "__main__":
    main(sys.argv[1:])
