"""What is done with a statement in a process of its own: text in, JSON out."""

from __future__ import annotations

from restitution.errors import RestitutionError
from restitution.export import contract
from restitution.export.job import Job, Writing, serve
from restitution.language import parse

FILE = "statement"


def solved(statement: str, limit: float) -> str:
    """The JSON of ``restitution solve --format json``."""
    try:
        problem = parse(statement)
    except RestitutionError as error:
        return contract.to_json(contract.unreadable(FILE, error))
    try:
        return str(serve(Job(FILE, problem, Writing("json"), limit)).content).rstrip("\n")
    except RestitutionError as error:
        return contract.to_json(contract.unfinished(FILE, problem, error))
