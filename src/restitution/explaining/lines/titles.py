"""What the principles and definitions are called: the titles above their lines."""

from __future__ import annotations

from collections.abc import Mapping

from restitution.explaining.lines.derivation import Event
from restitution.explaining.lines.sentences import SentenceId

# The title of each record, by its id among the sentences: at a wall, and elsewhere.
_TITLES: Mapping[str, tuple[SentenceId | None, SentenceId | None]] = {
    "unchanged": ("unchanged-wall.title", "unchanged.title"),
    "restitution-wall": ("restitution.title", None),
    "momentum": (None, "momentum.title"),
    "restitution": (None, "restitution.title"),
    "momentum-vector": (None, "momentum.vectors"),
    "impulse-vector": ("impulse.title", "impulse.title"),
    "opposite-impulses": (None, "derived-opposite.title"),
    "impulse": ("impulse-wall.title", "impulse-spheres.title"),
    "across-the-impulse": ("impulse-normal.title", "impulse-line.title"),
    "impulse-direction": ("impulse-away.title", "impulse-along.title"),
    "along-the-change": ("impulse-normal.title", "impulse-line.title"),
    "changed-velocity": ("changed-wall.title", "changed-spheres.title"),
    "component": ("resolved-wall.before", "resolved-spheres.before"),
    "sum": ("turned-wall.title", "turned.title"),
    "difference": ("turned-wall.title", "turned.title"),
    "tan-deflection": ("turned.products", "turned.products"),
    "tan-from-axis": ("turned.title", "turned.title"),
    "scalar-angle": ("derived-between.title", "derived-between.title"),
    "energy-lost": ("loss-wall.title", "loss-spheres.title"),
    "energy-change": ("change-of-energy.title", "change-of-energy.title"),
    "energy": ("derived-energy.title", "derived-energy.title"),
    "energy-ratio": ("energy-ratio.title", "energy-ratio.title"),
    "total": ("derived-energy.title", "derived-energy.title"),
    "total-lost": ("derived-energy.title", "derived-energy.title"),
    "tan": ("derived-direction.title", "derived-direction.title"),
    "tan-squared": ("derived-direction.squared", "derived-direction.squared"),
    "tan-direction": ("derived-direction.title", "derived-direction.title"),
    "speed": ("derived-speed.title", "derived-speed.title"),
    "size": ("derived-size.title", "derived-size.title"),
    "assemble": ("derived-assembled.title", "derived-assembled.title"),
    "relative-velocity": (None, "relative-velocity.title"),
    "product": ("derived-product.title", "derived-product.title"),
    "perpendicular": ("derived-perpendicular.title", "derived-perpendicular.title"),
    "parallel": ("derived-parallel.title", "derived-parallel.title"),
    "straight-line": ("flight.title", "flight.title"),
    "round": (None, "round.title"),
    "chord": ("chord.title", None),
    "moves-off": (None, "moves-off.title"),
    "turned": ("turned-velocity.title", "turned-velocity.title"),
    "either-side": ("either-side.wall", "either-side.title"),
    "beside": (None, "beside.title"),
    "momentum-of": ("momentum-of.title", "momentum-of.title"),
}


def title_of(record: str, event: Event | None) -> SentenceId | None:
    """The sentence that names a record above its lines in an event; None where it has no name."""
    wall = event is not None and event.wall
    return _TITLES.get(record, (None, None))[0 if wall else 1]
