"""Items without a plan: equations solved together in one line, and notes with the answer alone."""

from __future__ import annotations

import random
from dataclasses import replace
from functools import cache

import pytest
from planned import listed, statements

from restitution.explaining.awarding.awards import awarded, marks_of
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.notation import read_relation, write_relation
from restitution.explaining.lines.storing import from_json, to_json
from restitution.language import parse, read
from restitution.oracle import Oracle
from restitution.planning import planner
from restitution.planning.planner import plan
from restitution.planning.routes import by_closing, by_laws, course
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.scene import Scene
from restitution.solving import Solution, solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

PAIR = """
sphere A: mass m, velocity u at 60°
sphere B: mass 2m, at rest
A hits B: along i
given abs(velocity(A) - velocity(B)) = 9/10 u
find e
"""
FROM_WHERE = """
wall W: along i - j
sphere P: velocity v at theta
P hits W: e = 1/3
given velocity(P) = 4i, 180° < theta < 270°
find v, theta
"""
OFFSET = """
sphere A: mass m, velocity u i, radius a
sphere B: mass m, at rest, radius a
A hits B: offset d, e = 1/2
given deflection(A) = 30°
find d
"""
ANGLED = """
wall W: along i
sphere P: velocity u at {} to W
P hits W{}
given speed(P) = {}
find {}
"""
TWO = """
sphere A, B: mass m
sphere A: velocity u at alpha
sphere B: at rest
A hits B: along i, e = 1/2
given deflection(A) = arctan(3/5)
find alpha
"""


@pytest.fixture
def _no_shape(monkeypatch: pytest.MonkeyPatch) -> None:
    """No equation has a shape by which it could be solved."""

    def close(scene: Scene, number: int, symbol: object) -> None:
        raise NotPlannedError(f"no way from line {number} to {symbol}")

    def close_two(*_: object) -> None:
        raise NotPlannedError("no way from two lines")

    for module in (course, by_laws):
        monkeypatch.setattr(module, "close", close)
    monkeypatch.setattr(by_closing, "close_two", close_two)


@cache
def solved(text: str) -> Solution:
    return solve(parse(text))


def written(text: str) -> Derivation:
    derivation = plan(solved(text), partial=True)
    assert complaints(text, derivation) == []
    assert from_json(to_json(derivation)) == derivation
    return derivation


def complaints(text: str, derivation: Derivation) -> list[str]:
    return [str(each) for each in follow(derivation, Oracle(roles(solved(text).problem)))]


def line_of(derivation: Derivation) -> Line:
    """The line in which equations are solved together."""
    (line,) = (each for each in derivation.lines if each.move.id == "solve")
    return line


def said(relation: object) -> str:
    assert isinstance(relation, Relation)
    return write_relation(relation)


# --- the line -------------------------------------------------------------------------------------


@pytest.mark.usefixtures("_no_shape")
@pytest.mark.parametrize(
    ("text", "answer"),
    [
        (PAIR, "e = sqrt(6)/5"),
        (ANGLED.format("45°", "", "3/4 u", "e"), "e = sqrt(2)/4"),
        (ANGLED.format("alpha", ": e = 2/3", "5/6 u", "alpha"), "alpha = arctan(sqrt(11)/3)"),
    ],
)
def test_an_equation_without_a_shape_is_solved_in_one_line(text: str, answer: str) -> None:
    with pytest.raises(NotPlannedError):
        plan(solved(text))
    derivation = written(text)
    assert said(derivation.items[0].answer) == answer
    assert said(line_of(derivation).relation) == answer
    assert "Solving" in to_text(explain(solved(text)))


@pytest.mark.usefixtures("_no_shape")
def test_two_unknowns_of_two_equations() -> None:
    derivation = written(FROM_WHERE)
    line = line_of(derivation)
    assert len(line.premises) == 2
    assert [said(each.answer) for each in derivation.items] == [
        "v = 4sqrt(5)",
        "theta = 180° + arctan(2)",
    ]
    flat = " ".join(to_text(explain(solved(FROM_WHERE))).split())
    assert "Solving (1) and (2): θ = 180° + arctan 2 v = 4√5" in flat


@pytest.mark.usefixtures("_no_shape")
def test_several_solutions_are_alternatives_of_the_line() -> None:
    derivation = written(OFFSET)
    line = line_of(derivation)
    assert isinstance(line.relation, Relation)
    assert len(line.relation.options) == 2
    assert derivation.cases == ()
    assert [each.line for each in derivation.items] == [line.number]


@pytest.mark.usefixtures("_no_shape")
def test_what_comes_behind_several_solutions_stands_in_cases() -> None:
    text = TWO + "find speed(A)"
    derivation = written(text)
    assert len(derivation.cases) == 2
    assert [each.item for each in derivation.items] == ["1", "2", "2"]


@pytest.mark.usefixtures("_no_shape")
def test_the_line_has_a_method_and_its_accuracy() -> None:
    derivation = awarded(written(PAIR))
    assert [(each.kind, each.dependent) for each in line_of(derivation).marks] == [
        ("M", True),
        ("A", False),
    ]


# --- what the follower refuses --------------------------------------------------------------------


def with_line(derivation: Derivation, **changes: object) -> Derivation:
    line = line_of(derivation)
    other = replace(line, **changes)  # type: ignore[arg-type]
    ends = tuple(
        replace(each, answer=other.relation) if each.line == line.number else each
        for each in derivation.items
    )
    return replace(
        derivation,
        lines=tuple(other if each is line else each for each in derivation.lines),
        items=ends if len(ends) == 1 else derivation.items,
    )


def refusals(text: str, derivation: Derivation, **changes: object) -> set[str]:
    number = line_of(derivation).number
    return {
        each.reason
        for each in follow(with_line(derivation, **changes), Oracle(roles(solved(text).problem)))
        if each.line == number
    }


@pytest.mark.usefixtures("_no_shape")
@pytest.mark.parametrize(
    "relation",
    [
        "e = sqrt(6)/4",
        "e = -sqrt(6)/5",
        "e = 0.49",
        "e <= sqrt(6)/5",
        "e = e",
        "e = 25e^2 sqrt(6)/30",
        "e^2 = 6/25",
        "e = sqrt(6)/5 and v = 0",
        "e = sqrt(6)/5 or e = 1/2",
    ],
)
def test_a_value_that_does_not_satisfy_the_equations_is_refused(relation: str) -> None:
    derivation = written(PAIR)
    own = read_relation(relation, {"A": "sphere", "B": "sphere"})
    if relation == "e = -sqrt(6)/5":
        # It satisfies them, and no coefficient is negative: ranges are the matter of the solver.
        own = Relation(((Link(own.only[0].left, "=", own.only[0].left),),))
    assert refusals(PAIR, derivation, relation=own) == {"does-not-follow"}


@pytest.mark.usefixtures("_no_shape")
@pytest.mark.parametrize("relation", ["v = 4sqrt(5)", "theta = 180° + arctan(2)"])
def test_every_unknown_of_the_equations_has_its_value(relation: str) -> None:
    derivation = written(FROM_WHERE)
    own = read_relation(relation, {})
    assert "does-not-follow" in refusals(FROM_WHERE, derivation, relation=own)


@pytest.mark.usefixtures("_no_shape")
def test_an_equation_is_neither_left_out_nor_added() -> None:
    for text in (PAIR, FROM_WHERE):
        derivation = written(text)
        line = line_of(derivation)
        for ref in line.premises:
            fewer = tuple(each for each in line.premises if each != ref)
            assert "does-not-follow" in refusals(text, derivation, premises=fewer)
        others = [
            each.number
            for each in derivation.lines[: line.number - 1]
            if isinstance(each.relation, Relation) and each.number not in line.premises
        ]
        assert others
        for each in others:
            more = (*line.premises, each)
            assert "does-not-follow" in refusals(text, derivation, premises=more)


@pytest.mark.usefixtures("_no_shape")
def test_equations_that_say_the_same_fix_nothing() -> None:
    """Two forms of one equation hold with both values, and with many others."""
    derivation = written(FROM_WHERE)
    line = line_of(derivation)
    first = line.premises[0]
    assert isinstance(first, int)
    own = derivation.lines[first - 1]
    assert isinstance(own.relation, Relation)
    (link,) = own.relation.only
    turned = replace(own, number=99, relation=Relation(((Link(link.right, "=", link.left),),)))
    whole = replace(
        derivation,
        lines=(*derivation.lines[: line.number - 1], turned, *derivation.lines[line.number - 1 :]),
    )
    assert "does-not-follow" in refusals(FROM_WHERE, whole, premises=(first, 99))


# --- all statements ------------------------------------------------------------------------------

WITHOUT_PLAN = sorted(statements().keys() - {each for each, good in listed().items() if good})
SAMPLE = frozenset(random.Random(3).sample(WITHOUT_PLAN, min(8, len(WITHOUT_PLAN))))


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(each, marks=() if each in SAMPLE else pytest.mark.nightly)
        for each in WITHOUT_PLAN
    ],
)
def test_every_item_of_a_statement_has_an_end_or_a_note(name: str) -> None:
    solution = solve(read(statements()[name]))
    explanation = explain(solution)
    for part in explanation.parts:
        ends = {each.item for each in part.derivation.items}
        noted = {each.item for each in part.derivation.notes}
        asked = [each for each, own in part.derivation.asked.items() if own == part.label]
        assert len(asked) == len(part.asked)
        assert set(asked) <= ends | noted
    assert to_text(explanation)


# --- notes ----------------------------------------------------------------------------------------

PARTS = """
wall W: along i
sphere P: mass m, velocity u at alpha to W
P hits W
part a
find speed(P)
find range of speed(P) in terms of u
find impulse
part b
given e = 1/2
find energy_lost
"""


@pytest.fixture
def _without_ranges(monkeypatch: pytest.MonkeyPatch) -> None:
    def write_range(*_: object) -> None:
        raise NotPlannedError("a range")

    monkeypatch.setattr(planner, "write_range", write_range)


@pytest.mark.usefixtures("_without_ranges")
def test_what_an_item_speaks_of_is_written_before_its_note() -> None:
    derivation = written(PARTS)
    assert [each.item for each in derivation.items] == ["a1", "a3", "b1"]
    (note,) = derivation.notes
    assert (note.item, note.kind) == ("a2", "unwritten")
    assert note.claim is not None
    assert write_relation(note.claim) == "0 < speed(P, 1) <= u"
    (number,) = note.lines
    assert said(derivation.lines[number - 1].relation).startswith("speed(P, 1) = ")
    flat = " ".join(to_text(explain(solved(PARTS))).split())
    assert "The steps from here are not written out: (ii) 0 < speed of P ≤ u" in flat
    assert "0 < speed of P ≤ u M1" not in flat


@pytest.mark.usefixtures("_without_ranges")
def test_a_note_has_no_marks() -> None:
    derivation = awarded(written(PARTS))
    assert derivation.notes[0].marks == ()
    parts = explain(solved(PARTS)).parts
    assert marks_of(derivation) == {each.label: each.marks for each in parts}
    assert awarded(derivation, "none").notes[0].marks == ()
    assert from_json(to_json(derivation)) == derivation


def test_where_nothing_can_be_written_the_note_stands_alone() -> None:
    items = ", ".join(["speed(P)"] * 41)
    text = f"wall W: along i\nsphere P: velocity 3i - 4j\nP hits W: e = 1/2\nfind {items}"
    derivation = written(text)
    assert derivation.lines == ()
    assert len(derivation.notes) == 41
    flat = " ".join(to_text(explain(solved(text))).split())
    assert "The working of this is not written out: speed of P = √13" in flat


@pytest.mark.usefixtures("_no_shape")
def test_of_several_solutions_the_principles_stand(monkeypatch: pytest.MonkeyPatch) -> None:
    def solve_together(*_: object) -> None:
        raise NotPlannedError("not together")

    monkeypatch.setattr(by_closing, "solve_together", solve_together)
    derivation = written(OFFSET)
    assert derivation.items == ()
    (note,) = derivation.notes
    records = [derivation.lines[each - 1].move.record for each in note.lines]
    assert records == ["momentum", "restitution"]
    assert note.claim is not None
    assert len(note.claim.options) == 2


def test_a_quadratic_stands_before_roots_that_are_not_real_for_each_angle() -> None:
    text = """
    wall AB: along i
    wall BC: along 135°
    sphere P: velocity u at alpha to AB
    P hits AB
    P hits BC
    given velocity(P) parallel to AB
    find e in terms of alpha
    """
    rows = [row.strip() for row in to_text(explain(solve(parse(text)))).splitlines()]
    number = rows.index("Solving this equation:")
    assert rows[number - 1] == "e² sin α + e(cos α − sin α) + cos α = 0"


@pytest.mark.parametrize(
    ("given", "equation", "root"),
    [
        ("velocity(A) = u i/3", "1 − 9e + 3e² − 3e³ = 0", "e ≈ 0.115"),
        ("energy(A) = 1/4 energy(C)", "(4 − e + 2e² − e³)(2 − 5e − e³) = 0", "e ≈ 0.388"),
    ],
)
def test_the_root_of_a_cubic_stands_in_figures_below_its_equation(
    given: str, equation: str, root: str
) -> None:
    text = f"""
sphere A: mass m, velocity u i
sphere B, C: mass m, at rest
A hits B: along i
B hits C: along i
A hits B
given {given}
find e
"""
    *_, line, note, last = to_text(explain(solve(parse(text)))).rstrip().split("\n")
    assert equation in line
    assert note == "The steps from here are not written out:"
    assert last.strip() == root
