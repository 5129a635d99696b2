"""Given facts that become equations: sums of angles, sizes of momenta, a sine after an impact."""

from __future__ import annotations

import re

import pytest
from test_planning_closing import planned, said

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

WALL = """
wall W: along i
sphere P: mass m, velocity u at {angle} to W
P hits W{e}
given {given}
find {asked}
"""
SPHERES = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass {mass}, at rest
A hits B: along i
let beta = angle(velocity(A), i)
given {given}
find {asked}
"""
SQUARE_TURN = """
wall W: along i - 2j
sphere P: mass 1, velocity 7i - 2j
P hits W
given {given}
find e
"""
SLANTING = """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along theta
given velocity(A) = 1/2 u i - 1/4 u j
find theta, e
"""
AFTER_A_WALL = """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
wall W: along j
A hits B: along i
B hits W
show A and B collide again
"""
COLLINEAR = """
sphere A: mass {mass}, velocity u i
sphere B: mass {other}, velocity {velocity}
A hits B: along i, e = 1/2
given {given}
find {asked}
"""
SLOWED = """
sphere A: mass m, velocity 5 at alpha
sphere B: mass {mass}, velocity {velocity}
A hits B: along i, e = 1/4
find angle(velocity(A), {line})
"""
AFTER = "angle(velocity(P), W)"

CASES = {
    "a sum of angles, one of which has no letter": (
        WALL.format(angle="alpha", e=": e = 1/4", given=f"alpha + {AFTER} = 90°", asked="alpha"),
        ["It is given that α + β = 90° (1)", "(tan α)(¼ tan α) = 1", "α = arctan 2"],
    ),
    "a difference of such angles": (
        WALL.format(angle="alpha", e=": e = 1/3", given=f"alpha - {AFTER} = 30°", asked="alpha"),
        ["α − β = 30°", "(tan α − ⅓ tan α)/(1 + ⅓ tan²α) = √3/3", "α = 60°"],
    ),
    "two angles by their sum and one of them": (
        WALL.format(angle="alpha", e="", given=f"deflection(P) = 75°, {AFTER} = 30°", asked="e"),
        ["α = 75° − 30° = 45°", "It is given that β = 30°: tan 30° = (√2 eu/2)/(√2 u/2) = e"],
    ),
    "two angles by their sum and their ratio": (
        WALL.format(
            angle="alpha", e="", given=f"deflection(P) = 90°, alpha = 2 {AFTER}", asked="e"
        ),
        ["3β = 90°", "α = 90° − 30° = 60°", "−(√3 u/2)(√3 eu/2) + (u/2)(u/2) = 0"],
    ),
    "two angles by their sum and difference": (
        WALL.format(
            angle="alpha", e="", given=f"deflection(P) = 75°, alpha - {AFTER} = 15°", asked="e"
        ),
        ["Eliminating α from (1) and (2): β = 30°", "tan 30° = (√2 eu/2)/(√2 u/2)"],
    ),
    "an angle that is half of what it was": (
        WALL.format(angle="2 theta", e=": e = 1/3", given=f"{AFTER} = theta", asked="theta"),
        ["tan θ = ⅓ × (2 tan θ/(1 − tan²θ))", "tan θ = √3/3, as θ is acute", "θ = 30°"],
    ),
    "a speed by one component and its angle": (
        WALL.format(
            angle="alpha", e="", given=f"speed(P) = v, {AFTER} = 30°, alpha = 60°", asked="v"
        ),
        ["Parallel to W the velocity does not change: u/2 = v cos 30°"],
    ),
    "sizes of momenta": (
        SPHERES.format(
            mass="3m", given="abs(momentum(A)) = abs(momentum(B)), e = 1/2", asked="alpha"
        ),
        ["√((⅕mu cos α)² + (2mu sin α)²) = √(((9/5)mu cos α)²)", "α = arctan(2√5/5)"],
    ),
    "an impulse of the sphere of known mass": (
        COLLINEAR.format(
            mass="2",
            other="m",
            velocity="-3 i",
            given="velocity(B) = 2 i, impulse = 4",
            asked="u, m",
        ),
        ["change of momentum of A along the line of centres: 4 = 2(u − (1 − u)/2)", "m = ⅘"],
    ),
    "an impulse of the sphere of known velocity": (
        COLLINEAR.format(mass="m", other="2m", velocity="-v i", given="impulse = 2m u", asked="v"),
        ["decrease in the momentum of A along the line of centres: 2mu = m(u − w)", "v = u"],
    ),
    "an angle to a line along which nothing moves": (
        SLOWED.format(mass="m", velocity="3 at 180° - alpha", line="i"),
        ["A moves perpendicular to 𝐢: angle between 𝐯_A and 𝐢 = 90° A1"],
    ),
    "an angle to a line along which a sphere moves": (
        SLOWED.format(mass="m", velocity="3 at 180° - alpha", line="j"),
        ["A moves in the direction of 𝐣: angle between 𝐯_A and 𝐣 = 0° A1"],
    ),
    "a right angle at a slanting wall": (
        SQUARE_TURN.format(given="deflection(P) = 90°"),
        ["−(12√5/5) × (12√5 e/5) + (11√5/5) × (11√5/5) = 0 DM1 e = 121/144"],
    ),
    "a perpendicular velocity at a slanting wall": (
        SQUARE_TURN.format(given="velocity(P) perpendicular to velocity(P, 0)"),
        ["is perpendicular to 𝐮_P, so the scalar product is zero: −(12√5 e/5)", "e = 121/144"],
    ),
    "an impulse at a wall after an impact": (
        AFTER_A_WALL.replace("at rest", "velocity -u i")
        .replace("mass m,", "mass k m,")
        .replace("show A and B collide again", "find impulse(2)"),
        ["= 2(1 + e)(k − 2 + 2ek)mu/(2 + k) M1 A1"],
    ),
    "a complement of an angle": (
        WALL.format(angle="theta", e=": e = 1/3", given=f"{AFTER} = 90° - theta", asked="theta"),
        ["tan(90° − θ) = ⅓u sin θ/(u cos θ) = ⅓ tan θ", "1/tan θ = ⅓ tan θ", "θ = 60°"],
    ),
    "a component that is positive away from a wall": (
        WALL.format(angle="30°", e="", given="deflection(P) = 45°", asked="e, energy_lost"),
        [
            "tan 15° = (eu/2)/(√3 u/2) DM1 e ≈ 0.464",
            "component of 𝐯_P away from W ≈ 0.4641u/2 ≈ 0.2321u",
        ],
    ),
    "an obtuse angle in letters": (
        SLOWED.format(mass="5m", velocity="-v i", line="i").replace("alpha", "45°"),
        ["Direction of motion: tan β = ", "β = 180° − arctan("],
    ),
    "a sine after an impact of spheres": (
        SPHERES.format(mass="m", given="sin(alpha) = 3/5, sin(beta) = 4/5", asked="e"),
        ["sin β = ⅘", "tan β = (3u/5)/(4(2 − e)u/15)", "tan β = 4/3", "e = 5/16"],
    ),
}


@pytest.mark.parametrize(("text", "lines"), CASES.values(), ids=CASES)
def test_a_given_fact_is_written_out(text: str, lines: list[str]) -> None:
    working = re.sub(r"\s+", " ", to_text(explain(solve(parse(text))), 200))
    assert "not written out" not in working
    for line in lines:
        assert line in working


def test_an_angle_that_may_be_both_is_acute() -> None:
    text = WALL.format(angle="2 theta", e=": e = 1/3", given=f"{AFTER} = theta", asked="theta")
    ((_, item),) = solve(parse(text)).items()
    assert [each.display for each in item.answers] == ["30°"]


def test_a_given_velocity_across_a_line_at_an_open_angle_is_followed() -> None:
    problem = parse(SLANTING)
    assert follow(plan(solve(problem)), Oracle(roles(problem))) == ()


def test_a_sum_that_is_never_zero_has_its_square_completed() -> None:
    working = re.sub(r"\s+", " ", to_text(explain(solve(parse(AFTER_A_WALL))), 200))
    assert "= u(1 − e + e²)/3 = u((e − ½)² + ¾)/3" in working


def test_a_speed_may_rest_on_alternatives() -> None:
    text = """
wall W: along i
sphere P: mass 1/2, velocity p i - 4j
P hits W
given speed(P, 0) = sqrt(17)
given speed(P)/speed(P, 0) = 5/sqrt(153)
find p, e
"""
    working = to_text(explain(solve(parse(text))))
    assert "p = 1 or p = −1" in working
    assert "not written out" not in working


def test_a_root_is_rejected_by_what_is_given() -> None:
    text = """
sphere A: mass 2, velocity u i + 2 j
sphere B: mass 3, velocity w i
A hits B: along i, e = 3/4
given along(velocity(A), i) = -3/8
given speed(A) = sqrt(265/64)
find u in terms of w
"""
    working = to_text(explain(solve(parse(text))))
    assert "v = −⅜ m s⁻¹, as this is given" in working


def test_a_denominator_with_a_root_is_made_rational_on_paper() -> None:
    _, derivation = planned(
        "sphere A: mass M, velocity 4i - 3j\nsphere B: mass 2, velocity i + 2j\n"
        "A hits B: along i - j, e = 1/2\ngiven impulse = 6\nfind M"
    )
    assert (
        "M = 2/(2sqrt(2) - 1) = 2(1 + 2sqrt(2))/((2sqrt(2) - 1) (1 + 2sqrt(2)))"
        " [rearrange] = 2(1 + 2sqrt(2))/7 [rearrange]"
    ) in said(derivation)


def test_a_number_beside_squares_of_ratios_stands_with_the_sum_of_both() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/4\n"
        "given speed(P) = u/2\nfind tan(alpha)"
    )
    told = said(derivation)
    at = told.index("4(sin^2(alpha) + cos^2(alpha)) = sin^2(alpha) + 16cos^2(alpha)")
    assert told[at - 1] == "4 = sin^2(alpha) + 16cos^2(alpha)"
    assert told[at + 1] == "sin^2(alpha) = 4cos^2(alpha)"


def test_a_cosine_with_a_root_in_a_root_comes_by_its_square() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/3\n"
        "given deflection(P) = 60°\nfind tan(alpha), speed(P)"
    )
    told = said(derivation)
    assert any(line.endswith("(5 + sqrt(13))/16 [rearrange]") for line in told)
    assert "sin^2(alpha) = (11 - sqrt(13))/16" in told


def test_a_coordinate_of_a_component_that_stays_is_by_the_whole_time() -> None:
    _, derivation = planned(
        "wall W: along i, through (0, 0)\nwall X: along i, through (0, d)\n"
        "sphere P: at (0, 0), velocity u at alpha\nP hits X: e = e\nP hits W: e = e\n"
        "find time(2) - time(1), position(P)"
    )
    told = said(derivation)
    assert not any(text.startswith("along(position(P, 1), i)") for text in told)
    (place,) = (text for text in told if text.startswith("along(position(P, 2), i)"))
    assert "u cos(alpha) (d/(u sin(alpha)) + d/(e u sin(alpha)))" in place
