"""Shorthand of students' lines: arrows, cases, counted quantities, one letter for two bodies."""

from __future__ import annotations

import pytest
from marked import solution_of, verdicts

import restitution

WALL = "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\nfind velocity(P)\n"
CORNER = (
    "wall W: along i\nwall X: along j\nsphere P: mass m, velocity u at 30° to W\n"
    "P hits W: e = 1/2\nP hits X: e = 1/3\nfind angle(velocity(P, 0), velocity(P))\n"
)
OUT = (
    "wall W: along i\nsphere P: velocity 10 at 40° to W\nP hits W\n"
    "given angle(velocity(P), W) = 25°\nfind e, speed(P)\n"
)
LOSSES = (
    "wall W: along i\nwall X: along j\nsphere P: mass m, velocity u at alpha to W\nP hits W\n"
    "P hits X\ngiven 0 < e < 1\nshow energy_lost(1)/energy_lost(2) = tan^2(alpha)\n"
)
SLANTED = (
    "sphere A: mass 3, velocity 4i - 3j\nsphere B: mass 2, velocity i + 2j\n"
    "A hits B: along i - j, e = 1/2\nfind velocity(A), velocity(B)\n"
)
TURNED = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass 4m, at rest\nA hits B: along i\n"
    "given deflection(A) = 90°\nfind range of alpha\n"
)
KICK = (
    "sphere P: mass 1/2, velocity 6i\nP receives lambda (i + 2j)\ngiven speed(P) = 10\n"
    "find lambda\n"
)
RELATIVE = (
    "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, at rest\nA hits B: along i\n"
    "given abs(velocity(A) - velocity(B)) = 9/10 u\nfind e\n"
)
ANGLES = (
    "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 3/4\n"
    "let beta = angle(velocity(P), W)\ngiven alpha + beta = 60°\nfind tan(alpha)\n"
)
TIMES = (
    "wall W: along i, through (0, 0)\npoint Q: (9, 2)\n"
    "sphere P: at (0, 4), velocity V at alpha to W\n"
    "P hits W\nP reaches Q\ngiven time(2) = 3 time(1)\nfind e, tan(alpha)\n"
)
MET = (
    "sphere A: mass 1, at (0, 0), velocity 4i, radius 1\n"
    "sphere B: mass 1, at (10, 6/5), at rest, radius 1\nA hits B: e = 1/2\n"
    "find time(1), velocity(A), velocity(B)\n"
)
TWO = (
    "sphere A1: mass M, velocity v at phi\nsphere A2: mass 2M, at rest\n"
    "A1 hits A2: along i\nfind energy_lost/energy(0)\n"
)


@pytest.mark.parametrize(
    ("statement", "line", "verdict"),
    [
        (OUT, "(∥) v cos25 = 10cos40", "true"),
        (OUT, "(⟂) v sin25 = 10e sin40", "true"),
        (OUT, "(perpendicular to W) v sin25 = 10sin40", "false"),
        (OUT, "(÷) tan 25 = e tan 40", "true"),
        (OUT, "(+) v cos25 + v sin25 = 10cos40 + 10e sin40", "true"),
        (WALL, "perp: 4 → 2", "true"),
        (WALL, "perp: 4 → 3", "false"),
        (WALL, "KE 25 → 13, so 12 lost", "true"),
        (WALL, "KE 25 → 12, so 13 lost", "false"),
        (CORNER, "perp to W: usin30 → 0.5u", "true"),
        (CORNER, "angle between first and last velocities = 169.1°", "true"),
        (CORNER, "angle between first and last velocities = 159.1°", "false"),
        (CORNER, "angle between u and v = 169.1°", "true"),
        (CORNER, "deflection 1 = 30 + 16.1 = 46.1", "true"),
        (CORNER, "deflection 2 = 30 + 16.1 = 46.1", "false"),
        (CORNER, "after W: u(cos30i + ½sin30j) = 0.866ui + 0.25uj", "true"),
        (LOSSES, "ratio = sin²α(1 - e²)/cos²α(1 - e²) = tan²α", "true"),
        (LOSSES, "ratio = cos²α/sin²α", "false"),
        (SLANTED, "A: u.n = 7/√2, B: u.n = -1/√2", "true"),
        (SLANTED, "A: u.n = 7/√2, B: u.n = 1/√2", "asks"),
        (SLANTED, "mom in i direction check: 12 + 2 = 14", "true"),
        (TURNED, "e = 1 gives tan²α = 3/5", "true"),
        (TURNED, "e = 1 gives tan²α = 4/5", "false"),
        (KICK, "Δv = 2λi + 4λj", "true"),
        (KICK, "Δv = 2λi + 2λj", "false"),
        (RELATIVE, "rel vel perp = usin60 = 0.866u", "true"),
        (RELATIVE, "rel vel perp = ucos60 = 0.5u", "false"),
        (RELATIVE, "comps of u: ucos60 and usin60", "remark"),
        (TIMES, "across: Vcosα × 3t1 = 9", "true"),
        (MET, "t = 8.4/4 = 2.1s", "true"),
    ],
)
def test_shorthand_is_read_as_it_is_meant(statement: str, line: str, verdict: str) -> None:
    assert verdicts(statement, line) == [verdict]


def test_t_may_be_a_tangent_without_a_declaration() -> None:
    above = ["tanβ = ¾tanα", "tan(α + β) = √3"]
    assert verdicts(ANGLES, *above, "1.75t/(1 - 0.75t²) = 1.732", "t = 0.663")[2:] == ["true"] * 2


def test_nothing_is_said_of_what_goes_on_from_an_unread_line() -> None:
    above = "v₁ = ⅓(1 - 2e)v cosφ"
    said = verdicts(TWO, above, "lost/initial = [1 - ((", "= ⅔(1 - e²)cos²φ = ⅔cos²φ - ⅔e²cos²φ")
    assert said[1:] == ["unread", "true"]


def test_vectors_do_not_go_on_from_a_speed() -> None:
    lines = ["speed after = √13 = 3.61", "= 3i + 2j = i + 2j + 2i"]
    assert verdicts(WALL, *lines) == ["true", "true"]


def test_a_subscript_ends_before_the_next_letter() -> None:
    lines = ["vcosφ = v1 + 2v2", "v2 - v1 = evcosφ", "loss = ½M(vcosφ)^2 - ½M1v1^2 - Mv₂²"]
    assert verdicts(TWO, *lines)[:2] == ["true", "true"]
    assert verdicts(TWO, *lines[:2], "loss = ½M(vcosφ)² - ½Mv₁² - Mv₂²")[2] == "true"


def test_what_holds_in_a_case_defines_no_letter() -> None:
    assert "false" not in verdicts(TWO, "e = 1: v₁ = -⅓vcosφ", "e = 0: v₁ = ⅓vcosφ")


LIGHT = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"
    "given energy(B) = energy(A)\nfind tan(alpha) in terms of e, k\n"
)
RIGHT = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"
    "given deflection(A) = 90°\nshow tan(alpha)^2 = (k e - 1)/(1 + k)\n"
)
LEAST = (
    "sphere A: mass m, velocity u at 60°\nsphere B: mass 2m, at rest\nA hits B: along i\n"
    "find minimum of speed(A) over e, maximum of speed(A) over e\n"
)
STRUCK = (
    "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\n"
    "P receives -8i - 12j\nP hits W: e = 1/2\nfind velocity(P)\n"
)
ENERGY = (
    "wall W: along theta\nsphere P: mass m, velocity u j\nP hits W\n"
    "given energy(P) = (1/2) energy(P, 0)\nfind e in terms of theta\n"
)
LAWS = ["ucosα = v + kw", "w - v = eucosα"]


@pytest.mark.parametrize(
    ("statement", "above", "line", "verdict"),
    [
        (
            LIGHT,
            [*LAWS, "w = ucosα(1 + e)/(k + 1)", "v = ucosα(1 - ke)/(k + 1)", "kw² = v²"],
            "k(1 + e)² = (1 - ke)²",
            "follows",
        ),
        (
            LIGHT,
            [*LAWS, "w = ucosα(1 + e)/(k + 1)", "v = ucosα(1 - ke)/(k + 1)", "kw² = v²"],
            "k(1 + e) = (1 - ke)²",
            "false",
        ),
        (RIGHT, [*LAWS, "v = (1 - ke)ucosα/(1 + k)", "v = 0"], "ke = 1", "follows"),
        (RIGHT, [*LAWS, "v = (1 - ke)ucosα/(1 + k)", "v = 0"], "ke = 2", "false"),
        (LEAST, ["v + 2w = ½u", "w = v + ½eu"], "3v + ½eu = ½u", "false"),
        (LEAST, ["v + 2w = ½u", "w = v + ½eu"], "3v + eu = ½u", "true"),
        (STRUCK, ["W: v = 3i + 2j", "kick: v = -5i - 10j"], "W again: -5i + 5j", "follows"),
        (STRUCK, ["W: v = 3i + 2j", "kick: v = -5i - 10j"], "W again: -5i + 4j", "false"),
        (ENERGY, ["along wall ucosθ"], "perp to wall after = eusinθ", "follows"),
    ],
)
def test_what_follows_is_no_further_mistake(
    statement: str, above: list[str], line: str, verdict: str
) -> None:
    assert verdicts(statement, *above, line)[-1] == verdict


HALF = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
    "A hits B: along i, e = 1/3\nlet phi = angle(velocity(A), line_of_centres)\n"
    "given phi = 90° - alpha\nfind tan(alpha)\n"
)
TWICE = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"
    "given deflection(A) = alpha\nfind k in terms of e, alpha\n"
)
BLOW = (
    "sphere A: mass 2, velocity p i - j\nsphere B: mass 4, velocity i + q j\n"
    "A hits B: along 3i + 4j, e = 1/2\ngiven impulse(B) = 6i + 8j\n"
    "given velocity(A) parallel to j\nfind p, q\n"
)
SLOPE = (
    "wall W: along i - j\nsphere P: velocity v at theta\nP hits W: e = 1/3\n"
    "given velocity(P) = 4i, 0 < theta < 360°\nfind v, theta\n"
)


@pytest.mark.parametrize(
    ("statement", "above", "line", "name"),
    [
        (HALF, ["3 tan² α = 1"], "tan α = 1/3", None),
        (TWICE, ["v = ucosα(1 - ke)/(1 + k)"], "tanα = usinα/v", "deflection-is-after"),
        (BLOW, [], "v_A = (p + 3, 3)", "impulse-sign"),
    ],
)
def test_a_mistake_has_its_own_name_or_none(
    statement: str, above: list[str], line: str, name: str | None
) -> None:
    marking = restitution.mark(solution_of(statement), "\n".join([*above, line])).json()
    mistake = marking["lines"][-1]["mistake"]
    assert marking["lines"][-1]["verdict"] == "false"
    assert mistake["id"] == name


def test_that_a_component_stays_may_be_shown_by_saying_so() -> None:
    statement = (
        "wall W: along j\nsphere P: velocity u at alpha to W\nP hits W\n"
        "let beta = angle(velocity(P), W)\nshow speed(P) cos(beta) = u cos(alpha)\n"
    )
    assert verdicts(statement, "component along the wall does not change: Vcosβ = ucosα") == [
        "true"
    ]


def test_a_value_behind_a_heading_of_a_moment_is_of_that_moment() -> None:
    found = restitution.mark(solution_of(SLOPE), "before: perp = 3 × 2.83 = 8.49").json()
    assert found["lines"][0]["verdict"] == "true"
    assert found["lines"][0]["read_as"].startswith("the perp before")
    assert verdicts(SLOPE, "after: perp = 8.49") == ["false"]


TURN = (
    "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\nA hits B: along i\n"
    "given tan(alpha) = 1/2, deflection(A) > 30°\nfind range of e\n"
)


@pytest.mark.parametrize(
    ("answer", "state"), [("0.340 < e ≤ 1", "earned"), ("e > 0.34", "lost"), ("e > 0.330", "lost")]
)
def test_the_end_of_a_range_may_be_a_decimal(answer: str, state: str) -> None:
    lines = "v = ½(1 - e)ucosα", "tanθ = 2tanα/(1 - e) = 1/(1 - e)", "1/(1 - e) > 1.514", answer
    points = restitution.mark(solution_of(TURN), "\n".join(lines)).json()["marks"]["points"]
    assert points[-1]["state"] == state


@pytest.mark.parametrize(
    ("line", "verdict"),
    [
        ("least when e = 0, v = u/6", "true"),
        ("least when e = 0, v = u/5", "false"),
        ("time = 3u/4 = 0.75u", "remark"),
    ],
)
def test_a_case_before_a_comma_and_a_time_that_counts_from_nowhere(line: str, verdict: str) -> None:
    assert verdicts(LEAST, "v + 2w = ½u", "w = v + ½eu", line)[-1] == verdict


IN_U = (
    "sphere A: mass 3m, velocity 2u i + u j\nsphere B: mass 2m, velocity -u i + 3u j\n"
    "A hits B: along i\nfind velocity(A), velocity(B)\n"
)


@pytest.mark.parametrize(
    "lines",
    [
        ("let u = 5", "3(10) - 2(5) = 3v + 2w", "w - v = 15e", "v = 4 - 6e"),
        ("3(2) - 2 = 3v + 2w where v, w are in terms of u", "w - v = 3e", "v = (4 - 6e)/5"),
    ],
)
def test_a_letter_of_the_question_may_be_taken_for_a_number(lines: tuple[str, ...]) -> None:
    assert set(verdicts(IN_U, *lines)) <= {"true", "remark"}
    wrong = [each.replace("- 2", "+ 2") for each in lines]
    assert "false" in verdicts(IN_U, *wrong)


STRIP = (
    "wall W: along i, through (0, 0)\nwall X: along i, through (0, 2)\n"
    "sphere P: velocity 3i - 4j, at (0, 1)\nP hits W: e = 3/4\nP hits X: e = 1/2\n"
    "find time(1), time(2)\n"
)


def test_the_formula_of_steady_motion_has_no_letters_of_the_script() -> None:
    """The s of ``s = ut`` is no letter, so that behind a number it is a second."""
    lines = "s=ut so 1=4t1, t1=¼s. Then 2 = 3t, t = ⅔ s", "total = 11/12 s"
    assert verdicts(STRIP, *lines) == ["true", "true"]
    assert verdicts(STRIP, "s=ut so 1=4t1, t1=½s") == ["false"]


REACHED = (
    "wall W: along i, through (0, 0)\npoint N: (10, 3)\nsphere P: velocity 4i - 3j, at (0, 3)\n"
    "P hits W: e = 2/3\nP reaches N\nfind velocity(P)\n"
)


def test_a_vector_v_is_the_velocity_after_the_only_event_that_changes_it() -> None:
    assert verdicts(REACHED, "v = 4i + 2j") == ["true"]
    assert verdicts(REACHED, "v = 2.67i + 3j") == ["false"]


GREATEST = (
    "sphere A, B: mass m\nsphere A: velocity u at alpha\nsphere B: at rest\n"
    "A hits B: along i, e = 1/3\nfind maximum of deflection(A) over alpha\n"
)


def test_a_letter_without_a_meaning_may_be_known_where_a_value_is_greatest() -> None:
    lines = "2(1+3t²) - 2t(6t) = 0", "6t² = 2", "tan δ = 1/√3", "max δ = 30°"
    assert verdicts(GREATEST, *lines) == ["true"] * 4
    assert verdicts(GREATEST, lines[0], "6t² = 3") == ["true", "false"]
    slip = lines[0], "2 + 6t² - 12t = 0", "t = 1.816 or 0.184"
    assert verdicts(GREATEST, *slip) == ["true", "false", "follows"]


OBLIQUE = (
    "sphere A: mass 0.17, velocity 3.2 at 28°\nsphere B: mass 0.17, at rest\n"
    "A hits B: along i, e = 0.92\nfind speed(A), speed(B)\n"
)


def test_letters_of_the_data_and_values_from_rounded_equations() -> None:
    """The angle that the question gives in numbers may be θ; 2.83 and 2.60 move v by 2 %."""
    lines = "u cosθ = 2.83", "v + w = 2.83", "w - v = 2.60", "w = 2.715, v = 0.115"
    assert verdicts(OBLIQUE, *lines) == ["true"] * 4
    assert verdicts(OBLIQUE, *lines[:3], "w = 2.715, v = 0.135")[-1] == "false"


RANGED = (
    "sphere A: mass m, velocity 3u i\nsphere B: mass k m, at rest\nA hits B: along i, e = 1/2\n"
    "given along(velocity(A), i) < 0\nfind range of k\n"
)
UNASKED = (
    "sphere A: mass m, velocity 3u i + 4u j\nsphere B: mass 5/4 m, velocity u i\n"
    "A hits B: along j, e = e\nfind along(velocity(A), j)\n"
)


def test_what_an_inequality_leads_to_is_claimed_under_it_alone() -> None:
    """Behind *if v < 0* nothing is false where nobody knows that v is negative, or what v is."""
    for line in ("if v < 0 → 5e > 4 → e > 4/5", "if v < 0 then 4 - 5e < 0 so e > 4/5"):
        assert verdicts(UNASKED, line) == ["remark"]
    for line in ("reversed if v<0 → 2 - k < 0 → k > 2", "A bounces back when k > 2 (heavy B)"):
        marking = restitution.mark(solution_of(RANGED), line).json()
        assert marking["lines"][0]["verdict"] == "true"
        assert marking["marks"]["earned"] == marking["marks"]["of"]
    assert verdicts(RANGED, "A is positive when k < 2") == ["remark"]


def test_what_stands_before_the_mistake_of_a_line_keeps_its_credit() -> None:
    parts = RANGED.replace("given", "part a\nfind along(velocity(A), i)\npart b\ngiven")
    marking = restitution.mark(solution_of(parts), "2 - k < 0 → k < 2", part="b").json()
    states = {each["for"]: each["state"] for each in marking["marks"]["points"]}
    assert states == {"the condition used": "earned", "correct answer": "lost"}


CHAIN = (
    "sphere A: mass 2m, velocity 3u i\nsphere B: mass m, at rest\nsphere C: mass 3m, at rest\n"
    "A hits B: along i, e = 1/2\nB hits C: along i, e = 1/2\nshow A and B collide again\n"
)
NUMBERS = (
    "sphere A: mass 3, velocity 4i + 2j\nsphere B: mass 2, velocity -i - j\n"
    "A hits B: along i, e = 2/5\nfind velocity(A), velocity(B)\n"
)


def test_relations_and_words_that_only_blanks_part() -> None:
    assert verdicts(CHAIN, "yes, as 1.5u > -0.375u A catches B") == ["true"]
    lines = "3x4 + 2x1 = 3a+2b", "b-a = 2", "14 = 5a + 4 a = 2 b = 4"
    assert verdicts(NUMBERS, *lines) == ["false", "true", "follows"]
    assert verdicts(CHAIN, "2(3u) = 2v + w", "w - v = 1.5u", "2w = 6u w = 3u") == ["true"] * 3


BACK = (
    "wall W: along j, through (3, 0)\nsphere A: mass 2, velocity 4i, at (-1, 0)\n"
    "sphere B: mass 1, at rest, at (0, 0)\nA hits B: along i, e = 1/2\nB hits W: e = 1/2\n"
    "B hits A\nfind along(position(B, 3), i)\n"
)


def test_moments_at_a_wall_gaps_and_places_of_two() -> None:
    assert verdicts(BACK, "speed of B after wall = 4") == ["false"]
    assert verdicts(BACK, "speed of B after hitting the wall = 2") == ["true"]
    for line in ("distance is 3 so x = 2.25", "gap = 3 so x = 2.25"):
        assert verdicts(BACK, line) != ["false"]  # that to the wall, where B was struck
    lines = "A has gone 2 x ¾ = 1.5", "gap 1.5, closing speed 4, t = 3/8", "x = 3 - 2(3/8) = 2.25"
    marking = restitution.mark(solution_of(BACK), "\n".join(lines)).json()
    assert [line["verdict"] for line in marking["lines"]] == ["true"] * 3
    assert marking["marks"]["earned"] == marking["marks"]["of"]


RAILS = (
    "wall W: along i, through (0, 0)\nwall X: along i, through (0, 3)\n"
    "sphere P: velocity 2i - 6j, at (0, 1)\nP hits W: e = 1/2\nP hits X: e = 1/3\n"
    "find time(1), time(2)\n"
)


def test_units_of_speeds_are_no_letters_and_t1_is_the_first_time() -> None:
    lines = "1 m to W at 6 m/s: t = 1/6 s", "rebounds at 3, 3m to go so t = 1s", "total time 7/6 s"
    marking = restitution.mark(solution_of(RAILS), "\n".join(lines)).json()
    assert marking["marks"]["earned"] == marking["marks"]["of"]
    assert verdicts(RAILS, "speed = √(4+36) = 6.32 so t1 = 1/6.32 = 0.158") == ["false"]


TAPPED = (
    "wall W: along j\nsphere P: mass 3, velocity i - 2j\nP receives 6i + 9j\n"
    "P hits W: e = 2/3\nfind speed(P), energy_lost\n"
)


def test_a_vector_v_behind_a_blow_and_one_impact_is_the_velocity_that_is_asked() -> None:
    assert verdicts(TAPPED, "v after = -3i + ⅔j") == ["false"]
    assert verdicts(TAPPED, "v = -2i + j") == ["true"]
    assert verdicts(TAPPED, "v = 3i + j") == ["true"]


HEAD_ON = (
    "sphere A: mass 2, velocity 4i + j\nsphere B: mass 5, velocity -3i + 2j\n"
    "A hits B: along i, e = 3/5\n"
)
AT_SIXTY = (
    "wall W: along i\nsphere P: mass m, velocity u at 60° to W\nP hits W\n"
    "given angle(velocity(P), W) = 45°\n"
)
AT_SIX = (
    "wall W: along j, through (6, 0)\nsphere P: velocity 3i + 2j, at (0, 0)\nP hits W: e = 1/3\n"
)


@pytest.mark.parametrize(
    ("statement", "line"),
    [
        (f"{HEAD_ON}find impulse\n", "I = 2(-4i+j) - 2(4i+j) = -16i so 16"),
        (f"{HEAD_ON}find speed(A), speed(B)\n", "speeds: A √(16+1) = 4.12, B √(0.2²+2²) = 2.01"),
        (f"{AT_SIXTY}find energy_lost/energy(0)\n", "v² = u²/2 so half the KE is lost"),
        (f"{AT_SIXTY}find energy_lost/energy(0)\n", "1 - ¼ - ¼ = ½ lost"),
        (f"{HEAD_ON}find speed(A), speed(B)\n", "4.12, 2.01 m/s"),
        (f"{HEAD_ON}find deflection(B)\n", "62.0°"),
    ],
)
def test_answers_in_sentences_and_lists(statement: str, line: str) -> None:
    marking = restitution.mark(solution_of(statement), line).json()
    assert {one["verdict"] for one in marking["lines"]} <= {"true", "remark"}
    assert marking["marks"]["earned"] == marking["marks"]["of"]


def test_a_share_that_is_not_lost_and_a_place_that_is_no_velocity() -> None:
    share = f"{AT_SIXTY}find energy_lost/energy(0)\n"
    assert verdicts(share, "so a third of the KE is lost") == ["false"]
    assert verdicts(share, "1 - e² = 1 - ⅓ = ⅔ lost") == ["false"]
    assert verdicts(f"{AT_SIX}find position(P, at 5)\n", "at wall (6,4)") == ["remark"]


def test_letters_of_the_book_for_impulses_velocities_and_speeds() -> None:
    known = (
        "sphere A: mass 3, velocity 4i + 2j\nsphere B: mass 5, velocity -i\nA hits B\n"
        "given velocity(A) = i - 2j\nfind velocity(B)\n"
    )
    assert verdicts(known, "12i + 6j + 5i = 3i - 6j + 5v") == ["false"]
    assert verdicts(f"{HEAD_ON}find impulse\n", "I = 2(4 - 4) = 0") != ["true"]
    square = (
        "wall W: along i\nsphere P: mass m, velocity u at 60° to W\nP hits W\n"
        "show speed(P)^2 = (1 + 3e^2)u^2/4\n"
    )
    assert verdicts(square, "v² = u²cos²60 + e u²sin²60") == ["false"]


def test_a_name_of_an_earlier_part_keeps_its_meaning() -> None:
    statement = (
        "sphere A: mass m, velocity u at alpha\nsphere B: mass 2m, at rest\npart a\n"
        "A hits B: along i\nlet beta = angle(velocity(A), i)\n"
        "show tan(beta) = 3 tan(alpha)/(1 - 2e)\n"
        "part b\ngiven e = 1/4, tan(alpha) = 1/2\nfind deflection(A)\n"
    )
    lines = ["tan β = 3(1/2)/(1/2) = 3", "β = 71.6°", "tan β = 2"]
    found = restitution.mark(solution_of(statement), lines, part="b").json()
    assert [line["verdict"] for line in found["lines"]] == ["true", "true", "false"]
