"""A solved problem as pictures to scale: scenes of shapes as data, and SVG made of them."""

from __future__ import annotations

from restitution.draw.before_after import before_and_after
from restitution.draw.said import sayings
from restitution.draw.scene import Scene
from restitution.draw.values import motion
from restitution.problem import Impact, Kick
from restitution.solve.solution import Solution


def scenes(solution: Solution, part: str | None = None) -> tuple[Scene, ...]:
    """X"""
    made = []
    done = set()
    for label, each in solution.parts.items():
        if part is not None and label != part:
            continue
        if not each.branches:
            continue
        told = motion(solution, each, each.branches[0])
        said = sayings(told)
        for h in told.story.happenings:
            if isinstance(h.step, Impact | Kick) and h.number not in done:
                made.append(before_and_after(told, said, h.number))
                done.add(h.number)
    return tuple(made)
