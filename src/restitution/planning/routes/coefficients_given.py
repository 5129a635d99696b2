"""Ranges and extrema of which a given fact of the motion ties the coefficient to other letters.

The coefficient is worked out first: what is bounded stands without it then.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress

import sympy as sp

from restitution.expression.tree import Letter, has_quantity
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.scene import Scene


def with_coefficients_given(scene: Scene, solver: Solver, write: Callable[[], None]) -> None:
    """Writes an item; where there is no way, or it leaves a given fact idle, once more.

    Then it stands below the coefficients that the fact tells by other letters.
    """
    tied, standing = _tied(scene), solver.mark()
    if not tied:
        write()
        return
    with suppress(NotPlannedError, sp.PolynomialError):
        write()
        if not _idle(scene):
            return
    solver.back(standing)
    with suppress(NotPlannedError, sp.PolynomialError):
        solver.determine(tied)
        write()
        return
    solver.back(standing)
    write()


def _idle(scene: Scene) -> bool:
    """Whether a given equation of the motion, or a direction, has not been used by now."""
    cited = {ref for line in scene.desk.lines for ref in line.premises}
    return any(
        given.fact.id not in cited
        and given.link.sign in _TIES
        and any(map(has_quantity, (given.link.left, given.link.right)))
        for given in scene.given
    )


def _tied(scene: Scene) -> list[sp.Expr]:
    """The open coefficients that are expressions of other letters, as a fact not used yet says."""
    if not _idle(scene):
        return []
    roles = scene.model.unknowns.roles
    return [
        symbol
        for symbol, value in scene.model.final.items()
        if symbol.name in roles
        and roles[symbol.name].kind == "restitution"
        and sp.sympify(value, strict=True).free_symbols
        and scene.desk.known(Letter(symbol.name)) is None
    ]


_TIES = ("=", "perpendicular to", "parallel to")

__all__ = ["with_coefficients_given"]
