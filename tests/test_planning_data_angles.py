"""Angles that the data give are read off, and stand so in sums, differences and their bounds."""

from __future__ import annotations

import pytest

import restitution as r
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Move
from restitution.explaining.lines.notation import read_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.solving.story.letters import roles

WALL = """
wall W: along {line}
sphere P: velocity {velocity}
P hits W{e}
"""
SPHERES = """
sphere A: mass {m}, velocity {velocity}
sphere B: mass m, at rest
A hits B: along i{e}
"""
BEFORE, AFTER = "angle(velocity(P, 0), W)", "angle(velocity(P), W)"

SAYS = {
    "in letters": (
        WALL.format(line="i", velocity="u at alpha to W", e=": e = 1/3") + f"find {BEFORE}",
        ["angle between 𝐮_P and W = α"],
    ),
    "in degrees, to a slanting wall": (
        WALL.format(line="20°", velocity="5 at 50°", e=": e = 1/3") + f"find {BEFORE}",
        ["angle between 𝐮_P and W = 30°"],
    ),
    "an obtuse one": (
        SPHERES.format(m="2m", velocity="u at 120°", e="").replace("along i", "along j")
        + "find angle(velocity(A, 0), i)",
        ["angle between 𝐮_A and 𝐢 = 120°"],
    ),
    "one of which the tangent is given": (
        WALL.format(line="i", velocity="u at alpha to W", e=": e = 1/3")
        + f"given tan(alpha) = 3/4\nfind {BEFORE}",
        ["angle between 𝐮_P and W = α (1)", "angle between 𝐮_P and W = arctan(3/4)"],
    ),
    "in a difference": (
        WALL.format(line="i", velocity="u at alpha to W", e=": e = 1/3")
        + f"find {BEFORE} - {AFTER}",
        ["α − β = α − arctan(⅓ tan α)"],
    ),
    "in the range of a difference": (
        WALL.format(line="i", velocity="u at 50° to W", e="") + f"find range of {BEFORE} - {AFTER}",
        ["50° − β = 50° − arctan(e tan 50°)", "0° ≤ 50° − β ≤ 50°"],
    ),
    "in the greatest difference, over a coefficient": (
        WALL.format(line="i", velocity="10 at 60° to W", e="")
        + f"given e >= 1/3\nfind maximum of {BEFORE} - {AFTER} over e",
        [
            "60° − β ≤ 30° as 60° − arctan(√3 e) decreases with increasing e and e ≥ ⅓",
            "greatest value of 60° − β = 30°, when e = ⅓",
        ],
    ),
    "in the greatest difference, over an angle": (
        WALL.format(line="i", velocity="u at alpha to W", e=": e = 1/3")
        + f"find maximum of {BEFORE} - {AFTER} over alpha",
        ["Let δ = α − β.", "greatest value of δ = 30°, when √3 − tan α = 0, so α = 60°"],
    ),
    "in the greatest difference of spheres": (
        SPHERES.format(m="2m", velocity="u at alpha", e=", e = 1/2")
        + "find maximum of angle(velocity(A), i) - angle(velocity(A, 0), i) over alpha",
        ["greatest value of δ = arctan(√2/4) ≈ 19.5°"],
    ),
    "in the greatest difference to a line of centres": (
        SPHERES.format(m="m", velocity="u at alpha", e=", e = 1/4").replace(
            "B: mass m", "B: mass 2m"
        )
        + "find maximum of angle(velocity(A), line_of_centres)"
        " - angle(velocity(A, 0), line_of_centres) over alpha",
        ["tan β = u sin α/(⅙u cos α) = 6 tan α", "greatest value of δ = arctan(5√6/12)"],
    ),
    "one of vectors, which is worked out": (
        WALL.format(line="i", velocity="3i - 4j", e="")
        + f"find maximum of {BEFORE} - {AFTER} over e",
        ["tan β = 4/3", "greatest value of β − θ = arctan(4/3) ≈ 53.1°, when e = 0"],
    ),
}


@pytest.mark.parametrize("name", SAYS)
def test_it_is_read_off(name: str) -> None:
    statement, said = SAYS[name]
    explanation = r.explain(r.solve(parse(statement)), check=True)
    text = " ".join(str(explanation).split())
    assert not explanation.warnings
    assert "not written out" not in text
    assert "The difference from that value" not in text
    for sentence in said:
        assert sentence in text


@pytest.mark.parametrize(
    ("line", "right"),
    [
        ("angle(velocity(P, 0), W) = 30°", True),
        ("angle(velocity(P, 0), i) = 50°", True),
        ("angle(velocity(P, 0), W) = 50°", False),
        ("angle(velocity(P, 0), i) = 30°", False),
        ("angle(velocity(P, 0), j) = 50°", False),
    ],
)
def test_only_the_angle_that_is_given_follows(line: str, right: bool) -> None:
    problem = parse(WALL.format(line="20°", velocity="5 at 50°", e=": e = 1/3") + "find speed(P)")
    names = {"P": "sphere", "W": "wall"}
    refs = ("velocity P", "wall W") if "W)" in line else ("velocity P",)
    own = Line(1, "1", Move("define", "difference", None, ("P",)), refs, read_relation(line, names))
    whole = Derivation(facts_of(problem), (own,), (), events_of(problem))
    reasons = {each.reason for each in follow(whole, Oracle(roles(problem)))}
    assert ("does-not-follow" in reasons) is not right
