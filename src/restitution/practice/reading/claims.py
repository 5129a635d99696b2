"""A claim in symbols, as it was read."""

from __future__ import annotations

from dataclasses import replace

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Pair,
    Quantity,
)
from restitution.practice.reading.phrases import is_phrase
from restitution.practice.script import Claim
from restitution.render.layout.statements import from_tree
from restitution.render.text import to_text

_SIGNS = {"=": "=", "<": "<", "<=": "≤", ">": ">", ">=": "≥", "!=": "≠"}


def write_claim(claim: Claim) -> str:
    """A claim in symbols: ``⅕ × 3 + ⅖ × 4 = ⅕v + ⅖w``; further right sides behind *or*."""
    right = " or ".join(write_side(each) for each in (claim.right, *claim.others))
    return f"{write_side(claim.left)} {_SIGNS[claim.sign]} {right}"


def write_side(tree: Expression) -> str:
    """An expression of a working in symbols, with its phrases as words."""
    return to_text(from_tree(_with_names(tree)))


def _with_names(tree: Expression) -> Expression:
    """A tree in which phrases are names, which are written as words."""
    match tree:
        case Letter(name) if is_phrase(name):
            return Name(_words(name))
        case Binary(_, left, right):
            return replace(tree, left=_with_names(left), right=_with_names(right))
        case Negate(operand):
            return replace(tree, operand=_with_names(operand))
        case Apply(_, argument):
            return replace(tree, argument=_with_names(argument))
        case Pair(x, y):
            return replace(tree, x=_with_names(x), y=_with_names(y))
        case Quantity(_, arguments):
            return replace(tree, arguments=tuple(map(_with_names, arguments)))
    return tree


def _words(name: str) -> str:
    """A phrase with its short forms in capitals."""
    return " ".join("KE" if each == "ke" else each for each in name.split())
