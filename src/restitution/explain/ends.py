"""What a working leads to: its items as they were asked, and the lines in which they end."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from restitution.explain.naming import Naming
from restitution.explaining.derivation import Derivation, ItemEnd, Line, Relation
from restitution.explaining.saying import Sentence, say
from restitution.expression.tree import Quantity
from restitution.problem import (
    Arrival,
    Find,
    Impact,
    Item,
    Kick,
    Meets,
    Problem,
    Show,
    Value,
)
from restitution.render import layout as lay
from restitution.wording.asking import names_of
from restitution.wording.scene import scene_of
from restitution.wording.structure import Named, Words


class Ends:
    """The items of one derivation, and the lines in which they end."""

    def __init__(self, derivation: Derivation, problem: Problem, naming: Naming) -> None:
        self._naming = naming
        self._problem = problem
        self._named: dict[str, Words] | None = None
        self._ends = {each.line: each for each in _ends(derivation)}
        self._parts = derivation.asked
        self._places = {
            each: [e for e in self._parts if self._parts[e] == self._parts[each]].index(each)
            for each in self._parts
        }
        asked = [each for _, step in problem.steps() for each in _asked(step)]
        self._asked: Mapping[str, Item | Show] = (
            dict(zip(self._parts, asked, strict=True)) if len(asked) == len(self._parts) else {}
        )

    def part(self, line: Line) -> str | None:
        """The label of the part to which a line belongs."""
        return self._parts.get(line.item or "")

    def place(self, line: Line) -> int | None:
        """Which item of its part a line belongs to, counted from 0."""
        return self.place_of(line.item)

    def place_of(self, item: str | None) -> int | None:
        """Which of its part an item is, counted from 0."""
        return self._places.get(item or "")

    def of(self, line: Line) -> ItemEnd | None:
        """The end of an item in a line; None where none ends."""
        return self._ends.get(line.number)

    def asked(self, line: Line) -> Item | Show | None:
        """What was asked, in the line that ends it."""
        end = self.of(line)
        return None if end is None else self._asked.get(end.item)

    def item(self, name: str) -> Item | Show | None:
        """An item by its name in the working."""
        return self._asked.get(name)

    def text(self, item: str) -> str:
        """An item as it was typed."""
        known = self._asked.get(item)
        return known.text if known is not None and known.text else item

    def named(self, item: str) -> tuple[lay.Layout | str, ...]:
        """An item in the words of the question; as it was typed where it has none."""
        if self._named is None:
            self._named = {}
            scene, events = scene_of(self._problem), 0
            spoken: list[Words] = []
            for _, step in self._problem.steps():
                events += isinstance(step, Impact | Kick | Arrival)
                if isinstance(step, Find | Show):
                    spoken += names_of(scene.at(events), step)
            if len(spoken) == len(self._parts):
                self._named = dict(zip(self._parts, spoken, strict=True))
        words = self._named.get(item)
        return (self.text(item),) if words is None else (_laid(words),)

    def is_place(self, line: Line) -> bool:
        """Whether it is a place that was asked."""
        match self.asked(line):
            case Value(expression=Quantity("position", _, _)):
                return True
        return False

    def claim(self, line: Line) -> Sentence | None:
        """What was to be shown, where it is a meeting and no equation."""
        asked = self.asked(line)
        if not isinstance(asked, Show) or not isinstance(asked.relation, Meets):
            return None
        return claim_of_meeting(asked.relation, self._naming)


def _laid(words: Words) -> lay.Layout | str:
    """Words of a question as an operand."""
    pieces = [each.text if isinstance(each, Named) else each for each in words]
    if all(isinstance(each, str) for each in pieces):
        return "".join(map(str, pieces))
    if len(pieces) == 1:
        return pieces[0]
    return lay.Phrase(tuple(lay.Words(e) if isinstance(e, str) else e for e in pieces), "")


def claim_of_meeting(relation: Meets, naming: Naming) -> Sentence:
    """That two bodies will meet, or that they will not."""
    one, other = relation.first.name, relation.second.name
    again = say("again") if relation.again else ""
    if naming.bodies.get(other) == "wall":
        if relation.happens:
            return say("claim.will-hit", body=one, wall=other, again=again)
        return say("claim.will-not-hit", body=one, wall=other, again=again)
    if relation.happens:
        return say("claim.will-collide", one=one, other=other, again=again)
    return say("claim.will-not-collide", one=one, other=other, again=again)


def _ends(derivation: Derivation) -> Iterator[ItemEnd]:
    """The last lines of items, also of one of which the value is impossible."""
    yield from derivation.items
    for note in derivation.notes:
        line = derivation.line(max(note.lines, default=0))
        if note.kind == "impossible" and line is not None and line.item == note.item:
            assert isinstance(line.relation, Relation)
            yield ItemEnd(note.item, line.number, line.relation, note.part)


def _asked(step: Any) -> Iterator[Item | Show]:
    if isinstance(step, Find):
        yield from step.items
    elif isinstance(step, Show):
        yield step
