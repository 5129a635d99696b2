"""Decimals between: those that are put in lead to the figures that are printed."""

from __future__ import annotations

import math
from fractions import Fraction

import pytest
import sympy as sp

from restitution.exact.angles import tidy_angle
from restitution.explaining.following.follower import follow
from restitution.expression.tree import Apply, Binary, Negate, Number
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of
from restitution.workings.naming.figures import Figures


def as_number(tree) -> float:
    return -float(tree.operand.value) if isinstance(tree, Negate) else float(tree.value)


@pytest.mark.parametrize("above", [1, 7, 19, -8, -27])
def test_the_angle_of_a_decimal_cosine_is_that_of_the_exact_one(above: int) -> None:
    for square in range(1255, 1271):  # arccos 0.5351 = 57.65°, where arccos(19/√1261) is 57.653°
        root = Apply("sqrt", Number(Fraction(square)))
        cosine = Binary("/", Number(Fraction(abs(above))), root)
        put = as_number(Figures().cosine(Negate(cosine) if above < 0 else cosine))
        exact = math.degrees(math.acos(above / math.sqrt(square)))
        assert f"{math.degrees(math.acos(put)):.3g}" == f"{exact:.3g}", (above, square)


def printed(text: str) -> str:
    return " ".join(to_text(explain(solve(parse(text)))).split())


def test_an_answer_has_its_values_put_in_before_it() -> None:
    text = printed(
        "sphere A: mass 0.2, velocity 3 at 40°\nsphere B: mass 0.3, velocity 2 at 160°\n"
        "A hits B: along i, e = 0.7\nfind speed(A), impulse"
    )
    assert "magnitude of the impulse ≈ 0.2(3 cos 40° + 1.963) ≈ 0.852 N s" in text


def test_values_of_an_earlier_part_are_put_in_as_they_stand_there() -> None:
    text = printed(
        "sphere A: mass 0.45, velocity 6.2 at 33°\nsphere B: mass 0.3, velocity 2.6 at 180° - 58°\n"
        "A hits B: along i, e = 0.54\npart a\nfind speed(A)\npart b\nfind impulse, energy_lost"
    )
    assert "v ≈ 1.148 m s⁻¹" in text
    assert "w − 1.148 ≈ 3.552 M1 w ≈ 4.700 m s⁻¹" in text
    assert "0.45(6.2 cos 33° − 1.148)" in text
    assert "½ × 0.45((6.2 cos 33°)² − 1.148²) + ½ × 0.3((2.6 cos 58°)² − 4.700²)" in text


def test_the_half_of_an_energy_is_no_decimal() -> None:
    text = printed(
        "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, at rest\n"
        "A hits B: along i, e = 0.5\nfind energy_lost"
    )
    assert "kinetic energy lost = ½m(u cos 60°)² − ½ × 2m(u/4)²" in text


def test_a_coefficient_of_a_letter_is_a_decimal_among_decimals() -> None:
    """Also within a square; where the unit of a value is that of a letter it is a fraction."""
    text = printed(
        "wall W: along i\nsphere P: mass 0.5, velocity 3.1i - 6.2j\nP hits W\n"
        "find velocity(P)\ngiven energy_lost = 4\nfind e"
    )
    assert "component of 𝐯_P along 𝐣 = 6.2e" in text
    assert "4 = ½ × 0.5(6.2² − (6.2e)²) = 9.61(1 − e²)" in text
    assert "e² ≈ 0.5838" in text
    text = printed(
        "sphere A: mass 2.5m, velocity u i\nsphere B: mass 1.5m, at rest\n"
        "A hits B: along i\nfind speed(B)"
    )
    assert "speed of B = 5(1 + e)u/8" in text


WALL = "wall W: along i\nsphere P: mass {mass}, velocity {speed} at {angle}° to W\nP hits W\n"
CORNER = """
wall AB: along i
wall BC: along 70°
sphere P: velocity 9 at 35° to AB
P hits AB: e = 0.5
P hits BC: e = 0.4
find speed(P), angle(velocity(P), BC)
"""
SPHERES = """
sphere A: mass m, velocity u at 50°
sphere B: mass m, at rest
A hits B: along i
given angle(velocity(A), line_of_centres) = 80°
find e, energy_lost/energy(0) as a percentage
"""


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        (
            WALL.format(mass=0.5, speed=8, angle=35)
            + "given energy_lost = 3\nfind e, deflection(P)",
            [
                "e² ≈ 0.4301",
                "e ≈ 0.656, as e ≥ 0",
                "component of 𝐯_P away from W ≈ 3.009 m s⁻¹",
                "tan β ≈ 3.009/(8 cos 35°) ≈ 0.4592",
                "β ≈ 24.66°",
                "δ = 35° + β ≈ 35° + 24.66°",
            ],
        ),
        (
            WALL.format(mass=0.2, speed="u", angle=55)
            + "given angle(velocity(P), W) = 40°, energy_lost = 2\nfind e, u",
            [
                "e = (tan 40°)/tan 55° ≈ 0.588",
                "u² ≈ 45.52",
                "≈ 6.75, as u is positive",
            ],
        ),
        (
            WALL.format(mass=0.5, speed=8, angle=35) + "given energy_lost = 9\nfind e",
            [
                "e² ≈ −0.710",
                "This cannot be, as a square is not negative.",
            ],
        ),
        (
            (
                "wall W: along i\nsphere P: mass 0.25, velocity 7 at theta to W\nP hits W\n"
                "given speed(P) = 5, angle(velocity(P), W) = 25°\nfind theta, e"
            ),
            ["sin θ ≈ 0.7622", "5.335e ≈ 2.113 e ≈ 0.396"],
        ),
        (
            (
                "wall W: along i\nsphere P: velocity 7 at theta to W\nP hits W: e = 0.6\n"
                "given deflection(P) = 80°\nfind theta"
            ),
            ["tan θ ≈ 1.077 or tan θ ≈ −1.547", "θ ≈ arctan 1.077 ≈ 47.1°"],
        ),
        (
            SPHERES.replace("m, velocity u at 50°", "m, velocity u at 35°")
            .replace("B: mass m", "B: mass 2m")
            .replace("angle(velocity(A), line_of_centres) = 80°", "energy_lost = 5% energy(0)")
            .replace("energy_lost/energy(0) as a percentage", "deflection(A)"),
            [
                "v ≈ −0.2416u",
                "tan β ≈ (u sin 35°)/(0.2416u) ≈ 2.374",
                "β ≈ 67.16°",
                "δ = 180° − 35° − β ≈ 180° − 35° − 67.16°",
            ],
        ),
        (
            CORNER,
            [
                "does not change: the component stays 4.947 m s⁻¹.",
                "component of 𝐯₂ away from BC ≈ 0.4 × 6.045 ≈ 2.418 m s⁻¹",
                "speed of P ≈ √(2.418² + 4.947²) ≈ 5.51 m s⁻¹",
                "tan β ≈ 2.418/4.947 ≈ 0.4888",
            ],
        ),
        (
            CORNER.replace("velocity 9", "mass 0.5, velocity 9") + "find total_energy_lost",
            [
                "kinetic energy after the second impact ≈ ½ × 0.5(2.418² + 4.947²) ≈ 7.580",
                "total kinetic energy lost ≈ 20.25 − 7.580",
            ],
        ),
        (
            SPHERES,
            [
                "v ≈ 0.1351u",
                "w ≈ 0.5077u",
                "½m((u cos 50°)² − (0.1351u)²) − ½m(0.5077u)² ≈ 0.06858mu²",
                "≈ 0.06858mu²/(½mu²) ≈ 13.7%",
            ],
        ),
    ],
)
def test_angles_are_kept_and_long_values_have_figures(statement: str, says: list[str]) -> None:
    problem = parse(statement)
    derivation = plan(solve(problem))
    assert not follow(derivation, Oracle(roles(problem)))
    text = " ".join(to_text(explanation_of(derivation, problem)).split())
    assert [each for each in says if each not in text] == []


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        (
            (
                "sphere A: mass 0.4, velocity 5i\nsphere B: mass 0.6, velocity 3 at 100°\n"
                "A hits B: along 25°, e = 0.75\nfind velocity(A), speed(B), direction(B)"
            ),
            [
                "B moves at 100° − 25° = 75° to the line of centres",
                "0.4 × 5 cos 25° + 0.6 × 3 cos 75° = 0.4v + 0.6w",
                "v ≈ 0.5887 m s⁻¹",
                "≈ 5𝐢 − 3.943(cos 25° 𝐢 + sin 25° 𝐣) ≈ (1.43𝐢 − 1.67𝐣) m s⁻¹",
                "speed of B ≈ √(3.405² + (3 sin 75°)²) ≈ 4.47 m s⁻¹",
                "≈ 4.065/1.861 ≈ 2.184",
            ],
        ),
        (
            SPHERES.replace("angle(velocity(A), line_of_centres) = 80°", "deflection(A) = 25°"),
            ["tan 75° ≈ 0.2053u", "mu cos 50° ≈ m × 0.2053u + mw", "w ≈ 0.4375u", "e ≈ 0.361"],
        ),
    ],
)
def test_with_a_calculator_roots_have_figures_too(statement: str, says: list[str]) -> None:
    text = " ".join(printed(statement).split())
    assert [value for value in says if value not in text] == []


def test_a_ratio_has_the_figures_that_stand_above_also_where_they_come_to_four() -> None:
    text = printed(
        "sphere A, B: mass m\nsphere A: velocity u i\nsphere B: at rest\nA hits B: along 35°\n"
        "given deflection(A) = 40°\nfind e, energy_lost/energy(0)"
    )
    assert "fraction lost ≈ 0.1023mu²/(½mu²) ≈ 0.205" in text


def test_ratios_of_15_degrees_are_those_of_a_calculator() -> None:
    """A question that has roots itself has the roots of 15° too."""
    wall = "wall W: along i\nsphere P: mass 0.6, velocity {} at 60° to W\nP hits W\n"
    asked = "given deflection(P) = 75°\n"
    text = printed(wall.format("4") + asked + "find e, speed(P), impulse")
    assert "tan 15° = 2√3 e/2 DM1 (i) e ≈ 0.155" in text
    assert "magnitude of the impulse ≈ 0.6(0.5359 + 2√3) ≈ 2.4 N s" in text
    assert "√6" not in text
    assert "e ≈ 0.155" in printed(wall.format("u") + asked + "find e")
    assert "(2√3 − 3)/3" in printed(wall.format("4") + asked + "show e = (2sqrt(3) - 3)/3")


def test_multiples_of_letters_at_15_degrees_have_its_ratios() -> None:
    """The roots of its sine and cosine are no shorter to be read than those of 37°."""
    text = printed(
        "sphere A: mass m, velocity u at 15°\nsphere B: mass 2m, at rest\nA hits B: along i\n"
        "find velocity(A) in terms of e, u\ngiven e = 1/3\nfind angle(velocity(A), i), speed(B)"
    )
    for said in (
        "the component of A in the direction of 𝐣 stays u sin 15°.",
        "𝐯_A = ⅓(1 − 2e)u cos 15° 𝐢 + u sin 15° 𝐣",
        "tan β = (u sin 15°)/((1/9)u cos 15°) = 9 tan 15°",
        "w = (4/9)u cos 15°",
    ):
        assert said in text
    assert "√" not in text


def test_a_share_at_75_degrees_keeps_its_cosine() -> None:
    text = printed(
        "wall W: along i\nsphere P: velocity u at 75° to W\nP hits W\n"
        "given angle(velocity(P), W) = 45°\nfind e, speed(P), energy_lost/energy(0)"
    )
    assert "tan 45° = (eu sin 75°)/(u cos 75°) = e tan 75°" in text
    assert "≈ 0.866" in text


def test_what_figures_are_put_into_is_worked_out_before_the_outcome() -> None:
    text = printed(
        "wall AB: along i\nwall BC: along 75°\nsphere P: velocity u at 30° to AB\n"
        "P hits AB: e = 1/2\nP hits BC: e = 1/2\nfind angle(velocity(P), BC)"
    )
    assert "(√3 u/2) sin 75° − (u/4) cos 75°" in text
    assert "≈ ½ × 0.7718u ≈ 0.3859u" in text
    assert "tan β ≈ 0.3859u/(0.4656u)" in text


def test_a_difference_has_the_figures_that_stand_above_also_where_it_comes_to_four() -> None:
    text = printed(
        "wall L: along i\nwall R: along i\nsphere P: mass 0.1, velocity 3 at 65°\n"
        "P hits R: e = 0.8\nP hits L: e = 0.8\nfind total_energy_lost"
    )
    assert "total kinetic energy lost ≈ 0.45 − 0.2318 ≈ 0.218 J" in text


def test_the_power_of_a_number_does_not_run_into_a_letter() -> None:
    text = printed(
        "sphere A: mass m, velocity 8i\nsphere B: mass 2m, at rest\n"
        "A hits B: along i, e = 1/2\nfind energy_lost"
    )
    assert "kinetic energy lost = ½m(8²) − ½ × 2m(4²) = 16m" in text


def test_a_vector_of_long_products_with_a_letter_is_printed() -> None:
    text = """
wall W: along i
wall X: along 60°
sphere P: mass m, velocity u at -20°
P hits W: e = 3/4
P hits X: e = 1/2
find velocity(P), direction(P)
"""
    assert "𝐯₂ ≈ −0.3428u((√3/2)𝐢" in to_text(explain(solve(parse(text))), 100)


def test_a_decimal_that_ends_with_its_fourth_figure_is_not_rounded() -> None:
    text = printed(
        "sphere A: mass 3, velocity 5i\nsphere B: mass 2, velocity -2i\n"
        "A hits B: along i, e = 1/2\n"
        "find energy_lost, energy_lost/energy(0)\n"
    )
    assert "= 441/20 = 22.05 J" in text
    assert "fraction lost = (441/20)/(83/2) = 441/830 ≈ 0.531" in text


def checked(statement: str) -> str:
    return " ".join(to_text(explain(solve(parse(statement)), check=True)).split())


@pytest.mark.parametrize(
    ("statement", "says"),
    [
        (
            # J² + 3(1 + √3)J = 207, and the velocities 6i + 6j and 24.81i + 16.86j.
            (
                "wall W: along i\nsphere P: mass 1/2, velocity 6i - 8j\nP hits W: e = 3/4\n"
                "P receives J at 30°\ngiven speed(P) = 3 speed(P, 0)\nfind J, deflection(P)"
            ),
            [
                "𝐯₂ ≈ (24.81𝐢 + 16.86𝐣) m s⁻¹",
                "speed of P after the impulse ≈ √(24.81² + 16.86²)",
                "≈ 0.9823",
                "δ ≈ 10.8°",
            ],
        ),
        (
            # J = 2.553: 4.209i − 4.276j comes to the wall.
            (
                "wall W: along i\nsphere P: mass 1, velocity 2i - 3j\nP receives J at -30°\n"
                "given speed(P) = 6\nP hits W: e = 1/2\nfind J, velocity(P), speed(P), energy_lost"
            ),
            [
                "𝐢 stays 4.209 m s⁻¹",
                "component of 𝐯₂ along 𝐣 ≈ ½ × 4.276 ≈ 2.138 m s⁻¹",
                "𝐯₂ ≈ (4.21𝐢 + 2.14𝐣) m s⁻¹",
                "speed of P ≈ √(2.138² + 4.209²) ≈ 4.72 m s⁻¹",
                "≈ ½(4.276² − 2.138²) ≈ 6.86 J",
            ],
        ),
        (
            # J = 3.577: 4.789i − 5.098j and two walls, to within what four figures of 𝐯 tell.
            (
                "wall V: along i\nwall W: along j\nsphere P: mass 1, velocity 3i - 2j\n"
                "P receives J at -60°\ngiven speed(P) = 7\nP hits V: e = 1/2\nP hits W: e = 2/3\n"
                "find J, angle(velocity(P), i), impulse(P, 3)"
            ),
            [
                "component of 𝐯₃ along 𝐢 ≈ −⅔ × 4.792 ≈ −3.194 m s⁻¹",
                "tan β ≈ 2.552/(−3.194) ≈ −0.7988",
                "β ≈ 180° − 38.62°, as tan β < 0 ≈ 141°",
                "≈ −7.99𝐢 N s",
            ],
        ),
        (
            # J = 8.797: A has 4.199i + 6.809j before the impact.
            (
                "sphere A: mass 2, velocity 2i + 3j\nsphere B: mass 1, at rest\n"
                "A receives J at 60°\ngiven speed(A) = 8\nA hits B: along i, e = 1/2\n"
                "find J, velocity(B), speed(A)"
            ),
            [
                "2 × 4.199 ≈ 2v + w",
                "𝐯_B ≈ 4.20𝐢 m s⁻¹",
                "≈ 7.13 m s⁻¹",
            ],
        ),
        (
            # J = 9.473: (12 − J)/6 = 0.4212 and (√3 J + 30)/6 = 7.735.
            (
                "sphere P: mass 3, velocity 2i + 5j\nP receives J at 120°\ngiven energy(P) = 90\n"
                "find J\nfind angle(velocity(P), i)\nfind velocity(P)"
            ),
            ["≈ 18.36", "β ≈ 86.9°", "𝐯_P ≈ (0.421𝐢 + 7.73𝐣) m s⁻¹"],
        ),
    ],
)
def test_a_value_with_roots_of_sums_of_roots_is_carried_in_figures(
    statement: str, says: list[str]
) -> None:
    text = checked(statement)
    for own in says:
        assert own in text
    assert "not written out" not in text and "does not follow" not in text


def test_an_angle_of_roots_of_sums_of_roots_is_told_by_its_tangent() -> None:
    """Its cosine took a minute, and nobody would read it; also beyond a right angle."""
    root = sp.sqrt(118 + 8 * sp.sqrt(3))
    x = 117 - 36 * sp.sqrt(3) - 9 * sp.sqrt(2) * root - 18 * sp.sqrt(6) * root
    y = 99 - 9 * sp.sqrt(2) * root + 18 * sp.sqrt(6) * root
    angle = tidy_angle(sp.pi + sp.atan(y / x))
    assert angle.atoms(sp.atan) and not angle.atoms(sp.acos, sp.asin)
    assert float(angle) == pytest.approx(math.atan2(y, x))


def test_a_value_that_stands_rounded_is_shown_by_more_figures() -> None:
    shown = printed(
        "wall W: along i\nsphere P: mass m, velocity 3u i - 4u j\nP hits W: e = 1/3\n"
        "find speed(P)\nshow speed(P) = 3.28u to 3 s.f."
    )
    assert "(i) speed of P = √((4u/3)² + (3u)²) = √97 u/3 ≈ 3.28u" in shown
    assert "(ii) speed of P ≈ 3.283u ≈ 3.28u (as required)" in shown


def test_a_cosine_by_a_scalar_product_has_its_figures_with_a_calculator() -> None:
    text = printed(
        "wall OX: along i\nwall OY: along j\nsphere P: velocity 4 at 232°\nP hits OX: e = 2/3\n"
        "P hits OY: e = 1/2\nfind angle(velocity(P, 0), velocity(P))"
    )
    assert "≈ −0.99114 M1 A1 β ≈ 172°" in text


def test_roots_below_roots_are_figures_among_numbers() -> None:
    text = checked(
        "sphere A: mass 2, velocity 6 at 30°\nsphere B: mass 3, velocity 5 at 120°\n"
        "A hits B: along i, e = 1/2\npart a\nfind speed(A)\npart b\nfind deflection(A)"
    )
    assert "v ≈ −1.730 m s⁻¹" in text
    assert "speed of A ≈ √(1.730² + 3²) ≈ 3.46 m s⁻¹" in text
    assert "β ≈ 60.02°" in text
    assert "√(" not in text.replace("√(1.730² + 3²)", "")


def test_a_component_along_a_slanting_wall_is_written_out_before_its_figures() -> None:
    text = checked(
        "wall AB: along i\nwall BC: along 45°\nsphere P: mass 0.3, velocity 10 at 30° to AB\n"
        "P hits AB: e = 2/3\npart a\nfind speed(P)\npart b\nP hits BC: e = 1/2\nfind speed(P)"
    )
    assert "𝐯₁ · 𝐧 = 5√3(√2/2) − (10/3)(√2/2) ≈ 3.767 m s⁻¹" in text
    assert "√(1.883² + 8.481²)" in text


def test_what_follows_from_an_angle_of_a_calculator_is_in_figures() -> None:
    text = checked(
        "wall W: along j\nsphere P: mass 0.5, velocity 6 at alpha to W\nP hits W: e = 0.4\n"
        "given deflection(P) = 70°\npart a\nfind alpha\npart b\n"
        "find speed(P), energy_lost, impulse"
    )
    # sin 46.87° and cos 46.87°; 6 sin α is 4.379, of which 0.4 is left.
    assert "sin α ≈ 0.7299" in text and "cos α ≈ 0.6836" in text
    assert "speed of P ≈ √(1.752² + 4.102²) ≈ 4.46 m s⁻¹" in text
    assert "½ × 0.5(4.379² − 1.752²) ≈ 4.03 J" in text
    assert "0.5(4.379 + 1.752) ≈ 3.07 N s" in text
    assert "not written out" not in text


def test_angles_of_roots_are_added_in_degrees() -> None:
    text = checked(
        "wall W: along i\nsphere P: velocity 10 at alpha to W\nP hits W: e = 0.6\n"
        "given speed(P) = 7\npart a\nfind alpha\npart b\nfind deflection(P)"
    )
    assert "δ ≈ 63.21° + 49.92°" in text


def test_a_speed_of_a_calculator_is_a_quotient_of_decimals_and_then_its_figures() -> None:
    text = checked(
        "wall W: along i\nsphere P: mass 0.6, velocity 7.5 at 41° to W\nP hits W\n"
        "given angle(velocity(P), W) = 22°\npart a\nfind e\npart b\n"
        "find speed(P), energy_lost/energy(0) as a percentage"
    )
    assert "speed of P = (7.5 cos 41°)/cos 22° ≈ 6.1049 ≈ 6.10 m s⁻¹" in text
    assert "percentage lost ≈ (7.5² − 6.1049²)/7.5² ≈ 33.7%" in text


def test_an_angle_of_an_earlier_part_is_in_degrees_again() -> None:
    text = checked(
        "wall W: along i\nsphere P: mass 0.25, velocity u at alpha to W\nP hits W: e = 0.6\n"
        "given speed(P) = 5, angle(velocity(P), W) = 24°\npart a\nfind alpha, u\npart b\n"
        "find deflection(P)"
    )
    assert "With α from part (a): δ ≈ 36.58° + 24°" in text


def test_a_vector_is_rounded_once() -> None:
    """v is −2.7946: −2.795 on the way, and −2.79 in the end."""
    text = checked(
        "sphere A, B: mass 0.4\nsphere A: velocity 7 at 28°\nsphere B: velocity 5 at 200°\n"
        "A hits B: along i, e = 0.65\nfind velocity(A), velocity(B)"
    )
    assert "𝐯_A ≈ (−2.79𝐢 + 3.29𝐣) m s⁻¹" in text
    assert "1.225 cos" not in text


def test_the_angle_of_a_path_with_a_wall_stays_and_not_its_complement() -> None:
    text = checked(
        "wall R: along 20°\nsphere P: mass 0.3, velocity 6 at 75°\nP hits R: e = 0.55\n"
        "find speed(P), impulse"
    )
    assert "6 cos 55°" in text and "0.55 × 6 sin 55° = 3.3 sin 55°" in text
    assert "0.3(6 sin 55° + 3.3 sin 55°)" in text
    assert "35°" not in text


def test_an_impulse_by_a_direction_in_degrees_is_the_subject_of_its_equation() -> None:
    """J is 3√3/(2 cos 20°), which no formula has from 50° and 60°."""
    text = checked(
        "sphere P: mass 0.6, velocity 5i\nP receives J at 130°\ngiven direction(P) = 60°\n"
        "part a\nfind J\npart b\nfind speed(P), energy_lost"
    )
    assert "J ≈ 2.76" in text
    assert "speed of P ≈ √(2.038² + 3.530²) ≈ 4.08 m s⁻¹" in text
    assert "not written out" not in text


def test_products_of_cosines_that_sympy_cannot_join_are_no_error() -> None:
    """Of cos 24° cos 35° and the like SymPy asks for keys that it has taken out."""
    text = checked(
        "sphere A: mass 2, velocity 6 at 24°\nsphere B: mass 5, velocity 3 at 180° - 35°\n"
        "A hits B: along i\ngiven speed(A) = 4\nfind e"
    )
    assert "4.172 ≈ 7.939e e ≈ 0.526" in text


def test_a_sum_in_a_letter_has_its_coefficients_in_figures() -> None:
    text = checked(
        "wall W: along i\nwall V: along 75°\nsphere P: velocity 8 at -52°\nP hits W: e = e\n"
        "P hits V: e = 1/2\ngiven energy(P) = 1/4 energy(P, 0)\nfind e"
    )
    assert "0.8158e − 2.379" in text  # −½(8 cos 52° sin 75° − 8e sin 52° cos 75°)
    assert "2.359e² + 0.7277e − 0.5448 ≈ 0" in text
    assert "cos² 52°" not in text


def test_a_multiple_of_one_cosine_stays_exact() -> None:
    """Only where several cosines stand in a sum nobody reads it."""
    text = checked(
        "sphere A: mass 3, velocity 5 at 40°\nsphere B: mass 0.4, at rest\nA hits B: along i\n"
        "find along(velocity(A), i), speed(B)"
    )
    assert "(5/17)(15 − 2e) cos 40°" in text
    assert "(75/17)(1 + e) cos 40°" in text


def test_a_factor_of_all_coefficients_stands_before_a_bracket() -> None:
    text = checked(
        "sphere A, B: mass 3\nsphere A: velocity 6 at 52°\nsphere B: velocity 3 at 125°\n"
        "A hits B: along i\nfind energy_lost"
    )
    assert "≈ 21.99(1 − e²) J" in text
    assert "5.415 − w + v ≈ 5.415(1 − e)" in text


@pytest.mark.parametrize("turn", ["20°", "25°", "110°"])
def test_components_along_a_wall_at_an_angle_follow(turn: str) -> None:
    """Of (i − j) along 20° the exact value is √2 cos 25°."""
    text = checked(
        f"wall W: along {turn}\nsphere P: velocity 2i - 2j\nP hits W: e = 3/4\n"
        "find angle(velocity(P), W)"
    )
    assert "does not follow" not in text


def test_a_value_has_as_many_figures_where_it_stands_first_as_below() -> None:
    text = checked(
        "sphere A, B: mass 0.2\nsphere A: velocity 5 at 35°\nsphere B: at rest\nA hits B: along i\n"
        "given angle(velocity(A), line_of_centres) = 65°\npart a\nfind e\n"
        "part b\nfind impulse, energy_lost"
    )
    assert "w ≈ 2.7584 m s⁻¹" in text
    assert "0.2 × 2.7584" in text


def test_what_an_equation_gives_has_its_figures_in_an_energy() -> None:
    text = checked(
        "wall W: along i\nsphere P: mass 0.15, velocity u at 40° to W\nP hits W\n"
        "given deflection(P) = 62°\npart a\nfind e\npart b\ngiven impulse = 1.1\n"
        "find u, energy_lost"
    )
    assert "½ × 0.15(4.950² − 2.383²) ≈ 1.41 J" in text


@pytest.mark.parametrize(
    ("masses", "speeds", "angles", "line"),
    [
        (("2", "1"), ("6", "4"), ("60°", "150°"), "= 3 + 4 cos 30° = 3 + 2√3 ≈ 6.46 N s"),
        (("2", "1"), ("6", "2 sqrt(2)"), ("60°", "135°"), "= 3 + 2√2 cos 45° = 3 + 2 = 5 N s"),
        (("2m", "2m"), ("2u", "u"), ("60°", "60°"), "= 2m(2u cos 60° − 5u/8) = 2m(u − 5u/8)"),
        (("3", "1"), ("7", "2 sqrt(2)"), ("45°", "60°"), "= 61√2/16 − 2√2 cos 60°"),
    ],
)
def test_a_component_that_has_no_line_is_written_as_the_data_have_it(
    masses: tuple[str, str], speeds: tuple[str, str], angles: tuple[str, str], line: str
) -> None:
    bodies = zip("AB", masses, speeds, angles, strict=True)
    spheres = "".join(f"sphere {n}: mass {m}, velocity {v} at {a}\n" for n, m, v, a in bodies)
    text = printed(spheres + "A hits B: along i, e = 1/2\nfind speed(A), speed(B), impulse")
    assert f"magnitude of the impulse {line}" in text


def test_a_loss_has_components_as_the_data_have_them() -> None:
    text = printed(
        "sphere A: mass 3, velocity 7 at 45°\nsphere B: mass 1, velocity 2 sqrt(2) at 60°\n"
        "A hits B: along i, e = 1/2\nfind energy_lost"
    )
    assert "½ × 3((7 cos 45°)² − (41√2/16)²) + ½((2√2 cos 60°)² − (61√2/16)²)" in text


def test_a_short_sum_with_a_root_stays_exact_beside_a_long_one() -> None:
    """Of angles such as 30°; what is longer has its figures."""
    text = printed(
        "sphere A: mass 2, velocity 6 at 60°\nsphere B: mass 1, velocity 4 at 150°\n"
        "A hits B: along i, e = 1/2\nfind speed(A), speed(B)"
    )
    assert "v = (3 − 2√3)/2 m s⁻¹" in text
    assert "v ≈" not in text
    text = printed(
        "sphere A: mass 4, velocity 8 at 30°\nsphere B: mass 5, velocity 3 at 135°\n"
        "A hits B: along i, e = 0.6\nfind speed(A)"
    )
    assert "v ≈ −1.116 m s⁻¹" in text


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (
            "sphere P: mass 1, velocity 6 at -30°\nwall W: along i + j\nP hits W: e = 1/2\n",
            ("stays 6 cos 75° m s⁻¹", "−½ × 6 sin 75°", "= 6 sin 75° + 3 sin 75°"),
        ),
        (
            """
sphere A: mass 2, velocity 5 at 60°
sphere B: mass 3, velocity 4 at -150°
A hits B: along i + j, e = 1/3
""",
            ("2 × 5 cos 15° + 3(−4 cos 15°) = 2v + 3w", "3(⅘ cos 15° + 4 cos 15°)"),
        ),
        (
            """
sphere A: mass 2, velocity 6 at 105°
sphere B: mass 1, velocity 4 at -45°
A hits B: along -i + j, e = 1/2
""",
            ("2 × 6 cos 30° − 4 = 2v + w",),
        ),
    ],
)
def test_a_line_along_i_and_j_makes_45_degrees(statement: str, lines: tuple[str, ...]) -> None:
    """With a velocity that is told by degrees its component is told by their difference."""
    asked = "find impulse" if "sphere A" in statement else "find speed(P), impulse"
    text = printed(statement + asked)
    for line in lines:
        assert line in text


def test_a_value_behind_figures_is_one_number() -> None:
    text = printed(
        "sphere A: mass 2, velocity 5 at 70°\nsphere B: mass 3, at rest\n"
        "A hits B: along i + j, e = 1/3\nfind velocity(A), impulse"
    )
    assert "magnitude of the impulse ≈ 3 × 2.417 ≈ 7.25 N s" in text


@pytest.mark.parametrize(
    ("statement", "line"),
    [
        (
            """
sphere A: mass 1, velocity 2 at 45°
sphere B: mass 2, velocity 4 at 60°
A hits B: along i, e = 1/2
find speed(A)
""",
            "component of 𝐮_A along 𝐢 = 2 cos 45° = √2 m s⁻¹",
        ),
        (
            """
sphere P: mass 2, velocity 3 at 30°, at (0, 0)
wall W: along i through (0, -2)
P hits W: e = 1/3
find speed(P)
""",
            "component of 𝐮_P along 𝐣 = 3 sin 30° = 3/2 m s⁻¹",
        ),
    ],
)
def test_components_that_do_not_approach_come_of_the_data(statement: str, line: str) -> None:
    assert line in printed(statement)


def test_a_vector_of_short_decimals_stands_once() -> None:
    """Its components are all decimals, and no line has the same vector in fractions."""
    statement = (
        "sphere A: mass 1, velocity 3i + 4j\nsphere B: mass 1, velocity -3i\n"
        "A hits B: along 2i - j, e = 1/2\nfind velocity(A), velocity(B)\n"
    )
    text = " ".join(to_text(explain(solve(parse(statement)))).split())
    assert "= (0.6𝐢 + 5.2𝐣) m s⁻¹" in text
    assert "𝐯_B = (−0.6𝐢 − 1.2𝐣) m s⁻¹" in text
    assert "(26/5)𝐣" not in text


def test_a_coefficient_has_the_figures_that_a_later_part_puts_in() -> None:
    text = """
wall W: along i
sphere P: mass 0.2, velocity 9 at 40° to W
P hits W
given angle(velocity(P), W) = 25°
part a
find e
part b
find impulse
"""
    whole = printed(text)
    assert "e = (tan 25°)/tan 40° ≈ 0.5557 ≈ 0.556" in whole
    assert "Substituting e ≈ 0.5557 from part (a)" in whole


def test_figures_that_stand_for_a_component_are_not_written_again_for_the_speed() -> None:
    """B moves along the line of centres: its speed is the component above."""
    text = printed("""
sphere A, B: mass 0.17
sphere A: velocity 3.2 at 25°
sphere B: at rest
A hits B: along i, e = 0.9
find speed(A), speed(B)
find impulse
""")
    assert "w = 3.04 cos 25° ≈ 2.755 m s⁻¹" in text
    assert "speed of B = 3.04 cos 25° ≈ 2.76 m s⁻¹" in text


def test_the_last_end_of_a_range_has_its_figures_behind_it() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at 60° to W
P hits W
given speed(P) <= 3/4 u
find range of e
"""
    assert "0 ≤ e ≤ √15/6 ≈ 0.645, as e cannot be negative" in printed(text)
    below = printed(text.replace("<=", ">="))
    assert "√15/6 ≤ e ≤ 1" in below and "0.645 ≤ e ≤ 1, to 3 s.f." in below
