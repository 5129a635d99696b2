"""Expressions as quotients of polynomials over ℚ.

Whatever is no rational function of the letters becomes a generator of its own, with what is known
of it beside it as relations and bounds:

- a root r of x: r ≥ 0 and r² = x (roots of whole numbers are those of their primes);
- an angle α: c and s, the cosine and sine of α/q, with c² + s² = 1 and what α may be as signs of
  sines; every sine, cosine and tangent of a sum of whole multiples of α/q is a polynomial in them;
- |x|, and the greatest or least of several;
- the cosine and sine of a plain number such as 37°, and anything else, held between rational
  bounds. Such a translation is *loose*: what is proved of it holds, what refutes it may not.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from fractions import Fraction
from functools import cache, lru_cache
from typing import Any, Literal

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement, PolyRing

from restitution.exact.degrees import cosine, function_of
from restitution.exact.irreducible import factor_list
from restitution.oracle.algebraic import (
    INVERSE,
    TRIGONOMETRIC,
    algebraic,
    domain_number,
    end_above,
    end_below,
    radicands,
    rational_or_none,
    role_of,
)
from restitution.oracle.bases import bases_of, multiple_of
from restitution.oracle.points import BeyondError, constant_interval, ends_of
from restitution.oracle.roles import REAL, Role
from restitution.oracle.senses import Bounds, possible_senses
from restitution.records import dataclass

Sense = Literal["+", "0+", "real"]
MOST_TERMS = 3000
# Terms, times degree, times binary digits, of what a letter between two bounds is moved in.
MOST_DIGITS = 1_000_000
MOST_MULTIPLE = 12
_OF_FIFTHS = (5, 10)

Quotient = tuple[PolyElement, PolyElement]


class TooLargeError(Exception):
    """An expression has more terms than are worth asking about."""


def _is_plain(turns: sp.Expr) -> bool:
    """Whether the cosine of a multiple of π has roots that take a decision procedure seconds.

    Those of 33° and of other multiples of 3°, but for 18°, 36° and what roots of numbers have.
    """
    if not turns.is_Rational or turns.q in _OF_FIFTHS:
        return False
    return bool(cosine(Fraction(int(turns.p), int(turns.q))).has(*TRIGONOMETRIC))


@dataclass(frozen=True)
class Bound:
    """A polynomial that is positive, or not negative (``strict`` False), by definition."""

    polynomial: PolyElement
    strict: bool


class Polynomials:
    """The polynomial world of some expressions.

    ``letters`` maps the name of each plain letter to its generator, ``angles`` that of each angle
    to (cosine, sine, q). ``relations`` vanish, ``bounds`` hold, ``senses`` says the sign of each
    generator, ``between`` the rational bounds of those that have any.
    """

    def __init__(self, expressions: Iterable[sp.Expr], roles: Mapping[str, Role]) -> None:
        self.roles = roles
        self.loose = False
        self.senses: dict[str, Sense] = {}
        self.between: dict[str, Bounds] = {}
        self.letters: dict[str, str] = {}
        self.angles: dict[str, tuple[str, str, int]] = {}
        self._keys: dict[Any, str] = {}
        self._order: list[tuple[Any, str]] = []
        self._divisors: dict[sp.Expr, int] = {}
        self._numbers: dict[sp.Expr, tuple[sp.Expr, bool]] = {}
        expressions = [algebraic(sp.sympify(expression, strict=True)) for expression in expressions]
        self._bases: list[sp.Rational] = []
        self._bases = bases_of({x for value in expressions for x in self._plain_angles(value)})
        for expression in expressions:
            self._divide(expression)
        ends = [end for divisor in list(self._divisors) for end in self._ends(divisor)]
        for end in ends:
            self._divide(end)
        for value in (*ends, *expressions):
            self._collect(value)
        for atom in list(self._divisors):
            self._collect_atom(atom)
        # Symbols, as a name of two words would be read as two.
        self.ring = PolyRing([sp.Symbol(name) for _, name in self._order] or ["_"], QQ)
        self._generators = dict(zip((n for _, n in self._order), self.ring.gens, strict=False))
        self._quotients: dict[sp.Expr, Quotient] = {}
        self.relations: list[PolyElement] = []
        self._squares: list[tuple[PolyElement, PolyElement, PolyElement]] = []
        self.bounds: list[Bound] = []
        for key, name in self._order:
            self._define(key, name)

    @property
    def names(self) -> list[str]:
        """The generators, in the order of the ring."""
        return [name for _, name in self._order]

    def depends(self, name: str, letters: frozenset[str]) -> bool:
        """Whether a generator is one of these letters, or made of them."""
        key = next(key for key, own in self._order if own == name)
        if key[0] == "letter":
            return key[1] in letters
        return any(symbol.name in letters for symbol in key[1].free_symbols)

    # --- which generators there are --------------------------------------------------------------

    def _divide(self, x: sp.Expr) -> None:
        """The whole numbers by which the angles in an expression are divided."""
        for node in x.atoms(*TRIGONOMETRIC):
            for coefficient, atom in self._terms(node.args[0])[0]:
                q = self._divisors.get(atom, 1)
                self._divisors[atom] = int(sp.ilcm(q, coefficient.q))

    def _ends(self, atom: sp.Expr) -> list[sp.Expr]:
        """Sines of the ends between which an angle lies: of them there are roots as well."""
        low, high, _ = self._limits(atom)
        q = self._divisors[atom]
        return [
            function(end / q)
            for end in (low, high)
            if end is not None
            for function in (sp.sin, sp.cos)
        ]

    def _limits(self, atom: sp.Expr) -> tuple[sp.Expr | None, sp.Expr | None, tuple[bool, bool]]:
        if atom.is_Symbol:
            role = self.roles.get(atom.name, REAL)
            return role.low, role.high, role.closed
        if isinstance(atom, sp.atan2):
            return -sp.pi, sp.pi, (False, True)
        return None, None, (False, False)

    def _terms(self, angle: sp.Expr) -> tuple[list[tuple[sp.Rational, sp.Expr]], sp.Expr]:
        """An angle as rational multiples of letters and inverse functions, and a plain angle.

        A plain angle without a cosine in roots, such as 37°, is among the letters.
        """
        terms: list[tuple[sp.Rational, sp.Expr]] = []
        rest = sp.Integer(0)
        for term in sp.Add.make_args(sp.expand(angle)):
            coefficient, atom = term.as_coeff_Mul()
            if not coefficient.is_Rational:
                coefficient, atom = sp.Integer(1), term
            if atom.is_Symbol or isinstance(atom, INVERSE):
                terms.append((coefficient, atom))
            else:
                rest += term
        turns = sp.expand(rest / sp.pi)
        if _is_plain(turns) or sp.cos(rest).has(*TRIGONOMETRIC):
            for base in self._bases if turns.is_Rational else ():
                count = multiple_of(turns, base)
                if count is not None:
                    terms.append((sp.Integer(count), base * sp.pi))
                    return terms, (turns - count * base) * sp.pi
            terms.append((sp.Integer(1), rest))
            rest = sp.Integer(0)
        return terms, rest

    def _plain_angles(self, x: sp.Expr) -> Iterator[sp.Rational]:
        """The plain angles without a cosine in roots in an expression, as multiples of π."""
        for node in x.atoms(*TRIGONOMETRIC):
            for _, atom in self._terms(node.args[0])[0]:
                turns = sp.expand(atom / sp.pi)
                if turns.is_Rational:
                    yield turns

    def _new(self, key: Any, name: str, sense: Sense = "real") -> None:
        if key not in self._keys:
            self._keys[key] = name
            self._order.append((key, name))
            self.senses[name] = sense

    def _collect(self, x: sp.Expr) -> None:
        if x.is_Symbol:
            self._letter(x)
        elif x.is_Rational:
            pass
        elif x.is_Add or x.is_Mul:
            for argument in x.args:
                self._collect(argument)
        elif x.is_Pow and x.exp.is_Integer:
            self._collect(x.base)
        elif x.is_Pow and x.exp.is_Rational:
            for base in radicands(x):
                self._collect(base)
                self._new(("root", base, int(x.exp.q)), f"root{len(self._order)}", "0+")
        elif isinstance(x, TRIGONOMETRIC):
            terms, rest = self._terms(x.args[0])
            for _, atom in terms:
                self._collect_atom(atom)
            if rest != 0:
                self._collect(sp.cos(rest))
                self._collect(sp.sin(rest))
        elif isinstance(x, sp.Abs):
            self._collect(x.args[0])
            self._new(("abs", x.args[0]), f"size{len(self._order)}", "0+")
        elif isinstance(x, sp.Max | sp.Min):
            for argument in x.args:
                self._collect(argument)
            self._new(("extreme", x), f"extreme{len(self._order)}")
        else:
            self._new(("other", x), f"other{len(self._order)}")
            self.loose = self.loose or not isinstance(x, sp.CRootOf)

    def _letter(self, x: sp.Symbol) -> None:
        name = f"x_{x.name}"
        role = self.roles.get(x.name)
        if role is None:
            role = role_of(x)
        if ("letter", x.name) in self._keys:
            return
        if x in self._divisors:
            self.loose = True  # an angle outside a sine as well
        low, high = (rational_or_none(value) for value in (role.low, role.high))
        if (role.low is not None and low is None) or (role.high is not None and high is None):
            low = low if role.low is None else end_below(role.low)
            high = high if role.high is None else end_above(role.high)
            self.loose = True
        sense: Sense = "real"
        if low is not None and low >= 0:
            sense = "0+" if low == 0 and role.closed[0] else "+"
        self._new(("letter", x.name), name, sense)
        self.letters[x.name] = name
        if high is not None or (low is not None and low != 0):
            self.between[name] = (low, high, *role.closed)

    def _collect_atom(self, atom: sp.Expr) -> None:
        if ("cos", atom) in self._keys:
            return
        q = self._divisors[atom]
        sense: tuple[Sense, Sense] = ("real", "real")
        if atom.is_Symbol:
            role = self.roles.get(atom.name, REAL)
            if role.low is not None and role.high is not None and bool(role.low >= 0):
                if bool(role.high <= sp.pi * q / 2):
                    inner = not role.closed[0], not role.closed[1]
                    sense = (
                        "+" if inner[1] or bool(role.high < sp.pi * q / 2) else "0+",
                        "+" if inner[0] or bool(role.low > 0) else "0+",
                    )
                elif bool(role.high <= sp.pi * q):
                    ends = any(role.closed)
                    sense = ("real", "0+" if ends else "+")
        elif isinstance(atom, INVERSE):
            for argument in atom.args:
                self._collect(argument)
            sense = (
                ("+", "real")
                if isinstance(atom, sp.atan | sp.asin) or q > 1
                else ("real", "0+")
                if isinstance(atom, sp.acos)
                else ("real", "real")
            )
            if isinstance(atom, sp.asin | sp.atan2):
                sense = ("0+" if isinstance(atom, sp.asin) else "real", "real")
        else:
            self._new(("cos", atom), f"c{len(self._order)}")
            self._new(("sin", atom), f"s{len(self._order)}")
            self.loose = True
            return
        self._new(("cos", atom), f"c{len(self._order)}", sense[0])
        self._new(("sin", atom), f"s{len(self._order)}", sense[1])
        if isinstance(atom, sp.atan2):
            self._new(("radius", atom), f"radius{len(self._order)}", "+")

    # --- what is known of them -------------------------------------------------------------------

    def _define(self, key: Any, name: str) -> None:
        own = self._generators[name]
        match key:
            case ("root", base, q):
                above, below = self.quotient(base)
                self._square(own, own**q, above, below, q == 2)
            case ("abs", x):
                above, below = self.quotient(x)
                self._square(own, own**2, above**2, below**2, True)
            case ("extreme", x):
                self._define_extreme(own, x)
            case ("cos", atom):
                self._define_angle(atom)
            case ("other", x):
                self._enclose(name, x)

    def _square(
        self,
        own: PolyElement,
        power: PolyElement,
        above: PolyElement,
        below: PolyElement,
        two: bool,
    ) -> None:
        self.relations.append(power * below - above)
        if two:
            self._squares.append((own, above, below))

    def _define_extreme(self, own: PolyElement, x: sp.Expr) -> None:
        sense = 1 if isinstance(x, sp.Max) else -1
        product = self.ring.one
        for argument in x.args:
            above, below = self.quotient(argument)
            rest = own * below - above
            product = product * rest
            self.bounds.append(Bound(rest * below * sense, False))
        self.relations.append(product)

    def _define_angle(self, atom: sp.Expr) -> None:
        c, s = (self._generators[self._keys[kind, atom]] for kind in ("cos", "sin"))
        q = self._divisors[atom]
        self.relations.append(c**2 + s**2 - 1)
        self._squares.append((c, 1 - s**2, self.ring.one))
        if atom.is_Symbol:
            self.angles[atom.name] = (self._keys["cos", atom], self._keys["sin", atom], q)
            self._define_limits(atom, c, s, q)
        elif isinstance(atom, INVERSE):
            self._define_inverse(atom, c, s, q)
        else:
            for kind, function in (("cos", sp.cos), ("sin", sp.sin)):
                self._enclose(self._keys[kind, atom], function(atom / q))

    def _define_limits(self, atom: sp.Expr, c: PolyElement, s: PolyElement, q: int) -> None:
        low, high, closed = self._limits(atom)
        if low is None or high is None or bool(high - low >= 2 * sp.pi * q):
            return
        if low == 0 and high in (sp.pi * q / 2, sp.pi * q):
            return  # the signs of cosine and sine say it
        from_low = self._turned(c, s, -low / q)[1]
        to_high = -self._turned(c, s, -high / q)[1]
        if bool(high - low <= sp.pi * q):
            self.bounds.append(Bound(from_low, not closed[0]))
            self.bounds.append(Bound(to_high, not closed[1]))
        else:
            self.loose = True  # one of two sectors: what is left out is an *or*

    def _define_inverse(self, atom: sp.Expr, c: PolyElement, s: PolyElement, q: int) -> None:
        n = q
        cn, sn = self._multiple(c, s, n)
        if isinstance(atom, sp.atan2):
            (y, yb), (x, xb) = (self.quotient(argument) for argument in atom.args)
            r = self._generators[self._keys["radius", atom]]
            self.relations.append(r * cn * xb - x)
            self.relations.append(r * sn * yb - y)
            # It is above -180°, and 180° at most.
            if q == 2:
                self.bounds += [Bound(c, False), Bound(s + 1, True)]
            elif q > 2:
                self._define_limits(atom, c, s, q)
            return
        above, below = self.quotient(atom.args[0])
        if isinstance(atom, sp.atan):
            self.relations.append(sn * below - above * cn)
            if q > 1:
                self.bounds.append(Bound(cn, True))
        elif isinstance(atom, sp.acos):
            self.relations.append(cn * below - above)
            if q > 1:
                self.bounds.append(Bound(s, False))
        else:
            self.relations.append(sn * below - above)
            if q > 1:
                self.bounds.append(Bound(cn, False))

    def _enclose(self, name: str, x: sp.Expr) -> None:
        """Rational bounds of a plain number, or of an inverse function."""
        ends: tuple[sp.Expr | None, sp.Expr | None] = (None, None)
        if not x.free_symbols:
            try:
                interval = constant_interval(x, 40)
            except BeyondError:
                pass
            else:
                low, high = ends_of(interval)
                self.between[name] = (low, high, True, True)
                if low > 0:
                    self.senses[name] = "+"
                if isinstance(x, sp.CRootOf):
                    own = self._generators[name]
                    powers = enumerate(reversed(x.poly.all_coeffs()))
                    self.relations.append(
                        sum((own**n * QQ(int(c.p), int(c.q)) for n, c in powers), self.ring.zero)
                    )
                return
        elif isinstance(x, sp.atan | sp.asin):
            ends = -sp.pi / 2, sp.pi / 2
        elif isinstance(x, sp.acos):
            ends = sp.Integer(0), sp.pi
        elif isinstance(x, sp.atan2):
            ends = -sp.pi, sp.pi
        elif isinstance(x, sp.sign):
            ends = sp.Integer(-1), sp.Integer(1)
        if ends[0] is not None and ends[1] is not None:
            self.between[name] = (end_below(ends[0]), end_above(ends[1]), True, True)

    # --- translating -----------------------------------------------------------------------------

    def quotient(self, x: sp.Expr) -> Quotient:
        """Numerator and denominator. Raises TooLargeError."""
        x = sp.sympify(x, strict=True)
        if x not in self._quotients:
            self._quotients[x] = self._translate(x)
        return self._quotients[x]

    def _translate(self, x: sp.Expr) -> Quotient:
        one = self.ring.one
        if x.is_Rational:
            return self.ring.ground_new(QQ(int(x.p), int(x.q))), one
        if x.is_Symbol:
            return self._generators[self._keys["letter", x.name]], one
        if x.is_Add:
            total: Quotient = self.quotient(x.args[0])
            for argument in x.args[1:]:
                total = self._sum(total, self.quotient(argument))
            return total
        if x.is_Mul:
            above, below = one, one
            for argument in x.args:
                a, b = self.quotient(argument)
                above, below = self._product(above, a), self._product(below, b)
            return above, below
        if x.is_Pow and x.exp.is_Integer:
            return self._power(self.quotient(x.base), int(x.exp))
        if x.is_Pow:
            above, below = one, one
            for base in radicands(x):
                root = self._generators[self._keys["root", base, int(x.exp.q)]]
                a, b = self._power((root, one), int(x.exp.p))
                above, below = above * a, below * b
            return above, below
        if isinstance(x, TRIGONOMETRIC):
            c, s = self.cosine_and_sine(x.args[0])
            return {
                sp.sin: (s, one),
                sp.cos: (c, one),
                sp.tan: (s, c),
                sp.cot: (c, s),
                sp.sec: (one, c),
                sp.csc: (one, s),
            }[function_of(x)]
        kind = (
            "abs" if isinstance(x, sp.Abs) else "extreme" if isinstance(x, sp.Max | sp.Min) else ""
        )
        key = ("abs", x.args[0]) if kind == "abs" else (kind or "other", x)
        return self._generators[self._keys[key]], one

    def cosine_and_sine(self, angle: sp.Expr) -> tuple[PolyElement, PolyElement]:
        """The cosine and the sine of a sum of multiples of the angles that were collected."""
        c, s = self.ring.one, self.ring.zero
        terms, rest = self._terms(angle)
        if rest != 0:
            c, s = self._turned(c, s, rest)
        for coefficient, atom in terms:
            q = self._divisors[atom]
            cosine, sine = (self._generators[self._keys[kind, atom]] for kind in ("cos", "sin"))
            cn, sn = self._multiple(cosine, sine, int(coefficient * q))
            c, s = (
                self._product(c, cn) - self._product(s, sn),
                self._product(s, cn) + self._product(c, sn),
            )
        return c, s

    def _turned(
        self, c: PolyElement, s: PolyElement, angle: sp.Expr
    ) -> tuple[PolyElement, PolyElement]:
        """Cosine and sine turned by a plain angle, whose own are sums of roots."""
        (cx, _), (sx, _) = (self.quotient(sp.expand(f(angle))) for f in (sp.cos, sp.sin))
        return c * cx - s * sx, s * cx + c * sx

    def _multiple(self, c: PolyElement, s: PolyElement, n: int) -> tuple[PolyElement, PolyElement]:
        if abs(n) > MOST_MULTIPLE:
            raise TooLargeError
        cn, sn = self.ring.one, self.ring.zero
        for _ in range(abs(n)):
            cn, sn = cn * c - sn * s, sn * c + cn * s
        return cn, (sn if n >= 0 else -sn)

    def _power(self, base: Quotient, n: int) -> Quotient:
        above, below = base if n >= 0 else (base[1], base[0])
        a, b = self.ring.one, self.ring.one
        for _ in range(abs(n)):
            a, b = self._product(a, above), self._product(b, below)
        return a, b

    def _sum(self, p: Quotient, q: Quotient) -> Quotient:
        (a, b), (c, d) = p, q
        if b == d:
            return a + c, b
        if b == 1 or d == 1:
            return self._product(a, d) + self._product(c, b), self._product(b, d)
        if len(b) * len(d) < 200:
            common = b.gcd(d)
            if common != 1:
                left, right = d.quo(common), b.quo(common)
                return (
                    self._product(a, left) + self._product(c, right),
                    self._product(b, left),
                )
        return self._product(a, d) + self._product(c, b), self._product(b, d)

    def _product(self, a: PolyElement, b: PolyElement) -> PolyElement:
        if len(a) * len(b) > 20 * MOST_TERMS:
            raise TooLargeError
        product = a * b
        if len(product) > MOST_TERMS:
            raise TooLargeError
        return product

    # --- deciding by algebra ---------------------------------------------------------------------

    def vanishes(self, polynomial: PolyElement) -> bool:
        """Whether a polynomial is zero by the relations of roots and angles.

        False says nothing: roots may depend on each other in ways that are not tried here.
        """
        return not self.reduced(polynomial)

    def reduced(self, polynomial: PolyElement) -> PolyElement:
        """The polynomial times something that is not zero, squares of generators put in."""
        for own, above, below in reversed(self._squares):
            n = self.ring.gens.index(own)
            if polynomial.degree(own) < 2:
                continue
            even: dict[int, PolyElement] = {}
            for monomial, coefficient in polynomial.terms():
                half, rest = divmod(monomial[n], 2)
                plain = list(monomial)
                plain[n] = rest
                even.setdefault(half, self.ring.zero)
                even[half] = even[half] + self.ring({tuple(plain): coefficient})
            most = max(even)
            total = self.ring.zero
            for half, part in even.items():
                term = part
                for _ in range(half):
                    term = self._product(term, above)
                for _ in range(most - half):
                    term = self._product(term, below)
                total = total + term
            polynomial = total
        return polynomial

    def sign(self, polynomial: PolyElement) -> int | None:
        """The sign of a polynomial where its coefficients show it; None says nothing.

        Letters between bounds go from 0 to ∞ first: then it is positive if all coefficients are.
        """
        if polynomial.is_ground:
            number = polynomial.coeff(1)
            return int(number > 0) - int(number < 0)
        for sense in possible_senses(polynomial, self.names, self.senses, self.between):
            if self._positive(polynomial * sense):
                return sense
        return None

    def not_negative(self, polynomial: PolyElement) -> bool:
        """Whether the coefficients show that a polynomial is never negative."""
        return self._positive(polynomial, strict=False)

    def _positive(self, polynomial: PolyElement, strict: bool = True) -> bool:
        moved, touched = self._moved(polynomial)
        # The powers that a monomial has to have to be positive at an end that belongs to a letter.
        ends: list[tuple[int, list[int]]] = []
        for n, name in enumerate(self.names):
            if name in touched:
                ends.append((n, touched[name]))
            elif self.senses[name] == "0+" and moved.degree(self.ring.gens[n]) > 0:
                ends.append((n, [0]))
        monomials = []
        for monomial, coefficient in moved.terms():
            for n, (_, name) in enumerate(self._order):
                if monomial[n] % 2 and self.senses[name] == "real" and name not in touched:
                    return False
            if coefficient < 0:
                return False
            monomials.append(monomial)
        if not strict:
            return True
        reals = [
            n
            for n, (_, name) in enumerate(self._order)
            if self.senses[name] == "real" and name not in touched
        ]
        # Positive also where letters are at those ends that belong to them.
        wanted: list[dict[int, int]] = [{}]
        for n, powers in ends:
            if powers:
                wanted = [{**powers_of, n: power} for powers_of in wanted for power in powers]
            if len(wanted) > 64:
                return False
        firm = [m for m in monomials if not any(m[n] for n in reals)]
        return all(
            any(all(m[n] == power for n, power in monomial.items()) for m in firm)
            for monomial in wanted
        )

    def _moved(self, polynomial: PolyElement) -> tuple[PolyElement, dict[str, list[int]]]:
        """Letters between bounds replaced by letters from 0 to ∞.

        With them, for each end that belongs to a letter, the power of it that is left there.
        """
        touched: dict[str, list[int]] = {}
        for name, (low, high, closed_low, closed_high) in self.between.items():
            own = self._generators[name]
            degree = polynomial.degree(own)
            if degree <= 0:
                continue
            n = self.ring.gens.index(own)
            digits = sum(end.denominator.bit_length() for end in (low, high) if end is not None)
            if len(polynomial) * degree * digits > MOST_DIGITS:
                raise TooLargeError
            parts: dict[int, PolyElement] = {}
            for monomial, coefficient in polynomial.terms():
                plain = list(monomial)
                power, plain[n] = plain[n], 0
                parts.setdefault(power, self.ring.zero)
                parts[power] = parts[power] + self.ring({tuple(plain): coefficient})
            if low is not None and high is not None:
                above, below = own * domain_number(high) + domain_number(low), own + 1
                touched[name] = [0] * closed_low + [degree] * closed_high
            elif low is not None:
                above, below = own + domain_number(low), self.ring.one
                touched[name] = [0] * closed_low
            elif high is not None:
                above, below = domain_number(high) - own, self.ring.one
                touched[name] = [0] * closed_high
            else:
                continue
            total = self.ring.zero
            for power, part in parts.items():
                total = total + part * above**power * below ** (degree - power)
            if len(total) > MOST_TERMS:
                raise TooLargeError
            polynomial = total
        return polynomial, touched

    def factors(self, polynomial: PolyElement) -> list[tuple[PolyElement, int]]:
        """Irreducible factors with their powers, and first the number in front."""
        if polynomial.is_ground or len(polynomial) > 80:
            return [(polynomial, 1)]
        content, parts = _factor_list(polynomial)
        return [(self.ring.ground_new(content), 1), *parts]


@lru_cache(maxsize=2048)
def _factor_list(polynomial: PolyElement) -> tuple[Any, list[tuple[PolyElement, int]]]:
    # Of a name of two words SymPy makes no ring anew, which it has to.
    plain = _ring(polynomial.ring.ngens)
    content, parts = factor_list(plain.from_dict(dict(polynomial)))
    return content, [(polynomial.ring.from_dict(dict(part)), times) for part, times in parts]


@cache
def _ring(count: int) -> PolyRing:
    return PolyRing([f"x{n}" for n in range(count)], QQ)
