"""The fraction of its kinetic energy that a sphere loses, or keeps, without its mass."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import product

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, MoveId, Ref
from restitution.explaining.lines.trees import angles_with_both_ratios
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import Binary, Expression, Name, Quantity, walk
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.energy_formulas import given_speed, stands
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.velocity_formulas import is_root_of_a_sum, known_speed, squares
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import difference, number, square, swept, total, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene

_PAIR = 2
# How a ratio comes to its last form.
_BY: tuple[MoveId, ...] = ("rearrange", "identity")


def fraction_lost(scene: Scene, asked: Expression, given: Ref | None = None) -> Formula | None:
    """The fraction of the kinetic energy that is lost, as the change of v² over that before.

    Where it is ``given``, the square of the speed before may hold what is sought, and a speed that
    comes of the fact tells no more.

    The change is that of the speed, where the last one is a line, or of the component at one
    impact, or of the speed by its components after several. Fractions of the same energy that each
    of several impacts takes are added where they are lines. None of another quotient, of several
    spheres, and where one of the energies is asked by itself, or is a line.
    """
    share = _loss_and_energy(scene, asked)
    if share is None:
        return None
    body, lost, before = share
    event, stage = lost.stage, before.stage
    assert isinstance(event, int)
    assert isinstance(stage, int)
    if any(
        scene.desk.known(quantity) is not None or quantity in scene.asked_alone
        for quantity in (lost, before)
    ):
        return None
    move = Move("define", "energy-ratio", event, (body,))
    kept = [
        Binary("/", late, early) for late, early in product(*_energies(scene, body, event, stage))
    ]
    first = 1 if lost.kind == "total_energy_lost" else event
    own = _rest(scene, asked, kept if stage == first - 1 else (), move)
    if lost.kind == "total_energy_lost":
        own = own or _sum_of_fractions(scene, asked, move)
    if own is not None:
        return own
    whole, size, refs = squares(scene, body, scene.last_event(body, stage), known=True)
    changed = _change_of_squares(scene, body, lost, stage, (whole, size), given)
    if changed is None:
        return None
    change, value, used = changed
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


def share_by_given_speed(scene: Scene, asked: Expression) -> int | None:
    """The line of the fraction lost, where the speed after an impact is given; None where not."""
    share = _loss_and_energy(scene, asked)
    if share is None or scene.desk.known(asked) is not None:
        return None
    body, lost, _ = share
    assert isinstance(lost.stage, int)
    if given_speed(scene, body, lost.stage) is None or stands(scene, body, lost.stage):
        return None
    own = fraction_lost(scene, asked)
    if own is None or scene.unknown(own.value):
        return None
    return write_formula(scene, own)


def _loss_and_energy(scene: Scene, asked: Expression) -> tuple[str, Quantity, Quantity] | None:
    """The only sphere, what it loses and the energy before, of a fraction of its energy."""
    match asked:
        case Binary(
            "/",
            Quantity(kind, (), int(event)) as lost,
            Quantity("energy", _, int(stage)) as before,
        ) if kind in LOSSES:
            bodies = tuple(scene.model.story.spheres)
            first = event if kind == "energy_lost" else 1  # the first impact that counts
            if len(bodies) == 1 and event in scene.model.frames and stage < first:
                return bodies[0], lost, before
    return None


def _energies(
    scene: Scene, body: str, late: int, early: int
) -> tuple[list[Quantity], list[Quantity]]:
    """What the energy of a body is called at two stages: that of all too, if there is no other."""
    alone = tuple(scene.model.story.spheres) == (body,)
    own = [(), (Name(body),)] if alone else [(Name(body),)]
    after, before = ([Quantity("energy", bodies, at) for bodies in own] for at in (late, early))
    return after, before


def _rest(
    scene: Scene, asked: Expression, others: Iterable[Expression], move: Move
) -> Formula | None:
    """A share of an energy as what another one, which is a line, leaves; None without a line."""
    for other in others:
        known = scene.desk.known(other)
        if known is None:
            continue
        value, more = scene.put(known.value)
        if scene.unknown(value):
            continue
        right = difference(number(1), tree_of(value))
        refs = together(known.refs, more)
        needed = scene.judge.needed(move, refs, chain(asked, (right, None)))
        if needed is not None:
            return Formula(move, itself, asked, right, tidy(expanded(1 - value)), needed)
    return None


def _sum_of_fractions(scene: Scene, asked: Expression, move: Move) -> Formula | None:
    """What all impacts take of an energy, by the fraction that each takes; None without lines."""
    assert isinstance(asked, Binary)
    assert move.event is not None
    own: list[Source] = []
    for event in range(1, move.event + 1):
        known = scene.desk.known(Binary("/", Quantity("energy_lost", (), event), asked.right))
        if known is None:
            return None
        value, more = scene.put(known.value)
        own.append(Source(value, together(known.refs, more)))
    if len(own) < _PAIR or any(scene.unknown(source.value) for source in own):
        return None
    right = total(tree_of(source.value) for source in own)
    value = tidy(expanded(sum(source.value for source in own)))
    refs = together(*(source.refs for source in own))
    needed = scene.judge.needed(move, refs, chain(asked, (right, None)))
    return None if needed is None else Formula(move, itself, asked, right, value, needed)


def _change_of_squares(
    scene: Scene,
    body: str,
    lost: Quantity,
    stage: int,
    before: tuple[Expression, sp.Expr],
    given: Ref | None,
) -> tuple[Expression, sp.Expr, tuple[Ref, ...]] | None:
    """What the square of the speed loses, as a tree and as a value, and what says so.

    ``before`` is the square of the speed at a stage, as a tree and as a value.
    """
    event = lost.stage
    assert isinstance(event, int)
    whole, size = before
    at_one = lost.kind == "energy_lost" or event == 1
    ends = _by_component(scene, body, event) if at_one else None
    speed = known_speed(scene, body, event) if not at_one or stage == event - 1 else None
    if (
        speed is not None
        and given is not None
        and (given in scene.desk.under(*speed.refs) or not scene.unknown(size - speed.value**2))
    ):
        speed = None
    if speed is not None and ends is not None and is_root_of_a_sum(speed.value):
        speed = None  # one component is shorter
    if speed is not None and not scene.unknown(speed.value) and (ends is None or ends[1].value):
        speed = _in_values(scene, Quantity("speed", (Name(body),), event), speed)
        return difference(whole, square(tree_of(speed.value))), size - speed.value**2, speed.refs
    if ends is not None:
        change = difference(*(square(tree_of(end.value)) for end in ends))
        return change, ends[0].value ** 2 - ends[1].value ** 2, _refs_of(scene, ends, event)
    late, value, refs = squares(scene, body, event)
    if given is not None or scene.unknown(value):
        return None
    return difference(whole, late), size - value, refs


def _in_values(scene: Scene, quantity: Quantity, speed: Source) -> Source:
    """A speed by a line of its own, where letters in the one that stands have values by now."""
    known = scene.desk.known(quantity)
    if known is None or known.value == speed.value:
        return speed
    refs = tuple(dict.fromkeys((*known.refs, *speed.refs)))  # first the line, then what is put in
    relation = chain(quantity, (tree_of(speed.value), None))
    line = scene.judge.write((Move("put"),), refs, relation)
    return speed if line is None else Source(speed.value, (line,))


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
    energies = _energies(scene, body, late, early)
    used = {*energies[0], *energies[1]}
    if any(scene.desk.known(quantity) is not None for quantity in used):
        return None
    others = (
        tree
        for tree in scene.asked_alone
        if _two_energies(tree) is None and _loss_and_energy(scene, tree) is None
    )
    if any(used & set(walk(tree)) for tree in others):
        return None
    move = Move("define", "energy-ratio", event, (body,))
    kinds = [kind for kind in LOSSES if early == (event - 1 if kind == "energy_lost" else 0)]
    lost = [
        Binary("/", Quantity(kind, (), event), before) for kind in kinds for before in energies[1]
    ]
    if len(energies[0]) > 1 and (rest := _rest(scene, asked, lost, move)) is not None:
        return rest
    ends = [
        squares(scene, body, scene.last_event(body, stage), known=True) for stage in (late, early)
    ]
    (above, square_after, refs), (below, square_before, more) = ends
    if square_after == 0 or scene.unknown(square_after) or scene.unknown(square_before):
        return None
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


__all__ = ["fraction_lost", "ratio_of_energies", "share_by_given_speed"]
