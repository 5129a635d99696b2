"""Speeds by the angles of their velocities to a line, and energies that are shown by them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

from restitution.explaining.lines.derivation import Link, Move, Ref, equality
from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ENERGIES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.fractions_lost import fraction_lost, ratio_of_energies
from restitution.planning.formulas.velocity_formulas import body_and_stage, frame_after
from restitution.planning.inequalities.claims import Claims
from restitution.planning.writing.desk import UNPLANNED, NotPlannedError, chain, together
from restitution.planning.writing.forms import factors, negative, product, swept, tree_of


def ratios_of_velocities(claims: Claims, *trees: Expression) -> Iterator[tuple[Quantity, Apply]]:
    """The sines and cosines of angles between a velocity and a line, with the velocity."""
    for node in (node for tree in trees for node in walk(tree)):
        match node:
            case Apply("sin" | "cos", Letter() | Quantity("angle") as angle):
                opened = claims.worths.opened(angle)
            case _:
                continue
        if isinstance(opened, Quantity) and is_quantity(opened.arguments[0], "velocity"):
            yield opened.arguments[0], node


def speeds_by_components(
    claims: Claims, speed: Quantity, ratio: Apply
) -> Iterator[tuple[int, tuple[Ref, ...]]]:
    """The lines of a speed times a ratio of an angle as a component: V cos β = u cos α.

    With each what the letter of the angle stands for.
    """
    scene, velocity = claims.scene, replace(speed, kind="velocity")
    body, stage = body_and_stage(scene, velocity)
    frame = frame_after(scene, body, stage)
    lets = scene.lets_in(Link(ratio.argument, "=", ratio.argument))
    move = Move("define", "speed", frame.number, (body,))
    for kind in ("across", "along"):
        own = claims.worths.component(kind, body, stage, frame)
        size = tree_of(own.value)
        size = negative(size) if scene.model.sign(own.value) < 0 else size
        pool = together(own.whole, frame.refs, lets)
        line = claims.judge.write((move,), pool, equality(product(speed, ratio), size))
        if line is not None:
            yield line, lets


def shown_by_speeds(claims: Claims, link: Link, quantities: Sequence[Quantity]) -> int | None:
    """An equation of energies by the speeds after impacts, in angles that the printed form has.

    A speed that was shown is quoted; another one comes of the component that does not change. None
    of another equation, and where the printed form has a coefficient: no speed would.
    """
    energies = [quantity for quantity in quantities if quantity.kind in ENERGIES]
    roles = claims.scene.model.unknowns.roles
    coefficients = {name for name, role in roles.items() if role.kind == "restitution"}
    if not energies or energies != [*quantities] or has_quantity(link.right):
        return None
    if letters(link.right) & coefficients:
        return None
    mark = claims.worths.mark()
    try:
        taken = [_take_shown_speeds(claims)]
        for velocity, ratio in ratios_of_velocities(claims, link.right):
            taken.append(_take_speed(claims, replace(velocity, kind="speed"), ratio))
        line = _of_energies(claims, link, energies) if any(taken) else None
    except UNPLANNED:
        line = None
    if line is None:
        claims.worths.back(mark)
    return line


def _take_shown_speeds(claims: Claims) -> bool:
    """Takes the speeds that were to be shown as they are printed, alone or times a ratio."""
    desk, taken = claims.scene.desk, False
    for number in [end.line for end in desk.ends if end.shown]:
        if not desk.holds(number) or len(desk.relation(number).options) != 1:
            continue
        own = desk.last_link(number)
        speed, *rest = sorted(factors(own.left), key=lambda tree: not is_quantity(tree, "speed"))
        if not is_quantity(speed, "speed") or any(map(has_quantity, rest)):
            continue
        if own.sign == "=" and not has_quantity(own.right):
            taken |= _take_alone(claims, number, speed, product(*rest) if rest else None)
    return taken


def _take_speed(claims: Claims, speed: Quantity, ratio: Apply) -> bool:
    """Takes a speed by a component and the ratio of its angle, unless it is taken already."""
    if not speed.stage or claims.scene.desk.known(speed) is not None:
        return False
    for line, _ in speeds_by_components(claims, speed, ratio):
        if _take_alone(claims, line, speed, ratio):
            return True
    return False


def _take_alone(claims: Claims, number: int, speed: Expression, factor: Expression | None) -> bool:
    """Takes a speed by a line of it, or of it times a factor, which is brought below."""
    desk = claims.scene.desk
    right = desk.last_link(number).right
    line: int | None = number
    if factor is not None:
        right = Binary("/", right, factor)
        known = claims.judge.known(letters(right))
        alone = equality(speed, right)
        line = claims.judge.write((Move("rearrange"),), (number, *known), alone, (number,))
    if line is not None:
        desk.know(speed, claims.worths.value(right), (line,))
    return line is not None


def _of_energies(claims: Claims, link: Link, energies: Sequence[Quantity]) -> int | None:
    """The printed form by the speeds that are taken, without the mass or by both energies."""
    scene, judge = claims.scene, claims.judge
    for ratio in (ratio_of_energies, fraction_lost) if isinstance(link.left, Binary) else ():
        own = ratio(scene, link.left)
        if own is not None:
            whole = chain(link.left, (own.right, None), (link.right, "rearrange"))
            last = judge.write((own.move,), own.refs, whole)
            if last is not None:
                return last
    values: dict[Expression, Expression] = {}
    lines: list[int] = []
    for energy in energies:
        own = formula(scene, energy)
        if scene.unknown(own.value):
            raise NotPlannedError("an energy that the speeds do not tell")
        lines.append(write_formula(scene, own))
        values[energy] = scene.desk.last_link(lines[-1]).right
    put = swept(exchanged(claims.worths.opened(link.left), values))
    known = judge.known(letters(put) | letters(link.right))
    whole = chain(link.left, (put, None), (link.right, "rearrange"))
    return judge.write((Move("put"), Move("rearrange")), (*lines, *known), whole)


__all__ = ["ratios_of_velocities", "shown_by_speeds", "speeds_by_components"]
