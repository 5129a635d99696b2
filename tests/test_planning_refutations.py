"""Workings of claims that are not true: what they speak of is worked out, then numbers refute."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache

import pytest

from restitution.explaining.following.follower import Complaint, follow
from restitution.explaining.lines.derivation import Derivation, Link
from restitution.explaining.lines.storing import from_json, to_json
from restitution.expression.tree import Letter, rational
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

WALL = """
wall V: along j
sphere S: mass 3m, velocity v at theta to V
S hits V
"""
OBLIQUE = """
sphere A: mass m, velocity 2u at theta
sphere B: mass 3m, at rest
A hits B: along i, e = 1/3
"""
LINE = """
sphere A: mass 4m, velocity 3u i
sphere B: mass m, at rest
sphere C: mass {c}, at rest
A hits B: along i, e = 1/2
B hits C: along i, e = 1/2
"""

# A statement, and what its working says in the end; each stands in place of a proof.
CLAIMS = {
    "a value": (WALL + "show speed(S) = e v", "The speed of S is not ev in general: it is v√("),
    "an impulse": (
        WALL + "show impulse = 3(1 - e) m v sin(theta)",
        "The magnitude of the impulse is not 3(1 − e)mv sin θ in general: it is 3(1 + e)mv sin θ.",
    ),
    "a value that is always another one, by the difference of squares": (
        WALL + "given 0 < e < 1\nshow speed(S) = e v",
        "and v²(cos²θ + e² sin²θ) − e²v² = v²(1 − e²) cos²θ > 0, as e < 1 and θ is acute.",
    ),
    "an impulse that is always another one, by the difference": (
        WALL + "given 0 < e < 1\nshow impulse = 3(1 - e) m v sin(theta)",
        "and 3(1 + e)mv sin θ − 3(1 − e)mv sin θ = 6emv sin θ > 0, as e > 0 and θ is acute.",
    ),
    "an inequality": (
        OBLIQUE + "show energy_lost > 1/2 energy(0)",
        "It is not true that the kinetic energy lost in the collision is greater than",
    ),
    "one side of a chain": (
        WALL + "show 1/3 v < speed(S) <= v",
        "It is not true that",
    ),
    "a velocity at rest": (
        OBLIQUE + "show A at rest",
        "A is not at rest: 𝐯_A = 2u",
    ),
    "a right angle": (
        (
            "sphere A: mass 1, velocity 3i + j\nsphere B: mass 2, velocity -i\n"
            "A hits B: along i, e = 1/2\nshow velocity(A) perpendicular to velocity(B)"
        ),
        "𝐯_A is not perpendicular to 𝐯_B, as 𝐯_A · 𝐯_B = −1 ≠ 0.",
    ),
    "one direction": (
        (
            "sphere A: mass 3, velocity 2i + j\nsphere B: mass 1, velocity -2i - j\n"
            "A hits B: along i, e = 1/2\nshow velocity(A) opposite to velocity(B)"
        ),
        "𝐯_A is not opposite to 𝐯_B, as ½𝐢 + 𝐣 is not a multiple of (5/2)𝐢 − 𝐣.",
    ),
    "a meeting": (
        LINE.format(c="8m") + "show A and B do not collide again",
        "So A and B will collide again, and the claim is not true.",
    ),
    "a meeting for some masses": (
        LINE.format(c="k m") + "show A and B collide again",
        "so the gap between A and B does not close.",
    ),
    "a value to three figures": (
        (
            "wall V: along j\nsphere S: velocity 5u at 35° to V\nS hits V: e = 0.3\n"
            "show speed(S) = 4.25u to 3 s.f."
        ),
        "The speed of S is not 4.25u: it is 4.19u.",
    ),
    "only at an angle that is found": (
        (
            "sphere A: mass m, velocity u at theta\nsphere B: mass m, at rest\n"
            "A hits B: along i, e = 1/2\nshow deflection(A) < arctan(3/4)"
        ),
        "θ = arctan(1/2)",
    ),
    "a relation of letters": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"
            "given A at rest\nshow k < 2"
        ),
        "k < 2: with e = ½, for instance, k = 2, which is not less than 2.",
    ),
    "a value that is a decimal": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"
            "show speed(B) < 1.9 u"
        ),
        "with e = 1 and k = 0.01, for instance, the speed of B = 200u/101",
    ),
    "a greatest value": (
        (
            "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
            "A hits B: along i, e = 1/3\nshow maximum of tan(deflection(A)) over alpha = 1/2"
        ),
        "The greatest value of tan δ is not ½: it is √3/3 ≈ 0.577.",
    ),
    "a bound in letters": (
        WALL + "show speed(S) < 1/2 v",
        "which is more than ½v.",
    ),
    "a letter whose value is known": (
        (
            "sphere A: mass m, velocity 2u i\nsphere B: mass m, at rest\nA hits B: along i\n"
            "part a\ngiven velocity(A) = u/2 i\nfind e\npart b\ngiven velocity(A) = u/2 i\n"
            "show energy(B) - energy(A) = 3 e^2 energy(0)"
        ),
        "but 3e² × total kinetic energy before the impact = 3mu²/2.",
    ),
    "two values": (
        WALL + "show speed(S)/v = sin(theta)",
        ", but sin θ = ",
    ),
    "a range": (
        WALL + "show range of speed(S): speed(S) > 0",
        "The range of possible values is not",
    ),
}


@cache
def planned(text: str) -> tuple[Solution, Derivation]:
    solution = solve(parse(text))
    derivation = plan(solution)
    assert complaints(solution, derivation) == ()
    assert from_json(to_json(derivation)) == derivation
    return solution, derivation


def complaints(solution: Solution, derivation: Derivation) -> tuple[Complaint, ...]:
    return follow(derivation, Oracle(roles(solution.problem)))


@pytest.mark.parametrize("name", CLAIMS)
def test_a_claim_that_is_not_true(name: str) -> None:
    text, ending = CLAIMS[name]
    solution, derivation = planned(text)
    (note,) = derivation.notes
    assert note.kind == "refuted"
    assert ending in " ".join(to_text(explain(solution)).split())


def test_claims_beside_it_are_shown() -> None:
    text = WALL + (
        "show impulse = 3(1 - e) m v sin(theta)\nshow impulse = 3(1 + e) m v sin(theta)\n"
        "find tan(angle(velocity(S), V))"
    )
    _, derivation = planned(text)
    assert [each.item for each in derivation.notes] == ["1"]
    assert [(each.item, each.shown) for each in derivation.items] == [("2", True), ("3", False)]


def test_an_instance_has_to_refute() -> None:
    """With e = 1 and θ = 90° the speed is v, so that these numbers show nothing."""
    solution, derivation = planned(WALL + "show speed(S) < 1/2 v")
    (note,) = derivation.notes
    assert complaints(solution, derivation) == ()
    value = rational(Fraction(1, 1000))
    changed = replace(
        note,
        instance=tuple(
            Link(each.left, "=", value) if each.left == Letter("v") else each
            for each in note.instance
        ),
        claim=None,
    )
    reasons = [e.reason for e in complaints(solution, replace(derivation, notes=(changed,)))]
    assert reasons == ["not-excluded"]
    without = replace(note, premises=())
    assert [e.reason for e in complaints(solution, replace(derivation, notes=(without,)))] == [
        "leads-nowhere"
    ] * len(derivation.lines)


def working(text: str) -> str:
    """The working of a question, of which the follower accepts every line."""
    return " ".join(to_text(explain(planned(text)[0])).split())


@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        (
            "velocity(A) perpendicular to velocity(A, 0)",
            "as 𝐯_A · 𝐮_A = −2 × (5/2) + 3 × 3 = 4 ≠ 0.",
        ),
        ("velocity(B, 0) parallel to velocity(A)", "as −2𝐢 is not a multiple of −2𝐢 + 3𝐣."),
    ],
)
def test_a_velocity_of_the_data_beside_another(claim: str, reason: str) -> None:
    text = (
        "sphere A: mass 1, velocity 5/2 i + 3j\nsphere B: mass 1, velocity -2i\n"
        "A hits B: along i, e = 1"
    )
    assert reason in working(f"{text}\nshow {claim}")


def test_a_velocity_told_by_its_direction_is_resolved_beside_another() -> None:
    text = (
        "sphere A: mass m, velocity 2u at 30°\nsphere B: mass m, velocity u at 180°\n"
        "A hits B: along i, e = 1\nshow velocity(A) parallel to velocity(A, 0)"
    )
    shown = working(text)
    assert "𝐮_A = √3 u𝐢 + u𝐣 B1" in shown
    assert "𝐯_A is not parallel to 𝐮_A, as −u𝐢 + u𝐣 is not a multiple of √3 u𝐢 + u𝐣." in shown


LATER = """
sphere A: mass 2m, velocity 3u i
sphere B: mass m, velocity -u i
A hits B: along i, e = e
part a
find velocity(A), speed(B), energy_lost
part b
given e = 1/2
"""


# With e = 1/2, v = u and w = 3u, and 16/3 (1 - e²)mu² = 4mu² of 19/2 mu² is lost.
@pytest.mark.parametrize(
    ("claim", "reason"),
    [
        ("show velocity(A) = 2u i", "from (3): 𝐯_A = u𝐢 B1ft 𝐯_A is not 2u𝐢: it is u𝐢."),
        ("show A at rest", "A is not at rest: 𝐯_A = u𝐢."),
        ("show speed(B) < 2u", "the speed of B = 3u, which is more than 2u."),
        ("show energy_lost > 5 m u^2", "the kinetic energy lost = 4mu², which is less than 5mu²."),
        (
            "show energy_lost < 1/2 energy(0)",
            (
                "½ × total kinetic energy before the impact = 19mu²/4 (5) From (4) and (5): "
                "kinetic energy lost < ½ × total kinetic energy before the impact (as required)"
            ),
        ),
    ],
)
def test_what_an_earlier_part_found_is_taken_with_the_values_of_its_own(
    claim: str, reason: str
) -> None:
    assert reason in working(LATER + claim)


@pytest.mark.parametrize(
    ("statement", "reason"),
    [
        (
            (
                "sphere A: mass m, velocity 4u i\nsphere B: mass k m, velocity -u i\n"
                "A hits B: along i, e = 1/5\nshow velocity(A) in the direction of velocity(B)"
            ),
            "𝐯_A = −(4u/5)𝐢 and 𝐯_B = (u/5)𝐢, which are in opposite directions.",
        ),
        (
            (
                "sphere A: mass 2m, velocity 3u i\nsphere B: mass m, velocity -u i\n"
                "A hits B: along i, e = e\nshow velocity(A) opposite to velocity(A, 0)"
            ),
            "𝐯_A = (u/3)𝐢 and 𝐮_A = 3u𝐢, which are in the same direction.",
        ),
        (
            (
                "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
                "A hits B: along i\ngiven energy_lost = 1/4 energy(0)\nfind e\nshow k < 1"
            ),
            "k is 1, for instance, when e = √2/2 ≈ 0.707.",
        ),
        (
            OBLIQUE.replace("3m", "m").replace("1/3", "1")
            + "show angle(velocity(A), velocity(B)) = 60°",
            "It is not true that β = 60°: β = 90°, which is not 60°.",
        ),
        (
            OBLIQUE.replace("3m", "m").replace("1/3", "1") + "show deflection(A) = theta",
            "δ = 30°, which is not θ.",
        ),
    ],
)
def test_a_counter_example_says_what_is_wrong(statement: str, reason: str) -> None:
    assert reason in working(statement)


BACK = """
sphere A: mass 2m, velocity u i
sphere B: mass 3m, at rest
wall W: along j
A hits B: along i
B hits W: e = 1/2
"""


# v = (2 - 3e)u/5 and B comes back with (1 + e)u/5.
@pytest.mark.parametrize(
    ("statement", "reason"),
    [
        (
            BACK + "given A and B do not collide again\nfind range of e",
            (
                "component of A is at most that of B: (2 − 3e)u/5 ≤ −(1 + e)u/5 DM1 e ≥ 3/2 "
                "But e ≤ 1. So what is described cannot happen."
            ),
        ),
        (
            BACK + "given velocity(A, 1) opposite to i, e < 1/2\nfind range of e",
            "2 − 3e < 0 DM1 e > ⅔ But e < ½. So what is described cannot happen.",
        ),
        (
            (
                "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
                "A hits B: along i, e = 1/2\n"
                "given velocity(A) opposite to i, k < 1\nfind range of k"
            ),
            "k > 2 But k < 1. So what is described cannot happen.",
        ),
        (
            BACK.replace("B hits W: e = 1/2\n", "")
            + "part a\ngiven velocity(A) opposite to i\nfind range of e\n"
            "part b\ngiven velocity(A) opposite to i, e < 1/2\nfind range of e",
            "(b) From part (a), e > ⅔. But e < ½. So what is described cannot happen.",
        ),
    ],
)
def test_why_a_range_has_no_value(statement: str, reason: str) -> None:
    solution = solve(parse(statement))
    assert reason in " ".join(to_text(explain(solution)).split())


@pytest.mark.parametrize(
    ("shown", "claim", "told"),
    [
        (
            "show tan(delta) = (1 + e) tan(alpha)/(1 - e tan^2(alpha))\nfind cos(delta)\n",
            "sin(delta) = sin(2 alpha)(1 - e)/2",
            "with α = 45° and e = 1, for instance, cos δ = 0, so sin δ = 1, but",
        ),
        (
            "show tan(delta) = (1 + e) tan(alpha)/(1 - e tan^2(alpha))\n",
            "cos(delta) = 1 - e",
            "with α = 45° and e = ½, for instance, tan δ = 3, so cos δ = √10/10",
        ),
    ],
)
def test_a_ratio_has_the_other_from_which_it_follows(shown: str, claim: str, told: str) -> None:
    text = f"""
wall W: along i
sphere P: velocity u at alpha to W
P hits W
let delta = deflection(P)
{shown}show {claim}
"""
    assert told in " ".join(to_text(explain(solve(parse(text)))).split())


@pytest.mark.parametrize(
    ("bound", "refuted"),
    [("1/2", "It is not true that e > ½: e may be ½."), ("1/3", "e may be 0, with u = −1.")],
)
def test_a_counterexample_has_a_negative_letter_only_where_it_rests_on_that(
    bound: str, refuted: str
) -> None:
    text = f"""
sphere A: mass m, velocity u i + v j
sphere B: mass 3m, at rest
A hits B: along i
given along(velocity(A), i) < 0
show e > {bound}
"""
    assert refuted in " ".join(to_text(explain(solve(parse(text)))).split())
