"""A working while it is written: its lines, what is known by them, and what each rests on."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import field, replace
from functools import lru_cache
from itertools import chain as joined
from typing import Any

import sympy as sp

from restitution.errors import StatementError, UnsupportedError
from restitution.exact.symbols import symbols_in
from restitution.explaining.following.trials import names_in
from restitution.explaining.lines.derivation import (
    Case,
    Event,
    Fact,
    ItemEnd,
    Line,
    Link,
    Meaning,
    Move,
    MoveId,
    Note,
    NoteKind,
    Ref,
    Relation,
    Route,
    Showing,
    Sign,
    common_scope,
    numbers_in,
    scopes_of,
)
from restitution.explaining.lines.trees import statement_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    has_quantity,
    is_quantity,
)
from restitution.planning.writing.forms import UnwrittenError, alike
from restitution.records import dataclass
from restitution.vector import Vector

# These moves start from the line that is cited first.
_FROM_A_LINE = frozenset(
    (
        *("put", "rearrange", "cancel", "identity", "combine", "divide", "monotone"),
        *("roots", "reject", "triangle", "inverse", "value", "answer"),
    )
)


class NotPlannedError(Exception):
    """A question, or a shape of equation, for which there is no plan."""


UNPLANNED = (NotPlannedError, UnwrittenError, UnsupportedError, StatementError)
"""What has no plan, what no line says, what the story does not tell exactly, and what no value has:
a quotient in the lines of which the divisor comes to zero."""

Scope = frozenset[str | None] | None
"""The parts in which something holds; None where it holds in all."""

# The moves that say what stands above once more.
_LAST = frozenset({"answer", "shown"})


@dataclass(frozen=True)
class Source:
    """A value that is known, as an expression or a vector of them, and what it rests on.

    ``axis`` is what a component rests on beside that, where it is named by the line of centres;
    ``form`` is how the line writes it in which it comes of the data, where that is another tree.
    """

    value: Any
    refs: tuple[Ref, ...] = ()
    axis: tuple[Ref, ...] = ()
    form: Expression | None = None

    @property
    def whole(self) -> tuple[Ref, ...]:
        """All that it rests on."""
        return together(self.refs, self.axis)


def together(*groups: Iterable[Ref]) -> tuple[Ref, ...]:
    """Premises without repetitions: facts first, in the order named, then lines by number."""
    refs = tuple(dict.fromkeys(joined.from_iterable(groups)))
    if len(refs) < 2:
        return refs
    numbers = numbers_in(refs)
    if not numbers:
        return refs
    if len(numbers) == len(refs):
        return tuple(sorted(numbers))
    return (*(ref for ref in refs if isinstance(ref, str)), *sorted(numbers))


def link(left: Expression, right: Expression, sign: Sign = "=", by: MoveId | None = None) -> Link:
    """``left sign right``."""
    return Link(left, sign, right, by)


def is_value_of(link: Link, quantity: Quantity | Letter) -> bool:
    """Whether an equation gives a quantity, as a number or in letters."""
    return (link.left, link.sign) == (quantity, "=") and not has_quantity(link.right)


@lru_cache(maxsize=4096)
def _as_before(relation: Relation) -> Relation:
    """What a line says, as the object that said it before: that has kept what it was asked for."""
    return relation


def chain(first: Expression, *steps: tuple[Expression, MoveId | None]) -> Relation:
    """``first = a = b``, in which each later link has its own move; what repeats is left out."""
    links: list[Link] = []
    last = first
    for tree, by in steps:
        if links and alike(tree, last):
            # The form of an answer is kept of two that only differ in brackets.
            links[-1] = Link(links[-1].left, "=", tree, links[-1].by)
            last = tree
            continue
        links.append(Link(last, "=", tree, by if links else None))
        last = tree
    return _as_before(Relation((tuple(links),)))


def _goes_further(one: Relation | Meaning, other: Relation | Meaning) -> bool:
    """Whether a chain begins with another, and works it out."""
    if isinstance(one, Meaning) or isinstance(other, Meaning):
        return False
    if len(one.options) != 1 or len(other.options) != 1:
        return False
    return one.only[: len(other.only)] == other.only


def _is_same(one: Relation | Meaning, other: Relation | Meaning) -> bool:
    """Whether a line says another.

    A chain says what its ends do, in any order of factors; an inequality may be written from
    either side.
    """
    if isinstance(one, Meaning) or isinstance(other, Meaning):
        return one == other
    whole, end = one.ends, other.ends
    if whole is not None and end is not None:
        return whole.left == end.left and alike(whole.right, end.right)
    if one == other:
        return True
    links = (*one.options[0], *other.options[0])
    if any(equation.sign not in ("<", "<=", ">", ">=") for equation in links):
        return False
    return statement_of(one) == statement_of(other)


@dataclass
class Desk:
    """The lines of a working so far.

    ``splits`` are the lines of alternatives, and which of them, under which the lines stand that
    come now; there are none where all solutions are still one. ``route`` is which of
    the ways to a goal is taken, ``others`` are those that are not.
    """

    events: tuple[Event, ...]
    facts: tuple[Fact, ...]
    route: int = 1
    lines: list[Line] = field(default_factory=list)
    ends: list[ItemEnd] = field(default_factory=list)
    cases: list[Case] = field(default_factory=list)
    others: list[Route] = field(default_factory=list)
    notes: list[Note] = field(default_factory=list)
    shown: list[int] = field(default_factory=list)
    """Equations between letters that were to be shown: they are quoted from then on."""
    item: str | None = None
    part: str | None = None
    splits: tuple[tuple[int, int], ...] = ()
    apart: bool = False
    """Whether the part that is written takes nothing from what another is given in the same words:
    where it has several solutions, that has them too."""
    within: frozenset[int] = frozenset()
    """The lines of a case of an earlier part in which the solution stands that is written."""
    withheld: frozenset[str] = frozenset()
    """Facts that the part gives further down: they are not in force yet."""
    assumed: frozenset[str] = frozenset()
    """Conditions under which a range has a form: they are in force only while that is written."""
    early: dict[str, ItemEnd] = field(default_factory=dict)
    """The ends of items without such facts, by item, where these say more of their answers."""
    waiting: dict[Any, Any] = field(default_factory=dict)
    """What a `Solver` without these facts has left to one with them."""
    paths: Mapping[int, Vector] = field(default_factory=dict)
    """The paths with which the line of centres of an impact makes an angle that has a letter."""
    version: int = 0
    """How often what is known has changed."""
    _sources: dict[Expression, tuple[Source, ...]] = field(default_factory=dict)
    _scopes: dict[Ref, Scope] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self._scopes |= scopes_of(self.facts)
        # A line may rest on what another part is given in the same words; a fact is cited at home.
        self._own: dict[Ref, Scope] = {
            fact.id: None if fact.part is None else frozenset({fact.part}) for fact in self.facts
        }

    # --- lines ----------------------------------------------------------------------------------

    def write(
        self,
        move: Move,
        premises: Iterable[Ref],
        relation: Relation | Meaning,
        shown: Showing = "line",
    ) -> int:
        """Writes a line, and returns its number. One that stands already is not written again."""
        own = tuple(premises)
        refs = tuple(dict.fromkeys(own)) if move.id in _FROM_A_LINE else together(own)
        subject = relation.subject
        for line in self.lines if move.id not in _LAST else ():
            if (
                (line.relation.subject == subject and _is_same(line.relation, relation))
                or (
                    line.move.id == move.id
                    and line.move == move
                    and _goes_further(line.relation, relation)
                    and set(line.premises) == set(refs)
                )
            ) and self.holds(line.number):
                return line.number
        return self._added(move, refs, relation, shown)

    def write_again(self, move: Move, premises: Iterable[Ref], relation: Relation) -> int:
        """Writes a line that says what one above says, as it rests on more than that."""
        return self._added(move, together(premises), relation, "line")

    def _added(
        self, move: Move, refs: tuple[Ref, ...], relation: Relation | Meaning, shown: Showing
    ) -> int:
        number = len(self.lines) + 1
        relation = _as_before(relation) if isinstance(relation, Relation) else relation
        self.lines.append(Line(number, self.item, move, refs, relation, (), shown))
        self._scopes[number] = common_scope(map(self._scope, refs))
        return number

    def assume(self, fact: Fact) -> None:
        """Takes up a condition, which is in force until it is one of those ``assumed``."""
        self.facts = (*self.facts, fact)
        self.version += 1
        self._scopes |= scopes_of((fact,))
        self._own[fact.id] = None if fact.part is None else frozenset({fact.part})

    def line(self, number: int) -> Line:
        """The line with a number."""
        return self.lines[number - 1]

    def meanings(self, lines: Iterable[int]) -> list[int]:
        """The lines that say what the letters in some lines stand for: δ is a deflection."""
        return self.introducing({n for line in lines for n in names_in(self.line(line).relation)})

    def introducing(self, names: Collection[str]) -> list[int]:
        """The lines that introduce some letters."""
        return [
            line.number
            for line in self.lines
            if isinstance(line.relation, Meaning) and line.relation.letter in names
        ]

    def meant(self, tree: Expression) -> Expression:
        """What a letter that the working introduces stands for; any other tree itself."""
        if isinstance(tree, Letter):
            for number in self.introducing({tree.name}):
                own = self.line(number).relation
                assert isinstance(own, Meaning)
                return own.quantity
        return tree

    def relation(self, number: int) -> Relation:
        """What a line says; it must not be one that introduces a letter."""
        own = self.line(number).relation
        assert isinstance(own, Relation)
        return own

    def last_link(self, number: int) -> Link:
        """A line as one link, from its first side to its last."""
        return self.relation(number).whole

    def under(self, *cited: Ref) -> frozenset[Ref]:
        """Lines or facts, and all that they rest on."""
        refs: set[Ref] = set()
        pending: list[Ref] = [*cited]
        while pending:
            ref = pending.pop()
            if ref not in refs:
                refs.add(ref)
                pending += self.line(ref).premises if isinstance(ref, int) else ()
        return frozenset(refs)

    def lines_under(self, source: Source) -> list[Line]:
        """The lines from which a value comes."""
        return [self.line(number) for number in numbers_in(self.under(*source.refs))]

    def _scope(self, ref: Ref) -> Scope:
        return self._scopes.get(ref)

    def holds(self, ref: Ref) -> bool:
        """Whether what a line rests on is in force in the part that is written."""
        hidden = self.withheld | self.assumed
        if hidden and self._rests_on(ref) & hidden:
            return False
        if self.apart:
            # What one case of an earlier part says does not hold in all of this one.
            in_cases = {number for case in self.cases for number in case.lines}
            if (in_cases - self.within) & self._rests_on(ref):
                return False
            return self._homes(ref) <= {None, self.part}
        scope = self._own[ref] if ref in self._own else self._scopes.get(ref)
        return scope is None or self.part in scope

    def _rests_on(self, ref: Ref) -> frozenset[Ref]:
        """A line and all that it rests on, or a fact alone."""
        return self.under(ref) if isinstance(ref, int) else frozenset({ref})

    def _homes(self, ref: Ref) -> frozenset[str | None]:
        """The parts whose own facts a line rests on, or that of a fact."""
        under = self._rests_on(ref)
        return frozenset(fact.part for fact in self.facts if fact.id in under)

    def reword(self, number: int, value: Expression) -> None:
        """Writes the value at the end of a line, and of its items, in another form."""
        own = self.relation(number).only
        links = (*own[:-1], replace(own[-1], right=value))
        self.lines[number - 1] = replace(self.line(number), relation=Relation((links,)))
        for n, end in enumerate(self.ends):
            if end.line == number and end.answer.only[-1].right == own[-1].right:
                last = replace(end.answer.only[-1], right=value)
                self.ends[n] = replace(end, answer=Relation(((*end.answer.only[:-1], last),)))

    # --- values ---------------------------------------------------------------------------------

    def know(
        self,
        quantity: Expression,
        value: Any,
        refs: Iterable[Ref],
        form: Expression | None = None,
    ) -> Source:
        """From here on a quantity, a letter, or a ratio of an angle has a value."""
        source = Source(value, tuple(refs), form=form)
        self.version += 1
        self._sources[quantity] = (*self._sources.get(quantity, ()), source)
        return source

    def known(self, quantity: Expression) -> Source | None:
        """The latest value of a quantity, or of a letter, that is in force; None without one."""
        for source in reversed(self._sources.get(quantity, ())):
            if all(map(self.holds, source.refs)):
                return source
        return None

    def components(self) -> Iterator[tuple[Expression, Source]]:
        """The products of a letter and a ratio of an angle, such as v cos θ, that are known."""
        for quantity in self._sources:
            match quantity:
                case Binary("*", Letter(), Apply("cos" | "sin")):
                    source = self.known(quantity)
                    if source is not None:
                        yield quantity, source

    def loosen(self, letter: Expression, source: Source) -> None:
        """A letter that is known by a line is open again, and the line is an equation for it."""
        self.forget_value(letter, source)
        self.shown += numbers_in(source.refs)

    def forget_value(self, letter: Expression, source: Source) -> None:
        """What a letter is known to be is forgotten; the lines stay."""
        self.version += 1
        own = self._sources[letter]
        self._sources[letter] = tuple(other for other in own if other is not source)

    def forget_components(self, mark: Mark) -> None:
        """Forgets what components have come to since a mark, of which the lines stay."""
        self.version += 1
        for key in list(self._sources):
            if is_quantity(key, "along", "across", "velocity"):
                self._sources[key] = mark.sources.get(key, ())

    # --- solutions apart ---------------------------------------------------------------------

    def fork(self) -> Desk:
        """A copy, on which another solution goes on."""
        return replace(
            self,
            lines=list(self.lines),
            ends=list(self.ends),
            cases=list(self.cases),
            others=list(self.others),
            notes=list(self.notes),
            early=dict(self.early),
            waiting=dict(self.waiting),
            shown=list(self.shown),
            _sources=dict(self._sources),
            _scopes=dict(self._scopes),
        )

    def take_letters(self, letters: Mapping[str, sp.Symbol]) -> None:
        """Has all values in the letters of a part, in which more may be known of their signs."""
        self.version += 1
        for key, own in self._sources.items():
            self._sources[key] = tuple(
                replace(source, value=_in_letters(source.value, letters)) for source in own
            )

    def take_last(self) -> None:
        """Takes away the last line, and the values that it gives."""
        number = len(self.lines)
        self.version += 1
        for key, own in self._sources.items():
            self._sources[key] = tuple(source for source in own if number not in source.whole)
        del self._scopes[number], self.lines[-1]

    def rewrite(self, line: Line) -> None:
        """Puts another line in the place of the one that has its number."""
        self.version += 1
        self.lines[line.number - 1] = line
        self._scopes[line.number] = common_scope(map(self._scope, line.premises))

    def forget(self, number: int) -> None:
        """Forgets the values that lines below one give, since they are those of one case."""
        for key, own in self._sources.items():
            kept = (e for e in own if all(isinstance(r, str) or r < number for r in e.whole))
            self._sources[key] = tuple(kept)
        for line in self.lines:
            self._scopes[line.number] = common_scope(map(self._scope, line.premises))

    def show(self, line: int) -> None:
        """Has a line printed that was not."""
        own = self.line(line)
        if own.shown != "line":
            self.lines[line - 1] = replace(own, shown="line")

    def end(self, item: str, line: int, answer: Relation, shown: bool = False) -> None:
        """The last line of an item, which is printed."""
        self.show(line)
        self.ends.append(ItemEnd(item, line, answer, self.part, shown))

    def is_of_this_part(self, number: int) -> bool:
        """Whether a line was written for an item of the part that is written now."""
        own, now = (
            (item or "").rstrip("0123456789") for item in (self.line(number).item, self.item)
        )
        return own == now

    def new_note(self, item: str, kind: NoteKind, reason: str = "", **rest: Any) -> Note:
        """A note on the item that is next, with these fields."""
        items = {*(end.item for end in self.ends), *(note.item for note in self.notes)}
        return Note(item, kind, len(items - {item}), self.part, reason, **rest)

    def note(self, item: str, kind: NoteKind, reason: str = "", **rest: Any) -> None:
        """What stands in place of an answer: a `Note` with these fields."""
        self.notes.append(self.new_note(item, kind, reason, **rest))

    # --- trials ---------------------------------------------------------------------------------

    def mark(self) -> Mark:
        """The state of the desk, to which ``back`` returns."""
        sources = dict(self._sources)
        counts = len(self.lines), len(self.ends), len(self.notes), len(self.others)
        return Mark(*counts, sources, dict(self._scopes), self.splits)

    def back(self, mark: Mark) -> None:
        """Takes away all that was written since a mark."""
        self.version += 1
        del self.lines[mark.lines :]
        del self.ends[mark.ends :]
        del self.notes[mark.notes :]
        self._sources = dict(mark.sources)
        self._scopes = dict(mark.scopes)
        self.splits = mark.splits
        del self.others[mark.others :]
        self.shown = [number for number in self.shown if number <= mark.lines]


@dataclass(frozen=True)
class Mark:
    """What stood on a desk at some time."""

    lines: int
    ends: int
    notes: int
    others: int
    sources: Mapping[Expression, tuple[Source, ...]]
    scopes: Mapping[Ref, Scope]
    splits: tuple[tuple[int, int], ...]


def _in_letters(value: Any, letters: Mapping[str, sp.Symbol]) -> Any:
    """A value, or each part of a vector, with other symbols for its letters."""
    if isinstance(value, Vector):
        return Vector(*(_in_letters(part, letters) for part in value))
    if not isinstance(value, sp.Basic):
        return value
    changes = {s: letters[s.name] for s in symbols_in(value) if s.name in letters}
    changes = {symbol: own for symbol, own in changes.items() if symbol != own}
    return value.xreplace(changes) if changes else value
