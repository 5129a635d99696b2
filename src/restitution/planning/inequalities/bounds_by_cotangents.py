"""A given bound of an angle that may be obtuse, or of a direction: its cotangent falls."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Link,
    Move,
    Ref,
    Relation,
    equality,
)
from restitution.expression.tree import Apply, Binary, Letter, Quantity
from restitution.planning.closing.cotangents import write_ratio_of
from restitution.planning.formulas.angle_formulas import deflection_formula
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.velocity_formulas import body_and_stage, in_the_plane
from restitution.planning.inequalities.angles_bounded import Bounded
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import swept, tree_of
from restitution.planning.writing.inequalities import without_signs
from restitution.planning.writing.polynomials import expanded


def write_by_cotangent(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    """The cotangent of an angle compared with that of its bound, in letters.

    None where no line gives it, or nothing is left to be compared.
    """
    mark = worths.mark()
    try:
        written = _written(worths, fact, link, angle)
    except NotPlannedError:
        written = None
    if written is None:
        worths.back(mark)
    return written


def _written(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    scene, judge = worths.scene, worths.judge
    limit = tidy(sp.cot(scene.scalar(link.right)))
    if link.sign not in FLIPPED or limit.has(sp.zoo):
        return None
    sign = FLIPPED[link.sign]
    worths.determine(Quantity("velocity", angle.arguments, angle.stage))
    letter, let = letter_of(scene, angle)
    pool: list[Ref] = [fact.id, let]
    if angle.kind == "direction":
        x, y = in_the_plane(scene, *body_and_stage(scene, angle))
        line: int | None = write_ratio_of(scene, angle, "cot", x, y)
        side = _side(worths, angle, [let, *y.whole, *worths.known_in(y.value)], y.value)
        if side is None:
            return None
        pool.append(side)
    else:
        line = _cotangent_of_deflection(worths, angle, letter, let)
        pool.append(f"0° <= {letter} <= 180°")
    if line is None:
        return None
    right = scene.desk.last_link(line).right
    cotangent, bound = Apply("cot", Letter(letter)), tree_of(limit)
    compared = judge.write(
        (Move("compare"),), [*pool, line], Relation(((Link(cotangent, sign, bound),),))
    )
    value = worths.value(right)
    stripped = without_signs(scene, expanded(value - limit), sign)
    if compared is None or stripped is None:
        return None
    put = judge.write((Move("put"),), [compared, line], Relation(((Link(right, sign, bound),),)))
    return None if put is None else (put, *stripped)


def _side(worths: Worths, angle: Quantity, pool: Sequence[Ref], up: sp.Expr) -> int | None:
    """The line that says on which side of **i** a velocity points."""
    low, high = (0, 180) if worths.scene.model.sign(up) > 0 else (-180, 0)
    ends = [tree_of(sp.Integer(number) * sp.pi / 180, angle=True) for number in (low, high)]
    links = (Link(ends[0], "<", angle), Link(angle, "<", ends[1]))
    return worths.judge.write((Move("sign"),), pool, Relation((links,)))


def _cotangent_of_deflection(worths: Worths, angle: Quantity, letter: str, let: Ref) -> int | None:
    """The cotangent of a deflection, the tangent turned over: it is also one of a right angle."""
    own = deflection_formula(worths.scene, angle)
    match own.right:
        case Binary("/", above, below):
            pass
        case _:
            return None
    cotangent = Apply("cot", Letter(letter))
    value = tidy(1 / own.value)
    known = worths.known_in(value)
    pool = [*own.refs, let]
    first = equality(cotangent, swept(Binary("/", below, above)))
    line = worths.judge.write((own.move,), [*pool, *known], first)
    if line is None:
        return None
    # A root below stays there: (8 - k)/(3√3 k).
    top, bottom = (tree_of(value) for value in sp.fraction(own.value)[::-1])
    last = equality(cotangent, swept(Binary("/", top, bottom)))
    moves = (Move("rearrange"), Move("cancel"))
    return worths.judge.write(moves, [line, *known], last) or line


__all__ = ["write_by_cotangent"]
