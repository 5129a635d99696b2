"""A worked solution as HTML with MathML: one page that needs nothing else, light or dark."""

from __future__ import annotations

from html import escape

from restitution.drawing.svg import to_svg
from restitution.explaining.lines.saying import note, say
from restitution.render.layout import (
    Brackets,
    Fraction,
    Layout,
    Phrase,
    Product,
    Relation,
    Sum,
)
from restitution.render.layout import Words as Said
from restitution.render.mathml import to_mathml
from restitution.render.page import page
from restitution.render.paragraph import paragraph
from restitution.render.text import NO_BREAK, to_text, width
from restitution.workings.rendering.steps import PartExplanation, Row, Step, Words, Working

# Columns of plain text below which a sum is never broken.
_WHOLE = 24
# Columns of plain text beyond which a left side may be broken.
_LEFT = 44

STYLE = """
.restitution { --ink: #1b1b1f; --paper: #fff; --soft: #5f6368; --line: #d9dbe0; --mark: #8a1c1c;
  color: var(--ink); background: var(--paper); max-width: 46rem; margin: 0 auto; padding: 1rem;
  font: 1.05rem/1.55 Georgia, "Times New Roman", serif; }
@media (prefers-color-scheme: dark) { .restitution { --ink: #e8e8ec; --paper: #17181c;
  --soft: #a3a7ae; --line: #3a3d44; --mark: #ff9d8f; } }
.restitution h1 { font-size: 1.35rem; line-height: 1.25; margin: 0 0 1rem; }
.restitution h2 { font-size: 1.1rem; margin: 1.6rem 0 .6rem; padding-top: .6rem;
  border-top: 1px solid var(--line); }
.restitution h3 { font-size: 1.02rem; margin: 1.2rem 0 .3rem; }
.restitution p { margin: .5rem 0 .2rem; }
.restitution .principle { font-style: italic; }
.restitution table { border-collapse: collapse; margin: .1rem 0 .3rem 2rem;
  width: calc(100% - 2rem); }
.restitution td math { math-style: normal; }
.restitution td { padding: .16rem .15rem; vertical-align: baseline; }
.restitution td:first-child { position: relative; }
.restitution td .item { position: absolute; left: -2rem; }
.restitution td.l { text-align: right; white-space: nowrap; width: 1%; }
.restitution td.l wbr { display: none; }
.restitution td.l.w { white-space: normal; width: 50%; }
.restitution td.l.w wbr { display: inline; }
.restitution td.s { width: 1%; white-space: nowrap; }
.restitution td.m, .restitution .mark { color: var(--mark); font: 600 .8rem/1 system-ui, sans-serif;
  text-align: right; white-space: nowrap; }
.restitution td.m { width: 6rem; padding: 0 0 0 .6rem; }
.restitution .mark { float: right; padding: .4rem 0 0 .6rem; }
.restitution figure { margin: .8rem 0; text-align: center; break-inside: avoid; }
.restitution figure svg { width: 30rem; max-width: 100%; height: auto; }
.restitution .whole { white-space: nowrap; }
.restitution .answer { border-bottom: 3px double var(--soft); }
.restitution .note { color: var(--soft); font-size: .9em; }
.restitution math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math;
  font-size: 1.05em; }
@media (max-width: 34rem) {
  .restitution { padding: .7rem; }
  .restitution table, .restitution tbody { display: block; width: auto; margin-left: .6rem;
    overflow-x: auto; }
  .restitution tr { display: flow-root; line-height: 1.9; }
  .restitution td { display: inline; padding: 0 .1rem; }
  .restitution td.l, .restitution td.l.w { white-space: normal; }
  .restitution td.l wbr { display: inline; }
  .restitution td .item { position: static; padding-right: .5rem; }
  .restitution td.l:empty { padding-left: 1rem; }
  .restitution td.m { float: right; padding: .4rem 0 0 .6rem; }
  .restitution td.m:empty { display: none; }
}
@media print { .restitution { --ink: #000; --paper: #fff; --soft: #333; --line: #999;
  --mark: #000; max-width: none; padding: 0; font-size: 11pt; }
  .restitution table, .restitution p { break-inside: avoid; }
  .restitution td { vertical-align: middle; }
  .restitution p { break-after: avoid; } }
"""
_PAGE = (
    "html { background: #fff } @media (prefers-color-scheme: dark) "
    "{ html { background: #17181c } } body { margin: 0 }"
)


def to_html(explanation: Working) -> str:
    """A whole page."""
    return page(explanation.title or str(say("page.title")), _PAGE, to_fragment(explanation))


def to_fragment(explanation: Working) -> str:
    """What stands in a page (or in a notebook), with its style."""
    return f"<style>{STYLE}</style>\n{to_body(explanation)}"


def to_body(explanation: Working) -> str:
    """The same without its style, for a page that has it already."""
    out = ['<article class="restitution">']
    if explanation.title:
        out.append(f"<h1>{escape(explanation.title)}</h1>")
    for part in explanation.parts:
        out += _part(part)
    out += [f'<p class="note">{escape(note(warning))}</p>' for warning in explanation.warnings]
    out.append("</article>")
    return "\n".join(out)


def _part(part: PartExplanation) -> list[str]:
    out = ["<section>"]
    if part.label:
        out.append(f"<h2>({escape(part.label)})</h2>")
    for step in part.steps:
        out += _step(step)
    out.append("</section>")
    return out


def _step(step: Step) -> list[str]:
    words = inline(step.words)
    if step.picture is not None:
        return [f"<figure>{to_svg(step.picture)}</figure>"]
    if step.kind == "heading":
        return [f"<h3>{words}</h3>"]
    if step.principle:
        words = f'<span class="principle">{escape(step.principle)}{step.sign}</span> {words}'
    out: list[str] = []
    if words:
        mark = f'<span class="mark">{escape(step.mark)}</span>' if step.mark else ""
        out.append(f"<p>{mark}{words}</p>")
    if step.rows:
        out += ["<table>", *(line for row in step.rows for line in table_rows(row)), "</table>"]
    return out


def inline(words: Words) -> str:
    """Words with their mathematics, to stand in a paragraph.

    What follows a short formula without a blank stays on its line.
    """
    return paragraph(words, _cell, lambda formula: width(to_text(formula)) <= _WHOLE).strip()


def table_rows(row: Row) -> list[str]:
    """A line of mathematics as rows of a table: long chains take several."""
    mark = f'<td class="m">{escape(row.mark)}</td>'
    none = '<td class="m"></td>'
    note = f'<span class="note">{inline(row.note)}</span>' if row.note else ""
    note = note if goes_on(row.note) or not note else f" {note}"
    left = _cell(row.operands[0])
    label = f'<span class="item">{escape(row.label)}</span>' if row.label else ""
    if not row.signs:
        left = f"{label}{_underlined(left) if row.answer else left}"
        return [f'<tr><td colspan="3">{left}{note}</td>{mark}</tr>']
    wide = row.operands[0] is not None and width(to_text(row.operands[0])) > _LEFT
    out: list[str] = []
    broken = lines(row)
    for index, (sign, operands) in enumerate(broken):
        last = index == len(broken) - 1
        final = len(operands) - 1 if row.answer and last else -1
        right = "".join(
            _piece(s, _underlined(_cell(operand)) if n == final else _cell(operand), operand)
            for n, (s, operand) in enumerate(operands)
        )
        kind = "l w" if wide and index == 0 else "l"
        out.append(
            f'<tr><td class="{kind}">{label + left if index == 0 else ""}</td>'
            f'<td class="s"><math><mo>{escape(sign)}</mo></math></td>'
            f"<td>{right}{note if last else ''}</td>{mark if last else none}</tr>"
        )
    return out


def _underlined(cell: str) -> str:
    """What was asked, as an answer is underlined on paper."""
    return f'<span class="answer">{cell}</span>'


def _piece(sign: str, cell: str, operand: Layout | None) -> str:
    """An operand with the sign before it; of a short one no line ends between the two."""
    if not sign:
        return cell
    whole = f"<math><mo>{escape(sign)}</mo></math>{cell}"
    short = operand is not None and width(to_text(operand)) <= _WHOLE
    return f'<wbr><span class="whole">{whole}</span>' if short else whole


def goes_on(words: Words) -> bool:
    """Whether words behind a line begin with a comma."""
    return bool(words) and isinstance(words[0], str) and words[0].startswith(",")


def lines(row: Row) -> list[tuple[str, list[tuple[str, Layout | None]]]]:
    """A chain in lines: short ones in one, long ones with each sign on its own.

    A line is its first sign, and the operands with the signs between them (none for the first).
    """
    pieces = list(zip(row.signs, row.operands[1:], strict=True))
    room = sum(width(to_text(operand)) + 3 for operand in row.operands if operand is not None)
    if room <= 80 or len(pieces) == 1:
        (first, operand), *rest = pieces
        return [(first, [("", operand), *rest])]
    return [(sign, [("", operand)]) for sign, operand in pieces]


def _is_long(layout: Layout) -> bool:
    """Whether a product is so long that a line may end in it."""
    return isinstance(layout, Product) and width(to_text(layout)) > _LEFT


def _long_product(product: Product) -> str:
    """Factors between which a line may end, and in whose brackets it may."""
    sign = f"<math><mo>{product.sign}</mo></math>" if product.sign else ""
    pieces: list[str] = []
    plain: list[Layout] = []
    for factor in (*product.factors, None):
        long = isinstance(factor, Brackets) and factor.kind == "()"
        if (long or factor is None) and plain:
            inside = plain[0] if len(plain) == 1 else Product(tuple(plain), product.sign)
            pieces.append(to_mathml(inside))
            plain = []
        if long and isinstance(factor, Brackets):
            opening, closing = (f'<math><mo stretchy="false">{c}</mo></math>' for c in "()")
            pieces.append(f"{opening}{_cell(factor.inside)}{closing}")
        elif factor is not None:
            plain.append(factor)
    return f"{sign}<wbr>".join(pieces)


def _worded(layout: Layout) -> bool:
    """Whether a layout is a name of words in brackets."""
    return isinstance(layout, Brackets) and isinstance(layout.inside, Phrase | Said)


def _cell(layout: Layout | None) -> str:
    """Mathematics; words among it and long sums may be broken over lines."""
    if layout is None:
        return ""
    if isinstance(layout, Sum) and len(layout.terms) > 1 and width(to_text(layout)) > _WHOLE:
        first, *rest = layout.terms
        plain = first[0] == "+" and isinstance(first[1], Phrase | Said)
        plain = plain or (first[0] == "+" and _is_long(first[1]))
        pieces = [_cell(first[1]) if plain else to_mathml(Sum((first,)))]
        for sign, term in rest:
            pieces.append(f'<math><mo form="infix">{"−" if sign == "-" else "+"}</mo>')
            worded = isinstance(term, Phrase | Said)
            apart = worded or _is_long(term)
            own = f"</math>{_cell(term)}" if apart else to_mathml(term).removeprefix("<math>")
            pieces.append(own)
        return "".join(pieces).replace("</math><math>", "</math><wbr><math>")
    if isinstance(layout, Said):
        return escape(layout.text)
    if isinstance(layout, Relation) and width(to_text(layout)) > _WHOLE:
        start, *others = layout.operands
        return _cell(start) + "".join(
            f"<wbr><math><mo>{escape(sign)}</mo></math>{_cell(each)}"
            for sign, each in zip(layout.signs, others, strict=True)
        )
    if isinstance(layout, Phrase):
        gap = escape(layout.separator)
        whole = gap.join(_cell(item) for item in layout.items)
        return f'<span class="whole">{whole}</span>' if layout.separator == NO_BREAK else whole
    if isinstance(layout, Product) and _is_long(layout):
        return _long_product(layout)
    if isinstance(layout, Fraction) and any(map(_worded, (layout.above, layout.below))):
        return f"{_cell(layout.above)}<wbr>/{_cell(layout.below)}"  # words may be broken
    if isinstance(layout, Brackets) and _worded(layout):
        return f"({_cell(layout.inside)})"
    if isinstance(layout, Product) and isinstance(layout.factors[-1], Phrase | Said):
        *head, last = layout.factors
        before = Product(tuple(head)) if len(head) > 1 else head[0]
        return f"{_cell(before)} <math><mo>{layout.sign}</mo></math> {_cell(last)}"
    return to_mathml(layout)
