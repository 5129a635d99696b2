"""Workings of bounds: how each comes about, and what the follower takes of them."""

from __future__ import annotations

import re
from functools import cache

import pytest

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Move
from restitution.explaining.lines.notation import read_meaning, read_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.problem import Problem
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W{e}
"""
REST = """
sphere A: mass m, velocity u at alpha
sphere B: mass {k}m, at rest
A hits B: along i{e}
"""

# Statement, and what its working says.
SAYS = {
    "the bound of a letter, put in before it is solved": (
        WALL.format(e="") + "given energy_lost = 1/3 energy(0)\nfind range of e",
        ["1/(3(1 − e²)) < 1", "e² < ⅔"],
    ),
    "the greatest deflection of a sphere, over e": (
        REST.format(k="", e="").replace("mass m, velocity", "mass 3m, velocity")
        + "given tan(alpha) = 1/2\nfind maximum of deflection(A) over e",
        [
            "as (1 + e)/(2(4 − e)) increases with e and e ≤ 1",
            "so δ is acute (5) From (4) and (5): δ ≤ arctan(1/3)",
        ],
    ),
    "a condition that always holds, with both components found": (
        (
            "wall W: along j\nsphere A: mass 3m, velocity 2u i\nsphere B: mass m, at rest\npart a\n"
            "A hits B: along i, e = e\nshow speed(B) = 3/2 (1 + e) u\nB hits W: e = 1/3\npart b\n"
            "given A and B collide again\nfind range of e"
        ),
        ["v = (3 − e)u/2", "(3 − e)u/2 > −(1 + e)u/2", "every value of e is possible"],
    ),
    "a bound of a speed as a quadratic in one ratio": (
        (
            "sphere A: mass 2m, velocity u at alpha\nsphere B: mass m, velocity u at 180°\n"
            "A hits B: along i, e = 1/2\ngiven speed(A) > 3/4 u\nfind range of cos(alpha)"
        ),
        ["As sin²α + cos²α = 1:", "12 cos²α + 8 cos α − 11 < 0"],
    ),
    "an obtuse deflection": (
        REST.format(k="4", e=", e = 1/2") + "given deflection(A) > 90°\nfind range of tan(alpha)",
        [
            "the angle of deflection of A is more than 90°",
            "so the scalar product of the velocities before and after is negative:",
        ],
    ),
    "an acute angle between two velocities": (
        (
            "sphere A: mass 2m, velocity u i + 3u j\nsphere B: mass m, velocity -u i + k u j\n"
            "A hits B: along i, e = 1/2\ngiven angle(velocity(A), velocity(B)) < 90°, k > -1\n"
            "find range of k"
        ),
        ["so the scalar product is positive:"],
    ),
    "a quadratic with irrational ends": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass 4m, at rest\n"
            "sphere C: mass m, at rest\nA hits B: along i\nB hits C: along i\n"
            "given A and B do not collide again\nfind range of e"
        ),
        [
            "A is behind B, so they do not collide again if the component of A is at most that",
            "² ≤",
        ],
    ),
    "two spheres that meet again": (
        (
            "wall W: along j\nsphere A: mass m, velocity u i\nsphere B: mass 3m, at rest\n"
            "A hits B: along i, e = 1/2\nB hits W: e = f\ngiven f > 2/3\nshow A and B collide again"
        ),
        [
            "A is behind B, so they collide again if the component of A is greater than that of B.",
            "as f > ⅔",
        ],
    ),
    "a wall that is hit again": (
        (
            "wall W: along j\nsphere A: mass m, velocity -u i\nsphere B: mass k m, at rest\n"
            "A hits W: e = 2/3\nA hits B: along i, e = 1/4\ngiven A hits W again\nfind range of k"
        ),
        ["if it moves towards W, that is, if v < 0: (4 − k)u/(6(1 + k)) < 0", "k > 4"],
    ),
    "a range in two parts": (
        (
            "wall W: along i\nsphere P: velocity p i - 5j\nP hits W: e = 2/5\n"
            "given 3 <= speed(P) <= 7\nfind range of p"
        ),
        ["or √5 ≤ p ≤ 3√5"],
    ),
    "a deflection at a wall": (
        WALL.format(e="") + "find range of deflection(P) in terms of alpha",
        ["0 ≤ tan β ≤ tan α", "δ = α + β", "α ≤ δ ≤ 2α"],
    ),
    "a deflection by a sphere at rest": (
        REST.format(k="", e="") + "find range of deflection(A) in terms of alpha, u",
        ["≤ δ ≤ 90° − α"],
    ),
    "without limit": (
        (
            "sphere A: mass m, velocity u at 45°\nsphere B: mass k m, at rest\n"
            "A hits B: along i, e = 1/3\nfind maximum of deflection(A) over k"
        ),
        [
            "tan δ < 2, as k/(3 + k) = 1 − 3/(3 + k) < 1",
            "as k → ∞, so there is no greatest value",
        ],
    ),
    "a greatest value that is only approached, to be shown": (
        REST.format(k="2", e=", e = 1/4") + "show maximum of energy_lost over alpha = 5/16 m u^2",
        ["as α → 0°: a bound that is approached and not reached"],
    ),
    "a square as it is defined": (
        REST.format(k="k ", e=", e = 1/3") + "find minimum of energy(A) over k",
        ["((3 − k)u cos α/(3(1 + k)))² ≥ 0", "when k = 3"],
    ),
    "a difference in factors": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass M, at rest\n"
            "A hits B: along i, e = 1\nshow energy(B) <= 1/2 m u^2 cos^2(alpha)"
        ),
        ["(m − M)²"],
    ),
    "a share of at most 1": (
        REST.format(k="2", e="") + "show energy_lost <= 2/3 energy(0)",
        ["as 1 − e² ≤ 1 and cos²α ≤ 1"],
    ),
    "a share that is less than 1, factor by factor": (
        REST.format(k="3", e="") + "show energy_lost < 3/4 energy(0)\nshow speed(B) < u/2",
        [
            "as 1 − e² ≤ 1 and cos²α < 1",
            "as ½(1 + e) ≤ 1 and cos α < 1",
        ],
    ),
    "a share with a ratio of masses": (
        REST.format(k="k ", e="") + "show energy_lost < energy(0)",
        ["as k/(1 + k) < 1, 1 − e² ≤ 1 and cos²α < 1"],
    ),
    "a sine by the tangent of its angle": (
        REST.format(k="2", e=", e = 1/4")
        + "show cos(angle(velocity(A), line_of_centres)) < cos(alpha)",
        ["tan β > tan α", "β > α", "cos β < cos α"],
    ),
    "a sine at most the one of an angle": (
        REST.format(k="1", e=", e = 2/3") + "show sin(deflection(A)) <= 5/7",
        ["tan δ ≤ 5√6/12", "so δ is acute", "sin δ ≤ 5/7"],
    ),
    "a sine at most a value in letters": (
        REST.format(k="1", e="") + "given e < 1\nshow sin(deflection(A)) <= (1 + e)/(3 - e)",
        ["so δ is acute", "sin δ ≤ (1 + e)/(3 − e)"],
    ),
    "the cosine of a sum of angles": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at 30° to W\nP hits W\n"
            "show cos(deflection(P)) <= sqrt(3)/2"
        ),
        ["δ = 30° + β", "cos δ ≤ √3/2"],
    ),
    "a quotient": (
        REST.format(k="2", e="")
        + "given e < 1/2\nshow tan(deflection(A)) <= (1 + e)/sqrt(3(1 - 2e))",
        ["Let S = ", "² ≥ 0 and α is acute"],
    ),
    "both ends of a speed by its square": (
        WALL.format(e="") + "given speed(P) = v\nfind range of v in terms of u, alpha",
        ["u² cos²α ≤ v² ≤ u²", "u cos α ≤ v ≤ u"],
    ),
    "a range with a condition": (
        REST.format(k="", e="") + "given speed(B) > speed(A)\nfind range of alpha in terms of e",
        ["tan²α < e", "0° < α < arctan(√e)"],
    ),
    "a letter that is positive": (
        REST.format(k="k ", e=", e = 1/2") + "given along(velocity(A), i) > 0\nfind range of k",
        ["0 < k < 2"],
    ),
    "a place between ends, without its denominator": (
        (
            "wall OX: from (0, 0) to (3a, 0)\nwall OY: from (0, 0) to (0, 3a)\n"
            "sphere P: at (a, a), velocity -k u i - u j\nP hits OX: e = 1/4\nP hits OY\n"
            "find range of k"
        ),
        ["0 < (1 − k)a/(4k) < 3a 0 < 1 − k < 12k, as k > 0 1/13 < k < 1"],
    ),
    "a range under the range of another letter": (
        WALL.format(e="") + "given 3/4 <= speed(P)/u <= 7/8, alpha = 60°\n"
        "find range of e, range of impulse",
        ["(√33 + 4√3)mu/8 as √3(1 + e)mu/2 increases with e"],
    ),
    "both ends of a range that is given": (
        WALL.format(e="") + "given 1/3 <= e <= 2/3\nfind range of impulse in terms of m, u, alpha",
        ["increases with e, α is acute and ⅓ ≤ e ≤ ⅔"],
    ),
    "a coefficient that bounds no other": (
        (
            "wall W: along j\nsphere A: mass m, velocity u i\nsphere B: mass m, at rest\n"
            "A hits B: along i, e = e1\nB hits W: e = e2\ngiven speed(B) = 1/4 u\n"
            "find e2 in terms of e1\nfind range of e1"
        ),
        ["e₂ ≤ ½ < 1, as", "So every value of e₁ is possible: (ii) 0 ≤ e₁ ≤ 1"],
    ),
    "a coefficient by one that is tied to it": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass m, at rest\n"
            "sphere C: mass 2m, at rest\nA hits B: along i, e = e1\nB hits C: along i, e = e2\n"
            "given velocity(C) = 2/5 u i\nfind e2 in terms of e1\nfind range of e2"
        ),
        ["e₂ ≥ ⅕ as (7 − 5e₁)/(5(1 + e₁)) decreases with increasing e₁ and e₁ ≤ 1"],
    ),
    "a coefficient that is twice another": (
        (
            "wall W: along i\nwall X: along j\nsphere P: mass m, velocity u at 30° to W\n"
            "P hits W: e = e\nP hits X: e = 3e\nfind range of e"
        ),
        ["A coefficient of restitution is at most 1: 3e ≤ 1 e ≤ ⅓"],
    ),
    "the size of a sum of sines": (
        (
            "sphere A: mass m, velocity u at alpha\n"
            "sphere B: mass m, velocity 2u at 90° - alpha from -i\nA hits B: along i\n"
            "find maximum of impulse over alpha"
        ),
        ["as cos α + 2 sin α = √5 cos(α − arctan 2) ≤ √5"],
    ),
}


@cache
def worked(name: str) -> tuple[Problem, Derivation]:
    problem = parse(SAYS[name][0])
    return problem, plan(solve(problem))


@pytest.mark.parametrize("name", SAYS)
def test_the_follower_accepts_it(name: str) -> None:
    problem, derivation = worked(name)
    assert follow(derivation, Oracle(roles(problem))) == ()


@pytest.mark.parametrize("name", SAYS)
def test_it_says_how_the_bound_comes_about(name: str) -> None:
    problem, derivation = worked(name)
    text = re.sub(r"\s+", " ", to_text(explanation_of(derivation, problem)))
    for each in SAYS[name][1]:
        assert each in text


# --- what the follower takes ----------------------------------------------------------------------


def reasons(statement: str, *lines: tuple[Move, tuple[object, ...], str]) -> list[str]:
    problem = parse(statement)
    names = {each.name: "sphere" for each in problem.spheres}
    names |= {each.name: "wall" for each in problem.walls}
    written = tuple(
        Line(
            number,
            "a",
            move,
            refs,  # type: ignore[arg-type]
            read_meaning(text, names) if move.id == "let" else read_relation(text, names),
        )
        for number, (move, refs, text) in enumerate(lines, 1)
    )
    whole = Derivation(facts_of(problem), written, (), events_of(problem))
    complaints = follow(whole, Oracle(roles(problem)))
    return [each.reason for each in complaints if each.reason != "leads-nowhere"]


GIVEN = WALL.format(e="") + "given deflection(P) > 90°\nfind range of e"
BEFORE = (
    (
        Move("law", "unchanged", 1, ("P",)),
        ("velocity P", "wall W", "axis 1"),
        "along(velocity(P, 1), i)",
    ),
    (
        Move("law", "restitution-wall", 1, ("P",)),
        ("velocity P", "wall W", "axis 1", "e 1"),
        "along(velocity(P, 1), j)",
    ),
)


@pytest.mark.parametrize(
    ("sign", "right"), [("<", True), (">", False), ("<=", False), ("=", False)]
)
def test_an_obtuse_angle_has_a_negative_product(sign: str, right: bool) -> None:
    found = reasons(
        GIVEN,
        (*BEFORE[0][:2], BEFORE[0][2] + " = u cos(alpha)"),
        (*BEFORE[1][:2], BEFORE[1][2] + " = e u sin(alpha)"),
        (
            Move("define", "perpendicular", 1, ("P",)),
            ("given 1", "velocity P", "wall W", 1, 2),
            f"-(u sin(alpha))(e u sin(alpha)) + (u cos(alpha))(u cos(alpha)) {sign} 0",
        ),
    )
    assert ("does-not-follow" not in found) == right


@pytest.mark.parametrize(
    ("bound", "right"),
    [("s < 3", True), ("s < 2", False), ("s <= 3", False), ("s > 0", True), ("s > 3", False)],
)
def test_a_positive_letter_grows_without_limit(bound: str, right: bool) -> None:
    found = reasons(
        REST.format(k="k ", e="") + "let s = 3k/(4 + k)\nfind s",
        (Move("fact"), ("let s",), "s = 3k/(4 + k)"),
        (Move("monotone"), (1,), bound),
    )
    assert ("does-not-follow" not in found) == right


@pytest.mark.parametrize(
    ("bound", "right"),
    [
        ("beta <= 90° - alpha", True),
        ("beta <= alpha", False),
        ("beta < 90° - alpha", False),
        ("beta >= 90° - alpha", False),
    ],
)
def test_an_angle_is_bounded_by_its_tangent(bound: str, right: bool) -> None:
    found = reasons(
        WALL.format(e="")
        + "let beta = angle(velocity(P), W)\ngiven tan(beta) <= 1/tan(alpha)\nfind e",
        (Move("fact"), ("given 1",), "tan(beta) <= 1/tan(alpha)"),
        (Move("compare"), (1, "0° <= beta <= 90°", "acute: alpha"), bound),
    )
    assert ("does-not-follow" not in found) == right


@pytest.mark.parametrize(
    ("least", "right"), [("0", True), ("1/3", True), ("-1", False), ("-1/2", False)]
)
def test_an_angle_of_up_to_180_is_below_a_bound_where_its_tangent_is_positive(
    least: str, right: bool
) -> None:
    found = reasons(
        REST.format(k="", e="")
        + f"let delta = deflection(A)\ngiven tan(delta) < 1/2, tan(delta) > {least}\nfind e",
        (Move("fact"), ("given 1",), "tan(delta) < 1/2"),
        (Move("fact"), ("given 2",), f"tan(delta) > {least}"),
        (Move("compare"), (1, 2, "0° <= delta <= 180°"), "delta < arctan(1/2)"),
    )
    assert "not-known-of-letters" not in found
    assert ("does-not-follow" not in found) == right


def test_a_range_of_one_value_is_no_inequality() -> None:
    """Two facts fix u: the offset goes, and nothing is left between two ends."""
    text = """
sphere A: mass 3, velocity u i, radius a
sphere B: mass m, velocity -u i, radius a
A hits B: offset d, e = 0
given energy_lost = 9, speed(A) = 3
find range of u
"""
    shown = to_text(explain(solve(parse(text))))
    assert "u = 3√((m + 5)/(m + 3))" in shown


def test_an_event_of_a_later_part_is_no_condition_of_an_earlier_one() -> None:
    text = """
    wall F: from (0, 0) to (5, 0)
    wall C: from (0, 2) to (9, 2)
    sphere P: at (0, 2), velocity u at -theta
    P hits F
    part a
    find range of tan(theta)
    part b
    P hits C
    find position(P)
    """
    problem = parse(text)
    derivation = plan(solve(problem), partial=True)
    assert [note.kind for note in derivation.notes] == []
    assert follow(derivation, Oracle(roles(problem))) == ()
