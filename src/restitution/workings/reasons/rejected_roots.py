"""What a root that is rejected would make of another letter: *w = −3u and e = −1*."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Derivation, Line, Link, Meaning, Relation
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression, Letter
from restitution.planning.writing.forms import UnwrittenError, tree_of

_BEYOND = {"<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}


def made_by_a_root(
    derivation: Derivation, line: Line, dropped: Sequence[Link], bound: Link
) -> tuple[Relation, ...]:
    """What the other letters of the cited equations would be, that of the bound last.

    Empty where these equations do not tell, or are not linear in them.
    """
    equations = list(_equations(derivation, line))
    own = {each.relation.letter for each in derivation.lines if isinstance(each.relation, Meaning)}
    if not isinstance(dropped[0].left, Letter) or not isinstance(bound.left, Letter):
        return ()
    root, last = dropped[0].left.name, bound.left.name
    try:
        gaps = [in_letters(a, positive=True) - in_letters(b, positive=True) for a, b in equations]
        value = in_letters(dropped[-1].right, positive=True)
        limit = in_letters(bound.right, positive=True)
    except (RestitutionError, TypeError):
        return ()
    put = [sp.expand(gap.subs(sp.Symbol(root, positive=True), value)) for gap in gaps]
    names = sorted({x.name for gap in put for x in gap.free_symbols} & (own | {last}) - {root})
    unknowns = [sp.Symbol(name, positive=True) for name in names if name != last]
    unknowns.append(sp.Symbol(last, positive=True))
    signed = {each: sp.Dummy(each.name) for each in unknowns}
    put = [gap for gap in (each.xreplace(signed) for each in put) if gap != 0]
    if len(put) != len(unknowns) or last not in names:
        return ()
    try:
        (solution,) = sp.linsolve(put, list(signed.values()))
    except (ValueError, sp.polys.polyerrors.PolynomialError):
        return ()
    values = [tidy(each) for each in solution]
    if any(each.free_symbols & set(signed.values()) for each in values):
        return ()
    if _BEYOND[bound.sign](values[-1], limit) != sp.true:
        return ()
    try:
        trees = [tree_of(each) for each in values]
    except UnwrittenError:
        return ()
    relations = [
        Relation(((Link(Letter(each.name), "=", tree),),))
        for each, tree in zip(unknowns, trees, strict=True)
        if Letter(each.name) not in {left for left, _ in equations}  # it stands there already
    ]
    if values[-1].free_symbols and relations:
        beyond = Link(trees[-1], bound.sign, bound.right)
        relations[-1] = Relation(((Link(bound.left, "=", trees[-1]), beyond),))
    return tuple(relations)


def _equations(derivation: Derivation, line: Line) -> Iterator[tuple[Expression, Expression]]:
    """The sides of the equations that a line cites, but for its roots."""
    for ref in line.premises[1:]:
        above = derivation.line(ref) if isinstance(ref, int) else None
        relation = None if above is None else above.relation
        if isinstance(relation, Relation) and len(relation.options) == 1:
            links = relation.only
            if all(each.sign == "=" for each in links):
                yield links[0].left, links[-1].right


__all__ = ["made_by_a_root"]
