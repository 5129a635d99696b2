"""Whether an expression is zero, and its sign, without samples or clocks."""

from __future__ import annotations

import sympy as sp
from sympy.polys.polyerrors import PolynomialError

from restitution.exact import digits_apart, rationalised
from restitution.expression.enclosed import UndefinedError, sign_of
from restitution.oracle.points import BeyondError, Program
from restitution.solving.algebra.numbers import at
from restitution.solving.algebra.polynomials import Element, Field, TooLargeError
from restitution.work import remembered


@remembered(4096)
def vanishing(x: sp.Expr) -> bool | None:
    """Whether an expression is zero whatever its letters are; None where that is not decided."""
    if x.is_Rational:
        return bool(x == 0)
    if x.is_Symbol:
        return False
    try:
        field = Field([x])
        above, _ = field.fraction(x)
        for circle in field.circles:
            above = field.using(circle, above)
    except (PolynomialError, TooLargeError):
        return None
    if above == 0:
        return True
    return False if field.exact else None


@remembered(2048)
def plain_number(x: sp.Expr) -> sp.Expr | None:
    """A number in roots as a sum without roots in denominators; None for any other.

    A root of a root that could be taken may stand in the way: then None too.
    """
    if x.has(sp.sin, sp.cos):
        return None
    try:
        field = Field([x])
        if not all(atom.is_Pow or isinstance(atom, sp.CRootOf) for atom in field.atoms):
            return None
        above, below = field.fraction(x)
        inverse = field.inverse(below)
    except (PolynomialError, TooLargeError):
        return None
    return None if inverse is None else field.expression(field.times(above, inverse))


def sign(x: sp.Expr) -> int | None:
    """The sign of a number; None for what is not real.

    Zero is proved by normal form, or else by as many digits as tell a number made with roots from
    zero. A number of another kind is zero if four hundred digits show no sign.
    """
    if x.is_Rational:
        return int(x.p > 0) - int(x.p < 0)
    if vanishing(x):
        return 0
    try:
        seen = at(x, {}).sign
        digits = None if seen else digits_apart(x)
        if seen or digits is None:
            return seen
        (interval,) = Program.of([x]).enclosures({}, 2 * digits + 20)
    except (UndefinedError, BeyondError, KeyError, ArithmeticError):
        return None
    return None if interval is None else sign_of(interval) or 0


@remembered(2048)
def definite(x: sp.Expr, positive: frozenset[sp.Expr] = frozenset(), weak: bool = False) -> int:
    """1 or −1 where the signs of letters and terms prove that sign; 0 where they do not.

    ``positive`` are other expressions in it that are known to be so, such as sines. ``weak`` takes
    what may vanish too, such as −cos²α: it is nowhere of the other sign.
    """
    if x.is_Symbol:
        return 1 if x.is_positive or (weak and x.is_nonnegative) else 0
    if x.is_number:
        return sign(x) or 0
    try:
        field = Field([x])
        above, below = field.fraction(x)
    except (PolynomialError, TooLargeError):
        return 0
    one, other = (_definite(field, value, positive, weak) for value in (above, below))
    return one * other


def _definite(field: Field, a: Element, known_positive: frozenset[sp.Expr], weak: bool) -> int:
    numbers = {index for index, atom in enumerate(field.atoms) if atom.is_number}
    terms: dict[tuple[int, ...], Element] = {}
    for monomial, c in a.items():
        kept = tuple(0 if n in numbers else power for n, power in enumerate(monomial))
        number = tuple(power if n in numbers else 0 for n, power in enumerate(monomial))
        terms.setdefault(kept, field.ring.zero)[number] = c
    signs = [atom in known_positive or _sign_of_atom(atom, known_positive) for atom in field.atoms]
    common, strict = 0, False
    for monomial, part in terms.items():
        own = sign(field.expression(part))
        if own is None:
            return 0
        if own == 0:
            continue
        positive = True
        for known, power in zip(signs, monomial, strict=True):
            if power and known is not True:
                if known is None and power % 2:
                    return 0
                positive = False
        if common not in (0, own):
            return 0
        common, strict = own, strict or positive
    return common if strict or weak else 0


def _sign_of_atom(x: sp.Expr, positive: frozenset[sp.Expr]) -> bool | None:
    """True for positive, False for not negative, None for real."""
    if x.is_Symbol:
        return True if x.is_positive else False if x.is_nonnegative else None
    if x.is_number:
        return None  # counted with the coefficients
    if x.is_Pow and x.exp.q % 2 == 0:
        return definite(x.base, positive) > 0
    return False if isinstance(x, sp.Abs) else None


def rational_below(x: sp.Expr, max_terms: int = 4) -> sp.Expr:
    """A number without roots in denominators, in SymPy's form for surds.

    Large numbers with roots of roots, with which SymPy might never end, are multiplied out by their
    conjugates; a root without a formula stands in a polynomial of lower degree than its own. What
    is more comes back as it is.
    """
    if x.has(sp.sin, sp.cos):
        return x
    if x.has(sp.CRootOf):
        plain = plain_number(x)
        return x if plain is None else plain
    plain = rationalised(x)
    if plain is not None:
        return plain
    nested = any(node.base.has(sp.Pow) for node in x.atoms(sp.Pow) if not node.exp.is_Integer)
    large = sp.count_ops(x) > _LARGE_NUMBER
    if nested and not large:
        return sp.radsimp(sp.expand(x), max_terms=max_terms)
    plain = plain_number(x)
    if nested or (large and plain is None):
        return x if plain is None else plain
    return sp.radsimp(sp.expand(x) if plain is None else plain, max_terms=max_terms)


_LARGE_NUMBER = 60
