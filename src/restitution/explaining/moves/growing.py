"""Bounds of what only grows, or only falls, with a letter."""

from __future__ import annotations

import sympy as sp

from restitution.explaining.lines.derivation import Link, Meaning, Relation
from restitution.explaining.moves.bases import FLIPPED, base_of, ends_of, equal_in, others_cited
from restitution.explaining.moves.limits import worth_at
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Expression,
    Letter,
    letters,
)
from restitution.oracle import REAL, Oracle, compared
from restitution.oracle import Relation as Claim


def is_monotone(step: Step, relation: Relation) -> bool:
    """The bounds of what only grows, or only falls, with a letter whose range is cited."""
    base = base_of(step)
    equation = None if base is None or len(base.options) != 1 else ends_of(base.only)
    if equation is None or len(relation.options) != 1:
        return False
    value = step.world.expression(step.world.scalar(equation.right), step.roles)
    ranges = _cited_ranges(step)
    for symbol in value.free_symbols:
        role = step.roles.get(symbol.name)
        if role is not None and role.kind == "positive":
            # That it is positive, and may be as great as you like, is said nowhere.
            own = {"low": (sp.Integer(0), False), "high": (sp.oo, False)}
            ranges[symbol.name] = {**own, **ranges.get(symbol.name, {})}
    meant: dict[Expression, Expression] = {Letter(e.letter): e.quantity for e in step.lets}
    subjects = dict.fromkeys((equation.left, meant.get(equation.left, equation.left)))
    return any(
        _grows_between(step, relation.only, subject, value, name, ends)
        for name, ends in ranges.items()
        for subject in subjects
        if any(subject in (link.left, link.right) for link in relation.only)
    )


_Ends = dict[str, tuple[sp.Expr, bool]]


def _cited_ranges(step: Step) -> dict[str, _Ends]:
    """The ends of the ranges of letters that are cited, and whether they belong to them."""
    ranges: dict[str, _Ends] = {}
    bounds: list[Relation | Meaning] = [
        *(entry.relation for entry in step.known),
        *(premise.relation for premise in others_cited(step)),
    ]
    for relation in bounds:
        if isinstance(relation, Meaning) or len(relation.options) != 1:
            continue
        for links in relation.options:
            for link in links:
                for side, other, sign in (
                    (link.left, link.right, link.sign),
                    (link.right, link.left, FLIPPED.get(link.sign, "")),
                ):
                    if isinstance(side, Letter) and side.name in letters(other):
                        continue
                    if isinstance(side, Letter) and sign in ("<", "<=", ">", ">="):
                        end = step.world.expression(step.world.scalar(other), step.roles)
                        which = "low" if sign in (">", ">=") else "high"
                        ranges.setdefault(side.name, {})[which] = end, len(sign) == 2
    return ranges


def _grows_between(
    step: Step,
    links: tuple[Link, ...],
    subject: Expression,
    value: sp.Expr,
    name: str,
    ends: _Ends,
) -> bool:
    letter = step.roles.get(name, REAL).symbol(name)
    for direction in (1, -1):
        bounds = [_end_of(link, subject, ends, direction) for link in links]
        # Whether a slope has one sign is a long question: it is asked where all ends are cited.
        if None in bounds:
            continue
        slope = sp.diff(value, letter)
        if slope == 0:
            return False
        if step.oracle.proves(Claim(direction * slope, ">=")):
            if not _is_unbroken(step, value, letter):
                return False
            strict = any(len(link.sign) == 1 for link in links)
            # What is only approached without end is told with the condition of the answer.
            bounded = all(end.is_finite is not False for end, _ in ends.values())
            if strict and bounded and not _is_steep(step, direction * slope, letter, ends):
                return False
            return all(
                _is_worth(step, value, letter, *bound) for bound in bounds if bound is not None
            )
    return False


def _is_unbroken(step: Step, value: sp.Expr, letter: sp.Symbol) -> bool:
    """Whether nothing that divides is zero between the ends: else a value only seems to grow.

    That there is such a value is no reason: it is said of each, and not of all between them. What a
    letter may be anyway need not be cited for that.
    """
    divisors = {power.base for power in value.atoms(sp.Pow) if power.exp.is_negative}
    divisors |= {sp.cos(tangent.args[0]) for tangent in value.atoms(sp.tan)}
    broken = [divisor for divisor in divisors if letter in divisor.free_symbols]
    if not broken:
        return True
    between = tuple(
        compared(step.roles.get(name, REAL).symbol(name), ">" if which == "low" else "<", end)
        for name, ends in _cited_ranges(step).items()
        for which, (end, _) in ends.items()
        if end.is_finite is not False
    )
    oracle = Oracle({**step.roles, **step.setting.roles}, between)
    return all(oracle.proves(Claim(value, "!=")) for value in broken)


def _is_steep(step: Step, slope: sp.Expr, letter: sp.Symbol, ends: _Ends) -> bool:
    """Whether a slope is not zero between the ends: what stays the same is at no strict bound."""
    signs = {"low": ">", "high": "<"}
    inside = [
        compared(letter, signs[which], end)
        for which, (end, _) in ends.items()
        if end.is_finite is not False
    ]
    return step.oracle.with_facts(inside).proves(Claim(slope, ">"))


def _end_of(
    link: Link, subject: Expression, ends: _Ends, direction: int
) -> tuple[Expression, sp.Expr] | None:
    """The bound that a link sets, and the end of the range at which it is; None without one."""
    if link.left == subject:
        bound, sign = link.right, str(link.sign)
    elif link.right == subject:
        bound, sign = link.left, FLIPPED.get(link.sign, "")
    else:
        return None
    if sign not in ("<", "<=", ">", ">="):
        return None
    end = ends.get("low" if (sign[0] == ">") == (direction == 1) else "high")
    if end is None or end[1] != (len(sign) == 2):
        return None
    return bound, end[0]


def _is_worth(
    step: Step, value: sp.Expr, letter: sp.Symbol, bound: Expression, end: sp.Expr
) -> bool:
    """Whether an expression comes to a bound at an end."""
    there = worth_at(value, letter, end)
    own = step.world.expression(step.world.scalar(bound), step.roles)
    return there is not None and equal_in(step, there, own)
