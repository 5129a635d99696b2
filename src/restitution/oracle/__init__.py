"""One oracle for every claim about letters: proved, refuted with a witness, or undecided.

It knows no story: claims and facts are relations between expressions, or trees of the statement
language (`of_tree`), and roles say what each letter may be.
"""

from __future__ import annotations

from restitution.oracle.formula import (
    FALSE,
    TRUE,
    All,
    Formula,
    Relation,
    Some,
    compared,
    joined,
    letters_of,
    negation,
    put_in,
    relations,
)
from restitution.oracle.oracle import (
    Answer,
    Oracle,
    Proof,
    Verdict,
    broken_off,
)
from restitution.oracle.points import BeyondError, Point, Program, as_number
from restitution.oracle.roles import REAL, Role
from restitution.oracle.testers import holds_at, holds_with

__all__ = [
    "FALSE",
    "REAL",
    "TRUE",
    "All",
    "Answer",
    "BeyondError",
    "Formula",
    "Oracle",
    "Point",
    "Program",
    "Proof",
    "Relation",
    "Role",
    "Some",
    "Verdict",
    "as_number",
    "broken_off",
    "compared",
    "holds_at",
    "holds_with",
    "joined",
    "letters_of",
    "negation",
    "put_in",
    "relations",
]
