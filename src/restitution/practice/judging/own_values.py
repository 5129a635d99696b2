"""The values that a student goes on with, right or wrong, and the worlds in which they hold."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import Protocol, overload

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import VariantAt
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Quantity,
    is_binary,
    is_quantity,
    letters,
)
from restitution.practice.judgement import Mistake, Use
from restitution.practice.judging.angles import INVERSE
from restitution.practice.judging.claimed import is_given
from restitution.practice.judging.deduction import is_identity
from restitution.practice.judging.entries import (
    Entry,
    Meanings,
    is_numeric,
    names_of,
)
from restitution.practice.judging.explained import Explained, Stated
from restitution.practice.judging.holding import Holding
from restitution.practice.judging.judged_link import (
    JudgedLink,
    Question,
)
from restitution.practice.judging.other_forms import (
    kind_of,
    label_in,
)
from restitution.practice.judging.own_numbers import OwnNumbers
from restitution.practice.judging.vector_momentum import (
    are_vectors,
    is_plain_vector,
    momentum_of,
    spheres_that_meet,
    velocity_after,
    with_momentum_kept,
)
from restitution.practice.judging.written_laws import with_written_law
from restitution.practice.letters.candidates import Candidate
from restitution.practice.letters.slots import same_size
from restitution.practice.reading.phrase_names import is_phrase, is_vague
from restitution.practice.reading.relations import worked_out
from restitution.practice.script import Claim, Link, ScriptLine
from restitution.practice.worlds.principles import uses_of
from restitution.practice.worlds.student import facts_of, student_world
from restitution.practice.worlds.turning import with_line_at
from restitution.practice.worlds.world import World
from restitution.problem import Impact, Problem

_TURNS = ("deflection-difference", "deflection-is-after")
ALTERED = 3
"""So many of the altered laws that explain a mistake are looked into."""
# Words that say of a value that it is the last one.
_OF_THE_END = ("after", "afterwards", "final", "new")


class _InTurn(Sequence[World]):
    """Worlds that are made when they are asked for, and kept: most lines need the first alone."""

    def __init__(self, worlds: Iterator[World]) -> None:
        self._rest, self._made = worlds, list[World]()

    def __iter__(self) -> Iterator[World]:
        place = 0
        while place < len(self._made) or self._more():
            yield self._made[place]
            place += 1

    def __len__(self) -> int:
        while self._more():
            pass
        return len(self._made)

    @overload
    def __getitem__(self, place: int) -> World: ...
    @overload
    def __getitem__(self, place: slice) -> Sequence[World]: ...
    def __getitem__(self, place: int | slice) -> World | Sequence[World]:
        return tuple(self)[place]

    def _more(self) -> bool:
        world = next(self._rest, None)
        if world is not None:
            self._made.append(world)
        return world is not None


class Naming(Protocol):
    """The interface of what names mistakes."""

    def explained(self, entry: Entry, judge: OwnValues) -> Explained:
        """What explains a claim that is false."""

    def altered(self, base: World, variant: VariantAt, unknown: frozenset[str]) -> World | None:
        """The world of an altered law, all else being right."""

    def candidates(self, world: World) -> Sequence[Candidate]:
        """The quantities that a letter may mean."""

    def named(self, explained: Explained, stated: Stated, confirmed: frozenset[str]) -> Mistake:
        """The mistake by its name."""


class OwnValues(Holding):
    """What the lines of a script so far state, and the student's own values by them.

    Without ``names`` nothing is asked of mistakes but that they are some.
    """

    def __init__(
        self,
        worlds: Sequence[World],
        meanings: Mapping[int, Meanings],
        naming: Naming,
        question: Question,
        *,
        names: bool = True,
    ) -> None:
        super().__init__(worlds, meanings, question)
        self.naming = naming
        self._names = names
        self._explained: dict[int, Explained] = {}
        self._stated: set[tuple[str, int | None, tuple[str, ...]]] = set()
        self._own: tuple[int, Sequence[World]] = (-1, ())
        self._own_numbers = OwnNumbers(_factors_of(self._base.problem), self._base.letters.keys())
        self._known_uses: dict[tuple[Claim, int, bool], tuple[Use, ...]] = {}

    @property
    def wrong(self) -> bool:
        """Whether a line so far is false."""
        return bool(self._own_numbers) or any(entry.wrong for entry in self.entries)

    def suspected(self) -> frozenset[str]:
        """The ids of the altered laws of which false lines above are instances."""
        return frozenset(variant.id for one in self._explained.values() for variant in one.variants)

    def stated(self) -> Stated:
        """The laws that a line above states rightly, each with its event and its bodies."""
        return frozenset(self._stated)

    # --- worlds -------------------------------------------------------------------------------

    def students(self) -> Sequence[World]:
        """The worlds in which the lines so far hold, as far as they can hold together."""
        if self._own[0] != len(self.entries):
            worlds = self._worlds_of_student(tuple(self.entries))
            self._own = len(self.entries), _InTurn(worlds)
        return self._own[1]

    def _is_of_asked_angle(self, line: ScriptLine, link: Link) -> bool:
        """Whether a line below a mistake gives *the angle*, or that *after*, and one is asked.

        Another angle may have its value.
        """
        left, base = link.readings[0].left, self._base
        if not isinstance(left, Letter) or not self.wrong:
            return False
        kind = " ".join(word for word in left.name.split() if word not in _OF_THE_END)
        if not is_phrase(left.name) or not kind or not is_vague(kind):
            return False
        meant = self.meanings(line.number).get(left.name)
        asked = self.question.wanted.trees(base.problem, base.part)
        return meant is not None and meant in asked and kind_of(meant) in ANGLES

    def students_without(self, names: Collection[str]) -> Iterator[World]:
        """The worlds of the lines that have none of some letters: their meanings are open."""
        known = [entry for entry in self.entries if names_of(entry.claim).isdisjoint(names)]
        if len(known) < len(self.entries):
            yield from self._worlds_of_student(known)

    def _worlds_of_student(self, entries: Sequence[Entry]) -> Iterator[World]:
        # Who puts two angles together wrongly has no other motion by that.
        first = next((n for n, x in enumerate(entries) if x.right), len(entries))
        moving = [
            x
            for n, x in enumerate(entries)
            if n < first or not (x.wrong and self._is_deflection(x))
        ]
        entries = moving or list(entries)
        broken = self._broken(entries)
        facts = any(fact.law for fact in facts_of(self._base))
        for latest, laws_first in ((True, False), (False, False), (True, True)):
            if laws_first and not facts:
                continue
            world = student_world(
                self._base,
                entries,
                self.question.unknown,
                latest=latest,
                broken=() if laws_first else broken,
                laws_first=laws_first,
            )
            if world is not None:
                yield world
        # A quantity wrongly worked out need not be what its components make of it.
        own = [entry for entry in entries if not (entry.wrong and label_in(entry.claim.left))]
        if own and len(own) < len(entries):
            world = student_world(self._base, own, self.question.unknown, laws_first=facts)
            if world is not None:
                yield world
        turned = self._with_own_line(entries)
        if turned is not None:
            world = student_world(turned, entries, self.question.unknown, broken=broken)
            if world is not None:
                yield world
        own = self._without_sources(entries) if not broken else []
        if own:
            world = student_world(self._base, own, self.question.unknown, laws_first=facts)
            if world is not None:
                yield world

    def _is_deflection(self, entry: Entry) -> bool:
        """Whether a claim gives an angle of deflection, of which the question tells nothing."""
        left = entry.claim.left
        explained = self._explained.get(entry.number)
        if explained is None or not any(x.mistake in _TURNS for x in explained.variants):
            return False
        meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
        turned = is_quantity(meant, "deflection")
        return turned and not is_given("deflection", self._base.problem)

    def _with_own_line(self, entries: Sequence[Entry]) -> World | None:
        """The true world with the line of centres at the student's own angle, if that is wrong.

        What he goes on with are components along that line and across it.
        """
        if len(self._base.lines) != 1:
            return None
        (number,) = self._base.lines
        for entry in entries:
            own = None if entry.right else _angle_of_line(entry)
            if own is None:
                continue
            meant, value = own
            try:
                true, angle = self._base.scalar(meant), self._base.scalar(value, entry.meanings)
            except RestitutionError:
                continue
            for sign in (1, -1):
                world = with_line_at(self._base, number, sign * (angle - true))
                if np.allclose(world.scalar(meant), angle):
                    return world
        return None

    def _without_sources(self, entries: Sequence[Entry]) -> list[Entry]:
        """The lines without those from which a slip was worked out: they do not hold with it.

        None where there are no such lines.
        """
        sources = {
            place
            for place, (above, entry) in enumerate(pairwise(entries))
            if above.right and entry.wrong
        }
        own = [entry for place, entry in enumerate(entries) if place not in sources]
        return own if len(own) < len(entries) else []

    def _broken(self, entries: Sequence[Entry]) -> frozenset[tuple[str, int | None]]:
        """The laws in whose place the student has an altered one."""
        return frozenset(
            (use.principle, use.event)
            for entry in entries
            if entry.wrong
            for use in self.uses_of_entry(entry)
            if use.altered is not None
        )

    def _forgone(self) -> frozenset[tuple[str, int | None]]:
        """The laws that a mistake above stands in place of, as far as mistakes have names."""
        if not self._names or not self.wrong:
            return frozenset()
        named = (
            (law.law, variant.event.number)
            for mistake in self._explained.values()
            for variant in mistake.variants[:ALTERED]
            for law in variant.laws
        )
        return self._broken(self.entries).union(named)

    def altered(self, variant: VariantAt) -> World | None:
        """The world of an altered law, all else being right."""
        return self.naming.altered(self._base, variant, self.question.unknown)

    # --- what lines state ---------------------------------------------------------------------

    def _remember(self, line: ScriptLine, links: Sequence[JudgedLink]) -> None:
        start: Expression | None = None
        last: Expression | None = None
        first, untrue = len(self.entries), False
        for link, judged in zip(line.links, links, strict=True):
            claim = judged.claim
            if start is None or claim.left != last:
                start, first, untrue = claim.left, len(self.entries), False
            last = claim.right
            if untrue and judged.verdict == "true":
                self._note_number(line, judged, start)  # β = 60 - 10.9 = 49.1
            elif judged.verdict == "true":
                self._note_worked(line, judged)
            untrue = untrue or judged.verdict in ("false", "follows")
            if judged.verdict not in ("true", "follows", "false", "unsupported"):
                continue
            if link.supposed and judged.verdict != "false":
                continue  # e = 0: I = 2mu holds in that case alone
            if judged.verdict in ("false", "follows"):
                self._note_number(line, judged, start)
            worked = is_numeric(claim.left) and is_numeric(claim.right)
            if judged.verdict == "false" and not letters(start) <= self._base.letters.keys():
                worked = worked or (claim.left != start and self._is_known(claim))
            if not worked:
                self.entries.append(self._entry(line, link, judged))
            elif judged.verdict == "false" and not is_numeric(start):
                # A chain that ends in another number gives that number to what it begins with.
                del self.entries[first:]
                whole = replace(judged, claim=replace(claim, left=start))
                self.entries.append(self._entry(line, link, whole))

    def _is_known(self, claim: Claim) -> bool:
        """Whether a claim has no letters but those of the question that are data."""
        own = letters(claim.left) | letters(claim.right)
        return own <= self._base.letters.keys() and own.isdisjoint(self.question.unknown)

    def _note_number(self, line: ScriptLine, judged: JudgedLink, start: Expression) -> None:
        """Keep a number that is wrong, with what is right in its place."""
        claim = judged.right or judged.claim
        named = isinstance(start, Letter | Quantity | Apply)
        if claim.sign == "=" and (named or is_numeric(start) or self._is_of_data(start, line)):
            meant = start if named else claim.left
            meanings = self.meanings(line.number)
            others: tuple[Expression, ...] = ()
            if isinstance(meant, Letter) and is_phrase(meant.name):
                others = self._meanings_of(meant.name, line.scope.event)
            self._own_numbers.note(judged.claim.right, meant, meanings, line.number, others)

    def _note_worked(self, line: ScriptLine, judged: JudgedLink) -> None:
        """Keep what is worked out of a wrong number, rightly: ``u cos 38.7 = 0.781u``."""
        claim = judged.claim
        if claim.sign != "=" or claim.others or not self._own_numbers:
            return
        if isinstance(claim.left, Letter | Quantity) or not self._is_known(claim):
            return
        for own, _ in self._own_numbers.put_back(claim):
            if own.right == claim.right and own.left != claim.left:
                self._own_numbers.note(
                    claim.right, own.left, self.meanings(line.number), line.number
                )
                return

    def _is_of_data(self, tree: Expression, line: ScriptLine) -> bool:
        """Whether a product has letters of what the question fixes alone: ``u cos θ``."""
        if not is_binary(tree, "*", "/"):
            return False
        if letters(tree) <= self._base.letters.keys() - self.question.unknown:
            return True  # u cos 30
        meanings = self.meanings(line.number)
        own = [
            meanings[name] for name in letters(tree) - self._base.letters.keys() if name in meanings
        ]
        known = letters(tree) <= self._base.letters.keys() | meanings.keys()
        return known and bool(own) and all(self._is_fixed(tree) for tree in own)

    def _is_fixed(self, meant: Expression) -> bool:
        """Whether a quantity is the same in the student's worlds as in the true one."""
        try:
            true = self._base.value(meant)
            return all(same_size(true, world.value(meant)) for world in self.students())
        except RestitutionError:
            return False

    def _by_momentum_of_vectors(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line of vectors in which momentum is kept, with his own velocity of one sphere.

        The components by which he came to that velocity need not agree with it.
        """
        meanings = self.meanings(line.number)
        for event, first, second in spheres_that_meet(self._base) if self.wrong else ():
            for body, other in ((first, second), (second, first)):
                own = self._own_value(velocity_after(body, event))
                if own is None or own.right or own.claim.others:
                    continue
                world = with_momentum_kept(self._base, event, (body, other), own)
                if world is None:
                    continue
                for claim in link.readings:
                    if not are_vectors(claim, world, meanings):
                        continue
                    grade = self.accuracy(claim, world, line, link)
                    if grade is not None:
                        law = (
                            None
                            if is_plain_vector(claim.right)
                            else momentum_of(event, body, other)
                        )
                        return JudgedLink("follows", claim, grade, (own.number,), right=law)
        return None

    def _own_value(self, quantity: Expression) -> Entry | None:
        """The last line that gives a quantity a value."""
        for entry in reversed(self.entries):
            left = entry.claim.left
            meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
            if meant == quantity and entry.claim.sign == "=":
                return entry
        return None

    # --- laws ---------------------------------------------------------------------------------

    def uses_of_entry(self, entry: Entry) -> tuple[Use, ...]:
        """The laws of which an entry is an instance; altered ones where it is false."""
        key = entry.claim, entry.number, entry.wrong
        if key not in self._known_uses:
            self._known_uses[key] = self._first_uses(entry)
        return self._known_uses[key]

    def _uses(
        self, line: ScriptLine, links: Sequence[JudgedLink]
    ) -> tuple[tuple[Use, ...], tuple[Use, ...]]:
        """The laws that a line uses, and those that its relations state, one each at most."""
        uses: dict[Use, None] = {}
        stated: dict[Use, None] = {}
        for link, judged in zip(line.links, links, strict=True):
            if judged.verdict in ("true", "follows", "false", "unsupported"):
                entry = self._entry(line, link, judged)
                if judged.right is not None:  # of a law, with wrong numbers in it
                    entry = replace(entry, claim=judged.right, right=True)
                own = self.uses_of_entry(entry)
                uses.update(dict.fromkeys(own))
                if all(use.principle != "value" for use in own):
                    stated.update(dict.fromkeys(own[:1]))
        if len(uses) > 1:
            uses.pop(Use("arithmetic"), None)
        return tuple(uses), tuple(stated)

    def _uses_before(
        self, line: ScriptLine, links: Sequence[JudgedLink], place: int
    ) -> tuple[Use, ...]:
        """The laws of the relations before the one that fails."""
        above = links[:place]
        if not self._names or not above or any(link.verdict != "true" for link in above):
            return ()
        return self._uses(replace(line, links=line.links[:place]), above)[0]

    def _first_uses(self, entry: Entry) -> tuple[Use, ...]:
        if is_identity(entry, self._base):
            return (Use("arithmetic"),)
        students = () if entry.right or entry.wrong else self.students()
        for world in (self._base, *students):
            try:
                uses = uses_of(
                    entry.claim,
                    world,
                    entry.meanings,
                    entry.decimals,
                    entry.scope,
                    altered=not entry.right,
                )
            except RestitutionError:
                continue
            if uses:
                return uses if entry.wrong else with_written_law(uses, entry, world)
        return ()


def _factors_of(problem: Problem) -> Iterator[Fraction]:
    """The masses and coefficients of restitution that a statement gives in numbers."""
    masses = [sphere.mass for sphere in problem.spheres]
    coefficients = [event.e for event in problem.events if isinstance(event, Impact)]
    for tree in filter(None, (*masses, *coefficients)):
        if (value := worked_out(tree)) is not None:
            yield value


def _angle_of_line(entry: Entry) -> tuple[Expression, Expression] | None:
    """An angle to the line of centres that an entry gives, and the value that it has there."""
    match entry.claim:
        case Claim(Apply(function, Letter(name)), "=", value) if function in INVERSE:
            value = Apply(INVERSE[function], value)
        case Claim(Letter(name), "=", value):
            pass
        case _:
            return None
    meant = entry.meanings.get(name)
    if not is_quantity(meant, "angle"):
        return None
    parts = [x for x in meant.arguments if isinstance(x, Quantity)]
    lined = any(part.kind == "line_of_centres" for part in parts)
    # A velocity after an impact has its angle by more than by the line.
    later = any(part.kind == "velocity" and part.stage != 0 for part in parts)
    return (meant, value) if lined and not later else None
