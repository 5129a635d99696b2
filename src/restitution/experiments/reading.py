"""Text → table."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from os import PathLike
from pathlib import Path

from restitution.errors import StatementError
from restitution.experiments.records import Kind, Measured, Table, WallReading


def table_of(
    data: str | bytes | PathLike[str] | Mapping[str, Sequence[object]],
    kind: Kind | None,
    from_normal: bool,
) -> Table:
    """The table of a text."""
    if isinstance(data, Mapping):
        text = ",".join(data) + "\n" + "\n".join(",".join(map(str, r)) for r in zip(*data.values()))
    elif isinstance(data, str):
        text = data
    elif isinstance(data, bytes):
        text = data.decode("utf-8-sig")
    else:
        text = Path(data).read_text(encoding="utf-8-sig")
    rows = list(csv.DictReader(io.StringIO(text)))
    readings = []
    for line, row in enumerate(rows, 2):
        try:
            values = {name: float(cell) for name, cell in row.items()}
        except (TypeError, ValueError):
            raise StatementError("not a number", line) from None
        u, v = (Measured(values[name]) if name in values else None for name in ("u", "v"))
        alpha, beta = Measured(values["alpha"]), Measured(values["beta"])
        readings.append(WallReading(line, alpha, beta, u, v))
    return Table(kind or "wall", tuple(readings), units={"alpha": "degrees", "beta": "degrees"})
