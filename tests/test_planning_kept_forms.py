"""Forms that are kept: a square beside a constant, a sum of times, a common factor."""

from __future__ import annotations

import pytest
from test_planning_closing import planned, said

from restitution.workings import to_text
from restitution.workings.derived import explanation_of

WALLS = """
wall L: along i, through (0, 0)
wall M: along i, through (0, {d})
sphere P: at ({x}, {b}), {velocity}
{given}P hits L: e = {e}
P hits M: e = {e}
P hits L: e = {e}
"""


@pytest.mark.parametrize(
    ("data", "way", "length"),
    [
        (
            {
                "d": "d",
                "x": "c",
                "b": "b",
                "velocity": "velocity u at -alpha",
                "given": "given 0 < b < d, c > 0\n",
                "e": "e",
            },
            "u cos(alpha) (d/(e u sin(alpha))) = d/(e tan(alpha))",
            (
                "sqrt((d/(e tan(alpha)))^2 + d^2) = d sqrt(1 + e^2 tan^2(alpha))/(e tan(alpha))"
                " = d sqrt(cos^2(alpha) + e^2 sin^2(alpha))/(e sin(alpha))"
            ),
        ),
        (
            {
                "d": "3",
                "x": "1",
                "b": "2",
                "velocity": "velocity 2i - 4j",
                "given": "",
                "e": "1/2",
            },
            "2(3/2) = 3",
            "sqrt(3^2 + 3^2) = 3sqrt(2)",
        ),
    ],
)
def test_between_two_impacts_a_body_comes_as_far_as_its_velocity_takes_it(
    data: dict[str, str], way: str, length: str
) -> None:
    solution, derivation = planned(
        f"{WALLS.format(**data)}find distance(position(P, 1), position(P, 2))"
    )
    shown = [each.replace(" [rearrange]", "") for each in said(derivation)]
    assert f"along(position(P, 2), i) - along(position(P, 1), i) = {way}" in shown
    assert shown[-1] == f"distance(position(P, 1), position(P, 2)) = {length}"
    # Neither when it began nor where it was is looked for.
    assert not any(each.startswith(("time(1) =", "along(position(P, 1), i) =")) for each in shown)
    text = to_text(explanation_of(derivation, solution.problem))
    assert "displacement of P along 𝐢 from the first impact to the second impact" in text
    assert "Distance, by Pythagoras:" in text
    assert ("= 3 m" in text) == (data["d"] == "3")


def test_a_distance_that_is_a_product_has_its_title() -> None:
    solution, derivation = planned(
        "wall W: along j, through (0, 0)\nsphere A: mass m, at (d, 0), velocity -u i\n"
        "sphere B: mass m, at (4d, 0), at rest\nA hits W: e = 0\n"
        "find distance(A, B, at time(1) + T)"
    )
    text = to_text(explanation_of(derivation, solution.problem))
    assert "Distance, from the coordinates:" in text


APART = """
wall W: along j, through (0, 0)
sphere A: mass 1, at ({near}, 0), velocity -{speed} i
sphere B: mass 1, at ({far}, {up}), velocity -{slow} i
A hits W: e = 1/2
find distance(A, B, at time(1) + T)
find minimum of distance(A, B, at time(1) + T) over T
"""


@pytest.mark.parametrize(
    ("data", "place", "length", "least"),
    [
        (
            {"near": "2", "speed": "2", "far": "9", "up": "5", "slow": "1"},
            "9i + 5j - (1 + T) i",
            "sqrt((8 - 2T)^2 + 5^2)",
            "distance(A, B, at time(1) + T) >= 5",
        ),
        (
            {"near": "d", "speed": "u", "far": "4d", "up": "d", "slow": "u"},
            "4d i + d j - u (d/u + T) i",
            "sqrt((3d - 3T u/2)^2 + d^2)",
            "distance(A, B, at time(1) + T) >= d",
        ),
    ],
)
def test_a_square_beside_a_constant_is_not_multiplied_out(
    data: dict[str, str], place: str, length: str, least: str
) -> None:
    solution, derivation = planned(APART.format(**data))
    shown = [each.replace(" [rearrange]", "") for each in said(derivation)]
    assert f"position(B, at time(1) + T) = {place}" in shown
    (distance,) = (e for e in shown if e.startswith("distance(A, B, at time(1) + T) = "))
    assert distance.endswith(f" = {length}")
    assert shown[shown.index(distance) + 1 :][0] == least
    root = length.removeprefix("sqrt(").split(" + ")[0]
    spoken = {"(8 - 2T)^2": "(8 − 2T)² ≥ 0", "(3d - 3T u/2)^2": "(3d − 3Tu/2)² ≥ 0"}[root]
    assert spoken in to_text(explanation_of(derivation, solution.problem))


def test_a_common_factor_is_taken_out_of_a_root_as_it_stands() -> None:
    _, derivation = planned(
        "wall AB: along i\nwall BC: along 180° - phi\nsphere P: velocity u at alpha to AB\n"
        "P hits AB: e = e\nP hits BC: e = e\nfind speed(P)"
    )
    last = said(derivation)[-1].replace(" [rearrange]", "")
    assert last.count(" = ") == 2
    assert last.endswith(
        "u sqrt((cos(alpha) cos(phi) - e sin(alpha) sin(phi))^2"
        " + e^2 (cos(alpha) sin(phi) + e sin(alpha) cos(phi))^2)"
    )


def test_fractions_with_different_sums_below_stand_over_one_line_before_they_cancel() -> None:
    solution, derivation = planned(
        "wall W: along j, through (d, 0)\nsphere A: mass m, at (-d, 0), velocity u i\n"
        "sphere B: mass m, at (0, 0), at rest\nA hits B: along i, e = e1\nB hits W: e = e2\n"
        "given e1 < 1\nA hits B: along i, e = e1\nfind position(A)"
    )
    text = " ".join(to_text(explanation_of(derivation, solution.problem)).split())
    assert (
        " = (1 − e₁)d/(1 + e₁) + 2(1 − e₁)e₁d/((1 + e₁)(1 − e₁ + e₂ + e₁e₂))"
        " = (1 − e₁)(1 + e₁ + e₂ + e₁e₂)d/((1 + e₁)(1 − e₁ + e₂ + e₁e₂))"
        " = (1 − e₁)(1 + e₁)(1 + e₂)d/((1 + e₁)(1 − e₁ + e₂ + e₁e₂))"
        " = (1 + e₂)(1 − e₁)d/(1 − e₁ + e₂ + e₁e₂)"
    ) in text
