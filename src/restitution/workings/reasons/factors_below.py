"""The factors of a value that are each at most 1, so that their product is below a bound."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TypeAlias

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression, Letter, has_quantity
from restitution.oracle.roles import Role
from restitution.planning.writing.forms import ONE, tree_of

Values: TypeAlias = Mapping[Expression, Expression]


def factors_below(
    relation: Relation, cited: Iterable[Relation | None], roles: Mapping[str, Role]
) -> tuple[Link, ...]:
    """Why a value is below a bound that it has but for such factors: 1 − e² ≤ 1, cos α < 1.

    There are a power of a sine or a cosine of an acute angle, and a sum with a coefficient of
    restitution; of anything else nothing is said.
    """
    match relation.options:
        case ((Link(left, "<", right),),):
            pass
        case _:
            return ()
    values = _values(cited)
    share = None if values is None else _share(left, right, values)
    if share is None:
        return ()
    ratios = [e for e in share.atoms(sp.sin, sp.cos) if e.args[0].is_Symbol]
    letters = sorted(share.free_symbols, key=str)
    names = [symbol for symbol in letters if _kind(symbol, roles) == "restitution"]
    if len(ratios) != 1 or len(names) != 1 or len(letters) != len(ratios) + len(names):
        return ()
    (ratio,), (e,) = ratios, names
    rest, power = share.as_independent(ratio, as_Add=False)
    if _kind(ratio.args[0], roles) != "angle" or not _is_power(power, ratio):
        return ()
    sum_ = sp.expand(rest)
    bound = _bound(sum_, e)
    if bound is None:
        return ()
    return bound, Link(tree_of(power), "<", ONE)


def _values(cited: Iterable[Relation | None]) -> Values | None:
    """What quantities are, by lines that are plain equations; None where there is another."""
    values: dict[Expression, Expression] = {}
    for own in cited:
        if own is None:
            continue
        if len(own.options) != 1 or any(link.sign != "=" for link in own.only):
            return None
        values[own.only[0].left] = own.only[-1].right
    return values


def _share(left: Expression, right: Expression, values: Values) -> sp.Expr | None:
    """What a value is of its bound."""
    sides = [rebuilt(side, lambda tree: values.get(tree, tree)) for side in (left, right)]
    if any(map(has_quantity, sides)):
        return None
    try:
        value, most = (sp.sympify(in_letters(side), strict=True) for side in sides)
        share = sp.factor(value / most)
    except (RestitutionError, TypeError, ValueError, sp.PolynomialError):
        return None
    return share if share.is_finite is not False else None


def _kind(letter: sp.Basic, roles: Mapping[str, Role]) -> str:
    role = roles.get(getattr(letter, "name", ""))
    return "" if role is None else role.kind


def _is_power(power: sp.Expr, ratio: sp.Expr) -> bool:
    base, exponent = power.as_base_exp()
    return bool(base == ratio and exponent.is_Integer and exponent > 0)


def _bound(sum_: sp.Expr, e: sp.Symbol) -> Link | None:
    """The bound of a sum in a coefficient that is 1 at most: at 0 by the sum, at 1 by that."""
    if not sum_.is_polynomial(e):
        return None
    if sum_.subs(e, 1) == 1 and all(c > 0 for c in sp.Poly(sum_, e).coeffs()):
        return Link(Letter(e.name), "<=", ONE)
    less = 1 - sum_
    if sum_.subs(e, 0) == 1 and all(c > 0 for c in sp.Poly(less, e).coeffs()):
        return Link(tree_of(sum_), "<=", ONE)
    return None


__all__ = ["factors_below"]
