"""Consistent questions in which a letter stays free, and clashing ones, from `plain_physics`.

A motion is drawn with magnitudes from 10⁻⁶ to 10⁶, what it gives is stated as a fact, and a
letter on which it rests is left free. The fact then has a solution for some values of the letter
only. Since one value, that of the motion, is among them, "impossible" is wrong; and the condition
that comes with the answer has to be exactly right: at any value of the letter, close to its ends
above all, the answers are those with which the story can happen.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cache
from typing import Any

import claims
import mpmath as mp
import plain_physics as physics
import pytest
from plain_physics import number

from restitution.errors import RestitutionError
from restitution.language import parse
from restitution.problem import Problem
from restitution.solving import solve

Roots = Callable[[Any], list[Any]]


@dataclass(frozen=True)
class Question:
    """A statement that leaves ``free`` free and asks for ``sought``.

    ``value`` is what ``free`` was in the motion; ``roots`` gives, for any value of ``free``,
    every root of the equations, whether the motion can happen with it or not.
    """

    statement: str
    free: str
    value: Any
    sought: str
    roots: Roots = field(repr=False)


Maker = Callable[[random.Random], Question]
QUESTIONS: list[Maker] = []


def question(make: Maker) -> Maker:
    QUESTIONS.append(make)
    return make


def magnitude(rng: random.Random) -> Fraction:
    return Fraction(rng.randint(1, 99), rng.choice((1, 2, 3, 7, 10))) * Fraction(10) ** rng.choice(
        (-6, -3, -1, 0, 0, 0, 1, 3, 6)
    )


def share(rng: random.Random) -> Fraction:
    """Strictly between 0 and 1, at times near an end."""
    near = Fraction(1, 10**6)
    return rng.choice((Fraction(rng.randint(1, 19), 20),) * 6 + (near, 1 - near))


def coefficient(rng: random.Random) -> Fraction:
    """From 0 to 1; at an end, the motion lies on the very border of the condition."""
    return rng.choice((Fraction(0), Fraction(1), *(share(rng) for _ in range(4))))


def roots_of_square(square: Any) -> list[Any]:
    if abs(square) <= physics.NONE:
        return [mp.mpf(0)]
    return [] if square < 0 else [mp.sqrt(square), -mp.sqrt(square)]


@question
def impulse_of_a_wall(rng: random.Random) -> Question:
    m, u, e = magnitude(rng), magnitude(rng), coefficient(rng)
    impulse = (1 + e) * m * u
    statement = (
        f"wall W: along i\nsphere P: mass {m}, velocity -u j\nP hits W\n"
        f"given impulse = {impulse}\nfind e"
    )
    m, u, impulse = map(number, (m, u, impulse))
    return Question(statement, "u", u, "e", lambda x: [impulse / (m * x) - 1])


@question
def impulse_of_a_wall_on_a_mass(rng: random.Random) -> Question:
    m, u, e = magnitude(rng), magnitude(rng), coefficient(rng)
    impulse = (1 + e) * m * u
    statement = (
        f"wall W: along i\nsphere P: mass M, velocity -{u} j\nP hits W\n"
        f"given impulse = {impulse}\nfind e"
    )
    m, u, impulse = map(number, (m, u, impulse))
    return Question(statement, "M", m, "e", lambda x: [impulse / (x * u) - 1])


@question
def speed_from_a_wall(rng: random.Random) -> Question:
    u, e = magnitude(rng), coefficient(rng)
    square = u * u * (16 + 9 * e * e) / 25
    statement = (
        "wall W: along i\nsphere P: velocity u at arctan(3/4) to W\nP hits W\n"
        f"given speed(P)^2 = {square}\nfind e"
    )
    u, square = map(number, (u, square))
    return Question(
        statement, "u", u, "e", lambda x: roots_of_square((25 * square / (x * x) - 16) / 9)
    )


@question
def energy_lost_at_a_wall(rng: random.Random) -> Question:
    m, u, e = magnitude(rng), magnitude(rng), coefficient(rng)
    lost = (1 - e * e) * m * u * u / 2
    statement = (
        f"wall W: along i\nsphere P: mass {m}, velocity -u j\nP hits W\n"
        f"given energy_lost = {lost}\nfind e"
    )
    m, u, lost = map(number, (m, u, lost))
    return Question(statement, "u", u, "e", lambda x: roots_of_square(1 - 2 * lost / (m * x * x)))


@question
def impulse_between_spheres(rng: random.Random) -> Question:
    m, k, u, e = magnitude(rng), magnitude(rng), magnitude(rng), coefficient(rng)
    impulse = (1 + e) * m * k / (m + k) * u
    statement = (
        f"sphere A: mass {m}, velocity {u} i\nsphere B: mass M, at rest\nA hits B: along i\n"
        f"given impulse = {impulse}\nfind e"
    )
    m, k, u, impulse = map(number, (m, k, u, impulse))
    return Question(statement, "M", k, "e", lambda x: [impulse * (m + x) / (m * x * u) - 1])


@question
def velocity_of_the_striking_sphere(rng: random.Random) -> Question:
    m, k, u, e = magnitude(rng), magnitude(rng), magnitude(rng), coefficient(rng)
    after = (m - e * k) / (m + k) * u
    statement = (
        f"sphere A: mass {m}, velocity u i\nsphere B: mass {k}, at rest\nA hits B: along i\n"
        f"given along(velocity(A), i) = {after}\nfind e"
    )
    m, k, u, after = map(number, (m, k, u, after))
    return Question(statement, "u", u, "e", lambda x: [(m - after * (m + k) / x) / k])


@question
def energy_lost_between_spheres(rng: random.Random) -> Question:
    m, k, u, e = magnitude(rng), magnitude(rng), magnitude(rng), coefficient(rng)
    lost = m * k / (m + k) * (1 - e * e) * u * u / 2
    statement = (
        f"sphere A: mass {m}, velocity {u} i\nsphere B: mass M, at rest\nA hits B: along i\n"
        f"given energy_lost = {lost}\nfind e"
    )
    m, k, u, lost = map(number, (m, k, u, lost))
    return Question(
        statement,
        "M",
        k,
        "e",
        lambda x: roots_of_square(1 - 2 * lost * (m + x) / (m * x * u * u)),
    )


@question
def mass_from_a_speed(rng: random.Random) -> Question:
    m, k, u, e = magnitude(rng), magnitude(rng), magnitude(rng), coefficient(rng)
    speed = (1 + e) * m / (m + k) * u
    statement = (
        f"sphere A: mass {m}, velocity u i\nsphere B: mass M, at rest\n"
        f"A hits B: along i, e = {e}\ngiven speed(B) = {speed}\nfind M"
    )
    m, k, u, e, speed = map(number, (m, k, u, e, speed))
    return Question(statement, "u", u, "M", lambda x: [(1 + e) * m * x / speed - m])


@question
def mass_from_a_velocity(rng: random.Random) -> Question:
    """(m - e M) u = (m + M) a, where a is the velocity of A afterwards."""
    m, k, u, e = magnitude(rng), magnitude(rng), magnitude(rng), coefficient(rng)
    after = (m - e * k) / (m + k) * u
    statement = (
        f"sphere A: mass {m}, velocity u i\nsphere B: mass M, at rest\n"
        f"A hits B: along i, e = {e}\ngiven along(velocity(A), i) = {after}\nfind M"
    )
    m, u, e, after = map(number, (m, u, e, after))

    def roots(x: Any) -> list[Any]:
        below = after + e * x
        return [] if abs(below) < mp.mpf(10) ** -60 else [m * (x - after) / below]

    return Question(statement, "u", u, "M", roots)


@question
def struck_from_behind(rng: random.Random) -> Question:
    m, k, u, e = magnitude(rng), magnitude(rng), magnitude(rng), coefficient(rng)
    v = u * share(rng)
    impulse = (1 + e) * m * k / (m + k) * (u - v)
    statement = (
        f"sphere A: mass {m}, velocity {u} i\nsphere B: mass {k}, velocity v i\n"
        f"A hits B: along i\ngiven impulse = {impulse}\nfind e"
    )
    m, k, u, v, impulse = map(number, (m, k, u, v, impulse))

    def roots(x: Any) -> list[Any]:
        return [] if x == u else [impulse * (m + k) / (m * k * (u - x)) - 1]

    return Question(statement, "v", v, "e", roots)


@question
def oblique_speed_of_what_is_struck(rng: random.Random) -> Question:
    m, k, u, e = magnitude(rng), magnitude(rng), magnitude(rng), coefficient(rng)
    speed = (1 + e) * m / (m + k) * u * Fraction(4, 5)
    statement = (
        f"sphere A: mass {m}, velocity u at arctan(3/4)\nsphere B: mass {k}, at rest\n"
        f"A hits B: along i\ngiven speed(B) = {speed}\nfind e"
    )
    m, k, u, speed = map(number, (m, k, u, speed))
    return Question(statement, "u", u, "e", lambda x: [speed * (m + k) * 5 / (m * x * 4) - 1])


@cache
def _problem(statement: str) -> Problem:
    return parse(statement)


def expected(asked: Question, x: Any) -> list[Any]:
    """The roots with which the story can happen, at one value of the free letter."""
    problem = _problem(asked.statement)
    physical = []
    for root in asked.roots(x):
        letters = {asked.free: x, asked.sought: root}
        try:
            allowed = all(claims.allowed(*each, problem) for each in letters.items())
            if allowed and physics.World(problem, letters).possible():
                physical.append((root,))
        except physics.ImpossibleWorldError:
            continue
    return physical


def values_of(asked: Question) -> Iterator[Any]:
    """Values of the free letter: that of the motion, many orders away, and both sides of every
    border between those with an answer and those without.
    """
    own = number(asked.value)
    chosen = sorted(
        own * mp.mpf(10) ** power / 7**seventh for power in range(-12, 13) for seventh in (0, 1)
    )
    chosen += [own * factor for factor in (mp.mpf("1.001"), mp.mpf("0.999"), mp.mpf("1.1"), 2)]
    chosen.sort()
    yield from chosen
    counts = [len(expected(asked, x)) for x in chosen]
    for a, b, at_a, at_b in zip(chosen, chosen[1:], counts, counts[1:]):
        if at_a == at_b:
            continue
        low, high = a, b
        for _ in range(70):  # b is at most ten times a: far closer than the steps below
            middle = (low + high) / 2
            if len(expected(asked, middle)) == at_a:
                low = middle
            else:
                high = middle
        for factor in ("1e-9", "1e-15"):
            yield low * (1 - mp.mpf(factor))
            yield low * (1 + mp.mpf(factor))


def answered_with_its_condition(asked: Question) -> None:
    item = solve(parse(asked.statement))[asked.sought]
    assert expected(asked, number(asked.value)), "the test is wrong: the motion is no solution"
    assert item.error is None, f"{asked.statement}\n{item.error!r}"
    for x in values_of(asked):
        wanted, given = expected(asked, x), claims.answered(item, {asked.free: x})
        assert claims.same_sets(wanted, given), (
            f"{asked.statement}\nat {asked.free} = {mp.nstr(x, 25)}: "
            f"{claims.numbers(given)} instead of {claims.numbers(wanted)}; "
            f"answers {[(each.exact, each.condition) for each in item.answers]}"
        )


NAMES = [each.__name__ for each in QUESTIONS]


@pytest.mark.parametrize("n", range(4))
@pytest.mark.parametrize("make", QUESTIONS, ids=NAMES)
def test_an_answer_comes_with_its_condition(make: Maker, n: int) -> None:
    answered_with_its_condition(make(random.Random(f"{make.__name__} {n}")))


@pytest.mark.nightly
@pytest.mark.parametrize("make", QUESTIONS, ids=NAMES)
def test_any_answer_comes_with_its_condition(make: Maker) -> None:
    for _ in range(100):
        seed = f"{make.__name__} {random.SystemRandom().randrange(10**12)}"
        print("seed:", seed)
        answered_with_its_condition(make(random.Random(seed)))


# --- facts that clash ---------------------------------------------------------------------------


@dataclass(frozen=True)
class Clash:
    """A story, and facts about it, of which not all hold in one motion."""

    story: tuple[str, ...]
    facts: tuple[str, ...]
    asked: str = "find e"

    def lines(self) -> list[str]:
        return [*self.story, *self.facts, self.asked]


def clash_at_a_wall(rng: random.Random, letters: bool) -> Clash:
    """Two facts that give different coefficients, among others that any coefficient satisfies."""
    m, a, b = magnitude(rng), magnitude(rng), magnitude(rng)
    e, other = coefficient(rng), coefficient(rng)
    while other == e:
        other = coefficient(rng)
    mass, unit = ("m", "m u") if letters else (str(m), "1")
    down = "u" if letters else str(b)
    size = Fraction(1) if letters else m * b
    energy, energy_unit = (Fraction(1), "m u^2") if letters else (m * b * b, "1")
    speed, speed_unit = (Fraction(1), "u") if letters else (b, "1")
    story = (
        "wall W: along i",
        f"sphere P: mass {mass}, velocity {a} i - {down} j",
        "P hits W",
    )
    facts = {
        "impulse": lambda x: f"given impulse = {(1 + x) * size}*{unit}",
        "energy": lambda x: f"given energy_lost = {(1 - x * x) / 2 * energy}*{energy_unit}",
        "velocity": lambda x: f"given along(velocity(P), j) = {x * speed}*{speed_unit}",
        "coefficient": lambda x: f"given e = {x}",
    }
    first, second = rng.sample(sorted(facts), 2)
    idle = [
        f"given along(velocity(P), i) = {a}",
        "given energy_lost >= 0",
        f"given impulse <= {2 * size}*{unit}",
    ]
    chosen = [facts[first](e), facts[second](other), *rng.sample(idle, rng.randint(0, 3))]
    rng.shuffle(chosen)
    return Clash(story, tuple(chosen), "find speed(P)")


def clash_of_spheres(rng: random.Random, letters: bool) -> Clash:
    """Three facts about e and k: two fix both, the third is of another motion."""
    e, k, other = coefficient(rng), magnitude(rng), coefficient(rng)
    while other == e:
        other = coefficient(rng)
    u = Fraction(1) if letters else magnitude(rng)
    unit = "u" if letters else "1"
    story = (
        f"sphere A: mass 1, velocity {'u' if letters else u} i",
        "sphere B: mass k, at rest",
        "A hits B: along i",
    )
    facts = [
        f"given speed(B) = {(1 + e) / (1 + k) * u}*{unit}",
        f"given along(velocity(A), i) = {(1 - e * k) / (1 + k) * u}*{unit}",
        f"given energy_lost = {k / (1 + k) * (1 - other**2) / 2 * u * u}*{unit}^2",
    ]
    idle = [f"given along(momentum, i) = {u}*{unit}", "given k > 0"]
    facts += rng.sample(idle, rng.randint(0, 2))
    rng.shuffle(facts)
    return Clash(story, tuple(facts), "find e, k")


CLASHES = (clash_at_a_wall, clash_of_spheres)


def error_of(lines: list[str]) -> RestitutionError | None:
    try:
        solution = solve(parse("\n".join(lines)))
    except RestitutionError as error:
        return error
    return next((item.error for _, item in solution.items() if item.error is not None), None)


def named_lines(error: RestitutionError) -> list[int]:
    """The numbers behind "line" and "lines" in a message: "lines 4, 5 and 6"."""
    numbers = []
    for some in re.findall(r"\blines? (\d+(?:(?:, | and |, and )\d+)*)", str(error)):
        numbers += [int(each) for each in re.findall(r"\d+", some)]
    return sorted(set(numbers))


def names_what_clashes(clash: Clash) -> None:
    lines = clash.lines()
    error = error_of(lines)
    statement = "\n".join(lines)
    assert claims.refused(error), f"{statement}\nanswered, or {error!r}"
    assert error is not None
    fact_lines = range(len(clash.story) + 1, len(clash.story) + len(clash.facts) + 1)
    named = [n for n in named_lines(error) if n in fact_lines]
    assert named, f"{statement}\n{error} names none of the facts"
    without = [line for n, line in enumerate(lines, 1) if n not in fact_lines or n in named]
    assert claims.refused(error_of(without)), f"{statement}\nlines {named} do not clash"
    for left_out in named:
        fewer = [
            line
            for n, line in enumerate(without, 1)
            if line != lines[left_out - 1] or n <= len(clash.story)
        ]
        again = error_of(fewer)
        assert not claims.refused(again), (
            f"{statement}\nlines {named} are named, but without {left_out} the others clash too: "
            f"{again}"
        )


@pytest.mark.parametrize("n", range(6))
@pytest.mark.parametrize("letters", [False, True], ids=["numbers", "letters"])
@pytest.mark.parametrize("make", CLASHES, ids=[each.__name__ for each in CLASHES])
def test_a_clash_names_facts_none_of_which_can_be_left_out(
    make: Callable[[random.Random, bool], Clash], letters: bool, n: int
) -> None:
    names_what_clashes(make(random.Random(f"{make.__name__} {letters} {n}"), letters))


@pytest.mark.nightly
@pytest.mark.parametrize("letters", [False, True], ids=["numbers", "letters"])
@pytest.mark.parametrize("make", CLASHES, ids=[each.__name__ for each in CLASHES])
def test_any_clash_names_facts_none_of_which_can_be_left_out(
    make: Callable[[random.Random, bool], Clash], letters: bool
) -> None:
    for _ in range(100):
        seed = f"{make.__name__} {random.SystemRandom().randrange(10**12)}"
        print("seed:", seed)
        names_what_clashes(make(random.Random(seed), letters))


def test_factors_of_long_numbers_are_the_same_each_time() -> None:
    text = """
sphere A: mass 11000000, velocity 78 i
sphere B: mass M, at rest
A hits B: along i
given energy_lost = 131756625000/220000009
find e
"""
    item = solve(parse(text))["e"]
    assert item.error is None
    assert [each.condition for each in item.answers] == [("693000000/3520000081 <= M",)]


SIGNED = "wall W: along i\nsphere P: velocity 3u i - v j\nP hits W: e = 1/2\n{}find v/u"
NOTE = "u and v may have either sign, as components and coordinates may: write 'given u > 0, v > 0'"


@pytest.mark.parametrize(
    ("facts", "noted"),
    [
        ("given deflection(P) = 45°\n", True),
        ("given deflection(P) = 45°, u > 0, v > 0\n", False),
        # No sign splits it: the answer is one.
        ("given velocity(P) parallel to 2i + j\n", False),
    ],
)
def test_a_note_says_how_components_are_positive(facts, noted):
    """3u·v/2 + 3uv over 9u² − v²/2 is 1 where v/u is a root of x² + 9x − 18 or of x² − 9x − 18."""
    solution = solve(parse(SIGNED.format(facts)))
    assert any(each.startswith(NOTE) for each in solution.warnings) is noted
