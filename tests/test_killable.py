"""The process that solves: what it does before its first request, and how it ends."""

from __future__ import annotations

import gc
import os
import sys
import time

import pytest

from restitution.export import job
from restitution.killable import LostError, Worker

_rehearsals: list[None] = []


def nothing():
    pass


_gate = os.pipe()


def loading():
    """Lasts until a request is sent."""
    os.read(_gate[0], 1)


class Sending:
    """The asker's end of a pipe, which opens the gate when a request has gone."""

    def __init__(self, pipe):
        self.pipe = pipe

    def __getattr__(self, name):
        return getattr(self.pipe, name)

    def send(self, request):
        self.pipe.send(request)
        os.write(_gate[1], b"!")


def failing():
    raise ValueError("nothing to load")


def rehearse():
    _rehearsals.append(None)


def rehearse_badly():
    rehearse()
    raise ValueError("forgot the text")


def serve(request):
    if request == "rehearsed?":
        return bool(_rehearsals)
    if request == "end":
        os._exit(3)
    if request == "last":
        time.sleep(60)
    return request


def asked_late(rehearsal):
    """Whether a process has rehearsed that was left alone until it must have."""
    with Worker(serve, nothing, rehearsal) as worker:
        deadline = time.monotonic() + 30
        # It takes up its first request only after the rehearsal: a second is answered by then.
        while not (rehearsed := worker.ask("rehearsed?")) and time.monotonic() < deadline:
            worker.close()
            worker._start()
            time.sleep(0.2)
        return rehearsed, worker.ask("well?", 10)


def test_a_process_left_alone_rehearses():
    assert asked_late(rehearse) == (True, "well?")


def test_a_rehearsal_that_fails_keeps_no_request_from_its_answer():
    assert asked_late(rehearse_badly) == (True, "well?")


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="a fork shares the gate")
def test_who_asks_before_all_is_loaded_does_not_wait_for_a_rehearsal():
    with Worker(serve, loading, rehearse) as worker:
        worker._pipe = Sending(worker._pipe)
        assert worker.ask("rehearsed?") is False


def test_why_loading_failed_is_said_though_the_process_has_ended():
    worker = Worker(serve, failing)
    worker._process.join()
    with worker, pytest.raises(LostError, match="a fault of the program") as lost:
        worker.ask("anything")
    assert "nothing to load" in lost.value.details


def test_a_process_that_ends_is_lost_and_the_next_request_has_another():
    with Worker(serve, nothing) as worker:
        with pytest.raises(LostError, match="ended without an answer"):
            worker.ask("end")
        assert worker.ask("again") == "again"
        with pytest.raises(TimeoutError):
            worker.ask("last", 0.2)
        assert worker.ask("again") == "again"


def test_the_rehearsal_is_a_question_that_is_solved_and_explained(monkeypatch):
    replies = []
    served = job.serve
    monkeypatch.setattr(job, "serve", lambda each: replies.append(served(each)))
    job.rehearse()
    (reply,) = replies
    assert reply.answered
    assert not (reply.errors or reply.fault)
    assert "Newton's experimental law" in reply.content


def test_a_process_that_works_seldom_looks_for_garbage() -> None:
    from restitution.export.job import prepare

    before = gc.get_threshold()
    try:
        gc.set_threshold(700, 10, 10)
        prepare()
        assert gc.get_threshold()[0] > 10_000 and gc.isenabled()
    finally:
        gc.set_threshold(*before)
