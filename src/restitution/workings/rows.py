"""The lines of a working as rows: chains with names, units and decimals at their ends."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

from restitution.explaining.lines.derivation import Line, Link, Relation
from restitution.explaining.lines.layouts import chains
from restitution.explaining.lines.opposite_roots import root_but_for_sign
from restitution.explaining.lines.saying import Sentence, operand, say
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Apply,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Unit,
    is_component,
    letters,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import tree_of
from restitution.problem import Value
from restitution.render import layout as lay
from restitution.workings.chain_sides import is_value, sign_of
from restitution.workings.chains import WORDS, Chains
from restitution.workings.leads.extremes import EXTREMA, extreme, value_reached
from restitution.workings.lines_together import between_parallels
from restitution.workings.naming.bold_letters import unit_vector
from restitution.workings.naming.measured import (
    as_answer,
    is_plain,
    rounded,
    with_unit,
    worth,
)
from restitution.workings.naming.row_sides import (
    are_values,
)
from restitution.workings.naming.sums_in_degrees import (
    degrees_of,
    is_sum_of_inverses_of_roots,
)
from restitution.workings.reasons.possible_roots import cases_together, why_possible
from restitution.workings.rendering.steps import REQUIRED, Row

# In these the second line of an equation leaves out the side that stays.
_GOES_ON = frozenset({"rearrange", "put", "identity", "value", "cancel"})
# So many lines after a letter was introduced a reader still knows what it stands for.
_REMEMBERED = 3
_ORDERS = frozenset({"<", "<=", ">", ">="})
_VECTORS = ("velocity", "impulse")


class Rows(Chains):
    """The rows of one derivation, written from the top."""

    def afresh(self) -> None:
        """The next row goes on from none."""
        self._left = None

    def of(self, line: Line, waiting: Sequence[Line], fresh: bool) -> Iterator[Row]:
        assert isinstance(line.relation, Relation)
        options = line.relation.options
        (left, item), self._left = self._left or (None, None), None
        left = left if item == line.item else None
        reached = value_reached(options)
        if reached is not None:
            place, value = reached
            row = self._chain(line, value)
            where = self._naming.relation(Relation(((place,),)))
            yield replace(row, reasons=(say("derived.for", places=(where,)),))
            return
        if len(options) > 1:
            yield self._alternatives(options, self._ends.of(line) is not None)
            return
        if line.move.record in EXTREMA and line.move.id == "answer":
            yield self._extreme(line)
            return
        groups = chains(options[0])
        for index, links in enumerate(groups):
            whole = links
            if waiting and not index:
                whole = self._with(waiting, links)
            row = self._chain(line, whole, last=index == len(groups) - 1)
            if index == len(groups) - 1 and self._ends.is_required(line):
                row = self._as_the_question_has_it(row, whole[-1])
            unit = self._unit_asked(line, links[-1])
            if unit is not None:
                if unit.operands[-1] != self._naming.layout(whole[-1].right):
                    yield row
                row = unit
            same = left is not None and not fresh and whole[0].left == left
            goes_on = line.move.id in _GOES_ON and whole[0].sign in ("=", "≈") and row.signs
            if same and goes_on and (self._single or whole[0].sign == "≈"):
                row = replace(row, operands=(None, *row.operands[1:]))
            yield row
            if all(link.sign == "=" for link in whole):
                self._left, self._single = (whole[0].left, line.item), len(whole) == 1
            fresh = False
        angle = self._angle_carried(line)
        if angle is not None:
            yield angle

    def _angle_carried(self, line: Line) -> Row | None:
        """The degrees of an angle of which a line has the tangent, where a sum below has them.

        Where a line has the angle as the inverse of a ratio, they go on from that.
        """
        if self._ends.of(line) is not None:
            return None
        match line.move.id, line.relation:
            case "inverse", Relation(((Link(Letter(), "=", value),),)) if self._is_summed(value):
                degrees = None if isinstance(value, Degrees) else degrees_of(value)
                return Row((None, self._naming.layout(degrees)), ("≈",)) if degrees else None
        for own in self._derivation.lines:
            match own.relation:
                case Relation(((Link(Letter() as angle, "=", value),),)) if (
                    (
                        own.move.id,
                        own.shown,
                    )
                    == ("inverse", "silent")
                    and line.number in own.premises
                    and (self._figures.with_calculator or self._is_summed(value))
                ):
                    degrees = degrees_of(value)
                    sides = [self._naming.layout(side) for side in (angle, degrees) if side]
                    return Row(tuple(sides), ("≈",)) if degrees else None
        return None

    def _is_summed(self, angle: Expression) -> bool:
        """Whether a line below has an angle in a sum of inverses that stands in degrees."""
        return any(
            is_sum_of_inverses_of_roots(links[0].right) and angle in set(walk(links[0].right))
            for own in self._derivation.lines
            if isinstance(own.relation, Relation)
            for links in own.relation.options
        )

    def _as_the_question_has_it(self, row: Row, link: Link) -> Row:
        """The row of what was to be shown, with the letter of the question for a time in it."""
        letters_ = self._naming.times_of_the_question()
        own = {node: Letter(letters_[node]) for node in walk(link.right) if node in letters_}
        inner = [node for whole in own for node in walk(whole) if node != whole]
        own = {node: letter for node, letter in own.items() if node not in inner}
        if not own or link.sign != "=" or link.right in own:
            return row
        side = rebuilt(link.right, lambda node: own.get(node, node))
        meanings = (Relation(((Link(letter, "=", node),),)) for node, letter in own.items())
        reason = say("derived.as", reasons=tuple(map(self._naming.relation, meanings)))
        return replace(
            row,
            operands=(*row.operands, self._naming.layout(side)),
            signs=(*row.signs, "="),
            reasons=(*row.reasons, reason),
        )

    def _unit_asked(self, line: Line, link: Link) -> Row | None:
        """The unit vector that was asked for, where a line says to what it is parallel."""
        match self._ends.asked(line), link:
            case (
                Value(expression=Quantity("line_of_centres")),
                Link(Quantity("line_of_centres", _, int(stage)), sign, vector),
            ) if sign == "parallel to" or isinstance(unsigned(vector), Unit):
                own = unsigned(vector)
                unit = vector if isinstance(own, Unit) else unit_vector(vector)
            case _:
                return None
        if unit is None:
            return None
        name = self._naming.unit_vector(self._naming.events[stage])
        return Row((operand(name), self._naming.layout(unit)), ("=",))

    def asides(self, line: Line, conditioned: bool) -> Iterator[Sentence]:
        """What stands behind a row in brackets: that it was to be shown, which roots there are.

        Of roots that are ``conditioned`` another sentence says when.
        """
        end = self._ends.of(line)
        if self._ends.is_required(line):
            yield from REQUIRED
        if end is not None and not end.shown and isinstance(line.relation, Relation):
            called = self._called(line)
            if called is not None:
                yield called
            if self._is_gain(line):
                yield say("derived.gained")
            excluded = conditioned or self._is_refused(line)
            if are_values(line.relation) and not excluded and line.move.record != "either-side":
                yield why_possible(self._derivation, self._naming, line)
        if end is None and self._parts_the_cases(line):
            yield why_possible(self._derivation, self._naming, line)

    def _parts_the_cases(self, line: Line) -> bool:
        """Whether a line that is no answer has values of a letter that lead to several answers.

        Not where a sentence below the last of them tells what they are together.
        """
        part = self._derivation.asked.get(line.item or "")
        return (
            any(case.line == line.number for case in self._derivation.cases)
            and isinstance(line.relation, Relation)
            and are_values(line.relation)
            and not self._is_refused(line)
            and cases_together(self._derivation, self._naming, self._measures, part) is None
        )

    def _is_refused(self, line: Line) -> bool:
        """Whether none of the values in a line can be."""
        return any(
            note.kind == "impossible" and line.number in note.lines
            for note in self._derivation.notes
        )

    def _is_gain(self, line: Line) -> bool:
        """Whether a loss of kinetic energy that was asked is a negative number."""
        assert isinstance(line.relation, Relation)
        match self._ends.asked(line):
            case Value(expression=Quantity(kind)) if kind in LOSSES:
                value = line.relation.options[0][-1].right
                return isinstance(value, Negate) and not letters(value)
        return False

    @staticmethod
    def _with(waiting: Sequence[Line], links: tuple[Link, ...]) -> tuple[Link, ...]:
        """A chain that takes up lines written within it."""
        whole = list(links)
        for line in reversed(waiting):
            assert isinstance(line.relation, Relation)
            before = line.relation.options[0]
            if before[0].left == whole[0].left:
                first, sides = whole[0], [whole[0].right]
                sign = first.sign
                if sign == "parallel to":
                    sign = "="
                    sides = [*(between_parallels(before[-1].right, first.right) or sides)]
                steps = pairwise((before[-1].right, *sides))
                whole = [*before, *(Link(a, sign, b, first.by) for a, b in steps), *whole[1:]]
            else:
                whole = [*before, *whole]
        return tuple(whole)

    def _called(self, line: Line) -> Sentence | None:
        """What a letter stands for that was introduced a while ago, where it is what was asked.

        Not a component along a line of centres: that is what its letter is known for.
        """
        asked = self._ends.asked(line)
        if not isinstance(asked, Value) or not isinstance(asked.expression, Quantity):
            return None
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        if not isinstance(left, Letter) or left.name not in self._naming.meanings:
            return None
        meaning = self._naming.meanings[left.name]
        if is_component(meaning.quantity):
            return None
        numbers = [line.number for line in self._derivation.lines]
        since = next(e.number for e in self._derivation.lines if e.relation == meaning)
        if numbers.index(line.number) - numbers.index(since) <= _REMEMBERED:
            return None
        return say("derived.called", quantity=self._naming.quantity(meaning.quantity))

    def decimals(self, line: Line) -> Row | None:
        """A row with the ends of a range to three figures, where roots or angles are in them."""
        end = self._ends.of(line)
        if end is None or end.shown or not isinstance(line.relation, Relation):
            return None
        if line.move.record in EXTREMA:
            return None
        if len(line.relation.options) != 1 or len(chains(line.relation.only)) != 1:
            return None
        links = line.relation.only
        if any(link.sign not in _ORDERS for link in links):
            return None
        sides = [links[0].left, *(link.right for link in links)]
        ends = [rounded(side) if _has_function(side) else None for side in sides]
        exact = tuple(self._naming.layout(side) for side in sides)
        figures = tuple(new or layout for new, layout in zip(ends, exact, strict=True))
        if figures == exact:
            return None
        reasons = (say("shown.figures", figures="3"),)
        bounded = list(figures)
        self._bounded(sides, bounded)
        return Row(tuple(bounded), tuple(sign_of(link) for link in links), reasons=reasons)

    def with_decimals(self, rows: Sequence[Row], line: Line) -> list[Row]:
        """Rows with the ends of their range to three figures below them, or the last one behind it.

        With a calculator they take the place of ends that nobody would write.
        """
        *above, last = rows
        decimals = self.decimals(line)
        if decimals is None:
            return [*rows]
        assert isinstance(line.relation, Relation)
        by_calculator = self._figures.with_calculator
        if not by_calculator or not any(map(self._figures.is_carried, line.relation.trees)):
            if decimals.operands[:-1] != last.operands[:-1] or decimals.signs != last.signs:
                return [*rows, decimals]
            operands, signs = (*last.operands, decimals.operands[-1]), (*last.signs, "≈")
            return [*above, replace(last, operands=operands, signs=signs)]
        reasons = (*last.reasons, *decimals.reasons)
        return [
            *above,
            replace(last, operands=decimals.operands, signs=decimals.signs, reasons=reasons),
        ]

    def _alternatives(self, options: tuple[tuple[Link, ...], ...], asked: bool) -> Row:
        """``t = 1 or t = −1``, set at the first sign; opposite roots as ``t = ±1``."""
        first, *rest = options
        root = None if asked else root_but_for_sign(options)
        if root is not None:
            own = self.in_figures(root)
            if own != root:
                # In the lines below it may have a tangent for the quotient of sine and cosine.
                for form in (root.right, tree_of(worth(root.right))):
                    self._figures.stands_for(form, own.right)
            subject, size = self._naming.layout(own.left), self._naming.layout(own.right)
            either = lay.Brackets(size) if isinstance(size, lay.Sum) else size
            return Row((subject, lay.Phrase((lay.Words("±"), either), "")), (own.sign,))
        if any(len(chains(option)) > 1 for option in options):
            cases = tuple(
                say("derived.both", values=tuple(self._bare(e, asked) for e in chains(option)))
                for option in options
            )
            return Row((operand(say("derived.either", values=cases)),), (), alternatives=True)
        words = WORDS.get(first[0].sign)
        if words is not None and all(len(option) == 1 for option in options):
            left = self._naming.side(first[0].left)
            values = tuple(self._naming.side(option[0].right) for option in options)
            right = say("derived.either", values=values)
            return Row((operand(say(words, left=left, right=right)),), (), alternatives=True)
        if isinstance(first[0].left, Quantity) and first[0].left.kind in _VECTORS:
            asked = False  # the line above has the value
        row = self._bare(first, asked)
        others: list[lay.Layout] = [self._bare(chain, asked) for chain in rest]
        if isinstance(first[0].left, Quantity) and all(len(option) == 1 for option in options):
            # A quantity in words stands once.
            others = [
                _without_subject(other) for other in others if isinstance(other, lay.Relation)
            ]
        final = lay.Phrase((row.operands[-1], *others), str(say("list.or")))
        return Row((*row.operands[:-1], final), row.signs, alternatives=True)

    def _extreme(self, line: Line) -> Row:
        """The greatest or the least value and where it is reached, or what is only approached."""
        assert isinstance(line.relation, Relation)
        link = line.relation.only[-1]
        end = self._ends.of(line)
        shown = end is not None and end.shown
        called, sign, reasons = extreme(self._derivation, self._naming, line, shown)
        sides, signs = [called, self._naming.layout(link.right)], [sign]
        self._ended(line, (Link(link.left, "=", link.right),), sides, signs)
        return Row(tuple(sides), tuple(signs), reasons=reasons)

    def _bare(self, links: tuple[Link, ...], asked: bool) -> lay.Relation:
        trees = [links[0].left, *(link.right for link in links)]
        figures = [self.by_calculator(link) for link in links]
        sides = list(map(self._naming.layout, (trees[0], *figures)))
        signs = [
            sign_of(link) if figure == link.right else "≈"
            for link, figure in zip(links, figures, strict=True)
        ]
        for side, sign in as_answer(trees[-1]) if asked and links[-1].sign == "=" else ():
            if isinstance(figures[-1], Number):
                sides[-1:], signs[-1:] = [side], [sign]  # three figures at once
            else:
                sides.append(side)
                signs.append(sign)
        if is_value(trees[0]) and is_plain(sides[-1]) and signs[-1] in ("=", "≈"):
            sides[-1] = with_unit(sides[-1], self._measures.unit(trees[0]))
        return lay.Relation(tuple(sides), tuple(signs))


def _has_function(tree: Expression) -> bool:
    """Whether there are roots or angles of which only a calculator knows the value."""
    return any(isinstance(node, Apply) for node in walk(tree))


def _without_subject(relation: lay.Relation) -> lay.Layout:
    """The right sides of an equation."""
    sides, signs = relation.operands[1:], relation.signs[1:]
    return sides[0] if len(sides) == 1 else lay.Relation(sides, signs)
