"""A sample: readings that one law is fitted to, and what is known of their errors."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from restitution.errors import MissingError
from restitution.experiments.curves import (
    WALL,
    Array,
    Law,
    Readings,
    nearest,
    squared_distance,
    sum_of_squares,
)
from restitution.experiments.distributions import upper_tail_of_squares
from restitution.experiments.fitting import Fit, Model, fitted, profile
from restitution.records import dataclass

LEVEL = 0.95


@dataclass(frozen=True)
class Sample:
    """Readings of a law, with errors that are known or known up to a common factor.

    ``known`` says which. ``freedom`` are the degrees of freedom with which known errors were
    estimated elsewhere, as those of tracks are from their positions; None where they are given.
    """

    readings: Readings
    law: Law
    known: bool
    freedom: int | None = None

    @cached_property
    def fit(self) -> Fit:
        """The fit of e alone. Raises MissingError where the readings do not determine it."""
        law, readings = self.law, self.readings
        if len(readings) == 1 and not self.known:
            raise MissingError(
                "one reading has no scatter, so its error has to be given: --angle-error for "
                "angles, --speed-error for speeds, or a column such as alpha_error"
            )
        starts = np.array([0.02, 0.1, 0.3, 0.5, 0.7, 0.9, 1.2, 2.0])[:, np.newaxis]
        best = starts[int(np.argmin(sum_of_squares(readings, law, starts)))]
        return fitted(readings, lambda x, p: law.value(x, p[0]), best)

    @property
    def e(self) -> float:
        return self.fit.parameters[0]

    @cached_property
    def factor(self) -> float:
        """By what the errors of the readings are to be multiplied."""
        return 1.0 if self.known else self.fit.scatter

    @property
    def standard_error(self) -> float:
        return self.fit.errors[0] * self.factor

    @property
    def exact(self) -> bool:
        """Whether the scatter, from which errors would be estimated, is none at all."""
        return not self.known and self.factor < 1e-6

    @cached_property
    def interval(self) -> tuple[float, float]:
        """The ends of the interval of e at LEVEL."""
        if self.exact:
            return self.e, self.e
        freedom = self.freedom if self.known else self.fit.degrees_of_freedom
        return profile(self.readings, self.law, self.fit, LEVEL, self.factor, freedom)

    @cached_property
    def x_fitted(self) -> Array:
        """The x of the points of the law nearest to the readings."""
        return nearest(self.readings, self.law, self.e)

    @cached_property
    def residuals(self) -> Array:
        """The distances from the law in standard errors, positive above it."""
        square = squared_distance(self.readings, self.law, self.x_fitted, self.e)
        above = self.readings.y > self.law.value(self.readings.x, self.e)
        distance = np.sqrt(square) / max(self.factor, 1e-300)
        result: Array = np.where(above, distance, -distance)
        return np.zeros_like(result) if self.exact else result

    def wider(self, model: Model, more: int) -> Fit | None:
        """The fit of a model with ``more`` parameters behind e, or None if it has none."""
        if self.fit.degrees_of_freedom <= more or self.exact:
            return None
        start = np.array([self.e, *[0.0] * more])
        try:
            fit = fitted(self.readings, model, start)
        except MissingError:
            return None
        return fit if np.all(np.isfinite(fit.errors)) else None

    def p_value(self, wider: Fit) -> float:
        """How probable so large a fall of the sum of squares is where the law is true."""
        fall = max(self.fit.sum_of_squares - wider.sum_of_squares, 0.0)
        if self.known:
            return upper_tail_of_squares(fall, 1, self.freedom)
        freedom = wider.degrees_of_freedom
        scale = wider.sum_of_squares / freedom
        return upper_tail_of_squares(fall / scale, 1, freedom) if scale > 0 else 0.0

    def error_of(self, wider: Fit, index: int) -> float:
        """The standard error of a parameter of a wider model."""
        return wider.errors[index] * (1.0 if self.known else wider.scatter)

    def with_scatter(self) -> Sample:
        """The same where the errors are taken from the scatter, whatever was given."""
        return Sample(self.readings, self.law, known=False)


def is_wall(sample: Sample) -> bool:
    """Whether the law is that of a wall, of angles."""
    return sample.law is WALL
