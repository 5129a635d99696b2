"""Letters in which an answer is to be given: where the solution has them by others, turned round.

``find speed(P) in terms of u, e``, where the facts say e = 1/tan²α: then α is what has to go, and
tan α = 1/√e.
"""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.expression.tree import Apply, Expression, Letter
from restitution.planning.writing.desk import Desk
from restitution.planning.writing.polynomials import expanded, factored, one_fraction, polynomial_in


def turn_round(model: Model, wanted: frozenset[str]) -> bool:
    """Expresses by the ``wanted`` letters another one, of which the solution makes one of them.

    Returns whether there is such a letter.
    """
    own_roles, turned = model.unknowns.roles, False
    for symbol in [value for value in model.final if value.name in wanted & own_roles.keys()]:
        value = model.final[symbol]
        others = [symbol for symbol in value.free_symbols if symbol.name not in wanted]
        if any(value.name not in own_roles for value in others):
            continue
        if len(others) > 1:  # of several letters that may go it is one that is no angle
            plain = [value for value in others if own_roles[value.name].kind != "angle"]
            others = sorted(plain, key=str, reverse=True)
        inverses = ((other, _inverse(model, symbol, value, other)) for other in others)
        other, changes = next(((e, own) for e, own in inverses if own), (symbol, None))
        if changes is None:
            continue
        turned = True
        del model.final[symbol]
        for letter in list(model.final):
            model.final[letter] = _put(model.final[letter], changes)
        model.final[other] = changes[other]
        for key, component in model.components.items():
            model.components[key] = replace(component, value=model.final[component.symbol])
    return turned


def standing_ties(desk: Desk, model: Model) -> frozenset[str]:
    """Letters by which lines have another one, where the solution has them by that one.

    Of cos²α = 1/(4(1 − e²)) that an earlier part found, e is not found once more by α.
    """
    names: set[str] = set()
    for symbol, value in model.final.items():
        for other in value.free_symbols if symbol.name in model.unknowns.roles else ():
            own: Expression = Letter(str(other))
            trees: list[Expression] = [own, *(Apply(ratio, own) for ratio in ("sin", "cos", "tan"))]
            standing = (desk.known(tree) for tree in trees)
            if any(e and symbol in sp.sympify(e.value, strict=True).free_symbols for e in standing):
                names.add(symbol.name)
    return frozenset(names)


def _inverse(
    model: Model, symbol: sp.Symbol, value: sp.Expr, other: sp.Symbol
) -> dict[sp.Expr, sp.Expr] | None:
    """What a letter, and each ratio of it, is by another of which a value is known."""
    role = model.unknowns.roles[other.name]
    t = sp.Dummy("t", positive=True)
    if role.kind == "angle":
        if role.low != 0 or role.high != sp.pi / 2:
            return None
        size = sp.sqrt(1 + t**2)
        ratios = {sp.sin(other): t / size, sp.cos(other): 1 / size, sp.tan(other): t}
        x = sp.simplify(value.xreplace(ratios))
    else:
        x = value.xreplace({other: t})
    if other in x.free_symbols:
        return None
    own: sp.Expr = symbol
    if x.has(sp.atan2):
        # An acute angle by its cosine.
        x, own = sp.simplify(sp.cos(x)), sp.cos(symbol)
    gap = own - x
    if not x.is_rational_function(t):
        gap = own**2 - sp.simplify(x**2)  # a root: both sides squared
    above = sp.fraction(factored(one_fraction(expanded(gap))))[0]
    try:
        poly = polynomial_in(expanded(above), t)
    except sp.PolynomialError:
        return None
    powers = {n for (n,) in poly.monoms()}
    if powers == {0, 1}:
        root = tidy(factored(-poly.nth(0) / poly.nth(1)))
    elif powers == {0, 2}:
        root = sp.sqrt(tidy(factored(-poly.nth(0) / poly.nth(2))))
    elif powers == {0, 1, 2} and role.kind != "angle":
        one = _of_two(model, symbol, poly, other)
        if one is None:
            return None
        root = one
    else:
        return None
    if role.kind != "angle":
        return {other: root}
    size = sp.sqrt(tidy(factored(1 + root**2)))
    return {
        sp.sin(other): tidy(root / size),
        sp.cos(other): tidy(1 / size),
        sp.tan(other): root,
        other: sp.atan(root),
    }


def _of_two(model: Model, symbol: sp.Symbol, poly: sp.Poly, other: sp.Symbol) -> sp.Expr | None:
    """The root of a quadratic that a letter is at the numbers of the solution."""
    a, b, c = (poly.nth(n) for n in (2, 1, 0))
    size = tidy(sp.sqrt(factored(b**2 - 4 * a * c)))
    size = size.replace(sp.Abs, lambda x: x if model.sign(x.xreplace(model.final)) >= 0 else -x)
    for sign in (1, -1):
        root = tidy((-b + sign * size) / (2 * a))
        if model.sign(root.xreplace({symbol: model.final[symbol]}) - other) == 0:
            return root
    return None


def _put(x: sp.Expr, changes: dict[sp.Expr, sp.Expr]) -> sp.Expr:
    """An expression with the ratios of a letter put in, and then the letter."""
    ratios = {term: value for term, value in changes.items() if not term.is_Symbol}
    rest = {symbol: value for symbol, value in changes.items() if symbol.is_Symbol}
    return tidy(x.xreplace(ratios).xreplace(rest))
