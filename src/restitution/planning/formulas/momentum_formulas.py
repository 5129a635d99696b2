"""Momenta, by their definition."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Expression, Name, Quantity
from restitution.planning.formulas.angle_formulas import velocity_as_a_line
from restitution.planning.formulas.definitions import Formula, itself
from restitution.planning.formulas.velocity_formulas import velocity_source
from restitution.planning.writing.desk import together
from restitution.planning.writing.forms import product, total, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def momentum_formula(scene: Scene, quantity: Quantity) -> Formula:
    """The momentum of a sphere, by its velocity as a vector."""
    if not quantity.arguments:
        return _momentum_of_all(scene, quantity)
    (name,) = quantity.arguments
    assert isinstance(name, Name)
    assert isinstance(quantity.stage, int)
    velocity = velocity_source(scene, name.name, quantity.stage)
    mass = scene.mass(name.name)
    return Formula(
        Move("define", "momentum-of", quantity.stage or None, (name.name,)),
        itself,
        quantity,
        product(tree_of(mass.value), tree_of(velocity.value)),
        Vector(*(tidy(mass.value * component) for component in velocity.value)),
        together(mass.refs, velocity.refs),
    )


def _momentum_of_all(scene: Scene, quantity: Quantity) -> Formula:
    """The momentum of all spheres, by their velocities as vectors."""
    stage = quantity.stage
    assert isinstance(stage, int)
    terms: list[Expression] = []
    refs: list[Ref] = []
    x = y = sp.Integer(0)
    for body in scene.model.story.spheres:
        velocity = velocity_as_a_line(scene, body, scene.last_event(body, stage))
        refs += velocity.refs
        if all(value == 0 for value in velocity.value):
            continue
        mass = scene.mass(body)
        refs += mass.refs
        terms.append(product(tree_of(mass.value), tree_of(velocity.value)))
        x, y = (a + mass.value * b for a, b in zip((x, y), velocity.value, strict=True))
    whole = Vector(*(tidy(expanded(component)) for component in (x, y)))
    move = Move("define", "momentum-of", stage or None, ())
    return Formula(move, itself, quantity, total(terms), whole, together(refs))
