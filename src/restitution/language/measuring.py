"""Units: which of the letters behind numbers are units, and the values in SI without them.

A unit of one letter (m, s, g, J) can only be told from a letter when the whole statement is read:
it is a unit if what is measured there has its dimension, and the letter stands nowhere else.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import field, replace
from functools import partial
from typing import Any

from restitution.errors import StatementError
from restitution.expression import read_expression
from restitution.expression.dimensions import (
    ENERGY,
    IMPULSE,
    LENGTH,
    MASS,
    NONE,
    SPEED,
    TIME,
    Dimension,
)
from restitution.expression.measured import (
    ANGLE,
    NOWHERE,
    Slot,
    has_unit,
    product_with,
    scaled,
    without_units,
)
from restitution.expression.quantities import ANGLES, dimension_of, dimension_of_any
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Expression,
    Letter,
    Measured,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    letters,
    walk,
)
from restitution.expression.units import NAMES, letters_of, measure
from restitution.expression.writing import write_expression
from restitution.mending import Edit, Fix, Note
from restitution.problem import (
    Arrival,
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Item,
    Kick,
    Let,
    Problem,
    Relation,
    Show,
    Step,
    Unknown,
    once_a_problem,
    trees,
)
from restitution.records import dataclass

# N is a unit that nothing here is measured in.
_ONE_LETTER: Mapping[str, Dimension] = {"m": LENGTH, "s": TIME, "g": MASS, "J": ENERGY, "N": NONE}
_SYMBOLS = frozenset("msgNJ")
_RULE = "besides SI units, g, cm, mm and km/h are read"

Rewrite = Callable[[Any, Slot], Any]


@dataclass
class _Reading:
    """Units that are met while a problem is rewritten."""

    letters: AbstractSet[str]
    mistakes: list[StatementError] = field(default_factory=list)
    notes: list[Note] = field(default_factory=list)


def in_si(problem: Problem, named: AbstractSet[str]) -> tuple[Problem, tuple[Note, ...]]:
    """The problem without units, and what there is to say of them; ``named`` are its bodies.

    Raises StatementError for a unit that is not read, or that measures something else.
    """
    of_letters = dimensions_of_letters(problem)
    reading = _Reading(_letters_of(problem, of_letters) | named)
    decide = partial(_decide, reading)
    rewritten = _rewritten(
        problem, of_letters, lambda tree, slot: without_units(tree, slot, decide, of_letters)
    )
    if reading.mistakes:
        first, *others = reading.mistakes
        first.others = tuple(others)
        raise first
    return rewritten, tuple(reading.notes)


def like_units(problem: Problem) -> frozenset[str]:
    """The letters of a problem that would be taken for units where they stand behind numbers."""
    of_letters = dimensions_of_letters(problem)
    fit: Counter[str] = Counter()

    def look(tree: Any, slot: Slot) -> Any:
        for letter, where in _behind_numbers(tree, slot):
            fit[letter] += _may_be_a_unit(letter, where)
        return tree

    _rewritten(problem, of_letters, look)
    if not fit:
        return frozenset()
    used = Counter(
        node.name for tree in trees(problem) for node in walk(tree) if isinstance(node, Letter)
    )
    used.update(_listed(problem))
    return frozenset(letter for letter, count in fit.items() if count == used[letter])


def _listed(problem: Problem) -> Iterator[str]:
    """The letters that lines name beside those in expressions."""
    for _, step in problem.steps():
        match step:
            case Let(letter):
                yield letter
            case Unknown(named):
                yield from named
            case Find(_, named) | Show(_, _, named) if named:
                yield from named


def _behind_numbers(tree: Any, slot: Slot) -> Iterator[tuple[str, Slot]]:
    """The letters of one character that stand behind a number, as a unit would."""
    marked: list[tuple[str, Slot]] = []

    def note(measured: Measured, where: Slot) -> Expression:
        marked.append((measured.unit, where))
        return measured.operand

    without_units(_marked(tree), slot, note, {})
    yield from marked


def _marked(tree: Any) -> Any:
    """A tree in which each such letter is marked as a unit."""
    match tree:
        case Binary("*", left, Letter(name)) if name in _ONE_LETTER and not letters(left):
            return Measured(left, name, place=tree.place)
        case Negate(operand):
            return replace(tree, operand=_marked(operand))
        case Binary(_, left, right):
            return replace(tree, left=_marked(left), right=_marked(right))
        case Pair(x, y):
            return replace(tree, x=_marked(x), y=_marked(y))
        case Polar(size):
            return replace(tree, size=_marked(size))
        case Apply(_, argument):
            return replace(tree, argument=_marked(argument))
        case Quantity(stage=AtTime(time)):
            return replace(tree, stage=AtTime(_marked(time)))
    return tree


def _may_be_a_unit(letter: str, slot: Slot) -> bool:
    """Whether a letter behind a number is a unit, right or wrong, if it stands nowhere else.

    Masses are 2m and 3m, and an impulse is J: only newtons and joules are sure to be wrong.
    """
    if slot.dimension in (None, NONE):
        return False
    if letter in "NJ":
        return letter == "N" or slot.dimension != IMPULSE
    return _ONE_LETTER[letter] == slot.dimension


# --- which letters there are --------------------------------------------------------------------


def _letters_of(problem: Problem, of_letters: Mapping[str, Dimension]) -> frozenset[str]:
    """The letters of a problem, those that can only be letters behind their numbers included."""
    names: set[str] = set()
    for tree in trees(problem):
        names |= letters(tree)
    names.update(_listed(problem))

    def look(measured: Measured, slot: Slot) -> Expression:
        if len(measured.unit) == 1 and not _may_be_a_unit(measured.unit, slot):
            names.add(measured.unit)
        return measured.operand

    _rewritten(problem, of_letters, lambda tree, slot: without_units(tree, slot, look, of_letters))
    return frozenset(names)


def dimensions_of_letters(problem: Problem) -> dict[str, Dimension]:
    """Letters that alone, or times a number, are the value of a property: of its dimension.

    A coefficient of restitution is a number, also where it stands beside one, as in 5 + e.
    """
    return dict(_dimensions_of_letters(problem))


@once_a_problem
def _dimensions_of_letters(problem: Problem) -> dict[str, Dimension]:
    dimensions: dict[str, Dimension] = {}
    for _, step in problem.steps():
        if isinstance(step, Impact):
            e = Letter("e") if step.e is None else step.e
            dimensions.update(dict.fromkeys(_alone(e, angle=False), NONE))

    def look(tree: Any, slot: Slot) -> Any:
        dimension = slot.dimension
        if dimension is not None and isinstance(tree, Expression):
            for letter in _alone(tree, slot.angle):
                dimensions.setdefault(letter, dimension)
        return tree

    _rewritten(problem, {}, look)
    for _, step in problem.steps():
        if isinstance(step, Let):
            dimension = dimension_of(step.expression)
            if dimension is not None:
                dimensions.setdefault(step.letter, dimension)
    for node in (node for tree in trees(problem) for node in walk(tree)):
        if isinstance(node, Quantity) and isinstance(node.stage, AtTime):
            for letter in _alone(node.stage.time, angle=False):
                dimensions.setdefault(letter, TIME)
    return dimensions


def _alone(tree: Any, angle: bool) -> Iterator[str]:
    match tree:
        case Letter(name):
            yield name
        case Negate(operand):
            yield from _alone(operand, angle)
        case Polar(size):
            yield from _alone(size, angle)
        case Pair(x, y):
            yield from _alone(x, angle)
            yield from _alone(y, angle)
        case Binary("+" | "-", left, right):
            yield from _alone(left, angle)
            yield from _alone(right, angle)
        case Binary("*", Number(), right):
            yield from _alone(right, angle)
        case Binary("*", left, Unit() | Apply()):
            yield from _alone(left, angle)
        case Binary("/", left, Number()):
            yield from _alone(left, angle)


# --- where values stand -------------------------------------------------------------------------


def _rewritten(problem: Problem, of_letters: Mapping[str, Dimension], rewrite: Rewrite) -> Problem:
    """A problem with every expression rewritten, each with its place."""

    def put(tree: Any, dimension: Dimension, what: str) -> Any:
        return tree if not _is_tree(tree) else rewrite(tree, Slot(dimension, what))

    def turned(tree: Any) -> Any:
        return tree if not _is_tree(tree) else rewrite(tree, ANGLE)

    def place(tree: Any) -> Any:
        return put(tree, LENGTH, "a place")

    return replace(
        problem,
        spheres=tuple(
            replace(
                sphere,
                mass=put(sphere.mass, MASS, f"the mass of {sphere.name}"),
                velocity=put(sphere.velocity, SPEED, f"the velocity of {sphere.name}"),
                position=put(sphere.position, LENGTH, f"the place of {sphere.name}"),
                radius=put(sphere.radius, LENGTH, f"the radius of {sphere.name}"),
            )
            for sphere in problem.spheres
        ),
        walls=tuple(
            replace(
                wall,
                along=turned(wall.along),
                through=place(wall.through),
                start=place(wall.start),
                end=place(wall.end),
                centre=place(wall.centre),
                radius=put(wall.radius, LENGTH, f"the radius of {wall.name}"),
            )
            for wall in problem.walls
        ),
        points=tuple(replace(point, position=place(point.position)) for point in problem.points),
        parts=tuple(
            replace(
                part,
                steps=tuple(_step(step, of_letters, rewrite, put, turned) for step in part.steps),
            )
            for part in problem.parts
        ),
    )


def _is_tree(value: Any) -> bool:
    return isinstance(value, Expression | Measured)


def _step(
    step: Step,
    of_letters: Mapping[str, Dimension],
    rewrite: Rewrite,
    put: Callable[[Any, Dimension, str], Any],
    turned: Callable[[Any], Any],
) -> Step:
    def relation(stated: Relation) -> Relation:
        return _relation(stated, of_letters, rewrite)

    def item(asked: Item) -> Item:
        changed = replace(asked, expression=rewrite(asked.expression, NOWHERE))
        if isinstance(changed, Extremum):
            return replace(changed, over=rewrite(changed.over, NOWHERE))
        return changed

    match step:
        case Impact():
            return replace(
                step,
                e=put(step.e, NONE, "e"),
                along=turned(step.along),
                offset=put(step.offset, LENGTH, "the offset"),
            )
        case Kick():
            return replace(step, impulse=put(step.impulse, IMPULSE, f"the impulse on {step.body}"))
        case Arrival():
            return replace(step, target=put(step.target, LENGTH, "a place"))
        case Let():
            return replace(step, expression=rewrite(step.expression, NOWHERE))
        case Given():
            return replace(step, relations=tuple(map(relation, step.relations)))
        case Find():
            return replace(step, items=tuple(map(item, step.items)))
        case Show():
            subject = step.subject
            if subject is not None:
                subject = replace(subject, expression=rewrite(subject.expression, NOWHERE))
                if isinstance(subject, Extremum):
                    subject = replace(subject, over=rewrite(subject.over, NOWHERE))
            return replace(step, relation=relation(step.relation), subject=subject)
    return step


def _relation(
    relation: Relation, of_letters: Mapping[str, Dimension], rewrite: Rewrite
) -> Relation:
    if not isinstance(relation, Compare):
        return relation
    operands: tuple[Any, ...] = relation.operands
    plain = [operand for operand in operands if not isinstance(operand, Measured)]
    dimension = dimension_of_any(plain, of_letters)
    tells = [tree for tree in plain if dimension_of_any([tree], of_letters) is not None]
    what = write_expression(tells[0]) if tells and not has_unit(tells[0]) else "this value"
    angle = any(isinstance(tree, Quantity) and tree.kind in ANGLES for tree in plain)
    slot = Slot(dimension, what, angle)
    return replace(
        relation, operands=tuple(rewrite(operand, slot) for operand in relation.operands)
    )


# --- what a unit does -----------------------------------------------------------------------------


def _decide(reading: _Reading, measured: Measured, slot: Slot) -> Expression:
    """The value in SI; a product, where the letters are letters. Mistakes are gathered."""
    unit, known = measured.unit, measure(measured.unit)
    own = letters_of(unit)
    if len(unit) == 1 and (unit in reading.letters or not _may_be_a_unit(unit, slot)):
        return product_with(measured.operand, Letter(unit, place=measured.operand.place))
    if own and (own <= reading.letters or (known.dimension is None and own & reading.letters)):
        place = _place_of_unit(measured)
        reading.notes.append(
            Note(f"'{unit}' was read as a product of letters", *place, (_leave_out(measured),))
        )
        return product_with(measured.operand, read_expression(unit))
    refusal = _refusal(reading, measured, slot)
    if refusal is not None:
        reading.mistakes.append(refusal)
        return measured.operand
    if known.factor == 1:
        return measured.operand
    value = scaled(measured.operand, known.factor)
    _converted(reading, measured, value)
    return value


def _refusal(reading: _Reading, measured: Measured, slot: Slot) -> StatementError | None:
    """Why a unit cannot stand in a place, or None where it can."""
    unit, known = measured.unit, measure(measured.unit)
    fixes = [_leave_out(measured)]
    dimension = slot.dimension
    si = NAMES.get(dimension) if dimension is not None and dimension != NONE else None
    own = letters_of(unit)
    # With c no letter, 5 cm is a length, also where m is a mass.
    fits = known.dimension == slot.dimension and not own <= reading.letters
    clash = [] if fits else sorted(own & reading.letters & _SYMBOLS)
    if clash:
        are = "is a letter" if len(clash) == 1 else "are letters"
        message = (
            f"'{unit}' cannot be a unit here, as {' and '.join(clash)} {are} of this statement: "
            f"leave out '{unit}' (all is in SI)"
        )
    elif slot.angle and known.dimension == NONE:
        return None
    elif known.dimension is None:
        wanted = f"{slot.what} is in {si[1]}" if si else f"{slot.what or 'this'} has no unit"
        message = f"the unit '{unit}' is not read: {wanted}; {_RULE}"
        fixes = []
        if unit == "ms" and dimension == SPEED:
            message = f"'ms' is no unit of {slot.what}: did you mean 'm/s'?"
            fixes = [_instead(measured, " m/s")]
    elif dimension is None or dimension not in NAMES:
        message = f"no units are typed (all is in SI): leave out '{unit}'"
    elif known.dimension == dimension and not slot.angle:
        if not slot.mixed or known.factor == 1:
            return None
        message = (
            f"'{unit}' stands behind one term of a sum and not behind the others: write it behind "
            "each, or behind brackets"
        )
        fixes = []
    else:
        noun = NAMES[known.dimension][0]
        wanted = "takes ° or rad" if slot.angle else f"is in {si[1]}" if si else "has no unit"
        message = f"'{unit}' is a unit of {noun}, and {slot.what} {wanted}"
        fixes = []
    mistake = StatementError(message, *_place_of_unit(measured))
    mistake.fixes = tuple(fixes)
    return mistake


def _place_of_unit(measured: Measured) -> tuple[int, int]:
    """Line and column of the unit itself, which ends in the line in which it begins."""
    _, _, line, end = measured.stretch
    return line, max(1, end - len(measured.unit))


def _leave_out(measured: Measured) -> Fix:
    return _instead(measured, "")


def _instead(measured: Measured, text: str) -> Fix:
    label = (
        f"Replace '{measured.unit}' by '{text.strip()}'" if text else f"Leave out '{measured.unit}'"
    )
    return Fix(label, (Edit(*measured.stretch, text),))


def _converted(reading: _Reading, measured: Measured, value: Expression) -> None:
    """The note of a value that was converted."""
    typed, written = write_expression(measured.operand), write_expression(value)
    fixes: tuple[Fix, ...] = ()
    start = measured.place
    if start is not None and start.line == measured.stretch[2]:
        stretch = (start.line, start.column, *measured.stretch[2:])
        fixes = (Fix(f"Write {written}", (Edit(*stretch, written),)),)
    si = NAMES[measure(measured.unit).dimension or NONE][1]
    message = f"{typed} {measured.unit} was read as {written} {si}"
    reading.notes.append(Note(message, *_place_of_unit(measured), fixes))
