"""Which lines a goal needs: the cheapest equations whose gradients hold the goal's in their span.

At the numbers of a solution every equation has a gradient in the unknowns. A set of equations
determines a goal if the goal's gradient is a combination of theirs. It has to be so at two points
of the solution, since a number may vanish at one of them by chance.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from itertools import combinations

import sympy as sp

from restitution.components.models import Model
from restitution.exact.degrees import function_of
from restitution.exact.symbols import symbols_in
from restitution.expression.enclosed import UndefinedError
from restitution.planning.writing.candidates import Candidate
from restitution.records import dataclass
from restitution.solving.algebra.numbers import float_at, number_of

# Numbers in a reduced gradient below this share of its largest are rounding.
_ROUNDING = 1e-9
# Of more equations than this, sets are not compared one by one.
_MOST = 12

Point = Mapping[sp.Symbol, float]
_Dual = tuple[float, dict[sp.Symbol, float]]


def points(model: Model) -> tuple[Point, ...]:
    """Two points of a solution: its sample, and another for the letters that are free."""
    symbols = set(model.final) | {
        model.unknowns.letter(name) for name in model.unknowns.roles if name in model.sample
    }
    # A mass that nothing tells is any number.
    symbols |= {role.symbol(name) for name, role in model.unknowns.hidden_roles.items()}
    sample = {
        symbol: float(model.sample[symbol.name])
        for symbol in symbols
        if symbol.name in model.sample
    }
    there = dict(model.sample)
    for n, name in enumerate(sorted(model.unknowns.roles)):
        symbol = model.unknowns.letter(name)
        if symbol not in model.final and name in there:
            factor = sp.Rational(97 + 2 * n, 100 + 2 * n)
            there[name] = number_of(model.sample[name]) * number_of(factor)
    other: dict[sp.Symbol, float] = {}
    for symbol in symbols:
        try:
            other[symbol] = float_at(model.in_data(symbol), there)
        except (UndefinedError, KeyError, ArithmeticError):
            return (sample,)
    return sample, other


def gradient(x: sp.Expr, point: Point) -> Mapping[sp.Symbol, float]:
    """The partial derivatives of an expression at a point.

    Raises ArithmeticError, KeyError or ValueError where it has none there.
    """
    return _gradient(x, tuple([(symbol, point[symbol]) for symbol in symbols_in(x)]))


@lru_cache(maxsize=2048)
def _gradient(x: sp.Expr, values: tuple[tuple[sp.Symbol, float], ...]) -> dict[sp.Symbol, float]:
    """The same for the numbers of its own letters: nobody may change what it gives."""
    return _dual(x, dict(values))[1]


def _dual(x: sp.Expr, point: Point) -> _Dual:
    if x.is_Symbol:
        return point[x], {x: 1.0}
    if x.is_Rational:
        return x.p / x.q, {}
    if not symbols_in(x):
        return float(x), {}
    parts = [_dual(argument, point) for argument in x.args]
    if x.is_Add:
        return sum(part[0] for part in parts), _weighted((1.0, part[1]) for part in parts)
    if x.is_Mul:
        values = [part[0] for part in parts]
        terms = []
        for n, (_, slopes) in enumerate(parts):
            others = math.prod(values[:n] + values[n + 1 :])
            terms.append((others, slopes))
        return math.prod(values), _weighted(terms)
    if x.is_Pow and not parts[1][1]:
        base, slopes = parts[0]
        exponent = parts[1][0]
        return base**exponent, _weighted([(exponent * base ** (exponent - 1), slopes)])
    own = _FUNCTIONS.get(function_of(x))
    if own is None or len(parts) != 1:
        raise ValueError(x)
    value, slopes = parts[0]
    function, derivative = own
    return function(value), _weighted([(derivative(value), slopes)])


_FUNCTIONS: Mapping[type, tuple[Callable[[float], float], Callable[[float], float]]] = {
    sp.sin: (math.sin, math.cos),
    sp.cos: (math.cos, lambda x: -math.sin(x)),
    sp.tan: (math.tan, lambda x: 1 + math.tan(x) ** 2),
    sp.atan: (math.atan, lambda x: 1 / (1 + x * x)),
    sp.asin: (math.asin, lambda x: 1 / math.sqrt(1 - x * x)),
    sp.acos: (math.acos, lambda x: -1 / math.sqrt(1 - x * x)),
    sp.Abs: (abs, lambda x: math.copysign(1, x)),
}


def _weighted(terms: object) -> dict[sp.Symbol, float]:
    total: dict[sp.Symbol, float] = {}
    for weight, slopes in terms:  # type: ignore[attr-defined]
        for symbol, slope in slopes.items():
            total[symbol] = total.get(symbol, 0.0) + weight * slope
    return total


# --- sets of equations -------------------------------------------------------------------------


@dataclass
class Routes:
    """The equations of a solution, with their gradients at its points."""

    candidates: Sequence[Candidate]
    points: Sequence[Point]
    unknowns: frozenset[sp.Symbol]

    def __post_init__(self) -> None:
        self.symbols = sorted(self.unknowns, key=lambda value: value.name)
        self.rows = [
            [[self.row(residual, point) for residual in own.residuals] for point in self.points]
            for own in self.candidates
        ]

    def row(self, x: sp.Expr, point: Point) -> list[float]:
        """The gradient of an expression in the unknowns, as a row.

        Each unknown is measured by its own size, so that units do not matter.
        """
        try:
            slopes = gradient(x, point)
        except (ArithmeticError, KeyError, ValueError, TypeError):
            return [math.nan] * len(self.symbols)
        return [
            slopes.get(symbol, 0.0) * (abs(point.get(symbol, 0.0)) or 1.0)
            for symbol in self.symbols
        ]

    def cheapest(self, goals: Sequence[sp.Expr], most: int = 3) -> list[tuple[Candidate, ...]]:
        """The cheapest sets that determine all goals, the cheapest first; none if none does."""
        wanted = self._wanted(goals)
        near = self._ancestors(wanted)
        if not self._spans(near, wanted):
            self._beside_the_solution()
            wanted = self._wanted(goals)
            near = self._ancestors(wanted)
            if not self._spans(near, wanted):
                return []
        bound = self._pruned(near, wanted)
        if len(near) > _MOST:
            return [tuple(self.candidates[n] for n in bound)]
        dearest = self._cost(bound) + 2
        costs = [candidate.cost for candidate in self.candidates]
        minimal: list[tuple[float, tuple[int, ...]]] = []
        taken: list[frozenset[int]] = []
        for size in range(len(near) + 1):
            for chosen in combinations(near, size):
                cost = sum(map(costs.__getitem__, chosen))
                # What has more than a set that determines the goals is not the least.
                if cost > dearest or any(map(frozenset(chosen).issuperset, taken)):
                    continue
                if self._spans(chosen, wanted):
                    minimal.append((cost, chosen))
                    taken.append(frozenset(chosen))
        minimal.sort(key=lambda basis: (basis[0], len(basis[1]), basis[1]))
        return [tuple(self.candidates[n] for n in chosen) for _, chosen in minimal[:most]]

    def _wanted(self, goals: Sequence[sp.Expr]) -> list[list[list[float]]]:
        """The gradients of goals, point by point."""
        return [[self.row(goal, point) for goal in goals] for point in self.points]

    def _beside_the_solution(self) -> None:
        """Takes gradients beside the solution: at a double root those at it tell nothing."""
        self.points = [
            {
                symbol: value * (1 + 0.07 * (1 + self.symbols.index(symbol)))
                if symbol in self.unknowns
                else value
                for symbol, value in point.items()
            }
            for point in self.points
        ]
        self.__post_init__()

    def _cost(self, chosen: Sequence[int]) -> float:
        return sum(self.candidates[n].cost for n in chosen)

    def _ancestors(self, wanted: Sequence[Sequence[Sequence[float]]]) -> tuple[int, ...]:
        """The equations that share an unknown with the goals, or with another ancestor."""
        reached = {k for rows in wanted for row in rows for k, x in enumerate(row) if x}
        chosen: set[int] = set()
        while True:
            new = {
                n
                for n in range(len(self.candidates))
                if n not in chosen
                and any(row[k] for rows in self.rows[n] for row in rows for k in reached)
            }
            if not new:
                return tuple(sorted(chosen))
            chosen |= new
            reached |= {
                k
                for n in new
                for rows in self.rows[n]
                for row in rows
                for k, x in enumerate(row)
                if x
            }

    def _pruned(
        self, near: Sequence[int], wanted: Sequence[Sequence[Sequence[float]]]
    ) -> tuple[int, ...]:
        """A set from which nothing can be left out, the dear ones having gone first."""
        kept = list(near)
        for n in sorted(near, key=lambda number: -self.candidates[number].cost):
            without = [number for number in kept if number != n]
            if self._spans(without, wanted):
                kept = without
        return tuple(kept)

    def _spans(self, chosen: Sequence[int], wanted: Sequence[Sequence[Sequence[float]]]) -> bool:
        for n in range(len(self.points)):
            basis = _reduced([row for k in chosen for row in self.rows[k][n]])
            if not all(_within(row, basis) for row in wanted[n]):
                return False
        return True


def _reduced(rows: Sequence[Sequence[float]]) -> list[tuple[int, list[float]]]:
    """Rows in echelon form, each with the place of its leading 1."""
    basis: list[tuple[int, list[float]]] = []
    for row in rows:
        rest = _without(row, basis)
        size = max(map(abs, row), default=0.0)
        sizes = list(map(abs, rest))
        most = max(sizes, default=0.0)
        if not size or most <= _ROUNDING * size:
            continue
        lead = sizes.index(most)
        basis.append((lead, [x / rest[lead] for x in rest]))
    return basis


def _without(row: Sequence[float], basis: Sequence[tuple[int, list[float]]]) -> list[float]:
    rest = list(row)
    for lead, own in basis:
        factor = rest[lead]
        if factor:
            rest = [x - factor * y for x, y in zip(rest, own, strict=True)]
    return rest


def _within(row: Sequence[float], basis: Sequence[tuple[int, list[float]]]) -> bool:
    size = max(map(abs, row), default=0.0)
    # A row that has no number is in no span.
    return not size or all(abs(x) <= 1e-7 * size for x in _without(row, basis))
