"""The registry of quantities: what each record says is what every door makes of it."""

from __future__ import annotations

import re
from functools import cache

import pytest

import restitution
from restitution.expression.quantities import KINDS, QUANTITIES, dimension_of
from restitution.expression.reading import read_expression
from restitution.expression.tree import Quantity
from restitution.workings import to_text

STORY = """
sphere A: mass 2, velocity 3i + j, at (0, 0)
sphere B: mass 1, velocity -i + j, at (8, 0)
A hits B: along i, e = 1/2
find {}
"""
NAMES = {"A": "sphere", "B": "sphere"}
ARGUMENTS = {"V": "velocity(A)", "W": "velocity(B)", "D": "i", "n": "1", "t": "3"}
ENDS = {"angle": ("velocity(A)", "velocity(B)"), "distance": ("A", "(1, 1)")}
KINDS_OF_ANSWERS = {
    "scalar": {"value"},
    "angle": {"value"},
    "vector": {"vector", "point", "direction"},
}


def forms(kind: str) -> list[str]:
    """The forms in which a quantity is written, by its own record, of the bodies of the story."""
    put = ARGUMENTS | dict(zip("XY", ENDS.get(kind, ("A", "B")), strict=True))
    usage = re.split(r", (?![^()]*\))| or ", KINDS[kind].usage)
    return [re.sub(r"\b[A-Znt]\b", lambda name: put.get(name[0], name[0]), form) for form in usage]


FORMS = [form for kind in QUANTITIES for form in forms(kind)]


@cache
def solution(form: str) -> restitution.Solution:
    """The story solved for one quantity."""
    return restitution.solve(restitution.parse(STORY.format(form)))


@pytest.mark.parametrize("form", FORMS)
def test_a_quantity_is_worth_what_its_record_says_and_is_asked_in_words(form: str) -> None:
    """By every form of its usage: a value of its nature, and a question without a formula."""
    solved = solution(form)
    ((_, result),) = solved.items()
    tree = read_expression(form, names=NAMES)
    if isinstance(tree, Quantity):
        nature = KINDS[tree.kind].nature_of(tree.arguments)
        assert result.kind in KINDS_OF_ANSWERS[nature]
        assert result.answers[0].angle == (nature == "angle")
    assert dimension_of(tree) is not None
    asked = str(restitution.question(solved.problem)).replace("\n", " ").split("Find ")[1]
    assert re.search(r"\w\(|_", asked) is None


@pytest.mark.parametrize("form", FORMS)
def test_a_quantity_has_a_working(form: str) -> None:
    """One that is followed, and written out to its end."""
    working = restitution.explain(solution(form), check=True)
    text = to_text(working)
    assert "written out" not in text
