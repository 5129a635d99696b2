"""A claim in symbols, as it was read."""

from __future__ import annotations

from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
)
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Claim
from restitution.render.layout.statements import from_tree
from restitution.render.text import to_text

_SIGNS = {"=": "=", "<": "<", "<=": "≤", ">": ">", ">=": "≥", "!=": "≠"}


def write_claim(claim: Claim) -> str:
    """A claim in symbols: ``⅕ × 3 + ⅖ × 4 = ⅕v + ⅖w``; further right sides behind *or*."""
    right = " or ".join(write_side(tree) for tree in (claim.right, *claim.others))
    return f"{write_side(claim.left)} {_SIGNS[claim.sign]} {right}"


def write_side(tree: Expression) -> str:
    """An expression of a working in symbols, with its phrases as words."""
    return to_text(from_tree(rebuilt(tree, _with_name)))


def _with_name(node: Expression) -> Expression:
    """A phrase as a name, which is written as words; another node as it is."""
    match node:
        case Letter(name) if is_phrase(name):
            return Name(_words(name))
    return node


def _words(name: str) -> str:
    """A phrase with its short forms in capitals."""
    return " ".join("KE" if word == "ke" else word for word in name.split())
