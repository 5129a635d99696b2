"""What lines of a script name, list or put together, as the points of a scheme need it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import permutations
from typing import Literal

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ENERGIES, LOSSES
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Pair,
    Quantity,
    Unit,
    has_unit_vector,
    is_binary,
    is_function,
    is_quantity,
    letters,
    quantities_in,
    walk,
)
from restitution.practice.judgement import JudgedLine
from restitution.practice.marking.lines import chains
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.marking.sides import (
    Sides,
    are_close,
    is_fine,
    is_zero,
    spread_of,
)
from restitution.practice.reading.vocabulary import HEADS
from restitution.practice.worlds.arrays import UnvaluedError, is_bare
from restitution.problem import Compare, Given, Impact
from restitution.records import dataclass
from restitution.vector import Vector

_ROUNDED = 0.006
"""What a student's own rounding may move a value by."""
Match = Literal["true", "own"]
_WORD = re.compile(r"[A-Za-z]{2,}")
_UNITS = re.compile(
    r"m\s?s\^?-1|ms⁻¹|N\s?s|kg|deg(?:rees)?|and|sqrt|\b(?:so|hence|thus|therefore|ans(?:wer)?)\b",
    re.IGNORECASE,
)


def _is_multiple_of_coefficient(tree: Expression, unknown: frozenset[str]) -> bool:
    """Whether a tree is a number times a coefficient that is not known."""
    match tree:
        case Binary("*", number, Letter(name)) | Binary("*", Letter(name), number):
            return name in unknown and name.startswith("e") and is_bare(number)
    return False


def _is_of_velocity(point: MarkPoint) -> bool:
    """Whether a point is for a velocity."""
    left = point.link.left if point.link is not None else None
    return is_quantity(left, "velocity") and not point.shown


def _is_sum_of_vectors(tree: Expression) -> bool:
    """Whether a multiple of a vector in brackets is added: ``4i + 3j - 2(3i - 4j)/5``."""
    if not is_binary(tree, "+", "-"):
        return False
    products = (node for node in walk(tree) if is_binary(node, "*", "/"))
    return any(_is_sum(part) for product in products for part in walk(product))


def _is_sum(tree: Expression) -> bool:
    """Whether vectors are added up."""
    return is_binary(tree, "+", "-") and has_unit_vector(tree)


def place_in(tree: Expression) -> Quantity | None:
    """The place of which a tree is, or has a coordinate."""
    inside = tree.arguments[0] if is_quantity(tree, "along") else tree
    return inside if is_quantity(inside, "position") else None


_ANGLE = re.compile(r"\bangles?\b|°|\bdeg", re.IGNORECASE)
_BEFORE_AND_AFTER = re.compile(
    r"\s*(?:angles?\s+)?before\W+[\d.]+°?\W+(?:and\s+)?after\W+[\d.]+°?\s*", re.IGNORECASE
)
_PARTS = re.compile(r"\b(?:parts?|bits?|components?|comps?|resolv\w+)\b", re.IGNORECASE)


_NUMBER_AND_WORD = re.compile(
    r"(?<![\w.√/])(\d+)\s*(?:m/s\s*)?(?:is\s+)?(perp|normal|into\b)"
    r"|\b(perp\w*|normal|into)\b\W*(\d+)(?![\w.√/])",
    re.IGNORECASE,
)


_LISTED = re.compile(r"\b(before|after)\s*[:=]?\s*(\d+)(?![\w.√/])", re.IGNORECASE)


def listed_numbers(text: str, *, before: bool) -> frozenset[int]:
    """The whole numbers that a remark lists as components before or after: ``before 9``."""
    word = "before" if before else "after"
    return frozenset(int(own) for at, own in _LISTED.findall(text) if at.lower() == word)


def numbers_into_a_wall(text: str, *, before: bool) -> frozenset[int]:
    """The whole numbers that a remark calls components at right angles to a wall: ``2 perp``.

    What goes *into* it is one ``before`` the impact.
    """
    matches = _NUMBER_AND_WORD.findall(text)
    pairs = [(one or other, (word or label).lower()) for one, word, label, other in matches]
    return frozenset(int(number) for number, word in pairs if before or word != "into")


def sizes_of(quantity: Quantity) -> tuple[Quantity, ...]:
    """A quantity; for a scalar product the component along its second vector as well."""
    if quantity.kind != "dot":
        return (quantity,)
    return quantity, replace(quantity, kind="along")


@dataclass(frozen=True, eq=False)
class LineContents(Sides):
    """What lines name of spheres and coefficients, list as answers, and add up."""

    def lacks_coefficient(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a point is for the law with a coefficient to be found, and a line is without it.

        Without it nothing is said of the law, but of velocities that are known.
        """
        events = self._base.events
        if point.principle != "restitution" or point.event is None or point.event > len(events):
            return False
        step = events[point.event - 1]
        e = step.e if isinstance(step, Impact) and step.e is not None else Letter("e")
        if not isinstance(e, Letter) or e.name not in self.unknown:
            return False
        meanings = self._meanings(line)
        sides = [
            side
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
        ]
        return not any(
            meanings.get(name, Letter(name)) in (e, Quantity("restitution", (), point.event))
            for tree in (*sides, *line.line.values)
            for name in letters(tree)
        )

    def carries_of_other(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a true line gives the speed of a sphere other than that of a point.

        It has a component that stays as well, for which there is no point.
        """
        link = point.link
        if link is None or point.principle != "unchanged" or line.verdict != "true":
            return False
        part = link.left
        velocity = next((x for x in quantities_in(part) if x.kind == "velocity"), None)
        if velocity is None or point.event is None or not is_quantity(part, *COMPONENTS):
            return False
        for body in self.bodies_in(line) - set(point.bodies):
            own = replace(velocity, arguments=(Name(body),))
            staying = replace(part, arguments=(own, *part.arguments[1:]))
            given = self.value_of(replace(own, kind="speed"), line) is not None
            if given and not is_zero(self._base, self._base.value(staying)):
                return True
        return False

    def has_speeds(self, line: JudgedLine) -> bool:
        """Whether a letter for a speed after an impact is in a line, or for an angle after it.

        ``v cos 75 = u cos 45``, ``5 cos b = 10 cos 55``.
        """
        meanings = self._meanings(line)
        return any(
            is_quantity(
                meanings.get(own.name, own) if isinstance(own, Letter) else own, "speed", "angle"
            )
            for chain in chains(line)
            for claim in chain
            for own in self.velocities_in(claim, line)
        )

    def has_rebound(self, line: JudgedLine) -> bool:
        """Whether a line has e and, but for an impulse, nothing else that an impact decides."""
        meanings = self._meanings(line)
        meant = (meanings.get(getattr(tree, "name", ""), tree) for tree in self.unknowns(line))
        impulses = all(tree == Letter("e") or is_quantity(tree, "impulse") for tree in meant)
        return impulses and any(
            node == Letter("e")
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for node in walk(side)
        )

    def has_coefficient(self, line: JudgedLine) -> bool:
        """Whether a coefficient of restitution stands in a line, by its letter or its value."""
        given = {Letter("e")} | {
            step.e for step in self._base.events if isinstance(step, Impact) and step.e is not None
        }
        numbers = {float(self._base.scalar(tree).flat[0]) for tree in given if is_bare(tree)}
        squares = {number**2 for number in numbers}
        return any(
            node in given or (is_bare(node) and self._is_one_of(node, numbers | squares))
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for node in walk(side)
        )

    def tells_coefficient(self, line: JudgedLine) -> bool:
        """Whether a line is Newton's law in numbers, with an e to be found: ``8 = 8e``."""
        return any(
            claim.sign == "=" and is_bare(one) and _is_multiple_of_coefficient(other, self.unknown)
            for chain in chains(line)
            for claim in chain
            for one, other in ((claim.left, claim.right), (claim.right, claim.left))
        )

    def bodies_in(self, line: JudgedLine) -> frozenset[str]:
        """The bodies of which velocities after an impact stand in a line."""
        meanings = self._meanings(line)
        return frozenset(
            node.name
            for chain in chains(line)
            for claim in chain
            for own in self.velocities_in(claim, line)
            for node in walk(meanings.get(own.name, own) if isinstance(own, Letter) else own)
            if isinstance(node, Name)
        )

    def has_component_of(self, bodies: Sequence[str], line: JudgedLine) -> bool:
        """Whether a letter for a component of one of some bodies after an impact is in a line.

        Of any body, where none is named.
        """
        meanings = self._meanings(line)
        meant = (
            meanings.get(own.name, own) if isinstance(own, Letter) else own
            for chain in chains(line)
            for claim in chain
            for own in self.velocities_in(claim, line)
        )
        return any(
            self._is_component(tree)
            and any(
                isinstance(node, Name) and (not bodies or node.name in bodies)
                for node in walk(tree)
            )
            for tree in meant
        )

    def is_about_others(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line names a sphere of which a point says nothing, and not all of its own."""
        if point.link is None:
            return False
        own = {
            node.name
            for side in (point.link.left, point.link.right)
            for node in walk(side)
            if isinstance(node, Name)
        }
        named = {name for name in self._base.start if re.search(rf"\b{name}\b", line.line.text)}
        return bool(named - own) and not own <= named

    def lists(self, point: MarkPoint, line: JudgedLine, items: int) -> bool:
        """Whether a line has nothing but the values of all that is asked, in their order."""
        link = point.link
        if link is None or point.item is None or point.shown or line.verdict != "remark":
            return False
        if len(line.line.values) != items or _WORD.search(_UNITS.sub("", line.line.text)):
            return False
        value = line.line.values[point.item]
        rounded = isinstance(value, Number | Degrees) or any(map(is_fine, walk(value)))
        return self._is_worth(value, link.left, line) or (
            rounded and self._has_figures_of(value, link.left, line)
        )

    def has_component(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the component that a point is for stands in a line, by its value."""
        link = point.link
        sides = (side for chain in chains(line) for claim in chain for side in walk(claim.right))
        terms = {*sides, *line.line.values}
        return link is not None and any(
            self._is_worth(term, link.right, line) for term in terms if letters(term)
        )

    def has_whole_energy(self, line: JudgedLine) -> bool:
        """Whether a line has the kinetic energy of all before an impact: ``25 - 10 = 15``."""
        stages = [Quantity("energy", (), number) for number in range(len(self._base.events))]
        terms = {
            node
            for chain in chains(line)
            for claim in chain
            for node in walk(claim.right)
            if not isinstance(node, Letter)
        }
        return any(self._is_worth(term, energy, line) for term in terms for energy in stages)

    def relates(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a true line has the approach, or the separation, of which a component is part."""
        link = point.link
        if link is None or line.verdict != "true" or point.event is None:
            return False
        stages = {node.stage for node in quantities_in(link.left) if node.kind == "velocity"}
        head = "approach" if stages == {point.event - 1} else "separation"
        lefts = (chain[0].left for chain in chains(line))
        names = (left.name.split() for left in lefts if isinstance(left, Letter))
        return bool(stages) and any(head in map(HEADS.get, words) for words in names)

    def has_inequality(self, line: JudgedLine) -> bool:
        """Whether a line compares two values that need not be equal."""
        return any(link.readings[0].sign not in ("=", "!=") for link in line.line.links)

    def is_other_loss(self, asked: Expression, line: JudgedLine) -> bool:
        """Whether a line gives an energy lost, and not the one that is asked."""
        if not is_quantity(asked, *LOSSES) or not line.line.links:
            return False
        left = line.line.links[0].readings[0].left
        if not isinstance(left, Letter) or "loss" not in map(HEADS.get, left.name.split()):
            return False
        last = line.line.links[-1].readings[0].right
        return not self._is_worth(last, asked, line)

    def is_separation(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives the difference of two velocities after an impact a value."""
        meanings = self._meanings(line)
        for link in line.line.links:
            claim = link.readings[0]
            for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
                if not is_binary(one, "+", "-") or not self._is_value(other, meanings, line):
                    continue
                terms = [
                    meanings.get(x.name, x) if isinstance(x, Letter) else x
                    for x in (one.left, one.right)
                ]
                sizes = (self._is_component(x) or is_quantity(x, "speed") for x in terms)
                if not all(sizes):
                    continue
                bodies = {node.name for x in terms for node in walk(x) if isinstance(node, Name)}
                if bodies == set(point.bodies) and len(bodies) > 1:
                    return True
        return False

    def adds_up(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line puts together what a point is for, of parts of which one may be wrong.

        That is a sum of vectors for a velocity, of squares for a speed, a difference of energies.
        """
        link = point.link
        if point.principle == "speed":
            return self._adds_squares(point, line)
        if point.principle == "energy":
            return self._subtracts_energies(line)
        if link is None or not _is_of_velocity(point):
            return False
        meanings = self._meanings(line)
        return any(
            self._names(chain[0].left, link.left, meanings, line)
            and any(_is_sum_of_vectors(claim.right) for claim in chain)
            for chain in chains(line)
        )

    def is_of_an_angle(self, line: JudgedLine) -> bool:
        """Whether a line begins with the angle of a velocity to a line."""
        left = line.line.links[0].readings[0].left if line.line.links else None
        meant = self._meanings(line).get(left.name) if isinstance(left, Letter) else left
        return is_quantity(meant, "angle")

    def is_of_geometry(self, line: JudgedLine) -> bool:
        """Whether a line begins with the angle of a line of centres that an offset gives."""
        left = line.line.links[0].readings[0].left if line.line.links else None
        left = left.argument if isinstance(left, Apply) else left
        meant = self._meanings(line).get(left.name, left) if isinstance(left, Letter) else left
        of_line = meant is not None and any(is_quantity(x, "line_of_centres") for x in walk(meant))
        offset = (isinstance(x, Impact) and x.offset is not None for x in self._base.events)
        return of_line and any(offset)

    def _adds_squares(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line has a root of a sum for a speed, with the square of one component."""
        speed = None if point.link is None else point.link.left
        match speed:
            case Quantity("speed", (Name(),) as body, int(stage)) if stage:
                velocity = Quantity("velocity", body, stage)
            case _:
                return False
        axes = (Quantity("line_of_centres", (), stage), Unit("i"))
        parts = [Quantity(kind, (velocity, axis)) for kind in COMPONENTS for axis in axes]
        meanings = self._meanings(line)
        return any(
            self._is_nearly(exchanged(claim.right, {root: Apply("sqrt", term)}), part, line)
            for chain in chains(line)
            if self._names(chain[0].left, speed, meanings, line)
            for claim in chain
            for root in walk(claim.right)
            if is_function(root, "sqrt") and is_binary(root.argument, "+")
            for term in (root.argument.left, root.argument.right)
            for part in parts
        )

    def _subtracts_energies(self, line: JudgedLine) -> bool:
        """Whether a line subtracts from the energy before, or one after from something."""
        energies = [Quantity("energy", (), n) for n in range(len(self._base.events) + 1)]
        return any(
            self._is_nearly(term, energy, line)
            for link in line.line.links
            for node in walk(link.readings[0].right)
            if is_binary(node, "-") and {type(node.left), type(node.right)} != {Number}
            for term in (node.left, node.right)
            for energy in energies
        )

    def _is_nearly(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a side has the size of a quantity, but for the student's rounding."""
        where = self._meanings(line), line.line.scope
        try:
            values = [self._base.value(tree, *where) for tree in (side, quantity)]
        except (RestitutionError, UnvaluedError, TypeError):
            return False
        if any(isinstance(value, Vector) for value in values):
            return False
        own, true = (np.abs(spread_of(self._base, value)) for value in values)
        return bool(np.all(true > 0) and np.all(np.abs(own - true) <= _ROUNDED * true))

    def ends_in_noughts(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a decimal has three figures, of which the last are noughts: ``e = 0.5``."""
        last = line.line.links[-1].decimals if line.line.links else ()
        if point.link is None or not last:
            return False
        try:
            true = np.abs(self._base.scalar(point.link.left)).flat[0]
        except RestitutionError:
            return False
        if not true > 0:
            return False
        typed = abs(float(last[-1].value))
        unit = 10.0 ** (math.floor(math.log10(true)) - 2)  # the third figure
        return bool(abs(typed - true) <= unit / 2)

    def lacks_squares(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a false line has a speed as the sum of its components, or as the root of that.

        So have ``v = √(8 + 2)`` and ``3u/4 = 3u/5 + 4eu/5``.
        """
        if line.mistake is None or point.link is None:
            return False
        two = Number(Fraction(2))
        claims = [link.readings[0] for link in line.line.links]
        wanted: list[tuple[Expression, Expression]] = []
        if line.mistake.id == "square-not-taken":
            roots = (x for own in claims for x in walk(own.right) if is_function(x, "sqrt"))
            wanted += [(root.argument, point.link.left) for root in roots]
        if line.verdict == "false":
            wanted += [
                (one, other)
                for claim in claims
                for one, other in permutations((claim.left, claim.right))
            ]
        return any(
            is_binary(tree, "+")
            and self._is_nearly(
                Apply("sqrt", Binary("+", *(Binary("^", x, two) for x in (tree.left, tree.right)))),
                speed,
                line,
            )
            for tree, speed in wanted
        )

    def is_sum_of_squares(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives the square of a point's speed as a sum: ``v² = u²/4 + u²/36``."""
        link = point.link
        if link is None or not is_quantity(link.left, "speed"):
            return False
        meanings = self._meanings(line)
        wanted = (link.left, replace(link.left, kind="velocity"))
        return any(
            is_binary(chain[0].left, "^")
            and any(self._names(chain[0].left.left, tree, meanings, line) for tree in wanted)
            and any(is_binary(claim.right, "+") for claim in chain)
            for chain in chains(line)
        )

    def puts_in_energy(self, line: JudgedLine) -> bool:
        """Whether a line has squares, and needs the energy that the question gives.

        So has ``v² + 3w² + u²/4 = 11u²/16``.
        """
        given = any(
            node.kind in ENERGIES
            for _, step in self._base.problem.steps()
            if isinstance(step, Given)
            for relation in step.relations
            if isinstance(relation, Compare)
            for tree in relation.operands
            for node in quantities_in(tree)
        )
        if not given or self.holds_by_laws(line):
            return False
        return any(
            is_binary(node, "^")
            and letters(node.left) & (self._meanings(line).keys() | self.unknown)
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for node in walk(side)
        )

    def speaks_of_line_alone(self, line: JudgedLine) -> bool:
        """Whether a line tells the direction of the line of centres, and of no motion."""
        meanings = self._meanings(line)
        kinds = {
            node.kind
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for tree in (side, *(meanings[name] for name in letters(side) if name in meanings))
            for node in quantities_in(tree)
        }
        return "line_of_centres" in kinds and kinds <= {"line_of_centres", "along", "across"}

    def is_place(self, point: MarkPoint) -> bool:
        """Whether a point is for the place of a body, or a coordinate of it."""
        left = point.link.left if point.link is not None else None
        return left is not None and place_in(left) is not None and not point.shown

    def is_distance(self, point: MarkPoint) -> bool:
        """Whether a point is for a distance."""
        return point.link is not None and is_quantity(point.link.left, "distance")

    def are_as_much(self, one: MarkPoint, other: MarkPoint) -> bool:
        """Whether what two points are for has one size: a distance, and the coordinate it is."""
        if one.link is None or other.link is None:
            return False
        try:
            sizes = [
                np.abs(self._base.spread(self._base.scalar(point.link.left)))
                for point in (one, other)
                if point.link is not None
            ]
        except RestitutionError:
            return False
        return are_close(*sizes)

    def adds_angle(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the angle of a point is a term of a sum of angles in a line."""
        link = point.link
        if link is None:
            return False
        angle = link.left.argument if isinstance(link.left, Apply) else link.left
        both = tuple(self._angles_between(angle)) if point.letter == "M" else ()
        angles = both or (angle,)
        terms = (
            side
            for chain in chains(line)
            for claim in chain
            for tree in (claim.left, claim.right)
            for node in walk(tree)
            if is_binary(node, "+", "-")
            for side in (node.left, node.right)
        )
        return any(self._is_angle(side, angle, line) for side in terms for angle in angles)

    def _angles_between(self, angle: Expression) -> Iterator[Expression]:
        """The angles of both velocities to an axis, or the line of centres, of a deflection."""
        if not is_quantity(angle, "deflection"):
            return
        number = angle.stage if isinstance(angle.stage, int) else len(self._base.events)
        axes: list[Expression] = [Unit("i"), Unit("j")]
        if number in self._base.lines:
            axes.append(Quantity("line_of_centres", (), number))
        for stage in (number - 1, number):
            velocity = Quantity("velocity", angle.arguments, stage)
            yield from (Quantity("angle", (velocity, axis)) for axis in axes)

    def names_angle(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the angle of a point stands in a remark about angles, as a decimal.

        Those before and after may be whole numbers of degrees: ``before 53.13, after 45``.
        """
        link = point.link
        both = bool(_BEFORE_AND_AFTER.fullmatch(line.line.text))
        if link is None or line.verdict != "remark":
            return False
        if not (both or (point.letter == "M" and _ANGLE.search(line.line.text))):
            return False
        angle = link.left.argument if isinstance(link.left, Apply) else link.left
        angles = tuple(self._angles_between(angle)) or (angle,)
        values = [value for value in line.line.values if both or is_fine(value)]
        return any(self._is_angle(value, angle, line) for value in values for angle in angles)

    def _has_part(
        self, vector: Expression, velocity: Quantity, point: MarkPoint, line: JudgedLine
    ) -> bool:
        """Whether a vector, taken for a velocity, has the component of a point."""
        link = point.link
        if link is None or not any(isinstance(node, Unit | Pair) for node in walk(vector)):
            return False
        return self._is_worth(exchanged(link.left, {velocity: vector}), link.left, line)

    def _completed_place(self, place: Quantity, lines: Sequence[JudgedLine]) -> Match | None:
        """Whether the last of some lines gives the coordinate of a place that is still missing.

        That of the wall which a sphere hits there is known.
        """
        parts = {axis: Quantity("along", (place, Unit(axis))) for axis in ("i", "j")}
        own = {
            axis: [line for line in lines if self.value_of(part, line) is not None]
            for axis, part in parts.items()
        }
        if not any(given and given[-1] is lines[-1] for given in own.values()):
            return None
        if any(not given and axis != self._axis_across(place.stage) for axis, given in own.items()):
            return None
        sound = all(given[-1].verdict == "true" for given in own.values() if given)
        return "true" if sound or self.his_own else "own"

    def _axis_across(self, number: object) -> str | None:
        """The axis at right angles to the wall along i or j that is hit in an event."""
        if not isinstance(number, int) or not 0 < number <= len(self._base.events):
            return None
        event = self._base.events[number - 1]
        walls = {wall.name: wall.along for wall in self._base.problem.walls}
        along = walls.get(event.second) if isinstance(event, Impact) else None
        return {"i": "j", "j": "i"}[along.axis] if isinstance(along, Unit) else None

    def _is_vector_part(self, vector: Expression, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a vector is the part of a velocity that the component of a point is the size of.

        ``parallel part 6i + 8j, perp part 4i - 3j`` resolves a velocity as components do.
        """
        part = None if point.link is None or not _PARTS.search(line.line.text) else point.link.left
        match part:
            case Quantity("along" | "across", (Quantity("velocity") as velocity, _)):
                along = self._has_part(vector, velocity, point, line)
                return along and self._is_worth(Apply("abs", vector), Apply("abs", part), line)
        return False

    def _is_in_a_tangent(self, part: Expression, line: JudgedLine) -> bool:
        """Whether a line has a tangent of which one component is a part: ``tan β = u sin α/v``."""
        if not any(use.principle == "angle" for use in line.uses[:1]):
            return False
        ratios = (
            node
            for chain in chains(line)
            for claim in chain
            for side in (claim.left, claim.right)
            for node in walk(side)
            if is_binary(node, "/")
        )
        return any(
            self._is_worth(side, part, line) and not isinstance(side, Number)
            for ratio in ratios
            for side in (ratio.left, ratio.right)
        )

    def is_of_a_speed(self, line: JudgedLine) -> bool:
        """Whether a line begins with a speed, or its square."""
        left = line.line.links[0].readings[0].left
        left = left.left if is_binary(left, "^") else left
        meant = self._meanings(line).get(left.name) if isinstance(left, Letter) else left
        return meant is not None and is_quantity(meant, "speed")
