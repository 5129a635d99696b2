"""A worked solution as Typst markup, for sheets that are printed: marks stand in the margin."""

from __future__ import annotations

from restitution.drawing.svg import to_svg
from restitution.explaining.lines.saying import note
from restitution.render.layout import Layout
from restitution.render.layout import Words as Said
from restitution.render.typst import literal, to_typst, words
from restitution.workings.rendering.html import goes_on, lines
from restitution.workings.rendering.steps import PartExplanation, Row, Step, Words, Working

#: What the markup below calls; it stands once at the head of a document.
PREAMBLE = """
#let working-mark(mark) = text(size: 0.85em, weight: "bold", mark)
#let working-picture(svg) = align(center, block(above: 1em, below: 1em,
  image(bytes(svg), format: "svg")))
#let working-line(body, mark) = block(above: 0.7em, below: 0.7em, grid(
  columns: (1fr, 5.6em), column-gutter: 0.6em, body, align(right + bottom, working-mark(mark))))
// Each row is one line of text, so that all of it stands on one baseline; the left sides are as
// wide as the widest that is less than half a page. The leading is nothing, as a line of text
// lets tall formulas reach into it.
#let working-rows(..rows) = block(above: 0.8em, below: 0.8em, width: 100%, context {
  set par(leading: 0em)
  let room = calc.max(0cm, ..rows.pos().map(row => measure(row.at(0)).width).filter(w => w < 8cm))
  for (left, sign, right, mark) in rows.pos() {
    let body = if sign == none { left } else {
      let beside = measure(left).width
      if beside > room { left } else { box(width: room, align(std.right, left)) }
      [#h(0.3em)#sign#h(0.3em)#right]
    }
    // What does not fit into a line goes on below its right side.
    let hanging = if sign == none or measure(left).width > room { 2em } else {
      calc.min(room + 1.6em.to-absolute(), 4.5cm) }
    block(above: 0.65em, below: 0.65em, grid(columns: (1fr, 5.6em), column-gutter: 0.6em,
      align: (std.left + horizon, std.right + horizon),
      par(hanging-indent: hanging, leading: 0.25em, body), working-mark(mark)))
  }
})
"""


def to_markup(explanation: Working) -> str:
    """The working as Typst markup, to stand in a document that begins with ``PREAMBLE``."""
    blocks: list[str] = []
    for part in explanation.parts:
        blocks += _part(part)
    blocks += [f"#emph[{words(note(each))}]" for each in explanation.left_over]
    return "\n\n".join(blocks) + "\n"


def _part(part: PartExplanation) -> list[str]:
    blocks = [f"#strong[({words(part.label)})]"] if part.label else []
    for step in part.steps:
        blocks += _step(step)
    return blocks


def _step(step: Step) -> list[str]:
    text = _inline(step.words)
    if step.picture is not None:
        return [f"#working-picture({literal(to_svg(step.picture))})"]
    if step.kind == "heading":
        return [f"#block(above: 1.1em, sticky: true)[#strong[{text}]]"]
    if step.principle:
        text = f"#emph[{words(step.principle)}{step.sign}] {text}"
    blocks: list[str] = []
    if text.strip():
        line = f"#working-line([{text}], {literal(step.mark)})"
        blocks.append(f"#block(sticky: true)[{line}]" if step.rows else line)
    if step.rows:
        rows = [each for row in step.rows for each in _row(row)]
        blocks.append("#working-rows(\n  " + ",\n  ".join(rows) + ",\n)")
    return blocks


def _row(row: Row) -> list[str]:
    """Arrays of the left side, the sign, the right side and the mark."""
    label = f"{words(row.label)} #h(0.4em) " if row.label else ""
    left = label + _operand(row.operands[0])
    note = f"#text(size: 0.9em)[{_inline(row.note)}]" if row.note else ""
    note = note if goes_on(row.note) or not note else f" {note}"
    mark = literal(row.mark)
    if not row.signs:
        return [f"([{left}{note}], none, [], {mark})"]
    cells: list[str] = []
    broken = lines(row)
    for index, (sign, operands) in enumerate(broken):
        last = index == len(broken) - 1
        right = "".join(f"{f' ${s}$ ' if s else ''}{_operand(operand)}" for s, operand in operands)
        cells.append(
            f"([{left if index == 0 else ''}], [${sign}$], "
            f"[{right}{note if last else ''}], {mark if last else literal('')})"
        )
    return cells


def _inline(parts: Words) -> str:
    return "".join(words(part) if isinstance(part, str) else to_typst(part) for part in parts)


def _operand(layout: Layout | None) -> str:
    if layout is None:
        return ""
    if isinstance(layout, Said):
        return words(layout.text)
    return to_typst(layout, block=True)
