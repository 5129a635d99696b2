"""A class at the page at once: nobody loses an answer, and every answer is the right one.

How long they take is measured by ``benchmarks/web.py``; here no time is asserted.
"""

from __future__ import annotations

import json
from contextlib import AbstractContextManager
from dataclasses import replace
from itertools import count
from types import SimpleNamespace
from typing import Any
from unittest import mock

import pytest
from crowd import crowd
from loops import completed
from serving import serving

from restitution import examples
from restitution.export import contract
from restitution.language import parse
from restitution.solving import solve
from restitution.web import Settings, api, work
from restitution.web.work import Payload

ORDINARY = ("corner", "two-spheres-with-vectors", "rejected-root", "find-e-at-a-wall", "bank-shot")
# No worker begins with it, so that it is not at hand.
SLOW = examples.text("both-moving-at-angles").replace("title ", "title Slow: ", 1)


def explained(statement: str, limit: float, early: str | None = None) -> Payload:
    """As the page has it; but over a question called slow each look at a clock takes an hour."""
    if "title Slow: " not in statement:
        return work.explained(statement, limit, early)
    clock = SimpleNamespace(monotonic=count(step=3600).__next__)
    with mock.patch("restitution.work.time", clock):
        return work.explained(statement, limit, early)


def ordinary() -> AbstractContextManager[str]:
    """A server for a class, which gives up what is slow and nothing else."""
    return serving(Settings(workers=2, time_limit=60))


def narrow() -> AbstractContextManager[str]:
    """A server that has little room: one process, three places."""
    return serving(Settings(workers=1, waiting=3, patience=2.0, time_limit=60))


def answer(name: str) -> dict:
    """What is right, found in this process."""
    found = contract.solved("statement", solve(parse(examples.text(name))))
    return json.loads(contract.to_json(found))


@pytest.fixture(autouse=True)
def slow(monkeypatch: pytest.MonkeyPatch) -> None:
    """One question is slow."""
    monkeypatch.setattr(api, "_EXPLAINING", replace(api._EXPLAINING, function=explained))


def kinds(shown: dict[str, Any]) -> list[str | None]:
    """Why the items have no answers."""
    items = [item for part in shown["answer"]["parts"] for item in part["items"]]
    return [item["error"] and item["error"]["kind"] for item in items]


@pytest.mark.timeout(300)
def test_a_class_loses_no_answer():
    """While others hold connections open for nothing, and more go away without their answers."""
    right = {name: answer(name) for name in ORDINARY}
    statements = {**{name: examples.text(name) for name in ORDINARY}, "slow": SLOW}
    names = [ORDINARY[number % len(ORDINARY)] for number in range(198)]
    with ordinary() as served:
        report = completed(
            crowd(served, statements, [*names, "slow", "slow"], 3, 0.2, idle=500, leaving=100)
        )
    assert report.lost == []
    assert len(report.answers) == 200
    for name, shown in report.answers:
        if name == "slow":
            assert set(kinds(shown)) == {"time limit"}
        else:
            assert shown["answer"] == right[name]
    assert report.health


def test_whoever_is_told_to_wait_and_waits_is_answered():
    right = {name: answer(name) for name in ORDINARY}
    statements = {name: examples.text(name) for name in ORDINARY}
    names = [ORDINARY[number % len(ORDINARY)] for number in range(24)]
    with narrow() as address:
        report = completed(crowd(address, statements, names, within=0.2))
    assert report.lost == []
    assert report.waits > 0
    assert all(shown["answer"] == right[name] for name, shown in report.answers)


def test_what_takes_too_long_says_so_and_harms_nobody():
    statements = {"slow": SLOW, "corner": examples.text("corner")}
    with narrow() as address:
        report = completed(crowd(address, statements, ["slow", "corner"], within=0.1))
    assert report.lost == []
    told = dict(report.answers)
    assert set(kinds(told["slow"])) == {"time limit"}
    assert told["corner"]["answer"] == answer("corner")
