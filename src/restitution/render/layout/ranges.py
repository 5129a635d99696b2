"""Sets of numbers laid out as ranges."""

from __future__ import annotations

from typing import Any

import sympy
from sympy import Expr, S

from restitution import exact
from restitution.render.layout.algebra import from_sympy
from restitution.render.layout.nodes import Layout, Phrase, Relation, Words
from restitution.render.layout.sides import as_layout


def from_set(values: Any, name: Any, *, degrees: bool = False) -> Layout:
    """A set of numbers as a statement about a letter: ``⅓ < e ≤ 1``, ``e = 0 or e > ½``.

    ``name`` is the letter or the quantity, as a layout, a SymPy expression or a tree.
    """
    subject = as_layout(name)

    def end(value: Any) -> Layout:
        return from_sympy(value, degrees=degrees)

    if isinstance(values, sympy.Interval):
        low, high = values.start, values.end
        before = "<" if values.left_open else "≤"
        after = "<" if values.right_open else "≤"
        if low is S.NegativeInfinity and high is S.Infinity:
            return Phrase((Words("all real"), subject))
        if low is S.NegativeInfinity:
            return Relation((subject, end(high)), (after,))
        if high is S.Infinity:
            return Relation((subject, end(low)), (">" if values.left_open else "≥",))
        return Relation((end(low), subject, end(high)), (before, after))
    if isinstance(values, sympy.FiniteSet):
        ordered = sorted(values.args, key=_set_order)
        cases = [Relation((subject, end(value)), ("=",)) for value in ordered]
        return cases[0] if len(cases) == 1 else Phrase(tuple(cases), " or ")
    if isinstance(values, sympy.Union):
        return _from_union(values, subject, degrees)
    if isinstance(values, sympy.Complement) and isinstance(values.args[1], sympy.FiniteSet):
        whole, holes = values.args
        missing = [Relation((subject, end(argument)), ("≠",)) for argument in holes.args]
        return Phrase((from_set(whole, subject, degrees=degrees), *missing), ", ")
    if values is S.EmptySet:
        return Phrase((Words("no"), subject))
    if values is S.Reals:
        return Phrase((Words("all real"), subject))
    return Relation((subject, Words(str(values))), ("∈",))


def _from_union(values: Any, subject: Layout, degrees: bool) -> Layout:
    """Parts in order; intervals that leave out one point between them are told with ≠."""
    parts = sorted(values.args, key=lambda argument: _set_order(argument.inf))
    merged: list[tuple[Any, list[Any]]] = []
    for part in parts:
        last = merged[-1] if merged else None
        if (
            last is not None
            and isinstance(part, sympy.Interval)
            and isinstance(last[0], sympy.Interval)
            and last[0].end == part.start
        ):
            whole = sympy.Interval(last[0].start, part.end, last[0].left_open, part.right_open)
            merged[-1] = (whole, [*last[1], part.start])
        else:
            merged.append((part, []))
    cases: list[Layout] = []
    for part, holes in merged:
        case = from_set(part, subject, degrees=degrees)
        if holes:
            missing = [
                Relation((subject, from_sympy(hole, degrees=degrees)), ("≠",)) for hole in holes
            ]
            case = Phrase((case, *missing), ", ")
        cases.append(case)
    return cases[0] if len(cases) == 1 else Phrase(tuple(cases), " or ")


def _set_order(value: Any) -> float:
    if value is S.NegativeInfinity:
        return float("-inf")
    if isinstance(value, Expr) and len(value.free_symbols) == 1:
        (letter,) = value.free_symbols
        size = value / letter
        # Multiples of a positive letter are in the order of their numbers.
        value = size if letter.is_positive and not size.free_symbols else value
    number = exact.decimal(value) if isinstance(value, Expr) else None
    return number if number is not None else 0.0
