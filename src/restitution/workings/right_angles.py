"""Angles of the motion that are 90° for some value of a letter, where they have no tangent."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.derivation import Derivation, Line, Link, Ref, Relation
from restitution.explaining.saying import Sentence, say
from restitution.explaining.trees import rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Quantity,
    letters,
    walk,
)
from restitution.oracle import Role
from restitution.planning.forms import factors, tree_of
from restitution.workings.naming import Naming

_RIGHT_ANGLE = Degrees(Fraction(90))


class RightAngles:
    """The right angles among those of the tangents of one derivation."""

    def __init__(self, derivation: Derivation, naming: Naming, roles: Mapping[str, Role]) -> None:
        self._derivation = derivation
        self._naming = naming
        self._roles = roles

    def of(self, line: Line) -> Sentence | None:
        """What is said behind a tangent of an angle that may be 90°, or made of such a one."""
        return self._right_angle(line) or self._upright_too(line)

    def _right_angle(self, line: Line) -> Sentence | None:
        """For which value of a letter an angle of the motion has no tangent, since it is 90°."""
        pole = self._pole(line)
        if pole is None:
            return None
        angle, name, root = pole
        right = Relation(((Link(angle, "=", _RIGHT_ANGLE),),))
        at = Relation(((Link(Letter(name), "=", tree_of(root)),),))
        return say(
            "derived.right-angle", angle=self._naming.relation(right), at=self._naming.relation(at)
        )

    def _upright_too(self, line: Line) -> Sentence | None:
        """That a tangent holds too where one of which it is made has none, as that angle is 90°."""
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(Apply("tan", Letter() as turn), "="), *_),) if line.move.id == "put":
                value = in_letters_alone(line.relation.only[-1].right)
            case _:
                return None
        above = [own for ref in line.premises if (own := self._line(ref)) is not None]
        poles = [pole for own in above if (pole := self._pole(own)) is not None]
        sums = (own for own in self._derivation.lines if own.number < line.number)
        whole = next((r for own in sums if (r := _made_of(own, turn)) is not None), None)
        if len(poles) != 1 or whole is None or value is None:
            return None
        angle, name, root = poles[0]
        there = rebuilt(whole, lambda each: _RIGHT_ANGLE if each == angle else each)
        at = in_letters_alone(there)
        if there == whole or at is None:
            return None
        tangent = sp.tan(sp.expand(at)) if at.has(sp.pi) else None
        known = value.subs(sp.Symbol(name), root)
        if tangent is None or tidy(sp.expand_trig(tangent) - known) != 0:
            return None
        where = Relation(((Link(Letter(name), "=", tree_of(root)),),))
        turned = Relation(((Link(turn, "=", there),),))
        return say(
            "derived.upright-too",
            at=self._naming.relation(where),
            angle=self._naming.relation(turned),
        )

    def _pole(self, line: Line) -> tuple[Expression, str, sp.Expr] | None:
        """The angle whose tangent a line gives, and the value of a letter at which it has none."""
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(Apply("tan", angle), "="), *_),) if line.move.id in ("define", "rearrange"):
                value = line.relation.only[-1].right
            case _:
                return None
        meaning = self._naming.meanings.get(angle.name) if isinstance(angle, Letter) else None
        meant = angle if meaning is None else meaning.quantity
        if not isinstance(meant, Quantity) or meant.kind not in ("angle", "deflection"):
            return None
        below = [e.right for e in walk(value) if isinstance(e, Binary) and e.op == "/"]
        for factor in (each for tree in below for each in factors(tree)):
            (name, *more) = letters(factor) or ("",)
            if more or not name or not isinstance(factor, Binary) or factor.op not in ("+", "-"):
                continue
            letter, above = sp.Symbol(name), in_letters_alone(value)
            difference = in_letters_alone(factor)
            if difference is None or above is None or not difference.is_polynomial(letter):
                continue
            for root in sp.roots(sp.Poly(difference, letter)):
                over, under = sp.fraction(sp.together(above))
                is_pole = under.subs(letter, root) == 0 != over.subs(letter, root)
                if is_pole and self._may_be(name, root):
                    return angle, name, root
        return None

    def _may_be(self, name: str, value: sp.Expr) -> bool:
        """Whether a letter may have a value, which is a number, by its role and by the data."""
        role = self._roles.get(name)
        if role is None or role.kind == "angle" or not value.is_Rational:
            return False
        for end, sign_, closed in ((role.low, 1, role.closed[0]), (role.high, -1, role.closed[1])):
            if end is not None and not (sign_ * (value - end) > 0 or (closed and value == end)):
                return False
        return not any(
            name in letters(side)
            for fact in self._derivation.facts
            if fact.kind == "range"
            for links in fact.relation.options
            for link in links
            for side in (link.left, link.right)
        )

    def _line(self, ref: Ref) -> Line | None:
        """A line with a relation among the premises."""
        own = self._derivation.line(ref) if isinstance(ref, int) else None
        return own if own is not None and isinstance(own.relation, Relation) else None


def _made_of(line: Line, turn: Letter) -> Expression | None:
    """The sum or difference of angles that a line says an angle is."""
    match line.relation:
        case Relation(((Link(left, "=", Binary("+" | "-") as right),),)) if left == turn:
            return right
    return None


def in_letters_alone(tree: Expression) -> sp.Expr | None:
    """What a tree is worth in its letters; None where it holds more than these."""
    try:
        return in_letters(tree)
    except RestitutionError:
        return None


__all__ = ["RightAngles", "in_letters_alone"]
