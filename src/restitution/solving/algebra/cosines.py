"""Numbers made of sines and cosines of angles in degrees, with their products multiplied out.

sin 70° is cos 20°, and sin 20° cos 20° is half of sin 40°: by itself neither is seen, and equations
with such coefficients grow without end. As sums of roots of unity they are short, and none is zero
in disguise.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from fractions import Fraction

import sympy as sp

from restitution.exact.degrees import cosine_beside, turns_of
from restitution.solving.algebra.polynomials import TooLargeError, afford, coefficients, terms_in
from restitution.solving.algebra.resultants import resultant
from restitution.work import remembered

MOST_BASIS = 24
"""Fields of more dimensions than this are not reduced in: their sums would be the longer ones."""
_MOST_CONJUGATES = 60
# √2 = 2 cos 45°, √3 = 2 cos 30°, √5 = 4 cos 36° − 1, beside the q of the angles π/q.
_SURDS = {2: 4, 3: 6, 5: 5}

_Sum = dict[int, Fraction]  # of powers of a root of unity
_NOTHING = Fraction(0)


def has_cosines(x: sp.Expr) -> bool:
    """Whether a sine or cosine of a number of degrees stands in an expression."""
    return any(_turn(atom) is not None for atom in x.atoms(sp.sin, sp.cos))


@remembered(512)
def gathered(x: sp.Expr) -> sp.Expr:
    """A polynomial whose coefficients are sums of cosines in place of products of them.

    What is no polynomial in its letters comes back as it is; so does what would not be shorter.
    """
    if not has_cosines(x):
        return x
    letters = sorted(x.free_symbols, key=lambda s: s.name)
    try:
        terms = terms_in(x, letters) if letters else {(): sp.expand(x)}
    except (sp.PolynomialError, TooLargeError):
        return x
    total = sp.Add(
        *[
            _shorter(c) * sp.Mul(*[g**p for g, p in zip(letters, m, strict=True)])
            for m, c in terms.items()
        ]
    )
    return total if sp.count_ops(total) < sp.count_ops(x) else x


def without_cosines(x: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """A multiple of a polynomial in one letter in which only surds are left beside rationals.

    It is the product of what the polynomial becomes where the angle of which all others are
    multiples is any other with the same cosines. None where that would be too large, or where a
    coefficient is no sum of products of cosines and surds.
    """
    parts = coefficients(x, symbol)
    circle = _Circle(2 * _half_turns(parts))
    size = int(sp.totient(circle.order)) // 2
    if size > MOST_BASIS or size * (len(parts) - 1) > _MOST_CONJUGATES:
        return None
    cosine = sp.Dummy("c")
    try:
        split = [circle.split(part) for part in parts]
    except _OtherError:
        return None
    whole = sp.Integer(0)
    for power, by_surds in zip(range(len(parts) - 1, -1, -1), split, strict=True):
        for surds, total in by_surds.items():
            folded = [(c, min(k % circle.order, -k % circle.order)) for k, c in total.items()]
            own = [
                sp.Rational(c.numerator, c.denominator) * sp.chebyshevt(k, cosine)
                for c, k in folded
            ]
            whole += surds * sp.Add(*own) * symbol**power
    least = _of_cosine(circle.order, cosine)
    reduced = sp.Poly(sp.expand(whole), cosine).rem(least)
    return resultant(least.as_expr(), reduced.as_expr(), cosine)


def _half_turns(numbers: Iterable[sp.Expr]) -> int:
    """The least n for which π/n measures all angles, and those by which surds are cosines."""
    atoms = [sine for x in numbers for sine in x.atoms(sp.sin, sp.cos)]
    turns = [_turn(atom) for atom in atoms]
    roots = {p.base for x in numbers for p in x.atoms(sp.Pow) if p.exp.is_Rational}
    known = [q for p, q in _SURDS.items() if any(r.is_Integer and r % p == 0 for r in roots)]
    return math.lcm(2, *known, *[turn.denominator for turn in turns if turn is not None])


def _of_cosine(order: int, cosine: sp.Symbol) -> sp.Poly:
    """The polynomial of least degree of which the cosine of 2π over a whole number is a root."""
    parts = _cyclotomic(order)
    middle = len(parts) // 2
    terms = [2 * parts[middle + k] * sp.chebyshevt(k, cosine) for k in range(1, middle + 1)]
    return sp.Poly(sp.expand(parts[middle] + sp.Add(*terms)), cosine)


def _turn(x: sp.Expr) -> Fraction | None:
    """The angle of a sine or cosine as a share of π, if it is a rational one."""
    return turns_of(x.args[0])


def _shorter(number: sp.Expr) -> sp.Expr:
    if not has_cosines(number):
        return number
    circle = _Circle(2 * _half_turns([number]))
    try:
        # Surds of other numbers stay factors of their own.
        parts = circle.split(number)
    except _OtherError:
        return number
    return sp.Add(*[rest * circle.shortest(total) for rest, total in parts.items()])


class _OtherError(Exception):
    """An expression is no sum of products of cosines and surds."""


class _Circle:
    """Sums of the powers of a root of unity of this order, modulo what makes two of them equal."""

    def __init__(self, order: int) -> None:
        self.order = order

    def split(self, x: sp.Expr) -> dict[sp.Expr, _Sum]:
        """A sum of cosines beside each surd that is none."""
        total: dict[sp.Expr, _Sum] = {}
        for term in sp.Add.make_args(sp.expand(x)):
            rest: sp.Expr = sp.Integer(1)
            own: _Sum = {0: Fraction(1)}
            for factor in sp.Mul.make_args(term):
                base, power = factor.as_base_exp()
                if factor.is_Rational:
                    own = {k: c * Fraction(int(factor.p), int(factor.q)) for k, c in own.items()}
                elif isinstance(base, sp.sin | sp.cos) and power.is_Integer and power > 0:
                    for _ in range(int(power)):
                        own = self.product(own, self.cosine(base))
                elif base.is_Integer and base > 0 and power == sp.S.Half:
                    for prime in sp.primefactors(int(base)):
                        root = self.surd(prime)
                        own = own if root is None else self.product(own, root)
                        rest = rest * sp.sqrt(prime) if root is None else rest
                else:
                    raise _OtherError
            sum_ = total.setdefault(rest, {})
            for k, c in own.items():
                sum_[k] = sum_.get(k, Fraction(0)) + c
        return total

    def product(self, a: _Sum, b: _Sum) -> _Sum:
        afford(len(a) * len(b))
        total: _Sum = {}
        for k, c in a.items():
            for n, d in b.items():
                at = (k + n) % self.order
                total[at] = total.get(at, Fraction(0)) + c * d
        return {k: c for k, c in total.items() if c}

    def at(self, turn: Fraction) -> _Sum:
        """The cosine of a share of π."""
        k = turn * self.order / 2
        if k.denominator != 1:
            raise _OtherError
        both = [int(k) % self.order, -int(k) % self.order]
        total: _Sum = {}
        for number in both:
            total[number] = total.get(number, Fraction(0)) + Fraction(1, 2)
        return total

    def cosine(self, x: sp.Expr) -> _Sum:
        turn = _turn(x)
        if turn is None:
            raise _OtherError
        return self.at(turn if isinstance(x, sp.cos) else Fraction(1, 2) - turn)

    def surd(self, prime: int) -> _Sum | None:
        q = _SURDS.get(prime)
        if q is None or self.order % (2 * q):
            return None
        if prime == 5:
            total = {k: 4 * c for k, c in self.at(Fraction(1, 5)).items()}
            return {**total, 0: total.get(0, Fraction(0)) - 1}
        return {k: 2 * c for k, c in self.at(Fraction(1, q)).items()}

    def shortest(self, total: _Sum) -> sp.Expr:
        """A real sum as one of cosines: as it stands, or by those that are independent."""
        plain = self._folded(total.items())
        size = int(sp.totient(self.order)) // 2
        if size > MOST_BASIS:
            return self._expression(plain)
        independent = self._reduced(total, size)
        return self._expression(min(independent, plain, key=len) if independent else {})

    def _folded(self, terms: Iterable[tuple[int, Fraction]]) -> _Sum:
        """The sum in cosines of at most a right angle."""
        folded: _Sum = {}
        for k, c in terms:
            k = min(k % self.order, -k % self.order)
            if 4 * k > self.order:
                k, c = self.order // 2 - k, -c
            folded[k] = folded.get(k, Fraction(0)) + c
        return {k: c for k, c in folded.items() if c and 4 * k != self.order}

    def _reduced(self, total: _Sum, size: int) -> _Sum:
        """The sum in cosines of the first multiples of the least angle, which are independent."""
        modulus = _cyclotomic(self.order)
        left = [_NOTHING] * self.order
        for k, c in total.items():
            left[(k + size - 1) % self.order] += c
        afford(self.order * len(modulus))
        top = len(modulus) - 1
        for n in range(self.order - 1, top - 1, -1):
            if left[n]:
                for m, part in enumerate(modulus[:top]):
                    left[n - top + m] -= left[n] * part
                left[n] = _NOTHING
        halves = left[size - 1 : 2 * size - 1]
        reduced = {k: c * (1 if k == 0 else 2) for k, c in enumerate(halves) if c}
        return self._folded(reduced.items())

    def _expression(self, total: _Sum) -> sp.Expr:
        turns = [Fraction(2 * k, self.order) for k in total]
        return sp.Add(
            *[
                sp.Rational(c.numerator, c.denominator)
                * cosine_beside(Fraction(2 * k, self.order), turns)
                for k, c in sorted(total.items())
            ]
        )


@remembered(64)
def _cyclotomic(order: int) -> tuple[int, ...]:
    """The coefficients of a cyclotomic polynomial, the constant one first."""
    x = sp.Symbol("x")
    return tuple(int(c) for c in reversed(sp.Poly(sp.cyclotomic_poly(order, x), x).all_coeffs()))
