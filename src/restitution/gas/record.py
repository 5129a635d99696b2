"""What a run leaves behind: impacts and snapshots as structured arrays, and files of them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np

from restitution.errors import StatementError, UnsupportedError
from restitution.gas import kernel as k
from restitution.gas.state import Box

# Walls, as the second body of an impact.
WEST, EAST, SOUTH, NORTH = -1, -2, -3, -4

IMPACT = np.dtype(
    [("time", "f8"), ("first", "i8"), ("second", "i8")]
    + [
        (name, "f8")
        for name in (
            *("e", "x", "y", "line_x", "line_y", "impulse_x", "impulse_y"),
            *("u1_x", "u1_y", "u2_x", "u2_y", "v1_x", "v1_y", "v2_x", "v2_y"),
        )
    ]
)


def impacts_from(
    logs: Sequence[np.ndarray],
    masses: np.ndarray,
    radii: np.ndarray,
    box: Box,
) -> np.ndarray:
    """The kernel's logs as impacts in the order of time, one row each, with the type ``IMPACT``.

    ``masses`` (kg) and ``radii`` (m) are those of the discs by their numbers. Places are within
    the box, whichever tile saw the impact.
    """
    log = np.concatenate(logs) if logs else np.empty((0, k.LOGGED))
    log = log[np.lexsort((log[:, 1], log[:, 0]))]
    first, second = log[:, 1].astype(int), log[:, 2].astype(int)
    # of two discs the one with the lower number stands first
    swap = (second >= 0) & (second < first)
    wall = second < 0
    line, u1, u2 = log[:, 5:7].copy(), log[:, 7:9].copy(), log[:, 9:11].copy()
    centre = log[:, 3:5].copy()
    centre[swap] += line[swap]
    line[swap] *= -1
    u1[swap], u2[swap] = u2[swap], u1[swap]
    first[swap], second[swap] = second[swap], first[swap]

    length = np.hypot(line[:, 0], line[:, 1])
    normal = line / length[:, None]
    m1 = masses[first]
    m2 = np.where(wall, np.inf, masses[np.where(wall, 0, second)])
    share = log[:, 11]
    # the kernel's share is impulse / (m1 m2 length), or for a wall impulse / m1
    size = np.where(wall, share * m1, share * m1 * np.where(wall, 1.0, m2) * length)
    impulse = size[:, None] * normal
    approach = ((u1 - u2) * normal).sum(axis=1)
    v1, v2 = u1 - impulse / m1[:, None], u2 + impulse / m2[:, None]

    out = np.empty(len(log), dtype=IMPACT)
    out["time"], out["first"] = log[:, 0], first
    across = np.where(line[:, 0] < 0, WEST, EAST)
    up = np.where(line[:, 1] < 0, SOUTH, NORTH)
    out["second"] = np.where(wall, np.where(log[:, 2] == -1, across, up), second)
    out["e"] = ((v2 - v1) * normal).sum(axis=1) / approach
    contact = _within(_within(centre, box) + radii[first][:, None] * normal, box)
    contact += (box.width / 2, box.height / 2)
    for name, vectors in (
        ("", contact),
        ("line_", normal),
        ("impulse_", impulse),
        ("u1_", u1),
        ("u2_", u2),
        ("v1_", v1),
        ("v2_", v2),
    ):
        out[f"{name}x"], out[f"{name}y"] = vectors.T
    return out


def _within(places: np.ndarray, box: Box) -> np.ndarray:
    """Places (m) from the middle of the box, brought into it through its periodic walls."""
    sides, wraps = np.array((box.width, box.height)), (box.periodic_x, box.periodic_y)
    return places - np.where(wraps, sides * np.floor(places / sides + 0.5), 0.0)


def write(table: np.ndarray, path: str | Path) -> None:
    """Writes a structured array to a file: ``.npz`` (in it as ``table``) or ``.parquet``.

    Raises:
        StatementError: another ending.
        UnsupportedError: Parquet without pyarrow.
    """
    path = Path(path)
    if path.suffix == ".npz":
        np.savez_compressed(path, table=table)
    elif path.suffix == ".parquet":
        try:
            import pyarrow as pa
            import pyarrow.parquet as pq
        except ImportError as error:
            raise UnsupportedError(
                "Parquet files need pyarrow: pip install 'restitution[fast]'"
            ) from error
        columns = {name: np.ascontiguousarray(table[name]) for name in table.dtype.names or ()}
        pq.write_table(pa.table(columns), path)
    else:
        raise StatementError(f"the file {path.name} has to end in .npz or .parquet")
