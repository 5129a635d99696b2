"""What lines below a mistake earn, and which letters and words keep what is asked."""

from __future__ import annotations

from functools import cache
from typing import Any

import restitution

CORNER = """
wall AB: along i
wall BC: along j
sphere P: mass 6, velocity 8i - 4j
P hits AB: e = 1/2
P hits BC: e = 3/4
part a
find velocity(P), speed(P)
part b
find total_energy_lost
"""
AT_REST = """
sphere A: mass 2, velocity 4i + 3j
sphere B: mass 4, at rest
A hits B: along i, e = 1/4
find velocity(A), velocity(B)
"""
BLOW = """
wall W: along j
sphere P: mass 4, velocity 3i + 2j
P receives 8i - 12j
part a
find velocity(P), speed(P)
P hits W: e = 1/2
part b
find velocity(P)
"""
TURNED = """
sphere A: mass m, velocity u at 45°
sphere B: mass 3m, at rest
A hits B: along i
given tan(deflection(A)) = 3
find e
"""
WALL = """
wall W: along i
sphere P: mass 2, velocity 12i - 5j
P hits W: e = 3/5
part a
find velocity(P), speed(P)
"""
SLOPE = """
wall W: along i
sphere P: velocity 10 at 45° to W
P hits W: e = 1/4
find speed(P), angle(velocity(P), W)
"""
AGAINST = """
sphere A: mass 2m, velocity 5u at alpha
sphere B: mass m, velocity -2u i
A hits B: along i, e = 1/2
given tan(alpha) = 3/4
part a
find velocity(A), velocity(B)
part b
find tan(deflection(A))
"""
TANGENT = """
sphere A: mass m, velocity u at alpha
sphere B: mass 3m, at rest
A hits B: along i
given e < 1/3
find tan(angle(velocity(A), line_of_centres))
"""


@cache
def solved(statement: str) -> restitution.Solution:
    return restitution.solve(restitution.parse(statement))


def marked(statement: str, part: str | None, *lines: str, **letters: str) -> dict[str, Any]:
    return restitution.mark(solved(statement), list(lines), part, letters).json()


def states(found: dict[str, Any]) -> list[str]:
    """The points, each with what it is for: ``B1 component that …``, and whether it is earned."""
    return [f"{x['kind']} {x['state']}" for x in found["marks"]["points"]]


def test_an_energy_lost_without_its_half_keeps_the_method() -> None:
    found = marked(CORNER, "b", "loss = 6(80) - 6(40) = 240")
    assert found["lines"][0]["mistake"]["id"] == "energy-no-half"
    assert states(found) == ["M1 earned", "A1ft lost"]
    assert marked(CORNER, "b", "loss = 3(80) - 3(40) = 120")["marks"]["earned"] == 2


def test_a_vector_with_a_component_from_whole_speeds_shows_the_other_one() -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    lines = ("10 = 2v + 4w", "w - v = 1.25", "w = 2.08, v = 0.83", "A: 0.83i + 3j, B: 2.08i")
    assert states(marked(AT_REST, None, *lines, **letters))[0] == "B1 earned"


def test_what_follows_from_an_impulse_without_its_mass_is_followed_through() -> None:
    found = marked(BLOW, "a", "v = 3i + 2j + 8i - 12j = 11i - 10j", "speed = √221 = 14.9")
    assert states(found) == ["M1 lost", "A1 lost", "A1 lost", "M1 earned", "A1ft earned"]


def test_a_law_with_letters_for_components_needs_no_condition() -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    found = marked(TURNED, None, "u cos 45 = v + 3w", "w - v = eu cos 45", **letters)
    assert found["marks"]["earned"] == 4


def test_the_speed_before_is_no_speed_after() -> None:
    lines = ("along wall 12", "speed before = √(144 + 25) = 13", "speed after = 3/5 × 13 = 7.8")
    assert marked(WALL, "a", *lines)["marks"]["earned"] == 1


def test_the_angle_that_follows_is_that_which_is_asked() -> None:
    """Upside down, e gives what is the angle to the normal in truth."""
    lines = ("10 cos 45 = 7.07", "perp after = 4 × 7.07 = 28.3", "angle = 76.0")
    found = marked(SLOPE, None, *lines)
    assert [line["verdict"] for line in found["lines"]] == ["true", "false", "follows"]
    assert states(found)[-2:] == ["M1 earned", "A1ft earned"]


def test_the_tangent_after_given_as_that_of_the_deflection_keeps_its_method() -> None:
    found = marked(AGAINST, "b", "tan d = 3", d="deflection(A)")
    assert found["lines"][0]["mistake"]["id"] == "deflection-is-after"
    assert states(found)[0] == "M1 earned"


def test_a_letter_is_no_supplement_of_another_one() -> None:
    found = marked(AGAINST, "b", "tan b = 3", "tan d = (3 + 0.75)/(1 - 2.25) = -3")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false"]


def test_a_tangent_that_follows_shows_the_component_that_stays() -> None:
    letters = {
        "v": "along(velocity(A), i)",
        "w": "along(velocity(B), i)",
        "b": "angle(velocity(A), line_of_centres)",
    }
    lines = ("u cos α = v + 3w", "w - v = eu cos α", "4v = (1 - e)u cos α")
    found = marked(TANGENT, None, *lines, "tan b = 4 tan α/(1 - e)", **letters)
    stays = [x for x in found["marks"]["points"] if x["kind"] == "B1"]
    assert [x["state"] for x in stays] == ["earned"]


FOUND = """
sphere A: mass 2, velocity 5i + 4j
sphere B: mass 3, at rest
A hits B
given velocity(A) = 2i - 2j
find velocity(B), line_of_centres
"""


def test_a_wrong_change_of_velocity_is_gone_on_with() -> None:
    lines = (
        "change in velocity of A = -3i - 2j",
        "line of centres along 3i + 2j",
        "3v = 2(3i + 2j)",
        "v = 2i + 4/3 j",
    )
    found = marked(FOUND, None, *lines, v="velocity(B)")
    assert [line["verdict"] for line in found["lines"]] == ["false", *["follows"] * 3]
    other = marked(FOUND, None, *lines[:2], "3v = 3i + 2j", v="velocity(B)")
    assert other["lines"][2]["verdict"] == "false"


def test_an_angle_that_is_worked_out_and_not_named_answers() -> None:
    statement = """wall W: along i
sphere P: mass m, velocity 8i - 6j
P hits W: e = 1/3
find angle(velocity(P), W)"""
    assert states(marked(statement, None, "tan⁻¹(2/8) = 14.0°"))[-1].endswith("earned")
    assert states(marked(statement, None, "tan⁻¹(2/8) = 14.2°"))[-1].endswith("lost")


def test_the_square_of_a_wrong_velocity_follows_though_it_cannot_be() -> None:
    statement = """wall W: along i
sphere P: mass 2, velocity 6i - 8j
P hits W
given speed(P) = 7
find e"""
    found = marked(statement, None, "after: 6e i + 8j", "36e² + 64 = 49", "36e² = -15")
    assert [line["verdict"] for line in found["lines"]] == ["false", "follows", "follows"]
    other = marked(statement, None, "after: 6e i + 8j", "36e² + 60 = 49")
    assert other["lines"][1]["verdict"] == "false"


HEAVIER = """
sphere A: mass m, velocity u at 30°
sphere B: mass 2m, at rest
A hits B: along i, e = 1/5
find speed(A), speed(B)
"""
SHOWN = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
show tan(direction(A)) = 2 tan(alpha)/(1 - e)
"""


def test_the_speed_of_a_sphere_that_was_at_rest_is_its_component() -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    lines = ("√3/2 u = v + 2w", "w - v = √3/10 u", "w = √3u/5", "v = √3u/10")
    wrong = (*lines, "speed of A = √3u/10", "speed of B = √3u/5")
    assert states(marked(HEAVIER, None, *wrong, **letters))[-1] == "A1 earned"


def test_a_result_at_the_end_of_a_chain_over_several_lines_is_printed() -> None:
    letters = {
        "v": "along(velocity(A), i)",
        "w": "along(velocity(B), i)",
        "θ": "direction(A)",
    }
    lines = ("v + w = ucosα", "w - v = eucosα", "v = 1/2(1 - e)ucosα", "tanθ = usinα/v")
    more = ("= 2usinα/((1 - e)ucosα)", "= 2tanα/(1 - e)")
    assert states(marked(SHOWN, None, *lines, *more, **letters))[-1] == "A1* earned"
    wrong = (more[0], "= 2tanα/(1 + e)")
    assert states(marked(SHOWN, None, *lines[:3], *wrong, **letters))[-1] == "A1* lost"


def test_an_impossible_cosine_follows_to_its_own_figures() -> None:
    """Of 1.06 half of the last place is nearly half a percent."""
    wall = "wall W: along i\nsphere P: mass 2, velocity 11 at 62° to W\nP hits W: e = 0.43\n"
    problem = restitution.parse(f"{wall}find speed(P), angle(velocity(P), W)")
    lines = ["speed after = 0.43 × 11 = 4.73", "4.73cosθ = 11cos62 = 5.16", "cosθ = 1.09, so no"]
    letters = {"θ": "angle(velocity(P), W)"}
    marking = restitution.mark(problem, "\n".join(lines), letters=letters)
    said = [line["verdict"] for line in marking.json()["lines"]]
    assert said == ["false", "follows", "follows"]
    lines[2] = "cosθ = 1.12, so no"
    marking = restitution.mark(problem, "\n".join(lines), letters=letters)
    assert marking.json()["lines"][2]["verdict"] == "false"


def test_a_wrong_number_goes_on_in_products_with_letters_and_beside_rounded_ones() -> None:
    """Sine and cosine exchanged lead to 12eu/13; a wrong angle stands beside a rounded speed."""
    slowed = (
        "wall W: along i\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
        "given tan(alpha) = 12/5, speed(P) = 4/5 u\nfind e"
    )
    lines = ["cosα = 12/13 and sinα = 5/13", "(12u/13)² + (5eu/13)² = (4u/5)²"]
    marking = restitution.mark(restitution.parse(slowed), "\n".join(lines)).json()
    assert [line["verdict"] for line in marking["lines"]] == ["false", "follows"]
    bend = (
        "wall AB: along i\nwall BC: along 75°\nsphere P: velocity 6 at 60° to AB\n"
        "P hits AB: e = 1/2\npart a\nfind speed(P)\nP hits BC: e = 2/3\npart b\nfind speed(P)"
    )
    letters = {"w": "speed(P, 2)", "c": "angle(velocity(P, 2), BC)"}
    lines = ["75 - 40.89 = 24.11", "w sin c = 2/3 × 3.969 sin 24.11 = 1.081"]
    marking = restitution.mark(
        restitution.parse(bend), "\n".join(lines), part="b", letters=letters
    ).json()
    assert [line["verdict"] for line in marking["lines"]] == ["false", "follows"]


# By hand: V cos 35 = 8 cos 60, so V = 4.883; V sin 35 = 8e sin 60.
OFF = """
wall W: along i
sphere P: mass 1, velocity 8 at 60° to W
P hits W
given angle(velocity(P), W) = 35°
find e, speed(P)
"""


def test_a_value_of_a_true_equation_stands_beside_that_of_a_wrong_one() -> None:
    lines = ["8cos60 = Vcos35", "8sin60 = Vsin35", "V = 12.08", "V = 4.88"]
    found = marked(OFF, None, *lines, V="speed(P)")
    assert [line["verdict"] for line in found["lines"]] == ["true", "false", "follows", "true"]


def test_a_ratio_is_no_value_before_it_is_worked_out() -> None:
    ratio = "V = 8cos60/cos35"
    purposes = {"right": "V = 4.88", "wrong": "V = 4.28", "left": "so that is V"}
    last = {
        name: marked(OFF, None, ratio, line, V="speed(P)")["marks"]["points"][-1]["state"]
        for name, line in purposes.items()
    }
    assert last == {"right": "earned", "wrong": "lost", "left": "earned"}


def test_a_decimal_of_four_figures_may_be_cut_off() -> None:
    lines = ["V = 4.882", "V = 4.883", "V = 4.881", "V = 4.87"]  # 4.8831
    assert [marked(OFF, None, x, V="speed(P)")["lines"][0]["verdict"] for x in lines] == [
        *("false", "true", "false", "false")
    ]
    assert marked(OFF, None, "e = 0.4042")["lines"][0]["verdict"] == "true"  # 0.40426


# By hand: along the line 13u × 12/13 = 12u and across it 5u.
RESOLVED = """
sphere A: mass m, velocity 13u at alpha
given tan(alpha) = 5/12
sphere B: mass 3m, at rest
A hits B: along i, e = 1/3
find speed(A), speed(B)
"""


def test_the_other_component_with_sine_for_cosine_is_no_second_mistake() -> None:
    first = "along the line of centres 13u sinα = 5u"
    found = marked(RESOLVED, None, first, "perp: 12u")
    assert [line["verdict"] for line in found["lines"]] == ["false", "follows"]
    assert found["lines"][0]["mistake"]["id"] == "sine-cosine"
    assert marked(RESOLVED, None, first, "perp: 11u")["lines"][1]["verdict"] == "false"


def test_the_way_of_a_component_may_stand_behind_it() -> None:
    lines = ["A keeps 13u sinα = 5u at right angles", "A also has 13u × 5/13 = 5u across"]
    found = marked(RESOLVED, None, *lines)
    assert [line["principle"] for line in found["lines"]] == ["unchanged"] * 2
    assert (
        marked(RESOLVED, None, "A has 13u cosα = 12u perpendicular")["lines"][0]["verdict"]
        == "false"
    )


def test_what_is_done_to_an_equation_stands_before_it() -> None:
    lines = ["Vcos35 = 4", "÷cos35: V = 4/cos35", "×e: eV = 4e/cos35 = 4.88e", "x2: 2V = 9"]
    found = marked(OFF, None, *lines, V="speed(P)")
    assert [line["verdict"] for line in found["lines"]] == ["true", "true", "true", "false"]


# By hand: v + w = 8, w - v = 8e and ½·½(64 - v² - w²) = 6, so 1 - e² = 3/4 and e = 1/2.
HALVES = """
sphere A: mass 1/2, velocity 8i + 3j
sphere B: mass 1/2, at rest
A hits B: along i
given energy_lost = 6
find e, velocity(A)
"""


def test_a_half_that_is_left_out_is_that_of_the_energy_where_the_mass_is_one_as_well() -> None:
    lines = ["v + w = 8", "w - v = 8e", "w = 4(1 + e), v = 4(1 - e)", "1/2(64 - v² - w²) = 6"]
    along = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    found = marked(HALVES, None, *lines, "e = 0.791", **along)
    points = {p["for"]: p["state"] for p in found["marks"]["points"]}
    assert points["kinetic energy"] == "earned"
    third = lines[3].replace("1/2(", "1/3(")
    points = {
        p["for"]: p for p in marked(HALVES, None, *lines[:3], third, **along)["marks"]["points"]
    }
    assert points["kinetic energy"]["why"] != "masses left out"


# By hand: after AB 5 cos 60 = 2.5 and 0.6 × 5 sin 60 = 2.60, at 46.1° to AB; 23.9° to BC.
BEND = """
wall AB: along i
wall BC: along 70°
sphere P: velocity 5 at 60° to AB
P hits AB: e = 3/5
P hits BC: e = 1/2
find speed(P)
"""


def test_the_angle_at_the_wall_before_is_known_by_its_value() -> None:
    for line in ("angle to BC = 46.1", "angle with BC is 46.1°", "hits BC at 46.1°"):
        (only,) = marked(BEND, None, line)["lines"]
        assert only["mistake"]["id"] == "second-wall-angle"


# By hand: the change is -8i + 4j; along 2i - j the approach is 12, the separation 4 + 4 = 8.
SLAB = """
wall W
sphere P: mass 2, velocity 6i
P hits W
given velocity(P) = -2i + 4j
find e
"""


def test_a_sign_in_a_scalar_product_is_no_mistake_in_restitution() -> None:
    lines = ["approach = 12", "separation = -4 + 4 = 0"]
    right = marked(SLAB, None, "approach = 12", "separation = 4 + 4 = 8", "e = 2/3")
    assert [line["verdict"] for line in right["lines"]] == ["true"] * 3
    found = marked(SLAB, None, *lines)
    assert found["lines"][1]["mistake"]["id"] != "restitution-sign"
