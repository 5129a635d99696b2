"""What the normal run leaves to the night is chosen by nobody, and nothing is left out of both."""

from __future__ import annotations

from pathlib import Path

import nights
import pytest
from statements import NAMES

HERE = Path(__file__).parent


def test_modules_and_statements_that_are_named_are_there() -> None:
    assert [name for name in nights.ONE_IN if not (HERE / f"{name}.py").exists()] == []
    assert nights.LONG <= NAMES
    assert len(nights.LONG) < 0.4 * len(NAMES)


@pytest.mark.parametrize(("count", "one_in", "kept"), [(1, 3, 1), (5, 3, 2), (9, 3, 3), (40, 8, 5)])
def test_some_are_kept_whatever_their_order(count: int, one_in: int, kept: int) -> None:
    names = [f"case {n}" for n in range(count)]
    assert len(nights.some(names, one_in)) == kept
    assert nights.some(names[::-1], one_in) == nights.some(names, one_in)
    assert nights.some(names, one_in) <= set(names)


def test_the_night_has_what_the_normal_run_leaves(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(nights.ONE_IN, "test_with_many_cases", 3)
    pytester.syspathinsert(HERE)
    pytester.makeini("[pytest]\nmarkers = nightly: at night\n")
    module = "import pytest\n@pytest.mark.parametrize('n', range(30))\ndef test_it(n): pass\n"
    pytester.makepyfile(test_with_many_cases=module, test_left_whole=module)

    def names(*options: str) -> set[str]:
        done = pytester.runpytest_inprocess(
            "-p", "nights", "-n", "0", "--collect-only", "-q", *options
        )
        return {line for line in done.outlines if "::" in line}

    normal, night, all_ = names("-m", "not nightly"), names("-m", "nightly"), names()
    assert (len(normal), len(night), len(all_)) == (30 + 10, 20, 60)
    assert normal | night == all_
    assert len(names("-m", "not nightly", "-k", "many_cases")) == 30
