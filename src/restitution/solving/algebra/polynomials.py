"""Polynomials over the rationals in plain letters, with what is known of roots as relations.

SymPy's expressions know what is assumed of their letters, and ask for it at every turn: a sign of
a coefficient may ask for the roots of a quartic. Here every letter, root and function of an
expression is a letter of a ring over ℚ and nothing more. √3 is a letter s with s² = 3; a root of a
root is a letter whose square is a polynomial in those before it. Radicands are split into coprime
numbers, none of them a square, so that surds of different numbers are independent, and a
polynomial in them is zero if and only if its normal form is.

Before a step is begun its size is estimated, and counted as work (``restitution.work``). Nothing
here looks at a clock, at random numbers or at assumptions.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from typing import Any

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.euclidtools import dup_invert
from sympy.polys.orderings import lex
from sympy.polys.polyerrors import NotInvertible, PolynomialError
from sympy.polys.rings import PolyRing

from restitution.errors import UnsupportedError
from restitution.exact.degrees import sine_beside
from restitution.exact.irreducible import factor_list
from restitution.records import dataclass
from restitution.work import remembered, spend

Element = Any
"""A polynomial of a ring: SymPy's PolyElement, a dictionary of monomials."""

WORD = 64
LARGEST = 3_000_000
"""Operations that one step may be estimated to take."""
TOO_HARD = "the equations of this question are too hard to solve exactly"


class TooLargeError(UnsupportedError):
    """A single step that would be too large, whatever else was done."""


def afford(operations: float) -> None:
    """Count a step before it is begun. Raises TooLargeError, or the error of a limit of work."""
    if operations > LARGEST:
        raise TooLargeError(TOO_HARD)
    spend(1 + int(operations))


# --- rings ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Relation:
    """``letter ** power`` is ``value``: a polynomial in letters that come earlier as relations."""

    index: int
    power: int
    value: Element


class Field:
    """The ring for some expressions, and the way into it and back.

    ``atoms`` are the expressions for which its letters stand; ``first`` come first. ``relations``
    are used throughout; ``circles`` (cos² = 1 − sin²) only where zero is asked for. ``exact`` tells
    that then a polynomial is zero only where its normal form is.
    """

    def __init__(self, expressions: Iterable[sp.Expr], first: Sequence[sp.Expr] = ()) -> None:
        kinds = _Atoms()
        for expression in (*first, *expressions):
            kinds.visit(expression)
        self.surds = _coprime(kinds.radicands)
        surds = {sp.Pow(n, sp.S.Half, evaluate=False): n for n in self.surds}
        others = (kinds.plain | kinds.roots | set(surds)) - set(first)
        self.atoms: tuple[sp.Expr, ...] = (*first, *sorted(others, key=_by_name))
        self.ring = PolyRing([f"x{n}" for n in range(len(self.atoms))], QQ, lex)
        self._gens = dict(zip(self.atoms, self.ring.gens, strict=True))
        self._surds = {n: self._gens[root] for root, n in surds.items()}
        self.relations: list[Relation] = [
            Relation(self.atoms.index(root), 2, self.ring.ground_new(QQ(n)))
            for root, n in surds.items()
        ]
        self.circles: list[Relation] = []
        self.exact = not kinds.roots and all(map(_independent, (*first, *kinds.plain)))
        unnamed = [x for x in self.atoms if isinstance(x, sp.CRootOf)]
        for x in unnamed:
            self.relations.insert(0, self._of_polynomial(x))
            # Of two of them one may be a polynomial in the other.
            self.exact = self.exact and len(unnamed) == 1 and not surds
        for x in self.atoms:
            partner = sine_beside(x)
            if partner in self._gens:
                square = 1 - self._gens[partner] ** 2
                self.circles.append(Relation(self.atoms.index(x), 2, square))
        for root in sorted(kinds.roots, key=lambda x: (sp.count_ops(x), sp.default_sort_key(x))):
            above, below = self.fraction(root.base)
            inverse = self.inverse(below)
            if inverse is not None:
                value = self.times(above, inverse)
                self.relations.append(Relation(self.atoms.index(root), int(root.exp.q), value))

    def _of_polynomial(self, x: sp.CRootOf) -> Relation:
        """The highest power of a root without a formula, by those below it."""
        index, parts = self.atoms.index(x), x.poly.all_coeffs()
        letter, top = self.ring.gens[index], len(parts) - 1
        value = self.ring.zero
        for power, c in enumerate(reversed(parts[1:])):
            value = value - letter**power * QQ(int(c), int(parts[0]))
        return Relation(index, top, value)

    # --- into the ring -----------------------------------------------------------------------

    def fraction(self, x: sp.Expr) -> tuple[Element, Element]:
        """An expression as a quotient of polynomials, in normal form, not reduced."""
        ring = self.ring
        if x.is_Rational:
            return ring.ground_new(QQ(x.p, x.q)), ring.one
        known = self._gens.get(x)
        if known is not None:
            return known, ring.one
        if x.is_Add:
            return self._sum([self.fraction(argument) for argument in x.args])
        if x.is_Mul:
            above = below = ring.one
            for argument in x.args:
                a, b = self.fraction(argument)
                above, below = self.times(above, a), self.times(below, b)
            return above, below
        if x.is_Pow and x.exp.is_Rational:
            above, below = self.fraction(x.base) if x.exp.is_Integer else self._root(x)
            power = int(x.exp.p)
            if power < 0:
                above, below = below, above
                if below == 0:
                    raise PolynomialError("division by zero")
            return self.power(above, abs(power)), self.power(below, abs(power))
        raise PolynomialError(f"{x} is not of this ring")

    def _root(self, x: sp.Expr) -> tuple[Element, Element]:
        """The root of which a power stands: as a letter, or a product of surds."""
        if x.base.is_Integer and x.base > 0 and x.exp.q == 2:
            left, value = int(x.base), self.ring.one
            for n, letter in self._surds.items():
                while left % n == 0:
                    left, value = left // n, self.times(value, letter)
            size = math.isqrt(left)
            assert size * size == left
            return value.mul_ground(QQ(size)), self.ring.one
        return self._gens[sp.Pow(x.base, sp.Rational(1, x.exp.q))], self.ring.one

    def _sum(self, parts: Sequence[tuple[Element, Element]]) -> tuple[Element, Element]:
        above: dict[Element, Element] = {}
        for a, b in parts:
            above[b] = above[b] + a if b in above else a
        (below, total), *others = above.items()
        for b, a in others:
            size = self.common_size(b, below)
            if b.is_ground or below.is_ground or size > LARGEST:
                common, x, y = self.ring.one, b, below
            else:
                afford(size)
                common, x, y = b.cofactors(below)
            total = self.times(total, x) + self.times(a, y)
            below = self.times(self.times(common, x), y)
        return total, below

    def common_size(self, a: Element, b: Element) -> int:
        """An estimate of the operations of finding what two polynomials have in common."""
        degrees = zip(a.degrees(), b.degrees(), strict=True)
        return int(len(a) * len(b) * (1 + sum(max(0, min(p, q)) for p, q in degrees)))

    # --- calculating -------------------------------------------------------------------------

    def times(self, a: Element, b: Element) -> Element:
        """A product in normal form."""
        if a == 1:
            return b
        if b == 1:
            return a
        afford(len(a) * len(b) * (1 + (bits(a) + bits(b)) / (4 * WORD)))
        return self.normal(a * b)

    def power(self, a: Element, n: int) -> Element:
        """A power in normal form."""
        if len(a) == 1:
            afford(n)
            return self.normal(a**n)
        result = self.ring.one
        for _ in range(n):
            result = self.times(result, a)
        return result

    def normal(self, a: Element) -> Element:
        """A polynomial with every relation used as far as it goes."""
        for relation in reversed(self.relations):
            a = self.using(relation, a)
        return a

    def using(self, relation: Relation, a: Element) -> Element:
        """A polynomial with one relation used as far as it goes."""
        index, power = relation.index, relation.power
        if not any(m[index] >= power for m in a):
            return a
        parts: dict[int, Element] = {}
        for monomial, coefficient in a.items():
            times, left = divmod(monomial[index], power)
            part = parts.setdefault(times, self.ring.zero)
            own = (*monomial[:index], left, *monomial[index + 1 :])
            part[own] = coefficient
        total = parts.pop(0, self.ring.zero)
        for times, part in sorted(parts.items()):
            value = relation.value if times == 1 else self.power(relation.value, times)
            afford(len(part) * len(value))
            total = total + part * value
        return self.using(relation, total)

    def conjugate(self, a: Element, index: int) -> Element:
        """A polynomial with the letter of a square root replaced by its negative."""
        turned = self.ring.zero
        for monomial, coefficient in a.items():
            turned[monomial] = -coefficient if monomial[index] % 2 else coefficient
        return turned

    def free_of_roots(self, a: Element) -> Element:
        """The product of a polynomial with its conjugates: no letter of a square root is left."""
        for relation in reversed(self.relations):
            if not any(m[relation.index] for m in a):
                continue
            if relation.power != 2:
                raise UnsupportedError("an equation whose coefficients hold roots of higher order")
            a = self.times(a, self.conjugate(a, relation.index))
        return a

    def inverse(self, a: Element) -> Element | None:
        """1/a for a number of the field; None for a divisor of zero, and for what holds letters."""
        if a.is_ground:
            return None if a == 0 else self.ring.ground_new(1 / QQ.convert(a.LC))
        multiple = self.ring.one
        for relation in reversed(self.relations):
            if any(m[relation.index] for m in a):
                if isinstance(self.atoms[relation.index], sp.CRootOf):
                    own = self._inverse_in_one(a, relation)
                    return None if own is None else self.times(multiple, own)
                if relation.power != 2:
                    return None
                turned = self.conjugate(a, relation.index)
                a, multiple = self.times(a, turned), self.times(multiple, turned)
        if not a.is_ground or a == 0:
            return None
        return multiple.mul_ground(1 / QQ.convert(a.LC))

    def _inverse_in_one(self, a: Element, relation: Relation) -> Element | None:
        """1/a for a polynomial in one root without a formula alone."""
        index = relation.index
        if any(power for m in a for n, power in enumerate(m) if n != index):
            return None
        modulus = self.ring.gens[index] ** relation.power - relation.value
        dense = []
        for value in (a, modulus):
            parts = [QQ(0)] * (1 + max(m[index] for m in value))
            for m, c in value.items():
                parts[-1 - m[index]] = c
            dense.append(parts)
        afford(relation.power**3 * (1 + (bits(a) + bits(modulus)) / WORD))
        try:
            inverted = dup_invert(*dense, QQ)
        except NotInvertible:
            return None
        inverse = self.ring.zero
        for power, c in enumerate(reversed(inverted)):
            inverse = inverse + self.ring.gens[index] ** power * c
        return inverse

    # --- and back ----------------------------------------------------------------------------

    def expression(self, a: Element) -> sp.Expr:
        """A polynomial in the letters of whoever asked, multiplied out."""
        spend(len(a))
        terms = []
        for monomial, c in a.terms():
            factors = [x**n for x, n in zip(self.atoms, monomial, strict=True) if n]
            number = sp.Rational(int(c.numerator), int(c.denominator))
            terms.append(sp.Mul(number, *factors))
        return sp.Add(*terms)


def bits(a: Element) -> int:
    """The size of the largest coefficient."""
    return max(
        (int(c.numerator).bit_length() + int(c.denominator).bit_length() for c in a.values()),
        default=0,
    )


_RANKS = {name: rank for rank, name in enumerate("xyzpqrstuvwabcdefghijklmno")}


def _independent(x: sp.Expr) -> bool:
    """Whether a letter of the ring may be anything, but for what its relations say of it."""
    if isinstance(x, sp.CRootOf):
        return True
    return bool(x.is_Symbol or (x.func in (sp.sin, sp.cos) and x.args[0].is_Symbol))


def _by_name(x: sp.Expr) -> tuple[int, str, int]:
    """The order of letters that SymPy chooses too: by it factors are ordered, and their signs."""
    name, number = re.fullmatch(r"(.*?)(\d*)", str(x), re.DOTALL).groups()  # type: ignore[union-attr]
    return _RANKS.get(name, len(_RANKS)), name, int(number or 0)


class _Atoms:
    """What the letters of a ring have to stand for."""

    def __init__(self) -> None:
        self.plain: set[sp.Expr] = set()
        self.roots: set[sp.Expr] = set()
        self.radicands: set[int] = set()
        self._seen: set[sp.Expr] = set()

    def visit(self, x: sp.Expr) -> None:
        if x in self._seen or x.is_Rational:
            return
        self._seen.add(x)
        if x.is_Add or x.is_Mul:
            for argument in x.args:
                self.visit(argument)
        elif x.is_Pow and x.exp.is_Integer:
            self.visit(x.base)
        elif x.is_Pow and x.exp.is_Rational:
            if x.base.is_Integer and x.base > 0 and x.exp.q == 2:
                self.radicands.add(int(x.base))
            else:
                self.visit(x.base)
                root = sp.Pow(x.base, sp.Rational(1, x.exp.q))
                if not root.is_Pow:
                    raise PolynomialError(f"{x} can be taken")
                self.roots.add(root)
        elif x.has(sp.nan, sp.zoo, sp.oo, sp.S.NegativeInfinity, sp.I) or not isinstance(
            x, sp.Expr
        ):
            raise PolynomialError(f"{x} is no real number")
        else:
            self.plain.add(x)


def _coprime(numbers: Iterable[int]) -> tuple[int, ...]:
    """Coprime numbers, none of them a square, of which all of these are products with squares."""
    pending = sorted(numbers)
    base: set[int] = set()
    while pending:
        n = pending.pop()
        size = math.isqrt(n)
        if n == 1:
            continue
        if size * size == n:
            pending.append(size)
            continue
        other = next((m for m in sorted(base) if math.gcd(m, n) > 1), None)
        if other is None:
            base.add(n)
        elif other != n:
            common = math.gcd(n, other)
            base.remove(other)
            pending += [n // common, other // common, common]
    return tuple(sorted(base))


# --- questions about expressions --------------------------------------------------------------


@remembered(2048)
def numerator(x: sp.Expr) -> sp.Expr:
    """The numerator of an expression as one fraction, multiplied out."""
    x = _opened(x)
    field = Field([x])
    above, below = field.fraction(x)
    size = field.common_size(above, below)
    if not below.is_ground and size < LARGEST:
        afford(size)
        above, _ = above.cancel(below)
    return field.expression(without_denominators(above))


def _opened(x: sp.Expr) -> sp.Expr:
    """An expression with its radicands multiplied out, so that equal roots look the same."""
    if x.is_Atom or not x.has(sp.Pow, sp.Abs):
        return x
    arguments = [_opened(argument) for argument in x.args]
    if isinstance(x, sp.Abs) or (x.is_Pow and x.exp.is_Rational and not x.exp.is_Integer):
        if arguments[0].is_Add or arguments[0].is_Mul:
            field = Field([arguments[0]])
            above, below = map(field.expression, field.fraction(arguments[0]))
            arguments[0] = above / below
    elif not (x.is_Add or x.is_Mul or x.is_Pow):
        return x
    return x.func(*arguments) if tuple(arguments) != x.args else x


def without_denominators(a: Element) -> Element:
    """A polynomial without denominators in its coefficients."""
    return a.clear_denoms()[1]


@remembered(2048)
def reduced(x: sp.Expr) -> sp.Expr:
    """A quotient of two polynomials that have nothing in common, as SymPy's ``cancel`` has it."""
    field = Field([x])
    above, below = field.fraction(x)
    if below == 0:
        raise PolynomialError("division by zero")
    afford(field.common_size(above, below))
    above, below = above.cancel(below)
    return field.expression(above) / field.expression(below)


def without_cos_squared(x: sp.Expr, angle: sp.Expr) -> sp.Expr:
    """A polynomial with cos² = 1 − sin² of one angle used throughout."""
    cosine = sp.cos(angle)
    field = Field([x, cosine, sp.sin(angle)])
    if any(atom != cosine and atom.has(cosine) for atom in field.atoms):
        raise PolynomialError(f"{x} is no polynomial in {cosine}")
    above, below = field.fraction(x)
    if not below.is_ground:
        raise PolynomialError(f"{x} is no polynomial")
    for circle in field.circles:
        if field.atoms[circle.index] == cosine:
            above = field.using(circle, above)
    return field.expression(above.mul_ground(1 / QQ.convert(below.LC)))


@remembered(4096)
def coefficients(x: sp.Expr, symbol: sp.Symbol) -> tuple[sp.Expr, ...]:
    """The coefficients of a polynomial in one letter, highest power first; () for zero.

    Raises PolynomialError for what is no polynomial in it.
    """
    field = Field([x], [symbol])
    return tuple(map(field.expression, field_coefficients(field, x, symbol)))


def field_coefficients(field: Field, x: sp.Expr, symbol: sp.Symbol) -> list[Element]:
    """The coefficients in the ring of a field, of which ``symbol`` is the first letter."""
    if any(atom.has(symbol) for atom in field.atoms[1:]):
        raise PolynomialError(f"{x} is no polynomial in {symbol}")
    above, below = field.fraction(x)
    if any(m[0] for m in below):
        raise PolynomialError(f"{x} is no polynomial in {symbol}")
    if not below.is_ground:
        inverse = field.inverse(below)
        if inverse is None:
            raise PolynomialError(f"{x} is no polynomial over the rationals")
        above = field.times(above, inverse)
    else:
        above = above.mul_ground(1 / QQ.convert(below.LC))
    return by_powers(above)


def by_powers(a: Element) -> list[Element]:
    """The coefficients of the powers of the first letter, from the highest."""
    parts: dict[int, Element] = {}
    for monomial, c in a.items():
        part = parts.setdefault(monomial[0], a.ring.zero)
        part[(0, *monomial[1:])] = c
    return [parts.get(n, a.ring.zero) for n in range(max(parts, default=-1), -1, -1)]


def terms_in(x: sp.Expr, symbols: Sequence[sp.Symbol]) -> dict[tuple[int, ...], sp.Expr]:
    """The coefficients of a polynomial in some letters, by their powers.

    Raises PolynomialError for what is no polynomial in them.
    """
    field = Field([x], symbols)
    count = len(symbols)
    above, below = field.fraction(x)
    if not below.is_ground or any(atom.has(*symbols) for atom in field.atoms[count:]):
        raise PolynomialError(f"{x} is no polynomial in {', '.join(map(str, symbols))}")
    parts: dict[tuple[int, ...], Element] = {}
    for monomial, c in above.mul_ground(1 / QQ.convert(below.LC)).items():
        rest = (*([0] * count), *monomial[count:])
        parts.setdefault(monomial[:count], field.ring.zero)[rest] = c
    return {powers: field.expression(part) for powers, part in parts.items()}


def degree(x: sp.Expr, symbol: sp.Symbol) -> int:
    """The degree of a polynomial in one letter, 0 for a constant."""
    return max(len(coefficients(x, symbol)) - 1, 0)


def from_powers(parts: Sequence[Element]) -> Element:
    """The polynomial with these coefficients of the first letter, highest power first."""
    total = parts[0].ring.zero
    top = len(parts) - 1
    for n, part in enumerate(parts):
        for monomial, c in part.items():
            total[(top - n, *monomial[1:])] = c
    return total


@remembered(2048)
def factors(x: sp.Expr) -> tuple[sp.Expr, ...]:
    """The irreducible factors of a polynomial, each once and numbers left out.

    Surds count as letters here. In the order of SymPy's factor_list. Raises PolynomialError for
    what is no polynomial, and TooLargeError for what is too large.
    """
    factors_: dict[sp.Expr, Any] = {}
    for other in sp.Mul.make_args(x):
        base = other.base if other.is_Pow and other.exp.is_Integer and other.exp > 0 else other
        field = Field([base])
        above, below = field.fraction(base)
        if not below.is_ground:
            raise PolynomialError(f"{base} is no polynomial")
        if above.is_ground:
            continue
        for key, factor in _split(above):
            expression = field.expression(without_denominators(factor))
            if not expression.is_number:
                factors_.setdefault(expression, key)
    lone = sp.Mul(*[factor for factor in factors_ if not factor.is_Add]).args
    places = {value: place for place, value in enumerate(lone)}
    return tuple(
        sorted(factors_, key=lambda x: (factors_[x][:3], places.get(x, 0), factors_[x][3]))
    )


def split(a: Element) -> list[Element]:
    """The irreducible factors of a polynomial over the rationals, each once."""
    return [factor for _, factor in sorted(_split(a), key=lambda pair: pair[0])]


def _split(a: Element) -> list[tuple[Any, Element]]:
    """The factors, each with a key by which they are ordered."""
    afford(factoring(a))
    ring = a.ring
    common = [min(powers) for powers in zip(*a, strict=True)]
    parts: list[tuple[Any, Element]] = [
        ((2, 1, power, []), ring.gens[index]) for index, power in enumerate(common) if power
    ]
    used = [n for n, (low, top) in enumerate(zip(common, a.degrees(), strict=True)) if top > low]
    if used:
        own = PolyRing([f"x{n}" for n in used], QQ, lex)
        rest = own.from_dict({tuple(m[n] - common[n] for n in used): c for m, c in a.items()})
        for factor, power in factor_list(rest)[1]:
            dense = factor.to_dense()
            key = (len(dense), len(used), power, dense)
            parts.append((key, embedded(ring, factor, used)))
    return parts


def embedded(ring: PolyRing, a: Element, places: Sequence[int]) -> Element:
    """A polynomial of a ring in some of the letters, as one in all of them."""
    polynomial = ring.zero
    for monomial, c in a.items():
        own = [0] * ring.ngens
        for place, power in zip(places, monomial, strict=True):
            own[place] = power
        polynomial[tuple(own)] = c
    return polynomial


def factoring(a: Element) -> float:
    """An estimate of the operations of a factorisation over the rationals."""
    common = [min(powers) for powers in zip(*a, strict=True)]
    degrees = [d - low for d, low in zip(a.degrees(), common, strict=True) if d > low]
    if not degrees or len(a) < 2:
        return 1
    size = min(math.prod(d + 1 for d in degrees), 50 * len(a) ** 2)
    if len(degrees) == 1:
        size = max(degrees) ** 2  # of one letter only, the coefficients modulo many primes
    return float(size * (1 + max(degrees)) * (1 + bits(a) / WORD) * len(degrees))
