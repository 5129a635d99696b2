"""Answers in letters of acute angles: no bars around what is positive, conditions in the angles."""

from __future__ import annotations

from fractions import Fraction

import pytest
import sympy as sp

from restitution.errors import RestitutionError
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

TWO_ANGLES = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given angle(velocity(P), W) = beta
find speed(P)
"""
RATIO_BY_ITS_LETTER = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
let beta = angle(velocity(P), W)
given tan(alpha) = 3 tan(beta)
find e
"""
AT_REST = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass M, velocity -i + j
A hits B
given A at rest
find line_of_centres
"""
NO_LINE = """
sphere A: mass m, velocity u i
sphere B: mass 4m, at rest
wall W: along j
A hits B
B hits W: e = 1/2
given A and B collide again
find range of e
"""

LINE_UNKNOWN = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along theta
given velocity(A) = 1/2 u i
find theta, e
"""


def printed(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text))), 100).split())


def test_the_cosine_of_an_acute_angle_has_no_bars() -> None:
    ((_, item),) = solve(parse(TWO_ANGLES)).items()
    (answer,) = item.answers
    assert answer.display == "(u cos α)/cos β, for α ≥ β and β < 90°"
    assert "= (u cos α)/cos β, as sin² + cos² = 1" in printed(TWO_ANGLES)


def test_a_range_has_no_bars_around_a_sine() -> None:
    text = TWO_ANGLES.split("given")[0] + "given speed(P) <= 1/2 u\nfind range of e"
    ((_, item),) = solve(parse(text)).items()
    assert item.answers[0].display == "0 ≤ e ≤ √(1 − 4 cos²α)/(2 sin α), for α ≥ 60°"


def test_a_ratio_of_tangents_is_read_by_the_letter_of_an_angle() -> None:
    working = printed(RATIO_BY_ITS_LETTER)
    assert "tan β = eu sin α/(u cos α) = e tan α" in working
    assert "Since tan α = 3 tan β: tan α = 3e tan α" in working
    assert "Let θ" not in working


def test_where_the_tangent_has_no_value_an_angle_is_not_acute() -> None:
    # At α = 60° the change of velocity is along j: the line of centres is at 90° then.
    theta, e = (item.answers[0].display for _, item in solve(parse(LINE_UNKNOWN)).items())
    assert theta == "arctan(2 sin α/(2 cos α − 1)), for α < 60°"
    assert e == "3(1 − cos α)/(2 − cos α), for α < 60°"


def test_a_sphere_at_rest_is_not_called_moving() -> None:
    working = printed(AT_REST)
    assert "As e = (M + 50)/(24M) ≤ 1, this holds for M ≥ 50/23 only." in working


def test_a_second_collision_needs_the_line_of_centres() -> None:
    with pytest.raises(RestitutionError, match=r"needs the line of centres of A and B \(write"):
        raise_error_of(NO_LINE)


def test_a_second_collision_needs_the_line_of_an_impact_between() -> None:
    text = """
    sphere A: mass 2m, velocity u i
    sphere B: mass m, at rest
    sphere C: mass 4m, at rest
    A hits B: along i
    B hits C
    given A and B collide again
    find range of e
    """
    with pytest.raises(RestitutionError, match=r"needs the line of centres of B and C \(write"):
        raise_error_of(text)


def raise_error_of(text: str) -> None:
    ((_, item),) = solve(parse(text)).items()
    if item.error is not None:
        raise item.error


@pytest.mark.parametrize(
    ("fact", "angle"),
    [
        ("impulse = 1/4 m u", "arccos((1 + k)/(4(1 + e)k))"),
        # The equation for the squares holds for ek > 1 too.
        ("along(velocity(A), i) = 1/2 speed(A)", "arctan(√3(1 − ek)/(1 + k)), for ek < 1"),
    ],
)
def test_an_angle_is_that_of_the_plainest_of_its_ratios(fact: str, angle: str) -> None:
    text = f"""
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given {fact}
find alpha
"""
    ((_, item),) = solve(parse(text)).items()
    assert item.answers[0].display.startswith(angle)
    assert f"α = {angle.partition(',')[0]} A1" in printed(text)


@pytest.mark.parametrize(
    ("e", "angle"), [("e", "2 arctan(e/tan α)"), ("1/2", "2 arctan(1/(2 tan α))")]
)
def test_an_angle_with_an_axis_of_symmetry_is_twice_another(e: str, angle: str) -> None:
    """A leaves with -eu cos α along the line of centres, B with eu cos α, and both with u sin α."""
    text = "sphere A: mass m, velocity u at alpha\nsphere B: mass m, velocity u at 180° - alpha\n"
    solution = solve(
        parse(f"{text}A hits B: along i, e = {e}\nfind angle(velocity(A), velocity(B))")
    )
    assert solution["angle(velocity(A), velocity(B))"].display == angle


def test_a_factor_that_surds_show_is_no_condition() -> None:
    """Along the line A has v/tan(60° + angle of v): nothing happens at |v| = (√11 − √3)|u|/4."""
    text = "sphere A: mass m, velocity u i + v j\nsphere B: mass M, at rest\n"
    text += "A hits B: along i, e = 1/2\ngiven deflection(A) = 60°\nfind M"
    (answer,) = solve(parse(text))["M"].answers
    assert answer.display.startswith("2m(u² + v²)/(u² − 2v² + √3 |u||v|), for ")
    assert answer.display.count("<") == 4


def test_an_acute_angle_by_its_cosine_has_that_cosine() -> None:
    statement = (
        "sphere A: mass 2m, velocity 3u at theta\nsphere B: mass 3m, velocity -u i\n"
        "A hits B: along i\ngiven angle(velocity(A), i) = 45°\nfind theta\n"
    )
    (item,) = solve(parse(statement)).parts[None].items
    (answer,) = item.distinct
    (letter,) = answer.value.free_symbols
    for e in (Fraction(1, 10), Fraction(1, 5)):
        theta = answer.value.subs(letter, sp.Rational(e)).evalf(40)
        left = (2 - 3 * e) * sp.cos(theta) - 5 * sp.sin(theta)
        assert abs(left - (1 + e)) < 1e-30


def test_what_an_acute_angle_alone_makes_impossible_says_so() -> None:
    text = """
wall W: along phi
sphere Q: mass 3, velocity 3i - 5j
Q hits W
given impulse(Q) = 3i + 18j
find tan(phi)
"""
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "For an acute φ, the other data make it impossible" in shown
