"""Lines as students type them, of which a careless reading would accuse true ones."""

from __future__ import annotations

import re
from fractions import Fraction
from functools import cache

import pytest

import restitution
from restitution.expression.tree import Apply, Binary, Letter, Number
from restitution.practice.reading.working import read_working
from restitution.solving.equations.solution import Solution

TURNED = """sphere A: mass 1, velocity 5i + j
sphere B: mass 2, velocity -i - 2j
A hits B: along i + j, e = 1/3
find velocity(A), velocity(B)"""
LETTERS = """sphere A: mass m, velocity u at alpha
sphere B: mass M, at rest
A hits B: along i, e = 1
find speed(A), velocity(B)"""
LEVEL = """sphere A: mass 2, velocity 4i + 3j
sphere B: mass 1, velocity -i + 2j
A hits B: along i, e = 1/2
find velocity(A), velocity(B)"""
PLACED = """wall C: circle centre (0, 0) radius 5
sphere P: at (-3, -4), velocity 2 at 45°, mass 1
P hits C: e = 1/3
find position(P), velocity(P)"""
KICKED = """sphere A: mass 1/2, velocity 4i
sphere B: mass 1, at rest
part a
A receives -i + 3/2 j
find velocity(A), deflection(A)
part b
A hits B: along 2i + 3j, e = 1/3
find velocity(A)"""
DIRECT = """sphere P: mass 1, velocity 4u i
sphere Q: mass 2, velocity u i
P hits Q: along i
given speed(P) = u/2
find e"""


@cache
def solution_of(statement: str) -> Solution:
    return restitution.solve(restitution.parse(statement))


def points(statement: str, *lines: str) -> list[tuple[str, str, int | None]]:
    marking = restitution.mark(solution_of(statement), "\n".join(lines)).json()
    return [(each["for"], each["state"], each["line"]) for each in marking["marks"]["points"]]


def verdicts(statement: str, *lines: str, part: str | None = None) -> list[str]:
    marking = restitution.mark(solution_of(statement), "\n".join(lines), part=part)
    return [line["verdict"] for line in marking.json()["lines"]]


def test_components_may_be_those_of_a_direction_that_is_no_unit_vector() -> None:
    lines = ["v + 2w = 6 - 6", "w - v = 1/3 × 9 = 3", "w = 1, v = -2", "perp A: 5 - 1 = 4"]
    assert verdicts(TURNED, *lines) == ["true"] * 4
    assert verdicts(TURNED, *lines[:1], "w - v = 1/3 × 3 = 1") == ["true", "false"]


def test_spaces_around_commands_of_latex_part_no_relations() -> None:
    lines = [
        r"$mu\cos\alpha = mv + Mw$",
        r"$w - v = u\cos\alpha$",
        r"speed of A: $v_A^2 = v^2 + u^2\sin^2\alpha$",
        r"$u^2 - v_A^2 = u^2\cos^2\alpha - v^2 = \frac{4mMu^2\cos^2\alpha}{(m+M)^2}$",
    ]
    assert verdicts(LETTERS, *lines) == ["true"] * 4
    assert verdicts(LETTERS, *lines[:3], lines[3].replace("4mM", "2mM"))[3] == "false"


def test_bold_letters_of_latex_end_at_commands_before_them() -> None:
    above = ["2x + y = 7", "y - x = 5/2"]
    line = r"$(\mathbf{v}_A - \mathbf{v}_B)\cdot\mathbf{i} = x - y = -5/2$"
    assert verdicts(LEVEL, *above, line)[2] == "true"
    assert verdicts(LEVEL, *above, line.replace("-5/2", "3/2"))[2] == "false"


@pytest.mark.parametrize("name", ["A = ", "A: "])
def test_a_vector_behind_a_name_is_of_any_moment(name: str) -> None:
    assert verdicts(TURNED, f"{name}5i + j") == ["true"]
    assert verdicts(TURNED, f"{name}(5, 1)", f"{name}(1, -3)") == ["true", "true"]
    assert verdicts(TURNED, f"{name}2i - 3j") == ["false"]


@pytest.mark.parametrize("name", ["P = ", "P: "])
def test_a_vector_behind_the_name_of_a_placed_sphere_may_be_its_place(name: str) -> None:
    lines = [f"{name}(-3 + √2t, -4 + √2t)", "(-3 + √2t)² + (-4 + √2t)² = 25", f"{name}(4, 3)"]
    assert verdicts(PLACED, *lines) == ["true"] * 3


def test_a_label_goes_on_at_another_stage() -> None:
    assert verdicts(LEVEL, "A before along 8cos60° = 4, after 1 + 1/2 = 3/2") == ["true"]
    assert verdicts(LEVEL, "A before along 8cos60° = 4, after 4 - 1 = 3") == ["false"]


def test_a_body_named_behind_a_value_is_no_subscript_of_its_letter() -> None:
    wide = LETTERS.replace("velocity u at alpha", "velocity u i + 1.2u j")
    assert verdicts(wide, "perp 1.2u for A and 0 for B") == ["true"]


def test_a_case_that_is_rejected_claims_nothing() -> None:
    above = ["v = 2u - 2eu", "2u - 2eu = u/2 so e = 3/4"]
    assert verdicts(DIRECT, *above, "or 2u - 2eu = -u/2, e = 5/4 too big")[2] == "remark"
    assert verdicts(DIRECT, above[0], "2u - 2eu = -u/2, e = 5/4")[1] == "false"


def test_a_deflection_may_be_by_the_blow_of_a_part() -> None:
    assert verdicts(KICKED, "deflection tan^-1(1.5) = 56.3", part="a") == ["true"]
    assert verdicts(KICKED, "deflection tan^-1(0.5) = 26.6", part="a") == ["false"]


WALL = """wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/3
given deflection(P) = 60°
find tan(alpha), speed(P)"""
EQUAL = """sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
find speed(A), speed(B)"""
BOTH_ANGLES = """sphere A: mass m, velocity u at 30°
sphere B: mass 2m, velocity v at 60° from -i
A hits B: along i
given direction(A) = 120°, e = 1/2
find v/u"""
SWAP = """sphere A, B: mass m
sphere A: velocity p i + q j
sphere B: velocity r i + s j
A hits B: along i, e = 1
find velocity(A), velocity(B), impulse(A)"""
WALLS = """wall W: along i
wall X: along j
sphere P: velocity u at alpha to W
P hits W: e = 1/2
P hits X: e = 1/4
find tan(angle(velocity(P), W)) in terms of alpha"""


def test_an_angle_is_not_turned_to_excuse_one_line_where_another_tells_its_sense() -> None:
    assert verdicts(WALL, "tanβ = 1/3 tanα", "α + β = 60") == ["true", "true"]
    assert verdicts(WALL, "tanβ = 1/3 tanα", "α - β = 60") == ["true", "false"]


def test_a_speed_in_words_is_no_component_that_has_a_letter() -> None:
    lines = ["mucosα = mp + mq", "q - p = eucosα", "p = ½(1 - e)ucosα", "q = ½(1 + e)ucosα"]
    assert verdicts(EQUAL, *lines, "speed B = ½(1 + e)ucosα") == ["true"] * 5
    assert verdicts(EQUAL, *lines, "speed A = ½(1 - e)ucosα") == [*["true"] * 4, "false"]


def test_a_datum_with_another_value_is_no_case() -> None:
    above = ["perp ½u, along a = -½u/tan60", "mucos30 - 2mvcos60 = ma + 2mb"]
    assert verdicts(BOTH_ANGLES, *above, "e = ½: b - a = ½(ucos30 + vcos60)")[2] == "true"
    assert verdicts(BOTH_ANGLES, *above, "e = ⅓: b - a = ⅓(ucos30 + vcos60)")[2] == "false"


def test_the_impulse_on_a_body_as_a_vector_has_its_sense() -> None:
    above = ["vA = ri + qj", "vB = pi + sj"]
    line = "impulse on A = m(ri + qj) - m(pi + qj) = m(r - p)i"
    assert verdicts(SWAP, *above, line) == ["true"] * 3
    turned = "impulse on A = m(pi + qj) - m(ri + qj) = m(p - r)i"
    assert verdicts(SWAP, *above, turned) == ["true", "true", "false"]


def test_behind_the_second_wall_the_angle_at_the_first_keeps_its_meaning() -> None:
    lines = [
        "after W: v1cosβ = ucosα, v1sinβ = ½usinα",
        "tanβ = ½tanα",
        "after X: v2cosγ = v1cosβ, v2sinγ = ¼v1sinβ",
        "tanγ = ¼tanβ = ⅛tanα",
    ]
    assert verdicts(WALLS, *lines) == ["true", "true", "false", "follows"]
    right = "after X: v2cosγ = v1sinβ, v2sinγ = ¼v1cosβ"
    assert verdicts(WALLS, *lines[:2], right) == ["true"] * 3


ENERGIES = """sphere A: mass 2m, velocity 3u at 60°
sphere B: mass m, velocity 2u at 30° from -i
A hits B: along i, e = 2/3
find energy_lost/energy(0) as a percentage, energy(A)/energy(A, 0), energy(B)/energy"""
EQUAL_SPEEDS = """sphere A: mass m, velocity u at 60°
sphere B: mass 2m, velocity v j
A hits B: along i, e = 1/2
given speed(A) = speed(B)
find v"""
BOUNCED = """wall W: along i, through (0, 0)
sphere P: mass 2, at (0, 4), velocity u at 30° to W
P hits W
given time(1) = 2, impulse = 6
find u, e, speed(P)"""


def test_a_ratio_is_the_one_that_is_asked_for() -> None:
    lines = [
        "KE of A after = ½(2m)(0.2961² + 2.598²)u² = 6.838mu²",
        "KE of A before = ½m(3u)² = 4.5mu²",
        "ratio A = 6.838/4.5 = 1.52",
    ]
    assert verdicts(ENERGIES, *lines) == ["true", "false", "follows"]
    assert verdicts(ENERGIES, lines[0], "ratio A = 6.838/4.5 = 1.52")[1] == "false"
    assert verdicts(ENERGIES, r"percentage = $\frac{1.9345}{11} = 17.6\%$") == ["true"]


def test_a_letter_that_the_script_has_alone_is_no_subscript() -> None:
    lines = ["mucos60 = mx + 2my so x + 2y = ½u", "y - x = ¼u", "3y = ¾u, 4y² - 2uy + ¼u² = 0"]
    assert verdicts(EQUAL_SPEEDS, *lines) == ["true"] * 3


def test_a_value_behind_the_name_of_a_body_is_no_further_value() -> None:
    assert verdicts(EQUAL_SPEEDS, "perp: A usin60 = √3u/2, B v") == ["true"]


def test_the_letter_of_a_known_speed_may_be_that_of_the_velocity() -> None:
    lines = ["4 = usin30 × 2 so u = 4", "u = 2√3i - 2j, v = 2√3i + yj", "6 = 2(y + 2), y = 1"]
    assert verdicts(BOUNCED, *lines) == ["true"] * 3


CORNER = """wall W: along i
wall X: along j
sphere P: mass m, velocity u at theta to W
P hits W: e = 3/4
P hits X: e = 1/4
given speed(P) = u/2
find tan(theta)"""


def test_components_listed_below_the_heading_of_a_wall_are_judged() -> None:
    above = "after W: ucosθ par, ¾usinθ perp"
    wrong = "after X: ucosθ par, 3/16usinθ perp"
    lines = [above, wrong, "cos²θ + 9/256sin²θ = 1/4"]
    assert verdicts(CORNER, *lines) == ["remark", "false", "follows"]
    assert verdicts(CORNER, "after W: ¾ucosθ and usinθ") == ["false"]
    for right in (
        "after X: ¼ucosθ perp, ¾usinθ par",
        "hits X: ucosθ, ¾usinθ",
    ):  # after it, and before it
        assert verdicts(CORNER, above, right) == ["remark", "remark"]


def test_an_energy_before_the_impact_shows_no_law_of_it() -> None:
    statement = """sphere A: mass 2m, velocity u at 45°
sphere B: mass m, velocity u at 45° from -i
A hits B: along i, e = 0
find speed(A), energy_lost/energy(0)"""
    lines = ["ucos45 - ucos45 = v1 + v2", "v2 - v1 = 0", "KE before = ½(2m)u² + ½mu² = (3/2)mu²"]
    law = "conservation of momentum along the line of centres"
    assert (law, "lost", 1) in points(statement, *lines)
    after = "KE after = ½(3m)(u²/18) + ½(3m)(½u²) = ⅚mu²"
    assert (law, "earned", 1) in points(statement, after)


PAIR = """sphere A: mass 2, velocity 6 at 60°
sphere B: mass 3, velocity 4 at 120°
A hits B: along i, e = 1/2
find speed(A), speed(B)"""
TO_THE_WALL = """sphere A: mass 2, velocity 5i, at (0, 0)
sphere B: mass 3, at rest, at (0, 0)
wall W: along j, through (12, 0)
A hits B: along i, e = 1/2
find velocity(A), velocity(B)
B hits W: e = 2/3
find velocity(B), time(2) - time(1), distance(A, B, at time(2))"""


def test_a_letter_that_is_solved_for_begins_a_relation() -> None:
    lines = ["0 = 2a + 3b", "b - a = 2.5", "5a = -7.5 a = -1.5 b = 1", "5a = -7.5 a = 1.5 b = 1"]
    assert verdicts(PAIR, *lines) == ["true", "true", "true", "false"]


def test_a_name_behind_a_direction_begins_a_statement() -> None:
    lines = ["a = -1.5, b = 1", "so A goes at 1.5 in opp direction and B 1 m/s"]
    assert verdicts(PAIR, *lines) == ["true", "remark"]


def test_a_label_before_prose_is_not_that_of_a_value_behind_it() -> None:
    (link,) = (
        read_working("B moves along the loc so angle between them = 88.0°", restitution.parse(PAIR))
        .lines[0]
        .links
    )
    assert link.readings[0].left == Letter("angle between")


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("after wall B = 2/3 × 3 = 2", "true"),
        ("after wall B = 2/3 × 3 = 1", "false"),
        ("B = 3", "true"),  # after the first impact
        ("B = -2", "true"),
        ("A has gone 0.5×4 = 2m so gap = 10m", "true"),
        ("A has gone 0.5×4 = 2m so gap = 12m", "false"),
        ("B is -2i", "true"),
        ("B is 5i", "false"),
        ("B rebounds at ⅔×3 = 2", "true"),
        ("B bounces off the wall with speed 5", "false"),
        ("B rebounds at 30° to the wall", "remark"),
    ],
)
def test_names_metres_and_copulas_are_read(line: str, verdict: str) -> None:
    assert verdicts(TO_THE_WALL, "v = 0.5, w = 3", line)[1] == verdict


def test_a_total_is_the_time_that_is_asked() -> None:
    walls = """wall L: along j, through (0, 0)
wall R: along j, through (d, 0)
sphere P: velocity u i, at (0, 0)
P hits R: e = 1/2
P hits L: e = 1/2
find time(2)"""
    assert verdicts(walls, "t = d/u", "total = 3d/u") == ["true", "true"]
    assert points(walls, "total = 3d/u")[-1][1] == "earned"


def test_it_is_deflected_in_short() -> None:
    bodies = "wall W: along i\nsphere S: velocity u at 45° to W\n"
    wall = f"{bodies}S hits W: e = 1/2\nfind deflection(S)"
    lines = ["it's deflected by 45 + 26.6 = 71.6°", "so it's deflected by 26.6°"]
    assert verdicts(wall, *lines) == ["true", "false"]


def test_a_title_before_an_equation_of_squares_is_no_value_of_it() -> None:
    closing = """sphere A: mass 2, velocity 3i + 4j
sphere B: mass 3, velocity -i - 2j
A hits B: along j
given abs(velocity(A) - velocity(B)) = 5
find e"""
    for last, verdict in (("3", "true"), ("4", "asks")):
        assert verdicts(closing, f"rel vel: 4² + s² = 5² so s = {last}")[0] == verdict


def test_a_printed_angle_rests_on_its_tangent_in_decimals() -> None:
    balls = """sphere A, B: mass 0.18
sphere A: velocity 4 at 35°
sphere B: at rest
A hits B: along i, e = 0.95
show angle(velocity(A), velocity(B)) = 88.0° to 3 s.f."""
    lines = ["4cos35 = v + w", "w - v = 0.95 x 4cos35", "v = 0.0819, w = 3.195"]
    lines += ["tanθ = 4sin35/0.0819", "θ = 88.0°", "B moves along the loc so angle between = 88.0°"]
    assert verdicts(balls, *lines) == ["true"] * 6
    assert verdicts(balls, lines[-1]) == ["unsupported"]


def test_a_root_of_squares_times_a_letter_goes_on_in_a_chain() -> None:
    wall = """wall W: along j
sphere P: mass 3, velocity 2a i + a j
P hits W: e = 1/2
given speed(P) = 4
find a, velocity(P)"""
    lines = ["v = -a i + a j", "|v| = √(a² + a²) = √2 a = 4", "a² = 8 a = 2√2"]
    assert verdicts(wall, *lines) == ["true"] * 3


@pytest.mark.parametrize("root", ["sq root", "square root of", "sq. rt", "root"])
def test_a_square_root_in_words_is_one(root: str) -> None:
    (line,) = read_working(f"A speed = {root} (9 + 4) = 3.61", restitution.parse(PAIR)).lines
    first = line.links[0].readings[0].right
    assert first == Apply("sqrt", Binary("+", Number(Fraction(9)), Number(Fraction(4))))


STOPPED = """sphere A: mass m, velocity 4u i
sphere B: mass k m, velocity -u i
A hits B: along i
given velocity(A) = 0
part a
show k = 4/(1 + 5e)
part b
find range of k"""


def test_a_velocity_that_is_given_as_zero_is_a_fact() -> None:
    lines = ["4mu - kmu = kmw", "w = 5eu", "4 - k = 5ek", "k(1 + 5e) = 4"]
    assert verdicts(STOPPED, *lines, part="a") == ["true"] * 4


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("e = 0 → k = 4 and e = 1 → k = 4/6", "true"),
        ("e=0, k=4, e=1, k=2/3", "true"),
        ("e=0 => k=4, e=1 => k=3/4", "false"),
    ],
)
def test_a_line_may_have_several_cases(line: str, verdict: str) -> None:
    assert verdicts(STOPPED, line, part="b") == [verdict]


FACING = """sphere A: mass 2, velocity 5 at 60°
sphere B: mass 3, velocity 4 at 150°
A hits B: along i, e = 1/2
find speed(B)"""


def test_a_result_to_three_figures_is_rounded_though_it_is_a_datum() -> None:
    assert verdicts(FACING, "speed of B = √(0.114² + 2²) = 2.00") == ["true"]
    assert verdicts(FACING, "speed of B = √(0.214² + 2²) = 2.00") == ["false"]


OFFSET = """sphere A: mass 2m, velocity u i, radius r
sphere B: mass 3m, at rest, radius r
A hits B: offset r sqrt(2), e = 1/3
find energy_lost/energy(0), speed(B)"""


def test_a_side_that_stood_before_keeps_its_decimals() -> None:
    assert verdicts(OFFSET, "so lost 0.267 of it = 4/15") == ["true"]
    assert verdicts(OFFSET, "speed of B = 0.377u", "= 4√2u/15") == ["true", "true"]
    assert verdicts(OFFSET, "speed of B = 0.377u", "= 4√2u/14")[1] == "false"


PUSHED = """sphere A: mass 2, velocity 2i + j
sphere B: mass M, velocity -2i + 3j
A hits B: along i
given velocity(A) = -i + j, velocity(B) = 2i + 3j
find M"""


def test_a_vector_on_a_body_is_an_impulse() -> None:
    assert verdicts(PUSHED, "imp on A = 2(-3i) = -6i so on B +6i") == ["true"]
    assert verdicts(PUSHED, "imp on A = 2(-3i) = -6i so on B +7i") == ["false"]


FOUND = """sphere A: mass 1, velocity 3i + j
sphere B: mass 2, at rest
A hits B
given velocity(A) = i - j
part a
find velocity(B)
part b
find line_of_centres"""


def test_a_line_of_centres_alone_has_its_method() -> None:
    marking = restitution.mark(solution_of(FOUND), "l.o.c. is (i + j)/√2", part="b")
    assert (marking.marks.earned, marking.marks.of) == (2, 2)


def test_a_value_may_stand_before_what_it_is_of() -> None:
    statement = FACING.replace("find speed(B)", "find angle(velocity(A), velocity(B))")
    assert verdicts(statement, "so 36.8° between") == ["true"]
    assert verdicts(statement, "so 63.3° between") == ["false"]


SQUARE_CORNER = """wall AB: along i
wall BC: along j
sphere P: mass 2, velocity 5i - 4j
P hits AB: e = 1/2
P hits BC: e = 1/3
find speed(P)"""


@pytest.mark.parametrize(
    "line",
    [
        *("into AB: 4", "away from AB: 1/2 × 4 = 2", "off AB 2, along AB 5", "towards BC 5"),
        *("so away from BC 5/3", "away from the wall = 5/3", "out from AB: 2"),
        *("perp² = 25/9", "perpendicular² = 25/9", "speed after² = 25/9 + 4"),
        *("speed of P after squared = 25/9 + 4", "speed before² = 25 + 4", "parallel² = 4"),
    ],
)
def test_ways_to_a_wall_are_labels_and_squares_stand_behind_words(line: str) -> None:
    assert verdicts(SQUARE_CORNER, line) == ["true"]
    *start, figure = re.split(r"(\d+)(?=\D*$)", line)[:2]
    wrong = f"{start[0]}7{figure}"
    assert verdicts(SQUARE_CORNER, wrong) == ["false"], wrong


def test_a_vector_behind_a_body_is_where_it_has_come_to() -> None:
    statement = LEVEL.replace("find velocity(A), velocity(B)", "find distance(A, B, at 3)")
    right = "A: 3(1.5i + 3j) = (4.5, 9)\nA: (4.5, 9) B: (12, 6)\nA moves 4.5i + 9j\nB: 12i + 6j"
    assert set(verdicts(statement, *right.splitlines())) == {"true"}
    assert verdicts(statement, "A: (4.5, 8)") == ["false"]


RELATIVE = """sphere A: mass 2, velocity 6i + j
sphere B: mass 3, velocity 2i - 2j
A hits B: along i, e = 1/4
find velocity(A), velocity(B)"""


@pytest.mark.parametrize(
    "line",
    [
        *("A relative to centre of mass 2.4", "relative to centre of mass A: 2.4, B: -1.6"),
        *("A relative to mass centre after = -0.6", "v_A relative to centre of mass = 2.4"),
        *("after: A -0.6, B 0.4 relative to it", "in the centre of mass frame: A 2.4, B -1.6"),
        *("centre of mass 3.6", "CM moves with 3.6", "relative to CoM: A 2.4 B -1.6"),
    ],
)
def test_the_mass_centre_needs_no_noun(line: str) -> None:
    assert verdicts(RELATIVE, line) == ["true"]
    assert verdicts(RELATIVE, re.sub(r"\d(?=\D*$)", "9", line)) == ["false"]


AT_A_WALL = "wall W: along i\nsphere P: mass 2, velocity 8i - 6j\nP hits W: e = 1/3\nfind {}"


@pytest.mark.parametrize(
    "line",
    [
        *("components x: 8, y: 2", "components x 8 y 2", "components after: x 8, y 2"),
        *("before/after: perp 6/2", "perp before/after: 6, 2", "perp before 6 after 2"),
        *("perp to wall: before 6, after 2", "x before 8 after 8", "par 8 before, 8 after"),
        *("before and after: perp 6 and 2", "components of P after: x 8 and y 2"),
    ],
)
def test_pairs_of_values_are_read_whole(line: str) -> None:
    statement = AT_A_WALL.format("velocity(P), speed(P)")
    assert verdicts(statement, line) == ["true"]
    assert verdicts(statement, re.sub(r"\d(?=\D*$)", "7", line)) == ["false"]


def test_a_slash_behind_an_equals_sign_may_be_of_a_ratio() -> None:
    statement = AT_A_WALL.format("energy_lost")
    assert verdicts(statement, "KE before/after = 25/17") != ["false"]
