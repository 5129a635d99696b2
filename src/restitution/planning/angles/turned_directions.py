"""A deflection by the directions before it and after it, where both stand already."""

from __future__ import annotations

from fractions import Fraction

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.definitions.turnings import direction_from_i
from restitution.explaining.lines.derivation import Meaning, Move, MoveId, Ref
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    is_binary,
    walk,
)
from restitution.planning.angles.turn_lines import inverse_of_data
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import difference, negative, tree_of
from restitution.planning.writing.scene import Scene


def turn_of_directions(scene: Scene, asked: Quantity) -> int | None:
    """The line of a deflection by the directions before and after, where both are known.

    The first is one of the data, from **i**, as a number or a letter that is known; the second
    stands in a line. None where that is not so, or where the second is no plain angle and the first
    not along an axis.
    """
    match asked:
        case Quantity("deflection", (Name(body),), int(event)) if not scene.last_event(
            body, event - 1
        ):
            pass
        case _:
            return None
    fact = scene.facts.get(f"velocity {body}")
    late = Quantity("direction", (Name(body),), event)
    known = scene.desk.known(late)
    early = None if fact is None else direction_from_i(fact.relation.only[0].right)
    if fact is None or known is None or early is None or len(known.refs) != 1:
        return None
    (line,) = known.refs
    sources: tuple[Ref, ...] = ()
    mark = scene.desk.mark()
    if isinstance(early, Letter):
        own = _known_angle(scene, early)
        if own is None:
            return None
        (sources, early) = own
    before, after = (sp.sympify(value, strict=True) for value in (scene.scalar(early), known.value))
    right = scene.desk.last_link(line).right if isinstance(line, int) else None
    if after.free_symbols or right is None or not (_is_plain(right) or sp.sin(2 * before) == 0):
        scene.desk.back(mark)
        return None
    above = scene.model.sign(after - before) > 0
    pair = (right, early) if above else (early, right)
    final = tree_of(tidy(abs(after - before)), angle=True)
    if early == Degrees(Fraction(0)):
        size = right if above else negative(right)
        steps: list[tuple[Expression, MoveId | None]] = [(size, None)]
    else:
        steps = [(difference(*pair), None)]
        steps += [(final, "rearrange")] if isinstance(final, Degrees) else []
    letter, meaning = letter_of(scene, asked)
    named = [
        own.number
        for own in scene.desk.lines
        if isinstance(own.relation, Meaning) and own.relation.quantity == late
    ]
    relation = chain(Letter(letter), *steps)
    move = Move("define", "difference", event, (body,))
    premises = scene.judge.needed(move, (fact.id, *sources, line, meaning, *named), relation)
    if premises is None:
        scene.desk.back(mark)
        return None
    return scene.desk.write(move, premises, relation)


def _known_angle(scene: Scene, angle: Letter) -> tuple[tuple[Ref, ...], Expression] | None:
    """The line of an angle of the data that stands, or of which a ratio is given."""
    known = scene.desk.known(angle)
    if known is not None and not sp.sympify(known.value, strict=True).free_symbols:
        return known.refs, tree_of(known.value, angle=True, as_it_is=True)
    if angle.name not in scene.ratio_facts:
        return None
    line = inverse_of_data(scene, angle.name)
    return (line,), scene.desk.last_link(line).right


def _is_plain(angle: Expression) -> bool:
    """Whether an angle is in degrees, or the inverse tangent of a number without a sum."""
    return not any(
        isinstance(node, Apply)
        and node.function.startswith("arc")
        and any(is_binary(part, "+", "-") for part in walk(node.argument))
        for node in walk(angle)
    )
