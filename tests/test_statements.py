"""Every statement, put to all laws that hold for it; it is solved and explained once.

``--law NAME`` looks at the laws alone whose name holds these letters.
"""

from __future__ import annotations

from pathlib import Path

import laws_of_answers  # noqa: F401
import laws_of_contract  # noqa: F401
import laws_of_explanations  # noqa: F401
import laws_of_labels  # noqa: F401
import laws_of_motions  # noqa: F401
import laws_of_numbers  # noqa: F401
import laws_of_paths  # noqa: F401
import laws_of_pictures  # noqa: F401
import laws_of_questions  # noqa: F401
import pytest
from statements import EXAMPLES, FILES, LAWS, Law, each_of, put_to


@pytest.mark.timeout(300)  # some are solved once for each item
@each_of(FILES)
def test_it_keeps_all_laws(path: Path, pytestconfig: pytest.Config) -> None:
    wanted = pytestconfig.getoption("--law")
    put_to([each for each in LAWS if wanted in each.name], path)


def test_there_are_statements_and_laws_enough() -> None:
    assert len(EXAMPLES) >= 40
    assert len(LAWS) >= 26
    assert len({each.name for each in LAWS}) == len(LAWS)
    assert all(each.paths for each in LAWS)


def broken(path: Path) -> None:
    raise AssertionError(f"{path.stem} is no good")


def broken_too(path: Path) -> None:
    broken(path)


def kept(path: Path) -> None:
    assert path.stem


def test_a_failure_names_every_law_that_is_broken() -> None:
    here, there = FILES[:2]
    other = Law(broken_too, frozenset([here]))
    laws = [Law(broken, frozenset([here])), Law(kept, frozenset(FILES)), other]
    put_to(laws, there)
    with pytest.raises(AssertionError, match="is no good") as one:
        put_to(laws[:2], here)
    assert one.value.__notes__ == ["law: broken"]
    with pytest.raises(ExceptionGroup, match="breaks 2 laws") as both:
        put_to(laws, here)
    assert [each.__notes__ for each in both.value.exceptions] == [
        ["law: broken"],
        ["law: broken_too"],
    ]
