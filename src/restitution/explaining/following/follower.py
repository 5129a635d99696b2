"""The follower: it reads a working as its reader does, and says where it does not follow.

It knows the facts of the statement, the events, the records and the answers of the items, and
nothing of how the working was made, or of how the problem was solved.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from fractions import Fraction
from functools import cached_property
from typing import Literal

from restitution.explaining.data.unused import lines_under, unused_facts
from restitution.explaining.following.axes import Axes
from restitution.explaining.following.meanings import means_something
from restitution.explaining.following.settled import settled_derivation
from restitution.explaining.following.trials import Trial, known_of_letters, names_in, setting_of
from restitution.explaining.lines.derivation import (
    Derivation,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Move,
    Note,
    Ref,
    Relation,
    common_scope,
    equality,
    scopes_of,
)
from restitution.explaining.lines.quotients import NotComparableError
from restitution.explaining.lines.trees import statement_of
from restitution.explaining.steps.excluding import excludes, holds_anyway
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Number,
    is_zero,
    letters,
)
from restitution.oracle import Oracle
from restitution.records import dataclass

Reason = Literal[
    "premise-unknown",
    "premise-below",
    "premise-of-another-part",
    "premise-of-another-case",
    "number-twice",
    "axis-turned",
    "case-unknown",
    "case-missing",
    "not-known-of-letters",
    "letter-not-introduced",
    "letter-introduced-twice",
    "does-not-follow",
    "not-comparable",
    "premise-not-needed",
    "said-before",
    "leads-nowhere",
    "fact-not-used",
    "not-the-answer",
    "answer-missing",
    "shown-by-itself",
    "not-excluded",
    "not-idle",
]


@dataclass(frozen=True)
class Complaint:
    """What is wrong with a working: a reason, at a line, and the premise or item concerned."""

    reason: Reason
    line: int | None = None
    about: Ref | None = None

    def __str__(self) -> str:
        where = "" if self.line is None else f"line {self.line}: "
        about = "" if self.about is None else f" ({self.about})"
        return f"{where}{self.reason.replace('-', ' ')}{about}"


def follow(
    derivation: Derivation,
    oracle: Oracle,
    redundant: AbstractSet[str] = frozenset(),
) -> tuple[Complaint, ...]:
    """What is wrong with a working; of no complaints, it is right.

    ``oracle`` knows the roles of the statement's letters. Facts that are ``redundant`` need not be
    used.
    """
    return tuple(Reader(settled_derivation(derivation), oracle, redundant).complaints())


def reader_of(derivation: Derivation, oracle: Oracle) -> Reader:
    """Who reads the lines of a working, made only where one has to be read."""
    return Reader(settled_derivation(derivation), oracle, frozenset())


class Reader:
    """One reading of a working."""

    def __init__(self, derivation: Derivation, oracle: Oracle, redundant: AbstractSet[str]) -> None:
        self.derivation = derivation
        self.redundant = redundant
        self.lines = {line.number: line for line in derivation.lines}
        self.facts = {fact.id: fact for fact in derivation.facts}
        self.parts = derivation.asked
        self.setting = setting_of(derivation, oracle)
        self._axes = Axes(derivation, self.setting)
        self._scopes: dict[Ref, frozenset[str | None] | None] = {}
        self._given_in = scopes_of(derivation.facts)
        self._home_parts: dict[Ref, frozenset[str | None]] = {}

    def complaints(self) -> Iterator[Complaint]:
        numbers = list(self._numbers())
        yield from numbers
        if numbers:
            return  # what a premise refers to is open
        yield from self._letters()
        for ref in self._axes.turned_in_laws():
            yield Complaint("axis-turned", ref if isinstance(ref, int) else None, ref)
        for position, line in enumerate(self.derivation.lines):
            above = self.derivation.lines[:position]
            bad = list(self._premises(line, {line.number for line in above}))
            yield from bad
            if not bad:
                yield from self._line(line)
            yield from self._said_before(line, above)
        yield from self._whole()

    # --- numbers and cases ----------------------------------------------------------------------

    def _numbers(self) -> Iterator[Complaint]:
        """Numbers of two lines, ids of two facts, and cases of what is no line of alternatives."""
        seen: set[Ref] = set()
        for fact in self.derivation.facts:
            if fact.id in seen:
                yield Complaint("number-twice", None, fact.id)
            seen.add(fact.id)
        for line in self.derivation.lines:
            if line.number in seen:
                yield Complaint("number-twice", line.number)
            seen.add(line.number)
        cases: set[int] = set()
        for case in self.derivation.cases:
            if case.number in cases:
                yield Complaint("number-twice", case.line)
            cases.add(case.number)
            own = self.lines.get(case.line)
            options = own.relation.options if own and isinstance(own.relation, Relation) else ()
            if not 0 <= case.option < len(options) or case.line in case.lines:
                yield Complaint("case-unknown", case.line, case.number)
        for end in self.derivation.items:
            if end.case is None:
                continue
            if not any(c.number == end.case and end.line in c.lines for c in self.derivation.cases):
                yield Complaint("case-unknown", end.line, end.item)

    def _options(self, number: int) -> dict[int, set[int]]:
        """For each line of alternatives, the options under which a line stands."""
        options: dict[int, set[int]] = {}
        for case in self.derivation.cases:
            if number in case.lines:
                options.setdefault(case.line, set()).add(case.option)
        return options

    def _cases(self) -> Iterator[Complaint]:
        """Alternatives of which one has no case, and items that are not reached in each."""
        for number in dict.fromkeys(case.line for case in self.derivation.cases):
            relation = self.lines[number].relation
            assert isinstance(relation, Relation)
            every = set(range(len(relation.options)))
            missing = every - {c.option for c in self.derivation.cases if c.line == number}
            for option in sorted(missing):
                yield Complaint("case-missing", number, option)
            if missing:
                continue
            reached: dict[str, set[int]] = {}
            for end in self.derivation.items:
                options = self._options(end.line).get(number, every)
                reached.setdefault(end.item, set()).update(options)
            for item, options in reached.items():
                if options != every:
                    yield Complaint("case-missing", number, item)

    # --- letters --------------------------------------------------------------------------------

    def _letters(self) -> Iterator[Complaint]:
        known = set(self.setting.roles)
        for fact in self.derivation.facts:
            known |= names_in(fact.relation)
        introduced: set[str] = set()
        quantities: dict[Expression, str] = {}
        for line in self.derivation.lines:
            if isinstance(line.relation, Meaning):
                meaning = line.relation
                if meaning.letter in introduced | known:
                    yield Complaint("letter-introduced-twice", line.number, meaning.letter)
                if meaning.quantity in quantities:
                    yield Complaint("letter-introduced-twice", line.number, meaning.letter)
                quantities[meaning.quantity] = meaning.letter
                introduced.add(meaning.letter)
                missing = letters(meaning.quantity) - known - introduced
            else:
                missing = names_in(line.relation) - known - introduced
            for name in sorted(missing):
                yield Complaint("letter-not-introduced", line.number, name)

    # --- one line -------------------------------------------------------------------------------

    def _premises(self, line: Line, above: AbstractSet[int]) -> Iterator[Complaint]:
        part = self.parts.get(line.item or "")
        if len(set(line.premises)) < len(line.premises):
            yield Complaint("premise-not-needed", line.number)
        for ref in line.premises:
            if isinstance(ref, int):
                if ref not in self.lines:
                    yield Complaint("premise-unknown", line.number, ref)
                elif ref not in above:
                    yield Complaint("premise-below", line.number, ref)
                elif not self._within_case(line.number, ref):
                    yield Complaint("premise-of-another-case", line.number, ref)
                elif line.item is not None and not self._holds(ref, part):
                    yield Complaint("premise-of-another-part", line.number, ref)
            elif ref in self.facts:
                fact = self.facts[ref]
                if fact.part is not None and line.item is not None and fact.part != part:
                    yield Complaint("premise-of-another-part", line.number, ref)
            elif known_of_letters(ref, self.setting) is None:
                yield Complaint("not-known-of-letters", line.number, ref)

    def _within_case(self, line: int, premise: int) -> bool:
        """Whether a premise holds wherever a line does."""
        own = self._options(line)
        return all(
            own.get(n) and own[n] <= options for n, options in self._options(premise).items()
        )

    def _scope(self, ref: Ref) -> frozenset[str | None] | None:
        """The parts in which a fact, or all on which a line rests, is given; None: in all."""
        if isinstance(ref, str):
            return self._given_in.get(ref)
        if ref not in self._scopes:
            self._scopes[ref] = None
            known = (premise for premise in self.lines[ref].premises if premise in self._known_refs)
            self._scopes[ref] = common_scope(map(self._scope, known))
        return self._scopes[ref]

    def _homes(self, ref: Ref) -> frozenset[str | None]:
        """The parts whose own facts a line rests on, or that of a fact."""
        if isinstance(ref, str):
            return frozenset({self.facts[ref].part} if ref in self.facts else ())
        if ref not in self._home_parts:
            self._home_parts[ref] = frozenset()
            known = (premise for premise in self.lines[ref].premises if premise in self._known_refs)
            self._home_parts[ref] = frozenset().union(*map(self._homes, known))
        return self._home_parts[ref]

    @cached_property
    def _known_refs(self) -> frozenset[Ref]:
        return frozenset((*self.lines, *self.facts))

    def _holds(self, ref: Ref, part: str | None) -> bool:
        """Whether a fact, or a line, holds in a part."""
        scope = self._scope(ref)
        return scope is None or part in scope

    def _line(self, line: Line) -> Iterator[Complaint]:
        if isinstance(line.relation, Meaning):
            if line.premises:
                yield Complaint("premise-not-needed", line.number, line.premises[0])
            if line.move.id != "let" or not means_something(line.relation, self.setting):
                yield Complaint("does-not-follow", line.number)
            return
        try:
            right = self._trial(line).follows(line.move, line.premises, line.relation)
        except NotComparableError:
            yield Complaint("not-comparable", line.number)
            return
        if not right:
            yield Complaint("does-not-follow", line.number)
            return
        trial = self._trial(line)
        for ref in line.premises:
            if ref in trial.needed(line.move, line.premises, line.relation, (ref,)):
                continue
            if not self._is_condition(line, ref) and not self._clash_without(trial, line, ref):
                yield Complaint("premise-not-needed", line.number, ref)

    @staticmethod
    def _clash_without(trial: Trial, line: Line, ref: Ref) -> bool:
        """Whether the other premises of a line contradict each other.

        Then all follows from them: that the line does, as an equation with twice or half its left
        side does, tells nothing of this one.
        """
        others = tuple(other for other in line.premises if other != ref)
        match line.relation:
            case Relation(((Link(left, "=", right),),)) if not (is_zero(left) or is_zero(right)):
                wrong = [equality(Binary(sign, left, _TWO), right) for sign in ("*", "/")]
            case _:
                return False
        try:
            return any(trial.follows(line.move, others, own) for own in wrong)
        except NotComparableError:
            return False

    def _is_condition(self, line: Line, ref: Ref) -> bool:
        """Whether a premise is a condition that is given, among those that a line joins.

        It is one of them even if the others imply it. So is one of several places at which a
        greatest or least value is reached.
        """
        if line.move.id == "answer" and line.move.record in ("greatest", "least"):
            return len(line.premises) > 2 and ref != line.premises[0]
        if line.move.id != "compare":
            return False
        if any(self._says_the_same(ref, other) for other in line.premises):
            return True
        if isinstance(ref, str):
            return False
        if self._keeps_its_range(line, ref):
            return True
        others = {r for other in line.premises if other != ref for r in self._under_ref(other)}
        return any(
            fact.kind in ("given", "range")
            and fact.id not in others
            and any(link.sign in _ORDERED for links in fact.relation.options for link in links)
            for fact in (self.facts[r] for r in self._under(ref) if r in self.facts)
        )

    def _says_the_same(self, ref: Ref, other: Ref) -> bool:
        """Whether one of two premises is an inequality that is given, and the other a line of it.

        The line is derived without it: the fact holds anyway.
        """
        line, fact = (ref, other) if isinstance(ref, int) else (other, ref)
        if not isinstance(line, int) or not isinstance(fact, str) or fact not in self.facts:
            return False
        own = self.facts[fact]
        signs = {link.sign for links in own.relation.options for link in links}
        same = own.kind == "given" and own.relation == self.lines[line].relation
        return same and signs <= {*_ORDERED} and fact not in self._under(line)

    def _keeps_its_range(self, line: Line, ref: int) -> bool:
        """Whether a premise says that another coefficient is at most 1, as it has to be.

        So no other bound comes of it for what a line bounds.
        """
        assert isinstance(line.relation, Relation)
        match self.lines[ref].relation:
            case Relation(((Link(Letter(name), "<="), *_) as links,)) if _is_at_most_one(links):
                role = self.setting.roles.get(name)
            case _:
                return False
        if role is None or role.kind != "restitution":
            return False
        return name not in names_in(line.relation)

    def _under_ref(self, ref: Ref) -> set[Ref]:
        return self._under(ref) if isinstance(ref, int) else {ref}

    def needed(self, number: int, doubted: Iterable[Ref]) -> tuple[Ref, ...]:
        """The premises of a line without those of the doubted ones without which it follows."""
        line = self.lines[number]
        assert isinstance(line.relation, Relation)
        return self._trial(line).needed(line.move, line.premises, line.relation, doubted)

    def completed(self, number: int, more: Iterable[Ref]) -> tuple[Ref, ...]:
        """The premises of a line, with some more where it does not follow without them."""
        line = self.lines[number]
        assert isinstance(line.relation, Relation)
        trial, premises = self._trial(line), line.premises
        every = (*premises, *(ref for ref in more if ref not in premises))
        try:
            if trial.follows(line.move, premises, line.relation) or not trial.follows(
                line.move, every, line.relation
            ):
                return premises
        except NotComparableError:
            return premises
        return trial.needed(line.move, every, line.relation, every[len(premises) :])

    def accepts(self, line: Line) -> bool:
        """Whether a line follows from what it cites."""
        assert isinstance(line.relation, Relation)
        try:
            return self._trial(line).follows(line.move, line.premises, line.relation)
        except NotComparableError:
            return True  # nobody can tell

    def speaks_of(self, ref: Ref, names: AbstractSet[str]) -> bool:
        """Whether a premise is a line, or is about one of some letters."""
        known = None if isinstance(ref, int) else known_of_letters(ref, self.setting)
        return known is None or bool(known.letters & names)

    def _trial(self, line: Line | None) -> Trial:
        """What may be cited where a line stands, or below all."""
        options = {} if line is None else self._options(line.number)

        def cited(ref: Ref) -> Relation | Meaning | None:
            return self._cited(ref, options) if isinstance(ref, int) or ref in self.facts else None

        return Trial(self.setting, cited, lambda ref: known_of_letters(ref, self.setting))

    def _cited(self, ref: Ref, options: Mapping[int, AbstractSet[int]]) -> Relation | Meaning:
        """What a premise says: of a line of alternatives, the options that a line stands under."""
        if isinstance(ref, str):
            return self.facts[ref].relation
        relation = self.lines[ref].relation
        if ref in options and isinstance(relation, Relation):
            return Relation(tuple(relation.options[n] for n in sorted(options[ref])))
        return relation

    def _said_before(self, line: Line, above: Iterable[Line]) -> Iterator[Complaint]:
        if line.move.id in ("answer", "shown") or isinstance(line.relation, Meaning):
            return
        case = {case.number for case in self.derivation.cases if line.number in case.lines}
        own = statement_of(line.relation)
        for earlier in above:
            if isinstance(earlier.relation, Meaning) or statement_of(earlier.relation) != own:
                continue
            other = {c.number for c in self.derivation.cases if earlier.number in c.lines}
            part = self.parts.get(line.item or "")
            if line.item is not None and not self._homes(earlier.number) <= {None, part}:
                continue  # it rests on what another part is given
            if not case or not other or case & other:
                yield Complaint("said-before", line.number, earlier.number)
                return

    # --- the whole ------------------------------------------------------------------------------

    def _whole(self) -> Iterator[Complaint]:
        on_the_way: set[Ref] = set()
        for end in self.derivation.items:
            under = self._under(end.line)
            on_the_way |= under
            yield from self._end(end, under)
            yield from self._in_force(end, under)
        for note in self.derivation.notes:
            for ref in note.premises:
                on_the_way |= self._under(ref)
            yield from self._note(note)
        yield from self._cases()
        for line in self.derivation.lines:
            if line.number not in on_the_way:
                yield Complaint("leads-nowhere", line.number)
        yield from self._facts_used()
        for number, ref in self._axes.turned_in_components():
            yield Complaint("axis-turned", number, ref)

    def _under(self, number: Ref) -> set[Ref]:
        """A line, or a fact, and all that it rests on."""
        return lines_under(self.derivation, number)

    def _in_force(self, end: ItemEnd, under: AbstractSet[Ref]) -> Iterator[Complaint]:
        """Facts of one part hold for no other, by whatever lines they come to it."""
        for ref in sorted(ref for ref in under if isinstance(ref, str)):
            if ref in self.facts and not self._holds(ref, end.part):
                yield Complaint("premise-of-another-part", end.line, ref)

    def _end(self, end: ItemEnd, under: AbstractSet[Ref]) -> Iterator[Complaint]:
        line = self.lines.get(end.line)
        if line is None or isinstance(line.relation, Meaning):
            yield Complaint("answer-missing", end.line, end.item)
            return
        if not _same(line.relation, end.answer):
            yield Complaint("not-the-answer", end.line, end.item)
        if line.item != end.item and not self._holds(end.line, end.part):
            yield Complaint("premise-of-another-part", end.line, end.item)
        if not end.shown:
            return
        statement = statement_of(end.answer)
        for other in self.derivation.lines:
            if other.number == end.line:
                break
            if line.move.id == "answer" and other.number in line.premises:
                continue  # the bound of a greatest or least value
            if isinstance(other.relation, Relation) and statement_of(other.relation) == statement:
                yield Complaint("shown-by-itself", other.number, end.item)

    # --- notes ----------------------------------------------------------------------------------

    def _note(self, note: Note) -> Iterator[Complaint]:
        """A note whose premises are unknown, or can hold together after all."""
        bad = False
        for ref in note.premises:
            known = ref in self.lines or ref in self.facts
            if not known and (isinstance(ref, int) or known_of_letters(ref, self.setting) is None):
                yield Complaint("premise-unknown", None, ref)
                bad = True
            elif not self._holds(ref, note.part):
                yield Complaint("premise-of-another-part", None, ref)
        if note.kind in ("missing", "agreeing") and note.premises and not bad:
            if not holds_anyway(self._trial(None).step(Move("put"), note.premises)):
                yield Complaint("not-idle", None, note.item)
            return
        if bad or not note.premises or note.kind not in _EXCLUDING:
            return
        if not self._excludes(note, note.premises):
            yield Complaint("not-excluded", None, note.item)
            return
        for n, ref in enumerate(note.premises):
            if self._excludes(note, (*note.premises[:n], *note.premises[n + 1 :]), sure=True):
                yield Complaint("premise-not-needed", None, ref)

    def _excludes(self, note: Note, premises: tuple[Ref, ...], sure: bool = False) -> bool:
        """Whether premises cannot hold together, nor with the claim where letters have values.

        What cannot be compared is not complained of: then the answer is what is ``sure``.
        """
        trial = self._trial(None)
        return excludes(note, trial.step(Move("reject"), premises), unknown=not sure)

    def _facts_used(self) -> Iterator[Complaint]:
        for fact in unused_facts(self.derivation, self._under):
            if fact.id not in self.redundant:
                yield Complaint("fact-not-used", None, fact.id)


def _same(line: Relation, answer: Relation) -> bool:
    """Whether a line says an answer: the last link of a chain does, with the first subject."""
    if statement_of(line) == statement_of(answer):
        return True
    subject = answer.options[0][0].left
    if all(subject in {link.left for link in links} for links in line.options):
        # Of several unknowns one is what was asked.
        own = (tuple(link for link in links if link.left == subject) for links in line.options)
        if statement_of(Relation(tuple(dict.fromkeys(own)))) == statement_of(answer):
            return True
    if len(line.options) != 1 or len(line.only) < 2:
        return False
    links = line.only
    if any(a.sign != "=" or a.right != b.left for a, b in itertools.pairwise(links)):
        return False
    whole = Link(links[0].left, links[-1].sign, links[-1].right)
    return statement_of(Relation(((whole,),))) == statement_of(answer)


_TWO = Number(Fraction(2))
_ORDERED = ("<", "<=", ">", ">=")


# These notes say that something cannot be.
def _is_at_most_one(links: Sequence[Link]) -> bool:
    """Whether a chain of bounds ends in 1: e ≤ 1, e ≤ 3/4 < 1."""
    match links[-1].right:
        case Number(value):
            return value == 1 and {link.sign for link in links} <= {"<", "<="}
    return False


_EXCLUDING = frozenset({"impossible", "contradiction", "refuted"})
