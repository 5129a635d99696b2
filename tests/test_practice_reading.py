"""What a student types, read: relations, declarations, headings, phrases, and what is none."""

from __future__ import annotations

import functools

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from restitution.expression import write_expression
from restitution.expression.tree import Expression
from restitution.language import parse
from restitution.practice.claims import write_claim
from restitution.practice.phrases import is_phrase, read_phrase
from restitution.practice.script import Claim, ScriptLine
from restitution.practice.working import read_working
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
