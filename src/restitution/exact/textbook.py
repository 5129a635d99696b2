"""Expressions in the form that a textbook would print.

An expression is brought into several equivalent forms by the rules of `table`, and the one that is
least to read is taken (``cost``). Of equals the earlier wins. Letters stand for the functions of
angles and for roots meanwhile, so that what is left is algebra:

- in what is given, bars are undone; sines of sums of angles are tried as they are and expanded;
- what stands under each root is brought into its own form, and squares are taken out;
- the rest is factored, with common letters collected, and tried in the sine, cosine and tangent of
  one angle after the other;
- roots come back, and signs of sums are turned as they are read.
"""

from __future__ import annotations

from typing import Any

import sympy
from sympy import Add, Expr, Mul, Pow, Rational, Symbol

from restitution.exact.degrees import function_of, with_ratio
from restitution.exact.factors import factored
from restitution.exact.nodes import rebuilt
from restitution.exact.numbers import tidy_number
from restitution.exact.quotients import bars_again, sizes_in
from restitution.exact.roots import (
    has_fractions,
    mask_roots,
    root_of,
    square_of_root,
    unrooted,
)
from restitution.exact.rules import everywhere, improved, shortest
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
from restitution.exact.symbols import symbols_in
from restitution.exact.table import (
    AT_FIRST,
    GIVEN,
    IN_LETTERS,
    MULTIPLIED_IN,
    OF_ALL_ANGLES,
    OF_AN_ANGLE,
    PRODUCTS_OF_ROOTS,
    SIGNS,
    SUMS_OF_ANGLES,
    TWO_ANGLES,
    UNDER_ROOTS,
    WITH_ROOTS,
)
from restitution.exact.trigonometry import InOneAngle, MaskedAngle, masked_angles
from restitution.work import remembered, spend

# Of expressions in more angles than these no other forms are sought.
_MOST_ANGLES = 3


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
    expression = improved(AT_FIRST, expression)
    if not expression.free_symbols:
        return tidy_number(expression)
    if expression.has(sympy.Abs):
        expression = everywhere(GIVEN, expression)
        sizes = sizes_in(expression)
        if sizes:
            # u² is |u|²: what depends on sizes alone is tidied as if these were letters.
            form = _tidy(expression.xreplace(sizes))
            return form.xreplace(bars_again(sizes))
    forms = [_tidy_letters(expression)]
    if SUMS_OF_ANGLES.applies(expression):
        forms.append(_tidy_letters(SUMS_OF_ANGLES.rewrite(expression)))
    if isinstance(expression, Mul) and expression.has(sympy.Abs):
        forms.append(_with_bars(expression))
    form = everywhere(TWO_ANGLES, everywhere(SIGNS, min(forms, key=cost)))
    return _once_more(form)


def _once_more(value: Expr) -> Expr:
    """An expression with factors put together and all done again, where that is shorter."""
    for rule in (*PRODUCTS_OF_ROOTS, *MULTIPLIED_IN):
        if rule.applies(value) and (start := rule.rewrite(value)) != value:
            value = min(value, _tidy_letters(start), key=cost)
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


def _tidy_letters(expression: Expr) -> Expr:
    expression = improved(IN_LETTERS, expression)
    angles: dict[Expr, MaskedAngle] = {}
    masks: dict[Expr, Symbol] = {}
    core = _core(_mask(expression, angles, masks))
    back: dict[Symbol, Expr] = {symbol: value for value, symbol in masks.items()}
    for argument, angle in angles.items():
        back[angle.sine] = with_ratio(sympy.sin, argument)
        back[angle.cosine] = with_ratio(sympy.cos, argument)
        back[angle.tangent] = with_ratio(sympy.tan, argument)
    return _restore(core, back)


def _mask(value: Expr, angles: dict[Expr, MaskedAngle], masks: dict[Expr, Symbol]) -> Expr:
    """Functions replaced by letters, so that what is left is algebra."""
    if value.is_Atom:
        return value
    if isinstance(value, TRIGONOMETRIC) and value.args[0].free_symbols:
        return _mask_of_angle(value, angles)
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


def _mask_of_angle(value: Expr, angles: dict[Expr, MaskedAngle]) -> Expr:
    argument = value.args[0]
    if argument not in angles:
        acute = bool(argument.is_Symbol and argument.is_positive)
        angles[argument] = MaskedAngle.numbered(len(angles), acute)
    angle = angles[argument]
    return {
        sympy.sin: angle.sine,
        sympy.cos: angle.cosine,
        sympy.tan: angle.tangent,
        sympy.cot: 1 / angle.tangent,
        sympy.sec: 1 / angle.cosine,
        sympy.csc: 1 / angle.sine,
    }[function_of(value)]


def _restore(value: Expr, back: dict[Symbol, Expr]) -> Expr:
    """Masked parts put back without multiplying out a number in front of a sum."""
    if isinstance(value, Symbol):
        return back.get(value, value)
    if value.is_Atom or not (symbols_in(value) & back.keys()):
        return value
    arguments = [_restore(argument, back) for argument in value.args]
    return rebuilt(value, arguments)


def _core(value: Expr) -> Expr:
    """The best form of an algebraic expression in letters, roots and masked functions."""
    if value.is_Atom:
        return value
    if not value.free_symbols:
        return tidy_number(value)
    value = _tidy_roots(value)
    back: dict[Symbol, Expr] = {}
    masked = mask_roots(value, back)
    if masked.is_Atom:
        return _restore(masked, back)
    if node_count(masked, SEARCHED) >= SEARCHED or terms_multiplied_out(masked) > EXPANDED:
        return _restore(factored(masked, False), back)
    best = _with_angles(unrooted(masked, back), masked_angles(masked))
    restored = improved(WITH_ROOTS, _restore(_with_roots_above(best, back), back))
    # As it was given may be much shorter, where it was collected by hand.
    if cost(value) < cost(restored) - (3 if has_fractions(value) else 1):
        if not isinstance(value, Add):
            return value
        terms = Add(*[_core(argument) for argument in value.args])
        return terms if cost(terms) <= cost(value) else value
    return restored


def _with_angles(value: Expr, angles: list[MaskedAngle]) -> Expr:
    """The shortest of the forms that differ in how sines, cosines and tangents are used."""
    best = factored(value)
    if len(angles) > _MOST_ANGLES:
        return best
    for angle in angles:
        form, before = shortest(OF_AN_ANGLE, InOneAngle(best, angle)), best
        while form != before:
            # A square of squares has become one square: 1 − sin²α in it is seen now.
            form, before = shortest(OF_AN_ANGLE, InOneAngle(form, angle)), form
        best = form
    return improved(OF_ALL_ANGLES, best)


def _with_roots_above(best: Expr, back: dict[Symbol, Expr]) -> Expr:
    """A masked root below the line multiplied away, above and below, where that is shorter."""
    candidates = [best]
    above, below = sympy.fraction(best)
    for symbol in below.free_symbols & back.keys():
        square = square_of_root(back[symbol], back)
        if square is not None:
            candidates.append(factored(Mul(above, symbol) / (square * (below / symbol))))
    return min(candidates, key=lambda candidate: _cost_restored(candidate, back))


def _cost_restored(value: Expr, back: dict[Symbol, Expr]) -> float:
    return cost(_restore(value, back))


def _tidy_roots(value: Expr) -> Expr:
    """Every root's contents in best form, squares taken out; the innermost first."""
    spend()
    if value.is_Atom or not value.has(Pow):
        return value
    if isinstance(value, Pow) and isinstance(value.exp, Rational) and value.exp.q != 1:
        inside = _core(value.base)
        if value.exp.q == 2:
            root = root_of(improved(UNDER_ROOTS, inside))
            return root if value.exp.p == 1 else Pow(root, value.exp.p)
        return Pow(inside, value.exp)
    arguments = [_tidy_roots(argument) for argument in value.args]
    if tuple(arguments) != value.args:
        value = value.func(*arguments)
    return improved(PRODUCTS_OF_ROOTS, value)


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
