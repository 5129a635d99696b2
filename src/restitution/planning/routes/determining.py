"""What is asked is determined: each quantity in it, or the whole, or first what it is made of."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from typing import Any

import sympy as sp

from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    is_quantity,
    walk,
)
from restitution.planning.angles.expressions import outermost, write_expression
from restitution.planning.angles.turning import is_angle, quantity_of
from restitution.planning.closing.squared_ratios import (
    angles_that_cancel,
    is_without,
    keeping,
    kept_for,
)
from restitution.planning.formulas.separations import event_of_relative
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.scene import Scene
from restitution.problem import Find, Value
from restitution.vector import Vector


def determine(scene: Scene, solver: Solver, asked: Expression) -> None:
    """Everything that is asked: each quantity in it, if they can be found, else the whole."""
    wanted: list[sp.Expr] = []
    match asked:
        case Quantity("direction", (Name(body),), int(stage)):
            wanted = list(scene.velocity(body, stage))
        case Quantity("angle", (Quantity("velocity") as a, Quantity("velocity") as b)):
            wanted = [*goals(scene, a), *goals(scene, b)]
        case Quantity() | Letter():
            pass
        case Apply("abs", velocity) if event_of_relative(scene, velocity) is not None:
            pass
        case Binary("-") if event_of_relative(scene, asked) is not None:
            pass
        case _:
            wanted = [
                goal
                for tree in outermost(asked)
                if isinstance(tree, Quantity)
                for goal in goals(scene, tree)
            ]
    if wanted:
        try:
            solver.determine(wanted)
        except NotPlannedError:
            pass
        else:
            return
    standing = solver.mark()
    try:
        solver.determine(goals(scene, asked))
    except NotPlannedError:
        solver.back(standing)
        if _determine_components(scene, solver, asked):
            return
        solver.back(standing)
        if not _determine_letters(scene, solver) and not _determine_start(scene, solver, asked):
            raise
        solver.determine(goals(scene, asked))


def _determine_components(scene: Scene, solver: Solver, asked: Expression) -> bool:
    """Finds first a component after an impact, by what is asked; then that."""
    components = {component.symbol for component in scene.model.components.values()}
    for symbol in sorted(components & scene.model.final.keys(), key=str):
        standing = solver.mark()
        try:
            solver.determine([symbol])
            solver.determine(goals(scene, asked))
        except NotPlannedError:
            solver.back(standing)
        else:
            return True
    return False


def _determine_letters(scene: Scene, solver: Solver) -> bool:
    """Finds first what else the part asks: its letters. Returns whether there are any."""
    progress = False
    for step in scene.part.steps:
        for item in step.items if isinstance(step, Find) else ():
            match item:
                case Value(expression=Letter(name)):
                    symbol = scene.model.unknowns.letter(name)
                    if symbol in scene.unknown(symbol):
                        solver.determine([symbol])
                        progress = True
    return progress


def _determine_start(scene: Scene, solver: Solver, asked: Expression) -> bool:
    """Finds first the velocity at the start, where that is to be found and stands in what is asked.

    Returns whether it does.
    """
    open_ = {symbol for goal in goals(scene, asked) for symbol in scene.unknown(goal)}
    for body in scene.problem.spheres:
        own = {s for component in scene.velocity(body.name, 0) for s in component.free_symbols}
        if len(own & open_) > 1 and own & open_ <= scene.model.final.keys():
            solver.determine(sorted(own & open_, key=str))
            return True
    return False


def determine_by_squares(scene: Scene, solver: Solver, asked: Expression) -> None:
    """Everything that is asked, with no ratio of an angle put in where its square will serve."""
    for symbol in (*kept_for(scene, asked), *angles_that_cancel(scene, asked)):
        standing = solver.mark()
        with suppress(NotPlannedError):
            with keeping(scene, symbol):
                determine(scene, solver, asked)
            if not isinstance(asked, Letter) or is_without(scene, asked, symbol):
                return
        solver.back(standing)
    determine(scene, solver, asked)


def determine_velocities(scene: Scene, solver: Solver, asked: Expression) -> None:
    """The components of which an angle is made, where it is the same whatever they are."""
    components = {component.symbol for component in scene.model.components.values()}
    for angle in walk(asked):
        if isinstance(angle, Letter | Quantity) and is_angle(scene, angle):
            velocities = _velocities_of(scene, quantity_of(scene, angle))
            open_ = {s for velocity in velocities for s in scene.unknown(velocity)} & components
            if open_:
                solver.determine(sorted(open_, key=str))


def _velocities_of(scene: Scene, angle: Quantity) -> Iterator[Vector]:
    match angle:
        case Quantity("angle", arguments):
            for argument in arguments:
                if is_quantity(argument, "velocity"):
                    yield scene.vector(argument)
        case Quantity("deflection" | "direction", (Name(body),), int(stage)):
            yield scene.velocity(body, stage)


def goals(scene: Scene, tree: Expression) -> list[sp.Expr]:
    """What has to be known for an expression to be: its value, or the components of it."""
    value = scene.value(tree)
    if isinstance(value, Vector):
        return [sp.sympify(other, strict=True) for other in value]
    if hasattr(value, "measure"):
        # Of a right angle there is no tangent.
        x, y = (sp.sympify(component, strict=True) for component in (value.x, value.y))
        return [x / y if scene.model.sign(x) == 0 else y / x]
    return [sp.sympify(value, strict=True)]


def write_determined(scene: Scene, solver: Solver, asked: Expression) -> tuple[int, Any]:
    """The line in which an expression comes to its value, once every letter in that is known.

    Of the square of what is zero, such as an energy, no gradient tells of its letters.
    """
    standing = solver.mark()
    line, value = write_expression(scene, asked)
    right = scene.value(scene.desk.last_link(line).right)
    parts = right if isinstance(right, Vector) else (right,)
    open_ = {s for part in parts if not hasattr(part, "measure") for s in scene.unknown(part)}
    open_ &= scene.model.final.keys()
    if not open_ or scene.others:
        return line, value
    solver.back(standing)
    solver.determine(sorted(open_, key=str))
    return write_expression(scene, asked)
