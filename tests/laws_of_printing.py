"""Laws of printed workings: what a reader would stumble over, in words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import fields, is_dataclass
from fractions import Fraction
from typing import Any

from restitution.explaining.awarding.awards import awarded
from restitution.explaining.lines.derivation import Derivation, Line, Meaning, Relation
from restitution.explaining.lines.saying import Sentence, Slot
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Number, Quantity, walk
from restitution.render import layout as lay
from restitution.solving import Solution
from restitution.workings import to_text
from restitution.workings.derived import explanation_of
from restitution.workings.rendering.explanation import Explanation
from restitution.workings.rendering.steps import Step


def _printed(solution: Solution, derivation: Derivation) -> Explanation:
    return explanation_of(awarded(derivation), solution.problem)


def headings(solution: Solution, derivation: Derivation) -> list[str]:
    """No heading of an event twice in a part with no other between, and none of nothing."""
    found = []
    for part in _printed(solution, derivation).parts:
        last: Step | None = None
        empty = False
        for step in part.steps:
            if step.kind != "heading":
                empty = empty and not (step.rows or step.kind == "principle")
                continue
            if empty and step.event is not None:
                found.append(f"nothing between two headings in part {part.label}")
            if last is not None and last.sentences == step.sentences:
                found.append(f"a heading stands twice in part {part.label}")
            last, empty = step, True
    return found


def titles(solution: Solution, derivation: Derivation) -> list[str]:
    """No title stands over two steps that follow each other, and no lead over two."""
    found = []
    for part in _printed(solution, derivation).parts:
        last: Step | None = None
        for step in part.steps:
            if last is not None and step.title is not None and step.title == last.title:
                found.append(f"{step.principle} stands twice")
            led = not step.title and step.sentences and step.rows
            same = last is not None and (step.sentences, step.item) == (last.sentences, last.item)
            if led and same:
                found.append("a sentence stands twice")
            last = step
    return found


def letters_first(solution: Solution, derivation: Derivation) -> list[str]:
    """What has a letter is called by it in all lines of its part."""
    found = []
    parts = derivation.asked
    for index, line in enumerate(derivation.lines):
        if not isinstance(line.relation, Meaning) or line.shown == "silent":
            continue
        for above in derivation.lines[:index]:
            same = parts.get(above.item or "") == parts.get(line.item or "")
            if same and above.shown != "silent" and isinstance(above.relation, Relation):
                nodes = (node for tree in trees_of(above.relation) for node in walk(tree))
                if line.relation.quantity in nodes:
                    found.append(f"{line.relation.letter} stands for what line {above.number} has")
    return found


def numbers(solution: Solution, derivation: Derivation) -> list[str]:
    """Equations have numbers from 1 in their order, and each is cited below."""
    above: list[str] = []
    cited: set[str] = set()
    found = []
    for part in _printed(solution, derivation).parts:
        for step in part.steps:
            reasons = (each for row in step.rows for each in row.reasons)
            for sentence in (*step.sentences, *reasons):
                for number in _numbers_in(sentence):
                    cited.add(number)
                    if number not in above and sentence in step.sentences:
                        found.append(f"({number}) is cited above its line")
            above += [row.number for row in step.rows if row.number]
    if above != [str(n) for n in range(1, len(above) + 1)]:
        found.append(f"the numbers are {', '.join(above)}")
    return [*found, *(f"({each}) is not cited" for each in above if each not in cited)]


def _numbers_in(slot: Slot) -> Iterator[str]:
    if isinstance(slot, tuple):
        for each in slot:
            yield from _numbers_in(each)
    elif isinstance(slot, Sentence):
        if slot.id == "derived.number":
            yield str(dict(slot.slots)["number"])
        for _, each in slot.slots:
            yield from _numbers_in(each)


def marks_of_work(solution: Solution, derivation: Derivation) -> list[str]:
    """No mark for what is nothing, but where it ends an item, and one kind once in a row.

    Two roots that are both what is asked are the exception: each has its own A1.
    """
    found = []
    ends = {each.line for each in derivation.items}
    for line in awarded(derivation).lines:
        if line.number in ends or not line.marks:
            continue
        if line.move.record in ("component", "unchanged") and _is_nothing(line):
            found.append(f"a mark for nothing in line {line.number}")
    for row in _printed(solution, derivation).rows():
        kinds = [mark.kind for mark in row.points]
        if row.alternatives and row.answer and kinds[-2:] == ["A", "A"]:
            kinds.pop()
        if len(kinds) > len(set(kinds)):
            found.append(f"marks of one kind in a row: {row.mark}")
    return found


def _is_nothing(line: Line) -> bool:
    match line.relation:
        case Relation(((link,),)):
            return isinstance(link.left, Quantity) and link.right == Number(Fraction(0))
    return False


def order_of_events(solution: Solution, derivation: Derivation) -> list[str]:
    """In an item the laws of an earlier impact come first, unless they rest on a later one."""
    found = []
    needs: dict[int, int] = {}
    latest: dict[object, tuple[int, int]] = {}
    cases = {n: case.option for case in derivation.cases for n in case.lines}
    for line in derivation.lines:
        own = line.move.event if line.move.id == "law" else None
        below = [needs[ref] for ref in line.premises if isinstance(ref, int) and ref in needs]
        needs[line.number] = max([own or 0, *below])
        if own is None:
            continue
        place = (line.item, cases.get(line.number))
        before, number = latest.get(place, (0, 0))
        if needs[line.number] < before:
            found.append(f"line {line.number} belongs before line {number}")
        latest[place] = max((before, number), (needs[line.number], line.number))
    return found


def vectors_introduced(solution: Solution, derivation: Derivation) -> list[str]:
    """A letter of a velocity, or of a unit vector, is introduced before it is used."""
    found = []
    known: set[lay.Bold] = set()
    for part in _printed(solution, derivation).parts:
        for step in part.steps:
            said = {each for sentence in step.sentences for each in _bold(sentence)}
            if step.kind == "setting":
                known |= said
            rows = {each for row in step.rows for each in _bold((row.operands, row.reasons))}
            for each in sorted((said | rows) - known, key=repr):
                found.append(f"{each.name}_{each.subscript} in part {part.label}")
    return found


def _bold(tree: Any) -> Iterator[lay.Bold]:
    """The letters of velocities and unit vectors in what is printed."""
    if isinstance(tree, tuple):
        for each in tree:
            yield from _bold(each)
    elif isinstance(tree, Sentence):
        yield from _bold(tuple(slot for _, slot in tree.slots))
    elif isinstance(tree, lay.Bold) and tree.name in ("u", "v", "n", "t"):
        yield tree
    elif is_dataclass(tree) and not isinstance(tree, type):
        for each in fields(tree):
            yield from _bold(getattr(tree, each.name))


def brackets(solution: Solution, derivation: Derivation) -> list[str]:
    """In text no line of mathematics ends within brackets."""
    found = []
    depth = 0
    text = re.sub(r"\(as(\s+)required\)", r"as\1required", to_text(_printed(solution, derivation)))
    for line in text.split("\n"):
        if not line.startswith("    "):
            depth = 0
            continue
        if depth > 0:
            found.append(line.strip())
        depth = max(0, depth + line.count("(") - line.count(")"))
    return found


PRINTED = {
    "headings say something new": headings,
    "titles say something new": titles,
    "letters come first": letters_first,
    "numbers are cited": numbers,
    "marks are for work": marks_of_work,
    "the story is in order": order_of_events,
    "vectors are introduced": vectors_introduced,
    "brackets stay on a line": brackets,
}
