"""Why a condition holds for all values of its letters: by the range of a coefficient in it."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression, Letter, Number, letters
from restitution.oracle import BeyondError, Formula, Oracle, compared
from restitution.oracle.roles import REAL
from restitution.solving.story.letters import roles
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.together import merged

_ZERO, _ONE = (Number(Fraction(n)) for n in (0, 1))


def range_behind(naming: Naming, relation: Relation) -> Relation | None:
    """The range of the coefficient by which a sign is seen; None where none, or more, are needed.

    The other letters are positive.
    """
    known = roles(naming.problem)
    names = sorted({name for tree in trees_of(relation) for name in letters(tree)})
    coefficients = [n for n in names if n in known and known[n].kind == "restitution"]
    others = [n for n in names if n not in coefficients]
    if len(coefficients) != 1 or any(n in known and known[n].kind != "positive" for n in others):
        return None
    (link,) = relation.only
    coefficient, room = Letter(coefficients[0]), sp.Symbol("room", nonnegative=True)
    for worth, links in (
        (room, (Link(coefficient, ">=", _ZERO),)),
        (1 - room, (Link(coefficient, "<=", _ONE),)),
    ):

        def letter(name: str, worth: sp.Expr = worth) -> sp.Expr:
            return worth if name == coefficients[0] else sp.Symbol(name, positive=True)

        try:
            sides = (evaluate(side, letter) for side in (link.left, link.right))
            left, right = (sp.sympify(side, strict=True) for side in sides)
        except (RestitutionError, TypeError, ValueError):
            return None
        gap = sp.expand(left - right if link.sign[0] == ">" else right - left)
        if gap.is_positive or (gap.is_nonnegative and link.sign in (">=", "<=")):
            return Relation((links,))
    return None


def bounds_behind(naming: Naming, relation: Relation) -> tuple[Relation, ...]:
    """The bounds of coefficients by which an inequality always holds, as few as prove it.

    Empty where it holds without them, as a sum of squares does, and where nothing is proved.
    """
    match relation.options:
        case ((Link(left, "<" | "<=" | ">" | ">=" as sign, right),),):
            pass
        case _:
            return ()
    own = roles(naming.problem)
    names = {name for tree in (left, right) for name in letters(tree)}
    coefficients = sorted(n for n in names if n in own and own[n].kind == "restitution")
    free = {**own, **dict.fromkeys(coefficients, REAL)}
    bounds = [
        link
        for name in coefficients
        for link in (Link(Letter(name), ">=", _ZERO), Link(Letter(name), "<=", _ONE))
    ]

    def proves(links: Sequence[Link]) -> bool:
        def symbol(name: str) -> sp.Expr:
            return free[name].symbol(name)

        def formula(one: Expression, sign: str, other: Expression) -> Formula:
            return compared(evaluate(one, symbol), sign, evaluate(other, symbol))

        try:
            within = [formula(link.left, link.sign, link.right) for link in links]
            return Oracle(free).with_facts(within).proves(formula(left, sign, right))
        except (RestitutionError, BeyondError, KeyError, TypeError, ValueError):
            return False

    if not bounds or not proves(bounds):
        return ()
    for link in tuple(bounds):
        fewer = [other for other in bounds if other != link]
        if proves(fewer):
            bounds = fewer
    return tuple(merged(bounds))


__all__ = ["bounds_behind", "range_behind"]
