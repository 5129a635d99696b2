"""Inequalities without the letters that others tie: by ratios, or by the ends of a range."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

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
    turned,
)
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    has_quantity,
    is_function,
    is_zero,
    letters,
)
from restitution.planning.inequalities.claims_in_stages import InStages
from restitution.planning.inequalities.gaps import write_difference
from restitution.planning.inequalities.letter_ties import is_letter_or_square
from restitution.planning.inequalities.letters_between import write_beyond_a_coefficient
from restitution.planning.inequalities.standard_conditions import as_quadratic, in_factors
from restitution.planning.inequalities.turned_at_walls import tangent_of
from restitution.planning.routes.order import Standing
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import ZERO, square, tree_of
from restitution.planning.writing.inequalities import is_monic, same, solve_linear, subject_of
from restitution.planning.writing.one_tangent import in_one_tangent, write_in_one_tangent
from restitution.planning.writing.polynomials import expanded, factored, one_fraction
from restitution.solving.story.letters import roles


class Eliminated(InStages):
    """Claims from which letters that are tied to others are eliminated."""

    def _attempts(
        self, target: set[str], relation: Relation
    ) -> Iterator[Callable[[list[Ref], Relation], int | None]]:
        wanted = subject_of(relation)

        def by_conditions(base: list[Ref], relation: Relation) -> int | None:
            lines = [ref for ref in base if isinstance(ref, int)]
            for bounds in (self._ranges(lines), self.conditions.lines(wanted)):
                line = self.monotone(lines[0], relation, bounds) if len(lines) == 1 else None
                if line is not None and bounds:
                    return line
            own = [*base, *self.conditions.lines(wanted)]
            beyond = write_beyond_a_coefficient(self, own, relation)
            return beyond or self.compared(own, relation, base)

        def by_what_is_shown(base: list[Ref], relation: Relation) -> int | None:
            shown = [self.ties.shown_by(equation.fact.id) for equation in self.scene.given]
            ends = {end.line for end in self.scene.desk.ends if end.shown}
            shown += [line for line in self.conditions.lines(wanted) if line in ends]
            for line in dict.fromkeys(line for line in shown if line is not None):
                if isinstance(self.scene.desk.last_link(line).left, Letter):
                    continue
                mark = self.worths.mark()
                first = self._without_quotients(relation)
                if first is not None and not self._is_factor_in(line, first.only[0].left):
                    first = None
                above = None if first is None else self.compared([line], first)
                if above is not None:
                    written = self.judge.write((Move("rearrange"),), [above], relation)
                    if written is not None:
                        return written
                self.worths.back(mark)
            return None

        def by_an_answer(base: list[Ref], relation: Relation) -> int | None:
            for line in filter(None, map(self._answered_by, self.ties.lines())):
                written = self._eliminated(line, [], relation, target)
                if written is not None:
                    return written
            return None

        def by_ties(base: list[Ref], relation: Relation) -> int | None:
            for line in self.ties.lines():
                written = self.monotone(line, relation)
                if written is not None:
                    return written
            for line in self.ties.lines():
                written = self._by_squares_of_ends(line, relation)
                if written is not None:
                    return written
            for line in self.ties.lines():
                if self._divides_by_an_end(line, relation):
                    written = self._by_both_ends(line, relation)
                    if written is not None:
                        return written
            for line in self.ties.lines():
                written = self._eliminated(line, base, relation, target)
                if written is not None:
                    return written
            for line in self.ties.lines():
                written = self._by_both_ends(line, relation)
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

        def by_its_tangent(base: list[Ref], relation: Relation) -> int | None:
            bounds = _of_the_tangent(relation)
            if bounds is None:
                return None
            try:
                line = self.write(bounds)
            except NotPlannedError:
                return None
            return self.compared([line, *self.judge.known(target)], relation)

        yield by_what_is_shown
        yield by_an_answer
        yield by_conditions
        yield by_ratios
        yield by_ties
        yield by_all
        yield by_story
        yield by_its_tangent

    def write(self, relation: Relation) -> int:
        """Writes the lines of an inequality that holds; the last says it."""
        raise NotImplementedError

    def _answered_by(self, ref: int) -> int | None:
        """An answer for a coefficient that is another form of a line: what follows begins there."""
        desk, known = self.scene.desk, roles(self.scene.problem)
        source = desk.line(ref)
        same = [(ref,), source.premises] if source.move.id == "rearrange" else [(ref,)]
        for end in desk.ends:
            own = desk.line(end.line)
            match own.relation:
                case Relation(((Link(Letter(name), "="),),)) if name in known:
                    plain = own.move.id == "rearrange" and own.premises in same
                    if plain and known[name].kind == "restitution":
                        return end.line
        return None

    def _is_factor_in(self, line: int, difference: Expression) -> bool:
        """Whether a difference is a factor of a side of an equation, above or below: seen there."""
        own = self.worths.value(difference)
        link = self.scene.desk.last_link(line)
        sides = (self.worths.value(side) for side in (link.left, link.right))
        parts = (part for side in sides for part in sp.fraction(factored(one_fraction(side))))
        factors = (x.as_base_exp()[0] for part in parts for x in sp.Mul.make_args(part))
        return any(tidy(x / own).is_number for x in factors)

    def _without_quotients(self, relation: Relation) -> Relation | None:
        """``2e - 1 > 0`` of e > 1/2; None of a relation that is no bound by a number."""
        match relation.options:
            case ((Link(Letter() as letter, sign, right),),) if not letters(right):
                pass
            case _:
                return None
        bound = self.worths.value(right)
        if sign not in FLIPPED or not bound.is_Rational:
            return None
        difference = self.worths.value(letter) * bound.q - bound.p
        return Relation(((Link(tree_of(difference), sign, ZERO),),))

    def _eliminated(
        self, line: int, base: Sequence[Ref], relation: Relation, target: set[str]
    ) -> int | None:
        """By the range of a letter in an equation that is not in the claim."""
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
                    number_ = self._solved(number_, solved, known)
                if same(scene.desk.relation(number_), relation):
                    return number_
                if solved is None and len(x.free_symbols) == 1:
                    number_ = as_quadratic(self.worths, number_, sign, x, wanted, known)
                if not base:
                    line_ = self.compared([number_], relation)
                    if line_ is not None:
                        return line_
                written.append(number_)
        if not written:
            return None
        for ref in base:
            line_ = self.monotone(ref, relation, written) if isinstance(ref, int) else None
            if line_ is not None:
                return line_
        line_ = self.compared([*base, *written], relation)
        if line_ is None and self.conditions.lines(wanted):
            line_ = self.compared([*base, *written, *self.conditions.lines(wanted)], relation)
        return line_

    def _solved(self, line: int, solved: Link, known: Sequence[Ref]) -> int:
        """A bound solved for a letter, by the product that it is where it has several factors."""
        moves = (Move("rearrange"), Move("cancel"), Move("compare"))
        mark = self.worths.mark()
        between = in_factors(self.worths, line, known)
        after = self.judge.write(moves, [between, *known], Relation(((solved,),)))
        if after is None and between != line:
            self.worths.back(mark)
            after = self.judge.write(moves, [line, *known], Relation(((solved,),)))
        return line if after is None else after

    def _by_difference(self, line: int, link: Link) -> int | None:
        """A bound of a quotient of polynomials in which a letter stands above and below."""
        right = self.scene.desk.last_link(line).right
        value = self.worths.value(right)
        by_tangent = in_one_tangent(value)
        plain = value if by_tangent is None else by_tangent
        plain = plain.xreplace({tangent: sp.Dummy() for tangent in plain.atoms(sp.tan)})
        if is_zero(link.right) or not plain.is_rational_function(*plain.free_symbols):
            return None
        above, below = sp.fraction(one_fraction(plain))
        if not above.free_symbols & below.free_symbols:
            return None
        return write_difference(self, line, Relation(((link,),)))

    def _by_difference_of_squares_from(self, line: int, link: Link) -> int | None:
        """A bound of a letter of which a line gives the square, by the difference of squares."""
        other = tree_of(expanded(self.worths.value(link.right) ** 2))
        squares = Relation(((Link(square(link.left), link.sign, other),),))
        mark = self.worths.mark()
        bound = write_difference(self, line, squares)
        end = None if bound is None else self.compared([bound], Relation(((link,),)))
        if end is None:
            self.worths.back(mark)
        return end

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
        equation = equality(tangent, tree_of(value))
        number = self.judge.standing(equation)
        if number is None and line is not None:
            number = self.judge.write((Move("triangle"), Move("put")), refs, equation)
        return self.compared([*(refs if number is None else [number])], relation)

    def _by_both_ends(self, line: int, relation: Relation) -> int | None:
        """One end after the other, by an equation and the range of a letter in it."""
        if not _bounds(relation):
            return None
        mark = self.worths.mark()
        written: list[int] = []
        whole = line
        alone = sum(map(self._is_open, relation.only)) == 1
        for link in relation.only:
            if not is_zero(link.left) and not is_zero(link.right):
                line = write_in_one_tangent(self.scene, whole) or whole
            sides = self.scene.desk.last_link(line)
            stands = sides.left in (link.left, square(link.left))
            own = turned(link) if isinstance(link.right, Letter) and not stands else link
            if self.judge.proves(self.judge.known(letters(own.left)), Relation(((own,),))):
                continue
            names = letters(sides.left) | letters(sides.right)
            pool = [line, *self.judge.known(names & set(roles(self.scene.problem)))]
            end = self._by_difference(line, own) if own.left == sides.left else None
            if end is None and square(own.left) == sides.left:
                end = self._by_difference_of_squares_from(line, own)
            if end is None and alone:
                end = self._by_its_tangent_from(line, own)
            if end is None:
                end = self.judge.write((Move("sign"),), pool, Relation(((own,),)))
            if end is None:
                self.worths.back(mark)
                return None
            written.append(end)
        return self._joined(written, relation, mark)

    def _divides_by_an_end(self, line: int, relation: Relation) -> bool:
        """Whether a letter that is to be shown not to be zero is divided by in a line."""
        right = self.scene.desk.last_link(line).right
        if has_quantity(right):
            return False
        below = sp.fraction(one_fraction(sp.sympify(self.scene.scalar(right), strict=True)))[1]
        factors = (part.as_base_exp()[0] for part in sp.Mul.make_args(factored(below)))
        names = {part.name for part in factors if part.is_Symbol}
        return any(
            link.sign == "<"
            and is_zero(link.left)
            and isinstance(link.right, Letter)
            and link.right.name in names
            for link in relation.only
        )

    def _is_open(self, link: Link) -> bool:
        """Whether an end of a range does not hold by the range of its letter alone."""
        names = self.judge.known(letters(link.left) | letters(link.right))
        return not self.judge.proves(names, Relation(((link,),)))

    def _by_its_tangent_from(self, line: int, link: Link) -> int | None:
        """A bound of an angle of which a line gives the tangent or its square, by that of these."""
        if has_quantity(link.right):
            return None
        tangent = Apply("tan", link.left)
        left = self.scene.desk.last_link(line).left
        bound = tangent_of(self.worths.value(link.right))
        if left not in (tangent, square(tangent)) or bound is None or bound.has(sp.tan):
            return None
        power = 1 if left == tangent else 2
        mark = self.worths.mark()
        own = self.monotone(line, Relation(((Link(left, link.sign, tree_of(bound**power)),),)))
        names = self.judge.known(letters(link.left))
        end = None if own is None else self.compared([own, *names], Relation(((link,),)))
        if end is None:
            self.worths.back(mark)
        return end

    def _by_squares_of_ends(self, line: int, relation: Relation) -> int | None:
        """Both ends of a letter of which a line gives the square, each in letters."""
        if not _bounds(relation):
            return None
        given = self.scene.desk.last_link(line).left
        ends = [link if square(link.left) == given else turned(link) for link in relation.only]
        if any(square(end.left) != given or not letters(end.right) for end in ends):
            return None
        mark = self.worths.mark()
        written: list[int] = []
        for own in ends:
            if self.judge.proves(self.judge.known(letters(own.left)), Relation(((own,),))):
                continue
            end = self._by_difference_of_squares_from(line, own)
            if end is None:
                self.worths.back(mark)
                return None
            written.append(end)
        return self._joined(written, relation, mark)

    def _joined(self, ends: Sequence[int], relation: Relation, standing: Standing) -> int | None:
        """The line of a relation by its ends; where there is none, what was written goes."""
        last = self.compared(ends, relation) if ends else None
        if last is None:
            self.worths.back(standing)
        return last


def _is_subject(tree: Expression) -> bool:
    """Whether a side is a letter, a ratio of an angle, or a power of one of them."""
    return not isinstance(tree, Binary) or tree.op == "^"


def _near(sign: Sign) -> tuple[str, ...]:
    """How premises about that end of a range are written."""
    return ("acute", "°", f" {sign[0]}")


def _of_the_tangent(relation: Relation) -> Relation | None:
    """Bounds of a letter for an acute angle by inverse tangents, as those of its tangent.

    None of other bounds.
    """
    if len(relation.options) != 1:
        return None
    sides = {side for link in relation.only for side in (link.left, link.right)}
    angles = {side for side in sides if isinstance(side, Letter)}
    arcs = {side for side in sides if is_function(side, "arctan")}
    if len(angles) != 1 or not arcs or sides != angles | arcs:
        return None

    def ratio(side: Expression) -> Expression:
        return side.argument if isinstance(side, Apply) else Apply("tan", side)

    return Relation(
        (tuple(Link(ratio(link.left), link.sign, ratio(link.right)) for link in relation.only),)
    )


def _bounds(relation: Relation) -> bool:
    """Whether a relation is an inequality, or several at once: one value alone is no range."""
    return all(link.sign in FLIPPED for link in relation.only)
