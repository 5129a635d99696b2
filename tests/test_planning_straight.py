"""Straight ways to an answer: what the data tell outright is not worked out by a detour."""

from __future__ import annotations

from dataclasses import replace

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import write_relation
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


def said(derivation: Derivation) -> list[str]:
    """What the lines say, but for those that introduce letters."""
    return [
        write_relation(each.relation)
        for each in derivation.lines
        if isinstance(each.relation, Relation)
    ]


# --- paths by their gradients --------------------------------------------------------------------


def test_a_path_between_known_places_has_a_gradient() -> None:
    lines = said(
        working(
            """
            point N: (11, 12)
            sphere A: mass 1, at (0, 0), velocity u at alpha, radius 1
            sphere B: mass 1, at (5, 4), at rest
            A hits B: e = 1/2
            B reaches N
            find alpha
            """
        )
    )
    # B goes along 3i + 4j; A is two radii behind: (5, 4) - 2(3, 4)/5 = (19/5, 12/5)
    assert "tan(alpha) = 12/5/(19/5) = 12/19 [rearrange]" in lines


def test_a_path_from_a_place_that_is_open_has_its_way_by_the_tangent() -> None:
    lines = said(
        working(
            """
            point N: (6, 2)
            wall W: along i, through (0, 0)
            sphere P: at (0, 4), velocity u at alpha to W
            P hits W: e = 2/3
            P reaches N
            find tan(alpha)
            """
        )
    )
    # as if from the mirror image at 4·2/3 below: 6 tan(alpha) 2/3 = 2 + 4·2/3
    (line,) = [each for each in lines if each.startswith("6 - 4/tan(alpha) = ")]
    assert "3/tan(alpha)" in line
    assert lines[-1] == "tan(alpha) = 7/6"


# --- what an impact does not change --------------------------------------------------------------


def test_the_momentum_of_all_is_that_before() -> None:
    lines = said(
        working(
            """
            sphere A: mass 2, velocity 3i + j
            sphere B: mass 3, velocity -2i + j
            A hits B: along i
            find momentum
            """
        )
    )
    assert lines == [
        "momentum(1) = 2(3i + j) + 3(-2i + j)",
        "momentum(1) = 5j",
    ]


CORRIDOR = """
wall L: along i, through (0, 0)
wall M: along i, through (0, 6)
sphere P: at (1, 3), velocity 5i - 6j
P hits L: e = 1/2
P hits M: e = 1/3
P hits L: e = 1/3
find time(3), position(P, 3)
"""


def test_a_component_that_no_wall_changes_is_taken_over_the_whole_time() -> None:
    # 3/6 + 6/3 + 6/1 = 17/2
    lines = said(working(CORRIDOR))
    assert "along(position(P, 3), i) = 1 + 5(17/2) = 87/2 [rearrange]" in lines
    assert not any(each.startswith("along(position(P, 1), i)") for each in lines)


def test_over_the_whole_time_each_component_on_the_way_is_cited() -> None:
    problem = parse(CORRIDOR)
    derivation = plan(solve(problem))
    (line,) = [
        each
        for each in derivation.lines
        if isinstance(each.relation, Relation)
        and write_relation(each.relation).startswith("along(position(P, 3), i)")
    ]
    for ref in line.premises:
        lines = tuple(
            replace(each, premises=tuple(e for e in each.premises if e != ref))
            if each is line
            else each
            for each in derivation.lines
        )
        assert follow(replace(derivation, lines=lines), Oracle(roles(problem)))


def test_the_time_to_a_point_gives_the_component_that_the_wall_does_not_change() -> None:
    lines = said(
        working(
            """
            point T: (9, 4)
            wall W: along i, through (0, 0)
            sphere P: at (0, 2), velocity u at alpha to W
            P hits W: e = 1/2
            P reaches T
            given time(2) = 3
            find u, alpha, time(1)
            """
        )
    )
    # 9 = 3 u cos(alpha); 2/(u sin(alpha)) + 8/(u sin(alpha)) = 3
    assert "9 = 3(u cos(alpha))" in lines
    assert "u cos(alpha) = 3" in lines
    assert "u sin(alpha) = 10/3" in lines
    assert lines[-1] == "time(1) = 3/5"


# --- what is asked of letters --------------------------------------------------------------------

TO_AND_FRO = """
wall W1: along i
wall W2: along i
sphere P: velocity u at 60° to W1
P hits W1: e = e1
P hits W2: e = e2
given angle(velocity(P), W2) = 30°
"""


def test_a_product_of_letters_is_not_found_by_one_of_them() -> None:
    lines = said(working(TO_AND_FRO + "find e1 e2\n"))
    assert lines[-1] == "e_1 e_2 = 1/3"
    assert not any(each.startswith("e_1 = ") for each in lines)


def test_a_product_of_letters_that_are_known_has_their_values() -> None:
    lines = said(working(TO_AND_FRO + "given e1 = 1/2\nfind e1 e2\n"))
    assert lines[-1] == "e_1 e_2 = 1/2 (2/3) = 1/3 [rearrange]"


# --- an unknown below a root ---------------------------------------------------------------------

DISCS = """
sphere A: mass m, velocity u i, radius a
sphere B: mass {mass}, at rest, radius a
A hits B: offset d, e = {e}
given deflection(A) = {angle}
find d
"""


def test_an_offset_by_a_deflection_is_by_the_tangent_and_squares_nothing() -> None:
    # With s = d/2a: tan 30° = 3s√(1 - s²)/(1 + 3s²), so 9s⁴·4 - 21s² + 1 = 0 has the same roots.
    lines = said(working(DISCS.format(mass="m", e="1/2", angle="30°")))
    assert "4tan^2(phi) - 3sqrt(3) tan(phi) + 1 = 0" in lines
    assert not any("d^2" in each or "d^4" in each for each in lines)
    assert "d = (sqrt(33) - 3) a/6" in lines
    assert lines[-1] == "d = (3 + sqrt(33)) a/6"


def test_an_offset_by_a_deflection_has_the_root_of_an_acute_angle() -> None:
    # A comes back along the line of centres: its turn through 45° has but one offset.
    lines = said(working(DISCS.format(mass="2m", e="3/4", angle="45°")))
    assert "tan(phi) = (7 + sqrt(73))/12 or tan(phi) = (7 - sqrt(73))/12" in lines
    assert "tan(phi) = (7 + sqrt(73))/12" in lines
    assert lines[-1] == "d = a sqrt((9 + sqrt(73))/7)"


def test_a_velocity_before_is_along_the_way_to_the_place_of_the_impact() -> None:
    lines = said(
        working(
            """
            point N: (9, 6)
            sphere A: mass 2, at (1, 1), radius 1/2
            sphere B: mass 1, at (5, 3), at rest
            A hits B: e = 1/3
            B reaches N
            given speed(A, 0) = 5
            find velocity(A, 0)
            """
        )
    )
    # A goes from (1, 1) to (5, 3) - (4, 3)/5 = (21/5, 12/5): along 16i + 7j at 5 m/s.
    assert "= 16sqrt(305)/61 i + 7sqrt(305)/61 j" in lines[-1]
