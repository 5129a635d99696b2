"""A root that is rejected by way of another letter: what it would make of that."""

from __future__ import annotations

import pytest
from workings import printed_with

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

SAME_SPEED = """
sphere A: mass m, velocity 2u i + u j
sphere B: mass 2m, velocity -3u i
A hits B: along i
given speed(A) = speed(A, 0)
find e
"""

SEVERAL_MASSES = """
sphere A: mass m, velocity 2u i + u j
sphere B: mass 3m, velocity -3u i
A hits B: along i
given speed(A) = speed(A, 0)
find e
"""

# w = −u/2: v = 2u cos α and −u/2 − v = u cos α + u/4.
OBTUSE = """
sphere A: mass m, velocity 2u at alpha
sphere B: mass 2m, velocity u at 120°
A hits B: along i, e = 1/2
given speed(B) = u
find cos(alpha)
"""

# v = u/√2: w − v = u/√2, and u(1 − k)/√2 = u/√2 + √2 ku.
NO_MASS = """
sphere A: mass m, velocity u at 45°
sphere B: mass k m, velocity u at 45° from -i
A hits B: along i, e = 1/2
given energy(A) = energy(A, 0)
find k
"""

# w = u/2: x = u/2 + u/4 + √3 v/4, and u/2 − √3 v = u/2 + 2x.
NO_SPEED = """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, velocity v at 150°
A hits B: along i, e = 1/2
given speed(A) = u
find v in terms of u
"""


@pytest.mark.parametrize(
    ("statement", "reason"),
    [
        (NO_SPEED, "w = −u/2, as w = u/2 would give x = u/2 and v = −√3 u/3 < 0 by (2) and (3)"),
        (NO_MASS, "as v = √2 u/2 would give w = √2 u and k = 0 by (2) and (3), but k > 0"),
        (
            OBTUSE,
            "as w = −u/2 would give v = −u/2 and cos α = −¼ by (2) and (3), but α is acute",
        ),
        (SAME_SPEED, "v = −2u, as v = 2u would give w = −3u and e = −1 by (2) and (3), but e ≥ 0"),
        (
            SEVERAL_MASSES,
            "v = −2u, as v = 2u would give w = −3u and e = −1 by (2) and (3), but e ≥ 0",
        ),
    ],
)
def test_the_values_stand_there(statement: str, reason: str) -> None:
    assert reason in to_text(explain(solve(parse(statement))), 120)


NEGATIVE_COEFFICIENTS = """
wall W: along i
sphere P: mass 2, velocity u at 60° to W
P hits W
given speed(P) = 4, impulse = 6
find u, e
"""

ABOVE_ONE = """
wall W: along i
sphere P: mass 2, velocity u at alpha to W
P hits W
given angle(velocity(P), W) = 30°, energy(P) = 11/10 energy(0)
find alpha, e
"""


def test_what_excludes_all_roots_rejects_none_of_them() -> None:
    working = to_text(explain(solve(parse(NEGATIVE_COEFFICIENTS))), 100)
    assert "u = (√55 + 3√3)/2 ≈ 6.31, as u is positive" in working
    assert "e ≈ −0.451 is impossible: a coefficient of restitution is not negative" in (
        " ".join(working.split())
    )


def test_of_two_unknowns_the_coefficient_is_impossible() -> None:
    working = " ".join(to_text(explain(solve(parse(ABOVE_ONE))), 100).split())
    assert "e cannot be found, as e = √77/7 is impossible" in working


def test_what_a_root_would_make_with_a_calculator_is_in_figures() -> None:
    text = """sphere A: mass 3, velocity 8i
sphere B: mass 2, velocity 5 at 35° from -i
A hits B: along i
given speed(B) = 7
find speed(A)
"""
    working = " ".join(to_text(explain(solve(parse(text))), 100).split())
    assert "as w ≈ −6.386 would give v ≈ 9.527 and e ≈ −1.316 by (2) and (3), but e ≥ 0" in working


def test_what_was_not_solved_in_time_earns_nothing() -> None:
    text = "wall W: along i\nsphere P: velocity 4i - 3j\nP hits W: e = 1/2\nfind speed(P)\n"
    solution = solve(parse(text), time_limit=1e-9)
    assert to_text(explain(solution), 200).strip() == (
        "There is no working of the speed of P immediately after the impact: no answer within the"
        " time limit of 1e-09 s."
    )


@pytest.mark.parametrize(
    ("statement", "reason"),
    [
        # v = (1 − 2e)u and the component across is u: (1 − 2e)² = 1.
        (
            """
            sphere A: mass m, velocity 3u i + u j
            sphere B: mass 2m, at rest
            A hits B: along i
            given speed(A) = sqrt(2) u
            find e
            """,
            "e = 0 or e = 1 (both are possible, as both are from 0 to 1)",
        ),
        # q² + 4 = 9.
        (
            """
            wall W: along i
            sphere P: velocity q i - 4j
            P hits W: e = 1/2
            given speed(P) = 3
            find q
            """,
            "(both are possible, as q may have either sign)",
        ),
    ],
)
def test_why_neither_of_two_roots_is_rejected(statement: str, reason: str) -> None:
    working = explain(solve(parse(statement)), marks="none", check=True)
    assert not working.warnings
    assert reason in " ".join(to_text(working).split())


# The equation has two roots that are opposite: both satisfy it.
def test_a_root_of_a_positive_letter_is_rejected_by_its_sign() -> None:
    statement = """
sphere P: mass m, velocity p at 30°
sphere Q: mass m, at rest
P hits Q: along i
given (1 + e) sqrt(9u^2 - p^2) = 3u
find p
"""
    shown = " ".join(to_text(explain(solve(parse(statement)), marks="none")).split())
    assert "p = 3u√((2 + e)e)/(1 + e), as p is positive and e ≥ 0" in shown
    assert "does not satisfy" not in shown


# 8(n − 1)/n = (9n + 17)/10.
def test_two_roots_are_possible_by_the_coefficient_that_they_give() -> None:
    statement = """
sphere P: mass m, velocity 4u i + u j
sphere Q: mass n m, velocity 3u j
P hits Q: along i
given velocity(P) perpendicular to line_of_centres
part a
show e = 1/n
part b
given energy_lost = 1/5 energy(0)
find n
"""
    shown = " ".join(to_text(explain(solve(parse(statement)), marks="none")).split())
    assert "(both are possible: e = 1/n gives e = 3/16 or e = ⅗, and 0 ≤ e ≤ 1)" in shown


# w = −u would make 2mu − nmu = −2mu − nmu.
def test_a_root_that_leaves_nothing_of_an_equation_is_rejected_by_it() -> None:
    statement = """
sphere A: mass m, velocity 4u at 60°
sphere B: mass n m, velocity -u i
A hits B: along i
given direction(A) = 120°, speed(B) = u
find n
"""
    working = explain(solve(parse(statement)), marks="none", check=True)
    assert not working.warnings
    assert "w = u, as w = −u does not satisfy (2)" in " ".join(to_text(working).split())


def test_two_lines_of_centres_are_both_possible_and_each_case_names_what_it_puts_in() -> None:
    text = """
sphere A: mass 3, velocity 2i + 4j
sphere B: mass 2, velocity -3i - j
A hits B: e = 1/2
given velocity(B) parallel to j
find velocity(A), line_of_centres
"""
    reason = "(both are possible, as the spheres approach each other in each)"
    first, second = (f"If s = (5 {sign} 3√17)/4: Substituting for s in (1):" for sign in "+−")
    printed_with(text, (reason, first, second))


TAKEN = {
    "sphere P: mass 1/2, velocity 3i\nP receives k (2i + j)\ngiven speed(P) = 7\nfind k": (
        "as k is taken to be positive"
    ),
    "sphere A: mass m, velocity u i\nsphere B: mass m, at rest\nA hits B: along theta, e = 1/4\n"
    "given speed(A) = 3u/4\nfind theta": "as θ is taken to be acute",
    "sphere A: mass m, velocity 2u at alpha\nsphere B: mass m, at rest\n"
    "A hits B: along i, e = 1/2\ngiven speed(A) = u\nfind alpha": ", as α is acute",
}


@pytest.mark.parametrize("text", TAKEN)
def test_which_of_two_lines_is_meant_is_taken(text: str) -> None:
    assert TAKEN[text] in " ".join(to_text(explain(solve(parse(text)))).split())


def test_a_coefficient_of_an_excluded_case_is_not_called_impossible() -> None:
    """The sphere comes back only with e = 3/2, and not with the ½ of the other case."""
    statement = """
sphere A: mass 2, velocity 4i + 3j
sphere B: mass 1, velocity -2i + j
A hits B: along i
given speed(A) = sqrt(10)
part a
find e
part b
given along(velocity(A), i) < 0
find energy_lost
"""
    text = to_text(explain(solve(parse(statement))))
    assert "e = ½ is impossible" not in text
    assert "cannot be found, as no value of e is possible." in " ".join(text.split())


def test_two_directions_of_a_wall_are_possible_without_an_approach_of_spheres() -> None:
    text = """
wall W
sphere P: mass 2, velocity 3i + j
P hits W: e = 1/4
given velocity(P) perpendicular to velocity(P, 0)
find velocity(P), direction(W)
"""
    working = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "(both are possible)" in working
    assert "spheres" not in working


def test_two_values_that_an_earlier_part_has_are_recalled_in_one_line() -> None:
    text = """
wall W
sphere P: mass 2, velocity 3i + j
P hits W: e = 1/4
given velocity(P) perpendicular to velocity(P, 0)
part a
find direction(W)
part b
find velocity(P)
"""
    recalled = "From part (a): 𝐯_P = (½𝐢 − (3/2)𝐣) m s⁻¹ or (−½𝐢 + (3/2)𝐣) m s⁻¹"
    printed_with(text, (recalled,))
