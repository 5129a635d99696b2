"""Solve forward, forget a given, solve it back; and what must not depend on the frame or units.

The forward values are computed here, in fractions, from the textbook principles.
"""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from restitution.language import parse
from restitution.solving import solve

WHOLE = st.integers(-9, 9)
MASS = st.integers(1, 6)
COEFFICIENT = st.fractions(0, 1, max_denominator=6)
few = settings(max_examples=25, deadline=None, print_blob=True)


def collide(m: int, u: Fraction, k: int, w: Fraction, e: Fraction) -> tuple[Fraction, Fraction]:
    """Components along the line of centres after, from momentum and Newton's law together."""
    total = m * u + k * w
    apart = e * (u - w)
    first = Fraction(total - k * apart, m + k)
    return first, first + apart


def answers(text: str, item: str) -> list[object]:
    result = solve(parse(text))[item]
    assert result.error is None, result.error
    return [answer.value for answer in result.answers]


def exact(x: Fraction) -> sp.Rational:
    return sp.Rational(x.numerator, x.denominator)


@st.composite
def impacts(draw: st.DrawFn) -> dict[str, Fraction | int]:
    """Two spheres with line of centres along i, A moving so that it does reach B."""
    data = {
        "m": draw(MASS),
        "k": draw(MASS),
        "a": draw(st.integers(1, 9)),
        "b": draw(WHOLE),
        "c": draw(st.integers(-9, 8)),
        "d": draw(WHOLE),
        "e": draw(COEFFICIENT),
    }
    assume(data["a"] > data["c"])
    data["v"], data["w"] = collide(data["m"], data["a"], data["k"], data["c"], data["e"])
    return data


STORY = """
sphere A: mass {m}, velocity ({a}, {b})
sphere B: mass {k}, velocity ({c}, {d})
A hits B: along i, e = {e}
"""


def story(data: dict[str, Fraction | int], **changed: object) -> str:
    return STORY.format(**{**data, **changed})


@few
@given(impacts())
def test_forward(data: dict[str, Fraction | int]) -> None:
    text = story(data) + "find velocity(A), velocity(B)"
    assert answers(text, "velocity(A)") == [(exact(data["v"]), data["b"])]
    assert answers(text, "velocity(B)") == [(exact(data["w"]), data["d"])]


@few
@given(impacts())
def test_the_coefficient_comes_back_from_a_velocity(data: dict[str, Fraction | int]) -> None:
    text = story(data, e="e") + f"given velocity(B) = ({data['w']}, {data['d']})\nfind e"
    assert answers(text, "e") == [exact(data["e"])]


@few
@given(impacts())
def test_the_coefficient_comes_back_from_the_energy_lost(data: dict[str, Fraction | int]) -> None:
    m, k = data["m"], data["k"]
    lost = Fraction(m, 2) * (data["a"] ** 2 - data["v"] ** 2) + Fraction(k, 2) * (
        data["c"] ** 2 - data["w"] ** 2
    )
    text = story(data, e="e") + f"given energy_lost = {lost}\nfind e"
    assert answers(text, "e") == [exact(data["e"])]


@few
@given(impacts())
def test_a_mass_comes_back(data: dict[str, Fraction | int]) -> None:
    assume(data["c"] != data["w"])
    text = story(data, k="k") + f"given velocity(A) = ({data['v']}, {data['b']})\nfind k"
    assert answers(text, "k") == [data["k"]]


@few
@given(impacts())
def test_a_component_before_comes_back(data: dict[str, Fraction | int]) -> None:
    text = story(data, a="p") + f"given velocity(B) = ({data['w']}, {data['d']})\nfind p"
    assert data["a"] in answers(text, "p")


@few
@given(impacts())
def test_the_line_of_centres_comes_back(data: dict[str, Fraction | int]) -> None:
    text = (
        story(data, e="e").replace("along i, ", "")
        + f"given velocity(A) = ({data['v']}, {data['b']})\nfind line_of_centres, e"
    )
    assert answers(text, "line_of_centres") == [(1, 0)]
    assert answers(text, "e") == [exact(data["e"])]


@few
@given(WHOLE, st.integers(1, 9), COEFFICIENT)
def test_a_wall_comes_back(along: int, towards: int, e: Fraction) -> None:
    assume((along, e) != (0, 0))
    text = (
        f"wall W\nsphere P: velocity ({along}, {-towards})\nP hits W\n"
        f"given velocity(P) = ({along}, {e * towards})\nfind direction(W), e"
    )
    ((x, y),) = answers(text, "direction(W)")
    assert y == 0
    assert x != 0
    assert answers(text, "e") == [exact(e)]


@pytest.mark.parametrize("quantity", ["speed(P)", "deflection(P)", "impulse"])
@pytest.mark.parametrize("e", ["1/3", "3/4", "1"])
def test_an_acute_angle_comes_back(quantity: str, e: str) -> None:
    body = f"wall W: along i\nsphere P: mass 2, velocity 5 at {{}} to W\nP hits W: e = {e}\n"
    value = solve(parse(body.format("arctan(4/3)") + f"find {quantity}"))[quantity].exact
    shown = str(value).replace("atan", "arctan").replace("**", "^")
    if quantity == "speed(P)" and e == "1":
        return  # the speed says nothing of the angle then
    text = body.format("alpha") + f"given {quantity} = {shown}\nfind tan(alpha)"
    assert sp.Rational(4, 3) in answers(text, "tan(alpha)")


@few
@given(impacts())
def test_a_turned_frame_turns_the_answers(data: dict[str, Fraction | int]) -> None:
    """Everything turned by the angle of the 3-4-5 triangle."""

    def turned(x: Fraction | int, y: Fraction | int) -> tuple[Fraction, Fraction]:
        return (3 * Fraction(x) - 4 * Fraction(y)) / 5, (4 * Fraction(x) + 3 * Fraction(y)) / 5

    (ax, ay), (cx, cy) = turned(data["a"], data["b"]), turned(data["c"], data["d"])
    text = (
        f"sphere A: mass {data['m']}, velocity ({ax}, {ay})\n"
        f"sphere B: mass {data['k']}, velocity ({cx}, {cy})\n"
        f"A hits B: along 3i + 4j, e = {data['e']}\nfind velocity(A), speed(B)^2"
    )
    x, y = turned(data["v"], data["b"])
    assert answers(text, "velocity(A)") == [(exact(x), exact(y))]
    assert answers(text, "speed(B)^2") == [exact(Fraction(data["w"] ** 2 + data["d"] ** 2))]


@few
@given(impacts(), st.integers(2, 5))
def test_units_scale(data: dict[str, Fraction | int], factor: int) -> None:
    """Speeds times n make impulses times n, and energies times n²."""
    items = "find impulse, energy_lost"
    larger = {key: data[key] * factor for key in ("a", "b", "c", "d")}
    one, other = solve(parse(story(data) + items)), solve(parse(story(data, **larger) + items))
    assert other["impulse"].exact == factor * one["impulse"].exact
    assert other["energy_lost"].exact == factor**2 * one["energy_lost"].exact


@few
@given(impacts())
def test_a_perfectly_elastic_impact_runs_backwards(data: dict[str, Fraction | int]) -> None:
    v, w = collide(data["m"], data["a"], data["k"], data["c"], Fraction(1))
    back = {"a": -v, "b": -data["b"], "c": -w, "d": -data["d"], "e": 1}
    first = "B hits A" if v > 0 or (v == 0 and w < 0) else "A hits B"
    text = story(data, **back).replace("A hits B", first) + "find velocity(A), velocity(B)"
    assert answers(text, "velocity(A)") == [(-data["a"], -data["b"])]
    assert answers(text, "velocity(B)") == [(-data["c"], -data["d"])]


def test_a_value_that_several_solutions_share_is_shown_once() -> None:
    """Four solutions go together by their numbers; each value is shown once."""
    solution = solve(
        parse(
            "sphere A: mass 1, velocity a i + b j\nsphere B: mass 1, at rest\n"
            "A hits B: along i, e = 1/2\ngiven a^2 = 16, b^2 = 4\nfind a, b, velocity(A, 0)\n"
        )
    )
    pairs = {
        (x.value, y.value)
        for x, y in zip(solution["a"].answers, solution["b"].answers, strict=True)
        if x.solution == y.solution
    }
    assert pairs == {(4, 2), (4, -2), (-4, 2), (-4, -2)}
    assert [answer.value for answer in solution["a"].distinct] == [4, -4]
    assert str(solution).splitlines()[0] == "a = 4  or  −4"
    assert len(solution["velocity(A, 0)"].distinct) == 4
