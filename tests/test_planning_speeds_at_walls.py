"""A speed after a wall and its angle to that: both laws take its components."""

from __future__ import annotations

import pytest
from workings import planned, printed_with

from restitution.workings import to_text
from restitution.workings.derived import explanation_of

WALL = "wall W: along i\n"
# A statement, and what its working says, in this order.
CASES = {
    "degrees": (
        WALL
        + """sphere P: velocity u at alpha to W
P hits W: e = 1/2
given speed(P) = 4, angle(velocity(P), W) = 20°
find alpha, u
""",
        (
            "Parallel to W the velocity does not change: u cos α = 4 cos 20°",
            "Newton's experimental law: ½u sin α = 4 sin 20°",
            "Dividing (2) by (1): tan α = 2 tan 20°",
            "u² = (4 cos 20°)² + (8 sin 20°)²",
        ),
    ),
    "letters": (
        WALL
        + """sphere P: velocity u at alpha to W
P hits W
given speed(P) = v, angle(velocity(P), W) = beta
find u, alpha in terms of v, beta, e
""",
        (
            "u cos α = v cos β",
            "eu sin α = v sin β",
            "u sin α = (v sin β)/e, as 0° < β < 90°",
            "tan α = (tan β)/e",
            "α = arctan((tan β)/e)",
        ),
    ),
    "a tangent, with the impulse": (
        WALL
        + """sphere P: mass 0.2, velocity V at theta to W
P hits W: e = 0.6
given speed(P) = 5, tan(angle(velocity(P), W)) = 3/4
find V, theta
find impulse
""",
        (
            "tan β = ¾",
            "V cos θ = 5 × 0.8 = 4",
            "0.6V sin θ = 5 × 0.6 = 3",
            "V² = 4² + 5² = 41",
            "magnitude of the impulse = 0.2(3 + 5) = 1.6 N s",
        ),
    ),
    "the coefficient": (
        WALL
        + """sphere P: velocity 6 at alpha to W
P hits W
given speed(P) = 4, angle(velocity(P), W) = 30°
find alpha, e
""",
        ("6 cos α = 4 cos 30°", "6e sin α = 4 sin 30°", "e = √6/6"),
    ),
    "components": (
        """wall W: along j
sphere P: velocity a i + b j
P hits W: e = 1/3
given speed(P) = 5, cos(angle(velocity(P), W)) = 0.6, a > 0, b > 0
find a, b
""",
        ("cos β = 0.6", "b = 5 × 0.6", "⅓a = 5 × 0.8 = 4", "a = 12"),
    ),
    "a deflection with a tangent that is given": (
        """wall W: along j
sphere P: mass 2, velocity 10 at 50° to W
P hits W
given tan(angle(velocity(P), W)) = 3/4
find e, deflection(P)
""",
        ("tan β = ¾", "β ≈ 36.87°", "δ = 50° + β = 50° + arctan(3/4)", "≈ 86.9°"),
    ),
    "a deflection, with the impulse": (
        WALL
        + """sphere P: mass 2, velocity 10 at alpha to W
P hits W
given deflection(P) = 90°, speed(P) = 7.5
find impulse
""",
        ("away from W = 7.5 sin(90° − α) = 7.5 cos α = 4.5 m s⁻¹", "= 2(4.5 + 8) = 25 N s"),
    ),
    "a deflection of 60°, with the velocity": (
        WALL
        + """sphere P: velocity 8 at alpha to W
P hits W
given deflection(P) = 60°, speed(P) = 5
find velocity(P)
""",
        (
            "along 𝐣 = 5 sin(60° − α) = 5(√3 cos α − sin α)/2 = 5/7 m s⁻¹",
            "the component in the direction of 𝐢 stays 8 cos α = 20√3/7",
        ),
    ),
    "a deflection, with an impulse that is given": (
        WALL
        + """sphere P: mass 0.5, velocity v at theta to W
P hits W
given deflection(P) = 90°, speed(P) = 6, impulse = 5
find theta, v
""",
        ("away from W = 6 sin(90° − θ) = 6 cos θ", "5 = 0.5(6 cos θ + v sin θ)"),
    ),
    "nothing told before a slanting wall": (
        """wall W: along 3i + 4j
sphere P: mass 2
P hits W: e = 0.4
given speed(P) = 10, tan(angle(velocity(P), W)) = 3/4
find speed(P, 0), impulse
""",
        (
            "the component in the direction of 𝐭 stays 10 × 0.8 = 8 m s⁻¹",
            "10 × 0.6 = 0.4(𝐮_P · 𝐧)",
            "√(15² + 8²) = 17 m s⁻¹",
            "= 2(15 + 6) = 42 N s",
        ),
    ),
    "nothing told before a wall in degrees": (
        """wall W: along 30°
sphere P: mass 0.5
P hits W: e = 0.5
given speed(P) = 5, angle(velocity(P), W) = 25°
find speed(P, 0), angle(velocity(P, 0), W)
""",
        ("5 sin 25° = 0.5(𝐮_P · 𝐧)", "√((10 sin 25°)² + (5 cos 25°)²)", "≈ 43.0°"),
    ),
    "nothing told of the velocity before": (
        """wall W: along j
sphere P: mass 0.3
P hits W: e = 2/3
given speed(P) = 6, angle(velocity(P), W) = 30°
find speed(P, 0), angle(velocity(P, 0), W)
""",
        (
            "the component in the direction of 𝐣 stays 6 cos 30° = 3√3 m s⁻¹",
            "6 sin 30° = ⅔ × component of 𝐮_P along 𝐢",
            "component of 𝐮_P along 𝐢 = 4.5 m s⁻¹",
            "= √(4.5² + (3√3)²) = 3√21/2",
            "tan β = 4.5/(3√3) = √3/2",
        ),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_both_laws_take_the_components_of_the_speed_after(name: str) -> None:
    statement, parts = CASES[name]
    printed_with(statement, parts)


def test_a_later_part_takes_the_component_after_as_it_is_given() -> None:
    problem, derivation = planned("""wall W: along i
sphere P: mass 0.25
P hits W: e = 3/4
given speed(P) = 6, angle(velocity(P), W) = 30°
part a
find speed(P, 0)
part b
find impulse
""")
    text = to_text(explanation_of(derivation, problem))
    assert "magnitude of the impulse = 0.25(4 + 3) = 1.75 N s" in text
    assert "component of 𝐯_P" not in text
