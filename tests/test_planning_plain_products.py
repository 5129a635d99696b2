"""Newton's law by scalar products with a vector whose length cancels."""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

FOUND = """
sphere A: mass 5, velocity 7i - 6j
sphere B: mass 3, velocity -4i - 8j
A hits B
given velocity(A) = i - 9j
find velocity(B), e
"""
AT_A_WALL = """
wall W: along i - 2j
sphere S: velocity 7i + j
S hits W
given velocity(S) = -2i - 7/2 j
find e
"""
WITH_A_MASS = AT_A_WALL.replace("velocity 7i", "mass 2, velocity 7i")
# The component itself is asked too.
USED_AGAIN = AT_A_WALL.replace("find e", "find e, along(velocity(S), 2i + j)")
BY_THE_IMPULSE = """
sphere A: mass 2, velocity 3i + a j
sphere B: mass 1, velocity -i
A hits B: e = 1/3
given impulse(B) = 4i + 2j
find a
"""
# The unit vector of 3𝐢 + 4𝐣 has no root.
WITHOUT_A_ROOT = """
wall W: along 3i + 4j
sphere S: velocity 10i + 5j
S hits W
given velocity(S) = 4i + 19/2 j
find e
"""


def printed(text: str) -> str:
    problem = parse(text)
    solution = solve(problem)
    assert follow(plan(solution), Oracle(roles(problem))) == ()
    return " ".join(to_text(explain(solution)).split())


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (
            FOUND,
            (
                "Scalar products with 2𝐢 + 𝐣, along the line of centres, before the impact:",
                "𝐮_A · (2𝐢 + 𝐣) = 2 × 7 − 6 = 8",
                "9 + 7 = e(8 + 16)",
            ),
        ),
        (
            AT_A_WALL,
            (
                "Scalar product with 2𝐢 + 𝐣, perpendicular to W, before the impact:",
                "after the impact: 𝐯_S · (2𝐢 + 𝐣) = −2 × 2 − 7/2 = −15/2",
                "15/2 = 15e",
            ),
        ),
    ],
)
def test_the_length_of_a_vector_along_the_line_cancels(
    statement: str, lines: tuple[str, ...]
) -> None:
    text = printed(statement)
    assert "√5" not in text
    for line in lines:
        assert line in text


def test_an_impulse_and_a_loss_come_by_the_vectors_and_no_root_is_written() -> None:
    text = printed(WITH_A_MASS.replace("find e", "find e, impulse, energy_lost"))
    assert "15/2 = 15e" in text
    assert "impulse on S = 2((−2𝐢 − (7/2)𝐣) − (7𝐢 + 𝐣))" in text
    # 18² + 9² = 9² × 5.
    assert "magnitude of the impulse = √(18² + 9²) = 9√5" in text
    # 50 − 65/4 joules.
    assert "kinetic energy lost = ½ × 2(7² + 1²) − ½ × 2(2² + (7/2)²) = 135/4" in text
    assert "√5 m s⁻¹" not in text


def test_of_no_loss_no_mass_is_cited() -> None:
    text = printed(
        "wall W\nsphere P: mass 0.5, velocity 5i + 10j\nP hits W\n"
        "given velocity(P) = -2i + 11j\nfind e, energy_lost"
    )
    assert "kinetic energy lost = ½ × 0.5(5² + 10²) − ½ × 0.5(2² + 11²) = 0" in text


def test_a_coefficient_in_numbers_stands_beside_scalar_products() -> None:
    text = printed(BY_THE_IMPULSE)
    assert "𝐮_B · (2𝐢 + 𝐣) = −2" in text
    assert "8 − (a + 1) = ⅓(a + 6 + 2)" in text
    assert "√5" not in text


@pytest.mark.parametrize("statement", [USED_AGAIN, WITHOUT_A_ROOT])
def test_a_component_that_is_needed_or_plain_stays(statement: str) -> None:
    assert "Scalar products" not in printed(statement)


@pytest.mark.parametrize(
    ("statement", "line"),
    [
        (
            (
                "sphere A: mass 2, velocity 3i + 4j\nsphere B: mass 3, velocity -i + j\n"
                "A hits B: along i + j, e = 0\nfind distance(A, B, at 3)"
            ),
            "𝐮_B · 𝐭 = (1 + 1)/√2 = √2 m s⁻¹",
        ),
        (
            (
                "wall W: along i + j\nsphere P: mass 2, velocity 4i - 4j\n"
                "P hits W: e = 1/2\nfind velocity(P)"
            ),
            "𝐮_P · 𝐧 = (4 + 4)/√2 = 4√2 m s⁻¹",
        ),
    ],
)
def test_who_moves_along_the_line_itself_has_a_scalar_product_too(
    statement: str, line: str
) -> None:
    assert line in printed(statement)


def test_the_unit_vector_along_the_line_keeps_its_letter_in_a_product() -> None:
    text = printed(
        "sphere A: mass 1, velocity 3i + 4j\nsphere B: mass 1, velocity -3i\n"
        "A hits B: along 2i - j, e = 1/2\n"
        "find line_of_centres, velocity(A), dot(velocity(A), line_of_centres)"
    )
    assert "unit vector along the line of centres = (2𝐢 − 𝐣)/√5" in text
    assert "𝐯_A · 𝐧 = −4√5/5" in text
