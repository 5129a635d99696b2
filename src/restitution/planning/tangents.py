"""The tangent of a deflection, by the components before and after an event."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.derivation import Move
from restitution.expression.tree import Apply, Binary, Expression, Name, Quantity
from restitution.planning.desk import NotPlannedError, Source, together
from restitution.planning.forms import difference, is_zero, product, square, total, tree_of
from restitution.planning.frames import Frame
from restitution.planning.impacts import in_direction
from restitution.planning.quantities import Formula, tangent
from restitution.planning.scene import Scene


def tangent_of_deflection(scene: Scene, quantity: Quantity) -> Formula:
    """``tan(deflection) = (a d − b c)/(a c + b d)`` with components a, b before and c, d after.

    Raises NotPlannedError where the deflection is a right angle, or its event is no impact.
    """
    (name,) = quantity.arguments
    if not isinstance(name, Name) or not isinstance(quantity.stage, int):
        raise NotPlannedError("the deflection of what is no body")
    event = quantity.stage
    frame = scene.frame(event)
    early = _pair(scene, name.name, event - 1, frame)
    late = _pair(scene, name.name, event, frame)
    (a, b), (c, d) = ([each.value for each in pair] for pair in (early, late))
    above, below = tidy(a * d - b * c), tidy(a * c + b * d)
    if below == 0:
        raise NotPlannedError("a deflection of a right angle")
    first, second = (_product(early[0], late[1]), _product(early[1], late[0]))
    if scene.model.sign(above) < 0:
        first, second, above = second, first, -above
    tree = Binary(
        "/",
        difference(first, second),
        total((_product(early[0], late[0]), _product(early[1], late[1]))),
    )
    refs = together(*(each.whole for each in (*early, *late)), frame.names_axis("along"))
    move = Move("define", "tan-deflection", event, (name.name,))
    return Formula(move, tangent, quantity, tree, tidy(above / below), refs)


def _pair(scene: Scene, body: str, stage: int, frame: Frame) -> tuple[Source, Source]:
    along, across = (in_direction(scene, each, body, stage, frame) for each in ("along", "across"))
    return along, across


def _product(a: Source, b: Source) -> Expression:
    trees = tree_of(a.value), tree_of(b.value)
    return trees[0] if is_zero(trees[0]) else product(*trees)


def cosine_of_deflection(scene: Scene, quantity: Quantity) -> Formula:
    """``cos(deflection) = (a c + b d)/(√(a² + b²) √(c² + d²))``; the value is what stands above."""
    (name,) = quantity.arguments
    if not isinstance(name, Name) or not isinstance(quantity.stage, int):
        raise NotPlannedError("the deflection of what is no body")
    event = quantity.stage
    frame = scene.frame(event)
    early = _pair(scene, name.name, event - 1, frame)
    late = _pair(scene, name.name, event, frame)
    above = total(_product(x, y) for x, y in zip(early, late, strict=True))
    sizes = (
        Apply("sqrt", total(square(tree_of(each.value)) for each in pair if each.value != 0))
        for pair in (early, late)
    )
    refs = together(*(each.whole for each in (*early, *late)), frame.names_axis("along"))
    value = tidy(sum(x.value * y.value for x, y in zip(early, late, strict=True)))
    move = Move("define", "scalar-angle", event, (name.name,))
    return Formula(move, cosine, quantity, Binary("/", above, product(*sizes)), value, refs)


def cosine(tree: Expression) -> Expression:
    """The cosine of an angle."""
    return Apply("cos", tree)
