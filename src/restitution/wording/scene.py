"""What a wording has to know of the whole statement: its bodies, its events, and *now*."""

from __future__ import annotations

from dataclasses import field, replace

from restitution.counting import ordinal
from restitution.expression.quantities import ENERGIES, PLACED
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Pair,
    Polar,
    Quantity,
    Stage,
    Unit,
    children,
    has_quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.problem import (
    Aligned,
    Arrival,
    Compare,
    Event,
    Find,
    Given,
    Impact,
    Kick,
    Let,
    Point,
    Problem,
    Relation,
    Show,
    Sphere,
    Step,
    Unknown,
    Wall,
    bodies_of,
    trees,
    trees_of_relation,
    trees_of_step,
)
from restitution.records import dataclass
from restitution.wording.structure import Emphasis, Words
from restitution.wording.units import Style, style_of
from restitution.wording.values import point
from restitution.wording.words import words

INITIALLY: Words = ("initially",)
# Quantities without a direction.
_SIZES = ENERGIES | {"speed", "deflection", "mass"}


@dataclass(frozen=True)
class Scene:
    """A statement, and how many of its events are told so far.

    ``letters`` are those of the statement and its names; ``denoted`` are the letters that the
    wording itself has given to quantities, by their words, and grows; so does ``lettered``, by the
    speeds with the number of the event after which they are meant, and by times.
    """

    problem: Problem
    events: tuple[Event, ...]
    style: Style
    places: bool
    oriented: bool
    letters: frozenset[str]
    now: int = 0
    denoted: dict[Words, str] = field(default_factory=dict, compare=False, repr=False)
    lettered: dict[Quantity | Binary, str] = field(default_factory=dict, compare=False, repr=False)

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
        return next((wall for wall in self.problem.walls if wall.name == name), None)

    def is_wall(self, name: str) -> bool:
        """Whether the name is a wall's."""
        return self.wall(name) is not None

    def timed(self) -> bool:
        """Whether time is counted from the start, and not from the first impact."""
        return any(sphere.position is not None for sphere in self.problem.spheres)


def scene_of(problem: Problem) -> Scene:
    """The scene of a statement of which nothing is told yet."""
    style, placed = style_of(problem), _placed(problem)
    oriented = _oriented(problem, style)
    return Scene(problem, problem.events, style, placed, oriented, _taken(problem))


def _taken(problem: Problem) -> frozenset[str]:
    """The letters of a statement, and the names of its bodies."""
    taken = {"e", "i", "j"}
    for tree in trees(problem):
        taken |= letters(tree)
    for _, step in problem.steps():
        if isinstance(step, Let):
            taken.add(step.letter)
        elif isinstance(step, Unknown):
            taken |= set(step.letters)
        elif isinstance(step, Find | Show):
            taken |= set(step.in_terms_of or ())
    bodies: tuple[Sphere | Wall | Point, ...]
    bodies = (*problem.spheres, *problem.walls, *problem.points)
    return frozenset(taken | {body.name for body in bodies})


# --- what matters ---------------------------------------------------------------------------------


def is_letter_fact(relation: Relation) -> bool:
    """Whether a relation is about letters alone: tan α = 3/4."""
    return isinstance(relation, Compare) and not any(map(has_quantity, relation.operands))


def _placed(problem: Problem) -> bool:
    """Whether it matters where things are, so that a size not told is negligible."""
    if any(sphere.position is not None for sphere in problem.spheres):
        return True
    nodes = (node for tree in trees(problem) for node in walk(tree))
    return any(isinstance(node, Quantity) and node.kind in PLACED for node in nodes)


def _oriented(problem: Problem, style: Style) -> bool:
    """Whether the statement turned round or mirrored would have other answers.

    With a sphere that comes to a wall at some angle, or to the first of two that are parallel or
    perpendicular, and no vector asked for, it has not: then nobody need be told how a wall alone
    runs, and from which side the sphere comes.
    """
    if len(problem.walls) not in (1, 2) or len(problem.spheres) != 1 or problem.points:
        return True
    (sphere,) = problem.spheres
    if sphere.position is not None or any(
        not isinstance(wall.along, Unit) or wall.through is not None for wall in problem.walls
    ):
        return True
    if not (isinstance(sphere.velocity, Polar) and _wall_of(problem, style, sphere.velocity)):
        return True
    return speaks_of_axes(problem)


def wall_before(scene: Scene, velocity: Polar) -> str | None:
    """The wall to which a velocity at the start is at an acute angle, if that says all of it."""
    return None if scene.oriented else _wall_of(scene.problem, scene.style, velocity)


def _wall_of(problem: Problem, style: Style, velocity: Polar) -> str | None:
    """The wall that a velocity names, or that is hit first, parallel to where its angle begins."""
    if isinstance(velocity.wall, Name):
        return velocity.wall.name
    first = next(iter(problem.events), None)
    wall = next(
        (wall for wall in problem.walls if isinstance(first, Impact) and wall.name == first.second),
        None,
    )
    origin = Unit("i") if velocity.origin is None else velocity.origin
    if isinstance(origin, Negate):
        origin = origin.operand
    match velocity.angle:
        case Letter(name):
            acute = name in style.acute
        case Degrees(size):
            acute = 0 < size < 90
        case _:
            acute = False
    return wall.name if wall is not None and acute and wall.along == origin else None


def is_mirrored(scene: Scene) -> bool:
    """Whether a collision of spheres on parallel lines, mirrored, would have the same answers."""
    alone = len(scene.events) == 1 and not (scene.problem.walls or scene.problem.points)
    return alone and not scene.places and not speaks_of_axes(scene.problem)


def speaks_of_axes(problem: Problem) -> bool:
    """Whether a statement speaks of vectors besides the velocities at the start."""
    return any(_of_axes(step) for _, step in problem.steps())


def _of_axes(step: Step) -> bool:
    """Whether a step speaks of a vector, and not only of its angles with other things."""
    relations: list[Relation] = []
    if isinstance(step, Given):
        relations = list(step.relations)
    elif isinstance(step, Show) and step.subject is None:
        relations = [step.relation]
    aligned = {
        id(tree)
        for relation in relations
        if isinstance(relation, Aligned)
        for tree in trees_of_relation(relation)
    }
    return any(
        _is_vector_side(tree) if id(tree) in aligned else _speaks_of_a_vector(tree)
        for tree in trees_of_step(step)
    )


def _is_vector_side(tree: Expression) -> bool:
    """Whether the side of an angle is a vector given by itself."""
    moving = is_quantity(tree, "velocity", "line_of_centres")
    return not (moving or isinstance(tree, Name))


def _speaks_of_a_vector(tree: Expression) -> bool:
    match tree:
        case Unit() | Pair() | Polar():
            return True
        case Quantity("angle", arguments):
            return any(map(_is_vector_side, arguments))
        case Quantity("impulse", arguments):
            return bool(arguments)
        case Quantity(kind):
            return kind not in _SIZES
    return any(map(_speaks_of_a_vector, children(tree)))


# --- the names of events and moments --------------------------------------------------------------


def event_name(scene: Scene, number: int) -> Words:
    """``the impact``, ``the second impact``, ``the collision between A and B``."""
    event = scene.events[number - 1]
    match event:
        case Impact():
            return _impact_name(scene, number, event)
        case Kick(body):
            same = [n for n, event in enumerate(scene.events, 1) if isinstance(event, Kick)]
            if len(same) == 1:
                return ("the impulse",)
            if len({event.body for event in scene.events if isinstance(event, Kick)}) == len(same):
                return words("the impulse on ", Emphasis(body))
            return (f"the {ordinal(same.index(number) + 1)} impulse",)
        case Arrival(body, target):
            return words("the arrival of ", Emphasis(body), " at ", point(target))


def _impact_name(scene: Scene, number: int, event: Impact) -> Words:
    impacts = [n for n, event in enumerate(scene.events, 1) if isinstance(event, Impact)]
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
        return words(
            f"the {which}collision between ", Emphasis(between[0]), " and ", Emphasis(between[1])
        )
    if len(scene.problem.spheres) == 1:
        return words(f"the {which}impact with ", Emphasis(event.second))
    return words(f"the {which}impact of ", Emphasis(event.first), " with ", Emphasis(event.second))


def happening(scene: Scene, number: int, subject: str | None = None) -> Words:
    """What happens in an event, as a clause: ``P hits W``; of a body spoken of, ``it hits W``."""
    match scene.events[number - 1]:
        case Impact(first, second):
            verb = " hits " if scene.is_wall(second) else " collides with "
            pair = {first, second}
            before = sum(
                isinstance(event, Impact) and {event.first, event.second} == pair
                for event in scene.events[: number - 1]
            )
            total = sum(
                isinstance(event, Impact) and {event.first, event.second} == pair
                for event in scene.events
            )
            time = f" for the {ordinal(before + 1)} time" if total > 1 else ""
            return words(_spoken(first, subject), verb, Emphasis(second), time)
        case Kick(body):
            name = event_name(scene, number)
            impulse = "the impulse" if len(name) > 1 else name
            return words(_spoken(body, subject), " receives ", impulse)
        case Arrival(body, target):
            return words(_spoken(body, subject), " reaches ", point(target))


def _spoken(body: str, subject: str | None) -> Words:
    return ("it",) if body == subject else (Emphasis(body),)


def after(scene: Scene, number: int, body: str | None = None) -> Words:
    """``immediately after the impact``; before the first event ``initially`` or the like.

    Where there is one sphere only, it need not be named twice: ``when it reaches N``.
    """
    if number == 0:
        return before(scene)
    if isinstance(scene.events[number - 1], Arrival):
        subject = body if len(scene.problem.spheres) == 1 else None
        return words("when ", happening(scene, number, subject))
    return words("immediately after ", event_name(scene, number))


def before(scene: Scene) -> Words:
    """The moment at which the velocities that are given hold."""
    if scene.timed() or len(scene.events) != 1 or isinstance(scene.events[0], Arrival):
        return INITIALLY
    return words("immediately before ", event_name(scene, 1))


def just_before(scene: Scene, body: str | None) -> Words:
    """The moment before the latest event of a body."""
    for number in range(scene.now, 0, -1):
        event = scene.events[number - 1]
        if body in bodies_of(event) and not isinstance(event, Arrival):
            return words("immediately before ", event_name(scene, number))
    return before(scene)


def instant(scene: Scene, number: int, subject: str | None = None) -> Words:
    """The moment of an event: ``when P hits W``; of a body spoken of, ``when it hits W``."""
    return INITIALLY if number == 0 else words("when ", happening(scene, number, subject))


def leading(when: Words) -> Words:
    """A moment in front of its clause, which may begin with a name as the moment ends."""
    return words(when, ", ") if isinstance(when[-1], Emphasis) else words(when, " ")
