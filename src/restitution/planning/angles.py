"""Lines about angles: their ratios from one that is given."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.derivation import Link, Move, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Polar,
    Unit,
    walk,
)
from restitution.planning.desk import NotPlannedError
from restitution.planning.forms import tree_of

if TYPE_CHECKING:
    from restitution.planning.scene import Scene

STRAIGHT, RIGHT = (Degrees(Fraction(each)) for each in (180, 90))


def range_of(scene: Scene, name: str) -> str:
    """What is known of the range of an angle, as a premise says it."""
    role = scene.model.unknowns.roles[name]
    if role.low == 0 and role.high == sp.pi / 2 and not any(role.closed):
        return f"acute: {name}"
    signs = ["<=" if each else "<" for each in role.closed]
    if role.low is None or role.high is None:
        raise NotPlannedError(f"the range of {name} is open")
    ends = [f"{int(sp.deg(each))}°" for each in (role.low, role.high)]
    return f"{ends[0]} {signs[0]} {name} {signs[1]} {ends[1]}"


def write_ratios(scene: Scene, symbol: sp.Symbol) -> None:
    """``cos α = 3/5 and sin α = 4/5`` from the ratio that is given."""
    fact = scene.ratio_facts[symbol.name]
    (link,) = fact.relation.only
    assert isinstance(link.left, Apply)
    letter = Letter(symbol.name)
    angle = scene.model.final[symbol]
    given = link.left.function
    scene.desk.know(link.left, scene.scalar(link.right), (fact.id,))
    others = {
        each: tidy(getattr(sp, each)(angle)) for each in ("sin", "cos", "tan") if each != given
    }
    shown = [each for each in ("sin", "cos") if each != given]
    links = tuple(Link(Apply(each, letter), "=", tree_of(others[each])) for each in shown)
    number = scene.desk.write(
        Move("triangle"), (fact.id, range_of(scene, symbol.name)), Relation((links,))
    )
    for each in shown:
        scene.desk.know(Apply(each, letter), others[each], (number,))
    if "tan" in others:
        scene.desk.know(Apply("tan", letter), others["tan"], (fact.id, number))


def write_other_ratio(scene: Scene, symbol: sp.Symbol, kind: str) -> None:
    """A sine, cosine or tangent of an angle of which another is known, or the angle itself."""
    letter = Letter(symbol.name)
    for each in ("tan", "sin", "cos"):
        known = scene.desk.known(Apply(each, letter))
        if known is None or len(known.refs) != 1:
            continue
        kinds = [kind] if kind == "tan" else [own for own in ("sin", "cos") if own != each]
        trees = {own: tidy(getattr(sp, own)(scene.model.final[symbol])) for own in kinds}
        links = tuple(Link(Apply(own, letter), "=", tree_of(trees[own])) for own in kinds)
        premises = (*known.refs, range_of(scene, symbol.name))
        number = scene.desk.write(Move("triangle"), premises, Relation((links,)))
        for own in kinds:
            scene.desk.know(Apply(own, letter), trees[own], (number,))
        return


def angle_to_a_line(scene: Scene, body: str, line: Expression) -> Expression | None:
    """The angle of up to 90° to a line at which the velocity of a body at the start is given.

    None where it is not given by an angle, nor along **i** or **j**.
    """
    fact = scene.facts.get(f"velocity {body}")
    right = None if fact is None else fact.relation.only[0].right
    angle: Expression = Degrees(Fraction(0))
    origin: Expression | None = None
    if isinstance(right, Polar):
        if right.wall is not None:
            return None
        angle, origin = right.angle, right.origin
        given = scene.model.story.direction(origin or Unit("i"), 0)
    elif right is not None and any(isinstance(node, Unit) for node in walk(right)):
        given = scene.initial(body).value
        if given.x != 0 and given.y != 0:
            return None
    else:
        return None
    turned = scene.scalar(angle)
    if all(isinstance(node, Degrees | Letter | Binary) for node in walk(line)):
        if given.x != 0 and given.y != 0:
            return None
        across = Binary("-", line, RIGHT) if given.x == 0 else line
        angle, turned = Binary("-", angle, across), turned - scene.scalar(across)
    else:
        way = scene.model.story.direction(line, 0)
        if given.cross(way) != 0:
            if not isinstance(line, Unit) or given.dot(way) != 0:
                return None
            angle, turned = Binary("-", RIGHT, angle), sp.pi / 2 - turned
        elif not isinstance(line, Unit | Negate) and origin != line:
            return None
    forms = ((angle, turned), (Binary("-", STRAIGHT, angle), sp.pi - turned), (None, -turned))
    for form, value in forms:
        if scene.model.decide(value, ">=", 0) and scene.model.decide(value, "<=", sp.pi / 2):
            own = tidy(value)
            plain = form is None or own.is_number or own.is_Symbol
            return tree_of(own, angle=True) if plain else form
    return None
