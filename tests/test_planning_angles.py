"""Planned workings of angles, deflections, and of lines of centres and walls that are not given.

Each is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest
from workings import printed_with

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.equations.solution import Solution
from restitution.solving.story.letters import roles

STATEMENTS = {
    "directions along both axes": """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, velocity -u j
A hits B: along i, e = 1/2
find direction(A), direction(B, 0), direction(B)
""",
    "a wall at an angle that is asked": """
wall W: along theta
sphere P: velocity 3u i
P hits W: e = 2/3
given velocity(P) perpendicular to i
find tan(theta), speed(P)
""",
    "a line of centres at an angle that is told by its sine": """
sphere A: mass 2m, velocity u i
sphere B: mass m, at rest
A hits B: along phi, e = 1/2
given sin(phi) = 5/13
find velocity(A), velocity(B), impulse
""",
    "an offset that is asked": """
sphere A: mass 2m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset d, e = 1/2
given direction(B) = 60°
find d, speed(B)
""",
    "a line of centres that is asked, though given": """
sphere A: mass 1, velocity 5i, radius 2
sphere B: mass 3, velocity -i, radius 2
A hits B: offset 2.4, e = 1/2
find line_of_centres, velocity(A)
""",
    "who was at rest goes along the line of centres": """
sphere A: mass 3, velocity 10i
sphere B: mass 2, at rest
A hits B: e = 1/4
given direction(B) = arctan(4/3)
find line_of_centres, velocity(A), speed(B)
""",
    "who was at rest goes along a vector": """
sphere A: mass m, velocity 3u i + u j
sphere B: mass m, at rest
A hits B: e = 1/2
given velocity(B) parallel to 2i + j
find velocity(B), impulse
""",
    "an angle to a line of centres that is found": """
sphere A: mass 2, velocity 4i + 2j
sphere B: mass 1, velocity -2i + j
A hits B
given velocity(A) = 2i
find angle(line_of_centres, i), e
""",
    "the angle between two paths, in letters": """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
find tan(angle(velocity(A), velocity(B)))
""",
    "the angle between two paths that is given": """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 4/5
given angle(velocity(A), velocity(B)) = 30°
find tan(alpha)
""",
    "a deflection at a wall, by the angles to it": """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/4
given deflection(P) = 45°
find tan(alpha)
""",
    "a deflection at a wall, and the angle before it": """
wall W: along j
sphere P: velocity u at 20° to W
P hits W
given deflection(P) = 35°
find e
""",
    "a multiple of a tangent that was worked out": """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at 180° - alpha
A hits B: along i
given e = 1/3, angle(velocity(A), velocity(B)) = 90°
find alpha
find angle(velocity(A), i)
""",
    "the tangent of a deflection at a wall": """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
find tan(deflection(P))
""",
    "along i": """
sphere A: mass 3, velocity 2i + 4j
sphere B: mass 1, at rest
A hits B: along i, e = 1/2
find direction(B), direction(A)
""",
    "against i": """
sphere A: mass m, velocity u at alpha
sphere B: mass 4m, velocity -3u i
A hits B: along i, e = 0
given alpha > 45°
find direction(B)
""",
    "a tangent of a deflection that is given": """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
given tan(alpha) = 1/3
A hits B: along i, e = 1/2
given tan(deflection(A)) = 1/2
find k
""",
    "a cosine of a deflection that is given": """
sphere A: mass m, velocity 2u i + u j
sphere B: mass m, velocity -4u i
A hits B: along i
given cos(deflection(A)) = -3/5
find e
""",
    "equal angles to the line of centres": """
sphere A: mass 2m, velocity u at 45°
sphere B: mass m, velocity u at 60° from -i
A hits B: along i
given angle(velocity(A), line_of_centres) = angle(velocity(B), line_of_centres)
find e
""",
    "an angle of the line of centres that is given": """
sphere A: mass m, velocity 4u i, radius 3
sphere B: mass m, at rest, radius 3
A hits B: offset d, e = 1/3
given angle(line_of_centres, i) = arctan(3/4), d > 0
find d, speed(B)
""",
    "an angle to a wall that comes later": """
wall AB: along i
wall BC: along 60°
sphere P: velocity u at 45° to AB
part a
P hits AB: e = 1/2
find angle(velocity(P), BC)
part b
P hits BC: e = 1/2
find tan(angle(velocity(P), BC))
""",
    "the range of an angle between two paths": """
sphere A: mass 2m, velocity u at 45°
sphere B: mass m, at rest
A hits B: along i
find range of angle(velocity(A), velocity(B))
""",
    "the angle between the first and the last path": """
wall AB: along i
wall BC: along 60°
sphere P: velocity u at 30° to AB
P hits AB: e = 1/2
P hits BC: e = 1
find angle(velocity(P), velocity(P, 0))
""",
}


@cache
def planned(name: str) -> tuple[Derivation, Solution]:
    solution = solve(parse(STATEMENTS[name]))
    return plan(solution), solution


@pytest.mark.parametrize("name", STATEMENTS)
def test_a_working_of_angles_is_followed(name: str) -> None:
    derivation, solution = planned(name)
    oracle = Oracle(roles(solution.problem))
    assert [str(each) for each in follow(derivation, oracle)] == []


@pytest.mark.parametrize("name", STATEMENTS)
def test_its_answers_are_those_of_the_solver(name: str) -> None:
    from derivations import disagreement

    derivation, solution = planned(name)
    items = list(solution.items())
    ends = list(derivation.items)
    assert len(ends) == len(items)
    for (part, item), end in zip(items, ends, strict=True):
        assert disagreement(item, [end], dict(part.roles)) is None, write_relation(end.answer)


def lines_of(name: str) -> list[str]:
    derivation, _ = planned(name)
    relations = (each.relation for each in derivation.lines)
    return [write_relation(each) for each in relations if isinstance(each, Relation)]


def test_an_offset_gives_the_line_of_centres_first() -> None:
    derivation, _ = planned("a line of centres that is asked, though given")
    first = derivation.lines[0]
    assert first.premises == ("axis 1",)
    assert first.relation == read_relation("line_of_centres(1) = 4/5 i + 3/5 j", {})


def test_the_size_of_a_velocity_along_the_line_has_no_part_in_the_angle_to_it() -> None:
    lines = lines_of("the angle between two paths that is given")
    assert any(each.startswith("tan(30°) = u sin(alpha)/(") for each in lines)


def test_who_is_at_rest_needs_no_direction() -> None:
    derivation, _ = planned("who was at rest goes along the line of centres")
    laws = [each for each in derivation.lines if each.move.record == "momentum"]
    assert all("axis 1" not in each.premises for each in laws)


def test_an_angle_that_may_be_obtuse_goes_by_its_cotangent() -> None:
    statement = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity v at beta from -i
A hits B: along i
find deflection(A)
"""
    problem = parse(statement)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    lines = [
        write_relation(each.relation)
        for each in derivation.lines
        if isinstance(each.relation, Relation)
    ]
    assert any(line.startswith("cot(delta) = ") for line in lines)
    assert lines[-1].startswith("delta = 90° - arctan(")


def test_a_deflection_at_a_wall_is_the_sum_of_the_angles_to_it() -> None:
    lines = lines_of("the tangent of a deflection at a wall")
    assert "delta = alpha + beta" in lines
    assert any(each.startswith("tan(delta) = (tan(alpha) + tan(beta))/(1 - ") for each in lines)
    assert any(
        "beta = 35° - 20° = 15°" in e
        for e in lines_of("a deflection at a wall, and the angle before it")
    )


def test_what_moves_along_i_has_its_direction_read_off() -> None:
    assert "direction(B, 1) = 0°" in lines_of("along i")
    assert "direction(B, 1) = 180°" in lines_of("against i")


def test_a_direction_is_not_read_off_in_the_other_sense() -> None:
    derivation, solution = planned("along i")
    relation = read_relation("direction(B, 1) = 180°", {"A": "sphere", "B": "sphere"})
    lines = tuple(
        replace(each, relation=relation) if each.move.record == "parallel" else each
        for each in derivation.lines
    )
    complaints = follow(replace(derivation, lines=lines), Oracle(roles(solution.problem)))
    assert any(each.reason == "does-not-follow" for each in complaints)


def test_a_direction_along_an_axis_is_read_off_with_its_sign() -> None:
    solution = solve(parse(STATEMENTS["directions along both axes"]))
    derivation = plan(solution)
    answers = [write_relation(each.answer) for each in derivation.items]
    assert answers[:2] == ["direction(A, 1) = 90°", "direction(B, 0) = -90°"]
    end = derivation.items[0]
    line = derivation.line(end.line)
    assert line is not None
    turned = replace(line, relation=read_relation("direction(A, 1) = -90°", {}))
    lines = tuple(turned if each is line else each for each in derivation.lines)
    wrong = replace(derivation, lines=lines)
    assert any(each.line == line.number for each in follow(wrong, Oracle(roles(solution.problem))))


def test_a_letter_of_an_angle_is_in_degrees_once_its_letters_are_known() -> None:
    statement = """
wall W: along j
sphere Q: velocity v at beta to W
Q hits W
given deflection(Q) = 90°
part a
find beta
part b
given e = 1/3
find beta
"""
    derivation = plan(solve(parse(statement)))
    last = derivation.lines[-1].relation
    assert isinstance(last, Relation)
    assert write_relation(last) == "beta = 60°"


def test_a_direction_is_a_multiple_of_a_tangent_that_was_worked_out() -> None:
    """No sine and no cosine of an angle is written down for a quotient in which both cancel."""
    said = lines_of("a multiple of a tangent that was worked out")
    assert not any(each.startswith(("sin(alpha)", "cos(alpha)")) for each in said)
    # v = −⅓u cos α, so that tan β = −3 tan α.
    assert "tan(beta) = -u sin(alpha)/(1/3 u cos(alpha)) = -3tan(alpha) [rearrange]" in said
    assert "tan(beta) = -1" in said


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (
            """
sphere A: mass 2m, velocity 3 at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given tan(direction(A)) = 3
find alpha
""",
            ("3 = 3 sin α/((3/2) cos α)", "tan α = 3/2", "α = arctan(3/2)"),
        ),
        (
            """
sphere A: mass 4m, velocity u at alpha
sphere B: mass 4m, velocity 2u at 270° - alpha
A hits B: along i, e = 3/4
given tan(alpha) = 3/4
find deflection(B)
""",
            ("tan β = (8u/5)/(11u/20) = 32/11", "180° − (90° − arctan(3/4)) − arctan(32/11)"),
        ),
        (
            """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = e
given speed(P) = 1/2 speed(P, 0)
find alpha
""",
            (
                "cos α = √((1 − 4e²)/(1 − e²))/2, as α is acute",
                "α = arccos(√((1 − 4e²)/(1 − e²))/2)",
            ),
        ),
    ],
    ids=[
        "the tangent of a direction that is given",
        "the complement of an angle with a ratio",
        "an angle by the cosine that a line gives in letters",
    ],
)
def test_angles_are_worked_out_by_their_tangents(statement: str, lines: tuple[str, ...]) -> None:
    printed_with(statement, lines)


@pytest.mark.parametrize(
    ("asked", "ends"),
    [
        ("sin(alpha)", ("sin α = ⅗",)),
        ("cos(alpha)", ("cos α = ⅘",)),
        ("sin(alpha), cos(alpha)", ("sin α = ⅗", "cos α = ⅘")),
    ],
)
def test_a_ratio_that_is_asked_ends_its_lines(asked: str, ends: tuple[str, ...]) -> None:
    """The other ratio stands there only if somebody needs it."""
    wall = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W: e = 2/3
given tan(angle(velocity(P), W)) = 1/2
"""
    text = printed_with(f"{wall}find {asked}\n", ("tan α = ¾", *ends))
    assert text.count("α = ⅗") + text.count("α = ⅘") == len(ends)
