"""Events that cannot happen: the velocities before them, by which the bodies do not approach.

The story is told up to such an event, which then has a solution. In that the velocities of its two
bodies are written, and a note that they do not come nearer to each other along their line.
"""

from __future__ import annotations

import re
from dataclasses import replace

import sympy as sp

from restitution.errors import ImpossibleError, RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Note, Ref, Relation, Sign
from restitution.explaining.lines.trees import settled
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    Unit,
    walk,
)
from restitution.planning.clashes import scene_without, with_what_is_needed
from restitution.planning.inequalities.claims import Claims
from restitution.planning.routes.order import Solver
from restitution.planning.unfinished import require_followed
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.degrees import share_by_degrees
from restitution.planning.writing.desk import UNPLANNED, Desk, chain, together
from restitution.planning.writing.forms import ZERO, negative, product, tree_of
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.problem import Event, Find, Impact, Part, Problem, Step, Value
from restitution.shapes import Circle
from restitution.solving import solve
from restitution.solving.equations.solution import PartSolution, Solution
from restitution.vector import Vector


def write_unreached(
    solution: Solution, part: PartSolution, desk: Desk, names: list[str]
) -> Desk | None:
    """The desk with the velocities before an event that cannot be, and a note for each item.

    None where no item has such a reason, and where no lines tell that the bodies do not approach.
    """
    errors = [item.error for item in part.items]
    if part.branches or not all(isinstance(error, ImpossibleError) for error in errors):
        return None
    reason = next(error.because or error.message for error in errors if error is not None)
    before = _up_to_it(solution.problem, part.part)
    if before is None:
        return None
    without, own, step, number = before
    if not {step.first, step.second} <= set(re.findall(r"\w+", reason)):
        return None  # it is of something else
    draft = desk.fork()
    try:
        note = _receding(solution.problem, part.part, without, own, draft, step, number, names[0])
    except (*UNPLANNED, RestitutionError):
        return None
    if note is None:
        return None
    for name in names:
        draft.note(
            name, note.kind, reason.partition(":")[0], premises=note.premises, claim=note.claim
        )
    draft.withheld = frozenset()
    return draft


def _up_to_it(problem: Problem, part: Part) -> tuple[Problem, PartSolution, Impact, int] | None:
    """The problem up to the first event that cannot be, solved; with that event and its number."""
    story = [(s, number) for s, number, _ in problem.timeline(part) if isinstance(s, Event)]
    for step, number in reversed(story):
        without = _before(problem, step)
        try:
            own = next(
                other for other in solve(without).parts.values() if other.part.label == part.label
            )
        except (RestitutionError, StopIteration):
            return None
        if len(own.branches) == 1 and isinstance(step, Impact):
            return without, own, step, number
    return None


def _before(problem: Problem, event: Event) -> Problem:
    """A problem without an event and all that comes after it, which asks how a body comes to it."""
    body = event.first if isinstance(event, Impact) else event.body
    asked = Find((Value(Quantity("velocity", (Name(body),))),))
    parts: list[Part] = []
    ended = False
    for part in problem.parts:
        steps: list[Step] = []
        for step in () if ended else part.steps:
            if step is event:
                ended = True
                steps.append(asked)
                break
            steps.append(step)
        parts.append(replace(part, steps=tuple(steps)))
    return replace(problem, parts=tuple(parts))


def _receding(
    problem: Problem,
    part: Part,
    without: Problem,
    own: PartSolution,
    desk: Desk,
    step: Impact,
    number: int,
    name: str,
) -> Note | None:
    """The lines by which two bodies do not approach, and a note with the claim that they do."""
    scene = scene_without(problem, part, without, own, desk, name)
    fact = scene.facts.get(f"axis {number}")
    if fact is None:
        return None
    line = fact.relation.only[0].right
    if isinstance(line, Negate) and isinstance(line.operand, Unit):
        line = line.operand
    sign = _sense(scene, step, number, line)
    if sign is None:
        return None
    velocities = [
        velocity
        for sphere in (step.first, step.second)
        if sphere in scene.model.story.spheres
        for velocity in (settled(Quantity("velocity", (Name(sphere),), number - 1), desk.events),)
        if isinstance(velocity, Quantity)
    ]
    pool: list[Ref] = []
    with Claims(scene, Solver(scene)) as claims:
        for velocity in velocities:
            if not claims.worths.is_data(velocity):
                pool.append(claims.worths.quantity(velocity))
            elif (component := _component(scene, velocity, line, number)) is not None:
                pool.append(component)
            else:
                pool += claims.worths.data_of(velocity)
    if not any(isinstance(ref, int) for ref in pool):
        return None  # nothing would be said but that
    require_true(scene.model, desk.lines, desk.lines, desk.facts)
    require_followed(scene, desk.lines)
    own_letters = {
        node.name
        for ref in pool
        if isinstance(ref, int)
        for tree in (desk.last_link(ref).right,)
        for node in walk(tree)
        if isinstance(node, Letter)
    }
    relative = velocities[0] if len(velocities) == 1 else Binary("-", *velocities)
    claim = Relation(((Link(Quantity("dot", (relative, line)), sign, ZERO),),))
    if isinstance(line, Unit):
        sides: list[Expression] = [Quantity("along", (velocity, line)) for velocity in velocities]
        claim = Relation(((Link(sides[0], sign, sides[1] if len(sides) > 1 else ZERO),),))
    premises = together(pool, background(scene, own_letters))
    note = replace(desk.new_note(name, "impossible"), premises=premises, claim=claim)
    return with_what_is_needed(scene, note) if scene.judge.excludes(note) else None


def _component(scene: Scene, velocity: Quantity, line: Expression, number: int) -> int | None:
    """The component along **i** or **j** of a velocity of the data; None along another line."""
    (body,) = velocity.arguments
    if not isinstance(line, Unit) or not isinstance(body, Name):
        return None
    value = scene.vector(velocity).dot(scene.vector(line))
    own = _by_degrees(scene, body.name, line, value) or tree_of(value)
    component = Quantity("along", (velocity, line))
    relation = chain(component, (own, None), (tree_of(value), "rearrange"))
    move = Move("define", "component", number, (body.name,))
    return scene.judge.write((move,), (f"velocity {body.name}",), relation)


def _by_degrees(scene: Scene, body: str, line: Unit, value: sp.Expr) -> Expression | None:
    """A component along **i** or **j** by the angle of the data: 2 cos 45°; None without one."""
    right = scene.facts[f"velocity {body}"].relation.only[-1].right
    if not isinstance(right, Polar):
        return None
    size = scene.scalar(right.size)
    share = share_by_degrees(tidy(value / size), "cos" if line.axis == "i" else "sin")
    own = None if share is None else product(tree_of(size), share)
    return negative(own) if own is not None and scene.model.sign(value) < 0 else own


def _sense(scene: Scene, step: Impact, number: int, line: Expression) -> Sign | None:
    """The sign of the velocity towards each other along a line, as the bodies are placed on it.

    Bodies that have met on the same line are on the same sides as then. The second of two spheres
    is on the side to which the first moves, a wall where the place of the sphere tells. None where
    that is open.
    """
    model, story = scene.model, scene.model.story
    along = scene.value(line)
    pair = {step.first, step.second}
    met = [
        happening
        for happening in story.happenings
        if isinstance(happening.step, Impact)
        and {happening.step.first, happening.step.second} == pair
    ]
    wall = story.walls.get(step.second)
    if not isinstance(along, Vector) or (wall is not None and isinstance(wall.shape, Circle)):
        return None
    if met:
        (own, before) = model.frames[met[-1].number].n, met[-1].before
        if own.cross(along) != 0:
            return None
        others = before.get(step.second, Vector(sp.Integer(0), sp.Integer(0)))
        towards = (before[step.first] - others).dot(along)
    elif wall is None:
        towards = scene.velocity(step.first, number - 1).dot(along)
    else:
        there = story.place(step.first, number - 1)
        if there is None or not isinstance(wall.shape.point, Expression):
            return None
        towards = (scene.value(wall.shape.point) - there[0]).dot(along)
    sign = model.sign(model.in_data(scene.put(towards)[0]))
    return ">" if sign > 0 else "<" if sign < 0 else None
