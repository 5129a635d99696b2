"""A velocity after an impact by that before it, and its change along a line that slants."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Expression, Name, Negate, Polar, Quantity, Unit, walk
from restitution.planning.formulas.definitions import Formula, itself
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import difference, negative, product, total, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import unit_tree, whole_direction
from restitution.vector import Vector


def by_change_along(scene: Scene, body: str, stage: int, frame: Frame) -> Formula | None:
    """A velocity as **u** + (change along **n**)**n**, which needs no component across the line.

    None where that component stands already or is wanted, where the line is along **i** or **j**
    or its direction has letters, and where the velocity before is no vector of data or of a line.
    """
    if stage not in scene.model.frames or not frame.is_slanted:
        return None
    if not all(component.is_number for component in frame.n):
        return None
    for sphere in scene.spheres(stage):
        beside = scene.desk.known(frame.component("across", sphere, stage))
        if beside is not None and (sphere == body or beside.value != 0):
            return None
    if _across_is_wanted(scene, body, stage, frame):
        return None
    early = vector_before(scene, body, stage)
    if early is None or not any(early.value) or tidy(early.value.dot(frame.t)) == 0:
        return None
    try:
        first, last = (in_direction(scene, "along", body, k, frame) for k in (stage - 1, stage))
    except NotPlannedError:
        return None
    change = tidy(last.value - first.value)
    if change == 0 or last.value == 0 or scene.unknown(change):
        return None  # who has no component then moves at right angles to the line
    terms = [tree_of(last.value), negative(tree_of(first.value))]
    terms.sort(key=lambda term: isinstance(term, Negate))
    back = scene.model.sign(scene.model.in_data(change)) < 0
    size = difference(tree_of(first.value), tree_of(last.value)) if back else total(terms)
    step = product(size, unit_tree(frame.n))
    right: Expression = total((tree_of(early.value), negative(step) if back else step))
    value = Vector(
        *(tidy(expanded(a + change * n)) for a, n in zip(early.value, frame.n, strict=True))
    )
    quantity = Quantity("velocity", (Name(body),), stage)
    move = Move("law", "changed-velocity", stage, (body,))
    pool = together(early.refs, last.whole, first.whole, frame.refs)
    refs = scene.judge.needed(move, pool, chain(quantity, (right, None)), early.refs)
    if refs is None:
        return None
    whole, length = whole_direction(frame.n)
    once = product(tree_of(tidy((-change if back else change) / length)), tree_of(whole))
    between = (
        total((tree_of(early.value), negative(once) if back else once)) if first.value else None
    )
    return Formula(move, itself, quantity, right, value, refs, between)


def _across_is_wanted(scene: Scene, body: str, stage: int, frame: Frame) -> bool:
    """Whether it is asked how fast a body goes along a wall, or across the line of centres.

    Or whether it is wanted for the next way of a body along a circular wall.
    """
    later = any(body in scene.bodies(index) for index in range(stage + 1, scene.events + 1))
    if later and circle_of(scene, stage) is not None:
        return True
    velocity = Quantity("velocity", (Name(body),), stage)
    for tree in scene.asked:
        match tree:
            case Quantity("along" | "across" | "dot", (one, axis)) if velocity in (one, axis):
                if frame.along in (one, axis) or not {Unit("i"), Unit("j")} & {one, axis}:
                    return True
            case Quantity("angle", (one, other)) if velocity in (one, other):
                if not {Unit("i"), Unit("j")} & {one, other}:
                    return True
    return False


def vector_before(scene: Scene, body: str, stage: int) -> Source | None:
    """A velocity just before an impact as a vector of the data, or of a line; None of another."""
    last = scene.last_event(body, stage - 1)
    if last:
        known = scene.desk.known(Quantity("velocity", (Name(body),), last))
        if known is None:
            return None
        value, refs = scene.put(known.value)
        return None if refs or scene.unknown(value) else known
    fact = scene.facts.get(f"velocity {body}")
    if fact is None or len(fact.relation.options) > 1:
        return None
    source = scene.initial(body)
    if scene.unknown(source.value) or scene.put(source.value)[1]:
        return None
    polar = any(isinstance(node, Polar) for node in walk(fact.relation.only[0].right))
    return None if polar and all(source.value) else source


__all__ = ["by_change_along", "vector_before"]
