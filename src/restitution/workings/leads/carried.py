"""What lines take from other parts of a working: named, with its part, in the words before them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence

from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.explaining.lines.layouts import chains
from restitution.explaining.lines.saying import Sentence, Slot, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import is_share_of_energy, trees_of
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Quantity,
    is_component,
    is_function,
    is_zero,
    letters,
    walk,
)
from restitution.render import layout as lay
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.figure_multiples import is_one_term
from restitution.workings.naming.measured import Measures, is_plain, with_unit
from restitution.workings.naming.quantities import Naming, with_article
from restitution.workings.naming.senses_at_walls import away, is_turned
from restitution.workings.naming.sources import Sources, is_time

# These name what is put in.
_PUTTING: frozenset[SentenceId] = frozenset(
    {
        "derived.put",
        "derived.put-in",
        "derived.since-put",
        "derived.since-put-in",
        "derived.moves-put",
    }
)
# The same where all that is put in are equations: *Substituting e = ½ from part (a)*.
_PUTTING_VALUES: dict[SentenceId, SentenceId] = {
    "derived.put": "derived.put-values",
    "derived.put-in": "derived.put-values-in",
    "derived.since-put": "derived.since-put-values",
    "derived.since-put-in": "derived.since-put-values-in",
}
# No sentences: what goes with them stands behind a comma.
_PHRASES: frozenset[SentenceId] = _PUTTING | {
    *_PUTTING_VALUES.values(),
    "derived-between.title-of",
    "derived-between.title-turned",
    "given.by-the-product",
    "given.by-those-that-change",
    "given.by-what-changes",
    "given.fact-across-wall",
    "given.fact-without-mass",
    "flight.time-to-rest",
    "flight.time-to-rest-until",
    "flight.add",
    "flight.subtract",
    "made.difference",
    "made.difference-of-energies",
    "made.difference-of-velocities",
    "made.fraction-lost",
    "made.product",
    "made.ratio",
    "made.sum",
    "next-wall.angle",
    "next-wall.between",
    "next-wall.corner",
    "next-wall.exterior",
    "next-wall.exterior-before",
    "derived.add",
    "derived.by-from",
    "derived.combine",
    "derived.divide",
    "derived.put-last",
    "derived.since",
    "derived.since-by",
    "derived.since-in",
    "derived.solve",
    "derived.square-add",
}
_BY_COMPONENTS: frozenset[SentenceId] = frozenset(
    {"derived-speed.title", "derived-speed.title-of", "derived-assembled.title"}
)


class Carried:
    """The values of earlier parts on which lines rest, where these do not cite them by numbers.

    Each is named once in a part, before the first row that takes it. Its value stands in that row.
    """

    def __init__(
        self,
        derivation: Derivation,
        naming: Naming,
        measures: Measures,
        sources: Sources,
        ends: Ends,
        figures: Callable[[Link], Link],
        unprinted: Callable[[Line], bool],
    ) -> None:
        self._derivation = derivation
        self._naming = naming
        self._measures = measures
        self._sources = sources
        self._ends = ends
        self._figures = figures
        self._unprinted = unprinted
        self._named: set[tuple[str | None, int]] = set()
        self._waiting: dict[int, Line] = {}
        self._ratios: set[Expression] = set()  # in the rows that take what waits
        self._subject: Expression | None = None
        labels = map(ends.part, derivation.lines)
        self._first = next(filter(None, labels), None)

    def gather(self, lines: Iterable[Line]) -> bool:
        """Whether lines take values of other parts; these wait for the words before the row."""
        lines = tuple(lines)
        values: dict[int, Line] = {}
        beside: list[Line] = []
        part: str | None = None
        for line in lines:
            part, source = self._ends.part(line), self._sources.of(line)
            cited = () if source is None else source.numbered
            for ref in line.premises:
                own = self._derivation.line(ref)
                if own is None or ref in cited or (part, ref) in self._named:
                    continue
                label = self._ends.part(own)
                if label == part or not (_is_a_value(own) or _has_ratios(own)):
                    continue
                if label is None and part == self._first:
                    continue  # it stands just above
                if self._unprinted(own):
                    continue
                if line.move.record == "difference" and self._is_a_component(own):
                    continue  # it only tells which way a body goes
                if own.move.record == "unchanged":
                    beside.append(own)
                else:
                    values[own.number] = own
        # A component that stays is named beside the other one of that velocity alone.
        values |= {line.number: line for line in _others(beside, tuple(values.values()))}
        self._named |= {(part, number) for number in values}
        if values:
            self._ratios = self._ratios if self._waiting else set()
            trees = (tree for line in lines for tree in trees_of(line.relation))
            self._ratios |= {
                node
                for tree in trees
                for node in walk(tree)
                if is_function(node, "sin", "cos", "tan")
            }
        self._waiting |= values
        return bool(values)

    def _is_a_component(self, line: Line) -> bool:
        """Whether a line says a component of a velocity, by a letter for it or by its name."""
        assert isinstance(line.relation, Relation)
        left = line.relation.only[0].left
        for earlier in self._derivation.lines:
            if isinstance(earlier.relation, Meaning) and left == Letter(earlier.relation.letter):
                left = earlier.relation.quantity
        return is_component(left)

    def beside(
        self,
        title: Sentence | None,
        sentences: Sequence[Sentence],
        subject: Expression | None = None,
    ) -> tuple[tuple[Sentence, ...], Sentence | None]:
        """The words before a row, and behind them where the values come from that wait.

        Of the row's own ``subject`` the value is said too, as the row has another.
        """
        lines = [self._waiting[number] for number in sorted(self._waiting)]
        self._waiting = {}
        self._subject = subject
        *above, last = sentences or (None,)
        if lines and last is not None and last.id in _PUTTING:
            last, lines = self._put(last, lines)
        if last is not None and last.id == "resolved.before-vector" and len(lines) == 1:
            last, lines = self._with_its_part(last, lines)
        spoken = tuple(filter(None, (*above, last)))
        if not lines:
            return spoken, None
        if title is not None and title.id in _BY_COMPONENTS and self._are_components(lines):
            label = self._ends.part(lines[0])
            return spoken, say("carried.in", label=label) if label else say("carried.in-above")
        sources = tuple(self._sources_of(lines))
        if last is not None and last.id in ("so", "made.by-these"):
            spoken = spoken[:-1]  # it follows from what is named
        if not spoken:
            return spoken, say("carried.with" if title else "carried.with-alone", sources=sources)
        phrase = last is not None and (last.id in _PHRASES or last.topic.startswith("resolved"))
        return spoken, say("carried.with" if phrase else "carried.with-anew", sources=sources)

    def _are_components(self, lines: Sequence[Line]) -> bool:
        """Whether lines of one part say components, by these names."""
        parts = {self._ends.part(line) for line in lines}
        return len(parts) == 1 and all(tuple(_resolved(line)) for line in lines)

    def _with_its_part(self, sentence: Sentence, lines: list[Line]) -> tuple[Sentence, list[Line]]:
        """A velocity of one component with the part that has the letter for that."""
        (line,) = lines
        label = self._ends.part(line)
        slots = dict(sentence.slots)
        if label is None or not self._is_a_component(line):
            return sentence, lines
        return say("resolved.before-vector-from", **slots, label=label), []

    def _put(self, sentence: Sentence, lines: list[Line]) -> tuple[Sentence, list[Line]]:
        """A sentence that names what is put in with the part from which that is; and the rest."""
        put = dict(sentence.slots)["letters"]
        assert isinstance(put, tuple)
        there = [line for line in lines if self._name(line) in put]
        if not there:
            return sentence, lines
        names = [self._name(line) for line in there]
        sources = tuple(self._sources_of(there))
        others = tuple(name for name in put if name not in names)
        slots = {**dict(sentence.slots), "letters": (*sources, *others)}
        are_equations = not others and all(
            isinstance(value, lay.Relation) for value in self._values(there)
        )
        name = _PUTTING_VALUES.get(sentence.id, sentence.id) if are_equations else sentence.id
        return say(name, **slots), [line for line in lines if line not in there]

    def _sources_of(self, lines: Sequence[Line]) -> Iterator[Sentence]:
        """What stands in which part, part by part."""
        parts: dict[str | None, list[Line]] = {}
        for line in lines:
            parts.setdefault(self._ends.part(line), []).append(line)
        for label, own in parts.items():
            values = tuple(self._values(own))
            if label is None:
                yield say("carried.from-above", values=values)
            else:
                yield say("carried.from-part", values=values, label=label)

    def _values(self, lines: Sequence[Line]) -> Iterator[Slot]:
        """What lines say the value of: components of a velocity as one, numbers by an equation."""
        resolved = [velocity for line in lines for velocity in _resolved(line)]
        for velocity in dict.fromkeys(resolved):
            if resolved.count(velocity) > 1:
                yield say("carried.components", velocity=self._naming.layout(velocity))
        beside_numbers = any(map(self._is_a_number, lines))
        for line in lines:
            if any(resolved.count(velocity) > 1 for velocity in _resolved(line)):
                continue
            assert isinstance(line.relation, Relation)
            if _has_ratios(line):
                lefts = [own[0].left for own in chains(line.relation.only)]
                used = [left for left in lefts if self._ratios.intersection(walk(left))]
                yield from map(self._naming.layout, used or lefts)
                continue
            left = line.relation.only[0].left
            link = self._figures(Link(left, "=", line.relation.only[-1].right))
            value = self._naming.layout(link.right)
            own = left == self._subject
            number = isinstance(left, Letter) and not letters(link.right) and is_plain(value)
            # Beside a number a short value in letters is said too.
            number |= beside_numbers and isinstance(left, Letter) and is_one_term(link.right)
            if not (own or number):
                yield self._name(line)
                continue
            value = with_unit(value, self._measures.unit(left)) if is_plain(value) else value
            yield lay.Relation((self._naming.layout(left), value), (link.sign,))

    def _is_a_number(self, line: Line) -> bool:
        """Whether a line gives a letter as a number."""
        assert isinstance(line.relation, Relation)
        link = line.relation.only[0]
        right = line.relation.only[-1].right
        plain = isinstance(link.left, Letter) and not letters(right)
        return plain and is_plain(self._naming.layout(right))

    def _name(self, line: Line) -> Sentence | lay.Layout:
        """What a line says the value of: a letter, or words with an article."""
        assert isinstance(line.relation, Relation)
        links = line.relation.only
        left = links[0].left
        match left:
            case Binary("/", Quantity("energy_lost", (), int(stage))) if self._naming.several:
                event = self._naming.called(self._naming.events[stage])
                return say("fraction-lost.at", event=event)
            case Binary("/", Quantity("energy"), Quantity("energy")):
                return say("fraction-lost.of-energies")
        sides = [self._naming.layout(tree) for tree in (left, *(link.right for link in links))]
        if self._ends.of(line) is None and is_turned(self._naming, links, sides):
            return with_article(away(self._naming, left))
        return with_article(sides[0])


def _is_a_value(line: Line) -> bool:
    """Whether a line gives a value that was worked out, and no plain datum."""
    relation = line.relation
    return (
        isinstance(relation, Relation)
        and len(relation.options) == 1
        and len(chains(relation.only)) == 1
        and relation.only[-1].sign == "="
        and not is_zero(relation.only[-1].right)
        and (
            isinstance(left := relation.only[0].left, Letter | Quantity)
            or is_time(left)
            or is_share_of_energy(line)
        )
        and line.shown != "silent"
        and line.move.id not in ("triangle", "fact")
    )


def _has_ratios(line: Line) -> bool:
    """Whether a line gives ratios of an angle, or their squares, by a line above it."""
    relation = line.relation
    return (
        isinstance(relation, Relation)
        and len(relation.options) == 1
        and (line.move.id, line.shown) == ("triangle", "line")
        and any(isinstance(ref, int) for ref in line.premises)
    )


def _others(beside: Sequence[Line], lines: Sequence[Line]) -> Iterator[Line]:
    """The components of velocities that have another one among lines."""
    velocities = {velocity for line in lines for velocity in _resolved(line)}
    for line in beside:
        if not velocities.isdisjoint(_resolved(line)):
            yield line


def _resolved(line: Line) -> Iterator[Expression]:
    """The velocity of which a line says a component."""
    match line.relation:
        case Relation(((Link(Quantity("along" | "across", (velocity, _))), *_),)):
            yield velocity
