"""Numbers with roots below roots, which nobody carries through a working exactly."""

from __future__ import annotations

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
