"""The identity sin² + cos² = 1, with the angle for which a line uses it."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.lines.derivation import Derivation, Line, Relation, equation
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Apply, Binary, Expression, Number, walk
from restitution.planning.writing.forms import square


def pythagoras(derivation: Derivation, line: Line) -> Relation | None:
    """The identity for the one angle of which a line or its premises have a sine and a cosine.

    None where there are several such angles, or none.
    """
    ratios: dict[Expression, set[str]] = {}
    cited = [derivation.line(ref) for ref in line.premises if isinstance(ref, int)]
    for own in (line, *cited):
        if own is None or not isinstance(own.relation, Relation):
            continue
        for tree in trees_of(own.relation):
            for node in walk(tree):
                if isinstance(node, Apply) and node.function in ("sin", "cos"):
                    ratios.setdefault(node.argument, set()).add(node.function)
    both = [angle for angle, names in ratios.items() if len(names) > 1]
    if len(both) != 1:
        return None
    (angle,) = both
    squares = Binary("+", square(Apply("sin", angle)), square(Apply("cos", angle)))
    return equation(squares, Number(Fraction(1)))
