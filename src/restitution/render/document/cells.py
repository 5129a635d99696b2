"""Words and lines of mathematics as elements of HTML, which may be broken over lines."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import pairwise

from restitution.render.document import (
    Cell,
    Chain,
    Emphasis,
    LineBreak,
    Strong,
    Typed,
    lines,
    pieces,
)
from restitution.render.layout import (
    Brackets,
    Fraction,
    Layout,
    Phrase,
    Product,
    Relation,
    Sum,
    Words,
)
from restitution.render.markup import Tree, element
from restitution.render.mathml import formula, mathematics, sign, term_sign
from restitution.render.text import NO_BREAK, to_text, width

# Columns of plain text below which a sum is never broken.
_WHOLE = 24
# Columns of plain text beyond which a left side may be broken.
_LEFT = 44

_BREAK = element("wbr")


def inline(words: Cell) -> list[Tree]:
    """Words with their mathematics, to stand in a paragraph.

    What follows a short formula without a blank, such as a full stop, stays on its line.
    """
    out: list[Tree] = []
    held = ""
    for piece, after in pairwise((*pieces(words), "")):
        if isinstance(piece, str):
            out.append(piece.removeprefix(held))
            held = ""
        elif isinstance(piece, Emphasis):
            out.append(element("i", [piece.text]))
        elif isinstance(piece, Typed):
            out.append(element("code", [piece.text]))
        elif isinstance(piece, Strong):
            out.append(element("b", [piece.text]))
        elif isinstance(piece, LineBreak):
            out.append(element("br"))
        else:
            whole = isinstance(after, str) and width(to_text(piece)) <= _WHOLE
            held = after.split(" ", 1)[0] if whole and isinstance(after, str) else ""
            out += [_whole([*cell(piece), held])] if held else cell(piece)
    return out


def rows(chain: Chain) -> list[Tree]:
    """A line of mathematics as rows of a table: long chains take several."""
    gap = "" if chain.goes_on or not chain.note else " "
    behind: list[Tree] = [gap, classed("span", "note", inline(chain.note))] if chain.note else []
    left = cell(chain.operands[0])
    before = [classed("span", "item", [chain.label])] if chain.label else []
    mark = classed("td", "m", [chain.mark])
    if not chain.signs:
        own = [*before, *(_underlined(left) if chain.answer else left)]
        return [element("tr", [element("td", [*own, *behind], {"colspan": "3"}), mark])]
    wide = chain.operands[0] is not None and width(to_text(chain.operands[0])) > _LEFT
    broken = lines(chain)
    out: list[Tree] = []
    for index, (first, operands) in enumerate(broken):
        last = index == len(broken) - 1
        right: list[Tree] = []
        for number, (own_sign, operand) in enumerate(operands):
            value = cell(operand)
            if chain.answer and last and number == len(operands) - 1:
                value = _underlined(value)
            right += _joined(own_sign, value, operand)
        cells = [
            classed(
                "td",
                "l w" if wide and index == 0 else "l",
                [*before, *left] if index == 0 else [],
            ),
            classed("td", "s", [_sign(first)]),
            element("td", [*right, *(behind if last else [])]),
            mark if last else classed("td", "m", []),
        ]
        out.append(element("tr", cells))
    return out


def cell(layout: Layout | None) -> list[Tree]:
    """Mathematics; words among it and long sums may be broken over lines."""
    match layout:
        case None:
            return []
        case Words(text):
            return [text]
        case Sum(terms) if len(terms) > 1 and _is_longer(layout, _WHOLE):
            return _long_sum(layout)
        case Relation(operands, signs) if _is_longer(layout, _WHOLE):
            out = cell(operands[0])
            for own, operand in zip(signs, operands[1:], strict=True):
                out += [_BREAK, _sign(own), *cell(operand)]
            return out
        case Phrase(items, separator):
            out = list(_apart([cell(item) for item in items], [separator]))
            return [_whole(out)] if separator == NO_BREAK else out
        case Product() if _is_longer(layout, _LEFT):
            return _long_product(layout)
        case Fraction(above, below) if _is_worded(above) or _is_worded(below):
            return [*cell(above), _BREAK, "/", *cell(below)]
        case Brackets(inside) if _is_worded(layout):
            return ["(", *cell(inside), ")"]
        case Product((*head, Phrase() | Words() as last), times):
            before = Product(tuple(head)) if len(head) > 1 else head[0]
            return [*cell(before), " ", _sign(times), " ", *cell(last)]
    return [mathematics(layout)]


def _long_sum(layout: Sum) -> list[Tree]:
    """A sum in which a line may end before each sign."""
    (first_sign, first), *rest = layout.terms
    plain = first_sign == "+" and (_is_words(first) or _is_long_product(first))
    out = cell(first) if plain else [mathematics(Sum((layout.terms[0],)))]
    for own, term in rest:
        out.append(_BREAK)
        if _is_words(term) or _is_long_product(term):
            out += [formula([term_sign(own)]), *cell(term)]
        else:
            node = mathematics(term)
            assert not isinstance(node, str)
            out.append(formula([term_sign(own), *node[2:]]))
    return out


def _long_product(product: Product) -> list[Tree]:
    """Factors between which a line may end, and in whose brackets it may."""
    groups: list[list[Tree]] = []
    plain: list[Layout] = []
    for factor in (*product.factors, None):
        long = isinstance(factor, Brackets) and factor.kind == "()"
        if (long or factor is None) and plain:
            inside = plain[0] if len(plain) == 1 else Product(tuple(plain), product.sign)
            groups.append([mathematics(inside)])
            plain = []
        if long and isinstance(factor, Brackets):
            opening, closing = (formula([sign(c, stretchy="false")]) for c in "()")
            groups.append([opening, *cell(factor.inside), closing])
        elif factor is not None:
            plain.append(factor)
    return list(_apart(groups, [*([_sign(product.sign)] if product.sign else []), _BREAK]))


def _joined(own: str, value: list[Tree], operand: Layout | None) -> list[Tree]:
    """An operand with the sign before it; of a short one no line ends between the two."""
    if not own:
        return value
    both = [_sign(own), *value]
    short = operand is not None and not _is_longer(operand, _WHOLE)
    return [_BREAK, _whole(both)] if short else both


def _apart(groups: Iterable[list[Tree]], gap: list[Tree]) -> Iterable[Tree]:
    for number, group in enumerate(groups):
        yield from gap if number else ()
        yield from group


def _sign(own: str) -> Tree:
    return formula([sign(own)])


def _underlined(value: list[Tree]) -> list[Tree]:
    """What was asked, as an answer is underlined on paper."""
    return [classed("span", "answer", value)]


def _whole(value: list[Tree]) -> Tree:
    """What is not broken over lines."""
    return classed("span", "whole", value)


def classed(name: str, kind: str, children: Iterable[Tree]) -> Tree:
    """An element of a class."""
    return element(name, children, {"class": kind})


def _is_longer(layout: Layout, columns: int) -> bool:
    return width(to_text(layout)) > columns


def _is_long_product(layout: Layout) -> bool:
    """Whether a product is so long that a line may end in it."""
    return isinstance(layout, Product) and _is_longer(layout, _LEFT)


def _is_words(layout: Layout) -> bool:
    return isinstance(layout, Phrase | Words)


def _is_worded(layout: Layout) -> bool:
    """Whether a layout is a name of words in brackets."""
    return isinstance(layout, Brackets) and _is_words(layout.inside)


__all__ = ["cell", "inline", "rows"]
