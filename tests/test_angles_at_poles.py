"""Angles at values of a letter for which they have no tangent: 90° to a line, and 180°."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution import explain
from restitution.language import parse
from restitution.solving import solve

RIGHT = sp.pi / 2

WALL = """
    wall W: along i
    sphere P: velocity {velocity}
    P hits W: e = {e}
    given {given}
    """
SPHERES = """
    sphere A: mass m, velocity u at {angle}
    sphere B: mass 2m, at rest
    A hits B: along i
    """


@pytest.mark.parametrize(
    ("text", "values"),
    [
        # The velocity after is (u cos α, u sin α/2), which is at 90° to the wall where α is.
        (
            WALL.format(velocity="u at alpha to W", e="1/2", given="30° <= alpha <= 120°")
            + "find range of angle(velocity(P), W)",
            sp.Interval(sp.atan(sp.sqrt(3) / 6), RIGHT),
        ),
        # Here u cos α < 0 for every α, and the angle is that to −i.
        (
            WALL.format(velocity="u at alpha to W", e="1", given="90° < alpha <= 150°")
            + "find range of angle(velocity(P), W)",
            sp.Interval.Ropen(sp.pi / 6, RIGHT),
        ),
        # It is turned by 180° where it comes along the normal, whatever e > 0 is.
        (
            WALL.format(velocity="u at -alpha", e="1/2", given="0 < alpha < 180°")
            + "find range of deflection(P)",
            sp.Interval.Lopen(0, sp.pi),
        ),
        # v = (1 − 2e)u cos 45°/3 is 0 for e = ½, when A moves at right angles to the line.
        (
            SPHERES.format(angle="45°") + "find range of angle(velocity(A), line_of_centres)",
            sp.Interval(sp.atan(3), RIGHT),
        ),
        # The pole is in one of two letters.
        (
            SPHERES.format(angle="alpha") + "find range of angle(velocity(A), line_of_centres) in "
            "terms of u",
            sp.Interval.Lopen(0, RIGHT),
        ),
        # e = ½ is left out, and so is the right angle.
        (
            SPHERES.format(angle="45°")
            + "given e > 1/2\nfind range of angle(velocity(A), line_of_centres)",
            sp.Interval.Ropen(sp.atan(3), RIGHT),
        ),
    ],
    ids=["wall", "obtuse", "straight back", "line of centres", "two letters", "left out"],
)
def test_a_range_has_the_right_angle_and_180_where_they_are_reached(
    text: str, values: sp.Set
) -> None:
    result = solve(parse(text)).parts[None].items[0]
    assert [answer.value for answer in result.answers] == [values]
    assert result.proof != "undecided"


@pytest.mark.parametrize(
    ("text", "value", "place", "reached"),
    [
        # 2j after −4j.
        (
            WALL.format(velocity="p i - 4j", e="1/2", given="-5 < p < 5")
            + "find maximum of deflection(P) over p",
            sp.pi,
            "p = 0",
            True,
        ),
        (
            WALL.format(velocity="p i - 4j", e="1/2", given="p > 0")
            + "find maximum of deflection(P) over p",
            sp.pi,
            "p → 0",
            False,
        ),
        (
            SPHERES.format(angle="45°")
            + "find maximum of angle(velocity(A), line_of_centres) over e",
            RIGHT,
            "e = ½",
            True,
        ),
        # v = (u cos 60° − 3u cos α)/4 along the line is 0 where cos α is 1/6.
        (
            """
            sphere A, B: mass m
            sphere A: velocity u at 60°
            sphere B: velocity u at alpha from -i
            A hits B: along i, e = 1/2
            find maximum of angle(velocity(A), line_of_centres) over alpha
            """,
            RIGHT,
            "α = arccos(1/6)",
            True,
        ),
        (
            WALL.format(velocity="u at alpha to W", e="1/2", given="0 < alpha < 180°")
            + "find minimum of angle(velocity(P), W) over alpha",
            sp.Integer(0),
            "α → 0°",
            False,
        ),
    ],
    ids=["straight back", "approached", "line of centres", "two spheres", "least"],
)
def test_an_extremum_at_a_pole_is_reached(
    text: str, value: sp.Expr, place: str, reached: bool
) -> None:
    solved = solve(parse(text))
    result = solved.parts[None].items[0]
    (answer,) = result.answers
    assert (answer.value, answer.reached) == (value, reached)
    assert place in str(solved)


def test_the_working_says_where_the_angle_to_a_wall_has_no_tangent() -> None:
    text = WALL.format(velocity="u at alpha", e="1/2", given="-90° < alpha < 90°").replace(
        "along i", "along j"
    )
    assert "β = 90° if α = 0°" in str(explain(solve(parse(text + "find angle(velocity(P), W)"))))
