"""Equations with an unknown below a root: that is alone on a side, and both sides are squared."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import sympy as sp

from restitution.exact import in_one_ratio, tidy
from restitution.exact.symbols import atoms_in, symbol_names
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.expression.tree import Apply, Letter
from restitution.expression.writing import write_expression
from restitution.planning.closing.excluded_roots import option, rejected
from restitution.planning.closing.ratios import inside_functions
from restitution.planning.closing.roots import by_roots, is_reached, is_value, itself, known_as
from restitution.planning.closing.square_roots import as_square
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.writing.desk import Source, chain
from restitution.planning.writing.forms import product, square, swept, tree_of
from restitution.planning.writing.polynomials import cancelled, expanded, numerator, polynomial_in
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def alone(scene: Scene, number: int, symbol: sp.Symbol) -> int | None:
    """The line ``a√q = b`` of an equation with one root in which an unknown stands.

    A side that is long is written in its shortest form before. None of another equation.
    """
    whole = expanded(numerator(residual(scene, number)))
    parted = _parted(whole, symbol)
    if parted is None:
        return None
    factor, inside, rest = parted
    if scene.model.sign(scene.model.in_data(factor)) < 0:
        factor, rest = -factor, -rest
    inside = _in_the_ratio_of(rest, inside, symbol)
    left = product(tree_of(factor), Apply("sqrt", tree_of(inside)))
    number = _shortened(scene, number)
    relation = chain(swept(left), (tree_of(expanded(-rest)), None))
    if scene.desk.relation(number) == relation:
        return None
    return _rewritten(scene, number, relation)


def _in_the_ratio_of(rest: sp.Expr, inside: sp.Expr, angle: sp.Symbol) -> sp.Expr:
    """What is below a root in the one ratio of an angle that stands beside it."""
    sine, cosine = sp.sin(angle), sp.cos(angle)
    for kept, other in ((cosine, sine), (sine, cosine)):
        if rest.has(kept) and not rest.has(other):
            return expanded(in_one_ratio(inside, kept, other))
    return inside


def _parted(whole: sp.Expr, symbol: sp.Symbol) -> tuple[sp.Expr, sp.Expr, sp.Expr] | None:
    """A sum ``a√q + b`` as a, q and b; None of another one. The root may stand in two factors."""
    half = sp.Rational(1, 2)
    roots = [p for p in atoms_in(whole, sp.Pow) if p.exp == half and p.has(symbol)]
    names = [sp.Dummy(positive=True) for _ in roots]
    bare = whole.xreplace(dict(zip(roots, names, strict=True)))
    ratios = [ratio for ratio in (sp.sin(symbol), sp.cos(symbol)) if bare.has(ratio)]
    plain = bare.xreplace({ratio: sp.Dummy() for ratio in ratios})
    if not roots or symbol in inside_functions(plain) or not bare.is_polynomial(*names):
        return None
    poly = sp.Poly(bare, *names)
    if set(poly.monoms()) != {(0,) * len(roots), (1,) * len(roots)}:
        return None
    factor, rest = poly.nth(*(1 for _ in roots)), poly.nth(*(0 for _ in roots))
    common = sp.gcd(factor, rest)
    factor, rest = (expanded(cancelled(value / common)) for value in (factor, rest))
    if not all(value.is_polynomial(*(ratios or (symbol,))) for value in (factor, rest)):
        return None
    return factor, expanded(sp.Mul(*(root.base for root in roots))), rest


def _shortened(scene: Scene, number: int) -> int:
    """The line with its right side in one fraction, where that is much shorter."""
    link = scene.desk.last_link(number)
    short = tree_of(tidy(scene_value(scene, link.right)))
    if 2 * len(write_expression(short)) > len(write_expression(link.right)):
        return number
    return _rewritten(scene, number, chain(link.left, (short, None))) or number


def _rewritten(scene: Scene, number: int, relation: object) -> int | None:
    names = symbol_names(residual(scene, number))
    known: tuple[Ref, ...] = (*background(scene, names), *_given(scene, names))
    for move in (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras")):
        refs = scene.judge.enough(move, (number,), relation, known)  # type: ignore[arg-type]
        if refs is not None:
            return scene.desk.write(move, refs, relation)  # type: ignore[arg-type]
    return None


def _given(scene: Scene, names: Iterable[str]) -> tuple[Ref, ...]:
    return tuple(ref for ref in scene.judge.known(names) if ref in scene.facts)


def in_squares(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """An equation of the fourth degree in which only even powers stand: by the square."""
    above = numerator(residual(scene, number))
    if symbol**4 not in atoms_in(above, sp.Pow):
        return None
    if symbol in inside_functions(above) or not above.is_polynomial(symbol):
        return None
    poly = polynomial_in(above, symbol)
    if poly.degree() != 4 or poly.nth(3) != 0 or poly.nth(1) != 0:
        return None
    y = sp.Dummy("y", positive=True)
    whole = sum((poly.nth(2 * n) * y**n for n in range(3)), sp.Integer(0))
    squared: Callable[[sp.Expr], sp.Expr] = lambda value: tidy(value**2)  # noqa: E731
    source = by_roots(scene, number, whole, y, square(Letter(symbol.name)), symbol, squared)
    if source is None:
        return None
    (line,) = (ref for ref in source.refs if isinstance(ref, int))
    return _of_square(scene, line, symbol)


def _of_square(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """An unknown by its square, which a line says: both roots, and the one that is excluded."""
    value = sp.sympify(scene.final(symbol), strict=True)
    kept = [root for root in (value, -value) if is_reached(scene, root, itself, symbol)]
    first, last = (
        (value, -value) if scene.model.sign(scene.model.in_data(value)) > 0 else (-value, value)
    )
    own = as_square(tidy(expanded(value**2)))
    if own is not None:
        shown = chain(square(Letter(symbol.name)), (own, None))
        line = scene.judge.write((Move("rearrange"),), [line], shown) or line
    options = [option(Letter(symbol.name), value) for value in (first, last)]
    alternatives = Relation(tuple(options))
    refs = scene.judge.enough(
        Move("roots"), (line,), alternatives, background(scene, {symbol.name})
    )
    if refs is None:
        return None
    number = scene.desk.write(Move("roots"), refs, alternatives)
    if len(kept) == 1:
        number = rejected(scene, number, symbol, Letter(symbol.name), kept)
    else:
        scene.desk.splits += ((number, (first, last).index(value)),)
        scene.others = tuple(e for e in scene.others if is_value(e, value, itself, symbol))
    return known_as(scene, symbol, value, number)
