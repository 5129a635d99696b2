"""Letters that are taken for what a part asks, where the lines tell of nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Angle
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    walk,
)
from restitution.practice.judgement import JudgedLine, Meaning
from restitution.practice.judging.bench import numbers
from restitution.practice.judging.certain_letters import asked_by_look, has_no_such_value
from restitution.practice.judging.doubts import Doubts, names_in
from restitution.practice.judging.entries import is_numeric
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.judging.verdicts import Judge
from restitution.practice.letters.interpretation import Interpretation
from restitution.practice.letters.wordings import words_of
from restitution.practice.reading.phrase_names import is_phrase, is_vague
from restitution.practice.script import Script, ScriptLine

_OF_ANGLES = frozenset({"beta", "phi", "theta"})
_RIGHT_ANGLE, _STRAIGHT = Degrees(Fraction(90)), Degrees(Fraction(180))
_NEAR_DEGREES = 0.6
_CONSTANT = 1e-9
_UNDECIDED = frozenset({"asks", "unread", "remark"})


class AskedLetters(Doubts):
    """The letters of one script that are what its part asks."""

    def _judged(
        self, script: Script, interpretation: Interpretation, *, names: bool = True
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        judge_ = self._judge(interpretation, names=names)
        return judge_, judge_.judged(script)

    # --- letters for what is asked ----------------------------------------------------------------

    def _with_asked_letters(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines with letters for what is asked that have a value which nothing of the kind has.

        So it is with ``t = 2/5`` where one time is asked: whatever time it is, the value is wrong.
        """
        best = self.meanings.best
        taken = {name: tree for line in lines for name, tree in self._taken(line, lines)}
        if not taken:
            return judge_, lines
        meant = tuple(
            Meaning(name, tree, words_of(tree, self.bench.problem), "default")
            for name, tree in taken.items()
        )
        kept = tuple(meaning for meaning in best.meanings if meaning.letter not in taken)
        other = replace(best, meanings=(*kept, *meant), unknown=best.unknown - taken.keys())
        judge_too, again = self._judged(self.script, other)
        before, after = (
            sum(line.verdict in ("false", "asks") for line in every) for every in (lines, again)
        )
        # A line that alone defines its letter was true by that.
        if after > before + len(taken.keys() & self._defined_last(lines).keys()):
            return judge_, lines
        self.meanings = replace(self.meanings, best=other)
        self.taken = frozenset(taken)
        return judge_too, again

    def _taken(
        self, line: JudgedLine, lines: Sequence[JudgedLine]
    ) -> Iterator[tuple[str, Expression]]:
        """The letters of a line that are taken for what is asked, each with that."""
        defined = self._defined_last(lines)
        if line.verdict not in ("false", "asks") and line not in defined.values():
            return
        known = self.meanings.best.at(line.line.number)
        worlds, asked = self.bench.worlds, self._asked_trees()
        true = {name for own in lines if own.verdict == "true" for name in names_in(own.line)}
        true -= defined.keys()
        for link in line.line.links:
            match link.readings[0].left:
                case Letter(name) if name not in true and not is_phrase(name):
                    meaning = known.get(name)
                case _:
                    continue
            meant = asked_by_look(name, link.readings[0].right, asked)
            if meant is None:
                continue
            if name not in defined and meaning is not None and meaning.by != "inferred":
                continue
            if _goes_on(link.readings[0].right, line, lines):
                continue
            candidates = self.bench.names.candidates(worlds[0])
            if has_no_such_value(meant, link, candidates, worlds, line.line.scope):
                yield name, meant

    def with_idle_definitions(
        self, lines: Sequence[JudgedLine], asks: set[str]
    ) -> tuple[JudgedLine, ...]:
        """The lines in which ``v = 2i + j``, which fits nothing, is no definition but a question.

        So it is where no other line has the letter: nobody defines what he does not use.
        """
        return tuple(self._idle_definition(line, lines, asks) for line in lines)

    def _idle_definition(
        self, line: JudgedLine, lines: Sequence[JudgedLine], asks: set[str]
    ) -> JudgedLine:
        own = line.line
        if line.verdict != "true" or own.kind != "relations" or len(own.links) != 1:
            return line
        names = names_in(own)
        if len(names) != 1:
            return line
        (name,) = names
        base, _, number = name.partition("_")
        others = {other for e in lines if e != line for other in names_in(e.line)}
        if number.isdigit() and any(other.startswith(f"{base}_") for other in others):
            return line  # the velocity at the start, before v2 and v3
        word = re.compile(rf"(?<![^\W\d_]){re.escape(name)}(?![^\W_])")
        if any(names & names_in(e.line) or word.search(e.line.text) for e in lines if e != line):
            return line
        meaning = self.meanings.best.at(own.number).get(name)
        if meaning is None or meaning.by != "declared" or not is_numeric(meaning.quantity):
            return line
        asks.add(name)
        return replace(line, verdict="asks")

    def _defined_last(self, lines: Sequence[JudgedLine]) -> Mapping[str, JudgedLine]:
        """The letter for an impulse that the last line alone defines by numbers, with that line.

        Where a number is asked; an impulse of which another line speaks may be another one.
        """
        related = [line for line in lines if line.line.links]
        if not related or related[-1].verdict != "true":
            return {}
        *above, last = related
        names = names_in(last.line)
        spoken = any("impulse" in name.split() for line in above for name in names_in(line.line))
        asked = [tree for tree, _ in self.bench.wanted.asked if kind_of(tree) == "impulse"]
        if len(names) != 1 or spoken or len(asked) != 1 or not self._is_constant(asked[0]):
            return {}
        meanings = self.meanings.best.at(last.line.number)
        return {
            name: last
            for name in names
            if name in meanings and meanings[name].by == "declared"
            if is_numeric(meanings[name].quantity)
            if not any(name in names_in(line.line) for line in above)
        }

    def _is_constant(self, tree: Expression) -> bool:
        """Whether a quantity has a number, whatever the letters are."""
        try:
            return bool(np.ptp(self.bench.worlds[0].scalar(Apply("abs", tree))) < _CONSTANT)
        except RestitutionError:
            return False

    # --- the angle that is asked ------------------------------------------------------------------

    def _with_asked_angle(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines with a letter for the angle that is asked, where only its complement stands.

        Nobody asks for the angle to the normal: ``tan β = 0.5/0.433`` is upside down, if no line
        has the angle itself. Nor has anybody two letters for one angle and its supplement.
        """
        best = self.meanings.best
        asked = self._asked_angles()
        own = [
            meaning
            for meaning in best.meanings
            if meaning.by == "inferred"
            and len(asked) == 1
            and (self._is_to_the_normal(meaning, asked[0], lines) or self._is_supplement(meaning))
            and not self._agree(meaning.quantity, asked[0])
        ]
        if len(own) != 1 or self._has_number_of(asked[0]):
            return judge_, lines
        meant = replace(own[0], quantity=asked[0], by="default")
        meanings = tuple(meant if meaning is own[0] else meaning for meaning in best.meanings)
        other = replace(best, meanings=meanings)
        judge_too, again = self._judged(self.script, other)
        if sum(line.verdict == "false" for line in again) > 1:
            return judge_, lines
        self.meanings = replace(self.meanings, best=other)
        return judge_too, again

    def _is_to_the_normal(
        self, meaning: Meaning, asked: Expression, lines: Sequence[JudgedLine]
    ) -> bool:
        """Whether a letter for an angle means the complement of the one that is asked."""
        return (
            kind_of(asked) == "angle"
            and meaning.letter in _OF_ANGLES
            and self._agree(meaning.quantity, Binary("-", _RIGHT_ANGLE, asked))
            and any(Letter(meaning.letter) in _sides_of(line.line) for line in lines)
        )

    def _is_supplement(self, meaning: Meaning) -> bool:
        """Whether a letter means the supplement of the angle that a letter above it means."""
        own = [other for other in self.meanings.best.meanings if not is_phrase(other.letter)]
        return kind_of(meaning.quantity) in ANGLES and any(
            kind_of(other.quantity) in ANGLES
            and self._agree(meaning.quantity, Binary("-", _STRAIGHT, other.quantity))
            and self._begins(other.letter) < self._begins(meaning.letter)
            for other in own
        )

    def _begins(self, letter: str) -> int:
        """The number of the first line in which a letter stands."""
        own = (line.number for line in self.script.lines if letter in names_in(line))
        return next(own, len(self.script.lines))

    def _with_angle_in_words(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines of a wrong working where *the angle* is the one asked for, if no more is false.

        A wrong value of it may be that of another angle.
        """
        best = self.meanings.best
        asked = self._asked_angles()
        own = [
            meaning
            for meaning in best.meanings
            if is_phrase(meaning.letter)
            and is_vague(meaning.letter)
            and kind_of(meaning.quantity) in ANGLES
            and meaning.quantity not in asked
        ]
        false = sum(line.verdict == "false" for line in lines)
        if len(own) != 1 or len(asked) != 1 or not false:
            return judge_, lines
        meant = replace(own[0], quantity=asked[0])
        meanings = tuple(meant if meaning is own[0] else meaning for meaning in best.meanings)
        other = replace(best, meanings=meanings)
        judge_too, again = self._judged(self.script, other)
        if sum(line.verdict == "false" for line in again) > false:
            return judge_, lines
        self.meanings = replace(self.meanings, best=other)
        return judge_too, again

    def _has_number_of(self, angle: Expression) -> bool:
        """Whether a number of the script is what an angle is worth in degrees, or nearly."""
        world = self.bench.worlds[0]
        try:
            value = world.value(angle)
        except RestitutionError:
            return True
        if not isinstance(value, Angle):
            return True
        degrees = np.degrees(value.measure()).flat[0]
        typed = [float(x) for line in self.script.lines for x in _values_in(line)]
        return any(abs(number - degrees) < _NEAR_DEGREES for number in typed)


def _goes_on(value: Expression, line: JudgedLine, lines: Sequence[JudgedLine]) -> bool:
    """Whether a value goes on from one of a line above of which nothing is known."""
    above = [x for x in lines if x.line.number < line.line.number and x.verdict in _UNDECIDED]
    worked = {link.readings[0].right for x in above for link in x.line.links}
    return any(node in worked for node in walk(value))


def _sides_of(line: ScriptLine) -> Iterator[Expression]:
    """The sides of the relations of a line."""
    for link in line.links:
        yield from (link.readings[0].left, link.readings[0].right)


def _values_in(line: ScriptLine) -> Iterator[Fraction]:
    """The numbers of a line, of a remark those seen in it."""
    yield from numbers((*_sides_of(line), *line.values))
