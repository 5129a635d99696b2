"""The false lines from which a line follows, and what these have cost."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from restitution.explaining.lines.angles import TRIGONOMETRIC
from restitution.explaining.lines.derivation import FLIPPED
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Expression,
    Letter,
    Quantity,
    has_unit_vector,
    is_binary,
    is_function,
    is_quantity,
    walk,
)
from restitution.practice.judgement import JudgedLine, Judgement, Use
from restitution.practice.marking.lines import (
    SOUND,
    fitting_uses,
    has_vector,
    is_plain,
    is_slip,
    is_sound,
    subtracts_squares,
)
from restitution.practice.marking.marks import PointMark
from restitution.practice.marking.scheme import MarkPoint, Scheme
from restitution.practice.marking.values import Values

LAWS = ("momentum", "restitution", "unchanged")
OF_ANGLES = ("angle", "component", "deflection")
_OF_WHOLE_SPEEDS = frozenset({"speed-for-component", "restitution-whole-speed"})
_WITH_COMPONENT = ("restitution-inverted", "restitution-omitted")
OF_DEFLECTION = ("deflection-difference", "deflection-is-after")


class Grounds:
    """The lines of a working beside one scheme, and what each line rests on."""

    def __init__(self, judgement: Judgement, scheme: Scheme, values: Values) -> None:
        self.lines = judgement.lines
        self.scheme = scheme
        self.values = values
        self.states: dict[str, PointMark] = {}

    def _stated(self, point: MarkPoint) -> JudgedLine | None:
        """A true line that is the equation for whose values a mark is, with a method beside it."""
        if point.letter != "A" or point.item is not None or point.shown or point.link is None:
            return None
        method = next((x for x in self.scheme.points if x.id in point.depends), None)
        own = ("energy", "fact")
        if method is None or method.link != point.link or method.principle not in own:
            return None
        true = (line for line in self.lines if line.verdict == "true" and line.grounded)
        return next((line for line in true if self.values.states(point, line)), None)

    def _is_second_law(self, point: MarkPoint) -> bool:
        """Whether momentum is used with what Newton's law has given, so that it may be his own."""
        above = self.scheme.points[: self.scheme.points.index(point)]
        return point.principle == "momentum" and any(
            other.equation and (other.principle, other.event) == ("restitution", point.event)
            for other in above
        )

    def _is_vector_law(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether momentum of vectors is written, and is what a point is for.

        That is another equation than the one along the line of centres.
        """
        link = point.link
        sides = () if link is None else (link.left, link.right)
        return (
            point.principle == "momentum" and has_vector(line) and any(map(has_unit_vector, sides))
        )

    def _in_wrong_law(self, point: MarkPoint) -> JudgedLine | None:
        """A line in which the law is turned upside down or has no e, and the component is right."""
        return next(
            (
                line
                for line in self.lines
                if line.verdict == "false" and line.mistake is not None
                if line.mistake.id in _WITH_COMPONENT
                if any(use.event == point.event and use.altered for use in fitting_uses(line))
            ),
            None,
        )

    def _has_true_line(self, point: MarkPoint) -> bool:
        """Whether a true line is the one for which a point is given."""
        true = (line for line in self.lines if line.verdict == "true")
        return any(self.values.matches(point, line) == "true" for line in true)

    def _is_below(self, line: JudgedLine) -> bool:
        """Whether a mistake stands above a line."""
        above = (other for other in self.lines if other.line.number < line.line.number)
        return any(line.verdict not in ("true", "remark") for line in above)

    def _follows_through(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a point is earned by what follows from a mistake.

        Its value comes from an earlier part, where it is only quoted here; or the mistake has lost
        an earlier A or B, and no method of a law, nor an equation of two spheres.
        """
        if point.letter == "B" and point.principle in LAWS and self._is_at_wrong_angle(point, line):
            return True  # the law is right, and the angle another point
        if not point.follows:
            return False
        begun = [
            root
            for root in self._roots(line)
            if not self._is_quoted(root) or self.values.speaks_for(point, root)
        ]
        return not begun or self._has_cost(begun, point)

    def _is_his_own(self, point: MarkPoint, lines: Sequence[JudgedLine]) -> bool:
        """Whether a true value, the last of some lines, is so in his own world as well.

        A sign that is lost may leave a speed as it is.
        """
        return point.follows and lines[-1].his_own

    def _has_cost(self, roots: Sequence[JudgedLine], point: MarkPoint) -> bool:
        """Whether mistakes have lost an answer or a B above a point, and no law of two spheres.

        Of such a law that is its method, or its equation; of an impulse it is the method. An answer
        that is written nowhere is lost to the mistake as well: it could not have been right.
        """
        numbers = {root.line.number for root in roots}
        above = takewhile(lambda other: other.id != point.id, self.scheme.points)
        marks = [self.states[other.id] for other in above if other.id in self.states]
        lost = [mark for mark in marks if mark.state == "lost"]
        by_these = [mark for mark in lost if self._rests_on(mark.line, numbers)]
        laws = [mark.point for mark in by_these if _is_of_a_law(mark.point)]
        if laws and not self._is_of_another_law(point, laws):
            return False
        angles = [mark for mark in lost if mark.point.principle in OF_ANGLES]
        wrong = [root for root in roots if self._is_of_wrong_angle(root)]
        if wrong and any(mark.point.letter == "M" for mark in angles):
            return all(map(has_name, wrong))  # that at another wall costs its own points
        unseen = [mark for mark in lost if mark.line is None and mark.point.letter == "A"]
        return any(
            mark.point.letter in "AB"
            and not mark.point.equation
            and not _is_ratio_of_angle(mark.point)
            for mark in [*by_these, *unseen]
        )

    def _is_of_another_law(self, point: MarkPoint, laws: Sequence[MarkPoint]) -> bool:
        """Whether an answer has a right method of its own, and other laws have been lost.

        So has an e by Newton's law below a wrong momentum, and an impulse below either.
        """
        own = [self.states[x] for x in point.depends if x in self.states]
        methods = [mark for mark in own if mark.point.principle in (*LAWS, "impulse")]
        lost = {law.principle for law in laws}
        return (
            point.item is not None
            and bool(methods)
            and all(mark.state == "earned" for mark in methods)
            and all(mark.point.principle not in lost for mark in methods)
        )

    def _has_lost_law(self, line: JudgedLine) -> bool:
        """Whether a line has lost a point for a law, which is then one of this part."""
        return any(
            mark.state == "lost" and mark.line == line.line.number and mark.point.principle in LAWS
            for mark in self.states.values()
        )

    def _rests_on(self, number: int | None, roots: set[int]) -> bool:
        """Whether a line is one of some false lines, or follows from one of them."""
        line = self._line(number)
        if line is None:
            return False
        return number in roots or any(root.line.number in roots for root in self._roots(line))

    def _is_of_wrong_motion(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a time or a place is wrong by a law alone, and worked out as it should be."""
        named = line.mistake is not None and line.mistake.kind == "misconception"
        law = bool(line.uses) and line.uses[0].principle in LAWS
        return point.principle == "place" and line.verdict == "false" and named and law

    def _is_matched(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives what a point is for, or the square of a speed by its components.

        Of an impulse that is a vector it may be the only component.
        """
        if self.values.matches(point, line) is not None:
            return True
        if point.principle == "impulse" and self.values.is_size_of_impulse(point, line):
            return line.verdict == "true"
        return point.principle == "speed" and self.values.is_sum_of_squares(point, line)

    def _is_of_vectors(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a velocity only follows from an equation of vectors that is false.

        No components are put together there.
        """
        return (
            point.principle in ("velocity", "impulse")
            and line.verdict == "follows"
            and is_plain(line)
            and any(
                has_vector(root)
                and not isinstance(root.line.links[0].readings[0].left, Letter | Quantity)
                for root in self._roots(line)
            )
        )

    def _has_no_components(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a speed follows from laws with whole speeds, and so from no component."""
        roots = (root.mistake for root in self._roots(line))
        names = {mistake.id for mistake in roots if mistake is not None}
        worked = any(
            is_binary(node, "^") or is_function(node, "sqrt")
            for link in line.line.links
            for node in walk(link.readings[0].right)
        )
        of_speeds = line.verdict == "follows" and not worked and bool(names & _OF_WHOLE_SPEEDS)
        return point.principle == "speed" and of_speeds

    def _is_of_wrong_angle(self, line: JudgedLine) -> bool:
        """Whether a false line has the angle at another wall, or one to a line for no reason."""
        if line.mistake is not None and line.mistake.id == "second-wall-angle":
            return True
        return not has_name(line) and not is_slip(line) and self.values.is_of_an_angle(line)

    def _is_at_old_wall(self, line: JudgedLine) -> bool:
        """Whether nothing but the angle at another wall is wrong in a line, or above it."""
        wrong = [root.mistake for root in ([line] if line.mistake else self._roots(line))]
        old = all(mistake is not None and mistake.id == "second-wall-angle" for mistake in wrong)
        return bool(wrong) and old

    def _is_at_wrong_angle(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether nothing but the angle to a wall is wrong in a line, and costs a point elsewhere.

        The scheme has a point for it above, or it stands in a line of its own.
        """
        if not self._is_at_old_wall(line):
            return False
        above = takewhile(lambda other: other.id != point.id, self.scheme.points)
        own = any(
            other.letter == "M" and other.principle in ("angle", "component")
            for other in above
            if other.event in (None, point.event)
        )
        roots = [line] if line.mistake else self._roots(line)
        return own or not any(use.principle in LAWS for root in roots for use in root.uses)

    def _resolved_at_wrong_angle(self, point: MarkPoint) -> JudgedLine | None:
        """A line with components at a wall by a wrong angle, where that has a point of its own."""
        above = [other for other in self.scheme.points if other.id in point.above]
        if point.principle != "component" or not any(map(is_for_an_angle, above)):
            return None
        return next(
            (
                line
                for line in self.lines
                if any(
                    use.principle in ("unchanged", "restitution")
                    and use.event in (None, point.event)
                    for use in line.uses
                )
                if any(map(self._is_of_wrong_angle, (line, *self._roots(line))))
            ),
            None,
        )

    def _has_no_turn(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line follows from another angle in the place of the deflection.

        No deflection is put together there, nor one that is given made use of.
        """
        wrong = (root.mistake for root in self._roots(line))
        other = any(mistake is not None and mistake.id in OF_DEFLECTION for mistake in wrong)
        if point.principle == "condition" and point.link is not None:
            return other and is_ratio_of_angle(point.link.left)
        return other and point.principle == "deflection"

    def _is_no_component_of(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line has no velocity in it, or one component alone where a velocity is due.

        Nor is a component before an impact a velocity after it.
        """
        if point.principle == "velocity":
            of_start = point.event is not None and not self.values.has_velocities(line)
            if of_start or not has_vector(line):
                return True
        return point.principle in ("velocity", "component") and self.values.speaks_of_line_alone(
            line
        )

    def _is_no_elimination(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line with one unknown only prepares what is solved."""
        return (
            self._is_of_one_angle(point, line)
            or self._is_before_condition(point, line)
            or self._is_of_other_impact(point, line)
        )

    def _is_of_other_impact(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line is a law at another impact than those whose laws are solved."""
        needed = (self.states[name].point for name in point.depends if name in self.states)
        events = {other.event for other in needed if other.principle in LAWS}
        own = line.uses[0] if line.uses else None
        if own is None or own.principle not in LAWS or own.event is None:
            return False
        return bool(events - {None}) and own.event not in events

    def _is_before_condition(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line needs no condition of the question, which solving puts in."""
        needed = (self.states[name].point for name in point.depends if name in self.states)
        conditions = [x for x in needed if x.principle in ("deflection", "fact")]
        return bool(conditions) and self.values.holds_by_laws(line)

    def _is_of_one_angle(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line only gives the angle from which another is put together wrongly."""
        wrong = (other.mistake.id for other in self.lines if other.mistake is not None)
        if not any(name in OF_DEFLECTION for name in wrong):
            return False
        needed = (self.states[name] for name in point.depends if name in self.states)
        return line.verdict == "true" and any(
            mark.point.principle == "angle" and mark.line == line.line.number for mark in needed
        )

    def _is_after_alone(self, line: JudgedLine) -> bool:
        """Whether the angle after is worked out, and given as the deflection or put into it."""
        named = line.mistake is not None and line.mistake.id in OF_DEFLECTION
        return named and line.verdict == "false"

    def _is_tangent_after(self, line: JudgedLine) -> bool:
        """Whether the tangent of the angle after is given as that of the deflection: tan d = 3."""
        named = line.mistake is not None and line.mistake.id == "deflection-is-after"
        return named and any(is_function(x.readings[0].left, "tan") for x in line.line.links)

    def _joined(self, line: JudgedLine) -> JudgedLine:
        """A line that begins with a sign of equality, behind the chain above that it goes on."""
        above = self._line(line.line.number - 1)
        goes_on = line.line.text.lstrip().startswith("=") and bool(line.line.links)
        if not goes_on or above is None or above.verdict not in SOUND:
            return line
        above = self._joined(above)
        typed = replace(line.line, links=(*above.line.links, *line.line.links))
        return replace(line, line=typed, meant={**above.meant, **line.meant})

    def _is_quoted(self, line: JudgedLine) -> bool:
        """Whether a line gives a letter, in its first line, a value and no more.

        An energy is worked out where it is needed.
        """
        if not is_plain(line) or self._has_lost_law(line):
            return False
        if line.uses and line.uses[0].principle == "energy":
            return False
        lefts = {link.readings[0].left for link in line.line.links}
        above = [other for other in self.lines if other.line.number < line.line.number]
        return not any(
            tree in lefts
            for line in above
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for tree in walk(side)
        )

    def _roots(self, line: JudgedLine) -> list[JudgedLine]:
        """The false lines from which a line follows, over all lines between."""
        seen: set[int] = set()
        pending = list(line.sources)
        while pending:
            number = pending.pop()
            source = self._line(number)
            if number not in seen and source is not None:
                seen.add(number)
                pending += source.sources
        return [line for line in self.lines if line.line.number in seen and line.verdict == "false"]

    def _line(self, number: int | None) -> JudgedLine | None:
        return next((line for line in self.lines if line.line.number == number), None)

    def _is_withdrawn(self, lost: PointMark | None, seen: JudgedLine) -> bool:
        """Whether a component that is only seen is changed by a mistake in a line below."""
        line = None if lost is None else self._line(lost.line)
        if line is None or line.verdict != "false" or line.mistake is None:
            return False
        named = line.mistake.kind == "misconception"
        return named and line.line.number > seen.line.number

    def _is_exchanged(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a value only follows from a mistake by which no component stays as it is."""
        if point.principle != "unchanged" or line.verdict != "follows":
            return False
        if self.values.has_component(point, line):
            return False
        return any(
            named is not None and (named.mark_of("unchanged") or "")[:2] == "B0"
            for root in self._roots(line)
            if root.mistake is not None and root.mistake.kind != "slip"
            for named in map(MISCONCEPTIONS.get, _names_of(root))
        )

    def _is_taken(self, line: JudgedLine, use: Use, point: MarkPoint) -> bool:
        """Whether the impulse on one sphere has earned its own point, where momentum is another.

        The impulses on both spheres are as good as one of them and momentum.
        """
        if point.principle != "momentum" or use.principle != "impulse":
            return False
        own = {x.bodies for x in (*line.uses, *line.stated) if x.principle == "impulse"}
        earned = (
            self._line(mark.line)
            for mark in self.states.values()
            if mark.state == "earned" and mark.point.principle == "impulse"
        )
        return len(own) < 2 and any(
            other is line or any(x.principle == "impulse" and x.bodies in own for x in other.uses)
            for other in earned
            if other is not None
            and not (other.verdict == "false" and self._is_of_other_body(other, line))
        )

    def _is_of_other_body(self, one: JudgedLine, other: JudgedLine) -> bool:
        """Whether two lines each have velocities of bodies that the other has not."""
        bodies = self.values.bodies_in(one), self.values.bodies_in(other)
        return all(bodies) and bodies[0].isdisjoint(bodies[1])

    def _is_of_other(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether an impulse is the change of another body, where that of this one is wrong.

        It stands for momentum then.
        """
        bodies = self.values.bodies_in(line)
        if not (bodies and point.bodies) or bodies & set(point.bodies) or not is_sound(line):
            return False
        return any(
            other.verdict == "false"
            and any(use.principle == "impulse" for use in fitting_uses(other))
            and self.values.bodies_in(other) & set(point.bodies)
            for other in self.lines
        )

    def _is_of_other_point(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether an impulse is the change of another body, for which another point is given."""
        bodies = self.values.bodies_in(line)
        return not bodies & set(point.bodies) and any(
            (other.principle, other.event) == (point.principle, point.event)
            and bodies & set(other.bodies)
            for other in self.scheme.points
        )

    def _same(self, point: MarkPoint) -> JudgedLine | None:
        """A true line with the coordinate that a distance which is asked for is equal to."""
        if point.shown or not self.values.is_distance(point):
            return None
        alike = [
            other
            for other in self.scheme.points
            if other.id in point.depends and self.values.are_as_much(point, other)
        ]
        return next(
            (
                line
                for line in self.lines
                if line.verdict == "true"
                and line.grounded
                and any(self.values.matches(other, line) == "true" for other in alike)
            ),
            None,
        )

    def _lacks_an_end(self, point: MarkPoint, mark: PointMark) -> bool:
        """Whether a range is answered by one of its two ends alone, in all lines."""
        line = self._line(mark.line)
        if point.item is None or line is None or line.verdict != "true":
            return False
        return self.values.lacks_an_end(point, [x for x in self.lines if x.verdict in SOUND])

    def _unchanged_instead(self, point: MarkPoint) -> JudgedLine | None:
        """A true line with the component that stays, where the scheme has the other one alone."""
        if point.letter != "B" or any(
            (other.principle, other.event) == ("unchanged", point.event)
            for other in self.scheme.points
        ):
            return None
        return next(
            (
                line
                for line in self.lines
                if line.verdict == "true"
                and any((x.principle, x.event) == ("unchanged", point.event) for x in line.stated)
            ),
            None,
        )

    def _spoils_laws(self, point: MarkPoint, root: JudgedLine) -> bool:
        """Whether no equation of a law is right below a mistake: a component, or sine for cosine.

        At a wall what is exchanged in one component is so in the other.
        """
        exchanged = root.mistake is not None and root.mistake.id == "sine-cosine"
        at_a_wall = exchanged and self.values.is_at_a_wall(point)
        return at_a_wall or self._resolves(root)

    def _is_at_own_line(self, line: JudgedLine) -> bool:
        """Whether all that is wrong with a law is the angle of the line of centres above it."""
        roots = self._roots(line)
        return bool(roots) and all(map(self.values.is_of_geometry, roots))

    def _resolves(self, line: JudgedLine) -> bool:
        """Whether a line works out a component of what is given: ``8 cos 60 = 4√3``."""
        if line.link is None or line.link >= len(line.line.links):
            return False
        claim = line.line.links[line.link].readings[0]
        known = not self.values.velocities_in(claim, line)
        return known and any(is_function(node, "sin", "cos") for node in walk(claim.left))

    def _is_turned(self, line: JudgedLine) -> bool:
        """Whether an inequality only follows from one that is false, and has no sign of its own."""
        return line.verdict == "follows" and any(
            {link.readings[0].sign for link in root.line.links} - {"=", "!="}
            for root in self._roots(line)
        )

    def _is_answered_wrongly(self, point: MarkPoint) -> bool:
        """Whether a false line gives the answer for which a method is."""
        answers = [other for other in self.scheme.points if point.id in other.depends]
        return any(
            line.verdict == "false" and self.values.matches(answer, line) is not None
            for answer in answers
            for line in self.lines
        )

    def _in_a_sum(self, point: MarkPoint) -> JudgedLine | None:
        """A line that puts angles together wrongly, with the angle of a point among them."""
        if point.principle != "angle" or point.shown:
            return None
        remark = next((line for line in self.lines if self.values.names_angle(point, line)), None)
        return remark or next(
            (
                line
                for line in self.lines
                if line.verdict == "false"
                and line.mistake is not None
                and line.mistake.id in OF_DEFLECTION
                and self.values.adds_angle(point, line)
            ),
            None,
        )

    def _in_squares(self, point: MarkPoint, lost: PointMark | None) -> JudgedLine | None:
        """A true line in which the energy that is given stands by the squares of speeds alone."""
        if point.principle not in ("energy", "condition") or lost is not None:
            return None
        true = (line for line in self.lines if line.verdict == "true" and line.grounded)
        return next((line for line in true if self.values.puts_in_energy(line)), None)

    def _of_difference(self, point: MarkPoint) -> PointMark | None:
        """A speed by a difference of squares, or with none, which is no theorem of Pythagoras."""
        if point.principle != "speed" or self._has_true_line(point):
            return None
        wrong = next(
            (
                x
                for x in self.lines
                if (subtracts_squares(x) and self.values.is_of_a_speed(x))
                or self.values.lacks_squares(point, x)
            ),
            None,
        )
        why = "the squares of the components are added"
        return None if wrong is None else PointMark(point, "lost", wrong.line.number, why)


def _is_ratio_of_angle(point: MarkPoint) -> bool:
    """Whether a point is for the cosine or the tangent of which an angle that is asked is found."""
    return point.letter == "A" and point.item is None and point.principle in OF_ANGLES


def _is_of_a_law(point: MarkPoint) -> bool:
    """Whether a point is for the method of a law, or an impulse, or for an equation of a law."""
    if point.letter == "M":
        return point.principle in LAWS
    return point.equation and point.principle in LAWS


def is_ratio_of_angle(tree: Expression) -> bool:
    """Whether a tree is the cosine or the tangent of an angle that a velocity makes."""
    return is_function(tree, *TRIGONOMETRIC) and is_quantity(tree.argument, *ANGLES)


def has_name(line: JudgedLine) -> bool:
    """Whether the mistake of a line is a misconception that has a name."""
    mistake = line.mistake
    return mistake is not None and mistake.kind == "misconception" and mistake.id is not None


def _names_of(line: JudgedLine) -> tuple[str, ...]:
    """The name of a mistake, or those of the altered laws that a line without a name fits."""
    if line.mistake is not None and line.mistake.id is not None:
        return (line.mistake.id,)
    altered = (use.altered for use in fitting_uses(line))
    return tuple(name.partition("/")[0] for name in altered if name)


def is_of_plain_mistake(line: JudgedLine, use: Use) -> bool:
    """Whether a line with a mistake about a deflection only happens to fit an altered law."""
    named = line.mistake is not None and line.mistake.id in OF_DEFLECTION
    return named and use.altered is not None and use.principle in LAWS


def is_for_an_angle(point: MarkPoint) -> bool:
    """Whether a point is for the method by which an angle is found."""
    return point.letter == "M" and point.principle in ("angle", "deflection")


def is_inequality(point: MarkPoint) -> bool:
    """Whether a point is for an inequality, which no value of a letter is."""
    return point.link is not None and point.link.sign in FLIPPED
