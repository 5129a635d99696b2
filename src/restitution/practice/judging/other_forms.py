"""Other forms of a claim that say the same: with sizes, with vectors, with components."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import chain, product

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    Unit,
    is_binary,
    is_component,
    is_function,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.practice.judging.entries import Meanings, is_numeric
from restitution.practice.reading.grammar import is_vector
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Claim
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.world import World
from restitution.problem import Impact
from restitution.vector import Vector

_OBLIQUE = 1e-6
# Letters for a mass, and for a speed, in which a student may count.
_SCALES = "mM", "uUvV"


def same_left(one: Claim, other: Claim) -> bool:
    """Whether two claims are about the same letter or quantity."""
    return one.left == other.left


def kind_of(tree: Expression) -> object:
    """What kind of quantity a tree is, its sign aside."""
    if isinstance(tree, Negate):
        return kind_of(tree.operand)
    if isinstance(tree, Binary) and isinstance(tree.left, Degrees):
        return kind_of(tree.right)
    match tree:
        case Binary("-", Quantity("time"), Quantity("time")):
            return "time"
    return tree.kind.removeprefix("total_") if isinstance(tree, Quantity) else type(tree)


def are_alike(one: Expression, other: Expression) -> bool:
    """Whether two trees are quantities of one kind; so are energies lost, and sizes of vectors."""
    one, other = (tree.argument if is_function(tree, "abs") else tree for tree in (one, other))
    kinds = {kind_of(one), kind_of(other)}
    if kinds == {"deflection", "angle"}:
        return is_turn(one) and is_turn(other)
    return len(kinds) == 1 or kinds == {"energy", "energy_lost"}


def is_turn(tree: Expression) -> bool:
    """Whether a quantity is the angle between two directions of one body."""
    if not isinstance(tree, Quantity):
        return False
    moving = [argument for argument in tree.arguments if isinstance(argument, Quantity)]
    velocities = len(moving) == 2 and all(quantity.kind == "velocity" for quantity in moving)
    one = velocities and moving[0].arguments == moving[1].arguments
    return tree.kind == "deflection" or (tree.kind == "angle" and one)


def of_natures(claim: Claim, meanings: Meanings) -> Iterator[Claim]:
    """A claim with the velocity of a body in place of a component or speed of it, and its speed.

    People use one letter for both: ``v_A = (3, 4)`` beside ``v_A = 5``.
    """
    put: dict[Expression, Expression] = {}
    for side in (claim.left, claim.right):
        for node in walk(side):
            meant = meanings.get(node.name) if isinstance(node, Letter) else None
            if meant is not None and (other := _of_other_nature(meant)) is not None:
                put[node] = other
    single: list[dict[Expression, Expression]] = [{tree: put[tree]} for tree in put]
    for exchange in [put, *(single if len(put) > 1 else [])] if put else []:
        left, right = (exchanged(side, exchange) for side in (claim.left, claim.right))
        yield replace(claim, left=left, right=right)
    # I = -5 so I = -5i: of one letter the component first
    match claim.left:
        case Letter(name) if is_quantity(on := meanings.get(name), "impulse") and on.arguments:
            along = Quantity("along", (on, Quantity("line_of_centres", (), on.stage)))
            yield from (replace(claim, left=tree) for tree in (along, Negate(along)))


def of_known_speeds(claim: Claim, world: World) -> Iterator[Claim]:
    """A claim with a speed of the question for the velocity: ``u = 2√3i - 2j``, ``v = -e u``."""
    if claim.sign != "=" or claim.others:
        return
    names = letters(claim.left) | letters(claim.right)
    for name in sorted(names & world.letters.keys()):
        for body in world.start:
            speed, velocity = (Quantity(x, (Name(body),), 0) for x in ("speed", "velocity"))
            if not np.allclose(world.scalar(speed), world.spread(world.letters[name])):
                continue
            sides = claim.left, claim.right
            left, right = (exchanged(side, {Letter(name): velocity}) for side in sides)
            forms = ((left, claim.right), (claim.left, right), (left, right))
            yield from (Claim(one, "=", other) for one, other in dict.fromkeys(forms))


def is_difference_of_tangents(claim: Claim) -> bool:
    """Whether a side is a sum or a difference of two angles by their tangents."""
    return any(
        is_binary(side, "+", "-")
        and all(is_function(unsigned(part), "arctan") for part in (side.left, side.right))
        for side in (claim.left, claim.right)
    )


def as_vectors(claim: Claim, meanings: Meanings) -> Claim:
    """A claim that equates a letter for a component with a vector, of the velocity in its place."""
    meant = meanings.get(claim.left.name) if isinstance(claim.left, Letter) else None
    whole = None if meant is None else _of_other_nature(meant)
    moving = is_quantity(whole, "velocity")
    if whole is None or not moving or not is_vector(claim.right, frozenset()):
        return claim
    return replace(claim, left=whole)


def has_bars(claim: Claim) -> bool:
    """Whether a letter stands between bars, as that of a vector does: ``|v_A| = 2``."""
    return any(
        is_function(node, "abs") and isinstance(node.argument, Letter)
        for side in (claim.left, claim.right)
        for node in walk(side)
    )


def _of_other_nature(tree: Expression) -> Expression | None:
    match tree:
        case Negate(operand):
            return _of_other_nature(operand)
        case Quantity("along" | "across", (Quantity("velocity", (Name(),)) as whole, _)):
            return whole
        case Quantity("speed", (Name(),) as body, stage):
            return Quantity("velocity", body, stage)
        case Quantity("velocity", (Name(),) as body, stage):
            return Quantity("speed", body, stage)
        case Quantity("impulse", (Name(),), stage):
            return Quantity("impulse", (), stage)
    return None


def is_signed(tree: Expression) -> bool:
    """Whether a quantity has a sense that may be turned."""
    return is_quantity(tree, "along", "across", "direction")


def times_sizes(senses: Sequence[Expression], side: Expression) -> Iterator[Expression]:
    """Components times the size of a direction in a scalar product: ``(4i + 2j).(i - 3j)``."""
    if not is_signed(senses[0]):
        return
    for node in walk(side):
        if is_quantity(node, "dot"):
            for vector in node.arguments:
                for sense in senses:
                    yield Binary("*", Apply("abs", vector), sense)


def times_directions(
    senses: Sequence[Expression], claims: Iterable[Claim], world: World
) -> Iterator[Expression]:
    """Components, and relative velocities, times the size of a direction that lines above name.

    ``approach = 7`` beside ``line of centres -i + 2j`` counts in √5.
    """
    if not any(_is_along(sense) for sense in senses):
        return
    sizes = dict.fromkeys(vector for claim in claims for vector in _directions_in(claim, world))
    for vector in sizes:
        for sense in senses:
            if _is_along(sense):
                yield Binary("*", Apply("abs", vector), sense)


def _is_along(tree: Expression) -> bool:
    inside = unsigned(tree)
    return is_component(inside)


def _directions_in(claim: Claim, world: World) -> Iterator[Expression]:
    """The vectors of a claim, without letters, that are along or across a line of centres."""
    for side in (claim.left, claim.right):
        parts = (node.arguments for node in walk(side) if is_quantity(node, "dot", *COMPONENTS))
        for tree in (side, *chain.from_iterable(parts)):
            if any(isinstance(node, Letter | Name) for node in walk(tree)):
                continue
            try:
                value = world.value(tree)
            except RestitutionError:
                continue
            if isinstance(value, Vector) and any(_is_on(value, c) for c in world.lines.values()):
                yield tree


def _is_on(vector: Vector, axis: Vector) -> bool:
    """Whether a vector is along a line in every sample, or across it."""
    size = np.hypot(vector.x, vector.y)
    return any(
        bool(np.all(np.abs(part) <= _OBLIQUE * size))
        for part in (vector.dot(axis), vector.cross(axis))
    )


def label_in(tree: Expression) -> Letter | None:
    """The phrase that a side is, or has inside as its only letter: ``tan(angle)``."""
    names = {node for node in walk(tree) if isinstance(node, Letter)}
    label = next(iter(names)) if len(names) == 1 else None
    return label if label is not None and is_phrase(label.name) else None


def shares_of_energy(tree: Expression, side: Expression) -> Iterator[Expression]:
    """An energy, or a loss of it, as a share of that before: ``KE lost is 3/4``."""
    if not isinstance(tree, Quantity) or not isinstance(tree.stage, int) or tree.arguments:
        return
    if any(isinstance(node, Letter | Quantity) for node in walk(side)):
        return
    if tree.kind == "total_energy_lost" or (tree.kind == "energy" and tree.stage > 0):
        yield Binary("/", tree, Quantity("energy", (), 0))
    if tree.kind in ("energy", "energy_lost") and tree.stage > 0:
        yield Binary("/", tree, Quantity("energy", (), tree.stage - 1))


def by_energies(tree: Expression, meanings: Meanings) -> Iterator[Expression]:
    """An energy lost, or a ratio with energies, by the energies of which it is made."""
    meant = meanings.get(tree.name, tree) if isinstance(tree, Letter) else tree
    losses: dict[Expression, Expression] = {}
    for node in walk(meant):
        if isinstance(node, Quantity) and not node.arguments and isinstance(node.stage, int):
            starts = {"energy_lost": node.stage - 1, "total_energy_lost": 0}
            if node.kind in starts:
                before = Quantity("energy", (), starts[node.kind])
                losses[node] = Binary("-", before, Quantity("energy", (), node.stage))
    if is_binary(meant, "/"):
        yield meant
    if losses:
        yield exchanged(meant, losses)


def of_sizes(claim: Claim, meanings: Meanings) -> Iterator[Claim]:
    """A claim about a size with its other side turned: momenta subtracted in the other order."""
    if claim.sign != "=" or claim.others:
        return
    if is_impulse(claim.left, meanings):
        yield replace(claim, right=Negate(claim.right))
    elif is_impulse(claim.right, meanings):
        yield replace(claim, left=Negate(claim.left))


def of_vectors(claim: Claim, meanings: Meanings, world: World) -> Iterator[Claim]:
    """A claim about an impulse as that on one of the spheres: ``I = 3(v - u)`` of vectors.

    Its size as well: behind a wrong equation of momentum it is another for each of them.
    """
    if claim.sign != "=" or claim.others or not is_impulse(claim.left, meanings):
        return
    size = meanings.get(claim.left.name) if isinstance(claim.left, Letter) else claim.left
    if not isinstance(size, Quantity) or size.arguments:
        return
    for sphere in world.problem.spheres:
        own = Quantity("impulse", (Name(sphere.name),), size.stage)
        yield from (replace(claim, left=side) for side in (own, Apply("abs", own)))


def without_divisors(claim: Claim, meanings: Meanings, world: World) -> Iterator[Claim]:
    """A claim cleared of a quotient whose divisor is truly zero, if it does not hold so.

    Where nothing moves along a line, ``tan 30 = 3/v`` has no value, and is false all the same.
    """
    if claim.sign != "=" or claim.others:
        return
    for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
        if not is_binary(one, "/"):
            continue
        cleared = replace(claim, left=Binary("*", other, one.right), right=one.left)
        try:
            zero = np.all(np.abs(world.spread(world.scalar(one.right, meanings))) < _OBLIQUE)
            if zero and agrees(cleared, world, meanings, ()) is None:
                yield cleared
        except RestitutionError:
            continue


def by_components(claim: Claim, meanings: Meanings, world: World) -> Iterator[Claim]:
    """A claim about the size of an impulse as the change of one sphere's momentum along its line.

    Whoever takes another component for that along the line has it before the impact as well:
    so the one across stands in its place, in the sense of the right one.
    """
    meant = meanings.get(claim.left.name) if isinstance(claim.left, Letter) else claim.left
    if claim.sign != "=" or not isinstance(meant, Quantity) or not is_impulse(meant, {}):
        return
    number = meant.stage
    step = world.events[number - 1] if isinstance(number, int) else None
    if not isinstance(step, Impact) or not isinstance(number, int):
        return
    line = Quantity("line_of_centres", (), number)
    for name in {step.first, step.second} & world.start.keys():
        body = Name(name)
        after = Quantity("along", (Quantity("velocity", (body,), number), line))
        velocity = Quantity("velocity", (body,), number - 1)
        before = Quantity("along", (velocity, line))
        sense = Binary("/", before, Apply("abs", before))
        across = Apply("abs", Quantity("across", (velocity, line)))
        for taken in (before, Binary("*", across, sense)):
            change = Binary("*", Quantity("mass", (body,)), Binary("-", after, taken))
            yield replace(claim, left=Apply("abs", change))


def of_components(claim: Claim) -> Iterator[Claim]:
    """A claim whose sides are a number and a multiple of i, or of j, without the vector."""
    sides = claim.left, claim.right
    units = [{node for node in walk(side) if isinstance(node, Unit)} for side in sides]
    if claim.others or sorted(map(len, units)) != [0, 1]:
        return
    (unit,) = units[0] | units[1]
    put: dict[Expression, Expression] = {unit: Number(Fraction(1))}
    left, right = (exchanged(side, put) for side in sides)
    if not any(isinstance(node, Quantity | Pair) for side in (left, right) for node in walk(side)):
        yield replace(claim, left=left, right=right)


def lines_of(world: World) -> Iterator[Expression]:
    """The lines of centres of a story; that of a wall is perpendicular to it."""
    for number in world.lines:
        yield Quantity("line_of_centres", (), number)


def is_to_a_line(tree: Expression) -> bool:
    """Whether a quantity is an angle to a line of centres, a wall, i or j."""
    if not is_quantity(tree, "angle"):
        return False
    other = tree.arguments[1]
    other = unsigned(other)
    return isinstance(other, Unit | Name) or is_quantity(other, "line_of_centres")


def is_oblique(axis: Expression, world: World) -> bool:
    """Whether a direction is along neither i nor j."""
    try:
        direction = world.value(axis)
    except RestitutionError:
        return False
    parts = (direction.x, direction.y) if isinstance(direction, Vector) else ()
    return bool(parts) and all(bool(np.all(np.abs(world.spread(x)) > _OBLIQUE)) for x in parts)


def with_across_exchanged(tree: Expression) -> Expression:
    """A quantity in which a speed has what was along the line before in place of that across.

    Who exchanges sine and cosine along the line does so across it.
    """
    put: dict[Expression, Expression] = {}
    for node in walk(tree):
        match node:
            case Quantity("speed", (Name(),) as body, int(stage)) if stage:
                line = Quantity("line_of_centres", (), stage)
                parts = (
                    Quantity("along", (Quantity("velocity", body, when), line))
                    for when in (stage, stage - 1)
                )
                one, other = (Binary("^", part, Number(Fraction(2))) for part in parts)
                put[node] = Apply("sqrt", Binary("+", one, other))
    return exchanged(tree, put)


def is_impulse(tree: Expression, meanings: Meanings) -> bool:
    """Whether a side is the size of an impulse."""
    if isinstance(tree, Letter):
        tree = meanings.get(tree.name, tree)
    if is_function(tree, "abs"):
        return True
    return is_quantity(tree, "impulse") and not tree.arguments


def with_units(claim: Claim, world: World) -> Iterator[Claim]:
    """A claim whose numbers count in letters of the statement: ``lost 2 - 1.56 = 0.444`` in mu².

    Only of what a phrase names, of a square, and of what is worked out: a letter has its value.
    """
    named = isinstance(claim.left, Letter) and is_phrase(claim.left.name)
    squared = is_binary(claim.left, "^")
    data = {node.name for node in walk(claim.left) if isinstance(node, Letter)}
    worked = isinstance(claim.left, Binary) and data <= world.letters.keys()
    if claim.sign != "=" or claim.others or not (named or squared or worked):
        return
    pure = letters(claim.right) <= world.letters.keys() - set("".join(_SCALES))
    if not (is_numeric(claim.right) or (named and pure)):
        return  # the parallel component of u at α is cos α in units of u
    masses, speeds = ((None, *map(Letter, sorted(set(s) & world.letters.keys()))) for s in _SCALES)
    for mass, speed in product(masses, speeds):
        square = Binary("^", speed, Number(Fraction(2))) if speed is not None else None
        for amount in dict.fromkeys((speed, square)):
            factors = [part for part in (mass, amount) if part is not None]
            if factors:
                right = claim.right
                for part in factors:
                    right = Binary("*", right, part)
                yield replace(claim, right=right)


def after_later_events(tree: Expression, last: int) -> Iterator[Expression]:
    """A quantity after one event as it is after each later one, up to the ``last``."""
    stages = {
        node.stage
        for node in walk(tree)
        if isinstance(node, Quantity) and isinstance(node.stage, int)
    }
    for now in stages if len(stages) == 1 else ():
        for later in range(now + 1, last + 1):
            yield _moved(tree, now, later)


def after_earlier_event(tree: Expression, event: int) -> Expression | None:
    """A quantity after a later event as it is after this one; None for what is not later."""
    stages = {node.stage for node in walk(tree) if isinstance(node, Quantity)}
    later = {stage for stage in stages if isinstance(stage, int) and stage > event}
    return _moved(tree, later.pop(), event) if len(later) == 1 else None


def _moved(tree: Expression, now: int, then: int) -> Expression:
    """A quantity with what it takes after one event taken after another."""

    def put(node: Expression) -> Expression:
        match node:
            case Quantity(kind, arguments, stage) if stage == now:
                return Quantity(kind, arguments, then)
        return node

    return rebuilt(tree, put)
