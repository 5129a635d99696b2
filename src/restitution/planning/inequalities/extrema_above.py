"""A greatest or least value, and a bound, that an earlier part gives in letters.

They have values now, or it is to be shown what follows from it.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Line,
    Link,
    Meaning,
    Move,
    Ref,
    Relation,
    turned,
)
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import Apply, Expression, Letter, Quantity, has_quantity
from restitution.planning.inequalities.claims import Claims
from restitution.planning.writing.forms import tree_of

_PUT = (Move("put"),)
_NAMED = (Move("put"), Move("rearrange"), Move("compare"))


def write_bound_again(claims: Claims, move: Move, asked: Link) -> int | None:
    """The line of a greatest or least value, by the bound and its place with the values put in.

    ``asked`` is the bound as an answer. None where no other part gives one in letters which have
    these values.
    """
    desk = claims.scene.desk
    subjects = dict(_subjects(claims, asked.left))
    end = _by_tangent(claims, asked)
    for line in reversed(desk.lines):
        link = _bound(claims, line)
        if link is None or link.left not in subjects or link.sign != end.sign:
            continue
        mark = claims.worths.mark()
        put = _put_below if end != asked else _put
        bound = put(claims, line, end, subjects[link.left])
        there = None if bound is None else _place(claims, line)
        whole = Relation(((end,),))
        if bound is None or there is None or not claims.judge.follows(move, (bound, there), whole):
            claims.worths.back(mark)
            continue
        return desk.write(move, (bound, there), whole)
    return None


def write_by_a_bound_above(claims: Claims, claim: Link) -> int | None:
    """An inequality of a quantity by a bound that an earlier part has, with the values put in.

    None where no other part has one on that side, or where it is too wide.
    """
    link = claim if has_quantity(claim.left) else turned(claim)
    if has_quantity(link.right) or not has_quantity(link.left) or link.sign not in FLIPPED:
        return None
    for line in reversed(claims.scene.desk.lines):
        own = _bound(claims, line)
        if own is None or own.left != link.left or own.sign[0] != link.sign[0]:
            continue
        mark = claims.worths.mark()
        value, refs = _with_values(claims, own.right)
        relation, bound = Relation(((claim,),)), line.number
        if refs and tidy(value - claims.worths.value(link.right)) == 0:
            last = claims.judge.write(_PUT, [bound, *refs], relation)
        else:
            put = Relation(((replace(own, right=tree_of(value)),),))
            start = claims.judge.write(_PUT, [bound, *refs], put) if refs else bound
            known = claims.worths.known_in(value)
            last = start and claims.judge.write((Move("compare"),), [start, *known], relation)
        if last:
            return last
        claims.worths.back(mark)
    return None


def _by_tangent(claims: Claims, asked: Link) -> Link:
    """The bound of an angle as an inverse tangent, but for one in whole degrees."""
    if not isinstance(asked.left, Quantity) or asked.left.kind not in ANGLES:
        return asked
    angle = claims.worths.value(asked.right)
    tangent = tidy(sp.tan(angle))
    if sp.deg(angle).is_Rational or claims.scene.model.sign(tangent) <= 0:
        return asked
    return replace(asked, right=Apply("arctan", tree_of(tangent)))


def _subjects(claims: Claims, asked: Expression) -> Iterator[tuple[Expression, tuple[Ref, ...]]]:
    """What is bounded, as it is asked and by the letter for its angle, with what introduces it."""
    yield asked, ()
    angle = asked.argument if isinstance(asked, Apply) else asked
    for line in claims.scene.desk.lines:
        if isinstance(line.relation, Meaning) and line.relation.quantity == angle:
            letter = Letter(line.relation.letter)
            named = Apply(asked.function, letter) if isinstance(asked, Apply) else letter
            yield named, (line.number,)


def _bound(claims: Claims, line: Line) -> Link | None:
    """What a printed line of another part says that is in force, if it has one link."""
    desk = claims.scene.desk
    if not isinstance(line.relation, Relation) or len(line.relation.options) != 1:
        return None
    if len(line.relation.only) != 1 or desk.is_of_this_part(line.number):
        return None
    if line.move.id == "answer" or line.shown == "silent" or not desk.holds(line.number):
        return None
    return line.relation.only[0]


def _with_values(claims: Claims, tree: Expression) -> tuple[Any, tuple[Ref, ...]]:
    """An expression with the values that its letters have in this part, and what gives them."""
    value = claims.worths.value(tree)
    final = claims.scene.model.final
    claims.solver.determine(sorted(value.free_symbols & final.keys(), key=str))
    put, refs = claims.scene.put(value)
    return tidy(put), refs


def _put(claims: Claims, line: Line, end: Link, lets: tuple[Ref, ...]) -> int | None:
    """A bound with the values put in, as it is asked; None where it is another."""
    link = claims.scene.desk.last_link(line.number)
    value, refs = _with_values(claims, link.right)
    if not refs or tidy(value - claims.worths.value(end.right)) != 0:
        return None
    own = Relation(((replace(link, right=end.right),),))
    number = claims.judge.write(_PUT, [line.number, *refs], own)
    if number is None or link.left == end.left:
        return number
    return claims.judge.write(_NAMED, [number, *lets], Relation(((end,),)), shown="silent")


def _put_below(claims: Claims, line: Line, end: Link, lets: tuple[Ref, ...]) -> int | None:
    """The bound of an angle, from that of its tangent with the values put in."""
    tangent = end.right.argument if isinstance(end.right, Apply) else end.right
    pool: list[Ref] = []
    for ref in line.premises:
        own = claims.scene.desk.line(ref) if isinstance(ref, int) else None
        link = None if own is None else _bound(claims, own)
        if own is None or link is None or link.sign != end.sign:
            pool.append(ref)
            continue
        put = _put(claims, own, replace(link, right=tangent), ())
        if put is None:
            return None
        pool.append(put)
    return claims.judge.write((Move("compare"),), [*pool, *lets], Relation(((end,),)))


def _place(claims: Claims, bound: Line) -> int | None:
    """The line that says what the value is where the bound is reached, with the values put in."""
    desk = claims.scene.desk
    for line in reversed(desk.lines):
        own = line.relation
        if not isinstance(own, Relation) or len(own.options) != 2 or not desk.holds(line.number):
            continue
        unless, value = own.options[0][0], own.options[1][0]
        if unless.sign != "!=" or desk.line(line.number).item != bound.item:
            continue
        place, refs = _with_values(claims, unless.right)
        reached, more = _with_values(claims, value.right)
        links = (
            Link(unless.left, "!=", tree_of(place)),
            Link(value.left, "=", tree_of(reached)),
        )
        relation = Relation(tuple((link,) for link in links))
        pool = [*line.premises, *refs, *more]
        needed = claims.judge.needed(Move("put"), pool, relation)
        if needed is not None:
            return desk.write(Move("put"), needed, relation, "silent")
    return None


__all__ = ["write_bound_again", "write_by_a_bound_above"]
