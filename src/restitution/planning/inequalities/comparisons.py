"""Components of two bodies along one line compared: who is the faster, and which way one moves."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    equality,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    is_zero,
)
from restitution.planning.formulas.scalar_products import by_scalar_product
from restitution.planning.formulas.separations import separation_known
from restitution.planning.formulas.velocity_formulas import frame_after
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.sums_of_products import never_negative
from restitution.planning.writing.desk import NotPlannedError, Source, chain
from restitution.planning.writing.forms import ZERO, swept, tree_of
from restitution.planning.writing.inequalities import completed_square
from restitution.planning.writing.polynomials import cancelled, factored
from restitution.solving.story.letters import roles
from restitution.vector import Vector


class Comparison:
    """Components compared by the letters for them, or by their values."""

    def __init__(self, claims: Claims) -> None:
        self.claims = claims
        self.worths = claims.worths
        self.scene = claims.scene
        self.judge = claims.judge

    def write(self, link: Link) -> tuple[int, Relation]:
        """An inequality between components along one line, as letters say it."""
        apart = self._by_separation(link)
        if apart is not None:
            return apart
        sides: list[Expression] = []
        values: list[sp.Expr] = []
        lines: list[Ref] = []
        for side in (link.left, link.right):
            tree, refs, value = self.component(side)
            sides.append(tree)
            values.append(value)
            lines += refs
        own = Link(sides[0], link.sign, sides[1])
        if isinstance(own.left, Negate) and is_zero(own.right):
            own = Link(own.left.operand, FLIPPED[own.sign], own.right)
        relation = Relation(((own,),))
        if self._is_plain(values):
            line = self.claims.compared(list(dict.fromkeys(lines)), relation)
            if line is not None:
                return line, relation
        numbers = [line for line in dict.fromkeys(lines) if isinstance(line, int)]
        if len(numbers) == 2:
            turn = 1 if link.sign[0] == ">" else -1
            value = tidy(factored(values[::turn][0] - values[::turn][1]))
            put = swept(Binary("-", *map(tree_of, values[::turn])))
            steps = [tree_of(value), *self._with_its_square(value)]
            difference = chain(
                Binary("-", *sides[::turn]), (put, None), *((step, "rearrange") for step in steps)
            )
            line = self._difference(difference, numbers)
            if line is not None:
                number_ = self.claims.compared([line], relation)
                if number_ is None and len(steps) > 1:
                    last = self._by_zero_between(sides, numbers, relation)
                    if last is not None:  # the sense of each is plainer
                        return last, relation
                    with self.judge.ranges_as_one():  # of both letters in it
                        number_ = self.claims.compared([line], relation)
                if number_ is None:
                    more = self.claims.conditions.lines()
                    number_ = self.claims.compared([line, *more], relation)
                if number_ is not None:
                    return number_, relation
            last = self._by_zero_between(sides, numbers, relation)
            if last is not None:
                return last, relation
        line = self.claims.compared(list(dict.fromkeys(lines)), relation)
        if line is not None:
            return line, relation
        if len(numbers) == 1:
            number_ = self._by_product(numbers[0], values, lines, relation)
            if number_ is not None:
                return number_, relation
        raise NotPlannedError("who is the faster")

    def _by_separation(self, link: Link) -> tuple[int, Relation] | None:
        """Who is the faster after an impact of the two, by how fast they separate.

        The law of restitution alone tells that; None where something else is compared, or where
        what they were is known already.
        """
        scene = self.scene
        match link:
            case Link(
                Quantity("along", (Quantity("velocity", (Name(one),), int(stage)), axis)),
                "<" | "<=" | ">" | ">=",
                Quantity("along", (Quantity("velocity", (Name(other),), int(late)), other_axis)),
            ) if axis == other_axis:
                event = scene.last_event(one, stage)
            case _:
                return None
        components = [scene.model.components.get((event, body)) for body in (one, other)]
        if scene.last_event(other, late) != event or None in components:
            return None
        symbols = [component.symbol for component in components if component is not None]
        if not all(scene.unknown(symbol) for symbol in symbols):
            return None
        frame = scene.frame(event)
        wanted = scene.model.story.direction(axis, scene.events)
        if tidy(wanted.cross(frame.n)) != 0:
            return None
        mark = self.worths.mark()
        self.claims.solver.determine([symbols[0] - symbols[1]])
        apart = separation_known(scene, frame)
        if apart is not None:
            ahead = scene.model.sign(wanted.dot(frame.n)) * frame.letter_sign
            sign = link.sign if ahead > 0 else FLIPPED[link.sign]
            first, second = (Letter(symbol.name) for symbol in symbols)
            relation = Relation(((Link(first, sign, second),),))
            conditions = self.claims.conditions
            for more in (lambda: (), conditions.lines, conditions.story):
                line = self.claims.compared((*apart.refs, *more()), relation)
                if line is not None:
                    return line, relation
        self.worths.back(mark)
        return None

    def _by_zero_between(
        self, sides: Sequence[Expression], numbers: Sequence[int], relation: Relation
    ) -> int | None:
        """Components of which one goes forwards and one back, or stays: each has its own line."""
        (own,) = relation.only
        greater = 0 if own.sign[0] == ">" else 1
        mark = self.worths.mark()
        pairs: tuple[tuple[Sign, Sign], ...] = ((">", "<="), (">=", "<"))
        for first, second in pairs:
            signs = (first, second) if greater == 0 else (second, first)
            bounds = [
                self.claims.compared([line], Relation(((Link(side, sign, ZERO),),)))
                for side, sign, line in zip(sides, signs, numbers, strict=True)
            ]
            if None not in bounds:
                written = self.claims.compared([e for e in bounds if e is not None], relation)
                if written is not None:
                    return written
            self.worths.back(mark)
        return None

    @staticmethod
    def _is_plain(values: Sequence[sp.Expr]) -> bool:
        """Whether which is the greater is seen at once: one is zero, or they are like terms."""
        if any(value == 0 for value in values):
            return True
        return bool(cancelled(values[0] / values[1]).is_number)

    def _by_product(
        self, line: int, values: Sequence[sp.Expr], lines: Sequence[Ref], relation: Relation
    ) -> int | None:
        """The sense of a component with several coefficients: their product is positive."""
        own_roles = roles(self.scene.problem)
        names = {s.name for value in values for s in value.free_symbols if s.name in own_roles}
        several = self.claims.coefficients(names)
        mark = self.worths.mark()
        products = self.claims.products(several)
        if not products:
            return None
        rest = self.judge.known(names - set(several))
        sides = relation.only[0]
        subject, value = (sides.left, values[0]) if values[1] == 0 else (sides.right, values[1])
        equation = equality(subject, tree_of(value))
        named = self.judge.write((Move("put"), Move("rearrange")), lines, equation) or line
        pool = [named, *lines, *products, *rest]
        written = self.judge.write((Move("compare"),), pool, relation)
        if written is None:
            self.worths.back(mark)
        return written

    def _difference(self, relation: Relation, lines: Sequence[int]) -> int | None:
        for pair in (lines, lines[::-1]):
            line = self.judge.write((Move("combine"),), pair, relation)
            if line is not None:
                return line
        return None

    def component(self, side: Expression) -> tuple[Expression, tuple[Ref, ...], sp.Expr]:
        """A component by the letter for it, and the line that says what it is."""
        scene = self.scene
        match side:
            case Quantity("along", (Quantity("velocity", (Name(body),), int(stage)), axis)):
                self.worths.determine(side)
                last = scene.last_event(body, stage)
                frame = frame_after(scene, body, last)
                quantity = frame.component("along", body, last)
                known = scene.desk.known(quantity)
                source = self.worths.component("along", body, last, frame)
                wanted = scene.model.story.direction(axis, scene.events)
                sense = scene.model.sign(wanted.dot(frame.n))
                if tidy(wanted.cross(frame.n)) != 0:
                    return self._by_the_vector(side, body, last, axis, wanted)
                value = sense * source.value
                own = sp.sympify(0 if known is None else known.value, strict=True)
                symbol = own if own.is_Symbol else -own
                if symbol not in {
                    component.symbol for component in scene.model.components.values()
                }:
                    tree = quantity if sense == 1 else side
                    refs = (*source.whole, *frame.refs, *self.claims.conditions.axis_named(axis))
                    return tree, tuple(dict.fromkeys(refs)), value
                return tree_of(sense * own), self._explicit(symbol, source), value
        return side, (), sp.sympify(scene.scalar(side), strict=True)

    def _by_the_vector(
        self, side: Expression, body: str, stage: int, axis: Expression, wanted: Vector
    ) -> tuple[Expression, tuple[Ref, ...], sp.Expr]:
        """A component in the direction of another impact, by the velocity as a vector."""
        scene = self.scene
        match axis:
            case Quantity("line_of_centres", (), int(event)):
                pass
            case _:
                raise NotPlannedError("components along different lines")
        velocity = Quantity("velocity", (Name(body),), stage)
        if scene.desk.known(velocity) is None:
            self.worths.quantity(velocity)
        vector = scene.desk.known(velocity)
        assert isinstance(side, Quantity)
        assert vector is not None
        own = by_scalar_product(scene, side, vector, scene.frame(event), wanted)
        return side, own.refs, own.value

    def _explicit(self, symbol: sp.Symbol, source: Source) -> tuple[Ref, ...]:
        """The line that says what a letter of a component is, in letters of the statement."""
        desk = self.scene.desk
        own = desk.known(Letter(symbol.name))
        if own is None:
            return source.refs
        value, refs = self.scene.put(own.value)
        if value == own.value:
            return own.refs
        relation = equality(Letter(symbol.name), tree_of(value))
        line = self.judge.write((Move("put"),), (*own.refs, *refs), relation)
        return source.refs if line is None else (line,)

    def _with_its_square(self, value: sp.Expr) -> Iterator[Expression]:
        """A product whose only sum is 1 − e + e², with (e − ½)² + ¾ for it; or nothing.

        Of 3 + 10e − 9e² it has 3 + e + 9e(1 − e).
        """
        sums = [factor for factor in sp.Mul.make_args(sp.fraction(value)[0]) if factor.is_Add]
        if len(sums) != 1:
            return
        completed = completed_square(self.scene, sums[0])
        if completed is None or isinstance(completed, Negate):
            completed = never_negative(self.scene, sums[0])
        if completed is None:
            return
        stand_in = sp.Dummy("sum", positive=True)
        tree = tree_of(value.xreplace({sums[0]: stand_in}))
        yield exchanged(tree, {Letter(stand_in.name): completed})
