"""How directions stand to each other, to be shown: by components, or one as a multiple."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.explaining.data.facts import links_of
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, numbers_in
from restitution.expression.tree import (
    COMPONENTS,
    Expression,
    Name,
    Quantity,
    has_quantity,
    is_quantity,
    unsigned,
)
from restitution.oracle import Relation as Formula
from restitution.planning.angles.scalar_angles import write_product_of_two
from restitution.planning.axes.by_changes import write_wall
from restitution.planning.formulas.next_walls import angle_to_a_wall, standing_angle
from restitution.planning.formulas.resolving import along_axis
from restitution.planning.formulas.turns import Moving
from restitution.planning.formulas.velocity_formulas import body_and_stage, frame_after
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.comparisons import Comparison
from restitution.planning.shows.shown_equations import ShownEquation
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import (
    ZERO,
    product,
    swept,
    total,
    tree_of,
    vector,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.place_trees import AXES, Axis
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.unit_vectors import plain_direction
from restitution.problem import (
    Aligned,
)
from restitution.vector import Vector


def write_aligned(claims: Claims, relation: Aligned, now: int) -> tuple[int, Relation]:
    """How two directions stand to each other, by their components."""
    scene = claims.scene
    (link,) = links_of(scene.problem, relation, now)
    if relation.relation == "parallel to":
        for own in (link, Link(link.right, link.sign, link.left)):
            match own:
                case Link(Quantity("line_of_centres", (), int(event)), _, right) if not (
                    has_quantity(right) or isinstance(right, Name)
                ):
                    return _axis_shown(claims, event, own)
    for own in (link, Link(link.right, link.sign, link.left)):
        if (wall := _wall_shown(claims, own)) is not None:
            return wall
    if relation.relation != "perpendicular to" and not isinstance(link.right, Name):
        return _sense_shown(claims, relation, link) or _common_direction(claims, relation, link)
    record = "perpendicular" if relation.relation == "perpendicular to" else "parallel"
    return _tied(claims, record, (link.left, link.right), Relation(((link,),)))


def _sense_shown(claims: Claims, relation: Aligned, link: Link) -> tuple[int, Relation] | None:
    """The sense in which a sphere moves along the line of its latest impact: a component's sign.

    None where its velocity has another component, or may be zero.
    """
    match link.left:
        case Quantity("velocity", (Name(body),), int(stage)) if stage > 0:
            pass
        case _:
            return None
    if relation.relation == "parallel to" or has_quantity(link.right):
        return None
    scene, mark = claims.scene, claims.worths.mark()
    wanted = scene.model.story.direction(link.right, scene.events)
    velocity = scene.model.story.velocity(body, stage)
    frame = frame_after(scene, body, stage)
    value = velocity.dot(frame.n)
    ahead = scene.model.sign(wanted.dot(frame.n))
    if tidy(wanted.cross(frame.n)) != 0 or tidy(velocity.cross(frame.n)) != 0 or not ahead:
        return None
    claims.solver.determine([value])
    along = frame.component("along", body, stage)
    try:
        return Comparison(claims).write(Link(along, ">" if ahead > 0 else "<", ZERO))
    except NotPlannedError:
        claims.worths.back(mark)
        return None


def _axis_shown(claims: Claims, event: int, link: Link) -> tuple[int, Relation]:
    """A line of centres that is worked out, in the printed direction."""
    relation = Relation(((link,),))
    lines = numbers_in(claims.scene.frame(event).refs)
    if not lines:
        raise NotPlannedError("a line of centres that is given")
    line = claims.judge.write((Move("rearrange"),), lines, relation)
    if line is None:
        raise NotPlannedError("another direction of a line of centres")
    return line, relation


def _wall_shown(claims: Claims, link: Link) -> tuple[int, Relation] | None:
    """A wall that is worked out from an impulse, in the printed direction; None of any other."""
    match link:
        case Link(
            Quantity("direction", (Name(name),), None) | Name(name),
            "parallel to" | "perpendicular to",
            right,
        ) if not (has_quantity(right) or isinstance(right, Name)):
            pass
        case _:
            return None
    scene = claims.scene
    numbers = [n for n, frame in scene.model.frames.items() if frame.wall == name]
    if not numbers or f"axis {numbers[0]}" in scene.facts:
        return None
    own = Quantity("direction", (Name(name),))
    relation = Relation(((Link(own, link.sign, right),),))
    line = write_wall(scene, name)
    if scene.desk.relation(line) == relation:
        return line, relation
    line_ = claims.judge.write((Move("rearrange"),), [line], relation)
    return None if line_ is None else (line_, relation)


def _along_the_axis(claims: Claims, link: Link) -> tuple[int, Relation]:
    """A velocity along a line of centres that is worked out: as a multiple of its direction."""
    match link:
        case Link(Quantity("velocity") as velocity, "parallel to", Quantity() as axis):
            pass
        case _:
            raise NotPlannedError("a line of centres that is to be worked out")
    scene, judge = claims.scene, claims.judge
    lines = numbers_in(scene.frame(int(str(axis.stage))).refs)
    written = scene.desk.known(velocity)
    if not lines or written is None or not isinstance(written.value, Vector):
        raise NotPlannedError("a line of centres, or a velocity, that no line says")
    direction = scene.desk.last_link(lines[-1]).right
    x, y = scene.model.story.direction(direction, scene.events)
    own, other = written.value
    factor = tidy(own / x) if x != 0 else tidy(other / y)
    multiple = Link(velocity, "=", product(tree_of(factor), direction))
    line = judge.write((Move("rearrange"),), written.refs, Relation(((multiple,),)))
    relation = Relation(((link,),))
    last = None if line is None else judge.write((Move("put"),), [lines[-1], line], relation)
    if last is None:
        raise NotPlannedError("a velocity along a line of centres")
    return last, relation


def write_right_angle(
    claims: Claims, pair: Sequence[Expression], opened: Link, link: Link
) -> tuple[int, Relation]:
    """That an angle is 90°, and then that a letter of the statement for it is."""
    line, relation = _tied(claims, "perpendicular", pair, Relation(((opened,),)))
    if opened == link:
        return line, relation
    relation = Relation(((link,),))
    named = claims.judge.write((Move("put"),), [line, *claims.scene.lets_in(link)], relation)
    if named is None:
        raise NotPlannedError("a letter for a right angle")
    return named, relation


def _tied(
    claims: Claims, record: str, pair: Sequence[Expression], own_relation: Relation
) -> tuple[int, Relation]:
    """That two directions are parallel, or at right angles, by the components of velocities."""
    scene = claims.scene
    moving = [body_and_stage(scene, tree) for tree in pair if is_quantity(tree, "velocity")]
    if not moving:
        return _of_a_sum(claims, record, pair)
    by_angle = _by_the_angle(claims, record, pair, moving, own_relation)
    if by_angle is not None:
        return by_angle, own_relation
    frame = frame_after(scene, *max(moving, key=lambda own: own[1]))
    refs: list[Ref] = []
    for body, stage in moving:
        own = scene.velocity(body, stage)
        claims.solver.determine(list(own))
        for kind in COMPONENTS:
            refs += claims.worths.component(kind, body, stage, frame).whole
    refs += [f"wall {wall.name}" for wall in scene.problem.walls]
    move = Move("define", record, frame.number, tuple(dict.fromkeys(b for b, _ in moving)))
    if record == "perpendicular" and len(moving) == len(pair):
        line = _by_the_product(claims, move, (moving[0], moving[1]), own_relation)
        if line is not None:
            return line, own_relation
    if len(moving) == 1 and frame.is_slanted:
        line = _by_a_component(claims, move, pair, moving[0], own_relation)
        if line is not None:
            return line, own_relation
    if record == "perpendicular" and len(moving) == 1:
        line = _by_a_product_with_a_line(claims, move, pair, frame, refs, own_relation)
        if line is not None:
            return line, own_relation
    for pool in (refs, [*frame.refs, *refs]):
        cited = together(r for r in pool if claims.worths.exists(r))
        line = claims.judge.write((move,), cited, own_relation)
        if line is not None:
            return line, own_relation
    raise NotPlannedError("two directions")


def _of_a_sum(claims: Claims, record: str, pair: Sequence[Expression]) -> tuple[int, Relation]:
    """That a difference of velocities is at right angles to a direction, by a scalar product."""
    sums = [tree for tree in pair if has_quantity(tree) and not isinstance(tree, Quantity)]
    if record != "perpendicular" or len(sums) != 1:
        raise NotPlannedError("directions of no velocity")
    shown = Link(Quantity("dot", tuple(pair)), "=", ZERO)
    return ShownEquation(claims, shown).write(), Relation(((shown,),))


def _by_the_angle(
    claims: Claims,
    record: str,
    pair: Sequence[Expression],
    moving: Sequence[Moving],
    relation: Relation,
) -> int | None:
    """That a path is at right angles to the next wall, by the angle to the last one that stands."""
    scene = claims.scene
    walls = [side.arguments[0] if is_quantity(side, "direction") else side for side in pair]
    names = [side.name for side in walls if isinstance(side, Name)]
    if record != "perpendicular" or len(moving) != 1 or len(names) != 1:
        return None
    (own,), (wall,), mark = moving, names, claims.worths.mark()
    frame = scene.model.frames.get(own[1])
    if frame is None or frame.wall is None or wall not in scene.model.story.walls:
        return None
    velocity = Quantity("velocity", (Name(own[0]),), own[1])
    if standing_angle(scene, Quantity("angle", (velocity, Name(frame.wall)))) is None:
        return None
    angle = angle_to_a_wall(scene, *own, wall)
    line = None
    if angle is not None and angle.value == sp.pi / 2:
        move = Move("define", record, own[1], (own[0],))
        line = claims.judge.write((move,), angle.refs, relation)
    if line is None:
        claims.worths.back(mark)
    return line


def _by_the_product(
    claims: Claims, move: Move, pair: tuple[Moving, Moving], relation: Relation
) -> int | None:
    """That two velocities are at right angles, by their scalar product, a line of its own."""
    mark = claims.worths.mark()
    product_ = write_product_of_two(claims.scene, pair)
    line = None if product_ is None else claims.judge.write((move,), [product_], relation)
    if line is None:
        claims.worths.back(mark)
    return line


def _by_a_component(
    claims: Claims, move: Move, pair: Sequence[Expression], moving: Moving, relation: Relation
) -> int | None:
    """That a velocity is along **i** or **j**, or a wall there, by its other component, which is 0.

    None where the other direction is none of these, or is that of another velocity.
    """
    scene = claims.scene
    _, line = sorted(pair, key=lambda tree: not is_quantity(tree, "velocity"))
    if has_quantity(line):
        return None
    along = plain_direction(scene.model.story.direction(line, scene.events))
    if 0 not in along:
        return None
    axis: Axis = "i" if (along.y == 0) == (move.record == "perpendicular") else "j"
    mark = claims.worths.mark()
    own = along_axis(scene, *moving, axis)
    walls = [f"wall {wall.name}" for wall in scene.problem.walls]
    last = None
    if own.value == 0:
        last = claims.judge.write((move,), [*own.refs, *walls], relation)
    if last is None:
        claims.worths.back(mark)
    return last


def _by_a_product_with_a_line(
    claims: Claims,
    move: Move,
    pair: Sequence[Expression],
    frame: Frame,
    refs: Sequence[Ref],
    relation: Relation,
) -> int | None:
    """That a velocity is at right angles to a slanting line, by a scalar product of its own line.

    None where the line is along **i** or **j** or in letters, or no line has the components along
    these.
    """
    scene = claims.scene
    velocity, line = sorted(pair, key=lambda tree: not isinstance(tree, Quantity))
    if not isinstance(velocity, Quantity) or isinstance(line, Quantity):
        return None
    along = plain_direction(scene.model.story.direction(line, scene.events))
    if 0 in along or not all(value.is_number for value in along):
        return None
    body, stage = body_and_stage(scene, velocity)
    mark = claims.worths.mark()
    if frame.is_slanted:
        across, up = (along_axis(scene, body, stage, axis) for axis in AXES)
        parts, more = (across.value, up.value), (*across.refs, *up.refs)
    else:
        (x, x_refs), (y, y_refs) = map(scene.put, scene.velocity(body, stage))
        parts, more = (x, y), (*x_refs, *y_refs)
    if 0 in parts:
        claims.worths.back(mark)
        return None
    terms = total(product(tree_of(a), tree_of(tidy(b))) for a, b in zip(along, parts, strict=True))
    late = Quantity("velocity", (Name(body),), stage)
    own = Quantity("dot", (late, vector(*map(tree_of, along))))
    product_move = replace(move, record="product")
    every = more if frame.is_slanted else (*frame.refs, *refs, *more)
    cited = together(ref for ref in every if claims.worths.exists(ref))
    shown = chain(own, (swept(terms), None), (ZERO, "rearrange"))
    number = claims.judge.write((product_move,), cited, shown)
    last = None
    if number is not None:
        last = claims.judge.write((move,), [number, *cited], relation)
    if last is None:
        claims.worths.back(mark)
    return last


def _common_direction(claims: Claims, relation: Aligned, link: Link) -> tuple[int, Relation]:
    """One velocity as a multiple of another, or of a direction: the sign of the factor tells."""
    scene = claims.scene
    left = link.left
    right = unsigned(link.right)
    a, b = (scene.model.story.direction(tree, scene.events) for tree in (left, right))
    for own in (a, b):
        claims.solver.determine(list(own))
    (ax, ay), (bx, by) = (
        tuple(sp.sympify(scene.put(component)[0], strict=True) for component in (own.x, own.y))
        for own in (a, b)
    )
    factor = tidy(ax / bx) if bx != 0 else tidy(ay / by)
    # What is at rest has no direction, and nothing is claimed of it.
    sizes = [expanded(own[0] ** 2 + own[1] ** 2) for own in ((ax, ay), (bx, by))]
    moving = [Formula(size, ">") for size in sizes if size.free_symbols]
    sign = proved_sign(scene.model.oracle.with_facts(moving), factor)
    sense = 1 if right is link.right else -1
    wanted = sign if relation.relation == "parallel to" else sense
    if not has_quantity(left) or sign == 0 or sign != wanted:
        raise NotPlannedError("two directions")
    if sign is None and relation.relation != "parallel to":
        raise NotPlannedError("two directions")  # the factor may vanish, or have either sign
    if is_quantity(right, "line_of_centres"):
        fact = scene.facts.get(f"axis {right.stage}")
        if fact is None:
            return _along_the_axis(claims, link)
        right = fact.relation.only[0].right
    parallel = Link(left, "=", product(tree_of(factor), right))
    line = ShownEquation(claims, parallel).write()
    if is_quantity(left, "impulse"):  # a velocity is known by its components
        scene.desk.know(left, Vector(*(factor * component for component in (bx, by))), (line,))
    return line, Relation(((parallel,),))
