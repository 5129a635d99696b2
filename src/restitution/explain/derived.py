"""A derivation as a worked solution: what it says in sentences and rows, for every renderer.

Premises are not printed but where a reader looks for them: which equations were combined, why a
root is rejected, on what an inequality rests. An equation has a number only where it is named.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import groupby
from typing import TYPE_CHECKING, Any

from restitution.explain.measured import (
    Measures,
    as_answer,
    as_decimal,
    is_plain,
    percentage,
    rounded,
    to_three_figures,
    with_unit,
)
from restitution.explain.naming import Naming
from restitution.explain.reasons import Reasons
from restitution.explain.sources import Source, Sources
from restitution.explain.steps import REQUIRED, Explanation, PartExplanation, Row, Step
from restitution.explaining.definitions import tie_of
from restitution.explaining.derivation import (
    Derivation,
    Event,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.layouts import chains
from restitution.explaining.marks import Mark, Marks, reasoned
from restitution.explaining.notation import read_tree
from restitution.explaining.saying import Sentence, operand, say
from restitution.expression.tree import (
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
)
from restitution.problem import Find, Item, Meets, Problem, Show, Value
from restitution.render import layout as lay

if TYPE_CHECKING:
    from restitution.solve.solution import Solution

_TITLED = frozenset({"law", "define"})
# Letters along a line of centres that is given as a direction, and one that is given by its angle.
_TOWARDS = ("let.component-centres-towards", "let.components-centres-towards")
_AT = ("let.component-centres-at", "let.components-centres-at")
# Definitions that speak of the whole motion: they begin no working of an impact.
_OF_THE_WHOLE = frozenset(
    {"energy", "total", "total-lost", "energy-ratio", "energy-lost", "assemble", "speed"}
)
# In these the second line of an equation leaves out the side that stays.
_GOES_ON = frozenset({"rearrange", "put", "identity", "value", "cancel"})
# So many lines after a letter was introduced a reader still knows what it stands for.
_REMEMBERED = 3
_WORDS = {"parallel to": "claim.parallel", "perpendicular to": "claim.perpendicular"}


def explanation_of(
    derivation: Derivation,
    problem: Problem,
    solution: Solution | None = None,
    conditions: Mapping[int, Sentence] | None = None,
) -> Explanation:
    """The working as a value that text, Markdown, LaTeX, HTML and Typst are made of.

    With the ``solution`` it can be illustrated. ``conditions`` are said below the lines with
    these numbers.
    """
    writer = _Writer(derivation, problem, conditions or {})
    parts: list[PartExplanation] = []
    by_part = groupby(derivation.lines, writer.part_of)
    for label, lines in by_part:
        steps = tuple(_joined(writer.steps(list(lines))))
        ends = [each for each in derivation.items if each.part == label]
        asked = tuple(writer.asked(each) for each in dict.fromkeys(e.item for e in ends))
        answers = tuple(_plain(writer.relation(each.answer)) for each in ends)
        parts.append(PartExplanation(label, asked, steps, answers))
    return Explanation(problem.title, tuple(parts), problem.warnings, solution)


def _joined(steps: Iterator[Step]) -> Iterator[Step]:
    """Steps with the rows that follow without a word among the rows above them."""
    last: Step | None = None
    for step in steps:
        wordless = step.rows and not step.title and not step.sentences
        if last is not None and last.rows and wordless and step.item == last.item:
            rows = step.rows
            if _says_again(last.rows[-1], rows[0]):
                points = (*last.rows[-1].points, *rows[0].points)
                rows = (replace(last.rows[-1], points=points), *rows[1:])
                last = replace(last, rows=last.rows[:-1])
            last = replace(last, rows=(*last.rows, *rows))
            continue
        if last is not None:
            yield last
        last = step
    if last is not None:
        yield last


def _says_again(row: Row, other: Row) -> bool:
    """Whether a row says in print what the one above it says."""
    return (
        other.operands[0] in (None, row.operands[0])
        and (row.operands[1:], row.signs) == (other.operands[1:], other.signs)
        and not (other.reasons or other.asides or other.number)
    )


def _plain(layout: lay.Layout) -> str:
    from restitution.render.text import to_text

    return to_text(layout)


@dataclass
class _Writer:
    """One derivation on its way to paper."""

    derivation: Derivation
    problem: Problem
    conditions: Mapping[int, Sentence] = field(default_factory=dict)
    heading: int | None = None
    title: Sentence | None = None
    left: tuple[Expression, str | None] | None = None
    said: tuple[Sentence, ...] = ()

    def __post_init__(self) -> None:
        self.naming = Naming(self.derivation, self.problem)
        self.measures = Measures(self.problem, self.derivation.meanings)
        self.events = self.naming.events
        self.ends = {each.line: each for each in self.derivation.items}
        parts = {each.item: each.part for each in self.derivation.items}
        self.items = {
            each: [e for e in parts if parts[e] == parts[each]].index(each) for each in parts
        }
        self.parts = parts
        asked = [each for _, step in self.problem.steps() for each in _asked(step)]
        self.of_items: Mapping[str, Item | Show] = (
            dict(zip(parts, asked, strict=True)) if len(asked) == len(parts) else {}
        )
        self.sources = Sources(self.derivation)
        self.reasons = Reasons(self.derivation, self.naming)
        self.cases = {n: each for each in self.derivation.cases for n in each.lines}
        self.case: int | None = None
        self.given: set[str] = set()
        self.entered: set[int] = set()
        self.stay: list[Line] = []
        self.recalled: set[tuple[str | None, int]] = set()

    def part_of(self, line: Line) -> str | None:
        """The label of the part to which a line belongs."""
        return self.parts.get(line.item or "")

    def asked(self, item: str) -> str:
        """An item as it was typed."""
        known = self.of_items.get(item)
        return known.text if known is not None and known.text else item

    def relation(self, relation: Relation) -> lay.Layout:
        """A whole relation in one line."""
        return self.naming.relation(relation)

    # --- steps ----------------------------------------------------------------------------------

    def steps(self, lines: list[Line]) -> Iterator[Step]:
        """The lines of a part as steps."""
        self.title = self.left = None
        lets: list[Meaning] = []
        conditions: list[Sentence] = []
        waiting: list[Line] = []
        shown = [each for each in lines if each.shown != "silent"]
        for index, line in enumerate(shown):
            if isinstance(line.relation, Meaning):
                lets.append(line.relation)
                continue
            yield from self._entered(line)
            if not waiting:
                yield from self._recalled(line)
            if lets:
                yield Step("setting", sentences=tuple(self._setting(lets)))
                lets, self.left = [], None
            if line.shown == "inline":
                waiting.append(line)
                continue
            after = shown[index + 1] if index + 1 < len(shown) else None
            if self._stays(line) and not waiting:
                self.stay.append(line)
                if after is not None and self._stays(after) and self._same_law(line, after):
                    continue
                together, self.stay = self.stay, []
                if all(map(_is_idle, together)):
                    continue  # of bodies on one line there is nothing to say
                step = self._unchanged(together)
            else:
                step = self._step(line, waiting)
                waiting = []
            introduced = self.naming.introduced()
            if introduced:
                step = self._whole(step, line)
                yield Step("setting", sentences=introduced)
            yield step
            claim = self._claim(line)
            if claim is not None:
                yield Step("note", sentences=(say("shown.claim", claim=claim),), item=step.item)
            condition = self.conditions.get(line.number)
            if condition is not None and condition not in conditions:
                conditions.append(condition)
                yield Step("note", sentences=(condition,), item=step.item)

    def _recalled(self, line: Line) -> Iterator[Step]:
        """The values of earlier parts on which a line rests, where it does not name them."""
        source = self.sources.of(line)
        named = () if source is None else source.numbered
        values: dict[str | None, list[Row]] = {}
        for ref in line.premises:
            own = self.derivation.line(ref) if isinstance(ref, int) else None
            if own is None or ref in named or (self.part_of(line), ref) in self.recalled:
                continue
            label = self.part_of(own)
            if label == self.part_of(line) or not self._is_recalled(own):
                continue
            assert isinstance(own.relation, Relation)
            self.recalled.add((self.part_of(line), own.number))
            link = own.relation.only[-1]
            left = own.relation.only[0].left
            value = self.naming.laid(link.right)
            if is_plain(value) and value != lay.Number("0"):
                value = with_unit(value, self.measures.unit(left))
            row = Row((self.naming.laid(left), value), ("=",))
            values.setdefault(label, []).append(row)
        for label, rows in values.items():
            where = say("carried.part", label=label) if label else say("carried.above")
            self.title = self.left = None
            item = self.items.get(line.item or "")
            yield Step("result", tuple(rows), sentences=(where,), item=item)

    @staticmethod
    def _is_recalled(line: Line) -> bool:
        """Whether a line gives a value that was worked out, and no plain datum."""
        relation = line.relation
        return (
            isinstance(relation, Relation)
            and len(relation.options) == 1
            and len(chains(relation.only)) == 1
            and relation.only[-1].sign == "="
            and isinstance(relation.only[0].left, Letter | Quantity)
            and line.shown != "silent"
            and line.move.id not in ("triangle", "fact")
            and line.move.record != "unchanged"
        )

    def _whole(self, step: Step, line: Line) -> Step:
        """A step whose first row goes on from the row above, with its left side after all."""
        if not step.rows or step.rows[0].operands[0] is not None:
            return step
        assert isinstance(line.relation, Relation)
        first, *rest = step.rows
        left = self.naming.laid(line.relation.options[0][0].left)
        first = replace(first, operands=(left, *first.operands[1:]))
        return replace(step, rows=(first, *rest))

    def _entered(self, line: Line) -> Iterator[Step]:
        """What stands before the lines of an event, or of a case."""
        case = self.cases.get(line.number)
        number = None if case is None else case.number
        if number != self.case:
            self.case, self.title, self.left = number, None, None
            behind = None if case is None else self.derivation.line(case.line)
            if case is not None and behind is not None:
                assert isinstance(behind.relation, Relation)
                options = (behind.relation.options[case.option],)
                values = (self.relation(Relation(options)),)
                yield Step("heading", sentences=(say("heading.case", values=values),))
        yield from self._heading(line)

    def _heading(self, line: Line) -> Iterator[Step]:
        """A heading where the next of several events begins."""
        number = line.move.event
        if number is None or number == self.heading or len(self.naming.impacts) < 2:
            return
        if line.move.record in _OF_THE_WHOLE:
            return
        if line.move.id == "define" and number in self.entered:
            return
        event = self.events.get(number)
        if event is not None and event.kind == "impact":
            self.heading = self.naming.now = number
            self.entered.add(number)
            self.title = self.left = None
            yield Step("heading", sentences=(self.naming.heading(event),), event=number)

    def _setting(self, lets: list[Meaning]) -> Iterator[Sentence]:
        """What letters stand for: quantities by name, and the others as equations."""
        for kind, group in groupby(lets, self._kind):
            meanings = list(group)
            if kind is None:
                yield say(
                    "derived.name",
                    equations=tuple(
                        lay.Relation((self._letter(each), self.naming.laid(each.quantity)), ("=",))
                        for each in meanings
                    ),
                )
            elif kind == "named":
                yield say(
                    "derived.let",
                    meanings=tuple(
                        say(
                            "derived.meaning",
                            letter=self._letter(each),
                            quantity=self.naming.of_letter(each),
                        )
                        for each in meanings
                    ),
                )
            else:
                yield from self._components(kind, meanings)
            for each in meanings:
                self.naming.knows(each.quantity, each.letter)

    def _letter(self, meaning: Meaning) -> lay.Layout:
        return self.naming.laid(Letter(meaning.letter))

    def _kind(self, meaning: Meaning) -> Any:
        """Letters that are introduced in one sentence: components of one impact; the others."""
        match meaning.quantity:
            case Quantity("along", (Quantity("velocity", (Name(body),), int(stage)), axis)):
                event = self.naming.event_of_axis(axis)
                sense = meaning.sense if meaning.sense is not None else axis
                if event is not None and event.number == stage:
                    turned = self._turned(axis, sense)
                    if turned is None:
                        return ("axis", sense)
                    return ("wall" if event.wall else "centres", event, turned)
                if isinstance(sense, Unit) and event is None and stage == self.naming.last(body):
                    return ("axis", sense)
                return "named"
            case Quantity():
                return "named"
        return None

    @staticmethod
    def _turned(axis: Expression, sense: Expression) -> bool | None:
        """Whether a sense is against the axis; None where it is another direction."""
        own, back = (
            (each.operand, True) if isinstance(each, Negate) else (each, False)
            for each in (axis, sense)
        )
        return own[1] != back[1] or own[1] if own[0] == back[0] else None

    def _components(self, kind: tuple[Any, ...], meanings: list[Meaning]) -> Iterator[Sentence]:
        letters = tuple(self._letter(each) for each in meanings)
        bodies = tuple(each.quantity.arguments[0].arguments[0].name for each in meanings)  # type: ignore[union-attr]
        if kind[0] == "axis":
            axis = self.naming.laid(kind[1])
            if len(letters) > 1:
                yield say("let.components", letters=letters, bodies=bodies, axis=axis)
            else:
                yield say("let.component", letter=letters[0], body=bodies[0], axis=axis)
            return
        event: Event = kind[1]
        first, second = reversed(event.bodies) if kind[2] else event.bodies
        if kind[0] == "wall":
            name = "derived.away" if kind[2] else "derived.towards"
            for letter, body in zip(letters, bodies, strict=True):
                yield say(name, letter=letter, body=body, wall=event.bodies[1])
        elif (given := self._given_axis(event, turned=kind[2])) is not None:
            (one, several), slots = given
            if len(letters) > 1:
                yield say(several, letters=letters, bodies=bodies, **slots)
            else:
                yield say(one, letter=letters[0], body=bodies[0], **slots)
        elif len(letters) > 1:
            yield say(
                "let.components-centres",
                letters=letters,
                bodies=bodies,
                first=first,
                second=second,
            )
        else:
            yield say(
                "let.component-centres",
                letter=letters[0],
                body=bodies[0],
                first=first,
                second=second,
            )

    def _given_axis(
        self, event: Event, *, turned: bool
    ) -> tuple[tuple[str, str], dict[str, Any]] | None:
        """The direction in which a line of centres is given, which need not be that of approach.

        The sentences for one letter and for several, and what they say; None where the line is
        worked out: then it leads from the first body to the second.
        """
        fact = self.derivation.fact(" ".join(("axis", str(event.number))))
        if fact is None:
            return None
        axis = fact.relation.only[0].right
        if isinstance(axis, Polar):
            return None
        if isinstance(axis, Degrees | Letter):
            unit = self.naming.laid(Negate(Unit("i")) if turned else Unit("i"))
            return _AT, {"axis": self.naming.laid(axis), "unit": unit}
        sense: Expression = axis
        if turned:
            sense = axis.operand if isinstance(axis, Negate) else Negate(axis)
        return _TOWARDS, {"axis": self.naming.laid(sense)}

    # --- components that stay -------------------------------------------------------------------

    def _stays(self, line: Line) -> bool:
        """Whether a line tells of a component that stays, and no more than that."""
        if line.move.id != "law" or line.move.record != "unchanged" or line.shown != "line":
            return False
        if line.number in self.sources.numbers or line.number in self.ends:
            return False
        relation = line.relation
        return (
            isinstance(relation, Relation)
            and len(relation.options) == 1
            and isinstance(relation.only[0].left, Quantity)
            and all(each.sign == "=" for each in relation.only)
            and len(chains(relation.only)) == 1
        )

    def _same_law(self, line: Line, other: Line) -> bool:
        return line.move.event == other.move.event and self.cases.get(
            line.number
        ) == self.cases.get(other.number)

    def _unchanged(self, lines: Sequence[Line]) -> Step:
        """The components that stay as a sentence."""
        event = self.events[lines[0].move.event or 1]
        values: list[tuple[str, lay.Layout]] = []
        for line in lines:
            assert isinstance(line.relation, Relation)
            sides = [self.naming.laid(each.right) for each in line.relation.only]
            unit = self.measures.unit(line.relation.only[0].left)
            if is_plain(sides[-1]) and sides[-1] != lay.Number("0"):
                sides[-1] = with_unit(sides[-1], unit)
            body = line.move.bodies[0] if line.move.bodies else event.bodies[0]
            whole = lay.Relation(tuple(sides), ("=",) * (len(sides) - 1))
            values.append((body, whole if len(sides) > 1 else sides[0]))
        title: Sentence = (
            say("unchanged-wall.title", wall=event.bodies[1])
            if event.wall
            else say("unchanged.title")
        )
        if event.wall:
            said = say("unchanged-wall.component", value=values[0][1])
        elif len(values) == 1:
            said = say("derived.stays", of=values[0][0], value=values[0][1])
        else:
            components = [say("unchanged.component", value=v, body=b) for b, v in values]
            said = say("unchanged.components", components=components)
        self.title, self.left = None, None
        points: Marks = tuple(_because(mark) for line in lines for mark in line.marks)
        item = self.items.get(lines[0].item or "")
        return Step("principle", (), title, (said,), points, item=item)

    # --- lines ----------------------------------------------------------------------------------

    def _step(self, line: Line, waiting: Sequence[Line] = ()) -> Step:
        kind: Any = "principle" if line.move.id in _TITLED else "solve"
        given = self._given(line)
        title = None if given else self._title(line)
        named = title is not None and title == self.title
        sentences = given or tuple(self._sentences(line))
        fresh = bool(sentences) or (title is not None and not named)
        rows = list(self._rows(line, waiting, fresh))
        resolved = self._resolved(line) if line.move.record == "component" else None
        if title is not None or sentences or resolved is not None:
            self.title = title or resolved
        again = bool(sentences) and sentences == self.said and not given
        self.said = sentences
        sentences = () if again else sentences
        numbers = self.sources.numbers
        behind = next((numbers[e.number] for e in (line, *waiting) if e.number in numbers), None)
        rows[-1] = replace(
            rows[-1],
            points=tuple(_because(mark) for each in (*waiting, line) for mark in each.marks),
            reasons=(*rows[-1].reasons, *self.reasons.of(line)),
            asides=(*rows[-1].asides, *self._asides(line)),
            number="" if behind is None else str(behind),
        )
        return Step(
            kind,
            tuple(rows),
            None if named else title,
            sentences,
            item=self.items.get(line.item or ""),
        )

    def _given(self, line: Line) -> tuple[Sentence, ...]:
        """The given fact that a definition turns into an equation."""
        if line.move.id != "define":
            return ()
        facts = [
            fact
            for ref in line.premises
            if isinstance(ref, str)
            and (fact := self.derivation.fact(ref)) is not None
            and fact.kind == "given"
            and fact.id not in self.given
        ]
        if line.move.record in ("perpendicular", "parallel"):
            # What else is given is a value that is put in.
            facts = [each for each in facts if tie_of(each.relation.only[0]) is not None]
        if len(facts) != 1:
            return ()
        self.given |= {each.id for each in facts}
        told = self.naming.fact(facts[0])
        assert isinstance(line.relation, Relation)
        if isinstance(line.relation.options[0][0].left, Letter):
            return (say("given.fact", fact=told),)
        nothing = _plain(self.naming.laid(line.relation.options[0][-1].right)) == "0"
        if line.move.record == "perpendicular" and nothing:
            match line.relation.options[0][0].left:
                case Quantity("along" | "across"):
                    pass
                case _:
                    return (say("given.product", fact=told),)
        if line.move.record == "parallel":
            return (say("given.proportion", fact=told),)
        return (say("given.fact", fact=told),)

    def _title(self, line: Line) -> Sentence | None:
        record, event = line.move.record, self.events.get(line.move.event or 0)
        if line.move.id not in _TITLED or record is None:
            return None
        body = line.move.bodies[0] if line.move.bodies else None
        if event is not None and event.wall:
            wall = event.bodies[1]
            match record:
                case "unchanged":
                    return say("unchanged-wall.title", wall=wall)
                case "impulse":
                    return say("impulse-wall.title", body=body or event.bodies[0], wall=wall)
                case "across-the-impulse" | "along-the-change":
                    return say("impulse-normal.title", wall=wall)
                case "component":
                    return None
                case "sum" | "difference":
                    return say("turned-wall.title")
                case "energy-lost":
                    return say("loss-wall.title")
        if record == "straight-line" and body is not None and self.naming.movers > 1:
            return say("flight.title-of", body=body)
        if record == "assemble":
            match line.relation:
                case Relation(options=((Link(left=Quantity("position", _, _)), *_), *_)):
                    return say("derived-place.title")
        if record == "impulse" and event is not None:
            return say("impulse-spheres.title", body=body or event.bodies[0])
        if record == "perpendicular":
            assert isinstance(line.relation, Relation)
            right = line.relation.options[0][-1].right
            if _plain(self.naming.laid(right)) != "0":
                return None
        return say(_TITLES[record]) if record in _TITLES else None

    def _sentences(self, line: Line) -> Iterator[Sentence]:
        """What is said before a row: how it comes from the ones above."""
        source = self.sources.of(line)
        if line.move.id == "fact":
            given = [each for ref in line.premises if (each := self.derivation.fact(str(ref)))]
            if given and isinstance(words := self.naming.fact(given[0]), Sentence):
                yield say("given.fact", fact=words)
            else:
                yield say("given.data")
            return
        if line.move.record == "component" and line.move.id == "define":
            title = self._resolved(line)
            if title is not None and self.title != title:
                yield title
            return
        if line.move.record in ("perpendicular", "parallel") and self._title(line) is None:
            yield say("so")
            return
        if source is not None:
            yield from self._source(source)
        if line.move.id == "identity" and line.move.record in _BY:
            yield say(_BY[line.move.record])

    def _resolved(self, line: Line) -> Sentence | None:
        """What is said before components: of which time they are, and in which directions."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Quantity("along" | "across", (Quantity("velocity", _, int(stage)), axis)):
                event = self.naming.event_of_axis(axis)
            case _:
                return None
        if event is None:
            return None
        if event.wall and stage < event.number:
            return say("resolved-wall.before", wall=event.bodies[1])
        if event.wall:
            return say("resolved-wall.after", wall=event.bodies[1])
        if stage < event.number:
            return say("resolved-spheres.before")
        return say("resolved-spheres.after")

    def _source(self, source: Source) -> Iterator[Sentence]:
        equations = tuple(self._number(each) for each in source.numbered)
        match source.kind:
            case "combine":
                letter = self.naming.laid(read_tree(source.eliminated, self.naming.bodies))
                yield say("derived.combine", letter=letter, equations=equations)
            case "compare" if not equations:
                yield say("given.compare")
            case "divide":
                first, second = equations
                yield say("derived.divide", first=first, second=second)
            case "square-add":
                yield say("derived.square-add", equations=equations)
            case "put":
                letters = tuple(self.naming.laid(each) for each in source.letters)
                facts = tuple(self._fact(each) for each in source.facts)
                told = any(isinstance(e, Sentence) and e.topic == "claim" for e in facts)
                if len(facts) == 1 and told:
                    yield say("given.fact", fact=facts[0])
                elif facts and letters and not source.last and not equations:
                    yield say("derived.since-put", facts=facts, letters=letters)
                elif facts and equations:
                    yield say("derived.since-in", facts=facts, equation=equations[0])
                elif facts:
                    yield say("derived.since", facts=facts)
                elif letters and equations and source.last:
                    yield say("derived.put-last", equation=equations[0])
                elif letters and equations:
                    yield say("derived.put-in", letters=letters, equation=equations[0])
                elif letters and not source.last:
                    yield say("derived.put", letters=letters)
                elif equations:
                    yield say("derived.add", equations=equations)
            case _:
                if equations:
                    yield say("derived.add", equations=equations)

    def _number(self, ref: int) -> Sentence:
        return say("derived.number", number=str(self.sources.numbers[ref]))

    def _fact(self, name: str) -> Sentence | lay.Layout:
        fact = self.derivation.fact(name)
        assert fact is not None
        return self.naming.fact(fact)

    def _asides(self, line: Line) -> Iterator[Sentence]:
        """What stands behind a row in brackets: that it was to be shown."""
        end = self.ends.get(line.number)
        if end is not None and end.shown:
            if self._claim(line) is None:
                yield from REQUIRED
        elif end is not None and isinstance(line.relation, Relation):
            called = self._called(line)
            if called is not None:
                yield called
            decimals = self._decimal_range(line.relation)
            if decimals is not None:
                yield say("derived.value", value=decimals)

    def _claim(self, line: Line) -> Sentence | None:
        """What was to be shown, where it is a meeting and no equation."""
        end = self.ends.get(line.number)
        asked = None if end is None else self.of_items.get(end.item)
        if not isinstance(asked, Show) or not isinstance(asked.relation, Meets):
            return None
        one, other = asked.relation.first.name, asked.relation.second.name
        again = say("again") if asked.relation.again else ""
        happens = asked.relation.happens
        if self.naming.bodies.get(other) == "wall":
            if happens:
                return say("claim.will-hit", body=one, wall=other, again=again)
            return say("claim.will-not-hit", body=one, wall=other, again=again)
        if happens:
            return say("claim.will-collide", one=one, other=other, again=again)
        return say("claim.will-not-collide", one=one, other=other, again=again)

    def _decimal_range(self, relation: Relation) -> lay.Layout | None:
        """A range with its ends to three figures, where they are no plain numbers."""
        if len(relation.options) != 1 or len(chains(relation.only)) != 1:
            return None
        links = relation.only
        if all(each.sign in ("=", "≈") for each in links) or any(
            each.sign not in ("<", "<=", ">", ">=") for each in links
        ):
            return None
        sides = [links[0].left, *(each.right for each in links)]
        decimals = [rounded(each) for each in sides]
        if not any(decimals):
            return None
        laid = [new or self.naming.laid(each) for new, each in zip(decimals, sides, strict=True)]
        return lay.Relation(tuple(laid), tuple(_sign(each) for each in links))

    # --- rows -----------------------------------------------------------------------------------

    def _rows(self, line: Line, waiting: Sequence[Line], fresh: bool) -> Iterator[Row]:
        assert isinstance(line.relation, Relation)
        options = line.relation.options
        (left, item), self.left = self.left or (None, None), None
        left = left if item == line.item else None
        place = self._reached(options)
        if place is not None:
            value, where = place
            row = self._chain(line, value)
            yield replace(row, reasons=(say("derived.for", place=where),))
            return
        if len(options) > 1:
            yield self._alternatives(options, line.number in self.ends)
            return
        if line.move.record in ("greatest", "least") and line.move.id == "answer":
            yield self._extreme(line)
            return
        groups = chains(options[0])
        for index, links in enumerate(groups):
            whole = links
            if waiting and not index:
                whole = self._with(waiting, links)
            row = self._chain(line, whole, last=index == len(groups) - 1)
            same = left is not None and not fresh and whole[0].left == left
            goes_on = line.move.id in _GOES_ON and whole[0].sign in ("=", "≈") and row.signs
            if same and goes_on:
                row = replace(row, operands=(None, *row.operands[1:]))
            yield row
            if whole[0].sign == "=" and len(whole) == 1:
                self.left = (whole[0].left, line.item)
            fresh = False

    @staticmethod
    def _with(waiting: Sequence[Line], links: tuple[Link, ...]) -> tuple[Link, ...]:
        """A chain that takes up lines written within it."""
        whole = list(links)
        for line in reversed(waiting):
            assert isinstance(line.relation, Relation)
            before = line.relation.options[0]
            if before[0].left == whole[0].left:
                first = Link(before[-1].right, whole[0].sign, whole[0].right, whole[0].by)
                whole = [*before, first, *whole[1:]]
            else:
                whole = [*before, *whole]
        return tuple(whole)

    def _chain(self, line: Line, links: tuple[Link, ...], last: bool = True) -> Row:
        """A chain as a row: with the name of what was asked, units, and a decimal at its end."""
        words = _WORDS.get(links[0].sign)
        if words is not None:
            left, right = map(self.naming.side, (links[0].left, links[0].right))
            return Row((operand(say(words, left=left, right=right)),), ())
        trees = [links[0].left, *(each.right for each in links)]
        if self.measures.decimals and self.measures.unit(links[0].left):
            trees[1:] = map(as_decimal, trees[1:])
        sides_ = [self._laid(line, each, n) for n, each in enumerate(trees)]
        for n, each in enumerate(links, 1):
            if each.sign == "≈":
                sides_[n] = to_three_figures(trees[n]) or sides_[n]
        signs = [_sign(each) for each in links]
        for n in range(len(sides_) - 1, 1, -1):
            if sides_[n] == sides_[n - 1] and signs[n - 1] == "=":
                del sides_[n], signs[n - 1]
        if self._towards(line, links, sides_):
            sides_[0] = self._away(links[0].left)
            sides_[1:] = [lay.split_sign(each)[1] for each in sides_[1:]]
        if signs[-1] in ("=", "≈") and last:
            self._ended(line, links, sides_, signs)
        return Row(tuple(sides_), tuple(signs))

    def _laid(self, line: Line, tree: Expression, index: int) -> lay.Layout:
        """An operand; a component that is resolved is called by its direction alone."""
        if not index and line.move.id == "define" and line.move.record == "component":
            match tree:
                case Quantity(
                    "along" | "across" as kind, (Quantity("velocity", (Name(body),)), axis)
                ):
                    event = self.naming.event_of_axis(axis)
                    if event is not None and event.wall:
                        name = "operand.towards" if kind == "along" else "operand.parallel"
                        return operand(say(name, wall=event.bodies[1]))
                    if event is not None:
                        name = "operand.along" if kind == "along" else "operand.across"
                        return operand(say(name, body=body))
        return self.naming.laid(tree)

    def _towards(self, line: Line, links: tuple[Link, ...], sides: list[lay.Layout]) -> bool:
        """Whether a row gives a rebound as a negative component towards a wall."""
        if line.number in self.ends:
            return False
        match links[0].left:
            case Quantity("along", (Quantity("velocity", _), axis)):
                event = self.naming.event_of_axis(axis)
                return (
                    event is not None
                    and event.wall
                    and all(lay.split_sign(each)[0] == "-" for each in sides[1:])
                )
        return False

    def _away(self, tree: Expression) -> lay.Layout:
        assert isinstance(tree, Quantity)
        vector, axis = tree.arguments
        event = self.naming.event_of_axis(axis)
        assert event is not None
        body = vector.arguments[0]  # type: ignore[union-attr]
        assert isinstance(body, Name)
        return operand(
            say("derived.component-away", of=lay.Bold("v", body.name), wall=event.bodies[1])
        )

    def _ended(
        self,
        line: Line,
        links: tuple[Link, ...],
        sides: list[lay.Layout],
        signs: list[str],
    ) -> None:
        """Puts what belongs to a value at the end of a row: its name, its unit, a decimal."""
        left, right = links[0].left, links[-1].right
        end = self.ends.get(line.number)
        unit = self.measures.unit(left) if _is_value(left) else ""
        asked = None if end is None else self.of_items.get(end.item)
        if end is not None and not end.shown:
            if isinstance(asked, Value) and asked.percentage:
                hundred = percentage(right)
                if hundred is not None:
                    sides.append(hundred)
                    signs.append("=")
                return
            place = _is_place(asked)
            for side, sign in as_answer(right, place) if links[-1].sign == "=" else ():
                if place and sign == "=" and len(sides) == len(links) + 1:
                    sides[-1] = side  # a place is told by its coordinates
                elif side != sides[-1]:
                    sides.append(side)
                    signs.append(sign)
        nothing = sides[-1] == lay.Number("0")
        if unit and (end is not None or (is_plain(sides[-1]) and not nothing)):
            sides[-1] = with_unit(sides[-1], unit)

    def _called(self, line: Line) -> Sentence | None:
        """What a letter stands for that was introduced a while ago, where it is what was asked."""
        end = self.ends.get(line.number)
        asked = None if end is None else self.of_items.get(end.item)
        if not isinstance(asked, Value) or not isinstance(asked.expression, Quantity):
            return None
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        if not isinstance(left, Letter) or left.name not in self.naming.meanings:
            return None
        meaning = self.naming.meanings[left.name]
        numbers = [each.number for each in self.derivation.lines]
        since = next(e.number for e in self.derivation.lines if e.relation == meaning)
        if numbers.index(line.number) - numbers.index(since) <= _REMEMBERED:
            return None
        return say("derived.called", quantity=self.naming.quantity(meaning.quantity))

    def _alternatives(self, options: tuple[tuple[Link, ...], ...], asked: bool) -> Row:
        """``t = 1 or t = −1``, set at the first sign."""
        first, *rest = options
        laid = self._bare(first, asked)
        others = [self._bare(each, asked) for each in rest]
        final = lay.Phrase((laid.operands[-1], *others), str(say("list.or")))
        return Row((*laid.operands[:-1], final), laid.signs, alternatives=True)

    def _bare(self, links: tuple[Link, ...], asked: bool) -> lay.Relation:
        trees = [links[0].left, *(each.right for each in links)]
        sides = [self.naming.laid(each) for each in trees]
        signs = [_sign(each) for each in links]
        for side, sign in as_answer(trees[-1]) if asked and signs[-1] == "=" else ():
            sides.append(side)
            signs.append(sign)
        if _is_value(trees[0]) and is_plain(sides[-1]) and signs[-1] in ("=", "≈"):
            sides[-1] = with_unit(sides[-1], self.measures.unit(trees[0]))
        return lay.Relation(tuple(sides), tuple(signs))

    def _reached(
        self, options: tuple[tuple[Link, ...], ...]
    ) -> tuple[tuple[Link, ...], lay.Layout] | None:
        """A value and where it is reached: ``x ≠ a or y = b`` says y = b when x = a."""
        if len(options) != 2:
            return None
        (where, *_), value = options
        if where.sign != "!=" or len(options[0]) != 1:
            return None
        place = Relation(((Link(where.left, "=", where.right),),))
        return value, self.relation(place)

    def _extreme(self, line: Line) -> Row:
        """The greatest or the least value, and where it is reached."""
        assert isinstance(line.relation, Relation)
        link = line.relation.only[-1]
        name = "derived.greatest" if line.move.record == "greatest" else "derived.least"
        called = operand(say(name, quantity=self.naming.laid(link.left)))
        sides, signs = [called, self.naming.laid(link.right)], ["="]
        self._ended(line, (Link(link.left, "=", link.right),), sides, signs)
        places = [
            reached[1]
            for ref in line.premises
            if isinstance(ref, int)
            and (behind := self.derivation.line(ref)) is not None
            and isinstance(behind.relation, Relation)
            and (reached := self._reached(behind.relation.options)) is not None
        ]
        reasons = tuple(say("derived.for", place=each) for each in places)
        return Row(tuple(sides), tuple(signs), reasons=reasons)


def _because(mark: Mark) -> Mark:
    """A mark with its reason: its own, or the one of its kind."""
    return mark if mark.because else reasoned(mark)


def _is_place(asked: object) -> bool:
    """Whether it is a place that was asked."""
    match asked:
        case Value(expression=Quantity("position", _, _)):
            return True
    return False


def _asked(step: Any) -> Iterator[Item | Show]:
    if isinstance(step, Find):
        yield from step.items
    elif isinstance(step, Show):
        yield step


def _is_value(tree: Expression) -> bool:
    """Whether a side names one quantity, whose dimension is known."""
    return isinstance(tree, Letter | Quantity)


def _sign(link: Link) -> str:
    return lay.SIGNS.get(link.sign, link.sign)


_BY = {
    "pythagoras": "derived.pythagoras",
    "double-angle": "derived.double-angle",
    "half-angle": "derived.half-angle",
    "sum-of-angles": "derived.sum-of-angles",
    "complement": "derived.complement",
}
_TITLES = {
    "unchanged": "unchanged.title",
    "momentum": "momentum.title",
    "restitution": "restitution.title",
    "restitution-wall": "restitution.title",
    "momentum-vector": "momentum.vectors",
    "impulse-vector": "impulse.title",
    "opposite-impulses": "derived-opposite.title",
    "across-the-impulse": "impulse-line.title",
    "along-the-change": "impulse-line.title",
    "wall-direction": "impulse-line.title",
    "energy": "derived-energy.title",
    "energy-ratio": "derived-energy.title",
    "energy-lost": "loss-spheres.title",
    "total": "derived-energy.title",
    "total-lost": "derived-energy.title",
    "tan": "derived-direction.title",
    "tan-squared": "derived-direction.title",
    "tan-direction": "derived-direction.title",
    "scalar-angle": "derived-between.title",
    "tan-deflection": "turned.title",
    "sum": "turned.title",
    "difference": "turned.title",
    "speed": "derived-speed.title",
    "assemble": "derived-assembled.title",
    "perpendicular": "derived-perpendicular.title",
    "parallel": "derived-parallel.title",
    "straight-line": "flight.title",
}


def _is_idle(line: Line) -> bool:
    """Whether a line says that a component stays 0, and earns nothing."""
    relation = line.relation
    return (
        isinstance(relation, Relation) and _is_nothing(relation.only[-1].right) and not line.marks
    )


def _is_nothing(tree: Expression) -> bool:
    """Whether a side is the number 0."""
    return isinstance(tree, Number) and not tree.value
