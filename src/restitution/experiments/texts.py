"""An experiment as text for a terminal."""

from __future__ import annotations

from restitution.experiments.results import Experiment


def written(experiment: Experiment, width: int) -> str:
    """What a student reads."""
    return f"e = {experiment.e:.3f} ± {experiment.standard_error:.3f}\n"
