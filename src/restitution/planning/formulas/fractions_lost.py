"""The fraction of its kinetic energy that a sphere loses, or keeps, without its mass."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, MoveId, Ref
from restitution.explaining.lines.trees import angles_with_both_ratios
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import Binary, Expression, Name, Quantity, walk
from restitution.planning.formulas.definitions import Formula, itself
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.velocity_formulas import is_root_of_a_sum, known_speed, squares
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import difference, square, swept, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene

# How a ratio comes to its last form.
_BY: tuple[MoveId, ...] = ("rearrange", "identity")


def fraction_lost(scene: Scene, asked: Expression, given: Ref | None = None) -> Formula | None:
    """The fraction of the kinetic energy that is lost, as the change of v² over that before.

    Where it is ``given``, the square of the speed before may hold what is sought, and a speed that
    comes of the fact tells no more.

    The change is that of the speed, where the last one is a line, or of the component at one
    impact. None of another quotient, of several spheres, and where one of the energies is asked
    by itself, or is a line.
    """
    match asked:
        case Binary(
            "/",
            Quantity(kind, (), int(event)) as lost,
            Quantity("energy", _, int(stage)) as before,
        ) if kind in LOSSES:
            pass
        case _:
            return None
    bodies = tuple(scene.model.story.spheres)
    if len(bodies) != 1 or event not in scene.model.frames:
        return None
    (body,) = bodies
    if stage != (0 if kind == "total_energy_lost" else event - 1):
        return None
    if any(
        scene.desk.known(quantity) is not None or quantity in scene.asked_alone
        for quantity in (lost, before)
    ):
        return None
    whole, size, refs = squares(scene, body, scene.last_event(body, stage), known=True)
    ends = _by_component(scene, body, event) if stage == event - 1 else None
    speed = known_speed(scene, body, event)
    if speed is not None and given in scene.desk.under(*speed.refs):
        speed = None
    if speed is not None and ends is not None and is_root_of_a_sum(speed.value):
        speed = None  # one component is shorter
    if speed is not None and not scene.unknown(speed.value) and (ends is None or ends[1].value):
        late, used = speed.value, speed.refs
        change, value = difference(whole, square(tree_of(late))), size - late**2
    elif ends is not None:
        change = difference(*(square(tree_of(end.value)) for end in ends))
        value, used = ends[0].value ** 2 - ends[1].value ** 2, _refs_of(scene, ends, event)
    else:
        return None
    move = Move("define", "energy-ratio", event, (body,))
    right = Binary("/", swept(change), whole)
    fraction = tidy(expanded(value / size))
    if angles_with_both_ratios((whole,)) and given is None:
        # By sin² + cos² = 1 it takes a line of its own; a quotient in the tangent does not.
        in_one = chain(asked, (right, None), (tree_of(fraction), "rearrange"))
        if not scene.judge.follows(move, together(refs, used), in_one):
            return None
    needed = scene.judge.needed(move, together(refs, used), chain(asked, (right, None)))
    if needed is None or (scene.unknown(size) and given is None):
        return None
    return Formula(move, itself, asked, right, fraction, needed)


def ratio_of_energies(scene: Scene, asked: Expression) -> Formula | None:
    """The kinetic energy of one body over what it was, as the ratio of the squares of its speeds.

    None of another quotient, and where the energies are asked besides, or are lines.
    """
    pair = _two_energies(asked)
    if pair is None:
        return None
    body, late, early = pair
    event = scene.last_event(body, late)
    if event not in scene.model.frames or scene.last_event(body, early) == event:
        return None
    used = {
        Quantity("energy", bodies, at) for bodies in ((), (Name(body),)) for at in (late, early)
    }
    if any(scene.desk.known(quantity) is not None for quantity in used):
        return None
    others = (tree for tree in scene.asked_alone if _two_energies(tree) is None)
    if any(used & set(walk(tree)) for tree in others):
        return None
    ends = [
        squares(scene, body, scene.last_event(body, stage), known=True) for stage in (late, early)
    ]
    (above, square_after, refs), (below, square_before, more) = ends
    if square_after == 0 or scene.unknown(square_after) or scene.unknown(square_before):
        return None
    move = Move("define", "energy-ratio", event, (body,))
    right = Binary("/", above, below)
    fraction = tidy(expanded(square_after / square_before))
    for by in _BY:
        whole = chain(asked, (right, None), (tree_of(fraction), by))
        needed = scene.judge.needed(move, together(refs, more), whole)
        if needed is not None:
            return Formula(move, itself, asked, right, fraction, needed)
    return None


def _two_energies(tree: Expression) -> tuple[str, int, int] | None:
    """The body of which an energy is divided by an earlier one, and both stages."""
    match tree:
        case Binary(
            "/",
            Quantity("energy", (Name(body),), int(late)),
            Quantity("energy", (Name(other),), int(early)),
        ) if body == other and late > early:
            return body, late, early
    return None


def _by_component(scene: Scene, body: str, event: int) -> tuple[Source, Source]:
    """The component along the line of an impact, before it and after it."""
    frame = scene.frame(event)
    first, last = (in_direction(scene, "along", body, k, frame) for k in (event - 1, event))
    return first, last


def _refs_of(scene: Scene, ends: tuple[Source, Source], event: int) -> tuple[Ref, ...]:
    """What two components along the line of an impact rest on, with the line itself."""
    return together(*(end.whole for end in ends), scene.frame(event).names_axis("along"))


__all__ = ["fraction_lost", "ratio_of_energies"]
