"""Angles of more than 90°, or of less, by the sign of a tangent that an earlier item has.

From ``tan δ = (1 + e) tan α/(1 − e tan² α)`` and δ > 90° it is ``1 − e tan² α < 0``: no velocity is
put together again.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from restitution.components.verdicts import proved_sign
from restitution.explaining.lines.derivation import FLIPPED, Fact, Link, Move, Relation, Sign
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    letters,
)
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.inequalities.angles_bounded import Bounded
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import ZERO
from restitution.planning.writing.inequalities import without_signs
from restitution.planning.writing.polynomials import expanded


def write_by_a_tangent(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    """The sign of what stands below in the tangent of an angle; None where no item has that."""
    if link.sign not in ("<", ">"):
        return None
    mark = worths.mark()
    for number, subject in _tangents(worths, angle):
        line = worths.tangent_closed(number)
        own = worths.scene.desk.last_link(line)
        match own.right:
            case Binary("/", above, below):
                bounded = _below(worths, fact, link, (line, subject), above, below)
                if bounded is not None:
                    return bounded
        worths.back(mark)
    return None


def _tangents(worths: Worths, angle: Quantity) -> Iterator[tuple[int, Expression]]:
    """The ends of items that give the tangent of an angle: with the angle, or the letter for it."""
    desk = worths.scene.desk
    named = letter_known(worths.scene, angle)
    subjects = (angle,) if named is None else (angle, Letter(named[0]))
    for end in reversed(desk.ends):
        if not desk.holds(end.line) or len(desk.relation(end.line).options) > 1:
            continue
        own = desk.last_link(end.line)
        for subject in subjects:
            if own.left == Apply("tan", subject) and own.sign == "=":
                yield end.line, subject


_OR_ZERO: Mapping[Sign, Sign] = {"<": "<=", ">": ">="}


def _below(
    worths: Worths,
    fact: Fact,
    link: Link,
    tangent: tuple[int, Expression],
    above: Expression,
    below: Expression,
) -> Bounded | None:
    """The sign of one side of a quotient, by those of the other side and of the tangent."""
    scene, judge = worths.scene, worths.judge
    if proved_sign(scene.model.inside, worths.value(above)) != 1:
        return None
    sign = FLIPPED[link.sign]
    x = worths.value(below)
    stripped = without_signs(scene, expanded(x), sign)
    if stripped is None:
        return None
    line, letter, extent = worths.lettered(*tangent)
    known = judge.known(letters(above) | letters(below))
    signed = Relation(((Link(Apply("tan", letter), _OR_ZERO[sign], ZERO),),))
    first = judge.write((Move("compare"),), [fact.id, *extent], signed)
    if first is None:
        return None
    compared = Relation(((Link(below, sign, ZERO),),))
    number = judge.write((Move("compare"),), [first, line, *known], compared)
    return None if number is None else (number, *stripped)


__all__ = ["write_by_a_tangent"]
