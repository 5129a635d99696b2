"""What the normal run leaves to the night: of many cases that take long, it looks at some.

Which those are, nobody chooses: the order of checksums of their names. The cases of one statement
go together, for what takes long is made once for all that is asked of it. What is asked for by its
file, or by a name, runs whole.
"""

from __future__ import annotations

import os
import time
import zlib
from collections import defaultdict
from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

import pytest

FEW = 5
"""A test with fewer cases is whole in the normal run, but for those that take long."""

ONE_IN = {
    "test_statements": 12,
    # Workings of statements of its own: solved, planned, followed.
    "test_planning_accepted": 3,
    "test_planning_angles": 3,
    "test_planning_bounds": 3,
    "test_planning_claims": 3,
    "test_planning_between": 3,
    "test_planning_lines": 3,
    "test_planning_reading": 3,
    "test_planning_turns": 3,
    "test_planning_values": 3,
    "test_workings_reasons": 3,
    # Workings by hand, in several modules.
    "test_derivations": 3,
    "test_explaining": 3,
    "test_false_lines": 3,
    "test_following": 2,
    "test_hostile": 2,
    # Letters, ranges, verdicts.
    "test_angles_in_degrees": 3,
    "test_backwards": 3,
    "test_free_letters": 3,
    "test_random_claims": 3,
    "test_ranges": 2,
    "test_practice_forms": 3,
    "test_practice_marking": 2,
    "test_practice_judging": 3,
    "test_practise": 3,
    # Pictures, motions, processes.
    "test_cli": 2,
    "test_experiment_pictures": 3,
    "test_experiment_spheres": 2,
    "test_experiment_tracks": 3,
    "test_fuzz": 2,
    "test_gas": 3,
    "test_motion_few": 3,
    "test_never_hangs": 3,
    "test_properties": 2,
}
"""Of the cases of a test in these modules, one in so many stands in the normal run."""

BROWSER_ONE_IN = 4
"""Of the tests of a module that have a browser, one in so many stands in the normal run.

Each takes about a second of a processor, most of it in processes of the browser and of the server,
which no test waits for the end of: ``--long`` does not see them.
"""

LONG_TESTS = Path(__file__).parent / "long_tests.txt"
"""Tests of more than an eighth of a second of a quick processor; ``--long FILE`` writes them."""

LAWS_OF_THE_HOUSE = frozenset({"test_project", "test_sentences"})
"""What these modules ask of all files stands whole in the normal run, however long it takes."""

LONG = frozenset(LONG_TESTS.read_text(encoding="utf-8").splitlines())
LONG_SECONDS = 0.125
LONG_ONE_IN = 60
"""Of the tests that take long, one in so many stands in the normal run."""


def order(name: str) -> int:
    """The place of a case among others: the same everywhere, and without any sense."""
    return zlib.crc32(name.encode())


def some(names: list[str], one_in: int) -> set[str]:
    """One in so many of these, and at least one."""
    most = max(1, round(len(names) / one_in)) if names else 0
    return set(sorted(names, key=order)[:most])


KEPT = some(sorted(LONG), LONG_ONE_IN)
"""The tests that take long and stand in the normal run all the same."""


@pytest.hookimpl(tryfirst=True)  # marks are looked at afterwards
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Marks as nightly what the normal run leaves out, but for what is asked for by name."""
    if config.option.whole:
        return
    cases: dict[tuple[Path, str], list[pytest.Function]] = defaultdict(list)
    in_browsers: dict[Path, list[pytest.Item]] = defaultdict(list)
    long: dict[Path, list[pytest.Item]] = defaultdict(list)
    by_day: set[Path] = set()
    for item in items:
        if item.get_closest_marker("nightly") is not None:
            continue
        if item.nodeid in LONG and item.nodeid not in KEPT:
            long[item.path].append(item)
            continue
        by_day.add(item.path)
        if item.nodeid in LONG:
            continue
        if "page" in getattr(item, "fixturenames", ()):
            in_browsers[item.path].append(item)
        elif hasattr(item, "callspec"):
            assert isinstance(item, pytest.Function)
            cases[item.path, item.originalname].append(item)
    for (path, _), own in cases.items():
        if path.stem in ONE_IN and len(own) >= FEW:
            names = {each.callspec.id: each for each in own}
            _leave(names, some([*names], ONE_IN[path.stem]))
    for path, long_ones in long.items():  # no module is left to the night as a whole
        kept = (
            set() if path in by_day else some([each.nodeid for each in long_ones], len(long_ones))
        )
        _leave({each.nodeid: each for each in long_ones}, kept)
    for own_tests in in_browsers.values():
        tests = {each.nodeid: each for each in own_tests}
        _leave(tests, some([*tests], BROWSER_ONE_IN))
    if config.option.markexpr == "not nightly":
        # Two in three: what else is done with a list of tests takes seconds for these too.
        by_night = [item for item in items if item.get_closest_marker("nightly") is not None]
        config.hook.pytest_deselected(items=by_night)
        items[:] = [item for item in items if item.get_closest_marker("nightly") is None]


def _leave(tests: Mapping[str, pytest.Item], kept: Collection[str]) -> None:
    """Leaves to the night all of these tests but those that are kept, by their names."""
    for name, each in tests.items():
        if name not in kept:
            each.add_marker(pytest.mark.nightly)


def pytest_configure(config: pytest.Config) -> None:
    """What is asked for by name runs whole; each process of pytest-xdist reads what was typed."""
    named = config.args_source is config.ArgsSource.ARGS or bool(config.option.keyword)
    config.option.whole |= named and config.option.markexpr == "not nightly"


def pytest_addoption(parser: pytest.Parser) -> None:
    """Options for who wants all of what is named, and for who writes the list of long ones."""
    parser.addoption("--whole", action="store_true", help="leave nothing to the night")
    parser.addoption("--long", default="", help="a file to which tests that take long are added")


# --- the list of those that take long -------------------------------------------------------------


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Notes a test that takes long of a processor, its own processes included."""
    before = _seconds()
    try:
        return (yield)
    finally:
        file = item.config.getoption("--long")
        law = item.path.stem in LAWS_OF_THE_HOUSE
        if file and not law and _seconds() - before > LONG_SECONDS:
            with Path(file).open("a", encoding="utf-8") as names:
                names.write(_name(item) + "\n")


def _name(item: pytest.Item) -> str:
    """The name of a test without that of its group, which pytest-xdist writes behind it."""
    group = item.get_closest_marker("xdist_group")
    return item.nodeid if group is None else item.nodeid.removesuffix(f"@{group.args[0]}")


def _seconds() -> float:
    children = os.times()
    return time.process_time() + children.children_user + children.children_system
