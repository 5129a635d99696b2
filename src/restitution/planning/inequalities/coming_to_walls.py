"""That a body moves towards the wall that it hits, or at least not parallel to it."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.explaining.lines.derivation import FLIPPED, Fact, Link, Move, Ref, Relation, Sign
from restitution.expression.tree import Expression, Name, Quantity
from restitution.oracle import Relation as Formula
from restitution.planning.inequalities.angles_bounded import Bounded, relation_of
from restitution.planning.inequalities.standard_conditions import as_quadratic
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import together
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.inequalities import solve_linear, without_signs


def is_of_a_wall(worths: Worths, fact: Fact) -> bool:
    """Whether a fact says that a body comes to a wall."""
    kind, _, number = fact.id.partition(" ")
    return kind == "approach" and worths.scene.frame(int(number)).wall is not None


def write_towards(
    worths: Worths, fact: Fact, wanted: Expression | None
) -> tuple[int, Sign, sp.Expr] | None:
    """The line in which a component towards a wall is positive, or not zero, in letters.

    With it what has that sign, to be solved; what is not zero is solved already, where it can be.
    None where it holds anyway.
    """
    scene, judge = worths.scene, worths.judge
    (link,) = fact.relation.only
    match link.left:
        case Quantity("along", (Quantity("velocity", (Name(body),), int(stage)) as velocity, _)):
            pass
        case _:
            return None
    worths.determine(velocity)
    frame = scene.frame(int(fact.id.removeprefix("approach ")))
    own = worths.component("along", body, stage, frame)
    open_ = link.sign == "!="
    stripped = without_signs(scene, own.value, ">" if open_ else link.sign)
    if stripped is None:
        return None
    known = worths.known_in(own.value)
    put = Relation(((Link(tree_of(own.value), link.sign, ZERO),),))
    pool = [fact.id, *together(own.whole, frame.refs), *known]
    line = judge.write((Move("put"),), pool, put)
    if line is None or not open_:
        return None if line is None else (line, *stripped)
    solved = solve_linear(scene, ">", stripped[1], wanted)
    if solved is not None:
        last = Relation(((replace(solved, sign="!="),),))
        moves = (Move("rearrange"), Move("cancel"), Move("compare"))
        line = judge.write(moves, [line, *known], last) or line
    return line, "!=", stripped[1]


def solved_at_walls(worths: Worths, bounded: Bounded, wanted: Expression | None) -> int | None:
    """A quadratic inequality, without the factors that are positive as a body comes to a wall.

    None where there are no such factors, or what is left is no quadratic.
    """
    line, sign, x = bounded
    scene, mark = worths.scene, worths.mark()
    lines: list[Ref] = []
    factors = [*sp.Mul.make_args(x)]
    for fact in scene.desk.facts if len(factors) > 1 else ():
        if not scene.desk.holds(fact.id) or not is_of_a_wall(worths, fact):
            continue
        towards = write_towards(worths, fact, wanted)
        if towards is None or towards[1] != ">":
            continue
        number, _, gap = towards
        oracle = scene.model.ground.with_facts((Formula(gap, ">"),))
        signs = {own: proved_sign(oracle, own) for own in factors}
        solved = solve_linear(scene, ">", gap, wanted) or solve_linear(scene, ">", gap)
        pool = [number, *worths.known_in(gap)]
        last = solved and worths.judge.write((Move("rearrange"),), pool, relation_of(solved))
        lines.append(last or number)
        factors = [own for own in factors if not signs[own]]
        sign = FLIPPED[sign] if list(signs.values()).count(-1) % 2 else sign
    if lines and factors:
        rest = sp.Mul(*factors)
        known = (*lines, *worths.known_in(rest))
        after = as_quadratic(worths, line, sign, rest, wanted, known)
        if after != line:
            return after
    worths.back(mark)
    return None
