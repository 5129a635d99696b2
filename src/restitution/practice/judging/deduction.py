"""Whether a line follows from a few earlier ones by algebra alone.

Letters are any complex numbers here, so that a working which has no real end (``sin²α = 1.37``) is
followed too. Random values are moved to where the earlier lines hold; a line that then holds at all
of them follows from these.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import chain, combinations
from typing import Any

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pair,
    Pi,
    Quantity,
    Unit,
    children,
    is_binary,
    walk,
)
from restitution.practice.judging.entries import Entry
from restitution.practice.script import Claim
from restitution.practice.worlds.arrays import is_bare
from restitution.practice.worlds.world import World
from restitution.vector import Vector

Array = Any

_POINTS = 8
_STEPS = 20
_CLOSE = 1e-7
# What rounding to three figures may move.
_ROUNDED = 3e-3
_FIGURES = 3
_LATEST = 6
_TRIES = 24
_FUNCTIONS: Mapping[str, Callable[[Array], Array]] = {
    "sqrt": np.sqrt,
    "sin": np.sin,
    "cos": np.cos,
    "tan": np.tan,
    "cot": lambda x: 1 / np.tan(x),
    "sec": lambda x: 1 / np.cos(x),
    "cosec": lambda x: 1 / np.sin(x),
    "arcsin": np.arcsin,
    "arccos": np.arccos,
    "arctan": np.arctan,
}
_TURNING = frozenset({"sin", "cos", "tan", "cot", "sec", "cosec"})


class _UnfitError(Exception):
    """A claim of which this algebra knows nothing."""


def deduced_from(
    entry: Entry, entries: Sequence[Entry], world: World, data: frozenset[str] = frozenset()
) -> tuple[int, ...]:
    """The places of the few earlier lines from which a line follows; () if there are none.

    They are one or two, or two and the last that is not true.

    ``data`` are letters of the statement that keep their values in ``world``.
    """
    if entry.claim.sign != "=" or entry.claim.others:
        return ()
    wrong = frozenset(
        k
        for k, entry in enumerate(entries)
        if not entry.right and _is_arithmetic(entry, world, data)
    )
    bare = _is_arithmetic(entry, world, data)
    usable = [k for k, entry in enumerate(entries) if _is_equation(entry.claim) and k not in wrong]
    usable = usable[-_LATEST:]
    own = _symbols(entry)
    near = [k for k in reversed(usable) if not own.isdisjoint(_symbols(entries[k]))]
    others = [(a, b) for a, b in combinations(list(reversed(usable)), 2) if a in near or b in near]
    untrue = [k for k in usable if not entries[k].right][-1:]
    pairs = list(combinations(list(reversed(usable)), 2))
    threes = [(*pair, k) for k in untrue for pair in pairs if k not in pair]
    tried = 0
    for places in chain(((k,) for k in near), others, threes):
        earlier = [entries[k] for k in places]
        if not own <= frozenset().union(*(_symbols(entry) for entry in earlier)) | data:
            continue
        tried += 1
        if tried > _TRIES:
            break
        if _follows(entry, earlier, world, data, bare=bare):
            return tuple(sorted(places))
    return ()


def is_identity(entry: Entry, world: World) -> bool:
    """Whether a sum is worked out that holds whatever the letters of the statement are in it."""
    sums = any(
        is_binary(node, "+", "-")
        for side in (entry.claim.left, entry.claim.right)
        for node in walk(side)
    )
    if not sums or not _is_equation(entry.claim) or not _symbols(entry):
        return False
    if not _is_arithmetic(entry, world, frozenset()):
        return False
    try:
        plane = _Plane((entry,), world, frozenset())
        apart, size = plane.sides(entry, plane.x)
    except (_UnfitError, RestitutionError, ArithmeticError):
        return False
    return bool(np.all(np.isfinite(apart)) and np.all(np.abs(apart) <= _CLOSE * (size + 1e-3)))


def _is_equation(claim: Claim) -> bool:
    return claim.sign == "=" and not claim.others


def _is_arithmetic(entry: Entry, world: World, data: frozenset[str]) -> bool:
    """Whether a claim speaks of free letters alone: untrue, it makes them zero, and all follows."""
    fixed = data | frozenset(world.determined)
    return all(
        isinstance(symbol, Letter) and symbol.name in world.letters and symbol.name not in fixed
        for symbol in _symbols(entry)
    )


def _symbols(entry: Entry) -> frozenset[Expression]:
    """The letters and quantities of a claim; letters count by what they mean."""
    return frozenset(_parts(entry))


def _parts(entry: Entry) -> Iterator[Expression]:
    for side in (entry.claim.left, entry.claim.right):
        yield from _within(side, entry, ())


def _within(tree: Expression, entry: Entry, opened: tuple[str, ...]) -> Iterator[Expression]:
    """The symbols of a tree; a letter that means a sum or a product counts by what is in it."""
    pending = [tree]
    while pending:
        node = pending.pop()
        if isinstance(node, Letter):
            meant = entry.meanings.get(node.name, node)
            if node.name in opened or isinstance(meant, Quantity) or meant == node:
                yield node if node.name in opened else meant
            else:
                yield from _within(meant, entry, (*opened, node.name))
        elif isinstance(node, Quantity):
            yield node
        else:
            pending.extend(children(node))


def _follows(
    entry: Entry,
    earlier: Sequence[Entry],
    world: World,
    data: frozenset[str],
    *,
    bare: bool = False,
) -> bool:
    """Whether a line follows; letters of the statement that it has not may keep any values.

    Moved, they might make what stands between the lines zero: ``u cos α (1 - ke) = 0``. A claim
    of free letters alone, which is ``bare``, has to follow while all others keep their values.
    """
    inside = {symbol.name for symbol in _symbols(entry) if isinstance(symbol, Letter)}
    kept = frozenset(world.letters.keys() - world.determined - inside - data)
    free = frozenset[str]()
    for still in (kept,) if bare else (kept, free) if kept else (free,):
        try:
            plane = _Plane((entry, *earlier), world, data, still)
            if plane.holds(entry, earlier):
                return True
        except (_UnfitError, RestitutionError, ArithmeticError, np.linalg.LinAlgError):
            continue
    return False


class _Plane:
    """The symbols of some claims as complex unknowns, near their true values."""

    def __init__(
        self,
        entries: Sequence[Entry],
        world: World,
        data: frozenset[str],
        kept: frozenset[str] = frozenset(),
    ) -> None:
        symbols = sorted(set().union(*(_symbols(entry) for entry in entries)), key=repr)
        rng = np.random.default_rng(11)
        self.columns: dict[Expression, tuple[int, ...]] = {}
        self.fixed: dict[Expression, Any] = {}
        self.positive: list[int] = []  # the places of letters of the statement, which are not zero
        starts: list[Array] = []
        for symbol in symbols:
            value = _value(symbol, entries, world)
            parts = value if isinstance(value, tuple) else (value,)
            if isinstance(symbol, Letter) and symbol.name in data:
                self.fixed[symbol] = value
                continue
            scattered = []
            for part in parts:
                wide = max(abs(part), 0.5)
                moved = rng.uniform(-0.3, 0.3, _POINTS) + 1j * rng.uniform(0.2, 0.9, _POINTS)
                scattered.append(part + wide * moved)
            if isinstance(symbol, Letter) and symbol.name in kept:
                self.fixed[symbol] = scattered[0]
                continue
            self.columns[symbol] = tuple(range(len(starts), len(starts) + len(parts)))
            if isinstance(symbol, Letter) and symbol.name in world.letters:
                self.positive += self.columns[symbol]
            starts += scattered
        self.x = np.stack(starts) if starts else np.zeros((0, _POINTS), dtype=complex)

    def holds(self, entry: Entry, earlier: Sequence[Entry]) -> bool:
        """Whether a claim holds wherever the earlier ones do."""
        x = self._moved(earlier)
        apart, size = self.sides(entry, x)
        there = self._met(earlier, x)
        if np.count_nonzero(there) < 2:
            return False
        apart, size = apart[:, there], size[:, there]
        rounded = any(given.decimals for given in (entry, *earlier))
        close = (_rounding_of(entry) if rounded else _CLOSE) * (size + 1e-3)
        return bool(np.all(np.isfinite(apart)) and np.all(np.abs(apart) <= close))

    def _met(self, earlier: Sequence[Entry], x: Array) -> Array:
        """At which points some claims hold, and no letter of the statement is zero."""
        there = np.all(np.abs(x[self.positive]) > _CLOSE, axis=0)
        for entry in earlier:
            apart, size = self.sides(entry, x)
            there &= np.all(np.abs(apart) <= 1e-10 * (size + 1e-3), axis=0)
        return there

    def _moved(self, earlier: Sequence[Entry]) -> Array:
        """The points moved to where some claims hold; those that come to no end are left behind."""
        x = self.x
        for _ in range(_STEPS):
            r = self._residuals(earlier, x)
            if np.max(np.abs(r), initial=0) < 1e-12 or not len(x):
                break  # claims of data alone hold or do not: nothing can be moved
            step = 1e-7
            slopes = np.stack(
                [
                    (self._residuals(earlier, x + step * np.eye(len(x))[k][:, None]) - r) / step
                    for k in range(len(x))
                ],
                axis=1,
            )
            slopes, r = (np.where(np.isfinite(array), array, 0) for array in (slopes, r))
            move = np.einsum("pij,pj->ip", np.linalg.pinv(slopes.transpose(2, 0, 1)), r.T)
            x = x - move
        return x

    def _residuals(self, entries: Sequence[Entry], x: Array) -> Array:
        return np.concatenate([self.sides(entry, x)[0] for entry in entries])

    def sides(self, entry: Entry, x: Array) -> tuple[Array, Array]:
        """Left less right, and the size of the sides, shape (1 or 2, points)."""
        with np.errstate(all="ignore"):
            left, right = (self._tree(t, entry, x) for t in (entry.claim.left, entry.claim.right))
        a, b = (side if isinstance(side, tuple) else (side,) for side in (left, right))
        if len(a) != len(b):
            raise _UnfitError
        one, other = (np.stack([np.broadcast_to(p, (_POINTS,)) for p in parts]) for parts in (a, b))
        return one - other, np.maximum(np.abs(one), np.abs(other))

    def _tree(self, tree: Expression, entry: Entry, x: Array, opened: tuple[str, ...] = ()) -> Any:
        match tree:
            case Number(value):
                return complex(value)
            case Degrees(value):
                return complex(np.radians(float(value)))
            case Pi():
                return complex(np.pi)
            case Letter(name):
                meant = tree if name in opened else entry.meanings.get(name, tree)
                if isinstance(meant, Quantity) or meant == tree:
                    return self._symbol(meant, x)
                return self._tree(meant, entry, x, (*opened, name))
            case Quantity():
                return self._symbol(tree, x)
            case Unit(axis):
                return (1 + 0j, 0j) if axis == "i" else (0j, 1 + 0j)
            case Pair(a, b):
                return self._tree(a, entry, x, opened), self._tree(b, entry, x, opened)
            case Negate(operand):
                return _scaled(-1, self._tree(operand, entry, x, opened))
            case Binary(op, left, right):
                return _combined(
                    op, self._tree(left, entry, x, opened), self._tree(right, entry, x, opened)
                )
            case Apply(function, argument) if function in _FUNCTIONS:
                inside = self._tree(argument, entry, x, opened)
                if isinstance(inside, tuple):
                    raise _UnfitError
                if function in _TURNING and is_bare(argument):
                    inside = np.radians(inside.real)
                return _FUNCTIONS[function](np.asarray(inside, dtype=complex))
        raise _UnfitError

    def _symbol(self, symbol: Expression, x: Array) -> Any:
        if symbol in self.fixed:
            return self.fixed[symbol]
        if symbol not in self.columns:
            raise _UnfitError
        columns = self.columns[symbol]
        return tuple(x[k] for k in columns) if len(columns) == 2 else x[columns[0]]


def _rounding_of(entry: Entry) -> float:
    """What its rounding may move a line by: of 1.06 half of its last place is more than usual."""
    own = (
        float(decimal.half_unit / abs(decimal.value))
        for decimal in entry.decimals
        if decimal.figures >= _FIGURES and decimal.value
    )
    return max((_ROUNDED, *own))


def _value(symbol: Expression, entries: Sequence[Entry], world: World) -> Any:
    """The true value of a symbol in the first sample: a number, or a pair of them."""
    value: Any = None
    for entry in entries:
        try:
            value = world.value(symbol, entry.meanings, entry.scope)
            break
        except RestitutionError:
            continue
    if isinstance(value, Vector):
        return tuple(complex(np.ravel(part)[0]) for part in value)
    if isinstance(value, Angle):
        value = value.measure()
    number = complex(np.ravel(value)[0]) if value is not None else 1 + 0j
    return number if np.isfinite(number) else 1 + 0j


def _scaled(factor: Any, value: Any) -> Any:
    return tuple(factor * part for part in value) if isinstance(value, tuple) else factor * value


def _combined(op: str, left: Any, right: Any) -> Any:
    vectors = isinstance(left, tuple), isinstance(right, tuple)
    if op in "+-":
        if vectors[0] != vectors[1]:
            raise _UnfitError
        sign = 1 if op == "+" else -1
        if vectors[0]:
            return tuple(a + sign * b for a, b in zip(left, right, strict=True))
        return left + sign * right
    if op == "*" and not all(vectors):
        return _scaled(left, right) if vectors[1] else _scaled(right, left)
    if vectors[1] or (op != "/" and any(vectors)):
        raise _UnfitError
    if op == "/":
        return _scaled(1 / np.asarray(right, dtype=complex), left)
    return np.asarray(left, dtype=complex) ** right
