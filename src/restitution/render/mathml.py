"""Mathematics in MathML Core, as browsers show it without a script."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

from restitution.render.layout import (
    Bold,
    Brackets,
    Coordinates,
    Degrees,
    Fraction,
    Function,
    Layout,
    Letter,
    Number,
    Percent,
    Phrase,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    Words,
)
from restitution.render.markup import Tree, element, to_markup
from restitution.render.text import GREEK, MINUS, bold

_TIMES = element("mo", ["\u2062"])
_APPLY = element("mo", ["\u2061"])
# Browsers put no space of their own around a function's name.
_THIN = element("mspace", (), {"width": "0.167em"})
_TALL = ("mfrac", "msqrt", "mroot")


def to_mathml(layout: Layout, *, block: bool = False) -> str:
    """The layout as the text of one ``math`` element: see `mathematics`."""
    return to_markup(mathematics(layout, block=block))


def mathematics(layout: Layout, *, block: bool = False) -> Tree:
    """The layout as one ``math`` element, in a line of text or (``block``) on a line of its own."""
    return formula([_node(layout)], block=block)


def formula(children: Iterable[Tree], *, block: bool = False) -> Tree:
    """Elements of MathML as one ``math`` element."""
    return element("math", children, {"display": "block"} if block else None)


def sign(text: str, **attributes: str) -> Tree:
    """A sign, such as that of a relation."""
    return element("mo", [text], attributes)


def _node(layout: Layout) -> Tree:
    match layout:
        case Number(digits):
            return element("mn", [digits])
        case Letter(name, subscript):
            return _with_subscript(element("mi", [GREEK.get(name, name)]), subscript)
        case Bold(name, subscript):
            return _with_subscript(element("mi", [bold(name)]), subscript)
        case Words("∞"):
            return element("mi", ["∞"])
        case Words(text):
            return element("mtext", [text])
        case Sum(terms):
            return _row(terms_of_sum(terms))
        case Product(factors, times):
            if times:
                return _row(_between(map(_node, factors), sign(times)))
            return _row(_product(factors))
        case Fraction(above, below):
            return element("mfrac", [_node(above), _node(below)])
        case Root(inside, 2):
            return element("msqrt", [_node(inside)])
        case Root(inside, index):
            return element("mroot", [_node(inside), element("mn", [str(index)])])
        case Power(base, exponent):
            return element("msup", [_node(base), _node(exponent)])
        case Function():
            return _function(layout)
        case Brackets(inside, kind):
            return _fenced([_node(inside)], kind)
        case Degrees(inside):
            return _row([_unit_number(inside), _postfix("°")])
        case Percent(inside):
            return _row([_unit_number(inside), _postfix("%")])
        case Coordinates(items):
            return _fenced(list(_between(map(_node, items), sign(","))), "()")
        case Relation(operands, signs):
            parts = [_node(operands[0])]
            for own, operand in zip(signs, operands[1:], strict=True):
                parts += [sign(own), _node(operand)]
            return _row(parts)
        case Phrase(items, separator):
            gap = element("mtext", [separator.replace(" ", "\u00a0")])
            return _row(_between(map(_node, items), gap))


def _row(children: Iterable[Tree]) -> Tree:
    return element("mrow", children)


def _between(nodes: Iterable[Tree], gap: Tree) -> Iterator[Tree]:
    """Elements with one more between any two."""
    for number, node in enumerate(nodes):
        yield from (gap, node) if number else (node,)


def _postfix(text: str) -> Tree:
    return sign(text, form="postfix", lspace="0", rspace="0")


def _fenced(body: list[Tree], kind: str) -> Tree:
    # Brackets grow only around what is tall: a grown one stands off, and lifts its exponent.
    grows = "true" if any(map(_is_tall, body)) else "false"
    left, right = (
        sign(bracket, form=form, stretchy=grows, lspace="0", rspace="0")
        for bracket, form in zip(kind, ("prefix", "postfix"), strict=True)
    )
    return _row([left, *body, right])


def _is_tall(tree: Tree) -> bool:
    return not isinstance(tree, str) and (tree[0] in _TALL or any(map(_is_tall, tree[2:])))


def _with_subscript(base: Tree, subscript: str) -> Tree:
    if not subscript:
        return base
    tag = "mn" if subscript.isdigit() else "mi"
    return element("msub", [base, element(tag, [GREEK.get(subscript, subscript)])])


def terms_of_sum(terms: tuple[tuple[str, Layout], ...]) -> list[Tree]:
    """The terms of a sum with their signs; a first plus is left out."""
    out: list[Tree] = []
    for index, (own, term) in enumerate(terms):
        if index or own == "-":
            out.append(term_sign(own, form="infix" if index else "prefix"))
        out.append(_node(term))
    return out


def term_sign(own: str, form: str = "infix") -> Tree:
    """The sign of a term."""
    return sign(MINUS if own == "-" else "+", form=form)


def _product(factors: tuple[Layout, ...]) -> list[Tree]:
    out = [_node(factors[0])]
    for before, factor in pairwise(factors):
        spaced = isinstance(before, Function | Words) or isinstance(factor, Function | Words)
        spaced = spaced or (isinstance(before, Fraction) and isinstance(factor, Fraction))
        out += [_TIMES, *([_THIN] if spaced else []), _node(factor)]
    return out


def _function(layout: Function) -> Tree:
    name = element("mi", [layout.name])
    if layout.power is not None:
        name = element("msup", [name, _node(layout.power)])
    close = isinstance(layout.argument, Brackets) or (
        layout.power is not None and isinstance(layout.argument, Letter)
    )
    return _row([name, _APPLY, *([] if close else [_THIN]), _node(layout.argument)])


def _unit_number(inside: Layout) -> Tree:
    body = _node(inside)
    return _fenced([body], "()") if isinstance(inside, Fraction) else body
