"""Angles that are sought where walls and lines of centres stand at any number of degrees.

What is expected is worked out in floats by the law of reflection alone.
"""

import math
import random

import pytest
import sympy as sp

from restitution import parse, solve
from restitution.solving.algebra.cosines import gathered, has_cosines, without_cosines

DEGREE = sp.pi / 180


def _number(rng: random.Random) -> sp.Expr:
    total = sp.Integer(0)
    for _ in range(rng.randint(1, 5)):
        term = sp.Rational(rng.randint(-5, 5), rng.randint(1, 4))
        for _ in range(rng.randint(0, 3)):
            angle = rng.choice([10, 18, 20, 25, 37, 40, 50, 60, 70])
            term *= rng.choice([sp.sin, sp.cos])(angle * DEGREE)
        if rng.random() < 0.3:
            term *= sp.sqrt(rng.choice([2, 3, 5, 6, 7, 15]))
        total += term
    return total


@pytest.mark.parametrize("seed", range(12))
def test_products_of_cosines_as_sums_have_the_same_value(seed: int) -> None:
    rng, t = random.Random(seed), sp.Symbol("t")
    x = _number(rng) + _number(rng) * t + _number(rng) * t**2
    gap = (gathered(x) - x).subs(t, sp.Rational(7, 3))
    assert abs(sp.N(gap, 40)) < 1e-30


def test_what_is_zero_or_plain_in_disguise_is_seen() -> None:
    c, s = (lambda d: sp.cos(d * DEGREE)), (lambda d: sp.sin(d * DEGREE))
    assert gathered(s(70) * c(20) + s(20) ** 2 - 1) == 0
    assert gathered(c(20) * c(40) * c(80)) == sp.Rational(1, 8)
    x = sp.Symbol("x")
    assert gathered(x**2 * (s(70) - c(20)) + x * (4 * s(20) * s(70) - 2 * s(40))) == 0
    assert not has_cosines(sp.cos(sp.Symbol("alpha")) + sp.sqrt(3))


def _reflected(v: complex, wall: float, e: float) -> complex:
    turned = v * complex(math.cos(wall), -math.sin(wall))
    return complex(turned.real, -e * turned.imag) * complex(math.cos(wall), math.sin(wall))


def _roots(gap, steps: int = 4000) -> list[float]:
    """Where a function of an acute angle changes its sign, in degrees."""
    step = math.pi / 2 / steps
    found = []
    for n in range(1, steps - 1):
        low, high = n * step, (n + 1) * step
        if (gap(low) < 0) == (gap(high) < 0):
            continue
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if (gap(middle) < 0) == (gap(low) < 0) else (low, middle)
        found.append(math.degrees(low))
    return found


def _turned(v: complex, w: complex) -> float:
    return math.acos(max(-1.0, min(1.0, (v.conjugate() * w).real / abs(v) / abs(w))))


WALLS = [
    # walls, coefficients, the fact, and the same of the velocities before, between and after
    ((20, 70), (0.5, 0.5), "speed(P) = 2/3 speed(P, 0)", lambda v: abs(v[2]) - 2 / 3 * abs(v[0])),
    ((10, 80), (0.5, 0.25), "speed(P) = 1/2 speed(P, 0)", lambda v: abs(v[2]) - abs(v[0]) / 2),
    ((25,), (1 / 4, 0), "deflection(P) = 60°", lambda v: _turned(v[0], v[1]) - math.pi / 3),
    ((40,), (1, 0), "deflection(P) = 60°", lambda v: _turned(v[0], v[1]) - math.pi / 3),
    ((30, 75), (0.5, 0.5), "speed(P) = 3/5 speed(P, 0)", lambda v: abs(v[2]) - 0.6 * abs(v[0])),
]


@pytest.mark.parametrize(("walls", "es", "fact", "gap"), WALLS)
def test_every_angle_is_found_and_no_other(walls, es, fact, gap) -> None:
    names = "VW"[: len(walls)]
    lines = [f"wall {name}: along {d}°" for name, d in zip(names, walls, strict=True)]
    lines += ["sphere P: velocity u at alpha"]
    lines += [f"P hits {name}: e = {e}" for name, e in zip(names, es, strict=False)]
    solution = solve(parse("\n".join([*lines, f"given {fact}", "find alpha"])))

    def difference(alpha: float) -> float:
        velocities = [complex(math.cos(alpha), math.sin(alpha))]
        for d, e in zip(walls, es, strict=False):
            velocities.append(_reflected(velocities[-1], math.radians(d), e))
        return float(gap(velocities))

    answers = sorted(math.degrees(float(each.decimal)) for each in solution["alpha"].distinct)
    assert answers == pytest.approx(_roots(difference), abs=1e-7)
    assert all(not each.condition for each in solution["alpha"].distinct)


def test_degrees_come_out_as_degrees() -> None:
    text = """sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along 40°, e = 1/2
given deflection(A) = 60°
find alpha"""
    answers = solve(parse(text))["alpha"].distinct
    assert {each.value for each in answers} == {10 * DEGREE, 70 * DEGREE}


@pytest.mark.parametrize(
    ("angle", "fact", "display"),
    [
        (35, "energy_lost = 3", "√(16 sin² 35° − 3)/(4 sin 35°) = 0.656"),
        (40, "speed(P) = 7", "√(64 sin² 40° − 15)/(8 sin 40°) = 0.658"),
    ],
)
def test_answers_have_the_angles_of_the_data(angle: int, fact: str, display: str) -> None:
    text = f"wall W: along i\nsphere P: mass 0.5, velocity 8 at {angle}° to W\nP hits W\n"
    (answer,) = solve(parse(f"{text}given {fact}\nfind e"))["e"].distinct
    assert answer.display == display


def test_a_deflection_where_the_coefficient_is_a_letter() -> None:
    text = "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
    item = solve(parse(f"{text}given deflection(P) = 60°\nfind alpha"))["alpha"]
    (answer,) = item.distinct
    assert not answer.condition
    for e in (0.2, 0.7, 1.0):
        (letter,) = answer.value.free_symbols
        t = math.tan(float(answer.value.xreplace({letter: sp.Float(e)})))
        assert math.degrees(math.atan(t) + math.atan(e * t)) == pytest.approx(60)


def _unit(turn: float) -> complex:
    return complex(math.cos(turn), math.sin(turn))


def _collided(u: complex, v: complex, masses: tuple[int, int], line: float) -> tuple[float, float]:
    """The speed of the first sphere after an impact with e = ½, and the impulse."""
    n = _unit(line)
    approach = ((u - v) * n.conjugate()).real
    impulse = 1.5 * approach / (1 / masses[0] + 1 / masses[1])
    return abs(u - impulse / masses[0] * n), impulse


@pytest.mark.parametrize(
    ("before", "gap"),
    [
        # The spheres and their line of centres, and the fact with the same in floats
        (
            """sphere A: mass 2, velocity 5 at theta
sphere B: mass 3, velocity 2 at 160°
A hits B: along 20°, e = 1/2
given speed(A) = 4""",
            lambda x: (
                _collided(5 * _unit(x), 2 * _unit(math.radians(160)), (2, 3), math.radians(20))[0]
                - 4
            ),
        ),
        (
            """sphere A: mass 2, velocity 5 at 70°
sphere B: mass 3, velocity 2 at 40°
A hits B: along theta, e = 1/2
given impulse = 2""",
            lambda x: (
                _collided(5 * _unit(math.radians(70)), 2 * _unit(math.radians(40)), (2, 3), x)[1]
                - 2
            ),
        ),
    ],
)
def test_an_angle_is_found_where_both_spheres_move_at_odd_angles(before: str, gap) -> None:
    part = solve(parse(f"{before}\nfind theta")).parts[None]
    (item,) = part.items
    assert item.error is None
    found = sorted(math.degrees(float(each.decimal)) for each in item.answers)
    assert found == pytest.approx(_roots(gap))


def test_both_lines_of_centres_by_which_a_sphere_is_turned_through_so_much_are_found() -> None:
    text = """sphere A: mass 3, velocity 5 at 10°
sphere B: mass 2, velocity 2 at 40°
A hits B: along theta, e = 1/2
given deflection(A) = 10°
find theta"""
    u, v = 5 * _unit(math.radians(10)), 2 * _unit(math.radians(40))

    def gap(x: float) -> float:
        impulse = _collided(u, v, (3, 2), x)[1]
        return _turned(u, u - impulse / 3 * _unit(x)) - math.radians(10)

    item = solve(parse(text))["theta"]
    found = sorted(math.degrees(float(each.decimal)) for each in item.distinct)
    assert len(found) == 2
    assert found == pytest.approx(_roots(gap))


def test_cosines_are_left_out_of_a_polynomial_without_losing_a_root() -> None:
    x, c = sp.Symbol("x"), sp.cos(20 * DEGREE)
    lone = without_cosines(x**2 - 2 * c * x + sp.sqrt(2) * sp.sin(10 * DEGREE), x)
    assert lone is not None
    assert not has_cosines(lone)
    root = complex(sp.N(c + sp.sqrt(c**2 - sp.sqrt(2) * sp.sin(10 * DEGREE))))
    assert abs(complex(lone.subs(x, root))) < 1e-6
