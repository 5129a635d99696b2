"""What a line needs: premises tried with the follower, without those it can do without."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

import sympy as sp

from restitution.explaining.algebra import NotComparableError
from restitution.explaining.derivation import Derivation, Line, Meaning, Move, Ref, Relation
from restitution.explaining.follower import known_of_letters, setting_of
from restitution.explaining.moves import MOST_COMPARED, follows
from restitution.explaining.step import Cited, Known, Setting, Step
from restitution.expression.tree import letters
from restitution.oracle import BeyondError, Oracle
from restitution.planning.forms import ZERO
from restitution.planning.scene import Scene
from restitution.solve.letters import roles


@dataclass
class Judge:
    """Reads lines of a scene as the follower does."""

    scene: Scene
    _last: tuple[Line | None, Setting] | None = None
    _known: dict[str, Known | None] = field(default_factory=dict)

    def _setting(self) -> Setting:
        desk = self.scene.desk
        last = desk.lines[-1] if desk.lines else None
        if self._last is None or self._last[0] is not last:
            start = Derivation(desk.facts, tuple(desk.lines), (), desk.events)
            self._last = last, setting_of(start, Oracle(roles(self.scene.problem)))
        return self._last[1]

    def _step(self, move: Move, refs: Sequence[Ref]) -> Step:
        setting = self._setting()
        cited: list[Cited] = []
        known: list[Known] = []
        for ref in refs:
            if isinstance(ref, int):
                cited.append(Cited(ref, self.scene.desk.line(ref).relation))
            elif ref in self.scene.facts:
                cited.append(Cited(ref, self.scene.facts[ref].relation))
            else:
                own = self._known_of(ref)
                if own is not None:
                    known.append(own)
        return Step(setting, move, tuple(cited), tuple(known))

    def _known_of(self, ref: str) -> Known | None:
        if ref not in self._known:
            self._known[ref] = known_of_letters(ref, self._setting())
        return self._known[ref]

    def follows(self, move: Move, refs: Sequence[Ref], relation: Relation) -> bool:
        """Whether the follower accepts a line."""
        try:
            return follows(self._step(move, refs), relation)
        except (NotComparableError, BeyondError):
            return False

    def proves(self, refs: Sequence[Ref], relation: Relation) -> bool:
        """Whether what is cited makes a relation certain, however many premises that takes."""
        step = self._step(Move("sign"), refs)
        try:
            return step.oracle.proves(step.formula(relation))
        except (NotComparableError, BeyondError):
            return False

    def known(self, names: Iterable[str]) -> tuple[Ref, ...]:
        """What may be cited of the range of letters."""
        return tuple(
            ref
            for name in sorted(names)
            for ref in bounds_of(self.scene, name)
            if ref in self.scene.facts or self._known_of(str(ref)) is not None
        )

    def needed(
        self,
        move: Move,
        pool: Iterable[Ref],
        relation: Relation,
        sure: Iterable[Ref] = (),
    ) -> tuple[Ref, ...] | None:
        """Premises of which a line needs every one; None where it does not follow from all.

        Lines that are ``sure`` are not tried one by one.
        """
        refs = list(dict.fromkeys(pool))
        by_oracle = move.id in ("sign", "compare")

        def right(some: Sequence[Ref]) -> bool:
            if by_oracle:
                return self.proves(some, relation)
            return self.follows(move, some, relation)

        if not right(refs):
            return None
        certain = {each for each in sure if isinstance(each, int) and not self._is_zero(each)}
        for each in tuple(refs)[::-1]:
            if each in certain:
                continue
            fewer = [ref for ref in refs if ref != each]
            if right(fewer):
                refs = fewer
        if by_oracle and self._compared(refs) > MOST_COMPARED:
            return None
        return tuple(refs)

    def _is_zero(self, ref: Ref) -> bool:
        """Whether a line says that something is zero, so that factors of it are not needed."""
        own = self.scene.desk.line(ref).relation if isinstance(ref, int) else None
        return isinstance(own, Relation) and own.options[0][-1].right == ZERO

    def standing(self, relation: Relation) -> int | None:
        """The line in force that says a relation, if there is one."""
        desk = self.scene.desk
        lines = (each for each in desk.lines if each.relation == relation)
        return next((each.number for each in lines if desk.holds(each.number)), None)

    def _compared(self, refs: Sequence[Ref]) -> int:
        return sum(
            not (isinstance(ref, int) and isinstance(self.scene.desk.line(ref).relation, Meaning))
            for ref in refs
        )

    def write(
        self,
        moves: Iterable[Move],
        pool: Iterable[Ref],
        relation: Relation,
        sure: Iterable[Ref] = (),
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
                return self.scene.desk.write(move, own, relation)
        return None


def bounds_of(scene: Scene, name: str) -> tuple[Ref, ...]:
    """The bounds of a letter as premises say them: ``e >= 0``, ``e <= 1``, ``acute: alpha``."""
    role = roles(scene.problem).get(name)
    if role is None:
        return ()
    facts: list[Ref] = [
        fact.id
        for fact in scene.desk.facts
        if fact.kind == "range"
        and scene.desk.holds(fact.id)
        and fact.id.startswith("given")
        and name in _letters(fact.relation)
    ]
    if role.kind == "angle":
        return (*facts, *_of_angle(name, role.low, role.high, role.closed))
    refs: list[Ref] = []
    for end, sign, closed in ((role.low, ">", role.closed[0]), (role.high, "<", role.closed[1])):
        if end is None or (role.kind == "positive" and sign == ">" and end == 0):
            continue
        if not end.is_Rational:
            continue
        refs.append(f"{name} {sign}{'=' if closed else ''} {end}")
    return (*facts, *refs)


def _of_angle(
    name: str, low: sp.Expr | None, high: sp.Expr | None, closed: tuple[bool, bool]
) -> tuple[Ref, ...]:
    if low is None or high is None:
        return ()
    if low == 0 and high == sp.pi / 2 and not any(closed):
        return (f"acute: {name}",)
    signs = ["<=" if each else "<" for each in closed]
    ends = [sp.deg(each) for each in (low, high)]
    if not all(each.is_Rational for each in ends):
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
