"""Elastic collisions in two dimensions: exact answers, worked solutions.

    >>> import restitution as r
    >>> A = r.Sphere("A", mass=2, velocity=(3, -4))
    >>> B = r.Sphere("B", mass=3, velocity=(2, 3))
    >>> r.impact(A, B, line_of_centres=(0, 1), e="3/7").after.A.velocity
    Vector(x=3, y=2)

Every name below is loaded when it is first used, so that importing the package costs next to
nothing: algebra comes in with the first question.
"""

from __future__ import annotations

import sys
from types import ModuleType
from typing import TYPE_CHECKING, Any

from restitution import first_names as _first_names

if TYPE_CHECKING:
    from restitution.batch.ensemble import ensemble
    from restitution.batch.impacts import impacts
    from restitution.errors import (
        CollapseError,
        ContradictionError,
        ImpossibleError,
        MissingError,
        RestitutionError,
        StatementError,
        TimeLimitError,
        UnsupportedError,
    )
    from restitution.experiments import experiment, experiment_plan
    from restitution.explaining.mistakes.consequences import solve_as
    from restitution.export.player import play
    from restitution.gas import Gas
    from restitution.impact import impact
    from restitution.language import parse, read, to_statement
    from restitution.motion import Table, simulate
    from restitution.practice.marking.marking import mark
    from restitution.practice.questions.generate import PracticeQuestion, practice_question
    from restitution.problem import Point, Problem, Sphere, Wall
    from restitution.solving import solve
    from restitution.vector import Vector
    from restitution.wording import question
    from restitution.workings import explain
    from restitution.workings.pictures import draw

    __version__: str

__all__ = [
    "CollapseError",
    "ContradictionError",
    "Gas",
    "ImpossibleError",
    "MissingError",
    "Point",
    "PracticeQuestion",
    "Problem",
    "RestitutionError",
    "Sphere",
    "StatementError",
    "Table",
    "TimeLimitError",
    "UnsupportedError",
    "Vector",
    "Wall",
    "__version__",
    "draw",
    "ensemble",
    "experiment",
    "experiment_plan",
    "explain",
    "impact",
    "impacts",
    "mark",
    "parse",
    "play",
    "practice_question",
    "question",
    "read",
    "simulate",
    "solve",
    "solve_as",
    "to_statement",
]

_NAMES_OF_MODULES = {
    "errors": (
        "CollapseError",
        "ContradictionError",
        "ImpossibleError",
        "MissingError",
        "RestitutionError",
        "StatementError",
        "TimeLimitError",
        "UnsupportedError",
    ),
    "workings.pictures": ("draw",),
    "workings": ("explain",),
    "export.player": ("play",),
    "impact": ("impact",),
    "language": ("parse", "read", "to_statement"),
    "motion": ("Table", "simulate"),
    "practice.marking.marking": ("mark",),
    "gas": ("Gas",),
    "batch.impacts": ("impacts",),
    "batch.ensemble": ("ensemble",),
    "experiments": ("experiment", "experiment_plan"),
    "practice.questions.generate": ("PracticeQuestion", "practice_question"),
    "problem": ("Point", "Problem", "Sphere", "Wall"),
    "solving": ("solve",),
    "explaining.mistakes.consequences": ("solve_as",),
    "vector": ("Vector",),
    "wording": ("question",),
}
_MODULE_OF_NAME = {name: module for module, names in _NAMES_OF_MODULES.items() for name in names}


def __getattr__(name: str) -> Any:
    if name == "__version__":
        from importlib.metadata import version

        value: Any = version(__name__)
    elif name in _MODULE_OF_NAME:
        from importlib import import_module

        value = getattr(import_module(f"{__name__}.{_MODULE_OF_NAME[name]}"), name)
    else:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


class _Package(ModuleType):
    """This package, on which a module does not hide the function of the same name.

    When ``restitution.impact`` is first imported, by whomever, Python's import system binds the
    module to the name ``impact`` of the package. Here the name means the function, whatever was
    imported before: ``r.impact(A, B)``. The module is still found by every
    ``from restitution.impact import …``; so are modules under their first names.
    """

    def __setattr__(self, name: str, value: object) -> None:
        if not (name in _MODULE_OF_NAME and isinstance(value, ModuleType)):
            super().__setattr__(name, value)


sys.modules[__name__].__class__ = _Package
_first_names.install()
