"""The identity sin² + cos² = 1, or that of the tangent, with the angle for which a line uses it."""

from __future__ import annotations

from collections.abc import Iterable
from fractions import Fraction
from itertools import chain

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation, equality
from restitution.explaining.lines.trees import angles_with_both_ratios, trees_of
from restitution.expression.tree import Apply, Binary, Expression, Number, letters, walk
from restitution.planning.writing.forms import square
from restitution.workings.naming.quantities import Naming
from restitution.workings.rendering.steps import Row

OF_VALUES = frozenset({"put", "rearrange", "square-add"})
_OF_SQUARES = frozenset({"speed", "size", "energy", "energy-ratio", "total", "tan-deflection"})


def is_by_pythagoras(line: Line) -> bool:
    """Whether a sum of squares is worked out by sin² + cos² = 1."""
    assert isinstance(line.relation, Relation)
    steps = {link.by for links in line.relation.options for link in links}
    values = line.move.record in (None, "pythagoras") and line.move.id in OF_VALUES
    return (values or line.move.record in _OF_SQUARES) and "identity" in steps


def is_arithmetic(naming: Naming, line: Line, rows: Iterable[Row]) -> bool:
    """Whether a line takes the identity for degrees alone, and no row has what comes of it.

    With figures in its place nobody needs the identity.
    """
    relation = line.relation
    if not isinstance(relation, Relation) or len(relation.options) > 1:
        return False
    by_itself = line.move.id == "identity" and line.move.record == "pythagoras"
    if not (by_itself or is_by_pythagoras(line)) or any(map(letters, _ratios(relation.trees))):
        return False
    outcome = naming.layout(relation.options[0][-1].right)
    return all(outcome not in row.operands for row in rows)


def pythagoras(derivation: Derivation, line: Line) -> Relation | None:
    """The identity for the one angle of which a line or its premises have a sine and a cosine.

    Where a line has the tangent alone in place of the cosine, it is the identity of these two. None
    where there are several such angles, or none.
    """
    relations = [own.relation for own in (line, *derivation.lines_in(line.premises))]
    trees = [
        tuple(trees_of(relation)) if isinstance(relation, Relation) else ()
        for relation in relations
    ]
    above, below = _ratios(chain.from_iterable(trees[1:])), _ratios(trees[0])
    if len(below) == 1 and above - below:
        (tangent,) = below
        cosine = Apply("cos", tangent.argument)
        if tangent.function == "tan" and above - below == {cosine}:
            one = Number(Fraction(1))
            over = Binary("/", one, square(cosine))
            return equality(over, Binary("+", one, square(tangent)))
    angles = angles_with_both_ratios(chain.from_iterable(trees))
    angles = angles or frozenset(function.argument for function in above | below)
    if len(angles) != 1:
        return None
    (angle,) = angles
    squares = Binary("+", square(Apply("sin", angle)), square(Apply("cos", angle)))
    return equality(squares, Number(Fraction(1)))


def square_by_the_tangent(derivation: Derivation, line: Line) -> Relation | None:
    """The identity by which the square of a sine or a cosine comes of that of the tangent.

    None of another line, and of one with numbers alone: tan²α = 3/16 is a triangle.
    """
    match line.relation:
        case Relation(
            ((Link(Binary("^", Apply("sin" | "cos" as name, angle), Number(2)), "="), *_),)
        ) if line.move.id == "triangle" and letters(line.relation.only[-1].right):
            pass
        case _:
            return None
    one, tangent = Number(Fraction(1)), square(Apply("tan", angle))
    squares = [square(Apply(ratio, angle)) for ratio in ("sin", "cos")]
    if all(any(link.left == own for link in line.relation.only) for own in squares):
        return equality(Binary("+", *squares), one)  # of both it is seen by their sum
    for own in derivation.lines_in(line.premises):
        match own.relation:
            case Relation(((Link(left, "="), *_),)) if left == tangent:
                over = Binary("/", one, square(Apply(name, angle)))
                rest = tangent if name == "cos" else Binary("/", one, tangent)
                return equality(over, Binary("+", one, rest))
    return None


def _ratios(trees: Iterable[Expression]) -> set[Apply]:
    """The sines, cosines and tangents of some expressions."""
    nodes = (node for tree in trees for node in walk(tree) if isinstance(node, Apply))
    return {node for node in nodes if node.function in ("sin", "cos", "tan")}
