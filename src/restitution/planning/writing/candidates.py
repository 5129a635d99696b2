"""Equations among which a route is chosen."""

from __future__ import annotations

import sympy as sp

from restitution.records import dataclass


@dataclass(frozen=True)
class Candidate:
    """An equation that may be used: its residuals, and what it costs a reader."""

    id: str
    cost: float
    residuals: tuple[sp.Expr, ...]
