"""Every statement with written answers: the examples that ship, and questions in exam style.

The answers were worked by hand and checked by other means, never taken from this program.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from answers import disagreements, expected

import restitution.examples
from restitution.language import parse
from restitution.oracle import decision
from restitution.solve import solve

EXAMPLES = Path(restitution.examples.__file__).parent
STATEMENTS = sorted([*EXAMPLES.glob("*.impact"), *Path(__file__).parent.glob("questions/*.impact")])


def test_there_are_statements_enough() -> None:
    assert len(list(EXAMPLES.glob("*.impact"))) >= 40


@pytest.fixture
def no_guard(monkeypatch: pytest.MonkeyPatch) -> None:
    """The guards of time and memory of the decision procedure are there for other questions."""
    checked = decision.checked

    def watched(solver: Any) -> tuple[str, str]:
        answer, reason = checked(solver)
        assert not any(word in reason for word in ("timeout", "canceled", "memory")), reason
        return answer, reason

    monkeypatch.setattr(decision, "checked", watched)


@pytest.mark.usefixtures("no_guard")
@pytest.mark.parametrize("path", STATEMENTS, ids=lambda path: path.stem)
def test_solves_to_the_written_answers(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    wanted = expected(text)
    assert wanted, "a statement without answers proves nothing"
    assert disagreements(solve(parse(text)), wanted) == []
