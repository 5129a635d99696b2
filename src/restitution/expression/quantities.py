"""The quantities of the language: how many arguments each takes, and which stages."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Signature:
    """How a quantity is written: its numbers of arguments, its stages, and an example."""

    fewest: int
    most: int
    usage: str
    staged: bool = False
    before: bool = False
    at_time: bool = False
    stage_needed: bool = False


SIGNATURES: Mapping[str, Signature] = {
    "velocity": Signature(1, 1, "velocity(A) or velocity(A, n)", staged=True, before=True),
    "speed": Signature(1, 1, "speed(A) or speed(A, n)", staged=True, before=True),
    "direction": Signature(1, 1, "direction(A) or direction(A, n)", staged=True, before=True),
    "along": Signature(2, 2, "along(V, D)"),
    "across": Signature(2, 2, "across(V, D)"),
    "angle": Signature(2, 2, "angle(X, Y)"),
    "deflection": Signature(1, 1, "deflection(A) or deflection(A, n)", staged=True),
    "impulse": Signature(0, 1, "impulse, impulse(n), impulse(A) or impulse(A, n)", staged=True),
    "energy": Signature(
        0, 1, "energy, energy(n), energy(A) or energy(A, n)", staged=True, before=True
    ),
    "energy_lost": Signature(0, 0, "energy_lost or energy_lost(n)", staged=True),
    "total_energy_lost": Signature(0, 0, "total_energy_lost", staged=True),
    "momentum": Signature(
        0, 1, "momentum, momentum(A) or momentum(A, n)", staged=True, before=True
    ),
    "line_of_centres": Signature(0, 0, "line_of_centres or line_of_centres(n)", staged=True),
    "mass": Signature(1, 1, "mass(A)"),
    "position": Signature(
        1,
        1,
        "position(A), position(A, n) or position(A, at t)",
        staged=True,
        before=True,
        at_time=True,
    ),
    "time": Signature(0, 0, "time(n)", staged=True, stage_needed=True),
    "distance": Signature(
        2, 2, "distance(X, Y) or distance(A, B, at t)", staged=True, at_time=True
    ),
    "dot": Signature(2, 2, "dot(V, W)"),
    # Lines of a working alone speak of it: a statement gives e with the impact.
    "restitution": Signature(0, 0, "restitution(n)", staged=True, stage_needed=True),
}


def stands_alone(kind: str) -> bool:
    """Whether a quantity may be written without arguments."""
    signature = SIGNATURES[kind]
    return signature.fewest == 0 and not signature.stage_needed
