"""Requirements of a story: equations and conditions."""

from __future__ import annotations

from typing import Literal

from restitution.expression.evaluate import Scalar
from restitution.expression.tree import Place
from restitution.records import dataclass


@dataclass(frozen=True)
class Condition:
    """A requirement: ``value > 0``, or ``>= 0``, or ``!= 0``; else ``reason``.

    ``end_of`` is the wall whose end would be passed.
    """

    value: Scalar
    relation: Literal[">", ">=", "!="]
    reason: str
    kind: Literal["coefficient", "approach", "sign", "time", "place", "rest", "fact"] = "sign"
    end_of: str | None = None


@dataclass(frozen=True)
class AnyOf:
    """At least one of several conditions must hold."""

    options: tuple[Condition, ...]
    reason: str
    kind: Literal["place", "rest", "fact"] = "place"


@dataclass(frozen=True)
class Equation:
    """``value`` = 0, by ``reason``; ``place`` is where the text says so.

    Of what is told, a ``law`` is Newton's, a ``direction`` ties the components of a hidden one
    together, and a ``path`` leads a sphere somewhere.
    """

    value: Scalar
    reason: str
    place: Place | None = None
    fact: bool = False
    kind: Literal["law", "direction", "path"] = "path"
