"""Laws of planned workings: what is wrong with a derivation of a solution, in words."""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterable, Iterator
from fractions import Fraction

from derivations import disagreement, oracle_of
from numbers_of_workings import BeyondError, Judge
from plain_physics import ImpossibleWorldError, World

from restitution.components.letters import protected_letters
from restitution.components.telling import model
from restitution.explaining.awarding.awards import awarded, marks_of
from restitution.explaining.data.facts import staged
from restitution.explaining.following.follower import follow
from restitution.explaining.lines.derivation import Derivation, Fact, Line, Link, Meaning, Relation
from restitution.explaining.lines.marks import Style
from restitution.explaining.lines.notation import write_meaning, write_relation
from restitution.explaining.lines.storing import from_json, to_json
from restitution.explaining.lines.trees import rebuilt, trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    letters,
    walk,
)
from restitution.problem import Value
from restitution.solving import Solution
from restitution.workings.derived import explanation_of
from restitution.workings.naming.measured import Measures
from restitution.workings.rendering.document import to_text

Law = Callable[[Solution, Derivation], list[str]]


def complaints(solution: Solution, derivation: Derivation) -> list[str]:
    """What the follower does not accept."""
    return [str(each) for each in follow(derivation, oracle_of(solution.problem))]


def answers(solution: Solution, derivation: Derivation) -> list[str]:
    """Items without an end, and ends that are not what the solver answers."""
    noted = {each.place for each in derivation.notes if each.kind not in ("standing", "agreeing")}
    items = [each for n, each in enumerate(solution.items()) if n not in noted]
    names = list(dict.fromkeys(each.item for each in derivation.items))
    if len(names) != len(items):
        return [f"{len(names)} ends for {len(items)} items"]
    found = []
    for name, (part, item) in zip(names, items, strict=True):
        ends = [each for each in derivation.items if each.item == name]
        wrong = disagreement(item, ends, part.roles)
        if wrong is not None:
            found.append(f"{item.text}: {wrong}")
    return found


def storing(solution: Solution, derivation: Derivation) -> list[str]:
    """What is written as JSON is read back."""
    return [] if from_json(to_json(derivation)) == derivation else ["another is read back"]


def false_lines(
    derivation: Derivation, stories: Iterable[World], items: Container[str | None] | None = None
) -> list[str]:
    """Lines that do not hold in a story told in numbers, where they stand for it.

    With ``items`` only those on the way to them are looked at.
    """
    found = []
    for story in stories:
        judge = Judge(story, derivation)
        for line in derivation.lines:
            if items is not None and line.item not in items:
                continue
            if isinstance(line.relation, Relation) and _is_false(judge, line):
                found.append(f"line {line.number} is false: {write_relation(line.relation)}")
    return found


def _is_false(judge: Judge, line: Line) -> bool:
    assert isinstance(line.relation, Relation)
    try:
        return judge.applies(line) and not judge.true(line.relation)
    except (BeyondError, ImpossibleWorldError, ZeroDivisionError):
        return False


# --- what a line may be ---------------------------------------------------------------------------


def printed_results(solution: Solution, derivation: Derivation) -> list[str]:
    """A result that is to be shown does not stand above the end of its derivation."""
    found = []
    for end in derivation.items:
        if not end.shown:
            continue
        last = derivation.line(end.line)
        assert last is not None
        bound = last.premises if last.move.id == "answer" else ()
        for line in derivation.lines:
            if line.number in bound:
                continue  # the bound of a greatest or least value
            if line.number < end.line and line.relation == end.answer:
                found.append(f"line {line.number} says what is to be shown in line {end.line}")
    return found


def facts_used(solution: Solution, derivation: Derivation) -> list[str]:
    """Every given equation that is in force for an item is below the last line of one."""
    if derivation.notes:
        return []  # what an item without an answer rests on is under no last line
    found = []
    for part in dict.fromkeys(end.part for end in derivation.items):
        ends = [end.line for end in derivation.items if end.part == part]
        below = _below(derivation, ends)
        found += [
            f"{fact.id} is not used in part {part}"
            for fact in derivation.facts
            if fact.kind == "given" and fact.part == part and _ties(fact) and fact.id not in below
        ]
    every = _below(derivation, [end.line for end in derivation.items])
    found += [
        f"{fact.id} is not used"
        for fact in derivation.facts
        if fact.kind == "given" and fact.part is None and _ties(fact) and fact.id not in every
    ]
    return found


def _ties(fact: Fact) -> bool:
    return all(link.sign in ("=", "perpendicular to") for link in fact.relation.options[0])


def _below(derivation: Derivation, ends: Iterable[int]) -> set[int | str]:
    """All that some lines rest on, they themselves among it."""
    lines = {each.number: each for each in derivation.lines}
    found: set[int | str] = set()
    open_: list[int | str] = list(ends)
    while open_:
        ref = open_.pop()
        if ref not in found:
            found.add(ref)
            open_ += lines[ref].premises if isinstance(ref, int) else ()
    return found


def plain_numbers(solution: Solution, derivation: Derivation) -> list[str]:
    """But for answers: no long number under a root, no root in a root, no arctan taken back."""
    ends = {end.line for end in derivation.items}
    found = []
    for line, _ in _relations(derivation):
        for tree in trees_of(line.relation) if line.number not in ends else ():
            where = f"line {line.number}: {_text(line)}"
            for node in walk(tree):
                match node:
                    case Apply("sqrt", inside):
                        if _has_root(_without_squares(inside)):
                            found.append(f"a root in a root in {where}")
                        if any(isinstance(x, Number) and x.value >= 1000 for x in walk(inside)):
                            found.append(f"a long number under a root in {where}")
                    case Apply("sin" | "cos" | "tan", inside):
                        if any(
                            isinstance(x, Apply) and x.function == "arctan" for x in walk(inside)
                        ):
                            found.append(f"a ratio of an arctan in {where}")
    return list(dict.fromkeys(found))


def _without_squares(tree: Expression) -> Expression:
    """A tree without what is squared in it, as a component is in the size of a velocity."""

    def change(each: Expression) -> Expression:
        match each:
            case Binary("^", _, Number(value)) if value == 2:
                return Number(value)
        return each

    return rebuilt(tree, change)


def components_used(solution: Solution, derivation: Derivation) -> list[str]:
    """No component is taken of a velocity that was put together from it."""
    lines = {each.number: each for each in derivation.lines}
    found = []
    for line, links in _relations(derivation):
        if (line.move.id, line.move.record) != ("define", "component"):
            continue
        for ref in line.premises:
            above = lines.get(ref) if isinstance(ref, int) else None
            if above is None or above.move.record != "assemble":
                continue
            known = {
                link.left for n in above.premises if isinstance(n, int) for link in _links(lines[n])
            }
            if links[0].left in known:
                found.append(f"line {line.number} takes a component back out of line {ref}")
    return found


def no_repetition(solution: Solution, derivation: Derivation) -> list[str]:
    """Nothing is said twice, also with its sides exchanged; what is recalled stands above."""
    found = []
    seen: dict[object, Line] = {}
    parts = {end.item: end.part for end in derivation.items}
    cases = {n: case.option for case in derivation.cases for n in case.lines}
    for line in derivation.lines:
        for ref in line.premises:
            if isinstance(ref, int) and ref >= line.number:
                found.append(f"line {line.number} recalls line {ref}")
        for form in _forms(line) if line.move.id not in ("answer", "shown") else ():
            other = seen.setdefault((form, parts.get(line.item or "")), line)
            if other is not line and cases.get(other.number) == cases.get(line.number):
                found.append(f"lines {other.number} and {line.number} say the same: {_text(line)}")
    return found


def _forms(line: Line) -> Iterator[object]:
    yield line.relation
    match line.relation:
        case Relation(((Link(left, "=", right),),)) if left != right:
            yield Relation(((Link(right, "=", left),),))


def one_form(solution: Solution, derivation: Derivation) -> list[str]:
    """Of a number with a root there is one form in which lines end: √2/2 or 1/√2."""
    above: dict[float, str] = {}
    below: dict[float, str] = {}
    for line, links in _relations(derivation):
        for tree in (links[-1].right,):
            for node in walk(tree):
                match node:
                    case Binary("/", p, q) if not (letters(node) or _has_quantity(node)):
                        roots = [_has_root(p), _has_root(q)]
                        value = _number(node)
                        if value is not None and any(roots) and not all(roots):
                            group = below if roots[1] else above
                            group.setdefault(round(value, 9), _text(line))
    return [f"two forms: {above[x]} and {below[x]}" for x in above.keys() & below.keys()]


def _has_root(tree: Expression) -> bool:
    return any(isinstance(x, Apply) and x.function == "sqrt" for x in walk(tree))


def _has_quantity(tree: Expression) -> bool:
    return any(isinstance(x, Quantity) for x in walk(tree))


def _number(tree: Expression) -> float | None:
    match tree:
        case Number(value):
            return float(value)
        case Negate(operand):
            inside = _number(operand)
            return None if inside is None else -inside
        case Apply("sqrt", inside_):
            value = _number(inside_)
            return None if value is None or value < 0 else math.sqrt(value)
        case Binary(op, left, right):
            a, b = _number(left), _number(right)
            if a is None or b is None:
                return None
            match op:
                case "+":
                    return a + b
                case "-":
                    return a - b
                case "*":
                    return a * b
                case "/" if b:
                    return a / b
    return None


# --- the whole ------------------------------------------------------------------------------------


def marks(solution: Solution, derivation: Derivation) -> list[str]:
    """Every item has an A at its end, or a B, and a part at most one mark more than lines.

    Each of the two laws of an impact of spheres is M1 A1, and counts as two lines.
    """
    found = []
    styles: tuple[Style, ...] = ("fm1", "m4", "caie")
    for style in styles:
        marked = awarded(derivation, style)
        parts = {end.item: end.part for end in derivation.items}
        for end in derivation.items:
            own = marked.line(end.line)
            assert own is not None
            if end.case is None and not any(mark.kind in "AB" for mark in own.marks):
                found.append(f"{style}: no A or B at the end of {end.item}")
        for part, total in marks_of(marked).items():
            room = sum(
                (1 if isinstance(line.relation, Meaning) else max(map(len, line.relation.options)))
                + (line.move.record in ("momentum", "restitution"))
                for line in derivation.lines
                if parts.get(line.item) == part
            )
            if total > room + 1:
                found.append(f"{style}: {total} marks for {room} lines in part {part}")
    return found


def names(solution: Solution, derivation: Derivation) -> list[str]:
    """The letters of components are those of the pictures; one letter for one thing."""
    found = []
    told = {}
    for part in solution.parts.values():
        if part.branches:
            own = model(
                solution.problem,
                part.part,
                part.branches[0],
                part.roles,
                protected_letters(part.part),
            )
            told |= {key: each.symbol.name for key, each in own.components.items()}
    meanings = list(derivation.meanings.values())
    walls_struck = {event.number for event in derivation.events if event.wall}
    for meaning in meanings:
        match meaning.quantity:
            case Quantity("along", (Quantity("velocity", (Name(body),), int(stage)), direction)):
                # Without a given line of centres, a component along i or j is no frame's.
                free = derivation.fact(f"axis {stage}") is None and isinstance(direction, Unit)
                own_letter = free and stage not in walls_struck
                wanted = meaning.letter if own_letter else told.get((stage, body), meaning.letter)
                if stage and meaning.letter != wanted:
                    found.append(f"{write_meaning(meaning)}, but {wanted} in the picture")
    quantities = [each.quantity for each in meanings]
    if len(set(quantities)) < len(quantities):
        found.append("two letters for one thing")
    return found


def units(solution: Solution, derivation: Derivation) -> list[str]:
    """An answer that measures something has its unit, where no letter gives the scale."""
    problem = solution.problem
    measures = Measures(problem, derivation.meanings)
    text = to_text(explanation_of(derivation, problem)).replace("\u00a0", " ")
    asked = [item.item for part in solution.parts.values() for item in part.items]
    plain = [each.expression for each in asked if isinstance(each, Value) and not each.percentage]
    wanted = {measures.unit(staged(problem, each, len(derivation.events))) for each in plain}
    return [f"no {unit}" for unit in wanted if unit.replace("\u00a0", " ") not in text]


_OF_VECTORS = frozenset(
    ("momentum-vector", "impulse-vector", "across-the-impulse", "along-the-change")
    + ("equal-across", "component", "assemble")
)


def vectors(solution: Solution, derivation: Derivation) -> list[str]:
    """Where vectors meet along a slanting line, vectors or scalar products are used."""
    found = []
    for event in derivation.events:
        fact = derivation.fact(f"axis {event.number}")
        own = [e for e in derivation.lines if e.move.event == event.number and e.move.id == "law"]
        if fact is None or not own or not _slants(fact.relation.only[0].right):
            continue
        given = [derivation.fact(f"velocity {body}") for body in event.bodies]
        right = [each.relation.only[0].right for each in given if each is not None]
        moving = [each for each in right if each != Pair(_NOTHING, _NOTHING)]
        first = all(
            e.number >= event.number for e in derivation.events if {*e.bodies} & {*event.bodies}
        )
        if not first or not moving or any(isinstance(x, Polar) for y in moving for x in walk(y)):
            continue
        if not any(
            line.move.record in _OF_VECTORS
            for line in derivation.lines
            if line.move.event == event.number
        ):
            found.append(f"no vector and no scalar product at event {event.number}")
    return found


def _slants(tree: Expression) -> bool:
    while isinstance(tree, Negate):
        tree = tree.operand
    return not isinstance(tree, Unit)


_NOTHING = Number(Fraction(0))

LAWS: dict[str, Law] = {
    "a printed result is reached, not used": printed_results,
    "every fact is used": facts_used,
    "numbers are plain": plain_numbers,
    "components are not taken back": components_used,
    "nothing is said twice": no_repetition,
    "one exact form": one_form,
    "marks": marks,
    "letters are those of the figure": names,
    "vectors stay vectors": vectors,
    "units": units,
}


def _relations(derivation: Derivation) -> Iterator[tuple[Line, tuple[Link, ...]]]:
    for line in derivation.lines:
        if isinstance(line.relation, Relation):
            yield line, line.relation.options[0]


def _links(line: Line) -> tuple[Link, ...]:
    return line.relation.options[0] if isinstance(line.relation, Relation) else ()


def _text(line: Line) -> str:
    if isinstance(line.relation, Meaning):
        return write_meaning(line.relation)
    return write_relation(line.relation)
