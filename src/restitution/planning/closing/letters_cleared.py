"""A letter, or a tangent, to be shown that stands in an equation more than once: that is multiplied
out first.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    has_quantity,
    letters,
    walk,
)
from restitution.planning.closing.collecting import multiplied_out
from restitution.planning.writing.judging import Judge
from restitution.planning.writing.scene import Scene

_TO_CLEAR = (Move("rearrange"), Move("cancel"))


def written_by_clearing(scene: Scene, judge: Judge, pool: Sequence[Ref], link: Link) -> int | None:
    """The line ``k = 1/(3 - 4e^2)`` of e² = (3k − 1)/(4k), by way of 4ke² = 3k − 1.

    None where the letter stands once in the first line of the ``pool``, or alone.
    """
    match link, pool:
        case Link(subject, "=", right), [int(line), *others] if not has_quantity(right):
            letter = _letter_of(subject)
        case _:
            return None
    if letter is None or letter.name in letters(right):
        return None
    if len(scene.desk.relation(line).options) != 1:
        return None
    own, symbol = scene.desk.last_link(line), scene.model.unknowns.letter(letter.name)
    times = sum(node == letter for side in (own.left, own.right) for node in walk(side))
    if own.sign != "=" or times < 2 or subject in (own.left, own.right) or symbol is None:
        return None
    mark = scene.desk.mark()
    cleared = multiplied_out(scene, line, symbol)
    if cleared != line:
        last = judge.write(_TO_CLEAR, [cleared, *others], Relation(((link,),)))
        if last is not None:
            return last
    scene.desk.back(mark)
    return None


def _letter_of(subject: Expression) -> Letter | None:
    """The letter that a claim is solved for, or the angle of which it is solved for the tangent.

    None of any other side of a claim.
    """
    match subject:
        case Letter() as letter:
            return letter
        case Apply("tan", Letter() as angle):
            return angle
        case Binary("^", base, Number(Fraction(numerator=2, denominator=1))):
            return _letter_of(base)
    return None


__all__ = ["written_by_clearing"]
