"""How a line was read: its claims as mathematics on one line of text."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from restitution.expression.tree import Expression, Letter, letters, walk
from restitution.expression.writing import write_expression
from restitution.practice.reading.vocabulary import SCALAR_PRODUCT_WORD
from restitution.practice.script import Claim, Script
from restitution.render.layout import Layout, Words
from restitution.render.layout.statements import from_tree
from restitution.render.text import to_text

_SIGNS = {"<=": "≤", ">=": "≥", "!=": "≠"}


def read_as(claims: Sequence[Claim]) -> str | None:
    """Claims as they were read: a chain is written once, others are parted by commas."""
    text = ""
    last: Claim | None = None
    for claim in claims:
        if claim.left == claim.right and len(claims) > 1:
            continue
        sign = _SIGNS.get(claim.sign, claim.sign)
        right = " or ".join(text_of(tree) for tree in (claim.right, *claim.others))
        if last is not None and last.leads_to(claim):
            text += f" {sign} {right}"
        else:
            text += f"{', ' if text else ''}{text_of(claim.left)} {sign} {right}"
        last = claim
    return text.replace(f"the {SCALAR_PRODUCT_WORD}", "scalar product") or None


@lru_cache(maxsize=4096)
def text_of(tree: Expression) -> str:
    """A tree as people write it; phrases stand in it as typed."""
    if isinstance(tree, Letter) and " " in tree.name:
        return tree.name
    if any(isinstance(node, Letter) and not node.name.isidentifier() for node in walk(tree)):
        return write_expression(tree)
    return to_text(_layout(tree))


def _layout(tree: Expression) -> Layout:
    if isinstance(tree, Letter) and " " in tree.name:
        return Words(tree.name)
    return from_tree(tree)


def lines_of_letters(script: Script) -> dict[str, set[int]]:
    """The numbers of the lines in which a letter stands."""
    lines: dict[str, set[int]] = {}
    for line in script.lines:
        for link in line.links:
            for side in (link.readings[0].left, link.readings[0].right):
                for name in letters(side):
                    lines.setdefault(name, set()).add(line.number)
    return lines
