"""Expressions of SymPy laid out in the order of factors and terms that textbooks use.

Number, surd, brackets in e, masses, other letters, further brackets, roots, functions.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction as Ratio
from functools import lru_cache
from typing import Any, Literal, NamedTuple

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, S, Symbol, ilcm

from restitution import exact
from restitution.exact.symbols import symbol_names
from restitution.render.layout.builders import (
    bracketed,
    fraction,
    function,
    letter,
    negative,
    power,
    product,
    split_sign,
    total,
)
from restitution.render.layout.nodes import (
    LONGEST,
    ONE,
    SIGNS,
    ZERO_VECTOR,
    Bold,
    Brackets,
    Coordinates,
    Degrees,
    Fraction,
    Layout,
    Letter,
    Number,
    Phrase,
    Power,
    Product,
    Relation,
    Root,
    Sum,
    Words,
)


def decimal_number(value: Any, figures: int = 3) -> Layout:
    """A number rounded to so many significant figures."""
    text = exact.significant(value, figures)
    size: Layout
    digits, _, tail = text.lstrip("-").partition(" × 10")
    size = Number(digits)
    if tail:
        plain = tail.translate(str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-"))
        exponent: Layout = Number(plain.lstrip("-"))
        exponent = negative(exponent) if plain.startswith("-") else exponent
        size = Product((size, Power(Number("10"), exponent)), "×")
    return negative(size) if text.startswith("-") else size


def vector(x: Any, y: Any) -> Layout:
    """``3**i** − 4**j**``: no zero components, no factor 1, sums in brackets, **0** for zero.

    Irrational components with a rational ratio have their common factor taken out:
    ``(1/√5)(**i** + 2**j**)``.
    """
    if not isinstance(x, Layout) and not isinstance(y, Layout):
        first, second = sympy.sympify(x, strict=True), sympy.sympify(y, strict=True)
        common = _common_surd(first, second)
        if common is not None:
            x, y = sympy.nsimplify(first / common), sympy.nsimplify(second / common)
            if x < 0 and y < 0:
                return negative(product(from_sympy(common), Brackets(vector(-x, -y))))
            return product(from_sympy(common), Brackets(vector(x, y)))
    sizes = (
        component if isinstance(component, Layout) else from_sympy(component)
        for component in (x, y)
    )
    terms = [
        _component(size, axis)
        for size, axis in zip(sizes, ("i", "j"), strict=True)
        if size != Number("0")
    ]
    return total(terms) if terms else ZERO_VECTOR


def _component(value: Layout, axis: str) -> Layout:
    sign, size = split_sign(value)
    term = product(size, Bold(axis))
    return Sum((("-", term),)) if sign == "-" else term


def _common_surd(x: Expr, y: Expr) -> Expr | None:
    if x.free_symbols or y.free_symbols or x.is_Rational or y.is_Rational:
        return None
    ratio = exact.tidy(y / x)
    if not isinstance(ratio, Rational):
        return None
    common = exact.tidy(x / ratio.q)
    if common.could_extract_minus_sign():
        common = exact.tidy(-common)
    return common if max(abs(ratio.p), ratio.q) < 100 else None


_NAMES = {
    "sin": "sin",
    "cos": "cos",
    "tan": "tan",
    "cot": "cot",
    "sec": "sec",
    "csc": "cosec",
    "asin": "arcsin",
    "acos": "arccos",
    "atan": "arctan",
    "log": "ln",
    "exp": "exp",
    "Max": "max",
    "Min": "min",
    "sign": "sgn",
}
_INVERSE = (sympy.atan, sympy.acos, sympy.asin, sympy.atan2)
DIRECT = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)
_ODD = (sympy.sin, sympy.tan, sympy.cot, sympy.csc)
_MASSES = ("m", "M")
_COEFFICIENTS = ("e", "f", "epsilon")
_RATIOS = ("k", "lambda", "mu", "nu")
_HALF = Rational(1, 2)


def from_sympy(value: Any, *, degrees: bool = False) -> Layout:
    """The layout of a SymPy expression, in the order in which a textbook writes it.

    With ``degrees`` the value is an angle in radians and is shown in degrees. Angles inside sine,
    cosine and tangent are always shown in degrees.
    """
    if isinstance(value, Expr):
        return _from_angle(value) if degrees else _from_expression(value)
    if isinstance(value, bool | int | Ratio):
        return from_sympy(sympy.sympify(value, strict=True), degrees=degrees)
    if isinstance(value, float):
        return decimal_number(sympy.Float(value))
    if isinstance(value, sympy.Set):
        return Words(str(value))
    if isinstance(value, tuple | sympy.Tuple):
        return Coordinates(tuple(from_sympy(component, degrees=degrees) for component in value))
    if isinstance(value, sympy.core.relational.Relational):
        sides = tuple(from_sympy(side, degrees=degrees) for side in (value.lhs, value.rhs))
        return Relation(sides, (SIGNS.get(value.rel_op, value.rel_op),))
    if isinstance(value, sympy.And | sympy.Or):
        word = " and " if isinstance(value, sympy.And) else " or "
        return Phrase(tuple(from_sympy(argument, degrees=degrees) for argument in value.args), word)
    return Words(str(value))


@lru_cache(maxsize=4096)
def _from_expression(value: Expr) -> Layout:
    if isinstance(value, Rational) and max(abs(value.p), value.q).bit_length() > LONGEST:
        return decimal_number(value)
    if isinstance(value, Rational):
        size = fraction(Number(str(abs(value.p))), Number(str(value.q)))
        return negative(size) if value.p < 0 else size
    if isinstance(value, Symbol):
        return letter(exact.canonical_name(value.name))
    if isinstance(value, sympy.Float):
        return decimal_number(value)
    if value is sympy.pi:
        return Letter("pi")
    if value is S.Infinity or value is S.NegativeInfinity:
        return Words("∞") if value is S.Infinity else negative(Words("∞"))
    if isinstance(value, Add):
        return _from_sum(value)
    if isinstance(value, Mul | Pow):
        return _from_product(value)
    if isinstance(value, sympy.Abs):
        inside = value.args[0]
        inside = exact.forward(inside) if isinstance(inside, Add) else inside
        return Brackets(_from_expression(inside), "||")
    if isinstance(value, DIRECT):
        return function(_NAMES[value.func.__name__], _from_angle(value.args[0]))
    if isinstance(value, sympy.atan2):
        # Neither sign is known: the direction of a vector says it all.
        y, x = value.args
        return Phrase((Words("direction of"), bracketed(vector(x, y))))
    name = value.func.__name__
    if isinstance(value, sympy.atan | sympy.asin) and _is_turned(value.args[0]):
        return negative(function(_NAMES[name], _from_expression(exact.tidy(-value.args[0]))))
    if name in _NAMES and value.args:
        arguments = [_from_expression(argument) for argument in value.args]
        if len(arguments) == 1:
            return function(_NAMES[name], arguments[0])
        return function(_NAMES[name], Phrase(tuple(arguments), ", "))
    if not value.free_symbols and exact.decimal(value) is not None:
        return decimal_number(value, 6)
    return Words(exact.sympy_text(value))


def _from_angle(value: Expr) -> Layout:
    """An angle: its multiple of π in degrees."""
    terms: list[tuple[bool, bool, Layout]] = []
    for term in Add.make_args(value):
        number = term / sympy.pi
        if isinstance(number, Rational):
            size: Layout = Degrees(plain_number(Ratio(int(abs(number.p)), int(number.q)) * 180))
            terms.append((number.p < 0, True, Sum((("-", size),)) if number.p < 0 else size))
        else:
            # SymPy may hold arctan(x) as −arctan(−x): the two signs meet here.
            turned = -term if _is_negative(term) else term
            layout = _from_expression(turned)
            layout = negative(layout) if turned != term else layout
            terms.append((split_sign(layout)[0] == "-", False, layout))
    # 180° − arctan(4/3), 90° + arctan(3/4), 90° − α, but α + 30°
    arcs = value.has(*_INVERSE)
    terms.sort(key=lambda term: (term[0], term[1] != arcs))
    return total([term[2] for term in terms])


def _is_turned(value: Expr) -> bool:
    """Whether a value is a negative number times letters, as SymPy's arctan may hold it."""
    number, _ = value.as_independent(*value.free_symbols, as_Add=False)
    return bool(number.is_negative)


def plain_number(value: Ratio) -> Layout:
    """A positive rational as a decimal where that is short, else as a fraction."""
    if 1000 % value.denominator == 0:
        whole, rest = divmod(value.numerator * (1000 // value.denominator), 1000)
        return Number(f"{whole}.{rest:03}".rstrip("0") if rest else str(whole))
    return Fraction(Number(str(value.numerator)), Number(str(value.denominator)))


def _from_sum(value: Add) -> Layout:
    terms = sorted(value.args, key=_term_order)
    others = [term for term in terms if term.free_symbols]
    numbers = [term for term in terms if not term.free_symbols]
    if others and numbers and not _numbers_first(others):
        terms = others + numbers
    positive = [term for term in terms if not _is_negative(term)]
    if positive and _is_negative(terms[0]):
        if not _is_negative(terms[-1]) and len(terms) > 2 and len(value.free_symbols) == 1:
            terms.reverse()
        else:
            terms.remove(positive[0])
            terms.insert(0, positive[0])
    return total([_from_expression(term) for term in terms])


def _is_negative(term: Expr) -> bool:
    coefficient = term if term.is_Rational else term.as_coeff_Mul()[0]
    return bool(coefficient.is_Rational and coefficient < 0)


def _numbers_first(others: list[Expr]) -> bool:
    """``1 + e``, ``1 − tan²α``, ``1 + k``; but ``k² + k + 1``, ``t + 1``, ``t² + 2t + 3``."""
    letters = set().union(*[other.free_symbols for other in others])
    if any(other.has(*DIRECT) for other in others):
        return True
    if any(_class(factor) == "coefficient" for factor in letters):
        return True
    return all(
        (other / other.as_coeff_Mul()[0]).is_Symbol
        and _class(next(iter(other.free_symbols))) == "ratio"
        for other in others
    )


def _term_order(term: Expr) -> tuple[Any, ...]:
    """Numbers, then powers of e ascending, then high powers first, then by the alphabet."""
    if not term.free_symbols:
        rational = 0 if term.is_Rational else 1
        return (0, False, rational, 0, (), cost_key(term))
    powers = term.as_powers_dict()
    ratio = 0
    other: Any = 0
    names: list[tuple[Any, ...]] = []
    for base, exponent in powers.items():
        if base.is_Symbol and _class(base) == "coefficient":
            ratio = ratio + exponent
        elif base.is_Symbol:
            other = other + exponent
            names.append((0, _alphabet(base)))
        elif base.free_symbols:
            names.append((1, str(base.func.__name__), _alphabet_of(base)))
    numeric = float(other) if getattr(other, "is_number", True) else 0.0
    return (
        1,
        term.has(*DIRECT),  # 1 − e + 2 tan²α
        float(ratio) if getattr(ratio, "is_number", True) else 0.0,
        -numeric,
        tuple(sorted(names, key=str)),
        str(term),
    )


def cost_key(term: Expr) -> tuple[float, str]:
    """A key that puts simple numbers before complicated ones."""
    return exact.cost(term), str(term)


def _alphabet(symbol: Symbol) -> tuple[bool, str, bool, str]:
    """The place of a letter among others: a time comes behind a speed, as in ut."""
    name = exact.canonical_name(symbol.name)
    head, _, tail = name.partition("_")
    return head == "t", head.lower(), head.isupper(), tail


def _alphabet_of(value: Expr) -> str:
    return " ".join(sorted(symbol_names(value)))


def _class(symbol: Symbol) -> Literal["coefficient", "ratio", "mass", "other"]:
    head = symbol.name.rstrip("_0123456789").split("_")[0]
    if head in _COEFFICIENTS:
        return "coefficient"
    if head in _RATIOS:
        return "ratio"
    return "mass" if head in _MASSES else "other"


LARGE_INSIDE = 10**6  # from here on a number is not multiplied out under a root of a higher index


LONG_SURD = 100  # from here on a root is not worth writing a second time, as in 11√185/185


def _one_higher_root(value: Expr) -> Layout | None:
    """A number below a root of an index above 2 that stands above its denominator: (1/10)^(1/6).

    SymPy has 10^(5/6)/10 for it. None of another product, and where the root is no shorter so.
    """
    rational, rest = value.as_coeff_Mul()
    if rational.p < 0:
        root = _one_higher_root(-value)
        return None if root is None else negative(root)
    powers = [factor.as_base_exp() for factor in Mul.make_args(rest)]
    if rational.q == 1 or rational.p != 1:
        return None
    if not all(base.is_Integer and base > 0 and exponent.is_Rational for base, exponent in powers):
        return None
    index = ilcm(1, *(exponent.q for _, exponent in powers))
    inside = rational**index * Mul(*(base ** (exponent * index) for base, exponent in powers))
    if index == 2 or not inside.is_Rational or inside.p * inside.q > rational.q**2:
        return None
    return Root(fraction(*map(_from_expression, inside.as_numer_denom())), int(index))


def _from_product(value: Expr) -> Layout:
    higher = _one_higher_root(value)
    if higher is not None:
        return higher
    sign = 1
    rational = S.One
    surds: list[Integer] = []
    above: list[tuple[Expr, Expr]] = []
    below: list[tuple[Expr, Expr]] = []
    roots_above: list[Expr] = []
    roots_below: list[Expr] = []
    other: list[Layout] = []
    for factor in Mul.make_args(value):
        base, exponent = factor.as_base_exp() if not factor.is_Rational else (factor, S.One)
        if isinstance(factor, Rational):
            rational *= factor
            continue
        if not isinstance(exponent, Rational) or exponent.q > 2:
            layout = _general_power(base, exponent)
            other.append(layout)
            continue
        if exponent.q == 2:
            whole, rest = divmod(int(exponent.p), 2)
            # Above the line a power 3/2 is 1 + 1/2; below it −3/2 is −1 − 1/2.
            if exponent.p < 0:
                whole, rest = -((-int(exponent.p)) // 2), -1
            if base.is_Integer and rest == 1 and whole == 0:
                surds.append(base)
            else:
                (roots_above if rest > 0 else roots_below).append(base)
                if whole:
                    (above if whole > 0 else below).append((base, Integer(abs(whole))))
            continue
        (above if exponent.p > 0 else below).append((base, abs(exponent)))
    _cubes_in_quotients(above, roots_above, roots_below)
    if rational.p < 0:
        rational = -rational
        sign = 1 if _turn_a_difference(above) or _turn_a_difference(below) else -1
    if not below and not roots_below:
        rational = _with_ones(rational, surds, above, roots_above)
    layout = _assemble(rational, surds, above, below, roots_above, roots_below, other)
    if isinstance(layout, Brackets) and layout.kind == "()":
        layout = layout.inside  # (4 − 3 sin²α)/4 is the sum 1 − ¾ sin²α
    return negative(layout) if sign < 0 else layout


def _cubes_in_quotients(
    above: list[tuple[Expr, Expr]], roots_above: list[Expr], roots_below: Sequence[Expr]
) -> None:
    """Leaves a cube of a letter below the root of a quotient: √(e³/(1 + e)), not e√(e/(1 + e))."""
    for place, base in enumerate(roots_above):
        if base.is_Symbol and (base, S.One) in above and any(e.is_Add for e in roots_below):
            above.remove((base, S.One))
            roots_above[place] = base**3


def _with_ones(
    rational: Rational,
    surds: list[Integer],
    above: list[tuple[Expr, Expr]],
    roots: list[Expr],
) -> Rational:
    """1 − ¾ sin²α for (4 − 3 sin²α)/4, u√(1 − ½ sin²α) for u√((2 − sin²α)/2); what is left over.

    The sums change where they stand.
    """
    if rational.p != 1 or rational.q == 1:
        return rational
    divisor = Integer(rational.q)
    for place, (base, exponent) in enumerate(above):
        if exponent == 1 and _has_own_number(base, divisor):
            above[place] = (_divided(base, divisor), exponent)
            return S.One
    if surds == [divisor] and len(roots) == 1 and _has_own_number(roots[0], divisor):
        roots[0] = _divided(roots[0], divisor)
        surds.clear()
        return S.One
    return rational


def _has_own_number(base: Expr, divisor: Integer) -> bool:
    """Whether a sum is a number and a multiple of the square of a sine or a cosine: 4 − 3 sin²α."""
    if not isinstance(base, Add) or len(base.args) != 2 or divisor not in base.args:
        return False
    (other,) = (term for term in base.args if term != divisor)
    number, power = other.as_coeff_Mul()
    ratio, exponent = power.as_base_exp()
    return bool(number.is_Rational and isinstance(ratio, sympy.sin | sympy.cos) and exponent == 2)


def _divided(total: Expr, divisor: Integer) -> Expr:
    return Add(*(term / divisor for term in total.args))


def _turn_a_difference(factors: list[tuple[Expr, Expr]]) -> bool:
    """Puts ``tan(β − α)`` for the ``tan(α − β)`` of a product with a minus; False without one."""
    for place, (base, exponent) in enumerate(factors):
        if isinstance(base, _ODD) and exponent.is_odd and isinstance(base.args[0], Add):
            terms = base.args[0].args
            if 0 < sum(map(_is_negative, terms)) < len(terms):
                factors[place] = (base.func(-base.args[0], evaluate=False), exponent)
                return True
    return False


def _assemble(
    rational: Rational,
    surds: list[Integer],
    above: list[tuple[Expr, Expr]],
    below: list[tuple[Expr, Expr]],
    roots_above: list[Expr],
    roots_below: list[Expr],
    other: list[Layout],
) -> Layout:
    roots = _put_together(rational, surds, roots_above, roots_below, bool(above))
    p, q = int(rational.p), roots.q
    upper = sorted(above, key=_factor_order)
    functions = [x for x in upper if isinstance(x[0], DIRECT)]
    front = [x for x in upper if x not in functions]
    letters_above = [_power_layout(*x) for x in front]
    functions_above = [_power_layout(*x) for x in functions]
    if roots.above is not None:
        letters_above.append(roots.above)
    surd: list[Layout] = [Root(Number(str(roots.surd)))] if roots.surd != 1 else []
    denominator: list[Layout] = []
    if roots.surd_below != 1:
        denominator.append(Root(Number(str(roots.surd_below))))
    denominator.extend(_power_layout(*x) for x in sorted(below, key=_factor_order))
    if roots.below:
        denominator.append(Root(_plain_product(roots.below)))
    numerals: list[Layout] = [Number(str(p))] if p != 1 else []
    # A number before a product that ends in a function: ¾mu sin α, since mu sin α/4 misleads.
    energy = p == 1 and q == 2 and not surd and _like_energy(upper)
    if not denominator and q != 1 and (functions_above or energy):
        number = fraction(product(*numerals, *surd) if numerals or surd else ONE, Number(str(q)))
        return product(number, *letters_above, *other, *functions_above)
    # A root of a number comes first: √3(1 + e)u. That of the whole would be √(3(1 + e)u).
    numbers = [
        layout for layout in other if isinstance(layout, Root) and isinstance(layout.inside, Number)
    ]
    other = [layout for layout in other if layout not in numbers]
    numerator = [*numerals, *surd, *numbers, *letters_above, *other, *functions_above]
    if q != 1:
        denominator.insert(0, Number(str(q)))
    return _over(product(*numerator) if numerator else ONE, denominator)


class _Roots(NamedTuple):
    """The roots of a product: their numbers, what is under one root, and what is left below."""

    q: int
    surd: int
    surd_below: int
    above: Root | None
    below: list[Expr]


def _put_together(
    rational: Rational,
    surds: list[Integer],
    roots_above: list[Expr],
    roots_below: list[Expr],
    has_factors: bool,
) -> _Roots:
    """Roots of numbers and of expressions under one root, where a reader would have it so."""
    p, q = int(rational.p), int(rational.q)
    surd = 1
    for root in surds:
        surd *= int(root)
    surd_below = 1
    inside_above: list[Expr] = list(roots_above)
    inside_below: list[Expr] = []
    merged = not all(radicand.is_Rational for radicand in roots_above)
    if surd != 1:
        if merged and q == surd:
            # u√((1 + e²)/2), but u√(2(5 + e²))/4
            inside_below.append(Integer(surd))
            q //= surd
            surd = 1
        elif merged:
            inside_above.insert(0, Integer(surd))
            surd = 1
        elif q % surd == 0 and ((p == 1 and q == surd) or surd >= LONG_SURD):
            # 1/√3, and 11/√185, but 2√3/3
            surd_below, surd, q = surd, 1, q // surd
    if merged or (roots_below and surd != 1 and not has_factors):
        if surd != 1:
            inside_above.insert(0, Integer(surd))
            surd = 1
        inside_below.extend(roots_below)
        roots_below = []
    if len(inside_above) + len(inside_below) > 1:
        # √(2(a + b)/(3c)), and no quotient within a quotient.
        quotients = [radicand.as_numer_denom() for radicand in inside_above]
        inside_above = [above for above, _ in quotients if above != 1]
        inside_below.extend(below for _, below in quotients if below != 1)
    if inside_below and not inside_above:
        # 1/√(2(1 − e²)): of the quotient nothing is above.
        return _Roots(q, surd, surd_below, None, [*roots_below, *inside_below])
    whole = None
    if inside_above:
        whole = Root(fraction(_plain_product(inside_above), _plain_product(inside_below)))
    return _Roots(q, surd, surd_below, whole, roots_below)


def _over(numerator: Layout, denominator: Sequence[Layout]) -> Layout:
    """A quotient whose parts need no brackets around the whole."""
    if not denominator:
        return numerator
    if isinstance(numerator, Brackets) and numerator.kind == "()":
        numerator = numerator.inside
    lowest = product(*denominator)
    if isinstance(lowest, Brackets) and lowest.kind == "()":
        lowest = lowest.inside
    return (
        fraction(numerator, lowest)
        if split_sign(numerator)[0] == "+"
        else Fraction(numerator, lowest)
    )


def _plain_product(bases: Sequence[Expr]) -> Layout:
    """What stands under one root: the factors of it that SymPy keeps apart."""
    if not bases:
        return ONE
    number = S.One
    rest: list[tuple[Expr, Expr]] = []
    for other in bases:
        if other.is_Integer:
            number *= other
        else:
            coefficient, base = other.as_coeff_Mul()
            if coefficient.is_Integer and coefficient > 0:
                number *= coefficient
            else:
                base = other
            rest.append((base, S.One))
    factors: list[Layout] = [] if number == 1 else [Number(str(number))]
    factors.extend(_power_layout(*factor) for factor in sorted(rest, key=_factor_order))
    layout = product(*factors) if factors else ONE
    return layout.inside if isinstance(layout, Brackets) and layout.kind == "()" else layout


def _power_layout(base: Expr, exponent: Expr) -> Layout:
    layout = _from_expression(base)
    if isinstance(base, Add):
        layout = bracketed(layout)
    return power(layout, _from_expression(exponent))


def _general_power(base: Expr, exponent: Expr) -> Layout:
    if base is S.Exp1:
        return function("exp", _from_expression(exponent))
    if isinstance(exponent, Rational) and exponent.p == 1:
        return Root(_from_expression(base), int(exponent.q))
    if isinstance(base, Integer) and isinstance(exponent, Rational) and exponent.p > 0:
        inside = base**exponent.p
        if inside < LARGE_INSIDE:  # of numbers 3^(3/4) is not written, and 2 3^(3/4) misleads
            return Root(_from_expression(inside), int(exponent.q))
    layout = _from_expression(base)
    return power(bracketed(layout), _from_expression(exponent))


def _factor_order(factor: tuple[Expr, Expr]) -> tuple[Any, ...]:
    base, _ = factor
    if not base.free_symbols and not isinstance(base, DIRECT):
        return (0, exact.cost(base), str(base))
    if isinstance(base, Symbol):
        kind = _class(base)
        rank = {"coefficient": 2, "ratio": 2, "mass": 3, "other": 4}[kind]
        return (
            rank,
            1 if base.name[:1].isascii() and len(base.name.split("_")[0]) == 1 else 2,
            _alphabet(base),
        )
    if isinstance(base, Add):
        if base.has(*DIRECT):
            return (6, 1, str(base))
        classes = {_class(symbol) for symbol in base.free_symbols}
        plain = all(
            abs(p) <= 1
            for term in base.args
            for _, p in term.as_powers_dict().items()
            if p.is_number
        )
        if classes <= {"coefficient", "ratio"} and plain:
            minuses = sum(_is_negative(argument) for argument in base.args)
            # (1 + e)k, but k(1 − 2k)
            place = 1.0 if "coefficient" in classes else 2.2
            return (place, minuses, _alphabet_of(base), str(base))
        if (
            classes == {"mass"}
            or classes == {"mass", "coefficient"}
            or (classes == {"mass", "ratio"})
        ):
            return (2.5 if plain else 5, 0, _alphabet_of(base), str(base))
        return (5, 1, _alphabet_of(base), str(base))
    if isinstance(base, DIRECT):
        return (
            7,
            _alphabet_of(base.args[0]),
            {"sin": 0, "cos": 1}.get(base.func.__name__, 2),
        )
    return (6, 2, str(base))


def _like_energy(factors: list[tuple[Expr, Expr]]) -> bool:
    """½mu²: a mass and the square of another letter."""
    return any(isinstance(b, Symbol) and _class(b) == "mass" for b, _ in factors) and any(
        isinstance(b, Symbol) and _class(b) == "other" and p == 2 for b, p in factors
    )
