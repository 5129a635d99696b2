"""A worked solution as a value: parts, their steps, and the lines of a step.

A step is data: which principle, in which words, which equations with which values, which marks.
How it looks is for the renderers.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, Literal

from restitution.explaining.lines.derivation import Derivation
from restitution.explaining.lines.marks import Marks, written
from restitution.explaining.lines.saying import Sentence, Words, say, words_of
from restitution.records import dataclass
from restitution.render.layout import Layout
from restitution.render.text import NO_BREAK

if TYPE_CHECKING:
    from restitution.drawing.scene import Scene
    from restitution.expression.tree import Expression
    from restitution.solving.equations.solution import Solution

StepKind = Literal["setting", "principle", "solve", "fact", "result", "note", "heading", "picture"]


# What stands before a source.
_BEFORE: Mapping[str, str] = {"carried.with": ",", "carried.with-anew": "."}


@dataclass(frozen=True)
class Row:
    """One line of mathematics: a chain of operands with signs between them.

    ``operands[0]`` None goes on from the line above. ``points`` are what an examiner would give;
    ``reasons`` go on from the line as words (*as α is acute*), ``asides`` stand behind it in
    brackets, as does its ``number`` last, by which others name it; a line with ``alternatives``
    offers several values, and one that is an ``answer`` gives what was asked. In front of a line
    that ends an item stands its ``label``, the number of the item in the question.
    """

    operands: tuple[Layout | None, ...]
    signs: tuple[str, ...]
    points: Marks = ()
    asides: tuple[Sentence, ...] = ()
    alternatives: bool = field(default=False, compare=False, repr=False)
    reasons: tuple[Sentence, ...] = ()
    number: str = ""
    answer: bool = field(default=False, compare=False, repr=False)
    label: str = field(default="", compare=False, repr=False)

    @property
    def mark(self) -> str:
        """The marks as they stand beside the line."""
        return written(self.points)

    @property
    def note(self) -> Words:
        """Words behind the line, with the brackets in which they stand."""
        spoken: list[str | Layout] = []
        comma = str(say("list.comma"))
        # What is required is the printed result, and not the case that it leaves out.
        required = any(aside.id == "shown.required" for aside in self.asides)
        late = [own for own in self.reasons if required and own.id == "derived.right-angle"]
        if first := [own for own in self.reasons if own not in late]:
            spoken += [comma, *words_of(first, comma)]
        number = (say("derived.value", value=self.number),) if self.number else ()
        for aside in (self.asides, number):
            if aside:
                # A number behind words stands apart from them.
                gap = "" if not spoken else 3 * NO_BREAK if aside is number else " "
                spoken += [f"{gap}(", *words_of(aside, str(say("list.semicolon"))), ")"]
            if aside is self.asides and late:
                spoken += [comma, *words_of(late, comma)]
        return tuple(spoken)


@dataclass(frozen=True)
class Step:
    """One step of the working.

    ``title`` names the law used, ``sentences`` stand before the equations; behind the title, or
    behind sentences that have none, stands the ``source`` of what is put in from another part.
    ``item`` counts the items of the part from 0. The ``event`` is that of a heading or of a
    picture. In front of sentences that end an item stands its ``label``, the number of the item in
    the question.
    """

    kind: StepKind
    rows: tuple[Row, ...] = ()
    title: Sentence | None = None
    sentences: tuple[Sentence, ...] = ()
    points: Marks = ()
    item: int | None = field(default=None, compare=False, repr=False)
    event: int | None = field(default=None, compare=False, repr=False)
    picture: Scene | None = None
    label: str = field(default="", compare=False, repr=False)
    source: Sentence | None = None

    @property
    def principle(self) -> str | None:
        """The name of the law used, in words."""
        return None if self.title is None else str(self.title)

    @property
    def sign(self) -> str:
        """What stands right behind the name of the law, or behind the sentences before a source."""
        return ":" if self.source is None else _BEFORE.get(self.source.id, "")

    @property
    def words(self) -> Words:
        """What stands before the equations."""
        words = words_of(self.sentences)
        if self.source is not None and self.title is not None:
            words = words_of((self.source, *self.sentences))
        elif self.source is not None:
            words = (*_left_open(words, self.sign), *self.source.words)
        return (f"{self.label} ", *words) if self.label else words

    @property
    def marks(self) -> int:
        """How many marks the step is worth."""
        return sum(
            mark.number
            for points in (self.points, *(row.points for row in self.rows))
            for mark in points
        )

    @property
    def mark(self) -> str:
        """The marks of its words as they stand beside them; those of its lines are theirs."""
        return written(self.points)


def _left_open(words: Words, sign: str) -> Words:
    """Words with a sign in the place of the colon at their end, before others that follow."""
    if not words:
        return words
    *before, last = words
    if isinstance(last, str):
        return (*before, f"{last.removesuffix(':').removesuffix(sign)}{sign} ")
    return (*words, f"{sign} ")


@dataclass(frozen=True)
class PartExplanation:
    """The working of one part; ``asked`` are its items as typed, ``answers`` as people see them.

    ``marks`` is what the part is worth, ``item_marks`` what each item adds to it: what several
    items rest on counts with the first of them. ``derivation`` is the working of the whole
    question as data, of which the steps are the part's own lines.
    """

    label: str | None
    asked: tuple[str, ...]
    steps: tuple[Step, ...]
    answers: tuple[str, ...]
    derivation: Derivation = field(compare=False, repr=False)

    @property
    def marks(self) -> int:
        """The marks of the part."""
        return sum(step.marks for step in self.steps)

    @property
    def item_marks(self) -> tuple[int, ...]:
        """The marks of each item, in the order of ``asked``."""
        return tuple(
            sum(step.marks for step in self.steps if step.item == index)
            for index in range(len(self.asked))
        )


@dataclass(frozen=True)
class Working:
    """A whole worked solution as data, and what it explains.

    Pictures are not among its steps until ``illustrated`` puts them there. ``followed`` tells
    whether its lines were followed exactly; None where that was not asked. ``letters`` are those
    that it introduces, by the quantities for which they stand.
    """

    title: str | None
    parts: tuple[PartExplanation, ...]
    warnings: tuple[str, ...] = ()
    solution: Solution | None = field(default=None, compare=False, repr=False)
    followed: bool | None = None
    letters: Mapping[Expression, str] = field(default_factory=dict, compare=False, repr=False)

    @property
    def marks(self) -> int:
        """The marks of the whole question."""
        return sum(part.marks for part in self.parts)

    @property
    def left_over(self) -> tuple[str, ...]:
        """The warnings that the steps do not give themselves."""
        notes = {
            note.reason
            for part in self.parts
            for note in part.derivation.notes
            if note.kind == "impossible" and note.premises
        }
        return tuple(
            warning
            for warning in self.warnings
            if not any(warning.endswith(note) for note in notes if note)
        )

    def rows(self) -> tuple[Row, ...]:
        """Every line of mathematics, in order."""
        return tuple(row for part in self.parts for step in part.steps for row in step.rows)


REQUIRED = (say("shown.required"),)
"""Behind the line of a printed result."""

__all__ = ["REQUIRED", "PartExplanation", "Row", "Step", "StepKind", "Words", "Working"]
