"""From an expression tree to its value, in exact symbols or in numbers of high precision.

One reading of a tree serves both: a :class:`Symbolic` arithmetic (SymPy) and a
:class:`Numeric` one (mpmath). A value is a scalar, a :class:`~restitution.vector.Vector`, or an
:class:`Angle`. Angles are kept as a direction, so that a fact about an angle becomes a relation
of dot and cross products and never an inverse function.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp

from restitution.errors import RestitutionError, StatementError
from restitution.exact.degrees import cosine, sine, turns_of
from restitution.exact.symbols import symbol_names, symbols_in
from restitution.expression.enclosed import PI, Enclosed
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Pi,
    Polar,
    Quantity,
    Unit,
    letters,
)
from restitution.records import dataclass
from restitution.vector import Vector

Scalar = Any


@dataclass(frozen=True)
class Angle:
    """An angle as a direction: (x, y) is (cos, sin) times any positive factor.

    ``measure`` gives it in radians, as a scalar; it is a function because most angles are only
    ever compared, and the measure costs an inverse tangent.
    """

    x: Scalar
    y: Scalar
    measure: Callable[[], Scalar]


Value = Any  # Scalar | Vector | Angle


_LONG_NUMBER = 60


class Symbolic:
    """Exact arithmetic in SymPy."""

    exact = True
    pi = sp.pi
    zero = sp.Integer(0)

    def number(self, value: Fraction) -> Scalar:
        return _rational(*value.as_integer_ratio())

    def sqrt(self, x: Scalar) -> Scalar:
        return root(sp.sympify(x, strict=True))

    def abs(self, x: Scalar) -> Scalar:
        if not symbols_in(x) and (x.has(sp.CRootOf) or sp.count_ops(x) > _LONG_NUMBER):
            # SymPy would look for a form of it; its digits tell on which side of zero it is.
            number = x.evalf(20)
            if number.is_Float and number._prec > 1:
                return x if number > 0 else -x
        return sp.Abs(x)

    def power(self, x: Scalar, y: Scalar) -> Scalar:
        return x**y

    def cos_sin(self, x: Scalar) -> tuple[Scalar, Scalar]:
        return cos_sin(sp.sympify(x, strict=True))

    def arctan2(self, y: Scalar, x: Scalar) -> Scalar:
        return sp.atan2(y, x)

    def arc(self, function: str, x: Scalar) -> Scalar:
        return {"arcsin": sp.asin, "arccos": sp.acos, "arctan": sp.atan}[function](x)

    def is_zero(self, x: Scalar) -> bool:
        return bool(x == 0)


class Numeric:
    """Numbers with a bound of every rounding: `Enclosed`. Only the search rests on them."""

    exact = False
    pi = PI
    zero = Enclosed.of(0)

    def number(self, value: Fraction) -> Scalar:
        return Enclosed.of(value)

    def sqrt(self, x: Scalar) -> Scalar:
        return Enclosed.of(x).sqrt()

    def abs(self, x: Scalar) -> Scalar:
        return abs(x)

    def power(self, x: Scalar, y: Scalar) -> Scalar:
        return Enclosed.of(x) ** y

    def cos_sin(self, x: Scalar) -> tuple[Scalar, Scalar]:
        return Enclosed.of(x).cos_sin()

    def arctan2(self, y: Scalar, x: Scalar) -> Scalar:
        return Enclosed.atan2(y, x)

    def arc(self, function: str, x: Scalar) -> Scalar:
        return Enclosed.of(x).arc(function.replace("arc", "a"))

    def is_zero(self, x: Scalar) -> bool:
        return not Enclosed.of(x).sign


@lru_cache(maxsize=4096)
def _rational(numerator: int, denominator: int) -> sp.Rational:
    return sp.Rational(numerator, denominator)


@lru_cache(maxsize=4096)
def root(x: sp.Expr) -> sp.Expr:
    """√x with whole squares taken out: √(u² v) is u√v where u is positive."""
    if x.is_Number or x.is_Symbol:
        return sp.sqrt(x)
    factored = sp.factor_terms(x) if not x.is_Mul else x
    if factored.is_Add and len(factored.free_symbols) <= 6 and sp.count_ops(factored) <= 60:
        with suppress(sp.PolynomialError, NotImplementedError):
            factored = sp.factor(factored)
    return sp.sqrt(factored)


@lru_cache(maxsize=4096)
def cos_sin(x: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Cosine and sine of a sum of angles, expanded into those of its letters."""
    terms = sp.Add.make_args(sp.expand(x))
    if len(terms) == 1:
        return _cos_sin_of_term(terms[0])
    constants = [term for term in terms if not term.free_symbols]
    pairs = [_cos_sin_of_term(term) for term in terms if term.free_symbols]
    if constants:
        pairs.append(_cos_sin_of_term(sp.Add(*constants)))
    c, s = pairs[0]
    for c2, s2 in pairs[1:]:
        c, s = sp.expand(c * c2 - s * s2), sp.expand(s * c2 + c * s2)
    return c, s


def _cos_sin_of_term(term: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    turns = turns_of(term)
    if turns is not None:
        return cosine(turns), sine(turns)
    if term.is_Add:
        total = sp.cos(term), sp.sin(term)
        if any(addend.has(sp.cos, sp.sin) for addend in total):
            total = tuple(sp.expand_trig(addend) for addend in total)
        return total
    factor, base = term.as_coeff_Mul()
    if factor.is_Rational and factor.p not in (1,) and base != sp.pi and abs(factor.p) <= 6:
        c, s = sp.cos(base / factor.q), sp.sin(base / factor.q)
        rc, rs = sp.Integer(1), sp.Integer(0)
        for _ in range(abs(factor.p)):
            rc, rs = sp.expand(rc * c - rs * s), sp.expand(rs * c + rc * s)
        return rc, (rs if factor.p > 0 else -rs)
    return sp.cos(term), sp.sin(term)


class Evaluator:
    """Evaluates trees in one arithmetic.

    ``letter`` maps a canonical name to a value; ``quantity`` and ``name`` say what a
    :class:`Quantity` and the :class:`Name` of a body or a point are worth. Without them an
    expression may hold numbers and letters alone. Raises StatementError, at the place in the
    text, for what makes no sense: a vector squared, the sine of a vector.
    """

    def __init__(
        self,
        arithmetic: Symbolic | Numeric,
        letter: Callable[[str], Value],
        quantity: Callable[[Quantity], Value] | None = None,
        name: Callable[[Name], Value] | None = None,
        wall_direction: Callable[[Expression], Vector] | None = None,
    ) -> None:
        self.field = arithmetic
        self._letter = letter
        self._quantity = quantity
        self._name = name
        self._wall_direction = wall_direction

    # -- the three kinds of value ---------------------------------------------------------

    def scalar(self, tree: Expression) -> Scalar:
        """The value of a tree that must be a number; angles count in radians."""
        value = self.value(tree)
        if isinstance(value, Angle):
            return value.measure()
        if isinstance(value, Vector):
            raise _error(tree, "a vector stands where a number is needed")
        return value

    def vector(self, tree: Expression) -> Vector:
        """The value of a tree that must be a vector; the number 0 is the zero vector."""
        value = self.value(tree)
        if isinstance(value, Vector):
            return value
        if not isinstance(value, Angle) and self.field.is_zero(value):
            return Vector(self.field.zero, self.field.zero)
        raise _error(tree, "a number stands where a vector is needed")

    def direction(self, tree: Expression) -> Vector:
        """A direction: a vector, or an angle measured anticlockwise from **i**."""
        value = self.value(tree)
        if isinstance(value, Vector):
            return value
        return Vector(*self.cos_sin(value))

    def value(self, tree: Expression) -> Value:
        """The value of a tree: a scalar, a Vector or an Angle."""
        match tree:  # what is met most stands first
            case Binary():
                return self._binary(tree)
            case Letter(name):
                return self._letter(name)
            case Number(value):
                return self.field.number(value)
            case Quantity():
                if self._quantity is None:
                    raise _error(tree, f"{tree.kind} has no meaning here")
                return self._quantity(tree)
            case Apply(function, argument):
                return self._apply(tree, function, self.value(argument))
            case Unit(axis):
                one = self.field.number(Fraction(1))
                zero = self.field.zero
                return Vector(one, zero) if axis == "i" else Vector(zero, one)
            case Negate(operand):
                return self._negate(self.value(operand))
            case Degrees(value):
                return self.field.number(value / 180) * self.field.pi
            case Pi():
                return self.field.pi
            case Name():
                if self._name is None:
                    raise _error(tree, f"{tree.name} is not a number")
                return self._name(tree)
            case Pair(x, y):
                return Vector(self.scalar(x), self.scalar(y))
            case Polar():
                return self._polar(tree)
        raise TypeError(tree)  # pragma: no cover - the kinds of node are all listed

    # -- angles ----------------------------------------------------------------------------

    def cos_sin(self, value: Value) -> tuple[Scalar, Scalar]:
        """Cosine and sine, up to a common positive factor for an Angle."""
        if isinstance(value, Angle):
            return value.x, value.y
        return self.field.cos_sin(value)

    def as_angle(self, value: Value) -> Angle:
        """A number of radians as an Angle."""
        if isinstance(value, Angle):
            return value
        x, y = self.field.cos_sin(value)
        return Angle(x, y, lambda: value)

    def _sum_of_angles(self, a: Value, b: Value, sign: int) -> Angle:
        a, b = self.as_angle(a), self.as_angle(b)
        y = b.y * sign
        return Angle(
            a.x * b.x - a.y * y, a.y * b.x + a.x * y, lambda: a.measure() + sign * b.measure()
        )

    def _times_angle(self, factor: Scalar, angle: Angle, tree: Expression) -> Value:
        """A rational multiple of an angle; halves by the bisector."""
        ratio = sp.nsimplify(factor, rational=True) if self.field.exact else factor
        for n in range(1, 7):
            for d in (1, 2):
                if self.field.is_zero(ratio - self.field.number(Fraction(n, d))):
                    base = self._half(angle) if d == 2 and n % 2 else angle
                    times = n if d == 2 and n % 2 else n // d
                    result = base
                    for _ in range(times - 1):
                        result = self._sum_of_angles(result, base, 1)
                    return result
        if self.field.is_zero(ratio + 1):
            return Angle(angle.x, -angle.y, lambda: -angle.measure())
        return factor * angle.measure()

    def _half(self, angle: Angle) -> Angle:
        x, y = angle.x + self.field.sqrt(angle.x**2 + angle.y**2), angle.y
        if self.field.is_zero(x) and self.field.is_zero(y):
            y = self.field.number(Fraction(1))  # half of 180°
        return Angle(x, y, lambda: angle.measure() / 2)

    # -- operations ------------------------------------------------------------------------

    def _polar(self, tree: Polar) -> Vector:
        size = self.scalar(tree.size)
        angle = self.value(tree.angle)
        if isinstance(angle, Vector):
            raise _error(tree.angle, "a vector stands where an angle is needed")
        c, s = self._unit(angle)
        if tree.wall is not None:
            if self._wall_direction is None:
                raise _error(tree, "a direction to a wall has no meaning here")
            base = self._wall_direction(tree.wall)
            s = -s
        elif tree.origin is not None:
            base = self.vector(tree.origin)
        else:
            return Vector(size * c, size * s)
        length = self.field.sqrt(base.x * base.x + base.y * base.y)
        if self.field.is_zero(length):
            raise _error(tree, "the zero vector has no direction")
        x, y = base.x / length, base.y / length
        return Vector(size * (x * c - y * s), size * (y * c + x * s))

    def _unit(self, angle: Value) -> tuple[Scalar, Scalar]:
        if isinstance(angle, Angle):
            length = self.field.sqrt(angle.x**2 + angle.y**2)
            return angle.x / length, angle.y / length
        return self.field.cos_sin(angle)

    def _negate(self, value: Value) -> Value:
        if isinstance(value, Vector):
            return Vector(-value.x, -value.y)
        if isinstance(value, Angle):
            return Angle(value.x, -value.y, lambda: -value.measure())
        return -value

    def _binary(self, tree: Binary) -> Value:
        return self._combined(tree, self.value(tree.left), self.value(tree.right))

    def _combined(self, tree: Binary, left: Value, right: Value) -> Value:
        op = tree.op
        vectors = isinstance(left, Vector), isinstance(right, Vector)
        if op in "+-":
            sign = 1 if op == "+" else -1
            if all(vectors):
                return left + right if sign > 0 else left - right
            if any(vectors):
                scalar = right if vectors[0] else left
                if not isinstance(scalar, Angle) and self.field.is_zero(scalar):
                    return left if vectors[0] else self._negate(right) if sign < 0 else right
                raise _error(tree, "a vector and a number cannot be added")
            if isinstance(left, Angle) or isinstance(right, Angle):
                return self._sum_of_angles(left, right, sign)
            return left + right if sign > 0 else left - right
        if op == "*":
            if all(vectors):
                raise _error(tree, "two vectors cannot be multiplied: dot(…, …) is their product")
            if vectors[0] or vectors[1]:
                vector, number = (left, right) if vectors[0] else (right, left)
                number = self._plain(number)
                return Vector(vector.x * number, vector.y * number)
            if isinstance(left, Angle) != isinstance(right, Angle):
                angle, number = (left, right) if isinstance(left, Angle) else (right, left)
                return self._times_angle(number, angle, tree)
            return self._plain(left) * self._plain(right)
        if op == "/":
            if vectors[1]:
                raise _error(tree, "a vector cannot divide")
            if not isinstance(right, Angle) and self.field.is_zero(right):
                raise _error(tree.right, "division by zero")
            if vectors[0]:
                number = self._plain(right)
                return Vector(left.x / number, left.y / number)
            if isinstance(left, Angle) and not isinstance(right, Angle):
                return self._times_angle(self.field.number(Fraction(1)) / right, left, tree)
            return self._plain(left) / self._plain(right)
        if any(vectors):
            raise _error(tree, "a vector has no power: use dot(…, …) or abs(…)")
        base, exponent = self._plain(left), self._plain(right)
        if self.field.exact and exponent.is_Number and abs(exponent) > 64:
            raise _error(tree, f"the power {exponent} is larger than 64")
        if self.field.exact and base.is_Number and exponent.is_Number and abs(base) > 10**12:
            raise _error(tree, "a power of so large a number")
        if self.field.is_zero(base) and not self._positive(exponent):
            raise _error(tree, "zero to a power that is not positive")
        return self.field.power(base, exponent)

    def _positive(self, x: Scalar) -> bool:
        return bool(x.is_positive) if self.field.exact else bool(x > 0)

    def _plain(self, value: Value) -> Scalar:
        return value.measure() if isinstance(value, Angle) else value

    def _apply(self, tree: Apply, function: str, value: Value) -> Value:
        if isinstance(value, Vector):
            if function == "abs":
                return self.field.sqrt(value.x * value.x + value.y * value.y)
            raise _error(tree, f"{function} of a vector has no meaning")
        if function == "sqrt":
            x = self._plain(value)
            if self.field.exact and x.is_negative:
                raise _error(tree, f"the square root of {x}, a negative number")
            return self.field.sqrt(x)
        if function == "abs":
            return self.field.abs(self._plain(value))
        if function.startswith("arc"):
            x = self._plain(value)
            if self.field.exact and function != "arctan" and x.is_number and abs(x) > 1:
                raise _error(tree, f"{function} of {x}, a number beyond 1")
            return self.field.arc(function, x)
        return self._trigonometric(tree, function, value)

    def _trigonometric(self, tree: Apply, function: str, value: Value) -> Scalar:
        if function in ("tan", "cot") and isinstance(value, Angle):
            c, s = value.x, value.y
        else:
            c, s = self._unit(value)
        top, bottom = {
            "sin": (s, None),
            "cos": (c, None),
            "tan": (s, c),
            "cot": (c, s),
            "sec": (self.field.number(Fraction(1)), c),
            "cosec": (self.field.number(Fraction(1)), s),
        }[function]
        if bottom is None:
            return top
        if self.field.is_zero(bottom):
            noun = _RATIOS[function]
            right = "a right angle" if function in ("tan", "sec") else "0° or 180°"
            raise _error(tree, f"the {noun} has no value, as the angle is {right}")
        return top / bottom


_RATIOS = {"tan": "tangent", "cot": "cotangent", "sec": "secant", "cosec": "cosecant"}


def evaluate(tree: Expression, symbol: Callable[[str], sp.Expr]) -> Any:
    """The exact value of an expression of numbers and letters: a SymPy expression or a Vector.

    ``symbol`` gives the SymPy symbol (or value) for a letter's canonical name.
    """
    value = Evaluator(Symbolic(), symbol).value(tree)
    return value.measure() if isinstance(value, Angle) else value


def enclosed(tree: Expression) -> Enclosed | None:
    """A number between two ends; None of a vector, of letters, and of what has no value."""
    letters_: dict[str, Scalar] = {}
    try:
        value = Evaluator(Numeric(), letters_.__getitem__).value(tree)
    except (KeyError, ArithmeticError, RestitutionError):
        return None
    if isinstance(value, Vector):
        return None
    return Enclosed.of(value.measure() if isinstance(value, Angle) else value)


def in_letters(tree: Expression, *, positive: bool = False) -> Any:
    """The exact value of an expression, in letters of which no more is known than their names.

    They may be taken to be ``positive``. Raises what `evaluate` raises.
    """
    return _in_letters(tree, positive)


@lru_cache(maxsize=4096)
def _in_letters(tree: Expression, positive: bool) -> Any:
    value = evaluate(tree, (lambda name: sp.Symbol(name, positive=True)) if positive else sp.Symbol)
    return value if isinstance(value, Vector) else sp.sympify(value, strict=True)


def letters_of_vector(tree: Expression) -> tuple[frozenset[str], frozenset[str]]:
    """The letters of a vector that are sizes, and those that are components of either sign.

    ``p i + 2j`` makes p any real number; in ``u i`` or ``u cos α i + …`` u is a speed.
    """
    if not letters(tree):
        return frozenset(), frozenset()
    try:
        vector = in_letters(tree, positive=True)
    except StatementError:
        return frozenset(), frozenset()
    if not isinstance(vector, Vector):
        return frozenset(), frozenset()
    sizes, components = set[str](), set[str]()
    x, y = (sp.expand(part) for part in vector)
    for one, other in ((x, y), (y, x)):
        _, rest = one.as_coeff_Mul()
        if rest.is_Symbol and other != 0 and not other.has(rest):
            components.add(rest.name)
        else:
            sizes.update(symbol_names(one))
    return frozenset(sizes), frozenset(components)


def _error(tree: Expression, message: str) -> StatementError:
    place = getattr(tree, "place", None)
    return StatementError(
        message,
        None if place is None else place.line,
        None if place is None else place.column,
    )
