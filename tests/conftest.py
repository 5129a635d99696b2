"""What all tests share: which of them go together, a time limit, draws, a browser for pages."""

from __future__ import annotations

import gc
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import browsing
import bytecode  # noqa: F401 # before whatever it is to hold for
import pytest
from playwright.sync_api import Browser, BrowserContext, Page, expect
from statements import FILES, NAMES

# In these modules too a failed assertion says what it compared.
for _path in Path(__file__).parent.glob("laws_of_*.py"):
    pytest.register_assert_rewrite(_path.stem)

pytest_plugins = ["limits", "draws", "nights", "pytester"]

# Trees of expressions are freed when nobody refers to them: to look for circles among them as often
# as Python does takes a seventh of the time of all tests.
gc.set_threshold(200_000, 10, 10)

# A machine may be busy; what is awaited and does not come fails all the same.
expect.set_options(timeout=30_000)


def pytest_addoption(parser: pytest.Parser) -> None:
    """An option for who looks for one law of statements."""
    parser.addoption("--law", default="", help="laws of statements whose name holds these letters")


QUICK = {
    "test_algebra",
    "test_answer_table",
    "test_awarding",
    "test_bodies",
    "test_docs",
    "test_expression",
    "test_found_again",
    "test_impact",
    "test_impossible_coefficient",
    "test_inverse",
    "test_lab",
    "test_language",
    "test_law",
    "test_meeting_again",
    "test_oracle",
    "test_parsers",
    "test_physical_sense",
    "test_planning_events",
    "test_planning_notes",
    "test_planning_wide_angles",
    "test_problem_timeline",
    "test_project",
    "test_render",
    "test_statements",
    "test_trace",
    "test_units",
    "test_vacuous",
    "test_work",
}
"""Modules for ``-m quick``: of every layer some, none of a browser, of servers or of commands."""


def pytest_ignore_collect(collection_path: Path, config: pytest.Config) -> bool | None:
    """Nothing else is even read where only quick tests are wanted."""
    name = collection_path.stem
    if config.option.markexpr == "quick" and name.startswith("test_") and name not in QUICK:
        return True
    return None


@pytest.hookimpl(tryfirst=True)
def pytest_xdist_auto_num_workers(config: pytest.Config) -> int:
    """One more than there are processors, for the tests of pages wait most of their time.

    Quick ones do not, and each process has all to load.
    """
    return (os.cpu_count() or 1) + (config.option.markexpr != "quick")


@pytest.hookimpl(tryfirst=True)  # marks are looked at afterwards
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Which tests are quick, and which go to one process, sharing what takes long to make.

    That is all tests of a statement, for it is solved once; all of pages, for their server and
    their browser; all of a module, but of those whose tests have nothing in common.
    """
    few = frozenset(FILES[::40])
    groups = {item: _group(item) for item in items}
    items.sort(key=lambda item: _turn(item, groups[item]))
    for item in items:
        item.add_marker(pytest.mark.xdist_group(groups[item]))
        path = item.callspec.params.get("path") if hasattr(item, "callspec") else None
        one_of_many = item.path.stem == "test_statements" and path is not None
        if (
            item.path.stem in QUICK
            and item.get_closest_marker("nightly") is None
            and (not one_of_many or path in few)
        ):
            item.add_marker(pytest.mark.quick)


def pytest_collection_finish() -> None:
    """What is collected stays to the end: it is not looked through for what may be freed."""
    gc.freeze()


# Their tests take long, and share nothing.
SPREAD = {"test_cli", "test_never_hangs", "test_properties"}


def _group(item: pytest.Item) -> str:
    if isinstance(item, pytest.Function):
        if {"page", "served"} & set(item.fixturenames):
            return "pages"
        params = item.callspec.params if hasattr(item, "callspec") else {}
        path, name = params.get("path"), params.get("name")
        statement = path.stem if isinstance(path, Path) else name
        if statement in NAMES:
            return str(statement)
    return item.nodeid if item.path.stem in SPREAD else item.path.stem


def _turn(item: pytest.Item, group: str) -> int:
    """When a group begins, so that all processes have work to the end: the small ones come last.

    Pages wait for their server and their browser: they begin first, while others calculate.
    """
    if group == "pages":
        return 0
    return 2 if group in NAMES or group == item.nodeid else 1


@pytest.fixture(scope="session")
def browser_type_launch_args(browser_type_launch_args: dict[str, Any]) -> dict[str, Any]:
    """The machine's own Chromium, for pytest-playwright; tests that need it say so by ``page``."""
    found = browsing.browser()
    if found is None:
        reason = f"no browser: none of {', '.join(browsing.BROWSERS)} is installed"
        pytest.fail(reason) if os.environ.get("CI") else pytest.skip(reason)
    # To begin a process takes longer than most of what is done in a tab: all tabs share one, and
    # what draws is in the browser's own.
    arguments = [
        *browsing.ARGUMENTS,
        "--renderer-process-limit=1",
        "--disable-site-isolation-trials",
        "--disable-gpu",
        "--in-process-gpu",
    ]
    return {**browser_type_launch_args, "executable_path": found, "args": arguments}


@pytest.fixture(scope="session")
def context(browser: Browser) -> Iterator[BrowserContext]:
    """One for all tests, so that files which may be kept are fetched and compiled once."""
    with browser.new_context() as one:
        one.new_page()  # it stays open, so that the process of tabs does not end with each of them
        yield one


@pytest.fixture
def page(context: BrowserContext) -> Iterator[Page]:
    """A tab of its own for each test: what a tab keeps, no other sees."""
    with context.new_page() as one:
        yield one


@pytest.fixture(scope="session")
def served() -> Iterator[str]:
    """The page, served on a free port of this machine: its address, without a slash at its end."""
    from serving import serving

    from restitution.web import Settings

    # A slow machine leaves nothing out that another has.
    with serving(Settings(workers=2, time_limit=60)) as address:
        yield address
