"""The lines of a working as rows: chains with names, units and decimals at their ends."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import sympy as sp

from restitution.explaining.lines.derivation import Derivation, Line, Link, Relation
from restitution.explaining.lines.layouts import chains
from restitution.explaining.lines.opposite_roots import root_but_for_sign
from restitution.explaining.lines.saying import Sentence, operand, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Quantity,
    Unit,
    has_quantity,
    is_function,
    is_quantity,
    is_zero,
    letters,
    unsigned,
    walk,
)
from restitution.planning.writing.forms import coordinates, negative
from restitution.problem import Value
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.solving.story.letters import roles
from restitution.workings.leads.extremes import EXTREMA, extreme, value_reached
from restitution.workings.leads.senses import direction_by_its_sense
from restitution.workings.naming.bold_letters import unit_vector
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.figures import (
    FIGURES_BETWEEN,
    Figures,
    has_plain_angles,
    has_sums_of_nested_roots,
    in_letters_with_figures,
    is_of_nested_roots,
    of_plain_angles,
)
from restitution.workings.naming.measured import (
    Measures,
    as_answer,
    as_decimal,
    is_long_quotient,
    is_plain,
    multiple_in_figures,
    percentage,
    rounded,
    terms_as_decimals,
    to_figures,
    to_three_figures,
    with_unit,
    worth,
)
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.row_sides import (
    are_values,
    has_decimals,
    has_long_root,
    is_vector_of_short_decimals,
    turned_side,
    without_doubles,
)
from restitution.workings.naming.senses_at_walls import away, is_turned, turned_value
from restitution.workings.naming.sources import is_displacement, is_time, is_vector
from restitution.workings.naming.values_of_letters import in_the_other_sense, with_values
from restitution.workings.rendering.steps import REQUIRED, Row

# In these the second line of an equation leaves out the side that stays.
_GOES_ON = frozenset({"rearrange", "put", "identity", "value", "cancel"})
# So many lines after a letter was introduced a reader still knows what it stands for.
_REMEMBERED = 3
# The root of an equation is told exactly, and so are answers of at most so many signs.
_EXACTLY = frozenset({"roots", "reject"})
_LONGEST_ANSWER = 40
# No number from here on stands under a root; where data are decimals, none of four figures.
_NEVER_READ = 10000
_TANGENTS = frozenset({"tan", "tan-direction"})
# What is divided by the length of a direction: a reader sees its root below the line.
_BY_A_LENGTH = frozenset({"scalar-angle", "component"})
_ORDERS = frozenset({"<", "<=", ">", ">="})
_VECTORS = ("velocity", "impulse")
_WORDS = {"parallel to": "claim.parallel", "perpendicular to": "claim.perpendicular"}


class Rows:
    """The rows of one derivation, written from the top."""

    def __init__(
        self, derivation: Derivation, naming: Naming, measures: Measures, ends: Ends
    ) -> None:
        self._derivation = derivation
        self._naming = naming
        self._measures = measures
        self._ends = ends
        self._figures = Figures()
        # The left sides of lines with figures in place of roots of sums of roots.
        self._in_figures_above: set[Expression] = set()
        # The left side of the row above, and the item to which it belongs.
        self._left: tuple[Expression, str | None] | None = None
        self._single = True

    def instead_of(self, tree: Expression) -> Expression:
        """The figures of a value that is on paper with them; any other as it is."""
        return self._figures.instead_of(tree)

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
            unit = self._unit_asked(line, whole[-1])
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
            if are_values(line.relation) and not conditioned:
                yield say(self._possible(line.relation))

    def _possible(self, relation: Relation) -> SentenceId:
        """Why both of two values hold, where that is seen; that all do, where there are more."""
        if len(relation.options) != 2:
            return "derived.all-possible"
        left = relation.options[0][0].left
        values = [worth(links[-1].right) for links in relation.options]
        if not all(value.is_positive for value in values):
            return "derived.both-possible"
        roles_ = roles(self._naming.problem)
        match left:
            case Letter(name) if name in roles_ and roles_[name].kind == "restitution":
                return "derived.both-coefficients"
            case Letter(name) if name in roles_ and roles_[name].kind == "positive":
                return "derived.both-positive"
            case Apply("tan", Letter(name)) if name in roles_ and roles_[name].high == sp.pi / 2:
                return "derived.both-positive"
        return "derived.both-possible"

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
                first = Link(before[-1].right, whole[0].sign, whole[0].right, whole[0].by)
                whole = [*before, first, *whole[1:]]
            else:
                whole = [*before, *whole]
        return tuple(whole)

    def _chain(self, line: Line, links: tuple[Link, ...], last: bool = True) -> Row:
        """A chain as a row: with the name of what was asked, units, and a decimal at its end."""
        compared = with_values(self._derivation, self._naming, line, links)
        if compared != links:
            trees = [compared[0].left, *(link.right for link in compared)]
            layouts = [self._naming.layout(tree) for tree in trees]
            if is_zero(trees[-1]) and is_plain(layouts[1]):
                layouts[1] = with_unit(layouts[1], self._measures.unit(trees[0]))
            return Row(tuple(layouts), tuple(map(_sign, compared)))
        words = _WORDS.get(links[0].sign)
        sense = direction_by_its_sense(self._derivation, self._naming, line)
        if sense is not None:
            return Row((operand(sense),), ())
        if words is not None:
            left, right = map(self._naming.side, (links[0].left, links[0].right))
            return Row((operand(say(words, left=left, right=right)),), ())
        trees = [links[0].left, *(link.right for link in links)]
        # Of a range it stands between its bounds.
        subject = trees[1] if isinstance(as_decimal(trees[0]), Number) else trees[0]
        if self._measures.decimals and self._measures.unit(subject):
            trees = [terms_as_decimals(as_decimal(tree)) for tree in trees]
        trees = list(map(self._measures.with_decimals, trees))
        match links[0]:
            case Link(Binary("/", Quantity(), Quantity()), _, Binary("/", above, below)) if (
                self._measures.decimals
            ):
                trees[1] = Binary("/", as_decimal(above), as_decimal(below))
        match links[0]:
            case Link(Quantity("line_of_centres"), "=") if not self._measures.decimals:
                trees[1:] = [unit_vector(tree) or tree for tree in trees[1:]]
        nested = any(map(has_sums_of_nested_roots, trees))
        in_figures = self._in_figures(line, links, trees)
        sides = [self._naming.layout(tree) for tree in trees]
        idle = {
            n: sides[n]
            for n, tree in enumerate(trees)
            if n not in in_figures
            and n > min(in_figures, default=n)
            and (has_plain_angles(tree) or has_sums_of_nested_roots(tree))
        }
        # With figures put in, and still to be worked out.
        worked = [
            sides[n] for n in in_figures if of_plain_angles(trees[n]) or (nested and n < len(links))
        ]
        match trees:
            case [Binary("/", Quantity(), Quantity()), Binary("/", Number() as above, below), *_]:
                # A quotient of two numbers stands as it is before its decimal.
                sides[1] = lay.Fraction(*map(self._naming.layout, (above, below)))
        if is_vector(links[0].left):
            sides = [
                lay.ZERO_VECTOR if is_zero(t) else s for t, s in zip(trees, sides, strict=True)
            ]
        typed = self._ends.typed(line, replace(links[0], sign=links[-1].sign)) if last else None
        if typed is not None and not is_vector(links[0].left):
            sides[-1] = typed
        for n, link in enumerate(links, 1):
            if link.sign == "≈":
                sides[n] = to_three_figures(trees[n]) or sides[n]
        signs = ["≈" if n in in_figures else _sign(link) for n, link in enumerate(links, 1)]
        signs[:1] = ["≈"] if 0 in in_figures else signs[:1]
        if (angle := self._tangent_of(line, links[0])) is not None:
            sides[:0], signs[:0] = [self._naming.layout(Apply("tan", angle))], ["="]
        match links[0].right:
            case Binary("/") | Negate(Binary("/")) if (
                line.move.record in _BY_A_LENGTH and len(links) > 1
            ):
                sides[1] = self._unrationalised(trees[1] if 1 in in_figures else links[0].right)
            case (Binary("/", above, below) | Negate(Binary("/", above, below))) as ratio if (
                line.move.record in _TANGENTS
                and len(links) > 1
                and _has_root(below)
                and 1 not in in_figures
            ):
                # Components that are multiples of roots stand as they are before they cancel.
                own = lay.fraction(*map(self._naming.layout, (above, below)))
                sides[1] = lay.negative(own) if isinstance(ratio, Negate) else own
        without_doubles(sides, signs)
        quotient = self._quotient(line, links[0])
        if quotient is not None and isinstance(sides[1], lay.Number) and not self._by_axis(line):
            alone = len(trees) == 2 and self._naming.in_fractions(trees[0])
            sides[1 : 1 + alone], signs[:alone] = [quotient], ["="]
        back = in_the_other_sense(self._derivation, self._naming, line, links)
        if back is not None:
            sides[1:1], signs[:0] = [self._naming.layout(back)], ["="]
        shown = [side for side in sides if id(side) not in map(id, idle.values())]
        if self._ends.of(line) is None and is_turned(self._naming, links, shown):
            sides[0] = away(self._naming, links[0].left)
            turned = {id(side): turned_value(self._naming, links, side) for side in sides[1:]}
            sides[1:] = [turned[id(side)] for side in sides[1:]]
            idle = {n: turned.get(id(side), side) for n, side in idle.items()}
        if line.move.id == "solve" and not last and _is_value(links[0].left):
            unit = self._measures.unit(links[0].left)
            sides[-1] = with_unit(sides[-1], unit) if is_plain(sides[-1]) else sides[-1]
        if signs[-1] in ("=", "≈") and last:
            self._ended(line, links, sides, signs)
            self._placed(line, links, sides, signs)
            # Behind figures a value is not written once more exactly.
            for n in range(len(sides) - 1, 0, -1):
                if any(sides[n] is layout for layout in idle.values()):
                    del sides[n], signs[n - 1]
            if idle:
                without_doubles(sides, signs)
            for n in idle:
                self._figures.stands_for(trees[n], trees[min(in_figures)])
            if signs[-2:] == ["≈", "≈"] and is_plain(sides[-2]) and sides[-2] not in worked:
                del sides[-2], signs[-2]  # an answer has three figures at once
            shortest = 1000 if self._measures.decimals else _NEVER_READ
            if signs[-1] == "≈" and len(sides) > 3 and has_long_root(trees[-1], shortest):
                del sides[-2], signs[-2]
            more = self._one_figure_more(line)
            if more is not None:
                sides.insert(1, more)
                signs.insert(0, "≈")
        elif last and self._ends.of(line) is not None:
            self._bounded(trees, sides)
        return Row(tuple(sides), tuple(signs))

    def _one_figure_more(self, line: Line) -> lay.Layout | None:
        """A value by its figures before it is rounded; None where it was not yet rounded above."""
        (first, *_) = line.premises if line.move.id == "value" else (None,)
        above = self._derivation.line(first)
        end = None if above is None else self._ends.of(above)
        if above is None or end is None or end.shown or not isinstance(above.relation, Relation):
            return None
        if len(above.relation.options) > 1:
            return None
        return multiple_in_figures(above.relation.only[-1].right, FIGURES_BETWEEN)

    def _in_figures(
        self, line: Line, links: tuple[Link, ...], trees: list[Expression]
    ) -> frozenset[int]:
        """Puts figures for values that are on paper; the numbers of the sides that have them."""
        exact = list(trees)
        last = trees[-1]
        # Some come to an exact number.
        plain = len(links) > 1 and not (
            has_quantity(last)
            or letters(last)
            or of_plain_angles(last)
            or has_sums_of_nested_roots(last)
        )
        plain = plain or self._stays_exact(line, last)
        if not plain and has_sums_of_nested_roots(trees[0]) and links[0].sign == "=":
            trees[0] = self._figures.put(trees[0])
        for n, link in enumerate(() if plain else links, 1):
            if link.sign not in ("=", "≈"):
                continue
            outcome = n == len(links) > 1 and not isinstance(trees[n], Apply)
            trees[n] = self._figures.put(trees[n], outcome)
            if is_vector(links[0].left) and self._ends.of(line) is None:
                trees[n] = self._figures.vector(trees[n])
        if line.move.record == "scalar-angle" and len(links) > 1 and has_long_root(trees[-1]):
            # Nobody multiplies two roots to have one of such a number.
            trees[-1] = self._figures.cosine(trees[-1])
        if isinstance(links[0].left, Apply) and trees[-1] != exact[-1]:
            self._figures.stands_for(exact[-1], trees[-1])  # of the angle itself, next
        put = frozenset(n for n, tree in enumerate(trees) if tree != exact[n])
        if put and any(map(has_sums_of_nested_roots, exact)):
            self._in_figures_above.add(exact[0])
        return put

    def _stays_exact(self, line: Line, last: Expression) -> bool:
        """Whether a value with roots of sums of roots stays exact: a root, a short answer."""
        if not has_sums_of_nested_roots(last):
            return False
        if line.move.id in _EXACTLY:
            return True
        answer = self._ends.of(line) is not None and not isinstance(last, Apply)
        if line.relation.trees[0] in self._in_figures_above:
            return False
        return answer and len(to_text(self._naming.layout(last))) <= _LONGEST_ANSWER

    def _unrationalised(self, ratio: Expression) -> lay.Layout:
        """A quotient by a root as it stands, where its layout would have a whole number below."""
        own = unsigned(ratio)
        whole = self._naming.layout(ratio)
        match own:
            case Binary("/", Number() as above, below) | Binary(
                "/", Letter() | Binary("*") as above, Apply("sqrt") as below
            ) if not letters(below):
                quotient = lay.Fraction(self._naming.layout(above), self._naming.layout(below))
                return quotient if own is ratio else lay.negative(quotient)
        return whole

    def _quotient(self, line: Line, link: Link) -> lay.Layout | None:
        """The quotient of two numbers, a decimal next: of components, or of a flight."""
        flight = line.move.record == "straight-line" and is_time(link.left)
        match link.right:
            case Binary("/", above, below) if flight or line.move.record in _TANGENTS:
                sides = [self._naming.layout(tree) for tree in (above, below)]
                if all(isinstance(side, lay.Number) for side in sides):
                    return lay.Fraction(*sides)
        return None

    def _by_axis(self, line: Line) -> bool:
        """Whether a ratio is that of a line of centres which a line tells, and of no components."""
        above = self._derivation.lines_in(line.premises)
        return any(
            isinstance(own.relation, Relation)
            and is_quantity(own.relation.options[0][0].left, "line_of_centres")
            for own in above
        )

    def _tangent_of(self, line: Line, link: Link) -> Expression | None:
        """The given sum or difference of angles of which a row is the tangent, if it is left out.

        None where the row has the tangent of an angle on a side.
        """
        if line.move.record != "sum-of-angles" or not isinstance(link.left, Binary):
            return None
        if link.left.op != "/" or isinstance(link.right, Apply):
            return None
        for ref in line.premises:
            fact = self._derivation.fact(ref)
            if fact is not None and fact.kind == "given" and len(fact.relation.options) == 1:
                match fact.relation.only:
                    case (Link(Binary("+" | "-") as angle, "="),):
                        return angle
        return None

    def _placed(
        self, line: Line, links: tuple[Link, ...], sides: list[lay.Layout], signs: list[str]
    ) -> None:
        """Where a body is by its coordinates, if that was asked.

        They take the place of a position vector that is made of them, unless other places are
        worked out as vectors.
        """
        end, asked = self._ends.of(line), self._ends.asked(line)
        if end is None or end.shown or len(links) > 1 or line.move.id == "rearrange":
            return
        match asked:
            case Value(expression=Quantity("position", (Name(),))) if not self._has_vectors():
                place = self._coordinates(line, links[-1])
                if place:
                    sides[1:], signs[1:] = [a for a, _ in place], [sign for _, sign in place[1:]]

    def _has_vectors(self) -> bool:
        """Whether a place is worked out as a vector, which is neither asked nor the origin."""
        return any(
            isinstance(line.relation, Relation)
            and self._ends.of(line) is None
            and any(
                is_quantity(link.left, "position")
                and any(isinstance(node, Unit) for node in walk(link.right))
                for link in line.relation.options[0]
            )
            for line in self._derivation.lines
        )

    def _coordinates(self, line: Line, link: Link) -> tuple[tuple[lay.Layout, str], ...]:
        """The coordinates of a place, exactly and as decimals, each with the sign before it."""
        assert isinstance(line.relation, Relation)
        shown = list(as_answer(link.right, True))
        if not shown:
            return ()
        decimals = self._measures.decimals and self._measures.unit(link.left)
        point = coordinates(as_decimal(link.right) if decimals else link.right)
        if point is not None:
            shown[0] = (self._naming.layout(Pair(*point)), "=")
        if decimals and [sign for _, sign in shown[1:]] == ["="]:
            shown = shown[:1]
        if is_plain(self._naming.layout(link.right)):
            unit = self._measures.unit(line.relation.options[0][0].left)
            last, sign = shown[-1]
            shown[-1] = (with_unit(last, unit), sign)
        return tuple(shown)

    def _ended(
        self,
        line: Line,
        links: tuple[Link, ...],
        sides: list[lay.Layout],
        signs: list[str],
    ) -> None:
        """Puts what belongs to a value at the end of a row: its name, its unit, a decimal."""
        left, right = links[0].left, links[-1].right
        end = self._ends.of(line)
        worth = not has_quantity(right) and (_is_value(left) or end is not None)
        worth = worth and not self._measures.has_units_of_its_own(right)
        unit = self._measures.unit(left) if worth else ""
        asked = self._ends.asked(line)
        if end is not None and not end.shown:
            if isinstance(asked, Value) and asked.percentage:
                hundred = percentage(right)
                if hundred is not None:
                    if sides[0] == operand(say("derived.fraction-lost")):
                        sides[0] = operand(say("derived.percentage-lost"))
                    if len(sides) > 2 and has_decimals(sides[-2]) and is_long_quotient(right):
                        del sides[-1], signs[-1]  # the decimals above it say more
                    sides.append(hundred[0])
                    signs.append(hundred[1])
                return
            place = self._ends.is_place(line) and line.move.id != "rearrange"
            place = place and not self._has_vectors()
            decimals = self._measures.decimals
            added = as_answer(right, False, decimals) if links[-1].sign == "=" else ()
            for side, sign in () if place else added:
                if sign == "≈" and is_vector_of_short_decimals(sides[-1]):
                    continue  # one component alone would be rounded
                if side != sides[-1] and not (sign == "=" and has_decimals(sides[-1])):
                    sides.append(side)
                    signs.append(sign)
        in_letters = in_letters_with_figures(right) if end is None and not unit else None
        if in_letters is not None and links[-1].sign == "=" and _is_value(left):
            printed = self._as_printed(right, sides[-1]) or right
            sides.append(self._naming.layout(in_letters_with_figures(printed) or in_letters))
            signs.append("≈")
            self._figures.note(right)
        elif (
            end is None
            and (unit or is_of_nested_roots(right))
            and links[-1].sign == "="
            and (of_plain_angles(right) or self._is_carried(line, links[-1]))
        ):
            tree = self._as_printed(right, sides[-1])
            figures = None if tree is None else to_figures(tree, FIGURES_BETWEEN)
            if figures is not None:
                sides.append(figures)
                signs.append("≈")
                self._figures.note(right)
        nothing = sides[-1] in (lay.Number("0"), lay.ZERO_VECTOR)
        answered = end is not None and not has_quantity(right)
        if unit and not nothing and (answered or is_plain(sides[-1])):
            sides[-1] = with_unit(sides[-1], unit)

    def _is_carried(self, line: Line, link: Link) -> bool:
        """Whether a value with roots of sums of roots is used from here, and told no plainer."""
        return is_of_nested_roots(link.right) and not any(
            own.number > line.number
            and isinstance(own.relation, Relation)
            and own.relation.options[0][0].left == link.left
            for own in self._derivation.lines
        )

    def _as_printed(self, right: Expression, side: lay.Layout) -> Expression | None:
        """A side as it is printed: that of a component away from a wall has the other sign.

        None where it is printed in another form.
        """
        own = self._naming.layout(right)
        other = turned_side(own) or lay.negative(own)
        return {own: right, other: negative(right)}.get(side)

    def _bounded(self, trees: Sequence[Expression], sides: list[lay.Layout]) -> None:
        """Puts the unit of what a range is of behind the numbers that bound it."""
        subject = [tree for tree in trees if has_quantity(tree) or isinstance(tree, Letter)]
        unit = self._measures.unit(subject[0]) if len(subject) == 1 else ""
        for n, tree in enumerate(trees):
            if unit and tree not in subject and not is_zero(tree):
                sides[n] = with_unit(sides[n], unit)

    def _called(self, line: Line) -> Sentence | None:
        """What a letter stands for that was introduced a while ago, where it is what was asked."""
        asked = self._ends.asked(line)
        if not isinstance(asked, Value) or not isinstance(asked.expression, Quantity):
            return None
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        if not isinstance(left, Letter) or left.name not in self._naming.meanings:
            return None
        meaning = self._naming.meanings[left.name]
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
        return Row(tuple(bounded), tuple(_sign(link) for link in links), reasons=reasons)

    def _alternatives(self, options: tuple[tuple[Link, ...], ...], asked: bool) -> Row:
        """``t = 1 or t = −1``, set at the first sign; opposite roots as ``t = ±1``."""
        first, *rest = options
        root = None if asked else root_but_for_sign(options)
        if root is not None:
            subject, size = self._naming.layout(root.left), self._naming.layout(root.right)
            either = lay.Brackets(size) if isinstance(size, lay.Sum) else size
            return Row((subject, lay.Phrase((lay.Words("±"), either), "")), ("=",))
        if any(len(chains(option)) > 1 for option in options):
            cases = tuple(
                say("derived.both", values=tuple(self._bare(e, asked) for e in chains(option)))
                for option in options
            )
            return Row((operand(say("derived.either", values=cases)),), (), alternatives=True)
        words = _WORDS.get(first[0].sign)
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
        sides = [self._naming.layout(tree) for tree in trees]
        signs = [_sign(link) for link in links]
        for side, sign in as_answer(trees[-1]) if asked and signs[-1] == "=" else ():
            sides.append(side)
            signs.append(sign)
        if _is_value(trees[0]) and is_plain(sides[-1]) and signs[-1] in ("=", "≈"):
            sides[-1] = with_unit(sides[-1], self._measures.unit(trees[0]))
        return lay.Relation(tuple(sides), tuple(signs))


def _has_function(tree: Expression) -> bool:
    """Whether there are roots or angles of which only a calculator knows the value."""
    return any(isinstance(node, Apply) for node in walk(tree))


def _without_subject(relation: lay.Relation) -> lay.Layout:
    """The right sides of an equation."""
    sides, signs = relation.operands[1:], relation.signs[1:]
    return sides[0] if len(sides) == 1 else lay.Relation(sides, signs)


def _is_value(tree: Expression) -> bool:
    """Whether a side names one quantity, whose dimension is known."""
    return isinstance(tree, Letter | Quantity) or is_time(tree) or is_displacement(tree)


def _has_root(tree: Expression) -> bool:
    """Whether a tree has a root in it."""
    return any(is_function(node, "sqrt") for node in walk(tree))


def _sign(link: Link) -> str:
    return lay.SIGNS.get(link.sign, link.sign)
