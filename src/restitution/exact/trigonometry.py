"""Expressions in the sine, cosine and tangent of an angle, by sin² + cos² = 1 and by tangents.

In an algebraic expression a letter stands for each function of an angle (`MaskedAngle`). Whoever
needs a quotient of sines and cosines in another form takes it from here.
"""

from __future__ import annotations

from functools import cached_property

import sympy
from sympy import Add, Dummy, Expr, Mul, Pow, S, Symbol

from restitution.exact.factors import factored
from restitution.exact.simplicity import MASKED, TERMS, cost
from restitution.exact.symbols import atoms_in
from restitution.records import dataclass
from restitution.work import spend

_MOST_DEGREES_APART = 6


@dataclass(frozen=True)
class MaskedAngle:
    """The letters that stand for the sine, cosine and tangent of an angle."""

    sine: Symbol
    cosine: Symbol
    tangent: Symbol

    @classmethod
    def numbered(cls, number: int, positive: bool) -> MaskedAngle:
        """The letters of one of several angles, the same each time; an acute angle's are positive.

        What was done with them before is remembered.
        """
        kind = {"positive": True} if positive else {"real": True}
        return cls(*(Dummy(name, number, **kind) for name in MASKED))


def masked_angles(value: Expr) -> list[MaskedAngle]:
    """The angles of which letters stand in an expression."""
    letters = (x for x in value.free_symbols if isinstance(x, Dummy) and x.name in MASKED)
    kinds = {letter.dummy_index: bool(letter.is_positive) for letter in letters}
    return [MaskedAngle.numbered(number, kinds[number]) for number in sorted(kinds)]


def in_sines(value: Expr, angle: Expr | None = None) -> Expr:
    """Tangents and cotangents, of all angles or of one, as quotients of sines and cosines.

    These have values where a tangent has none.
    """
    for function, above, below in (
        (sympy.cot, sympy.cos, sympy.sin),
        (sympy.tan, sympy.sin, sympy.cos),
    ):
        put = {
            ratio: above(ratio.args[0]) / below(ratio.args[0])
            for ratio in atoms_in(value, function)
            if angle is None or ratio.args[0] == angle
        }
        value = value.xreplace(put)
    return value


def in_one_ratio(value: Expr, kept: Expr, other: Expr) -> Expr:
    """A sum multiplied out, with other² = 1 − kept² for the sine and cosine of an angle."""
    value = sympy.expand(value)
    squares = {
        power: other ** (power.exp % 2) * (1 - kept**2) ** (power.exp // 2)
        for power in value.atoms(Pow)
        if power.base == other and power.exp.is_Integer and power.exp > 1
    }
    return sympy.expand(value.xreplace(squares)) if squares else value


def has_cotangents_alone(value: Expr) -> bool:
    """Whether there are cotangents, secants or cosecants, and no tangents."""
    return value.has(sympy.cot, sympy.sec, sympy.csc) and not value.has(sympy.tan)


def in_tangents(value: Expr) -> Expr:
    """Tangents for cotangents, secants and cosecants."""
    return value.rewrite([sympy.cot, sympy.sec, sympy.csc], sympy.tan)


def has_tangent_letter(value: Expr) -> bool:
    """Whether a letter in an algebraic expression stands for a tangent."""
    return any(isinstance(x, Dummy) and x.name == "tan" for x in value.free_symbols)


def is_sum_over_product(value: Expr) -> bool:
    """Whether a sum with tangents stands over a product: (a tan α + b)/tan α."""
    above, below = sympy.fraction(value)
    apart = isinstance(above, Add) and below is not S.One and not isinstance(below, Add)
    return apart and has_tangent_letter(value)


def over_terms(value: Expr) -> Expr:
    """(a tan α + b)/tan α as a + b/tan α."""
    above, below = sympy.fraction(value)
    return Add(*[term / below for term in above.args])


class InOneAngle:
    """An algebraic expression as a quotient of polynomials in the sine and cosine of an angle."""

    def __init__(self, value: Expr, angle: MaskedAngle) -> None:
        self.value = value
        self.angle = angle

    @cached_property
    def forms(self) -> dict[str, tuple[Expr, Expr]]:
        """Numerators and denominators by what was done with them, each pair once; none below zero.

        There are none where nothing can come of it.
        """
        s, c, t = self.angle.sine, self.angle.cosine, self.angle.tangent
        spend()
        raw = self.value
        if t in raw.free_symbols:
            raw = sympy.together(raw.xreplace({t: s / c}))
        sides = [sympy.expand(side) for side in sympy.fraction(sympy.together(raw))]
        if any(len(Add.make_args(side)) > TERMS for side in sides):
            return {}
        try:
            pair = [sympy.Poly(side, s, c) for side in sides]
        except sympy.PolynomialError:
            return {}
        degrees = [poly.total_degree() for poly in pair]
        if max(degrees) < 2 and t not in self.value.free_symbols and min(degrees) == 0:
            return {}
        forms = {"a sine over a cosine": (sides[0], sides[1])}
        for name, first, second in (
            ("squares of cosines by sines", c, s),
            ("squares of sines by cosines", s, c),
        ):
            forms[name] = (
                in_one_ratio(sides[0], second, first),
                in_one_ratio(sides[1], second, first),
            )
        level = [_homogeneous(poly, s, c) for poly in pair]
        if level[0] is not None and level[1] is not None:
            forms["one degree"] = (level[0], level[1])
        names = {form: name for name, form in reversed(forms.items()) if form[1] != 0}
        return {name: form for name, form in forms.items() if names.get(form) == name}

    def as_(self, name: str) -> Expr:
        """The quotient in one of these forms."""
        above, below = self.forms[name]
        return factored(above / below)

    @cached_property
    def quotients_in_tangents(self) -> list[Expr]:
        """Those of the forms that are homogeneous, divided by powers of the cosine."""
        return [own for form in self.forms.values() for own in _in_tangent(form, self.angle)]

    def as_tangents(self) -> Expr:
        """The shortest of the quotients in the tangent."""
        return min(map(factored, self.quotients_in_tangents), key=cost)


def is_of_two_angles(value: Expr) -> bool:
    """Whether a sum of two terms is a multiple of a sine or cosine of a sum of angles."""
    return isinstance(value, Add) and _of_two_angles(value) is not None


def of_two_angles(total: Expr) -> Expr:
    """sin(α − θ) for sin α cos θ − cos α sin θ, and so on."""
    form = _of_two_angles(total)
    return total if form is None else form


def _of_two_angles(total: Expr) -> Expr | None:
    if len(total.args) != 2:
        return None
    first, second = total.args
    trigonometric = [
        {f for f in Mul.make_args(term) if isinstance(f, sympy.sin | sympy.cos)}
        for term in (first, second)
    ]
    if any(len(functions) != 2 for functions in trigonometric):
        return None
    angles = sorted(
        {f.args[0] for functions in trigonometric for f in functions}, key=sympy.default_sort_key
    )
    if len(angles) != 2 or any(len({f.args[0] for f in x}) != 2 for x in trigonometric):
        return None
    a, b = angles
    sines, cosines = (sympy.sin(a), sympy.sin(b)), (sympy.cos(a), sympy.cos(b))
    for left, right, function in (
        (sines[0] * cosines[1], cosines[0] * sines[1], sympy.sin),
        (cosines[0] * cosines[1], -sines[0] * sines[1], sympy.cos),
    ):
        for x, y in ((first, second), (second, first)):
            factor, other = x / left, y / right
            if factor == other:
                return factor * function(a + b)
            if factor == -other:
                return factor * function(a - b)
    return None


def _homogeneous(poly: sympy.Poly, s: Symbol, c: Symbol) -> Expr | None:
    """A polynomial raised to one degree in s and c by factors s² + c² = 1, or None."""
    degrees = [sum(powers) for powers, _ in poly.terms()]
    top = max(degrees)
    if any((top - degree) % 2 for degree in degrees) or top - min(degrees) > _MOST_DEGREES_APART:
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
    while more > 1:
        rest, left_over = sympy.div(above, 1 + t**2, t)
        if left_over != 0:
            break
        above, more = rest, more - 2  # (1 + tan²α) cos²α = 1
    whole = above / below * c**more
    return [whole, whole * s / (c * t)] if more > 0 else [whole]
