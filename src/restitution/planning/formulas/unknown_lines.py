"""What stays of a velocity at a wall, or beside a line of centres, of unknown letters.

Both velocities are resolved along a vector, of which the length does not matter.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Expression, Name, Quantity
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import negative, product, swept, total, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import over_its_root
from restitution.planning.writing.vectors import velocity_given
from restitution.vector import Vector


def law_by_vectors(scene: Scene, kind: str, body: str, frame: Frame) -> int | None:
    """The law of a component, along or across, as an equation for a direction in letters.

    None where the direction is no vector with unknown letters, or a velocity is none that is known.
    """
    shorter = over_its_root(frame.direction(kind))
    if shorter is None or not any(map(scene.unknown, shorter[0])):
        return None
    direction = _forwards(shorter[0]) if kind == "across" else shorter[0]
    early, late = _before(scene, body, frame.number), _after(scene, body, frame.number)
    if early is None or late is None:
        return None
    ends = [velocity.value.dot(direction) for velocity in (late, early)]
    if any(sp.sympify(end, strict=True).is_Symbol for end in ends):
        direction, ends = -direction, [-end for end in ends]  # −b = b − 2
    sides = [_product(source.value, direction) for source in (late, early)]
    pool = together(late.refs, early.refs, frame.refs)
    if kind == "across":
        move = Move("law", "unchanged", frame.number, (body,))
        if scene.unknown(ends[1]) and not scene.unknown(ends[0]):
            sides.reverse()
    else:
        move = Move("law", "restitution-wall", frame.number, (body,))
        e = scene.coefficient(frame.number)
        sides[1] = negative(product(tree_of(e.value), sides[1]))
        pool = together(pool, e.refs)
    relation = chain(sides[0], (sides[1], None))
    premises = scene.judge.needed(move, pool, relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def _forwards(direction: Vector) -> Vector:
    """A direction in the sense in which its first part is positive, as far as that is plain."""
    first = next((component for component in direction if component != 0), sp.Integer(1))
    return -direction if sp.sympify(first, strict=True).could_extract_minus_sign() else direction


def _product(velocity: Vector, direction: Vector) -> Expression:
    pairs = zip(velocity, direction, strict=True)
    return swept(total(product(tree_of(tidy(a)), tree_of(tidy(b))) for a, b in pairs if a != 0))


def _before(scene: Scene, body: str, number: int) -> Source | None:
    """A velocity of the data, or one that stands as a vector."""
    last = scene.last_event(body, number - 1)
    if last:
        return scene.desk.known(Quantity("velocity", (Name(body),), last))
    return scene.initial(body) if f"velocity {body}" in scene.facts else None


def _after(scene: Scene, body: str, number: int) -> Source | None:
    """A velocity after an impact that is given as a vector, or stands as one."""
    given = velocity_given(scene, body, number)
    if given is not None:
        return Source(given[1], given[2])
    return scene.desk.known(Quantity("velocity", (Name(body),), number))


__all__ = ["law_by_vectors"]
