"""Blows whose impulse is found from the velocities before and after."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Link, Move, Relation
from restitution.expression.tree import Apply, Letter, Name, Quantity
from restitution.planning.angles.quantities import formula
from restitution.planning.closing.ratios import inverse
from restitution.planning.closing.shapes import close
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.writing.desk import NotPlannedError, chain, link, together
from restitution.planning.writing.forms import square, swept, total, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector


def take_blow(scene: Scene, body: str, event: int) -> None:
    """Finds what is open in an impulse from the velocity after it, component by component.

    So it does with what is open in the velocity before it, where the impulse is known.
    """
    impulse = Quantity("impulse", (Name(body),), event)
    fact = scene.facts.get(f"impulse {event}")
    if fact is None:
        raise NotPlannedError("a blow of which nothing is told")
    blow = fact.relation.only[0].right
    open_ = scene.value(blow)
    assert isinstance(open_, Vector)
    own = formula(scene, impulse)
    put, refs = (open_, ()) if scene.unknown(open_) else scene.put(open_)
    left = tree_of(tuple(put))
    rights, last = own.value, tree_of(own.value)
    if impulse in scene.asked:
        line = write_formula(scene, own)
        line = scene.desk.write(Move("put"), (fact.id, line), Relation(((link(left, last),),)))
    else:
        line = scene.desk.write(
            own.move,
            together(own.refs, (fact.id,), refs),
            Relation(((link(left, swept(own.right)),),)),
        )
        if scene.unknown(open_) and swept(own.right) != last:
            line = scene.desk.write(Move("rearrange"), (line,), chain(left, (last, None)))
    if not scene.unknown(open_):
        pairs = [_solved(scene, *sides) for sides in zip(own.value, put, strict=True)]
        open_, rights = (Vector(*column) for column in zip(*pairs, strict=True))
    lines: list[int] = []
    for left, right in zip(open_, rights, strict=True):
        if not scene.unknown(left):
            continue
        trees = tree_of(left), tree_of(right)
        if _is_minus(left):
            trees = tree_of(-left), tree_of(tidy(-right))
        lines.append(
            scene.desk.write(Move("rearrange"), (line,), chain(trees[0], (trees[1], None)))
        )
    unknown = [scene.unknown(value) for value in open_ if scene.unknown(value)]
    if all(len(letters) == 1 for letters in unknown):
        for number, symbols in zip(lines, unknown, strict=True):
            if scene.desk.known(Letter(next(iter(symbols)).name)) is None:
                close(scene, number, next(iter(symbols)))
        return
    _size_and_angle(scene, lines, open_)


def _solved(scene: Scene, left: sp.Expr, right: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """Two sides, with what is unknown alone on the left; what has no unknown stays as it is."""
    own, rest = expanded(left - right).as_independent(*scene.unknown(left))[::-1]
    if own == 0:
        return left, right
    factor, bare = own.as_independent(*scene.unknown(left), as_Add=False)
    return bare, tidy(-rest / factor)


def _is_minus(x: Any) -> bool:
    return bool(sp.sympify(x, strict=True).could_extract_minus_sign())


def _size_and_angle(scene: Scene, lines: list[int], open_: Vector) -> None:
    """Two lines J sin θ = a and J cos θ = b: squared and added for J, divided for θ."""
    symbols = scene.unknown(open_)
    angles = {s for value in open_ for f in value.atoms(sp.sin, sp.cos) for s in f.free_symbols}
    sizes = symbols - angles
    if len(lines) != 2 or len(angles) != 1 or len(sizes) != 1:
        raise NotPlannedError("an impulse with several letters that are open")
    (size,), (angle,) = sizes, angles
    rights = [scene.desk.last_link(number).right for number in lines]
    squared = total(square(right) for right in rights)
    line = scene.desk.write(
        Move("square-add"), lines, chain(square(Letter(size.name)), (squared, None))
    )
    value = tidy(scene.final(size))
    roots = tuple((Link(Letter(size.name), "=", tree_of(root)),) for root in (value, -value))
    line = scene.desk.write(Move("roots"), (line,), Relation(roots))
    line = scene.desk.write(
        Move("reject"), (line,), chain(Letter(size.name), (tree_of(value), None))
    )
    scene.desk.know(Letter(size.name), value, (line,))
    tangent = tidy(tangent_of_angle(scene.final(angle)))
    subject = Apply("tan", Letter(angle.name))
    sine = next(n for n, value in enumerate(open_) if value.has(sp.sin))
    line = scene.desk.write(
        Move("divide"), (lines[sine], lines[1 - sine]), chain(subject, (tree_of(tangent), None))
    )
    scene.desk.know(subject, tangent, (line,))
    inverse(scene, line, angle, lines)
