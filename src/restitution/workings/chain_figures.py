"""Figures in the place of values in a chain, where a reader has a calculator, or roots of sums."""

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
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Number,
    Rounded,
    has_quantity,
    letters,
    unsigned,
)
from restitution.render.text import to_text
from restitution.workings.chain_sides import (
    is_made_of_figures,
    is_rounded_below,
    is_value,
)
from restitution.workings.fuller_figures import goes_into_numbers
from restitution.workings.naming.ends import Ends
from restitution.workings.naming.figure_multiples import beside_figures
from restitution.workings.naming.figures import Figures
from restitution.workings.naming.long_numbers import has_long_numbers, keeps_short_sums
from restitution.workings.naming.measured import (
    Measures,
)
from restitution.workings.naming.plain_angles import (
    has_plain_angles,
    is_with_calculator,
    of_plain_angles,
)
from restitution.workings.naming.printed_decimals import PrintedDecimals
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.roots_of_roots import has_long_root
from restitution.workings.naming.solved_figures import leads_elsewhere
from restitution.workings.naming.sources import is_vector
from restitution.workings.naming.sums_in_degrees import (
    angles_in_figures,
    bound_in_figures,
    is_figures,
    is_sum_of_inverses_of_roots,
    is_sum_with_inverse,
)

# The root of an equation is told exactly, and so are answers of at most so many signs.
_EXACTLY = frozenset({"roots", "reject"})
_LONGEST_ANSWER = 40
TANGENTS = frozenset({"tan", "tan-direction"})
# Lines that only work something out: with a calculator their sums of numbers are figures at once.
_WORKED_OUT = frozenset({"rearrange", "solve", "combine", "put", "roots", "reject"})
# Lines that go on from the one above: where that has figures, their values have some.
_GOES_ON_IN_FIGURES = _WORKED_OUT | {"identity", "cancel"}
# What is divided by the length of a direction: a reader sees its root below the line.
BY_A_LENGTH = frozenset({"scalar-angle", "component"})


class ChainsInFigures:
    """The chains of one derivation, with figures for values that are on paper with them."""

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
        # Some come to an exact number, and vectors to that of the line below.
        number = last if len(links) > 1 else self._outcome_below(line, links[0])
        plain = number is not None and not (
            has_quantity(number)
            or letters(number)
            or of_plain_angles(number)
            or self._figures.has_sums_of_roots(number)
        )
        known = calculated and len(links) > 1 and self._figures.has_known(trees[1])
        plain = plain and not known
        plain = plain or (not calculated and self._stays_exact(line, last))
        elsewhere = calculated and self._leads_elsewhere(line, last)
        if elsewhere and (more := self._figures.rounded_alike(last)) is not None:
            trees[1:] = [more] * len(links)
        plain = plain or elsewhere
        ratio = isinstance(links[0].left, Apply) and line.move.id != "define"
        worked = calculated and (ratio or self._only_works_out(line))
        if line.move.id == "put" and (
            self._figures.has_known(trees[1]) or (len(links) > 1 and self._is_of_a_result(line))
        ):
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
        if calculated and not plain and line.move.record not in BY_A_LENGTH:
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
        if calculated and line.move.record in TANGENTS and isinstance(trees[-1], Rounded):
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
        if not put and self._puts_in_figures(line, last):
            trees[-1] = self._figures.outcome(last)
            self._figures.stands_for(last, trees[-1])
            return frozenset({len(trees) - 1})
        return put

    def _outcome_below(self, line: Line, link: Link) -> Expression | None:
        """What a vector comes to in a line that only works it out; None of another."""
        for own in self._derivation.lines if is_vector(link.left) else ():
            if own.move.id == "rearrange" and own.premises == (line.number,):
                match own.relation:
                    case Relation(((Link(link.left), *_) as worked,)):
                        return worked[-1].right
        return None

    def _puts_in_figures(self, line: Line, value: Expression) -> bool:
        """Whether a number comes of what another part has in figures: it is one itself then."""
        if line.move.id != "put" or not of_plain_angles(value):
            return False
        part = self._ends.part(line)
        for ref in numbers_in(line.premises):
            own = self._derivation.line(ref)
            relation = None if own is None else own.relation
            if own is None or not isinstance(relation, Relation) or self._ends.part(own) == part:
                continue
            given = Link(relation.only[0].left, "=", relation.only[-1].right)
            if isinstance(given.left, Letter) and self.in_figures(given).sign == "≈":
                return True
        return False

    def _is_of_a_result(self, line: Line) -> bool:
        """Whether values are put into what was to be shown."""
        shown = {end.line for end in self._derivation.items if end.shown}
        return bool(shown & set(numbers_in(line.premises)))

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
        if line.move.record not in TANGENTS or not self._figures.with_calculator or number:
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
