"""What a line needs: premises tried with the follower, without those it can do without."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field

import sympy as sp

from restitution.explaining.data.setting import Known
from restitution.explaining.following.trials import Trial, known_of_letters, names_of, setting_of
from restitution.explaining.lines.derivation import (
    Derivation,
    Fact,
    Line,
    Meaning,
    Move,
    Note,
    Ref,
    Relation,
    Showing,
)
from restitution.explaining.lines.quotients import NotComparableError
from restitution.explaining.moves import MOST_COMPARED, number_compared
from restitution.explaining.steps.excluding import excludes, holds_anyway
from restitution.expression.tree import Apply, letters, walk
from restitution.oracle import BeyondError, Oracle
from restitution.planning.writing.desk import Desk
from restitution.planning.writing.forms import ZERO
from restitution.problem import Problem
from restitution.records import dataclass
from restitution.solving.story.letters import roles


@dataclass
class Judge:
    """Reads lines of a desk as the follower does."""

    problem: Problem
    desk: Desk
    _last: tuple[Line | None, Trial] | None = None
    _known: dict[str, Known | None] = field(default_factory=dict)
    _names: tuple[tuple[Fact, ...], Mapping[str, str]] | None = None
    _as_one: bool = False

    def __post_init__(self) -> None:
        self.facts = {fact.id: fact for fact in self.desk.facts}

    # --- reading --------------------------------------------------------------------------------

    def _trial(self) -> Trial:
        """What may be cited of the lines that stand now."""
        last = self.desk.lines[-1] if self.desk.lines else None
        if self._last is None or self._last[0] is not last:
            start = Derivation(self.desk.facts, tuple(self.desk.lines), (), self.desk.events)
            if self._names is None or self._names[0] is not self.desk.facts:
                self._names = self.desk.facts, names_of(self.desk.events, self.desk.facts)
            setting = setting_of(start, Oracle(roles(self.problem)), self._names[1])
            if self._last is not None:
                before = self._last[1].setting
                if before.meanings != setting.meanings:
                    self._known.clear()
                elif before == setting:
                    setting = before  # which keeps what it was asked for
            self._last = last, Trial(setting, self._cited, self._known_of)
        return self._last[1]

    def _cited(self, ref: Ref) -> Relation | Meaning | None:
        """What a premise says: of alternatives, the one under which the next lines stand."""
        if isinstance(ref, str):
            fact = self.facts.get(ref)
            return None if fact is None else fact.relation
        own = self.desk.line(ref).relation
        for line, option in self.desk.splits:
            if line == ref and isinstance(own, Relation):
                return Relation((own.options[option],))
        return own

    def _known_of(self, ref: str) -> Known | None:
        if ref not in self._known:
            self._known[ref] = known_of_letters(ref, self._trial().setting)
        return self._known[ref]

    def _says(self, ref: Ref) -> bool:
        """Whether there is such a premise."""
        return isinstance(ref, int) or ref in self.facts or self._known_of(ref) is not None

    def follows(self, move: Move, refs: Iterable[Ref], relation: Relation) -> bool:
        """Whether the follower accepts a line."""
        cited = tuple(refs)
        try:
            return all(map(self._says, cited)) and self._trial().follows(move, cited, relation)
        except (NotComparableError, BeyondError):
            return False

    def proves(self, refs: Sequence[Ref], relation: Relation) -> bool:
        """Whether what is cited makes a relation certain, however many premises that takes."""
        try:
            return self._trial().proves(refs, relation)
        except (NotComparableError, BeyondError):
            return False

    def excludes(self, note: Note, unknown: bool = False, *, quickly: bool = False) -> bool:
        """Whether what a note rests on cannot hold; ``unknown`` where that is not compared."""
        step = self._trial().step(Move("reject"), note.premises)
        return excludes(note, step, unknown, quickly=quickly)

    def holds_anyway(self, note: Note) -> bool:
        """Whether a fact that a note cites says only what the lines beside it come to."""
        return holds_anyway(self._trial().step(Move("put"), note.premises))

    def known(self, names: Iterable[str]) -> tuple[Ref, ...]:
        """What may be cited of the range of letters."""
        bounds = (ref for name in sorted(names) for ref in self.bounds(name))
        return tuple(ref for ref in bounds if self._says(ref))

    def _right(self, move: Move, refs: Sequence[Ref], relation: Relation) -> bool:
        if move.id in _BY_ORACLE:
            return self.proves(refs, relation)
        return self.follows(move, refs, relation)

    def needed(
        self,
        move: Move,
        pool: Iterable[Ref],
        relation: Relation,
        sure: Iterable[Ref] = (),
    ) -> tuple[Ref, ...] | None:
        """Premises of which a line needs every one; None where it does not follow from all.

        Of the others, those that are named last are left out first. Lines that are ``sure`` are
        not tried one by one, and where they are enough nothing else is tried.
        """
        refs = tuple(ref for ref in dict.fromkeys(pool) if self._says(ref))
        certain = {ref for ref in sure if not self._is_spare(ref)}
        if not self._right(move, refs, relation):
            return None
        doubted = [ref for ref in reversed(refs) if ref not in certain]
        own = self._trial().needed(move, refs, relation, doubted, self._right)
        if move.id in _BY_ORACLE and self._compared(own) > MOST_COMPARED:
            return None
        return own

    def enough(
        self,
        move: Move,
        own: Iterable[Ref],
        relation: Relation,
        others: Iterable[Ref] = (),
    ) -> tuple[Ref, ...] | None:
        """Premises of its own with which a line follows, and as few of some others as it takes.

        None where it does not follow from all of them.
        """
        first = tuple(dict.fromkeys(own))
        if self.follows(move, first, relation):
            return first
        return self.needed(move, (*first, *others), relation, first)

    def _is_spare(self, ref: Ref) -> bool:
        """Whether a premise may be one too many wherever it is named.

        What is known of letters may be; and a line that says that something is zero, of which no
        factor is needed.
        """
        if isinstance(ref, str):
            return True
        own = self.desk.line(ref).relation
        return isinstance(own, Relation) and own.options[0][-1].right == ZERO

    def standing(self, relation: Relation) -> int | None:
        """The line in force that says a relation, if there is one."""
        lines = (line for line in self.desk.lines if line.relation == relation)
        return next((line.number for line in lines if self.desk.holds(line.number)), None)

    @contextlib.contextmanager
    def ranges_as_one(self) -> Iterator[None]:
        """Where both ends of the range of a letter count as one premise: 0 ≤ e < 1.

        So a line that is a difference, or a bound of a quotient, may rest on one angle besides.
        """
        self._as_one = True
        try:
            yield
        finally:
            self._as_one = False

    def _compared(self, refs: Sequence[Ref]) -> int:
        """How many relations are compared: letters and the direction of an axis are none."""
        step = self._trial().step(
            Move("compare"), [ref for ref in refs if not str(ref).startswith("axis ")]
        )
        relations = [*(e.relation for e in step.cited), *(e.relation for e in step.known)]
        plain = [relation for relation in relations if isinstance(relation, Relation)]
        return number_compared(plain) if self._as_one else len(plain)

    def write(
        self,
        moves: Iterable[Move],
        pool: Iterable[Ref],
        relation: Relation,
        sure: Iterable[Ref] = (),
        shown: Showing = "line",
    ) -> int | None:
        """Writes a line by the first move that makes it of what is cited; None without one.

        One that stands already is not judged again.
        """
        standing = self.standing(relation)
        if standing is not None:
            return standing
        refs = list(pool)
        for move in moves:
            own = self.needed(move, refs, relation, sure)
            if own is not None:
                return self.desk.write(move, own, relation, shown)
        return None

    # --- bounds of letters ----------------------------------------------------------------------

    def ranges_given(self, name: str) -> list[Ref]:
        """The inequalities in force that are given of a letter, or that a form of a range asks."""
        return [
            fact.id
            for fact in self.desk.facts
            if fact.kind in ("range", "case")
            and self.desk.holds(fact.id)
            and fact.id.startswith(("given", "case", "path"))
            and name in _letters(fact.relation)
        ]

    def _is_of_a_ratio(self, ref: Ref) -> bool:
        """Whether a fact bounds a ratio of an angle."""
        return any(
            isinstance(node, Apply)
            for links in self.facts[str(ref)].relation.options
            for link in links
            for side in (link.left, link.right)
            for node in walk(side)
        )

    def bounds(self, name: str) -> tuple[Ref, ...]:
        """The bounds of a letter as premises say them: ``e >= 0``, ``e <= 1``, ``acute: alpha``."""
        role = roles(self.problem).get(name)
        if role is None:
            return tuple(
                f"acute: {name}"
                for line in self.desk.lines
                if isinstance(line.relation, Meaning)
                and line.relation.letter == name
                and line.relation.angle == "acute"
            )[:1]
        ranges = self.ranges_given(name)
        # What is known anyway is cited before the condition of a form.
        cases = [ref for ref in ranges if str(ref).startswith("case")]
        facts = [ref for ref in ranges if ref not in cases]
        if role.kind == "angle":
            # That it is acute goes before what is given of a ratio of it.
            ratios = [ref for ref in facts if self._is_of_a_ratio(ref)]
            facts = [ref for ref in facts if ref not in ratios]
            return (*facts, *_of_angle(name, role.low, role.high, role.closed), *ratios, *cases)
        refs: list[Ref] = []
        for end, sign, closed in (
            (role.low, ">", role.closed[0]),
            (role.high, "<", role.closed[1]),
        ):
            if end is None or (role.kind == "positive" and sign == ">" and end == 0):
                continue
            if not end.is_Rational:
                continue
            refs.append(f"{name} {sign}{'=' if closed else ''} {end}")
        return (*facts, *refs, *cases)


def _of_angle(
    name: str, low: sp.Expr | None, high: sp.Expr | None, closed: tuple[bool, bool]
) -> tuple[Ref, ...]:
    if low is None or high is None:
        return ()
    if low == 0 and high == sp.pi / 2 and not any(closed):
        return (f"acute: {name}",)
    signs = ["<=" if inside else "<" for inside in closed]
    ends = [sp.deg(value) for value in (low, high)]
    if not all(end.is_Rational for end in ends):
        return ()
    return (f"{ends[0]}° {signs[0]} {name} {signs[1]} {ends[1]}°",)


def _letters(relation: Relation) -> frozenset[str]:
    return frozenset(
        name
        for links in relation.options
        for link in links
        for side in (link.left, link.right)
        for name in letters(side)
    )


# These ask what is certain, not what a step makes.
_BY_ORACLE = ("sign", "compare")
