"""A way by the tangent of the angle of a path, where that is given: 2/tan α in place of sizes.

The sine and the cosine of the angle would be roots that cancel.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Derivation, Line, Link, Move, Ref, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    has_root,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import Oracle
from restitution.planning.writing.forms import ONE, swept
from restitution.planning.writing.lines_in_two import number_above, with_two_for


def with_direct_slopes(derivation: Derivation, oracle: Oracle) -> Derivation:
    """The same working, in which a way is by the tangent that is given of the angle of its path."""
    for line in derivation.lines:
        if (line.move.id, line.move.record) != ("define", "straight-line"):
            continue
        for pair in _by_the_tangent(derivation, line):
            whole = with_two_for(derivation, line, pair, oracle)
            if whole is not None:
                return with_direct_slopes(whole, oracle)
    return derivation


def _by_the_tangent(derivation: Derivation, line: Line) -> Iterator[tuple[Line, Line]]:
    """A line with the tangent in place of the quotient of two speeds with roots, and its value."""
    match line.relation:
        case Relation(((Link(left, "=", right), Link(_, "=", final)),)):
            pass
        case _:
            return
    quotients = [e for e in walk(right) if is_binary(e, "/") and has_root(e)]
    for quotient, (angle, ref, refs) in _pairs(quotients, derivation, line):
        tangent = Apply("tan", angle)
        for ratio in (tangent, Binary("/", ONE, tangent)):
            if not _is_alike(quotient, ratio, derivation, ref):
                continue
            put = swept(exchanged(right, {quotient: ratio}))
            if isinstance(ratio, Binary):
                put = _divided(right, quotient, tangent) or put
            first = Relation(((Link(left, "=", put),),))
            above = replace(line, number=number_above(derivation), relation=first, premises=refs)
            last = Relation(((Link(left, "=", final),),))
            move = Move("put")
            yield above, replace(line, move=move, relation=last, premises=(above.number, ref))


Given = tuple[Letter, Ref, tuple[Ref, ...]]
"""An angle, the fact of its tangent, and the other premises of a line."""


def _pairs(
    quotients: Sequence[Expression], derivation: Derivation, line: Line
) -> Iterator[tuple[Expression, Given]]:
    """Each quotient with the tangent that a line of sine and cosine above it comes from."""
    for number in line.premises:
        own = derivation.line(number)
        if own is None or own.move.id != "triangle":
            continue
        for ref in own.premises:
            cited = derivation.cited(ref)
            match None if cited is None else cited.relation:
                case Relation(((Link(Apply("tan", Letter() as angle), "="), *_),)):
                    refs = tuple(e for e in line.premises if e != number)
                    for quotient in quotients:
                        yield quotient, (angle, ref, refs)


def _is_alike(quotient: Expression, ratio: Expression, derivation: Derivation, ref: Ref) -> bool:
    """Whether a quotient of numbers is a tangent, with the value that is given of it."""
    cited = derivation.cited(ref)
    assert cited is not None
    assert isinstance(cited.relation, Relation)
    tangent, value = cited.relation.only[0].left, cited.relation.only[-1].right
    if letters(value):
        return False
    try:
        put = exchanged(ratio, {tangent: value})
        own, other = (in_letters(e, positive=True) for e in (quotient, put))
    except RestitutionError:
        return False
    return bool(tidy(sp.sympify(own - other, strict=True)) == 0)


def _divided(tree: Expression, quotient: Expression, tangent: Expression) -> Expression | None:
    """``2/tan α`` for 2 times a quotient that is 1/tan α; None of another form."""
    match tree:
        case Binary("*", factor, own) if own == quotient:
            return Binary("/", factor, tangent)
    return None


__all__ = ["with_direct_slopes"]
