"""The signs of the factors of a product, where not all of them are seen at once."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation, Sign
from restitution.explaining.lines.notation import read_relation
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Number,
    has_quantity,
    is_binary,
    letters,
    walk,
)
from restitution.oracle import BeyondError, Formula, Oracle, Role, compared
from restitution.planning.writing.forms import factors

_ZERO = Number(Fraction(0))
# The sign of one factor is seen beside what is cited.
_RATIOS = frozenset({"sin", "cos", "tan"})
_SEVERAL = 2
_ORDERS = frozenset(("<", "<=", ">", ">="))


def signs_of_factors(
    derivation: Derivation, line: Line, roles: Mapping[str, Role]
) -> tuple[Relation, ...]:
    """The sign of each difference that is a factor of the one product of which a line tells it.

    Empty where fewer than two factors are differences, unless that is one of a part of an angle,
    and where one of them has no certain sign.
    """
    whole = _product(derivation, line)
    if whole is None:
        return ()
    open_ = [base for base in bases_of(whole) if _is_difference(base)]
    hidden = any(map(_is_of_a_part, open_))
    if (len(open_) < _SEVERAL and not hidden) or has_quantity(whole):
        return ()
    oracle = Oracle(roles, tuple(cited_bounds(derivation, line, roles)))
    signs = [_sign(tree, oracle, roles) for tree in open_]
    if None in signs:
        return ()
    return tuple(
        Relation(((Link(tree, sign, _ZERO),),))
        for tree, sign in zip(open_, signs, strict=True)
        if sign is not None
    )


def _is_of_a_part(tree: Expression) -> bool:
    """Whether a ratio of a part of an angle is in a sum, as tan(α/3): of it no bound is seen."""
    return any(
        isinstance(e, Apply) and e.function in _RATIOS and isinstance(e.argument, Binary)
        for e in walk(tree)
    )


def _product(derivation: Derivation, line: Line) -> Expression | None:
    """What the one equation that is cited comes to, where a line tells its sign."""
    if line.move.id != "sign" or not isinstance(line.relation, Relation):
        return None
    relations = [own.relation for own in derivation.lines_in(line.premises)]
    match relations, line.relation.options:
        case [Relation((links,))], ((Link(sign=sign),),) if sign in _ORDERS:
            return links[-1].right if all(link.sign == "=" for link in links) else None
    return None


def bases_of(tree: Expression) -> Iterator[Expression]:
    """The factors of a product above and below; of a power of odd degree its base."""
    match tree:
        case Binary("/", above, below):
            yield from bases_of(above)
            yield from bases_of(below)
        case Binary("*"):
            for factor in factors(tree):
                yield from bases_of(factor)
        case Binary("^", base, Number(power)) if power.denominator == 1:
            yield from bases_of(base) if power.numerator % 2 else ()
        case _:
            yield tree


def _is_difference(tree: Expression) -> bool:
    """Whether it is a sum in which something is taken away that holds a letter."""
    return (
        is_binary(tree, "+", "-")
        and bool(letters(tree))
        and any(is_binary(node, "-") for node in walk(tree))
    )


def cited_bounds(
    derivation: Derivation, line: Line, roles: Mapping[str, Role]
) -> Iterator[Formula]:
    """What is cited of letters, as the oracle takes it."""
    for ref in line.premises:
        if not isinstance(ref, str) or ref.startswith("acute:"):
            continue
        fact = derivation.fact(ref)
        relation = read_relation(ref, {}) if fact is None else fact.relation
        if len(relation.options) != 1:
            continue
        for link in relation.only:
            sides = (link.left, link.right)
            if link.sign in _ORDERS and not any(map(has_quantity, sides)):
                left, right = (worth_of(side, roles) for side in sides)
                yield compared(left, link.sign, right)


def worth_of(tree: Expression, roles: Mapping[str, Role]) -> sp.Expr:
    """A tree in letters that know what they may be."""
    own = sp.sympify(in_letters(tree), strict=True)
    named = {s: roles[s.name].symbol(s.name) for s in own.free_symbols if s.name in roles}
    return own.xreplace(named)


def _sign(tree: Expression, oracle: Oracle, roles: Mapping[str, Role]) -> Sign | None:
    """How a factor compares with zero; None where that is not certain."""
    try:
        value = worth_of(tree, roles)
        signs: tuple[Sign, ...] = (">", "<", ">=", "<=")
        for sign in signs:
            if oracle.proves(compared(value, sign, sp.Integer(0))):
                return sign
    except (RestitutionError, BeyondError, TypeError, ValueError):
        return None
    return None


__all__ = ["bases_of", "cited_bounds", "signs_of_factors", "worth_of"]
