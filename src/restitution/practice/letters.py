"""What the letters and phrases of a script mean, and which of them have to be asked.

In order: letters of the statement; what the student declares; what a letter usually means; and
what makes most lines true (`inference`). A letter has one meaning in a scope. A new declaration or
a heading opens one, and outside it the meaning holds on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from functools import cached_property
from typing import Any

from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    letters,
)
from restitution.practice.arrays import is_bare
from restitution.practice.candidates import Candidate, candidates
from restitution.practice.dependence import Dependence
from restitution.practice.inference import Item, Slot, State, linear_pair, search, slot_of
from restitution.practice.instances import Instances
from restitution.practice.interpretation import FixedLetter, Interpretation, Interpretations
from restitution.practice.judgement import By, Meaning
from restitution.practice.options import Usage, of_trees, options, staged, usual
from restitution.practice.sampling import true_worlds
from restitution.practice.script import ANYWHERE, Claim, Link, Scope, Script, ScriptLine
from restitution.practice.trial import Frame, Tester, inside_angles
from restitution.practice.wordings import words_of
from restitution.practice.world import World
from restitution.problem import Event, Impact, Let, Part, Problem, trees
from restitution.solving.solution import Solution

# Meanings that explain a script nearly as well as the best are kept.
NEARLY = 0.7
_RIVALS = 24
_INEQUALITY = 0.25
_HEADING, _BREAK = 0.2, 1.2
# What it costs that a letter means nothing.
_UNKNOWN = 0.1
# A line that follows from those above, and one that tells the sense of its letters.
_DEPENDENT, _MOMENTUM = 0.3, 1.8


def meanings_of(
    script: Script,
    problem: Problem,
    solution: Solution,
    part: str | None = None,
    declared: Mapping[str, Expression | Sequence[Expression]] | None = None,
    worlds: Sequence[World] | None = None,
) -> Interpretations:
    """What every letter and phrase of a script means: the best interpretation and its rivals.

    ``declared`` are meanings from the letters box, as trees or, where words may mean several, as
    sequences of trees. ``worlds`` are the true worlds of the part, which are made where they are
    not given. Raises KeyError for a part that is not there.
    """
    own = script.of(part)
    fixed = _all_fixed(own, letters_of(problem, solution.parts[part].part))
    if worlds is None or fixed:
        worlds = true_worlds(solution, part, fixed)
    found: list[Interpretation] = []
    for world in worlds[:4]:
        surroundings = Surroundings(problem, solution.parts[part].part, world)
        found += _interpretations(own, surroundings, declared or {})
    if not found:
        return Interpretations(Interpretation())
    found.sort(key=lambda each: -each.score)
    best = found[0]
    rivals = [each for each in found[1:] if each.score >= best.score - NEARLY]
    return Interpretations(best, tuple(_distinct(best, rivals))[:_RIVALS])


def _all_fixed(script: Script, statement: frozenset[str]) -> dict[str, Fraction]:
    """The letters of the statement that a script fixes, each with its first value."""
    fixed: dict[str, Fraction] = {}
    for line in script.lines:
        for each in line.declarations:
            value = rational_value(each.meanings[0]) if each.meanings else None
            if each.letter in statement and value is not None:
                fixed.setdefault(each.letter, value)
    return fixed


def _distinct(best: Interpretation, rivals: Iterable[Interpretation]) -> Iterator[Interpretation]:
    seen = {_signature(best)}
    for each in rivals:
        if _signature(each) not in seen:
            seen.add(_signature(each))
            yield each


def _signature(each: Interpretation) -> Any:
    return frozenset((m.letter, m.quantity, m.since) for m in each.meanings)


@dataclass(frozen=True, eq=False)
class Surroundings:
    """A part in one of its worlds, with all that a letter may mean there."""

    problem: Problem
    part: Part
    world: World
    _phrases: dict[str, tuple[Expression, ...]] = field(default_factory=dict, init=False)

    @cached_property
    def tester(self) -> Tester:
        """Tries claims in this world."""
        return Tester(self.world)

    @cached_property
    def instances(self) -> Instances:
        """Tells which lines break a known law."""
        return Instances(self.world)

    def broken(self, item: Item, slots: Sequence[Slot]) -> Mapping[tuple[int, ...], float]:
        """The options for which an item breaks a known law, with what it is worth then."""
        return self.instances.ways(item, slots)

    @cached_property
    def candidates(self) -> tuple[Candidate, ...]:
        """Every quantity that a letter may mean."""
        return candidates(self.problem, self.part)

    @cached_property
    def events(self) -> tuple[Event, ...]:
        """The events of the story."""
        return self.world.events

    @cached_property
    def letters(self) -> frozenset[str]:
        """The letters of the statement and its lets."""
        return letters_of(self.problem, self.part)

    def phrase(self, words: str) -> tuple[Expression, ...]:
        """The quantities that a phrase may name; none for a letter."""
        if words not in self._phrases:
            self._phrases[words] = read_words(words, self.problem) if " " in words else ()
        return self._phrases[words]

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


def read_words(words: str, problem: Problem) -> tuple[Expression, ...]:
    """The quantities that words may name, the most natural first."""
    from importlib import import_module

    try:
        phrases = import_module("restitution.practice.phrases")
    except ModuleNotFoundError:
        return ()
    return tuple(phrases.read_phrase(words, problem))


# --- declarations ---------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Declared:
    """A letter that is declared: its possible trees, and the line from which they hold."""

    letter: str
    trees: tuple[Expression, ...]
    words: str
    since: int
    scope: Scope = ANYWHERE


def _declarations(
    script: Script, around: Surroundings, declared: Mapping[str, Any]
) -> tuple[list[_Declared], list[FixedLetter]]:
    """What is declared in the box and in lines; letters of the statement that are fixed."""
    found: list[_Declared] = []
    fixed: list[FixedLetter] = []
    for letter, trees_ in declared.items():
        each = trees_ if isinstance(trees_, tuple | list) else (trees_,)
        whole = tuple(around.staged(tree, ANYWHERE) for tree in each)
        if whole:
            found.append(_Declared(letter, whole, "", 0))
    for line in script.lines:
        for one in line.declarations:
            if one.letter in around.letters:
                fixed += _fixed(one.letter, one.meanings, line, script, around)
                continue
            whole = tuple(around.staged(tree, line.scope) for tree in one.meanings)
            if whole:
                first = all(one.letter != known.letter for known in found)
                since = 0 if first else line.number
                found.append(_Declared(one.letter, whole, one.words, since, line.scope))
    return found, fixed


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
        each.number
        for each in script.lines
        if each.number > line.number and letter in _letters_in(each)
    ]
    yield FixedLetter(letter, value, line.number, again[0] - 1 if again else None)


def rational_value(tree: Expression) -> Fraction | None:
    """The value of a number as typed: 5, -2, 1/3; None for any other tree."""
    from restitution.expression.tree import Negate

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


# --- one world ------------------------------------------------------------------------------------


def _interpretations(
    script: Script, around: Surroundings, declared: Mapping[str, Any]
) -> list[Interpretation]:
    search_ = _Search(script, around, *_declarations(script, around, declared))
    found = search_.interpretations(())
    for breaks in search_.breaks(found):
        found += search_.interpretations(breaks)
    found.sort(key=lambda each: -each.score)
    return [each for each in found if each.score >= found[0].score - NEARLY]


@dataclass(frozen=True)
class _Break:
    """Letters may have another meaning from a line on; what that costs for each that does."""

    line: int
    cost: float


class _Search:
    """The interpretations of a script in one world."""

    def __init__(
        self,
        script: Script,
        around: Surroundings,
        declared: Sequence[_Declared],
        fixed: Sequence[FixedLetter],
    ) -> None:
        self.lines = [line for line in script.lines if line.kind in ("relations", "declaration")]
        self.around = around
        self.declared = declared
        self.fixed = tuple(fixed)
        self.angular = self._angular()
        self.slots: dict[Any, Slot | None] = {}
        self.items: dict[int, list[tuple[Link, frozenset[str]]]] = {}
        self.certain = {
            each.letter: each for each in declared if len(each.trees) == 1 and not each.since
        }
        for line in self.lines:
            links = [(link, self._open(link, line.number)) for link in line.links]
            self.items[line.number] = [(link, names) for link, names in links if names]
        self.definitions = dict(self._definitions())

    # --- letters of the lines

    def _angular(self) -> frozenset[str]:
        """The letters that stand inside a trigonometric function anywhere."""
        return frozenset[str]().union(
            *(
                inside_angles(side)
                for line in self.lines
                for link in line.links
                for claim in link.readings[:1]
                for side in (claim.left, claim.right)
            )
        )

    def meanings(self, number: int) -> dict[str, Expression]:
        """The trees of letters whose declaration is certain, in a line."""
        force: dict[str, Expression] = {}
        for each in sorted(self.declared, key=lambda each: each.since):
            if each.since <= number and len(each.trees) == 1:
                force[each.letter] = each.trees[0]
        return force

    def _open(self, link: Link, number: int) -> frozenset[str]:
        """The letters of a link whose meaning is not certain, those inside meanings included."""
        force = self.meanings(number)
        names: set[str] = set()
        for claim in link.readings:
            for side in (claim.left, claim.right, *claim.others):
                names |= letters(side)
        pending, seen = list(names), set[str]()
        while pending:
            name = pending.pop()
            if name not in seen:
                seen.add(name)
                pending.extend(letters(force[name]) if name in force else ())
        return frozenset(seen - force.keys() - self.around.letters)

    def _definitions(self) -> Iterator[tuple[str, tuple[int, Expression]]]:
        """Letters whose first line gives them a known value."""
        seen: set[str] = set()
        for line in self.lines:
            for link, names in self.items[line.number]:
                fresh = names - seen
                seen |= names
                if len(names) == 1 and fresh and not any(" " in name for name in names):
                    (name,) = names
                    for claim in link.readings[:1]:
                        tree = _defining(claim, name)
                        if tree is not None:
                            yield name, (line.number, tree)

    # --- slots

    def _slot(self, name: str, line: ScriptLine, segment: int) -> Slot | None:
        scope = line.scope
        key = (name, segment, scope if segment or " " in name else ANYWHERE)
        if key not in self.slots:
            self.slots[key] = slot_of(
                name, self._options(name, line, segment), self.around.tester, segment
            )
        return self.slots[key]

    def _options(self, name: str, line: ScriptLine, segment: int) -> list[Candidate]:
        around, scope = self.around, line.scope
        named = [each for each in self.declared if each.letter == name]
        if named:
            latest = [each for each in named if each.since <= line.number] or named
            return list(of_trees(latest[-1].trees))
        phrase = around.phrase(name)
        if phrase:
            return list(of_trees(around.staged(tree, scope) for tree in phrase))
        usage = Usage(name, name in self.angular, scope)
        chosen = list(options(usage, around.candidates, around.problem))
        if name in self.definitions and self.usual(name, scope) is None:
            _, tree = self.definitions[name]
            value = around.tester.value(tree, {}, Frame(None, self.meanings(line.number)))
            if value is not None:
                if name in self.angular and not isinstance(value, Angle) and is_bare(tree):
                    tree = Binary("*", tree, Degrees(Fraction(1)))
                chosen.append(Candidate(tree, "definition", "scalar", cost=0.0))
        return chosen

    def usual(self, name: str, scope: Scope) -> Candidate | None:
        """What a letter or phrase means where no line tells."""
        phrase = self.around.phrase(name)
        if phrase:
            trees_ = [self.around.staged(tree, scope) for tree in phrase[:1]]
            return next(of_trees(trees_))
        usage = Usage(name, name in self.angular, scope)
        return usual(usage, self.around.candidates, self.around.problem, self.around.events)

    # --- searching

    def interpretations(self, breaks: Sequence[_Break]) -> list[Interpretation]:
        """The best interpretations where letters may change their meaning at some lines."""
        places: dict[tuple[str, int], int] = {}
        slots: list[Slot] = []
        firsts: list[tuple[str, ScriptLine]] = []
        items: list[Item] = []
        for line in self.lines:
            segment = sum(each.line <= line.number for each in breaks)
            for link, names in self.items[line.number]:
                used: dict[str, int] = {}
                for name in sorted(names):
                    if (name, segment) not in places:
                        slot = self._slot(name, line, segment)
                        if slot is None:
                            break
                        places[name, segment] = len(slots)
                        slots.append(slot)
                        firsts.append((name, line))
                    used[name] = places[name, segment]
                else:
                    items.append(self._item(link, line, used))
        states = search(self._weighed(items), slots, self.around.tester, self.around.broken)
        cost = {each.line: each.cost for each in breaks}
        return [self._interpretation(state, slots, firsts, cost) for state in states]

    def _item(self, link: Link, line: ScriptLine, used: Mapping[str, int]) -> Item:
        frame = Frame(self.around.world.now(line.scope), self.meanings(line.number))
        count = max(1, len(self.items[line.number]))
        weight = (1.0 if link.readings[0].sign == "=" else _INEQUALITY) / count**0.5
        pair = linear_pair(link.readings[0], sorted(used), self.around.tester, frame)
        return Item(line.number, link.readings, used, weight, link.decimals, frame, pair)

    def _weighed(self, items: Sequence[Item]) -> list[Item]:
        """The items with what each is worth, less where it follows from those above."""
        dependence = Dependence(self.around.tester, self.angular)
        weighed: list[Item] = []
        for item in items:
            names = {name: f"{name} {s}" for name, s in item.slots.items()}
            known = dependence.follows(item.readings[0], names, item.frame)
            factor = _DEPENDENT if known else _MOMENTUM if _is_momentum(item) else 1.0
            weighed.append(replace(item, weight=item.weight * factor))
        return weighed

    def _interpretation(
        self,
        state: State,
        slots: Sequence[Slot],
        firsts: Sequence[tuple[str, ScriptLine]],
        breaks: Mapping[int, float],
    ) -> Interpretation:
        meanings = [
            Meaning(
                each.letter,
                each.trees[0],
                each.words or self._words(each.trees[0]),
                "declared",
                each.scope,
                each.since,
            )
            for each in self.declared
            if len(each.trees) == 1
        ]
        unknown: set[str] = set()
        score = state.score
        for option, slot, (name, line) in zip(state.options, slots, firsts, strict=True):
            since = line.number if slot.segment else 0
            chosen = slot.options[option] if option >= 0 else self.usual(name, line.scope)
            if chosen is None:
                unknown.add(name)
                score -= _UNKNOWN
                continue
            by = self._by(name, chosen, option, line.scope)
            meanings.append(
                Meaning(name, chosen.quantity, self._words(chosen.quantity), by, line.scope, since)
            )
        changed = {m.letter for m in meanings if m.since and m.by == "inferred"}
        if changed and breaks:
            score -= sum(breaks.values())
        known = {meaning.letter for meaning in meanings}
        return Interpretation(tuple(meanings), score, frozenset(unknown - known), self.fixed)

    def _by(self, name: str, chosen: Candidate, option: int, scope: Scope) -> By:
        if any(each.letter == name for each in self.declared) or chosen.kind == "definition":
            return "declared"
        if option < 0 or self.around.phrase(name):
            return "default"
        known = self.usual(name, scope)
        return "default" if known is not None and known.quantity == chosen.quantity else "inferred"

    def _words(self, tree: Expression) -> str:
        return words_of(tree, self.around.problem)

    def breaks(self, found: Sequence[Interpretation]) -> Iterator[tuple[_Break, ...]]:
        """Where letters may begin to mean something else: at headings, and where lines fail."""
        headings: list[int] = []
        for above, below in zip(self.lines, self.lines[1:], strict=False):
            if above.scope != below.scope:
                headings.append(below.number)
        if headings:
            yield tuple(_Break(number, _HEADING) for number in headings)


def _is_momentum(item: Item) -> bool:
    """Whether an item looks like an equation of momentum: its sense is that of the letters."""
    return item.pair is not None and item.pair.sign != 0


def _defining(claim: Claim, name: str) -> Expression | None:
    """The value that a claim gives a letter: ``n = (-3i + 4j)/5``."""
    if claim.sign != "=" or claim.others:
        return None
    for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
        if isinstance(one, Letter) and one.name == name and name not in letters(other):
            return other
    return None
