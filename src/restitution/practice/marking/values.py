"""What a student's lines give: which side names what is asked, and which one is its value.

A side names a quantity if both are worth the same, up to a sign, whatever happens at the impacts:
in a world in which velocities and unknown letters are scattered. A side is a value if nothing
there changes it.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from typing import Literal

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import FLIPPED, Link
from restitution.explaining.lines.trees import exchanged
from restitution.expression.evaluate import Angle, Value
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Unit,
    children,
    walk,
)
from restitution.practice.judgement import JudgedLine, Meaning
from restitution.practice.letters.interpretation import Interpretation
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.reading.quoted import has_data
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.arrays import Array, UnvaluedError, is_bare
from restitution.practice.worlds.principles import is_worked
from restitution.practice.worlds.student import scattered_world, told_world
from restitution.practice.worlds.world import World
from restitution.problem import Impact
from restitution.vector import Vector

Match = Literal["true", "own"]

_NEAR = 1e-7
_LEAST = 1e-9
_ROUNDED = 2e-3
_IMPULSE = ("I", "J")
_STAYING = re.compile(r"\b(perp\w*|across|parallel|unchanged|stays?|same)\b", re.IGNORECASE)
_CONCLUSIONS: Mapping[str, re.Pattern[str]] = {
    "perpendicular to": re.compile(r"\b(perp\w*|right angles?)\b", re.IGNORECASE),
    "parallel to": re.compile(r"\b(parallel|direction|along|line of centres|loc)\b", re.IGNORECASE),
}
# What is said of a line that rests on several laws.
_OF_SEVERAL = ("solve", "value", "fact")
# The quantities of which a line of a principle speaks.
_KINDS_OF_FACTS: Mapping[str, frozenset[str]] = {
    "speed": frozenset({"speed", "energy", "energy_lost", "total_energy_lost"}),
    "energy": frozenset({"speed", "energy", "energy_lost", "total_energy_lost"}),
    "deflection": frozenset({"deflection", "angle", "direction"}),
    "angle": frozenset({"deflection", "angle", "direction", "line_of_centres"}),
}


@dataclass(frozen=True, eq=False)
class Values:
    """The values of a part, and how a script's letters reach them.

    ``worlds`` are the true ones, one for each admissible solution, ``unknown`` the letters of the
    statement that are not given. ``his_own`` counts what follows from a slip as true, as a misread
    datum makes it.
    """

    worlds: tuple[World, ...]
    unknown: frozenset[str]
    letters: tuple[Meaning, ...] = ()
    his_own: bool = False

    def of_his_own(self) -> Values:
        """The values for a working from another datum."""
        return replace(self, his_own=True)

    def matches(self, point: MarkPoint, line: JudgedLine) -> Match | None:
        """Whether a line gives the value of a point: the true one, or one of his own.

        None where it gives no value of that quantity.
        """
        if point.link is None:
            return None
        if point.shown and not self._is_printed(point, line):
            whole = line.verdict == "true" and self._gives_whole(point.link.left, line)
            return self._match(line) if whole else None
        if not point.shown and not self._gives(point.link.left, line, self._is_open(point)):
            energetic = point.principle in ("energy", "component")
            computed = (energetic or point.letter == "A") and self._computes(point.link.left, line)
            between = point.letter == "A" and point.item is None
            computed = computed or (between and self.gives_multiple(point, line))
            if not computed and not self._gives_whole(point.link.left, line):
                return None
        return self._match(line)

    def gives_multiple(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives a multiple of what a point is for its value."""
        link = point.link
        return link is not None and self._gives_multiple(link.left, line, self._is_open(point))

    def gives_multiple_only(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives a multiple of what a point is for, and not that itself."""
        link = point.link
        if link is None or self._gives(link.left, line, self._is_open(point)):
            return False
        return self.gives_multiple(point, line)

    def speaks_for(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a side of a line names what a point is for: an angle, or its tangent."""
        link = point.link
        if link is None:
            return False
        meanings = self._meanings(line)
        angle = link.left.argument if isinstance(link.left, Apply) else link.left
        return any(
            self._names(side, each, meanings, line)
            for chain in _chains(line)
            for claim in chain
            for side in (claim.left, claim.right)
            for each in dict.fromkeys((link.left, angle))
        )

    def has_angle(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the angle of a point is all that a line has of velocities, as a sine or so."""
        link = point.link
        if link is None or not line.uses or line.uses[0].principle not in _OF_SEVERAL:
            return False
        meanings = self._meanings(line)
        angle = link.left.argument if isinstance(link.left, Apply) else link.left
        return any(
            isinstance(each, Apply)
            and each.function in ("sin", "cos", "tan", "cot")
            and self._names(each.argument, angle, meanings, line)
            and self.velocities_in(claim, line) <= {each.argument}
            for chain in _chains(line)
            for claim in chain
            for side in (claim.left, claim.right)
            for each in walk(side)
        )

    def left_out(self, point: MarkPoint, lines: Sequence[JudgedLine]) -> int:
        """In how many of several solutions no line gives the value of a point."""
        link = point.link
        if link is None or point.shown or len(self.worlds) < 2:
            return 0
        return sum(
            not any(self._holds_in(world, link.left, line) for line in lines)
            for world in self.worlds
        )

    def _holds_in(self, world: World, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a line that names a quantity holds in a solution."""
        meanings = self._meanings(line)
        for link in line.line.links:
            for claim in link.readings:
                sides = (claim.left, claim.right)
                if not any(
                    self._names(side, quantity, meanings, line)
                    or self._is_of_velocity(side, quantity, line)
                    for side in sides
                ):
                    continue
                try:
                    if agrees(claim, world, meanings, link.decimals, line.line.scope):
                        return True
                except RestitutionError:
                    continue
        return False

    def _is_of_velocity(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a side is a component of the velocity, or of the speed, that a quantity is."""
        if not (isinstance(quantity, Quantity) and quantity.kind in ("velocity", "speed")):
            return False
        meanings = self._meanings(line)
        meant = meanings.get(side.name, side) if isinstance(side, Letter) else side
        velocity = replace(quantity, kind="velocity")
        return self._is_component(meant) and any(
            self._names(each, velocity, {}, line) for each in _within(meant)
        )

    def completes(self, point: MarkPoint, lines: Sequence[JudgedLine]) -> Match | None:
        """Whether the last of some lines completes the components of a point's velocity."""
        link = point.link
        if link is None or point.shown or not isinstance(link.left, Quantity) or not lines:
            return None
        if link.left.kind != "velocity":
            return None
        squares = [square for line in lines for square in self._squares(link.left, line)]
        own = self._squares(link.left, lines[-1])
        if not own:
            return None
        size = self._size(link.left)
        if size is None or not any(_near(a + b, size**2) for a in own for b in squares):
            return None
        sound = all(line.verdict == "true" for line in lines if self._squares(link.left, line))
        return "own" if not sound else self._match(lines[-1])

    def _match(self, line: JudgedLine) -> Match:
        return "true" if line.verdict == "true" or self.his_own else "own"

    def is_solved(self, line: JudgedLine) -> bool:
        """Whether a line gives one unknown of the impact, or a multiple of it, a value."""
        meanings = self._meanings(line)
        return any(
            claim.sign == "="
            and len(set(_names_in(claim.left))) == 1
            and self._changes(claim.left, meanings, line)
            and self._is_value(claim.right, meanings, line)
            for chain in _chains(line)
            for claim in chain
        )

    def is_eliminated(self, line: JudgedLine) -> bool:
        """Whether one velocity is left in an equation that no law alone gives."""
        if line.uses and line.uses[0].principle not in _OF_SEVERAL:
            return False
        names = [self.velocities_in(claim, line) for chain in _chains(line) for claim in chain]
        return any(len(each) == 1 for each in names)

    def unknowns(self, line: JudgedLine) -> frozenset[Expression]:
        """The letters and quantities of a line that an impact decides."""
        return frozenset[Expression]().union(
            *(self.velocities_in(claim, line) for chain in _chains(line) for claim in chain)
        )

    def works_out_an_angle(self, line: JudgedLine) -> bool:
        """Whether a line works out an angle from a ratio of two numbers."""
        return any(
            isinstance(each, Apply)
            and each.function in ("arctan", "arcsin", "arccos")
            and isinstance(each.argument, Binary)
            and each.argument.op == "/"
            and is_bare(each.argument)
            for chain in _chains(line)
            for claim in chain
            for side in (claim.left, claim.right)
            for each in walk(side)
        )

    def has_tangent(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line works out, by its components, the angle of a velocity to i or j.

        That is what stands in place of its speed where a path turns through a sum of angles.
        """
        left = None if point.link is None else point.link.left
        if not (isinstance(left, Quantity) and left.kind == "speed"):
            return False
        world = self._base
        try:
            v = world.value(replace(left, kind="velocity"))
        except UnvaluedError:
            return False
        if not isinstance(v, Vector):
            return False
        for chain in _chains(line):
            for side in (side for claim in chain for side in (claim.left, claim.right)):
                for each in walk(side):
                    match each:
                        case Apply("arctan", Binary("/") as ratio) if is_bare(ratio):
                            tangent = np.abs(world.scalar(ratio))
                            pairs = (v.x, v.y), (v.y, v.x)
                            if any(_close(tangent * np.abs(a), np.abs(b)) for a, b in pairs):
                                return True
        return False

    def velocities_in(self, claim: Claim, line: JudgedLine) -> frozenset[Expression]:
        """The letters and quantities of a claim that an impact decides; none of the statement."""
        meanings = self._meanings(line)
        return frozenset(
            each
            for side in (claim.left, claim.right)
            for each in _names_in(side)
            if not (isinstance(each, Letter) and each.name not in meanings)
            and self._changes(each, meanings, line)
        )

    def has_velocities(self, line: JudgedLine) -> bool:
        """Whether a letter for a velocity after an impact stands in a line."""
        return any(self.velocities_in(claim, line) for each in _chains(line) for claim in each)

    def is_velocity(self, point: MarkPoint) -> bool:
        """Whether a point is for a velocity."""
        left = point.link.left if point.link is not None else None
        return isinstance(left, Quantity) and left.kind == "velocity" and not point.shown

    def shows(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the value of a velocity stands in a remark: ``so both 0.6i + j``."""
        link = point.link
        if link is None:
            return False
        if self.is_direction(point):
            return line.verdict in ("true", "remark") and any(
                self._is_angle(value, link.left, line) or self._is_towards(value, link, line)
                for value in line.line.values
            )
        if link.sign == "parallel to":
            return line.verdict in ("true", "remark") and any(
                self._is_towards(value, link, line) for value in line.line.values
            )
        return line.verdict == "remark" and any(
            self._is_worth(value, link.left, line) for value in line.line.values
        )

    def _is_towards(self, value: Expression, link: Link, line: JudgedLine) -> bool:
        """Whether a vector has the direction that a relation gives."""
        if link.sign != "parallel to":
            return False
        return self._is_parallel(value, link.right, self._meanings(line), line)

    def words_of_direction(self, point: MarkPoint) -> re.Pattern[str] | None:
        """The words in which a student concludes what is printed of a direction."""
        if point.link is None or not point.shown:
            return None
        if point.link.sign == "=" and isinstance(point.link.right, Binary):
            unit = any(isinstance(each, Unit) for each in walk(point.link.right))
            vector = isinstance(point.link.left, Quantity) and point.link.left.kind == "impulse"
            return _CONCLUSIONS["parallel to"] if unit and vector else None
        return _CONCLUSIONS.get(point.link.sign)

    def is_pointing(self, point: MarkPoint) -> bool:
        """Whether a point is for the vector along which something points."""
        return point.link is not None and point.link.sign == "parallel to" and not point.shown

    def is_direction(self, point: MarkPoint) -> bool:
        """Whether a point is for a direction."""
        left = point.link.left if point.link is not None else None
        return isinstance(left, Quantity) and left.kind == "direction" and not point.shown

    def _is_angle(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a number, in degrees, is the size of an angle to three figures."""
        try:
            own = self._base.value(side, self._meanings(line), line.line.scope)
            asked = self._base.value(quantity)
        except UnvaluedError:
            return False
        if isinstance(own, Vector) or not isinstance(asked, Angle):
            return False
        return _is_rounded(self._base, own, asked)

    def has_rebound(self, line: JudgedLine) -> bool:
        """Whether a line has e and, but for an impulse, nothing else that an impact decides."""
        meanings = self._meanings(line)
        meant = (meanings.get(getattr(each, "name", ""), each) for each in self.unknowns(line))
        impulses = all(
            each == Letter("e") or (isinstance(each, Quantity) and each.kind == "impulse")
            for each in meant
        )
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
        numbers = {float(self._base.scalar(each).flat[0]) for each in given if is_bare(each)}
        squares = {number**2 for number in numbers}
        return any(
            node in given or (is_bare(node) and self._is_one_of(node, numbers | squares))
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for node in walk(side)
        )

    def _is_one_of(self, tree: Expression, numbers: Collection[float]) -> bool:
        try:
            own = float(np.ravel(self._base.scalar(tree))[0])
        except UnvaluedError:
            return False
        return any(abs(own - each) <= _NEAR for each in numbers)

    def speaks_of(self, point: MarkPoint, principle: str) -> bool:
        """Whether a fact may be stated by a line of a principle: one of energy speaks of energies.

        A fact without a quantity may be stated in any of them.
        """
        link = point.link
        if principle == "fact" or link is None:
            return True
        kinds = {each.kind for side in (link.left, link.right) for each in _within(side)}
        return not kinds or bool(kinds & _KINDS_OF_FACTS.get(principle, kinds))

    def is_quoted(self, line: JudgedLine) -> bool:
        """Whether a line gives quantities their values and no more, without a calculation."""
        claims = [link.readings[0] for link in line.line.links]
        return all(
            isinstance(claim.left, Letter | Quantity) and not is_worked(claim.right)
            for claim in claims
        )

    def is_formula(self, line: JudgedLine) -> bool:
        """Whether a line is a formula that is only quoted: I = m(v - u), with m and u for data."""
        inferred = {each.letter for each in self.letters if each.by == "inferred"}
        meanings = self._meanings(line)
        if has_data(line.line):
            return False
        return any(
            isinstance(each, Letter)
            and each.name in inferred
            and not self._changes(each, meanings, line)
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for each in _names_in(side)
        )

    def is_seen(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the value of a point stands in a line that states nothing about it.

        A whole number is none, as too many are alike, but behind a word such as *perp*.
        """
        link = point.link
        if link is None or point.shown or line.verdict not in ("remark", "true"):
            return False
        if not isinstance(link.left, Quantity) or self.is_direction(point):
            return False
        across = point.principle == "unchanged" and bool(_STAYING.search(line.line.text))
        return any(
            self._is_worth(value, link.left, line)
            or (_is_fine(value) and self._is_rounded_to(value, link.left, line))
            for value in line.line.values
            if across or not (isinstance(value, Number) and value.value.denominator == 1)
        )

    def _is_rounded_to(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        try:
            own = self._base.value(side, self._meanings(line), line.line.scope)
            return _is_rounded(self._base, own, self._base.value(quantity))
        except UnvaluedError:
            return False

    def is_at_a_wall(self, point: MarkPoint) -> bool:
        """Whether a point is for the component of one velocity alone, as at a wall."""
        link = point.link
        if link is None:
            return False
        after = {each for each in _within(link.left) if each.kind == "velocity"}
        return len(after) == 1

    def carries(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line uses the component of a point: in a velocity, a speed, or as a remark."""
        link = point.link
        if link is None or point.principle not in ("unchanged", "restitution"):
            return False
        own = point.principle == "unchanged"
        if line.verdict == "remark" and own:
            return any(self._is_worth(value, link.right, line) for value in line.line.values)
        velocity = next((each for each in _within(link.left) if each.kind == "velocity"), None)
        if velocity is None or line.verdict not in ("true", "follows", "false"):
            return False
        wrong = line.verdict == "false"
        if wrong and not own:
            return False  # what is wrong in a velocity is most often the component that changes
        kinds = ("speed", "energy") if own and not wrong else ()
        if any(self.value_of(replace(velocity, kind=kind), line) is not None for kind in kinds):
            return True
        if own and not wrong and self._has_square(link.right, line):
            return True
        vector = self.value_of(velocity, line)
        if vector is None:
            return False
        return self._is_worth(exchanged(link.left, {velocity: vector}), link.left, line)

    def _has_square(self, value: Expression, line: JudgedLine) -> bool:
        """Whether the square of a value in letters stands in a line: ``w² = v² + u² sin²α``."""
        world, meanings = self._scattered, self._meanings(line)
        square = Binary("^", value, Number(Fraction(2)))
        if is_bare(value):
            return False
        for link in line.line.links:
            for side in (link.readings[0].left, link.readings[0].right):
                for each in walk(side):
                    if not isinstance(each, Binary) or each.op not in ("*", "^"):
                        continue
                    try:
                        own = world.value(each, meanings, line.line.scope)
                        if _same(world, own, world.value(square)):
                            return True
                    except UnvaluedError:
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
            for each in line.line.links
            for side in (each.readings[0].left, each.readings[0].right)
            for product in _within(side)
            if product.kind == "dot"
            for vector in product.arguments
        )

    def _is_parallel(
        self,
        vector: Expression,
        direction: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
    ) -> bool:
        world = self._base
        try:
            own, asked = world.value(vector, meanings, line.line.scope), world.value(direction)
        except UnvaluedError:
            return False
        if not (isinstance(own, Vector) and isinstance(asked, Vector)):
            return False
        crossed = own.x * asked.y - own.y * asked.x
        return _is_zero(world, crossed) and self._is_value(vector, meanings, line)

    def letter_of(self, quantity: Expression) -> Expression | None:
        """The student's letter for a quantity, with a sign where it has the other sense."""
        world = self._scattered
        for meaning in self.letters:
            if " " in meaning.letter:
                continue
            try:
                own = world.value(meaning.quantity, scope=meaning.scope)
                asked = world.value(quantity)
            except UnvaluedError:
                continue
            if isinstance(own, Vector) or isinstance(asked, Vector):
                continue
            a, b = _number(world, own), _number(world, asked)
            if _near(a, b):
                return Letter(meaning.letter)
            if _near(a, -b):
                return Negate(Letter(meaning.letter))
        return None

    def _is_worth(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        world = self._base
        try:
            own = world.value(side, self._meanings(line), line.line.scope)
            return _same(world, own, world.value(quantity))
        except UnvaluedError:
            return False

    def value_of(
        self, tree: Expression, line: JudgedLine, open_: bool = False
    ) -> Expression | None:
        """The side of a line that gives a quantity its value, the last one typed.

        With ``open_`` the letters that the question asks for may stand in it.
        """
        meanings = self._meanings(line)
        last: Expression | None = None
        for chain in _chains(line):
            if self._names(chain[0].left, tree, meanings, line):
                last = next(
                    (
                        claim.right
                        for claim in reversed(chain)
                        if self._is_value(claim.right, meanings, line, open_)
                    ),
                    last,
                )
            elif self._names(chain[-1].right, tree, meanings, line) and self._is_value(
                chain[0].left, meanings, line, open_
            ):
                last = chain[0].left
        return last

    # --- sides ----------------------------------------------------------------------------------

    def _is_open(self, point: MarkPoint) -> bool:
        """Whether letters that the question asks for stand in the value of a point."""
        assert point.link is not None
        return any(
            isinstance(each, Letter) and each.name in self.unknown
            for each in walk(point.link.right)
        )

    def _gives(self, quantity: Expression, line: JudgedLine, open_: bool) -> bool:
        if line.verdict == "remark":
            return False
        if self.value_of(quantity, line, open_) is not None:
            return True
        ratio = isinstance(quantity, Binary) and quantity.op == "/"
        return ratio and self._gives_ratio(quantity, line, open_)  # type: ignore[arg-type]

    def _gives_ratio(self, ratio: Binary, line: JudgedLine, open_: bool) -> bool:
        """Whether a line gives one of two quantities by the other: ``q = 2p`` for q/p."""
        meanings = self._meanings(line)
        for chain in _chains(line):
            sides = chain[0].left, chain[-1].right
            for one, other in (sides, sides[::-1]):
                match one:
                    case Binary("/", above, below) if self._is_size(
                        above, ratio.left, line
                    ) and self._names(below, ratio.right, meanings, line):
                        value: Expression = other
                    case _ if self._is_size(one, ratio.left, line):
                        value = Binary("/", other, ratio.right)
                    case _ if self._is_size(one, ratio.right, line):
                        value = Binary("/", ratio.left, other)
                    case _:
                        continue
                if self._is_value(value, meanings, line, open_):
                    return True
        return False

    def _is_size(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a side names a quantity, or is the only component of a speed."""
        meanings = self._meanings(line)
        if self._names(side, quantity, meanings, line):
            return True
        meant = meanings.get(side.name, side) if isinstance(side, Letter) else side
        speed = isinstance(quantity, Quantity) and quantity.kind == "speed"
        return speed and self._is_component(meant) and self._is_worth(side, quantity, line)

    def _gives_multiple(self, quantity: Expression, line: JudgedLine, open_: bool) -> bool:
        """Whether a line gives a multiple of a quantity its value: ``2w = (1 + e)u``."""
        if line.verdict == "remark":
            return False
        meanings = self._meanings(line)
        world = self._released if open_ else self._scattered
        for chain in _chains(line):
            first, last = chain[0].left, chain[-1].right
            if len(set(_names_in(first))) != 1 or not self._is_value(last, meanings, line, open_):
                continue
            if not self._changes(first, meanings, line):
                continue  # 3/√5 is a multiple of any number
            try:
                own = world.value(first, meanings, line.line.scope)
                asked = world.value(quantity)
            except UnvaluedError:
                continue
            if isinstance(own, Vector | Angle) or isinstance(asked, Vector | Angle):
                continue
            a, b = _number(world, own), _number(world, asked)
            if _is_zero(world, asked):
                continue
            ratio = a / np.where(b == 0, 1.0, b)
            if np.ptp(ratio) <= _NEAR * abs(ratio[0]) and abs(ratio[0]) > _NEAR:
                return True
        return False

    def _computes(self, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a true line without a name computes what a quantity is worth, and is not zero."""
        if line.verdict != "true":
            return False
        meanings = self._meanings(line)
        for chain in _chains(line):
            first, last = chain[0].left, chain[-1].right
            impulse = isinstance(first, Letter) and first.name in _IMPULSE
            impulse = impulse and isinstance(quantity, Quantity) and quantity.kind == "impulse"
            nameless = self._is_nameless(first, meanings, line)
            if not nameless and not impulse:
                continue
            try:
                worth = self._base.value(last, meanings, line.line.scope)
                asked = self._base.value(quantity)
            except UnvaluedError:
                continue
            rounded = line.line.links[-1].decimals and line.accuracy != "coarse"
            near = _is_rounded if rounded else _same
            if near(self._base, worth, asked) and not _is_zero(self._base, asked):
                return True
        return False

    def _is_nameless(
        self, side: Expression, meanings: Mapping[str, Expression], line: JudgedLine
    ) -> bool:
        """Whether a side is a calculation, or a letter of which no meaning is known."""
        if isinstance(side, Number):
            return False
        if isinstance(side, Letter):
            if line.uses and all(use.principle == "arithmetic" for use in line.uses):
                return True
            return side.name not in meanings and not self._has_value(side, meanings, line)
        return self._is_value(side, meanings, line)

    def _has_value(
        self, side: Expression, meanings: Mapping[str, Expression], line: JudgedLine
    ) -> bool:
        try:
            self._base.value(side, meanings, line.line.scope)
        except UnvaluedError:
            return False
        return True

    def _gives_whole(self, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a line gives the only component of a velocity, where the other one is zero."""
        size = self._size(quantity)
        return size is not None and any(
            _near(square, size**2) for square in self._squares(quantity, line)
        )

    def _squares(self, quantity: Expression, line: JudgedLine) -> list[Array]:
        """The true squares of the components of a velocity that a sound line gives a value."""
        if not isinstance(quantity, Quantity) or quantity.kind not in ("velocity", "speed"):
            return []
        if line.verdict not in ("true", "follows", "false"):
            return []
        velocity = replace(quantity, kind="velocity")
        meanings = self._meanings(line)
        squares: list[Array] = []
        for chain in _chains(line):
            sides = chain[0].left, chain[-1].right
            for named, value in (sides, sides[::-1]):
                tree = exchanged(named, {Letter(name): meant for name, meant in meanings.items()})
                if not any(self._names(each, velocity, {}, line) for each in _within(tree)):
                    continue
                if not self._is_component(tree) or not self._is_value(value, meanings, line):
                    continue
                try:
                    true = self._base.value(named, meanings, line.line.scope)
                except UnvaluedError:
                    continue
                if not isinstance(true, Vector):
                    squares.append(_number(self._base, true) ** 2)
        return squares

    def _is_component(self, tree: Expression) -> bool:
        """Whether a tree is a component of a velocity, or that turned round."""
        if isinstance(tree, Negate):
            (tree,) = children(tree)
        return isinstance(tree, Quantity) and tree.kind in ("along", "across")

    def _size(self, quantity: Expression) -> Array | None:
        """The true size of a velocity or speed; None where a quantity is neither."""
        if not isinstance(quantity, Quantity) or quantity.kind not in ("velocity", "speed"):
            return None
        try:
            return _number(self._base, self._base.value(replace(quantity, kind="speed")))
        except UnvaluedError:
            return None

    def states(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line says what a point's own relation says, whatever happens.

        The differences of the sides of both are multiples of one another, and not zero: in any
        story, or in one with other values of what the question asks for.
        """
        worlds = (self._scattered, self._told) if point.principle != "fact" else (self._scattered,)
        return any(self._states_in(world, point, line) for world in worlds if world is not None)

    def _states_in(self, world: World, point: MarkPoint, line: JudgedLine) -> bool:
        link = point.link
        if link is None:
            return False
        sides = (link.left, link.right)
        if link.sign == "perpendicular to":
            sides = (Quantity("dot", sides), Number(Fraction(0)))
        meanings = self._meanings(line)
        return any(
            self._are_multiples(world, (claim.left, claim.right), sides, meanings, line)
            for each in line.line.links
            for claim in each.readings[:1]
            if (claim.sign in FLIPPED) == (link.sign in FLIPPED)
        )

    def _are_multiples(
        self,
        world: World,
        own: tuple[Expression, Expression],
        asked: tuple[Expression, Expression],
        meanings: Mapping[str, Expression],
        line: JudgedLine,
    ) -> bool:
        try:
            values = [world.value(x, meanings, line.line.scope) for x in own]
            values += [world.value(x) for x in asked]
        except UnvaluedError:
            return False
        if any(isinstance(value, Vector) for value in values):
            return False
        left, right, first, second = (_number(world, value) for value in values)
        a, b = left - right, first - second
        if np.any(np.abs(a) < _LEAST) or np.any(np.abs(b) < _LEAST):
            return False
        return bool(np.ptp(a / b) < _LEAST * np.max(np.abs(a / b)))

    def _is_printed(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line is the printed relation, its sides perhaps exchanged, or ends in it."""
        link = point.link
        assert link is not None
        meanings = self._meanings(line)
        for chain in _chains(line):
            first, last = chain[0].left, chain[-1].right
            for left, right in ((first, last), (last, first)):
                if self._names(left, link.left, meanings, line) and self._names(
                    right, link.right, meanings, line
                ):
                    return True
        return False

    def _names(
        self,
        side: Expression,
        quantity: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
    ) -> bool:
        """Whether a side is worth what a quantity is, up to a sign, whatever happens."""
        world = self._scattered
        try:
            own = world.value(side, meanings, line.line.scope)
            asked = world.value(quantity)
        except UnvaluedError:
            return False
        return _same(world, own, asked) or self._is_size_of(side, quantity, meanings)

    def _is_size_of(
        self, side: Expression, quantity: Expression, meanings: Mapping[str, Expression]
    ) -> bool:
        """Whether a side is a component of an impulse, and so its size, as smooth bodies meet."""
        meant = meanings.get(side.name, side) if isinstance(side, Letter) else side
        if not isinstance(quantity, Quantity) or quantity.kind != "impulse" or quantity.arguments:
            return False
        try:
            own, asked = self._base.value(meant), self._base.value(quantity)
        except UnvaluedError:
            return False
        inside = [each for each in _within(meant) if each.kind == "impulse"]
        return bool(inside) and not isinstance(own, Vector) and _same(self._base, own, asked)

    def _changes(
        self, side: Expression, meanings: Mapping[str, Expression], line: JudgedLine
    ) -> bool:
        try:
            true = self._base.value(side, meanings, line.line.scope)
            other = self._scattered.value(side, meanings, line.line.scope)
        except UnvaluedError:
            return False
        return not _same(self._base, true, other)

    def _is_value(
        self,
        side: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
        open_: bool = False,
    ) -> bool:
        """Whether nothing that happens at the impacts changes a side.

        With ``open_`` the letters that the question asks for are as they are.
        """
        world = self._released if open_ else self._scattered
        try:
            true = self._base.value(side, meanings, line.line.scope)
            other = world.value(side, meanings, line.line.scope)
        except UnvaluedError:
            return False
        return _same(self._base, true, other)

    @property
    def _base(self) -> World:
        return self.worlds[0]

    @cached_property
    def _scattered(self) -> World:
        return scattered_world(self._base, self.unknown)

    @cached_property
    def _told(self) -> World | None:
        """A world in which all laws hold, with other letters than the question leads to."""
        return told_world(self._base, self.unknown) if self.unknown else None

    @cached_property
    def _released(self) -> World:
        """A world in which velocities are scattered, and no letters of the statement."""
        return scattered_world(self._base, frozenset())

    def _meanings(self, line: JudgedLine) -> Mapping[str, Expression]:
        return {**Interpretation(self.letters).trees(line.line.number), **line.meant}


def _chains(line: JudgedLine) -> Iterator[Sequence[Claim]]:
    """The relations of a line, links of a chain together, in the reading that is most natural."""
    chain: list[Claim] = []
    for link in line.line.links:
        claim = _of_direction(link.readings[0])
        if chain and chain[-1].right != claim.left:
            yield chain
            chain = []
        chain.append(claim)
    if chain:
        yield chain


def _of_direction(claim: Claim) -> Claim:
    """A vector that has no part across a line, as the direction of that line."""
    right = claim.right
    if claim.left == Number(Fraction(0)) and isinstance(right, Quantity) and right.kind == "across":
        vector, line = right.arguments
        return Claim(line, "=", vector)
    return claim


def _names_in(tree: Expression) -> Iterator[Expression]:
    """The letters and quantities of a tree; those within a quantity are left out."""
    if isinstance(tree, Letter | Quantity):
        yield tree
        return
    for child in children(tree):
        yield from _names_in(child)


def _within(tree: Expression) -> Iterator[Quantity]:
    """The quantities of a tree, outer ones first."""
    if isinstance(tree, Quantity):
        yield tree
    for child in children(tree):
        yield from _within(child)


def _same(world: World, one: Value, other: Value) -> bool:
    """Whether two values agree in all samples, up to a sign."""
    if isinstance(one, Vector) or isinstance(other, Vector):
        if not (isinstance(one, Vector) and isinstance(other, Vector)):
            return False
        return any(
            _near(world.spread(one.x), sign * world.spread(other.x))
            and _near(world.spread(one.y), sign * world.spread(other.y))
            for sign in (1, -1)
        )
    a, b = _number(world, one), _number(world, other)
    return _near(a, b) or _near(a, -b)


def _is_rounded(world: World, own: Value, true: Value) -> bool:
    """Whether a value is another one to 3 figures; a bare number is an angle in degrees."""
    if isinstance(own, Vector) or isinstance(true, Vector):
        return _same(world, own, true)
    a, b = _number(world, own), _number(world, true)
    if isinstance(true, Angle) and not isinstance(own, Angle):
        a = np.radians(a)
    return bool(np.allclose(np.abs(a), np.abs(b), rtol=_ROUNDED))


def _is_fine(tree: Expression) -> bool:
    """Whether a value is a decimal."""
    return isinstance(tree, Number) and tree.value.denominator != 1


def _is_zero(world: World, value: Value) -> bool:
    if isinstance(value, Vector):
        return _is_zero(world, value.x) and _is_zero(world, value.y)
    number = _number(world, value)
    return _near(number, 0 * number)


def _number(world: World, value: Value) -> Array:
    return world.spread(value.measure() if isinstance(value, Angle) else value)


def _near(a: Array, b: Array) -> bool:
    return bool(np.allclose(a, b, rtol=_NEAR, atol=_NEAR))


def _close(one: Array, other: Array) -> bool:
    """Whether two sizes agree to three figures."""
    return bool(np.all(np.abs(one - other) <= 0.005 * np.abs(other)))
