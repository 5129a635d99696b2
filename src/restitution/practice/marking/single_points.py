"""Each point of a scheme by itself: the line of a working that earns or loses it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.expression.tree import Binary, Number
from restitution.practice.judgement import JudgedLine, Use
from restitution.practice.marking.grounds import (
    LAWS,
    OF_DEFLECTION,
    has_name,
    is_inequality,
)
from restitution.practice.marking.lines import (
    SOUND,
    continues,
    has_vector,
    is_plain,
    is_sound,
)
from restitution.practice.marking.marks import PointMark, State
from restitution.practice.marking.principle_lines import PrincipleLines, is_of_what_stays
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.worlds.principles import is_worked

_OF_WHOLE_SPEEDS = frozenset(
    {"impulse-of-speeds", "speed-for-component", "restitution-whole-speed"}
)

# The words in which it is said whether bodies meet.
_CONCLUDING = re.compile(
    r"\b(again|collides?|collisions?|hits?|strikes?|meets?|catch(?:es)?|overtakes?)\b", re.I
)

_UNGROUNDED = "does not follow from the true lines above"

# What a condition of the question is stated with.
_CONDITIONS = ("fact", "speed", "energy", "angle", "deflection")

# Methods that a value of what they are for shows.
OF_VALUES = (
    "component",
    "speed",
    "angle",
    "energy",
    "impulse",
    "deflection",
    "velocity",
    "scalar-product",
    "place",
)


class SinglePoints(PrincipleLines):
    """The lines of a working, and what each point of one scheme finds in them."""

    def _first(self, point: MarkPoint) -> PointMark:
        if point.letter == "M":
            mark = self._method(point)
            return self._missing(point) if self._is_asserted(point, mark) else mark
        if point.equation:
            return self._equation(point)
        if point.letter == "B" and point.item is None:
            return self._independent(point)
        stated = self._stated(point)
        value = self._value(point) if stated is None else self._earned(point, stated, "")
        if (spoilt := self._goes_wrong(point, value)) is not None:
            return PointMark(point, "lost", spoilt.line.number, "what it goes on with is not true")
        alone = value.line is None or value.state == "earned"
        in_words = self._in_words(point) if point.shown and alone else None
        return value if in_words is None else self._earned(point, in_words, "said in words")

    def _goes_wrong(self, point: MarkPoint, value: PointMark) -> JudgedLine | None:
        """A false line that goes on, ``= ½mu²(1 - e)²``, from what is worth what is printed.

        Whoever has written the printed form itself has shown it.
        """
        line = self._line(value.line)
        if not point.shown or value.state != "earned" or line is None or point.link is None:
            return None
        links = line.line.links
        if not links or links[-1].readings[0].right == point.link.right:
            return None
        below = next((x for x in self.lines if x.line.number > line.line.number), None)
        if below is None or not below.line.text.lstrip().startswith("="):
            return None
        return below if below.verdict == "false" else None

    def _method(self, point: MarkPoint) -> PointMark:
        """A line that uses the principle; one with a mistake has the rule of that mistake."""
        lost = self._of_other_energy(point) or self._of_difference(point)
        lost = lost or self._of_a_part(point)
        if lost is not None:
            return lost
        for line, use in self._uses(point):
            if point.principle == "solve" and (
                not line.grounded or line.line.number < self._first_line(point)
            ):
                continue
            # What follows by a definition is worked out from his own values by the right one.
            defined = line.verdict == "follows" and point.principle in OF_VALUES
            if (use.altered is None or defined) and is_sound(line):
                if line.verdict != "follows" or lost is None:
                    return self._earned(point, line, "")
                continue
            earns, why = self._with_mistake(line, use)
            if earns:
                return self._earned(point, line, why)
            lost = lost or PointMark(point, "lost", line.line.number, why)
        whole = lost is not None and point.principle == "impulse"
        line_of_it = (
            (None if whole else self._by_value(point))
            or self._pointing(point)
            or (None if self._is_denied_turn(point, lost) else self._condition(point))
        )
        if line_of_it is not None:
            return self._earned(point, line_of_it, "")
        compared = self._compared(point) or self._in_a_sum(point) or self._in_squares(point, lost)
        compared = compared or self._in_a_law(point)
        if compared is not None:
            return self._earned(point, compared, "")
        if point.principle == "deflection":
            turned = (x for x in self.lines if x.verdict == "true" and x.grounded)
            by_sum = next((x for x in turned if self.values.turns_by(point, x)), None)
            if by_sum is not None:
                return self._earned(point, by_sum, "")
        if point.principle == "angle" and (lost is None or self._is_of_deflection(lost)):
            # The components may go out of the equations of two laws together, or the angle is
            # worked out to another line first.
            sound = (
                line
                for line in self.lines
                if (line.verdict in SOUND and line.grounded) or self._is_after_alone(line)
            )
            divided = next(
                (
                    line
                    for line in sound
                    if self.values.has_angle(point, line)
                    or self.values.works_out_an_angle(line, known=not self._is_below(line))
                    or self._is_tangent_after(line)
                ),
                None,
            )
            if divided is not None:
                return self._earned(point, divided, "")
        if point.principle == "angle" and (
            inverted := next((x for x in self.lines if self.values.is_upside_down(point, x)), None)
        ):
            return self._earned(point, inverted, "the tangent upside down; the method stands")
        solving = point.principle in ("solve", "method") or (
            point.principle == "condition" and bool(point.depends) and not is_inequality(point)
        )
        if lost is None and solving:
            line_of_value = self._elimination(point) or self._worked_out(point)
            if line_of_value is not None and self._has_no_turn(point, line_of_value):
                why = "the deflection that is given is not used"
                return PointMark(point, "lost", line_of_value.line.number, why)
            if line_of_value is not None:
                return self._earned(point, line_of_value, "")
        tangent = self._by_tangent(point)
        if tangent is not None:
            return self._earned(point, tangent, "the angle by its tangent instead")
        if (assembled := self._assembled(point)) is not None:
            return self._earned(point, assembled, "its parts put together")
        if lost is None and point.principle == "component":
            value = self._value(point)
            if value.state == "earned":
                return value  # seen in a remark, or used in a line
        if lost is None and (other := self._of_other_approach(point)) is not None:
            return self._earned(point, other, "both velocities are there; the approach is wrong")
        if lost is None and (resolved := self._resolved_at_wrong_angle(point)) is not None:
            return self._earned(point, resolved, "resolved; the angle is another point")
        return lost or self._carried(point) or self._missing(point)

    def _is_asserted(self, point: MarkPoint, mark: PointMark) -> bool:
        """Whether a method for an angle shows in the printed result alone, to which nothing leads.

        Nothing above speaks of the angle, nor of the component that stays.
        """
        line = self._line(mark.line)
        if mark.state != "earned" or point.principle not in ("angle", "deflection"):
            return False
        if line is None or self.values.turns_by(point, line):
            return False
        if not any(self.values.is_bare_result(x, line) for x in self.scheme.points):
            return False
        above = [x for x in self.lines if x.line.number < line.line.number and x.verdict in SOUND]
        staying = [self.states[x] for x in point.above if self.states[x].point.letter == "B"]
        seen = staying and all(x.line not in (None, line.line.number) for x in staying)
        return not seen and not any(self.values.mentions(point, other) for other in above)

    def _of_other_approach(self, point: MarkPoint) -> JudgedLine | None:
        """A false line with the separation of two spheres, and a value that no mistake explains."""
        if point.principle != "restitution":
            return None
        return next(
            (
                line
                for line in self.lines
                if line.verdict == "false" and line.mistake is not None and not line.mistake.kind
                if self.values.is_separation(point, line)
            ),
            None,
        )

    def _assembled(self, point: MarkPoint) -> JudgedLine | None:
        """A false line that puts together parts of which one only is wrong, for no known reason."""
        if point.principle not in ("velocity", "speed", "energy"):
            return None
        return next(
            (
                line
                for line in self.lines
                if line.verdict == "false" and self.values.adds_up(point, line)
                if point.principle == "velocity" or not has_name(line)
            ),
            None,
        )

    def _by_tangent(self, point: MarkPoint) -> JudgedLine | None:
        """A line with the angle of a velocity where the scalar product needs its speed."""
        if not any(point.principle == "scalar-product" for point in self.scheme.points):
            return None
        sound = (line for line in self.lines if line.verdict in SOUND)
        return next((line for line in sound if self.values.has_tangent(point, line)), None)

    def _carried(self, point: MarkPoint) -> PointMark | None:
        """The law of restitution at a wall, in the velocity after that a true line gives."""
        if point.principle != "restitution" or not self.values.is_at_a_wall(point):
            return None
        true = [line for line in self.lines if line.verdict == "true" and line.grounded]
        line = next((line for line in true if self.values.carries(point, line)), None)
        line = line or next((line for line in true if self._has_rebound(line)), None)
        line = line or next((x for x in true if self.values.bounds_component(point, x)), None)
        return None if line is None else self._earned(point, line, "used here")

    def _has_rebound(self, line: JudgedLine) -> bool:
        """Whether an impulse of a wall is written with e, and so without the velocity after it."""
        of_impulse = bool(line.uses) and line.uses[0].principle == "impulse"
        return of_impulse and self.values.has_rebound(line) and not self.values.is_formula(line)

    def _is_of_deflection(self, mark: PointMark) -> bool:
        """Whether a point is lost by how a deflection is put together, and not by its angles."""
        line = self._line(mark.line)
        mistake = None if line is None else line.mistake
        return mistake is not None and mistake.id in OF_DEFLECTION

    def _is_denied_turn(self, point: MarkPoint, lost: PointMark | None) -> bool:
        """Whether a deflection is put together wrongly: its angles are no method for it."""
        return point.principle == "deflection" and lost is not None and self._is_of_deflection(lost)

    def _of_other_energy(self, point: MarkPoint) -> PointMark | None:
        """An energy without all its terms, beside one that is right: the method needs both."""
        answers = [
            other
            for other in self.scheme.points
            if point.id in other.depends and other.item is not None
        ]
        if point.principle != "energy" or any(map(self._has_true_line, answers or [point])):
            return None
        alone = sum(x.letter == "M" and x.principle == "energy" for x in self.scheme.points) == 1
        for line in self.lines:
            named = MISCONCEPTIONS.get(line.mistake.id or "") if line.mistake else None
            rule = None if named is None else named.mark_of("energy")
            own = [use for use in line.uses if use.principle == "energy"]
            if line.verdict != "false" or rule is None or not rule.startswith("M0"):
                continue
            if _adds_numbers(line):
                continue
            if any(alone or use.event == point.event for use in own):
                return PointMark(point, "lost", line.line.number, self._reason(line))
        return None

    def _of_a_part(self, point: MarkPoint) -> PointMark | None:
        """A loss in one impact, or of one sphere, alone in a working that is to give another."""
        asked = [
            other.link.left
            for other in self.scheme.points
            if point.id in other.depends and other.item is not None and other.link is not None
        ]
        of_energy = [x for x in self.lines if any(use.principle == "energy" for use in x.uses)]
        if point.principle != "energy" or len(asked) != 1 or len(of_energy) != 1:
            return None
        line = of_energy[0]
        if line.verdict != "true" or not self.values.is_other_loss(asked[0], line):
            return None
        return PointMark(point, "lost", line.line.number, "a part of the energy lost")

    def _compared(self, point: MarkPoint) -> JudgedLine | None:
        """A line that uses the condition of a point, or compares what the part is to compare."""
        if point.principle == "inequality":
            return self._conclusion(point)
        if point.principle == "condition":
            return self._with_component(point) or self._inequality(point)
        shown = any(point.shown and point.principle == "inequality" for point in self.scheme.points)
        return self._inequality(point) if shown and point.principle == "solve" else None

    def _inequality(self, point: MarkPoint) -> JudgedLine | None:
        """A sound line that compares two values; of a false one what stands before its mistake.

        Where there are several conditions, one that is another one is none of a point.
        """
        others = [
            other
            for other in self.scheme.points
            if other is not point and other.principle == "condition" and is_inequality(other)
        ]
        for line in self.lines:
            stated = any(self.values.states(other, line) for other in others)
            if stated and not self.values.states(point, line):
                continue
            end = line.link or 0 if line.verdict == "false" else len(line.line.links)
            signs = {link.readings[0].sign for link in line.line.links[:end]}
            if self._is_turned(line) or self.values.restates_a_fact(line):
                continue
            if line.verdict in (*SOUND, "false") and signs - {"=", "!="}:
                return line
        return None

    def _by_value(self, point: MarkPoint) -> JudgedLine | None:
        """A line that gives what a method is for, from true values or the student's own."""
        if point.principle not in OF_VALUES or point.shown:
            return None
        return next(
            (
                line
                for line in self.lines
                if line.verdict in SOUND or self._is_of_wrong_motion(point, line)
                if self._is_matched(point, line) and not self._has_no_components(point, line)
                if not self._is_of_vectors(point, line)
            ),
            None,
        )

    def _pointing(self, point: MarkPoint) -> JudgedLine | None:
        """A line in which the vector stands along which something points."""
        if not self.values.is_pointing(point):
            return None
        return next((line for line in self.lines if self.values.shows(point, line)), None)

    def _condition(self, point: MarkPoint) -> JudgedLine | None:
        """A true line that is the condition of the question, with values put in."""
        if point.principle not in _CONDITIONS:
            return None
        true = (line for line in self.lines if line.verdict == "true")
        return next((line for line in true if self.values.states(point, line)), None)

    def _equation(self, point: MarkPoint) -> PointMark:
        """The equation itself, correct."""
        lost: PointMark | None = None
        for line, use in self._uses(point):
            altered = use.altered is not None
            through = line.verdict == "follows" and self._follows_through(point, line)
            if line.verdict == "follows" and self._is_at_own_line(line):
                return self._earned(point, line, "right along his line of centres")
            if line.verdict in ("true", "remark") or through:
                if not altered and (lost is None or line.verdict != "follows"):
                    return self._earned(point, line, "")
            elif line.verdict == "follows" and not altered and lost is None:
                # Newton's law with the sense that his momentum gives his letters.
                law = point.principle == "restitution" or self._is_second_law(point)
                law = law and not any(self._spoils_laws(point, x) for x in self._roots(line))
                if law and self.values.has_velocities(line):
                    return self._earned(point, line, "consistent with the line of momentum")
                if law and self._puts_in(line):
                    return self._earned(point, line, "the law with his own values in it")
                why = "follows from an earlier slip"
                lost = PointMark(point, "lost", line.line.number, why)
            lost = lost or PointMark(point, "lost", line.line.number, self._reason(line))
        return lost or self._carried(point) or self._missing(point)

    def _puts_in(self, line: JudgedLine) -> bool:
        """Whether a line is a law with values in it, and not a value alone: ``e = (3 - 1)/4``."""
        links = line.line.links
        worked = len(links) > 1 and continues(links[0], links[1])
        worked = worked or is_worked(links[0].readings[0].right)
        return line.uses[0].principle in LAWS and (worked or not self.values.is_solved(line))

    def _independent(self, point: MarkPoint) -> PointMark:
        """A component that stays, or one read off: as a line, or used in one."""
        lost: PointMark | None = None
        for line, use in self._uses(point):
            sound = line.verdict in SOUND and use.altered is None
            if self._is_at_wrong_angle(point, line):
                return self._earned(point, line, "the law is right; the angle is another point")
            if sound and not self._is_of_what_stays(point, line, use):
                continue
            if sound and self._is_exchanged(point, line):
                continue
            if line.verdict == "false" and self._is_of_other_body_alone(point, line):
                continue  # what stays is shown for one sphere, and left out for the other
            if sound and self._is_denied(point) and not self.values.has_velocities(line):
                continue  # 13 cos α = 12 tells nothing of what stays
            if sound and point.principle == "component" and line.verdict == "follows":
                continue  # a component that is read off is right, or has no mark
            if sound and (lost is None or line.verdict == "true"):
                return self._earned(point, line, "")
            lost = lost or PointMark(point, "lost", line.line.number, self._reason(line))
        condition = self._condition(point) if lost is None and not point.shown else None
        if condition is not None:
            return self._earned(point, condition, "")
        if (shown := self._carried_above(point, lost)) is not None:
            return self._earned(point, shown, "used here")
        value = self._value(point)
        seen = next((line for line in self.lines if self.values.is_seen(point, line)), None)
        if value.state != "earned" and seen is not None and not self._is_withdrawn(lost, seen):
            return self._earned(point, seen, "seen here")
        if value.state == "earned" or (lost is not None and self._is_named(lost)):
            return value if value.state == "earned" else lost or value
        used = next(
            (
                line
                for line in self.lines
                if self.values.carries(point, line)
                and (lost is None or (line.verdict in SOUND and has_vector(line)))
                and not (self._is_unresolved(line) or self._is_exchanged(point, line))
                and (not self._is_at_old_wall(line) or self._is_at_wrong_angle(point, line))
            ),
            None,
        )
        if lost is None:
            used = used or next(
                (x for x in self.lines if x.grounded and self.values.carries_of_other(point, x)),
                None,
            )
        return lost or value if used is None else self._earned(point, used, "used here")

    def _carried_above(self, point: MarkPoint, lost: PointMark | None) -> JudgedLine | None:
        """A true line with the component after a wall, above a mistake that may be at another."""
        if lost is None or lost.line is None or not self.values.is_at_a_wall(point):
            return None
        above = (x for x in self.lines if x.line.number < lost.line and x.verdict == "true")
        return next((x for x in above if x.grounded and self.values.carries(point, x)), None)

    def _is_named(self, lost: PointMark) -> bool:
        """Whether a point is lost to a mistake that has a name, and not to a slip or to none."""
        line = self._line(lost.line)
        return line is None or line.verdict != "false" or has_name(line)

    def _is_of_other_body_alone(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line speaks of other bodies than a point, and has no component in exchange."""
        bodies = self.values.bodies_in(line)
        other = bool(bodies and point.bodies) and bodies.isdisjoint(point.bodies)
        return other and not has_name(line)

    def _is_unresolved(self, line: JudgedLine) -> bool:
        """Whether a line only gives a speed to which whole speeds have led, without components."""
        above = {root.mistake.id for root in self._roots(line) if root.mistake is not None}
        return bool(above & _OF_WHOLE_SPEEDS) and is_plain(line) and not has_vector(line)

    def _is_denied(self, point: MarkPoint) -> bool:
        """Whether a false line has a component that stays as another one."""
        return point.principle == "unchanged" and any(
            line.verdict == "false"
            and any(
                use.altered and (use.principle, use.event) == (point.principle, point.event)
                for use in line.uses
            )
            for line in self.lines
        )

    def _is_of_what_stays(self, point: MarkPoint, line: JudgedLine, use: Use) -> bool:
        """Whether a line speaks of one body's component that stays.

        A sum over two bodies does not, nor does a wrong value that happens to be its size.
        """
        if point.principle != "unchanged" or self.values.speaks_for(point, line):
            return True
        own = line.uses[:1] == (use,) and self.values.has_speeds(line)
        return (line.verdict == "true" or own) and len(use.bodies) < 2

    def _value(self, point: MarkPoint) -> PointMark:
        """A value: true, or his own where the point follows through; the last one given counts."""
        last: PointMark | None = None
        for place, line in enumerate(self.lines, 1):
            whole = self._joined(line) if point.shown else line
            match = self.values.matches(point, whole) or self.values.completes(
                point, self.lines[:place]
            )
            if line.verdict == "false" and self.values.is_bound(point, line):
                last = PointMark(point, "lost", line.line.number, "another range in its place")
                continue
            if self.values.is_other_range(point, line):
                last = PointMark(point, "lost", line.line.number, "not the whole range")
                continue
            if match is None and self._is_worked_out_wrongly(point, last, line):
                last = PointMark(point, "lost", line.line.number, self._reason(line))
            if match is None:
                continue
            right = line.verdict == "follows" and self.values.is_right_beside(point, line)
            if right:
                last = self._earned(point, line, "")
            elif line.verdict == "true" and match == "true":
                last = self._earned(point, line, "")
                if not line.grounded and not self._is_his_own(point, self.lines[:place]):
                    last = PointMark(point, "lost", line.line.number, _UNGROUNDED)
                if self._is_left_open(point, line, self.lines[place:]):
                    why = "another value is given beside it"
                    last = PointMark(point, "lost", line.line.number, why)
            elif line.verdict == "follows" and match != "true":
                if last is not None and last.state == "earned" and point.item is None:
                    continue  # a value on the way, that another equation gives once more
                through = self._follows_through(point, line)
                state: State = "earned" if through else "lost"
                last = PointMark(point, state, line.line.number, "follows from an earlier slip")
            elif line.verdict == "false":
                stands = last is not None and last.state == "earned"
                stands = stands and not (last and self._is_begun(point, last))
                above = self._line(last.line) if last is not None else None
                stands = stands and not self.values.has_ratios(point, above)
                if stands and not self.values.replaces(point, line):
                    continue  # what is wrong behind a right answer loses nothing
                last = PointMark(point, "lost", line.line.number, self._reason(line))
            elif line.verdict == "unsupported":
                why = "does not follow from the lines above"
                if last is None or last.state != "earned":
                    last = PointMark(point, "lost", line.line.number, why)
        if last is not None and last.state == "earned" and self._lacks_an_end(point, last):
            last = replace(last, state="lost", why="the other end of the range is missing")
        if last is not None and last.state == "earned" and self._is_one_of_several(point, last):
            sound = [line for line in self.lines if line.verdict in SOUND]
            alike = [other for other in self.scheme.points if other.item == point.item]
            if self.values.left_out(point, sound) > len(alike) - 1 - alike.index(point):
                last = replace(last, state="lost", why="another value is possible as well")
        if last is not None and self._is_left_off(point, last):
            last = replace(last, state="lost", why="only a multiple of it is given")
        if last is None and (summed := self._in_a_sum(point)) is not None:
            last = self._earned(point, summed, "seen here")
        seen_alone = (
            self.values.is_velocity,
            self.values.is_direction,
            self.values.is_pointing,
            self.values.is_place,
            self.values.is_time,
        )
        if last is None and any(function(point) for function in seen_alone):
            seen = next((line for line in self.lines if self.values.shows(point, line)), None)
            last = None if seen is None else self._earned(point, seen, "")
        if last is None and point.item is not None:
            items = len({other.item for other in self.scheme.points} - {None})
            listed = next((x for x in self.lines if self.values.lists(point, x, items)), None)
            last = None if listed is None else self._earned(point, listed, "")
        if last is None and point.item is not None and (same := self._same(point)) is not None:
            last = self._earned(point, same, "is worth as much")
        if last is None and (angle := self._by_angle_of_line(point)) is not None:
            last = self._earned(point, angle, "by its angle")
        if last is None and point.principle == "component":
            used = next((line for line in self.lines if self.values.relates(point, line)), None)
            used = used or self._unchanged_instead(point) or self._in_wrong_law(point)
            last = None if used is None else self._earned(point, used, "used here")
        if last is None:
            wrong = any(x.verdict == "false" and self.values.is_of_direction(x) for x in self.lines)
            along = (x for x in self.lines if not wrong and self.values.points_along(point, x))
            used = next(along, None)
            last = None if used is None else self._earned(point, used, "used here")
        if last is None:
            seen = next((line for line in self.lines if self.values.is_seen(point, line)), None)
            last = None if seen is None else self._earned(point, seen, "seen here")
        if last is None and point.shown and point.principle == "inequality":
            conclusion = self._conclusion(point)
            compared = next((x for x in self.lines if self.values.compares(point, x)), None)
            if compared is not None:
                last = self._earned(point, compared, "")
            elif conclusion is not None and _CONCLUDING.search(conclusion.line.text):
                last = self._earned(point, conclusion, "")
        return last or self._missing(point)

    def _is_left_open(
        self, point: MarkPoint, line: JudgedLine, below: Sequence[JudgedLine]
    ) -> bool:
        """Whether an answer is one of two values of which the other is none: ``9 or 10``."""
        if point.link is None or point.item is None or point.shown:
            return False
        asked = point.link.left
        open_ = self.values.leaves_open(asked, line)
        return open_ and not self.values.is_decided_below(asked, below)

    def _is_worked_out_wrongly(
        self, point: MarkPoint, mark: PointMark | None, line: JudgedLine
    ) -> bool:
        """Whether a line goes on from the one that has a value not worked out, to a wrong one."""
        goes_on = line.verdict == "false" and line.line.text.lstrip().startswith("=")
        above = mark is not None and mark.line == line.line.number - 1
        return goes_on and above and self.values.replaces(point, line)

    def _is_one_of_several(self, point: MarkPoint, mark: PointMark) -> bool:
        """Whether a right answer may be one of several; of what follows nobody counts them."""
        line = self._line(mark.line)
        return point.item is not None and line is not None and line.verdict != "follows"

    def _is_begun(self, point: MarkPoint, mark: PointMark) -> bool:
        """Whether a value is earned by a multiple of it alone: ``3v/2 = √13/6``."""
        line = self._line(mark.line)
        return line is not None and self.values.gives_multiple_only(point, line)

    def _is_left_off(self, point: MarkPoint, mark: PointMark) -> bool:
        """Whether a working ends in a multiple of a value on the way: ``3w = 9``."""
        last = self.lines[-1].line.number == mark.line
        between = point.item is None and not point.equation
        return mark.state == "earned" and last and between and self._is_begun(point, mark)

    def _in_words(self, point: MarkPoint) -> JudgedLine | None:
        """A line below the equations that says in words what is printed, as of a direction."""
        words = self.values.words_of_direction(point)
        words = words or self.values.words_of_equality(point, self.lines)
        last = max((self.states[x].line or 0 for x in point.above if x in self.states), default=0)
        return next(
            (
                line
                for line in self.lines
                if words is not None
                and line.line.number >= last > 0
                and line.verdict in ("remark", "true")
                and words.search(line.line.text)
            ),
            None,
        )

    def _conclusion(self, point: MarkPoint) -> JudgedLine | None:
        """A line that compares two values, or says in words what comes of it."""
        for line in self.lines:
            if self.values.is_about_others(point, line):
                continue
            signs = {link.readings[0].sign for link in line.line.links}
            if line.verdict in SOUND and signs - {"=", "!="}:
                return line
            if line.verdict in ("remark", *SOUND) and _CONCLUDING.search(line.line.text):
                return line
        return None

    def _elimination(self, point: MarkPoint) -> JudgedLine | None:
        """A line in which one unknown is left, below the equations of which it is eliminated."""
        return next(
            (
                line
                for line in self.lines
                if line.verdict in SOUND and line.grounded and self._is_eliminated(line)
                if line.line.number >= self._first_line(point)
                if not self._is_no_elimination(point, line)
            ),
            None,
        )

    def _worked_out(self, point: MarkPoint) -> JudgedLine | None:
        """The line of an answer for which no working is known, with a step in it or above it."""
        answer = next((other for other in self.scheme.points if point.id in other.depends), None)
        if point.principle != "method" or answer is None:
            return None
        mark = self._value(answer)
        line = self._line(mark.line) if mark.state == "earned" else None
        first = line is not None and all(
            other is line or other.verdict != "true" for other in self.lines
        )
        return None if line is None or (first and len(line.line.links) < 2) else line

    def _first_line(self, point: MarkPoint) -> int:
        """The number of the line in which all that a point depends on has been attempted."""
        needed = (self.states[name].line or 0 for name in point.depends if name in self.states)
        return max(needed, default=0)

    def _is_eliminated(self, line: JudgedLine) -> bool:
        own = self.values.unknowns(line)
        above = [other for other in self.lines if other.line.number < line.line.number]
        fewer = len(own) == 1 and sum(own < self.values.unknowns(x) for x in above) > 1
        if line.verdict == "follows" and fewer:
            return True
        if is_of_what_stays(line):
            return False
        solved = self.values.is_solved(line, whole=True)
        return solved or self.values.is_eliminated(line, put_in=fewer)


def _adds_numbers(line: JudgedLine) -> bool:
    """Whether what is false in a line adds two numbers, of energies as wholes: ``15 + 2.5``."""
    match line.line.links[line.link or 0].readings[0].right:
        case Binary("+", Number(), Number()):
            return True
    return False
