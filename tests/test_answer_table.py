"""Answers without their working: their units, the columns in which they stand, and vectors."""

from __future__ import annotations

import json

import pytest
import sympy as sp

from restitution.export import contract
from restitution.export.answers import answers
from restitution.language import parse
from restitution.render.layout import display_point, display_vector
from restitution.render.text import to_text, width
from restitution.solving import solve

NUMBERS = """\
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
"""
LETTERS = """\
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i, e = 1/3
"""
PLACES = """\
wall W: along i, through (0, 0)
sphere P: mass 2, velocity 3i - 4j, at (0, 4)
P hits W: e = 1/2
"""


def units_of(text):
    found = json.loads(contract.to_json(contract.solved("-", solve(parse(text)))))
    return {item["text"]: item["unit"] for part in found["parts"] for item in part["items"]}


@pytest.mark.parametrize(
    ("head", "units"),
    [
        (
            NUMBERS,
            {
                "velocity(A)": "m s⁻¹",
                "speed(B)": "m s⁻¹",
                "along(velocity(A), i)": "m s⁻¹",
                "speed(A) - speed(B)": "m s⁻¹",
                "impulse": "N s",
                "impulse(A)": "N s",
                "momentum": "N s",
                "energy_lost": "J",
                "energy(A)/energy(0)": None,
                "energy_lost/energy(0) as a percentage": None,
                "mass(A)": "kg",
                "deflection(A)": None,
                "line_of_centres": None,
                "tan(deflection(A))": None,
            },
        ),
        (LETTERS, {"velocity(A)": None, "impulse": None, "energy_lost": None, "u": None}),
        (PLACES, {"time(1)": "s", "position(P)": "m"}),
        (
            "wall W: along i\nsphere P: mass m, velocity 3i - 4j\nP hits W: e = 1/2\n",
            {"speed(P)": "m s⁻¹", "impulse": None, "energy_lost": None},
        ),
        (
            "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W\n",
            {"speed(P)": "m s⁻¹", "impulse": "N s", "range of speed(P)": None},
        ),
        (
            (
                "wall W: along i\nsphere P: velocity u at 60° to W\nP hits W: e = 1/2\n"
                "given speed(P) = 3\n"
            ),
            {"u": "m s⁻¹"},
        ),
    ],
)
def test_units(head, units) -> None:
    assert units_of(head + "".join(f"find {each}\n" for each in units)) == units


def test_the_table_is_aligned() -> None:
    asked = "find velocity(A), impulse, line_of_centres, energy_lost, range of e"
    rows = answers(solve(parse(NUMBERS + asked))).splitlines()
    assert len(rows) == 5
    assert len({width(row.partition(" = ")[0]) for row in rows[:4]}) == 1
    units = {0: "m s⁻¹", 1: "N s", 3: "J"}
    for number, unit in units.items():
        assert rows[number].endswith(f"  {unit}")
    assert len({width(rows[number]) - width(unit) for number, unit in units.items()}) == 1
    assert rows[4].startswith("range of e: ")


def test_units_stand_before_what_was_rejected() -> None:
    text = "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W\n"
    (row,) = answers(solve(parse(text + "given energy_lost = 7\nfind impulse"))).splitlines()
    value, _, beside = row.partition("(rejected: ")
    assert value.rstrip().endswith("N s")
    assert "N s, as " in beside


def test_what_was_rejected_is_told_of_the_letter_alone() -> None:
    text = "wall W: along i\nsphere P: mass 2, velocity 13 at 55° to W\nP hits W\n"
    rows = answers(solve(parse(text + "given speed(P) = 10\nfind e, impulse"))).splitlines()
    assert ["rejected" in row for row in rows] == [True, False]


def test_a_number_of_several_angles_of_a_calculator_is_its_digits() -> None:
    text = """sphere A: mass 3, velocity 5 at 35°
sphere B: mass 4, velocity 3 at 100°
A hits B: along i, e = 0.6
find speed(A), direction(A), velocity(B)"""
    rows = answers(solve(parse(text))).splitlines()
    assert len(rows) == 3 and not any("sin" in row or "arctan" in row for row in rows)


@pytest.mark.parametrize("form", ["markdown", "latex", "html"])
def test_units_in_other_forms(form) -> None:
    said = answers(solve(parse(NUMBERS + "find velocity(A), impulse")), form)
    assert {
        "markdown": "\u00a0m\u00a0s⁻¹",
        "latex": r"~m~s$^{-1}$",
        "html": "\u00a0m\u00a0s⁻¹</span></li>",
    }[form] in said
    assert "N" in said


u = sp.Symbol("u")


@pytest.mark.parametrize(
    ("x", "y", "shown"),
    [
        (u / 4, sp.sqrt(2) * u / 3, "(u/4)𝐢 + (√2 u/3)𝐣 = 0.250u𝐢 + 0.471u𝐣"),
        (-u / 2, 3 * u / 7, "−(u/2)𝐢 + (3u/7)𝐣"),
        (2 * u, 3 * u / 7, "2u𝐢 + (3u/7)𝐣"),
        (sp.Rational(1, 2), sp.sqrt(2), "½𝐢 + √2 𝐣 = 0.500𝐢 + 1.41𝐣"),
        (sp.Rational(1, 2), sp.Rational(3, 4), "½𝐢 + ¾𝐣"),
    ],
)
def test_components_are_alike(x, y, shown) -> None:
    assert to_text(display_vector(x, y)) == shown


def test_coordinates_are_alike() -> None:
    assert to_text(display_point(u / 4, sp.sqrt(2) * u)) == "(u/4, √2 u) = (0.250u, 1.41u)"
