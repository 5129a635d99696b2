"""Angles that are made of two others: greatest values, inequalities, tangents to parallel walls."""

from __future__ import annotations

import pytest
from workings import printed_with

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles

WALL = """
wall W: along j
sphere P: velocity V at theta to W
P hits W: e = 1/4
"""
SPHERES = """
sphere A: mass {0}, velocity u at alpha
sphere B: mass {1}, at rest
A hits B: along i, e = {2}
"""


def working(text: str) -> Derivation:
    """The working of a statement, which the follower accepts."""
    problem = parse(text)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    return derivation


def answers(derivation: Derivation) -> list[str]:
    """The answers as lines say them."""
    return [write_relation(each.answer) for each in derivation.items]


def said(derivation: Derivation) -> list[str]:
    """The lines that are shown, without letters that are introduced."""
    return [
        write_relation(each.relation)
        for each in derivation.lines
        if isinstance(each.relation, Relation) and each.shown != "silent"
    ]


def test_the_greatest_difference_of_two_angles() -> None:
    derivation = working(f"{WALL}find maximum of theta - angle(velocity(P), W) over theta")
    assert answers(derivation) == ["delta <= arctan(3/4)"]
    assert "S >= 4" in said(derivation)


def test_the_greatest_difference_with_an_angle_that_is_acute_as_a_letter_is_bounded() -> None:
    derivation = working(
        f"{SPHERES.format('m', 'm', 'e')}given e < 1\nlet psi = angle(velocity(A), i)\n"
        "find maximum of psi - alpha over alpha"
    )
    assert answers(derivation) == ["delta <= arctan(sqrt(2) (1 + e)/(4sqrt(1 - e)))"]
    assert "tan(delta) > 0" in said(derivation)


@pytest.mark.parametrize(
    ("impulse", "deflection", "parts"),
    [
        (
            "m u",
            60,
            (
                "α + β = 60°",
                "(1 + sin α)/cos α = √3",
                "(1 + sin α)² = 3 cos²α",
                "3(1 − sin²α) = (1 + sin α)²",
                "Dividing by 1 + sin α, which is not zero",
                "sin α = ½",
            ),
        ),
        ("sqrt(3) m u", 120, ("√3 cos α/(1 − √3 sin α) = −√3", "tan(α/2) = √3/3", "α = 60°")),
    ],
)
def test_an_impulse_and_a_deflection_at_a_wall(
    impulse: str, deflection: int, parts: tuple[str, ...]
) -> None:
    printed_with(
        f"""
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given impulse = {impulse}
part a
find e in terms of alpha
part b
given deflection(P) = {deflection}°
find alpha, e
""",
        parts,
    )


def test_a_deflection_at_a_wall_that_only_approaches_its_bound() -> None:
    derivation = working(f"{WALL}find maximum of deflection(P) over theta")
    assert answers(derivation) == ["delta < 180°"]
    assert "delta = theta + beta" in said(derivation)


@pytest.mark.parametrize(
    ("masses", "angle"), [(("2m", "5m", "3/4"), "180°"), (("m", "2m", "1/2"), "90°")]
)
def test_who_is_sent_back_or_aside(masses: tuple[str, str, str], angle: str) -> None:
    text = SPHERES.format(*masses) + "find maximum of deflection(A) over alpha"
    assert answers(working(text)) == [f"delta < {angle}"]


def test_angles_at_a_wall_compared() -> None:
    derivation = working(
        f"{WALL}show deflection(P) >= 2 angle(velocity(P), W)\nshow angle(velocity(P), W) < theta"
    )
    assert "beta <= theta" in said(derivation)


def test_an_angle_is_acute_where_its_tangent_is_positive() -> None:
    text = SPHERES.format("3m", "3m", "e")
    derivation = working(f"{text}given e < 1\nshow angle(velocity(A), velocity(B)) < 90°")
    assert "tan(beta) > 0" in said(derivation)


def test_the_angle_to_a_wall_parallel_to_that_which_was_struck() -> None:
    derivation = working(
        """
        wall L: along j
        wall M: along j
        sphere P: velocity u at alpha to L
        P hits L: e = 1/2
        P hits M: e = 2/3
        find tan(angle(velocity(P), L))
        """
    )
    assert answers(derivation) == ["tan(beta) = 1/3 tan(alpha)"]


@pytest.mark.parametrize("told", ["beta - alpha = 30°", "beta = 2alpha"])
def test_a_tangent_at_a_double_root_or_of_the_double_angle(told: str) -> None:
    text = SPHERES.format("m", "m", "1/3")
    derivation = working(
        f"{text}let beta = angle(velocity(A), line_of_centres)\ngiven {told}\nfind alpha"
    )
    assert answers(derivation) == ["alpha = 30°"]


def test_a_direction_by_half_the_angle() -> None:
    derivation = working(
        """
        wall W: along 45°
        sphere P: mass 1, velocity 3i
        P receives J at theta
        given J = 3, velocity(P) parallel to W, 0 < theta < 180°
        find theta
        """
    )
    assert answers(derivation) == ["theta = 90°"]
    assert "tan(theta/2) = 1" in said(derivation)


def test_an_offset_by_the_square_of_its_root() -> None:
    derivation = working(
        """
        sphere A, B: mass m, radius a
        sphere A: velocity u i
        sphere B: at rest
        A hits B: offset d, e = 2/3
        given speed(B) = 2/3 u
        find d
        """
    )
    assert answers(derivation) == ["d = 6/5 a"] or answers(derivation) == ["d = 6a/5"]


def test_an_offset_by_the_sine_of_an_angle() -> None:
    derivation = working(
        """
        sphere A: mass m, velocity u i, radius a
        sphere B: mass 2m, at rest, radius a
        A hits B: offset 2a sin(theta), e = 1/2
        find speed(B)
        """
    )
    assert answers(derivation) == ["speed(B, 1) = 1/2 u cos(theta)"]


def test_the_least_distance_of_two_bodies_after_a_wall() -> None:
    derivation = working(
        """
        wall W: along j, through (0, 0)
        sphere A: mass m, at (a, 0), velocity -2u i
        sphere B: mass m, at (5a, 2a), velocity -u i
        A hits W: e = 1/2
        find minimum of distance(A, B, at time(1) + T) over T
        """
    )
    assert answers(derivation) == ["distance(A, B, at time(1) + T) >= 2a"]


def test_the_greatest_letter_that_an_equation_ties() -> None:
    text = SPHERES.format("m", "4m", "e")
    derivation = working(f"{text}given deflection(A) = 90°\nfind maximum of alpha over e")
    (answer,) = answers(derivation)
    assert answer.startswith("alpha <= arctan(")


def test_angles_are_rounded_in_degrees() -> None:
    text = """
    sphere A, B: mass 0.18
    sphere A: velocity 4 at 35°
    sphere B: at rest
    A hits B: along i, e = 0.95
    show angle(velocity(A), velocity(B)) = {0}° to 3 s.f.
    """
    held = [solve(parse(text.format(each))).parts[None].items[0].holds for each in ("87.9", "88.0")]
    assert held == [False, True]


def test_the_roots_of_two_quotients_of_squares_stand_before_these_are_multiplied_across() -> None:
    text = """
sphere A: mass 2m, velocity u at 30°
sphere B: mass m, velocity u at 60° from -i
A hits B: along i
given angle(velocity(A), line_of_centres) = angle(velocity(B), line_of_centres)
find e
"""
    quotient = "(u/2)/((2√3 − 1 − (1 + √3)e)u/6) = ±(√3 u/2)/"
    across = "2(1 + √3)e + 2√3 − 1 = ±(6 − √3 − (3 + √3)e)"
    printed_with(text, (quotient, across, "e = 18√3 − 31 ≈ 0.177"))
