"""The tangent of a direction as a multiple of a tangent that is known.

Where ``tan α = ⅓`` was worked out and components are ``u sin α`` and ``⅓u cos α``, a direction is
by ``tan β = 3 tan α = 1``: no sine and no cosine of α is needed.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Line, Move
from restitution.expression.tree import Apply, Letter, Quantity
from restitution.planning.angles.quantities import formula
from restitution.planning.closing.squared_ratios import keeping
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import in_tangents, swept, tree_of
from restitution.planning.writing.premises import background
from restitution.planning.writing.ratio_of_an_angle import Ratio
from restitution.planning.writing.scene import Scene


def multiple_of_a_tangent(scene: Scene, asked: Quantity, extent: str) -> Ratio | None:
    """A direction by a known tangent, where its angle is used in no sine and no cosine; or None."""
    for symbol, tangent in _tangents(scene):
        mark = scene.desk.mark()
        ratio = _multiple(scene, asked, extent, symbol, tangent)
        if ratio is not None:
            return ratio
        scene.desk.back(mark)
    return None


def _tangents(scene: Scene) -> Iterator[tuple[sp.Symbol, Source]]:
    """The angles of which the tangent alone is used, which is a number."""
    for symbol in scene.model.final:
        role = scene.model.unknowns.roles.get(symbol.name)
        if role is None or role.kind != "angle" or (scene.final(symbol) / sp.pi).is_Rational:
            continue
        letter = Letter(symbol.name)
        *others, tangent = (scene.desk.known(Apply(e, letter)) for e in ("sin", "cos", "tan"))
        if tangent is None or any(
            _serves(scene, source) for source in others if source is not None
        ):
            continue
        yield symbol, tangent


def _serves(scene: Scene, source: Source) -> bool:
    """Whether a ratio is data, or serves for more than values put in that nothing rests on."""
    return any(
        not isinstance(ref, int)
        or scene.desk.line(ref).move.id != "triangle"
        or any(map(partial(_is_needed, scene), _resting(scene, ref)))
        for ref in source.refs
    )


def _is_needed(scene: Scene, line: Line) -> bool:
    """Whether a line is no value put in, or one on which a line rests that is needed."""
    return line.move.id != "put" or any(
        map(partial(_is_needed, scene), _resting(scene, line.number))
    )


def _resting(scene: Scene, number: int) -> Iterator[Line]:
    return (line for line in scene.desk.lines if number in line.premises)


def _multiple(
    scene: Scene, asked: Quantity, extent: str, symbol: sp.Symbol, tangent: Source
) -> Ratio | None:
    try:
        with keeping(scene, symbol):
            own = formula(scene, asked)
    except NotPlannedError:
        return None
    value = sp.sympify(own.value, strict=True)
    factor = tidy(value / sp.tan(symbol))
    if own.move.record != "tan" or symbol not in value.free_symbols or not factor.is_number:
        return None
    letter, meaning = letter_of(scene, asked)
    subject = Apply("tan", Letter(letter))
    in_letters = chain(
        subject,
        (swept(own.right), None),
        (tree_of(in_tangents(factor * sp.tan(symbol))), "rearrange"),
    )
    pool = background(scene, {symbol.name})
    move = Move("define", "tan", own.move.event, own.move.bodies)
    refs = scene.judge.enough(move, together(own.refs, (meaning,)), in_letters, pool)
    if refs is None:
        return None
    number = scene.desk.write(move, refs, in_letters, shown="inline")
    worth = tidy(factor * tangent.value)
    relation = chain(subject, (tree_of(worth), None))
    if not scene.judge.follows(Move("put"), (number, *tangent.refs), relation):
        return None
    line = scene.desk.write(Move("put"), (number, *tangent.refs), relation)
    return Ratio(line, letter, "tan", worth, extent.format(letter))
