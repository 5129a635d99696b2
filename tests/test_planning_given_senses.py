"""Ranges that come of the way a sphere moves along the line of centres, where that is given.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says.
"""

from __future__ import annotations

import pytest
from workings import planned

from restitution.explaining.lines.notation import write_relation
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

# A statement, and what its working says: lines, or parts of them.
CASES = {
    "back, in terms of e": (
        """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given direction(A) = 180°
find range of k in terms of e
""",
        ("It is given that the angle from 𝐢 to 𝐯_A is 180°:", "v < 0", "(1 − ek)u/(1 + k) < 0"),
    ),
    "back along its path from a wall": (
        """
wall OA: along i
wall OB: along 60°
sphere P: mass m, velocity u at theta from -i
P hits OA: e = 1/2
P hits OB: e = 1/3
given velocity(P) opposite to velocity(P, 1)
find tan(theta)
""",
        # tan⁻¹(½ tan θ) is 30°.
        ("It is given that 𝐯₂ is opposite to 𝐯₁, so P hits OB at right angles:", "= 2√3/3"),
    ),
    "back along its path from a wall at an unknown angle": (
        """
wall W: along alpha
sphere P: velocity 2 at 30°
P hits W: e = 1/2
given alpha < 180°, velocity(P) opposite to velocity(P, 0)
find alpha
""",
        ("√3 cos α + sin α = 0", "tan α = −√3", "α = 120°, as 0° < α < 180°"),
    ),
    "on along its path after a sphere": (
        """
sphere A: mass 3m, velocity 2u i + p j
sphere B: mass m, velocity -u i + u j
A hits B: along i, e = 1/2
given velocity(A) parallel to velocity(A, 0)
find p
""",
        ("so A has no component perpendicular to the line of centres:", "p = 0"),
    ),
    "on, as the ratio of two speeds": (
        """
sphere P: mass 3m, velocity 2u i
sphere Q: mass m, velocity -w i
P hits Q: along i, e = 1/2
given direction(P) = 0°
find range of w/u
""",
        ("(10u − 3w)/8 > 0", "w < 10u/3", "0 < w/u < 10/3"),
    ),
    "back, in numbers": (
        """
sphere P: mass 3, velocity 4i
sphere Q: mass M, velocity -2i
P hits Q: along i, e = 1/2
given direction(P) = 180°
find range of M
""",
        ("(12 − 5M)/(M + 3) < 0", "M > 12/5"),
    ),
    "against the line of centres as it is typed": (
        """
sphere P: mass 2m, velocity u j
sphere Q: mass k m, velocity -u j
P hits Q: along -j, e = 1/2
given direction(Q) = 90°
find range of k
""",
        ("It is given that the angle from 𝐢 to 𝐯_Q is 90°:",),
    ),
    "after a wall and another impact": (
        """
wall W: along j
sphere A: mass 2m, velocity 3u i
sphere B: mass m, at rest
A hits B: along i
B hits W: e = 1/2
A hits B: along i
given direction(A) = 180°
find range of e
""",
        ("v₃ < 0", "½ < e ≤ 1"),
    ),
    "back, against its own velocity along an axis": (
        """
sphere P: mass m, velocity 3u i
sphere Q: mass 2m, velocity -2u i
P hits Q: along i
given velocity(Q) opposite to velocity(Q, 0)
find range of e
""",
        ("Q moves in the direction of 𝐢, so w > 0", "5e − 1 > 0", "e > ⅕"),
    ),
    "the size of a component that is known to be negative": (
        """
sphere P: mass m, velocity 4u i
sphere Q: mass 3m, at rest
wall W: along j
P hits Q: along i
part a
given velocity(P) opposite to i
find range of e
part b
given velocity(P) opposite to i, e < 1
Q hits W
show speed(Q) > speed(P)
""",
        (
            "speed of P = (3e − 1)u, as e > ⅓",
            "speed of Q − speed of P = (1 + e)eu − (3e − 1)u = (1 − e)²u",
            "speed of Q > speed of P, as e < 1",
        ),
    ),
    "multiples of speeds whose components may have either sign": (
        """
sphere P: mass m, velocity 4u i
sphere Q: mass k m, at rest
P hits Q: along i, e = 1/3
given speed(P) < 1/3 speed(Q)
find range of k
""",
        (
            "(4(3 − k)u/(3(1 + k)))² < (1/9)(16u/(3(1 + k)))²",
            "(3k − 13)(3k − 5) < 0",
            "5/3 < k < 13/3",
        ),
    ),
    "an angle by a bound of the coefficient that is at most 1": (
        """
sphere P: mass m, velocity 2u at alpha
sphere Q: mass 3m, velocity -u i
P hits Q: along i
given velocity(Q) opposite to velocity(Q, 0)
part a
show e > (3 - 2 cos(alpha))/(1 + 2 cos(alpha))
part b
unknown e
find range of alpha
""",
        (
            "(3 − 2 cos α)/(1 + 2 cos α) < 1, as e ≤ 1",
            "cos α > ½, as α is acute",
            "0° < α < 60°",
        ),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_way_a_sphere_moves_bounds_letters(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem), 120)
    for each in lines:
        assert each in text, text


def test_directions_at_different_impacts_are_in_proportion() -> None:
    """A goes on from the first impact with −2i + 9j, B from the wall with −fi + 3j."""
    _, derivation = planned("""
wall W: along j
sphere A: mass 2, velocity 6i + 9j
sphere B: mass 4, velocity -3i + 3j
A hits B: along i, e = 1/3
B hits W: e = f
given velocity(B) in the direction of velocity(A)
find f
""")
    assert write_relation(derivation.items[0].answer) == "f = 2/3"


def test_who_moves_along_a_line_across_that_of_centres_has_no_component_along_it() -> None:
    text = """
sphere A: mass 1, velocity 5i + j
sphere B: mass 2, velocity i + 2j
A hits B: along i - j
given velocity(A) parallel to i + j
find e
"""
    told = " ".join(to_text(explain(solve(parse(text)), check=True)).split())
    assert "so A has no component along the line of centres:" in told
    assert "e = ⅕" in told
