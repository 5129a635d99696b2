"""The law of impact: welded to its principles, the same over every kind of number."""

from __future__ import annotations

import ast
import math
import random
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest
import sympy

from restitution import law, measure
from restitution.vector import Vector

SOURCE = Path(law.__file__)


def vector(name: str) -> Vector:
    return Vector(*sympy.symbols(f"{name}_x {name}_y", real=True))


def fraction(rng: random.Random, low: int = -9, high: int = 9) -> Fraction:
    return Fraction(rng.randint(low, high), rng.randint(1, 9))


def random_impact(seed: int) -> tuple[Vector, Vector, Fraction, Fraction, Vector, Fraction]:
    """Exact data of one impact; every third is with a wall."""
    rng = random.Random(seed)
    u1, u2, c = (Vector(fraction(rng), fraction(rng)) for _ in range(3))
    w1, w2 = fraction(rng, 1), fraction(rng, 1)
    if seed % 3 == 0:
        u2, w2 = Vector(Fraction(0), Fraction(0)), Fraction(0)
    if c == (0, 0):
        c = Vector(Fraction(1), Fraction(2))
    return u1, u2, w1, w2, c, Fraction(rng.randint(0, 12), 12)


def turned(v: Vector) -> Vector:
    """v turned by the acute angle with tangent 4/3, without a root."""
    return Vector((3 * v.x - 4 * v.y) / 5, (4 * v.x + 3 * v.y) / 5)


# --- the law and its principles ---------------------------------------------------------------


def test_closed_form_is_the_only_solution_of_the_principles():
    """Principles first, solved as the linear equations they are: the closed form comes out."""
    u1, u2, v1, v2, c = (vector(name) for name in ("u1", "u2", "v1", "v2", "c"))
    w1, w2, e = sympy.symbols("w1 w2 e", positive=True)
    principles = [
        law.momentum_along_line_of_centres(u1, u2, v1, v2, w1, w2, c),
        law.newtons_experimental_law(u1, u2, v1, v2, c, e),
        law.change_across_line_of_centres(u1, v1, c),
        law.change_across_line_of_centres(u2, v2, c),
    ]
    (solution,) = sympy.linsolve(principles, [*v1, *v2])
    first, second = law.impact(u1, u2, w1, w2, c, e)
    for derived, closed in zip(solution, [*first, *second], strict=True):
        assert sympy.cancel(derived - closed) == 0


def test_impulse_is_the_change_of_momentum():
    u1, u2, c = (vector(name) for name in ("u1", "u2", "c"))
    w1, w2, e = sympy.symbols("w1 w2 e", positive=True)
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    on_2 = law.impulse(u1, u2, w1, w2, c, e)
    for changed, expected in ((v2 - u2) / w2 - on_2, Vector(0, 0)), ((v1 - u1) / w1, -on_2):
        assert all(sympy.cancel(left - right) == 0 for left, right in zip(changed, expected))


def test_energy_lost_is_the_difference_of_kinetic_energies():
    u1, u2, c = (vector(name) for name in ("u1", "u2", "c"))
    w1, w2, e = sympy.symbols("w1 w2 e", positive=True)
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    before = (u1.dot(u1) / w1 + u2.dot(u2) / w2) / 2
    after = (v1.dot(v1) / w1 + v2.dot(v2) / w2) / 2
    assert sympy.cancel(before - after - law.kinetic_energy_lost(u1, u2, w1, w2, c, e)) == 0


def test_wall_is_a_body_of_no_inverse_mass():
    """Textbook formulas: tan(beta) = e tan(alpha), impulse (1+e)mu sin(alpha), and the energy."""
    m, u, alpha = sympy.symbols("m u alpha", positive=True)
    e = sympy.Symbol("e", positive=True)
    before = Vector(u * sympy.cos(alpha), -u * sympy.sin(alpha))
    data = before, Vector(0, 0), 1 / m, 0, Vector(0, -7), e
    after, wall = law.impact(*data)
    assert wall == (0, 0)
    assert sympy.simplify(after.y / after.x - e * sympy.tan(alpha)) == 0
    assert after.x == before.x
    on_wall = law.impulse(*data)
    assert on_wall.x == 0
    assert sympy.simplify(on_wall.y + (1 + e) * m * u * sympy.sin(alpha)) == 0
    lost = m * u**2 * sympy.sin(alpha) ** 2 * (1 - e**2) / 2
    assert sympy.simplify(law.kinetic_energy_lost(*data) - lost) == 0


# --- one body of test, every kind of number ---------------------------------------------------

KINDS = {
    "Fraction": Fraction,
    "float": float,
    "NumPy": lambda value: np.full(3, float(value)),
    "NumPy single": lambda value: np.full((2, 1), float(value), dtype=np.float32),
    "SymPy": lambda value: sympy.Rational(value.numerator, value.denominator),
}


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(12))
def test_every_kind_of_number(kind, seed):
    """The principles hold in each kind, and the kind comes out again."""
    number = KINDS[kind]
    u1, u2, w1, w2, c, e = random_impact(seed)
    u1, u2, c = (Vector(number(v.x), number(v.y)) for v in (u1, u2, c))
    w1, w2, e = number(w1), number(w2), number(e)
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    on_2 = law.impulse(u1, u2, w1, w2, c, e)
    lost = law.kinetic_energy_lost(u1, u2, w1, w2, c, e)
    residuals = [
        law.momentum_along_line_of_centres(u1, u2, v1, v2, w1, w2, c),
        law.newtons_experimental_law(u1, u2, v1, v2, c, e),
        law.change_across_line_of_centres(u1, v1, c),
        law.change_across_line_of_centres(u2, v2, c),
    ]
    for value in (*v1, *v2, *on_2, lost, *residuals):
        assert is_of_kind(value, number(Fraction(1)))
    exact = kind in ("Fraction", "SymPy")
    tolerance = 0 if exact else 2e-3 if kind == "NumPy single" else 1e-11
    assert all(np.all(abs(value) <= tolerance) for value in residuals)
    assert np.all(lost >= 0)


def is_of_kind(value: object, sample: object) -> bool:
    if isinstance(sample, np.ndarray):
        return (
            isinstance(value, np.ndarray)
            and value.shape == sample.shape
            and value.dtype == sample.dtype
        )
    if isinstance(sample, sympy.Basic):
        return isinstance(value, sympy.Rational)
    return type(value) is type(sample)


def test_many_impacts_at_once_are_those_one_by_one():
    cases = [random_impact(seed) for seed in range(60)]
    u1, u2, c = (
        Vector(*np.array([[float(x) for x in case[k]] for case in cases]).T) for k in (0, 1, 4)
    )
    w1, w2, e = (np.array([float(case[k]) for case in cases]) for k in (2, 3, 5))
    first, second = law.impact(u1, u2, w1, w2, c, e)
    for k, case in enumerate(cases):
        exact = [float(x) for v in law.impact(*case) for x in v]
        assert [first.x[k], first.y[k], second.x[k], second.y[k]] == pytest.approx(exact)


# --- figures from books -----------------------------------------------------------------------


def test_two_spheres_with_line_of_centres_along_j():
    data = Vector(3, -4), Vector(2, 3), Fraction(1, 2), Fraction(1, 3), Vector(0, 1), Fraction(3, 7)
    assert law.impact(*data) == ((3, 2), (2, -1))
    assert law.impulse(*data) == (0, -12)  # on B; 2(2 - -4) = 12 upwards on A
    # before: 2·25/2 + 3·13/2; after: 2·13/2 + 3·5/2
    assert law.kinetic_energy_lost(*data) == Fraction(89, 2) - Fraction(41, 2)


def test_line_of_centres_from_the_change_of_velocity():
    """6i - 5j becomes 3i - 9j: the line of centres is 3i + 4j, the component along it -2/5."""
    before, after = Vector(6, -5), Vector(3, -9)
    centres = Vector(3, 4)
    assert law.change_across_line_of_centres(before, after, centres) == 0
    assert Fraction(before.dot(centres), 5) == Fraction(-2, 5)


def test_offset_centres():
    """Masses 3m, 2m, speeds u, 2u towards each other, d = 1.6 r, e = 1/6: impulse 63mu/25."""
    sine = Fraction(16, 10) / 2
    cosine = Fraction(3, 5)
    on_2 = law.impulse(
        Vector(1, 0),
        Vector(-2, 0),
        Fraction(1, 3),
        Fraction(1, 2),
        Vector(cosine, sine),
        Fraction(1, 6),
    )
    assert on_2.dot(on_2) == Fraction(63, 25) ** 2


def test_corner_of_120_degrees():
    """Path at 60 degrees to AB, e = 1/2 at both walls: (√7/4)u, then (√103/16)u."""
    half, root3 = sympy.Rational(1, 2), sympy.sqrt(3)
    still = Vector(0, 0)
    before = Vector(half, -root3 / 2)
    first, _ = law.impact(before, still, 1, 0, Vector(0, 1), half)
    assert sympy.simplify(measure.speed(first) - sympy.sqrt(7) / 4) == 0
    # BC makes 60 degrees with AB produced: its normal
    second, _ = law.impact(first, still, 1, 0, Vector(-root3 / 2, half), half)
    assert sympy.simplify(measure.speed(second) - sympy.sqrt(103) / 16) == 0


# --- what must be true of any law of impact ---------------------------------------------------


@pytest.mark.parametrize("seed", range(40))
def test_same_for_a_moving_observer(seed):
    u1, u2, w1, w2, c, e = random_impact(seed)
    wind = Vector(Fraction(7, 3), Fraction(-5, 2))
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    assert law.impact(u1 + wind, u2 + wind, w1, w2, c, e) == (v1 + wind, v2 + wind)
    assert law.kinetic_energy_lost(u1 + wind, u2 + wind, w1, w2, c, e) == law.kinetic_energy_lost(
        u1, u2, w1, w2, c, e
    )


@pytest.mark.parametrize("seed", range(40))
def test_same_in_turned_and_mirrored_axes(seed):
    u1, u2, w1, w2, c, e = random_impact(seed)
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    for change in (turned, Vector.turned_left, lambda v: Vector(v.y, v.x)):
        moved = law.impact(change(u1), change(u2), w1, w2, change(c), e)
        assert moved == (change(v1), change(v2))


@pytest.mark.parametrize("seed", range(40))
def test_neither_size_nor_sense_of_the_line_of_centres_matters(seed):
    u1, u2, w1, w2, c, e = random_impact(seed)
    expected = law.impulse(u1, u2, w1, w2, c, e)
    for factor in (Fraction(-1), Fraction(5, 7), Fraction(-3)):
        assert law.impulse(u1, u2, w1, w2, c * factor, e) == expected


@pytest.mark.parametrize("seed", range(40))
def test_names_of_the_bodies_do_not_matter(seed):
    u1, u2, w1, w2, c, e = random_impact(seed)
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    assert law.impact(u2, u1, w2, w1, c, e) == (v2, v1)
    assert law.impulse(u2, u1, w2, w1, c, e) == -law.impulse(u1, u2, w1, w2, c, e)


@pytest.mark.parametrize("seed", range(40))
def test_perfectly_elastic_impacts_run_backwards(seed):
    u1, u2, w1, w2, c, _ = random_impact(seed)
    v1, v2 = law.impact(u1, u2, w1, w2, c, 1)
    assert law.impact(-v1, -v2, w1, w2, c, 1) == (-u1, -u2)
    assert law.kinetic_energy_lost(u1, u2, w1, w2, c, 1) == 0


def test_a_principle_that_fails_is_seen():
    """The residuals are not zero whatever is put in."""
    u1, u2, w1, w2, c, e = random_impact(1)
    v1, v2 = law.impact(u1, u2, w1, w2, c, e)
    off = v1 + c
    assert law.momentum_along_line_of_centres(u1, u2, off, v2, w1, w2, c) != 0
    assert law.newtons_experimental_law(u1, u2, off, v2, c, e) != 0
    assert law.change_across_line_of_centres(u1, v1 + c.turned_left(), c) != 0


# --- vectors and measures ---------------------------------------------------------------------


@pytest.mark.parametrize("factor", [2, 0.5, Fraction(1, 3), sympy.Symbol("k"), np.float64(2)])
def test_numbers_multiply_vectors_from_both_sides(factor):
    v = Vector(4, -6)
    assert factor * v == v * factor == (4 * factor, -6 * factor)
    assert isinstance(factor * v, Vector)
    assert (v / factor) == (4 / factor, -6 / factor)


def test_arrays_multiply_vectors_from_both_sides():
    v, factor = Vector(np.array([1.0, 2.0]), np.array([3.0, 4.0])), np.array([10.0, 100.0])
    for product in (factor * v, v * factor):
        assert isinstance(product, Vector)
        np.testing.assert_array_equal(product, [[10, 200], [30, 400]])


def test_sums_of_vectors_are_not_those_of_tuples():
    v = Vector(1, 2)
    assert v + Vector(3, 4) == (1, 2) + Vector(3, 4) == v + (3, 4) == (4, 6)
    assert v - (3, 4) == (-2, -2) and (3, 4) - v == (2, 2)
    assert -v == (-1, -2) and v.turned_left() == (-2, 1)
    assert v.dot((3, 4)) == 11 and v.cross((3, 4)) == -2


@pytest.mark.parametrize(
    "wrong",
    [lambda v: v * v, lambda v: v / v, lambda v: v * (1, 2), lambda v: (1, 2) * v, lambda v: v + 1],
)
def test_what_vectors_do_not_do(wrong):
    with pytest.raises(TypeError):
        wrong(Vector(1, 2))


@pytest.mark.parametrize("kind", [float, Fraction, np.float64, lambda x: np.full(2, float(x))])
def test_measures_of_numbers(kind):
    v, w = Vector(kind(3), kind(4)), Vector(kind(-4), kind(3))
    assert np.all(measure.speed(v) == 5)
    assert np.allclose(measure.direction(v), math.atan2(4, 3))
    assert np.allclose(measure.angle_between(v, w), math.pi / 2)
    assert np.allclose(measure.deflection(w, v), math.pi / 2)
    assert np.allclose(measure.deflection(v, -v), math.pi)
    assert np.allclose(measure.unit(v), measure.at_angle(measure.direction(v)))


def test_measures_of_symbols_are_exact():
    u = sympy.Symbol("u", positive=True)
    v, w = Vector(3 * u, 4 * u), Vector(-u, sympy.Integer(0))
    assert measure.speed(v) == 5 * u
    assert measure.direction(v) == sympy.atan(sympy.Rational(4, 3))
    assert measure.direction(w) == sympy.pi
    assert measure.angle_between(v, w) == sympy.pi - sympy.atan(sympy.Rational(4, 3))
    assert measure.at_angle(sympy.pi / 3) == (sympy.Rational(1, 2), sympy.sqrt(3) / 2)


def test_small_angles_keep_their_figures():
    assert measure.angle_between(Vector(1.0, 0.0), Vector(1.0, 1e-9)) == pytest.approx(1e-9)


# --- the source -------------------------------------------------------------------------------


def test_source_of_the_law_has_no_branch_no_loop_no_float_and_no_import():
    refused = (
        *(ast.If, ast.IfExp, ast.Compare, ast.BoolOp, ast.Match, ast.Try, ast.Assert, ast.While),
        *(ast.For, ast.comprehension, ast.Import, ast.ImportFrom, ast.Global, ast.Lambda),
    )
    for node in ast.walk(ast.parse(SOURCE.read_text(encoding="utf-8"))):
        where = f"line {getattr(node, 'lineno', '?')}"
        assert not isinstance(node, refused), f"{type(node).__name__} on {where}"
        if isinstance(node, ast.Constant):
            assert isinstance(node.value, (int, str)), f"{node.value!r} on {where}"
        if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow):
            assert isinstance(node.right, ast.Constant), f"a root on {where}"


def test_types_of_the_law_match_its_source():
    """law.pyi stands apart from law.py: both name the same functions and parameters."""

    def signatures(path: Path) -> dict[str, list[str]]:
        return {
            node.name: [each.arg for each in node.args.args]
            for node in ast.parse(path.read_text(encoding="utf-8")).body
            if isinstance(node, ast.FunctionDef)
        }

    assert signatures(SOURCE) == signatures(SOURCE.with_suffix(".pyi"))
