"""Inequalities in letters: without factors of certain sign, and solved for a letter or a ratio."""

from __future__ import annotations

from itertools import chain
from typing import Any

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import in_one_ratio, tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Relation, Sign
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    letters,
)
from restitution.planning.writing.forms import difference, negative, product, square, tree_of
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factored,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles


def subject_of(relation: Relation) -> Expression | None:
    """The subject of a relation: what stands between two bounds, else a side.

    That is one which is a letter or a ratio of an angle, or its square, if the other is none.
    """
    links = relation.only
    if len(links) == 2 and links[0].right == links[1].left:
        return links[0].right
    sides = (links[0].left, links[0].right)
    plain = (side for side in sides if _is_one_letter(side))
    return next(chain(plain, (side for side in sides if letters(side))), None)


def _is_one_letter(tree: Expression) -> bool:
    match tree:
        case Letter() | Apply(_, Letter()):
            return True
        case Binary("^", base, Number()):
            return _is_one_letter(base)
    return False


def same(a: Relation, b: Relation) -> bool:
    """Whether two relations say the same, whichever way round they are written."""
    return content(a) == content(b)


def content(relation: Relation) -> frozenset[object]:
    """What a relation says: of each alternative, whichever way round it is written."""
    return frozenset(
        frozenset(
            (FLIPPED[e.sign], e.right, e.left)
            if e.sign in (">", ">=")
            else (e.sign, e.left, e.right)
            for e in links
        )
        for links in relation.options
    )


def certain(scene: Scene, x: sp.Expr) -> int | None:
    """The sign of a factor, where the letters alone make it certain; None where it is open."""
    sign = proved_sign(scene.model.ground, x)
    return sign or None


def isolated(scene: Scene, x: sp.Expr, symbol: sp.Symbol) -> tuple[Expression, sp.Expr] | None:
    """A letter, a ratio of it or a square of one, and what it is equal to if ``x = 0``."""
    form = linear_in(x, symbol, roles(scene.problem)[symbol.name].kind == "angle")
    if form is None:
        return None
    tree, _, a, b = form
    return tree, tidy(factored(-b / a))


def without_signs(scene: Scene, gap: sp.Expr, sign: Sign) -> tuple[Sign, sp.Expr] | None:
    """``gap sign 0`` without the factors whose signs are certain; None if it always holds.

    A factor below a line is not zero, so what holds of its reciprocal is strict, and holds of it.
    """
    above, below = sp.fraction(factored(one_fraction(gap)))
    kept: list[sp.Expr] = []
    sums: list[tuple[sp.Expr, bool]] = []
    turned = False
    for factor in sp.Mul.make_args(above):
        base, power = factor.as_base_exp()
        own = certain(scene, factor)
        if own is None:
            kept.append(base if power.is_Integer and power % 2 else factor)
        else:
            turned ^= own < 0
            if base.is_Add and power.is_odd:
                sums.append((base, own < 0))
    for divisor in sp.Mul.make_args(below):
        base, power = divisor.as_base_exp()
        if power.is_Integer and power % 2 == 0:
            continue
        # What stands below a line is not zero: so the ends of letters do not matter.
        own = certain(scene, divisor) or proved_sign(scene.model.inside, divisor)
        if own is None:
            if kept and sign not in _STRICT:
                return None
            kept.append(base if power.is_Integer else divisor)
            sign = _STRICT_OF[sign]
        elif own < 0:
            turned = not turned
    if not kept and turned == (sign[0] == ">"):
        # It never holds: what is left are the sums, which have the other sign.
        kept = [value for value, _ in sums]
        turned ^= sum(negative for _, negative in sums) % 2 == 1
    if not kept:
        return None
    if len(kept) > 1:
        return (FLIPPED[sign] if turned else sign), sp.Mul(*kept)
    # The sense of the inequality is kept, and the terms take the sign.
    return sign, expanded(-kept[0] if turned else kept[0])


def solve_linear(
    scene: Scene, sign: Sign, x: sp.Expr, wanted: Expression | None = None
) -> Link | None:
    """``P sign 0`` solved for the letter or the ratio in it, where it is linear in one."""
    x = _in_the_wanted_ratio(x, wanted)
    symbols = sorted(x.free_symbols, key=lambda s: s.name)
    names = None if wanted is None else letters(wanted)
    match wanted:
        case Binary("/", Letter(above), Letter()):
            symbols.sort(key=lambda s: s.name != above)
    for symbol in symbols:
        if names is not None and symbol.name not in names:
            continue
        if names is None and len(symbols) > 1:
            continue
        role = roles(scene.problem).get(symbol.name)
        if role is None:
            continue
        form = linear_in(x, symbol, role.kind == "angle")
        if form is None:
            continue
        tree, _, a, b = form
        slope = certain(scene, a)
        if slope is None:
            continue
        own = sign if slope > 0 else FLIPPED[sign]
        return Link(tree, own, tree_of(tidy(factored(-b / a))))
    return None


def _in_the_wanted_ratio(x: sp.Expr, wanted: Expression | None) -> sp.Expr:
    """An expression with squares of sines by cosines, or the other way, where a square of those is
    wanted.
    """
    match wanted:
        case Binary("^", Apply("sin" | "cos" as name, Letter()), Number()):
            ratios = {ratio.args[0]: ratio for ratio in x.atoms(getattr(sp, name))}
        case _:
            return x
    if len(ratios) != 1:
        return x
    ((angle, kept),) = ratios.items()
    other = sp.sin(angle) if name == "cos" else sp.cos(angle)
    if not x.has(other) or not x.is_polynomial(kept, other):
        return x
    if any(m[1] % 2 for m in polynomial_in(x, kept, other).monoms()):
        return x
    return expanded(in_one_ratio(x, kept, other))


def is_monic(scene: Scene, x: sp.Expr) -> bool:
    """Whether a condition is solved by moving a term to the other side."""
    if len(x.free_symbols) != 1:
        return False
    (symbol,) = x.free_symbols
    role = roles(scene.problem).get(symbol.name)
    form = linear_in(x, symbol, role is not None and role.kind == "angle")
    return form is not None and abs(form[2]) == 1


def linear_in(
    x: sp.Expr, symbol: sp.Symbol, angle: bool
) -> tuple[Expression, sp.Expr, sp.Expr, sp.Expr] | None:
    """A generator in which ``x = 0`` is linear: its tree, its value, its factor and the rest.

    A letter, its square, or a ratio of an angle or the square of one.
    """
    x = expanded(x)
    letter = Letter(symbol.name)
    if not angle:
        if symbol in {s for f in x.atoms(sp.Function) for s in f.free_symbols}:
            return None
        return _linear_poly(x, symbol, symbol, letter)
    functions = {f for f in x.atoms(sp.sin, sp.cos, sp.tan) if symbol in f.free_symbols}
    if any(f.args != (symbol,) for f in functions) or not functions:
        return None
    kinds = {type(f) for f in functions}
    t = sp.Dummy("t")
    if kinds == {sp.tan} or kinds == {sp.sin} or kinds == {sp.cos}:
        (kind,) = kinds
        put = expanded(x.subs(kind(symbol), t))
        return _linear_poly(put, t, kind(symbol), Apply(kind.__name__, letter))
    if kinds != {sp.sin, sp.cos}:
        return None
    try:
        mixed = polynomial_in(x, sp.sin(symbol), sp.cos(symbol))
    except sp.PolynomialError:
        return None
    most = max(sum(monom) for monom in mixed.monoms())
    if any((most - sum(monom)) % 2 for monom in mixed.monoms()):
        return None
    # Each term takes powers of sin² + cos², until all are of one degree.
    put = sum(c * t**a * (1 + t**2) ** ((most - a - b) // 2) for (a, b), c in mixed.terms())
    return _linear_poly(expanded(put), t, sp.tan(symbol), Apply("tan", letter))


def _linear_poly(
    x: sp.Expr, t: sp.Symbol, value: sp.Expr, tree: Expression
) -> tuple[Expression, sp.Expr, sp.Expr, sp.Expr] | None:
    try:
        poly = polynomial_in(x, t)
    except sp.PolynomialError:
        return None
    powers = {m for (m,) in poly.monoms()}
    if powers <= {0, 1} and 1 in powers:
        return tree, value, poly.nth(1), poly.nth(0)
    if powers <= {0, 2} and 2 in powers:
        return square(tree), value**2, poly.nth(2), poly.nth(0)
    return None


def bounds(role: Any, generator: sp.Expr, symbol: sp.Symbol) -> list[tuple[Sign, sp.Expr]]:
    """The bounds of a letter, or of a ratio of it, by its role."""
    base, power = generator.as_base_exp()
    low, high = role.low, role.high
    ends: list[tuple[Sign, sp.Expr]] = []
    falling = isinstance(base, sp.cos)
    if role.kind == "angle" and (
        low is None or high is None or low < 0 or high > (sp.pi if falling else sp.pi / 2)
    ):
        return []
    if power == 2 and (low is None or low < 0 or (falling and high > sp.pi / 2)):
        return []
    for end, sign, closed in ((low, ">", role.closed[0]), (high, "<", role.closed[1])):
        if end is None:
            continue
        value = base.subs(symbol, end) ** power
        if not value.is_finite:
            continue
        own: Any = sign + ("=" if closed else "")
        ends.append((FLIPPED[own] if falling else own, value))
    return ends


_STRICT_OF: dict[Sign, Sign] = {"<": "<", "<=": "<", ">": ">", ">=": ">"}
_STRICT = ("<", ">")


def completed_parts(
    x: sp.Expr, symbol: sp.Symbol
) -> tuple[sp.Expr, sp.Rational, sp.Rational] | None:
    """a, p and r of the a((e − p)² + r) that an expression is, with numbers p and r.

    None of one that is of another degree, or has other letters in p or r.
    """
    if not x.is_polynomial(symbol):
        return None
    poly = polynomial_in(expanded(x), symbol)
    if poly.degree() != 2:
        return None
    lead, middle, rest = (factored(poly.nth(n)) for n in (2, 1, 0))
    least = cancelled(-middle / (2 * lead))
    more = cancelled(rest / lead - least**2)
    return (lead, least, more) if least.is_Rational and more.is_Rational else None


def completed_square(scene: Scene, x: sp.Expr) -> Expression | None:
    """A square of the second degree in one letter that is never zero: 2(e − ¼)² + 15/8.

    None of another expression, where the square says nothing or the letter has a root; and where
    every term has the same sign, as with 9 + 2e + 9e² and a letter that is not negative.
    """
    letters_ = x.free_symbols
    if len(letters_) != 1:
        return None
    (symbol,) = letters_
    parts = completed_parts(x, symbol)
    if parts is None:
        return None
    lead, least, more = parts
    if least == 0 or not more > 0:
        return None
    role = roles(scene.problem).get(symbol.name)
    if least < 0 and role is not None and role.low is not None and role.low >= 0:
        return None
    away = (
        difference(tree_of(symbol), tree_of(least))
        if least > 0
        else Binary("+", tree_of(symbol), tree_of(-least))
    )
    whole = product(tree_of(abs(lead)), square(away))
    completed = Binary("+", whole, tree_of(tidy(abs(lead) * more)))
    return completed if lead > 0 else negative(completed)
