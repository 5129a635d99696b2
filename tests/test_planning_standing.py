"""What stands in letters is used where a fact, a range or an item speaks of it again."""

from __future__ import annotations

import pytest

from restitution.explaining.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.letters import roles
from restitution.workings import explain, to_text

LOSSES = """
wall W: along i
wall X: along j
sphere P: mass m, velocity u at alpha to W
P hits W
P hits X
given 0 < e < 1
part a
find energy_lost(1)/energy_lost(2)
part b
given 2 energy_lost(1) < energy_lost(2)
find range of alpha
"""

BOUND = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given along(velocity(A), i) < 0
part a
find range of e
part b
given e = 2/3
find range of k
"""

EQUAL = """
wall AB: along i
wall BC: along j
sphere P: mass m, velocity u at alpha to AB
P hits AB: e = e1
P hits BC: e = e2
find speed(P)
part b
given e1 = e2, speed(P) = 2/3 u
find e1
"""

NAMED = """
let t = tan(alpha)
sphere A: mass 3m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 3/5
let gamma = angle(velocity(A), velocity(B))
show tan(gamma) = 5/3 t
find gamma
"""

PRODUCT = """
sphere A: mass 1, velocity 3i + 4j
sphere B: mass 1, velocity -3i
A hits B: along 2i - j, e = 1/2
find velocity(A), dot(velocity(A), line_of_centres)
"""


def printed(statement: str) -> str:
    """The working, which the follower accepts, as text."""
    problem = parse(statement)
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    return " ".join(to_text(explain(solution)).split())


@pytest.mark.quick
def test_a_ratio_in_letters_bounds_its_quantities() -> None:
    text = printed(LOSSES)
    assert "kinetic energy lost at the second impact > 0, as α is acute" in text
    _, later = text.split("(b)")
    assert "tan²α < ½" in later
    assert "sin²α" not in later


@pytest.mark.quick
def test_a_bound_above_takes_the_value_of_a_later_part() -> None:
    _, later = printed(BOUND).split("(b)")
    assert "⅔ > 1/k M1 k > 3/2, as k > 0 A1" in later


def test_a_root_that_equal_letters_leave_is_taken_from_the_line_above() -> None:
    text = printed(EQUAL)
    assert "2u/3 = u√(e₁² cos²α + e₁² sin²α) = e₁u" in text


def test_a_tangent_that_was_shown_gives_its_angle() -> None:
    text = printed(NAMED)
    assert text.count("tan γ = u sin α/") == 1
    assert "(as required) A1* tan γ = (5/3) tan α γ = arctan((5/3) tan α)" in text


def test_a_scalar_product_along_the_line_of_centres_is_the_component() -> None:
    text = printed(PRODUCT)
    assert "𝐯_A · (unit vector along the line of centres) = −4√5/5" in text


def test_a_half_is_that_of_an_energy_and_a_percentage_makes_no_decimals() -> None:
    text = printed(
        "wall W: along i\nsphere P: mass 0.5, velocity 3i - 8j\nP hits W: e = 0.5\nfind energy_lost"
    )
    assert "½ × 0.5(8² − 4²)" in text
    text = printed(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\ngiven energy_lost = 25% energy(0)\nfind alpha"
    )
    assert "v = ¼u cos α" in text
