"""Angles in their usual form: π/3, π − arctan(4/3), α."""

from __future__ import annotations

import math
from typing import Any

import sympy
from sympy import Add, Expr, Float, Integer, Mul, Rational, S

from restitution.exact.degrees import function_of
from restitution.exact.directions import direction_in_surds, direction_of, vector_of
from restitution.exact.numbers import is_nested, tidy_number, tidy_parts
from restitution.exact.plain_angles import has_plain_angles
from restitution.exact.simplicity import HALF, TOUCHED, UNREADABLE, cost, node_count
from restitution.exact.surds import root_is_nested
from restitution.exact.textbook import tidy
from restitution.exact.zero import is_zero
from restitution.work import remembered, spend


@remembered(1024)
def tidy_angle(expression: Any) -> Any:
    """An angle in radians in its usual form: ``pi/3``, ``pi - atan(4/3)``, ``alpha``.

    Recognised multiples of π/24 and π/10 are verified by exact algebra. Never raises but
    at a limit of work.
    """
    if not isinstance(expression, Expr) or expression.is_Atom:
        return expression
    if node_count(expression, TOUCHED) >= TOUCHED:
        return expression
    try:
        return _tidy_angle(expression)
    except UNREADABLE:
        return expression


def plain_angle(value: Any) -> Any:
    """An angle in radians in its usual form, if that has no inverse functions; else None.

    A number that is by its digits no multiple of what its degrees are multiples of has them, and
    no other form of it is sought.
    """
    if not value.free_symbols and not _may_be_plain(value):
        return None
    usual = tidy_angle(value)
    return None if usual.has(*_ARCS) else usual


_ARCS = (sympy.atan, sympy.acos, sympy.asin)


def _may_be_plain(value: Expr) -> bool:
    """Whether an angle is by its digits a multiple of half of what all degrees in it are."""
    ratios = value.atoms(sympy.sin, sympy.cos, sympy.tan)
    angles = (*(ratio.args[0] for ratio in ratios), *Add.make_args(value))
    turns = [angle / sympy.pi for angle in angles]
    below = math.lcm(24, 10, *(int(turn.q) for turn in turns if turn.is_Rational))
    count = (value / sympy.pi * 2 * below).evalf(40)
    return not count.is_real or abs(count - sympy.floor(count + HALF)) < Float("1e-15")


def _tidy_angle(value: Expr) -> Expr:
    spend()
    if value.free_symbols:
        return _tidy_angle_letters(value)
    value = _with_plain_angles(value)
    quotient = sympy.expand(value / sympy.pi)
    if quotient.is_Rational:
        return quotient * sympy.pi
    size = value.evalf(40)
    if value.has(sympy.CRootOf) and not _near_nice(size):
        return value  # nobody would write it out
    nested = _of_nested_tangent(value)
    if nested is not None and not _near_nice(size):
        return nested
    if not size.is_real:
        return tidy_parts(value)
    plain_angles = has_plain_angles(value)
    vector = None
    if not _near_nice(size):
        vector = vector_of(value) if plain_angles else direction_in_surds(value)
    if vector is not None and (plain_angles or root_is_nested(vector[0] ** 2 + vector[1] ** 2)):
        # Its cosine and sine are longer than its tangent.
        candidates = [_by_tangent(*vector)]
    else:
        direction = direction_of(value)
        if direction is None:
            return tidy_parts(value)
        cosine, sine = (tidy_number(component) for component in direction)
        turns = _nice(size, cosine, sine)
        if turns is not None:
            return turns * sympy.pi
        candidates = _candidates(cosine, sine)
    best = min(candidates, key=lambda candidate: candidate[0])
    pi = sympy.pi
    whole = Integer(sympy.floor((size - best[1].evalf(40)) / (2 * pi) + HALF))
    form = best[1] + 2 * pi * whole
    if abs((form - value).evalf(30)) > 1:  # of one direction, they are whole turns apart
        return tidy_parts(value)
    plain = tidy_parts(value)
    return form if cost(form) <= cost(plain) + 3 else plain


def _of_nested_tangent(value: Expr) -> Expr | None:
    """An arctangent of roots of sums of roots, perhaps beside a half turn, by a plain tangent.

    Its cosine and sine would be roots of such roots; None of any other angle.
    """
    turned, arc = value.as_independent(sympy.atan, as_Add=True)
    if not isinstance(arc, sympy.atan) or not is_nested(arc.args[0]):
        return None
    if not (turned / sympy.pi).is_Integer:
        return None
    tangent = _shorter_quotient(arc.args[0])
    if turned != 0 and not _is_positive(tangent):
        return turned - sympy.atan(-tangent)
    return turned + sympy.atan(tangent)


def _shorter_quotient(value: Expr) -> Expr:
    """A number in its usual form, or as a quotient of two such numbers where that is shorter."""
    plain = tidy_number(value)
    above, below = sympy.fraction(sympy.together(value))
    (first, above), (second, below) = (tidy_number(e).as_coeff_Mul() for e in (above, below))
    quotient = first / second * above / below
    return quotient if cost(quotient) < cost(plain) else plain


def _candidates(cosine: Expr, sine: Expr) -> list[tuple[float, Expr]]:
    """An angle by its tangent, cosine and sine, each with its cost."""
    # The quadrant is that of the direction: the angle itself may be too near to its end.
    ahead, left = _is_positive(cosine), _is_positive(sine)
    if cosine == 0 or sine == 0:
        return []
    candidates = [_by_tangent(cosine, sine)]
    if not tidy_number(sine / cosine).is_Rational:
        form = sympy.acos(cosine) if left else -sympy.acos(cosine)
        # 180° − arctan(…), −arctan(…) are what is written then
        obtuse = 4 if cosine.is_negative else 3 if not left else 0
        candidates.append((cost(form) + obtuse - (2 if cosine.is_Rational else 0), form))
        form = sympy.asin(abs(sine))
        form = form if ahead else sympy.pi - form
        form = form if left else -form
        candidates.append((cost(form) - (1 if sine.is_Rational else 0), form))
    return candidates


def _by_tangent(x: Expr, y: Expr) -> tuple[float, Expr]:
    """The angle of a vector by its tangent, with its cost."""
    ahead, left = _is_positive(x), _is_positive(y)
    tangent = tidy_number(y / x)
    if tangent.is_negative:
        tangent = -tangent
    form = sympy.atan(tangent)
    if left:
        form = form if ahead else sympy.pi - form
    else:
        form = -form if ahead else form - sympy.pi
    return cost(form) - (3 if tangent.is_Rational else 1), form


def _is_positive(number: Expr) -> bool:
    """Whether a number is above zero, by its digits where these tell."""
    size = number.evalf(20)
    return bool(size > 0) if abs(size) > Float("1e-9") else bool(number > 0)


def _near_nice(size: Expr) -> bool:
    """Whether an angle is within 10⁻²⁰ of one of the well-known fractions of π."""
    ratio = (size / sympy.pi).evalf(30)
    return any(
        abs(ratio * step - sympy.floor(ratio * step + HALF)) < Float("1e-20") for step in (24, 10)
    )


def _nice(size: Expr, cosine: Expr, sine: Expr) -> Rational | None:
    """The rational multiple of π that an angle is, if it is one of the well-known ones."""
    ratio = (size / sympy.pi).evalf(30)
    for step in (24, 10):
        nearest = Rational(int(sympy.floor(ratio * step + HALF)), step)
        if abs(ratio - nearest) < Float("1e-25"):
            angle = nearest * sympy.pi
            if _same_number(cosine, sympy.cos(angle)) and _same_number(sine, sympy.sin(angle)):
                return nearest
    return None


def _of_plain_angles(tangent: Expr) -> Rational | None:
    """The multiple of π whose tangent is made of sines and cosines of such multiples, if it is one.

    It is a multiple of half of what those all are multiples of, proved as an identity in that
    angle: arctan((1 - cos 50°)/sin 50°) = 25°.
    """
    parts = tangent.atoms(sympy.sin, sympy.cos, sympy.tan)
    turns = [x.args[0] / sympy.pi for x in parts]
    if not turns or not all(turn.is_Rational for turn in turns):
        return None
    below = math.lcm(*(int(turn.q) for turn in turns))
    unit = Rational(math.gcd(*(int(turn * below) for turn in turns)), 2 * below)
    count = (sympy.atan(tangent) / sympy.pi / unit).evalf(30)
    nearest = int(sympy.floor(count + HALF))
    counts = (*(turn / unit for turn in turns), nearest)
    if abs(count - nearest) > Float("1e-20") or any(abs(count) > 40 for count in counts):
        return None
    c, s = sympy.symbols("c s")

    def components(multiple: int) -> tuple[Expr, Expr]:
        """Cosine and sine of so many units, by the powers of c + is."""
        cosine, sine = S.One, S.Zero
        for _ in range(abs(multiple)):
            cosine, sine = sympy.expand(c * cosine - s * sine), sympy.expand(s * cosine + c * sine)
        return cosine, sine if multiple > 0 else -sine

    put = {}
    for x in parts:
        cosine, sine = components(int(x.args[0] / sympy.pi / unit))
        put[x] = {sympy.cos: cosine, sympy.sin: sine, sympy.tan: sine / cosine}[function_of(x)]
    cosine, sine = components(nearest)
    gap = sympy.together(tangent.xreplace(put) * cosine - sine).as_numer_denom()[0]
    if not gap.is_polynomial(c, s):
        return None
    return nearest * unit if sympy.rem(gap, s**2 + c**2 - 1, s) == 0 else None


def _with_plain_angles(value: Expr) -> Expr:
    """An angle in which each arctangent that is a plain angle is written as that angle."""
    plain = {}
    for atom in value.atoms(sympy.atan):
        if atom.free_symbols or not atom.args[0]:
            continue
        turns = _of_plain_angles(atom.args[0])
        if turns is None and (rest := _of_plain_angles(1 / atom.args[0])) is not None:
            # arctan(1/tan 10°) = 90° − 10°
            turns = (HALF if rest > 0 else -HALF) - rest
        if turns is not None:
            plain[atom] = turns * sympy.pi
    return value.xreplace(plain) if plain else value


def _same_number(a: Expr, b: Expr) -> bool:
    return a == b or tidy_number(sympy.expand(a - b)) == 0 or is_zero(a - b)


def _tidy_angle_letters(value: Expr) -> Expr:
    """Inverse functions of acute angles undone; what stands inside the others tidied."""
    numbers, rest = value.as_independent(*value.free_symbols, as_Add=True)
    terms = [_tidy_angle_term(term) for term in Add.make_args(rest)]
    if numbers != 0:
        terms.append(_tidy_angle(numbers))
    return Add(*terms)


def _tidy_angle_term(term: Expr) -> Expr:
    number, rest = term.as_coeff_Mul()
    if number not in (1, -1) and number.is_Rational:
        return number * _tidy_angle_term(rest)
    if number == -1:
        return -_tidy_angle_term(rest)
    if isinstance(rest, sympy.atan2):
        y, x = rest.args
        if not x.is_positive:
            return rest.func(tidy(y), tidy(x))
        rest = sympy.atan(y / x)
    if not isinstance(rest, sympy.atan | sympy.acos | sympy.asin):
        return tidy(rest) if not rest.has(sympy.atan, sympy.acos, sympy.asin) else rest
    inside = tidy(rest.args[0])
    quarter = sympy.pi / 2
    inner = {sympy.atan: sympy.tan, sympy.acos: sympy.cos, sympy.asin: sympy.sin}[rest.func]
    other = {sympy.acos: sympy.sin, sympy.asin: sympy.cos}.get(rest.func)
    if isinstance(inside, inner) and _acute(inside.args[0]):
        return inside.args[0]
    if other is not None and isinstance(inside, other) and _acute(inside.args[0]):
        return quarter - inside.args[0]
    if isinstance(rest, sympy.atan):
        half = _of_half_an_angle(inside)
        if half is not None:
            return half
        reciprocal = 1 / inside
        if isinstance(reciprocal, sympy.tan) and _acute(reciprocal.args[0]):
            return quarter - reciprocal.args[0]
        if inside.could_extract_minus_sign() and _negative_term(inside):
            return -_tidy_angle_term(sympy.atan(-inside))
    return rest.func(inside)


def _of_half_an_angle(tangent: Expr) -> Expr | None:
    """The angle whose tangent is sin a/(1 + cos a), or the like: half of a, or 90° less that.

    So it is with 90° − a: cos a/(1 + sin a) is the tangent of 45° − a/2.
    """
    angles = {sine.args[0] for sine in tangent.atoms(sympy.sin, sympy.cos)}
    if len(angles) != 1 or not tangent.free_symbols <= (whole := angles.pop()).free_symbols:
        return None
    if not _acute(whole):
        return None
    sine, cosine = sympy.sin(whole), sympy.cos(whole)
    quarter = sympy.pi / 2
    forms = {}
    for angle, s, c in ((whole, sine, cosine), (quarter - whole, cosine, sine)):
        forms[angle / 2] = (s, 1 + c), (1 - c, s)
        forms[quarter - angle / 2] = (1 + c, s), (s, 1 - c)
    above, below = sympy.fraction(sympy.together(tangent))
    for half, quotients in forms.items():
        if any(sympy.expand(above * b - below * a) == 0 for a, b in quotients):
            return sympy.expand(half)
    return None


def _negative_term(value: Expr) -> bool:
    return isinstance(value, Mul) and value.as_coeff_Mul()[0].is_negative is True


def _acute(value: Expr) -> bool:
    return bool(value.is_Symbol and value.is_positive)
