"""Angles that directions tell at sight, right angles, and tangents of sums of two letters."""

from __future__ import annotations

import pytest
from derivations import oracle_of
from workings import planned

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

STRUCK = """
sphere A: mass m, velocity {velocity}{more}
sphere B: mass 3m, at rest
A hits B: {line}, e = 1/3
find {asked}
"""
AT_A_WALL = """
wall W: along i
sphere P: velocity u at theta to W
P hits W
"""
FROM_REST = "B was at rest, so it moves along the line of centres:"

# A statement, what its working says, and what it does not.
CASES: dict[str, tuple[str, tuple[str, ...], tuple[str, ...]]] = {
    "a right angle between two velocities in a letter": (
        """
sphere A: mass m, velocity 3u i + 2u j
sphere B: mass 2m, velocity u i - u j
A hits B: along i, e = 1/2
find angle(velocity(A), velocity(B))
""",
        ("𝐯_A · 𝐯_B = u × 2u − 2u × u = 0", "angle between 𝐯_A and 𝐯_B = 90°"),
        ("arctan",),
    ),
    "who was at rest, by an offset, to an axis": (
        STRUCK.format(
            velocity="u i", more=", radius a", line="offset a", asked="angle(velocity(B), i)"
        ),
        (FROM_REST, "angle between 𝐯_B and 𝐢 = 30°"),
        ("in the direction of −𝐢", "Let w"),
    ),
    "who was at rest, by an offset, to a velocity": (
        STRUCK.format(
            velocity="u i",
            more=", radius a",
            line="offset a",
            asked="angle(velocity(B), velocity(A, 0))",
        ),
        (FROM_REST, "angle between 𝐯_B and 𝐮_A = 30°"),
        ("in the same ratio",),
    ),
    "a velocity in degrees from a slanting line of centres": (
        STRUCK.format(
            velocity="5 at 140° from -i - j", more="", line="along i + j", asked="velocity(B)"
        )
        .replace("mass m", "mass 2")
        .replace("mass 3m", "mass 3"),
        ("𝐮_A · 𝐧 = 5 cos 40° ≈ 3.830", "((8/3) cos 40°)((𝐢 + 𝐣)/√2)", "≈ (1.44𝐢 + 1.44𝐣)"),
        ("cos 5°", "cos 40° 𝐢"),
    ),
    "a velocity in a letter from a slanting line of centres": (
        STRUCK.format(
            velocity="u at alpha from 3i + 4j", more="", line="along 3i + 4j", asked="speed(A)"
        ),
        ("𝐮_A · 𝐧 = u cos α", "𝐮_A · 𝐭 = u sin α"),
        ("3 cos α",),
    ),
    "who was at rest, to a velocity in degrees": (
        STRUCK.format(
            velocity="u at 60°", more="", line="along i", asked="angle(velocity(B), velocity(A, 0))"
        ),
        (FROM_REST, "angle between 𝐯_B and 𝐮_A = 60°"),
        ("Conservation",),
    ),
    "who was at rest, to a velocity at a letter": (
        STRUCK.format(
            velocity="u at alpha",
            more="",
            line="along i",
            asked="angle(velocity(B), velocity(A, 0))",
        ),
        (FROM_REST, "angle between 𝐯_B and 𝐮_A = α"),
        ("arccos",),
    ),
    "across a line that slants, to an axis": (
        STRUCK.format(velocity="u i", more="", line="along 4i + 3j", asked="angle(velocity(A), i)"),
        ("𝐮_A · 𝐭 = −3u/5", "tan β = 4/3"),
        (),
    ),
    "two directions of the data": (
        """
sphere A: mass 2m, velocity u at 30° from i
sphere B: mass m, velocity 2u at 130° from i
A hits B: along i, e = 1/2
find angle(velocity(A, 0), velocity(B, 0))
""",
        ("Difference of the directions from 𝐢:", "= 130° − 30° = 100°"),
        ("Scalar product",),
    ),
    "the size of a velocity is that which is given": (
        """
wall AB: along i
wall BC: along 60 deg
sphere P: mass m, velocity u at 30° to AB
P hits AB: e = 1
P hits BC: e = 1
show speed(P) = u
show angle(velocity(P), velocity(P, 0)) = 120°
""",
        ("cos β = −u(u/2)/(u × u) = −½",),
        (),
    ),
    "the tangent of a sum is found": (
        AT_A_WALL + "let phi = angle(velocity(P), W)\nfind tan(theta + phi)",
        (
            "By the formula for the tangent of a sum:",
            "tan(θ + φ) = (tan θ + tan φ)/(1 − tan θ tan φ)",
            "= (1 + e) tan θ/(1 − e tan²θ)",
        ),
        ("|",),
    ),
    "the tangent of a sum is shown": (
        AT_A_WALL
        + "let phi = angle(velocity(P), W)\n"
        + "show tan(theta + phi) = (1 + e) tan(theta)/(1 - e tan^2(theta))",
        ("tan(θ + φ) = (tan θ + e tan θ)/(1 − e tan²θ)",),
        ("not written out",),
    ),
    "the tangent of a difference that rests on a letter": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
let beta = angle(velocity(A), i)
find tan(beta - alpha)
""",
        ("tan(β − α) = (4 tan α − tan α)/(1 + 4 tan²α)", "= 3 tan α/(1 + 4 tan²α)"),
        ("|", "cannot be found"),
    ),
    "a deflection at a wall, with its angle given below": (
        AT_A_WALL + "given theta = 60°\nfind range of deflection(P)",
        ("δ = 60° + β = 60° + arctan(√3 e)", "60° ≤ δ ≤ 120°"),
        ("derivative",),
    ),
    "a deflection at a wall by a tangent of an earlier part": (
        AT_A_WALL
        + "given 0 < e < 1\npart a\nlet phi = angle(velocity(P), W)\nfind tan(phi)\n"
        + "part b\ngiven theta = 60°\nfind range of deflection(P)",
        ("tan φ = √3 e", "δ = 60° + φ", "60° < δ < 120°"),
        ("not written out",),
    ),
    "a deflection that stands, with degrees put in": (
        AT_A_WALL
        + "part a\nfind deflection(P)\npart b\ngiven theta = 60°\nfind range of deflection(P)",
        ("Since θ = 60°, from (1):", "  δ = 60° + arctan(√3 e)"),
        ("π",),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_an_angle_is_seen(name: str) -> None:
    statement, lines, others = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    assert not [each for each in lines if each not in text], text
    assert not [each for each in others if each in text], text
    assert not follow(derivation, oracle_of(problem))


@pytest.mark.parametrize(
    ("velocities", "rest", "told"),
    [
        (
            ("u i", "0i"),
            "e = e\ngiven e k > 1\nshow angle(velocity(A), velocity(B)) = 180°",
            "As v < 0 (since ek > 1), A and B move along the line of centres, opposite ways:",
        ),
        (
            ("3u i", "u i"),
            "e = 1/3\ngiven k < 2\nfind angle(velocity(A), velocity(B))",
            "As v > 0 and w > 0, A and B move along the line of centres, the same way:",
        ),
    ],
)
def test_two_spheres_on_one_line_make_no_angle_or_a_straight_one(
    velocities: tuple[str, str], rest: str, told: str
) -> None:
    """It was said that one moves at right angles to the line, or nothing was written out."""
    statement = (
        f"sphere A: mass m, velocity {velocities[0]}\n"
        f"sphere B: mass k m, velocity {velocities[1]}\nA hits B: along i, {rest}"
    ).replace("velocity 0i", "at rest")
    said = " ".join(str(explain(solve(parse(statement)), check=True)).split())
    assert told in said
    assert "follow" not in said
