"""What a line rests on besides equations: *as α is acute*, *as 0 ≤ e ≤ 1*."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Relation,
    Sign,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Unit,
    is_function,
    walk,
)
from restitution.planning.writing.forms import coordinates
from restitution.problem import Problem
from restitution.render import layout as lay
from restitution.workings.naming.measured import Measures
from restitution.workings.naming.multiples import measured_meanings
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sources import Sources
from restitution.workings.reasons.along_units import along_its_unit
from restitution.workings.reasons.before_walls import walls_ahead
from restitution.workings.reasons.definite_sums import definite_sums
from restitution.workings.reasons.equality import equal_tangents
from restitution.workings.reasons.every_value import between_its_ends, every_positive_value
from restitution.workings.reasons.factors import factor_cancelled
from restitution.workings.reasons.grounds import (
    angle_acute_by,
    grounds_of,
    motion_of,
)
from restitution.workings.reasons.growth_reasons import GrowthReasons
from restitution.workings.reasons.later_times import later_than
from restitution.workings.reasons.multipliers import multipliers_of
from restitution.workings.reasons.plain_signs import (
    bound_in_words,
    bounds_said,
)
from restitution.workings.reasons.positive import PositiveReasons
from restitution.workings.reasons.pythagoras import (
    OF_VALUES,
    is_by_pythagoras,
    pythagoras,
    square_by_the_tangent,
)
from restitution.workings.reasons.quotients import top_of_a_bound, top_of_a_sign
from restitution.workings.reasons.rejected_roots import (
    bound_of_a_quadratic,
    bound_of_a_ratio,
    made_of_a_root,
)
from restitution.workings.reasons.right_angles import RightAngles
from restitution.workings.reasons.shape_reasons import DOWN, UP, ZERO
from restitution.workings.reasons.shares import bounded_factors
from restitution.workings.reasons.signs_of_factors import signs_of_factors
from restitution.workings.reasons.together import with_acute_angles_together

_REASONED = frozenset({"reject", "sign", "compare", "cancel", "divide", "monotone", "inverse"})
_BEHIND = {
    "derived.fact-equal": 1,
    "derived.it-is": 2,
    "derived.from": 2,
    "derived.to": 2,
    "derived.from-to": 2,
}
Words = tuple[Sentence | lay.Layout, ...]


class Reasons(PositiveReasons):
    """The reasons of the lines of one derivation.

    ``shared`` are those of the same lines in other letters.
    """

    def __init__(
        self,
        derivation: Derivation,
        naming: Naming,
        problem: Problem,
        sources: Sources,
        shared: Reasons | None = None,
    ) -> None:
        super().__init__(derivation, naming, problem)
        self._sources = sources
        poles = shared._right_angles.poles if shared else None
        self._right_angles: RightAngles = RightAngles(derivation, naming, self._roles, poles)
        measures = Measures(problem, measured_meanings(derivation))
        self._growth = GrowthReasons(
            derivation, naming, self._roles, self._shapes, self._reason, measures
        )

    def sign_by_a_bound(self, value: Expression) -> tuple[Sign, Link] | None:
        """That a component is positive, or not negative, by a bound of a coefficient."""
        return self._right_angles.sign_by_a_bound(value)

    def sign_of(self, value: Expression, line: Line) -> tuple[Sign, Relation | None] | None:
        """The sign of a component at a line, and the bound by which it has it."""
        return self._right_angles.sign_of(value, line)

    def right_angle_among(self, line: Line) -> Relation | None:
        """For which letters one of the angles of which a line makes another is a right one."""
        return self._right_angles.among(line)

    def of(self, line: Line) -> tuple[Sentence, ...]:
        """What a line rests on, to stand behind it, and which angle it tells to be acute."""
        angle = angle_acute_by(self._derivation, line)
        more = () if angle is None else (say("derived.so-acute", angle=self._naming.layout(angle)),)
        every = every_positive_value(self._derivation, self._roles, line)
        if every is not None:
            more = (say("derived.every-positive", angle=self._naming.layout(every)),)
        between = between_its_ends(self._derivation, self._roles, line)
        if between is not None:
            goes, first, last = (self._naming.layout(tree) for tree in between)
            more = (say("derived.every-between", angle=goes, first=first, last=last),)
        return (*map(with_acute_angles_together, self._of(line)), *more)

    def _of(self, line: Line) -> tuple[Sentence, ...]:
        """What a line rests on."""
        alone = self._alone(line)
        if alone is not None:
            return alone
        grounds = tuple(map(self._ground, grounds_of(self._derivation, self._roles, line)))
        if line.move.record == "turned":
            grounds = grounds or tuple(self._side_of_a_blow(line))
            return (say("derived.as", reasons=grounds),) if grounds else ()
        multipliers = map(self._layout, multipliers_of(self._derivation, self._roles, line))
        if multiplied := tuple(multipliers):
            return (say("derived.as", reasons=(*grounds, *multiplied)),)
        if not self._is_reasoned(line) and not self._of_sizes(line) and not grounds:
            return ()
        if line.move.id == "cancel" and factor_cancelled(self._derivation, line) is not None:
            return ()  # the words before the line say it
        if self.is_own_range(line):
            return tuple(self._as_it_is(line))
        cited = [self._shapes.relation_of(ref) for ref in line.premises]
        top = top_of_a_bound(line, cited)
        if top is not None and not grounds and self.known(line):
            return (say("derived.as", reasons=(self._layout(top),)),)
        would = made_of_a_root(self._derivation, self._naming, self._sources, line)
        if would is not None:
            return (say("derived.as", reasons=(would,)),)
        reasons = self._with_what_no_premise_says(line, self._of_premises(line, cited), grounds)
        return self._in_words(line, (*(e for e in grounds if e not in reasons), *reasons))

    def _side_of_a_blow(self, line: Line) -> Iterator[Sentence]:
        """To which side of **i** an impulse, and so the velocity after it, is by its angle."""
        bounds = self.known(line)
        match line.relation:
            case Relation(((*_, Link(right=velocity)),)) if (
                bounds and f"impulse {line.move.event}" in line.premises
            ):
                parts = coordinates(velocity)
                down = parts is not None and isinstance(parts[1], Negate)
                axis = Negate(Unit("j")) if down else Unit("j")
                side = self._naming.layout(axis)
                yield say("derived.side-of-blow", axis=side, bounds=tuple(bounds))

    def _alone(self, line: Line) -> tuple[Sentence, ...] | None:
        """A reason beside which no other is given: an identity, a right angle, or an order."""
        if is_by_pythagoras(line):
            identity = pythagoras(self._derivation, line)
            if identity is not None:
                return (say("derived.as", reasons=(self._layout(identity),)),)
            return (say("derived.pythagoras"),)
        by_the_tangent = square_by_the_tangent(self._derivation, line)
        if by_the_tangent is not None:
            return (say("derived.as", reasons=(self._layout(by_the_tangent),)),)
        if self._by_the_double_angle(line):
            return (say("derived.double-angle"),)
        vertical = self._right_angles.of(line)
        if vertical:
            known = self.known(line) if self._of_sizes(line) else ()
            return (say("derived.as", reasons=known), *vertical) if known else vertical
        bound = bound_of_a_quadratic(self._derivation, self._roles, line)
        if bound is not None:
            return (say("derived.as", reasons=(self._layout(bound),)),)
        since = later_than(self._derivation, self._naming, line)
        if since is not None:
            return (since,)
        ahead = tuple(
            say("derived.not-yet", body=body, wall=wall, bound=self._layout(bound))
            for body, wall, bound in walls_ahead(self._derivation, self._naming.problem, line)
        )
        if ahead:
            return ahead
        if bounds := tuple(self._bounds_of_a_speed(line)):
            return (say("derived.as", reasons=bounds),)
        shares = tuple(map(self._layout, bounded_factors(self._derivation, line, self._roles)))
        if shares:
            return (say("derived.as", reasons=shares),)
        tangents = equal_tangents(self._derivation, line)
        if tangents is None:
            return None
        return (say("derived.as", reasons=(self._layout(tangents),)),)

    def _bounds_of_a_speed(self, line: Line) -> Iterator[lay.Layout]:
        """The bounds of letters by which one component has a sign, where a speed is its size."""
        if line.move.record != "speed":
            return
        for own in self._derivation.lines_in(line.premises):
            match own.relation:
                case Relation(((Link(Letter(), "<" | "<=" | ">" | ">="),),)) as bound:
                    yield self._layout(bound)

    def _is_reasoned(self, line: Line) -> bool:
        """Whether a line is one of those behind which a reason stands."""
        return (
            line.move.id in _REASONED
            or self._ordered(line)
            or self._is_root(line)
            or any(self._cleared(line))
            or any(self._dropped(line))
            or self._by_its_sense(line)
            or self._in_its_case(line)
            or self._divided_by_ratios(line)
            or self._divided_by_a_ratio(line)
        )

    def _of_premises(self, line: Line, cited: Sequence[Relation | None]) -> Words:
        """How a quantity grows, what is known of letters, and which factors are positive."""
        reasons = (
            *self._growth.between_ends(line),
            *self._growth.at_its_end(line),
            *self._shapes.of(line),
            *map(self._layout, filter(None, (top_of_a_sign(line, cited),))),
            # That a sum is positive, its letters show.
            *(() if any(self._dropped(line)) else self._known_beside_a_square(line)),
            *self._silent(line),
            *self._definite(line),
            *self._cleared(line),
            *self._dropped(line),
            *self._divided_by(line),
        )
        # Behind what is known of a letter stand where an equality holds, and the value at its end.
        return tuple(sorted(reasons, key=lambda e: _BEHIND.get(getattr(e, "id", ""), 0)))

    def _known_beside_a_square(self, line: Line) -> Words:
        """What is known of letters, but for the bounds of a coefficient whose square says them."""
        square = self._shapes.square_of_a_coefficient(line)
        if square is None:
            return self.known(line)
        assert isinstance(square.left, Binary)
        name = self._naming.layout(square.left.left)
        return tuple(
            reason
            for reason in self.known(line)
            if not (isinstance(reason, lay.Relation) and name in reason.operands)
        )

    def _definite(self, line: Line) -> Iterator[Sentence | lay.Layout]:
        """Which quadratics have one sign throughout, and by what."""
        for tree, relation, by_discriminant in definite_sums(self._derivation, line, self._roles):
            worth = self._layout(relation)
            own = say("no-root.definite", sum=self._naming.layout(tree), discriminant=worth)
            yield own if by_discriminant else worth

    def _with_what_no_premise_says(self, line: Line, reasons: Words, grounds: Words) -> Words:
        """The reasons, or where there are none what a reader sees of signs, roots and units."""
        reasons = reasons or tuple(self._positive_sum(line)) or tuple(self._positive_ratio(line))
        reasons = reasons or tuple(self._both_squared(line)) or tuple(self._compared(line))
        if self._is_root(line):
            reasons = reasons or tuple(self._given_ranges(line))
        if line.move.id == "inverse" and not _is_of_a_sum(line):
            # An angle of up to 90° is what the arc functions give.
            reasons = () if grounds else self._beyond_a_right_angle(line, reasons)
        if (
            not reasons
            and (unit := along_its_unit(self._derivation, self._naming, line)) is not None
        ):
            reasons = () if grounds else (unit,)
        if line.move.id == "reject" and (not reasons or self._by_its_own_sign(line)):
            reasons = (*self._positive(line), *reasons)
        if line.move.id == "reject" and not reasons:
            bound = bound_of_a_ratio(self._derivation, line)
            reasons = () if bound is None else (self._layout(bound),)
        return reasons

    def _in_words(self, line: Line, reasons: Words) -> tuple[Sentence, ...]:
        """The reasons as one sentence, with the signs of factors and bounds in words."""
        signs = tuple(map(self._layout, signs_of_factors(self._derivation, line, self._roles)))
        if signs and reasons:
            return (say("derived.as-because", reasons=signs, causes=reasons),)
        if reasons and self._by_a_cotangent(line):
            reasons = (say("derived.cotangent"), *reasons)
        own = {self._layout(relation): relation for relation in bounds_said(line)}
        words = (
            bound_in_words(own[e], self._roles, self._naming) if e in own else e for e in reasons
        )
        reasons = tuple(dict.fromkeys(word for word in words if word is not None))
        return (say("derived.as", reasons=reasons),) if reasons else ()

    def _in_its_case(self, line: Line) -> bool:
        """Whether a line rests on the condition under which a range has its form."""
        facts = self._derivation.facts_in(line.premises)
        return any(fact.kind == "case" for fact in facts)

    @staticmethod
    def _divided_by_ratios(line: Line) -> bool:
        """Whether an inequality is divided by ratios of angles, whose signs their ranges tell."""
        assert isinstance(line.relation, Relation)
        signs = {link.sign for links in line.relation.options for link in links}
        of_angles = any(str(ref).startswith("acute:") for ref in line.premises)
        return line.move.id == "rearrange" and bool(signs & {*UP, *DOWN}) and of_angles

    @staticmethod
    def _divided_by_a_ratio(line: Line) -> bool:
        """Whether sin² + cos² = 1 leaves a factor of an equation that is not zero by its angle."""
        of_angles = any(str(ref).startswith("acute:") for ref in line.premises)
        return line.move.id == "identity" and line.move.record == "pythagoras" and of_angles

    def _by_a_cotangent(self, line: Line) -> bool:
        """Whether the bounds of an angle come of those of its cotangent, which falls."""
        if line.move.id != "compare":
            return False
        cited = self._derivation.lines_in(line.premises)
        return any(
            isinstance(own.relation, Relation)
            and any(
                is_function(side, "cot") and link.sign != "="
                for link in own.relation.options[0]
                for side in (link.left, link.right)
            )
            for own in cited
        )

    def _beyond_a_right_angle(
        self, line: Line, known: tuple[Sentence | lay.Layout, ...]
    ) -> tuple[Sentence | lay.Layout, ...]:
        """Why an angle of the statement is obtuse or more: a component has a sign, or its range."""
        assert isinstance(line.relation, Relation)
        link = line.relation.only[0]
        if not isinstance(link.left, Letter) or link.left.name in self._naming.meanings:
            return ()
        if not any(isinstance(e, Degrees) and e.value > 90 for e in walk(link.right)):
            return ()
        signs: list[Sentence | lay.Layout] = []
        for ref in line.premises:
            own = self._derivation.line(ref)
            match own.relation if own is not None else None:
                case Relation(((Link(Apply("cos"), "="), *_),)):
                    return ()  # it tells an angle of up to 180°
                case Relation(((Link(left, "=", right),),)):
                    sign = "<" if isinstance(right, Negate) else ">"
                    ratios = [Apply(ratio, link.left) for ratio in ("sin", "cos")]
                    for function in (e for e in ratios if e in set(walk(left))):
                        comparison = Link(function, sign, Number(Fraction(0)))  # type: ignore[arg-type]
                        signs.append(self._layout(Relation(((comparison,),))))
        return tuple(signs) or known

    @staticmethod
    def _by_the_double_angle(line: Line) -> bool:
        """Whether values that are put in are worked out by the formulae for the double angle."""
        assert isinstance(line.relation, Relation)
        steps = {link.by for links in line.relation.options for link in links}
        own = line.move.record == "double-angle" and line.move.id in OF_VALUES
        return own and "identity" in steps

    def _ground(self, relation: Relation) -> Sentence | lay.Layout:
        """A ground as a relation; of a component without a letter in words."""
        match relation.only:
            case (
                Link(Quantity("along", (Quantity("velocity") as velocity, Unit() as axis)), order),
            ) if order in ("<", ">"):
                name = "derived.negative-part" if order == "<" else "derived.positive-part"
                vector = self._naming.layout(velocity)
                return say(name, velocity=vector, axis=self._naming.layout(axis))
            case (Link(Quantity() as component, "<" | ">" as order, right),) if right == ZERO:
                name = "derived.negative" if order == "<" else "derived.above-zero"
                return say(name, component=self._naming.layout(component))
        return self._layout(relation)

    @staticmethod
    def _of_sizes(line: Line) -> bool:
        """Whether a size of a component is worked out, by what is known of angles."""
        assert isinstance(line.relation, Relation)
        sizes = any(
            is_function(node, "abs")
            for links in line.relation.options
            for link in links[1:]
            for node in walk(link.right)
        )
        return line.move.id == "define" and sizes

    def _is_root(self, line: Line) -> bool:
        """Whether of an equation of squares the roots are taken, which may have two signs."""
        above = [own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None]
        assert isinstance(line.relation, Relation)
        if line.move.id != "rearrange" or len(above) != 1 or len(line.relation.options) != 1:
            return False
        root = line.relation.only[0].left
        squares = (link.left for link in above[0].options[0])
        return any(square == Binary("^", root, Number(Fraction(2))) for square in squares)

    def _by_its_sense(self, line: Line) -> bool:
        """Whether a given speed is that of a component whose sense is given too."""
        facts = self._derivation.facts_in(line.premises)
        return line.move.record == "speed" and any(map(motion_of, facts))

    @staticmethod
    def _ordered(line: Line) -> bool:
        """Whether values were put into an inequality."""
        assert isinstance(line.relation, Relation)
        signs = {link.sign for links in line.relation.options for link in links}
        return line.move.id == "put" and bool(signs & {*UP, *DOWN})

    def is_own_range(self, line: Line) -> bool:
        """Whether a line only says what a letter may be anyway: all its values are possible."""
        assert isinstance(line.relation, Relation)
        reasons = self.known(line) if line.move.id in ("sign", "compare") else ()
        return reasons == (self._layout(line.relation),)

    def _as_it_is(self, line: Line) -> Iterator[Sentence]:
        """What holds of any coefficient of restitution, where no more than that is to be shown."""
        assert isinstance(line.relation, Relation)
        shown = any(end.line == line.number and end.shown for end in self._derivation.items)
        match line.relation.options:
            case ((Link(Letter(name), ">=" | "<=" as sign, Number()),),) if shown:
                if name in self._roles and self._roles[name].kind == "restitution":
                    bound = "derived.not-negative" if sign == ">=" else "derived.at-most-one"
                    yield say("derived.as", reasons=(say(bound),))


def _is_of_a_sum(line: Line) -> bool:
    """Whether a line says what a sum of angles comes to."""
    match line.relation:
        case Relation(((Link(Binary("+" | "-"), "="), *_),)):
            return True
    return False
