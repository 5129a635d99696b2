"""A tangent that takes every positive value: not only is each of its values one of these."""

from __future__ import annotations

from collections.abc import Mapping

import sympy as sp

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Apply, Expression, Letter, letters
from restitution.oracle import Role
from restitution.oracle.roles import ACUTE
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.workings.naming.measured import scalar_worth


def every_positive_value(
    derivation: Derivation, roles: Mapping[str, Role], line: Line
) -> Letter | None:
    """The acute angle by which a tangent that is called positive takes every positive value.

    None of a tangent on which no range rests, and of one whose values are not seen to be all: it
    is a multiple of the tangent of the angle, or of its cotangent, and nothing is given of that.
    """
    match line.move.id, line.relation:
        case "sign", Relation(((Link(Apply("tan"), ">", right),),)) if right == ZERO:
            pass
        case _:
            return None
    if not _is_under_a_range(derivation, line):
        return None
    for ref in line.premises:
        above = derivation.line(ref)
        if above is None or not isinstance(above.relation, Relation):
            continue
        value = above.relation.options[0][-1].right
        for name in sorted(letters(value)):
            free = roles.get(name) == ACUTE and not _is_given(derivation, name)
            if free and _is_multiple(value, name):
                return Letter(name)
    return None


def between_its_ends(
    derivation: Derivation, roles: Mapping[str, Role], line: Line
) -> tuple[Letter, Expression, Expression] | None:
    """The acute angle as which goes through all its values a letter does so between two ends.

    With what it tends to as the angle goes to 0° and to 90°. None where no line has the letter by
    that angle alone, where something is given of the angle, and where the ends are others.
    """
    match line.move.id, line.relation:
        case "compare", Relation(((Link(low, "<", subject), Link(_, "<", high)),)):
            ends = {scalar_worth(low), scalar_worth(high)}
        case _:
            return None
    if not isinstance(subject, Letter) or line.number not in derivation.held:
        return None
    for own in derivation.lines:
        match own.relation:
            case Relation(((Link(left, "="), *_),)) if left == subject:
                value = own.relation.only[-1].right
            case _:
                continue
        names = sorted(letters(value))
        if own.number > line.number or len(names) != 1 or roles.get(names[0]) != ACUTE:
            continue
        is_bound = _is_given(derivation, names[0], _facts_under(derivation, own))
        limits = () if is_bound else _limits(value, names[0])
        if len(limits) == len(ends) and set(limits) == ends:
            first, last = map(tree_of, limits)
            return Letter(names[0]), first, last
    return None


def _limits(value: Expression, name: str) -> tuple[sp.Expr, ...]:
    """What a value by an angle tends to as that goes to 0° and to 90°; nothing without limits."""
    whole = scalar_worth(value)
    if whole is None:
        return ()
    angle = sp.Symbol(name, positive=True)
    try:
        limits = (sp.limit(whole, angle, 0, "+"), sp.limit(whole, angle, sp.pi / 2, "-"))
    except (NotImplementedError, ValueError):
        return ()
    return limits if all(limit.is_number and limit.is_finite for limit in limits) else ()


def _is_under_a_range(derivation: Derivation, line: Line) -> bool:
    """Whether the range of an angle between two ends rests on a line."""
    return any(
        own is not None and line.number in own.premises and len(end.answer.options[0]) == 2
        for end in derivation.items
        for own in (derivation.line(end.line),)
    )


def _facts_under(derivation: Derivation, line: Line) -> frozenset[str]:
    """The facts on which a line rests, by way of others too."""
    pending, facts = [*line.premises], set[str]()
    while pending:
        ref = pending.pop()
        if isinstance(ref, str):
            facts.add(ref)
        elif (own := derivation.line(ref)) is not None:
            pending += own.premises
    return frozenset(facts)


def _is_given(derivation: Derivation, name: str, besides: frozenset[str] = frozenset()) -> bool:
    """Whether a fact other than the data, and some others, bounds a letter or ties it to others."""
    return any(
        fact.kind in ("given", "range", "case")
        and fact.id not in besides
        and any(name in letters(tree) for tree in trees_of(fact.relation))
        for fact in derivation.facts
    )


def _is_multiple(value: Expression, name: str) -> bool:
    """Whether an expression is a factor without a letter times its tangent, or cotangent."""
    whole = scalar_worth(value)
    if whole is None:
        return False
    angle = sp.Symbol(name, positive=True)
    tangent = sp.sin(angle) / sp.cos(angle)
    factors = (sp.cancel(whole / tangent), sp.cancel(whole * tangent))
    return any(angle not in factor.free_symbols for factor in factors)
