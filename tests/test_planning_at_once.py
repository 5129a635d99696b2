"""What stands above is used as it stands: forms of an equation, energies, components, letters."""

from __future__ import annotations

import re

from test_planning_closing import planned, said

from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain, to_text

SPHERES = "sphere A: mass 2m, velocity u i\nsphere B: mass 3m, at rest\n"


def text_of(statement: str) -> str:
    """A working, in one line."""
    return " ".join(to_text(explain(solve(parse(statement)))).split())


def test_a_speed_follows_from_the_energy_that_stands() -> None:
    _, derivation = planned(
        "wall V: along i\nwall W: along j\nsphere P: mass m, velocity u at alpha from -i\n"
        "P hits V: e = e\nP hits W: e = e\n"
        "given total_energy_lost = 75% energy(0)\nfind e, speed(P)"
    )
    lines = said(derivation)
    assert lines[-3:] == ["speed(P, 2)^2 = e^2 u^2", "speed(P, 2)^2 = u^2/4", "speed(P, 2) = u/2"]
    assert not any("1/2 u cos" in each for each in lines)


def test_the_square_of_a_speed_has_no_root() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: mass 2, velocity 3i - 5j\nP hits W: e = 2/5\nfind speed(P)^2"
    )
    assert said(derivation)[-1] == "speed(P, 1)^2 = 2^2 + 3^2 = 13 [rearrange]"


def test_the_square_of_a_speed_that_is_asked_is_its_square() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: mass 2, velocity 3i - 5j\nP hits W: e = 2/5\n"
        "find speed(P), speed(P)^2"
    )
    assert "speed(P, 1) = sqrt(2^2 + 3^2) = sqrt(13) [rearrange]" in said(derivation)


def test_a_letter_comes_of_the_last_form_of_its_equation() -> None:
    text = text_of(
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass 5m, at rest\nA hits B: along i\n"
        "given deflection(A) = 90°\nfind range of alpha, e in terms of alpha"
    )
    assert "tan²α = (5e − 2)/7 (3)" in text
    assert "From (3): e = (2 + 7 tan²α)/5" in text


def test_the_second_component_is_put_into_the_law() -> None:
    _, derivation = planned(f"{SPHERES}A hits B: along i\nfind velocity(A), velocity(B)")
    assert "w = (2 - 3e) u/5 + e u = 2(1 + e) u/5 [rearrange]" in said(derivation)


def test_laws_with_sums_in_them_are_tidied_before_they_are_solved() -> None:
    _, derivation = planned(
        f"{SPHERES}wall W: along j\nA hits B: along i, e = e\n"
        "B hits W: e = 1/3\nA hits B: along i, e = e\nfind velocity(A)"
    )
    lines = said(derivation)
    assert "2(1 - 4e) u/5 = 2v_3 + 3w_3" in lines
    assert "w_3 - v_3 = (8 - 7e) e u/15" in lines


def test_coordinates_with_roots_are_collected_in_a_line() -> None:
    solution, _ = planned(
        "sphere A: mass 1, velocity 5i - 2j\nsphere B: mass 2, velocity i + 3j\n"
        "A hits B: along i - j\ngiven impulse = 3\nfind velocity(A)"
    )
    text = to_text(explain(solution))
    assert "(3√2/2)(𝐢 − 𝐣) = ((10 − 3√2)/2)𝐢 + ((3√2 − 4)/2)𝐣" in text


def test_equal_angles_are_shown_by_their_letters() -> None:
    text = text_of(
        "sphere A, B: mass 3m\nsphere A: velocity 2u at theta\n"
        "sphere B: velocity 2u at theta from -i\n"
        "A hits B: along i\nshow deflection(A) = deflection(B)"
    )
    assert "δ = 180° − θ − β" in text
    assert "arctan" not in text
    assert re.search("([φψ]) = β, as tan \\1 = tan β", text)


def test_who_was_at_rest_moves_off_along_the_line_of_centres() -> None:
    text = text_of(
        "sphere A, B, C: mass m\nsphere A: velocity u at alpha\nsphere B, C: at rest\n"
        "A hits B: along i\nB hits C: along 45°\nfind speed(C)"
    )
    moved = "so it moved off along the line of centres of that impact, at 45°"
    assert f"B was at rest before the first impact, {moved}" in text


def test_the_factors_of_a_difference_have_their_signs() -> None:
    text = text_of(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
        "sphere C: mass k^2 m, at rest\n"
        "A hits B: along i\nB hits C: along i\nshow A and B do not collide again\ngiven k < e"
    )
    assert "as 1 − ek > 0 and e − k > 0, because k < e and e ≤ 1" in text or (
        "as 1 − ek > 0 and e − k > 0, because k < e ≤ 1" in text
    )


def test_the_loss_of_two_moving_spheres_is_a_product() -> None:
    solution, derivation = planned(
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass 3m, velocity v at beta from -i\n"
        "A hits B: along i\nfind energy_lost"
    )
    lines = [each for each in said(derivation) if each.startswith("energy_lost(1) = ")]
    assert lines[-1].endswith("= 3m (1 - e^2) (u cos(alpha) + v cos(beta))^2/5")
    assert not any("cos(alpha)^2" in each or "cos^2" in each for each in lines)
    assert "½ × 3m(x + v cos β)(u cos α + w − (x − v cos β))" in to_text(explain(solution))


ROAD = (
    "wall W: along j, through (12, 0)\nsphere A: mass 2, at (0, 0), velocity 3i, radius 1/2\n"
    "sphere B: mass 1, at (9, 0), velocity -i, radius 1/2\n"
    "A hits B: e = 1/2\nB hits W: e = 1/2\nA hits B: e = 1/2\n"
)


def test_spheres_on_a_line_meet_by_distances() -> None:
    _, derivation = planned(f"{ROAD}find time(1), time(3), velocity(A)")
    lines = said(derivation)
    assert not any("^2" in each for each in lines)
    assert "time(1) = (9 - 2(1/2))/(3 + 1) = 2 [rearrange]" in lines
    assert any(each.endswith("= 47/10 [rearrange]") for each in lines)


def test_where_a_sphere_at_rest_is_struck_both_radii_are_taken_off() -> None:
    text = text_of(
        "sphere A: mass m, at (0, 0), velocity u j, radius r\n"
        "sphere B: mass 2m, at (0, d), at rest, radius r\n"
        "given d > 2r\nA hits B\nfind time(1)"
    )
    assert "When A and B touch, their centres are 2r apart." in text
    assert "t = (d − 2r)/u" in text


def test_spheres_off_a_line_have_the_line_of_centres_of_their_places() -> None:
    text = text_of(
        "sphere A: mass 1, at (0, 0), velocity 2i, radius 1\n"
        "sphere B: mass 1, at (6, 1), at rest, radius 1\nA hits B: e = 1/2\nfind time(1)"
    )
    assert "A and B touch when their centres are 2 m apart" in text


def test_a_given_speed_has_its_sense_by_a_bound_of_e() -> None:
    text = text_of(
        "sphere A: mass 2m, velocity 3u i\nsphere B: mass 3m, velocity u i\nA hits B: along i\n"
        "given speed(B) = 2u\nfind e"
    )
    assert "It is given that the speed of B is 2u, and w > 0, as e ≥ 0:" in text


def test_a_square_stands_alone_where_a_given_sign_lets_it() -> None:
    text = text_of(
        "sphere A: mass m, velocity u i + v j\nsphere B: mass m, velocity -u i + v j\n"
        "A hits B: along i\ngiven energy_lost = 1/4 energy(0), u > 0\nfind e\nfind range of v/u"
    )
    assert "1 − e² = (u² + v²)/(4u²), as u > 0 e² = (3u² − v²)/(4u²) (4)" in text
    assert "(3u² − v²)/(4u²) ≥ 0, as e² ≥ 0" in text


def test_what_holds_of_any_coefficient_is_shown_by_that() -> None:
    text = text_of("wall W: along i\nsphere P: velocity u at alpha to W\nP hits W\nshow e <= 1")
    assert "e ≤ 1, as a coefficient of restitution is at most 1 (as required)" in text


def test_a_product_of_which_the_signs_tell_is_not_multiplied_out() -> None:
    text = text_of(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
        "sphere C: mass k^2 m, at rest\n"
        "A hits B: along i\nB hits C: along i\ngiven e = 1/3\n"
        "given A and B do not collide again\nfind range of k"
    )
    assert "(3k − 1)(k − 3) ≥ 0 0 < k ≤ ⅓ or k ≥ 3, as k > 0" in text


def test_a_condition_that_is_shown_below_is_not_said_above() -> None:
    statement = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass M, at rest\nA hits B: along i\n"
        "given velocity(A) perpendicular to velocity(A, 0)\nfind tan(alpha)"
    )
    assert "this holds for" in text_of(statement)
    assert "this holds for" not in text_of(f"{statement}\nshow M > m")


def test_a_velocity_that_is_asked_stands_before_it_is_resolved() -> None:
    _, derivation = planned(
        "sphere A: mass 2, velocity p i - j\nsphere B: mass 4, velocity i + q j\n"
        "A hits B: along 3i + 4j, e = 1/2\ngiven impulse(B) = 6i + 8j\n"
        "given velocity(A) parallel to j\nfind q, velocity(A)"
    )
    lines = said(derivation)
    (vector,) = (n for n, each in enumerate(lines) if each == "velocity(A, 1) = -5j")
    (resolved,) = (
        n
        for n, each in enumerate(lines)
        if each.startswith("along(velocity(A, 1), line_of_centres(1)) = ")
    )
    assert vector < resolved


def test_a_speed_follows_from_the_energy_that_is_given() -> None:
    _, derivation = planned(
        "wall W: along i\nsphere P: mass 2, velocity 10 at 30° to W\nP hits W\n"
        "given energy(P) = 76\nfind speed(P), e"
    )
    assert said(derivation)[:2] == ["speed(P, 1)^2 = 76", "speed(P, 1) = 2sqrt(19)"]


def test_given_inequalities_tell_on_which_side_a_sphere_is() -> None:
    text = text_of(
        "wall W: along j, through (0, 0)\nsphere A: mass m, at (3d, 0), velocity -u i, radius r\n"
        "sphere B: mass m, at (5d, 0), at rest, radius r\ngiven d > 2r\n"
        "A hits W: e = 1/2\nA hits B: e = 1/2\nfind time(2), position(B)"
    )
    assert "t₂ − t₁ = (5d − 2r − r)/(u/2) = 2(5d − 3r)/u" in text
    assert "B is at rest, so it stays where it is: position of B" in text
