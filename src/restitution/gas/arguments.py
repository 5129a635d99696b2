"""What is passed to a gas, checked: errors name the quantity, its value and the rule."""

from __future__ import annotations

import operator
from typing import Any

import numpy as np

from restitution.errors import StatementError


def numbers(values: Any, name: str) -> np.ndarray:
    """Numbers of any shape. Raises StatementError with the name of what is none."""
    try:
        return np.array(values, dtype=float)
    except (TypeError, ValueError) as error:
        raise StatementError(f"{name} has to be numbers, not {values!r}") from error


def number(value: Any, name: str) -> float:
    """One number. Raises StatementError with the name of what is none, or several."""
    own = numbers(value, name)
    if own.ndim:
        raise StatementError(f"{name} is one number, not {value!r}")
    return float(own)


def both(periodic: Any) -> tuple[bool, bool]:
    """The pair for x and y, from a pair or from one value for both.

    Raises StatementError for what is neither.
    """
    axes = [periodic] * 2 if isinstance(periodic, bool | np.bool_) else periodic
    if (
        not isinstance(axes, tuple | list)
        or len(axes) != 2
        or not all(isinstance(axis, bool | np.bool_) for axis in axes)
    ):
        raise StatementError(f"periodic is True, False or a pair of them, not {periodic!r}")
    return bool(axes[0]), bool(axes[1])


def whole(value: Any, name: str, least: int = 1) -> int:
    """A whole number. Raises StatementError where it is none, or less than what is allowed."""
    try:
        own = operator.index(value)
    except TypeError as error:
        raise StatementError(f"{name} is a whole number, not {value!r}") from error
    if own < least:
        raise StatementError(f"{name} is {own}; it has to be at least {least}")
    return own
