"""An answer in numbers of which the working does not say what it is."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import product

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    COMPONENTS,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.practice.judgement import JudgedLine
from restitution.practice.judging.entries import Entry, is_numeric, sources_of
from restitution.practice.judging.explained import Explained
from restitution.practice.judging.journeys import Journeys
from restitution.practice.judging.judged_link import JudgedLink
from restitution.practice.judging.plain_impulses import is_change_of_momentum
from restitution.practice.judging.solved_values import is_solved_from
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Claim, Link, ScriptLine
from restitution.practice.worlds.agreement import agrees

_CONSTANT = 1e-9
_SAME = 1e-6
_TWO = Number(Fraction(2))


class Unlabelled(Journeys):
    """What the last numbers of a working are, where it ends without a name for them."""

    def _at_a_later_moment(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A speed, or an angle, that is true of the motion before an impact and follows after it.

        Who has left a velocity as it was does not speak of the one before.
        """
        claim = link.readings[0]
        label = claim.left
        if not self.wrong or not isinstance(label, Letter) or not is_phrase(label.name):
            return None
        own = self.meanings(line.number).get(label.name)
        if own is None or not is_quantity(own, "speed", "angle"):
            return None
        for tree in self._meanings_of(label.name, line.scope.event):
            if not is_quantity(tree, own.kind) or _stage_of(tree) <= _stage_of(own):
                continue
            other = replace(claim, left=tree)
            grade = self._best_accuracy(other, self.students(), line, link)
            if grade is not None:
                sources = sources_of(claim, self.entries)
                return JudgedLink("follows", other, grade, sources, meant=((label.name, tree),))
        return None

    def _explained_otherwise(
        self, entry: Entry, known: Explained, before: Sequence[Entry]
    ) -> Explained | None:
        """What explains an energy in words as one at another moment: ``KE before = 0.5 × 100``.

        A value that the equation ``before`` it on its line decides is solved wrongly.
        """
        if before and is_solved_from(entry, before[-1], self._base):
            return replace(known, variants=(), plain=None)
        left = entry.claim.left
        if not known.is_empty or not (isinstance(left, Letter) and is_phrase(left.name)):
            return None
        own = entry.meanings.get(left.name)
        moments = self._meanings_of(left.name, entry.scope.event)
        for tree in moments if is_quantity(own, "energy") else ():
            if tree != own and is_quantity(tree, "energy"):
                moved = replace(entry, claim=replace(entry.claim, left=tree))
                other = self.naming.explained(moved, self)
                if not other.is_empty:
                    return other
        return None

    def _ends_in_numbers(
        self, lines: Sequence[JudgedLine]
    ) -> Iterator[tuple[ScriptLine, Link, int]]:
        """The lines whose numbers may be an answer that is not true, as relations.

        Beside each is the last line that goes on from it. None where another line answers, where
        a line is not true, and where the number is that of anything in the story. That they have a
        mistake with a name is still to be seen.
        """
        sound = all(line.verdict in ("true", "remark") for line in lines)
        if not lines or not sound or self.question.extreme:
            return
        answered = {item for entry in self.entries for item in self._support.answered_by(entry)}
        left = [item for item in self.question.wanted.asked if item not in answered]
        if len(left) == 1 and (end := self._as_answer(*left[0], lines[-1].line)) is not None:
            link, value = end
            if not any(self._is_worth(x, value, link) for x in self._known_of_kind(left[0][0])):
                working = (line.line for line in lines if self._works_out(line.line, value))
                first = next(working, None)
                if first is not None:
                    yield first, link, lines[-1].line.number
        for (tree, now), line in product(left, reversed(lines)):
            if (end := self._as_answer(tree, now, line.line)) is not None:
                link, value = end
                if is_change_of_momentum(tree, value, self._base):
                    yield line.line, link, line.line.number

    def _as_answer(
        self, tree: Expression, now: object, line: ScriptLine
    ) -> tuple[Link, Expression] | None:
        """The numbers of a line as the value of what is asked, if that is not true."""
        value = self._value_of(line)
        if value is None or now != self._base.now(line.scope):
            return None
        decimals = line.links[-1].decimals if line.links else ()
        link = Link((Claim(tree, "=", value),), 1, 1, decimals)
        if not self._is_multiple(value, tree) or self._holds(link, line, self.worlds) is not None:
            return None
        return link, value

    def _without_title(self, line: ScriptLine, links: Sequence[JudgedLink]) -> ScriptLine | None:
        """A line without the words before an equation, if these only announce it.

        In ``perpendicular: 1 - 4e = 0`` it is not a component that is zero.
        """
        if len(links) < 2 or links[0].verdict != "false" or ":" not in line.text:
            return None
        title, equation = (link.readings[0] for link in line.links[:2])
        label = title.left
        if not isinstance(label, Letter) or not is_phrase(label.name):
            return None
        unknown = (letters(equation.left) | letters(equation.right)) & self.question.unknown
        if title.right != equation.left or links[1].verdict != "true" or not unknown:
            return None
        return replace(line, links=line.links[1:])

    def _known_of_kind(self, tree: Expression) -> Iterator[Expression]:
        """What numbers on the way to an answer may be: of an energy, energies and parts of them."""
        known = [candidate.quantity for candidate in self.naming.candidates(self._base)]
        if not _is_of_energy(tree):
            yield from known
            return
        yield from filter(_is_of_energy, known)
        bodies = tuple(self._base.start)
        for number, kind in product(self._base.lines, COMPONENTS):
            axis = Quantity("line_of_centres", (), number)
            for names in {*((name,) for name in bodies), bodies}:
                before, after = (
                    _energy(names, kind, axis, stage) for stage in (number - 1, number)
                )
                yield from (before, after, Binary("-", before, after))

    def _is_multiple(self, value: Expression, tree: Expression) -> bool:
        """Whether a value is a multiple of a quantity, by one number: 12mu² of 4mu²."""
        try:
            with np.errstate(all="ignore"):
                ratio = self._base.spread(self._base.scalar(value) / self._base.scalar(tree))
        except (RestitutionError, ZeroDivisionError):
            return False
        return bool(np.all(np.isfinite(ratio)) and np.ptp(ratio) < _CONSTANT * np.abs(ratio).max())

    def _is_of_statement(self, tree: Expression) -> bool:
        """Whether a side is of numbers, or of letters that the question gives."""
        own = letters(tree)
        return is_numeric(tree) or (
            own <= self._base.letters.keys() and not own & self.question.unknown
        )

    def _amounts_of(self, line: ScriptLine) -> Iterator[Expression]:
        """The sides of a line, and its values, that are of numbers or of known letters."""
        sides = (s for link in line.links for s in (link.readings[0].left, link.readings[0].right))
        yield from (tree for tree in (*sides, *line.values) if self._is_of_statement(tree))

    def _value_of(self, line: ScriptLine) -> Expression | None:
        """What a line of numbers alone, or of known letters, works out, as it stands."""
        sides = [s for link in line.links for s in (link.readings[0].left, link.readings[0].right)]
        if line.kind not in ("relations", "remark") or len(line.values) + bool(sides) != 1:
            return None
        if not all(map(self._is_of_statement, (*sides, *line.values))):
            return None
        if any(link.readings[0].sign != "=" for link in line.links):
            return None
        worked = (tree for tree in (*sides, *line.values) if isinstance(tree, Binary))
        return next(worked, None)

    def _is_worth(self, quantity: Expression, value: Expression, link: Link) -> bool:
        """Whether a number is the size of a quantity, as exactly as it is typed."""
        claims = (Claim(quantity, "=", tree) for tree in (value, Negate(value)))
        try:
            return any(agrees(claim, self._base, {}, link.decimals) for claim in claims)
        except RestitutionError:
            return False

    def _works_out(self, line: ScriptLine, value: Expression) -> bool:
        """Whether numbers of a line have a value."""
        try:
            worth = self._base.spread(self._base.scalar(value))
            return any(
                np.allclose(self._base.spread(self._base.scalar(tree)), worth, rtol=_SAME)
                for tree in self._amounts_of(line)
            )
        except RestitutionError:
            return False


def _energy(names: Sequence[str], kind: str, axis: Expression, stage: int) -> Expression:
    """The energy of spheres by their components along an axis, or across it."""

    def of_one(name: str) -> Expression:
        part = Quantity(kind, (Quantity("velocity", (Name(name),), stage), axis))
        twice = Binary("*", Quantity("mass", (Name(name),)), Binary("^", part, _TWO))
        return Binary("/", twice, _TWO)

    return reduce(lambda one, other: Binary("+", one, other), map(of_one, names))


def _is_of_energy(tree: Expression) -> bool:
    """Whether a quantity is an energy, or is worked out from one."""
    return any(isinstance(node, Quantity) and "energy" in node.kind for node in walk(tree))


def followed(lines: Sequence[JudgedLine], false: JudgedLine, last: int) -> tuple[JudgedLine, ...]:
    """The lines with one of them false, and those down to the last that go on from it."""
    number = false.line.number
    goes_on = [number < line.line.number <= last and bool(line.line.links) for line in lines]
    return tuple(
        false
        if line.line.number == number
        else replace(line, verdict="follows", sources=(number,))
        if follows
        else line
        for line, follows in zip(lines, goes_on, strict=True)
    )


def _stage_of(tree: Expression) -> int:
    """After which event a quantity is meant."""
    stages = (x.stage for x in walk(tree) if isinstance(x, Quantity) and isinstance(x.stage, int))
    return max(stages, default=0)
