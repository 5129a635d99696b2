"""What Hypothesis draws: the same examples everywhere; others, from a seed, under ``nightly``."""

from __future__ import annotations

import secrets

import pytest
from hypothesis import HealthCheck, is_hypothesis_test, seed, settings
from hypothesis.internal.conjecture import providers

SAME_EVERYWHERE = "same everywhere"

# No clock decides what is drawn, or whether a test passes: each has the time limit of every test.
settings.register_profile(
    SAME_EVERYWHERE,
    derandomize=True,
    print_blob=True,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
)
settings.load_profile(SAME_EVERYWHERE)

# Hypothesis also draws the constants that stand in the modules of the project which are loaded by
# then: others after a change, in another folder, or after other tests.
_CONSTANTS = "_get_local_constants"
assert hasattr(providers, _CONSTANTS), "where does Hypothesis take constants of modules from?"
setattr(providers, _CONSTANTS, providers.Constants)


def pytest_configure(config: pytest.Config) -> None:
    """One seed for all random draws; processes of pytest-xdist get the options of the first."""
    if config.option.hypothesis_seed is None:
        config.option.hypothesis_seed = str(secrets.randbelow(2**32))


def pytest_report_header(config: pytest.Config) -> str:
    """How to draw the same again."""
    number = config.option.hypothesis_seed
    return f"random draws (-m nightly): --hypothesis-seed={number}"


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Every property test stands twice: once for the normal run, once for ``nightly``."""
    if is_hypothesis_test(metafunc.function):
        both = [
            pytest.param("same", id=pytest.HIDDEN_PARAM),
            pytest.param("random", marks=pytest.mark.nightly),
        ]
        metafunc.parametrize("draws", both, indirect=True)


@pytest.fixture(autouse=True)
def draws(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> None:
    """Random draws for a test that is to have them."""
    if getattr(request, "param", "same") == "random":
        number = int(request.config.option.hypothesis_seed)
        test = request.function
        monkeypatch.setattr(test, "_hypothesis_internal_use_seed", None)  # put back afterwards
        seed(number)(test)
        request.node.add_report_section("call", "draws", f"--hypothesis-seed={number}")
