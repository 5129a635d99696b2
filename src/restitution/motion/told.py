"""The first name of `restitution.motion.parts`, which still answers."""

from restitution.motion.parts import PartMotion as Told
from restitution.motion.parts import motions

__all__ = ["Told", "motions"]
