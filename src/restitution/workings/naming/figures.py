"""Values of whole degrees and decimals to four figures, once they are on paper.

Exactly ``v = (61/76) cos 35° − (319/190) sin 25°`` is long, and stands once, with ``≈ −0.05208``
behind it; where it comes again, its figures are printed. What the lines say stays exact.
"""

from __future__ import annotations

from fractions import Fraction
from functools import partial

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import significant
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Negate,
    Number,
    Unit,
    letters,
    walk,
)
from restitution.planning.writing.forms import swept
from restitution.workings.naming.measured import rounded, worth

# Of a value on the way, so that three are right in the end.
FIGURES_BETWEEN = 4
_FIGURES_OF_COSINES = range(FIGURES_BETWEEN, 9)
_RATIOS = frozenset({"sin", "cos", "tan"})
# Values beyond these would need a power of ten.
_LEAST, _GREATEST = Fraction(1, 1000), 10000


def of_plain_angles(tree: Expression) -> bool:
    """Whether a number has ratios of angles such as 37°, of which only a calculator knows."""
    ratios = [e for e in walk(tree) if isinstance(e, Apply) and e.function in _RATIOS]
    return bool(ratios) and not letters(tree)


class Figures:
    """The sums of ratios of plain angles that are on paper, with their figures."""

    def __init__(self) -> None:
        self._known: dict[Expression, Expression] = {}

    def note(self, tree: Expression) -> None:
        """Notes that the figures of a value stand behind it now."""
        own = tree.operand if isinstance(tree, Negate) else tree
        if not _is_sum(own):
            return
        number = _in_figures(own)
        if number is not None:
            self._known[own] = number

    def cosine(self, tree: Expression) -> Expression:
        """The figures of a cosine that is not written exactly; they stand for it from then.

        There are as many of them as the angle to three figures needs.
        """
        own = tree.operand if isinstance(tree, Negate) else tree
        number = next(
            filter(partial(_same_angle, own), (_in_figures(own, n) for n in _FIGURES_OF_COSINES)),
            None,
        )
        if number is None:
            return tree
        self._known[own] = number
        return tree if own is tree and number == own else exchanged(tree, {own: number})

    def put(self, tree: Expression) -> Expression:
        """A side of a line with figures for the values in it that are on paper."""
        own = tree.operand if isinstance(tree, Negate) else tree
        if own in self._known:
            return tree
        put = exchanged(tree, self._known)
        if put == tree:
            return tree
        put = swept(rebuilt(swept(put), _sign_outside))
        # Figures that lead to others in the end would make the line false.
        return tree if _differ(tree, put) else put

    def vector(self, tree: Expression) -> Expression:
        """A vector of which each long component has its figures alone; they are known from then."""
        for node in walk(tree):
            match node:
                case Binary("*", size, Unit()):
                    self.note(size)
        return self.put(tree)


def _sign_outside(tree: Expression) -> Expression:
    """An arctangent without a sign inside: 180° − arctan 1.374."""
    match tree:
        case Apply("arctan", Negate(inside)):
            return Negate(Apply("arctan", inside))
    return tree


def _is_sum(tree: Expression) -> bool:
    """Whether a value is a sum with ratios of plain angles in it."""
    match tree:
        case Binary("+" | "-"):
            return of_plain_angles(tree)
        case Binary("/", above, Number()):
            return _is_sum(above)
    return False


def _same_angle(cosine: Expression, figures: Expression | None) -> bool:
    return figures is not None and not _differ(Apply("arccos", cosine), Apply("arccos", figures))


def _differ(exact: Expression, put: Expression) -> bool:
    """Whether a value has other figures in an answer if figures are put in on the way."""
    one, other = rounded(exact), rounded(put)
    return one is not None and other is not None and one != other


def _in_figures(tree: Expression, figures: int = FIGURES_BETWEEN) -> Expression | None:
    """A number to so many figures, as a decimal; None of one that is very small or large."""
    try:
        number = Fraction(significant(worth(tree), figures))
    except (RestitutionError, sp.SympifyError, ValueError):
        return None
    if not _LEAST <= abs(number) < _GREATEST:
        return None
    return Negate(Number(-number)) if number < 0 else Number(number)
