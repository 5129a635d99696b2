"""The shorter of two ways: a difference where it is enough, nothing worked out that stands."""

from __future__ import annotations

from dataclasses import replace

import pytest
from test_planning_closing import lines, planned, said

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation
from restitution.explaining.lines.notation import read_relation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

PAIR = "sphere A: mass {a}, velocity {u}\nsphere B: mass {b}, velocity {x}\nA hits B: along i"


def laws(derivation: Derivation) -> list[str | None]:
    """The principles of a working, in the order of its lines."""
    return [each.move.record for each in lines(derivation, "law")]


@pytest.mark.parametrize("size", ["velocity(A) - velocity(B)", "velocity(B) - velocity(A)"])
def test_a_relative_speed_comes_of_restitution_alone(size: str) -> None:
    text = PAIR.format(a="3", u="4i + 3j", b="2", x="-2i - j")
    _, derivation = planned(f"{text}\ngiven abs({size}) = 5\nfind e")
    assert laws(derivation) == ["unchanged", "unchanged", "restitution"]
    assert "sqrt((6e)^2 + (3 + 1)^2) = 5" in said(derivation)
    assert said(derivation)[-1] == "e = 1/2"


def test_restitution_is_written_once_for_a_distance_and_a_velocity() -> None:
    text = PAIR.format(a="2", u="4i + j", b="1", x="-2i + j")
    _, derivation = planned(f"{text}, e = 1/2\nfind distance(A, B, at 2), velocity(B)")
    assert laws(derivation).count("restitution") == 1
    assert any("= 2*3 = 6" in each for each in said(derivation))


def test_velocities_in_one_direction_are_tied_before_the_laws_are_solved() -> None:
    text = PAIR.format(a="1", u="8i + j", b="1", x="-2i + 2j")
    _, derivation = planned(f"{text}\ngiven velocity(A) parallel to velocity(B)\nfind e")
    assert not lines(derivation, "combine")
    assert said(derivation)[-5:] == [
        "8 - 2 = v + 2v",
        "v = 2",
        "w = 4",
        "4 - 2 = e (8 + 2)",
        "e = 1/5",
    ]


def test_an_impulse_that_is_given_acts_on_both_spheres() -> None:
    _, derivation = planned(
        "sphere A: mass 2, velocity p i - 3j\nsphere B: mass 1, velocity q i + j\nA hits B\n"
        "given impulse(A) = -4i + 2j, velocity(A) parallel to j, e = 1/2\n"
        "find p, q, velocity(B)"
    )
    assert "momentum" not in laws(derivation)
    assert "opposite-impulses" in laws(derivation)
    assert "p - 2 = 0" in said(derivation)


OPEN_LINE = (
    "sphere A: mass 2, velocity 5i + 3j\nsphere B: mass 3, velocity -2i + j\nA hits B\n"
    "given velocity(A) = i + j\n"
)


@pytest.mark.parametrize("items", ["impulse(B)", "impulse(B), velocity(B)"])
def test_an_impulse_is_opposite_to_the_change_of_momentum_of_the_other(items: str) -> None:
    solution, derivation = planned(f"{OPEN_LINE}find {items}")
    assert said(derivation)[:2] == [
        "impulse(B, 1) = -2(i + j - (5i + 3j))",
        "impulse(B, 1) = 8i + 4j",
    ]
    assert laws(derivation) == ["opposite-impulses", "impulse-vector"][: len(items.split())]
    text = to_text(explain(solution))
    assert "opposite to that on A, which is the change of momentum of A" in text
    marks = [mark for each in awarded(derivation, "fm1").lines[:2] for mark in each.marks]
    assert [each.kind for each in marks] == ["M", "A"]


def test_the_second_of_two_impulses_is_opposite_to_the_first() -> None:
    _, derivation = planned(f"{OPEN_LINE}find impulse(A), impulse(B), velocity(B)")
    assert laws(derivation) == ["impulse-vector", "opposite-impulses", "impulse-vector"]
    assert "8i + 4j = 3(velocity(B, 1) - (-2i + j))" in said(derivation)


def test_the_size_of_an_impulse_needs_no_line_that_is_open() -> None:
    _, derivation = planned(f"{OPEN_LINE}find impulse")
    assert laws(derivation) == ["impulse-vector"]
    assert [each.move.record for each in lines(derivation, "define")] == ["size"]
    assert said(derivation)[-1].startswith("impulse(1) = sqrt(8^2 + 4^2)")


def test_a_line_of_centres_is_that_of_an_impulse_that_stands() -> None:
    _, derivation = planned(f"{OPEN_LINE}part a\nfind impulse(B)\npart b\nfind line_of_centres")
    assert laws(derivation) == ["opposite-impulses", "across-the-impulse"]
    assert "line_of_centres(1) parallel to 8i + 4j" in said(derivation)


def test_the_energy_of_a_sphere_changes_by_one_component() -> None:
    text = PAIR.format(a="2", u="3i + 5j", b="1", x="-2i + j")
    _, derivation = planned(f"{text}, e = 1/2\nfind energy(B) - energy(B, 0)")
    assert said(derivation)[-1].startswith("energy(B, 1) - energy(B, 0) = 1/2 (3^2 - 2^2)")
    assert derivation.lines[-1].move.record == "energy-change"
    assert "unchanged" not in laws(derivation)


def test_a_mass_comes_of_the_impulse_that_is_given() -> None:
    text = PAIR.format(a="M", u="5i + 2j", b="3", x="-i + j")
    _, derivation = planned(f"{text}, e = 1/2\ngiven impulse = 9\nfind M")
    assert laws(derivation) == ["impulse", "restitution", "impulse"]


def test_an_impulse_that_is_found_is_one_equation() -> None:
    _, derivation = planned(
        "sphere P: mass 2, velocity 3i - j\nP receives p i + q j\n"
        "given velocity(P) = i + 4j\nfind p, q"
    )
    assert said(derivation)[:2] == [
        "p i + q j = 2(i + 4j - (3i - j))",
        "p i + q j = -4i + 10j",
    ]


def test_the_other_component_is_put_in_where_it_is_short() -> None:
    text = PAIR.format(a="m", u="6u i", b="2m", x="0")
    _, derivation = planned(f"{text}, e = 1/2\nfind velocity(A), velocity(B)")
    assert len(lines(derivation, "combine")) == 1


def test_a_component_by_its_angle_is_put_into_both_laws() -> None:
    _, derivation = planned(
        "sphere A: mass 4m, velocity u at 30°\nsphere B: mass 3m, at rest\nA hits B: along i\n"
        "given angle(velocity(A), line_of_centres) = 60°\nfind e, energy_lost"
    )
    assert not lines(derivation, "combine")
    assert "v = sqrt(3) u/6" in said(derivation)


def test_a_tangent_of_two_angles_is_one_quotient_first() -> None:
    _, derivation = planned(
        "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\n"
        "given tan(alpha) = 1/2\nA hits B: along i, e = 1/3\nfind tan(deflection(A))"
    )
    assert any("= 8k/(15 - k)" in each for each in said(derivation))


def test_what_the_data_give_is_not_followed_through() -> None:
    solution, derivation = planned(
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "part a\ngiven tan(alpha) = 3/4, e = 1/2\nfind energy_lost/energy(0)\n"
        "part b\ngiven alpha = 60°, energy_lost = 1/4 energy(0)\nfind e"
    )
    marked = awarded(derivation)
    assert not any(mark.ft for mark in marked.lines[-1].marks)
    assert "as e ≥ 0" in to_text(explanation_of(derivation, solution.problem))


def test_a_time_that_is_a_multiple_of_the_one_before_tells_the_time_between() -> None:
    solution, derivation = planned(
        "wall W: along i, through (0, 0)\npoint Q: (9, 2)\n"
        "sphere P: at (0, 4), velocity V at alpha to W\nP hits W\nP reaches Q\n"
        "given time(2) = 5 time(1)\nfind e"
    )
    told = said(derivation)
    assert "time(2) - time(1) = 4time(1)" in told
    assert not any(each.startswith("time(2) =") for each in told)
    assert "Since t₂ = 5t₁:" in to_text(explain(solution))


def test_a_time_that_a_fact_gave_above_is_what_the_time_between_is_of() -> None:
    """The fact is used once: not again for the time between."""
    solution, derivation = planned(
        "wall L: along j, through (0, 0)\nwall R: along j, through (9d, 0)\n"
        "sphere P: mass m, at (5d, 0), velocity u i\nP hits R: e = e\nP hits L: e = e\n"
        "find time(1), time(2)\ngiven time(2) = 5 time(1)\nfind e"
    )
    told = said(derivation)
    assert "9d/(e u) = 20d/u - 4d/u" in told
    assert not any("time(2) - time(1) = 4" in each for each in told)
    assert to_text(explain(solution, check=True)).count("Since t₂ = 5t₁:") == 1


def test_equal_components_cancel_where_the_speeds_are_equal() -> None:
    _, derivation = planned(
        "sphere A: mass 2m, velocity u at theta\nsphere B: mass m, velocity w at phi from -i\n"
        "A hits B: along i, e = 0\ngiven speed(A) = speed(B)\nfind w/u in terms of theta, phi"
    )
    assert "momentum" not in laws(derivation)
    assert said(derivation)[-2:] == ["w sin(phi) = u sin(theta)", "w/u = sin(theta)/sin(phi)"]


@pytest.mark.parametrize(
    ("asked", "fraction"),
    [
        ("energy_lost/energy(0)", "((3u/5)² − (2u/5)²)/u² = ⅕"),
        ("energy_lost/energy(0) as a percentage", "((3u/5)² − (2u/5)²)/u² = ⅕ = 20%"),
        ("speed(P), energy_lost/energy(0)", "(u² − (2√5 u/5)²)/u² = ⅕"),
    ],
)
def test_of_one_sphere_the_fraction_lost_is_by_squares_of_speeds(asked: str, fraction: str) -> None:
    text = (
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 2/3\n"
        f"given tan(alpha) = 3/4\nfind {asked}"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert f"lost = {fraction}" in words
    assert "½m" not in words


def test_a_fraction_of_a_loss_that_is_asked_is_by_the_loss() -> None:
    text = (
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W: e = 2/3\n"
        "given tan(alpha) = 3/4\nfind energy_lost, energy_lost/energy(0)"
    )
    solution, _ = planned(text)
    assert "= (mu²/10)/(½mu²) = ⅕" in to_text(explain(solution), 200)


def test_a_given_share_that_a_wall_takes_is_by_the_squares_of_the_component() -> None:
    text = (
        "wall W: along j\nsphere A: mass 2m, velocity u at theta\nA hits W: e = 3/5\n"
        "given total_energy_lost = 1/3 energy(0)\nfind theta"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert "(u cos θ)² − (⅗u cos θ)² = ⅓u²" in words
    assert "½" not in words


def test_a_given_tangent_stays_on_its_side() -> None:
    text = (
        PAIR.format(a="m", u="u at alpha", b="m", x="0 i")
        + ", e = 1/2\ngiven deflection(A) = arctan(3/5)\nfind tan(alpha)"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert "(4 tan α − tan α)/(1 + 4 tan²α) = ⅗" in words
    assert "⅗ = " not in words


def test_the_tangent_of_the_double_angle_stays_on_its_side() -> None:
    text = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
        "A hits B: along i, e = 1/3\ngiven angle(velocity(A), i) = 2alpha\nfind alpha"
    )
    solution, _ = planned(text)
    assert "2 tan α/(1 − tan²α) = 3 tan α" in to_text(explain(solution), 200)


@pytest.mark.parametrize(
    ("velocity", "early"),
    [
        ("u at arccos(4/5)", "arccos(4/5)"),
        ("u at alpha\ngiven tan(alpha) = 3/4", "arctan(3/4)"),
    ],
)
def test_a_deflection_after_a_direction_is_their_difference(velocity: str, early: str) -> None:
    first, *given = velocity.split("\n")
    text = "\n".join(
        [
            f"sphere A: mass m, velocity {first}",
            "sphere B: mass 3m, at rest",
            *given,
            "A hits B: along i, e = 7/8",
            "find direction(A), deflection(A)",
        ]
    )
    problem = parse(text)
    solution = solve(problem)
    assert not follow(plan(solution), Oracle(roles(problem)))
    words = to_text(explain(solution), 200)
    assert "A turns through the difference of its directions before and after:" in words
    assert f"δ = 180° − arctan(24/13) − {early}" in words


def test_a_root_is_rejected_before_the_other_is_put_in_order() -> None:
    text = (
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/3\n"
        "given deflection(P) = 60°\nfind tan(alpha)"
    )
    solution, derivation = planned(text)
    assert said(derivation)[-2] == "tan(alpha) = (-2 + sqrt(13))/sqrt(3)"
    words = to_text(explain(solution), 200)
    assert "tan α = (−2 + √13)/√3, as α is acute" in words
    assert "= (√39 − 2√3)/3 ≈ 0.927" in words
    assert "−(√39 + 2√3)/3" not in words


def test_an_energy_is_by_the_square_of_a_speed_that_stands_as_a_root() -> None:
    text = (
        "wall W: along i\nwall X: along j\nsphere P: mass m, velocity u at alpha to W\n"
        "P hits W: e = 1/2\nP hits X: e = 1/3\nfind speed(P), energy(P)"
    )
    solution, _ = planned(text)
    words = " ".join(to_text(explain(solution), 200).split())
    assert "kinetic energy of P = ½m(u²(4 + 5 sin²α)/36)" in words
    assert ")²/6)²" not in words


def test_the_difference_from_a_greatest_value_says_where_that_is_reached() -> None:
    text = (
        "sphere A: mass m, velocity u i, radius a\nsphere B: mass m, at rest, radius a\n"
        "A hits B: offset d, e = 1/2\nfind maximum of deflection(A) over d"
    )
    words = " ".join(to_text(explain(solve(parse(text))), 200).split())
    assert "when 1 − 2 tan φ = 0, so tan φ = ½, sin φ = √5/5 and d = 2√5 a/5" in words


@pytest.mark.parametrize("asked", ["range of speed(A)", "maximum of speed(A) over e"])
def test_a_square_that_stands_is_not_expanded_for_its_ends(asked: str) -> None:
    text = PAIR.format(a="m", u="u at 60°", b="2m", x="0 i") + f"\nfind {asked}"
    problem = parse(text)
    solution = solve(problem)
    assert not follow(plan(solution), Oracle(roles(problem)))
    words = " ".join(to_text(explain(solution), 200).split())
    assert "(speed of A)² = ((1 − 2e)u/6)² + (√3 u/2)² = (u²/36)(1 − 2e)² + 3u²/4" in words
    assert "0 ≤ (1 − 2e)² ≤ 1, as 0 ≤ e ≤ 1" in words


@pytest.mark.parametrize("items", ["find time(3)\n{given}\nfind e", "{given}\nfind e, time(3)"])
def test_a_time_that_is_given_by_an_earlier_one_does_not_wait_for_e(items: str) -> None:
    text = (
        "wall W1: along j, through (0, 0)\nwall W2: along j, through (L, 0)\n"
        "sphere P: at (0, 0), velocity V i\nP hits W2\nP hits W1\nP hits W2\n"
        + items.format(given="given time(3) - time(1) = 6 L/V")
    )
    problem = parse(text)
    solution = solve(problem)
    assert not follow(plan(solution), Oracle(roles(problem)))
    words = " ".join(to_text(explain(solution), 200).split())
    assert "t₃ = L/V + 6L/V = 7L/V" in words
    assert "L(1 + e + e²)/(e²V)" not in words


def test_a_speed_of_one_component_at_an_acute_angle_is_that_component() -> None:
    text = (
        "sphere A, B: mass m, radius r\nsphere A: velocity u i\nsphere B: at rest\n"
        "A hits B: offset d, e = 1/2\ngiven speed(B) = 3/5 u\nfind d"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert "w = 3u/5" in words
    assert "(3u/5)²" not in words
    assert "cos φ = ⅘" in words


@pytest.mark.parametrize("angle", ["deflection(A)", "angle(velocity(A), i)"])
def test_a_right_angle_to_the_line_of_centres_leaves_the_first_angle(angle: str) -> None:
    text = (
        "sphere A: mass m, velocity u i, radius r\nsphere B: mass m, at rest, radius r\n"
        f"A hits B: offset d, e = 1\ngiven {angle} = 60°\nfind d, speed(A)"
    )
    solution, derivation = planned(text)
    assert "phi = 90° - 60° = 30° [rearrange]" in said(derivation)
    assert "tan 60°" not in to_text(explain(solution), 200)


def test_the_energy_before_stands_before_what_is_lost_of_it() -> None:
    text = PAIR.format(a="m", u="u at alpha", b="m", x="0 i") + (
        ", e = 1/2\nfind energy_lost/energy(0) in terms of alpha"
    )
    solution, _ = planned(text)
    words = to_text(explain(solution), 200)
    assert words.index("before the impact = ½mu²") < words.index("kinetic energy lost = ½m(")


CORNER_OF_120 = (
    "wall OA: along i\nwall OB: along 120°\nsphere P: mass m, velocity u at 60° to OA\n"
    "P hits OA: e = 1/3\n"
)


@pytest.mark.parametrize(
    "claim", ["velocity(P) perpendicular to OB", "angle(velocity(P), OB) = 90°"]
)
def test_a_right_angle_to_a_wall_that_is_shown_has_its_scalar_product(claim: str) -> None:
    problem = parse(f"{CORNER_OF_120}show {claim}")
    solution = solve(problem)
    derivation = plan(solution)
    assert not follow(derivation, Oracle(roles(problem)))
    assert said(derivation)[-2] == (
        "dot(velocity(P, 1), -i + sqrt(3) j) = -u/2 + sqrt(3) (sqrt(3) u/6) = 0 [rearrange]"
    )
    assert set(derivation.lines[-1].premises) == {"wall OB", derivation.lines[-2].number}
    assert "Scalar product with a vector along OB:" in to_text(explain(solution))


def test_a_scalar_product_shows_a_right_angle_to_its_own_direction_alone() -> None:
    problem = parse(f"{CORNER_OF_120}show velocity(P) perpendicular to OB")
    derivation = plan(solve(problem))
    *above, product, end = derivation.lines
    names = {"P": "sphere", "OA": "wall", "OB": "wall"}
    other = read_relation(
        "dot(velocity(P, 1), 2i - 2sqrt(3) j) = u - 2sqrt(3) (sqrt(3) u/6) = 0 [rearrange]", names
    )
    backwards = (*above, replace(product, relation=other), end)
    assert not follow(replace(derivation, lines=backwards), Oracle(roles(problem)))
    along = replace(end, relation=read_relation("velocity(P, 1) perpendicular to OA", names))
    along = replace(along, premises=("wall OA", product.number))
    complaints = follow(replace(derivation, lines=(*above, product, along)), Oracle(roles(problem)))
    assert along.number in [each.line for each in complaints]


def test_a_way_over_several_impacts_is_one_product_where_the_component_stays() -> None:
    text = (
        "wall W1: along i, through (0, 0)\nwall W2: along i, through (0, 3)\n"
        "sphere P: mass 0.1, at (0, 1), velocity 3i - 4j\nP hits W1: e = 1/2\n"
        "P hits W2: e = 1/2\nP hits W1: e = 1/2\n{}"
        "find distance(position(P, 1), position(P, 3))"
    )
    solution, derivation = planned(text.format("find time(1), time(3)\n"))
    way = "along(position(P, 3), i) - along(position(P, 1), i) = "
    assert f"{way}3(19/4 - 1/4) = 27/2 [rearrange]" in said(derivation)
    printed = to_text(explain(solution))
    assert "differ in their x-coordinates alone" in printed
    assert "Pythagoras" not in printed
    _, derivation = planned(text.format(""))
    assert f"{way}3(3/2 + 3) = 27/2 [rearrange]" in said(derivation)


@pytest.mark.parametrize(
    ("velocities", "vectors"),
    [
        (("u(3i + 4j)", "u(-2i + j)"), "−𝐢 + 2𝐣 and 𝐢 + 2𝐣"),
        (("u(3i - 4j)", "u(-2i - j)"), "−𝐢 − 2𝐣 and 𝐢 − 2𝐣"),
    ],
)
def test_an_angle_between_multiples_of_vectors_is_between_these(
    velocities: tuple[str, str], vectors: str
) -> None:
    one, other = velocities
    problem = parse(
        f"sphere A: mass m, velocity {one}\nsphere B: mass 2m, velocity {other}\n"
        "A hits B: along i, e = 1/2\nfind velocity(A), velocity(B)\n"
        "find angle(velocity(A), velocity(B))"
    )
    solution = solve(problem)
    derivation = plan(solution)
    assert not follow(derivation, Oracle(roles(problem)))
    records = {each.move.record for each in lines(derivation, "define")}
    assert records.isdisjoint({"product", "speed"}) and "scalar-angle" in records
    text = " ".join(to_text(explain(solution)).split())
    assert f"by the scalar product of {vectors}, which are in their directions" in text


def test_an_angle_by_a_product_that_stands_is_not_said_to_be_between_others() -> None:
    solution, _ = planned(
        "sphere A: mass 1, velocity 2i + 3j\nsphere B: mass 2, velocity -i + j\n"
        "A hits B: along i, e = 1/2\nfind dot(velocity(A), velocity(B))\n"
        "find speed(A), speed(B), angle(velocity(A), velocity(B))"
    )
    assert "in their directions" not in to_text(explain(solution))


@pytest.mark.parametrize(
    ("line", "value"),
    [("i", "2i + j"), ("j", "5i + 3/2 j"), ("i + j", "-9/4 i + 19/4 j")],
)
def test_a_relative_velocity_brings_in_no_mass(line: str, value: str) -> None:
    text = f"sphere A: velocity 3i + j\nsphere B: velocity {{x}}\nA hits B: along {line}, e = 1/2\n"
    velocity = {"i": "-i + 2j", "j": "8i - 2j", "i + j": "-3i + 2j"}[line]
    problem = parse(text.format(x=velocity) + "find velocity(B) - velocity(A)\n")
    derivation = plan(solve(problem))
    assert set(laws(derivation)) <= {"unchanged", "restitution"}
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert said(derivation)[-1] == f"velocity(B, 1) - velocity(A, 1) = {value}"


def test_a_velocity_that_is_given_is_put_in_as_it_is() -> None:
    text = "sphere A: mass 1, velocity 3i + 2j\nsphere B: mass 2, at rest\nA hits B\n"
    _, derivation = planned(f"{text}given velocity(A) = -i\nfind velocity(B) - velocity(A)")
    assert not any(each.startswith("velocity(A, 1) = ") for each in said(derivation))


def test_a_fraction_needs_no_mass_though_an_energy_is_asked_that_cannot_be_found() -> None:
    text = "wall W: along i\nsphere P: velocity 2i - 6j\nP hits W: e = 1/3\n"
    derivation = plan(solve(parse(f"{text}find energy_lost/energy(0), energy_lost\n")))
    (fraction,) = (each for each in derivation.lines if each.move.record == "energy-ratio")
    assert "mass" not in str(fraction)


def test_a_direction_of_the_data_is_their_letter() -> None:
    text = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i, e = 0"
    )
    _, derivation = planned(f"{text}\ngiven speed(B) = u/4\nfind direction(A, 0)")
    assert "direction(A, 0) = alpha" in said(derivation)
    assert not any("tan(theta)" in each for each in said(derivation))


def test_a_direction_along_the_line_of_centres_is_the_angle_to_it_that_is_named() -> None:
    text = PAIR.format(a="2m", u="u at alpha", b="m", x="0")
    _, derivation = planned(
        f"{text}, e = 1/2\ngiven tan(deflection(A)) = 1/3, tan(alpha) < 3/4\n"
        "find tan(direction(A)) in terms of alpha"
    )
    assert said(derivation)[-2:] == ["theta = beta", "tan(theta) = 2(1/2) = 1 [rearrange]"]


def test_the_angle_between_two_spheres_takes_all_values_that_its_tangent_takes() -> None:
    text = PAIR.format(a="m", u="u at alpha", b="2m", x="0")
    problem = parse(f"{text}, e = 1/3\nfind range of angle(velocity(A), velocity(B))\n")
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert said(derivation)[-3:] == [
        "tan(beta) = u sin(alpha)/(1/9 u cos(alpha)) = 9tan(alpha) [rearrange]",
        "tan(beta) > 0",
        "0° < angle(velocity(A, 1), velocity(B, 1)) < 90°",
    ]


def test_a_path_to_a_wall_at_right_angles_makes_what_is_left_of_90_degrees() -> None:
    text = (
        "wall W: along i\nwall X: along j\nsphere P: velocity u at 30° to W\n"
        "P hits W: e = 1/2\nP hits X: e = 1/3\nfind deflection(P, 1) + deflection(P, 2)\n"
    )
    problem = parse(text)
    derivation = plan(solve(problem))
    assert follow(derivation, Oracle(roles(problem))) == ()
    assert "angle(velocity(P, 1), X) = 90° - beta" in said(derivation)
    assert said(derivation)[-2].endswith("= 120° + arctan(2sqrt(3)/3)")


def test_who_moves_at_right_angles_to_a_line_of_centres_tells_its_angle() -> None:
    text = (
        "sphere A: mass m, velocity u i, radius r\nsphere B: mass m, at rest, radius r\n"
        "A hits B: offset 1, e = 1\ngiven direction(A) = -60°\nfind r"
    )
    _, derivation = planned(text)
    assert "phi - 90° = -60°" in said(derivation)
    assert not any("tan" in each for each in said(derivation))


@pytest.mark.parametrize(
    ("given", "item", "line"),
    [
        ("speed(P) = 4.5", "speed(P)", "speed of P = 4.5 m s⁻¹"),
        ("deflection(P) = 60°", "deflection(P)", "angle of deflection of P = 60°"),
        ("energy_lost = 2", "energy_lost", "kinetic energy lost = 2 J"),
        ("deflection(P) = 10°", "deflection(P)", "angle of deflection of P = 10°"),
    ],
)
def test_a_number_that_is_given_is_read_off(given: str, item: str, line: str) -> None:
    text = (
        f"wall W: along i\nsphere P: mass 2, velocity 4i - 3j\nP hits W\ngiven {given}\nfind {item}"
    )
    explanation = explain(solve(parse(text)), check=True)
    shown = " ".join(to_text(explanation, 200).split())
    assert explanation.followed
    assert f"{line} B1" in shown
    assert "Newton" not in shown
