"""What was measured: readings and trials, and the table that holds them.

Angles are in degrees here, as a protractor has them; speeds, times, places and masses are in the
units that `Table.units` names. An error is one standard deviation, and None where it is not known.
"""

from __future__ import annotations

from dataclasses import field
from typing import Literal

from restitution.records import dataclass

Kind = Literal["wall", "spheres", "tracks"]
"""What was measured: angles to a wall, velocities of two spheres, or positions with times."""

KINDS: tuple[Kind, ...] = ("wall", "spheres", "tracks")


@dataclass(frozen=True)
class Measured:
    """A value with its standard error, which is None where it is not known."""

    value: float
    error: float | None = None


@dataclass(frozen=True)
class Fault:
    """What is wrong with one cell, or with one row: its place, its value, and the rule.

    ``line`` counts from 1, the header included; ``column`` is the name in the header, "" for the
    row as a whole.
    """

    line: int
    column: str
    value: str
    rule: str

    def __str__(self) -> str:
        place = f"line {self.line}"
        if self.column:
            place += f", column {self.column}"
        return f"{place}: {self.value!r}: {self.rule}" if self.value else f"{place}: {self.rule}"


@dataclass(frozen=True)
class WallReading:
    """One impact with a wall: angles to the wall before and after, and speeds if known."""

    line: int
    alpha: Measured
    beta: Measured
    u: Measured | None = None
    v: Measured | None = None
    covariance: float = 0.0
    """Of the errors of α and β, in square degrees; not zero where the wall itself is estimated."""
    label: str = ""
    """The trial, where it has a name."""


@dataclass(frozen=True)
class Velocity:
    """Components along x and y, with the covariance of their errors."""

    x: Measured
    y: Measured
    covariance: float = 0.0


@dataclass(frozen=True)
class MeasuredSphere:
    """A sphere's velocities before and after, and its mass if known."""

    u: Velocity
    v: Velocity
    m: Measured | None = None


@dataclass(frozen=True)
class SpheresTrial:
    """One impact of two spheres. ``line_of_centres`` is in degrees from x, None if not given."""

    line: int
    A: MeasuredSphere
    B: MeasuredSphere
    line_of_centres: Measured | None = None
    label: str = ""
    """The trial, where it has a name."""


@dataclass(frozen=True)
class Position:
    """Where a body was at a time."""

    line: int
    t: float
    x: float
    y: float


@dataclass(frozen=True)
class Track:
    """The positions of one body in one trial, in order of time."""

    trial: str
    body: str
    positions: tuple[Position, ...]
    wall: float | None = None
    """The direction of the wall in degrees from x, where it is given; of two bodies, of their
    common tangent."""
    m: Measured | None = None


@dataclass(frozen=True)
class Table:
    """All that was read from one text; what is of another kind is empty.

    ``faults`` are the rows that were left out, ``notes`` what was assumed on the way, and
    ``units`` is by name of the quantity: ``{"alpha": "degrees", "u": "m/s"}``.
    """

    kind: Kind
    readings: tuple[WallReading, ...] = ()
    trials: tuple[SpheresTrial, ...] = ()
    tracks: tuple[Track, ...] = ()
    units: dict[str, str] = field(default_factory=dict)
    faults: tuple[Fault, ...] = ()
    notes: tuple[str, ...] = ()
    from_normal: bool = False
    """Whether the angles were to the normal in the text; here they are to the wall."""
