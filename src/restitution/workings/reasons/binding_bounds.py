"""Bounds of letters that were found, where a condition is just that: *e ≤ 1*, *α is acute*."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from collections.abc import Set as AbstractSet

import sympy as sp

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.explaining.lines.saying import Sentence, say
from restitution.oracle import All, BeyondError, Formula, Oracle
from restitution.oracle import Relation as Claim
from restitution.oracle.roles import ACUTE
from restitution.planning.writing.forms import tree_of
from restitution.render import layout as lay
from restitution.render.layout import Layout

Bound = tuple[Formula, tuple[sp.Symbol, str]]
"""A claim of a letter that was found, and of which end or angle it is one."""


def reasons_that_bind(
    model: Model, unknowns: AbstractSet[sp.Symbol], above: AbstractSet[sp.Symbol]
) -> tuple[Sentence | Layout, ...]:
    """``e ≤ 1``, *α is acute*: what letters that were found may be, if a condition is just that.

    A coefficient that is not among those ``above`` has its value with it. Where the condition is
    that of a value without a divisor that is zero, it is that; and empty where it rests on anything
    else, or on another letter that no line tells.
    """
    if model.branch.oracle is None:
        return ()
    ends = list(_ends(model))
    angles = [end for end in ends if end[1][1] != "positive"]
    groups = (angles, _divisors(model), ends, _squares(model), motions(model))
    for bounds in map(list, groups):
        needed = _enough(model, bounds)
        if needed and all(
            end in ("moving", "low", "high") or e in unknowns for _, (e, end) in needed
        ):
            return _in_words(model, needed, above)
    return ()


def _enough(model: Model, bounds: Sequence[Bound]) -> list[Bound]:
    """Those bounds without which the solution is not one; none where they are not enough."""
    # A sphere that is at rest at the end gives no bound by its motion.
    held = [bound for bound in bounds if follows(model.oracle, bound[0])]
    needed = [entry for entry in held if not follows(model.ground, entry[0])]
    for bound in list(needed):
        fewer = [entry for entry in needed if entry is not bound]
        if _is_enough(model, fewer):
            needed = fewer
    return needed if _is_enough(model, needed) else []


def _is_enough(model: Model, bounds: Sequence[Bound]) -> bool:
    oracle = model.ground.with_facts([claim for claim, _ in bounds])
    return all(follows(oracle, fact) for fact in model.oracle.facts)


def _ends(model: Model) -> Iterator[Bound]:
    """What the letters that were found may be."""
    for symbol, value in model.final.items():
        role = model.unknowns.roles.get(symbol.name)
        if role is None:
            continue
        if role.kind == "restitution" and (role.low, role.high) == (0, 1):
            for end, gap in (("low", value), ("high", 1 - value)):
                closed = role.closed[end == "high"]
                yield Claim(gap, ">=" if closed else ">"), (symbol, end)
        elif role == ACUTE:
            ratios = (Claim(tidy(ratio(value)), ">") for ratio in (sp.sin, sp.cos))
            yield All(tuple(ratios)), (symbol, "acute")
        elif role.kind == "positive":
            yield Claim(value, ">"), (symbol, "positive")


def _divisors(model: Model) -> Iterator[Bound]:
    """That no value of a letter of the statement has a divisor that is zero."""
    for symbol, value in model.final.items():
        divisor = sp.fraction(sp.together(value))[1]
        if symbol.name in model.unknowns.roles and isinstance(divisor, sp.Symbol):
            yield Claim(divisor, "!="), (symbol, "divisor")


def _squares(model: Model) -> Iterator[Bound]:
    """That the squares of letters that are roots are not negative."""
    for symbol, value in model.final.items():
        square = tidy(value**2)
        roots_ = [power for power in square.atoms(sp.Pow) if not power.exp.is_integer]
        if symbol.name in model.unknowns.roles and not roots_:
            yield Claim(square, ">="), (symbol, "square")


def motions(model: Model) -> Iterator[Bound]:
    """That a sphere still moves at the end."""
    story = model.branch.story
    for body in story.spheres:
        velocity = story.velocity(body, len(story.happenings))
        square = tidy(model.in_data(velocity.dot(velocity)))
        yield Claim(square, ">"), (sp.Symbol(body), "moving")


def _in_words(
    model: Model, bounds: Sequence[Bound], above: AbstractSet[sp.Symbol]
) -> tuple[Sentence | Layout, ...]:
    """Bounds as reasons, both ends of a coefficient at once."""
    ends: dict[sp.Symbol, set[str]] = {}
    for _, (symbol, end) in bounds:
        ends.setdefault(symbol, set()).add(end)
    return tuple(_reason(model, symbol, own, symbol in above) for symbol, own in ends.items())


def _reason(
    model: Model, symbol: sp.Symbol, ends: Collection[str], is_above: bool
) -> Sentence | Layout:
    name, zero, one = lay.from_sympy(symbol), lay.Number("0"), lay.Number("1")
    if "acute" in ends:
        return say("derived.acute", angle=name)
    if "divisor" in ends:
        above, below = sp.fraction(sp.together(model.final[symbol]))
        divisor = lay.from_sympy(below)
        if model.proved_sign(above.subs(below, 0)):
            none = lay.Relation((divisor, zero), ("=",))
            return say("answer.no-value", place=none, letter=name)
        return say("answer.divisor", divisor=divisor)
    if "moving" in ends:
        return say("answer.moving", body=symbol.name)
    if "square" in ends:
        return lay.Relation((lay.from_sympy(symbol**2), zero), ("≥",))
    if "positive" in ends:
        return lay.Relation((name, zero), (">",))
    at_low, at_high = (
        "≤" if closed else "<" for closed in model.unknowns.roles[symbol.name].closed
    )
    value = () if is_above else (lay.from_tree(tree_of(model.final[symbol])),)
    equal = ("=",) if value else ()
    if "high" not in ends:
        return lay.Relation((name, *value, zero), (*equal, "≥" if at_low == "≤" else ">"))
    if "low" not in ends:
        return lay.Relation((name, *value, one), (*equal, at_high))
    return lay.Relation((zero, name, *value, one), (at_low, *equal, at_high))


def follows(oracle: Oracle, claim: Formula) -> bool:
    """Whether a claim is proved; no claim that the oracle cannot read is."""
    try:
        return bool(oracle.decide(claim))
    except BeyondError:
        return False
