"""Which impacts there can be, for any kind of number, compiled ones among them."""

from __future__ import annotations

import math
from typing import Any


def possible(w1: Any, w2: Any, c: Any, e: Any) -> Any:
    """Whether there can be such an impact, for any kind of number; false where one is not a number.

    What is done to each number is what compiled code can do to eight of them.
    """
    w, square = w1 + w2, c.dot(c)
    return (
        (e >= 0)
        & (e <= 1)
        & (w1 >= 0)
        & (w2 >= 0)
        & (w > 0)
        & (w < math.inf)
        & (square > 0)
        & (square < math.inf)
    )
