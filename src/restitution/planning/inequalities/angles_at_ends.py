"""Angles that grow, or fall, with one letter: bounded by what they are at its ends.

Such an angle is a line already, a sum or a difference of inverse tangents: ``arctan(4/3) +
arctan(4e/3)`` grows with e.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, Sign
from restitution.explaining.moves.limits import worth_at
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import Expression, Letter, Quantity, is_quantity, letters
from restitution.planning.angles.expressions import write_expression
from restitution.planning.angles.turning import angle_line
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.letter_ranges import ranges_of
from restitution.planning.routes.determining import determine
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import cancelled, expanded
from restitution.solving.story.letters import roles


class AngleAtEnds:
    """An angle of the motion as a line has it, between its values at the ends of a letter."""

    def __init__(
        self, claims: Claims, solver: Solver, asked: Expression, line: int | None = None
    ) -> None:
        self.claims = claims
        self.scene = claims.scene
        self.judge = claims.judge
        self.asked = asked
        self.line = self._standing(solver) if line is None else line
        self.right = self.scene.desk.last_link(self.line).right
        self.value = sp.sympify(self.scene.scalar(self.right), strict=True)

    def _standing(self, solver: Solver) -> int:
        """The line that says the angle, or a sum of such angles and those of the data."""
        for quantity in self.claims.worths.quantities(self.asked):
            determine(self.scene, solver, quantity)
        if isinstance(self.asked, Quantity):
            return angle_line(self.scene, self.asked)
        return write_expression(self.scene, self.asked)[0]

    def names(self) -> list[str]:
        """The letters of the statement in the angle."""
        return sorted(letters(self.right) & set(roles(self.scene.problem)))

    def at(self, name: str, end: sp.Expr) -> Expression:
        """The angle where a letter has a value, in degrees or by inverse tangents."""
        role = roles(self.scene.problem)[name]
        there = _with_acute(self._value_at(role.symbol(name), end), self._acute())
        if there.has(sp.zoo, sp.oo, sp.nan):
            raise NotPlannedError("an angle that has no value at an end")
        return tree_of(_tidied(there), angle=True, as_it_is=True)

    def bounded(self, relation: Relation, bounds: tuple[Ref, ...] = ()) -> int | None:
        """The line of a relation that says what the angle is at the ends of a letter."""
        for name in self.names():
            others = set(self.names()) - {name}
            pool = [self.line, *bounds, *self.judge.known([name]), *self.judge.known(others)]
            pool += self._meaning()
            line = self.judge.write((Move("monotone"),), pool, relation)
            if line is not None:
                return line
        return None

    def _meaning(self) -> list[Ref]:
        """What introduces the letter of the angle, where its line has that."""
        if not isinstance(self.asked, Quantity):
            return []
        known = letter_known(self.scene, self.asked)
        left = self.scene.desk.last_link(self.line).left
        return [known[1]] if known is not None and left == Letter(known[0]) else []

    def bounded_twice(self, relation: Relation) -> int | None:
        """The line of a bound that comes of one at an end of a letter, and of another letter.

        From α + arctan(e tan α) ≤ 2α, as e ≤ 1, comes ≤ 60° where α ≤ 30°.
        """
        match relation.options:
            case ((Link(left, "<" | "<=" | ">" | ">=" as sign),),) if left == self.asked:
                pass
            case _:
                return None
        closed: Sign = "<=" if sign[0] == "<" else ">="
        for name in self.names():
            others = [other for other in self.names() if other != name]
            for end, bounds in self.ends_of(name):
                mark = self.scene.desk.mark()
                there = Relation(((Link(self.asked, closed, self.at(name, end)),),))
                line = self.bounded(there, bounds)
                if line is not None:
                    for known in self.judge.known(others):
                        if self.judge.follows(Move("compare"), (line, known), relation):
                            return self.scene.desk.write(Move("compare"), (line, known), relation)
                self.scene.desk.back(mark)
        return None

    def ranges(self) -> Iterator[tuple[Relation, tuple[Ref, ...]]]:
        """The range of the angle by that of its letter, with the lines that bound this."""
        names = self.names()
        if len(names) != 1:
            return
        (name,) = names
        for ends, refs in self._ranges_of(name):
            grows = self._slope(name, ends)
            low, high = ends if grows else ends[::-1]
            signs: list[Sign] = ["<=" if closed else "<" for _, closed in (low, high)]
            links = (
                Link(self.at(name, low[0]), signs[0], self.asked),
                Link(self.asked, signs[1], self.at(name, high[0])),
            )
            yield Relation((links,)), refs

    def ends_of(self, name: str) -> Iterator[tuple[sp.Expr, tuple[Ref, ...]]]:
        """The ends of a letter that belong to its range, with the lines that bound it."""
        for ends, refs in self._ranges_of(name):
            for end, closed in ends:
                if closed:
                    yield end, refs

    def _ranges_of(
        self, name: str
    ) -> Iterator[tuple[Sequence[tuple[sp.Expr, bool]], tuple[Ref, ...]]]:
        """The ranges of a letter, as lines tell them or as they are anyway, with these lines."""
        for bound in ranges_of(self.claims, name):
            yield self._ends(bound), (bound,)
        role = roles(self.scene.problem)[name]
        if role.low is not None and role.high is not None:
            yield list(zip((role.low, role.high), role.closed, strict=True)), ()

    def _acute(self) -> list[sp.Symbol]:
        known = {name: roles(self.scene.problem)[name] for name in self.names()}
        return [
            role.symbol(name)
            for name, role in known.items()
            if role.kind == "angle"
            and role.low is not None
            and role.high is not None
            and role.low >= 0
            and role.high <= sp.pi / 2
        ]

    def _ends(self, bound: int) -> list[tuple[sp.Expr, bool]]:
        low, high = self.scene.desk.relation(bound).only
        return [
            (sp.sympify(self.scene.scalar(low.left), strict=True), low.sign == "<="),
            (sp.sympify(self.scene.scalar(high.right), strict=True), high.sign == "<="),
        ]

    def _slope(self, name: str, ends: Sequence[tuple[sp.Expr, bool]]) -> bool:
        """Whether the angle is greater at the upper end."""
        symbol = roles(self.scene.problem)[name].symbol(name)
        low, high = (self._value_at(symbol, end) for end, _ in ends)
        return self.scene.model.sign(high - low) > 0

    def _value_at(self, symbol: sp.Symbol, end: sp.Expr) -> sp.Expr:
        """The angle at an end; arctan(k tan α) is 90° there if α is."""
        there = worth_at(self.value, symbol, end)
        return sp.nan if there is None else there


def write_at_ends(claims: Claims, solver: Solver, relation: Relation) -> int:
    """An inequality of one angle of the motion, by what that is at the end of a letter.

    Raises NotPlannedError for what is no such inequality.
    """
    sides = [side for link in relation.only for side in (link.left, link.right)]
    angles = dict.fromkeys(side for side in sides if is_angle_of_motion(side))
    if len(angles) != 1:
        raise NotPlannedError("an inequality")
    (asked,) = angles
    own = AngleAtEnds(claims, solver, asked)
    line = own.bounded(relation) or own.bounded_twice(relation)
    if line is None:
        raise NotPlannedError("an inequality")
    return line


def is_angle_of_motion(tree: Expression) -> bool:
    """Whether an expression is an angle that velocities make."""
    return is_quantity(tree, *UNSIGNED_ANGLES)


def _with_acute(value: sp.Expr, acute: list[sp.Symbol]) -> sp.Expr:
    """A value with arctan(tan φ) as φ, for acute angles."""
    put = {
        inverse: other
        for inverse in value.atoms(sp.atan)
        for other in acute
        if inverse.args[0] == sp.tan(other)
        or cancelled(inverse.args[0] * sp.cos(other) / sp.sin(other)) == 1
    }
    return value.xreplace(put)


def _tidied(value: sp.Expr) -> sp.Expr:
    """A sum of inverse tangents, each of its shortest argument."""
    own = value.replace(sp.atan, lambda x: sp.atan(tidy(x)))
    return expanded(own)


__all__ = ["AngleAtEnds", "is_angle_of_motion", "write_at_ends"]
