"""The short form: one impact of known bodies, over every kind of number."""

from __future__ import annotations

import copy
import math
import pickle
import subprocess
import sys
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import sympy
from hypothesis import assume, given
from hypothesis import strategies as st

import restitution as r
from restitution.errors import (
    ImpossibleError,
    MissingError,
    RestitutionError,
    StatementError,
    UnsupportedError,
)
from restitution.vector import Vector

half, root3 = sympy.Rational(1, 2), sympy.sqrt(3)
A = r.Sphere("A", mass=2, velocity="3i - 4j")
B = r.Sphere("B", mass=3, velocity="2i + 3j")
W = r.Wall("W", along="i")


def zero(expression: object) -> bool:
    return sympy.simplify(expression) == 0


# --- figures from books -----------------------------------------------------------------------


def test_two_spheres():
    hit = r.impact(A, B, line_of_centres="j", e="3/7")
    assert hit.after.A.velocity == (3, 2)
    assert hit.after.B.velocity == (2, -1)
    assert hit.before.A.velocity == (3, -4)
    assert hit.impulse == 12
    assert hit.impulse_on("A") == (0, 12) and hit.impulse_on(B) == (0, -12)
    assert hit.kinetic_energy_lost == 24
    assert hit.speed(A) == sympy.sqrt(13) and hit.speed("A", "before") == 5
    assert hit.line_of_centres == (0, -1)  # A is above B: they approach
    # (3, -4) to (3, 2): arctan(4/3) + arctan(2/3), whose tangent is 2/(1 - 8/9) = 18
    assert zero(sympy.tan(hit.deflection(A)) - 18)
    assert zero(hit.direction(B) + sympy.atan(half))


def test_wall_in_letters():
    P = r.Sphere("P", mass="m", velocity="u at alpha to W")
    hit = r.impact(P, W)
    m, u, alpha = sympy.symbols("m u alpha", positive=True)
    e = sympy.Symbol("e", nonnegative=True)
    assert hit.e == e
    assert zero(hit.impulse - (1 + e) * m * u * sympy.sin(alpha))
    assert zero(hit.kinetic_energy_lost - m * u**2 * sympy.sin(alpha) ** 2 * (1 - e**2) / 2)
    squared = u**2 * (sympy.cos(alpha) ** 2 + e**2 * sympy.sin(alpha) ** 2)
    assert zero(hit.speed(P) ** 2 - squared)
    after = hit.after.P.velocity
    assert zero(after.y / after.x - e * sympy.tan(alpha))
    # (tan α + tan β)/(1 − tan α tan β), with tan β = e tan α
    t = sympy.tan(alpha)
    assert zero(sympy.tan(hit.deflection(P)) - (1 + e) * t / (1 - e * t**2))
    assert hit.line_of_centres == (0, -1)


def test_corner_of_120_degrees_by_two_impacts():
    u = sympy.Symbol("u", positive=True)
    P = r.Sphere("P", velocity="u at 60° to AB")
    first = r.impact(P, r.Wall("AB", along="i"), e="1/2")
    assert zero(first.speed(P) - sympy.sqrt(7) * u / 4)
    second = r.impact(first.after.P, r.Wall("BC", along="60°"), e="1/2")
    assert zero(second.speed("P") - sympy.sqrt(103) * u / 16)


def test_offset_centres():
    P = r.Sphere("P", mass="3m", velocity="u i")
    Q = r.Sphere("Q", mass="2m", velocity="-2u i")
    hit = r.impact(P, Q, line_of_centres="arcsin(4/5)", e="1/6")
    m, u = sympy.symbols("m u", positive=True)
    assert zero(hit.impulse - sympy.Rational(63, 25) * m * u)


def test_line_of_centres_of_any_length_and_sense():
    expected = r.impact(A, B, line_of_centres="j", e="3/7")
    for line in ("-j", "5j", (0, -3), "90°", Vector(0, Fraction(1, 3)), "(0, 2)", sympy.pi / 2):
        assert r.impact(A, B, line_of_centres=line, e=Fraction(3, 7)).after == expected.after


@pytest.mark.parametrize(
    "wall",
    [
        r.Wall("W", along="i"),
        r.Wall("W", along=(-2, 0)),
        r.Wall("W", along=0),
        r.Wall("W", start=(0, 1), end=("5", 1)),
        r.Wall("W", along="180°", through=(0, 0)),
    ],
)
def test_ways_to_say_a_wall(wall):
    P = r.Sphere("P", mass=1, velocity=(3, -4))
    assert r.impact(P, wall, e="1/2").after.P.velocity == (3, 2)


def test_circular_wall_with_a_line_of_centres():
    P = r.Sphere("P", mass=1, velocity=(3, -4))
    circle = r.Wall("C", centre=(0, 0), radius=2)
    assert r.impact(P, circle, line_of_centres="j", e=1).after.P.velocity == (3, 4)
    with pytest.raises(MissingError, match="direction of the wall C"):
        r.impact(P, circle, e=1)


# --- kinds of number --------------------------------------------------------------------------


@pytest.mark.parametrize(
    "e", ["3/7", Fraction(3, 7), sympy.Rational(3, 7), "6/14"], ids=lambda e: type(e).__name__
)
@pytest.mark.parametrize(
    "velocity",
    ["3i - 4j", (3, -4), ["3", Decimal("-4")], sympy.Matrix([3, -4]), Vector(3, Fraction(-4))],
    ids=lambda v: type(v).__name__,
)
def test_everything_exact_gives_exact_answers(e, velocity):
    hit = r.impact(r.Sphere("A", 2, velocity), B, line_of_centres="j", e=e)
    for value in (*hit.after.A.velocity, hit.impulse, hit.kinetic_energy_lost, hit.speed("B")):
        assert isinstance(value, sympy.Expr) and not value.has(sympy.Float)
    assert hit.after.A.velocity == (3, 2)


@pytest.mark.parametrize(
    "velocity", [(3.0, -4.0), (3, np.float64(-4)), np.array([3.0, -4.0])], ids=str
)
def test_a_float_makes_all_the_numbers_floats(velocity):
    hit = r.impact(r.Sphere("A", 2, velocity), B, line_of_centres="j", e="3/7")
    values = (*hit.after.A.velocity, hit.impulse, hit.kinetic_energy_lost, hit.deflection("A"))
    assert all(isinstance(value, float) for value in values)
    assert values == pytest.approx((3, 2, 12, 24, math.atan2(18, 1)))


@pytest.mark.parametrize("as_pair", [False, True])
def test_arrays_are_many_impacts_at_once(as_pair):
    rng = np.random.default_rng(7)
    u1, u2, c = (rng.normal(size=(50, 2)) for _ in range(3))
    e, mass = rng.uniform(size=50), rng.uniform(1, 3, size=50)

    def form(v: np.ndarray) -> object:
        return Vector(v[:, 0], v[:, 1]) if as_pair else v

    hit = r.impact(
        r.Sphere("A", mass, form(u1)),
        r.Sphere("B", 2, form(u2)),
        line_of_centres=form(c),
        e=e,
    )
    assert len(repr(hit)) < 2000
    for k in range(50):
        one = r.impact(
            r.Sphere("A", float(mass[k]), tuple(map(float, u1[k]))),
            r.Sphere("B", 2, tuple(map(float, u2[k]))),
            line_of_centres=tuple(map(float, c[k])),
            e=float(e[k]),
        )
        for name in "AB":
            both = zip(hit.after[name].velocity, one.after[name].velocity, strict=True)
            assert all(many[k] == pytest.approx(single) for many, single in both)
            assert hit.deflection(name)[k] == pytest.approx(one.deflection(name))
        assert hit.impulse[k] == pytest.approx(one.impulse)
        assert hit.kinetic_energy_lost[k] == pytest.approx(one.kinetic_energy_lost)
        assert hit.line_of_centres.x[k] == pytest.approx(one.line_of_centres.x)


def test_one_array_spreads_over_the_rest():
    e = np.linspace(0, 1, 11)
    hit = r.impact(r.Sphere("P", 2, (3, -4)), W, e=e)
    np.testing.assert_allclose(hit.after.P.velocity.y, 4 * e)
    np.testing.assert_allclose(hit.kinetic_energy_lost, 16 * (1 - e**2))


def test_floats_and_arrays_do_not_load_sympy():
    code = """
import sys, numpy, restitution as r
P = r.Sphere("P", mass=2.0, velocity=numpy.ones((4, 2)))
hit = r.impact(P, r.Wall("W", along=(1.0, 0.0)), e=0.5)
hit.deflection(P), hit.impulse, repr(hit)
one = r.impact(r.Sphere("P", 2.0, (1.0, -1.0)), r.Wall("W", along=0.0), e=0.5)
one.deflection("P"), one.impulse, repr(one)
print("sympy" in sys.modules)"""
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, timeout=100, check=False
    )
    assert done.stdout.strip() == "False", done.stderr


def test_letters_with_floats_stay_letters():
    k = sympy.Symbol("k", positive=True)
    hit = r.impact(r.Sphere("P", k, (1.0, k)), r.Sphere("Q", 1, 0), line_of_centres=(1, 0), e=0.5)
    assert float(hit.after.Q.velocity.x.subs(k, 1)) == pytest.approx(0.75)


def test_a_lone_component_may_have_either_sign():
    """``p i + 2j``: p is any real number, so that the impulse is of size |p| times the rest."""
    P = r.Sphere("P", mass="m", velocity="p i + 2j")
    hit = r.impact(P, r.Wall("W", along="j"), e=1)
    p, m = sympy.Symbol("p", real=True), sympy.Symbol("m", positive=True)
    assert hit.before.P.velocity.x == p
    assert zero(hit.impulse - 2 * m * sympy.Abs(p))
    # but in u i it is a speed
    hit = r.impact(r.Sphere("P", mass="m", velocity="u i"), r.Wall("W", along="j"), e=1)
    assert zero(hit.impulse - 2 * m * sympy.Symbol("u", positive=True))


finite = st.integers(-20, 20)
ratios = st.fractions(min_value=0, max_value=1, max_denominator=20)


@given(finite, finite, finite, finite, st.integers(1, 9), st.integers(1, 9), finite, finite, ratios)
def test_exact_and_float_agree_and_conserve(ax, ay, bx, by, m1, m2, cx, cy, e):
    assume((cx, cy) != (0, 0) and (ax - bx) * cx + (ay - by) * cy != 0)
    P, Q = r.Sphere("P", m1, (ax, ay)), r.Sphere("Q", m2, (bx, by))
    exact = r.impact(P, Q, line_of_centres=(cx, cy), e=e)
    rough = r.impact(P, Q, line_of_centres=(float(cx), float(cy)), e=float(e))
    assert rough.impulse == pytest.approx(float(exact.impulse))
    assert rough.after.P.velocity == pytest.approx(tuple(map(float, exact.after.P.velocity)))

    def momentum(pair: object) -> Vector:
        return sum((body.velocity * body.mass for body in pair), Vector(0, 0))

    def energy(pair: object) -> sympy.Expr:
        return sum(body.mass * body.velocity.dot(body.velocity) for body in pair) / 2

    assert momentum(exact.before) == momentum(exact.after)
    assert energy(exact.before) - energy(exact.after) == exact.kinetic_energy_lost
    change = (exact.after.P.velocity - exact.before.P.velocity) * m1
    assert exact.impulse_on(P) == change == -exact.impulse_on(Q)
    assert zero(exact.impulse**2 - change.dot(change))
    assert exact.line_of_centres.dot(exact.before.P.velocity - exact.before.Q.velocity) > 0


# --- what cannot be answered ------------------------------------------------------------------


def sphere(**given_: object) -> r.Sphere:
    return r.Sphere("P", **{"mass": 1, "velocity": (3, -4), **given_})


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda: r.impact(sphere(), W, e="3/2"), ImpossibleError, r"e = 3/2"),
        (lambda: r.impact(sphere(), W, e=-0.5), ImpossibleError, r"e = -0.5"),
        (lambda: r.impact(sphere(), W, e=math.nan), ImpossibleError, r"e = nan"),
        (lambda: r.impact(sphere(mass=-2), W, e=1), ImpossibleError, "mass of P is -2"),
        (lambda: r.impact(sphere(mass=0.0), W, e=1), ImpossibleError, "mass of P is 0"),
        (lambda: r.impact(sphere(velocity="2i"), W, e=1), ImpossibleError, "do not approach"),
        (lambda: r.impact(A, B, line_of_centres=(0, 0), e=1), ImpossibleError, "zero vector"),
        (lambda: r.impact(sphere(), W, e=1.0).deflection("W"), ImpossibleError, "W is at rest"),
        (lambda: r.impact(A, B, e=1), MissingError, "line of centres of A and B"),
        (lambda: r.impact(sphere(velocity=None), W, e=1), MissingError, "velocity of P"),
        (lambda: r.impact(sphere(), r.Wall("W"), e=1), MissingError, "direction of the wall W"),
        (lambda: r.impact(sphere(velocity=(3.0, 1.0)), W), MissingError, "coefficient of rest"),
        (
            lambda: r.impact(sphere(mass=None), B, line_of_centres="j", e=1),
            MissingError,
            "mass of P",
        ),
        (lambda: r.impact(sphere(mass=None), W, e=1).impulse, MissingError, "impulse needs the m"),
        (lambda: r.impact(W, sphere(), e=1), StatementError, "first body .* is a Sphere"),
        (lambda: r.impact(A, 3, e=1), StatementError, "second body"),
        (lambda: r.impact(A, A, e=1), StatementError, "both bodies .* named A"),
        (
            lambda: r.impact(sphere(velocity=(math.nan, 0)), W, e=1),
            StatementError,
            "velocity of P is n",
        ),
        (
            lambda: r.impact(sphere(mass=math.inf), W, e=1),
            StatementError,
            "mass of P is inf: it must",
        ),
        (lambda: r.impact(sphere(velocity="3i - (4"), W, e=1), StatementError, "velocity of P"),
        (lambda: r.impact(sphere(velocity="3i k^"), W, e=1), StatementError, r"\(column \d"),
        (lambda: r.impact(sphere(velocity=5), W, e=1), StatementError, "where a vector is needed"),
        (lambda: r.impact(sphere(mass="2i"), W, e=1), StatementError, "mass of P is a vector"),
        (lambda: r.impact(sphere(velocity=(1, 2, 3)), W, e=1), StatementError, "3 components"),
        (lambda: r.impact(sphere(velocity=object()), W, e=1), StatementError, "velocity of P"),
        (lambda: r.impact(sphere(mass=1j), W, e=1), StatementError, "mass of P"),
        (lambda: r.impact(sphere(mass=sympy.I), W, e=1), StatementError, "mass of P"),
        (lambda: r.impact(A, W, e="speed(A)"), StatementError, "^e"),
        (lambda: r.impact(A, W, e=1).speed("Z"), StatementError, "Z takes no part"),
        (lambda: r.impact(A, W, e=1).speed(A, "later"), StatementError, "'later'"),
        (
            lambda: r.impact(sphere(mass="m", velocity=np.ones((3, 2))), W, e=1),
            UnsupportedError,
            "letters and arrays",
        ),
    ],
)
def test_errors_say_what_and_why(call, error, message):
    with pytest.raises(error, match=message):
        call()


@given(st.text(max_size=30))
def test_any_text_is_answered_or_refused(text):
    try:
        repr(r.impact(r.Sphere("P", mass=1, velocity=text), W, e="1/2"))
    except RestitutionError as error:
        assert error.message


# --- to hold and to see -----------------------------------------------------------------------


def test_what_comes_out_is_a_value():
    hit = r.impact(A, B, line_of_centres="j", e="3/7")
    assert hit == r.impact(A, B, line_of_centres="j", e="3/7")
    assert copy.deepcopy(hit) == hit and pickle.loads(pickle.dumps(hit)) == hit
    assert [body.name for body in hit.after] == ["A", "B"]
    assert hit.after["A"] is hit.after.A and "A" in dir(hit.after)
    assert not hasattr(hit.after, "C")
    with pytest.raises(KeyError, match="'C'"):
        _ = hit.after["C"]
    with pytest.raises(AttributeError):
        hit.e = 1


def test_it_shows_itself():
    assert repr(r.impact(A, B, line_of_centres="j", e="3/7")) == (
        "Impact of A and B, e = 3/7\n"
        "  A  velocity 3i - 4j → 3i + 2j\n"
        "     speed 5 → sqrt(13) = 3.61\n"
        "     angle of deflection atan(18) = 86.8°\n"
        "  B  velocity 2i + 3j → 2i - j\n"
        "     speed sqrt(13) = 3.61 → sqrt(5) = 2.24\n"
        "     angle of deflection atan(8) = 82.9°\n"
        "  line of centres along -j\n"
        "  impulse 12\n"
        "  kinetic energy lost 24"
    )
    still = r.impact(r.Sphere("P", velocity="2i"), r.Wall("W", along="j"), e=0)
    assert "at rest after" in repr(still) and "needs the mass of P" in repr(still)


def test_components_may_be_arrays_even_of_two() -> None:
    u = Vector(np.array([3.0, 4.0]), np.array([0.0, 1.0]))
    for velocity in (u, (u.x, u.y), [u.x, u.y]):
        A = r.Sphere("A", mass=1.0, velocity=velocity)
        B = r.Sphere("B", mass=1.0, velocity=(0.0, 0.0))
        hit = r.impact(A, B, line_of_centres=(1.0, 0.0), e=0.5)
        assert hit.impulse.tolist() == [2.25, 3.0]
        assert hit.after.A.velocity.x.tolist() == [0.75, 1.0]
        assert hit.after.A.velocity.y.tolist() == [0.0, 1.0]
