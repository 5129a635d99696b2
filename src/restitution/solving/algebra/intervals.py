"""Intervals of values with exact ends, and what several of them have in common."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Sequence

import sympy as sp

from restitution.errors import UnsupportedError
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.oracle import (
    All,
    Formula,
    Relation,
    Some,
    joined,
)
from restitution.records import dataclass
from restitution.solving.algebra import forms
from restitution.solving.algebra.numbers import Sample, at

INFINITE = 10**1000


@dataclass(frozen=True)
class End:
    """One end of an interval, exact, and whether it belongs to it."""

    value: sp.Expr
    closed: bool


Piece = tuple[End, End]
Pick = Callable[[Iterable[Enclosed]], Enclosed]


def inside_of(x: sp.Expr, pieces: Sequence[Piece]) -> Formula:
    """The claim that a value lies in one of some intervals."""
    parts: list[Formula] = []
    for low, high in pieces:
        if low.value == high.value:
            parts.append(Relation(x - low.value, "="))
            continue
        ends: list[Formula] = []
        if low.value != -sp.oo:
            ends.append(Relation(x - low.value, ">=" if low.closed else ">"))
        if high.value != sp.oo:
            ends.append(Relation(high.value - x, ">=" if high.closed else ">"))
        parts.append(All(tuple(ends)))
    return parts[0] if len(parts) == 1 else Some(tuple(parts))


def existence(values: Iterable[sp.Expr]) -> list[Relation]:
    """That no divisor in some values is zero, and that no root is that of less than zero."""
    demands: list[Relation] = []
    for power in {power for value in values for power in value.atoms(sp.Pow)}:
        inside, exponent = power.as_base_exp()
        if not inside.free_symbols or not exponent.is_Rational:
            continue
        if exponent < 0 or not exponent.is_Integer:
            demands.append(
                Relation(inside, ">=" if exponent > 0 else "!=" if exponent.is_Integer else ">")
            )
    return sorted(demands, key=lambda demand: sp.default_sort_key(demand.value))


def with_existence(claim: Formula, pieces: Sequence[Piece]) -> Formula:
    """A claim of some intervals together with that their ends have values.

    Where one has none, the claim alone would say nothing.
    """
    ends = [end.value for piece in pieces for end in piece]
    return joined((claim, *existence(ends)))


def joined_cells(cells: list[tuple[sp.Expr | None, bool]]) -> list[Piece]:
    """Alternating gaps and points, true or false, as intervals."""
    pieces: list[Piece] = []
    start: End | None = None
    for index, (point, inside) in enumerate(cells):
        if point is None:  # a gap between points
            if inside and start is None:
                before = cells[index - 1][0] if index else None
                start = End(-sp.oo if before is None else before, False)
            continue
        if inside:
            if start is None:
                start = End(point, True)
            after = cells[index + 1][1] if index + 1 < len(cells) else False
            if not after:
                pieces.append((start, End(point, True)))
                start = None
        elif start is not None:
            pieces.append((start, End(point, False)))
            start = None
    if start is not None:
        pieces.append((start, End(sp.oo, False)))
    return pieces


def reconcile(shapes: list[tuple[list[Piece], Sample]]) -> list[Piece]:
    """One form for all the trials; ends that change places become the larger or the smaller."""
    counts = Counter(tuple(pieces) for pieces, _ in shapes)
    if len(counts) == 1:
        return shapes[0][0]
    sizes = {len(pieces) for pieces, _ in shapes}
    if sizes != {1}:
        raise UnsupportedError("the form of the range depends on the values of the data")
    lows = {pieces[0][0] for pieces, _ in shapes}
    highs = {pieces[0][1] for pieces, _ in shapes}
    low = _extreme(lows, [(p[0][0], d) for p, d in shapes], sp.Max, max)
    high = _extreme(highs, [(p[0][1], d) for p, d in shapes], sp.Min, min)
    return [(low, high)]


def _extreme(
    ends: set[End], seen: list[tuple[End, Sample]], form: type[sp.Max | sp.Min], pick: Pick
) -> End:
    if len(ends) == 1:
        return next(iter(ends))
    for end, drawn in seen:
        values = [_end_at(end, drawn) for end in ends]
        if (_end_at(end, drawn) - pick(values)).sign:
            raise UnsupportedError("the form of the range depends on the values of the data")
    return End(form(*[end.value for end in ends]), all(end.closed for end in ends))


def _end_at(end: End, drawn: Sample) -> Enclosed:
    if end.value in (sp.oo, -sp.oo):
        return Enclosed.of(INFINITE if end.value == sp.oo else -INFINITE)
    try:
        return at(end.value, drawn)
    except UndefinedError:
        raise UnsupportedError("the form of the range depends on the values of the data") from None


def same_at(form: Sequence[Piece], pieces: Sequence[Piece], drawn: Sample) -> bool:
    """Whether a form has the same intervals as another, at one point."""
    try:
        return len(form) == len(pieces) and all(
            a.closed == b.closed and (a.value == b.value or _near(a.value, b.value, drawn))
            for one, other in zip(form, pieces, strict=True)
            for a, b in zip(one, other, strict=True)
        )
    except UndefinedError:
        return False


def same_values_at(form: Sequence[Piece], pieces: Sequence[Piece], drawn: Sample) -> bool:
    """Whether the same values lie in the intervals of two forms, at one point."""
    try:
        own, other = ([x for x in parts if not _is_empty(x, drawn)] for parts in (form, pieces))
    except UndefinedError:
        return False
    return same_at(own, other, drawn)


def _near(a: sp.Expr, b: sp.Expr, drawn: Sample) -> bool:
    if a.is_infinite or b.is_infinite:
        return False
    return not (at(a, drawn) - at(b, drawn)).sign


def _is_empty(piece: Piece, drawn: Sample) -> bool:
    """Whether the ends of an interval have changed places."""
    low, high = piece
    if low.value.is_infinite or high.value.is_infinite or low.value == high.value:
        return False
    gap = (at(high.value, drawn) - at(low.value, drawn)).sign
    return gap < 0 or (gap == 0 and not (low.closed and high.closed))


def to_set(pieces: Sequence[Piece]) -> sp.Set:
    """Intervals as one SymPy set, the ends in textbook form."""
    sets = []
    for low, high in pieces:
        a, b = (forms.bound(end.value) for end in (low, high))
        if a == b:
            sets.append(sp.FiniteSet(a))
        else:
            sets.append(sp.Interval(a, b, not low.closed, not high.closed))
    return sp.Union(*sets) if sets else sp.S.EmptySet
