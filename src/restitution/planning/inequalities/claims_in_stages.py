"""Inequalities in stages: a part is bounded first, or a tangent, squares, or values."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import FLIPPED, Link, Move, Ref, Relation, Sign, turned
from restitution.expression.tree import Apply, Expression, Letter, Quantity, has_quantity
from restitution.planning.angles.turn_lines import meeting
from restitution.planning.inequalities.claim_lines import ClaimLines
from restitution.planning.inequalities.completed_squares import write_completed
from restitution.planning.inequalities.gaps import is_left, is_plain, write_difference
from restitution.planning.inequalities.quotients import write_quotient
from restitution.planning.inequalities.turned_at_walls import tangent_of
from restitution.planning.inequalities.worths import NAMED
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.polynomials import factored
from restitution.solving.story.letters import roles


class InStages(ClaimLines):
    """Claims whose lines come in stages."""

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
        named = [ref for ref in extent if isinstance(ref, int)]
        return self.compared([*ends, *named], relation)

    def _bounded(self, line: int, link: Link) -> int | None:
        """A bound of what only grows, or only falls; that it is positive is seen at once."""
        own = Relation(((link,),))
        if ZERO in (link.left, link.right):
            signed = self.compared([line], own) or self.compared([line, *meeting(self.scene)], own)
            return signed or self.monotone(line, own)
        written = self._by_bounds_above(link) or self.monotone(line, own)
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
            with self.judge.ranges_as_one():
                positive = self.compared([tangent], bounded)
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
        for other in relation.only:
            link = turned(other) if has_quantity(other.right) else other
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
            if line is None and isinstance(self.scene.desk.last_link(lines[0]).left, Apply):
                line = self._by_quotient(lines[0], own)  # of a tangent the plainest way
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
        known = self.judge.known(symbol_names(value))
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
        if link.sign not in FLIPPED:
            return None  # one value alone
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
            left, whole = (self.scene.desk.last_link(number) for number in (one, other))
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

    def _by_bounds_above(self, link: Link) -> int | None:
        """A bound by one that stands, as it is or with the end of a letter put in."""
        own = Relation(((link,),))
        for standing in self._bounds_of_tangent(link.left):
            if self.scene.desk.relation(standing).only[0].sign[0] == link.sign[0]:
                line = self.compared([standing], own) or self._at_an_end(standing, own)
                if line is not None:
                    return line
        return None

    def _bounds_of_tangent(self, subject: Expression) -> Iterator[int]:
        """The lines above that bound an expression, or the tangent of what a letter stands for."""
        yield from self._bounds_above(subject)
        match subject:
            case Apply("tan", Letter() as letter) if isinstance(
                angle := self.scene.desk.meant(letter), Quantity
            ):
                _, let = self.worths.letter_for(angle)
                for standing in self._bounds_above(Apply("tan", angle)):
                    own = replace(self.scene.desk.relation(standing).only[0], left=subject)
                    lettered = self.judge.write(
                        NAMED, [standing, let], Relation(((own,),)), shown="silent"
                    )
                    if lettered is not None:
                        yield lettered

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
