"""The algebra: plain polynomials, what is known of roots, and work counted before it is begun."""

from __future__ import annotations

import mpmath
import pytest
import sympy as sp
from mpmath.libmp import NoConvergence

from restitution import work
from restitution.errors import UnsupportedError
from restitution.exact.quotients import over_surds
from restitution.language import parse
from restitution.solving import solve
from restitution.solving.algebra import polynomials as plain
from restitution.solving.algebra import systems as algebra
from restitution.solving.algebra.number_fields import split_over_numbers
from restitution.solving.algebra.real_roots import roots
from restitution.solving.algebra.resultants import resultant
from restitution.solving.algebra.signs import definite, rational_below, vanishing
from restitution.solving.story.letters import ACUTE, COEFFICIENT, POSITIVE, REAL

x, y, m = sp.symbols("x y m", positive=True)
e = sp.Symbol("e", nonnegative=True)
z = sp.Symbol("z", real=True)
angle = sp.Symbol("alpha", positive=True)
r3, r5 = sp.sqrt(3), sp.sqrt(5)


# --- a statement whose algebra once had no end -------------------------------------------------

NESTED = """
sphere A: mass 5, velocity u at 150°
sphere B: mass 1/3, velocity (3, -1)
A hits B: along (3, 4)
given deflection(A) = arctan(7*(159175*sqrt(3) + 395472)/89618797)
given speed(A) = sqrt(8652*sqrt(3) + 897583)/576
find u, e
"""


def after(u: mpmath.mpf, e: mpmath.mpf) -> tuple[tuple, tuple, tuple]:
    """A's velocities before and after, and B's after, from momentum and restitution."""
    c = mpmath.mpf(-3) / 5, mpmath.mpf(-4) / 5
    before = u * mpmath.cos(5 * mpmath.pi / 6), u * mpmath.sin(5 * mpmath.pi / 6)
    other = mpmath.mpf(3), mpmath.mpf(-1)
    ua, ub = (v[0] * c[0] + v[1] * c[1] for v in (before, other))
    ma, mb = mpmath.mpf(5), mpmath.mpf(1) / 3
    # ma va + mb vb = ma ua + mb ub and vb − va = e (ua − ub)
    va = (ma * ua + mb * ub - mb * e * (ua - ub)) / (ma + mb)
    vb = va + e * (ua - ub)
    a = before[0] + (va - ua) * c[0], before[1] + (va - ua) * c[1]
    b = other[0] + (vb - ub) * c[0], other[1] + (vb - ub) * c[1]
    return before, a, b


def test_nested_roots_are_solved():
    solution = solve(parse(NESTED))
    assert [item.error for item in solution.parts[None].items] == [None, None]
    with mpmath.workdps(60):
        u, e = (mpmath.mpf(str(sp.N(solution[name].exact, 60))) for name in ("u", "e"))
        assert 0 <= e <= 1
        assert u > 0
        before, a, b = after(u, e)
        assert abs(5 * before[0] + 1 - 5 * a[0] - b[0] / 3) < mpmath.mpf(10) ** -30
        root = mpmath.sqrt(3)
        turned = mpmath.atan2(
            abs(before[0] * a[1] - before[1] * a[0]), before[0] * a[0] + before[1] * a[1]
        )
        expected = mpmath.atan(7 * (159175 * root + 395472) / mpmath.mpf(89618797))
        assert abs(turned - expected) < mpmath.mpf(10) ** -30
        speed = mpmath.sqrt(8652 * root + 897583) / 576
        assert abs(mpmath.hypot(*a) - speed) < mpmath.mpf(10) ** -30


@pytest.mark.parametrize(
    ("statement", "answers"),
    [
        (  # e belongs to a cosine that is a root of roots
            """
            sphere A: mass 6, velocity 2 at alpha
            sphere B: mass 1, at rest
            A hits B: along (4, -3)
            given deflection(A) = arctan(48/611), along(velocity(A), i) = 184/125
            find alpha, e
            """,
            {"alpha": [sp.atan(sp.Rational(3, 4))], "e": [1]},
        ),
        (  # the roots that are rejected have no formula
            """
            sphere A: mass 2, velocity 1 at alpha from j
            sphere B: mass 3, at rest
            A hits B: along (1, -1)
            given along(velocity(A), i) = -123/520, energy_lost = 6069/27040
            find alpha, e
            """,
            {"alpha": [sp.atan(sp.Rational(12, 5))], "e": [sp.Rational(3, 4)]},
        ),
        (  # the second solution has no formula
            """
            sphere A: mass 3/2, velocity u at 120°
            sphere B: mass 2, velocity (2, 5/3)
            A hits B: along (1, -1)
            given energy_lost = (180sqrt(3) + 343)/42, speed(A) = 2sqrt(2324 - 837sqrt(3))/21
            find u, e
            """,
            {"u": [6, "10.60"], "e": [0, "0.8174"]},
        ),
        (
            """
            sphere A: mass 2, velocity (2, 3/2)
            sphere B: mass 3/2, velocity (-1, 5)
            B hits A: e = 1, along theta
            given impulse = 3(-6 + 7sqrt(3))/7
            find theta
            """,
            {"theta": [sp.pi / 3]},
        ),
    ],
)
def test_surds_among_the_data(statement, answers):
    solution = solve(parse(statement))
    for name, wanted in answers.items():
        values = [answer.value for answer in solution[name].answers]
        assert len(values) == len(wanted)
        for value, own in zip(values, wanted, strict=True):
            if isinstance(own, str):
                assert str(sp.N(value, 4)) == own
            else:
                assert value == own


# --- rings and normal forms -------------------------------------------------------------------


def test_radicands_are_split_into_coprime_numbers():
    assert plain._coprime([12, 18, 30, 49, 101 * 101 * 7]) == (2, 3, 5, 7, 101)
    large = (10**20 + 39) * (10**20 + 129)  # which nobody could take apart without the other
    assert plain._coprime([large, 10**20 + 39]) == (10**20 + 39, 10**20 + 129)


@pytest.mark.parametrize(
    ("expression", "vanishes"),
    [
        (sp.sqrt(6) - sp.sqrt(2) * r3, True),
        (1 / (r3 - 1) - (r3 + 1) / 2, True),
        (1 / (r3 - 1) - (r3 + 1) / 2 + sp.Rational(1, 10**40), False),
        (sp.sin(angle) ** 2 + sp.cos(angle) ** 2 - 1, True),
        (sp.sin(angle) ** 2 + sp.cos(angle) ** 2 - x, False),
        (sp.sqrt(x**2 + y**2) ** 2 - x**2 - y**2, True),
        (x / (x + y) + y / (x + y) - 1, True),
        (sp.sqrt(5 + 2 * sp.sqrt(6)) - sp.sqrt(2) - r3, None),  # a root that could be taken
    ],
)
def test_zero_is_decided_by_normal_form(expression, vanishes):
    assert vanishing(sp.sympify(expression)) is vanishes


@pytest.mark.parametrize(
    ("expression", "sign"),
    [
        (1 + e, 1),
        (-x * y - e, -1),
        (x - y, 0),
        (e, 0),
        ((r3 - 1) * x + y, 1),
        ((r3 - 2) * x + y, 0),
        (z**2 + m, 1),
        (z + m, 0),
        (z**2, 0),
        (sp.sqrt(x + y) + e, 1),
        (-1 / (x + y), -1),
        (sp.cos(angle) ** 2 + 1, 1),
        (sp.cos(angle) + 1, 0),
        (sp.sqrt(2) + r3 - sp.sqrt(10), -1),
    ],
)
def test_signs(expression, sign):
    assert definite(sp.sympify(expression)) == sign


def test_signs_of_sines_are_those_that_are_known():
    c, s = sp.cos(angle), sp.sin(angle)
    assert definite(c + x * s) == 0
    assert definite(c + x * s, frozenset({c, s})) == 1


def test_coefficients():
    assert plain.coefficients(sp.expand((r3 * x - y) ** 2), x) == (3, -2 * r3 * y, y**2)
    assert plain.coefficients(x / (1 + r3), x) == (r3 / 2 - sp.Rational(1, 2), 0)
    assert plain.coefficients(sp.Integer(0), x) == ()
    with pytest.raises(sp.PolynomialError):
        plain.coefficients(1 / x, x)
    with pytest.raises(sp.PolynomialError):
        plain.coefficients(sp.sqrt(x + 1), x)


@pytest.mark.parametrize(
    "expression",
    [
        x**2 * y - y**3,
        (x + 2 * y) ** 3 * (x**2 + m) * (3 - x * y),
        e**2 * sp.cos(angle) ** 2 - sp.sin(angle) ** 2,
        5 * m * x**2 - 5 * m * y**2,
    ],
)
def test_factors_are_those_of_sympy_in_its_order(expression):
    wanted = tuple(factor for factor, _ in sp.factor_list(sp.expand(expression))[1])
    assert plain.factors(sp.expand(expression)) == wanted


@pytest.mark.parametrize(
    ("f", "g"),
    [
        (r3 * x**2 + y * x - 1, x * y - r3),
        (x**3 + r3 * x * y + r5, x**2 - r5 * y * x + r3),
        (x**2 + y**2 - 1, x**2 - 2 * x * y + m),
        (x**2 + y, y**2 + 1),
    ],
)
def test_resultants(f, g):
    # Up to a number: the determinant of Sylvester's matrix, by SymPy.
    a, b = sp.Poly(f, x).all_coeffs(), sp.Poly(g, x).all_coeffs()
    rows = [[0] * k + a + [0] * (len(b) - 2 - k) for k in range(len(b) - 1)]
    rows += [[0] * k + b + [0] * (len(a) - 2 - k) for k in range(len(a) - 1)]
    wanted = sp.expand(sp.Matrix(rows).det(method="berkowitz"))
    answer = resultant(f, g, x)
    ratio = sp.radsimp(sp.cancel(answer / wanted))
    assert ratio.is_Rational
    assert ratio != 0


def test_factors_over_surds():
    whole = sp.expand((x**2 - 2 * r3 * x + 1) * (x**2 + r3) * (x - 5))
    assert set(split_over_numbers(whole, x)) == {
        x - 5,
        x**2 + r3,
        x**2 - 2 * r3 * x + 1,
    }
    conjugates = sp.expand((x**4 - 3) * (x - r3))
    assert set(split_over_numbers(conjugates, x)) == {x - r3, x**2 + r3, x**2 - r3}
    root = sp.sqrt(5 + r3)
    assert set(split_over_numbers(sp.expand((x - root) * (x**2 - root * x + r3)), x)) == {
        x - root,
        x**2 - root * x + r3,
    }


def test_a_root_without_a_formula_is_a_letter_with_its_polynomial():
    root = sp.CRootOf(x**3 + x + 1, 0)
    assert vanishing(root**3 + root + 1) is True
    assert vanishing(root**2 - root) is False
    assert rational_below(1 / root) == -1 - root**2
    for quotient in ((2 * root + 1) / (root**2 - 3), (root + r3) / (root - r3)):
        simpler = rational_below(quotient)
        assert abs(sp.N(simpler - quotient, 30)) < sp.Float("1e-28")
        assert all(node.exp.is_positive for node in simpler.atoms(sp.Pow))


# --- systems ----------------------------------------------------------------------------------

ROLES = {"x": POSITIVE, "y": POSITIVE, "m": POSITIVE, "e": COEFFICIENT, "z": REAL, "alpha": ACUTE}


def solved(equations, unknowns):
    none: frozenset[sp.Symbol] = frozenset()
    solutions = algebra.solve_system(equations, unknowns, none, none, ROLES)
    return [dict(each.values) for each in solutions]


def test_sizes_are_one_sign_or_the_other():
    solutions = solved([sp.Abs(z - 2) - 3], [z])
    assert sorted(each["z"] for each in solutions) == [-1, 5]
    # The range of α tells the sign of its cosine.
    assert solved([e * sp.Abs(sp.cos(angle)) - sp.cos(angle) / 2], [e]) == [
        {"e": sp.Rational(1, 2)}
    ]


def test_numbers_decide_zero_exactly():
    tiny = sp.Rational(1, 10**40)
    solutions = algebra.solve_system([z - 1, z - 1 - tiny], [z], frozenset(), frozenset(), ROLES)
    assert solutions == [], "no tolerance makes them the same"


def test_work_is_refused_before_it_is_begun():
    """The same amount each time, and an error that speaks of the question."""
    a, b = sp.symbols("a b", real=True)
    letters = sp.symbols("k0:9", positive=True)
    f = sum((k * a**n * b ** (7 - n) for n, k in enumerate(letters)), sp.Integer(0)) + 1
    g = sum((k * b**n * a ** (8 - n) for n, k in enumerate(letters)), sp.Integer(0)) - a - 3
    left = []
    for _ in range(2):
        with work.limited(operations=10**12) as limit:
            with pytest.raises(UnsupportedError, match="too hard to solve exactly"):
                algebra.solve_system([f, g], [a, b], frozenset(), frozenset(), {})
            left.append(limit.left)
        for cached in (plain.numerator, plain.coefficients, plain.factors, resultant):
            cached.cache_clear()
    assert left[0] == left[1]


def test_cubics_with_letters_are_beyond_people():
    with pytest.raises(UnsupportedError, match="degree 3 with letters"):
        roots(x**3 + m * x + y, x)
    assert roots(x**3 - 8 * m**3, x) == [2 * m]


def test_a_root_is_finite_where_a_coefficient_with_cosines_vanishes() -> None:
    """Of (k - 1) c² x² - 2c² x + (k + 1) s², the root of the rest, s²/c², has a value at k = 1."""
    x, k, alpha = sp.Symbol("x"), sp.Symbol("k", positive=True), sp.Symbol("alpha", positive=True)
    c, s = sp.cos(alpha), sp.sin(alpha)
    values = roots((k - 1) * c**2 * x**2 - 2 * c**2 * x + (k + 1) * s**2, x)
    numbers = [value.subs({k: 1, alpha: sp.pi / 6}) for value in values]
    assert sp.Rational(1, 3) in numbers


@pytest.mark.parametrize("sign", [1, -1])
def test_a_root_stays_where_the_leading_coefficient_vanishes(sign):
    """Of (1 - m)x² ± 2x - 3 = 0, the root of ± 2x - 3 has a value for m = 1 as well."""
    equation = (1 - m) * x**2 + sign * 2 * x - 3
    values = roots(equation, x)
    assert [value.subs(m, 1) for value in values].count(sp.Rational(3 * sign, 2)) == 1
    for value in values:
        assert sp.simplify(equation.subs(x, value)) == 0


def test_a_quotient_loses_a_factor_that_is_double_on_one_side() -> None:
    t = sp.Symbol("t", positive=True)
    value = sp.expand((t + 3 * r3) * (t - r3) ** 2) / ((r3 * t - 3) * (t + 1))
    assert sp.simplify(over_surds(value) - (t + 3 * r3) * (t - r3) / (r3 * (t + 1))) == 0
    assert sp.degree(sp.fraction(over_surds(value))[1], t) == 1


def test_a_quotient_whose_roots_are_not_found_stays_as_it_is(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def polyroots(*_: object, **__: object) -> list[object]:
        raise NoConvergence("too many steps")

    u, v = sp.symbols("u v", positive=True)
    value = (sp.sqrt(3) * u**2 + 4 * u * v + sp.sqrt(3) * v**2) / (3 * v**2 - u**2)
    assert over_surds(value) != value
    monkeypatch.setattr(mpmath, "polyroots", polyroots)
    assert over_surds(value) == value


def test_a_quotient_with_the_root_of_a_negative_number_for_some_letters_is_answered() -> None:
    solution = solve(
        parse(
            "wall W: along i\nwall V: along 60°\nsphere P: mass m, velocity u at alpha to W\n"
            "P hits W: e = e\nP hits V: e = f\ngiven angle(velocity(P), V) = 30°\nfind tan(alpha)"
        )
    )
    (item,) = solution.parts[None].items
    assert item.error is None
    (answer,) = item.distinct
    f = next(s for s in answer.value.free_symbols if s.name == "f")
    assert answer.value.subs(f, sp.Rational(1, 3)) == 0
    assert answer.condition == ("3*f > 1",)  # without the root of a sum of squares
