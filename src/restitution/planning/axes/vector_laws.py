"""Laws of an impact by whole velocities: momentum, the line of centres along its change, e."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Binary, Expression, Name, Quantity
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import (
    ZERO,
    alike,
    difference,
    multiple,
    negative,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import plain_direction
from restitution.vector import Vector


def vector_tree(value: Vector) -> Expression:
    """A vector, its components multiplied out."""
    return tree_of(Vector(*(tidy(expanded(component)) for component in value)))


def by_momentum(
    scene: Scene, number: int, body: str, late: dict[str, Vector], lines: dict[str, Ref], other: str
) -> tuple[Vector, int]:
    """The velocity of the other sphere by the momentum of both."""
    early = {name: scene.initial(name) for name in (body, other)}
    masses = {name: scene.mass(name) for name in (body, other)}
    sides: list[list[Expression]] = [[], []]
    whole = Vector(sp.Integer(0), sp.Integer(0))
    for sphere in scene.bodies(number):
        whole += early[sphere].value * masses[sphere].value
        if any(early[sphere].value):
            sides[0].append(product(tree_of(masses[sphere].value), tree_of(early[sphere].value)))
        velocity: Expression = Quantity("velocity", (Name(sphere),), number)
        if sphere == body:
            velocity = vector_tree(late[body])
        sides[1].append(product(tree_of(masses[sphere].value), velocity))
    refs = together(
        *(mass.refs for mass in masses.values()), *(e.refs for e in early.values()), (lines[body],)
    )
    left, right = (swept(total(side)) for side in sides)
    move = Move("law", "momentum-vector", number, scene.bodies(number))
    line = scene.desk.write(move, refs, chain(left, (right, None)))
    rest = whole - late[body] * masses[body].value
    value = Vector(*(tidy(expanded(component / masses[other].value)) for component in rest))
    own = Quantity("velocity", (Name(other),), number)
    return value, scene.desk.write(
        Move("rearrange"), (line,), chain(own, (vector_tree(value), None))
    )


def line_of_change(
    scene: Scene, number: int, late: dict[str, Vector], lines: dict[str, Ref]
) -> tuple[Vector, int]:
    """The line of centres along the change of a velocity: of who was at rest, if any."""
    body = next(
        (sphere for sphere in late if not any(scene.initial(sphere).value)), next(iter(late))
    )
    source = scene.initial(body)
    change = Vector(*(expanded(a - b) for a, b in zip(late[body], source.value, strict=True)))
    centres = Quantity("line_of_centres", (), number)
    own = scene.model.frames[number]
    is_found = not any(scene.unknown(value) for value in change)
    ahead = scene.model.sign(Vector(*map(scene.model.in_data, change)).dot(own.n))
    # Between spheres it points from the first to the second; into a wall, once it is known.
    back = ahead < 0 if own.wall is None else ahead > 0 and is_found
    axis: Expression = vector_tree(-late[body] if back else late[body])
    if any(source.value):
        early = tree_of(source.value)
        axis = Binary("-", early, vector_tree(late[body])) if back else Binary("-", axis, early)
    change = -change if back else change
    final = Relation(((Link(centres, "parallel to", vector_tree(change)),),))
    if is_found:
        final = Relation(((Link(centres, "parallel to", vector_tree(plain_direction(change))),),))
    first = Relation(((Link(centres, "parallel to", swept(axis)),),))
    is_one = final == first or alike(
        swept(axis), vector_tree(change)
    )  # in another order of terms it is the same line
    line = scene.desk.write(
        Move("law", "along-the-change", number, (body,)),
        together(source.refs, (lines[body],)),
        final if is_one else first,
    )
    return change, scene.desk.write(Move("rearrange"), (line,), final)


def restitution_along(
    scene: Scene,
    number: int,
    late: dict[str, Vector],
    lines: dict[str, Ref],
    change: Vector,
    axis: int,
) -> tuple[int, Relation]:
    """Newton's law by scalar products with the change of velocity, whose size cancels.

    Beside the line what it is with the relative velocities worked out.
    """
    e = scene.coefficient(number)
    refs = together(
        e.refs, *(scene.initial(sphere).refs for sphere in late), lines.values(), (axis,)
    )
    if len(late) == 1:
        (body,) = late
        gap, approach = late[body], -scene.initial(body).value
        move = Move("law", "restitution-wall", number, (body,))
    else:
        first, second = scene.bodies(number)
        early = {body: scene.initial(body).value for body in (first, second)}
        gap, approach = late[second] - late[first], early[first] - early[second]
        move = Move("law", "restitution", number, (first, second))
    left, right = (_product(vector, change) for vector in (gap, approach))
    final = chain(left, (swept(multiple(e.value, right)), None))
    if len(late) == 1:
        return scene.desk.write(move, refs, final), final
    # How fast they are, relative to each other, stands as a difference first.
    left = _product_of_difference((late[second], late[first]), change)
    right = _product_of_difference((early[first], early[second]), change)
    relation = chain(left, (swept(multiple(e.value, right)), None))
    return scene.desk.write(move, refs, relation), final


def _product_of_difference(pair: tuple[Vector, Vector], change: Vector) -> Expression:
    """The scalar product of the difference of two vectors with the change of velocity."""
    terms = []
    for one, other, by in zip(*pair, change, strict=True):
        one, other, by = (tidy(expanded(value)) for value in (one, other, by))
        if one == other or by == 0:
            continue
        if one == 0 or other == 0:
            terms.append(_product(Vector(one - other, sp.Integer(0)), Vector(by, sp.Integer(0))))
        else:
            terms.append(product(difference(tree_of(one), tree_of(other)), tree_of(by)))
    return total(terms) if terms else ZERO


def _product(a: Vector, b: Vector) -> Expression:
    """A scalar product, by components."""
    terms = []
    for x, y in zip(a, b, strict=True):
        one, other = (tidy(expanded(value)) for value in (x, y))
        if one == 0 or other == 0:
            continue
        if one.could_extract_minus_sign() and other.could_extract_minus_sign():
            one, other = -one, -other
        if one == other and one.is_Symbol:
            terms.append(square(tree_of(one)))
            continue
        tree = product(tree_of(abs(one) if one.is_number else one), tree_of(other))
        terms.append(negative(tree) if one.is_number and one < 0 else tree)
    return total(terms) if terms else ZERO
