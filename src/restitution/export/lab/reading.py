"""Plain data that may hold anything at all, read with care. All raise StatementError."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from restitution.errors import StatementError
from restitution.expression.words import NAME

_LARGEST = 1e6
_LONGEST_NAME = 12


def an_object(value: object, what: str) -> Mapping[str, Any]:
    """An object with properties by name; ``what`` names it in the error."""
    if not isinstance(value, Mapping):
        raise StatementError(f"{what} is told as an object with its properties by name")
    return value


def a_list(value: object, what: str, most: int) -> Sequence[Any]:
    """A list of at most so many items."""
    if not isinstance(value, list):
        raise StatementError(f"the {what} are a list")
    if len(value) > most:
        raise StatementError(f"there are {len(value)} {what}: {most} are the most that are taken")
    return value


def a_name(value: Mapping[str, Any], what: str) -> str:
    """The name of a body, such as statements take."""
    name = value.get("name")
    if not isinstance(name, str) or len(name) > _LONGEST_NAME or not NAME.fullmatch(name):
        raise StatementError(
            f"{what} is named by a capital and then letters or digits, {_LONGEST_NAME} at most"
        )
    return name


def a_number(value: object, what: str) -> float:
    """A number that is not too large to be reckoned with."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise StatementError(f"{what} is a number")
    if not abs(value) <= _LARGEST:
        raise StatementError(f"{what} is out of bounds: numbers go up to {_LARGEST:g}")
    return float(value)


def a_pair(value: object, what: str) -> tuple[float, float]:
    """Two such numbers: a vector."""
    if not isinstance(value, list | tuple) or len(value) != 2:
        raise StatementError(f"{what} is a pair of numbers")
    return a_number(value[0], what), a_number(value[1], what)
