"""The Lab: the motion of a scene, and the question that one of its impacts makes."""

from restitution.export.lab.question import question
from restitution.export.lab.scene import simulated

__all__ = ["question", "simulated"]
