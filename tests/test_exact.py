"""Exact expressions: textbook forms written by hand, values compared with plain floats."""

from __future__ import annotations

import cmath
import math
import random
from decimal import ROUND_HALF_UP, Context, Decimal

import pytest
import sympy
from sympy import Interval, Rational, S, Symbol, acos, asin, atan, cos, pi, sin, sqrt, symbols, tan

from restitution.exact import (
    decimal,
    is_zero,
    same,
    significant,
    sympy_text,
    tidy,
    tidy_angle,
)
from restitution.exact.samples import has_one_sign, is_negative
from restitution.exact.surds import worked_out
from restitution.exact.symbols import multiple_of_a_symbol

u, v, w, m, M, k, g, h, a, b, m_1, m_2 = symbols("u v w m M k g h a b m_1 m_2", positive=True)
e, e_1, e_2 = symbols("e e_1 e_2", nonnegative=True)
x, y = symbols("x y", real=True)
alpha, beta = symbols("alpha beta", positive=True)
C, T = cos(alpha), tan(alpha)
Z = sin(alpha)
Q = Rational

TEXTBOOK = [
    (
        (4 * u**2 * v**2 + sqrt(3) * (u**2 + v**2) * u * v) / (v**2 * (3 * v**2 - u**2)),
        "u*(sqrt(3)*u + v)/(v*(-u + sqrt(3)*v))",
    ),
    (
        (x**2 * m + sqrt(3) * abs(x) * m**2) / (x**2 - 3 * m**2),
        "m*Abs(x)/(-sqrt(3)*m + Abs(x))",
    ),
    (sqrt(48), "4*sqrt(3)"),
    (sqrt(3 + 2 * sqrt(2)), "1 + sqrt(2)"),
    (1 / (1 + sqrt(3)), "(-1 + sqrt(3))/2"),
    ((5 * sqrt(3) - 3) / (4 * sqrt(3) + 3), "(23 - 9*sqrt(3))/13"),
    (sqrt(8 + 4 * sqrt(2)), "2*sqrt(sqrt(2) + 2)"),
    (cos(atan(Q(3, 4)) + pi / 6), "(-3 + 4*sqrt(3))/10"),
    (sqrt(u**2 * Q(103, 256)), "sqrt(103)*u/16"),
    (sqrt(7 * u**2 / 16), "sqrt(7)*u/4"),
    (3 * u / 8 + 5 * e * u / 8, "u*(5*e + 3)/8"),
    (3 * u + 2 * e * u - e**2 * u, "u*(3 - e)*(e + 1)"),
    (3 * e * u - u, "u*(3*e - 1)"),
    (-u * (3 * e - 1) / 4, "u*(1 - 3*e)/4"),
    (-(a - b), "-a + b"),
    (m * u**2 * (1 - e) * (1 + e) / 2, "m*u**2*(1 - e**2)/2"),
    (m * u**2 / 2 - m * u**2 * (C**2 + e**2 * Z**2) / 2, "m*u**2*(1 - e**2)*sin(alpha)**2/2"),
    (
        m * M * (1 - e**2) * u**2 / (2 * m + 2 * M),
        "M*m*u**2*(1 - e**2)/(2*(M + m))",
    ),
    (Z**2 + C**2, "1"),
    (1 - Z**2, "cos(alpha)**2"),
    (u**2 * (C**2 + e**2 * Z**2), "u**2*(e**2*sin(alpha)**2 + cos(alpha)**2)"),
    (u**2 - u**2 * (1 - e**2) * Z**2, "u**2*(e**2*sin(alpha)**2 + cos(alpha)**2)"),
    (
        sqrt(u**2 * C**2 + e**2 * u**2 * Z**2),
        "u*sqrt(e**2*sin(alpha)**2 + cos(alpha)**2)",
    ),
    (
        u * sqrt(1 + e**2 * T**2) / sqrt(1 + T**2),
        "u*sqrt(e**2*sin(alpha)**2 + cos(alpha)**2)",
    ),
    (e * Z / C, "e*tan(alpha)"),
    (
        (1 + e) * Z * C / (C**2 - e * Z**2),
        "(e + 1)*tan(alpha)/(-e*tan(alpha)**2 + 1)",
    ),
    (u**2 / (1 + T**2), "u**2*cos(alpha)**2"),
    (u * Z**2 + u * C**2 + v, "u + v"),
    (sqrt(u**2 + v**2), "sqrt(u**2 + v**2)"),
    (u * (u**2 + v**2) / sqrt(u**2 + v**2), "u*sqrt(u**2 + v**2)"),
    ((x**2 - 2 * x + 1) / (x - 1), "x - 1"),
    (1 - 1 / k, "(k - 1)/k"),
    ((3 + sqrt(3) + (1 + sqrt(3)) * e) * u, "u*(1 + sqrt(3))*(e + sqrt(3))"),
    (sqrt((1 + e**2) / 2) * u, "sqrt(2)*u*sqrt(e**2 + 1)/2"),
    (m * u * (1 + e) * Z / 3 * 2, "2*m*u*(e + 1)*sin(alpha)/3"),
    # the sign goes inside a sum that has a minus
    (-2 * (2 * k - 1) / (3 * k), "2*(1 - 2*k)/(3*k)"),
    (-(14 * e - 1) / 5, "(1 - 14*e)/5"),
    (-2 * (1 + e) / (4 * e - 1), "2*(e + 1)/(1 - 4*e)"),
    ((e - 1) ** 2 * C**2 + 4 * Z**2, "(1 - e)**2*cos(alpha)**2 + 4*sin(alpha)**2"),
    # roots
    (sqrt(2 * a - b) * sqrt(2 * a + b), "sqrt(4*a**2 - b**2)"),
    (b * sqrt(4 * a**2 - b**2) / (4 * a**2 - b**2), "b/sqrt(4*a**2 - b**2)"),
    (sqrt((1 - e) * (3 - e)) / (3 - e), "sqrt((1 - e)/(3 - e))"),
    (
        sqrt((m_1 - e * m_2) ** 2 * C**2 / (m_1 + m_2) ** 2 + Z**2),
        "sqrt((m_1 + m_2)**2*sin(alpha)**2 + (-e*m_2 + m_1)**2*cos(alpha)**2)/(m_1 + m_2)",
    ),
    # components and surds gathered
    ((u + v - e * (u - v)) / 2, "(u*(1 - e) + v*(e + 1))/2"),
    (1 - sqrt(3) - 2 * e - sqrt(3) * e, "-e*(sqrt(3) + 2) - sqrt(3) + 1"),
    (u * (2 - C**2 - e * C**2) / 2, "u*(-(e + 1)*cos(alpha)**2 + 2)/2"),
    # tangents and compound angles
    (Z * C / (1 + Z**2), "tan(alpha)/(2*tan(alpha)**2 + 1)"),
    ((a * T + b) / T, "a + b/tan(alpha)"),
    ((1 - T**4) * C**2 / 2, "(1 - tan(alpha)**2)/2"),
    (Z * cos(beta) - C * sin(beta), "sin(alpha - beta)"),
    (
        (C * sin(beta) + e * Z * cos(beta)) / sympy.Abs(e * Z * sin(beta) - C * cos(beta)),
        "(e*tan(alpha) + tan(beta))/Abs(e*tan(alpha)*tan(beta) - 1)",
    ),
    (
        sqrt((1 + e) ** 2 * Z**2 * C**2 + (C**2 - e * Z**2) ** 2),
        "sqrt(e**2*sin(alpha)**2 + cos(alpha)**2)",
    ),
]


@pytest.mark.parametrize(("given", "text"), TEXTBOOK, ids=[each[1] for each in TEXTBOOK])
def test_textbook_form(given: sympy.Expr, text: str) -> None:
    assert str(tidy(given)) == text


def test_a_textbook_form_is_left_alone() -> None:
    for given, _ in TEXTBOOK:
        once = tidy(given)
        assert tidy(once) == once


def test_what_is_not_an_expression_comes_back() -> None:
    assert tidy(None) is None
    assert tidy("u") == "u"
    assert tidy(sympy.true) is sympy.true
    assert tidy(S.NaN) is S.NaN


def test_ends_of_a_range() -> None:
    assert tidy(Interval.open(sqrt(12) / 6, 1)) == Interval.open(sqrt(3) / 3, 1)


# --- the value never changes ------------------------------------------------------------------


def at(expression: sympy.Expr, point: dict[Symbol, float]) -> complex:
    """The value in plain floats, by a walk that knows nothing of the code under test."""
    if expression in point:
        return complex(point[expression])
    if expression.is_Rational:
        return complex(float(expression))
    if expression is sympy.pi:
        return complex(math.pi)
    parts = [at(each, point) for each in expression.args]
    name = type(expression).__name__
    if name == "Add":
        return sum(parts, complex(0))
    if name == "Mul":
        return complex(math.prod(parts))
    if name == "Pow":
        return complex(parts[0] ** parts[1])
    if name == "Abs":
        return complex(abs(parts[0]))
    if expression is sympy.I:
        return 1j
    return complex({"sin": cmath.sin, "cos": cmath.cos, "tan": cmath.tan}[name](parts[0]))


LEAVES = [u, v, m, k, e, e_1, x, y, Z, C, T, sin(beta), cos(beta), 1 - e, 1 + e]
LEAVES += [sqrt(2), sqrt(3), S(2), S(3), S.Half]


def build(generator: random.Random, depth: int) -> sympy.Expr:
    if depth == 0 or generator.random() < 0.15:
        return generator.choice(LEAVES)
    left, right = build(generator, depth - 1), build(generator, depth - 1)
    kind = generator.randrange(8)
    if kind < 2:
        return left + right
    if kind == 2:
        return left - right
    if kind < 5:
        return left * right
    if kind == 5:
        return left / right if right != 0 else left
    return left**2 if kind == 6 else sqrt(left**2 + right**2)


def point_for(generator: random.Random, letters: set[Symbol]) -> dict[Symbol, float]:
    low = {alpha: 0.1, beta: 0.1, e: 0.0, e_1: 0.0, x: -3.0, y: -3.0}
    high = {alpha: 1.5, beta: 1.5, e: 1.0, e_1: 1.0}
    return {
        each: generator.uniform(low.get(each, 0.1), high.get(each, 3.0))
        for each in sorted(letters, key=str)
    }


@pytest.mark.parametrize("seed", range(8))
def test_value_is_unchanged(seed: int) -> None:
    generator = random.Random(seed)
    for _ in range(25):
        given = build(generator, generator.choice([1, 2, 2, 3]))
        if given.has(S.NaN, S.ComplexInfinity):
            continue
        found = tidy(given)
        for _ in range(4):
            point = point_for(generator, given.free_symbols)
            try:
                before = at(given, point)
            except ZeroDivisionError:
                continue
            # Values that arise by cancellation have no more than these figures.
            assert at(found, point) == pytest.approx(before, rel=1e-6, abs=1e-6), (given, found)


def test_a_factor_below_a_root_and_below_the_line_is_cancelled() -> None:
    """√(a b)/√a is √b, also where it comes out of a longer form."""
    m, u = sympy.symbols("m u", positive=True)
    e = sympy.Symbol("e", nonnegative=True)
    above = 8 * e**5 - 4 * e**4 - 10 * e**3 + 5 * e**2 + 2 * e - 1
    below = 4 * e**4 - 4 * e**3 - 3 * e**2 + 4 * e - 1
    sine = sqrt(3) * sqrt(1 - 2 * e) / (2 * (1 - 2 * e)) / sqrt(above / below)
    long = m * u * (1 + e) * sine / sqrt((e**2 - 1) / (4 * e**2 - 1))
    form = tidy(long)
    assert not form.has(1 - 2 * e)
    assert sympy.simplify((form - long).subs(e, sympy.Rational(1, 3))) == 0


def test_roots_of_negative_factors_keep_their_sign() -> None:
    given = sqrt((e - Z) * (x + u - Z / 2) / (Z + sin(beta)))
    point = {e: 0.75, alpha: 1.2, u: 0.5, x: -2.9, beta: 1.0}
    assert at(tidy(given), point) == pytest.approx(at(given, point))


def test_large_expressions_do_not_hang() -> None:
    many = sum(Symbol(f"x_{n}", real=True) ** n / (1 + Symbol(f"y_{n}")) for n in range(60))
    power = (u + v + w + m + M + k + g + h + a + b) ** 40 / (1 + u) ** 30 + 1
    nested = u
    for _ in range(60):
        nested = sqrt(1 + nested)
    for each in (many, power, nested, S(9) ** 9**5):
        assert tidy(each).free_symbols == each.free_symbols  # and it comes to an end


def test_the_sign_of_what_nearly_cancels_is_right() -> None:
    rest = Q(1, 10**14)
    total = (u + 1) ** 2 - u**2 - 2 * u - 1
    assert is_negative(total - rest)
    assert not is_negative(total + rest)
    assert has_one_sign(total + rest)
    assert not has_one_sign(u - v + total)
    assert not is_negative(-sqrt(u - 1))  # no real value everywhere
    assert is_negative(-(u**400) - v)  # beyond floats


# --- angles -----------------------------------------------------------------------------------

ANGLES = [
    (atan(sqrt(3)), pi / 3),
    (acos(Q(3, 5)), atan(Q(4, 3))),
    (acos(-Q(3, 5)), pi - atan(Q(4, 3))),
    (asin(Q(3, 5)), atan(Q(3, 4))),
    (asin(-Q(3, 5)), -atan(Q(3, 4))),
    (atan(Q(1, 2)) + atan(Q(1, 3)), pi / 4),
    (2 * atan(Q(1, 2)), atan(Q(4, 3))),
    (atan(Q(3, 4)) / 2, atan(Q(1, 3))),
    (atan(2 + sqrt(3)), 5 * pi / 12),
    (atan(sqrt(2) - 1), pi / 8),
    (acos((1 + sqrt(5)) / 4), pi / 5),
    (sympy.atan2(-4, -3), atan(Q(4, 3)) - pi),
    (sympy.atan2(S(4), S(-3)), pi - atan(Q(4, 3))),
    (acos(Q(1, 3)), acos(Q(1, 3))),
    (-acos(Q(13, 14)), -atan(3 * sqrt(3) / 13)),
    (-acos(Q(1, 7)), -atan(4 * sqrt(3))),
    (asin(4 / sqrt(17)), atan(4)),
    (atan(2) + atan(3) + pi, 7 * pi / 4),
    (atan(Z / C), alpha),
    (pi - atan(T), pi - alpha),
    (atan(1 / T), pi / 2 - alpha),
    (acos(Z), pi / 2 - alpha),
    (asin(Z), alpha),
    (atan(e * Z / C), atan(e * T)),
    (alpha, alpha),
    (pi / 36 + atan(2), pi / 36 + atan(2)),
]


@pytest.mark.parametrize(("given", "expected"), ANGLES, ids=[str(each[1]) for each in ANGLES])
def test_angles(given: sympy.Expr, expected: sympy.Expr) -> None:
    assert tidy_angle(given) == expected


def test_nearly_nice_angles_are_not_taken_for_nice() -> None:
    near = atan(sqrt(3) + Q(1, 10**30))
    assert tidy_angle(near) != pi / 3


# --- equality and rounding --------------------------------------------------------------------


def test_equal_expressions() -> None:
    assert same(sin(alpha + beta), Z * cos(beta) + C * sin(beta))
    assert same(sqrt(3 + 2 * sqrt(2)), 1 + sqrt(2))
    assert same(sqrt(2) + sqrt(3), sqrt(5 + 2 * sqrt(6)))
    assert same((u**2 - v**2) / (u - v), u + v)
    assert same(sqrt(1 - Z**2), C)
    assert same(atan(Q(1, 2)) + atan(Q(1, 3)), pi / 4)
    assert same(1 / (1 + T**2), 1 - Z**2)
    assert same(2, S(2))


def test_unequal_expressions() -> None:
    assert not same(u, v)
    assert not same(sqrt(x**2), x)
    assert not same(sqrt(2) + sqrt(3), Q(314626, 100000))
    assert not same(u + Q(1, 10**15), u)
    assert not same(S.Infinity, u)
    assert not is_zero(m * u * Q(1, 10**40))
    assert is_zero(S.Zero)


def test_decimal() -> None:
    assert decimal(sqrt(2)) == math.sqrt(2)
    assert decimal(u) is None
    assert decimal(sqrt(-2)) is None
    assert decimal(Q(1, 3)) == 1 / 3
    assert str(decimal(S.Zero)) == "0.0"


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (sqrt(103) / 16, "0.634"),
        (Q(6, 5), "1.20"),
        (Q(63, 25), "2.52"),
        (S(12345), "12300"),
        (S(12), "12.0"),
        (Q(123, 100000), "0.00123"),
        (Q(2525, 1000), "2.53"),
        (Q(-2525, 1000), "-2.53"),
        (Q(995, 1000), "0.995"),
        (Q(9996, 10000), "1.00"),
        (100 * pi, "314"),
        (S.Zero, "0"),
        (sqrt(2) - sqrt(8) + sqrt(2), "0"),
        (sqrt(3 + 2 * sqrt(2)) - sqrt(2) + Q(1525, 1000), "2.53"),
        (S(10) ** 9, "1.00 × 10⁹"),
        (Q(-1, 3 * 10**6), "-3.33 × 10⁻⁷"),
        (180 * atan(Q(3, 4)) / pi, "36.9"),
    ],
)
def test_three_figures(value: sympy.Expr, text: str) -> None:
    assert significant(value) == text


def test_figures_agree_with_decimal_arithmetic() -> None:
    generator = random.Random(3)
    for _ in range(300):
        number = Decimal(generator.randrange(1, 10**6)) / Decimal(10 ** generator.randrange(7))
        figures = generator.randrange(1, 6)
        rounded = Context(prec=figures, rounding=ROUND_HALF_UP).plus(number)
        if Decimal("0.0001") <= rounded < 10**7:
            assert Decimal(significant(Rational(str(number)), figures)) == rounded


def test_letters_cannot_be_rounded() -> None:
    with pytest.raises(ValueError, match="no real value"):
        significant(u)


def test_text_of_the_contract() -> None:
    lamda, mu = Symbol("lambda", positive=True), Symbol("mu", positive=True)
    assert sympy_text(sqrt(103) * u / 16) == "sqrt(103)*u/16"
    assert sympy_text(lamda * mu) == "lambda_*mu_"
    assert sympy_text(Symbol("e1") * Symbol("e_2")) == "e_1*e_2"
    assert sympy_text(Symbol("lambda_") + alpha) == "alpha + lambda_"
    assert sympy_text(Interval.Lopen(Q(1, 3), 1)) == "Interval.Lopen(1/3, 1)"
    assert sympy_text(tidy(3 * u / 8 + 5 * e * u / 8)) == "u*(5*e + 3)/8"


def test_equality_where_the_samples_are_not_real() -> None:
    far = sqrt(e - 5)
    assert same(far * far, e - 5)
    assert same(2 * far + far, 3 * far)
    assert not same(far, 2 * far)


TINY = sympy.Integer(10) ** -120
ROOTS = [
    # Zero, and as near to it as that without being so.
    (sympy.sqrt(2) + sympy.sqrt(3) - sympy.sqrt(5 + 2 * sympy.sqrt(6)), True),
    (sympy.sqrt(13 + TINY) - sympy.sqrt(13), False),
    (sympy.sqrt(2) + sympy.sqrt(3) - sympy.sqrt(5 + 2 * sympy.sqrt(6 + TINY)), False),
    (sympy.cbrt(2 + TINY) * sympy.sqrt(7) - sympy.cbrt(2) * sympy.sqrt(7), False),
    (4 * sympy.cos(sympy.pi / 9) ** 3 - 3 * sympy.cos(sympy.pi / 9) - sympy.Rational(1, 2), True),
    (4 * sympy.cos(sympy.pi / 9) ** 3 - 3 * sympy.cos(sympy.pi / 9) - (1 + TINY) / 2, False),
    (sympy.atan(sympy.Rational(2, 3) + TINY) - sympy.atan(sympy.Rational(2, 3)), False),
    (2 * sympy.atan(sympy.Rational(1, 3)) - sympy.atan(sympy.Rational(3, 4)), True),
    (sympy.sqrt(7) / (sympy.sqrt(5) - 2) - sympy.sqrt(7) * (sympy.sqrt(5) + 2), True),
    (sympy.sqrt(7) / (sympy.sqrt(5) - 2) - sympy.sqrt(7) * (sympy.sqrt(5) + 2 + TINY), False),
]


@pytest.mark.parametrize(("number", "zero"), ROOTS)
def test_no_difference_is_too_small(number, zero):
    assert is_zero(number) is zero


DEGREE = pi / 180
PLAIN = {
    atan((1 - cos(50 * DEGREE)) / sin(50 * DEGREE)): 25,
    atan(sin(50 * DEGREE) / cos(50 * DEGREE)): 50,
    pi - atan(tan(50 * DEGREE)): 130,
    pi / 2 - atan((1 - cos(37 * DEGREE)) / sin(37 * DEGREE)): Q(143, 2),
}


@pytest.mark.parametrize(("angle", "degrees"), PLAIN.items())
def test_an_angle_of_plain_angles_is_plain(angle, degrees):
    assert tidy_angle(angle) == degrees * DEGREE


def test_an_angle_near_a_plain_one_is_not_it():
    angle = atan((1 - cos(50 * DEGREE)) / sin(50 * DEGREE) + Q(1, 10**25))
    assert tidy_angle(angle) != 25 * DEGREE


def test_bars_inside_bars_are_one():
    u, v = sympy.symbols("u v", real=True)
    assert tidy(abs(v * abs(u))) == abs(u * v)
    assert tidy(u**2 / abs(u)) == abs(u)


def test_the_half_of_an_acute_angle_is_seen_in_its_tangent():
    a = Symbol("alpha", positive=True)
    halves = {
        sin(a) / (1 + cos(a)): a / 2,
        (1 - cos(a)) / sin(a): a / 2,
        (1 + cos(a)) / sin(a): pi / 2 - a / 2,
        (1 - sin(a)) / cos(a): pi / 4 - a / 2,
        (1 + sin(a)) / cos(a): pi / 4 + a / 2,
    }
    for tangent, half in halves.items():
        assert tidy_angle(atan(tangent)) == half
        assert abs((atan(tangent) - half).subs(a, Q(4, 5)).evalf()) < 1e-12
    for tangent in (sin(a) / (2 + cos(a)), 2 * sin(a) / (1 + cos(a))):
        assert isinstance(tidy_angle(atan(tangent)), atan)


def test_a_minus_goes_into_a_factor_that_has_one() -> None:
    w = Symbol("w", real=True)
    assert str(tidy(-5 * (w - 5) * (w + 1))) == "5*(5 - w)*(w + 1)"
    assert str(tidy(-5 * w * (w + 1))) == "-5*w*(w + 1)"


def test_a_sum_is_no_multiple_of_a_symbol() -> None:
    assert multiple_of_a_symbol(sqrt(3) * u / 2) == (sqrt(3) / 2, u)
    assert multiple_of_a_symbol(sqrt(3)) == (sqrt(3), None)
    assert multiple_of_a_symbol(12345 + u) is None  # it is not 12345u
    assert multiple_of_a_symbol(3 * u * v) is multiple_of_a_symbol(u**2) is None


def test_a_number_of_roots_is_worked_out_in_floats() -> None:
    exact = Q(2, 3) - sqrt(2 + sqrt(3)) / 5 + 2 ** Q(-3, 4)
    assert worked_out(exact, float, math.sqrt) == pytest.approx(float(exact))
    for other in (pi, 2 ** Q(1, 3)):
        with pytest.raises(TypeError):
            worked_out(other, float, math.sqrt)


def test_a_root_of_a_sum_of_roots_stands_below_where_that_is_shorter() -> None:
    root = sqrt(11 - 4 * sqrt(3))
    for given, text in (
        ((34 + 19 * sqrt(3)) * root / 146, "(sqrt(3) + 2)/(2*sqrt(11 - 4*sqrt(3)))"),
        ((4 * sqrt(3) + 11) * root / 73, "1/sqrt(11 - 4*sqrt(3))"),
        ((1 + sqrt(3)) * root, "sqrt(11 - 4*sqrt(3)) + sqrt(3)*sqrt(11 - 4*sqrt(3))"),
    ):
        assert str(tidy(given)) == text
        assert tidy(tidy(given)) == tidy(given)
        assert abs(complex((tidy(given) - given).evalf())) < 1e-12


def test_a_sum_of_roots_of_roots_is_the_root_of_its_square_where_that_is_plain() -> None:
    one = sqrt(3 * sqrt(3) - 5)
    for given, text in (
        (sqrt(sqrt(3) - 1) * (sqrt(6) - sqrt(2)) / 2, "sqrt(-5 + 3*sqrt(3))"),
        (sqrt(sqrt(3) - 1) * (sqrt(2) - sqrt(6)) / 6, "-sqrt(-5 + 3*sqrt(3))/3"),
        (sqrt(2 - sqrt(2)) + sqrt(2 + sqrt(2)), "sqrt(2 - sqrt(2)) + sqrt(sqrt(2) + 2)"),
        (sqrt(5 + sqrt(3)) + sqrt(7), "sqrt(sqrt(3) + 5) + sqrt(7)"),
    ):
        assert str(tidy(given)) == text
        assert abs(complex((tidy(given) - given).evalf())) < 1e-12
    assert tidy(one) == one


def test_a_sine_of_an_inverse_beside_a_root_stays() -> None:
    """Its angle is no rational part of a turn."""
    value = sqrt(2) * sympy.sin(4 * sympy.pi / 9 - sympy.atan(sympy.tan(5 * sympy.pi / 18) / 2))
    assert float(tidy(value)) == pytest.approx(float(value))
