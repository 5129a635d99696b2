"""Values put into templates: how they look, and that they still say the same."""

from __future__ import annotations

from fractions import Fraction
from math import isclose, sqrt
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sympy import Rational, cos, symbols

from restitution.explaining.printing import printed
from restitution.render import layout as lay
from restitution.render.text import to_text

u, v, w, m, k = symbols("u v w m k", positive=True)
alpha = symbols("alpha", positive=True)
e = symbols("e", nonnegative=True)

PRINTED: list[tuple[str, dict[str, Any], str]] = [
    # Momentum: × between numbers, nothing between letters, zeros left out, ones left out.
    ("m*u + n*v", {"m": 2, "u": 3, "n": 4, "v": -1}, "2 × 3 + 4 × (−1)"),
    ("m*u + n*v", {"m": 2, "u": v, "n": 4, "v": w}, "2v + 4w"),
    ("m*u + n*v", {"m": 2, "u": -4, "n": -3, "v": 3}, "2 × (−4) − 3 × 3"),
    ("m*u + n*v", {"m": 3 * m, "u": u, "n": 2 * m, "v": -2 * u}, "3mu + 2m × (−2u)"),
    ("m*u + n*v", {"m": 2, "u": v, "n": 3, "v": -w}, "2v − 3w"),
    ("m*u + n*v", {"m": m, "u": u, "n": k * m, "v": 0}, "mu"),
    ("m*u + n*v", {"m": m, "u": 0, "n": m, "v": 0}, "0"),
    ("m*u + n*v", {"m": 1, "u": v, "n": 2, "v": 1}, "v + 2"),
    ("m*u + n*v", {"m": m, "u": 4, "n": m, "v": -3}, "4m + m × (−3)"),
    # Newton's law: a bracket for several things, none for one.
    ("e*(u - v)", {"e": e, "u": u, "v": 0}, "eu"),
    ("e*(u - v)", {"e": Rational(1, 2), "u": 3, "v": -4}, "½(3 − (−4))"),
    ("e*(u - v)", {"e": 1, "u": 3, "v": -4}, "3 − (−4)"),
    ("e*(u - v)", {"e": 0, "u": 3, "v": -4}, "0"),
    ("e*u", {"e": Rational(1, 2), "u": 1}, "½ × 1"),
    ("e*u", {"e": e, "u": e * u}, "e × eu"),
    ("a*b", {"a": 2 * u, "b": u}, "2u²"),
    ("w - v", {"w": w, "v": v}, "w − v"),
    ("w - v", {"w": w, "v": -v}, "w + v"),
    # Energy and speed.
    ("1/2*m*(a^2 + b^2)", {"m": 2, "a": 3, "b": -4}, "½ × 2 × (3² + (−4)²)"),
    ("1/2*m*(a^2 + b^2)", {"m": m, "a": -u, "b": 0}, "½mu²"),
    ("1/2*m*(a^2 + b^2)", {"m": m, "a": 0, "b": 0}, "0"),
    ("sqrt(a^2 + b^2)", {"a": u * cos(alpha), "b": 2}, "√((u cos α)² + 2²)"),
    # Vectors.
    ("m*(v - u)", {"m": 2, "v": (3, -9), "u": (6, -5)}, "2((3𝐢 − 9𝐣) − (6𝐢 − 5𝐣))"),
    ("m*(v - u)", {"m": 2, "v": (0, 0), "u": (3, 2)}, "2(𝟎 − (3𝐢 + 2𝐣))"),
    ("m*(v - u)", {"m": 1, "v": (3, -9), "u": (0, 0)}, "3𝐢 − 9𝐣"),
    ("a*n + b*t", {"a": -3, "n": (1, 1), "b": 1, "t": (-1, 1)}, "(−3)(𝐢 + 𝐣) + (−𝐢 + 𝐣)"),
    ("r + t*v", {"r": (0, 0), "t": 2, "v": (3, 4)}, "2(3𝐢 + 4𝐣)"),
    ("-v", {"v": (3, -4)}, "−(3𝐢 − 4𝐣)"),
    ("dot(a, b)", {"a": (3, -4), "b": (3, 2)}, "3 × 3 + (−4) × 2"),
    ("dot(a, b)", {"a": (3, -4), "b": (0, 2)}, "(−4) × 2"),
    # Places, times, tangents.
    ("(x - a*t)^2", {"x": 3, "a": -2, "t": lay.Letter("t")}, "(3 + 2t)²"),
    ("t + d/v", {"t": lay.Letter("t", "1"), "d": 3, "v": u}, "t₁ + 3/u"),
    ("(a - b)/(1 + p)", {"a": 4, "b": 3, "p": 12}, "(4 − 3)/(1 + 12)"),
    ("a*b", {"a": -w, "b": -3}, "(−w) × (−3)"),
]


@pytest.mark.parametrize(("template", "values", "text"), PRINTED)
def test_values_put_in(template: str, values: dict[str, Any], text: str) -> None:
    assert to_text(printed(template, **values)) == text


def test_signs_to_the_front_and_zeros_written() -> None:
    assert to_text(printed("a*b", a=-w, b=-3, front=True)) == "w × 3"
    assert to_text(printed("a*b", a=2 - w, b=3, front=True)) == "3(2 − w)"
    assert to_text(printed("dot(a, b)", a=(u, v), b=(1, 0), zeros=True)) == "u × 1 + v × 0"
    assert to_text(printed("e*u", e=0, u=u * cos(alpha), zeros=True)) == "0 × u cos α"


def test_a_letter_without_a_value_is_refused() -> None:
    with pytest.raises(KeyError):
        printed("m*u", m=2)


NUMBERS = st.one_of(
    st.integers(-3, 3), st.fractions(-3, 3, max_denominator=4).map(lambda x: Rational(str(x)))
)
TEMPLATES = {
    "m*u + n*v": lambda m, u, n, v: m * u + n * v,
    "e*(u - v)": lambda e, u, v: e * (u - v),
    "m*(v - u)": lambda m, v, u: m * (v - u),
    "w - v": lambda w, v: w - v,
    "1/2*m*(a^2 + b^2)": lambda m, a, b: m * (a * a + b * b) / 2,
    "1/2*m*u^2": lambda m, u: m * u * u / 2,
    "sqrt(a^2 + b^2)": lambda a, b: sqrt(a * a + b * b),
    "(x - a*t)^2 + (y - b*t)^2": lambda x, a, t, y, b: (x - a * t) ** 2 + (y - b * t) ** 2,
    "(a + b)/(7 - p)": lambda a, b, p: (a + b) / (7 - p),
    "a*b": lambda a, b: a * b,
}


@pytest.mark.parametrize("template", TEMPLATES)
@given(data=st.data())
def test_what_is_printed_is_worth_the_same(template: str, data: st.DataObject) -> None:
    worth = TEMPLATES[template]
    names = worth.__code__.co_varnames[: worth.__code__.co_argcount]
    values = {name: data.draw(NUMBERS, label=name) for name in names}
    laid = printed(template, **values)
    exact = {name: Fraction(str(value)) for name, value in values.items()}
    assert isclose(value_of(laid), float(worth(**exact)), abs_tol=1e-9)
    text = to_text(laid)
    assert not any(each in text for each in ("+ −", "− −", "× −", "0 ×", "1(", "()")), text


def value_of(laid: lay.Layout) -> float:
    """What a layout of numbers is worth, by what stands in it."""
    match laid:
        case lay.Number(digits):
            return float(digits)
        case lay.Sum(terms):
            return sum((-1 if sign == "-" else 1) * value_of(term) for sign, term in terms)
        case lay.Product(factors):
            total = 1.0
            for each in factors:
                total *= value_of(each)
            return total
        case lay.Fraction(above, below):
            return value_of(above) / value_of(below)
        case lay.Brackets(inside):
            return value_of(inside)
        case lay.Power(base, exponent):
            return value_of(base) ** value_of(exponent)
        case lay.Root(inside):
            return sqrt(value_of(inside))
    raise TypeError(laid)
