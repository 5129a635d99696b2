"""Greatest and least values: a bound, and where it is reached."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Line,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    numbers_in,
)
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    is_function,
    is_quantity,
    letters,
)
from restitution.planning.formulas.turns import velocities_of
from restitution.planning.inequalities.angle_pairs import (
    extents,
    is_beside_degrees,
    is_of_two_angles,
    is_tangent_of_letters,
    letters_under,
    made_of_two,
    tangent_as_asked,
    tangent_with_letter,
)
from restitution.planning.inequalities.angles_at_ends import AngleAtEnds, is_angle_of_motion
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.completed_squares import write_completed, write_square
from restitution.planning.inequalities.extrema_above import write_bound_again
from restitution.planning.inequalities.gaps import is_left, is_plain, write_difference
from restitution.planning.inequalities.inverses import bounds_of_the_ratio, inverse_by_lines
from restitution.planning.inequalities.letter_ranges import ranges_of
from restitution.planning.inequalities.nearing import (
    comes_to,
    letter_within,
    roots_by_a_root,
    worth_within,
)
from restitution.planning.inequalities.over_offsets import offset_over, role_of
from restitution.planning.inequalities.quotients import by_tangent, write_quotient
from restitution.planning.inequalities.wide_angles import compared_by_cosine, cosine_of
from restitution.planning.inequalities.worths import NAMED
from restitution.planning.routes.order import Solver, Standing
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.forms import (
    ONE,
    ZERO,
    outer_terms,
    product,
    tree_of,
)
from restitution.planning.writing.polynomials import expanded, one_fraction, polynomial_in
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.solving.equations.solution import Answer
from restitution.solving.story.letters import roles

_TO_FORM = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))


def write_extremum(
    scene: Scene,
    solver: Solver,
    kind: str,
    asked: Expression,
    over: Expression,
    answer: Answer | None,
    value: Any,
    name: str,
    printed: Expression | None = None,
) -> None:
    """Writes the lines of a greatest or least value, of which the last says it as a bound.

    What is to be shown ends in its ``printed`` form.
    """
    reached = answer is None or answer.reached
    if not isinstance(over, Letter):
        raise NotPlannedError("an extremum over what is no letter")
    bound = sp.sympify(value, strict=True)
    with Claims(scene, solver) as claims:
        mark = claims.worths.mark()
        try:
            own = _Extremum(claims, kind, asked, over.name, bound, reached, printed)
            line = own.write()
        except NotPlannedError:
            if answer is not None:
                raise
            # What is to be shown does not say whether it is reached.
            claims.worths.back(mark)
            claims.ties.clear()
            own = _Extremum(claims, kind, asked, over.name, bound, False, printed)
            line = own.write()
    scene.desk.end(name, line, Relation(((own.end,),)), shown=printed is not None)


class _Extremum:
    """An expression whose greatest or least value over a letter is sought."""

    def __init__(
        self,
        claims: Claims,
        kind: str,
        asked: Expression,
        over: str,
        value: sp.Expr,
        reached: bool,
        printed: Expression | None,
    ) -> None:
        self.claims = claims
        self.scene = claims.scene
        self.judge = claims.judge
        self.symbol = roles(self.scene.problem)[over].symbol(over)
        self.offset = offset_over(self.scene, self.symbol)
        if self.offset is not None:
            self.symbol = self.offset.angle
        self.role = role_of(self.scene, self.symbol)
        self.angle = self.role.kind == "angle"
        self.least = kind == "minimum"
        # A tangent of two letters is written by these.
        self.asked = asked if is_tangent_of_letters(asked) else claims.worths.opened(asked)
        self.value = value
        self.support: tuple[Ref, ...] = ()
        self.lets: list[Ref] = []
        self.place: Link | None = None
        self.extents: dict[Expression, int] = {}
        self.attained = reached
        sign: Sign = ">" if self.least else "<"
        if reached:
            sign = ">=" if self.least else "<="
        self.move = Move("answer", "least" if self.least else "greatest")
        if not reached:
            self.move = Move("answer", "approached")
        angle = is_quantity(self.asked, *ANGLES) or is_of_two_angles(self.asked)
        known = roles(self.scene.problem)
        degrees = angle or (isinstance(asked, Letter) and known[asked.name].kind == "angle")
        self.printed = printed if not angle else None
        self.arctangent = printed.argument if angle and is_function(printed, "arctan") else None
        self.inverse = printed if angle and is_function(printed, "arcsin", "arccos") else None
        form = self.printed or tree_of(value, angle=degrees, as_it_is=angle)
        self.end = Link(self.asked, sign, form)

    def write(self) -> int:
        """Writes the lines, and returns the number of the last."""
        again = write_bound_again(self.claims, self.move, self.end) if self.attained else None
        if again is not None:
            self.end = self.scene.desk.last_link(again)
            return again
        if is_quantity(self.asked, *ANGLES) or is_of_two_angles(self.asked):
            start, end, value = self.claims.worths.mark(), self.end, self.value
            if is_beside_degrees(self.asked):
                with suppress(NotPlannedError):
                    return self._at_an_end()
                self.claims.worths.back(start)
                self.end = end
            for form in (self.arctangent, None) if self.arctangent else (None,):
                try:
                    return self._of_angle(form)
                except NotPlannedError:
                    self.claims.worths.back(start)
                    self.end, self.value = end, value
            return self._at_an_end()
        if (letter := letter_within(self.asked)) is not None:
            self.claims.ties.lines()
            start = self.claims.worths.mark()
            try:
                tied = self._of_tied_letter(letter)
            except NotPlannedError:
                self.claims.worths.back(start)
                tied = None
            if tied is not None:
                return tied
        start = self.claims.worths.mark()
        line = self._lettered()
        if line is None:
            line = self._line()
            # A tangent is written by the letter that another part has introduced.
            line = self._lettered() or line
            self._say_as_stated(line)
        end = self.end
        defined = self._as_defined(start, line)
        methods = [self._as_known, self._monotone, self._quotient, self._square, self._double]
        methods += [self._square_between, self._gap, self._plain]
        if defined is not None:
            line = defined
        if defined is not None or self._shows_a_square(line):
            methods.insert(0, self._plain)
        for method in methods:
            mark = self.claims.worths.mark()
            self.support, self.place = (), None
            bound = method(line)
            if bound is not None:
                last = self._reached(line, bound)
                if last is not None:
                    return last
            self.claims.worths.back(mark)
            self.end = end
        raise NotPlannedError("a greatest or least value")

    def _of_angle(self, form: Expression | None = None) -> int:
        """An angle by its tangent, which has a form where that is to be shown."""
        asked, whole, value = self.asked, self.end, self.value
        tangent = tidy(sp.tan(value))
        if not value.is_Symbol and not sp.deg(value).is_Rational:
            whole = replace(whole, right=self.inverse or Apply("arctan", form or tree_of(tangent)))
        if tangent.has(sp.zoo) or self.scene.model.sign(tangent) <= 0:
            return self._of_wide_angle(asked)
        start = self.claims.worths.mark()
        line, letter, extent = tangent_with_letter(self.scene, self.claims.worths, asked)
        line = self._put(line)
        if self._may_be_obtuse(asked, line):
            standing = self.end, self.value
            try:
                self.claims.worths.back(start)
                return self._of_cosine(asked)
            except NotPlannedError:
                self.claims.worths.back(start)
                self.end, self.value = standing
                line, letter, extent = tangent_with_letter(self.scene, self.claims.worths, asked)
                line = self._put(line)
        if is_of_two_angles(asked) or self.claims.worths.is_of_statement(letter):
            asked, whole = letter, replace(whole, left=letter)
        self.value = tangent
        self.end = Link(Apply("tan", letter), whole.sign, form or tree_of(tangent))
        for method in (self._monotone, self._quotient, self._gap, self._plain):
            mark = self.claims.worths.mark()
            self.support, self.place = (), None
            bound = method(line)
            if bound is not None:
                own = Relation(((whole,),))
                for ratio in bounds_of_the_ratio(whole, letter) if self.inverse else ():
                    in_it = self.claims.angle_of(bound, line, extent, ratio, (), self.support)
                    bound = in_it or bound
                last = self.claims.angle_of(bound, line, extent, own, (), self.support)
                there = None if last is None else self._place(line, Apply("tan", asked), extent)
                if last is not None and there is not None:
                    given = self._known(*self._names(self.value))
                    refs = self.judge.enough(self.move, [last, there], own, given)
                    if refs is not None:
                        self.end = whole
                        return self.scene.desk.write(self.move, refs, own)
            self.claims.worths.back(mark)
        raise NotPlannedError("the greatest or least angle")

    def _at_an_end(self) -> int:
        """An angle that a line gives by inverse tangents, at an end of the letter."""
        if not is_angle_of_motion(self.asked) and not is_of_two_angles(self.asked):
            raise NotPlannedError("the greatest or least angle")
        own = AngleAtEnds(self.claims, self.claims.solver, self.asked)
        name = self.symbol.name
        for end, bounds in own.ends_of(name):
            self.place = Link(Letter(name), "=", tree_of(end, angle=self.angle))
            self.end = replace(self.end, right=own.at(name, end))
            bound = own.bounded(self._relation, bounds)
            if bound is not None:
                last = self._reached(own.line, bound)
                if last is not None:
                    return last
        raise NotPlannedError("the greatest or least angle")

    def _of_wide_angle(self, asked: Expression) -> int:
        """An angle that is not bounded by an acute one, by those of which it is made."""
        if not isinstance(asked, Quantity):
            raise NotPlannedError("an angle that is not acute")
        self.claims.worths.determine_angle(asked)
        parts = made_of_two(self.scene, asked)
        if parts is None:
            return self._of_cosine(asked)
        line, support = parts
        self.end = replace(self.end, left=self.scene.desk.last_link(line).left)
        inside = {name for ref in (line, *support) for name in letters_under(self.scene, ref)}
        known = [*self._known(*sorted(inside)), *extents(self.scene, inside)]
        moves = (Move("compare"),)
        bound = self.judge.write(moves, [line, *support, *known], self._relation)
        if bound is not None:
            there = self._place(line, self.end.left, support)
            if there is not None and self.judge.follows(self.move, [bound, there], self._relation):
                return self.scene.desk.write(self.move, [bound, there], self._relation)
        raise NotPlannedError("an angle that is not acute")

    def _may_be_obtuse(self, asked: Expression, line: int) -> bool:
        """Whether the tangent of an angle between velocities does not grow with it throughout."""
        if not isinstance(asked, Quantity) or velocities_of(self.scene, asked) is None:
            return False
        return not proved_sign(self.scene.model.ground, self._value(line))

    def _of_cosine(self, asked: Expression) -> int:
        """An angle between two velocities by its cosine, which falls as the angle grows."""
        own = cosine_of(self.claims, asked) if isinstance(asked, Quantity) else None
        if own is None:
            raise NotPlannedError("an angle that is not acute")
        whole, self.value = self._relation, tidy(sp.cos(self.value))
        sign = FLIPPED[whole.only[0].sign]
        bound = Relation(((Link(own.tree, sign, tree_of(self.value)),),))
        ends = self.claims.monotone(own.line, bound)
        if ends is not None:
            last = compared_by_cosine(self.claims, own, ends, whole)
            whole = whole if last is None else self.scene.desk.relation(last)
            there = self._place(own.line, Apply("cos", asked), own.known)
            if (
                last is not None
                and there is not None
                and self.judge.follows(self.move, [last, there], whole)
            ):
                (self.end,) = whole.only
                return self.scene.desk.write(self.move, [last, there], whole)
        raise NotPlannedError("an angle that is not acute")

    def _of_tied_letter(self, asked: Letter) -> int | None:
        """A letter that no line gives by others: by the equation that ties it to them."""
        lines = self.claims.ties.lines()
        if any(self.claims.ties.subject(number, asked.name, self.asked) for number in lines):
            return None
        role = roles(self.scene.problem)[asked.name]
        reached: list[tuple[Expression, sp.Expr]] = [(self.asked, self.value)]
        if role.kind == "angle" and asked == self.asked:
            ratios = {"tan": sp.tan, "cos": sp.cos, "sin": sp.sin}
            reached = [(Apply(e, asked), tidy(ratios[e](self.value))) for e in ratios]
            by_ratio = inverse_by_lines(self.scene, lines, asked, self.value)
            self.end = self.end if by_ratio is None else replace(self.end, right=by_ratio)
        bound = self.claims.write(self._relation)
        for line in lines:
            for end in (self.role.low, self.role.high):
                if end is None or not comes_to(
                    self.scene, asked.name, worth_within(self.asked, self.value), self.symbol, end
                ):
                    continue
                unless = Link(Letter(self.symbol.name), "!=", tree_of(end))
                pool = [line, *self._known(asked.name, self.symbol.name)]
                for subject, value in reached:
                    relation = Relation(((unless,), (Link(subject, "=", tree_of(value)),)))
                    there = self.judge.write((Move("put"),), pool, relation, shown="silent")
                    if there is not None and self.judge.follows(
                        self.move, [bound, there], self._relation
                    ):
                        return self.scene.desk.write(self.move, [bound, there], self._relation)
        raise NotPlannedError("a greatest or least value of a letter")

    def _line(self) -> int:
        if (letter := letter_within(self.asked)) is not None:
            for number in self.claims.ties.lines():
                line = self.claims.ties.subject(number, letter.name, self.asked)
                if line is not None:
                    return line
        match self.asked:
            case Letter(name):
                return self._solved(name)
            case Apply("tan", Quantity() as angle):
                return self.claims.worths.angle(angle)
        if is_tangent_of_letters(self.asked):
            line = tangent_as_asked(self.scene, self.claims.worths, self.asked)
        else:
            line = self.claims.worths.worth(self.asked)
        if line is None:
            raise NotPlannedError("an expression of several quantities")
        return line

    def _solved(self, letter: str) -> int:
        """The line of a letter for which the facts are solved: of a coefficient, by its square."""
        symbol = roles(self.scene.problem)[letter].symbol(letter)
        self.claims.solver.determine([symbol])
        known = self.scene.desk.known(Letter(letter))
        lines = () if known is None else numbers_in(known.refs)
        if not lines or len(self.scene.desk.relation(lines[-1]).options) != 1:
            raise NotPlannedError(f"{letter} by other letters")
        return lines[-1]

    def _lettered(self) -> int | None:
        """The line of a tangent by the letter for its angle, where one stands already."""
        match self.asked:
            case Apply("tan", Quantity() as angle) if self.claims.worths.is_lettered(angle):
                name, let = self.claims.worths.letter_for(angle)
            case _:
                return None
        subject, known = Apply("tan", Letter(name)), set(roles(self.scene.problem))
        for other in self.scene.desk.lines:
            match other.relation:
                case Relation(((Link(left, "="), *_),)) if left in (subject, self.asked):
                    own = self.scene.desk.last_link(other.number).right
                    if self.scene.desk.holds(other.number) and letters(own) <= known:
                        line, _, _ = self.claims.worths.lettered(other.number, angle)
                        self.end, self.lets = replace(self.end, left=subject), [let]
                        return self._put(line)
        return None

    def _say_as_stated(self, line: int) -> None:
        """The answer is of the letter that the statement has for a quantity, where a line is."""
        left = self.scene.desk.last_link(line).left
        if left != self.asked and self.claims.worths.opened(left) == self.asked:
            self.asked, self.end = left, replace(self.end, left=left)

    def _put(self, line: int) -> int:
        """A line with the values of this part put in."""
        link = self.scene.desk.last_link(line)
        final = self.scene.model.final
        known = sorted(self._value(line).free_symbols & final.keys(), key=str)
        self.claims.solver.determine(known)
        value, refs = self.scene.put(self._value(line))
        if value == self._value(line):
            return line
        relation = Relation(((replace(link, right=tree_of(tidy(value))),),))
        return self.judge.write((Move("put"),), [line, *refs], relation) or line

    @property
    def _relation(self) -> Relation:
        return Relation(((self.end,),))

    def _known(self, *names: str) -> tuple[Ref, ...]:
        return self.judge.known(names)

    def _names(self, x: sp.Expr) -> list[str]:
        known = {*roles(self.scene.problem), self.symbol.name}
        return sorted(s.name for s in x.free_symbols if s.name in known)

    # --- where it is reached --------------------------------------------------------------------

    def _reached(self, line: int, bound: int) -> int | None:
        """The value at the place where it is greatest or least, and the answer."""
        if self.end.left != self.asked:
            # The answer is printed with the letter.
            self.end = replace(self.end, left=self.asked)
            named = self.judge.write(NAMED, [bound, *self.lets], self._relation, shown="silent")
            if named is None:
                return None
            bound = named
        there = self._place(line, self.end.left, self.lets)
        if there is None:
            return None
        others = self._other_places(line, there)
        if not self.judge.follows(self.move, [bound, there], self._relation):
            place = self.scene.desk.relation(there).options[0][0].right
            others = [self.extents[place]] if place in self.extents else []
            if not self.judge.follows(self.move, [bound, there, *others], self._relation):
                return None
        return self.scene.desk.write(self.move, [bound, there, *others], self._relation)

    def _other_places(self, line: int, there: int) -> list[int]:
        """The lines of the other places at which the value is reached, those of numbers."""
        if self.angle or not self.attained:
            return []
        own = self.scene.desk.relation(there).options[0][0]
        others: list[int] = []
        for place in self._places(line):
            if place.left != own.left or place.right == own.right or letters(place.right):
                continue
            more = self._place(line, self.end.left, self.lets, place)
            if more is not None and more not in (there, *others):
                others.append(more)
        return others

    def _place(
        self, line: int, subject: Expression, named: Sequence[Ref] = (), only: Link | None = None
    ) -> int | None:
        """The line that says what the value is at the place where it is greatest or least."""
        for place in self._places(line) if only is None else (only,):
            form = self.end.right if self.end.left == subject else tree_of(self.value)
            value = Link(subject, "=", form)
            ratios: tuple[int, ...] = ()
            if self.offset is not None:
                by_offset = self.offset.place(place)
                if by_offset is None:
                    continue
                place, ratios = by_offset, self.offset.ratios()
            unless = Link(place.left, "!=", place.right)
            relation = Relation(((unless,), (value,)))
            known = self._known(*self._names(self._value(line)))
            # The answer says it once more, with the place.
            for more in ((), self._times()):
                # No time is before the clock starts: that tells the sign of a length.
                there = self.judge.standing(relation)
                if there is not None:
                    return there
                # What introduces the letter is tried first: nothing else may be needed.
                lines = [ref for ref in named if isinstance(ref, int)]
                for pool in ([line, *ratios, *lines], [line, *ratios, *named, *known, *more]):
                    refs = self.judge.needed(Move("put"), pool, relation)
                    if refs is not None:
                        return self.scene.desk.write(Move("put"), refs, relation, "silent")
        return None

    def _times(self) -> list[int]:
        """The lines that say when something happens."""
        lines = (e.number for e in self.scene.desk.lines if isinstance(e.relation, Relation))
        return [
            n
            for n in lines
            if len(self.scene.desk.relation(n).options) == 1
            and is_quantity(self.scene.desk.last_link(n).left, "time")
        ]

    def _places(self, line: int) -> Iterator[Link]:
        """The value of the letter, or of its tangent, at which the bound is reached."""
        if not self.attained:
            yield from self._ends()
            return
        if self.place is not None:
            yield self.place
        gap = sp.fraction(one_fraction(self._value(line) - self.value))[0]
        for bar in gap.atoms(sp.Abs):
            # The place is tried: with the other sign it is none.
            if bar.has(self.symbol):
                inside = bar.args[0]
                gap = gap.xreplace({bar: inside}) * gap.xreplace({bar: -inside})
        letter = Letter(self.symbol.name)
        if not self.angle:
            x, subject, generator = expanded(gap), letter, self.symbol
        else:
            t = sp.Dummy("t", positive=True)
            x = sp.fraction(one_fraction(expanded(by_tangent(gap, self.symbol, t) ** 1)))[0]
            subject, generator = Apply("tan", letter), t  # type: ignore[assignment]
        if not self.angle and (squares := roots_by_a_root(x, self.symbol)) is not None:
            yield from (Link(letter, "=", tree_of(own)) for own in squares)
            return
        if any(p.exp == sp.Rational(1, 2) and generator in p.free_symbols for p in x.atoms(sp.Pow)):
            gap = self._value(line) ** 2 - self.value**2
            if self.angle:
                gap = by_tangent(gap, self.symbol, generator)
            x = expanded(sp.fraction(one_fraction(gap))[0])
        try:
            roots = sp.roots(polynomial_in(x, generator))
        except sp.PolynomialError:
            return
        role = self.role
        for root in sorted(roots, key=sp.default_sort_key):
            own = tidy(root)
            if own.is_real is False or (self.angle and own.is_positive is False):
                continue
            if not self.angle and role.low is not None and (own - role.low).is_negative:
                continue
            if not self.angle and role.high is not None and (own - role.high).is_positive:
                continue
            if self.angle and own.is_number:
                # An angle in whole degrees is named, and so is one of which no line needs a ratio.
                angle = sp.atan(own)
                degrees = sp.deg(angle)
                if degrees.is_Integer and degrees not in (30, 60):
                    yield Link(letter, "=", tree_of(angle, angle=True, as_it_is=True))
            yield Link(subject, "=", tree_of(own))

    def _ends(self) -> Iterator[Link]:
        """The ends of the range of the letter that do not belong to it."""
        role = self.role
        for end, closed in zip((role.low, role.high), role.closed, strict=True):
            if end is not None and not closed:
                tree = tree_of(end, angle=self.angle, as_it_is=self.angle)
                yield Link(Letter(self.symbol.name), "=", tree)
        if role.high is None:
            # As it grows without limit.
            yield Link(Binary("/", ONE, Letter(self.symbol.name)), "=", ZERO)
        letter = Letter(self.symbol.name)
        for line in ranges_of(self.claims, self.symbol.name):
            # What is given of the motion may leave an end out.
            for link in self.scene.desk.relation(line).only:
                if link.sign in ("<", ">") and letter in (link.left, link.right):
                    end_ = link.right if link.left == letter else link.left
                    if self.symbol.name not in letters(end_):
                        self.extents[end_] = line
                        yield Link(letter, "=", end_)

    def _value(self, line: int) -> sp.Expr:
        return self.claims.worths.value(self.scene.desk.last_link(line).right)

    # --- methods ----------------------------------------------------------------------------------

    def _as_known(self, line: int) -> int | None:
        """The bound that holds of a letter anyway: a coefficient is at most 1."""
        if not isinstance(self.asked, Letter) or self.end.left != self.asked:
            return None
        known = background(self.scene, {self.asked.name})
        return self.judge.write((Move("compare"),), known, self._relation) if known else None

    def _monotone(self, line: int) -> int | None:
        """What only grows, or only falls, is greatest or least at an end."""
        pool = [line, *self._known(*self._names(self._value(line)))]
        bound = self.judge.write((Move("monotone"),), pool, self._relation)
        if bound is not None:
            return bound
        for extent in () if self.offset else ranges_of(self.claims, self.symbol.name):
            bound = self.judge.write((Move("monotone"),), [line, extent, *pool[1:]], self._relation)
            if bound is not None:
                return bound
        return None

    def _quotient(self, line: int) -> int | None:
        """``c t/(a + d t + b t²)``: divided by t, and a/t + b t as a square and what is left."""
        own = write_quotient(self.claims, line, self.symbol, self.end, self.printed is not None)
        if own is None:
            return None
        self.support, self.place = own.support, own.place
        self.end = replace(self.end, right=own.right)
        return own.line

    def _square(self, line: int) -> int | None:
        """A quadratic in the letter: its square completed."""
        if self.angle:
            return None
        return write_square(self.claims, line, self.symbol, self._relation, self.least)

    def _square_between(self, line: int) -> int | None:
        """A speed by a square in a coefficient that is greatest at an end of the range of that."""
        return write_completed(self.claims, line, self._relation)

    def _double(self, line: int) -> int | None:
        """The product of a sine and a cosine of one angle, by the sine of the double."""
        value = self._value(line)
        factor = value / (sp.sin(self.symbol) * sp.cos(self.symbol))
        if not self.angle or self.symbol in factor.free_symbols:
            return None
        twice = Apply("sin", product(tree_of(2), Letter(self.symbol.name)))
        link = Link(self.end.left, "=", product(tree_of(tidy(factor / 2)), twice))
        identity = (Move("identity", "double-angle"),)
        doubled = self.judge.write(identity, [line], Relation(((link,),)))
        if doubled is None:
            return None
        pool = [doubled, *self._known(*self._names(value))]
        return self.judge.write((Move("sign"),), pool, self._relation)

    def _as_defined(self, start: Standing, line: int) -> int | None:
        """The line without its last form, where its first without a square is the least value."""
        own = self.scene.desk.line(line)
        links = self.scene.desk.relation(line).only
        if (
            not self.least
            or len(links) != 2
            or not is_left(self.claims.worths, links[0].right, self.value)
        ):
            return None
        written = self.scene.desk.lines[start.desk.lines :]
        if not written or written[-1] != own:
            return None
        self.scene.desk.lines.pop()
        return self.scene.desk.write(own.move, own.premises, Relation((links[:1],)))

    def _shows_a_square(self, line: int) -> bool:
        """Whether a line ends in the square of a sum with the letter, beside what is without it."""
        if not self.least or self.angle:
            return False
        right = self.scene.desk.last_link(line).right
        inside = right.argument if is_function(right, "sqrt") else right
        own = [term for term in outer_terms(inside) if self.symbol.name in letters(term)]
        match own:
            case [Binary("^", Binary("+" | "-"), Number(Fraction(numerator=2, denominator=1)))]:
                return is_left(self.claims.worths, right, self.value)
        return False

    def _gap(self, line: int) -> int | None:
        """A bound by the difference to it, in factors of certain signs."""
        if is_plain(self.scene, line, self._relation):
            return None
        return write_difference(self.claims, line, self._relation)

    def _plain(self, line: int) -> int | None:
        """A bound that what a line says shows at once."""
        pool = [line, *self._known(*self._names(self._value(line)))]
        whole = self._shortened(line)
        bound = self.judge.write((Move("sign"),), pool, self._relation)
        if bound is None and whole is not None:
            self.scene.desk.lines[line - 1] = whole
            bound = self.judge.write((Move("sign"),), pool, self._relation)
        return bound

    def _shortened(self, line: int) -> Line | None:
        """A line as it is defined alone, where what it comes to has not been used yet.

        Squares show a bound, which what they come to does not. Returns the line as it was.
        """
        desk = self.scene.desk
        own = desk.line(line)
        links = desk.relation(line).only
        used = any(line in other.premises for other in desk.lines)
        if len(links) < 2 or used or own.move.record not in ("energy", "total"):
            return None
        first = Relation((links[:1],))
        refs = self.judge.needed(own.move, own.premises, first)
        if refs is None:
            return None
        desk.lines[line - 1] = replace(own, premises=refs, relation=first)
        return own
