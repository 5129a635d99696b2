"""A class at the page at once: nobody loses an answer, and every answer is the right one.

How long they take is measured by ``benchmarks/web.py``; here no time is asserted.
"""

from __future__ import annotations

import json
from contextlib import AbstractContextManager

import pytest
from crowd import crowd
from loops import completed
from serving import serving

from restitution import examples
from restitution.export import contract
from restitution.language import parse
from restitution.solve import solve
from restitution.web import Settings

ORDINARY = ("corner", "two-spheres-with-vectors", "rejected-root", "find-e-at-a-wall", "bank-shot")
# Beyond what is solved in the time that this server gives.
SLOW = "\n".join(
    [
        "sphere A: mass 1, velocity a i + b j",
        "sphere B: mass 2, velocity c i + d j",
        "A hits B: along p i + q j, e = f",
        "given speed(A) = speed(B), energy_lost = 1/3 energy(0), deflection(A) = 40°",
        "given deflection(B) = 50°",
        "find a, b, c, d, p, f",
    ]
)


def ordinary() -> AbstractContextManager[str]:
    """A server for a class, which gives up what is slow and nothing else."""
    return serving(Settings(workers=2, time_limit=10))


def narrow(time_limit: float) -> AbstractContextManager[str]:
    """A server that has little room: one process, three places."""
    return serving(Settings(workers=1, waiting=3, patience=2.0, time_limit=time_limit))


def answer(name: str) -> dict:
    """What is right, found in this process."""
    found = contract.solved("statement", solve(parse(examples.text(name))))
    return json.loads(contract.to_json(found))


@pytest.mark.timeout(300)
def test_a_class_loses_no_answer():
    right = {name: answer(name) for name in ORDINARY}
    statements = {**{name: examples.text(name) for name in ORDINARY}, "slow": SLOW}
    names = [ORDINARY[number % len(ORDINARY)] for number in range(198)]
    with ordinary() as served:
        report = completed(crowd(served, statements, [*names, "slow", "slow"], 3, 0.2))
    assert report.lost == []
    assert len(report.answers) == 200
    for name, shown in report.answers:
        assert name == "slow" or shown["answer"] == right[name]
    assert report.health


def test_whoever_is_told_to_wait_and_waits_is_answered():
    right = {name: answer(name) for name in ORDINARY}
    statements = {name: examples.text(name) for name in ORDINARY}
    names = [ORDINARY[number % len(ORDINARY)] for number in range(24)]
    with narrow(60) as address:
        report = completed(crowd(address, statements, names, within=0.2))
    assert report.lost == []
    assert report.waits > 0
    assert all(shown["answer"] == right[name] for name, shown in report.answers)


def test_what_takes_too_long_says_so_and_harms_nobody():
    statements = {"slow": SLOW, "corner": examples.text("corner")}
    with narrow(4) as address:
        report = completed(crowd(address, statements, ["slow", "corner"], within=0.1))
    assert report.lost == []
    told = dict(report.answers)
    items = [item for part in told["slow"]["answer"]["parts"] for item in part["items"]]
    assert len(items) == 6
    # What is too hard is seen by a count of steps, or else the time is over: it is said either way.
    assert {item["error"]["kind"] for item in items} <= {"time limit", "unsupported"}
    assert told["corner"]["answer"] == answer("corner")
