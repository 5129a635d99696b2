"""A mark scheme as a table: HTML, and Typst's markup."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from restitution.practice.marking.mark_scheme import SchemeRow
from restitution.render.document import cells, typst
from restitution.render.markup import to_markup
from restitution.render.typst import words

_HEADS = ("Part", "Marks", "For", "Notes")

STYLE = """
table.scheme { border-collapse: collapse; width: 100%; font: 400 .92rem/1.4 Georgia, serif }
table.scheme th, table.scheme td { border: 1px solid #888; padding: .3rem .45rem; text-align: left;
  vertical-align: top } table.scheme tr { break-inside: avoid }
table.scheme .marks { white-space: nowrap; font-weight: 600 }
table.scheme .notes { font-size: .86rem }
"""


def to_html(rows: Sequence[SchemeRow]) -> str:
    """The scheme as a table."""
    parted = _has_parts(rows)
    heads = "".join(f'<th scope="col">{each}</th>' for each in _HEADS[not parted :])
    body = "".join(_html_row(row, new, parted) for row, new in _with_parts(rows))
    total = sum(len(row.marks) for row in rows)
    return (
        f'<table class="scheme"><thead><tr>{heads}</tr></thead><tbody>{body}'
        f'<tr>{"<td></td>" if parted else ""}<td class="marks">{total}</td>'
        '<td colspan="2">Total</td></tr></tbody></table>'
    )


def _html_row(row: SchemeRow, new: bool, parted: bool) -> str:
    label = f"({escape(row.part)})" if new and row.part is not None else ""
    line = f"<br>{to_markup(*cells.inline(row.line))}" if row.line else ""
    notes = "<br>".join(map(escape, row.notes))
    return (
        f"<tr>{f'<td>{label}</td>' if parted else ''}"
        f'<td class="marks">{escape(" ".join(row.marks))}</td>'
        f'<td>{escape(row.purpose)}{line}</td><td class="notes">{notes}</td></tr>'
    )


def to_typst(rows: Sequence[SchemeRow]) -> str:
    """The scheme as a table in Typst's markup; its head stands on every page."""
    parted = _has_parts(rows)
    heads = ", ".join(f"[#strong[{words(each)}]]" for each in _HEADS[not parted :])
    content = [f"table.header({heads})"]
    for row, new in _with_parts(rows):
        label = f"({row.part})" if new and row.part is not None else ""
        line = f" #linebreak() {typst.inline(row.line)}" if row.line else ""
        notes = " #linebreak() ".join(words(note) for note in row.notes)
        content += [f"[{words(label)}]"] * parted
        content += [
            f"[#strong[{words(' '.join(row.marks))}]]",
            f"[{words(row.purpose)}{line}]",
            f"[#text(size: 0.85em)[{notes}]]",
        ]
    total = sum(len(row.marks) for row in rows)
    content += ["[]"] * parted
    content += [f"[#strong[{words(str(total))}]]", f"[{words('Total')}]", "[]"]
    inside = ",\n  ".join(content)
    columns = "(auto, auto, 1.2fr, 1fr)" if parted else "(auto, 1.2fr, 1fr)"
    return (
        f"#table(columns: {columns}, stroke: 0.4pt, inset: 5pt, align: left + top,\n  {inside},\n)"
    )


def _has_parts(rows: Sequence[SchemeRow]) -> bool:
    return any(row.part is not None for row in rows)


def _with_parts(rows: Sequence[SchemeRow]) -> list[tuple[SchemeRow, bool]]:
    """Rows, each with whether it is the first of its part."""
    parts = [None, *(row.part for row in rows)]
    return [(row, index == 0 or row.part != parts[index]) for index, row in enumerate(rows)]
