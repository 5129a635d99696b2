"""Many discs in a box, as fast as may be: the front of the compiled engine.

``box`` is what is used, ``windows`` the run in windows and tiles, ``tiles`` and ``kernel`` the
functions that are compiled, ``state`` the rows that they work on, ``record`` what is written down.
"""

from __future__ import annotations

from restitution.gas.box import Gas
from restitution.gas.record import IMPACT, write

__all__ = ["IMPACT", "Gas", "write"]
