"""Variants of an expression by sin² + cos² = 1 and by tangents."""

from __future__ import annotations

import sympy
from sympy import Add, Expr, S, Symbol

from restitution.exact.factors import factored
from restitution.exact.simplicity import TERMS, cost
from restitution.records import dataclass
from restitution.work import spend


@dataclass(frozen=True)
class MaskedAngle:
    """An angle with the positive letters that stand for its sine, cosine and tangent."""

    argument: Expr
    sine: Symbol
    cosine: Symbol
    tangent: Symbol


def in_sines(value: Expr) -> Expr:
    """Tangents and cotangents as quotients of sines and cosines.

    These have values where a tangent has none.
    """
    value = value.replace(sympy.cot, lambda angle: sympy.cos(angle) / sympy.sin(angle))
    return value.replace(sympy.tan, lambda angle: sympy.sin(angle) / sympy.cos(angle))


def with_angles(value: Expr, angles: list[MaskedAngle]) -> Expr:
    """The cheapest of the forms that differ in how sines, cosines and tangents are used."""
    best = factored(value)
    if len(angles) > 3:
        return best
    for angle in angles:
        form = _with_angle(best, angle)
        # A square of squares has become one square: 1 − sin²α in it is seen now.
        best = form if form == best else _with_angle(form, angle)
    return _divided(best) if any(a.tangent in best.free_symbols for a in angles) else best


def _divided(value: Expr) -> Expr:
    """(a tan α + b)/tan α as a + b/tan α, where that is shorter."""
    above, below = sympy.fraction(value)
    if below is S.One or isinstance(below, Add) or not isinstance(above, Add):
        return value
    terms = Add(*[term / below for term in above.args])
    return terms if cost(terms) < cost(value) - 1 else value


def _with_angle(best: Expr, angle: MaskedAngle) -> Expr:
    spend()
    s, c, t = angle.sine, angle.cosine, angle.tangent
    if t in best.free_symbols:
        raw = sympy.together(best.xreplace({t: s / c}))
    else:
        raw = best
    above, below = sympy.fraction(sympy.together(raw))
    above, below = sympy.expand(above), sympy.expand(below)
    if len(Add.make_args(above)) > TERMS or len(Add.make_args(below)) > TERMS:
        return best
    try:
        pair = [sympy.Poly(value, s, c) for value in (above, below)]
    except sympy.PolynomialError:
        return best
    degrees = [poly.total_degree() for poly in pair]
    if max(degrees) < 2 and t not in best.free_symbols and min(degrees) == 0:
        return best
    forms: list[tuple[Expr, Expr]] = [(above, below)]
    for first, second in ((c, s), (s, c)):
        forms.append(
            (
                _pythagoras(above, first, second),
                _pythagoras(below, first, second),
            )
        )
    level = [_homogeneous(poly, s, c) for poly in pair]
    if level[0] is not None and level[1] is not None:
        forms.append((level[0], level[1]))
    candidates = [best]
    done: set[tuple[Expr, Expr]] = set()
    for form in forms:
        if form[1] == 0 or form in done:
            continue
        done.add(form)
        candidates.append(factored(form[0] / form[1]))
    for form in list(done):
        candidates += map(factored, _in_tangent(form, angle))
    return min(candidates, key=cost)


def _pythagoras(value: Expr, first: Symbol, second: Symbol) -> Expr:
    """A polynomial with first² = 1 − second² used throughout."""
    if first not in value.free_symbols:
        return value
    poly = sympy.Poly(value, first)
    return sympy.expand(
        Add(
            *[
                coefficient * (1 - second**2) ** (power // 2) * first ** (power % 2)
                for (power,), coefficient in poly.terms()
            ]
        )
    )


def _homogeneous(poly: sympy.Poly, s: Symbol, c: Symbol) -> Expr | None:
    """A polynomial raised to one degree in s and c by factors s² + c² = 1, or None."""
    degrees = [sum(powers) for powers, _ in poly.terms()]
    top = max(degrees)
    if any((top - degree) % 2 for degree in degrees) or top - min(degrees) > 6:
        return None
    return sympy.expand(
        Add(
            *[
                coefficient
                * s ** powers[0]
                * c ** powers[1]
                * (s**2 + c**2) ** ((top - sum(powers)) // 2)
                for powers, coefficient in poly.terms()
            ]
        )
    )


def _in_tangent(form: tuple[Expr, Expr], angle: MaskedAngle) -> list[Expr]:
    """A quotient of homogeneous polynomials in sine and cosine, in the tangent.

    What is above by a degree is a cosine, or a sine: cos α tan²α, sin α tan α.
    """
    s, c, t = angle.sine, angle.cosine, angle.tangent
    degrees = []
    for value in form:
        terms = sympy.Poly(value, s, c).monoms()
        totals = {sum(powers) for powers in terms}
        if len(totals) != 1:
            return []
        degrees.append(totals.pop())
    above, below = (value.xreplace({s: t, c: S.One}) for value in form)
    more = degrees[0] - degrees[1]
    whole = above / below * c**more
    return [whole, whole * s / (c * t)] if more > 0 else [whole]
