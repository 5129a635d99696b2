"""Squares of the sine and the cosine of one angle: like terms together, one square a side."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Apply, Expression, Letter
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import (
    negative,
    outer_terms,
    product,
    square,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factored,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.scene import Scene

_MOVES = (Move("rearrange"), Move("cancel"))
_SQUARES = ((2, 0), (0, 2))


def one_square_a_side(scene: Scene, line: int, angle: sp.Symbol, known: Sequence[Ref]) -> int:
    """``a sin²θ = b cos²θ``, from an equation whose terms are multiples of these squares.

    The coefficients stand as sums of squares first, where there are several in one. The line
    itself, where it is no such equation, or says no more than this.
    """
    link = scene.desk.last_link(line)
    if link.sign != "=":
        return line
    trees = [*outer_terms(link.left), *map(negative, outer_terms(link.right))]
    shares = _shares([scene_value(scene, tree) for tree in trees], angle)
    if shares is None or _stands_so(shares):
        return line
    sums = [sp.Add(*own) for own in shares]
    signs = [scene.model.sign(own) for own in sums]
    if sorted(signs) != [-1, 1]:
        return line
    whole = [[sign * value for value in own] for sign, own in zip(signs, shares, strict=True)]
    shares = [_numbers_added(own) for own in _without_common(scene, whole)]
    apart = [total(map(_term, own)) for own in shares]
    last = _without_common(scene, [[sp.Add(*own)] for own in shares])
    joined = [tree_of(tidy(factored(own[0]))) for own in last]
    names = [square(Apply(ratio, Letter(angle.name))) for ratio in ("sin", "cos")]
    several = any(len(own) > 1 and any(value.free_symbols for value in own) for own in shares)
    for coefficients in (apart, joined) if several else (joined,):
        left, right = (product(c, name) for c, name in zip(coefficients, names, strict=True))
        written = scene.judge.write(_MOVES, [line, *known], chain(left, (right, None)))
        line = line if written is None else written
    return line


def _shares(values: Sequence[sp.Expr], angle: sp.Symbol) -> list[list[sp.Expr]] | None:
    """By how much of sin² and of cos² each term is; None where one is of anything else."""
    shares: list[list[sp.Expr]] = [[], []]
    for value in values:
        if value == 0:
            continue
        try:
            poly = polynomial_in(expanded(value), sp.sin(angle), sp.cos(angle))
        except sp.PolynomialError:
            return None
        for powers, share in poly.terms():
            if powers not in _SQUARES or angle in share.free_symbols:
                return None
            shares[_SQUARES.index(powers)].append(factored(one_fraction(share)))
    return shares if all(shares) else None


def _stands_so(shares: Sequence[Sequence[sp.Expr]]) -> bool:
    """Whether there is one term of each square, and nothing that both have in common."""
    return all(len(own) == 1 for own in shares) and not (
        shares[0][0].free_symbols & shares[1][0].free_symbols
    )


def _without_common(scene: Scene, shares: list[list[sp.Expr]]) -> list[list[sp.Expr]]:
    """Coefficients without denominators, and without what all have in common."""
    parts = [sp.fraction(one_fraction(value)) for own in shares for value in own]
    below = sp.lcm_list([bottom for _, bottom in parts])
    above = [[expanded(cancelled(value * below)) for value in own] for own in shares]
    shared = factored(sp.gcd_list([value for own in above for value in own]))
    ratio = sp.Mul(
        *(x for x in sp.Mul.make_args(shared) if x.is_number or proved_sign(scene.model.ground, x))
    )
    return [[factored(cancelled(value / ratio)) for value in own] for own in above]


def _numbers_added(terms: Sequence[sp.Expr]) -> list[sp.Expr]:
    """Terms of which those that are numbers are one."""
    worth = sp.Add(*(term for term in terms if term.is_number))
    rest = [term for term in terms if not term.is_number]
    return (
        [*rest, worth] if worth.is_negative else [value for value in (worth, *rest) if value != 0]
    )


def _term(value: sp.Expr) -> Expression:
    """A term with its sign in front of it; what is squared begins with its number."""
    squares = {
        power: (-power.base) ** power.exp
        for power in value.atoms(sp.Pow)
        if power.exp.is_even and power.base.is_Add and power.base.as_coeff_Add()[0].is_negative
    }
    value = value.xreplace(squares)
    minus = value.as_coeff_Mul()[0].is_negative
    return negative(tree_of(-value, as_it_is=True)) if minus else tree_of(value, as_it_is=True)
