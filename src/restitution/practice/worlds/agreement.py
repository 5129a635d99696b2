"""Whether the two sides of a claim agree in a world, and how exactly."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import lru_cache
from typing import Any

import numpy as np

from restitution.expression.evaluate import Angle, Value
from restitution.expression.tree import (
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    is_binary,
    unsigned,
    unsigned_terms,
    walk,
)
from restitution.practice.judgement import Accuracy
from restitution.practice.script import ANYWHERE, Claim, Decimal, Scope, Sign, column_of
from restitution.practice.worlds.arrays import Array, UnvaluedError, is_bare
from restitution.practice.worlds.telling import NO_MEANINGS, NO_NUMBERS, Meanings
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Problem, Show, trees
from restitution.vector import Vector

GRADES: tuple[Accuracy, ...] = ("exact", "rounded", "coarse")
NOT = len(GRADES)
# Of the sides of an exact line, and of what their terms are where the sides are zero.
_RELATIVE = 1e-7
_TURN = 7
_FINE = 3
"""A decimal of so many figures or more is rounded finely enough."""
_ROUNDING = 1e-11
# A half unit is met by a number that is half way, whatever its last binary place.
_SLACK = 1 + 1e-6
# Angles that are meant as they stand, in degrees.
_WHOLE = frozenset(map(Fraction, (0, 30, 45, 60, 90, 120, 135, 150, 180, 270, 360)))


def agrees(
    claim: Claim,
    world: World,
    meanings: Meanings = NO_MEANINGS,
    decimals: Sequence[Decimal] = (),
    scope: Scope = ANYWHERE,
) -> Accuracy | None:
    """How exactly a claim holds in every sample of a world; None where it does not hold.

    Of ``x = a or b`` one has to hold. Decimals of the statement are exact; so is a line that is
    exact with the decimals as they stand. Raises UnvaluedError where a side has no value.
    """
    worst = max(grades(claim, world, meanings, decimals, scope), default=NOT)
    return None if worst >= NOT else GRADES[worst]


def grades(
    claim: Claim,
    world: World,
    meanings: Meanings = NO_MEANINGS,
    decimals: Sequence[Decimal] = (),
    scope: Scope = ANYWHERE,
) -> Array:
    """How exactly a claim holds in each sample: places in `GRADES`, or `NOT`, shape (samples,).

    All samples have the unit of angle in which the claim holds best. Raises UnvaluedError where a
    side has no value.
    """
    links = [Claim(claim.left, claim.sign, right) for right in (claim.right, *claim.others)]
    by_link = []
    for link in links:
        noted: list[Expression] = []
        by_link.append(_grades(link, world, meanings, decimals, scope, True, noted))
        if noted and _are_small(noted) and by_link[-1].any():
            by_link.append(_grades(link, world, meanings, decimals, scope, False, []))
    return min(by_link, key=lambda grade: (grade.max(), grade.sum()))


def difference(
    claim: Claim,
    world: World,
    meanings: Meanings = NO_MEANINGS,
    scope: Scope = ANYWHERE,
    *,
    degrees: bool = True,
    put: Mapping[int, Array] = NO_NUMBERS,
    noted: list[Expression] | None = None,
) -> tuple[Array, Array]:
    """Left side less right side, and the size of what is compared, in every sample.

    Both have the shape (samples, 1), or (samples, 2) for vectors. Angles are in radians and differ
    by less than a half turn. A wall, or a line of centres, is told by any vector along it. Raises
    UnvaluedError where the sides are not alike.
    """
    how: dict[str, Any] = {"scope": scope, "degrees": degrees, "put": put, "noted": noted}
    left = world.value(claim.left, meanings, **how)
    right = world.value(claim.right, meanings, **how)
    with np.errstate(all="ignore"):
        lines = any(_is_line(side, world, meanings) for side in (claim.left, claim.right))
        return _difference(claim, world, left, right, degrees, noted, lines=lines)


def _difference(
    claim: Claim,
    world: World,
    left: Value,
    right: Value,
    degrees: bool,
    noted: list[Expression] | None,
    *,
    lines: bool,
) -> tuple[Array, Array]:
    left, right = _sized(claim.left, left, right), _sized(claim.right, right, left)
    if lines:
        left, right = _directed(left, right)
    if isinstance(left, Vector) or isinstance(right, Vector):
        a, b = (as_vector(side) for side in (left, right))
        size = np.maximum(np.hypot(*a), np.hypot(*b))
        return _columns(world, a.x - b.x, a.y - b.y), _columns(world, size, size)
    if isinstance(left, Angle) or isinstance(right, Angle):
        one, other = (
            _radians(tree, value, degrees, noted)
            for tree, value in ((claim.left, left), (claim.right, right))
        )
        return _columns(world, _within_a_turn(one - other)), _columns(
            world, np.maximum(np.abs(one), np.abs(other))
        )
    return _columns(world, left - right), _columns(world, np.maximum(np.abs(left), np.abs(right)))


def is_angular(claim: Claim, world: World, meanings: Meanings, scope: Scope = ANYWHERE) -> bool:
    """Whether a claim compares angles."""
    sides = (world.value(side, meanings, scope) for side in (claim.left, claim.right))
    return any(isinstance(side, Angle) for side in sides)


def scale(
    claim: Claim, world: World, meanings: Meanings = NO_MEANINGS, scope: Scope = ANYWHERE
) -> Array:
    """The sizes of the terms of both sides, added up, shape (samples, 1).

    Against these a difference counts where the sides themselves are zero.
    """
    total = np.zeros((world.samples, 1))
    for tree in (claim.left, claim.right):
        for term in unsigned_terms(tree):
            value = world.value(term, meanings, scope)
            if isinstance(value, Vector):
                value = np.hypot(value.x, value.y)
            elif isinstance(value, Angle):
                value = value.measure()
            total = total + np.abs(_columns(world, value))
    return np.where(np.isfinite(total), total, 0.0)


# --- one link -------------------------------------------------------------------------------------


def _grades(
    claim: Claim,
    world: World,
    meanings: Meanings,
    decimals: Sequence[Decimal],
    scope: Scope,
    degrees: bool,
    noted: list[Expression],
) -> Array:
    """The grades of one equation or inequality."""
    apart, size = difference(claim, world, meanings, scope, degrees=degrees, noted=noted)
    size = np.where(np.isfinite(size), size, 0.0)
    tolerance = _RELATIVE * size + _ROUNDING * _magnitude(world)
    if claim.sign == "=" and (apart != 0).any() and (np.abs(apart) <= 1e-6 * size.max()).any():
        terms = scale(claim, world, meanings, scope)
        tolerance = np.maximum(tolerance, _ROUNDING * terms)
    by_sample = np.where(_holding(claim.sign, apart, tolerance), 0, NOT)
    equal = claim.sign in ("<", ">") and np.any(np.abs(apart) <= tolerance)
    if not by_sample.any() or equal or claim.sign == "!=":
        return by_sample
    if claim.sign == "=" and (loose := looseness(world)):
        room = loose * np.maximum(size, scale(claim, world, meanings, scope))
        near = _holding(claim.sign, apart, room, closed=True)
        by_sample = np.where(near, np.minimum(by_sample, 1), by_sample)
    angular = degrees and any(tree is claim.left or tree is claim.right for tree in noted)
    fine, coarse = _half_units(claim, world, decimals, angular)
    room = np.broadcast_to(tolerance, apart.shape)
    tolerance = np.zeros_like(apart)
    for grade, half_units in ((1, fine), (2, coarse)):
        for column, (value, half) in half_units.items():
            put = ({column: value - half}, {column: value + half})
            tolerance = tolerance + _moved(claim, world, meanings, scope, degrees, apart, put)
        if half_units:
            close = _holding(claim.sign, apart, tolerance * _SLACK + room, closed=True)
            by_sample = np.where(close, np.minimum(by_sample, grade), by_sample)
    return by_sample


@lru_cache(maxsize=64)
def looseness(world: World) -> float:
    """How far a rounded angle of the statement, 36.87°, moves its sine: half its last place.

    Zero where all angles are whole numbers of degrees, or 22.5.
    """
    rounded = (
        Fraction(1, 2 * 10 ** len(digits))
        for tree in trees(world.problem)
        for node in walk(tree)
        if isinstance(node, Degrees)
        for digits in [f"{float(node.value):g}".partition(".")[2]]
        if digits not in ("", "5")
    )
    return math.radians(max(rounded, default=Fraction(0)))


def _moved(
    claim: Claim,
    world: World,
    meanings: Meanings,
    scope: Scope,
    degrees: bool,
    apart: Array,
    put: Sequence[Mapping[int, Array]],
) -> Array:
    """By how much the difference of the sides changes where a decimal is put at either end."""
    ends = [
        difference(claim, world, meanings, scope, degrees=degrees, put=change)[0] for change in put
    ]
    with np.errstate(all="ignore"):
        changes = [end - apart for end in ends]
        if is_angular(claim, world, meanings, scope):
            changes = [_within_a_turn(change) for change in changes]
        moved = np.maximum(*map(np.abs, changes))
    return np.where(np.isfinite(moved), moved, 0.0)


def _holding(sign: Sign, apart: Array, tolerance: Array, *, closed: bool = False) -> Array:
    """In which samples the sides stand so, within a tolerance."""
    if sign == "=":
        return np.all(np.abs(apart) <= tolerance, axis=1)
    if sign == "!=":
        return np.any(np.abs(apart) > tolerance, axis=1)
    if apart.shape[1] != 1:
        return np.zeros(len(apart), dtype=bool)
    below = apart if sign in ("<", "<=") else -apart
    if sign in ("<=", ">=") or closed:
        return np.all(below <= tolerance, axis=1)
    return np.all(below < -tolerance, axis=1)


# --- decimals -------------------------------------------------------------------------------------

_HALF = Fraction(1, 2)
_Half = Mapping[int, tuple[float, float]]


def _half_units(
    claim: Claim, world: World, decimals: Sequence[Decimal], angular: bool
) -> tuple[_Half, _Half]:
    """The decimals of a claim that are not exact, by column: with 3 figures or more, and fewer.

    Whole degrees that are not those of the statement are rounded ones.
    """
    whole = list(_whole_degrees(claim, angular))
    if not decimals and not whole:
        return {}, {}
    given = world.plot.known.get("numbers")
    if given is None:
        given = world.plot.known["numbers"] = numbers_of(world.problem)
    terms = {column_of(term) for side in (claim.left, claim.right) for term in _terms_in(side)}
    noughts = {decimal.column for decimal in decimals if _has_nought(decimal)} & terms
    numbers = {
        column: node.value
        for node in _numbers((claim.left, claim.right))
        if (column := column_of(node)) is not None
        and (column in noughts or not _is_half(node, claim, given))
    }
    results = {column_of(side) for side in (claim.left, claim.right)}
    fine: dict[int, tuple[float, float]] = {}
    coarse: dict[int, tuple[float, float]] = {}
    for decimal in decimals:
        number = numbers.get(decimal.column)
        if number is None:
            continue
        # A result to three figures, √(0.114² + 2²) = 2.00, may be a datum by chance, and so may
        # one with a nought behind its point, also where it goes on as a term: 2 × 5.4 − 1.0.
        worth = (decimal.figures >= _FINE or _has_nought(decimal)) and decimal.column in results
        if worth or decimal.column in noughts or decimal.value not in given:
            chosen = fine if decimal.figures >= _FINE else coarse
            chosen[decimal.column] = float(number), float(decimal.half_unit_of(number))
    for node in whole:
        column = column_of(node)
        if column is None or column in {**fine, **coarse}:
            continue
        if node.value not in given and node.value not in _WHOLE:
            fine[column] = float(node.value), 0.5
    return fine, coarse


def _numbers(sides: Iterable[Expression]) -> Iterator[Number | Degrees]:
    return (node for tree in sides for node in walk(tree) if isinstance(node, Number | Degrees))


def _has_nought(decimal: Decimal) -> bool:
    """Whether a decimal is a whole number with a nought behind its point: 2.0."""
    return decimal.value.denominator == 1 and decimal.half_unit < _HALF


def _terms_in(side: Expression) -> Iterator[Expression]:
    """The terms of a side and of the sums inside it, and what is squared there."""
    for node in walk(side):
        if is_binary(node, "+", "-"):
            yield from (unsigned(node.left), unsigned(node.right))
        elif is_binary(node, "^"):
            yield node.left


def _is_half(node: Number | Degrees, claim: Claim, given: Collection[Fraction]) -> bool:
    """Whether a number inside a side is one half, or half a datum: ``0.2 × 29`` for ½ × 0.4."""
    if node in (claim.left, claim.right):
        return False
    return node.value == _HALF or 2 * node.value in given


def _whole_degrees(claim: Claim, angular: bool) -> Iterator[Number | Degrees]:
    """The angles typed to the nearest degree: with a degree sign, or as terms of a side."""
    for side in (claim.left, claim.right):
        terms = tuple(unsigned_terms(side)) if angular and is_bare(side) else ()
        for node in _numbers((side,)):
            if node.value.denominator == 1 and (isinstance(node, Degrees) or node in terms):
                yield node


@lru_cache(maxsize=64)
def _numbers_of(problem: Problem) -> Collection[Fraction]:
    rounded = {
        tree
        for _, step in problem.steps()
        if isinstance(step, Show) and isinstance(step.relation, Compare) and step.relation.figures
        for tree in step.relation.operands
    }
    exact = [tree for tree in trees(problem) if tree not in rounded]
    typed = {node.value for node in _numbers(exact)}
    quotients = {
        node.left.value / node.right.value
        for tree in exact
        for node in walk(tree)
        if is_binary(node, "/")
        and isinstance(node.left, Number)
        and isinstance(node.right, Number)
        and node.right.value
    }
    return frozenset(typed | quotients)


def numbers_of(problem: Problem) -> Collection[Fraction]:
    """The numbers that stand in a statement: what a student copies from it is exact.

    Those of a result that is to be shown to some figures are left out.
    """
    try:
        return _numbers_of(problem)
    except TypeError:  # what Python put in has no hash to be remembered by
        return _numbers_of.__wrapped__(problem)


# --- sides ----------------------------------------------------------------------------------------


def _are_small(bare: Sequence[Expression]) -> bool:
    """Whether no bare number is more than a turn in radians."""
    return all(node.value < _TURN for node in _numbers(bare))


def _radians(
    tree: Expression, value: Value, degrees: bool, noted: list[Expression] | None
) -> Array:
    if isinstance(value, Angle):
        return value.measure()
    if noted is not None and is_bare(tree):
        noted.append(tree)
    return np.radians(value) if degrees and is_bare(tree) else value


def _within_a_turn(radians: Array) -> Array:
    """An angle from -180° to 180°."""
    return np.mod(radians + np.pi, 2 * np.pi) - np.pi


def _sized(tree: Expression, value: Value, other: Value) -> Value:
    """A velocity, or where a sphere's name is compared with a number, its speed."""
    if isinstance(tree, Name) and isinstance(value, Vector) and not isinstance(other, Vector):
        return np.hypot(value.x, value.y)
    return value


def _is_line(tree: Expression, world: World, meanings: Meanings) -> bool:
    """Whether a side is the direction of a line, of which a vector of any length tells."""
    if isinstance(tree, Letter):
        tree = meanings.get(tree.name, tree)
    if isinstance(tree, Negate):
        return _is_line(tree.operand, world, {})
    return isinstance(tree, Quantity) and (
        tree.kind == "line_of_centres"
        or (
            tree.kind == "direction"
            and isinstance(tree.arguments[0], Name)
            and tree.arguments[0].name in world.plot.walls
        )
    )


def _directed(left: Value, right: Value) -> tuple[Value, Value]:
    """Two directions of lines as unit vectors of one sense."""
    if not (isinstance(left, Vector) and isinstance(right, Vector)):
        return left, right
    one, other = (v / np.hypot(v.x, v.y) for v in (left, right))
    return one, other * np.where(one.dot(other) < 0, -1.0, 1.0)


def as_vector(value: Value) -> Vector:
    """A value as a vector: 0 is one. Raises UnvaluedError for any other number."""
    if isinstance(value, Vector):
        return value
    if isinstance(value, Angle) or np.any(np.asarray(value) != 0):
        raise UnvaluedError("a vector and a number are compared")
    return Vector(np.float64(0), np.float64(0))


def _columns(world: World, *values: Array) -> Array:
    return np.stack([world.spread(value) for value in values], axis=1)


def _magnitude(world: World) -> float:
    """The largest of the speeds of a world, and 1 if they are small."""
    known = world._known.get("magnitude")
    if known is None:
        vectors = (*world.start.values(), *world.after.values())
        sizes = [float(np.max(np.abs(component))) for v in vectors for component in v]
        known = world._known["magnitude"] = max(1.0, *(x for x in sizes if np.isfinite(x)), 1.0)
    return float(known)
