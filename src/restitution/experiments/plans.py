"""What a plan of an experiment holds."""

from __future__ import annotations

import dataclasses
import json
from typing import Any

from restitution.records import dataclass


@dataclass(frozen=True)
class Design:
    """Angles α in degrees, one for each trial, and what comes of them.

    ``standard_error`` is that of e by propagation, ``simulated_error`` the standard deviation of e
    in simulated experiments, and ``half_width`` the mean half width of their intervals of 95%.
    ``smallest_turn`` is the turn of the line from which angles are measured, in degrees, that the
    check of the model sees in 80% of the experiments; None where the check is impossible.
    """

    id: str
    title: str
    angles: tuple[float, ...]
    standard_error: float
    simulated_error: float
    half_width: float
    smallest_turn: float | None


@dataclass(frozen=True)
class PlanContent:
    """What a plan holds: what is to be expected of an experiment with a wall.

    ``best_angle`` is that at which one reading tells most of e, in degrees; ``recommended`` the id
    of a design. ``trials_for`` has half widths of the interval of 95% with the trials, of the
    recommended design, that they take.
    """

    e: float
    angle_error: float
    trials: int
    seed: int
    simulations: int
    best_angle: float
    designs: tuple[Design, ...]
    recommended: str
    trials_for: tuple[tuple[float, int], ...]

    def design(self, name: str) -> Design:
        """A design by its id. Raises KeyError where there is none of it."""
        for design in self.designs:
            if design.id == name:
                return design
        raise KeyError(name)

    def json(self) -> str:
        """The plan as one line of JSON."""
        fields: dict[str, Any] = dataclasses.asdict(self)
        fields["trials_for"] = [
            {"half_width": width, "trials": trials} for width, trials in self.trials_for
        ]
        return json.dumps(fields, ensure_ascii=False)
