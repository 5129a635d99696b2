"""The angles of a path to a wall, before and after, that linear facts determine by themselves.

*α + β = 75°* and *β = 30°* give α = 45°: no formula for a sum of angles is needed.
"""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Quantity,
    has_quantity,
    letters,
)
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.writing.angles import angle_of_approach, data_of_approach
from restitution.planning.writing.desk import chain, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import derivative, expanded
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.records import dataclass


@dataclass(frozen=True)
class _Fact:
    """A linear fact of both angles: a line in their letters, and what is zero by it."""

    line: int
    relation: Relation
    gap: sp.Expr


def write_angles_at_walls(scene: Scene) -> set[str]:
    """Writes both angles, where two facts give them and one at most is given in degrees.

    Returns the facts that say no more then: of the two, the one that is no angle after the impact.
    """
    idle: set[str] = set()
    for number, frame in scene.model.frames.items():
        if frame.wall is None or scene.others or f"axis {number}" not in scene.facts:
            continue
        body = scene.bodies(number)[0]
        before = angle_of_approach(scene, body, scene.frame(number))
        if not isinstance(before, Letter) or not scene.unknown(scene.scalar(before)):
            continue
        mark = scene.desk.mark()
        own = _write(scene, body, number, before)
        if own is None:
            scene.desk.back(mark)
        else:
            idle.add(own)
    return idle


def _write(scene: Scene, body: str, event: int, before: Letter) -> str | None:
    wall = scene.frame(event).wall
    assert wall is not None
    velocity = Quantity("velocity", (Name(body),), event)
    after = Quantity("angle", (velocity, Name(wall)))
    turned = Quantity("deflection", (Name(body),), event)
    spoken = [
        equation for equation in scene.given if _speaks(scene, equation, before, after, turned)
    ]
    if len(spoken) != 2:
        return None
    name, meaning = letter_of(scene, after)
    other = Letter(name)
    symbols = {letter: sp.Symbol(letter) for letter in (before.name, name)}
    facts: list[_Fact] = []
    for equation in spoken:
        sides = [
            exchanged(side, {after: other}) for side in _sides(equation, turned, before, other)
        ]
        if any(map(has_quantity, sides)) or {*letters(sides[0]), *letters(sides[1])} - {*symbols}:
            return None
        gap = expanded(scene.worth(sides[0], symbols) - scene.worth(sides[1], symbols))
        if not gap.is_polynomial(*symbols.values()) or sp.total_degree(gap, *symbols.values()) != 1:
            return None
        relation = chain(sides[0], (sides[1], None))
        if turned in (equation.link.left, equation.link.right):
            move = Move("define", "sum", event, (body,))
            pool = (*data_of_approach(scene, body, scene.frame(event)), meaning)
        else:
            move, pool = Move("fact"), (meaning,)
            if scene.judge.follows(move, (equation.fact.id,), relation):
                pool = ()
        cited = (equation.fact.id, *pool) if move.id == "fact" else together(equation.refs, pool)
        line = scene.judge.write((move,), cited, relation)
        if line is None:
            return None
        facts.append(_Fact(line, relation, gap))
    if not _solved(scene, facts, symbols, (before, other)):
        return None
    useful = next((e for e in spoken if e.link.left == after), None)
    useful = useful or next((e for e in spoken if turned in (e.link.left, e.link.right)), spoken[0])
    return next(equation.fact.id for equation in spoken if equation is not useful)


def _speaks(
    scene: Scene, equation: GivenEquation, before: Letter, after: Quantity, turned: Quantity
) -> bool:
    """Whether a fact is an equation of the two angles, of their sum, or of one of them."""
    if equation.link.sign != "=":
        return False
    trees = equation.fact.relation.only[0], equation.link
    nodes = {side for link in trees for side in (link.left, link.right)}
    named = {name for side in nodes for name in letters(side)}
    let = scene.facts.get(f"let {next(iter(named - {before.name}), '')}")
    own = let is not None and let.relation.only[0].left == after
    return before.name in named or own or after in nodes or turned in nodes


def _sides(
    equation: GivenEquation, turned: Quantity, before: Letter, after: Letter
) -> tuple[Expression, Expression]:
    """The sides of a fact, in which a deflection is the sum of the angles."""
    own = equation.fact.relation.only[0] if len(equation.fact.relation.only) == 1 else equation.link
    whole = Binary("+", before, after)
    left, right = (whole if side == turned else side for side in (own.left, own.right))
    if any(map(has_quantity, (left, right))):
        left, right = (
            whole if e == turned else e for e in (equation.link.left, equation.link.right)
        )
    return left, right


def _solved(
    scene: Scene,
    facts: list[_Fact],
    symbols: dict[str, sp.Symbol],
    angles: tuple[Letter, Letter],
) -> bool:
    """Writes what the angles come to, one after the other; False where the facts do not say it."""
    names = [symbols[angle.name] for angle in angles]
    solution = sp.linsolve([fact.gap for fact in facts], names)
    values = next(iter(solution), ())
    if len(values) != 2 or any(not value.is_number for value in values):
        return False
    trees = {
        angle: tree_of(tidy(value), angle=True) for angle, value in zip(angles, values, strict=True)
    }
    lone = [fact for fact in facts if len(fact.gap.free_symbols) == 1]
    if len(lone) == 2:
        return False  # each is given by itself
    known: dict[Letter, int] = {}
    if lone:
        (symbol,) = lone[0].gap.free_symbols
        known[Letter(symbol.name)] = lone[0].line
        rest = next(fact for fact in facts if fact is not lone[0])
    else:
        first, rest = angles[1], facts[0]
        for eliminated in angles:
            (left,) = (angle for angle in angles if angle != eliminated)
            line = _without(scene, facts, eliminated, left, trees[left])
            if line is not None:
                first = left
                break
        else:
            return False
        known[first] = line
    (second,) = (angle for angle in angles if angle not in known)
    ((one, line),) = known.items()
    for relation in _steps(scene, rest, one, second, trees):
        put = scene.judge.write((Move("put"), Move("rearrange")), (rest.line, line), relation)
        if put is not None:
            known[second] = put
            break
    else:
        return False
    for angle, number in known.items():
        scene.desk.know(angle, scene.scalar(trees[angle]), (number,))
    return True


def _without(
    scene: Scene, facts: list[_Fact], eliminated: Letter, left: Letter, value: Expression
) -> int | None:
    """One angle of two equations: by putting in what one says of the other, or by adding them."""
    lines, last = [fact.line for fact in facts], chain(left, (value, None))
    for own, other in (facts, facts[::-1]):
        (link,) = own.relation.only
        if link.left != eliminated or letters(link.right) != {left.name}:
            continue
        factor = expanded(other.gap.subs(sp.Symbol(eliminated.name), 0)).coeff(
            sp.Symbol(left.name)
        ) + other.gap.coeff(sp.Symbol(eliminated.name)) * derivative(
            scene.worth(link.right, {left.name: sp.Symbol(left.name)}), sp.Symbol(left.name)
        )
        whole = Binary("*", tree_of(tidy(factor)), left)
        constant = tree_of(tidy(factor) * scene.scalar(value), angle=True)
        put = scene.judge.write(
            (Move("put"),), (other.line, own.line), chain(whole, (constant, None))
        )
        return put and scene.judge.write((Move("rearrange"),), (put,), last)
    return scene.judge.write((Move("combine", eliminated=eliminated.name),), lines, last)


def _steps(
    scene: Scene, rest: _Fact, one: Letter, second: Letter, trees: dict[Letter, Expression]
) -> Iterator[Relation]:
    """The second angle by a fact and the first one: as it is worked out, and as it is."""
    gap = rest.gap
    slope, more = gap.coeff(sp.Symbol(second.name)), gap.coeff(sp.Symbol(one.name))
    constant = gap - slope * sp.Symbol(second.name) - more * sp.Symbol(one.name)
    if abs(slope) == 1 and abs(more) == 1:
        whole, sign = -constant / slope, "-" if more / slope > 0 else "+"
        if whole > 0:
            right = Binary(sign, tree_of(tidy(whole), angle=True), trees[one])  # type: ignore[arg-type]
            yield chain(second, (right, None), (trees[second], "rearrange"))
    yield chain(second, (trees[second], None))


__all__ = ["write_angles_at_walls"]
