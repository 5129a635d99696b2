"""In which order the equations of a route are written: laws express, known facts express, the rest
closes.

What an earlier part shows of letters takes the value of one first. A law expresses the components
after an impact. A fact expresses one only where that is its only unknown and it holds no letter
that is asked; else it is the last equation of its block.
"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from itertools import chain as chained

import sympy as sp

from restitution.explaining.lines.derivation import Route
from restitution.expression.tree import Letter, letters
from restitution.planning.formulas.blows import write_blows
from restitution.planning.routes.by_closing import Closing
from restitution.planning.routes.course import LAWS, Standing
from restitution.planning.routes.givens import candidate_of
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import NotPlannedError


class Solver(Closing):
    """Writes what a goal needs: the equations of its route, in the order of a teacher."""

    def reopen(self) -> None:
        """Equations that were used may be used again, where something in them is open by now."""
        own = [
            *(law.candidate for law in self.equations.laws),
            *map(candidate_of, self.scene.given),
        ]
        self.equations.used -= {candidate.id for candidate in own if self._open(candidate)}

    def determine(self, goals: Sequence[sp.Expr]) -> None:
        """Writes lines until everything in some values is known.

        The cheapest equations are tried first. Raises NotPlannedError where none of them can be
        written in an order, or solved.
        """
        standing, start = self.mark(), len(self.scene.desk.lines)
        zeros = self._take_zeros()
        if zeros:
            with suppress(NotPlannedError):
                self._determine(goals)
                if any(zeros & set(line.premises) for line in self.scene.desk.lines[start:]):
                    return
            self.back(standing)
        self._determine(goals)

    def _determine(self, goals: Sequence[sp.Expr]) -> None:
        """The same with what is known by now."""
        self.goals = goals
        self._express_waiting(goals)
        write_blows(self.scene)
        self._take_shown(goals)
        if not any(self.scene.unknown(self._by_separation(goal)) for goal in goals):
            return
        scene = self.scene
        first: NotPlannedError | None = None
        routes = self.equations.routes(goals, self.waiting)
        whole = filter(None, map(self._with_both_laws, routes))
        every = filter(None, map(self._with_all_laws, routes[:1]))
        for n, route in enumerate(chained(routes, whole, every)):
            standing = self.mark()
            try:
                self._take(route, goals)
                lines = scene.desk.lines
                require_true(scene.model, lines[standing.desk.lines :], lines, scene.desk.facts)
            except NotPlannedError as error:
                first = first or error
                self.back(standing)
                self.goals = goals
            else:
                item = scene.desk.item or ""
                scene.desk.others += [
                    Route(item, tuple(self.equations.move(own) for own in route))
                    for route in routes[n + 1 :]
                ]
                return
        assert first is not None
        raise first

    def _take_shown(self, goals: Sequence[sp.Expr]) -> None:
        """Takes the equations of letters that earlier parts show, in which one is unknown now.

        That has its value before laws are used: nothing needs to be worked out with it.
        """
        desk = self.scene.desk
        rests = [desk.under(number) for number in desk.shown if desk.holds(number)]
        if not rests or all(goal.is_Symbol for goal in goals):
            return
        numbers = {
            self.scene.model.unknowns.letter(own.link.left.name)
            for own in self.scene.given
            if isinstance(own.link.left, Letter) and not letters(own.link.right)
        }
        for own in map(candidate_of, self.scene.given):
            if own.id in self.equations.used or not any(own.id in under for under in rests):
                continue
            open_ = self._essential(own) - numbers
            if len(open_) == 1 and not open_ & self._letters.keys():
                standing = self.mark()
                try:
                    self._determine(list(open_))
                except NotPlannedError:
                    self.back(standing)
                self.goals = goals

    def _take(self, route: Sequence[Candidate], goals: Sequence[sp.Expr]) -> None:
        """Writes the equations of a route, in an order in which each tells something new."""
        scene = self.scene
        left = list(route)
        self._express_waiting([x for candidate in left for x in candidate.residuals])
        while left:
            self.reasons.clear()
            step = self._step(left)
            if step is None and (self._separation(left, goals) or self._widened(left)):
                continue
            if step is None and self.resort:
                step = self._together(left, goals)
            if step is None and self.reasons:
                raise self.reasons[0]
            if step is None:
                raise NotPlannedError(f"no order of {[candidate.id for candidate in left]}")
            for candidate in step:
                left.remove(candidate)
            # What was written on the way to another equation is used too.
            done = [candidate for candidate in left if not self._open(candidate)]
            self.equations.used |= {candidate.id for candidate in done}
            left = [candidate for candidate in left if candidate not in done]
            self._express_waiting([*goals, *(x for candidate in left for x in candidate.residuals)])
            write_blows(scene)
        rest = {symbol for goal in goals for symbol in scene.unknown(goal)}
        rest -= self._separating()
        if rest & self._letters.keys() and list(rest) != list(goals):
            # Where a goal is greatest or least in what is open, no gradient tells of that.
            self.determine(sorted(rest & self._letters.keys(), key=str))
            return
        components = {component.symbol for component in scene.model.components.values()}
        if rest & (components | {goal for goal in goals if goal.is_Symbol}):
            raise NotPlannedError(f"{rest} are open")

    def _widened(self, left: list[Candidate]) -> bool:
        """Takes up the laws of components that stand in a route and that it leaves open.

        A fact may tell what is asked without them, and yet be written by them.
        """
        open_ = [
            s
            for candidate in left
            for s in sorted(self._open(candidate), key=str)
            if s in self._letters
        ]
        taken = {candidate.id for candidate in left}
        for symbol in open_:
            try:
                route = self.equations.routes([symbol], self.waiting)[0]
            except NotPlannedError:
                continue
            more = [candidate for candidate in route if candidate.id not in taken]
            if more:
                left += more
                return True
        return False

    def _with_both_laws(self, route: Sequence[Candidate]) -> tuple[Candidate, ...]:
        """A route with momentum where it has restitution alone, and the other way round.

        Both solve together, though one may be enough to tell what is asked. Empty without such.
        """
        ids = {candidate.id for candidate in route}
        more = [
            own.candidate
            for own in self.equations.laws
            for other in ("momentum", "restitution")
            if own.kind in LAWS
            and own.candidate.id not in ids | self.equations.used
            and f"{other} {own.number}" in ids
            and self._after(own.number).keys()
            <= {s for candidate in route for s in self._open(candidate)}
        ]
        return (*route, *more) if more else ()

    def _with_all_laws(self, route: Sequence[Candidate]) -> tuple[Candidate, ...]:
        """A route with the laws of all impacts up to its last; empty where it has them.

        What cancels in an answer is no part of its route, and stands open in the laws all the same.
        """
        taken = {candidate.id for candidate in route}
        last = max(
            (own.number for own in self.equations.laws if own.candidate.id in taken), default=0
        )
        laws = tuple(
            own.candidate
            for own in self.equations.laws
            if own.number <= last
            and own.kind in (*LAWS, "wall")
            and own.candidate.id not in self.equations.used
        )
        more = [law for law in laws if law.id not in taken]
        rest = tuple(
            candidate for candidate in route if candidate.id not in {own.id for own in laws}
        )
        return (*laws, *rest) if more else ()

    def _next(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """Writes the next equation or block; returns what was used."""
        for test in (
            self._velocity_given,
            self._coefficient_given,
            self._direction_given,
            self._speed_compared,
            self._resolved,
            self._impulse_at_a_wall,
            self._wall,
            self._fact_expresses,
            self._letters_tied,
            self._fact_ties,
            self._law_ties,
            self._squares_with_momentum,
            self._block,
            self._single,
            self._closing,
            self._two,
        ):
            used = test(left)
            if used:
                self.equations.used |= {candidate.id for candidate in used}
                return used
        return None

    def _step(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """The next equation or block; as a last resort, none where one of them has no line."""
        try:
            return self._next(left)
        except NotPlannedError as error:
            if not self.resort:
                raise
            self.reasons.append(error)
            return None


__all__ = ["Solver", "Standing"]
