"""A speed put together from two numbers that stand above: ``√(3.464² + 0.334²) u``."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from math import cos, isclose, radians, sin, sqrt

from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    is_binary,
    is_function,
    walk,
)
from restitution.practice.judging.entries import Entry, Meanings
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.script import Claim

_TWO = Number(Fraction(2))
_ROUNDED = 6e-3
"""What a student's own rounding may move a number by."""


def assembled_from(claim: Claim, meanings: Meanings, entries: Sequence[Entry]) -> tuple[int, ...]:
    """The lines of the two numbers that a speed is put together from, of which one is wrong.

    Whatever they are, the speed follows from them: a line of true values has none of its own.
    """
    meant = meanings.get(claim.left.name) if isinstance(claim.left, Letter) else claim.left
    roots = [node for node in walk(claim.right) if is_function(node, "sqrt")]
    if meant is None or claim.sign != "=" or claim.others or len(roots) != 1:
        return ()
    if kind_of(meant) != "speed":
        return ()
    inside = roots[0].argument
    if not is_binary(inside, "+"):
        return ()
    summands = [_entry_of(_root(term), entries) for term in (inside.left, inside.right)]
    own = [entry for entry in summands if entry is not None]
    wrong = {entry.number for entry in entries if not entry.right}
    if len(own) < len(summands) or own[0] is own[1] or wrong.isdisjoint(x.number for x in own):
        return ()
    return tuple(dict.fromkeys(entry.number for entry in own))


def _entry_of(size: float | None, entries: Sequence[Entry]) -> Entry | None:
    """The last line that ends in a number, but for the letters behind it."""
    return next(
        (
            entry
            for entry in reversed(entries)
            if size and (own := _factor(entry.claim.right)) is not None
            if isclose(abs(own), size, rel_tol=_ROUNDED)
        ),
        None,
    )


def _root(term: Expression) -> float | None:
    """The number of which a term is the square, as it stands or worked out."""
    if is_binary(term, "^") and term.right == _TWO:
        return _factor(term.left)
    own = _factor(term)
    return sqrt(own) if own is not None and own > 0 else None


def _factor(tree: Expression) -> float | None:
    """The number before the letters of a product; None of anything else."""
    match tree:
        case Number(value):
            return float(value)
        case Letter(name) if " " not in name:
            return 1.0
        case Negate(operand):
            own = _factor(operand)
            return None if own is None else -own
        case Apply("sqrt", argument):
            own = _factor(argument)
            return sqrt(own) if own is not None and own >= 0 else None
        case Apply("sin" | "cos" as function, Degrees(value) | Number(value)):
            return (sin if function == "sin" else cos)(radians(float(value)))
        case Binary("*" | "/" as op, left, right):
            one, other = _factor(left), _factor(right)
            if one is None or other is None or (op == "/" and not other):
                return None
            return one * other if op == "*" else one / other
    return None
