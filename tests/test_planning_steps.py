"""The size of the steps of planned workings, and what a teacher writes in them."""

from __future__ import annotations

from itertools import pairwise
from math import atan, cos, isclose, sin, tan

import pytest
from laws_of_steps import STEPS
from test_planning_closing import lines, moves, planned, said

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Link, Move, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles
from restitution.workings import explain
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import to_text

TARGET = "sphere A: mass m, velocity {velocity}\nsphere B: mass {mass}, at rest\n"


def kept(text: str) -> tuple[Solution, Derivation]:
    """A statement and its working, which keeps the laws of steps."""
    solution, derivation = planned(text)
    assert [each for law in STEPS.values() for each in law(solution, derivation)] == []
    return solution, derivation


def printed(text: str) -> str:
    """The working of a statement as it is printed, on long lines."""
    solution, derivation = kept(text)
    return to_text(explanation_of(derivation, solution.problem))


# --- components -------------------------------------------------------------------------------


def test_both_components_before_an_impact_stand_together_and_none_of_what_is_at_rest() -> None:
    _, derivation = kept(
        TARGET.format(velocity="7i + j", mass="3m")
        + "A hits B: along 3i + 4j, e = 1/2\nfind speed(A), speed(B)"
    )
    resolved = [e for e in said(derivation) if "velocity(A, 0)" in e.split(" = ")[0]]
    assert [each.split("(")[0] for each in resolved] == ["along", "across"]
    assert not any("velocity(B, 0)" in each.split(" = ")[0] for each in said(derivation))


def test_what_is_at_rest_is_not_resolved_in_a_direction_in_letters() -> None:
    text = printed(
        TARGET.format(velocity="4u i", mass="m")
        + "A hits B: along phi, e = 1/2\ngiven speed(A) = 2u\nfind tan(phi)"
    )
    assert "𝐮_B" not in text
    assert "and 𝐭 = −sin φ 𝐢 + cos φ 𝐣 the one perpendicular to it" in " ".join(text.split())
    assert "𝐮_A · 𝐭 = −4u sin φ" in text


def test_angles_in_degrees_stand_in_the_laws_as_they_are_given() -> None:
    _, derivation = kept(
        TARGET.format(velocity="4u at 30°", mass="2m")
        + "A hits B: along i, e = 1/3\nfind velocity(A)"
    )
    told = said(derivation)
    assert any("= 4u sin(30°) = 2u" in each for each in told)
    assert any(each.startswith("m (4u cos(30°)) =") for each in told)


def test_a_component_at_a_wall_is_by_its_angle_to_the_wall() -> None:
    _, derivation = kept(
        "wall W: along j\nsphere P: velocity 6 at 45° to W\nP hits W: e = 1/4\nfind speed(P)"
    )
    told = said(derivation)
    assert any("6cos(45°) = 3sqrt(2)" in each for each in told)
    assert any("6sin(45°)" in each for each in told)


def test_a_velocity_between_walls_is_resolved_by_the_numbers_of_the_unit_vectors() -> None:
    text = printed(
        "wall AB: along i\nwall BC: along 60°\nsphere P: velocity u at 30° to AB\n"
        "P hits AB: e = 1/3\nP hits BC: e = 1/2\nfind speed(P)"
    )
    assert "𝐧 = (√3/2)𝐢 − ½𝐣" in text
    assert "𝐯₁ · 𝐧 = (√3 u/2)(√3/2) − ½(u/6)" in text
    assert "60°" not in text


def test_components_of_a_velocity_that_is_put_together_are_read_off() -> None:
    _, derivation = kept(
        "wall U: along 45°\nwall W: along i\nsphere P: velocity u i\n"
        "P hits U: e = 1/2\nfind velocity(P)\nP hits W: e = 1/2\nfind velocity(P)"
    )
    last = [e for e in lines(derivation, "define") if e.move.record == "component"]
    assert all(each.move.event != 2 for each in last)


# --- values -----------------------------------------------------------------------------------


def test_squares_of_sine_and_cosine_are_put_into_a_speed() -> None:
    _, derivation = kept(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/2\n"
        "given angle(velocity(P), W) = 30°\nfind tan(alpha), speed(P)"
    )
    (put,) = (each for each in lines(derivation, "put") if each.move.id == "put")
    (speed,) = (e for e in lines(derivation, "define") if e.move.record == "speed")
    assert speed.number in put.premises  # no component is worked out with roots


def test_a_component_that_becomes_a_number_has_a_line() -> None:
    _, derivation = kept(
        "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W\n"
        "given impulse = 10\nfind e, speed(P)"
    )
    (put,) = (each for each in lines(derivation, "put") if each.move.id == "put")
    assert write_relation(put.relation) == "along(velocity(P, 1), j) = 1"  # type: ignore[arg-type]


def test_a_number_in_the_place_of_a_letter_is_mental_arithmetic() -> None:
    _, derivation = kept(
        "wall W: along i\nsphere P: mass 2, velocity u (3i - 4j)\nP hits W\n"
        "given impulse = 10u\nfind e, speed(P)"
    )
    assert moves(derivation).count("put") == 0


def test_a_speed_of_separation_that_is_used_is_written() -> None:
    _, derivation = kept(
        "sphere A: mass 2, velocity 3i + j\nsphere B: mass 1, velocity -2i + j\n"
        "A hits B: along i, e = 2/5\nfind distance(A, B, at 3)"
    )
    assert "w - v = 2/5 (3 + 2) = 2 [rearrange]" in said(derivation)


def test_of_a_sine_and_a_cosine_only_that_is_written_which_is_used() -> None:
    _, derivation = kept(
        "sphere A: mass m, velocity 3u i\nsphere B: mass m, at rest\nA hits B: along phi, e = 1/3\n"
        "given speed(A) = 2u\nfind phi, tan(phi), speed(B)"
    )
    (ratios,) = lines(derivation, "triangle")
    assert write_relation(ratios.relation) == "cos(phi) = sqrt(10)/4"  # type: ignore[arg-type]


def test_a_difference_of_squares_is_left_as_it_is() -> None:
    _, derivation = kept(
        "sphere A: mass 2m, velocity 3u i\nsphere B: mass 3m, velocity -2u i\nA hits B: along i\n"
        "given energy_lost = 80% of energy(0)\nfind e"
    )
    assert "1 - e^2 = 4/5" in said(derivation)


def test_a_speed_that_is_given_makes_the_energy() -> None:
    _, derivation = kept(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 1/2\n"
        "given speed(P) = 3u/4\nfind sin(alpha), energy(P)"
    )
    assert any("= 1/2 m (3u/4)^2" in each for each in said(derivation))


def test_a_velocity_after_a_blow_has_a_line_once_its_letters_are_known() -> None:
    _, derivation = kept(
        "wall W: along i\nsphere P: mass m, at rest\nP receives H at 45° to W\nP hits W: e = 1/2\n"
        "given speed(P) = u\nfind H, energy(P, 1)"
    )
    (put,) = lines(derivation, "put")
    assert said(derivation)[put.number - 1].startswith("velocity(P, 1) = ")


# --- equations --------------------------------------------------------------------------------


def test_a_quadratic_is_in_standard_form_then_in_factors() -> None:
    _, derivation = kept(
        "sphere A: mass m, velocity u at 30°\nsphere B: mass 3m, velocity u at 30° from -i\n"
        "A hits B: along i\ngiven energy(A) = energy(B)\nfind e"
    )
    *_, standard, factors, roots, last = said(derivation)
    assert standard.endswith(" = 0")
    assert factors.startswith("(3e - 1)")
    assert " or " in roots
    assert last == "e = 1/3"


@pytest.mark.parametrize(("mass", "speed"), [("2m", "u"), ("3m", "2u")])
def test_equal_energies_give_a_quadratic_in_standard_form(mass: str, speed: str) -> None:
    _, derivation = kept(
        "sphere A: mass m, velocity u at 30°\n"
        f"sphere B: mass {mass}, velocity {speed} at 30° from -i\n"
        "A hits B: along i\ngiven energy(A) = energy(B)\nfind e"
    )
    (roots,) = lines(derivation, "roots")
    above = derivation.line(roots.premises[0])  # type: ignore[arg-type]
    assert above is not None
    assert isinstance(above.relation, Relation)
    assert above.relation.only[-1].right == read_relation("e = 0", {}).only[0].right


def test_common_factors_and_brackets_go_before_the_unknown_is_alone() -> None:
    _, derivation = kept(
        "sphere A: mass 3, velocity 5i + 2j\nsphere B: mass 1, velocity -3i + 4j\n"
        "A hits B: along i\n"
        "given along(velocity(B), i) = 2 along(velocity(A), i) + 1\nfind e"
    )
    (first, second) = lines(derivation, "rearrange")[-2:]
    assert "(" not in said(derivation)[first.number - 3].replace("(2)", "")
    assert second.premises == (first.number,)


def test_one_step_stays_one_step() -> None:
    _, derivation = kept(
        "sphere A: mass 2, velocity 6i\nsphere B: mass 3, velocity -2i\nA hits B: along i\n"
        "given velocity(A) = 0\nfind e"
    )
    assert moves(derivation).count("rearrange") == 2


def test_a_sum_of_roots_is_divided_by_in_the_open() -> None:
    _, derivation = kept(
        "sphere A: mass m, velocity 2u at 30°\nsphere B: mass 2m, velocity u at 120°\n"
        "A hits B: along i\ngiven deflection(B) = 60°\nfind e"
    )
    (links,) = derivation.lines[-1].relation.options  # type: ignore[union-attr]
    assert [each.by for each in links] == [None, "rearrange", "rearrange"]


def test_an_angle_in_many_terms_is_collected() -> None:
    _, derivation = kept(
        "wall AB: along i\nwall BC: along 135°\nsphere P: mass m, velocity u at alpha to AB\n"
        "P hits AB: e = 1/3\nP hits BC: e = 1/2\ngiven velocity(P) parallel to j\nfind tan(alpha)"
    )
    first, last = said(derivation)[-2:]
    assert first == "cos(alpha) = sin(alpha)"
    assert last.startswith("tan(alpha) = ")


def test_two_equations_lose_their_common_factors_first() -> None:
    _, derivation = kept(
        "wall W: along i\nsphere S: mass m, velocity u at alpha to W\nS hits W\n"
        "given deflection(S) = 90°, energy_lost = 1/4 energy(0)\nfind e, alpha"
    )
    told = said(derivation)
    first = next(
        n for n, each in enumerate(told) if each.startswith("cos^2(alpha) = e sin^2(alpha)")
    )
    assert not any("u^2" in each for each in told[first:])


def test_a_sum_of_squares_says_its_identity() -> None:
    text = printed(
        TARGET.format(velocity="u at alpha", mass="2m") + "A hits B: along i, e = 1\nfind speed(A)"
    )
    assert "as sin²α + cos²α = 1" in text


def test_an_irrational_quadratic_is_solved_by_the_formula() -> None:
    text = printed(
        "sphere A: mass m, velocity u at 30°\nsphere B: mass 2m, velocity u at 30° from -i\n"
        "A hits B: along i\ngiven energy(A) = energy(B)\nfind e"
    )
    assert "By the quadratic formula" in text


# --- vectors ----------------------------------------------------------------------------------


def test_the_second_velocity_comes_by_momentum_as_vectors() -> None:
    _, derivation = kept(
        "sphere A: mass 2, velocity 4i + j\nsphere B: mass 3, velocity -i + 2j\n"
        "A hits B: along i + j, e = 1/3\nfind velocity(A), velocity(B)"
    )
    laws = [each.move.record for each in lines(derivation, "law")]
    assert laws[-2:] == ["changed-velocity", "momentum-vector"]
    assert "unchanged" not in laws


def test_velocities_by_angles_are_put_together_of_components() -> None:
    _, derivation = kept(
        "sphere A: mass 2m, velocity u at 75°\nsphere B: mass m, velocity u at 150°\n"
        "A hits B: along 45°, e = 1/3\nfind velocity(A), velocity(B)"
    )
    assert "momentum-vector" not in {each.move.record for each in lines(derivation, "law")}


# --- the laws can fail ------------------------------------------------------------------------


def _of(*texts: tuple[str, Move, tuple[int | str, ...]]) -> Derivation:
    made = tuple(
        Line(n, "1", move, premises, read_relation(text, {"A": "sphere", "P": "sphere"}))
        for n, (text, move, premises) in enumerate(texts, 1)
    )
    return Derivation((), made, ())


@pytest.mark.parametrize(
    ("law", "made"),
    [
        (
            "quadratics in standard form",
            _of(
                ("2e^2 + e = 1", Move("put"), ()),
                ("e = 1/2 or e = -1", Move("roots"), (1,)),
            ),
        ),
        (
            "nothing of what is at rest",
            _of(("along(velocity(A, 0), i) = 0", Move("define", "component", 1, ("A",)), ())),
        ),
        (
            "both components together",
            _of(
                (
                    "along(velocity(A, 0), line_of_centres(1)) = 3",
                    Move("define", "component", 1, ("A",)),
                    (),
                ),
                ("e = 1/2", Move("fact"), ()),
                (
                    "across(velocity(A, 0), line_of_centres(1)) = 4",
                    Move("define", "component", 1, ("A",)),
                    (),
                ),
            ),
        ),
        (
            "values have lines",
            _of(
                ("along(velocity(P, 1), i) = u cos(alpha)", Move("law"), ()),
                ("cos(alpha) = 3/5", Move("triangle"), ()),
                ("speed(P, 1) = 3u/5", Move("define", "speed", 1, ("P",)), (1, 2)),
            ),
        ),
        (
            "no long division",
            _of(
                ("(1 + sqrt(3)) e = 1", Move("put"), ()),
                ("e = (sqrt(3) - 1)/2", Move("rearrange"), (1,)),
            ),
        ),
    ],
)
def test_a_law_of_steps_can_fail(law: str, made: Derivation) -> None:
    assert STEPS[law](None, made)  # type: ignore[arg-type]
    for one, other in pairwise(made.lines):
        assert one.number < other.number
    assert all(isinstance(link, Link) for e in made.lines for link in e.relation.options[0])  # type: ignore[union-attr]


def test_a_velocity_beside_one_that_is_given_comes_by_momentum_before_any_component() -> None:
    _, derivation = kept(
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 1, velocity -i + 4j\n"
        "A hits B: along 2i - j\ngiven velocity(B) = 3i + 2j\nfind velocity(A), e"
    )
    assert derivation.lines[0].move.record == "momentum-vector"
    laws = [each.move.record for each in lines(derivation, "law")]
    assert laws == ["momentum-vector", "restitution"]


# --- where values come from ---------------------------------------------------------------------


def test_a_component_of_a_speed_and_an_angle_stands_as_a_product_first() -> None:
    text = printed(
        "wall W: along j\nsphere P: mass 2, velocity 10 at alpha to W\n"
        "given cos(alpha) = 3/5\nP hits W: e = 1/4\nfind speed(P)"
    )
    assert "stays 10 cos α = 6 m s⁻¹" in " ".join(text.split())
    assert "= ¼ × 10 × ⅘ = 2 m s⁻¹" in text


def test_an_angle_is_the_inverse_of_the_ratio_that_stands() -> None:
    _, derivation = kept(
        TARGET.format(velocity="8 at theta", mass="m")
        + "A hits B: along i, e = 1\ngiven velocity(B) = 2i\nfind theta, velocity(A)"
    )
    told = said(derivation)
    assert "cos(theta) = 1/4" in told
    assert "theta = arccos(1/4)" in told


@pytest.mark.parametrize(
    ("velocity", "quotient"),
    [("2i - j", "t = 5/1 = 5 s"), ("u at -30°", "t = 5/(u sin 30°) = 10/u")],
)
def test_a_time_is_seen_to_be_a_quotient(velocity: str, quotient: str) -> None:
    text = printed(
        f"wall W: along i, through (0, 0)\nsphere P: at (0, 5), velocity {velocity}\n"
        "P hits W: e = 1/2\nfind time(1), position(P)"
    )
    assert quotient in text


def test_what_a_square_is_divided_by_stands_beside_it_before_it_is_shown() -> None:
    problem = parse(
        "wall W: along j\nsphere P: mass m, velocity u at theta to W\nP hits W\n"
        "given energy_lost = 1/3 energy(0)\nshow sin^2(theta) = 1/(3(1 - e^2))"
    )
    derivation = plan(solve(problem))
    assert not follow(derivation, Oracle(roles(problem)))
    assert said(derivation)[-2:] == [
        "(1 - e^2) sin^2(theta) = 1/3",
        "sin^2(theta) = 1/(3(1 - e^2))",
    ]


@pytest.mark.parametrize(
    ("asked", "link"),
    [
        ("impulse", "= m(u + 2√10 u sin α) = m(u + 2u) = 3mu"),
        ("energy_lost", "= ½m((2√10 u sin α)² − u²) = ½m((2u)² − u²) = 3mu²/2"),
    ],
)
def test_a_component_before_a_wall_of_which_no_line_has_the_value_stands_as_the_data_have_it(
    asked: str, link: str
) -> None:
    text = f"""
wall W
sphere P: mass m, velocity 2 sqrt(10) u at alpha to W
P hits W: e = 1/2
given tan(alpha) = 1/3
find {asked}
"""
    assert link in " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())


def test_who_rests_stays_where_it_touched_the_other() -> None:
    text = """
sphere A: mass 1 kg, radius 1/4 m, at (0, 0), velocity 3i
sphere B: mass 2 kg, radius 1/4 m, at (3, 0), at rest
wall W: along j through (7, 0)
A hits B: e = 1/2
B hits W: e = 2/3
find distance(A, B)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "A is at rest, so it stays where it touched B:" in working
    assert "= 3𝐢 − ½𝐢 = (5/2)𝐢 m" in working


def test_the_square_of_a_cosine_by_a_tangent_with_roots_is_by_one_and_its_square() -> None:
    text = """
sphere P: mass m, velocity u at alpha to W
wall W
P hits W: e = 1/3
given deflection(P) = 60°
find tan(alpha), speed(P)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    link = "= 3/(20 − 4√13) = 3(5 + √13)/((20 − 4√13)(5 + √13)) = (15 + 3√13)/48"
    first = "cos²α = 1/(1 + ((√39 − 2√3)/3)²) = 1/(1 + (17 − 4√13)/3)"
    assert f"{first} {link} = (5 + √13)/16 sin²α = (11 − √13)/16" in working


def test_a_tangent_of_a_sum_with_roots_below_is_multiplied_through_first() -> None:
    text = """
sphere A: mass m, velocity u at 60°
sphere B: mass m, velocity u at 150°
A hits B: along i, e = e
find tan(deflection(A)) in terms of e
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    first = "tan δ = (√3 + (3 − √3)/(2 − √3 + e))/(3(√3 − 1)/(2 − √3 + e) − 1)"
    assert f"{first} = (√3 + √3 e)/(4√3 − 5 − e) = √3(1 + e)/(4√3 − 5 − e)" in working


def test_a_speed_of_separation_with_degrees_is_put_in_as_the_law_has_it() -> None:
    text = """
sphere A: mass m, velocity u at 25°
sphere B: mass 2m, velocity 0.8u at 140°
A hits B: along i, e = 0.65
find velocity(A), velocity(B)
"""
    working = to_text(explain(solve(parse(text)), check=True), 200)
    assert "+ 0.65(u cos 25° + 0.8u cos 40°)" in working


def test_what_a_component_put_in_comes_to_is_seen_before_a_loss_by_products() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass k m, velocity v at 180° - beta
A hits B: along i, e = e
find energy_lost
"""
    working = to_text(explain(solve(parse(text)), check=True), 300)
    assert "½(1 − e)km(x + v cos β)(u cos α + v cos β)   (6)" in working
    assert "From (3):\n    x + v cos β = (1 + e)(u cos α + v cos β)/(1 + k)\n" in working
    assert "kinetic energy lost = km(1 − e²)(u cos α + v cos β)²/(2(1 + k))" in working


def test_of_a_loss_by_products_each_law_says_what_a_whole_factor_is() -> None:
    text = """
sphere A: mass M, velocity a i + b j
sphere B: mass m, velocity -c i + d j
A hits B: along i, e = 1/2
show energy_lost = 3 m M (a + c)^2/(8(m + M))
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "From (1): M(a − v) = m(w + c) Substituting in (4):" in working
    assert "lost = ½m(w + c)(a + v − (w − c)) (5) From (2): a + v − (w − c) = ½(a + c)" in working


def test_why_a_place_is_on_an_axis_is_said_where_no_line_has_the_other_coordinate() -> None:
    text = """
sphere A: mass 1 kg, at (-4, -3), velocity 4i + 3j
sphere B: mass 3 kg, at (0, 0), at rest
wall W: along j, through (6, 0)
A hits B: along i, e = 2/3
find velocity(B), velocity(A)
B reaches W
find time(2) - time(1), distance(A, B), position(B)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "B moves parallel to the x-axis:" in working
    assert "position of B when B reaches W = 6𝐢 m" in working


def test_roots_of_roots_of_which_one_is_a_multiple_of_the_other_are_compared() -> None:
    text = """
sphere A: mass 2, velocity 5 at 30°
sphere B: mass 1, velocity -2i
A hits B: along i, e = e
given energy_lost = 9
find e, speed(A)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "e² ≈ 0.3262 e ≈ 0.571, as e ≥ 0" in working
    assert "v ≈ 1.015 m s⁻¹" in working
    assert "does not follow" not in working


def test_a_greatest_difference_of_angles_of_whole_degrees_is_by_its_tangent_that_stands() -> None:
    text = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/3
let beta = angle(velocity(P), W)
part a
show tan(alpha - beta) = 2 tan(alpha)/(3 + tan^2(alpha))
part b
find maximum of alpha - beta over alpha
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    last = working.split("(b)")[1]
    assert last.startswith(" Let δ = α − β. From (1): tan δ = 2 tan α/(3 + tan²α)")
    assert "tan δ ≤ √3/3 δ ≤ 30°, as −90° < δ < 90°" in last
    assert "greatest value of δ = 30°, when √3 − tan α = 0, so α = 60°" in last


def test_a_velocity_at_right_angles_to_a_wall_is_shown_by_the_component_that_is_0() -> None:
    text = """
wall BC: along i
wall AB: along 60°
sphere P: velocity -u i
P hits AB: e = 1/3
show velocity(P) perpendicular to BC
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    line = "component of 𝐯_P along 𝐢 = (√3 u/6)(√3/2) − ½(u/2) = 0"
    assert f"{line} So 𝐯_P is perpendicular to BC (as required)" in working


def test_a_velocity_at_right_angles_to_a_slanting_line_is_shown_by_its_components() -> None:
    text = """
wall AB: along i + 2j
sphere P: velocity 10i
P hits AB: e = 1/2
show velocity(P) perpendicular to 3i + j
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "component of 𝐯_P along 𝐢 = −2√5(2√5/5) + 2√5(√5/5) = −2 m s⁻¹" in working
    assert "𝐯_P · (3𝐢 + 𝐣) = −3 × 2 + 6 = 0" in working


def test_an_angle_in_letters_is_shown_by_its_cosine() -> None:
    text = """
wall W1: along i
wall W2: along phi
sphere P: velocity u at alpha to W1
P hits W1: e = 1
P hits W2: e = 1
show angle(velocity(P), velocity(P, 0)) = 2 phi
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    first = "As sin²α + cos²α = 1: cos β = cos(α − 2φ) cos α − sin(2φ − α) sin α"
    last = "By the formulae for a difference of angles: cos β = cos 2φ DM1 β = 2φ"
    assert f"{first} DM1 {last}" in working
    assert "does not follow" not in working


def test_each_factor_of_a_value_below_its_bound_is_named() -> None:
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i, e = e
show energy_lost < 3/4 energy(0)
show speed(B) < u/2
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "< ¾ × total kinetic energy before the impact" in working
    assert "as 1 − e² ≤ 1 and cos²α < 1 (as required)" in working
    assert "speed of B < u/2, as ½(1 + e) ≤ 1 and cos α < 1 (as required)" in working


def test_a_cubic_stands_as_the_product_of_its_factors() -> None:
    text = """
wall W: along i
sphere P: velocity u at 45° to W
P hits W: e = e
given 2e^3 + 3e^2 + 1 = 4e
find e
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "2e³ + 3e² − 4e + 1 = 0 (2e − 1)(e² + 2e − 1) = 0 e = ½ or" in working


def test_an_angle_that_is_given_by_its_tangent_is_added_to_one_of_the_data() -> None:
    text = """
sphere A: mass 3m, velocity u at 45°
sphere B: mass m, at rest
A hits B: along i
given angle(velocity(A), velocity(A, 0)) = arctan(1/3)
find e, energy_lost/energy(0)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "tan(45° + arctan(1/3)) = (1 + ⅓)/(1 − ⅓) = 2" in working
    assert "2 = (√2 u/2)/(√2(3 − e)u/8) 3 − e = 2 e = 1" in working
    assert "Dividing (6) by (5): fraction lost = 0" in working


def test_a_ratio_of_an_angle_that_is_known_in_degrees_is_written() -> None:
    text = """
sphere A: mass 2m, velocity u at theta
sphere B: mass 3m, velocity 2u j
A hits B: along i, e = 2/3
given deflection(A) = 45°
find tan(theta)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "tan θ = tan 45° = 1 A1" in working
    assert "not written out" not in working
    assert "does not follow" not in working


def test_a_component_is_shown_by_the_letter_that_is_given_for_a_speed() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given speed(P) = v
unknown v
let beta = angle(velocity(P), W)
show u cos(alpha) = v cos(beta)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "(speed of P) cos β = u cos α" in working
    assert "u cos α = v cos β (as required)" in working
    assert "not written out" not in working


def test_a_line_of_centres_along_a_velocity_after_a_wall_is_worked_out() -> None:
    text = """
wall W: along i
sphere A: mass m, velocity u at 60° to W
sphere B: mass 3m, at rest
A hits W: e = 1/3
A hits B: along velocity(A, 1), e = 1/2
find speed(B)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "along 𝐯_A: the line of centres is parallel to √3 𝐢 + 𝐣" in working
    assert "m(√3 u/3) = mv + 3mw" in working
    assert "speed of B = √3 u/8 ≈ 0.217u" in working
    assert "not written out" not in working


def test_a_place_of_a_sphere_that_was_struck_at_rest_is_by_the_line_of_centres() -> None:
    text = """
sphere P: mass 2m, at (0, 0), velocity 3u i
sphere Q: mass m, at (0, 0), at rest
wall W: along j, through (a, 0)
P hits Q: along i + 2j, e = 1/3
Q hits W: e = 1/2
find position(Q, 2)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "component of 𝐯_Q along 𝐢 = (8√5 u/15)(√5/5) = 8u/15" in working
    assert "= a((16u/15)/(8u/15)) = 2a" in working
    assert "position of Q at the second impact = (a, 2a)" in working


@pytest.mark.parametrize(
    ("given", "lines"),
    [
        ("tan(angle(velocity(P), W1)) = 1/2", "e³ = ½ e = ∛(1/2) ≈ 0.794"),
        ("tan(angle(velocity(P), W1)) = 1/8", "e³ = ⅛ e = ½"),
        ("energy = 55% of energy(0)", "e⁶ = 1/10 e = (1/10)^(1/6) ≈ 0.681, as e ≥ 0"),
    ],
)
def test_a_power_that_is_a_number_has_the_root_of_its_degree(given: str, lines: str) -> None:
    text = f"""
wall W1: along i
wall W2: along i
sphere P: velocity u at 45° to W1
P hits W1: e = e
P hits W2: e = e
P hits W1: e = e
given {given}
find e
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert lines in working
    assert "does not follow" not in working


def test_what_is_shown_with_a_sum_of_angles_has_it_written_out_first() -> None:
    text = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
let beta = angle(velocity(P), W)
show energy_lost = 1/2 m u^2 sin(alpha + beta) sin(alpha - beta)/cos^2(beta)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    first = "mu²(sin²α cos²β − cos²α sin²β)/(2 cos²β)"
    product = "(sin α cos β + cos α sin β)(sin α cos β − cos α sin β)"
    assert f"Substituting in (1): kinetic energy lost = {first} = ½mu²{product}/cos²β" in working
    assert "By the formulae for a sum of angles: kinetic energy lost = ½mu² sin(α + β)" in working
    assert "does not follow" not in working


def test_a_greatest_angle_that_is_shown_ends_in_the_printed_form() -> None:
    text = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = e
given 0 < e < 1
show maximum of alpha - angle(velocity(P), W) over alpha = arctan((1 - e^2)/(2(1 + e) sqrt(e)))
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "tan δ ≤ (1 − e²)/(2(1 + e)√e)" in working
    assert "greatest value of δ = arctan((1 − e²)/(2(1 + e)√e))" in working
    assert "does not follow" not in working


@pytest.mark.parametrize(
    ("velocity", "lines"),
    [
        ("2i + j", "(2t − 1)² + t² = 5² M1 5t² − 4t − 24 = 0 By the quadratic formula:"),
        ("3i + 4j", "(3t − 1)² + (4t)² = 5² M1 25t² − 6t − 24 = 0"),
    ],
)
def test_a_time_to_a_circle_has_its_quadratic_in_standard_form(velocity: str, lines: str) -> None:
    text = f"""
wall C: circle centre (0, 0) radius 5
sphere P: at (-1, 0), velocity {velocity}, mass 1
P hits C: e = 1/3
find time(1)
"""
    assert lines in " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())


def test_a_time_of_touching_has_its_square_alone_where_one_coordinate_stays() -> None:
    text = """
sphere A: mass 1, at (0, 0), velocity 3i, radius 1
sphere B: mass 2, at (10, 1), velocity -i, radius 1
A hits B: e = 1/2
find time(1)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "(4t − 10)² + 1² = 2² M1 (4t − 10)² = 3 t = (10 − √3)/4 s or (10 + √3)/4 s" in working


def test_a_letter_that_a_tangent_tells_less_a_number_goes_before_a_sum_is_written_out() -> None:
    """tan β = 2 tan α/(1 − e), and the speed of B is ½(1 + e)u cos α."""
    alpha, e = 0.5, 0.3
    beta = atan(2 * tan(alpha) / (1 - e))
    assert isclose((1 + e) * cos(alpha) / 2, sin(beta - alpha) / sin(beta))
    text = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
let beta = angle(velocity(A), i)
show speed(B) = u sin(beta - alpha)/sin(beta)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "e = 1 − (2 tan α)/tan β Substituting in (3): speed of B = " in working
    assert "u(cos α sin β − sin α cos β)/sin β By the formulae for a sum of angles" in working
    assert "does not follow" not in working


def test_a_sine_by_a_tangent_that_is_a_sum_of_roots_is_by_the_square_of_the_cosine() -> None:
    text = """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset d, e = 1/2
given deflection(A) = 30°
find d
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "= (17 + √33)/24 sin φ = √((7 − √33)/24) = (√33 − 3)/12" in working
    assert "If tan φ = (√11 + 3√3)/8: cos²φ" in working


def test_a_ratio_of_masses_without_letters_is_put_in() -> None:
    text = """
sphere A: velocity 3i + j
sphere B: velocity -2i
A hits B: along i
given velocity(A) = -i + j, velocity(B) = i
find mass(A)/mass(B)
"""
    working = explain(solve(parse(text)), check=True)
    assert not working.warnings
    assert "(mass of A)/(mass of B) = ¾" in str(working)


def test_an_answer_that_only_a_calculator_knows_has_the_figures_that_go_on() -> None:
    text = """
wall AB: along i
wall BC: along 65°
sphere P: velocity 10 at 40° to AB
P hits AB: e = 0.7
part a
find speed(P), angle(velocity(P), AB)
P hits BC: e = 0.5
part b
find speed(P)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "≈ 8.884 ≈ 8.88 m s⁻¹" in working
    assert "≈ 30.43° ≈ 30.4°" in working
    assert "8.884 sin 34.57°" in working
    assert "≈ 7.74 m s⁻¹" in working


def test_squares_of_ratios_serve_each_of_two_solutions() -> None:
    """No cosine with a root in a root is put in; the speed by its components stands above both."""
    target = TARGET.format(velocity="u at alpha", mass="m")
    given = "A hits B: along i, e = 1/{}\ngiven tan(deflection(A)) = {}\nfind alpha, {}\n"
    _, speed = planned(target + given.format(2, "1/2", "speed(A)"))
    working = said(speed)
    assert working.count("speed(A, 1) = sqrt((1/4 u cos(alpha))^2 + (u sin(alpha))^2)") == 1
    assert "= 2(5 - sqrt(5))/15" in "\n".join(working)
    assert "cos(alpha) = 4" not in "\n".join(working)
    # Of a loss of energy the square of the cosine is enough.
    _, loss = planned(target + given.format(3, "2/5", "energy_lost"))
    assert "sin^2(alpha)" not in "\n".join(said(loss))


def test_a_line_of_centres_along_a_velocity_of_the_data_has_its_direction() -> None:
    text = """
sphere P: mass m, velocity 2u i - u j
sphere Q: mass 3m, at rest
P hits Q: along velocity(P), e = 1/3
find velocity(P), velocity(Q)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "the unit vector along the line of centres" in working
    assert "𝐧 = (2𝐢 − 𝐣)/√5" in working
    assert "√5 mu = mv + 3mw" in working
    assert "𝐯_Q = (√5 u/3)((2𝐢 − 𝐣)/√5)" in working
    assert "= (2u/3)𝐢 − (u/3)𝐣" in working


@pytest.mark.parametrize(
    "line",
    ["along velocity(P), e = 1/3", "e = 1/3\ngiven velocity(P, 0) parallel to line_of_centres"],
)
def test_spheres_that_meet_along_a_path_at_an_angle_have_their_speeds_along_it(line: str) -> None:
    text = f"""
sphere P: mass m, velocity u at theta
sphere Q: mass 3m, at rest
P hits Q: {line}
find speed(Q)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "mu = mv + 3mw" in working
    assert "w − v = ⅓u" in working
    assert "speed of Q = u/3" in working
    assert "not written out" not in working


def test_a_line_of_centres_along_a_velocity_of_letters_of_either_sign_is_worked_out() -> None:
    text = """
wall W: along j
sphere P: mass m, velocity 2u i + 3u j
sphere Q: mass 2m, at rest
P hits W: e = 1/2
P hits Q: along velocity(P), e = 1/2
find velocity(Q)
"""
    working = " ".join(to_text(explain(solve(parse(text)), check=True), 200).split())
    assert "the line of centres is parallel to −𝐢 + 3𝐣" in working
    assert "√10 mu = mv + 2mw" in working
    assert "𝐯_Q = (√10 u/2)((−𝐢 + 3𝐣)/√10)" in working
    assert "= −(u/2)𝐢 + (3u/2)𝐣" in working
