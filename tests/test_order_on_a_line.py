"""Spheres on one line pass neither each other nor a wall: who met stay next to each other."""

from __future__ import annotations

import pytest

import restitution
from restitution.errors import ImpossibleError

MIDDLE = """sphere A: mass 3m, at rest
sphere B: mass m, velocity -u i
sphere C: mass 3m, at rest
B hits C: along i
B hits A: along i
"""
WALLS = """wall V, W: along j
sphere A: mass m, velocity u i
sphere B: mass k m, velocity -u i
A hits B: along i, e = 1/2
A hits V
B hits W
"""


@pytest.mark.parametrize(
    ("text", "letter", "expected"),
    [(MIDDLE, "e", "⅓ < e ≤ 1"), (WALLS, "k", "½ < k < 2")],
    ids=["two spheres", "two walls"],
)
def test_a_body_meets_another_one_on_the_side_on_which_it_met_nobody(
    text: str, letter: str, expected: str
) -> None:
    solution = restitution.solve(restitution.parse(f"{text}find range of {letter}\n"))
    assert str(solution) == f"range of {letter} = {expected}"


@pytest.mark.parametrize(
    ("events", "who"),
    [
        ("A hits B: along i\nB hits C: along i\nA hits C: along i", "B, which A has met"),
        ("C hits B: along i\nB hits A: along i\nB hits W", "C, which B has met"),
    ],
)
def test_what_is_between_two_bodies_keeps_them_apart(events: str, who: str) -> None:
    text = f"""wall W: along j
sphere A: mass 2, velocity 5i
sphere B: mass 3, at rest
sphere C: mass 1, velocity -7i
{events}
find velocity(A)
"""
    (part,) = restitution.solve(restitution.parse(text)).parts.values()
    error = part.items[0].error
    assert isinstance(error, ImpossibleError)
    assert error.message.startswith(f"{who}, would be between")


def test_off_the_line_there_is_no_order() -> None:
    text = MIDDLE.replace("-u i", "u i + u j").replace("along i", "along i, e = 1/4")
    solution = restitution.solve(restitution.parse(f"{text}find velocity(B)\n"))
    assert str(solution) == "velocity(B) = (u/256)𝐢 + u𝐣"


def test_the_order_is_the_sense_of_an_approach_in_a_working() -> None:
    solution = restitution.solve(restitution.parse(f"{MIDDLE}show e > 1/3\n"))
    working = " ".join(str(restitution.explain(solution)).split())
    assert "approach each other before the second impact" in working
    assert "not written out" not in working


def test_an_order_holds_after_other_impacts_too() -> None:
    solution = restitution.solve(restitution.parse(f"{WALLS}show k < 2\n"))
    working = " ".join(str(restitution.explain(solution)).split())
    assert "B moves towards W before the third impact" in working


def test_nothing_is_taken_away_in_what_two_components_differ_by() -> None:
    text = """wall W: along j
sphere A: mass m, velocity -u i
sphere B: mass 2m, at rest
A hits B: along i
A hits W: e = f
show A and B do not collide again
"""
    working = " ".join(str(restitution.explain(restitution.solve(restitution.parse(text)))).split())
    assert "= u(1 + e(1 − f) + f(1 − e))/3" in working
    assert "as 0 ≤ e ≤ 1 and 0 ≤ f ≤ 1" in working
