"""Formulas that are only quoted, and lines with the data of the question in them."""

from __future__ import annotations

from fractions import Fraction

from restitution.expression.tree import Number, walk
from restitution.practice.judgement import JudgedLine

_OF_FORMULAS = frozenset((Fraction(0), Fraction(1, 2), Fraction(1), Fraction(2)))


def has_data(line: JudgedLine) -> bool:
    """Whether a line has numbers in it that no formula has by itself."""
    return any(
        isinstance(node, Number) and abs(node.value) not in _OF_FORMULAS
        for link in line.line.links
        for side in (link.readings[0].left, link.readings[0].right)
        for node in walk(side)
    )
