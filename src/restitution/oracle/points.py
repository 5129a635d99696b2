"""The sign of an expression at one point, with a bound on every rounding error.

Expressions are compiled once into a list of instructions that shares what they have in common.
At a point, where every letter has an exact value, the list is worked through in floats that carry
a bound of their error; where that leaves a sign open in fractions, if there are no roots or angles
in it; then in intervals of many digits. A sign that is given is certain.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import cached_property, lru_cache
from typing import Any, TypeAlias

import sympy as sp
from mpmath.libmp import (
    ComplexResult,
    dps_to_prec,
    from_float,
    mpf_sign,
    mpi_add,
    mpi_mid,
    mpi_mul,
    prec_to_dps,
    to_float,
    to_rational,
)
from mpmath.libmp.libmpi import mpi_pi

from restitution.exact.degrees import function_of
from restitution.exact.symbols import expression_of
from restitution.expression.enclosed import (
    Enclosed,
    Interval,
    fraction_in,
    function_in,
    power_in,
    sign_of,
    whole_power_in,
)
from restitution.records import dataclass

Value: TypeAlias = Fraction | float | sp.Expr
Point = Mapping[str, Value]
Ball = tuple[float, float]
"""A number in floats, and a bound of its error."""

# Twice the unit roundoff: what one operation adds, itself rounded.
_EPSILON = 2.0**-51
_TINY = 1e-300
_NOWHERE = (math.nan, math.nan)  # of what has no value in floats; nor has what is made of it
# Floats below it are added and multiplied without an error if they are whole and few.
_WHOLE = 2.0**26
_EXACT = 2.0**53
DIGITS = (60, 240)
_SEARCHED = 300


def as_number(value: Value) -> sp.Expr:
    """The value of a letter at a point as a SymPy number."""
    return value if isinstance(value, sp.Expr) else sp.Rational(Fraction(value))


class BeyondError(Exception):
    """A value cannot be had in this arithmetic: it is undefined, or too wide to tell."""


_NO_VALUE = (BeyondError, ArithmeticError, ValueError, ComplexResult)


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
        return _compiled(tuple(map(expression_of, expressions)))

    def signs(self, point: Point, balls: Mapping[str, Ball] | None = None) -> list[int | None]:
        """The sign of every expression at a point; None where it is undefined or not certain.

        ``balls`` are the letters' values in floats, where they are known already.
        Raises KeyError for a letter without a value.
        """
        signs = self.sure_signs(point, balls)
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
            left = [n for n, sign in enumerate(signs) if sign is None]
            try:
                intervals = self.enclosures(point, digits, left)
            except BeyondError:
                continue
            for n, interval in zip(left, intervals, strict=True):
                if interval is not None:
                    signs[n] = sign_of(interval)
            if None not in signs:
                break
        return signs

    def near_signs(self, point: Point) -> list[int | None]:
        """The signs, with 0 for what may be zero, as far as 300 digits show.

        None is for what has no real value. This is for a search; it decides nothing.
        """
        signs = self.sure_signs(point)
        self.search(point, signs, range(len(signs)))
        return signs

    def search(self, point: Point, signs: list[int | None], wanted: Iterable[int]) -> None:
        """Puts `near_signs` in place of None among signs, for the expressions with some numbers."""
        left = [n for n in wanted if signs[n] is None]
        if left:
            for n, interval in zip(left, self.enclosures(point, _SEARCHED, left), strict=True):
                signs[n] = None if interval is None else sign_of(interval) or 0

    def sure_signs(self, point: Point, balls: Mapping[str, Ball] | None = None) -> list[int | None]:
        """The signs that floats show for certain; None where they do not.

        ``balls`` are the letters' values in floats, where they are known already.
        Raises KeyError for a letter without a value.
        """
        signs: list[int | None] = [None] * len(self.results)
        for n, value in enumerate(self.balls(point, balls)):
            if value is not None:
                middle, error = value
                if abs(middle) > error:
                    signs[n] = 1 if middle > 0 else -1
                elif error == 0:
                    signs[n] = 0
        return signs

    def balls(self, point: Point, letters: Mapping[str, Ball] | None = None) -> list[Ball | None]:
        """The values in floats, with bounds of the errors; None where floats have none.

        ``letters`` are those of the letters, where they are known already.
        Raises KeyError for a letter without a value.
        """
        try:
            values = self._balls(self._balls_at(point) if letters is None else letters)
        except (BeyondError, ArithmeticError, ValueError):
            return [None] * len(self.results)
        return [values[place] for place in self.results]

    def _balls_at(self, point: Point) -> dict[str, Ball]:
        return {name: ball(point[name]) for name in self.letters}

    @cached_property
    def _steps(self) -> tuple[list[Ball | None], list[tuple[int, str, tuple[Any, ...]]]]:
        """The values that need no letter, and what is left to be worked out at a point."""
        values: list[Ball | None] = []
        steps: list[tuple[int, str, tuple[Any, ...]]] = []
        for place, (operation, arguments) in enumerate(self.instructions):
            value = None
            if operation in ("number", "constant"):
                value = ball(arguments[0])
            elif operation == "pi":
                value = (math.pi, math.pi * _EPSILON)
            elif operation == "nothing":
                value = _NOWHERE
            else:
                if operation == "power" and arguments[1] == 2:
                    operation = "square"
                steps.append((place, operation, arguments))
            values.append(value)
        return values, steps

    def _balls(self, letters: Mapping[str, Ball]) -> list[Ball]:
        # What is beyond floats is infinite, or no number: so is then its error, and no sign is
        # read from it.
        known, steps = self._steps
        values: list[Any] = known.copy()
        for place, operation, arguments in steps:
            if operation == "multiply":
                middle, error = values[arguments[0]]
                for argument in arguments[1:]:
                    m, r = values[argument]
                    product = middle * m
                    if error == 0.0 and r == 0.0:
                        if middle == 0.0 or m == 0.0:
                            product = 0.0
                        elif not (
                            -_WHOLE < middle < _WHOLE
                            and -_WHOLE < m < _WHOLE
                            and middle.is_integer()
                            and m.is_integer()
                        ):
                            error = abs(product) * _EPSILON + _TINY
                    elif (error == middle == 0.0 and r == r) or (r == m == 0.0 and error == error):
                        product = error = 0.0  # unless the other has no value at all
                    else:
                        error = (
                            (abs(middle) * r + abs(m) * error + error * r) * (1 + _EPSILON)
                            + abs(product) * _EPSILON
                            + _TINY
                        )
                    middle = product
                values[place] = middle, error
            elif operation == "add":
                middle = error = size = 0.0
                whole = True
                for argument in arguments:
                    m, r = values[argument]
                    middle += m
                    error += r
                    size += abs(m)
                    whole = whole and m.is_integer()
                if error or size >= _EXACT or not whole:
                    error += size * _EPSILON * len(arguments)
                values[place] = middle, error
            elif operation == "letter":
                values[place] = letters[arguments[0]]
            elif operation == "square":
                middle, error = values[arguments[0]]
                product = middle * middle
                if error or not (product < _EXACT and middle.is_integer()):
                    error = (2 * abs(middle) + error) * error * (1 + 4 * _EPSILON)
                    error += product * _EPSILON + _TINY
                values[place] = product, error
            else:
                try:
                    if operation == "power":
                        values[place] = _ball_power(values[arguments[0]], arguments[1])
                    elif operation == "root":
                        values[place] = _ball_root(values[arguments[0]], arguments[1], arguments[2])
                    else:
                        values[place] = _ball_function(operation, values[arguments[0]])
                except (BeyondError, ArithmeticError, ValueError):
                    values[place] = _NOWHERE
        return values

    def _fractions(self, point: Point) -> list[Fraction]:
        values: list[Fraction] = []
        for operation, arguments in self.instructions:
            if operation == "number":
                values.append(arguments[0])
            elif operation == "letter":
                values.append(Fraction(point[arguments[0]]))
            elif operation == "add":
                values.append(sum((values[argument] for argument in arguments), Fraction(0)))
            elif operation == "multiply":
                values.append(
                    math.prod((values[argument] for argument in arguments), start=Fraction(1))
                )
            else:
                values.append(values[arguments[0]] ** arguments[1])
        return values

    def enclosures(
        self, point: Point, digits: int, wanted: Sequence[int] | None = None
    ) -> list[Interval | None]:
        """Intervals of so many digits that hold the values; None where there is no value.

        ``wanted`` are the numbers of some of the expressions; without it, it is all of them.
        """
        precision = dps_to_prec(digits)
        values = self._constants_in(precision).copy()
        instructions = self.instructions
        for place in self._needed(None if wanted is None else tuple(wanted)):
            operation, arguments = instructions[place]
            with suppress(*_NO_VALUE):
                values[place] = _enclosed(precision, operation, arguments, values, point)
        results = self.results if wanted is None else [self.results[n] for n in wanted]
        return [values[place] for place in results]

    def _constants_in(self, precision: int) -> list[Interval | None]:
        """The values that need no letter, as intervals of so many bits."""
        if precision not in self._intervals:
            values: list[Interval | None] = [None] * len(self.instructions)
            for place, (operation, arguments) in enumerate(self.instructions):
                if operation in _CONSTANTS:
                    with suppress(*_NO_VALUE):
                        values[place] = _enclosed(precision, operation, arguments, values, {})
            self._intervals[precision] = values
        return self._intervals[precision]

    @cached_property
    def _intervals(self) -> dict[int, list[Interval | None]]:
        return {}

    def _needed(self, wanted: tuple[int, ...] | None) -> Sequence[int]:
        """The instructions from which some of the expressions have their values, in order.

        Those of constants are left out.
        """
        if wanted is None or len(wanted) == len(self.results):
            wanted = tuple(range(len(self.results)))
        if wanted not in self._slices:
            needed = {self.results[n] for n in wanted}
            for place in range(len(self.instructions) - 1, -1, -1):
                operation, arguments = self.instructions[place]
                if place in needed:
                    needed.update(_earlier(operation, arguments))
            self._slices[wanted] = tuple(
                place for place in sorted(needed) if self.instructions[place][0] not in _CONSTANTS
            )
        return self._slices[wanted]

    @cached_property
    def _slices(self) -> dict[tuple[int, ...], tuple[int, ...]]:
        return {}


@lru_cache(maxsize=512)
def _compiled(expressions: tuple[sp.Expr, ...]) -> Program:
    compiler = _Compiler()
    results = tuple(compiler.place(expression) for expression in expressions)
    rational = all(operation in _RATIONAL for operation, _ in compiler.instructions)
    letters = frozenset(a[0] for operation, a in compiler.instructions if operation == "letter")
    return Program(tuple(compiler.instructions), results, rational, letters)


_CONSTANTS = frozenset({"number", "pi", "constant", "nothing"})
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


def _earlier(operation: str, arguments: tuple[Any, ...]) -> tuple[int, ...]:
    """The places of the values that an instruction needs."""
    if operation in ("number", "letter", "constant"):
        return ()
    return arguments[:1] if operation in ("power", "root") else arguments


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
            return "add", tuple(self.place(argument) for argument in x.args)
        if x.is_Mul:
            return "multiply", tuple(self.place(argument) for argument in x.args)
        if x.is_Pow and x.exp.is_Integer:
            return "power", (self.place(x.base), int(x.exp))
        if x.is_Pow and x.exp.is_Rational:
            return "root", (self.place(x.base), int(x.exp.p), int(x.exp.q))
        if isinstance(x, sp.CRootOf):
            return "constant", (x,)
        name = _FUNCTIONS.get(function_of(x))
        if name is None:
            raise BeyondError(str(x))
        return name, tuple(self.place(argument) for argument in x.args)


# --- floats with a bound of their error ----------------------------------------------------------


def ball(value: Value) -> Ball:
    """A value in floats, with a bound of the error; that is 0 where the float is the value.

    Raises BeyondError for a constant without a real value.
    """
    if isinstance(value, float):
        return value, 0.0
    if isinstance(value, Fraction):
        return _ball_of_fraction(value)
    if isinstance(value, sp.Expr):
        if value.is_Rational:
            return _ball_of_fraction(Fraction(int(value.p), int(value.q)))
        interval = constant_interval(value, 30)
        middle = to_float(mpi_mid(interval, dps_to_prec(30)))
        return middle, abs(middle) * 2 * _EPSILON + _TINY
    if isinstance(value, Enclosed):
        low, high = (to_float(end) for end in value.ends)
        middle = low + (high - low) / 2
        return middle, (high - low) + abs(middle) * 2 * _EPSILON + _TINY
    middle = float(value)
    exact = isinstance(value, int) and middle == value
    return middle, 0.0 if exact else abs(middle) * _EPSILON + _TINY


def _ball_of_fraction(value: Fraction) -> Ball:
    above, below = value.numerator, value.denominator
    middle = above / below
    # Halves of halves of a whole number of few digits are floats.
    exact = above.bit_length() <= 53 and not below & (below - 1) and below < 2**1000
    return middle, 0.0 if exact else abs(middle) * _EPSILON + _TINY


def _ball_product(one: Ball, other: Ball) -> Ball:
    (middle, error), (m, r) = one, other
    product = middle * m
    spread = (abs(middle) * r + abs(m) * error + error * r) * (1 + _EPSILON)
    return product, spread + abs(product) * _EPSILON + _TINY


def _ball_power(base: Ball, n: int) -> Ball:
    middle, error = base
    if n < 0:
        low = abs(middle) - error
        if low <= 0:
            raise BeyondError
        inverse = 1 / middle
        error = error / (low * abs(middle)) * (1 + 4 * _EPSILON) + abs(inverse) * _EPSILON + _TINY
        middle, n = inverse, -n
        if n == 1:
            return middle, error
    value, spread = 1.0, 0.0
    for _ in range(n):
        spread = (abs(value) * error + abs(middle) * spread + spread * error) * (1 + _EPSILON)
        exact = spread == 0 and _is_whole(value) and _is_whole(middle)
        value *= middle
        if not exact or abs(value) >= _EXACT:
            spread += abs(value) * _EPSILON + _TINY
    return value, spread


def _is_whole(x: float) -> bool:
    return abs(x) < _WHOLE and x.is_integer()


def _ball_root(base: Ball, p: int, q: int) -> Ball:
    middle, error = base
    low, high = middle - error, middle + error
    if low <= 0:
        if middle == error == 0 and p > 0:
            return 0.0, 0.0
        raise BeyondError
    if q == 2 and p == 1:
        value = math.sqrt(middle)
        if error == 0 and _is_whole(value) and value * value == middle:
            return value, 0.0
        steepest = 0.5 / math.sqrt(low)
    else:
        value = math.pow(middle, p / q)
        steepest = max(math.pow(low, p / q - 1), math.pow(high, p / q - 1)) * abs(p) / q
    return value, (steepest * error + 4 * value * _EPSILON) * (1 + _EPSILON)


def _ball_function(operation: str, x: Ball) -> Ball:
    middle, error = x
    if middle == error == 0.0 and operation in ("sin", "cos"):
        return (0.0 if operation == "sin" else 1.0), 0.0
    if operation in ("sin", "cos"):
        value = math.sin(middle) if operation == "sin" else math.cos(middle)
        return value, error + 2 * _EPSILON
    if operation == "abs":
        return abs(middle), error
    if operation == "atan":
        return math.atan(middle), error + 4 * _EPSILON
    if operation in ("tan", "sec", "cot", "csc"):
        cosine, sine = (_ball_function(ratio, x) for ratio in ("cos", "sin"))
        below = cosine if operation in ("tan", "sec") else sine
        above = {"tan": sine, "cot": cosine}.get(operation, (1.0, 0.0))
        return _ball_product(above, _ball_power(below, -1))
    raise BeyondError


# --- intervals of many digits ---------------------------------------------------------------------


def ends_of(interval: Interval) -> tuple[Fraction, Fraction]:
    """The two ends of an interval, exactly."""
    low, high = (Fraction(*to_rational(value)) for value in interval)
    return low, high


@lru_cache(maxsize=1024)
def constant_interval(x: sp.Expr, digits: int) -> Interval:
    """An interval of so many digits that holds a number. Raises BeyondError if it is not real."""
    interval = Program.of([x]).enclosures({}, digits)[0]
    if interval is None:
        raise BeyondError(str(x))
    return interval


def _enclosed(
    precision: int,
    operation: str,
    arguments: tuple[Any, ...],
    values: list[Interval | None],
    point: Point,
) -> Interval:
    if operation == "number":
        return fraction_in(precision, arguments[0])
    if operation == "letter":
        value = point[arguments[0]]
        if isinstance(value, sp.Expr) and not value.is_Rational:
            return constant_interval(value, prec_to_dps(precision))
        if isinstance(value, Enclosed):
            return value.ends
        if isinstance(value, sp.Expr):
            value = Fraction(int(value.p), int(value.q))
        return fraction_in(precision, Fraction(value))
    if operation == "pi":
        return mpi_pi(precision)  # type: ignore[no-any-return]
    if operation == "constant":
        return _root_in(precision, arguments[0])
    if operation == "nothing":
        raise BeyondError
    if operation == "power":
        return whole_power_in(precision, values[arguments[0]], arguments[1])
    if operation == "root":
        return power_in(precision, values[arguments[0]], arguments[1], arguments[2])
    inner: list[Interval] = []
    for argument in arguments:
        own = values[argument]
        if own is None:
            raise BeyondError
        inner.append(own)
    if operation == "add":
        total = inner[0]
        for own in inner[1:]:
            total = mpi_add(total, own, precision)
        return total
    if operation == "multiply":
        product = inner[0]
        for own in inner[1:]:
            product = mpi_mul(product, own, precision)
        return product
    return function_in(precision, operation, inner)


@lru_cache(maxsize=512)
def _root_in(precision: int, x: Any) -> Interval:
    """A real root of a polynomial without a formula."""
    width = sp.Rational(1, 10 ** (prec_to_dps(precision) + 5))
    middle = x.eval_rational(width)
    low, high = (Fraction(int(y.p), int(y.q)) for y in (middle - width, middle + width))
    return fraction_in(precision, low)[0], fraction_in(precision, high)[1]


def box_signs(program: Program, box: Mapping[str, tuple[float, float]]) -> list[frozenset[int]]:
    """The signs that the expressions may have in a box; all of them where it is not known."""
    precision = dps_to_prec(20)
    point = {name: (from_float(low), from_float(high)) for name, (low, high) in box.items()}
    values: list[Interval | None] = []
    for operation, arguments in program.instructions:
        try:
            if operation == "letter":
                values.append(point[arguments[0]])
            else:
                values.append(_enclosed(precision, operation, arguments, values, {}))
        except _NO_VALUE:
            values.append(None)
    signs = []
    for place in program.results:
        x = values[place]
        if x is None:
            signs.append(frozenset({-1, 0, 1}))
            continue
        low, high = mpf_sign(x[0]), mpf_sign(x[1])
        signs.append(
            frozenset(
                sign for sign, may in ((-1, low < 0), (0, low <= 0 <= high), (1, high > 0)) if may
            )
        )
    return signs
