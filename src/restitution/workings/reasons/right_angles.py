"""Angles of the motion that are 90° for some value of a letter, where they have no tangent."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    Fact,
    Line,
    Link,
    Ref,
    Relation,
    Sign,
    equality,
    whole_of,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.evaluate import in_letters
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    RIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    has_quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.oracle import Formula, Oracle, Role, compared
from restitution.oracle import Relation as Claim
from restitution.planning.writing.forms import factors_above, tree_of
from restitution.records import dataclass
from restitution.shapes import Circle
from restitution.workings.naming.in_force import inequalities
from restitution.workings.naming.quantities import Naming


@dataclass(frozen=True)
class _Pole:
    """Where an angle has no tangent: ``at`` says for which letters.

    It is ``upright`` there, that is 90°, unless the body may be at rest.
    """

    angle: Expression
    at: Link
    upright: bool


class RightAngles:
    """The right angles among those of the tangents of one derivation.

    ``poles`` is what is known of its lines already.
    """

    def __init__(
        self,
        derivation: Derivation,
        naming: Naming,
        roles: Mapping[str, Role],
        poles: dict[int, _Pole | None] | None = None,
    ) -> None:
        self._derivation = derivation
        self._naming = naming
        self._roles = roles
        self.poles: dict[int, _Pole | None] = {} if poles is None else poles
        self._closings: dict[int, Sentence | None] = {}
        self._any: bool | None = None

    def of(self, line: Line) -> tuple[Sentence, ...]:
        """What is said behind a tangent of an angle that may be 90°, or made of such a one."""
        above = None
        if self._has_poles():
            above = self._right_angle(line) or self._upright_too(line) or self._closes(line)
        own = self._of_an_answer(line)
        return tuple(sentence for sentence in (above, own) if sentence is not None)

    def sign_by_a_bound(self, value: Expression) -> tuple[Sign, Link] | None:
        """That a component is positive, or not negative, by a bound of a coefficient.

        None where it has no coefficient of restitution, or is not linear in that.
        """
        worth = in_letters_alone(value)
        known = {name: self._roles[name] for name in letters(value) if name in self._roles}
        names = [name for name, role in known.items() if role.kind == "restitution"]
        if worth is None or len(names) != 1:
            return None
        (name,) = names
        symbol = sp.Symbol(name)
        worth = sp.expand(worth)
        slope = sp.diff(worth, symbol)
        oracle = Oracle(known)
        if slope.has(symbol) or not oracle.proves(Claim(worth, ">=")):
            return None
        sign: Sign = ">" if oracle.proves(Claim(worth, ">")) else ">="
        role = known[name]
        end = 1 if oracle.proves(Claim(-slope, ">")) else 0
        bound = (role.low, role.high)[end]
        if bound is None:
            return None
        of_the_bound: Sign = (">", "<")[end] if not role.closed[end] else (">=", "<=")[end]
        return sign, Link(Letter(name), of_the_bound, tree_of(bound))

    def sign_of(self, value: Expression, line: Line) -> tuple[Sign, Relation | None] | None:
        """The sign of a component at a line, and the bound by which it has it, if it is not seen.

        None where it is open.
        """
        for tree, signs in ((value, {}), (Negate(value), FLIPPED)):
            known = self.sign_by_a_bound(tree)
            if known is not None:
                weak = signs.get(known[0], known[0]), Relation(((known[1],),))
                strict = self._strict(value, line) if weak[0] in _WEAK else None
                return strict or weak
        return self._strict(value, line)

    def _strict(self, value: Expression, line: Line) -> tuple[Sign, Relation | None] | None:
        """That a value is positive, or negative, and the given bound by which it is."""
        worth = in_letters_alone(value)
        if worth is None:
            return None
        known_letters = {name: self._roles[name] for name in letters(value) if name in self._roles}
        given = (None, *(fact.relation for fact in self._bounds_given(line, letters(value))))
        for relation in given:
            facts = () if relation is None else tuple(_formulas(relation))
            oracle = Oracle({**self._roles, **known_letters}, facts)
            for sign, side in _SIDES:
                if oracle.proves(Claim(side * worth, ">")):
                    return sign, relation
        return None

    def _bounds_given(self, line: Line, names: frozenset[str]) -> Iterator[Fact]:
        """The inequalities of some letters that are given in the part of a line."""
        part = self._derivation.asked.get(line.item or "")
        for fact in self._derivation.facts:
            if fact.kind not in ("given", "range") or fact.part not in (None, part):
                continue
            links = fact.relation.options[0]
            sides = (side for link in links for side in (link.left, link.right))
            if len(fact.relation.options) > 1 or any(map(has_quantity, sides)):
                continue
            if names & fact.relation.letters and links[0].sign in FLIPPED:
                yield fact

    def among(self, line: Line) -> Relation | None:
        """For which letters one of the angles of which a line makes another is a right one."""
        assert isinstance(line.relation, Relation)
        first = line.relation.options[0][0]
        trees = {*walk(first.left), *walk(first.right)}
        for ref in line.premises:
            own = self._line(ref)
            if own is not None and isinstance(own.relation, Relation):
                trees.add(own.relation.options[0][0].left)
        for other in self._derivation.lines:
            if other.number < line.number and isinstance(other.relation, Relation):
                pole = self._pole(other)
                if pole is not None and pole.upright and pole.angle in trees:
                    return Relation(((pole.at,),))
        return None

    def _of_an_answer(self, line: Line) -> Sentence | None:
        """Where an angle made of two has no tangent, of which that is an answer."""
        assert isinstance(line.relation, Relation)
        ends = any(end.line == line.number and not end.shown for end in self._derivation.items)
        match line.relation.options:
            case ((Link(Apply("tan", angle), "="), *_),) if line.move.id == "put" and ends:
                pole = self._pole_at(line, angle, line.relation.only[-1].right)
                return None if pole is None else self._sentence(pole)
        return None

    def _right_angle(self, line: Line) -> Sentence | None:
        """Where an angle of the motion has no tangent: it is 90° there, or no angle at all."""
        pole = self._pole(line)
        again = line.move.id == "rearrange" and any(
            self._pole(own) is not None for own in map(self._line, line.premises) if own is not None
        )
        if pole is None or again or (pole.upright and self._is_spoken_of_below(line)):
            return None
        return self._sentence(pole)

    def _is_spoken_of_below(self, line: Line) -> bool:
        """Whether a line that is made of a tangent says for which letters it holds all the same."""
        if any(end.line == line.number for end in self._derivation.items):
            return False
        below = (
            other
            for other in self._derivation.lines
            if other.number > line.number and isinstance(other.relation, Relation)
        )
        return any(
            (line.number in other.premises and self._upright_too(other) is not None)
            or (other.item == line.item and self._closing(other) is not None)
            for other in below
        )

    def _sentence(self, pole: _Pole) -> Sentence:
        """That an angle is a right one, or for which letters it is any."""
        if not pole.upright:
            apart = Relation(((replace(pole.at, sign="!="),),))
            return say("derived.tangent-for", condition=self._naming.relation(apart))
        right = equality(pole.angle, RIGHT_ANGLE)
        at = Relation(((pole.at,),))
        return say(
            "derived.right-angle", angle=self._naming.relation(right), at=self._naming.relation(at)
        )

    def _upright_too(self, line: Line) -> Sentence | None:
        """That a tangent holds too where one of which it is made has none, as that angle is 90°."""
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(Apply("tan", Letter() as turn), "="), *_),) if line.move.id == "put":
                value = in_letters_alone(line.relation.only[-1].right)
            case _:
                return None
        above = [own for ref in line.premises if (own := self._line(ref)) is not None]
        poles = [pole for own in above if (pole := self._pole(own)) is not None]
        sums = (own for own in self._derivation.lines if own.number < line.number)
        whole = next((r for own in sums if (r := _made_of(own, turn)) is not None), None)
        if len(poles) != 1 or not poles[0].upright or whole is None or value is None:
            return None
        angle, vertical = poles[0].angle, poles[0].at
        root = in_letters_alone(vertical.right)
        there = rebuilt(whole, lambda tree: RIGHT_ANGLE if tree == angle else tree)
        at = in_letters_alone(there)
        if there == whole or at is None or root is None or not isinstance(vertical.left, Letter):
            return None
        tangent = sp.tan(sp.expand(at)) if at.has(sp.pi) else None
        known = value.subs(sp.Symbol(vertical.left.name), root)
        if tangent is None:
            return None
        put = self._given_in(sp.expand_trig(tangent), line)
        if tidy(put.subs(sp.Symbol(vertical.left.name), root) - known) != 0:
            return None
        where = Relation(((vertical,),))
        if at.is_number:
            there = tree_of(tidy(at), angle=True)
        turned = equality(turn, there)
        return say(
            "derived.upright-too",
            at=self._naming.relation(where),
            angle=self._naming.relation(turned),
        )

    def _closes(self, line: Line) -> Sentence | None:
        """That an equation made of tangents holds too where one of these angles is a right one.

        It is said of the first line in which nothing is divided by what is zero there.
        """
        if any(self._closing(own) is not None for own in self._above(line)):
            return None
        return self._closing(line)

    def _closing(self, line: Line) -> Sentence | None:
        if line.number not in self._closings:
            self._closings[line.number] = self._closing_of(line)
        return self._closings[line.number]

    def _closing_of(self, line: Line) -> Sentence | None:
        assert isinstance(line.relation, Relation)
        whole = whole_of(line.relation.options[0])
        if line.move.id not in ("put", "rearrange", "cancel") or len(line.relation.options) > 1:
            return None
        if whole is None or whole.sign != "=":
            return None
        above = list(self._above(line))
        poles = [pole for own in above if (pole := self._pole(own)) is not None]
        if len(poles) != 1 or not poles[0].upright or not isinstance(poles[0].angle, Letter):
            return None
        (pole,) = poles
        for own in above:
            angle = self._other_angle(own, pole.angle)
            if angle is not None and _holds_at(whole, angle, pole.at):
                name, value = angle
                where = equality(Letter(name), tree_of(value, angle=True))
                at = self._naming.relation(Relation(((pole.at,),)))
                return say("derived.upright-too", at=at, angle=self._naming.relation(where))
        return None

    def _above(self, line: Line) -> Iterator[Line]:
        """The lines on which one rests, as far as those of its angles and their tangents."""
        pending, seen = list(line.premises), set[Ref]()
        while pending:
            ref = pending.pop()
            own = None if ref in seen else self._line(ref)
            seen.add(ref)
            if own is not None:
                yield own
                if own.move.id in ("put", "rearrange", "cancel", "identity"):
                    pending += own.premises

    def _other_angle(self, line: Line, right: Expression) -> tuple[str, sp.Expr] | None:
        """The letter of the data in an equation of angles, with its value where one is 90°."""
        assert isinstance(line.relation, Relation)
        whole = whole_of(line.relation.options[0])
        if whole is None or whole.sign != "=" or len(line.relation.options) > 1:
            return None
        sides = whole.left, whole.right
        names = {name for side in sides for name in letters(side)} - letters(right)
        if not letters(right) & {n for side in sides for n in letters(side)} or len(names) != 1:
            return None
        (name,) = names
        role = self._roles.get(name)
        trees = [rebuilt(side, lambda e: RIGHT_ANGLE if e == right else e) for side in sides]
        worths = [in_letters_alone(tree) for tree in trees]
        if role is None or role.kind != "angle" or worths[0] is None or worths[1] is None:
            return None
        gap, symbol = sp.expand(worths[0] - worths[1]), sp.Symbol(name)
        slope = sp.diff(gap, symbol)
        if not slope.is_number or slope == 0 or gap.has(sp.Function):
            return None
        value = tidy(-gap.subs(symbol, 0) / slope)
        return (name, value) if bool(value > 0) and bool(value < sp.pi / 2) else None

    def _given_in(self, value: sp.Expr, line: Line) -> sp.Expr:
        """A value in tangents of letters, those put in that a line cites, of data and of lines."""
        facts = (fact.relation for fact in self._derivation.facts_in(line.premises))
        lines = (own.relation for own in self._derivation.lines_in(line.premises))
        for relation in (*facts, *lines):
            match relation:
                case Relation(((Link(Apply("tan", Letter(name)), "="), *_) as links,)):
                    known = in_letters_alone(links[-1].right)
                    if known is not None:
                        angle = sp.Symbol(name)
                        value = value.subs({sp.tan(angle): known, sp.cot(angle): 1 / known})
        return sp.sympify(value, strict=True)

    def _has_poles(self) -> bool:
        """Whether there is a line with the tangent of an angle that may be a right one."""
        if self._any is None:
            relations = (e for e in self._derivation.lines if isinstance(e.relation, Relation))
            self._any = any(self._pole(line) is not None for line in relations)
        return self._any

    def _pole(self, line: Line) -> _Pole | None:
        """Where the angle whose tangent a line gives has none, if the letters may be so."""
        if line.number not in self.poles:
            self.poles[line.number] = self._pole_of(line)
        return self.poles[line.number]

    def _pole_of(self, line: Line) -> _Pole | None:
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(Apply("tan", angle), "="), *_),) if line.move.id in ("define", "rearrange"):
                if self._comes_off_a_circle(line):
                    return None
                return self._pole_at(line, angle, line.relation.only[0].right)
        return None

    def _comes_off_a_circle(self, line: Line) -> bool:
        """Whether a body leaves a circular wall, as the story goes on: along it, it could not."""
        events = self._naming.events
        event = events.get(line.move.event or 0)
        circles = {w.name for w in self._naming.problem.walls if isinstance(w.shape, Circle)}
        if event is None or event.bodies[-1] not in circles:
            return False
        later = (own for number, own in events.items() if number > event.number)
        return any(own.bodies[0] == event.bodies[0] for own in later)

    def _pole_at(self, line: Line, angle: Expression, value: Expression) -> _Pole | None:
        """Where an angle has no tangent, of which a side of a line is the value."""
        assert isinstance(line.relation, Relation)
        meaning = self._naming.meanings.get(angle.name) if isinstance(angle, Letter) else None
        meant = angle if meaning is None else meaning.quantity
        if not isinstance(meant, Quantity) or meant.kind not in ANGLES:
            return None
        quotient = _quotient(value)
        if quotient is None:
            return None
        given = tuple(self._in_force(line))
        # The last side is the plainest: there most has been cancelled.
        sides = list(dict.fromkeys((line.relation.only[-1].right, value)))
        whole = [node for side in sides for node in walk(side)]
        below = [e.right for e in whole if is_binary(e, "/")]
        factors = (
            own for tree in below for factor in factors_above(tree) for own in _sized(factor)
        )
        for factor in factors:
            for at in self._zeros(factor):
                gap = in_letters_alone(Binary("-", at.left, at.right))
                if gap is None or not self._may_hold(gap, given):
                    continue
                there = quotient
                if isinstance(at.left, Letter):
                    root = at.left.name, in_letters_alone(at.right)
                    there = quotient[0].subs(*root), quotient[1].subs(*root)
                oracle = Oracle(self._roles, (*given, Claim(gap, "=")))
                if oracle.proves(Claim(there[1], "=")):
                    return _Pole(angle, at, upright=oracle.proves(Claim(there[0], "!=")))
        return None

    def _zeros(self, factor: Expression) -> Iterator[Link]:
        """Where a factor below a line is zero: a letter is a number, or two terms are equal."""
        difference = in_letters_alone(factor)
        names = letters(factor)
        if difference is None:
            return
        if len(names) == 1:
            (name,) = names
            symbol = sp.Symbol(name)
            role = self._roles.get(name)
            if role is not None and role.kind != "angle" and difference.is_polynomial(symbol):
                for root in sp.roots(sp.Poly(difference, symbol)):
                    if root.is_Rational:
                        yield Link(Letter(name), "=", tree_of(root))
            if role is not None and role.kind == "angle":
                upright = {sp.cos(symbol): RIGHT_ANGLE, sp.sin(symbol): Degrees(Fraction(0))}
                if difference in upright:
                    yield Link(Letter(name), "=", upright[difference])
                    return
            if role is not None and role.kind == "angle" and not difference.has(sp.pi):
                in_tan = sp.cancel(difference.subs(sp.sin(symbol), symbol * sp.cos(symbol)))
                slope = sp.diff(in_tan, symbol)
                if slope != 0 and not slope.free_symbols:
                    root = tidy(symbol - in_tan / slope)
                    yield Link(Apply("tan", Letter(name)), "=", tree_of(root))
        elif is_binary(factor, "-"):
            turned = isinstance(factor.left, Number)
            sides = (factor.right, factor.left) if turned else (factor.left, factor.right)
            yield Link(sides[0], "=", sides[1])
        elif is_binary(factor, "+"):
            yield Link(factor, "=", Number(Fraction(0)))

    def _may_hold(self, gap: sp.Expr, given: tuple[Formula, ...]) -> bool:
        """Whether an expression is zero for some of the values that the letters may have."""
        names = frozenset(str(symbol) for symbol in gap.free_symbols)
        roles = {name: role for name, role in self._roles.items() if name in names}
        if len(roles) < len(names):
            return False
        oracle = Oracle(roles, given)
        return oracle.decide(Claim(gap, "!=")).answer == "refuted"

    def _in_force(self, line: Line) -> Iterator[Formula]:
        part = self._derivation.asked.get(line.item or "")
        return inequalities(self._derivation, part, in_letters)

    def _line(self, ref: Ref) -> Line | None:
        """A line with a relation among the premises."""
        own = self._derivation.line(ref)
        return own if own is not None and isinstance(own.relation, Relation) else None


def _holds_at(whole: Link, angle: tuple[str, sp.Expr], at: Link) -> bool:
    """Whether an equation holds, and nothing in it is without a value, at an angle and a pole."""
    sides = [in_letters_alone(side) for side in (whole.left, whole.right, at.left, at.right)]
    if any(side is None for side in sides):
        return False
    left, right, first, second = (side.subs(sp.Symbol(angle[0]), angle[1]) for side in sides)  # type: ignore[union-attr]
    gap = sp.expand(first - second)
    for symbol in sorted(gap.free_symbols, key=str):
        slope = sp.diff(gap, symbol)
        if slope != 0 and not slope.has(symbol):
            root = -gap.subs(symbol, 0) / slope
            there = [value.subs(symbol, root) for value in (left, right)]
            finite = not any(value.has(sp.zoo, sp.nan, sp.oo) for value in there)
            return finite and bool(tidy(there[0] - there[1]) == 0)
    return False


def _made_of(line: Line, turn: Letter) -> Expression | None:
    """The sum or difference of angles that a line says an angle is."""
    match line.relation:
        case Relation(((Link(left, "=", Binary("+" | "-") as right),),)) if left == turn:
            return right
    return None


def _sized(tree: Expression) -> Iterator[Expression]:
    """The factors of what a size is taken of; any other tree as it is."""
    if is_function(tree, "abs"):
        yield from factors_above(tree.argument)
    else:
        yield tree


def _quotient(tree: Expression) -> tuple[sp.Expr, sp.Expr] | None:
    """What is above and below the line of a quotient, nothing cancelled."""
    if is_binary(tree, "/"):
        over, under = in_letters_alone(tree.left), in_letters_alone(tree.right)
        return None if over is None or under is None else (over, under)
    worth = in_letters_alone(tree)
    return None if worth is None else sp.fraction(sp.together(worth))


_WEAK = frozenset({"<=", ">="})
_SIDES: tuple[tuple[Sign, int], ...] = ((">", 1), ("<", -1))


def _formulas(relation: Relation) -> Iterator[Formula]:
    """The inequalities of a fact as the oracle knows them."""
    for link in relation.only:
        yield compared(in_letters(link.left), link.sign, in_letters(link.right))


def in_letters_alone(tree: Expression) -> sp.Expr | None:
    """What a tree is worth in its letters; None where it holds more than these."""
    try:
        return in_letters(tree)
    except RestitutionError:
        return None


__all__ = ["RightAngles", "in_letters_alone"]
