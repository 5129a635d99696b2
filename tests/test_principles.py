"""What is said about principles: that there is something for each, and that it is fit to read."""

from __future__ import annotations

import pytest

from restitution import examples
from restitution.explaining.lines.saying import say
from restitution.language import parse
from restitution.solving import solve
from restitution.workings import explain
from restitution.workings.rendering.principles import about

SOME = (
    "brought-to-rest",
    "corner",
    "corner-energy",
    "find-the-blow",
    "greatest-loss",
    "mass-ratio",
    "meeting-again",
    "range-of-speed-after-a-wall",
    "right-angles-afterwards",
    "two-spheres-with-vectors",
    "wall-in-letters",
)


@pytest.fixture(scope="module")
def told() -> list[tuple[str | None, str, str | None]]:
    """For every step of some examples: its principle, its words, and what is said about it.

    That every principle of every example has a text, and what it has to be like, is a law.
    """
    return [
        (step.principle, "".join(w for w in step.words if isinstance(w, str)), about(step))
        for name in SOME
        for part in explain(solve(parse(examples.text(name)))).parts
        for step in part.steps
    ]


def test_there_are_texts_enough(told) -> None:
    assert [principle for principle, _, text in told if principle and not text] == []
    assert len({text for _, _, text in told}) >= 15  # unnamed ones too


def test_the_text_belongs_to_the_step(told) -> None:
    by = {principle: text for principle, _, text in told if principle}
    walls = next(t for p, t in by.items() if p.startswith("Parallel to"))
    assert "wall" in walls and "spheres" not in walls
    assert by["Newton's experimental law"].count("wall") >= 1
    impulses = {t for p, t in by.items() if p.startswith("Impulse = change of momentum")}
    assert len(impulses) == 3  # at a wall, between spheres, of a whole vector
    assert about(say("derived.solve-this")) is None
    assert about(say("restitution.title")) == by["Newton's experimental law"]
