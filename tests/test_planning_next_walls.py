"""Planned workings of a second impact that the body comes to at an exact angle.

That angle is the sum or the difference of one that stands and of one between walls.
"""

from __future__ import annotations

from dataclasses import replace
from functools import cache

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.problem import Problem
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain

STATEMENTS = {
    "after an angle that was found": """
wall AB: along i
wall BC: along 75°
sphere P: mass m, velocity u at 60° to AB
P hits AB: e = 1/3
find speed(P), angle(velocity(P), AB)
P hits BC: e = 1/2
find speed(P)
""",
    "from the other side": """
wall AB: along j
wall BC: along 150°
sphere P: mass m, velocity u at 30° to AB
P hits AB: e = 1
P hits BC: e = 1/2
find speed(P)
""",
    "by letters": """
wall OA: along i
wall OB: along phi
sphere P: mass m, velocity u at alpha to OA
given alpha < phi
P hits OA: e = 1
P hits OB: e = 1
find angle(velocity(P), OB), deflection(P)
""",
    "through a right angle": """
wall AB: along i
wall BC: along j
sphere P: mass m, velocity u at 60° to AB
P hits AB: e = 1/3
find speed(P), angle(velocity(P), AB)
P hits BC: e = 1/3
find deflection(P)
""",
    "along the line of centres, and then a wall": """
sphere A: mass k m, velocity u at 45°
sphere B: mass m, at rest
wall W: along 120°
A hits B: along i, e = 1/2
B hits W: e = 1/3
find deflection(B)
""",
}


@cache
def planned(name: str) -> tuple[Problem, Derivation]:
    problem = parse(STATEMENTS[name])
    return problem, plan(solve(problem))


def lines_of(name: str) -> list[str]:
    relations = (each.relation for each in planned(name)[1].lines)
    return [write_relation(each) for each in relations if isinstance(each, Relation)]


@pytest.mark.parametrize("name", STATEMENTS)
def test_each_line_follows(name: str) -> None:
    problem, derivation = planned(name)
    assert not derivation.notes
    assert not follow(derivation, Oracle(roles(problem)))


def test_the_angle_to_the_next_wall_is_a_difference() -> None:
    said = lines_of("after an angle that was found")
    assert "angle(velocity(P, 1), BC) = 180° - 105° - 30° = 45° [rearrange]" in said
    components = [each for each in said if "velocity(P, 1), line_of_centres(2)" in each]
    assert [each.split(" = ")[1] for each in components[:2]] == [
        "u/sqrt(3) sin(45°)",
        "u/sqrt(3) cos(45°)",
    ]


GIVEN = """
wall AB: along i
wall BC: along 60°
sphere P: velocity 4 at 45° to AB
P hits AB: e = e
given angle(velocity(P, 1), AB) = 30°
part a
find e
part b
P hits BC: e = e
find angle(velocity(P), BC)
"""

SQUARE = """
wall AB: along i
wall BC: along 120°
sphere P: velocity 6 at 60° to AB
P hits AB: e = 1/3
part a
show velocity(P) perpendicular to BC
part b
P hits BC: e = 1/2
find speed(P)
"""


def test_a_given_angle_to_a_wall_is_one_with_the_next_wall() -> None:
    said = " ".join(str(explain(solve(parse(GIVEN)), check=True)).split())
    assert (
        "AB and BC meet at 180° − 60° = 120°. Third angle of the triangle that they make with "
        "the path: angle between 𝐯₁ and BC = 180° − 120° − 30° = 30°"
    ) in said
    assert "P moves at 30° to BC." in said
    assert "𝐧" not in said


def test_a_wall_that_is_struck_at_right_angles_needs_no_unit_vector() -> None:
    said = " ".join(str(explain(solve(parse(SQUARE)), check=True)).split())
    assert "component of 𝐯₁ towards BC = 2√3" in said
    assert "component of 𝐯₂ away from BC = ½ × 2√3 = √3" in said
    assert "𝐧" not in said


def test_a_vector_of_an_earlier_part_is_resolved_at_the_next_wall() -> None:
    problem = parse("""
wall W: along 3i + 4j
wall V: along -4i + 3j
sphere P: mass 2, velocity 10i + 5j
part a
P hits W: e = 2/5
find velocity(P)
part b
P hits V: e = 1/2
find velocity(P)
""")
    said = " ".join(str(explain(solve(problem), check=True)).split())
    assert "𝐯₁ · 𝐧₂ = (3 × 4.4 + 4 × 9.2)/5 = 10" in said
    assert "𝐭₁" not in said


FROM_A_WALL = """
wall W: along {}
sphere P: velocity 9 at {}
P hits W: e = 0.4
find direction(P)
"""


@pytest.mark.parametrize(
    ("wall", "path", "lines"),
    [
        ("20°", "-15°", ("W is at 20° to 𝐢, and P leaves it", "≈ 20° + 15.647° ≈ 35.6°")),
        ("20°", "155°", ("P moves the opposite way along it.", "= arctan 0.4 − 160° ≈ −138°")),
        ("20°", "65°", ("W is at 20° to 𝐢, and P leaves it", "= 20° − arctan 0.4 ≈ −1.80°")),
        ("150°", "-75°", ("P moves the opposite way along it.", "= arctan 0.4 − 30° ≈ −8.20°")),
    ],
)
def test_the_direction_from_a_wall_in_degrees_is_by_its_own(
    wall: str, path: str, lines: tuple[str, ...]
) -> None:
    problem = solve(parse(FROM_A_WALL.format(wall, path)))
    text = str(explain(problem, check=True))
    for mark in (" M1", " A1", " B1"):
        text = text.replace(mark, "")
    said = " ".join(text.split())
    for line in lines:
        assert line in said
    assert "𝐣" not in said


def test_a_wall_with_e_1_keeps_speed_and_angle() -> None:
    said = lines_of("from the other side")
    assert "speed(P, 1) = u" in said
    assert "angle(velocity(P, 1), AB) = 30°" in said
    assert "angle(velocity(P, 1), BC) = 180° - 120° - 30° = 30° [rearrange]" in said
    assert lines_of("by letters") == [
        "angle(velocity(P, 1), OA) = alpha",
        "angle(velocity(P, 1), OB) = phi - alpha",
        "angle(velocity(P, 2), OB) = phi - alpha",
        "deflection(P, 2) = phi - alpha + (phi - alpha) = 2phi - 2alpha [rearrange]",
    ]


def test_a_deflection_is_the_sum_of_exact_angles() -> None:
    assert "deflection(P, 2) = 60° + 30° = 90° [rearrange]" in lines_of("through a right angle")
    name = "along the line of centres, and then a wall"
    assert "deflection(B, 2) = 60° + 30° = 90° [rearrange]" in lines_of(name)


@pytest.mark.parametrize(
    ("name", "right", "wrong"),
    [
        ("after an angle that was found", "105° - 30° = 45°", "105° + 30° = 105°"),
        ("after an angle that was found", "180° - 105° - 30° = 45°", "30° + 30° = 60°"),
        ("after an angle that was found", "sin(45°)", "(-sin(45°))"),
        ("after an angle that was found", "cos(45°)", "(-cos(45°))"),
        ("from the other side", "120° - 30° = 30°", "120° + 30° = 90°"),
        ("from the other side", "u sin(30°)", "(-u sin(30°))"),
        ("from the other side", "u cos(30°)", "(-u cos(30°))"),
        ("by letters", "OB) = phi - alpha", "OB) = phi + alpha"),
    ],
)
def test_another_angle_or_sense_does_not_follow(name: str, right: str, wrong: str) -> None:
    problem, derivation = planned(name)
    names = {"P": "sphere", "AB": "wall", "BC": "wall", "OA": "wall", "OB": "wall"}

    def turned(line: Line) -> Line:
        said = "" if not isinstance(line.relation, Relation) else write_relation(line.relation)
        if right not in said or line.move.id != "define":
            return line
        altered = said.replace(right, wrong).split(" = ")
        # A wrong first step is not worked out any further.
        return replace(line, relation=read_relation(" = ".join(altered[:2]), names))

    lines = tuple(map(turned, derivation.lines))
    assert lines != derivation.lines
    wrong_working = replace(derivation, lines=lines)
    reasons = {each.reason for each in follow(wrong_working, Oracle(roles(problem)))}
    assert "does-not-follow" in reasons


def test_who_came_along_a_line_of_centres_has_its_angle_to_the_next_one() -> None:
    problem = parse("""
sphere A: mass m, velocity u at 30°
sphere B: mass 2m, at rest
sphere C: mass m, at rest
A hits B: along i, e = 1/2
B hits C: along 60°, e = 1/2
find deflection(B)
""")
    derivation = plan(solve(problem))
    relations = (each.relation for each in derivation.lines)
    said = [write_relation(each) for each in relations if isinstance(each, Relation)]
    assert "angle(velocity(B, 1), line_of_centres(2)) = 60°" in said
    assert not any(each.endswith("sqrt(3)") and each.startswith("tan(theta)") for each in said)
    assert not follow(derivation, Oracle(roles(problem)))


def test_a_given_direction_is_the_letter_of_the_line_of_centres() -> None:
    """No tangent has to say that tan θ is tan 60°."""
    problem = parse("""
sphere A: mass 3m, velocity u i
sphere B: mass m, at rest
A hits B: along theta
given direction(B) = 60°
find theta, speed(B) in terms of e, u
""")
    derivation = plan(solve(problem))
    relations = (each.relation for each in derivation.lines)
    said = [write_relation(each) for each in relations if isinstance(each, Relation)]
    assert "theta = 60°" in said
    assert not any("tan(" in each for each in said)
    assert not follow(derivation, Oracle(roles(problem)))


def test_an_angle_without_exact_ratios_keeps_its_sine() -> None:
    problem = parse("""
wall AB: along i
wall BC: along 100°
sphere P: mass m, velocity u at 45° to AB
P hits AB: e = 1
P hits BC: e = 1/2
find impulse(2)
""")
    derivation = plan(solve(problem))
    relations = (each.relation for each in derivation.lines)
    said = [write_relation(each) for each in relations if isinstance(each, Relation)]
    assert "along(velocity(P, 1), line_of_centres(2)) = u sin(55°)" in said
    assert not follow(derivation, Oracle(roles(problem)))


ELASTIC = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1\n"


@pytest.mark.parametrize(
    ("rest", "working"),
    [
        (
            "given tan(alpha) = 3/4\nfind angle(velocity(P), W)",
            "α = arctan(3/4) Substituting in (1): angle between 𝐯_P and W = arctan(3/4) ≈ 36.9°",
        ),
        (
            "given tan(alpha) = 3/4\nfind deflection(P)",
            "δ = α + α = 2α = 2 arctan(3/4) ≈ 73.7°",
        ),
        ("find direction(P)", "tan θ = u sin α/(u cos α) = tan α θ = α"),
    ],
    ids=["its angle", "the deflection", "its direction"],
)
def test_the_angle_that_an_elastic_wall_keeps_is_that_of_the_data(rest: str, working: str) -> None:
    text = " ".join(str(explain(solve(parse(ELASTIC + rest)), check=True)).split())
    for mark in (" M1", " A1ft", " A1", " B1"):
        text = text.replace(mark, "")
    assert working in text


def test_the_corner_is_the_one_in_which_the_body_runs() -> None:
    said = " ".join(
        str(
            explain(
                solve(
                    parse("""
wall AB: along i
wall BC: along 112°
sphere P: velocity 5 at 40° to AB
P hits AB: e = 0.7
part a
find speed(P), angle(velocity(P), AB)
part b
P hits BC: e = 0.7
find speed(P)
""")
                ),
                check=True,
            )
        ).split()
    )
    assert "AB and BC meet at 180° − 112° = 68°." in said
    assert "angle between 𝐯₁ and BC ≈ 180° − 68° − 30.43° ≈ 81.57°" in said


def test_the_rest_of_a_wall_at_more_than_90_degrees_is_said() -> None:
    statement = """
wall W: along 130°
sphere P: velocity 5i - j
P hits W: e = 0.5
find speed(P)
"""
    said = " ".join(str(explain(solve(parse(statement)), check=True)).split())
    assert "W is at 180° − 130° = 50° to −𝐢. Components before the impact:" in said


def test_a_speed_is_kept_at_each_elastic_wall() -> None:
    statement = """
wall AB: along i
wall BC: along 120°
wall CA: along 60°
sphere P: velocity u at alpha to AB
P hits AB: e = 1
P hits BC: e = 1
given alpha < 60°
find speed(P)
"""
    said = " ".join(str(explain(solve(parse(statement)), check=True)).split())
    assert "BC is perfectly elastic, so P keeps its speed: speed of P after the second" in said
    assert "√" not in said


@pytest.mark.parametrize(
    ("corner", "path", "e", "last"),
    [(80, 50, "0.5", "≈ 64 − 18.58 ≈ 45.4 J"), (75, 55, "2/3", "≈ 64 − 30.99 ≈ 33.0 J")],
)
def test_components_after_a_corner_follow_for_a_path_above_45_degrees(
    corner: int, path: int, e: str, last: str
) -> None:
    """1 − cos² 40° below a root is the square of sin 40°; an energy stands as written."""
    statement = f"""
wall AB: along i
wall BC: along {corner}°
sphere P: mass 2, velocity 8 at {path}° to AB
P hits AB: e = {e}
part a
find speed(P), angle(velocity(P), AB)
part b
P hits BC: e = 0.4
find speed(P), total_energy_lost
"""
    said = " ".join(str(explain(solve(parse(statement)), check=True)).split())
    assert "does not follow" not in said
    assert last in said
