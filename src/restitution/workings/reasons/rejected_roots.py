"""Why roots are rejected: by what they make of another letter, *w = −3u and e = −1*, or where."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import (
    OPPOSITE,
    Derivation,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression, Letter, Negate, Unit
from restitution.planning.writing.forms import UnwrittenError, tree_of
from restitution.workings.naming.measured import vector_worth
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sources import Sources, bound_broken, root_of_a_square

_BEYOND = {"<": sp.Lt, "<=": sp.Le, ">": sp.Gt, ">=": sp.Ge}


def made_of_a_root(
    derivation: Derivation, naming: Naming, sources: Sources, line: Line
) -> Sentence | None:
    """What the root that is rejected would make of another letter, by which laws.

    What that letter may be stands behind it: *w = −u would give e = −1 by (2), but e ≥ 0*.
    """
    squared = root_of_a_square(derivation, line)
    if squared is not None and squared[1] in sources.numbers:
        root = naming.relation(Relation((squared[0],)))
        number = say("derived.number", number=str(sources.numbers[squared[1]]))
        return say("derived.no-root", value=root, equation=number)
    broken = bound_broken(derivation, line) if line.move.id == "reject" else None
    if broken is None:
        return None
    dropped, bound = broken
    values = _made_by_a_root(derivation, line, dropped, bound)
    source = sources.of(line)
    numbers = sorted(sources.numbers[e] for e in (source.reasons if source else ()))
    equations = tuple(say("derived.number", number=str(number)) for number in numbers)
    if not equations:
        return None
    results = tuple(map(naming.relation, values or (Relation(((bound,),)),)))
    root = naming.relation(Relation((dropped,)))
    if not values or any(link.sign != "=" for link in values[-1].only):
        return say("derived.would", value=root, results=results, equations=equations)
    allowed = naming.relation(Relation(((replace(bound, sign=OPPOSITE[bound.sign]),),)))
    slots = {"value": root, "results": results, "equations": equations, "bound": allowed}
    return say("derived.would-beyond", **slots)


def _made_by_a_root(
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
    names = sorted(symbol_names(*put) & (own | {last}) - {root})
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


def root_on_a_rim(derivation: Derivation, naming: Naming, line: Line, number: int) -> Sentence:
    """Why a body that moves parallel to an axis strikes a circular wall at one of two points.

    From inside it comes to the one that is in front of it, from outside to the nearer one. For a
    path that slants, only that it moves towards the wall there.
    """
    body, wall = naming.events[number].bodies
    otherwise = say("circle.towards", body=body, wall=wall)
    above = derivation.line(line.premises[0]) if isinstance(line.premises[0], int) else None
    datum = " ".join(("velocity", body))
    fact = derivation.fact(datum) if datum in line.premises else None
    if above is None or fact is None:
        return otherwise
    if not isinstance(above.relation, Relation) or not isinstance(line.relation, Relation):
        return otherwise
    velocity = vector_worth(fact.relation.only[-1].right)
    kept = line.relation.options[0]
    (*_, dropped) = [each for each in above.relation.options if each != kept] or [kept]
    try:
        ahead = in_letters(kept[-1].right, positive=True)
        ahead -= in_letters(dropped[-1].right, positive=True)
    except (RestitutionError, TypeError):
        return otherwise
    speeds = [] if velocity is None else [each for each in velocity if each != 0]
    sense = sp.sign(speeds[0] * tidy(ahead)) if len(speeds) == 1 else None
    if sense not in (-1, 1):
        return otherwise
    if sense < 0:
        return say("circle.first", body=body)
    unit = Unit("i" if velocity is not None and velocity[0] != 0 else "j")
    axis = naming.layout(unit if speeds[0].is_positive else Negate(unit))
    return say("circle.ahead", body=body, axis=axis)


__all__ = ["made_of_a_root", "root_on_a_rim"]
