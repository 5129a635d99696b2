"""Where a letter comes to its greatest or least value, as another letter comes to some place."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.expression.tree import Apply, Expression, Letter
from restitution.planning.writing.polynomials import expanded, polynomial_in
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles

_STEP, _CLOSE = sp.Float("1e-9"), 1e-3

_INVERSES = {"sin": sp.asin, "cos": sp.acos, "tan": sp.atan}


def comes_to(scene: Scene, name: str, bound: sp.Expr, over: sp.Symbol, place: sp.Expr) -> bool:
    """Whether the value of a letter comes to a ``bound`` as the other one comes to a place.

    An equation that has no solution there says nothing: so it is tried close to the place.
    """
    final = {symbol.name: value for symbol, value in scene.model.final.items()}
    if name in final:
        return _nears(scene, final[name], over, place, bound)
    letter = roles(scene.problem)[name].symbol(name)
    return over.name in final and _nears(scene, final[over.name], letter, bound, place)


def letter_within(tree: Expression) -> Letter | None:
    """The letter that is asked for, or of which a ratio is."""
    match tree:
        case Letter() as letter:
            return letter
        case Apply("sin" | "cos" | "tan", Letter() as letter):
            return letter
    return None


def worth_within(tree: Expression, value: sp.Expr) -> sp.Expr:
    """What a letter is where it, or a ratio of it, has a value."""
    match tree:
        case Apply("sin" | "cos" | "tan" as ratio, _):
            return _INVERSES[ratio](value)
    return value


def _nears(
    scene: Scene, value: sp.Expr, letter: sp.Symbol, place: sp.Expr, wanted: sp.Expr
) -> bool:
    """Whether an expression is close to what is wanted where a letter is close to a place."""
    sample = scene.model.branch.sample
    data = {
        symbol: sp.Float(float(sample[symbol.name]))
        for expression in (value, place, wanted)
        for symbol in expression.free_symbols - {letter}
        if symbol.name in sample
    }
    near = (sp.N(value.subs({**data, letter: place.subs(data) + step})) for step in (_STEP, -_STEP))
    goal = sp.N(wanted.subs(data))
    return any(bool(value.is_real) and abs(value - goal) < _CLOSE for value in near)


def roots_by_a_root(gap: sp.Expr, symbol: sp.Symbol) -> list[sp.Expr] | None:
    """The values of a letter at which an expression of it and of its root, √k, is zero.

    None where it is no polynomial in the root.
    """
    root = sp.Dummy("t", positive=True)
    by_root = expanded(gap.subs(symbol, root**2))
    if not gap.has(sp.sqrt(symbol)) or not by_root.is_polynomial(root):
        return None
    own = sorted(sp.roots(polynomial_in(by_root, root)), key=sp.default_sort_key)
    return [tidy(expanded(value**2)) for value in own if value.is_positive]


__all__ = ["comes_to", "letter_within", "roots_by_a_root", "worth_within"]
