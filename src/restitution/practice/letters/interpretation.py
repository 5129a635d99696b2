"""Interpretations of a script: what each of its letters means, line by line."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

from restitution.expression.tree import Expression
from restitution.practice.judgement import Meaning
from restitution.records import dataclass


@dataclass(frozen=True)
class FixedLetter:
    """``take u = 5``: a free letter of the statement has one value from one line to another.

    ``last`` is None where it holds to the end.
    """

    letter: str
    value: Fraction
    first: int
    last: int | None = None


@dataclass(frozen=True)
class Interpretation:
    """A meaning for every letter and phrase of a script.

    ``score`` counts the lines that it explains. ``unknown`` are the letters that have no meaning.
    """

    meanings: tuple[Meaning, ...] = ()
    score: float = 0.0
    unknown: frozenset[str] = frozenset()
    fixed_letters: tuple[FixedLetter, ...] = ()

    def at(self, number: int) -> Mapping[str, Meaning]:
        """The meanings in force in a line; letters of the statement are not among them."""
        force: dict[str, Meaning] = {}
        for meaning in sorted(self.meanings, key=lambda meaning: meaning.since):
            if meaning.since <= number or meaning.letter not in force:
                force[meaning.letter] = meaning
        return force

    def trees(self, number: int) -> Mapping[str, Expression]:
        """The quantities that letters mean in a line."""
        return {letter: meaning.quantity for letter, meaning in self.at(number).items()}

    def fixed(self, number: int) -> Mapping[str, Fraction]:
        """The letters of the statement that have one value in a line."""
        return {
            letter.letter: letter.value
            for letter in self.fixed_letters
            if letter.first <= number and (letter.last is None or number <= letter.last)
        }


@dataclass(frozen=True)
class Interpretations:
    """The best interpretation, and those that explain a script nearly as well.

    ``asks`` are the letters that have no meaning in the best one.
    """

    best: Interpretation
    rivals: tuple[Interpretation, ...] = ()

    @property
    def asks(self) -> frozenset[str]:
        """The letters of which it has to be asked what they mean."""
        return self.best.unknown

    def __iter__(self) -> Iterator[Interpretation]:
        yield self.best
        yield from self.rivals

    def __len__(self) -> int:
        return 1 + len(self.rivals)

    def doubtful(self, rival: Interpretation, number: int) -> tuple[str, ...]:
        """The letters that mean something else in a rival, in a line."""
        best, other = self.best.trees(number), rival.trees(number)
        return tuple(name for name in best if best[name] != other.get(name))
