"""A second velocity after an impact, by the momentum of both spheres as vectors."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import Expression, Letter, Name, Polar, Quantity, walk
from restitution.planning.axes.by_changes import take_impulse, take_known_impulse, take_opposite
from restitution.planning.formulas.definitions import Formula, itself, write_formula
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import product, swept, total, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def write_by_momentum(scene: Scene, asked: Expression) -> Quantity | None:
    """The velocity under what is asked, by the momentum of both spheres; None where none is."""
    velocity = _velocity_under(scene, asked)
    if velocity is None or not _is_by_momentum(scene, velocity):
        return None
    return velocity


def _velocity_under(scene: Scene, asked: Expression) -> Quantity | None:
    """The velocity that is asked, or that of the sphere whose speed, energy or direction is.

    The latter only where the velocity of the other sphere is given.
    """
    match asked:
        case Quantity("velocity"):
            return asked
        case Quantity("speed" | "energy" | "direction" | "deflection", (Name(body),), int(stage)):
            pass
        case _:
            return None
    last = scene.last_event(body, stage)
    if not last or len(scene.spheres(last)) != len(scene.bodies(last)):
        return None
    others = (own for own in scene.bodies(last) if own != body)
    if not any(_is_given(scene, Quantity("velocity", (Name(own),), last)) for own in others):
        return None
    return Quantity("velocity", (Name(body),), last)


def _is_by_momentum(scene: Scene, velocity: Quantity) -> bool:
    """Whether a second velocity after a slanting impact is written by momentum as vectors.

    Nothing is written, and False returned, where the velocities are not vectors that are known.
    """
    if not isinstance(velocity.stage, int):
        return False
    body, stage = body_and_stage(scene, velocity)
    own = Quantity("velocity", (Name(body),), stage)
    if stage not in scene.model.frames or scene.desk.known(own) is not None:
        return False
    if take_known_impulse(scene, body, stage) or _by_opposite_impulse(scene, body, stage):
        return True
    component = scene.model.components.get((stage, body))
    if component is not None and scene.desk.known(Letter(component.symbol.name)) is not None:
        return False  # it is put together of what stands
    if _component_is_wanted(scene, body, stage):
        return False
    try:
        frame = scene.frame(stage)
    except NotPlannedError:
        return False  # the line of centres comes with what is asked
    if (
        frame.wall is not None
        or 0 in frame.n
        or not all(component.is_number for component in frame.n)
    ):
        return False
    (other,) = (sphere for sphere in scene.spheres(stage) if sphere != body)
    rested = not scene.last_event(body, stage - 1) and not any(scene.initial(body).value)
    if rested and not _is_given(scene, Quantity("velocity", (Name(other),), stage)):
        return False  # it moves off along the line of centres
    after = velocity_as_vector(scene, other, stage) or _by_impulse(scene, other, stage)
    before = [velocity_as_vector(scene, body, stage - 1) for body in scene.bodies(stage)]
    if after is None or None in before:
        return False
    masses = {sphere: scene.mass(sphere) for sphere in (body, other)}
    whole = [(masses[n], v) for n, v in zip(scene.bodies(stage), before, strict=True) if v]
    values = [source.value for pair in ((*masses.values(), after), *whole) for source in pair]
    if any(scene.unknown(x) or scene.put(x)[1] for x in values):
        return False
    sums = [
        sum(m.value * v.value[n] for m, v in whole) - masses[other].value * after.value[n]
        for n in (0, 1)
    ]
    late = Vector(*(tidy(momentum / masses[body].value) for momentum in sums))
    left = total(product(tree_of(m.value), tree_of(v.value)) for m, v in whole if any(v.value))
    right = total(
        (
            product(tree_of(masses[other].value), tree_of(after.value)),
            product(tree_of(masses[body].value), own),
        )
    )
    refs = together(*(m.refs for m in masses.values()), *(v.refs for _, v in whole), after.refs)
    move = Move("law", "momentum-vector", stage, scene.bodies(stage))
    line = scene.desk.write(move, refs, chain(swept(left), (swept(right), None)))
    line = scene.desk.write(Move("rearrange"), (line,), chain(own, (tree_of(late), None)))
    scene.desk.know(own, late, (line,))
    return True


def write_total_kept(scene: Scene, momentum: Quantity) -> bool:
    """The momentum of all spheres after the first impact, by that before, which is data.

    Nothing is written, and False returned, where that impact is no impact of two spheres.
    """
    kept = momentum.kind == "momentum" and not momentum.arguments and momentum.stage == 1
    if not kept or 1 not in scene.model.frames or scene.model.frames[1].wall is not None:
        return False
    if scene.desk.known(momentum) is not None:
        return False
    refs: list[Ref] = []
    terms: list[Expression] = []
    value = Vector(sp.Integer(0), sp.Integer(0))
    for body in scene.model.story.spheres:
        early, mass = scene.initial(body), scene.mass(body)
        moves = any(early.value)
        if scene.unknown(early.value) or (moves and scene.unknown(mass.value)):
            return False
        refs += (*early.refs, *(mass.refs if moves else ()))
        if moves:
            terms.append(product(tree_of(mass.value), tree_of(early.value)))
            value = value + early.value * mass.value
    whole = Vector(*(tidy(expanded(component)) for component in value))
    move = Move("law", "momentum-vector", 1, scene.bodies(1))
    own = Formula(move, itself, momentum, total(terms), whole, together(refs))
    return scene.judge.follows(move, own.refs, chain(momentum, (swept(own.right), None))) and bool(
        write_formula(scene, own)
    )


def _is_given(scene: Scene, quantity: Quantity) -> bool:
    """Whether an equation of the statement says what a quantity is."""
    links = (equation.link for equation in scene.given)
    return any(link.sign == "=" and link.left == quantity for link in links)


def _component_is_wanted(scene: Scene, body: str, stage: int) -> bool:
    """Whether the part asks for what the component along the line of centres tells.

    Then that is worked out once, and the velocity is put together of it.
    """
    if any(body in scene.bodies(event) for event in range(stage + 1, scene.events + 1)):
        return True
    velocity = Quantity("velocity", (Name(body),), stage)
    others = [Quantity("velocity", (Name(o),), stage) for o in scene.bodies(stage) if o != body]
    is_given = any(_is_given(scene, other) for other in others)
    for tree in scene.asked:
        match tree:
            # Beside a velocity that is given the components are not worked out for the laws.
            case Quantity("energy_lost", (), int(event)) if event == stage and not is_given:
                return True
            case Quantity("total_energy_lost", (), 1) if stage == 1 and not is_given:
                return True  # that of the one impact
            case Quantity("along" | "across", (one, _)) if one == velocity:
                return True
            case Quantity("angle", (one, Quantity("line_of_centres"))) if one == velocity:
                return True
    return False


def _by_opposite_impulse(scene: Scene, body: str, stage: int) -> bool:
    """Whether a velocity is written by the impulse on the other sphere, whose own start is sought.

    Not where the velocity before is sought, or the impulse holds what is open.
    """
    others = [sphere for sphere in scene.spheres(stage) if sphere != body]
    if any(map(scene.unknown, scene.velocity(body, stage - 1))):
        return False
    if any(f"velocity {sphere}" in scene.facts for sphere in others):
        return False
    impulses = [Quantity("impulse", (Name(sphere),), stage) for sphere in others]
    for equation in scene.given:
        if equation.link.left in impulses and equation.link.sign == "=":
            if any(map(scene.unknown, scene.vector(equation.link.right))):
                return False
            return take_opposite(scene, equation) is not None
    return False


def _by_impulse(scene: Scene, body: str, stage: int) -> Source | None:
    """A velocity after an impulse on the sphere that is given as a vector."""
    impulse = Quantity("impulse", (Name(body),), stage)
    for equation in scene.given:
        if equation.link.left != impulse or equation.link.sign != "=":
            continue
        if scene.unknown(scene.mass(body).value) or scene.last_event(body, stage - 1):
            return None
        take_impulse(scene, equation)
        return scene.desk.known(Quantity("velocity", (Name(body),), stage))
    return None


def velocity_as_vector(scene: Scene, body: str, stage: int) -> Source | None:
    """A velocity that is a vector of the data, of a given fact, or of a line; None of another."""
    last = scene.last_event(body, stage)
    if not last:
        if f"velocity {body}" not in scene.facts:
            return None
        (link,) = scene.facts[f"velocity {body}"].relation.only
        source = scene.initial(body)
        if any(isinstance(node, Polar) for node in walk(link.right)) and all(source.value):
            return None
        return source
    known = scene.desk.known(Quantity("velocity", (Name(body),), last))
    if known is not None:
        return known
    quantity = Quantity("velocity", (Name(body),), last)
    for equation in scene.given:
        if equation.link.sign == "=" and equation.link.left == quantity:
            return Source(scene.vector(equation.link.right), (equation.fact.id,))
    return None
