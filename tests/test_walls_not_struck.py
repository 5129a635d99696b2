"""Walls that a story does not speak of, where a body may move parallel to one, or stay at rest.

Such a body never comes there: the value of a letter at which it is so is one of those allowed.
"""

from __future__ import annotations

import random

import pytest
import sympy as sp

from restitution.errors import ImpossibleError
from restitution.language import parse
from restitution.solving import ItemResult, solve

PAST = """wall W: along j, through (10, 0)
wall V: {wall}
sphere P: at (0, 0), velocity 2i + {q} j
P hits W: e = 1
"""


def only(text: str) -> ItemResult:
    ((_, item),) = solve(parse(text)).items()
    return item


def _walls(seed: int) -> tuple[str, sp.Rational]:
    """A wall, or a part of one, beside the path, and the q at which P moves parallel to it."""
    rng = random.Random(seed)
    a, b = rng.choice((1, 2, 4)), rng.randint(-5, 5)
    x, y = rng.randint(1, 6), rng.choice((-1, 1)) * rng.randint(12, 20)
    if rng.random() < 0.5:
        return f"along {a}i + {b}j, through ({x}, {y})", sp.Rational(2 * b, a)
    return f"from ({x - a}, {y - b}) to ({x + a}, {y + b})", sp.Rational(2 * b, a)


@pytest.mark.parametrize("seed", range(3))
def test_letters_and_numbers_agree(seed: int) -> None:
    wall, parallel = _walls(seed)
    range_of_q = only(PAST.format(wall=wall, q="q") + "find range of q").answers[0].value
    assert isinstance(range_of_q, sp.Set)
    rng = random.Random(seed)
    draws = [sp.Rational(rng.randint(-40, 40), 8) for _ in range(4)]
    for q in (parallel, parallel - 1, parallel + 1, *draws):
        error = only(PAST.format(wall=wall, q=f"({q})") + "find velocity(P)").error
        assert error is None or isinstance(error, ImpossibleError)
        assert range_of_q.contains(q) == sp.S(error is None)


@pytest.mark.parametrize("seed", range(3))
def test_no_claim_is_shown_that_is_false_of_a_parallel_path(seed: int) -> None:
    wall, parallel = _walls(seed)
    given = f"given q >= {parallel}\n"
    claim = only(PAST.format(wall=wall, q="q") + f"{given}show q > {parallel}")
    assert claim.holds is False
    assert sp.sympify(claim.counterexample["q"]) == parallel
    assert only(PAST.format(wall=wall, q="q") + f"{given}show q >= {parallel}").holds is True


@pytest.mark.parametrize(
    ("bodies", "events", "claim", "refuted_at"),
    [
        # A rests after the blow where B comes back to it: 3 = 2e₁ × 3/2.
        (
            "sphere A: mass 3, at (0, 0), velocity 2i\nsphere B: mass 6, at (1, 0), at rest",
            "A hits B: e = e1\nB hits W: e = 1\nA hits B: e = 1\ngiven e1 <= 1/2",
            "e1 < 1/2",
            {"e_1": "1/2"},
        ),
        # B may be at rest before; nothing else happens.
        (
            "sphere A: mass 1, at (0, 0), velocity 2i\nsphere B: mass 2, at (4, 0), velocity -q i",
            "A hits B: e = 1/2\ngiven q >= 0",
            "q > 0",
            {"q": "0"},
        ),
        # With e = 0 it slides along the floor.
        (
            """wall F: along i, through (0, 0)
wall C: along i, through (0, 40)
sphere P: at (-2, 4), velocity i - 2j""",
            "P hits F\nP hits W: e = 1/2",
            "speed(P) > 1/2",
            {"e": "0"},
        ),
    ],
    ids=["after a blow", "from the start", "beside a floor"],
)
def test_a_body_that_may_be_at_rest(
    bodies: str, events: str, claim: str, refuted_at: dict[str, str]
) -> None:
    text = f"wall W: along j, through (12, 0)\n{bodies}\n{events}\n"
    item = only(f"{text}show {claim}")
    assert item.holds is False
    assert item.counterexample == refuted_at


def test_a_range_of_a_time_has_both_its_ends() -> None:
    """B rests at 4 with e = 1, and C comes there; with e = 0 it has moved on by then."""
    item = only(
        """wall W: along j, through (30, 0)
sphere A, B: mass 2
sphere B: at (0, 0), velocity 4i
sphere A: at (4, 0), at rest
sphere C: mass 2, at (-8, 0), velocity 6i
B hits A
C hits B: e = 1
find range of time(2)"""
    )
    assert item.answers[0].value == sp.Interval(2, sp.Rational(5, 2))
    assert item.proof != "undecided"


def test_a_range_of_a_distance_from_where_spheres_meet_again() -> None:
    """A keeps (1 − e) of 3, B has (1 + e); B comes back with e of it, from 10, and meets A at x."""
    item = only(
        """point O: (0, 0)
wall W: along j, through (10, 0)
sphere A, B: mass 3
sphere A: at (0, 0), velocity 6i
sphere B: at (4, 0), at rest
A hits B
B hits W
A hits B
find range of distance(A, O)"""
    )
    # x = 10 − 12e²/(1 + e²): with e = 1, A rests at 4; with e = 0, both are at W in one instant.
    assert item.answers[0].value == sp.Interval(4, 10)
