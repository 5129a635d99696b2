"""Which law a line uses: the smallest set of laws on which it holds, in random states."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import combinations
from math import gcd
from typing import TypeGuard

import numpy as np

from restitution.expression.evaluate import Angle, Value
from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import (
    COMPONENTS,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    children,
    is_binary,
    is_quantity,
    letters,
    quantities_in,
    unsigned,
    walk,
)
from restitution.practice.judgement import Use
from restitution.practice.script import ANYWHERE, Claim, Decimal, Scope
from restitution.practice.worlds.agreement import NOT, grades
from restitution.practice.worlds.arrays import Array, is_bare
from restitution.practice.worlds.results import altered_results
from restitution.practice.worlds.states import Block, States, states
from restitution.practice.worlds.student import lawful_world
from restitution.practice.worlds.telling import NO_MEANINGS, Meanings, Telling
from restitution.practice.worlds.terms import (
    coefficient_put_in,
    component_put_in,
    impulse_put_in,
    is_triangle,
    law_put_in,
)
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given, Impact
from restitution.vector import Vector

_ANGLES = frozenset({"angle", "direction"})
Laws = tuple[tuple[str, tuple[str, ...]], ...]
_OF_JOURNEYS = ("time", "position", "distance")
_NO_VALUES = frozenset({"arithmetic", "component", "fact", "value"})
_RESOLVED = frozenset({"arithmetic", "component"})
_OPEN_NAMES = frozenset({"none", "solve", "fact", "arithmetic", "component"})
_RESULTS = ("impulse", "energy", "deflection")


def uses_of(
    claim: Claim,
    world: World,
    meanings: Meanings = NO_MEANINGS,
    decimals: Sequence[Decimal] = (),
    scope: Scope = ANYWHERE,
    *,
    altered: bool = False,
) -> tuple[Use, ...]:
    """The laws of which a line is an instance; first its principle, then laws that it needs.

    ``value`` is among them where the line gives a quantity its value and no more: first of all
    where that takes several laws.

    The world is the true one, or the student's own. With ``altered``, a line that holds under no
    right law has a use for each altered law, or else altered result, of which it is an instance. An
    inequality, and a line that holds nowhere, has none. Raises UnvaluedError where a side has no
    value.
    """
    if claim.sign != "=" or claim.others:
        return ()
    trial = _Trial(claim, states(world), meanings, decimals, scope)
    uses = _put_in(trial, claim, world, meanings, scope) or trial.uses()
    if uses or not altered:
        return uses
    tried = states(world, altered=True)
    how = (claim, tried, meanings, decimals, scope)
    return (
        altered_results(*how, loose=True)
        or _Trial(*how).altered()
        or altered_results(*how, loose=False)
    )


def _put_in(
    trial: _Trial, claim: Claim, world: World, meanings: Meanings, scope: Scope
) -> tuple[Use, ...]:
    """The law of a line that has numbers in place of some components; none if it is plainer."""
    uses = trial.uses()
    first = uses[0].principle if uses else "none"
    if not trial.true or any(is_quantity(x, *_OF_JOURNEYS) for x in trial.quantities):
        return ()  # a time is no component, whatever its number
    divided = impulse_put_in(claim, world)
    if divided is not None:
        return (divided,)
    # 8 - 2k = -1/4 × 8: with a multiple of the impulse in it, and restitution all the same.
    of_impulse = first == "impulse" and not trial.is_value
    if first in _RESOLVED or of_impulse:
        product = coefficient_put_in(claim, world, meanings, scope)
        if product is not None:
            return (product,)
        kept = component_put_in(claim, world, scope) if trial.plain else None
        if kept is not None:
            return (kept,)
    if trial.plain or not (first in _OPEN_NAMES or (first == "speed" and len(uses) > 1)):
        return ()
    if uses and is_triangle(claim, world, meanings, scope):
        return (Use("angle", uses[0].event, uses[0].bodies), *uses[1:])
    if letters(claim.left) | letters(claim.right) == {"e"} and not trial.is_value:
        product = coefficient_put_in(claim, world, meanings, scope)
        if product is not None:
            return (product,)
    law = law_put_in(claim, trial.states, meanings, scope, exact=trial.exact)
    return () if law is None or trial.is_value else (law,)


class _Trial:
    """A line tried on all random states of a world."""

    def __init__(
        self,
        claim: Claim,
        tried: States,
        meanings: Meanings,
        decimals: Sequence[Decimal],
        scope: Scope,
    ) -> None:
        self.states, self.world = tried, tried.world
        self.quantities = tuple(_quantities(claim, self.world, meanings))
        self.now = self.world.now(scope)
        self.plain = not self.quantities and _is_arithmetic(claim, meanings)
        self.uses_letters = bool(_letters_of(claim, meanings))
        self.line = (claim, meanings, decimals, scope)
        self.is_value = _is_value(claim, self.world, meanings)
        grades = self.grades_in(self.world)
        self.sides = [
            _size(self.world, self.world.value(side, meanings, scope))
            for side in (claim.left, claim.right)
        ]
        self.exact = bool((grades[: tried.rows] == 0).all())
        self.true = bool((grades[: tried.rows] < NOT).all())
        self.holding = tried.holding(grades < NOT)

    def grades_in(self, world: World) -> Array:
        """How exactly the line holds in the samples of a world."""
        claim, meanings, decimals, scope = self.line
        return grades(claim, world, meanings, decimals, scope)

    def uses(self) -> tuple[Use, ...]:
        """The laws of the latest event on which the line depends."""
        uses = self._laws_used()
        if not self.is_value or not uses or uses[0].principle in _NO_VALUES:
            return uses
        value = Use("value", uses[0].event, uses[0].bodies)
        if uses[0].principle == "solve":
            return (value, *uses[1:])
        return (*uses, value)

    def _laws_used(self) -> tuple[Use, ...]:
        if self.plain:
            return (Use("arithmetic"),)
        for number in sorted({block.event for block in self.states.blocks}, reverse=True):
            lawful = self._blocks(number)
            if lawful and not lawful[0].laws and self._holds(lawful[0]):
                continue
            best = next((block for block in lawful if self._holds(block)), None)
            if best is None:
                if self._fact(number):
                    return (Use(self._fact_name(number), number),)
                continue
            return self._named(self._across(lawful) or best)
        if self.true and self._loose_everywhere():
            uses = self._of_determined_letters()
            if uses:
                return uses
            return (Use(self._definition(), self._event(), self._bodies(None)),)
        return (Use("fact"),) if self.true else ()

    def _across(self, lawful: Sequence[Block]) -> Block | None:
        """The states in which nothing but the components across stays, if a line holds there.

        A sum of momenta across the line of centres is no equation of momentum.
        """
        every = max((block.laws for block in lawful), key=len)
        kept = tuple(law for law in every if law[0] == "unchanged")
        own = next((block for block in lawful if block.laws == kept and len(kept) > 1), None)
        return own if own is not None and self._holds(own) else None

    def altered(self) -> tuple[Use, ...]:
        """The altered laws of which the line is an instance, of the latest event that has some."""
        by_event: dict[int, list[Use]] = {}
        for block, holds in zip(self.states.blocks, self.holding, strict=True):
            if holds and block.variant is not None and block.law and self._is_of_size(block):
                law = block.law
                use = Use(law.law, block.event, law.bodies, block.variant.id)
                by_event.setdefault(block.event, []).append(use)
        return tuple(dict.fromkeys(by_event[max(by_event)])) if by_event else ()

    def _is_of_size(self, block: Block) -> bool:
        """Whether the sides are not just both zero under a law, where neither is in the world."""
        rows = self.states.rows
        start = (self.states.places[id(block)] + 1) * rows
        here = [float(side[:rows].max()) for side in self.sides]
        there = [float(side[start : start + rows].max()) for side in self.sides]
        return min(here) <= 1e-9 * max(here) or max(there) > 1e-6 * max(here)

    def _blocks(self, number: int) -> list[Block]:
        return [
            block
            for block in self.states.blocks
            if block.event == number and block.variant is None and not block.given
        ]

    def _holds(self, block: Block) -> bool:
        return bool(self.holding[self.states.places[id(block)]])

    def _fact(self, number: int) -> bool:
        return any(
            holds and block.given and block.event == number
            for block, holds in zip(self.states.blocks, self.holding, strict=True)
        )

    def _fact_name(self, number: int) -> str:
        """``impulse`` for its definition where the impulse is given, ``energy`` for squares where
        an energy is; else ``fact``.
        """
        problem, part = self.states.base.problem, self.states.base.part
        given = [
            {node.kind for tree in relation.operands for node in walk(tree) if _is_quantity(node)}
            for step, now, _ in problem.timeline(part)
            if isinstance(step, Given) and now >= number
            for relation in step.relations
            if isinstance(relation, Compare)
        ]
        moving = [kinds for kinds in given if kinds]
        impulsive = bool(moving) and all(kinds == {"impulse"} for kinds in moving)
        if not self.is_value and any(kinds & ENERGIES for kinds in moving) and self._has_squares():
            return "energy"
        return "impulse" if impulsive and not self.is_value else "fact"

    def _has_squares(self) -> bool:
        """Whether something is squared on a side of the line, as speeds are in energies."""
        claim = self.line[0]
        return any(is_binary(x, "^") for side in (claim.left, claim.right) for x in walk(side))

    def _loose_everywhere(self) -> bool:
        return all(
            holds
            for block, holds in zip(self.states.blocks, self.holding, strict=True)
            if not block.laws and block.variant is None and not block.given
        )

    # --- names --------------------------------------------------------------------------------

    def _named(self, best: Block) -> tuple[Use, ...]:
        laws = best.laws if len(best.laws) == 1 else self._without_idle_laws(best)
        if len(laws) > 1 and self.true:
            if self._fact(best.event):
                uses = _uses_at(laws, best.event)
                name = self._fact_name(best.event)
                return (Use(name, best.event, self._bodies(best.event)), *uses)
            own = self._with_facts(best.event, laws)
            if own and len(own) < len(laws):
                # The facts of the question stand in it in place of the other laws.
                uses = self._uses_of(best.event, own)
                fact = Use(self._fact_name(best.event), best.event)
                return uses if uses[0].principle in _RESULTS else (*uses, fact)
            laws = own
        return self._uses_of(best.event, laws)

    def _uses_of(self, event: int, laws: Laws) -> tuple[Use, ...]:
        """The principle of a line that is an instance of some laws, and these."""
        uses = _uses_at(laws, event)
        name = self._principle(event, laws)
        if [name] == [use.principle for use in uses]:
            return uses
        return (Use(name, event, self._bodies(event)), *uses)

    def _of_determined_letters(self) -> tuple[Use, ...]:
        """The laws that determine the unknown letters of a line."""
        claim, meanings, _, _ = self.line
        if not _letters_of(claim, meanings) & self.states.base.determined:
            return ()
        for number in sorted({block.event for block in self.states.blocks}, reverse=True):
            every = max((block.laws for block in self._blocks(number)), key=len, default=())
            kept = self._with_facts(number, every)
            if kept:
                name = kept[0][0] if len(kept) == 1 else "solve"
                own = (Use("solve", number),) if name == "solve" else ()
                return (*own, *_uses_at(kept, number))
        return ()

    def _with_facts(self, event: int, laws: Laws) -> Laws:
        """The laws that a line needs beside the facts, where the facts determine letters.

        A value that a fact and one law give does not rest on another law with a letter in it that
        is still to be found.
        """
        world = self.states.base
        unknown = frozenset(name for name in world.determined if name[:2] != "_k")
        if not unknown:
            return laws
        every = max((block.laws for block in self._blocks(event)), key=len)
        for count in range(len(laws)):
            for kept in combinations(every, count):
                if not self._rests_on(event, kept, unknown):
                    continue
                return kept
        return laws

    def _rests_on(self, event: int, kept: Laws, unknown: frozenset[str]) -> bool:
        """Whether the line holds under some laws of an event, all other laws, and the facts."""
        base = self.states.base
        key = ("lawful", event, kept)
        if key not in base._known:
            others = (
                (law, block.event, bodies)
                for block in self.states.blocks
                if block.variant is None and block.event != event
                for law, bodies in block.laws
            )
            laws = {*others, *((law, event, bodies) for law, bodies in kept)}
            with np.errstate(all="ignore"):
                base._known[key] = lawful_world(base, laws, unknown)
        world = base._known[key]
        return world is not None and bool((self.grades_in(world) < NOT).all())

    def _without_idle_laws(self, best: Block) -> Laws:
        """The laws without conservation of components that are zero."""
        telling = Telling(self.world, degrees=False)
        line = self.world.lines.get(best.event)
        if line is None:
            return best.laws

        def moves(name: str) -> bool:
            across = self.world.spread(telling.velocity(name, best.event - 1).cross(line))
            return bool(np.any(np.abs(across[: self.states.rows]) > 1e-9))

        kept = tuple(
            (law, bodies) for law, bodies in best.laws if law != "unchanged" or moves(bodies[0])
        )
        return kept or (() if self._fact(best.event) else best.laws)

    def _principle(self, event: int, laws: Laws) -> str:
        kinds = self._kinds(event)
        names = {law for law, _ in laws}
        result = next((name for name in _RESULTS if name in kinds), None)
        if result is not None:
            return result
        if names == {"impulse"} and len(kinds) == 1 and kinds <= {"speed", "angle"}:
            return next(iter(kinds))
        if names == {"unchanged"}:
            if "component" in kinds and len(kinds & {"speed", "angle"}) == 1:
                return "speed" if "speed" in kinds else "angle"
            return "unchanged"
        if not laws:
            return self._fact_name(event)
        if len(laws) == 1:
            return laws[0][0]
        if kinds == {"speed"} or (kinds == {"angle"} and not self.uses_letters):
            return next(iter(kinds))
        return "solve"

    def _definition(self) -> str:
        kinds = self._kinds(0)
        for name in (*_RESULTS, "angle", "speed"):
            if name in kinds:
                return name
        return "component" if self.quantities else "arithmetic"

    def _kinds(self, event: int) -> set[str]:
        """The kinds of quantities in a line, at an event and after it."""
        return {
            kind
            for quantity in self.quantities
            if (kind := _kind(quantity)) in _RESULTS or self._stage(quantity) >= event
            if kind is not None
        }

    def _stage(self, tree: Quantity) -> int:
        """After which event a quantity is meant; of a component, the velocity in it."""
        inside = list(quantities_in(tree))
        stages = [
            self.now
            if quantity.stage is None
            else quantity.stage
            if isinstance(quantity.stage, int)
            else 0
            for quantity in inside
            if quantity.kind not in ("along", "across", "angle", "dot", "line_of_centres", "mass")
        ]
        return max(stages, default=0)

    def _event(self) -> int | None:
        stages = [self._stage(quantity) for quantity in self.quantities]
        return max(stages, default=0) or None

    def _bodies(self, event: int | None) -> tuple[str, ...]:
        """The spheres that a line names, in the order of the event."""
        named = {
            node.name
            for quantity in self.quantities
            for node in walk(quantity)
            if isinstance(node, Name) and node.name in self.world.start
        }
        step = self.world.events[event - 1] if event else None
        if isinstance(step, Impact):
            own = (step.first, step.second)
            return tuple(name for name in own if name in named)
        return tuple(sorted(named))


def _uses_at(laws: Laws, event: int) -> tuple[Use, ...]:
    return tuple(Use(law, event, bodies) for law, bodies in laws)


def _size(world: World, value: Value) -> Array:
    """The sizes of a value in the samples."""
    if isinstance(value, Vector):
        return world.spread(np.hypot(value.x, value.y))
    number = value.measure() if isinstance(value, Angle) else value
    return np.abs(world.spread(number))


def _is_quantity(node: Expression) -> TypeGuard[Quantity]:
    return isinstance(node, Quantity)


# --- what a line speaks of ------------------------------------------------------------------------


def _kind(tree: Quantity) -> str | None:
    if tree.kind in ENERGIES:
        return "energy"
    if tree.kind in _ANGLES:
        return "angle"
    if tree.kind in COMPONENTS:
        return "component"
    known = ("impulse", "deflection", "speed", "velocity")
    return tree.kind if tree.kind in known else None


def _quantities(claim: Claim, world: World, meanings: Meanings) -> Iterator[Quantity]:
    """The quantities of a line, outermost ones alone, with its letters put into words."""
    for side in (claim.left, claim.right):
        yield from _outermost(side, world, meanings, frozenset())


def _outermost(
    tree: Expression, world: World, meanings: Meanings, opened: frozenset[str]
) -> Iterator[Quantity]:
    if isinstance(tree, Quantity):
        if tree.kind == "dot":
            for argument in tree.arguments:
                yield from _outermost(argument, world, meanings, opened)
        else:
            yield tree
        return
    if isinstance(tree, Letter):
        if tree.name not in opened:
            yield from _of_letter(tree.name, world, meanings, opened | {tree.name})
        return
    for node in children(tree):
        yield from _outermost(node, world, meanings, opened)


def _of_letter(
    name: str, world: World, meanings: Meanings, opened: frozenset[str]
) -> Iterator[Quantity]:
    if name in meanings:
        yield from _outermost(meanings[name], world, meanings, opened)
    elif name in world.lets:
        yield from _outermost(world.lets[name][0].expression, world, meanings, opened)


def _is_arithmetic(claim: Claim, meanings: Meanings) -> bool:
    """Whether a line has no letters, but for those of known vectors: ``n = (3i + 4j)/5``."""
    return all(
        node.name in meanings and not any(isinstance(x, Letter) for x in walk(meanings[node.name]))
        for side in (claim.left, claim.right)
        for node in walk(side)
        if isinstance(node, Letter)
    )


def _letters_of(claim: Claim, meanings: Meanings) -> frozenset[str]:
    """The letters of the statement in a line."""
    return frozenset(
        node.name
        for side in (claim.left, claim.right)
        for node in walk(side)
        if isinstance(node, Letter) and node.name not in meanings
    )


def _is_value(claim: Claim, world: World, meanings: Meanings) -> bool:
    """Whether a line gives one quantity, or one letter to be found, its value and no more."""
    for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
        lone = unsigned(one)
        named = isinstance(lone, Quantity) or (
            isinstance(lone, Letter) and (lone.name in meanings or lone.name in world.determined)
        )
        spoken = Claim(other, "=", other)
        if named and not any(_quantities(spoken, world, meanings)):
            return not _letters_of(spoken, meanings) & world.determined and not is_worked(other)
    return False


def is_worked(tree: Expression) -> bool:
    """Whether there is a calculation in a side: a sum of numbers or of like terms, a product of
    two numbers, or a quotient that is not in its lowest terms.
    """
    return any(isinstance(node, Binary) and _is_worked_out(node) for node in walk(tree))


def _is_worked_out(node: Binary) -> bool:
    sides = node.left, node.right
    match node.op:
        case "+" | "-":
            one, other = map(_letters_in_product, sides)
            return all(map(is_bare, sides)) or (one is not None and one == other and bool(one))
        case "*":
            return all(map(_is_plain, sides))
        case "/":
            above, below = map(_number_of, sides)
            if above is None or below is None:
                return False
            whole = above.denominator == below.denominator == 1
            return not whole or gcd(above.numerator, below.numerator) > 1
    return False


def _number_of(tree: Expression) -> Fraction | None:
    return tree.value if isinstance(tree, Number) else None


def _letters_in_product(tree: Expression) -> tuple[str, ...] | None:
    """The letters of a product of numbers and letters, in order; None for anything else."""
    match tree:
        case Letter(name):
            return (name,)
        case Negate(operand):
            return _letters_in_product(operand)
        case Binary("*", left, right):
            one, other = _letters_in_product(left), _letters_in_product(right)
            return None if one is None or other is None else tuple(sorted((*one, *other)))
        case Binary("/", left, right) if is_bare(right):
            return _letters_in_product(left)
    return () if is_bare(tree) else None


def _is_plain(tree: Expression) -> bool:
    return isinstance(tree, Number) or (
        is_binary(tree, "/") and is_bare(tree) and not is_worked(tree)
    )
