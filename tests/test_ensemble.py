"""Many cases: in order, reproducible, and none lost, whatever happens to some of them."""

from __future__ import annotations

import math
import os
import pickle
import random
import signal
import subprocess
import sys
import time
from concurrent.futures import Executor, Future, ProcessPoolExecutor, ThreadPoolExecutor
from importlib.util import module_from_spec, spec_from_file_location
from itertools import count, islice, pairwise
from multiprocessing import get_context
from pathlib import Path
from statistics import median
from textwrap import dedent

import numpy as np
import pytest

from restitution import RestitutionError, StatementError, ensemble
from restitution.batch.ensemble import EnsembleInterrupt, Failure

EXAMPLE = Path(__file__).parents[1] / "docs" / "examples" / "break_shot.py"


class Inline(Executor):
    """Works at once, in the thread that asks, and counts how much was ever under way."""

    def __init__(self) -> None:
        self.sent = 0

    def submit(self, function, /, *args, **kwargs):
        self.sent += 1
        future = Future()
        try:
            future.set_result(function(*args, **kwargs))
        except BaseException as error:  # noqa: BLE001
            future.set_exception(error)
        return future


class Unsendable(Exception):  # noqa: N818
    """Pickles, but cannot be put together again."""

    def __init__(self, first, second):
        super().__init__(first)


def square(case):
    return case * case


def at_random_pace(case):
    time.sleep(random.random() / 200)
    return case


def drawn(case, rng):
    return case, rng.random(3).tolist(), int(rng.integers(2**62))


def picky(case):
    if case % 10 == 3:
        raise Unsendable(case, "is not liked")
    return case


def value_that_cannot_be_sent(case):
    return (lambda: case) if case == 7 else case


def deadly(case):
    if case in (5, 40):
        os._exit(1)
    return case


def always_deadly(case):
    os._exit(1)


# --- order, executors ------------------------------------------------------------------------


@pytest.mark.parametrize("kind", [ThreadPoolExecutor, ProcessPoolExecutor])
def test_in_the_order_of_the_cases(kind):
    with kind(3) as executor:
        result = ensemble(at_random_pace, range(60), executor, workers=3)
    assert result.values == tuple(range(60))
    assert result.all_values() == result.values
    assert (result.failures, result.missing, result.stopped) == ((), (), "")


def test_a_pool_of_processes_by_default():
    assert ensemble(square, range(500)).all_values() == tuple(k * k for k in range(500))
    assert ensemble(square, []).values == ()
    values = ensemble(process_of, range(3), workers=1).values
    assert len(set(values)) == 1 and os.getpid() not in values


def process_of(case):
    return os.getpid()


def test_processes_that_are_started_afresh():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as executor:
        assert ensemble(square, range(5), executor).all_values() == (0, 1, 4, 9, 16)


def test_dask():
    from distributed import Client, LocalCluster

    with (
        LocalCluster(
            n_workers=1,
            threads_per_worker=2,
            processes=False,
            dashboard_address=None,
            silence_logs=False,
        ) as cluster,
        Client(cluster) as client,
        client.get_executor() as executor,
    ):
        result = ensemble(drawn, range(30), executor, seed=5)
        with_failures = ensemble(picky, range(30), executor)
    assert result.all_values() == ensemble(drawn, range(30), Inline(), seed=5).values
    assert [each.index for each in with_failures.failures] == [3, 13, 23]


# --- seeds -----------------------------------------------------------------------------------


def test_seeds_depend_on_the_place_of_a_case_alone():
    expected = ensemble(drawn, "abcdefghij" * 5, Inline(), seed=11).all_values()
    assert ensemble(drawn, "abcdefghij" * 5, workers=2, seed=11).all_values() == expected
    assert ensemble(drawn, "abcdefghij" * 5, workers=1, seed=11).all_values() == expected
    with ThreadPoolExecutor(4) as executor:
        assert ensemble(drawn, iter("abcdefghij" * 5), executor, seed=11).values == expected
    longer = ensemble(drawn, "abcdefghij" * 6, Inline(), seed=11).values
    assert longer[:50] == expected
    assert len({numbers for _, _, numbers in longer}) == 60
    assert ensemble(drawn, "abc", Inline(), seed=12).values != expected[:3]


@pytest.mark.parametrize("seed", [0, 2**100, (1, 2, 3)])
def test_seeds_are_those_that_numpy_spawns(seed):
    generators = [np.random.default_rng(each) for each in np.random.SeedSequence(seed).spawn(4)]
    expected = [generator.random(3).tolist() for generator in generators]
    values = ensemble(drawn, range(4), Inline(), seed=seed).all_values()
    assert [numbers for _, numbers, _ in values] == expected


# --- failures --------------------------------------------------------------------------------


@pytest.mark.parametrize("processes", [True, False])
def test_exceptions_are_kept_with_their_cases(processes):
    result = ensemble(picky, range(40), None if processes else Inline())
    assert [each.index for each in result.failures] == [3, 13, 23, 33]
    assert [each.case for each in result.failures] == [3, 13, 23, 33]
    assert all(each.error.endswith("Unsendable: 3") for each in result.failures[:1])
    assert "in picky" in result.failures[0].traceback
    assert "raise Unsendable" in result.failures[0].traceback
    assert result.values == tuple(None if k % 10 == 3 else k for k in range(40))
    assert result.missing == ()
    with pytest.raises(RestitutionError, match="36 worked out, 4 failed"):
        result.all_values()
    assert pickle.loads(pickle.dumps(result)) == result


def test_summary():
    text = str(ensemble(picky, (k if k else "x" * 200 for k in range(90)), Inline()))
    lines = text.splitlines()
    assert lines[0] == "90 cases: 80 worked out, 10 failed"
    assert lines[1].startswith("  case 0, 'xxx") and len(lines[1]) < 190
    assert lines[-1] == "  and 5 more in .failures"
    assert len(lines) == 7
    assert str(ensemble(square, [1], Inline())) == "1 case: 1 worked out, 0 failed"


def test_a_value_that_cannot_be_sent_costs_its_own_case_only():
    result = ensemble(value_that_cannot_be_sent, range(50))
    assert [each.index for each in result.failures] == [7]
    assert "<lambda>" in result.failures[0].error
    assert result.values == tuple(None if k == 7 else k for k in range(50))


def test_a_worker_that_dies_costs_its_own_case_only():
    result = ensemble(deadly, range(80), workers=2)
    assert [(each.index, each.case) for each in result.failures] == [(5, 5), (40, 40)]
    assert all("BrokenProcessPool" in each.error for each in result.failures)
    assert result.values == tuple(None if k in (5, 40) else k for k in range(80))
    assert (result.missing, result.stopped) == ((), "")


def test_workers_that_always_die():
    result = ensemble(always_deadly, range(100), workers=2)
    assert result.stopped.startswith("worker processes died")
    assert 1 <= len(result.failures) < 10
    assert len(result.failures) + len(result.missing) == 100
    assert "stopped: worker processes died" in str(result)


def test_an_executor_that_breaks():
    """What was done before is kept, and what was not begun is named."""
    with ProcessPoolExecutor(1) as executor:
        result = ensemble(deadly, range(300), executor, workers=1)
    assert "broke" in result.stopped
    failed = [each.index for each in result.failures]
    assert 5 in failed
    for k, value in enumerate(result.values):
        assert (value == k) + (k in failed) + (k in result.missing) == 1
    assert result.values[0] == 0 and 299 in result.missing


class Cancelling(Inline):
    """Cancels what it is given, at first, as a cluster does that loses its workers."""

    def __init__(self, times: int) -> None:
        super().__init__()
        self.left = times

    def submit(self, function, /, *args, **kwargs):
        future = super().submit(function, *args, **kwargs) if self.left <= 0 else Future()
        self.left -= 1
        if future.cancel():
            future.set_running_or_notify_cancel()
        return future


def test_what_is_cancelled_is_tried_once_more():
    assert ensemble(square, range(9), Cancelling(2), workers=1).all_values()[8] == 64
    result = ensemble(square, range(9), Cancelling(10**6), workers=1)
    assert len(result.failures) == 9 and "Cancelled" in result.failures[0].error


def test_an_executor_that_is_shut_down_on_the_way():
    """It takes nothing more; what it had done is kept."""
    executor = ThreadPoolExecutor(1)

    def last(case):
        if case == 3:
            executor.shutdown(wait=False)
        return case

    result = ensemble(last, range(100), executor, workers=1)
    assert "after shutdown" in result.stopped
    assert result.values[:4] == (0, 1, 2, 3) and 99 in result.missing
    assert ensemble(square, [1, 2], executor).values == (None, None)


def test_cases_that_raise():
    """Those before the exception are worked out, also those drawn in one go with it."""

    def cases():
        yield from range(50)
        raise OSError("the disk is gone")

    for executor in (None, Inline()):
        result = ensemble(square, cases(), executor)
        assert result.values == tuple(case * case for case in range(50))
        assert result.stopped == "after 50 cases there came OSError: the disk is gone"
        with pytest.raises(RestitutionError, match="the disk is gone"):
            result.all_values()


class Unshowable:
    def __repr__(self):
        raise ValueError


def test_a_case_that_cannot_be_shown():
    result = ensemble(math.sqrt, [Unshowable()], Inline())
    assert "case 0, of type Unshowable: TypeError" in str(result)


@pytest.mark.parametrize(
    ("cases", "options", "message"),
    [
        (5, {}, "the cases are 5"),
        ([5], {"executor": 3}, "the executor is 3"),
        ([5], {"workers": "two"}, "workers is a whole number, not 'two'"),
        ([5], {"workers": 1.5}, "workers is a whole number, not 1.5"),
        ([5], {"seed": -1}, "seed = -1: expected non-negative"),
        ([5], {"seed": "luck"}, "seed = 'luck': "),
    ],
)
def test_errors_name_what_is_wrong(cases, options, message):
    with pytest.raises(StatementError, match=message):
        ensemble(square, cases, **options)


def test_function_that_cannot_be_sent():
    with pytest.raises(StatementError, match="define it at the top of a module"):
        ensemble(lambda case: case, range(3))
    with pytest.raises(StatementError, match="workers = 0"):
        ensemble(square, range(3), workers=0)


# --- many cases, and Ctrl-C --------------------------------------------------------------------


def test_cases_are_drawn_as_they_are_needed():
    drawn_so_far = 0

    def cases():
        nonlocal drawn_so_far
        for case in count():
            drawn_so_far += 1
            yield case

    ahead = []

    def slow_at_first(case):
        if case == 0:
            time.sleep(0.1)
            ahead.append(drawn_so_far)
        return case

    with ThreadPoolExecutor(1) as executor:
        result = ensemble(slow_at_first, islice(cases(), 100), executor, workers=1)
    assert result.all_values() == tuple(range(100))
    assert ahead == [2]


def test_many_short_cases_are_sent_in_few_chunks():
    executor = Inline()
    assert len(ensemble(square, range(20_000), executor).all_values()) == 20_000
    assert executor.sent < 200


def test_interrupted():
    def stop_at_50(case):
        if case == 50:
            raise KeyboardInterrupt
        return case

    with pytest.raises(EnsembleInterrupt) as caught:
        ensemble(stop_at_50, range(100), Interrupted())
    result = caught.value.ensemble
    assert result.stopped == "Ctrl-C"
    assert isinstance(caught.value, KeyboardInterrupt)
    done = [value for value in result.values if value is not None]
    assert done and done == list(range(len(done)))
    assert result.missing == tuple(range(len(done), 100))
    assert "not begun" in str(caught.value)


class Interrupted(Inline):
    """Ctrl-C comes while a chunk is being sent."""

    def submit(self, function, /, *args, **kwargs):
        future = super().submit(function, *args, **kwargs)
        if isinstance(future.exception(), KeyboardInterrupt):
            raise KeyboardInterrupt
        return future


def test_ctrl_c_in_a_terminal(tmp_path):
    """The signal goes to the workers as well; nothing hangs, and nothing is printed by them."""
    script = tmp_path / "long.py"
    script.write_text(
        dedent("""
        import signal
        import sys
        import time
        from pathlib import Path
        from restitution import ensemble
        from restitution.batch.ensemble import EnsembleInterrupt

        # What runs in the background of a script ignores Ctrl-C; a terminal does not.
        signal.signal(signal.SIGINT, signal.default_int_handler)

        def slow(case):
            if case >= 4:
                Path(sys.argv[1], f"case{case}").touch()
                time.sleep(60)
            else:
                time.sleep(0.5)  # so that no chunk has more than one of them
            return case

        if __name__ == "__main__":
            try:
                print("begun", flush=True)
                ensemble(slow, range(10), workers=2)
            except EnsembleInterrupt as stopped:
                print(stopped.ensemble.values[:4], stopped.ensemble.missing)
        """),
        encoding="utf-8",
    )
    process = subprocess.Popen(
        [sys.executable, script, tmp_path],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stdout.readline() == "begun\n"
    while len(list(tmp_path.glob("case*"))) < 2:  # both workers are at work
        assert process.poll() is None
        time.sleep(0.05)
    time.sleep(0.5)
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=100)
    assert out == "(0, 1, 2, 3) (4, 5, 6, 7, 8, 9)\n"
    assert err == ""


# --- progress ----------------------------------------------------------------------------------


def test_progress(capfd):
    ensemble(square, range(1_234), Inline())
    assert capfd.readouterr().err == ""  # not a terminal
    ensemble(square, range(1_234), Inline(), progress=True)
    assert "1,234 of 1,234 cases" in capfd.readouterr().err
    ensemble(square, iter(range(50)), Inline(), progress=True)
    assert "50 cases, " in capfd.readouterr().err


def test_failure_shows_itself_shortly():
    assert repr(Failure(1, 2, "E: x", "long" * 100)) == "Failure(index=1, case=2, error='E: x')"


# --- the worked example --------------------------------------------------------------------------


@pytest.fixture(scope="module")
def example():
    spec = spec_from_file_location("break_shot", EXAMPLE)
    module = module_from_spec(spec)
    sys.modules[spec.name] = module  # where its dataclasses look for their types
    spec.loader.exec_module(module)
    yield module
    del sys.modules[spec.name]


def test_first_hit_of_a_break_shot(example):
    """By the triangle of the foremost ball, the place of the hit and the start of the cue ball."""
    way = example.LENGTH / 2
    for aim in (-0.02, -0.004, 0.0, 0.013, 0.03):

        def after(aim):
            between = math.asin(way * math.sin(aim) / (2 * example.RADIUS))
            along = example.SPEED * math.cos(between) * (1 - example.E) / 2
            across = example.SPEED * math.sin(between)
            return aim - between + math.atan2(across, along)

        first = example.shot(aim)[0]
        assert first.angle == pytest.approx(after(aim), abs=1e-12)
        slope = abs(after(aim + 1e-6) - after(aim - 1e-6)) / 2e-6
        assert first.slope == pytest.approx(slope, rel=1e-2)
        assert first.number == 1


def test_break_shots_drift_apart(example):
    """Every hit makes a small difference several times as large, and the mirror image is one."""
    shots = [
        ensemble(example.shot, [side * k / 700 for k in range(1, 12)]).all_values()
        for side in (1, -1)
    ]
    for left, right in zip(*shots):
        for one, other in zip(left[:3], right[:3]):
            assert math.remainder(one.angle + other.angle, math.tau) == pytest.approx(
                0, abs=1e-13 * one.slope
            )
    medians = [
        median(hits[n].slope for hits in shots[0] if len(hits) > n) for n in range(example.HITS)
    ]
    assert all(later > 3 * sooner for sooner, later in pairwise(medians))
