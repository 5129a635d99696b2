"""What single lines are about, by the shape of what they say."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Ref,
    Relation,
)
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Name,
    Quantity,
    is_function,
    is_quantity,
    is_zero,
    walk,
)


def under_a_root(tree: Expression) -> tuple[Expression, ...]:
    """What stands under a root, and its size if it is no sum."""
    return (tree.argument,) if is_function(tree, "sqrt") else ()


def has_sum_of_squares(tree: Expression) -> bool:
    """Whether two squares are added within an expression, as those of both components are."""
    for node in walk(tree):
        match node:
            case Binary("+", Binary("^"), Binary("^")):
                return True
    return False


def is_over_a_ratio(line: Line) -> bool:
    """Whether a line has a speed as a component over a ratio of its angle in degrees."""
    match line.relation:
        case Relation(((Link(Quantity("speed"), "=", right), *_),)):
            return bool(ratio_below(right))
    return False


def ratio_below(speed: Expression) -> str:
    """The sine or cosine of an angle in degrees by which a component is divided; empty without."""
    match speed:
        case Binary("/", _, below):
            for tree in (below.left, below.right) if isinstance(below, Binary) else (below,):
                match tree:
                    case Apply("sin" | "cos" as ratio, Degrees()):
                        return ratio
    return ""


def body_read_off(line: Line) -> str | None:
    """The body of which a line says the direction, without a tangent."""
    match line.relation:
        case Relation(((Link(Quantity("direction", (Name(body),), int()), "="), *_),)):
            return body
    return None


def read_off_lines(derivation: Derivation, line: Line) -> tuple[tuple[str, int], ...]:
    """The spheres along the lines of centres of which an angle is read off, each with its event."""
    if not any(_is_of_a_line_of_centres(derivation, ref) for ref in line.premises):
        return ()
    match line.relation:
        case Relation(((Link(Quantity("angle", arguments), "=", right), *_),)):
            straight = right in (Degrees(Fraction(0)), STRAIGHT_ANGLE)
        case _:
            return ()
    moving = tuple(
        (argument.arguments[0].name, argument.stage)
        for argument in arguments
        if is_quantity(argument, "velocity") and argument.stage
        if isinstance(argument.stage, int)
        if isinstance(argument.arguments[0], Name)
    )
    at_sight = straight or (line.move.record == "perpendicular" and len(moving) < len(arguments))
    return () if at_sight else moving


def _is_of_a_line_of_centres(derivation: Derivation, ref: Ref) -> bool:
    """Whether a fact, or a line, says the direction of a line of centres."""
    own = derivation.cited(ref)
    match None if own is None else own.relation:
        case Relation(((Link(Quantity("line_of_centres")), *_),)):
            return True
    return False


def says_something(line: Line) -> bool:
    """Whether a line is no letter that is let, and no component that there is none of."""
    if not isinstance(line.relation, Relation):
        return False
    return line.move.record != "unchanged" or not is_zero(line.relation.options[0][-1].right)
