"""A letter that facts of one part give a value is a letter again in the next: that is told."""

from __future__ import annotations

import json

import pytest

from restitution.export import contract
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_html, to_text

HEAD = """\
wall W: along i
sphere P: mass 2, velocity 3i - 4j
P hits W
"""
TOLD = "e was found in part (a) from what is given in that part alone; part (b) is in terms of e"


def notes(text):
    return [each for each in solve(parse(HEAD + text)).warnings if "was found in part" in each]


@pytest.mark.parametrize(
    "text",
    [
        "part a\ngiven speed(P) = 4\nfind e\npart b\nfind impulse",
        "part a\ngiven impulse = 12\nfind speed(P)\npart b\nfind energy_lost",
    ],
)
def test_it_is_told(text) -> None:
    assert notes(text) == [TOLD]


@pytest.mark.parametrize(
    "text",
    [
        "given speed(P) = 4\npart a\nfind e\npart b\nfind impulse",
        "part a\ngiven speed(P) = 4\nfind e\npart b\nfind velocity(P, 0)",
        "part a\ngiven speed(P) = 4\nfind e\npart b\ngiven impulse = 12\nfind speed(P)",
        "part a\nfind impulse\npart b\nfind energy_lost",
        "part a\ngiven speed(P) = 4\nfind e, impulse",
        "part a\ngiven e = 1/2\nfind impulse\npart b\nfind impulse",
        "part a\ngiven speed(P) = 4\nfind e\npart b\nfind impulse in terms of e",
        "part a\ngiven speed(P) = 4\nfind e\npart b\nshow impulse = 8(1 + e)",
    ],
)
def test_where_nothing_is_met_again_nothing_is_told(text) -> None:
    assert notes(text) == []


SPHERES = """\
sphere A: mass m, velocity u cos(alpha) i + u sin(alpha) j
sphere B: mass m, velocity -u cos(alpha) i + u sin(alpha) j
A hits B: along i
part a
given velocity(A) perpendicular to velocity(A, 0)
show tan(alpha)^2 = e
part b
"""


@pytest.mark.parametrize(
    "text",
    [
        "given velocity(A) perpendicular to velocity(A, 0)\nshow speed(A) = u sqrt(e)",
        "find velocity(A)",
    ],
)
def test_a_relation_that_is_shown_or_given_again_is_no_value(text) -> None:
    warnings = solve(parse(SPHERES + text)).warnings
    assert not [each for each in warnings if "was found in part" in each]


def test_a_relation_that_is_given_again_holds_again() -> None:
    found = SPHERES.replace("show tan(alpha)^2 = e", "find e in terms of alpha")
    given = "given velocity(A) perpendicular to velocity(A, 0)\nfind speed(A) in terms of u, e"
    warnings = solve(parse(found + given)).warnings
    assert not [each for each in warnings if "was found in part" in each]


def test_it_is_told_once() -> None:
    parts = "part a\ngiven speed(P) = 4\nfind e\npart b\nfind impulse\npart c\nfind energy_lost"
    assert notes(parts) == [TOLD]


def test_it_is_told_in_text_page_and_json() -> None:
    solution = solve(parse(HEAD + "part a\ngiven speed(P) = 4\nfind e\npart b\nfind impulse"))
    explanation = explain(solution)
    text = " ".join(to_text(explanation).split())
    assert TOLD in text
    assert text.index(f"(b) Note: {TOLD}.") < text.index("Impulse = ")
    assert TOLD in to_html(explanation)
    assert TOLD in json.loads(contract.to_json(contract.solved("-", solution)))["warnings"]
