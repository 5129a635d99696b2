"""Roots of expressions with letters: joined, divided, and what stands under them."""

from __future__ import annotations

from itertools import combinations

import sympy
from sympy import Add, Expr, Mul, Pow, Rational, S, Symbol

from restitution.exact.factors import conjugates, factored
from restitution.exact.samples import is_negative
from restitution.exact.signs import sign_of
from restitution.exact.simplicity import HALF, cost
from restitution.exact.symbols import atoms_in
from restitution.exact.trigonometry import MaskedAngle, has_tangent_letter, masked_angles


def has_fractions(value: Expr) -> bool:
    """Whether a sum in the expression has terms with denominators."""
    return any(
        sympy.fraction(term)[1] is not S.One
        for total in atoms_in(value, Add)
        for term in total.args
    )


def has_tangent_under_root(value: Expr) -> bool:
    """Whether the letter of a tangent stands under a root in a product."""
    return any(map(_is_root_with_tangent, Mul.make_args(value)))


def _is_root_with_tangent(factor: Expr) -> bool:
    return isinstance(factor, Pow) and factor.exp == HALF and has_tangent_letter(factor.base)


def into_root(value: Expr) -> Expr:
    """``cos α √(1 + e² tan²α)`` as ``√(cos²α + e² sin²α)``, where that is shorter."""
    for angle in masked_angles(value):
        value = _cosine_into_root(value, angle)
    return value


def _cosine_into_root(value: Expr, angle: MaskedAngle) -> Expr:
    s, c, t = angle.sine, angle.cosine, angle.tangent
    best = value
    for factor in Mul.make_args(value):
        if not (isinstance(factor, Pow) and factor.exp == HALF and t in factor.free_symbols):
            continue
        above, below = sympy.fraction(sympy.together(factor.base.xreplace({t: s / c}) * c**2))
        if below.free_symbols & {s, c}:
            continue
        inside = factored(sympy.expand(above) / below)
        candidate = value / factor / c * sympy.sqrt(inside)
        best = candidate if cost(candidate) < cost(best) else best
    return best


def square_of_root(root: Expr, back: dict[Symbol, Expr]) -> Expr | None:
    """What stands under a masked root, if it is free of further roots."""
    if isinstance(root, Pow) and root.exp == HALF:
        return mask_roots(root.base, back)
    return None


def has_two_roots(value: Expr) -> bool:
    """Whether a product has two roots of letters."""
    return isinstance(value, Mul) and sum(map(_is_root_of_letters, value.args)) > 1


def _is_root_of_letters(factor: Expr) -> bool:
    return isinstance(factor, Pow) and abs(factor.exp) == HALF and bool(factor.base.free_symbols)


def with_roots_joined(value: Expr) -> Expr:
    """√(a − b) √(a + b) as √(a² − b²), and √(a b)/√a as √b, where that is shorter."""
    factors = list(value.args)
    for first, second in combinations(filter(_is_root_of_letters, factors), 2):
        joined = _joined(first, second)
        if joined is not None:
            rest = [factor for factor in factors if factor not in (first, second)]
            return Mul(*rest, joined)
    return value


def _joined(first: Pow, second: Pow) -> Expr | None:
    if first.exp == second.exp:
        inside = conjugates(first.base, second.base)
        if inside is not None:
            return Pow(inside, first.exp)
    if first.base.is_Symbol or second.base.is_Symbol:
        return None
    # Both roots are real, so √(a b)/√a is √b.
    inside = sympy.cancel(first.base ** (2 * first.exp) * second.base ** (2 * second.exp))
    if cost(inside) < cost(first.base) + cost(second.base) - 1:
        return sympy.sqrt(factored(inside))
    return None


def has_sum_under_root_and_below(value: Expr) -> bool:
    """Whether a positive sum is a factor under a root and below the line."""
    return _factor_under_root(value) is not None


def divided_roots(value: Expr) -> Expr:
    """√(a b)/a as √(b/a), where a is positive."""
    pair = _factor_under_root(value)
    if pair is None:
        return value
    root, factor = pair
    return value / root * factor * sympy.sqrt(root.base / factor**2)


def _factor_under_root(value: Expr) -> tuple[Pow, Expr] | None:
    if not isinstance(value, Mul):
        return None
    for root in value.args:
        if not (isinstance(root, Pow) and root.exp == HALF and isinstance(root.base, Mul)):
            continue
        for factor in Mul.make_args(sympy.fraction(value)[1]):
            if isinstance(factor, Add) and factor in root.base.args and sign_of(factor) == 1:
                return root, factor
    return None


def has_squares_below(inside: Expr) -> bool:
    """Whether the terms of a sum have a square as their common denominator."""
    return isinstance(inside, Add) and _common_square(inside) is not None


def over_a_square(inside: Expr) -> Expr:
    """A²/c² + b as (A² + b c²)/c², whose root is simpler; the terms are kept as they are."""
    whole = _common_square(inside)
    if whole is None:
        return inside
    parts = [sympy.fraction(term) for term in inside.args]
    return Mul(Add(*[above * (whole / below) for above, below in parts]), 1 / whole, evaluate=False)


def _common_square(inside: Expr) -> Expr | None:
    parts = [sympy.fraction(term) for term in inside.args]
    number = sympy.ilcm(*[below.as_coeff_Mul()[0] for _, below in parts])
    powers: dict[Expr, Expr] = {}
    for _, below in parts:
        for base, power in below.as_coeff_Mul()[1].as_powers_dict().items():
            powers[base] = max(powers.get(base, S.Zero), power)
    powers.pop(S.One, None)
    if not (powers or number > 1) or any(not value.is_even for value in powers.values()):
        return None
    if not sympy.sqrt(number).is_Integer:
        return None
    return number * Mul(*[base**power for base, power in powers.items()])


def root_of(inside: Expr) -> Expr:
    """The square root, each factor's sign turned so that squares come out tidily."""
    if isinstance(inside, Mul):
        flipped = [
            Pow(-f.base, f.exp)
            if isinstance(f, Pow)
            and isinstance(f.base, Add)
            and f.exp.is_even
            and is_negative(f.base)
            else f
            for f in inside.args
        ]
        content, rest = Mul(*flipped, evaluate=False).as_coeff_Mul()
        if content.is_negative:
            # √(−1) must not be split off: another factor may be negative as well.
            sums = [x for x in Mul.make_args(rest) if isinstance(x, Add)]
            if not sums:
                return sympy.sqrt(inside)
            content, rest = -content, rest / sums[0] * (-sums[0])
        return sympy.sqrt(content) * sympy.sqrt(rest)
    return sympy.sqrt(inside)


def mask_roots(value: Expr, back: dict[Symbol, Expr]) -> Expr:
    """Each root of letters replaced by one letter, each letter under a root by a square."""
    roots = {
        atom.base
        for atom in atoms_in(value, Pow)
        if isinstance(atom.exp, Rational) and atom.exp.q == 2 and atom.base.free_symbols
    }
    known = {root.base: symbol for symbol, root in back.items() if isinstance(root, Pow)}
    letters: dict[Expr, Expr] = {}
    for base in sorted(roots, key=sympy.default_sort_key):
        if base not in known:
            kind = {"nonnegative": True} if base.is_extended_nonnegative is not False else {}
            symbol = sympy.Dummy("root", len(back), **kind)
            known[base] = symbol
            back[symbol] = Pow(base, HALF)
        if base.is_Symbol:
            letters[base] = known[base]

    def walk(node: Expr) -> Expr:
        if node in letters:
            return letters[node] ** 2
        if node.is_Atom:
            return node
        if isinstance(node, Pow) and isinstance(node.exp, Rational) and node.base in known:
            if node.exp.q == 2:
                return Pow(known[node.base], node.exp.p)
            if node.exp.q == 1 and not node.base.is_Symbol:
                return Pow(known[node.base], 2 * node.exp.p)
        if isinstance(node, Add) and node in known:
            return known[node] ** 2
        return node.func(*[walk(argument) for argument in node.args])

    return walk(value)


def unrooted(value: Expr, back: dict[Symbol, Expr]) -> Expr:
    """Even powers of masked roots replaced by what stands under them, where that is a sum."""
    for symbol, root in back.items():
        if symbol in value.free_symbols and isinstance(root, Pow) and isinstance(root.base, Add):
            inside = mask_roots(root.base, dict(back))
            if inside.free_symbols & back.keys():
                continue
            above, below = sympy.fraction(sympy.together(value))
            above, below = (_reduce_square(value, symbol, inside) for value in (above, below))
            value = above / below
    return value


def _reduce_square(value: Expr, symbol: Symbol, square: Expr) -> Expr:
    """A polynomial with every symbol² replaced; a product keeps what it can."""
    if symbol not in value.free_symbols:
        return value
    if isinstance(value, Mul):
        return Mul(*[_reduce_square(argument, symbol, square) for argument in value.args])
    if isinstance(value, Pow) and value.base == symbol and value.exp.is_Integer:
        return symbol ** (value.exp % 2) * square ** (value.exp // 2)
    poly = sympy.Poly(sympy.expand(value), symbol)
    return Add(
        *[
            coefficient * square ** (power // 2) * symbol ** (power % 2)
            for (power,), coefficient in poly.terms()
        ]
    )
