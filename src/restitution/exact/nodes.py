"""Nodes of expressions made anew, with a number left in front of a sum."""

from __future__ import annotations

from sympy import Add, Expr, Mul, Rational, S


def in_front(coefficient: Expr, rest: Expr) -> Expr:
    """A product that keeps a rational factor in front of a sum instead of multiplying it out."""
    if coefficient is S.One:
        return rest
    if isinstance(rest, Add) and isinstance(coefficient, Rational):
        if coefficient is S.NegativeOne:
            return -rest
        return Mul(coefficient, rest, evaluate=False)
    return coefficient * rest


def rebuilt(value: Expr, arguments: list[Expr]) -> Expr:
    """A node with other arguments; a number stays in front of a sum."""
    if isinstance(value, Mul) and len(arguments) == 2:
        first, second = arguments
        if isinstance(first, Rational) and isinstance(second, Add):
            return in_front(first, second)
    return value.func(*arguments)


def is_multiple_of_sum(value: Expr) -> bool:
    """Whether an expression is a rational number in front of a sum."""
    coefficient, rest = value.as_coeff_Mul()
    return coefficient is not S.One and isinstance(rest, Add)


def multiplied_in(value: Expr) -> Expr:
    """6 sin²α − 2 for 2(3 sin²α − 1)."""
    return Mul(*value.args)


__all__ = ["in_front", "is_multiple_of_sum", "multiplied_in", "rebuilt"]
