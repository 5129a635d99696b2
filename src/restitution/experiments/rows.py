"""A text of cells → rows: its encoding, what parts its cells, its numbers.

Semicolons, tabs, commas and spaces part cells, whichever the header has. Numbers have a decimal
point or a decimal comma.
"""

from __future__ import annotations

import csv
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from pathlib import Path

from restitution.errors import StatementError
from restitution.experiments.columns import UnitError, column_of
from restitution.records import dataclass

MAX_BYTES = 4_000_000
"""Of a text; a longer one is refused before it is read."""
MAX_ROWS = 20_000
MAX_CELL = 200
"""Characters of one cell."""
LARGEST = 1e9
"""A number beyond it is in the wrong unit, or in the wrong column."""

Data = str | bytes | PathLike[str] | Mapping[str, Sequence[object]]
"""A text in CSV, a path to one, or columns by their names."""


@dataclass(frozen=True)
class Row:
    """The cells of one line, which counts from 1."""

    line: int
    cells: tuple[str, ...]


def rows_of(data: Data) -> list[Row]:
    """The header and the rows of a table, without comments and empty lines.

    Raises StatementError for what is no table.
    """
    if isinstance(data, Mapping):
        return _of_columns(data)
    if isinstance(data, PathLike):
        data = _bytes_of(Path(data))
    text = _text(data)
    return _parted(text)


def _bytes_of(path: Path) -> bytes:
    try:
        with path.open("rb") as stream:
            return stream.read(MAX_BYTES + 1)
    except OSError as error:
        raise StatementError(f"{path}: cannot be read: {error.strerror}") from None


def _text(data: str | bytes) -> str:
    if len(data) > MAX_BYTES:
        rule = f"a table has at most {MAX_BYTES // 1_000_000} MB"
        raise StatementError(f"the table is too large: {rule}; split it, or leave frames out")
    text = data if isinstance(data, str) else _decoded(data)
    text = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    for number, line in enumerate(text.split("\n"), 1):
        if "\0" in line:
            raise StatementError("this is no text: it has a character of code 0", number)
    return text


def _decoded(data: bytes) -> str:
    encoding = "utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8"
    try:
        return data.decode(encoding)
    except UnicodeDecodeError as error:
        line = data[: error.start].count(b"\n") + 1
        rule = "this is no text in UTF-8; in a spreadsheet, save as CSV UTF-8"
        raise StatementError(rule, line) from None


def _of_columns(data: Mapping[str, Sequence[object]]) -> list[Row]:
    """Columns by name as rows, numbered as the lines of a file would be."""
    columns = {str(name): [*values] for name, values in data.items()}
    lengths = {name: len(values) for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        counts = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise StatementError(f"columns have as many values as each other: {counts}")
    if any(length > MAX_ROWS for length in lengths.values()):
        raise _too_many()
    rows = [Row(1, tuple(columns))]
    for line, values in enumerate(zip(*columns.values()), 2):
        rows.append(Row(line, tuple("" if value is None else str(value) for value in values)))
    return rows


def _parted(text: str) -> list[Row]:
    lines = text.split("\n")
    first = _header(lines)
    separator = _separator(lines[first], first + 1)
    rows: list[Row] = []
    for row in _split(lines, first, separator):
        if any(row.cells):
            rows.append(row)
        if len(rows) > MAX_ROWS + 1:
            raise _too_many()
    return rows


def _header(lines: list[str]) -> int:
    """Where the header is: a program that exports a table may write a title above it."""
    counting = [index for index, line in enumerate(lines) if _counts(line)]
    if not counting:
        raise StatementError("the table is empty: a header such as alpha,beta, then a row a trial")
    for index in counting[:_ABOVE]:
        names = re.split(r"[\t;,]", lines[index][: MAX_CELL * _WIDEST])
        if sum(_known(name) for name in names) > 1:
            return index
    return counting[0]


_ABOVE = 6
_WIDEST = 50


def _known(name: str) -> bool:
    try:
        return column_of(name.strip(' "')).quantity is not None
    except UnitError:
        return True


def _counts(line: str) -> bool:
    return bool(line.strip(" \t;,")) and not line.lstrip().startswith("#")


def _separator(header: str, line: int) -> str:
    for separator in ("\t", ";", ","):
        if separator in header:
            return separator
    words = header.split()
    if len(words) > 1 and all(map(_known, words)):
        return " "
    rule = "a header names two columns or more, parted by commas, semicolons or tabs"
    raise StatementError(f"{_cut(header)!r}: {rule}, such as alpha,beta", line)


def _split(lines: list[str], first: int, separator: str) -> Iterator[Row]:
    """The rows from the header on.

    A cell in quotes may hold the separator, but ends on its line: so a quote that is never closed
    spoils one row, and not all that follow.
    """
    for number, line in enumerate(lines[first:], first + 1):
        if not _counts(line):
            continue
        if separator == " ":
            yield Row(number, tuple(line.split()))
            continue
        try:
            cells = next(csv.reader([line], delimiter=separator, skipinitialspace=True))
        except csv.Error as error:
            raise StatementError(f"this line is no row of cells: {error}", number) from None
        if number == first + 1:
            long = next((cell for cell in cells if len(cell) > MAX_CELL), None)
            if long is not None:
                rule = f"a name of a column has at most {MAX_CELL} characters"
                raise StatementError(f"{_cut(long)!r}: {rule}", number)
        yield Row(number, tuple(cell.strip() for cell in cells))


def _too_many() -> StatementError:
    return StatementError(f"the table is too long: it has at most {MAX_ROWS} rows")


def _cut(text: str) -> str:
    return text if len(text) <= 40 else text[:40] + "…"


def shown(cell: str) -> str:
    """A cell as a message shows it."""
    return _cut(printable(cell))


def printable(text: str) -> str:
    """A text without what a terminal would take for a command."""
    return "".join(
        character if character.isprintable() else "\N{REPLACEMENT CHARACTER}" for character in text
    )


_NUMBER = re.compile(r"[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][+-]?\d{1,3})?", re.ASCII)
_TWO_SIGNS = re.compile(r"[+-]?[\d.,' ]*\d[\d.,' ]*")


def number_of(cell: str) -> float:
    """The number of a cell. Raises ValueError with the rule where it is none."""
    text = cell.replace("−", "-").removesuffix("°").strip()
    if len(text) <= MAX_CELL and _NUMBER.fullmatch(text):
        value = float(text.replace(",", "."))
        if not math.isfinite(value):
            raise ValueError("a number is finite")
        if abs(value) > LARGEST:
            raise ValueError(f"a number is at most {LARGEST:g} in size; take another unit")
        return value
    if text.lower().lstrip("+-") in ("nan", "inf", "infinity", "na", "n/a", "-"):
        raise ValueError("a number is needed; leave a row out where nothing was measured")
    if _TWO_SIGNS.fullmatch(text[:MAX_CELL]):
        raise ValueError("a number has one decimal sign, and no sign between thousands")
    raise ValueError("this is no number")
