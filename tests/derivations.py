"""Workings written by hand, read from a short notation.

A file is a statement, a line of dashes, and the lines of a working:

    3 a | law unchanged 1 A | velocity A, axis 1 | s(A, 1) = U sin(alpha) | B

number and item, the move with its record, event and bodies (``combine w`` names what goes), the
premises, what the line says, its marks. ``c(A, 1)`` is short for the component of A along the line
of centres of event 1 after it, ``c(A, 0@1)`` for that before; ``s`` is the one across. A last line
``a: 8 shown tan(beta) = …`` names an item, its last line and its answer.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from answers import _differs

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.data.facts import facts_of
from restitution.explaining.lines.derivation import (
    Case,
    Derivation,
    ItemEnd,
    Line,
    Link,
    Move,
)
from restitution.explaining.lines.marks import Mark
from restitution.explaining.lines.notation import read_meaning, read_relation
from restitution.expression.evaluate import evaluate
from restitution.expression.tree import Expression, has_quantity
from restitution.expression.writing import write_expression
from restitution.language.reading import parse
from restitution.oracle import Oracle
from restitution.problem import Problem, Range
from restitution.solving import ItemResult
from restitution.solving.story.letters import roles

FOLDER = Path(__file__).with_name("derivations")
_SHORT = re.compile(r"\b([cs])\((\w+), (\d+)(?:@(\d+))?\)")
_LINE = re.compile(r"(\d+) (\S+)\s*\|(.*)")
_END = re.compile(r"(\S+): (\d+)( shown)?(?: case (\d+))? (.+)")
_CASE = re.compile(r"case (\d+): line (\d+) option (\d+) lines (.+)")
_MARK = re.compile(r"(DM|M|A\*|A|B)(ft)?")


def names_of(problem: Problem) -> dict[str, str]:
    """The bodies and points of a problem, and what each is."""
    kinds = (("sphere", problem.spheres), ("wall", problem.walls), ("point", problem.points))
    return {each.name: kind for kind, bodies in kinds for each in bodies}


def read_derivation(path: Path) -> tuple[Problem, Derivation]:
    """The statement and the working of a file."""
    statement, _, working = path.read_text().partition("\n---\n")
    problem = parse(statement)
    return problem, derivation_of(problem, working)


def derivation_of(problem: Problem, working: str) -> Derivation:
    """The working that a text in the short notation says."""
    names = names_of(problem)
    labels = [part.label for part in problem.parts if part.label is not None]
    lines, items, cases = [], [], []
    for text in filter(None, map(str.strip, working.splitlines())):
        if match := _LINE.fullmatch(text):
            lines.append(_line(match, names))
        elif match := _CASE.fullmatch(text):
            number, line, option, under = match.groups()
            own = tuple(int(each) for each in under.split())
            cases.append(Case(int(number), int(line), int(option), own))
        elif match := _END.fullmatch(text):
            item, line, shown, case, answer = match.groups()
            part = item[0] if item[0] in labels else None
            items.append(
                ItemEnd(
                    item,
                    int(line),
                    read_relation(_whole(answer), names),
                    part,
                    shown is not None,
                    None if case is None else int(case),
                )
            )
        else:
            raise ValueError(f"no line of a working: {text}")
    return Derivation(
        facts_of(problem), tuple(lines), tuple(items), events_of(problem), tuple(cases)
    )


def oracle_of(problem: Problem) -> Oracle:
    """The oracle that knows the letters of a problem."""
    return Oracle(roles(problem))


def disagreement(item: ItemResult, ends: list[ItemEnd], roles: Mapping[str, Any]) -> str | None:
    """How the ends of an item differ from the answers of the solver, in words; None if not at all.

    Both are worked out at a few numbers that their letters may have.
    """
    if any(end.shown != (item.kind == "show") for end in ends):
        return "a result is printed, or is not"
    if item.kind == "show":
        return _differs(item, "true", dict(roles))
    links = [links for end in ends for links in end.answer.options]
    if item.kind == "range":
        assert isinstance(item.item, Range)
        text = " or ".join(_interval(each, item.item.expression) for each in links)
        return _differs(item, text, dict(roles))
    if any(each[-1].sign == "≈" for each in links):
        return _rounds_to(item, [each[-1].right for each in links])
    text = " ; ".join(write_expression(each[-1].right) for each in links)
    return _differs(item, text, dict(roles))


def _interval(links: tuple[Link, ...], subject: Expression) -> str:
    sides = [links[0].left, *(each.right for each in links)]
    texts = [
        "X" if each == subject or has_quantity(each) else write_expression(each) for each in sides
    ]
    return texts[0] + "".join(
        f" {link.sign} {text}" for link, text in zip(links, texts[1:], strict=True)
    )


def _rounds_to(item: ItemResult, decimals: list[Expression]) -> str | None:
    got = sorted({float(each.value) for each in item.answers})
    printed = sorted(float(evaluate(each, lambda name: None)) for each in decimals)
    close = len(got) == len(printed) and all(
        abs(a - b) <= 5e-3 * abs(a)  # half a unit in the third figure
        for a, b in zip(got, printed, strict=True)
    )
    return None if close else f"got {got}"


def _line(match: re.Match[str], names: dict[str, str]) -> Line:
    number, item, rest = match.groups()
    move, premises, says, marks = (*map(str.strip, rest.split("|")), "")[:4]
    relation = (
        read_meaning(_whole(says), names)
        if says.startswith("let ")
        else read_relation(_whole(says), names)
    )
    return Line(
        int(number),
        item,
        _move(move),
        tuple(int(p) if p.isdigit() else p for p in map(str.strip, premises.split(",")) if p),
        relation,
        tuple(
            Mark(kind[-1] if kind != "A*" else "A", 1, kind == "DM", kind == "A*", ft is not None)
            for kind, ft in (_MARK.fullmatch(each).groups() for each in marks.split())  # type: ignore[union-attr]
        ),
    )


def _move(text: str) -> Move:
    name, *words = text.split()
    if name == "combine":
        return Move("combine", eliminated=_whole(" ".join(words)) or None)
    record = words[0] if words else None
    event = int(words[1]) if len(words) > 1 else None
    return Move(name, record, event, tuple(words[2:]))  # type: ignore[arg-type]


def _whole(text: str) -> str:
    def full(match: re.Match[str]) -> str:
        kind, body, stage, event = match.groups()
        word = {"c": "along", "s": "across"}[kind]
        return f"{word}(velocity({body}, {stage}), line_of_centres({event or stage}))"

    return _SHORT.sub(full, text)
