"""An experiment and a plan as values that write themselves as text."""

from __future__ import annotations

from restitution.experiments import plan_text, texts
from restitution.experiments.plans import PlanContent
from restitution.experiments.results import ExperimentContent


class Experiment(ExperimentContent):
    """The coefficient of restitution from what was measured.

    ``error_source`` says where the errors of the readings are from; ``angle_error`` is the error of
    one angle in degrees where it is the same for all, else None, and ``speed_error`` that of one
    component of a velocity.
    """

    def text(self, width: int = 80) -> str:
        """What a student reads in a terminal, in lines of at most ``width`` columns."""
        return texts.written(self, width)


class Plan(PlanContent):
    """What is to be expected of an experiment with a wall.

    ``best_angle`` is that at which one reading tells most of e, in degrees; ``recommended`` the id
    of a design. ``trials_for`` has half widths of the interval of 95% with the trials, of the
    recommended design, that they take.
    """

    def text(self, width: int = 80) -> str:
        """The plan in lines of at most ``width`` columns."""
        return plan_text.written(self, width)
