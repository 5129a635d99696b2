"""Letters that are not certain: where a line that looks false is a question about a letter.

A line that is false under the best meaning of the letters, and true or following under one that
explains the script nearly as well, is no mistake.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.expression.evaluate import Angle
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    is_binary,
    is_quantity,
    letters,
)
from restitution.practice.judgement import JudgedLine
from restitution.practice.judging.bench import Bench
from restitution.practice.judging.entries import Meanings
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.judging.verdicts import Judge
from restitution.practice.letters.candidates import is_odd
from restitution.practice.letters.interpretation import Interpretation, Interpretations
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Claim, Link, Script, ScriptLine
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.effort import ExhaustedError, effort
from restitution.practice.worlds.world import World
from restitution.records import dataclass

_RIVALS = 8
_EFFORT = 80_000
"""So many evaluations are spent on other meanings of the letters, at most."""
_SURE = 3
"""What an angle is taken for is certain with so many true lines that it stands in."""
_ROUNDED = 0.006
"""What a student's own rounding may move a product of speeds by."""
# Letters for a deflection, where one is asked.
_OF_TURN = frozenset({"d", "delta"})
_RIGHT = 1e-9
"""A sine below this is that of a multiple of two right angles."""


@dataclass(frozen=True)
class _Idle:
    """Whether a meaning explains too little: more lines are false, or all that are in doubt."""

    open: Collection[int]
    most: int

    def __call__(self, lines: Sequence[JudgedLine]) -> bool:
        false = {line.line.number for line in lines if line.verdict == "false"}
        return len(false) > self.most or false.issuperset(self.open)


class Doubts:
    """The doubts about the letters of one script before the bench."""

    def __init__(self, bench: Bench, script: Script, meanings: Interpretations) -> None:
        self.bench = bench
        self.script = script
        self.meanings = meanings
        self.taken = frozenset[str]()  # the letters that are taken for what is asked

    def _judge(
        self,
        interpretation: Interpretation,
        worlds: Sequence[World] | None = None,
        *,
        names: bool = True,
    ) -> Judge:
        table = {line.number: interpretation.trees(line.number) for line in self.script.lines}
        bench = self.bench
        return Judge(worlds or bench.worlds, table, bench.names, bench.question, names=names)

    def asked(self, lines: tuple[JudgedLine, ...], asks: set[str]) -> tuple[JudgedLine, ...]:
        """False lines that another meaning makes true are questions about a letter.

        A meaning under which more lines are false explains the script less well, and where one
        altered law explains several of them, so does one under which any is. A mistake with a name
        stands where the other meaning makes another line false. Where the meanings are too many to
        be tried, a line is a question about every letter in it that may be doubtful.
        """
        try:
            with effort(_EFFORT):
                return self._asked_by_rivals(lines, asks)
        except ExhaustedError:
            return tuple(self._open_to_doubt(line, asks) for line in lines)

    def _open_to_doubt(self, line: JudgedLine, asks: set[str]) -> JudgedLine:
        """A false line as a question, if its letters have meanings that nobody declared."""
        meanings = self.meanings.best.at(line.line.number)
        open_ = {
            name
            for name in _names_in_doubt(line)
            if name in meanings and meanings[name].by == "inferred"
        }
        if line.verdict != "false" or not open_:
            return line
        asks.update(open_)
        return replace(line, verdict="asks", mistake=None, link=None)

    def _asked_by_rivals(
        self, lines: tuple[JudgedLine, ...], asks: set[str]
    ) -> tuple[JudgedLine, ...]:
        """The lines of which another meaning is tried with the whole script."""
        tries = iter(range(_RIVALS))
        most = 0 if are_of_one_mistake(lines) else sum(line.verdict == "false" for line in lines)
        for rival in self.meanings.rivals:
            doubtful = {line.line.number: self._doubtful(rival, line) for line in lines}
            false = [line.line for line in lines if line.verdict == "false"]
            if not any(set(doubtful[line.number]) & names_in(line) for line in false):
                continue
            if next(tries, None) is None:
                break
            open_ = {line.number for line in false if set(doubtful[line.number]) & names_in(line)}
            judge_ = self._judge(rival, names=False)
            others = judge_.judged(self.script, _Idle(open_, most))
            if not others:
                continue
            breaks = any(
                line.verdict in ("true", "follows") and other.verdict == "false"
                for line, other in zip(lines, others, strict=True)
            )
            lines = tuple(
                line
                if (breaks and is_named(line) and not self._is_exchanged(line, lines))
                or self._follows_from_a_result(other, lines)
                else self._doubted(line, other, doubtful[line.line.number], asks)
                for line, other in zip(lines, others, strict=True)
            )
        return lines

    def _follows_from_a_result(self, other: JudgedLine, lines: Sequence[JudgedLine]) -> bool:
        """Whether a line of a rival rests on a wrong result alone, which alters no motion."""
        above = [line for line in lines if line.line.number in other.sources]
        return (
            other.verdict == "follows"
            and bool(above)
            and all(
                line.mistake is not None
                and (named := MISCONCEPTIONS.get(line.mistake.id or "")) is not None
                and named.world == "result"
                for line in above
            )
        )

    def _doubtful(self, rival: Interpretation, line: JudgedLine) -> tuple[str, ...]:
        """The letters that mean something else in a rival, and were not declared."""
        number = line.line.number
        force = self.meanings.best.at(number)
        return tuple(
            name
            for name in self.meanings.doubtful(rival, number)
            if force[name].by not in ("declared", "agreed")
            and not self._is_of_a_letter(rival, name, number)
            and not self._is_asked_speed(name, number)
            and not self._is_asked_share(name, number)
            and not self._is_taken_for_asked(name, number)
        )

    def _is_of_a_letter(self, rival: Interpretation, name: str, number: int) -> bool:
        """Whether a speed in words is the size of a component in a rival that has a letter.

        Nobody who has called it p says *speed of A* for it: he takes p for the whole speed.
        """
        meanings = self.meanings.best.at(number)
        other = rival.trees(number).get(name)
        if not (is_phrase(name) and kind_of(meanings[name].quantity) == "speed"):
            return False
        if not isinstance(other, Apply):
            return False
        parts = (meaning.quantity for meaning in meanings.values() if not is_phrase(meaning.letter))
        return any(_sphere_of(part) and self._agree(Apply("abs", part), other) for part in parts)

    def _is_asked_speed(self, name: str, number: int) -> bool:
        """Whether words name the very speed that the part asks for, and so no component of it."""
        meant = self.meanings.best.at(number)[name].quantity
        if not (is_phrase(name) and is_quantity(meant, "speed")):
            return False
        asked = (tree for tree, _ in self.bench.wanted.asked if isinstance(tree, Quantity))
        return any((x.kind, x.arguments) == (meant.kind, meant.arguments) for x in asked)

    def _is_asked_share(self, name: str, number: int) -> bool:
        """Whether words name the very share of an energy that the part asks for."""
        meant = self.meanings.best.at(number)[name].quantity
        if not (is_phrase(name) and is_binary(meant, "/")):
            return False
        return any(self._agree(meant, tree) for tree, _ in self.bench.wanted.asked)

    def _asked_trees(self) -> list[Expression]:
        """What the part asks for, each at its moment."""
        return self.bench.wanted.trees(self.bench.problem, self.bench.solved.part)

    def _asked_angles(self) -> list[Expression]:
        """The angles that the part asks for, or the sine, cosine or tangent of which."""
        trees = (x.argument if isinstance(x, Apply) else x for x in self._asked_trees())
        return [tree for tree in trees if kind_of(tree) in ANGLES]

    def _is_taken_for_asked(self, name: str, number: int) -> bool:
        """Whether a letter is taken for what is asked, as no line has that otherwise.

        Where a deflection is asked, d stands for nothing else.
        """
        if name in self.taken:
            return True
        meaning = self.meanings.best.at(number)[name]
        turn = name in _OF_TURN and kind_of(meaning.quantity) == "deflection"
        return (turn or meaning.by == "default") and meaning.quantity in self._asked_angles()

    def _is_asked_angle(self, name: str, meant: Expression, line: JudgedLine) -> bool:
        """Whether a letter is the only angle that is asked, by the sizes in a scalar product.

        ``cos θ = (14 + 9)/(5 × 4.61)`` is of the velocities of 5 and 4.61, whatever stands above.
        """
        asked = [tree for tree, _ in self.bench.wanted.asked if kind_of(tree) in ANGLES]
        if len(asked) != 1 or not self._agree(meant, asked[0]):
            return False
        sizes = _sizes_beside(asked[0], len(self.bench.worlds[0].events))
        cosine = Apply("cos", Letter(name))
        return sizes is not None and any(
            is_binary(claim.right, "/") and self._is_near(claim.right.right, sizes)
            for link in line.line.links
            for claim in link.readings
            if claim.left == cosine
        )

    def _is_near(self, first: Expression, second: Expression) -> bool:
        """Whether two numbers are equal in the first true world, but for a student's rounding."""
        world = self.bench.worlds[0]
        try:
            return bool(np.allclose(world.scalar(first), world.scalar(second), rtol=_ROUNDED))
        except RestitutionError:
            return False

    def _agree(self, first: Expression, second: Expression) -> bool:
        """Whether two quantities are equal in the first true world."""
        try:
            return agrees(Claim(first, "=", second), self.bench.worlds[0], {}, ()) is not None
        except RestitutionError:
            return False

    def _is_exchanged(self, line: JudgedLine, lines: Sequence[JudgedLine]) -> bool:
        """Whether all is true where the two letters of a line have each other's meanings."""
        meanings = self.meanings.best.at(line.line.number)
        known = self.meanings.best.trees(line.line.number)
        inferred = [
            name
            for name in sorted(names_in(line.line))
            if name in meanings
            and meanings[name].by == "inferred"
            and _sphere_of(known[name]) is not None
        ]
        if len(inferred) != 2:
            return False
        one, other = inferred
        turned = {**known, one: known[other], other: known[one]}
        return all(
            self._is_so_meant(link, line, turned)
            for line in lines
            for link in line.line.links
            if line.verdict in ("true", "false") and not names_of(link).isdisjoint(inferred)
        )

    def _doubted(
        self, line: JudgedLine, other: JudgedLine, doubtful: Sequence[str], asks: set[str]
    ) -> JudgedLine:
        inside = [name for name in doubtful if name in _names_in_doubt(line)]
        if line.verdict != "false" or not inside or other.verdict not in ("true", "follows"):
            return line
        asks.update(inside)
        return replace(line, verdict="asks", mistake=None, link=None)

    def unless_in_doubt(
        self, line: JudgedLine, lines: Sequence[JudgedLine], asks: set[str]
    ) -> JudgedLine:
        """A false line is a question if no other line supports what a letter in it is taken for.

        A letter of an odd look for that needs two true lines, others one, or a mistake with a name.
        """
        if line.verdict != "false":
            return line
        named = is_named(line)
        true = [names_in(line.line) for line in lines if line.verdict == "true"]
        true += [names_of(link) for link in line.line.links[: line.link or 0]]
        # An angle that is worked out from components is known by them.
        worked = {
            name
            for line in lines
            if line.verdict == "true" and any(use.principle == "angle" for use in line.uses)
            for name in names_in(line.line)
        }
        # Momentum of two letters tells both, however odd they look, if the line is a law in them.
        momenta = [
            names_in(line.line)
            for line in lines
            if line.verdict == "true" and line.uses and line.uses[0].principle == "momentum"
        ]
        names = _names_in_doubt(line)
        by_momentum = named and any(names <= pair for pair in momenta)
        doubtful: set[str] = set()
        for name, meaning in self.meanings.best.at(line.line.number).items():
            if name in names and meaning.by == "inferred" and not is_phrase(name):
                support = sum(name in proved for proved in true) + _SURE * (
                    name in worked or by_momentum
                )
                odd = is_odd(name, meaning.quantity)
                if self._is_asked_angle(name, meaning.quantity, line):
                    continue
                if support < (2 if odd else 0 if named else 1) or (
                    (not support or (support < _SURE and kind_of(meaning.quantity) in ANGLES))
                    and self._is_true_of_another(line, name, lines)
                ):
                    doubtful.add(name)
        if not doubtful:
            return line
        asks.update(doubtful)
        return replace(line, verdict="asks", mistake=None, link=None)

    def _is_true_of_another(self, line: JudgedLine, name: str, lines: Sequence[JudgedLine]) -> bool:
        """Whether a line is true if a letter means another quantity than it is taken for.

        Beside a component of one sphere a component is one of the other sphere, and what is known
        from the start is only given a value. The other sense of what a letter is taken for has to
        make all false lines true in which it stands, and those of an angle no more lines false.
        """
        known = self.meanings.best.trees(line.line.number)
        own = {known[name], Negate(known[name]), getattr(known[name], "operand", known[name])}
        beside = set(self._beside(line, name))
        defining = _gives(line.line, name)
        candidates = self.bench.names.candidates(self.bench.worlds[0])
        false = [line for line in lines if line.verdict == "false" and name in names_in(line.line)]
        true = [line for line in lines if line.verdict == "true" and name in names_in(line.line)]
        for candidate in candidates:
            if beside and (candidate.kind != "component" or candidate.body in beside):
                continue
            if candidate.start and not defining:
                continue
            for meant in (candidate.quantity, Negate(candidate.quantity)):
                tried = false if meant in own else [line]
                if not all(self._is_true_with_meaning(one, name, meant) for one in tried):
                    continue
                broken = sum(not self._is_true_with_meaning(one, name, meant) for one in true)
                if not self._is_turned(known[name], meant):
                    if broken > len(tried) and self._is_given(meant):
                        continue  # nobody who uses it otherwise calls a datum by it
                    return True
                if broken < len(tried) or (broken == len(tried) and not is_named(line)):
                    return True
        return False

    def _is_given(self, tree: Expression) -> bool:
        """Whether a quantity is equal to one that the question gives in numbers."""
        return any(self._agree(tree, quantity) for quantity, _ in self.bench.names.given)

    def _is_turned(self, own: Expression, other: Expression) -> bool:
        """Whether two angles are one, from either side of a line or its perpendicular."""
        world = self.bench.worlds[0]
        try:
            first, second = world.value(own), world.value(other)
        except RestitutionError:
            return False
        if not (isinstance(first, Angle) and isinstance(second, Angle)):
            return False
        gaps = (first.measure() - second.measure(), first.measure() + second.measure())
        return any(bool(np.all(np.abs(np.sin(2 * gap)) < _RIGHT)) for gap in gaps)

    def _beside(self, line: JudgedLine, name: str) -> Iterator[str]:
        """The spheres of the components beside which a letter for a component stands in a line."""
        meanings = self.meanings.best.at(line.line.number)
        if _sphere_of(meanings[name].quantity) is None:
            return
        for other in _names_in_doubt(line) - {name}:
            sphere = _sphere_of(meanings[other].quantity) if other in meanings else None
            if sphere is not None:
                yield sphere

    def _is_true_with_meaning(self, line: JudgedLine, name: str, meant: Expression) -> bool:
        known = self.meanings.best.trees(line.line.number)
        links = (link for link in line.line.links if name in names_of(link))
        return all(self._is_so_meant(link, line, {**known, name: meant}) for link in links)

    def _is_so_meant(self, link: Link, line: JudgedLine, meanings: Meanings) -> bool:
        """Whether a link is true where letters have given meanings, to three figures."""
        try:
            grade = agrees(
                link.readings[0], self.bench.worlds[0], meanings, link.decimals, line.line.scope
            )
        except RestitutionError:
            return False
        return grade in ("exact", "rounded")


def _gives(line: ScriptLine, name: str) -> bool:
    """Whether a line gives a letter, its square, or its tangent and the like a value."""
    sides = (
        side for link in line.links for claim in link.readings for side in (claim.left, claim.right)
    )
    return any(
        side == Letter(name)
        or (is_binary(side, "^") and side.left == Letter(name))
        or (isinstance(side, Apply) and side.argument == Letter(name))
        for side in sides
    )


def _sizes_beside(angle: Expression, last: int) -> Expression | None:
    """The product of the sizes of the two velocities that an angle is between."""
    match angle:
        case Quantity("deflection", (body,), stage):
            number = stage if isinstance(stage, int) else last
            return Binary("*", *(Quantity("speed", (body,), n) for n in (number - 1, number)))
        case Quantity("angle", (Quantity("velocity") as one, Quantity("velocity") as other)):
            return Binary("*", Apply("abs", one), Apply("abs", other))
    return None


def _sphere_of(tree: Expression) -> str | None:
    """The sphere whose component of velocity a quantity is; None of any other."""
    match tree:
        case Negate(operand):
            return _sphere_of(operand)
        case Quantity("along" | "across", (Quantity("velocity", (Name(body),)), _)):
            return body
    return None


def is_named(line: JudgedLine) -> bool:
    """Whether the mistake of a line is a misconception."""
    return line.mistake is not None and line.mistake.kind == "misconception"


def are_of_one_mistake(lines: Sequence[JudgedLine]) -> bool:
    """Whether several lines are false, and all of them instances of one altered law."""
    false = [line.mistake for line in lines if line.verdict == "false"]
    variants = [set(mistake.variants) for mistake in false if mistake is not None]
    return len(variants) > 1 and bool(set.intersection(*variants))


def names_in(line: ScriptLine) -> frozenset[str]:
    """The letters and phrases of a line."""
    return frozenset[str]().union(*map(names_of, line.links))


def _names_in_doubt(line: JudgedLine) -> frozenset[str]:
    """The letters on which it rests that a line is false.

    ``p = 3(3 - 7/4) = 9/2`` is false whatever p means: its numbers do not agree.
    """
    return names_in(line.line) if line.link is None else names_of(line.line.links[line.link])


def names_of(link: Link) -> frozenset[str]:
    """The letters and phrases of a relation, in all its readings."""
    return frozenset[str]().union(
        *(
            letters(side)
            for claim in link.readings
            for side in (claim.left, claim.right, *claim.others)
        )
    )
