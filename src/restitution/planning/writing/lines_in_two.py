"""A line that becomes two: what is put in first, and what comes of it."""

from __future__ import annotations

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Derivation, Line
from restitution.oracle import Oracle
from restitution.planning.writing.gathering import numbered_anew


def number_above(derivation: Derivation) -> int:
    """A number that no line has, for one that comes above another: it is numbered anew with it."""
    return len(derivation.lines) + 1


def with_two_for(
    derivation: Derivation, line: Line, pair: tuple[Line, Line], oracle: Oracle
) -> Derivation | None:
    """The working with two lines in the place of one, of which the second keeps its number.

    None where one of them does not follow.
    """
    order = [
        own
        for other in derivation.lines
        for own in (pair if other.number == line.number else (other,))
    ]
    whole = numbered_anew(derivation, order)
    read = reader_of(whole, oracle)
    numbers = (line.number, line.number + 1)
    return whole if all(read.accepts(read.lines[number]) for number in numbers) else None


__all__ = ["number_above", "with_two_for"]
