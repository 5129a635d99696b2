"""Lines of centres, and walls, that are found with a velocity of which only the direction is known.

The velocity after the impact is a letter times a vector. The change of velocity is along the line,
and the law of restitution, by scalar products with that change, is an equation for the letter.
"""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Meaning, Move, Ref, Relation
from restitution.expression.tree import Binary, Expression, Letter, Name, Quantity, Unit, walk
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.planning.closing import close
from restitution.planning.desk import NotPlannedError, chain, together
from restitution.planning.forms import (
    ZERO,
    UnwrittenError,
    alike,
    negative,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.frames import Frame
from restitution.planning.impacts import plain_direction
from restitution.planning.named_angles import letters_taken
from restitution.planning.scene import GivenEquation, Scene
from restitution.solving.numbers import number_of
from restitution.vector import Vector

_LETTERS = ("s", "k", "b", "c", "q", "r")


@dataclass(frozen=True)
class _Ray:
    """What is known of a velocity: a letter for ``quantity`` times a vector, by a given fact."""

    body: str
    quantity: Quantity
    direction: Vector
    given: GivenEquation
    role: Role


def write_open_lines(scene: Scene) -> None:
    """Finds the lines of centres for which there is no other way, with the velocities after."""
    for number, own in scene.model.frames.items():
        known = f"axis {number}" in scene.facts or not own.by_values or own.angle is not None
        if known or number in scene.frames:
            continue
        standing = scene.desk.mark()
        try:
            scene.frame(number)
        except NotPlannedError:
            scene.desk.back(standing)
            others = scene.others
            try:
                if _by_a_ray(scene, number):
                    continue
            except (NotPlannedError, UnwrittenError):
                pass
            scene.desk.back(standing)
            scene.others = others
            scene.frames.pop(number, None)


def _by_a_ray(scene: Scene, number: int) -> bool:
    """Whether a velocity whose direction is given leads to the line: its lines are written."""
    spheres = scene.spheres(number)
    if any(scene.last_event(sphere, number - 1) for sphere in spheres):
        return False
    early = {sphere: scene.initial(sphere) for sphere in spheres}
    e = scene.coefficient(number)
    masses = {sphere: scene.mass(sphere) for sphere in spheres} if len(spheres) > 1 else {}
    values = [*(x for each in early.values() for x in each.value), e.value]
    if any(scene.unknown(x) for x in (*values, *(mass.value for mass in masses.values()))):
        return False
    ray = next(
        (own for sphere in spheres if (own := _ray(scene, sphere, number)) is not None), None
    )
    if ray is None:
        return False
    symbol, line = _written_ray(scene, number, ray)
    late = {ray.body: ray.direction * symbol}
    lines = {ray.body: line}
    for other in spheres:
        if other != ray.body:
            late[other], lines[other] = _by_momentum(scene, number, ray.body, late, lines, other)
    change, axis = _axis(scene, number, late, lines)
    number_ = _restitution(scene, number, late, lines, change, axis)
    close(scene, number_, symbol)
    _settle(scene, number, late, lines, change, axis)
    return True


def _ray(scene: Scene, body: str, number: int) -> _Ray | None:
    """The direction of a velocity after an impact, as far as it is given."""
    velocity = Quantity("velocity", (Name(body),), number)
    for each in scene.given:
        match each.link:
            case Link(Quantity("direction", (Name(name),), event), "=", angle) if (
                name == body and event == number
            ):
                turn = scene.scalar(angle)
                if turn.free_symbols:
                    continue
                direction = Vector(tidy(sp.cos(turn)), tidy(sp.sin(turn)))
                return _Ray(
                    body, Quantity("speed", (Name(body),), number), direction, each, POSITIVE
                )
            case Link(left, "parallel to" | "perpendicular to" as sign, other) if velocity in (
                left,
                other,
            ):
                tree = other if left == velocity else left
                if any(isinstance(node, Quantity) for node in walk(tree)):
                    continue
                direction = scene.model.story.direction(tree, scene.events)
                if sign == "perpendicular to":
                    direction = direction.turned_left()
                # Along i and j the letter is a component.
                if direction.x == 0 or direction.y == 0:
                    unit: Expression = Unit("j" if direction.x == 0 else "i")
                    along = Vector(*(sp.Integer(0 if x == 0 else 1) for x in direction))
                    return _Ray(body, Quantity("along", (velocity, unit)), along, each, REAL)
    return None


def _written_ray(scene: Scene, number: int, ray: _Ray) -> tuple[sp.Symbol, int]:
    """The letter of such a velocity, and the line that gives the velocity by it."""
    taken = letters_taken(scene)
    name = next(each for each in _LETTERS if each not in taken)
    symbol = ray.role.symbol(name)
    scene.model.unknowns.roles = {**scene.model.unknowns.roles, name: ray.role}
    for model in {id(each): each for each in (scene.model, *scene.others)}.values():
        final = model.branch.story.velocity(ray.body, number)
        value = tidy(final.dot(ray.direction))
        model.final[symbol] = value
        model.sample[name] = number_of(model.number(value))
    let = scene.desk.write(Move("let"), (), Meaning(name, ray.quantity))
    velocity = Quantity("velocity", (Name(ray.body),), number)
    refs: tuple[Ref, ...] = (*ray.given.refs, let)
    if ray.quantity.kind == "along":
        other = Unit("i" if ray.direction.x == 0 else "j")
        nothing = scene.desk.write(
            Move("define", "parallel" if ray.given.link.sign == "parallel to" else "perpendicular"),
            ray.given.refs,
            chain(Quantity("along", (velocity, other)), (ZERO, None)),
        )
        refs = (let, nothing)
    line = scene.desk.write(
        Move("define", "assemble", number, (ray.body,)),
        refs,
        chain(velocity, (_tree(ray.direction * symbol), None)),
    )
    return symbol, line


def _tree(value: Vector) -> Expression:
    return tree_of(Vector(*(tidy(sp.expand(each)) for each in value)))


def _by_momentum(
    scene: Scene, number: int, body: str, late: dict[str, Vector], lines: dict[str, int], other: str
) -> tuple[Vector, int]:
    """The velocity of the other sphere by the momentum of both."""
    early = {each: scene.initial(each) for each in (body, other)}
    masses = {each: scene.mass(each) for each in (body, other)}
    sides: list[list[Expression]] = [[], []]
    whole = Vector(sp.Integer(0), sp.Integer(0))
    for each in scene.bodies(number):
        whole += early[each].value * masses[each].value
        if any(early[each].value):
            sides[0].append(product(tree_of(masses[each].value), tree_of(early[each].value)))
        velocity: Expression = Quantity("velocity", (Name(each),), number)
        if each == body:
            velocity = _tree(late[body])
        sides[1].append(product(tree_of(masses[each].value), velocity))
    refs = together(
        *(mass.refs for mass in masses.values()), *(e.refs for e in early.values()), (lines[body],)
    )
    left, right = (swept(total(side)) for side in sides)
    move = Move("law", "momentum-vector", number, scene.bodies(number))
    line = scene.desk.write(move, refs, chain(left, (right, None)))
    rest = whole - late[body] * masses[body].value
    value = Vector(*(tidy(sp.expand(each / masses[other].value)) for each in rest))
    own = Quantity("velocity", (Name(other),), number)
    return value, scene.desk.write(Move("rearrange"), (line,), chain(own, (_tree(value), None)))


def _axis(
    scene: Scene, number: int, late: dict[str, Vector], lines: dict[str, int]
) -> tuple[Vector, int]:
    """The line of centres along the change of a velocity: of who was at rest, if any."""
    body = next((each for each in late if not any(scene.initial(each).value)), next(iter(late)))
    source = scene.initial(body)
    change = Vector(*(sp.expand(a - b) for a, b in zip(late[body], source.value, strict=True)))
    axis: Expression = _tree(late[body])
    if any(source.value):
        axis = Binary("-", axis, tree_of(source.value))
    centres = Quantity("line_of_centres", (), number)
    final = Relation(((Link(centres, "parallel to", _tree(change)),),))
    first = Relation(((Link(centres, "parallel to", swept(axis)),),))
    is_one = alike(swept(axis), _tree(change))  # in another order of terms it is the same line
    line = scene.desk.write(
        Move("law", "along-the-change", number, (body,)),
        together(source.refs, (lines[body],)),
        final if is_one else first,
    )
    return change, scene.desk.write(Move("rearrange"), (line,), final)


def _restitution(
    scene: Scene,
    number: int,
    late: dict[str, Vector],
    lines: dict[str, int],
    change: Vector,
    axis: int,
) -> int:
    """Newton's law by scalar products with the change of velocity, whose size cancels."""
    e = scene.coefficient(number)
    refs = together(e.refs, *(scene.initial(each).refs for each in late), lines.values(), (axis,))
    if len(late) == 1:
        (body,) = late
        gap, approach = late[body], -scene.initial(body).value
        move = Move("law", "restitution-wall", number, (body,))
    else:
        first, second = scene.bodies(number)
        gap = late[second] - late[first]
        approach = scene.initial(first).value - scene.initial(second).value
        move = Move("law", "restitution", number, (first, second))
    left, right = (_product(each, change) for each in (gap, approach))
    if e.value == 1:
        whole = right
    else:
        whole = product(tree_of(e.value), right)
    return scene.desk.write(move, refs, chain(left, (swept(whole), None)))


def _product(a: Vector, b: Vector) -> Expression:
    """A scalar product, by components."""
    terms = []
    for x, y in zip(a, b, strict=True):
        one, other = (tidy(sp.expand(each)) for each in (x, y))
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


def _settle(
    scene: Scene,
    number: int,
    late: dict[str, Vector],
    lines: dict[str, int],
    change: Vector,
    axis: int,
) -> None:
    """The velocities and the line with what has been found."""
    known: dict[str, Ref] = {}
    for body, value in late.items():
        put, refs = scene.put(value)
        velocity = Quantity("velocity", (Name(body),), number)
        line: Ref = lines[body]
        if refs:
            line = scene.desk.write(Move("put"), (line, *refs), chain(velocity, (_tree(put), None)))
        scene.desk.know(velocity, Vector(*(tidy(sp.expand(each)) for each in put)), (line,))
        known[body] = line
    put, refs = scene.put(change)
    centres = Quantity("line_of_centres", (), number)
    own = scene.model.frames[number]
    plain = plain_direction(put)
    n = own.n if scene.model.sign(plain.dot(own.n)) > 0 else -own.n
    line = axis
    if refs:
        line = scene.desk.write(
            Move("put"),
            (axis, *refs),
            Relation(((Link(centres, "parallel to", _tree(put)),),)),
        )
    if _tree(put) != _tree(plain):
        line = scene.desk.write(
            Move("rearrange"),
            (line,),
            Relation(((Link(centres, "parallel to", _tree(plain)),),)),
        )
    scene.desk.know(centres, plain, (line,))
    sign = 1 if scene.model.sign(n.dot(own.n)) > 0 else -1
    scene.frames[number] = Frame(number, own.wall, centres, None, n, n.turned_left(), (line,), sign)
    for body, ref in known.items():
        symbol = scene.model.components[number, body].symbol
        scene.desk.know(Letter(symbol.name), scene.model.final[symbol], (ref, line))
