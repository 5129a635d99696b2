"""Directions by their tangents, or by their cotangents where a velocity may point along **j**."""

from __future__ import annotations

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Line, Link, Meaning, Move, Ref, Relation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Apply, Binary, Letter, Quantity, letters
from restitution.planning.formulas.named_angles import letter_of, ratio_line
from restitution.planning.formulas.velocity_formulas import body_and_stage
from restitution.planning.writing.angles import RIGHT
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import difference, in_tangents, tree_of
from restitution.planning.writing.premises import background, nonzero
from restitution.planning.writing.scene import Scene


def write_ratio_of(scene: Scene, direction: Quantity, function: str, x: Source, y: Source) -> int:
    """The line ``tan(θ) = y/x`` or ``cot(θ) = x/y``, by the components of the velocity."""
    body, stage = body_and_stage(scene, direction)
    letter, let = letter_of(scene, direction)
    above, below = (y, x) if function == "tan" else (x, y)
    quotient = Binary("/", tree_of(above.value), tree_of(below.value))
    move = Move("define", "tan-direction", stage or None, (body,))
    refs = together(x.whole, y.whole, (let,))
    ratio = Apply(function, Letter(letter))
    return ratio_line(scene, move, refs, ratio, quotient, tidy(above.value / below.value))


def write_by_cotangent(scene: Scene, direction: Quantity, x: Source, y: Source) -> int | None:
    """The line ``θ = 90° − arctan(x/y)``, on the side of **i** on which a velocity points.

    None where that is open.
    """
    sign = scene.model.sign(y.value)
    if not sign or not scene.model.decide(sign * scene.model.in_data(y.value), ">", 0):
        return None
    mark = scene.desk.mark()
    line = write_ratio_of(scene, direction, "cot", x, y)
    letter, let = letter_of(scene, direction)
    arc = Apply("arctan", tree_of(tidy(sign * x.value / y.value)))
    right = difference(RIGHT, arc) if sign > 0 else difference(arc, RIGHT)
    relation = chain(Letter(letter), (right, None))
    refs = (line, let, *y.whole, *nonzero(scene, y.value))
    premises = scene.judge.needed(Move("inverse"), refs, relation)
    if premises is None:
        scene.desk.back(mark)
        return None
    return scene.desk.write(Move("inverse"), premises, relation)


def cotangent_of(scene: Scene, line: int, letter: str) -> int | None:
    """The line of a cotangent by what the line of the tangent rests on.

    Where values were put into a tangent, they are put into the cotangent. None of a tangent that is
    not defined by a quotient.
    """
    own = scene.desk.line(line)
    match own.move.id, own.relation:
        case "put", Relation(((Link(Apply("tan") as tangent, "=", _),),)):
            return _with_values(scene, own, tangent, letter)
        case "define", Relation(((Link(Apply("tan"), "=", Binary("/", above, below)), *_),)):
            value = tidy(scene.scalar(below) / scene.scalar(above))
        case _:
            return None
    mark = scene.desk.mark()
    cotangent = Apply("cot", Letter(letter))
    first = ratio_line(scene, own.move, own.premises, cotangent, Binary("/", below, above), value)
    line_, relation = scene.desk.line(first), scene.desk.relation(first)
    names = {name for tree in trees_of(relation) for name in letters(tree)}
    premises = scene.judge.enough(own.move, line_.premises, relation, background(scene, names))
    scene.desk.back(mark)
    return None if premises is None else scene.desk.write(own.move, premises, relation)


def _with_values(scene: Scene, put: Line, tangent: Apply, letter: str) -> int | None:
    """The same of a tangent into whose line values were put."""
    lines = (scene.desk.line(ref) for ref in put.premises if isinstance(ref, int))
    numbers = [line.number for line in lines if isinstance(line.relation, Relation)]
    own = next((n for n in numbers if scene.desk.last_link(n).left == tangent), None)
    line = None if own is None else cotangent_of(scene, own, letter)
    if line is None:
        return None
    link = scene.desk.last_link(line)
    value, refs = scene.put(scene.scalar(link.right))
    relation = chain(Apply("cot", Letter(letter)), (tree_of(in_tangents(value)), None))
    premises = scene.judge.enough(Move("put"), (line, *refs), relation)
    return None if premises is None else scene.desk.write(Move("put"), premises, relation)


def write_open_angle(scene: Scene, line: int, letter: str, extent: Ref) -> int | None:
    """The line of an angle that may be obtuse or not: ``β = 90° − arctan(a/b)``.

    None where the tangent, of which the line is given, is not defined by a quotient.
    """
    mark = scene.desk.mark()
    first = cotangent_of(scene, line, letter)
    if first is None:
        return None
    right = difference(RIGHT, Apply("arctan", scene.desk.last_link(first).right))
    relation = chain(Letter(letter), (right, None))
    lets = (ref for ref in scene.desk.line(first).premises if _introduces(scene, ref, letter))
    premises = scene.judge.needed(Move("inverse"), (first, extent, *lets), relation)
    if premises is None:
        scene.desk.back(mark)
        return None
    return scene.desk.write(Move("inverse"), premises, relation)


def _introduces(scene: Scene, ref: Ref, letter: str) -> bool:
    """Whether a premise is the line that introduces a letter."""
    own = scene.desk.line(ref).relation if isinstance(ref, int) else None
    return isinstance(own, Meaning) and own.letter == letter


__all__ = ["cotangent_of", "write_by_cotangent", "write_open_angle", "write_ratio_of"]
