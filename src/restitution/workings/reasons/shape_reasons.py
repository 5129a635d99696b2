"""What bounds a value by its form: a square that is not negative, a share of a whole, a wave."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction

import sympy as sp

from restitution.explaining.data.setting import Setting
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Derivation,
    Line,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    numbers_in,
)
from restitution.explaining.lines.quotients import NotComparableError, Quotient
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import rebuilt, squared
from restitution.explaining.steps.step import Step
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    is_binary,
    letters,
    walk,
)
from restitution.oracle.roles import COEFFICIENT, Role
from restitution.planning.writing.forms import factors, tree_of
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.bounding_parts import (
    is_bound_by,
    squares_below,
    squares_of_terms,
    wave_of,
)
from restitution.workings.reasons.equality import divisor_left_out, place_of_zero
from restitution.workings.reasons.shares import share_of

# A longer expression is told by the name of what it is worth.
_LONGEST = 24
ZERO, ONE = Number(Fraction(0)), Number(Fraction(1))
# A range has two.
_ENDS = 2
SQUARED = 2
UP: tuple[Sign, Sign] = ("<", "<=")
DOWN: tuple[Sign, Sign] = (">", ">=")
_WEAK = ("<=", ">=")


class ShapeReasons:
    """The reasons of bounds that rest on the form of what is bounded."""

    def __init__(self, derivation: Derivation, naming: Naming, roles_: Mapping[str, Role]) -> None:
        self._derivation = derivation
        self._naming = naming
        self._roles = roles_

    def relation_of(self, ref: Ref) -> Relation | None:
        """What a premise says."""
        if isinstance(ref, int):
            own = self._derivation.line(ref)
            return own.relation if own is not None and isinstance(own.relation, Relation) else None
        fact = self._derivation.fact(ref)
        return None if fact is None else fact.relation

    def of(self, line: Line) -> tuple[Sentence, ...]:
        """What bounds a value by its form, the plainest that fits."""
        for bound in (
            *(self._ratio, self._square, self._positive_square),
            *(
                self._factor,
                self._wave,
                self.square_of_a_ratio,
                self._square_of_a_coefficient,
                self._share,
                self._divisor,
                self._below_a_sine,
            ),
        ):
            if reasons := tuple(bound(line)):
                return reasons
        return ()

    def _ratio(self, line: Line) -> Iterator[Sentence]:
        """How the ratio of an angle, which is cited, compares with that of a given angle."""
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(Letter() as angle, sign_, bound),),) if line.move.id in ("sign", "compare"):
                pass
            case _:
                return
        cited = [own for ref in line.premises if (own := self.relation_of(ref)) is not None]
        acute = any(str(ref).startswith("acute:") for ref in line.premises)
        for own in cited if acute and sign_ in (*UP, *DOWN) and not letters(bound) else ():
            for link in own.options[0] if len(own.options) == 1 else ():
                match link:
                    case Link(Apply("sin" | "cos" | "tan" as ratio, inside), "=", value) if (
                        inside == angle and not letters(value)
                    ):
                        other = in_letters(Apply(ratio, bound))
                        sign = FLIPPED[sign_] if ratio == "cos" else sign_
                        chain_ = (link, Link(value, sign, tree_of(other)))
                        last = Link(tree_of(other), "=", Apply(ratio, bound))
                        yield say(
                            "derived.fact", fact=self._naming.relation(Relation(((*chain_, last),)))
                        )
                        return

    def _square(self, line: Line) -> Iterator[Sentence]:
        """That a square is not negative, where a bound is what is left without it."""
        assert isinstance(line.relation, Relation)
        links = line.relation.options[0]
        if line.move.id != "sign" or len(links) != 1 or links[0].sign not in (">=", "<="):
            return
        for own in self._derivation.lines_in(line.premises):
            if not isinstance(own.relation, Relation):
                continue
            left, bound = own.relation.options[0][0].left, links[0].right
            if left == Binary("^", links[0].left, Number(Fraction(2))):
                bound = Binary("^", bound, Number(Fraction(2)))
            elif left != links[0].left:
                continue
            for link in reversed(own.relation.options[0]):
                for term, square in (
                    *squares_of_terms(link.right, links[0].sign),
                    *squares_below(link.right),
                ):
                    if self._is_left(link.right, term, bound):
                        facts = [Link(square, ">=", ZERO)]
                        match term:
                            case Binary("/", _, Letter(name) as below) if (
                                name in self._roles and self._roles[name].kind == "positive"
                            ):
                                facts.append(Link(below, ">", ZERO))
                        for fact in facts:
                            yield say(
                                "derived.fact", fact=self._naming.relation(Relation(((fact,),)))
                            )
                        return

    def _positive_square(self, line: Line) -> Iterator[Sentence]:
        """That a square is not negative, or that of a ratio positive, as what it is equal to is."""
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(_, ">" | "<" | ">=" | "<=" as sign, right),),) if (
                right == ZERO and line.move.id == "sign"
            ):
                pass
            case _:
                return
        own = [self.relation_of(ref) for ref in line.premises]
        strict = sign in ("<", ">")
        match own:
            case [Relation(((Link(Binary("^", base, Number(power)) as square, "=", _),),))] if (
                power == SQUARED and isinstance(base, Apply if strict else Apply | Letter)
            ):
                bound = Relation(((Link(square, ">" if strict else ">=", ZERO),),))
                yield say("derived.fact", fact=self._naming.relation(bound))

    def _is_left(self, whole: Expression, square: Expression, bound: Expression) -> bool:
        """Whether a bound is what is left of a whole without a square."""
        rest = rebuilt(whole, lambda tree: ZERO if tree == square else tree)
        match rest:
            case Apply("sqrt", inside):
                rest, bound = inside, squared(bound)
            case Binary("*", factor, Apply("sqrt", inside)):
                rest, bound = Binary("*", squared(factor), inside), squared(bound)
        step = Step(Setting(self._roles), Move("rearrange"), (), ())
        try:
            gap = step.residual(Link(rest, "=", bound))
        except NotComparableError:
            return False
        return isinstance(gap, Quotient) and gap.vanishes

    def _factor(self, line: Line) -> Iterator[Sentence]:
        """That a square is not negative, where it is a factor of the difference to a bound."""
        assert isinstance(line.relation, Relation)
        refs = numbers_in(line.premises)
        own = self._derivation.line(refs[0]) if line.move.id == "sign" and len(refs) == 1 else None
        if own is None or not isinstance(own.relation, Relation):
            return
        match own.relation.options:
            case ((Link(Binary("-"), "=", right),),) if line.relation.options[0][0].sign in _WEAK:
                above = right.left if is_binary(right, "/") else right
                for factor in factors(above):
                    match factor:
                        case Binary("^", Binary("+" | "-") as base, Number(Fraction(numerator=2))):
                            fact = self._naming.relation(Relation(((Link(factor, ">=", ZERO),),)))
                            place = place_of_zero(base, self._roles, self._derivation)
                            if place is None:
                                yield say("derived.fact", fact=fact)
                            else:
                                where = self._naming.relation(Relation(((place,),)))
                                yield say("derived.fact-equal", fact=fact, place=where)

    def _wave(self, line: Line) -> Iterator[Sentence]:
        """Why a sum or a product of a sine and a cosine is bounded, where a bound comes of that."""
        assert isinstance(line.relation, Relation)
        links = line.relation.options[0]
        if line.move.id != "sign" or len(links) != 1 or links[0].sign not in UP:
            return
        for ref in line.premises:
            own = self._derivation.line(ref)
            if own is None or not isinstance(own.relation, Relation):
                continue
            wholes = [link.right for link in reversed(own.relation.options[0])]
            for whole, node in ((tree, node) for tree in wholes for node in walk(tree)):
                wave = wave_of(node)
                if wave is not None and is_bound_by(whole, node, wave[0], links[0].right):
                    yield say("derived.fact", fact=self._naming.relation(Relation((wave[1],))))
                    return

    def square_of_a_ratio(self, line: Line) -> Iterator[Sentence]:
        """That the square of a sine or cosine is at most 1, or one of a ratio at least 0.

        That gives a bound of a value.
        """
        assert isinstance(line.relation, Relation)
        links = line.relation.options[0]
        if line.move.id == "monotone" and len(links) == _ENDS:
            yield from self._between_no_angle_and_a_right_one(line, links)
            return
        if line.move.id not in ("sign", "monotone") or len(links) != 1:
            return
        for own in map(self.relation_of, line.premises):
            if own is None or own.options[0][0].left != links[0].left:
                continue
            whole = own.options[0][-1].right
            for node in walk(whole):
                match node:
                    case Binary("^", Apply(ratio, x), Number(value=power)) if power == 2:
                        pass
                    case _:
                        continue
                if line.move.id != "sign" and sum(node == x for node in walk(whole)) > 1:
                    continue
                least, most = (DOWN, ZERO), (UP, Number(Fraction(1)))
                for signs, end in (most, least) if ratio in ("sin", "cos") else (least,):
                    if end == links[0].right:
                        continue  # a product with it is as small
                    if is_bound_by(whole, node, end, links[0].right):
                        bound = Relation(((Link(node, signs[links[0].sign in _WEAK], end),),))
                        yield say("derived.limit", fact=self._naming.relation(bound))
                        return

    def square_of_a_coefficient(self, line: Line) -> Link | None:
        """That e² is at least 0, or at most 1, where a value is bounded by that; else None."""
        match line.move.id, line.relation:
            case "sign" | "monotone", Relation(((bound,),)) if bound.sign in _WEAK:
                pass
            case _:
                return None
        for own in map(self.relation_of, line.premises):
            if own is None or own.options[0][0].left != bound.left:
                continue
            whole = own.options[0][-1].right
            for node in walk(whole):
                match node:
                    case Binary("^", Letter(name) as letter, Number(value=power)) if power == 2:
                        pass
                    case _:
                        continue
                alone = sum(other == letter for other in walk(whole)) == 1
                if not alone or self._roles.get(name) != COEFFICIENT:
                    continue
                for square in (Link(node, ">=", ZERO), Link(node, "<=", ONE)):
                    if is_bound_by(whole, node, square.right, bound.right):
                        return square
        return None

    def _square_of_a_coefficient(self, line: Line) -> Iterator[Sentence]:
        square = self.square_of_a_coefficient(line)
        if square is not None:
            yield say("derived.fact", fact=self._naming.relation(Relation(((square,),))))

    def _between_no_angle_and_a_right_one(
        self, line: Line, links: tuple[Link, ...]
    ) -> Iterator[Sentence]:
        """That the square of a sine or cosine of an acute angle lies between 0 and 1.

        That gives both ends of a range.
        """
        low, high = links
        if low.right != high.left or {low.sign, high.sign} != {"<"}:
            return
        for own in map(self.relation_of, line.premises):
            if own is None or own.options[0][0].left != low.right:
                continue
            whole = own.options[0][-1].right
            for node in walk(whole):
                match node:
                    case Binary("^", Apply("sin" | "cos", Letter(name)), Number(power)) if (
                        power == 2 and f"acute: {name}" in line.premises
                    ):
                        pass
                    case _:
                        continue
                once = sum(isinstance(x, Letter) and x.name == name for x in walk(whole)) == 1
                if once and any(
                    is_bound_by(whole, node, one, low.left)
                    and is_bound_by(whole, node, other, high.right)
                    for one, other in ((ZERO, ONE), (ONE, ZERO))
                ):
                    between = Relation(((Link(ZERO, "<", node), Link(node, "<", ONE)),))
                    yield say("derived.limit", fact=self._naming.relation(between))
                    return

    def _divisor(self, line: Line) -> Iterator[Sentence]:
        """That what a square was divided by is more than 1, where a bound has it no more."""
        above = self.relation_of(line.premises[0]) if line.premises else None
        own = line.relation
        if line.move.id != "compare" or above is None or not isinstance(own, Relation):
            return
        bound = divisor_left_out(above, own, self._roles)
        if bound is not None:
            yield say("derived.fact", fact=self._naming.relation(Relation(((bound,),))))

    def _below_a_sine(self, line: Line) -> Iterator[Sentence]:
        """That ``sin θ − √3 cos θ`` is less than sin θ, and so than 1, where a value has it below.

        So it is of an angle that is cited as acute.
        """
        acute = [str(ref).removeprefix("acute:").strip() for ref in line.premises]
        match line.relation:
            case Relation(((Link(subject, ">", bound),),)) if line.move.id == "sign":
                pass
            case _:
                return
        for ref in line.premises:
            own = self.relation_of(ref) if isinstance(ref, int) else None
            match own and own.only[-1].right:
                case Binary("/", above, Binary("-", Apply("sin", Letter(name)) as sine, less)):
                    pass
                case _:
                    continue
            if own is None or own.only[0].left != subject or name not in acute or above != bound:
                continue
            share = in_letters(less) / in_letters(Apply("cos", Letter(name)))
            if share.is_number and share.is_positive:
                whole = Binary("-", sine, less)
                chain_ = (Link(whole, "<", sine), Link(sine, "<", Number(Fraction(1))))
                yield say("derived.fact", fact=self._naming.relation(Relation((chain_,))))

    def _share(self, line: Line) -> Iterator[Sentence]:
        """That what a value is of its bound is at most 1, where nothing else is cited for that."""
        share = share_of(self._derivation, line)
        if share is None or sp.fraction(share)[1].free_symbols:
            return
        if not any(isinstance(ref, str) for ref in line.premises):
            assert isinstance(line.relation, Relation)
            link = Link(tree_of(share), line.relation.only[0].sign, Number(Fraction(1)))
            if is_short(link.left):
                yield say("derived.fact", fact=self._naming.relation(Relation(((link,),))))


def is_short(tree: Expression) -> bool:
    """Whether an expression fits behind a line as what grows or falls."""
    return len(walk(tree)) <= _LONGEST
