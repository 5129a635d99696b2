"""Why roots are rejected: by what they make of another letter, *w = −3u and e = −1*, or where."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    OPPOSITE,
    Derivation,
    Line,
    Link,
    Relation,
    Sign,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Letter,
    Negate,
    Number,
    Unit,
    has_quantity,
    is_function,
    letters,
)
from restitution.oracle import BeyondError, Oracle, Role
from restitution.oracle import Relation as Claim
from restitution.render import layout as lay
from restitution.solving.story.letters import roles
from restitution.workings.naming.figures import Figures
from restitution.workings.naming.measured import vector_worth, worth
from restitution.workings.naming.plain_angles import is_by_calculator
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.rejected import (
    bound_broken,
    made_by_a_root,
    positive_by_a_law,
    root_against_a_law,
    root_of_a_square,
)
from restitution.workings.naming.sources import Sources


def made_of_a_root(
    derivation: Derivation, naming: Naming, sources: Sources, line: Line
) -> Sentence | None:
    """What the root that is rejected would make of another letter, by which laws.

    What that letter may be stands behind it: *w = −u would give e = −1 by (2), but e ≥ 0*.
    """
    squared = root_of_a_square(derivation, line)
    if squared is not None and squared[1] in sources.numbers:
        root = naming.relation(Relation((squared[0],)))
        number = say("derived.number", number=str(sources.numbers[squared[1]]))
        return say("derived.no-root", value=root, equation=number)
    broken = bound_broken(derivation, line) if line.move.id == "reject" else None
    if broken is None:
        sign = positive_by_a_law(derivation, line, roles(naming.problem))
        if sign is not None and sign[1] in sources.numbers:
            positive = naming.relation(Relation(((sign[0],),)))
            number = say("derived.number", number=str(sources.numbers[sign[1]]))
            return say("derived.by-equation", fact=positive, equation=number)
        against = root_against_a_law(derivation, line)
        if against is None or against[1] not in sources.numbers:
            return None
        root = naming.relation(_with_a_calculator(Relation((against[0],))))
        number = say("derived.number", number=str(sources.numbers[against[1]]))
        return say("derived.no-root", value=root, equation=number)
    dropped, bound = broken
    values = made_by_a_root(derivation, line, dropped, bound)
    source = sources.of(line)
    numbers = sorted(sources.numbers[e] for e in (source.reasons if source else ()))
    equations = tuple(say("derived.number", number=str(number)) for number in numbers)
    if not equations:
        return None
    outcomes = map(_with_a_calculator, values or (Relation(((bound,),)),))
    results = tuple(map(naming.relation, outcomes))
    root = naming.relation(_with_a_calculator(Relation((dropped,))))
    if not values or any(link.sign != "=" for link in values[-1].only):
        return say("derived.would", value=root, results=results, equations=equations)
    allowed: Sentence | lay.Layout
    match bound.left:
        case Apply(_, angle):
            allowed = say("derived.acute", angle=naming.layout(angle))
        case _:
            allowed = naming.relation(Relation(((replace(bound, sign=OPPOSITE[bound.sign]),),)))
    slots = {"value": root, "results": results, "equations": equations, "bound": allowed}
    return say("derived.would-beyond", **slots)


def _with_a_calculator(relation: Relation) -> Relation:
    """What a letter is with angles such as 37°, in figures; any other relation as it is."""
    match relation.options:
        case ((Link(left, "=", value),),) if is_by_calculator((value,)):
            number = Figures(with_calculator=True).outcome(value)
            return relation if number == value else Relation(((Link(left, "≈", number),),))
    return relation


def root_on_a_rim(derivation: Derivation, naming: Naming, line: Line, number: int) -> Sentence:
    """Why a body that moves parallel to an axis strikes a circular wall at one of two points.

    From inside it comes to the one that is in front of it, from outside to the nearer one. For a
    path that slants, only that it moves towards the wall there.
    """
    body, wall = naming.events[number].bodies
    otherwise = say("circle.towards", body=body, wall=wall)
    above = derivation.line(line.premises[0])
    datum = f"velocity {body}"
    fact = derivation.fact(datum) if datum in line.premises else None
    if above is None or fact is None:
        return otherwise
    if not isinstance(above.relation, Relation) or not isinstance(line.relation, Relation):
        return otherwise
    velocity = vector_worth(fact.relation.only[-1].right)
    kept = line.relation.options[0]
    (*_, dropped) = [option for option in above.relation.options if option != kept] or [kept]
    try:
        ahead = in_letters(kept[-1].right, positive=True)
        ahead -= in_letters(dropped[-1].right, positive=True)
    except (RestitutionError, TypeError):
        return otherwise
    speeds = [] if velocity is None else [component for component in velocity if component != 0]
    sense = sp.sign(speeds[0] * tidy(ahead)) if len(speeds) == 1 else None
    if sense not in (-1, 1):
        return otherwise
    if sense < 0:
        return say("circle.first", body=body)
    unit = Unit("i" if velocity is not None and velocity[0] != 0 else "j")
    axis = naming.layout(unit if speeds[0].is_positive else Negate(unit))
    return say("circle.ahead", body=body, axis=axis)


def bound_of_a_quadratic(
    derivation: Derivation, known: Mapping[str, Role], line: Line
) -> Relation | None:
    """``e >= 0``, where a line has one root of a quadratic whose roots have opposite signs."""
    cited = list(derivation.lines_in(line.premises))
    if line.move.id != "solve" or len(cited) != 1 or len(line.premises) != 1:
        return None
    match line.relation, cited[0].relation:
        case Relation(((Link(Letter(name), "="),),)), Relation(((Link(left, "=", right),),)):
            role = known.get(name)
        case _:
            return None
    if role is None or role.kind not in ("restitution", "positive") or has_quantity(left):
        return None
    letter = sp.Symbol(name)
    try:
        gap = sp.expand(in_letters(left) - in_letters(right))
    except (RestitutionError, TypeError):
        return None
    if not gap.is_polynomial(letter) or sp.degree(gap, letter) != 2:
        return None
    product = gap.subs(letter, 0) * gap.coeff(letter, 2)
    others = {other: role for other, role in known.items() if other != name}
    try:
        opposite = product.free_symbols <= {sp.Symbol(other) for other in others} and Oracle(
            others
        ).proves(Claim(-product, ">"))
    except BeyondError:
        return None
    sign: Sign = ">=" if role.kind == "restitution" else ">"
    return Relation(((Link(Letter(name), sign, Number(Fraction(0))),),)) if opposite else None


def bound_of_a_ratio(derivation: Derivation, line: Line) -> Relation | None:
    """``cos α ≥ −1``, where that excludes the roots of a sine or a cosine that a line rejects."""
    above = derivation.line(line.premises[0]) if len(line.premises) == 1 else None
    if above is None or not isinstance(above.relation, Relation):
        return None
    assert isinstance(line.relation, Relation)
    dropped = [option[-1] for option in above.relation.options if option != line.relation.only]
    ratio = line.relation.only[0].left
    if not is_function(ratio, "sin", "cos") or any(letters(link.right) for link in dropped):
        return None
    values = [worth(link.right) for link in dropped]
    if values and all(bool(value < -1) for value in values):
        return Relation(((Link(ratio, ">=", Negate(Number(Fraction(1)))),),))
    if values and all(bool(value > 1) for value in values):
        return Relation(((Link(ratio, "<=", Number(Fraction(1))),),))
    return None


__all__ = ["bound_of_a_quadratic", "bound_of_a_ratio", "made_of_a_root", "root_on_a_rim"]
