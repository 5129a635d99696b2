"""What lines show of directions: vectors along which something points, and words for them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Link
from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    Unit,
    has_unit_vector,
    is_binary,
    is_function,
    is_quantity,
    quantities_in,
    walk,
)
from restitution.practice.judgement import JudgedLine
from restitution.practice.marking.line_contents import LineContents, place_in
from restitution.practice.marking.lines import SOUND, chains
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.marking.sides import names_in
from restitution.practice.worlds.agreement import agrees
from restitution.problem import Aligned, Show
from restitution.records import dataclass

_SECONDS = re.compile(r"\d\s*(?:s|secs?|seconds?)\b")
_EQUAL = re.compile(r"\b(equal|same)\b", re.IGNORECASE)
_CONCLUSIONS: Mapping[str, re.Pattern[str]] = {
    "opposite to": re.compile(r"\b(opposite|anti-?parallel|reversed?|back)\b", re.IGNORECASE),
    "perpendicular to": re.compile(r"\b(perp\w*|right angles?)\b", re.IGNORECASE),
    "parallel to": re.compile(r"\b(parallel|direction|along|line of centres|loc)\b", re.IGNORECASE),
}


@dataclass(frozen=True, eq=False)
class Directions(LineContents):
    """What lines show of velocities, places and directions without an equation for them."""

    def is_velocity(self, point: MarkPoint) -> bool:
        """Whether a point is for a velocity."""
        left = point.link.left if point.link is not None else None
        return is_quantity(left, "velocity") and not point.shown

    def is_slanted(self, point: MarkPoint) -> bool:
        """Whether a point is for a velocity along neither axis, of a question in i and j.

        Its component along another line is not the velocity yet.
        """
        link = point.link
        if link is None or not is_quantity(link.left, "velocity") or not _is_slanted(link.right):
            return False
        problem = self.worlds[0].problem
        given = [sphere.velocity for sphere in problem.spheres]
        return any(isinstance(tree, Expression) and has_unit_vector(tree) for tree in given)

    def shows(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the value of a velocity stands in a remark: ``so both 0.6i + j``."""
        link = point.link
        if link is None:
            return False
        if self._tells_slope(link, line):
            return True
        if self.is_direction(point):
            return line.verdict in ("true", "remark") and any(
                self._is_angle(value, link.left, line) or self._is_towards(value, link, line)
                for value in line.line.values
            )
        if link.sign == "parallel to":
            method = point.letter == "M"
            vectors = (*line.line.values, *_vectors_of(line, whole=method))
            # A change of velocity without the mass has the direction of the impulse.
            massless = method and line.mistake is not None and line.mistake.id == "mass-omitted"
            return (massless or line.verdict in (*SOUND, "remark")) and any(
                self._is_towards(value, link, line) for value in vectors
            )
        if self.is_time(point) and not _SECONDS.search(line.line.text):
            return False
        place = place_in(link.left)
        return line.verdict == "remark" and any(
            self._is_worth(value, link.left, line)
            or (place is not None and self._has_part(value, place, point, line))
            for value in line.line.values
        )

    def _is_towards(self, value: Expression, link: Link, line: JudgedLine) -> bool:
        """Whether a vector has the direction that a relation gives."""
        if link.sign != "parallel to":
            return False
        return self._is_parallel(value, link.right, self._meanings(line), line)

    def is_of_direction(self, line: JudgedLine) -> bool:
        """Whether a line says along which vector a wall, or a line of centres, lies."""
        return any(
            link.readings[0].left == Number(Fraction(0))
            and is_quantity(link.readings[0].right, *COMPONENTS)
            and is_quantity(link.readings[0].right.arguments[1], "line_of_centres")
            for link in line.line.links
        )

    def _tells_slope(self, link: Link, line: JudgedLine) -> bool:
        """Whether a true line gives the gradient of the line that is asked, or its angle to i."""
        if line.verdict != "true" or not is_quantity(link.left, "direction", "line_of_centres"):
            return False
        meanings = self._meanings(line)
        own = {node for node in walk(link.left) if isinstance(node, Name)}
        for chain in chains(line):
            left = chain[0].left
            meant = meanings.get(left.name, left) if isinstance(left, Letter) else left
            nodes = tuple(walk(meant))
            of_line = any(is_quantity(node, "line_of_centres") for node in nodes)
            of_line = of_line or (bool(own) and own <= set(nodes))
            to_axis = any(isinstance(node, Unit) for node in nodes)
            moving = any(is_quantity(node, "velocity") for node in nodes)
            if of_line and to_axis and not moving and not any(names_in(chain[-1].right)):
                return True
        return False

    def words_of_direction(self, point: MarkPoint) -> re.Pattern[str] | None:
        """The words in which a student concludes what is printed of a direction."""
        if point.link is None or not point.shown:
            return None
        right = point.link.right
        aligned = (
            isinstance(step, Show) and isinstance(step.relation, Aligned)
            for _, step in self.worlds[0].problem.steps()
        )
        ahead = point.link.sign == "=" and any(x.kind == "velocity" for x in quantities_in(right))
        if ahead and any(aligned):
            turned = any(isinstance(node, Negate) for node in walk(right))
            return _CONCLUSIONS["opposite to" if turned else "parallel to"]
        if point.link.sign == "=" and isinstance(right, Binary):
            unit = has_unit_vector(point.link.right)
            vector = is_quantity(point.link.left, "impulse")
            return _CONCLUSIONS["parallel to"] if unit and vector else None
        return _CONCLUSIONS.get(point.link.sign)

    def words_of_equality(
        self, point: MarkPoint, lines: Iterable[JudgedLine]
    ) -> re.Pattern[str] | None:
        """The words in which two quantities of one kind are concluded to be equal.

        None where true ``lines`` do not give a value to each of them.
        """
        link = point.link
        if link is None or not point.shown or link.sign != "=":
            return None
        both = link.left, link.right
        kinds = {side.kind if isinstance(side, Quantity) else None for side in both}
        if len(kinds) > 1 or None in kinds:
            return None
        true = [line for line in lines if line.verdict == "true"]
        given = all(
            any(
                self._names(chain[0].left, side, self._meanings(line), line)
                for line in true
                for chain in chains(line)
            )
            for side in both
        )
        return _EQUAL if given else None

    def is_pointing(self, point: MarkPoint) -> bool:
        """Whether a point is for the vector along which something points."""
        return point.link is not None and point.link.sign == "parallel to" and not point.shown

    def is_time(self, point: MarkPoint) -> bool:
        """Whether a point is for a time."""
        left = point.link.left if point.link is not None else None
        return is_quantity(left, "time") and not point.shown

    def is_direction(self, point: MarkPoint) -> bool:
        """Whether a point is for a direction."""
        left = point.link.left if point.link is not None else None
        return is_quantity(left, "direction") and not point.shown

    def mentions(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the angle of a point stands anywhere in a line, by whatever it is called."""
        return self._is_named(point, line, walk)

    def _is_named(
        self,
        point: MarkPoint,
        line: JudgedLine,
        parts: Callable[[Expression], Iterable[Expression]],
    ) -> bool:
        """Whether one of the ``parts`` of a side names what a point is for, or its angle."""
        link = point.link
        if link is None:
            return False
        meanings = self._meanings(line)
        angle = link.left.argument if isinstance(link.left, Apply) else link.left
        return any(
            self._names(part, tree, meanings, line)
            for chain in chains(line)
            for claim in chain
            for side in (claim.left, claim.right)
            for part in parts(side)
            for tree in dict.fromkeys((link.left, angle))
        )

    def turns_by(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the sum of angles that is a deflection stands in a line: ``tan(α + β) = …``."""
        turn = None if point.link is None else point.link.left
        meanings = self._meanings(line)
        return is_quantity(turn, "deflection") and any(
            is_binary(node, "+", "-")
            and any(self._changes(name, meanings, line) for name in names_in(node))
            and self._is_worth(node, turn, line)
            for chain in chains(line)
            for claim in chain
            for side in (claim.left, claim.right)
            for node in walk(side)
        )

    def is_size_of_impulse(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives the vector of an impulse along its line: ``I = 2(-1 - 4) = -10``."""
        asked = None if point.link is None else point.link.left
        if not is_quantity(asked, "impulse") or not asked.arguments:
            return False
        meanings = self._meanings(line)
        return any(
            isinstance(left, Letter)
            and any(x.kind == "impulse" for x in quantities_in(meanings.get(left.name, left)))
            and self._is_worth(Apply("abs", left), Apply("abs", asked), line)
            for chain in chains(line)
            for left in (chain[0].left,)
        )

    def is_upside_down(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line has the angle of a point by a tangent that is upside down."""
        asked = None if point.link is None else point.link.left
        asked = asked.argument if is_function(asked, "tan") else asked
        if not is_quantity(asked, *ANGLES) or line.verdict != "false":
            return False
        meanings = self._meanings(line)
        for link in line.line.links:
            for claim in link.readings:
                own = claim.left.argument if is_function(claim.left, "tan") else claim.left
                sides = (claim.left, claim.right)
                by_tangent = any(
                    is_function(x, "tan", "arctan") for side in sides for x in walk(side)
                )
                if not by_tangent or not self._names(own, asked, meanings, line):
                    continue
                other = exchanged(claim.left, {own: Binary("-", RIGHT_ANGLE, own)})
                turned = replace(claim, left=other)
                try:
                    if agrees(turned, self._base, meanings, link.decimals, line.line.scope):
                        return True
                except RestitutionError:
                    continue
        return False

    def points_along(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line takes a component along the direction that a point is for."""
        link = point.link
        if link is None or link.sign != "parallel to" or line.verdict != "true":
            return False
        meanings = self._meanings(line)
        return any(
            self._is_parallel(vector, link.right, meanings, line)
            for other in line.line.links
            for side in (other.readings[0].left, other.readings[0].right)
            for product in quantities_in(side)
            if product.kind == "dot"
            for vector in product.arguments
        )


def _vectors_of(line: JudgedLine, *, whole: bool) -> Iterator[Expression]:
    """The vectors that a line declares, and those of which it has a multiple: ``w(3i + 4j)/5``.

    One along i or j is none, as each vector is a sum of these. With ``whole`` a side may be such a
    vector itself: a change of velocity is the method for its direction.
    """
    for declared in line.line.declarations:
        yield from (tree for tree in declared.meanings if _is_slanted(tree))
    for link in line.line.links:
        for side in (link.readings[0].left, link.readings[0].right):
            yield from (
                tree for tree in _factors(side) if _is_slanted(tree) and (whole or tree != side)
            )


def _factors(tree: Expression) -> Iterator[Expression]:
    """The factors of a product or a quotient."""
    if is_binary(tree, "*", "/"):
        yield from _factors(tree.left)
        yield from _factors(tree.right)
    elif isinstance(tree, Negate):
        yield from _factors(tree.operand)
    else:
        yield tree


def _is_slanted(tree: Expression) -> bool:
    """Whether a vector in numbers is along neither i nor j."""
    axes = {node.axis for node in walk(tree) if isinstance(node, Unit)}
    known = not any(isinstance(node, Letter | Quantity) for node in walk(tree))
    return known and (len(axes) > 1 or isinstance(tree, Pair))
