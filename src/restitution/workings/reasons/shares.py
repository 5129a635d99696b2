"""What a value is of its bound: a product of factors, of which none is more than 1."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation, Sign, turned
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression, Number, has_quantity
from restitution.oracle import BeyondError, Oracle, Role, compared
from restitution.planning.writing.forms import product, tree_of
from restitution.workings.reasons.signs_of_factors import cited_bounds, worth_of

_ONE = Number(Fraction(1))
_SEVERAL = 2


def share_of(derivation: Derivation, line: Line) -> sp.Expr | None:
    """What a value is of its upper bound, in factors; None where that is no product of letters."""
    match line.relation:
        case Relation(((Link(sign="<" | "<=") as link,),)) if line.move.id == "sign":
            pass
        case Relation(((Link(sign=">" | ">=") as above,),)) if line.move.id == "sign":
            link = turned(above)
        case _:
            return None
    values: dict[Expression, Expression] = {}
    for own in derivation.lines_in(line.premises):
        match own.relation:
            case Relation((links,)) if all(e.sign == "=" for e in links):
                values[links[0].left] = links[-1].right
            case _:
                return None  # another bound is cited
    sides = [rebuilt(side, lambda tree: values.get(tree, tree)) for side in (link.left, link.right)]
    if not values or any(map(has_quantity, sides)):
        return None
    try:
        value, most = (in_letters(side) for side in sides)
    except (RestitutionError, TypeError, ValueError):
        return None
    share = sp.factor(value / most)
    if not share.free_symbols or share.has(sp.zoo):
        return None
    roots = any(not atom.exp.is_Integer for atom in share.atoms(sp.Pow))
    return None if roots else share


def bounded_factors(
    derivation: Derivation, line: Line, roles: Mapping[str, Role]
) -> tuple[Relation, ...]:
    """That each factor of what a value is of its bound is at most 1, or less: 1 - e^2 <= 1.

    Empty where fewer than two factors have letters, and where the greatest values of them all do
    not come to 1 together.
    """
    share = share_of(derivation, line)
    parts = [] if share is None else list(_apart(share))
    if share is None or len(parts) < _SEVERAL:
        return ()
    assert isinstance(line.relation, Relation)
    oracle = Oracle(roles, tuple(cited_bounds(derivation, line, roles)))
    whole = sp.Mul(*(factor for factor in sp.Mul.make_args(share) if factor.is_number))
    strict = line.relation.only[0].sign in ("<", ">")
    bounds: list[Relation] = []
    try:
        for part in parts:
            most = _greatest(part, oracle, roles)
            if most is None:
                return ()
            whole *= most
            tree = _share_of_most(part, most)
            below = compared(worth_of(tree, roles), "<", sp.Integer(1))
            sign: Sign = "<" if strict and oracle.proves(below) else "<="
            bounds.append(Relation(((Link(tree, sign, _ONE),),)))
    except (RestitutionError, BeyondError):
        return ()
    return tuple(bounds) if whole == 1 else ()


def _apart(share: sp.Expr) -> Iterator[sp.Expr]:
    """The factors of a product with letters, those with one letter in one."""
    left = [factor for factor in sp.Mul.make_args(share) if not factor.is_number]
    left.sort(key=lambda factor: factor.has(sp.Function))
    while left:
        own = [left.pop(0)]
        for factor in [e for e in left if e.free_symbols & own[0].free_symbols]:
            left.remove(factor)
            own.append(factor)
        yield sp.Mul(*own)


def _greatest(part: sp.Expr, oracle: Oracle, roles: Mapping[str, Role]) -> sp.Expr | None:
    """What a factor in one letter is at an end of that, and never further from zero; or None."""
    (symbol, *rest) = sorted(part.free_symbols, key=str)
    role = roles.get(symbol.name)
    if rest or role is None:
        return None
    own = worth_of(tree_of(part), roles)
    for end in (role.low, role.high):
        most = sp.limit(part, symbol, sp.oo if end is None else end)
        if not most.is_number or not most.is_finite or most == 0:
            continue
        if oracle.proves(compared(own / most, "<=", sp.Integer(1))):
            return most
    return None


def _share_of_most(part: sp.Expr, most: sp.Expr) -> Expression:
    """A factor divided by the greatest value that it has: 1/2 (1 + e)."""
    if abs(most) == 1:
        return tree_of(part / most if part.has(sp.Function) else sp.cancel(part / most))
    return product(tree_of(1 / most), tree_of(part))


__all__ = ["bounded_factors", "share_of"]
