"""Marks for a working: which points of a scheme its lines earn, as an examiner gives them.

Each point of a scheme looks for the line that earns it. A method is a line that uses its principle,
a mistake in it having its own rule (`explaining.mistakes.misconceptions`); accuracy is a true line
beside a method, or a value reached; a value that cannot be had without a method earns that as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from restitution.expression.tree import Binary, Degrees, Number, letters, walk
from restitution.practice.judgement import JudgedLine, Judgement
from restitution.practice.judging.other_forms import is_difference_of_tangents
from restitution.practice.marking.grounds import (
    LAWS,
    OF_ANGLES,
    has_name,
    is_for_an_angle,
    is_inequality,
)
from restitution.practice.marking.lines import (
    as_true,
    before_mistake,
    continues,
    ends_fine,
    has_cosine,
    is_plain,
    without_slip,
    wrong_numbers,
)
from restitution.practice.marking.marks import Marks, PointMark
from restitution.practice.marking.principle_lines import is_of_what_stays
from restitution.practice.marking.scheme import MarkPoint, Scheme
from restitution.practice.marking.single_points import OF_VALUES, SinglePoints
from restitution.practice.marking.values import Values

_UNSOUND = ("false", "unsupported", "follows")
# What a condition speaks of, which is used where the condition is stated in another form.
_OF_FACTS = ("angle", "deflection", "component", "speed", "fact")

# What an equation of a law has in it, so that it cannot be had without them.
_IN_EQUATIONS = ("component", "unchanged", "angle", "condition", "direction", "fact")

# Methods with values that laws have given.
_OF_STEPS = ("solve", "velocity", "speed", "angle", "direction", "component", "condition") + (
    "deflection",
)

# What a component is found by.
_RESOLVING = ("component", "angle", "direction")


def marked(judgement: Judgement, schemes: Sequence[Scheme], values: Values) -> Marks:
    """The marks of a judged working, by the scheme that gives most.

    ``values`` knows what the sides of lines are worth, and which of them name what is asked.
    """
    cosines = any(map(has_cosine, judgement.lines))
    fitting = [scheme for scheme in schemes if not (scheme.by_angles and cosines)]
    tried = [_Examiner(judgement, scheme, values).marks() for scheme in fitting]
    return max(tried, key=lambda marks: (marks.earned / max(marks.of, 1), marks.open))


class _Examiner(SinglePoints):
    """One working marked by one scheme."""

    def marks(self) -> Marks:
        self._apply()
        self._complete()
        self._keep()
        self._forgive()
        self._follow()
        self._require()
        self._imply_what_stands_by_itself()
        points = [self.states[point.id] for point in self.scheme.points]
        misread = self._misread(points)
        points = self._too_coarse(points) if misread is None else misread
        return Marks(self.scheme, tuple(points))

    def _apply(self) -> None:
        """Every point by itself, and what values imply."""
        for point in self.scheme.points:
            self.states[point.id] = self._first(point)
        self._solve()
        self._imply()
        self._imply_methods()

    def _solve(self) -> None:
        """A true value of either unknown is the value for which an elimination is made."""
        for point in self.scheme.points:
            own = self.states[point.id]
            between = point.letter == "A" and point.principle == "solve" and point.item is None
            if own.state != "lost" or own.line is not None or not between or point.equation:
                continue
            taken = {
                mark.line
                for mark in self.states.values()
                if mark.state == "earned" and mark.point.letter == "A"
            }
            line = next(
                (
                    line
                    for line in self.lines
                    if line.verdict == "true"
                    and line.grounded
                    and line.line.number not in taken
                    and not is_of_what_stays(line)
                    and self.values.is_solved(line)
                    and not (line is self.lines[-1] and self.values.is_of_multiples(line))
                ),
                None,
            )
            if line is not None:
                self.states[point.id] = self._earned(point, line, "")

    def _is_given(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line of a method gives its value as well: ``tan b = 5/36``."""
        worth = point.principle in OF_VALUES and not point.shown
        return worth and line.verdict == "true" and self.values.matches(point, line) == "true"

    def _complete(self) -> None:
        """Right answers to everything, without a mistake, earn the points of steps left out."""
        points = self.scheme.points
        answers = [self.states[point.id] for point in points if point.item is not None]
        broken = any(line.verdict in _UNSOUND for line in self.lines)
        if broken or not answers or any(point.shown for point in points):
            return
        if any(answer.state != "earned" for answer in answers):
            return
        last = max(answer.line or 0 for answer in answers)
        for point in points:
            if self.states[point.id].state != "earned":
                self.states[point.id] = PointMark(
                    point, "earned", last, "all that is asked is right without it", implied=True
                )

    def _imply(self) -> None:
        """A true value earns the points that it rests on, unless the result is printed."""
        printed = {name for point in self.scheme.points if point.shown for name in point.above}
        for point in reversed(self.scheme.points):
            own = self.states[point.id]
            if own.state == "earned" and point.shown:
                self._imply_steps(own)
            if own.state != "earned" or own.line is None or point.shown:
                continue
            line = self._line(own.line)
            if line is None or line.verdict not in ("true", "unsupported", "remark"):
                continue
            of_start = own.point.item is None and self.values.is_of_the_start(line)
            broken = self._is_broken(own.line, ("false",)) and not self._is_sure(own)
            if broken and not (point.equation and self._is_right_throughout(line)):
                continue  # a true equation shows what is in it, whatever stands above
            stated = point.letter == "M" and not own.implied
            stated = stated and not self._is_given(point, line)
            if stated and point.principle not in ("solve", "fact"):
                continue
            whole = point.principle == "energy" and self.values.has_whole_energy(line)
            for name in point.above:
                state = self.states[name]
                other = state.point.principle not in _OF_FACTS
                if stated and point.principle == "fact" and other:
                    continue
                if (point.letter == "B" or of_start) and state.point.principle not in _RESOLVING:
                    continue  # what stays, or stood before, implies no more than resolving it
                if state.state == "earned" or state.point.shown:
                    continue
                if state.point.item is not None and state.line is not None:
                    continue  # an answer is right or wrong by itself
                if name in printed and point.letter != "B" and not point.equation:
                    continue  # an equation shows the components in it
                if point.equation and state.point.principle not in _IN_EQUATIONS:
                    continue  # an equation needs the components in it, and nothing found before
                if point.equation and self._is_of_unknown(state.point, line):
                    continue  # a letter for a component needs no value of it
                if state.line is not None and self._is_wrong(state.line):
                    # A tangent has the component that stays, whatever a speed leaves out.
                    wrong = self._line(state.line)
                    named = wrong is None or has_name(wrong)
                    if named or state.point.letter != "B" or not _is_by_tangents(line):
                        continue
                if whole and state.point.principle in (*_RESOLVING, "impulse", "speed"):
                    continue  # an energy by whole speeds needs none of these
                why = f"line {own.line} cannot be had without it"
                self.states[name] = replace(
                    state, state="earned", line=own.line, why=why, implied=True
                )

    def _is_of_unknown(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line has a letter for a component from which a point's condition finds it."""
        of_body = point.principle in ("angle", "fact") and bool(point.bodies)
        known = of_body or point.principle in ("condition", "unchanged")
        return known and self.values.has_component_of(point.bodies, line)

    def _is_right_throughout(self, line: JudgedLine) -> bool:
        """Whether no number of a true line is one that a false line above has worked out."""
        above = (other for other in self.lines if other.line.number < line.line.number)
        wrong = wrong_numbers(above)
        return not any(
            isinstance(node, Number | Degrees) and node.value in wrong
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for node in walk(side)
        )

    def _imply_steps(self, result: PointMark) -> None:
        """A printed result that its own line works out earns the steps in that line.

        ``KE after/KE before = v²/u² = cos²α + e²sin²α = …`` needs neither energy by itself. What
        is printed shows no law.
        """
        line = self._line(result.line)
        if line is None or line.verdict != "true" or not line.grounded:
            return
        links = line.line.links
        worked = len(links) > 1 and all(continues(a, b) for a, b in pairwise(links))
        worked = worked or self._goes_on(line)
        if not worked or self._is_broken(result.line, _UNSOUND):
            return
        for name in result.point.above:
            state = self.states[name]
            step = state.point.letter == "A" or state.point.principle == "solve"
            if step and state.state == "lost" and state.line is None and not state.point.equation:
                why = "worked out in the line of the result"
                self.states[name] = replace(
                    state, state="earned", line=result.line, why=why, implied=True
                )

    def _imply_what_stands_by_itself(self) -> None:
        """A printed result that is earned shows each component that is said nowhere.

        So it does each value of the usual way, where there is no fault in another one.
        """
        faultless = not any(line.verdict in _UNSOUND for line in self.lines)
        for point in self.scheme.points:
            result = self.states[point.id]
            if not point.shown or result.state != "earned" or point.kind != "A1*":
                continue
            for name in point.above:
                state = self.states[name]
                shown = state.point.letter == "B" or (
                    faultless
                    and state.point.letter == "A"
                    and state.point.item is None
                    and not state.point.equation
                )
                if shown and state.state == "lost" and state.line is None:
                    why = f"line {result.line} cannot be had without it"
                    self.states[name] = replace(
                        state, state="earned", line=result.line, why=why, implied=True
                    )

    def _goes_on(self, line: JudgedLine) -> bool:
        """Whether a line begins with what a true line above it has worked out."""
        begun = {node for node in walk(line.line.links[0].readings[0].left) if letters(node)}
        return any(
            isinstance(other.line.links[-1].readings[0].right, Binary)
            and other.line.links[-1].readings[0].right in begun
            for other in self.lines
            if other.line.number < line.line.number and other.verdict == "true" and other.line.links
        )

    def _imply_methods(self) -> None:
        """A value that follows earns the methods by which it was found, and that it left out.

        Not those of laws: in place of one of these there may be what is wrong above.
        """
        for point in reversed(self.scheme.points):
            own = self.states[point.id]
            line = self._line(own.line)
            if line is None or line.verdict != "follows" or point.shown:
                continue
            if self._is_turned(line):
                continue
            for name in point.above:
                state = self.states[name]
                is_step = state.point.letter == "M" and state.point.principle in _OF_STEPS
                is_step = is_step or self._is_of_other_law(state.point, line)
                is_step = is_step or self._is_in_a_tangent(point, state.point, line)
                worked = state.point.principle == "energy" and name in point.depends
                worked = worked and point.principle == "energy" and not is_plain(line)
                is_step = is_step or (state.point.letter == "M" and worked)
                is_step = is_step or (
                    # A time in all, or a way, is put together of times or ways.
                    (state.point.letter, state.point.principle) == ("M", "place")
                    and name in point.depends
                    and point.item is not None
                )
                is_step = is_step and not (
                    is_inequality(state.point) and not self.values.has_inequality(line)
                )
                is_step = is_step and not self._is_at_old_angle(state.point, line)
                is_step = is_step and not self._has_no_components(state.point, line)
                is_step = is_step and not self._has_no_turn(state.point, line)
                is_step = is_step and not self._is_of_vectors(state.point, line)
                if is_step and state.state == "lost" and state.line is None:
                    why = f"line {own.line} cannot be had without it"
                    self.states[name] = replace(
                        state, state="earned", line=own.line, why=why, implied=True
                    )

    def _is_in_a_tangent(self, angle: MarkPoint, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a point is for the component that stays, in the tangent of an angle after.

        The other one, or the angle, is wrong there.
        """
        return (
            angle.principle in ("angle", "condition")
            and (point.letter, point.principle) == ("B", "unchanged")
            and not self._is_exchanged(point, line)
            and not self._is_unresolved(line)
        )

    def _is_at_old_angle(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line follows from a wrong angle to a wall, or from that to another one.

        No angle is found for this wall.
        """
        return point.principle in OF_ANGLES and any(map(self._is_of_wrong_angle, self._roots(line)))

    def _is_of_other_law(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a point is for a law at a wall that no mistake above a line concerns.

        So a velocity after a wall that follows from one before it shows both laws.
        """
        if point.principle not in LAWS or not self.values.is_at_a_wall(point):
            return False
        roots = self._roots(line)
        return bool(roots) and all(
            root.mistake is not None
            and root.mistake.id is not None
            and bool(root.uses)
            and all(
                use.principle != "arithmetic"
                and (use.principle not in LAWS or use.event not in (None, point.event))
                for use in root.uses
            )
            for root in roots
        )

    def _keep(self) -> None:
        """A slip in the line of an answer keeps the method that this line alone shows."""
        for point in self.scheme.points:
            own = self.states[point.id]
            line = self._line(own.line)
            if point.letter == "M" or own.state != "lost" or line is None:
                continue
            if not (self._is_slip_in_chain(line) or self._follows_slips(line)):
                continue
            for name in point.depends:
                state = self.states[name]
                if state.state == "lost" and state.line is None:
                    why = "a slip keeps the method"
                    self.states[name] = PointMark(state.point, "earned", own.line, why)

    def _forgive(self) -> None:
        """A line that but for a slip earns a method, or has what stays in it, keeps that.

        What stands in a line before the relation that is false keeps all that it earns; before a
        value that is worked out wrongly, the component that it is.
        """
        for mending, whole in ((without_slip, False), (before_mistake, True)):
            mended = tuple(map(mending, self.lines))
            false = {a.line.number for a, b in zip(self.lines, mended, strict=True) if a is not b}
            if false:
                self._keep_of(mended, false, whole=whole)

    def _keep_of(self, mended: tuple[JudgedLine, ...], false: set[int], *, whole: bool) -> None:
        """Keeps what lines that are false earn as they would be, a method or a ``whole`` line."""
        other = _Examiner(Judgement(mended, ()), self.scheme, self.values)
        other._apply()
        why = "stands before the mistake" if whole else "a slip keeps the method"
        for point in self.scheme.points:
            own, there = self.states[point.id], other.states[point.id]
            kept = whole or point.letter == "M" or point.principle == "unchanged"
            if self._of_difference(point) is not None:
                continue
            if not kept or own.state != "lost" or there.line not in false:
                continue
            if whole and (there.implied or not self._stands_apart(point, there)):
                continue
            if there.state == "earned" and own.line in (None, there.line):
                self.states[point.id] = replace(there, why=why)

    def _stands_apart(self, point: MarkPoint, there: PointMark) -> bool:
        """Whether a point rests on a relation by itself, or on a component worked out wrongly."""
        line = self._line(there.line)
        place = None if line is None else line.link
        if line is None or not place or (point.principle == "deflection" and has_name(line)):
            return False
        links = line.line.links
        apart = not continues(links[place - 1], links[place])
        return apart or (point.letter == "B" and point.item is None and point.principle in LAWS)

    def _follow(self) -> None:
        """What follows from a mistake is right only where that has cost something: not forgiven."""
        for point in self.scheme.points:
            own = self.states[point.id]
            line = self._line(own.line)
            if own.state != "earned" or line is None or line.verdict != "follows":
                continue
            if point.letter != "A" or not point.follows or point.equation or own.implied:
                continue
            right = self.values.is_right_beside(point, line)
            if not right and not self._follows_through(point, line):
                why = "follows from an earlier slip"
                self.states[point.id] = PointMark(point, "lost", own.line, why)

    def _is_slip_in_chain(self, line: JudgedLine) -> bool:
        """Whether a slip stands in a line that works out its value."""
        slip = line.mistake is not None and line.mistake.kind == "slip"
        return line.verdict == "false" and slip and len(line.line.links) > 1

    def _follows_slips(self, line: JudgedLine) -> bool:
        """Whether a value follows from lines in which nothing but slips is wrong."""
        above = [other for other in self.lines if other.line.number < line.line.number]
        wrong = [line.mistake for line in above if line.verdict == "false"]
        slips = all(mistake is not None and mistake.kind == "slip" for mistake in wrong)
        return line.verdict == "follows" and bool(wrong) and slips

    def _is_sure(self, mark: PointMark) -> bool:
        """Whether a value is true and rests on true lines, with a false one above it."""
        line = self._line(mark.line)
        if line is None or mark.point.equation:
            return False
        if mark.point.letter == "B" and mark.point.principle != "unchanged":
            return False
        if mark.point.kind == "DM1":
            return False
        solved = self.values.is_solved(line) or self.values.is_place(mark.point)
        solved = solved or (mark.point.item is not None and self.values.is_distance(mark.point))
        solved = solved or (self.values.is_pointing(mark.point) and self._has_pointing(mark.point))
        solved = solved or (mark.point.item is not None and _is_by_tangents(line))
        return line.verdict == "true" and line.grounded and solved

    def _has_pointing(self, point: MarkPoint) -> bool:
        """Whether the methods for a direction are earned, as they are without the mass."""
        return all(self.states[name].state == "earned" for name in point.depends)

    def _is_wrong(self, number: int) -> bool:
        line = self._line(number)
        return line is not None and line.verdict in ("false", "follows")

    def _require(self) -> None:
        """No accuracy without its method, and no dependent method without those it depends on."""
        for point in self.scheme.points:
            own = self.states[point.id]
            if point.shown and own.state == "lost" and self._is_broken(own.line, ("false",)):
                self._withdraw(own.line, own.why)
            if own.state != "earned":
                continue
            needed = [self.states[name] for name in point.depends or self._methods_for(own)]
            if self._is_too_early(own, needed):
                self.states[point.id] = self._missing(point)
                continue
            if point.shown:
                needed = [
                    self.states[name]
                    for name in point.above
                    if self.states[name].point.letter == "M"
                ]
            turned = point.letter == "M" and point.principle == "angle"
            by_angle = any(mark.point.principle == "angle" for mark in needed)
            if point.letter == "A" and by_angle and self._is_from_wrong_angle(own):
                # Nor is an angle right that comes of a wrong one.
                above = [self.states[name] for name in point.above]
                needed = [*needed, *(mark for mark in above if is_for_an_angle(mark.point))]
            if (turned or point.principle == "speed") and self._is_from_wrong_angle(own):
                # A speed is put together from components in the same way at any angle.
                kept = [mark for mark in needed if mark.point.principle not in OF_ANGLES]
                # No value is right at an angle for which there is a point, and this is lost.
                steps = [self.states[name] for mark in kept for name in mark.point.depends]
                angles = [mark for mark in steps if is_for_an_angle(mark.point)]
                needed = kept if point.letter == "M" else [*kept, *angles]
            missing = next((mark for mark in needed if mark.state == "lost"), None)
            if missing is not None and not point.shown and self._is_sure(own):
                continue
            if missing is not None:
                why = f"{missing.point.kind} for {missing.point.purpose} is not earned"
                self.states[point.id] = replace(own, state="lost", why=why)
            elif any(mark.state == "open" for mark in needed):
                self.states[point.id] = replace(
                    own, state="open", why="rests on a point still open"
                )
            elif point.shown and self._is_broken(own.line, _UNSOUND):
                why = "a line above it is not true"
                self.states[point.id] = replace(own, state="lost", why=why)
                self._withdraw(own.line, why)
            elif point.shown and self._is_leap(own, needed):
                why = "a step is missing between the equations and the result"
                self.states[point.id] = replace(own, state="lost", why=why)

    def _methods_for(self, mark: PointMark) -> Sequence[str]:
        """The one method by which a value is found that only follows, and has none of its own.

        Of two speeds the first shows how both are put together.
        """
        line = self._line(mark.line)
        if mark.point.letter != "A" or line is None or line.verdict != "follows":
            return ()
        alike = [x for x in self.scheme.points if x.principle == mark.point.principle]
        methods = [x.id for x in alike if x.letter == "M"]
        return methods if len(methods) == 1 else ()

    def _is_too_early(self, mark: PointMark, needed: Sequence[PointMark]) -> bool:
        """Whether a line that eliminates an unknown stands above what it is eliminated from."""
        if mark.point.principle != "solve" or mark.point.kind != "DM1" or mark.implied:
            return False
        stated = all(other.state == "earned" and not other.implied for other in needed)
        below = max((other.line or 0 for other in needed), default=0)
        return stated and (mark.line or 0) < below and self._elimination(mark.point) is None

    def _is_from_wrong_angle(self, mark: PointMark) -> bool:
        """Whether what earns a point follows from an angle that is wrong for no reason.

        Where the angle to a wall has its own point, that of another wall is such an angle.
        """
        line = self._line(mark.line)
        roots = [] if line is None else self._roots(line)
        apart = any(is_for_an_angle(self.states[name].point) for name in mark.point.above)
        wrong = filter(self._is_of_wrong_angle, roots)
        return any(apart or not has_name(root) for root in wrong)

    def _withdraw(self, number: int | None, why: str) -> None:
        """Takes away what the line of a printed result, under a line that is not true, gives."""
        line = self._line(number)
        if line is None or line.verdict != "true":
            return
        for name, mark in self.states.items():
            by_it = mark.line == number and mark.state == "earned" and not mark.point.equation
            if by_it and mark.point.letter != "M" and mark.point.item is None:
                self.states[name] = replace(mark, state="lost", why=why)

    def _is_leap(self, result: PointMark, methods: Sequence[PointMark]) -> bool:
        """Whether no step stands between the equations and the printed result."""
        line = self._line(result.line)
        if line is None or len(line.line.links) > 1 or result.point.principle == "inequality":
            return False
        laws = [mark.line for mark in methods if mark.point.principle in LAWS and mark.line]
        last = max(laws, default=0)
        return not any(
            last <= other.line.number < line.line.number
            and other.verdict == "true"
            and (other.line.number > last or len(other.line.links) > 1)  # CLM: ..., so v = ...
            for other in self.lines
        )

    def _is_broken(self, number: int | None, verdicts: Sequence[str]) -> bool:
        """Whether a line with one of the verdicts stands above a line."""
        return any(
            line.verdict in verdicts
            for line in self.lines
            if number is None or line.line.number < number
        )

    def _misread(self, points: list[PointMark]) -> list[PointMark] | None:
        """A misread datum: what follows from it is earned, and two A or B are taken away."""
        first = next(
            (
                line
                for line in self.lines
                if line.mistake is not None and line.mistake.id == "misread"
            ),
            None,
        )
        if first is None:
            return None
        through = _Examiner(
            Judgement(tuple(as_true(line) for line in self.lines), ()), self.scheme, self.values
        )
        through.values = self.values.of_his_own()
        own = {point.point.id: point for point in through.marks().points}
        taken = 0
        marks: list[PointMark] = []
        for point in points:
            after = own[point.point.id]
            if after.state == "earned" and point.point.letter in "AB" and taken < 2:
                taken += 1
                after = replace(
                    after, state="lost", why="a misread: the first two of these are lost"
                )
            marks.append(after)
        return marks

    def _too_coarse(self, points: list[PointMark]) -> list[PointMark]:
        """Answers that are right and given too coarsely cost one mark, once.

        Each that early rounding has put off costs its own.
        """
        marks: list[PointMark] = []
        coarse = False
        for point in points:
            line = self._line(point.line)
            judged = point.state == "earned" and point.point.item is not None and not point.implied
            if not judged or point.point.shown or line is None or line.accuracy != "coarse":
                marks.append(point)  # of what is printed the statement says how fine it is
                continue
            off = self.values.is_off(point.point, line)
            fine = ends_fine(line) or self.values.is_to_a_tenth(point.point, line)
            fine = fine or self.values.ends_in_noughts(point.point, line)
            right = line.verdict == "true" and not self._is_exact_above(point)
            if right and off:
                point = replace(point, state="lost", why="wrong by early rounding")
            elif right and not fine and not coarse:
                coarse = True
                point = replace(point, state="lost", why="given too coarsely")
            marks.append(point)
        return marks

    def _is_exact_above(self, mark: PointMark) -> bool:
        """Whether a finer form of the same value stands in a line."""
        return any(
            line.verdict == "true"
            and line.accuracy in ("exact", "rounded")
            and self.values.matches(mark.point, line) == "true"
            for line in self.lines
        )


def _is_by_tangents(line: JudgedLine) -> bool:
    """Whether a line works out an angle from two others by their tangents."""
    return any(is_difference_of_tangents(link.readings[0]) for link in line.line.links)
