"""Facts from which letters are eliminated one by one: linear equations of numbers need no more.

With angles such as 35° the numbers are long, and a decision procedure takes seconds for what a
calculator shows at once.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from functools import lru_cache
from typing import Literal

import sympy as sp

from restitution.oracle.formula import Formula, Relation, conjuncts, letters_of, put_in, relations
from restitution.oracle.points import BeyondError
from restitution.oracle.roles import REAL, Role
from restitution.oracle.scaled import scaled_sign
from restitution.oracle.testers import holds_with

# More letters are not eliminated, and longer facts are not taken up.
_MOST_LETTERS = 12
_MOST_OPERATIONS = 400


def hold_together(
    facts: Sequence[Formula], roles: Mapping[str, Role]
) -> Literal["yes", "no", "unknown"]:
    """Whether facts can hold together, as far as elimination and signs of numbers show it.

    A letter is eliminated by an equation in which it is linear, where what it is multiplied with
    is certain not to be zero.
    """
    left = list(conjuncts(facts))
    if sum(int(sp.count_ops(own.value)) for e in left for own in relations(e)) > _MOST_OPERATIONS:
        return "unknown"
    bounds: list[Formula] = []
    for _ in range(_MOST_LETTERS):
        solved = _solved(left, roles)
        if solved is None:
            break
        equation, symbol, value = solved
        left.remove(equation)
        bounds += _bounds(symbol, roles.get(symbol.name, REAL))
        left = [put_in(formula, {symbol: value}) for formula in left]
        bounds = [put_in(formula, {symbol: value}) for formula in bounds]
    try:
        truths = [_holds(formula, roles) for formula in _without_loose([*left, *bounds], roles)]
    except BeyondError:
        return "unknown"
    if False in truths:
        return "no"
    return "yes" if all(truths) else "unknown"


def bearing_on(
    letters: frozenset[str], facts: Sequence[Formula], roles: Mapping[str, Role]
) -> tuple[Formula, ...]:
    """The facts on which a claim about some letters rests.

    An equation that gives a letter of any value, of which nothing else is known, says nothing of
    the others; nor do facts that have no letter in common with the claim, or with facts that have.
    """
    if not letters:
        return tuple(facts)
    left = {fact: letters_of(fact) for fact in conjuncts(facts)}
    free = {fact: _given_freely(fact, roles) for fact in left}
    counts = Counter(name for names in left.values() for name in names)
    while idle := [f for f in left if any(counts[n] == 1 and n not in letters for n in free[f])]:
        for fact in idle:
            counts.subtract(left.pop(fact))
    near, before = letters, frozenset[str]()
    while near != before:
        before = near
        near = near.union(*(names for names in left.values() if names & near))
    return tuple(fact for fact, names in left.items() if names & near)


@lru_cache(maxsize=4096)
def _free_in(fact: Formula) -> frozenset[sp.Symbol]:
    """The letters of a polynomial equation that stand there once, times a number."""
    if not isinstance(fact, Relation) or fact.operator != "=":
        return frozenset()
    terms = sp.Add.make_args(fact.value)
    symbols = fact.value.free_symbols
    if not fact.value.is_polynomial(*symbols):
        return frozenset()
    alone = (term.as_coeff_Mul()[1] for term in terms)
    return frozenset(x for x in alone if x.is_Symbol and sum(term.has(x) for term in terms) == 1)


def _given_freely(fact: Formula, roles: Mapping[str, Role]) -> frozenset[str]:
    """The letters that may be any number, and that an equation gives by the others."""
    return frozenset(x.name for x in _free_in(fact) if not _is_bounded(x, roles))


def _solved(
    facts: Sequence[Formula], roles: Mapping[str, Role]
) -> tuple[Formula, sp.Symbol, sp.Expr] | None:
    """An equation that gives a letter, the letter, and what it is; None where there is none."""
    for fact in facts:
        if not isinstance(fact, Relation) or fact.operator != "=":
            continue
        for symbol in sorted(
            fact.value.free_symbols, key=lambda s: (_is_bounded(s, roles), s.name)
        ):
            slope = _slope(fact.value, symbol)
            if slope is None or not scaled_sign(sp.factor_terms(slope), roles):
                continue
            value = -fact.value.xreplace({symbol: sp.S.Zero}) / slope
            return fact, symbol, sp.factor_terms(value)
    return None


def _slope(x: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """What a letter is multiplied with in an expression that is seen to be linear in it.

    That is its derivative, which SymPy takes ten times as long to find. None for all others.
    """
    if x == symbol:
        return sp.S.One
    if not x.has(symbol):
        return sp.S.Zero
    if x.is_Add:
        slopes = [_slope(term, symbol) for term in x.args]
        return None if None in slopes else sp.Add(*slopes)
    if x.is_Mul:
        with_it = [factor for factor in x.args if factor.has(symbol)]
        slope = _slope(with_it[0], symbol) if len(with_it) == 1 else None
        return slope and sp.Mul(slope, *(factor for factor in x.args if factor != with_it[0]))
    return None


def _is_bounded(symbol: sp.Symbol, roles: Mapping[str, Role]) -> bool:
    """Whether a letter may not be any number: it is eliminated last."""
    role = roles.get(symbol.name, REAL)
    return role.low is not None or role.high is not None


def _without_loose(facts: Sequence[Formula], roles: Mapping[str, Role]) -> Sequence[Formula]:
    """Facts without inequalities that a letter satisfies which may be any number, and is alone."""
    kept: list[Formula] = []
    for fact in facts:
        own = fact.value if isinstance(fact, Relation) and fact.operator != "=" else sp.S.Zero
        others = [value for other in facts if other is not fact for value in relations(other)]
        if not any(
            not _is_bounded(symbol, roles)
            and not any(other.value.has(symbol) for other in others)
            and scaled_sign(sp.factor_terms(sp.diff(own, symbol)), roles)
            for symbol in own.free_symbols
        ):
            kept.append(fact)
    return kept


def _bounds(symbol: sp.Symbol, role: Role) -> list[Formula]:
    """What a letter may be, as relations."""
    ends = ((role.low, 1, role.closed[0]), (role.high, -1, role.closed[1]))
    return [
        Relation(sense * (symbol - end), ">=" if closed else ">")
        for end, sense, closed in ends
        if end is not None
    ]


def _holds(formula: Formula, roles: Mapping[str, Role]) -> bool | None:
    """Whether a formula holds for all letters in it, by the signs of numbers; None if open."""
    signs = {own.value: scaled_sign(own.value, roles) for own in relations(formula)}
    return holds_with(formula, signs)


__all__ = ["hold_together"]
