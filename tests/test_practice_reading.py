"""What a student types, read: relations, declarations, headings, phrases, and what is none."""

from __future__ import annotations

import functools
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from restitution.expression import write_expression
from restitution.expression.tree import Expression
from restitution.language import parse
from restitution.practice.reading.claims import write_claim
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.phrases import read_phrase
from restitution.practice.reading.working import read_working
from restitution.practice.script import Claim, ScriptLine
from restitution.problem import Problem

SPHERES = """
sphere A: mass 2, velocity 3i - 4j
sphere B: mass 3, velocity 2i + 3j
A hits B: along j, e = 3/7
find velocity(A), velocity(B), impulse
"""
WALLS = """
wall AB: along i
wall BC: along 60°
sphere P: mass m, velocity u at alpha to AB
part a
P hits AB
find speed(P)
part b
P hits BC: e = 1/2
find speed(P)
"""


@functools.cache
def problem(statement: str = SPHERES) -> Problem:
    return parse(statement)


def line(text: str, statement: str = SPHERES) -> ScriptLine:
    (only,) = read_working(text, problem(statement)).lines
    return only


def written(tree: Expression) -> str:
    return write_expression(tree)


def written_claim(claim: Claim) -> str:
    others = "".join(f" or {written(each)}" for each in claim.others)
    return f"{written(claim.left)} {claim.sign} {written(claim.right)}{others}"


def first(text: str, statement: str = SPHERES) -> list[str]:
    """The most natural reading of every link."""
    read = line(text, statement)
    assert read.fault is None, (text, read.fault)
    return [written_claim(link.readings[0]) for link in read.links]


RELATIONS = {
    "CLM: 2x-4 + 3x3 = 2v - 3w": ["2(-4) + 3*3 = 2v - 3w"],
    "NEL: v + w = 3/7 x 7 = 3": ["v + w = 3/7*7", "3/7*7 = 3"],
    "so v = 2, w = 1": ["v = 2", "w = 1"],
    "VA = 3i+2j": ["V_A = 3i + 2j"],
    "|I| = 2(2--4) = 12Ns": ["abs(I) = 2(2 - (-4))", "2(2 - (-4)) = 12"],
    "tanθ = 2/3 => θ = 33.7°": ["tan(theta) = 2/3", "theta = 33.7°"],
    "mucos30 = 3x5cos45": ["m u cos(30°) = 3*5 cos(45°)"],
    "x = ±3": ["x = 3 or -3"],
    "x = 2 or -3": ["x = 2 or -3"],
    "(3i-4j).(3i+2j) = 1": ["dot(3i - 4j, 3i + 2j) = 1"],
    "q = 1/6   p = -1/3": ["q = 1/6", "p = -1/3"],
    "perp after = 8 x 0.75 = 6.4": ["perp after = 8*0.75", "8*0.75 = 6.4"],
    "angle = 90 - tan^-1(3/4)": ["the angle = 90° - arctan(3/4)"],
}


@pytest.mark.parametrize("text", RELATIONS)
def test_a_line_has_the_relations_that_it_states(text: str) -> None:
    assert first(text) == RELATIONS[text]


def test_a_function_behind_a_space_may_go_on_with_a_chain() -> None:
    read = line("k = u sin(a) = √3 u/2", WALLS)
    assert "u sin(alpha) = sqrt(3) u/2" in [written_claim(x) for x in read.links[1].readings]


def test_a_chain_whose_angle_goes_on_is_one() -> None:
    text = "h = u/4 cos(a) - u/2 sin(a) = u (cos(a) - 2sin(a))/4"
    assert first(text, WALLS) == [
        "h = u/4 cos(alpha) - u/2 sin(alpha)",
        "u/4 cos(alpha) - u/2 sin(alpha) = u (cos(alpha) - 2sin(alpha))/4",
    ]


def test_a_number_behind_a_root_is_no_power() -> None:
    (link,) = line("k = √3 u").links
    assert [written_claim(each) for each in link.readings] == ["k = sqrt(3) u"]


def test_a_quotient_has_both_readings() -> None:
    (link,) = line("v = 3u/2m").links
    assert [written_claim(each) for each in link.readings] == ["v = 3u/(2m)", "v = 3u/2 m"]


def test_a_declaration_has_its_meanings() -> None:
    (declaration,) = line("let v = component of A along j after").declarations
    assert declaration.letter == "v"
    assert written(declaration.meanings[0]) == "along(velocity(A), j)"


def test_a_part_and_an_event_open_a_scope() -> None:
    script = read_working("(b)\nat BC: v = 3\nw = 2", problem(WALLS))
    assert [each.kind for each in script.lines] == ["heading", "relations", "relations"]
    assert [each.part for each in script.lines] == ["b"] * 3
    assert script.lines[2].scope.event == 2


@pytest.mark.parametrize(
    ("typed", "parts"),
    [
        ("v = 3\n(b)\nw = 2", ["a", "b", "b"]),
        ("let v be the speed of P\n(b)\nw = 2", ["b", "b", "b"]),
        ("1(a) v = 3\n1(b) w = 2", ["a", "b"]),
        ("Q1. (a) v = 3\nQ1. (b) w = 2", ["a", "b"]),
        ("2(a) = 3\nv = 3", [None, None]),
    ],
)
def test_every_line_is_in_a_part_where_one_is_opened(typed: str, parts: list[str | None]) -> None:
    assert [each.part for each in read_working(typed, problem(WALLS)).lines] == parts


@pytest.mark.parametrize("typed", ["v = 9..76", "v = 9,76", "v = 9.76"])
def test_a_decimal_is_one_number(typed: str) -> None:
    (link,) = line(typed).links
    assert [written_claim(each) for each in link.readings] == ["v = 9.76"]


def test_values_behind_a_comma_are_two() -> None:
    (link,) = line("v = 2, 12").links
    assert [written_claim(each) for each in link.readings] == ["v = 2 or 12"]


def test_what_cannot_be_read_says_where() -> None:
    read = line("v = 3 + = 4")
    assert (read.kind, read.column) == ("unread", 8)
    assert read.fault is not None


def test_too_much_is_answered_with_a_message() -> None:
    read = read_working(["v = 1"] * 70 + ["w = " + "1+" * 200], problem())
    assert read.lines[-1].kind == "unread" and "60 lines" in (read.lines[-1].fault or "")
    assert "200 characters" in (line("v = " + "1+" * 200).fault or "")


def test_a_claim_is_written_in_symbols() -> None:
    (link,) = line("0.2*3 + 0.4*4 = 0.2v + 0.4w").links
    assert write_claim(link.readings[0]) == "0.2 × 3 + 0.4 × 4 = 0.2v + 0.4w"
    assert is_phrase("speed of A") and not is_phrase("v_A")


def test_a_phrase_has_its_quantity() -> None:
    assert written(read_phrase("KE lost", problem())[0]) == "energy_lost"
    assert written(read_phrase("along(velocity(A), i)", problem())[0]) == "along(velocity(A), i)"


# --- whatever is typed ----------------------------------------------------------------------------

PIECES = st.sampled_from(
    [*"uvwmeαβθij0123456789.+-*/^()[]{}|=<>,;:~±√²½'%°_ \t", "sin", "cos", "tan", "sqrt", "KE"]
    + ["speed of A", " after", " so ", " or ", "let ", " x ", "v_A", "=>", "≤", "\\frac{1}{2}"]
    + ["before ", "(a)", "case 1", "m/s", "ms^-1", "10^99", "a", " and ", "impulse", "A", "AB"]
)


@settings(max_examples=150, deadline=None)
@given(st.one_of(st.text(max_size=120), st.lists(PIECES, max_size=40).map("".join)))
def test_any_text_gives_a_script(text: str) -> None:
    for statement in (SPHERES, WALLS):
        script = read_working(text, problem(statement))
        for read in script.lines:
            assert (read.kind == "relations") == bool(read.links) or read.kind == "crossed"
            for link in read.links:
                assert 0 < len(link.readings) <= 24
                assert all(write_claim(each) for each in link.readings[:2])


@settings(max_examples=60, deadline=None)
@given(st.one_of(st.text(max_size=80), st.lists(PIECES, max_size=12).map(" ".join)))
def test_any_words_are_read_or_have_no_meaning(words: str) -> None:
    assert isinstance(read_phrase(words, problem()), tuple)


# --- what seventeen-year-olds type ----------------------------------------------------------------

Typed = tuple[str, str, str, tuple[str, ...]]


def typed_lines() -> list[Typed]:
    """Statement, kind, line and readings of every line of the table, each looked at by a person."""
    typed: list[Typed] = []
    statement, readings = "", []
    for row in (Path(__file__).parent / "typed_lines.txt").read_text().splitlines()[1:]:
        if row == "statement":
            statement, readings = "", []
        elif row.startswith("    ") and not readings and " | " not in row:
            statement += row.strip() + "\n"
        elif " | " in row and not row.startswith(" "):
            kind, text = row.split(" | ", 1)
            typed.append((statement, kind, text, ()))
            readings = [text]
        elif row.startswith("    "):
            typed[-1] = (*typed[-1][:3], (*typed[-1][3], row.strip()))
    return typed


def what_is_read(read: ScriptLine) -> tuple[str, ...]:
    claims = [written_claim(each.readings[0]) for each in read.links]
    declared = [
        f"let {each.letter} = {written(each.meanings[0]) if each.meanings else '?'}"
        for each in read.declarations
    ]
    return (*claims, *declared, *([f"column {read.column}"] if read.fault else []))


def test_lines_as_they_are_typed_are_read() -> None:
    lines = typed_lines()
    assert len(lines) > 550
    wrong = []
    for statement, kind, text, expected in lines:
        read = line(text, statement)
        if (read.kind, what_is_read(read)) != (kind, expected):
            wrong.append((text, read.kind, what_is_read(read), expected))
    assert not wrong


def test_a_line_that_begins_with_its_sign_goes_on() -> None:
    script = read_working("KE lost = 44.5 - 20.5\n= 24\n\nspeed =\n√13", problem())
    links = [link.readings[0] for each in script.lines for link in each.links]
    assert [written_claim(each) for each in links] == [
        "ke lost = 44.5 - 20.5",
        "44.5 - 20.5 = 24",
        "the speed = sqrt(13)",
    ]


def test_an_x_is_a_letter_where_the_script_uses_it_as_one() -> None:
    script = read_working("x + y = 3\n2x - 3y = 1\n3x5 = 15", problem())
    assert written_claim(script.lines[1].links[0].readings[0]) == "2x - 3y = 1"
    assert written_claim(script.lines[2].links[0].readings[0]) == "3*5 = 15"


def test_a_number_beside_an_angle_is_degrees_or_radians() -> None:
    (link,) = line("θ = 0.59").links
    assert [written_claim(each) for each in link.readings] == ["theta = 0.59°", "theta = 0.59"]
    (link,) = line("θ = 0.59 rad").links
    assert [written_claim(each) for each in link.readings] == ["theta = 0.59"]


def test_decimals_know_their_figures_and_their_place() -> None:
    (link,) = line("v = 0.050 + 12.5%").links
    assert [(each.figures, each.half_unit) for each in link.decimals] == [
        (2, Fraction(1, 2000)),
        (3, Fraction(1, 2000)),
    ]
    assert [each.column for each in link.decimals] == [5, 13]
    (whole,) = line("θ = 37").links
    assert [(each.column, each.half_unit) for each in whole.decimals] == [(5, Fraction(1, 2))]


def test_a_crossed_out_line_has_its_relations_and_leaves_no_trace() -> None:
    script = read_working("v = 1\n~~w = 2~~\n= 3", problem())
    assert [each.kind for each in script.lines] == ["relations", "crossed", "relations"]
    assert written_claim(script.lines[2].links[0].readings[0]) == "1 = 3"


def test_cases_are_counted() -> None:
    script = read_working("case 1: v = 1\nw = 2\ncase 2\nv = 3", problem())
    assert [each.scope.case for each in script.lines] == [1, 1, 2, 2]


PHRASES = {
    "component of A along the line of centres after": "along(velocity(A), line_of_centres)",
    "speed of B after the impact": "speed(B)",
    "velocity of A before": "velocity(A, 0)",
    "KE of A before": "energy(A, 0)",
    "KE gained by B": "-(energy(B, 0) - energy(B))",
    "component of A to the left after": "along(velocity(A), -i)",
    "speed of A to the left along i after": "along(velocity(A), -i)",
    "component of A opposite to i after": "along(velocity(A), -i)",
    "speed of B against i after": "along(velocity(B), -i)",
    "velocity of B in the negative j direction": "along(velocity(B), -j)",
    "speed of A downwards along j after": "along(velocity(A), -j)",
    "velocity of B towards A": "-along(velocity(B), line_of_centres)",
    "component of A in the direction of -i after": "along(velocity(A), -i)",
    "component of A along 3i+4j": "along(velocity(A), 3i + 4j)",
    "deflection of A": "deflection(A)",
    "angle to line of centres of A before": "angle(velocity(A, 0), line_of_centres)",
    "perpendicular to line of centres of B after": "across(velocity(B), line_of_centres)",
    "approach": "along(velocity(A, 0) - velocity(B, 0), line_of_centres)",
    "fraction of KE lost": "energy_lost/energy(0)",
    "magnitude of impulse": "impulse",
}
AT_WALLS = {
    "speed after AB": "speed(P, 1)",
    "angle to the wall after": "angle(velocity(P), BC)",
    "angle to AB": "angle(velocity(P, 1), AB)",
    "away from the wall": "-along(velocity(P), line_of_centres)",
    "component parallel to AB": "along(velocity(P, 1), AB)",
    "speed after first impact": "speed(P, 1)",
    "impulse at AB": "impulse(1)",
}


@pytest.mark.parametrize("words", PHRASES)
def test_a_phrase_of_two_spheres_means_first_what_it_says(words: str) -> None:
    assert written(read_phrase(words, problem())[0]) == PHRASES[words]


@pytest.mark.parametrize("words", AT_WALLS)
def test_a_phrase_of_walls_means_first_what_it_says(words: str) -> None:
    assert written(read_phrase(words, problem(WALLS))[0]) == AT_WALLS[words]


def test_words_that_name_nothing_have_no_meaning() -> None:
    assert read_phrase("hello there", problem()) == ()


def test_a_dash_before_a_line_may_be_a_bullet() -> None:
    (link,) = line("- v = 3").links
    assert [written_claim(each) for each in link.readings] == ["-v = 3", "v = 3"]
    assert [len(each.readings) for each in line("-v = 3").links] == [1]


def test_letters_of_the_question_are_no_words() -> None:
    statement = (
        "sphere A: mass 1, velocity u i\nsphere B: mass k, at rest\nA hits B: along i\nfind e"
    )
    assert first("1 - ek = 0", statement) == ["1 - e k = 0"]
    assert first("ke = 1", statement) == ["k e = 1"]
    assert first("KE = 1", statement) == ["the ke = 1"]


def test_the_number_of_an_equation_is_no_factor() -> None:
    assert first("(1) -a = u/8") == ["-a = u/8"]
    assert first("(2)(3) + 3(4) = 18") == ["2*3 + 3*4 = 18"]


@pytest.mark.parametrize(
    ("typed", "readings"),
    [
        ("v = u/3√2 (1-2e)", {"v = (u/(3√2))(1 − 2e)", "v = (u/3)√2(1 − 2e)"}),
        ("v = u/2√2(1-e)", {"v = (u/(2√2))(1 − e)", "v = u/(2√2(1 − e))"}),
    ],
)
def test_a_denominator_may_end_before_brackets(typed: str, readings: set[str]) -> None:
    (link,) = line(typed).links
    assert readings <= {write_claim(claim) for claim in link.readings}


@pytest.mark.parametrize(
    ("typed", "claims"),
    [
        ("v = -2u (v = 2u means no collision)", ["v = −2u"]),
        ("v = -2u, v = 2u impossible", ["v = −2u"]),
        ("v = 3u rejected", []),
        ("e = 1/2 not 2", ["e = ½"]),
        ("e = 1 equal masses so A stops", ["e = 1"]),
        ("1 - 4e < 0, e > 1/4", ["1 − 4e < 0", "e > ¼"]),
        ("comps along 2i-j: A before (12-2)/√5 = 10/√5", ["(12 − 2)/√5 = 10/√5"]),
    ],
)
def test_what_is_said_to_be_impossible_is_not_claimed(typed: str, claims: list[str]) -> None:
    assert [write_claim(link.readings[0]) for link in line(typed).links] == claims


def test_a_line_goes_on_from_the_value_of_a_remark() -> None:
    script = read_working("w = 4v\nafter: mv² + 3/2mw²\n= 2mu²", problem()).lines
    written = [write_claim(claim) for claim in script[2].links[0].readings]
    assert written[0] == "mv² + (3/2)mw² = 2mu²"
    assert "4v = 2mu²" in written


def test_a_letter_of_the_question_before_a_tangent_is_no_inverse() -> None:
    walls = problem(WALLS.replace("find", "given tan(theta) = 3a/u\nfind", 1))
    for typed, claim in (
        ("y = 3atan(theta)", "y = 3a tan θ"),
        ("y = atanθ", "y = a tan θ"),
        ("y = atan(3/4)", "y = arctan(3/4)"),
    ):
        (line_,) = read_working(typed, walls).lines
        assert write_claim(line_.links[0].readings[0]) == claim


def test_a_declared_letter_is_no_alias() -> None:
    alias, own = (
        read_working("tan a = 3/4", problem(WALLS), declared).lines[0] for declared in ((), ("a",))
    )
    assert write_claim(alias.links[0].readings[0]) == "tan α = ¾"
    assert write_claim(own.links[0].readings[0]) == "tan a = ¾"


@pytest.mark.parametrize(
    ("typed", "claims"),
    [
        ("resolve: A 5cos 60 = 2.5, B -3", ["5 cos 60° = 2.5"]),
        ("A 5sin 30 = 2.5 B 4", ["5 sin 30° = 2.5"]),
        ("mass x vel before: A 6i - 8j, B 6i + 9j", []),
        ("j direction: 2v + 3w = 4", ["2v + 3w = 4"]),
        ("v = 2u would give w = -3u", ["w = −3u"]),
        ("mA : mB = 3:4", ["m_A/m_B = ¾"]),
        ("v = 8/3: 1 = 4 - 6x", ["v = 8/3", "1 = 4 − 6x"]),
        ("KE after = 0.36 of it", []),
    ],
)
def test_what_only_announces_is_no_part_of_a_claim(typed: str, claims: list[str]) -> None:
    assert [write_claim(link.readings[0]) for link in line(typed).links] == claims


ENERGIES = """
sphere A: mass m, velocity u i
sphere B: mass 2m, at rest
A hits B: along i, e = 1/2
find energy_lost/energy(0) as a percentage, velocity(A), velocity(B)
"""


@pytest.mark.parametrize(
    ("typed", "claims"),
    [
        ("energy lost/initial energy = 50%", ["energy lost/(initial energy) = 0.5"]),
        ("KE i = 1/2mu^2, KE f = 1/4mu^2", ["initial KE = ½mu²", "final KE = ¼mu²"]),
        ("KEi = 1/2mu^2, KEf = 1/4mu^2", ["KE before = ½mu²", "KE after = ¼mu²"]),
        ("KE1 - KE2 = 1/4mu^2", ["E₁ − E₂ = ¼mu²"]),
        ("gain = -1/4mu^2", ["the gain = −¼mu²"]),
        ("lost 1/4 out of 1/2 = 50%", ["the lost = (1/4)/(1/2)", "(1/4)/(1/2) = 0.5"]),
        ("50%", ["the percentage = 0.5"]),
        ("1 - 0.707² = 0.5 so 50%", ["1 − 0.707² = 0.5", "the percentage = 0.5"]),
        ("so 50% of the KE is lost", ["percentage lost = 0.5"]),
    ],
)
def test_energies_and_their_shares_are_read(typed: str, claims: list[str]) -> None:
    read = line(typed, ENERGIES)
    assert [write_claim(link.readings[0]) for link in read.links] == claims


def test_a_percentage_may_be_worked_out_in_hundredths() -> None:
    (label, _) = line("lost = 100 - 38.5 = 61.5%", ENERGIES).links
    assert "the lost = (100 − 38.5)/100" in [write_claim(each) for each in label.readings]


def test_what_stands_in_the_chain_of_a_body_may_be_of_that_body() -> None:
    *_, link = line("KE B = 1/4mu^2 > 0 = KE before", ENERGIES).links
    assert [written(each.right) for each in link.readings] == ["ke before", "ke before of B"]


def test_an_at_is_an_angle_where_it_stands_in_a_function() -> None:
    script = read_working("vcosa = ucos@\nat 3 @ 2", problem(WALLS))
    assert write_claim(script.lines[0].links[0].readings[0]) == "v cos α = u cos α"
    script = read_working("vcosa = 3 @ 2", problem(WALLS))
    assert "@" not in str(script.lines[0].links)


def test_a_dash_behind_the_letter_of_a_sphere_belongs_to_it() -> None:
    script = read_working("2va + 3vb = 1\n4vb' - va' = 2", problem())
    assert write_claim(script.lines[1].links[0].readings[0]) == "4v_B' − v_A' = 2"


@pytest.mark.parametrize(
    ("typed", "read"),
    [
        ("4 = 2a + b\na = 1, b = 2\nva = i + j, vb = 2i", "v_A = i + j"),  # v is no letter there
        ("v = 3, w = 2\nvb = 2i, va = 3i", "v_B = 2i"),
        ("v = 3, b = 2\nvb = 6, va = 3a", "v b = 6"),  # both are letters, and so a product
        ("u = 3, w = a\nua + ub = 5", "u a + u b = 5"),
    ],
)
def test_two_small_letters_are_a_name_where_no_product_is_meant(typed: str, read: str) -> None:
    *_, last = read_working(typed, problem()).lines
    assert written_claim(last.links[0].readings[0]) == read


def test_the_label_of_a_part_is_no_letter_of_the_working() -> None:
    parts = problem(SPHERES.replace("find", "part a\nfind", 1) + "\npart b\nfind energy_lost")
    script = read_working("(a)\nv = 3, w = 1\n(b)\nva = 3i, vb = i", parts)
    assert written_claim(script.lines[-1].links[0].readings[0]) == "v_A = 3i"


def test_a_share_may_end_the_chain_of_what_is_lost() -> None:
    *_, link = line("KE lost = 16 - 13 = 3J = 18.75%", ENERGIES).links
    assert "percentage lost = 0.1875" in [write_claim(each) for each in link.readings]


def test_an_angle_to_one_wall_is_none_to_another_that_is_asked() -> None:
    corner = parse("""wall AB: along i
wall BC: along 60°
sphere P: velocity 12 at 45° to AB
P hits AB: e = 1/2
find angle(velocity(P, 1), AB)
P hits BC: e = 2/3
find speed(P)""")
    for wall, other in (("AB", "BC"), ("BC", "AB")):
        meant = [write_expression(each) for each in read_phrase(f"angle with {wall}", corner)]
        assert any(wall in each for each in meant)
        assert not any(other in each for each in meant)
