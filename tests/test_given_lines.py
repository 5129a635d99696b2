"""Lines of centres that are given as facts, of spheres whose places are given too."""

from __future__ import annotations

from dataclasses import replace

import pytest
import sympy as sp
from workings import planned

from restitution import parse, solve
from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Note
from restitution.workings import explain, to_text
from restitution.workings.derived import explanation_of

START = """
sphere A: mass 2, radius 1/2, at (0, 0), velocity 3i
sphere B: mass 1, radius 1/2, at (6.6, 10.8), velocity v at -90°
A hits B: e = 1/2
"""


@pytest.mark.parametrize(
    "given",
    [
        "line_of_centres parallel to 3i + 4j",
        "line_of_centres parallel to -3i - 4j",
        "3i + 4j parallel to line_of_centres(1)",
    ],
)
def test_the_time_and_a_speed_follow_from_the_line(given: str) -> None:
    """The line tells where the centres are at the impact, and these tell the rest."""
    problem, derivation = planned(f"{START}given {given}\nfind time(1), v\n")
    text = to_text(explanation_of(derivation, problem))
    assert text.index("Let t be the time") < text.index("= 2 s") < text.index("v = 5")


@pytest.mark.parametrize("given", ["in the direction of 3i + 4j", "= 3/5 i + 4/5 j"])
def test_a_line_with_its_sense_is_said_to_agree(given: str) -> None:
    """The line tells the rest; its sense follows from that, and stays a fact."""
    problem = parse(f"{START}given line_of_centres {given}\nfind v\n")
    text = to_text(explain(solve(problem)))
    assert "v = 5" in text
    assert "It is also given that" in text
    assert "not written out" not in text


def test_the_other_sense_is_a_contradiction() -> None:
    """A fact that tells the sense is not lost."""
    text = f"{START}given line_of_centres in the direction of -3i - 4j\nfind v\n"
    (item,) = solve(parse(text)).parts[None].items
    assert isinstance(item.error, RestitutionError)


def test_a_direction_is_found() -> None:
    """The centre of A is two radii from that of B, back along the line: at (8.4, 1.2)."""
    problem, derivation = planned(
        """
sphere A: mass 3, radius 1, at (0, 0), velocity 5 at theta
sphere B: mass 2, radius 1, at (10, 0), at rest
A hits B: e = 1/3
given line_of_centres parallel to 4i - 3j
find theta, speed(B)
"""
    )
    text = to_text(explanation_of(derivation, problem))
    assert "tan θ = (6/5)/(42/5) = 1/7" in text
    assert "speed of B = 2√2" in text


def test_a_fact_of_one_part_is_no_fact_of_another() -> None:
    """The same impact has another line of centres in each part."""
    solution = solve(
        parse(
            f"{START}part a\ngiven line_of_centres parallel to 3i + 4j\nfind v\n"
            "part b\ngiven line_of_centres parallel to i + j\nfind v\n"
        )
    )
    values = [part.items[0].answers[0].value for label, part in solution.parts.items() if label]
    # Of the second: 3t = 6.6 − √2/2 and vt = 10.8 − √2/2.
    other = (sp.Rational(54, 5) - 1 / sp.sqrt(2)) * 3 / (sp.Rational(33, 5) - 1 / sp.sqrt(2))
    assert [sp.simplify(a - b) for a, b in zip(values, (5, other), strict=True)] == [0, 0]


def test_what_a_note_names_is_introduced_before_it() -> None:
    """A time whose working is not written out stands below the letter for it."""
    problem, derivation = planned(
        f"{START}given line_of_centres parallel to 3i + 4j\nfind time(1)\n"
    )
    (end,) = derivation.items
    note = Note(end.item, "unwritten", 0, reason="2", claim=end.answer)
    bare = replace(derivation, lines=(), items=(), notes=(note,))
    text = to_text(explanation_of(bare, problem))
    assert text.index("Let t be the time") < text.index("t = 2 s")


def test_an_arrival_names_the_impact_that_has_the_line() -> None:
    """The latest event is no impact: how that of the impact is asked for."""
    text = """
sphere A, B: mass 1
sphere A: at (0, 0), velocity 2i + j
sphere B: at (2, 1), at rest
point H: (4, 1)
A hits B: along i, e = 1/2
B reaches H
find line_of_centres
"""
    (item,) = solve(parse(text)).parts[None].items
    assert "line_of_centres(1)" in str(item.error)
