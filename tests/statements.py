"""The statements of the tests, and the examples that ship: each is solved once in a process.

All tests of one statement go to one process (``pytest_collection_modifyitems`` in conftest).
"""

from __future__ import annotations

from functools import cache
from pathlib import Path
from typing import Any
from unittest import mock

import pytest

import restitution.examples
from restitution.language import parse
from restitution.oracle import decision
from restitution.solve import Solution, solve

EXAMPLES = sorted(Path(restitution.examples.__file__).parent.glob("*.impact"))
QUESTIONS = sorted(Path(__file__).parent.glob("questions/*.impact"))
FILES = [*EXAMPLES, *QUESTIONS]
NAMES = frozenset(path.stem for path in FILES)


def each_of(paths: list[Path]) -> pytest.MarkDecorator:
    """A test of every one of these statements, as ``path``."""
    return pytest.mark.parametrize("path", paths, ids=lambda path: path.stem)


@cache
def solved(path: Path) -> Solution:
    """The solution of a statement. The guards of time and memory of the oracle are not for it."""
    asked = decision.checked

    def checked(solver: Any) -> tuple[str, str]:
        answer, reason = asked(solver)
        assert not any(word in reason for word in ("timeout", "canceled", "memory")), reason
        return answer, reason

    with mock.patch.object(decision, "checked", checked):
        return solve(parse(path.read_text(encoding="utf-8")))
