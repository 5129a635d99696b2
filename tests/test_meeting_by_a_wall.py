"""Two spheres that separate meet again only by way of a wall: no line says that one is faster."""

from __future__ import annotations

import pytest

from restitution.explaining.lines.derivation import Derivation
from restitution.language import parse
from restitution.planning.planner import plan
from restitution.solving import solve

STORY = """sphere P: mass {}, velocity 6i
sphere Q: mass 2, at rest
wall W: along j
P hits Q: along i, e = 1/2
Q hits W: e = 1/2
P hits Q: e = 1/4
show P and Q {}
"""


def derived(mass: int, claim: str) -> Derivation:
    problem = parse(STORY.format(mass, claim))
    return plan(solve(problem), partial=True)


# P of mass 6 goes on after Q, which comes back; P of mass 2 goes back faster than Q comes.
@pytest.mark.parametrize(("mass", "claim"), [(6, "collide again"), (2, "do not collide again")])
def test_that_they_separate_is_no_reason(mass: int, claim: str) -> None:
    derivation = derived(mass, claim)
    assert not derivation.items
    (note,) = derivation.notes
    assert (note.kind, note.reason, note.claim) == ("unwritten", "shown", None)
