"""Methods that no rule gives a line, where an answer below would stand without one."""

from __future__ import annotations

from collections.abc import Mapping

from restitution.explaining.awarding.work import Work, is_an_equation
from restitution.explaining.data.unused import lines_under
from restitution.explaining.lines.derivation import Line, Relation

Points = Mapping[int, list[str]]
"""The points of lines by their numbers, to which methods are added."""


def with_methods(work: Work, points: Points) -> None:
    """Adds methods to parts, to answers from earlier equations, and to results to be shown."""
    _of_parts(work, points)
    _of_equations(work, points)
    _of_results(work, points)


def _of_parts(work: Work, points: Points) -> None:
    """A method for the first line of a part of which nothing but its one answer has earned.

    A value that is read off in one line has its B1 alone.
    """
    for part in dict.fromkeys(work.parts.values()):
        own = [line for line in work.derivation.lines if work.part(line) == part]
        marked = [line for line in own if points[line.number]]
        if len(marked) != 1 or points[marked[0].number] != ["A"]:
            continue
        under = lines_under(work.derivation, marked[0].number)
        steps = [line for line in own if line.number in under and _is_a_step(work, line)]
        if len(steps) > 1:
            points[steps[0].number].append("M")


def _of_equations(work: Work, points: Points) -> None:
    """A method for values put into an equation that stood in an earlier part.

    Only where nothing else is a method above the answer that is solved for from it.
    """
    methods: set[str | None] = set()
    for line in work.derivation.lines:
        part = work.part(line)
        if line.number in work.ends and points[line.number] == ["A"] and part not in methods:
            under = lines_under(work.derivation, line.number)
            equations = (
                own
                for own in work.derivation.lines
                if own.number in under and work.part(own) == part and _is_closed(work, own)
            )
            first = next(equations, None)
            if first is not None:
                points[first.number].append("M")
        if "M" in points[line.number]:
            methods.add(part)


def _is_closed(work: Work, line: Line) -> bool:
    """Whether values are put into an equation of an earlier part that is no value of one."""
    if line.shown == "silent" or not is_an_equation(line):
        return False
    if line.move.id != "put":
        rule = work.rule(line)
        return rule is not None and rule.name == "repeated"
    earlier = (own for own in work.cited(line) if work.part(own) != work.part(line))
    return any(is_an_equation(own) for own in earlier)


def _of_results(work: Work, points: Points) -> None:
    """A method for the first step to a result that is to be shown, where no other earns.

    What is only said of what an item above has found, with no step between, is the result alone.
    """
    for end in work.derivation.items:
        if end.line not in work.shown or points[end.line] != ["A"]:
            continue
        own = [line for line in work.derivation.lines if line.item == end.item]
        steps = [line for line in own if _is_a_step(work, line) and line.number <= end.line]
        if any(points[line.number] for line in steps[:-1]) or not steps:
            continue
        if len(steps) > 1 or steps[0].move.id in _METHODS:
            points[steps[0].number].append("M")


_METHODS = ("law", "compare", "sign")
"""What is a method even where the result is all that stands of it."""


def _is_a_step(work: Work, line: Line) -> bool:
    """Whether a line is printed, and comes of another one."""
    printed = line.shown != "silent" and isinstance(line.relation, Relation)
    return printed and any(work.cited(line))


__all__ = ["with_methods"]
