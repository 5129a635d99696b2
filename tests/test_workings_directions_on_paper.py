"""A direction that stands on paper is used: velocities resolved by angles in degrees."""

from __future__ import annotations

import pytest
from test_planning_closing import planned

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of


def working(text: str) -> str:
    """The working of a statement in one line, with single spaces."""
    solution, derivation = planned(text)
    return " ".join(to_text(explanation_of(derivation, solution.problem)).split())


CHAIN = """
sphere A, B, C: mass m
sphere A: velocity {u}
sphere B, C: at rest
A hits B: along {first}, e = 1/2
B hits C: along {second}, e = 1/2
find {asked}speed(C)
"""


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (
            {"u": "u i", "first": "60°", "second": "30°", "asked": ""},
            [
                "of centres of that impact, at 60° − 30° = 30° to this one.",
                "𝐯_B · 𝐧₂ = (3u/8) cos 30° = 3√3 u/16",
            ],
        ),
        (
            {
                "u": "u i",
                "first": "60°",
                "second": "30°",
                "asked": "speed(B, 1), direction(B, 1), ",
            },
            [
                "B was at rest, so it moves along the line of centres: (i) speed of B = ",
                "angle from 𝐢 to 𝐯_B = 60° Second impact",
                "B moves at 60° − 30° = 30° to the line of centres.",
            ],
        ),
        (
            {"u": "8u i", "first": "i", "second": "45°", "asked": ""},
            ["at 45° to this one.", "𝐯_B · 𝐧 = 6u cos 45° = 3√2 u"],
        ),
    ],
)
def test_who_moves_along_one_line_is_resolved_along_the_next_by_the_angle_between(
    data: dict[str, str], says: list[str]
) -> None:
    words = working(CHAIN.format(**data))
    for each in says:
        assert each in words
    # Why it moves along the line is said once.
    assert words.count("B was at rest") == 1


def test_who_is_left_at_right_angles_is_resolved_by_its_own_angle() -> None:
    words = working(
        "sphere A, B, C: mass m\nsphere A: velocity u i\nsphere B, C: at rest\n"
        "A hits B: along 60°, e = 1\nA hits C: along -45°, e = 1\nfind speed(C)"
    )
    assert "A moves perpendicular to the line of centres of its last impact, at 15° to" in words
    assert "𝐯_A · 𝐧₂ = (√3 u/2) cos 15° ≈ 0.8365u" in words


def test_to_a_wall_a_body_comes_at_the_angle_with_the_wall() -> None:
    words = working(
        "wall W: along i\nsphere A, B: mass m\nsphere A: velocity 2u at 60° to W\n"
        "sphere B: at rest\nA hits B: along -60°, e = 1/2\nB hits W: e = 2/3\nfind velocity(B)"
    )
    along = "A moves towards W at 60° to it, that is at −60° to 𝐢: along the line of centres."
    assert words.index(along) < words.index("Conservation of momentum")
    assert "along the line of centres, at 60° to W." in words
    assert "(3u/2) sin 60° = −3√3 u/4" in words
    assert "(3u/2) cos 60° = 3u/4" in words


@pytest.mark.parametrize(
    ("statement", "line"),
    [
        (
            """
sphere P: mass 2m, velocity 3u at theta
sphere Q: mass m, velocity -2u j
given tan(theta) = 5/12
P hits Q: along i, e = 2/5
find deflection(P)
""",
            "δ = β − θ = arctan(25/32) − arctan(5/12)",
        ),
        (
            """
wall W: along i
wall X: along j
sphere P: velocity u at 30° to W
P hits W: e = 1/2
P hits X: e = 1/3
find deflection(P, 1) + deflection(P, 2)
""",
            "δ₂ = 90° − arctan(√3/6) + arctan(2√3/3)",
        ),
    ],
)
def test_a_sum_of_angles_is_made_of_their_letters_first(statement: str, line: str) -> None:
    assert line in " ".join(to_text(explain(solve(parse(statement)))).split())


CORNER = """
wall AB: along i
wall BC: along theta
sphere P: velocity u at {angle} to AB
P hits AB: e = {first}
P hits BC: e = {second}
given velocity(P) perpendicular to i
find tan(theta)
"""


@pytest.mark.parametrize(
    "data",
    [
        {"angle": "45°", "first": "1/2", "second": "1/2"},
        {"angle": "45°", "first": "1", "second": "1/3"},
    ],
)
def test_who_divides_by_a_cosine_says_so_where_sine_and_cosine_are_multiplied(
    data: dict[str, str],
) -> None:
    words = working(CORNER.format(**data))
    assert "Dividing by cos²θ, which is not zero as θ is acute: " in words


def test_of_squares_alone_the_tangent_is_seen() -> None:
    words = working(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, velocity u at 180° - alpha\n"
        "A hits B: along i, e = 1/4\ngiven velocity(A) perpendicular to velocity(B)\nfind alpha"
    )
    assert "tan²α = 1/16" in words
    assert "Dividing by" not in words


OFF_A_LINE = """
sphere A: mass m, velocity u i
sphere B, C: mass 2m, at rest
A hits B: along 30°, e = 1/2
A hits C: along -50°, e = 1/2
find {asked}
"""


@pytest.mark.parametrize(
    ("asked", "wanted"),
    [
        ("angle(velocity(B), i)", "angle between 𝐯_B and 𝐢 = 30°"),
        ("angle(velocity(B), j)", "angle between 𝐯_B and 𝐣 = 90° − 30° = 60°"),
        ("angle(velocity(B), velocity(A, 0))", "angle between 𝐯_B and 𝐮_A = 30°"),
        ("angle(velocity(B), velocity(C))", "angle between 𝐯_B and 𝐯_C = 30° + 50° = 80°"),
    ],
)
def test_what_was_at_rest_moves_at_the_angle_of_its_line_of_centres(
    asked: str, wanted: str
) -> None:
    said = working(OFF_A_LINE.format(asked=asked))
    assert "at rest, so" in said and wanted in said
    assert "tan" not in said and "cos" not in said


def test_an_angle_to_a_wall_is_read_off_the_line_of_centres() -> None:
    said = working("wall W: along 110°" + OFF_A_LINE.format(asked="angle(velocity(B), W)"))
    assert "angle between 𝐯_B and W = 110° − 30° = 80°" in said


@pytest.mark.parametrize(
    ("velocity", "says"),
    [
        ("8i - 6j", "θ = 180° − arctan(3/4) ≈ 143°, as 𝐯_P is in the direction of −𝐧"),
        ("-8i + 6j", "θ = −arctan(3/4) ≈ −36.9°, as 𝐯_P is in the direction of −𝐧"),
    ],
)
def test_of_two_directions_of_a_normal_it_is_the_one_against_the_unit_vector(
    velocity: str, says: str
) -> None:
    statement = f"""
        wall W: along 3i + 4j
        sphere P: velocity {velocity}
        P hits W: e = 1/2
        find direction(P)
        """
    text = to_text(explain(solve(parse(statement)), check=True))
    assert says in " ".join(text.split())


@pytest.mark.parametrize(
    ("statement", "senses"),
    [
        (
            "wall W: along i\nwall X: along j\nsphere P: velocity u at alpha to W\n",
            "Take 𝐢 parallel to W, in the direction in which P first moves, and 𝐣 away from W.",
        ),
        (
            "wall W: along j\nwall X: along i\nsphere P: velocity u at alpha to W\n",
            "Take 𝐣 parallel to W, in the direction in which P first moves, and 𝐢 towards W.",
        ),
        (
            "wall W: along i\nwall X: along j\nsphere P: velocity u at alpha from -i\n",
            (
                "Take 𝐢 parallel to W, opposite to the direction in which P first moves, and 𝐣 "
                "away from W."
            ),
        ),
    ],
)
def test_senses_that_the_question_leaves_open_are_taken(statement: str, senses: str) -> None:
    """The question says only that P comes to W at an acute angle."""
    shown = working(f"{statement}P hits W\nP hits X\nfind speed(P)")
    assert shown.count("Take ") == 1
    assert senses in shown
    assert shown.index(senses) < shown.index("in the direction of")
    # Where a vector is asked for, the question says how P comes, and nothing is taken.
    assert "Take " not in working(f"{statement}P hits W\nP hits X\nfind velocity(P)")


@pytest.mark.parametrize(
    ("wall", "velocity", "senses"),
    [
        (
            "i",
            "u at 20° to W",
            "Parallel to W, A first moves in the direction of 𝐢, and 𝐣 is away from W",
        ),
        (
            "j",
            "3 at 70° to W",
            "Parallel to W, A first moves in the direction of 𝐣, and 𝐢 is towards W",
        ),
        (
            "i",
            "u at 110° to W",
            "Parallel to W, A first moves in the direction opposite to 𝐢, and 𝐣 is away from W",
        ),
        (
            "j",
            "u at 180° - theta to W",
            "Parallel to W, A first moves in the direction opposite to 𝐣, and 𝐢 is towards W",
        ),
        ("i", "u at 90° to W", None),
        ("i", "u at -20°", None),
        ("i", "2i - 3j", None),
    ],
)
def test_the_sense_along_a_wall_is_said_beside_another_sphere(
    wall: str, velocity: str, senses: str | None
) -> None:
    """An angle to a wall does not say which way along it A moves."""
    shown = working(f"""
        wall W: along {wall}
        sphere A: mass 2, velocity {velocity}
        sphere B: mass 1, at rest
        A hits W: e = 1/2
        A hits B: along j, e = 1/2
        find velocity(A)
        """)
    assert (" first moves in the direction" in shown) == (senses is not None)
    if senses is not None:
        assert shown.count(senses) == 1
        assert shown.index(senses) < shown.index("in the direction of", shown.index(senses) + 60)


def test_on_which_side_of_a_wall_an_axis_is_by_the_sense_of_the_angle() -> None:
    text = "wall W: along i\nsphere P: velocity u at {}alpha to W\nP hits W\nfind velocity(P)"
    assert "and 𝐣 is away from W." in working(text.format(""))
    assert "the direction opposite to 𝐢, and 𝐣 is towards W." in working(text.format("180° + "))
