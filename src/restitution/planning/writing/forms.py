"""Trees of the lines of a working: from values in their textbook form, and put together."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import lru_cache
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import function_of, with_ratio
from restitution.exact.symbols import atoms_in, expression_of, symbols_in
from restitution.explaining.lines.trees import compounds_rebuilt, rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Negate,
    Number,
    Pi,
    Unit,
    functions_in,
    has_quantity,
    is_binary,
    is_function,
    is_zero,
    letters,
    plain_letter,
    unsigned,
    walk,
)
from restitution.planning.writing.polynomials import cancelled
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.work import remembered

ZERO = Number(Fraction(0))
ONE = Number(Fraction(1))
TWO = Number(Fraction(2))


class UnwrittenError(Exception):
    """A value has no form in which a line could say it."""


def number(value: int | Fraction) -> Expression:
    """A rational number as a tree."""
    exact = Fraction(value)
    if exact < 0:
        return Negate(number(-exact))
    if exact.denominator == 1:
        return Number(exact)
    return Binary("/", Number(Fraction(exact.numerator)), Number(Fraction(exact.denominator)))


def neat(value: Any) -> Any:
    """A value in its usual form, in which ratios of 2θ and ½θ are not written by those of θ.

    Nor are those of 50° and 80° by others.
    """
    own = expression_of(value)
    multiples = {
        atom.args[0]
        for atom in atoms_in(own, sp.sin, sp.cos, sp.tan)
        if not atom.args[0].is_Symbol and len(atom.args[0].free_symbols) <= 1
    }
    if not multiples:
        return tidy(own)
    if (one := _of_one_ratio(own)) is not None:
        return one
    if _is_over_a_sum(own):
        return tidy(own)  # a quotient of components stays as they stand
    names = {
        multiple: sp.Dummy("angle", number, positive=True)
        for number, multiple in enumerate(sorted(multiples, key=sp.default_sort_key))
    }
    functions = {
        atom: function_of(atom)(names[atom.args[0]])
        for atom in atoms_in(own, sp.sin, sp.cos, sp.tan)
        if atom.args[0] in names
    }
    back = {dummy: angle for angle, dummy in names.items()}
    whole = tidy(own.xreplace(functions))
    ratios = {
        atom: with_ratio(function_of(atom), back[atom.args[0]])
        for atom in atoms_in(whole, sp.sin, sp.cos, sp.tan)
        if atom.args[0] in back
    }
    return _with_tangents(_with_contents_out(whole.xreplace(ratios).xreplace(back)))


def _with_contents_out(value: Any) -> Any:
    """√(49 − 25 cos² 25°)/7, and not √(2(98 − 50 cos² 25°))/14."""
    roots: dict[sp.Expr, sp.Expr] = {}
    for power in value.atoms(sp.Pow) if isinstance(value, sp.Expr) else ():
        if power.exp == sp.Rational(1, 2) and power.base.is_Add and power.base.has(sp.sin, sp.cos):
            content, rest = power.base.primitive()
            roots[power] = sp.sqrt(content) * sp.sqrt(rest)
    return value.xreplace(roots) if roots else value


def _of_one_ratio(value: sp.Expr) -> sp.Expr | None:
    """A sum of ratios of degrees that is a multiple of one: 3.4 cos 40°, of 65° and of 25°."""
    ratios = value.atoms(sp.sin, sp.cos)
    if not value.is_Add or len(ratios) < 2 or any(ratio.free_symbols for ratio in ratios):
        return None
    plain = sp.sympify(tidy(value), strict=True)
    is_one = not plain.is_Add and len(plain.atoms(sp.sin, sp.cos)) <= 1
    return plain if is_one else None


def _is_over_a_sum(value: sp.Expr) -> bool:
    """Whether a number is a ratio of degrees over a sum of such ratios alone."""
    above, below = value.as_numer_denom() if not value.free_symbols else (value, value)
    terms = sp.Add.make_args(below)
    return (
        not above.has(sp.Add)
        and len(terms) > 1
        and all(len(term.atoms(sp.sin, sp.cos)) == 1 for term in terms)
        and all(not atom.args[0].free_symbols for atom in value.atoms(sp.sin, sp.cos))
    )


def _with_tangents(value: Any) -> Any:
    """Tan 26° for sin 26°/cos 26°, in products of numbers."""
    if not isinstance(value, sp.Expr) or value.is_Atom:
        return value
    if not any(not cosine.free_symbols for cosine in value.atoms(sp.cos)):
        return value
    if not isinstance(value, sp.Mul):
        return value.func(*map(_with_tangents, value.args))
    powers = value.as_powers_dict()
    for sine in [power for power in powers if isinstance(power, sp.sin) and not power.free_symbols]:
        cosine = sp.cos(sine.args[0])
        if powers[sine] * powers.get(cosine, 0) == -1:
            tangent = sp.tan(sine.args[0], evaluate=False)
            value = value / sine ** powers[sine] / cosine ** powers[cosine]
            value = value * tangent ** powers[sine]
    return value


def tree_of(value: Any, *, angle: bool = False, as_it_is: bool = False) -> Expression:
    """The tree of a value, with its terms and factors in the order that textbooks use.

    A vector has its components with **i** and **j**; an ``angle`` is in degrees. Raises
    UnwrittenError where a line cannot say the value.
    """
    if isinstance(value, Vector | tuple):
        return vector(*(tree_of(other, as_it_is=as_it_is) for other in value))
    return _tree_of(expression_of(value), angle, as_it_is)


@remembered(4096)
def _tree_of(own: sp.Expr, angle: bool, as_it_is: bool) -> Expression:
    if own.has(sp.zoo, sp.nan):
        raise UnwrittenError(own)
    if angle and own.has(sp.pi) and own.free_symbols:
        # 90° − α, and no fraction with π above
        own, as_it_is = sp.expand_mul(own, deep=False), True
        inverses = own.atoms(sp.asin, sp.acos, sp.atan)
        own = own.xreplace(
            {inverse: inverse.func(*map(neat, inverse.args)) for inverse in inverses}
        )
    own = own if as_it_is else neat(own)
    names = {_parted(symbol.name): symbol.name for symbol in own.free_symbols}
    return _from_layout(lay.from_sympy(own, degrees=angle), names)


def in_tangents(value: sp.Expr) -> sp.Expr:
    """A quotient with sine over cosine as the tangent."""
    for ratio in atoms_in(value, sp.sin):
        (argument,) = ratio.args
        cosine = with_ratio(sp.cos, argument)
        put = cancelled(value.subs(ratio, sp.Symbol("_t") * cosine))
        if not put.has(cosine):
            value = put.subs(sp.Symbol("_t"), with_ratio(sp.tan, argument))
    return value


def _parted(name: str) -> tuple[str, str]:
    symbol = lay.letter(name)
    return symbol.name, symbol.subscript


def _from_layout(layout: Any, names: dict[tuple[str, str], str]) -> Expression:
    def of(layout: Any) -> Expression:
        return _from_layout(layout, names)

    match layout:
        case lay.Number(digits):
            return Number(Fraction(digits))
        case lay.Letter("pi", ""):
            return Pi()
        case lay.Letter(name, subscript):
            return plain_letter(names.get((name, subscript), name))
        case lay.Sum(terms):
            return _sum_of([(sign, of(layout)) for sign, layout in terms])
        case lay.Product(factors):
            return product(*(of(factor) for factor in factors))
        case lay.Fraction(above, below):
            return Binary("/", of(above), of(below))
        case lay.Root(inside, 2):
            return Apply("sqrt", of(inside))
        case lay.Root(inside, index):
            return Binary("^", of(inside), Binary("/", ONE, Number(Fraction(index))))
        case lay.Power(base, exponent):
            return Binary("^", of(base), of(exponent))
        case lay.Function(name, argument, exponent):
            applied = Apply(name, of(argument))
            return applied if exponent is None else Binary("^", applied, of(exponent))
        case lay.Brackets(inside, "||"):
            return Apply("abs", of(inside))
        case lay.Brackets(inside):
            return of(inside)
        case lay.Degrees(inside):
            match of(inside):
                case Number(value):
                    return Degrees(value)
                case Binary("/", Number(whole), Number(part)):
                    return Degrees(whole / part)
    raise UnwrittenError(layout)


def _sum_of(terms: list[tuple[str, Expression]]) -> Expression:
    (sign, first), *rest = terms
    total = first if sign == "+" else Negate(first)
    for sign, tree in rest:
        total = Binary("+" if sign == "+" else "-", total, tree)
    return total


# --- putting together --------------------------------------------------------------------------


def product(*factors: Expression) -> Expression:
    """Factors side by side: without ones, with its sign in front, and 0 if one of them is 0."""
    minus = False
    kept: list[Expression] = []
    for factor in factors:
        while isinstance(factor, Negate):
            minus, factor = not minus, factor.operand
        if is_zero(factor):
            return ZERO
        if not is_one(factor):
            kept.append(factor)
    if not any(map(_begins_with_a_number, kept)):
        kept.sort(key=lambda tree: not is_rational(tree))  # 2w, not w × 2; but 2m × 4/3
    total: Expression = kept[0] if kept else ONE
    for factor in kept[1:]:
        total = Binary("*", total, factor)
    return Negate(total) if minus else total


def multiple(value: sp.Expr, tree: Expression) -> Expression:
    """A value times a tree, and the tree itself where that is 1."""
    return tree if value == 1 else product(tree_of(value), tree)


def is_one(tree: Expression) -> bool:
    """Whether a tree is the number 1."""
    return type(tree) is Number and tree.value == 1


def _begins_with_a_number(tree: Expression) -> bool:
    """Whether a tree is a product, or a quotient, of a number and something else: ``2m``."""
    match tree:
        case Binary("*" | "/", left) if not is_rational(tree):
            return is_rational(left) or _begins_with_a_number(left)
    return False


def is_rational(tree: Expression) -> bool:
    """Whether a tree is a number or a fraction of two."""
    match tree:
        case Number() | Binary("/", Number(), Number()):
            return True
    return False


def factors(tree: Expression) -> list[Expression]:
    """The factors of a product, however they are bracketed; its sign is one."""
    if isinstance(tree, Negate):
        return [Negate(ONE), *factors(tree.operand)]
    if is_binary(tree, "*"):
        return [*factors(tree.left), *factors(tree.right)]
    return [tree]


def factors_above(tree: Expression) -> Iterator[Expression]:
    """The factors of a product, and of what stands above in a quotient, but for a sign."""
    match tree:
        case Binary("*", left, right):
            yield from factors_above(left)
            yield from factors_above(right)
        case Binary("/", above, _):
            yield from factors_above(above)
        case Negate(operand):
            yield from factors_above(operand)
        case _:
            yield tree


def total(terms: Iterable[Expression]) -> Expression:
    """Terms added up: zeros are left out, what is negative is subtracted."""
    own: Expression | None = None
    for term in terms:
        if is_zero(term):
            continue
        if own is None:
            own = term
        elif isinstance(term, Negate):
            own = Binary("-", own, term.operand)
        else:
            own = Binary("+", own, term)
    return ZERO if own is None else own


def outer_terms(tree: Expression) -> Iterator[Expression]:
    """The terms of a sum as they stand, each with its sign."""
    match tree:
        case Negate(operand):
            yield from map(negative, outer_terms(operand))
        case Binary("+" | "-" as op, left, right):
            yield from outer_terms(left)
            yield from outer_terms(right) if op == "+" else map(negative, outer_terms(right))
        case _:
            yield tree


def negative(tree: Expression) -> Expression:
    """A tree with the other sign."""
    if is_zero(tree):
        return tree
    if isinstance(tree, Negate):
        return tree.operand
    return Negate(tree)


def opposite(tree: Expression, *, as_it_stands: bool = False) -> Expression:
    """A tree with the other sign, which each term has: 5 − 2 × 2 for −5 + 2 × 2.

    The terms of a sum stay ``as_it_stands``; else one that is added comes first.
    """
    match tree:
        case Negate(operand):
            return operand
        case Binary("+" | "-", left, right):
            terms = [opposite(left, as_it_stands=as_it_stands), right]
            if tree.op == "+":
                terms[1] = opposite(right, as_it_stands=as_it_stands)
            if not as_it_stands and isinstance(terms[0], Negate):
                terms.sort(key=lambda term: isinstance(term, Negate))
            return total(terms)
        case Binary("/", above, below) if _has_terms(above):
            return swept(Binary("/", opposite(above, as_it_stands=as_it_stands), below))
        case Binary("*", first, second) if _has_terms(second):
            return product(first, opposite(second, as_it_stands=as_it_stands))
        case Binary("*", first, second) if _has_terms(first):
            return product(opposite(first, as_it_stands=as_it_stands), second)
    return negative(tree)


def _has_terms(tree: Expression) -> bool:
    """Whether a tree is a sum, or one over a number."""
    match tree:
        case Binary("+" | "-"):
            return True
        case Binary("/", above, _):
            return _has_terms(above)
    return False


def difference(left: Expression, right: Expression) -> Expression:
    """One less another; a sum that is taken away stands in brackets."""
    if is_zero(right):
        return left
    if is_zero(left):
        return negative(right)
    if isinstance(right, Negate):
        return Binary("+", left, right.operand)
    return Binary("-", left, right)


def vector(x: Expression, y: Expression) -> Expression:
    """``x i + y j``, without a part that is 0."""
    return total((product(x, Unit("i")), product(y, Unit("j"))))


def coordinates(tree: Expression) -> tuple[Expression, Expression] | None:
    """What stands with **i** and with **j** in ``x i + y j``; None of another tree."""
    match tree:
        case Unit(axis):
            return (ONE, ZERO) if axis == "i" else (ZERO, ONE)
        case Negate(operand):
            own = coordinates(operand)
            return None if own is None else (negative(own[0]), negative(own[1]))
        case Binary("*", size, Unit(axis)):
            return (size, ZERO) if axis == "i" else (ZERO, size)
        case Binary("+" | "-" as op, left, right):
            one, other = coordinates(left), coordinates(right)
            if one is None or other is None:
                return None
            join = difference if op == "-" else lambda a, b: total((a, b))
            return join(one[0], other[0]), join(one[1], other[1])
    return None


def square(tree: Expression) -> Expression:
    """A tree squared, with the sign in which its value is positive: (2√3 − 3)²."""
    if isinstance(tree, Negate):
        tree = tree.operand
    if is_zero(tree):
        return tree
    if any(is_function(e, "sqrt") for e in walk(tree)):
        tree = _positive(tree)
    return Binary("^", tree, Number(Fraction(2)))


def _positive(tree: Expression) -> Expression:
    """The value of a tree with the other sign, if it is negative and the tree is no more."""
    if has_quantity(tree):
        return tree
    value = sp.sympify(in_letters(tree, positive=True), strict=True)
    return tree_of(-value) if value.is_negative and tree == tree_of(value) else tree


def swept(tree: Expression) -> Expression:
    """A tree without terms that are 0, factors that are 1, and signs that cancel.

    Nothing is multiplied out and no numbers are put together.
    """

    def change(tree: Expression) -> Expression:
        match tree:
            case Negate(operand):
                return negative(operand)
            case Binary("*", left, right):
                return product(_one_fraction(left), right)
            case Binary("+", left, right):
                return total((left, right))
            case Binary("-", left, right):
                return difference(left, right)
            case Binary("/", left, right):
                return _quotient(left, right)
            case Binary("^", left, right):
                if is_one(right):
                    return left
                return square(left) if type(right) is Number and right.value == 2 else tree
        return tree

    return compounds_rebuilt(tree, change)


def _one_fraction(factor: Expression) -> Expression:
    """A factor that is a fraction of numbers over a number, as one fraction: 5/12 for ⅚ ÷ 2."""
    match factor:
        case Binary("/", Binary("/", Number() as above, Number(middle)), Number(least)):
            return Binary("/", above, Number(middle * least))
    return factor


def _quotient(above: Expression, below: Expression) -> Expression:
    if is_zero(above):
        return ZERO
    if is_one(below):
        return above
    if isinstance(above, Negate) and isinstance(below, Negate):
        return Binary("/", above.operand, below.operand)
    if isinstance(above, Negate):
        return Negate(_quotient(above.operand, below))
    if isinstance(below, Negate):
        return Negate(_quotient(above, below.operand))
    return Binary("/", above, below)


# --- comparing ----------------------------------------------------------------------------------


def alike(a: Expression, b: Expression) -> bool:
    """Whether two expressions differ in nothing but brackets and the order of factors and terms.

    ``e (u sin α)`` and ``e u sin α`` are alike, so are ``√3/2 u`` and ``√3 u/2``, and ``1 + e`` and
    ``e + 1``; ``½ (4u)`` and ``2u`` are not, nor are ``d/(u/2)`` and ``2d/u``; of numbers a
    product is not its value.
    """
    if a == b:
        return True
    if is_rational(unsigned(a)) or letters(a) != letters(b):
        return False
    return functions_in(a) == functions_in(b) and _shape(a) == _shape(b)


@lru_cache(maxsize=4096)
def _shape(tree: Expression) -> str:
    """An expression as text in which brackets and order make no difference."""
    match tree:
        case Negate() | Binary("*" | "/"):
            return repr(_factors(tree))
        case Binary("+" | "-"):
            return repr(sorted(_terms(tree, 1)))
        case Binary(op, left, right):
            return f"({_shape(left)} {op} {_shape(right)})"
        case Apply(function, argument):
            return f"{function}({_shape(argument)})"
    return repr(tree)


def _terms(tree: Expression, sign: int) -> Iterator[tuple[int, list[str], list[str]]]:
    """The terms of a sum, each as its sign and its factors."""
    match tree:
        case Binary("+" | "-" as op, left, right):
            yield from _terms(left, sign)
            yield from _terms(right, sign if op == "+" else -sign)
        case _:
            own, above, below = _factors(tree)
            yield sign * own, above, below


def reordered(a: Expression, b: Expression) -> bool:
    """Whether two sums, or two quotients of sums with one divisor, have the same terms."""
    match a, b:
        case Binary("/", above, below), Binary("/", other, divisor) if below == divisor:
            return reordered(above, other)
    terms, others = (
        [_factors(signed_term) for signed_term in _signed_terms(tree)] for tree in (a, b)
    )
    return len(terms) > 1 and sorted(terms) == sorted(others)


def _signed_terms(tree: Expression) -> Iterator[Expression]:
    match tree:
        case Binary("+", left, right):
            yield from _signed_terms(left)
            yield from _signed_terms(right)
        case Binary("-", left, right):
            yield from _signed_terms(left)
            yield Negate(right)
        case _:
            yield tree


def _factors(tree: Expression) -> tuple[int, list[str], list[str]]:
    """The sign of a product, and its factors above and below the line, sorted."""
    sign, above, below = 1, list[str](), list[str]()

    def take(tree: Expression, up: list[str], down: list[str]) -> None:
        nonlocal sign
        match tree:
            case Negate(operand):
                sign = -sign
                take(operand, up, down)
            case Binary("*", left, right):
                take(left, up, down)
                take(right, up, down)
            case Binary("/", left, Binary("/") as right):
                take(left, up, down)
                down.append(_shape(right))
            case Binary("/", left, right):
                take(left, up, down)
                take(right, down, up)
            case _ if not is_one(tree):
                up.append(_shape(tree))

    take(tree, above, below)
    return sign, sorted(above), sorted(below)


def tangents_opened(*sides: Expression) -> tuple[Expression, ...]:
    """The sides of a relation with the tangents of double angles by those of the single ones.

    Where the tangent of half an angle occurs, the whole angle is the double one.
    """
    of_double: dict[Expression, Expression] = {}
    for node in (node for side in sides for node in walk(side)):
        match node:
            case Apply("tan", Binary("/", angle, below) as half) if below == TWO:
                of_double[angle] = half

    def change(tree: Expression) -> Expression:
        match tree:
            case Apply("tan", Binary("*", whole, angle)) if whole == TWO:
                single = angle
            case Apply("tan", angle) if angle in of_double:
                single = of_double[angle]
            case _:
                return tree
        own = Apply("tan", single)
        return Binary("/", product(TWO, own), difference(ONE, square(own)))

    return tuple(swept(rebuilt(side, change)) for side in sides)


def is_in_degrees(value: sp.Expr) -> bool:
    """Whether a number has ratios of angles such as 37°."""
    return not symbols_in(value) and value.has(sp.sin, sp.cos, sp.tan)


def product_without(tree: Expression, factor: Expression) -> Expression | None:
    """What a product is without one of its factors; None where it is no such product."""
    if tree == factor:
        return ONE
    match tree:
        case Binary("*", left, right) if right == factor and not has_quantity(left):
            return left
        case Binary("/", above, below) if not has_quantity(below):
            rest = product_without(above, factor)
            return None if rest is None else Binary("/", rest, below)
    return None
