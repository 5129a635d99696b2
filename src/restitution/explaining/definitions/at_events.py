"""What each definition says at an event, by the record of a move."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from restitution.explaining.definitions.energies import (
    energy_lost,
    fraction_lost,
    impulse_along_the_line,
    impulse_by_its_size,
    momentum_kept,
    momentum_of_all,
    total,
    total_lost,
    velocity_by_its_change,
)
from restitution.explaining.definitions.journeys import beside, chords, moving_off, rounds
from restitution.explaining.definitions.next_walls import next_walls
from restitution.explaining.definitions.ties import between_directions, tied
from restitution.explaining.definitions.turnings import between_given_directions, turnings
from restitution.explaining.definitions.wall_angles import by_angles, to_slanted_centres, to_walls
from restitution.explaining.lines.derivation import Event, Link
from restitution.explaining.steps.step import Step


def nothing(step: Step, event: Event | None) -> Iterable[Link]:
    """Nothing is worked out for the other records."""
    return ()


def angles_made_of_others(step: Step, event: Event | None) -> Iterable[Link]:
    """Angles between velocities, and angles of one to walls, by others."""
    yield from turnings(step, event)
    yield from between_given_directions(step)
    yield from next_walls(step, event)


WORKED_OUT: Mapping[str, Callable[[Step, Event | None], Iterable[Link]]] = {
    "difference": angles_made_of_others,
    "tan": to_walls,
    "tan-direction": to_slanted_centres,
    "speed": by_angles,
    "total": total,
    "total-lost": total_lost,
    "impulse-vector": impulse_along_the_line,
    "impulse-direction": impulse_by_its_size,
    "changed-velocity": velocity_by_its_change,
    "momentum-of": momentum_of_all,
    "momentum-vector": momentum_kept,
    "energy-lost": energy_lost,
    "energy-ratio": fraction_lost,
    "perpendicular": tied,
    "parallel": tied,
    "scalar-angle": between_directions,
    "chord": chords,
    "moves-off": moving_off,
    "beside": beside,
    "round": rounds,
}
