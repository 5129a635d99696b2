"""Sines and cosines of whole degrees stay as they are, and are what they were."""

from __future__ import annotations

import math
import pickle
from fractions import Fraction

import pytest
import sympy as sp

from restitution import exact
from restitution.exact import degrees
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import is_function, walk
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text


@pytest.mark.parametrize("whole", range(-360, 721, 7))
def test_they_have_their_values(whole: int) -> None:
    turns = Fraction(whole, 180)
    angle = math.radians(whole)
    assert float(degrees.cosine(turns)) == pytest.approx(math.cos(angle))
    assert float(degrees.sine(turns)) == pytest.approx(math.sin(angle))
    if abs(math.cos(angle)) > 1e-9:
        radians = sp.Rational(whole, 180) * sp.pi
        assert float(degrees.tangent(radians)) == pytest.approx(math.tan(angle))


@pytest.mark.parametrize("whole", [3, 18, 36, 42, 48, 54, 63, 72, 87])
def test_they_are_no_roots_of_roots(whole: int) -> None:
    cosine = degrees.cosine(Fraction(whole, 180))
    for form in (cosine, exact.tidy(3 * cosine / 2 + 1), sp.cancel(cosine), sp.radsimp(1 / cosine)):
        assert not form.has(sp.sqrt(5))
        assert form.has(sp.cos)
    assert pickle.loads(pickle.dumps(cosine)) == cosine


@pytest.mark.parametrize(("whole", "value"), [(60, "1/2"), (45, "sqrt(2)/2"), (90, "0")])
def test_standard_angles_have_surds(whole: int, value: str) -> None:
    assert str(degrees.cosine(Fraction(whole, 180))) == value


def test_equal_numbers_are_proved_equal() -> None:
    """cos 36° − cos 72° = ½, and sin 42° = cos 48°."""
    one, other = (degrees.cosine(Fraction(n, 180)) for n in (36, 72))
    assert exact.is_zero(one - other - sp.Rational(1, 2))
    assert exact.is_zero(degrees.sine(Fraction(42, 180)) - degrees.cosine(Fraction(48, 180)))


@pytest.mark.parametrize("angle", [33, 42, 35])
def test_a_working_at_whole_degrees(angle: int) -> None:
    text = (
        f"sphere A: mass 0.6, velocity 3.5 at {angle}°\nsphere B: mass 0.45, at rest\n"
        "A hits B: along i\ngiven speed(B) = 2.4\nfind e, speed(A)"
    )
    shown = " ".join(to_text(explain(solve(parse(text))), 80).split())
    e = 2.4 / (2 * math.cos(math.radians(angle))) - 1
    assert f"e ≈ {e:.3f} A1" in shown
    v = 3.5 * math.cos(math.radians(angle)) - 1.8
    assert f"v ≈ {v:#.4g} m s⁻¹" in shown
    assert "√5" not in shown


@pytest.mark.parametrize("whole", [4, 10, 36, 42, 50, 77])
def test_an_arctangent_of_a_plain_angle_is_that_angle(whole: int) -> None:
    turns = Fraction(whole, 180)
    cosine, sine = degrees.cosine(turns), degrees.sine(turns)
    angle = sp.Rational(whole, 180) * sp.pi
    assert exact.tidy_angle(sp.atan(sine / cosine)) == angle
    assert exact.tidy_angle(sp.atan(cosine / sine)) == sp.pi / 2 - angle
    assert exact.tidy_angle(-sp.atan(cosine / sine)) == angle - sp.pi / 2
    assert not (exact.tidy_angle(sp.atan(sine / (2 * cosine))) / sp.pi).is_Rational


def test_angles_of_paths_at_whole_degrees_are_read_off() -> None:
    text = (
        "wall AB: along i\nwall BC: along 150°\nsphere P: velocity u at 50° to AB\n"
        "P hits AB: e = 1\nP hits BC: e = 1\n"
        "find angle(velocity(P), BC), deflection(P, 1), deflection(P, 2)"
    )
    shown = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert "arctan" not in shown
    assert "angle between 𝐯₁ and BC = 30° + 50° = 80°" in shown
    assert "(i) angle between 𝐯₂ and BC = 80°" in shown


@pytest.mark.parametrize("angle", [36, 48])
def test_a_tangent_of_components_has_no_roots_of_roots(angle: int) -> None:
    problem = parse(
        f"sphere A: mass 1, velocity 6 at 25°\nsphere B: mass 2, velocity 4 at 180° - {angle}°\n"
        "A hits B: along i, e = 0.3\nfind deflection(A), deflection(B)"
    )
    derivation = plan(solve(problem))
    trees = [tree for line in derivation.lines for tree in trees_of(line.relation)]
    assert not any(is_function(node, "sqrt") for tree in trees for node in walk(tree))
    assert not follow(derivation, Oracle(roles(problem)))


def test_numbers_with_angles_that_are_no_parts_of_a_turn_are_merged_beside_roots() -> None:
    angle = sp.atan(2)
    value = sp.sqrt(5) * sp.sin(angle, evaluate=False) / 20 - sp.Rational(1, 10)
    assert exact.tidy(value) == 0


@pytest.mark.parametrize(
    ("first", "then", "speed"),
    [("75°", "45°", "(√3 − 1)u/2"), ("15°", "30°", "(√6 + 3√2)u/6")],
)
def test_roots_of_fifteen_degrees_go_together_with_others(
    first: str, then: str, speed: str
) -> None:
    text = (
        f"wall W: along i\nsphere P: mass m, velocity u at {first} to W\nP hits W: e = 1/2\n"
        f"sphere Q: mass m, velocity u at {first} to W\nQ hits W\n"
        f"given angle(velocity(Q), W) = {then}\nfind speed(Q)"
    )
    ((answer,),) = (item.answers for item in solve(parse(text)).parts[None].items)
    assert speed in answer.display
