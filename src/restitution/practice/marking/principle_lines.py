"""The lines of a working that use the principle of a point, and what a mistake in them costs."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.expression.tree import COMPONENTS, is_quantity, walk
from restitution.practice.judgement import JudgedLine, Use
from restitution.practice.marking.grounds import (
    LAWS,
    Grounds,
    is_inequality,
    is_of_plain_mistake,
)
from restitution.practice.marking.lines import SOUND, fitting_uses, is_plain, is_sound
from restitution.practice.marking.marks import PointMark
from restitution.practice.marking.scheme import MarkPoint

_UNSURE = ("asks", "unread")

# The words of verdicts for the principle of a point, where they are several.
_NAMES: Mapping[str, tuple[str, ...]] = {
    "momentum": ("momentum", "impulse"),
    "velocity": ("velocity", "component"),
    "speed": ("speed", "energy"),
    "angle": ("angle", "direction"),
    "scalar-product": ("scalar-product", "deflection"),
    "fact": ("fact", "energy", "angle", "deflection", "speed"),
    "solve": ("solve", "value"),
}


class PrincipleLines(Grounds):
    """The lines of a working, and which principles they use, at which event and of which body."""

    def _uses(self, point: MarkPoint) -> Iterator[tuple[JudgedLine, Use]]:
        """The lines that use a point's principle, those that hold first."""
        for sound in (True, False):
            for line in self.lines:
                if is_sound(line) is not sound or line.verdict == "unsupported":
                    continue
                if self.values.is_formula(line):
                    continue
                use = self._use(line, point)
                if use is None or self._is_by_chance(line, use) or is_of_plain_mistake(line, use):
                    continue
                if self._is_of_vectors(point, line):
                    continue
                if self._is_stated_wrongly(line, use, point) or self._is_taken(line, use, point):
                    continue
                yield line, use

    def _is_by_chance(self, line: JudgedLine, use: Use) -> bool:
        """Whether what follows from a mistake only happens to fit another altered law.

        So it does where the law itself is stated, wrongly, in a line above.
        """
        if line.verdict != "follows" or not use.altered:
            return False
        solved = use.principle != "energy" and self.values.is_solved(line)
        return solved or any(
            other.verdict == "false"
            and other.line.number < line.line.number
            and any(
                (own.principle, own.event) == (use.principle, use.event)
                for own in fitting_uses(other)
            )
            for other in self.lines
        )

    def _is_stated_wrongly(self, line: JudgedLine, use: Use, point: MarkPoint) -> bool:
        """Whether a line only implies a law, or follows, that a line above states wrongly.

        The impulse on one sphere, or its change of velocity, implies no momentum of two, and
        components imply no law that is stated wrongly below them.
        """
        law = point.principle
        if law not in (*LAWS, "impulse") or use.altered is not None or line.verdict == "false":
            return False
        stated = line.uses[0].principle == law or law == "impulse"
        of_one = law == "momentum" and line.verdict == "true"
        of_one = of_one and len(self.values.bodies_in(line)) == 1
        if (
            stated
            and not of_one
            and (line.verdict != "follows" or self._is_vector_law(point, line))
        ):
            return False
        return any(
            other.verdict in ("false", "follows")
            and any(
                own.principle == law and own.event in (None, use.event) and own.altered
                for own in fitting_uses(other)[:1]
            )
            for other in self.lines
            if other.line.number < line.line.number or of_one or is_of_what_stays(line)
        )

    def _use(self, line: JudgedLine, point: MarkPoint) -> Use | None:
        """The use of the point's principle in a line, at its event and for its bodies."""
        names = _NAMES.get(point.principle, (point.principle,))
        implied = line.verdict == "true" and not self.values.is_solved(line)
        for place, use in enumerate(fitting_uses(line)):
            if use.principle not in names:
                continue
            bare = place and use not in line.stated
            known = use.altered is None and use.principle in LAWS
            own = line.verdict == "follows" and not self.values.is_at_a_wall(point)
            own = own and self.values.tells_coefficient(line)
            if bare and known and not (implied or own):
                continue  # a bare value states no law
            if known and line.verdict == "false" and is_plain(line):
                continue  # nor does a wrong one
            if place and line.uses[0].principle == "fact" and not self.values.has_coefficient(line):
                continue  # a fact of the question needs no law
            if point.principle == "fact" and not self.values.speaks_of(point, use.principle):
                continue
            if point.principle == "fact" and line.verdict == "follows":
                nothing = use.event is None and not use.bodies
                if nothing or is_plain(line):
                    continue  # a value that follows states no fact
            if point.principle == "solve" and is_of_what_stays(line):
                continue
            if use.principle == "component" and self._is_no_component_of(point, line):
                continue
            if point.event is not None and use.event not in (None, point.event):
                continue
            if use.altered is None and self.values.lacks_coefficient(point, line):
                continue  # what is known of velocities tells nothing of an unknown e
            if point.principle == "energy" and self.values.is_of_the_start(line):
                continue  # a change needs the energy after as well
            if self._is_of_another(point, line):
                continue
            if point.principle == "speed" and self.values.is_of_the_start(line):
                continue  # the speed before is another one
            by_energy = (point.principle, use.principle) == ("speed", "energy")
            own_speed = line.verdict == "false" and self.values.is_of_a_speed(line)
            if by_energy and not own_speed and self._is_answered_wrongly(point):
                continue  # an energy from the components that change needs no speed
            own = point.principle in ("unchanged", "impulse", "speed", "angle", "deflection")
            if own and use.bodies and point.bodies and not set(use.bodies) & set(point.bodies):
                continue
            if use.principle == point.principle == "impulse" and (
                self._is_of_other(point, line) or self._is_of_other_point(point, line)
            ):
                continue
            return use
        return None

    def _is_of_another(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line speaks of the angle of another point, and not of that of this one."""
        if point.principle != "angle" or self.values.speaks_for(point, line):
            return False
        return any(
            self.values.speaks_for(other, line)
            for other in self.scheme.points
            if other.principle == "angle" and other.link != point.link
        )

    def _with_mistake(self, line: JudgedLine, use: Use) -> tuple[bool, str]:
        """Whether a false line of a principle keeps its method, and why."""
        mistake = line.mistake
        name = (use.altered or "").partition("/")[0] or (mistake.id if mistake else None)
        above = [root.mistake.id for root in self._roots(line) if root.mistake is not None]
        root = MISCONCEPTIONS.get(above[0] or "") if len(above) == 1 else None
        if line.verdict == "follows" and root is not None and root.mark_of(use.principle):
            name = above[0]  # what follows from one mistake has no other
        if mistake is not None and mistake.id is None and len(mistake.also) > 1:
            # Of several that it may be, one that keeps the method speaks for the student.
            kept_by = (x for x in mistake.also if _keeps(x, use))
            name = next(kept_by, name)
        named = MISCONCEPTIONS.get(name or "")
        if named is not None:
            rule = named.mark_of(use.principle) or "M0"
            kept = rule.startswith("M1") and not self._is_resolved_elsewhere(name, use)
            return kept, f"{named.title[0].lower()}{named.title[1:]}" + (
                "; the method stands" if kept else ""
            )
        if mistake is not None and mistake.kind == "slip":
            return True, "all terms are there; a slip keeps the method"
        return False, "not an instance of the law"

    def _in_a_law(self, point: MarkPoint) -> JudgedLine | None:
        """A false line that gives an answer by a law, and keeps the method of that law.

        So it is where a part uses a condition that is the law with values put in.
        """
        if point.principle != "condition" or is_inequality(point):
            return None
        answers = [other for other in self.scheme.points if point.id in other.depends]
        return next(
            (
                line
                for line in self.lines
                if line.verdict == "false"
                and any(self.values.matches(answer, line) is not None for answer in answers)
                and any(
                    use.principle in LAWS and self._with_mistake(line, use)[0] for use in line.uses
                )
            ),
            None,
        )

    def _with_component(self, point: MarkPoint) -> JudgedLine | None:
        """A sound line that gives the one component which the equation of a condition decides.

        So it is where a part goes on from what an earlier one has shown, put into a law. For an
        impulse the component of the other body does as well.
        """
        link = point.link
        if link is None or link.sign != "=":
            return None
        parts = {
            part
            for side in (link.left, link.right)
            for part in walk(side)
            if is_quantity(part, *COMPONENTS)
        }
        if len(parts) != 1:
            return None
        part = parts.pop()
        of_either = any(other.principle == "impulse" for other in self.scheme.points)
        others = self.values.others_at_impact(part) if of_either else ()
        wanted = [replace(point, link=replace(link, left=x)) for x in (part, *others)]
        lines = [line for line in self.lines if line.verdict in SOUND]
        return next((x for own in wanted for x in lines if self._is_matched(own, x)), None)

    def _by_angle_of_line(self, point: MarkPoint) -> JudgedLine | None:
        """The true line that gives the angle of a line of centres, where its direction is right."""
        link = point.link
        if link is None or point.principle != "fact" or point.letter != "A":
            return None
        if not is_quantity(link.left, "line_of_centres") or point.item is not None:
            return None
        methods = (self.states[x] for x in point.depends if x in self.states)
        lines = (self._line(mark.line) for mark in methods if mark.state == "earned")
        return next(
            (
                line
                for line in lines
                if line is not None and line.verdict == "true" and line.grounded
                if line.uses and line.uses[0].principle == "angle"
            ),
            None,
        )

    def _is_resolved_elsewhere(self, name: str | None, use: Use) -> bool:
        """Whether sine and cosine are exchanged in Newton's law alone.

        Beside a right equation of momentum, or a right component along a wall, that is no slip.
        """
        if name != "sine-cosine" or use.principle != "restitution":
            return False
        # Of spheres a component across the line of centres may be called one along it.
        at_a_wall = any(
            point.principle == "restitution" and point.event == use.event
            for point in self.scheme.points
            if self.values.is_at_a_wall(point)
        )
        return any(
            line.verdict == "true"
            and own.altered is None
            and own.event == use.event
            and own.principle == ("unchanged" if at_a_wall else "momentum")
            and line.uses[0] == own
            for line in self.lines
            for own in line.uses
        )

    def _reason(self, line: JudgedLine) -> str:
        mistake = line.mistake
        if mistake is None or mistake.id is None:
            return "not true"
        named = MISCONCEPTIONS.get(mistake.id)
        if named is not None:
            return f"{named.title[0].lower()}{named.title[1:]}"
        return f"a slip ({mistake.id})"

    def _earned(self, point: MarkPoint, line: JudgedLine, why: str) -> PointMark:
        return PointMark(point, "earned", line.line.number, why)

    def _missing(self, point: MarkPoint) -> PointMark:
        """A lost point; an open one where a line that cannot be judged may earn it."""
        unsure = next((line for line in self.lines if line.verdict in _UNSURE), None)
        if unsure is None:
            return PointMark(point, "lost", None, "not seen")
        return PointMark(point, "open", unsure.line.number, "a line could not be judged")


def _keeps(mistake: str, use: Use) -> bool:
    """Whether a misconception keeps the method of a principle."""
    named = MISCONCEPTIONS.get(mistake)
    return named is not None and (named.mark_of(use.principle) or "M0").startswith("M1")


def is_of_what_stays(line: JudgedLine) -> bool:
    """Whether a line has a component that stays, or one before, for which nothing is solved."""
    return bool(line.uses) and line.uses[0].principle in ("unchanged", "component")
