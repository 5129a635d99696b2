"""Equations with the square of a sum of roots, which is worked out on a line of its own."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.explaining.following.follower import reader_of
from restitution.explaining.lines.derivation import Case, Derivation, Line, Link, Move, Relation
from restitution.explaining.lines.trees import rebuilt, trees_of
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Binary,
    Expression,
    has_quantity,
    has_root,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.between import is_square
from restitution.planning.writing.forms import number, product, tree_of
from restitution.planning.writing.gathering import numbered_anew
from restitution.planning.writing.polynomials import expanded

_MOVES = ("rearrange", "cancel")


def with_squares_of_surds(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which the square of a sum of roots is worked out before all else.

    Of ((√3 − 1)u)² = ¾e²u² + ¼u² nobody sees e² at once.
    """
    order: list[Line] = []
    cases = derivation.cases
    read = None
    free = max((line.number for line in derivation.lines), default=0)
    for line in derivation.lines:
        links = _worked_out(derivation, line)
        if links is not None:
            free += 1
            between = replace(
                line, number=free, move=Move("rearrange"), relation=Relation((links,)), marks=()
            )
            read = read or reader_of(derivation, oracle)
            if read.accepts(between):
                order.append(between)
                cases = tuple(_with(case, free, before=line.number) for case in cases)
                line = replace(line, premises=(free,))
        order.append(line)
    if len(order) == len(derivation.lines):
        return derivation
    return numbered_anew(replace(derivation, cases=cases), order)


def _with(case: Case, number_: int, *, before: int) -> Case:
    """A case with one line more, where it has the line before which that stands."""
    lines = (n for own in case.lines for n in ((number_, own) if own == before else (own,)))
    return replace(case, lines=tuple(lines))


def _worked_out(derivation: Derivation, line: Line) -> tuple[Link] | None:
    """The equation above a line with its squares worked out, where a sum of roots is squared."""
    if line.move.id not in _MOVES or line.move.record is not None or len(line.premises) != 1:
        return None
    above = next(iter(derivation.lines_in(line.premises)), None)
    if above is None:
        return None
    match above.relation, line.relation:
        case Relation() as equation, Relation() if (link := equation.ends) is not None:
            pass
        case _:
            return None
    sides = (link.left, link.right)
    squares = [node for side in sides for node in walk(side) if is_square(node)]
    kept = {node for tree in trees_of(line.relation) for node in walk(tree)}
    if any(map(has_quantity, sides)) or not any(_is_of_surds(e) and e not in kept for e in squares):
        return None
    if any(map(_is_of_a_sum, squares)):
        return None
    left, right = (rebuilt(side, _squared) for side in sides)
    return (Link(left, link.sign, right),)


def _squared(tree: Expression) -> Expression:
    """A square worked out, with its letters behind a number."""
    if not is_square(tree):
        return tree
    whole = sp.factor_terms(expanded(in_letters(tree)))
    value, rest = whole.as_independent(*whole.free_symbols, as_Add=False)
    value = expanded(value)
    below = sp.ilcm(1, *(term.as_coeff_Mul()[0].q for term in sp.Add.make_args(value)))
    above = product(tree_of(expanded(value * below), as_it_is=True), tree_of(rest))
    return above if below == 1 else Binary("/", above, number(int(below)))


def _is_of_surds(square: Expression) -> bool:
    """Whether a sum of numbers with roots is squared."""
    return any(
        is_binary(node, "+", "-") and has_root(node) and not letters(node) for node in walk(square)
    )


def _is_of_a_sum(square: Expression) -> bool:
    """Whether a sum with letters is squared."""
    return any(is_binary(node, "+", "-") and letters(node) for node in walk(square))


__all__ = ["with_squares_of_surds"]
