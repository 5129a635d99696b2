"""Sines and cosines of the angle of a path with a line: a component over the speed."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Relation
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    is_quantity,
    letters,
)
from restitution.planning.angles.turning import quantity_of, write_ratio
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.velocity_formulas import (
    body_and_stage,
    frame_after,
    known_speed,
    speed_formula,
)
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import negative, product, swept, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def write_ratio_of_path(scene: Scene, function: str, angle: Expression) -> tuple[int, Relation]:
    """The line that gives a ratio of an angle of the motion: by another one, or by the speed."""
    mark = scene.desk.mark()
    try:
        return write_ratio(scene, function, angle)
    except NotPlannedError:
        scene.desk.back(mark)
        line = _by_the_speed(scene, function, angle)
        if line is None:
            scene.desk.back(mark)
            raise
    tree = Apply(function, angle)
    return line, chain(tree, (scene.desk.last_link(line).right, None))


def _by_the_speed(scene: Scene, function: str, angle: Expression) -> int | None:
    """The sine, or the cosine, as a component over the speed; None of another angle or ratio."""
    quantity = quantity_of(scene, angle)
    if function not in ("sin", "cos") or quantity.kind != "angle":
        return None
    velocity = quantity.arguments[0]
    if not is_quantity(velocity, "velocity") or not isinstance(velocity.stage, int):
        return None
    body, stage = body_and_stage(scene, velocity)
    if stage not in scene.model.frames:
        return None
    frame = frame_after(scene, body, stage)
    speed = Quantity("speed", velocity.arguments, stage)
    if known_speed(scene, body, stage) is None:
        own = speed_formula(scene, speed)
        if scene.unknown(own.value):
            return None
        write_formula(scene, own)
    known = known_speed(scene, body, stage)
    assert known is not None
    ratio = Apply(function, angle)
    lets = (f"let {angle.name}",) if isinstance(angle, Letter) else ()
    for kind in COMPONENTS:
        part = in_direction(scene, kind, body, stage, frame)
        size = tree_of(part.value)
        size = negative(size) if scene.model.sign(part.value) < 0 else size
        move, pool = (
            Move("define", "speed", frame.number, (body,)),
            together(part.whole, frame.refs, lets),
        )
        resolved = chain(product(speed, ratio), (size, None))
        line = scene.judge.write((move,), pool, resolved)
        if line is None:
            continue
        value = tidy(expanded(scene.scalar(size) / known.value))
        quotient = swept(Binary("/", size, tree_of(known.value)))
        names = letters(quotient)
        for final in ((tree_of(value), "rearrange"), None):
            links = ((quotient, None), final) if final else ((quotient, None),)
            refs = (line, *known.refs, *background(scene, names))
            last = scene.judge.write((Move("put"),), refs, chain(ratio, *links), (line,))
            if last is not None:
                scene.desk.know(ratio, value, (last,))
                return last
    return None


__all__ = ["write_ratio_of_path"]
