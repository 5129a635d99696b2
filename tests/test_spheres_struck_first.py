"""No sphere is struck before the impact that is told, in letters as in numbers.

Ranges were worked out by hand from the times at which spheres meet.
"""

from __future__ import annotations

import random

import pytest
import sympy

import restitution
from restitution.errors import ImpossibleError

BETWEEN_WALLS = """wall W: along j, through (20, 0)
wall V: along j, through (-20, 0)
sphere A: mass 1, at (0, 0), velocity 2i{size}
sphere B: mass 2, at ({start}, 0), at rest
A hits B: e = {e}
B hits W: e = 1
A hits V: e = 1
"""
IN_THE_WAY = """sphere A: mass 1, at (0, 0), velocity 2i{size}
sphere C: mass 1, at (20, 0), at rest
sphere B: mass 1, at (6, {b}), velocity {w}j
A hits C: e = 1
"""
TOWARDS = """sphere A: mass 1, at (0, 0), velocity 2i
sphere C: mass 1, at (10, 0), at rest
sphere B: mass 1, at (20, 0), velocity -{v} i
A hits C: e = 1
"""

Case = tuple[str, str, sympy.Set]
ROOT = sympy.sqrt(5)
CASES: list[Case] = [
    # B comes back from W, and is at x = −20 after A.
    (
        BETWEEN_WALLS.format(size="", start=3, e="{x}"),
        "e1",
        sympy.Interval(sympy.Rational(80, 91), 1),
    ),
    (
        BETWEEN_WALLS.format(size=", radius 1", start=5, e="{x}"),
        "e1",
        sympy.Interval(sympy.Rational(12, 13), 1),
    ),
    # The path relative to B passes it at a distance of at least two radii.
    (
        IN_THE_WAY.format(size=", radius 1", b="{x}", w=""),
        "b",
        sympy.Union(sympy.Interval(-sympy.oo, -3 - ROOT), sympy.Interval(-3 + ROOT, sympy.oo)),
    ),
    (IN_THE_WAY.format(size="", b="{x}", w="-"), "b", sympy.Complement(sympy.Reals, {3})),
    (TOWARDS.format(v="{x}"), "v", sympy.Interval.Lopen(0, 2)),
]


def is_possible(text: str) -> bool:
    """Whether a statement in numbers is solved; else a sphere is struck first."""
    (part,) = restitution.solve(restitution.parse(text)).parts.values()
    error = part.items[0].error
    assert error is None or (isinstance(error, ImpossibleError) and "first" in str(error))
    return error is None


IDS = ["back", "back_with_radius", "beside_with_radius", "beside", "towards"]


@pytest.mark.parametrize(("text", "letter", "expected"), CASES, ids=IDS)
def test_a_range_is_where_numbers_are_possible(text: str, letter: str, expected: sympy.Set) -> None:
    statement = text.format(x=letter) + f"find range of {letter}\n"
    (part,) = restitution.solve(restitution.parse(statement)).parts.values()
    assert part.items[0].answers[0].value == expected
    rng = random.Random(letter + text)
    for _ in range(3):
        drawn = sympy.Rational(rng.randint(1, 99), 100)
        if letter == "e1":
            drawn = sympy.Rational(3, 4) + drawn / 4
        elif letter == "b":
            drawn = 16 * drawn - 8
        else:
            drawn = 4 * drawn
        possible = is_possible(text.format(x=f"({drawn})") + "find time(1)\n")
        assert possible == (drawn in expected), (letter, drawn)


def test_spheres_that_have_met_may_meet_again_first() -> None:
    text = """sphere A, B: mass 1
sphere A: at (0, 0), velocity 2i
sphere B: at (3, 0), at rest
wall W: along j, through (7, 0)
A hits B: e = 1/2
B hits W: e = 1
A hits {}: e = 1
find time(3)
"""
    assert not is_possible(text.format("W"))
    solution = restitution.solve(restitution.parse(text.format("B")))
    assert str(solution) == "time(3) = 11/2"


def test_events_of_different_bodies_may_come_in_another_order() -> None:
    text = """wall W: along j, through (10, 0)
wall U: along j, through (0, 0)
sphere P: mass 1, at (1, 5), velocity {v} i
sphere Q: mass 1, at (5, -5), velocity -i
P hits W: e = 1
Q hits U: e = 1
"""
    numbers = restitution.solve(restitution.parse(text.format(v=1) + "find time(1)\n"))
    assert str(numbers) == "time(1) = 9"
    assert "in the order of time" in numbers.warnings[0]
    letters = (
        text.format(v="v") + "find range of v\npart b\ngiven time(1) <= time(2)\nfind range of v"
    )
    solution = restitution.solve(restitution.parse(letters))
    assert str(solution) == "range of v = v > 0\n(b) range of v = v ≥ 9/5 (v ≥ 1.80)"
