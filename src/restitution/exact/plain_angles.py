"""Products of cosines and sines of plain angles, such as 37°, merged into one.

``5 cos 70° cos 35° + 5 sin 70° sin 35°`` is ``5 cos 35°``, and ``sin 35° − √3 cos 35°`` is
``−2 cos 65°``: components of a velocity at one angle along a line at another. A number is told as a
sum of cosines of multiples of π; those whose angles differ by multiples of 15°, of which all ratios
are surds, make one.
"""

from __future__ import annotations

import math
from fractions import Fraction

import sympy
from sympy import Add, Expr, Mul, Pow, Rational, S

from restitution.exact import degrees
from restitution.exact.numbers import tidy_number
from restitution.exact.simplicity import node_count
from restitution.exact.symbols import atoms_in
from restitution.work import remembered, spend

_STEP = Fraction(1, 12)
_RIGHT = Fraction(1, 2)
_POWERS = 6
_NEAR = 1e-6
_TERMS = 200

# The coefficient of the cosine of each multiple of π from 0 to 1; of 0 it is what stands alone.
_Cosines = dict[Fraction, Expr]


class _OtherError(Exception):
    """A number is no sum of products of cosines and surds."""


def merged(value: Expr) -> Expr:
    """The same with the cosines and sines of plain angles merged, wherever that is shorter."""
    if not has_plain_angles(value):
        return value
    return _merged(value)


def has_plain_angles(value: Expr) -> bool:
    """Whether there are cosines or sines of numbers, such as cos 35°."""
    return any(not sine.free_symbols for sine in atoms_in(value, sympy.sin, sympy.cos))


def plain_angles_in(value: Expr) -> set[Expr]:
    """The angles of the ratios in a number: 40° for 40° and 50°, whose ratios are the same."""
    ratios = atoms_in(value, sympy.sin, sympy.cos, sympy.tan)
    turns = (abs(ratio.args[0]) for ratio in ratios if not ratio.free_symbols)
    return {min(turn, sympy.pi / 2 - turn, key=abs) for turn in turns}


@remembered(2048)
def _merged(value: Expr) -> Expr:
    if value.is_Atom or isinstance(value, sympy.Function) or not has_plain_angles(value):
        return value
    spend()
    value = value.func(*map(_merged, value.args))
    if not isinstance(value, Add | Mul | Pow):
        return value
    if not value.free_symbols:
        return _of_number(value)
    if not isinstance(value, Add):
        number, rest = value.as_independent(*value.free_symbols, as_Add=False)
        return _of_number(number) * rest if has_plain_angles(number) else value
    numbers: dict[Expr, Expr] = {}
    for term in value.args:
        number, rest = term.as_independent(*value.free_symbols, as_Add=False)
        numbers[rest] = numbers.get(rest, S.Zero) + number
    return Add(*(_of_number(number) * rest for rest, number in numbers.items()))


@remembered(2048)
def _of_number(value: Expr) -> Expr:
    """A number, where its merged form is shorter."""
    if not has_plain_angles(value):
        return value
    in_roots = _in_roots(value)
    if in_roots is not None and node_count(in_roots, 2 * _TERMS) < node_count(value, 2 * _TERMS):
        return in_roots
    try:
        cosines = _cosines(value)
    except _OtherError:
        return _cancelled(value)
    own = _acute_angles(value)
    form = _in_ratios_of(value, Add(*_classes(cosines, kept=_STEP in own)))
    other = form.is_Add if len(own) > 1 else bool(_acute_angles(form) - own)
    other = other or not _roots(form) <= _roots(value)  # sin² 15° is not (2 − √3)/4
    if other and not _is_linear(value):
        return value  # 16 sin² 35° − 3, and not 5 − 8 sin 20°
    shorter = node_count(form, 2 * _TERMS) < node_count(value, 2 * _TERMS)
    return form if shorter else value


def _in_ratios_of(value: Expr, form: Expr) -> Expr:
    """A form with the ratios that a number has where both are the same: cos 50° for sin 40°."""
    ratios = {_cosine_of(sine): sine for sine in value.atoms(sympy.sin, sympy.cos)}
    own = {sine: ratios.get(_cosine_of(sine), sine) for sine in form.atoms(sympy.sin, sympy.cos)}
    return form.xreplace(own)


def _cosine_of(ratio: Expr) -> Fraction:
    """The angle of which a sine or cosine is the cosine, as a multiple of π."""
    turns = _turns(ratio.args[0])
    return turns if isinstance(ratio, sympy.cos) else _RIGHT - turns


def _acute_angles(value: Expr) -> set[Fraction]:
    """The angles of the ratios in a number as multiples of π, each as the one below 45° that has
    the same ratios. Raises _OtherError where one is no rational multiple.
    """
    turns = (_turns(sine.args[0]) % _RIGHT for sine in value.atoms(sympy.sin, sympy.cos))
    return {min(turn, _RIGHT - turn) for turn in turns}


def _in_roots(value: Expr) -> Expr | None:
    """A number with roots beside ratios of 15° or 75°, with roots for these: (√6 − √2) sin 15°.

    None of another number.
    """
    ratios = value.atoms(sympy.sin, sympy.cos)
    if not (_roots(value) and all(degrees.has_sums_of_surds(ratio.args[0]) for ratio in ratios)):
        return None
    put = {ratio: degrees.function_of(ratio)(ratio.args[0]) for ratio in ratios}
    return tidy_number(sympy.expand(value.xreplace(put)))


def _roots(value: Expr) -> set[Expr]:
    """The roots of numbers in a number."""
    return {power for power in value.atoms(Pow) if power.exp == S.Half}


def _is_linear(value: Expr) -> bool:
    """Whether no ratio in a sum stands beside another, or in a power."""
    ratios = value.atoms(sympy.sin, sympy.cos)
    return bool(sympy.Poly(value, *ratios).total_degree() == 1)


def _cancelled(value: Expr) -> Expr:
    """A quotient in which common factors of both sides are left out, where that is shorter.

    ``½(4 + 3(10 cos 42° − 12)/(10 cos 42°)) cos 42°`` is ``(35 cos 42° − 18)/10``.
    """
    ratios = sorted(value.atoms(sympy.sin, sympy.cos), key=sympy.default_sort_key)
    put = {ratio: sympy.Dummy() for ratio in ratios}
    plain = value.xreplace(put)
    if not plain.is_rational_function(*put.values()):
        return value
    sums = (node for node in sympy.preorder_traversal(plain) if isinstance(node, Add))
    is_one_quotient = not any(
        sympy.fraction(argument)[1].free_symbols for sum_ in sums for argument in sum_.args
    )
    sides = (value.atoms(Rational) for value in sympy.fraction(plain))
    if is_one_quotient and any(not value.is_Integer for side in sides for value in side):
        return value  # (3.6 sin 25°)/0.58 would become a quotient of whole numbers
    above, below = sympy.fraction(sympy.cancel(plain))
    back = {letter: ratio for ratio, letter in put.items()}
    above, below = above.xreplace(back), below.xreplace(back)
    if below.is_Add and below.evalf(20).is_negative:
        above, below = -above, -below
    form = above / below
    return form if node_count(form, 2 * _TERMS) <= node_count(value, 2 * _TERMS) else value


def _cosines(value: Expr) -> _Cosines:
    """A number as a sum of cosines. Raises _OtherError where it is none."""
    if not value.has(sympy.sin, sympy.cos):
        return {Fraction(0): value}
    match value:
        case sympy.cos():
            return {_angle(value.args[0]): S.One}
        case sympy.sin():
            return _cosine(_RIGHT - _turns(value.args[0]), S.One)
        case Add():
            total: _Cosines = {}
            for term in value.args:
                for angle, number in _cosines(term).items():
                    total[angle] = total.get(angle, S.Zero) + number
            return total
        case Mul():
            return _product([_cosines(factor) for factor in value.args])
        case Pow() if value.exp.is_Integer and 1 < value.exp <= _POWERS:
            return _product([_cosines(value.base)] * int(value.exp))
    raise _OtherError


def _product(factors: list[_Cosines]) -> _Cosines:
    """2 cos α cos β = cos(α − β) + cos(α + β)."""
    result: _Cosines = {Fraction(0): S.One}
    for factor in factors:
        if len(result) * len(factor) > _TERMS:
            raise _OtherError
        product: _Cosines = {}
        for a, x in result.items():
            for b, y in factor.items():
                for angle in (a - b, a + b):
                    for own, number in _cosine(angle, sympy.expand(x * y) / 2).items():
                        product[own] = product.get(own, S.Zero) + number
        result = product
    return result


def _turns(angle: Expr) -> Fraction:
    """An angle as a multiple of π. Raises _OtherError where it is no rational one."""
    turns = degrees.turns_of(angle)
    if turns is None:
        raise _OtherError
    return turns


def _angle(angle: Expr) -> Fraction:
    turns = _turns(angle) % 2
    return min(turns, 2 - turns)


def _cosine(turns: Fraction, number: Expr) -> _Cosines:
    """A multiple of a cosine of any angle, by the angle from 0 to π that has the same."""
    turns %= 2
    return {min(turns, 2 - turns): number}


def _classes(cosines: _Cosines, kept: bool) -> list[Expr]:
    """One term for all cosines whose angles differ by multiples of 15°, or add up to one.

    The cosines of 15° and 75° themselves are ``kept``, or have roots.
    """
    classes: dict[Fraction, list[tuple[Fraction, Expr, Expr]]] = {}
    for turns, number in cosines.items():
        rest = turns % _STEP
        sign = 1
        if 2 * rest > _STEP:  # cos α = cos(−α)
            rest, sign = _STEP - rest, -1
        if kept and not rest and not degrees.is_standard(turns):
            rest = _STEP  # cos 75° by cos 15° and sin 15°, and not by roots
        is_plain = kept or bool(turns % _STEP)
        cosine = _plain(turns) if is_plain else degrees.cosine_beside(turns, cosines)
        own = sign * turns - rest, number, tidy_number(number) * cosine
        classes.setdefault(rest, []).append(own)
    terms: list[Expr] = []
    for rest, members in classes.items():
        one = _term(rest, members) if len(members) > 1 or not rest else None
        terms.extend([term for *_, term in members] if one is None else [one])
    return terms


def _radians(turns: Fraction) -> Expr:
    """A multiple of π as an angle."""
    return Rational(turns.numerator, turns.denominator) * sympy.pi


def _term(rest: Fraction, members: list[tuple[Fraction, Expr, Expr]]) -> Expr | None:
    """Cosines of ρ and further angles as one cosine; None where no multiple of 15° makes one."""
    # cos(ρ + φ) = cos ρ cos φ − sin ρ sin φ
    pairs = [(number, _radians(further)) for further, number, _ in members]
    a = tidy_number(Add(*(number * sympy.cos(angle) for number, angle in pairs)))
    b = tidy_number(Add(*(-number * sympy.sin(angle) for number, angle in pairs)))
    if not rest:
        return a
    # b cos φ = a sin φ: then it is R cos(ρ − φ) with a = R cos φ, b = R sin φ.
    steps = math.atan2(float(b.evalf(20)), float(a.evalf(20))) % math.pi / (math.pi * _STEP)
    further = round(steps)
    if abs(steps - further) > _NEAR:
        return None
    turn = further % 12 * _STEP
    cosine, sine = sympy.cos(_radians(turn)), sympy.sin(_radians(turn))
    if tidy_number(sympy.expand(b * cosine - a * sine)) != 0:
        return None
    part, ratio = (a, cosine) if cosine != 0 else (b, sine)
    size = tidy_number(sympy.expand(part * sympy.radsimp(1 / ratio)))
    return size * _plain(rest - turn)


def _plain(turns: Fraction) -> Expr:
    """A cosine by that of an acute angle, or by the sine of an angle below 45°."""
    acute = min(turns % 2, -turns % 2)
    sign = 1
    if acute > _RIGHT:
        acute, sign = 1 - acute, -1
    if 2 * acute > _RIGHT:
        return sign * degrees.sine(_RIGHT - acute)
    return sign * degrees.cosine(acute)
