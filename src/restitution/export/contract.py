"""A solution as the JSON object that other programs read: one object a file, one a line.

`restitution.export.objects` has its fields: a solved file is a `SolvedObject`.

``exact`` is plain SymPy syntax in which every letter is a Symbol, angles are in radians, Greek
letters go by name but for ``lambda_``, ``mu_``, ``nu_``, ``xi_``, and subscripts are written
``e_1``. A range whose form depends on the data has an answer for each form, with its condition.
``proof`` says what a claim rests on: ``algebra``, ``decision``, ``intervals`` or ``witness``; it is
``undecided``, and ``holds`` null, where nothing is proved; else null.

Where the working is asked for as well, each part has a ``derivation``: its working as
`restitution.explaining.lines.storing` writes it, with the lines of earlier parts on which it rests;
null where the working could not be made.

Nothing here loads SymPy: what is asked for in an unreadable or unfinished file can be said without
it.
"""

from __future__ import annotations

import json
import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict
from typing import TYPE_CHECKING, cast

from restitution.errors import RestitutionError
from restitution.expression.quantities import is_vector_quantity
from restitution.expression.tree import Expression, Name, Negate, Pair, Polar, Quantity
from restitution.mending import Fix, Note
from restitution.problem import Extremum, Find, Part, Problem, Range, Show, Value

if TYPE_CHECKING:
    from restitution.explaining.lines.stored import DerivationObject
    from restitution.export.objects import (
        AnswerObject,
        CheckedObject,
        ErrorObject,
        FixObject,
        ItemObject,
        PartObject,
        SolvedObject,
        TextNoteObject,
        WorkedObject,
    )
    from restitution.solving.equations.solution import Answer, ItemResult, PartSolution, Solution
    from restitution.workings.rendering.explanation import Explanation


def solved(file: str, solution: Solution, label: str | None = None) -> SolvedObject:
    """The object of a solved problem; of the one part ``label`` where that is given."""
    from restitution.export.units import Units

    units = Units(solution)
    parts = [
        _part(part.part.label, [_item(part, item, units.of(item)) for item in part.items])
        for part in solution.parts.values()
        if label is None or part.part.label == label
    ]
    return _file(
        file,
        solution.problem.title,
        [part for part in parts if part["items"] or part["part"] is not None],
        solution.warnings,
        solution.problem.notes,
        solution.error,
    )


def derivations(explanation: Explanation) -> dict[str | None, DerivationObject]:
    """The derivations of the parts, by label."""
    from restitution.explaining.lines.derivation import of_part
    from restitution.explaining.lines.storing import to_json as stored

    return {part.label: stored(of_part(part.derivation, part.label)) for part in explanation.parts}


def with_derivations(
    content: SolvedObject,
    derivations_of_parts: Mapping[str | None, DerivationObject] | None = None,
) -> WorkedObject:
    """The object with a ``derivation`` in each part, null where none is told."""
    return {
        **content,
        "parts": [
            {**part, "derivation": (derivations_of_parts or {}).get(part["part"])}
            for part in content["parts"]
        ],
    }


def unreadable(file: str, error: RestitutionError) -> SolvedObject:
    """The object of a file that could not be read."""
    return _file(file, None, [], (), (), error)


def unfinished(
    file: str, problem: Problem, error: RestitutionError | None, label: str | None = None
) -> SolvedObject:
    """The object of a problem whose solving ended without a result: nothing is answered.

    Without an error it is that of a problem which nobody has solved yet.
    """
    walls = frozenset(wall.name for wall in problem.walls)
    parts = [
        _part(part.label, [_unanswered(*asked, error) for asked in _asked(part, walls)])
        for part in problem.parts
        if label is None or part.label == label
    ]
    shown = [part for part in parts if part["items"]]
    return _file(file, problem.title, shown, problem.warnings, problem.notes, error)


def checked(file: str, problem: Problem | None, error: RestitutionError | None) -> CheckedObject:
    """The object of a text that was read and not solved, with all its mistakes as ``errors``."""
    if problem is not None:
        result = unfinished(file, problem, None)
    else:
        assert error is not None
        result = unreadable(file, error)
    return {**result, "errors": mistakes(error)}


def mistakes(error: RestitutionError | None) -> list[ErrorObject]:
    """An error and those found beside it in the same text."""
    if error is None:
        return []
    return [error_object(mistake) for mistake in (error, *getattr(error, "others", ()))]


def to_json(content: Mapping[str, object]) -> str:
    """The object in one line; letters such as θ stand as they are."""
    return json.dumps(content, ensure_ascii=False, allow_nan=False)


def all_answered(content: SolvedObject) -> bool:
    """Whether every item has an answer; a refuted ``show`` is one."""
    if content["error"] is not None:
        return False
    items = [item for part in content["parts"] for item in part["items"]]
    return all(
        item["error"] is None and (item["answers"] or item["proof"] is not None) for item in items
    )


def _file(
    file: str,
    title: str | None,
    parts: list[PartObject],
    warnings: Iterable[str],
    notes: Iterable[Note],
    error: RestitutionError | None,
) -> SolvedObject:
    return {
        "file": file,
        "title": title,
        "parts": parts,
        "warnings": list(dict.fromkeys(warnings)),
        "notes": [_note(note) for note in notes],
        "error": _error(error),
    }


def _part(label: str | None, items: list[ItemObject]) -> PartObject:
    return {"part": label, "items": items}


def _item(part: PartSolution, one: ItemResult, unit: str) -> ItemObject:
    unanswered = one.error is None and not one.answers and one.proof is None
    return item(one, unit, part.error if unanswered else one.error)


def item(item: ItemResult, unit: str, error: RestitutionError | None = None) -> ItemObject:
    """The object of an item; ``error`` is that of its part where it has none of its own."""
    error = error or item.error
    return {
        "line": item.line,
        "text": item.text,
        "kind": item.kind,
        "unit": unit.replace("\u00a0", " ") or None,
        "answers": [] if error is not None else [_answer(answer) for answer in item.answers],
        "holds": None if error is not None else item.holds,
        "proof": None if error is not None else item.proof,
        "trials": item.trials,
        "counterexample": _exact_of(item.counterexample),
        "rejected": [
            {"exact": _plain(root.exact), "reason": root.reason} for root in item.rejected
        ],
        "error": _error(error, item.line),
    }


def _answer(answer: Answer) -> AnswerObject:
    return {
        "solution": answer.solution,
        "exact": _plain(answer.exact),
        "decimal": _decimal(answer.decimal),
        "display": answer.display,
        "where": _exact_of(answer.where),
        "condition": list(answer.condition),
    }


def _unanswered(
    line: int | None, text: str, kind: str, error: RestitutionError | None
) -> ItemObject:
    return {
        "line": line,
        "text": text,
        "kind": kind,
        "unit": None,
        "answers": [],
        "holds": None,
        "proof": None,
        "trials": 0,
        "counterexample": None,
        "rejected": [],
        "error": _error(error, line),
    }


def _error(error: RestitutionError | None, line: int | None = None) -> ErrorObject | None:
    return None if error is None else error_object(error, line)


def error_object(error: RestitutionError, line: int | None = None) -> ErrorObject:
    """The object of an error; ``line`` is its place where it has none of its own."""
    return {
        "kind": error.kind if error.kind != RestitutionError.kind else "unsupported",
        "message": error.message,
        "line": error.line if error.line is not None else line,
        "column": error.column,
        "fixes": _fixes(error.fixes),
    }


def _note(note: Note) -> TextNoteObject:
    return {
        "message": note.message,
        "line": note.line,
        "column": note.column,
        "fixes": _fixes(note.fixes),
    }


def _fixes(fixes: Iterable[Fix]) -> list[FixObject]:
    return [cast("FixObject", asdict(fix)) for fix in fixes]


def _plain(exact: str | tuple[str, str]) -> str | list[str]:
    return exact if isinstance(exact, str) else list(exact)


def _exact_of(values: Mapping[str, str] | None) -> dict[str, str] | None:
    return None if values is None else dict(values)


def _decimal(value: float | tuple[float, float] | None) -> float | list[float] | None:
    numbers = value if isinstance(value, tuple) else (value,)
    finite = [float(number) for number in numbers if number is not None and math.isfinite(number)]
    if len(finite) < len(numbers):
        return None  # JSON knows no infinity
    return finite if isinstance(value, tuple) else finite[0]


# --- what was asked, by the text alone --------------------------------------------------------


def _asked(part: Part, walls: frozenset[str]) -> Iterator[tuple[int | None, str, str]]:
    """Line, text and kind of every item of a part."""
    for step in part.steps:
        if isinstance(step, Show):
            yield (None if step.place is None else step.place.line), step.text, "show"
        elif isinstance(step, Find):
            for item in step.items:
                yield (
                    (None if item.place is None else item.place.line),
                    item.text,
                    _kind(item, walls),
                )


def _kind(item: Value | Range | Extremum, walls: frozenset[str]) -> str:
    if isinstance(item, Range):
        return "range"
    if isinstance(item, Extremum):
        return "extremum"
    return _kind_of(item.expression, walls)


def _kind_of(expression: Expression, walls: frozenset[str]) -> str:
    if isinstance(expression, Negate):
        return _kind_of(expression.operand, walls)
    if isinstance(expression, Pair | Polar):
        return "vector"
    if isinstance(expression, Quantity):
        if expression.kind == "position":
            return "point"
        if expression.kind == "line_of_centres":
            return "direction"
        if expression.kind == "direction" and _is_one_of(expression.arguments, walls):
            return "direction"
        if is_vector_quantity(expression):
            return "vector"
    return "value"


def _is_one_of(arguments: tuple[Expression, ...], walls: frozenset[str]) -> bool:
    return len(arguments) == 1 and isinstance(arguments[0], Name) and arguments[0].name in walls
