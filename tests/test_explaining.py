"""Lines as text and as JSON, lines from anyone traced to moves, and derivations on paper."""

from __future__ import annotations

import json
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from derivations import FOLDER, derivation_of, oracle_of, read_derivation

from restitution.errors import StatementError
from restitution.explaining.data.facts import facts_of
from restitution.explaining.definitions.at_events import WORKED_OUT
from restitution.explaining.following.follower import follow
from restitution.explaining.following.tracing import Tracer, explain_line
from restitution.explaining.laws.principles import RECORDS
from restitution.explaining.lines.algebra import World
from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Meaning,
    Move,
    Relation,
    whole_of,
)
from restitution.explaining.lines.notation import (
    read_meaning,
    read_relation,
    read_tree,
    write_meaning,
    write_relation,
)
from restitution.explaining.lines.quotients import (
    NotComparableError,
    one,
    product,
    quotient_ring,
    total,
)
from restitution.explaining.lines.sentences import SENTENCES
from restitution.explaining.lines.storing import from_json, to_json
from restitution.language.reading import parse
from restitution.oracle.roles import ACUTE, POSITIVE
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.document import (
    to_html,
    to_latex,
    to_markdown,
    to_text,
    to_typst,
)

NAMES = {"A": "sphere", "B": "sphere", "W": "wall"}
FILES = sorted(FOLDER.glob("*.txt"))


# --- notation -------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text",
    [
        "tan(beta) = U sin(alpha)/v = 3tan(alpha)/(2 - e) [put]",
        "t = 1/sqrt(3) or t = -1/sqrt(3)",
        "sin(alpha) = 3/5 and cos(alpha) = 4/5",
        "1/2 < e <= 1",
        "x ≈ 3.993",
        "e != 0",
        "restitution(1) = 1/2",
        "velocity(A, 1) perpendicular to velocity(A, 0)",
        "line_of_centres(1) parallel to 3i + 4j",
        "along(velocity(A, 1), W) = -2u",
    ],
)
def test_a_relation_reads_back_as_it_was_written(text: str) -> None:
    relation = read_relation(text, NAMES)
    assert write_relation(relation) == text
    assert read_relation(write_relation(relation), NAMES) == relation


@pytest.mark.parametrize(
    "text",
    [
        "let v = along(velocity(A, 1), line_of_centres(1))",
        "let vector R = impulse(A, 1)",
        "let v = along(velocity(A, 1), i) in the sense of -i",
        "let beta = angle(velocity(A, 1), W) as an acute angle",
    ],
)
def test_a_meaning_reads_back_as_it_was_written(text: str) -> None:
    meaning = read_meaning(text, NAMES)
    assert write_meaning(meaning) == text
    assert read_meaning(write_meaning(meaning), NAMES) == meaning


@pytest.mark.parametrize(
    ("chain", "whole"),
    [
        ("a = b = c", "a = c"),
        ("a < b = c", "a < c"),
        ("a = b < c", None),
        ("a = b and a = c", None),
    ],
)
def test_a_chain_says_what_its_ends_are_to_each_other(chain: str, whole: str | None) -> None:
    expected = None if whole is None else read_relation(whole, NAMES).only[0]
    assert whole_of(read_relation(chain, NAMES).only) == expected


def test_no_equation_comes_of_a_chain_that_begins_with_less() -> None:
    problem = parse("sphere A: mass 1, velocity v i\ngiven v < 3\nfind speed(A)")
    working = """
1 a | fact | given 1 | v < 3 = 6/2 [rearrange]
2 a | rearrange | 1 | {}
a: 2 v < 3
"""
    for line, refused in (("v = 3", True), ("2v < 6", False)):
        derivation = derivation_of(problem, working.format(line))
        told = [str(each) for each in follow(derivation, oracle_of(problem))]
        assert ("line 2: does not follow" in told) == refused, told


@pytest.mark.parametrize("text", ["v", "2 + ", "let 3 = v", "a == b", ""])
def test_what_is_no_relation_is_an_error(text: str) -> None:
    with pytest.raises(StatementError):
        read_relation(text, NAMES)


def test_statements_know_no_quantity_of_lines() -> None:
    with pytest.raises(StatementError):
        parse("sphere A: mass 1, velocity i\nfind restitution(1)")


# --- trees that are compared ----------------------------------------------------------------------


def same(left: str, right: str, *identities: str) -> bool:
    """Whether two texts are one quotient of polynomials."""
    roles = {"alpha": ACUTE, "theta": ACUTE, "u": POSITIVE, "m": POSITIVE}
    angles = frozenset({"alpha", "theta"})
    world = World(roles, angles=angles, identities=frozenset(identities))  # type: ignore[arg-type]
    a, b = (read_tree(each, {}) for each in (left, right))
    world.divide_angles([a, b])
    gap = world.scalar(a) - world.scalar(b)
    return world.reduced(gap).vanishes


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ("tan(alpha)", "sin(alpha)/cos(alpha)"),
        ("sqrt(12)", "2 sqrt(3)"),
        ("sqrt(8 u^2)", "2 sqrt(2) u"),
        ("1/sqrt(3)", "sqrt(3)/3"),
        ("cos(60°)", "1/2"),
        ("sin(75°)", "(sqrt(6) + sqrt(2))/4"),
        ("cos(50°)", "sin(40°)"),
        ("sin(-alpha)", "-sin(alpha)"),
        ("cos(arctan(3/4))", "4/5"),
        ("abs(3i - 4j)", "5"),
        ("dot(2i + 7j, -18i - 24j)", "-204"),
    ],
)
def test_equal_trees_are_the_same(left: str, right: str) -> None:
    assert same(left, right)


@pytest.mark.parametrize(
    ("left", "right", "identity"),
    [
        ("sin^2(alpha) + cos^2(alpha)", "1", "pythagoras"),
        ("sin(2theta)", "2 sin(theta) cos(theta)", "double-angle"),
        ("tan(2theta)", "2tan(theta)/(1 - tan^2(theta))", "double-angle"),
        ("cos(alpha)", "2cos^2(alpha/2) - 1", "half-angle"),
        ("sin(alpha + theta)", "sin(alpha) cos(theta) + cos(alpha) sin(theta)", "sum"),
        ("sin(90° - alpha)", "cos(alpha)", "complement"),
    ],
)
def test_identities_hold_only_where_they_are_named(left: str, right: str, identity: str) -> None:
    assert not same(left, right)
    assert same(left, right, identity)


def test_products_and_sums_of_polynomials_are_those_of_sympy():
    x, y, z = quotient_ring().gens[:3]
    numbers = [one() * 0, one(), one() * 2, one() * Fraction(-1, 3)]
    own = [*numbers, x, x - y, x + y, x * y / 2 - z, (x + y) ** 3 - z]
    for a in own:
        for b in own:
            assert product(a, b) == a * b, (a, b)
            assert total(a, b) == a + b, (a, b)
            assert all(product(a, b).values()) and all(total(a, b).values()), (a, b)
    assert one() == quotient_ring().one  # as none of them wrote into it


def test_products_of_many_terms_are_those_of_sympy() -> None:
    x, y, z = quotient_ring().gens[:3]
    many = (x + Fraction(2, 3) * y - z / 5 + Fraction(7, 4)) ** 4
    less = (x - Fraction(2, 3) * y + Fraction(1, 6)) ** 6
    assert len(many) * len(less) > 256
    assert product(many, less) == many * less
    assert product(many, many - many) == quotient_ring().zero
    opposite = product(many, less - x) + product(many, x)  # terms that cancel are left out
    assert opposite == product(many, less)


def test_what_cannot_be_compared_is_told_apart() -> None:
    world = World({})
    for text in ("2^u", "u^(1/3)", "1/(u - u)", "i/j"):
        with pytest.raises(NotComparableError):
            world.value(read_tree(text, {}))


# --- facts ----------------------------------------------------------------------------------------


def test_facts_are_made_of_the_statement_alone() -> None:
    problem = parse(
        "wall W: along i\nsphere P: mass 2, velocity 3i - 4j\nP hits W: e = 1/2\n"
        "part a\ngiven speed(P) < 4\nfind speed(P)\npart b\ngiven P at rest\nfind e"
    )
    told = {each.id: (write_relation(each.relation), each.part) for each in facts_of(problem)}
    assert told == {
        "mass P": ("mass(P) = 2", None),
        "velocity P": ("velocity(P, 0) = 3i - 4j", None),
        "wall W": ("direction(W) parallel to i", None),
        "e 1": ("restitution(1) = 1/2", None),
        "axis 1": ("line_of_centres(1) = -j", None),
        "given 1": ("speed(P, 1) < 4", "a"),
        "given 2": ("velocity(P, 1) = (0, 0)", "b"),
    }


def test_records_know_what_they_need_and_what_is_said_of_them() -> None:
    momentum = RECORDS["momentum"]
    assert momentum.needs == {"along", "line_of_centres", "mass", "velocity"}
    wall, spheres = Event(1, "impact", ("A", "W"), True), Event(1, "impact", ("A", "B"))
    assert (RECORDS["unchanged"].topic(wall), RECORDS["unchanged"].topic(spheres)) == (
        "unchanged-wall",
        "unchanged",
    )
    for record in RECORDS.values():
        for event in (wall, spheres):
            topic = record.topic(event)
            if record.serves(event) and topic is not None:
                assert SENTENCES[f"{topic}.why"]
                assert SENTENCES[f"{topic}.mistakes"]
    for record in RECORDS.values():
        if record.kind == "principle":
            assert record.gives
            if record.id not in WORKED_OUT:
                assert record.templates
                assert record.needs


# --- JSON -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_json_reads_back(path: Path) -> None:
    """What is read back is equal, so that the follower says of it what it says of the first."""
    _, derivation = read_derivation(path)
    text = json.dumps(to_json(derivation))
    assert from_json(json.loads(text)) == derivation


def test_json_that_is_no_derivation_is_refused() -> None:
    _, derivation = read_derivation(FOLDER / "unknown-wall.txt")
    whole = to_json(derivation)
    for spoiled in (
        {},
        {**whole, "version": 9},
        {**whole, "lines": [{**whole["lines"][0], "move": "guess"}]},
        {**whole, "lines": [{**whole["lines"][1], "text": "R = )"}]},
    ):
        with pytest.raises(StatementError):
            from_json(spoiled)


# --- lines from anyone ----------------------------------------------------------------------------


def traced(path: Path) -> list[tuple[int, Move, object]]:
    """Each line of a working by hand, its own move, and what it is traced to."""
    problem, derivation = read_derivation(path)
    tracer = Tracer(replace(derivation, lines=()), oracle_of(problem))
    found = []
    for line in derivation.lines:
        if isinstance(line.relation, Relation):
            found.append((line.number, line.move, tracer.trace(line.relation)))
        tracer.add(line.number, line.relation)
    return found


SIX = [
    "show-tangent",
    "half-angle",
    "right-angle",
    "unknown-wall",
    "two-conditions",
    "half-the-angle-out",
]


@pytest.mark.parametrize("name", SIX)
def test_every_line_by_hand_is_one_move(name: str) -> None:
    for number, move, trace in traced(FOLDER / f"{name}.txt"):
        assert trace.kind == "move", number  # type: ignore[attr-defined]
        if move.id == "law":
            assert trace.move.record == move.record, number  # type: ignore[attr-defined]


def test_premises_are_what_the_line_needs() -> None:
    problem, derivation = read_derivation(FOLDER / "show-tangent.txt")
    for number in (3, 4, 5, 6, 7, 8):
        line = derivation.line(number)
        assert line is not None
        above = replace(derivation, lines=derivation.lines[: number - 1])
        assert isinstance(line.relation, Relation)
        trace = explain_line(line.relation, above, oracle_of(problem))
        assert set(trace.premises) == set(line.premises), number


SPHERES = """
sphere A: mass 2, velocity 3i + 4j
sphere B: mass 4, velocity -i + j
A hits B: along i, e = 1/2
find velocity(A)
"""
LETTERS = """
1 a | let | | let v = c(A, 1)
2 a | let | | let w = c(B, 1)
"""


def trace_of(text: str, *above: str) -> tuple[str, str | None]:
    """What a line by a student is, under lines by the same student."""
    problem = parse(SPHERES)
    start = derivation_of(problem, LETTERS)
    tracer = Tracer(replace(start, lines=()), oracle_of(problem))
    for line in start.lines:
        tracer.add(line.number, line.relation)
    for number, each in enumerate(above, 3):
        tracer.add(number, read_relation(each, NAMES))
    trace = tracer.trace(read_relation(text, NAMES))
    return trace.kind, trace.move and (trace.move.record or trace.move.id)


@pytest.mark.parametrize(
    ("text", "above", "expected"),
    [
        ("2*3 + 4*(-1) = 2v + 4w", (), ("move", "momentum")),
        ("2 = 2v + 4w", (), ("move", "momentum")),
        ("1 = v + 2w", (), ("move", "momentum")),
        ("4w - 4 = 6 - 2v - 4", (), ("unrecognised", None)),
        ("w - v = 1/2 (3 + 1)", (), ("move", "restitution")),
        ("v = w - 2", (), ("move", "restitution")),
        ("v - w = 2", (), ("unrecognised", None)),
        ("2*3 + 4*1 = 2v + 4w", (), ("unrecognised", None)),
        ("3w = 3", ("1 = v + 2w", "w - v = 2"), ("move", "combine")),
        ("v = -1", ("1 = v + 2w", "w - v = 2", "w = 1"), ("move", "put")),
        ("w = 1", ("1 = v + 2w",), ("composition", "put")),
        ("v = -1", (), ("composition", "momentum")),
        ("v = 1", (), ("unrecognised", None)),
        ("w = 2", ("1 = v + 2w", "w - v = 2"), ("unrecognised", None)),
    ],
)
def test_lines_of_students(
    text: str, above: tuple[str, ...], expected: tuple[str, str | None]
) -> None:
    assert trace_of(text, *above) == expected


# --- on paper -------------------------------------------------------------------------------------


def test_a_derivation_reads_as_a_teacher_writes() -> None:
    problem, derivation = read_derivation(FOLDER / "unknown-wall.txt")
    assert to_text(explanation_of(derivation, problem)).splitlines() == [
        "Let 𝐑 be the impulse on P.",
        "Impulse = change of momentum of P:",
        "(i)   𝐑 = 3((−4𝐢 − 𝐣) − (2𝐢 + 7𝐣))                                            M1",
        "        = (−18𝐢 − 24𝐣) N s                                                    A1",
        "Magnitude, from the components:",
        "(ii)  magnitude of the impulse = √(18² + 24²) = 30 N s                     M1 A1",
        "Newton's experimental law:",
        "      (−4)(−18) + (−1)(−24) = −e(2(−18) + 7(−24))                          M1 A1",
        "(iii)                     e = 8/17 ≈ 0.471                                    A1",
    ]


@pytest.mark.parametrize("path", FILES, ids=lambda path: path.stem)
def test_every_format_has_every_line_and_every_mark(path: Path) -> None:
    problem, derivation = read_derivation(path)
    explanation = explanation_of(derivation, problem)
    marks = sum(len(line.marks) for line in derivation.lines)
    assert explanation.marks == marks
    shown = [each for each in derivation.lines if not isinstance(each.relation, Meaning)]
    sentences = sum(len(step.points) for part in explanation.parts for step in part.steps)
    assert len(explanation.rows()) + sentences >= len(shown) - 4
    for written in (
        to_text(explanation),
        to_markdown(explanation),
        to_latex(explanation),
        to_html(explanation),
        to_typst(explanation),
    ):
        assert len(written) > 20 * len(shown)
        assert "along(" not in written
        assert "None" not in written
    for line in to_text(explanation).splitlines():
        assert len(line) <= 140  # a quantity without a letter has a long name


def test_frozen_values_are_hashable() -> None:
    _, derivation = read_derivation(FOLDER / "two-conditions.txt")
    assert isinstance(hash(derivation), int)
    assert isinstance(derivation, Derivation)
    assert Fraction(1) == 1
