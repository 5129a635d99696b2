"""A mark scheme as a table of a document."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.practice.marking.mark_scheme import SchemeRow
from restitution.render.document import Cell, CellPiece, LineBreak, Strong, Table

_HEADS = ("Part", "Marks", "For", "Notes")
_SHARES = (None, None, 1.2, 1.0)


def to_table(rows: Sequence[SchemeRow]) -> Table:
    """The scheme as a table, with the total below; its first column are parts, if there are any."""
    first = 0 if any(row.part is not None for row in rows) else 1
    total = sum(len(row.marks) for row in rows)
    labels = _labels(rows)
    body = [_row(row, label) for row, label in zip(rows, labels, strict=True)]
    body.append(("", (Strong(f"{total}"),), "Total", ""))
    return Table(
        _HEADS[first:],
        tuple(cells[first:] for cells in body),
        "l" * (len(_HEADS) - first),
        ruled=True,
        shares=_SHARES[first:],
        remarks=(len(_HEADS) - first - 1,),
    )


def _row(row: SchemeRow, label: str) -> tuple[Cell, ...]:
    purpose: Cell = (row.purpose, LineBreak(), *row.line) if row.line else (row.purpose,)
    notes: list[CellPiece] = [piece for note in row.notes for piece in (LineBreak(), note)]
    return label, (Strong(" ".join(row.marks)),), purpose, tuple(notes[1:])


def _labels(rows: Sequence[SchemeRow]) -> list[str]:
    """The part of each row, where it is the first of its part."""
    before = [None, *(row.part for row in rows)]
    return [
        f"({row.part})" if row.part is not None and row.part != former else ""
        for former, row in zip(before, rows, strict=False)
    ]
