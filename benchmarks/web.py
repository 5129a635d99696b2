"""How fast the page answers: ``uv run python benchmarks/web.py``.

Edits: every example is asked for with `api/explain`, each time with a comment that nobody has sent
before, so that no reply is at hand. Class: two hundred students within one minute, each of whom
opens the page, types (`api/check`) and asks (`api/explain`), two of them something slow, while five
hundred connections stay in the midst of a header and a hundred clients ask and go away.
"""

from __future__ import annotations

import argparse
import asyncio
import sys
import time
from pathlib import Path
from statistics import median, quantiles

import httpx

from restitution import examples

ROOT = Path(__file__).parents[1]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "scripts")]

import browsing  # noqa: E402
from crowd import crowd  # noqa: E402

EXAMPLES = {name: examples.statement(name) for name in examples.names()}
SLOW = ROOT / "tests/questions/619-unknown-line-from-B-only.impact"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--repeat", type=int, default=3)
    parser.add_argument("--students", type=int, default=200)
    parser.add_argument("--within", type=float, default=60.0, metavar="SECONDS")
    chosen = parser.parse_args()
    with browsing.page() as address:
        edits(address, chosen.repeat)
    with browsing.page() as address:
        lesson(address, chosen.students, chosen.within)


def edits(address: str, repeat: int) -> None:
    """Times of each example; the first of them, and the others."""
    rows = []
    with httpx.Client(base_url=address, timeout=60) as client:
        for name, text in EXAMPLES.items():
            times = [_asked(client, f"{text}\n# {turn}") for turn in range(repeat + 1)]
            rows.append((name, times[0], median(times[1:])))
    print("| edit to reply, ms | median | 95 % | 99 % | longest |\n|---|---:|---:|---:|---:|")
    for title, which in (("first seen", 1), ("edited", 2)):
        times = [row[which] for row in rows]
        print(f"| {title} | {figures(times)} |")
    for name, first, later in sorted(rows, key=lambda row: -row[2])[:8]:
        print(f"| {name} | {later * 1e3:.0f} (first {first * 1e3:.0f}) | | | |")


def _asked(client: httpx.Client, statement: str) -> float:
    began = time.perf_counter()
    client.post("/api/explain", json={"statement": statement}).raise_for_status()
    return time.perf_counter() - began


def lesson(address: str, students: int, within: float) -> None:
    """Times of a whole class."""
    names = [list(EXAMPLES)[number % len(EXAMPLES)] for number in range(students - 2)]
    told = {**EXAMPLES, "slow": SLOW.read_text(encoding="utf-8")}
    asking = crowd(address, told, [*names, "slow", "slow"], within, idle=500, leaving=100)
    report = asyncio.run(asking)
    print(
        f"\n{students} students within {within:g} s: {len(report.answers)} answers, "
        f"{len(report.lost)} lost, {report.waits} told to wait"
    )
    print("| ms | median | 95 % | 99 % | longest |\n|---|---:|---:|---:|---:|")
    for title, times in (
        ("explain", report.seconds),
        ("check", report.checks),
        ("health", report.health),
    ):
        print(f"| {title} | {figures(times)} |")
    for each in report.lost:
        print(each)


def figures(times: list[float]) -> str:
    parts = quantiles(times, n=100)
    chosen = (median(times), parts[94], parts[98], max(times))
    return " | ".join(f"{each * 1e3:.0f}" for each in chosen)


if __name__ == "__main__":
    main()
