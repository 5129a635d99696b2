"""Keeping exact expressions small while a story is told: one fraction, nothing left to cancel.

This is about size and equality, not about beauty: the textbook form is ``exact.tidy``'s.
"""

from __future__ import annotations

from contextlib import suppress

import sympy as sp

from restitution.exact import merged, rationalised
from restitution.solving.algebra.polynomials import TooLargeError, reduced, without_cos_squared
from restitution.solving.algebra.signs import rational_below
from restitution.work import remembered, spend

_LARGE = 400
_LONG = 60


@remembered(4096)
def neat(x: sp.Expr) -> sp.Expr:
    """The same value as one reduced fraction, with sin² + cos² = 1 used where it stands."""
    x = sp.sympify(x, strict=True)
    if x.is_Number or x.is_Symbol:
        return x
    x = pythagoras(merged(x))
    if not x.free_symbols:
        if x.has(sp.Pow, sp.CRootOf):
            return rational_below(x, max_terms=6)
        return x
    if not _needs_work(x):
        return x
    spend()
    if sp.count_ops(x) > _LARGE:
        return sp.together(x)
    try:
        result = sp.cancel(sp.together(x)) if _is_no_quotient(x) else reduced(x)
    except (sp.PolynomialError, TooLargeError):
        return sp.together(x)
    if result.has(sp.sin) and sp.count_ops(result) > _LONG:
        with suppress(sp.PolynomialError, TooLargeError):  # a cosine under a root
            result = _reduced(result)
    return pythagoras(sp.factor_terms(result))


@remembered(1024)
def ratio_in_numbers(above: sp.Expr, below: sp.Expr) -> sp.Expr | None:
    """The ratio of two expressions whose terms have proportional numbers before them, or None."""
    if above.free_symbols != below.free_symbols or sp.count_ops(above + below) > _LARGE:
        return None
    upper, lower = map(_numbers_of_terms, (above, below))
    if upper.keys() != lower.keys() or sp.S.Zero in (*upper.values(), *lower.values()):
        return None
    ratios = {rationalised(number / lower[term]) for term, number in upper.items()}
    return ratios.pop() if len(ratios) == 1 else None


def _numbers_of_terms(x: sp.Expr) -> dict[sp.Expr, sp.Expr]:
    """The terms of an expression without the numbers before them, each with its number."""
    numbers: dict[sp.Expr, sp.Expr] = {}
    for other in sp.Add.make_args(sp.expand(x)):
        number, term = other.as_independent(*x.free_symbols, as_Add=False)
        numbers[term] = numbers.get(term, sp.Integer(0)) + number
    return numbers


def _is_no_quotient(x: sp.Expr) -> bool:
    """Whether bars, a sense, an angle or a root keeps SymPy's form of it.

    That is a root in a root of numbers, and one of a quotient: √P and √(1/P) are strangers else.
    """
    if x.has(sp.sign, sp.atan, sp.atan2, sp.Abs):
        return True
    roots = (node.base for node in x.atoms(sp.Pow) if not node.exp.is_Integer)
    return any(
        not base.is_Rational and (not base.free_symbols or _is_of_a_quotient(base))
        for base in roots
    )


def _is_of_a_quotient(base: sp.Expr) -> bool:
    """Whether letters stand below a line in what is below a root."""
    return any(node.exp.is_negative and node.base.free_symbols for node in base.atoms(sp.Pow))


def _reduced(x: sp.Expr) -> sp.Expr:
    """A quotient with cos²θ = 1 − sin²θ used throughout, where that is shorter."""
    above, below = sp.fraction(x)
    for angle in sorted({atom.args[0] for atom in x.atoms(sp.sin)}, key=sp.default_sort_key):
        above, below = (without_cos_squared(value, angle) for value in (above, below))
    if below == 0:
        return x
    form = reduced(above / below)
    return form if sp.count_ops(form) < sp.count_ops(x) else x


def pythagoras(x: sp.Expr) -> sp.Expr:
    """Replaces every sum a cos²θ + a sin²θ that stands as such by a."""
    if not x.has(sp.sin):
        return x
    return x.replace(lambda node: node.is_Add and node.has(sp.sin), _pythagoras_in_sum)


def _pythagoras_in_sum(node: sp.Add) -> sp.Expr:
    terms = list(node.args)
    for i, term in enumerate(terms):
        for angle in [f.args[0] for f in term.atoms(sp.sin)]:
            square = sp.sin(angle) ** 2
            factors = sp.Mul.make_args(term)
            if square not in factors:
                continue
            rest = term / square
            partner = rest * sp.cos(angle) ** 2
            for k, other in enumerate(terms):
                if k != i and other == partner:
                    kept = [t for n, t in enumerate(terms) if n not in (i, k)]
                    return _pythagoras_in_sum(sp.Add(*kept, rest)) if kept else rest
    return node


def _needs_work(x: sp.Expr) -> bool:
    """Whether there is a sum in a denominator, or a product or power of sums."""
    for node in sp.preorder_traversal(x):
        if node.is_Pow and (node.exp.is_negative or node.base.is_Add):
            return True
        if node.is_Mul and sum(1 for arg in node.args if arg.is_Add) >= 1 and len(node.args) > 1:
            return True
    return False
