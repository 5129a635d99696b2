"""Equations solved together: the values of their unknowns, put in one by one.

The line says the value of each unknown. It is right if every equation holds with these values
exactly, if there are as many equations as unknowns, and if the equations fix them: the determinant
of their slopes is not zero there. So no equation is cited that is not needed.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.explaining.lines.derivation import Link, Relation, whole_of
from restitution.explaining.lines.quotients import NotComparableError, Plane
from restitution.explaining.steps.step import Step
from restitution.expression.tree import Expression, Letter
from restitution.oracle import REAL, BeyondError, Oracle
from restitution.oracle import Relation as Claim

# Of more unknowns nobody would write such a line.
_MOST = 8


def solves(step: Step, relation: Relation) -> bool:
    """Whether a line gives the values of all unknowns of the equations that are cited.

    Alternatives are several solutions; each has to satisfy the equations.
    """
    # What is cited is to be solved, and stands for nothing else.
    bare = step.under(cited=())
    equations = _equations(step, bare)
    if not equations or any(link.sign != "=" for links in relation.options for link in links):
        return False
    return all(_satisfied(bare, equations, links) for links in relation.options)


def _equations(step: Step, bare: Step) -> list[sp.Expr] | None:
    """What is cited as expressions that are zero; None where something else is cited."""
    equations: list[sp.Expr] = []
    for premise in step.cited:
        if not isinstance(premise.relation, Relation) or len(premise.relation.options) != 1:
            return None
        link = whole_of(premise.relation.only)
        if link is None or link.sign != "=":
            return None
        value = bare.residual(link)
        parts = (value.x, value.y) if isinstance(value, Plane) else (value,)
        equations += [bare.world.expression(part, bare.setting.roles) for part in parts]
    return equations


def _satisfied(step: Step, equations: Sequence[sp.Expr], links: Sequence[Link]) -> bool:
    values = {
        _expression(step, link.left, of=True): _expression(step, link.right) for link in links
    }
    unknowns = list(values)
    if len(unknowns) != len(links) or len(links) != len(equations) or len(links) > _MOST:
        return False
    if not all(unknown.is_Symbol for unknown in unknowns):
        return False
    if any(value.free_symbols & set(unknowns) for value in values.values()):
        return False
    oracle = Oracle(step.setting.roles)
    slopes = sp.Matrix([[sp.diff(equation, x) for x in unknowns] for equation in equations])
    try:
        return all(
            _is_finite(own := equation.subs(values)) and oracle.proves(Claim(own, "="))
            for equation in equations
        ) and _is_not_zero(oracle, slopes.subs(values).det(method="berkowitz"))
    except BeyondError:
        return False


def _is_not_zero(oracle: Oracle, value: sp.Expr) -> bool:
    """Whether an expression is not zero for all letters: at one of them is enough."""
    return _is_finite(value) and oracle.decide(Claim(value, "=")).answer == "refuted"


def _is_finite(value: sp.Expr) -> bool:
    return not value.has(sp.nan, sp.zoo, sp.oo, -sp.oo)


def _expression(step: Step, tree: Expression, of: bool = False) -> sp.Expr:
    """A side as an expression: an unknown by its own letter, a value in radians."""
    if of and isinstance(tree, Letter):
        return step.setting.roles.get(tree.name, REAL).symbol(tree.name)
    value = step.world.value(tree)
    if isinstance(value, Plane):
        raise NotComparableError("a vector among the unknowns")
    return step.world.expression(value, step.setting.roles)
