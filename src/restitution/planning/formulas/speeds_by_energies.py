"""A speed by a kinetic energy, which is a line or is given."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Name, Quantity
from restitution.planning.formulas.velocity_formulas import body_and_stage, known_speed, parts
from restitution.planning.writing.desk import Source, chain, is_value_of, together
from restitution.planning.writing.forms import square, tree_of
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene


def speed_by_its_energy(scene: Scene, speed: Quantity) -> int | None:
    """A speed by the line of its kinetic energy; None without one, or where that gains nothing.

    It is none where the speed is a line, and where a body has one component alone, or a root is
    left.
    """
    body, stage = body_and_stage(scene, speed)
    if stage not in scene.model.frames or known_speed(scene, body, stage):
        return None
    known, record = scene.desk.known(Quantity("energy", (Name(body),), stage)), "energy"
    if known is None and tuple(scene.model.story.spheres) == (body,):
        known, record = scene.desk.known(Quantity("energy", (), stage)), "total"
    if known is None or any(part.value == 0 for part in parts(scene, body, stage)):
        return None
    return _speed_of_energy(scene, body, stage, known, record)


def speed_by_given_energy(scene: Scene, speed: Quantity) -> int | None:
    """A speed by its kinetic energy, which is given; None where that is not so."""
    body, stage = body_and_stage(scene, speed)
    if stage not in scene.model.frames or known_speed(scene, body, stage):
        return None
    energy = Quantity("energy", (Name(body),), stage)
    for equation in scene.given:
        if is_value_of(equation.link, energy):
            known = Source(scene.scalar(equation.link.right), equation.refs)
            if not scene.unknown(scene.mass(body).value):
                return _speed_of_energy(scene, body, stage, known, "energy")
    return None


def _speed_of_energy(scene: Scene, body: str, stage: int, known: Source, record: str) -> int | None:
    """The lines of a speed by a kinetic energy: its square, and the root of that."""
    mass = scene.mass(body)
    squared = tidy(2 * known.value / mass.value)
    value, more = scene.put(squared)
    size = tidy(sp.sqrt(tidy(value)))
    plain = size.is_rational_function() or tidy(value).is_Rational
    if scene.unknown(value) or size.has(sp.Add) or not plain:
        return None
    own = Quantity("speed", (Name(body),), stage)
    define = Move("define", record, stage, (body,) if record == "energy" else ())
    relation = chain(square(own), (tree_of(squared), None))
    pool = together(known.refs, mass.refs)
    line = scene.judge.write((define,), pool, relation, shown="inline" if more else "line")
    if line is not None and more:
        relation = chain(square(own), (tree_of(tidy(value)), None))
        line = scene.judge.write((Move("put"),), (line, *more), relation)
    if line is None:
        return None
    names = symbol_names(squared)
    root = chain(own, (tree_of(size), None))
    line = scene.judge.write((Move("rearrange"),), (line, *background(scene, names)), root, (line,))
    if line is not None:
        scene.desk.know(own, size, (line,))
    return line
