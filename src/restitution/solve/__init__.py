"""Problem → Solution: exact values for everything asked, with what was rejected and why."""

from __future__ import annotations

from restitution.solve.solution import (
    Answer,
    Branch,
    ItemResult,
    PartSolution,
    Rejected,
    RejectedBranch,
    Solution,
)
from restitution.solve.solver import solve

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
