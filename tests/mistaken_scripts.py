"""Scripts with one law altered as a student types it: data put in, and no letter declared.

The components before stand as their values (``3 × 4``, ``m u cos α``), those after as two letters
that many use; a sense may be turned. Below stand the values to which the equations lead.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from random import Random

import numpy as np
import sympy as sp
from altered_scripts import AlteredScript, _Impact, _quantities, _text, impacts, only_values
from handwriting import Hand

from restitution.explaining.lines.trees import exchanged
from restitution.explaining.mistakes.misconceptions import LawAt, VariantAt, laws_at
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Polar,
    Quantity,
    rational,
    walk,
)
from restitution.expression.writing import write_expression

PAIRS = (("v", "w"), ("x", "y"), ("a", "b"), ("p", "q"), ("v_1", "v_2"), ("V", "W"), ("s", "t"))
MOST_LAWS = 2
_OF_SIGNS = ("momentum-sign", "restitution-sign")


def mistaken_scripts(
    statement: str, random: Random, hand: Hand | None = None
) -> Iterator[AlteredScript]:
    """One script for each first impact of a question and each variant that alters a law of it."""
    for impact in impacts(statement):
        if impact.event.number > 1:
            continue
        for variant in impact.variants():
            if variant.mistake in _OF_SIGNS and "after" in variant.alteration.words:
                continue  # it turns the sense of a letter, and no sign is wrong
            script = _script(impact, variant, random, hand)
            if script is not None:
                yield script


def _script(
    impact: _Impact, variant: VariantAt, random: Random, hand: Hand | None
) -> AlteredScript | None:
    put = _values(impact, variant, random)
    if put is None:
        return None
    laws = [law for law in laws_at(impact.event) if law.law != "unchanged" or impact.event.wall]
    altered = [impact._replaced(law, variant) for law in laws]
    wrong = tuple(n for n, law in enumerate(altered, 1) if not impact.holds(law))
    if len(wrong) != 1 or len(altered) > MOST_LAWS:
        return None
    sides = [tuple(exchanged(side, put) for side in law.sides) for law in altered]
    if any(isinstance(node, Quantity) for pair in sides for side in pair for node in walk(side)):
        return None
    typed = [f"{write_expression(left)} = {write_expression(right)}" for left, right in sides]
    typed += _ends(sides, put)
    if hand is not None:
        records = [law.law for law in altered] + [""] * MOST_LAWS
        typed = [hand.line(text, record, random) for text, record in zip(typed, records)]
    own = laws.index(next(law for n, law in enumerate(laws, 1) if n in wrong))
    names = frozenset(
        each.mistake
        for each in impact.variants()
        if _is_alike(impact, each, altered[own], laws[own])
    )
    if impact.event.wall and "speed-for-component" in names:
        names |= {"restitution-whole-speed"}
    return AlteredScript(impact.statement, impact.part, variant.id, {}, tuple(typed), wrong, names)


def _is_alike(impact: _Impact, other: VariantAt, altered: LawAt, law: LawAt) -> bool:
    """Whether a variant has the same altered law, by numbers."""
    own = impact._replaced(law, other)
    if own.relation == law.relation:
        return False
    a, b = (impact.world.scalar(Binary("-", *each.sides)) for each in (own, altered))
    return bool(np.allclose(np.abs(a), np.abs(b), rtol=1e-6, atol=1e-9))


def _values(
    impact: _Impact, variant: VariantAt, random: Random
) -> dict[Expression, Expression] | None:
    """What a student has for each quantity of the laws: a value before, a letter after."""
    taken = {node for node in impact.statement if node.isalpha()}
    pairs = [pair for pair in PAIRS if not set(pair) & taken]
    if not pairs:
        return None
    letters = iter(random.choice(pairs))
    put: dict[Expression, Expression] = {}
    for law in (*laws_at(impact.event), *variant.laws):
        for quantity in _quantities(law):
            if quantity in put:
                continue
            given = impact._given(quantity)
            value = given if given is not None else _value(impact, quantity)
            if value is None and _is_after(impact, quantity):
                if quantity.kind != "along":
                    continue  # what stays has no letter
                name = next(letters, None)
                if name is None:
                    return None
                value = Letter(name)
                if random.random() < 0.2:
                    value = Negate(value)
            if value is None:
                return None
            put[quantity] = value
    return put


def _is_after(impact: _Impact, quantity: Quantity) -> bool:
    stages = {getattr(node, "stage", None) for node in walk(quantity)} - {None}
    return impact.event.number in stages and 0 not in stages


def _value(impact: _Impact, quantity: Quantity) -> Expression | None:
    """The value of a component before, as data give it."""
    if _is_after(impact, quantity):
        return None
    number = impact._number(quantity)
    if number is not None:
        return rational(number) if number >= 0 else Negate(rational(-number))
    own = impact.world.scalar(quantity)
    for sphere in impact.world.problem.spheres:
        if not isinstance(sphere.velocity, Polar):
            continue
        size, angle = sphere.velocity.size, sphere.velocity.angle
        forms = (*(Binary("*", size, Apply(f, angle)) for f in ("cos", "sin")), size)
        for form in forms:
            value = impact.world.scalar(form)
            for sense, tree in ((1, form), (-1, Negate(form))):
                if np.allclose(own, sense * value, rtol=1e-9):
                    return tree
    return None


def _ends(sides: Sequence[tuple[Expression, ...]], put: dict[Expression, Expression]) -> list[str]:
    """The values of the letters to which the equations lead."""
    functions: dict[Expression, Expression] = {}
    for pair in sides:
        for side in pair:
            for node in walk(side):
                if isinstance(node, Apply):
                    functions.setdefault(node, Letter(f"f{len(functions)}"))
    names = {
        node.name
        for tree in put.values()
        for node in walk(tree)
        if isinstance(node, Letter) and any(node.name in pair for pair in PAIRS)
    }
    symbols = [sp.Symbol(name) for name in sorted(names)]
    equations = [(exchanged(left, functions), exchanged(right, functions)) for left, right in sides]
    values = only_values(equations, symbols)
    if values is None:
        return []
    ends = []
    for symbol, value in zip(symbols, values, strict=True):
        text = _text(value)
        for function, letter in functions.items():
            text = text.replace(letter.name, write_expression(function))  # type: ignore[union-attr]
        ends.append(f"{symbol} = {text}")
    return ends
