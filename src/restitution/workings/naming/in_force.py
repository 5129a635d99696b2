"""What is given of letters in a part, as formulas that the oracle knows."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import sympy as sp

from restitution.explaining.lines.derivation import FLIPPED, Derivation
from restitution.expression.tree import Expression, has_quantity
from restitution.oracle import Formula, compared


def inequalities(
    derivation: Derivation, part: str | None, value: Callable[[Expression], sp.Expr]
) -> Iterator[Formula]:
    """The inequalities between letters that are given for a part; ``value`` is of one side."""
    for fact in derivation.facts:
        if fact.kind not in ("given", "range") or fact.part not in (None, part):
            continue
        links = [link for links in fact.relation.options for link in links]
        sides = (side for link in links for side in (link.left, link.right))
        if len(fact.relation.options) == 1 and not any(map(has_quantity, sides)):
            for link in links:
                if link.sign in FLIPPED:
                    yield compared(value(link.left), link.sign, value(link.right))


__all__ = ["inequalities"]
