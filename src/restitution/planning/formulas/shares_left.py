"""An energy after impacts as a share of that before: what it leaves is the share that is lost."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, equality
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Binary,
    Expression,
    Name,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.formulas.speeds_by_energies import speed_by_given_energy
from restitution.planning.formulas.velocity_formulas import (
    body_and_stage,
    known_speed,
    squares,
)
from restitution.planning.writing.desk import together
from restitution.planning.writing.forms import (
    difference,
    product,
    product_without,
    square,
    swept,
    tree_of,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene


def as_a_loss(scene: Scene, link: Link, share: Expression) -> tuple[Link, int] | None:
    """A relation of an energy to one before it as one of what is lost between the two.

    ``share`` is that loss over the energy before it. With the line that says what the loss is; None
    of another relation, and where no such line is followed.
    """
    match share:
        case Binary("/", Quantity(kind, (), int(event)) as lost, Quantity("energy") as before) if (
            kind in LOSSES and before.stage == (0 if kind == "total_energy_lost" else event - 1)
        ):
            pass
        case _:
            return None
    after = link.left
    if not is_quantity(after, "energy") or after.stage != event:
        return None
    factor = product_without(link.right, before)
    left = None if factor is None else scene.scalar(factor)
    if left is None or not left.is_number:
        return None
    record = _RECORDS[kind]
    bodies = scene.bodies(event) if kind == "energy_lost" else ()
    defined = equality(lost, Binary("-", before, after))
    line = scene.judge.write((Move("define", record, event, bodies),), (), defined, shown="silent")
    sign = "=" if link.sign == "=" else FLIPPED[link.sign]
    rest = swept(Binary("*", tree_of(1 - left), before))
    return None if line is None else (Link(lost, sign, rest), line)


def speed_by_a_fact(scene: Scene, asked: Quantity) -> int | None:
    """A speed by its kinetic energy that is given, or by the share of one; None of all else."""
    if asked.kind != "speed":
        return None
    return speed_by_given_energy(scene, asked) or speed_by_a_share(scene, asked)


def speed_by_a_share(scene: Scene, speed: Quantity) -> int | None:
    """The speed of the only sphere after an impact, by the share of its energy that is given.

    None where the fact gives no share in numbers of the energy just before it.
    """
    if known_speed(scene, *body_and_stage(scene, speed)) is not None:
        return None
    return _by_a_share(scene, speed)


def speed_compared(scene: Scene, equation: GivenEquation) -> tuple[int, sp.Symbol] | None:
    """A given speed in one unknown, compared with that of the energy which is given too.

    The line, and the unknown. None of another fact, and where no energy tells the speed.
    """
    match equation.link:
        case Link(Quantity("speed") as speed, "=", right) if not has_quantity(right):
            value, more = scene.put(scene.scalar(right))
        case _:
            return None
    unknown = scene.unknown(value)
    if len(unknown) != 1 or scene.desk.known(speed) is not None:
        return None
    line = _by_a_share(scene, speed)
    if line is None:
        return None
    relation = equality(swept(tree_of(value) if more else right), scene.desk.last_link(line).right)
    number = scene.judge.write((Move("put"),), (*equation.refs, line, *more), relation)
    return None if number is None else (number, *unknown)


def _by_a_share(scene: Scene, speed: Quantity) -> int | None:
    """The lines of a speed by the share of the energy that is given."""
    body, stage = body_and_stage(scene, speed)
    if tuple(scene.model.story.spheres) != (body,) or stage not in scene.model.frames:
        return None
    for equation in scene.given:
        share = _share_left(scene, equation.link, body, stage)
        if share is not None:
            line = _written(scene, equation, (body, stage), *share)
            if line is not None:
                return line
    return None


def _share_left(scene: Scene, link: Link, body: str, stage: int) -> tuple[sp.Expr, bool] | None:
    """The share of its energy that a sphere keeps at an impact, and whether the loss is given."""
    before = [Quantity("energy", bodies, stage - 1) for bodies in ((), (Name(body),))]
    left, right = link.left, link.right
    if link.sign != "=":
        return None
    match left:
        case Binary("/", above, below) if below in before:
            left, right = above, Binary("*", right, below)
    own = next((tree for tree in walk(right) if tree in before), None)
    factor = None if own is None else product_without(right, own)
    if factor is None or has_quantity(factor) or not scene.scalar(factor).is_number:
        return None
    share = scene.scalar(factor)
    match left:
        case Quantity("energy", bodies, at) if at == stage and bodies in ((), (Name(body),)):
            return share, False
        case Quantity(kind, (), at) if kind in LOSSES and at == stage:
            return (1 - share, True) if stage == 1 or kind == "energy_lost" else None
    return None


def _written(
    scene: Scene, given: GivenEquation, of: tuple[str, int], share: sp.Expr, lost: bool
) -> int | None:
    """The square of a speed as a share of that before, and the speed."""
    body, stage = of
    early, size, refs = squares(scene, body, scene.last_event(body, stage - 1), known=True)
    root = tidy(sp.sqrt(tidy(share * size)))
    if scene.unknown(size) or root.has(sp.Add) or root.has(sp.sin, sp.cos):
        return None
    own, mark = Quantity("speed", (Name(body),), stage), scene.desk.mark()
    factor = tree_of(1 - share if lost else share)
    sides = (difference(early, square(own)) if lost else square(own), product(factor, early))
    move = Move("define", "energy-ratio", stage, (body,))
    pool = together(given.refs, refs)
    line = scene.judge.write((move,), pool, equality(*map(swept, sides)))
    known = background(scene, letters(early))
    value = tree_of(root)
    if line is not None:
        squared = equality(square(own), tree_of(tidy(share * size)))
        line = scene.judge.write((Move("rearrange"),), (line, *known), squared) or line
        alone = equality(own, value)
        line = scene.judge.write((Move("rearrange"),), (line, *known), alone, (line,))
    if line is None:
        scene.desk.back(mark)
        return None
    scene.desk.know(own, root, (line,))
    return line


_RECORDS = {"energy_lost": "energy-lost", "total_energy_lost": "total-lost"}

__all__ = ["as_a_loss", "speed_by_a_fact", "speed_compared"]
