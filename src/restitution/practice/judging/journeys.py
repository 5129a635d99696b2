"""Times that are not those their letters and words have: of another event, or of a mistake."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations, product

from restitution.expression.tree import Binary, Expression, Letter, Number, Quantity
from restitution.practice.judging.entries import Entry, is_numeric
from restitution.practice.judging.following import Following
from restitution.practice.judging.judged_link import JudgedLink
from restitution.practice.reading.phrases import (
    names_time,
    names_way_back,
    names_whole_time,
)
from restitution.practice.script import Claim, Link, ScriptLine


class Journeys(Following):
    """Times of events, and those between two of them."""

    def _times(self) -> Iterator[Expression]:
        """The times of the events, the latest first, and those between two of them."""
        events = range(len(self._base.events), 0, -1)
        times = [Quantity("time", (), number) for number in events]
        yield from times
        yield from (Binary("-", one, other) for one, other in combinations(times, 2))

    def _at_another_time(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A time by the letter that another time has further up: ``t = 0.5``, then ``t = 2.5``."""
        meanings = self.meanings(line.number)
        times = tuple(self._times())
        for claim in link.readings:
            match claim:
                case Claim(Letter(name), "=", value, ()) if is_numeric(value):
                    meant = meanings.get(name)
                case _:
                    continue
            if meant not in times or names_whole_time(name) or names_way_back(name):
                continue
            for time in times:
                other = replace(claim, left=time)
                grade = self._best_accuracy(other, self.worlds, line, link)
                if grade is not None:
                    return JudgedLink("true", other, grade)
        return None

    def _summed_times(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A time in all that adds up times of lines above, of which one is wrong."""
        own = [entry for entry in self.entries if self._is_time(entry)]
        wrong = [(entry.claim.right, entry.number) for entry in own if entry.wrong]
        # A time on the way is a number without a name: 6/2 = 3, of a wrong speed.
        wrong += [(Number(value), number) for value, number in self._own_numbers.worked()]
        known = [(x, 0) for x in self._times()] if wrong else []
        for claim in link.readings if wrong else ():
            match claim:
                case Claim(Letter(name), "=", value, ()) if is_numeric(value) and names_time(name):
                    pass
                case _:
                    continue
            for (first, number), (other, beside) in product(wrong, [*wrong, *known]):
                if number == beside:
                    continue
                summed = replace(claim, left=Binary("+", first, other))
                grade = self._best_accuracy(summed, self.worlds, line, link)
                if grade is not None:
                    numbers = tuple(sorted({number, beside} - {0}))
                    return JudgedLink("follows", claim, grade, numbers)
        return None

    def _is_time(self, entry: Entry) -> bool:
        """Whether a line gives a time its value."""
        left = entry.claim.left
        meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
        return entry.is_value and is_numeric(entry.claim.right) and meant in tuple(self._times())

    def _mistimed(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A time that is wrong: one in all, or one that an altered law explains.

        Of any other nobody knows since when it counts.
        """
        summed = self._summed_times(line, link)
        if summed is not None:
            return summed
        for claim in link.readings:
            match claim:
                case Claim(Letter(name), "=", value, ()) if is_numeric(value) and names_time(name):
                    pass
                case _:
                    continue
            if names_whole_time(name):
                return JudgedLink("false", claim)
            for time in self._times() if self._names else ():
                other = replace(claim, left=time)
                if self.naming.explained(self._entry_of(line, link, other), self).variants:
                    return JudgedLink("false", other, meant=((name, time),))
        return None
