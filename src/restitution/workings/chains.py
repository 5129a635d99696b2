"""A chain as one row of a working: its sides, the signs between them, and its end."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

from restitution.explaining.data.restated import axis_restated
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Relation,
    numbers_in,
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
    Rounded,
    has_quantity,
    has_root,
    has_unit_vector,
    is_function,
    is_quantity,
    is_zero,
    letters,
    unsigned,
)
from restitution.planning.writing.forms import coordinates, negative
from restitution.problem import Value
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.workings.chain_sides import (
    Draft,
    as_printed,
    is_by_axis,
    is_made_of_figures,
    is_multiple,
    is_rounded_below,
    is_value,
    sign_of,
    tangent_left_out,
    unrationalised,
)
from restitution.workings.fuller_figures import goes_into_numbers, one_figure_more
from restitution.workings.leads.senses import direction_by_its_sense
from restitution.workings.naming.bold_letters import unit_vector
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.figure_multiples import beside_figures
from restitution.workings.naming.figures import (
    Figures,
    has_plain_angles,
    is_with_calculator,
    of_plain_angles,
    plain_angles,
)
from restitution.workings.naming.long_numbers import has_long_numbers, keeps_short_sums
from restitution.workings.naming.measured import (
    Measures,
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
from restitution.workings.naming.printed_decimals import PrintedDecimals
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.roots_of_roots import has_long_root
from restitution.workings.naming.row_sides import (
    has_decimals,
    is_vector_of_short_decimals,
    turned_side,
    without_doubles,
)
from restitution.workings.naming.scaled_equations import in_decimals_as_above
from restitution.workings.naming.senses_at_walls import away, is_turned, turned_value
from restitution.workings.naming.solved_figures import leads_elsewhere
from restitution.workings.naming.sources import is_time, is_vector
from restitution.workings.naming.sums_in_degrees import (
    angles_in_figures,
    bound_in_figures,
    degrees_of,
    is_figures,
    is_sum_of_inverses_of_roots,
    is_sum_with_inverse,
)
from restitution.workings.naming.values_of_letters import in_the_other_sense, with_values
from restitution.workings.rendering.steps import Row

# The root of an equation is told exactly, and so are answers of at most so many signs.
_EXACTLY = frozenset({"roots", "reject"})
_LONGEST_ANSWER = 40
# No number from here on stands under a root; where data are decimals, none of four figures.
_NEVER_READ = 10000
_TANGENTS = frozenset({"tan", "tan-direction"})
# Lines that only work something out: with a calculator their sums of numbers are figures at once.
_WORKED_OUT = frozenset({"rearrange", "solve", "combine", "put", "roots", "reject"})
# Lines that go on from the one above: where that has figures, their values have some.
_GOES_ON_IN_FIGURES = _WORKED_OUT | {"identity", "cancel"}
# What is divided by the length of a direction: a reader sees its root below the line.
_BY_A_LENGTH = frozenset({"scalar-angle", "component"})
WORDS = {"parallel to": "claim.parallel", "perpendicular to": "claim.perpendicular"}


class Chains:
    """The rows of one derivation that are chains."""

    def __init__(
        self,
        derivation: Derivation,
        naming: Naming,
        measures: Measures,
        ends: Ends,
        finer: Mapping[str, int] | None = None,
    ) -> None:
        self._derivation = derivation
        self._naming = naming
        self._measures = measures
        self._ends = ends
        self._long_numbers = measures.decimals and has_long_numbers(derivation)
        calculator = self._long_numbers or is_with_calculator(derivation)
        short = keeps_short_sums(derivation)
        self._figures = Figures(calculator, measures.decimals, finer, self._long_numbers, short)
        self._decimals = PrintedDecimals(derivation, measures.decimals)
        # Lines with figures in place of values: their first two sides, by the number.
        self._with_figures: dict[int, tuple[Expression, Expression]] = {}
        # The left sides of lines with figures in place of roots of sums of roots.
        self._in_figures_above: set[Expression] = set()
        # The left side of the row above, and the item to which it belongs.
        self._left: tuple[Expression, str | None] | None = None
        self._single = True

    @property
    def finer(self) -> Mapping[str, int]:
        """How many figures values have where four lead to others below, by their digits."""
        return self._figures.wanted

    def instead_of(self, tree: Expression) -> Expression:
        """The figures of a value that is on paper with them; any other as it is."""
        return self._figures.instead_of(tree)

    def by_calculator(self, link: Link) -> Expression:
        """The right side of an equation in figures, with a calculator; they stand for it then."""
        if not self._figures.with_calculator or link.sign != "=" or has_quantity(link.right):
            return link.right
        put = self._figures.again(link.right, outcome=True, behind=True)
        if put != link.right and not isinstance(link.right, Apply):
            self._figures.note(link.right)
        return put

    def in_figures(self, link: Link) -> Link:
        """An equation whose right side has figures, with a calculator."""
        put = self.by_calculator(link)
        return link if put == link.right else replace(link, sign="≈", right=put)

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
            self._decimals.note(links[-1], *own)
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

    def _trees(self, links: tuple[Link, ...]) -> list[Expression]:
        """The sides of a chain, as decimals where the data are decimals."""
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
        return self._decimals.put(trees, measured=bool(self._measures.unit(links[0].left)))

    def _draft(self, line: Line, links: tuple[Link, ...]) -> Draft:
        """The sides as they are set by themselves, with figures for values that are on paper."""
        trees = self._trees(links)
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
                line.move.record in _BY_A_LENGTH and len(links) > 1
            ):
                sides[1] = unrationalised(self._naming, trees[1])
            case (Binary("/", above, below) | Negate(Binary("/", above, below))) as ratio if (
                line.move.record in _TANGENTS
                and len(links) > 1
                and has_root(below)
                and 1 not in draft.in_figures
            ):
                # Components that are multiples of roots stand as they are before they cancel.
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

    def _goes_into_numbers(self, line: Line, value: Expression) -> bool:
        """Whether lines below have the four figures of an answer."""
        return self._figures.with_calculator and goes_into_numbers(
            self._derivation, self._ends, line, value
        )

    def _in_figures(
        self, line: Line, links: tuple[Link, ...], trees: list[Expression]
    ) -> frozenset[int]:
        """Puts figures for values that are on paper; the numbers of the sides that have them."""
        exact = list(trees)
        last, calculated = trees[-1], self._figures.with_calculator
        # Some come to an exact number.
        plain = len(links) > 1 and not (
            has_quantity(last)
            or letters(last)
            or of_plain_angles(last)
            or self._figures.has_sums_of_roots(last)
        )
        plain = plain and not (calculated and self._figures.has_known(trees[1]))
        plain = plain or (not calculated and self._stays_exact(line, last))
        elsewhere = calculated and self._leads_elsewhere(line, last)
        if elsewhere and (more := self._figures.rounded_alike(last)) is not None:
            trees[1:] = [more] * len(links)
        plain = plain or elsewhere
        ratio = isinstance(links[0].left, Apply) and line.move.id != "define"
        worked = calculated and (ratio or self._only_works_out(line))
        if line.move.id == "put" and self._figures.has_known(trees[1]):
            worked = False  # what is put in is shown first
        if (
            not plain
            and (calculated or self._figures.has_sums_of_roots(trees[0]))
            and links[0].sign == "="
        ):
            whole = self._figures.sum_in_letters(trees[0]) if worked else None
            within = self._figures.within(trees[0]) if line.move.id == "put" else trees[0]
            own = self._figures.put(trees[0], worked) if within == trees[0] else within
            trees[0] = whole or own
        for n, link in enumerate(() if plain else links, 1):
            if link.sign in ("=", "≈"):
                trees[n] = self._side_in_figures(line, trees, n, worked)
            elif calculated:
                trees[n] = bound_in_figures(trees[n])
        if calculated and not plain and line.move.record not in _BY_A_LENGTH:
            solved = line.move.id in _GOES_ON_IN_FIGURES - {"put"}
            trees[:] = beside_figures(exact, trees, solved)
        if line.move.record == "scalar-angle" and len(links) > 1:
            behind = calculated and trees[1] != exact[1] and has_plain_angles(trees[-1])
            if behind or has_long_root(trees[-1]):
                # Nobody multiplies two roots to have one of such a number, or cosines of figures.
                trees[-1] = self._figures.cosine(exact[-1] if behind else trees[-1])
            elif trees[-1] != exact[-1] and is_made_of_figures(trees[-1]):
                trees[-1] = self._figures.cosine(exact[-1])  # one number: no quotient of figures
        if not plain and self._goes_on_in_figures(line):
            own = trees[-1] if letters(exact[-1]) else exact[-1]
            outcome = self._figures.outcome(own)
            trees[-1] = trees[-1] if outcome == own else outcome
            if trees[-1] != exact[-1]:
                self._figures.stands_for(exact[-1], trees[-1])
        if calculated and is_vector(trees[0]) and self._ends.of(line) is not None:
            self._figures.note_components(exact[-1])
        if calculated and line.move.record in _TANGENTS and isinstance(trees[-1], Rounded):
            trees[-1] = self._figures.tangent(exact[-1]) or trees[-1]
        put = frozenset(n for n, tree in enumerate(trees) if tree != exact[n])
        if put:
            self._with_figures[line.number] = trees[0], trees[1]
        tangent = self._tangent(line, exact[-1], trees[-1]) if put else trees[-1]
        if isinstance(links[0].left, Apply) and tangent != exact[-1]:
            self._figures.stands_for(exact[-1], tangent)  # of the angle itself, next
        first = min(put - {0}, default=0)
        if first and is_value(exact[0]) and is_made_of_figures(trees[first]):
            # Where its square is taken, say, it stands as it does here.
            self._figures.stands_for(exact[-1], trees[first])
        if put and any(map(self._figures.has_sums_of_roots, exact)):
            self._in_figures_above.add(exact[0])
        return put

    def _only_works_out(self, line: Line) -> bool:
        """Whether a line makes a value of what stands, or says a coordinate as a distance."""
        return line.move.id in _WORKED_OUT or axis_restated(self._derivation, line) is not None

    def _goes_on_in_figures(self, line: Line) -> bool:
        """Whether a line only works out what figures stand for above, with a calculator."""
        cited = self._with_figures.keys() & set(numbers_in(line.premises))
        return self._figures.with_calculator and line.move.id in _GOES_ON_IN_FIGURES and bool(cited)

    def _leads_elsewhere(self, line: Line, value: Expression) -> bool:
        """Whether the figures of the equation above lead to others than those of an answer."""
        assert isinstance(line.relation, Relation)
        left = line.relation.only[0].left
        cited = [n for n in numbers_in(line.premises) if n in self._with_figures]
        if self._ends.of(line) is None or len(cited) != 1 or not isinstance(left, Letter):
            return False
        equation = self._with_figures[cited[0]]
        solved = line.move.id in _GOES_ON_IN_FIGURES and any(
            left.name in letters(e) for e in equation
        )
        return solved and leads_elsewhere(*equation, left, value)

    def _tangent(self, line: Line, exact: Expression, put: Expression) -> Expression:
        """What stands at the end of the line of a tangent: its figures, with a calculator."""
        number = isinstance(unsigned(put), Number)
        if line.move.record not in _TANGENTS or not self._figures.with_calculator or number:
            return put
        return self._figures.tangent(exact) or put

    def _side_in_figures(
        self, line: Line, trees: Sequence[Expression], n: int, worked: bool
    ) -> Expression:
        """A side of a chain with figures; ``worked`` where the line only works something out."""
        tree, calculated = trees[n], self._figures.with_calculator
        if calculated and n > 1 and is_figures(trees[n - 1]):
            return trees[n - 1]  # it is the same number
        if calculated and n > 1 and is_rounded_below(trees, n):
            return self._figures.outcome(tree)
        if calculated and (n > 1 or line.move.id in _WORKED_OUT):
            sum_ = self._figures.sum_in_letters(tree)
            if sum_ is not None:
                return sum_
        if is_sum_of_inverses_of_roots(trees[-1]) and not self._goes_into_others(line):
            return angles_in_figures(tree) if is_sum_with_inverse(tree) else tree
        outcome = n == len(trees) - 1 > 1 and not isinstance(tree, Apply)
        if calculated and line.move.record == "scalar-angle":
            outcome = False  # a cosine needs more figures than its angle
        elif calculated:
            outcome = outcome or worked or n > 1
        if is_vector(trees[0]) and self._ends.of(line) is None:
            tree = self._figures.vector(tree)
        put = self._figures.again if worked else self._figures.put
        side = put(tree, outcome, behind=n > 1)
        if n == 1 and calculated and line.move.id == "define" and self._is_worked_out_here(trees):
            return tree if isinstance(unsigned(side), Number) else side
        within = self._figures.within(tree) if n == 1 < len(trees) - 1 and not worked else tree
        return side if within == tree else within

    def _is_worked_out_here(self, trees: Sequence[Expression]) -> bool:
        """Whether the first of several values is a sum of roots that is new on paper."""
        first = trees[1]
        new = self._figures.is_of_roots(first) and not self._figures.has_known(first)
        return len(trees) > 2 and new

    def _goes_into_others(self, line: Line) -> bool:
        """Whether a line below goes on from it, and does more than to say its value."""
        below = (own for own in self._derivation.lines if line.number in own.premises)
        return any(own.move.id != "value" for own in below)

    def _stays_exact(self, line: Line, last: Expression) -> bool:
        """Whether a value with roots of sums of roots stays exact: a root, a short answer."""
        if not self._figures.has_sums_of_roots(last):
            return False
        if line.move.id in _EXACTLY:
            return True
        answer = self._ends.of(line) is not None and not isinstance(last, Apply)
        if line.relation.trees[0] in self._in_figures_above:
            return False
        return answer and len(to_text(self._naming.layout(last))) <= _LONGEST_ANSWER

    def _quotient(self, line: Line, link: Link) -> lay.Layout | None:
        """The quotient of two numbers, a decimal next: of components, or of a flight."""
        flight = line.move.record == "straight-line" and is_time(link.left)
        match link.right:
            case Binary("/", above, below) if flight or line.move.record in _TANGENTS:
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
                    if sign == "≈" and self._goes_into_numbers(line, right):
                        four = to_figures(right, self._figures.count(right))
                        if not is_rounded_to(four, side):
                            four = to_figures(right, self._figures.one_more(right))
                        if four is not None and four not in (side, sides[-1]):
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
        nothing = sides[-1] in (lay.Number("0"), lay.ZERO_VECTOR)
        answered = end is not None and not has_quantity(right)
        if unit and not nothing and (answered or is_plain(sides[-1])):
            sides[-1] = with_unit(sides[-1], unit)

    def _is_figures_at_once(self, line: Line) -> bool:
        """Whether an angle has its figures in its own line, and no other line has them."""
        return self._figures.with_calculator and not any(
            own.move.id == "value" and line.number in own.premises for own in self._derivation.lines
        )

    def _is_carried(self, line: Line, link: Link) -> bool:
        """Whether a value with roots of sums of roots is used from here, and told no plainer."""
        return self._figures.is_of_roots(link.right) and not any(
            own.number > line.number
            and isinstance(own.relation, Relation)
            and own.relation.options[0][0].left == link.left
            for own in self._derivation.lines
        )

    def _bounded(self, trees: Sequence[Expression], sides: list[lay.Layout]) -> None:
        """Puts the unit of what a range is of behind the numbers that bound it."""
        subject = [tree for tree in trees if has_quantity(tree) or isinstance(tree, Letter)]
        unit = self._measures.unit(subject[0]) if len(subject) == 1 else ""
        for n, tree in enumerate(trees):
            if unit and tree not in subject and not is_zero(tree):
                sides[n] = with_unit(sides[n], unit)
