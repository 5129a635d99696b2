"""How mathematics is laid out, as data: no output format, no algebra.

The nodes are few and frozen. Builders (`product`, `power`, `function`, …) put brackets where the
meaning needs them, so that every renderer can print a node without looking at its surroundings.
`from_sympy` chooses the order of factors and terms that textbooks use: number, surd, brackets in
e, masses, other letters, further brackets, roots, functions.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction as Ratio
from functools import lru_cache
from typing import Any, Literal, TypeAlias

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, S, Symbol

from restitution import exact
from restitution.expression import tree as trees

# --- nodes ------------------------------------------------------------------------------------


@dataclass(frozen=True, slots=True)
class Number:
    """Digits as printed, without a sign: ``3``, ``0.634``."""

    digits: str


@dataclass(frozen=True, slots=True)
class Letter:
    """A letter in italics; Greek ones go by name (``alpha``)."""

    name: str
    subscript: str = ""


@dataclass(frozen=True, slots=True)
class Bold:
    """An upright bold letter: **i**, **j**, **v** with a subscript, the zero vector **0**."""

    name: str
    subscript: str = ""


@dataclass(frozen=True, slots=True)
class Words:
    """Upright text."""

    text: str


@dataclass(frozen=True, slots=True)
class Sum:
    """Terms with their signs; one term with a minus is a negative quantity."""

    terms: tuple[tuple[Literal["+", "-"], Layout], ...]


@dataclass(frozen=True, slots=True)
class Product:
    """Factors side by side, or with ``×`` or ``·`` between them."""

    factors: tuple[Layout, ...]
    sign: Literal["", "×", "·"] = ""


@dataclass(frozen=True, slots=True)
class Fraction:
    """One thing above another."""

    above: Layout
    below: Layout


@dataclass(frozen=True, slots=True)
class Root:
    """A root; the index is 2 for the square root, and then not printed."""

    inside: Layout
    index: int = 2


@dataclass(frozen=True, slots=True)
class Power:
    """A base with an exponent."""

    base: Layout
    exponent: Layout


@dataclass(frozen=True, slots=True)
class Function:
    """A named function; the power stands after the name, as in sin²α."""

    name: str
    argument: Layout
    power: Layout | None = None


@dataclass(frozen=True, slots=True)
class Brackets:
    """Round brackets, or the bars of an absolute value."""

    inside: Layout
    kind: Literal["()", "||"] = "()"


@dataclass(frozen=True, slots=True)
class Degrees:
    """A number of degrees."""

    inside: Layout


@dataclass(frozen=True, slots=True)
class Percent:
    """A percentage."""

    inside: Layout


@dataclass(frozen=True, slots=True)
class Coordinates:
    """Things in round brackets with commas between: (3, −4)."""

    items: tuple[Layout, ...]


@dataclass(frozen=True, slots=True)
class Relation:
    """A chain: ``signs[k]`` (one of ``= ≠ < ≤ > ≥ ≈ →``) stands between operands k and k + 1."""

    operands: tuple[Layout, ...]
    signs: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Phrase:
    """Things side by side with a separator of words between: ``e = 0 or e = 1``."""

    items: tuple[Layout, ...]
    separator: str = " "


Layout: TypeAlias = (
    Number
    | Letter
    | Bold
    | Words
    | Sum
    | Product
    | Fraction
    | Root
    | Power
    | Function
    | Brackets
    | Degrees
    | Percent
    | Coordinates
    | Relation
    | Phrase
)

# Numbers with more bits than this are rounded, as nobody reads their digits.
LONGEST = 400
ONE = Number("1")
ZERO_VECTOR = Bold("0")
SIGNS = {"<=": "≤", ">=": "≥", "==": "=", "!=": "≠"}

# --- builders ---------------------------------------------------------------------------------


def letter(name: str) -> Letter:
    """The layout of a letter by its canonical name: ``u``, ``alpha``, ``lambda_``, ``e_1``."""
    head, _, subscript = name.partition("_")
    return Letter(head, subscript.strip("_"))


def negative(inside: Layout) -> Layout:
    """The layout with the other sign."""
    sign, size = split_sign(inside)
    if sign == "-":
        return size
    return Sum((("-", bracketed(size)),))


def split_sign(layout: Layout) -> tuple[Literal["+", "-"], Layout]:
    """The sign of a single term, and the term without it."""
    if isinstance(layout, Sum) and len(layout.terms) == 1:
        return layout.terms[0]
    return "+", layout


def bracketed(layout: Layout) -> Layout:
    """The layout in brackets if it is a sum, a negative or several things."""
    if isinstance(layout, Sum | Relation | Phrase):
        return Brackets(layout)
    return layout


def total(terms: Iterable[Layout]) -> Layout:
    """A sum of layouts; negative ones are subtracted, sums inside are opened."""
    parts: list[tuple[Literal["+", "-"], Layout]] = []
    for term in terms:
        parts.extend(term.terms if isinstance(term, Sum) else [("+", term)])
    if len(parts) == 1 and parts[0][0] == "+":
        return parts[0][1]
    return Sum(tuple(parts)) if parts else Number("0")


def product(*factors: Layout, sign: Literal["", "×", "·"] = "") -> Layout:
    """A product; sums are put in brackets, and products without a sign are opened."""
    flat: list[Layout] = []
    for factor in factors:
        if isinstance(factor, Product) and factor.sign == "" and sign == "":
            flat.extend(factor.factors)
        else:
            flat.append(factor)
    if sign == "" and len(flat) > 1:
        flat = [each for each in flat if each != ONE] or [ONE]
    if len(flat) == 1:
        return flat[0]
    return Product(tuple(bracketed(each) for each in flat), sign)


def fraction(above: Layout, below: Layout) -> Layout:
    """A fraction; a denominator 1 is left out, a sign of the numerator stands in front."""
    if below == ONE:
        return above
    sign, size = split_sign(above)
    inner = Fraction(size, below)
    return Sum(((sign, inner),)) if sign == "-" else inner


def power(base: Layout, exponent: Layout) -> Layout:
    """A power; sin α squared is sin²α, and a base of several things is put in brackets."""
    if exponent == ONE:
        return base
    if isinstance(base, Function) and base.power is None and isinstance(exponent, Number):
        return Function(base.name, base.argument, exponent)
    if not isinstance(base, Number | Letter | Bold | Brackets):
        base = Brackets(base)
    return Power(base, exponent)


def root(inside: Layout, index: int = 2) -> Layout:
    """A root."""
    return Root(inside.inside if _is_round(inside) else inside, index)  # type: ignore[union-attr]


def function(name: str, argument: Layout, exponent: Layout | None = None) -> Layout:
    """A function; its argument is put in brackets unless it is a letter, number or ``2α``."""
    simple = isinstance(argument, Number | Letter | Brackets) or (
        isinstance(argument, Degrees) and isinstance(argument.inside, Number)
    )
    if (
        isinstance(argument, Product)
        and not name.startswith("arc")
        and argument.sign == ""
        and len(argument.factors) == 2
        and isinstance(argument.factors[0], Number)
        and isinstance(argument.factors[1], Letter)
    ):
        simple = True
    return Function(name, argument if simple else Brackets(argument), exponent)


def equation(*sides: Any) -> Relation:
    """Sides with ``=`` between them; each a layout, a SymPy expression or a number."""
    return Relation(tuple(as_layout(each) for each in sides), ("=",) * (len(sides) - 1))


def relation(first: Any, *rest: Any) -> Relation:
    """A chain such as ``relation(0, "<", e, "<=", 1)``."""
    signs = tuple(SIGNS.get(each, each) for each in rest[0::2])
    return Relation(tuple(as_layout(each) for each in (first, *rest[1::2])), signs)


def as_layout(value: Any) -> Layout:
    """A layout as it is; a tree as written; anything else by way of SymPy; text as words."""
    if isinstance(value, Layout):
        return value
    if isinstance(value, str):
        return Words(value)
    if isinstance(value, trees.Expression):
        return from_tree(value)
    return from_sympy(value)


def _is_round(layout: Layout) -> bool:
    return isinstance(layout, Brackets) and layout.kind == "()"


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


# --- vectors ----------------------------------------------------------------------------------


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
    terms = [
        _component(as_layout(value), axis)
        for value, axis in ((x, "i"), (y, "j"))
        if as_layout(value) != Number("0")
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


# --- from SymPy -------------------------------------------------------------------------------

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
_DIRECT = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)
_MASSES = ("m", "M")
_RATIOS = ("e", "f", "k", "lambda", "mu", "nu")
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
        return Coordinates(tuple(from_sympy(each, degrees=degrees) for each in value))
    if isinstance(value, sympy.core.relational.Relational):
        return relation(
            from_sympy(value.lhs, degrees=degrees),
            value.rel_op,
            from_sympy(value.rhs, degrees=degrees),
        )
    if isinstance(value, sympy.And | sympy.Or):
        word = " and " if isinstance(value, sympy.And) else " or "
        return Phrase(tuple(from_sympy(each, degrees=degrees) for each in value.args), word)
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
    if isinstance(value, _DIRECT):
        return function(_NAMES[value.func.__name__], _from_angle(value.args[0]))
    if isinstance(value, sympy.atan2):
        # Neither sign is known: the direction of a vector says it all.
        y, x = value.args
        return Phrase((Words("direction of"), bracketed(vector(x, y))))
    name = value.func.__name__
    if isinstance(value, sympy.atan | sympy.asin) and _is_turned(value.args[0]):
        return negative(function(_NAMES[name], _from_expression(exact.tidy(-value.args[0]))))
    if name in _NAMES and value.args:
        arguments = [_from_expression(each) for each in value.args]
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
            size: Layout = Degrees(_plain_number(Ratio(int(abs(number.p)), int(number.q)) * 180))
            terms.append((number.p < 0, True, Sum((("-", size),)) if number.p < 0 else size))
        else:
            # SymPy may hold arctan(x) as −arctan(−x): the two signs meet here.
            turned = -term if _is_negative(term) else term
            laid = _from_expression(turned)
            laid = negative(laid) if turned != term else laid
            terms.append((split_sign(laid)[0] == "-", False, laid))
    # 180° − arctan(4/3), 90° + arctan(3/4), 90° − α, but α + 30°
    arcs = value.has(*_INVERSE)
    terms.sort(key=lambda each: (each[0], each[1] != arcs))
    return total([each[2] for each in terms])


def _is_turned(value: Expr) -> bool:
    """Whether a value is a negative number times letters, as SymPy's arctan may hold it."""
    number, _ = value.as_independent(*value.free_symbols, as_Add=False)
    return bool(number.is_negative)


def _plain_number(value: Ratio) -> Layout:
    """A positive rational as a decimal where that is short, else as a fraction."""
    if 1000 % value.denominator == 0:
        whole, rest = divmod(value.numerator * (1000 // value.denominator), 1000)
        return Number(f"{whole}.{rest:03}".rstrip("0") if rest else str(whole))
    return Fraction(Number(str(value.numerator)), Number(str(value.denominator)))


# Sums: which term comes first.


def _from_sum(value: Add) -> Layout:
    terms = sorted(value.args, key=_term_order)
    others = [each for each in terms if each.free_symbols]
    numbers = [each for each in terms if not each.free_symbols]
    if others and numbers and not _numbers_first(others):
        terms = others + numbers
    positive = [each for each in terms if not _is_negative(each)]
    if positive and _is_negative(terms[0]):
        if not _is_negative(terms[-1]) and len(terms) > 2 and len(value.free_symbols) == 1:
            terms.reverse()
        else:
            terms.remove(positive[0])
            terms.insert(0, positive[0])
    return total([_from_expression(each) for each in terms])


def _is_negative(term: Expr) -> bool:
    coefficient = term if term.is_Rational else term.as_coeff_Mul()[0]
    return bool(coefficient.is_Rational and coefficient < 0)


def _numbers_first(others: list[Expr]) -> bool:
    """``1 + e``, ``1 − tan²α``, ``1 + k``; but ``k² + k + 1``, ``t + 1``, ``t² + 2t + 3``."""
    letters = set().union(*[each.free_symbols for each in others])
    if any(each.has(*_DIRECT) for each in others):
        return True
    if any(_class(each) == "coefficient" for each in letters):
        return True
    return all(
        (each / each.as_coeff_Mul()[0]).is_Symbol
        and _class(next(iter(each.free_symbols))) == "ratio"
        for each in others
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
        term.has(*_DIRECT),  # 1 − e + 2 tan²α
        float(ratio) if getattr(ratio, "is_number", True) else 0.0,
        -numeric,
        tuple(sorted(names, key=str)),
        str(term),
    )


def cost_key(term: Expr) -> tuple[float, str]:
    """A key that puts simple numbers before complicated ones."""
    return exact.cost(term), str(term)


def _alphabet(symbol: Symbol) -> tuple[str, bool, str]:
    name = exact.canonical_name(symbol.name)
    head, _, tail = name.partition("_")
    return head.lower(), head.isupper(), tail


def _alphabet_of(value: Expr) -> str:
    return " ".join(sorted(x.name for x in value.free_symbols))


def _class(symbol: Symbol) -> Literal["coefficient", "ratio", "mass", "other"]:
    head = symbol.name.rstrip("_0123456789").split("_")[0]
    if head in ("e", "f"):
        return "coefficient"
    if head in _RATIOS:
        return "ratio"
    return "mass" if head in _MASSES else "other"


# Products: which factor comes first, what stands above and below the line.

LONG_SURD = 100  # from here on a root is not worth writing a second time, as in 11√185/185


def _from_product(value: Expr) -> Layout:
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
            laid = _general_power(base, exponent)
            other.append(laid)
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
    if rational.p < 0:
        sign = -1
        rational = -rational
    laid = _assemble(rational, surds, above, below, roots_above, roots_below, other)
    return negative(laid) if sign < 0 else laid


def _assemble(
    rational: Rational,
    surds: list[Integer],
    above: list[tuple[Expr, Expr]],
    below: list[tuple[Expr, Expr]],
    roots_above: list[Expr],
    roots_below: list[Expr],
    other: list[Layout],
) -> Layout:
    p, q = int(rational.p), int(rational.q)
    surd = 1
    for each in surds:
        surd *= int(each)
    below_surd = 1
    gathered = [each for each in roots_above if not each.is_Rational]
    inside_above: list[Expr] = list(roots_above)
    inside_below: list[Expr] = []
    merged = bool(gathered)
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
            below_surd, surd, q = surd, 1, q // surd
    if merged or (roots_below and surd != 1 and not above):
        if surd != 1:
            inside_above.insert(0, Integer(surd))
            surd = 1
        inside_below.extend(roots_below)
        roots_below = []
    root_above = None
    if inside_above:
        root_above = Root(fraction(_plain_product(inside_above), _plain_product(inside_below)))
    upper = sorted(above, key=_factor_order)
    lower = sorted(below, key=_factor_order)
    functions = [x for x in upper if isinstance(x[0], _DIRECT)]
    front = [x for x in upper if x not in functions]
    letters_above = [_laid_power(*x) for x in front]
    functions_above = [_laid_power(*x) for x in functions]
    if root_above is not None:
        letters_above.append(root_above)
    surd_layout: list[Layout] = [Root(Number(str(surd)))] if surd != 1 else []
    denominator: list[Layout] = []
    if below_surd != 1:
        denominator.append(Root(Number(str(below_surd))))
    denominator.extend(_laid_power(*x) for x in lower)
    if roots_below:
        denominator.append(Root(_plain_product(roots_below)))
    # A number before a product that ends in a function: ¾mu sin α, since mu sin α/4 misleads.
    energy = p == 1 and q == 2 and not surd_layout and _like_energy(upper)
    prefix = (
        not denominator
        and q != 1
        and ((bool(functions_above) and bool(letters_above or len(functions_above) > 0)) or energy)
    )
    numerals: list[Layout] = [Number(str(p))] if p != 1 else []
    if prefix:
        number = fraction(
            product(*numerals, *surd_layout) if numerals or surd_layout else ONE,
            Number(str(q)),
        )
        return product(number, *letters_above, *other, *functions_above)
    if surd_layout and letters_above and isinstance(letters_above[0], Brackets):
        # (1 + e)u√3, since √3(1 + e) could be read as the root of the whole.
        body = [*letters_above, *surd_layout]
    elif (
        surd_layout
        and letters_above
        and isinstance(letters_above[0], Power)
        and isinstance(letters_above[0].base, Brackets)
    ):
        body = [*letters_above, *surd_layout]
    else:
        body = [*surd_layout, *letters_above]
    numerator_parts = [*numerals, *body, *other, *functions_above]
    numerator = product(*numerator_parts) if numerator_parts else ONE
    if q != 1:
        denominator.insert(0, Number(str(q)))
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
    for each in bases:
        if each.is_Integer:
            number *= each
        else:
            coefficient, base = each.as_coeff_Mul()
            if coefficient.is_Integer and coefficient > 0:
                number *= coefficient
            else:
                base = each
            rest.append((base, S.One))
    factors: list[Layout] = [] if number == 1 else [Number(str(number))]
    factors.extend(_laid_power(*each) for each in sorted(rest, key=_factor_order))
    laid = product(*factors) if factors else ONE
    return laid.inside if isinstance(laid, Brackets) and laid.kind == "()" else laid


def _laid_power(base: Expr, exponent: Expr) -> Layout:
    laid = _from_expression(base)
    if isinstance(base, Add):
        laid = bracketed(laid)
    return power(laid, _from_expression(exponent))


def _general_power(base: Expr, exponent: Expr) -> Layout:
    if base is S.Exp1:
        return function("exp", _from_expression(exponent))
    if isinstance(exponent, Rational) and exponent.p == 1:
        return Root(_from_expression(base), int(exponent.q))
    laid = _from_expression(base)
    return power(bracketed(laid), _from_expression(exponent))


def _factor_order(factor: tuple[Expr, Expr]) -> tuple[Any, ...]:
    base, _ = factor
    if not base.free_symbols and not isinstance(base, _DIRECT):
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
        if base.has(*_DIRECT):
            return (6, 1, str(base))
        classes = {_class(each) for each in base.free_symbols}
        plain = all(
            abs(p) <= 1
            for term in base.args
            for _, p in term.as_powers_dict().items()
            if p.is_number
        )
        if classes <= {"coefficient", "ratio"} and plain:
            minuses = sum(_is_negative(each) for each in base.args)
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
    if isinstance(base, _DIRECT):
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


# --- ranges -----------------------------------------------------------------------------------


def from_set(values: Any, name: Any, *, degrees: bool = False) -> Layout:
    """A set of numbers as a statement about a letter: ``⅓ < e ≤ 1``, ``e = 0 or e > ½``.

    ``name`` is the letter or the quantity, as a layout, a SymPy expression or a tree.
    """
    subject = as_layout(name)

    def end(value: Any) -> Layout:
        return from_sympy(value, degrees=degrees)

    if isinstance(values, sympy.Interval):
        low, high = values.start, values.end
        before = "<" if values.left_open else "≤"
        after = "<" if values.right_open else "≤"
        if low is S.NegativeInfinity and high is S.Infinity:
            return Phrase((Words("all real"), subject))
        if low is S.NegativeInfinity:
            return Relation((subject, end(high)), (after,))
        if high is S.Infinity:
            return Relation((subject, end(low)), (">" if values.left_open else "≥",))
        return Relation((end(low), subject, end(high)), (before, after))
    if isinstance(values, sympy.FiniteSet):
        ordered = sorted(values.args, key=_set_order)
        cases = [Relation((subject, end(each)), ("=",)) for each in ordered]
        return cases[0] if len(cases) == 1 else Phrase(tuple(cases), " or ")
    if isinstance(values, sympy.Union):
        return _from_union(values, subject, degrees)
    if isinstance(values, sympy.Complement) and isinstance(values.args[1], sympy.FiniteSet):
        whole, holes = values.args
        missing = [Relation((subject, end(each)), ("≠",)) for each in holes.args]
        return Phrase((from_set(whole, subject, degrees=degrees), *missing), ", ")
    if values is S.EmptySet:
        return Phrase((Words("no"), subject))
    if values is S.Reals:
        return Phrase((Words("all real"), subject))
    return Relation((subject, Words(str(values))), ("∈",))


def _from_union(values: Any, subject: Layout, degrees: bool) -> Layout:
    """Parts in order; intervals that leave out one point between them are told with ≠."""
    parts = sorted(values.args, key=lambda each: _set_order(each.inf))
    merged: list[tuple[Any, list[Any]]] = []
    for part in parts:
        last = merged[-1] if merged else None
        if (
            last is not None
            and isinstance(part, sympy.Interval)
            and isinstance(last[0], sympy.Interval)
            and last[0].end == part.start
        ):
            whole = sympy.Interval(last[0].start, part.end, last[0].left_open, part.right_open)
            merged[-1] = (whole, [*last[1], part.start])
        else:
            merged.append((part, []))
    cases: list[Layout] = []
    for part, holes in merged:
        case = from_set(part, subject, degrees=degrees)
        if holes:
            missing = [
                Relation((subject, from_sympy(each, degrees=degrees)), ("≠",)) for each in holes
            ]
            case = Phrase((case, *missing), ", ")
        cases.append(case)
    return cases[0] if len(cases) == 1 else Phrase(tuple(cases), " or ")


def _set_order(value: Any) -> float:
    if value is S.NegativeInfinity:
        return float("-inf")
    found = exact.decimal(value) if isinstance(value, Expr) else None
    return found if found is not None else 0.0


# --- from a statement -------------------------------------------------------------------------

_OF_BODY = {
    "speed": "speed",
    "direction": "direction",
    "deflection": "angle of deflection",
    "momentum": "momentum",
    "mass": "mass",
    "position": "position",
    "energy": "kinetic energy",
    "impulse": "impulse on",
}
_OF_ALL = {
    "impulse": "magnitude of the impulse",
    "energy": "total kinetic energy",
    "energy_lost": "kinetic energy lost",
    "total_energy_lost": "total kinetic energy lost",
    "momentum": "total momentum",
    "line_of_centres": "line of centres",
    "time": "time",
}
_BOLD = {"velocity": "v", "momentum": "p", "position": "r", "impulse": "I"}


@dataclass(frozen=True)
class EventNames:
    """How the events of a story are called, by number; those that are not there keep theirs.

    ``after`` and ``during`` are words for when a quantity is taken, ``times`` stand for the times
    of events.
    """

    after: Mapping[int, str] = field(default_factory=dict)
    during: Mapping[int, str] = field(default_factory=dict)
    times: Mapping[int, Layout] = field(default_factory=dict)


_NUMBERED = EventNames()


def from_tree(node: trees.Expression, events: EventNames = _NUMBERED) -> Layout:
    """The layout of an expression as it was written in a statement."""
    match node:
        case trees.Number(value):
            return _typed_number(value)
        case trees.Degrees(value):
            return Degrees(_typed_number(value))
        case trees.Pi():
            return Letter("pi")
        case trees.Letter(name):
            return letter(name)
        case trees.Unit(axis):
            return Bold(axis)
        case trees.Name(name):
            return Words(name)
        case trees.Pair(x, y):
            return Coordinates((from_tree(x, events), from_tree(y, events)))
        case trees.Polar():
            return _from_polar(node, events)
        case trees.Negate(operand):
            inner = from_tree(operand, events)
            return Sum((("-", bracketed(inner)),))
        case trees.Apply(name, argument):
            return _from_apply(name, from_tree(argument, events))
        case trees.Binary():
            return _from_binary(node, events)
        case trees.Quantity():
            return _from_quantity(node, events)


def _typed_number(value: Ratio) -> Layout:
    """A number with all the decimals with which it was typed; one without end as a fraction."""
    for places in range(4, 13):
        scaled = value * 10**places
        if scaled.denominator == 1 and 1000 % value.denominator:
            digits = f"{scaled.numerator:0{places + 1}}"
            return Number(f"{digits[:-places]}.{digits[-places:]}".rstrip("0"))
    return _plain_number(value)


def _from_apply(name: str, argument: Layout) -> Layout:
    if name == "sqrt":
        return Root(argument)
    if name == "abs":
        return Brackets(argument, "||")
    return function(name, argument)


def _from_binary(node: trees.Binary, events: EventNames) -> Layout:
    left, right = from_tree(node.left, events), from_tree(node.right, events)
    match node.op:
        case "+":
            return total([left, bracketed(right) if _is_negation(right) else right])
        case "-":
            if _has_terms(left) and _has_terms(right) and _has_vectors(node):
                left = Brackets(left)  # a change of velocity: one vector minus another
            parts = left.terms if isinstance(left, Sum) else (("+", left),)
            return Sum((*parts, ("-", bracketed(right))))
        case "*":
            if _ends_in_number(left) and _begins_with_digit(right):
                return product(left, right, sign="×")
            if not isinstance(left, Number) and _begins_with_number(right):
                return product(left, right, sign="×")
            if isinstance(right, Product) and _begins_with_digit(right):
                return product(left, Brackets(right))  # 2m(3u), not 2m3u
            return product(left, right)
        case "/":
            return Fraction(left, right)
        case "^":
            return power(left, right)


def _has_terms(layout: Layout) -> bool:
    return isinstance(layout, Sum) and len(layout.terms) > 1


def _has_vectors(node: trees.Expression) -> bool:
    return any(isinstance(each, trees.Unit) for each in trees.walk(node))


def _is_negation(layout: Layout) -> bool:
    return isinstance(layout, Sum) and len(layout.terms) == 1


def _ends_in_number(layout: Layout) -> bool:
    if isinstance(layout, Product):
        return _ends_in_number(layout.factors[-1])
    return isinstance(layout, Number | Fraction | Power) and (
        not isinstance(layout, Power) or isinstance(layout.base, Number)
    )


def _begins_with_number(layout: Layout) -> bool:
    """Whether a factor is a number, or a product that begins with one: ``u × 2v``."""
    if isinstance(layout, Product) and layout.sign == "":
        layout = layout.factors[0]
    return isinstance(layout, Number)


def _begins_with_digit(layout: Layout) -> bool:
    while isinstance(layout, Product | Power):
        layout = layout.factors[0] if isinstance(layout, Product) else layout.base
    return isinstance(layout, Number) or (
        isinstance(layout, Fraction) and _begins_with_digit(layout.above)
    )


def _from_polar(node: trees.Polar, events: EventNames) -> Layout:
    parts: list[Layout] = [from_tree(node.size, events), Words("at"), from_tree(node.angle, events)]
    if node.wall is not None:
        parts += [Words("to"), from_tree(node.wall, events)]
    elif node.origin is not None:
        parts += [Words("from"), from_tree(node.origin, events)]
    return Phrase(tuple(parts))


def _from_quantity(node: trees.Quantity, events: EventNames) -> Layout:
    arguments = [from_tree(each, events) for each in node.arguments]
    if node.kind == "time" and isinstance(node.stage, int) and node.stage in events.times:
        return events.times[node.stage]
    main = _quantity(node.kind, node.arguments, arguments)
    when = _stage(node, events)
    return main if when is None else Phrase((*_opened(main), *when))


def _opened(layout: Layout) -> tuple[Layout, ...]:
    if isinstance(layout, Phrase) and layout.separator == " ":
        return layout.items
    return (layout,)


def _quantity(kind: str, written: tuple[trees.Expression, ...], arguments: list[Layout]) -> Layout:
    named = len(written) == 1 and isinstance(written[0], trees.Name)
    if kind == "velocity" and named:
        return Bold("v", _name(written[0]))
    if kind == "line_of_centres" or not arguments:
        return Words(_OF_ALL.get(kind, kind.replace("_", " ")))
    if kind == "abs":
        return Brackets(arguments[0], "||")
    if kind == "dot":
        return product(*arguments, sign="·")
    if kind == "along":
        return Phrase((Words("component of"), arguments[0], Words("along"), arguments[1]))
    if kind == "across":
        return Phrase(
            (
                Words("component of"),
                arguments[0],
                Words("perpendicular to"),
                arguments[1],
            )
        )
    if kind in ("angle", "distance"):
        noun = "angle between" if kind == "angle" else "distance between"
        return Phrase((Words(noun), arguments[0], Words("and"), arguments[1]))
    noun = _OF_BODY.get(kind, kind.replace("_", " "))
    link = noun if noun.endswith(" on") else f"{noun} of"
    return Phrase((Words(link), *arguments))


def _name(node: trees.Expression) -> str:
    return node.name if isinstance(node, trees.Name) else ""


def _stage(node: trees.Quantity, events: EventNames) -> tuple[Layout, ...] | None:
    match node.stage:
        case None:
            return None
        case "before":
            return (Words("before the impact"),)
        case trees.AtTime(time):
            return (Words("at time"), from_tree(time, events))
        case 0:
            return (Words("at the start"),)
        case number:
            lasting = {
                "velocity",
                "speed",
                "energy",
                "momentum",
                "direction",
                "position",
            }
            names, word = events.during, "in event"
            if node.kind in lasting:
                names, word = events.after, "after event"
            elif node.kind == "time":
                names, word = {}, "of event"
            return (Words(names.get(number, f"{word} {number}")),)


# --- answers as people see them ---------------------------------------------------------------


def display(value: Any, *, angle: bool = False, percentage: bool = False) -> Layout:
    """An answer: its exact form and, where that says more, its value to 3 significant figures.

    ``√103 u/16 = 0.634u``, ``arctan(3/4) = 36.9°``, ``60°``, ``3/7 = 0.429``, ``7u/4``. An angle
    is given in radians and shown in degrees.
    """
    sides = _display_sides(value, angle, percentage)
    return sides[0] if len(sides) == 1 else equation(*sides)


def display_named(name: Any, value: Any, *, angle: bool = False) -> Relation:
    """The same with the name of what has the value in front: ``α = arctan(3/4) = 36.9°``."""
    return equation(name, *_display_sides(value, angle, percentage=False))


def display_vector(x: Any, y: Any) -> Layout:
    """A vector answer: exact and, where a component needs it, to 3 significant figures."""
    return _display_pair(x, y, vector)


def display_point(x: Any, y: Any) -> Layout:
    """The coordinates of a point: exact and, where one needs it, to 3 significant figures."""
    return _display_pair(x, y, lambda a, b: Coordinates((as_layout(a), as_layout(b))))


def display_set(values: Any, name: Any, *, angle: bool = False) -> Layout:
    """A range: exact and, where an end needs it, with ends to 3 significant figures."""
    said = from_set(values, name, degrees=angle)
    ends = _ends(values)
    if not any(_rounded(each, angle) for each in ends):
        return said
    if any(each.free_symbols for each in ends):
        return said
    return Phrase((said, Brackets(_set_decimals(values, as_layout(name), angle))))


def _display_sides(value: Any, angle: bool, percentage: bool) -> list[Layout]:
    value = sympy.sympify(value, strict=True)
    if percentage:
        return _display_percentage(value)
    rounded = _rounded(value, angle)
    if rounded is None:
        return [from_sympy(value, degrees=angle)]
    if _is_long(value):
        return [rounded]
    return [from_sympy(value, degrees=angle), rounded]


def _is_long(value: Expr) -> bool:
    """Whether nobody would print the exact form of a value that has a decimal one."""
    most = 28 if value.has(*_DIRECT) else 40
    return bool(value.has(sympy.CRootOf)) or exact.cost(value) > most


def _display_percentage(value: Expr) -> list[Layout]:
    hundred = exact.tidy(100 * value)
    if value.free_symbols:
        return [Percent(bracketed(from_sympy(hundred)))]
    rounded = Percent(decimal_number(hundred))
    if isinstance(hundred, Rational) and 1000 % hundred.q == 0 and _figures(hundred) <= 3:
        size = Percent(_plain_number(Ratio(int(abs(hundred.p)), int(hundred.q))))
        return [negative(size) if hundred.p < 0 else size]
    return [from_sympy(value), rounded]


def _figures(value: Rational) -> int:
    """How many significant figures a terminating decimal has."""
    scaled = abs(value) * 1000
    return len(str(int(scaled)).strip("0")) if scaled.q == 1 else 99


@lru_cache(maxsize=1024)
def _rounded(value: Expr, angle: bool) -> Layout | None:
    """The value to 3 significant figures, or None where the exact form says enough."""
    if angle:
        in_degrees = value * 180 / sympy.pi
        if value.free_symbols or exact.decimal(value) is None:
            return None
        if isinstance(in_degrees, Rational) and 1000 % in_degrees.q == 0:
            return None
        size = decimal_number(in_degrees)
        sign, inner = split_sign(size)
        return negative(Degrees(inner)) if sign == "-" else Degrees(inner)
    coefficient, rest = _number_and_letters(value)
    if coefficient is None or exact.decimal(coefficient) is None:
        return None
    if isinstance(coefficient, Rational) and _simple(coefficient):
        return None
    return _times_letters(decimal_number(coefficient), rest)


def _times_letters(number: Layout, rest: Expr) -> Layout:
    """A decimal number, with its sign, times a product of letters."""
    if rest is S.One:
        return number
    laid = from_sympy(rest)
    sign, size = split_sign(number)
    term: Layout
    if isinstance(laid, Fraction):
        term = Fraction(product(size, laid.above), laid.below)
    else:
        term = product(size, laid)
    return negative(term) if sign == "-" else term


def _number_and_letters(value: Expr) -> tuple[Expr | None, Expr]:
    """A number times one product of letters, or None."""
    if not value.free_symbols:
        return value, S.One
    number, rest = value.as_independent(*value.free_symbols, as_Add=False)
    for factor in Mul.make_args(rest):
        base, exponent = factor.as_base_exp()
        if not base.is_Symbol or not exponent.is_Integer:
            return None, rest
    return number, rest


def _simple(value: Rational) -> bool:
    """Whole numbers, halves and quarters, and proper fractions down to sixths."""
    return value.q in (1, 2, 4) or (value.q <= 6 and abs(value.p) < value.q)


def _display_pair(x: Any, y: Any, build: Any) -> Layout:
    first, second = sympy.sympify(x, strict=True), sympy.sympify(y, strict=True)
    whole: Layout = build(first, second)
    rounded = [_rounded(each, False) for each in (first, second)]
    ready = all(
        each is not None or _number_and_letters(value)[0] is not None
        for each, value in zip(rounded, (first, second), strict=True)
    )
    if not ready or all(each is None for each in rounded):
        return whole
    long = any(_is_long(each) for each in (first, second))
    parts = [
        each if each is not None else _short_decimal(value)
        for each, value in zip(rounded, (first, second), strict=True)
    ]
    return build(*parts) if long else equation(whole, build(*parts))


def _short_decimal(value: Expr) -> Layout:
    """A simple number beside one that is rounded: 0.5, not ½."""
    if isinstance(value, Rational):
        size = (
            _plain_number(Ratio(int(abs(value.p)), int(value.q)))
            if 1000 % value.q == 0
            else decimal_number(abs(value))
        )
        return negative(size) if value.p < 0 else size
    number, rest = _number_and_letters(value)
    if isinstance(number, Rational) and number.q != 1:
        return _times_letters(_short_decimal(number), rest)
    return from_sympy(value)


def _ends(values: Any) -> list[Expr]:
    if isinstance(values, sympy.Interval):
        return [x for x in (values.start, values.end) if x.is_finite is not False]
    if isinstance(values, sympy.FiniteSet):
        return list(values.args)
    if isinstance(values, sympy.Union):
        return [end for part in values.args for end in _ends(part)]
    return []


def _set_decimals(values: Any, subject: Layout, angle: bool) -> Layout:
    """The same statement with rounded ends."""
    said = from_set(values, subject, degrees=angle)
    table: dict[Layout, Layout] = {}
    for each in _ends(values):
        rounded = _rounded(each, angle)
        if rounded is not None:
            table[from_sympy(each, degrees=angle)] = rounded
    return _replaced(said, table)


def _replaced(layout: Layout, table: dict[Layout, Layout]) -> Layout:
    if isinstance(layout, Relation):
        return Relation(tuple(table.get(each, each) for each in layout.operands), layout.signs)
    if isinstance(layout, Phrase):
        return Phrase(tuple(_replaced(each, table) for each in layout.items), layout.separator)
    return layout
