"""Marks by rule: what an examiner would give for each line of a derivation.

A rule looks at a line's move, record, event and item, and at what stands above it; it knows neither
how the working was found nor how it is printed. `RULES` is the table, tried from the top: the first
that fits a line says what it earns, in each style. Then, part by part:

- An item's last line has an A1, or a B1 where nothing of the part has been earned above it, or the
  line is read off the data; where nothing else of a part earns and it has several lines, its first
  one is M1. Where the statement prints the result it is an A1*, which never follows through, and
  has a method among its steps. What the data give outright earns nothing where something else does.
- Of three or more methods one below the other every second one is A1, if its line has a value; in
  place of a formula that is quoted, the value above it has the A1.
- One kind of point stands once on a line: M1 A1 and another A1 are M1 A1. Two roots that are both
  answers are A1 A1, where their equation is a method above; so are a greatest value and where it is
  reached.
- An M that rests on an earlier method of the same part is dependent: solving, a given fact in terms
  of what was found, and what goes on from that; no speed, angle, velocity, energy, time or place by
  its definition, nor a principle.
- An A whose line puts in a value that an earlier part or item found follows through.
- What an item's last line only says once more has its A1 there.
- Where an item has no answer, the conclusion has the mark of its end, and one of its own where no
  line has that.
- What rests on a coefficient that cannot be, in the same part, earns nothing.
- A principle that an earlier part has used at the same impact earns nothing again.
- Of several solutions, methods count once, and each further one adds its answers.
- A part has at most one mark more than it has lines; a link of a chain counts as a line, and a
  principle, which is M1 A1, as two.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby
from typing import Literal

from restitution.explaining.awarding.mark_conditions import (
    CONDITIONS,
    aligned,
    events_solved,
    is_given,
    is_opposite,
    letters_of_line,
    rests_on_facts,
    says_again,
    works_out,
)
from restitution.explaining.awarding.mark_rules import (
    CONCLUDING,
    PAIR,
    STAYS_ZERO,
    Rule,
    marks_of_note,
    rules_of,
)
from restitution.explaining.awarding.methods_added import with_methods
from restitution.explaining.awarding.work import (
    earning_under,
    grounds,
    has_bound_and_place,
    length,
    says_a_value_again,
    subject_of,
)
from restitution.explaining.data.unused import lines_under
from restitution.explaining.lines.derivation import (
    Derivation,
    Fact,
    ItemEnd,
    Line,
    Meaning,
    Note,
    Relation,
)
from restitution.explaining.lines.marks import Mark, Marks, Style, reasoned
from restitution.explaining.lines.trees import is_share_of_energy
from restitution.expression.tree import (
    Letter,
    has_quantity,
    letters,
)


def awarded(
    derivation: Derivation, style: Style = "fm1", justify: Collection[str] = ()
) -> Derivation:
    """The same derivation with marks by rule; without marks in the style ``none``.

    ``justify`` are the items of which reasons are asked: there, whatever rejects a root has a mark
    of its own. Marks that stood on the lines before are gone.
    """
    if style == "none":
        return replace(
            derivation,
            lines=tuple(replace(line, marks=()) for line in derivation.lines),
            notes=tuple(replace(note, marks=()) for note in derivation.notes),
        )
    awarding = _Awarding(derivation, style, frozenset(justify))
    proposed = awarding.proposed()
    notes = tuple(awarding.noted(proposed))
    return replace(
        derivation,
        lines=tuple(
            line if line.marks == own else replace(line, marks=own)
            for line in derivation.lines
            for own in (proposed[line.number],)
        ),
        notes=notes,
    )


def rule_of(derivation: Derivation, number: int, justify: Collection[str] = ()) -> Rule | None:
    """The rule that fits the line with a number; None where there is none."""
    line = derivation.line(number)
    if line is None:
        return None
    return _Awarding(derivation, "fm1", frozenset(justify)).rule(line)


def marks_of(derivation: Derivation) -> dict[str | None, int]:
    """How many marks stand in each part, by its label, in the order of the parts."""
    part = derivation.asked
    total: dict[str | None, int] = {}
    for line in derivation.lines:
        label = part.get(line.item or "")
        total[label] = total.get(label, 0) + sum(mark.number for mark in line.marks)
    for note in derivation.notes:
        total[note.part] = total.get(note.part, 0) + sum(mark.number for mark in note.marks)
    return total


class _Awarding:
    """One derivation on its way to its marks."""

    def __init__(self, derivation: Derivation, style: Style, justify: frozenset[str]) -> None:
        self.derivation = derivation
        self.style: Style = style
        self.justify = justify
        self.lines = {line.number: line for line in derivation.lines}
        self._cited = {
            line.number: tuple(derivation.lines_in(line.premises)) for line in derivation.lines
        }
        self.place = {line.number: n for n, line in enumerate(derivation.lines)}
        self.parts = derivation.asked
        self.ends: dict[int, ItemEnd | None] = {item.line: item for item in derivation.items}
        for note in derivation.notes:
            last = max(note.lines, default=0)
            if note.kind == "agreeing":
                continue
            if last and self.lines[last].item == note.item:
                self.ends.setdefault(last, None)
        # What only shows that a fact holds which no answer needs earns nothing.
        checks = [e for note in derivation.notes if note.kind == "agreeing" for e in note.lines]
        spare, needed = (
            {ref for line in lines for ref in lines_under(derivation, line)}
            for lines in (checks, [item.line for item in derivation.items])
        )
        self.checks = spare - needed
        # A line of an earlier part that a later one has to show was found there.
        self.shown = {
            item.line
            for item in derivation.items
            if item.shown and self.parts.get(self.lines[item.line].item or "") == item.part
        }
        self.order = {item: n for n, item in enumerate(self.parts)}
        self.walls = {event.number: event.wall for event in derivation.events}
        self.further = {
            number
            for case in derivation.cases
            for number in case.lines
            if case.option != min(e.option for e in derivation.cases if e.line == case.line)
        }
        self.new = frozenset(derivation.meanings)
        # What is asked of a line again and again, for itself and for those that rest on it.
        self.solved: dict[int, frozenset[int | None]] = {}
        self._rules: dict[int, Rule | None] = {}

    # --- the whole ------------------------------------------------------------------------------

    def proposed(self) -> dict[int, Marks]:
        """The marks of every line, by its number."""
        points: dict[int, list[str]] = {number: [] for number in self.lines}
        for line in self.derivation.lines:
            if line.shown == "silent" or line.number in self.further or self._is_idle(line):
                continue
            if line.number in self.checks:
                continue
            rule = self.rule(line)
            for point in () if rule is None else rule.earned(self.style).split():
                if point == "V":
                    points[self._value_of(line)].append("A")
                elif point == "U":
                    for number in self._unknown_of(line):
                        points[number].append("A")
                else:
                    points[line.number].append(point)
        earned: set[str | None] = set()
        for line in self.derivation.lines:
            if line.number in self.ends and line.shown == "silent":
                self._award_above(line, points)
            elif line.number in self.ends and not self._is_idle(line):
                end = self.ends[line.number]
                # What is printed has to be reached by something.
                lone = end is not None and end.shown and not self._has_a_method(line, points)
                # A principle, or a component, and its value are one mark.
                one = line.move.id in ("law", "define")
                own = [e for e in points[line.number] if e != "B" or not one]
                again = line.move.record == "unchanged" or says_a_value_again(self, line)
                points[line.number] = (
                    ["B"] if again and not lone else own + (["M", "A"] if lone else ["A"])
                )
                if self._answers_twice(line):
                    own = [e for e in points[line.number] if e == "M"]
                    points[line.number] = [*own, "A", "A"]
                elif is_given(self, line) and (earned or own == ["B"]):
                    points[line.number] = [] if earned else ["B"]
                whole = self._first_form(line)
                if says_again(self, whole):
                    for solution in self._solutions(whole):
                        # The value is asked: it stands there already, under another name.
                        points[solution.number] = [e for e in points[solution.number] if e != "A"]
                if line.move.record == "component":
                    for other in self.cited(line):
                        # One fact, from which the component is read off, is one mark.
                        if self._is_only_for(other, line):
                            points[other.number] = []
            if points[line.number]:
                earned.add(self.part(line))
        with_methods(self, points)
        return self._settled(points)

    def _has_a_method(self, line: Line, points: Mapping[int, Sequence[str]]) -> bool:
        """Whether a line of its part on which a line rests has earned something."""
        own = grounds(self, line, lambda other: self.part(other) == self.part(line))
        return any(points[premise.number] for premise in own)

    def _is_only_for(self, law: Line, line: Line) -> bool:
        """Whether a law stands on the way to one line alone."""
        users = [own for own in self.below(law) if law.number in own.premises]
        return law.move.id == "law" and law.number not in self.ends and users == [line]

    def noted(self, marks: dict[int, Marks]) -> Iterator[Note]:
        """The notes with their marks; those of lines are taken from there.

        That an item has no answer is concluded once: the value above it has no answer's mark then.
        """
        concluded = set[object]()
        for note in self.derivation.notes:
            if note.kind not in CONCLUDING:
                yield replace(note, marks=marks_of_note(note))
                continue
            conclusion = note.kind, note.reason, note.premises
            last = max(note.lines, default=0)
            of_the_end: Marks = ()
            if marks.get(last) and self._ends_in(note):
                (*own, final) = marks[last]
                marks[last], of_the_end = tuple(own), (final,)
            earned = () if conclusion in concluded else marks_of_note(note, of_the_end)
            concluded.add(conclusion)
            yield replace(note, marks=earned)

    def _ends_in(self, note: Note) -> bool:
        """Whether the last line of a note has a mark only as the item ends there.

        A velocity by which two bodies do not approach is a value for itself.
        """
        last = self.lines.get(max(note.lines, default=0))
        if last is None or note.claim is not None or last.item != note.item:
            return False
        if self.ends.get(last.number) is not None:
            return False
        rule = self.rule(last)
        return rule is None or not {"A", "B", "V"} & set(rule.earned(self.style).split())

    def _award_above(self, end: Line, points: dict[int, list[str]]) -> None:
        """The mark of an item that a fact gives goes to the line that had it in letters."""
        sides = end.relation.sides
        for line in reversed(self.derivation.lines[: self.place[end.number]]):
            if line.shown == "silent" or not isinstance(line.relation, Relation) or sides is None:
                continue
            own = line.relation.sides
            if own is not None and own[0] == sides[0]:
                points[line.number].append("A")
                return

    def _is_idle(self, line: Line) -> bool:
        """Whether it rests on a coefficient that cannot be, to which its part has come."""
        last = len(self.order)
        return any(
            note.kind == "impossible"
            and note.premises
            and note.part == self.part(line)
            and self.order.get(note.item, last) < self.order.get(line.item or "", 0)
            and self._rests_on_any(line, note.lines)
            for note in self.derivation.notes
        )

    def _rests_on_any(self, line: Line, numbers: Collection[int]) -> bool:
        """Whether one of some lines is under a line."""
        seen, open_ = set[int](), [line]
        while open_:
            own = open_.pop()
            if own.number in numbers:
                return True
            if own.number not in seen:
                seen.add(own.number)
                open_ += self.cited(own)
        return False

    def rule(self, line: Line) -> Rule | None:
        """The first rule of the table that fits a line."""
        if line.number not in self._rules:
            self._rules[line.number] = next(self._fitting(line), None)
        return self._rules[line.number]

    def _fitting(self, line: Line) -> Iterator[Rule]:
        """The rules that fit a line."""
        for rule in rules_of(line.move.id, line.move.record):
            for name in rule.when:
                if not CONDITIONS[name](self, line):
                    break
            else:
                yield rule

    def _settled(self, points: Mapping[int, Sequence[str]]) -> dict[int, Marks]:
        """Points as marks that agree with each other, part by part."""
        kept = self._cut(
            {
                number: tuple(point) if self._answers_twice(self.lines[number]) else _once(point)
                for number, point in points.items()
            }
        )
        kept = self._with_accuracy(kept)
        methods: dict[str | None, list[int]] = {}
        out: dict[int, Marks] = {}
        for line in self.derivation.lines:
            marks: list[Mark] = []
            part = self.part(line)
            before = methods.setdefault(part, [])
            for point in kept[line.number]:
                if point == "M":
                    on = self._rests_on(line, before)
                    marks.append(Mark("M", dependent=bool(on), on=on))
                elif point == "A":
                    star = line.number in self.shown
                    # What needs no method is independent.
                    own = not before or self._is_read_off(line, out)
                    own = own or self._is_put_together_alone(line, before)
                    kind: Literal["A", "B"] = "B" if own and not (star or marks) else "A"
                    marks.append(Mark(kind, star=star, ft=not star and self._follows(line, out)))
                else:
                    marks.append(Mark("B"))
            if "M" in kept[line.number]:
                before.append(line.number)
            out[line.number] = tuple(reasoned(mark) for mark in marks)
        return out

    def _is_put_together_alone(self, line: Line, methods: Sequence[int]) -> bool:
        """Whether a velocity is put together of components for which there was no method.

        Those of other items, as of a time, are none for it, unless they are laws.
        """
        if line.move.record != "assemble":
            return False
        if any(line.number in case.lines for case in self.derivation.cases):
            return False
        above = [self.lines[number] for number in methods]
        if any(own.move.id == "law" or own.item == line.item for own in above):
            return False
        return not self._rests_on(line, methods)

    def _answers_twice(self, line: Line) -> bool:
        """Whether a line has two answers.

        They are both roots of an equation that is a method above it, or a greatest or least value
        and where it is reached.
        """
        if line.move.record in ("greatest", "least"):
            end = self.ends.get(line.number)
            return end is not None and not end.shown and has_bound_and_place(self, line)
        moves = ("roots", "rearrange")
        if line.number not in self.ends or line.move.id not in moves or is_opposite(self, line):
            return False
        assert isinstance(line.relation, Relation)
        methods = (
            premise
            for premise in grounds(self, line, lambda other: other.item == line.item)
            if (rule := self.rule(premise)) is not None
            and premise.move.id == "define"
            and "M" in rule.earned(self.style)
        )
        return any(methods) and len(line.relation.options) == 2

    def _is_read_off(self, line: Line, marks: Mapping[int, Marks]) -> bool:
        """Whether an item's last line rests on the statement alone: nothing above it has earned.

        That a component stays zero is seen.
        """
        if line.number not in self.ends:
            return False

        def is_law(premise: Line) -> bool:
            rule = self.rule(premise)
            return premise.move.id == "law" and (rule is None or rule.name != STAYS_ZERO)

        return not any(
            is_law(premise) or marks.get(premise.number)
            for premise in grounds(self, line, lambda _: True)
        )

    def _cut(self, points: dict[int, tuple[str, ...]]) -> dict[int, tuple[str, ...]]:
        """The same, with at most one point more in a part than it has lines.

        M1 A1 for an equation and A1 for its solution are three marks for two lines.
        The first to go are those of accuracy on the way, from the bottom, where what was done above
        is done again; an item keeps its last.
        """
        for part in dict.fromkeys(self.parts.values()):
            own = [line for line in self.derivation.lines if self.part(line) == part]
            over = sum(len(points[line.number]) for line in own) - self._room(part) - 1
            for kind in "AB":
                for line in reversed(own):
                    if over > 0 and line.number not in self.ends and kind in points[line.number]:
                        points[line.number] = tuple(e for e in points[line.number] if e != kind)
                        over -= 1
        return points

    def _with_accuracy(self, points: dict[int, tuple[str, ...]]) -> dict[int, tuple[str, ...]]:
        """The same, with marks for accuracy between three or more methods in a row."""
        marked = [line for line in self.derivation.lines if points[line.number]]
        for (_, alone), run in groupby(
            marked, lambda line: (self.part(line), points[line.number] == ("M",))
        ):
            lines = list(run)
            if not alone or len(lines) < _LONG_RUN:
                continue
            method: Line | None = None
            after = marked[marked.index(lines[-1]) + 1 :]
            has_its_own = bool(after) and points[after[0].number][0] == "A"
            for line in lines:
                if method is not None and line is lines[-1] and has_its_own:
                    break
                if method is not None and line.move.id == "identity":
                    # A formula that is quoted comes after the value that goes into it.
                    closes = any(fact.kind == "given" for fact in self.facts(line))
                    points[method.number] = ("M", "A")
                    points[line.number] = ("M",) if closes else ()
                    method = None
                elif method is not None and self._is_of_values(line):
                    points[line.number], method = ("A",), None
                else:
                    method = line
        # Of two bounds that are joined the second is the same method once more.
        for line in (own for own in marked if own.move.id == "compare"):
            first, *others = earning_under(self, line, points) or (line.number,)
            for other in others:
                alike = self.lines[first].move.id == self.lines[other].move.id
                if alike and "A" in points[first] and points[other] == ("M",):
                    points[other] = ("A",)
        return points

    def _is_of_values(self, line: Line) -> bool:
        """Whether a line says what something is, or its bounds, in letters of the statement.

        That is not one in which the value comes from the statement.
        """
        if isinstance(line.relation, Meaning) or any(e.kind == "given" for e in self.facts(line)):
            return False
        ends = [links[-1].right for links in line.relation.options]
        return not any(letters(end) & self.new or has_quantity(end) for end in ends)

    def _room(self, part: str | None) -> int:
        """How many lines a part has."""
        own = [line for line in self.derivation.lines if self.part(line) == part]
        return sum(map(length, own)) + sum(line.move.record in PAIR for line in own)

    def _first_form(self, line: Line) -> Line:
        """The line that a line only simplifies, in the same item; else that line itself."""
        (*_, above) = [own for own in self.cited(line) if own.item == line.item] or [line]
        alike = subject_of(above) is not None and subject_of(above) == subject_of(line)
        return above if alike and line.move.id == "rearrange" else line

    def _solutions(self, line: Line) -> Iterator[Line]:
        """The lines among the premises of one, in its item, that solve principles together."""
        for other in self.cited(line):
            if (
                other.item == line.item
                and other.number not in self.ends
                and events_solved(self, other)
            ):
                yield other

    # --- what a line rests on -------------------------------------------------------------------

    def part(self, line: Line) -> str | None:
        """The label of the part to which a line belongs."""
        return self.parts.get(line.item or "")

    def above(self, line: Line) -> Sequence[Line]:
        """The lines above a line."""
        return self.derivation.lines[: self.place[line.number]]

    def below(self, line: Line) -> Sequence[Line]:
        """The lines below a line."""
        return self.derivation.lines[self.place[line.number] + 1 :]

    def cited(self, line: Line) -> Sequence[Line]:
        """The lines among the premises of a line."""
        return self._cited[line.number]

    def facts(self, line: Line) -> Iterator[Fact]:
        """The facts among the premises of a line."""
        for ref in line.premises:
            fact = self.derivation.fact(ref)
            if fact is not None:
                yield fact

    def _value_of(self, line: Line) -> int:
        """The line that simplifies a line, or is it itself."""
        last = line
        for other in self.below(line):
            if other.item != line.item or other.move.id not in ("rearrange", "put", "value"):
                break
            if other.shown == "silent":
                break
            if [e.number for e in self.cited(other)] != [last.number]:
                break
            if subject_of(other) != subject_of(last) or aligned(other) != aligned(last):
                break
            if subject_of(other) is None and aligned(other) is None:
                break
            last = other
        return last.number

    def _unknown_of(self, line: Line) -> Iterator[int]:
        """The line on the way that solves an equation for a letter of the working, if there is one.

        Between them that equation is only rearranged.
        """
        last = line
        for other in self.below(line):
            if other.item != line.item or other.move.id not in ("rearrange", "cancel", "roots"):
                return
            if other.shown == "silent" or last not in list(self.cited(other)):
                return
            if other.number not in self.ends and self._is_settled(other):
                yield other.number
                return
            last = other

    def _is_settled(self, line: Line) -> bool:
        """Whether a line says what a letter of the working is, by what the statement has."""
        subject = subject_of(line)
        return isinstance(subject, Letter) and subject.name in self.new and self._is_value(line)

    def _rests_on(self, line: Line, methods: Sequence[int]) -> tuple[int, ...]:
        """The methods of the part without which a line has nothing to put in.

        A principle is a method by itself, whatever is put into it. So is a definition that works
        out what is wanted, unless components of a velocity that was found are taken anew.
        """
        if line.move.id == "law" or not methods:
            return ()
        unknown = self.new & letters_of_line(line)
        numbers = []
        seen: set[int] = set()
        open_ = [other.number for other in self.cited(line)]
        while open_:
            number = open_.pop()
            if number in seen:
                continue
            seen.add(number)
            if number in methods:
                numbers.append(number)
            elif isinstance(self.lines[number].relation, Meaning):
                # An unknown of the impact has been found, if a method above speaks of it.
                numbers += [n for n in methods if unknown & letters_of_line(self.lines[n])]
            else:
                open_ += [line.number for line in self.cited(self.lines[number])]
        if works_out(self, line) and not any(map(self._resolves_what_was_found, numbers)):
            return ()
        return tuple(sorted(set(numbers)))

    def _resolves_what_was_found(self, number: int) -> bool:
        """Whether a line takes components of a velocity that no datum tells."""
        line = self.lines[number]
        return line.move.record == "component" and not rests_on_facts(self, line)

    def _follows(self, line: Line, marks: Mapping[int, Marks]) -> bool:
        """Whether a value is put in that an earlier part or item has found, and earned by."""
        seen: set[int] = set()
        open_ = [line.number]
        while open_:
            number = open_.pop()
            for other in self.cited(self.lines[number]):
                if other.number in seen or self._is_solved_by(other, self.lines[number]):
                    continue
                seen.add(other.number)
                if other.item == line.item:
                    open_.append(other.number)
                elif (
                    self._is_value(other)
                    and self._earlier(other, line)
                    and not self._is_of_data(other)
                    and self._has_earned(other, marks)
                ):
                    return True
        return False

    def _is_of_data(self, line: Line) -> bool:
        """Whether a line is a component of the data, or one that stays what it is by these."""
        return line.move.record in ("unchanged", "component") and all(
            isinstance(other.relation, Meaning) or self._is_of_data(other)
            for other in self.cited(line)
        )

    def _has_earned(self, line: Line, marks: Mapping[int, Marks]) -> bool:
        """Whether a line, or one on which it rests, has a mark that may be lost."""
        seen: set[int] = set()
        open_ = [line]
        while open_:
            own = open_.pop()
            if marks.get(own.number):
                return True
            if own.number not in seen:
                seen.add(own.number)
                open_ += self.cited(own)
        return False

    def _is_solved_by(self, line: Line, other: Line) -> bool:
        """Whether a line is the one of two values of which the other one is, in the same part."""
        return self.part(line) == self.part(other) and bool(
            events_solved(self, other) & events_solved(self, line)
        )

    def _earlier(self, line: Line, than: Line) -> bool:
        last = len(self.order)
        return self.order.get(line.item or "", last) < self.order.get(than.item or "", last)

    def _is_value(self, line: Line) -> bool:
        """Whether a line says what a quantity or a letter is, in the letters of the statement."""
        link = line.relation.sides
        return (
            link is not None
            and (subject_of(line) is not None or is_share_of_energy(line))
            and not (letters(link[1]) & self.new)
            and not has_quantity(link[1])
        )


_LONG_RUN = 3
"""So many methods in a row no board gives without a mark for accuracy."""


def _once(points: Sequence[str]) -> tuple[str, ...]:
    """M, A, B in this order, each once; a value that a method gives needs no B beside it."""
    return tuple(kind for kind in "BMA" if kind in points)
