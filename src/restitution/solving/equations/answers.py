"""Answers of items as people read them, and the errors of items without one."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import sympy as sp

from restitution import exact
from restitution.errors import ImpossibleError, MissingError
from restitution.exact.symbols import symbol_names
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Quantity,
    is_quantity,
)
from restitution.problem import Value
from restitution.render.layout import Layout, display, display_point, display_vector
from restitution.render.text import to_text
from restitution.solving.equations.solution import Answer, Branch, Exact, ItemKind
from restitution.solving.story import missing
from restitution.solving.story.unknowns import Letters


def missing_for(item: Value, branch: Branch, names: Iterable[str]) -> MissingError:
    """The error for an item that rests on open quantities."""
    names = list(names)
    phrases = dict.fromkeys(phrase_of(branch, name) for name in names)
    called = name_of(item)
    own = next((phrase for phrase in phrases if phrase.startswith(called)), None)
    if own is not None:
        return missing.is_open(own)
    match item.expression:
        case Quantity("direction", (Name(wall),), None):
            own = missing.direction_of(wall)
            if [*phrases] == [own]:
                return missing.is_open(own, _told_by(branch, names))  # it is what is asked
    return missing.needs(called, phrases)


def _told_by(branch: Branch, names: Iterable[str]) -> list[str]:
    """The letters of the statement that a branch has by open quantities: they are open too."""
    open_ = set(names)
    return sorted(
        key
        for key, value in branch.values.items()
        if not key.startswith("_") and open_ & symbol_names(value)
    )


def phrase_of(branch: Branch, name: str) -> str:
    """The phrase of a hidden unknown of a branch; its own name where it has none."""
    unknowns = branch.story.unknowns
    assert isinstance(unknowns, Letters)
    return unknowns.phrases.get(name, name.lstrip("_"))


# Quantities that are pure numbers, or whose dimension depends on what they are taken of.
_WITHOUT_UNIT = frozenset({"dot", "along", "across", "abs"})


def has_dimension(tree: Expression) -> bool:
    """Whether an expression is plainly a quantity with a unit: a speed, a sum of energies."""
    match tree:
        case Quantity(kind):
            return kind not in _WITHOUT_UNIT
        case Negate(operand):
            return has_dimension(operand)
        case Binary("+" | "-", left, right):
            return has_dimension(left) or has_dimension(right)
        case Binary("*", left, right) if isinstance(left, Number) or isinstance(right, Number):
            return has_dimension(left) or has_dimension(right)
        case Binary("/", left, Number()):
            return has_dimension(left)
    return False


def is_unit(tree: Expression) -> bool:
    """A line of centres is a unit vector; that of a wall is up to scale."""
    return is_quantity(tree, "line_of_centres")


def name_of(item: Value) -> str:
    """What an error calls an item: ``the impulse``, else its text."""
    text = item.text or "this"
    tree = item.expression
    if isinstance(tree, Quantity) and not tree.arguments:
        return "the " + tree.kind.replace("_", " ")
    return text


def is_same_value(a: Exact, b: Exact) -> bool:
    """Whether two values, numbers or vectors, are equal."""
    if isinstance(a, tuple) != isinstance(b, tuple):
        return False
    if isinstance(a, tuple):
        return all(exact.same(x, y) for x, y in zip(a, b, strict=True))
    return bool(exact.same(a, b))


def value_layout(value: Exact, kind: ItemKind, angle: bool, percentage: bool) -> Layout:
    """A value as people write it: a number, a vector or a point."""
    if isinstance(value, tuple):
        return display_point(*value) if kind == "point" else display_vector(*value)
    return display(value, angle=angle, percentage=percentage)


@lru_cache(maxsize=512)
def answer_of(number: int, value: Exact, kind: ItemKind, angle: bool, percentage: bool) -> Answer:
    """The answer that a value makes. Raises ImpossibleError for a value that is not finite."""
    if any(
        other.has(sp.nan, sp.zoo) for other in (value if isinstance(value, tuple) else (value,))
    ):
        raise ImpossibleError("it has no value: a division by zero, or a direction at rest")
    display_ = to_text(value_layout(value, kind, angle, percentage))
    if isinstance(value, tuple):
        x, y = value
        decimals = exact.decimal(x), exact.decimal(y)
        return Answer(
            number,
            value,
            (exact.sympy_text(x), exact.sympy_text(y)),
            None if None in decimals else decimals,  # type: ignore[arg-type]
            display_,
        )
    return Answer(
        number, value, exact.sympy_text(value), exact.decimal(value), display_, angle=angle
    )
