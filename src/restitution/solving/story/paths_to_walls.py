"""Angles of paths to walls that letters leave open: where one may be acute, it is."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import sympy as sp

from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Apply, Binary, Expression, Name, Polar, letters
from restitution.oracle import Oracle, compared
from restitution.problem import Problem, Sphere
from restitution.solving.story.letters import roles


def angle_to_be_acute(problem: Problem, sphere: Sphere) -> Expression | None:
    """The angle, such as 2θ, at which a sphere comes to a wall, that may be acute and obtuse.

    None of one that its letters make the one or the other.
    """
    match sphere.velocity:
        case Polar(_, Binary() as angle, wall=Name()) if _is_open(problem, angle):
            return angle
    return None


@lru_cache(maxsize=256)
def _is_open(problem: Problem, angle: Expression) -> bool:
    names = {name: role for name, role in roles(problem).items() if name in letters(angle)}
    if not names or not all(role.kind == "angle" for role in names.values()):
        return False
    cosine: Any = evaluate(Apply("cos", angle), lambda name: names[name].symbol(name))
    return not any(Oracle(names).proves(compared(cosine, s, sp.Integer(0))) for s in ("<=", ">"))
