"""Rows → readings, trials or tracks; what is wrong with a row is told, and the rest goes on."""

from __future__ import annotations

import math
import statistics
from collections.abc import Callable, Iterator
from dataclasses import field
from typing import TypeVar

from restitution.counting import counted
from restitution.errors import StatementError
from restitution.experiments.columns import (
    DIMENSIONS,
    SPHERES,
    TRACKS,
    VELOCITIES,
    WALL,
    Column,
    UnitError,
    column_of,
)
from restitution.experiments.records import (
    KINDS,
    Fault,
    Kind,
    Measured,
    MeasuredSphere,
    Position,
    SpheresTrial,
    Table,
    Track,
    Velocity,
    WallReading,
)
from restitution.experiments.rows import Row, number_of, printable, shown
from restitution.records import dataclass

SAME_TIME = 1e-9
NOTHING = 1e-30
"""What is less is 0, so that no quotient of two values overflows."""
MAX_NAME = 40
"""Characters of the name of a trial or of a body."""
_T = TypeVar("_T")
_QUANTITIES = {"wall": WALL, "spheres": SPHERES, "tracks": TRACKS}


class _FaultError(Exception):
    """A row that is left out, and why."""

    def __init__(self, fault: Fault) -> None:
        super().__init__(str(fault))
        self.fault = fault


@dataclass(frozen=True)
class Options:
    """How a table is to be read.

    ``kind`` follows from the columns where it is None. The errors are for values of which none is
    in the table, in degrees and in the unit of the speeds.
    """

    kind: Kind | None = None
    from_normal: bool = False
    angle_error: float | None = None
    speed_error: float | None = None

    def __post_init__(self) -> None:
        for name in ("angle_error", "speed_error"):
            value = _as_float(getattr(self, name))
            rule = None if value is None else _rule_of_error(value, name.removesuffix("_error"))
            if rule is not None:
                raise StatementError(f"{name.replace('_', ' ')} {value:g}: {rule}")


def _as_float(number: float | None) -> float | None:
    """A whole number that no float can hold is infinite."""
    try:
        return None if number is None else float(number)
    except OverflowError:
        return math.inf


LEAST_ERROR, LARGEST_ANGLE_ERROR = 1e-9, 45.0


def _rule_of_error(error: float, dimension: str | None) -> str | None:
    """What an error breaks; None where it is one."""
    if not 0 < error < math.inf:
        return "an error is more than 0, and finite"
    if error < LEAST_ERROR:
        return f"an error is at least {LEAST_ERROR:g}"
    if dimension == "angle" and error > LARGEST_ANGLE_ERROR:
        return f"the error of an angle is at most {LARGEST_ANGLE_ERROR:g}°"
    return None


@dataclass
class _Sheet:
    """The columns of a table, by quantity, and what is said of its rows."""

    options: Options
    values: dict[str, tuple[int, Column]] = field(default_factory=dict)
    errors: dict[str, tuple[int, Column]] = field(default_factory=dict)
    width: int = 0
    faults: list[Fault] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def __contains__(self, quantity: str) -> bool:
        return quantity in self.values

    def measured(self, row: Row, quantity: str) -> Measured:
        """The value of a cell with its error. Raises _FaultError where there is none."""
        index, column = self.values[quantity]
        cell = row.cells[index] if index < len(row.cells) else ""
        if not cell:
            raise _fault(row, column, "", "no value")
        text, _, beside = cell.partition("±")
        value = self._number(row, column, text) * column.factor
        value = value if abs(value) > NOTHING else 0.0
        error = None
        if quantity in self.errors:
            place, other = self.errors[quantity]
            given = row.cells[place] if place < len(row.cells) else ""
            error = self._error(row, other, given) if given else None
        elif beside:
            error = self._error(row, column, beside)
        return Measured(value, error or self.usual_error(quantity))

    def usual_error(self, quantity: str) -> float | None:
        """What the options have for all values of a dimension."""
        errors = {"angle": self.options.angle_error, "speed": self.options.speed_error}
        return errors.get(DIMENSIONS[quantity])

    def optional(self, row: Row, quantity: str) -> Measured | None:
        """None where there is no such column, or no value in it."""
        if quantity not in self.values:
            return None
        index = self.values[quantity][0]
        if index >= len(row.cells) or not row.cells[index]:
            return None
        return self.measured(row, quantity)

    def name(self, row: Row, quantity: str) -> str:
        """The text of a cell as it can be printed, "" where there is none."""
        if quantity not in self.values:
            return ""
        index = self.values[quantity][0]
        return printable(row.cells[index])[:MAX_NAME] if index < len(row.cells) else ""

    def require(self, row: Row, quantity: str, good: bool, rule: str) -> None:
        """Raises _FaultError where a value is not what it can be."""
        if not good:
            index, column = self.values[quantity]
            raise _fault(row, column, row.cells[index], rule)

    def from_rows(self, rows: list[Row], make: Callable[[Row], _T]) -> Iterator[_T]:
        """What is made of the rows; those with a fault are left out."""
        for row in rows:
            try:
                if any(row.cells[self.width :]):
                    rule = f"{len(row.cells)} values for {counted(self.width, 'column')}"
                    hint = "; with decimal commas, part the columns by semicolons"
                    raise _FaultError(Fault(row.line, "", "", rule + hint))
                yield make(row)
            except _FaultError as error:
                self.faults.append(error.fault)

    def units(self) -> dict[str, str]:
        return {name: column.unit for name, (_, column) in self.values.items() if column.unit}

    def _number(self, row: Row, column: Column, cell: str) -> float:
        try:
            return number_of(cell.strip())
        except ValueError as error:
            raise _fault(row, column, cell, str(error)) from None

    def _error(self, row: Row, column: Column, cell: str) -> float:
        error = self._number(row, column, cell) * column.factor
        rule = _rule_of_error(error, DIMENSIONS.get(column.quantity or ""))
        if rule is not None:
            raise _fault(row, column, cell, rule)
        return error


def _fault(row: Row, column: Column, cell: str, rule: str) -> _FaultError:
    return _FaultError(Fault(row.line, shown(column.header), shown(cell), rule))


def table_of(rows: list[Row], options: Options) -> Table:
    """The table of a header and its rows.

    Raises StatementError where the columns are not those of an experiment, or no row can be read.
    """
    if options.kind is not None and options.kind not in KINDS:
        raise StatementError(f"kind {options.kind!r}: it is one of {', '.join(KINDS)}")
    sheet = _sheet_of(rows[0], options)
    kind = options.kind or _kind_of(sheet, rows[0])
    _require_columns(sheet, kind, rows[0])
    _note_columns(sheet, kind, rows[0])
    if len(rows) == 1:
        raise StatementError("the table has a header and no rows below it", rows[0].line)
    table = _MAKERS[kind](sheet, rows[1:])
    if not (table.readings or table.trials or table.tracks):
        raise _unreadable(sheet.faults)
    return table


def _sheet_of(header: Row, options: Options) -> _Sheet:
    sheet = _Sheet(options, width=len(header.cells))
    while sheet.width and not header.cells[sheet.width - 1]:
        sheet.width -= 1
    for index, cell in enumerate(header.cells[: sheet.width]):
        try:
            column = column_of(cell)
        except UnitError as error:
            raise StatementError(printable(str(error)), header.line) from None
        if column.quantity is None:
            continue
        of_kind = sheet.errors if column.is_error else sheet.values
        if column.quantity in of_kind:
            raise StatementError(
                f"two columns are {column.quantity}: {of_kind[column.quantity][1].header!r} and "
                f"{shown(cell)!r}",
                header.line,
            )
        of_kind[column.quantity] = index, column
    return sheet


def _kind_of(sheet: _Sheet, header: Row) -> Kind:
    kinds = [kind for kind in KINDS if not _missing(sheet, kind)]
    if len(kinds) == 1:
        return kinds[0]
    if kinds:
        rule = f"the columns are those of {' and of '.join(kinds)}: give the kind"
        raise StatementError(rule, header.line)
    names = ", ".join(shown(cell) for cell in header.cells[:12])
    raise StatementError(
        f"the columns are {names}: a wall needs alpha and beta, two spheres u_A_x, u_A_y, u_B_x, "
        "…, v_B_y (or u_A, u_A_angle, …), tracks t, x and y",
        header.line,
    )


def _missing(sheet: _Sheet, kind: Kind) -> list[str]:
    if kind == "wall":
        return [name for name in ("alpha", "beta") if name not in sheet]
    if kind == "tracks":
        return [name for name in ("t", "x", "y") if name not in sheet]
    missing = []
    for name in VELOCITIES:
        parts = [f"{name}_x", f"{name}_y"]
        polar = [name, f"{name}_angle"]
        chosen = polar if any(column in sheet for column in polar) else parts
        if name == "u_B" and not any(column in sheet for column in chosen):
            continue  # B at rest
        missing += [column for column in chosen if column not in sheet]
    return missing


def _require_columns(sheet: _Sheet, kind: Kind, header: Row) -> None:
    missing = _missing(sheet, kind)
    if missing:
        raise StatementError(f"{kind}: no column {', '.join(missing)}", header.line)
    for name, (_, column) in sheet.errors.items():
        if name not in sheet and name in _QUANTITIES[kind]:
            rule = f"an error without its value: there is no column {name}"
            raise StatementError(f"column {shown(column.header)!r}: {rule}", header.line)


def _note_columns(sheet: _Sheet, kind: Kind, header: Row) -> None:
    """Columns that are not read are told."""
    read = {index for name, (index, _) in sheet.values.items() if name in _QUANTITIES[kind]}
    read |= {index for name, (index, _) in sheet.errors.items() if name in _QUANTITIES[kind]}
    unread = [repr(shown(cell)) for i, cell in enumerate(header.cells) if cell and i not in read]
    if unread:
        more = f" and {len(unread) - 6} more" if len(unread) > 6 else ""
        names = ", ".join(unread[:6])
        sheet.notes.append(f"not read: {counted(len(unread), 'column')}, {names}{more}")


def _unreadable(faults: list[Fault]) -> StatementError:
    first, *others = faults
    place = f"column {first.column}: {first.value!r}: " if first.column else ""
    error = StatementError(f"no row can be read; {place}{first.rule}", first.line)
    error.others = tuple(StatementError(str(fault)) for fault in others[:5])
    return error


# --- walls ------------------------------------------------------------------------------------


def _wall(sheet: _Sheet, rows: list[Row]) -> Table:
    turned = {
        name: sheet.options.from_normal or sheet.values[name][1].from_normal
        for name in ("alpha", "beta")
    }
    readings = tuple(sheet.from_rows(rows, lambda row: _reading(sheet, row, turned)))
    _require_degrees(sheet, readings)
    return Table(
        "wall",
        readings=readings,
        units=sheet.units(),
        faults=tuple(sheet.faults),
        notes=tuple(sheet.notes),
        from_normal=all(turned.values()),
    )


LEAST_BETA = -5.0
"""Degrees: an angle β near 0 may be read as a little less."""


def _reading(sheet: _Sheet, row: Row, turned: dict[str, bool]) -> WallReading:
    angles = {}
    for name in ("alpha", "beta"):
        angle = sheet.measured(row, name)
        if turned[name]:
            angle = Measured(90 - angle.value, angle.error)
        angles[name] = angle
    alpha, beta = angles["alpha"], angles["beta"]
    sheet.require(row, "alpha", 0 < alpha.value < 90, "an angle of impact is between 0° and 90°")
    good = LEAST_BETA <= beta.value <= 90
    sheet.require(row, "beta", good, "an angle of rebound is from 0° to 90°")
    speeds = {name: sheet.optional(row, name) for name in ("u", "v")}
    for name, speed in speeds.items():
        sheet.require(row, name, speed is None or speed.value > 0, "a speed is more than 0")
    return WallReading(row.line, alpha, beta, speeds["u"], speeds["v"])


def _require_degrees(sheet: _Sheet, readings: tuple[WallReading, ...]) -> None:
    """Angles that are all less than 1.6 are radians, or a mistake: whoever made them says which."""
    column = sheet.values["alpha"][1]
    if column.stated or not readings:
        return
    if all(0 < reading.alpha.value < 1.6 and reading.beta.value < 1.6 for reading in readings):
        raise StatementError(
            f"column {shown(column.header)!r}: all angles are less than 1.6, which as degrees is "
            "nearly nothing: write alpha (rad) in the header, or alpha (deg)"
        )


# --- spheres ----------------------------------------------------------------------------------


def _spheres(sheet: _Sheet, rows: list[Row]) -> Table:
    _refuse_normal(sheet, "spheres")
    trials = tuple(sheet.from_rows(rows, lambda row: _trial(sheet, row)))
    _note_half_errors(sheet)
    if "u_B" not in sheet and "u_B_x" not in sheet:
        sheet.notes.append("there is no column for u_B: B is at rest before each impact")
    return Table(
        "spheres",
        trials=trials,
        units=sheet.units(),
        faults=tuple(sheet.faults),
        notes=tuple(sheet.notes),
    )


def _note_half_errors(sheet: _Sheet) -> None:
    """An error of a speed alone, or of an angle alone, is no error of a velocity."""
    for name in VELOCITIES:
        if name not in sheet or f"{name}_angle" not in sheet:
            continue
        speed, angle = (
            column in sheet.errors or sheet.usual_error(column) is not None
            for column in (name, f"{name}_angle")
        )
        if speed != angle:
            there, missing = ("speed", "angle") if speed else ("angle", "speed")
            sheet.notes.append(
                f"{name} has an error of its {there} and none of its {missing}; without both "
                "neither is used"
            )


def _trial(sheet: _Sheet, row: Row) -> SpheresTrial:
    spheres = {}
    for name in "AB":
        m = sheet.optional(row, f"m_{name}")
        sheet.require(row, f"m_{name}", m is None or m.value > 0, "a mass is more than 0")
        spheres[name] = MeasuredSphere(
            _velocity(sheet, row, f"u_{name}"), _velocity(sheet, row, f"v_{name}"), m
        )
    return SpheresTrial(row.line, spheres["A"], spheres["B"], sheet.optional(row, "line"))


def _velocity(sheet: _Sheet, row: Row, name: str) -> Velocity:
    """A velocity by its components, or by speed and angle from x; 0 exactly where B is at rest."""
    if f"{name}_x" in sheet:
        return Velocity(sheet.measured(row, f"{name}_x"), sheet.measured(row, f"{name}_y"))
    if name not in sheet:
        return Velocity(Measured(0.0, 0.0), Measured(0.0, 0.0))
    speed = sheet.measured(row, name)
    sheet.require(row, name, speed.value >= 0, "a speed is 0 or more")
    angle = sheet.optional(row, f"{name}_angle")
    if angle is None:
        sheet.require(row, name, speed.value == 0, "a speed other than 0 needs its angle")
        return Velocity(Measured(0.0, speed.error), Measured(0.0, speed.error))
    return velocity_of(speed, angle)


def velocity_of(speed: Measured, angle: Measured) -> Velocity:
    """Components of a speed at an angle in degrees from x.

    The components have no error where one of the two is not known.
    """
    turn = math.radians(angle.value)
    x, y = speed.value * math.cos(turn), speed.value * math.sin(turn)
    if speed.error is None or angle.error is None:
        return Velocity(Measured(x), Measured(y))
    along, across = speed.error, speed.value * math.radians(angle.error)
    return Velocity(
        Measured(x, math.hypot(along * math.cos(turn), across * math.sin(turn))),
        Measured(y, math.hypot(along * math.sin(turn), across * math.cos(turn))),
        (along**2 - across**2) * math.cos(turn) * math.sin(turn),
    )


# --- tracks -----------------------------------------------------------------------------------


def _tracks(sheet: _Sheet, rows: list[Row]) -> Table:
    _refuse_normal(sheet, "tracks")
    if sheet.units()["x"] != sheet.units()["y"]:
        raise StatementError("x and y are in units of one kind: both lengths, or both px")
    positions: dict[tuple[str, str], list[Position]] = {}
    walls: dict[tuple[str, str], list[float]] = {}
    masses: dict[tuple[str, str], list[Measured]] = {}

    def place(row: Row) -> None:
        position = Position(row.line, *(sheet.measured(row, name).value for name in "txy"))
        wall = sheet.optional(row, "wall")
        key = sheet.name(row, "trial"), sheet.name(row, "body")
        positions.setdefault(key, []).append(position)
        if wall is not None:
            walls.setdefault(key, []).append(wall.value)
        mass = sheet.optional(row, "m")
        if mass is not None:
            sheet.require(row, "m", mass.value > 0, "a mass is more than 0")
            masses.setdefault(key, []).append(mass)

    for _ in sheet.from_rows(rows, place):
        pass
    tracks = tuple(
        Track(
            *key,
            _in_order(sheet, position),
            _wall_of(key, walls.get(key)),
            _mass_of(key, masses.get(key)),
        )
        for key, position in positions.items()
    )
    return Table(
        "tracks",
        tracks=tracks,
        units=sheet.units(),
        faults=tuple(sorted(sheet.faults, key=lambda fault: fault.line)),
        notes=tuple(sheet.notes),
    )


def _in_order(sheet: _Sheet, positions: list[Position]) -> tuple[Position, ...]:
    """In order of time; of two at one time the first is kept."""
    ordered: list[Position] = []
    for position in sorted(positions, key=lambda position: position.t):
        if ordered and position.t - ordered[-1].t <= SAME_TIME * max(1.0, abs(position.t)):
            rule = "a body is at one place at a time; give a column trial, or body"
            header = sheet.values["t"][1].header
            sheet.faults.append(Fault(position.line, shown(header), f"{position.t:g}", rule))
        else:
            ordered.append(position)
    return tuple(ordered)


def _wall_of(key: tuple[str, str], walls: list[float] | None) -> float | None:
    if not walls:
        return None
    _require_one(key, "wall", walls, "a wall has one direction in a trial")
    return statistics.fmean(walls)


def _mass_of(key: tuple[str, str], masses: list[Measured] | None) -> Measured | None:
    if not masses:
        return None
    _require_one(key, "m", [mass.value for mass in masses], "a body has one mass in a trial")
    return masses[0]


def _require_one(key: tuple[str, str], quantity: str, values: list[float], rule: str) -> None:
    low, high = min(values), max(values)
    if high - low > 1e-9 * max(abs(low), abs(high)):
        name = f"trial {key[0]}: " if key[0] else ""
        raise StatementError(f"{printable(name)}{quantity} {low:g} and {high:g}: {rule}")


def _refuse_normal(sheet: _Sheet, kind: Kind) -> None:
    if sheet.options.from_normal:
        raise StatementError(f"{kind}: angles from the normal are of a wall; here there are none")


_MAKERS: dict[Kind, Callable[[_Sheet, list[Row]], Table]] = {
    "wall": _wall,
    "spheres": _spheres,
    "tracks": _tracks,
}
