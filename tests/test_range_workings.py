"""The conditions that the working of a range tells imply the range, and no claim contradicts it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path

import pytest
import sympy as sp

import restitution
from restitution import examples
from restitution.explain import explain, route
from restitution.explain.checking import related
from restitution.explain.quantities import evaluated
from restitution.explain.working import Working
from restitution.expression import read_expression
from restitution.expression.evaluate import evaluate
from restitution.language import parse
from restitution.oracle import Formula, Relation, compared
from restitution.problem import Range
from restitution.solve.solution import ItemResult, Solution

QUESTIONS = Path(__file__).parent / "questions"
ORDERS = {"<": "<", ">": ">", "≤": "<=", "≥": ">=", "≠": "!="}


def statements() -> Iterator[tuple[str, str]]:
    """Every statement of the corpus that asks for a range."""
    texts = {path.stem: path.read_text(encoding="utf-8") for path in QUESTIONS.glob("*.impact")}
    texts |= {name: examples.text(name) for name in examples.names()}
    for name, text in sorted(texts.items()):
        if "range of" in text:
            yield name, text


CORPUS = dict(statements())


def told(work: Working, upto: int) -> list[Formula]:
    """The inequalities that stand in a working, in the data alone."""
    found: list[Formula] = []
    for step in work.steps:
        if step.item is not None and step.item > upto:
            continue
        for row in step.rows:
            for left, sign, right in related(row):
                if sign in ORDERS and not isinstance(left, tuple):
                    sides = (work.model.in_data(each) for each in (left, right))
                    one, other = sides
                    found.append(compared(one, ORDERS[sign], other))
    return found


def bounds(value: sp.Expr, values: sp.Set) -> list[Formula]:
    """That a value lies in an interval, or in the hull of several."""
    if isinstance(values, sp.FiniteSet):
        return [Relation(value - each, "=") for each in values.args] if len(values) == 1 else []
    pieces = values.args if isinstance(values, sp.Union) else (values,)
    found: list[Formula] = []
    first, last = pieces[0], pieces[-1]
    if first.start.is_infinite is not True:
        found.append(Relation(value - first.start, ">" if first.left_open else ">="))
    if last.end.is_infinite is not True:
        found.append(Relation(last.end - value, ">" if last.right_open else ">="))
    return found


def ranges(solution: Solution) -> Iterator[tuple[Working, ItemResult, int, int]]:
    """The ranges answered, each with its working, its place in the part and the event."""
    carried: route.Carried = {}
    for part in solution.parts.values():
        if not part.branches:
            continue
        works = route.workings(solution, part, carried)
        route._carry(part.part, works, carried)
        nows = [now for _, now in solution.problem.asked(part.part)]
        for index, (item, now) in enumerate(zip(part.items, nows, strict=False)):
            if isinstance(item.item, Range) and item.error is None:
                for work in works:
                    yield work, item, index, now


def conditions(work: Working, texts: tuple[str, ...]) -> list[Formula]:
    """The relations under which an answer holds, read again."""
    found = []
    for text in texts:
        sign = next(each for each in ("<=", ">=", "<", ">") if each in text)
        sides = [
            work.model.in_data(evaluate(read_expression(each), work.model.unknowns.letter))
            for each in text.split(sign)
        ]
        found.append(compared(sides[0], sign, sides[1]))
    return found


# An angle against a sum of angles with an arctangent of letters: that is left undecided.
UNDECIDED = {("093-ranges-when-e-is-not-known", "range of deflection(A)")}


@pytest.mark.parametrize("name", CORPUS)
def test_what_the_working_of_a_range_tells_implies_the_range(name: str) -> None:
    solution = restitution.solve(parse(CORPUS[name]))
    for work, item, index, now in ranges(solution):
        value = evaluated(work, item.item.expression, now)
        answer = next((a for a in item.answers if a.solution == work.model.branch.number), None)
        if answer is None:
            continue
        facts = [*told(work, index), *conditions(work, answer.condition)]
        oracle = work.model.ground.with_facts(dict.fromkeys(facts))
        for bound in bounds(value, answer.value):
            claim = Relation(work.model.in_data(bound.value), bound.operator)
            verdict = oracle.decide(claim)
            expected = "undecided" if (name, item.text) in UNDECIDED else "proved"
            assert verdict.answer in (expected, "proved"), (item.text, claim, verdict, facts)


def test_the_corpus_has_ranges() -> None:
    assert len(CORPUS) > 80


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        (
            """
            sphere A: mass m, velocity u i
            sphere B: mass k m, at rest
            A hits B: along i
            given energy_lost < 500
            find range of u
            """,
            ["Since kinetic energy lost < 500:", "kmu²(1 − e²)/(2(1 + k)) < 500"],
        ),
        (
            """
            wall W: from (1, 0) to (4, 0)
            sphere P: at (0, 1), velocity a i - j
            P hits W
            find range of a
            """,
            ["P hits W between its ends: 1 < a < 4"],
        ),
        (
            """
            wall W: along i
            sphere P: mass m, velocity u at alpha to W
            P hits W
            given energy_lost = 1/4 energy(0)
            find range of e
            """,
            ["sin²α = 1/(4(1 − e²))", "0 ≤ e < √3/2", "as α is acute"],
        ),
        (
            """
            wall X: along i
            wall Y: along j
            sphere P: velocity u at 60° to X
            P hits X: e = e
            P hits Y: e = 2e
            find range of e
            """,
            ["A coefficient of restitution is at most 1: e ≤ ½", "0 ≤ e ≤ ½, as e ≥ 0"],
        ),
    ],
)
def test_conditions_that_fail_only_far_away_are_told(text: str, lines: list[str]) -> None:
    working = " ".join(str(explain(restitution.solve(parse(text)), marks="none")).split())
    for line in lines:
        assert line in working


@pytest.mark.parametrize(
    ("facts", "condition"),
    [
        ("given velocity(A) perpendicular to velocity(B)\nfind e in terms of k", "As e ≤ 1, "),
        ("given velocity(A) perpendicular to i\nfind e in terms of k", "As e ≤ 1, "),
    ],
)
def test_a_condition_says_which_coefficient_it_comes_from(facts: str, condition: str) -> None:
    text = "sphere A: mass m, velocity u at alpha\nsphere B: mass k m, at rest\nA hits B: along i\n"
    working = " ".join(str(explain(restitution.solve(parse(text + facts)))).split())
    assert f"{condition}this holds for k ≥ 1 only." in working


IMPACT = "sphere A: mass m, velocity u i\nsphere B: mass k m, at rest\nA hits B: along i\n"


@pytest.mark.parametrize(
    ("fact", "claims"),
    [
        (
            "given velocity(A) = -u/10 i\nfind range of k",
            {"k > 1": True, "k >= 11/9": True, "k < 50": False, "k > 11/9": False},
        ),
        (
            "given speed(B) = 3/4 u\nfind range of k",
            {"k < 2": True, "k <= 5/3": True, "k < 5/3": False, "e >= 0": True},
        ),
        (
            "given energy_lost = 1/2 energy(0)\nunknown e\nfind range of k",
            {"k >= 1": True, "k > 1": False, "k < 50": False},
        ),
    ],
)
def test_claims_beside_a_range_agree_with_it(fact: str, claims: dict[str, bool]) -> None:
    shows = "".join(f"\nshow {claim}" for claim in claims)
    solution = restitution.solve(parse(IMPACT + fact + shows))
    assert {claim: solution[claim].holds for claim in claims} == claims
    working = " ".join(str(explain(solution, marks="none")).split())
    for claim, holds in claims.items():
        shown = claim.replace(">=", "≥").replace("<=", "≤")
        false = f"It is not true in general that {shown}:"
        assert (f"{shown} (as required)" in working) is holds
        assert (false in working) is not holds


OBLIQUE = """\
sphere P: mass m, velocity u at alpha
sphere Q: mass {}, at rest
P hits Q: along i, e = e"""
CUSHION = """\
wall W: along i
sphere P: velocity u at (-alpha)
P hits W: e = e"""


@pytest.mark.parametrize(
    ("setting", "claim"),
    [
        (CUSHION, "deflection(P) > 90°"),
        (OBLIQUE.format("k m"), "deflection(P) < 60°"),
        (OBLIQUE.format("3 m"), "angle(velocity(P), velocity(Q)) < 100°"),
    ],
)
def test_an_angle_beside_a_counterexample_is_that_of_its_letters(setting: str, claim: str) -> None:
    solution = restitution.solve(parse(f"{setting}\nshow {claim}"))
    item = solution[claim]
    assert item.holds is False
    working = " ".join(str(explain(solution)).split())
    degrees = float(re.findall(r"([\d.]+)°\.", working)[-1])
    asked, sign, bound = re.fullmatch(r"(.*) ([<>]) (\d+)°", claim).groups()
    assert degrees >= float(bound) if sign == "<" else degrees <= float(bound)
    put = "".join(f"\ngiven {name} = {text}" for name, text in item.counterexample.items())
    exact = restitution.solve(parse(f"{setting}{put}\nfind {asked}"))[asked]
    assert math.degrees(exact.decimal) == pytest.approx(degrees, rel=5e-3)


def test_what_is_bounded_as_a_whole_is_said_once():
    text = """sphere A: mass m, velocity u i
sphere B: mass k m, velocity -v i
A hits B: along i
given speed(A) = speed(B)
find e, velocity(B)
"""
    working = " ".join(str(explain(restitution.solve(restitution.parse(text)))).split())
    assert working.lower().count("this holds for") == 1
    assert "As 0 ≤ e ≤ 1, this holds for 0 ≤ 2(u − kv)/((k − 1)(u + v)) ≤ 1 only." in working
    assert "As 0 ≤ e ≤ 1, this holds for 0 ≤ e ≤ 1" not in working
