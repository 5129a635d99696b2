"""Velocities before two spheres meet along a line that slants, by those after it.

Only the components along the line change: these are the unknowns, and not those along **i** and
**j**.
"""

from __future__ import annotations

from functools import partial

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Meaning, Move
from restitution.expression.tree import Expression, Name, Quantity
from restitution.oracle.roles import REAL
from restitution.planning.axes.open_lines import tried
from restitution.planning.closing.pairs import close_two
from restitution.planning.closing.shapes import close
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.impacts import in_direction, momentum, residual, restitution
from restitution.planning.formulas.named_angles import letters_taken
from restitution.planning.routes.back_through_walls import take_start
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import difference, negative, product, total, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import unit_tree, whole_direction
from restitution.planning.writing.vectors import velocity_given
from restitution.solving.algebra.numbers import number_of
from restitution.vector import Vector

_LETTERS = ("p", "q", "x", "y", "r", "s")


def write_before_slanting_impacts(scene: Scene) -> None:
    """The velocities at the start of spheres that meet so, where those after it are given."""
    for number, own in scene.model.frames.items():
        if own.wall is not None or own.by_values or own.angle is not None:
            continue
        if not all(part.is_number and part != 0 for part in own.n):
            continue
        sought = [body for body in scene.spheres(number) if _is_sought(scene, body, number)]
        if sought and not scene.others:
            tried(scene, partial(_write, scene, number, sought))


def _is_sought(scene: Scene, body: str, event: int) -> bool:
    """Whether a velocity at the start is to be found, and the event is the first of the body."""
    if scene.last_event(body, event - 1):
        return False
    return all(part.is_Symbol and scene.unknown(part) for part in scene.velocity(body, 0))


def _write(scene: Scene, number: int, sought: list[str]) -> bool:
    """Both laws in the components along the line, and the velocities at the start by these."""
    frame = scene.frame(number)
    late: dict[str, Source] = {}
    for body in sought:
        given = velocity_given(scene, body, number)
        if given is None or any(map(scene.unknown, given[1])):
            return False
        late[body] = Source(given[1], given[2])
    symbols = {body: _named(scene, body, frame) for body in sought}
    laws = [momentum(scene, frame)]
    if not scene.unknown(scene.coefficient(number).value):
        laws.append(restitution(scene, frame))
    unknowns = frozenset().union(*(scene.unknown(residual(scene, law)) for law in laws))
    if len(unknowns) != len(laws) or not unknowns.issuperset(symbols.values()):
        return False
    first, *others = sorted(unknowns, key=lambda symbol: symbol not in symbols.values())
    if others:
        close_two(scene, (laws[0], laws[1]), (first, others[0]))
    else:
        close(scene, laws[0], first)
    for body in sought:
        start = _by_the_change(scene, body, frame, late[body])
        line = write_formula(scene, start)
        take_start(scene, body, Source(start.value, (line,)))
    return True


def _named(scene: Scene, body: str, frame: Frame) -> sp.Symbol:
    """The letter for a component along the line before the impact, introduced here."""
    taken = letters_taken(scene)
    name = next(own for own in _LETTERS if own not in taken)
    symbol, component = REAL.symbol(name), frame.component("along", body, 0)
    model = scene.model
    model.unknowns.roles = {**model.unknowns.roles, name: REAL}
    value = tidy(model.branch.story.velocity(body, 0).dot(frame.n))
    model.final[symbol] = value
    model.sample[name] = number_of(model.number(value))
    let = scene.desk.write(Move("let"), (), Meaning(name, component))
    scene.desk.know(component, symbol, (let,))
    return symbol


def _by_the_change(scene: Scene, body: str, frame: Frame, late: Source) -> Formula:
    """A velocity before an impact as **v** + (change along **n**)**n**."""
    number = frame.number
    first, last = (in_direction(scene, "along", body, k, frame) for k in (0, number))
    change = tidy(first.value - last.value)
    back = scene.model.sign(scene.model.in_data(change)) < 0
    ends = (last, first) if back else (first, last)
    step = product(difference(*(tree_of(end.value) for end in ends)), unit_tree(frame.n))
    whole, length = whole_direction(frame.n)
    once = product(tree_of(tidy((-change if back else change) / length)), tree_of(whole))

    def beside(own: Expression) -> Expression:
        return total((tree_of(late.value), negative(own) if back else own))

    value = Vector(
        *(tidy(expanded(a + change * n)) for a, n in zip(late.value, frame.n, strict=True))
    )
    quantity = Quantity("velocity", (Name(body),), 0)
    move = Move("law", "changed-velocity", number, (body,))
    pool = together(late.refs, first.whole, last.whole, frame.refs)
    refs = scene.judge.needed(move, pool, chain(quantity, (beside(step), None)), late.refs)
    if refs is None or any(map(scene.unknown, value)):
        raise NotPlannedError("a velocity before an impact")
    return Formula(move, itself, quantity, beside(step), value, refs, beside(once))


__all__ = ["write_before_slanting_impacts"]
