"""Reasons and conditions of answers say what is true of every value of the letters."""

from __future__ import annotations

import re

import pytest

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text


def working(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text))), 80).split())


def test_a_square_of_a_cosine_is_at_most_one() -> None:
    shown = working(
        "sphere A: mass 3m, velocity u at alpha\nsphere B: mass m, velocity u at 180° - alpha\n"
        "A hits B: along i, e = 1/2\ngiven velocity(A) perpendicular to velocity(B)\n"
        "find tan(alpha)"
    )
    assert (
        "cos²α = 16/11 ≈ 1.45 This cannot be, as cos²α is at most 1. "
        "So what is described cannot happen. A1"
    ) in shown


def test_a_quadratic_without_roots_has_a_negative_discriminant() -> None:
    shown = working(
        "wall AB: along i\nwall BC: along 120°\nsphere P: velocity u at alpha to AB\nP hits AB\n"
        "P hits BC\ngiven velocity(P) parallel to velocity(P, 0), e = 1/2\nfind tan(alpha)"
    )
    assert re.search(r"the discriminant of .*tan α .* = 0 is negative: .* = −23\.", shown)


def test_a_greatest_value_exists_where_its_form_does() -> None:
    text = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
        "find maximum of tan(deflection(A)) over alpha"
    )
    assert working(text).endswith("This holds for e < 1 only.")


@pytest.mark.parametrize(("claim", "holds"), [("0 < k < e", True), ("0 < k < e^2", False)])
def test_the_ends_of_a_claimed_range_name_its_data(claim: str, holds: bool) -> None:
    text = (
        "sphere A: mass k m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
        f"given velocity(A) perpendicular to velocity(A, 0)\nshow range of k: {claim}"
    )
    ((_, result),) = solve(parse(text)).items()
    assert result.holds is holds


def test_a_speed_by_an_angle_in_degrees_has_two_components() -> None:
    shown = working(
        "wall W: along i\nsphere P: velocity 12 at theta to W\nP hits W: e = 0.7\n"
        "given angle(velocity(P), W) = 25°\nfind theta, speed(P)"
    )
    assert "one component only" not in shown


def test_a_case_against_directions_has_directions() -> None:
    shown = working(
        "sphere A: mass m, velocity 4u i\nsphere B: mass k m, velocity -u i\n"
        "A hits B: along i, e = 1/5\nshow velocity(A) in the direction of velocity(B)"
    )
    assert "= 0 " not in shown[shown.index("in general") :]


@pytest.mark.parametrize(
    ("text", "hint"),
    [
        (
            (
                "wall AB: along i\nwall BC: along theta\nsphere P: velocity u at 40° to AB\n"
                "P hits AB: e = 1\nP hits BC: e = 1\ngiven velocity(P) opposite to velocity(P, 0)\n"
                "find theta"
            ),
            True,
        ),
        (
            (
                "sphere P: mass 3, at rest\nP receives 6i + 3j\nP receives 12 at theta from i\n"
                "given speed(P, 2) = 5\nfind theta"
            ),
            True,
        ),
        (
            (
                "wall W: along i\nsphere P: velocity 4 at theta to W\nP hits W: e = 1/2\n"
                "given speed(P) = 5\nfind theta"
            ),
            False,
        ),
    ],
)
def test_an_angle_that_would_be_obtuse_is_named(text: str, hint: bool) -> None:
    ((_, result),) = solve(parse(text)).items()
    assert result.error is not None
    assert ("write 'given theta < 180°'" in str(result.error)) is hint


def test_two_angles_in_numbers_are_compared() -> None:
    shown = working(
        "sphere A: mass 1, velocity 4i + 3j\nsphere B: mass 2, velocity -3i + 4j\n"
        "A hits B: along i, e = 1/2\nfind deflection(A), deflection(B)\n"
        "show deflection(B) < deflection(A)"
    )
    assert "not written" not in shown
    assert shown.endswith("From (3) and (4): (ii) φ < δ (as required) DM1 A1*")


@pytest.mark.parametrize(("bound", "reason"), [(">= 4/9", "sin²θ ≤ 1"), ("<= 1", "sin²θ ≥ 0")])
def test_a_bound_by_the_square_of_a_sine_has_its_reason(bound: str, reason: str) -> None:
    shown = working(
        "wall W: along j\nsphere P: mass m, velocity u at theta to W\nP hits W: e = 2/3\n"
        f"show energy(P)/energy(P, 0) {bound}"
    )
    assert f"as {reason} (as required)" in shown


# Statement, what its working says, and what it does not say.
SAYS = {
    "a sphere that stops where the condition does not hold": (
        (
            "wall W: along i\nwall V: along j\nsphere P: mass m, velocity u at 60° to W\n"
            "P hits W: e = e1\nP hits V: e = e2\nlet beta = angle(velocity(P), W)\n"
            "given beta = 60°\nfind total_energy_lost/energy(0) in terms of e1"
        ),
        "As P is still moving at the end, this holds for e₁ > 0 only.",
        "cannot happen otherwise",
    ),
    "a sphere that stays at a wall": (
        (
            "sphere P: mass m, at (0, 0), velocity u at alpha\n"
            "wall AB: from (2a, 0) to (2a, a)\nwall BC: from (2a, a) to (0, a)\n"
            "P hits AB\nP hits BC: e = 1/2\nfind range of tan(alpha)"
        ),
        "This holds for e > 0 only: if e = 0, P does not leave AB.",
        "cannot happen otherwise",
    ),
    "a sense by momentum": (
        (
            "sphere A: mass 2m, velocity u at alpha\nsphere B: mass k m, at rest\n"
            "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B)\n"
            "given speed(B) = 2 speed(A)\nfind k, e"
        ),
        "w = 2u sin α, as w > 0 by (2)",
        "as α is acute",
    ),
    "a sense by a coefficient, with an angle between two ends": (
        (
            "sphere A: mass 2m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
            "given angle(velocity(A), line_of_centres) = beta\nfind e in terms of alpha, beta"
        ),
        "as v = −(u sin α)/tan β would give e > 1 by (2) and (3)",
        "e ≤ 1 Subst",
    ),
    "a number and a multiple of e": (
        (
            "sphere A: mass k m, velocity u i\nsphere B: mass m, velocity -3u i\n"
            "A hits B: along i\ngiven A at rest\nfind k in terms of e\nshow 3 <= k\nshow k <= 7"
        ),
        "3 ≤ k, as e ≥ 0 (as required)",
        "increases with e",
    ),
    "a rest that is given in a later part": (
        (
            "sphere A, B: mass m\nsphere C: mass 3m, at rest\nsphere A: velocity u i\n"
            "sphere B: at rest\nA hits B: along i\nB hits C: along i\npart a\nfind speed(C)\n"
            "part b\ngiven B at rest\nfind e"
        ),
        "It is given that B is at rest: v₂ = 0 Substituting for w₂ from part (a) and v₂ in (3):",
        "unless",
    ),
    "a sense that a given bound of e makes certain": (
        (
            "wall W: along i\nwall V: along j\nsphere P: mass m, velocity u at alpha\n"
            "P hits W: e = e\nP hits V: e = e\ngiven e > 0\n"
            "show velocity(P) opposite to velocity(P, 0)"
        ),
        "So 𝐯₂ is opposite to 𝐮, since e > 0, as required.",
        "unless",
    ),
    "one of two roots with opposite signs": (
        (
            "wall OX: along i\nwall OY: along 45°\nsphere P: velocity u at 180° + alpha\n"
            "P hits OX: e = e\nP hits OY: e = e\ngiven velocity(P) perpendicular to OX\n"
            "find e in terms of alpha"
        ),
        "(2 sin α), as e ≥ 0",
        "unless",
    ),
    "a square that is not zero": (
        (
            "sphere A: mass 2m, velocity u i\nsphere B: mass 2m, at rest\n"
            "sphere C: mass 2m, at rest\nA hits B: along i, e = e\nB hits C: along i, e = e\n"
            "A hits B: e = e\nfind range of e"
        ),
        "(1 − e)² > 0 0 ≤ e < 1",
        "e² − 2e",
    ),
    "a ratio that stands on the right": (
        (
            "sphere A: mass 2m, velocity u i\nsphere B: mass m, velocity V j\nA hits B: along i\n"
            "given deflection(B) = theta\nfind e in terms of u, V, theta\n"
            "show 2u/(3V) <= tan(theta)"
        ),
        "2u/(3V) ≤ tan θ, as e ≥ 0 (as required)",
        "V ≥",
    ),
}


@pytest.mark.parametrize("name", SAYS)
def test_a_reason_is_the_one_that_a_reader_needs(name: str) -> None:
    statement, says, not_says = SAYS[name]
    shown = working(statement)
    assert says in shown
    assert not_says not in shown


@pytest.mark.parametrize("multiple", ["2", "3"])
def test_a_solution_that_is_another_one_wherever_it_is_possible_is_no_open_one(
    multiple: str,
) -> None:
    # With the angle from the line of centres taken the other way e = 1 alone is left.
    text = (
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
        f"A hits B: along i\ngiven angle(velocity(A), line_of_centres) = {multiple} alpha\nfind e"
    )
    assert not solve(parse(text)).warnings


def test_a_letter_by_which_an_inequality_is_divided_is_not_zero() -> None:
    shown = working(
        "wall W: along j\nsphere A: mass m, velocity 3u i\nsphere B: mass k m, at rest\n"
        "A hits B: along i, e = 1\nA hits W: e = f\ngiven A and B collide again\nfind range of k"
    )
    assert "k > (2 + f)/f, as f > 0" in shown


def test_letters_that_have_one_value_are_given_it_together() -> None:
    shown = working(
        "sphere A: mass m, velocity u i\nsphere B: mass m, at rest\nwall W: along j\n"
        "A hits B: along i\nB hits W: e = f\npart a\nfind velocity(B)\n"
        "part b\ngiven e = f = 1/2\nfind velocity(B)"
    )
    assert "Since e = ½ and f = ½, from (3)" in shown
    assert "It is given that" not in shown
