"""A chain as one row of a working: its sides, the signs between them, and its end."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from restitution.explaining.lines.derivation import (
    Line,
    Link,
    Relation,
)
from restitution.explaining.lines.saying import operand, say
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
    has_quantity,
    has_root,
    has_unit_vector,
    is_function,
    is_quantity,
    is_zero,
    letters,
)
from restitution.planning.writing.forms import coordinates, negative
from restitution.problem import Value
from restitution.render import layout as lay
from restitution.workings.chain_figures import BY_A_LENGTH, TANGENTS, ChainsInFigures
from restitution.workings.chain_sides import (
    Draft,
    as_printed,
    is_by_axis,
    is_multiple,
    is_value,
    sign_of,
    tangent_left_out,
    unrationalised,
)
from restitution.workings.fuller_figures import one_figure_more
from restitution.workings.leads.senses import direction_by_its_sense
from restitution.workings.naming.bold_letters import unit_vector
from restitution.workings.naming.measured import (
    as_answer,
    as_decimal,
    is_long_quotient,
    is_measure_of_angle,
    is_plain,
    is_rounded_to,
    percentage,
    terms_as_decimals,
    to_figures,
    to_three_figures,
    with_unit,
)
from restitution.workings.naming.plain_angles import has_plain_angles, of_plain_angles, plain_angles
from restitution.workings.naming.roots_of_roots import has_long_root
from restitution.workings.naming.row_sides import (
    has_decimals,
    is_vector_of_short_decimals,
    turned_side,
    without_doubles,
)
from restitution.workings.naming.scaled_equations import in_decimals_as_above
from restitution.workings.naming.senses_at_walls import away, is_turned, turned_value
from restitution.workings.naming.sources import is_time, is_vector
from restitution.workings.naming.sums_in_degrees import (
    degrees_of,
    is_figures,
    is_sum_with_inverse,
)
from restitution.workings.naming.values_of_letters import in_the_other_sense, with_values
from restitution.workings.rendering.steps import Row

# No number from here on stands under a root; where data are decimals, none of four figures.
_NEVER_READ = 10000
# What has no unit.
_NOTHING = (lay.Number("0"), lay.ZERO_VECTOR)
WORDS = {"parallel to": "claim.parallel", "perpendicular to": "claim.perpendicular"}


class Chains(ChainsInFigures):
    """The rows of one derivation that are chains."""

    def _chain(self, line: Line, links: tuple[Link, ...], last: bool = True) -> Row:
        """A chain as a row: with the name of what was asked, units, and a decimal at its end."""
        whole = self._by_letters(line, links) or self._in_words(line, links)
        if whole is not None:
            return whole
        if self._long_numbers:
            links = in_decimals_as_above(self._derivation, line, links)
        draft = self._draft(line, links)
        self._as_asked(draft, last)
        self._with_quotients(draft)
        self._with_senses(draft)
        if line.move.id == "solve" and not last and is_value(links[0].left):
            unit, value = self._measures.unit(links[0].left), draft.sides[-1]
            draft.sides[-1] = with_unit(value, unit) if is_plain(value) else value
        if draft.signs[-1] in ("=", "≈") and last:
            self._with_its_end(draft)
            own = draft.trees[-1], draft.sides[-1], draft.signs[-1]
            measured = bool(self._measures.unit(links[0].left))
            self._decimals.note(links[-1], *own, measured=measured)
        elif last and self._ends.of(line) is not None:
            self._bounded(draft.trees, draft.sides)
        return Row(tuple(draft.sides), tuple(draft.signs))

    def _by_letters(self, line: Line, links: tuple[Link, ...]) -> Row | None:
        """A chain in which letters have their values, where it compares these."""
        compared = with_values(self._derivation, self._naming, line, links)
        if compared == links:
            return None
        trees = [compared[0].left, *(link.right for link in compared)]
        layouts = [self._naming.layout(tree) for tree in trees]
        if is_zero(trees[-1]) and is_plain(layouts[1]):
            layouts[1] = with_unit(layouts[1], self._measures.unit(trees[0]))
        return Row(tuple(layouts), tuple(map(sign_of, compared)))

    def _in_words(self, line: Line, links: tuple[Link, ...]) -> Row | None:
        """A direction by its sense, and what is parallel or perpendicular to what."""
        words = WORDS.get(links[0].sign)
        sense = direction_by_its_sense(self._derivation, self._naming, line)
        if sense is not None:
            return Row((operand(sense),), ())
        if words is not None:
            left, right = map(self._naming.side, (links[0].left, links[0].right))
            # A vector may be worked out in the same line.
            further = tuple(self._naming.layout(link.right) for link in links[1:])
            signs = tuple(sign_of(link) for link in links[1:])
            return Row((operand(say(words, left=left, right=right)), *further), signs)
        return None

    def _trees(self, links: tuple[Link, ...], of_vectors: bool = False) -> list[Expression]:
        """The sides of a chain, as decimals where the data are decimals.

        ``of_vectors`` says that all numbers in it are components.
        """
        trees = [links[0].left, *(link.right for link in links)]
        # Of a range it stands between its bounds.
        subject = trees[1] if isinstance(as_decimal(trees[0]), Number) else trees[0]
        if self._measures.is_in_decimals(subject):
            trees = [terms_as_decimals(as_decimal(tree)) for tree in trees]
        trees = list(map(self._measures.with_decimals, trees))
        match links[0]:
            case Link(Binary("/", Quantity(), Quantity()), _, Binary("/", above, below)) if (
                self._measures.decimals
            ):
                trees[1] = Binary("/", as_decimal(above), as_decimal(below))
            case Link(Quantity("line_of_centres"), "=") if not self._measures.decimals:
                trees[1:] = [unit_vector(tree) or tree for tree in trees[1:]]
        measured = bool(self._measures.unit(links[0].left))
        return self._decimals.put(trees, measured=measured, of_vectors=of_vectors)

    def _draft(self, line: Line, links: tuple[Link, ...]) -> Draft:
        """The sides as they are set by themselves, with figures for values that are on paper."""
        trees = self._trees(links, line.move.record in BY_A_LENGTH)
        nested = any(map(self._figures.has_sums_of_roots, trees))
        in_figures = self._in_figures(line, links, trees)
        sides = [self._naming.layout(tree) for tree in trees]
        idle = {
            n: sides[n]
            for n, tree in enumerate(trees)
            if n not in in_figures
            and n > min(in_figures - {0}, default=n)
            and (has_plain_angles(tree) or self._figures.has_sums_of_roots(tree))
        }
        worked = [
            sides[n] for n in in_figures if of_plain_angles(trees[n]) or (nested and n < len(links))
        ]
        angles = list(map(plain_angles, trees))
        joined = [
            sides[n]
            for n in range(2, len(trees))
            if self._figures.with_calculator and angles[n - 1] and angles[n] - angles[n - 1]
        ]
        # Squares that a calculator adds have other last figures than those that are printed.
        squares = {n for n in in_figures if n > 1 and is_function(trees[n], "sqrt")}
        joined += [sides[n] for n in squares - {len(links)}]
        signs = [
            "≈" if link.sign == "=" and in_figures & {n, n - 1} - {0} else sign_of(link)
            for n, link in enumerate(links, 1)
        ]
        signs[:1] = ["≈"] if 0 in in_figures else signs[:1]
        return Draft(line, links, trees, in_figures, sides, signs, idle, worked, joined)

    def _as_asked(self, draft: Draft, last: bool) -> None:
        """Sides that are written otherwise: zero vectors, what was typed, three figures."""
        line, links, trees, sides = draft.line, draft.links, draft.trees, draft.sides
        match trees:
            case [Binary("/", Quantity(), Quantity()), Binary("/", Number() as above, below), *_]:
                # A quotient of two numbers stands as it is before its decimal.
                sides[1] = lay.Fraction(*map(self._naming.layout, (above, below)))
        if is_vector(links[0].left):
            sides[:] = [
                lay.ZERO_VECTOR if is_zero(t) else s for t, s in zip(trees, sides, strict=True)
            ]
        typed = self._ends.typed(line, replace(links[0], sign=links[-1].sign)) if last else None
        if typed is not None and not is_vector(links[0].left):
            sides[-1] = typed
        for n, link in enumerate(links, 1):
            if link.sign == "≈":
                sides[n] = to_three_figures(trees[n]) or sides[n]

    def _with_quotients(self, draft: Draft) -> None:
        """Quotients as they stand before they are shortened, and the tangent that is left out."""
        line, links, trees = draft.line, draft.links, draft.trees
        sides, signs = draft.sides, draft.signs
        if (angle := tangent_left_out(self._derivation, line, links[0])) is not None:
            sides[:0], signs[:0] = [self._naming.layout(Apply("tan", angle))], ["="]
        match links[0].right:
            case Binary("/") | Negate(Binary("/")) if (
                line.move.record in BY_A_LENGTH and len(links) > 1
            ):
                sides[1] = unrationalised(self._naming, trees[1])
            case (Binary("/", above, below) | Negate(Binary("/", above, below))) as ratio if (
                line.move.record in TANGENTS
                and len(links) > 1
                and (has_root(below) or of_plain_angles(below))
                and 1 not in draft.in_figures
            ):
                # Components that are multiples of roots, or of ratios, are seen before they cancel.
                own = lay.fraction(*map(self._naming.layout, (above, below)))
                sides[1] = lay.negative(own) if isinstance(ratio, Negate) else own
        without_doubles(sides, signs)
        quotient, number = self._quotient(line, links[0]), isinstance(sides[1], lay.Number)
        if quotient is not None and number and not is_by_axis(self._derivation, line):
            alone = len(trees) == 2 and self._naming.in_fractions(trees[0])
            sides[1 : 1 + alone], signs[:alone] = [quotient], ["="]

    def _with_senses(self, draft: Draft) -> None:
        """Components in the sense in which a reader knows them."""
        links, sides = draft.links, draft.sides
        back = in_the_other_sense(self._derivation, self._naming, draft.line, links)
        if back is not None:
            sides[1:1], draft.signs[:0] = [self._naming.layout(back)], ["="]
        shown = [side for side in sides if id(side) not in map(id, draft.idle.values())]
        if self._ends.of(draft.line) is None and is_turned(self._naming, links, shown):
            sides[0] = away(self._naming, links[0].left)
            turned = {id(side): turned_value(self._naming, links, side) for side in sides[1:]}
            sides[1:] = [turned[id(side)] for side in sides[1:]]
            draft.idle = {n: turned.get(id(side), side) for n, side in draft.idle.items()}

    def _with_its_end(self, draft: Draft) -> None:
        """The end of a chain as an answer, without what nobody writes on the way to figures."""
        line, links, trees, idle = draft.line, draft.links, draft.trees, draft.idle
        sides, signs = draft.sides, draft.signs
        put = trees[-1] if len(links) in draft.in_figures else None
        exact = sides[-1]
        self._ended(line, links, sides, signs, put)
        decimals = sides[-1] != exact and has_decimals(sides[-1]) and "≈" not in signs
        if decimals and is_vector(trees[0]) and len(sides) == len(trees):
            # A vector of decimals has such above it as well: 1.2(3i + 4j).
            worked = map(self._decimals.in_decimals, trees[1:-1])
            sides[1:-1] = map(self._naming.layout, worked)
        self._placed(line, links, sides, signs)
        # Behind figures a value is not written once more exactly.
        for n in range(len(sides) - 1, 0, -1):
            if any(sides[n] is layout for layout in (*idle.values(), *draft.joined)):
                del sides[n], signs[n - 1]
        without_doubles(sides, signs)
        for n in idle:
            self._figures.stands_for(trees[n], trees[min(draft.in_figures - {0})])
        rounded = is_plain(sides[-2]) or is_multiple(sides[-2])
        rounded &= signs[-2:] == ["≈", "≈"] and not self._is_open(draft)
        rounded &= not self._goes_into_numbers(line, links[-1].right)
        if rounded or self._is_never_read(draft):
            del sides[-2]
            signs[-2:] = ["≈"]  # an answer has three figures at once
        shortest = 1000 if self._measures.decimals else _NEVER_READ
        if signs[-1] == "≈" and len(sides) > 3 and has_long_root(trees[-1], shortest):
            del sides[-2], signs[-2]
        if draft.in_figures and (ratio := self._ratio_in_figures(draft)) != trees[-1]:
            sides.append(self._naming.layout(ratio))
            signs.append("≈")
        self._in_figures_from_here(links, sides, signs)
        more = one_figure_more(self._derivation, self._ends, self._naming, self._figures, line)
        if more is not None:
            sides.insert(1, more)
            signs.insert(0, "≈")

    def _is_never_read(self, draft: Draft) -> bool:
        """Whether the side before the figures is an exact number with cosines that nobody needs.

        Components that are multiplied out, and roots below a line that has figures.
        """
        exact = draft.trees[-1]
        if draft.signs[-2:] != ["=", "≈"] or not of_plain_angles(exact):
            return False
        is_multiplied = is_vector(draft.links[0].left) and draft.line.move.id == "rearrange"
        return is_multiplied or (self._goes_on_in_figures(draft.line) and has_root(exact))

    def _in_figures_from_here(
        self, links: tuple[Link, ...], sides: Sequence[lay.Layout], signs: Sequence[str]
    ) -> None:
        """Notes the figures of a value that no row has exactly, with a calculator."""
        if not self._figures.with_calculator or signs[-1] != "≈" or has_quantity(links[-1].right):
            return
        exact = self._trees(links)[-1]
        if isinstance(links[0].left, Apply):
            return
        if self._naming.layout(exact) in sides:
            if self._figures.is_carried(exact) and not is_measure_of_angle(exact):
                self._figures.note(exact)
            return
        figures = self._figures.outcome(exact)
        if figures != exact:
            self._figures.stands_for(exact, figures)

    def _ratio_in_figures(self, draft: Draft) -> Expression:
        """The figures of a tangent, or of a cosine by a scalar product; else the last side."""
        line, exact, put = draft.line, draft.links[-1].right, draft.trees[-1]
        if line.move.record != "scalar-angle":
            return self._tangent(line, exact, put)
        alone = self._figures.with_calculator and of_plain_angles(exact)
        return self._figures.cosine(exact) if alone and not is_figures(put) else put

    def _is_open(self, draft: Draft) -> bool:
        """Whether the side before the last is still to be worked out, so that it is printed."""
        before = draft.sides[-2]
        if self._figures.with_calculator:
            return not (is_multiple(before) or is_vector(draft.links[0].left))
        return before in draft.worked

    def _quotient(self, line: Line, link: Link) -> lay.Layout | None:
        """The quotient of two numbers, a decimal next: of components, or of a flight."""
        flight = line.move.record == "straight-line" and is_time(link.left)
        match link.right:
            case Binary("/", above, below) if flight or line.move.record in TANGENTS:
                sides = [self._naming.layout(tree) for tree in (above, below)]
                if all(isinstance(side, lay.Number) for side in sides):
                    return lay.Fraction(*sides)
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
                is_quantity(link.left, "position") and has_unit_vector(link.right)
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
            awkward = (has_plain_angles(x) or self._figures.is_of_roots(x) for x in point)
            if self._figures.with_calculator and any(awkward):
                del shown[:-1]
        if [sign for _, sign in shown[1:]] == ["="]:
            # Nobody writes a place twice.
            kept = decimals or self._decimals.keeps_fractions(link.right)
            shown = shown[:1] if kept else shown[1:]
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
        put: Expression | None = None,
    ) -> None:
        """Puts what belongs to a value at the end of a row: its name, its unit, a decimal.

        ``put`` is the last side with figures, where it has some.
        """
        left, right = links[0].left, links[-1].right
        end = self._ends.of(line)
        worth = not has_quantity(right) and (is_value(left) or end is not None)
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
                vector = sign == "=" and is_vector(left)
                if side != sides[-1] and (vector or not (sign == "=" and has_decimals(sides[-1]))):
                    if sign == "≈" and self._figures.with_calculator and of_plain_angles(right):
                        four = to_figures(right, self._figures.count(right))
                        if not is_rounded_to(four, side):  # where the value stands above, too
                            four = to_figures(right, self._figures.one_more(right))
                        goes_on = self._goes_into_numbers(line, right)
                        if goes_on and four is not None and four not in (side, sides[-1]):
                            sides.append(four)
                            signs.append(sign)
                    if vector and not self._decimals.keeps_fractions(right):
                        sides[-1] = side  # nobody writes a vector twice
                    if vector:
                        continue
                    sides.append(side)
                    signs.append(sign)
        in_letters = self._figures.in_letters(right) if end is None and not unit else None
        if in_letters is not None and links[-1].sign == "=" and is_value(left):
            printed = as_printed(self._naming, right, sides[-1]) or right
            if put is not None and sides[-1] != self._naming.layout(put) and printed == right:
                printed = (
                    negative(right) if turned_side(self._naming.layout(put)) == sides[-1] else right
                )
            self._figures.note(right)
            multiple = self._naming.layout(self._figures.in_letters(printed) or in_letters)
            if multiple != sides[-1]:
                sides.append(multiple)
                signs.append("≈")
        elif (
            end is None
            and (unit or self._figures.is_of_roots(right))
            and links[-1].sign == "="
            and (of_plain_angles(right) or self._is_carried(line, links[-1]))
        ):
            tree = as_printed(self._naming, right, sides[-1])
            if put is not None and not (has_quantity(put) or letters(put)):
                tree = right if sides[-1] == self._naming.layout(put) else negative(right)
            carried = self._figures.count(right)
            figures = None if tree is None else to_figures(tree, carried)
            if figures is not None:
                self._figures.note(right)
                if figures != sides[-1]:
                    sides.append(figures)
                    signs.append("≈")
        elif end is None and is_sum_with_inverse(right) and self._is_figures_at_once(line):
            degrees = degrees_of(right)
            if degrees is not None:
                sides.append(self._naming.layout(degrees))
                signs.append("≈")
        answered = end is not None and not has_quantity(right)
        if unit and (answered or is_plain(sides[-1])) and sides[-1] not in _NOTHING:
            sides[-1] = with_unit(sides[-1], unit)

    def _bounded(self, trees: Sequence[Expression], sides: list[lay.Layout]) -> None:
        """Puts the unit of what a range is of behind the numbers that bound it."""
        subject = [tree for tree in trees if has_quantity(tree) or isinstance(tree, Letter)]
        unit = self._measures.unit(subject[0]) if len(subject) == 1 else ""
        for n, tree in enumerate(trees):
            if unit and tree not in subject and not is_zero(tree):
                sides[n] = with_unit(sides[n], unit)
