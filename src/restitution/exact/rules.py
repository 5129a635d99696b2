"""Rules by which an expression is written in another way, and how they are put to use.

What the rules are, and in which order they are tried, is told in `table`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any

from sympy import Expr

from restitution.exact.nodes import rebuilt
from restitution.exact.simplicity import cost
from restitution.records import dataclass

# No more passes are made, should two rules undo each other.
_PASSES = 8
CONVENTION = -math.inf
"""The gain of a rule whose form is taken however long it is."""


@dataclass(frozen=True)
class Rule:
    """One way to write an expression otherwise.

    ``rewrite`` gives another form of what ``applies`` is true of, of the same value wherever the
    letters are admissible. It is taken where it is less to read (`cost`) by more than ``gain``.
    """

    name: str
    applies: Callable[[Any], bool]
    rewrite: Callable[[Any], Expr]
    gain: float = 0.0


def improved(rules: Iterable[Rule], value: Expr) -> Expr:
    """An expression after the rules in their order, again and again until none changes it."""
    for _ in range(_PASSES):
        before = value
        for rule in rules:
            if rule.applies(value):
                form = rule.rewrite(value)
                if rule.gain == CONVENTION or cost(form) < cost(value) - rule.gain:
                    value = form
        if value == before:
            break
    return value


def everywhere(rules: Iterable[Rule], value: Expr) -> Expr:
    """An expression with each node improved, the innermost first."""
    if value.is_Atom:
        return value
    arguments = [everywhere(rules, argument) for argument in value.args]
    if tuple(arguments) != value.args:
        value = rebuilt(value, arguments)
    return improved(rules, value)


def shortest(rules: Iterable[Rule], subject: Any) -> Expr:
    """Of the forms that the rules give of something the one that is least to read, or the first."""
    return min((rule.rewrite(subject) for rule in rules if rule.applies(subject)), key=cost)


__all__ = ["CONVENTION", "Rule", "everywhere", "improved", "shortest"]
