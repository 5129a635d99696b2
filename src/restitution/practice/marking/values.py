"""What a student's lines give to the points of a scheme: values, equations, what they show."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import FLIPPED, Link
from restitution.expression.quantities import ANGLES, ENERGIES
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    is_function,
    is_quantity,
    letters,
    quantities_in,
    walk,
)
from restitution.practice.judgement import JudgedLine
from restitution.practice.judging.support import is_sum_for_product
from restitution.practice.marking.carried_components import CarriedComponents
from restitution.practice.marking.line_contents import (
    Match,
)
from restitution.practice.marking.lines import chains, ratios_of_angles
from restitution.practice.marking.scheme import MarkPoint
from restitution.practice.marking.sides import (
    are_close,
    are_near,
    is_fine,
    names_in,
    spread_of,
)
from restitution.practice.reading.quoted import has_data
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.arrays import Array, UnvaluedError, is_bare
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given, Impact
from restitution.records import dataclass
from restitution.vector import Vector

# So near, relative to it, a decimal may be meant for a value that stands above.
_CONVERTED = 0.05
# So near is the end of a range, as a decimal too.
_END, _ZERO = 0.006, 1e-9
# Of a decimal that is an answer.
_FIGURES = 3
_SEVERAL = 2
# What is said of a line that rests on several laws.
_OF_SEVERAL = ("solve", "value", "fact")
# The quantities of which a line of a principle speaks.
_KINDS_OF_FACTS: Mapping[str, frozenset[str]] = {
    "speed": ENERGIES | {"speed"},
    "energy": ENERGIES | {"speed"},
    "deflection": ANGLES,
    "angle": ANGLES | {"line_of_centres"},
}


def _bounds_of(point: MarkPoint) -> Iterator[tuple[str, Expression, Expression]]:
    """The ends of the range that a point is for: the sign, what is bounded, and the end."""
    single = (point.link,) if point.link is not None and point.link.sign in FLIPPED else ()
    bounds = point.bounds or single
    if point.item is None or point.shown:
        return
    between = {bound.left for bound in bounds} & {bound.right for bound in bounds}
    named = {
        x for bound in bounds for x in (bound.left, bound.right) if isinstance(x, Letter | Quantity)
    }
    ranged = between or {x for x in named if not is_bare(x)}
    for bound in bounds if len(ranged) == 1 else ():
        if bound.left in ranged:
            yield bound.sign, bound.left, bound.right
        elif bound.right in ranged:
            yield FLIPPED[bound.sign], bound.right, bound.left


@dataclass(frozen=True, eq=False)
class Values(CarriedComponents):
    """The values of a part, and how the lines of a script reach them."""

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
        ends = [point.link.left, *(end for _, _, end in _bounds_of(point))]
        if point.link.sign != "=" and any(self._gives_end(end, line) for end in ends):
            return self._match(line)
        if not point.shown and not self._gives(point.link.left, line, self._is_open(point, line)):
            computed = point.principle in ("energy", "component") or point.letter == "A"
            computed = computed or point.item is not None
            open_ = self._is_open(point, line)
            left = point.link.left
            trees = (left, left.argument) if is_function(left, "tan", "cos", "sin") else (left,)
            computed = computed and any(self._computes(tree, line, open_) for tree in trees)
            between = point.letter == "A" and point.item is None
            computed = computed or (between and self.gives_multiple(point, line))
            computed = computed or (between and self.gives_part(point, line))
            whole = self._gives_whole(point.link.left, line)
            if not computed and (not whole or self.is_slanted(point)):
                return None
        return self._match(line)

    def _gives_end(self, end: Expression, line: JudgedLine) -> bool:
        """Whether a line compares something with the end of a range as a decimal: ``e > 0.340``."""
        if any(names_in(end)) or any(quantities_in(end)) or line.verdict != "true":
            return False
        try:
            value = float(self.worlds[0].scalar(end).flat[0])
        except RestitutionError:
            return False
        return any(
            decimal.figures >= _FIGURES and abs(float(decimal.value) - value) <= decimal.half_unit
            for link in line.line.links
            if link.readings[0].sign in ("<", "<=", ">", ">=")
            for decimal in link.decimals
        )

    def is_bound(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line bounds the letter, or the quantity, whose range a point is for."""
        return any(self._bounds_in(point, line))

    def is_other_range(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a true line bounds what a range is of, and not by the ends of that range.

        An end that it leaves out is none of its own.
        """
        true = {sign[0]: end for sign, _, end in _bounds_of(point)}
        own: dict[str, list[Expression]] = {}
        for sign, end in self._bounds_in(point, line):
            own.setdefault(sign[0], []).append(end)
        return line.verdict == "true" and any(
            sign in true and not any(self._is_end(end, true[sign], line) for end in ends)
            for sign, ends in own.items()
        )

    def lacks_an_end(self, point: MarkPoint, lines: Sequence[JudgedLine]) -> bool:
        """Whether a range has two ends, and lines speak of one of them alone.

        That what is positive is greater than zero need not be said.
        """
        ends = {sign[0]: end for sign, _, end in _bounds_of(point)}
        needed = {sign for sign, end in ends.items() if end != Number(Fraction(0))}
        own = {sign[0] for line in lines for sign, _ in self._bounds_in(point, line)}
        return len(ends) > 1 and bool(own) and not needed <= own

    def restates_a_fact(self, line: JudgedLine) -> bool:
        """Whether an inequality is one that the question gives, before anything is put in."""
        facts = [
            pair
            for _, step in self.worlds[0].problem.steps()
            if isinstance(step, Given)
            for fact in step.relations
            if isinstance(fact, Compare) and "=" not in fact.operators
            for pair in pairwise(fact.operands)
            if any(map(any, map(quantities_in, pair)))
        ]
        meanings = self._meanings(line)
        own = [claim for chain in chains(line) for claim in chain if claim.sign in FLIPPED]
        return (
            line.verdict == "true"
            and bool(own)
            and all(
                any(
                    self._names(one, left, meanings, line) and other == right
                    for one, other in ((claim.left, claim.right), (claim.right, claim.left))
                    for left, right in facts
                )
                for claim in own
            )
        )

    def _is_end(self, own: Expression, true: Expression, line: JudgedLine) -> bool:
        try:
            value = self._base.scalar(own, self._meanings(line), scope=line.line.scope)
            end = self._base.scalar(true)
        except RestitutionError:
            return True  # nobody knows its value
        return bool(np.all(np.abs(value - end) <= _END * np.abs(end) + _ZERO))

    def _bounds_in(self, point: MarkPoint, line: JudgedLine) -> Iterator[tuple[str, Expression]]:
        """The bounds that a line gives for what a point has the range of, by sign and end."""
        ranged = {quantity for _, quantity, _ in _bounds_of(point)}
        meanings = self._meanings(line)
        for claim in (claim for chain in chains(line) for claim in chain if claim.sign in FLIPPED):
            for sign, side, end in (
                (claim.sign, claim.left, claim.right),
                (FLIPPED[claim.sign], claim.right, claim.left),
            ):
                if any(self._names(side, tree, meanings, line) for tree in ranged):
                    yield sign, end

    def replaces(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives what is asked another value, and no decimal of the true one.

        A chain that has the true value as well withdraws nothing.
        """
        link = point.link
        if link is None or point.item is None or point.shown or link.sign not in ("=", "≈"):
            return False
        value = self.value_of(link.left, line)
        sides = [
            side for chain in chains(line) for claim in chain for side in (claim.left, claim.right)
        ]
        if sides and line.line.text.lstrip().startswith("="):
            value, sides = sides[-1], sides[-1:]  # it works out what stands in the line above
        bare = (side for side in sides if not any(names_in(side)))
        if value is None or any(self._is_worth(side, link.left, line) for side in bare):
            return False
        try:
            own = np.abs(self._base.scalar(value, self._meanings(line), scope=line.line.scope))
            true = np.abs(self._base.scalar(link.left))
        except RestitutionError:
            return True  # a vector is not rounded to be another one
        return not bool(np.all(np.abs(own - true) <= _CONVERTED * true))

    def has_ratios(self, point: MarkPoint, line: JudgedLine | None) -> bool:
        """Whether the value in a line is not worked out: ``v = 6 cos 55/cos 40``."""
        value = None if line is None or point.link is None else self.value_of(point.link.left, line)
        return value is not None and any(
            is_function(node, "sin", "cos", "tan") and isinstance(node.argument, Degrees)
            for node in walk(value)
        )

    def compares(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a true line compares the values of what a printed inequality compares."""
        link = point.link
        if link is None or line.verdict != "true" or link.sign not in FLIPPED:
            return False
        signs = {link.sign, f"{link.sign}=", link.sign.rstrip("=")}
        turned = {FLIPPED[sign] for sign in signs if sign in FLIPPED}
        return any(
            (claim.sign in signs and self._are_worth(claim.left, claim.right, link, line))
            or (claim.sign in turned and self._are_worth(claim.right, claim.left, link, line))
            for chain in chains(line)
            for claim in chain
        )

    def _are_worth(self, one: Expression, other: Expression, link: Link, line: JudgedLine) -> bool:
        """Whether two sides have the values of the two sides of a relation."""
        return self._is_worth(one, link.left, line) and self._is_worth(other, link.right, line)

    def others_at_impact(self, part: Quantity) -> Iterator[Quantity]:
        """A component after an impact as that of the other sphere that meets in it."""
        match part.arguments:
            case (Quantity("velocity", (Name(body),), int(number)) as velocity, *rest) if number:
                pass
            case _:
                return
        step = self._base.events[number - 1]
        if isinstance(step, Impact) and body in (step.first, step.second):
            other = step.second if step.first == body else step.first
            if other in self._base.start:
                own = replace(velocity, arguments=(Name(other),))
                yield replace(part, arguments=(own, *rest))

    def gives_multiple(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives a multiple of what a point is for its value."""
        link = point.link
        return link is not None and self._gives_multiple(
            link.left, line, self._is_open(point, line)
        )

    def gives_multiple_only(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line gives a multiple of what a point is for, and not that itself."""
        link = point.link
        if link is None or self._gives(link.left, line, self._is_open(point, line)):
            return False
        return self.gives_multiple(point, line)

    def speaks_for(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a side of a line names what a point is for: an angle, or its tangent."""
        return self._is_named(point, line, lambda side: (side,))

    def has_angle(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether the angle of a point is all that a line has of velocities, as a sine or so."""
        link = point.link
        if link is None or not line.uses or line.uses[0].principle not in _OF_SEVERAL:
            return False
        meanings = self._meanings(line)
        angle = link.left.argument if isinstance(link.left, Apply) else link.left
        return any(
            is_function(node, "sin", "cos", "tan", "cot")
            and self._names(node.argument, angle, meanings, line)
            and self.velocities_in(claim, line) <= {node.argument}
            for chain in chains(line)
            for claim in chain
            for side in (claim.left, claim.right)
            for node in walk(side)
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

    def completes(self, point: MarkPoint, lines: Sequence[JudgedLine]) -> Match | None:
        """Whether the last of some lines completes the components of a velocity, or a place."""
        link = point.link
        if link is None or point.shown or not isinstance(link.left, Quantity) or not lines:
            return None
        if link.left.kind == "position":
            return self._completed_place(link.left, lines)
        if link.left.kind != "velocity":
            return None
        squares = [square for line in lines for square in self._squares(link.left, line)]
        own = self._squares(link.left, lines[-1])
        if not own:
            return None
        size = self._size(link.left)
        pairs = [(a, b) for one, a in own for other, b in squares if one != other]
        if size is None or not any(are_near(a + b, size**2) for a, b in pairs):
            return None
        sound = all(line.verdict == "true" for line in lines if self._squares(link.left, line))
        return "own" if not sound else self._match(lines[-1])

    def is_right_beside(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line of several relations, of which others only follow, gives a true value."""
        link = point.link
        if link is None or point.shown or link.sign != "=" or len(list(chains(line))) < _SEVERAL:
            return False
        value = self.value_of(link.left, line)
        if value is None or self.his_own or self._is_turned(value, link.left, line):
            return False
        return self._is_worth(value, link.left, line) or (
            is_fine(value) and self._has_figures_of(value, link.left, line)
        )

    def _match(self, line: JudgedLine) -> Match:
        return "true" if line.verdict == "true" or self.his_own else "own"

    def is_solved(self, line: JudgedLine, whole: bool = False) -> bool:
        """Whether a line gives one unknown of the impact, or a multiple of it, a value.

        With ``whole`` the value may stand at the end of a chain: ``v = u/tan b = 0.2u``.
        """
        meanings = self._meanings(line)
        sides = [(x.left, x.right) for chain in chains(line) for x in chain if x.sign == "="]
        if whole:
            equal = (chain for chain in chains(line) if all(x.sign == "=" for x in chain))
            sides += [(chain[0].left, chain[-1].right) for chain in equal]
        return any(
            len(set(names_in(left))) == 1
            and self._changes(left, meanings, line)
            and self._is_value(right, meanings, line)
            for left, right in sides
        )

    def is_of_multiples(self, line: JudgedLine) -> bool:
        """Whether a line gives multiples of letters or quantities, and none by itself."""
        return not any(isinstance(chain[0].left, Letter | Quantity) for chain in chains(line))

    def is_of_the_start(self, line: JudgedLine) -> bool:
        """Whether a line tells by its letters of what stands before the impacts: ``KE before``."""
        meanings = self._meanings(line)
        sides = [
            side for chain in chains(line) for claim in chain for side in (claim.left, claim.right)
        ]
        named = any(isinstance(side, Letter) and side.name in meanings for side in sides)
        return named and not any(self._changes(side, meanings, line) for side in sides)

    def is_eliminated(self, line: JudgedLine, put_in: bool = False) -> bool:
        """Whether one velocity is left in an equation that no law alone gives.

        It may look like a law with the other velocity put in: ``u - v = kv + keu``.
        """
        own = line.uses[0].principle if line.uses else "solve"
        if own not in _OF_SEVERAL and not (own in ("momentum", "restitution") and put_in):
            return False
        names = [self.velocities_in(claim, line) for chain in chains(line) for claim in chain]
        return any(len(name) == 1 for name in names)

    def works_out_an_angle(self, line: JudgedLine, known: bool = False) -> bool:
        """Whether a line works out an angle from a ratio of two numbers.

        With ``known`` those of a tangent have to be components of a velocity.
        """
        return any(
            is_bare(ratio) and not (known and function == "arctan" and not self._is_slope(ratio))
            for chain in chains(line)
            for claim in chain
            for function, ratio in ratios_of_angles(claim)
        )

    def _is_slope(self, ratio: Expression) -> bool:
        """Whether a ratio is of two components of a velocity: along i and j, or a line and not."""
        world = self._base
        tangent = np.abs(world.scalar(ratio))
        lines = [Quantity("line_of_centres", (), number) for number in world.lines]
        for body in world.start:
            for stage in range(len(world.events) + 1):
                velocity = Quantity("velocity", (Name(body),), stage)
                v = world.value(velocity)
                assert isinstance(v, Vector)
                pairs = [(world.spread(v.x), world.spread(v.y))]
                for line in lines:
                    parts = (Quantity(kind, (velocity, line)) for kind in COMPONENTS)
                    along, across = (world.scalar(part) for part in parts)
                    pairs.append((along, across))
                if any(
                    are_close(tangent * np.abs(a), np.abs(b)) and bool(np.any(b))
                    for one, other in pairs
                    for a, b in ((one, other), (other, one))
                ):
                    return True
        return False

    def has_tangent(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line works out, by its components, the angle of a velocity to i or j.

        That is what stands in place of its speed where a path turns through a sum of angles.
        """
        left = None if point.link is None else point.link.left
        if not is_quantity(left, "speed"):
            return False
        world = self._base
        try:
            v = world.value(replace(left, kind="velocity"))
        except UnvaluedError:
            return False
        if not isinstance(v, Vector):
            return False
        for chain in chains(line):
            for side in (side for claim in chain for side in (claim.left, claim.right)):
                for node in walk(side):
                    match node:
                        case Apply("arctan", Binary("/") as ratio) if is_bare(ratio):
                            tangent = np.abs(world.scalar(ratio))
                            pairs = (v.x, v.y), (v.y, v.x)
                            if any(are_close(tangent * np.abs(a), np.abs(b)) for a, b in pairs):
                                return True
        return False

    def speaks_of(self, point: MarkPoint, principle: str) -> bool:
        """Whether a fact may be stated by a line of a principle: one of energy speaks of energies.

        A fact without a quantity may be stated in any of them.
        """
        link = point.link
        if principle == "fact" or link is None:
            return True
        kinds = {
            quantity.kind for side in (link.left, link.right) for quantity in quantities_in(side)
        }
        return not kinds or bool(kinds & _KINDS_OF_FACTS.get(principle, kinds))

    def is_formula(self, line: JudgedLine) -> bool:
        """Whether a line is a formula that is only quoted: I = m(v - u), with m and u for data."""
        inferred = {letter.letter for letter in self.letters if letter.by == "inferred"}
        meanings = self._meanings(line)
        if has_data(line.line):
            return False
        return any(
            isinstance(name, Letter)
            and name.name in inferred
            and not self._changes(name, meanings, line)
            for link in line.line.links
            for side in (link.readings[0].left, link.readings[0].right)
            for name in names_in(side)
        )

    def states(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line says what a point's own relation says, whatever happens.

        The differences of the sides of both are multiples of one another, and not zero: in any
        story, or in one with other values of what the question asks for.
        """
        worlds = (
            (self._scattered, self._lawful) if point.principle != "fact" else (self._scattered,)
        )
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
            for other in line.line.links
            for claim in other.readings[:1]
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
        """Whether the differences of two pairs have a constant ratio, but for powers of letters.

        ``16(1 - e²) = 12`` is ``(4u/5)² - (4eu/5)² = 12u²/25`` divided by u².
        """
        try:
            values = [world.value(x, meanings, line.line.scope) for x in own]
            values += [world.value(x) for x in asked]
        except UnvaluedError:
            return False
        if any(isinstance(value, Vector) for value in values):
            return False
        left, right, first, second = (spread_of(world, value) for value in values)
        a, b = left - right, first - second
        if np.any(np.abs(a) < _ZERO) or np.any(np.abs(b) < _ZERO):
            return False
        apart = {name for tree in (*own, *asked) for name in letters(tree)} - self.unknown
        sizes = [world.spread(world.letters[x]) for x in sorted(apart) if x in world.letters]
        powers = product(range(-2, 3), repeat=len(sizes)) if len(sizes) < _FIGURES else ()
        return any(
            np.ptp(ratio) < _ZERO * np.max(np.abs(ratio))
            for ratio in (a / b * _product(sizes, power) for power in ((), *powers))
        )

    def _is_printed(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line is the printed relation, its sides perhaps exchanged, or ends in it."""
        link = point.link
        assert link is not None
        meanings = self._meanings(line)
        for chain in chains(line):
            first, last = chain[0].left, chain[-1].right
            for left, right in ((first, last), (last, first)):
                if is_sum_for_product(right, link.right):
                    continue
                shares = self._is_share_of(left, link.left, meanings, line)
                if (shares or self._names(left, link.left, meanings, line)) and self._names(
                    right, link.right, meanings, line
                ):
                    return True
        return False

    def is_bare_result(self, point: MarkPoint, line: JudgedLine) -> bool:
        """Whether a line is the printed relation of a point alone, worked out from nothing."""
        link = point.link
        if link is None or not point.shown or len(line.line.links) != 1:
            return False
        claim = line.line.links[0].readings[0]
        known = letters(claim.right) <= letters(link.right) or letters(claim.left) <= letters(
            link.right
        )
        bare = known and _functions(claim) <= _functions(link)
        return bare and self._is_printed(point, line)

    def _is_share_of(
        self,
        own: Expression,
        printed: Expression,
        meanings: Mapping[str, Expression],
        line: JudgedLine,
    ) -> bool:
        """Whether a side divides by what the printed share is of: ``÷ ½mu² gives …``."""
        match own, printed:
            case Binary("/", _, below), Binary("/", _, whole):
                return self._names(below, whole, meanings, line)
        return False


def _functions(relation: Link | Claim) -> frozenset[str]:
    """The functions on both sides of a relation."""
    sides = (relation.left, relation.right)
    return frozenset(
        node.function for side in sides for node in walk(side) if isinstance(node, Apply)
    )


def _product(sizes: Sequence[Array], powers: Sequence[int]) -> Array:
    """The product of some powers."""
    return np.prod([size**power for size, power in zip(sizes, powers)], axis=0)
