"""What people write in place of the language: patterns, each with its cure.

A pattern tells where a slip is found, its group ``x`` (else all of it) what is wrong there. Each
area has a module; of several that are found where a mistake is, the first counts.
"""

from __future__ import annotations

from restitution.language.slip_tables.asked import ASKED
from restitution.language.slip_tables.bodies import BODIES
from restitution.language.slip_tables.directions import DIRECTIONS
from restitution.language.slip_tables.motions import MOTIONS
from restitution.language.slip_tables.patterns import NAME, Cure, Slip
from restitution.language.slip_tables.properties import PROPERTIES
from restitution.language.slip_tables.relations import RELATIONS
from restitution.language.slip_tables.stages import STAGES
from restitution.language.slip_tables.walls import WALLS

__all__ = ["NAME", "SLIPS", "Cure"]

SLIPS: tuple[Slip, ...] = (
    *STAGES,
    *MOTIONS,
    *BODIES,
    *WALLS,
    *PROPERTIES,
    *DIRECTIONS,
    *ASKED,
    *RELATIONS,
)
