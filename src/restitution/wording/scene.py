"""What a wording has to know of the whole statement: its bodies, its events, and *now*."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Stage,
    Unit,
    has_quantity,
    letters,
    walk,
)
from restitution.problem import (
    Aligned,
    Arrival,
    Compare,
    Event,
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
    Wall,
)
from restitution.wording.question import Named, Words
from restitution.wording.units import Scale, scale_of
from restitution.wording.values import point
from restitution.wording.words import ordinal, words

_PLACED = frozenset(("position", "distance", "time"))


@dataclass(frozen=True)
class Scene:
    """A statement, and how many of its events are told so far."""

    problem: Problem
    events: tuple[Event, ...]
    scale: Scale
    places: bool
    oriented: bool
    now: int = 0

    def at(self, now: int) -> Scene:
        """The scene when so many events are told."""
        return replace(self, now=now)

    def stage(self, stage: Stage, body: str | None) -> int:
        """The number of the event after which a quantity is meant; before the first, 0."""
        if isinstance(stage, int):
            return stage
        if stage == "before":
            for number in range(self.now, 0, -1):
                if body in bodies_of(self.events[number - 1]):
                    return number - 1
            return 0
        return self.now

    def wall(self, name: str) -> Wall | None:
        """The wall of that name."""
        return next((each for each in self.problem.walls if each.name == name), None)

    def is_wall(self, name: str) -> bool:
        """Whether the name is a wall's."""
        return self.wall(name) is not None

    def timed(self) -> bool:
        """Whether time is counted from the start, and not from the first impact."""
        return any(each.position is not None for each in self.problem.spheres)


def scene_of(problem: Problem) -> Scene:
    """The scene of a statement of which nothing is told yet."""
    events = tuple(
        step for _, step in problem.steps() if isinstance(step, Impact | Kick | Arrival)
    )
    return Scene(problem, events, scale_of(problem), _placed(problem), _oriented(problem))


def bodies_of(event: Event) -> tuple[str, ...]:
    """The names of the bodies of an event."""
    return (event.first, event.second) if isinstance(event, Impact) else (event.body,)


# --- what the statement speaks of ---------------------------------------------------------------


def expressions(problem: Problem) -> Iterator[Expression]:
    """Every expression of a statement."""
    for sphere in problem.spheres:
        yield from _trees(sphere.mass, sphere.velocity, sphere.position, sphere.radius)
    for wall in problem.walls:
        yield from _trees(
            wall.along, wall.through, wall.start, wall.end, wall.centre, wall.radius
        )
    for point in problem.points:
        yield from _trees(point.position)
    for _, step in problem.steps():
        yield from expressions_of_step(step)


def _trees(*values: object) -> Iterator[Expression]:
    yield from (each for each in values if isinstance(each, Expression))


def expressions_of_step(step: Step) -> Iterator[Expression]:
    """Every expression of a step."""
    match step:
        case Impact():
            yield from _trees(step.e, step.along, step.offset)
        case Kick():
            yield step.impulse
        case Arrival():
            yield step.target
        case Let():
            yield step.expression
        case Given(relations):
            for relation in relations:
                yield from expressions_of_relation(relation)
        case Find(items):
            for item in items:
                yield from expressions_of_item(item)
        case Show(relation, subject):
            yield from expressions_of_relation(relation)
            if subject is not None:
                yield from expressions_of_item(subject)


def expressions_of_relation(relation: Relation) -> Iterator[Expression]:
    """Every expression of a relation."""
    if isinstance(relation, Compare):
        yield from relation.operands
    elif isinstance(relation, Aligned):
        yield from (relation.left, relation.right)


def expressions_of_item(item: Item) -> Iterator[Expression]:
    """Every expression of an item."""
    yield item.expression
    if isinstance(item, Extremum):
        yield item.over


def is_letter_fact(relation: Relation) -> bool:
    """Whether a relation is about letters alone: tan α = 3/4."""
    return isinstance(relation, Compare) and not any(
        has_quantity(each) for each in relation.operands
    )


def letters_of(*values: object) -> frozenset[str]:
    """The letters of those values that are expressions."""
    return frozenset().union(*(letters(each) for each in values if isinstance(each, Expression)))


def _placed(problem: Problem) -> bool:
    """Whether it matters where things are, so that a size not told is negligible."""
    if any(each.position is not None for each in problem.spheres):
        return True
    quantities = (node for tree in expressions(problem) for node in walk(tree))
    return any(isinstance(node, Quantity) and node.kind in _PLACED for node in quantities)


def _oriented(problem: Problem) -> bool:
    """Whether mirror images of the statement would have other answers.

    With one wall and a sphere that comes to it at some angle, and no vector asked for, they
    have not: then nobody need be told from which side the sphere comes.
    """
    if len(problem.walls) != 1 or len(problem.spheres) != 1 or problem.points:
        return True
    (sphere,), (wall,) = problem.spheres, problem.walls
    if sphere.position is not None or wall.along is None:
        return True
    if not (isinstance(sphere.velocity, Polar) and sphere.velocity.wall is not None):
        return True
    return any(
        _speaks_of_a_vector(tree) for _, step in problem.steps() for tree in expressions_of_step(step)
    )


def _speaks_of_a_vector(tree: Expression) -> bool:
    match tree:
        case Unit() | Pair() | Polar():
            return True
        case Quantity("angle", arguments):
            return any(
                _speaks_of_a_vector(each)
                for each in arguments
                if not (isinstance(each, Quantity) and each.kind in ("velocity", "line_of_centres"))
            )
        case Quantity(kind, arguments):
            sized = kind in ("impulse", "energy", "speed", "deflection", "mass")
            return not (
                (sized and (kind != "impulse" or not arguments))
                or kind in ("energy_lost", "total_energy_lost")
            )
    return any(
        _speaks_of_a_vector(each)
        for node in (tree,)
        for each in _inside(node)
    )


def _inside(tree: Expression) -> tuple[Expression, ...]:
    match tree:
        case Negate(operand):
            return (operand,)
        case Binary(_, left, right):
            return (left, right)
        case Apply(_, argument):
            return (argument,)
    return ()


# --- the names of events and moments --------------------------------------------------------------


def event_name(scene: Scene, number: int) -> Words:
    """``the impact``, ``the second impact``, ``the collision between A and B``."""
    event = scene.events[number - 1]
    match event:
        case Impact():
            return _impact_name(scene, number, event)
        case Kick(body):
            same = [n for n, each in enumerate(scene.events, 1) if isinstance(each, Kick)]
            if len(same) == 1:
                return ("the impulse",)
            if len({each.body for each in scene.events if isinstance(each, Kick)}) == len(same):
                return words("the impulse on ", Named(body))
            return (f"the {ordinal(same.index(number) + 1)} impulse",)
        case Arrival(body, target):
            return words("the arrival of ", Named(body), " at ", point(target))


def _impact_name(scene: Scene, number: int, event: Impact) -> Words:
    impacts = [n for n, each in enumerate(scene.events, 1) if isinstance(each, Impact)]
    wall = scene.is_wall(event.second)
    noun = "impact" if wall else "collision"
    if len(impacts) == 1:
        return (f"the {noun}",)
    pairs = {n: frozenset(bodies_of(scene.events[n - 1])) for n in impacts}
    alike = [n for n in impacts if pairs[n] == pairs[number]]
    if len(alike) == len(impacts):
        return (f"the {ordinal(impacts.index(number) + 1)} {noun}",)
    which = "" if len(alike) == 1 else f"{ordinal(alike.index(number) + 1)} "
    if not wall:
        between = sorted((event.first, event.second))
        return words(f"the {which}collision between ", Named(between[0]), " and ", Named(between[1]))
    if len(scene.problem.spheres) == 1:
        return words(f"the {which}impact with ", Named(event.second))
    return words(f"the {which}impact of ", Named(event.first), " with ", Named(event.second))


def happening(scene: Scene, number: int) -> Words:
    """What happens in an event, as a clause: ``P hits W``."""
    match scene.events[number - 1]:
        case Impact(first, second):
            verb = " hits " if scene.is_wall(second) else " collides with "
            pair = {first, second}
            before = sum(
                isinstance(each, Impact) and {each.first, each.second} == pair
                for each in scene.events[: number - 1]
            )
            total = sum(
                isinstance(each, Impact) and {each.first, each.second} == pair
                for each in scene.events
            )
            time = f" for the {ordinal(before + 1)} time" if total > 1 else ""
            return words(Named(first), verb, Named(second), time)
        case Kick(body):
            return words(Named(body), " receives ", event_name(scene, number))
        case Arrival(body, target):
            return words(Named(body), " reaches ", point(target))


def after(scene: Scene, number: int) -> Words:
    """``immediately after the impact``; before the first event ``initially`` or the like."""
    if number == 0:
        return before(scene)
    if isinstance(scene.events[number - 1], Arrival):
        return words("when ", happening(scene, number))
    return words("immediately after ", event_name(scene, number))


def before(scene: Scene) -> Words:
    """The moment at which the velocities that are given hold."""
    if scene.timed() or len(scene.events) != 1 or isinstance(scene.events[0], Arrival):
        return ("initially",)
    return words("immediately before ", event_name(scene, 1))


def just_before(scene: Scene, body: str | None) -> Words:
    """The moment before the latest event of a body."""
    for number in range(scene.now, 0, -1):
        event = scene.events[number - 1]
        if body in bodies_of(event) and not isinstance(event, Arrival):
            return words("immediately before ", event_name(scene, number))
    return before(scene)


def instant(scene: Scene, number: int) -> Words:
    """The moment of an event: ``when P hits W``."""
    return ("initially",) if number == 0 else words("when ", happening(scene, number))


def name_of(tree: Expression) -> str | None:
    """The name that an expression is, if it is one."""
    return tree.name if isinstance(tree, Name) else None
