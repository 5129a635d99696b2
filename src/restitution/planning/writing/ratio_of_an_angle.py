"""The ratio of an angle that a line gives, and the range in which the angle lies."""

from __future__ import annotations

from typing import Any

from restitution.explaining.lines.derivation import Ref
from restitution.expression.tree import (
    Expression,
)
from restitution.records import dataclass

RANGES = {"deflection": "0° <= {} <= 180°", "direction": "-180° < {} <= 180°"}


@dataclass(frozen=True)
class Ratio:
    """A line that gives a ratio of an angle, and what makes the angle the only one.

    ``open`` tells that the angle is another for other values of the letters.
    """

    line: int
    letter: str
    function: str
    value: Any
    extent: str
    side: tuple[Ref, ...] = ()
    angle: Expression | None = None
    open: bool = False
