"""What is done with a statement in a process of its own: plain values in, text or bytes out."""

from __future__ import annotations

import gzip
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from restitution.errors import RestitutionError, StatementError, TimeLimitError, UnsupportedError
from restitution.export import contract
from restitution.export.job import Job, Picturing, Setting, Showing, Task, Writing, serve, stopped
from restitution.language import parse
from restitution.problem import Problem, require_part
from restitution.records import dataclass
from restitution.work import limited

if TYPE_CHECKING:
    from restitution.explaining.lines.marks import Style
    from restitution.export.objects import ExplainedObject, PicturesObject, SolvedObject
    from restitution.practice.marking.objects import MarkingObject, PartsMarkedObject

Object = dict[str, Any]

FILE = "statement"
"""What the contract's object calls the file."""


@dataclass(frozen=True)
class Payload:
    """A reply: JSON, or a PDF.

    ``tired`` tells that the work was broken off, so that its process should end, and that another
    time more may come of it. ``fault`` is the traceback of a failure of the program. What is
    ``packed`` is so by gzip: done here, it keeps nobody waiting whom the server answers meanwhile.
    """

    content: bytes
    kind: str = "application/json"
    status: int = 200
    tired: bool = False
    fault: str = ""
    packed: bool = False


def checked(statement: str) -> Payload:
    """The contract's object of a problem that nobody has solved yet, with all its mistakes."""
    try:
        return _json(contract.checked(FILE, parse(statement), None))
    except RestitutionError as mistake:
        return _json(contract.checked(FILE, None, mistake))


def outlined(statement: str) -> Payload:
    """The pieces of a statement, for a form; null with all its mistakes where it cannot be read."""
    from restitution.export.outline import outline

    try:
        return _json({"outline": outline(parse(statement)), "errors": []})
    except RestitutionError as mistake:
        return _json({"outline": None, "errors": contract.mistakes(mistake)})


def solved(
    statement: str,
    limit: float,
    part: str | None = None,
    working: bool = False,
    marks: Style = "fm1",
) -> Payload:
    """The object of ``restitution solve --format json``, and with ``--working``."""
    return _payload_of(statement, Writing("json", part, working=working, marks=marks), limit)


def drawn(statement: str, limit: float, event: int | None = None) -> Payload:
    """The same with ``pictures`` and ``pictures_error``; an error where there is no such event."""
    try:
        _require_event(parse(statement), event)
    except _NoEventError as error:
        return _failed(error)
    except RestitutionError:
        pass  # of a statement that cannot be read there is more to tell
    return _payload_of(statement, Picturing(event), limit, **_NO_PICTURES)


def explained(statement: str, limit: float, early: str | None = None) -> Payload:
    """All that a page shows, the object of the contract as its ``answer``.

    What comes before the working is written into the file ``early``, as soon as it is there.
    """

    def write(content: ExplainedObject) -> None:
        if early is not None:
            growing = Path(f"{early}.part")
            growing.write_bytes(contract.to_json(content).encode())
            growing.replace(early)

    return _payload_of(statement, Showing(write), limit)


def on_a_sheet(
    statement: str,
    limit: float,
    solutions: bool,
    diagrams: bool,
    title: str | None,
    room: bool,
    marks: Style = "fm1",
) -> Payload:
    """A PDF; or the error, as JSON, of a statement that cannot be set."""
    from restitution.export.sheet import Options, to_document
    from restitution.render.document.typst import to_pdf

    options = Options(solutions, diagrams, None if room else 0.0, marks)
    try:
        reply = serve(Job(FILE, parse(statement), Setting(options), limit))
        document = to_document([reply.content], title, options)
        return Payload(to_pdf(document), "application/pdf", tired=reply.tired)
    except RestitutionError as error:
        return _failed(error)


def simulated(scene: Object, limit: float) -> Payload:
    """The motion of a scene of the Lab."""
    from restitution.export import lab

    return _tried(lambda: lab.simulated(scene))


def put_as_a_question(impact: Object, limit: float) -> Payload:
    """The statement of a question about an impact of the Lab."""
    from restitution.export import lab

    return _tried(lambda: {"statement": lab.question(impact)})


def marked(
    statement: str,
    limit: float,
    working: str = "",
    part: str | None = None,
    letters: Mapping[str, str] | None = None,
    hints: int | Mapping[str, int] = 0,
) -> Payload:
    """A working marked; an error where the question has no answer, or a letter no meaning."""
    from restitution.export.marking import marking_of
    from restitution.solving import solve

    def marking() -> MarkingObject | PartsMarkedObject:
        solution = solve(parse(statement))
        return marking_of(solution, working, part, letters or {}, hints)

    with limited(limit, error=stopped(limit)):
        return _tried(marking)


def played_mistake(
    statement: str, limit: float, mistake: str = "", part: str | None = None
) -> Payload:
    """The motion of a question with that of a mistake beside it, as the player takes it."""
    from restitution.export.player.beside import of_mistake
    from restitution.solving import solve

    def motion() -> Object:
        return {"motion": of_mistake(solve(parse(statement)), mistake, part)}

    with limited(limit, error=stopped(limit)):
        return _tried(motion)


def to_practise(wanted: Object, limit: float) -> Payload:
    """A question to practise, with its letters box."""
    from restitution.export import practising

    with limited(limit, error=stopped(limit)):
        return _tried(lambda: practising.asked(wanted))


def progress(record: Object, limit: float) -> Payload:
    """How sure one is of each topic."""
    from restitution.export import practising

    return _tried(lambda: practising.progress(record))


def experiment(data: str, limit: float, *reading: Any) -> Payload:
    """The coefficient of restitution from a table; an error where the table does not give it.

    ``reading`` is how the table is read: the other arguments of `experimenting.experiment_of`.
    """
    from restitution.export import experimenting

    return _tried(lambda: experimenting.shown(experimenting.experiment_of(data, *reading)))


def report(data: str, limit: float, *reading: Any) -> Payload:
    """The report of an experiment as a PDF; or the error, as JSON, where there is none."""
    from restitution.experiments.report import report as written
    from restitution.export import experimenting

    try:
        content = written(experimenting.experiment_of(data, *reading), "pdf")
        return Payload(content, "application/pdf")
    except RestitutionError as error:
        return _failed(error)


def given_up(
    about: Any,
    task: Callable[..., Payload],
    message: str,
    late: bool,
    others: tuple[Any, ...] = (),
) -> Payload:
    """The reply for work whose process was killed, or ended by itself.

    It was to be done by ``task``, one of the functions above, which was told ``others`` as well.
    """
    error = (TimeLimitError if late else UnsupportedError)(message)
    if task not in (solved, drawn, explained):
        return _failed(error)
    content = contract.unfinished(FILE, parse(about), error)
    if task is explained:
        return _json(_nothing(content), tired=True)
    if task is solved and True in others[1:2]:  # the working too
        return _json(contract.with_derivations(content), tired=True)
    return _json({**content, **(_NO_PICTURES if task is drawn else {})}, tired=True)


_NO_PICTURES: PicturesObject = {"pictures": [], "pictures_error": None}


def _nothing(answer: SolvedObject) -> ExplainedObject:
    """What a page shows of a problem that could not be read or solved."""
    from restitution.export.working import Pieces

    return Pieces(warnings=answer["warnings"]).beside(answer)


def _tried(make: Callable[[], Mapping[str, object]]) -> Payload:
    """The reply with what ``make`` returns, or with its error."""
    try:
        return _json(make())
    except RestitutionError as error:
        return _failed(error)


def _failed(error: RestitutionError) -> Payload:
    """The reply with the error of a well-formed request that has no result."""
    reply = _json({"error": contract.mistakes(error)[0]}, error.kind == TimeLimitError.kind)
    return replace(reply, status=422)


def _payload_of(statement: str, task: Task, limit: float, **beside: Any) -> Payload:
    whole = isinstance(task, Showing)
    part = task.part if isinstance(task, Writing) else None
    problem: Problem | None = None
    try:
        problem = parse(statement)
        require_part(problem, part)
        reply = serve(Job(FILE, problem, task, limit))
    except RestitutionError as error:
        content = (
            contract.unreadable(FILE, error)
            if problem is None or isinstance(error, StatementError)
            else contract.unfinished(FILE, problem, error, part)
        )
        tired = error.kind == TimeLimitError.kind
        if isinstance(task, Writing) and task.working:
            return _json(contract.with_derivations(content), tired)
        return _json(_nothing(content) if whole else {**content, **beside}, tired)
    if isinstance(reply.content, str):
        return _packed(reply.content.rstrip("\n").encode(), reply.tired)
    return replace(_json(reply.content, reply.tired), fault=reply.fault)


class _NoEventError(StatementError):
    """An event that a statement does not tell of."""


def _require_event(problem: Problem, number: int | None) -> None:
    events = len(problem.events)
    if number is not None and not 1 <= number <= events:
        known = "1 event" if events == 1 else f"{events} events"
        raise _NoEventError(f"there is no event {_short(number)}: the statement tells of {known}")


def _short(number: int) -> str:
    digits = str(number)
    return digits if len(digits) <= _MANY else f"{digits[:_MANY]}… ({len(digits)} digits)"


_MANY = 40  # digits


def _json(content: Mapping[str, object], tired: bool = False) -> Payload:
    return _packed(contract.to_json(content).encode(), tired)


def _packed(text: bytes, tired: bool) -> Payload:
    if len(text) < _SMALL:
        return Payload(text, tired=tired)
    return Payload(gzip.compress(text, 6, mtime=0), tired=tired, packed=True)


_SMALL = 1000  # bytes, of which packing spares few
