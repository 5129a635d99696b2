"""Limits of work: counted, or by the clock, in any thread, one inside another."""

from __future__ import annotations

import threading

import pytest

import restitution as r
from restitution import work
from restitution.errors import ImpossibleError, TimeLimitError, UnsupportedError
from restitution.solving.story.forward import Story

CORNER = """
sphere P: mass 2, velocity 4i - 3j
wall W: along i
P hits W: e = 1/2
find speed(P), impulse
"""


def long(items: int) -> r.Problem:
    """A statement of so many items, each of which has to be worked out for itself."""
    asked = [
        f"find speed(P) + {n} m/(m + 1), speed(P) - {n} m^2/(m + 1)"
        for n in range(1, items // 2 + 1)
    ]
    return r.parse(CORNER.replace("mass 2", "mass m") + "\n".join(asked))


def test_operations_are_counted():
    with work.limited(operations=10) as limit:
        work.spend(4)
        work.spend(6)
        assert limit.left == 0
        with pytest.raises(UnsupportedError):
            work.spend()
    work.spend(10**9)  # nothing is left behind


def test_a_limit_has_its_own_error():
    with work.limited(operations=1, error=ImpossibleError("no more")):  # noqa: SIM117
        with pytest.raises(ImpossibleError, match="no more"):
            work.spend(2)


def test_limits_nest():
    with work.limited(operations=100) as outer:
        with work.limited(operations=5), pytest.raises(UnsupportedError):
            work.spend(6)
        assert outer.left == 100, "the inner one refused the step before it was begun"
        with work.limited(operations=1000), pytest.raises(UnsupportedError):
            work.spend(101)
        with work.limited():
            pass


def test_a_clock_stays_over_and_is_confirmed():
    with work.limited(seconds=0) as limit:
        work.confirm()
        for _ in range(2):
            with pytest.raises(TimeLimitError):
                work.spend()
        assert limit.broken
        with pytest.raises(TimeLimitError):
            work.confirm()
    work.confirm()


def test_a_clock_around_other_limits():
    with work.limited(seconds=0), work.limited(operations=10**9), pytest.raises(TimeLimitError):
        work.spend()


def test_what_is_remembered_counts_as_much_as_before():
    calls = []

    @work.remembered(10)
    def square(x: int) -> int:
        calls.append(x)
        work.spend(x)
        return x * x

    for _ in range(2):
        with work.limited(operations=7) as limit:
            assert square(5) == 25
            assert (limit.left, limit.used) == (2, 5)
            with pytest.raises(UnsupportedError):
                square(5)
    assert calls == [5]


def test_what_a_clock_broke_off_is_not_remembered():
    @work.remembered(10)
    def square(x: int) -> int:
        try:
            work.spend()
        except TimeLimitError:
            return 0  # another way was tried
        return x * x

    with work.limited(seconds=0), pytest.raises(TimeLimitError):
        square(5)
    assert square(5) == 25


def test_the_story_of_plain_numbers_is_told_once_exactly_and_once_in_numbers(monkeypatch):
    exact = []
    begin = Story.__init__

    def counted(self, problem, part, arithmetic, *rest, **named):
        exact.append(arithmetic.exact)
        begin(self, problem, part, arithmetic, *rest, **named)

    monkeypatch.setattr(Story, "__init__", counted)
    solution = r.solve(r.parse(CORNER))
    assert str(solution["speed(P)"].exact) == "sqrt(73)/2"
    assert sorted(exact) == [False, True]


def test_solving_keeps_what_is_solved():
    problem = r.parse(CORNER)
    solution = r.solve(problem, time_limit=1e-9)
    for item in solution.parts[None].items:
        assert isinstance(item.error, TimeLimitError)
        assert "time limit of 1e-09 s" in item.error.message
    assert r.solve(problem)["speed(P)"].error is None
    assert r.solve(problem, time_limit=1000)["speed(P)"].error is None


def test_explaining_is_whole_or_not_at_all():
    solution = r.solve(r.parse(CORNER))
    with pytest.raises(TimeLimitError, match="time limit of 1e-09 s"):
        r.explain(solution, time_limit=1e-9)
    assert str(r.explain(solution, time_limit=1000)) == str(r.explain(solution))


@pytest.mark.parametrize("limit", [-1, -0.5, float("nan"), "5"])
def test_a_time_limit_is_not_negative(limit):
    problem = r.parse(CORNER)
    with pytest.raises(ValueError, match="a time limit is"):
        r.solve(problem, time_limit=limit)
    with pytest.raises(ValueError, match="a time limit is"):
        r.explain(r.solve(problem), time_limit=limit)


def test_a_time_limit_of_0_is_none_as_in_the_command():
    solution = r.solve(r.parse(CORNER), time_limit=0)
    assert solution["speed(P)"].error is None
    assert str(r.explain(solution, time_limit=0)) == str(r.explain(solution))


def test_each_thread_has_its_own():
    """One is stopped by its limit while the other, at the same time, solves all."""
    results: dict[str, r.Solution] = {}
    begun = threading.Barrier(2)

    def run(name: str, problem: r.Problem, limit: float | None) -> None:
        begun.wait()
        results[name] = r.solve(problem, time_limit=limit)

    threads = [
        threading.Thread(target=run, args=("short", long(1800), 0.5)),
        threading.Thread(target=run, args=("long", r.parse(CORNER), 1000.0)),
    ]
    for each in threads:
        each.start()
    for each in threads:
        each.join()
    assert all(item.error is None for item in results["long"].parts[None].items)
    errors = [item.error for item in results["short"].parts[None].items]
    assert isinstance(errors[-1], TimeLimitError)
    stopped = [isinstance(error, TimeLimitError) for error in errors]
    assert stopped == sorted(stopped), "what was solved before is kept"
