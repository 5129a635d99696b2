r"""Mathematics in LaTeX: ``\tfrac{1}{2}mu^{2}(1 - e^{2})\sin^{2}\alpha``; no delimiters."""

from __future__ import annotations

import re
from itertools import pairwise
from unicodedata import decomposition, normalize

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
from restitution.render.text import GREEK

SIGNS = {  # of relations and products, in mathematical mode
    "≤": r"\leq",
    "≥": r"\geq",
    "≠": r"\neq",
    "≈": r"\approx",
    "→": r"\to",
    "∈": r"\in",
    "×": r"\times",
    "·": r"\cdot",
}
_KNOWN = (
    "sin",
    "cos",
    "tan",
    "cot",
    "sec",
    "arcsin",
    "arccos",
    "arctan",
    "ln",
    "exp",
    "max",
    "min",
)
_ESCAPES = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "%": r"\%",
    "#": r"\#",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
}


_POWER = re.compile("([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)")
_BY_SIGN = {
    "−": "-",
    "√": r"\surd",
    "÷": r"\div",
    "±": r"\pm",
    "°": r"^{\circ}",
    "∞": r"\infty",
    **SIGNS,
    **{sign: f"\\{name}" for name, sign in GREEK.items()},
}


def to_latex(layout: Layout) -> str:
    r"""The layout in LaTeX's mathematical mode (needs amsmath for ``\tfrac`` and ``\text``)."""
    match layout:
        case Number(digits):
            return digits
        case Letter(name, subscript):
            head = rf"\{name}" if name in GREEK else name
            return head + _subscript(subscript)
        case Bold(name, subscript):
            return rf"\mathbf{{{name}}}" + _subscript(subscript)
        case Words("∞"):
            return r"\infty"
        case Words("±"):
            return r"\pm{}"
        case Words(text):
            return rf"\text{{{words(text)}}}"
        case Sum(terms):
            return _sum(terms)
        case Product(factors, times):
            if times:
                return f" {SIGNS[times]} ".join(to_latex(factor) for factor in factors)
            return _product(factors)
        case Fraction(Number(a), Number(b)):
            return rf"\tfrac{{{a}}}{{{b}}}"
        case Fraction(above, below):
            return rf"\frac{{{to_latex(above)}}}{{{to_latex(below)}}}"
        case Root(inside, index):
            degree = "" if index == 2 else f"[{index}]"
            return rf"\sqrt{degree}{{{to_latex(inside)}}}"
        case Power(base, exponent):
            return f"{to_latex(base)}^{{{to_latex(exponent)}}}"
        case Function():
            return _function(layout)
        case Brackets(inside, kind):
            return _fenced(to_latex(inside), inside, kind)
        case Degrees(inside):
            return rf"{_unit_number(inside)}^{{\circ}}"
        case Percent(inside):
            return rf"{_unit_number(inside)}\%"
        case Coordinates(items):
            body = ",\\ ".join(to_latex(item) for item in items)
            return _fenced(body, layout, "()")
        case Relation(operands, signs):
            parts = [to_latex(operands[0])]
            for sign, operand in zip(signs, operands[1:], strict=True):
                parts += [relation_sign(sign), to_latex(operand)]
            return " ".join(parts)
        case Phrase(items, separator):
            return _phrase(items, separator)


def relation_sign(sign: str) -> str:
    """A sign between two sides; words such as ``is parallel to`` stand upright and apart."""
    return rf"\text{{ {words(sign)} }}" if sign[0].isalpha() else SIGNS.get(sign, sign)


def words(text: str) -> str:
    """Plain text as LaTeX; it never comes through as markup.

    Characters of formulas and the powers of units among it are mathematics, blanks that hold ties.
    """
    pieces = _POWER.split(text)
    return "".join(
        _power(piece) if number % 2 else "".join(_ESCAPES.get(c) or _sign(c) for c in piece)
        for number, piece in enumerate(pieces)
    ).replace("\u00a0", "~")


def _power(raised: str) -> str:
    return f"$^{{{normalize('NFKC', raised).replace('−', '-')}}}$"


def _sign(c: str) -> str:
    """A character of a formula among words, as mathematics; other characters as they are."""
    if c in _BY_SIGN:
        return f"${_BY_SIGN[c]}$"
    kind, _, parts = decomposition(c).partition(" ")
    if kind == "<fraction>":
        above, _, below = (chr(int(code, 16)) for code in parts.replace(" 2044 ", " 2f ").split())
        return rf"$\tfrac{{{above}}}{{{below}}}$"
    if kind in ("<super>", "<sub>") and len(parts) == 4:
        mark = "^" if kind == "<super>" else "_"
        return f"${mark}{{{chr(int(parts, 16))}}}$"
    return c


def _escape(text: str) -> str:
    """A name with the characters that mean something to LaTeX made harmless."""
    return "".join(_ESCAPES.get(c, c) for c in text)


def _subscript(subscript: str) -> str:
    if not subscript:
        return ""
    inner = rf"\{subscript}" if subscript in GREEK else _escape(subscript)
    return f"_{{{inner}}}"


def _sum(terms: tuple[tuple[str, Layout], ...]) -> str:
    out = ""
    for index, (sign, term) in enumerate(terms):
        text = to_latex(term)
        if index == 0:
            out = ("-" if sign == "-" else "") + text
        else:
            out += f" {sign} {text}"
    return out


def _product(factors: tuple[Layout, ...]) -> str:
    out = to_latex(factors[0])
    for before, factor in pairwise(factors):
        text = to_latex(factor)
        if isinstance(before, Function):
            gap = r"\," if not isinstance(factor, Function) else " "
        elif isinstance(before, Words) or isinstance(factor, Words):
            gap = r"\ "
        elif isinstance(before, Root) and not isinstance(factor, Brackets | Function):
            gap = r"\,"
        else:
            # A command such as \alpha must not run into the letter that follows it.
            gap = " " if _ends_in_command(out) and text[:1].isalpha() else ""
        out += gap + text
    return out


def _ends_in_command(text: str) -> bool:
    _, slash, tail = text.rpartition("\\")
    return bool(slash) and tail.isalpha()


def _function(layout: Function) -> str:
    name = rf"\{layout.name}" if layout.name in _KNOWN else rf"\operatorname{{{layout.name}}}"
    power = "" if layout.power is None else f"^{{{to_latex(layout.power)}}}"
    argument = to_latex(layout.argument)
    gap = "" if power or argument.startswith(("\\", "(")) else " "
    return f"{name}{power}{gap}{argument}"


def _fenced(body: str, inside: Layout, kind: str) -> str:
    left, right = kind[0], kind[1]
    if _is_tall(inside):
        return rf"\left{left}{body}\right{right}"
    return f"{left}{body}{right}"


def _is_tall(layout: Layout) -> bool:
    match layout:
        case Fraction():
            return True
        case Sum(terms):
            return any(_is_tall(term) for _, term in terms)
        case Product(factors):
            return any(_is_tall(factor) for factor in factors)
        case Coordinates(items) | Phrase(items):
            return any(_is_tall(item) for item in items)
        case Root(inside) | Brackets(inside):
            return _is_tall(inside)
        case Power(base):
            return _is_tall(base)
        case Function(_, argument):
            return _is_tall(argument)
        case _:
            return False


def _unit_number(inside: Layout) -> str:
    body = to_latex(inside)
    return _fenced(body, inside, "()") if isinstance(inside, Fraction) else body


def _phrase(items: tuple[Layout, ...], separator: str) -> str:
    gap = {"": "", " ": r"\ ", "\u00a0": "~"}.get(separator, rf"\text{{{_escape(separator)}}}")
    return gap.join(to_latex(item) for item in items)
