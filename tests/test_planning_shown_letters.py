"""What the facts make of a letter, shown in the printed form: values, ratios, powers, equations."""

from __future__ import annotations

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Relation
from restitution.explaining.lines.notation import write_relation
from restitution.language.reading import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: mass 1/2, velocity {velocity}\nP hits W{e}\n"
BALL = WALL.format(velocity="6 at alpha to W", e="")
PAIR = (
    "sphere A: mass 2m, velocity {velocity}\nsphere B: mass {mass}, {motion}\n"
    "A hits B: along i{e}\n"
)
NUMBERS = "sphere A: mass 2, velocity 4i + 3j\nsphere B: mass 5, velocity -2i\nA hits B: along i\n"
VECTORS = "sphere A: mass 2, velocity 3i + j\nsphere B: mass 3, velocity -i + 2j\nA hits B\n"
PARALLEL = (
    "wall AB: along i\nwall CD: along i\nsphere P: velocity v at alpha to AB\n"
    "P hits AB: e = 2/3\nP hits CD: e = 2/3\n"
)
HEAVIER = "sphere S: mass m, velocity U at alpha\nsphere T: mass M, at rest\nS hits T: along i\n"
MEETING = (
    "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, velocity u at 180° - theta\n"
    "A hits B: along i\n"
)
EQUAL = "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"


# Each with its last line, worked out by hand from the laws.
CASES = {
    "a coefficient by the direction after a wall": (
        BALL + "given tan(alpha) = 4/3, tan(angle(velocity(P), W)) = 1/3\nshow e = 1/4",
        "e = 1/4",
    ),
    "a coefficient by the speed after a wall": (
        WALL.format(velocity="6i - 3j", e="") + "given speed(P) = 6.5\nshow e = 5/6",
        "e = 5/6",
    ),
    "an angle by a deflection": (
        WALL.format(velocity="u at alpha to W", e=": e = 1/3")
        + "given deflection(P) = 90°\nshow alpha = 60°",
        "alpha = 60°",
    ),
    "a tangent, of which the cosine is found": (
        WALL.format(velocity="u at alpha to W", e=": e = 1/3")
        + "given speed(P) = u/2\nshow tan(alpha) = 3 sqrt(15)/5",
        "tan(alpha) = 3sqrt(15)/5",
    ),
    "a mass in terms of another": (
        PAIR.format(velocity="3u i", mass="M", motion="at rest", e=", e = 1/2")
        + "given velocity(B) = 2u i\nshow M = 5/2 m",
        "M = 5/2 m",
    ),
    "a square as a decimal, and then its root": (
        NUMBERS + "given energy_lost = 18\nshow e^2 = 0.3",
        "e^2 = 0.3",
    ),
    "the square of a sine": (
        WALL.format(velocity="8 at theta to W", e=": e = 1/2")
        + "given energy_lost = 3\nshow sin(theta)^2 = 1/4",
        "sin^2(theta) = 1/4",
    ),
    "a quadratic in a tangent": (
        EQUAL
        + "A hits B: along i, e = 1/2\ngiven tan(deflection(A)) = 3/4\n"
        + "show 4tan(alpha)^2 - 4tan(alpha) + 1 = 0",
        "4tan^2(alpha) - 4tan(alpha) + 1 = 0",
    ),
    "the tangent of half an angle, for which the working has a letter": (
        PARALLEL + "given angle(velocity(P), CD) = alpha/2\nshow tan(alpha/2) = 1/3",
        "tan(alpha/2) = 1/3",
    ),
    "a line of centres by the change of a velocity, in the other sense": (
        VECTORS + "given velocity(A) = i + 3j\nshow line_of_centres parallel to -i + j",
        "line_of_centres(1) parallel to -i + j",
    ),
    "the angle to a line of centres, of masses that are given as one heavier": (
        HEAVIER
        + "let beta = angle(velocity(S), line_of_centres)\ngiven m > e M\n"
        + "show tan(beta) = (m + M) tan(alpha)/(m - e M)",
        "tan(beta) = (m + M) tan(alpha)/(m - e M)",
    ),
    "a component, without the coefficient that a fact ties to an angle": (
        MEETING
        + "given along(velocity(B), i) = 0\n"
        + "show along(velocity(A), i) = -1/2 u (4 cos(theta) - 1)",
        "v = -1/2 u (4cos(theta) - 1)",
    ),
    # v = (1 - ek)u cos(alpha)/(1 + k) is zero.
    "a product, read off before a letter of it is solved": (
        EQUAL.replace("A, B: mass m", "A: mass m").replace("sphere B: ", "sphere B: mass k m, ")
        + "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B)\nshow e k = 1",
        "e k = 1",
    ),
    "a coefficient by an impulse": (
        PAIR.format(velocity="2u i + u j", mass="m", motion="velocity -u i", e="")
        + "given impulse = 3 m u\nshow e = 1/2",
        "e = 1/2",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_the_facts_make_of_a_letter_is_shown(name: str) -> None:
    text, last = CASES[name]
    problem = parse(text)
    derivation = plan(solve(problem))  # raises where there is no plan
    assert not follow(derivation, Oracle(roles(problem)))
    (end,) = derivation.items
    assert write_relation(end.answer) == last
    (link,) = end.answer.only
    line = derivation.line(end.line).relation
    assert isinstance(line, Relation)
    assert (line.only[0].left, line.only[-1].right) == (link.left, link.right)


@pytest.mark.parametrize(
    ("given", "asked", "line", "shown"),
    [
        ("energy_lost = 1/4 energy(0)", "1/(3 - 4e^2)", "4e²k = 3k − 1 DM1", "k = 1/(3 − 4e²)"),
        ("velocity(A) = -1/4 u i", "5/(4e - 1)", "4ek = 5 + k DM1", "k = 5/(4e − 1)"),
    ],
)
def test_an_equation_in_which_the_letter_stands_twice_is_multiplied_out(
    given: str, asked: str, line: str, shown: str
) -> None:
    text = f"""
sphere A: mass m, velocity u i
sphere B: mass k m, at rest
A hits B: along i, e = e
given {given}
find e in terms of k
show k = {asked}
"""
    printed = to_text(explain(solve(parse(text)), check=True))
    rows = [" ".join(row.split()) for row in printed.splitlines()]
    (last,) = [n for n, row in enumerate(rows) if shown in row and "required" in row]
    assert rows[last - 1] == line
