"""Identities of sines, cosines and tangents."""

from __future__ import annotations

from collections.abc import Iterator

from restitution.explaining.lines.angles import Identity
from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.quotients import NotComparableError, Quotient
from restitution.explaining.lines.trees import rebuilt
from restitution.explaining.moves.angles import RATIOS
from restitution.explaining.moves.bases import (
    IDENTITIES,
    base_of,
    expected_residual,
    from_base,
    others_cited,
)
from restitution.explaining.moves.putting import by_values, is_root_of, matches_with
from restitution.explaining.steps.rules import Rules
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
)


def is_identity(step: Step, line: Link) -> bool:
    """Whether a line is its base, rewritten by an identity or an instance of it."""
    names = IDENTITIES.get(step.move.record or "")
    if names is not None and _is_instance(step, line, names):
        return True
    step = from_base(step)
    base = base_of(step)
    if names is None or base is None or len(base.options) != 1:
        return False
    if by_values(step, line, base):
        return False  # no identity is used
    chosen = step.under(identities=names)
    trees = [t for link in (line, *base.only) for t in (link.left, link.right)]
    chosen.world.divide_angles([*trees, *(let.quantity for let in step.lets)])
    # Where tan ½α is t, its cosine and sine are known by t: c² = 1/(1 + t²).
    rules = chosen.rules(others_cited(step))
    rules.complete()
    return any(
        _of_angle(chosen, line, link, rules)
        if chosen.world.is_angle(link.left)
        else is_root_of(chosen, line, link)
        or matches_with(chosen, line, expected_residual(chosen, link, rules), rules, link.sign)
        for link in (*base.only, *_parts_of_sums(base))
    )


def _parts_of_sums(base: Relation) -> Iterator[Link]:
    """Each part of a sum of two angles by the other: β = 90° − α where α + β = 90°."""
    for link in base.only:
        match link:
            case Link(Binary("+", one, other), "=", whole):
                yield Link(one, "=", Binary("-", whole, other))
                yield Link(other, "=", Binary("-", whole, one))


def _is_instance(step: Step, line: Link, names: frozenset[Identity]) -> bool:
    """Whether a line is the identity itself, for its angles, or for what letters stand for."""
    if line.sign != "=":
        return False
    named: dict[Expression, Expression] = {
        Letter(let.letter): let.quantity for let in step.lets if isinstance(let.quantity, Binary)
    }
    left, right = (
        rebuilt(side, lambda own: named.get(own, own)) for side in (line.left, line.right)
    )
    line = Link(left, "=", right)
    chosen = step.under(cited=(), known=(), identities=names)
    chosen.world.divide_angles([line.left, line.right])
    own, plain = chosen.residual(line), step.under(cited=(), known=()).residual(line)
    return (
        isinstance(own, Quotient)
        and isinstance(plain, Quotient)
        and own.vanishes
        and not plain.vanishes
    )


def _of_angle(step: Step, line: Link, base: Link, rules: Rules) -> bool:
    """Whether a line is what an identity makes of a ratio of two angles that are equal."""
    for function in (*RATIOS, "cot"):
        ratios = Link(Apply(function, base.left), base.sign, Apply(function, base.right))
        try:
            expected = expected_residual(step, ratios, rules)
            if base.sign == "=" and matches_with(step, line, expected, rules, "="):
                return True
        except NotComparableError:
            continue
    return False
