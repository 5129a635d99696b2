"""Mathematics in MathML Core, as browsers show it without a script."""

from __future__ import annotations

from html import escape
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
from restitution.render.text import GREEK, MINUS, bold

_TIMES = "<mo>&#x2062;</mo>"
_APPLY = "<mo>&#x2061;</mo>"
# Browsers put no space of their own around a function's name.
_THIN = '<mspace width="0.167em"></mspace>'


def to_mathml(layout: Layout, *, block: bool = False) -> str:
    """The layout as one ``math`` element, in a line of text or (``block``) on a line of its own."""
    display = ' display="block"' if block else ""
    return f"<math{display}>{_node(layout)}</math>"


def _node(layout: Layout) -> str:
    match layout:
        case Number(digits):
            return f"<mn>{escape(digits)}</mn>"
        case Letter(name, subscript):
            return _with_subscript(f"<mi>{escape(GREEK.get(name, name))}</mi>", subscript)
        case Bold(name, subscript):
            return _with_subscript(f"<mi>{escape(bold(name))}</mi>", subscript)
        case Words("∞"):
            return "<mi>∞</mi>"
        case Words(text):
            return f"<mtext>{escape(text)}</mtext>"
        case Sum(terms):
            return _row(_sum(terms))
        case Product(factors, times):
            if times:
                return _row(f"<mo>{times}</mo>".join(_node(factor) for factor in factors))
            return _row(_product(factors))
        case Fraction(above, below):
            return f"<mfrac>{_node(above)}{_node(below)}</mfrac>"
        case Root(inside, 2):
            return f"<msqrt>{_node(inside)}</msqrt>"
        case Root(inside, index):
            return f"<mroot>{_node(inside)}<mn>{index}</mn></mroot>"
        case Power(base, exponent):
            return f"<msup>{_node(base)}{_node(exponent)}</msup>"
        case Function():
            return _function(layout)
        case Brackets(inside, kind):
            return _fenced(_node(inside), kind)
        case Degrees(inside):
            return _row(_unit_number(inside) + _postfix("°"))
        case Percent(inside):
            return _row(_unit_number(inside) + _postfix("%"))
        case Coordinates(items):
            return _fenced("<mo>,</mo>".join(_node(item) for item in items), "()")
        case Relation(operands, signs):
            parts = [_node(operands[0])]
            for sign, operand in zip(signs, operands[1:], strict=True):
                parts += [f"<mo>{escape(sign)}</mo>", _node(operand)]
            return _row("".join(parts))
        case Phrase(items, separator):
            gap = f"<mtext>{escape(separator).replace(' ', '&#xa0;')}</mtext>"
            return _row(gap.join(_node(item) for item in items))


def _row(body: str) -> str:
    return f"<mrow>{body}</mrow>"


def _postfix(sign: str) -> str:
    return f'<mo form="postfix" lspace="0" rspace="0">{sign}</mo>'


def _fenced(body: str, kind: str) -> str:
    # Brackets grow only around what is tall: a grown one stands off, and lifts its exponent.
    grows = "true" if "<mfrac" in body or "<msqrt" in body or "<mroot" in body else "false"
    left = f'<mo form="prefix" stretchy="{grows}" lspace="0" rspace="0">{kind[0]}</mo>'
    right = f'<mo form="postfix" stretchy="{grows}" lspace="0" rspace="0">{kind[1]}</mo>'
    return _row(left + body + right)


def _with_subscript(base: str, subscript: str) -> str:
    if not subscript:
        return base
    tag = "mn" if subscript.isdigit() else "mi"
    return f"<msub>{base}<{tag}>{escape(GREEK.get(subscript, subscript))}</{tag}></msub>"


def _sum(terms: tuple[tuple[str, Layout], ...]) -> str:
    out = []
    for index, (sign, term) in enumerate(terms):
        if index or sign == "-":
            form = "prefix" if index == 0 else "infix"
            out.append(f'<mo form="{form}">{MINUS if sign == "-" else "+"}</mo>')
        out.append(_node(term))
    return "".join(out)


def _product(factors: tuple[Layout, ...]) -> str:
    out = [_node(factors[0])]
    for before, factor in pairwise(factors):
        spaced = isinstance(before, Function | Words) or isinstance(factor, Function | Words)
        spaced = spaced or (isinstance(before, Fraction) and isinstance(factor, Fraction))
        out.append(_TIMES + (_THIN if spaced else "") + _node(factor))
    return "".join(out)


def _function(layout: Function) -> str:
    name = f"<mi>{escape(layout.name)}</mi>"
    if layout.power is not None:
        name = f"<msup>{name}{_node(layout.power)}</msup>"
    close = isinstance(layout.argument, Brackets) or (
        layout.power is not None and isinstance(layout.argument, Letter)
    )
    gap = "" if close else _THIN
    return _row(name + _APPLY + gap + _node(layout.argument))


def _unit_number(inside: Layout) -> str:
    body = _node(inside)
    return _fenced(body, "()") if isinstance(inside, Fraction) else body
