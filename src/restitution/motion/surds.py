"""Exact numbers: rationals and square roots of them, also nested, decided without rounding.

A motion among straight walls and circles needs no more than the four operations and square
roots. So its numbers lie in a tower of fields, each made from the one below by one square root:

    Q ⊂ Q(√d₁) ⊂ Q(√d₁)(√d₂) ⊂ …,    x = a + b √d with a, b and d from below.

A root is adjoined only where it is not already there, so that the form is unique: a number is
zero if and only if its a and b are. A number that is not zero has a sign that enough digits show.
Rationals are ``fractions.Fraction``; the two mix freely.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import count
from math import gcd, isqrt, lcm, prod
from typing import Any

_FIRST_BITS = 64
_BITS_OF_A_TIE = 512  # where two numbers of different towers agree so far, algebra decides
_SMALL_FACTORS = 1000
MOST_ROOTS = 8  # a number of the tower has up to 2**8 terms then
MOST_NESTED = 4  # each root within a root makes the numerators three times as long

Exact = Any  # Fraction | Surd


class TooManyRootsError(ArithmeticError):
    """A number needs more independent square roots than are worth computing with."""


class Root:
    """√square over the field of the roots ``below``; ``new`` if it is known not to lie in it."""

    __slots__ = ("_bits", "_bounds", "below", "depth", "new", "square")

    def __init__(self, square: Exact, below: tuple[Root, ...], *, new: bool) -> None:
        self.square = square
        self.below = below
        self.new = new
        self.depth: int = 1 + max(
            (root.depth for _, roots in terms(square) for root in roots), default=0
        )
        self._bits = 0
        self._bounds = (0, 0)

    def bounds(self, bits: int) -> tuple[int, int]:
        """Whole numbers below and above √square × 2**bits."""
        if bits != self._bits:
            low, high = bounds(self.square, bits)
            self._bounds = isqrt(max(low, 0) << bits), isqrt(high << bits) + 1
            self._bits = bits
        return self._bounds


class Surd:
    """plain + times × √square; ``times`` is not zero."""

    __slots__ = ("plain", "root", "times")
    __hash__ = None  # type: ignore[assignment]

    def __init__(self, plain: Exact, times: Exact, root: Root) -> None:
        self.plain = plain
        self.times = times
        self.root = root

    # -- arithmetic ---------------------------------------------------------------------------

    def __add__(self, other: Exact) -> Exact:
        if not isinstance(other, Surd):
            return Surd(self.plain + other, self.times, self.root)
        if self.root is other.root:
            return _surd(self.plain + other.plain, self.times + other.times, self.root)
        if len(self.root.below) < len(other.root.below):
            return Surd(self + other.plain, other.times, other.root)
        return Surd(self.plain + other, self.times, self.root)

    def __mul__(self, other: Exact) -> Exact:
        if not isinstance(other, Surd):
            return Surd(self.plain * other, self.times * other, self.root) if other else Fraction(0)
        if self.root is other.root:
            return _surd(
                self.plain * other.plain + self.times * other.times * self.root.square,
                self.plain * other.times + self.times * other.plain,
                self.root,
            )
        if len(self.root.below) < len(other.root.below):
            return Surd(self * other.plain, self * other.times, other.root)
        return Surd(self.plain * other, self.times * other, self.root)

    def __neg__(self) -> Surd:
        return Surd(-self.plain, -self.times, self.root)

    def __sub__(self, other: Exact) -> Exact:
        return self + -other

    def __rsub__(self, other: Exact) -> Exact:
        return -self + other

    def __truediv__(self, other: Exact) -> Exact:
        return self * (other.inverse() if isinstance(other, Surd) else Fraction(1) / other)

    def __rtruediv__(self, other: Exact) -> Exact:
        return self.inverse() * other

    __radd__ = __add__
    __rmul__ = __mul__

    def inverse(self) -> Exact:
        """1 / self, by the conjugate plain − times √square."""
        norm = self.norm()
        inverse = norm.inverse() if isinstance(norm, Surd) else 1 / norm
        return Surd(self.plain * inverse, -self.times * inverse, self.root)

    def norm(self) -> Exact:
        """The product of this number and its conjugate, in the field below."""
        return self.plain * self.plain - self.times * self.times * self.root.square

    # -- order --------------------------------------------------------------------------------

    def __bool__(self) -> bool:
        return True  # zero is a Fraction

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Surd | Fraction | int) and compare(self, other) == 0

    def __lt__(self, other: Exact) -> bool:
        return compare(self, other) < 0

    def __le__(self, other: Exact) -> bool:
        return compare(self, other) <= 0

    def __gt__(self, other: Exact) -> bool:
        return compare(self, other) > 0

    def __ge__(self, other: Exact) -> bool:
        return compare(self, other) >= 0

    def __abs__(self) -> Surd:
        return -self if self < 0 else self

    def __float__(self) -> float:
        for bits in _more_bits():
            low, high = bounds(self, bits)
            if (high - low) << 60 < abs(low):
                return float(Fraction(low + high, 2 << bits))
        raise AssertionError  # pragma: no cover - the bits do not end

    def __repr__(self) -> str:
        return f"({self.plain} + {self.times}*sqrt({self.root.square}))"


def _surd(plain: Exact, times: Exact, root: Root) -> Exact:
    return Surd(plain, times, root) if times else plain


def bounds(x: Exact, bits: int) -> tuple[int, int]:
    """Whole numbers below and above x × 2**bits."""
    if not isinstance(x, Surd):
        low, rest = divmod(x.numerator << bits, x.denominator)
        return low, low + bool(rest)
    low, high = bounds(x.plain, bits)
    factor, root = bounds(x.times, bits), x.root.bounds(bits)
    products = [a * b for a in factor for b in root]
    return low + (min(products) >> bits), high - (-max(products) >> bits)


def compare(x: Exact, y: Exact) -> int:
    """−1, 0 or 1, as x is below, equal to or above y: they may be of different towers."""
    if _one_tower(x, y):
        difference = x - y
        return _sign(difference) if difference else 0
    for bits in _more_bits():
        (x_low, x_high), (y_low, y_high) = bounds(x, bits), bounds(y, bits)
        if x_high < y_low:
            return -1
        if y_high < x_low:
            return 1
        if bits >= _BITS_OF_A_TIE:
            tower = Tower(next(value.root.below for value in (x, y) if isinstance(value, Surd)))
            return compare(tower.lifted(x), tower.lifted(y))
    raise AssertionError  # pragma: no cover - the bits do not end


def _one_tower(x: Exact, y: Exact) -> bool:
    """Whether both are in unique form over roots of one tower."""
    roots = sorted(
        (value.root for value in (x, y) if isinstance(value, Surd)),
        key=lambda root: len(root.below),
    )
    return all(root.new for root in roots) and (
        len(roots) < 2 or roots[0] is roots[1] or roots[0] in roots[1].below
    )


def _sign(x: Exact) -> int:
    """The sign of a number that is not zero."""
    if not isinstance(x, Surd):
        return 1 if x > 0 else -1
    for bits in _more_bits():
        low, high = bounds(x, bits)
        if low > 0:
            return 1
        if high < 0:
            return -1
    raise AssertionError  # pragma: no cover - the bits do not end


def _more_bits() -> Iterator[int]:
    return (_FIRST_BITS << doubled for doubled in count())


# --- towers ------------------------------------------------------------------------------------


class Tower:
    """The roots adjoined so far, each to the field of those before it."""

    def __init__(self, roots: tuple[Root, ...] = ()) -> None:
        self.roots = roots

    def sqrt(self, x: Exact) -> Exact:
        """√x, adjoined to the tower where it does not lie in it. Raises ArithmeticError below 0."""
        if x < 0:
            raise ArithmeticError("square root of a negative number")
        within = _root_within(x, self.roots)
        if within is not None:
            return abs(within)
        outside, inside = _square_out(x)
        root = Root(inside, self.roots, new=True)
        if len(root.below) >= MOST_ROOTS:
            raise TooManyRootsError(f"more than {MOST_ROOTS} independent square roots")
        if root.depth > MOST_NESTED:
            raise TooManyRootsError(f"square roots nested deeper than {MOST_NESTED}")
        self.roots += (root,)
        return Surd(Fraction(0), outside, root)

    def tentative_sqrt(self, x: Exact) -> Exact:
        """√x for a number that is only to be compared: nothing is adjoined or looked for."""
        if not x:
            return x
        return Surd(Fraction(0), Fraction(1), Root(x, self.roots, new=False))

    def lifted(self, x: Exact) -> Exact:
        """A number in unique form over the roots of this tower, with new ones where it needs."""
        if not isinstance(x, Surd) or x.root in self.roots:
            return x
        root = self.sqrt(self.lifted(x.root.square))
        return self.lifted(x.plain) + self.lifted(x.times) * root


def _root_within(x: Exact, roots: tuple[Root, ...]) -> Exact | None:
    """A root of x in the field of these roots, of either sign, or None if there is none.

    With s = √d on top and x = a + b s: (p + q s)² = x means p² + q² d = a and 2 p q = b. Then
    a² − b² d = (p² − q² d)² is a square n² below, and p² = (a ± n)/2; where b = 0, a or a/d is
    a square below.
    """
    if x < 0:
        return None
    if not roots:
        above, below = isqrt(x.numerator), isqrt(x.denominator)
        whole = above * above == x.numerator and below * below == x.denominator
        return Fraction(above, below) if whole else None
    lower, top = roots[:-1], roots[-1]
    if not (isinstance(x, Surd) and x.root is top):
        root = _root_within(x, lower)
        if root is not None:
            return root
        root = _root_within(x / top.square, lower)
        return None if root is None else _surd(Fraction(0), root, top)
    n = _root_within(x.norm(), lower)
    if n is None:
        return None
    for square in ((x.plain + n) / 2, (x.plain - n) / 2):
        p = _root_within(square, lower)
        if p:
            return Surd(p, x.times / (2 * p), top)
    return None


def _square_out(x: Exact) -> tuple[Fraction, Exact]:
    """X as outside² × inside, with small whole numbers inside."""
    numbers = [number for number, _ in terms(x)]
    content = Fraction(
        gcd(*(number.numerator for number in numbers)),
        lcm(*(number.denominator for number in numbers)),
    )
    outside, left = Fraction(1, content.denominator), content.numerator * content.denominator
    for factor in range(2, _SMALL_FACTORS):
        while left % (factor * factor) == 0:
            left //= factor * factor
            outside *= factor
    return outside, x / (outside * outside)


# --- other numbers -----------------------------------------------------------------------------


def terms(x: Exact) -> list[tuple[Fraction, tuple[Root, ...]]]:
    """X as a sum of rationals times products of different roots."""
    if not isinstance(x, Surd):
        return [(Fraction(x), ())] if x else []
    return terms(x.plain) + [(number, (*roots, x.root)) for number, roots in terms(x.times)]


def translated(x: Exact, number: Callable[[Fraction], Any], sqrt: Callable[[Any], Any]) -> Any:
    """X in another arithmetic, given what makes a number and a root there."""
    return sum(
        (
            number(factor) * prod(sqrt(translated(root.square, number, sqrt)) for root in roots)
            for factor, roots in terms(x)
        ),
        start=number(Fraction(0)),
    )
