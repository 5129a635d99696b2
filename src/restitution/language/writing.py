"""A Problem to the text of its statement."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from typing import Any

from restitution.errors import StatementError
from restitution.expression.limits import MAX_LINE_LENGTH
from restitution.expression.tree import Expression, Number, Pair
from restitution.expression.words import NAME
from restitution.expression.writing import write_expression, write_sum
from restitution.language.measuring import like_units
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Item,
    Kick,
    Let,
    Meets,
    Point,
    Problem,
    Range,
    Relation,
    Show,
    Sphere,
    Step,
    Unknown,
    Value,
    Wall,
)
from restitution.shapes import Circle, Line, Segment

_LABEL = re.compile(r"[^\W_](?:[\w.'-]*\w)?")
_SIGNS = {"mu": "μ", "nu": "ν", "xi": "ξ"}


def to_statement(problem: Problem) -> str:
    r"""The statement of a problem; ``parse`` reads it back as an equal Problem.

    A body is told on one line, however many lines told of it. Raises StatementError for what
    no text can say: numbers that are not exact, a name that is none, a title of several lines, laws
    that are altered.

    >>> from restitution.language import parse
    >>> to_statement(parse("sphere P: mass 2\\nsphere P: at rest"))
    'sphere P: mass 2, at rest\\n'
    """
    if problem.altered:
        raise StatementError("the world of a mistake, in which other laws hold, has no statement")
    bodies: list[Sphere | Wall | Point] = [
        *problem.spheres,
        *problem.walls,
        *problem.points,
    ]
    lines: list[str] = []
    if problem.title is not None:
        lines.append(f"title {_title(problem.title)}")
    for body in bodies:
        lines.extend(_body(body))
    kinds = _kinds(problem)
    for part in problem.parts:
        if part.label is not None:
            if not _LABEL.fullmatch(part.label):
                raise StatementError(f"a label is one word, not {part.label!r}")
            lines.append(f"part {part.label}")
        lines.extend(_step(kinds, step) for step in part.steps)
    units = "".join(sorted(like_units(problem)))
    if units:
        # ``2m`` would be read as two metres.
        behind = r"(?:(?<=[\d)])|(?<=\bpi)|(?<=\b[ij]))"
        product = re.compile(rf"{behind}\s*(?=[{units}](?![\w.(]))")
        first = 0 if problem.title is None else 1
        lines[first:] = [product.sub("*", line) for line in lines[first:]]
    return "".join(f"{line}\n" for line in lines)


def _title(title: str) -> str:
    if not title or title != " ".join(title.split()) or not title.isprintable():
        raise StatementError(f"a title is one line of text without idle blanks, not {title!r}")
    if title.endswith("\\"):
        raise StatementError("a title cannot end with a backslash: the line would go on")
    return title


def _tree(value: Any, what: str) -> Expression:
    if not isinstance(value, Expression):
        raise StatementError(f"the {what} is not an exact number or expression: {value!r}")
    return value


def _body(body: Sphere | Wall | Point) -> Iterator[str]:
    if not NAME.fullmatch(body.name):
        raise StatementError(f"a name is a capital, then letters or digits, not {body.name!r}")
    match body:
        case Sphere():
            kind, properties = "sphere", list(_sphere(body))
        case Wall():
            kind, properties = "wall", list(_wall(body))
        case Point():
            yield f"point {body.name}: {write_sum(_tree(body.position, 'place of a point'))}"
            return
    head = f"{kind} {body.name}"
    line = f"{head}: {', '.join(properties)}" if properties else head
    if len(line) <= MAX_LINE_LENGTH:
        yield line
    else:
        yield from (f"{head}: {entry}" for entry in properties)


def _sphere(sphere: Sphere) -> Iterator[str]:
    name = sphere.name
    if sphere.mass is not None:
        yield f"mass {write_expression(_tree(sphere.mass, f'mass of {name}'))}"
    if sphere.velocity is not None:
        velocity = _tree(sphere.velocity, f"velocity of {name}")
        if velocity == Pair(Number(0), Number(0)):  # type: ignore[arg-type]
            yield "at rest"
        else:
            yield f"velocity {write_expression(velocity)}"
    if sphere.position is not None:
        yield f"at {write_sum(_tree(sphere.position, f'place of {name}'))}"
    if sphere.radius is not None:
        yield f"radius {write_expression(_tree(sphere.radius, f'radius of {name}'))}"


def _wall(wall: Wall) -> Iterator[str]:
    name = wall.name
    match wall.shape:
        case Line(along, through):
            if along is not None:
                yield f"along {write_expression(_tree(along, f'direction of {name}'))}"
            if through is not None:
                yield f"through {write_sum(_tree(through, f'place of {name}'))}"
        case Segment(start, end):
            ends = (_tree(start, f"start of {name}"), _tree(end, f"end of {name}"))
            yield "from {} to {}".format(*map(write_sum, ends))
        case Circle(centre, radius):
            place = write_sum(_tree(centre, f"centre of {name}"))
            size = write_expression(_tree(radius, f"radius of {name}"))
            yield f"circle centre {place} radius {size}"


def _step(kinds: Mapping[str, str], step: Step) -> str:
    match step:
        case Impact():
            properties = [
                f"{word} {write_expression(value)}"
                for word, value in (("e =", step.e), ("along", step.along), ("offset", step.offset))
                if value is not None
            ]
            line = f"{step.first} hits {step.second}"
            return f"{line}: {', '.join(properties)}" if properties else line
        case Kick(body, impulse):
            return f"{body} receives {write_expression(impulse)}"
        case Arrival(body, target):
            return f"{body} reaches {write_expression(target)}"
        case Let(letter, expression):
            return f"let {_letter(letter)} = {write_expression(expression)}"
        case Given(relations):
            return f"given {', '.join(_relation(kinds, relation) for relation in relations)}"
        case Unknown(letters):
            return f"unknown {', '.join(map(_letter, letters))}"
        case Find(items):
            line = f"find {', '.join(item_text(item) for item in items)}"
            return line + _terms(step.in_terms_of)
        case Show():
            return f"show {_shown(kinds, step)}" + _terms(step.in_terms_of)


def _letter(name: str) -> str:
    head, line, subscript = name.partition("_")
    return _SIGNS.get(head, head) + line + subscript


def _terms(letters: tuple[str, ...] | None) -> str:
    return f" in terms of {', '.join(map(_letter, letters))}" if letters else ""


def _kinds(problem: Problem) -> dict[str, str]:
    bodies: list[Sphere | Wall | Point] = [*problem.spheres, *problem.walls, *problem.points]
    return {body.name: type(body).__name__.lower() for body in bodies}


def relation_text(problem: Problem, relation: Relation) -> str:
    """A relation as a statement has it."""
    return _relation(_kinds(problem), relation)


def _relation(kinds: Mapping[str, str], relation: Relation) -> str:
    match relation:
        case Compare(operands, operators, figures):
            text = write_expression(operands[0])
            for sign, operand in zip(operators, operands[1:], strict=True):
                text += f" {sign} {write_expression(operand)}"
            return text + (f" to {figures} s.f." if figures is not None else "")
        case Aligned(left, aligned, right):
            return f"{write_expression(left)} {aligned} {write_expression(right)}"
        case AtRest(body):
            return f"{body.name} at rest"
        case Meets(first, second, again, happens):
            if not again:
                word = "will hit" if happens else "will not hit"
                return f"{first.name} {word} {second.name}"
            if kinds.get(second.name) == "sphere":
                word = "collide again" if happens else "do not collide again"
                return f"{first.name} and {second.name} {word}"
            word = "hits" if happens else "does not hit"
            return f"{first.name} {word} {second.name} again"


def item_text(item: Item) -> str:
    """What is asked, as a statement has it."""
    match item:
        case Value(expression):
            text = write_expression(expression)
        case Range(expression):
            text = f"range of {write_expression(expression)}"
        case Extremum(kind, expression, over):
            text = f"{kind} of {write_expression(expression)} over {write_expression(over)}"
    return text + (" as a percentage" if item.percentage else "")


def _shown(kinds: Mapping[str, str], show: Show) -> str:
    if isinstance(show.subject, Range):
        return f"{item_text(show.subject)}: {_relation(kinds, show.relation)}"
    if isinstance(show.subject, Extremum):
        relation = show.relation
        if not isinstance(relation, Compare) or relation.operators != ("=",):
            raise StatementError("a maximum or minimum is shown to equal a value")
        text = f"{item_text(show.subject)} = {write_expression(relation.operands[1])}"
        return text + (f" to {relation.figures} s.f." if relation.figures is not None else "")
    return _relation(kinds, show.relation)
