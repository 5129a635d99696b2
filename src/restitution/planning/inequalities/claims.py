"""Inequalities: conditions in components, solved, and joined with what holds anyway."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress

import sympy as sp

from restitution.exact import in_one_ratio, tidy
from restitution.explaining.lines.derivation import Link, Meaning, Move, Ref, Relation
from restitution.explaining.lines.trees import rebuilt
from restitution.explaining.moves import MOST_COMPARED
from restitution.expression.quantities import UNSIGNED_ANGLES
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Degrees,
    Expression,
    Letter,
    Quantity,
    has_quantity,
    is_quantity,
    is_zero,
    letters,
)
from restitution.oracle.roles import ACUTE
from restitution.planning.inequalities.angle_inequalities import (
    write_by_a_right_angle,
    write_of_angles,
)
from restitution.planning.inequalities.bounds_by_ties import write_by_its_square
from restitution.planning.inequalities.claims_eliminated import Eliminated
from restitution.planning.inequalities.degrees_by_ratios import bound_that_stands
from restitution.planning.inequalities.directions_bounded import (
    write_of_direction,
    write_of_wide_angle,
)
from restitution.planning.inequalities.gaps import (
    has_root,
    is_plain,
    write_difference,
    write_given_gap,
)
from restitution.planning.inequalities.ratios_by_angles import write_by_its_angle
from restitution.planning.inequalities.signs_of_components import write_by_components
from restitution.planning.inequalities.standing_bounds import write_by_a_standing_bound
from restitution.planning.inequalities.tangents_of_sums import write_tangent_of_a_sum
from restitution.planning.inequalities.turned_at_walls import write_turn
from restitution.planning.inequalities.two_values import write_difference_of_two
from restitution.planning.inequalities.wide_angles import write_by_a_product, write_by_cosine
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import ONE, tree_of
from restitution.planning.writing.inequalities import subject_of
from restitution.planning.writing.polynomials import expanded
from restitution.solving.story.letters import roles

_PROOFS = (
    write_by_a_product,
    write_by_components,
    write_of_direction,
    write_of_angles,
    write_turn,
    write_of_wide_angle,
    write_by_cosine,
)


class Claims(Eliminated):
    """What a part says of its letters: equations that tie them, and conditions on them."""

    def write(self, relation: Relation) -> int:
        """Writes the lines of an inequality that holds; the last says it."""
        standing = self._of_letter(relation) or bound_that_stands(self, relation)
        standing = standing or write_by_a_standing_bound(self, relation)
        standing = standing or write_by_its_square(self, relation)
        standing = standing or write_by_a_right_angle(self, relation)
        standing = standing or write_by_its_angle(self, relation)
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
            for quantity in quantities
            if self.worths.is_data(quantity)
            for ref in self.worths.data_of(quantity)
        ]
        target = {name for tree in trees for name in letters(tree)}
        base = [*lines, *facts, *lets]
        of_sum = write_tangent_of_a_sum(self.scene, relation, lines)
        if of_sum is not None:
            line = self._by_stages([of_sum], relation)
            if line is not None:
                return line
        if base:
            for number in lines:
                line = self._by_an_even_power(number, relation)
                line = line or self._by_difference_of_squares(number, relation)
                line = line or self._by_its_sign(number, relation)
                line = line or self._by_factors_at_sight(number, relation)
                line = line or write_given_gap(self, number, relation)
                line = self.monotone(number, relation) if line is None else line
                if line is not None:
                    return line
            by_difference = write_difference_of_two(self, lines, relation)
            if by_difference is not None:
                return by_difference
            if len(lines) != 1 or is_plain(self.scene, lines[0], relation):
                line = self.compared(base, relation)
                if line is not None:
                    return line
            if _is_acute(relation):
                line = self._by_tangents(base, lines, relation)
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
        last = self._by_its_tangent(relation) or (None if base else self._one_by_one(relation))
        last = last or write_of_wide_angle(self, quantities, relation, also_acute=True)
        if last is None:
            raise NotPlannedError("an inequality")
        return last

    def _one_by_one(self, relation: Relation) -> int | None:
        """The two bounds of what letters make, each by what it rests on, and then both."""
        if len(relation.options) != 1 or len(relation.only) != 2:
            return None
        mark = self.worths.mark()
        with suppress(NotPlannedError):
            bounds = [self.write(Relation(((link,),))) for link in relation.only]
            both = self.judge.write((Move("compare"),), bounds, relation)
            if both is not None:
                return both
        self.worths.back(mark)
        return None

    def _by_its_tangent(self, relation: Relation) -> int | None:
        """The bounds of an acute angle that is a letter of the data, by those of its tangent."""
        links = tuple(e for e in map(_of_tangent, relation.only) if e is not None)
        names = {name for link in links for name in letters(link.left) | letters(link.right)}
        known = roles(self.scene.problem)
        if not links or len(names) != 1 or not all(known.get(n) == ACUTE for n in names):
            return None
        (name,) = names
        mark = self.worths.mark()
        try:
            line = self.write(Relation((links,)))
        except NotPlannedError:
            line = 0
        last = line and self.judge.write((Move("compare"),), [line, f"acute: {name}"], relation)
        if not last:
            self.worths.back(mark)
            return None
        return last

    def _by_an_even_power(self, line: int, relation: Relation) -> int | None:
        """A bound from which a value differs by a letter to an even power: 1 − e² is at most 1."""
        match relation.options:
            case ((Link(left, "<=" | ">=", right),),):
                own = self.scene.desk.last_link(line)
            case _:
                return None
        if own.left != left or own.sign != "=" or has_quantity(right):
            return None
        gap = expanded(self.worths.value(own.right) - self.worths.value(right))
        factors = [factor.as_base_exp() for factor in sp.Mul.make_args(sp.factor(gap))]
        if not all(base.is_positive or base.is_Number or power.is_even for base, power in factors):
            return None
        if not any(base.is_Symbol and not base.is_positive for base, _ in factors):
            return None
        return self.judge.write((Move("sign"),), (line,), relation)

    def _by_difference_of_squares(self, line: int, relation: Relation) -> int | None:
        """A strict bound of a root, where the difference of squares is a product of plain signs.

        What only grows with a letter approaches such a bound, and a limit is no reason for it.
        """
        if len(relation.only) > 1 or relation.only[0].sign not in ("<", ">"):
            return None
        if not has_root(self.worths.value(self.scene.desk.last_link(line).right)):
            return None
        return write_difference(self, line, relation)

    def _by_factors_at_sight(self, line: int, relation: Relation) -> int | None:
        """A bound from which a value differs by a product of factors with signs that are seen.

        (1 + e)mu is at most 2mu as e is at most 1; of a root the squares differ so.
        """
        own = self.scene.desk.last_link(line)
        match relation.options:
            case ((Link(left, "<=" | ">=", right),),) if own.left in (left, right):
                bound_ = right if own.left == left else left
            case _:
                return None
        if own.sign != "=" or has_quantity(own.right) or has_quantity(bound_):
            return None
        value, bound = (self.worths.value(e) for e in (own.right, bound_))
        power = 2 if has_root(value) else 1
        gap = expanded(value**power - bound**power)
        # Under a root what sin² + cos² = 1 takes away would have to be seen before.
        for angle in {f.args[0] for f in gap.atoms(sp.cos)} if power == 1 else ():
            gap = in_one_ratio(gap, sp.sin(angle), sp.cos(angle))
        gap = sp.factor(gap)
        known = self.judge.known(letters(own.right) | letters(right))
        if gap == 0 or not all(map(self._is_seen, sp.Mul.make_args(gap))):
            return None
        return self.judge.write((Move("sign"),), (line, *known), relation)

    def _is_seen(self, factor: sp.Expr) -> bool:
        """Whether the sign of a factor is seen: a letter, a ratio of one, or 1 ± e."""
        base, _ = factor.as_base_exp()
        if base.is_number or base.is_Symbol or isinstance(base, (sp.sin, sp.cos, sp.tan)):
            return True
        names = [symbol.name for symbol in base.free_symbols]
        coefficient = len(names) == 1 and bool(self.coefficients(names))
        return coefficient and base.is_Add and base.is_polynomial() and sp.degree(base) == 1

    def _by_its_sign(self, line: int, relation: Relation) -> int | None:
        """The sign of a value that stands, which the ranges of its letters tell at sight."""
        link = self.scene.desk.last_link(line)
        match relation.options:
            case ((Link(left, _, right),),) if left == link.left and is_zero(right):
                known = self.judge.known(letters(link.right))
                return self.judge.write((Move("sign"),), (line, *known), relation)
        return None

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
        for other in self.scene.desk.lines:
            own = other.relation
            if not isinstance(own, Meaning):
                continue
            renamed = Relation(
                tuple(tuple(_renamed(e, own) for e in links) for links in relation.options)
            )
            line = None if renamed == relation else self.judge.standing(renamed)
            if line is not None:
                return line, other.number
        return None

    def write_parts(self, asked: Expression, relation: Relation) -> int:
        """Writes the lines of a range in several parts: the conditions, and the range."""
        conditions: list[Ref] = [*self.conditions.lines(asked), *self.conditions.story(asked)]
        known = self.judge.known(letters(asked))
        line = self.judge.write((Move("compare"),), [*conditions, *known], relation)
        if line is None and has_quantity(asked):
            line = self._parts_by_its_value(asked, relation)
        if line is None:
            raise NotPlannedError("a range in several parts")
        return line

    def _parts_by_its_value(self, asked: Expression, relation: Relation) -> int | None:
        """A range in several parts of what has a value in letters, by the ranges of these."""
        mark = self.worths.mark()
        worth = self.worths.worth(self.worths.opened(asked))
        if worth is not None:
            own = self.scene.desk.last_link(worth)
            pool = [worth, *self.judge.known(letters(own.right))]
            for move in ("sign", "monotone"):
                line = self.judge.write((Move(move),), pool, relation)
                if line is not None:
                    return line
        self.worths.back(mark)
        return None

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
        cited = [own.relation for e in under if (own := self.scene.facts.get(str(e))) is not None]
        rest = [fact for fact in rest if fact.relation not in cited]
        if line.move.id != "compare" or not rest:
            return number
        again = number != len(desk.lines)
        premises: tuple[Ref, ...] = (number,) if again else line.premises
        if not again:
            desk.lines.pop()
        for fact in rest:
            try:
                condition = self.conditions.stated(fact, subject_of(relation))
            except NotPlannedError:
                condition = None
            if condition is not None and len(premises) < MOST_COMPARED:
                premises = (*premises, condition)
        if again and len(premises) > 1:
            # An earlier part came to the range, and what this one asks besides holds there.
            return desk.write_again(line.move, premises, desk.relation(number))
        return number if again else desk.write(line.move, premises, relation)

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
            tied = letters(link.left) | letters(link.right)
            for name in sorted(tied - own) if tied & own else ():
                if name not in known or known[name].kind != "restitution":
                    continue
                pool = [tie, *self.judge.known(own)]
                links: tuple[Link, ...] = (Link(Letter(name), "<=", ONE),)
                for most in self._greatest_at_an_end(link, Letter(name)):
                    links = (Link(Letter(name), "<=", most), Link(most, "<", ONE))
                line = self.judge.write((Move("sign"),), pool, Relation((links,)))
                lines += [] if line is None else [line]
        return lines

    def _greatest_at_an_end(self, tie: Link, subject: Letter) -> Iterator[Expression]:
        """What a coefficient that is tied to one other is at most, where that is less than 1."""
        others = letters(tie.right)
        if tie.left != subject or len(others) != 1:
            return
        (symbol,) = self.worths.value(tie.right).free_symbols
        ends = [tidy(self.worths.value(tie.right).subs(symbol, end)) for end in (0, 1)]
        if all(end.is_Rational for end in ends) and 0 < max(ends) < 1:
            yield tree_of(max(ends))

    def _worths(self, trees: Sequence[Expression], quantities: Sequence[Quantity]) -> list[int]:
        """The lines of what stands in a claim: of its sides, or of the quantities in them."""
        lines: list[int] = []
        left = [quantity for quantity in quantities if not self.worths.is_data(quantity)]
        for tree in trees:
            opened = self.worths.opened(tree)
            inside = list(self.worths.quantities(opened))
            if not inside or not all(quantity in left for quantity in inside):
                continue
            mark = self.worths.mark()
            line = (
                self.worths.angle(opened)
                if is_quantity(opened, *UNSIGNED_ANGLES)
                else self.worths.worth(opened)
            )
            if line is None:
                self.worths.back(mark)
                continue
            lines.append(line)
            left = [quantity for quantity in left if quantity not in inside]
        return [*dict.fromkeys(lines), *(self.worths.quantity(quantity) for quantity in left)]


def _renamed(link: Link, meaning: Meaning) -> Link:
    """A link with a letter for the quantity for which it stands."""
    letter = Letter(meaning.letter)
    left, right = (
        rebuilt(side, lambda tree: letter if tree == meaning.quantity else tree)
        for side in (link.left, link.right)
    )
    return Link(left, link.sign, right)


def _is_acute(relation: Relation) -> bool:
    """Whether something is said to be between 0° and 90°, without both."""
    match relation.options:
        case ((Link(Degrees(value), "<", one), Link(other, "<", right)),):
            return value == 0 and one == other and right == RIGHT_ANGLE
    return False


def _of_tangent(link: Link) -> Link | None:
    """A bound of an angle as one of its tangent; None of 90°, which an acute angle is below."""
    sides: list[Expression] = []
    for side in (link.left, link.right):
        match side:
            case Letter():
                sides.append(Apply("tan", side))
            case Degrees(value) if value == 90:
                return None
            case Degrees(value) if 0 <= value < 90:
                sides.append(tree_of(tidy(sp.tan(sp.pi * sp.Rational(str(value)) / 180))))
            case Apply("arctan", inside) if not letters(inside):
                sides.append(inside)
            case _:
                return None
    return Link(sides[0], link.sign, sides[1])
