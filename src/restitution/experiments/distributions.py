"""Tail probabilities and quantiles, for errors that are known and for errors that are estimated.

Errors that were estimated with so many degrees of freedom make a normal deviation one of Student's
t, and a χ² one of F. They come of `scipy.special`, which loads in a third of the time of
`scipy.stats`.
"""

from __future__ import annotations

from typing import overload

import numpy as np

from restitution.experiments.curves import Array
from restitution.experiments.needs import needed


@overload
def upper_tail(deviation: float, freedom: float | None) -> float: ...
@overload
def upper_tail(deviation: Array, freedom: float | None) -> Array: ...
def upper_tail(deviation: float | Array, freedom: float | None) -> float | Array:
    """The probability of so large a deviation in standard errors, or a larger one, by chance.

    ``freedom`` is None where the errors are known. An array has the probability of each.
    """
    special = needed("scipy.special", "a test")
    below = np.negative(deviation)
    p = special.ndtr(below) if freedom is None else special.stdtr(freedom, below)
    return float(p) if np.ndim(deviation) == 0 else np.asarray(p, dtype=np.float64)


def upper_tail_of_squares(total: float, count: int, freedom: float | None) -> float:
    """The probability that ``count`` squared deviations come to so much, or more, by chance.

    ``freedom`` is None where the errors are known.
    """
    special = needed("scipy.special", "a test")
    if freedom is None:
        return float(special.chdtrc(count, total))
    return float(special.fdtrc(count, freedom, total / count))


def limit_of_square(level: float, freedom: float | None) -> float:
    """What one squared deviation exceeds with the probability 1 − ``level``."""
    special = needed("scipy.special", "an interval")
    if freedom is None:
        return float(special.chdtri(1, 1 - level))
    return float(special.fdtri(1, freedom, level))
