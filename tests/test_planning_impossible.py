"""Workings of what cannot happen: the equations are worked out, and say why."""

from __future__ import annotations

import pytest

from restitution.errors import ContradictionError, ImpossibleError
from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

SPHERES = """
sphere A: mass m, velocity {u}
sphere B: mass {k} m, {v}
A hits B: along i{e}
"""


def working(text: str) -> str:
    """The working of a question, of which the follower accepts every line."""
    solution = solve(parse(text))
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(solution.problem))) == ()
    return " ".join(to_text(explain(solution)).split())


def test_one_value_that_a_letter_cannot_have() -> None:
    """A would be driven back faster than it came: w = −2, and 2 = −3 − 2k."""
    text = SPHERES.format(u="2i + 3j", k="k", v="at rest", e=", e = 1/2")
    text += "given velocity(A) = -3i + 3j\nfind k"
    with pytest.raises(ImpossibleError, match="k = −5/2 rejected: k must be positive"):
        _ = solve(parse(text))["k"].exact
    assert "k = −5/2 But k is positive. So what is described cannot happen. A1" in (working(text))


def test_all_roots_are_out_of_range() -> None:
    """11k² + 12k + 1 = 0."""
    text = SPHERES.format(u="u at 60°", k="k", v="velocity u/2 at -90°", e=", e = 2/3")
    text += "given speed(A) = speed(B)\nfind k, speed(A)"
    shown = working(text)
    assert "(11k + 1)(k + 1) = 0" in shown
    assert "k = −1/11 ≈ −0.0909 or k = −1" in shown
    assert shown.count("But k is positive. So what is described cannot happen.") == 1
    assert "as k is positive" not in shown


def test_no_angle_between_directions_is_more_than_two_right_angles() -> None:
    """The angle to the line of centres would be 150° + 45°."""
    text = SPHERES.format(u="u at 45°", k="3", v="at rest", e="")
    shown = working(text + "given deflection(A) = 150°\nfind e")
    assert "195°" not in shown
    assert "This cannot be, as e ≥ 0. So what is described cannot happen." in shown


@pytest.mark.parametrize(
    ("speed", "lines"),
    [
        (
            "10",
            "cos θ = 25/8 = 3.125 This cannot be, as cos θ is at most 1.",
        ),
        ("1/2", "cos θ = −33/32 ≈ −1.03 This cannot be, as cos θ is at least −1."),
    ],
)
def test_a_cosine_of_no_angle(speed: str, lines: str) -> None:
    """Squares of a sine and a cosine that are 1 together stand in the equation."""
    text = f"sphere P: mass 1, velocity 4i\nP receives 3 at theta\ngiven speed(P) = {speed}\n"
    assert lines in working(text + "find theta")


def test_a_value_in_letters() -> None:
    text = SPHERES.format(u="u at theta", k="", v="velocity c u at 90°", e=", e = 1/2")
    text += "given velocity(A) perpendicular to velocity(B)\nfind c in terms of theta"
    shown = working(text)
    assert "But c is positive and θ is acute. So what is described cannot happen." in shown


def test_several_values_of_a_coefficient() -> None:
    text = SPHERES.format(u="3u at 45°", k="", v="velocity u at 135°", e="")
    text = text.replace("mass m,", "mass 4m,", 1).replace("mass  m", "mass 3m")
    text += "given speed(A) = 5/7 speed(B)\nfind e"
    shown = working(text)
    assert "82e² − 2223e + 2791 = 0" in shown
    assert "But e ≤ 1. So what is described cannot happen." in shown


def test_an_equation_that_no_angle_satisfies() -> None:
    """For heavy A and e = ½: (½ cos α)² + sin² α + cos² α = 1 needs cos α = 0."""
    text = SPHERES.format(u="u at alpha", k="", v="at rest", e=", e = 1/2")
    text = text.replace("mass m,", "mass 2m,", 1)
    text += "given speed(A)^2 + speed(B)^2 = u^2\nfind alpha\npart b\nfind speed(A)"
    shown = working(text)
    assert "cos²α = 0 This cannot be, as α is acute. So what is described cannot happen. A1" in (
        shown
    )
    assert shown.endswith("What is described cannot happen, as shown above.")


def test_a_direction_that_cannot_be() -> None:
    text = (
        "wall OA: along i\nwall OB: along 60°\nsphere P: velocity u at theta to OA\n"
        "P hits OA: e = 1/2\nP hits OB: e = 1/2\n"
        "given velocity(P) parallel to OA\nfind tan(theta)"
    )
    with pytest.raises(ContradictionError):
        _ = solve(parse(text))["tan(theta)"].exact
    assert "This cannot be, as θ is acute." in working(text)


def test_that_nothing_moves_is_no_value_of_a_speed() -> None:
    """An equation of squares of speeds alone is satisfied by u = 0: that is not the reason."""
    text = SPHERES.format(u="u at alpha", k="", v="at rest", e=", e = 1/2")
    text += "given speed(A)^2 + speed(B)^2 = 3u^2\nfind alpha"
    with pytest.raises(ContradictionError) as caught:
        _ = solve(parse(text))["alpha"].exact
    assert "u must be positive" not in caught.value.message


def test_walls_in_an_order_that_cannot_be() -> None:
    """After a step and its wall P climbs: it does not come back to the floor."""
    text = (
        "wall F: along i, through (0, 0)\nwall W: along j, through (6, 0)\n"
        "sphere P: at (-3, 2), velocity 3i - 2j\nP hits F: e = 1/2\nP hits W: e = 1/3\n"
        "find position(P)"
    )
    shown = working(text + "\nP hits F: e = 1/2\nfind speed(P)")
    assert "𝐯₂ = (−𝐢 + 𝐣) m s⁻¹ B1ft (ii) So P moves away from F: what is described" in shown
    assert "(i) position of P at the second impact = (6, 2) m A1" in shown


def test_walls_in_an_order_that_cannot_be_without_places() -> None:
    text = (
        "wall F: along i\nwall W: along j\nsphere P: velocity u at theta from -j\n"
        "P hits F: e = f\nP hits W: e = 1/3\npart a\nfind speed(P)\npart b\nP hits F\nfind speed(P)"
    )
    shown = working(text)
    assert "So P is moving away from F, or along it: what is described cannot happen." in shown
    assert shown.index("speed of P =") < shown.index("So P")


@pytest.mark.parametrize(("second", "speed"), [("2m", "w₁ = 4u/5"), ("m", "w₁ = 6u/5")])
def test_who_does_not_catch_up(second: str, speed: str) -> None:
    text = (
        f"sphere A: mass m, velocity 2u i\nsphere B: mass {second}, at rest\n"
        "sphere C: mass m, velocity 5u/4 i\nA hits B: along i, e = 1/5\n"
        "B hits C: along i, e = 1/3\nfind speed(C)"
    )
    shown = working(text)
    assert speed in shown
    assert shown.endswith(
        "So B and C are separating along the line of centres: what is described cannot happen. B1"
    )


def test_data_that_fix_one_component_whatever_the_letter_is() -> None:
    """With masses as 1 to 1/e the first leaves with the velocity of the second before."""
    text = (
        "sphere A: mass 3, velocity p i + 2j\nsphere B: mass 9, velocity -i + q j\n"
        "A hits B: along i, e = 1/3\ngiven velocity(A) = 2i + 2j, velocity(B) = 3i - j\nfind p, q"
    )
    shown = working(text)
    assert "Eliminating p from (1) and (2): v = −1 m s⁻¹" in shown
    assert shown.endswith(
        "But it is given that the velocity of A immediately after the collision is "
        "(2𝐢 + 2𝐣) m s⁻¹. "
        "So the data contradict each other. A1"
    )


def test_a_bound_that_no_coefficient_reaches() -> None:
    """A is turned through a right angle at most where 4(3e − 1) is 9/4 or less."""
    text = (
        "sphere A: mass m, velocity 5u at beta\nsphere B: mass 3m, at rest\nA hits B: along i\n"
        "given cos(beta) = 4/5, deflection(A) > 90°\nfind range of e"
    )
    shown = working(text)
    assert "4u(1 − 3e)u + 3u × 3u < 0" in shown
    assert "e > 13/12" in shown
    assert shown.endswith("But e ≤ 1. So what is described cannot happen. A1")


def test_a_square_that_would_be_negative() -> None:
    """Across the line of centres A keeps 3u, which is more than 2u."""
    text = (
        "sphere A: mass m, velocity 4u i + 3u j\nsphere B: mass m, velocity -4u i\n"
        "A hits B: along i\ngiven speed(A) = 2u\nfind e"
    )
    shown = working(text)
    assert "(2u)² = v² + (3u)² M1 v² = −5u² This cannot be, as a square is not negative." in shown


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (
            (
                "sphere A: mass 2, velocity 2i + 3j\nsphere B: mass 1, velocity 5i - j\n"
                "A hits B: along i, e = 1/2\nfind velocity(A)"
            ),
            "𝐮_A along 𝐢 = 2 m s⁻¹ B1 component of 𝐮_B along 𝐢 = 5 m s⁻¹ B1 A moves in the",
        ),
        (
            (
                "wall W: along j, through (4, 0)\nsphere P: at (0, 1), velocity -3i + 2j\n"
                "P hits W: e = 1/2\nfind velocity(P)"
            ),
            "= −3 m s⁻¹ B1 P is on the side of W to which −𝐢 points. So P moves away from W",
        ),
    ],
)
def test_who_does_not_approach_by_the_data(text: str, said: str) -> None:
    shown = working(text)
    assert said in shown
    assert shown.endswith("what is described cannot happen. B1")


def test_an_offset_under_a_root_is_no_square_alone() -> None:
    """A is turned through arctan(3/4) at most."""
    shown = working(
        "sphere A: mass m, radius a, velocity u i\nsphere B: mass m, radius a, at rest\n"
        "A hits B: offset d, e = 1/2\ngiven deflection(A) = 60°\nfind d"
    )
    assert "3d√(4a² − d²)/(4a² + 3d²) = √3" in shown
    assert shown.endswith("So what is described cannot happen. A1")


BEYOND_ITS_END = """
wall V: along i, through (0, 0)
wall W: from (1, 3) to (4, 3)
sphere P: mass m, at (0, 4), velocity {velocity}
P hits V: e = {e}
find time(1), velocity(P)
show speed(P, 0) = 5
find range of speed(P)
P hits W: e = 1/2
find velocity(P){more}
"""


def test_what_is_asked_above_an_event_that_cannot_happen_is_answered() -> None:
    """P meets the line of W at x = 3 + 9/2."""
    text = BEYOND_ITS_END.format(velocity="3i - 4j", e="1/2", more="")
    solution = solve(parse(text))
    items = solution.parts[None].items
    assert [each.error is None for each in items] == [True, True, True, False, False]
    assert items[0].exact == 1
    assert items[1].exact == (3, 2)
    shown = working(text)
    assert "(i) t₁ = 4/4 = 1 s M1 A1" in shown
    assert "𝐯_P = (3𝐢 + 2𝐣) m s⁻¹ B1" in shown
    assert "What is described cannot happen, as P does not meet W between its ends" in shown
    assert shown.index("𝐯_P = (3𝐢 + 2𝐣)") < shown.index("What is described cannot happen")


def test_what_hangs_on_a_letter_that_is_not_found_is_not_answered() -> None:
    text = BEYOND_ITS_END.format(velocity="30i - 4j", e="e", more="\nfind e")
    items = solve(parse(text)).parts[None].items
    # the speed before it hangs on no letter, but is not 5
    assert [each.error is None for each in items] == [True, False, False, False, False, False]


def test_nothing_asked_of_an_impact_that_cannot_happen() -> None:
    """The two separate after the first impact, of which alone something is asked."""
    text = SPHERES.format(u="5i + 2j", k="k", v="at rest", e=", e = 1/2")
    text += "find velocity(B)\nA hits B: along i"
    assert "cannot happen" not in working(text)


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (
            (
                "wall OA: from (0, 0) to (2, 0)\nsphere P: at (0, 2), velocity 2i - j\n"
                "P hits OA: e = 1\nfind velocity(P), speed(P)"
            ),
            (
                "x-coordinate of P at the impact = 2 × 2 = 4 m M1",
                "So P does not meet OA between its ends: what is described cannot happen. B1",
            ),
        ),
        (
            (
                "wall OA: from (0, 0) to (a, 0)\nsphere P: at (0, a), velocity 2u i - u j\n"
                "P hits OA: e = 1\nfind velocity(P)"
            ),
            ("position of P at the impact = 2a𝐢", "So P does not meet OA between its ends: what"),
        ),
        (
            (
                "wall OA: from (0, 0) to (8, 0)\nwall OB: from (8, 0) to (8, 3)\n"
                "sphere P: at (0, 2), velocity 2i - 2j\nP hits OA: e = 1\nP hits OB: e = 1/2\n"
                "find velocity(P)"
            ),
            ("y-coordinate of P at the second impact = 8 − 2 = 6 m", "So P does not meet OB"),
        ),
    ],
)
def test_a_wall_that_is_missed(statement: str, lines: tuple[str, ...]) -> None:
    """Where the sphere comes to the line of the wall is worked out."""
    shown = working(statement)
    assert all(line in shown for line in lines), shown


def test_a_line_by_which_no_item_can_be_is_the_answer_of_none() -> None:
    text = (
        "wall W: along i, through (0, 0)\nwall V: along j, through (8, 0)\n"
        "sphere P: at (1, 2), velocity 2i - 2j\n"
        "P hits W: e = 1/2\nP hits V: e = 1/2\nP hits W: e = 1/2\n"
        "find position(P, 1), position(P, 2), position(P, 3), speed(P)\n"
    )
    shown = " ".join(to_text(explain(solve(parse(text)))).split())
    assert "The velocity, from its components: 𝐯₂ = (−𝐢 + 𝐣) m s⁻¹" in shown
    assert "(i), (ii), (iii), (iv) So P moves away from W" in shown


BOTH_ABOVE = """
sphere A: mass 3m, velocity 2u at 60°
sphere B: mass m, at rest
A hits B: along i
"""


def test_no_two_roots_are_called_possible_of_which_none_is() -> None:
    """16(49/16 − 3) = (3 − e)², so that e is 2 or 4."""
    shown = working(BOTH_ABOVE + "part a\nfind speed(A)\npart b\ngiven speed(A) = 7/4 u\nfind e")
    assert "e = 4 or e = 2 DM1 But e ≤ 1. So what is described cannot happen." in shown
    assert "possible" not in shown


def test_of_a_square_no_root_is_taken_where_what_is_known_excludes_both() -> None:
    """3 − e is neither 1 nor −1, as e ≤ 1."""
    shown = working(BOTH_ABOVE + "given speed(A) = 7/4 u\nfind e")
    assert "3 − e = −1" not in shown
    assert "(3 − e)² = 1 e = 4 or e = 2" in shown
    assert "But e ≤ 1. So what is described cannot happen." in shown


def test_every_impossible_coefficient_is_named() -> None:
    text = BOTH_ABOVE + "given speed(A) = 7/4 u\nfind speed(B), e"
    with pytest.raises(ImpossibleError, match="e = 4 or e = 2 rejected"):
        _ = solve(parse(text))["e"].exact
    assert "as the data give e = 4 or e = 2, and a coefficient of restitution" in working(text)


def test_a_quadratic_without_roots_is_stated_with_its_discriminant() -> None:
    shown = working(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nsphere C: mass m, at rest\n"
        "A hits B: along i, e = 1/2\nB hits C: along i, e = 1/2\n"
        "given speed(C) = 2/3 u\nfind k"
    )
    assert (
        "This cannot be, as the discriminant of 8k² − 11k + 8 = 0 is negative: "
        "11² − 4 × 8 × 8 = −135."
    ) in shown


@pytest.mark.parametrize(
    ("impact", "angle", "says"),
    [
        ("wall W: along 4i + 3j\nsphere P: velocity 2i + 6j\nP hits W", "j", "e > 13/12"),
        (
            "sphere P: mass 1, velocity 4i + j\nsphere Q: mass 2, at rest\nP hits Q: along i + j",
            "i",
            "7 − 5e < 0 e > 7/5",
        ),
    ],
)
def test_an_angle_to_an_axis_has_its_reason(impact: str, angle: str, says: str) -> None:
    """No value of e is possible: what it would have to be stands above that."""
    shown = working(f"{impact}\ngiven angle(velocity(P), {angle}) > 90°\nfind range of e")
    assert f"{says} But e ≤ 1. So what is described cannot happen." in shown


@pytest.mark.parametrize(
    ("velocity", "line", "given", "told"),
    [
        (
            "4i + 3j",
            "j",
            "direction(A) = 174°",
            "component of A in the direction of 𝐢 stays 4 m s⁻¹. B1 But it is given that",
        ),
        (
            "4i + 3j",
            "j",
            "angle(velocity(A), i) = 150°",
            "component of A in the direction of 𝐢 stays 4 m s⁻¹. B1 But it is given that",
        ),
        (
            "u at alpha",
            "i",
            "direction(A) = -20°",
            "stays u sin α. B1 u sin α is positive, as α is acute. But it is given",
        ),
        (
            "3i + 2j",
            "i",
            "direction(B) = 30°",
            "component of B in the direction of 𝐣 stays 0. But it is given that",
        ),
    ],
)
def test_a_direction_against_the_component_that_stays(
    velocity: str, line: str, given: str, told: str
) -> None:
    """What stays across the line of centres points away from the direction that is given."""
    text = f"""
sphere A: mass 2, velocity {velocity}
sphere B: mass 3, at rest
A hits B: along {line}, e = e
given {given}
find e
"""
    assert told in working(text)


@pytest.mark.parametrize("item", ["minimum of e over k", "range of e"])
@pytest.mark.parametrize(
    ("speed", "given", "lines"),
    [
        ("u", "speed(B) = 3u", ("3u = (1 + e)u/(1 + k)", "3(1 + k) = 1 + e")),
        ("2u", "impulse = 5 m u", ("5mu = km(2(1 + e)u/(1 + k))", "5(1 + k) = 2k + 2ke")),
        ("4u", "energy_lost = 10 m u^2", ("v² = −kw² − 4u²", "as a square is not negative")),
    ],
)
def test_an_equation_without_solutions_is_written_where_a_range_or_its_end_is_asked(
    item: str, speed: str, given: str, lines: tuple[str, ...]
) -> None:
    said = working(
        f"sphere A: mass m, velocity {speed} i\nsphere B: mass k m, at rest\n"
        f"A hits B: along i\ngiven {given}\nfind {item}"
    )
    for line in (*lines, "This cannot be, as", "So what is described cannot happen."):
        assert line in said


@pytest.mark.parametrize(
    ("masses", "speeds", "lost", "line"),
    [
        (
            ("3m", "k m"),
            ("2u", "-u"),
            20,
            "27k − 27e²k > 120 + 40k, as 3 + k > 0 −120 − k(13 + 27e²) > 0",
        ),
        (("2m", "k m"), ("u", "-3u"), 18, "8k − 8e²k > 18 + 9k, as 2 + k > 0 −18 − k − 8e²k > 0"),
    ],
)
def test_an_inequality_that_cannot_hold_is_put_in(
    masses: tuple[str, str], speeds: tuple[str, str], lost: int, line: str
) -> None:
    bodies = zip("AB", masses, speeds, strict=True)
    spheres = "".join(f"sphere {n}: mass {m}, velocity {v} i\n" for n, m, v in bodies)
    said = working(f"{spheres}A hits B: along i\ngiven energy_lost > {lost} m u^2\nfind range of e")
    assert line in said
    assert "contradict" not in said


ALONG = """
wall F: along 3i + 4j
sphere Q: velocity 6i + 8j
Q hits F: e = 1/2
find speed(Q)
find deflection(Q)
"""


def test_an_impact_that_the_data_exclude_is_refused_at_its_line_and_without_a_mark() -> None:
    errors = {str(item.error) for _, item in solve(parse(ALONG)).items()}
    assert errors == {"line 4, column 1: Q is moving away from F, or along it"}
    assert working(ALONG).endswith("Q is moving away from F, or along it.")


def test_a_sphere_at_rest_does_not_move_away_from_a_wall() -> None:
    after = "sphere A: mass 1, velocity 2i\nsphere B: mass 1, at rest\nwall V: along j\n"
    for text, name in (
        ("sphere B: at rest\nwall V: along 30°\nB hits V: e = 1/3\nfind speed(B)", "B"),
        (after + "A hits B: along i, e = 1\nA hits V: e = 1/2\nfind speed(A)", "A"),
        (after.replace("2i", "0i") + "A hits V: e = 1\nfind speed(A)", "A"),
    ):
        (error,) = (item.error for _, item in solve(parse(text)).items())
        assert error is not None and error.message == f"{name} is at rest, and does not hit V"
        assert f"{name} is at rest, and does not hit V" in working(text)


def test_one_that_a_letter_excludes_is_not_refused_in_itself() -> None:
    text = ALONG.replace("6i + 8j", "u i + 8j").replace("find speed(Q)\n", "")
    assert solve(parse(text)).parts[None].items[0].error is None


def test_a_mass_that_comes_out_negative_is_worked_out_with_what_an_earlier_part_has() -> None:
    """The equation cannot hold for a mass, and is followed all the same: values are put into it."""
    text = working(
        "sphere A: mass m, velocity 3u i + 4u j\nsphere B: mass k m, velocity -u i\n"
        "A hits B: along i, e = 1/3\npart a\nfind speed(B)\n"
        "part b\ngiven deflection(A) = 90°\nfind k"
    )
    assert "k = −25/9 ≈ −2.78 But k is positive. So what is described cannot happen." in text
