"""Back to the first point of a circular wall by two others: what the angles make together.

A chord that makes the angle φ with the radii at its ends spans 180° − 2φ at the centre, and three
chords that close span 360°. So the three angles make 90°. The tangent of each is that of the one
before it over the coefficient of restitution between.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    COMPONENTS,
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    has_quantity,
)
from restitution.planning.formulas.impacts import after, in_direction
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.circles import chord_from, circle_of, from_centre
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import (
    ONE,
    in_tangents,
    product,
    swept,
    tree_of,
)
from restitution.planning.writing.place_trees import place_tree
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.problem import Arrival, Event, Impact
from restitution.records import dataclass
from restitution.vector import Vector


@dataclass(frozen=True)
class Round:
    """That three chords close, as an equation of a route."""

    number: int
    body: str
    hits: tuple[int, int]
    candidate: Candidate
    place: Ref
    """What says where the third chord ends."""


def rounds(scene: Scene) -> Iterator[Round]:
    """The ways round a circular wall that close, and in which something unknown stands."""
    for number in range(3, scene.events + 1):
        step = scene.model.happening(number).step
        end = _end(scene, number, step)
        if end is None:
            continue
        body, place, ref = end
        own = [n for n in range(1, number) if body in scene.bodies(n)]
        if len(own) != 2 or [chord_from(scene, body, n) for n in own] != [0, own[0]]:
            continue
        start = scene.value(place_tree(body, 0))
        if not all(map(scene.model.identically_zero, place - start)):
            continue
        first, second = own
        radius_vector, velocity = from_centre(scene, first, start), scene.velocity(body, 0)
        e, f = (scene.coefficient(n).value for n in own)
        t = radius_vector.cross(velocity) / radius_vector.dot(velocity)
        residual = tidy(t**2 * (1 + e + e * f) - e**2 * f)
        if scene.unknown(residual):
            candidate = Candidate(f"round {number}", 3.0, (residual,))
            yield Round(number, body, (first, second), candidate, ref)


def _end(scene: Scene, number: int, step: Event) -> tuple[str, Vector, Ref] | None:
    """Who comes to which place at an event, where the statement tells that, and what says so."""
    if isinstance(step, Arrival):
        return step.body, scene.value(place_tree(step.body, number)), f"contact {number}"
    if not isinstance(step, Impact) or circle_of(scene, number) is None:
        return None
    for equation in scene.given:
        link = equation.link
        if link.left == Quantity("position", (Name(step.first),), number) and link.sign == "=":
            if has_quantity(link.right) or scene.unknown(scene.value(link.right)):
                return None
            return step.first, scene.value(link.right), equation.fact.id
    return None


def write_round(scene: Scene, own: Round) -> int:
    """The equation of the tangents, and its number."""
    first, second = own.hits
    ends = [(0, first), (first, first), (second, second)]
    angles: list[Letter] = []
    tangents: dict[Expression, tuple[sp.Expr, int]] = {}
    premises: list[Ref] = [*(f"contact {n}" for n in own.hits), own.place]
    premises.append(f"position {own.body}")
    meanings: list[Ref] = []
    pool: list[Ref] = []
    for stage, event in ends:
        frame = scene.frame(event)
        along, across = (
            after(scene, kind, own.body, frame)
            if stage
            else in_direction(scene, kind, own.body, 0, frame)
            for kind in COMPONENTS
        )
        velocity = Quantity("velocity", (Name(own.body),), stage)
        angle = Quantity("angle", (velocity, Quantity("line_of_centres", (), event)))
        letter, meaning = letter_of(scene, angle)
        premises.append(meaning)
        worth, line = _tangent(scene, event, own.body, letter, meaning, along, across)
        same = _same_angle(scene, line, letter, worth)
        if same is None:
            angles.append(Letter(letter))
            tangents[Apply("tan", angles[-1])] = worth, line
            meanings.append(meaning)
        else:
            other, number = same
            angles.append(other)
            premises.append(number)
            pool.append(f"acute: {other.name}")
    a, b, c = angles
    is_one = len({*angles}) == 1
    relation = chain(Binary("+", a, b), (Binary("-", RIGHT_ANGLE, c), None))
    if is_one:
        span = Binary("-", STRAIGHT_ANGLE, product(tree_of(2), a))
        whole = Degrees(Fraction(360))
        relation = chain(product(tree_of(len(angles)), span), (whole, None))
    move = move_of(own)
    closing = scene.desk.write(move, together(premises), relation)
    if all(scene.coefficient(n).value == 1 for n in own.hits):
        _hide_components(scene, closing)
    if is_one:
        simple = chain(product(tree_of(len(angles)), a), (RIGHT_ANGLE, None))
        return scene.desk.write(Move("rearrange"), (closing,), simple)
    x, y, z = (Apply("tan", angle) for angle in angles)
    quotient = Binary("/", Binary("+", x, y), Binary("-", ONE, product(x, y)))
    relation = chain(quotient, (Binary("/", ONE, z), None))
    move = Move("identity", "sum-of-angles")
    refs = scene.judge.enough(move, (closing,), relation, [*meanings, *pool])
    if refs is None:
        raise NotPlannedError("the tangent of a sum")
    line = scene.desk.write(move, refs, relation)
    values: dict[Expression, Expression] = {
        key: tree_of(worth) for key, (worth, _) in tangents.items()
    }
    right = tree_of(in_tangents(tidy(1 / tangents[z][0]))) if z in tangents else Binary("/", ONE, z)
    put = chain(swept(exchanged(quotient, values)), (right, None))
    names = {value.name for value in scene.unknown(own.candidate.residuals[0])}
    known = [*(number for _, number in tangents.values()), *background(scene, names)]
    kept = scene.judge.enough(Move("put"), (line,), put, known)
    if kept is None:
        raise NotPlannedError("the tangents of angles round a circle")
    return scene.desk.write(Move("put"), kept, put)


def _hide_components(scene: Scene, closing: int) -> None:
    """Where nothing is lost the angle with the radius stays, and no reader needs its components."""
    lines = scene.desk.lines
    for ref in scene.desk.under(closing):
        if (
            isinstance(ref, int)
            and ref != closing
            and isinstance(lines[ref - 1].relation, Relation)
        ):
            lines[ref - 1] = replace(lines[ref - 1], shown="silent")


def _same_angle(
    scene: Scene, line: int, letter: str, tangent: sp.Expr
) -> tuple[Letter, int] | None:
    """The letter whose tangent an angle has, and the line that they are equal; None without one."""
    match in_tangents(tangent):
        case sp.tan(args=(sp.Symbol() as symbol,)):
            other = Letter(symbol.name)
        case _:
            return None
    relation = chain(Letter(letter), (other, None))
    pool = [f"0° <= {letter} <= 90°", f"acute: {other.name}"]
    refs = scene.judge.enough(Move("inverse"), (line,), relation, pool)
    if refs is None:
        return None
    lines = scene.desk.lines
    for number in scene.desk.introducing({letter}):
        lines[number - 1] = replace(scene.desk.line(number), shown="silent")
    return other, scene.desk.write(Move("inverse"), refs, relation, "silent")


def _tangent(
    scene: Scene,
    event: int,
    body: str,
    letter: str,
    meaning: Ref,
    along: Source,
    across: Source,
) -> tuple[sp.Expr, int]:
    """The tangent of the angle with a radius: its value, and its line."""
    values, refs = [], [meaning]
    for source in (across, along):
        value, more = scene.put(source.value)
        if scene.model.sign(scene.model.in_data(value)) < 0:
            value = -value
        values.append(value)
        refs += [*source.whole, *more]
    worth = in_tangents(tidy(sp.sympify(values[0] / values[1], strict=True)))
    right = swept(Binary("/", *map(tree_of, values)))
    number = scene.desk.write(
        Move("define", "tan", event, (body,)),
        together(refs),
        chain(Apply("tan", Letter(letter)), (right, None), (tree_of(worth), "rearrange")),
        # The angle is that of the data, with which the components are written.
        "silent" if isinstance(worth, sp.tan) and worth.args[0].is_Symbol else "line",
    )
    return worth, number


def move_of(own: Round) -> Move:
    """The definition that the equation of a round is."""
    return Move("define", "round", own.number, (own.body,))


__all__ = ["Round", "move_of", "rounds", "write_round"]
