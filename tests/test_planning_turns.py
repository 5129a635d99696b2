"""Angles between velocities at an impact: made of their angles to the line of centres.

Each working is followed line by line, its answers are those of the solver, and it says what a
teacher says.
"""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from derivations import oracle_of
from workings import planned

from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Relation
from restitution.expression.tree import Binary
from restitution.expression.writing import write_expression
from restitution.language import parse
from restitution.planning.planner import plan
from restitution.planning.writing.forms import tree_of
from restitution.solving import solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

# A statement, and what its working says: lines, or parts of them.
CASES = {
    "at a wall, a multiple of the angle after": (
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = e
given deflection(P) = 3 angle(velocity(P), W)
find e in terms of alpha
""",
        ("α + β = 3β", "β = α/2", "tan(α/2) = e tan α", "e = tan(α/2)/tan α"),
    ),
    "at a wall, twice the angle after, with a velocity as a vector": (
        """
wall W: along i + j
sphere P: mass m, velocity u(3i - j)
P hits W
given deflection(P) = 2 angle(velocity(P), W)
find e
""",
        ("tan β = 2√2 u/(√2 u) = 2", "β + θ = 2θ", "θ = β", "2 = 2e", "e = 1"),
    ),
    "at a wall, a multiple of the angle before, with a velocity as a vector": (
        """
wall W: along i
sphere P: mass m, velocity 4i - 3j
P hits W
given deflection(P) = 3/2 angle(velocity(P, 0), W)
find e
""",
        ("β = 2θ", "tan β = 2 tan θ/(1 − tan²θ)", "16 − 9e² = 32e", "e = 4/9 ≈ 0.444, as e ≥ 0"),
    ),
    "at a wall, a multiple of the angle after, of which the tangent is a root": (
        """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/4
given deflection(P) = 3 angle(velocity(P), W)
find alpha
""",
        ("β = α/2", "1 − t² = ½", "t = √2/2", "α = arctan(2√2)"),
    ),
    "at a wall, double an angle": (
        """
wall V: along j
sphere Q: velocity 3w at phi to V
Q hits V: e = k
given deflection(Q) = 2 angle(velocity(Q), V)
find k
""",
        ("φ + β = 2β", "β = φ", "tan φ = k tan φ", "k = 1"),
    ),
    "at a wall, by letters of the data": (
        """
wall W: along i
sphere P: velocity u at -beta
P hits W: e = e
given deflection(P) = 90° - alpha
find e in terms of alpha, beta
""",
        ("θ = 90° − α − β", "tan(90° − α − β) = eu sin β/(u cos β)", "(tan α + tan β) tan β"),
    ),
    "at a wall, what is left of a right angle": (
        """
wall W: along i
sphere P: velocity u at -alpha
P hits W: e = e
given deflection(P) = 90° - alpha
find e in terms of alpha
""",
        ("β = 90° − α − α = 90° − 2α", "By the complement of the angle"),
    ),
    "of two spheres, from a number of degrees": (
        """
sphere A: mass m, velocity u at 30°
sphere B: mass m, at rest
A hits B: along i, e = e
given deflection(A) = theta
find e in terms of theta
""",
        ("β = θ + 30°", "By the formula for the tangent of a sum"),
    ),
    "at a wall, with the speed given": (
        """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given deflection(P) = 60°, speed(P) = u/sqrt(3)
find alpha
""",
        ("P turns through the sum of", "angle between 𝐯_P and W = 60° − α"),
    ),
    "at a wall, as a difference": (
        """
wall W: along i
sphere P: velocity u at -alpha
P hits W: e = e
given deflection(P) = theta
find e in terms of alpha, theta
""",
        ("tan(θ − α) = eu sin α/(u cos α)", "By the formula for the tangent of a difference"),
    ),
    "an offset by an angle": (
        """
sphere A: mass m, velocity 4 i, radius 3
sphere B: mass m, at rest, radius 3
A hits B: offset b, e = 1/2
given angle(line_of_centres, i) = 30°
find b, speed(B)
""",
        ("b/(2 × 3) = b/6.", "b/6 = ½", "b = 3"),
    ),
    "at a wall, to be shown": (
        """
wall V: along j
sphere Q: velocity w at 30° to V
Q hits V: e = k
show tan(deflection(Q)) = sqrt(3)(1 + k)/(3 - k)
show deflection(Q) = 2 angle(velocity(Q), V)
""",
        ("δ = 30° + β", "tan δ = (tan 30° + tan β)/(1 − tan 30° tan β)"),
    ),
    "goes on": (
        """
sphere A: mass 3m, velocity 2u at 60°
sphere B: mass m, at rest
A hits B: along i, e = 1/3
find deflection(A)
""",
        ("As v > 0, A keeps its sense", "δ = β − 60° = arctan(3√3/2) − 60°"),
    ),
    "a given turn in numbers, before the laws": (
        """
sphere A: mass 3m, velocity 2u at theta
sphere B: mass m, at rest
A hits B: along i
given tan(theta) = 1/2, deflection(A) = arctan(1/3)
find e
""",
        ("of −𝐢, so A turns away", "β = θ + arctan(1/3)", "v = 2√5 u/5\nConservation of momentum"),
    ),
    "a right angle that a given turn makes, before the laws": (
        """
sphere A: mass m, velocity u at 60°
sphere B: mass k m, at rest
A hits B: along i
given deflection(A) = 30°
find e in terms of k
""",
        ("β = 30° + 60° = 90°", "v = 0", "mu cos 60° = kmw"),
    ),
    "a given turn of who is pushed on": (
        """
sphere A: mass m, velocity 5u i
sphere B: mass 5m, velocity u at 60°
A hits B: along i
given deflection(B) = 30°
find e
""",
        ("of 𝐢, so B turns towards 𝐢", "β = 60° − 30° = 30°", "w = 3u/2\nConservation of momentum"),
    ),
    "sent back": (
        """
sphere A: mass m, velocity u at 45°
sphere B: mass 4m, velocity u at 150°
A hits B: along i, e = 1/2
find deflection(A)
""",
        ("sent back", "δ = 180° − 45° −"),
    ),
    "leaves at right angles": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass 4m, at rest
A hits B: along i, e = 1/4
find deflection(A), speed(B)
""",
        ("leaves at right angles", "δ = 90° − α"),
    ),
    "an angle that the data tell by its tangent": (
        """
sphere A: mass 2m, velocity 10u at theta
sphere B: mass m, velocity 5u at 180°
given tan(theta) = 3/4
A hits B: along i, e = 1/2
find deflection(A)
""",
        ("Since tan θ = ¾", "δ = β − θ = arctan 4 − arctan(3/4)"),
    ),
    "straight back": (
        """
sphere A: mass 1, velocity 4i
sphere B: mass 5, velocity -i
A hits B: along i, e = 3/5
find deflection(A)
""",
        ("straight back", "δ = 180°"),
    ),
    "opposite sides": (
        """
sphere A: mass m, velocity 3u at 60°
sphere B: mass m, velocity u at -60°
A hits B: along i, e = 1/2
find angle(velocity(A), velocity(B))
""",
        ("opposite sides",),
    ),
    "in letters, which way it goes is open": (
        """
sphere A: mass m, velocity u at theta
sphere B: mass 5m, at rest
A hits B: along i
find tan(deflection(A))
""",
        ("make with 𝐢", "the tangent of a difference", "tan δ = (tan β − tan θ)/(1 + tan β tan θ)"),
    ),
    "shown": (
        """
sphere A: mass m, velocity u at beta
sphere B: mass 3m, at rest
A hits B: along i, e = 0
show tan(deflection(A)) = 3tan(beta)/(1 + 4tan(beta)^2)
""",
        ("(as required)", "tan δ = (4 tan β − tan β)/(1 + 4 tan²β)"),
    ),
    "given, in degrees": (
        """
sphere A: mass m, velocity u at 30°
sphere B: mass 2m, velocity u at 120°
A hits B: along i
given deflection(B) = 75°
find e
""",
        ("= 45°",),
    ),
    "given, at right angles": (
        """
sphere A: mass 2m, velocity u at 30°
sphere B: mass k m, at rest
A hits B: along i
given deflection(A) = 60°
find e in terms of k
""",
        ("β = 60° + 30° = 90°", "e = 2/k"),
    ),
    "given, two angles of approach": (
        """
sphere A, B: mass m
sphere A: velocity u at beta
sphere B: at rest
A hits B: along i, e = 0
given deflection(A) = arctan(1/3)
find tan(beta)
""",
        ("tan β = 1 or tan β = ½",),
    ),
    "given by its tangent": (
        """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
given tan(alpha) = 1/3
A hits B: along i, e = 1/2
given tan(deflection(A)) = 1/3
find k
""",
        ("β = α + δ", "tan β = (⅓ + ⅓)/(1 − ⅓ × ⅓) = ¾"),
    ),
    "a deflection that is shown": (
        """
sphere A: mass 2m, velocity u at theta
sphere B: mass 3m, at rest
A hits B: along i, e = 2/3
show deflection(A) = 90° - theta
""",
        ("δ = 90° − θ   (as required)",),
    ),
    "twice the angle to a wall": (
        """
wall W: along j
sphere P: velocity u at theta to W
P hits W: e = 1
show deflection(P) = 2 theta
""",
        ("= 2θ   (as required)",),
    ),
    "two deflections added": (
        """
wall W: along i
wall X: along j
sphere P: velocity u at 30° to W
P hits W: e = 1/2
P hits X: e = 1/3
find deflection(P, 1) + deflection(P, 2)
""",
        ("≈ 169°",),
    ),
    "both deflections given": (
        """
sphere A: mass m, velocity u at 30°
sphere B: mass k m, velocity u j
A hits B: along i
given deflection(A) = 60°, deflection(B) = 45°
find k, e
""",
        ("tan 45° = w/u",),
    ),
    "a right angle by the product": (
        """
sphere A: mass m, velocity 3u i + u j
sphere B: mass m, velocity -5u i
A hits B: along i, e = 1
find deflection(A)
""",
        (),
    ),
    "a cosine that is too long for one line": (
        """
sphere A: mass m, velocity 1300000u at arctan(12/5)
sphere B: mass 2m, velocity 500000u at arctan(4/3) from -i
A hits B: along i, e = 1/2
find cos(angle(velocity(A), velocity(B)))
""",
        ("𝐯_A · 𝐯_B = ", "speed of A = ", "cos β = "),
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_an_angle_is_made_of_two(name: str) -> None:
    statement, lines = CASES[name]
    problem, derivation = planned(statement)
    text = to_text(explanation_of(derivation, problem))
    missing = [each for each in lines if each not in text]
    assert not missing, text


def test_no_tangent_is_a_quotient_of_products() -> None:
    for statement, _ in CASES.values():
        derivation = plan(solve(parse(statement)))
        assert all(each.move.record != "tan-deflection" for each in derivation.lines)


TURNED = """
sphere A: mass m, velocity u at 60°
sphere B: mass m, velocity 2u at 60° from -i
A hits B: along i, e = 1/4
"""


def _printed(asked: str) -> str:
    text = f"{TURNED}find {asked}\n"
    return to_text(explain(solve(parse(text))), 100)


def test_an_angle_of_two_others_has_no_lines_of_inverse_tangents() -> None:
    text = _printed("deflection(A), angle(velocity(A), velocity(B))")
    assert "β = arctan" not in text
    assert "= 180° − 60° − arctan(8√3/7) = 120° − arctan(8√3/7)" in text


def test_an_inverse_tangent_that_is_asked_stands() -> None:
    text = _printed("deflection(A), angle(velocity(A), line_of_centres)")
    assert "β = arctan(8√3/7)" in text


def test_which_way_a_sphere_turns_rests_on_the_velocity_of_the_other() -> None:
    problem, derivation = planned(CASES["a given turn of who is pushed on"][0])
    (turn,) = (each for each in derivation.lines if each.move.record == "difference")
    assert "velocity A" in turn.premises
    others = tuple(each for each in turn.premises if each != "velocity A")
    assert isinstance(turn.relation, Relation)
    own, *_ = turn.relation.only
    assert isinstance(own.right, Binary)
    away = Relation(((replace(own, right=replace(own.right, op="+")),),))
    for wrong in (replace(turn, premises=others), replace(turn, relation=away)):
        lines = tuple(wrong if each == turn else each for each in derivation.lines)
        assert follow(replace(derivation, lines=lines), oracle_of(problem))


@pytest.mark.parametrize(
    ("angle", "more"),
    [
        ("45°", "given e <= 1/3\nshow deflection(A) <= 45°"),
        ("theta", "given deflection(A) = 60°, e = 1/3\nfind theta"),
    ],
)
def test_a_turn_rests_on_what_does_not_change_across_the_line_of_centres(
    angle: str, more: str
) -> None:
    text = f"""
sphere A: mass m, velocity u at {angle}
sphere B: mass 3m, at rest
A hits B: along i, e = e
{more}
"""
    problem = parse(text)
    derivation = plan(solve(problem))
    (turn,) = (line for line in derivation.lines if line.move.record == "difference")
    (kept,) = (line for line in derivation.lines if line.move.record == "unchanged")
    assert kept.number in turn.premises
    less = replace(turn, premises=tuple(ref for ref in turn.premises if ref != kept.number))
    lines = tuple(less if line == turn else line for line in derivation.lines)
    assert follow(replace(derivation, lines=lines), oracle_of(problem))


def test_to_which_side_a_sphere_goes_along_the_line_of_centres_may_be_open() -> None:
    text = """
sphere A: mass m, velocity u at theta
sphere B: mass 2m, velocity -v i
A hits B: along i, e = 1/2
find angle(velocity(A), velocity(B))
"""
    working = to_text(explain(solve(parse(text))), 200)
    assert "β = arccos(v(v − u cos θ)/(|v − u cos θ|√(v² + u² sin²θ)))" in working


def test_an_angle_with_letters_has_its_constant_in_degrees() -> None:
    value = (sp.pi - 2 * sp.Symbol("alpha", positive=True)) / 2
    assert write_expression(tree_of(sp.factor(value), angle=True)) == "90° - alpha"


@pytest.mark.parametrize(
    ("given", "asked", "line"),
    [
        ("given deflection(A) = 30°", "find e", "tan 30° = ((1 + e)u/2)/u"),
        ("given tan(deflection(A)) = 2/3", "find e", "⅔ = ((1 + e)u/2)/u"),
        ("", "find tan(deflection(A))", "tan δ = ((1 + e)u/2)/u = (1 + e)/2"),
    ],
)
def test_who_came_across_the_line_of_centres_turns_from_its_own_direction(
    given: str, asked: str, line: str
) -> None:
    text = f"""
sphere A: mass 3m, velocity u j
sphere B: mass m, velocity -2u i
A hits B: along i
{given}
{asked}
"""
    shown = " ".join(to_text(explain(solve(parse(text)), check=True)).split())
    assert "A came in the direction of 𝐣, so the angle of deflection is the one" in shown
    assert line in shown


# Where a wall runs, at which angle from i a sphere comes, and its angle to the wall.
PATHS = (("i", 215, 35), ("i", 290, 70), ("j", 335, 65), ("20°", 265, 65), ("-40°", 300, 20))


@pytest.mark.parametrize(("wall", "path", "angle"), PATHS)
def test_an_angle_from_i_of_more_than_a_straight_one_adds_up_at_a_wall(
    wall: str, path: int, angle: int
) -> None:
    problem, derivation = planned(
        f"wall W: along {wall}\nsphere P: velocity u at {path}°\nP hits W\n"
        f"given deflection(P) = {angle + 10}°\nfind e"
    )
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert f"β = {angle + 10}° − {angle}° = 10°" in text
    assert not follow(derivation, oracle_of(problem))


def test_two_equal_deflections_that_are_right_angles_have_no_tangent() -> None:
    """Where 1 − tan 30° tan 60° is zero the scalar products say it."""
    statement = (
        "sphere A: mass m, velocity u at 30°\nsphere B: mass m, velocity u at -150°\n"
        "A hits B: along i, e = 1/3\nshow deflection(A) = deflection(B)\nfind deflection(A)"
    )
    said = " ".join(str(explain(solve(parse(statement)), check=True)).split())
    assert "𝐮_B · 𝐯_B = −(√3 u/2)(√3 u/6) + (u/2)(u/2) = 0" in said
    assert "follow" not in said


def test_the_complement_of_an_angle_with_a_ratio_is_put_in_by_its_inverse() -> None:
    problem, derivation = planned(
        "wall W: along j\nsphere P: mass 2, velocity u at alpha\nP hits W: e = 1/2\n"
        "given tan(alpha) = 3/4\nfind deflection(P)"
    )
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert "δ = 90° − α + β = 90° − arctan(3/4) + arctan(2/3)" in text
    assert not follow(derivation, oracle_of(problem))


def test_ratios_of_angles_apart_are_one_on_a_slanting_line() -> None:
    problem, derivation = planned(
        "sphere A: mass 3, velocity u at 125°\nsphere B: mass 0.5, at rest\n"
        "A hits B: along i + j, e = 0.6\nfind speed(B)"
    )
    assert any(
        "10°" in write_expression(tree)
        for line in derivation.lines
        if isinstance(line.relation, Relation)
        for tree in line.relation.trees
    )
    assert not follow(derivation, oracle_of(problem))


def test_spheres_that_approach_against_a_line_as_it_stands_do_so_in_the_facts() -> None:
    problem = parse(
        "sphere A: mass 3, velocity u at 200°\nsphere B: mass 2, at rest\n"
        "A hits B: along 3i + 4j, e = 2/3\nfind speed(B)"
    )
    (fact,) = (own for own in facts_of(problem) if own.id == "approach 1")
    assert isinstance(fact.relation, Relation)
    assert fact.relation.only[0].sign == "<"


@pytest.mark.parametrize(
    ("given", "lines"),
    [
        ("3 angle(velocity(P), W)", ("deflection of P is 3β", "60° + β = 3β", "β = 30°")),
        ("2 angle(velocity(P), W) + 25°", ("60° + β = 2β + 25°", "tan 35° = ")),
    ],
)
def test_a_deflection_by_the_angle_after_is_one_of_degrees_with_that_before(
    given: str, lines: tuple[str, ...]
) -> None:
    problem, derivation = planned(
        "wall W: along 30°\nsphere P: mass 0.5, velocity 4 at 60° to W\nP hits W\n"
        f"given deflection(P) = {given}\nfind e"
    )
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert not [line for line in lines if line not in text], text
    assert not follow(derivation, oracle_of(problem))


def test_a_ball_that_turns_through_its_angle_to_the_wall_leaves_along_it() -> None:
    """Its component away from the wall is nothing, in neither sense."""
    statement = (
        "wall W: along j\nsphere P: mass 2, velocity 6 at 60° to W\nP hits W\n"
        "given deflection(P) = 60°\nfind e"
    )
    said = " ".join(str(explain(solve(parse(statement)), check=True)).split())
    assert "tan 0° = 3√3 e/3 DM1 e = 0" in said
    assert "follow" not in said


def test_the_tangent_of_a_deflection_beside_degrees_for_a_calculator() -> None:
    text = (
        "wall W: along {}\nsphere P: mass m, velocity 3u at {}° to W\nP hits W\n"
        "given tan(deflection(P)) = {}\nfind velocity(P)\n"
    )
    for wall, degrees, tangent in (("j", 25, 1), ("i", 35, "4/3"), ("j", 40, 2)):
        solution = solve(parse(text.format(wall, degrees, tangent)))
        explanation = explain(solution, check=True)
        assert explanation.followed
        assert f"tan δ = (tan {degrees}° + tan β)/(1 − tan {degrees}° tan β)" in to_text(
            explanation, 120
        )


@pytest.mark.parametrize(
    ("wall", "velocity", "given"),
    [
        ("30°", "2u at alpha to W", "cos(alpha) = 5/13, deflection(P) = 60°"),
        ("3i + 4j", "3u at alpha to W", "tan(alpha) = 2, deflection(P) = 60°"),
        ("j", "5 at theta to W", "tan(theta) = 4/3, deflection(P) = 45°"),
    ],
)
def test_a_negative_coefficient_by_a_deflection_is_worked_out(
    wall: str, velocity: str, given: str
) -> None:
    text = f"wall W: along {wall}\nsphere P: mass m, velocity {velocity}\nP hits W\n"
    explanation = explain(solve(parse(f"{text}given {given}\nfind e\n")), check=True)
    shown = " ".join(to_text(explanation, 120).split())
    assert explanation.followed
    assert "a coefficient of restitution is not negative" in shown
    assert "P turns through the sum" not in shown
    assert "not written out" not in shown
    assert "It is given that the angle of deflection of P is" in shown


def test_a_negative_coefficient_by_the_tangent_of_a_deflection_is_worked_out() -> None:
    text = "wall W: along j\nsphere P: mass 0.5, velocity 3i + j\nP hits W\n"
    explanation = explain(
        solve(parse(f"{text}given tan(deflection(P)) = 2\nfind e, impulse\n")), check=True
    )
    shown = " ".join(to_text(explanation, 120).split())
    assert explanation.followed
    assert "2 = (3 + 3e)/(−3 × 3e + 1)" in shown
    assert "not written out" not in shown


@pytest.mark.parametrize("mass", ["m", "k m"])
def test_a_deflection_that_a_direct_impact_excludes_rests_on_its_line_alone(mass: str) -> None:
    text = (
        f"sphere A: mass 2m, velocity 5i\nsphere B: mass {mass}, at rest\nA hits B: along i\n"
        "given deflection(A) = 30°\nfind direction(B)\n"
    )
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation, 120).split())
    assert explanation.followed
    assert "so it goes straight on or straight back: tan δ = 0" in " ".join(shown.split())
    assert "the data contradict each other" in shown


@pytest.mark.parametrize(
    ("wall", "velocity"), [("i", "2i + 4j"), ("j", "4i + 2j"), ("i", "u(i - 2j)")]
)
def test_the_tangent_after_a_wall_has_the_sign_for_any_coefficient(
    wall: str, velocity: str
) -> None:
    text = (
        f"wall W: along {wall}\nsphere P: mass m, velocity {velocity}\nP hits W\n"
        "given tan(deflection(P)) = 2\nfind e\n"
    )
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    assert "2 = (2 + 2e)/(1 − 4e)" in to_text(explanation, 120)


@pytest.mark.parametrize(
    ("wall", "turned", "lines"),
    [
        ("45°", "75°", ("and W = 45°", "β = 75° − 45° = 30°")),
        ("150°", "80°", ("and W = 30°", "β = 80° − 30° = 50°")),
        ("j + sqrt(3) i", "30°", ("θ = 30° − 30° = 0°", "e = 0")),
    ],
)
def test_a_sphere_set_in_motion_comes_to_a_wall_at_the_angle_of_its_line_of_centres(
    wall: str, turned: str, lines: tuple[str, ...]
) -> None:
    text = (
        "sphere A: mass 3m, velocity u i\nsphere B: mass 2m, at rest\n"
        f"wall W: along {wall}\nA hits B: along i\nB hits W\n"
        f"given deflection(B) = {turned}\nfind e\n"
    )
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation, 120).split())
    assert explanation.followed
    assert not [line for line in lines if line not in shown], shown


@pytest.mark.parametrize(
    ("first", "turned", "lines"),
    [
        ("show speed(B) = sqrt(3)/6 (1 + e) u", "30°", ("θ = 30° + 30° = 60°", "v = √3 u/6")),
        ("find speed(A)", "45°", ("θ = 45° + 30° = 75°", "tan 75° = (u/2)/(√3(1 − 2e)u/6)")),
        ("find speed(A)", "80°", ("180° less both", "θ = 180° − 80° − 30° = 70°")),
    ],
)
def test_a_deflection_that_is_given_tells_how_a_sphere_goes_on_along_the_line_of_centres(
    first: str, turned: str, lines: tuple[str, ...]
) -> None:
    """No part of the statement tells in which sense A leaves; a vector product is not asked."""
    text = (
        "sphere A: mass m, velocity u i, radius r\nsphere B: mass 2m, at rest, radius r\n"
        f"A hits B: offset r\npart a\n{first}\npart b\ngiven deflection(A) = {turned}\nfind e\n"
    )
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation, 120).split())
    assert explanation.followed
    assert not [line for line in lines if line not in shown], shown


def test_the_sense_after_an_impact_rests_on_the_deflection_that_is_given() -> None:
    text = (
        "sphere A: mass m, velocity 4i + 3j\nsphere B: mass 4m, at rest\nA hits B: along i + j\n"
        "part a\nfind along(velocity(A), i + j)\npart b\ngiven deflection(A) = 45°\nfind e\n"
    )
    problem, derivation = planned(text)
    assert not follow(derivation, oracle_of(problem))
    for line in derivation.lines:
        if line.move.record in ("difference", "tan") and "given 1" in line.premises:
            premises = tuple(ref for ref in line.premises if ref != "given 1")
            lines = tuple(
                replace(e, premises=premises) if e is line else e for e in derivation.lines
            )
            assert follow(replace(derivation, lines=lines), oracle_of(problem))
    shown = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert "β − θ = 45°" in shown
    assert "e = 13/112" in shown


@pytest.mark.parametrize(
    "text",
    [
        # A speed that is one component in ratios of angles in degrees has the form of that.
        (
            "sphere A: mass m, velocity u at 60°\nsphere B: mass m, at rest\nA hits B: along i\n"
            "given deflection(A) = 20°\nfind speed(B)\n"
        ),
        (
            "sphere P: mass m, velocity v at 35°\nsphere Q: mass 2m, at rest\nP hits Q: along i\n"
            "given deflection(P) = 25°\nfind speed(Q)\n"
        ),
        # A letter keeps the ratios of the line above it: none of the double of the angle.
        (
            "sphere A: mass 2m, velocity u at alpha\nsphere B: mass 2m, velocity 2u at 180° - 40°\n"
            "A hits B: along i\ngiven tan(alpha) = 3/4, speed(A) = speed(B)\nfind speed(A), e\n"
        ),
        # A component that turns out to be negative is put in before the deflection is.
        (
            "sphere A: mass 3, velocity 2i - 4j\nsphere B: mass 1.5, velocity 8 at 180° - beta\n"
            "A hits B: along j\ngiven tan(beta) = 3/4, deflection(A) = 20°\nfind e\n"
        ),
        # What a law says stands once, also where a part between had values put in at first.
        (
            "sphere A: mass 2m, velocity u at alpha\nsphere B: mass m, at rest\n"
            "A hits B: along i, e = 1/2\npart a\nfind along(velocity(A), i)\n"
            "part b\ngiven tan(alpha) = 2\nfind angle(velocity(A), velocity(B))\n"
            "part c\ngiven deflection(A) = 90°\nfind speed(B)\n"
        ),
    ],
)
def test_a_working_with_angles_in_degrees_is_followed(text: str) -> None:
    problem = parse(text)
    derivation = plan(solve(problem), partial=True)
    assert not follow(derivation, oracle_of(problem))


@pytest.mark.parametrize(
    ("e", "words", "angle"),
    [
        (
            "1/2",
            "B goes on along the line of centres in the same sense, so it is not turned:",
            "0°",
        ),
        ("1", "B is sent straight back along the line of centres:", "180°"),
    ],
)
def test_along_the_line_of_centres_a_sphere_goes_on_or_comes_back(
    e: str, words: str, angle: str
) -> None:
    text = to_text(
        explain(
            solve(
                parse(f"""
sphere A: mass 2, velocity 2i + j
sphere B: mass 3, velocity -3i - 4j
A hits B: along 3i + 4j, e = {e}
find deflection(B)
""")
            )
        )
    )
    assert f"{words} δ = {angle}" in " ".join(text.split())


@pytest.mark.parametrize(
    ("claim", "line", "conclusion"),
    [
        (
            "velocity(A) - velocity(B) perpendicular to i + j",
            "(𝐯_A − 𝐯_B) · (𝐢 + 𝐣) = 2 − 2 = 0",
            "So 𝐯_A − 𝐯_B is perpendicular to 𝐢 + 𝐣, as required.",
        ),
        (
            "velocity(A) - velocity(B) perpendicular to line_of_centres",
            "(𝐯_A − 𝐯_B) · 𝐧 =",
            "So 𝐯_A − 𝐯_B is perpendicular to the line of centres, as required.",
        ),
        (
            "velocity(A) - velocity(A, 0) parallel to i + j",
            "𝐯_A − 𝐮_A = −(9/5)(𝐢 + 𝐣)",
            "So 𝐯_A − 𝐮_A is parallel to 𝐢 + 𝐣, as required.",
        ),
    ],
)
def test_the_direction_of_a_difference_of_velocities_is_shown(
    claim: str, line: str, conclusion: str
) -> None:
    text = to_text(
        explain(
            solve(
                parse(f"""
sphere A: mass 2, velocity 5i - j
sphere B: mass 3, velocity -2j
A hits B: along i + j, e = 0
find velocity(A), velocity(B)
show {claim}
""")
            )
        )
    )
    assert line in text
    assert conclusion in " ".join(text.split())
