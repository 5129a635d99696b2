"""Components that an impact does not change, said as one sentence."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from fractions import Fraction

from restitution.explaining.lines.derivation import Derivation, Event, Line, Ref, Relation
from restitution.explaining.lines.layouts import chains
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Expression,
    Letter,
    Number,
    Pair,
    Quantity,
    Unit,
    is_quantity,
    is_zero,
    letters,
)
from restitution.planning.writing.forms import negative
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.measured import Measures, is_plain, with_unit
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.senses_at_walls import is_turned_along
from restitution.workings.naming.sources import Sources


def _ids(premises: Iterable[Ref]) -> Iterator[str]:
    """The facts among premises."""
    return (ref for ref in premises if isinstance(ref, str))


def _parts(tree: Expression) -> tuple[Expression, ...]:
    return (tree.x, tree.y) if isinstance(tree, Pair) else (tree,)


class Staying:
    """The lines of one derivation that tell of a component that stays, and of nothing more."""

    def __init__(
        self,
        derivation: Derivation,
        naming: Naming,
        measures: Measures,
        sources: Sources,
        ends: Ends,
        figures: Callable[[Expression], Expression],
    ) -> None:
        self._naming = naming
        self._measures = measures
        self._sources = sources
        self._ends = ends
        self._figures = figures
        self._lines = {line.number: line for line in derivation.lines}
        self._facts = {fact.id: fact for fact in derivation.facts}
        self._cases = {n: case.number for case in derivation.cases for n in case.lines}
        self._noted = {n for note in derivation.notes for n in note.lines}

    def stays(self, line: Line) -> bool:
        """Whether a line tells of a component that stays, and no more than that."""
        if line.move.id != "law" or line.move.record != "unchanged" or line.shown != "line":
            return False
        if line.number in self._sources.numbers or self._ends.of(line) is not None:
            return False
        relation = line.relation
        return (
            isinstance(relation, Relation)
            and len(relation.options) == 1
            and isinstance(relation.only[0].left, Quantity)
            and all(link.sign == "=" for link in relation.only)
            and len(chains(relation.only)) == 1
        )

    def together(self, line: Line, other: Line) -> bool:
        """Whether two such lines are about one impact, in one case."""
        one, two = (self._cases.get(own.number) for own in (line, other))
        return line.move.event == other.move.event and one == two

    def is_idle(self, line: Line) -> bool:
        """Whether a line says that a component stays 0, and earns nothing.

        One that was worked out to be 0 is said to stay so, as is one that contradicts the data.
        """
        relation = line.relation
        return (
            isinstance(relation, Relation)
            and relation.only[-1].right == Number(Fraction(0))
            and not line.marks
            and line.number not in self._noted
            and not (line.move.record == "unchanged" and any(map(self._is_product, line.premises)))
        )

    def _is_product(self, ref: Ref) -> bool:
        """Whether a premise is a component by a scalar product, with what that comes to."""
        own = self._lines.get(ref) if isinstance(ref, int) else None
        if own is None or own.move.record != "component" or own.shown != "line":
            return False
        return isinstance(own.relation, Relation) and len(own.relation.only) > 1

    def is_nothing(self, line: Line) -> bool:
        """Whether a line says that a body at rest has no component, or stays where it is.

        No one writes that, nor that a body stays on an axis.
        """
        if (line.move.id, line.move.record) == ("define", "straight-line"):
            assert isinstance(line.relation, Relation)
            if is_quantity(line.relation.only[0].left, "time"):
                return False  # when those meet who start in one place
            named = line.number in self._sources.numbers or self._ends.of(line) is not None
            if len(line.relation.only) > 1:
                return False  # it is worked out
            return not named and not line.marks and (self.is_idle(line) or self._rests(line))
        if (line.move.id, line.move.record) != ("define", "component"):
            return False
        assert isinstance(line.relation, Relation)
        wanted = line.number in self._sources.numbers or self._ends.of(line) is not None
        known_later = self._is_rest_given_later(line)
        return (
            len(line.relation.only) == 1 and not wanted and not known_later and self.is_idle(line)
        )

    def _is_rest_given_later(self, line: Line) -> bool:
        """Whether a line gives a letter, with which a line above was written, by a given rest."""
        assert isinstance(line.relation, Relation)
        letter, facts = line.relation.only[0].left, map(self._facts.get, _ids(line.premises))
        if not isinstance(letter, Letter) or all(e is None or e.kind != "given" for e in facts):
            return False
        return any(
            isinstance(own.relation, Relation)
            and own.shown != "silent"
            and any(letter.name in letters(tree) for tree in trees_of(own.relation))
            for own in self._lines.values()
            if own.number < line.number
        )

    def _sense(self, line: Line, event: Event) -> lay.Layout | None:
        """The direction in which a component that stays is counted, where it has a short name."""
        assert isinstance(line.relation, Relation)
        match line.relation.only[0].left:
            case Quantity("along", (_, Unit() as own)):
                return None if self._naming.at_the_wall(own) else self._naming.layout(own)
            case Quantity("across", (_, Quantity())):
                if self._naming.bold.is_read_off(event.number):
                    return None
                unit: lay.Layout | None = self._naming.bold.unit(event.number, "across")
                unit = unit or self._naming.bold.direction(event.number, "across")
                own_ = self._naming.unit_of(event, "across")
                return unit or (None if own_ is None else self._naming.layout(own_))
        return None

    def _rests(self, line: Line) -> bool:
        """Whether a line is about a body that is at rest until then."""
        facts = [self._facts.get(premise) for premise in line.premises if isinstance(premise, str)]
        if len(facts) != len(line.premises):
            return False
        return any(
            fact is not None
            and fact.id.partition(" ")[0] == "velocity"
            and all(is_zero(part) for part in _parts(fact.relation.only[0].right))
            for fact in facts
        )

    def sentences(self, lines: Sequence[Line]) -> tuple[Sentence, Sentence]:
        """The components that stay as a title and a sentence."""
        event = self._naming.events[lines[0].move.event or 1]
        values: list[tuple[str, lay.Layout]] = []
        for line in [own for own in lines if not self._moves_off(own)] or lines:
            assert isinstance(line.relation, Relation)
            links = line.relation.only
            trees = [self._figures(link.right) for link in links]
            carried = [tree != link.right for tree, link in zip(trees, links, strict=True)]
            signs = tuple("≈" if put else "=" for put in carried[1:])
            if is_turned_along(self._naming, line):
                trees = [negative(tree) for tree in trees]
            sides = [self._naming.layout(tree) for tree in trees]
            unit = self._measures.unit(line.relation.only[0].left)
            if is_plain(sides[-1]) and sides[-1] != lay.Number("0"):
                sides[-1] = with_unit(sides[-1], unit)
            body = line.move.bodies[0] if line.move.bodies else event.bodies[0]
            whole = lay.Relation(tuple(sides), signs)
            values.append((body, whole if len(sides) > 1 else sides[0]))
        axis = self._sense(lines[0], event)
        return self._title(event), self._sentence(event, values, axis)

    def _moves_off(self, line: Line) -> bool:
        """Whether it is said below that a body at rest moves off along the line of centres."""
        assert isinstance(line.relation, Relation)
        link = line.relation.only[-1]
        if not (is_zero(link.right) and is_quantity(link.left, "across") and self._rests(line)):
            return False
        return any(
            own.move.record in ("speed", "assemble")
            and (own.move.event, own.move.bodies) == (line.move.event, line.move.bodies)
            and own.shown == "line"
            for own in self._lines.values()
        )

    def _title(self, event: Event) -> Sentence:
        if not event.wall:
            return say("unchanged.title")
        wall = event.bodies[1]
        if wall in self._naming.circles:
            return say("unchanged-wall.circle", wall=wall)
        return say("unchanged-wall.title", wall=wall)

    @staticmethod
    def _sentence(
        event: Event, values: Sequence[tuple[str, lay.Layout]], axis: lay.Layout | None
    ) -> Sentence:
        """The components that stay, in the direction of an axis where that is not None."""
        (body, value), *others = values
        if event.wall:
            if axis is None:
                return say("unchanged-wall.component", value=value)
            return say("unchanged-wall.component-in", value=value, axis=axis)
        whole = [v.operands[-1] if isinstance(v, lay.Relation) else v for _, v in values]
        # A sign needs a sense.
        left = axis is None and any(to_text(v).startswith("−") for v in whole)
        if left and not others:
            first, second = event.bodies
            return say("derived.stays-left", of=body, value=value, first=first, second=second)
        if not others:
            if axis is None:
                return say("derived.stays", of=body, value=value)
            return say("derived.stays-in", of=body, value=value, axis=axis)
        components = [say("unchanged.component", value=v, body=b) for b, v in values]
        if all(own == value for _, own in others):
            components = [say("unchanged.each", value=value)]
        if left:
            first, second = event.bodies
            slots = {"first": first, "second": second}
            return say("unchanged.components-left", components=components, **slots)
        if axis is None:
            return say("unchanged.components", components=components)
        return say("unchanged.components-in", components=components, axis=axis)
