"""The way in which a teacher goes: laws first, roots of both sides, results quoted once shown."""

from __future__ import annotations

from functools import cache

import pytest
from answers import _differs

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Meaning
from restitution.explaining.lines.notation import write_relation
from restitution.expression.writing import write_expression
from restitution.language.reading import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

PAIR = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i
"""
SLANTING = """
sphere A: mass 2, velocity 3i + j
sphere B: mass 1, velocity -i + 2j
A hits B: along i + j, e = 1/2
find velocity(A), velocity(B)
"""


@cache
def planned(text: str) -> Derivation:
    """The working of a statement; the follower and the answers are asked first."""
    problem = parse(text)
    solution = solve(problem)
    derivation = plan(solution)
    assert [str(each) for each in follow(derivation, Oracle(roles(problem)))] == []
    ends = {each.item: each for each in derivation.items}
    for (part, item), end in zip(solution.items(), ends.values(), strict=True):
        plain = item.kind == "value" and len(item.answers) == 1 and not item.answers[0].angle
        if plain:
            (links,) = end.answer.options
            told = write_expression(links[-1].right)
            assert _differs(item, told, dict(part.roles)) is None, told
    return derivation


def said(text: str) -> list[str]:
    """What the lines of a working say, but for those that introduce a letter."""
    lines = planned(text).lines
    return [write_relation(e.relation) for e in lines if e.move.id != "let"]  # type: ignore[arg-type]


# --- roots of both sides -------------------------------------------------------------------------


def test_a_speed_of_one_component_is_not_squared() -> None:
    told = said(PAIR + "given speed(B) = 1/2 u cos(alpha)\nfind e")
    assert "1/2 u cos(alpha) = e (u cos(alpha))" in told
    assert not any("^2" in each for each in told)


def test_speeds_of_one_component_each_are_equal_without_squares() -> None:
    text = """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
sphere C: mass k m, at rest
A hits B: along i, e = 1/2
B hits C: along i, e = 1/2
given speed(C) = 3/4 speed(B, 1)
find k
"""
    told = said(text)
    assert not any("^2" in each for each in told)


@pytest.mark.parametrize(
    ("fact", "lines"),
    [
        ("speed(A) = sqrt(109)/12 u", ("(1 - 2e)^2 = ",)),
        ("energy(A) = 109/144 energy(A, 0)", ("(1 - 2e)^2 = ",)),
    ],
)
def test_the_square_of_a_sum_is_not_multiplied_out(fact: str, lines: tuple[str, ...]) -> None:
    text = PAIR.replace("at alpha", "at 60°") + f"given {fact}\nfind e"
    told = said(text)
    for start in lines:
        assert any(each.startswith(start) for each in told)
    assert not any("e^2" in each for each in told)


def test_a_power_has_its_root_taken_at_once() -> None:
    text = """
sphere A, B, C: mass m
sphere A: velocity u i
sphere B, C: at rest
A hits B: along i
B hits C: along i
given energy(C) = 81/256 energy(A, 0)
find e
"""
    told = said(text)
    assert told[-3:] == ["(1 + e)^4 = 81/16", "1 + e = 3/2", "e = 1/2"]


def test_a_ratio_of_energies_of_one_body_is_one_of_speeds_squared() -> None:
    wall = "wall W: along i\nsphere P: mass m, velocity u at theta to W\nP hits W: e = 1/3\n"
    derivation = planned(wall + "given energy(P) = 2/3 energy(P, 0)\nfind theta")
    (line,) = (each for each in derivation.lines if each.move.record == "energy-ratio")
    assert write_relation(line.relation) == (  # type: ignore[arg-type]
        "(1/3 u sin(theta))^2 + (u cos(theta))^2 = 2/3 u^2"
    )


# --- order ---------------------------------------------------------------------------------------


def test_laws_come_before_a_fact_that_leaves_a_sense_open() -> None:
    moving = PAIR.replace("at rest", "velocity -u cos(alpha) i")
    lines = planned(moving + "given speed(B) = 1/4 u cos(alpha)\nfind e").lines
    kinds = [each.move.record or each.move.id for each in lines]
    assert kinds.index("momentum") < kinds.index("restitution") < kinds.index("speed")


@pytest.mark.parametrize(
    "more", ["energy_lost", "impulse(A), total_energy_lost", "angle(velocity(B), line_of_centres)"]
)
def test_a_second_velocity_is_of_its_components_where_these_are_wanted(more: str) -> None:
    records = [each.move.record for each in planned(SLANTING.strip() + f", {more}").lines]
    assert "momentum-vector" not in records
    across = "angle" in more
    assert records.count("changed-velocity") == (1 if across else 2)
    assert records.count("assemble") == (1 if across else 0)


@pytest.mark.parametrize("more", ["speed(B)", "energy(B)", "impulse(A)"])
def test_a_second_velocity_by_momentum_is_used_as_a_vector(more: str) -> None:
    lines = planned(SLANTING.strip() + f", {more}").lines
    (after,) = (n for n, each in enumerate(lines) if each.move.record == "momentum-vector")
    assert not any(each.move.record == "component" for each in lines[after:])
    assert not any(
        write_relation(e.relation).startswith("w = ") for e in lines if e.move.id != "let"
    )  # type: ignore[arg-type]


# --- facts ----------------------------------------------------------------------------------------


def test_a_velocity_that_is_given_beside_the_laws_is_an_equation() -> None:
    text = """
sphere A: mass 3m, velocity p i
sphere B: mass 2m, velocity -q i
A hits B: along i, e = 1/4
given velocity(A) opposite to i
find range of q/p
part b
given velocity(A) = -1/2 velocity(A, 0)
find q/p, speed(B)/q
"""
    told = said(text)
    assert "v = -p/2" in told and "(p - q)/2 = -p/2" in told and "q/p = 2" in told


def test_a_scalar_product_that_is_given() -> None:
    text = """
sphere A: mass 3, velocity 5i + 2j
sphere B: mass 1, velocity -3i + 4j
A hits B: along i
given dot(velocity(A), velocity(B, 0)) = 5
find e
"""
    assert "-3v + 2*4 = 5" in said(text)


def test_the_size_of_a_difference_of_velocities_that_is_given() -> None:
    text = (
        PAIR.replace("at alpha", "at 60°")
        + """
given abs(velocity(A) - velocity(B)) = 9/10 u
find e
"""
    )
    assert "(e u/2)^2 + (sqrt(3) u/2)^2 = (9/10 u)^2" in said(text)


# --- quoting --------------------------------------------------------------------------------------


def test_a_quantity_that_was_shown_is_quoted() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
part a
show energy_lost = 1/4 m u^2 (1 - e^2) cos^2(alpha)
part b
given e = 1/2
find energy_lost/energy(0)
part c
given energy_lost = 1/8 energy(0), alpha = 45°
find e
"""
    derivation = planned(text)
    records = [each.move.record for each in derivation.lines]
    assert records.count("energy-lost") == 1
    (shown,) = (end.line for end in derivation.items if end.shown)
    assert sum(shown in each.premises for each in derivation.lines) == 2


def test_an_equation_that_was_shown_is_quoted() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
given velocity(A) perpendicular to velocity(A, 0)
part a
show tan^2(alpha) = (3e - 1)/4
part b
given e = 2/3
find alpha
"""
    derivation = planned(text)
    assert [each.move.record for each in derivation.lines].count("perpendicular") == 1


def test_what_is_shown_before_a_fact_is_shown_in_letters() -> None:
    text = """
let t = tan(alpha)
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/4
show tan(deflection(P)) = 5t/(4 - t^2)
find t
given deflection(P) = 45°
"""
    derivation = planned(text)
    told = said(text)
    assert "tan(deflection(P, 1)) = 5t/(4 - t^2)" in told
    assert "1 = 5tan(alpha)/(4 - tan^2(alpha))" in told
    assert derivation.items[-1].answer.only[0].left == derivation.items[-1].answer.only[-1].left


def test_letters_for_expressions_in_sequence() -> None:
    text = """
let c = cos(alpha)
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
let V = speed(B)/u
show V = 2/3 (1 + e) c
given V = c
find e
"""
    assert "V = 2/3 (1 + e) c" in said(text)
    assert said(text)[-1] == "e = 1/2"


SHARED = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
part a
given velocity(A) perpendicular to velocity(A, 0)
{first}
part b
given velocity(A) perpendicular to velocity(A, 0){more}
{second}
"""


@pytest.mark.parametrize(
    ("first", "more", "second", "last"),
    [
        ("show tan^2(alpha) = (3e - 1)/4", ", e = 2/3", "find alpha", "alpha = arctan(1/2)"),
        ("find tan(alpha) in terms of e", ", e = 2/3", "find alpha", "alpha = arctan(1/2)"),
        (
            "show tan^2(alpha) = (3e - 1)/4",
            "\nunknown e",
            "find range of alpha",
            "0° < alpha <= arctan(1/sqrt(2))",
        ),
    ],
)
def test_what_two_parts_are_given_is_used_once(
    first: str, more: str, second: str, last: str
) -> None:
    text = SHARED.format(first=first, more=more, second=second)
    derivation = planned(text)
    assert [each.move.record for each in derivation.lines].count("perpendicular") == 1
    assert said(text)[-1] == last


def test_a_fact_of_one_part_alone_holds_in_no_other() -> None:
    first, second = "find tan(alpha) in terms of e", "find e"
    text = SHARED.format(first=first, more="", second=second)
    own = "perpendicular to velocity(A, 0)\nfind e"
    derivation = planned(text.replace(own, "parallel to j\nfind e"))
    (end,) = (each for each in derivation.items if each.part == "b")
    assert "given 1" not in lines_under(derivation, end.line)


def lines_under(derivation: Derivation, number: int) -> set[object]:
    """A line, and all that it rests on."""
    line = derivation.line(number)
    assert line is not None
    found: set[object] = set(line.premises)
    for ref in line.premises:
        if isinstance(ref, int):
            found |= lines_under(derivation, ref)
    return found


# --- no momentum in all ---------------------------------------------------------------------------


def test_equal_spheres_without_momentum_in_all_go_on_opposite_to_each_other() -> None:
    text = """
sphere A: mass m, velocity u i
sphere B: mass m, velocity -u i
A hits B: along i, e = 1/3
find velocity(A), velocity(B)
"""
    told = said(text)
    assert told.index("w = -v") < told.index("v = -u/3") < told.index("w = u/3")
    assert not any(line.move.id == "combine" for line in planned(text).lines)


# --- the letters and the sense of components -----------------------------------------------------


def test_beside_a_speed_that_is_named_v_in_capitals_no_component_is_v() -> None:
    text = PAIR + "let V = speed(B)\nfind V"
    assert "V = 1/3 (1 + e) u cos(alpha)" in said(text)
    lets = [e.relation for e in planned(text).lines if isinstance(e.relation, Meaning)]
    assert [each.letter for each in lets] == ["w", "x"]


def test_components_count_in_the_sense_in_which_the_line_of_centres_is_given() -> None:
    text = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 1, at rest
A hits B: along 3i - 4j, e = 1/2
find velocity(A), velocity(B)
"""
    told = said(text)
    assert "2(-7/5) = 2v + w" in told
    assert "v - w = 1/2 (7/5)" in told


# --- tangents of angles before, and to opposite directions ---------------------------------------


def test_angles_to_opposite_directions_that_are_equal_make_components_opposite() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, velocity u at alpha from -i
A hits B: along i, e = 1/2
given angle(velocity(A), i) = angle(velocity(B), -i)
find k
"""
    told = said(text)
    assert "tan(angle(velocity(B, 1), -i)) = -u sin(alpha)/w" in told
    assert told.index("v = -w") < told.index("k = 1")


@pytest.mark.parametrize(
    ("text", "line", "end"),
    [
        (
            """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i, e = 1/2
given tan(angle(velocity(A), i)) = 4 tan(angle(velocity(A, before), i))
find k
""",
            "2(1 + k) tan(alpha)/(2 - k) = 4tan(alpha)",
            "k = 1",
        ),
        (
            """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(angle(velocity(P), W)) = 1/4 tan(angle(velocity(P, before), W))
find e
""",
            "e tan(alpha) = 1/4 tan(alpha)",
            "e = 1/4",
        ),
    ],
)
def test_the_tangent_of_an_angle_before_is_that_of_the_data(text: str, line: str, end: str) -> None:
    told = said(text)
    assert told[told.index(line) :][-1] == end


# --- the angle of who moves along the line of centres, and angles that are found -----------------


def test_the_angle_with_who_moves_along_the_line_of_centres_is_that_to_the_line() -> None:
    text = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 1, at rest
A hits B: along 3i - 4j, e = 1/2
find velocity(A), velocity(B), angle(velocity(A), velocity(B))
"""
    assert "tan(beta) = 24/5/(7/10) = 48/7 [rearrange]" in said(text)


def test_an_angle_in_degrees_that_is_found_is_put_into_a_difference() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given deflection(P) = 60°, speed(P) = (sqrt(3) - 1) u
find alpha, e
"""
    assert "e u sin(45°) = (sqrt(3) - 1) u sin(60° - 45°)" in said(text)


def test_what_is_lost_in_all_is_what_each_impact_takes_where_one_is_known() -> None:
    text = """
sphere P: mass 1, velocity 8i + j
wall W: along 3i + 4j
P hits W: e = 1/4
part a
find velocity(P), energy_lost
part b
wall X: along i + j
P hits X: e = 1/3
find total_energy_lost
"""
    told = said(text)
    assert any(each.startswith("total_energy_lost(2) = 2523/160 + 441/200") for each in told)


# --- roots in products ----------------------------------------------------------------------------


def test_components_in_proportion_have_no_root_in_common() -> None:
    text = """
sphere A: mass 3m, velocity 4u i
sphere B: mass m, velocity 2u j
A hits B: along 45°
given velocity(B) parallel to i + 3j
find e
"""
    assert "2(sqrt(2) u) - w = 0" in said(text)


def test_a_product_of_equal_roots_is_a_square_and_a_cosine_above_one_has_its_reason() -> None:
    text = """
sphere A: mass 2m, velocity 3u at alpha
sphere B: mass m, velocity 2u at beta from -i
A hits B: along i, e = 1/2
given cos(alpha) = 2/3, velocity(A) perpendicular to velocity(A, 0)
find cos(beta)
"""
    words = " ".join(to_text(explain(solve(parse(text))), 100).split())
    assert "u(1 − cos β) × 2u + (√5 u)² = 0" in words
    assert "This cannot be, as cos β is at most 1." in words


def test_a_tangent_that_comes_out_on_the_right_is_written_on_the_left_once() -> None:
    text = """
point S: (0, 1)
wall W1: along i, through (0, 0)
wall W2: along j, through (3, 0)
wall W3: along i, through (0, 2)
sphere P: at (0, 1), velocity u at alpha from -j
given e = 1/2
P hits W1
P hits W2
P hits W3
P reaches S
find alpha, time(4)
"""
    told = said(text)
    assert "tan(alpha) = 1" in told
    assert "1 = tan(alpha)" not in told
