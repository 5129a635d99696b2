"""The events of a story as they happened."""

from __future__ import annotations

from collections.abc import Mapping

from restitution.expression.evaluate import Scalar
from restitution.problem import Event, Impact
from restitution.records import dataclass
from restitution.vector import Vector


@dataclass(frozen=True)
class Standing:
    """A sphere before an impact: its velocity, and where it is and since when, if that is known."""

    velocity: Vector
    place: tuple[Vector, Scalar] | None


@dataclass(frozen=True)
class Happening:
    """An event as it happened.

    ``centres`` is a vector along the line of centres (into a wall: along its normal) of any
    length; times ``closing``, its scalar product with the velocity of approach, it points from
    the first body to the second. ``time`` is None where nothing is known of places.
    """

    number: int
    step: Event
    before: Mapping[str, Vector]
    after: Mapping[str, Vector]
    centres: Vector | None = None
    closing: Scalar = None
    e: Scalar = None
    impulse: Vector | None = None  # on the second body, or on the body kicked; mass times that
    impulse_mass: str | None = None  # the body whose mass the impulse is still to be multiplied by
    time: Scalar = None
    unknown_line: bool = False
    altered: bool = False  # other equations than the laws hold

    @property
    def bodies(self) -> tuple[str, ...]:
        """The names of the bodies in this event."""
        step = self.step
        return (step.first, step.second) if isinstance(step, Impact) else (step.body,)

    def oriented(self) -> Vector:
        """A vector from the first body to the second."""
        assert self.centres is not None
        return self.centres * self.closing if not self.unknown_line else self.centres
