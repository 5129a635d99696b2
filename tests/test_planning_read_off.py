"""Directions that are read off, where a scalar product or a tangent would be a detour."""

from __future__ import annotations

import pytest
from test_planning_closing import lines, planned, said

from restitution.language import parse
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.workings import explain, to_text

WALL = "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W"
AT_REST = "sphere A: mass {a}, velocity u at alpha\nsphere B: mass {b}, at rest\nA hits B: along i"


@pytest.mark.parametrize(("a", "b", "e"), [("m", "5m", "1/5"), ("2m", "3m", "2/3")])
def test_at_right_angles_to_who_moves_along_the_line_of_centres(a: str, b: str, e: str) -> None:
    text = f"{AT_REST.format(a=a, b=b)}\ngiven velocity(A) perpendicular to velocity(B)\nfind e"
    solution, derivation = planned(text)
    (square,) = lines(derivation, "define")
    assert square.relation.only[-1].right.value == 0  # type: ignore[union-attr]
    assert "v = 0" in said(derivation)
    assert not lines(derivation, "combine")
    assert not lines(derivation, "roots")
    assert said(derivation)[-1] == f"e = {e}"
    words = " ".join(to_text(explain(solution), 200).split())
    assert "along the line of centres, and A perpendicular to it: v = 0 B1" in words


def test_both_components_count_where_both_spheres_move_across() -> None:
    _, derivation = planned(
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 1, velocity -i - j\n"
        "A hits B: along i\ngiven velocity(A) perpendicular to velocity(B)\nfind e"
    )
    assert "v = 0" not in said(derivation)


@pytest.mark.parametrize("e", ["1/2", "e"])
def test_a_speed_by_the_squares_of_sine_and_cosine(e: str) -> None:
    text = f"{WALL}: e = {e}\ngiven deflection(P) = 90°\nfind tan(alpha), speed(P)"
    if e == "e":
        text = f"{WALL}\ngiven deflection(P) = 90°\nfind tan(alpha), speed(P) in terms of u, e"
    solution, derivation = planned(text)
    told = said(derivation)
    assert not any(each.startswith("sin(alpha) =") for each in told)
    assert any(each.startswith("sin^2(alpha) =") for each in told)
    assert f"speed(P, 1) = sqrt(({'e' if e == 'e' else '1/2'} u sin(alpha))^2" in told[-2]
    assert told[-1].count("[rearrange]") == 1
    words = to_text(explain(solution), 200)
    assert words.count("speed of P =") == 1  # one chain
    assert "Substituting for sin" not in words


def test_a_right_angle_by_the_squares_of_sine_and_cosine() -> None:
    text = f"{WALL}: e = 1/9\ngiven speed(P) = 1/3 u\nfind tan(alpha), deflection(P)"
    solution, derivation = planned(text)
    assert (
        said(derivation)[-2]
        == "dot(velocity(P, 0), velocity(P, 1)) = -u^2/10 + u^2/10 = 0 [rearrange]"
    )
    assert "sin α = " not in to_text(explain(solution), 200)


def test_components_that_are_asked_have_the_ratios_themselves() -> None:
    text = f"{WALL}\ngiven deflection(P) = 90°, e = 1/2\nfind tan(alpha), speed(P), velocity(P)"
    _, derivation = planned(text)
    assert any(each.startswith("sin(alpha) =") for each in said(derivation))


POST = """wall C: circle centre (0, 0) radius a
sphere P: at (-3a, a/2), velocity u i
P hits C: e = 1/3"""


def test_a_velocity_along_i_and_one_along_j_are_at_right_angles() -> None:
    solution, derivation = planned(f"{POST}\nfind velocity(P), deflection(P)")
    assert not any("dot" in each for each in said(derivation))
    words = " ".join(to_text(explain(solution), 200).split())
    assert (
        "P came parallel to 𝐢 and leaves parallel to 𝐣. So angle of deflection of P = 90° A1ft"
        in words
    )


def test_a_deflection_that_is_the_angle_of_approach_doubles_it() -> None:
    text = AT_REST.format(a="m", b="k m")
    _, derivation = planned(f"{text}\ngiven deflection(A) = alpha\nfind k in terms of e, alpha")
    told = said(derivation)
    assert "beta = 2alpha" in told
    assert told[-1] == "k = (tan^2(alpha) + 1)/(1 - tan^2(alpha) + 2e)"


def test_a_deflection_by_a_blow_is_the_angle_to_the_axis_along_which_the_body_came() -> None:
    _, derivation = planned(
        "sphere P: mass 2, velocity 5j\nP receives 4i - 6j\nfind velocity(P), deflection(P)"
    )
    assert "tan(delta) = 2/2 = 1 [rearrange]" in said(derivation)
    assert not [each for each in derivation.lines if each.move.record == "scalar-angle"]
    # Of roots the component over a speed that is known is plainer.
    text = (
        "sphere P: mass 2, velocity 5i\nP receives J at theta\ngiven J = 6, speed(P) = 6\n"
        "find cos(theta), deflection(P)"
    )
    assert any(each.startswith("cos(delta) = ") for each in said(plan(solve(parse(text)))))


def test_a_scalar_product_with_an_axis_is_a_component() -> None:
    text = (
        "sphere A: mass 2, velocity 3i + j\nsphere B: mass 1, at rest\n"
        "A hits B: along 3i + 4j, e = 1/2\nfind dot(velocity(A), j)"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert "from its components" not in words
    assert "Components along the axes:\n    𝐯_A · 𝐣 = (13/10) × ⅘ − (9/5) × ⅗" in words


def test_a_scalar_product_with_an_axis_is_read_off_a_velocity_that_stands() -> None:
    text = (
        "sphere A: mass 2, velocity 3i + j\nsphere B: mass 1, at rest\n"
        "A hits B: along 3i + 4j, e = 1/2\nfind velocity(A), dot(velocity(A), j)"
    )
    solution, _ = planned(text)
    assert "Scalar product:\n    𝐯_A · 𝐣 = −0.04" in to_text(explain(solution), 200)


def test_a_component_across_an_axis_is_along_the_other() -> None:
    text = (
        "wall W: along theta\nsphere P: mass m, velocity u i\nP hits W: e = 1/3\n"
        "find across(velocity(P), i), across(velocity(P), j)"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert "component of 𝐯_P along 𝐣 = ⅓u sin θ cos θ" in words
    assert "component of 𝐯_P along −𝐢 = " in words
    assert "perpendicular to 𝐢" not in words


def test_directions_at_two_angles_are_resolved_by_their_difference() -> None:
    text = (
        "wall W: along theta\nsphere P: mass m, velocity u at alpha\nP hits W: e = e\n"
        "find velocity(P)"
    )
    _, derivation = planned(text)
    lines = said(derivation)
    assert lines[0].endswith("= u cos(alpha - theta)")
    assert "sin(alpha) cos(theta)" not in lines[-1]
    assert len(lines) == 4


def test_an_impulse_along_a_line_that_slants_is_a_multiple_of_its_unit_vector() -> None:
    text = (
        "sphere A: mass 2m, velocity u (3i + j)\nsphere B: mass 3m, velocity -u i\n"
        "A hits B: along i + j, e = 1/2\nfind impulse(B)"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert "impulse on B = 3m(√2 u + √2 u/2)((𝐢 + 𝐣)/√2)" in words
    assert "from its components" not in words


def test_an_impulse_after_a_velocity_is_a_change_of_momentum() -> None:
    text = (
        "wall W: along 3i + 4j\nsphere P: mass 2, velocity 7i + j\nP hits W: e = 3/5\n"
        "find velocity(P), impulse(P)"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert "impulse on P = 2((0.6𝐢 + 5.8𝐣) − (7𝐢 + 𝐣))" in words


def test_an_impulse_along_an_axis_rests_on_both_components() -> None:
    text = (
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass m, velocity -i + 3j\n"
        "A hits B: along i, e = 1/2\ngiven velocity(A) parallel to j\n"
        "find m, velocity(B), impulse(A)"
    )
    solution, _ = planned(text)
    assert "impulse on A = 2(2𝐣 − (3𝐢 + 2𝐣))" in to_text(explain(solution), 200)
