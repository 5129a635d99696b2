"""Equations that say of a sum of angles that its sine, or its cosine, is zero."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

import sympy as sp

from restitution.exact import tidy_angle
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Apply, Binary, Degrees, Expression, Letter, is_binary, walk
from restitution.oracle.roles import ACUTE
from restitution.planning.closing.roots import known_as
from restitution.planning.formulas.impacts import residual
from restitution.planning.writing.desk import Source, chain
from restitution.planning.writing.forms import ZERO, number, product, tree_of
from restitution.planning.writing.polynomials import expanded, numerator
from restitution.planning.writing.scene import Scene

# Samples of two acute angles, and what two values may differ by that are the same.
_SAMPLES = ((0.31, 0.57), (0.83, 1.21), (1.37, 0.44), (0.19, 1.02))
_NEAR = 1e-9
_MOST = 3
_RIGHT_ANGLE = 90


def zero_of_a_sum(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """An equation in ratios of sums of an unknown angle and another, as sin(α + 2θ) = 0."""
    link = scene.desk.last_link(line)
    if not any(map(_is_of_a_sum, (*walk(link.left), *walk(link.right)))):
        return None
    own = numerator(residual(scene, line))
    angles = sorted((symbol for symbol in own.free_symbols if _is_acute(scene, symbol)), key=str)
    value = tidy_angle(scene.final(symbol))
    if symbol not in angles or len(angles) < len(_SAMPLES[0]):
        return None  # of one angle a sum with degrees would hide where these come from
    if value.free_symbols != set(angles) - {symbol}:
        return None
    known: list[Ref] = [f"acute:{angle}" for angle in angles]
    for function, whole, turn in _sums(own, symbol, value):
        relation = chain(Apply(function, whole), (ZERO, None))
        refs = scene.judge.enough(Move("identity", "sum-of-angles"), (line,), relation, ())
        if refs is None:
            continue
        mark = scene.desk.mark()
        zero = scene.desk.write(Move("identity", "sum-of-angles"), refs, relation)
        sized = chain(whole, (Degrees(turn), None))
        if scene.judge.follows(Move("inverse"), (zero, *known), sized):
            angle = scene.desk.write(Move("inverse"), (zero, *known), sized)
            alone = chain(Letter(symbol.name), (tree_of(value, angle=True, as_it_is=True), None))
            last = scene.judge.write((Move("rearrange"),), (angle,), alone)
            if last is not None:
                return known_as(scene, symbol, value, last)
        scene.desk.back(mark)
    return None


def _is_acute(scene: Scene, symbol: sp.Basic) -> bool:
    return scene.model.unknowns.roles.get(str(symbol)) == ACUTE


def _is_of_a_sum(tree: Expression) -> bool:
    return isinstance(tree, Apply) and is_binary(tree.argument, "+", "-")


def _sums(
    own: sp.Expr, symbol: sp.Symbol, value: sp.Expr
) -> Iterator[tuple[str, Expression, Fraction]]:
    """The sines and cosines of sums of which an expression is a multiple, as samples say it.

    Each with the sum, and what that comes to, in degrees, where the unknown has its value.
    """
    others = sorted(value.free_symbols, key=str)
    rest = sorted(own.free_symbols - {symbol, *others}, key=str)
    put = own.subs({value: sp.Integer(n) for n, value in enumerate(rest, 2)})
    samples = [dict(zip((symbol, *others), sample, strict=False)) for sample in _SAMPLES]
    values = [complex(put.subs(sample).evalf()) for sample in samples]
    for times in range(1, _MOST + 1):
        for degrees in (90, 180):
            whole = expanded(times * (symbol - value) + sp.pi * degrees / 180)
            function = "cos" if degrees == _RIGHT_ANGLE else "sin"
            sizes = [complex(getattr(sp, function)(whole.subs(e)).evalf()) for e in samples]
            first = values[0] / sizes[0]
            if all(abs(v - first * s) < _NEAR for v, s in zip(values, sizes, strict=True)):
                tree = _sum(whole)
                shift = expanded(whole - _without_number(whole)) * 180 / sp.pi
                if tree is not None and shift.is_Rational:
                    yield function, tree, degrees - Fraction(int(shift.p), int(shift.q))


def _without_number(whole: sp.Expr) -> sp.Expr:
    """A sum of angles without the number that is added."""
    return whole.as_independent(*whole.free_symbols, as_Add=True)[1]


def _sum(whole: sp.Expr) -> Expression | None:
    """A sum of whole multiples of angles, without a number; None of another."""
    shares = [term.as_coeff_Mul() for term in sp.Add.make_args(_without_number(whole))]
    if not all(count.is_Integer for count, _ in shares):
        return None
    shares.sort(key=lambda share: bool(share[0] < 0))
    trees = [product(number(abs(count)), Letter(str(value))) for count, value in shares]
    tree, *others = trees
    for (count, _), other in zip(shares[1:], others, strict=True):
        tree = Binary("+" if count > 0 else "-", tree, other)
    return tree if shares[0][0] > 0 else None


__all__ = ["zero_of_a_sum"]
