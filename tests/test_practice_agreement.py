"""Sides that agree exactly, to the figures typed, or not."""

from __future__ import annotations

import pytest
from lines_of_practice import claim, meanings, world_of

from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.arrays import UnvaluedError

WALL = """
wall W: along i
sphere P: mass 0.6, velocity 5i - 3j
P hits W: e = 0.7
find speed(P), deflection(P)
"""
OF_WALL = meanings(
    {
        "v": "speed(P)",
        "w": "along(velocity(P), j)",
        "a": "angle(velocity(P, 0), W)",
        "b": "angle(velocity(P), W)",
        "d": "deflection(P)",
        "I": "impulse",
        "F": "impulse(P)",
        "r": "velocity(P)",
    }
)
LETTERS = """
sphere A: mass 2m, velocity u at 30°
sphere B: mass 3m, at rest
A hits B: along i
find velocity(A), velocity(B)
"""
OF_LETTERS = meanings(
    {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)", "y": "along(velocity(B), j)"}
)

# v = √(25 + 4.41) = 5.4231…, a = 30.964°, b = 22.782°, d = 53.746°, I = 3.06


@pytest.mark.parametrize(
    ("text", "grade"),
    [
        ("w = 0.7*3", "exact"),
        ("w = 2.1", "exact"),
        ("v^2 = 29.41", "exact"),
        ("v = 5.42", "rounded"),
        ("v = 5.423", "rounded"),
        ("v = 5.4", "coarse"),
        ("v = 5.43", None),
        ("v = 5.5", None),
        ("v = sqrt(25 + 4.41)", "exact"),
        ("I = 0.6*(3 + 2.1)", "exact"),
        ("I = 3.06", "exact"),
        ("I = 3.1", "coarse"),
        ("I = 0.6*(3 - 2.1)", None),
        ("0.5*0.6*v^2 = 8.823", "exact"),
        ("0.5*0.6*v^2 = 8.82", "rounded"),
        ("0.5*0.6*5.42^2 = 8.81", "rounded"),
        ("b = 22.8", "rounded"),
        ("b = 22.8°", "rounded"),
        ("b = 23", "rounded"),
        ("b = 23°", "rounded"),
        ("b = 22", None),
        ("b = 0.398", "rounded"),
        ("b = arctan(2.1/5)", "exact"),
        ("tan(b) = 0.42", "exact"),
        ("a + b = 53.7", "rounded"),
        ("d = a + b", "exact"),
        ("d = 180 - 126.25", "rounded"),
        ("d = 31 + 22.8", "rounded"),
        ("5 cos(22.8) = 4.61", "rounded"),
        ("v cos(23°) = 5", "rounded"),
        ("arctan(0.42) = 22.8", "rounded"),
        ("r = 5i + 2.1j", "exact"),
        ("r = (5, 2.1)", "exact"),
        ("r = 5i - 2.1j", None),
        ("F = 3.06j", "exact"),
        ("abs(r) = 5.42", "rounded"),
        ("along(F, i) = 0", "exact"),
        ("0 = along(r, j) - 0.7*3", "exact"),
        ("v > 5", "exact"),
        ("v < 5.42", "rounded"),
        ("v < 5", None),
        ("w >= 2.1", "exact"),
        ("w > 2.1", None),
        ("P = 5i + 2.1j", "exact"),
        ("P = 5.42", "rounded"),
        ("P = 5.5", None),
    ],
)
def test_a_line_of_numbers(text: str, grade: str | None) -> None:
    line, decimals = claim(text)
    assert agrees(line, world_of(WALL), OF_WALL, decimals) == grade


@pytest.mark.parametrize(
    ("text", "grade"),
    [
        ("2m u cos(30°) = 2m v + 3m w", "exact"),
        ("2u cos(30) = 2v + 3w", "exact"),
        ("2 u*0.866 = 2v + 3w", "rounded"),
        ("1.732u = 2v + 3w", "rounded"),
        ("1.73u = 2v + 3w", "rounded"),
        ("1.7u = 2v + 3w", "coarse"),
        ("2u sin(30) = 2v + 3w", None),
        ("w - v = e u cos(30)", "exact"),
        ("w - v = u cos(30)", None),
        ("w - v = e u", None),
        ("y = 0", "exact"),
        ("v - v = 0", "exact"),
        ("v = 0", None),
        ("w > v", "exact"),
        ("w < v", None),
        ("w > 0", "exact"),
        ("velocity(B) = w i", "exact"),
        ("velocity(B) - w i = 0", "exact"),
    ],
)
def test_a_line_of_letters(text: str, grade: str | None) -> None:
    line, decimals = claim(text)
    assert agrees(line, world_of(LETTERS), OF_LETTERS, decimals) == grade


def test_of_several_values_one_has_to_hold() -> None:
    line, decimals = claim("w = 1.9")
    either = Claim(line.left, "=", line.right, (claim("w = 2.1")[0].right,))
    assert agrees(either, world_of(WALL), OF_WALL, decimals) == "exact"
    assert agrees(line, world_of(WALL), OF_WALL, decimals) is None


def test_angles_are_the_same_after_a_whole_turn() -> None:
    world = world_of("sphere P: mass 1, velocity 1 at -100°\nfind direction(P)")
    for text in ("direction(P) = 260", "direction(P) = -100°", "direction(P) + 360 = 260"):
        assert agrees(claim(text)[0], world) == "exact", text
    assert agrees(claim("direction(P) = 80")[0], world) is None


def test_what_cannot_be_compared_is_an_error() -> None:
    for text in ("r = 3", "r = v", "x = 3", "v = r"):
        with pytest.raises(UnvaluedError):
            agrees(claim(text)[0], world_of(WALL), OF_WALL)


def test_a_bare_name_is_no_number_of_another_kind() -> None:
    assert agrees(claim("P = 2i")[0], world_of(WALL), OF_WALL) is None


def test_a_result_that_is_shown_to_some_figures_is_rounded() -> None:
    world = world_of(
        """
        sphere A: mass m, velocity u at 30°
        sphere B: mass m, velocity u at 60° from -i
        A hits B: along i, e = sqrt(3)/3
        show energy_lost = 0.311m u^2 to 3 s.f.
        """
    )
    line, decimals = claim("energy_lost = 0.311m u^2")
    assert agrees(line, world, {}, decimals) == "rounded"


def test_the_direction_of_a_line_is_told_by_any_vector_along_it() -> None:
    world = world_of(
        """
        wall W
        sphere P: velocity 4i - 2j
        P hits W
        given velocity(P) = 2i + 2j
        find direction(W), e
        """
    )
    table = meanings({"d": "direction(W)"})
    for text in ("direction(W) = 2i + j", "d = -4i - 2j", "line_of_centres = i - 2j"):
        assert agrees(claim(text)[0], world, table) == "exact", text
    for text in ("direction(W) = i + 2j", "d = 2i - j"):
        assert agrees(claim(text)[0], world, table) is None, text


@pytest.mark.parametrize(
    "text", ["9^9^9^9 = v", "v = 9^9^9^9", "v = 1.5*9^9^9", "v = arcsin(2)", "v = sqrt(2 - 3)"]
)
def test_what_is_beyond_numbers_agrees_with_nothing(text: str) -> None:
    line, decimals = claim(text)
    assert agrees(line, world_of(WALL), OF_WALL, decimals) is None


def test_a_rounded_term_is_no_datum_of_the_same_number() -> None:
    # 3 cos 48° = 2.007, and 2 is a mass.
    statement = """
        sphere A: mass 2, velocity 5 at 30°
        sphere B: mass 3, velocity 3 at 132°
        A hits B: along i, e = 1/2
        find velocity(A)
    """
    world = world_of(statement)
    separation = "along(velocity(B), i) - along(velocity(A), i)"
    for text, grade in (("4.33 + 2.0", "coarse"), ("4.33 + 2", None), ("4.33 + 2.2", None)):
        line, decimals = claim(f"{separation} = ({text})/2")
        assert agrees(line, world, {}, decimals) == grade, text
