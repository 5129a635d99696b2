"""Questions in which the line of centres has to be found, by level."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from restitution.practice.questions.dice import Dice, Recipe
from restitution.practice.questions.nice import (
    lines_of,
    number,
    pair,
    ratio,
    slanted,
    times,
    vector,
)


def _one_velocity_given(d: Dice, *asked: str) -> str:
    """The velocity of one sphere after the collision, of which the line of centres follows."""
    c = slanted(d, at_rest=d.below(3) == 0, denominators=1)
    second = f"velocity {vector(*c.u2)}" if any(c.u2) else "at rest"
    return lines_of(
        f"sphere A: mass {number(c.m1)}, velocity {vector(*c.u1)}",
        f"sphere B: mass {number(c.m2)}, {second}",
        "A hits B",
        f"given velocity(A) = {vector(*c.v1)}",
        *asked,
    )


def _line_1(d: Dice) -> str:
    return _one_velocity_given(d, "part a", "find velocity(B)", "part b", "find line_of_centres")


def _line_2(d: Dice) -> str:
    return _one_velocity_given(d, "part a", "find line_of_centres", "part b", "find velocity(B), e")


def _line_3(d: Dice) -> str:
    """Centres on parallel paths: the line of centres makes arcsin(d/2r) with them."""
    across, whole = d.of(((3, 5), (4, 5), (5, 13), (12, 13)))
    share = Fraction(2 * across, whole)
    offset = f"{float(share):g} r" if whole == 5 else f"{share} r"
    while True:
        c = pair(d, at_rest=True)
        if c.m1.denominator == c.m2.denominator == 1:
            break
    both_moving = d.below(3) > 0
    second = f"velocity {vector(-d.between(1, 5), 0, 'u')}" if both_moving else "at rest"
    first = vector(d.between(1, 5), 0, "u")
    angles = ("find deflection(A)", "find angle(velocity(A), line_of_centres), speed(A)")
    return lines_of(
        f"sphere A: mass {times(c.m1, 'm')}, velocity {first}, radius r",
        f"sphere B: mass {times(c.m2, 'm')}, {second}, radius r",
        f"A hits B: offset {offset}, e = {ratio(c.e)}",
        "part a",
        d.of(("find impulse", "find energy_lost")),
        "part b",
        d.of(("find speed(A)", "find speed(B)", "find speed(A), speed(B)", *angles)),
    )


def _line_4(d: Dice) -> str:
    last = d.of(("find energy_lost", "find deflection(A), energy_lost", "find deflection(B)"))
    return _one_velocity_given(
        d, "part a", "find line_of_centres", "part b", "find velocity(B), e", "part c", last
    )


RECIPES: Mapping[tuple[str, int], tuple[Recipe, ...]] = {
    ("line-of-centres", 1): (_line_1,),
    ("line-of-centres", 2): (_line_2,),
    ("line-of-centres", 3): (_line_3,),
    ("line-of-centres", 4): (_line_4,),
}
