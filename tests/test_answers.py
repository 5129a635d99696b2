"""Every statement with written answers: the examples that ship, and questions in exam style.

The answers were worked by hand and checked by other means, never taken from this program.
"""

from __future__ import annotations

from pathlib import Path

from answers import disagreements, expected
from statements import EXAMPLES, FILES, each_of, solved


def test_there_are_statements_enough() -> None:
    assert len(EXAMPLES) >= 40


@each_of(FILES)
def test_solves_to_the_written_answers(path: Path) -> None:
    wanted = expected(path.read_text(encoding="utf-8"))
    assert wanted, "a statement without answers proves nothing"
    assert disagreements(solved(path), wanted) == []
