"""What stands above is used as it stands: forms of an equation, energies, components, letters."""

from __future__ import annotations

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
    assert "2(1 - 4e) u/5 = 2v_2 + 3w_2" in lines
    assert "w_2 - v_2 = (8 - 7e) e u/15" in lines


def test_coordinates_with_roots_are_collected_in_a_line() -> None:
    solution, _ = planned(
        "sphere A: mass 1, velocity 5i - 2j\nsphere B: mass 2, velocity i + 3j\n"
        "A hits B: along i - j\ngiven impulse = 3\nfind velocity(A)"
    )
    text = to_text(explain(solution))
    assert "= ((7 − 3√2)/2 + 3/2)𝐢 + ((3√2 − 7)/2 + 3/2)𝐣" in text


def test_equal_angles_are_shown_by_their_letters() -> None:
    text = text_of(
        "sphere A, B: mass 3m\nsphere A: velocity 2u at theta\n"
        "sphere B: velocity 2u at theta from -i\n"
        "A hits B: along i\nshow deflection(A) = deflection(B)"
    )
    assert "δ = 180° − θ − β" in text
    assert "arctan" not in text
    assert "ψ = β, as tan ψ = tan β" in text


def test_who_was_at_rest_moves_off_along_the_line_of_centres() -> None:
    text = text_of(
        "sphere A, B, C: mass m\nsphere A: velocity u at alpha\nsphere B, C: at rest\n"
        "A hits B: along i\nB hits C: along 45°\nfind speed(C)"
    )
    assert "B was at rest, so it moved off along the line of centres: 𝐯_B = " in text


def test_the_factors_of_a_difference_have_their_signs() -> None:
    text = text_of(
        "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\n"
        "sphere C: mass k^2 m, at rest\n"
        "A hits B: along i\nB hits C: along i\nshow A and B do not collide again\ngiven k < e"
    )
    assert "as 1 − ek > 0 and e − k > 0, because k < e and e ≤ 1" in text or (
        "as 1 − ek > 0 and e − k > 0, because k < e ≤ 1" in text
    )
