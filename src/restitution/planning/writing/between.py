"""What stands between a definition with values put in and what that comes to.

A step works squares out, or puts terms over one denominator, or puts them together in factors: a
line that did it all at once would not be followed by a reader. So there are lines between:

- of numbers with roots, the same with each square worked out;
- of sums of letters, the terms in their order, with what they have in common in front;
- of long sums, each difference of two squares as a product;
- the terms collected, where they are many, or where a sum still cancels.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TypeGuard

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    has_quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.planning.writing.forms import (
    ONE,
    TWO,
    factors,
    negative,
    number,
    outer_terms,
    product,
    square,
    total,
    tree_of,
)
from restitution.planning.writing.one_fraction import over_one_line
from restitution.planning.writing.polynomials import cancelled, expanded, one_fraction
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass

# So many squares of sums are worked out in one step.
_AT_ONCE = 1
# Longer brackets are no help to a reader.
_LONGEST = 120
# The square of a longer sum is not multiplied out: the difference of two squares is a product.
_TERMS_SQUARED = 3
# So many terms are collected and factorised in one step.
_COLLECTED = 3


def terms_between(scene: Scene, right: Expression, final: Expression) -> tuple[Expression, ...]:
    """The lines between a definition and its value; none where that is one step."""
    if _keeps_squares(scene, right, final):
        return ()
    both = _of_both_squares(scene, right, final)
    if both is not None:
        return (both,)
    match right, final:
        case Apply("sqrt", inside), Apply("sqrt", value):
            return tuple(Apply("sqrt", term) for term in terms_between(scene, inside, value))
        case Apply("sqrt", inside), _ if _has_surds_squared(inside):
            if len({node for node in walk(inside) if is_square(node)}) == 1:
                return ()  # x√2
            inner = tuple(Apply("sqrt", term) for term in terms_between(scene, inside, final))
            return (*inner, *root_of_a_square(scene, final))
    if has_quantity(right):
        return ()
    try:
        lines = _between(scene, right, final)
    except (RestitutionError, TypeError, ValueError, sp.PolynomialError):
        return ()
    kept: list[Expression] = []
    for tree in lines:
        if tree in (right, final, *kept) or len(walk(tree)) > _LONGEST:
            continue
        kept.append(tree)
    return tuple(kept)


def _keeps_squares(scene: Scene, right: Expression, final: Expression) -> bool:
    """Whether a root has the squares of sums of another, with a common factor taken out."""
    if not is_function(right, "sqrt"):
        return False
    own = [_primitive(scene, node.left) for node in walk(right) if _is_square_of_sum(node)]
    kept = [_primitive(scene, node.left) for node in walk(final) if _is_square_of_sum(node)]
    return bool(own) and all(value in kept or expanded(-value) in kept for value in own)


def _of_both_squares(scene: Scene, right: Expression, final: Expression) -> Expression | None:
    """u√(64 cos²α + 9 sin²α)/24 for √((⅛u sin α)² + (⅓u cos α)²), before sin² + cos² = 1 is used.

    So of the sum of both squares itself. None where there is nothing to take out, or a root of it.
    """
    inside = right.argument if is_function(right, "sqrt") else right
    match inside:
        case Binary("+", Binary("^") as one_square, Binary("^") as other_square) if not (
            has_quantity(inside) or len(_ratios(inside)) <= len(_ratios(final))
        ):
            terms = [scene.scalar(one_square), scene.scalar(other_square)]
        case _:
            return None
    (one, first), (other, second) = (
        term.as_independent(sp.sin, sp.cos, as_Add=False) for term in terms
    )
    ratio = cancelled(one / other)
    if not ratio.is_Rational or ratio == 1:
        return None
    outside = sp.sqrt(cancelled(one / ratio.p))
    if outside == 1 or not all(power.exp.is_Integer for power in outside.atoms(sp.Pow)):
        return None
    both = ratio.p * first + ratio.q * second
    value = outside**2 * both if inside is right else outside * sp.sqrt(both)
    return tree_of(value, as_it_is=True)


def _ratios(tree: Expression) -> set[Expression]:
    """The sines and cosines of letters in a tree."""
    return {node for node in walk(tree) if is_function(node, "sin", "cos") and letters(node)}


def root_of_a_square(scene: Scene, value: Expression) -> tuple[Expression, ...]:
    """The root of the square of a value that is a sum of roots, multiplied out and as a square."""
    if not any(_is_surd(base) for base in _bases(value)):
        return ()
    whole = sp.sympify(scene.scalar(value), strict=True)
    own = _primitive(scene, value)
    ratio, rest = cancelled(whole**2 / own**2).as_coeff_Mul()
    above = product(number(ratio.p), tree_of(expanded(own**2), as_it_is=True), tree_of(rest))
    worked = above if ratio.q == 1 else Binary("/", above, number(ratio.q))
    return Apply("sqrt", worked), Apply("sqrt", square(value))


def _between(scene: Scene, right: Expression, final: Expression) -> list[Expression]:
    if _has_surds_squared(right):
        return [_with_squares(scene, right)] if sum(1 for _ in _terms(right)) > 1 else []
    squares = sum(map(_is_square_of_sum, walk(right)))
    if not squares:
        return _collected(scene, right, final) or [*over_one_line(scene, right, final)]
    if squares <= _AT_ONCE:
        return []
    terms = [_Term.of(scene, term) for term in _terms(right)]
    kept = {_primitive(scene, node.left) for node in walk(final) if _is_square_of_sum(node)} - {1}
    if squares - sum(term.base in kept for term in terms) <= _AT_ONCE:
        return []
    if not all(term.is_short for term in terms):
        return _in_products(scene, right)
    return _in_terms(terms, sp.sympify(scene.scalar(final), strict=True)) or [
        _with_squares(scene, right)
    ]


def _collected(scene: Scene, right: Expression, final: Expression) -> list[Expression]:
    """Many terms over one denominator, where their value is a product of sums."""
    sums = [base for base in _bases(final) if _is_sum(base) or _is_square_of_sum(base)]
    if len(sums) < _AT_ONCE + 1 or sum(1 for _ in _terms(right)) == 1:
        return []
    above, below = sp.fraction(sp.factor(sp.sympify(scene.scalar(right), strict=True)))
    factor = sp.Mul(*(factor for factor in sp.Mul.make_args(above) if not _has_sum(factor)))
    whole = expanded(cancelled(above / factor))
    if below.free_symbols or len(whole.args) <= _COLLECTED:
        return []
    if factor.as_coeff_Mul()[0].is_negative:
        factor, whole = -factor, -whole
    inside, line = total(map(_term, _parts(whole))), _is_over_a_number(final)
    return [_put_together(factor, inside, below, line=line)]


def _terms(tree: Expression, factor: tuple[Expression, ...] = ()) -> Iterator[Expression]:
    """The terms of a sum, with brackets of squares multiplied out: m(x² − y²) is mx² and −my²."""
    match tree:
        case Negate(operand):
            for term in _terms(operand, factor):
                yield negative(term)
        case Binary("+" | "-" as op, left, right):
            yield from _terms(left, factor)
            for term in _terms(right, factor):
                yield term if op == "+" else negative(term)
        case Binary("*", left, Binary("+" | "-") as right):
            yield from _terms(right, (*factor, left))
        case _:
            yield product(*factor, tree)


@dataclass(frozen=True)
class _Term:
    """A term of a sum: a factor, and the square of a sum that goes with it (1 without one)."""

    factor: sp.Expr
    base: sp.Expr

    @classmethod
    def of(cls, scene: Scene, tree: Expression) -> _Term:
        """A term by its tree."""
        sums = [factor for factor in factors(tree) if _is_square_of_sum(factor)]
        whole = sp.sympify(scene.scalar(tree), strict=True)
        if len(sums) != 1:
            return cls(whole, sp.Integer(1))
        base = _primitive(scene, sums[0].left)
        return cls(cancelled(whole / base**2), base)

    @property
    def is_short(self) -> bool:
        """Whether the square is multiplied out in the head."""
        return len(sp.Add.make_args(expanded(self.base**2))) <= _TERMS_SQUARED


def is_square(tree: Expression) -> TypeGuard[Binary]:
    """Whether a tree is the square of something."""
    return is_binary(tree, "^") and tree.right == TWO


def _is_square_of_sum(tree: Expression) -> TypeGuard[Binary]:
    """Whether it is the square of what has a sum with letters as a factor."""
    return is_square(tree) and any(map(_is_sum, _bases(tree.left)))


def _bases(tree: Expression) -> Iterator[Expression]:
    """The factors of a product or a quotient."""
    match tree:
        case Negate(operand):
            yield from _bases(operand)
        case Binary("*" | "/", left, right):
            yield from _bases(left)
            yield from _bases(right)
        case _:
            yield tree


def _is_sum(tree: Expression) -> bool:
    return is_binary(tree, "+", "-") and bool(letters(tree))


def _primitive(scene: Scene, tree: Expression) -> sp.Expr:
    """The sums that are factors of a tree above the line."""
    value = sp.factor_terms(sp.sympify(scene.scalar(tree), strict=True))
    return sp.Mul(*(factor for factor in sp.Mul.make_args(value) if factor.is_Add))


# --- numbers with roots -------------------------------------------------------------------------


def _has_surds_squared(tree: Expression) -> bool:
    """Whether sums of numbers with roots are squared, and no sums of letters."""
    squares = [node for node in walk(tree) if is_square(node)]
    return any(map(_surds_of, squares)) and not any(map(_is_square_of_sum, squares))


def _surds_of(square: Expression) -> bool:
    return any(map(_is_surd, walk(square)))


def _is_surd(tree: Expression) -> bool:
    """Whether it is a sum of numbers with roots."""
    return (
        is_binary(tree, "+", "-")
        and not letters(tree)
        and any(is_function(node, "sqrt") for node in walk(tree))
    )


def _with_squares(scene: Scene, tree: Expression) -> Expression:
    """A tree with each square worked out."""

    def change(tree: Expression) -> Expression:
        if not is_square(tree):
            return tree
        whole = sp.sympify(scene.scalar(tree), strict=True)
        own = _primitive(scene, tree.left)
        value, others = own**2, cancelled(whole / own**2)
        if not own.free_symbols:
            value, others = sp.factor_terms(expanded(whole)).as_independent(
                *whole.free_symbols, as_Add=False
            )
        elif others != 1:
            ratio, rest = others.as_coeff_Mul()
            above = product(number(ratio.p), tree_of(rest), total(map(_term, _parts(own**2))))
            return above if ratio.q == 1 else Binary("/", above, number(ratio.q))
        value = expanded(value)
        below = sp.ilcm(1, *(term.as_coeff_Mul()[0].q for term in sp.Add.make_args(value)))
        above = product(tree_of(expanded(value * below), as_it_is=True), tree_of(others))
        return above if below == 1 else Binary("/", above, number(int(below)))

    return rebuilt(tree, change)


# --- sums of letters ----------------------------------------------------------------------------


def _in_terms(terms: list[_Term], final: sp.Expr) -> list[Expression]:
    """The common factor of all terms, and in brackets what is left of them, in their order."""
    fractions = [sp.fraction(one_fraction(term.factor)) for term in terms]
    below = sp.factor(sp.lcm_list([expanded(value) for _, value in fractions]))
    above = [top * sp.factor(cancelled(below / bottom)) for top, bottom in fractions]
    common = sp.factor(sp.gcd_list([expanded(value) for value in above]))
    factor = sp.Mul(*(factor for factor in sp.Mul.make_args(common) if not _has_sum(factor)))
    rest = [sp.factor(cancelled(value / factor)) for value in above]
    shared = sp.ilcm(1, *(sp.Rational(value.as_coeff_Mul()[0]).q for value in rest))
    below, rest = below * shared, [value * shared for value in rest]
    inside = total(
        _multiplied(value, term.base, first=not n)
        for n, (value, term) in enumerate(zip(rest, terms, strict=True))
    )
    whole = sp.Add(*(value * term.base**2 for value, term in zip(rest, terms, strict=True)))
    if not factor.free_symbols and not below.free_symbols:
        return []  # the squares are worked out where they stand
    # A number below has the place that it has in the value.
    line = _is_over_a_number(tree_of(final))
    lines = [_put_together(factor, inside, below, line=line)]
    collected = expanded(whole)
    if not _divisors(below) <= _divisors(sp.fraction(one_fraction(final))[1]):
        above_ = tree_of(sp.factor(factor * collected))
        lines.append(Binary("/", above_, tree_of(below)))
    elif len(sp.Add.make_args(collected)) > _COLLECTED and not below.free_symbols:
        lines.append(_put_together(factor, total(map(_term, _parts(collected))), below, line=line))
    return lines


def _multiplied(factor: sp.Expr, base: sp.Expr, first: bool) -> Expression:
    """A term with its square multiplied out; in brackets, unless it is added and has no factor."""
    square = total(_term(part) for part in _parts(base**2))
    number_, rest = factor.as_coeff_Mul()
    if base == 1:
        return _term(factor)
    front = tree_of(abs(number_) * rest, as_it_is=True)
    whole = square if front == ONE else _beside(front, square)
    return Negate(whole) if number_ < 0 else whole


def _beside(front: Expression, bracket: Expression) -> Expression:
    """A factor and a bracket: ratios of angles stand behind it."""
    own = list(factors(front))
    ratios = [tree for tree in own if any(isinstance(node, Apply) for node in walk(tree))]
    return product(*(tree for tree in own if tree not in ratios), bracket, *ratios)


def _put_together(
    factor: sp.Expr, inside: Expression, below: sp.Expr, *, line: bool = False
) -> Expression:
    """A factor, a bracket, and what stands below them; with a ``line``, below that."""
    number_, letters_ = factor.as_coeff_Mul()
    front = tree_of(letters_)
    if not below.free_symbols and letters_ != 1 and not line:
        return _beside(product(tree_of(number_ / below), front), inside)
    whole = _beside(product(tree_of(number_), front), inside)
    return whole if below == 1 else Binary("/", whole, tree_of(below))


def _is_over_a_number(tree: Expression) -> bool:
    """Whether a number stands below all that a tree has."""
    return is_binary(tree, "/") and not letters(tree.right)


def _divisors(below: sp.Expr) -> set[sp.Expr]:
    """The sums that stand below a line, with their powers."""
    return {factor for factor in sp.Mul.make_args(below) if _has_sum(factor)}


def _has_sum(factor: sp.Expr) -> bool:
    return bool(factor.as_base_exp()[0].is_Add)


def _parts(value: sp.Expr) -> Iterable[sp.Expr]:
    """The terms of a product of sums, those of the lowest degree first."""

    def degree(term: sp.Expr) -> tuple[int, object]:
        powers = term.as_powers_dict()
        return sum(int(powers[s]) for s in term.free_symbols), sp.default_sort_key(term)

    return sorted(sp.Add.make_args(expanded(value)), key=degree)


def _term(value: sp.Expr) -> Expression:
    number_, rest = value.as_coeff_Mul()
    tree = tree_of(abs(number_) * rest, as_it_is=True)
    return Negate(tree) if number_ < 0 else tree


# --- differences of squares ---------------------------------------------------------------------


def _in_products(scene: Scene, tree: Expression) -> list[Expression]:
    """Each difference of two squares as a product, and then what these have in common in front."""
    terms = list(outer_terms(tree))
    values = [sp.sympify(scene.scalar(term), strict=True) for term in terms]
    parts = [sp.fraction(sp.factor(value)) for value in values]
    below = sp.factor(sp.lcm_list([bottom for _, bottom in parts]))
    above = [cancelled(top * below / bottom) for top, bottom in parts]
    common = sp.factor(sp.gcd_list(above))
    sums = [factor for factor in sp.Mul.make_args(common) if _has_sum(factor)]
    if not sums:
        return []
    rest = total(_signed(cancelled(value / common)) for value in above)
    whole = product(*factors(tree_of(common)), rest)
    last = whole if below == 1 else Binary("/", whole, tree_of(below))
    sum_ = sp.Mul(*sums) / below
    return [total(_as_product(scene, term, sum_) for term in terms), last]


def _signed(value: sp.Expr) -> Expression:
    """A sum with its sign in front of it."""
    whole = sp.factor_terms(value)
    return negative(tree_of(-whole)) if whole.as_coeff_Mul()[0].is_negative else tree_of(whole)


def _as_product(scene: Scene, tree: Expression, common: sp.Expr) -> Expression:
    """A term, k(x² − y²) as k(x − y)(x + y): first the multiple of what is common."""
    if isinstance(tree, Negate):
        return negative(_as_product(scene, tree.operand, common))
    *front, bracket = factors(tree)
    match bracket:
        case Binary("-", left, right) if is_square(left) and is_square(right):
            x, y = (sp.sympify(scene.scalar(node.left), strict=True) for node in (left, right))
            one, other = sp.factor(x - y), sp.factor(x + y)
            ratio = cancelled(one / common)
            if any(map(_has_sum, sp.Mul.make_args(sp.fraction(sp.factor(ratio))[1]))):
                one, other = other, one
            if sp.factor_terms(cancelled(one / common)).as_coeff_Mul()[0].is_negative:
                one, other = -one, -other
            bottoms = [sp.fraction(one_fraction(value))[1] for value in (one, other)]
            if not any(value.free_symbols for value in bottoms):
                return product(*front, tree_of(one), tree_of(other))
            lead = sp.sympify(scene.scalar(product(*front)), strict=True) * one * bottoms[0]
            ratio, lead = sp.factor(cancelled(lead)).as_coeff_Mul()
            tops = (number(ratio.p), tree_of(lead), tree_of(cancelled(other * bottoms[1])))
            whole = product(*(factor for top in tops for factor in factors(top)))
            return Binary("/", whole, tree_of(ratio.q * sp.Mul(*bottoms)))
    return tree


__all__ = ["terms_between"]


def with_squares_out(value: sp.Expr) -> Expression:
    """A product in which the square of a sum of sines and cosines is multiplied out.

    So that *cos²θ + 2 sin θ cos θ + sin²θ* is seen, which identities make shorter.
    """
    factors = sp.Mul.make_args(value)
    squares = [
        factor
        for factor in factors
        if factor.is_Pow and factor.exp == 2 and factor.base.is_Add and factor.has(sp.sin, sp.cos)
    ]
    if len(squares) != 1:
        return tree_of(value)
    (own,) = squares
    stand_in = sp.Dummy("square", positive=True)
    whole = tree_of(value.xreplace({own: stand_in}))
    return exchanged(whole, {Letter(stand_in.name): tree_of(expanded(own), as_it_is=True)})
