"""Inequalities: conditions in components, solved, and joined with what holds anyway."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Self

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.following.trials import names_in
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Link,
    Meaning,
    Move,
    MoveId,
    Ref,
    Relation,
    Sign,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.explaining.moves import MOST_COMPARED
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    has_quantity,
    is_zero,
    letters,
)
from restitution.planning.angles.turn_lines import meeting
from restitution.planning.inequalities.angle_inequalities import write_of_angles
from restitution.planning.inequalities.completed_squares import write_completed
from restitution.planning.inequalities.conditions import Conditions
from restitution.planning.inequalities.degrees_by_ratios import bound_by_a_ratio, bound_that_stands
from restitution.planning.inequalities.directions_bounded import (
    write_of_direction,
    write_of_wide_angle,
)
from restitution.planning.inequalities.gaps import has_root, is_left, is_plain, write_difference
from restitution.planning.inequalities.letter_ties import Ties, is_letter_or_square
from restitution.planning.inequalities.quotients import write_quotient
from restitution.planning.inequalities.turned_at_walls import tangent_of, write_turn
from restitution.planning.inequalities.wide_angles import write_by_cosine
from restitution.planning.inequalities.worths import Worths
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import ONE, ZERO, tree_of
from restitution.planning.writing.inequalities import (
    is_monic,
    same,
    solve_linear,
    subject_of,
    turned,
)
from restitution.planning.writing.polynomials import factored, one_fraction
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles


class Claims:
    """What a part says of its letters: equations that tie them, and conditions on them."""

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

    def write(self, relation: Relation) -> int:
        """Writes the lines of an inequality that holds; the last says it."""
        standing = self._of_letter(relation) or bound_that_stands(self, relation)
        if standing is not None:
            return standing
        trees = [side for link in relation.only for side in (link.left, link.right)]
        quantities = list(
            dict.fromkeys(
                q for tree in trees for q in self.worths.quantities(self.worths.opened(tree))
            )
        )
        lets = [
            fact.id
            for tree in trees
            for name in sorted(letters(tree))
            for fact in (self.scene.facts.get(f"let {name}"),)
            if fact is not None
        ]
        lines = self._worths(trees, quantities)
        facts = [
            ref
            for each in quantities
            if self.worths.is_data(each)
            for ref in self.worths.data_of(each)
        ]
        target = {name for tree in trees for name in letters(tree)}
        base = [*lines, *facts, *lets]
        if base:
            for each in lines:
                line = self._by_difference_of_squares(each, relation)
                line = self.monotone(each, relation) if line is None else line
                if line is not None:
                    return line
            if len(lines) != 1 or is_plain(self.scene, lines[0], relation):
                line = self.compared(base, relation)
                if line is not None:
                    return line
            for proof in _PROOFS:
                line = proof(self, quantities, relation)
                if line is not None:
                    return line
            line = self._by_tangents(base, lines, relation)
            if line is not None:
                return line
            line = self._by_stages(lines, relation)
            if line is not None:
                return line
            line = self.compared(base, relation)
            if line is not None:
                return line
            line = self._by_squares(quantities, relation)
            if line is not None:
                return line
            line = self._by_values(lines, relation)
            if line is not None:
                return line
            line = self.compared([*self.scene.desk.meanings(lines), *base], relation)
            if line is not None:
                return line
        mark = self.worths.mark()
        for attempt in self._attempts(target, relation):
            line = attempt(base, relation)
            if line is not None:
                return line
            self.worths.back(mark)
            self.ties.clear()
            self.conditions.clear()
        raise NotPlannedError("an inequality")

    def _by_difference_of_squares(self, line: int, relation: Relation) -> int | None:
        """A strict bound of a root, where the difference of squares is a product of plain signs.

        What only grows with a letter approaches such a bound, and a limit is no reason for it.
        """
        if len(relation.only) > 1 or relation.only[0].sign not in ("<", ">"):
            return None
        if not has_root(self.worths.value(self.scene.desk.last_link(line).right)):
            return None
        return write_difference(self, line, relation)

    def _of_letter(self, relation: Relation) -> int | None:
        """An inequality that stands already of the letter for its quantity, said of that."""
        standing = self.standing_of_letter(relation)
        if standing is None:
            return None
        return self.judge.write((Move("compare"),), standing, relation)

    def standing_of_letter(self, relation: Relation) -> tuple[int, int] | None:
        """The line that says an inequality of the letter for its quantity, and that of the letter.

        None where there is none.
        """
        for each in self.scene.desk.lines:
            own = each.relation
            if not isinstance(own, Meaning):
                continue
            renamed = Relation(
                tuple(tuple(_renamed(e, own) for e in links) for links in relation.options)
            )
            line = None if renamed == relation else self.judge.standing(renamed)
            if line is not None:
                return line, each.number
        return None

    def write_parts(self, asked: Expression, relation: Relation) -> int:
        """Writes the lines of a range in several parts: the conditions, and the range."""
        conditions: list[Ref] = [*self.conditions.lines(asked)]
        known = self.judge.known(letters(asked))
        line = self.judge.write((Move("compare"),), [*conditions, *known], relation)
        if line is None:
            raise NotPlannedError("a range in several parts")
        return line

    def join_the_rest(self, number: int, relation: Relation) -> int:
        """Joins to a range the conditions that are given and that others imply."""
        desk = self.scene.desk
        line = desk.line(number)
        if (
            number == len(desk.lines)
            and line.move.id == "sign"
            and self.is_own_range(line.premises)
        ):
            desk.lines.pop()
            kept = self._kept_bounds(relation)
            move = Move("compare") if kept else line.move
            return desk.write(move, (*kept, *line.premises), relation)
        under = desk.under(number)
        rest = [
            inequality
            for inequality in self.conditions.inequalities()
            if inequality.id not in under and inequality.kind in ("given", "range")
        ]
        if line.move.id != "compare" or number != len(desk.lines) or not rest:
            return number
        desk.lines.pop()
        premises = line.premises
        for fact in rest:
            try:
                condition = self.conditions.stated(fact, subject_of(relation))
            except NotPlannedError:
                condition = None
            if condition is not None and len(premises) < MOST_COMPARED:
                premises = (*premises, condition)
        return desk.write(line.move, premises, relation)

    def is_own_range(self, premises: Sequence[Ref]) -> bool:
        """Whether premises only say what a letter may be anyway."""
        return all(
            isinstance(premise, str) and premise not in self.scene.facts for premise in premises
        )

    def _kept_bounds(self, relation: Relation) -> list[int]:
        """That the coefficients that are tied to a letter are at most 1 for all its values."""
        own = {n for e in relation.only for side in (e.left, e.right) for n in letters(side)}
        known = roles(self.scene.problem)
        lines: list[int] = []
        for tie in self.ties.lines():
            if len(self.scene.desk.relation(tie).options) > 1:
                continue
            link = self.scene.desk.last_link(tie)
            for name in sorted((letters(link.left) | letters(link.right)) - own):
                if name not in known or known[name].kind != "restitution":
                    continue
                most = Relation(((Link(Letter(name), "<=", ONE),),))
                line = self.judge.write((Move("sign"),), [tie, *self.judge.known(own)], most)
                lines += [] if line is None else [line]
        return lines

    def _worths(self, trees: Sequence[Expression], quantities: Sequence[Quantity]) -> list[int]:
        """The lines of what stands in a claim: of its sides, or of the quantities in them."""
        lines: list[int] = []
        left = [quantity for quantity in quantities if not self.worths.is_data(quantity)]
        for tree in trees:
            opened = self.worths.opened(tree)
            inside = list(self.worths.quantities(opened))
            if not inside or not all(each in left for each in inside):
                continue
            mark = self.worths.mark()
            line = (
                self.worths.angle(opened)
                if isinstance(opened, Quantity) and opened.kind in ("angle", "deflection")
                else self.worths.worth(opened)
            )
            if line is None:
                self.worths.back(mark)
                continue
            lines.append(line)
            left = [each for each in left if each not in inside]
        return [*dict.fromkeys(lines), *(self.worths.quantity(each) for each in left)]

    def _by_tangents(
        self, base: Sequence[Ref], lines: Sequence[int], relation: Relation
    ) -> int | None:
        """Angles compared by their tangents, which grow with them."""
        if len(lines) != 1:
            return None
        match self.scene.desk.last_link(lines[0]).left:
            case Apply("tan", angle):
                pass
            case _:
                return None
        mark = self.worths.mark()
        number, angle, extent = self.worths.lettered(lines[0], angle)
        quantity, tangent = self.scene.desk.meant(angle), Apply("tan", angle)
        links: list[Link] = []
        for link in relation.only:
            sides = [
                tangent if side in (angle, quantity) else self._tangent_of(side)
                for side in (link.left, link.right)
            ]
            if None not in sides:
                links.append(Link(sides[0], link.sign, sides[1]))  # type: ignore[arg-type]
        if not links or len(links) < len(relation.only) - 1:
            self.worths.back(mark)
            return None
        written = self._by_ends(links, number, extent, relation, base)
        if written is None:
            self.worths.back(mark)
        return written

    def _by_ends(
        self,
        links: Sequence[Link],
        tangent: int,
        extent: Sequence[Ref],
        relation: Relation,
        base: Sequence[Ref],
    ) -> int | None:
        """Bounds of an angle by those of its tangent, one after the other."""
        if len(links) == 1:
            (link,) = links
            line = self._bounded(tangent, turned(link) if link.left == ZERO else link)
            return None if line is None else self.angle_of(line, tangent, extent, relation, base)
        line = self.monotone(tangent, Relation((tuple(links),)))
        if line is not None:
            written = self.compared([line, *self._texts(base), *extent], relation)
            if written is not None:
                return written
        ends: list[Ref] = []
        for link, asked in zip(links, relation.only, strict=False):
            line = self.compared([tangent], Relation(((link,),)))
            if line is None:
                return None
            end = self.angle_of(line, tangent, extent, Relation(((asked,),)), base)
            if end is None:
                return None
            ends.append(end)
        named = [each for each in extent if isinstance(each, int)]
        return self.compared([*ends, *named], relation)

    def _bounded(self, line: int, link: Link) -> int | None:
        """A bound of what only grows, or only falls; that it is positive is seen at once."""
        own = Relation(((link,),))
        if ZERO in (link.left, link.right):
            return self.compared([line], own) or self.monotone(line, own)
        written = self.monotone(line, own)
        if written is None and not is_plain(self.scene, line, own):
            written = self._quotient_at_an_end(line, own) or self._by_quotient(line, own)
        return written or self.compared([line], own)

    def angle_of(
        self,
        line: int,
        tangent: int,
        extent: Sequence[Ref],
        relation: Relation,
        base: Sequence[Ref] = (),
        support: Sequence[Ref] = (),
    ) -> int | None:
        """An angle compared by bounds of its tangent, of which another line tells the sign."""
        rest = self._texts(base)
        ranges = list(extent)
        written = self.compared([line, *rest, *ranges], relation)
        if written is not None:
            return written
        own = self.scene.desk.last_link(tangent)
        bounded = Relation(((Link(own.left, ">", ZERO),),))
        positive = self.compared([tangent, *meeting(self.scene)], bounded)
        if positive is None and support:
            positive = self.compared(support, bounded)
        if positive is None:
            least = next(self._at_ends(tangent, ">="), None)
            positive = None if least is None else self.compared([least], bounded)
        if positive is None:
            return None
        return self.compared([line, positive, *rest, *ranges], relation)

    @staticmethod
    def _texts(refs: Sequence[Ref]) -> list[Ref]:
        """The facts among premises."""
        return [ref for ref in refs if isinstance(ref, str)]

    def _tangent_of(self, tree: Expression) -> Expression | None:
        value = sp.sympify(self.scene.scalar(tree), strict=True)
        if value.free_symbols:
            tangent = tangent_of(value)
            return Apply("tan", tree) if tangent is None else tree_of(tangent)
        there = tidy(sp.tan(value))
        return None if there.has(sp.zoo) else tree_of(there)

    def _by_stages(self, lines: Sequence[int], relation: Relation) -> int | None:
        """One end at a time, and one letter at a time: at its end first, then the others."""
        if len(lines) != 1:
            return None
        completed = write_completed(self, lines[0], relation)
        if completed is not None:
            return completed
        mark = self.worths.mark()
        written: list[int] = []
        for each in relation.only:
            link = turned(each) if has_quantity(each.right) else each
            own = Relation(((link,),))
            line = self._in_a_range(link)
            if line is not None:
                pass  # one end of what stands already
            elif self._is_left(lines[0], link):
                line = self._without_square(lines[0], own)
            elif ZERO in (link.left, link.right) or is_plain(self.scene, lines[0], own):
                line = self._bounded(lines[0], link)
            else:
                line = self.monotone(lines[0], own)
            if line is None:
                line = write_difference(self, lines[0], own)
            if line is None:
                line = self._staged(lines[0], own)
            if line is None:
                line = self._by_quotient(lines[0], own)
            if line is None:
                self.worths.back(mark)
                return None
            written.append(line)
        if len(written) == 1:
            return written[0]
        line = self.compared(written, relation)
        if line is None:
            self.worths.back(mark)
        return line

    def _in_a_range(self, link: Link) -> int | None:
        """The line of a range that has an inequality as one of its ends."""
        for line in self.scene.desk.lines:
            own = line.relation
            if isinstance(own, Relation) and len(own.options) == 1 and len(own.only) > 1:
                ends = {*own.only, *(turned(e) for e in own.only if e.sign in FLIPPED)}
                if link in ends and self.scene.desk.holds(line.number):
                    return line.number
        return None

    def _is_left(self, line: int, link: Link) -> bool:
        """Whether a lower bound is what a line says without one of its squares."""
        if link.sign != ">=":
            return False
        tree = self.scene.desk.relation(line).only[0].right
        return is_left(self.worths, tree, self.worths.value(link.right))

    def _without_square(self, line: int, relation: Relation) -> int | None:
        """A lower bound as a square is not negative; of a speed by its square, without a root."""
        speed = self.scene.desk.last_link(line).left
        if len(self.scene.desk.relation(line).only) > 1:
            # What it comes to shows no square: the sum above it does.
            written = self.compared([line], relation)
            if written is not None:
                return written
        start = self.worths.squared(speed) if isinstance(speed, Quantity) else None
        return self.compared([line if start is None else start], relation)

    def _by_quotient(self, line: int, relation: Relation) -> int | None:
        """A bound that is the greatest value of a quotient."""
        whole = self.scene.desk.last_link(line)
        if relation.only[0].sign not in FLIPPED:
            return None
        link = relation.only[0] if relation.only[0].left == whole.left else turned(relation.only[0])
        value = self.worths.value(whole.right)
        if link.left != whole.left or link.sign[0] != "<":
            return None
        for symbol in sorted(value.free_symbols, key=lambda s: s.name):
            role = roles(self.scene.problem).get(symbol.name)
            if role is None or role.kind not in ("angle", "positive"):
                continue
            mark = self.worths.mark()
            bound = write_quotient(self, line, symbol, link)
            if bound is not None:
                return self.compared([bound.line], relation)
            self.worths.back(mark)
        return None

    def _quotient_at_an_end(self, line: int, relation: Relation) -> int | None:
        """A bound by the greatest value of what a quotient is where a coefficient is 1, or 0."""
        mark = self.worths.mark()
        for first in self._at_ends(line, "<="):
            written = self._by_quotient(first, relation)
            if written is not None:
                return written
            self.worths.back(mark)
        return None

    def _at_ends(self, line: int, sign: Sign) -> Iterator[int]:
        """Bounds of what a line gives by what it is where a coefficient is 1, or 0."""
        whole = self.scene.desk.last_link(line)
        value = self.worths.value(whole.right)
        known = self.judge.known(s.name for s in value.free_symbols)
        for symbol in sorted(value.free_symbols, key=lambda s: s.name):
            role = roles(self.scene.problem).get(symbol.name)
            if role is None or role.kind != "restitution" or len(value.free_symbols) == 1:
                continue
            for end in (role.high, role.low):
                there = tidy(factored(value.subs(symbol, end)))
                bound = Relation(((Link(whole.left, sign, tree_of(there)),),))
                written = self.judge.write((Move("monotone"),), [line, *known], bound)
                if written is not None:
                    yield written

    def _staged(self, line: int, relation: Relation) -> int | None:
        """A bound by a bound of what a line gives, with the end of one letter put in."""
        whole = self.scene.desk.last_link(line)
        value = self.worths.value(whole.right)
        (link,) = relation.only
        turned = not has_quantity(link.left)
        sign = FLIPPED[link.sign] if turned else link.sign
        for symbol in sorted(value.free_symbols, key=lambda s: s.name):
            role = roles(self.scene.problem).get(symbol.name)
            if role is None or role.kind == "positive":
                continue
            for end in (role.low, role.high):
                if end is None:
                    continue
                there = value.subs(symbol, end)
                if there.has(sp.zoo, sp.oo, sp.nan, sp.AccumBounds):
                    continue
                weak: Sign = ">=" if sign[0] == ">" else "<="
                own = Relation(((Link(whole.left, weak, tree_of(tidy(there))),),))
                mark = self.worths.mark()
                pool = [line, *self.judge.known([symbol.name])]
                first = self.judge.write((Move("monotone"), Move("sign")), pool, own)
                if first is None:
                    continue
                written = self.compared([first], relation)
                if written is not None:
                    return written
                self.worths.back(mark)
        return None

    def _by_squares(self, quantities: Sequence[Quantity], relation: Relation) -> int | None:
        """A speed compared by its square."""
        if not all(quantity.kind == "speed" for quantity in quantities):
            return None
        mark = self.worths.mark()
        lines = [self.worths.squared(quantity) for quantity in quantities]
        if None not in lines:
            line = self.compared(lines, relation)  # type: ignore[arg-type]
            if line is None:
                line = self._by_stages(lines, relation)  # type: ignore[arg-type]
            if line is not None:
                return line
        self.worths.back(mark)
        return None

    def _by_values(self, lines: Sequence[int], relation: Relation) -> int | None:
        """One side compared with what the other is worth, by a bound that stands or by its own."""
        if len(relation.only) != 1 or len(lines) != 2:
            return None
        (link,) = relation.only
        for one, other in (lines, lines[::-1]):
            left, whole = (self.scene.desk.last_link(each) for each in (one, other))
            own = link if link.left == left.left else turned(link)
            if (own.left, own.right) != (left.left, whole.left):
                continue
            mark = self.worths.mark()
            bound = Relation(((Link(own.left, own.sign, whole.right),),))
            for standing in self._bounds_above(own.left):
                line = self.compared([standing], bound) or self._at_an_end(standing, bound)
                if line is not None:
                    return self.compared([line, other], relation)
            line = write_difference(self, one, bound)
            if line is not None:
                line = self.compared([line, other], relation)
                if line is not None:
                    return line
            self.worths.back(mark)
        return None

    def _attempts(
        self, target: set[str], relation: Relation
    ) -> Iterator[Callable[[list[Ref], Relation], int | None]]:
        wanted = subject_of(relation)

        def by_conditions(base: list[Ref], relation: Relation) -> int | None:
            lines = [each for each in base if isinstance(each, int)]
            for bounds in (self._ranges(lines), self.conditions.lines(wanted)):
                line = self.monotone(lines[0], relation, bounds) if len(lines) == 1 else None
                if line is not None and bounds:
                    return line
            return self.compared([*base, *self.conditions.lines(wanted)], relation, base)

        def by_ties(base: list[Ref], relation: Relation) -> int | None:
            for line in self.ties.lines():
                written = self.monotone(line, relation)
                if written is not None:
                    return written
            for line in self.ties.lines():
                written = self._eliminated(line, base, relation, target)
                if written is not None:
                    return written
            for line in self.ties.lines():
                written = self._by_each_end(line, relation)
                if written is not None:
                    return written
            return None

        def by_ratios(base: list[Ref], relation: Relation) -> int | None:
            return self._by_ratios(target, relation)

        def by_all(base: list[Ref], relation: Relation) -> int | None:
            return self.compared(
                [*base, *self.ties.lines(), *self.conditions.lines(wanted)], relation
            )

        def by_story(base: list[Ref], relation: Relation) -> int | None:
            own = (*self.conditions.story(wanted), *self.conditions.lines(wanted))
            return self.compared([*base, *own], relation, base)

        yield by_conditions
        yield by_ratios
        yield by_ties
        yield by_all
        yield by_story

    def _ranges(self, lines: Sequence[int]) -> list[int]:
        """The ranges of the letters in some lines, where lines above say them."""
        desk = self.scene.desk
        inside = {n for each in lines for n in letters(desk.last_link(each).right)}
        return [line for each in sorted(inside) for line in self.ranges_of(each)]

    def ranges_of(self, letter: str) -> list[int]:
        """The lines above that say between what a letter is."""
        bounds = self._bounds_of(Letter(letter))
        return [each for each in bounds if len(self.scene.desk.relation(each).only) == 2]

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

    def _at_an_end(self, standing: int, relation: Relation) -> int | None:
        """A bound by one that stands, with the end of one letter put in that first."""
        own = self.scene.desk.relation(standing).only[0]
        value = self.worths.value(own.right)
        for symbol in sorted(value.free_symbols, key=lambda s: s.name):
            role = roles(self.scene.problem).get(symbol.name)
            if role is None or role.kind != "restitution" or role.high is None:
                continue
            mark = self.worths.mark()
            there = tree_of(tidy(value.subs(symbol, role.high)))
            first = self.compared([standing], Relation(((replace(own, right=there),),)))
            line = None if first is None else self.compared([first], relation)
            if line is not None:
                return line
            self.worths.back(mark)
        return None

    def _bounds_above(self, subject: Expression) -> list[int]:
        """The lines above that bound a quantity, or an expression of quantities."""
        desk = self.scene.desk
        return [
            line.number
            for line in desk.lines
            if isinstance(line.relation, Relation)
            and [len(links) for links in line.relation.options] == [1]
            and line.relation.only[0].left == subject
            and line.relation.only[0].sign in FLIPPED
            and desk.holds(line.number)
        ]

    def monotone(self, line: int, relation: Relation, bounds: Sequence[Ref] = ()) -> int | None:
        """The ends of what only grows, or only falls, with one letter.

        Its range is what it may be anyway, or what lines tell that bound it.
        """
        known = roles(self.scene.problem)
        names = sorted(letters(self.scene.desk.last_link(line).right) & set(known))
        # What has two ends is bounded by them; of a mass the other end is far away.
        for name in sorted(names, key=lambda each: known[each].kind == "positive"):
            others = letters(self.scene.desk.last_link(line).right) - {name}
            pool = [line, *bounds, *self.judge.known([name]), *self.judge.known(others)]
            number_ = self.judge.write((Move("monotone"),), pool, relation)
            if number_ is not None:
                return number_
        return None

    def _eliminated(
        self, line: int, base: Sequence[Ref], relation: Relation, target: set[str]
    ) -> int | None:
        """By the range of a letter in an equation of which the claim does not speak."""
        scene = self.scene
        link = scene.desk.last_link(line)
        inside = {
            s for side in (link.left, link.right) for s in self.worths.value(side).free_symbols
        }
        known_roles = roles(scene.problem)
        gone = [s for s in inside if s.name in known_roles and s.name not in target]
        wanted = subject_of(relation)
        written: list[int] = []
        for symbol in sorted(gone, key=self.ties.rank):
            for sign, x, bound in self.ties.derived(line, symbol):
                mark = self.worths.mark()
                solved = solve_linear(self.scene, sign, x, wanted) or solve_linear(
                    self.scene, sign, x
                )
                short = self.ties.put_in(line, symbol, bound)
                if short is None:
                    short = Link(tree_of(x), sign, ZERO)
                    alone = is_letter_or_square(self.scene.desk.last_link(line).left)
                    if alone or x.atoms(sp.sin, sp.cos, sp.tan):
                        short = self.ties.bounded(line, symbol, bound) or short
                        solved = short if _is_subject(short.left) else solved
                    if solved is not None and (link.left == solved.left or is_monic(scene, x)):
                        short = solved
                ends = self.judge.known([symbol.name])
                first = [ref for ref in ends if any(e in str(ref) for e in _near(bound))]
                known = self.worths.known_in(x)
                pool = [line, *first, *ends, *known]
                moves: tuple[Move, ...] = (Move("sign"),)
                number_ = None
                if short.left == link.left and self._is_twice_in(link.right, symbol):
                    number_ = self.judge.write((Move("monotone"),), pool, Relation(((short,),)))
                    if number_ is None:
                        number_ = self._by_difference(line, short)
                if number_ is None:
                    number_ = self.judge.write(moves, pool, Relation(((short,),)))
                if number_ is None:
                    self.worths.back(mark)
                    continue
                if solved is not None and short != solved:
                    moves = (Move("rearrange"), Move("cancel"), Move("compare"))
                    after = self.judge.write(moves, [number_, *known], Relation(((solved,),)))
                    number_ = number_ if after is None else after
                if same(scene.desk.relation(number_), relation):
                    return number_
                if not base:
                    line_ = self.compared([number_], relation)
                    if line_ is not None:
                        return line_
                written.append(number_)
        if not written:
            return None
        for each in base:
            line_ = self.monotone(each, relation, written) if isinstance(each, int) else None
            if line_ is not None:
                return line_
        line_ = self.compared([*base, *written], relation)
        if line_ is None and self.conditions.lines(wanted):
            line_ = self.compared([*base, *written, *self.conditions.lines(wanted)], relation)
        return line_

    def _by_difference(self, line: int, link: Link) -> int | None:
        """A bound of a quotient of polynomials in which a letter stands above and below."""
        right = self.scene.desk.last_link(line).right
        value = self.worths.value(right)
        symbols = value.free_symbols
        if is_zero(link.right) or not value.is_rational_function(*symbols):
            return None
        if not any(self._is_twice_in(right, symbol) for symbol in symbols):
            return None
        return write_difference(self, line, Relation(((link,),)))

    def _is_twice_in(self, tree: Expression, symbol: sp.Symbol) -> bool:
        """Whether a letter stands above and below in a quotient: no bound is seen at once."""
        above, below = sp.fraction(one_fraction(self.worths.value(tree)))
        return symbol in above.free_symbols and symbol in below.free_symbols

    def _by_ratios(self, target: set[str], relation: Relation) -> int | None:
        """An angle of which the data give a ratio in numbers, by the tangent of it."""
        known = roles(self.scene.problem)
        angles = [n for n in sorted(target) if n in known and known[n].kind == "angle"]
        if len(angles) != 1:
            return None
        tangent = Apply("tan", Letter(angles[0]))
        symbol = self.scene.model.unknowns.letter(angles[0])
        standing = self.scene.desk.known(tangent)
        if standing is not None and not standing.value.free_symbols:
            return self.compared(standing.refs, relation)
        value, refs = self.scene.put(sp.tan(symbol))
        if value.free_symbols or not refs:
            return None
        line = next((ref for ref in refs if isinstance(ref, int)), None)
        equation = Relation(((Link(tangent, "=", tree_of(value)),),))
        number = self.judge.standing(equation)
        if number is None and line is not None:
            number = self.judge.write((Move("triangle"), Move("put")), refs, equation)
        return self.compared([*(refs if number is None else [number])], relation)

    def _by_each_end(self, line: int, relation: Relation) -> int | None:
        """One end after the other, by an equation and the range of a letter in it."""
        mark = self.worths.mark()
        written: list[int] = []
        for link in relation.only:
            own = turned(link) if isinstance(link.right, Letter) else link
            if self.judge.proves(self.judge.known(letters(own.left)), Relation(((own,),))):
                continue
            sides = self.scene.desk.last_link(line)
            names = letters(sides.left) | letters(sides.right)
            pool = [line, *self.judge.known(names & set(roles(self.scene.problem)))]
            end = self._by_difference(line, own) if own.left == sides.left else None
            if end is None:
                end = self.judge.write((Move("sign"),), pool, Relation(((own,),)))
            if end is None:
                self.worths.back(mark)
                return None
            written.append(end)
        last = self.compared(written, relation) if written else None
        if last is None:
            self.worths.back(mark)
        return last

    def compared(
        self, refs: Sequence[Ref], relation: Relation, known_only: Sequence[Ref] = ()
    ) -> int | None:
        """A line by what is cited, and the ranges of letters."""
        for each in refs:
            if isinstance(each, int) and each not in known_only:
                stated = self.scene.desk.line(each).relation
                if isinstance(stated, Relation) and same(stated, relation):
                    return each
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
        pool = [*refs, *self.judge.known(n for n in names if n in roles(self.scene.problem))]
        line = bound_by_a_ratio(self, relation, pool)
        if line is not None:
            return line
        rooted = self._rooted(refs, relation, pool)
        if rooted is not None:
            pool = [rooted, *pool]
        conditions = [
            each
            for each in refs
            if isinstance(each, int)
            and isinstance(own := self.scene.desk.line(each).relation, Relation)
            and own.options[0][0].sign != "="
        ]
        for condition in conditions:
            line = self.judge.write((Move("rearrange"),), [condition], relation)
            if line is not None:
                return line
        kind: MoveId = "compare" if conditions else "sign"
        line = self.judge.write((Move(kind),), pool, relation)
        if line is not None:
            return line
        mark = self.worths.mark()
        several = self.coefficients(names)
        products = self.products(several)
        if products:
            rest = self.judge.known(
                n for n in names - set(several) if n in roles(self.scene.problem)
            )
            line = self.judge.write((Move("compare"),), [*refs, *products, *rest], relation)
        if line is None:
            self.worths.back(mark)
        return line

    def coefficients(self, names: Iterable[str]) -> list[str]:
        """The coefficients of restitution among some letters."""
        known = roles(self.scene.problem)
        return sorted(n for n in names if n in known and known[n].kind == "restitution")

    def products(self, several: Sequence[str]) -> list[int]:
        """The bounds of a product of coefficients, where there are several."""
        if len(several) < 2:
            return []
        known = roles(self.scene.problem)
        product = tree_of(sp.Mul(*(known[each].symbol(each) for each in several)))
        bounds = (Link(product, ">", ZERO), Link(product, "<=", ONE))
        lines = [
            self.judge.write((Move("sign"),), self.judge.known(several), Relation(((bound,),)))
            for bound in bounds
        ]
        return [line for line in lines if line is not None]

    def _rooted(self, refs: Sequence[Ref], relation: Relation, pool: Sequence[Ref]) -> int | None:
        """Of a bound of the square of a ratio, that of the ratio, where its angle is asked."""
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


def _renamed(link: Link, meaning: Meaning) -> Link:
    """A link with a letter for the quantity for which it stands."""
    letter = Letter(meaning.letter)
    left, right = (
        rebuilt(side, lambda each: letter if each == meaning.quantity else each)
        for side in (link.left, link.right)
    )
    return Link(left, link.sign, right)


def _is_subject(tree: Expression) -> bool:
    """Whether a side is a letter, a ratio of an angle, or a power of one of them."""
    return not isinstance(tree, Binary) or tree.op == "^"


_PROOFS = (write_of_direction, write_of_angles, write_turn, write_of_wide_angle, write_by_cosine)


def _near(sign: Sign) -> tuple[str, ...]:
    """How premises about that end of a range are written."""
    return ("acute", "°", f" {sign[0]}")
