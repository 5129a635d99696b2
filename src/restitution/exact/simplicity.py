"""How much there is to read in an expression, and how large it may be to be improved.

The measure of simplicity
    Letters, digits, functions and roots count one each, a fraction bar, a bracket, a power or a
    sign about a half, a plus one; a surd in a denominator counts heavily.
"""

from __future__ import annotations

import math

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, S

# A tree above the first size is not searched for better forms, above the second not touched.
SEARCHED = 260
TOUCHED = 1500
TERMS = 20
# The terms that an expression may have when multiplied out, if it is to be searched.
EXPANDED = 200
TRIGONOMETRIC = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)
MASKED = ("sin", "cos", "tan")
HALF = Rational(1, 2)
# What SymPy raises for an expression that has no value, or whose value it cannot find.
WITHOUT_VALUE = (TypeError, ValueError, ArithmeticError, AttributeError, NotImplementedError)
# An unusual form that some step of the search cannot read.
UNREADABLE = (
    ArithmeticError,
    AttributeError,
    LookupError,
    TypeError,
    ValueError,
    NotImplementedError,
    RecursionError,
    sympy.PolynomialError,
)


def node_count(expression: sympy.Basic, limit: int) -> int:
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


def operations(value: sympy.Basic) -> int:
    """The number of operations of an expression."""
    return int(sympy.count_ops(value))


def terms_multiplied_out(value: Expr) -> float:
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
        return 2.0 if isinstance(expression, sympy.Dummy) and expression.name in MASKED else 1.0
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
    return 1.0 + sum(cost(argument) for argument in expression.args if isinstance(argument, Expr))


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
    if isinstance(above, Add) and any(is_surd(x) for x in sympy.preorder_traversal(above)):
        surds = 6.0 if not above.free_symbols else 1.0
    return _cost_power(above) + surds + (0.5 if isinstance(above, Add) else 0.0)


def _is_negative_number(value: Expr) -> bool:
    return bool(isinstance(value, Rational) and value.p < 0)


def is_surd(value: sympy.Basic) -> bool:
    """Whether a node is a root of a number."""
    return (
        isinstance(value, Pow)
        and isinstance(value.exp, Rational)
        and value.exp.q != 1
        and not value.base.free_symbols
    )
