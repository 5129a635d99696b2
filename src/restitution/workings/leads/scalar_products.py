"""Between which velocities an angle is found by a scalar product, and what these are."""

from __future__ import annotations

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Line,
    Link,
    Meaning,
    Relation,
    equality,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    Unit,
    is_function,
    letters,
    unsigned,
)
from restitution.planning.angles.lines_between import cosine_of
from restitution.planning.writing.forms import swept, tree_of
from restitution.planning.writing.unit_vectors import short_direction
from restitution.vector import Vector
from restitution.workings.naming.plain_angles import has_plain_angles
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.grounds import meant_by


def slope_title(naming: Naming, line: Line) -> Sentence | None:
    """What is said before the tangent of the angle of a line of centres, by a vector along it.

    And before a velocity that is turned to a side, which the line of centres tells, or is along
    the way that a body goes.
    """
    kinds = {str(premise).partition(" ")[0] for premise in line.premises}
    if line.move.record == "turned" and "position" in kinds:
        return say("derived.along-the-path")
    if "axis" not in kinds:
        return None
    match line.move.record, line.relation:
        case "parallel", Relation(((Link(Apply("tan", Letter() as angle), "="), *_),)):
            axis = naming.layout(Unit("i"))
            return say("derived.line-at", angle=naming.layout(angle), axis=axis)
        case "turned", Relation(((Link(_, "=", Binary(op)), *_),)):
            (body,) = line.move.bodies
            (other,) = (e for e in naming.events[line.move.event or 0].bodies if e != body)
            turned: SentenceId = (
                "derived.turned-clockwise" if op == "-" else "derived.turned-anticlockwise"
            )
            return say(turned, body=body, other=other)
    return None


def product_title(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """The title of the cosine of an angle of deflection, or of the angle between two velocities.

    Of the latter a velocity of which only components stand is written out. None of another angle,
    and where a velocity stands in no such way.
    """
    match line.relation:
        case Relation(((Link(Apply("cos", Letter() as angle), "="), *_),)):
            asked = meant_by(derivation, angle)
        case _:
            return None
    match asked:
        case Quantity("deflection", (body,), int(stage)):
            early = max(
                (e.number for e in derivation.events if e.number < stage and body in _names(e)),
                default=0,
            )
            both = tuple(Quantity("velocity", (body,), moment) for moment in (early, stage))
            short = _directions(derivation, line, both)
            if short is None:
                return say("derived-between.title-turned")
            first, second = (naming.layout(tree_of(vector)) for vector in short)
            return say("derived-between.title-turned-along", first=first, second=second)
        case Quantity("angle", (Quantity("velocity"), Quantity("velocity")) as pair):
            short = _directions(derivation, line, pair)
            if short is not None:
                one, other = map(naming.layout, pair)
                first, second = (naming.layout(tree_of(vector)) for vector in short)
                return say(
                    "derived-between.title-along", one=one, other=other, first=first, second=second
                )
            sides = []
            for velocity, beside in (pair, pair[::-1]):
                value = _written_out(derivation, line, velocity, beside)
                if value is None and _stands(derivation, line, velocity):
                    sides.append(naming.layout(velocity))
                    continue
                value = value or _by_components(derivation, line, velocity)
                if value is None:
                    return None
                # What only a calculator knows stands above, in figures.
                own = None if has_plain_angles(value) else equality(velocity, value)
                sides.append(naming.layout(velocity) if own is None else naming.relation(own))
            above = derivation.line(line.number - 1)
            named = above is not None and isinstance(above.relation, Meaning)
            if named and sides == list(map(naming.layout, pair)):
                return say("given.by-the-product")  # the words for the angle stand just above
            return say("derived-between.title-of", one=sides[0], other=sides[1])
    return None


def _names(event: Event) -> tuple[Name, ...]:
    return tuple(map(Name, event.bodies))


def _directions(
    derivation: Derivation, line: Line, pair: tuple[Expression, ...]
) -> tuple[Vector, Vector] | None:
    """The short vectors in the directions of two velocities, where their product is of these."""
    assert isinstance(line.relation, Relation)
    short: list[Vector] = []
    are_themselves = True
    for velocity in pair:
        value = _value(derivation, line, velocity)
        direction = None if value is None else short_direction(value, _sign)
        if direction is None:
            return None
        are_themselves &= direction == value
        short.append(direction)
    first, second = short
    trees = [(tree_of(p), tree_of(q)) for p, q in zip(first, second, strict=True)]
    by_these = swept(cosine_of(trees, first, second)[0]) == line.relation.only[0].right
    return (first, second) if by_these and not are_themselves else None


def _value(derivation: Derivation, line: Line, velocity: Expression) -> Vector | None:
    """The last vector that a velocity is said to be above a line, or in the data.

    What the line cites of letters that are given is put in.
    """
    relations = [fact.relation for fact in derivation.facts]
    relations += [
        other.relation
        for other in derivation.lines[: line.number]
        if isinstance(other.relation, Relation)
    ]
    links = [relation.options[0] for relation in relations if len(relation.options) == 1]
    trees = [own[-1].right for own in links if own[0].left == velocity and own[-1].sign == "="]
    try:
        value = in_letters(trees[-1]) if trees else None
    except RestitutionError:
        return None
    if not isinstance(value, Vector):
        return None
    given = _given_letters(derivation, line)
    return Vector(*(tidy(component.subs(given)) for component in map(sp.sympify, value)))


def _given_letters(derivation: Derivation, line: Line) -> dict[sp.Expr, sp.Expr]:
    """The letters that facts which a line cites give as numbers."""
    values: dict[sp.Expr, sp.Expr] = {}
    for fact in derivation.facts:
        match fact.relation.options:
            case ((Link(Letter() as letter, "=", right),),) if fact.id in line.premises:
                if fact.kind == "given" and not letters(right):
                    values[in_letters(letter)] = in_letters(right)
    return values


def _sign(value: sp.Expr) -> int:
    """The sign of a multiple of positive letters."""
    own = value.subs(dict.fromkeys(value.free_symbols, sp.Integer(1)))
    return int(sp.sign(own)) if own.is_number and own.is_real else 0


def _stands(derivation: Derivation, line: Line, velocity: Expression) -> bool:
    """Whether a velocity stands as a vector above a line, or is one of the data."""
    for other in derivation.lines:
        match other.relation:
            case Relation(((Link(left, "="), *_),)) if left == velocity:
                if other.number < line.number and other.shown == "line":
                    return True
    match velocity:
        case Quantity("velocity", (Name(body),), 0):
            return derivation.fact(f"velocity {body}") is not None
    return any(
        fact.kind == "given" and any(link.left == velocity for link in fact.relation.options[0])
        for fact in derivation.facts
    )


def _by_its_angle(derivation: Derivation, velocity: Expression) -> tuple[Vector, ...]:
    """What a velocity of the data may be that is told by an angle, along no axis; else nothing.

    With an angle to a wall that is along an axis, it goes either way along it.
    """
    match velocity:
        case Quantity("velocity", (Name(body),), 0):
            fact = derivation.fact(f"velocity {body}")
        case _:
            return ()
    match None if fact is None else fact.relation.only[0].right:
        case Polar(wall=None) as polar:
            vectors = [in_letters(polar)]
        case Polar(size, angle, wall=Name(wall)):
            vectors = _beside_a_wall(derivation, wall, in_letters(size), in_letters(angle))
        case _:
            return ()
    return tuple(
        vector
        for vector in vectors
        if isinstance(vector, Vector) and all(tidy(part) != 0 for part in vector)
    )


def _beside_a_wall(
    derivation: Derivation, wall: str, size: sp.Expr, angle: sp.Expr
) -> list[Vector]:
    """The velocities with which a body may come to a wall along **i** or **j**, at an angle."""
    number = next((e.number for e in derivation.events if e.wall and e.bodies[1] == wall), None)
    axis = derivation.fact(f"axis {number}")
    into = None if axis is None else direction_by_axes(axis.relation.only[-1].right)
    if into is None:
        return []
    along = into.turned_left()
    ahead, aside = (into * (size * sp.sin(angle)), along * (size * sp.cos(angle)))
    return [ahead + aside, ahead - aside]


def direction_by_axes(tree: Expression) -> Vector | None:
    """**i** or **j**, or what is opposite to one, as a vector; None of any other direction."""
    if not isinstance(unsigned(tree), Unit):
        return None
    value = in_letters(tree)
    return value if isinstance(value, Vector) else None


def _ratios_cited(derivation: Derivation, line: Line) -> dict[sp.Expr, sp.Expr]:
    """The sines and cosines that have a number in what a line cites."""
    relations: list[Relation | Meaning] = [e.relation for e in derivation.lines_in(line.premises)]
    relations += [fact.relation for fact in derivation.facts_in(line.premises)]
    return {
        in_letters(link.left): in_letters(link.right)
        for relation in relations
        if isinstance(relation, Relation) and len(relation.options) == 1
        for link in relation.only
        if is_function(link.left, "sin", "cos") and not letters(link.right)
    }


def _written_out(
    derivation: Derivation, line: Line, velocity: Expression, other: Expression
) -> Expression | None:
    """A velocity that is told by an angle, by its components, which the cosine agrees with."""
    beside = _value(derivation, line, other)
    if beside is None or not isinstance(line.relation, Relation):
        return None
    cosine = in_letters(line.relation.only[-1].right)
    ratios = _ratios_cited(derivation, line)
    for own in _by_its_angle(derivation, velocity):
        vector = Vector(*(sp.sympify(part, strict=True).subs(ratios) for part in own))
        sizes = [sp.sqrt(tidy(sp.expand(x.dot(x)))) for x in (vector, beside)]
        gap = tidy(vector.dot(beside)) / sizes[0] / sizes[1] - cosine
        if tidy(gap) == 0:
            return tree_of(Vector(*map(tidy, vector)))
    return None


def _by_components(derivation: Derivation, line: Line, velocity: Expression) -> Expression | None:
    """A velocity by the components on which a line rests; None along a line that slants."""
    axis = derivation.fact(f"axis {line.move.event}")
    parts: dict[str, Expression] = {}
    for ref in line.premises:
        own = derivation.line(ref)
        match None if own is None else own.relation:
            case Relation((links,)) if all(link.sign == "=" for link in links):
                subject: Expression | None = links[0].left
            case _:
                continue
        if isinstance(subject, Letter):
            subject = meant_by(derivation, subject)
        match subject:
            case Quantity("along" | "across" as kind, (own_velocity, Quantity("line_of_centres"))):
                if own_velocity == velocity:
                    parts[kind] = links[-1].right
    if axis is None or parts.keys() != set(COMPONENTS):
        return None
    try:
        normal = in_letters(axis.relation.only[-1].right)
        along, across = (in_letters(parts[kind]) for kind in COMPONENTS)
    except RestitutionError:
        return None
    if not isinstance(normal, Vector) or 0 not in normal or normal.dot(normal) != 1:
        return None
    whole = normal * along + normal.turned_left() * across
    return tree_of(Vector(*map(tidy, whole)))


__all__ = ["product_title"]
