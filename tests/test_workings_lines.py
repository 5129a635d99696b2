"""How printed lines read: reasons beside conditions, one name for one thing, the angles of data."""

from __future__ import annotations

from functools import cache

import pytest

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Move
from restitution.explaining.lines.notation import read_meaning, read_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.solving import solve
from restitution.workings import explain, to_text

EQUAL_SPEEDS = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along j
given speed(A) = speed(B)
find tan(alpha) in terms of e
"""
STOPPED = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given direction(A) = 90°
find k
"""
LOST = """
wall W: along j
sphere P: mass m, velocity u at alpha
P hits W
given energy_lost/energy(0) = s
find e
"""
BACK = """
wall W: along j
wall V: along i
sphere P: velocity u at 40° to W
P hits W: e = f
P hits V: e = g
given velocity(P) opposite to velocity(P, 0)
find g
"""
FASTER = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
given speed(B) > speed(A)
find range of e
"""
ACROSS = """
wall R: along j, through (d, 0)
sphere P: at (0, 0), velocity u at 45°
P hits R: e = 1/2
find velocity(P), time(1)
"""
STEEP = """
wall R: along j, through (d, 0)
sphere P: at (0, 0), velocity u at 30°
P hits R: e = 1/2
find velocity(P)
"""
DRIFT = """
wall L: along j, through (0, 0)
wall R: along j, through (d, 0)
sphere P: at (0, 0), velocity u at 45°
P hits R
P hits L
given distance(position(P, 0), position(P)) = 3d
find e, time(2)
"""
THREE_CHORDS = """
wall C: circle centre (0, 0) radius a
point S: (-a, 0)
sphere P: at (-a, 0), velocity u at alpha
P hits C
P hits C
P reaches S
given e = 1
find alpha
"""
TWO_SLANTS = """
sphere A: mass 2, velocity a i + b j
sphere B: mass 3, velocity -i + 2j
A hits B
given impulse(A) = -6i + 3j, e = 1/2
given velocity(A) perpendicular to velocity(A, 0)
find a
"""
OFFSET = """
sphere A: mass m, velocity u i, radius r
sphere B: mass m, at rest, radius r
A hits B: offset r, e = 1/2
find speed(B)
"""

TURNED = """
sphere A: mass m, velocity u at 45°
sphere B: mass 2m, at rest
A hits B: along i
find range of deflection(A)
"""
TABLE = """
wall W1: from (0, 0) to (0, 2)
wall W2: from (0, 2) to (3, 2)
sphere P: at (2, 1), velocity -u i + k u j
P hits W1: e = 2/3
P hits W2: e = 2/3
find range of k
"""
BALL_TO_BALL = """
sphere A, B, C: mass m
sphere A: velocity u i
sphere B, C: at rest
A hits B: along i
B hits C: along 60°
find speed(C)
"""
CANNON = """
sphere A, B, C: mass m
sphere A: velocity u i
sphere B, C: at rest
A hits B: along 30°, e = 1
A hits C: along -30°, e = 1
find velocity(A)
"""
PARALLEL = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, velocity u at beta from -i
given tan(alpha) = 2, tan(beta) = 1
A hits B: along i
given velocity(A) parallel to velocity(B)
find e
"""

SPARE = """
wall W: along i, through (0, 0)
sphere P: mass 2, at (0, 4), velocity u at 30° to W
P hits W: e = 1/2
given time(1) = 2, impulse = 6
find u, velocity(P)
"""

SAME_TO_THE_WALL = """
wall W: along i
sphere P: mass 0.5, velocity 6i - 8j
P hits W: e = 1/2
find direction(P), angle(velocity(P), W)
"""
SAME_TO_THE_AXIS = """
sphere A: mass m, velocity u at alpha
sphere B: mass M, at rest
A hits B: along i
find tan(direction(A))
find tan(deflection(A))
"""
SAME_TO_THE_LINE = """
sphere A: mass m, velocity u at alpha
sphere B: mass 2m, at rest
A hits B: along i, e = 1/3
find range of angle(velocity(A), velocity(B)) in terms of u
find maximum of deflection(A) over alpha
"""
FROM_BELOW = """
wall W: along i
sphere P: mass 1, velocity {}6i + 8j
P hits W: e = 1/2
find direction(P), angle(velocity(P), W)
"""

TRIANGLE = """
wall AB: from (0, 0) to (4, 0)
wall BC: from (4, 0) to (0, 3)
sphere P: at (1, 1), velocity -j
P hits AB: e = 1/2
P hits BC: e = 1/2
find velocity(P)
"""
UPWARDS = """
sphere A, B, C: mass m
sphere A: velocity u j
sphere B, C: at rest
A hits B: along j
B hits C: along 60°
find speed(C)
"""


@cache
def working(text: str) -> str:
    """A printed working, with single spaces."""
    return " ".join(to_text(explain(solve(parse(text))), 80).split())


# --- conditions ----------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        (EQUAL_SPEEDS, "As α is acute, this holds for e > 0 only."),
        (STOPPED, "As e = 0 gives no value of k, this holds for e > 0 only."),
        (LOST, "As e² ≥ 0, this holds for s ≤ cos²α only."),
        (BACK, "As P is still moving at the end, this holds for f > 0 only."),
        (FASTER, "This holds for α < 45° only, as there is no such e otherwise."),
    ],
)
def test_a_condition_has_its_reason(text: str, sentence: str) -> None:
    assert sentence in working(text)


def test_a_condition_of_a_divisor_that_an_earlier_part_shows_is_plain() -> None:
    """``tan²α = 1/e`` tells of itself that e is not 0, as ``tan²α = e`` does not."""
    text = """
wall W: along {way}
sphere P: mass m, velocity u at alpha{to}
P hits W
given deflection(P) = 90°
part a
show tan(alpha)^2 = {square}
part b
find energy_lost/energy(0) in terms of e
"""
    condition = "As α is acute, this holds for e > 0 only."
    assert condition not in working(text.format(way="i", to=" to W", square="1/e"))
    assert condition in working(text.format(way="j", to="", square="e"))


# --- angles of the data --------------------------------------------------------------------------


def test_a_component_is_by_the_angle_that_is_told() -> None:
    assert "stays u sin 45°" in working(ACROSS)
    assert "= −½u cos 45°" in working(ACROSS)
    assert "d/(u cos 45°)" in working(ACROSS)
    assert "stays u sin 30°" in working(STEEP)
    assert "cos 60°" not in working(STEEP)


def test_a_component_in_which_a_value_is_put_stands_before_its_use() -> None:
    text = working(DRIFT)
    assert text.index("component of 𝐯_P along 𝐢 = −√2 u/4") < text.index("t₂ − t₁ =")


# --- one name for one thing ----------------------------------------------------------------------


def test_angles_of_one_tangent_are_one_angle() -> None:
    text = working(THREE_CHORDS)
    for each in ("3(180° − 2α) = 360°", "3α = 90°", "α = 30°"):
        assert each in text
    assert "α, that of the first chord with the radius at the start." in " ".join(text.split())
    assert "tan²α" not in text


def test_an_angle_that_is_known_by_another_name_is_that() -> None:
    text = working(SAME_TO_THE_WALL)
    assert "W is along 𝐢, so the two angles are equal: β = θ = arctan(2/3) ≈ 33.7°" in text
    assert text.count("4/6") == 1
    text = working(SAME_TO_THE_AXIS)
    assert "the angles that its velocities make with 𝐢: δ = θ − α" in text
    assert "β" not in text
    assert text.count("u sin α/(") == 1
    text = working(SAME_TO_THE_LINE)
    assert "B was at rest, so it moves along the line of centres: tan β = " in text
    assert "so it turns through the difference of its angles to that line: δ = β − α" in text
    assert "θ" not in text
    assert text.count("u sin α/(") == 1


@pytest.mark.parametrize(
    ("sign", "right"), [("", "-theta"), ("-", "180° + theta"), ("", None), ("-", None)]
)
def test_an_angle_to_a_wall_by_a_direction_has_its_sign(sign: str, right: str | None) -> None:
    """Below **i** the angle to a wall along **i** is not the direction, but what goes with it."""
    problem = parse(FROM_BELOW.format(sign))
    facts, events = facts_of(problem), events_of(problem)
    names = {"P": "sphere", "W": "wall"}
    x = "-6" if sign else "6"
    below = [
        ("law", "unchanged", f"along(velocity(P, 1), i) = {x}", ("velocity P", "axis 1")),
        (
            "law",
            "restitution-wall",
            "along(velocity(P, 1), j) = -4",
            ("velocity P", "axis 1", "e 1"),
        ),
    ]
    lines = [
        Line(1, "1", Move("let"), (), read_meaning("let theta = direction(P, 1)", names)),
        Line(2, "1", Move("let"), (), read_meaning("let beta = angle(velocity(P, 1), W)", names)),
    ]
    for number, (move, record, relation, refs) in enumerate(below, 3):
        own = Move(move, record, 1, ("P",))  # type: ignore[arg-type]
        lines.append(Line(number, "1", own, refs, read_relation(relation, names)))
    claim = read_relation(f"beta = {right or 'theta'}", names)
    move = Move("define", "difference", 1, ("P",))
    lines.append(Line(5, "1", move, ("wall W", 1, 2, 3, 4), claim))
    whole = Derivation(facts, tuple(lines), (), events)
    refused = {e.line for e in follow(whole, Oracle({})) if e.reason == "does-not-follow"}
    assert refused == (set() if right else {5})


# --- unit vectors --------------------------------------------------------------------------------


def test_unit_vectors_stand_above_cases() -> None:
    text = working(TWO_SLANTS)
    assert "Scalar products with 2𝐢 − 𝐣, along the line of centres, before the impact:" in text
    assert "𝐮_A · (2𝐢 − 𝐣) = 2a − b" in text


def test_a_wall_between_points_has_unit_vectors() -> None:
    text = working(TRIANGLE)
    assert "𝐧 = (3𝐢 + 4𝐣)/5 be the unit vector perpendicular to BC, towards it" in text
    assert "𝐯₂ · 𝐧 = −½ × ⅖ = −⅕" in text


def test_a_direction_across_is_told_where_it_is_used() -> None:
    assert "perpendicular to it" not in working(OFFSET)
    sideways = OFFSET.replace("find speed(B)", "find speed(A)")
    assert "𝐭 = −½𝐢 + (√3/2)𝐣 the one perpendicular to it" in working(sideways)


# --- reasons behind lines ------------------------------------------------------------------------


def test_a_tangent_holds_where_one_of_its_angles_is_right() -> None:
    text = working(TURNED)
    assert "β = 90°" not in text  # it is said once, below
    assert "= (1 + e)/(2 − e) which holds if e = ½ too, where δ = 45°" in text


def test_a_tangent_holds_at_a_right_angle_beside_one_that_a_line_tells_in_numbers() -> None:
    text = working(
        "sphere A: mass m, velocity 3u i + 4u j\nsphere B: mass 2m, velocity -u i\n"
        "A hits B: along i\nfind tan(deflection(A)) in terms of e"
    )
    assert "which holds if e = ⅛ too, where δ = 90° − θ" in text


def test_walls_that_are_hit_in_the_whole_range_are_named() -> None:
    text = working(TABLE)
    assert "0 < 2 − 4k < 9k, as k > 0" in text
    assert "In this range 0 < 1 + 2k < 2, so P hits W1 between its ends too." in text


def test_a_wall_that_is_hit_in_an_earlier_part_is_named_there() -> None:
    text = working("""
point O: (0, 0)
wall OX: from O to (6, 0)
wall OY: from O to (0, 1)
sphere P: at (4, 2), velocity -u i - u j
part a
P hits OX: e = e
find position(P, 1)
part b
P hits OY
find range of e
""")
    first, second = text.split("(b)", 1)
    assert "P hits OX between its ends, as 0 < 2 < 6." in first
    assert "P hits OY between its ends:" in second
    assert "OX between" not in second


def test_a_share_of_the_energy_in_numbers_is_multiplied_out() -> None:
    text = working("""
wall W: along i
sphere P: velocity 10 at alpha to W
P hits W
given tan(alpha) = 4/3, energy_lost = 40% of energy(0)
find e
""")
    assert "8² − (8e)² = ⅖ × 10² DM1 A1 64(1 − e²) = 40 e² = ⅜" in text


def test_a_letter_that_takes_the_place_of_its_value_is_not_substituted_for() -> None:
    text = working("""
sphere A: mass m, velocity u at alpha
sphere B: mass k m, at rest
A hits B: along i
given velocity(A) perpendicular to line_of_centres
part a
show e = 1/k
part b
show energy_lost = 1/2 m u^2 (1 - e) cos^2(alpha)
""")
    assert "= (k − 1)mu² cos²α/(2k) = ½mu²(1 − 1/k) cos²α M1" in text
    assert "Since 1/k = e, with e from part (a): kinetic energy lost = ½mu²(1 − e) cos²α" in text
    assert "Substituting for e" not in text


def test_ratios_by_a_tangent_with_a_surd_share_one_root() -> None:
    text = working("""
wall AB: along i
wall BC: along 120°
sphere P: velocity u at alpha to AB
P hits AB: e = e
given velocity(P, 1) perpendicular to BC
part a
show tan(alpha) = 1/(e sqrt(3))
part b
P hits BC: e = e
find speed(P) in terms of u, e
""")
    assert "√3 eu/√(1 + 3e²)" in text or "3e²u²/(1 + 3e²)" in text
    assert "9e²" not in text


def test_a_velocity_of_one_component_is_told_before_it_is_resolved() -> None:
    text = working(BALL_TO_BALL)
    told = "B was at rest before the first impact, so it moved off along the line of centres"
    resolved = "Component before the impact: 𝐯_B · 𝐧 = ((1 + e)u/2) cos {} ="
    both = f"{told} of that impact, at {{}} to this one. {resolved}"
    assert both.format("60°", "60°") in text
    assert both.format("30°", "30°") in working(UPWARDS)
    told = "A moves perpendicular to the line of centres of its last impact, at 30° to this"
    resolved = "one. Components before the impact: 𝐯_A1 · 𝐧₂ = (u/2) cos 30° ="
    assert f"{told} {resolved}" in working(CANNON)


def test_a_sum_with_roots_is_below_a_line_before_it_is_gone() -> None:
    text = working(PARALLEL)
    assert "(√5 − 5√2)u = (10 − 2√10)w" in text
    multiplied = "(√5 − 5√2)u(5 + √10)/((10 − 2√10)(5 + √10))"
    assert f"w = (√5 − 5√2)u/(10 − 2√10) = {multiplied} = −(√5 + 4√2)u/6" in text


# --- facts that are not needed -------------------------------------------------------------------


def test_a_fact_that_follows_is_no_complaint() -> None:
    solution = solve(parse(SPARE))
    assert explain(solution, check=True).followed
    assert "It is also given that the magnitude of the impulse is 6 N s" in working(SPARE)
