"""Marks by rule: what an examiner would give for each line of a derivation.

A rule looks at a line's move, record, event and item, and at what stands above it; it knows neither
how the working was found nor how it is printed. `RULES` is the table, tried from the top: the first
that fits a line says what it earns, in each style. Then, part by part:

- An item's last line has an A1, or a B1 where nothing of the part has been earned above it, or the
  line is read off the data; where the statement prints the result an A1*, which never follows
  through. What the data give outright earns nothing where something else does.
- One kind of point stands once on a line: M1 A1 and another A1 are M1 A1. Two roots that are both
  answers are A1 A1, where their equation is a method above.
- An M that rests on an earlier method of the same part is dependent.
- An A whose line puts in a value that an earlier part or item found follows through.
- What an item's last line only says once more has its A1 there.
- What comes after a coefficient that cannot be, in the same part, earns nothing.
- A principle that an earlier part has used at the same impact earns nothing again.
- Of several solutions, methods count once, and each further one adds its answers.
- A part has at most one mark more than it has lines; a link of a chain counts as a line, and a
  principle, which is M1 A1, as two.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Literal

from restitution.explaining.derivation import (
    Derivation,
    Fact,
    ItemEnd,
    Line,
    Link,
    Meaning,
    MoveId,
    NoteKind,
    Relation,
    whole_of,
)
from restitution.explaining.marks import Mark, Marks, Style, reasoned
from restitution.explaining.resting import is_of_a_body_at_rest
from restitution.explaining.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    Unit,
    has_quantity,
    letters,
    walk,
)
from restitution.expression.writing import write_expression


@dataclass(frozen=True)
class Rule:
    """What a kind of line earns.

    ``moves`` and ``records`` are those of the line (none: any), ``when`` names the conditions of
    `CONDITIONS` that hold there. ``points`` are M, A and B, and V for an A that belongs to the
    value: it stands on the line that simplifies this one, if there is such a line. ``others`` are
    the points in styles that differ.
    """

    name: str
    moves: frozenset[MoveId]
    records: frozenset[str] = frozenset()
    when: tuple[str, ...] = ()
    points: str = ""
    others: Mapping[Style, str] = field(default_factory=dict)

    def earned(self, style: Style) -> str:
        """The points in a style."""
        return self.others.get(style, self.points)


def _rule(
    name: str,
    moves: tuple[MoveId, ...],
    points: str,
    records: tuple[str, ...] = (),
    when: tuple[str, ...] = (),
    m4: str | None = None,
    caie: str | None = None,
) -> Rule:
    styles: tuple[tuple[Style, str | None], ...] = (("m4", m4), ("caie", caie))
    others = {style: own for style, own in styles if own is not None}
    return Rule(name, frozenset(moves), frozenset(records), when, points, others)


_PAIR = ("momentum", "restitution")
_VECTORS = (
    "momentum-vector",
    "impulse-vector",
    "across-the-impulse",
    "along-the-change",
    "equal-across",
)
_CLOSING = (
    "tan",
    "tan-squared",
    "tan-direction",
    "tan-deflection",
    "perpendicular",
    "parallel",
    "sum",
)
_ENERGIES = (
    "energy",
    "energy-ratio",
    "energy-lost",
    "energy-change",
    "total",
    "total-lost",
    "difference",
)

RULES: tuple[Rule, ...] = (
    # Principles. What an earlier part has used at the same impact is no method again.
    _rule("repeated", ("law",), "", when=("repeated",)),
    _rule("component-that-stays-zero", ("law",), "", ("unchanged",), ("zero",)),
    _rule("coefficient-sought", ("law",), "M A", ("restitution-wall",), ("sought",)),
    _rule(
        "component-at-a-wall", ("law",), "B", ("unchanged", "restitution-wall"), ("wall",), m4="M A"
    ),
    _rule("first-component-unchanged", ("law",), "B", ("unchanged",), ("first-at-event",)),
    _rule("component-unchanged", ("law",), "", ("unchanged",)),
    _rule("one-of-two-alone", ("law",), "M A", _PAIR, ("alone",)),
    _rule("first-of-two", ("law",), "M A", _PAIR, ("first-of-several",), caie="M"),
    _rule("second-of-two", ("law",), "M A", _PAIR, ("second-of-several",)),
    _rule("impulse", ("law",), "M V", ("impulse",)),
    _rule("principle-of-vectors", ("law",), "M V", _VECTORS),
    # Solving.
    _rule("solved-together", ("combine",), "M A", when=("of-laws", "first"), caie=""),
    _rule("put-together-with-a-law", ("put",), "M", when=("of-laws", "first"), caie=""),
    _rule("two-values-of-a-letter", ("put",), "M", when=("of-one-letter",)),
    _rule("another-value", ("combine",), "A", when=("of-laws", "another")),
    _rule("solved-again", ("combine",), "", when=("of-laws",)),
    _rule("unknowns-of-equations", ("solve",), "M A"),
    _rule("equations-joined", ("combine", "divide", "square-add"), "M"),
    _rule("identity", ("identity",), "M", when=("on-the-way",)),
    _rule("square-root", ("roots",), "", when=("opposite",)),
    _rule("roots", ("roots",), "M"),
    _rule("reason-for-a-root", ("reject",), "B", when=("justified",)),
    # Vectors and their components.
    _rule("component-with-a-letter", ("define",), "", ("component",), ("by-its-letter",)),
    _rule("component-of-nothing", ("define",), "", ("component",), ("zero",)),
    _rule("component-alone", ("define",), "B", ("component",), ("alone",)),
    _rule("component-read-off", ("define",), "B", ("component",), ("read-off", "first-of-several")),
    _rule("further-component-read-off", ("define",), "", ("component",), ("read-off",)),
    _rule("first-scalar-product", ("define",), "M", ("component",), ("first-of-several",)),
    _rule("second-scalar-product", ("define",), "A", ("component",), ("second-of-several",)),
    _rule("given-speed", ("define",), "M", ("speed", "size"), ("of-one-term", "an-equation")),
    _rule("read-off", ("define",), "", ("assemble", "speed", "size"), ("of-one-term",)),
    _rule("put-together", ("define",), "M", ("assemble", "speed", "size"), ("on-the-way",)),
    _rule("velocity-in-components", ("define",), "", ("assemble",)),
    # Facts closed into equations, and what is asked.
    _rule("angle-of-the-data", ("define",), "", ("scalar-angle",), ("of-facts", "of-a-number")),
    _rule(
        "speed-size-angle-distance",
        ("define",),
        "M V",
        ("speed", "size", "scalar-angle", "distance", "product", "momentum-of"),
    ),
    _rule(
        "condition-on-one-component", ("define",), "B", ("perpendicular", "parallel"), ("of-facts",)
    ),
    _rule("right-angle-by-a-product", ("define",), "", ("perpendicular",), ("product-above",)),
    _rule("condition", ("define",), "M", _CLOSING, m4="M A"),
    _rule(
        "difference-of-angles",
        ("define",),
        "",
        ("difference",),
        ("of-angles", "in-letters", "on-the-way"),
    ),
    _rule("angle-read-off", ("define",), "", ("difference",), ("of-angles", "at-once")),
    _rule("angle-by-a-difference", ("define",), "M", ("difference",), ("of-angles",)),
    _rule("time-of-no-way", ("define",), "", ("straight-line",), ("zero", "time")),
    _rule("place-at-rest", ("define",), "", ("straight-line",), ("at-rest", "on-the-way")),
    _rule("place-in-an-open-time", ("define",), "", ("straight-line",), ("open-place",)),
    _rule("place-by-a-path", ("define",), "M", ("straight-line",), ("place-of-facts",)),
    _rule("place-on-an-axis", ("define",), "", ("straight-line",), ("zero", "on-the-way")),
    _rule(
        "time-by-the-data", ("define",), "B", ("straight-line",), ("of-facts", "time", "on-the-way")
    ),
    _rule("place-by-the-data", ("define",), "", ("straight-line",), ("of-facts", "a-place")),
    _rule("energy-lost-by-the-data", ("define",), "M A", ("energy-lost",), ("of-facts",)),
    _rule("data", ("define",), "", _ENERGIES, ("of-facts", "on-the-way")),
    _rule("time-or-place", ("define",), "M", ("straight-line",)),
    _rule("centres-by-a-path", ("law",), "M", ("moves-off",)),
    _rule("centres-two-radii-apart", ("define",), "A", ("beside",)),
    _rule("chord-again", ("define",), "", ("chord",), ("another-chord",)),
    _rule("chord", ("define",), "M", ("chord",)),
    _rule("angles-round-a-circle", ("define",), "M", ("round",)),
    _rule("energy", ("define",), "M A", _ENERGIES, ("alone",)),
    _rule("first-of-several-energies", ("define",), "M", _ENERGIES, ("first-of-several",)),
    _rule("second-of-several-energies", ("define",), "A", _ENERGIES, ("second-of-several",)),
    # Inequalities, ranges and greatest values.
    _rule(
        "condition-as-inequality",
        ("sign", "put", "fact", "compare"),
        "M",
        when=("new-inequality", "on-the-way"),
    ),
    _rule("bounds", ("monotone", "complete"), "M"),
    _rule("comparison", ("sign", "compare"), "M", when=("claim-without-method",)),
    _rule("given-fact", ("put", "fact"), "M", when=("fact-of-motion",)),
    _rule("centres-beside-a-path", ("fact",), "M A", when=("of-an-offset",)),
    _rule("place-of-a-contact", ("fact",), "M A", when=("of-a-contact", "of-facts")),
    _rule("equation-of-a-contact", ("fact",), "M", when=("of-a-contact",)),
)
"""The table. A line that no rule fits earns nothing by itself."""

# A method that is not written out, and its answer.
_FOR_NOTES: Mapping[NoteKind, Marks] = {
    "unwritten": (reasoned(Mark("M")), reasoned(Mark("A"))),
    "standing": (reasoned(Mark("B")),),
}


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
            lines=tuple(replace(each, marks=()) for each in derivation.lines),
            notes=tuple(replace(note, marks=()) for note in derivation.notes),
        )
    proposed = _Awarding(derivation, style, frozenset(justify)).proposed()
    return replace(
        derivation,
        lines=tuple(replace(each, marks=proposed[each.number]) for each in derivation.lines),
        notes=tuple(
            replace(note, marks=_FOR_NOTES.get(note.kind, ())) for note in derivation.notes
        ),
    )


def rule_of(derivation: Derivation, number: int, justify: Collection[str] = ()) -> Rule | None:
    """The rule that fits the line with a number; None where there is none."""
    line = derivation.line(number)
    if line is None:
        return None
    return _Awarding(derivation, "fm1", frozenset(justify)).rule(line)


def marks_of(derivation: Derivation) -> dict[str | None, int]:
    """How many marks stand in each part, by its label, in the order of the parts."""
    part = part_of_items(derivation)
    total: dict[str | None, int] = {}
    for line in derivation.lines:
        label = part.get(line.item or "")
        total[label] = total.get(label, 0) + sum(mark.number for mark in line.marks)
    for note in derivation.notes:
        total[note.part] = total.get(note.part, 0) + sum(mark.number for mark in note.marks)
    return total


def part_of_items(derivation: Derivation) -> Mapping[str, str | None]:
    """The label of the part to which each item belongs."""
    return derivation.asked


class _Awarding:
    """One derivation on its way to its marks."""

    def __init__(self, derivation: Derivation, style: Style, justify: frozenset[str]) -> None:
        self.derivation = derivation
        self.style: Style = style
        self.justify = justify
        self.lines = {each.number: each for each in derivation.lines}
        self.place = {each.number: n for n, each in enumerate(derivation.lines)}
        self.parts = part_of_items(derivation)
        self.ends: dict[int, ItemEnd | None] = {each.line: each for each in derivation.items}
        for note in derivation.notes:
            last = max(note.lines, default=0)
            if last and self.lines[last].item == note.item:
                self.ends.setdefault(last, None)
        self.shown = {each.line for each in derivation.items if each.shown}
        self.order = {item: n for n, item in enumerate(self.parts)}
        self.walls = {event.number: event.wall for event in derivation.events}
        self.further = {
            number
            for case in derivation.cases
            for number in case.lines
            if case.option != min(e.option for e in derivation.cases if e.line == case.line)
        }
        self.new = frozenset(derivation.meanings)

    # --- the whole ------------------------------------------------------------------------------

    def proposed(self) -> dict[int, Marks]:
        """The marks of every line, by its number."""
        points: dict[int, list[str]] = {number: [] for number in self.lines}
        for line in self.derivation.lines:
            if line.shown == "silent" or line.number in self.further or self._is_idle(line):
                continue
            rule = self.rule(line)
            for point in () if rule is None else rule.earned(self.style).split():
                if point == "V":
                    points[self._value_of(line)].append("A")
                else:
                    points[line.number].append(point)
        earned: set[str | None] = set()
        for line in self.derivation.lines:
            if line.number in self.ends and not self._is_idle(line):
                end = self.ends[line.number]
                # What is printed has to be reached by something.
                lone = end is not None and end.shown and end.part not in earned
                # A principle, or a component, and its value are one mark.
                one = line.move.id in ("law", "define")
                own = [e for e in points[line.number] if e != "B" or not one]
                points[line.number] = own + (["M", "A"] if lone else ["A"])
                if self._answers_twice(line):
                    points[line.number] = ["A", "A"]
                elif earned and _is_given(self, line):
                    points[line.number] = []
                if _says_again(self, line):
                    for each in self._solutions(line):
                        # The value is asked: it stands there already, under another name.
                        points[each.number] = [e for e in points[each.number] if e != "A"]
            if points[line.number]:
                earned.add(self.part(line))
        return self._settled(points)

    def _is_idle(self, line: Line) -> bool:
        """Whether its part has come to a coefficient that cannot be, and asks for more."""
        last = len(self.order)
        return any(
            note.kind == "impossible"
            and note.premises
            and note.part == self.part(line)
            and self.order.get(note.item, last) < self.order.get(line.item or "", 0)
            for note in self.derivation.notes
        )

    def rule(self, line: Line) -> Rule | None:
        """The first rule of the table that fits a line."""
        return next((each for each in RULES if self._fits(each, line)), None)

    def _fits(self, rule: Rule, line: Line) -> bool:
        move = line.move
        return (
            move.id in rule.moves
            and (not rule.records or move.record in rule.records)
            and all(CONDITIONS[name](self, line) for name in rule.when)
        )

    def _settled(self, points: Mapping[int, Sequence[str]]) -> dict[int, Marks]:
        """Points as marks that agree with each other, part by part."""
        kept = self._cut(
            {
                number: ("A", "A") if self._answers_twice(self.lines[number]) else _once(each)
                for number, each in points.items()
            }
        )
        methods: dict[str | None, list[int]] = {}
        earned: dict[str | None, bool] = {}
        out: dict[int, Marks] = {}
        for line in self.derivation.lines:
            marks: list[Mark] = []
            part = self.part(line)
            before = methods.setdefault(part, [])
            earned.setdefault(part, False)
            for point in kept[line.number]:
                if point == "M":
                    on = self._rests_on(line, before)
                    marks.append(Mark("M", dependent=bool(on), on=on))
                elif point == "A":
                    star = line.number in self.shown
                    # What needs no method is independent.
                    own = not earned[part] or self._is_read_off(line, out)
                    kind: Literal["A", "B"] = "B" if own and not (star or marks) else "A"
                    marks.append(Mark(kind, star=star, ft=not star and self._follows(line, out)))
                else:
                    marks.append(Mark("B"))
            earned[part] = earned[part] or bool(marks)
            if "M" in kept[line.number]:
                before.append(line.number)
            out[line.number] = tuple(reasoned(mark) for mark in marks)
        return out

    def _answers_twice(self, line: Line) -> bool:
        """Whether a line has both roots as answers, of an equation that is a method above it."""
        if line.number not in self.ends or line.move.id != "roots" or _opposite(self, line):
            return False
        assert isinstance(line.relation, Relation)
        seen, open_ = set[int](), list(self.cited(line))
        while open_:
            each = open_.pop()
            if each.number in seen or each.item != line.item:
                continue
            seen.add(each.number)
            rule = self.rule(each)
            if rule is not None and each.move.id == "define" and "M" in rule.earned(self.style):
                return len(line.relation.options) == 2
            open_ += self.cited(each)
        return False

    def _is_read_off(self, line: Line, marks: Mapping[int, Marks]) -> bool:
        """Whether an item's last line rests on the statement alone: nothing above it has earned."""
        if line.number not in self.ends:
            return False
        seen, open_ = set[int](), list(self.cited(line))
        while open_:
            each = open_.pop()
            if each.move.id == "law" or marks.get(each.number):
                return False
            if each.number not in seen:
                seen.add(each.number)
                open_ += self.cited(each)
        return True

    def _cut(self, points: dict[int, tuple[str, ...]]) -> dict[int, tuple[str, ...]]:
        """The same, with at most one point more in a part than it has lines.

        M1 A1 for an equation and A1 for its solution are three marks for two lines.
        The first to go are those of accuracy on the way, from the bottom, where what was done above
        is done again; an item keeps its last.
        """
        for part in dict.fromkeys(self.parts.values()):
            own = [each for each in self.derivation.lines if self.part(each) == part]
            over = sum(len(points[each.number]) for each in own) - self._room(part) - 1
            for kind in "AB":
                for line in reversed(own):
                    if over > 0 and line.number not in self.ends and kind in points[line.number]:
                        points[line.number] = tuple(e for e in points[line.number] if e != kind)
                        over -= 1
        return points

    def _room(self, part: str | None) -> int:
        """How many lines a part has."""
        own = [each for each in self.derivation.lines if self.part(each) == part]
        return sum(map(_length, own)) + sum(each.move.record in _PAIR for each in own)

    def _solutions(self, line: Line) -> Iterator[Line]:
        """The lines among the premises of one, in its item, that solve principles together."""
        for each in self.cited(line):
            if each.item == line.item and each.number not in self.ends and _solves(self, each):
                yield each

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

    def cited(self, line: Line) -> Iterator[Line]:
        """The lines among the premises of a line."""
        for ref in line.premises:
            if isinstance(ref, int) and ref in self.lines:
                yield self.lines[ref]

    def facts(self, line: Line) -> Iterator[Fact]:
        """The facts among the premises of a line."""
        for ref in line.premises:
            fact = self.derivation.fact(ref) if isinstance(ref, str) else None
            if fact is not None:
                yield fact

    def _value_of(self, line: Line) -> int:
        """The line that simplifies a line, or is it itself."""
        last = line
        for each in self.below(line):
            if each.item != line.item or each.move.id not in ("rearrange", "put", "value"):
                break
            if each.shown == "silent":
                break
            if [e.number for e in self.cited(each)] != [last.number]:
                break
            if _subject(each) != _subject(last) or _aligned(each) != _aligned(last):
                break
            if _subject(each) is None and _aligned(each) is None:
                break
            last = each
        return last.number

    def _rests_on(self, line: Line, methods: Sequence[int]) -> tuple[int, ...]:
        """The methods of the part without which a line has nothing to put in.

        A principle is a method by itself, whatever is put into it.
        """
        if line.move.id == "law" or not methods:
            return ()
        unknown = self.new & _letters(line)
        numbers = []
        seen: set[int] = set()
        open_ = [each.number for each in self.cited(line)]
        while open_:
            number = open_.pop()
            if number in seen:
                continue
            seen.add(number)
            if number in methods:
                numbers.append(number)
            elif isinstance(self.lines[number].relation, Meaning):
                # An unknown of the impact has been found, if a method above speaks of it.
                numbers += [n for n in methods if unknown & _letters(self.lines[n])]
            else:
                open_ += [each.number for each in self.cited(self.lines[number])]
        return tuple(sorted(set(numbers)))

    def _follows(self, line: Line, marks: Mapping[int, Marks]) -> bool:
        """Whether a value is put in that an earlier part or item has found, and earned by."""
        seen: set[int] = set()
        open_ = [line.number]
        while open_:
            number = open_.pop()
            for each in self.cited(self.lines[number]):
                if each.number in seen or self._is_solved_by(each, self.lines[number]):
                    continue
                seen.add(each.number)
                if each.item == line.item:
                    open_.append(each.number)
                elif (
                    self._is_value(each)
                    and self._earlier(each, line)
                    and not self._is_of_data(each)
                    and self._has_earned(each, marks)
                ):
                    return True
        return False

    def _is_of_data(self, line: Line) -> bool:
        """Whether a line is a component of the data, or one that stays what it is by these."""
        return line.move.record in ("unchanged", "component") and all(
            isinstance(each.relation, Meaning) or self._is_of_data(each)
            for each in self.cited(line)
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
            _solves(self, other) & _solves(self, line)
        )

    def _earlier(self, line: Line, than: Line) -> bool:
        last = len(self.order)
        return self.order.get(line.item or "", last) < self.order.get(than.item or "", last)

    def _is_value(self, line: Line) -> bool:
        """Whether a line says what a quantity or a letter is, in the letters of the statement."""
        link = None if isinstance(line.relation, Meaning) else _single(line.relation)
        return (
            link is not None
            and _subject(line) is not None
            and not (letters(link[1]) & self.new)
            and not has_quantity(link[1])
        )


def _once(points: Sequence[str]) -> tuple[str, ...]:
    """M, A, B in this order, each once; a value that a method gives needs no B beside it."""
    return tuple(kind for kind in "BMA" if kind in points)


def _length(line: Line) -> int:
    """How many lines of a page a line takes: one for each link of its chains."""
    if line.shown == "silent":
        return 0
    return 1 if isinstance(line.relation, Meaning) else max(map(len, line.relation.options))


def _single(relation: Relation) -> tuple[Expression, Expression] | None:
    """The sides of an equation, a chain by its ends; None for any other relation."""
    if len(relation.options) != 1:
        return None
    link = whole_of(relation.options[0])
    return None if link is None or link.sign not in ("=", "≈") else (link.left, link.right)


def _subject(line: Line) -> Expression | None:
    """The letter or quantity that a line is about: its left side."""
    sides = None if isinstance(line.relation, Meaning) else _single(line.relation)
    if sides is None or not isinstance(sides[0], Letter | Quantity):
        return None
    return sides[0]


def _aligned(line: Line) -> tuple[Expression, str] | None:
    """What a line says the direction of, and how; None for any other relation."""
    if isinstance(line.relation, Meaning) or len(line.relation.options) != 1:
        return None
    link = line.relation.only[0]
    return (link.left, link.sign) if link.sign.endswith(" to") else None


def _letters(line: Line) -> frozenset[str]:
    return frozenset(name for tree in trees_of(line.relation) for name in letters(tree))


def _says_again(work: _Awarding, line: Line) -> bool:
    """Whether a line only puts together what stands already: a component, a velocity, a speed."""
    if line.move.id != "define":
        return False
    if line.move.record == "component":
        return _by_its_letter(work, line)
    return line.move.record in ("assemble", "speed", "size")


def _unequal(line: Line) -> bool:
    """Whether a line is an inequality."""
    return isinstance(line.relation, Relation) and any(
        link.sign in ("<", "<=", ">", ">=") for links in line.relation.options for link in links
    )


# --- conditions -----------------------------------------------------------------------------------


def _is_law(line: Line, records: Collection[str], event: int | None) -> bool:
    return line.move.id == "law" and line.move.record in records and line.move.event == event


def _repeated(work: _Awarding, line: Line) -> bool:
    """An earlier part has the same principle for the same bodies at the same event."""
    move, part = line.move, work.part(line)
    return any(
        _is_law(each, (move.record or "",), move.event)
        and set(each.move.bodies) == set(move.bodies)
        and work.part(each) != part
        for each in work.above(line)
    )


def _first_at_event(work: _Awarding, line: Line) -> bool:
    return not any(
        _is_law(e, ("unchanged",), line.move.event) and not _zero(work, e) for e in work.above(line)
    )


def _zero(work: _Awarding, line: Line) -> bool:
    """A component of a body that has none: nothing is to be worked out."""
    sides = None if isinstance(line.relation, Meaning) else _single(line.relation)
    return sides is not None and sides[1] == Number(Fraction(0))


def _another_chord(work: _Awarding, line: Line) -> bool:
    """A component on a chord, below another one in the part: the angles are equal once more."""
    match _subject(line):
        case Quantity("along" | "across"):
            pass
        case _:
            return False
    return any(each.move.record == "chord" for each in work.above(line))


def _place_of_facts(work: _Awarding, line: Line) -> bool:
    """A coordinate by the way in the other direction, from the data alone."""
    match _subject(line):
        case Quantity("along", (Quantity("position"), _)):
            return _of_facts(work, line) and any("contact" in str(e) for e in line.premises)
    return False


_GROUPS: Mapping[str, str] = {
    **dict.fromkeys(_PAIR, "direction"),
    **dict.fromkeys(_ENERGIES, "energy"),
    "component": "component",
}


def _alike(work: _Awarding, line: Line) -> list[Line]:
    """The lines that make one step together, in order.

    They are the two principles along the centres of an event, the components in its directions at
    one time, the energies of an item.
    """
    move, group = line.move, _GROUPS[line.move.record or ""]

    def same(each: Line) -> bool:
        if each.move.id != move.id or _GROUPS.get(each.move.record or "") != group:
            return False
        if group == "energy":
            own = not _of_facts(work, each) and not _of_angles(work, each)
            return own and each.item == line.item
        if work.part(each) != work.part(line) or each.move.event != move.event:
            return False
        if group == "direction":
            return True
        plain = not _zero(work, each) and not _by_its_letter(work, each)
        return plain and _is_late(each) == _is_late(line)

    return [each for each in work.derivation.lines if same(each)]


def _is_late(line: Line) -> bool:
    """Whether a component is that of a velocity after the event of its line."""
    subject = _subject(line)
    vector = subject.arguments[0] if isinstance(subject, Quantity) and subject.arguments else None
    return isinstance(vector, Quantity) and vector.stage == line.move.event


def _read_off(work: _Awarding, line: Line) -> bool:
    """None of the components that stand together is a sum of products."""
    return not any(
        _is_sum(node)
        for each in _alike(work, line)
        if isinstance(each.relation, Relation)
        for node in walk(each.relation.only[0].right)
    )


def _origins(work: _Awarding, line: Line) -> frozenset[int | None]:
    """The events of the principles along the centres that a line says in other words."""
    if line.move.id == "law":
        direction = _GROUPS.get(line.move.record or "") == "direction"
        return frozenset((line.move.event,)) if direction else frozenset()
    if line.move.id not in ("put", "rearrange", "cancel"):
        return frozenset()
    return frozenset(event for each in work.cited(line) for event in _origins(work, each))


def _solves(work: _Awarding, line: Line) -> frozenset[int | None]:
    """The events whose principles a line solves: two of them joined, or an unknown put in."""
    cited = [each for each in work.cited(line) if isinstance(each.relation, Relation)]
    events = [_origins(work, each) for each in cited]
    if line.move.id == "combine":
        return frozenset.intersection(*events) if len(events) == 2 else frozenset()
    if line.move.id != "put" or len(cited) < 2:
        return frozenset()
    own = work.new & _letters(line)
    return frozenset(
        event
        for each, those in zip(cited, events, strict=True)
        for event in those
        if not _is_settled(work, each)
        and work.new & _letters(each) - own
        and any(e != each and work.new & _letters(e) & _letters(each) for e in cited)
    )


def _is_settled(work: _Awarding, line: Line) -> bool:
    """Whether a line says what an unknown is, with no unknown on its other side."""
    sides = None if isinstance(line.relation, Meaning) else _single(line.relation)
    return sides is not None and isinstance(sides[0], Letter) and not letters(sides[1]) & work.new


def _solved_before(work: _Awarding, line: Line) -> list[Line]:
    """The lines above, in the same part, that solve the same principles."""
    events = _solves(work, line)
    return [
        each
        for each in work.above(line)
        if (line.move.id == "put" or work.part(each) == work.part(line))
        and _solves(work, each) & events
    ]


def _of_one_letter(work: _Awarding, line: Line) -> bool:
    """Two lines say what one letter is: what they say is equal; none solves two principles."""
    subjects = [_subject(e) for e in work.cited(line) if isinstance(e.relation, Relation)]
    equal = len(subjects) >= 2 and isinstance(subjects[0], Letter) and subjects[0] == subjects[1]
    return equal and not _solves(work, line)


def _sought(work: _Awarding, line: Line) -> bool:
    """The part asks for the coefficient that the line holds, or the line is to be solved.

    It is where it has scalar products with a change of velocity that holds a letter.
    """
    own = line.relation.options[0][0].left if isinstance(line.relation, Relation) else None
    axes = any(
        isinstance(each.relation, Relation) and each.relation.options[0][0].sign == "parallel to"
        for each in work.cited(line)
    )
    if axes and own is not None and not isinstance(own, Quantity):
        return True
    asked = {
        tree
        for end in work.derivation.items
        if end.part == work.part(line)
        for tree in trees_of(end.answer)
        if isinstance(tree, Letter)
    }
    return any(
        node in asked
        for fact in work.facts(line)
        if fact.id.startswith("e ")
        for tree in trees_of(fact.relation)
        for node in walk(tree)
    )


def _of_facts(work: _Awarding, line: Line) -> bool:
    """It rests on the statement alone, and on what letters stand for."""
    return all(isinstance(each.relation, Meaning) for each in work.cited(line))


def _in_letters(work: _Awarding, line: Line) -> bool:
    """Whether what a line comes to has letters in it."""
    relation = line.relation
    return isinstance(relation, Relation) and bool(letters(relation.options[0][-1].right))


def _of_angles(work: _Awarding, line: Line) -> bool:
    subject = _subject(line)
    if isinstance(subject, Letter):
        meaning = work.derivation.meanings.get(subject.name)
        subject = None if meaning is None else meaning.quantity
    return isinstance(subject, Quantity) and subject.kind in ("deflection", "angle")


def _of_one_term(work: _Awarding, line: Line) -> bool:
    """There is nothing to put together: only one component is not zero."""
    nodes = [node for tree in trees_of(line.relation) for node in walk(tree)]
    squares = any(_is_sum(each) and _has_power(each) for each in nodes)
    rooted = any(
        isinstance(each, Apply) and each.function in ("sqrt", "abs") and _is_sum(each.argument)
        for each in nodes
    )
    return not (squares or rooted or len({e.axis for e in nodes if isinstance(e, Unit)}) > 1)


def _is_given(work: _Awarding, line: Line) -> bool:
    """Whether a line only says what the statement gives."""
    return line.move.id == "fact" and not list(work.cited(line)) and line.number not in work.shown


def _has_power_on_the_left(line: Line) -> bool:
    """Whether a line closes the square of what is given into an equation."""
    if isinstance(line.relation, Meaning):
        return False
    left = line.relation.options[0][0].left
    return _has_power(left) and not has_quantity(left)


def _of_a_number(work: _Awarding, line: Line) -> bool:
    """Whether the value is read off the data as a number, with nothing to work out."""
    sides = None if isinstance(line.relation, Meaning) else _single(line.relation)
    if sides is None or not isinstance(sides[0], Apply):
        return False
    return _length(line) == 1 and not letters(sides[1])


def _is_sum(tree: Expression) -> bool:
    return isinstance(tree, Binary) and tree.op in ("+", "-")


def _has_power(tree: Expression) -> bool:
    return any(isinstance(node, Binary) and node.op == "^" for node in walk(tree))


def _opposite(work: _Awarding, line: Line) -> bool:
    """The roots are two opposite ones: nothing had to be factorised."""
    if isinstance(line.relation, Meaning):
        return False
    roots = [write_expression(options[-1].right) for options in line.relation.options]
    return len(roots) == 2 and any(a == f"-{b}" for a, b in (roots, roots[::-1]))


def _new_inequality(work: _Awarding, line: Line) -> bool:
    """An inequality that comes of none; a comparison by a place on a wall, or by a given bound."""
    if line.move.id == "compare" and not any(
        fact.id.startswith("within ") or _bounds_a_quantity(fact) for fact in work.facts(line)
    ):
        return False
    if isinstance(line.relation, Relation) and _tells_a_quadrant(line.relation):
        return False
    return _unequal(line) and not any(map(_unequal, work.cited(line)))


def _tells_a_quadrant(relation: Relation) -> bool:
    """Whether it is only said that a tangent is positive, so that its angle is acute."""
    match relation:
        case Relation((((Link(Apply("tan"), ">", right)),),)):
            return right == Number(Fraction(0))
    return False


def _claim_without_method(work: _Awarding, line: Line) -> bool:
    """A claim is settled by comparing what stands: nothing else in its item is a method."""
    end = work.ends.get(line.number)
    if line.number not in work.ends or (end is not None and line.number not in work.shown):
        return False
    own = [each for each in work.above(line) if each.item == line.item]
    rules = (work.rule(each) for each in own)
    return not any(rule is not None and "M" in rule.earned(work.style) for rule in rules)


def _bounds_a_quantity(fact: Fact) -> bool:
    """Whether it is given between what bounds a quantity of the motion is."""
    links = [link for each in fact.relation.options for link in each]
    unequal = all(link.sign in ("<", "<=", ">", ">=") for link in links)
    return fact.kind == "given" and unequal and any(map(has_quantity, trees_of(fact.relation)))


def _fact_of_motion(work: _Awarding, line: Line) -> bool:
    """A given equation about the motion is used, and for the first time.

    One that only gives a letter its value is put in like any datum.
    """
    used = {
        fact.id
        for each in work.above(line)
        if each.move.id in ("put", "fact")
        for fact in work.facts(each)
    }
    return any(
        fact.kind == "given"
        and fact.id not in used
        and _single(fact.relation) is not None
        and any(map(has_quantity, trees_of(fact.relation)))
        for fact in work.facts(line)
    )


def _by_its_letter(work: _Awarding, line: Line) -> bool:
    """A letter stands for the component already: nothing is read off."""
    cited = list(work.cited(line))
    return len(cited) <= 2 and any(
        isinstance(each.relation, Meaning)
        and isinstance(each.relation.quantity, Quantity)
        and each.relation.quantity.kind in ("along", "across")
        for each in cited
    )


def _of_an_offset(work: _Awarding, line: Line) -> bool:
    """A line of centres by the sine of its angle to a path, for the first time."""
    facts = [each for each in work.facts(line) if each.id.startswith("axis ")]
    above = {
        fact.id for each in work.above(line) for fact in work.facts(each) if each.move.id == "fact"
    }
    return any(
        each.id not in above
        and any(isinstance(node, Apply) and node.function == "arcsin" for node in walk(tree))
        for each in facts
        for tree in trees_of(each.relation)
    )


def _open_place(work: _Awarding, line: Line) -> bool:
    """A place by a time that is not yet known, or a second coordinate by it."""
    match _subject(line):
        case Quantity("position"):
            return _by_an_open_time(line)
        case Quantity("along", (Quantity("position"), axis)):
            before = [
                e for e in work.above(line) if e.move == replace(line.move, bodies=e.move.bodies)
            ]
            return _by_an_open_time(line) and any(
                _by_an_open_time(each)
                and isinstance(own := _subject(each), Quantity)
                and own.arguments[-1] == axis
                for each in before
            )
    return False


def _by_an_open_time(line: Line) -> bool:
    """Whether a time stands in a line that is not what it is about."""
    match line.relation:
        case Relation(((first, *_), *_)):
            nodes = walk(first.right)
            return any(isinstance(node, Quantity) and node.kind == "time" for node in nodes)
    return False


CONDITIONS: Mapping[str, Callable[[_Awarding, Line], bool]] = {
    "repeated": _repeated,
    "sought": _sought,
    "zero": _zero,
    "wall": lambda work, line: work.walls.get(line.move.event or 0, False),
    "first-at-event": _first_at_event,
    "read-off": _read_off,
    "alone": lambda work, line: len(_alike(work, line)) == 1,
    "first-of-several": lambda work, line: _alike(work, line)[:1] == [line],
    "second-of-several": lambda work, line: _alike(work, line)[1:2] == [line],
    "by-its-letter": _by_its_letter,
    "of-facts": _of_facts,
    "of-angles": _of_angles,
    "in-letters": _in_letters,
    "at-once": lambda work, line: (
        isinstance(line.relation, Relation)
        and not isinstance(line.relation.options[0][0].right, Binary)
    ),
    "place-of-facts": _place_of_facts,
    "another-chord": _another_chord,
    "time": lambda work, line: getattr(_subject(line), "kind", None) == "time",
    "a-place": lambda work, line: (
        line.number not in work.ends and isinstance(_subject(line), Quantity)
    ),
    "of-one-term": _of_one_term,
    "an-equation": lambda work, line: line.number not in work.ends and _has_power_on_the_left(line),
    "of-a-number": _of_a_number,
    "product-above": lambda work, line: any(
        each.move.record == "product" and each.item == line.item for each in work.cited(line)
    ),
    "opposite": _opposite,
    "of-laws": lambda work, line: bool(_solves(work, line)),
    "first": lambda work, line: not _solved_before(work, line),
    "of-one-letter": _of_one_letter,
    "another": lambda work, line: len(_solved_before(work, line)) == 1,
    "on-the-way": lambda work, line: line.number not in work.ends,
    "justified": lambda work, line: line.item in work.justify,
    "new-inequality": _new_inequality,
    "fact-of-motion": _fact_of_motion,
    "claim-without-method": _claim_without_method,
    "of-an-offset": _of_an_offset,
    "of-a-contact": lambda work, line: any(e.id.startswith("contact ") for e in work.facts(line)),
    "open-place": _open_place,
    "at-rest": lambda work, line: is_of_a_body_at_rest(work.derivation, line),
}
"""What a rule may ask of a line, and of the lines about it."""
