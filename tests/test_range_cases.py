"""Ranges whose form depends on the data: each truth was worked by hand, as its function says."""

from __future__ import annotations

import math
import operator
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import plain_physics
import pytest
import sympy as sp
from workings import solved

from restitution.export.answers import answers
from restitution.workings import explain

DIRECT = """sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i
"""
NUMBERS = """sphere A: mass 2, velocity u i
sphere B: mass 3, at rest
A hits B: along i
"""
ZERO, ONE = sp.Integer(0), sp.Integer(1)


def loss_below_500(u: sp.Expr) -> sp.Set:
    """3u²(1 - e²)/5 < 500, so e² > 1 - 2500/(3u²)."""
    least = 1 - sp.Rational(2500, 3) / u**2
    return sp.Interval.Lopen(sp.sqrt(least), 1) if least >= 0 else sp.Interval(0, 1)


def speed_of_b_then(u: sp.Expr) -> sp.Set:
    """2u(1 + e)/5, which grows with e."""
    e = loss_below_500(u)
    ends = [2 * u * (1 + each) / 5 for each in (e.start, e.end)]
    return sp.Interval(*ends, e.left_open, e.right_open)


def slow_b(u: sp.Expr, k: sp.Expr) -> sp.Set:
    """(1 + e)u/(k + 1) < 3, so e < 3(k + 1)/u - 1."""
    most = 3 * (k + 1) / u - 1
    if most <= 0:
        return sp.S.EmptySet
    return sp.Interval(0, 1) if most > 1 else sp.Interval.Ropen(0, most)


def half_lost(e: sp.Expr) -> sp.Set:
    """k(1 - e²)/(2(k + 1)) > 1/4: 2k(1 - e²) > k + 1, so k(1 - 2e²) > 1."""
    return sp.Interval.open(1 / (1 - 2 * e**2), sp.oo) if 2 * e**2 < 1 else sp.S.EmptySet


def speed_of_a(u: sp.Expr, k: sp.Expr) -> sp.Set:
    """|1 - ek|u/(k + 1): between those at e = 0 and e = 1, or down to 0 where e = 1/k is one."""
    ends = [u / (k + 1), abs(1 - k) * u / (k + 1)]
    return sp.Interval(0 if k > 1 else min(ends), max(ends))


def no_more(e: sp.Expr) -> sp.Set:
    """A, m, keeps (1 - 2e)u/3, and B (1 + e)(4 - k)u/(6(2 + k)): k(1 - e) <= 4e."""
    if e == 0:
        return sp.S.EmptySet
    return sp.Interval.open(0, sp.oo) if e == 1 else sp.Interval.Lopen(0, 4 * e / (1 - e))


def back_from_the_wall(e: sp.Expr) -> sp.Set:
    """A keeps (1 - 3e)u/4, and B comes back with (1 + e)fu/4: f > (3e - 1)/(1 + e)."""
    least = (3 * e - 1) / (1 + e)
    if e == 1:
        return sp.S.EmptySet
    return sp.Interval.Lopen(least, 1) if least >= 0 else sp.Interval(0, 1)


@dataclass(frozen=True)
class Question:
    statement: str
    truth: Callable[..., sp.Set]
    letters: tuple[str, ...]
    borders: tuple[tuple[sp.Expr, ...], ...] = ()


QUESTIONS = {
    "least e, or any": Question(
        NUMBERS + "given energy_lost < 500\nfind range of e",
        loss_below_500,
        ("u",),
        ((50 / sp.sqrt(3),), (sp.Integer(28),), (sp.Integer(29),)),
    ),
    "a speed over that": Question(
        NUMBERS + "given energy_lost < 500\nfind range of speed(B)",
        speed_of_b_then,
        ("u",),
        ((50 / sp.sqrt(3),),),
    ),
    "greatest e, or any, or none": Question(
        DIRECT + "given speed(B) < 3\nfind range of e",
        slow_b,
        ("u", "k"),
        ((sp.Integer(3), ONE), (sp.Integer(6), ONE), (sp.Integer(5), ONE)),
    ),
    "a mass, for some e alone": Question(
        DIRECT + "given energy_lost > 1/4 m u^2\nfind range of k",
        half_lost,
        ("e",),
        ((1 / sp.sqrt(2),), (ONE,), (ZERO,)),
    ),
    "any mass at one end of e": Question(
        DIRECT.replace("k m", "2m")
        + "sphere C: mass k m, at rest\nB hits C: along i, e = 1/2\n"
        + "given A and B do not collide again\nfind range of k",
        no_more,
        ("e",),
        ((ZERO,), (ONE,)),
    ),
    "any wall for small e": Question(
        DIRECT.replace("k m", "3m")
        + "wall W: along j\nB hits W: e = f\ngiven A and B collide again\nfind range of f",
        back_from_the_wall,
        ("e",),
        ((ZERO,), (ONE,), (sp.Rational(1, 3),)),
    ),
    "a speed that vanishes within": Question(
        DIRECT + "unknown e\nfind range of speed(A)",
        speed_of_a,
        ("u", "k"),
        ((ONE, ONE), (ONE, sp.Integer(2))),
    ),
}


def points(question: Question) -> Iterator[dict[str, sp.Expr]]:
    """Values of the data over many orders of magnitude, and those where the form changes."""
    for values in question.borders:
        yield dict(zip(question.letters, values, strict=True))
    rng = random.Random(5)
    for _ in range(60):
        yield {
            name: sp.Rational(rng.randint(0, 40), 40)
            if name == "e"
            else sp.Rational(rng.randint(1, 99), 30) * sp.Integer(10) ** rng.randint(-3, 3)
            for name in question.letters
        }


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_form_that_holds_is_the_range(name):
    question = QUESTIONS[name]
    solution = solved(question.statement)
    ((_, item),) = solution.items()
    assert item.error is None and item.proof not in (None, "undecided")
    holding = 0
    for point in points(question):
        values = {s: v for n, v in point.items() for s in _named(item, n)}
        forms = [
            answer.value.xreplace(values)
            for answer in item.answers
            if all(_holds(each, point) for each in answer.condition)
        ]
        truth = question.truth(**point)
        holding += len(forms)
        if truth is sp.S.EmptySet:
            assert forms == [], point
        else:
            assert len(forms) == 1, point
            assert _same(forms[0], truth), (point, forms, truth)
    assert holding > 20


def _named(item, name):
    return {s for answer in item.answers for s in answer.value.free_symbols if s.name == name}


def _holds(condition: str, point) -> bool:
    return plain_physics.true_of(
        condition, {n: plain_physics.number(str(sp.N(x, 80))) for n, x in point.items()}
    )


def _same(form: sp.Set, truth: sp.Set) -> bool:
    return (form.left_open, form.right_open) == (truth.left_open, truth.right_open) and all(
        a == b or abs(sp.N(a - b, 40)) < sp.Float("1e-30")
        for a, b in ((form.start, truth.start), (form.end, truth.end))
    )


@pytest.mark.parametrize("name", QUESTIONS)
def test_a_working_ends_with_each_form(name):
    solution = solved(QUESTIONS[name].statement)
    ((_, item),) = solution.items()
    text = " ".join(str(explain(solution)).split())
    for answer in item.answers:
        if len(item.answers) > 1:
            assert answer.display in text
        else:
            assert all(each in text for each in answer.display.split(", for "))


def test_forms_of_one_range_are_no_choice():
    text = answers(solved(QUESTIONS["least e, or any"].statement), "text")
    assert "; " in text and " or " not in text


def test_a_form_that_asks_nothing_of_its_letter_has_no_condition():
    wall = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
    ((_, item),) = solved(wall + "find range of speed(P) in terms of u").items()
    assert [each.display for each in item.answers] == ["0 < speed of P ≤ u"]


OBLIQUE = """sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
"""
THREE = DIRECT + "sphere C: mass m, at rest\nB hits C: along i\n"


def speed_after(d: dict[str, float]) -> float:
    """A keeps u sin α across, and (1 - ek)u cos α/(1 + k) along the line of centres."""
    along = (1 - d["e"] * d["k"]) / (1 + d["k"]) * math.cos(d["alpha"])
    return d["u"] * math.hypot(along, math.sin(d["alpha"]))


def turned_by(d: dict[str, float]) -> float:
    along = (1 - d["e"] * d["k"]) / (1 + d["k"]) * math.cos(d["alpha"])
    return abs(math.atan2(math.sin(d["alpha"]), along) - d["alpha"])


def middle_after(d: dict[str, float]) -> float:
    """B moves with (1 + e)u/(1 + k), and hits C of mass m: (k - e)/(1 + k) of that is left."""
    return (1 + d["e"]) * abs(d["k"] - d["e"]) / (1 + d["k"]) ** 2 * d["u"]


@pytest.mark.parametrize(
    ("text", "over", "quantity", "number"),
    [
        (OBLIQUE + "find minimum of speed(A) over e", "e", speed_after, 2),
        (OBLIQUE + "find maximum of deflection(A) over alpha", "alpha", turned_by, 3),
        (
            OBLIQUE + "find maximum of sin(deflection(A)) over alpha",
            "alpha",
            lambda d: math.sin(turned_by(d)),
            3,
        ),
        (
            OBLIQUE.replace("k m", "2m") + "find maximum of deflection(A) over alpha",
            "alpha",
            lambda d: turned_by({**d, "k": 2}),
            3,
        ),
        (THREE + "find minimum of speed(B) over e", "e", middle_after, 3),
        (THREE + "find maximum of speed(B) over k", "k", middle_after, 2),
    ],
)
def test_an_extremum_that_lies_elsewhere_for_other_data(
    text: str, over: str, quantity: Callable[[dict[str, float]], float], number: int
) -> None:
    """Each form is the greatest or least of thousands of values, where its condition holds."""
    (item,) = solved(text).parts[None].items
    assert item.proof == "decision"
    assert len(item.answers) == number
    ends = {"e": (0, 1), "alpha": (0, math.pi / 2), "k": (0, 60)}
    low, high = ends[over]
    best = max if "maximum" in text else min
    rng = random.Random(5)
    met = set()
    for _ in range(12):
        data = {"k": rng.uniform(0.05, 4), "e": rng.random(), "alpha": rng.uniform(0, 1.5), "u": 1}
        fine = (low + (high - low) * ((n + 0.5) / 4000) ** 2 for n in range(4000))
        seen = best(quantity({**data, over: x}) for x in fine)
        put = {sp.Symbol(name): value for name, value in data.items()}
        holding = [each for each in item.answers if all(holds(c, put) for c in each.condition)]
        assert len(holding) == 1
        met.add(holding[0].display)
        value = sp.sympify(holding[0].exact).subs(put)
        assert float(value) == pytest.approx(seen, abs=3e-3)
    assert len(met) == number - ("deflection" in text)  # k = 1/e is not drawn


def holds(condition: str, put: dict[sp.Symbol, float]) -> bool:
    """Whether a chain such as ``1 < k <= 2`` holds."""
    first, *rest = re.split(r" (<=|<|=) ", condition)
    sides = [float(sp.sympify(each).subs(put)) for each in (first, *rest[1::2])]
    signs = {"<": operator.lt, "<=": operator.le, "=": operator.eq}
    return all(signs[s](a, b) for s, a, b in zip(rest[::2], sides, sides[1:], strict=False))


def test_a_form_whose_end_has_no_value_is_not_all() -> None:
    """With e = 1 no energy is lost, and every u is possible; else mu²(1 − e²)/4 < 500."""
    text = DIRECT.replace("k m", "m") + "given energy_lost < 500\nfind range of u"
    ((_, item),) = solved(text).items()
    assert [(each.condition, each.value.end == sp.oo) for each in item.answers] == [
        (("e < 1",), False),
        (("e = 1",), True),
    ]


def test_a_greatest_angle_is_one_inverse_tangent() -> None:
    text = OBLIQUE + "find maximum of deflection(A) over alpha"
    ((_, item),) = solved(text).items()
    assert item.answers[0].display.startswith("arctan((1 + e)k/(2√((1 − ek)(1 + k)))) when")


def test_cases_of_which_one_is_not_written_leave_nothing_in_force() -> None:
    solution = solved(OBLIQUE + "find maximum of deflection(A) over alpha")
    assert explain(solution, check=True).followed


def test_an_extremum_in_cases_is_printed_with_them() -> None:
    text = OBLIQUE + "find minimum of speed(A) over e"
    working = " ".join(str(explain(solved(text))).split())
    assert "least speed of A = u sin α, when ek − 1 = 0, so e = 1/k" in working
    assert "This holds for k ≤ 1 only." in working
    assert "This holds for k > 1 only." in working


def test_a_deflection_has_its_range_at_the_end_of_e_too() -> None:
    """δ is at most arcsin((1 + e)/(3 − e)), and comes near to 90° for e = 1 as A hits B fully."""
    text = OBLIQUE.replace("k m", "m") + "unknown alpha\nfind range of deflection(A)"
    item = solved(text)["range of deflection(A)"]
    assert item.proof == "decision"
    below, at_one = item.answers
    assert (below.condition, at_one.condition) == (("e < 1",), ("e = 1",))
    assert at_one.value == sp.Interval.open(0, sp.pi / 2)
    for e in (0, sp.Rational(3, 10), sp.Rational(9, 10)):
        most = below.value.end.subs(sp.Symbol("e", nonnegative=True), e)
        most = most.subs(sp.Symbol("e", real=True), e).subs(sp.Symbol("e"), e)
        assert float(most) == pytest.approx(float(sp.asin((1 + e) / (3 - e))))
