"""The values of several quantities, put into the equation between them that is to be shown."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, MoveId, Ref, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Number,
    Quantity,
    has_quantity,
    is_function,
    letters,
    walk,
)
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import alike, square, swept, tree_of
from restitution.planning.writing.judging import Judge
from restitution.planning.writing.scene import Scene

_BY: tuple[MoveId, ...] = ("rearrange", "identity")


def with_values(
    worths: Worths, link: Link, quantities: Sequence[Quantity], lines: Sequence[int], last: int
) -> int:
    """The line of a printed result, in which the values are seen before it: *v² sin²φ + v² cos²φ*.

    ``lines`` are those of the quantities, ``last`` the one that goes from them to the result at
    once; it is written anew. What is no such line stays, and the number of it is returned.
    """
    desk, judge = worths.scene.desk, worths.judge
    own = desk.line(last)
    if last != len(desk.lines) or own.relation != Relation(((link,),)):
        return last
    if link.sign != "=":
        return last
    if has_quantity(worths.opened(link.right)):
        return _with_the_other(worths, link, quantities, lines, last)
    values = _values(worths, quantities, lines)
    put = swept(exchanged(worths.opened(link.left), values))
    if len(values) < 2 or has_quantity(put) or isinstance(put, Letter | Number):
        return last
    moves = (own.move,) if own.move.id == "square-add" else (Move("rearrange"), Move("put"))
    pool = (*own.premises, *worths.judge.known(letters(put) | letters(link.right)))
    for move in moves:
        for by in _BY if own.move.id in ("rearrange", "put") else _BY[::-1]:
            step = replace(move, record=own.move.record) if by == "identity" else move
            relation = chain(link.left, (put, None), (link.right, by))
            if len(relation.only) == 1:
                return last
            refs = judge.needed(step, pool, relation, lines)
            if refs is not None:
                desk.lines.pop()
                return desk.write(step, refs, relation)
    return last


def _with_the_other(
    worths: Worths, link: Link, quantities: Sequence[Quantity], lines: Sequence[int], last: int
) -> int:
    """The line of one quantity as a multiple of another, which stands there by its value first."""
    desk, judge = worths.scene.desk, worths.judge
    own = desk.line(last)
    values = _values(worths, quantities, lines)
    put = exchanged(worths.opened(link.right), values)
    known = judge.known(letters(put))
    if link.left not in quantities or has_quantity(put) or len(lines) != len(quantities):
        return last
    start = lines[quantities.index(link.left)]
    desk.lines.pop()
    first = judge.write((Move("rearrange"),), (start, *known), chain(link.left, (put, None)))
    pool = (first or start, *(line for line in lines if line != start))
    written = first and judge.write((Move("put"),), pool, Relation(((link,),)))
    if first and written:
        return written
    if first:
        desk.take_last()
    return desk.write(own.move, own.premises, Relation(((link,),)))


def _values(
    worths: Worths, quantities: Sequence[Quantity], lines: Sequence[int]
) -> Mapping[Expression, Expression]:
    """What each quantity is by its line, its square without a root, or the ratio of an angle."""
    values: dict[Expression, Expression] = {}
    for quantity, line in zip(quantities, lines, strict=False):
        own = worths.scene.desk.last_link(line)
        if isinstance(own.left, Apply):
            values[Apply(own.left.function, quantity)] = own.right
            continue
        values[quantity] = own.right
        values[square(quantity)] = _squared(worths, own.right)
    return values


def _squared(worths: Worths, tree: Expression) -> Expression:
    if any(is_function(node, "sqrt") for node in walk(tree)):
        return tree_of(tidy(worths.value(tree) ** 2))
    return square(tree)


def by_numbers(
    claims: Claims, line: int, link: Link, last: Callable[[int], int | None]
) -> int | None:
    """What is to be shown by an equation into which numbers are put first: 1 = (1 + e)/2k.

    ``last`` goes from there to the result. None where the equation says it then, from either side.
    """
    mark = claims.worths.mark()
    put = claims.ties.with_numbers(line)
    number = None
    if put is not None:
        own = claims.scene.desk.last_link(put)
        one, other = (own.left, own.right), (link.left, link.right)
        if not any(all(map(alike, one, pair)) for pair in (other, other[::-1])):
            number = last(put)
    if number is None:
        claims.worths.back(mark)
    return number


def by_values_written_out(
    scene: Scene, judge: Judge, pool: Sequence[Ref], refs: Sequence[Ref], link: Link
) -> int | None:
    """A printed form with e by a line that has 1/k there, if e = 1/k, at the end of the last line.

    None of all else.
    """
    lines = [ref for ref in pool if isinstance(ref, int)]
    if lines != [len(scene.desk.lines)] or not isinstance(link.left, Quantity):
        return None
    own, last = scene.desk.line(lines[0]), scene.desk.last_link(lines[0])
    values: dict[Expression, Expression] = {}
    for name in letters(link.right) - letters(last.right):
        known = scene.desk.known(Letter(name))
        if known is not None and isinstance(known.value, sp.Expr) and known.value.free_symbols:
            values[Letter(name)] = tree_of(known.value)
    between = swept(exchanged(link.right, values))
    if not values or between == last.right or last.left != link.left:
        return None
    links = (*scene.desk.relation(own.number).only, Link(last.right, "=", between, "rearrange"))
    relation = Relation((links,))
    if not judge.follows(own.move, own.premises, relation):
        return None
    scene.desk.rewrite(replace(own, relation=relation))
    number = judge.write((Move("put"),), [*pool, *refs], Relation(((link,),)))
    if number is None:
        scene.desk.rewrite(own)
    return number
