"""Centres beside each other's path: the angle of the line of centres, by its sine."""

from __future__ import annotations

from dataclasses import replace

import pytest
from workings import planned

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Meaning, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.expression.tree import Letter, Quantity, walk
from restitution.oracle import Oracle
from restitution.problem import Problem
from restitution.solving.story.letters import roles
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

TURNED_BACK = """
sphere A: mass m, velocity u i, radius r
sphere B: mass 3m, at rest, radius r
A hits B: offset d, e = 7/9
given deflection(A) = 90°
find d, speed(A)
"""
AGAINST_I = """
sphere A: mass m, velocity -3u i, radius r
sphere B: mass 2m, velocity u i, radius r
A hits B: offset d, e = 1/2
given speed(A) = 3u/2
find d, speed(B), energy_lost
"""
TO_THE_RIGHT = """
sphere A: mass m, velocity u i, radius r
sphere B: mass 2m, at rest, radius r
A hits B: offset -d, e = 1/2
given direction(B) = -45°
find d, velocity(A), velocity(B)
"""
SLANTING = """
sphere A: mass 2, velocity 3i + 4j, radius 2
sphere B: mass 3, at rest, radius 2
A hits B: offset d, e = 1/4
given speed(B) = 2
find d, speed(A), energy_lost
"""
WITH_A_RADIUS = """
sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset 1, e = 1
given direction(A) = -60°
find r, speed(A)
"""
TWICE = """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset d, e = 1/2
given deflection(A) = 30°
find d
"""


def printed(problem: Problem, derivation: Derivation) -> str:
    """The working as text."""
    return to_text(explanation_of(awarded(derivation), problem))


@pytest.mark.parametrize(
    ("text", "answer"),
    [
        (TURNED_BACK, "d = r"),
        (AGAINST_I, "d = √10 r/4"),
        (TO_THE_RIGHT, "d = √2 r"),
        (SLANTING, "d = 12/5"),
        (WITH_A_RADIUS, "r = 1"),
        (TWICE, "d = (√33 − 3)a/6"),
    ],
)
def test_no_root_of_the_offset_is_carried(text: str, answer: str) -> None:
    problem, derivation = planned(text)
    assert follow(derivation, Oracle(roles(problem))) == ()
    working = " ".join(printed(problem, derivation).split())
    assert "Let φ be the angle between the line of centres and that path: sin φ = " in working
    assert answer in working
    open_ = {letter for letter in ("d", "r") if letter in answer.split(" = ")[0]}
    for line in derivation.lines:
        for tree in () if isinstance(line.relation, Meaning) else _sides(line.relation):
            roots = [each for each in walk(tree) if getattr(each, "function", "") == "sqrt"]
            inside = {
                node.name for each in roots for node in walk(each) if isinstance(node, Letter)
            }
            assert not inside & open_


def _sides(relation: Relation) -> list[object]:
    return [
        side for links in relation.options for link in links for side in (link.left, link.right)
    ]


def test_the_sine_is_that_of_the_offset_alone() -> None:
    problem, derivation = planned(TURNED_BACK)
    names = dict.fromkeys("AB", "sphere")
    (sine,) = (
        line
        for line in derivation.lines
        if isinstance(line.relation, Relation) and line.move.record == "scalar-angle"
    )
    assert isinstance(sine.relation, Relation)
    assert write_relation(sine.relation) == "sin(phi) = d/(2r)"
    for other in ("sin(phi) = d/r", "cos(phi) = d/(2r)", "sin(phi) = 2r/d"):
        false = replace(sine, relation=read_relation(other, names))
        lines = tuple(false if each is sine else each for each in derivation.lines)
        complaints = follow(replace(derivation, lines=lines), Oracle(roles(problem)))
        assert any(each.line == sine.number for each in complaints)


def test_a_component_is_on_the_side_of_the_offset() -> None:
    problem, derivation = planned(TO_THE_RIGHT)
    names = dict.fromkeys("AB", "sphere")
    (across,) = (
        line
        for line in derivation.lines
        if line.move.record == "component"
        and isinstance(line.relation, Relation)
        and isinstance(line.relation.only[0].left, Quantity)
        and line.relation.only[0].left.kind == "across"
    )
    false = read_relation("across(velocity(A, 0), line_of_centres(1)) = -sqrt(2) u/2", names)
    lines = tuple(replace(e, relation=false) if e is across else e for e in derivation.lines)
    complaints = follow(replace(derivation, lines=lines), Oracle(roles(problem)))
    assert any(each.line == across.number for each in complaints)


def test_an_offset_that_may_be_on_either_side_has_no_letter_for_its_angle() -> None:
    text = TURNED_BACK.replace("offset d", "offset d - r").replace("find d", "given d > 0\nfind d")
    problem, derivation = planned(text)
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert not any(
        isinstance(line.relation, Meaning) and line.relation.angle == "acute"
        for line in derivation.lines
    )


def test_where_a_sphere_is_sent_across_the_line_of_centres_that_comes_of_the_laws() -> None:
    problem, derivation = planned(WITH_A_RADIUS)
    working = " ".join(printed(problem, derivation).split())
    assert working.index("v = 0") < working.index("It is given that the angle from")
    assert "φ − 90° = −60° DM1 φ = 30°" in working


def test_an_angle_that_the_offset_gives_is_not_worked_out_again() -> None:
    problem, derivation = planned(
        """
sphere A: mass m, velocity v i, radius R
sphere B: mass m, at rest, radius R
A hits B: offset R, e = 1
find speed(A), deflection(A)
"""
    )
    working = printed(problem, derivation)
    assert "δ = 90° − 30° = 60°" in working
    assert "tan" not in working


def test_a_line_of_centres_beside_a_slanting_path_is_that_path_turned() -> None:
    problem, derivation = planned(
        """
sphere A: mass 1, velocity 3i, radius 2
sphere B: mass 1, velocity -4j, radius 2
A hits B: offset 2, e = 1/2
find line_of_centres
"""
    )
    assert "(cos 30°)((3𝐢 + 4𝐣)/5) + (sin 30°)((−4𝐢 + 3𝐣)/5)" in printed(problem, derivation)


def test_a_range_of_an_offset_is_one_of_the_sine_of_its_angle() -> None:
    problem, derivation = planned(
        "sphere A: mass 2, velocity 6i, radius 5\nsphere B: mass 5, velocity -2i, radius 5\n"
        "A hits B: offset d, e = 1/2\ngiven deflection(A) > 90°\nfind range of d"
    )
    text = " ".join(to_text(explanation_of(awarded(derivation), problem)).split())
    assert "v = −(18/7) cos φ" in text
    assert "tan²φ < 3/7 sin²φ < 3/10 Substituting for sin φ: (d/10)² < 3/10 d² < 30" in text
    assert "√(100 − d²)" not in text


def test_components_keep_their_signs_in_a_scalar_product_that_is_negative() -> None:
    problem, derivation = planned(
        "sphere A: mass m, velocity u i, radius r\nsphere B: mass 3m, at rest, radius r\n"
        "A hits B: offset d, e = 1\ngiven deflection(A) > 90°\nfind range of d in terms of r"
    )
    assert not follow(derivation, Oracle(roles(problem)))
    text = printed(problem, derivation)
    assert "(u cos φ)(−½u cos φ) + (−u sin φ)(−u sin φ) < 0" in text


GREATEST = """
sphere P: mass 2m, velocity V i, radius a
sphere Q: mass m, at rest, radius a
P hits Q: offset x, e = 1
"""


def test_a_greatest_deflection_over_an_offset_is_one_over_the_angle() -> None:
    problem, derivation = planned(GREATEST + "find maximum of deflection(P) over x")
    assert follow(derivation, Oracle(roles(problem))) == ()
    text = " ".join(printed(problem, derivation).split())
    assert "tan δ = (3 tan φ − tan φ)/(1 + 3 tan²φ) = 2 tan φ/(1 + 3 tan²φ)" in text
    assert "S = (1 − √3 tan φ)²/tan φ + 2√3" in text
    # tan φ = 1/√3 is 30°, of which the sine is ½ = x/(2a).
    assert "when 1 − √3 tan φ = 0, so tan φ = √3/3, sin φ = ½ and x = a" in text
    assert "√(4a² − x²)" not in text


def test_what_is_asked_by_the_offset_beside_a_greatest_deflection_ends_in_it() -> None:
    problem, derivation = planned(
        GREATEST + "find speed(Q) in terms of V, a, x\nfind maximum of deflection(P) over x"
    )
    assert follow(derivation, Oracle(roles(problem))) == ()
    text = " ".join(printed(problem, derivation).split())
    assert "cos φ = √(4a² − x²)/(2a)" in text
    # Q leaves with 2 × 2/3 of V cos φ.
    assert "speed of Q = (4/3)V cos φ" in text
    assert "Substituting for cos φ: (i) speed of Q = 2V√(4a² − x²)/(3a)" in text


def test_an_offset_is_told_by_the_radius_and_not_the_other_way_round() -> None:
    problem, derivation = planned(
        "sphere P: mass m, velocity V i, radius a\nsphere Q: mass m, at rest, radius a\n"
        "P hits Q: offset d, e = 1/2\nfind range of d"
    )
    text = " ".join(printed(problem, derivation).split())
    assert "d = 2a sin φ 0 < d < 2a, as 2a sin φ increases with φ and φ is acute" in text


def test_an_offset_that_a_later_part_gives_leaves_the_angle_to_the_first() -> None:
    problem, derivation = planned(
        "sphere P: mass m, velocity V i, radius a\nsphere Q: mass m, at rest, radius a\n"
        "P hits Q: offset x\npart a\ngiven e = 1/2\nfind maximum of deflection(P) over x\n"
        "part b\ngiven x = a, deflection(P) = 45°\nfind e"
    )
    assert follow(derivation, Oracle(roles(problem))) == ()
    text = " ".join(printed(problem, derivation).split())
    assert "so tan φ = ½, sin φ = √5/5 and x = 2√5 a/5" in text
    assert "sin φ = a/(2a) = ½ φ = 30°" in text
    assert "Substituting for φ in (13): v = √3(1 − e)V/4" in text
    # β = δ + φ, where v is not negative.
    assert "As v ≥ 0 (since e ≤ 1), P keeps its sense" in text and "β = 45° + 30° = 75°" in text
    assert "tan 75° = (V/2)/(√3(1 − e)V/4)" in text and "e ≈ 0.691" in text


OFFSET_OF_A_RADIUS = (
    "sphere A: mass m, radius a, velocity U i\nsphere B: mass m, radius a, at rest\n"
    "A hits B: offset a\n"
)


def test_a_given_deflection_and_the_angle_that_an_offset_makes_give_the_other_angle() -> None:
    problem, derivation = planned(OFFSET_OF_A_RADIUS + "given deflection(A) = 30°\nfind e")
    assert follow(derivation, Oracle(roles(problem))) == ()
    text = " ".join(printed(problem, derivation).split())
    assert "and is 30°" in text and "θ = 30° + 30° = 60°" in text
    # √3 = (U/2)/v, so that both laws have one unknown each.
    assert "tan 60° = (U/2)/v" in text and "v = √3 U/6" in text
    assert "√3 U/3 − √3 U/6 = e(√3 U/2)" in text and "e = ⅓" in text


def test_what_the_impulse_leaves_is_no_scalar_product_of_the_velocity_that_it_makes() -> None:
    problem, derivation = planned(
        OFFSET_OF_A_RADIUS + "part a\nfind velocity(A)\npart b\ngiven deflection(A) = 30°\nfind e"
    )
    assert follow(derivation, Oracle(roles(problem))) == ()
    text = " ".join(printed(problem, derivation).split())
    assert "the component of A in the direction of 𝐭 stays −U/2" in text.split("(b)")[1]


def test_a_range_of_an_offset_for_a_deflection_has_each_of_its_lines() -> None:
    problem, derivation = planned(
        "sphere A: mass m, velocity u i, radius a\nsphere B: mass m, at rest, radius a\n"
        "A hits B: offset d, e = 1/2\ngiven deflection(A) >= 30°\nfind range of d"
    )
    assert "4a⁴ − 21a²d² + 9d⁴ ≤ 0" in printed(problem, derivation)


DECIMALS = """
sphere A, B: mass 0.2, radius 5 cm
sphere A: velocity 3i
sphere B: at rest
A hits B: offset 4 cm, e = 0.9
part a
find angle(velocity(A, 0), line_of_centres)
part b
find speed(A)
part c
find deflection(A)
"""


def test_an_angle_by_an_offset_is_that_of_its_sine_and_a_deflection_takes_it() -> None:
    problem, derivation = planned(DECIMALS)
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert "sin β = 0.04/(2 × 0.05) = 0.4" in text
    assert "β = arcsin 0.4 ≈ 23.6°" in text
    assert "tan θ = 1.2/(3√21/100)" in text
    assert "δ = θ − β = arctan(40√21/21) − arcsin 0.4" in text
    assert "cos δ" not in text


def test_the_words_of_an_offset_are_said_once() -> None:
    problem, derivation = planned("""
sphere A: mass 1, velocity 5i, radius 0.4
sphere B: mass 2, at rest
A hits B: offset 0.62, e = 0.5
find speed(A), deflection(A)
""")
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert text.count("At the impact the centres are 0.8 m apart") == 1
    assert "Let β be the angle between the line of centres and the path of A: sin β = 0.775" in text
    assert "δ = 90° − β = 90° − arcsin 0.775" in text


def test_data_that_clash_in_a_later_part_meet_the_letter_of_the_offset() -> None:
    problem, derivation = planned("""
sphere A: mass 2m, velocity u i, radius a
sphere B: mass 6m, velocity -u i
A hits B: offset d, e = 1
part a
given impulse = 4 m u
find d
part b
given speed(A) = 3u
find d
""")
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert "sin φ = d/(2a)" in text
    assert "it is given that the speed of A immediately after the collision is 3u" in text


def test_the_sine_of_an_offset_earns_its_marks_once() -> None:
    problem, derivation = planned(
        "sphere A: mass m, radius r, velocity u i\nsphere B: mass m, at rest\n"
        "A hits B: offset 1.2r, e = 1/3\nfind speed(A), deflection(A)"
    )
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert text.count("1.2r/(2r)") == 1
    assert "the line of centres and the path of A: sin θ = 0.6 Let" in text


@pytest.mark.parametrize(
    ("asked", "last"),
    [
        ("speed(A)", "speed of A = u√(15d² + 4r²)/(8r)"),
        ("energy_lost", "kinetic energy lost = 3mu²(4r² − d²)/(64r²)"),
        ("velocity(B)", "𝐯_B = (3u(4r² − d²)/(16r²))𝐢 + (3du√(4r² − d²)/(16r²))𝐣"),
        ("direction(B)", "angle from 𝐢 to 𝐯_B = arcsin(d/(2r))"),
    ],
)
def test_values_in_terms_of_an_offset_are_worked_out_by_an_angle(asked: str, last: str) -> None:
    """No root of 4r² − d² stands in the laws."""
    problem, derivation = planned(
        "sphere A: mass m, radius r, velocity u i\nsphere B: mass m, at rest\n"
        f"A hits B: offset d, e = 1/2\nfind {asked}"
    )
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert asked == "direction(B)" or "mu cos φ = mv + mw" in text
    assert text.endswith(last)
