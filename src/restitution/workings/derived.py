"""A derivation as a worked solution: what it says in sentences and rows, for every renderer.

Premises are not printed but where a reader looks for them: which equations were combined, why a
root is rejected, on what an inequality rests. An equation has a number only where it is named.

Each room has its topic: `ends` what was asked, `introductions` what letters stand for, `leads` the
words before a line, `staying` the components that an impact does not change, `rows` the line
itself, `reasons` what stands behind it, `noted` why an item has no answer. Here they come
together, from the top of a part to its end.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import field, replace
from typing import TYPE_CHECKING, Any, NamedTuple

from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.data.unused import is_of_open_data, spare_facts
from restitution.explaining.lines.derivation import (
    Case,
    Derivation,
    Event,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Move,
    Note,
    Relation,
)
from restitution.explaining.lines.marks import Mark, Marks, reasoned
from restitution.explaining.lines.opposite_roots import root_but_for_sign
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import Expression, Quantity, walk
from restitution.problem import Problem, Show, Value
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.workings.conditions import is_same
from restitution.workings.leads.axes import has_axes, senses_of_axes, with_axes
from restitution.workings.leads.carried import Carried
from restitution.workings.leads.given_leads import GivenLeads
from restitution.workings.leads.introductions import Introductions
from restitution.workings.leads.meetings import meetings
from restitution.workings.leads.radii import Radii
from restitution.workings.leads.same_angles import SameAngles
from restitution.workings.leads.senses import direction_by_its_sense
from restitution.workings.leads.sides import Sides
from restitution.workings.leads.staying import Staying
from restitution.workings.leads.titles import TITLED
from restitution.workings.leads.touching import Touching
from restitution.workings.leads.unit_vectors import UnitVectors
from restitution.workings.lines_together import (
    before_their_line,
    first_under_its_heading,
    impact_of_a_value,
    is_of_centres,
    is_worked_out_below,
    resolved_with,
)
from restitution.workings.naming.bold_letters import Used
from restitution.workings.naming.data_angles import DataAngles
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import Measures, is_plain, with_unit
from restitution.workings.naming.multiples import measured_meanings
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.senses_of_walls import in_senses_of_walls
from restitution.workings.naming.sources import Sources
from restitution.workings.naming.sums_in_degrees import FIGURES_OF_ANSWERS, degrees_of, is_inverse
from restitution.workings.noted import Notes, cases_of
from restitution.workings.reasons.possible_roots import cases_together
from restitution.workings.reasons.premises import Reasons
from restitution.workings.reasons.pythagoras import is_arithmetic
from restitution.workings.rendering.explanation import Explanation
from restitution.workings.rendering.joining import joined
from restitution.workings.rendering.once import (
    in_turn,
    labelled_once,
    of_a_percentage,
    reasoned_once,
    spoken,
    without_its_condition,
)
from restitution.workings.rendering.steps import REQUIRED, PartExplanation, Row, Step
from restitution.workings.rows import Rows

if TYPE_CHECKING:
    from restitution.solving.equations.solution import Solution

_LONG_ANGLE = 40  # nodes of an angle that nobody would write exactly
# Definitions that speak of the whole motion: they begin no working of an impact.
_OF_THE_WHOLE = frozenset(
    {"energy", "total", "total-lost", "energy-ratio", "energy-lost", "assemble", "speed"}
)


def explanation_of(
    derivation: Derivation,
    problem: Problem,
    solution: Solution | None = None,
    conditions: Mapping[int, Sentence] | None = None,
) -> Explanation:
    """The working as a value of which all formats are made, and pictures with the ``solution``."""
    written = steps_of(derivation, problem, conditions)
    parts: list[PartExplanation] = []
    for label, steps in written.steps.items():
        ends = [item for item in derivation.items if item.part == label]
        asked = tuple(written.ends.text(e) for e, part in derivation.asked.items() if part == label)
        answers = tuple(to_text(written.naming.relation(end.answer)) for end in ends)
        parts.append(PartExplanation(label, asked, steps, answers, derivation))
    letters = written.naming.letters
    return Explanation(problem.title, tuple(parts), problem.warnings, solution, letters=letters)


class Written(NamedTuple):
    """The steps of each part, by its label, with the names and the items of the working."""

    steps: Mapping[str | None, tuple[Step, ...]]
    naming: Naming
    ends: Ends


def steps_of(
    derivation: Derivation, problem: Problem, conditions: Mapping[int, Sentence] | None = None
) -> Written:
    """The working in steps; ``conditions`` are said below the lines with these numbers."""
    labels = list(dict.fromkeys(derivation.asked.values()))
    in_senses = in_senses_of_walls(derivation, problem)
    derivation, turned = in_senses.printed, in_senses.events
    writer = _Writer(derivation, problem, conditions or {}, turned=turned)
    steps = {label: writer.part(label) for label in labels}
    wanted = writer.naming.bold.wanted
    if wanted != writer.naming.bold.used or writer.rows.finer:
        # Which velocities have letters is known now, so that they can be introduced together,
        # and which values need more than four figures from where they stand first.
        writer = _Writer(
            *(derivation, problem, conditions or {}, wanted),
            shared=writer,
            turned=turned,
            finer=writer.rows.finer,
        )
        steps = {label: writer.part(label) for label in labels}
    return Written(steps, writer.naming, writer.ends)


@dataclass
class _Writer:
    """One derivation on its way to paper."""

    derivation: Derivation
    problem: Problem
    conditions: Mapping[int, Sentence] = field(default_factory=dict)
    used: Used | None = None
    heading: int | None = None
    title: Sentence | None = None
    before: tuple[Sentence, ...] = ()
    shared: _Writer | None = None
    turned: frozenset[int] = frozenset()
    finer: Mapping[str, int] = field(default_factory=dict)

    def __post_init__(self) -> None:
        derivation, shared = self.derivation, self.shared
        self.naming: Naming = Naming(
            derivation,
            self.problem,
            used=self.used,
            shared=shared.naming if shared else None,
            foresees=self.used is None,
            turned=self.turned,
        )
        # What no letter changes is the same for both.
        self.measures: Measures = (
            shared.measures if shared else Measures(self.problem, measured_meanings(derivation))
        )
        self.sources: Sources = shared.sources if shared else Sources(derivation)
        self.reasons: Reasons = Reasons(
            derivation,
            self.naming,
            self.problem,
            self.sources,
            shared.reasons if shared else None,
        )
        self.ends = Ends(derivation, self.problem, self.naming)
        self.introductions = Introductions(derivation, self.naming)
        # These are introduced where the offset is.
        for letter in filter(None, map(letter_of_offset, derivation.lines)):
            self.naming.introduced_early.add(letter)
            self.naming.knows(derivation.meanings[letter].quantity, letter)
        self.leads = GivenLeads(derivation, self.naming, self.sources, self.reasons)
        self.meetings = dict(meetings(derivation, self.ends, self.naming))
        self.angles = DataAngles(derivation, self.naming)
        self.rows = Rows(derivation, self.naming, self.measures, self.ends, self.finer)
        self.notes = Notes(derivation, self.naming, self.ends, self.rows.in_figures)
        self.radii = Radii(derivation, self.naming)
        self.sides = Sides(derivation, self.naming)
        self.same_angles = SameAngles(derivation, self.naming)
        self.units = UnitVectors(derivation, self.naming)
        self.staying = Staying(
            derivation, self.naming, self.measures, self.sources, self.ends, self.rows.instead_of
        )
        unprinted = self.staying.is_nothing
        self.touching = Touching(derivation, self.naming, unprinted)
        in_figures = self.rows.in_figures
        self.carried = Carried(
            *(derivation, self.naming, self.measures, self.sources, self.ends),
            *(in_figures, unprinted),
        )
        self.cases = {n: case for case in derivation.cases for n in case.lines}
        self.case: int | None = None
        #: The title below each heading of a case, by the line at which the cases part.
        self.titles_of_cases: dict[int, Sentence] = {}
        self.begins: Case | None = None
        self.group: int | None = None
        self.entered: set[int] = set()
        self.stay: list[Line] = []
        self.said_again: set[str] = set()
        # The conditions of answers that are printed; an earlier part has said the same for all.
        self.limited: list[Sentence] = []
        self.axes = senses_of_axes(self.problem)

    def part(self, label: str | None) -> tuple[Step, ...]:
        """The steps of a part."""
        lines = [line for line in self.derivation.lines if self.ends.part(line) == label]
        lines = list(self.angles.in_order(lines))
        self.naming.bold.part = label
        self.before = ()
        self.heading = self.naming.heading_in_part = None
        steps = tuple(labelled_once(reasoned_once(joined(self.steps(lines, label)))))
        if self.axes and has_axes(steps):
            steps, self.axes = tuple(with_axes(steps, self.axes)), ()
        return steps

    def afresh(self) -> None:
        """What comes next goes on from nothing above it."""
        self.title = None
        self.rows.afresh()

    def steps(self, lines: list[Line], label: str | None) -> Iterator[Step]:
        """The lines of a part as steps, with its notes among them."""
        self.afresh()
        lets: list[Meaning] = []
        waiting: list[Line] = []
        shown = [line for line in lines if line.shown != "silent"]
        notes = self.notes.places(label, [line.item for line in shown])
        again = self.ends.again(label, shown)
        self.said_again = {end.item for ends in again.values() for end in ends}
        due: list[Note] = []
        once_more: list[ItemEnd] = []
        roots: Step | None = None
        for index, line in enumerate(shown):
            due += notes.get(index, ())
            once_more += again.get(index, ())
            if (due or once_more) and not (waiting or lets or self.stay):
                yield from self._again_asked(once_more)
                yield from self._noted(due)
                due, once_more = [], []
            if isinstance(line.relation, Meaning):
                lets.append(line.relation)
                continue
            if not waiting and self._is_silent(shown, index):
                continue
            yield from self._entered(self._heads(shown, index))
            yield from self._ratios(line)
            yield from self._vectors_of_event(line, bool(lets))
            if not waiting and self.carried.gather(resolved_with(shown[index:])):
                self.rows.afresh()
            if lets and not before_their_line(lets, shown[index:]):
                yield from self._letters(lets)
                lets = []
            if line.shown == "inline" or (
                is_worked_out_below(shown, index)
                and direction_by_its_sense(self.derivation, self.naming, shown[index + 1]) is None
            ):
                waiting.append(line)
                continue
            after = shown[index + 1] if index + 1 < len(shown) else None
            if self.staying.stays(line) and not waiting:
                self.stay.append(line)
                if after is not None and self._stays_with(shown, index):
                    continue
                together, self.stay = self.stay, []
                given = tuple(e for own in together for e in self.leads.given_before(own))
                step = self._unchanged(together)
            else:
                yield from self._places_before(line)
                laws = [own for own in waiting if own.move.id == "law"]
                given = tuple(e for own in (*laws, line) for e in self.leads.given_before(own))
                step = self._step(line, waiting)
                waiting = []
            introduced = self.naming.introduced()
            both, step = step, self._with_roots(roots, step, bool(introduced or given))
            if roots is not None and step is both:
                yield roots
            if introduced:
                step = self._whole(step, line)
                yield Step("setting", sentences=introduced)
            if given:
                yield Step("note", sentences=given, item=step.item)
            roots = None
            if after is not None and self._is_kept_alone(line, after):
                roots = step
                continue
            yield without_its_condition(step, self.conditions.get(line.number))
            yield from self._claimed(line, step)
            yield from self._conditioned(line, step)
        yield from self._again_asked([*once_more, *again.get(len(shown), ())])
        yield from self._noted([*due, *notes.get(len(shown), ())])
        summary = cases_together(self.derivation, self.naming, self.measures, label)
        if summary is not None:
            yield Step("note", sentences=(summary,))
        yield from self._spare(label)

    def _heads(self, lines: Sequence[Line], index: int) -> Line:
        """The line whose impact a line stands under; one that is not printed heads no others."""
        line = lines[index]
        own = first_under_its_heading(lines, index, self.naming.meanings)
        return line if own is not line and self._is_silent(lines, lines.index(own)) else own

    def _ratios(self, line: Line) -> Iterator[Step]:
        """The ratios of angles that a line needs."""
        ratios = tuple(self.angles.before(line))
        if ratios:
            self.afresh()
            yield Step("fact", sentences=ratios)

    def _vectors_of_event(self, line: Line, has_lets: bool) -> Iterator[Step]:
        """The bold letters of the event under whose heading a line stands."""
        here = self.heading in (None, line.move.event)
        if here and line.move.event in self.naming.events and not self.stay:
            self.naming.bold.gather(line.move.event or 0)
            if not has_lets:
                yield from self._introduced()

    def _letters(self, lets: Sequence[Meaning]) -> Iterator[Step]:
        """What letters stand for; of what they are letters may have to be introduced itself."""
        introductions = tuple(self.introductions.of(lets))
        sentences = (*self.naming.introduced(), *introductions)
        if sentences:
            yield Step("setting", sentences=sentences)
            self.rows.afresh()

    def _places_before(self, line: Line) -> Iterator[Step]:
        """Who meets whom, on which side, and who touches what, before a line that uses it."""
        if line.number in self.meetings:
            self.afresh()
            meeting = (self.meetings[line.number],)
            yield Step("note", sentences=meeting, item=self.ends.place(line))
        touching = (
            *self.radii.before(line),
            *self.sides.before(line),
            *self.same_angles.before(line),
            *self.units.before(line),
        )
        if touching:
            self.afresh()
            yield Step("setting", sentences=touching)
        places = tuple(self.touching.before(line))
        if places:
            self.afresh()
            yield Step("note", sentences=places, item=self.ends.place(line))

    def _claimed(self, line: Line, step: Step) -> Iterator[Step]:
        """The claims that a line ends."""
        for claim in self.ends.claims(line):
            yield from self._introduced()
            sentences = (say("shown.claim", claim=claim),)
            label = self.ends.label_of_claims(line)
            yield Step("note", sentences=sentences, item=step.item, label=label)

    def _conditioned(self, line: Line, step: Step) -> Iterator[Step]:
        """The condition of an answer, where it was not told above."""
        condition = self.conditions.get(line.number)
        if condition is not None and not any(is_same(condition, e) for e in self.limited):
            self.limited.append(condition)
            yield Step("note", sentences=(condition,), item=step.item)

    def _is_kept_alone(self, line: Line, after: Line) -> bool:
        """Whether a line has two opposite roots, and the next one only keeps one of them."""
        return (
            line.move.id == "roots"
            and after.move.id == "reject"
            and line.number in after.premises
            # Of two places both are written.
            and not any(str(ref).partition(" ")[0] == "towards" for ref in after.premises)
            and line.number not in self.sources.numbers
            and isinstance(line.relation, Relation)
            and root_but_for_sign(line.relation.options) is not None
            and not line.marks
            and self.ends.of(line) is None
            and line.number not in self.conditions
            and self.cases.get(line.number) == self.cases.get(after.number)
        )

    @staticmethod
    def _with_roots(roots: Step | None, step: Step, apart: bool) -> Step:
        """The step of the root that is kept, in the place of the one of both."""
        if roots is None or apart or step.title is not None or step.sentences:
            return step
        return replace(roots, rows=(*roots.rows[:-1], *step.rows), item=step.item)

    def _again_asked(self, ends: Sequence[ItemEnd]) -> Iterator[Step]:
        """The answers of items that an item above has too, said once more."""
        for end in ends:
            line = self.derivation.line(end.line)
            if line is not None and len(end.answer.options) == 1:
                self.afresh()
                label = self.ends.label_of(end.item)
                row = replace(self._again(line), answer=True, label=label)
                item = self.ends.place_of(end.item)
                yield Step("result", (row,), sentences=(say("carried.above"),), item=item)

    def _spare(self, label: str | None) -> Iterator[Step]:
        """What is given beside what the working needs: it agrees, as there is a solution.

        What is given of a letter of which no line says the value has nothing with which to agree.
        """
        labels = list(dict.fromkeys(self.derivation.asked.values()))
        for fact in spare_facts(self.derivation):
            home = fact.part if fact.part in labels else labels[-1]
            if home == label:
                words = fact_in_words(self.naming, fact)
                yield from self._introduced()
                open_ = is_of_open_data(fact, self.derivation)
                sentence = say("given.not-needed" if open_ else "given.agrees", fact=words)
                yield Step("note", sentences=(sentence,))

    def _is_silent(self, lines: Sequence[Line], index: int) -> bool:
        """Whether a line says nothing that is printed, so that no heading stands above it.

        Of bodies on one line nothing is said of the components that stay.
        """
        line = lines[index]
        if self.staying.is_nothing(line) or self._is_named_by_its_unit(line):
            return True
        if not self.staying.stays(line):
            return False
        first = last = index
        while first and self._stays_with(lines, first - 1):
            first -= 1
        while last + 1 < len(lines) and self._stays_with(lines, last):
            last += 1
        return all(map(self.staying.is_idle, lines[first : last + 1]))

    def _is_named_by_its_unit(self, line: Line) -> bool:
        """Whether a line gives the radius of a circular wall that gets a unit vector below it."""
        match line.relation:
            case Relation(((Link(Quantity("line_of_centres", (), int(number)), "parallel to"),),)):
                return (
                    self.naming.bold.is_radius_with_a_unit(number)
                    and not line.marks
                    and line.number not in self.sources.numbers
                    and self.ends.of(line) is None
                )
        return False

    def _stays_with(self, lines: Sequence[Line], index: int) -> bool:
        """Whether a line and the next one tell of components that stay in one impact."""
        one, two = lines[index], lines[index + 1]
        stay = self.staying.stays(one) and self.staying.stays(two)
        return stay and self.staying.together(one, two)

    def _noted(self, notes: Sequence[Note]) -> Iterator[Step]:
        """Why items have no answer, or why a claim is not true."""
        for (note, *others), sentence in self.notes.sentences(notes):
            self.afresh()
            points = tuple(_because(mark) for mark in note.marks)
            item = self.ends.place_of(note.item)
            items = dict.fromkeys((note.item, *(e.item for e in others), *self.notes.alike(note)))
            label = self.ends.label_of(*items)
            if note.kind in ("unwritten", "standing") and note.claim is not None:
                line = Line(0, note.item, Move("answer"), (), _in_degrees(note.claim))
                *rows, last = self.rows.of(line, (), True)
                shown = isinstance(self.ends.item(note.item), Show)
                asides = (*last.asides, *REQUIRED) if shown else last.asides
                last = replace(last, points=points, asides=asides, answer=not shown, label=label)
                step = Step("result", (*rows, last), sentences=(sentence,), item=item)
            elif cases := cases_of(note):
                cells = [Row((lay.Words(case),), ()) for case in cases]
                rows = [replace(cells[0], points=points, label=label), *cells[1:]]
                step = Step("result", tuple(rows), sentences=(sentence,), item=item)
            else:
                step = Step("note", sentences=(sentence,), points=points, item=item, label=label)
            # What the note names is introduced before it.
            yield from self._introduced()
            yield step
            onward = tuple(self.notes.onward(note))
            if onward:
                yield Step("note", sentences=onward, item=item)

    def _introduced(self) -> Iterator[Step]:
        """What letters stand for that have come into use."""
        introduced = self.naming.introduced()
        if introduced:
            yield Step("setting", sentences=introduced)

    def _again(self, line: Line) -> Row:
        """What a line says of its left side, as a row."""
        assert isinstance(line.relation, Relation)
        left = line.relation.only[0].left
        value = self.naming.layout(line.relation.only[-1].right)
        if is_plain(value) and value != lay.Number("0"):
            value = with_unit(value, self.measures.unit(left))
        return Row((self.naming.layout(left), value), ("=",))

    def _whole(self, step: Step, line: Line) -> Step:
        """A step whose first row goes on from the row above, with its left side after all."""
        if not step.rows or step.rows[0].operands[0] is not None:
            return step
        assert isinstance(line.relation, Relation)
        first, *rest = step.rows
        left = self.naming.layout(line.relation.options[0][0].left)
        first = replace(first, operands=(left, *first.operands[1:]))
        return replace(step, rows=(first, *rest))

    def _entered(self, line: Line) -> Iterator[Step]:
        """What stands before the lines of an event, or of a case."""
        case = self.cases.get(line.number)
        number = None if case is None else case.number
        if number != self.case:
            self.case = number
            self.begins = case
            self.afresh()
            behind = None if case is None else self.derivation.line(case.line)
            if case is not None and behind is not None:
                assert isinstance(behind.relation, Relation)
                links = tuple(map(self.rows.in_figures, behind.relation.options[case.option]))
                values = (self.naming.relation(Relation((links,))),)
                yield Step("heading", sentences=(say("heading.case", values=values),))
        yield from self._heading(line)

    def _heading(self, line: Line) -> Iterator[Step]:
        """A heading where the next of several events begins."""
        number = line.move.event if line.move.id != "fact" else _impact_of_a_line(line)
        if number is None and self.heading is not None:
            number = impact_of_a_value(line, self.naming.meanings)
        event = self.naming.events.get(number or 0)
        if event is None or number == self.heading or len(self.naming.impacts_with(event)) < 2:
            return
        if line.move.record in _OF_THE_WHOLE and not self._is_of_its_impact(line, event):
            return
        again = line.move.id in ("define", "put", "rearrange") and not _is_before(line)
        # Below another impact's heading in a late part, values of the next one need their own.
        late = line.move.id == "put" and 0 < (self.naming.heading_in_part or 0) < event.number
        if number in self.entered and not late and (again or line.move.record == "impulse"):
            return
        if event.kind != "arrival":
            self.heading = self.naming.now = self.naming.heading_in_part = event.number
            self.entered.add(event.number)
            self.afresh()
            yield Step("heading", sentences=(self.naming.heading(event),), event=number)

    def _is_of_its_impact(self, line: Line, event: Event) -> bool:
        """Whether a speed is the one that an impact leaves as it was, or a place that of one."""
        match line.relation:
            case Relation(((Link(Quantity("position", _, int(stage))), *_),)):
                return stage == event.number
        return self.leads.kept_speed(line, event) is not None

    def _is_a_percentage(self, line: Line) -> bool:
        """Whether what a line ends with is asked as a percentage."""
        asked = self.ends.asked(line)
        return isinstance(asked, Value) and asked.percentage

    def _unchanged(self, lines: Sequence[Line]) -> Step:
        """The components that stay as a sentence."""
        title, sentence = self.staying.sentences(lines)
        again = title == self.title
        if again:
            sentence = say("derived.sentence", sentence=sentence)
        self.afresh()
        self.title = title
        points: Marks = tuple(_because(mark) for line in lines for mark in line.marks)
        own = None if again else title
        sentences, source = self.carried.beside(own, () if own else (sentence,))
        if own is not None and source is not None and source.id == "carried.with":
            whole = dict(source.slots)["sources"]
            sentence = say("carried.with-sentence", sources=whole, sentence=sentence)
            source = None
        item = self.ends.place(lines[0])
        return Step("principle", (), own, sentences or (sentence,), points, item, source=source)

    def _step(self, line: Line, waiting: Sequence[Line] = ()) -> Step:
        kind: Any = "principle" if line.move.id in TITLED else "solve"
        # What goes on in the same chain has no words of its own.
        heads = (e for e in waiting if e.move.id in ("define", "law") or is_of_centres(e))
        head = next(heads, line)
        given = self.leads.given(head)
        title = None if given else self.leads.title(head)
        titles = [
            spoken(sentence) for sentence in (*self.before, self.title) if sentence is not None
        ]
        named = title is not None and (title == self.title or spoken(title) in titles)
        if self.begins is not None and title is not None and not named:
            # A second case goes as the first one does; of laws each is named, or none.
            named = self.titles_of_cases.get(self.begins.line) == title and head.move.id != "law"
            self.titles_of_cases.setdefault(self.begins.line, title)
        self.begins = None
        sentences = given or in_turn(
            tuple(self.leads.anyway(head)), tuple(self.leads.of(head, self.title))
        )
        if not given and len(sentences) == 1 and spoken(sentences[0]) in titles:
            sentences, title, named = (), self.title, True
        fresh = bool(sentences) or (title is not None and not named)
        rows = list(self.rows.of(line, waiting, fresh))
        arithmetic = is_arithmetic(self.naming, line, rows)
        if arithmetic:
            sentences = tuple(sentence for sentence in sentences if sentence.id != "derived.by")
        resolved = self.leads.resolved(line) if self.leads.resolves(line) else None
        if title is not None or sentences or resolved is not None:
            self.title = title or resolved
        again = bool(sentences) and sentences == self.before and not given
        self.before = sentences
        title = None if named else title
        if self._is_a_percentage(line):
            sentences = tuple(map(of_a_percentage, sentences))
            title = None if title is None else of_a_percentage(title)
        sentences, source = self.carried.beside(title, () if again else sentences, _subject(line))
        reasons = () if arithmetic else self.reasons.of(line)
        numbers = self.sources.numbers
        behind = next((numbers[e.number] for e in (line, *waiting) if e.number in numbers), None)
        points = tuple(
            _because(mark) for line_waiting in (*waiting, line) for mark in line_waiting.marks
        )
        # Below the tangent of an angle its degrees have a row of their own.
        own = -2 if self.ends.of(line) is None and _is_of_degrees(rows) else -1
        rows[own] = replace(
            rows[own],
            points=points,
            reasons=(*rows[own].reasons, *self.leads.behind(line), *reasons),
            asides=(*rows[own].asides, *self.rows.asides(line, line.number in self.conditions)),
            number="" if behind is None else str(behind),
            label=self.ends.label(line, self.said_again),
        )
        rows = self.rows.with_decimals(rows, line)
        end = self.ends.of(line)
        if end is not None and not end.shown:
            rows[-1] = replace(rows[-1], answer=True)
        item = self.ends.place(line)
        if resolved is not None:
            # Components under one heading belong together, whatever items need them.
            item = self.group if not sentences else item
            self.group = item
        return Step(kind, tuple(rows), title, sentences, item=item, source=source)


def _in_degrees(claim: Relation) -> Relation:
    """An answer whose steps are not written out, in degrees where its ratio is long."""
    match claim.options:
        case ((Link(left, "=", right),),) if is_inverse(right) and len(walk(right)) > _LONG_ANGLE:
            degrees = degrees_of(right, FIGURES_OF_ANSWERS)
            return claim if degrees is None else Relation(((Link(left, "≈", degrees),),))
    return claim


def _is_of_degrees(rows: Sequence[Row]) -> bool:
    """Whether the last of several rows only gives the degrees of the angle above it."""
    if len(rows) < 2:
        return False
    last = rows[-1]
    return last.signs == ("≈",) and isinstance(last.operands[-1], lay.Degrees)


def _subject(line: Line) -> Expression | None:
    """The quantity or letter whose value a line says."""
    relation = line.relation
    return relation.options[0][0].left if isinstance(relation, Relation) else None


def _because(mark: Mark) -> Mark:
    """A mark with its reason: its own, or the one of its kind."""
    return mark if mark.because else reasoned(mark)


def _impact_of_a_line(line: Line) -> int | None:
    """The impact whose line of centres a datum tells; None of another datum."""
    numbers = (ref.partition(" ") for ref in line.premises if isinstance(ref, str))
    return next((int(number) for kind, _, number in numbers if kind == "axis"), None)


def _is_before(line: Line) -> bool:
    """Whether a line resolves a velocity for the impact that comes next."""
    if line.move.record != "component" or not isinstance(line.relation, Relation):
        return False
    match line.relation.options[0][0].left:
        case Quantity(_, (Quantity("velocity", _, int(stage)), _)):
            return stage == (line.move.event or 0) - 1
    return False
