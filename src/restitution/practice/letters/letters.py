"""What the letters and phrases of a script mean, and which of them have to be asked.

In order: letters of the statement; what the student declares; what a letter usually means; and
what makes most lines true (`inference`). A letter has one meaning in a scope. A new declaration or
a heading opens one, and outside it the meaning holds on.
"""

from __future__ import annotations

from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import cached_property
from itertools import pairwise, permutations

from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    is_binary,
    is_quantity,
    unsigned,
)
from restitution.practice.judgement import By, Meaning
from restitution.practice.letters.candidates import Candidate, kinds_of
from restitution.practice.letters.dependence import Dependence, Relation
from restitution.practice.letters.inference import (
    Item,
    State,
    is_of_difference,
    linear_pair,
    search,
)
from restitution.practice.letters.interpretation import FixedLetter, Interpretation, Interpretations
from restitution.practice.letters.letters_of_lines import LettersOfLines
from restitution.practice.letters.named_vectors import (
    NamedComponent,
    named_components,
)
from restitution.practice.letters.options import (
    Usage,
    directions,
    elsewhen,
    is_angle_to_a_wall,
    is_direction,
    is_impulse,
    multiples,
    of_trees,
    options,
    scaled,
)
from restitution.practice.letters.slots import Slot, slot_of
from restitution.practice.letters.surroundings import (
    DeclaredLetter,
    Surroundings,
    all_fixed,
    declarations,
    letters_of,
)
from restitution.practice.letters.trial import Frame
from restitution.practice.letters.wordings import words_of
from restitution.practice.reading.phrase_names import (
    is_phrase,
    is_relative,
    names_distance,
)
from restitution.practice.script import ANYWHERE, Claim, Link, Scope, Script, ScriptLine
from restitution.practice.worlds.arrays import is_bare
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.world import World
from restitution.problem import Problem
from restitution.records import dataclass
from restitution.solving.equations.solution import Solution

# Meanings that explain a script nearly as well as the best are kept.
NEARLY = 0.7
_RIVALS = 24
_INEQUALITY = 0.25
_HEADING, _BREAK, _ALONE = 0.2, 0.5, 1.05
# What it costs that a letter means nothing which its first line may define.
_UNKNOWN = 0.2
# What it costs where it stands in two equations like those of the laws beside one with a meaning.
_UNPAIRED = 0.4
# What a line tells that follows from those above or contradicts them, and one of momentum, which
# tells the sense of its letters as well.
_WORTH = {"new": 1.0, "follows": 0.3, "contradicts": 0.6}
_MOMENTUM = 1.8
# What a vector tells in which the value of a letter stands again: of the value of its component,
# and of the component itself, as the components of two spheres may be equal.
_SHOWN, _NAMED = 0.6, 4.0
_PLACES = 5
# What it costs that a letter for times is one of the student's own where a time is asked.
_OWN_TIME = 0.3
_LAST = 10**6
_PERPENDICULAR = frozenset(("perp", "perpendicular", "perpendicularly", "across"))
_ALONG = frozenset(("along", "parallel", "par", "loc", "centres", "centers"))


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
    fixed = all_fixed(own, letters_of(problem, solution.parts[part].part))
    if worlds is None or fixed:
        worlds = true_worlds(solution, part, fixed)
    interpretations: list[Interpretation] = []
    for world in worlds[:4]:
        surroundings = Surroundings(problem, solution.parts[part].part, world)
        interpretations += _interpretations(own, surroundings, declared or {})
    if not interpretations:
        return Interpretations(Interpretation())
    interpretations.sort(key=lambda interpretation: -interpretation.score)
    best = interpretations[0]
    rivals = [
        interpretation
        for interpretation in interpretations[1:]
        if interpretation.score >= best.score - NEARLY
    ]
    return Interpretations(best, tuple(_distinct(best, rivals))[:_RIVALS])


def _distinct(best: Interpretation, rivals: Iterable[Interpretation]) -> Iterator[Interpretation]:
    """Rivals once each, before others those in which a letter has a meaning that is new."""
    seen, known = {_signature(best)}, set(_signature(best))
    late: list[Interpretation] = []
    for interpretation in rivals:
        signature = _signature(interpretation)
        if signature in seen:
            continue
        seen.add(signature)
        if signature <= known:
            late.append(interpretation)
        else:
            known |= signature
            yield interpretation
    yield from late


def _signature(interpretation: Interpretation) -> frozenset[Hashable]:
    return frozenset((m.letter, m.quantity, m.since) for m in interpretation.meanings)


# --- one world ------------------------------------------------------------------------------------


def _interpretations(
    script: Script, around: Surroundings, declared: Mapping[str, Expression | Sequence[Expression]]
) -> list[Interpretation]:
    search_ = _Search(script, around, *declarations(script, around, declared))
    interpretations = search_.interpretations(())
    if search_.headings:
        interpretations += search_.interpretations(search_.headings)
    else:
        interpretations += search_.reused()
    interpretations.sort(key=lambda interpretation: -interpretation.score)
    return [
        interpretation
        for interpretation in interpretations
        if interpretation.score >= interpretations[0].score - NEARLY
    ]


@dataclass(frozen=True)
class _Break:
    """A line from which letters may have another meaning.

    ``cost`` is what that costs, ``alone`` where only one line says so.
    """

    line: int
    cost: float
    alone: float


class _Search(LettersOfLines):
    """The interpretations of a script in one world."""

    def __init__(
        self,
        script: Script,
        around: Surroundings,
        declared: Sequence[DeclaredLetter],
        fixed: Sequence[FixedLetter],
    ) -> None:
        super().__init__(script, around, declared)
        self.fixed = tuple(fixed)
        self.slots: dict[tuple[str, int, Scope], Slot | None] = {}
        self.phrases = {
            name
            for links in self.items.values()
            for _, names in links
            for name in names
            if " " in name
        }
        self.directions = around.directions(self.lines)
        self.multipliers = around.multipliers(self.lines)
        self.failing: set[int] = set()
        self.relations: dict[tuple[int, tuple[Claim, ...]], Relation] = {}
        self.paired: dict[str, dict[str, set[int]]] = {}
        self.separations: dict[int, frozenset[str]] = {}

    def _slot(self, name: str, line: ScriptLine, segment: int) -> Slot | None:
        scope = line.scope
        key = (name, segment, scope if segment or " " in name else ANYWHERE)
        if key not in self.slots and segment and scope == ANYWHERE:
            first = self._slot(name, line, 0)
            self.slots[key] = None if first is None else replace(first, segment=segment)
        elif key not in self.slots:
            self.slots[key] = slot_of(
                name,
                self._options(name, line, segment),
                self.around.tester,
                segment,
                may_vanish=name in self.vanishing and not is_impulse(name),
            )
        return self.slots[key]

    def _options(self, name: str, line: ScriptLine, segment: int) -> list[Candidate]:
        around, scope = self.around, line.scope
        named = [letter for letter in self.declared if letter.letter == name]
        if named:
            latest = [letter for letter in named if letter.since <= line.number] or named
            return list(of_trees(latest[-1].trees))
        phrase = around.phrase(name, scope.event)
        if phrase:
            own = self.staged(name, self._other_way(name, phrase), scope)
            last = around.world.now()
            stages = range(last + 1) if scope.event is None else (scope.event - 1, scope.event)
            if scope.event is None and any(
                is_angle_to_a_wall(tree, around.problem) for tree in own
            ):
                stages = range(
                    around.world.first_stage, last + 1
                )  # what is before is another part's
            other = () if is_relative(name) else elsewhen(name, own, stages)
            every = [*map(self._in_its_sense, of_trees(own)), *other]
            return [*every, *scaled(every, self.directions)]
        if is_phrase(name) and names_distance(name):
            return []
        dotted = name in self.dotted
        usage = Usage(name, name in self.angular, scope, name in self.defined, dotted)
        if dotted and is_direction(name):
            return list(directions(around.problem, around.events, name))
        chosen = list(options(usage, around.candidates, around.problem))
        components = self._components(name)
        chosen = [
            replace(candidate, cost=candidate.cost - _NAMED)
            if candidate.quantity in components
            else candidate
            for candidate in chosen
        ]
        known = {candidate.quantity for candidate in chosen}
        multiples_ = [
            component
            for component in components
            if component not in known and _is_multiple(component)
        ]
        chosen += [Candidate(tree, "component", "scalar", cost=-_NAMED) for tree in multiples_]
        if name in self.turned_speeds:
            chosen = [candidate for candidate in chosen if not around.is_a_part(candidate)]
        if self._points(name):
            chosen = [candidate for candidate in chosen if candidate.nature == "vector"]
        chosen += list(scaled(chosen, self.directions))
        if name in self.multipliers:
            chosen += multiples(around.candidates, self.multipliers[name], around.problem)
        if name in self.definitions and self.usual(name, scope) is None:
            _, tree = self.definitions[name]
            value = around.tester.value(tree, {}, Frame(None, self.meanings(line.number)))
            if value is not None:
                if name in self.angular and not isinstance(value, Angle) and is_bare(tree):
                    tree = Binary("*", tree, Degrees(Fraction(1)))
                start = around.of_the_start(value)
                if not start and self._is_velocity(name):
                    return chosen
                cost = _OWN_TIME if around.asks_time and name[:1] in "tT" else 0.0
                chosen.append(Candidate(tree, "definition", "scalar", start=start, cost=cost))
        return chosen

    def _in_its_sense(self, candidate: Candidate) -> Candidate:
        """A candidate of words; an impulse as a vector that is asked for has its sense."""
        asked = candidate.nature == "vector" and candidate.quantity in self.around.asked
        return replace(candidate, asked=True) if asked else candidate

    def _other_way(self, name: str, trees: Sequence[Expression]) -> Sequence[Expression]:
        """The meanings of *perp* that are not along the line, in a script that names both ways."""
        words = set(name.split())
        others = [set(phrase.split()) for phrase in self.phrases if phrase != name]
        if self.around.problem.walls or not words & _PERPENDICULAR or words & _ALONG:
            return trees
        if not any(phrase & _ALONG and not phrase & _PERPENDICULAR for phrase in others):
            return trees
        across = [tree for tree in trees if not _is_along_the_line(tree)]
        return across or trees

    def interpretations(self, breaks: Sequence[_Break]) -> list[Interpretation]:
        """The best interpretations where letters may change their meaning at some lines."""
        places: dict[tuple[str, int], int] = {}
        slots: list[Slot] = []
        firsts: list[tuple[str, ScriptLine]] = []
        items: list[Item] = []
        for line in self.lines:
            segment = sum(cut.line <= line.number for cut in breaks)
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
        items = self._weighed(items)
        typed = len(items)
        for component in self.named:
            segment = sum(one.line <= component.line.number for one in breaks)
            if (component.letter, segment) in places:
                items.append(self._shown(component, places[component.letter, segment]))
        states = search(items, slots, self.around.tester, self.around.broken)
        interpretations = []
        for state in states[: 2 * _RIVALS]:
            lines = {item.line for k, item in enumerate(items[:typed]) if k in state.satisfied}
            whole = self._interpretation(state, slots, firsts)
            interpretations.append(
                replace(whole, score=whole.score - self._cost(whole, breaks, lines))
            )
        if interpretations:
            best = max(range(len(interpretations)), key=lambda k: interpretations[k].score)
            held = states[best].satisfied
            self.failing = {item.line for k, item in enumerate(items[:typed]) if k not in held}
        return interpretations

    @cached_property
    def named(self) -> tuple[NamedComponent, ...]:
        """The letters that are shown to be components by vectors with their values."""
        around = self.around
        known = around.problem, around.tester, self.usual, self._is_own
        return tuple(named_components(self.lines, *known))

    def _components(self, name: str) -> list[Expression]:
        """The components that vectors show a letter to be."""
        own = (component for component in self.named if component.letter == name)
        return [self.around.staged(component.component, component.line.scope) for component in own]

    def _is_own(self, name: str) -> bool:
        """Whether a name is a letter of the student's own."""
        return not is_phrase(name) and name not in self.around.letters

    def _shown(self, named: NamedComponent, slot: int) -> Item:
        """What a vector with the value of a letter in it tells of the letter."""
        frame = Frame(self.around.world.now(named.line.scope))
        component = self.around.staged(named.component, named.line.scope)
        claim = Claim(Letter(named.letter), "=", component)
        used = {named.letter: slot}
        line = named.line.number
        return Item(line, (claim,), used, _SHOWN, (), frame, fresh=False, shown=True)

    def _cost(self, whole: Interpretation, breaks: Sequence[_Break], lines: Iterable[int]) -> float:
        """The cost of letters that change their meanings, less where several lines support it."""
        changed = [m.since for m in whole.meanings if m.since and m.by == "inferred"]
        cost = 0.0
        ends = [*(later.line for later in breaks[1:]), _LAST]
        for cut, end in zip(breaks, ends, strict=False):
            if any(since >= cut.line for since in changed):
                several = sum(cut.line <= number < end for number in lines) > 1
                cost += cut.cost if several else cut.alone
        return cost

    def _item(self, link: Link, line: ScriptLine, used: Mapping[str, int]) -> Item:
        frame = Frame(self.around.world.now(line.scope), self.meanings(line.number))
        count = max(1, len(self.items[line.number]))
        weight = (1.0 if link.readings[0].sign == "=" else _INEQUALITY) / count**0.5
        claim, tester = link.readings[0], self.around.tester
        pair = linear_pair(claim, sorted(used), tester, frame)
        for one, other in permutations(pair.names if pair is not None else (), 2):
            self.paired.setdefault(one, {}).setdefault(other, set()).add(line.number)
        if pair is not None and is_of_difference(claim, pair.names, tester, frame):
            self.separations[line.number] = frozenset(pair.names)
        return Item(line.number, link.readings, used, weight, link.decimals, frame, pair)

    def _weighed(self, items: Sequence[Item]) -> list[Item]:
        """The items with what each is worth, less where it follows from those above.

        What a line is worth does not change with the scopes that its letters are given. Equations
        of momentum come before all others: a value above them may be wrong.
        """
        dependence = Dependence(self.around.tester, self.angular)
        for item in sorted(items, key=lambda item: not _is_momentum(item)):
            key = item.line, item.readings
            if key not in self.relations:
                names = {name: f"{name} 0" for name in item.slots}
                self.relations[key] = dependence.relation(item.readings[0], names, item.frame)
        weighed: list[Item] = []
        for item in items:
            relation = self.relations[item.line, item.readings]
            factor = _WORTH[relation]
            if relation == "new" and _is_momentum(item):
                factor = _MOMENTUM
            fresh = relation == "new"
            weighed.append(replace(item, weight=item.weight * factor, fresh=fresh))
        return weighed

    def _interpretation(
        self,
        state: State,
        slots: Sequence[Slot],
        firsts: Sequence[tuple[str, ScriptLine]],
    ) -> Interpretation:
        meanings = [
            Meaning(
                letter.letter,
                letter.trees[0],
                letter.words or self._words(letter.trees[0]),
                "declared",
                letter.scope,
                letter.since,
            )
            for letter in self.declared
            if len(letter.trees) == 1
        ]
        unknown: set[str] = set()
        other_shape = any(
            option >= 0
            and name in self.shapes
            and slot.options[option].quantity not in (self.shapes[name], Negate(self.shapes[name]))
            for option, slot, (name, _) in zip(state.options, slots, firsts, strict=True)
        )
        score = state.score
        for option, slot, (name, line) in zip(state.options, slots, firsts, strict=True):
            since = line.number if slot.segment else 0
            if option >= 0 or any(letter.letter == name for letter in self.declared):
                chosen: Candidate | None = slot.options[max(option, 0)]
            else:
                chosen = self.usual(name, line.scope)
                if name in self.shapes and other_shape:
                    chosen = None  # lines tell that the shapes mislead
            if chosen is None:
                unknown.add(name)
                score -= _UNKNOWN if name in self.definitions else 0.0
                continue
            by = self._by(name, chosen, option, line.scope)
            meanings.append(
                Meaning(name, chosen.quantity, self._words(chosen.quantity), by, line.scope, since)
            )
        known = {meaning.letter for meaning in meanings}
        for name in unknown - known:
            beside = self.paired.get(name, {})
            if any(len(lines) > 1 for other, lines in beside.items() if other in known):
                score -= _UNPAIRED
        return Interpretation(tuple(meanings), score, frozenset(unknown - known), self.fixed)

    def _by(self, name: str, chosen: Candidate, option: int, scope: Scope) -> By:
        if any(letter.letter == name for letter in self.declared):
            return "declared"
        if option < 0 or self.around.phrase(name):
            return "default"
        if chosen.kind == "definition":
            return "declared"
        known = self.usual(name, scope)
        usual = known is not None and known.quantity == chosen.quantity
        return "default" if usual or chosen.quantity in self._components(name) else "inferred"

    def _words(self, tree: Expression) -> str:
        return words_of(tree, self.around.problem)

    @cached_property
    def headings(self) -> tuple[_Break, ...]:
        """Where a heading opens a scope."""
        return tuple(
            _Break(below.number, _HEADING, _HEADING)
            for above, below in pairwise(self.lines)
            if above.scope != below.scope
        )

    def reused(self) -> list[Interpretation]:
        """The interpretations where letters come again with another meaning, at one line or two."""
        breaks = tuple(_Break(number, _HEADING, _HEADING) for number in self.becoming_vectors())
        interpretations = self.interpretations(breaks) if breaks else []
        for _ in range(2):
            if not self.failing or len(self.around.events) < 2:
                break
            tried: list[tuple[float, _Break, set[int]]] = []
            for number in self._places()[:_PLACES]:
                if all(number != cut.line for cut in breaks):
                    one = _Break(number, _BREAK, _ALONE)
                    new = self.interpretations(sorted((*breaks, one), key=lambda b: b.line))
                    interpretations += new
                    score = max((interpretation.score for interpretation in new), default=0.0)
                    tried.append((score, one, set(self.failing)))
            if not tried:
                break
            _, one, self.failing = max(tried, key=lambda entry: entry[0])
            breaks = (*breaks, one)
        return interpretations

    def _places(self) -> list[int]:
        """The lines, the failing first, at which letters from above come again."""
        seen: set[str] = set()
        places: list[int] = []
        above = 0
        for line in self.lines:
            names = {name for _, letters in self.items[line.number] for name in letters}
            if names & seen and not self._belong_together(above, line.number):
                places.append(line.number)
            seen |= names
            above = line.number
        return sorted(places, key=lambda number: (number not in self.failing, number))

    def _belong_together(self, above: int, number: int) -> bool:
        """Whether a line is of restitution in the two letters of the momentum in that above."""
        names = self.separations.get(number, frozenset())
        if len(names) != 2 or above in self.separations:
            return False
        one, other = sorted(names)
        return above in self.paired.get(one, {}).get(other, set())


def _is_momentum(item: Item) -> bool:
    """Whether an item looks like an equation of momentum: its sense is that of the letters."""
    if item.pair is None or not item.pair.sign:
        return False
    return all("component" in kinds_of(name, False) for name in item.pair.names)


def _is_multiple(tree: Expression) -> bool:
    """Whether a component is told as a multiple of a speed: the x of ``v = x u i``."""
    inner = unsigned(tree)
    return is_binary(inner, "/")


def _is_along_the_line(tree: Expression) -> bool:
    """Whether a quantity is the component along a line of centres of two spheres."""
    inner = unsigned(tree)
    return is_quantity(inner, "along") and is_quantity(inner.arguments[1], "line_of_centres")
