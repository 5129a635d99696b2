"""Blows: the velocity of a body after an impulse that is given."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.derivation import Move
from restitution.expression.tree import Name, Quantity
from restitution.planning.desk import NotPlannedError, Source, chain, together
from restitution.planning.forms import difference, product, swept, tree_of
from restitution.planning.resolving import along_axis
from restitution.planning.scene import Scene
from restitution.problem import Kick
from restitution.vector import Vector


def write_blows(scene: Scene) -> None:
    """Writes the velocities after blows, as far as all is known on which they rest."""
    for number in range(1, scene.events + 1):
        step = scene.model.happening(number).step
        if not isinstance(step, Kick):
            continue
        quantity = Quantity("velocity", (Name(step.body),), number)
        if scene.desk.known(quantity) is None:
            velocities = [scene.velocity(step.body, each) for each in (number - 1, number)]
            if not any(scene.unknown(each) for each in velocities):
                _write_blow(scene, step.body, number, quantity)


def _write_blow(scene: Scene, body: str, number: int, quantity: Quantity) -> Source:
    """``I = m(v - u)`` as vectors, and the velocity after it."""
    impulse, mass = scene.data(f"impulse {number}"), scene.mass(body)
    early = velocity_before(scene, body, number)
    pairs = zip(early.value, impulse.value, strict=True)
    value = Vector(*(tidy(a + b / mass.value) for a, b in pairs))
    move = Move("law", "impulse-vector", number, (body,))
    refs = together(mass.refs, early.refs, impulse.refs)
    change = swept(product(tree_of(mass.value), difference(quantity, tree_of(early.value))))
    if change == quantity:
        # Of a mass of 1 at rest the impulse is the velocity.
        line = scene.desk.write(move, refs, chain(quantity, (tree_of(value), None)))
        return scene.desk.know(quantity, value, (line,))
    law = scene.desk.write(move, refs, chain(tree_of(impulse.value), (change, None)))
    line = scene.desk.write(Move("rearrange"), (law,), chain(quantity, (tree_of(value), None)))
    return scene.desk.know(quantity, value, (line,))


def velocity_before(scene: Scene, body: str, number: int) -> Source:
    """A velocity before an event, as a vector."""
    last = scene.last_event(body, number - 1)
    known = scene.desk.known(Quantity("velocity", (Name(body),), last))
    if known is not None:
        return known
    if last == 0:
        initial = scene.initial(body)
        value, refs = scene.put(initial.value)
        return Source(value, together(initial.refs, refs))
    x, y = (along_axis(scene, body, last, axis) for axis in ("i", "j"))
    if any(scene.unknown(each.value) for each in (x, y)):
        raise NotPlannedError(f"the velocity of {body} before event {number}")
    return Source(Vector(x.value, y.value), together(x.whole, y.whole))
