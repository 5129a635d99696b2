"""Workings of places, times and distances: accepted by the follower, with the right answers."""

from __future__ import annotations

import math
import random
from fractions import Fraction

import pytest
import sympy as sp
from workings import printed_with

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Meaning, Relation
from restitution.explaining.lines.notation import write_relation
from restitution.expression.evaluate import in_letters
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles


def working(statement: str) -> Derivation:
    """The planned working of a statement, which the follower accepts."""
    problem = parse(statement)
    derivation = plan(solve(problem))
    complaints = follow(derivation, Oracle(roles(problem)))
    assert not complaints, [str(each) for each in complaints]
    return derivation


def answers(derivation: Derivation) -> list[str]:
    """The answers as lines say them."""
    return [write_relation(each.answer) for each in derivation.items]


def said(derivation: Derivation) -> list[str]:
    """What the lines say, but for those that introduce letters."""
    return [
        write_relation(each.relation)
        for each in derivation.lines
        if isinstance(each.relation, Relation)
    ]


CORRIDOR = """
wall L: along i, through (0, 0)
wall M: along i, through (0, 4)
sphere P: at (0, 2), velocity 6i - 4j
P hits L: e = 1/2
P hits M: e = 1/2
"""


def test_times_and_places_between_walls() -> None:
    derivation = working(CORRIDOR + "find time(1), time(2), position(P, 2), position(P, at 2)\n")
    assert answers(derivation) == [
        "time(1) = 1/2",
        "time(2) = 5/2",
        "position(P, 2) = 15i + 4j",
        "position(P, at 2) = 12i + 3j",
    ]
    lines = said(derivation)
    assert "time(2) - time(1) = 4/2 = 2 [rearrange]" in lines
    assert "time(2) = 1/2 + 2 = 5/2 [rearrange]" in lines
    assert "along(position(P, 2), i) = 6(5/2) = 15 [rearrange]" in lines


def test_what_is_asked_of_one_direction_needs_no_other() -> None:
    derivation = working(CORRIDOR + "find time(2)\n")
    assert not any("velocity(P, 1), i" in each for each in said(derivation))


def test_a_duration_needs_no_time_before() -> None:
    derivation = working(CORRIDOR + "find time(2) - time(1)\n")
    assert said(derivation)[-1] == "time(2) - time(1) = 4/2 = 2 [rearrange]"
    assert not any(each.startswith("time(1) =") for each in said(derivation))


def test_places_at_one_wall_are_apart_by_their_coordinates() -> None:
    derivation = working(
        CORRIDOR + "P hits L: e = 1\nfind distance(position(P, 1), position(P, 3))\n"
    )
    assert answers(derivation) == ["distance(position(P, 1), position(P, 3)) = 36"]


def test_a_distance_may_be_to_a_place_that_is_told_by_its_coordinates() -> None:
    derivation = working(
        """
        wall W: along j, through (6, 0)
        sphere P: at (0, 0), velocity 3i + 2j
        P hits W: e = 1/2
        find distance(position(P, 1), (3, 0)), position(P)
        """
    )
    assert answers(derivation)[0] == "distance(position(P, 1), (3, 0)) = 5"


def test_letters_of_length_and_speed() -> None:
    derivation = working(
        """
        wall L: along i, through (0, 0)
        wall M: along i, through (0, d)
        sphere P: at (0, 0), velocity u at alpha
        P hits M
        P hits L
        find time(2), position(P, 2)
        """
    )
    first, second = answers(derivation)
    assert first == "time(2) = (1 + e) d/(e u sin(alpha))"
    assert second == "position(P, 2) = (1 + e) d/(e tan(alpha)) i"


def test_a_path_to_a_point_gives_an_angle_without_a_time_there() -> None:
    derivation = working(
        """
        wall W: along i, through (0, 0)
        point N: (7, 3)
        sphere P: at (0, 4), velocity u at alpha to W
        P hits W: e = 3/4
        P reaches N
        find alpha
        """
    )
    assert answers(derivation) == ["alpha = arctan(8/7)"]
    assert not any("time(" in each for each in said(derivation))
    assert "along(position(P, 1), i) = 4(u cos(alpha)/(u sin(alpha)))" in " ".join(said(derivation))


def test_without_a_word_of_times_places_come_of_the_components() -> None:
    derivation = working(
        """
        wall W1: along i, through (0, 0)
        wall W2: along j, through (a, 0)
        sphere P: at (0, a), velocity 3u i - 4u j
        P hits W1: e = 1/2
        P hits W2: e = 1/2
        P reaches (0, h)
        find h
        """
    )
    assert answers(derivation) == ["h = 3a/2"]
    lines = said(derivation)
    assert "along(position(P, 1), i) = a (3u/(4u)) = 3a/4 [rearrange]" in lines
    assert not any("time(" in each for each in lines)


def test_a_chase_is_counted_from_the_last_impact() -> None:
    derivation = working(
        """
        wall W: along j, through (6d, 0)
        sphere A: mass 2m, at (-2d, 0), velocity 3u i
        sphere B: mass m, at (0, 0), at rest
        A hits B: along i, e = 1/2
        B hits W: e = 2/3
        A hits B: along i, e = 1/2
        find position(A), time(3)
        """
    )
    lines = said(derivation)
    assert "time(2) - time(1) = 6d/(3u) = 2d/u [rearrange]" in lines
    assert any(each.startswith("time(3) - time(2) =") for each in lines)
    assert lines[-1].startswith("time(3) = 2d/(3u) + 2d/u + ")


def test_where_one_direction_tells_the_time_the_other_gives_the_coefficient() -> None:
    derivation = working(
        """
        wall W: along i, through (0, 0)
        point N: (9, 4)
        sphere P: at (0, 2), velocity 3i - 2j
        P hits W
        P reaches N
        find e, time(2)
        """
    )
    assert answers(derivation) == ["e = 1", "time(2) = 3"]
    assert "time(2) = 9/3 = 3 [rearrange]" in said(derivation)
    assert "4 = 2e*2" in said(derivation)


def test_two_that_move_meet_at_one_place() -> None:
    derivation = working(
        """
        wall W: along j, through (9, 0)
        sphere A: mass 2, at (0, 0), velocity 6i
        sphere B: mass 1, at (3, 0), at rest
        A hits B: along i, e = 1/2
        B hits W: e = 1/2
        A hits B: along i, e = 1/2
        find time(3), position(B, 3)
        """
    )
    assert answers(derivation) == ["time(3) = 2", "position(B, 3) = 15/2 i"]


def test_distance_after_an_impact_by_restitution_alone() -> None:
    derivation = working(
        """
        sphere A: mass 3, velocity 5i + 2j
        sphere B: mass 2, velocity -i + 6j
        A hits B: along i, e = 1/2
        find distance(A, B, at 3)
        """
    )
    assert answers(derivation) == ["distance(A, B, at 3) = 15"]
    assert not any(each.move.record == "momentum" for each in derivation.lines)


def test_a_length_is_positive_because_a_time_is() -> None:
    derivation = working(
        """
        sphere A: mass m, at (0, 0), velocity u i
        sphere B: mass m, at (d, 0), at rest
        sphere C: mass m, at (3d, 0), at rest
        A hits B: along i, e = 1/3
        B hits C: along i, e = 1/3
        find distance(A, B)
        """
    )
    assert answers(derivation) == ["distance(A, B, 2) = d"]


def test_a_slanted_wall() -> None:
    derivation = working(
        """
        wall W: from (0, 0) to (4, 3)
        sphere P: at (0, 4), velocity i - j
        P hits W: e = 1/2
        find time(1), position(P, 1)
        """
    )
    assert answers(derivation) == ["time(1) = 16/7", "position(P, 1) = 16/7 i + 12/7 j"]


def test_a_place_after_two_further_ways_follows_from_the_one_between() -> None:
    derivation = working(
        """
        wall L: along j, through (0, 0)
        wall R: along j, through (d, 0)
        sphere P: at (0, 0), velocity u at 45°
        P hits R
        P hits L
        P hits R
        find time(3)
        find distance(position(P, 1), position(P, 3))
        """
    )
    assert answers(derivation)[-1].endswith("= (1 + e) d/e^2")


@pytest.mark.parametrize("angle", ["60°", "40°", "150°", "theta"])
def test_a_wall_that_is_told_by_its_angle_is_on_a_line_too(angle: str) -> None:
    statement = f"""
        wall W: along {angle}, through (0, 0)
        sphere P: at (2, 0), velocity {"-i - 3j" if angle == "150°" else "i + 3j"}
        P hits W: e = 1/2
        find time(1), position(P, 1)
        """
    derivation = working(statement)
    degrees = 35.0 if angle == "theta" else float(angle[:-1])
    slope = math.tan(math.radians(degrees))
    sense = -1 if angle == "150°" else 1
    # At the time t it is at (2 ± t, ±3t), and ±3t = (2 ± t) tan θ.
    time = 2 * slope / (sense * (3 - slope))
    (line,) = (each for each in derivation.items if "time(1)" in write_relation(each.answer))
    tree = line.answer.only[-1].right
    value = sp.sympify(in_letters(tree))
    own = value.subs({each: math.radians(degrees) for each in value.free_symbols})
    assert abs(float(own) - time) < 1e-9


def test_a_blow_to_a_ball_at_rest_starts_the_clock() -> None:
    derivation = working(
        """
        wall W: along i, through (0, 0)
        sphere P: mass 2, at (0, 6), at rest
        P receives 4i - 6j
        P hits W: e = 1/3
        find velocity(P, 1), time(2), position(P, 2), velocity(P, 2)
        """
    )
    assert answers(derivation) == [
        "velocity(P, 1) = 2i - 3j",
        "time(2) = 2",
        "position(P, 2) = 4i",
        "velocity(P, 2) = 2i + j",
    ]


def test_a_given_time_finds_a_coefficient() -> None:
    derivation = working(
        """
        wall W: along j, through (0, 0)
        wall X: along j, through (d, 0)
        sphere P: at (d/2, 0), velocity -u i
        P hits W
        P hits X
        given time(2) = 5d/(2u)
        find e
        """
    )
    assert answers(derivation) == ["e = 1/2"]


@pytest.mark.parametrize("seed", range(4))
def test_corridors_of_any_numbers(seed: int) -> None:
    draw = random.Random(seed)
    width, start = draw.randint(3, 9), draw.randint(1, 2)
    x, y = draw.randint(1, 6), draw.randint(1, 6)
    e, f = Fraction(draw.randint(1, 4), 4), Fraction(draw.randint(1, 3), 3)
    derivation = working(
        f"""
        wall L: along j, through (0, 0)
        wall M: along j, through ({width}, 0)
        sphere P: at ({start}, 0), velocity -{x}i + {y}j
        P hits L: e = {e}
        P hits M: e = {f}
        find time(2), position(P, 2)
        """
    )
    time = Fraction(start, x) + width / (e * x)
    assert answers(derivation)[0] == f"time(2) = {time}"


@pytest.mark.parametrize(
    ("statement", "last"),
    [
        (
            """
            wall W: along j
            sphere P: mass m
            P hits W: e = 2/3
            given velocity(P) = -2u i + 3u j
            find speed(P, 0), velocity(P, 0)
            """,
            "velocity(P, 0) = 3u i + 3u j",
        ),
        (
            """
            sphere A: mass 3
            sphere B: mass 2
            A hits B: along j, e = 1/2
            given velocity(A) = i, velocity(B) = -2i + 5j
            find velocity(B, 0), velocity(A, 0)
            """,
            "velocity(A, 0) = i + 6j",
        ),
    ],
)
def test_velocities_before_by_letters_for_their_components(statement: str, last: str) -> None:
    derivation = working(statement)
    assert answers(derivation)[-1] == last
    assert any(isinstance(each.relation, Meaning) for each in derivation.lines)


@pytest.mark.parametrize(
    ("statement", "last"),
    [
        (
            """
            sphere P: mass 2, velocity 3j
            P receives k (2i - j)
            given speed(P) = 5
            find k
            """,
            "k = 2(3 + sqrt(89))/5",
        ),
        (
            """
            sphere A: mass 1, velocity 2i
            sphere B: mass 3, at rest
            A hits B: along i, e = 1
            A receives -q i + 2q j
            given velocity(A) perpendicular to i + j
            find q
            """,
            "q = 1",
        ),
    ],
)
def test_bodies_that_are_struck_by_blows_alone(statement: str, last: str) -> None:
    assert answers(working(statement))[-1] == last


AIMED = """
sphere A: mass m, at (0, 0), velocity u at alpha, radius {radius}
sphere B: mass m, at {there}, at rest, radius {radius}
A hits B: along {line}, e = 1/2
find tan(alpha)
"""


@pytest.mark.parametrize(
    ("radius", "there", "line", "place", "tangent"),
    [
        ("5", "(40, 30)", "4i + 3j", "40i + 30j - 10((4i + 3j)/5) = 32i + 24j", "3/4"),
        ("5", "(40, 20)", "-4i - 3j", "40i + 20j + 10((-4i - 3j)/5) = 32i + 14j", "7/16"),
        ("r", "(8r, 6r)", "j", "8r i + 6r j - 2r j = 8r i + 4r j", "1/2"),
        ("1", "(8, 2)", "-30°", "8i + 2j - 2(sqrt(3)/2 i - 1/2 j) = (8 - sqrt(3)) i + 3j", None),
    ],
)
def test_who_is_sent_has_to_come_two_radii_before_the_other(
    radius: str, there: str, line: str, place: str, tangent: str | None
) -> None:
    derivation = working(AIMED.format(radius=radius, there=there, line=line))
    assert f"position(A, 1) = {place} [rearrange]" in said(derivation)
    if tangent is not None:
        assert answers(derivation) == [f"tan(alpha) = {tangent}"]


def test_who_is_sent_without_a_radius_comes_to_the_place_of_the_other() -> None:
    derivation = working(
        """
        sphere A: mass m, at (0, 0), velocity u at alpha
        sphere B: mass m, at (5, 2), at rest
        A hits B: along i, e = 1/2
        find tan(alpha)
        """
    )
    assert answers(derivation) == ["tan(alpha) = 2/5"]
    assert "tan(alpha) = 2/5" in said(derivation)


def test_a_time_by_a_component_of_1_in_degrees_is_one_quotient() -> None:
    derivation = working("""
        wall W: along j, through (0, 0)
        sphere P: at (3, 1), velocity 2 at 60° from -i
        P hits W: e = 1/2
        find time(1)
        """)
    assert said(derivation)[0] == "time(1) = 3/(2cos(60°)) = 3 [rearrange]"


BY_A_WALL_TO_A_POINT = """
point T: (9, 4)
wall W: along i, through (0, 0)
sphere P: at (0, 2), velocity 3i - 2j
P hits W
P reaches T
find e, time(2){}
"""


def test_a_time_that_is_asked_comes_of_the_whole_way_that_no_impact_changes() -> None:
    lines = said(working(BY_A_WALL_TO_A_POINT.format("")))
    assert "time(2) = 9/3 = 3 [rearrange]" in lines
    assert "time(2) - time(1) = 3 - 1 = 2 [rearrange]" in lines
    assert not any("position(P, 1)" in line for line in lines)


def test_a_place_between_that_is_asked_gives_the_time_of_the_last_way() -> None:
    lines = said(working(BY_A_WALL_TO_A_POINT.format(", position(P, 1)")))
    assert "time(2) - time(1) = (9 - 3)/3 = 2 [rearrange]" in lines


def test_a_time_of_three_ways_that_is_asked_is_their_sum_where_places_rest_on_them() -> None:
    lines = said(
        working(
            """
            wall V: along i, through (0, 0)
            wall W: along i, through (0, 4)
            sphere P: at (0, 1), velocity 3i - 2j
            P hits V: e = 1/2
            P hits W: e = 1/2
            P hits V: e = 1/2
            find position(P, 2), position(P, 3), time(3)
            """
        )
    )
    assert "along(position(P, 3), i) = 27/2 + 3*8 = 75/2 [rearrange]" in lines
    assert "time(3) = 1/2 + 4 + 8 = 25/2 [rearrange]" in lines
    assert not any("time(3) - time(1)" in line for line in lines)


def test_particles_that_collide_are_at_one_point() -> None:
    lines = said(
        working(
            """
            sphere A: mass 1, velocity 4i, at (0, 0)
            sphere B: mass 1, at rest, at (0, 0)
            wall W: along j, through (3, 0)
            A hits B: along i, e = 0.4
            B hits W: e = 1/2
            A hits B: e = 1/2
            find distance(A, B), time(3)
            """
        )
    )
    assert "distance(A, B, 3) = 0" in lines
    assert not any("velocity(A, 3)" in line for line in lines)


@pytest.mark.parametrize(
    ("asked", "value"), [("dot(position(A), i)", "4a/3"), ("2a - dot(i, position(A))", "2a/3")]
)
def test_the_scalar_product_of_a_place_with_an_axis_is_a_coordinate(asked: str, value: str) -> None:
    derivation = working(
        f"""
        sphere A: mass m, velocity 3u i, at (0, 0)
        sphere B: mass m, at rest, at (0, 0)
        wall W: along j, through (2a, 0)
        A hits B: along i, e = 1/2
        B hits W: e = 1/3
        A hits B
        find {asked}
        """
    )
    *_, above, last = (e.relation for e in derivation.lines if isinstance(e.relation, Relation))
    assert "along(position(A, 3), i) = 2a/3 + 3u/4 (8a/(9u)) = 4a/3" in write_relation(above)
    assert write_relation(last).endswith(f"= {value}")


def test_a_distance_in_letters_ends_in_the_tangent_and_takes_what_a_later_part_gives() -> None:
    printed_with(
        """
        sphere A: mass 2m, velocity u at alpha, at (0, 0)
        sphere B: mass m, at rest, at (0, 0)
        wall W: along j, through (d, 0)
        A hits B: along i, e = e
        B reaches W
        part a
        find distance(A, B)
        part b
        given e = 1/2, tan(alpha) = 1
        find distance(A, B)
        """,
        (
            "= 3d√(sin²α + e² cos²α)/(2(1 + e) cos α) = 3d√(e² + tan²α)/(2(1 + e))",
            "(b) Since e = ½ and tan α = 1, from (3): ",
            "distance between A and B when B reaches W = √5 d/2",
        ),
    )


def test_what_was_shown_of_a_distance_takes_the_coefficient_of_a_later_part() -> None:
    printed_with(
        """
        sphere A: mass m, velocity u at alpha
        sphere B: mass m, at rest
        A hits B: along i
        part a
        show distance(A, B, at t) = u t sqrt(e^2 cos^2(alpha) + sin^2(alpha))
        part b
        given e = 1
        find distance(A, B, at t)
        """,
        (
            "(b) Since e = 1, from (1): ",
            "= ut√(1² cos²α + sin²α) = ut, as sin²α + cos²α = 1",
        ),
    )


def test_centres_that_touched_are_apart_as_their_places_at_a_time_are() -> None:
    text = printed_with(
        """
        sphere A: mass 2m, velocity u at alpha, radius a
        sphere B: mass 2m, at rest, radius a
        A hits B: along i, e = 1/2
        given tan(alpha) = 3/4
        given distance(A, B, at t) = 2 sqrt(10) a
        find t
        """,
        (
            "at the impact their centres are 2a apart. So B is then at 2a𝐢.",
            "= √((2ut/5 + 2a)² + (3ut/5)²)",
            "(13ut − 90a)(ut + 10a) = 0",
            "t = 90a/(13u), as t is positive",
        ),
    )
    assert "particles" not in text
