"""What is to be shown of angles: of one, of two that are equal, of the sum of two."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from contextlib import suppress
from dataclasses import replace
from functools import partial

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    Link,
    Meaning,
    Move,
    MoveId,
    Ref,
    Relation,
)
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    is_quantity,
    letters,
    unsigned,
)
from restitution.planning.angles.angle_sums import write_tangent_of_sum, write_tangent_of_two
from restitution.planning.angles.angles_by_letters import write_by_equal_letters
from restitution.planning.angles.ratios_by_speeds import write_ratio_of_path
from restitution.planning.angles.turning import angle_line, is_angle
from restitution.planning.inequalities.claims import Claims
from restitution.planning.shows.speeds_of_angles import (
    ratios_of_velocities,
    speeds_by_components,
)
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import (
    alike,
    is_rational,
    square,
    tree_of,
)
from restitution.planning.writing.judging import Judge
from restitution.planning.writing.scene import Scene

_TO_FORM = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))
_LAST_LINKS: tuple[MoveId | None, ...] = (None, "rearrange", "identity")


def says(scene: Scene, line: int, link: Link) -> bool:
    """Whether a line is an equation, but for the order of its factors."""
    if len(scene.desk.relation(line).options) > 1:
        return False
    own = scene.desk.last_link(line)
    same = own.sign == link.sign and own.left == link.left
    return same and is_form_of(scene, (own.right, link.right))


def is_form_of(scene: Scene, pair: tuple[Expression, Expression]) -> bool:
    """Whether two expressions are one, but for the order of factors or a decimal point."""
    if all(is_rational(unsigned(tree)) for tree in pair):
        one, other = (sp.sympify(scene.scalar(tree), strict=True) for tree in pair)
        return bool(one == other)
    return alike(*pair)


class ShownAngles(ABC):
    """Equations of angles that are to be shown, and of speeds by angles."""

    claims: Claims
    scene: Scene
    judge: Judge
    link: Link
    relation: Relation

    @abstractmethod
    def _last(self, pool: Sequence[Ref]) -> int | None:
        """The line in the printed form, by what is cited."""

    @abstractmethod
    def _known(self, names: AbstractSet[str]) -> tuple[Ref, ...]:
        """What may be cited of letters."""

    def _of_equal_angles(self, *sides: Expression) -> int | None:
        """Two angles that are the same: each as an angle, in letters."""
        angles = [
            side for side in sides if isinstance(side, Quantity) and is_angle(self.scene, side)
        ]
        if len(angles) != len(sides):
            return None
        lines: list[int] = []
        names: list[Ref] = []
        try:
            for angle in angles:
                self.claims.worths.determine(angle)
                lines.append(angle_line(self.scene, angle))
                names += self.claims.worths.name_of(angle)
        except NotPlannedError:
            return None
        refs = [*(write_by_equal_letters(self.scene, lines) or lines), *names]
        return self.judge.write((Move("put"),), [*refs, *self._lets_of(*angles)], self.relation)

    def _lets_of(self, *angles: Quantity) -> list[int]:
        """The lines that introduce letters for angles."""
        desk = self.scene.desk
        return [
            line.number
            for line in desk.lines
            if isinstance(line.relation, Meaning) and line.relation.quantity in angles
        ]

    def _speed_by_an_angle(self, quantities: Sequence[Quantity]) -> int | None:
        """A speed in terms of the angle of its velocity to a line: a component, by that."""
        claims, sides = self.claims, (self.link.left, self.link.right)
        named = self._speeds_in_letters()
        for speed in (*quantities, *named):
            if speed.kind != "speed" or not isinstance(speed.stage, int):
                continue
            velocity = replace(speed, kind="velocity")
            for own, ratio in ratios_of_velocities(claims, *sides):
                if own != velocity:
                    continue
                mark = claims.worths.mark()
                claims.worths.determine(velocity)
                for line, lets in speeds_by_components(claims, speed, ratio):
                    if self.scene.desk.relation(line) == self.relation:
                        return line
                    names = letters(self.link.left) | letters(self.link.right)
                    facts = named.get(speed, ())
                    form = self._last([line, *facts, *lets, *self._known(names)])
                    if form is not None:
                        return form
                claims.worths.back(mark)
        return None

    def _speeds_in_letters(self) -> dict[Quantity, tuple[Ref, ...]]:
        """The speeds for which letters of the equation are given, with what says so."""
        names = letters(self.link.left) | letters(self.link.right)
        speeds: dict[Quantity, tuple[Ref, ...]] = {}
        for given in self.scene.given:
            match given.link:
                case Link(Quantity("speed") as speed, "=", Letter(name)) if name in names:
                    speeds[speed] = given.refs
        return speeds

    def _ratio_as_asked(self, angle: Quantity) -> int | None:
        """A ratio of an angle as it is written where it is asked, then in the printed form."""
        match self.link.left:
            case Apply("sin" | "cos" | "tan" as function, tree) | Binary(
                "^", Apply("sin" | "cos" as function, tree)
            ) if is_angle(self.scene, tree):
                pass
            case _:
                return None
        # The sine of an angle that may be 0 comes by its cosine: its square tells it, too.
        squared = isinstance(self.link.left, Binary) and function == "sin"
        for ratio in (function, "cos") if squared else (function,):
            mark = self.claims.worths.mark()
            try:
                self.claims.worths.determine(angle)
                line, _ = write_ratio_of_path(self.scene, ratio, tree)
            except NotPlannedError:
                self.claims.worths.back(mark)
                continue
            if says(self.scene, line, self.link):
                return line
            right = self.scene.desk.last_link(line).right
            names = self._known(letters(right) | letters(tree))
            if ratio != function:
                relation = chain(square(Apply(ratio, tree)), (_squared(self.scene, right), None))
                line = self.judge.write((Move("rearrange"),), [line, *names], relation) or line
            printed = self._last([line, *self.claims.worths.name_of(angle), *names])
            if printed is not None:
                return printed
            self.claims.worths.back(mark)
        return None

    def _turned(self, angle: Quantity) -> int | None:
        """The tangent of an angle between two velocities, by their angles to one line."""
        mark = self.claims.worths.mark()
        match self.link.left:
            case Apply("tan", inside) if isinstance(inside, Letter) or is_quantity(
                inside, *UNSIGNED_ANGLES
            ):
                line = self.claims.worths.turned(angle, by_letter=True)
            case _:
                line = write_tangent_of_two(self.scene, self.link.left)
        if line is None:
            return None
        written = self._in_printed_form(line, self.claims.worths.name_of(angle))
        if written is None:
            self.claims.worths.back(mark)
        return written

    def _of_two_angles(self) -> int | None:
        """The tangent of a sum or a difference of two letters for angles, by both tangents."""
        match self.link.left:
            case Apply("tan", Letter() as letter):
                write = partial(write_tangent_of_sum, self.scene, letter)
            case Apply("tan", Binary("+" | "-", Letter(), Letter())):
                write = partial(write_tangent_of_two, self.scene, self.link.left)
            case _:
                return None
        opened = self.claims.worths.opened(self.link.left)
        match opened:
            case Apply(_, Binary(_, one, other)):
                angles = [side for side in (one, other) if isinstance(side, Quantity)]
            case _:
                return None
        mark = self.claims.worths.mark()
        with suppress(NotPlannedError):
            for angle in angles:
                self.claims.worths.determine(angle)
            line = write() if angles else None
            written = None if line is None else self._in_printed_form(line)
            if written is not None:
                return written
        self.claims.worths.back(mark)
        return None

    def _in_printed_form(self, line: int, named: tuple[Ref, ...] = ()) -> int | None:
        """A line of a tangent that ends in the printed form, or is followed by that."""
        desk, (left, right) = self.scene.desk, (self.link.left, self.link.right)
        own = desk.line(line)
        first = desk.relation(line).only[0].right
        pool = (*own.premises, *named, *self.judge.known(letters(first) | letters(right)))
        for by in _LAST_LINKS:
            printed = chain(left, (first, None), (right, by))
            refs = self.judge.needed(own.move, pool, printed, own.premises)
            if refs is not None and own.number == len(desk.lines):
                desk.lines.pop()
                return desk.write(own.move, refs, printed)
        names = self.judge.known(letters(first) | letters(right))
        written = self.judge.write(_TO_FORM, [line, *named, *names], self.relation)
        if written is None:
            # By a letter of the statement for a tangent.
            known = self._known(letters(first) | letters(right))
            own_refs = [line, *named, *known]
            written = self.judge.write((Move("put"),), own_refs, self.relation)
            written = written or self._last(own_refs)
        return written


def _squared(scene: Scene, tree: Expression) -> Expression:
    """The square of a value; of a quotient that of what is above and of what is below."""
    match tree:
        case Apply("sqrt", inside):
            return inside
        case Binary("/", above, below):
            return Binary("/", _squared(scene, above), _squared(scene, below))
    return square(tree) if letters(tree) else tree_of(tidy(scene.scalar(tree) ** 2))
