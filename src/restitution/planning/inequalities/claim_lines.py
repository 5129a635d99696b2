"""Lines of an inequality: compared with what stands, by the ranges of its letters."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Self

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.following.trials import names_in
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Link,
    Move,
    MoveId,
    Ref,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    is_binary,
    is_zero,
    letters,
    walk,
)
from restitution.planning.inequalities.conditions import Conditions
from restitution.planning.inequalities.degrees_by_ratios import bound_by_a_ratio
from restitution.planning.inequalities.letter_ties import Ties
from restitution.planning.inequalities.worths import Worths
from restitution.planning.routes.order import Solver
from restitution.planning.writing.forms import ONE, ZERO, tree_of
from restitution.planning.writing.inequalities import same, subject_of
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles

_R = sp.Dummy("r")


class ClaimLines:
    """What a part says of its letters: equations that tie them, and lines of conditions."""

    def __init__(self, scene: Scene, solver: Solver) -> None:
        self.scene = scene
        self.solver = solver
        self.judge = scene.judge
        self.worths = Worths(scene, solver)
        self.ties = Ties(self.worths)
        self.conditions = Conditions(self.worths)

    def __enter__(self) -> Self:
        self.scene.free |= self._tied_letters()
        return self

    def __exit__(self, *_: object) -> None:
        self.scene.free.clear()

    def _tied_letters(self) -> set[sp.Symbol]:
        """The letters of the statement that the facts tie to others."""
        model = self.scene.model
        components = {component.symbol for component in model.components.values()}
        return {
            symbol
            for symbol, value in model.final.items()
            if symbol not in components
            and symbol.name in model.unknowns.roles
            and sp.sympify(value, strict=True).free_symbols
        }

    def _ranges(self, lines: Sequence[int]) -> list[int]:
        """The ranges of the letters in some lines, where lines above say them."""
        desk = self.scene.desk
        inside = {n for number in lines for n in letters(desk.last_link(number).right)}
        return [line for letter in sorted(inside) for line in self.ranges_of(letter)]

    def ranges_of(self, letter: str) -> list[int]:
        """The lines above that say between what a letter is."""
        bounds = self._bounds_of(Letter(letter))
        return [bound for bound in bounds if len(self.scene.desk.relation(bound).only) == 2]

    def _bounds_of(self, subject: Expression) -> list[int]:
        """The lines above that bound a letter, or a ratio of one."""
        desk = self.scene.desk
        return [
            line.number
            for line in desk.lines
            if isinstance(line.relation, Relation)
            and len(line.relation.options) == 1
            and all(link.sign in FLIPPED for link in line.relation.only)
            and subject_of(line.relation) == subject
            and desk.holds(line.number)
        ]

    def monotone(self, line: int, relation: Relation, bounds: Sequence[Ref] = ()) -> int | None:
        """The ends of what only grows, or only falls, with one letter.

        Its range is what it may be anyway, or what lines tell that bound it.
        """
        known = roles(self.scene.problem)
        names = sorted(letters(self.scene.desk.last_link(line).right) & set(known))
        # What has two ends is bounded by them; of a mass the other end is far away.
        for name in sorted(names, key=lambda name: known[name].kind == "positive"):
            others = letters(self.scene.desk.last_link(line).right) - {name}
            pool = [line, *bounds, *self.judge.known([name]), *self.judge.known(others)]
            number_ = self.judge.write((Move("monotone"),), pool, relation)
            if number_ is not None:
                return number_
        return None

    def compared(
        self, refs: Sequence[Ref], relation: Relation, known_only: Sequence[Ref] = ()
    ) -> int | None:
        """A line by what is cited, and the ranges of letters."""
        for cited in refs:
            if isinstance(cited, int) and cited not in known_only:
                stated = self.scene.desk.line(cited).relation
                if isinstance(stated, Relation) and same(stated, relation):
                    return cited
        names: set[str] = set()
        for ref in refs:
            own = (
                self.scene.desk.line(ref).relation
                if isinstance(ref, int)
                else self.scene.facts[ref].relation
                if ref in self.scene.facts
                else None
            )
            if isinstance(own, Relation):
                names |= names_in(own)
        names |= names_in(relation)
        names &= set(roles(self.scene.problem)) | {angle.name for angle in self.scene.kept}
        pool = [*refs, *self.judge.known(names)]
        line = bound_by_a_ratio(self, relation, pool)
        if line is not None:
            return line
        rooted = self._rooted(refs, relation, pool)
        if rooted is not None:
            pool = [rooted, *pool]
        conditions = [
            ref
            for ref in refs
            if isinstance(ref, int)
            and isinstance(own := self.scene.desk.line(ref).relation, Relation)
            and own.options[0][0].sign != "="
        ]
        for condition in conditions:
            line = self.judge.write((Move("rearrange"),), [condition], relation)
            line = line or self._by_its_own_bound(condition, relation)
            if line is not None:
                return line
        kind: MoveId = "compare" if conditions else "sign"
        line = self.judge.write((Move(kind),), pool, relation)
        if line is not None:
            return line
        above = self._dividing(conditions, relation)
        if above:
            line = self.judge.write((Move("compare"),), [*refs, *above, *pool], relation)
            if line is not None:
                return line
        mark = self.worths.mark()
        several = self.coefficients(names)
        products = self.products(several)
        if products:
            rest = self.judge.known(names - set(several))
            line = self.judge.write((Move("compare"),), [*refs, *products, *rest], relation)
        if line is None:
            self.worths.back(mark)
        return line

    def _by_its_own_bound(self, condition: int, relation: Relation) -> int | None:
        """A bound of a quotient of letters, by the closer one that a line between them makes of it.

        ``u < 7v/3`` says that u/v is less than 7/3, and so less than 5/2.
        """
        own = self.scene.desk.relation(condition)
        match relation.options, own.options:
            case (
                ((Link(Binary("/", Letter(), Letter()) as ratio, sign, right),),),
                ((Link(low, "<" | "<=" | ">" | ">=", high),),),
            ) if not letters(right):
                above, below = (self.worths.value(side) for side in (ratio.left, ratio.right))
            case _:
                return None
        gap = sp.together(
            (self.worths.value(low) - self.worths.value(high)).subs(above, below * _R)
        )
        ends = sp.solve(sp.fraction(gap)[0], _R)
        if len(ends) != 1 or ends[0].free_symbols:
            return None
        for order in (sign, f"{sign[0]}="):
            closer = Relation(((Link(ratio, order, tree_of(ends[0])),),))  # type: ignore[arg-type]
            line = self.judge.write((Move("rearrange"),), [condition], closer)
            if line is not None:
                return self.judge.write((Move("compare"),), [line], relation)
        return None

    def coefficients(self, names: Iterable[str]) -> list[str]:
        """The coefficients of restitution among some letters."""
        known = roles(self.scene.problem)
        return sorted(n for n in names if n in known and known[n].kind == "restitution")

    def products(self, several: Sequence[str]) -> list[int]:
        """The bounds of a product of coefficients, where there are several."""
        if len(several) < 2:
            return []
        known = roles(self.scene.problem)
        product = tree_of(sp.Mul(*(known[name].symbol(name) for name in several)))
        bounds = (Link(product, ">", ZERO), Link(product, "<=", ONE))
        lines = [
            self.judge.write((Move("sign"),), self.judge.known(several), Relation(((bound,),)))
            for bound in bounds
        ]
        return [line for line in lines if line is not None]

    def _rooted(self, refs: Sequence[Ref], relation: Relation, pool: Sequence[Ref]) -> int | None:
        """The bound of a ratio by that of its square, where its angle is asked."""
        subject = subject_of(relation)
        if not isinstance(subject, Letter):
            return None
        standing = [
            line
            for ratio in ("tan", "sin", "cos")
            for line in self._bounds_of(Apply(ratio, subject))
            if len(self.scene.desk.relation(line).only) == len(relation.only) - 1
        ]
        if standing:
            return standing[0]
        for ref in refs:
            own = self.scene.desk.line(ref).relation if isinstance(ref, int) else None
            match own.options if isinstance(own, Relation) else ():
                case (
                    (
                        Link(
                            Binary("^", Apply(name, Letter() as letter) as ratio, power),
                            sign,
                            right,
                        ),
                    ),
                ):
                    if (
                        letter != subject
                        or sign not in FLIPPED
                        or name not in ("sin", "cos", "tan")
                    ):
                        continue
                    if power != Number(Fraction(2)):
                        continue
                    root = tree_of(tidy(sp.sqrt(self.worths.value(right))))
                    links = (
                        (Link(ZERO, "<", ratio), Link(ratio, sign, root))
                        if sign[0] == "<"
                        else (Link(ratio, sign, root),)
                    )
                    return self.judge.write((Move("compare"),), pool, Relation((links,)))
        return None

    def _dividing(self, conditions: Sequence[int], relation: Relation) -> list[Ref]:
        """The lines under conditions in which a letter divides that a range has above zero.

        So it is not zero: what takes the time d/(eu) comes to its end.
        """
        match relation.options:
            case ((Link(left, "<", Letter() as letter), *_),) if is_zero(left):
                pass
            case _:
                return []
        refs = {ref for condition in conditions for ref in self.scene.desk.under(condition)}
        return [
            ref
            for ref in sorted(numbers_in(refs))
            if any(
                is_binary(node, "/") and letter in walk(node.right)
                for tree in self._trees(ref)
                for node in walk(tree)
            )
        ]

    def _trees(self, number: int) -> Iterable[Expression]:
        """The trees of a line; none of one that introduces a letter."""
        own = self.scene.desk.line(number).relation
        return trees_of(own) if isinstance(own, Relation) else ()
