"""Workings of what is to be shown, of ranges, and of greatest and least values."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction
from functools import cache

import pytest
import sympy as sp

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.expression.tree import Degrees, rational
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.problem import Problem
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

OBLIQUE = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
"""
EQUAL = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i{e}
"""
WALL = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
"""
LINE = """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
sphere C: mass {c}m, at rest
A hits B: along i
B hits C: along i
"""

# Statement, and the last line of each item.
WORKINGS = {
    "a tangent": (
        OBLIQUE + "let beta = angle(velocity(A), i)\n"
        "show tan(beta) = (1 + k)tan(alpha)/(1 - k e)\ngiven k e < 1",
        ["tan(beta) = (1 + k) tan(alpha)/(1 - k e)"],
    ),
    "the square of a speed": (
        WALL + "show speed(P)^2 = u^2 (cos^2(alpha) + e^2 sin^2(alpha))",
        ["speed(P, 1)^2 = u^2 (cos^2(alpha) + e^2 sin^2(alpha))"],
    ),
    "a ratio of energies": (
        EQUAL.format(e="") + "show energy_lost/energy(0) = 1/2 (1 - e^2)cos^2(alpha)",
        ["energy_lost(1)/energy(0) = 1/2 (1 - e^2) cos^2(alpha)"],
    ),
    "a relation of letters": (
        OBLIQUE + "given velocity(A) perpendicular to velocity(A, 0)\n"
        "show tan^2(alpha) = (k e - 1)/(k + 1)\nshow k e > 1\nshow k > 1",
        ["tan^2(alpha) = (k e - 1)/(k + 1)", "k e > 1", "k > 1"],
    ),
    "a right angle": (
        EQUAL.format(e=", e = 1") + "show velocity(A) perpendicular to velocity(B)",
        ["velocity(A, 1) perpendicular to velocity(B, 1)"],
    ),
    "at rest": (
        (
            "sphere A: mass m, velocity 3u i\nsphere B: mass 2m, at rest\n"
            "A hits B: along i, e = 1/2\nshow A at rest"
        ),
        ["velocity(A, 1) = 0"],
    ),
    "one direction": (
        (
            "sphere A, B: mass m\nsphere A: velocity 4i + j\nsphere B: velocity -2i + 3j\n"
            "A hits B: along i, e = 1/6\nshow velocity(A) in the direction of velocity(B)"
        ),
        ["velocity(A, 1) = 1/3 velocity(B, 1)"],
    ),
    "they meet again": (
        (
            "sphere A, B, C: mass m\nsphere A: velocity u i\nsphere B, C: at rest\n"
            "A hits B: along i\nB hits C: along i\ngiven e < 1\nshow A and B collide again"
        ),
        ["v_1 > v_2"],
    ),
    "an angle less than another": (
        WALL + "show angle(velocity(P), W) <= alpha",
        ["angle(velocity(P, 1), W) <= alpha"],
    ),
    "an acute deflection": (
        EQUAL.format(e="") + "given e < 1\nshow deflection(A) < 90°",
        ["deflection(A, 1) < 90°"],
    ),
    "an angle after that is one before at most": (
        WALL + "find maximum of angle(velocity(P), W) over e",
        ["angle(velocity(P, 1), W) <= alpha"],
    ),
    "reversed": (
        OBLIQUE + "given along(velocity(A), i) < 0\npart a\ngiven k = 4\nfind range of e\n"
        "part b\nunknown e\nfind range of k",
        ["1/4 < e <= 1", "k > 1"],
    ),
    "turned through a right angle": (
        OBLIQUE + "given velocity(A) perpendicular to velocity(A, 0), k = 5\n"
        "find range of e, range of alpha",
        ["1/5 < e <= 1", "0° < alpha <= arctan(sqrt(6)/3)"],
    ),
    "ends by a coefficient": (
        WALL + "given alpha = 60°\nfind range of speed(P), range of impulse",
        ["u/2 <= speed(P, 1) <= u", "sqrt(3) m u/2 <= impulse(1) <= sqrt(3) m u"],
    ),
    "no further impact": (
        LINE.format(c="1/2 ") + "given A and B do not collide again\nfind range of e",
        ["(13 - sqrt(165))/2 <= e <= 1"],
    ),
    "two conditions": (
        (
            "sphere A: mass m, velocity 3u i\nsphere B: mass k m, velocity -u i\n"
            "A hits B: along i, e = 1/2\n"
            "given along(velocity(A), i) < 0, along(velocity(B), i) > 0\nfind range of k"
        ),
        ["1 < k < 5"],
    ),
    "to three figures": (
        (
            "wall W: along 60°\nsphere P: mass m, velocity u i\nP hits W: e = 1/2\n"
            "show speed(P) = 0.661u to 3 s.f."
        ),
        ["speed(P, 1) ≈ 0.661u"],
    ),
    "a letter for an expression": (
        WALL + "let R = energy(P)/energy(P, 0)\nshow R = 1 - (1 - e^2)sin^2(alpha)",
        ["R = 1 - (1 - e^2) sin^2(alpha)"],
    ),
    "a deflection of more than 90°": (
        WALL + "given deflection(P) > 90°, e = 1/2\nfind range of tan(alpha)",
        ["tan(alpha) > sqrt(2)"],
    ),
    "a deflection between two": (
        OBLIQUE + "given alpha = 45°, k = 2\nunknown e\nfind range of deflection(A)",
        ["arctan(1/2) <= deflection(A, 1) <= arctan(2)"],
    ),
    "the greatest deflection": (
        EQUAL.format(e=", e = 1/2") + "find maximum of deflection(A) over alpha",
        ["deflection(A, 1) <= arctan(3/4)"],
    ),
    "the best mass between": (
        (
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
            "sphere C: mass 9m, at rest\nA hits B: along i\nB hits C: along i\n"
            "find maximum of speed(C) over k"
        ),
        ["speed(C, 2) <= (1 + e)^2 u/16"],
    ),
    "an end of e": (
        WALL + "find minimum of speed(P) over e, maximum of impulse over e",
        ["speed(P, 1) >= u cos(alpha)", "impulse(1) <= 2m u sin(alpha)"],
    ),
    "a square completed": (
        (
            "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, at rest\nA hits B: along i\n"
            "find minimum of speed(A) over e"
        ),
        ["speed(A, 1) >= sqrt(3) u/2"],
    ),
}


@cache
def planned(text: str) -> tuple[Problem, Derivation]:
    problem = parse(text)
    return problem, plan(solve(problem))


def complaints(problem: Problem, derivation: Derivation) -> list[str]:
    return [str(each) for each in follow(derivation, Oracle(roles(problem)))]


@pytest.mark.parametrize("name", WORKINGS)
def test_follower_accepts_and_last_lines_say_what_is_asked(name: str) -> None:
    text, ends = WORKINGS[name]
    problem, derivation = planned(text)
    assert complaints(problem, derivation) == []
    assert [write_relation(each.answer) for each in derivation.items] == ends


@pytest.mark.parametrize("k", [Fraction(3, 2), Fraction(2), Fraction(7, 3), Fraction(5)])
def test_ends_of_a_range_are_those_of_the_solution(k: Fraction) -> None:
    text = OBLIQUE + f"given along(velocity(A), i) < 0, k = {k}\nfind range of e"
    problem = parse(text)
    solution = solve(problem)
    derivation = plan(solution)
    assert complaints(problem, derivation) == []
    (end,) = derivation.items
    low, high = end.answer.only
    interval = solution.parts[None].items[0].exact
    assert (low.sign, high.sign) == ("<", "<=")
    assert interval == sp.Interval.Lopen(sp.Rational(k.denominator, k.numerator), 1)
    assert low.left == rational(1 / k)


def test_what_is_false_is_said_in_no_line() -> None:
    _, derivation = planned(OBLIQUE + "show speed(B) < u/2")
    said = [
        write_relation(e.relation) for e in derivation.lines if isinstance(e.relation, Relation)
    ]
    assert said
    assert "speed(B, 1) < u/2" not in said


def test_a_bound_that_is_only_approached_is_no_greatest_value() -> None:
    text = WALL + "given e < 1\nfind maximum of energy_lost/energy(0) over alpha"
    problem, derivation = planned(text)
    assert follow(derivation, Oracle(roles(problem))) == ()
    last = derivation.line(derivation.items[0].line)
    assert last is not None
    assert last.move.record == "approached"
    assert last.relation.only[0].sign == "<"  # type: ignore[union-attr]
    assert "→ 1 − e² as α → 90°, but α < 90°, so there is no greatest value" in _printed(text)


def test_what_is_reached_is_not_approached_and_what_is_inside_no_end() -> None:
    problem, derivation = planned(WALL + "given e < 1\nfind maximum of energy_lost over alpha")
    *above, last = derivation.lines
    for record in ("greatest", "least"):
        other = replace(last, move=replace(last.move, record=record))
        wrong = replace(derivation, lines=(*above, other))
        assert "does-not-follow" in [e.reason for e in follow(wrong, Oracle(roles(problem)))]
    place = derivation.line(last.premises[1])  # type: ignore[arg-type]
    assert place is not None
    (unless,), then = place.relation.options  # type: ignore[union-attr]
    inside = replace(unless, right=Degrees(Fraction(60)))
    told = replace(place, relation=replace(place.relation, options=((inside,), then)))  # type: ignore[type-var]
    lines = tuple(told if each.number == place.number else each for each in derivation.lines)
    wrong = replace(derivation, lines=lines)
    assert len(follow(wrong, Oracle(roles(problem)))) == 2


def test_a_greatest_value_says_where_it_is_reached() -> None:
    problem, derivation = planned(WORKINGS["the best mass between"][0])
    last = derivation.line(derivation.items[0].line)
    assert last is not None
    bound, place = (derivation.line(ref) for ref in last.premises)  # type: ignore[arg-type]
    assert last.move.record == "greatest"
    assert bound is not None
    assert bound.relation == last.relation
    assert place is not None
    assert write_relation(place.relation).startswith("k != 3 or ")  # type: ignore[arg-type]
    assert complaints(problem, derivation) == []


def test_every_line_is_on_the_way() -> None:
    problem, derivation = planned(WORKINGS["a relation of letters"][0])
    cited = {ref for line in derivation.lines for ref in line.premises}
    ends = {each.line for each in derivation.items}
    assert all(line.number in cited | ends for line in derivation.lines)
    assert [line.number for line in derivation.lines] == list(range(1, len(derivation.lines) + 1))
    assert complaints(problem, derivation) == []


def altered(derivation: Derivation, number: int, text: str) -> Derivation:
    """A derivation in which a line says something else."""
    relation = read_relation(text, {"A": "sphere", "B": "sphere", "P": "sphere", "W": "wall"})
    lines = tuple(
        replace(each, relation=relation) if each.number == number else each
        for each in derivation.lines
    )
    return replace(derivation, lines=lines)


@pytest.mark.parametrize("decimal", ["0.662u", "0.66u^2", "0.661"])
def test_a_wrong_decimal_before_letters_is_refused(decimal: str) -> None:
    problem, derivation = planned(WORKINGS["to three figures"][0])
    last = derivation.items[0].line
    wrong = altered(derivation, last, f"speed(P, 1) ≈ {decimal}")
    assert f"line {last}: does not follow" in complaints(problem, wrong)


def test_an_angle_is_reached_where_its_tangent_is_that_of_the_bound() -> None:
    problem, derivation = planned(WORKINGS["the greatest deflection"][0])
    last = derivation.line(derivation.items[0].line)
    assert last is not None
    place = last.premises[1]
    assert isinstance(place, int)
    wrong = altered(derivation, place, "tan(alpha) != 1 or tan(deflection(A, 1)) = 3/5")
    assert complaints(problem, wrong) == [f"line {last.number}: does not follow"]


def test_at_rest_is_said_of_no_other_velocity() -> None:
    problem, derivation = planned(
        WORKINGS["at rest"][0]
        .replace("2m, at rest", "3m, at rest")
        .replace("show A at rest", "find velocity(A)")
    )
    last = derivation.items[0].line
    wrong = altered(derivation, last, "velocity(A, 1) = 0")
    assert f"line {last}: does not follow" in complaints(problem, wrong)


# --- reasons -------------------------------------------------------------------------------------

SAID = {
    "what grows with a letter": (
        OBLIQUE + "find maximum of speed(B) over e",
        "increases with e, α is acute and e ≤ 1",
    ),
    "the square of a coefficient": (
        WALL + "find maximum of speed(P) over e",
        "= u√(cos²α + e² sin²α) speed of P ≤ u, as e² ≤ 1 greatest",
    ),
    "an energy without the square": (
        OBLIQUE.replace("along i", "along i, e = 1") + "find minimum of energy(A) over k",
        "≥ ½mu² sin²α, as ((1 − k)u cos α/(1 + k))² ≥ 0",
    ),
}


def _printed(statement: str) -> str:
    problem = parse(statement)
    return " ".join(to_text(explanation_of(plan(solve(problem)), problem)).split())


@pytest.mark.parametrize("name", SAID)
def test_the_reason_of_a_bound_is_said(name: str) -> None:
    statement, words = SAID[name]
    assert words in _printed(statement)


def test_what_grows_is_called_as_it_stands_in_the_line_above() -> None:
    text = _printed(
        "wall W: along i\nsphere P: mass m, velocity u at 30° to W\nP hits W\nfind range of impulse"
    )
    line, reason = text.split(" ≤ magnitude of the impulse", 1)
    grows = reason.split(" as ")[1].split(" increases")[0]
    assert line.count(f"= {grows}") == 1


def test_the_greatest_value_is_said_once() -> None:
    text = _printed(
        OBLIQUE.replace("along i", "along i, e = 1") + "find minimum of energy(A) over k"
    )
    assert text.count("when k = 1") == 1


def test_an_angle_has_its_letter_before_its_tangent() -> None:
    derivation = plan(
        solve(parse(EQUAL.format(e=", e = 1/3") + "find maximum of deflection(A) over alpha"))
    )
    lines = [each for each in derivation.lines if each.move.record == "sum-of-angles"]
    assert [write_relation(each.relation)[:10] for each in lines] == ["tan(delta)"]


# --- walls with ends ------------------------------------------------------------------------------

CORNER = """
point O: (0, 0)
wall OX: from O to ({x}, 0)
wall OY: from O to (0, {y})
sphere P: at {at}, velocity {velocity}
P hits OX: e = {e}
P hits OY
find range of {asked}
"""


@pytest.mark.parametrize(
    ("corner", "last"),
    [
        (("6", "1/3", "(4, 3)", "-i - j", "e", "e"), "0 < e < 1/3"),
        (("5d", "2d", "(3d, d)", "-k u i - u j", "1/2", "k"), "3/5 < k < 3"),
        (("4a", "2a", "(2a, a)", "u at alpha from -i", "1/3", "cot(alpha)"), ""),
    ],
)
def test_where_a_wall_is_hit_bounds_a_letter(corner: tuple[str, ...], last: str) -> None:
    x, y, at, velocity, e, asked = corner
    statement = CORNER.format(x=x, y=y, at=at, velocity=velocity, e=e, asked=asked)
    problem = parse(statement)
    solution = solve(problem)
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert any("within 2" in each.premises for each in derivation.lines)
    if last:
        assert write_relation(derivation.items[-1].answer) == last


@pytest.mark.parametrize(
    ("statement", "premise", "last"),
    [
        (
            (
                "sphere A: mass m, velocity c i\nsphere B: mass m, velocity 3i + j\n"
                "A hits B: along i, e = 1/3\ngiven c > 0\nfind range of c"
            ),
            "approach 1",
            "c > 3",
        ),
        (
            (
                "wall V: along i\nwall W: along j\nsphere P: velocity u at 60° to V\n"
                "P hits V\nP hits W: e = 3e\nfind range of e, speed(P)"
            ),
            "most 2",
            "0 <= e <= 1/3",
        ),
        (
            (
                "wall W: along i\nsphere P: velocity u at beta to W\ngiven tan(beta) = 5/12\n"
                "P hits W: e = 1/2\nfind speed(P)\nshow beta < 30°"
            ),
            "acute: beta",
            "beta < 30°",
        ),
        (
            WALL + "given angle(velocity(P), W) = 30°\npart a\nfind tan(alpha)\n"
            "part b\nunknown e\nfind range of alpha",
            "e <= 1",
            "30° <= alpha < 90°",
        ),
    ],
)
def test_what_has_to_be_bounds_a_letter(statement: str, premise: str, last: str) -> None:
    problem = parse(statement)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert last in [write_relation(each.answer) for each in derivation.items]
    assert any(premise in each.premises for each in derivation.lines)


# --- speeds compared ------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (
            (
                "sphere A: mass m, velocity u at 45°\nsphere B: mass k m, at rest\n"
                "A hits B: along i, e = 1/2\ngiven speed(B) > speed(A)\nfind range of k"
            ),
            ["(speed of B)² =", "(speed of A)² ="],
        ),
        (
            EQUAL.format(e=", e = 1/2") + "given speed(A) < speed(B)\nfind range of tan(alpha)",
            ["(speed of B)² =", "tan²α < ½"],
        ),
        (
            (
                "wall W: along i\nsphere P: velocity u at 45° to W\nP hits W\n"
                "part a\nfind speed(P)\npart b\ngiven speed(P) < 5/6 u\nfind range of e"
            ),
            ["e² < 7/18"],
        ),
    ],
)
def test_speeds_are_compared_by_their_squares(statement: str, lines: list[str]) -> None:
    problem = parse(statement)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    text = _printed(statement)
    for each in lines:
        assert each in text


# --- where a greatest value is reached ------------------------------------------------------------


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        (
            (
                "sphere A: mass m, velocity 5u at alpha\n"
                "sphere B: mass m, velocity 12u at 90° - alpha from -i\n"
                "A hits B: along i, e = 1\nfind maximum of impulse over alpha"
            ),
            "5 cos α + 12 sin α = 13 cos(α − arctan(12/5)) ≤ 13",
        ),
        (
            (
                "wall W: along theta\nsphere P: mass m, velocity u i\nP hits W: e = 1/2\n"
                "find maximum of across(velocity(P), i) over theta"
            ),
            "as sin 2θ ≤ 1",
        ),
        (
            OBLIQUE + "given e k < 1\nfind maximum of tan(deflection(A)) over alpha",
            "so tan α = √(1 − ek)/√(1 + k)",
        ),
    ],
)
def test_a_place_may_be_told_by_an_angle_or_a_root(statement: str, words: str) -> None:
    problem = parse(statement)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert words in _printed(statement)


def test_several_coefficients_are_bounded_by_their_ranges() -> None:
    problem = parse(
        "wall L: along i\nwall M: along i\nsphere P: velocity u at alpha to L\n"
        "P hits L: e = e1\nP hits M: e = e2\ngiven e1 > 0, e2 > 0\n"
        "show P hits L again\nfind range of speed(P)"
    )
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    said = [each.relation for each in derivation.lines if isinstance(each.relation, Relation)]
    assert {"e_1 e_2 > 0", "u cos(alpha) < speed(P, 2) <= u"} <= set(map(write_relation, said))


# --- what is shown -------------------------------------------------------------------------------

SHOWN = {
    "in the order in which it is printed": (
        WALL + "show impulse = m u sin(alpha) (e + 1)",
        "= (mu sin α)(e + 1) (as required)",
    ),
    "what is found is shown in the same line": (
        OBLIQUE + "find speed(B)\nshow speed(B) = (1 + e) u cos(alpha)/(1 + k)",
        "speed of B = (1 + e)u cos α/(1 + k) (as required)",
    ),
    "an angle by its tangent": (
        OBLIQUE + "given deflection(A) = 90°\nshow alpha < 45°",
        "tan α < 1",
    ),
    "who is the faster by the values": (
        (
            "sphere A: mass 3m, velocity u i\nsphere B: mass m, at rest\n"
            "sphere C: mass 2m, at rest\nA hits B: along i\n"
            "B hits C: along i\nshow A and B collide again"
        ),
        "as e ≥ 0",
    ),
    "squares of two speeds": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
            "A hits B: along i, e = 1/3\nshow speed(A)^2 + speed(B)^2 < u^2"
        ),
        "V_A² + V_B² = (",
    ),
    "a ratio by its quotient": (
        WALL + "show energy_lost/energy(0) = (1 - e^2) sin^2(alpha)",
        "/(½mu²)",
    ),
    "one velocity is a multiple of another": (
        (
            "sphere A: mass m, velocity 2u at alpha\n"
            "sphere B: mass 2m, velocity u at alpha from -i\nA hits B: along i\n"
            "show velocity(A) parallel to velocity(B)"
        ),
        "So 𝐯_A is parallel to 𝐯_B, as required.",
    ),
}


@pytest.mark.parametrize("name", SHOWN)
def test_what_is_shown_is_reached_step_by_step(name: str) -> None:
    statement, words = SHOWN[name]
    problem = parse(statement)
    assert follow(plan(solve(problem)), Oracle(roles(problem))) == ()
    assert words in _printed(statement)


def test_a_claim_of_the_size_of_a_vector_has_a_working() -> None:
    """|mu − Mv| ≤ mu + Mv: with the vector itself nothing is compared."""
    text = """
sphere A: mass m, velocity u i
sphere B: mass M, velocity -v i
A hits B: along i
show abs(momentum) <= m u + M v
"""
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "|total momentum| = |Mv − mu|" in shown
    assert "|total momentum| ≤ mu + Mv (as required)" in shown


def test_a_sum_with_a_deflection_is_in_degrees() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, velocity u at 180° - alpha
A hits B: along i
show deflection(A) + 2 alpha <= 180°
"""
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "δ + 2α = 180° + α − arctan((tan α)/e)" in shown


def test_an_angle_asked_above_all_impacts_is_no_right_one() -> None:
    """A is not deflected yet, and what is asked below the impact is worked out all the same."""
    text = "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
    text += "show tan(deflection(A)) <= 1\nA hits B: along i\n"
    text += "show energy_lost/energy(0) <= 1/2 m u^2"
    assert "fraction lost = ½(1 − e²) cos²α" in to_text(explain(solve(parse(text))))


def test_an_angle_of_an_earlier_part_is_open_in_a_later_one() -> None:
    """With tan α = e the loss is mu²(1 − e²)/(1 + e²), or mu²(1 − 2 sin²α)."""
    text = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: velocity u at 180° - alpha
A hits B: along i
part a
find velocity(A), velocity(B)
part b
given velocity(A) perpendicular to velocity(B)
find alpha
part c
given velocity(A) perpendicular to velocity(B)
unknown e
find range of alpha
find maximum of energy_lost over e
"""
    solution = solve(parse(text))
    assert "mu²(1 − 2 sin²α)" in to_text(explain(solution))
