"""A given inequality of an angle: its tangent is more, or less, than that of the bound."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Quantity,
    is_function,
)
from restitution.planning.angles.turn_lines import (
    meeting,
)
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.inequalities import linear_in, without_signs
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass

Bounded = tuple[int, Sign, sp.Expr]
"""A line that says an inequality of letters, its sign, and what is compared with 0 by it."""


def write_bounded(worths: Worths, fact: Fact, link: Link, angle: Quantity) -> Bounded | None:
    """The tangent of an angle compared with that of an acute one, in letters.

    None where it is open whether the angle is acute, or nothing is left to be compared.
    """
    assert isinstance(link.right, Degrees)
    mark = worths.mark()
    try:
        line = worths.angle(angle)
        own = worths.scene.desk.last_link(line)
        if not is_function(own.left, "tan"):
            raise NotPlannedError("an angle without a tangent")
        line, letter, extent = worths.lettered(line, own.left.argument)
    except NotPlannedError:
        worths.back(mark)
        return None
    own_bound = Bound(fact.id, letter, link.sign, link.right)
    bounded = by_tangents(worths, own_bound, line, extent)
    if bounded is None:
        worths.back(mark)
    return bounded


@dataclass(frozen=True)
class Bound:
    """That an angle, by its letter, is more or less than another one, as a premise says."""

    ref: Ref
    letter: Expression
    sign: Sign
    end: Expression


def by_tangents(worths: Worths, bound: Bound, line: int, extent: tuple[Ref, ...]) -> Bounded | None:
    """The bound of an angle as one of its tangent, which a line gives, in letters.

    Where the bound is a sum with an inverse tangent, its own tangent is a number like a letter.
    """
    judge, in_degrees = worths.judge, isinstance(bound.end, Degrees)
    tangent, right = Apply("tan", bound.letter), worths.scene.desk.last_link(line).right
    value, most = worths.value(right), tidy(sp.tan(worths.scene.scalar(bound.end)))
    most = most if in_degrees else sp.Symbol(BOUND, positive=True)
    known = worths.known_in(value)
    pool: list[Ref] = [bound.ref, *extent]
    if not _is_at_most_a_right_angle(extent):
        met = meeting(worths.scene)
        acute = judge.write(
            (Move("sign"),), [line, *known, *met], relation_of(Link(tangent, ">", ZERO))
        )
        pool += [] if acute is None else [acute]
    limit = tree_of(most) if in_degrees else Apply("tan", bound.end)
    stripped = without_signs(worths.scene, expanded(value - most), bound.sign)
    compared = judge.write((Move("compare"),), pool, relation_of(Link(tangent, bound.sign, limit)))
    if compared is None or stripped is None:
        return None
    put = judge.write((Move("put"),), [compared, line], relation_of(Link(right, bound.sign, limit)))
    if put is None or in_degrees:
        return None if put is None else (put, *stripped)
    return solved_with(worths, put, stripped, limit)


def solved_with(
    worths: Worths, line: int, stripped: tuple[Sign, sp.Expr], limit: Expression
) -> Bounded | None:
    """An inequality with the ratio of a sum of angles in it, by the line that is solved for it."""
    known = worths.known_in(stripped[1])
    last = _solved(worths.scene, *stripped, limit)
    moves = (Move("rearrange"),)
    after = last and worths.judge.write(moves, [line, *known], relation_of(last))
    return (after, *stripped) if after else None


def _solved(scene: Scene, sign: Sign, x: sp.Expr, limit: Expression) -> Link | None:
    tangent = next((e for e in x.free_symbols if e.name == BOUND), None)
    symbols = [symbol for symbol in x.free_symbols if symbol != tangent]
    form = linear_in(x, symbols[0], angle=False) if len(symbols) == 1 else None
    if form is None:
        return None
    tree, _, slope, rest = form
    size = sp.N(slope.subs(tangent, scene.scalar(limit)))
    own = sign if size > 0 else FLIPPED[sign]
    right = tree_of(sp.apart(tidy(-rest / slope), tangent))
    return Link(tree, own, exchanged(right, {Letter(BOUND): limit}))


# Stands for the ratio of a bound that is a sum, while an inequality is solved.
BOUND = "_bound"


def relation_of(link: Link) -> Relation:
    """A relation of one link."""
    return Relation(((link,),))


def _is_at_most_a_right_angle(extent: tuple[Ref, ...]) -> bool:
    """Whether what is known of an angle says that it is no more than 90°."""
    return any(isinstance(ref, str) and ("90°" in ref or "acute" in ref) for ref in extent)
