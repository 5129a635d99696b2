"""Motion between impacts and through them.

Between impacts every sphere moves uniformly, so a simulation needs no time step: it goes from
impact to impact, and all that there is to know are straight pieces and what happens at their ends.
"""

from __future__ import annotations

from restitution.motion.run import Run, State, simulate
from restitution.motion.table import Table, polygon

__all__ = ["Run", "State", "Table", "polygon", "simulate"]
