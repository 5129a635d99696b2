"""In which terms a working speaks, whatever letters in bold type it has."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from restitution.explaining.lines.derivation import Derivation, Line, Meaning
from restitution.explaining.lines.layouts import Forms, shares_in
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Expression,
    Quantity,
    has_quantity,
    letters,
    quantities_in,
    walk,
)
from restitution.problem import Problem, Show, comparisons, trees, trees_of_relation
from restitution.records import dataclass


@dataclass(frozen=True)
class Terms:
    """The forms of numbers, the letters, and the quantities of a working.

    ``often`` counts the printed lines in which each quantity stands, ``inside`` are those of which
    a line has a sine or the like.
    """

    forms: Forms
    letters: frozenset[str]
    often: Counter[Quantity]
    inside: frozenset[Quantity]


def terms_of(derivation: Derivation, problem: Problem) -> Terms:
    """The terms of the working of a problem."""
    typed = list(trees(problem))
    shown = (item.answer for item in derivation.items if item.shown)
    whole = [*typed, *(tree for relation in shown for tree in trees_of(relation))]
    compared = (comparison.operands for comparison in comparisons(problem))
    shares = {share for operands in compared for share in shares_in(operands)}
    names = {*derivation.meanings}.union(*map(letters, typed))
    often: Counter[Quantity] = Counter()
    inside: set[Quantity] = set()
    for line in derivation.lines:
        own: set[Quantity] = set()
        for tree in _trees(line):
            names |= letters(tree)
            if has_quantity(tree):
                own |= set(quantities_in(tree))
                ratios = (node.argument for node in walk(tree) if isinstance(node, Apply))
                inside.update(node for ratio in ratios for node in quantities_in(ratio))
        if line.shown != "silent":
            often.update(own)
    claims = (step.relation for _, step in problem.steps() if isinstance(step, Show))
    wanted = (tree for claim in claims for tree in trees_of_relation(claim))
    forms = Forms((tree for tree in whole if tree not in shares), wanted)
    return Terms(forms, frozenset(names), often, frozenset(inside))


def _trees(line: Line) -> Iterator[Expression]:
    if not isinstance(line.relation, Meaning):
        yield from trees_of(line.relation)


__all__ = ["Terms", "terms_of"]
