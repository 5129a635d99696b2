"""Times that are not those their letters and words have: of another event, or of a mistake."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import combinations

from restitution.expression.tree import Binary, Expression, Letter, Quantity
from restitution.practice.judging.entries import is_numeric
from restitution.practice.judging.following import Following
from restitution.practice.judging.judged_link import JudgedLink
from restitution.practice.reading.phrases import names_time, names_whole_time
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
            if meant not in times or names_whole_time(name):
                continue
            for time in times:
                other = replace(claim, left=time)
                grade = self._best_accuracy(other, self.worlds, line, link)
                if grade is not None:
                    return JudgedLink("true", other, grade)
        return None

    def _mistimed(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A time that is wrong: one in all, or one that an altered law explains.

        Of any other nobody knows since when it counts.
        """
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
