"""One impact of two spheres: its line of centres, and what happens along and across it.

The components of all velocities are one vector z = (u_A, v_A, u_B, v_B) of eight numbers with a
covariance of shape (8, 8). What follows of it is linear in z to first order, so that its errors
follow by z ↦ J z: J Σ Jᵀ (JCGM 100:2008, section 5.2). Where the line of centres is found from the
same velocities, J has its turning with them.
"""

from __future__ import annotations

import math
from dataclasses import replace

import numpy as np

from restitution.experiments.curves import Array
from restitution.experiments.records import MeasuredSphere, SpheresTrial
from restitution.records import dataclass

_U_A, _V_A, _U_B, _V_B = (slice(i, i + 2) for i in range(0, 8, 2))


@dataclass(frozen=True)
class Impact:
    """One trial seen along the line of centres ``n``, which points from A to B.

    ``z`` and ``covariance`` are of all velocities; ``turning``, of shape (8,), is the derivative of
    the direction of ``n`` with respect to z, 0 where the line is given, and ``line_error`` its own
    standard error in radians. ``relative`` are the velocities of A relative to B, before and after.
    """

    trial: SpheresTrial
    z: Array
    covariance: Array
    n: Array
    turning: Array
    line_error: float
    given: bool

    @property
    def t(self) -> Array:
        """The common tangent, 90° anticlockwise from ``n``."""
        return np.array([-self.n[1], self.n[0]])

    @property
    def relative(self) -> tuple[Array, Array]:
        return self.z[_U_A] - self.z[_U_B], self.z[_V_A] - self.z[_V_B]

    @property
    def approach(self) -> float:
        return float(self.relative[0] @ self.n)

    @property
    def separation(self) -> float:
        return float(-self.relative[1] @ self.n)

    def turned(self, angle: float) -> Impact:
        """The same with the line of centres turned anticlockwise by an angle in radians."""
        return replace(self, n=math.cos(angle) * self.n + math.sin(angle) * self.t)

    def along(self) -> Array:
        """The covariance of the speeds of approach and of separation, of shape (2, 2)."""
        before, after = self.relative
        turned = np.array([before @ self.t, -after @ self.t])
        rows = np.array([_of_spheres(1, 0, -1, 0, self.n), _of_spheres(0, -1, 0, 1, self.n)])
        return self._propagated(rows, turned)

    def across(self) -> tuple[float, float, float]:
        """What the relative velocity gains along the tangent, its variance, and its mean there."""
        before, after = self.relative
        gain = float((after - before) @ self.t)
        rows = _of_spheres(-1, 1, 1, -1, self.t)[np.newaxis]
        turned = np.array([-(after - before) @ self.n])
        variance = float(self._propagated(rows, turned)[0, 0])
        return gain, variance, float((after + before) @ self.t) / 2

    def direction_error(self) -> float:
        """The standard error of the direction of ``n`` in radians."""
        variance = self.turning @ self.covariance @ self.turning
        return math.sqrt(float(variance) + self.line_error**2)

    def _propagated(self, rows: Array, turned: Array) -> Array:
        """The covariance of rows · z, each of which grows by ``turned`` as n turns by 1 rad."""
        jacobian = rows + np.outer(turned, self.turning)
        own = self.line_error**2 * np.outer(turned, turned)
        result: Array = jacobian @ self.covariance @ jacobian.T + own
        return result

    def momentum(self) -> tuple[Array, Array, Array] | None:
        """The momentum that is lost, its covariance, and the mean momentum; None without masses.

        The mean is that of before and after, whose error has little to do with that of the loss.
        """
        if self.trial.A.m is None or self.trial.B.m is None:
            return None
        a, b = self.trial.A.m, self.trial.B.m
        jacobian = np.hstack([_scaled(number) for number in (a.value, -a.value, b.value, -b.value)])
        covariance = jacobian @ self.covariance @ jacobian.T
        for mass, change in ((a, self.change_of_A), (b, self.change_of_B)):
            covariance += (mass.error or 0.0) ** 2 * np.outer(change, change)
        mean = a.value * (self.z[_U_A] + self.z[_V_A]) + b.value * (self.z[_U_B] + self.z[_V_B])
        return jacobian @ self.z, covariance, mean / 2

    @property
    def change_of_A(self) -> Array:
        return self.z[_V_A] - self.z[_U_A]

    @property
    def change_of_B(self) -> Array:
        return self.z[_V_B] - self.z[_U_B]


def impact_of(trial: SpheresTrial, covariance: Array) -> Impact | None:
    """The trial along its line of centres; None where no velocity changes and no line is given."""
    z = np.array([component for sphere in (trial.A, trial.B) for component in _components(sphere)])
    if trial.line_of_centres is None:
        return _with_line_of_impulse(trial, z, covariance)
    angle = math.radians(trial.line_of_centres.value)
    n = np.array([math.cos(angle), math.sin(angle)])
    error = math.radians(trial.line_of_centres.error or 0.0)
    impact = Impact(trial, z, covariance, n, np.zeros(8), error, given=True)
    if impact.approach + impact.separation >= 0:
        return impact
    return Impact(trial, z, covariance, -n, np.zeros(8), error, given=True)


def _with_line_of_impulse(trial: SpheresTrial, z: Array, covariance: Array) -> Impact | None:
    """The line along which both velocities change.

    The impulses are opposite, so the changes of both velocities lie on one line through the origin:
    the one with the least sum of squared distances from both, each divided by its variance. Masses
    are not needed for it, and would not make it better: with momentum conserved, the weighted mean
    of m_A Δv_A and −m_B Δv_B has the same direction and the same error.
    """
    weights = [_weight(covariance, *slices) for slices in ((_U_A, _V_A), (_U_B, _V_B))]
    changes = [z[_V_A] - z[_U_A], z[_V_B] - z[_U_B]]
    moments = sum(w * np.outer(d, d) for w, d in zip(weights, changes))
    values, vectors = np.linalg.eigh(moments)
    if not values[1] - values[0] > 1e-12 * float(np.abs(z).max() ** 2 * max(weights)):
        return None
    n = vectors[:, 1]
    if (changes[1] - changes[0]) @ n < 0:
        n = -n
    t = np.array([-n[1], n[0]])
    turning = np.zeros(8)
    for before, after, weight, change in zip((_U_A, _U_B), (_V_A, _V_B), weights, changes):
        slope = weight * (float(change @ n) * t + float(change @ t) * n) / (values[1] - values[0])
        turning[after] += slope
        turning[before] -= slope
    return Impact(trial, z, covariance, n, turning, 0.0, given=False)


def _weight(covariance: Array, before: slice, after: slice) -> float:
    """2 / the trace of the covariance of the change of a velocity; 0 for a wall, that has none."""
    change = covariance[before, before] + covariance[after, after] - 2 * covariance[before, after]
    trace = float(np.trace(change))
    return 2 / trace if trace > 0 else 0.0


def _components(sphere: MeasuredSphere) -> tuple[float, ...]:
    return sphere.u.x.value, sphere.u.y.value, sphere.v.x.value, sphere.v.y.value


def _of_spheres(u_A: float, v_A: float, u_B: float, v_B: float, along: Array) -> Array:
    """The row whose product with z is (u_A **u**_A + …) · along."""
    return np.concatenate([number * along for number in (u_A, v_A, u_B, v_B)])


def _scaled(factor: float) -> Array:
    return factor * np.eye(2)
