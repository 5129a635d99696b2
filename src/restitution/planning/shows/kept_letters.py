"""A result to be shown in a letter that has been found: *tan β = e tan α*, with e = 9/16 above.

It is shown in the letter, as it is printed, and not by the number.
"""

from __future__ import annotations

from collections.abc import Callable

import sympy as sp

from restitution.expression.tree import Expression, Letter, has_quantity, letters
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import UNPLANNED, Source
from restitution.planning.writing.scene import Scene
from restitution.problem import Compare, Show


def write_in_its_letters(
    scene: Scene, solver: Solver, item: Show, write: Callable[[], None]
) -> None:
    """Writes what is to be shown, in the letters of the coefficients in it where that is possible.

    With such a letter of which the number is put in it would not be shown in the letter.
    """
    values = _known(scene, item)
    if not values or scene.others or scene.sided or not _written(scene, solver, values, write):
        write()


def _written(
    scene: Scene, solver: Solver, values: dict[Letter, Source], write: Callable[[], None]
) -> bool:
    """Whether the item is written in letters that have values, of which no line takes these."""
    standing, free, start = solver.mark(), set(scene.free), len(scene.desk.lines)
    for letter, source in values.items():
        scene.desk.forget_value(letter, source)
        scene.free.add(scene.model.unknowns.letter(letter.name))
    try:
        write()
        numbers = range(start + 1, len(scene.desk.lines) + 1)
        done = not any(_rests_on(scene, number, values) for number in numbers)
    except UNPLANNED:
        done = False
    scene.free = free
    if not done:
        solver.back(standing)
        return False
    for letter, source in values.items():
        scene.desk.know(letter, source.value, source.refs)
    return True


def _known(scene: Scene, item: Show) -> dict[Letter, Source]:
    """The letters of coefficients of restitution in an equation that are known as numbers."""
    relation = item.relation
    if item.subject is not None or not isinstance(relation, Compare):
        return {}
    sides: tuple[Expression, ...] = relation.operands
    if relation.operators != ("=",) or not any(map(has_quantity, sides)):
        return {}
    values: dict[Letter, Source] = {}
    for name in sorted({name for side in sides for name in letters(side)}):
        role = scene.model.unknowns.roles.get(name)
        known = scene.desk.known(Letter(name))
        if role is None or role.kind != "restitution" or known is None:
            continue
        if sp.sympify(known.value, strict=True).is_number:
            values[Letter(name)] = known
    return values


def _rests_on(scene: Scene, number: int, values: dict[Letter, Source]) -> bool:
    """Whether a line cites what gives one of the letters as a number."""
    premises = set(scene.desk.line(number).premises)
    return any(premises & set(source.refs) for source in values.values())


__all__ = ["write_in_its_letters"]
