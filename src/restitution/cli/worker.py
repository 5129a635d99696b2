"""The process that solves for the commands."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from restitution.export.job import Job, Reply
    from restitution.killable import Worker


def new_worker() -> Worker:
    """The process that solves, which begins at once to load what it needs."""
    from restitution.killable import Worker

    load_shared()

    return Worker(_serve, _prepare, _rehearse)


def load_shared() -> None:
    """Load what both processes need before they part, and nothing else: so both go on at once."""
    import restitution.export.job
    import restitution.expression.reading
    import restitution.language.checking
    import restitution.language.measuring  # noqa: F401


def _prepare() -> None:
    from restitution.export.job import prepare

    prepare()


def _rehearse() -> None:
    from restitution.export.job import rehearse

    rehearse()


def _serve(job: Job) -> Reply:
    from restitution.export.job import serve

    return serve(job)
