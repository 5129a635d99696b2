"""How fast the page is in a browser: ``uv run python benchmarks/page.py``.

Opened: both views with nothing in any cache, when something is seen first, and how much was sent.
Edits: each example is put into the editor, then its first number is changed, then a comment is
added; the time from the last key to the new answers and the new diagram, and to the whole solution,
with the moment that the page waits for another key. Frames: fifty spheres in the Lab, with arrows
and trails.
"""

from __future__ import annotations

import math
import re
import statistics
from itertools import pairwise
from urllib.parse import urlencode

import web
from playwright.sync_api import Browser, Page, sync_playwright

TURNS = 5
SECONDS = 5.0


def main() -> None:
    with web.browsing.page() as address, sync_playwright() as playwright:
        browser = playwright.chromium.launch(
            executable_path=web.browsing.browser(), args=web.browsing.ARGUMENTS
        )
        print("| opened | first paint, ms | kB in all | kB without the font |")
        print("|---|---:|---:|---:|")
        for name, path in (("Solve", "/"), ("Lab", "/lab")):
            opened(browser, name, f"{address}{path}")
        edits(browser, address)
        frames(browser, address)
        browser.close()


# --- opened ---------------------------------------------------------------------------------------


def opened(browser: Browser, name: str, address: str) -> None:
    """Medians of some times, each in a new browser profile."""
    seen = [_opened(browser, address) for _ in range(TURNS)]
    paint, everything, rest = (statistics.median(column) for column in zip(*seen, strict=True))
    print(f"| {name} | {paint:.0f} | {everything / 1e3:.0f} | {rest / 1e3:.0f} |")


def _opened(browser: Browser, address: str) -> tuple[float, int, int]:
    context = browser.new_context()
    page = context.new_page()
    wire = context.new_cdp_session(page)
    names: dict[str, str] = {}
    sizes: dict[str, int] = {}
    wire.send("Network.enable")
    wire.on(
        "Network.requestWillBeSent", lambda e: names.update({e["requestId"]: e["request"]["url"]})
    )
    wire.on(
        "Network.loadingFinished",
        lambda e: sizes.update({e["requestId"]: e["encodedDataLength"]}),
    )
    page.goto(address)
    page.wait_for_load_state("networkidle")
    paint = page.evaluate("performance.getEntriesByName('first-contentful-paint')[0].startTime")
    context.close()
    fonts = sum(size for key, size in sizes.items() if names[key].endswith(".woff2"))
    everything = sum(sizes.values())
    return paint, int(everything), int(everything - fonts)


# --- edits ----------------------------------------------------------------------------------------

_EDIT = """(text) => new Promise((done) => {
  const area = document.getElementById("statement");
  const results = document.getElementById("results");
  area.value = text;
  area.dispatchEvent(new InputEvent("input", { bubbles: true }));
  const diagram = () => document.querySelector("#pictures figure:not(.aside) img")?.src;
  const before = diagram();
  const began = performance.now();
  let answered = null;
  const settled = () => {
    const isBusy = results.getAttribute("aria-busy") === "true";
    const isNew = !results.classList.contains("stale") && diagram() !== before;
    const now = performance.now() - began;
    if (!isBusy || isNew) answered ??= now;
    if (isBusy) requestAnimationFrame(settled);
    else requestAnimationFrame(() => setTimeout(() => done([answered, now])));
  };
  requestAnimationFrame(settled);
})"""


def changed(text: str) -> str:
    """A statement with its first number that is not 0 or 1 one greater."""
    return re.sub(r"(?<![\w.^/°])[2-9]\d*\b", lambda m: str(int(m[0]) + 1), text, count=1)


def edits(browser: Browser, address: str) -> None:
    page = browser.new_page()
    page.goto(f"{address}/#{urlencode({'statement': 'title Begun'})}")
    page.wait_for_load_state("networkidle")
    kinds = ("put in", "a number changed", "a comment added")
    times: dict[str, list[float]] = {
        f"{kind}, {what}": [] for kind in kinds for what in ("answers and diagram", "all")
    }
    slow: list[tuple[float, str]] = []
    for name, text in web.EXAMPLES.items():
        number = changed(text)
        for kind, edited in zip(kinds, (text, number, f"{number}\n# a comment"), strict=True):
            for what, took in zip(
                ("answers and diagram", "all"), page.evaluate(_EDIT, edited), strict=True
            ):
                times[f"{kind}, {what}"].append(took)
                if (kind, what) == ("a number changed", "answers and diagram"):
                    slow.append((took, name))
    print("\n| key to solution, ms | median | 95 % | 99 % | longest | within 300 |")
    print("|---|---:|---:|---:|---:|---:|")
    for kind, each in times.items():
        within = sum(took <= 300 for took in each) / len(each)
        print(f"| {kind} | {web.figures([took / 1e3 for took in each])} | {within:.0%} |")
    for took, name in sorted(slow, reverse=True)[:12]:
        print(f"    {name}: {took:.0f}")


# --- frames ---------------------------------------------------------------------------------------

_PLAY = """(seconds) => new Promise((done) => {
  const { lab } = document.getElementById("lab");
  const work = [];
  const times = [];
  const draw = lab.draw.bind(lab);
  lab.draw = () => {
    const began = performance.now();
    draw();
    work.push(performance.now() - began);
  };
  lab.clock.play();
  const began = performance.now();
  const tick = (now) => {
    times.push(now);
    if (now - began < 1000 * seconds) requestAnimationFrame(tick);
    else done({ work, times });
  };
  requestAnimationFrame(tick);
})"""


def frames(browser: Browser, address: str) -> None:
    balls = ";".join(
        f"S{n},1,0.08,{0.3 + 0.4 * (n % 10):.2f},{0.3 + 0.4 * (n // 10):.2f},"
        f"{math.cos(n):.3f},{math.sin(n):.3f}"
        for n in range(50)
    )
    walls = "walls=B,0,0,4.2,0,1;R,4.2,0,4.2,2.2,1;T,4.2,2.2,0,2.2,1;L,0,2.2,0,0,1"
    page: Page = browser.new_page(viewport={"width": 1280, "height": 800})
    page.goto(f"{address}/lab#spheres={balls}&{walls}&e=1&seconds=10")
    page.wait_for_load_state("networkidle")
    page.wait_for_function("() => document.getElementById('lab').lab?.known")
    told = page.evaluate(_PLAY, SECONDS)
    times = told["times"]
    rate = 1e3 * (len(times) - 1) / (times[-1] - times[0])
    print("\n| fifty spheres | median | 95 % | longest |\n|---|---:|---:|---:|")
    print(f"| script of a frame, ms | {_tenths(told['work'])} |")
    print(f"| between frames, ms | {_tenths([b - a for a, b in pairwise(times)])} |")
    print(f"\n{rate:.1f} frames a second")


def _tenths(times: list[float]) -> str:
    most = statistics.quantiles(times, n=20)[-1]
    return " | ".join(f"{each:.1f}" for each in (statistics.median(times), most, max(times)))


if __name__ == "__main__":
    main()
