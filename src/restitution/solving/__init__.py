"""Problem → Solution: exact values for everything asked, with what was rejected and why."""

from __future__ import annotations

from restitution.solving.equations.solution import (
    Answer,
    Branch,
    ItemResult,
    PartSolution,
    Rejected,
    RejectedBranch,
    Solution,
)
from restitution.solving.solver import solve

__all__ = [
    "Answer",
    "Branch",
    "ItemResult",
    "PartSolution",
    "Rejected",
    "RejectedBranch",
    "Solution",
    "solve",
]
