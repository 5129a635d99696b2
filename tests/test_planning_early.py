"""Items above a given fact of their part are derived without it, where they hold without it."""

from __future__ import annotations

import re

import pytest

from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain, to_text

SPHERES = """
sphere A: mass m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i
"""


def planned(text: str) -> Derivation:
    solution = solve(parse(text))
    derivation = plan(solution)
    assert follow(derivation, Oracle(roles(solution.problem))) == ()
    return derivation


def under(derivation: Derivation, item: str) -> set[int | str]:
    """All that the last line of an item rests on."""
    lines = {line.number: line for line in derivation.lines}
    pending: list[int | str] = [end.line for end in derivation.items if end.item == item]
    refs: set[int | str] = set()
    while pending:
        ref = pending.pop()
        if ref not in refs:
            refs.add(ref)
            pending += lines[ref].premises if isinstance(ref, int) else ()
    return refs


def test_what_is_shown_above_a_fact_is_shown_without_it() -> None:
    derivation = planned(
        SPHERES
        + """
let beta = angle(velocity(A), line_of_centres)
show tan(beta) = 2tan(alpha)/(1-e)
given e = 1/3
find tan(beta)
"""
    )
    assert "given 1" not in under(derivation, "1")
    assert "given 1" in under(derivation, "2")


@pytest.mark.parametrize(
    ("mass", "claim", "fact"),
    [
        ("m", "tan(angle(velocity(A), i)) = 2tan(alpha)/(1-e)", "deflection(A) = 90° - alpha"),
        (
            "2m",
            "tan(deflection(A)) = 2(1+e)tan(alpha)/(1 - 2e + 3tan(alpha)^2)",
            "deflection(A) = 90°",
        ),
    ],
)
def test_a_tangent_is_shown_above_the_fact_that_the_angle_is_right(
    mass: str, claim: str, fact: str
) -> None:
    text = SPHERES.replace("B: mass m", f"B: mass {mass}")
    text += f"show {claim}\ngiven {fact}\nfind e"
    assert [item.holds for _, item in solve(parse(text)).items()] == [True, None]
    assert "given 1" not in under(planned(text), "1")


def test_what_is_shown_by_a_fact_below_it_still_rests_on_that() -> None:
    derivation = planned(SPHERES + "show speed(A) = u sin(alpha)\ngiven e = 1\nfind speed(B)")
    assert "given 1" in under(derivation, "1")


def test_a_value_in_terms_of_a_letter_is_worked_out_in_that_first() -> None:
    text = """
wall W: along i
sphere P: velocity u at alpha to W
P hits W: e = 1/2
find tan(angle(velocity(P), W)) in terms of alpha
given tan(alpha) = 3/4
find angle(velocity(P), W)
"""
    planned(text)
    working = re.sub(r"\s+", " ", to_text(explain(solve(parse(text)))))
    assert "= ½ tan α" in working
    assert "Since tan α = ¾: tan β = ½ × ¾ = ⅜" in working
    assert "sin α = ⅗" not in working


def test_a_value_in_no_letters_takes_the_letters_that_are_given() -> None:
    working = to_text(explain(solve(parse(SPHERES + "find velocity(A)\ngiven e = 1"))))
    assert "1 − e" not in working


def test_a_value_above_a_condition_on_the_motion_is_worked_out_before_it() -> None:
    text = SPHERES + "find speed(B)/u\ngiven speed(B) = 4/5 u cos(alpha)\nfind e"
    planned(text)
    working = to_text(explain(solve(parse(text))))
    assert "V/u = ½(1 + e) cos α" in working


def test_a_tangent_that_stands_takes_the_value_of_a_letter() -> None:
    text = (
        SPHERES
        + """
let beta = angle(velocity(A), line_of_centres)
show tan(beta) = 2tan(alpha)/(1-e)
given e = 1/3
part b
given beta = 2alpha
find alpha
"""
    )
    planned(text)
    assert to_text(explain(solve(parse(text)))).count("Direction of motion") == 1


def test_a_range_is_that_with_the_facts_below_it() -> None:
    working = to_text(explain(solve(parse(SPHERES + "find range of e\ngiven e < 1/2"))))
    assert "0 ≤ e < ½" in working


def test_an_answer_has_no_letter_that_a_let_names() -> None:
    text = """
sphere A: mass 2m, velocity u at alpha
sphere B: mass m, at rest
A hits B: along i, e = 1/2
let beta = direction(A)
let delta = beta - alpha
find tan(beta) in terms of alpha
given delta = arctan(1/3), tan(alpha) < 3/4
find alpha
"""
    working = to_text(explain(solve(parse(text))))
    assert "2 tan(β − arctan(1/3))" not in working
    assert "2 tan α" in working and "tan β = 1" not in working
    assert "α = arctan(1/2)" in working


def test_a_value_in_terms_of_a_letter_keeps_it_above_the_fact_that_fixes_it() -> None:
    """A fact below the question gives no number to it; one above it does."""
    question = "find speed(A)/u in terms of alpha, e\n"
    fact = "given tan(alpha) = 2\n"
    below, above = (
        solve(parse(SPHERES + text)).parts[None].items[0].answers[0].value
        for text in (question + fact + "find energy(A)", fact + question)
    )
    assert {symbol.name for symbol in below.free_symbols} == {"alpha", "e"}
    assert {symbol.name for symbol in above.free_symbols} == {"e"}


@pytest.mark.parametrize(
    ("fact", "line"),
    [
        ("alpha = 45°", "δ = 45° + β = 45° + arctan(2/3)"),
        ("alpha = 60°", "δ = 60° + β = 60° + arctan(2√3/3)"),
        ("tan(alpha) = 3/2", "δ = α + 45° = arctan(3/2) + 45°"),
    ],
)
def test_an_angle_in_letters_and_then_in_numbers(fact: str, line: str) -> None:
    """In the later part the values are put in, and nothing is left in letters."""
    text = (
        "wall W: along i\nsphere P: velocity u at alpha to W\nP hits W: e = 2/3\n"
        f"part a\nfind deflection(P)\npart b\ngiven {fact}\nfind deflection(P)"
    )
    shown = to_text(explain(solve(parse(text))), 80)
    assert "δ = α + β = α + arctan(⅔ tan α)" in shown
    assert line in shown
    assert "not written out" not in shown


CORNER = """
point O: (0, 0)
wall V: from O to (5, 0)
wall W: from O to (0, 3)
sphere P: at (3, 2), velocity -w i - w j
P hits V: e = f
P hits W: e = g
P reaches (5, y)
"""


def test_a_letter_asked_in_letters_keeps_them_where_its_value_has_a_condition() -> None:
    text = (
        CORNER + "find y in terms of f, g\ngiven f = 1/3\nfind range of g\n"
    )  # by hand: x = 1 and y = f at the walls, 5fw = (y − f)gw
    first, second = solve(parse(text)).parts[None].items
    assert [answer.exact for answer in first.answers] == ["f*(g + 5)/g"]
    assert second.answers[0].exact == "Interval.Lopen(0, 1)"
    explanation = explain(solve(parse(text)), check=True)
    assert explanation.followed
    lines = " ".join(to_text(explanation).split())
    assert "5fw = (y − f)gw" in lines
    assert "g > 0, as g ≥ 0 and there is no y if g = 0" in lines


@pytest.mark.parametrize("letter", ["e", "f"])
def test_a_coefficient_in_terms_of_an_angle_stands_above_the_tangent_that_is_given(
    letter: str,
) -> None:
    text = (
        "wall W: along j\nsphere P: mass m, velocity v at theta to W\n"
        f"P hits W: e = {letter}\ngiven speed(P) = 3/4 v\n"
        f"find {letter} in terms of theta\ngiven tan(theta) = 2\nfind {letter}"
    )
    first, second = solve(parse(text)).parts[None].items
    assert [answer.letters for answer in first.answers] == [frozenset({"theta"})]
    # By hand: e² = (9/16 − cos²θ)/sin²θ = (9/16 − 1/5)/(4/5) = 29/64.
    assert [answer.exact for answer in second.answers] == ["sqrt(29)/8"]
    derivation = planned(text)
    assert "given 2" not in under(derivation, "1")
    lines = " ".join(to_text(explain(solve(parse(text)))).split())
    assert f"{letter}² = (9 − 16 cos²θ)/(16 sin²θ)" in lines
