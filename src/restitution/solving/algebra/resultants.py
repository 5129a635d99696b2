"""Resultants of polynomials, by minors of their Sylvester matrix."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.solving.algebra.polynomials import (
    WORD,
    Element,
    Field,
    afford,
    bits,
    field_coefficients,
    from_powers,
    without_denominators,
)
from restitution.work import remembered

MOST_COLUMNS = 12


@remembered(256)
def resultant(f: sp.Expr, g: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The resultant of two polynomials with respect to a letter, multiplied out."""
    field = Field([f, g], [symbol])
    a, b = field_coefficients(field, f, symbol), field_coefficients(field, g, symbol)
    m, n = len(a) - 1, len(b) - 1
    if m < 0 or n < 0:
        return sp.S.Zero
    afford(_eliminating(field, a, b))
    if any(r.power > 1 for r in field.relations) and m + n <= MOST_COLUMNS:
        result = _determinant(field, _sylvester(a, b, field.ring.zero))
    elif m == 0 or n == 0:
        result = field.power(a[0], n) if m == 0 else field.power(b[0], m)
    else:
        one, other = (without_denominators(from_powers(polynomial)) for polynomial in (a, b))
        result = field.normal(one.resultant(other).set_ring(field.ring))
    return field.expression(without_denominators(_primitive(result)))


def _primitive(a: Element) -> Element:
    return a.primitive()[1] if a != 0 else a


def _eliminating(field: Field, a: Sequence[Element], b: Sequence[Element]) -> float:
    """An estimate of the operations of a resultant: the terms it may have, and their size."""
    m, n = len(a) - 1, len(b) - 1
    reduced = {r.index: r.power - 1 for r in field.relations}
    terms = 1.0
    for index in range(1, len(field.atoms)):
        top = [
            max((mono[index] for part in polynomial for mono in part), default=0)
            for polynomial in (a, b)
        ]
        grown = n * top[0] + m * top[1]
        terms *= 1 + min(grown, reduced.get(index, grown))
    size = n * max(map(bits, a)) + m * max(map(bits, b))
    given = max(len(part) for part in (*a, *b))
    return terms * given * (m + n) ** 2 * (1 + size / WORD) / 16


def _sylvester(a: Sequence[Element], b: Sequence[Element], zero: Element) -> list[list[Element]]:
    m, n = len(a) - 1, len(b) - 1
    return [
        *[[zero] * k + list(a) + [zero] * (n - 1 - k) for k in range(n)],
        *[[zero] * k + list(b) + [zero] * (m - 1 - k) for k in range(m)],
    ]


def _determinant(field: Field, rows: Sequence[Sequence[Element]]) -> Element:
    """The determinant by minors of the first rows: without division, so that relations hold."""
    minors: dict[int, Element] = {0: field.ring.one}
    for row in rows:
        deeper: dict[int, Element] = {}
        for columns, minor in minors.items():
            for column, entry in enumerate(row):
                if entry == 0 or columns >> column & 1:
                    continue
                term = field.times(minor, entry)
                if (columns >> column).bit_count() % 2:
                    term = -term
                key = columns | 1 << column
                deeper[key] = deeper[key] + term if key in deeper else term
        minors = {key: value for key, value in deeper.items() if value != 0}
    return minors.get((1 << len(rows)) - 1, field.ring.zero)
