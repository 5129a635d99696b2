"""What the sides of lines are worth, and which of them name a quantity.

A side names a quantity if both are worth the same, up to a sign, whatever happens at the impacts:
in a world in which velocities and unknown letters are scattered. A side is a value if nothing
there changes it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from functools import cached_property

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged
from restitution.expression.evaluate import Angle, Value
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pair,
    Quantity,
    Unit,
    children,
    has_unit_vector,
    is_binary,
    is_component,
    is_function,
    is_quantity,
    letters,
    quantities_in,
    unsigned,
    walk,
)
from restitution.practice.judgement import JudgedLine, Meaning
from restitution.practice.letters.interpretation import Interpretation
from restitution.practice.marking.lines import chains
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.script import Claim, column_of
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.arrays import Array, UnvaluedError, is_bare
from restitution.practice.worlds.student import scattered_world, told_world
from restitution.practice.worlds.world import World
from restitution.records import dataclass
from restitution.vector import Vector

_NEAR = 1e-7
_LEAST = 1e-9
_ROUNDED = 2e-3
_FIGURES = 2
_THIRD = 3
_OFF = 1.5
"""So many units of the third figure is an answer off that values rounded too early lead to."""
_IMPULSE = ("I", "J")


@dataclass(frozen=True, eq=False)
class Sides:
    """The worlds of a part, and what the sides of lines are worth there.

    ``worlds`` are the true ones, one for each admissible solution, ``unknown`` the letters of the
    statement that are not given. ``his_own`` counts what follows from a slip as true, as a misread
    datum makes it.
    """

    worlds: tuple[World, ...]
    unknown: frozenset[str]
    letters: tuple[Meaning, ...] = ()
    his_own: bool = False

    def _is_of_velocity(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a side is a component of the velocity, or of the speed, that a quantity is."""
        if not is_quantity(quantity, "velocity", "speed"):
            return False
        meanings = self._meanings(line)
        meant = meanings.get(side.name, side) if isinstance(side, Letter) else side
        velocity = replace(quantity, kind="velocity")
        return self._is_component(meant) and any(
            self._names(quantity, velocity, {}, line) for quantity in quantities_in(meant)
        )

    def unknowns(self, line: JudgedLine) -> frozenset[Expression]:
        """The letters and quantities of a line that an impact decides."""
        return frozenset[Expression]().union(
            *(self.velocities_in(claim, line) for chain in chains(line) for claim in chain)
        )

    def velocities_in(self, claim: Claim, line: JudgedLine) -> frozenset[Expression]:
        """The letters and quantities of a claim that an impact decides; none of the statement."""
        meanings = self._meanings(line)
        return frozenset(
            name
            for side in (claim.left, claim.right)
            for name in names_in(side)
            if not (isinstance(name, Letter) and name.name not in meanings)
            and self._changes(name, meanings, line)
        )

    def holds_by_laws(self, line: JudgedLine) -> bool:
        """Whether a relation of a line holds whatever the question states beside the laws."""
        world, meanings = self._lawful, self._meanings(line)
        if world is None:
            return False
        try:
            return any(
                agrees(link.readings[0], world, meanings, (), line.line.scope) is not None
                for link in line.line.links
            )
        except RestitutionError:
            return False

    def has_velocities(self, line: JudgedLine) -> bool:
        """Whether a letter for a velocity after an impact stands in a line."""
        return any(self.velocities_in(claim, line) for chain in chains(line) for claim in chain)

    @staticmethod
    def _both(
        world: World,
        side: Expression,
        quantity: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
    ) -> tuple[Value, Value] | None:
        """What a side of a line and a quantity are worth in a world; None without a value."""
        try:
            return world.value(side, meanings, line.line.scope), world.value(quantity)
        except UnvaluedError:
            return None

    def _is_angle(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a number, in degrees, is the size of an angle to three figures."""
        pair = self._both(self._base, side, quantity, self._meanings(line), line)
        if pair is None:
            return False
        own, asked = pair
        if isinstance(own, Vector) or not isinstance(asked, Angle):
            return False
        return is_rounded(self._base, own, asked)

    def _is_one_of(self, tree: Expression, numbers: Collection[float]) -> bool:
        try:
            own = float(np.ravel(self._base.scalar(tree))[0])
        except UnvaluedError:
            return False
        return any(abs(own - number) <= _NEAR for number in numbers)

    def _is_rounded_to(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        try:
            own = self._base.value(side, self._meanings(line), line.line.scope)
            return is_rounded(self._base, own, self._base.value(quantity))
        except UnvaluedError:
            return False

    def _has_figures_of(
        self, side: Expression, quantity: Expression, line: JudgedLine, units: float = 0.5
    ) -> bool:
        """Whether a number is what a quantity is worth to three figures, or more exactly.

        It may differ by so many ``units`` of the third figure.
        """
        world = self._base
        pair = self._both(world, side, quantity, self._meanings(line), line)
        if pair is None or any(isinstance(value, Vector) for value in pair):
            return False
        own, true = (np.abs(spread_of(world, value)) for value in pair)
        if isinstance(pair[1], Angle):
            own = own if isinstance(pair[0], Angle) else np.radians(own)
            own, true = np.degrees(own), np.degrees(true)
        decimals = [
            float(node.value) for node in walk(side) if isinstance(node, Number) and is_fine(node)
        ]
        if len(decimals) == 1 and any(names_in(side)) and np.all(own > _LEAST):
            true = true * decimals[0] / own  # of 3.91u the figures are those of 3.91
            own = np.full_like(true, decimals[0])
        if np.any(true < _LEAST):
            return False
        return bool(np.all(np.abs(own - true) <= units * 10 ** (np.floor(np.log10(true)) - 2)))

    def _is_turned(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        """Whether a value has the other sign than a letter that the question asks for."""
        pair = self._both(self._base, side, quantity, self._meanings(line), line)
        if pair is None or not isinstance(quantity, Letter):
            return False
        own, true = (np.atleast_1d(spread_of(self._base, value)) for value in pair)
        return bool(np.all(own * true < 0))

    def is_off(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the last decimal that a line gives for a point is wrong in its third figure.

        So it is where values rounded too early have led to it: 4.65 for 4.67. A decimal of two
        figures may be right in these: 7.2 for 7.247. Of what follows from a misread datum nobody
        knows.
        """
        if self.his_own:
            return False
        value = None if point.link is None else self.value_of(point.link.left, line)
        if point.link is None or value is None or has_unit_vector(value):
            return False
        decimals = line.line.links[-1].decimals if line.line.links else ()
        if not decimals:
            return False
        last = max(decimals, key=lambda decimal: decimal.column)
        units = max(_OFF, 0.5 * 10 ** (_THIRD - last.figures))
        return not self._has_figures_of(value, point.link.left, line, units=units)

    def is_to_a_tenth(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line ends in an angle to a tenth of a degree: ``β = 8.2``."""
        meant = None if point.link is None else point.link.left
        last = line.line.links[-1].decimals if line.line.links else ()
        tenth = any(decimal.half_unit <= Fraction(1, 20) for decimal in last)
        return is_quantity(meant, *ANGLES) and tenth

    def _has_square(self, value: Expression, line: JudgedLine) -> bool:
        """Whether the square of a value in letters stands in a line: ``w² = v² + u² sin²α``."""
        world, meanings = self._scattered, self._meanings(line)
        square = Binary("^", value, Number(Fraction(2)))
        if is_bare(value):
            return False
        for link in line.line.links:
            for side in (link.readings[0].left, link.readings[0].right):
                for node in walk(side):
                    if not is_binary(node, "*", "^"):
                        continue
                    try:
                        own = world.value(node, meanings, line.line.scope)
                        if are_same(world, own, world.value(square)):
                            return True
                    except UnvaluedError:
                        continue
        return False

    def _is_parallel(
        self,
        vector: Expression,
        direction: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
    ) -> bool:
        world = self._base
        pair = self._both(world, vector, direction, meanings, line)
        if pair is None:
            return False
        own, asked = pair
        if not (isinstance(own, Vector) and isinstance(asked, Vector)):
            return False
        crossed = own.x * asked.y - own.y * asked.x
        return is_zero(world, crossed) and self._is_value(vector, meanings, line)

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
            a, b = spread_of(world, own), spread_of(world, asked)
            if are_near(a, b):
                return Letter(meaning.letter)
            if are_near(a, -b):
                return Negate(Letter(meaning.letter))
        return None

    def _is_worth(self, side: Expression, quantity: Expression, line: JudgedLine) -> bool:
        world = self._base
        try:
            own = world.value(side, self._meanings(line), line.line.scope)
            return are_same(world, own, world.value(quantity))
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
        for chain in chains(line):
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

    def _is_open(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether letters that the question asks for stand in the value of a point.

        Or they stand in the student's for another letter, with which a fact has tied them:
        ½mu²(1 - e) is mu²(tan²α - 1)/(2 tan²α) where tan²α = 1/e.
        """
        assert point.link is not None
        own = letters(point.link.right)
        if own & self.unknown:
            return True
        last = letters(line.line.links[-1].readings[0].right) if line.line.links else frozenset()
        known = last <= self._base.letters.keys()
        return known and bool(last & self.unknown) and len(last) <= len(own) and not own <= last

    def _gives(self, quantity: Expression, line: JudgedLine, open_: bool) -> bool:
        if line.verdict == "remark":
            return False
        if self.value_of(quantity, line, open_) is not None:
            return True
        ratio = is_binary(quantity, "/")
        return ratio and self._gives_ratio(quantity, line, open_)  # type: ignore[arg-type]

    def _gives_ratio(self, ratio: Binary, line: JudgedLine, open_: bool) -> bool:
        """Whether a line gives one of two quantities by the other: ``q = 2p`` for q/p."""
        meanings = self._meanings(line)
        for chain in chains(line):
            sides = chain[0].left, chain[-1].right
            for one, other in (sides, sides[::-1]):
                match one:
                    case Binary("/", above, below) if self._is_size(
                        above, ratio.left, line
                    ) and self._names(below, ratio.right, meanings, line):
                        value: Expression = other
                    case _ if is_bare(other):
                        continue  # KE lost = 4 is no share
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
        speed = is_quantity(quantity, "speed")
        return speed and self._is_component(meant) and self._is_worth(side, quantity, line)

    def _gives_multiple(self, quantity: Expression, line: JudgedLine, open_: bool) -> bool:
        """Whether a line gives a multiple of a quantity its value: ``2w = (1 + e)u``."""
        if line.verdict == "remark":
            return False
        meanings = self._meanings(line)
        world = self._released if open_ else self._scattered
        for chain in chains(line):
            first, last = chain[0].left, chain[-1].right
            if len(set(names_in(first))) != 1 or not self._is_value(last, meanings, line, open_):
                continue
            if not self._changes(first, meanings, line):
                continue  # 3/√5 is a multiple of any number
            pair = self._both(world, first, quantity, meanings, line)
            if pair is None:
                continue
            own, asked = pair
            if isinstance(own, Vector | Angle) or isinstance(asked, Vector | Angle):
                continue
            a, b = spread_of(world, own), spread_of(world, asked)
            if is_zero(world, asked):
                continue
            ratio = a / np.where(b == 0, 1.0, b)
            if np.ptp(ratio) <= _NEAR * abs(ratio[0]) and abs(ratio[0]) > _NEAR:
                return True
        return False

    def _computes(self, quantity: Expression, line: JudgedLine, open_: bool = False) -> bool:
        """Whether a true line without a name computes what a quantity is worth, and is not zero."""
        if line.verdict != "true":
            return False
        meanings = self._meanings(line)
        for chain in chains(line):
            first, last = chain[0].left, chain[-1].right
            impulse = isinstance(first, Letter) and first.name in _IMPULSE
            impulse = impulse and is_quantity(quantity, "impulse")
            nameless = self._is_nameless(first, meanings, line, open_)
            if not nameless and not impulse:
                continue
            if isinstance(last, Number) and is_quantity(quantity, *ANGLES):
                last = Degrees(last.value)  # 60 + 30 = 90
            pair = self._both(self._base, last, quantity, meanings, line)
            if pair is None:
                continue
            worth, asked = pair
            rounded = line.line.links[-1].decimals and line.accuracy != "coarse"
            near = is_rounded if rounded else are_same
            same = near(self._base, worth, asked) or self._is_typed_for(last, worth, asked, line)
            if same and not is_zero(self._base, asked):
                return True
        return False

    def _is_typed_for(self, side: Expression, worth: Value, asked: Value, line: JudgedLine) -> bool:
        """Whether a side is a decimal of two figures or more, and rounds what is asked."""
        own = [
            decimal
            for link in line.line.links
            for decimal in link.decimals
            if decimal.column == column_of(side) and decimal.figures >= _FIGURES
        ]
        if not own or any(isinstance(value, Vector) for value in (worth, asked)):
            return False
        if isinstance(asked, Angle) != isinstance(worth, Angle):
            return False
        a, b = (np.abs(spread_of(self._base, value)) for value in (worth, asked))
        if isinstance(asked, Angle):
            a, b = np.degrees(a), np.degrees(b)
        return bool(np.all(np.abs(a - b) <= float(own[0].half_unit) * (1 + _NEAR)))

    def _is_nameless(
        self,
        side: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
        open_: bool = False,
    ) -> bool:
        """Whether a side is a calculation, or a letter of which no meaning is known."""
        if isinstance(side, Number):
            return False
        if isinstance(side, Letter):
            if line.uses and all(use.principle == "arithmetic" for use in line.uses):
                return True
            return side.name not in meanings and not self._has_value(side, meanings, line)
        return self._is_value(side, meanings, line, open_)

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
            are_near(square, size**2) for _, square in self._squares(quantity, line)
        )

    def _squares(self, quantity: Expression, line: JudgedLine) -> list[tuple[Expression, Array]]:
        """The components of a velocity that a sound line gives a value, with their true squares."""
        if not is_quantity(quantity, "velocity", "speed"):
            return []
        if line.verdict not in ("true", "follows", "false"):
            return []
        velocity = replace(quantity, kind="velocity")
        meanings = self._meanings(line)
        squares: list[tuple[Expression, Array]] = []
        for chain in chains(line):
            sides = chain[0].left, chain[-1].right
            for named, value in (sides, sides[::-1]):
                tree = exchanged(named, {Letter(name): meant for name, meant in meanings.items()})
                own = list(quantities_in(tree))
                speed = is_quantity(tree, "speed") and self._base.is_in_one_line
                own = [replace(one, kind="velocity") for one in own] if speed else own
                if not any(self._names(quantity, velocity, {}, line) for quantity in own):
                    continue
                parts = [tree]
                if not (speed or self._is_component(tree)):
                    parts = list(self._known_parts(tree, value, line))
                elif not self._is_value(value, meanings, line):
                    continue
                for part in parts:
                    try:
                        true = self._base.value(part, meanings, line.line.scope)
                    except UnvaluedError:
                        continue
                    if not isinstance(true, Vector):
                        squares.append((unsigned(part), spread_of(self._base, true) ** 2))
        return squares

    def _known_parts(
        self, velocity: Expression, vector: Expression, line: JudgedLine
    ) -> Iterator[Expression]:
        """The components that a vector with a letter in it gives a velocity: of ``v = 2i + pj``."""
        own = self._meanings(line).keys()
        if isinstance(vector, Pair) and is_quantity(velocity, "velocity"):
            for part, unit in ((vector.x, Unit("i")), (vector.y, Unit("j"))):
                if not letters(part) & own:
                    yield Quantity("along", (velocity, unit))
            return
        terms = [vector]
        while any(is_binary(term, "+", "-") for term in terms):
            terms = [
                part
                for term in terms
                for part in ((term.left, term.right) if is_binary(term, "+", "-") else (term,))
            ]
        if len(terms) < 2 or not is_quantity(velocity, "velocity"):
            return
        for term in terms:
            axes = [node for node in walk(term) if isinstance(node, Unit)]
            if len(axes) == 1 and not letters(term) & own:
                yield Quantity("along", (velocity, axes[0]))

    def _is_component(self, tree: Expression) -> bool:
        """Whether a tree is a component of a velocity, or that turned round."""
        if isinstance(tree, Negate):
            (tree,) = children(tree)
        return is_component(tree)

    def _size(self, quantity: Expression) -> Array | None:
        """The true size of a velocity or speed; None where a quantity is neither."""
        if not is_quantity(quantity, "velocity", "speed"):
            return None
        try:
            return spread_of(self._base, self._base.value(replace(quantity, kind="speed")))
        except UnvaluedError:
            return None

    def _names(
        self,
        side: Expression,
        quantity: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
    ) -> bool:
        """Whether a side is worth what a quantity is, up to a sign, whatever happens."""
        world = self._scattered
        pair = self._both(world, side, quantity, meanings, line)
        if pair is None:
            return False
        own, asked = pair
        return are_same(world, own, asked) or self._is_size_of(side, quantity, meanings)

    def _is_size_of(
        self, side: Expression, quantity: Expression, meanings: Mapping[str, Expression]
    ) -> bool:
        """Whether a side is the size, or a component, of an impulse: smooth bodies meet."""
        inner = side.argument if is_function(side, "abs") else side
        meant = meanings.get(inner.name, inner) if isinstance(inner, Letter) else inner
        meant = meant if inner is side else Apply("abs", meant)
        if not is_quantity(quantity, "impulse") or quantity.arguments:
            return False
        try:
            own, asked = self._base.value(meant), self._base.value(quantity)
        except UnvaluedError:
            return False
        if isinstance(own, Vector):
            parts = [part for part in (own.x, own.y) if not is_zero(self._base, part)]
            own = parts[0] if len(parts) == 1 else own  # 14j is as great as 14
        inside = [quantity for quantity in quantities_in(meant) if quantity.kind == "impulse"]
        return bool(inside) and not isinstance(own, Vector) and are_same(self._base, own, asked)

    def _changes(
        self, side: Expression, meanings: Mapping[str, Expression], line: JudgedLine
    ) -> bool:
        try:
            true = self._base.value(side, meanings, line.line.scope)
            other = self._scattered.value(side, meanings, line.line.scope)
        except UnvaluedError:
            return False
        return not are_same(self._base, true, other)

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
        return are_same(self._base, true, other)

    @property
    def _base(self) -> World:
        return self.worlds[0]

    @cached_property
    def _scattered(self) -> World:
        return scattered_world(self._base, self.unknown)

    @cached_property
    def _lawful(self) -> World | None:
        """A world in which all laws hold, with other letters than the question leads to."""
        return told_world(self._base, self.unknown) if self.unknown else None

    @cached_property
    def _released(self) -> World:
        """A world in which velocities are scattered, and no letters of the statement."""
        return scattered_world(self._base, frozenset())

    def _meanings(self, line: JudgedLine) -> Mapping[str, Expression]:
        return {**Interpretation(self.letters).trees(line.line.number), **line.meant}


def names_in(tree: Expression) -> Iterator[Expression]:
    """The letters and quantities of a tree; those within a quantity are left out."""
    if isinstance(tree, Letter | Quantity):
        yield tree
        return
    for child in children(tree):
        yield from names_in(child)


def are_same(world: World, one: Value, other: Value) -> bool:
    """Whether two values agree in all samples, up to a sign."""
    if isinstance(one, Vector) or isinstance(other, Vector):
        if not (isinstance(one, Vector) and isinstance(other, Vector)):
            return False
        return any(
            are_near(world.spread(one.x), sign * world.spread(other.x))
            and are_near(world.spread(one.y), sign * world.spread(other.y))
            for sign in (1, -1)
        )
    a, b = spread_of(world, one), spread_of(world, other)
    return are_near(a, b) or are_near(a, -b)


def is_rounded(world: World, own: Value, true: Value) -> bool:
    """Whether a value is another one to 3 figures; a bare number is an angle in degrees."""
    if isinstance(own, Vector) or isinstance(true, Vector):
        return are_same(world, own, true)
    a, b = spread_of(world, own), spread_of(world, true)
    if isinstance(true, Angle) and not isinstance(own, Angle):
        a = np.radians(a)
    return bool(np.allclose(np.abs(a), np.abs(b), rtol=_ROUNDED))


def is_fine(tree: Expression) -> bool:
    """Whether a value is a decimal."""
    return isinstance(tree, Number) and tree.value.denominator != 1


def is_zero(world: World, value: Value) -> bool:
    """Whether a value is zero in every sample."""
    if isinstance(value, Vector):
        return is_zero(world, value.x) and is_zero(world, value.y)
    number = spread_of(world, value)
    return are_near(number, 0 * number)


def spread_of(world: World, value: Value) -> Array:
    """A number, or the measure of an angle, in every sample."""
    return world.spread(value.measure() if isinstance(value, Angle) else value)


def are_near(a: Array, b: Array) -> bool:
    """Whether two values are one in every sample, but for the last figures."""
    return bool(np.allclose(a, b, rtol=_NEAR, atol=_NEAR))


def are_close(one: Array, other: Array) -> bool:
    """Whether two sizes agree to three figures."""
    return bool(np.all(np.abs(one - other) <= 0.005 * np.abs(other)))
