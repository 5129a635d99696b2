"""The statements of the tests, and the examples that ship: each is solved once.

What holds for each of them is a law: a function of a statement that a module ``laws_of_...`` marks
by ``@law(PATHS)``. ``test_statements`` puts a statement to all its laws.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any
from unittest import mock

import pytest

import restitution.examples
from restitution.language import parse
from restitution.oracle import decision
from restitution.solving import Solution, solve
from restitution.workings import Explanation, explain

EXAMPLES = sorted(Path(restitution.examples.__file__).parent.glob("*.impact"))
QUESTIONS = sorted(Path(__file__).parent.glob("questions/*.impact"))
FILES = [*EXAMPLES, *QUESTIONS]
NAMES = frozenset(path.stem for path in FILES)


def each_of(paths: list[Path]) -> pytest.MarkDecorator:
    """A test of every one of these statements, as ``path``."""
    return pytest.mark.parametrize("path", paths, ids=lambda path: path.stem)


# One statement is put to all its laws before the next: few have to be kept.


@lru_cache(maxsize=8)
def solved(path: Path) -> Solution:
    """The solution of a statement. The guards of time and memory of the oracle are not for it."""
    asked = decision.checked

    def checked(solver: Any) -> tuple[str, str]:
        answer, reason = asked(solver)
        limits = ("timeout", "canceled", "resource", "memory")
        assert not any(word in reason for word in limits), reason
        return answer, reason

    with mock.patch.object(decision, "checked", checked):
        return solve(parse(path.read_text(encoding="utf-8")))


@lru_cache(maxsize=8)
def explained(path: Path) -> Explanation:
    """The worked solution of a statement."""
    return explain(solved(path))


# --- laws ----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Law:
    """What holds for some statements: ``check`` fails where it does not."""

    check: Callable[[Path], None]
    paths: frozenset[Path]

    @property
    def name(self) -> str:
        """The name by which a failure tells it."""
        return self.check.__name__


LAWS: list[Law] = []


def law(paths: Iterable[Path]) -> Callable[[Callable[[Path], None]], Callable[[Path], None]]:
    """Marks a function as a law of these statements."""

    def mark(check: Callable[[Path], None]) -> Callable[[Path], None]:
        LAWS.append(Law(check, frozenset(paths)))
        return check

    return mark


def put_to(laws: Iterable[Law], path: Path) -> None:
    """Puts a statement to all laws that are for it; fails with every one that does not hold."""
    broken: list[Exception] = []
    for each in laws:
        if path in each.paths:
            try:
                each.check(path)
            except Exception as error:  # noqa: BLE001 # the other laws are looked at all the same
                error.add_note(f"law: {each.name}")
                broken.append(error)
    if len(broken) == 1:
        raise broken[0]
    if broken:
        raise ExceptionGroup(f"{path.stem} breaks {len(broken)} laws", broken)
