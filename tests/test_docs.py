"""What the documentation shows is true: statements solve, Python runs, links and limits hold."""

from __future__ import annotations

import re
from itertools import pairwise
from pathlib import Path
from textwrap import dedent

import pytest

import restitution
from restitution.export.answers import answers
from restitution.expression import limits
from restitution.expression.quantities import QUANTITIES

ROOT = Path(__file__).parents[1]
PAGES = [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").glob("*.md"))]
FENCE = re.compile(r"^( *)```(\w*)\n(.*?)^ *```$", re.MULTILINE | re.DOTALL)


def fences():
    """The page, the number of the first line, the language and the text of every block."""
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for match in FENCE.finditer(text):
            line = text[: match.start()].count("\n") + 2
            yield page, line, match[2], dedent(match[3])


STATEMENTS = [
    pytest.param(text, id=f"{page.name}:{line}")
    for page, line, language, text in fences()
    if language == "impact"
]


def answered():
    """Statements directly above a text, which is what they are answered."""
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        blocks = list(FENCE.finditer(text))
        for first, second in pairwise(blocks):
            between = text[first.end() : second.start()]
            if (first[2], second[2], between.strip()) == ("impact", "text", ""):
                yield dedent(first[3]), dedent(second[3])


ANSWERED = dict(answered())


@pytest.mark.parametrize("statement", STATEMENTS)
def test_statement_is_answered(statement):
    solution = restitution.solve(restitution.parse(statement))
    items = [item for _, item in solution.items()]
    assert items
    for item in items:
        assert item.error is None, f"{item.text}: {item.error}"
        assert item.answers or item.holds or statement in ANSWERED, item.text


@pytest.mark.parametrize("statement", ANSWERED)
def test_what_is_printed_below_a_statement_is_its_answers(statement):
    assert answers(restitution.solve(restitution.parse(statement))) == ANSWERED[statement]


def test_every_fence_says_what_it_holds():
    """A fence without a language would be run by no test."""
    for page, line, language, _ in fences():
        assert language in ("impact", "python", "text", "sh"), (page.name, line)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text(encoding="utf-8")):
        if "://" in target:
            continue
        path, _, anchor = target.partition("#")
        found = page.parent / path if path else page
        assert found.exists(), target
        if anchor:
            headings = re.findall(r"^#+ (.*)$", found.read_text(encoding="utf-8"), re.MULTILINE)
            slugs = {
                re.sub(r"[^\w\- ]", "", each).strip().lower().replace(" ", "-") for each in headings
            }
            assert anchor in slugs, target


def test_reference_tells_the_limits():
    text = (ROOT / "docs" / "language.md").read_text(encoding="utf-8").replace(" ", "")
    for name in vars(limits):
        if name.startswith("MAX_") and name != "MAX_ERRORS":
            assert f"|{getattr(limits, name)}|" in text, name


def test_reference_names_every_quantity():
    text = (ROOT / "docs" / "language.md").read_text(encoding="utf-8")
    for quantity in QUANTITIES:
        assert f"`{quantity}" in text, quantity
