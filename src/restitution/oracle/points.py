"""The sign of an expression at one point, with a bound on every rounding error.

Expressions are compiled once into a list of instructions that shares what they have in common.
At a point, where every letter has an exact value, the list is worked through in floats that carry
a bound of their error; where that leaves a sign open in fractions, if there are no roots or angles
in it; then in intervals of many digits. A sign that is given is certain.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from typing import Any

import mpmath
import sympy as sp
from mpmath.libmp import to_rational

Value = Fraction | float | Any  # Any: a SymPy number
Point = Mapping[str, Value]

# Twice the unit roundoff: what one operation adds, itself rounded.
_EPSILON = 2.0**-51
_TINY = 1e-300
DIGITS = (60, 240)
_NOTHING_SEEN = Fraction(1, 10**95)
_SEARCHED = 300  # digits: even the root of what ought to vanish is seen to vanish


class BeyondError(Exception):
    """A value cannot be had in this arithmetic: it is undefined, or too wide to tell."""


@dataclass(frozen=True)
class Program:
    """Instructions for some expressions: ``results`` says where the value of each stands.

    An instruction is (operation, arguments): places of earlier values, or constants.
    """

    instructions: tuple[tuple[str, tuple[Any, ...]], ...]
    results: tuple[int, ...]
    rational: bool
    letters: frozenset[str]

    @classmethod
    def of(cls, expressions: Sequence[sp.Expr]) -> Program:
        """Compiles expressions. Raises BeyondError for a function that is not known here."""
        compiler = _Compiler()
        results = tuple(compiler.place(sp.sympify(each, strict=True)) for each in expressions)
        rational = all(operation in _RATIONAL for operation, _ in compiler.instructions)
        letters = frozenset(a[0] for operation, a in compiler.instructions if operation == "letter")
        return cls(tuple(compiler.instructions), results, rational, letters)

    def signs(self, point: Point) -> list[int | None]:
        """The sign of every expression at a point; None where it is undefined or not certain.

        Raises KeyError for a letter without a value.
        """
        signs: list[int | None] = [None] * len(self.results)
        try:
            balls = self._balls(point)
        except (BeyondError, OverflowError, ValueError):
            balls = None
        if balls is not None:
            for n, place in enumerate(self.results):
                middle, error = balls[place]
                if abs(middle) > error:
                    signs[n] = 1 if middle > 0 else -1
                elif error == 0:
                    signs[n] = 0
            if None not in signs:
                return signs
        if self.rational and all(
            isinstance(point[name], int | float | Fraction) for name in self.letters
        ):
            try:
                numbers = self._fractions(point)
            except (BeyondError, ZeroDivisionError, OverflowError):
                return signs
            return [(x > 0) - (x < 0) for x in (numbers[place] for place in self.results)]
        for digits in DIGITS:
            try:
                intervals = self.enclosures(point, digits)
            except BeyondError:
                continue
            for n, interval in enumerate(intervals):
                if signs[n] is None and interval is not None:
                    signs[n] = 1 if interval.a > 0 else -1 if interval.b < 0 else None
            if None not in signs:
                break
        return signs

    def near_signs(self, point: Point) -> list[int | None]:
        """The signs, with 0 for what is within 10⁻⁹⁵ of zero, such as a root in figures.

        None is for what has no real value. This is for a search; it decides nothing.
        """
        try:
            balls = self._balls(point)
            middles = [balls[place] for place in self.results]
            if all(abs(middle) > error and abs(middle) > 1e-12 for middle, error in middles):
                return [1 if middle > 0 else -1 for middle, _ in middles]
        except (BeyondError, OverflowError, ValueError):
            pass
        signs: list[int | None] = []
        for interval in self.enclosures(point, _SEARCHED):
            if interval is None:
                signs.append(None)
                continue
            low, high = ends_of(interval)
            signs.append(1 if low > _NOTHING_SEEN else -1 if high < -_NOTHING_SEEN else 0)
        return signs

    def _balls(self, point: Point) -> list[tuple[float, float]]:
        values: list[tuple[float, float]] = []
        for operation, arguments in self.instructions:
            if operation == "number":
                fraction = arguments[0]
                middle = float(fraction)
                exact = middle == fraction
                values.append((middle, 0.0 if exact else abs(middle) * _EPSILON + _TINY))
            elif operation == "letter":
                values.append(_ball(point[arguments[0]]))
            elif operation == "add":
                middle = error = size = 0.0
                for place in arguments:
                    m, r = values[place]
                    middle += m
                    error += r
                    size += abs(m)
                rounding = 0.0 if size == 0 else size * _EPSILON * len(arguments)
                values.append((middle, 0.0 if _whole(values, arguments) else error + rounding))
            elif operation == "multiply":
                middle, error = values[arguments[0]]
                for place in arguments[1:]:
                    m, r = values[place]
                    product = middle * m
                    if error == 0 and r == 0 and _is_whole(middle) and _is_whole(m):
                        error = 0.0 if abs(product) < 2.0**53 else abs(product) * _EPSILON
                    elif (error == 0 and middle == 0) or (r == 0 and m == 0):
                        product = error = 0.0
                    else:
                        error = (
                            (abs(middle) * r + abs(m) * error + error * r) * (1 + _EPSILON)
                            + abs(product) * _EPSILON
                            + _TINY
                        )
                    middle = product
                values.append((middle, error))
            elif operation == "power":
                values.append(_ball_power(values[arguments[0]], arguments[1]))
            elif operation == "root":
                values.append(_ball_root(values[arguments[0]], arguments[1], arguments[2]))
            elif operation == "constant":
                values.append(_ball(arguments[0]))
            else:
                values.append(_ball_function(operation, [values[each] for each in arguments]))
            middle, error = values[-1]
            if not (math.isfinite(middle) and math.isfinite(error)):
                raise BeyondError
        return values

    def _fractions(self, point: Point) -> list[Fraction]:
        values: list[Fraction] = []
        for operation, arguments in self.instructions:
            if operation == "number":
                values.append(arguments[0])
            elif operation == "letter":
                values.append(Fraction(point[arguments[0]]))
            elif operation == "add":
                values.append(sum((values[each] for each in arguments), Fraction(0)))
            elif operation == "multiply":
                values.append(math.prod((values[each] for each in arguments), start=Fraction(1)))
            else:
                values.append(values[arguments[0]] ** arguments[1])
        return values

    def enclosures(self, point: Point, digits: int) -> list[Any]:
        """Intervals of so many digits that hold the values; None where there is no value."""
        context = _context(digits)
        values: list[Any] = []
        for operation, arguments in self.instructions:
            try:
                values.append(_enclosed(context, operation, arguments, values, point))
            except (BeyondError, ZeroDivisionError, ValueError, OverflowError, TypeError):
                values.append(None)
        return [values[place] for place in self.results]


_NOTHING = frozenset({sp.nan, sp.zoo, sp.oo, -sp.oo, sp.I})
_RATIONAL = frozenset({"number", "letter", "add", "multiply", "power"})
_FUNCTIONS: dict[type, str] = {
    sp.sin: "sin",
    sp.cos: "cos",
    sp.tan: "tan",
    sp.cot: "cot",
    sp.sec: "sec",
    sp.csc: "csc",
    sp.atan: "atan",
    sp.acot: "acot",
    sp.acos: "acos",
    sp.asin: "asin",
    sp.atan2: "atan2",
    sp.Abs: "abs",
    sp.sign: "sign",
    sp.Max: "max",
    sp.Min: "min",
}


class _Compiler:
    def __init__(self) -> None:
        self.instructions: list[tuple[str, tuple[Any, ...]]] = []
        self._places: dict[sp.Basic, int] = {}

    def place(self, x: sp.Expr) -> int:
        """Where the value of an expression stands among the results of the instructions."""
        if x not in self._places:
            instruction = self._instruction(x)
            self.instructions.append(instruction)
            self._places[x] = len(self.instructions) - 1
        return self._places[x]

    def _instruction(self, x: sp.Expr) -> tuple[str, tuple[Any, ...]]:
        if x.is_Symbol:
            return "letter", (x.name,)
        if x.is_Rational:
            return "number", (Fraction(int(x.p), int(x.q)),)
        if x.is_Float:
            return "number", (Fraction(str(x)),)
        if x is sp.pi:
            return "pi", ()
        if x in _NOTHING:
            return "nothing", ()
        if x.is_Add:
            return "add", tuple(self.place(each) for each in x.args)
        if x.is_Mul:
            return "multiply", tuple(self.place(each) for each in x.args)
        if x.is_Pow and x.exp.is_Integer:
            return "power", (self.place(x.base), int(x.exp))
        if x.is_Pow and x.exp.is_Rational:
            return "root", (self.place(x.base), int(x.exp.p), int(x.exp.q))
        if isinstance(x, sp.CRootOf):
            return "constant", (x,)
        name = _FUNCTIONS.get(type(x))
        if name is None:
            raise BeyondError(str(x))
        return name, tuple(self.place(each) for each in x.args)


# --- floats with a bound of their error ----------------------------------------------------------


def _is_whole(x: float) -> bool:
    return abs(x) < 2.0**26 and x == int(x)


def _whole(values: list[tuple[float, float]], places: tuple[int, ...]) -> bool:
    """Whether a sum is of whole numbers, which floats add without an error."""
    return all(values[each][1] == 0 and _is_whole(values[each][0]) for each in places)


def _ball(value: Value) -> tuple[float, float]:
    if isinstance(value, sp.Expr):
        if value.is_Rational:
            value = Fraction(int(value.p), int(value.q))
        else:
            interval = Program.of([value]).enclosures({}, 30)[0]
            if interval is None:
                raise BeyondError
            middle = float(interval.mid)
            return middle, abs(middle) * 2 * _EPSILON + _TINY
    middle = float(value)
    exact = isinstance(value, int | float | Fraction) and middle == value
    return middle, 0.0 if exact else abs(middle) * _EPSILON + _TINY


def _ball_power(ball: tuple[float, float], n: int) -> tuple[float, float]:
    middle, error = ball
    if n < 0:
        low = abs(middle) - error
        if low <= 0:
            raise BeyondError
        inverse = 1 / middle
        error = error / (low * abs(middle)) * (1 + 4 * _EPSILON) + abs(inverse) * _EPSILON + _TINY
        middle, n = inverse, -n
    value, spread = 1.0, 0.0
    for _ in range(n):
        spread = (abs(value) * error + abs(middle) * spread + spread * error) * (1 + _EPSILON)
        exact = spread == 0 and _is_whole(value) and _is_whole(middle)
        value *= middle
        if not exact or abs(value) >= 2.0**53:
            spread += abs(value) * _EPSILON + _TINY
    return value, spread


def _ball_root(ball: tuple[float, float], p: int, q: int) -> tuple[float, float]:
    middle, error = ball
    low, high = middle - error, middle + error
    if low <= 0:
        if middle == error == 0 and p > 0:
            return 0.0, 0.0
        raise BeyondError
    if q == 2 and p == 1:
        value = math.sqrt(middle)
        if error == 0 and _is_whole(value) and value * value == middle:
            return value, 0.0
    else:
        value = math.pow(middle, p / q)
    steepest = max(math.pow(low, p / q - 1), math.pow(high, p / q - 1)) * abs(p) / q
    return value, (steepest * error + 4 * value * _EPSILON) * (1 + _EPSILON)


def _ball_function(operation: str, values: list[tuple[float, float]]) -> tuple[float, float]:
    if operation == "nothing":
        raise BeyondError
    if operation == "pi":
        return math.pi, math.pi * _EPSILON
    middle, error = values[0]
    if operation in ("sin", "cos"):
        value = math.sin(middle) if operation == "sin" else math.cos(middle)
        return value, error + 2 * _EPSILON
    if operation == "abs":
        return abs(middle), error
    if operation == "atan":
        return math.atan(middle), error + 4 * _EPSILON
    raise BeyondError


def ends_of(interval: Any) -> tuple[Fraction, Fraction]:
    """The two ends of an interval, exactly."""
    low, high = (Fraction(*to_rational(each)) for each in interval._mpi_)
    return low, high


# --- intervals of many digits ---------------------------------------------------------------------

_contexts: dict[int, Any] = {}


def _context(digits: int) -> Any:
    if digits not in _contexts:
        context = mpmath.ctx_iv.MPIntervalContext()
        context.dps = digits
        _contexts[digits] = context
    return _contexts[digits]


def _enclosed(
    context: Any, operation: str, arguments: tuple[Any, ...], values: list[Any], point: Point
) -> Any:
    if operation == "number":
        return _fraction_in(context, arguments[0])
    if operation == "letter":
        value = point[arguments[0]]
        if isinstance(value, sp.Expr) and not value.is_Rational:
            constant = Program.of([value]).enclosures({}, context.dps)[0]
            if constant is None:
                raise BeyondError
            return constant
        return _fraction_in(context, Fraction(str(value)) if isinstance(value, sp.Expr) else value)
    if operation == "pi":
        return context.pi
    if operation == "constant":
        return _root_in(context, arguments[0])
    if operation == "nothing":
        raise BeyondError
    if operation == "power":
        base, n = values[arguments[0]], arguments[1]
        if base is None or (n < 0 and base.a <= 0 <= base.b):
            raise BeyondError
        return base**n
    if operation == "root":
        base, p, q = values[arguments[0]], arguments[1], arguments[2]
        if base is None or base.b < 0 or (p < 0 and base.a <= 0):
            raise BeyondError
        if base.a < 0:  # what is not known to be negative may be nothing
            base = context.mpf([0, base.b])
        if q == 2:
            return context.sqrt(base) ** p
        if base.a <= 0:
            raise BeyondError
        return context.exp(context.log(base) * p / q)
    inner = [values[each] for each in arguments]
    if any(each is None for each in inner):
        raise BeyondError
    if operation == "add":
        total = inner[0]
        for each in inner[1:]:
            total = total + each
        return total
    if operation == "multiply":
        product = inner[0]
        for each in inner[1:]:
            product = product * each
        return product
    return _function_in(context, operation, inner)


def _fraction_in(context: Any, value: Any) -> Any:
    fraction = Fraction(*to_rational(value._mpf_)) if hasattr(value, "_mpf_") else Fraction(value)
    return context.mpf(fraction.numerator) / fraction.denominator


@lru_cache(maxsize=512)
def _root_in(context: Any, x: Any) -> Any:
    """A real root of a polynomial without a formula."""
    width = sp.Rational(1, 10 ** (context.dps + 5))
    middle = x.eval_rational(width)
    low, high = (Fraction(int(y.p), int(y.q)) for y in (middle - width, middle + width))
    return context.mpf([_fraction_in(context, low).a, _fraction_in(context, high).b])


def _function_in(context: Any, operation: str, inner: list[Any]) -> Any:
    x = inner[0]
    if operation in ("sin", "cos"):
        return getattr(context, operation)(x)
    if operation in ("tan", "sec", "cot", "csc"):
        below = context.cos(x) if operation in ("tan", "sec") else context.sin(x)
        if below.a <= 0 <= below.b:
            raise BeyondError
        above = {"tan": context.sin(x), "cot": context.cos(x)}.get(operation, context.mpf(1))
        return above / below
    if operation == "atan":
        return context.atan2(x, context.mpf(1))
    if operation == "acot":
        return (
            context.atan2(context.mpf(1), x)
            if x.a > 0
            else context.pi / -2 - context.atan2(x, context.mpf(1))
        )
    if operation in ("acos", "asin"):
        if x.b < -1 or x.a > 1:
            raise BeyondError
        other = 1 - x * x
        if other.b < 0:
            raise BeyondError
        other = context.sqrt(context.mpf([max(other.a, 0), other.b]))
        return context.atan2(other, x) if operation == "acos" else context.atan2(x, other)
    if operation == "atan2":
        y, x = inner
        if x.a <= 0 and y.a <= 0 <= y.b:
            raise BeyondError
        return context.atan2(y, x)
    if operation == "abs":
        return abs(x)
    if operation == "sign":
        if x.a > 0 or x.b < 0:
            return context.mpf(1 if x.a > 0 else -1)
        raise BeyondError
    low = [each.a for each in inner]
    high = [each.b for each in inner]
    pick = max if operation == "max" else min
    return context.mpf([pick(low), pick(high)])


def box_signs(program: Program, box: Mapping[str, tuple[float, float]]) -> list[frozenset[int]]:
    """The signs that the expressions may have in a box; all of them where it is not known."""
    context = _context(20)
    point = {name: context.mpf([low, high]) for name, (low, high) in box.items()}
    values: list[Any] = []
    for operation, arguments in program.instructions:
        try:
            if operation == "letter":
                values.append(point[arguments[0]])
            else:
                values.append(_enclosed(context, operation, arguments, values, {}))
        except (BeyondError, ZeroDivisionError, ValueError, OverflowError, TypeError):
            values.append(None)
    signs = []
    for place in program.results:
        x = values[place]
        if x is None:
            signs.append(frozenset({-1, 0, 1}))
            continue
        low, high = ends_of(x)
        signs.append(
            frozenset(
                sign for sign, may in ((-1, low < 0), (0, low <= 0 <= high), (1, high > 0)) if may
            )
        )
    return signs
