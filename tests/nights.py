"""What the normal run leaves to the night: of many cases that take long, it looks at some.

Which those are, nobody chooses: the order of checksums of their names. The cases of one statement
go together, for what takes long is made once for all that is asked of it.
"""

from __future__ import annotations

import zlib
from collections import defaultdict
from pathlib import Path

import pytest

FEW = 5
"""A test with fewer cases is whole in the normal run."""

ONE_IN = {
    # Workings of statements of its own: solved, planned, followed.
    "test_planning_accepted": 3,
    "test_planning_angles": 3,
    "test_planning_bounds": 3,
    "test_planning_claims": 3,
    "test_planning_lines": 3,
    "test_planning_turns": 3,
    "test_planning_values": 3,
    # Workings by hand, in several modules.
    "test_derivations": 3,
    "test_explaining": 3,
    "test_false_lines": 3,
    # Letters, ranges, verdicts.
    "test_angles_in_degrees": 3,
    "test_backwards": 3,
    "test_free_letters": 3,
    "test_random_claims": 3,
    "test_ranges": 2,
    "test_practice_forms": 2,
    "test_practise": 3,
    # Pictures, motions, processes, pages.
    "test_cli": 2,
    "test_experiment_pictures": 3,
    "test_experiment_spheres": 2,
    "test_experiment_tracks": 2,
    "test_fuzz": 2,
    "test_gas": 2,
    "test_motion_few": 3,
    "test_never_hangs": 3,
    "test_page_form": 2,
    "test_page_guides": 2,
    "test_properties": 2,
}
"""Of the cases of a test in these modules, one in so many stands in the normal run."""

LONG = frozenset(
    (Path(__file__).parent / "long_statements.txt").read_text(encoding="utf-8").split()
)
"""Statements that took more than half a second of a processor with all their laws."""

LONG_ONE_IN, SHORT_ONE_IN = 8, 2
"""Of the long statements, and of the others, one in so many stands in the normal run."""


def order(name: str) -> int:
    """The place of a case among others: the same everywhere, and without any sense."""
    return zlib.crc32(name.encode())


def some(names: list[str], one_in: int) -> set[str]:
    """One in so many of these, and at least one."""
    most = max(1, round(len(names) / one_in)) if names else 0
    return set(sorted(names, key=order)[:most])


@pytest.hookimpl(tryfirst=True)  # marks are looked at afterwards
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Marks as nightly what the normal run leaves out, but for cases that are asked for by name."""
    if config.option.keyword or any("::" in each for each in config.args):
        return
    cases: dict[tuple[Path, str], list[pytest.Function]] = defaultdict(list)
    for item in items:
        if item.get_closest_marker("nightly") is None and hasattr(item, "callspec"):
            assert isinstance(item, pytest.Function)
            cases[item.path, item.originalname].append(item)
    for (path, _), own in cases.items():
        names = [each.callspec.id for each in own]
        if path.stem == "test_statements":
            long = [name for name in names if name in LONG]
            short = [name for name in names if name not in LONG]
            kept = some(long, LONG_ONE_IN) | some(short, SHORT_ONE_IN)
        elif path.stem in ONE_IN and len(names) >= FEW:
            kept = some(names, ONE_IN[path.stem])
        else:
            continue
        for each in own:
            if each.callspec.id not in kept:
                each.add_marker(pytest.mark.nightly)
