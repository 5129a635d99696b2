"""The line that decides stands before what is to be shown, and before the answer of an inequality.

The questions are chosen so that the step from the equation with values put in to the printed
result would be too long for a reader.
"""

from __future__ import annotations

import re

import pytest
from laws_of_steps import STEPS

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.printed_terms import in_printed_terms
from restitution.solving.story.letters import roles
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

WALL = "wall W: along i\nsphere P: velocity 2u at theta to W\nP hits W\n"
TWO = "sphere A: mass {a}, velocity {u}\nsphere B: mass {b}, {v}\nA hits B: along i{e}\n"


def rows(text: str) -> list[str]:
    """The rows of a working that is right, and planned to its end; without marks and numbers."""
    solution = solve(parse(text))
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(solution.problem))) == ()
    assert [each for law in STEPS.values() for each in law(solution, derivation)] == []
    printed = to_text(explanation_of(derivation, solution.problem))
    return [_AROUND.sub("", " ".join(row.split())) for row in printed.splitlines()]


_AROUND = re.compile(r"^(\([ivx]+\) )+|( \(\d+\))?( D?[MAB]\d(ft|\*)?)*$")


def before(text: str, row: str) -> str:
    """The row before the first one that begins so."""
    own = rows(text)
    (number, *_) = [n for n, each in enumerate(own) if each.startswith(row)]
    return own[number - 1]


# --- squares of a sine and a cosine -----------------------------------------------------------


def test_like_squares_stand_together_before_the_square_of_the_tangent() -> None:
    text = WALL + "given velocity(P) perpendicular to velocity(P, 0)\nshow tan(theta)^2 = 1/e"
    assert before(text, "tan²θ = 1/e") == "e sin²θ = cos²θ"


def test_coefficients_that_are_sums_of_squares_are_put_together_in_a_line_of_their_own() -> None:
    text = (
        TWO.format(a="m", u="3u at theta", b="m", v="velocity u at theta from -i", e="")
        + "given speed(A) = speed(B)\nshow tan(theta)^2 = e"
    )
    own = rows(text)
    last = next(n for n, each in enumerate(own) if each.startswith("tan²θ = e"))
    assert own[last - 1].startswith("8 sin²θ = ((1 + 2e)² − (1 − 2e)²) cos²θ")


def test_one_term_of_each_square_is_not_written_twice() -> None:
    text = (
        TWO.format(a="m", u="u at theta", b="k m", v="at rest", e=", e = 1")
        + "given velocity(A) perpendicular to velocity(A, 0)\n"
        + "show tan(theta)^2 = (k - 1)/(k + 1)"
    )
    own = rows(text)
    assert sum("sin²θ =" in each for each in own) == 1
    assert before(text, "tan²θ = ") == "(k + 1) sin²θ = (k − 1) cos²θ"


def test_a_right_angle_that_is_shown_has_its_scalar_product() -> None:
    text = (
        "sphere A, B: mass 2m\n"
        "sphere A: velocity 4u at 30°\n"
        "sphere B: velocity 4u at 150°\n"
        "A hits B: along i\n"
        "given energy_lost = 16 m u^2\n"
        "find e\n"
        "show velocity(A) perpendicular to velocity(B)"
    )
    own = rows(text)
    assert any(each.startswith("𝐯_A · 𝐯_B = −") and each.endswith("= 0") for each in own)


# --- inequalities -------------------------------------------------------------------------------


def test_an_inequality_is_a_product_before_it_is_solved() -> None:
    text = (
        "sphere A: mass m, velocity 2u i\n"
        "sphere B: mass 2m, at rest\n"
        "sphere C: mass 4m, at rest\n"
        "A hits B: along i\n"
        "B hits C: along i\n"
        "given A and B do not collide again\n"
        "find range of e"
    )
    assert before(text, "1 − 2e ≤ 0") == "Dividing by 2 − e, which is positive as e ≤ 1:"
    assert before(text, "e ≥ ½") == "1 − 2e ≤ 0"


def test_a_tangent_between_bounds_comes_of_a_quadratic_in_it() -> None:
    text = (
        TWO.format(a="m", u="u at theta", b="m", v="at rest", e=", e = 1/2")
        + "given deflection(A) >= 30°\nfind range of tan(theta)"
    )
    assert before(text, "(3√3 − √11)/8 ≤ tan θ") == "4 tan²θ − 3√3 tan θ + 1 ≤ 0"


def test_a_quadratic_in_letters_is_a_square_before_its_root_is_taken() -> None:
    text = (
        "sphere A: mass 2m, velocity u i\n"
        "sphere B: mass 2k m, at rest\n"
        "sphere C: mass 2m, at rest\n"
        "A hits B: along i\n"
        "B hits C: along i\n"
        "given A and B collide again\n"
        "find range of k in terms of e"
    )
    assert before(text, "0 < k < ") == "e(1 + k)² < (1 + e)²"


def test_a_quadratic_that_is_solved_is_not_written_below_its_roots() -> None:
    own = rows(
        "sphere A: mass 2m, velocity 2u at 45°\n"
        "sphere B: mass m, at rest\n"
        "A hits B: along i\n"
        "given speed(B) >= speed(A)\n"
        "find range of e"
    )
    assert own[-4:-1] == [
        "(e + 2)² ≥ 7",
        "e ≥ √7 − 2, as e ≥ 0",
        "√7 − 2 ≤ e ≤ 1, as e cannot exceed 1",
    ]


def test_a_difference_of_two_squares_needs_no_product() -> None:
    text = (
        TWO.format(a="2m", u="u at theta", b="3m", v="at rest", e=", e = 0")
        + "given energy_lost/energy(A, 0) >= 1/5\nfind range of cos(theta)"
    )
    assert not any("≤ 0" in each or "≥ 0" in each for each in rows(text))


# --- speeds, angles and directions ----------------------------------------------------------------


@pytest.mark.parametrize(
    ("given", "claim", "last"),
    [
        ("given deflection(P) = 90°", "2u cot(theta)", "speed of P = 2u cot θ"),
        ("given deflection(P) = 90°", "2u tan(90° - theta)", "speed of P = 2u tan(90° − θ)"),
        (
            "let beta = angle(velocity(P), W)\ngiven beta = 90° - theta",
            "2u cot(theta)",
            "speed of P = 2u cot θ",
        ),
    ],
)
def test_a_speed_is_shown_without_a_coefficient_that_the_data_give(
    given: str, claim: str, last: str
) -> None:
    own = rows(WALL + f"{given}\nshow speed(P) = {claim}")
    assert "= 4u² cot²θ, as sin²θ + cos²θ = 1" in own
    assert any(each.startswith(last) and "as required" in each for each in own)
    assert not any("not written out" in each for each in own)


def test_a_velocity_at_whole_degrees_is_turned_onto_the_line_across() -> None:
    own = rows(
        "sphere A: mass 3, velocity 2i + 2j\n"
        "sphere B: mass M, at rest\n"
        "A hits B: along i, e = 1/3\n"
        "given deflection(A) = 45°\n"
        "find M"
    )
    assert any(each.startswith("θ = 45° + 45° = 90°") for each in own)
    assert any(each.startswith("M = 9") for each in own)


def test_who_was_at_rest_goes_along_a_line_of_centres_that_is_worked_out() -> None:
    own = rows(
        "sphere A: mass 1, velocity 4i\n"
        "sphere B: mass 3, at rest\n"
        "A hits B\n"
        "given velocity(A) = 3i - j\n"
        "find velocity(B), line_of_centres\n"
        "show velocity(B) parallel to line_of_centres"
    )
    assert "𝐯_B = ⅓(𝐢 + 𝐣)" in own
    assert any(each.startswith("𝐯_B is parallel to the line of centres") for each in own)


# --- a coefficient at its end -------------------------------------------------------------------


def test_an_angle_is_bounded_at_the_greatest_coefficient_and_then_over_the_other_angle() -> None:
    own = rows(
        TWO.format(a="2m", u="u at theta", b="m", v="at rest", e="") + "show deflection(A) <= 30°"
    )
    (most,) = (n for n, each in enumerate(own) if each.startswith("tan δ ≤ 2 tan θ/(1 + 3 tan²θ)"))
    acute = own.index("tan δ > 0, as θ is acute and 0 ≤ e ≤ 1, so δ is acute")
    assert most < own.index("tan δ ≤ √3/3") < acute
    assert own[-1] == "δ ≤ 30° (as required)"


# --- what is sought of a claim --------------------------------------------------------------------


def test_a_claim_is_decided_by_the_letter_that_it_prints_by_others() -> None:
    own = rows(
        "wall C: circle centre (0, 0) radius r\n"
        "sphere P: at (r, 0), velocity w at theta from -i\n"
        "P hits C\n"
        "P hits C\n"
        "P reaches (r, 0)\n"
        "show tan^2(theta) = e^3/(1 + e + e^2)"
    )
    assert own[-1] == "tan²θ = e³/(1 + e + e²) (as required)"
    assert own[-2] == "(1 + e) tan²θ = e³ − e² tan²θ"


def test_a_claim_beside_a_time_that_is_sought_too_is_not_tried_again() -> None:
    solution = solve(
        parse(
            "wall C: circle centre (0, 0) radius r\n"
            "sphere P: at (r, 0), velocity w at theta from -i\n"
            "P hits C\n"
            "P hits C\n"
            "given position(P, at t) = (r, 0)\n"
            "show tan^2(theta) = e^3/(1 + e + e^2)"
        )
    )
    assert in_printed_terms(solution) is None


# --- tangents of double angles, and what is at most a number --------------------------------------


def test_the_tangent_of_a_double_angle_is_opened_before_what_is_shown() -> None:
    text = TWO.format(a="m", u="u at theta", b="m", v="at rest", e="")
    text += "given angle(velocity(A), line_of_centres) = 2*theta\nshow tan^2(theta) = e"
    assert before(text, "tan²θ = e") == "2 tan θ/(1 − tan²θ) = 2 tan θ/(1 − e)"


def test_the_greatest_value_stands_before_a_bound_beyond_it() -> None:
    text = TWO.format(a="m", u="u at alpha", b="m", v="at rest", e=", e = 1/2")
    assert before(text + "show deflection(A) < 40°", "tan δ < tan 40°") == "tan δ ≤ ¾"


def test_of_two_equations_in_squares_none_of_the_fourth_degree_comes() -> None:
    # sin²α = e cos²α and (1 − e²) cos²α = 1/4, so 1 − e = 1/4.
    text = TWO.format(a="m", u="u at alpha", b="m", v="velocity u at 180° - alpha", e="")
    text += "given deflection(A) = 90°, energy_lost = 1/4 energy(0)\nfind tan(alpha), e"
    own = rows(text)
    assert own.index("cos²α = 1/(1 + e)") < own.index("(1 − e²)/(1 + e) = ¼")
    assert own[own.index("tan²α = ¾") + 1] == "tan α = √3/2 ≈ 0.866, as α is acute"
    assert not any("⁴" in each for each in own)


# --- deflections at a wall, by the angle after ----------------------------------------------------


@pytest.mark.parametrize(
    ("deflection", "angle"),
    [
        ("2*angle(velocity(P), W) + 30°", "β = α − 30°"),
        ("2*alpha - 30°", "β = 2α − 30° − α = α − 30°"),
        ("30° + 2*angle(velocity(P), W)", "β = α − 30°"),
        ("2*angle(velocity(P), W)", "β = α"),
    ],
)
def test_a_deflection_that_is_given_by_one_of_the_angles_of_its_sum(
    deflection: str, angle: str
) -> None:
    e = ": e = 1/3" if "30" in deflection else ""
    text = f"wall W: along i\nsphere P: velocity u at alpha to W\nP hits W{e}\n"
    text += f"given deflection(P) = {deflection}\nfind {'alpha' if e else 'e'}"
    assert angle in rows(text)


def test_a_deflection_lies_between_its_values_at_the_ends_of_the_angle_before() -> None:
    text = "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/2\n"
    own = rows(text + "find range of deflection(P)")
    assert "0° < δ < 180°, as α + arctan(½ tan α) increases with α and α is acute" in own


# --- two spheres --------------------------------------------------------------------------------

DIFFERENCE = "let phi = angle(velocity(A), i)\nlet delta = phi - theta\n"


def test_a_component_that_a_fact_gives_comes_before_the_laws_in_what_is_shown() -> None:
    text = (
        TWO.format(a="m", u="u at theta", b="k m", v="at rest", e="")
        + "given velocity(A) perpendicular to line_of_centres\nshow e = 1/k"
    )
    own = rows(text)
    assert "v = 0" in own
    assert before(text, "e = 1/k") == "(u cos θ)/k = eu cos θ"


def test_vectors_that_stand_have_their_scalar_product_beside_a_slanting_line() -> None:
    own = rows(
        "sphere A: mass 4, velocity 5i\nsphere B: mass 2, at rest\nA hits B\n"
        "given velocity(B) = 4i + 2j\nfind velocity(A)\nfind e\n"
        "find angle(velocity(A), velocity(B))"
    )
    assert "cos β = (3 × 4 − 2)/(√(3² + 1²)√(4² + 2²)) = √2/2" in own


def test_bounds_of_a_square_that_is_shown_come_of_the_square_in_it() -> None:
    text = (
        TWO.format(a="m", u="u at alpha", b="2m", v="at rest", e="")
        + "given cos(alpha) = 4/5\npart a\nshow speed(A)^2 = u^2 (81 + 16(1 - 2e)^2)/225\n"
        "part b\nfind range of speed(A)"
    )
    own = rows(text)
    assert "0 ≤ (1 − 2e)² ≤ 1, as 0 ≤ e ≤ 1" in own
    assert not [row for row in own if "64e²" in row]


@pytest.mark.parametrize(
    ("asked", "row"),
    [
        ("energy(A)", "= (mu²/18)(1 − 8e)² + ½mu²"),
        ("energy(A)/energy(A, 0)", "= (1/90)(1 − 8e)² + 1/10"),
    ],
)
def test_bounds_of_an_energy_come_of_a_square_that_is_completed(asked: str, row: str) -> None:
    own = rows(
        TWO.format(a="m", u="3u i + u j", b="2m", v="velocity -u i", e="")
        + f"find range of {asked}"
    )
    assert row in own
    assert "0 ≤ (1 − 8e)² ≤ 49, as 0 ≤ e ≤ 1" in own


def test_a_bound_of_a_tangent_is_a_product_of_tangents_before_it_is_solved() -> None:
    text = (
        TWO.format(a="m", u="u at theta", b="m", v="at rest", e=", e = 1/2")
        + "given tan(deflection(A)) >= 3/5\nfind range of tan(theta)"
    )
    own = rows(text)
    assert own[own.index("(4 tan θ − 1)(tan θ − 1) ≤ 0") - 1] == "4 tan²θ − 5 tan θ + 1 ≤ 0"


def test_the_tangent_of_a_difference_is_shown_by_both_tangents() -> None:
    spheres = TWO.format(a="4m", u="u at theta", b="m", v="at rest", e=", e = 2/3")
    for asked, lets in (("delta", DIFFERENCE), ("phi - theta", DIFFERENCE.split("let delta")[0])):
        text = f"{spheres}{lets}show tan({asked}) = tan(theta)/(2 + 3 tan^2(theta))"
        assert before(text, "= tan θ/(2 + 3 tan²θ)").endswith(
            "= ((3/2) tan θ − tan θ)/(1 + (3/2) tan²θ)"
        )


def test_a_difference_from_an_angle_to_an_axis_is_acute_by_its_tangent() -> None:
    own = rows(
        TWO.format(a="4m", u="u at theta", b="m", v="at rest", e=", e = 2/3")
        + f"{DIFFERENCE}find maximum of delta over theta"
    )
    assert "tan δ > 0, as θ is acute" in own
    assert "δ ≤ arctan(√6/12), as −90° < δ < 180°" in own


@pytest.mark.parametrize(
    ("given", "asked", "row"),
    [
        ("tan(theta) = 1/2", "delta", "δ = arctan 3 − arctan(1/2) ≈ 45.0°"),
        ("theta = 45°", "phi - theta", "φ − θ = arctan 7 − 45° ≈ 36.9°"),
    ],
)
def test_a_difference_of_angles_of_numbers_is_worked_out(given: str, asked: str, row: str) -> None:
    mass = "2m" if "tan" in given else "4/3 m"
    own = rows(
        TWO.format(
            a="m",
            u="u at theta",
            b=mass,
            v="at rest",
            e=", e = 1/4" if "tan" in given else ", e = 1/2",
        )
        + f"{DIFFERENCE}given {given}\nfind {asked}"
    )
    assert row in own


def test_an_impulse_leaves_no_velocities_behind_that_it_does_not_need() -> None:
    own = rows(
        "sphere A: mass m, velocity u i, radius a\nsphere B: mass m, at rest, radius a\n"
        "A hits B: offset d, e = 1/2\npart a\nfind speed(A)\npart b\nfind impulse\n"
        "part c\ngiven d = 6a/5\nfind deflection(A)"
    )
    # sin φ = 3/5 gives tan φ = 3/4: the components of A are not worked out for a ratio of them.
    assert "tan β = u sin φ/(¼u cos φ) = 4 tan φ" in own
    assert "tan β = 3" in own


def test_the_line_of_an_impulse_stands_where_it_is_needed() -> None:
    own = rows(
        "sphere A: mass 2, velocity 3i + j\nsphere B: mass 4, velocity -i - j\nA hits B\n"
        "given impulse(A) = -8i - 4j\nfind velocity(A), velocity(B)\nfind e"
    )
    (axis,) = [n for n, row in enumerate(own) if row.endswith("parallel to −8𝐢 − 4𝐣")]
    assert own.index("𝐯_B = 𝐢 m s⁻¹") < axis


@pytest.mark.parametrize(
    ("speed", "asked", "row"),
    [
        ("at rest", "deflection(A)", "δ = 90° − 45° = 45°"),
        ("velocity u at 90°", "velocity(B)", "𝐯_B = (√2 u/4)𝐢 + u𝐣 ≈ 0.354u𝐢 + u𝐣"),
        ("velocity u at 90°", "angle(velocity(A), velocity(B))", "≈ 19.5°"),
    ],
)
def test_a_component_that_comes_to_nothing_has_its_line(speed: str, asked: str, row: str) -> None:
    own = rows(
        TWO.format(a="m", u="u at alpha", b="k m", v=speed, e="")
        + "part a\nfind along(velocity(A), i)\npart b\n"
        f"given k = 2, e = 1/2, tan(alpha) = 1\nfind {asked}"
    )
    (number,) = [n for n, each in enumerate(own) if each.endswith(row)]
    assert own.index("v = 0") < number
    assert not [each for each in own if each.startswith("A comes at right angles")]


def test_vectors_in_the_directions_of_velocities_are_named_with_values_put_in() -> None:
    own = rows(
        TWO.format(a="m", u="3u i + 2u j", b="2m", v="velocity -2u i + u j", e="")
        + "part a\nfind velocity(A), velocity(B)\npart b\ngiven e = 1/2\n"
        "find energy_lost\nfind angle(velocity(A), velocity(B))"
    )
    assert "by the scalar product of −𝐢 + 𝐣 and 𝐢 + 2𝐣, which are" in " ".join(own)


def test_a_line_of_centres_at_an_inverse_tangent_has_a_direction_from_i() -> None:
    own = rows(
        "sphere A: mass 2m, velocity 5u i\nsphere B: mass m, at rest\n"
        "A hits B: along arctan(4/3), e = 1/2\nfind speed(B)"
    )
    assert "in the direction at arctan(4/3) anticlockwise from 𝐢" in " ".join(own)


def test_a_difference_of_a_letter_for_an_angle_is_made_greatest_in_a_later_part() -> None:
    own = rows(
        TWO.format(a="4m", u="u at theta", b="m", v="at rest", e="")
        + f"{DIFFERENCE}part a\ngiven e = 2/3\n"
        "show tan(delta) = tan(theta)/(2 + 3 tan^2(theta))\n"
        "part b\nfind maximum of delta over theta"
    )
    assert "δ ≤ arctan(√5(1 + e)/(10√(4 − e))), as −90° < δ < 180°" in own


# --- powers -----------------------------------------------------------------------------------

CHANNEL = "wall V, W: along j\nsphere P: velocity 3u i\n" + "P hits V: e = e\nP hits W: e = e\n" * 2


@pytest.mark.parametrize(
    ("given", "lines"),
    [
        ("speed(P) = 16/81 * 3u", ["e⁴ = 16/81", "e² = 4/9", "e = ⅔, as e ≥ 0"]),
        ("energy = 3/5 energy(0)", ["e⁸ = ⅗", "e = (⅗)^(1/8) ≈ 0.938, as e ≥ 0"]),
        ("e^3 = 1/20", ["e³ = 1/20", "e = ∛(1/20) ≈ 0.368"]),
    ],
)
def test_what_a_power_of_the_unknown_is_stands_before_its_root(
    given: str, lines: list[str]
) -> None:
    own = rows(f"{CHANNEL}given {given}\nfind e")
    assert own[-len(lines) :] == lines


def test_a_factor_that_every_term_has_goes_first() -> None:
    own = rows(
        "sphere A, B: mass 2m, radius a\nsphere A: velocity u i\nsphere B: at rest\n"
        "wall W: along j\nA hits B: offset a, e = e\nB hits W: e = e\n"
        "given velocity(A) perpendicular to velocity(B)\nfind e"
    )
    last = own.index("Dividing by 1 + e, which is not zero as e ≥ 0:")
    assert own[last + 1 : last + 3] == ["(5 − 3e)e + 1 + e = 0", "3e² − 6e − 1 = 0"]


# --- a speed beside the angle of its velocity to a wall ----------------------------------------


@pytest.mark.parametrize(
    ("angle", "line", "answer"),
    [
        ("90° - 58°", "2u cos 40° = 5.4 cos 32°", "u = (27 cos 32°)/(10 cos 40°) ≈ 2.989 ≈ 2.99"),
        ("35°", "2u cos 40° = 5.4 cos 35°", "u = (27 cos 35°)/(10 cos 40°) ≈ 2.887 ≈ 2.89"),
    ],
)
def test_a_given_speed_at_a_given_angle_to_a_wall_is_resolved(
    angle: str, line: str, answer: str
) -> None:
    own = rows(
        WALL.replace("theta", "40°")
        + f"given angle(velocity(P), W) = {angle}, speed(P) = 5.4\nfind e, u"
    )
    assert line in own
    assert answer in own
    assert not [row for row in own if "90°" in row or "²" in row]


def test_an_impulse_that_is_typed_by_its_size_and_angle_stands_by_components() -> None:
    own = rows(
        "wall W\nsphere P: mass 1/2, velocity 6i\nP hits W\n"
        "given impulse(P) = 2 at 120°\nfind speed(P), e"
    )
    assert "−𝐢 + √3 𝐣 = ½(𝐯_P − 6𝐢)" in own
    assert "the normal to W is parallel to −𝐢 + √3 𝐣" in own


def test_a_tangent_in_figures_keeps_the_decimal_of_the_data() -> None:
    own = rows(
        TWO.format(a="2", u="2.5 at 37°", b="3", v="velocity 1.7 at 20°", e=", e = 1/3")
        + "find deflection(B)"
    )
    assert "tan β ≈ (1.7 sin 20°)/1.810 ≈ 0.3212" in own
    assert "δ = 20° − β ≈ 20° − 17.81°" in own


def test_sine_and_cosine_by_a_tangent_in_letters_stand_over_one_root() -> None:
    own = rows(
        "wall AB: along i\nwall BC: along 120°\nsphere P: velocity 2u at theta to AB\n"
        "P hits AB: e = e\nP hits BC: e = e\ngiven velocity(P) parallel to AB\n"
        "find tan(theta)\nfind speed(P)"
    )
    sine = own.index("sin θ = √3(1 + e)/√(3 + 6e + 12e² − 6e³ + e⁴)")
    assert own[sine + 1] == "cos θ = (3 − e)e/√(3 + 6e + 12e² − 6e³ + e⁴)"


def test_a_tangent_with_roots_beside_a_sine_without_an_exact_value_goes_by_figures() -> None:
    own = rows(
        TWO.format(a="m", u="u at 50°", b="m", v="at rest", e="")
        + "given deflection(A) = 25°\nfind e"
    )
    assert "v = (u sin 50°)/tan 75° ≈ 0.2053u" in own
    assert "mu cos 50° ≈ m × 0.2053u + mw" in own
    assert "w ≈ 0.4375u" in own


# --- values put in, numbers compared, and angles ------------------------------------------------

AWAY = """
sphere P: mass m, velocity u i
sphere Q: mass M, velocity -w i
P hits Q: along i, e = 1/2
given u > 0, w > 0
part a
find along(velocity(P), i), along(velocity(Q), i)
part b
"""


def test_a_quotient_of_letters_is_put_into_a_sum_before_that_is_worked_out() -> None:
    own = rows(AWAY + "given w = m u/M\nshow along(velocity(Q), i) = m u/(2M)")
    said = "x = (m(3u + mu/M) − 2M(mu/M))/(2(m + M)) = mu/(2M) (as required)"
    assert said in own


def test_the_tangent_of_an_angle_in_degrees_stands_before_its_value() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
let theta = angle(velocity(A), velocity(B))
part a
show tan(theta) = 2 tan(alpha)/(1 - e)
part b
given tan(alpha) = 1/2, theta = 75°
find e
"""
    own = rows(text)
    assert "tan 75° = (2 × ½)/(1 − e)" in own
    assert own[-1] == "e ≈ 0.732"


def test_a_bound_of_a_quotient_comes_of_its_own_one() -> None:
    own = rows(AWAY.replace("M", "2m") + "given velocity(Q) in the direction of -i\nshow u/w < 3/2")
    place = own.index("u/w < 3/2 (as required)")
    assert own[place - 1] == "u/w < 1"


TWO_WALLS = """
wall V: along i
wall W: along j
sphere P: mass m, velocity 4u i - 3u j
P hits V: e = 5/7
P hits W: e = 3/5
"""


@pytest.mark.parametrize(
    ("claim", "said"),
    [
        ("speed(P)^2 < 11u^2", "as 12681/1225 < 13475/1225 = 11"),
        ("speed(P) < 10/3 u", "as 3√1409/35 ≈ 3.22 < 10/3"),
        ("energy(P) < 1/2 energy(0)", "as 12681/2450 ≈ 5.18 < 25/4"),
    ],
)
def test_numbers_that_are_not_compared_at_sight_say_how_they_compare(claim: str, said: str) -> None:
    assert said in " ".join(rows(TWO_WALLS + f"show {claim}"))


def test_an_angle_that_is_summed_in_degrees_has_its_degrees_before() -> None:
    own = rows(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/3\n"
        "given energy_lost = 1/3 energy(0)\nfind deflection(P)"
    )
    place = own.index("δ ≈ 37.76° + 14.48°")
    assert "α ≈ 37.76°" in own[:place] and "β ≈ 14.48°" in own[:place]


def test_a_direction_in_exact_degrees_says_its_quadrant() -> None:
    own = rows(
        "wall W: along j\nwall V: along i\nsphere P: velocity 2 at 30°\nP hits W: e = 0.9\n"
        "P hits V: e = 0.9\nfind direction(P)"
    )
    assert own[-1] == "θ = −150°, as 𝐯₂ has a negative 𝐢-component"


@pytest.mark.parametrize(
    ("second", "start", "said"),
    [
        ("70°", "160°", "OA and OB meet at 70°. Exterior angle of the triangle that they make"),
        ("25°", "50°", "The angle between the path and OA is an exterior angle of the triangle"),
    ],
)
def test_an_angle_to_the_next_wall_is_one_of_a_triangle(second: str, start: str, said: str) -> None:
    text = (
        f"wall OA: along i\nwall OB: along {second}\nsphere P: velocity 8 at {start} to OA\n"
        "P hits OA: e = 0.8\nP hits OB: e = 0.5\nfind angle(velocity(P, 1), OB)"
    )
    assert said in " ".join(rows(text))


def test_a_given_speed_is_said_again_where_a_later_part_uses_it() -> None:
    text = TWO.format(a="m", u="3u i", b="k m", v="velocity u i", e="") + (
        "given speed(A) = 1/2 u\npart a\nfind e in terms of k\npart b\ngiven e = 1/2\nfind k"
    )
    own = rows(text)
    assert own[own.index("½u = 3u/(1 + k)") - 1] == "It is given that the speed of A is ½u:"


def test_a_completed_square_tells_a_sign_by_itself() -> None:
    own = " ".join(
        rows(
            "sphere A: mass 3m, velocity u i\nsphere B: mass m, at rest\n"
            "sphere C: mass m, at rest\nA hits B: along i\nB hits C: along i, e = e\n"
            "show A and B collide again"
        )
    )
    assert "(3(e − ⅓)² + 8/3)/8" in own and "as (e − ⅓)² ≥ 0" in own
    assert "discriminant" not in own


# --- one line instead of several ----------------------------------------------------------------


def test_a_square_with_one_side_out_of_range_is_solved_by_its_root() -> None:
    own = rows(
        TWO.format(a="m", u="u at 60°", b="m", v="at rest", e="")
        + "given speed(A) > 9/10 u\nfind range of e"
    )
    place = own.index("(e − 1)² > 24/25")
    assert own[place + 1 : place + 3] == ["1 − e > 2√6/5, as e ≤ 1", "e < (5 − 2√6)/5"]
    assert "25e² − 50e + 1 > 0" not in own


@pytest.mark.parametrize(
    ("shown", "given", "said"),
    [
        (
            "tan(angle(velocity(A), line_of_centres)) = (1 + k) tan(alpha)/(1 - k e)",
            "angle(velocity(A), line_of_centres) = 60°",
            "√3 = √3(1 + k)/(3(1 − ke))",
        ),
        (
            "speed(B) = (1 + e) u cos(alpha)/(1 + k)",
            "speed(B) = 1/4 u",
            "¼u = √3(1 + e)u/(2(1 + k))",
        ),
        (
            "energy_lost = k m (1 - e^2) u^2 cos(alpha)^2/(2(1 + k))",
            "energy_lost = 1/12 m u^2",
            "(1/12)mu² = 3kmu²(1 − e²)/(8(1 + k))",
        ),
    ],
)
def test_what_was_shown_ties_the_letters_of_a_range(shown: str, given: str, said: str) -> None:
    own = rows(
        TWO.format(a="m", u="u at alpha", b="k m", v="at rest", e="")
        + f"given k e < 1\npart a\nshow {shown}\npart b\ngiven alpha = 30°, {given}\n"
        "find range of k"
    )
    rest = own[own.index("(b)") :]
    assert said in rest
    assert not any(row.startswith(("v =", "w =")) for row in rest)


def test_a_given_direction_is_an_angle_to_a_line_of_centres_that_slants() -> None:
    own = rows(
        "sphere P: mass 2, velocity 6i\nsphere Q: mass 3, at rest\nP hits Q: along -30°\n"
        "given direction(P) = 45°\nfind e"
    )
    assert "tan 75° = 3/v" in own
    said = "It is given that the angle from 𝐢 to 𝐯_P is 45°, so 𝐯_P makes 45° + 30° = 75° with the"
    assert said in " ".join(own)
    back = rows(
        "sphere P: mass m, velocity 2u i\nsphere Q: mass 2m, at rest\nP hits Q: along 30°\n"
        "given direction(P) = -75°\nfind e"
    )
    assert "180° − (30° + 75°) = 75° with the line of centres:" in back
    assert back[back.index("tan 75° = −u/v") + 1] == "v = −u/tan 75°"


def test_a_way_is_by_the_tangent_that_is_given_of_its_angle() -> None:
    own = rows(
        "wall S: along i, through (0, 3)\nsphere P: at (0, 0), velocity u at alpha\n"
        "given tan(alpha) = 3/5\nP hits S\nfind position(P, 1)"
    )
    assert "x-coordinate of P at the impact = 3/tan α" in own
    assert not any("√34" in row for row in own)


def test_a_given_deflection_goes_into_the_sum_that_an_earlier_part_has() -> None:
    own = rows(
        "wall W: along i\nsphere P: mass m, velocity u at 35° to W\nP hits W\n"
        "part a\nfind deflection(P)\npart b\ngiven deflection(P) = 55°\nfind e"
    )
    place = own.index("35° + β = 55°")
    assert own[place + 1 :] == [
        "β = 20°",
        "Substituting in (1):",
        "tan 20° = e tan 35°",
        "e = (tan 20°)/tan 35° ≈ 0.520",
    ]


def test_ratios_that_both_sides_have_are_divided_out_before_the_square_stands_alone() -> None:
    own = rows(
        "sphere P: mass m, velocity u i\nsphere Q: mass 2m, at rest\nwall W: along j\n"
        "P hits Q: along theta\nQ hits W: e = e\n"
        "given velocity(Q) parallel to velocity(P, 1)\nshow cos(theta) = sqrt(6)/(2(1 + e))"
    )
    place = own.index("cos²θ = 3/(2(1 + e)²)")
    assert own[place - 1] == "2(1 + e)e cos²θ = 3 − 2(1 + e) cos²θ"
