"""Spheres that separate and meet again as one of them comes back from a wall, or do not."""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.data.meeting_again import Return, catching_up, returning
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import Binary, Expression, Negate
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.comparisons import Comparison
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import ZERO, swept, tree_of
from restitution.planning.writing.polynomials import factored
from restitution.problem import Meets
from restitution.solving.equations.facts import comes_back


def write_meeting_again(claims: Claims, relation: Meets, now: int) -> tuple[int, Relation] | None:
    """That two bodies that have met meet again, or do not; None of two that have not met.

    Who is behind and faster catches up. Of two that separate, one may come back from a wall.
    """
    scene = claims.scene
    link = catching_up(scene.problem, relation, now)
    if link is None:
        return None
    names = relation.first.name, relation.second.name
    if not comes_back(scene.model.story, *names, now) or (
        relation.happens and _catches_up(claims, link)
    ):
        return Comparison(claims).write(link)
    back = returning(scene.problem, relation, now)
    if back is None:
        raise NotPlannedError("spheres that separate, of which one may come back")
    return _Way(claims, back, now).write(happens=relation.happens)


def _catches_up(claims: Claims, link: Link) -> bool:
    """Whether it is plain that the one behind is the faster."""
    scene = claims.scene
    gap = sp.sympify(scene.scalar(link.left) - scene.scalar(link.right), strict=True)
    return scene.model.proved_sign(gap) == 1


class _Way:
    """The way of a sphere to a wall and back to another."""

    def __init__(self, claims: Claims, back: Return, now: int) -> None:
        self.claims = claims
        self.scene = claims.scene
        self.back = back
        comparison = Comparison(claims)
        self.own, self.own_refs, self.pace = comparison.component(
            back.component(back.returning, now)
        )
        self.other, self.other_refs, self.rest = comparison.component(
            back.component(back.other, now)
        )
        e, self.e_refs = self.scene.put(self.scene.scalar(back.e))
        self.e = sp.sympify(e, strict=True)

    def write(self, *, happens: bool) -> tuple[int, Relation]:
        """How it comes back, how the gap closes then, and what follows."""
        gap = swept(self.back.gap(self.own, self.other))
        returned = self._returned()
        whole = tidy(factored(self.rest + self.e * self.pace))
        put = swept(Binary("+", tree_of(self.rest), tree_of(self.e * self.pace)))
        lines = together(self.other_refs, (returned,) if returned else self.own_refs, self.e_refs)
        relation = chain(gap, (put, None), (tree_of(whole), "rearrange"))
        line = self._written(relation, lines)
        if line is None:
            raise NotPlannedError("how a gap closes by way of a wall")
        closing = Link(gap, self.back.sign(">" if happens else "<="), ZERO)
        number = self._concluded(line, closing, happens=happens)
        if number is None:
            raise NotPlannedError("whether a gap closes by way of a wall")
        return number, self.scene.desk.relation(number)

    def _concluded(self, line: int, closing: Link, *, happens: bool) -> int | None:
        """The last line: that it moves to the wall and the gap closes, or that the gap does not.

        That it closes is enough where both take proofs of their own: who separates, and is met on
        the way back, moved to the wall.
        """
        towards = Link(self.own, self.back.sign(">"), ZERO)
        for more in ((), self.claims.conditions.lines()):
            both = Relation(((towards, closing),))
            number = self._compared(both, [*self.own_refs, line, *more]) if happens else None
            number = number or self._compared(Relation(((closing,),)), [line, *more])
            if number is not None:
                return number
        return None

    def _compared(self, relation: Relation, refs: Sequence[Ref]) -> int | None:
        return self.claims.compared(together(refs), relation)

    def _returned(self) -> int | None:
        """The line of the speed with which it comes back; None where that is as it was, or 0."""
        if self.e in (0, 1):
            return None
        speed: Expression = Binary("*", self.back.e, self.own)
        if self.back.side < 0:
            speed = Negate(speed)
        relation = chain(swept(speed), (tree_of(tidy(self.back.side * self.e * self.pace)), None))
        return self._written(relation, together(self.own_refs, self.e_refs))

    def _written(self, relation: Relation, refs: Sequence[Ref]) -> int | None:
        moves = (Move("put"), Move("combine"), Move("rearrange"))
        return self.claims.judge.write(moves, refs, relation)
