"""All recipes for questions, by topic and level."""

from __future__ import annotations

from collections.abc import Mapping

from restitution.practice.questions import (
    given_facts,
    lines_of_centres,
    one_wall,
    two_spheres,
    two_walls,
)
from restitution.practice.questions.dice import Recipe

RECIPES: Mapping[tuple[str, int], tuple[Recipe, ...]] = {
    **one_wall.RECIPES,
    **two_walls.RECIPES,
    **two_spheres.RECIPES,
    **lines_of_centres.RECIPES,
    **given_facts.RECIPES,
}
