"""The identity sin² + cos² = 1, with the angle for which a line uses it."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.lines.derivation import Derivation, Line, Relation, equation
from restitution.explaining.lines.trees import angles_with_both_ratios, trees_of
from restitution.expression.tree import Apply, Binary, Number
from restitution.planning.writing.forms import square


def pythagoras(derivation: Derivation, line: Line) -> Relation | None:
    """The identity for the one angle of which a line or its premises have a sine and a cosine.

    None where there are several such angles, or none.
    """
    cited = [derivation.line(ref) for ref in line.premises if isinstance(ref, int)]
    relations = [own.relation for own in (line, *cited) if own is not None]
    trees = (tree for each in relations if isinstance(each, Relation) for tree in trees_of(each))
    angles = angles_with_both_ratios(trees)
    if len(angles) != 1:
        return None
    (angle,) = angles
    squares = Binary("+", square(Apply("sin", angle)), square(Apply("cos", angle)))
    return equation(squares, Number(Fraction(1)))
