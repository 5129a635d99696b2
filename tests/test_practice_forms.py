"""Lines in forms that students use beside equations: true ones hold, those with a slip do not."""

from __future__ import annotations

import random

import pytest
from marked import solution_of, verdicts

import restitution

WAYS = ((3, 4, 5), (4, 3, 5), (-3, 4, 5), (5, 12, 13), (4, -3, 5), (12, 5, 13))


def oblique(seed: int) -> tuple[str, dict[str, tuple[int, int]]]:
    """Two spheres with a line of centres along neither axis; components along and across it."""
    dice = random.Random(seed)
    x, y, size = WAYS[seed % len(WAYS)]
    parts = {
        "A": (dice.randint(2, 5), dice.choice((-3, -1, 2))),
        "B": (dice.randint(-3, 0), dice.choice((1, 4, 6))),
    }
    velocities = {
        name: f"({p * x - q * y}/{size}) i + ({p * y + q * x}/{size}) j"
        for name, (p, q) in parts.items()
    }
    statement = (
        f"sphere A: mass 2, velocity {velocities['A']}\n"
        f"sphere B: mass 3, velocity {velocities['B']}\n"
        f"A hits B: along {x}i + {y}j, e = 1/2\nfind velocity(A), velocity(B)\n"
    )
    return statement.replace("+ -", "- "), parts


@pytest.mark.parametrize("seed", range(6))
def test_components_in_turned_axes_hold_and_those_of_another_size_do_not(seed: int) -> None:
    statement, parts = oblique(seed)
    (p, q), (r, s) = parts["A"], parts["B"]
    lines = f"velocity before of A = ({p}, {q})", f"velocity before of B = ({r}, {s})"
    assert verdicts(statement, *lines) == ["true", "true"]
    assert verdicts(statement, f"velocity before of A = ({p + 1}, {q})") == ["false"]


def test_axes_along_i_and_j_leave_no_sign_open() -> None:
    statement = (
        "sphere A: mass 2, velocity 3i + 2j\nsphere B: mass 3, at rest\n"
        "A hits B: along i, e = 1/2\nfind velocity(A)\n"
    )
    assert verdicts(statement, "velocity before of A = (3, 2)") == ["true"]
    assert verdicts(statement, "velocity before of A = (3, -2)") == ["false"]


@pytest.mark.parametrize("seed", range(6))
def test_scalar_products_with_n_and_t_need_no_declaration(seed: int) -> None:
    statement, parts = oblique(seed)
    (p, q), (r, s) = parts["A"], parts["B"]
    lines = f"u_A.n = {p}", f"u_B.n = {r}", f"u_A.t = {q}", f"u_B.t = {s}"
    assert verdicts(statement, *lines) == ["true"] * 4


FOUND = (
    "sphere A: mass 1, velocity 5i + 5j\nsphere B: mass 2, velocity -5i\nA hits B\n"
    "given velocity(A) = -i - 3j\nfind line_of_centres, velocity(B), e\n"
)
SAYINGS = (
    "line of centres parallel to {}",
    "line of centres is {}",
    "so the line of centres is along {}",
    "loc = {}",
    "the line of centres is in the direction {}",
)


@pytest.mark.parametrize("saying", SAYINGS)
def test_which_way_the_line_of_centres_points_is_a_claim(saying: str) -> None:
    for way, verdict in (("3i + 4j", "true"), ("-6i - 8j", "true"), ("4i - 3j", "false")):
        assert verdicts(FOUND, saying.format(way)) == [verdict], way


def test_the_angle_of_a_line_of_centres_may_be_that_to_i() -> None:
    assert verdicts(FOUND, "angle of loc = tan^-1(4/3) = 53.1") == ["true"]
    assert verdicts(FOUND, "angle of loc = 25.5") == ["false"]


def test_a_change_of_a_body_is_that_of_its_velocity() -> None:
    assert verdicts(FOUND, "change in A = -6i - 8j, parallel to 3i + 4j") == ["true"]
    assert verdicts(FOUND, "change in A = -6i + 8j") == ["false"]


WALLS = (
    "wall W: along i\nwall V: along j\nsphere P: mass 2, velocity 8i - 6j\n"
    "P hits W: e = 1/2\nP hits V: e = 3/4\nfind velocity(P), total_energy_lost\n"
)


@pytest.mark.parametrize(
    ("first", "second"),
    [
        ("after W: 8i + 3j", "after V: -6i + 3j"),
        ("1st wall: 8i + 3j", "2nd wall: -6i + 3j"),
        ("after W - 8i + 3j", "after V - -6i + 3j"),
    ],
)
def test_a_vector_behind_a_heading_is_the_velocity_there(first: str, second: str) -> None:
    assert verdicts(WALLS, first, second) == ["true", "true"]
    turned = second.replace("-6i", "6i").replace("- 6i", "6i")
    assert verdicts(WALLS, first, turned) == ["true", "false"]


def test_what_a_heading_speaks_of_is_not_another_wall() -> None:
    """Along the second wall is not along the first, whatever is true there."""
    assert verdicts(WALLS, "after W: 8i + 3j", "at V: parallel = 8") == ["true", "false"]


PAIR = (
    "sphere A: mass 3, velocity 4i + 2j\nsphere B: mass 2, velocity -i + 3j\n"
    "A hits B: along i, e = 1/2\nfind velocity(A), velocity(B), energy_lost\n"
)


def test_the_mass_centre_has_its_own_velocity() -> None:
    names = "velocity of centre of mass", "vel of com", "velocity of the mass centre along i"
    for name in names:
        assert verdicts(PAIR, f"{name} = 10/5 = 2") == ["true"], name
        assert verdicts(PAIR, f"{name} = 3") == ["false"], name


def test_the_way_behind_a_value_is_that_of_a_component() -> None:
    assert verdicts(PAIR, "before", "A: 4 along, 2 perp", "B: 1 left, 3 up")[1:] == ["true", "true"]
    assert verdicts(PAIR, "before", "A: 5 along, 2 perp")[1:] == ["false"]


def test_the_factor_behind_a_sum_may_belong_to_all_of_it() -> None:
    statement = (
        "sphere A: mass m, velocity 3u i + u j\nsphere B: mass 3m, velocity u j\n"
        "A hits B: along i, e = 1/2\nfind energy_lost\n"
    )
    assert verdicts(statement, "KE before 5 + 1.5 = 6.5mu²") == ["true"]
    assert verdicts(statement, "KE before 5 + 2.5 = 7.5mu²") == ["false"]


def test_an_angle_to_a_wall_may_be_the_obtuse_one() -> None:
    statement = "wall W: along i\nsphere P: velocity 4 at 60° to W\nP hits W: e = 1/3\n"
    statement += "find angle(velocity(P), W)\n"
    assert verdicts(statement, "angle to W = 180 - 30 = 150") == ["true"]
    assert verdicts(statement, "angle to W = 140") == ["false"]


def test_a_letter_met_below_a_mistake_means_what_makes_it_follow() -> None:
    statement = "wall W: along i\nsphere P: velocity 12 at 60° to W\nP hits W: e = 1/3\n"
    statement += "find speed(P), angle(velocity(P), W)\n"
    lines = "parallel after = 12 sin 60 = 6√3", "perp after = 1/3 * 12 cos 60 = 2"
    angle = "tan β = 2/(6√3), β = 10.9"
    assert verdicts(statement, *lines, angle)[2] == "follows"
    assert verdicts(statement, *lines, "tan β = 3/(6√3)")[2] != "follows"


def test_two_bodies_may_stand_on_one_line() -> None:
    assert verdicts(PAIR, "A = i + 2j  B = 3.5i + 3j") == ["true"]
    assert verdicts(PAIR, "A = i + 2j  B = 3i + 3j") == ["false"]


def test_a_sign_lost_in_a_given_impulse_is_not_one_of_restitution() -> None:
    statement = (
        "wall W: along i\nsphere P: mass 0.5, velocity 7i - 4j\nP hits W\n"
        "given impulse = 3\nfind e, speed(P)\n"
    )
    marking = restitution.mark(solution_of(statement), "3 = 0.5(4 - 4e)")
    (line,) = marking.json()["lines"]
    assert line["verdict"] == "false"
    assert line["mistake"]["id"] != "restitution-sign"


FOUND_B = (
    "sphere A: mass 3, velocity 4i + j\nsphere B: mass M, velocity -2i + 3j\nA hits B: along i\n"
    "given velocity(B) perpendicular to velocity(B, 0), e = 3/4\nfind M, velocity(B)\n"
)
SLOW = (
    "wall W: along i\nsphere P: mass 0.4, velocity 3i - 4j\nP hits W: e = 1/2\n"
    "find velocity(P), energy_lost, energy_lost/energy(0)\n"
)  # v = 3i + 2j; 5 before, 2.6 after


SLANTED = (
    "wall W: along i\nsphere P: mass 2, velocity 4 at -35°\nP hits W: e = 1/2\nfind speed(P)\n"
)


def test_a_colon_behind_words_is_no_ratio() -> None:
    assert verdicts(FOUND_B, "b = 9/2", "so the product is -1: 3/b x 3/-2 = -1") == ["true"] * 2
    assert verdicts(FOUND_B, "b = 9/2", "so the product is -1: 3/b x 3/2 = -1")[1] == "false"


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("KE lost is 12/25 so KE left is 13/25", "true"),
        ("KE lost is 13/25", "false"),
        ("lost 2.4/5 = 48%", "true"),
        ("lost 2.4/5 = 52%", "false"),
        ("KE: 0.2(25) - 0.2(13) = 2.4", "true"),
        ("KE: 0.2(25) - 0.2(9) = 3.2", "false"),
        ("app = 4", "true"),
        ("sep = 4", "false"),
        ("speed^2: 9 + 4 = 13", "true"),
        ("speed^2: 9 + 2 = 11", "false"),
        ("tan(angle) = 2/3", "true"),
        ("tan(angle) = 3/5", "false"),
        ("unit vec along wall = i", "true"),
    ],
)
def test_what_a_label_may_name(line: str, verdict: str) -> None:
    assert verdicts(SLOW, line) == [verdict]


def test_half_of_a_datum_is_as_exact_as_the_datum() -> None:
    """0.2 for half of the mass 0.4 is no rounded number, which would make any line true."""
    assert verdicts(SLOW, "KE after = 0.2 x 3.5^2 = 2.45") == ["false"]
    assert verdicts(SLOW, "KE after = 0.2 x 3.6^2 = 2.59") == ["true"]


def test_a_line_below_a_heading_may_have_come_to_the_next_event() -> None:
    lines = "after W: 8i + 3j", "speed = 10", "KE = 45"
    assert verdicts(WALLS, *lines)[0] == "true"
    assert verdicts(WALLS, "after W: 8i + 3j", "speed = √45") == ["true", "true"]
    assert verdicts(WALLS, "after W: 8i + 3j", "speed = √44") == ["true", "false"]


def test_a_relation_may_follow_from_one_before_it_in_its_line() -> None:
    lines = "v = 3i + 1j", "tan(angle) = 1/3, angle = 18.4"
    assert verdicts(SLOW, *lines) == ["false", "follows"]
    assert verdicts(SLOW, lines[0], lines[1].replace("18.4", "28.4")) == ["false", "false"]


def test_letters_below_a_mistake_mean_what_they_mean_in_his_own_world() -> None:
    between = (
        "sphere A: mass 3m, at (0, 0), at rest\nsphere B: mass m, at (d, 0), velocity u i\n"
        "sphere C: mass 3m, at (2d, 0), at rest\nB hits C: along i, e = 2/3\n"
        "B hits A: along i, e = 2/3\nfind velocity(A), velocity(B)\n"
    )
    first = "u = b + 3c", "c - b = 2/3u", "4c = u - 2u/3 = u/3", "c = u/12", "b = -7u/12"
    second = "-7u/12 = x + 3y", "x - y = 2/3*7u/12 = 7u/18", "4y = -7u/12 - 7u/18 = -35u/36"
    said = verdicts(between, *first, *second)
    assert said[:2] == ["true", "true"]
    assert said[2] == "false"
    assert set(said[3:]) == {"follows"}


@pytest.mark.parametrize(
    ("statement", "lines", "name"),
    [
        (SLOW, ["I = m(v - u) = 0.4(4 - 2) = 0.8"], "impulse-sign"),
        (SLOW, ["I = m(v - u) = 0.4(5 - 3.61)"], "impulse-of-speeds"),
        (SLANTED, ["perp before = 4cos35"], "sine-cosine"),
        (SLOW, ["speed^2: 3 + 4 = 7"], "square-not-taken"),
    ],
)
def test_mistakes_in_chains_and_in_lines_without_a_law_have_their_names(
    statement: str, lines: list[str], name: str
) -> None:
    marking = restitution.mark(solution_of(statement), "\n".join(lines)).json()
    assert (marking["lines"][-1]["mistake"] or {}).get("id") == name


def test_an_inequality_that_cannot_be_follows_from_a_wrong_value() -> None:
    statement = (
        "sphere A: mass m, velocity 2u i\nsphere B: mass 3m, velocity -u i\nA hits B: along i\n"
        "given velocity(A) opposite to i\nfind range of e\n"
    )
    lines = "5u = v + 3w", "w - v = eu", "v = (5 - 3e)u/4", "v < 0 so 5 - 3e < 0"
    assert verdicts(statement, *lines, "e > 5/3")[2:] == ["follows"] * 3
    assert verdicts(statement, *lines, "e > 3/5")[-1] == "false"


@pytest.mark.parametrize("quoted", ["e = 1/2", "e = 0.5"])
def test_a_datum_that_is_misquoted_is_a_misread(quoted: str) -> None:
    statement = (
        "wall W: along i\nsphere P: mass 2, velocity 5i - 12j\nP hits W: e = 1/3\nfind impulse\n"
    )
    marking = restitution.mark(solution_of(statement), f"{quoted}\nI = 2(12 + 6) = 36").json()
    first, second = marking["lines"]
    assert (first["verdict"], first["mistake"]["id"]) == ("false", "misread")
    assert second["verdict"] == "follows"


RESTING = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\nA hits B: along i\n"
    "find speed(B), tan(angle(velocity(A), i))\n"
)
BOTH = (
    "sphere A: mass 3, velocity 4i + j\nsphere B: mass 2, velocity -i + 3j\n"
    "A hits B: along i, e = 1/2\nfind velocity(A), velocity(B)\n"
)  # i + j and 3.5i + 3j


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("v_A = ucosα(1-2e)/3 if e > 1/4", "true"),
        ("v_A < 0 if e > 1/2", "remark"),
        ("v_A = 0 when e = 1/2", "true"),
        ("v_A = 0 when e = 1/3", "false"),
        ("the max e is 1 so v_B max = 2ucosα/3", "remark"),
        ("v_B = 2ucosα/3", "false"),
    ],
)
def test_what_holds_under_a_condition_is_no_claim_without_it(line: str, verdict: str) -> None:
    momentum = "mucosα = m v_A + 2m v_B"
    assert verdicts(RESTING, momentum, line) == ["true", verdict]


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("v_A = 1, v_B = 3.5, so v_A = (1, 1)", "true"),
        ("v_A = 1, v_B = 3.5, so v_A = (1, 2)", "false"),
        ("change in velocity of A = 9/3 = 3", "true"),
        ("change in velocity of A = 9/2 = 4.5", "false"),
        ("angle between them = 45 - 40.6 = 4.4", "true"),
        ("angle between them = 45 + 40.6 = 85.6", "false"),
        ("along: 4 becomes 1", "true"),
        ("along: 4 becomes 2", "false"),
    ],
)
def test_a_letter_for_a_vector_and_its_part_and_changes_in_words(line: str, verdict: str) -> None:
    assert verdicts(BOTH, line) == [verdict]


def test_behind_a_sign_of_division_stands_the_whole_of_a_product() -> None:
    assert verdicts(RESTING, "tan θ = usinα ÷ (1-2e)ucosα/3 = 3tanα/(1-2e)") == ["true"]
    assert verdicts(RESTING, "tan θ = usinα ÷ (1-2e)ucosα/2 = 2tanα/(1-2e)") != ["true"]


def test_a_chain_may_pass_from_vectors_to_sizes() -> None:
    """I = m(v - u) holds of vectors, and what comes behind it is the size."""
    lines = "v = 3i + 2j", "I = m(v - u) = 0.4(4 + 2) = 2.4"
    assert verdicts(SLOW, *lines) == ["true", "true"]
    assert verdicts(SLOW, lines[0], "I = m(v - u) = 0.4(4 - 2) = 0.8") == ["true", "false"]


LIMITS = (
    "sphere A: mass m, velocity 2u at 60°\nsphere B: mass 2m, velocity -v i\nA hits B: along i\n"
    "given B at rest\nfind v in terms of u, e\n"
)
SHARE = (
    "wall W: along 3i + 4j\nsphere A: mass 0.4, velocity 5i - 2j\nA hits W: e = 0.5\n"
    "find energy_lost/energy(0) as a percentage\n"
)
GLANCING = (
    "sphere A: mass 4m, velocity u at 30°\nsphere B: mass 3m, at rest\nA hits B: along i\n"
    "given angle(velocity(A), line_of_centres) = 60°\nfind e, energy_lost/energy(0)\n"
)
TURNED = (
    "sphere A: mass m, velocity 3i\nsphere B: mass m, velocity -2i + j\nA hits B\n"
    "given velocity(A) = 2i + 2j\nfind velocity(B), e, line_of_centres\n"
)


@pytest.mark.parametrize(
    ("statement", "lines", "right"),
    [
        (LIMITS, ["e=0 v = u/2"], True),
        (LIMITS, ["e=1, v = 2u"], True),
        (LIMITS, ["e=1, v = 3u"], False),
        (SHARE, ["% lost = 4.056/5.8 = 69.9"], True),
        (SHARE, ["% lost = 4.056/5.8 = 59.9"], False),
        (GLANCING, ["KE before 2mu²", "lost 2 - 0.667 - 0.889 = 0.444"], True),
        (GLANCING, ["KE before 2mu²", "lost 2 - 0.667 - 0.389 = 0.944"], False),
        (GLANCING, ["frac = 0.222"], True),
        (GLANCING, ["deflection 63.4 - 53.1 = 10.3"], False),
        (GLANCING, ["KE before = ½4m9u² - ½4m8u² = 2mu²"], True),
        (GLANCING, ["|vA|² = 0.0833 + 0.25, |vA| = 0.577u"], True),
        (GLANCING, ["|vA|² = 0.0833 + 0.35, |vA| = 0.577u"], False),
        (TURNED, ["change in A's velocity -i + 2j", "approach 7", "sep 3"], True),
        (TURNED, ["change in A's velocity -i + 2j", "approach 8"], False),
        (TURNED, ["change in A's velocity 3i + j", "approach 7"], False),
    ],
)
def test_what_counts_in_a_case_in_hundredths_or_in_units_left_out(
    statement: str, lines: list[str], right: bool
) -> None:
    assert (verdicts(statement, *lines)[-1] == "true") == right


def test_a_heading_of_a_direction_is_no_quantity() -> None:
    statement = (
        "wall W1: along i\nwall W2: along j\nsphere P: velocity u at alpha to W1\n"
        "P hits W1: e = e1\nP hits W2: e = e2\n"
        "given velocity(P) opposite to velocity(P, 0)\nfind e2\n"
    )
    line = "opposite direction: e2ucosα / (e1usinα) = ucosα/usinα"
    assert verdicts(statement, line) == ["true"]


def test_the_speed_of_a_sphere_that_was_at_rest_is_shown_by_its_component() -> None:
    statement = (
        "sphere A: mass 2m, velocity u at alpha\nsphere B: mass 3m, at rest\nA hits B: along i\n"
        "show speed(B) = 2/5 u (1 + e) cos(alpha)\n"
    )
    laws = "2mucosα = 2mv + 3mw", "w - v = eucosα"
    printed = "speed of B = 2/5u(1+e)cosα"
    assert verdicts(statement, *laws, "5w = 2ucosα(1+e)", printed) == ["true"] * 4
    assert verdicts(statement, laws[0], printed)[-1] == "unsupported"


def test_a_wrong_line_of_centres_is_one_mistake() -> None:
    statement = (
        "sphere A: mass m, velocity u i, radius r\nsphere B: mass m, at rest, radius r\n"
        "A hits B: offset r, e = 1/2\nfind direction(B), speed(B), impulse, direction(A)\n"
    )
    letters = {
        "v": "along(velocity(A), line_of_centres)",
        "w": "along(velocity(B), line_of_centres)",
        "θ": "angle(line_of_centres, i)",
    }
    lines = (
        "tanθ = r/2r so θ = 26.6",
        "ucosθ = 0.894u",
        "0.894u = v + w",
        "w - v = 0.447u",
        "w = 0.671u",
        "A perp 0.447u",
    )
    marking = restitution.mark(solution_of(statement), "\n".join(lines), letters=letters)
    said = [line["verdict"] for line in marking.json()["lines"]]
    assert said == ["false", *["follows"] * 5]


def test_a_coefficient_follows_from_wrong_speeds_of_approach_and_separation() -> None:
    statement = (
        "wall W\nsphere P: mass 2, velocity 7i + j\nP hits W\ngiven velocity(P) = 3i + 5j\nfind e\n"
    )
    lines = "approach = (7+1)/√2 = 8/√2", "sep = 2/√2", "e = 1/4"
    assert verdicts(statement, *lines) == ["false", "true", "follows"]
    assert verdicts(statement, *lines[:2], "e = 1/2")[-1] == "false"


UNKNOWN_WALL = (
    "wall W\nsphere P: mass 2, velocity 7i + j\nP hits W\ngiven velocity(P) = 3i + 5j\n"
    "find direction(W), line_of_centres, e, impulse\n"
)


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("wall: i + j", "remark"),
        ("perp to wall is -i + j", "true"),
        ("perp to wall is i + j", "false"),
        ("parallel to wall: i + j", "true"),
        ("before wall: 7i + j", "true"),
        ("impulse = (-8,8), mag 8√2", "true"),
        ("impulse = (-8,8), mag 7√2", "false"),
    ],
)
def test_which_way_a_wall_goes_and_how_large_a_vector_is(line: str, verdict: str) -> None:
    assert verdicts(UNKNOWN_WALL, line) == [verdict]


REVERSED = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\n"
    "given tan(alpha) = 3/4\nA hits B: along i, e = 3/4\n"
    "find velocity(A), speed(B), energy_lost\n"
)
SLOWED = (
    "sphere A: mass 3m, velocity 2u i\nsphere B: mass 2m, velocity -u i\nA hits B: along i\n"
    "find velocity(A), velocity(B) in terms of e, u\n"
)


@pytest.mark.parametrize(
    ("statement", "line", "verdict"),
    [
        (REVERSED, "v = 2u/15 to the left", "true"),
        (REVERSED, "v = 2u/15 in the opposite direction", "true"),
        (REVERSED, "v = 3u/15 to the left", "false"),
        (REVERSED, "v = 2u/15", "false"),
        (REVERSED, "4 = v + 2w (u=5)", "true"),
        (REVERSED, "5 = v + 2w (u=5)", "false"),
        (REVERSED, "with u = 5: 4 = v + 2w, w - v = 3", "true"),
        (REVERSED, "67.38 + 38.66 = 106", "true"),
        (REVERSED, "67.38 + 38.66 = 107", "false"),
        (REVERSED, "along only: ½m(16/25 - 4/225)u² - m(49/225)u² = 7mu²/75", "true"),
        (SLOWED, "A: 2u(2-3e)/5 B: u(4+9e)/5", "true"),
        (SLOWED, "A: 2u(3-2e)/5", "false"),
    ],
)
def test_senses_in_words_values_put_in_and_headings(
    statement: str, line: str, verdict: str
) -> None:
    letters = {"v": "along(velocity(A), i)", "w": "along(velocity(B), i)"}
    marking = restitution.mark(solution_of(statement), line, letters=letters).json()
    assert [each["verdict"] for each in marking["lines"]] == [verdict]


PAIR_OF_ANGLES = (
    "sphere A: mass m, velocity 2u at 30°\nsphere B: mass m, velocity u at 150°\n"
    "A hits B: along i\ngiven angle(velocity(A), velocity(B)) = 90°\nfind e\n"
)
HALVED = (
    "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 1/4\n"
    "given angle(velocity(P), W) = 1/2 alpha\nfind alpha\n"
)
STRUCK_AT = (
    "wall W: from (0, 0) to (4, 3)\nsphere P: at (0, 2), velocity i - j\nP hits W: e = 1/2\n"
    "find position(P), velocity(P)\n"
)
DIAGONAL = (
    "sphere A: mass 3, velocity 4i - 2j\nsphere B: mass 1, velocity -2i + j\n"
    "A hits B: along i - j, e = 1/3\nfind velocity(A), velocity(B)\n"
)


@pytest.mark.parametrize(
    ("statement", "lines", "verdict"),
    [
        (PAIR_OF_ANGLES, ["m2ucos30 - mucos30 = mx + my"], "true"),
        (PAIR_OF_ANGLES, ["y - x = 3eucos30", "m2ucos30 + mucos30 = mx + my"], "false"),
        (HALVED, ["tan 2\\alpha = \\frac{2\\tan\\alpha}{1 - \\tan^2\\alpha}"], "true"),
        (HALVED, ["let t = tan½α", "t = ¼ . 2t/(1-t²)"], "true"),
        (HALVED, ["let t = tan½α", "t = ½ . 2t/(1-t²)"], "false"),
        (HALVED, ["\\alpha = 70.5^\\circ"], "true"),
        (HALVED, ["\\alpha = 60.5^{\\circ}"], "false"),
        (STRUCK_AT, ["hits at (8/7, 6/7)"], "remark"),
        (STRUCK_AT, ["n = (-3i+4j)/5", "v = 7/10 n = -0.42i + 0.56j"], "false"),
        (DIAGONAL, ["n = (i - j)/√2", "A.n = 6/√2, B.n = -3/√2"], "true"),
        (DIAGONAL, ["n = (i - j)/√2", "A.n = 5/√2"], "false"),
        (DIAGONAL, ["p = 5/2, vA = pi - ½j", "(pi - ½j).(i + j) = 2"], "true"),
        (PAIR_OF_ANGLES, ["x² - √3ux/2 - ½u² = 0"], "true"),
    ],
)
def test_products_angles_and_places_in_forms_that_look_like_others(
    statement: str, lines: list[str], verdict: str
) -> None:
    found = verdicts(statement, *lines)
    assert found[-1] == verdict
    assert "false" not in found[:-1]


def test_a_name_before_a_letter_says_whose_the_component_is() -> None:
    statement = (
        "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, velocity v j\n"
        "A hits B: along i, e = 1/2\ngiven speed(A) = speed(B)\nfind v\n"
    )
    assert verdicts(statement, "along: A ucos60 = ½u") == ["true"]
    assert verdicts(statement, "along: A ucos60 = ¾u") == ["false"]


KICKED = (
    "wall W: along i + 2j\nsphere P: mass 0.25, velocity 8i\nP receives -i + 3j\n"
    "P hits W: e = 0.4\nfind velocity(P), impulse(P, 2)\n"
)


@pytest.mark.parametrize(("size", "verdict"), [("11.88", "false"), ("10.88", "true")])
def test_the_final_velocity_is_not_that_of_the_same_letter_above(size: str, verdict: str) -> None:
    change = f"{float(size) - 12:.2f}"
    lines = (
        "-i + 3j = 1/4(v - 8i)",
        "v = 4i + 12j",
        f"final v = 6.24i + {size}j",
        f"I = 0.25(6.24 - 4, {size} - 12) = (0.56, {0.25 * float(change):.2f})",
    )
    after = "true" if verdict == "true" else "follows"
    assert verdicts(KICKED, *lines) == ["true", "true", verdict, after]


def test_a_letter_of_an_impulse_that_is_a_vector_is_no_component() -> None:
    statement = "wall W: along i + 2j\nsphere P: mass 0.25, velocity 8i\nP hits W: e = 0.4\n"
    lines = "I = 0.25(1.24 - 8, 5.88) = (-1.69, 1.47)", "|I| = 2.24"
    assert verdicts(statement + "find impulse(P)\n", *lines) == ["false", "follows"]


def test_a_subscript_ends_before_a_sine() -> None:
    statement = (
        "sphere A: mass m_1, velocity u_1 at θ_1\nsphere B: mass m_2, velocity u_2 at θ_2 from -i\n"
        "A hits B: along i, e = e_1\nfind impulse\n"
    )
    for line in ("v₂ - v₁ = e₁(u₁cosθ₁ + u₂cosθ₂)", "v_2 - v_1 = e_1(u_1cosθ_1 + u_2cosθ_2)"):
        letters = {"v_1": "along(velocity(A), i)", "v_2": "along(velocity(B), i)"}
        marking = restitution.mark(solution_of(statement), line, letters=letters)
        assert [each.verdict for each in marking.lines] == ["true"]
    wrong = "u₁cosθ₁ - u₂cosθ₂ = v₁ + v₂", "v₂ - v₁ = e₁(u₁cosθ₁ + u₂cosθ₂)"
    more = "I = m₁(u₁cosθ₁ - v₁) = ½m₁(1+e₁)(u₁cosθ₁ + u₂cosθ₂)"
    marking = restitution.mark(solution_of(statement), "\n".join([*wrong, more]), letters=letters)
    assert marking.mistakes == ("mass-omitted",)
    methods = {
        each.point.principle: each.state
        for each in marking.marks.points
        if each.point.letter == "M"
    }
    assert methods["momentum"] == "lost"
    assert methods["impulse"] == "earned"


def test_what_a_chain_ends_in_with_a_slip_is_gone_on_with() -> None:
    statement = (
        "sphere A: mass 2m, velocity u at arccos(12/13)\nsphere B: mass 5m, velocity u j\n"
        "A hits B: along i, e = 3/4\nfind velocity(A)\n"
    )
    lines = (
        "2m(12u/13) = 2mx + 5my",
        "y - x = ¾(12u/13) = 8u/13",
        "24u/13 = 2x + 5x + 40u/13",
        "x = -16u/91",
    )
    assert verdicts(statement, *lines) == ["true", "false", "follows", "follows"]


def test_a_component_of_a_number_times_a_sine_is_a_chain() -> None:
    statement = (
        "wall W: along 5i + 12j\nsphere P: mass 2, velocity 13 i\nP hits W: e = 5/12\n"
        "find along(velocity(P), W)\n"
    )
    marking = restitution.mark(
        solution_of(statement), "tan α = 12/5, α = 67.4\ncomponent along wall = 13 sin α = 12"
    )
    assert [line.verdict for line in marking.lines] == ["true", "false"]
    assert marking.mistakes == ("sine-cosine",)
    right = restitution.mark(
        solution_of(statement), "tan α = 12/5, α = 67.4\ncomponent along wall = 13 cos α = 5"
    )
    assert [line.verdict for line in right.lines] == ["true", "true"]
