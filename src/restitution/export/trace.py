"""The stages of a statement on its way to an answer, printed for developers and the curious.

``tree`` is the statement as values; ``equations`` are what each part asks of its story, in the
letters of the statement; ``derivation`` are the lines of the working, with move and premises.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from typing import Any, Literal, TypeAlias, get_args

from restitution.expression.tree import Expression
from restitution.expression.writing import write_expression
from restitution.problem import Part, Problem
from restitution.render.layout import from_sympy
from restitution.render.text import to_text
from restitution.solving import solve
from restitution.solving.equations.setting import settle
from restitution.solving.story.conditions import AnyOf, Condition, Equation
from restitution.solving.story.unknowns import Letters

Stage: TypeAlias = Literal["tree", "equations", "derivation"]

_STEP = "    "
_NODES = get_args(Expression)


def trace(problem: Problem, stage: Stage) -> str:
    """A stage of a problem as text, one thing a line.

    Raises whatever telling or solving the problem raises.
    """
    match stage:
        case "tree":
            lines = _tree(problem)
        case "equations":
            lines = _equations(problem)
        case "derivation":
            lines = _derivation(problem)
    return "\n".join(lines) + "\n"


# --- the statement as values --------------------------------------------------------------------


def _tree(problem: Problem) -> Iterator[str]:
    for body in (*problem.spheres, *problem.walls, *problem.points):
        yield from _value("", body, 0)
    heading = ""
    for step, events, part in problem.timeline():
        label = f"part {part.label}, " if part.label is not None else ""
        if heading != (heading := f"{label}events so far: {events}"):
            yield heading
        yield from _value("", step, 1)


def _value(label: str, value: Any, depth: int) -> Iterator[str]:
    """A value with what it holds, each under the name that it has there."""
    head = f"{_STEP * depth}{f'{label}: ' if label else ''}"
    if not is_dataclass(value):
        yield f"{head}{value}"
        return
    held = [
        (field.name, getattr(value, field.name))
        for field in fields(value)
        if field.name != "place" and getattr(value, field.name) not in (None, (), "", False)
    ]
    inside = [(name, entry) for name, entry in held if _is_nested(entry)]
    plain = [_plain(name, entry) for name, entry in held if not _is_nested(entry)]
    text = f"   {write_expression(value)}" if isinstance(value, _NODES) and inside else ""
    yield f"{head}{' '.join([type(value).__name__, *plain])}{text}"
    for name, own in inside:
        if isinstance(own, tuple):
            for number, one in enumerate(own, 1):
                yield from _value(f"{name} {number}" if len(own) > 1 else name, one, depth + 1)
        else:
            yield from _value(name, own, depth + 1)


def _is_nested(value: Any) -> bool:
    """Whether a value takes lines of its own."""
    return is_dataclass(value) or (isinstance(value, tuple) and any(map(is_dataclass, value)))


def _plain(name: str, value: Any) -> str:
    if value is True:
        return name
    if isinstance(value, tuple):
        signs = " ".join(map(str, value))
        return signs if name == "operators" else f"{name} {signs}"
    return str(value)


# --- what the solver sees -----------------------------------------------------------------------


def _equations(problem: Problem) -> Iterator[str]:
    for part in problem.parts:
        if part.label is not None or part.events or len(problem.parts) == 1:
            yield from _of_part(problem, part)


def _of_part(problem: Problem, part: Part) -> Iterator[str]:
    setting = settle(problem, part, None)
    letters = Letters(setting.roles)
    story = setting.tell(letters)
    needs = setting.requirements(story)
    yield f"part {part.label}:" if part.label is not None else "the question:"
    for name in sorted(setting.roles):
        asked = "unknown" if name in setting.unknown else "data, or found from what is given"
        yield f"{_STEP}{name}: {setting.roles[name].kind}; {asked}"
    for name, phrase in letters.phrases.items():
        yield f"{_STEP}{name}: {letters.hidden_roles[name].kind}; {phrase}"
    for happening in story.happenings:
        for body in happening.bodies:
            if body in story.spheres:
                after = happening.after[body]
                x, y = (to_text(from_sympy(velocity)) for velocity in after)
                yield f"{_STEP}velocity of {body} after event {happening.number}: ({x}, {y})"
    for condition in (*story.equations, *story.conditions, *needs):
        yield f"{_STEP}{_demand(condition)}"


def _demand(demand: Equation | Condition | AnyOf) -> str:
    match demand:
        case Equation():
            line = f", line {demand.place.line}" if demand.place is not None else ""
            return f"{to_text(from_sympy(demand.value))} = 0   ({demand.reason}{line})"
        case Condition():
            sign = {">=": "≥", "!=": "≠"}.get(demand.relation, demand.relation)
            return f"{to_text(from_sympy(demand.value))} {sign} 0   (else {demand.reason})"
        case AnyOf():
            options = " or ".join(_demand(option).partition("   ")[0] for option in demand.options)
            return f"{options}   (else {demand.reason})"


# --- the working --------------------------------------------------------------------------------


def _derivation(problem: Problem) -> Iterator[str]:
    from restitution.explaining.lines.derivation import Meaning
    from restitution.explaining.lines.notation import write_meaning, write_relation
    from restitution.planning.planner import plan

    derivation = plan(solve(problem), partial=True)
    for fact in derivation.facts:
        part = f", part {fact.part}" if fact.part is not None else ""
        yield f"{fact.id}: {write_relation(fact.relation)}   ({fact.kind}{part})"
    for line in derivation.lines:
        relation = line.relation
        written = (
            write_meaning(relation) if isinstance(relation, Meaning) else write_relation(relation)
        )
        move = line.move
        names = (move.id, move.record, move.event, *move.bodies, move.eliminated)
        by = " ".join(str(name) for name in names if name is not None)
        premises = ", ".join(map(str, line.premises))
        yield f"{line.number}. {written}   [{by}{f'; from {premises}' if premises else ''}]"
    for end in derivation.items:
        yield f"{end.item}: {write_relation(end.answer)}   (line {end.line})"
    for note in derivation.notes:
        yield f"{note.item}: {note.reason}   ({note.kind})"
