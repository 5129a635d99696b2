"""What is said about principles: that there is something for each, and that it is fit to read."""

from __future__ import annotations

import re

import pytest

from restitution import examples
from restitution.explain import explain
from restitution.explain.principles import about
from restitution.explaining.saying import say
from restitution.language import parse
from restitution.solve import solve


@pytest.fixture(scope="module")
def told() -> list[tuple[str | None, str, str | None]]:
    """For every step of every example: its principle, its words, and what is said about it."""
    return [
        (step.principle, "".join(w for w in step.words if isinstance(w, str)), about(step))
        for name in examples.names()
        for part in explain(solve(parse(examples.text(name)))).parts
        for step in part.steps
    ]


def test_every_principle_in_the_working_of_the_examples_has_a_text(told) -> None:
    assert [principle for principle, _, text in told if principle and not text] == []
    assert len({text for _, _, text in told}) >= 15  # unnamed ones too


def test_texts_are_a_few_sentences_in_words(told) -> None:
    for text in {text for _, _, text in told if text}:
        assert 2 <= len(re.findall(r"[.;] |\.$", text)) <= 6, text
        assert 120 <= len(text) <= 480, text
        assert not re.search(r"[*$\\<>_{}`]", text), text
        assert text[0].isupper() and text.endswith("."), text


def test_the_text_belongs_to_the_step(told) -> None:
    by = {principle: text for principle, _, text in told if principle}
    walls = next(t for p, t in by.items() if p.startswith("Parallel to"))
    assert "wall" in walls and "spheres" not in walls
    assert by["Newton's experimental law"].count("wall") >= 1
    impulses = {t for p, t in by.items() if p.startswith("Impulse = change of momentum")}
    assert len(impulses) == 3  # at a wall, between spheres, of a whole vector
    assert about(say("derived.solve-this")) is None
    assert about(say("restitution.title")) == by["Newton's experimental law"]
