"""That a sphere will hit a wall, or not: the fact, its working, and what the follower takes."""

from __future__ import annotations

import re

import pytest

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Move
from restitution.explaining.lines.notation import read_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import to_text
from restitution.workings.derived import explanation_of

GATE = """
wall V: along i, through (0, 0)
wall W: from (6, 2) to (6, 5)
sphere P: at (0, 6), velocity 3i - 6j
P hits V
given P will {n}hit W
find range of e
"""
LINE = """
wall W: along j, through (10, 0)
sphere A: mass m, at (0, 0), velocity u i
sphere B: mass 2m, at (3, 0), at rest
A hits B: along i
given A will {n}hit W
find range of e
"""
SLANTED = """
wall V: along i
wall W: along {along}
sphere Q: mass 2, velocity {velocity}
Q hits V{e}
given Q will {n}hit W
find range of {asked}
"""
SAYS = {
    "between the ends": (
        GATE.format(n=""),
        [
            "P hits W if, where x = 6, its y-coordinate is between those of the ends:",
            "2 < (6 − 3)(6e/3) < 5 2 < 6e < 5 ⅓ < e < ⅚",
        ],
    ),
    "beyond them": (
        GATE.format(n="not "),
        ["6e ≤ 2 or 6e ≥ 5 e ≤ ⅓ or e ≥ ⅚ 0 ≤ e ≤ ⅓ or ⅚ ≤ e ≤ 1, as 0 ≤ e ≤ 1"],
    ),
    "after two walls": (
        (
            "wall V: along i, through (0, 0)\nwall W: along j, through (10, 0)\n"
            "wall G: from (2, 8) to (5, 8)\nsphere P: at (0, 3), velocity 5i - 3j\n"
            "P hits V: e = 1/2\nP hits W: e = f\ngiven P will hit G\nfind range of f"
        ),
        ["its x-coordinate is between", "2 < 5(6 − 13f)/3 < 5 3/13 < f < 24/65"],
    ),
    "towards a whole line": (
        LINE.format(n=""),
        ["A hits W if it moves towards W, that is, if v > 0:", "0 ≤ e < ½"],
    ),
    "away from it": (
        LINE.format(n="not "),
        ["A does not hit W if it does not move towards W", "½ ≤ e ≤ 1"],
    ),
    "towards a slanting wall without a place": (
        SLANTED.format(along="3i + 2j", velocity="4i - 7j", e="", n="", asked="e"),
        [
            "component of 𝐯_Q in the direction of 2𝐢 − 3𝐣",
            "Q hits W if it moves towards W: (8 − 21e)/√13 > 0",
            "0 ≤ e < 8/21",
        ],
    ),
    "not towards one": (
        SLANTED.format(along="3i + 2j", velocity="4i - 7j", e="", n="not ", asked="e"),
        ["Q does not hit W if it does not move towards W", "8/21 ≤ e ≤ 1"],
    ),
    "towards one at some degrees": (
        SLANTED.format(along="60°", velocity="3 at beta to V", e=": e = 1/2", n="", asked="beta"),
        ["in the direction of sin 60° 𝐢 − cos 60° 𝐣", "tan β < 2√3"],
    ),
    "towards one from a corner, where the sphere has no place": (
        (
            "wall V: from (0, 0) to (10a, 0)\nwall W: from (0, 0) to (-5a, 5 sqrt(3) a)\n"
            "sphere P: velocity u at 180° + alpha\nP hits V: e = 1/3\ngiven P will hit W\n"
            "find range of alpha"
        ),
        ["in the direction of −√3 𝐢 − 𝐣", "tan α < 3√3", "0° < α < arctan(3√3) ≈ 79.1°"],
    ),
    "towards one from the far end, where the sphere has no place": (
        (
            "wall V: from (0, 0) to (8, 0)\nwall W: from (8, 0) to (12, 3)\n"
            "sphere Q: velocity 5 at -theta\nQ hits V: e = 1/2\ngiven Q will hit W\n"
            "find range of theta"
        ),
        ["in the direction of 3𝐢 − 4𝐣", "tan θ < 3/2"],
    ),
    "towards one at an obtuse angle": (
        SLANTED.format(along="150°", velocity="-4i - 3j", e="", n="", asked="e"),
        ["in the direction of −sin 30° 𝐢 − cos 30° 𝐣"],
    ),
}


@pytest.mark.parametrize("name", SAYS)
def test_it_is_worked_out(name: str) -> None:
    statement, phrases = SAYS[name]
    problem = parse(statement)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    text = re.sub(r"\s+", " ", to_text(explanation_of(derivation, problem)))
    for phrase in phrases:
        assert phrase in text


@pytest.mark.parametrize(
    ("range_", "right"),
    [
        ("1/3 < e and e < 5/6", True),
        ("1/3 < e < 5/6", True),
        ("1/3 < e < 1", False),
        ("1/4 < e < 5/6", False),
        ("1/3 < e <= 5/6", False),
        ("1/3 > e < 5/6", False),
    ],
)
def test_both_ends_of_a_range_come_of_those_above(range_: str, right: bool) -> None:
    problem = parse(GATE.format(n=""))
    names = {"P": "sphere", "V": "wall", "W": "wall"}
    above = "2 < (6 - 3)6e/3 < 5"
    written = (
        Line(
            1,
            "a",
            Move("law", "restitution-wall", 1, ("P",)),
            ("velocity P", "axis 1", "e 1"),
            read_relation("along(velocity(P, 1), j) = 6e", names),
        ),
        Line(
            2,
            "a",
            Move("define", "straight-line", 1, ("P",)),
            ("position P", "contact 1", "velocity P"),
            read_relation("along(position(P, 1), i) = 6(3/6)", names),
        ),
        Line(
            3,
            "a",
            Move("law", "unchanged", 1, ("P",)),
            ("velocity P", "axis 1"),
            read_relation("along(velocity(P, 1), i) = 3", names),
        ),
        Line(
            4,
            "a",
            Move("put"),
            ("given 1", "contact 1", 2, 1, 3),
            read_relation(above, names),
        ),
        Line(5, "a", Move("rearrange"), (4,), read_relation(range_, names)),
    )
    whole = Derivation(facts_of(problem), written, (), events_of(problem))
    complaints = follow(whole, Oracle(roles(problem)))
    refused = {each.line for each in complaints if each.reason == "does-not-follow"}
    assert refused == (set() if right else {5})


@pytest.mark.parametrize(
    "statement",
    [
        # It is open on which side of the wall the sphere is, or whether it moves towards that.
        (
            "wall V: along i, through (0, 0)\nwall W: from (d, 1) to (d, 2)\n"
            "sphere P: at (0, 3), velocity u i - u j\nP hits V\ngiven P will hit W\n"
            "find range of e"
        ),
        # The centre of a sphere with a radius comes to another line.
        (
            "wall V: along i, through (0, 0)\nwall W: from (9, 1) to (9, 4)\n"
            "sphere P: at (0, 3), velocity 2i - j, radius 1\nP hits V\ngiven P will hit W\n"
            "find range of e"
        ),
    ],
)
def test_what_places_leave_open_is_no_fact(statement: str) -> None:
    assert not [each for each in facts_of(parse(statement)) if each.id.startswith("given")]
