"""An expression over one denominator, in factors, with common letters collected."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, S, Symbol

from restitution.exact.nodes import in_front
from restitution.exact.numbers import tidy_number
from restitution.exact.products import in_factors
from restitution.exact.quotients import over_surds
from restitution.exact.samples import has_one_sign, is_negative
from restitution.exact.simplicity import MASKED, cost, is_surd, node_count
from restitution.work import remembered, spend


@remembered(2048)
def factored(value: Expr, deep: bool = True) -> Expr:
    """Over one denominator, in factors; surds out of denominators; signs and conjugates tidy."""
    if deep:
        return _set_out(over_surds(in_factors(value)), True)
    return _set_out(sympy.factor_terms(sympy.together(value)), False)


@remembered(2048)
def _set_out(value: Expr, deep: bool) -> Expr:
    """A product of factors as they are read: signs, conjugates and, if deep, surds and sums."""
    spend()
    coefficient: Expr = S.One
    powers: list[tuple[Expr, Expr]] = []
    for factor in Mul.make_args(value):
        if not factor.free_symbols:
            coefficient *= factor
            continue
        base, exponent = factor.as_base_exp()
        if not isinstance(exponent, Rational) or exponent.q != 1:
            powers.append((factor, S.One))
            continue
        if isinstance(base, Add) and deep:
            outside, parts = _primitive(base)
            coefficient *= outside**exponent
            powers.extend((part, exponent * power) for part, power in parts)
        else:
            powers.append((base, exponent))
    powers = _merged(powers)
    coefficient = tidy_number(coefficient)
    if deep:
        coefficient, powers = _surds_inside(coefficient, powers)
    sign, powers = _signed(coefficient, powers)
    if sign < 0:
        coefficient = -coefficient if not isinstance(coefficient, Add) else coefficient * -1
    if deep:
        powers = [(_collected(base), power) for base, power in powers]
    return _product(coefficient, powers)


def _surds_inside(
    coefficient: Expr, powers: list[tuple[Expr, Expr]]
) -> tuple[Expr, list[tuple[Expr, Expr]]]:
    """(2 + √3)(e + 3√3 − 5) as √3 − 1 + (2 + √3)e, where that is shorter."""
    rational, surd = coefficient.as_coeff_Mul()
    if not isinstance(surd, Add):
        return coefficient, powers
    for index, (base, power) in enumerate(powers):
        if power != 1 or not isinstance(base, Add) or len(base.args) > 4:
            continue
        if not any(is_surd(atom) for atom in base.atoms(Pow)):
            continue
        whole = _collected_in(sympy.expand(surd * base), tuple(base.free_symbols))
        if cost(whole) < cost(surd) + cost(base) + 1:  # two pairs of brackets
            return rational, [*powers[:index], (whole, power), *powers[index + 1 :]]
    return coefficient, powers


def _product(coefficient: Expr, powers: list[tuple[Expr, Expr]]) -> Expr:
    rational, surd = coefficient.as_coeff_Mul()
    rest = Mul(*[Pow(base, power) for base, power in powers])
    if surd is not S.One:
        rest = surd * rest
    return in_front(rational, rest)


@remembered(2048)
def _primitive(total: Add) -> tuple[Expr, list[tuple[Expr, Expr]]]:
    """A sum as a number times factors without a common factor, surds included."""
    surds = {x for x in total.atoms(Pow) if is_surd(x)}
    content, rest = total.primitive()
    plain: tuple[Expr, list[tuple[Expr, Expr]]] = (content, [(rest, S.One)])
    if not surds or len(total.args) > 10:
        return plain
    letters = sorted(total.free_symbols, key=sympy.default_sort_key)
    # 2e + √3 e − 1 as (2 + √3)e − 1
    gathered = _collected_in(rest, tuple(letters))
    plain = content, [(gathered if cost(gathered) < cost(rest) + 0.75 else rest, S.One)]
    try:
        poly = sympy.Poly(rest, *letters, domain="EX")
    except sympy.PolynomialError:
        return plain
    options = [plain]
    tried: set[Expr] = set()
    for coefficient in poly.coeffs()[:3] + poly.coeffs()[-1:]:
        value = sympy.expand(
            coefficient.as_expr() if hasattr(coefficient, "as_expr") else coefficient
        )
        if value.is_Rational or value in tried:
            continue
        tried.add(value)
        parts = [tidy_number(sympy.expand(coeff) / value) for coeff in poly.coeffs()]
        if any(not _is_simple(part) for part in parts):
            continue
        quotient = Add(
            *[
                sympy.expand(part) * Mul(*[x**p for x, p in zip(letters, powers, strict=True)])
                for part, powers in zip(parts, poly.monoms(), strict=True)
            ]
        )
        more, inner = quotient.primitive()
        # Dividing may have left a polynomial over the rationals that splits.
        split = sympy.factor_list(inner)
        factors = [(f, Integer(p)) for f, p in split[1]]
        options.append((tidy_number(value * more * split[0]), factors))
    return min(
        options,
        key=lambda option: (
            (cost(option[0]) if option[0] is not S.One else 0.0)
            + sum(cost(f) + (0.5 if p == 1 else 1.0) for f, p in option[1])
        ),
    )


def _is_simple(number: Expr) -> bool:
    return node_count(number, 16) < 16


def _merged(powers: list[tuple[Expr, Expr]]) -> list[tuple[Expr, Expr]]:
    """Equal bases joined, and (a − b)(a + b) written a² − b² where both have one power."""
    joined: dict[Expr, Expr] = {}
    sign = S.One
    for base, power in powers:
        if base not in joined and isinstance(base, Add) and -base in joined:
            base = -base
            if power.is_odd:
                sign = -sign
        joined[base] = joined.get(base, S.Zero) + power
    done = [(base, power) for base, power in joined.items() if power != 0]
    changed = True
    while changed:
        changed = False
        for (first, p), (second, q) in combinations(done, 2):
            product = conjugates(first, second) if p == q else None
            if product is not None:
                done = [x for x in done if x not in ((first, p), (second, q))]
                done.append((product, p))
                changed = True
                break
    if sign is not S.One:
        done.append((S.NegativeOne, S.One))
    return done


def conjugates(first: Expr, second: Expr) -> Expr | None:
    """a² − b² for (a − b)(a + b) of two single terms, else None."""
    if not (isinstance(first, Add) and isinstance(second, Add)):
        return None
    if len(first.args) != 2 or len(second.args) != 2:
        return None
    total, difference = first + second, first - second
    if isinstance(total, Add) or isinstance(difference, Add):
        return None
    a, b = total / 2, difference / 2
    return a**2 - b**2


def _signed(
    coefficient: Expr, powers: list[tuple[Expr, Expr]]
) -> tuple[int, list[tuple[Expr, Expr]]]:
    """Sums that are negative for all admissible letters turned round; no needless minus in front.

    Returns the sign that is left over for the coefficient.
    """
    sign = 1
    turned: list[tuple[Expr, Expr]] = []
    for base, power in powers:
        if base is S.NegativeOne:
            sign = -sign
            continue
        if isinstance(base, Add) and (_all_negative(base) or is_negative(base)):
            base = -base
            if power.is_odd:
                sign = -sign
        turned.append((base, power))
    overall = sign * (-1 if coefficient.could_extract_minus_sign() else 1)
    if overall < 0:
        for index, (base, power) in enumerate(turned):
            mixed = isinstance(base, Add) and any(map(_is_minus, base.args))
            if mixed and power.is_odd and not has_one_sign(base):
                turned[index] = (-base, power)
                sign = -sign
                break
    return sign, turned


@remembered(2048)
def _collected(total: Expr) -> Expr:
    """A sum with one letter, or with its components, collected where that is shorter."""
    if not isinstance(total, Add) or not 3 <= len(total.args) <= 12:
        return total
    best, least = total, cost(total)
    letters = sorted(total.free_symbols, key=_masked_first)
    for letter in letters:
        if sum(term.has(letter) for term in total.args) < 2:
            continue
        collected = _collected_in(total, (letter,))
        # (1 + e) cos²θ rather than cos²θ + e cos²θ, though both are as long.
        slack = 0.25 if isinstance(letter, sympy.Dummy) else -0.25
        if cost(collected) < least + slack:
            best, least = collected, min(least, cost(collected))
    components = _components(letters)
    if len(components) > 1 or (components and isinstance(components[0], sympy.Dummy)):
        collected = _collected_in(total, components)
        # (1 − e) cos α + (1 + e) cos β rather than cos α + cos β − e(cos α − cos β)
        whole = isinstance(collected, Add) and all(
            any(isinstance(x, Add) for x in Mul.make_args(term)) for term in collected.args
        )
        if cost(collected) < least + (2 if whole else 0.25):
            best = collected
    return best


def _masked_first(letter: Symbol) -> tuple[bool, Any]:
    return not isinstance(letter, sympy.Dummy), sympy.default_sort_key(letter)


def _components(letters: list[Symbol]) -> tuple[Symbol, ...]:
    """The sines and cosines in a sum or, where there are none, what is no coefficient."""
    masked = [x for x in letters if isinstance(x, sympy.Dummy) and x.name in MASKED]
    return tuple(masked or [x for x in letters if not x.is_nonnegative or x.is_positive])


def _collected_in(total: Add, letters: tuple[Symbol, ...]) -> Expr:
    """A sum with the products of some letters collected, each factor in factors."""
    parts: dict[Expr, list[Expr]] = {}
    for term in total.args:
        coefficient, power = term.as_independent(*letters, as_Add=False)
        parts.setdefault(power, []).append(coefficient)
    terms = []
    for power, coefficients in parts.items():
        coefficient = Add(*coefficients)
        inner = in_factors(coefficient) if isinstance(coefficient, Add) else coefficient
        if isinstance(inner, Mul) and any(isinstance(x, Add) for x in inner.args):
            many = sum(bool(x.free_symbols) for x in inner.args) > 1
            if inner.free_symbols:
                inner = _set_out(inner, False) if many else factored(inner, False)
        if isinstance(inner, Add) and power is not S.One and _turns(inner):
            terms.append(Mul(S.NegativeOne, -inner, power))
        else:
            terms.append(_keep(inner, power))
    return Add(*terms)


def _turns(total: Add) -> bool:
    """Whether a sum reads better behind a minus: −1 − e, and e − 1, which is never positive."""
    return _all_negative(total) or (
        any(_is_minus(term) for term in total.args) and is_negative(total)
    )


def _all_negative(total: Add) -> bool:
    return all(_is_minus(term) for term in total.args)


def _is_minus(term: Expr) -> bool:
    return bool(term.as_coeff_Mul()[0].is_negative)


def _keep(coefficient: Expr, power: Expr) -> Expr:
    if power is S.One:
        return coefficient
    rational, rest = coefficient.as_coeff_Mul()
    return rational * (rest * power) if not isinstance(rest, Add) else Mul(rational, rest, power)
