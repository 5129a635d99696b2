r"""Mathematics and words in Typst's markup, from which sheets are set: ``sqrt(7)/4 u``.

Words go through as string literals, so nothing that a user wrote is ever read as markup.
"""

from __future__ import annotations

from itertools import pairwise
from typing import Literal

from restitution.errors import UnsupportedError
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
from restitution.render.text import GREEK, MINUS

_THIN = "thin"


def to_typst(layout: Layout, *, block: bool = False) -> str:
    """The layout as an equation in a line of text or (``block``) in full size."""
    body = mathematics(layout)
    return f"$display({body})$" if block else f"${body}$"


def literal(text: str) -> str:
    """Text as a string literal of Typst."""
    escaped = text.replace("\\", "\\\\").replace('"', '\\"')
    return (
        '"' + "".join(character if character.isprintable() else " " for character in escaped) + '"'
    )


def words(text: str) -> str:
    """Text as content, whatever characters it has."""
    return f"#{literal(text)};"


def mathematics(layout: Layout) -> str:
    """The layout as it stands between the dollars of an equation."""
    match layout:
        case Number(digits):
            return literal(digits)
        case Letter(name, subscript):
            return _with_subscript(GREEK.get(name, name), subscript)
        case Bold(name, subscript):
            return _with_subscript(f"upright(bold({_letters(name)}))", subscript)
        case Words("∞"):
            return "infinity"
        case Words(text):
            return f"upright({literal(text)})"
        case Sum(terms):
            return _sum(terms)
        case Product(factors, times):
            if times:
                return f" {times} ".join(mathematics(factor) for factor in factors)
            return _product(factors)
        case Fraction(above, below):
            return f"frac({mathematics(above)}, {mathematics(below)})"
        case Root(inside, 2):
            return f"sqrt({mathematics(inside)})"
        case Root(inside, index):
            return f"root({index}, {mathematics(inside)})"
        case Power(base, exponent):
            return f"attach({mathematics(base)}, t: {mathematics(exponent)})"
        case Function(name, argument, power):
            head = f"op({literal(name)})"
            if power is not None:
                head = f"attach({head}, t: {mathematics(power)})"
            return f"{head} {mathematics(argument)}"
        case Brackets(inside, "||"):
            return f"abs({mathematics(inside)})"
        case Brackets(inside):
            return f"lr(({mathematics(inside)}))"
        case Degrees(inside):
            return _unit_number(inside) + literal("°")
        case Percent(inside):
            return _unit_number(inside) + literal("%")
        case Coordinates(items):
            # A comma of its own would end an argument of the function around it.
            comma = literal(",") + " "
            return f"lr(({comma.join(mathematics(item) for item in items)}))"
        case Relation(operands, signs):
            parts = [mathematics(operands[0])]
            for sign, operand in zip(signs, operands[1:], strict=True):
                words = literal(f" {sign} ") if sign[0].isalpha() else sign
                parts += [words, mathematics(operand)]
            return " ".join(parts)
        case Phrase(items, separator):
            # Without spaces around it: beside words they would be printed too.
            return literal(separator).join(mathematics(item) for item in items)


def _letters(name: str) -> str:
    return name if len(name) == 1 else literal(name)


def _with_subscript(base: str, subscript: str) -> str:
    if not subscript:
        return base
    below = GREEK.get(subscript, subscript)
    return f"attach({base}, b: {_letters(below)})"


def _sum(terms: tuple[tuple[str, Layout], ...]) -> str:
    parts: list[str] = []
    for index, (sign, term) in enumerate(terms):
        if index or sign == "-":
            parts.append(MINUS if sign == "-" else "+")
        parts.append(mathematics(term))
    return " ".join(parts)


def _product(factors: tuple[Layout, ...]) -> str:
    out = [mathematics(factors[0])]
    for before, factor in pairwise(factors):
        if isinstance(before, Function | Words) or isinstance(factor, Words):
            out.append(_THIN)
        out.append(mathematics(factor))
    return " ".join(out)


def _unit_number(inside: Layout) -> str:
    body = mathematics(inside)
    return f"lr(({body}))" if isinstance(inside, Fraction) else body


_PAPER = """\
#set document(title: TITLE, date: none)
#set page(paper: "a4", margin: (x: 20mm, top: 24mm, bottom: 20mm), numbering: "1 of 1",
  header: [#set text(size: 9pt); #text(TITLE) #h(1fr) HEAD #v(-0.6em) #line(length: 100%,
    stroke: 0.4pt)])
#set text(font: "New Computer Modern", size: 11pt, lang: "en", region: "GB")
#set par(justify: false, leading: 0.62em)
"""


NAME = "Name ........................................"
"""What stands above a sheet that is handed in."""


def paper(title: str, head: str) -> str:
    """The beginning of a document on A4: its title and ``head`` stand above every page."""
    return _PAPER.replace("HEAD", words(head)).replace("TITLE", literal(title))


def compiled(
    source: str, form: Literal["pdf", "png"], instead: str, sharpness: float | None = None
) -> bytes:
    """A document that typst makes of markup; the same bytes for the same markup.

    ``sharpness`` is in pixels to an inch. Raises UnsupportedError where typst is not installed,
    which tells what can be had ``instead``.
    """
    try:
        import typst
    except ImportError:
        needs = f"{form.upper()} needs typst: pip install 'restitution[pdf]', or take {instead}"
        raise UnsupportedError(needs) from None
    return typst.compile(source.encode(), format=form, ppi=sharpness, ignore_system_fonts=True)
