"""Numbers with roots below roots, which nobody carries through a working exactly."""

from __future__ import annotations

from fractions import Fraction

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    has_root,
    is_binary,
    is_function,
    walk,
)

# Whole numbers from here on are too long to stand under a root.
_LONG_ROOT = 1000
# A fraction with such a divisor is no number that people read, but for a decimal with an end.
_LONG_BELOW, _PARTS = 100, 10**6
# Numbers below this are short beside a root.
_SHORT = 10


def is_of_nested_roots(tree: Expression, every: bool) -> bool:
    """Whether a value as it comes out is a sum with roots of sums of roots, or the root of one.

    A sum of products of such values is still to be worked out. ``every`` sum of different roots
    counts, where there is a calculator.
    """
    match tree:
        case Binary("*", Number(), Binary("/")):
            return False
        case Binary("/", above, Number()) | Binary("*", Number(), above) | Negate(above):
            return is_of_nested_roots(above, every)
        case Binary("+" | "-"):
            rooted = has_root(tree) if every else any(map(is_nested_root, walk(tree)))
            return rooted and _is_sum_of_roots(tree)
        case Apply("sqrt", inside):
            return is_of_nested_roots(inside, every)
    return False


def is_short_sum_of_a_root(tree: Expression) -> bool:
    """Whether a number is a sum of a whole number and a root, of small numbers: (3 − 2√3)/2."""
    match tree:
        case Negate(operand):
            return is_short_sum_of_a_root(operand)
        case Binary("/", Binary("+" | "-") as above, Number(below)) if below < _SHORT:
            return is_short_sum_of_a_root(above)
        case Binary("+" | "-", left, right):
            one, other = sorted((left, right), key=has_root)
            whole = isinstance(one, Number) and one.value < _SHORT
            return whole and _is_multiple_of_a_root(other) and _largest(other) < _SHORT
    return False


def _is_sum_of_roots(tree: Expression) -> bool:
    match tree:
        case Binary("+" | "-", left, right):
            return _is_sum_of_roots(left) and _is_sum_of_roots(right)
    return _is_term(tree)


def _is_term(tree: Expression) -> bool:
    """Whether a number is a product of roots and rational numbers."""
    match tree:
        case Number():
            return True
        case Apply("sqrt", inside):
            return not any(map(_is_open, walk(inside)))
        case Negate(inside):
            return _is_term(inside)
        case Binary("*" | "/", left, right):
            return _is_term(left) and _is_term(right)
    return False


def _is_open(tree: Expression) -> bool:
    """Whether a node is a letter or a quantity, or a power that is still to be worked out."""
    return is_binary(tree, "^") or isinstance(tree, Letter | Quantity)


def is_to_be_worked_out(tree: Expression) -> bool:
    """Whether a value has letters, or powers that are still to be worked out: √((√3)² + 1)."""
    return any(map(_is_open, walk(tree)))


def is_nested_root(tree: Expression) -> bool:
    """Whether a value is a root below which there is another."""
    return is_function(tree, "sqrt") and has_root(tree.argument)


def has_long_root(tree: Expression, longest: int = _LONG_ROOT) -> bool:
    """Whether a number of four figures or more stands under a root, which nobody reads."""
    return has_root(tree) and any(
        is_function(node, "sqrt")
        and any(isinstance(e, Number) and e.value >= longest for e in walk(node.argument))
        for node in walk(tree)
    )


def is_long_number(tree: Expression) -> bool:
    """Whether a number is a fraction that nobody reads, or a multiple of a root that is none.

    A short multiple is one of a small root by small numbers: √3/2.
    """
    match tree:
        case Negate(operand):
            return is_long_number(operand)
        case Number(value):
            return _is_unreadable(value)
        case Binary("/", Number(above), Number(below)) if above.denominator == 1:
            return _is_unreadable(above / below)
    return _is_multiple_of_a_root(tree) and _largest(tree) >= _SHORT


def has_unwieldy_root(tree: Expression) -> bool:
    """Whether a value has a root beside numbers of three figures, or a sum of roots over a number
    of two, or the root of one of four.
    """
    return has_root(tree) and (has_long_root(tree) or any(map(_is_unwieldy, walk(tree))))


def _is_unwieldy(tree: Expression) -> bool:
    match tree:
        case Binary("/", above, Number(below)) if is_binary(above, "+", "-", "*"):
            sums = any(is_binary(node, "+", "-") for node in walk(above))
            plain = has_root(above) and not any(map(_is_open, walk(above)))
            return plain and below >= (_SHORT if sums else _LONG_BELOW)
    return _is_multiple_of_a_root(tree) and _largest(tree) >= _LONG_BELOW


def _is_multiple_of_a_root(tree: Expression) -> bool:
    """Whether a number is a multiple of one root, as it comes out: 9√30/65, or 9/√65.

    A product of such a number is still to be worked out.
    """
    match tree:
        case Binary("/", above, Number()):
            return not is_binary(above, "/") and _is_multiple_of_a_root(above)
        case Binary("/", Number(size), Apply("sqrt", Number())):
            return size.denominator == 1
        case Binary("*", Number(size), Apply("sqrt") as root) if size.denominator == 1:
            return _is_multiple_of_a_root(root)
        case Apply("sqrt", Number()):
            return True
    return False


def _largest(tree: Expression) -> Fraction:
    return max(node.value for node in walk(tree) if isinstance(node, Number))


def _is_unreadable(value: Fraction) -> bool:
    """Whether a fraction has no end as a decimal, and a divisor of three figures or more."""
    return value.denominator >= _LONG_BELOW and _PARTS % value.denominator != 0
