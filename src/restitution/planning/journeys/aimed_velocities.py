"""A velocity of which the size is given, and the direction by the way that a body goes."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Binary, Letter, Name, Quantity
from restitution.planning.formulas.whereabouts import contact_of
from restitution.planning.journeys.aims import striker, write_aim
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import product, tree_of
from restitution.planning.writing.place_trees import place_tree
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.unit_vectors import has_nested_roots, unit_tree
from restitution.vector import Vector


def write_by_its_way(scene: Scene, velocity: Quantity) -> bool:
    """Whether a velocity at the start comes of its size and of two places: its line is written.

    So it needs no letters for its components, of which the squares would have two signs.
    """
    match velocity:
        case Quantity("velocity", (Name(body),), 0) if f"velocity {body}" not in scene.facts:
            pass
        case _:
            return False
    given = _speed(scene, body)
    number = next((n for n in range(1, scene.events + 1) if body in scene.bodies(n)), None)
    if given is None or number is None or f"position {body}" not in scene.facts:
        return False
    start = scene.data(f"position {body}")
    there = _place(scene, body, number)
    if there is None or any(map(scene.unknown, (*start.value, *there.value))):
        return False
    displacement = Vector(*(tidy(b - a) for a, b in zip(start.value, there.value, strict=True)))
    length = tidy(scene.model.story.size(displacement))
    size = scene.scalar(given.link.right)
    if (
        not any(displacement)
        or not all(x.is_number for x in displacement)
        or has_nested_roots(length)
    ):
        return False
    value = Vector(*(tidy(size * x / length) for x in displacement))
    path = tree_of(there.value)
    if any(start.value):
        path = Binary("-", path, tree_of(start.value))
    relation = chain(
        velocity,
        (product(tree_of(size), Binary("/", path, tree_of(length))), None),
        (
            product(tree_of(size), unit_tree(Vector(*(tidy(x / length) for x in displacement)))),
            "rearrange",
        ),
        (tree_of(value), "rearrange"),
    )
    pool = together(given.refs, start.refs, there.refs)
    line = scene.judge.write((Move("define", "turned", number, (body,)),), pool, relation)
    if line is None:
        return False
    scene.desk.know(velocity, value, (line,))
    for letter, part in zip(scene.velocity(body, 0), value, strict=True):
        if sp.sympify(letter, strict=True).is_Symbol:
            scene.desk.know(Letter(letter.name), part, (line,))
    return True


def _speed(scene: Scene, body: str) -> GivenEquation | None:
    """The fact that gives the speed at the start by what is known."""
    speed = Quantity("speed", (Name(body),), 0)
    for equation in scene.given:
        if equation.link.left == speed and equation.link.sign == "=":
            value = scene.scalar(equation.link.right)
            return None if scene.unknown(value) else equation
    return None


def _place(scene: Scene, body: str, number: int) -> Source | None:
    """Where a body is at an event: a point to which it comes, or where it has to strike."""
    if striker(scene, number) == body:
        return write_aim(scene, number)
    for own in contact_of(scene, number):
        if own.left == place_tree(body, number):
            value, refs = scene.put(scene.vector(own.right))
            return Source(value, together((f"contact {number}",), refs))
    return None
