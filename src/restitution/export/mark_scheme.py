"""A mark scheme as a table: HTML, and Typst's markup."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

from restitution.practice.mark_scheme import SchemeRow
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
    heads = "".join(f'<th scope="col">{each}</th>' for each in _HEADS)
    body = "".join(_html_row(row, new) for row, new in _with_parts(rows))
    total = sum(len(row.marks) for row in rows)
    return (
        f'<table class="scheme"><thead><tr>{heads}</tr></thead><tbody>{body}'
        f'<tr><td></td><td class="marks">{total}</td><td colspan="2">Total</td></tr>'
        "</tbody></table>"
    )


def _html_row(row: SchemeRow, new: bool) -> str:
    label = f"({escape(row.part)})" if new and row.part is not None else ""
    working = f"<br>{escape(row.working)}" if row.working else ""
    notes = "<br>".join(map(escape, row.notes))
    return (
        f'<tr><td>{label}</td><td class="marks">{escape(" ".join(row.marks))}</td>'
        f'<td>{escape(row.purpose)}{working}</td><td class="notes">{notes}</td></tr>'
    )


def to_typst(rows: Sequence[SchemeRow]) -> str:
    """The scheme as a table in Typst's markup."""
    cells = [f"[#strong[{words(each)}]]" for each in _HEADS]
    for row, new in _with_parts(rows):
        label = f"({row.part})" if new and row.part is not None else ""
        working = f" #linebreak() {words(row.working)}" if row.working else ""
        notes = " #linebreak() ".join(words(each) for each in row.notes)
        cells += [
            f"[{words(label)}]",
            f"[#strong[{words(' '.join(row.marks))}]]",
            f"[{words(row.purpose)}{working}]",
            f"[#text(size: 0.85em)[{notes}]]",
        ]
    total = sum(len(row.marks) for row in rows)
    cells += ["[]", f"[#strong[{words(str(total))}]]", f"[{words('Total')}]", "[]"]
    inside = ",\n  ".join(cells)
    return (
        "#table(columns: (auto, auto, 1.2fr, 1fr), stroke: 0.4pt, inset: 5pt, "
        f"align: left + top,\n  {inside},\n)"
    )


def _with_parts(rows: Sequence[SchemeRow]) -> list[tuple[SchemeRow, bool]]:
    """Rows, each with whether it is the first of its part."""
    parts = [None, *(row.part for row in rows)]
    return [(row, index == 0 or row.part != parts[index]) for index, row in enumerate(rows)]
