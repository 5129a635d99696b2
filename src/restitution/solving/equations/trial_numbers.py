"""Numbers for a set of values at which nothing but a coefficient of restitution is wrong."""

from __future__ import annotations

import random
from collections.abc import Mapping

from restitution.errors import ImpossibleError
from restitution.expression.enclosed import UndefinedError
from restitution.oracle.roles import Role
from restitution.solving.algebra.numbers import Sample, at, sample
from restitution.solving.equations.setting import Setting, Trial, is_met
from restitution.solving.story.conditions import Equation
from restitution.solving.story.forward import Story
from restitution.solving.story.unknowns import Numbers

_TRIES = 8
"""Draws of the letters."""


def example_of(
    setting: Setting,
    trial: Trial,
    known: Mapping[str, Role],
    *,
    out_of_range: bool = False,
) -> tuple[Sample, Story] | None:
    """Values of the letters, and the story with them, at which only the coefficient is wrong.

    A root of an equation that was squared is no value that the data imply. Where a letter is
    ``out_of_range``, equations alone have to hold.
    """
    free = sorted(set(known) - set(trial.root.values))
    dice = random.Random(41)
    for _ in range(_TRIES if free else 1):
        values = sample(free, known, dice)
        try:
            for name, value in trial.root.values.items():
                values[name] = at(value, values)
            story = setting.tell(Numbers(values))
            wanted = (*story.equations, *story.conditions, *setting.requirements(story))
        except (UndefinedError, KeyError, ImpossibleError, ZeroDivisionError):
            continue
        if out_of_range:
            wanted = tuple(condition for condition in wanted if isinstance(condition, Equation))
        if all(condition.kind == "coefficient" or is_met(condition) for condition in wanted):
            return values, story
    return None
