"""By what a line is divided that loses a factor, so that its words can say so."""

from __future__ import annotations

import sympy as sp

from restitution.errors import RestitutionError
from restitution.explaining.derivation import Derivation, Line, Relation
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import Expression
from restitution.planning.forms import UnwrittenError, tree_of


def factor_cancelled(derivation: Derivation, line: Line) -> Expression | None:
    """The factor in letters by which a line was divided; None where it has no short form."""
    first = line.premises[0] if line.premises else None
    above = derivation.line(first) if isinstance(first, int) else None
    if above is None or not isinstance(above.relation, Relation):
        return None
    assert isinstance(line.relation, Relation)
    if len(above.relation.options) != 1 or len(line.relation.options) != 1:
        return None
    try:
        before, after = (_residual(each.relation) for each in (above, line))  # type: ignore[arg-type]
        numerator, _ = sp.fraction(sp.cancel(before / after))
        _, factor = sp.factor_list(numerator)
        bases = [base for base, _ in factor]
        return tree_of(bases[0]) if len(bases) == 1 else None
    except (RestitutionError, UnwrittenError, ZeroDivisionError, TypeError, sp.PolynomialError):
        return None


def _residual(relation: Relation) -> sp.Expr:
    """Left minus right. Raises RestitutionError where a quantity of the motion stands in it."""
    link = relation.only[0]
    left, right = (in_letters(each, positive=True) for each in (link.left, relation.only[-1].right))
    return sp.sympify(left - right, strict=True)


__all__ = ["factor_cancelled"]
