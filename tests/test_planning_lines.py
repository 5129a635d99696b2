"""Lines of centres and walls whose direction is unknown; momenta that are given; open masses.

Each working is followed line by line, and its answers are those of the solver.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
from workings import planned

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.following.trials import on_either_side
from restitution.explaining.lines.derivation import Derivation, Link, Relation
from restitution.expression.tree import Negate
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.solving.story.letters import roles
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

STATEMENTS = {
    "an angle by the energy that is lost": """
sphere A: mass 3, velocity 4i
sphere B: mass 1, velocity -2i
A hits B: e = 1/2
given energy_lost = 6
find angle(line_of_centres, i), velocity(B), impulse
""",
    "an angle by the speed of the sphere that was at rest": """
sphere A: mass 2, velocity 5i
sphere B: mass 3, at rest
A hits B: e = 2/3
given speed(B) = 2
find angle(line_of_centres, i), velocity(A), direction(B), impulse(B)
""",
    "equal elastic spheres with one speed": """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: e = 1
given speed(A) = speed(B)
find angle(line_of_centres, i), direction(A), direction(B)
""",
    "an angle on either side that is given": """
sphere A: mass 3m, velocity 2u i
sphere B: mass m, at rest
A hits B: e = 1/3
given angle(line_of_centres, i) = 60°
find direction(B), speed(B)
""",
    "the line by a speed and a deflection": """
sphere A: mass 3, velocity 4i
sphere B: mass 5, at rest
A hits B
given deflection(A) = 60°, speed(A) = 2, direction(A) > 0
find line_of_centres, e, direction(B)
""",
    "a speed and a deflection to either side": """
sphere A: mass 1, velocity 2u i
sphere B: mass 3, at rest
A hits B
given deflection(A) = 90°, speed(A) = u/2
find e, direction(B), speed(B), line_of_centres
""",
    "a wall at an angle on either side that is given": """
wall W
sphere P: mass 2, velocity 4i
P hits W: e = 1/2
given angle(i, W) = 60°
find speed(P), velocity(P), direction(W), impulse
""",
    "a wall at an unknown angle on either side": """
wall W
sphere P: mass 2, velocity 4i
P hits W: e = 1/2
given speed(P) = 3
find angle(W, i), direction(P), velocity(P), impulse(P), direction(W)
""",
    "a line of centres typed against the approach": """
sphere A: mass 1, velocity 2i - 6j
sphere B: mass 2, velocity i
A hits B: along j, e = 1/2
find line_of_centres, along(velocity(A), line_of_centres), across(velocity(B), line_of_centres)
""",
    "a deflection by an equal sphere at rest": """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: e = 1/2
given deflection(A) = 30°
find tan(angle(line_of_centres, i))
""",
    "squares of speeds": """
sphere A, B: mass m
sphere A: velocity u i
sphere B: at rest
A hits B: along phi, e = 1
show speed(A)^2 + speed(B)^2 = u^2
""",
    "a wall by the direction after it": """
wall W
sphere P: mass 2, velocity 6i + 2j
P hits W: e = 1/2
given direction(P) = 135°
find direction(W), speed(P), impulse(P)
""",
    "a wall in letters": """
wall W
sphere P: velocity 3u i
P hits W: e = 1/2
given velocity(P) parallel to j
find velocity(P), direction(W)
""",
    "both velocities and the line by one direction": """
sphere A: mass 1, velocity 6i + 2j
sphere B: mass 2, at rest
A hits B: e = 1/2
given velocity(A) parallel to j
find velocity(A), velocity(B), line_of_centres
""",
    "masses by the total momentum": """
sphere A: mass p, velocity 4i + j
sphere B: mass q, velocity -2i + 3j
A hits B: along i, e = 1/2
given momentum = 2i + 11j
find p, q, velocity(A)
""",
    "a mass by an impulse as a vector": """
wall W
sphere P: mass M, velocity 5i + j
P hits W
given impulse(P) = -12i + 4j, velocity(P) = -i + 3j
find M, e, direction(W)
""",
    "a mass by an impulse and a speed": """
wall W: along i + j
sphere P: mass M, velocity 10i
P hits W
given impulse(P) = -9i + 9j, speed(P) = 2 sqrt(17)
find M, e
""",
    "a mass by momentum as vectors": """
sphere A: mass 2, velocity 6i + 2j
sphere B: mass M, velocity i + j
A hits B
given velocity(A) = 2i + 4j, velocity(B) = 3i
find M, e, line_of_centres
""",
    "a velocity by its momentum": """
sphere A: mass 2, velocity x i + y j
sphere B: mass 5, velocity -i + 3j
A hits B: along j, e = 1/5
given momentum(A) = 8i + 4j
find x, y, impulse(A)
""",
}


def printed(name: str) -> str:
    problem, derivation = planned(STATEMENTS[name])
    return to_text(explanation_of(awarded(derivation), problem))


@pytest.mark.parametrize("name", STATEMENTS)
def test_the_follower_accepts(name: str) -> None:
    planned(STATEMENTS[name])


def test_the_angle_is_introduced_as_acute_and_both_sides_are_told() -> None:
    text = printed("an angle by the speed of the sphere that was at rest")
    assert "Let θ be the acute angle between the line of centres and 𝐢." in " ".join(text.split())
    assert "The line of centres may be on either side of 𝐢, and the other figure" in text
    assert "≈ 53.1° or −53.1°" in text
    assert "B was at rest, so it moves along the line of centres:" in " ".join(text.split())


def test_one_side_alone_is_refused() -> None:
    problem, derivation = planned(STATEMENTS["an angle on either side that is given"])
    for number, line in enumerate(derivation.lines):
        if line.move.record == "either-side":
            assert isinstance(line.relation, Relation)
            first, (second,) = line.relation.options
            wrong = Link(second.left, "=", Negate(second.right))
            changed = replace(line, relation=Relation((first, (wrong,))))
            lines = (*derivation.lines[:number], changed, *derivation.lines[number + 1 :])
            broken = replace(derivation, lines=lines)
            assert follow(broken, Oracle(roles(problem)))
            return
    raise AssertionError("no line says that there are two sides")


@pytest.mark.parametrize(
    ("body", "given", "open_"),
    [
        ("velocity u i", "speed(A) = u/2", True),
        ("velocity u i", "deflection(A) = 30°", True),
        ("velocity u i", "direction(A) = 30°", False),
        ("velocity u i", "velocity(A) parallel to i + j", False),
        ("velocity u i", "along(velocity(A), j) = u/4", False),
        ("velocity u i + u j", "speed(A) = u/2", False),
        ("velocity u at 30°", "speed(A) = u/2", False),
        ("velocity u i, at (0, 0)", "speed(A) = u/2", False),
    ],
)
def test_a_side_is_open_where_nothing_tells_it(body: str, given: str, open_: bool) -> None:
    problem = parse(
        f"sphere A: mass m, {body}\nsphere B: mass m, at rest\nA hits B: e = 1/2\n"
        f"given {given}\nfind speed(B)"
    )
    start = Derivation(facts_of(problem), (), (), events_of(problem))
    assert on_either_side(start) == (frozenset({1}) if open_ else frozenset())


def test_the_side_of_a_deflection_is_told_or_taken() -> None:
    text = printed("the line by a speed and a deflection")
    assert (
        "𝐯_A = 2 cos 60° 𝐢 + 2 sin 60° 𝐣 = (𝐢 + √3 𝐣) m s⁻¹,"
        " as the angle from 𝐢 to 𝐯_A is positive" in " ".join(text.split())
    )
    text = printed("a speed and a deflection to either side")
    assert "the line of centres is parallel to 4𝐢 + 𝐣 or 4𝐢 − 𝐣" in text
    assert "W may slope to either side of 𝐢, and the other figure" in printed(
        "a wall at an unknown angle on either side"
    )


def test_the_sense_of_a_line_that_is_asked_is_that_of_the_statement() -> None:
    text = printed("a line of centres typed against the approach")
    assert "unit vector along the line of centres = −𝐣" in text
    assert "component of 𝐯_A along −𝐣 = " in text


def test_newtons_law_takes_scalar_products_with_the_change_of_velocity() -> None:
    text = printed("a wall by the direction after it")
    assert "Newton's experimental law, by scalar products with this vector:" in text
    assert "the normal to W is parallel to" in text


def test_a_mass_by_vectors_is_compared_component_by_component() -> None:
    text = printed("a mass by momentum as vectors")
    assert "2(6𝐢 + 2𝐣) + M(𝐢 + 𝐣) = 2(2𝐢 + 4𝐣) + M × 3𝐢" in text
