"""Straight-line regressions through the origin, for what should be 0 by the model."""

from __future__ import annotations

import math

import numpy as np

from restitution.experiments.curves import Array
from restitution.experiments.distributions import upper_tail
from restitution.records import dataclass


@dataclass(frozen=True)
class Regression:
    """Coefficients of y = X b with their standard errors, and p-values of each being 0.

    ``known`` is False where the errors are estimated from the scatter about the regression itself.
    """

    coefficients: Array
    errors: Array
    sum_of_squares: float
    p_values: Array


def regression(
    y: Array,
    variances: Array,
    columns: list[Array],
    *,
    known: bool,
    freedom: int | None = None,
) -> Regression | None:
    """The regression of y on columns, all of shape (n,), weighted by 1/variances.

    None where the readings do not determine it. Where errors are not known, ``variances`` are so
    up to a factor; ``freedom`` are the degrees of freedom of errors that were
    estimated elsewhere.
    """
    X = np.column_stack(columns) / np.sqrt(variances)[:, np.newaxis]
    target = y / np.sqrt(variances)
    spare = len(y) - len(columns)
    if spare < (0 if known else 1):
        return None
    sizes = np.linalg.norm(X, axis=0)
    if np.any(sizes == 0) or np.linalg.cond(X / sizes) > _ALIKE:
        return None
    inverse = np.linalg.inv(X.T @ X)
    coefficients = inverse @ (X.T @ target)
    square = float(((target - X @ coefficients) ** 2).sum())
    errors = np.sqrt(np.diag(inverse))
    if not known:
        errors = errors * math.sqrt(square / spare)
    sure = np.where(coefficients == 0, 0.0, np.inf)
    z = np.divide(np.abs(coefficients), errors, out=sure, where=errors > 0)
    freedom = freedom if known else spare
    p = 2 * upper_tail(z, freedom)
    return Regression(coefficients, errors, square, p)


_ALIKE = 1e6
"""Columns whose condition is larger are one column."""
