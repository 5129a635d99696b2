"""Pictures put into a worked solution: each impact's beside its working, the plan at the top."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, TypeVar

from restitution.errors import RestitutionError
from restitution.explaining.lines.saying import say
from restitution.solving.worker import UNFORESEEN
from restitution.workings.rendering.steps import PartExplanation, Step, Working

if TYPE_CHECKING:
    from restitution.drawing.scene import Scene

Told = TypeVar("Told", bound=Working)


def illustrated(explanation: Told) -> Told:
    """The same with its pictures as steps of their own.

    What cannot be drawn is left out; where that is a defect of this package, a warning says so.
    """
    from restitution.drawing import scenes

    if explanation.solution is None:
        return explanation
    try:
        drawn = scenes(explanation.solution, letters=explanation.letters)
    except RestitutionError:
        return explanation  # unsolved: the working says why
    except (*UNFORESEEN, AssertionError):
        amiss = str(say("amiss.pictures"))
        return replace(explanation, warnings=(*explanation.warnings, amiss))
    parts = tuple(
        _illustrated(part, [scene for scene in drawn if scene.part == part.label])
        for part in explanation.parts
    )
    return replace(explanation, parts=parts)


def _illustrated(part: PartExplanation, scenes: Sequence[Scene]) -> PartExplanation:
    """The plan at the top, pictures behind the headings of their impacts.

    Where no impact has a heading they stand at the top too; where some have, the others are not
    worked on, and the plan shows them.
    """
    headed = {step.event for step in part.steps if step.kind == "heading"}
    plan = [scene for scene in scenes if scene.event is None]
    top = plan if headed & {scene.event for scene in scenes} else list(scenes)
    own = {scene.event: scene for scene in scenes if scene.event in headed}

    def steps() -> Iterator[Step]:
        yield from map(_step, top)
        for step in part.steps:
            yield step
            if step.kind == "heading" and step.event in own:
                yield _step(own.pop(step.event))

    return replace(part, steps=tuple(steps()))


def _step(scene: Scene) -> Step:
    return Step("picture", picture=scene, event=scene.event)
