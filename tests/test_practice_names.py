"""Mistakes whose names a line shows by itself: masses left out, 1/e, walls left before, shares."""

from __future__ import annotations

import pytest
from marked import solution_of

import restitution


def names(statement: str, *lines: str, **letters: str) -> list[str | None]:
    """The name of the mistake in each line, None where there is none."""
    marking = restitution.mark(solution_of(statement), "\n".join(lines), letters=letters).json()
    return [(line["mistake"] or {}).get("id") for line in marking["lines"]]


BLOW = """sphere P: mass 4, velocity 3i + j
P receives 8i - 12j
find velocity(P)"""
HIT = """sphere A: mass 2, velocity 4i + 3j
sphere B: mass 5, velocity -i + 3j
A hits B
given velocity(A) = -i - 2j
find velocity(B)"""
PUSHED = """wall W: along j
sphere P: mass 0.25, velocity -8i + 5j
P hits W
given impulse = 3
find e"""


@pytest.mark.parametrize(
    ("statement", "line"),
    [
        (BLOW, "v = 3i + j + 8i - 12j = 11i - 11j"),
        (BLOW, "8i - 12j = v - (3i + j)"),
        (HIT, "4i + 3j - i + 3j = -i - 2j + v_B"),
        (HIT, "(4, 3) + (-1, 3) = (-1, -2) + v_B"),
        (PUSHED, "3 = 8 + 8e"),
    ],
)
def test_a_mass_that_is_left_out_of_an_impulse_or_of_momentum_as_vectors(
    statement: str, line: str
) -> None:
    assert names(statement, line)[0] == "mass-omitted"


SOUGHT = """wall W: along i
sphere P: mass 2, velocity 7i - 5j
P hits W
given velocity(P) = 7i + 3j
find e"""
TURNED = """wall W: along j
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 4/3, deflection(P) = 90°
find e"""


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (SOUGHT, ["perp before = 5, perp after = 3", "5 = 3e"]),
        (SOUGHT, ["5 = e × 3"]),
        (SOUGHT, ["3e = 5"]),
        (TURNED, ["β = 90 - α", "tan β = 3/4", "e tan β = tan α"]),
        (TURNED, ["e × 3/4 = 4/3"]),
    ],
)
def test_an_equation_that_holds_for_one_over_e(statement: str, lines: list[str]) -> None:
    assert names(statement, *lines)[-1] == "restitution-inverted"


CORNER = """wall AB: along i
wall BC: along 60°
sphere P: velocity 6 at 60° to AB
part a
P hits AB: e = 1/3
find speed(P), angle(velocity(P), AB)
part b
P hits BC: e = 1/2
find speed(P)"""


@pytest.mark.parametrize("line", ["angle to BC = 60", "angle at BC = 60°"])
def test_the_angle_before_the_first_wall_at_the_second(line: str) -> None:
    solution = solution_of(CORNER)
    marking = restitution.mark(solution, f"{line}\nv cos b = 2√3 cos 60", part="b").json()
    assert (marking["lines"][0]["mistake"] or {}).get("id") == "second-wall-angle"


SHARE = """wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
given tan(alpha) = 4/3, energy_lost = 2/5 energy(0)
find e"""
HALF = """wall W: along i
sphere P: mass m, velocity u at 45° to W
P hits W
given energy_lost = 1/3 energy(0)
find e"""


@pytest.mark.parametrize(
    ("statement", "lines"),
    [
        (SHARE, ["perp after = 4eu/5", "1 - e² = 2/5"]),
        (SHARE, ["perp after: e u sin α", "2/5 = 1 - e^2"]),
        (HALF, ["after: e u sin 45", "1 - e² = 1/3"]),
    ],
)
def test_a_share_that_is_given_taken_of_the_energy_into_a_wall(
    statement: str, lines: list[str]
) -> None:
    assert names(statement, *lines) == [None, "energy-fraction-of-line"]


LOSS = """wall W: along i
sphere P: mass 2, velocity 5i - 9j
P hits W: e = 1/3
find energy_lost"""


@pytest.mark.parametrize(
    "line",
    ["KE lost = ½ × 2 × (9 + 3)²", "loss = 0.5(2)(9 + 3)^2 = 144", "KE lost = ½(2)(12)² = 144"],
)
def test_an_energy_of_a_difference_has_its_half(line: str) -> None:
    assert names(LOSS, line) == ["energy-of-difference"]
    assert names(LOSS, "KE lost = 2(9² - 3²) = 144") == ["energy-no-half"]


REBOUND = """wall W: along i
sphere P: mass 3, velocity 4i - 6j
P hits W: e = 1/2
find velocity(P), impulse"""


@pytest.mark.parametrize(
    ("lines", "name"),
    [
        (
            ["perp after = 6 ÷ 1/2 = 12", "v = 4i + 12j", "I = 3(12 + 6) = 54"],
            "restitution-inverted",
        ),
        (["v = 4i + 6j", "I = 3(6 + 6) = 36"], "restitution-omitted"),
    ],
)
def test_a_coefficient_of_one_or_more_is_no_datum_misread(lines: list[str], name: str) -> None:
    assert names(REBOUND, *lines) == [name, *[None] * (len(lines) - 1)]


MEASURED = """wall W: along i
sphere P: mass 2, velocity 12 at 50° to W
P hits W
given angle(velocity(P), W) = 35°
find e"""
LEFT = """sphere A: mass 3, velocity 2i + 5j
sphere B: mass 2, velocity i - 3j
A hits B: along j
given velocity(B) = i + 6j
find velocity(A)"""
EQUAL = """sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
given tan(alpha) = 3/4
find deflection(A)"""
PARTED = """sphere A: mass 3, velocity 4i + 2j
sphere B: mass 1, velocity -2i
A hits B: along i, e = 1/2
find energy_lost"""


def test_a_component_kept_by_sines_stands_for_the_one_along_a_wall() -> None:
    kept, slowed = "v sin 35 = 12 sin 50", "v cos 35 = 12e cos 50"
    for lines in ([kept, slowed], [f"12 sin 50 = {kept[:8]}", "v = 16.0", slowed]):
        assert names(MEASURED, *lines)[0] == "sine-cosine"
    assert names(MEASURED, slowed, kept)[0] == "restitution-parallel"


def test_terms_that_are_all_momenta_have_a_mistake_of_momentum() -> None:
    for line in ("15 + 6 = 3v + 12", "3v + 12 = 3(5) + 2(3)"):
        marking = restitution.mark(
            solution_of(LEFT), [line, "v = 3"], letters={"v": "along(velocity(A), j)"}
        ).json()
        assert marking["lines"][0]["mistake"]["id"] == "momentum-sign"


def test_two_angles_added_up_are_a_deflection_by_their_sum() -> None:
    letters = {"b": "angle(velocity(A), i)", "δ": "deflection(A)"}
    marking = restitution.mark(solution_of(EQUAL), ["tan b = 3", "δ = b + α"], letters=letters)
    mistake = marking.lines[1].mistake
    assert mistake is not None
    assert mistake.id == "deflection-difference"


def test_squares_of_differences_are_no_energy_of_one_sphere() -> None:
    # A goes from 4 to 7/4 along the line of centres, B from -2 to 19/4.
    line = "KE lost = ½(3)(4 - 1.75)² + ½(1)(4.75 + 2)²"
    assert names(PARTED, line) == ["energy-of-difference"]


SHARED = """wall W: along i
sphere P: mass m, velocity 4u i - 2u j
P hits W: e = 1/2
find energy_lost/energy(0)"""
UPRIGHT = """sphere A: mass 2, velocity 4i + j
sphere B: mass 1, velocity -2i - 3j
A hits B: along i, e = 1/2
find energy_lost"""
ONWARD = """sphere A: mass 2, velocity 6i + 3j
sphere B: mass 2, at rest
wall W: along j
A hits B: along i, e = 1/3
B hits W: e = 1/2
find total_energy_lost"""
POLAR = """wall W: along i
sphere P: mass 2, velocity 10 at 30° to W
P hits W: e = 1/5
find speed(P)"""


def test_a_fraction_is_the_one_that_is_asked() -> None:
    # What is lost is 3/2, of 10; along the normal 2 are there before, and 85 % are kept.
    lost = "KE lost = ½m(4u² - u²) = 3mu²/2"
    assert names(SHARED, lost, "fraction = (3mu²/2)/(2mu²) = 3/4")[1] == "energy-fraction-of-line"
    for line in ("fraction kept = 17/20", "fraction of KE remaining is 17/20"):
        assert names(SHARED, lost, line, "fraction = 3/20") == [None, None, None]


@pytest.mark.parametrize(("early", "late"), [("before", "after"), ("at the start", "at end")])
def test_energies_before_and_after_are_of_the_same_components(early: str, late: str) -> None:
    # A goes from 4 to 1 along i, B from -2 to 4.
    whole = f"{early} ½(2)(17) + ½(13) = 23.5"
    lines = [whole, f"{late} ½(2)(1²) + ½(4²) = 9", "loss = 14.5 J"]
    assert names(UPRIGHT, *lines) == [None, "energy-component-missing", None]
    along = [f"{early} ½(2)(16) + ½(4) = 18", lines[1], "loss = 9 J"]
    assert names(UPRIGHT, *along) == [None, None, None]


def test_an_energy_after_a_wall_has_the_component_across_as_well() -> None:
    # A comes to 2 along i, B to 4 and from the wall to -2.
    lines = ["at start: ½(2)(45) = 45", "at end: ½(2)(2²) + ½(2)(2²) = 8", "KE lost = 37 J"]
    assert names(ONWARD, *lines) == [None, "energy-component-missing", None]


def test_a_speed_by_its_components_leaves_out_the_coefficient() -> None:
    for line in ("speed = √((10cos30)² + (10sin30)²) = 10", "V = √(8.66² + 5²) = 10"):
        assert names(POLAR, line) == ["restitution-omitted"]
    assert names(POLAR, "speed before = √(8.66² + 5²) = 10") == [None]


def test_a_deflection_may_be_a_letter_of_the_question() -> None:
    marking = restitution.mark(solution_of(EQUAL), "deflection of A = α").json()
    assert marking["lines"][0]["verdict"] == "false"
    assert marking["lines"][0]["mistake"]["id"] is None


def test_the_share_that_is_left_for_the_one_lost_is_no_misconception() -> None:
    assert names(SHARED, "fraction = 17/20")[0] in (None, "arithmetic")


FOUND = """sphere A: mass m, velocity 3u i + 2u j
sphere B: mass k m, velocity -u i
A hits B: along i, e = 1/2
given along(velocity(A), i) = -u
find k"""
STRUCK = """sphere A: mass 2m, velocity 5u i
sphere B: mass m, at rest
A hits B: along 4i + 3j, e = 1/2
find energy_lost"""


def test_a_slip_below_a_true_equation_is_no_mistake_in_a_law() -> None:
    lines = ["(3 - 3k)/(1 + k) = -1", "3 - 3k = -1 + k", "k = 1"]
    assert names(FOUND, *lines) == [None, "sign", None]


def test_an_energy_in_letters_without_a_name_is_the_one_that_is_asked() -> None:
    # A goes from 5u to √13 u.
    assert names(STRUCK, "½(2m)(5u - 3.61u)² = 1.93mu²") == ["energy-of-difference"]
    true = "½(2m)(25u²) - ½(2m)(13u²) - ½m(16u²) = 4mu²"
    assert names(STRUCK, true) == [None]
    assert names(STRUCK, "½(2m)(25u²) - ½(2m)(13u²) = 12mu²") == [None]


def test_a_root_of_two_squares_is_of_no_whole_speed() -> None:
    statement = "wall X: along i\nwall Y: along j\nsphere P: mass m, velocity 4u i - 3u j\n"
    statement += "P hits X: e = 2/3\nP hits Y: e = 1/2\nfind speed(P)"
    assert names(statement, "speed = √(64/9 + 4)u = 10u/3")[0] in (None, "algebra", "misread")


TURNED = """wall W: along i
sphere P: velocity 3i - 4j
P hits W: e = 1/2
find deflection(P)"""


@pytest.mark.parametrize(
    ("above", "line"),
    [
        ("tan δ = (4/3 + 2/3)/(1 - 8/9) = 18", "δ = tan^-1(-18)"),
        ("cos δ = (9 - 8)/(5√13) = 0.0555", "δ = cos^-1(-0.0555) = 93.2°"),
    ],
)
def test_a_sign_left_out_of_an_inverse_ratio_is_a_slip(above: str, line: str) -> None:
    assert names(TURNED, above, line) == [None, "sign"]


def test_a_square_left_out_of_the_tangent_of_a_deflection_is_no_angle_after() -> None:
    # The value is tan α by chance.
    statement = "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
    statement += "A hits B: along i, e = 1/2\ngiven tan(alpha) = 1/2\nfind tan(deflection(A))"
    line = "tan δ = (3 × ½)/(1 + 4 × ½) = 0.5"
    marking = restitution.mark(solution_of(statement), line, letters={"δ": "deflection(A)"}).json()
    assert marking["lines"][0]["verdict"] == "false"
    assert marking["lines"][0]["mistake"]["id"] == "algebra"


def test_a_sign_in_the_momentum_of_a_later_impact_has_its_name() -> None:
    statement = "sphere A: mass 3, velocity 4i\nsphere B: mass 2, velocity 2i\nwall W: along j\n"
    statement += "A hits B: along i, e = 1\nB hits W: e = 1/2\nA hits B: e = 1/4\n"
    statement += "find velocity(A), velocity(B)"
    letters = {"x": "along(velocity(A, 3), i)", "y": "along(velocity(B, 3), i)"}
    lines = ["after the wall B has 1/2 x 4.4 = 2.2", "7.2 + 4.4 = 3x + 2y"]
    assert names(statement, *lines, **letters) == [None, "momentum-sign"]


def test_a_blow_given_the_sum_of_two_velocities_has_a_wrong_sign() -> None:
    statement = "sphere P: mass 3, velocity 2i - j\nP receives 9i + 6j\nfind speed(P)"
    assert names(statement, "3(v + 2i - j) = 9i + 6j", v="velocity(P, 1)") == ["sign"]
    assert names(statement, "3(v - 2i + j) = 9i + 6j", v="velocity(P, 1)") == [None]


def test_a_coefficient_whose_square_alone_is_left_out_has_a_name() -> None:
    statement = "wall W: along i\nsphere P: mass 2, velocity 4i - 5j\nP hits W\n"
    statement += "given speed(P) = 5\nfind e"
    assert names(statement, "16 + 25e = 25") == ["square-not-taken"]


def test_a_datum_without_its_decimal_point_is_copied_wrongly() -> None:
    statement = "wall W: along i\nsphere P: mass 0.4, velocity 3i - 5j\nP hits W: e = 0.6\n"
    statement += "find impulse"
    marking = restitution.mark(restitution.parse(statement), "I = 4(5 + 3) = 32")
    assert marking.json()["lines"][0]["mistake"]["id"] == "copied"
    assert [x.state for x in marking.marks.points][-2:] == ["earned", "lost"]


def test_restitution_left_out_at_a_later_wall_has_its_name() -> None:
    statement = "wall W: along i, through (0, 0)\nwall V: along i, through (0, a)\n"
    statement += "sphere P: mass m, velocity u at 45° to W\nP hits W: e = e\nP hits V: e = e\n"
    statement += "given angle(velocity(P), V) = 30°\nfind e"
    letters = {"w": "speed(P, 2)", "v": "speed(P, 1)", "b": "angle(velocity(P, 1), W)"}
    lines = ["v sin b = eu/√2", "w cos 30 = u/√2", "w sin 30 = eu/√2"]
    assert names(statement, *lines, **letters) == [None, None, "restitution-omitted"]


# 2a + 3b = 4 and b - a = 3: a = -1 and b = 2.
_STONES = """sphere A: mass 2, velocity 8i + 3j
sphere B: mass 3, velocity -4i + j
A hits B: along i, e = 1/4
find velocity(A), velocity(B)"""
# Along i + j: A from 12/√2 to -4/√2, B from -4/√2 to 4/√2; A has 8/√2 across it.
_SEEN = """sphere A: mass 2, velocity 10i + 2j
sphere B: mass 4, velocity -4i
A hits B
given velocity(A) = 2i - 6j
find e"""


@pytest.mark.parametrize(
    ("statement", "line", "principle"),
    [
        (_STONES, "4 = 2a + 3b", "momentum"),
        (_STONES, "b - a = 3", "restitution"),
        (_SEEN, "4√2 = e × 8√2", "restitution"),
        (_SEEN, "8/√2 = e × 16/√2", "restitution"),
    ],
)
def test_a_law_is_not_another_one_by_its_numbers(statement: str, line: str, principle: str) -> None:
    letters = {"a": "along(velocity(A), i)", "b": "along(velocity(B), i)"}
    marking = restitution.mark(solution_of(statement), line, letters=letters).json()
    assert marking["lines"][0]["principle"] == principle
    inverted = restitution.mark(solution_of(_STONES), "4 = 2a + 3b\n¼(b - a) = 12", letters=letters)
    assert inverted.mistakes == ("restitution-inverted",)


def test_a_sign_that_mends_a_quotient_is_one_of_the_law() -> None:
    lines = ["(10,2).(1,1) = 12, (2,-6).(1,1) = -4", "(-4,0).(1,1) = -4, (0,4).(1,1) = 4"]
    assert names(_SEEN, *lines, "e = (4 + 4)/(12 - 4) = 1")[-1] == "restitution-sign"
