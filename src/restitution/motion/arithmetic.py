"""The two kinds of number in which a table can be played: floats, and exact numbers.

What a motion needs beyond + − × ÷ is here: to read what a user gives, to take a root, to tell
the time, and to know what rounding may have done.

In floats a moment is a pair of numbers, whose sum it is: the nearest float and what it lacks.
So impacts that follow one another late in a long motion are still told apart as well as at its
beginning, and places derived from them are as good.
"""

from __future__ import annotations

import math
import numbers
import sys
from collections.abc import Callable, Iterable
from decimal import Decimal
from fractions import Fraction
from typing import Any, NoReturn, Protocol

from restitution.errors import StatementError, UnsupportedError
from restitution.expression.tree import Binary, Expression, Negate, Number, Pair
from restitution.motion.contact import TOLERANCE
from restitution.motion.surds import TooManyRootsError, Tower, translated
from restitution.vector import Vector


class Arithmetic(Protocol):
    """One kind of number; moments are of a kind of their own that can be compared."""

    exact: bool
    start: Any

    def number(self, value: Any, what: str) -> Any:
        """What a user gave, as such a number; ``what`` it is stands in the errors."""

    def root(self, x: Any) -> Any:
        """The square root, of a number that goes on being used."""

    def root_to_compare(self, x: Any) -> Any:
        """The square root, of a number that is only to be compared for now."""

    def later(self, moment: Any, seconds: Any) -> Any:
        """The moment so many seconds later."""

    def since(self, moment: Any, earlier: Any) -> Any:
        """The seconds from one moment to another."""

    def reached(self, moment: Any) -> Any:
        """A moment that was compared and is now to be used."""

    def time(self, moment: Any) -> Any:
        """The moment as one number, in s."""

    def rounding(self, lengths: Iterable[Any]) -> Any:
        """How far a place made from these coordinates may be wrong, in m."""

    def settled(self, velocity: Vector, speed: float) -> Vector:
        """A velocity made from speeds so large: rest, if it is no more than rounding of them."""

    def shown(self, number: Any) -> Any:
        """The number as a user gets it."""


# A float whose square still has all its figures; what is slower does not move.
_SLOWEST = math.sqrt(sys.float_info.min / sys.float_info.epsilon)


class Floats:
    """Double precision."""

    exact = False
    start = (0.0, 0.0)

    def number(self, value: Any, what: str) -> float:
        value_ = given(value, what)
        if hasattr(value_, "free_symbols"):
            from restitution.exact import decimal

            value_ = decimal(value_)
            if value_ is None:
                _refuse(value, what)
        try:
            number = float(value_)
        except OverflowError:
            number = math.inf
        if not math.isfinite(number):
            raise StatementError(f"{what} is {number}: it must be a finite number")
        return number

    def root(self, x: float) -> float:
        return math.sqrt(x)

    root_to_compare = root

    def later(self, moment: tuple[float, float], seconds: float) -> tuple[float, float]:
        time, rest = moment
        total = time + seconds  # what the sum loses is found again (Knuth's two-sum)
        added = total - time
        rest += (time - (total - added)) + (seconds - added)
        nearest = total + rest
        return nearest, rest - (nearest - total)

    def since(self, moment: tuple[float, float], earlier: tuple[float, float]) -> float:
        return (moment[0] - earlier[0]) + (moment[1] - earlier[1])

    def reached(self, moment: tuple[float, float]) -> tuple[float, float]:
        return moment

    def time(self, moment: tuple[float, float]) -> float:
        return moment[0]

    def rounding(self, lengths: Iterable[float]) -> float:
        return TOLERANCE * sum(map(abs, lengths))

    def settled(self, velocity: Vector, speed: float) -> Vector:
        still = abs(velocity.x) + abs(velocity.y) <= max(TOLERANCE * speed, _SLOWEST)
        return Vector(0.0, 0.0) if still else velocity

    def shown(self, number: float) -> float:
        return number


class ExactNumbers:
    """Rationals and square roots."""

    exact = True
    start = Fraction(0)

    def __init__(self, tower: Tower | None = None) -> None:
        self.tower = tower or Tower()

    def copy(self) -> ExactNumbers:
        """The same numbers so far; roots adjoined from now on are its own."""
        return ExactNumbers(Tower(self.tower.roots))

    def number(self, value: Any, what: str) -> Any:
        number = given(value, what)
        if hasattr(number, "free_symbols"):
            from restitution.exact.surds import worked_out

            try:
                return worked_out(number, Fraction, self.root)
            except (ArithmeticError, TypeError):
                raise UnsupportedError(
                    f"{what} is {number}: an exact motion takes rational numbers and square roots"
                ) from None
        if isinstance(number, numbers.Rational):
            return Fraction(int(number.numerator), int(number.denominator))
        raise StatementError(
            f'{what} is the float {number}: an exact motion takes text, as in "0.1", whole '
            "numbers, fractions or exact numbers of SymPy"
        )

    def root(self, x: Any) -> Any:
        return _within_reason(self.tower.sqrt, x)

    def root_to_compare(self, x: Any) -> Any:
        return self.tower.tentative_sqrt(x)

    def later(self, moment: Any, seconds: Any) -> Any:
        return moment + seconds

    def since(self, moment: Any, earlier: Any) -> Any:
        return moment - earlier

    def reached(self, moment: Any) -> Any:
        return _within_reason(self.tower.lifted, moment)

    def time(self, moment: Any) -> Any:
        return moment

    def rounding(self, lengths: Iterable[Any]) -> Any:
        return 0

    def settled(self, velocity: Vector, speed: float) -> Vector:
        return velocity

    def shown(self, number: Any) -> Any:
        from restitution.exact import tidy
        from restitution.expression.evaluate import Symbolic

        symbolic = Symbolic()
        return tidy(translated(number, symbolic.number, symbolic.sqrt))


def _within_reason(function: Callable[[Any], Any], x: Any) -> Any:
    try:
        return function(x)
    except TooManyRootsError as error:
        raise UnsupportedError(
            f"the motion needs {error}: exact numbers grow too long here; play it in floats, or "
            "ask for fewer impacts"
        ) from None


# --- what a user gives -------------------------------------------------------------------------


def given(value: Any, what: str) -> Any:
    """A number as it was given, text and trees read: a fraction, a float, or SymPy's."""
    if isinstance(value, str | Expression):
        value = _read(value, what)
    if isinstance(value, Decimal) and value.is_finite():
        return Fraction(value)
    if hasattr(value, "free_symbols"):
        if value.free_symbols:
            letter = min(map(str, value.free_symbols))
            raise StatementError(f"{what} is {value}: the letter {letter} has no value here")
        return value
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        _refuse(value, what)
    return value


def given_vector(value: Any, what: str) -> tuple[Any, Any]:
    """The components of a vector as it was given: a pair, an array of two, or text."""
    if isinstance(value, Pair):
        return value.x, value.y
    if isinstance(value, str | Expression):
        value = _read(value, what)
    elif _is_array(value):
        value = value.tolist()
    if isinstance(value, tuple | list) and len(value) == 2:
        return value[0], value[1]
    if not isinstance(value, tuple | list | bool) and value == 0:
        return 0, 0
    raise StatementError(f"{what} is not a vector: {value!r}")


def vector(value: Any, what: str, kind: Arithmetic) -> Vector:
    """A vector that was given, in one kind of number."""
    x, y = given_vector(value, what)
    return Vector(kind.number(x, f"{what} along i"), kind.number(y, f"{what} along j"))


def direction(value: Any, what: str, kind: Arithmetic) -> Vector:
    """A vector, or an angle anticlockwise from **i**: text with its unit, or radians."""
    if isinstance(value, str | Expression) and not isinstance(value, Pair):
        value = _read(value, what)
    if isinstance(value, tuple | list | Pair) or _is_array(value):
        return vector(value, what, kind)
    angle = given(value, what)
    if isinstance(angle, float):
        return vector((math.cos(angle), math.sin(angle)), what, kind)
    from restitution.expression.evaluate import Symbolic

    return vector(Symbolic().cos_sin(angle), what, kind)


def _read(value: str | Expression, what: str) -> Any:
    try:
        if isinstance(value, str):
            from restitution.expression import read_expression

            value = read_expression(value)
        plain = _plain(value)
        if plain is not None:
            return plain
        from restitution.expression.evaluate import evaluate

        return evaluate(value, _no_letter)
    except StatementError as error:
        raise StatementError(f"{what}: {error.message}") from error


def _no_letter(name: str) -> NoReturn:
    raise StatementError(f"the letter {name} has no value here")


def _plain(tree: Expression) -> Fraction | None:
    """The value of a tree that is only a whole number or a fraction, without any algebra."""
    match tree:
        case Number(value):
            return value
        case Negate(operand):
            root = _plain(operand)
            return None if root is None else -root
        case Binary("/", Number(above), Number(below)) if below:
            return above / below
    return None


def _is_array(value: Any) -> bool:
    return len(getattr(value, "shape", "")) > 0


def _refuse(value: Any, what: str) -> NoReturn:
    raise StatementError(f"{what} is not a number: {value!r}")
