"""A range that has one form where something in the data is positive, and another where it is not.

What decides may hold several letters of the data, of which none has bounds that exist for all of
the others: √(2 − 5e² sin²α) is an end only where 2 ≥ 5e² sin²α.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from itertools import combinations, islice

import sympy as sp

from restitution.errors import UnsupportedError
from restitution.expression.enclosed import UndefinedError
from restitution.oracle import BeyondError, Formula, Oracle, Point, Proof, Relation, relations
from restitution.records import dataclass
from restitution.solving.algebra.intervals import Piece, existence, reconcile
from restitution.solving.algebra.numbers import Sample, number_of, sample, sign_at
from restitution.solving.ranges.cases import Family, groups_of_ends
from restitution.solving.ranges.zeros import deciding, essential_factors

MOST_TRIED = 8
LONGEST = 250
"""What asks more operations takes long to be decided so often."""

DRAWS = 4
DRAWS_TRIED = 80
ROUNDS = 3


@dataclass(frozen=True)
class HalfForm:
    """The form of a range where a relation between data holds."""

    relation: Relation
    pieces: tuple[Piece, ...]
    proof: Proof


def forms_by_signs(region: Family) -> list[HalfForm]:
    """The forms of a range by the sign of one expression in the data, each proved; else none.

    Where there is one form alone, nothing is possible for the other sign.
    """
    if region.formula is None or _size(region.formula) > LONGEST:
        return []
    for deciding_one in islice(_deciding(region), MOST_TRIED):
        for closed, open_ in ((1, -1), (-1, 1)):
            relations = (
                Relation(closed * deciding_one, ">="),
                Relation(open_ * deciding_one, ">"),
            )
            try:
                halves = [_form(region, relation) for relation in relations]
            except (UnsupportedError, BeyondError, UndefinedError):
                continue
            forms = [half for half in halves if half is not None and half.pieces]
            if None not in halves and forms:
                return forms
    return []


def _size(formula: Formula) -> int:
    return sum(int(sp.count_ops(relation.value)) for relation in relations(formula))


def _deciding(region: Family) -> Iterator[sp.Expr]:
    """What may decide: all that does so whatever varies, roots of ends, and where two ends meet."""
    ends = [end.value for pieces, _ in region.shapes for piece in pieces for end in piece]
    under = [demand.value for demand in existence(ends) if demand.operator != "!="]
    gaps = [a - b for ends in groups_of_ends(region) for a, b in combinations(ends, 2)]
    parts = [part for value in (*region.of_data, *under, *gaps) for part in deciding(value)]
    data = set(region.data())
    seen: dict[sp.Expr, None] = {}
    for value in parts:
        changing = essential_factors(value)
        for factor in (sp.Mul(*changing), *changing):
            names = {symbol.name for symbol in factor.free_symbols}
            is_angle = factor.has(sp.atan, sp.atan2, sp.asin, sp.acos)
            if names <= data and not is_angle and -factor not in seen:
                seen[factor] = None
    # A coefficient alone has its ends among the cases of one letter.
    yield from sorted(
        (factor for factor in seen if len(factor.free_symbols) > 1),
        key=lambda factor: (sp.count_ops(factor), str(factor)),
    )


def _form(region: Family, relation: Relation) -> HalfForm | None:
    """The form where a relation holds, without intervals where nothing is possible; None of none
    that is proved.
    """
    assert region.formula is not None
    possible = Oracle(region.roles, (*region.given, relation, region.formula)).possible
    if possible.answer == "refuted":
        return HalfForm(relation, (), "decision")
    shapes = list(islice(_shapes(region, relation), DRAWS))
    if not shapes and possible.witness is not None:
        drawn = _data_of(region, possible.witness)
        shapes = [(region.pieces_at(drawn), drawn)]
    if not shapes:
        return None
    for _ in range(ROUNDS):
        pieces = reconcile(shapes)
        verdict = region.proved(pieces, (relation,))
        if verdict:
            return HalfForm(relation, tuple(pieces), verdict.proof)
        if verdict.answer != "refuted" or verdict.witness is None:
            return None
        drawn = _data_of(region, verdict.witness)
        shape = region.pieces_at(drawn)
        if not shape:
            return None
        shapes.append((shape, drawn))
    return None


def _data_of(region: Family, witness: Point) -> Sample:
    drawn = sample(region.data(), region.roles, random.Random(19))
    return drawn | {name: number_of(value) for name, value in witness.items() if name in drawn}


def _shapes(region: Family, relation: Relation) -> Iterator[tuple[list[Piece], Sample]]:
    """The intervals at some values of the data for which a relation holds."""
    rng = random.Random(61)
    for number in range(DRAWS_TRIED):
        drawn = sample(region.data(), region.roles, rng, number % 3 == 2)
        if sign_at(relation.value, [drawn]) == 1 and (pieces := region.pieces_at(drawn)):
            yield pieces, drawn
