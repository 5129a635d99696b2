"""The state of a gas: the discs' rows, the box they are in, and the scales that make it exact."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from restitution.errors import ImpossibleError, StatementError
from restitution.gas import kernel as k
from restitution.motion.contact import TOLERANCE
from restitution.records import dataclass

# Cells hold this many discs on average where the gas is so thin that they may be larger than discs.
PER_CELL = 0.7

# A periodic box has at least so many cells, that a disc meets only one image of each other.
FEWEST_CELLS = 4

# Places have to be known to this part of a radius, at least.
COARSEST = 1e-6

# Sizes below this, and above its inverse, would leave the range of floats when multiplied.
SMALLEST = 1e-60


@dataclass
class Discs:
    """The state of all discs, and the time it is.

    ``row``, ``small`` and ``tally`` are as ``kernel`` tells; ``names`` gives the disc of each of
    their rows, which are put in the order of cells now and then. ``now`` counts from ``epoch``,
    both in s.
    """

    row: np.ndarray
    small: np.ndarray
    tally: np.ndarray
    names: np.ndarray
    epoch: float = 0.0
    now: float = 0.0


@dataclass(frozen=True)
class Rules:
    """What happens at an impact, and the time (s) after which times are counted anew.

    Within an epoch times are whole multiples of ``instant``, so that counting anew is exact.
    """

    e: float
    e_walls: float
    contact_time: float
    epoch: float

    @property
    def at_once(self) -> int:
        """Impacts of one disc, one after another at what is one time, that are a collapse.

        Without loss, and with a contact time, there is none: among discs that touch, and of very
        different masses, there may be very many impacts, but there are finitely many, unless
        the discs are jammed.
        """
        if self.e == self.e_walls == 1 or self.contact_time > 0:
            return 30_000
        return 100

    @property
    def instant(self) -> float:
        """The finest time, in s."""
        return self.epoch * 2.0**-50


@dataclass(frozen=True)
class Box:
    """The rectangle that discs are in, centred at the origin within, and its grid of cells.

    ``resolution`` is the length (m) that places are whole multiples of. With it the sum of a place
    and a side is exact, as is the difference of two places.
    """

    width: float
    height: float
    periodic_x: bool
    periodic_y: bool
    columns: int
    lines: int
    edges_x: np.ndarray
    edges_y: np.ndarray
    resolution: float


def aligned(shape: tuple[int, ...], dtype: Any) -> np.ndarray:
    """An array of zeros that begins with a cache line."""
    size = math.prod(shape) * np.dtype(dtype).itemsize
    raw = np.zeros(size + 64, dtype=np.uint8)
    offset = -raw.ctypes.data % 64
    array: np.ndarray = raw[offset : offset + size].view(dtype).reshape(shape)
    return array


def box_for(
    width: float, height: float, periodic: tuple[bool, bool], radius: float, discs: int
) -> Box:
    """The box and its cells for discs of up to this radius (m).

    The sides are rounded to twice the resolution, a relative change below the machine epsilon.
    """
    # a periodic side is seen shifted by its length
    spans = [side * (2 if wraps else 1) for side, wraps in zip((width, height), periodic)]
    resolution = 2.0 ** (math.ceil(math.log2(max(spans))) - 53)
    side = max(2 * radius, _side(width, height, discs))
    if 3 * side > k.FARTHEST * resolution:
        resolution *= 4  # few cells: a disc may cross most of the box between two of their edges
    if resolution > COARSEST * radius:
        raise ImpossibleError(
            f"a box of {width:g} by {height:g} is too large for discs of radius {radius:g}: places "
            f"in it are known to {resolution:.2g}"
        )
    width, height = (2 * resolution * round(side / (2 * resolution)) for side in (width, height))
    side = max(2 * radius * (1 + TOLERANCE) + 4 * resolution, _side(width, height, discs))
    counts = []
    for length, wraps, name in ((width, periodic[0], "width"), (height, periodic[1], "height")):
        cells = max(min(int(length / side), 4 * discs + 16), 1)
        if wraps and cells < FEWEST_CELLS:
            cells = int(length / (2 * radius * (1 + TOLERANCE) + 4 * resolution))
            if cells < FEWEST_CELLS:
                raise ImpossibleError(
                    f"the {name} of a periodic box is {length:g}, but it has to be more than "
                    f"{FEWEST_CELLS} diameters, {2 * radius * FEWEST_CELLS:g}, that a disc meets "
                    "only one image of each other"
                )
            cells = FEWEST_CELLS
        counts.append(cells)
    edges_x, edges_y = (
        np.round((np.arange(cells + 1) / cells - 0.5) * length / resolution) * resolution
        for cells, length in zip(counts, (width, height))
    )
    return Box(width, height, *periodic, counts[0], counts[1], edges_x, edges_y, resolution)


def _side(width: float, height: float, discs: int) -> float:
    return math.sqrt(PER_CELL * width * height / max(discs, 1))


def check(
    positions: np.ndarray,
    velocities: np.ndarray,
    radii: np.ndarray,
    masses: np.ndarray,
    width: float,
    height: float,
) -> None:
    """Raise StatementError or ImpossibleError for what is no number, or no disc."""
    n = len(positions)
    for name, values, shape in (
        ("positions", positions, (n, 2)),
        ("velocities", velocities, (n, 2)),
        ("radius", radii, (n,)),
        ("mass", masses, (n,)),
    ):
        if values.shape != shape:
            raise StatementError(f"{name} has the shape {values.shape}, but {n} discs need {shape}")
        bad = ~np.isfinite(values).reshape(n, -1).all(axis=1)
        if bad.any():
            first = int(np.argmax(bad))
            raise StatementError(f"{name} of disc {first} is {values[first]}, not a finite number")
    for name, length in (("width", width), ("height", height)):
        if not (math.isfinite(length) and length > 0):
            raise ImpossibleError(f"the {name} of the box is {length:g}; it has to be positive")
    for name, values in (
        *(("width", np.array([width])), ("height", np.array([height]))),
        *(("radius", radii), ("mass", masses), ("velocities", velocities.ravel())),
    ):
        size = np.abs(values[values != 0])
        if ((size < SMALLEST) | (size > 1 / SMALLEST)).any():
            worst = size.min() if (size < SMALLEST).any() else size.max()
            raise StatementError(
                f"{name}: {worst:g} is beyond what is reckoned with, {SMALLEST:g} to "
                f"{1 / SMALLEST:g} in size"
            )
    for name, values in (("radius", radii), ("mass", masses)):
        if (values <= 0).any():
            first = int(np.argmax(values <= 0))
            raise ImpossibleError(
                f"the {name} of disc {first} is {values[first]:g}; it has to be positive"
            )
    with np.errstate(over="ignore"):
        energy = float((masses * (velocities**2).sum(axis=1)).sum()) / 2
    if not math.isfinite(energy):
        raise StatementError("velocities or masses are too large: so is the energy for a float")


def overlap(
    x: np.ndarray, y: np.ndarray, radii: np.ndarray, cells: tuple[np.ndarray, np.ndarray], box: Box
) -> tuple[float, int, int]:
    """The deepest overlap of two discs (m), and which; negative is the least gap found.

    Only discs in neighbouring cells are compared. Pairs farther apart than their cells count as
    infinitely far.
    """
    columns, lines = cells
    cell = lines * box.columns + columns
    order = np.argsort(cell, kind="stable")
    counts = np.bincount(cell, minlength=box.columns * box.lines)
    starts = np.concatenate(([0], np.cumsum(counts)))
    most = int(counts.max(initial=0))
    worst = (-math.inf, -1, -1)
    for over, along in ((0, 0), (0, 1), (1, -1), (1, 0), (1, 1)):
        there_column, there_line = columns + along, lines + over
        known = np.ones(len(x), dtype=bool)
        if box.periodic_x:
            there_column = there_column % box.columns
        else:
            known &= (there_column >= 0) & (there_column < box.columns)
        if box.periodic_y:
            there_line = there_line % box.lines
        else:
            known &= (there_line >= 0) & (there_line < box.lines)
        there = np.where(known, there_line * box.columns + there_column, 0)
        for rank in range(most):
            here = np.flatnonzero(known & (rank < counts[there]))
            other = order[starts[there[here]] + rank]
            if over == along == 0:
                later = other > here
                here, other = here[later], other[later]
            if not len(here):
                continue
            dx, dy = x[other] - x[here], y[other] - y[here]
            if box.periodic_x:
                dx -= box.width * np.round(dx / box.width)
            if box.periodic_y:
                dy -= box.height * np.round(dy / box.height)
            deep = radii[here] + radii[other] - np.hypot(dx, dy)
            at = int(np.argmax(deep))
            if deep[at] > worst[0]:
                worst = (float(deep[at]), int(here[at]), int(other[at]))
    return worst


def fresh(
    positions: np.ndarray, velocities: np.ndarray, radii: np.ndarray, masses: np.ndarray, box: Box
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The rows of discs that nothing is predicted for yet: (row, small, tally)."""
    n = len(positions)
    row, small, tally = aligned((n, 8), float), aligned((n, 8), np.int32), aligned((n, 4), float)
    row[:, k.X], row[:, k.Y] = positions.T
    row[:, k.VX], row[:, k.VY] = velocities.T
    row[:, k.RADIUS], row[:, k.MASS] = radii, masses
    for part, edges in ((k.COLUMN, box.edges_x), (k.LINE, box.edges_y)):
        place = row[:, k.X if part == k.COLUMN else k.Y]
        small[:, part] = np.clip(np.searchsorted(edges, place, side="right") - 1, 0, len(edges) - 2)
    small[:, k.PARTNER] = k.UNASKED
    tally[:, k.LAST_HIT] = -math.inf
    return row, small, tally
