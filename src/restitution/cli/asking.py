"""One file from its statement to what was asked of it, by the process that solves."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from restitution.cli.files import debugging, one_line, parse, pointed, read, say, shown_name
from restitution.cli.statuses import REPORT, UNANSWERED, UNREADABLE
from restitution.cli.worker import new_worker
from restitution.errors import LettersError, RestitutionError
from restitution.records import dataclass

if TYPE_CHECKING:
    from restitution.export.job import Job, Reply, Task
    from restitution.killable import Worker


@dataclass(frozen=True)
class Answer:
    """What became of one file: its exit status, what was made, and what is said of it."""

    status: int
    content: Any = None
    messages: tuple[str, ...] = ()


def worker_of(early: Worker | None) -> Worker:
    """The process that was started with the command, or one of its own."""
    return early or new_worker()


def answer(
    worker: Worker, file: str, task: Task, limit: float | None, letters: tuple[str, str] = ("", "")
) -> Answer:
    """Read a file and have the task done; what is wrong is told, in JSON too if that is asked.

    ``letters`` are the name and the text of a letters file, for what is wrong in that.
    """
    from restitution.export import contract
    from restitution.export.job import Job, Writing
    from restitution.problem import require_part

    writing = task if isinstance(task, Writing) else Writing()
    json = writing.form == "json"
    part = _part_of(task)
    text = b""
    try:
        text = read(file)
        problem = parse(text)
        require_part(problem, part)
    except RestitutionError as error:
        line = contract.to_json(contract.unreadable(shown_name(file), error)) + "\n"
        return Answer(UNREADABLE, line if json else None, tuple(pointed(file, text, error)))
    job = Job(shown_name(file), problem, task, limit)
    try:
        reply = _reply(worker, job)
    except RestitutionError as error:
        unfinished = contract.unfinished(job.file, problem, error, part)
        content = contract.with_derivations(unfinished) if writing.working else unfinished
        line = contract.to_json(content) + "\n"
        return Answer(UNANSWERED, line if json else None, tuple(pointed(file, text, error)))
    messages = [f"{job.file}: warning: {warning}" for warning in reply.warnings]
    messages += [f"{job.file}: {note}" for note in reply.notes]
    for missing in reply.errors:
        if isinstance(missing, LettersError):
            messages += pointed(letters[0], letters[1].encode(), missing)
        else:
            messages += pointed(file, text, missing)
    if reply.fault:
        messages.append(
            reply.fault
            if debugging()
            else f"{job.file}: internal error: the working could not be written; {REPORT}"
        )
    failed = UNREADABLE if reply.unreadable else UNANSWERED
    return Answer(0 if reply.answered else failed, reply.content, tuple(messages))


def _reply(worker: Worker, job: Job) -> Reply:
    """The reply to a job; whatever else happens, as a RestitutionError."""
    from restitution.errors import UnsupportedError
    from restitution.export.job import stopped
    from restitution.killable import LostError

    try:
        reply: Reply = worker.ask(job, job.limit)
    except TimeoutError:
        raise stopped(job.limit) from None
    except LostError as error:
        if debugging() and error.details:
            say(error.details)
        raise UnsupportedError(f"internal error: {one_line(error)}; {REPORT}") from None
    if reply.tired:
        worker.close()
    return reply


def _part_of(task: Task) -> str | None:
    from restitution.export.job import Marking, Playing, Writing

    if isinstance(task, Marking):
        return task.workings.part
    return task.part if isinstance(task, Writing | Playing) else None
