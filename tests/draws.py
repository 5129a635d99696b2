"""What Hypothesis draws: the same examples everywhere; others, from a seed, under ``nightly``.

How many, a profile says: ``quick``, ``ci`` or ``nightly``.
"""

from __future__ import annotations

import secrets

import pytest
from hypothesis import HealthCheck, is_hypothesis_test, seed, settings
from hypothesis.internal.conjecture import providers

# No clock decides what is drawn, or whether a test passes: each has the time limit of every test.
COMMON = settings(
    derandomize=True,
    print_blob=True,
    deadline=None,
    suppress_health_check=[HealthCheck.too_slow],
)
SHARES = {"quick": 16, "ci": 4, "nightly": 1}
"""Of the examples that a test asks for, one in so many is drawn."""

FEWEST = 6
"""Examples of a test, where it asks for no fewer."""

for _name in SHARES:
    settings.register_profile(_name, COMMON)
settings.load_profile("ci")

# Hypothesis also draws the constants that stand in the modules of the project which are loaded by
# then: others after a change, in another folder, or after other tests.
_CONSTANTS = "_get_local_constants"
assert hasattr(providers, _CONSTANTS), "where does Hypothesis take constants of modules from?"
setattr(providers, _CONSTANTS, providers.Constants)


def pytest_configure(config: pytest.Config) -> None:
    """One seed for all random draws; processes of pytest-xdist get the options of the first."""
    if config.option.hypothesis_seed is None:
        config.option.hypothesis_seed = str(secrets.randbelow(2**32))


def profile_of(config: pytest.Config) -> str:
    """The profile of a run: by ``--hypothesis-profile``, or by the marks that it chooses."""
    named = config.getoption("--hypothesis-profile", None)
    if named in SHARES:
        return str(named)
    return "quick" if config.option.markexpr == "quick" else "ci"


def pytest_report_header(config: pytest.Config) -> str:
    """How to draw the same again."""
    number = config.option.hypothesis_seed
    return f"draws: {profile_of(config)}; random ones (-m nightly): --hypothesis-seed={number}"


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
    """A share of the examples of a test, the same ones; all of them, at random, at night."""
    drawn = getattr(request, "param", None)
    if drawn is None:
        return
    test = request.function
    profile = profile_of(request.config)
    if drawn == "random":
        number = int(request.config.option.hypothesis_seed)
        monkeypatch.setattr(test, "_hypothesis_internal_use_seed", None)  # put back afterwards
        seed(number)(test)
        request.node.add_report_section("call", "draws", f"--hypothesis-seed={number}")
        profile = "nightly"
    own = getattr(test, _SETTINGS, None) or settings.default
    assert own is not None
    most = own.max_examples
    few = max(most // SHARES[profile], min(FEWEST, most))
    monkeypatch.setattr(test, _SETTINGS, settings(own, max_examples=few), raising=False)


_SETTINGS = "_hypothesis_internal_use_settings"
