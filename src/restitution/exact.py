"""Exact numbers and expressions in the form a textbook would print, compared and rounded.

The measure of simplicity
    An expression is brought into several equivalent forms, and the one that is least to read is
    taken. Letters, digits, functions and roots count one each, a fraction bar, a bracket, a power
    or a sign about a half, a plus one; a surd in a denominator counts heavily. Of equals the
    earlier wins, and the forms are made in this order: factored; with cos² and sin² exchanged;
    homogeneous in sine and cosine (``cos²α + e² sin²α``); in tangents; with common letters
    collected; as given.

Letters
    What is assumed of a letter is what its SymPy symbol says. A positive letter alone inside a
    sine, cosine or tangent is an acute angle, as everywhere in the language of statements.
    Nonnegative letters are coefficients of restitution, tried out between 0 and 1.
"""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from typing import Any

import sympy
from sympy import Add, Expr, Float, Integer, Mul, Pow, Rational, S, Symbol

from restitution.work import remembered, spend

# A tree above the first size is not searched for better forms, above the second not touched.
SEARCHED = 260
TOUCHED = 1500
TERMS = 20
# The terms that an expression may have when multiplied out, if it is to be searched.
EXPANDED = 200

_TRIGONOMETRIC = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)
_MASKED = ("sin", "cos", "tan")
_HALF = Rational(1, 2)


# --- the public functions ---------------------------------------------------------------------


@remembered(4096)
def tidy(expression: Any) -> Any:
    """An expression (or the ends of a set of numbers) in the form a textbook would print.

    The value is unchanged wherever the letters are admissible. Never raises but at a limit of
    work; what is too large to be improved quickly comes back as it is.
    """
    if isinstance(expression, sympy.Set):
        return _tidy_set(expression)
    if not isinstance(expression, Expr):
        return expression
    if expression.is_Atom or _size(expression, TOUCHED) >= TOUCHED:
        return expression
    try:
        return _tidy(expression)
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        return expression  # an unusual form that some step of the search cannot read
    except (NotImplementedError, RecursionError, sympy.PolynomialError):
        return expression


@remembered(1024)
def tidy_angle(expression: Any) -> Any:
    """An angle in radians in its usual form: ``pi/3``, ``pi - atan(4/3)``, ``alpha``.

    Recognised multiples of π/24 and π/10 are verified by exact algebra. Never raises but
    at a limit of work.
    """
    if not isinstance(expression, Expr) or expression.is_Atom:
        return expression
    if _size(expression, TOUCHED) >= TOUCHED:
        return expression
    try:
        return _tidy_angle(expression)
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        return expression
    except (NotImplementedError, RecursionError, sympy.PolynomialError):
        return expression


def same(a: Any, b: Any) -> bool:
    """Whether two expressions are equal for all admissible values of their letters.

    See `is_zero` for how that is decided.
    """
    left, right = sympy.sympify(a, strict=True), sympy.sympify(b, strict=True)
    if left == right:
        return True
    if not isinstance(left, Expr) or not isinstance(right, Expr):
        return False
    if left.is_infinite or right.is_infinite:
        return False
    return is_zero(left - right)


def is_zero(expression: Any) -> bool:
    """Whether an expression is zero for all admissible values of its letters.

    It is refuted by a value to 30 digits at up to four random admissible points that is not
    zero. What survives is proved zero by rational normal form, with sines and cosines reduced
    and surds rationalised. Else a number made with roots is calculated to as many digits as any
    such number needs to be told from zero (`digits_apart`). An expression in letters, or a number
    of another kind, is taken to be zero if it vanishes to 100 digits at fresh points: claims about
    letters are for the oracle to decide.
    """
    value = sympy.sympify(expression, strict=True)
    if value.is_Number:
        return bool(value == 0)
    if not isinstance(value, Expr):
        return False
    generator = random.Random(20)
    seen, real = 0, True
    # Where no point tried gives a real value, complex values must do.
    for real in (True, False):
        for point in _points(value, generator, 8):
            found = _evaluate(value, point, 30, real)
            if found is None:
                continue
            number, scale = found
            if abs(number) > scale * 1e-20:
                return False
            seen += 1
            if seen == (4 if point else 1):
                break
        if seen:
            break
    if _proved_zero(value):
        return True
    if not value.free_symbols:
        number = _zero_direction(value)
        digits = None if number is None else digits_apart(number)
        if number is not None and digits is not None:
            return bool(abs((number + 1).evalf(digits + 10) - 1) < Float(10) ** -digits)
    return bool(seen) and all(
        found is None or abs(found[0]) <= found[1] * Float("1e-85", 20)
        for point in _points(value, generator, 3)
        for found in [_evaluate(value, point, 100, real)]
    )


def _zero_direction(value: Expr) -> Expr | None:
    """What is zero just where a small number is, and is made with roots: the sine of an angle."""
    if not value.has(sympy.atan, sympy.asin, sympy.acos, sympy.atan2):
        return value
    direction = _direction(value)
    return None if direction is None else direction[1]


MOST_DIGITS = 20_000


def digits_apart(value: Expr) -> int | None:
    """So many digits tell a number made with roots from zero; None if there is no such bound.

    This is the bound of Burnikel, Fleischer, Mehlhorn and Schirra (A strong and easily computable
    separation bound for arithmetic expressions involving radicals, Algorithmica 27, 2000): for
    each part, ``above`` and ``below`` bound all conjugates of a numerator and a denominator that
    are algebraic integers, and ``degree`` bounds the degree of all together.
    """
    degree = 1
    seen: dict[Expr, tuple[float, float]] = {}

    def bounds(x: Expr) -> tuple[float, float]:
        """Logarithms of what bounds the conjugates above and below the line."""
        nonlocal degree
        if x in seen:
            return seen[x]
        if x.is_Rational:
            above, below = _log(abs(int(x.p))), _log(int(x.q))
        elif x.is_Add:
            above, below = bounds(x.args[0])
            for each in x.args[1:]:
                a, b = bounds(each)
                above, below = max(above + b, a + below) + math.log(2), below + b
        elif x.is_Mul:
            parts = [bounds(each) for each in x.args]
            above, below = sum(a for a, _ in parts), sum(b for _, b in parts)
        elif x.is_Pow and x.exp.is_Rational:
            above, below = bounds(x.base)
            power, root = abs(int(x.exp.p)), int(x.exp.q)
            above, below = above * power, below * power
            if x.exp.p < 0:
                above, below = below, above
            degree *= root
            if above >= below:
                above = (above + (root - 1) * below) / root
            else:
                below = (below + (root - 1) * above) / root
        elif isinstance(x, sympy.cos | sympy.sin) and (x.args[0] / sympy.pi).is_Rational:
            # Twice it is an algebraic integer whose conjugates are such numbers as well.
            above = below = math.log(2)
            degree *= 2 * int((x.args[0] / sympy.pi).q)
        else:
            raise ValueError(x)
        seen[x] = above, below
        return above, below

    try:
        above, below = bounds(value)
    except (ValueError, TypeError):
        return None
    digits = (below + (degree - 1) * max(above, 0.0)) / math.log(10)
    return int(digits) + 2 if digits < MOST_DIGITS else None


def _log(n: int) -> float:
    return math.log(n) if n else 0.0


def decimal(expression: Any) -> float | None:
    """The value to double precision, or None where letters remain or it is not a real number."""
    value = sympy.sympify(expression, strict=True)
    if not isinstance(value, Expr) or value.free_symbols:
        return None
    try:
        number = complex(value.evalf(30, maxn=200))
    except (TypeError, ValueError, OverflowError, ArithmeticError):
        return None
    if number.imag != 0 and abs(number.imag) > 1e-25 * abs(number):
        return None
    return number.real + 0.0


def significant(expression: Any, figures: int = 3) -> str:
    """The value to so many significant figures, as written in an examination.

    Halves are rounded away from zero; trailing zeros are kept (``1.20``), integers are padded
    (``12300``); from 10⁷ and below 10⁻⁴ a power of ten is split off (``1.23 × 10⁸``).
    Raises ValueError for an expression with letters or without a real value.
    """
    value = sympy.sympify(expression, strict=True)
    exact = _as_fraction(value, figures)
    if exact == 0:
        return "0"
    sign = "-" if exact < 0 else ""
    digits, exponent = _round(abs(exact), figures)
    if exponent >= 7 or exponent < -4:
        mantissa = _place_point(digits, 0)
        return f"{sign}{mantissa} × 10{_superscript(exponent)}"
    return sign + _place_point(digits, exponent)


def sympy_text(expression: Any) -> str:
    """Plain SymPy syntax with canonical letters: Greek by name (``lambda_``), ``e_1``."""
    if not isinstance(expression, sympy.Basic):
        return str(expression)
    names = {}
    for letter in expression.free_symbols:
        name = canonical_name(letter.name) if isinstance(letter, Symbol) else str(letter)
        if isinstance(letter, Symbol) and name != letter.name:
            names[letter] = name
    return str(_Printer({"order": None}, names).doprint(expression))


def canonical_name(name: str) -> str:
    """The name of a letter in the contract: ``lambda_``, ``mu_``, ``nu_``, ``xi_``, ``e_1``."""
    if name in ("lambda", "mu", "nu", "xi"):
        return name + "_"
    plain = re.fullmatch(r"([A-Za-z]+)(\d+)", name)
    return f"{plain[1]}_{plain[2]}" if plain else name


class _Printer(sympy.StrPrinter):  # type: ignore[misc]
    """SymPy's own text, with letters under their canonical names."""

    def __init__(self, settings: dict[str, Any], names: dict[Symbol, str]) -> None:
        super().__init__(settings)
        self._names = names

    def _print_Symbol(self, expr: Symbol) -> str:
        return self._names.get(expr, str(expr.name))


# --- size and cost ----------------------------------------------------------------------------


def _size(expression: sympy.Basic, limit: int) -> int:
    """The number of nodes, counted no further than the limit."""
    count = 0
    pending = [expression]
    while pending:
        current = pending.pop()
        count += 1
        if count >= limit:
            return limit
        pending.extend(current.args)
    return count


def _multiplied_out(value: Expr) -> float:
    """At most how many terms an expression has when brought over one denominator."""
    above, below = _spread(value)
    return above + below


def _spread(value: Expr) -> tuple[float, float]:
    if isinstance(value, Add):
        above, below = 0.0, 1.0
        for term in value.args:
            a, b = _spread(term)
            above, below = above * b + a * below if b > 1 else above + a * below, below * b
        return above, below
    if isinstance(value, Mul):
        above, below = 1.0, 1.0
        for factor in value.args:
            a, b = _spread(factor)
            above, below = min(above * a, 1e9), min(below * b, 1e9)
        return above, below
    if isinstance(value, Pow) and isinstance(value.exp, Integer):
        a, b = _spread(value.base)
        times = min(abs(int(value.exp)), 400)
        if max(a, b) > 1:
            # The number of products of so many factors out of n terms.
            a, b = (min(float(math.comb(int(min(n, 50)) + times - 1, times)), 1e9) for n in (a, b))
        return (a, b) if value.exp.p > 0 else (b, a)
    return 1.0, 1.0


def cost(expression: Expr) -> float:
    """How much there is to read in an expression: the measure of the module's docstring."""
    if expression.is_Integer:
        return 0.7 + 0.3 * len(str(abs(int(expression)))) + (0.5 if expression.is_negative else 0)
    if expression.is_Rational:
        return cost(Integer(expression.p)) + cost(Integer(expression.q)) + 0.5
    if expression.is_Atom:
        # A letter that stands for the sine of an angle is read as two.
        return 2.0 if isinstance(expression, sympy.Dummy) and expression.name in _MASKED else 1.0
    if isinstance(expression, Add):
        # A minus in the middle of a sum is as easy to read as a plus.
        total = 1.0 * (len(expression.args) - 1)
        negative = 0
        for term in expression.args:
            sign = term.could_extract_minus_sign() and not isinstance(term, Add)
            negative += sign
            total += cost(-term if sign else term)
        return total + (0.5 if negative == len(expression.args) else 0.0)
    if isinstance(expression, Mul):
        total = 0.0
        below = False
        for factor in expression.args:
            if factor is S.NegativeOne:
                total += 0.5
            elif isinstance(factor, Rational):
                below = below or factor.q != 1
                if factor.p not in (1, -1):
                    total += cost(Integer(abs(factor.p)))
                if factor.q != 1:
                    total += cost(Integer(factor.q))
                if factor.p < 0:
                    total += 0.5
            elif isinstance(factor, Pow) and _is_negative_number(factor.exp):
                below = True
                total += _cost_below(factor)
            else:
                total += cost(factor) + (0.5 if isinstance(factor, Add) else 0.0)
        return total + (0.5 if below else 0.0)
    if isinstance(expression, Pow):
        if _is_negative_number(expression.exp):
            return 1.5 + _cost_below(expression)
        return _cost_power(expression)
    return 1.0 + sum(cost(each) for each in expression.args if isinstance(each, Expr))


def _cost_power(power: Expr) -> float:
    if not isinstance(power, Pow):
        return cost(power)
    base, exponent = power.base, power.exp
    if isinstance(exponent, Rational):
        inside = cost(base)
        bracket = 0.5 if isinstance(base, Add | Mul) and exponent.q == 1 else 0.0
        root = 1.0 if exponent.q != 1 else 0.0
        return inside + bracket + root + (0.5 if exponent.p != 1 else 0.0)
    return cost(base) + cost(exponent) + 0.5


def _cost_below(power: Pow) -> float:
    """The cost of a factor of a denominator."""
    above = Pow(power.base, -power.exp)
    surds = 0.0
    if isinstance(above, Add) and any(_is_surd(x) for x in sympy.preorder_traversal(above)):
        surds = 6.0 if not above.free_symbols else 1.0
    return _cost_power(above) + surds + (0.5 if isinstance(above, Add) else 0.0)


def _is_negative_number(value: Expr) -> bool:
    return bool(isinstance(value, Rational) and value.p < 0)


def _is_surd(value: sympy.Basic) -> bool:
    return (
        isinstance(value, Pow)
        and isinstance(value.exp, Rational)
        and value.exp.q != 1
        and not value.base.free_symbols
    )


# --- numbers ----------------------------------------------------------------------------------


def _tidy_number(value: Expr) -> Expr:
    """A number without letters: surds denested, denominators rational, common factor in front."""
    spend()
    if value.is_Rational or value.is_Atom:
        return value
    if value.has(*_TRIGONOMETRIC):
        value = sympy.expand_trig(value)
    if not all(isinstance(x, Rational | Add | Mul | Pow) for x in sympy.preorder_traversal(value)):
        return _tidy_parts(value)
    value = _denest(value)
    if not value.is_Rational:
        value = sympy.radsimp(value, max_terms=4)
        value = sympy.expand(value)
    return _content_out(value)


def denested(value: Expr) -> Expr:
    """Roots inside roots undone where that leaves none; else the number as it is."""
    plain = sympy.sqrtdenest(value)
    return value if is_nested(plain) else plain


def is_nested(value: Expr) -> bool:
    """Whether a root stands under a root."""
    return any(
        isinstance(node, Pow) and not node.exp.is_Integer and node.base.has(Pow)
        for node in sympy.preorder_traversal(value)
    )


def _denest(value: Expr) -> Expr:
    """Each root simplified, the innermost first."""
    if value.is_Atom or not value.has(Pow):
        return value
    value = value.func(*[_denest(each) for each in value.args])
    if not isinstance(value, Pow) or not isinstance(value.exp, Rational) or value.exp.q == 1:
        return value
    base = value.base
    if base.is_Rational:
        return value
    base = _content_out(sympy.expand(sympy.radsimp(base)))
    if value.exp.q != 2:
        return Pow(base, value.exp)
    if base.is_negative:
        return Pow(base, value.exp)
    content, rest = base.as_coeff_Mul()
    if base.is_Rational:
        root = sympy.sqrt(base)
    else:
        # √(p/q · R) = √(pq R)/q, with the squares in pq taken out.
        content = Rational(content)
        top = sympy.sqrt(Integer(content.p * content.q)) / content.q
        coefficient, surd = top.as_coeff_Mul()
        inside = rest if surd is S.One else sympy.expand(surd**2 * rest)
        root = coefficient * denested(sympy.sqrt(inside))
    power = root ** (2 * value.exp)
    return sympy.expand(power) if value.exp.p > 1 else power


def _content_out(value: Expr) -> Expr:
    """``3/8 + 3*sqrt(5)/8`` as ``3*(1 + sqrt(5))/8``; a positive term is left inside."""
    if not isinstance(value, Add):
        return value
    content, rest = value.primitive()
    if rest.could_extract_minus_sign() and all(
        term.could_extract_minus_sign() for term in Add.make_args(rest)
    ):
        content, rest = -content, -rest
    return _scaled(content, rest)


def _scaled(coefficient: Expr, rest: Expr) -> Expr:
    """A product that keeps a rational factor in front of a sum instead of multiplying it out."""
    if coefficient is S.One:
        return rest
    if isinstance(rest, Add) and isinstance(coefficient, Rational):
        if coefficient is S.NegativeOne:
            return -rest
        return Mul(coefficient, rest, evaluate=False)
    return coefficient * rest


def _tidy_parts(value: Expr) -> Expr:
    """A number that contains functions: its arguments are tidied."""
    if value.is_Atom:
        return value
    arguments = [tidy(each) for each in value.args]
    return value.func(*arguments) if tuple(arguments) != value.args else value


# --- expressions with letters -----------------------------------------------------------------


@dataclass(frozen=True)
class _Angle:
    """An angle with the positive letters that stand for its sine, cosine and tangent."""

    argument: Expr
    sine: Symbol
    cosine: Symbol
    tangent: Symbol


def _tidy(expression: Expr) -> Expr:
    spend()
    if not expression.free_symbols:
        return _tidy_number(expression)
    if expression.has(sympy.Abs):
        expression = _fewer_bars(expression)
    starts = [expression]
    if any(
        not each.args[0].is_Symbol
        for each in expression.atoms(*_TRIGONOMETRIC, sympy.atan, sympy.acos, sympy.asin)
    ):
        expanded = sympy.expand_trig(expression)
        if expanded != expression and _size(expanded, SEARCHED) < SEARCHED:
            starts.append(expanded)
    found = [_tidy_letters(each) for each in starts]
    if isinstance(expression, Mul) and expression.has(sympy.Abs):
        found.append(_with_bars(expression))
    return _compounded(_oriented(min(found, key=cost)))


def _compounded(value: Expr) -> Expr:
    """sin(α − θ) for sin α cos θ − cos α sin θ, and so on, throughout."""
    if value.is_Atom or not (value.has(sympy.sin) or value.has(sympy.tan)):
        return value
    arguments = [_compounded(each) for each in value.args]
    if tuple(arguments) != value.args:
        value = _rebuilt(value, arguments)
    if isinstance(value, Add) and len(value.args) == 2:
        return _of_two_angles(value)
    return value


def _of_two_angles(total: Add) -> Expr:
    first, second = total.args
    trigonometric = [
        {f for f in Mul.make_args(term) if isinstance(f, sympy.sin | sympy.cos)}
        for term in (first, second)
    ]
    if any(len(each) != 2 for each in trigonometric):
        return total
    angles = sorted({f.args[0] for each in trigonometric for f in each}, key=sympy.default_sort_key)
    if len(angles) != 2 or any(len({f.args[0] for f in each}) != 2 for each in trigonometric):
        return total
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
    return total


def _fewer_bars(value: Expr) -> Expr:
    """|uv| for |u |v||, and |u| for u²/|u|."""

    def outer(inside: Expr) -> Expr:
        factors = [
            x.args[0] if isinstance(x, sympy.Abs) and x.args[0].is_real else x
            for x in Mul.make_args(inside)
        ]
        return sympy.Abs(Mul(*factors))

    value = value.replace(sympy.Abs, outer)
    for product in value.atoms(Mul):
        powers = product.as_powers_dict()
        for bar in [x for x in powers if isinstance(x, sympy.Abs) and x.args[0].is_real]:
            inside = bar.args[0]
            total = powers[bar] + powers.get(inside, 0)
            if inside in powers and powers[inside].is_even and total.is_Integer:
                old = bar ** powers[bar] * inside ** powers[inside]
                own = inside if total % 2 == 0 else bar
                value = value.xreplace({product: product / old * own**total})
    return value


def _with_bars(value: Mul) -> Expr:
    """A product with one |x| in it, tidied as one thing, and the bars put where they matter."""
    bars = [each for each in value.args if isinstance(each.as_base_exp()[0], sympy.Abs)]
    if len(bars) != 1:
        return value
    base, power = bars[0].as_base_exp()
    rest = value / bars[0]
    if rest.has(sympy.Abs) or _sign(rest) != 1:
        return value
    factors = []
    for factor in Mul.make_args(_tidy_letters(rest * base.args[0] ** power)):
        below, exponent = factor.as_base_exp()
        sign = 1 if exponent.is_even else _sign(below)
        factors.append(factor if sign == 1 else sympy.Abs(below) ** exponent)
    return Mul(*factors)


def _sign(value: Expr) -> int | None:
    """The sign of an expression, where the signs of its terms show it; zero at an end is allowed.

    Letters are positive, or coefficients from 0 to 1, or acute angles under a sine.
    """
    if value.is_nonnegative or value.is_nonpositive:
        return 1 if value.is_nonnegative else -1
    put: dict[Expr, Expr] = {}
    for node in value.atoms(sympy.sin, sympy.cos, sympy.tan):
        argument = node.args[0]
        if not (argument.is_Symbol and argument.is_positive):
            return None
        put[node] = sympy.Dummy("f", positive=True)
    plain = value.xreplace(put)
    # A coefficient e as z/(1 + z), with z from 0 to infinity: 1 − e is then 1/(1 + z).
    ends: dict[Expr, Expr] = {}
    for letter in plain.free_symbols:
        if letter.is_positive:
            continue
        if not letter.is_nonnegative:
            return None
        z = sympy.Dummy("z", positive=True)
        ends[letter] = z / (1 + z)
    if not all(isinstance(x, Rational | Symbol | Add | Mul | Pow) for x in _nodes(plain)):
        return None
    sides = sympy.together(plain.xreplace(ends)).as_numer_denom()
    sign = 1
    for side in sides:
        terms = Add.make_args(sympy.expand(side))
        if all(term.is_nonnegative for term in terms):
            continue
        if not all(term.is_nonpositive for term in terms):
            return None
        sign = -sign
    return sign


def _nodes(value: Expr) -> Iterator[Expr]:
    return iter(sympy.preorder_traversal(value))


def _oriented(value: Expr) -> Expr:
    """(1 − e)² for (e − 1)² throughout."""
    if value.is_Atom or not value.has(Add):
        return value
    arguments = [_oriented(each) for each in value.args]
    if isinstance(value, Pow) and value.exp.is_even and isinstance(arguments[0], Add):
        arguments[0] = forward(arguments[0])
    return value if tuple(arguments) == value.args else _rebuilt(value, arguments)


def forward(total: Expr) -> Expr:
    """A sum or the same with the other sign: few minuses, and the term with the least e first."""
    minuses = sum(term.could_extract_minus_sign() for term in total.args)
    if 2 * minuses != len(total.args):
        return -total if 2 * minuses > len(total.args) else total
    coefficients = {x for x in total.free_symbols if x.is_nonnegative and not x.is_positive}
    if not coefficients and not total.has(*_TRIGONOMETRIC):
        return total

    def order(term: Expr) -> tuple[Any, ...]:
        powers = term.as_powers_dict()
        return sum(powers[x] for x in coefficients if x in powers), sympy.default_sort_key(
            -term if term.could_extract_minus_sign() else term
        )

    return -total if min(total.args, key=order).could_extract_minus_sign() else total


def _tidy_letters(expression: Expr) -> Expr:
    expression = (
        expression.rewrite([sympy.cot, sympy.sec, sympy.csc], sympy.tan)
        if expression.has(sympy.cot, sympy.sec, sympy.csc) and not expression.has(sympy.tan)
        else expression
    )
    angles: dict[Expr, _Angle] = {}
    masks: dict[Expr, Symbol] = {}
    masked = _mask(expression, angles, masks)
    core = _core(masked, tuple(angles.values()))
    back: dict[Symbol, Expr] = {symbol: each for each, symbol in masks.items()}
    for angle in angles.values():
        back[angle.sine] = sympy.sin(angle.argument)
        back[angle.cosine] = sympy.cos(angle.argument)
        back[angle.tangent] = sympy.tan(angle.argument)
    return _restore(core, back)


def _mask(value: Expr, angles: dict[Expr, _Angle], masks: dict[Expr, Symbol]) -> Expr:
    """Functions replaced by letters, so that what is left is algebra."""
    if value.is_Atom:
        return value
    if isinstance(value, sympy.sin | sympy.cos | sympy.tan | sympy.cot | sympy.sec | sympy.csc):
        argument = value.args[0]
        if argument.free_symbols:
            if argument not in angles:
                acute = bool(argument.is_Symbol and argument.is_positive)
                kind = {"positive": True} if acute else {"real": True}
                angles[argument] = _Angle(
                    argument,
                    sympy.Dummy("sin", **kind),
                    sympy.Dummy("cos", **kind),
                    sympy.Dummy("tan", **kind),
                )
            angle = angles[argument]
            return {
                sympy.sin: angle.sine,
                sympy.cos: angle.cosine,
                sympy.tan: angle.tangent,
                sympy.cot: 1 / angle.tangent,
                sympy.sec: 1 / angle.cosine,
                sympy.csc: 1 / angle.sine,
            }[value.func]
    if isinstance(value, Add | Mul):
        return value.func(*[_mask(each, angles, masks) for each in value.args])
    if isinstance(value, Pow) and isinstance(value.exp, Rational):
        return Pow(_mask(value.base, angles, masks), value.exp)
    if not value.free_symbols and all(
        isinstance(x, Rational | Add | Mul | Pow) for x in sympy.preorder_traversal(value)
    ):
        return value
    arguments = [tidy(each) for each in value.args]
    whole = value.func(*arguments) if tuple(arguments) != value.args else value
    if isinstance(whole, Add | Mul | Pow) or whole.is_Atom:
        return whole
    if whole not in masks:
        known: dict[str, bool] = {}
        if whole.is_positive:
            known["positive"] = True
        elif whole.is_real is not False:
            known["real"] = True
        masks[whole] = sympy.Dummy("f", **known)
    return masks[whole]


def _restore(value: Expr, back: dict[Symbol, Expr]) -> Expr:
    """Masked parts put back without multiplying out a number in front of a sum."""
    if isinstance(value, Symbol):
        return back.get(value, value)
    if value.is_Atom or not (value.free_symbols & back.keys()):
        return value
    arguments = [_restore(each, back) for each in value.args]
    return _rebuilt(value, arguments)


def _rebuilt(value: Expr, arguments: list[Expr]) -> Expr:
    if isinstance(value, Mul) and len(arguments) == 2:
        first, second = arguments
        if isinstance(first, Rational) and isinstance(second, Add):
            return _scaled(first, second)
    return value.func(*arguments)


def _core(value: Expr, angles: tuple[_Angle, ...]) -> Expr:
    """The best form of an algebraic expression in letters, roots and masked functions."""
    if value.is_Atom:
        return value
    if not value.free_symbols:
        return _tidy_number(value)
    value = _tidy_roots(value, angles)
    back: dict[Symbol, Expr] = {}
    masked = _mask_roots(value, back)
    if masked.is_Atom:
        return _restore(masked, back)
    if _size(masked, SEARCHED) >= SEARCHED or _multiplied_out(masked) > EXPANDED:
        return _restore(_factored(masked, False), back)
    present = [a for a in angles if masked.free_symbols & {a.sine, a.cosine, a.tangent}]
    # A root in a numerator or a denominator: both are tried, by multiplying by it above and below.
    best = _with_angles(_unrooted(masked, back), present)
    candidates = [best]
    above, below = sympy.fraction(best)
    for symbol in below.free_symbols & back.keys():
        square = _square(back[symbol], back)
        if square is not None:
            candidates.append(_factored(Mul(above, symbol) / (square * (below / symbol))))
    best = min(candidates, key=lambda each: _cost_restored(each, back))
    restored = _restore(best, back)
    for angle in present:
        restored = _into_root(restored, angle)
    restored = _divided_roots(restored)
    # As it was given may be much shorter, where it was collected by hand.
    if cost(value) < cost(restored) - (3 if _has_fractions(value) else 1):
        if not isinstance(value, Add):
            return value
        terms = Add(*[_core(each, angles) for each in value.args])
        return terms if cost(terms) <= cost(value) else value
    return restored


def _cost_restored(value: Expr, back: dict[Symbol, Expr]) -> float:
    return cost(_restore(value, back))


def _has_fractions(value: Expr) -> bool:
    """Whether a sum in the expression has terms with denominators."""
    return any(
        sympy.fraction(term)[1] is not S.One for total in value.atoms(Add) for term in total.args
    )


def _into_root(value: Expr, angle: _Angle) -> Expr:
    """``cos α √(1 + e² tan²α)`` as ``√(cos²α + e² sin²α)``, where that is shorter."""
    s, c, t = angle.sine, angle.cosine, angle.tangent
    best = value
    for factor in Mul.make_args(value):
        if not (isinstance(factor, Pow) and factor.exp == _HALF and t in factor.free_symbols):
            continue
        above, below = sympy.fraction(sympy.together(factor.base.xreplace({t: s / c}) * c**2))
        if below.free_symbols & {s, c}:
            continue
        inside = _factored(sympy.expand(above) / below)
        candidate = value / factor / c * sympy.sqrt(inside)
        best = candidate if cost(candidate) < cost(best) else best
    return best


def _square(root: Expr, back: dict[Symbol, Expr]) -> Expr | None:
    """What stands under a masked root, if it is free of further roots."""
    if isinstance(root, Pow) and root.exp == _HALF:
        return _mask_roots(root.base, back)
    return None


def _tidy_roots(value: Expr, angles: tuple[_Angle, ...]) -> Expr:
    """Every root's contents in best form, squares taken out; the innermost first."""
    spend()
    if value.is_Atom or not value.has(Pow):
        return value
    if isinstance(value, Pow) and isinstance(value.exp, Rational) and value.exp.q != 1:
        inside = _core(value.base, angles)
        if value.exp.q == 2:
            inside = _over_a_square(inside)
            root = _root(inside)
            return root if value.exp.p == 1 else Pow(root, value.exp.p)
        return Pow(inside, value.exp)
    arguments = [_tidy_roots(each, angles) for each in value.args]
    if isinstance(value, Mul):
        arguments = _joined_roots(arguments)
    return value.func(*arguments) if tuple(arguments) != value.args else value


def _joined_roots(factors: list[Expr]) -> list[Expr]:
    """√(a − b) √(a + b), which SymPy keeps apart, as √(a² − b²)."""
    roots = [each for each in factors if isinstance(each, Pow) and abs(each.exp) == _HALF]
    for first, second in combinations(roots, 2):
        if not (first.base.free_symbols and second.base.free_symbols):
            continue
        rest = [each for each in factors if each not in (first, second)]
        if first.exp == second.exp:
            inside = _conjugates(first.base, second.base)
            if inside is not None:
                return [*rest, Pow(inside, first.exp)]
        if first.base.is_Symbol or second.base.is_Symbol:
            continue
        # √(a b) / √a is √b, as both roots are real.
        inside = sympy.cancel(first.base ** (2 * first.exp) * second.base ** (2 * second.exp))
        if cost(inside) < cost(first.base) + cost(second.base) - 1:
            return _joined_roots([*rest, sympy.sqrt(_factored(inside))])
    return factors


def _divided_roots(value: Expr) -> Expr:
    """√(a b)/a as √(b/a), where a is positive."""
    if not isinstance(value, Mul):
        return value
    for root in value.args:
        if not (isinstance(root, Pow) and root.exp == _HALF and isinstance(root.base, Mul)):
            continue
        below = sympy.fraction(value)[1]
        for factor in Mul.make_args(below):
            if isinstance(factor, Add) and factor in root.base.args and _sign(factor) == 1:
                return value / root * factor * sympy.sqrt(root.base / factor**2)
    return value


def _over_a_square(inside: Expr) -> Expr:
    """A²/c² + b as (A² + b c²)/c², whose root is simpler; the terms are kept as they are."""
    if not isinstance(inside, Add):
        return inside
    parts = [sympy.fraction(term) for term in inside.args]
    number = sympy.ilcm(*[below.as_coeff_Mul()[0] for _, below in parts])
    powers: dict[Expr, Expr] = {}
    for _, below in parts:
        for base, power in below.as_coeff_Mul()[1].as_powers_dict().items():
            powers[base] = max(powers.get(base, S.Zero), power)
    powers.pop(S.One, None)
    if not (powers or number > 1) or any(not each.is_even for each in powers.values()):
        return inside
    if not sympy.sqrt(number).is_Integer:
        return inside
    whole = number * Mul(*[base**power for base, power in powers.items()])
    return Mul(Add(*[above * (whole / below) for above, below in parts]), 1 / whole, evaluate=False)


def _root(inside: Expr) -> Expr:
    """The square root, each factor's sign turned so that squares come out tidily."""
    if isinstance(inside, Mul):
        flipped = [
            Pow(-f.base, f.exp)
            if isinstance(f, Pow)
            and isinstance(f.base, Add)
            and f.exp.is_even
            and _negative(f.base)
            else f
            for f in inside.args
        ]
        content, rest = Mul(*flipped, evaluate=False).as_coeff_Mul()
        if content.is_negative:
            # √(−1) must not be split off: another factor may be negative as well.
            sums = [x for x in Mul.make_args(rest) if isinstance(x, Add)]
            if not sums:
                return sympy.sqrt(inside)
            content, rest = -content, rest / sums[0] * (-sums[0])
        return sympy.sqrt(content) * sympy.sqrt(rest)
    return sympy.sqrt(inside)


def _mask_roots(value: Expr, back: dict[Symbol, Expr]) -> Expr:
    """Each root of letters replaced by one letter, each letter under a root by a square."""
    roots = {
        each.base
        for each in value.atoms(Pow)
        if isinstance(each.exp, Rational) and each.exp.q == 2 and each.base.free_symbols
    }
    known = {root.base: symbol for symbol, root in back.items() if isinstance(root, Pow)}
    letters: dict[Expr, Expr] = {}
    for base in sorted(roots, key=sympy.default_sort_key):
        if base not in known:
            kind = {"nonnegative": True} if base.is_extended_nonnegative is not False else {}
            symbol = sympy.Dummy("root", **kind)
            known[base] = symbol
            back[symbol] = Pow(base, _HALF)
        if base.is_Symbol:
            letters[base] = known[base]

    def walk(node: Expr) -> Expr:
        if node in letters:
            return letters[node] ** 2
        if node.is_Atom:
            return node
        if isinstance(node, Pow) and isinstance(node.exp, Rational) and node.base in known:
            if node.exp.q == 2:
                return Pow(known[node.base], node.exp.p)
            if node.exp.q == 1 and not node.base.is_Symbol:
                return Pow(known[node.base], 2 * node.exp.p)
        if isinstance(node, Add) and node in known:
            return known[node] ** 2
        return node.func(*[walk(each) for each in node.args])

    return walk(value)


def _unrooted(value: Expr, back: dict[Symbol, Expr]) -> Expr:
    """Even powers of masked roots replaced by what stands under them, where that is a sum."""
    for symbol, root in back.items():
        if symbol in value.free_symbols and isinstance(root, Pow) and isinstance(root.base, Add):
            inside = _mask_roots(root.base, dict(back))
            if inside.free_symbols & back.keys():
                continue
            above, below = sympy.fraction(sympy.together(value))
            above, below = (_reduce_square(each, symbol, inside) for each in (above, below))
            value = above / below
    return value


def _reduce_square(value: Expr, symbol: Symbol, square: Expr) -> Expr:
    """A polynomial with every symbol² replaced; a product keeps what it can."""
    if symbol not in value.free_symbols:
        return value
    if isinstance(value, Mul):
        return Mul(*[_reduce_square(each, symbol, square) for each in value.args])
    if isinstance(value, Pow) and value.base == symbol and value.exp.is_Integer:
        return symbol ** (value.exp % 2) * square ** (value.exp // 2)
    poly = sympy.Poly(sympy.expand(value), symbol)
    return Add(
        *[
            coefficient * square ** (power // 2) * symbol ** (power % 2)
            for (power,), coefficient in poly.terms()
        ]
    )


# --- trigonometric variants -------------------------------------------------------------------


def _with_angles(value: Expr, angles: list[_Angle]) -> Expr:
    """The cheapest of the forms that differ in how sines, cosines and tangents are used."""
    best = _factored(value)
    if len(angles) > 3:
        return best
    for angle in angles:
        found = _with_angle(best, angle)
        # A square of squares has become one square: 1 − sin²α in it is seen now.
        best = found if found == best else _with_angle(found, angle)
    return _divided(best) if any(a.tangent in best.free_symbols for a in angles) else best


def _divided(value: Expr) -> Expr:
    """(a tan α + b)/tan α as a + b/tan α, where that is shorter."""
    above, below = sympy.fraction(value)
    if below is S.One or isinstance(below, Add) or not isinstance(above, Add):
        return value
    terms = Add(*[term / below for term in above.args])
    return terms if cost(terms) < cost(value) - 1 else value


def _with_angle(best: Expr, angle: _Angle) -> Expr:
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
        pair = [sympy.Poly(each, s, c) for each in (above, below)]
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
        candidates.append(_factored(form[0] / form[1]))
    for form in list(done):
        quotient = _in_tangent(form, angle)
        if quotient is not None:
            candidates.append(_factored(quotient))
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
    if any((top - each) % 2 for each in degrees) or top - min(degrees) > 6:
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


def _in_tangent(form: tuple[Expr, Expr], angle: _Angle) -> Expr | None:
    """A quotient of homogeneous polynomials in sine and cosine, in the tangent."""
    s, c, t = angle.sine, angle.cosine, angle.tangent
    degrees = []
    for each in form:
        terms = sympy.Poly(each, s, c).monoms()
        totals = {sum(powers) for powers in terms}
        if len(totals) != 1:
            return None
        degrees.append(totals.pop())
    above, below = (each.xreplace({s: t, c: S.One}) for each in form)
    return above / below * c ** (degrees[0] - degrees[1])


# --- factors ----------------------------------------------------------------------------------


@remembered(2048)
def _factored(value: Expr, deep: bool = True) -> Expr:
    """Over one denominator, in factors; surds out of denominators; signs and conjugates tidy."""
    spend()
    value = sympy.factor(value) if deep else sympy.factor_terms(sympy.together(value))
    coefficient: Expr = S.One
    powers: list[tuple[Expr, Expr]] = []
    for factor in Mul.make_args(value):
        if not factor.free_symbols:
            coefficient *= factor
            continue
        base, exponent = factor.as_base_exp()
        if not isinstance(exponent, Rational) or exponent.q != 1:
            powers.append((factor, S.One))
            continue
        if isinstance(base, Add) and deep:
            outside, parts = _primitive(base)
            coefficient *= outside**exponent
            powers.extend((part, exponent * power) for part, power in parts)
        else:
            powers.append((base, exponent))
    powers = _merged(powers)
    coefficient = _tidy_number(coefficient)
    if deep:
        coefficient, powers = _surds_inside(coefficient, powers)
    sign, powers = _signed(coefficient, powers)
    if sign < 0:
        coefficient = -coefficient if not isinstance(coefficient, Add) else coefficient * -1
    if deep:
        powers = [(_collected(base), power) for base, power in powers]
    return _product(coefficient, powers)


def _surds_inside(
    coefficient: Expr, powers: list[tuple[Expr, Expr]]
) -> tuple[Expr, list[tuple[Expr, Expr]]]:
    """(2 + √3)(e + 3√3 − 5) as √3 − 1 + (2 + √3)e, where that is shorter."""
    rational, surd = coefficient.as_coeff_Mul()
    if not isinstance(surd, Add):
        return coefficient, powers
    for index, (base, power) in enumerate(powers):
        if power != 1 or not isinstance(base, Add) or len(base.args) > 4:
            continue
        if not any(_is_surd(each) for each in base.atoms(Pow)):
            continue
        whole = _collected_in(sympy.expand(surd * base), tuple(base.free_symbols))
        if cost(whole) < cost(surd) + cost(base) + 1:  # two pairs of brackets
            return rational, [*powers[:index], (whole, power), *powers[index + 1 :]]
    return coefficient, powers


def _product(coefficient: Expr, powers: list[tuple[Expr, Expr]]) -> Expr:
    rational, surd = coefficient.as_coeff_Mul()
    rest = Mul(*[Pow(base, power) for base, power in powers])
    if surd is not S.One:
        rest = surd * rest
    return _scaled(rational, rest)


@remembered(2048)
def _primitive(total: Add) -> tuple[Expr, list[tuple[Expr, Expr]]]:
    """A sum as a number times factors without a common factor, surds included."""
    surds = {x for x in total.atoms(Pow) if _is_surd(x)}
    content, rest = total.primitive()
    plain: tuple[Expr, list[tuple[Expr, Expr]]] = (content, [(rest, S.One)])
    if not surds or len(total.args) > 10:
        return plain
    letters = sorted(total.free_symbols, key=sympy.default_sort_key)
    # 2e + √3 e − 1 as (2 + √3)e − 1
    gathered = _collected_in(rest, tuple(letters))
    plain = content, [(gathered if cost(gathered) < cost(rest) + 0.75 else rest, S.One)]
    try:
        poly = sympy.Poly(rest, *letters, domain="EX")
    except sympy.PolynomialError:
        return plain
    options = [plain]
    tried: set[Expr] = set()
    for coefficient in poly.coeffs()[:3] + poly.coeffs()[-1:]:
        value = sympy.expand(
            coefficient.as_expr() if hasattr(coefficient, "as_expr") else coefficient
        )
        if value.is_Rational or value in tried:
            continue
        tried.add(value)
        parts = [_tidy_number(sympy.expand(each) / value) for each in poly.coeffs()]
        if any(not _is_simple(each) for each in parts):
            continue
        quotient = Add(
            *[
                sympy.expand(each) * Mul(*[x**p for x, p in zip(letters, powers, strict=True)])
                for each, powers in zip(parts, poly.monoms(), strict=True)
            ]
        )
        more, inner = quotient.primitive()
        # Dividing may have left a polynomial over the rationals that splits.
        split = sympy.factor_list(inner)
        factors = [(f, Integer(p)) for f, p in split[1]]
        options.append((_tidy_number(value * more * split[0]), factors))
    return min(
        options,
        key=lambda each: (
            (cost(each[0]) if each[0] is not S.One else 0.0)
            + sum(cost(f) + (0.5 if p == 1 else 1.0) for f, p in each[1])
        ),
    )


def _is_simple(number: Expr) -> bool:
    return _size(number, 16) < 16


def _merged(powers: list[tuple[Expr, Expr]]) -> list[tuple[Expr, Expr]]:
    """Equal bases joined, and (a − b)(a + b) written a² − b² where both have one power."""
    joined: dict[Expr, Expr] = {}
    sign = S.One
    for base, power in powers:
        if base not in joined and isinstance(base, Add) and -base in joined:
            base = -base
            if power.is_odd:
                sign = -sign
        joined[base] = joined.get(base, S.Zero) + power
    done = [(base, power) for base, power in joined.items() if power != 0]
    changed = True
    while changed:
        changed = False
        for (first, p), (second, q) in combinations(done, 2):
            product = _conjugates(first, second) if p == q else None
            if product is not None:
                done = [x for x in done if x not in ((first, p), (second, q))]
                done.append((product, p))
                changed = True
                break
    if sign is not S.One:
        done.append((S.NegativeOne, S.One))
    return done


def _conjugates(first: Expr, second: Expr) -> Expr | None:
    """a² − b² for (a − b)(a + b) of two single terms, else None."""
    if not (isinstance(first, Add) and isinstance(second, Add)):
        return None
    if len(first.args) != 2 or len(second.args) != 2:
        return None
    total, difference = first + second, first - second
    if isinstance(total, Add) or isinstance(difference, Add):
        return None
    a, b = total / 2, difference / 2
    return a**2 - b**2


def _signed(
    coefficient: Expr, powers: list[tuple[Expr, Expr]]
) -> tuple[int, list[tuple[Expr, Expr]]]:
    """Sums that are negative for all admissible letters turned round; no needless minus in front.

    Returns the sign that is left over for the coefficient.
    """
    sign = 1
    turned: list[tuple[Expr, Expr]] = []
    for base, power in powers:
        if base is S.NegativeOne:
            sign = -sign
            continue
        if isinstance(base, Add) and (_all_negative(base) or _negative(base)):
            base = -base
            if power.is_odd:
                sign = -sign
        turned.append((base, power))
    overall = sign * (-1 if coefficient.could_extract_minus_sign() else 1)
    if overall < 0:
        for index, (base, power) in enumerate(turned):
            if isinstance(base, Add) and power.is_odd and not _one_sign(base):
                turned[index] = (-base, power)
                sign = -sign
                break
    return sign, turned


def _one_sign(total: Expr) -> bool:
    """Whether turning a sum round would make it negative at all admissible letters tried."""
    return _all_of(_samples(total), lambda value: value > 0)


def _negative(total: Expr) -> bool:
    return _all_of(_samples(total), lambda value: value < 0)


def _all_of(values: Iterator[float], test: Callable[[float], bool]) -> bool:
    """Whether there are values and all pass; none is worked out beyond the first that fails."""
    any_ = False
    for value in values:
        if not test(value):
            return False
        any_ = True
    return any_


def _samples(total: Expr) -> Iterator[float]:
    """Values at fixed admissible points; none if a letter may have either sign."""
    letters = sorted(total.free_symbols, key=sympy.default_sort_key)
    if any(letter.is_extended_nonnegative is not True for letter in letters):
        return
    generator = random.Random(5)
    # One letter after the other is made large or small: u − 8v has no sign of its own, nor has
    # 14e − 1.
    masked = [x for x in letters if isinstance(x, sympy.Dummy) and x.name in _MASKED]
    ends = [
        (letter, end)
        for letter in letters
        if letter not in masked
        for end in (
            (Float("0.0001"), Float(1000))
            if letter.is_positive or letter.name == "root"
            else (Float("0.0001"), Float("0.9999"))
        )
    ]
    for index in range(6 + len(ends)):
        point = {letter: _sample(letter, generator, False) for letter in letters}
        if index >= 6:
            point[ends[index - 6][0]] = ends[index - 6][1]
        if masked:
            point.update(_of_an_angle(masked, generator))
        value = total.evalf(15, subs=point)
        if not value.is_Float and not value.is_Integer:
            return
        yield float(value)


def _of_an_angle(masked: list[Symbol], generator: random.Random) -> dict[Symbol, Float]:
    """Values for masked functions: of one acute angle where they may be, else of several."""
    several = len({x.name for x in masked}) < len(masked)
    angle = generator.uniform(0.05, 1.5)
    values = {}
    for each in masked:
        angle = generator.uniform(0.05, 1.5) if several else angle
        values[each] = Float(getattr(math, each.name)(angle))
    return values


@remembered(2048)
def _collected(total: Expr) -> Expr:
    """A sum with one letter, or with its components, collected where that is shorter."""
    if not isinstance(total, Add) or not 3 <= len(total.args) <= 12:
        return total
    best, least = total, cost(total)
    letters = sorted(total.free_symbols, key=_masked_first)
    for letter in letters:
        if sum(term.has(letter) for term in total.args) < 2:
            continue
        found = _collected_in(total, (letter,))
        # (1 + e) cos²θ rather than cos²θ + e cos²θ, though both are as long.
        slack = 0.25 if isinstance(letter, sympy.Dummy) else -0.25
        if cost(found) < least + slack:
            best, least = found, min(least, cost(found))
    components = _components(letters)
    if len(components) > 1 or (components and isinstance(components[0], sympy.Dummy)):
        found = _collected_in(total, components)
        # (1 − e) cos α + (1 + e) cos β rather than cos α + cos β − e(cos α − cos β)
        whole = isinstance(found, Add) and all(
            any(isinstance(x, Add) for x in Mul.make_args(term)) for term in found.args
        )
        if cost(found) < least + (2 if whole else 0.25):
            best = found
    return best


def _masked_first(letter: Symbol) -> tuple[bool, Any]:
    return not isinstance(letter, sympy.Dummy), sympy.default_sort_key(letter)


def _components(letters: list[Symbol]) -> tuple[Symbol, ...]:
    """The sines and cosines in a sum or, where there are none, what is no coefficient."""
    masked = [x for x in letters if isinstance(x, sympy.Dummy) and x.name in _MASKED]
    return tuple(masked or [x for x in letters if not x.is_nonnegative or x.is_positive])


def _collected_in(total: Add, letters: tuple[Symbol, ...]) -> Expr:
    """A sum with the products of some letters collected, each factor in factors."""
    parts: dict[Expr, list[Expr]] = {}
    for term in total.args:
        coefficient, power = term.as_independent(*letters, as_Add=False)
        parts.setdefault(power, []).append(coefficient)
    terms = []
    for power, coefficients in parts.items():
        coefficient = Add(*coefficients)
        inner = sympy.factor(coefficient) if isinstance(coefficient, Add) else coefficient
        if isinstance(inner, Mul) and any(isinstance(x, Add) for x in inner.args):
            inner = _factored(inner, False) if inner.free_symbols else inner
        if isinstance(inner, Add) and power is not S.One and _turns(inner):
            terms.append(Mul(S.NegativeOne, -inner, power))
        else:
            terms.append(_keep(inner, power))
    return Add(*terms)


def _turns(total: Add) -> bool:
    """Whether a sum reads better behind a minus: −1 − e, and e − 1, which is never positive."""
    return _all_negative(total) or (
        any(_is_minus(term) for term in total.args) and _negative(total)
    )


def _all_negative(total: Add) -> bool:
    return all(_is_minus(term) for term in total.args)


def _is_minus(term: Expr) -> bool:
    return bool(term.as_coeff_Mul()[0].is_negative)


def _keep(coefficient: Expr, power: Expr) -> Expr:
    if power is S.One:
        return coefficient
    rational, rest = coefficient.as_coeff_Mul()
    return rational * (rest * power) if not isinstance(rest, Add) else Mul(rational, rest, power)


def _tidy_set(value: Any) -> Any:
    """A set of numbers with its ends in textbook form."""
    if isinstance(value, sympy.Interval):
        low, high = (tidy(each) for each in (value.start, value.end))
        return sympy.Interval(low, high, value.left_open, value.right_open)
    if isinstance(value, sympy.FiniteSet):
        return sympy.FiniteSet(*[tidy(each) for each in value.args])
    if isinstance(value, sympy.Union):
        return sympy.Union(*[_tidy_set(each) for each in value.args])
    return value


# --- angles -----------------------------------------------------------------------------------


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
    if isinstance(value, sympy.atan) and is_nested(value.args[0]) and not _near_nice(size):
        return value.func(_tidy_number(value.args[0]))
    direction = _direction(value)
    if direction is None or not size.is_real:
        return _tidy_parts(value)
    cosine, sine = (_tidy_number(each) for each in direction)
    turns = _nice(size, cosine, sine)
    if turns is not None:
        return turns * sympy.pi
    pi = sympy.pi
    candidates: list[tuple[float, Expr]] = []
    # The quadrant is that of the direction: the angle itself may be too near to its end.
    ahead, left = bool(cosine > 0), bool(sine > 0)
    if cosine != 0 and sine != 0:
        tangent = _tidy_number(sine / cosine)
        if tangent.is_negative:
            tangent = -tangent
        if left:
            form = sympy.atan(tangent) if ahead else pi - sympy.atan(tangent)
        else:
            form = -sympy.atan(tangent) if ahead else sympy.atan(tangent) - pi
        candidates.append((cost(form) - (3 if tangent.is_Rational else 1), form))
        if not tangent.is_Rational:
            form = sympy.acos(cosine) if left else -sympy.acos(cosine)
            # 180° − arctan(…), −arctan(…) are what is written then
            obtuse = 4 if cosine.is_negative else 3 if not left else 0
            candidates.append((cost(form) + obtuse - (2 if cosine.is_Rational else 0), form))
            form = sympy.asin(abs(sine))
            form = form if ahead else pi - form
            form = form if left else -form
            candidates.append((cost(form) - (1 if sine.is_Rational else 0), form))
    best = min(candidates, key=lambda each: each[0])
    whole = Integer(sympy.floor((size - best[1].evalf(40)) / (2 * pi) + _HALF))
    form = best[1] + 2 * pi * whole
    if abs((form - value).evalf(30)) > 1:  # of one direction, they are whole turns apart
        return _tidy_parts(value)
    plain = _tidy_parts(value)
    return form if cost(form) <= cost(plain) + 3 else plain


def _near_nice(size: Expr) -> bool:
    """Whether an angle is within 10⁻²⁰ of one of the well-known fractions of π."""
    ratio = (size / sympy.pi).evalf(30)
    return any(
        abs(ratio * step - sympy.floor(ratio * step + _HALF)) < Float("1e-20") for step in (24, 10)
    )


def _nice(size: Expr, cosine: Expr, sine: Expr) -> Rational | None:
    """The rational multiple of π that an angle is, if it is one of the well-known ones."""
    ratio = (size / sympy.pi).evalf(30)
    for step in (24, 10):
        nearest = Rational(int(sympy.floor(ratio * step + _HALF)), step)
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
    if not turns or not all(each.is_Rational for each in turns):
        return None
    below = math.lcm(*(int(each.q) for each in turns))
    unit = Rational(math.gcd(*(int(each * below) for each in turns)), 2 * below)
    count = (sympy.atan(tangent) / sympy.pi / unit).evalf(30)
    nearest = int(sympy.floor(count + _HALF))
    if abs(count - nearest) > Float("1e-20") or any(abs(t / unit) > 40 for t in (*turns, nearest)):
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
        put[x] = {sympy.cos: cosine, sympy.sin: sine, sympy.tan: sine / cosine}[x.func]
    cosine, sine = components(nearest)
    gap = sympy.together(tangent.xreplace(put) * cosine - sine).as_numer_denom()[0]
    if not gap.is_polynomial(c, s):
        return None
    return nearest * unit if sympy.rem(gap, s**2 + c**2 - 1, s) == 0 else None


def _with_plain_angles(value: Expr) -> Expr:
    """An angle in which each arctangent that is a plain angle is written as that angle."""
    plain = {}
    for each in value.atoms(sympy.atan):
        turns = _of_plain_angles(each.args[0]) if not each.free_symbols else None
        if turns is not None:
            plain[each] = turns * sympy.pi
    return value.xreplace(plain) if plain else value


def _same_number(a: Expr, b: Expr) -> bool:
    return a == b or _tidy_number(sympy.expand(a - b)) == 0 or is_zero(a - b)


def _direction(value: Expr) -> tuple[Expr, Expr] | None:
    """The exact cosine and sine of an angle made of inverse functions, or None."""
    if isinstance(value, sympy.atan):
        x = value.args[0]
        size = sympy.sqrt(1 + x**2)
        return 1 / size, x / size
    if isinstance(value, sympy.acos):
        x = value.args[0]
        return x, sympy.sqrt(1 - x**2)
    if isinstance(value, sympy.asin):
        x = value.args[0]
        return sympy.sqrt(1 - x**2), x
    if (value / sympy.pi).is_Rational:
        return sympy.cos(value), sympy.sin(value)
    if isinstance(value, sympy.atan2):
        y, x = value.args
        size = sympy.sqrt(x**2 + y**2)
        return x / size, y / size
    if isinstance(value, Add):
        cosine, sine = S.One, S.Zero
        for term in value.args:
            part = _direction(term)
            if part is None:
                return None
            cosine, sine = (
                sympy.expand(cosine * part[0] - sine * part[1]),
                sympy.expand(sine * part[0] + cosine * part[1]),
            )
        return cosine, sine
    if isinstance(value, Mul):
        number, rest = value.as_coeff_Mul()
        if not number.is_Integer or abs(number) > 12:
            if number.is_Rational and number.q == 2 and abs(number.p) < 12:
                return _half_direction(number, rest)
            return None
        part = _direction(rest)
        if part is None:
            return None
        cosine, sine = S.One, S.Zero
        for _ in range(abs(int(number))):
            cosine, sine = (
                sympy.expand(cosine * part[0] - sine * part[1]),
                sympy.expand(sine * part[0] + cosine * part[1]),
            )
        return cosine, (sine if number > 0 else -sine)
    return None


def _half_direction(number: Rational, rest: Expr) -> tuple[Expr, Expr] | None:
    part = _direction(Integer(number.p) * rest)
    if part is None:
        return None
    half = (number * rest).evalf(30)
    cosine = sympy.sqrt(_tidy_number((1 + part[0]) / 2))
    sine = sympy.sqrt(_tidy_number((1 - part[0]) / 2))
    # Of two numbers whose product has a known sign, the larger tells that of the smaller.
    across, up = (bool(f(half).evalf(30) < 0) for f in (sympy.cos, sympy.sin))
    if abs(sympy.cos(half).evalf(30)) < _HALF:
        across = up != bool(part[1] < 0)
    elif abs(sympy.sin(half).evalf(30)) < _HALF:
        up = across != bool(part[1] < 0)
    return -cosine if across else cosine, -sine if up else sine


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
        reciprocal = 1 / inside
        if isinstance(reciprocal, sympy.tan) and _acute(reciprocal.args[0]):
            return quarter - reciprocal.args[0]
        if inside.could_extract_minus_sign() and _negative_term(inside):
            return -_tidy_angle_term(sympy.atan(-inside))
    return rest.func(inside)


def _negative_term(value: Expr) -> bool:
    return isinstance(value, Mul) and value.as_coeff_Mul()[0].is_negative is True


def _acute(value: Expr) -> bool:
    return bool(value.is_Symbol and value.is_positive)


# --- values -----------------------------------------------------------------------------------


def _sample(letter: Symbol, generator: random.Random, acute: bool) -> Float:
    """A random admissible value of a letter, to 110 digits."""
    value = Fraction(generator.randrange(10**12) + 1, 10**12)
    if acute:
        return _precise(Fraction(1, 10) + value * Fraction(13, 10))
    if letter.is_positive:
        return _precise(Fraction(1, 7) + 3 * value)
    if letter.is_nonnegative:
        return _precise(Fraction(1, 50) + Fraction(24, 25) * value)
    if letter.is_negative:
        return _precise(-Fraction(1, 7) - 3 * value)
    return _precise(6 * value - 3)


def _precise(value: Fraction) -> Float:
    return Float(Rational(value.numerator, value.denominator), 110)


def _points(value: Expr, generator: random.Random, count: int) -> Iterator[dict[Symbol, Float]]:
    letters = sorted(value.free_symbols, key=sympy.default_sort_key)
    if not letters:
        yield {}
        return
    inside: set[Any] = set()
    for each in value.atoms(*_TRIGONOMETRIC):
        inside |= each.free_symbols
    for _ in range(count):
        yield {x: _sample(x, generator, x in inside and bool(x.is_positive)) for x in letters}


def _evaluate(
    value: Expr, point: dict[Symbol, Float], digits: int, real_only: bool
) -> tuple[Any, Any] | None:
    """The value at a point and the scale on which it may be called zero.

    None if there is no value there or, with ``real_only``, no real one.

    The scale is that of the terms, so that units do not matter.
    """
    spend()
    try:
        number = value.evalf(digits, subs=point, maxn=4 * digits)
        scale = _scale(value, point)
    except (
        TypeError,
        ValueError,
        ArithmeticError,
        AttributeError,
        NotImplementedError,
    ):
        return None
    if not number.is_number or number.has(S.NaN, S.ComplexInfinity, S.Infinity):
        return None
    if not number.is_real:
        real, imaginary = number.as_real_imag()
        if abs(imaginary) > abs(real) * Float("1e-20"):
            if point and real_only:
                return None
            number = abs(number)
        else:
            number = real
    return number, scale


def _scale(value: Expr, point: dict[Symbol, Float]) -> Any:
    """How large an expression is where no sum in it cancels."""
    if value.is_Add:
        sizes = [_scale(each, point) for each in value.args]
        return max(each for each in sizes if each.is_real)
    if value.is_Mul and value.has(Add):
        return math.prod(_scale(each, point) for each in value.args)
    if value.is_Pow and value.exp.is_Rational and value.exp > 0 and value.base.has(Add):
        return _scale(value.base, point) ** value.exp
    return abs(value.evalf(15, subs=point))


def _proved_zero(value: Expr) -> bool:
    """A proof by normal form; False proves nothing."""
    if _size(value, SEARCHED) >= SEARCHED:
        return False
    try:
        if not value.free_symbols:
            return bool(_tidy_number(value) == 0)
        return bool(tidy(value) == 0)
    except (
        TypeError,
        ValueError,
        ArithmeticError,
        AttributeError,
        NotImplementedError,
    ):
        return False


def _as_fraction(value: Any, figures: int) -> Fraction:
    """A rational that rounds as the value does to so many figures."""
    if isinstance(value, Expr) and not value.free_symbols:
        if isinstance(value, Rational):
            return Fraction(int(value.p), int(value.q))
        for digits in (figures + 25, figures + 80):
            number = value.evalf(digits, maxn=400)
            real, imaginary = number.as_real_imag()
            if not real.is_Float and not real.is_Rational:
                break
            if imaginary != 0 and abs(imaginary) > abs(real) * Float("1e-20"):
                break
            if abs(real) < Float("1e-40") and is_zero(value):
                return Fraction(0)
            exact = Rational(real)
            fraction = Fraction(int(exact.p), int(exact.q))
            if fraction == 0:
                return fraction
            close = _near_tie(fraction, figures)
            if close is None:
                return fraction
        else:
            return close if close is not None else fraction
    raise ValueError(f"{value} has no real value to be rounded")


def _near_tie(value: Fraction, figures: int) -> Fraction | None:
    """The tie that a value is within 10⁻¹⁵ of a last figure of, or None."""
    unit = Fraction(10) ** (_exponent(abs(value)) - figures + 1)
    doubled = value / unit * 2
    nearest = round(doubled)
    if nearest % 2 and abs(doubled - nearest) < Fraction(1, 10**15):
        return nearest * unit / 2
    return None


def _exponent(value: Fraction) -> int:
    """The power of ten of the first digit of a positive number."""
    power = (value.numerator.bit_length() - value.denominator.bit_length()) * 3 // 10
    while Fraction(10) ** power > value:
        power -= 1
    while Fraction(10) ** (power + 1) <= value:
        power += 1
    return power


def _round(value: Fraction, figures: int) -> tuple[str, int]:
    """The digits of a positive number rounded half up, and the power of ten of the first."""
    power = _exponent(value)
    scaled = value / Fraction(10) ** (power - figures + 1)
    digits = int(scaled + Fraction(1, 2))
    if digits >= 10**figures:
        digits //= 10
        power += 1
    return str(digits), power


def _place_point(digits: str, exponent: int) -> str:
    if exponent < 0:
        return "0." + "0" * (-exponent - 1) + digits
    if exponent + 1 >= len(digits):
        return digits + "0" * (exponent + 1 - len(digits))
    return digits[: exponent + 1] + "." + digits[exponent + 1 :]


def _superscript(power: int) -> str:
    return str(power).translate(str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"))
