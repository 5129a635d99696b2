"""A letter or a quantity that the facts fix: its range, what varies over it, what rests on it."""

from __future__ import annotations

import pytest
import sympy as sp

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W\n"
TWO = """sphere A: mass m, velocity 3u at 45°
sphere B: mass 2m, velocity u at 45° from -i
A hits B: along i
"""


@pytest.mark.parametrize("given", ["e = 1/2", "2e = 1", "speed(P) = sqrt(13)"])
@pytest.mark.parametrize("order", [(0, 1), (1, 0)])
def test_the_range_of_a_letter_with_one_value(given: str, order: tuple[int, int]) -> None:
    """9 + 16e² = 13 where e = ½."""
    lines = [f"given {given}", "find range of e"]
    solution = solve(parse(WALL + "\n".join(lines[n] for n in order)))
    assert solution["range of e"].answers[0].value == sp.FiniteSet(sp.Rational(1, 2))
    working = to_text(explain(solution), 80)
    assert "every value" not in working and "not written" not in working


def test_what_is_given_of_a_letter_bounds_it() -> None:
    working = to_text(explain(solve(parse(WALL + "given e < 1/2\nfind range of e"))), 80)
    assert "0 ≤ e < ½" in working
    assert "every value" not in working


@pytest.mark.parametrize("fact", ["alpha = 30°, e = 1/2", "e = 1/2, speed(P) = 3/4 u"])
def test_nothing_varies_that_is_fixed(fact: str) -> None:
    text = "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\n"
    solution = solve(parse(f"{text}given {fact}\nfind maximum of speed(P) over alpha, speed(P)"))
    error = solution["maximum of speed(P) over alpha"].error
    assert error is not None
    assert error.message.startswith("what is given fixes alpha, so there is nothing to vary")


def test_nothing_rests_on_an_impact_at_which_nothing_happens() -> None:
    """4(1 + e)/(5 − 4e) = 2(1 + e)/(1 − 2e) holds for e = −1 alone, where nothing happens."""
    solution = solve(
        parse(TWO + "given deflection(A) = deflection(B)\nfind e, deflection(A), speed(A, 0)")
    )
    for item in ("e", "deflection(A)"):
        error = solution[item].error
        assert error is not None and error.message.startswith("e = −1 rejected")
    assert solution["speed(A, 0)"].exact == 3 * sp.Symbol("u", positive=True)


def test_a_coefficient_has_no_unit_beside_a_number() -> None:
    """4(5 + e) + 5(e − 5) = 0: the velocity that is shown has 5 + e in it, of metres a second."""
    working = to_text(
        explain(
            solve(
                parse(
                    "wall W: along i - j\nsphere P: mass 0.3, velocity 4i - 6j\nP hits W\npart a\n"
                    "show velocity(P) = (5 + e) i + (e - 5) j\npart b\n"
                    "given velocity(P) perpendicular to 4i + 5j\nfind e"
                )
            )
        ),
        80,
    )
    assert "4(5 + e) + 5(e − 5) = 0" in working
    assert "e = 5/9 ≈ 0.556" in working and "0.556 m" not in working


def test_a_range_that_is_another_is_named_as_it_was_claimed() -> None:
    text = (
        "sphere A: mass 3m, velocity 4u i + 3u j\nsphere B: mass 5m, velocity -2u i + 3u j\n"
        "A hits B: along i\nshow range of energy_lost: 0 <= energy_lost <= 13/4 m u^2"
    )
    working = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert (
        "The range of possible values is not 0 ≤ kinetic energy lost ≤ 13mu²/4: it is "
        "0 ≤ kinetic energy lost ≤ 135mu²/4."
    ) in working


def test_no_sphere_comes_to_a_wall_through_another() -> None:
    """A follows B with 0.7u; B has come back from W to it and moves on before it."""
    solution = solve(
        parse(
            "wall W: along j, through (6a, 0)\nsphere A: mass 4m, at (a, 0), velocity u i\n"
            "sphere B: mass m, at (3a, 0), at rest\nA hits B: along i, e = 1/2\n"
            "B hits W: e = 1/2\nA hits B: along i, e = 1/2\nshow A will hit W\nshow B will hit W"
        )
    )
    error = solution["A will hit W"].error
    assert error is not None
    assert error.message == "B is between A and W, on one line with both"
    assert solution["B will hit W"].holds is True


def test_nothing_is_lost_where_a_coefficient_is_above_one() -> None:
    """cos θ = ⅓ and so w = 8u/3 = e × 4u/3: the kinetic energy would grow by 2mu²."""
    solution = solve(
        parse(
            "sphere A: mass 3m, velocity 2u at 60°\nsphere B: mass m, velocity u at theta from -i\n"
            "A hits B: along i\ngiven velocity(A) perpendicular to i\n"
            "given velocity(B) perpendicular to velocity(B, 0)\nfind e, theta, energy_lost"
        )
    )
    assert solution["theta"].exact == sp.acos(sp.Rational(1, 3))
    for item in ("e", "energy_lost"):
        error = solution[item].error
        assert error is not None and error.message.startswith("e = 2 rejected")


def test_a_contradiction_is_named_once() -> None:
    text = (
        "sphere A: mass 2, velocity 4i\nsphere B: mass 3, velocity 2j\nA receives p i + 4 j\n"
        "A hits B: along i, e = 1/4\ngiven velocity(A) = 1/2 velocity(B) + 3j\n"
        "find p, velocity(B)"
    )
    assert to_text(explain(solve(parse(text))), 80).count("contradict each other") == 1


def test_a_range_goes_over_an_angle_that_a_fact_bounds() -> None:
    """cos²α + (9/25)sin²α ≥ 16/25 where sin α ≤ ¾: then α + arctan(⅗ tan α) ≤ arccos(1/8)."""
    solution = solve(
        parse(
            "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 3/5\n"
            "given speed(P) >= 4/5 u\nfind range of deflection(P)"
        )
    )
    values = solution["range of deflection(P)"].answers[0].value
    assert values == sp.Interval.Lopen(0, sp.acos(sp.Rational(1, 8)))


def test_what_rests_on_an_impossible_coefficient_says_so() -> None:
    """tan 120° gives e = 7/5; the line of v takes it."""
    text = (
        "sphere A: mass m, velocity u at 60°\nsphere B: mass 5m, at rest\nA hits B: along i\n"
        "given angle(velocity(A), velocity(B)) = 120°\nfind e, speed(A)"
    )
    working = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert "can be worked out all the same, though there is no such impact." in working
    assert "without e" not in working


def test_what_has_no_value_bounds_no_letter() -> None:
    """v = 0 and w = u cos 30° = eu cos 30° × k: with m = 0 nothing has a value."""
    solution = solve(
        parse(
            "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B\n"
            "given direction(A) = 60°, direction(B) = -30°\nfind e in terms of k\nfind range of k"
        )
    )
    assert solution["range of k"].answers[0].value == sp.Interval(1, sp.oo)
    assert solution["e"].rejected == ()


def test_a_coordinate_that_is_reached_may_be_negative() -> None:
    """From (4, 4) with −i − 2j to (0, −4)."""
    solution = solve(
        parse(
            "wall W: along i + j, through (0, 0)\nsphere P: at (12, 4), velocity -3i\n"
            "P hits W: e = 1/3\nP reaches (0, y)\nfind y"
        )
    )
    assert solution["y"].exact == -4


def test_a_claim_does_not_rest_on_what_another_question_takes_for_granted() -> None:
    """½mu² − ¼me²u²(1 + e²), whatever A and B do after so long a time."""
    solution = solve(
        parse(
            "wall W: along j, through (0, 0)\nsphere A: mass m, at (d, 0), velocity -u i\n"
            "sphere B: mass m, at (3d, 0), at rest\nA hits W: e = e\nA hits B: along i, e = e\n"
            "find distance(A, B, at 4d/(e u))\n"
            "show total_energy_lost = 1/4 m u^2 (2 - e^2 - e^4)"
        )
    )
    assert solution["total_energy_lost = 1/4 m u^2 (2 - e^2 - e^4)"].holds is True


def test_a_component_has_no_vector_in_it() -> None:
    text = (
        "sphere A: mass 2, velocity 4i\nsphere B: mass 3, velocity 2j\nA receives p i + 4 j\n"
        "A hits B: along i, e = 1/4\ngiven velocity(A) = 1/2 velocity(B) + j\nfind velocity(B)"
    )
    working = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert "It is given that 𝐯_A2 = ½𝐯_B + 𝐣." in working


def test_a_sum_that_is_not_zero_is_divided_by() -> None:
    """28(1 + e)k/(25 + (4 − 21e)k) = 21(1 + e)/(25k − 3 − 28e) is linear in e without 1 + e."""
    text = (
        "sphere A: mass m, velocity 3u i + 4u j\nsphere B: mass k m, velocity -4u i - 3u j\n"
        "A hits B: along i\ngiven deflection(A) = deflection(B)\nfind e in terms of k"
    )
    working = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert "Dividing by 1 + e, which is not zero as e ≥ 0:" in working
    assert "e²" not in working


def test_a_value_of_whole_degrees_has_four_figures_on_the_way() -> None:
    """0.7 × 3.4 sin 40° = 1.5298: P moves at 25° + 15° to the wall."""
    text = (
        "wall W: along 25°\nsphere P: mass 0.2, velocity 3.4 at -15°\nP hits W: e = 0.7\n"
        "find speed(P), impulse, deflection(P), energy_lost"
    )
    working = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert "0.7 × 3.4 sin 40° = 2.38 sin 40° ≈ 1.530 m s⁻¹" in working
    assert "√((2.38 sin 40°)² + (3.4 cos 40°)²) ≈ 3.02 m s⁻¹" in working
    assert "not written" not in working and "√(cos" not in working


def test_letters_of_angles_do_not_run_out() -> None:
    """Five angles of deflection and of paths in one part."""
    text = (
        "wall OX: along i\nwall OY: along j\nsphere P: mass m, velocity u at alpha to OX\n"
        "P hits OX: e = 1/2\nP hits OY: e = 1/3\npart a\nfind minimum of speed(P) over alpha\n"
        "part b\ngiven total_energy_lost = 5/6 energy(0)\nfind alpha, deflection(P)\npart c\n"
        "find maximum of deflection(P, 1) over alpha\n"
        "find range of angle(velocity(P), velocity(P, 0))"
    )
    assert "so there is no greatest value" in to_text(explain(solve(parse(text))), 80)


def test_a_root_of_a_difference_of_squares_is_seen_to_fall() -> None:
    text = (
        "sphere A: mass m, velocity u i, radius a\nsphere B: mass m, at rest\n"
        "A hits B: offset d, e = 1/2\nfind maximum of speed(B) over d"
    )
    working = to_text(explain(solve(parse(text))), 80)
    assert "as 3u√(4a² − d²)/(8a) decreases with increasing d" in working


def test_an_equation_of_letters_is_what_a_ratio_comes_from() -> None:
    text = (
        "wall W: along j\nsphere P: mass m, velocity u at alpha\nP hits W\n"
        "given velocity(P) perpendicular to velocity(P, 0)\nshow tan^2(alpha) = e\n"
        "find energy_lost in terms of m, u, e\nfind energy_lost/energy(0) in terms of alpha"
    )
    working = " ".join(to_text(explain(solve(parse(text))), 80).split())
    assert "From (1): (iii) fraction lost = " in working
    assert "Substituting for the kinetic energy" not in working


def test_an_angle_without_a_value_refutes_nothing() -> None:
    """With e = 0 P is at rest after the second wall, so there is no second deflection."""
    text = (
        "wall OX: along i\nwall OY: along j\nsphere P: velocity u at alpha to OX\n"
        "P hits OX\nP hits OY\nshow deflection(P, 1) + deflection(P, 2) = 180°\n"
        "show deflection(P, 1) + deflection(P, 2) = 170°"
    )
    first, second = solve(parse(text)).parts[None].items
    assert first.holds is True
    assert second.holds is False


@pytest.mark.parametrize(
    ("mass", "condition", "ends"),
    [("k^2 m", "0 < e < 1", "e < k < 1/e"), ("m", "e > 0", "0 < k < (1 − √e + e)/√e")],
)
def test_ends_of_a_range_that_may_have_no_value(mass: str, condition: str, ends: str) -> None:
    """With e = 0 A and B collide again whatever k is: e < k < 1/e is not that."""
    text = (
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
        f"sphere C: mass {mass}, at rest\nA hits B: along i\nB hits C: along i\n"
        "given A and B collide again\nfind range of k in terms of e"
    )
    solution = solve(parse(text))
    forms = [answer.display for answer in solution["range of k"].answers]
    assert forms == ["k > 0, for e = 0", f"{ends}, for {condition}"]
    working = " ".join(to_text(explain(solution), 80).split())
    assert f"This holds for {condition}. In all, the range is {'; '.join(forms)}." in working
    assert "no such k" not in working


def test_a_sample_is_as_letters_look() -> None:
    """Of b nothing is known but a² ≤ b²: the size of the impulse is written for b > 0."""
    text = (
        "wall W: along i\nsphere P: mass m, velocity a i - b j\nP hits W\n"
        "given e = a^2/b^2\nfind impulse"
    )
    assert "|m(a²/b + b)| = m(a² + b²)/|b|" in to_text(explain(solve(parse(text))), 80)


def test_a_letter_for_an_angle_is_below_90_degrees() -> None:
    text = TWO.replace("45° from -i", "beta") + "given beta = 90°, e = 1\nfind velocity(A)"
    error = solve(parse(text))["velocity(A)"].error
    assert error is not None
    assert "the angle must lie between 0° and 90°" in error.message


def test_a_product_that_is_zero_by_the_other_letter() -> None:
    """With p = 0 they do not meet, so that q is zero: then A follows B."""
    text = (
        "sphere A: mass m, velocity p i + q j\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/2\ngiven velocity(A) parallel to velocity(B)\nfind q/p"
    )
    solution = solve(parse(text))
    assert solution["q/p"].exact == 0
    (branch,) = solution.parts[None].branches
    assert branch.values == {"q": 0}


def test_a_root_for_one_sense_of_a_letter_is_given_for_that_alone() -> None:
    """Where tan is −3/4 for u, it is 3/4 for −u: 1 − v²/4 is less than 0 for all four."""
    text = "wall W: along i\nsphere P: mass 2, velocity u i - v j\nP hits W: e = 1/4\n"
    solution = solve(parse(f"{text}given tan(deflection(P)) = -3/4\nfind v"))
    u = sp.Symbol("u", real=True)
    answers = solution["v"].answers
    assert len(answers) == 4
    for answer in answers:
        (condition,) = answer.condition
        sense = {"u < 0": -1, "0 < u": 1}[condition]
        v = float(answer.value.subs(u, sense))
        # The velocities before and after: (u, -v) and (u, v/4).
        assert abs(sense * 5 * v / 4) / (1 - v * v / 4) == pytest.approx(-0.75)
    assert sorted(each.condition for each in answers) == [("0 < u",)] * 2 + [("u < 0",)] * 2


def test_a_coefficient_that_is_too_unwieldy_to_be_bounded_has_its_condition() -> None:
    """With α = 81° and M less than m, the formula has 1.16 and more."""
    text = "sphere A: mass m, velocity u at alpha\nsphere B: mass M, at rest\n"
    text += "A hits B: along 3i + 4j\ngiven tan(deflection(A)) = sqrt(3)\nfind e"
    (answer,) = solve(parse(text))["e"].answers
    assert answer.display.endswith(", for 0 ≤ e ≤ 1")
