"""A worked solution for the terminal: sentences wrapped, equations aligned at their signs."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.explain.steps import Explanation, PartExplanation, Row, Step, Words
from restitution.render.layout import Layout, Relation, Sum
from restitution.render.text import to_text as one_line
from restitution.render.text import width as columns

_INDENT = 4
_MARKS = 8
_NO_BREAK = "\u00a0"


def to_text(explanation: Explanation, width: int = 80) -> str:
    """The whole working as Unicode text, at most ``width`` columns wide where that can be."""
    lines: list[str] = []
    if explanation.title:
        lines += [*_wrapped(explanation.title, width), ""]
    for part in explanation.parts:
        lines += _part(part, width)
    for warning in explanation.warnings:
        lines += _wrapped(f"Note: {warning}", width)
    while lines and not lines[-1]:
        lines.pop()
    return "\n".join(lines)


def _part(part: PartExplanation, width: int) -> list[str]:
    lines: list[str] = []
    if part.label:
        lines += [f"({part.label})", ""]
    for step in part.steps:
        made = _step(step, width)
        lines += made[1:] if made and not made[0] and not (lines and lines[-1]) else made
    if lines and lines[-1]:
        lines.append("")
    return lines


def _step(step: Step, width: int) -> list[str]:
    lines: list[str] = []
    if step.kind == "heading":
        return ["", *_wrapped(said(step.words), width)]
    intro = said(step.words)
    if step.principle:
        intro = f"{step.principle}: {intro}" if intro else f"{step.principle}:"
    if intro:
        wrapped = _wrapped(intro, width - (columns(step.mark) + 2 if step.mark else 0))
        if step.mark:
            wrapped[-1] = _marked(wrapped[-1], step.mark, width)
        lines += wrapped
    lines += _rows(step.rows, width)
    return lines


def said(words: Words) -> str:
    """Words with their mathematics, as one string; formulas are not to be broken."""
    return "".join(
        each if isinstance(each, str) else one_line(each).replace(" ", _NO_BREAK) for each in words
    )


def _wrapped(text: str, width: int) -> list[str]:
    """Lines of at most ``width`` columns; formulas (with no-break spaces) stay whole."""
    lines: list[str] = []
    current = ""
    for word in text.split(" "):
        trial = f"{current} {word}" if current else word
        if current and columns(trial) > width:
            lines.append(current)
            current = word
        else:
            current = trial
    lines.append(current)
    return [line.replace(_NO_BREAK, " ") for line in lines]


def _rows(rows: Sequence[Row], width: int) -> list[str]:
    lefts = [_operand(row.operands[0]) for row in rows]
    fitting = [
        columns(left)
        for row, left in zip(rows, lefts, strict=True)
        if _INDENT + columns(left) + _widest(row) <= width - _margin(row)
    ]
    room = max(fitting, default=_INDENT)
    if any(_INDENT + room + _widest(row) > width - _margin(row) for row in rows):
        room = min(room, _INDENT + 4)
    lines: list[str] = []
    for row, left in zip(rows, lefts, strict=True):
        lines += _row(row, left, room, width)
    return lines


def _margin(row: Row) -> int:
    """The columns kept for the marks."""
    return max(_MARKS, columns(row.mark) + 2)


def _widest(row: Row) -> int:
    return max((columns(_operand(each)) + 3 for each in row.operands[1:]), default=0)


def _operand(layout: Layout | None) -> str:
    return "" if layout is None else one_line(layout)


def _row(row: Row, left: str, room: int, width: int) -> list[str]:
    """One chain; what does not fit goes on below, under its own sign."""
    pad = " " * (_INDENT + max(0, room - columns(left)))
    limit = width - _margin(row)
    lines: list[str] = []
    current = pad + left
    start = " " * (_INDENT + room)
    if columns(left) > room:
        lines.append(" " * _INDENT + left)
        current = start
    for sign, operand in zip(row.signs, row.operands[1:], strict=True):
        piece = f" {sign} {_operand(operand)}"
        fresh = current.strip() == "" or current == pad + left
        if columns(current + piece) > limit and not fresh:
            lines.append(current)
            current = start
        if columns(current + piece) > limit and operand is not None:
            broken = _broken(operand, limit - columns(current) - columns(sign) - 2)
            current = f"{current} {sign} {broken[0]}"
            for more in broken[1:]:
                lines.append(current)
                current = f"{start} {' ' * columns(sign)} {more}"
            continue
        current += piece
    lines.append(current)
    if row.mark:
        lines[-1] = _marked(lines[-1], row.mark, width)
    if row.note:
        note = said(row.note)
        lines += [" " * (_INDENT + 2) + each for each in _wrapped(f"({note})", width - _INDENT - 2)]
    return lines


def _broken(layout: Layout, room: int) -> list[str]:
    """A long sum broken before a sign, or several cases broken between them."""
    if isinstance(layout, Sum) and len(layout.terms) > 1:
        pieces: list[str] = []
        for index, term in enumerate(layout.terms):
            text = (
                one_line(Sum((term,)))
                if index == 0
                else (f"{'−' if term[0] == '-' else '+'} {one_line(term[1])}")
            )
            if pieces and columns(f"{pieces[-1]} {text}") <= room:
                pieces[-1] = f"{pieces[-1]} {text}"
            else:
                pieces.append(text)
        return pieces
    if isinstance(layout, Relation):
        return [one_line(layout)]
    return [one_line(layout)]


def _marked(line: str, mark: str, width: int) -> str:
    gap = width - columns(line) - columns(mark)
    return f"{line}{' ' * max(2, gap)}{mark}"
