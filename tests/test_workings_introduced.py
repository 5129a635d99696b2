"""Workings in which all is introduced before it is used, and nothing is done or marked twice."""

from __future__ import annotations

from dataclasses import replace

import pytest
from workings import planned, printed_with

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.oracle import Oracle
from restitution.solving.story.letters import roles
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

BY_AN_OFFSET = """
sphere A, B: mass m, radius r
sphere A: velocity u i
sphere B: at rest
A hits B: offset d, e = 1/2
given speed(B) = 3/5 u
find d, {item}
"""
TO_THE_RIGHT = """
sphere A: mass 2m, velocity 3u j, radius a
sphere B: mass m, at rest, radius a
A hits B: offset -d, e = 1/3
given speed(B) = 32u/15
find line_of_centres, velocity(A)
"""
BY_DEGREES = """
sphere A: mass m, velocity u i
sphere B: mass m, at rest
A hits B: along {angle}, e = 1/2
find velocity(A)
"""
AT_A_WALL = """
wall W: along {angle}
sphere P: mass m, velocity u i
P hits W: e = 1/2
find velocity(P)
"""
FROM_REST = """
wall W: along i
sphere A: mass m, velocity 2u at 60° to W
sphere B: mass m, at rest
A hits B: along -60°, e = 1/2
B hits W: e = 2/3
find speed(B, 1), velocity(B, 2)
"""
TWO_SPEEDS = """
sphere A: mass 3, velocity 3i + 2j
sphere B: mass 2, velocity -3i - 2j
A hits B: along i, e = 2/3
find dot(velocity(A), velocity(B)), angle(velocity(A), velocity(B))
"""
ONE_CHANGE = """
wall W
sphere P: mass {mass}, velocity 4i - 3j
P hits W
given velocity(P) = -i - 2j
find e, direction(W), impulse
"""


@pytest.mark.parametrize("item", ["velocity(A)", "velocity(A), direction(A)", "line_of_centres"])
def test_a_unit_vector_has_its_angle_with_the_path(item: str) -> None:
    """The letter for the angle is in it, as its sine and cosine are found further down."""
    let = "Let 𝐧 = cos φ 𝐢 + sin φ 𝐣 be the unit vector along the line of centres."
    parts = ["Let φ be the angle", let, "cos φ = ⅘ sin φ = ⅗"]
    if "velocity" in item:
        parts.append("𝐯_A = u𝐢 − (4u/5 − u/5)((4𝐢 + 3𝐣)/5)")
    else:
        parts.append(
            "The line of centres makes the angle φ with the path of A, to the left of it: "
            "unit vector along the line of centres = cos φ 𝐢 + sin φ 𝐣 = (4𝐢 + 3𝐣)/5"
        )
    printed_with(BY_AN_OFFSET.format(item=item), parts)


def test_a_line_of_centres_to_the_right_of_a_path() -> None:
    """Of a path along **j**: the follower refuses the sine and the cosine exchanged."""
    printed_with(
        TO_THE_RIGHT,
        [
            "Let 𝐧 = sin φ 𝐢 + cos φ 𝐣 be",
            "makes the angle φ with the path of A, to the right of it:",
            "= sin φ 𝐢 + cos φ 𝐣 = (3𝐢 + 4𝐣)/5",
            "𝐯_A = 3u𝐣 − (12u/5 − 4u/3)((3𝐢 + 4𝐣)/5)",
        ],
    )
    problem, derivation = planned(TO_THE_RIGHT)
    (line,) = [
        line
        for line in derivation.lines
        if line.move.id == "fact" and isinstance(line.relation, Relation)
    ]
    assert isinstance(line.relation, Relation)
    text = write_relation(line.relation)
    assert "sin(phi) i + cos(phi) j" in text
    own = Oracle(roles(problem))
    for wrong in ("cos(phi) i + sin(phi) j", "sin(phi) i - cos(phi) j"):
        relation = read_relation(text.replace("sin(phi) i + cos(phi) j", wrong), {})
        lines = tuple(replace(e, relation=relation) if e == line else e for e in derivation.lines)
        assert [each.line for each in follow(replace(derivation, lines=lines), own)]


@pytest.mark.parametrize(
    ("angle", "unit"),
    [
        ("60°", "from A to B, is cos 60° 𝐢 + sin 60° 𝐣 = ½𝐢 + (√3/2)𝐣."),
        ("-30°", "from A to B, is cos 30° 𝐢 − sin 30° 𝐣 = (√3/2)𝐢 − ½𝐣."),
    ],
)
def test_a_unit_vector_in_degrees_is_introduced(angle: str, unit: str) -> None:
    """Components are by the angle itself, so that no letter for the unit vector stands above."""
    text = printed_with(
        BY_DEGREES.format(angle=angle),
        [unit, "The velocity changes along the line of centres only: 𝐯_A = u𝐢"],
    )
    assert text.count("unit vector") == 1


def test_a_unit_vector_of_a_wall_in_degrees_is_introduced() -> None:
    printed_with(
        AT_A_WALL.format(angle="30°"),
        [
            "perpendicular to W, towards it, is sin 30° 𝐢 − cos 30° 𝐣 = ½𝐢 − (√3/2)𝐣.",
            "The velocity changes perpendicular to W only:",
        ],
    )


@pytest.mark.parametrize(
    ("statement", "unit", "component"),
    [
        (BY_DEGREES.format(angle="arctan(3/4)"), "𝐧 = (4𝐢 + 3𝐣)/5 be", "𝐮_A · 𝐧 = 4u/5"),
        (BY_DEGREES.format(angle="-arcsin(5/13)"), "𝐧 = (12𝐢 − 5𝐣)/13 be", "𝐮_A · 𝐧 = 12u/13"),
        (AT_A_WALL.format(angle="arctan(3/4)"), "𝐧 = (3𝐢 − 4𝐣)/5 be", "𝐮_P · 𝐧 = 3u/5"),
    ],
)
def test_a_direction_by_a_ratio_has_a_unit_vector(
    statement: str, unit: str, component: str
) -> None:
    printed_with(statement, [unit, component, "only:"])


def test_that_a_sphere_was_at_rest_is_said_once() -> None:
    """Its speed is the item above, and its components at the wall come next."""
    text = printed_with(
        FROM_REST,
        [
            "B was at rest, so it moves along the line of centres: speed of B = 3u/2",
            "B moves at 60° to W. Components before the impact:",
        ],
    )
    assert text.count("at rest") == 1


def test_speeds_for_a_scalar_product_have_no_marks_of_their_own() -> None:
    problem, derivation = planned(TWO_SPEEDS)
    text = " ".join(to_text(explanation_of(awarded(derivation), problem)).split())
    assert "speed of A = √(1² + 2²) = √5 m s⁻¹ speed of B = √(3² + 2²) = √13 m s⁻¹ Let β" in text
    assert "cos β = −7/(√5√13) = −7√65/65 M1 A1" in text
    # Where a speed is asked, it is a method; so is one on the way to an energy.
    problem, derivation = planned(TWO_SPEEDS.replace("find dot", "find speed(A), dot"))
    text = " ".join(to_text(explanation_of(awarded(derivation), problem)).split())
    assert "speed of A = √(1² + 2²) = √5 ≈ 2.24 m s⁻¹ M1 A1" in text


@pytest.mark.parametrize(("mass", "impulse"), [("1", "−5𝐢 + 𝐣"), ("3", "−15𝐢 + 3𝐣")])
def test_a_change_of_velocity_is_worked_out_once(mass: str, impulse: str) -> None:
    """The size of the impulse is asked: the normal is along the impulse."""
    text = printed_with(
        ONE_CHANGE.format(mass=mass),
        [
            f"= ({impulse}) N s",
            f"the normal to W is parallel to {impulse}",
            "is in the direction of 5𝐢 − 𝐣",
            "magnitude of the impulse = ",
        ],
    )
    assert text.count("(−𝐢 − 2𝐣) − (4𝐢 − 3𝐣)") == 1


KICKED = """
sphere P: mass 2, velocity {velocity}
P receives J at theta
given J = {size}, speed(P) = {speed}
find {asked}
"""


@pytest.mark.parametrize(
    ("velocity", "size", "speed", "asked", "cosine"),
    [
        ("5i", "8", "7", "cos(theta), deflection(P)", "5(5 + 4 × ⅕)/(5 × 7) = 29/35"),
        ("5j", "8", "7", "sin(theta), deflection(P)", "5(5 + 4 × ⅕)/(5 × 7) = 29/35"),
        ("-6i", "8", "5", "cos(theta), deflection(P)", "−6(4 × (9/16) − 6)/(6 × 5) = ¾"),
    ],
)
def test_only_the_component_that_is_used_is_worked_out(
    velocity: str, size: str, speed: str, asked: str, cosine: str
) -> None:
    """The velocity before is along an axis, and the speed is given."""
    text = printed_with(
        KICKED.format(velocity=velocity, size=size, speed=speed, asked=asked),
        [f"cos δ = {cosine}"],
    )
    assert "√" not in text


def test_a_velocity_that_is_asked_has_both_components() -> None:
    text = printed_with(
        KICKED.format(
            velocity="5i", size="8", speed="7", asked="cos(theta), velocity(P), deflection(P)"
        ),
        ["𝐯_P = (29/5)𝐢 + (8√6/5)𝐣", "cos δ = (5 × (29/5))/(5 × 7) = 29/35"],
    )
    assert text.count("29/5)𝐢") == 1


IN_PARTS = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
part a
show tan(angle(velocity(P), W)) = e*tan(alpha)
part b
given tan(alpha) = {tangent}, e = {e}
find tan(deflection(P)), speed(P)
"""


@pytest.mark.parametrize(
    ("tangent", "e", "away", "along"),
    [
        ("1", "1/2", "√2 u/4", "√2 u/2"),
        ("3/4", "1/3", "u/5", "4u/5"),
        ("2", "1/8", "√5 u/20", "√5 u/5"),
    ],
)
def test_components_stand_where_they_are_used(tangent: str, e: str, away: str, along: str) -> None:
    """The deflection needs neither; what goes into one of them is named."""
    printed_with(
        IN_PARTS.format(tangent=tangent, e=e),
        [
            "By the formula for the tangent of a sum:",
            "substituting for sin α in (2):",
            f"component of 𝐯_P away from W = {away}",
            "Substituting for cos α in (1):",
            f"component of 𝐯_P parallel to W = {along}",
            "Speed, from its components:",
        ],
    )


MIRRORS = """
wall AB: along i
wall BC: along 60 deg
sphere P: mass m, velocity u at 30° to AB
P hits AB: e = 1
P hits BC: e = 1
show speed(P) = u
show angle(velocity(P), velocity(P, 0)) = 120°
"""
TWO_MIRRORS = """
wall W: along i
wall V: along j
sphere P: mass m, velocity 3u at {angle} to W
P hits W: e = 1
P hits V: e = {e}
show speed(P) = 3u
"""


def test_a_speed_that_walls_keep_is_shown_by_that() -> None:
    printed_with(
        MIRRORS,
        [
            "AB is perfectly elastic, so P keeps its speed:",
            "BC is perfectly elastic, so P keeps its speed:",
            "speed of P after the second impact = u",
            "By the scalar product of 𝐯₂ and 𝐮 = (√3 u/2)𝐢 − (u/2)𝐣:",
        ],
    )
    text = printed_with(TWO_MIRRORS.format(angle="40°", e="1"), ["V is perfectly elastic, so"])
    assert "√" not in text


@pytest.mark.parametrize(
    ("statement", "vector"),
    [
        (
            (
                "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/2\n"
                "given sin(alpha) = 3/5\nfind velocity(P), angle(velocity(P), velocity(P, 0))"
            ),
            "𝐮_P = (4u/5)𝐢 − (3u/5)𝐣:",
        ),
        (
            (
                "sphere A: mass m, velocity 2u at 30°\nsphere B: mass m, velocity u j\n"
                "A hits B: along i, e = 1/2\n"
                "find velocity(B), cos(angle(velocity(B), velocity(A, 0)))"
            ),
            "𝐮_A = √3 u𝐢 + u𝐣:",
        ),
    ],
)
def test_a_velocity_by_its_angle_is_written_out_for_a_product(statement: str, vector: str) -> None:
    printed_with(statement, [vector])


BACK_TO_REST = """
wall W: along i, through (0, 3)
sphere A: mass m, velocity 2u j, at (0, -1)
sphere B: mass {mass}, at rest, at (0, 0)
A hits B: along j, e = 1/2
B hits W: e = 2/3
B hits A
find time(3) - time(1)
"""


def test_who_is_met_again_at_rest_is_said_to_stay() -> None:
    printed_with(
        BACK_TO_REST.format(mass="2m"),
        ["A is at rest, so it stays where it is. Time = distance ÷ speed", "t₃ − t₂ = 3/(2u/3)"],
    )
    # Until it is struck: the line may stand below those that set it in motion.
    struck = BACK_TO_REST.format(mass="2m").replace("time(3) - time(1)", "time(1)")
    printed_with(struck, ["B is at rest until the first impact. Time = distance ÷ speed, for A:"])
    moving = printed_with(BACK_TO_REST.format(mass="3m"), ["t₃ − t₁ ="])
    assert "stays where it is" not in moving


LEFT_OF_THE_ANGLE = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W
given angle(velocity(P), W) = alpha/{share}{more}
find range of e
"""


@pytest.mark.parametrize(("share", "high"), [("3", "⅓"), ("2", "½")])
def test_every_value_between_the_ends_of_a_range_is_taken(share: str, high: str) -> None:
    """Both bounds hold for each angle; that they are the ends is seen as the angle goes there."""
    between = f"and it takes every value between, as it tends to {high} as α → 0° and to 0 as α →"
    printed_with(LEFT_OF_THE_ANGLE.format(share=share, more=""), [f"0 < e < {high}", between])
    text = printed_with(LEFT_OF_THE_ANGLE.format(share="2", more=", alpha < 60°"), ["⅓ < e < ½"])
    assert "every value between" not in text


def test_a_long_fraction_of_letters_has_its_decimal() -> None:
    """One of which a reader sees the size has none."""
    text = (
        "sphere A: mass 3m, velocity 2u at arcsin(3/5)\n"
        "sphere B: mass 2m, velocity u at arcsin(4/5) from -i\n"
        "A hits B: along i, e = 5/8\nfind energy(B) - energy(B, 0), {item}"
    )
    parts = ["= 81081mu²/40000 ≈ 2.03mu²", "magnitude of the impulse", "= 429mu/100"]
    assert "429mu/100 ≈" not in printed_with(text.format(item="impulse"), parts)


def test_who_came_from_a_body_at_rest_does_not_say_so_on_the_way_to_a_wall() -> None:
    to_a_wall = """
wall W: along i, through (0, -2)
sphere A: mass 1, at (-3, 0), velocity 6i
sphere B: mass 1, at (0, 0), at rest
A hits B: along 4i + 3j, e = 1/2
A hits W: e = 1/2
find time(2)
"""
    text = printed_with(to_a_wall, ["Time = distance ÷ speed parallel to the y-axis, for A:"])
    assert text.count("B is at rest") == 1
    assert "B is at rest until the first impact." in text


def test_two_equal_angles_have_one_cosine() -> None:
    statement = """
wall W: along i
wall X: along j
sphere P: velocity u at alpha to W
P hits W
P hits X
given deflection(P, 1) = deflection(P, 2)
find tan(alpha) in terms of e
"""
    text = printed_with(statement, ["δ = φ", "Since cos δ = cos φ:", "tan α = 1/√e"])
    assert "for cos φ and δ" not in text
