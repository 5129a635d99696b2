"""Many discs in a box, as fast as may be: the front of the compiled engine.

``box`` is what is used, ``start`` where a gas starts, ``windows`` the run in windows and tiles
(``pauses`` what is done between two), ``tiles`` and ``kernel`` the functions that are compiled,
``state`` the rows that they work on, ``estimates`` how fast the discs move and how often they are
struck, ``record`` what is written down.
"""

from __future__ import annotations

from restitution.gas.box import Gas
from restitution.gas.record import IMPACT, write

__all__ = ["IMPACT", "Gas", "write"]
