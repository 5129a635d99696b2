"""The moves: what each makes of its premises, and whether a line is that.

A line is right if its residual (left minus right) is k times the expected one, and k is certain
not to be zero; for an inequality, the sign of k must be known. So equations need no prover, and a
step is one move long: that a line is true, or a consequence, does not make it right.
"""

from __future__ import annotations

from restitution.explaining.moves.bases import FLIPPED
from restitution.explaining.moves.following import follows
from restitution.explaining.moves.inequalities import MOST_COMPARED, is_certain, number_compared
from restitution.explaining.moves.laws import records_of

__all__ = [
    "FLIPPED",
    "MOST_COMPARED",
    "follows",
    "is_certain",
    "number_compared",
    "records_of",
]
