"""Errors where too little is known: what is open, and how a statement gives it."""

from __future__ import annotations

import re
from collections.abc import Iterable

from restitution.counting import listed
from restitution.errors import MissingError

# How what is open would be written; that a sphere has a mass and a velocity its line shows.
_WRITTEN = (
    (re.compile(r"the line of centres of (\w+) and (\w+)"), r"'\1 hits \2: along …'"),
    (re.compile(r"the direction of the wall (\w+)"), r"'wall \1: along …'"),
)


def direction_of(wall: str) -> str:
    """What the direction of a wall is called that is to be found."""
    return f"the direction of the wall {wall}"


def needs(called: str, phrases: Iterable[str]) -> MissingError:
    """The error that ``called`` needs what the phrases name, with the way to give it."""
    named = list(dict.fromkeys(phrases))
    error = MissingError(f"{called} needs {_listed(named)}{_written(named)}")
    error.because = f"{_listed(named)} {'are' if named[1:] else 'is'} not given"
    return error


def too_many(phrases: Iterable[str]) -> MissingError:
    """The error that there are more unknowns than facts."""
    named = sorted(set(phrases))
    return MissingError(
        f"there are more unknowns than facts that could fix them: {_listed(named)}{_written(named)}"
    )


def is_open(called: str, beside: Iterable[str] = ()) -> MissingError:
    """The error that the facts do not fix ``called``, nor what stands ``beside`` it."""
    named = list(dict.fromkeys(beside))
    verb = "are" if named[1:] else "is"
    beside_it = f" while {_listed(named)} {verb} open too" if named else ""
    error = MissingError(
        f"{called} is not fixed by what is given{beside_it}{_written([called, *named])}"
    )
    because = f": {_listed(named)} {verb} not known either" if named else ""
    error.because = f"too little is given{because}"
    return error


def _listed(named: list[str]) -> str:
    pause = len(named) > 2 or any(" and " in phrase for phrase in named)
    return listed(named, ", and" if pause else "and")


def _written(named: list[str]) -> str:
    for phrase in named:
        for pattern, text in _WRITTEN:
            match = pattern.fullmatch(phrase)
            if match:
                return f" (write {match.expand(text)})"
    return ""
