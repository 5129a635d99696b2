"""A part in one of its worlds, with all that a letter may mean there, and what is declared."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from fractions import Fraction
from functools import cached_property
from itertools import permutations

import numpy as np

from restitution.expression.evaluate import Angle, Value
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    Unit,
    has_quantity,
    is_binary,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.practice.letters.candidates import Candidate, before_event, candidates
from restitution.practice.letters.inference import Item
from restitution.practice.letters.instances import Instances
from restitution.practice.letters.interpretation import FixedLetter
from restitution.practice.letters.options import of_trees, staged
from restitution.practice.letters.slots import Slot, makes_idle, same_size
from restitution.practice.letters.trial import Tester
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.phrases import read_phrase
from restitution.practice.script import ANYWHERE, Scope, Script, ScriptLine
from restitution.practice.worlds.arrays import is_bare
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Event, Find, Given, Impact, Let, Part, Problem, Show, trees
from restitution.records import dataclass
from restitution.vector import Vector

# What a quantity costs that is no usual one, but asked for.
_ASKED = 0.2


@dataclass(frozen=True, eq=False)
class Surroundings:
    """A part in one of its worlds, with all that a letter may mean there."""

    problem: Problem
    part: Part
    world: World
    _phrases: dict[tuple[str, int | None], tuple[Expression, ...]] = field(
        default_factory=dict, init=False
    )

    @cached_property
    def tester(self) -> Tester:
        """The tester of claims in this world."""
        return Tester(self.world)

    @cached_property
    def instances(self) -> Instances:
        """The test of which lines break a known law."""
        return Instances(self.world)

    def broken(self, item: Item, slots: Sequence[Slot]) -> Mapping[tuple[int, ...], float]:
        """The options for which an item breaks a known law, with what it is worth then."""
        return self.instances.shares(item, slots)

    @cached_property
    def candidates(self) -> tuple[Candidate, ...]:
        """Every quantity that a letter may mean."""
        usual = list(candidates(self.problem, self.part))
        known = {candidate.quantity for candidate in usual}
        further = (tree for tree in self.asked if tree not in known and isinstance(tree, Quantity))
        usual += [replace(candidate, cost=_ASKED) for candidate in of_trees(further)]
        return tuple(
            replace(
                candidate,
                unchanged=self._is_unchanged(candidate),
                varies=self._varies(candidate),
                asked=candidate.nature != "vector" and candidate.quantity in self.asked,
                stopped=(candidate.body, candidate.event) in self.stopped,
                given=(candidate.body, candidate.event) in self.given,
            )
            for candidate in usual
            if not self._is_no_time(candidate) and not self._is_of_the_axes(candidate)
        )

    @cached_property
    def asked(self) -> tuple[Expression, ...]:
        """The quantities that the part asks for, with the numbers of their events."""
        return tuple(
            staged(item.expression, self.problem, self.part, now)
            for step, now, _ in self.problem.timeline(self.part)
            if isinstance(step, Find)
            for item in step.items
        )

    @cached_property
    def printed(self) -> tuple[Expression, ...]:
        """The sides of the relations that the part prints, with the numbers of their events."""
        return tuple(
            staged(tree, self.problem, self.part, now)
            for step, now, _ in self.problem.timeline(self.part)
            if isinstance(step, Show) and isinstance(step.relation, Compare)
            for tree in step.relation.operands
        )

    @cached_property
    def asks_time(self) -> bool:
        """Whether the part asks for a time."""
        return any(is_quantity(node, "time") for tree in self.asked for node in walk(tree))

    @cached_property
    def stopped(self) -> frozenset[tuple[str | None, int | None]]:
        """The bodies that the part is to show at rest, each with the number of the event before."""
        at_rest: set[tuple[str | None, int | None]] = set()
        for step, now, _ in self.problem.timeline(self.part):
            relation = step.relation if isinstance(step, Show) else None
            operands = relation.operands if isinstance(relation, Compare) else ()
            for tree, other in permutations(operands, 2):
                match staged(tree, self.problem, self.part, now):
                    case Quantity("speed" | "velocity", (Name(body),), int(stage)):
                        if other == Number(Fraction(0)):
                            at_rest.add((body, stage))
        return frozenset(at_rest)

    @cached_property
    def given(self) -> frozenset[tuple[str | None, int | None]]:
        """The bodies whose velocity after an event is given in numbers, each with that event."""
        known: set[tuple[str | None, int | None]] = set()
        for step, now, _ in self.problem.timeline(self.part):
            relations = step.relations if isinstance(step, Given) else ()
            for relation in relations:
                operands = relation.operands if isinstance(relation, Compare) else ()
                for tree, other in permutations(operands, 2):
                    match staged(tree, self.problem, self.part, now):
                        case Quantity("velocity", (Name(body),), int(stage)) if stage:
                            if not any(isinstance(x, Letter | Quantity) for x in walk(other)):
                                known.add((body, stage))
        return frozenset(known)

    def _is_no_time(self, candidate: Candidate) -> bool:
        """Whether a time is zero in a story that begins with that event."""
        if candidate.kind != "time":
            return False
        value = self.tester.value(candidate.quantity, {})
        return isinstance(value, np.ndarray | float) and not np.any(value)

    def _is_of_the_axes(self, candidate: Candidate) -> bool:
        """Whether an angle is that of a line along i or j to i or j: nobody has a letter for it."""
        tree = candidate.quantity
        if not is_quantity(tree, "angle"):
            return False
        line, axis = tree.arguments
        if not is_quantity(line, "line_of_centres"):
            return False
        value = self.tester.value(tree, {}) if isinstance(axis, Unit) else None
        return isinstance(value, Angle) and makes_idle(value, self.tester)

    def _varies(self, candidate: Candidate) -> bool:
        """Whether a scalar depends on the letters of the statement."""
        value = self.tester.value(candidate.quantity, {})
        if value is None or isinstance(value, Vector | Angle):
            return False
        spread = self.world.spread(value)
        return bool(np.all(np.isfinite(spread)) and np.ptp(spread) > 1e-6 * np.max(np.abs(spread)))

    def _is_unchanged(self, candidate: Candidate) -> bool:
        """Whether a component after an event is what it was before it."""
        if candidate.kind != "component" or not candidate.event:
            return False
        after = self.tester.value(candidate.quantity, {})
        before = self.tester.value(before_event(candidate.quantity), {})
        return after is not None and before is not None and same_size(after, before)

    def is_a_part(self, candidate: Candidate) -> bool:
        """Whether a component is only a part of its velocity, which has another one as well."""
        if candidate.kind != "component" or candidate.body is None:
            return False
        part = self.tester.value(candidate.quantity, {})
        whole = self.tester.value(
            Quantity("speed", (Name(candidate.body),), candidate.event or 0), {}
        )
        return part is not None and whole is not None and not same_size(part, whole)

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """The events of the story."""
        return self.world.events

    @cached_property
    def letters(self) -> frozenset[str]:
        """The letters of the statement and its lets."""
        return letters_of(self.problem, self.part)

    def of_the_start(self, value: Value) -> bool:
        """Whether a value is, up to sign, that of a quantity known from the start."""
        known = (
            self.tester.value(candidate.quantity, {})
            for candidate in self.candidates
            if candidate.start
        )
        return any(same_size(value, speed) for speed in known if speed is not None)

    def directions(self, lines: Iterable[ScriptLine]) -> tuple[Expression, ...]:
        """Vectors of any length, such as 3i + 4j: in scalar products, or as data.

        Data are those of lines of centres.
        """
        sizes: dict[float, Expression] = {}
        for line in lines:
            for link in line.links:
                for side in (link.readings[0].left, link.readings[0].right):
                    for tree in walk(side):
                        if is_quantity(tree, "dot"):
                            for argument in tree.arguments:
                                sizes.setdefault(self._size(argument), argument)
        for step in self.events:
            if isinstance(step, Impact) and step.along is not None:
                sizes.setdefault(self._size(step.along), step.along)
        return tuple(tree for size, tree in sizes.items() if size not in (0.0, 1.0))

    def multipliers(self, lines: Iterable[ScriptLine]) -> dict[str, Expression]:
        """The letters that multiply a vector of numbers which is no unit vector, each with it."""
        directions: dict[str, Expression] = {}
        for line in lines:
            for link in line.links:
                for side in (link.readings[0].left, link.readings[0].right):
                    for tree in walk(side):
                        match tree:
                            case Binary("*", left, right):
                                pairs = ((left, right), (right, left))
                            case _:
                                continue
                        for factor, vector in pairs:
                            own = unsigned(factor)
                            if is_binary(own, "*") and is_bare(own.left):
                                own = own.right  # 2k(3i + 4j), with a mass
                            if isinstance(own, Letter) and self._size(vector) not in (0.0, 1.0):
                                directions.setdefault(own.name, vector)
        return directions

    def _size(self, tree: Expression) -> float:
        """The size of a vector of numbers; 0 of anything else."""
        named = letters(tree) or has_quantity(tree)
        named = named or any(isinstance(node, Name) for node in walk(tree))
        value = None if named else self.tester.value(tree, {})
        return round(float(np.hypot(*value)), 9) if isinstance(value, Vector) else 0.0

    def phrase(self, words: str, event: int | None = None) -> tuple[Expression, ...]:
        """The quantities that a phrase may name, under a heading of an event; none for a letter."""
        if not is_phrase(words):
            return ()
        key = words, event
        if key not in self._phrases:
            self._phrases[key] = read_phrase(words, self.problem, event, self.world.now())
        return self._phrases[key]

    def staged(self, tree: Expression, scope: Scope) -> Expression:
        """A tree in which every quantity tells the number of its event."""
        return staged(tree, self.problem, self.part, self.world.now(scope))


def letters_of(problem: Problem, part: Part | None = None) -> frozenset[str]:
    """The letters that a statement gives a meaning, e of an impact without a number among them."""
    names: set[str] = set()
    for tree in trees(problem):
        names |= letters(tree)
    for step, _, _ in problem.timeline(part):
        if isinstance(step, Let):
            names.add(step.letter)
        elif isinstance(step, Impact) and step.e is None:
            names.add("e")
    return frozenset(names)


# --- declarations ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class DeclaredLetter:
    """A letter that is declared: its possible trees, and the line from which they hold."""

    letter: str
    trees: tuple[Expression, ...]
    words: str
    since: int
    scope: Scope = ANYWHERE


def declarations(
    script: Script, around: Surroundings, declared: Mapping[str, Expression | Sequence[Expression]]
) -> tuple[list[DeclaredLetter], list[FixedLetter]]:
    """What is declared in the box and in lines; letters of the statement that are fixed."""
    letters_declared: list[DeclaredLetter] = []
    fixed: list[FixedLetter] = []
    for letter, trees_ in declared.items():
        meanings = trees_ if isinstance(trees_, tuple | list) else (trees_,)
        whole = tuple(around.staged(tree, ANYWHERE) for tree in meanings)
        if whole:
            letters_declared.append(DeclaredLetter(letter, whole, "", 0))
    for line in script.lines:
        for one in line.declarations:
            if one.letter in around.letters:
                fixed += _fixed(one.letter, one.meanings, line, script, around)
                continue
            whole = tuple(around.staged(tree, line.scope) for tree in one.meanings)
            if whole:
                first = all(one.letter != known.letter for known in letters_declared)
                since = 0 if first else line.number
                letters_declared.append(
                    DeclaredLetter(one.letter, whole, one.words, since, line.scope)
                )
    return letters_declared, fixed


def _fixed(
    letter: str,
    meanings: Sequence[Expression],
    line: ScriptLine,
    script: Script,
    around: Surroundings,
) -> Iterator[FixedLetter]:
    """``take u = 5``, until a line carries the letter again."""
    value = rational_value(meanings[0]) if meanings else None
    if value is None:
        return
    again = [
        other.number
        for other in script.lines
        if other.number > line.number and letter in _letters_in(other)
    ]
    yield FixedLetter(letter, value, line.number, again[0] - 1 if again else None)


def rational_value(tree: Expression) -> Fraction | None:
    """The value of a number as typed: 5, -2, 1/3; None for any other tree."""
    match tree:
        case Number(value) | Degrees(value):
            return value
        case Negate(operand):
            inner = rational_value(operand)
            return None if inner is None else -inner
        case Binary("/", left, right):
            above, below = rational_value(left), rational_value(right)
            return above / below if above is not None and below else None
    return None


def _letters_in(line: ScriptLine) -> frozenset[str]:
    claims = [claim for link in line.links for claim in link.readings[:1]]
    return frozenset[str]().union(
        *(letters(side) for claim in claims for side in (claim.left, claim.right))
    )


def all_fixed(script: Script, statement: frozenset[str]) -> dict[str, Fraction]:
    """The letters of the statement that a script fixes, each with its first value."""
    fixed: dict[str, Fraction] = {}
    for line in script.lines:
        for declaration in line.declarations:
            value = rational_value(declaration.meanings[0]) if declaration.meanings else None
            if declaration.letter in statement and value is not None:
                fixed.setdefault(declaration.letter, value)
    return fixed
