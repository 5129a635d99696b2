"""Bounds of an angle in degrees that are exceeded in a narrow place alone, beside its maximum."""

from __future__ import annotations

import math
import random

import pytest
import sympy as sp

from restitution.language import parse
from restitution.oracle import Oracle, Relation
from restitution.oracle.roles import ACUTE, COEFFICIENT
from restitution.solving import ItemResult, solve
from restitution.workings import explain, to_text

SPHERES = """sphere A: mass 2m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = {e}
show deflection(A) < {bound}°
"""
WALL = """wall W: along j
sphere P: velocity u at alpha to W
P hits W: e = {e}
let beta = angle(velocity(P), W)
show alpha - beta <= {bound}°
"""


def only(text: str) -> ItemResult:
    ((_, item),) = solve(parse(text)).items()
    return item


@pytest.mark.parametrize("seed", range(3))
def test_a_bound_below_the_maximum_is_refuted_and_one_above_it_shown(seed: int) -> None:
    """What is along one line becomes k of it: the path turns by arcsin((1 − k)/(1 + k)) at most."""
    rng = random.Random(seed)
    text, e = rng.choice((SPHERES, WALL)), sp.Rational(rng.randint(3, 17), 20)
    k = (1 - e) / 2 if text == SPHERES else e
    most = math.degrees(math.asin((1 - k) / (1 + k)))
    digits = rng.choice((1, 2, 3))
    below, above = (f(most * 10**digits) / 10**digits for f in (math.floor, math.ceil))
    item = only(text.format(e=e, bound=below))
    assert item.holds is False
    assert item.counterexample is not None
    alpha = float(sp.sympify(item.counterexample["alpha"]))
    turned = (
        math.atan(math.tan(alpha) / k) - alpha
        if text == SPHERES
        else alpha - math.atan(k * math.tan(alpha))
    )
    assert below < math.degrees(turned) <= most + 1e-12
    assert only(text.format(e=e, bound=above)).holds is True


def test_the_maximum_over_two_letters_is_at_an_end_of_one() -> None:
    text = SPHERES.format(e="e", bound="25.376").replace("show", "given e <= 1/5\nshow")
    item = only(text)  # arcsin(3/7) = 25.3769…°
    assert item.counterexample is not None
    assert item.counterexample["e"] == "1/5"


def test_a_path_that_may_be_along_a_wall_is_tried_there() -> None:
    text = """wall F: along j, through (5, 0)
wall V: along i, through (0, -9)
sphere P: at (0, 0), velocity 3u cos(theta) i - 3u sin(theta) j
P hits F: e = 1
given 0 <= theta < 35°
show theta > 0°"""
    assert only(text).counterexample == {"theta": "0"}


def test_what_does_not_fail_anywhere_stays_so() -> None:
    """cos α sin α is at most ½: of a bound that it does not come to nothing is refuted."""
    alpha, e = ACUTE.symbol("alpha"), COEFFICIENT.symbol("e")
    oracle = Oracle({"alpha": ACUTE, "e": COEFFICIENT})
    turn = e * sp.sin(alpha) * sp.cos(alpha)
    assert oracle.decide(Relation(sp.sin(sp.pi * 301 / 1800) - turn, ">")).answer != "refuted"
    verdict = oracle.decide(Relation(sp.sin(sp.pi * 299 / 1800) - turn, ">"))
    assert verdict.answer == "refuted"
    assert verdict.witness is not None
    assert float(verdict.witness["e"]) * math.sin(2 * float(verdict.witness["alpha"])) > 0.996


@pytest.mark.parametrize(
    ("bound", "end"),
    [
        ("27.03", "δ ≈ 27.032°, which is more than 27.03°"),
        ("10", "≈ 24.4°, which is more than 10°"),
    ],
)
def test_an_angle_has_as_many_figures_as_tell_it_from_a_bound(bound: str, end: str) -> None:
    """The greatest deflection is arcsin(5/11) = 27.0356…°."""
    text = to_text(explain(solve(parse(SPHERES.format(e="1/4", bound=bound)))), 80)
    assert end in " ".join(text.split())
