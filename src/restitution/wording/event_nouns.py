"""What happens in an event, as a noun phrase: impulses, energies lost, lines of centres."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    Quantity,
    name_of,
)
from restitution.problem import Impact, Kick
from restitution.wording.moments import during, event_number, in_event
from restitution.wording.noun_phrases import (
    Noun,
    of_bodies,
)
from restitution.wording.scene import Scene, event_name
from restitution.wording.structure import Emphasis, Words
from restitution.wording.words import names, words


def lost_where(scene: Scene, lost: Quantity) -> Words:
    """Where energy is lost, with a blank in front."""
    if lost.kind == "total_energy_lost":
        return (" altogether",) if len(scene.events) > 1 else ()
    where = during(scene, event_number(scene, lost))
    return words(" ", where) if where else ()


def of_an_event(scene: Scene, tree: Quantity) -> Noun:
    """What is said of bodies in an event."""
    named = [name_of(argument) or "" for argument in tree.arguments]
    where = in_event(scene, event_number(scene, tree, named[0] if named else None))
    if len(named) == 1:
        return Noun(of_bodies(tree.kind, named), where, tree.kind, named[0])
    return Noun(of_several(tree.kind, "", named), where)


def of_several(kind: str, initial: str, bodies: Sequence[str]) -> Words:
    """``the distance between A and B``, ``the total momentum``: one quantity of them together."""
    record = KINDS[kind]
    if not bodies:
        return (f"the {initial}{record.called_of_all}",)
    return words(f"the {initial}{record.called()} {record.link} ", names(bodies))


def impulse(scene: Scene, tree: Quantity) -> Noun:
    """``the impulse on A``; of a kick by what it is called."""
    body = name_of(tree.arguments[0]) if tree.arguments else None
    number = event_number(scene, tree, body)
    event = scene.events[number - 1] if number else None
    if isinstance(event, Kick):
        size = "" if body else "the magnitude of "
        alone = sum(isinstance(event, Kick) for event in scene.events) == 1
        on = (" on ", Emphasis(event.body)) if alone else ()
        return Noun(words(size, event_name(scene, number), on))
    where = during(scene, number)
    if body is not None:
        return Noun(words("the impulse on ", Emphasis(body)), where)
    return Noun(("the magnitude of the impulse",), where)


def energy_of_all(scene: Scene, initial: str) -> Words:
    """``the total kinetic energy``; that of the only sphere by its name."""
    if len(scene.problem.spheres) == 1:
        (only,) = scene.problem.spheres
        return words(f"the {initial}kinetic energy of ", Emphasis(only.name))
    return (f"the {initial}total kinetic energy",)


def energy_lost(scene: Scene, tree: Quantity) -> Noun:
    """``the kinetic energy lost in the impact``."""
    number = event_number(scene, tree)
    return Noun(("the kinetic energy lost",), during(scene, number))


def total_energy_lost(scene: Scene, tree: Quantity) -> Noun:
    """``the total kinetic energy lost``, up to an event that is not the last."""
    number = scene.stage(tree.stage, None)
    if len(scene.events) <= 1 or number == len(scene.events):
        return Noun(("the total kinetic energy lost",))
    return Noun(
        words("the total kinetic energy lost up to and including ", event_name(scene, number))
    )


def line_of_centres(scene: Scene, tree: Quantity) -> Noun:
    """As something asked for: a unit vector with its sense."""
    number = event_number(scene, tree)
    event = scene.events[number - 1] if number else None
    if not isinstance(event, Impact):
        return Noun(("the line of centres",))
    where = in_event(scene, number)
    if scene.is_wall(event.second):
        return Noun(
            words(
                "the unit vector perpendicular to ", Emphasis(event.second), " and directed into it"
            )
        )
    towards = words(" from ", Emphasis(event.first), " to ", Emphasis(event.second))
    return Noun(words("the unit vector along the line of centres", towards), where)
