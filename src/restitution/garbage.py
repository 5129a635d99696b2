"""How often Python looks for garbage, in a process whose work is to solve and to explain."""

from __future__ import annotations

import gc


def collect_seldom() -> None:
    """Have circles of objects looked for seldom.

    Loading makes many objects and no garbage, and trees are freed when nobody refers to them: to
    look for circles as often as Python does takes a tenth of the time until a first answer, and
    some seven hundredths of that of a working.
    """
    gc.set_threshold(50_000, 20, 20)


__all__ = ["collect_seldom"]
