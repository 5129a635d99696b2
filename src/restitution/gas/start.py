"""Where a gas starts: discs on a lattice or at given places, velocities at random."""

from __future__ import annotations

import math

import numpy as np

from restitution.errors import ImpossibleError
from restitution.gas.state import Box


def lattice(
    discs: int,
    width: float,
    height: float,
    radius: float,
    periodic: tuple[bool, bool],
    rng: np.random.Generator,
) -> np.ndarray:
    """Places (m) for discs as far from one another as a triangular lattice allows, shape (n, 2).

    Where the lattice has more places than discs, the empty ones are drawn at random. Raises
    ImpossibleError if they would overlap.
    """
    room_x, room_y = (
        side if wraps else side - 2 * radius for side, wraps in zip((width, height), periodic)
    )
    best = (-math.inf, 1, 1, 0.0, 0.0)
    for columns in range(1, discs + 1):
        lines = math.ceil(discs / columns)
        if periodic[1] and lines % 2:
            lines += 1
        step_x = room_x / (
            columns if periodic[0] else columns - 0.5 if columns > 1 or lines > 1 else 1
        )
        step_y = room_y / (lines if periodic[1] else max(lines - 1, 1))
        nearest = min(
            step_x if columns > 1 or periodic[0] else math.inf,
            math.hypot(step_x / 2, step_y) if lines > 1 else math.inf,
            2 * step_y if lines > 2 else math.inf,
        )
        if nearest > best[0]:
            best = (nearest, columns, lines, step_x, step_y)
        if columns > 4 * math.sqrt(discs * width / height) + 4:
            break
    nearest, columns, lines, step_x, step_y = best
    if nearest <= 2 * radius or min(room_x, room_y) < 0:
        packing = discs * math.pi * radius**2 / (width * height)
        raise ImpossibleError(
            f"{discs} discs of radius {radius:g} in a box of {width:g} by {height:g} are a packing "
            f"of {packing:.3g}; on the best lattice their centres are {nearest:g} apart, and that "
            f"has to be more than {2 * radius:g}"
        )
    places = np.sort(rng.choice(columns * lines, discs, replace=False))
    line, column = np.divmod(places, columns)
    x = (column + 0.5 * (line % 2)) * step_x + (0.25 * step_x if periodic[0] else radius)
    y = line * step_y + (0.5 * step_y if periodic[1] else radius)
    return np.stack((x, y), axis=1)


def random_velocities(
    masses: np.ndarray, temperature: float, at_rest: bool, rng: np.random.Generator
) -> np.ndarray:
    """Velocities (m/s) after Maxwell, shape (n, 2), of mean kinetic energy ``temperature`` (J).

    ``at_rest`` takes away the velocity of the centre of mass.
    """
    velocities = rng.normal(size=(len(masses), 2)) / np.sqrt(masses)[:, None]
    if at_rest and len(masses) > 1:
        velocities -= (masses[:, None] * velocities).sum(axis=0) / masses.sum()
    energy = 0.5 * float((masses * (velocities**2).sum(axis=1)).sum())
    scaled: np.ndarray = velocities * math.sqrt(temperature * len(masses) / energy)
    return scaled


def centred(positions: np.ndarray, radii: np.ndarray, box: Box) -> np.ndarray:
    """Positions (m) from the middle of the box, rounded, shape (n, 2).

    Raises ImpossibleError for a disc that reaches beyond a wall.
    """
    out = np.empty_like(positions)
    for axis, side, wraps, name in (
        (0, box.width, box.periodic_x, "x"),
        (1, box.height, box.periodic_y, "y"),
    ):
        place = np.round((positions[:, axis] - side / 2) / box.resolution) * box.resolution
        if wraps:
            place -= side * np.floor(place / side + 0.5)
        else:
            beyond = np.abs(place) + radii - side / 2
            worst = int(np.argmax(beyond))
            if beyond[worst] > 4 * box.resolution:
                raise ImpossibleError(
                    f"disc {worst} at {name} = {positions[worst, axis]:g} with radius "
                    f"{radii[worst]:g} reaches {beyond[worst]:.3g} beyond a wall of the box, "
                    f"which is from 0 to {side:g}"
                )
        out[:, axis] = place
    return out
