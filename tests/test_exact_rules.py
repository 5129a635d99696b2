"""The rules of the textbook form, each by itself: where it applies, what comes of it, where not."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import pytest
import sympy
from sympy import Expr, Mul, S, cos, cot, sin, sqrt, symbols, tan

from restitution.exact import cost, in_one_ratio, in_sines, tidy
from restitution.exact.rules import CONVENTION, Rule, everywhere, improved, shortest
from restitution.exact.table import OF_AN_ANGLE, RULES
from restitution.exact.trigonometry import InOneAngle, MaskedAngle

u, v, m, k, a, b, alpha, beta = symbols("u v m k a b alpha beta", positive=True)
e = sympy.Symbol("e", nonnegative=True)
x = sympy.Symbol("x", real=True)
ANGLE = MaskedAngle.numbered(0, positive=True)
s, c, t = ANGLE.sine, ANGLE.cosine, ANGLE.tangent
ROOT = sqrt(11 - 4 * sqrt(3))
NESTED = sqrt(sqrt(3) - 1)


def unevaluated(*factors: Expr) -> Expr:
    return Mul(*factors, evaluate=False)


# By name: an expression to which this rule alone applies, what it makes of that, and one to which
# it must not apply.
OF_EXPRESSIONS: dict[str, tuple[Expr, Expr, Expr]] = {
    "plain angles merged": (
        5 * u * cos(sympy.pi / 9) ** 2 + 5 * u * sin(sympy.pi / 9) ** 2,
        5 * u,
        5 * cos(alpha) ** 2 + 5 * sin(alpha) ** 2,
    ),
    "bars inside bars": (abs(x * abs(x - 1)), abs(x * (x - 1)), abs(x) * abs(x - 1)),
    "a square over a size": (x**2 / abs(x), abs(x), x**3 / abs(x)),
    "sines of sums of angles": (
        sin(alpha + beta),
        sin(alpha) * cos(beta) + cos(alpha) * sin(beta),
        sin(alpha) * cos(beta),
    ),
    "tangents for cotangents": (1 + cot(alpha), 1 + 1 / tan(alpha), tan(alpha) + cot(alpha)),
    "roots joined": (
        sqrt(a - b) * sqrt(a + b),
        sqrt(a**2 - b**2),
        sqrt(a) * (a + b),
    ),
    "terms over a square": (
        1 + a**2 / b**2,
        unevaluated(a**2 + b**2, b**-2),
        1 + a**2 / b,
    ),
    "a tangent below each term": ((a * t + b) / t, a + b / t, (a * s + b) / s),
    "a cosine into a root": (
        unevaluated(c, sqrt(1 + e**2 * t**2)),
        sqrt(c**2 + e**2 * s**2),
        c * sqrt(1 + e**2 * s**2),
    ),
    "a root divided": (
        sqrt((1 - e) * (3 - e)) / (3 - e),
        sqrt((1 - e) / (3 - e)),
        sqrt((1 - e) * (3 - e)) / (2 - e),
    ),
    "over its own root": (
        m * sqrt(k**2 - 1) / (1 - k**2),
        -m / sqrt(k**2 - 1),
        m * sqrt(k**2 - 1) / (1 - k**3),
    ),
    "minuses below": (
        (k**2 - 2) / (-1 - k**2),
        (2 - k**2) / (1 + k**2),
        (k**2 - 2) / (k**2 - 1),
    ),
    "squares forward": ((e - 1) ** 2, (1 - e) ** 2, (e - 1) ** 3),
    "the sine of a sum": (
        a * sin(alpha) * cos(beta) - a * cos(alpha) * sin(beta),
        a * sin(alpha - beta),
        a * sin(alpha) * cos(beta) - b * cos(alpha) * sin(beta),
    ),
    "a number multiplied in": (
        unevaluated(S(2), 3 * sin(alpha) ** 2 - 1),
        6 * sin(alpha) ** 2 - 2,
        u * (3 * sin(alpha) ** 2 - 1),
    ),
    "a root of a root below the line": (
        (34 + 19 * sqrt(3)) * ROOT / 146,
        (2 + sqrt(3)) / (2 * ROOT),
        (34 + 19 * sqrt(3)) * sqrt(5) / 146,
    ),
    "roots of roots as one root": (
        sqrt(6) * NESTED / 2 - sqrt(2) * NESTED / 2,
        sqrt(3 * sqrt(3) - 5),
        sqrt(2) + sqrt(3),
    ),
}
# The same of quotients in the letters for the sine, cosine and tangent of an angle. There each rule
# gives a form, and the one that is less to read than all others is taken.
OF_QUOTIENTS: dict[str, tuple[Expr, Expr, Expr]] = {
    "as it stands": (s + 1, s + 1, S.Zero),
    "a sine over a cosine": (u * (t * c + 1), u * (s + 1), s + 1),
    "squares of cosines by sines": (1 - c**2 + s, s * (s + 1), s + 1),
    "squares of sines by cosines": (1 - s**2 + c, c * (c + 1), c + 1),
    "one degree": (1 - (1 - e**2) * s**2, c**2 + e**2 * s**2, c**2 + s),
    "in the tangent": (e * s / c, e * t, s * c + 1 + s),
}


PLAIN = [rule for rule in RULES if rule.name in OF_EXPRESSIONS]
POINTS = {u: 1.3, v: 0.7, m: 2.1, k: 1.9, a: 1.7, b: 0.6, alpha: 0.4, beta: 1.1, e: 0.35, x: -1.4}
POINTS |= {s: math.sin(0.8), c: math.cos(0.8), t: math.tan(0.8)}


def changed_by(rules: Iterable[Rule], subject: Any, given: Expr) -> list[str]:
    return [rule.name for rule in rules if rule.applies(subject) and rule.rewrite(subject) != given]


def test_each_rule_has_its_example() -> None:
    names = [rule.name for rule in RULES]
    assert len(set(names)) == len(names)
    assert set(names) == OF_EXPRESSIONS.keys() | OF_QUOTIENTS.keys()


@pytest.mark.parametrize("rule", PLAIN, ids=[rule.name for rule in PLAIN])
def test_a_rule_by_itself(rule: Rule) -> None:
    given, expected, other = OF_EXPRESSIONS[rule.name]
    assert changed_by(PLAIN, given, given) == [rule.name]
    assert rule.rewrite(given) == expected
    assert rule.gain == CONVENTION or cost(expected) < cost(given) - rule.gain
    assert not rule.applies(other)
    assert abs((given - expected).subs(POINTS).evalf()) < 1e-12


@pytest.mark.parametrize("rule", OF_AN_ANGLE, ids=[rule.name for rule in OF_AN_ANGLE])
def test_a_form_in_one_angle_by_itself(rule: Rule) -> None:
    given, expected, other = OF_QUOTIENTS[rule.name]
    subject = InOneAngle(given, ANGLE)
    forms = [own.name for own in OF_AN_ANGLE if own.applies(subject)]
    assert [name for name in forms if form(name, subject) == expected] == [rule.name]
    assert shortest(OF_AN_ANGLE, subject) == expected
    assert rule.name == "as it stands" or not rule.applies(InOneAngle(other, ANGLE))
    assert abs((given - expected).subs(POINTS).evalf()) < 1e-12


def form(name: str, subject: InOneAngle) -> Expr:
    (rule,) = [rule for rule in OF_AN_ANGLE if rule.name == name]
    return rule.rewrite(subject)


def test_rules_are_tried_until_none_changes_anything() -> None:
    down = Rule("one less", lambda n: n > 3, lambda n: n - 1, CONVENTION)
    assert improved([down], S(7)) == 3
    longer = Rule("a product", lambda _: True, lambda n: n * u * v)
    assert improved([longer], u) == u
    shorter = Rule("no plus", lambda n: n.is_Add, lambda n: n.args[0])
    assert improved([shorter], u + v) in (u, v)
    assert improved([replace(shorter, gain=9.0)], u + v) == u + v


def test_two_rules_that_undo_each_other_come_to_an_end() -> None:
    pair = [
        Rule("up", lambda n: n == 1, lambda n: S(2), CONVENTION),
        Rule("down", lambda n: n == 2, lambda n: S(3), CONVENTION),
        Rule("round", lambda n: n == 3, lambda n: S(1), CONVENTION),
    ]
    assert improved(pair, S.One) in (1, 2, 3)


def test_nodes_are_improved_from_the_innermost() -> None:
    square = Rule("squares", lambda n: n.is_Pow and n.exp == 2, lambda n: n.base + 1, CONVENTION)
    assert everywhere([square], ((u**2) ** 2 + v**2) ** 2) == everywhere([square], u**4 + v + 1) + 1


def test_what_is_tidied_is_tidy() -> None:
    """No rule changes a textbook form again."""
    for given, expected, _ in (*OF_EXPRESSIONS.values(), *OF_QUOTIENTS.values()):
        for start in (given, expected):
            once = tidy(start)
            assert tidy(once) == once


def test_a_sum_in_one_of_two_ratios() -> None:
    sine, cosine = sin(alpha), cos(alpha)
    assert in_one_ratio(4 * sine**2 + cosine**2 * (v - 2) ** 2, cosine, sine) == sympy.expand(
        4 - 4 * cosine**2 + cosine**2 * (v - 2) ** 2
    )
    assert in_one_ratio(cosine**5 + u * cosine, sine, cosine) == sympy.expand(
        cosine * (1 - sine**2) ** 2 + u * cosine
    )
    assert in_one_ratio(u * (v + 1), sine, cosine) == u * v + u
    assert in_one_ratio(cos(beta) ** 2, sine, cosine) == cos(beta) ** 2


def test_tangents_by_sines_and_cosines() -> None:
    both = u * tan(alpha) + cot(beta)
    assert in_sines(both) == u * sin(alpha) / cos(alpha) + cos(beta) / sin(beta)
    assert in_sines(both, alpha) == u * sin(alpha) / cos(alpha) + cot(beta)


def test_no_roots_are_sought_for_the_sign_of_a_sum_with_cosines(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def refused(*_: object) -> None:
        raise AssertionError

    for name in ("polytools.real_roots", "polyroots.roots"):
        monkeypatch.setattr(f"sympy.polys.{name}", refused)
    x = sympy.Symbol("x_of_signs", positive=True)
    second, first = cos(2 * sympy.pi / 9), sin(sympy.pi / 9)
    assert (second * x**2 - 3 * first * x + 1).is_positive is None
    assert (second * x**2 + 3 * x + 1).is_positive
