"""Sets and values that a claim states, compared with the true ones."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution import exact
from restitution.errors import UnsupportedError
from restitution.expression.evaluate import Evaluator
from restitution.oracle import BeyondError, Oracle, Relation
from restitution.oracle.roles import Role
from restitution.problem import Compare, Range


def claimed_set(relation: Compare, subject: Range, evaluator: Evaluator) -> sp.Set:
    """The set that a chain such as ``0 < e < 1/2`` describes."""
    operands, operators = relation.operands, relation.operators
    where = next((i for i, tree in enumerate(operands) if tree == subject.expression), None)
    if where is None:
        raise UnsupportedError("the chain does not hold the quantity whose range is claimed")
    low, high = -sp.oo, sp.oo
    low_open = high_open = True
    for index, other, op in (
        (where - 1, where - 1, where - 1),
        (where + 1, where + 1, where),
    ):
        if not 0 <= index < len(operands):
            continue
        sign = operators[op]
        bound = evaluator.scalar(operands[other])
        if sign == "=":
            return sp.FiniteSet(bound)
        below = (sign.startswith("<")) == (index < where)
        if below:
            low, low_open = bound, not sign.endswith("=")
        else:
            high, high_open = bound, not sign.endswith("=")
    return sp.Interval(low, high, low_open, high_open)


def same_value(a: sp.Expr, b: sp.Expr, roles: Mapping[str, Role]) -> bool | None:
    """Whether two expressions are equal for all that their letters may be; None if that is open."""
    gap = sp.sympify(a - b, strict=True)
    if not gap.free_symbols:
        return exact.is_zero(gap)
    try:
        verdict = Oracle(roles).decide(Relation(gap, "="))
    except BeyondError:
        return None
    return {"proved": True, "refuted": False, "undecided": None}[verdict.answer]


def same_set(claimed: sp.Set, true_set: sp.Set, roles: Mapping[str, Role]) -> bool | None:
    """Whether two sets are equal, None if that is open.

    A claim without a lower end means down to zero.
    """
    if not isinstance(claimed, sp.Interval) or not isinstance(true_set, sp.Interval):
        return bool(claimed == true_set)
    if claimed.start != -sp.oo and claimed.left_open != true_set.left_open:
        return False
    if claimed.right_open != true_set.right_open:
        return False
    open_ = False
    for a, b in ((claimed.start, true_set.start), (claimed.end, true_set.end)):
        if a in (sp.oo, -sp.oo) or b in (sp.oo, -sp.oo):
            if a != b and not (a == -sp.oo and b == 0):
                return False
            continue
        same = same_value(a, b, roles)
        if same is False:
            return False
        open_ = open_ or same is None
    return None if open_ else True
