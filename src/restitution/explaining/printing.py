"""The one printer of values put in: it alone decides on ×, brackets, signs and zeros.

A formula is a template of the statement language, and its letters stand for values:
``printed("m*u + n*v", m=2, u=3, n=4, v=-1)`` is 2 × 3 + 4 × (−1). What is zero is left out of a
sum, a factor 1 out of a product; numbers have × between them, letters nothing; what is negative or
several things stands in brackets, and a sign before letters is drawn to the front.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from typing import Any, Literal

import sympy as sp

from restitution.expression import read_expression
from restitution.expression import tree as trees
from restitution.render import layout as lay
from restitution.render.layout import Bold, Brackets, Layout, Number, Product, Sum

_HALF = lay.fraction(Number("1"), Number("2"))


def printed(template: str, /, *, front: bool = False, zeros: bool = False, **values: Any) -> Layout:
    """A template with values put in, not worked out.

    A value is an expression, a pair for a vector, or a layout; every letter of the template has
    one. A product that stands alone shows its factors as they are, ``(−w)(−3)``; with ``front``
    their signs are drawn to the front. ``dot(a, b)`` is a scalar product in components. With
    ``zeros`` a product with a factor 0 is written too. Raises KeyError for a letter without a
    value.
    """
    return _Printer(values, front, zeros).put(_read(template))


def scalar_product(first: Any, second: Any) -> Layout:
    """``(6**i** − 5**j**)·(3**i** + 4**j**)``, ``u**i**·(3**i** + 4**j**)``: not worked out."""
    a, b = look(first), look(second)
    bare = isinstance(a, Bold) or (isinstance(first, tuple) and not _several(a) and _several(b))
    return lay.product(
        a if bare else Brackets(a), b if isinstance(b, Bold) else Brackets(b), sign="·"
    )


@lru_cache(maxsize=256)
def _read(template: str) -> trees.Expression:
    return read_expression(template)


class _Printer:
    """The values of a template, and how its nodes look with them."""

    def __init__(self, values: Mapping[str, Any], front: bool, zeros: bool) -> None:
        self.values = values
        self.front = front
        self.zeros = zeros

    def put(self, tree: trees.Expression) -> Layout:
        match tree:
            case trees.Letter(name):
                return look(self.values[name])
            case trees.Number(value):
                return look(sp.Rational(value.numerator, value.denominator))
            case trees.Negate(operand):
                return lay.negative(self.put(operand))
            case trees.Apply("sqrt", argument):
                return lay.Root(self.put(argument))
            case trees.Binary("^", base, _):
                return self._square(base)
            case trees.Binary("/", above, below):
                return lay.fraction(self.put(above), self.put(below))
            case trees.Binary("*", _, _):
                return self._product(tree)
            case trees.Binary("+" | "-", _, _):
                return self._sum(tree)
            case trees.Quantity("dot", (trees.Letter(a), trees.Letter(b))):
                return self._scalar_product(self.values[a], self.values[b])
        raise TypeError(tree)  # pragma: no cover - no template has more

    def _square(self, base: trees.Expression) -> Layout:
        laid = self.put(base)
        if _zero(laid):
            return laid
        if isinstance(base, trees.Letter):
            return _square_of(laid)
        return lay.power(lay.bracketed(laid), Number("2"))

    def _product(self, tree: trees.Expression) -> Layout:
        first, *others = _factors(tree)
        pair = self._pair(tree) if self.front else None
        if pair is not None and not any(map(_zero, pair)):
            flip, term = _term(*pair, leads=True)
            return _signed(term) if flip else term
        if first == _read("1/2"):
            return _half(*map(self.put, others))
        factors = [self._factor(each) for each in (first, *others)]
        if any(_zero(each) for each in factors):
            written = Product(tuple(map(lay.bracketed, factors)), "×")
            return written if self.zeros else Number("0")
        if len(factors) == 2 and factors[0] == lay.ONE:
            last = others[0]
            return factors[1] if isinstance(last, trees.Letter) else self.put(last)
        return _product_of(*factors)

    def _factor(self, tree: trees.Expression) -> Layout:
        """A factor in the brackets that it needs: what is several things, and a vector."""
        laid = self.put(tree)
        single = isinstance(tree, trees.Letter)
        if single and not _vector(laid):
            return laid
        vector = not single and _vector(laid) and not isinstance(laid, Bold)
        return Brackets(laid) if isinstance(laid, Sum) or vector else laid

    def _sum(self, tree: trees.Expression) -> Layout:
        terms = _terms(tree)
        whole: Layout = Number("0")
        for sign, term in terms:
            laid = self.put(term)
            if _zero(laid):
                continue
            pair = self._pair(term)
            if pair is not None:
                flip, laid = _term(*pair, leads=_zero(whole))
                laid = _signed(laid) if flip != (sign == "-") else laid
                sign = "+"
            if sign == "-":
                whole = self._less(whole, laid, terms[0][1])
            else:
                whole = laid if _zero(whole) else lay.total([whole, laid])
        return whole

    def _less(self, whole: Layout, laid: Layout, first: trees.Expression) -> Layout:
        if not _vector(laid):
            return _difference(whole, laid)
        whole = lay.ZERO_VECTOR if _zero(whole) else whole
        right = Brackets(laid) if isinstance(laid, Sum) else laid
        put_in = isinstance(first, trees.Letter) and isinstance(self.values[first.name], tuple)
        left = Brackets(whole) if put_in and _several(whole) else whole
        return Sum((*(left.terms if isinstance(left, Sum) else (("+", left),)), ("-", right)))

    def _pair(self, term: trees.Expression) -> tuple[Layout, Layout] | None:
        """The factors of a product of two letters that stand for numbers; else None."""
        match term:
            case trees.Binary("*", trees.Letter() as a, trees.Letter() as b):
                first, second = self.put(a), self.put(b)
                return None if _vector(first) or _vector(second) else (first, second)
        return None

    def _scalar_product(self, a: tuple[Any, Any], b: tuple[Any, Any]) -> Layout:
        """``3 × 3 + (−4) × 2``: every component as it is."""
        pairs = [(look(x), look(y)) for x, y in zip(a, b, strict=True)]
        kept = [(x, y) for x, y in pairs if self.zeros or not (_zero(x) or _zero(y))]
        return lay.total([_product_of(x, y) for x, y in kept])


def _factors(tree: trees.Expression) -> list[trees.Expression]:
    if isinstance(tree, trees.Binary) and tree.op == "*":
        return [*_factors(tree.left), tree.right]
    return [tree]


def _terms(tree: trees.Expression) -> list[tuple[Literal["+", "-"], trees.Expression]]:
    if isinstance(tree, trees.Binary) and tree.op in ("+", "-"):
        return [*_terms(tree.left), ("+" if tree.op == "+" else "-", tree.right)]
    return [("+", tree)]


def _half(mass: Layout, inside: Layout) -> Layout:
    """½mv², with v² as a sum of squares of components."""
    if _zero(mass) or _zero(inside):
        return Number("0")
    inside = lay.bracketed(inside)
    letters = not (_numeric(mass) or _begins(mass))
    if _begins(inside) and letters:
        return Product((lay.product(_HALF, lay.bracketed(mass)), inside), "×")
    if not letters or _begins(inside):
        return Product((_HALF, lay.bracketed(mass), inside), "×")
    return lay.product(_HALF, lay.bracketed(mass), inside)


def _vector(laid: Any) -> bool:
    """Whether a layout is a vector: one with **i**, **j** or a bold letter in it."""
    if isinstance(laid, Bold):
        return True
    match laid:
        case Sum(terms):
            return any(_vector(each) for _, each in terms)
        case Product(factors):
            return any(_vector(each) for each in factors)
        case Brackets(inside):
            return _vector(inside)
    return False


def look(value: Any, *, angle: bool = False) -> Layout:
    """How a value looks: a vector for a pair, degrees for an angle."""
    if isinstance(value, Layout):
        return value
    if isinstance(value, tuple):
        return lay.vector(value[0], value[1])
    return lay.from_sympy(sp.sympify(value, strict=True), degrees=angle)


def _product_of(*factors: Any) -> Layout:
    """A product with values put in: ``×`` between numbers, nothing between letters."""
    laid = [look(each) for each in factors]
    if (
        len(laid) == 2
        and isinstance(laid[0], lay.Letter)
        and isinstance(laid[1], Product)
        and (laid[0] in laid[1].factors)
    ):
        return Product(tuple(laid), "×")  # e × eu, not eeu
    if sum(_numeric(each) for each in laid) > 1 or any(_begins(each) for each in laid[1:]):
        first, *rest = [
            Brackets(each) if _is_negative(each) and index else lay.bracketed(each)
            for index, each in enumerate(laid)
        ]
        if first == Number("1"):
            return lay.product(*rest, sign="×") if len(rest) > 1 else rest[0]
        return Product((first, *rest), "×")
    return _powers(lay.product(*laid))


def _powers(laid: Layout) -> Layout:
    """``u²`` for a letter that stands twice in a row."""
    if not isinstance(laid, Product) or laid.sign:
        return laid
    factors: list[Layout] = []
    for each in laid.factors:
        if isinstance(each, lay.Letter) and factors and factors[-1] == each:
            factors[-1] = lay.power(each, Number("2"))
        else:
            factors.append(each)
    return factors[0] if len(factors) == 1 else Product(tuple(factors))


def _numeric(laid: Layout) -> bool:
    _, size = lay.split_sign(laid)
    return (
        isinstance(size, Number)
        or (
            isinstance(size, lay.Fraction)
            and isinstance(size.above, Number)
            and isinstance(size.below, Number)
        )
        or isinstance(size, lay.Root)
    )


def _begins(laid: Layout) -> bool:
    _, size = lay.split_sign(laid)
    while isinstance(size, Product | lay.Fraction | lay.Power):
        size = (
            size.factors[0]
            if isinstance(size, Product)
            else size.above
            if isinstance(size, lay.Fraction)
            else size.base
        )
    return isinstance(size, Number)


def _is_negative(laid: Layout) -> bool:
    return isinstance(laid, Sum) and len(laid.terms) == 1


def _difference(first: Any, second: Any) -> Layout:
    """``a − b`` with values put in: ``3 − (−4)``; a zero is left out."""
    a, b = look(first), look(second)
    if _zero(b):
        return a
    minus: Layout
    if _is_negative(b):
        minus = Brackets(b)
        if not _starts_numeric(b):
            return lay.total([a, lay.split_sign(b)[1]]) if not _zero(a) else lay.split_sign(b)[1]
    else:
        minus = lay.bracketed(b)
    if _zero(a):
        return Sum((("-", minus),))
    terms = a.terms if isinstance(a, Sum) else (("+", a),)
    return Sum((*terms, ("-", minus)))


def _several(laid: Layout) -> bool:
    """Whether a layout is a sum of more than one term."""
    return isinstance(laid, Sum) and len(laid.terms) > 1


def _zero(laid: Layout) -> bool:
    return laid == Number("0") or laid == lay.ZERO_VECTOR


def _starts_numeric(laid: Layout) -> bool:
    return _begins(laid) and not _has_letter(laid)


def _has_letter(laid: Any) -> bool:
    if isinstance(laid, lay.Letter):
        return True
    for name in getattr(laid, "__slots__", ()):
        inner = getattr(laid, name)
        if isinstance(inner, tuple):
            for each in inner:
                parts = each if isinstance(each, tuple) else (each,)
                if any(_has_letter(part) for part in parts if not isinstance(part, str)):
                    return True
        elif not isinstance(inner, str | int) and inner is not None and _has_letter(inner):
            return True
    return False


def _square_of(value: Any) -> Layout:
    """A square with the value put in: ``(−4)²``, ``(u cos α)²``, ``v²``."""
    laid = look(value)
    sign, size = lay.split_sign(laid)
    if sign == "-" and _has_letter(size):
        laid = size
    if isinstance(laid, lay.Root):
        laid = Brackets(laid)
    return lay.power(laid, Number("2"))


def _signed(term: Layout) -> Layout:
    """A term with a minus sign before it."""
    return Sum((("-", Brackets(term) if _several(term) else term),))


def _term(first: Layout, second: Layout, *, leads: bool) -> tuple[bool, Layout]:
    """Whether a product is subtracted in a sum, and how it looks there; one that leads it."""
    (sign, size), (other, rest) = lay.split_sign(first), lay.split_sign(second)
    one_sign, both_signs = sign == "-", (sign == "-") != (other == "-")
    if _wordy(size) and _wordy(rest):
        return both_signs, lay.product(Brackets(size), Brackets(rest))
    if lay.ONE in (first, second):
        sign, size = lay.split_sign(second if first == lay.ONE else first)
        return sign == "-", size
    if isinstance(rest, Number) and other == "+" and not _begins(size):
        return one_sign, lay.product(rest, size)  # 4m
    if _begins(rest) and not (one_sign and leads):
        return one_sign, _product_of(size, second)
    return both_signs, _product_of(size, rest)


def _wordy(laid: Layout) -> bool:
    """Whether a factor holds a function: two such run into each other without brackets."""
    if isinstance(laid, lay.Function):
        return True
    return isinstance(laid, Product) and any(isinstance(f, lay.Function) for f in laid.factors)
