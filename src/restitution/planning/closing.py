"""An equation with one unknown becomes lines, by its shape."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import sympy as sp

from restitution.components import Model, proved_sign
from restitution.exact import tidy
from restitution.explaining.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Apply, Expression, Letter
from restitution.planning.angles import range_of
from restitution.planning.desk import NotPlannedError, Source, chain
from restitution.planning.forms import tree_of
from restitution.planning.impacts import residual
from restitution.planning.judging import Judge
from restitution.planning.scene import Scene


def close(scene: Scene, number: int, symbol: sp.Symbol) -> Source:
    """Solves a line for the only unknown in it. Raises NotPlannedError for other shapes."""
    for shape in _SHAPES:
        source = shape(scene, number, symbol)
        if source is not None:
            return source
    raise NotPlannedError(f"no way from line {number} to {symbol}")


def _already(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """The line says what the unknown is."""
    link = scene.desk.last_link(number)
    if link.left != Letter(symbol.name) or link.sign != "=":
        return None
    value = scene.final(symbol)
    if scene.model.identically_zero(_value(scene, link.right) - value):
        return _known(scene, symbol, value, number)
    return None


def _value(scene: Scene, tree: Expression) -> sp.Expr:
    from restitution.planning.impacts import scene_value

    return scene_value(scene, tree)


def _known(scene: Scene, symbol: sp.Symbol, value: Any, number: int) -> Source:
    return scene.desk.know(Letter(symbol.name), value, (number,))


def _linear(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """Linear in the unknown: it is made the subject."""
    above = _numerator(residual(scene, number))
    if symbol in _inside_functions(above):
        return None
    judge = Judge(scene)
    for each in (above, _uncertain(scene, above)):
        poly = sp.Poly(each, symbol)
        if poly.degree() != 1:
            continue
        value = tidy(-poly.nth(0) / poly.nth(1))
        relation = chain(Letter(symbol.name), (tree_of(value), None))
        names = (s.name for s in above.free_symbols)
        pool = (number, *nonzero(scene, poly.nth(1)), *judge.known(names))
        line = judge.write((Move("rearrange"), Move("cancel")), pool, relation)
        if line is not None:
            return _known(scene, symbol, value, line)
    return None


def _uncertain(scene: Scene, x: sp.Expr) -> sp.Expr:
    """An expression without the factors that are certain not to vanish."""
    factors = sp.Mul.make_args(sp.factor(x))
    kept = (each for each in factors if not proved_sign(scene.model.ground, each))
    return sp.expand(sp.Mul(*kept))


def _numerator(x: sp.Expr) -> sp.Expr:
    return sp.expand(sp.fraction(sp.together(x))[0])


def _inside_functions(x: sp.Expr) -> set[Any]:
    return {s for each in x.atoms(sp.Function) for s in each.free_symbols}


def not_negative(scene: Scene, size: sp.Expr) -> tuple[Ref, ...]:
    """What has to be known for the root of a square to be this, beyond what is silent."""
    odd = [
        each
        for each in sp.Mul.make_args(size)
        if not (each.is_Pow and (each.exp.is_even or each.exp == sp.Rational(1, 2)))
    ]
    return nonzero(scene, sp.Mul(*odd), alone=True)


def nonzero(scene: Scene, factor: sp.Expr, *, alone: bool = False) -> tuple[Ref, ...]:
    """What has to be known for a factor not to vanish, beyond what is silent."""
    refs: list[Ref] = []
    for each in sp.Mul.make_args(sp.factor(factor)):
        base = each.base if each.is_Pow else each
        for function in base.atoms(sp.sin, sp.cos):
            for angle in function.free_symbols:
                refs.append(range_of(scene, angle.name))
        for letter in sorted(base.free_symbols, key=lambda s: s.name):
            role = scene.model.unknowns.roles.get(letter.name)
            if role is not None and role.kind == "restitution" and (alone or base != letter):
                refs.append(f"{letter.name} >= 0")
    return tuple(dict.fromkeys(refs))


def _quadratic(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """A quadratic: its roots, and those that are excluded."""
    above = _numerator(residual(scene, number))
    if symbol in _inside_functions(above):
        return None
    return _by_roots(scene, number, above, symbol, Letter(symbol.name), symbol)


def _by_roots(
    scene: Scene,
    number: int,
    above: sp.Expr,
    generator: sp.Expr,
    subject: Expression,
    symbol: sp.Symbol,
) -> Source | None:
    factors = [(base, power) for base, power in sp.factor_list(above)[1] if base.has(generator)]
    if not factors or any(sp.Poly(base, generator).degree() > 2 for base, _ in factors):
        return None
    roots: list[sp.Expr] = []
    for base, _ in factors:
        roots += [tidy(each) for each in sp.roots(sp.Poly(base, generator))]
    roots = list(dict.fromkeys(roots))
    kept = [each for each in roots if _is_reached(scene, each, generator, symbol)]
    if not kept:
        return None
    wanted = [each for each in kept if _is_value(scene.model, each, generator, symbol)]
    if len(wanted) != 1:
        return None
    (value,) = wanted
    roots.sort(key=lambda each: each not in kept)
    line = scene.desk.write(
        Move("roots"), (number,), Relation(tuple(_option(subject, each) for each in roots))
    )
    dropped = [each for each in roots if each not in kept]
    if dropped:
        line = scene.desk.write(
            Move("reject"),
            (line, *_exclusion(scene, symbol, generator, dropped)),
            Relation(tuple(_option(subject, each) for each in kept)),
        )
    if len(kept) > 1:
        if scene.desk.split is not None:
            raise NotPlannedError("solutions that part twice")
        scene.desk.split = line, kept.index(value)
    if generator == symbol:
        return _known(scene, symbol, value, line)
    return scene.desk.know(subject, value, (line,))


def _option(subject: Expression, value: sp.Expr) -> tuple[Link, ...]:
    return (Link(subject, "=", tree_of(value)),)


def _is_value(model: Model, root: sp.Expr, generator: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether a root is what the unknown is by a solution."""
    final = model.final[symbol]
    target = final if generator == symbol else generator.func(final)
    return model.sign(root - target) == 0


def _is_reached(scene: Scene, root: sp.Expr, generator: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether a root is that of some solution of the part."""
    return any(
        _is_value(model, root, generator, symbol) for model in scene.others or (scene.model,)
    )


def _exclusion(
    scene: Scene, symbol: sp.Symbol, generator: sp.Expr, dropped: Sequence[sp.Expr]
) -> tuple[Ref, ...]:
    """By what the roots that are dropped are excluded."""
    role = scene.model.unknowns.roles.get(symbol.name)
    if role is None:
        raise NotPlannedError(f"nothing is known of {symbol}")
    if role.kind == "positive":
        return ()
    if role.kind == "angle":
        return (range_of(scene, symbol.name),)
    if role.kind != "restitution":
        raise NotPlannedError(f"nothing excludes a value of {symbol}")
    refs: list[Ref] = []
    for each in dropped:
        low = scene.model.sign(each) < 0
        refs.append(f"{symbol.name} >= 0" if low else f"{symbol.name} <= 1")
    return tuple(dict.fromkeys(refs))


def _ratio(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """An angle that stands in one ratio, or in its sine and cosine of one degree."""
    role = scene.model.unknowns.roles.get(symbol.name)
    if role is None or role.kind != "angle":
        return None
    own = residual(scene, number)
    functions = {each for each in own.atoms(sp.Function) if symbol in each.free_symbols}
    if any(each.args != (symbol,) for each in functions):
        return None
    found = {type(each) for each in functions}
    t = sp.Symbol("_t", real=True)
    if found == {sp.sin, sp.cos}:
        cosine = sp.cos(symbol)
        above = _numerator(own)
        mixed = sp.Poly(above, sp.sin(symbol), cosine)
        degrees = {sum(each) for each in mixed.monoms()}
        if len(degrees) != 1:
            return None
        put = sp.expand(above.subs(sp.sin(symbol), t * cosine) / cosine ** degrees.pop())
        kind: Callable[..., Any] = sp.tan
    elif len(found) == 1 and found <= {sp.sin, sp.cos, sp.tan}:
        (kind,) = found
        put = _numerator(own.subs(kind(symbol), t))
    else:
        return None
    subject = Apply(kind.__name__, Letter(symbol.name))
    above = _numerator(put)
    poly = sp.Poly(above, t)
    target = tidy(kind(scene.final(symbol)))
    if poly.degree() == 1:
        line = scene.desk.write(
            Move("rearrange"),
            (number, *nonzero(scene, poly.nth(1))),
            chain(subject, (tree_of(tidy(-poly.nth(0) / poly.nth(1))), None)),
        )
    else:
        again = above.subs(t, kind(symbol))
        if kind is sp.tan:
            again = sp.expand(again)
        source = _by_roots(scene, number, again, kind(symbol), subject, symbol)
        if source is None:
            return None
        (line,) = source.refs  # type: ignore[assignment]
        target = source.value
    scene.desk.know(subject, target, (line,))
    return inverse(scene, line, symbol)


def inverse(scene: Scene, line: int, symbol: sp.Symbol) -> Source:
    """The angle by its ratio."""
    value = scene.final(symbol)
    number = scene.desk.write(
        Move("inverse"),
        (line, range_of(scene, symbol.name)),
        chain(Letter(symbol.name), (tree_of(value, angle=True, as_it_is=True), None)),
    )
    return _known(scene, symbol, value, number)


_SHAPES: tuple[Callable[[Scene, int, sp.Symbol], Source | None], ...] = (
    _already,
    _ratio,
    _linear,
    _quadratic,
)
