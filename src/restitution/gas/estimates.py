"""How fast the discs of a gas move, how long an epoch is, and how often a disc is struck."""

from __future__ import annotations

import math

from restitution.gas import kernel as k
from restitution.gas.state import Box, Discs

# In an epoch a disc of root-mean-square speed goes about so many diameters. Times are counted
# anew after each, and so remain exact to 1e-14 of the time to go a diameter, however long the run.
EPOCH = 32


def kinetic_energy(discs: Discs) -> float:
    """In J. The sum is rounded once, so that it does not depend on the order of the discs."""
    row = discs.row
    return 0.5 * math.fsum(row[:, k.MASS] * (row[:, k.VX] ** 2 + row[:, k.VY] ** 2))


def packing(discs: Discs, box: Box) -> float:
    """The share of the box that the discs cover."""
    area = math.pi * float((discs.row[:, k.RADIUS] ** 2).sum())
    return area / (box.width * box.height)


def epoch_of(discs: Discs) -> float:
    """How long an epoch is at this temperature: a power of two, in s."""
    row = discs.row
    speed = math.sqrt(2 * kinetic_energy(discs) / math.fsum(row[:, k.MASS]))
    if speed == 0:  # nothing moves, or as good as
        return 2.0**1000
    return 2.0 ** math.floor(math.log2(EPOCH * 2 * float(row[:, k.RADIUS].mean()) / speed))


def expected_rate(discs: Discs, box: Box) -> float:
    """Changes of velocity of a disc in a second by Enskog's theory, for equal discs."""
    row = discs.row
    speed = math.sqrt(kinetic_energy(discs) / math.fsum(row[:, k.MASS]))
    covered = min(packing(discs, box), 0.85)
    pairs = 8 * covered / math.sqrt(math.pi) / (2 * float(row[:, k.RADIUS].mean()))
    dense = (1 - 7 * covered / 16) / (1 - covered) ** 2
    walls = 1 / box.width + 1 / box.height
    return speed * (pairs * dense + walls) if len(row) > 1 else speed * walls
