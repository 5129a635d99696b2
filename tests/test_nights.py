"""What the normal run leaves to the night is chosen by nobody, and nothing is left out of both."""

from __future__ import annotations

from pathlib import Path

import nights
import pytest

HERE = Path(__file__).parent


def test_modules_and_tests_that_are_named_are_there() -> None:
    assert [name for name in nights.ONE_IN if not (HERE / f"{name}.py").exists()] == []
    texts = {path.name: path.read_text(encoding="utf-8") for path in HERE.glob("test_*.py")}
    for name in nights.LONG:
        module, function = name.removeprefix("tests/").split("[")[0].split("::")
        assert f"def {function}(" in texts[module], name


def test_no_law_of_the_house_is_left_to_the_night() -> None:
    modules = {name.removeprefix("tests/").split(".py::")[0] for name in nights.LONG}
    assert not nights.LAWS_OF_THE_HOUSE & modules
    assert all((HERE / f"{name}.py").exists() for name in nights.LAWS_OF_THE_HOUSE)


def test_the_night_leaves_some_of_those_that_take_long() -> None:
    assert nights.KEPT < nights.LONG
    assert len(nights.KEPT) == round(len(nights.LONG) / nights.LONG_ONE_IN)


BY_DAY, BY_NIGHT = ("-m", "not nightly"), ("-m", "nightly")


def _names(pytester: pytest.Pytester, *options: str) -> set[str]:
    """The names of the tests that a run with these options would have."""
    plugins = ("-p", "nights", "-p", "no:playwright", "-n", "0")
    done = pytester.runpytest_inprocess(*plugins, "--collect-only", "-q", *options)
    return {line for line in done.outlines if "::" in line}


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

    normal, night, all_ = (_names(pytester, *each) for each in (BY_DAY, BY_NIGHT, ()))
    assert (len(normal), len(night), len(all_)) == (30 + 10, 20, 60)
    assert normal | night == all_
    assert len(_names(pytester, *BY_DAY, "-k", "many_cases")) == 30
    assert len(_names(pytester, *BY_DAY, "test_with_many_cases.py")) == 30
    assert len(_names(pytester, *BY_DAY, "--whole")) == 60


def test_of_tests_in_a_browser_each_module_keeps_some(pytester: pytest.Pytester) -> None:
    pytester.syspathinsert(HERE)
    pytester.makeini("[pytest]\nmarkers = nightly: at night\n")
    browser = "import pytest\n@pytest.fixture\ndef page(): pass\n"
    few = "@pytest.mark.parametrize('n', range(4))\ndef test_few(page, n): pass\n"
    many = "".join(f"def test_{n}(page): pass\n" for n in range(14))
    alone = "def test_one(page): pass\ndef test_without(): pass\n"
    pytester.makepyfile(test_pages=browser + few + many, test_page=browser + alone)
    normal, night, all_ = (_names(pytester, *each) for each in (BY_DAY, BY_NIGHT, ()))
    kept = round(18 / nights.BROWSER_ONE_IN)
    assert (len(normal), len(night)) == (kept + 2, 18 - kept)
    assert normal | night == all_
    assert {"test_page.py::test_one", "test_page.py::test_without"} < normal


def test_no_module_is_left_to_the_night_as_a_whole(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytester.syspathinsert(HERE)
    pytester.makeini("[pytest]\nmarkers = nightly: at night\n")
    module = "def test_a(): pass\ndef test_b(): pass\n"
    pytester.makepyfile(test_long=module, test_mixed=module)
    names = {"test_long.py::test_a", "test_long.py::test_b", "test_mixed.py::test_a"}
    monkeypatch.setattr(nights, "LONG", names)
    monkeypatch.setattr(nights, "KEPT", set())
    by_day = _names(pytester, *BY_DAY)
    assert len(by_day) == 2
    assert "test_mixed.py::test_b" in by_day


def test_those_that_take_long_are_noted_and_left_to_the_night(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytester.syspathinsert(HERE)
    pytester.makeini("[pytest]\nmarkers = nightly: at night\n")
    pytester.makepyfile(test_one="def test_long(): sum(range(10**7))\ndef test_short(): pass\n")
    monkeypatch.setattr(nights, "LONG_SECONDS", 0.02)
    options = ("-p", "nights", "-p", "no:playwright", "-n", "0", "-m", "not nightly")
    pytester.runpytest_inprocess(*options, "--long", "long.txt").assert_outcomes(passed=2)
    (name,) = (pytester.path / "long.txt").read_text(encoding="utf-8").split()
    assert name == "test_one.py::test_long"
    monkeypatch.setattr(nights, "LONG", {name})
    monkeypatch.setattr(nights, "KEPT", set())
    pytester.runpytest_inprocess(*options).assert_outcomes(passed=1, deselected=1)


def test_what_is_named_runs_whole_in_other_processes(
    pytester: pytest.Pytester, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytester.makepyfile(test_one="def test_long(): pass\ndef test_short(): pass\n")
    pytester.makeconftest(
        "import nights\nnights.LONG = {'test_one.py::test_long'}\nnights.KEPT = set()\n"
    )
    monkeypatch.setenv("PYTHONPATH", str(Path(nights.__file__).parent))
    monkeypatch.delenv("PYTEST_XDIST_WORKER", raising=False)
    options = ("-p", "nights", "-p", "no:playwright", "-n", "1", "-m", "not nightly")
    pytester.runpytest_subprocess(*options).assert_outcomes(passed=1)
    pytester.runpytest_subprocess(*options, "test_one.py").assert_outcomes(passed=2)
    pytester.runpytest_subprocess(*options, "-k", "long").assert_outcomes(passed=1)


def test_what_shares_is_kept_together(request: pytest.FixtureRequest) -> None:
    """Without this a statement is solved, and a browser begun, in every process.

    pytest-xdist writes a test's group behind its name, and goes by the name. pytest 9.2 lets no
    plugin do so, and nothing said that the groups were gone.
    """
    if not hasattr(request.config, "workerinput"):
        pytest.skip("all tests are in one process")
    assert request.node.nodeid.endswith("@test_nights")
