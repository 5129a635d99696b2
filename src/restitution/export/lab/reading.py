"""Plain data that may hold anything at all, read with care. All raise StatementError."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from restitution.errors import StatementError
from restitution.expression.words import NAME

_LARGEST = 1e6
_LONGEST_NAME = 12


def an_object(told: object, what: str) -> Mapping[str, Any]:
    """What has properties by name; ``what`` it is, for the error."""
    if not isinstance(told, Mapping):
        raise StatementError(f"{what} is told as an object with its properties by name")
    return told


def a_list(told: object, what: str, most: int) -> Sequence[Any]:
    """At most so many of something."""
    if not isinstance(told, list):
        raise StatementError(f"the {what} are a list")
    if len(told) > most:
        raise StatementError(f"there are {len(told)} {what}: {most} are the most that are taken")
    return told


def a_name(told: Mapping[str, Any], what: str) -> str:
    """The name of a body, such as statements take."""
    name = told.get("name")
    if not isinstance(name, str) or len(name) > _LONGEST_NAME or not NAME.fullmatch(name):
        raise StatementError(
            f"{what} is named by a capital and then letters or digits, {_LONGEST_NAME} at most"
        )
    return name


def a_number(told: object, what: str) -> float:
    """A number that is not too large to be reckoned with."""
    if isinstance(told, bool) or not isinstance(told, int | float):
        raise StatementError(f"{what} is a number")
    if not abs(told) <= _LARGEST:
        raise StatementError(f"{what} is out of bounds: numbers go up to {_LARGEST:g}")
    return float(told)


def a_pair(told: object, what: str) -> tuple[float, float]:
    """Two such numbers: a vector."""
    if not isinstance(told, list | tuple) or len(told) != 2:
        raise StatementError(f"{what} is a pair of numbers")
    return a_number(told[0], what), a_number(told[1], what)
