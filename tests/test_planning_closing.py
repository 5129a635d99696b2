"""Equations that close a working: shapes of one and two unknowns, roots, what excludes them."""

from __future__ import annotations

import random
from dataclasses import replace
from fractions import Fraction
from functools import cache

import pytest
import sympy as sp
from answers import _differs

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.expression.writing import write_expression
from restitution.language.reading import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles


@cache
def planned(text: str) -> tuple[Solution, Derivation]:
    """A statement solved, and its working; the follower and the answers are asked first."""
    problem = parse(text)
    solution = solve(problem)
    derivation = plan(solution)
    assert not follow(derivation, Oracle(roles(problem)))
    ends = list(dict.fromkeys(each.item for each in derivation.items))
    for (part, item), name in zip(solution.items(), ends, strict=True):
        options = [
            links for end in derivation.items if end.item == name for links in end.answer.options
        ]
        told = " ; ".join(write_expression(links[-1].right) for links in options)
        assert _differs(item, told, dict(part.roles)) is None, told
    return solution, derivation


def moves(derivation: Derivation) -> list[str]:
    """The moves of a working, with the names of identities."""
    return [
        f"identity {each.move.record}" if each.move.id == "identity" else each.move.id
        for each in derivation.lines
    ]


def lines(derivation: Derivation, move: str) -> list[Line]:
    """The lines of a move."""
    return [each for each in derivation.lines if each.move.id == move]


def said(derivation: Derivation) -> list[str]:
    """What the lines of a working say, but for those that introduce a letter."""
    return [write_relation(e.relation) for e in derivation.lines if e.move.id != "let"]  # type: ignore[arg-type]


WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W"
PAIR = "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\nA hits B: along i"


# --- one unknown ----------------------------------------------------------------------------------


def test_squares_of_sine_and_cosine_leave_one_of_them() -> None:
    _, derivation = planned(f"{WALL}: e = 1/5\ngiven energy(P) = 1/2 energy(P, 0)\nfind sin(alpha)")
    assert moves(derivation)[-4:] == ["identity pythagoras", "rearrange", "roots", "reject"]
    assert said(derivation)[-1] == "sin(alpha) = 5sqrt(3)/12"
    assert lines(derivation, "reject")[0].premises[1:] == ("acute: alpha",)


def test_a_tangent_that_is_asked_is_found_from_squares() -> None:
    _, derivation = planned(f"{WALL}: e = 1/5\ngiven speed(P) = 1/2 u\nfind tan(alpha)")
    assert "identity pythagoras" in moves(derivation)
    assert "tan^2(alpha)" in said(derivation)[-3]


def test_both_squares_of_one_degree_are_divided() -> None:
    _, derivation = planned(
        f"{PAIR}\ngiven velocity(A) perpendicular to velocity(A, 0), e = 3/4\n"
        "find tan(alpha), alpha"
    )
    assert "identity pythagoras" not in moves(derivation)
    assert any("tan^2(alpha) =" in each for each in said(derivation))


@pytest.mark.parametrize("e", ["1/4", "1/5", "1/3"])
def test_an_angle_is_halved(e: str) -> None:
    _, derivation = planned(f"{WALL}: e = {e}\ngiven angle(velocity(P), W) = alpha/2\nfind alpha")
    found = moves(derivation)
    assert found[found.index("identity half-angle") :] == [
        "identity half-angle",
        "cancel",
        "roots",
        "reject",
        "inverse",
    ]


def test_an_angle_is_doubled() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: velocity u at 2theta to W\nP hits W: e = 1/3\n"
        "given angle(velocity(P), W) = theta, theta < 45°\nfind theta"
    )
    assert "tan(theta) = 1/3 (2tan(theta)/(1 - tan^2(theta)))" in said(derivation)
    assert said(derivation)[-1] == "theta = 30°"


def test_a_difference_of_angles_is_written_in_tangents() -> None:
    _, derivation = planned(
        f"{WALL}: e = 1/4\nlet beta = angle(velocity(P), W)\n"
        "given alpha - beta = arctan(3/5)\nfind tan(alpha)"
    )
    assert "identity sum-of-angles" in moves(derivation)
    assert said(derivation)[-1] in (
        "tan(alpha) = 4 or tan(alpha) = 1",
        "tan(alpha) = 1 or tan(alpha) = 4",
    )


def test_angles_that_make_a_right_angle() -> None:
    _, derivation = planned(
        f"{WALL}: e = 1/3\nlet beta = angle(velocity(P), W)\ngiven beta = 90° - alpha\nfind alpha"
    )
    assert "identity complement" in moves(derivation)
    assert said(derivation)[-1] == "alpha = 60°"


def test_the_tangent_of_an_inverse_tangent_is_its_number() -> None:
    _, derivation = planned(
        f"{WALL}\ngiven tan(alpha) = 2, angle(velocity(P), W) = arctan(3/2)\nfind e"
    )
    assert not any("arctan" in each for each in said(derivation))


# --- what excludes a root -------------------------------------------------------------------------


def test_a_sense_that_is_given_excludes_a_root() -> None:
    _, derivation = planned(
        "sphere A: mass 2m, velocity 3u i\nsphere B: mass 3m, velocity -2u i\nA hits B: along i\n"
        "given velocity(A) opposite to i, speed(A) = 2u\nfind e"
    )
    # A speed along a line whose sense is known has one component, and no root is left to exclude.
    assert not lines(derivation, "reject")
    (speed,) = (each for each in derivation.lines if "sense 1" in each.premises)
    assert write_relation(speed.relation) == "2u = -v"
    _, derivation = planned(
        "sphere A: mass m, velocity 4u i\nsphere B: mass 3m, velocity -2u i\nA hits B: along i\n"
        "given velocity(A) opposite to i, energy_lost = 12 m u^2\nfind velocity(A), e"
    )
    (reject,) = lines(derivation, "reject")
    assert "sense 1" in reject.premises
    assert write_relation(reject.relation) == "v = -2u"


def test_the_laws_exclude_that_a_sphere_at_rest_moves_towards_the_other() -> None:
    _, derivation = planned(
        f"{PAIR.replace('2m', 'k m')}, e = 1/2\ngiven tan(alpha) = 3/4, speed(B) = 2/5 u\nfind k"
    )
    assert not lines(derivation, "reject")
    _, derivation = planned(
        "sphere A: mass m, velocity u i\nsphere B: mass M, at rest\nA hits B: along i, e = 1/2\n"
        "given speed(B) = 2/5 u\nfind velocity(A)"
    )
    assert not lines(derivation, "reject")
    assert "w = 2u/5" in said(derivation)


def test_a_coefficient_above_one_is_excluded() -> None:
    _, derivation = planned(
        "sphere A: mass 2m, velocity u at 45°\nsphere B: mass 3m, at rest\nA hits B: along i\n"
        "given angle(velocity(A), line_of_centres) = arctan(10/3)\nfind e"
    )
    # By the other root of both sides it would be 7/6.
    assert any("e <= 1" in each.premises for each in derivation.lines)
    assert lines(derivation, "define")[0].move.record == "tan-squared"
    assert said(derivation)[-1] == "e = 1/6"


def test_a_range_that_is_given_excludes_a_root() -> None:
    _, derivation = planned(
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\n"
        "given deflection(A) = arctan(1/3), tan(alpha) < 3/4\nfind alpha"
    )
    assert lines(derivation, "reject")[0].premises[1:] == ("given 2",)


def test_a_root_that_may_be_the_other_is_dropped() -> None:
    # Where λ = sin²α, e = 0 by either root.
    _, derivation = planned(
        f"{WALL}\ngiven energy_lost = lambda energy(0)\nfind e in terms of alpha, lambda"
    )
    assert lines(derivation, "reject")[0].premises[1:] == ("e >= 0", "acute: alpha")


def test_premises_of_a_law_are_put_in_and_not_said_again() -> None:
    _, derivation = planned(f"{PAIR}\ngiven tan(alpha) = 3/4, speed(B) = 2/5 u\nfind e, speed(A)")
    assert [each.move.record for each in lines(derivation, "law")].count("momentum") == 1


# --- two unknowns ---------------------------------------------------------------------------------


def test_velocities_before_from_those_after() -> None:
    _, derivation = planned(
        "sphere A: mass 2, velocity p i + j\nsphere B: mass 3, velocity -q i\n"
        "A hits B: along i, e = 1/3\n"
        "given velocity(A) = -i + j, velocity(B) = i\nfind p, q"
    )
    assert lines(derivation, "combine")[0].move.eliminated in ("p", "q")


def test_a_size_and_its_angle_are_divided_and_squared() -> None:
    _, derivation = planned(f"{WALL}\ngiven velocity(P) = 4i + j, impulse = 3m\nfind u, alpha, e")
    assert {"divide", "square-add"} <= set(moves(derivation))


def test_neither_the_angle_nor_the_speed_is_wanted() -> None:
    _, derivation = planned(
        f"{WALL}\nunknown alpha, u\ngiven deflection(P) = 90°, energy_lost = 2/5 energy(0)\nfind e"
    )
    assert said(derivation)[-1] == "e = 3/5"
    assert "sin^2(alpha) = 1/(1 + e)" in said(derivation)


def test_speeds_that_are_equal_are_squared() -> None:
    _, derivation = planned(
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\nA hits B: along i\n"
        "given speed(B) = speed(A)\nfind tan(alpha) in terms of e"
    )
    assert not any("sqrt((" in each for each in said(derivation))


def test_a_deflection_and_the_speed_after_a_wall_leave_an_angle_to_it() -> None:
    _, derivation = planned(f"{WALL}\ngiven deflection(P) = 60°, speed(P) = 3/4 u\nfind alpha, e")
    assert moves(derivation).count("identity sum-of-angles") == 2
    assert said(derivation)[0] == "angle(velocity(P, 1), W) = 60° - alpha"
    assert said(derivation)[-1] == "e = 3/10"


def test_an_unknown_mass_and_both_speeds() -> None:
    _, derivation = planned(
        "sphere A: mass M, velocity 6 at 30°\nsphere B: mass 2, at rest\nA hits B: along i\n"
        "given speed(A) = sqrt(12), speed(B) = 3 sqrt(3)\nfind M, e"
    )
    (reject,) = lines(derivation, "reject")  # who was at rest goes forwards: w has one sign
    assert reject.relation is not None and "v = " in write_relation(reject.relation)  # type: ignore[arg-type]
    assert [each.move.record for each in lines(derivation, "law")].count("restitution") == 1


def test_an_angle_and_the_speed_after_a_wall_are_put_into_both_laws() -> None:
    _, derivation = planned(
        f"{WALL}\ngiven angle(velocity(P), W) = 30°, speed(P) = 1/2 u\nfind alpha, e"
    )
    assert said(derivation)[0] == "u cos(alpha) = 1/2 u cos(30°)"
    assert len(lines(derivation, "law")) == 2


def test_a_sphere_that_goes_across_the_line_of_centres() -> None:
    _, derivation = planned(
        "sphere A: mass m, velocity u at 60°\nsphere B: mass k m, at rest\nA hits B: along i\n"
        "given angle(velocity(A), line_of_centres) = 90°, speed(B) = 1/3 u\nfind k, e"
    )
    assert lines(derivation, "define")[0].move.record == "perpendicular"
    assert not lines(derivation, "reject")
    assert "w = u/3" in said(derivation)


def test_ratios_of_an_angle_come_from_the_one_that_is_known() -> None:
    _, derivation = planned(
        "sphere A: mass 2, velocity 10 at alpha\nsphere B: mass 1, velocity 10 at beta from -i\n"
        "A hits B: along i, e = 1/2\ngiven velocity(B) = 6i - 6j\nfind alpha, velocity(A)"
    )
    ratios = [each for each in said(derivation) if each.startswith(("sin", "cos"))]
    assert "sin(alpha) = 4/5" in ratios
    assert len(lines(derivation, "triangle")) == 2


def test_the_tangent_is_a_quotient_before_it_is_compared() -> None:
    _, derivation = planned(f"{WALL}: e = 1/3\ngiven angle(velocity(P), W) = 30°\nfind alpha")
    (line,) = lines(derivation, "define")
    assert write_relation(line.relation) == (  # type: ignore[arg-type]
        "tan(30°) = 1/3 u sin(alpha)/(u cos(alpha)) = 1/3 tan(alpha) [rearrange]"
    )


# --- several solutions ----------------------------------------------------------------------------


def test_a_side_that_is_open_parts_the_solutions() -> None:
    _, derivation = planned(
        "sphere A: mass m, velocity u at 45°\nsphere B: mass 2m, at rest\nA hits B: along i\n"
        "given angle(velocity(A), line_of_centres) = arctan(5)\nfind e, velocity(A)"
    )
    assert len(derivation.cases) == 2
    assert len({each.line for each in derivation.cases}) == 1


def test_two_tangents_are_one_answer() -> None:
    _, derivation = planned(
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
        "A hits B: along i, e = 1/2\ngiven deflection(A) = arctan(3/5)\nfind tan(alpha)"
    )
    assert not derivation.cases
    assert len(derivation.items) == 1


def test_solutions_part_more_than_once() -> None:
    _, derivation = planned(
        "wall W: along i\nwall X: along j\nsphere P: velocity p i - q j\n"
        "P hits W: e = 1/2\ngiven p^2 = 9, q^2 - 6q + 8 = 0\nfind p, q, speed(P)"
    )
    assert len({each.line for each in derivation.cases}) == 2
    assert len([e for e in derivation.items if e.item == "3"]) == 4


# --- laws -----------------------------------------------------------------------------------------


def test_speeds_after_a_wall_give_angles() -> None:
    numbers = random.Random(7)
    for _ in range(4):
        e = Fraction(numbers.randint(1, 4), 5)
        share = Fraction(numbers.randint(1, 9), 10)
        square = e * e + (1 - e * e) * share
        text = f"{WALL}: e = {e}\ngiven energy(P) = {square} energy(P, 0)\nfind cos(alpha)"
        solution, _ = planned(text)
        (answer,) = next(iter(solution.items()))[1].answers
        assert sp.simplify(answer.value**2 - sp.Rational(share.numerator, share.denominator)) == 0


def test_what_has_no_shape_has_no_answer_and_a_note_that_says_why() -> None:
    derivation = plan(
        solve(
            parse(
                "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/2\n"
                "given deflection(P) = 3 alpha/2\nfind alpha"
            )
        )
    )
    assert derivation.items == ()
    assert [each.kind for each in derivation.notes] == ["impossible"]


def test_an_impulse_closes_by_the_sphere_of_known_mass() -> None:
    _, derivation = planned(
        "sphere A: mass 4, velocity 3i + 2j\nsphere B: mass m, velocity -2i - j\n"
        "A hits B: along i, e = 1/2\ngiven impulse = 12\nfind m"
    )
    assert "12 = 4(3 - v)" in said(derivation)


def test_a_component_that_vanishes_says_what_was_divided_by() -> None:
    _, derivation = planned(
        "sphere S: mass e M, velocity U at alpha\nsphere T: mass M, at rest\n"
        "S hits T: along i\nfind direction(S)"
    )
    (line,) = lines(derivation, "combine")
    assert "e >= 0" in line.premises


def test_like_terms_in_a_square_stand_on_one_side() -> None:
    text = (
        "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\nA hits B: along i"
    )
    _, derivation = planned(f"{text}\ngiven speed(A) = speed(B)\nfind tan(alpha) in terms of e")
    assert "e cos^2(alpha) = sin^2(alpha)" in said(derivation)


def test_along_a_wall_in_letters_a_body_goes_forwards() -> None:
    text = "wall W: along i + k j\nsphere P: mass m, velocity u i\nP hits W: e = 1/2"
    _, derivation = planned(f"{text}\nfind velocity(P)")
    assert any("= u/sqrt(k^2 + 1)" in each for each in said(derivation))
    assert not any("= -u/sqrt(k^2 + 1)" in each for each in said(derivation))


def test_equal_angles_of_open_sense_are_two_linear_equations() -> None:
    _, derivation = planned(
        "sphere A, B: mass m\nsphere A: velocity u at 30°\nsphere B: velocity u at 60° from -i\n"
        "A hits B: along i\n"
        "given angle(velocity(A), line_of_centres) = angle(velocity(B), line_of_centres)\nfind e"
    )
    assert said(derivation)[-3:] == [
        (
            "(1 + sqrt(3)) e + sqrt(3) - 1 = -(3 - sqrt(3) - (3 + sqrt(3)) e) or "
            "(1 + sqrt(3)) e + sqrt(3) - 1 = 3 - sqrt(3) - (3 + sqrt(3)) e"
        ),
        "e = 1 or e = (2 - sqrt(3))/(2 + sqrt(3))",
        "e = 1 or e = 7 - 4sqrt(3)",
    ]


DIRECT = """
sphere A: mass m, velocity {u}
sphere B: mass k m, velocity {v}
A hits B: along i, e = 1/2
given {fact}
find k
"""


def test_of_equal_squares_the_sides_are_equal_or_opposite() -> None:
    _, derivation = planned(DIRECT.format(u="u i", v="0i", fact="speed(A) = u/3"))
    assert said(derivation)[-2:] == [
        "2(1 + k) = -3(2 - k) or 2(1 + k) = 3(2 - k)",
        "k = 8 or k = 4/5",
    ]


def test_what_equal_or_opposite_sides_exclude_has_its_root() -> None:
    _, derivation = planned(DIRECT.format(u="3u i", v="-u i", fact="speed(A) = speed(B)"))
    assert said(derivation)[-3:] == [
        "5 - k = -3(1 - k) or 5 - k = 3(1 - k)",
        "k = 2 or k = -1",
        "k = 2",
    ]


def test_the_component_that_stays_is_taken_from_both_sides_of_squares() -> None:
    _, derivation = planned(
        DIRECT.format(u="u at alpha", v="0i", fact="tan(alpha) = 3/4, speed(A) = sqrt(10)/5 u")
    )
    assert said(derivation)[-4:] == [
        "10(1 + k)^2 = 4(2 - k)^2 + 9(1 + k)^2",
        "(1 + k)^2 = 4(2 - k)^2",
        "1 + k = -2(2 - k) or 1 + k = 2(2 - k)",
        "k = 5 or k = 1",
    ]


@pytest.mark.parametrize(
    ("alternatives", "follows"),
    [
        ("2(1 + k) = -3(2 - k) or 2(1 + k) = 3(2 - k)", True),
        ("5k = 4 or 8 = k", True),
        ("2(1 + k) = 3(2 - k)", False),
        ("2(1 + k) = 3(2 - k) or 2(1 + k) = 3(2 - k)", False),
        ("2(1 + k) = 3(2 - k) or 2(1 + k) = -3(2 + k)", False),
    ],
)
def test_alternatives_are_all_factors_of_the_equation(alternatives: str, follows: bool) -> None:
    # ((2 − k)u/(2(1 + k)))² = u²/9
    text = DIRECT.format(u="u i", v="0i", fact="energy(A) = 1/9 energy(A, 0)")
    _, derivation = planned(text)
    (number,) = (each.number for each in lines(derivation, "roots"))
    changed = replace(
        derivation,
        lines=tuple(
            replace(each, relation=read_relation(alternatives, {}))
            if each.number == number
            else each
            for each in derivation.lines
        ),
    )
    complaints = follow(changed, Oracle(roles(parse(text))))
    assert all(each.line != number for each in complaints) == follows


REFLECTED = """
wall OA: along i
wall OB: along 180° - theta
sphere P: velocity u at alpha to OA
P hits OA: e = 1
P hits OB: e = 1
given velocity(P) {}
find theta in terms of alpha
"""


@pytest.mark.parametrize(
    ("fact", "lines"),
    [
        ("parallel to i", ["sin(alpha + 2theta) = 0", "alpha + 2theta = 180°"]),
        ("perpendicular to i", ["cos(alpha + 2theta) = 0", "alpha + 2theta = 90°"]),
    ],
)
def test_a_sine_of_a_sum_that_is_zero_gives_the_sum(fact: str, lines: list[str]) -> None:
    _, derivation = planned(REFLECTED.format(fact))
    *_, first, second, last = [write_relation(e.relation) for e in derivation.lines]  # type: ignore[arg-type]
    assert [first, second] == lines
    degrees = "90°" if "180°" in second else "45°"
    assert last == f"theta = {degrees} - alpha/2"


def test_a_complement_is_named_as_that_in_both_laws() -> None:
    _, derivation = planned(
        """
        wall W: along j
        sphere P: velocity w at beta to W
        P hits W
        given deflection(P) = 90°, speed(P) = w/3
        find beta, e
        """
    )
    identities = [line.move.record for line in derivation.lines if line.move.id == "identity"]
    assert identities == ["complement", "complement"]
