"""Altered worlds: exact answers satisfy the altered equations and all laws that hold on."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction

import mpmath
import pytest
import sympy as sp

import restitution as r
from restitution.errors import StatementError, UnsupportedError
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.mistakes.altered import altered
from restitution.explaining.mistakes.consequences import altered_world, altered_worlds, applying
from restitution.explaining.mistakes.misconceptions import (
    MISCONCEPTIONS,
    alteration,
    laws_at,
    variants_at,
)
from restitution.expression.tree import Apply, Binary, Name, Negate, Number, Quantity

SMALL = mpmath.mpf(10) ** -40


@pytest.fixture(autouse=True)
def many_digits() -> Iterator[None]:
    """Sixty digits here; other tests have a precision of their own."""
    with mpmath.workdps(60):
        yield


WALL = """
wall W: along 3i + 4j
sphere P: mass 3, velocity {u}
P hits W: e = {e}
find velocity(P)
"""
SPHERES = """
sphere A: mass {m}, velocity {u}
sphere B: mass {n}, velocity {v}
A hits B: along {c}, e = {e}
find velocity(A), velocity(B)
"""
FORWARD = [
    WALL.format(u="7i - 2j", e="2/5"),
    WALL.format(u="2i - 3j", e="3/4"),
    SPHERES.format(m=2, n=3, u="3i - 4j", v="2i + 3j", c="j", e="3/7"),
    SPHERES.format(m=5, n=2, u="4i + j", v="-3i + 2j", c="4i - 3j", e="1/2"),
    SPHERES.format(m=2, n=2, u="6i + 2j", v="-i + 5j", c="i", e="2/3"),
    SPHERES.format(m=1, n=4, u="5i + 3j", v="0", c="i + j", e="1/3"),
]


class World:
    """Velocities as numbers of many digits, and what trees are worth by them."""

    def __init__(self, solution, names):
        self.masses = {s.name: _number(s.mass) for s in solution.problem.spheres if s.mass}
        (part,) = solution.parts.values()
        story = part.branches[0].story
        (impact,) = story.happenings
        self.e = mpmath.mpf(str(1)) * impact.e.p / impact.e.q
        line = impact.oriented()
        size = mpmath.sqrt(_digits(line.x) ** 2 + _digits(line.y) ** 2)
        self.c = (_digits(line.x) / size, _digits(line.y) / size)
        self.at = {
            (name, stage): tuple(map(_digits, story.velocity(name, stage)))
            for name in names
            for stage in (0, 1)
        }

    def component(self, part, name, stage):
        x, y = self.at[name, stage]
        return x * self.c[0] + y * self.c[1] if part == "along" else y * self.c[0] - x * self.c[1]

    def value(self, tree):
        match tree:
            case Number(value):
                return mpmath.mpf(value.numerator) / value.denominator
            case Negate(operand):
                return -self.value(operand)
            case Binary(op, left, right):
                a, b = self.value(left), self.value(right)
                return (
                    {"+": a + b, "-": a - b, "*": a * b}.get(op)
                    if op in "+-*"
                    else (a / b if op == "/" else a**b)
                )
            case Apply("abs", argument):
                return abs(self.value(argument))
            case Quantity("restitution"):
                return self.e
            case Quantity("mass", (Name(name),)):
                return self.masses[name]
            case Quantity("speed", (Name(name),), stage):
                return mpmath.hypot(*self.at[name, stage])
            case Quantity("energy", (Name(name),), stage):
                return self.masses[name] * mpmath.hypot(*self.at[name, stage]) ** 2 / 2
            case Quantity("along" | "across" as part, (Quantity(_, (Name(name),), stage), _)):
                return self.component(part, name, stage)
        raise TypeError(tree)


def _digits(x):
    return mpmath.mpf(x.evalf(55)) if x.free_symbols == set() else None


def _number(tree):
    assert isinstance(tree, Number)
    return mpmath.mpf(tree.value.numerator) / tree.value.denominator


def residual(world, law):
    left, right = law.sides
    return abs(world.value(left) - world.value(right))


@pytest.mark.parametrize("text", FORWARD)
def test_altered_equations_hold_and_the_other_laws_still_do(text):
    problem = r.parse(text)
    true = r.solve(problem)
    (event,) = events_of(problem)
    names = event.bodies[:1] if event.wall else event.bodies
    checked = 0
    for variant in variants_at(event):
        if not variant.laws or not variant.alteration.solvable:
            continue
        try:
            solved = altered_world(true, variant.alteration).solution
        except UnsupportedError:
            continue
        if any(item.error for _, item in solved.items()):
            continue
        world = World(solved, names)
        for law in variant.laws:
            assert residual(world, law) < SMALL, variant.id
        for law in laws_at(event):
            replaced = any(
                each.law == law.law and set(law.bodies) <= set(each.bodies) for each in variant.laws
            )
            assert replaced or residual(world, law) < SMALL, (variant.id, law.law)
        checked += 1
    assert checked > (7 if event.wall else 30)


@pytest.mark.parametrize("text", FORWARD)
def test_true_laws_hold_in_the_true_world(text):
    problem = r.parse(text)
    (event,) = events_of(problem)
    world = World(r.solve(problem), event.bodies[:1] if event.wall else event.bodies)
    assert all(residual(world, law) < SMALL for law in laws_at(event))


def rebound(u, e):
    """Of a wall along i, from above: what each variant gives, by hand."""
    x, y = u
    return {
        "restitution-parallel/1": (e * x, -y),
        "restitution-parallel/2": (e * x, y),
        "restitution-parallel/3": (-e * x, y),
        "restitution-inverted/1": (x, -y / e),
        "restitution-omitted/1": (x, -y),
        "restitution-sign/8": (x, e * y),
        "across-changed/1": (e * x, -e * y),
        "across-changed/2": (0, -e * y),
        "energy-conserved/1": (x, -y),
        "speed-for-component/1": (x, 5 * e),
        "speed-for-component/2": (0, 5 * e),
    }


@pytest.mark.parametrize("name", rebound((3, -4), Fraction(1, 2)))
def test_at_a_wall_by_hand(name):
    problem = r.parse(
        "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind velocity(P)"
    )
    wanted = rebound((3, -4), Fraction(1, 2))[name]
    assert tuple(map(str, r.solve_as(problem, name)["velocity(P)"].exact)) == tuple(
        map(str, wanted)
    )


def test_of_spheres_by_hand():
    problem = r.parse(
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 1, velocity -4i + j\n"
        "A hits B: along i, e = 1/2\nfind velocity(A), velocity(B)"
    )
    # 2 × 3 + 1 × 4 = 2v + w and w − v = 7/2: v = 13/6, w = 17/3.
    world = r.solve_as(problem, "momentum-sign/2")
    assert ", ".join(map(str, world["velocity(A)"].exact)) == "13/6, 2"
    assert ", ".join(map(str, world["velocity(B)"].exact)) == "17/3, 1"
    # Masses left out: v + w = −1, w − v = 7/2.
    world = r.solve_as(problem, "mass-omitted/1")
    assert ", ".join(map(str, world["velocity(A)"].exact)) == "-9/4, 2"
    # Energy conserved is e = 1: 2v + w = 2, w − v = 7.
    world = r.solve_as(problem, "energy-conserved/2")
    assert ", ".join(map(str, world["velocity(B)"].exact)) == "16/3, 1"
    # Masses exchanged: 3 − 8 = v + 2w, w − v = 7/2.
    world = r.solve_as(problem, "masses-exchanged")
    assert ", ".join(map(str, world["velocity(B)"].exact)) == "-1/2, 1"


BACKWARD = (
    "momentum-sign/2", "restitution-inverted/2", "mass-omitted/1", "restitution-sign/3",
    "masses-exchanged/1", "sine-cosine/5", "across-changed/10", "angle-from-normal/4",
)  # fmt: skip


@pytest.mark.parametrize("name", BACKWARD)
def test_backwards_is_the_inverse_of_forwards(name):
    """e is found again from a component after, in the same altered world."""
    start = (
        "sphere A: mass 2, velocity 5i + 3j\nsphere B: mass 3, velocity -i + 2j\n"
        "A hits B: along i, e = {}\n"
    )
    forward = r.parse(start.format("2/5") + "find along(velocity(B), i)")
    changed = altered(forward, alteration(name))
    assert changed is not None
    after = r.solve(changed.problem)["along(velocity(B), i)"].exact
    backward = r.parse(
        start.replace("hits B: along i, e = {}", "hits B: along i")
        + f"given along(velocity(B), i) = {after}\nfind e"
    )
    changed = altered(backward, alteration(name))
    assert changed is not None
    solved = r.solve(changed.problem)["e"]
    found = [each.exact for each in (*solved.answers, *solved.rejected)]
    assert "2/5" in found


def test_an_unknown_line_of_centres_in_an_altered_world():
    """A changes by 2.6 along (3, 4)/5; with the masses exchanged B gets 5.2, and e is a half."""
    text = (
        "sphere A: mass 1, velocity 6i + 2j\nsphere B: mass 2, velocity 0\nA hits B\n"
        "given velocity(A) = 4.44i - 0.08j\nfind line_of_centres, e"
    )
    problem = r.parse(text)
    world = altered_world(r.solve(problem), alteration("masses-exchanged/1")).solution
    assert tuple(world["line_of_centres"].exact) == (sp.Rational(3, 5), sp.Rational(4, 5))
    assert world["e"].exact == sp.Rational(1, 2)


def test_a_result_is_altered_alone():
    problem = r.parse(
        "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\n"
        "find speed(P), deflection(P), impulse, energy_lost"
    )
    for name, item, value in (
        ("deflection-is-after/1", "deflection(P)", "atan(2/3)"),
        ("impulse-sign/1", "impulse", "4"),
        ("energy-of-difference/1", "energy_lost", "36"),
        ("energy-component-missing/1", "energy_lost", "21"),
    ):
        (world,) = altered_worlds(r.solve(problem), name)
        assert [each.text for each in world.items] == [item]
        assert str(world.solution[item].exact) == value
        assert world.solution.mistake == name


def test_a_fraction_of_the_energy_along_the_line():
    problem = r.parse(
        "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\n"
        "find energy_lost/energy(0)"
    )
    (world,) = altered_worlds(r.solve(problem), "energy-fraction-of-line")
    assert str(world.solution["energy_lost/energy(0)"].exact) == "3/4"


def test_a_given_result_is_misunderstood_too():
    """Half the energy taken for half the speed: q² + 9 = 25/4 has no root, and with 3/4 it has."""
    text = (
        "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W\n"
        "given energy(P) = 4/5 energy(P, 0)\nfind e"
    )
    (world,) = altered_worlds(r.solve(r.parse(text)), "energy-ratio-as-speed")
    # Speed 4 after: q² = 16 − 9, e = √7/4.
    assert str(world.solution["e"].exact) == "sqrt(7)/4"


def test_whole_speeds_need_a_root_that_separates():
    problem = r.parse(SPHERES.format(m=2, n=2, u="6i + 2j", v="0", c="i", e="1/2"))
    world = r.solve_as(problem, "restitution-whole-speed/2")
    (x, y), (w, across) = (world[f"velocity({name})"].exact for name in "AB")
    assert (y, across) == (2, 0)
    assert sp.simplify(x + w - 6) == 0
    assert float(w - x) > 0
    assert abs(float(w - (x**2 + 4) ** 0.5 - 40**0.5 / 2)) < 1e-12


def test_what_cannot_be_says_why():
    wall = r.solve(r.parse(FORWARD[0]))
    with pytest.raises(StatementError, match="did you mean momentum-sign"):
        altered_worlds(wall, "momentum-sing")
    with pytest.raises(StatementError, match="momentum-sign/1 to momentum-sign/7"):
        altered_worlds(wall, "momentum-sign/8")
    with pytest.raises(UnsupportedError, match="no impact of two spheres; these apply: restit"):
        altered_worlds(wall, "momentum-sign")
    with pytest.raises(UnsupportedError, match="has no world of its own"):
        altered_worlds(wall, "rounding-early")
    with pytest.raises(UnsupportedError, match="does not speak of energy lost"):
        altered_worlds(wall, "energy-of-difference/1")
    with pytest.raises(StatementError, match="has no statement"):
        r.to_statement(r.solve_as(wall.problem, "restitution-omitted").problem)
    with pytest.raises(UnsupportedError, match="has answers and no working"):
        r.explain(r.solve_as(wall.problem, "restitution-omitted"))


def test_mistakes_that_apply():
    names = applying(r.parse(FORWARD[0]))
    assert "restitution-parallel" in names
    assert not {"momentum-sign", "second-wall-angle", "deflection-is-after"} & set(names)


def test_the_first_impact_alone():
    problem = r.parse(
        "wall AB: along i\nwall CD: along j\nsphere P: velocity 3i - 4j\n"
        "P hits AB: e = 1/2\nP hits CD: e = 1/2\nfind velocity(P)"
    )
    true = r.solve(problem)
    both = altered_world(true, alteration("restitution-omitted/1"))
    first = altered_world(true, alteration("restitution-omitted/1"), only=(1,))
    assert (both.events, first.events) == ((1, 2), (1,))
    assert tuple(both.solution["velocity(P)"].exact) == (-3, 4)
    assert tuple(first.solution["velocity(P)"].exact) == (sp.Rational(-3, 2), 4)


def test_the_old_angle_at_a_second_wall():
    """At 60° to the first wall with e = 1/3 it leaves at 30°, and a right-angled corner makes 60°.

    With 30° in place of that, V = 1/√3: along the second wall V cos 30° = 1/2, and e V sin 30°.
    """
    problem = r.parse(
        "wall AB: along i\nwall BC: along j\nsphere P: velocity u at 60° to AB\n"
        "P hits AB: e = 1/3\nP hits BC: e = 1/2\nfind speed(P)"
    )
    world = r.solve_as(problem, "second-wall-angle")
    u = next(iter(world["speed(P)"].exact.free_symbols))
    wanted = mpmath.sqrt(mpmath.mpf(1) / 4 + mpmath.mpf(1) / 48)
    assert abs(float(world["speed(P)"].exact / u) - float(wanted)) < 1e-12


@pytest.mark.nightly
def test_random_impacts_in_every_world():
    rng = random.Random(16)
    for _ in range(60):
        numbers = [rng.randint(-6, 6) for _ in range(4)]
        text = SPHERES.format(
            m=rng.randint(1, 6),
            n=rng.randint(1, 6),
            u=f"{numbers[0] or 1}i + {numbers[1]}j".replace("+ -", "- "),
            v=f"{numbers[2] or 2}i + {numbers[3]}j".replace("+ -", "- "),
            c=rng.choice(("i", "j", "3i + 4j")),
            e=rng.choice(("1/2", "1/3", "3/5")),
        )
        problem = r.parse(text)
        true = r.solve(problem)
        if any(item.error for _, item in true.items()):
            continue
        (event,) = events_of(problem)
        for variant in variants_at(event):
            if not variant.laws or not variant.alteration.solvable:
                continue
            try:
                solved = altered_world(true, variant.alteration).solution
            except UnsupportedError:
                continue
            errors = [item.error.message for _, item in solved.items() if item.error]
            assert not [each for each in errors if "report" in each or "fault" in each], text
            if not errors:
                world = World(solved, event.bodies)
                assert all(residual(world, law) < SMALL for law in variant.laws), variant.id


def test_every_variant_has_a_story_or_a_reason():
    """No variant fails its own check against numbers on these questions."""
    for text in FORWARD:
        true = r.solve(r.parse(text))
        for row in MISCONCEPTIONS.values():
            for each in row.variants:
                try:
                    world = altered_world(true, each)
                except UnsupportedError:
                    continue
                errors = [item.error.message for _, item in world.solution.items() if item.error]
                assert not [message for message in errors if "report" in message], each.id
