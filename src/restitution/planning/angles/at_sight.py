"""Angles that are seen: to a line along which a sphere moves, or perpendicular to it.

Of two vectors, one of which is a multiple of the other, too.
"""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.lines.derivation import Move, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import Degrees, Expression, Name, Quantity, Unit, walk
from restitution.planning.angles.quantities import formula
from restitution.planning.formulas.angle_formulas import components_to_a_line
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.premises import background, nonzero, sign_known
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def angle_at_sight(scene: Scene, asked: Quantity) -> int | None:
    """The line of an angle to **i**, **j**, a wall or a line of centres: one component is 0.

    None where neither is, or where it is open on which side of a line the sphere moves.
    """
    match asked:
        case Quantity("angle", (Quantity("velocity") as velocity, (Unit() | Name()) as line)):
            pass
        case Quantity(
            "angle", (Quantity("velocity") as velocity, Quantity("line_of_centres") as line)
        ):
            pass
        case _:
            return None
    body, stage = body_and_stage(scene, velocity)
    mark = scene.desk.mark()
    try:
        above, below, walls = components_to_a_line(scene, body, stage, line)
    except NotPlannedError:
        return None
    zero, other = (below, above) if scene.model.identically_zero(below.value) else (above, below)
    if not scene.model.identically_zero(zero.value) or not scene.model.proved_sign(
        scene.model.in_data(other.value)
    ):
        scene.desk.back(mark)
        return None
    if zero is below:
        move, degrees = Move("define", "perpendicular", stage or None, (body,)), 90
    else:
        if isinstance(line, Unit) and scene.desk.known(velocity) is None:
            write_formula(scene, formula(scene, velocity))  # to which side it moves
        back = isinstance(line, Unit) and scene.model.sign(other.value) < 0
        move, degrees = Move("define", "parallel", stage or None, (body,)), 180 if back else 0
    relation = chain(asked, (Degrees(Fraction(degrees)), None))
    axes = scene.frame(stage).refs if stage in scene.model.frames else ()
    pool = (*zero.whole, *other.whole, *walls, *axes, *nonzero(scene, other.value))
    premises = scene.judge.needed(move, pool, relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def angle_on_one_line(scene: Scene, asked: Quantity) -> int | None:
    """The line of the angle between two spheres that both move along the line of centres: 0°, 180°.

    None where one does not, or where the sense of one is open.
    """
    match asked:
        case Quantity("angle", (Quantity("velocity") as one, Quantity("velocity") as other)):
            pass
        case _:
            return None
    (first, stage), (second, late) = (body_and_stage(scene, velocity) for velocity in (one, other))
    frame = scene.model.frames.get(stage)
    if stage != late or first == second or frame is None or frame.wall is not None:
        return None
    mark, bodies = scene.desk.mark(), (first, second)
    own = scene.frame(stage)
    try:
        across, along = (
            [in_direction(scene, kind, body, stage, own) for body in bodies]
            for kind in ("across", "along")
        )
    except NotPlannedError:
        scene.desk.back(mark)
        return None
    values = [scene.model.in_data(source.value) for source in along]
    signs = [scene.model.proved_sign(value) for value in values]
    # Who was at rest moves off away from the other one, whatever its speed is.
    moving = [any(scene.velocity(body, stage - 1)) for body in bodies]
    is_open = any(
        scene.unknown(source.value) and m for source, m in zip(along, moving, strict=True)
    )
    if any(source.value != 0 for source in across) or not all(signs) or is_open:
        scene.desk.back(mark)
        return None
    names = {symbol.name for value in values for symbol in value.free_symbols}
    known = [ref for value in values for ref in (*sign_known(scene, value), *nonzero(scene, value))]
    facts = [f.id for f in scene.desk.facts if f.id.startswith("given ") and scene.desk.holds(f.id)]
    components = [source.whole for source in (*across, *along)]
    decisive = together(*(source.whole for source, m in zip(along, moving, strict=True) if m))
    still = [f"velocity {body}" for body, m in zip(bodies, moving, strict=True) if not m]
    pool = (*together(own.refs, *components, still), *known, *background(scene, names), *facts)
    degrees = 0 if signs[0] == signs[1] else 180
    relation = chain(asked, (Degrees(Fraction(degrees)), None))
    move = Move("define", "difference", stage, bodies)
    premises = scene.judge.needed(move, pool, relation, decisive)
    if premises is None:
        scene.desk.back(mark)
    return None if premises is None else scene.desk.write(move, premises, relation)


def angle_of_a_multiple(scene: Scene, asked: Quantity) -> int | None:
    """The line of the angle between two vectors, where a line has one as a multiple of the other.

    None where there is no such line, or the factor may be zero or have either sign.
    """
    match asked:
        case Quantity("angle", (Quantity("velocity") as one, Quantity("velocity") as other)):
            pass
        case _:
            return None
    others: dict[Expression, Quantity] = {one: other, other: one}
    for line in reversed(scene.desk.lines):
        match line.relation:
            case Relation((links,)) if scene.desk.holds(line.number) and links[0].sign == "=":
                vector = others.get(links[0].left)
            case _:
                continue
        if vector is None or vector not in set(walk(links[-1].right)):
            continue
        along = scene.value(exchanged(links[-1].right, {vector: Unit("i")}))
        if not isinstance(along, Vector) or along.y != 0:
            continue
        sign = scene.model.proved_sign(scene.model.in_data(along.x))
        if not sign:
            return None
        bodies = tuple(sorted({body_and_stage(scene, velocity)[0] for velocity in (one, other)}))
        stage = max(body_and_stage(scene, velocity)[1] for velocity in (one, other))
        move = Move("define", "parallel", stage or None, bodies)
        relation = chain(asked, (Degrees(Fraction(0 if sign > 0 else 180)), None))
        premises = scene.judge.needed(move, (line.number, *sign_known(scene, along.x)), relation)
        return None if premises is None else scene.desk.write(move, premises, relation)
    return None
