"""Ratios of angles of the motion that are given: *tan α = 3 tan β*, *sin β = 5/13*."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Move, Ref
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    letters,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.named_angles import letter_known, letter_of
from restitution.planning.writing.angles import angle_to_a_line
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import in_tangents, neat, swept, tree_of
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene

_RANGES = ("0° <= {} <= 90°", "0° <= {} <= 180°")


def write_tangents(scene: Scene, link: Link) -> tuple[dict[Expression, Expression], list[Ref]]:
    """Lines of the tangents in a relation: what each is by them, and the lines.

    Raises NotPlannedError where an angle has no line by its tangent.
    """
    values: dict[Expression, Expression] = {}
    refs: list[Ref] = []
    for node in (node for side in (link.left, link.right) for node in walk(side)):
        match node:
            case Apply("tan", Quantity(kind) as angle) if (
                kind in UNSIGNED_ANGLES and node not in values
            ):
                if (datum := _of_data(scene, angle)) is not None:
                    values[node] = Apply("tan", tree_of(datum.value, angle=True))
                    refs += datum.refs
                    continue
                own = formula(scene, angle)
                if own.left != node:
                    raise NotPlannedError("a relation with angles")
                final = tree_of(in_tangents(neat(own.value)))
                named = letter_known(scene, angle)
                left = node if named is None else Apply("tan", Letter(named[0]))
                pool = together(own.refs, () if named is None else (named[1],))
                relation = chain(left, (swept(own.right), None), (final, "rearrange"))
                known = background(scene, symbol_names(own.value))
                premises = scene.judge.enough(own.move, pool, relation, known)
                if premises is None:
                    raise NotPlannedError("to which side a sphere turns is open")
                refs.append(scene.desk.write(own.move, premises, relation))
                values[node] = final
    return values, refs


def _of_data(scene: Scene, angle: Quantity) -> Source | None:
    """The angle of a velocity of the data to a line, where the data give it as an acute letter."""
    match angle:
        case Quantity("angle", (Quantity("velocity", (Name(body),), int(stage)), line)):
            if scene.last_event(body, stage):
                return None
        case _:
            return None
    fact = scene.facts.get(f"velocity {body}")
    right = None if fact is None else fact.relation.only[0].right
    given = angle_to_a_line(scene, body, line)
    if isinstance(right, Polar) and right.wall == line:
        given = right.angle
    if given is None or fact is None:
        return None
    refs = [ref for ref in scene.facts if ref.startswith(("axis ", "wall "))]
    return Source(scene.scalar(given), (fact.id, *refs))


def write_by_tangent(scene: Scene, equation: GivenEquation, ratio: Apply) -> int | None:
    """A sine or a cosine of an angle that is given: its tangent, as a quotient of components.

    None where it is no number, or the tangent does not follow from it.
    """
    angle, right = ratio.argument, equation.link.right
    assert isinstance(angle, Quantity)
    value = scene.scalar(right)
    if not value.is_number or not 0 < value < 1:
        return None
    own = formula(scene, angle)
    if own.left != Apply("tan", angle):
        return None
    mark = scene.desk.mark()
    letter, meaning = letter_of(scene, angle)
    named = Apply(ratio.function, Letter(letter))
    first = scene.judge.write(
        (Move("fact"),), (equation.fact.id, *equation.lets, meaning), chain(named, (right, None))
    )
    other = tidy(sp.sqrt(1 - value**2))
    tangent = tree_of(value / other if ratio.function == "sin" else other / value)
    known = (*scene.judge.known([letter]), *(bounds.format(letter) for bounds in _RANGES))
    second = first and scene.judge.write(
        (Move("triangle"),),
        (first, meaning, *known),
        chain(Apply("tan", Letter(letter)), (tangent, None)),
    )
    final = tree_of(in_tangents(neat(own.value)))
    relation = chain(tangent, (swept(own.right), None), (final, "rearrange"))
    premises = second and scene.judge.enough(own.move, (second, meaning, *own.refs), relation)
    if premises:
        return scene.desk.write(own.move, premises, relation)
    line = first and _by_the_components(scene, own, (first, meaning, *known), letter, tangent)
    if line is None:
        scene.desk.back(mark)
    return line


def _by_the_components(
    scene: Scene, own: Formula, known: tuple[Ref, ...], letter: str, value: Expression
) -> int | None:
    """The same of an angle of up to 180°, which is acute by its components: their line is first."""
    subject, final = Apply("tan", Letter(letter)), tree_of(in_tangents(neat(own.value)))
    relation = chain(subject, (swept(own.right), None), (final, "rearrange"))
    premises = scene.judge.enough(own.move, (known[1], *own.refs), relation)
    if premises is None:
        return None
    line = scene.desk.write(own.move, premises, relation)
    pool = (known[0], line, *known[1:], *background(scene, letters(final)))
    ratio = scene.judge.write((Move("triangle"),), pool, chain(subject, (value, None)))
    put = ratio and scene.judge.write((Move("put"),), (line, ratio), chain(value, (final, None)))
    return put or None
