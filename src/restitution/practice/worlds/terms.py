"""A law with numbers put in, recognised by its terms.

Where components have been found, a student puts their values into the next law, and no state but
the true one satisfies the line any more. Its terms still are those of the law, up to a common
factor: each is a term of the law, or a sum of some, as it is or with its value in its place.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import lru_cache, reduce
from itertools import combinations, permutations

import numpy as np

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    is_binary,
    is_quantity,
    letters,
    negated,
    unsigned,
    walk,
)
from restitution.practice.judgement import Use
from restitution.practice.script import Claim, Scope
from restitution.practice.worlds.arrays import Array, UnvaluedError
from restitution.practice.worlds.states import States
from restitution.practice.worlds.telling import Meanings, Telling
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given, Impact
from restitution.records import dataclass
from restitution.vector import Vector

_MOST = 7
_MOST_FACTORS = 5
_ONE = Number(Fraction(1))
_NOTHING = 1e-9
_RESOLVING = frozenset({"sin", "cos"})
_TRIGONOMETRIC = frozenset({"sin", "cos", "tan"})


@dataclass(frozen=True, eq=False)
class Slots:
    """A law of an event as terms that add up to zero, each an array over the samples.

    By one of ``cancelled`` all terms may have been divided.
    """

    law: str
    event: int
    bodies: tuple[str, ...]
    terms: tuple[Array, ...]
    cancelled: tuple[Array, ...] = ()


def law_put_in(
    claim: Claim, tried: States, meanings: Meanings, scope: Scope, *, exact: bool
) -> Use | None:
    """The law of which a true line has all the terms, some with their values; None if none is.

    ``tried`` are the states of the world in which the line is true; where it is so to some figures
    only, ``exact`` is False.
    """
    for terms in terms_of(claim):
        try:
            values = [tried.world.value(term, meanings, scope) for term in terms]
        except UnvaluedError:
            continue
        matches = list(_matches(tried, values, exact))
        matches.sort(key=lambda match: not _mentions_coefficient(claim, match.slots, tried.world))
        for usual in (True, False):
            for match in matches:
                if match.fits(usual=usual):
                    slots = match.slots
                    return Use(slots.law, slots.event, slots.bodies)
    return None


def _matches(tried: States, values: Sequence[object], exact: bool) -> Iterator[_Match]:
    for slots in _laws(tried.world):
        try:
            numbers = [_number(tried.world, value, slots.event) for value in values]
        except UnvaluedError:
            continue
        yield _Match(tried, slots, numbers, exact)


def _mentions_coefficient(claim: Claim, slots: Slots, world: World) -> bool:
    """Whether a law of restitution is meant: the coefficient stands in the line as given."""
    step = world.events[slots.event - 1]
    if slots.law != "restitution" or not isinstance(step, Impact):
        return False
    e = Letter("e") if step.e is None else step.e
    return any(e == node for side in (claim.left, claim.right) for node in walk(side))


def _number(world: World, value: object, event: int) -> Array:
    """A term as a number; of a vector, its component along the line of centres."""
    if isinstance(value, Vector):
        return world.spread(value.dot(world.lines[event]))
    if not isinstance(value, np.ndarray | float):
        raise UnvaluedError("an angle is no term of a law")
    return world.spread(value)


# --- terms ----------------------------------------------------------------------------------------


@lru_cache(maxsize=1024)
def terms_of(claim: Claim) -> tuple[tuple[Expression, ...], ...]:
    """The terms of a line that add up to zero, brackets multiplied out.

    There may be two ways: as it stands, and with a quotient on one side cleared. One that has more
    terms than any law is left out.
    """
    expansions = []
    for left, right in _forms(claim):
        try:
            terms = (*_expanded(left), *(negated(tree) for tree in _expanded(right)))
        except _TooManyError:
            continue
        if len(terms) <= _MOST:
            expansions.append(terms)
    return tuple(expansions)


class _TooManyError(Exception):
    """More terms than any law has."""


def _forms(claim: Claim) -> Iterator[tuple[Expression, Expression]]:
    """Both sides as they stand, and without a quotient that is alone on its side."""
    left, right = claim.left, claim.right
    yield left, right
    if is_binary(left, "/"):
        yield left.left, _times(right, left.right)
    if is_binary(right, "/"):
        yield _times(left, right.right), right.left


def _expanded(tree: Expression) -> list[Expression]:
    if isinstance(tree, Negate):
        return [negated(other) for other in _expanded(tree.operand)]
    if not isinstance(tree, Binary) or tree.op == "^":
        return [tree]
    left = _expanded(tree.left)
    if tree.op == "/":
        return [Binary("/", other, tree.right) for other in left]
    right = _expanded(tree.right)
    if tree.op == "+":
        terms = left + right
    elif tree.op == "-":
        terms = left + [negated(tree) for tree in right]
    else:
        terms = [_times(one, other) for one in left for other in right]
    if len(terms) > _MOST:
        raise _TooManyError
    return terms


def _times(left: Expression, right: Expression) -> Expression:
    return Binary("*", left, right)


# --- laws -----------------------------------------------------------------------------------------


def _laws(world: World) -> Iterator[Slots]:
    """The laws of all impacts as terms, the latest first."""
    telling = Telling(world, degrees=False)
    for number in range(len(world.events), 0, -1):
        step = world.events[number - 1]
        if isinstance(step, Impact):
            yield from _laws_at(telling, number, step)


def _laws_at(telling: Telling, number: int, step: Impact) -> Iterator[Slots]:
    world, line = telling.world, telling.world.lines[number]
    spheres = tuple(name for name in (step.first, step.second) if name in world.start)

    def parts(name: str, stage: int) -> tuple[Array, Array]:
        v = telling.velocity(name, stage)
        return world.spread(v.dot(line)), world.spread(v.cross(line))

    before = [parts(name, number - 1) for name in spheres]
    after = [parts(name, number) for name in spheres]
    e = world.spread(telling.coefficient(number))
    masses = [world.spread(telling.mass(name)) for name in spheres]
    if len(spheres) == 2:
        start = [m * p for m, (p, _) in zip(masses, before, strict=True)]
        end = [-m * q for m, (q, _) in zip(masses, after, strict=True)]
        common = (*masses, *_letters_of_masses(telling, spheres))
        yield Slots("momentum", number, spheres, (*start, *end), common)
        yield Slots("momentum", number, spheres, (start[0] + start[1], *end), common)
        apart = (after[1][0], -after[0][0])
        yield Slots("restitution", number, spheres, (*apart, -e * before[0][0], e * before[1][0]))
        yield Slots("restitution", number, spheres, (*apart, -e * (before[0][0] - before[1][0])))
    else:
        yield Slots("restitution", number, spheres, (after[0][0], e * before[0][0]))
    for name, m, (p, s), (q, r) in zip(spheres, masses, before, after, strict=True):
        size = np.abs(m * (q - p))
        sign = np.sign(q - p)
        yield Slots("impulse", number, (name,), (size, -sign * m * q, sign * m * p), (m,))
        yield Slots("unchanged", number, (name,), (r, -s))


def _letters_of_masses(telling: Telling, spheres: Sequence[str]) -> tuple[Array, ...]:
    """The letters in which masses are written."""
    masses = (telling.spheres[name].mass for name in spheres)
    names = {x for mass in masses if isinstance(mass, Expression) for x in letters(mass)}
    known = telling.world.letters
    return tuple(telling.world.spread(known[name]) for name in sorted(names) if name in known)


class _Match:
    """A match of the terms of a line with those of a law."""

    def __init__(self, tried: States, slots: Slots, numbers: Sequence[Array], exact: bool) -> None:
        self.slots = slots
        self.rows = tried.rows
        self.near = 1e-6 if exact else 5e-3
        loose = tried.loose(slots.event)
        self.true = [number[: tried.rows] for number in numbers]
        self.free = [number[loose] for number in numbers]
        kept = [term for term in slots.terms if np.any(np.abs(term[: tried.rows]) > _NOTHING)]
        self.terms = [(term[: tried.rows], term[loose]) for term in kept]
        # The velocity of a body that was at rest is no impulse divided by its mass.
        alone = slots.law == "impulse" and len(kept) < len(slots.terms)
        divided = () if alone else slots.cancelled
        self.cancelled = [np.ones(tried.rows), *(x[: tried.rows] for x in divided)]
        self.masks = range(1, 2 ** len(self.true))
        self.sums = [self._sum(self.true, mask) for mask in range(2 ** len(self.true))]

    def _sum(self, numbers: Sequence[Array], mask: int) -> Array:
        total = np.zeros_like(numbers[0])
        for place, number in enumerate(numbers):
            if mask >> place & 1:
                total = total + number
        return total

    def fits(self, *, usual: bool) -> bool:
        """Whether every term of the law is a sum of terms of the line, up to one factor.

        A ``usual`` factor is 1 or -1, perhaps divided by a mass. Of two terms any two equal numbers
        are a multiple, and of an impulse one side is the sum of the others: for these no other
        will do.
        """
        count = len(self.terms)
        needs_usual = count == 2 or self.slots.law == "impulse"
        if not 2 <= count <= len(self.true) or (needs_usual and not usual):
            return False
        target, _ = self.terms[0]
        with np.errstate(all="ignore"):
            factors = ((self.sums[mask] / target, (mask,)) for mask in self.masks)
            return any(
                np.all(np.isfinite(factor) & (np.abs(factor) > _NOTHING))
                and self._is_usual(factor) == usual
                and self._covers(factor, masks)
                for factor, masks in factors
            )

    def _is_usual(self, factor: Array) -> bool:
        return any(
            np.all(np.abs(np.abs(factor * letter) - 1) < self.near) for letter in self.cancelled
        )

    def _covers(self, factor: Array, masks: tuple[int, ...]) -> bool:
        used = sum(masks)
        if len(masks) == len(self.terms):
            return used == 2 ** len(self.true) - 1 and self._follows(factor, masks)
        wanted = factor * self.terms[len(masks)][0]
        size = np.maximum(np.abs(wanted), np.abs(factor * self.terms[0][0]))
        return any(
            np.all(np.abs(self.sums[mask] - wanted) <= self.near * size)
            and self._covers(factor, (*masks, mask))
            for mask in self.masks
            if not mask & used
        )

    def _follows(self, factor: Array, masks: Sequence[int]) -> bool:
        """Whether each term moves with that of the law in loose states, or not at all.

        One may move otherwise, as a fact may give it by another one; but of two only where the law
        is not the same number in all samples, and no sum: u − 8eu = 3v is solved for v, whatever
        component that stays is u.
        """
        strays = 0
        for mask, (_, loose) in zip(masks, self.terms, strict=True):
            free, wanted = self._sum(self.free, mask), factor * loose
            size = np.abs(wanted) + np.abs(self.sums[mask])
            moves = np.abs(free - wanted) <= self.near * size
            stays = np.abs(free - self.sums[mask]) <= self.near * size
            strayed = not (np.all(moves) or np.all(stays))
            if strayed and len(self.terms) == 2 and mask.bit_count() > 1:
                return False
            strays += strayed
        return strays <= (len(self.terms) > 2 or bool(np.ptp(self.terms[0][0]) > _NOTHING))


# --- products with the coefficient ----------------------------------------------------------------


def coefficient_put_in(claim: Claim, world: World, meanings: Meanings, scope: Scope) -> Use | None:
    """The impact at which a line multiplies an approach by e, or divides a separation by it."""
    telling = Telling(world, degrees=False)
    for number in range(len(world.events), 0, -1):
        step = world.events[number - 1]
        if not isinstance(step, Impact):
            continue
        e = world.spread(telling.coefficient(number))
        line = world.lines[number]
        spheres = tuple(name for name in (step.first, step.second) if name in world.start)
        apart, after = (
            _relative([telling.velocity(name, stage) for name in spheres]).dot(line)
            for stage in (number - 1, number)
        )
        for node, other in _products(claim):
            if _has_size(node, e, world, meanings, scope):
                wanted = after if isinstance(other, _Divided) else apart
                tree = other.tree if isinstance(other, _Divided) else other
                if _has_size(tree, np.abs(world.spread(wanted)), world, meanings, scope):
                    return Use("restitution", number, spheres)
        known = Letter("e") if step.e is None else step.e
        for side in (claim.left, claim.right) if isinstance(known, Letter) else ():
            product_of_e = known in walk(side) and not any(
                is_binary(node, "+", "-") for node in walk(side)
            )
            if product_of_e and _has_size(side, e * np.abs(apart), world, meanings, scope):
                return Use("restitution", number, spheres)
    return None


def impulse_put_in(claim: Claim, world: World) -> Use | None:
    """The impact of which a line divides the impulse that is given by a mass: ``2.5/0.25 = 10``."""
    sizes = {
        value
        for _, step in world.problem.steps()
        if isinstance(step, Given)
        for relation in step.relations
        if isinstance(relation, Compare)
        for one, other in permutations(relation.operands, 2)
        if is_quantity(one, "impulse") and (value := _plain_number(other)) is not None
    }
    masses = {
        sphere.name: value
        for sphere in world.problem.spheres
        if isinstance(sphere.mass, Expression) and (value := _plain_number(sphere.mass)) is not None
    }
    impacts = [n for n, step in enumerate(world.events, 1) if isinstance(step, Impact)]
    if "e" in letters(claim.left) | letters(claim.right):
        return None  # 10/3 = 5e is Newton's law with the velocity that the impulse gives
    for side in (claim.left, claim.right):
        if sizes and len(impacts) == 1 and is_binary(side, "/"):
            above, below = _plain_number(unsigned(side.left)), _plain_number(side.right)
            bodies = tuple(name for name, mass in masses.items() if mass == below)
            if above in sizes and bodies:
                return Use("impulse", impacts[0], bodies[:1])
    return None


def _plain_number(tree: Expression) -> Fraction | None:
    match tree:
        case Number(value):
            return value
        case Binary("/", Number(above), Number(below)) if below:
            return above / below
    return None


def component_put_in(claim: Claim, world: World, scope: Scope) -> Use | None:
    """The impact at which a line in numbers works out a component that does not change.

    It is worked out from a speed and an angle, or by a scalar product.
    """
    if not any(_resolves(node) for side in (claim.left, claim.right) for node in walk(side)):
        return None
    telling = Telling(world, degrees=False)
    for number in range(len(world.events), 0, -1):
        step = world.events[number - 1]
        if not isinstance(step, Impact):
            continue
        for name in (step.first, step.second):
            if name not in world.start:
                continue
            before = telling.velocity(name, number - 1)
            across = np.abs(world.spread(before.cross(world.lines[number])))
            along = np.abs(world.spread(before.dot(world.lines[number])))
            apart = np.all(np.abs(across - along) > 1e-3 * across)
            if apart and _has_size(claim.right, across, world, {}, scope):
                return Use("unchanged", number, (name,))
    return None


def _resolves(tree: Expression) -> bool:
    """Whether a tree is a sine or a cosine, or a scalar product."""
    if isinstance(tree, Apply):
        return tree.function in _RESOLVING
    return is_quantity(tree, "dot")


@dataclass(frozen=True)
class _Divided:
    """What stands above the coefficient."""

    tree: Expression


def _relative(velocities: Sequence[Vector]) -> Vector:
    return velocities[0] - velocities[1] if len(velocities) > 1 else velocities[0]


def _products(claim: Claim) -> Iterator[tuple[Expression, Expression | _Divided]]:
    """Some factors of a side with the product of the others, or with what stands above them.

    To divide is to multiply by one over it: ``5 × 2/5`` has the factor 2/5, ``6/3`` a third.
    """
    for side in (claim.left, claim.right):
        tree = unsigned(side)
        if not isinstance(tree, Binary):
            continue
        if tree.op == "/":
            yield tree.right, _Divided(tree.left)
        factors = list(_factors(tree))[:_MOST_FACTORS]
        for number in range(1, len(factors)):
            for chosen in combinations(range(len(factors)), number):
                rest = [factor for place, factor in enumerate(factors) if place not in chosen]
                yield _product_of([factors[place] for place in chosen]), _product_of(rest)


def _product_of(factors: Sequence[Expression]) -> Expression:
    return reduce(_times, factors)


def _factors(tree: Expression) -> Iterator[Expression]:
    if is_binary(tree, "*"):
        yield from _factors(tree.left)
        yield from _factors(tree.right)
    elif is_binary(tree, "/"):
        yield from _factors(tree.left)
        yield from (Binary("/", _ONE, factor) for factor in _factors(tree.right))
    else:
        yield tree


def _has_size(
    tree: Expression, size: Array, world: World, meanings: Meanings, scope: Scope
) -> bool:
    """Whether a tree has a size that is not zero, to some figures."""
    try:
        value = np.abs(world.scalar(tree, meanings, scope=scope))
    except UnvaluedError:
        return False
    return bool(np.all((size > _NOTHING) & (np.abs(value - size) <= 1e-3 * size)))


# --- angles ---------------------------------------------------------------------------------------


def is_triangle(claim: Claim, world: World, meanings: Meanings, scope: Scope) -> bool:
    """Whether a line takes a ratio of components, or of a component and a speed, for an angle."""
    sizes = _sizes(world)
    return any(
        _is_size(node.left, sizes, world, meanings, scope)
        and _is_size(node.right, sizes, world, meanings, scope)
        for side in _ratios(claim)
        for node in walk(side)
        if is_binary(node, "/")
    )


def _ratios(claim: Claim) -> Iterator[Expression]:
    """What a line equates with the sine, cosine or tangent of an angle."""
    for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
        if isinstance(one, Apply) and one.function in _TRIGONOMETRIC:
            yield other
        yield from (
            node.argument
            for node in walk(one)
            if isinstance(node, Apply) and node.function.startswith("arc")
        )


def _sizes(world: World) -> Array:
    """Components along lines of centres, across them, along i and j, and speeds, as sizes."""
    known = world._known.get("sizes")
    if known is None:
        telling = Telling(world, degrees=False)
        lines = [*world.lines.values(), Vector(np.float64(1), np.float64(0))]
        velocities = [
            telling.velocity(name, stage)
            for name in world.start
            for stage in range(len(world.events) + 1)
        ]
        sizes = [
            np.abs(world.spread(x))
            for v in velocities
            for x in (*(f(line) for line in lines for f in (v.dot, v.cross)), np.hypot(*v))
        ]
        known = world._known["sizes"] = np.array([x for x in sizes if np.all(x > _NOTHING)])
    return known


def _is_size(
    tree: Expression, sizes: Array, world: World, meanings: Meanings, scope: Scope
) -> bool:
    try:
        value = np.abs(world.scalar(tree, meanings, scope=scope))
    except UnvaluedError:
        return False
    return bool(len(sizes)) and bool(np.any(np.all(np.abs(sizes - value) <= 5e-3 * sizes, axis=1)))
