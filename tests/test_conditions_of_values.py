"""Conditions of several values that one line gives, and solutions that part above it."""

from __future__ import annotations

import laws_of_numbers
import pytest
import sympy as sp
from statements import FILES

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

AT_REST = """
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
given {fact}
find e
"""


def test_numbers_for_letters_tell_a_wrong_condition(monkeypatch, tmp_path):
    path = tmp_path / "at-rest.impact"
    path.write_text(AT_REST.format(fact="speed(A) = 1/4 u"), encoding="utf-8")
    assert [*laws_of_numbers.draws(path)]
    laws_of_numbers.numbers_for_letters_give_the_same(path)
    monkeypatch.setattr(laws_of_numbers, "holds", lambda condition, numbers: True)
    with pytest.raises(AssertionError, match="at-rest"):
        laws_of_numbers.numbers_for_letters_give_the_same(path)


@pytest.mark.parametrize(
    ("fact", "lines"),
    [
        (
            "speed(A) = 1/4 u",
            [
                "4(1 − ek) = ±(1 + k) e = (5 + k)/(4k) or e = (3 − k)/(4k) A1 A1",
                "As e ≤ 1, e = (5 + k)/(4k) holds for k ≥ 5/3 only.",
                "As 0 ≤ e ≤ 1, e = (3 − k)/(4k) holds for ⅗ ≤ k ≤ 3 only.",
            ],
        ),
        (
            "speed(A) = speed(B)",
            [
                "((1 + e)u/(1 + k))² = ((1 − ek)u/(1 + k))²",
                "e = 0 or e = 2/(k − 1)",
                "As 0 ≤ e ≤ 1, e = 2/(k − 1) holds for k ≥ 3 only.",
            ],
        ),
    ],
)
def test_each_value_has_its_condition(fact: str, lines: list[str]) -> None:
    working = " ".join(to_text(explain(solve(parse(AT_REST.format(fact=fact)))), 100).split())
    for line in lines:
        assert line in working


def test_an_angle_too_unwieldy_to_be_bounded_has_its_cosine_as_condition() -> None:
    # A has no more than doubled its energy where B is light: no cosine is greater than 1.
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, velocity u at 180° - beta
A hits B: along i
given energy(A) = 2 energy(A, 0)
find beta
"""
    solution = solve(parse(text))
    (answer,) = solution["beta"].answers
    assert answer.display.endswith(", for 0 < cos β < 1")
    (condition,) = answer.condition
    letters = {"alpha": sp.pi / 3, "e": sp.Rational(1, 2), "k": sp.Integer(5)}
    low, cosine, high = condition.split(" < ")
    value = sp.sympify(cosine, locals={name: sp.Symbol(name) for name in letters})
    assert (low, high) == ("0", "1")
    # v = (1 - ek)u cos(alpha)/(1 + k) - (1 + e)ku cos(beta)/(1 + k), and v² + u² sin²(alpha) = 2u²
    given = value.subs(letters)
    v = (1 - 2.5) * 0.5 / 6 - 1.5 * 5 * given / 6
    assert abs(sp.N(v**2 + 0.75 - 2)) < 1e-12


@pytest.mark.parametrize(
    ("name", "sentence"),
    [
        # e = 0: an open range of which both ends come to 0, which d is not.
        ("267-post-range", "This holds for e > 0 only, as there is no such d otherwise."),
        # e = 0: no k is more than 1/e.
        ("direction-reversed", "This holds for e > 0 only, as there is no such k otherwise."),
        # e = 1: both ends come to u, which v is then.
        ("626-range-of-v-with-letters", "This holds for e < 1 only: if e = 1, v = u."),
        (
            "715-two-cushions-to-a-point-in-letters",
            "As P is still moving at the end, this holds for e > 0 only.",
        ),
        (
            "710-pocket-along-the-cushion",
            "As A has to move towards B to hit it, this holds for b > 2(√37 − 4)/3 only.",
        ),
    ],
)
def test_a_condition_has_its_reason(name: str, sentence: str) -> None:
    text = next(path.read_text() for path in FILES if path.stem == name)
    assert sentence in " ".join(to_text(explain(solve(parse(text)))).split())


def test_a_condition_that_the_statement_gives_is_not_said_again() -> None:
    text = """
wall W: along i
wall X: along j
sphere P: mass m, velocity u at alpha to W
P hits W
P hits X
{given}given energy_lost(1) > 3 energy_lost(2)
find range of alpha
"""
    said, unsaid = (
        to_text(explain(solve(parse(text.format(given=given)))))
        for given in ("", "given 0 < e < 1\n")
    )
    assert "This holds for" in said
    assert "This holds for" not in unsaid


@pytest.mark.parametrize(
    ("place", "condition"), [("at (a, 0)", "a < 0"), ("at (-a, 0)", ""), ("at (4 - a, 0)", "")]
)
def test_a_time_that_looks_negative_says_for_which_places_it_holds(
    place: str, condition: str
) -> None:
    statement = f"""
wall W: along j, through (0, 0)
sphere P: {place}, velocity u i
P hits W
find time(1)
"""
    (item,) = solve(parse(statement)).parts[None].items
    assert " ".join(item.answers[0].condition) == condition


CORNER = """
wall OX: along i
wall OY: along j
sphere P: mass m, velocity u at theta to OX
P hits OX: e = {one}
P hits OY: e = {two}
"""


@pytest.mark.parametrize(
    ("one", "two", "asked", "condition"),
    [
        (
            "p",
            "q",
            "given velocity(P) perpendicular to velocity(P, 1)\nfind tan(theta)",
            "As θ is acute, this holds for p > 0 and q > 0 only.",
        ),
        (
            "k",
            "k/2",
            "let phi = angle(velocity(P), OY)\ngiven phi = 60°\nfind theta",
            "",
        ),
        (
            "k",
            "f",
            (
                "let phi = angle(velocity(P), OY)\npart a\nshow tan(phi) = f/(k tan(theta))\n"
                "part b\ngiven f = k/3, phi = 30°\nfind theta"
            ),
            "",
        ),
    ],
    ids=["each factor of a product", "a quotient by a letter", "a quotient that is shown"],
)
def test_conditions_are_those_that_a_reader_needs(one, two, asked, condition):
    explanation = explain(solve(parse(CORNER.format(one=one, two=two) + asked)), check=True)
    assert explanation.followed
    text = " ".join(to_text(explanation, 100).split())
    assert "≠ 0" not in text
    assert "still moving" not in text
    assert condition in text


def test_a_condition_that_follows_from_a_result_above_is_not_said() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass n, at rest
A hits B: along i
given direction(A) = 90°
part a
show n = m/e
part b
given speed(A) = u/2
find alpha
"""
    working = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "α = 30°" in working
    assert "holds for" not in working


def test_a_condition_of_where_a_sphere_starts_is_not_said_of_an_angle() -> None:
    text = """
wall W: along j, through (0, 0)
wall V: along j, through (a, 0)
sphere P: at (x, 0), velocity -u cos(alpha) i + u sin(alpha) j
P hits W: e = 1/2
P hits V: e = 1/2
given angle(velocity(P), W) = arctan(1/4)
find tan(alpha)
"""
    working = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "tan α = 1" in working
    assert "holds for" not in working
