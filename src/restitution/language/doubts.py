"""What reads well and is probably a slip all the same: a warning, never an error."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import pairwise

from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    GREEK,
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    Number,
    Place,
    Polar,
    Quantity,
    children,
    has_quantity,
    is_binary,
    letters,
    line_and_column,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.mending import Edit, Fix, Note
from restitution.problem import (
    Compare,
    Event,
    Find,
    Given,
    Impact,
    Let,
    Problem,
    Relation,
    Show,
    Unknown,
    trees,
)

_TURN = Fraction("6.2832")  # radians; whoever types more than a full turn means degrees
_OF_ANGLES = frozenset(("sin", "cos", "tan", "cot", "sec", "cosec"))


def doubts(problem: Problem, text: str) -> Iterator[Note]:
    """Warnings: numbers of degrees without their sign, facts and questions tied to nothing.

    ``text`` is what the problem was read from.
    """
    yield from degrees_without_sign(problem, text)
    yield from _powers_of_ten(problem, text)
    yield from _idle_facts(problem)
    yield from _idle_questions(problem)
    yield from _facts_below_questions(problem)
    yield from _axes(problem)
    yield from _letters_with_a_stage(problem, text)


def _note(place: Place | None, message: str, *fixes: Fix) -> Note:
    return Note(message, *line_and_column(place), fixes)


# --- degrees without a sign -------------------------------------------------------------------


def degrees_without_sign(problem: Problem, text: str) -> Iterator[Note]:
    """Numbers that stand for angles and are greater than a full turn in radians.

    ``text`` is what the problem was read from.
    """
    noted: set[Place | None] = set()
    for angle in _angles(problem):
        for term in _terms(angle):
            if isinstance(term, Number) and term.value > _TURN and term.place not in noted:
                noted.add(term.place)
                number = write_expression(term)
                yield _note(
                    term.place,
                    f"{number} was read as {number} radians: if you mean degrees, write {number}°",
                    *_with_degrees(term.place, text),
                )


def _with_degrees(place: Place | None, text: str) -> Iterator[Fix]:
    """The sign of degrees behind a number that stands alone in its text."""
    if place is None:
        return
    line = text.split("\n")[place.line - 1 : place.line]
    number = re.compile(r"\d+(?:\.\d+)?(?![\w.°^*/])").match(
        line[0] if line else "", place.column - 1
    )
    if number is not None:
        end = place.column + len(number[0])
        yield Fix(f"Write {number[0]}°", (Edit(place.line, end, place.line, end, "°"),))


def _angles(problem: Problem) -> Iterator[Expression]:
    """Every expression that stands for an angle."""
    for tree in trees(problem):
        for node in walk(tree):
            if isinstance(node, Polar):
                yield node.angle
            elif isinstance(node, Apply) and node.function in _OF_ANGLES:
                yield node.argument
    directions = [wall.along for wall in problem.walls]
    for _, step in problem.steps():
        if isinstance(step, Impact):
            directions.append(step.along)
    yield from (direction for direction in directions if isinstance(direction, Number))
    angles = _letters_for_angles(problem)
    for relation in _relations(problem):
        if isinstance(relation, Compare) and any(_is_angle(x, angles) for x in relation.operands):
            yield from relation.operands


def _letters_for_angles(problem: Problem) -> frozenset[str]:
    letters_ = {
        node.name
        for tree in trees(problem)
        for part in walk(tree)
        if isinstance(part, Polar | Apply)
        for node in ([part.angle] if isinstance(part, Polar) else _argument(part))
        if isinstance(node, Letter)
    }
    return frozenset(letters_)


def _argument(tree: Apply) -> list[Expression]:
    return [tree.argument] if tree.function in _OF_ANGLES else []


def _is_angle(tree: Expression, angles: frozenset[str]) -> bool:
    return (isinstance(tree, Quantity) and tree.kind in ANGLES) or (
        isinstance(tree, Letter) and tree.name in angles
    )


def _terms(tree: Expression) -> Iterator[Expression]:
    """The terms of a sum."""
    pending = [tree]
    while pending:
        node = pending.pop()
        if isinstance(node, Negate) or is_binary(node, "+", "-"):
            pending.extend(reversed(children(node)))
        else:
            yield node


# --- scientific notation ----------------------------------------------------------------------

# A unit vector may stand at once behind a number: 2e3i.
_SCIENTIFIC = re.compile(
    r"(?<![\w.])(?P<digits>\d+(?:\.\d+)?)"
    r"(?:(?P<letter>[eE])(?P<power>(?P<sign>[-+]?)\d{1,2})"
    r"|\s*x\s*10\s*(?:\^|\*\*)\s*\(?(?P<exponent>[-+]?\d{1,2})\)?)"
    r"(?=[ij]?(?![\w.]))"
)
_OF_A_BODY = re.compile(r"\s*(?:sphere|wall|point)\b")


def _powers_of_ten(problem: Problem, text: str) -> Iterator[Note]:
    """``1e3``, which is e₃, ``2x10^3``, and ``2e-3`` among the data of a body, which is 2e - 3."""
    if not _SCIENTIFIC.search(text):
        return
    numbered: Counter[str] = Counter()
    for tree in trees(problem):
        numbered.update(node.name for node in walk(tree) if isinstance(node, Letter))
    for number, line in enumerate(text.split("\n"), start=1):
        if line.lstrip().startswith("title"):
            continue
        for match in _SCIENTIFIC.finditer(line.partition("#")[0]):
            power = match["power"] or match["exponent"]
            if match["sign"]:
                if not _OF_A_BODY.match(line):
                    continue
                product = f"{match['digits']}{match['letter']} {power[0]} {power[1:]}"
            elif match["letter"]:
                letter = f"{match['letter']}_{power}"
                plainly = re.findall(rf"[\d.]{match['letter']}{power}(?=[ij]?(?![\w.]))", text)
                if numbered[letter] != len(plainly):
                    continue  # a coefficient of its own
                product = letter if match["digits"] == "1" else f"{match['digits']} times {letter}"
            else:
                letter = next((name for name in ("x_10", "x") if numbered[name]), "")
                if not letter or numbered[letter] != len(re.findall(r"\d\s*x\s*10", text)):
                    continue  # a length x
                product = f"a product with the letter {letter}"
            value = Fraction(match["digits"]) * Fraction(10) ** int(power)
            plain = write_expression(Number(value))
            start, end = match.start() + 1, match.end() + 1
            yield Note(
                f"{match[0]} was read as {product}: there is no scientific notation; "
                f"if you mean {plain}, write so",
                number,
                start,
                (Fix(f"Write {plain}", (Edit(number, start, number, end, plain),)),),
            )


# --- facts that say nothing of the motion -----------------------------------------------------


def _relations(problem: Problem) -> Iterator[Relation]:
    for _, step in problem.steps():
        if isinstance(step, Given):
            yield from step.relations
        elif isinstance(step, Show):
            yield step.relation


def _idle_facts(problem: Problem) -> Iterator[Note]:
    """Facts about letters alone, none of which is tied to anything else in the statement."""
    facts = [
        relation
        for _, step in problem.steps()
        if isinstance(step, Given)
        for relation in step.relations
        if isinstance(relation, Compare) and not any(map(has_quantity, relation.operands))
    ]
    if not facts:
        return
    used = _tied(
        set(_used(problem, [operand for fact in facts for operand in fact.operands])), facts
    )
    for fact in facts:
        named = _letters_of(fact.operands) - used
        if not named:
            continue
        first = min(named)
        like = [
            letter for letter in used if (letter in GREEK) == (first in GREEK) and letter != "e"
        ]
        meant = f": did you mean {like[0]}?" if len(named) == len(like) == 1 else ""
        stand = "stands" if len(named) == 1 else "stand"
        alone = [operand for operand in fact.operands if isinstance(operand, Letter)]
        fixes = _quantities_meant(problem, alone[0]) if len(alone) == len(named) == 1 else ()
        fixes = tuple(fix for fix in fixes if fix.edits[0].text.startswith("speed"))
        yield _note(
            getattr(fact.operands[0], "place", None),
            f"{' and '.join(sorted(named))} {stand} nowhere else in the statement{meant}",
            *fixes,
        )


def _tied(used: set[str], facts: list[Compare]) -> set[str]:
    """The letters in use, and all that facts tie to one of them."""
    beside: dict[str, set[str]] = {}
    for fact in facts:
        named = _letters_of(fact.operands)
        for letter in named:
            beside.setdefault(letter, set()).update(named)
    pending = list(used)
    while pending:
        for letter in beside.pop(pending.pop(), set()) - used:
            used.add(letter)
            pending.append(letter)
    return used


def _letters_of(operands: Iterable[Expression]) -> frozenset[str]:
    return frozenset().union(*map(letters, operands))


def _idle_questions(problem: Problem) -> Iterator[Note]:
    """Letters that are asked for and of which nothing is told."""
    asked = list(problem.letters_asked())
    used = set(_used(problem, asked)) if asked else set()
    noted: set[str] = set()
    for letter in asked:
        if letter.name not in used | noted:
            noted.add(letter.name)
            fixes = _quantities_meant(problem, letter)
            meant = " or ".join(fix.edits[0].text for fix in fixes)
            yield _note(
                letter.place,
                f"{letter.name} stands nowhere else in the statement, and so has no value"
                + (f": did you mean {meant}?" if meant else _of_one_impact(problem, letter)),
                *fixes,
            )


def _facts_below_questions(problem: Problem) -> Iterator[Note]:
    """Facts at the end of a part, below all that it asks, which a later part may have wanted."""
    for part, later in pairwise(problem.parts):
        asked = [n for n, step in enumerate(part.steps) if isinstance(step, Find | Show)]
        for step in part.steps[asked[-1] + 1 :] if part.label and asked else ():
            if isinstance(step, Given):
                yield _note(
                    step.place,
                    f"this stands below the questions of part ({part.label}) and holds in that "
                    f"part only: for part ({later.label}), write it below 'part {later.label}'",
                )


def _of_one_impact(problem: Problem, letter: Letter) -> str:
    """How an impact gets a coefficient such as e₂ of its own, where its letter is e as it is."""
    symbol, _, number = letter.name.partition("_")
    impacts = [event for event in problem.events if isinstance(event, Impact)]
    if symbol != "e" or not number.isdecimal() or not 0 < int(number) <= len(impacts):
        return ""
    impact = impacts[int(number) - 1]
    if impact.e is not None:
        return ""
    return (
        f": an impact without a coefficient has the letter e; write "
        f"'{impact.first} hits {impact.second}: e = e{number}' for one of its own"
    )


# What letters usually stand for on paper, where they are not the letters of a statement.
_OF_A_SPHERE = {"v": ("velocity({})", "speed({})"), "u": ("velocity({}, 0)", "speed({}, 0)")}
_OF_ALL = {"I": "impulse", "J": "impulse"}
_FEW = 3


def _quantities_meant(problem: Problem, letter: Letter) -> tuple[Fix, ...]:
    """What v, v_A or J was meant to be, each as a cure."""
    place = letter.place
    if place is None:
        return ()
    symbol, _, of = letter.name.partition("_")
    spheres = [sphere.name for sphere in problem.spheres]
    if symbol in _OF_ALL and not of:
        texts = [_OF_ALL[symbol]]
    elif symbol in _OF_A_SPHERE and (not of or of in spheres):
        forms = _OF_A_SPHERE[symbol]
        if of or len(spheres) == 1:
            texts = [form.format(of or spheres[0]) for form in forms]
        else:
            texts = [forms[0].format(name) for name in spheres[:_FEW]]
    else:
        return ()
    end = place.column + len(letter.name)
    return tuple(
        Fix(f"Write {text}", (Edit(place.line, place.column, place.line, end, text),))
        for text in texts
    )


# --- a stage behind a letter ----------------------------------------------------------------------


def _letters_with_a_stage(problem: Problem, text: str) -> Iterator[Note]:
    """``e(2)``, which is twice e, where the statement has no fewer events."""
    events = sum(isinstance(step, Event) for _, step in problem.steps())
    lines = text.split("\n")
    for tree in trees(problem):
        for node in walk(tree):
            match node:
                case Binary("*", Letter(name, place=place), Number(value)) if place is not None:
                    written = f"{name}({value})"
                    line = lines[place.line - 1 : place.line]
                    if not 0 < value <= events or not line:
                        continue
                    if not line[0].startswith(written, place.column - 1):
                        continue
                    end = place.column + len(written)
                    edit = Edit(place.line, place.column, place.line, end, name)
                    yield _note(
                        place,
                        f"{written} was read as {name} times {value}: a letter has no stage, "
                        f"so write {name}",
                        Fix(f"Write {name}", (edit,)),
                    )


# --- axes ---------------------------------------------------------------------------------------


def _axes(problem: Problem) -> Iterator[Note]:
    """``along x``, where x is a letter of nothing else: an angle, and probably the axis."""
    directions = [wall.along for wall in problem.walls]
    directions += [step.along for _, step in problem.steps() if isinstance(step, Impact)]
    axes = [
        direction
        for direction in directions
        if isinstance(direction, Letter) and direction.name in _AXES
    ]
    if not axes:
        return
    used = set(_used(problem, axes))
    for letter in axes:
        place = letter.place
        if letter.name in used or place is None:
            continue
        vector = _AXES[letter.name]
        edit = Edit(place.line, place.column, place.line, place.column + 1, vector)
        yield _note(
            place,
            f"{letter.name} was read as an angle: did you mean {vector}?",
            Fix(f"Write {vector}", (edit,)),
        )


_AXES = {"x": "i", "y": "j"}


def _used(problem: Problem, besides: Iterable[Expression]) -> Iterator[str]:
    """The letters that stand anywhere but in some expressions, the unwritten e of an impact too."""
    apart = {id(beside) for beside in besides}
    for tree in trees(problem):
        if id(tree) not in apart:
            yield from letters(tree)
    for _, step in problem.steps():
        match step:
            case Impact(e=None):
                yield "e"
            case Let(letter):
                yield letter
            case Unknown(named):
                yield from named
            case Find(_, named) | Show(_, _, named) if named:
                yield from named
