"""A working as data: numbered lines, each made by a named move from what stands above it.

A line rests on *premises*: earlier lines by number, facts of the statement by their id, and what
is known of a letter (``0 <= e``, ``acute: alpha``) by its text. Trees are those of the statement
language. They are never evaluated when they are built: ``3((-4i - j) - (2i + 7j))`` and
``-18i - 24j`` are two lines. Comparing them is the work of the follower.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from functools import cached_property
from itertools import pairwise
from typing import Literal, get_args

from restitution.explaining.lines.marks import Marks
from restitution.expression.tree import Expression, Letter, Place, keeps_hash, letters
from restitution.records import dataclass

Ref = int | str
"""A premise: the number of a line, the id of a fact, or the text of what is known of a letter."""

MoveId = Literal[
    "let",
    "fact",
    "law",
    "define",
    "put",
    "rearrange",
    "cancel",
    "combine",
    "divide",
    "square-add",
    "solve",
    "identity",
    "triangle",
    "roots",
    "reject",
    "sign",
    "compare",
    "monotone",
    "complete",
    "inverse",
    "value",
    "answer",
    "shown",
]
MOVES: tuple[MoveId, ...] = get_args(MoveId)

FactKind = Literal["data", "given", "range", "case", "geometry", "earlier"]
EventKind = Literal["impact", "kick", "arrival"]
Showing = Literal["line", "inline", "silent"]
"""Whether a line is printed by itself, within another one, or not at all."""
Sign = Literal["=", "<", "<=", ">", ">=", "!=", "≈", "parallel to", "perpendicular to"]
BEARINGS: frozenset[Sign] = frozenset({"parallel to", "perpendicular to"})
"""Signs that relate directions; what is parallel or perpendicular to something is not at rest."""
SIGNS: tuple[Sign, ...] = get_args(Sign)
# The sign of an inequality whose sides are exchanged.
FLIPPED: Mapping[str, Sign] = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
# What holds where an inequality does not.
OPPOSITE: Mapping[str, Sign] = {"<": ">=", "<=": ">", ">": "<=", ">=": "<"}


@keeps_hash
@dataclass(frozen=True)
class Link:
    """``left sign right``; ``by`` is the move of a later link of a chain, where it has its own."""

    left: Expression
    sign: Sign
    right: Expression
    by: MoveId | None = None


@keeps_hash
@dataclass(frozen=True)
class Relation:
    """What a line says: options of which one holds, each of links that hold together.

    Most lines have one option of one link. A chain ``a = b = c`` is an option of links, each
    beginning where the one before it ends.
    """

    options: tuple[tuple[Link, ...], ...]

    @cached_property
    def only(self) -> tuple[Link, ...]:
        """The links of a relation without alternatives. Raises ValueError where it has some."""
        (links,) = self.options
        return links

    @cached_property
    def trees(self) -> tuple[Expression, ...]:
        """Both sides of each link."""
        return tuple(
            side for links in self.options for link in links for side in (link.left, link.right)
        )

    @cached_property
    def ends(self) -> Link | None:
        """A chain of equations by its ends; None for any other relation."""
        if len(self.options) != 1:
            return None
        (links,) = self.options
        if any(link.sign != "=" for link in links):
            return None
        if any(a.right != b.left for a, b in pairwise(links)):
            return None
        return Link(links[0].left, "=", links[-1].right)

    @cached_property
    def subject(self) -> int | None:
        """A number that two chains of equations share if their first sides are the same.

        None of any other relation.
        """
        return None if self.ends is None else hash(self.ends.left)

    @cached_property
    def whole(self) -> Link:
        """From its first side to its last. Raises ValueError where it has alternatives."""
        links = self.only
        return Link(links[0].left, links[0].sign, links[-1].right)

    @cached_property
    def sides(self) -> tuple[Expression, Expression] | None:
        """The sides of an equation, a chain by its ends; None for any other relation."""
        if len(self.options) != 1:
            return None
        link = whole_of(self.options[0])
        return None if link is None or link.sign not in ("=", "≈") else (link.left, link.right)

    @cached_property
    def letters(self) -> frozenset[str]:
        """The letters of which it speaks."""
        return frozenset().union(*map(letters, self.trees))


@keeps_hash
@dataclass(frozen=True)
class Meaning:
    """A letter that a working introduces, for one quantity and no other.

    ``sense`` is the direction in which a component counts as positive, where that is not the
    direction in which the quantity is taken.
    """

    letter: str
    quantity: Expression
    sense: Expression | None = None
    vector: bool = False
    angle: Literal["acute", "turn", "signed"] | None = None

    @property
    def sides(self) -> None:
        """None: it is no equation."""

    @property
    def subject(self) -> None:
        """None: it is no chain."""

    @cached_property
    def trees(self) -> tuple[Expression, ...]:
        """The letter, and what it stands for."""
        return Letter(self.letter), self.quantity


@dataclass(frozen=True)
class Fact:
    """What a statement gives: one relation, in force in one part (``part`` None: in all)."""

    id: str
    kind: FactKind
    relation: Relation
    part: str | None = None
    place: Place | None = None


@keeps_hash
@dataclass(frozen=True)
class Event:
    """An event of the story: who meets whom. ``wall`` tells that the second body is a wall."""

    number: int
    kind: EventKind
    bodies: tuple[str, ...]
    wall: bool = False


@keeps_hash
@dataclass(frozen=True)
class Move:
    """How a line is made.

    ``record`` names the principle, definition or identity, ``event`` and ``bodies`` what it is
    used for, ``eliminated`` the letter or quantity that goes when two lines are combined.
    """

    id: MoveId
    record: str | None = None
    event: int | None = None
    bodies: tuple[str, ...] = ()
    eliminated: str | None = None


@dataclass(frozen=True)
class Line:
    """A line of a working; ``item`` is the one on the way to which it stands."""

    number: int
    item: str | None
    move: Move
    premises: tuple[Ref, ...]
    relation: Relation | Meaning
    marks: Marks = ()
    shown: Showing = "line"


@dataclass(frozen=True)
class ItemEnd:
    """Where a working reaches an item: its last line, and the answer as printed.

    ``shown`` tells that the statement prints the result. There are several ends of an item that
    has several solutions, one for each ``case``.
    """

    item: str
    line: int
    answer: Relation
    part: str | None = None
    shown: bool = False
    case: int | None = None


NoteKind = Literal[
    "impossible",
    "unbounded",
    "contradiction",
    "missing",
    "refuted",
    "undecided",
    "unwritten",
    "unsolved",
    "standing",
    "agreeing",
]


@dataclass(frozen=True)
class Note:
    """What stands in place of an answer, or of a proof, and why.

    ``premises`` are lines, facts and what is known of letters: they cannot all hold. Of a claim
    that is refuted they cannot hold together with the ``claim``, where letters have the values in
    ``instance``; ``sides`` are what its sides are there. ``reason`` is in the solver's words.
    ``place`` counts the items of the question from 0, in the order asked. One that is
    ``unwritten`` has its answer as the reason, and the last lines that stand. One that is
    ``standing`` says the answer again, as its ``claim``: an earlier part came to it already.
    One that is ``unbounded`` has no extremum, which the lines of its premises show; one that is
    ``agreeing`` stands beside the answer: a given fact that no answer needs says what
    its lines come to. One that is ``unsolved`` was not worked out, which says nothing of impacts.
    """

    item: str
    kind: NoteKind
    place: int
    part: str | None = None
    reason: str = ""
    premises: tuple[Ref, ...] = ()
    claim: Relation | None = None
    instance: tuple[Link, ...] = ()
    sides: tuple[Link, ...] = ()
    marks: Marks = ()

    @property
    def lines(self) -> tuple[int, ...]:
        """The lines among its premises."""
        return tuple(premise for premise in self.premises if isinstance(premise, int))

    def renumbered(self, numbers: Mapping[int, int]) -> Note:
        """The same note, which names lines by their new numbers."""
        premises = tuple(numbers[e] if isinstance(e, int) else e for e in self.premises)
        return replace(self, premises=premises)


@dataclass(frozen=True)
class Case:
    """One of several solutions: an option of a line of alternatives, and the lines under it."""

    number: int
    line: int
    option: int
    lines: tuple[int, ...]


@dataclass(frozen=True)
class Route:
    """Another way to an item, by the principles that it would use."""

    item: str
    moves: tuple[Move, ...]


@dataclass(frozen=True)
class Derivation:
    """A working: the facts of the statement, the events of its story, and lines.

    Every item has an end in ``items``, or else a note.
    """

    facts: tuple[Fact, ...]
    lines: tuple[Line, ...]
    items: tuple[ItemEnd, ...]
    events: tuple[Event, ...] = ()
    cases: tuple[Case, ...] = ()
    others: tuple[Route, ...] = ()
    notes: tuple[Note, ...] = ()

    @cached_property
    def fact(self) -> Callable[[Ref | None], Fact | None]:
        """The fact with an id; None where there is none, or where a line is cited."""
        return self._facts.get  # asked for so often that a call is saved

    @cached_property
    def line(self) -> Callable[[Ref | None], Line | None]:
        """The line with a number; None where there is none, or where no line is cited."""
        return self._numbered.get

    def cited(self, ref: Ref) -> Fact | Line | None:
        """The fact or the line that is cited; None where it is what is known of a letter."""
        return self.fact(ref) or self.line(ref)

    def facts_in(self, refs: Iterable[Ref]) -> list[Fact]:
        """The facts among what is cited."""
        return [fact for ref in refs if (fact := self.fact(ref)) is not None]

    def lines_in(self, refs: Iterable[Ref]) -> list[Line]:
        """The lines among what is cited."""
        return [line for ref in refs if (line := self.line(ref)) is not None]

    # The first of several that have the same name, or number.
    @cached_property
    def _facts(self) -> Mapping[Ref | None, Fact]:
        return {fact.id: fact for fact in reversed(self.facts)}

    @cached_property
    def _numbered(self) -> Mapping[Ref | None, Line]:
        return {line.number: line for line in reversed(self.lines)}

    @cached_property
    def asked(self) -> Mapping[str, str | None]:
        """The part of each item, in the order asked."""
        parts = {item.item: item.part for item in self.items}
        order = list(parts)
        for note in sorted(self.notes, key=lambda note: note.place):
            if note.item not in parts:
                parts[note.item] = note.part
                order.insert(note.place, note.item)
        return {item: parts[item] for item in order}

    @cached_property
    def held(self) -> frozenset[int]:
        """The lines to which ends of items, cases and notes refer: none of them can be left out."""
        return frozenset(
            (
                *(end.line for end in self.items),
                *(number for case in self.cases for number in (case.line, *case.lines)),
                *(number for note in self.notes for number in note.lines),
            )
        )

    @cached_property
    def meanings(self) -> Mapping[str, Meaning]:
        """The letters that the working introduces."""
        return {
            line.relation.letter: line.relation
            for line in self.lines
            if isinstance(line.relation, Meaning)
        }


def of_part(derivation: Derivation, part: str | None) -> Derivation:
    """What one part needs of a working: its own lines, and the earlier ones on which they rest.

    Of the facts those of other parts are left out, but for those that these lines cite.
    """
    parts = derivation.asked
    lines = {line.number: line for line in derivation.lines}
    needed: set[int] = set()
    open_ = [line.number for line in derivation.lines if parts.get(line.item or "") == part]
    while open_:
        number = open_.pop()
        if number in needed or number not in lines:
            continue
        needed.add(number)
        open_ += [ref for ref in lines[number].premises if isinstance(ref, int)]
    own = tuple(line for line in derivation.lines if line.number in needed)
    cited = {ref for line in own for ref in line.premises}
    return Derivation(
        tuple(e for e in derivation.facts if e.part in (None, part) or e.id in cited),
        own,
        tuple(item for item in derivation.items if item.line in needed),
        derivation.events,
        tuple(
            Case(e.number, e.line, e.option, tuple(n for n in e.lines if n in needed))
            for e in derivation.cases
            if e.line in needed
        ),
        tuple(other for other in derivation.others if parts.get(other.item) == part),
        tuple(note for note in derivation.notes if note.part == part),
    )


def whole_of(links: tuple[Link, ...]) -> Link | None:
    """A chain as one link, from its first side to its last; None where links are no chain.

    Behind the first, every link is an equation that begins where the one before it ends: so
    ``a < b = c`` says that a < c.
    """
    first, *rest = links
    if any(a.right != b.left or b.sign != "=" for a, b in pairwise(links)):
        return None
    return Link(first.left, first.sign, rest[-1].right) if rest else first


def is_same_identity(line: Line, other: Line) -> bool:
    """Whether two lines of an item apply one identity to equations, and neither uses the other."""
    return (
        line.move.id == other.move.id == "identity"
        and line.move.record == other.move.record
        and line.item == other.item
        and line.number not in other.premises
        and other.number not in line.premises
    )


def numbers_in(refs: Iterable[Ref]) -> list[int]:
    """The numbers of the lines among what is cited."""
    return [ref for ref in refs if isinstance(ref, int)]


def citing(premises: Iterable[Ref], others: Mapping[Ref, Ref]) -> tuple[Ref, ...]:
    """Premises with some of them replaced by others, none of them twice."""
    return tuple(dict.fromkeys(others.get(ref, ref) for ref in premises))


def turned(link: Link) -> Link:
    """A link with its sides exchanged."""
    sign: Sign = FLIPPED.get(link.sign, link.sign)
    return Link(link.right, sign, link.left)


def equality(left: Expression, right: Expression) -> Relation:
    """``left = right`` as a relation."""
    return Relation(((Link(left, "=", right),),))


# --- where facts are in force --------------------------------------------------------------------


def scopes_of(facts: Iterable[Fact]) -> dict[Ref, frozenset[str | None] | None]:
    """The parts in which each fact is given, by its id; None where it is given in all.

    What is given in several parts in the same words holds in each of them.
    """
    own = tuple(facts)
    parts: dict[Relation, set[str | None]] = {}
    for fact in own:
        parts.setdefault(fact.relation, set()).add(fact.part)
    return {
        fact.id: None if None in parts[fact.relation] else frozenset(parts[fact.relation])
        for fact in own
    }


def common_scope(
    scopes: Iterable[frozenset[str | None] | None],
) -> frozenset[str | None] | None:
    """The parts in which all of some premises hold; None where they hold in all parts."""
    common: frozenset[str | None] | None = None
    for scope in scopes:
        if scope is not None:
            common = scope if common is None else common & scope
    return common
