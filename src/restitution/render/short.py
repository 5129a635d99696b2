"""Labels in the simplest form that a textbook has: angles reduced, nothing long."""

from __future__ import annotations

import math
from typing import Any

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy_angle
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.render.text import to_text

# Of all the numbers of a label together.
_MOST_DIGITS = 4
_MOST_LETTERS = 4
_SAME = 1e-6


def is_short(x: Any) -> bool:
    """Whether an expression says more as a label than it hides: ``u cos α``, ``√3 u/2``, ``½eu``.

    It is one product, in which at most one sine or cosine stands, and no root beside it; one of
    its factors may be a sum of two plain terms, as 1 + e. There is no root of letters.
    """
    x = sp.sympify(x, strict=True)
    factors = sp.Mul.make_args(x)
    sums = [factor for factor in factors if factor.is_Add]
    turned = [factor for factor in factors if _base(factor).is_Function]
    surds = [factor for factor in factors if factor.is_Pow and not factor.exp.is_Integer]
    if any(_base(surd).free_symbols or not _base(surd).is_Rational for surd in surds):
        return False
    if len(sums) + len(turned) > 1 or (surds and (sums or turned)):
        return False
    if any(_base(factor).is_Add and not factor.is_Add for factor in factors):
        return False
    if any(not _is_plain_sum(addend) for addend in sums):
        return False
    if any(len(sp.Add.make_args(_base(function).args[0])) > 2 for function in turned):
        return False
    numbers = {abs(n) for number in x.atoms(sp.Rational) for n in (int(number.p), int(number.q))}
    small = all(number < 1000 for number in numbers)
    return small and _digits(x) <= _MOST_DIGITS and len(x.free_symbols) <= _MOST_LETTERS


def _base(factor: sp.Expr) -> sp.Expr:
    return factor.base if factor.is_Pow else factor


def _is_plain_sum(total: sp.Expr) -> bool:
    plain = total.is_polynomial(*total.free_symbols) and all(
        term.is_Integer or term.is_Symbol or term.is_Mul or term.is_Pow
        for term in sp.Add.make_args(total)
    )
    roots = any(not atom.exp.is_Integer for atom in total.atoms(sp.Pow))
    return bool(plain) and len(total.args) == 2 and not roots and not total.has(sp.Function)


def _digits(x: sp.Expr) -> int:
    """How many digits the numbers of an expression have, but for powers and those of angles."""
    if x.is_Rational:
        sizes = (abs(int(x.p)), int(x.q))
        return sum(len(str(size)) for size in sizes if size != 1)
    if x.is_Pow:
        return _digits(x.base)
    if x.is_Function:
        return 0
    return sum(_digits(argument) for argument in x.args)


def angle_label(tree: Expression, value: float, drawn: float, typed: Layout) -> Layout | None:
    """The label of an arc that is ``drawn`` for an angle given as ``tree``, of this ``value``.

    Both are in radians. An arc is drawn the short way round, and from the nearer end of a line:
    so 180° + θ may be drawn as θ, and 120° as 60°. None where the arc is of another angle.
    """
    if abs(value - drawn) < _SAME and not isinstance(typed, lay.Sum):
        return typed
    for sign in (1, -1):
        for turns in (0, 1, -1, 2, -2, 3, -3, 4, -4):
            if abs(sign * value + turns * math.pi - drawn) < _SAME:
                return _reduced(tree, sign, turns, typed)
    return None


def _reduced(tree: Expression, sign: int, turns: int, typed: Layout) -> Layout | None:
    try:
        value = evaluate(tree, lambda name: sp.Symbol(name, positive=True))
    except RestitutionError:
        return typed if (sign, turns) == (1, 0) else None
    if not isinstance(value, sp.Expr):
        return typed if (sign, turns) == (1, 0) else None
    angle = sp.expand(sign * value + turns * sp.pi)
    shown = lay.from_sympy(tidy_angle(angle) if angle.has(sp.Function) else angle, degrees=True)
    if (sign, turns) == (1, 0) and len(to_text(typed)) <= len(to_text(shown)):
        return typed
    return shown
