"""Claims about stories drawn at random, each with a bound that is known from a formula.

A bound moved by a billionth of itself has to turn the verdict: above the greatest value a claim
is true, below it false, and refuted by numbers that `plain_physics` checks.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

import pytest
from claims import ABOVE, BELOW, Shown, judged


@dataclass(frozen=True)
class Bound:
    """The greatest value (or the least) of a quantity; ``reached``, or only approached."""

    story: str
    quantity: str
    value: str
    reached: bool
    greatest: bool = True


Family = Callable[[random.Random], Bound]
FAMILIES: list[Family] = []


def family(make: Family) -> Family:
    FAMILIES.append(make)
    return make


def ratio(rng: random.Random, low: int = 1, high: int = 12) -> Fraction:
    return Fraction(rng.randint(low, high), rng.randint(low, high))


def share(rng: random.Random) -> Fraction:
    """A number between 0 and 1, neither included."""
    below = rng.randint(2, 30)
    return Fraction(rng.randint(1, below - 1), below)


def wide(rng: random.Random) -> str:
    return rng.choice(("10^-9", "10^-3", "1", "10^3", "10^9"))


WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
DIRECT = "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"
OBLIQUE = "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"


@family
def speed_from_a_wall(rng: random.Random) -> Bound:
    """√(cos² + e² sin²) falls to e as the path turns to the normal."""
    e = share(rng)
    return Bound(f"{WALL}given e >= {e}", "speed(P)", f"{e} u", reached=False, greatest=False)


@family
def speed_of_numbers(rng: random.Random) -> Bound:
    """The part along the wall stays, the other is at most e times what it was."""
    a, b, e, s = rng.randint(1, 9), rng.randint(1, 9), share(rng), wide(rng)
    story = f"wall W: along i\nsphere P: velocity {a}*{s} i - {b}*{s} j\nP hits W\ngiven e <= {e}"
    return Bound(story, "speed(P)", f"sqrt({a * a} + ({e}*{b})^2)*{s}", reached=True)


@family
def impulse_of_a_wall(rng: random.Random) -> Bound:
    """(1 + e) m u sin(alpha), alpha up to 90°."""
    e = share(rng)
    return Bound(f"{WALL}given e <= {e}", "impulse", f"(1 + {e}) m u", reached=False)


@family
def share_of_energy_lost_at_a_wall(rng: random.Random) -> Bound:
    """(1 - e²) sin²(alpha) with tan(alpha) <= t, e = 0."""
    t = ratio(rng)
    story = f"{WALL}given tan(alpha) <= {t}"
    return Bound(story, "energy_lost/energy(0)", str(t * t / (1 + t * t)), reached=True)


@family
def angle_lost_at_a_wall(rng: random.Random) -> Bound:
    """tan(alpha - beta) is greatest for tan(alpha) = 1/√e."""
    root = share(rng)
    story = WALL.replace("P hits W", f"P hits W: e = {root**2}")
    value = (1 - root**2) / (2 * root)
    return Bound(story, "tan(alpha - angle(velocity(P), W))", str(value), reached=True)


@family
def speed_of_what_is_struck(rng: random.Random) -> Bound:
    """(1 + e)/(1 + k) with k from some number on."""
    e, k = share(rng), ratio(rng)
    story = f"{DIRECT}given e <= {e}, k >= {k}"
    return Bound(story, "speed(B)", f"{(1 + e) / (1 + k)} u", reached=True)


@family
def speed_of_what_is_struck_and_light(rng: random.Random) -> Bound:
    """(1 + e)/(1 + k), k as small as one likes."""
    e = share(rng)
    story = DIRECT.replace("along i", f"along i, e = {e}")
    return Bound(story, "speed(B)", f"(1 + {e}) u", reached=False)


@family
def speed_along_the_line_of_centres(rng: random.Random) -> Bound:
    """(1 + e)/(1 + k) cos(alpha), alpha as small as one likes."""
    e, k = share(rng), ratio(rng)
    story = f"{OBLIQUE}given e <= {e}, k >= {k}"
    return Bound(story, "speed(B)", f"{(1 + e) / (1 + k)} u", reached=False)


@family
def energy_lost_by_spheres(rng: random.Random) -> Bound:
    """k/(1 + k) (1 - e²)/2 with k up to some number, e = 0."""
    k = ratio(rng)
    value = k / (1 + k) / 2
    return Bound(f"{DIRECT}given k <= {k}", "energy_lost", f"{value} m u^2", reached=True)


@family
def energy_lost_by_moving_spheres(rng: random.Random) -> Bound:
    """Reduced mass, and (u - v)² with v at least some share of u."""
    k, c = ratio(rng), share(rng)
    story = (
        f"sphere A: mass m, velocity u i\nsphere B: mass {k}*m, velocity v i\n"
        f"A hits B: along i\ngiven v >= {c} u"
    )
    value = k / (1 + k) * (1 - c) ** 2 / 2
    return Bound(story, "energy_lost", f"{value} m u^2", reached=True)


@family
def greatest_deflection(rng: random.Random) -> Bound:
    """With c = (1 - e k)/(1 + k) > 0: sin = (1 - c)/(1 + c), where tan²(alpha) = c."""
    e = share(rng)
    k = ratio(rng)
    while e * k >= 1:
        k /= 2
    story = (
        f"sphere A: mass m, velocity u at alpha\nsphere B: mass {k}*m, at rest\n"
        f"A hits B: along i, e = {e}"
    )
    value = k * (1 + e) / (2 + k * (1 - e))
    return Bound(story, "sin(deflection(A))", str(value), reached=True)


@family
def best_middle_mass(rng: random.Random) -> Bound:
    """(1 + e)² r/((1 + r)(r + k)) is greatest for r = √k."""
    e, root = share(rng), ratio(rng)
    story = (
        "sphere A: mass m, velocity u i\nsphere B: mass r m, at rest\n"
        f"sphere C: mass {root**2}*m, at rest\n"
        f"A hits B: along i, e = {e}\nB hits C: along i, e = {e}"
    )
    return Bound(story, "speed(C)", f"{((1 + e) / (1 + root)) ** 2} u", reached=True)


@family
def right_angled_corner(rng: random.Random) -> Bound:
    """Each component at most e times what it was."""
    e = share(rng)
    story = (
        "wall X: along i\nwall Y: along j\n"
        "sphere P: mass m, velocity -u cos(alpha) i - u sin(alpha) j\n"
        f"P hits X: e = e_1\nP hits Y: e = e_2\ngiven e_1 <= {e}, e_2 <= {e}"
    )
    return Bound(story, "speed(P)", f"{e} u", reached=True)


@family
def impulse_of_the_wall_behind(rng: random.Random) -> Bound:
    """k (1 + e)(1 + e_1)/(1 + k), both coefficients 1."""
    k = ratio(rng)
    story = (
        f"wall W: along j\nsphere A: mass m, velocity u i\nsphere B: mass {k}*m, at rest\n"
        "A hits B: along i\nB hits W: e = e_1"
    )
    return Bound(story, "impulse(2)", f"{4 * k / (1 + k)} m u", reached=True)


def claims_about(bound: Bound, name: str) -> list[Shown]:
    below, above, near, far = (
        ("<", "<=", BELOW, ABOVE) if bound.greatest else (">", ">=", ABOVE, BELOW)
    )
    truths = (
        (above, bound.value, True),
        (below, bound.value, not bound.reached),
        (above, f"{near}*{bound.value}", False),
        (below, f"{near}*{bound.value}", False),
        (above, f"{far}*{bound.value}", True),
        (below, f"{far}*{bound.value}", True),
    )
    return [
        Shown("random", name, bound.story, f"{bound.quantity} {relation} {value}", holds)
        for relation, value, holds in truths
    ]


def the_verdict_turns(make: Family, seed: str) -> None:
    bound = make(random.Random(seed))
    wrong, open_ = judged(claims_about(bound, seed))
    assert not wrong + open_, "\n".join((bound.story, *wrong, *open_))


NAMES = [each.__name__ for each in FAMILIES]


@pytest.mark.parametrize("n", range(3))
@pytest.mark.parametrize("make", FAMILIES, ids=NAMES)
def test_the_verdict_turns(make: Family, n: int) -> None:
    the_verdict_turns(make, f"{make.__name__} {n}")


@pytest.mark.nightly
@pytest.mark.parametrize("make", FAMILIES, ids=NAMES)
def test_the_verdict_turns_wherever(make: Family) -> None:
    for _ in range(100):
        seed = f"{make.__name__} {random.SystemRandom().randrange(10**12)}"
        print("seed:", seed)
        the_verdict_turns(make, seed)
