"""Expressions in the form that a textbook would print.

An expression is brought into several equivalent forms, and the one that is least to read is taken
(``cost``). Of equals the earlier wins, and the forms are made in this order: factored; with cos²
and sin² exchanged; homogeneous in sine and cosine (``cos²α + e² sin²α``); in tangents; with common
letters collected; as given.
"""

from __future__ import annotations

from typing import Any

import sympy
from sympy import Add, Expr, Mul, Pow, Rational, S, Symbol

from restitution.exact.degrees import function_of, with_ratio
from restitution.exact.factors import factored
from restitution.exact.numbers import rebuilt, tidy_number
from restitution.exact.plain_angles import merged
from restitution.exact.quotients import bars_again, sizes_in
from restitution.exact.roots import (
    divided_roots,
    has_fractions,
    into_root,
    joined_roots,
    mask_roots,
    over_a_square,
    root_of,
    square_of_root,
    unrooted,
)
from restitution.exact.signs import sign_of
from restitution.exact.simplicity import (
    EXPANDED,
    SEARCHED,
    TOUCHED,
    TRIGONOMETRIC,
    UNREADABLE,
    cost,
    node_count,
    terms_multiplied_out,
)
from restitution.exact.trigonometry import MaskedAngle, with_angles
from restitution.work import remembered, spend


@remembered(4096)
def tidy(expression: Any) -> Any:
    """An expression (or the ends of a set of numbers) in the form a textbook would print.

    The value is unchanged wherever the letters are admissible. Never raises but at a limit of
    work; what is too large to be improved quickly comes back as it is.
    """
    if isinstance(expression, sympy.Set):
        return _tidy_set(expression)
    if not isinstance(expression, Expr):
        return expression
    if expression.is_Atom or node_count(expression, TOUCHED) >= TOUCHED:
        return expression
    try:
        return _tidy(expression)
    except UNREADABLE:
        return expression


def _tidy(expression: Expr) -> Expr:
    spend()
    expression = merged(expression)
    if not expression.free_symbols:
        return tidy_number(expression)
    if expression.has(sympy.Abs):
        expression = _fewer_bars(expression)
        sizes = sizes_in(expression)
        if sizes:
            # u² is |u|²: what depends on sizes alone is tidied as if these were letters.
            form = _tidy(expression.xreplace(sizes))
            return form.xreplace(bars_again(sizes))
    starts = [expression]
    if any(
        not atom.args[0].is_Symbol
        for atom in expression.atoms(*TRIGONOMETRIC, sympy.atan, sympy.acos, sympy.asin)
    ):
        expanded = sympy.expand_trig(expression)
        if expanded != expression and node_count(expanded, SEARCHED) < SEARCHED:
            starts.append(expanded)
    forms = [_tidy_letters(start) for start in starts]
    if isinstance(expression, Mul) and expression.has(sympy.Abs):
        forms.append(_with_bars(expression))
    return _with_roots_joined(_compounded(_oriented(min(forms, key=cost))))


def _with_roots_joined(value: Expr) -> Expr:
    """A product in which √(a b)/√a has been left, with √b."""
    if not isinstance(value, Mul):
        return value
    joined = Mul(*joined_roots(list(value.args)))
    if joined == value:
        return value
    other = _tidy_letters(joined)
    return other if cost(other) < cost(value) else value


def _compounded(value: Expr) -> Expr:
    """sin(α − θ) for sin α cos θ − cos α sin θ, and so on, throughout."""
    if value.is_Atom or not (value.has(sympy.sin) or value.has(sympy.tan)):
        return value
    arguments = [_compounded(argument) for argument in value.args]
    if tuple(arguments) != value.args:
        value = rebuilt(value, arguments)
    if isinstance(value, Add) and len(value.args) == 2:
        return _of_two_angles(value)
    return value


def _of_two_angles(total: Add) -> Expr:
    first, second = total.args
    trigonometric = [
        {f for f in Mul.make_args(term) if isinstance(f, sympy.sin | sympy.cos)}
        for term in (first, second)
    ]
    if any(len(each) != 2 for each in trigonometric):
        return total
    angles = sorted({f.args[0] for each in trigonometric for f in each}, key=sympy.default_sort_key)
    if len(angles) != 2 or any(len({f.args[0] for f in each}) != 2 for each in trigonometric):
        return total
    a, b = angles
    sines, cosines = (sympy.sin(a), sympy.sin(b)), (sympy.cos(a), sympy.cos(b))
    for left, right, function in (
        (sines[0] * cosines[1], cosines[0] * sines[1], sympy.sin),
        (cosines[0] * cosines[1], -sines[0] * sines[1], sympy.cos),
    ):
        for x, y in ((first, second), (second, first)):
            factor, other = x / left, y / right
            if factor == other:
                return factor * function(a + b)
            if factor == -other:
                return factor * function(a - b)
    return total


def _fewer_bars(value: Expr) -> Expr:
    """|uv| for |u |v||, and |u| for u²/|u|."""

    def outer(inside: Expr) -> Expr:
        factors = [
            x.args[0] if isinstance(x, sympy.Abs) and x.args[0].is_real else x
            for x in Mul.make_args(inside)
        ]
        return sympy.Abs(Mul(*factors))

    value = value.replace(sympy.Abs, outer)
    for product in value.atoms(Mul):
        powers = product.as_powers_dict()
        for bar in [x for x in powers if isinstance(x, sympy.Abs) and x.args[0].is_real]:
            inside = bar.args[0]
            total = powers[bar] + powers.get(inside, 0)
            if inside in powers and powers[inside].is_even and total.is_Integer:
                old = bar ** powers[bar] * inside ** powers[inside]
                own = inside if total % 2 == 0 else bar
                value = value.xreplace({product: product / old * own**total})
    return value


def _with_bars(value: Mul) -> Expr:
    """A product with one |x| in it, tidied as one thing, and the bars put where they matter."""
    bars = [argument for argument in value.args if isinstance(argument.as_base_exp()[0], sympy.Abs)]
    if len(bars) != 1:
        return value
    base, power = bars[0].as_base_exp()
    rest = value / bars[0]
    if rest.has(sympy.Abs) or sign_of(rest) != 1:
        return value
    factors = []
    for factor in Mul.make_args(_tidy_letters(rest * base.args[0] ** power)):
        below, exponent = factor.as_base_exp()
        sign = 1 if exponent.is_even else sign_of(below)
        factors.append(factor if sign == 1 else sympy.Abs(below) ** exponent)
    return Mul(*factors)


def _oriented(value: Expr) -> Expr:
    """(1 − e)² for (e − 1)² throughout, and (2 − k²)/(1 + k²) for (k² − 2)/(−1 − k²)."""
    if value.is_Atom or not value.has(Add):
        return value
    arguments = [_oriented(argument) for argument in value.args]
    if isinstance(value, Mul):
        arguments = _without_minuses_below(_over_its_own_root(arguments))
    if isinstance(value, Pow) and value.exp.is_even and isinstance(arguments[0], Add):
        arguments[0] = forward(arguments[0])
    return value if tuple(arguments) == value.args else rebuilt(value, arguments)


def _over_its_own_root(factors: list[Expr]) -> list[Expr]:
    """−1/√(k² − 1) for √(k² − 1)/(1 − k²)."""
    bases = {
        factor.base: n for n, factor in enumerate(factors) if factor.is_Pow and factor.exp == -1
    }
    for n, root in enumerate(factors):
        base, power = root.as_base_exp()
        if power == S.Half and base.is_Add and (below := bases.get(-base)) is not None:
            factors[n], factors[below] = 1 / root, S.NegativeOne
    return factors


def _without_minuses_below(factors: list[Expr]) -> list[Expr]:
    """A sum of negative terms below a line changes its sign with a sum above the line."""
    for n, below in enumerate(factors):
        base, power = below.as_base_exp()
        above = [m for m, factor in enumerate(factors) if isinstance(factor, Add)]
        if (
            above
            and power == -1
            and isinstance(base, Add)
            and all(term.could_extract_minus_sign() for term in base.args)
        ):
            factors[n], factors[above[0]] = 1 / -base, -factors[above[0]]
    return factors


def forward(total: Expr) -> Expr:
    """A sum or the same with the other sign: few minuses, and the term with the least e first."""
    minuses = sum(term.could_extract_minus_sign() for term in total.args)
    if 2 * minuses != len(total.args):
        return -total if 2 * minuses > len(total.args) else total
    coefficients = {x for x in total.free_symbols if x.is_nonnegative and not x.is_positive}
    if not coefficients and not total.has(*TRIGONOMETRIC):
        return total

    def order(term: Expr) -> tuple[Any, ...]:
        powers = term.as_powers_dict()
        return sum(powers[x] for x in coefficients if x in powers), sympy.default_sort_key(
            -term if term.could_extract_minus_sign() else term
        )

    return -total if min(total.args, key=order).could_extract_minus_sign() else total


def _tidy_letters(expression: Expr) -> Expr:
    expression = (
        expression.rewrite([sympy.cot, sympy.sec, sympy.csc], sympy.tan)
        if expression.has(sympy.cot, sympy.sec, sympy.csc) and not expression.has(sympy.tan)
        else expression
    )
    angles: dict[Expr, MaskedAngle] = {}
    masks: dict[Expr, Symbol] = {}
    masked = _mask(expression, angles, masks)
    core = _core(masked, tuple(angles.values()))
    back: dict[Symbol, Expr] = {symbol: value for value, symbol in masks.items()}
    for angle in angles.values():
        back[angle.sine] = with_ratio(sympy.sin, angle.argument)
        back[angle.cosine] = with_ratio(sympy.cos, angle.argument)
        back[angle.tangent] = with_ratio(sympy.tan, angle.argument)
    return _restore(core, back)


def _mask(value: Expr, angles: dict[Expr, MaskedAngle], masks: dict[Expr, Symbol]) -> Expr:
    """Functions replaced by letters, so that what is left is algebra."""
    if value.is_Atom:
        return value
    if isinstance(value, sympy.sin | sympy.cos | sympy.tan | sympy.cot | sympy.sec | sympy.csc):
        argument = value.args[0]
        if argument.free_symbols:
            if argument not in angles:
                acute = bool(argument.is_Symbol and argument.is_positive)
                kind = {"positive": True} if acute else {"real": True}
                # The same letters at every call: what was done with them before is remembered.
                number = len(angles)
                angles[argument] = MaskedAngle(
                    argument,
                    sympy.Dummy("sin", number, **kind),
                    sympy.Dummy("cos", number, **kind),
                    sympy.Dummy("tan", number, **kind),
                )
            angle = angles[argument]
            return {
                sympy.sin: angle.sine,
                sympy.cos: angle.cosine,
                sympy.tan: angle.tangent,
                sympy.cot: 1 / angle.tangent,
                sympy.sec: 1 / angle.cosine,
                sympy.csc: 1 / angle.sine,
            }[function_of(value)]
    if isinstance(value, Add | Mul):
        return value.func(*[_mask(argument, angles, masks) for argument in value.args])
    if isinstance(value, Pow) and isinstance(value.exp, Rational):
        return Pow(_mask(value.base, angles, masks), value.exp)
    if not value.free_symbols and all(
        isinstance(x, Rational | Add | Mul | Pow) for x in sympy.preorder_traversal(value)
    ):
        return value
    arguments = [tidy(argument) for argument in value.args]
    whole = value.func(*arguments) if tuple(arguments) != value.args else value
    if isinstance(whole, Add | Mul | Pow) or whole.is_Atom:
        return whole
    if whole not in masks:
        known: dict[str, bool] = {}
        if whole.is_positive:
            known["positive"] = True
        elif whole.is_real is not False:
            known["real"] = True
        masks[whole] = sympy.Dummy("f", len(masks), **known)
    return masks[whole]


def _restore(value: Expr, back: dict[Symbol, Expr]) -> Expr:
    """Masked parts put back without multiplying out a number in front of a sum."""
    if isinstance(value, Symbol):
        return back.get(value, value)
    if value.is_Atom or not (value.free_symbols & back.keys()):
        return value
    arguments = [_restore(argument, back) for argument in value.args]
    return rebuilt(value, arguments)


def _core(value: Expr, angles: tuple[MaskedAngle, ...]) -> Expr:
    """The best form of an algebraic expression in letters, roots and masked functions."""
    if value.is_Atom:
        return value
    if not value.free_symbols:
        return tidy_number(value)
    value = _tidy_roots(value, angles)
    back: dict[Symbol, Expr] = {}
    masked = mask_roots(value, back)
    if masked.is_Atom:
        return _restore(masked, back)
    if node_count(masked, SEARCHED) >= SEARCHED or terms_multiplied_out(masked) > EXPANDED:
        return _restore(factored(masked, False), back)
    present = [a for a in angles if masked.free_symbols & {a.sine, a.cosine, a.tangent}]
    # A root in a numerator or a denominator: both are tried, by multiplying by it above and below.
    best = with_angles(unrooted(masked, back), present)
    candidates = [best]
    above, below = sympy.fraction(best)
    for symbol in below.free_symbols & back.keys():
        square = square_of_root(back[symbol], back)
        if square is not None:
            candidates.append(factored(Mul(above, symbol) / (square * (below / symbol))))
    best = min(candidates, key=lambda candidate: _cost_restored(candidate, back))
    restored = _restore(best, back)
    for angle in present:
        restored = into_root(restored, angle)
    restored = divided_roots(restored)
    # As it was given may be much shorter, where it was collected by hand.
    if cost(value) < cost(restored) - (3 if has_fractions(value) else 1):
        if not isinstance(value, Add):
            return value
        terms = Add(*[_core(argument, angles) for argument in value.args])
        return terms if cost(terms) <= cost(value) else value
    return restored


def _cost_restored(value: Expr, back: dict[Symbol, Expr]) -> float:
    return cost(_restore(value, back))


def _tidy_roots(value: Expr, angles: tuple[MaskedAngle, ...]) -> Expr:
    """Every root's contents in best form, squares taken out; the innermost first."""
    spend()
    if value.is_Atom or not value.has(Pow):
        return value
    if isinstance(value, Pow) and isinstance(value.exp, Rational) and value.exp.q != 1:
        inside = _core(value.base, angles)
        if value.exp.q == 2:
            inside = over_a_square(inside)
            root = root_of(inside)
            return root if value.exp.p == 1 else Pow(root, value.exp.p)
        return Pow(inside, value.exp)
    arguments = [_tidy_roots(argument, angles) for argument in value.args]
    if isinstance(value, Mul):
        arguments = joined_roots(arguments)
    return value.func(*arguments) if tuple(arguments) != value.args else value


def _tidy_set(value: Any) -> Any:
    """A set of numbers with its ends in textbook form."""
    if isinstance(value, sympy.Interval):
        low, high = (tidy(end) for end in (value.start, value.end))
        return sympy.Interval(low, high, value.left_open, value.right_open)
    if isinstance(value, sympy.FiniteSet):
        return sympy.FiniteSet(*[tidy(argument) for argument in value.args])
    if isinstance(value, sympy.Union):
        return sympy.Union(*[_tidy_set(argument) for argument in value.args])
    return value
