"""What a line rests on besides equations: *as α is acute*, *as 0 ≤ e ≤ 1*."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

import sympy as sp

from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Ref,
    Relation,
    Sign,
    equality,
)
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Quantity,
    Unit,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.planning.writing.forms import factors
from restitution.planning.writing.inequalities import turned
from restitution.problem import Problem
from restitution.render import layout as lay
from restitution.solving.story.letters import roles
from restitution.workings.naming.measured import Measures
from restitution.workings.naming.quantities import Naming
from restitution.workings.naming.sources import Sources
from restitution.workings.reasons.along_units import along_its_unit
from restitution.workings.reasons.before_walls import wall_reached, walls_ahead
from restitution.workings.reasons.equality import divisor_left_out, equal_tangents
from restitution.workings.reasons.every_value import every_positive_value
from restitution.workings.reasons.factors import factor_cancelled, factor_left, positive_factor_left
from restitution.workings.reasons.grounds import (
    acute_by_its_tangent,
    angle_acute_by,
    compared_quantities,
    grounds_of,
    motion_of,
)
from restitution.workings.reasons.growth_reasons import GrowthReasons
from restitution.workings.reasons.half_angles import half_of_an_acute
from restitution.workings.reasons.later_times import later_than
from restitution.workings.reasons.multipliers import cleared_factors, multipliers_of
from restitution.workings.reasons.plain_signs import (
    are_squares,
    bound_in_words,
    bounds_said,
    positive_letters,
    signs_in_a_sum,
)
from restitution.workings.reasons.pushed import pushed_away
from restitution.workings.reasons.pythagoras import pythagoras
from restitution.workings.reasons.quotients import top_of_a_bound, top_of_a_sign
from restitution.workings.reasons.rejected_roots import made_of_a_root, root_on_a_rim
from restitution.workings.reasons.right_angles import RightAngles
from restitution.workings.reasons.shape_reasons import DOWN, UP, ZERO, ShapeReasons
from restitution.workings.reasons.signs_of_factors import signs_of_factors
from restitution.workings.reasons.together import merged, with_acute_angles_together

_REASONED = frozenset({"reject", "sign", "compare", "cancel", "monotone", "inverse"})
_BY_TANGENT = "derived.acute-by-tangent"
_BEHIND = {"derived.fact-equal": 1, "derived.it-is": 2}
_OF_SQUARES = frozenset({"speed", "size", "energy", "energy-ratio", "total", "tan-deflection"})
_OF_VALUES = frozenset({"put", "rearrange", "square-add"})


class Reasons:
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
        self._derivation = derivation
        self._sources = sources
        self._roles = roles(problem)
        self._naming = naming
        self._shapes = ShapeReasons(derivation, naming, self._roles)
        poles = shared._right_angles.poles if shared else None
        self._right_angles: RightAngles = RightAngles(derivation, naming, self._roles, poles)
        measures = Measures(problem, derivation.meanings)
        self._growth = GrowthReasons(
            derivation, naming, self._roles, self._shapes, self._reason, measures
        )

    def is_positive(self, name: str) -> bool:
        """Whether a letter of the statement is positive for all that it may be."""
        role = self._roles.get(name)
        return role is not None and role.symbol(name).is_positive is True

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
        return (*map(with_acute_angles_together, self._of(line)), *more)

    def _of(self, line: Line) -> tuple[Sentence, ...]:
        """What a line rests on."""
        if self._by_pythagoras(line):
            identity = pythagoras(self._derivation, line)
            if identity is not None:
                return (say("derived.as", reasons=(self._laid(identity),)),)
            return (say("derived.pythagoras"),)
        if self._by_the_double_angle(line):
            return (say("derived.double-angle"),)
        vertical = self._right_angles.of(line)
        if vertical:
            known = self._known(line) if self._of_sizes(line) else ()
            return (say("derived.as", reasons=known), *vertical) if known else vertical
        since = later_than(self._derivation, self._naming, line)
        if since is not None:
            return (since,)
        ahead = tuple(
            say("derived.not-yet", body=body, wall=wall, bound=self._laid(bound))
            for body, wall, bound in walls_ahead(self._derivation, self._naming.problem, line)
        )
        if ahead:
            return ahead
        tangents = equal_tangents(self._derivation, line)
        if tangents is not None:
            return (say("derived.as", reasons=(self._laid(tangents),)),)
        grounds = tuple(map(self._ground, grounds_of(self._derivation, self._roles, line)))
        if line.move.record == "turned":
            return (say("derived.as", reasons=grounds),) if grounds else ()
        multipliers = map(self._laid, multipliers_of(self._derivation, self._roles, line))
        if multiplied := tuple(multipliers):
            return (say("derived.as", reasons=(*grounds, *multiplied)),)
        reasoned = line.move.id in _REASONED or self._ordered(line) or self._is_root(line)
        reasoned = reasoned or any(self._cleared(line)) or any(self._dropped(line))
        reasoned = reasoned or self._by_its_sense(line) or self._in_its_case(line)
        reasoned = reasoned or self._divided_by_ratios(line) or self._divided_by_a_ratio(line)
        if not reasoned and not self._of_sizes(line) and not grounds:
            return ()
        if line.move.id == "cancel" and factor_cancelled(self._derivation, line) is not None:
            return ()  # the words before the line say it
        if self.is_own_range(line):
            return tuple(self._as_it_is(line))
        cited = [self._shapes.relation_of(ref) for ref in line.premises]
        top = top_of_a_bound(line, cited)
        if top is not None and not grounds and self._known(line):
            return (say("derived.as", reasons=(self._laid(top),)),)
        would = made_of_a_root(self._derivation, self._naming, self._sources, line)
        if would is not None:
            return (say("derived.as", reasons=(would,)),)
        reasons = (
            *self._growth.between_ends(line),
            *self._growth.at_its_end(line),
            *self._shapes.of(line),
            *map(self._laid, filter(None, (top_of_a_sign(line, cited),))),
            # That a sum is positive, its letters show.
            *(() if any(self._dropped(line)) else self._known(line)),
            *self._silent(line),
            *self._cleared(line),
            *self._dropped(line),
            *self._divided_by(line),
        )
        # Behind what is known of a letter stand where an equality holds, and the value at its end.
        reasons = tuple(
            sorted(reasons, key=lambda reason: _BEHIND.get(getattr(reason, "id", ""), 0))
        )
        reasons = reasons or tuple(self._positive_sum(line)) or tuple(self._positive_ratio(line))
        reasons = reasons or tuple(self._both_squared(line))
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
        if line.move.id == "reject" and not reasons:
            reasons = tuple(self._positive(line))
        reasons = (*(each for each in grounds if each not in reasons), *reasons)
        signs = tuple(map(self._laid, signs_of_factors(self._derivation, line, self._roles)))
        if signs and reasons:
            return (say("derived.as-because", reasons=signs, causes=reasons),)
        if reasons and self._by_a_cotangent(line):
            reasons = (say("derived.cotangent"), *reasons)
        own = {self._laid(relation): relation for relation in bounds_said(line)}
        words = (
            bound_in_words(own[e], self._roles, self._naming) if e in own else e for e in reasons
        )
        reasons = tuple(word for word in words if word is not None)
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
                        signs.append(self._laid(Relation(((comparison,),))))
        return tuple(signs) or known

    @staticmethod
    def _by_pythagoras(line: Line) -> bool:
        """Whether a sum of squares is worked out by sin² + cos² = 1."""
        assert isinstance(line.relation, Relation)
        steps = {link.by for links in line.relation.options for link in links}
        values = line.move.record in (None, "pythagoras") and line.move.id in _OF_VALUES
        return (values or line.move.record in _OF_SQUARES) and "identity" in steps

    @staticmethod
    def _by_the_double_angle(line: Line) -> bool:
        """Whether values that are put in are worked out by the formulae for the double angle."""
        assert isinstance(line.relation, Relation)
        steps = {link.by for links in line.relation.options for link in links}
        own = line.move.record == "double-angle" and line.move.id in _OF_VALUES
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
        return self._laid(relation)

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
        reasons = self._known(line) if line.move.id in ("sign", "compare") else ()
        return reasons == (self._laid(line.relation),)

    def _as_it_is(self, line: Line) -> Iterator[Sentence]:
        """What holds of any coefficient of restitution, where no more than that is to be shown."""
        assert isinstance(line.relation, Relation)
        shown = any(end.line == line.number and end.shown for end in self._derivation.items)
        match line.relation.options:
            case ((Link(Letter(name), ">=" | "<=" as sign, Number()),),) if shown:
                if name in self._roles and self._roles[name].kind == "restitution":
                    bound = "derived.not-negative" if sign == ">=" else "derived.at-most-one"
                    yield say("derived.as", reasons=(say(bound),))

    def known(self, line: Line) -> tuple[Sentence | lay.Layout, ...]:
        """What is known of letters on which a line rests."""
        return self._known(line)

    def _known(self, line: Line) -> tuple[Sentence | lay.Layout, ...]:
        reasons: list[Sentence | lay.Layout] = []
        bounds: list[Link] = []
        own = [self._reason(ref, line) for ref in line.premises]
        cited = [e for ref in line.premises if (e := self._shapes.relation_of(ref)) is not None]
        for reason in (self._without_a_pole(line, each) for each in self._narrowed(own)):
            match reason:
                case Relation() as relation if half := half_of_an_acute(relation, cited):
                    slots = self._laid(half[0]), self._naming.layout(half[1])
                    reasons.append(say("derived.half-acute", bound=slots[0], angle=slots[1]))
                case Relation(options=((link,),)) if link.sign in (*UP, *DOWN):
                    bounds.append(link)
                case Relation() as relation:
                    reasons.append(self._laid(relation))
                case Sentence() as sentence:
                    reasons.append(sentence)
        strict = [self._where_it_divides(line, bound) for bound in bounds]
        for bound in [link for link in strict if link not in bounds]:
            letter = bound.left
            alone = sum(letter in (link.left, link.right) for link in strict) == 1
            reached = wall_reached(self._derivation, letter) if alone else None
            if reached is not None:
                strict.remove(bound)
                body, wall = reached
                positive = self._laid(Relation(((bound,),)))
                reasons.append(say("derived.reached", body=body, wall=wall, bound=positive))
        whole = (self._laid(relation) for relation in merged(strict))
        if any(isinstance(reason, Sentence) and reason.id == _BY_TANGENT for reason in reasons):
            # By the sign of that tangent the other angles have been used.
            reasons = [e for e in reasons if getattr(e, "id", "") != "derived.acute"]
        return (*reasons, *whole, *self._below(line, bounds))

    def _narrowed(
        self, reasons: Sequence[Sentence | Relation | None]
    ) -> Iterator[Sentence | Relation | None]:
        """Reasons in which a range of an angle ends at a closer bound of it: 0° ≤ δ ≤ 30°."""
        rest = list(reasons)
        for reason in reasons:
            match reason:
                case Relation(((low, Link(angle, "<=", Degrees(end))),)):
                    name = self._naming.layout(angle)
                case _:
                    continue
            for other in rest:
                match other:
                    case Relation(((Link(left, "<" | "<=" as sign, Degrees(bound)),),)):
                        if self._naming.layout(left) == name and bound < end:
                            rest.remove(other)
                            link = Link(angle, sign, Degrees(bound))
                            rest[rest.index(reason)] = Relation(((low, link),))
                            break
        yield from rest

    def _without_a_pole(
        self, line: Line, reason: Sentence | Relation | None
    ) -> Sentence | Relation | None:
        """A range of an angle up to 90°, which is less where a line that is cited has its tangent.

        A line that ends at 90° itself keeps the range as it is. A cotangent has no value at either
        end of a range from 0° to 180°.
        """
        cited = (own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None)
        nodes = {node for own in cited for tree in trees_of(own) for node in walk(tree)}
        match reason:
            case Relation(((low, Link(angle, "<=", Degrees(Fraction(numerator=90)) as end)),)):
                tangent = Apply("tan", angle)
            case Relation(((Link(low_, "<=", angle), Link(same, "<=", end)),)) if (
                low_,
                same,
                end,
            ) == (Degrees(Fraction(0)), angle, STRAIGHT_ANGLE) and Apply("cot", angle) in nodes:
                return Relation(((Link(low_, "<", angle), Link(angle, "<", end)),))
            case _:
                return reason
        if tangent not in nodes or end in set(self._ends_of(line)):
            return reason
        return Relation(((low, Link(angle, "<", end)),))

    @staticmethod
    def _ends_of(line: Line) -> Iterator[Expression]:
        """The sides of a line that compares."""
        assert isinstance(line.relation, Relation)
        for link in line.relation.options[0]:
            yield from (link.left, link.right)

    def _where_it_divides(self, line: Line, bound: Link) -> Link:
        """A bound of a letter that is divided by in what a line compares: it is not zero there."""
        if line.move.id != "monotone" or bound.sign != ">=" or bound.right != ZERO:
            return bound
        cited = [own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None]
        nodes = [node for own in cited for node in walk(own.only[-1].right)]
        below = [e.right for e in nodes if is_binary(e, "/")]
        divides = any(bound.left in factors(tree) for tree in below)
        return Link(bound.left, ">", bound.right) if divides else bound

    def _below(self, line: Line, bounds: Sequence[Link]) -> Iterator[Sentence | lay.Layout]:
        """That a letter is not zero, where it stands below a line and may be zero otherwise.

        Of a letter that is worked out there would be no value then.
        """
        assert isinstance(line.relation, Relation)
        match line.relation.options[0]:
            case (Link(Letter() as letter, ">", zero),) if zero == ZERO:
                if line.move.id != "sign" or Link(letter, ">=", ZERO) not in bounds:
                    return
                for ref in line.premises:
                    own = self._shapes.relation_of(ref)
                    nodes = () if own is None else walk(own.only[-1].right)
                    below = [e.right for e in nodes if is_binary(e, "/")]
                    if own is None or not any(letter in factors(tree) for tree in below):
                        continue
                    subject, zero_ = own.only[0].left, equality(letter, ZERO)
                    if isinstance(subject, Letter):
                        slots = self._naming.layout(subject), self._laid(zero_)
                        yield say("derived.no-value", letter=slots[0], bound=slots[1])
                    else:
                        yield self._laid(Relation(((Link(letter, "!=", ZERO),),)))
                    return

    def _reason(self, ref: Ref, line: Line) -> Sentence | Relation | None:
        """What is known of a letter, as a reader would say it."""
        if isinstance(ref, int):
            own = self._derivation.line(ref)
            if line.move.id != "reject" or own is None or not isinstance(own.relation, Relation):
                return None
            # A law stands above: that a root contradicts it is told by what bounds the root.
            known = own.move.id == "law" or self._offers(own.relation, line)
            # That bodies approach is a reason by itself.
            approach = any(str(premise).startswith("towards") for premise in line.premises)
            return None if known or approach else _by_its_ends(own.relation)
        fact = self._derivation.fact(ref)
        if fact is not None and line.move.id == "put":
            return None
        if fact is not None and fact == compared_quantities(self._derivation, line):
            return None  # it stands before the line
        if fact is not None:
            signs = {link.sign for links in fact.relation.options for link in links}
            ordered = signs and signs <= {*UP, *DOWN, "!="}
            motion = motion_of(fact)
            if motion is not None and (line.move.id == "reject" or line.move.record == "speed"):
                # That a sign is given by the direction of motion is said where it is used.
                body, direction = motion
                return say("derived.moving", body=body, way=self._naming.layout(direction))
            kind, _, number = fact.id.partition(" ")
            if kind == "order":
                return fact.relation
            if kind == "towards":
                body, wall = self._naming.events[int(number)].bodies
                if self._naming.bodies.get(wall) == "sphere":
                    return say("touch.towards", one=body, other=wall)
                return root_on_a_rim(self._derivation, self._naming, line, int(number))
            if line.move.id == "reject" and kind == "velocity":
                return pushed_away(self._derivation, self._naming, line, fact)
            if line.move.id == "reject" and fact.kind == "given" and signs == {"="}:
                return say("derived.given")
            if not ordered or fact.kind not in ("given", "range", "case"):
                return None
            match fact.relation:
                case Relation(((Link(Number(), _, Quantity()) as link,),)):
                    return Relation(((turned(link),),))
            return fact.relation
        head, colon, text = ref.partition(":")
        if colon and head.strip() == "acute":
            return self._acute(read_tree(text, self._naming.bodies))
        relation = read_relation(ref, self._naming.bodies)
        acute = acute_by_its_tangent(line, relation, map(self._shapes.relation_of, line.premises))
        if acute is None:
            return relation
        if any(angle_acute_by(self._derivation, other) == acute for other in self._cited(line)):
            return None  # the line with its tangent says it
        tangent = Relation(((Link(Apply("tan", acute), ">", ZERO),),))
        angle = self._naming.layout(acute)
        return say(_BY_TANGENT, bound=self._laid(tangent), angle=angle)

    def _cited(self, line: Line) -> Iterator[Line]:
        """The lines among the premises of one."""
        for ref in line.premises:
            own = self._derivation.line(ref)
            if own is not None:
                yield own

    def acute(self, angle: Letter) -> Sentence | None:
        """That an angle is acute, where its letter may be no other."""
        role = self._roles.get(angle.name)
        ends = None if role is None or role.kind != "angle" else (role.low, role.high, *role.closed)
        return self._acute(angle) if ends == (0, sp.pi / 2, False, False) else None

    def _acute(self, angle: Expression) -> Sentence:
        return say("derived.acute", angle=self._naming.layout(angle))

    @staticmethod
    def _offers(relation: Relation, line: Line) -> bool:
        """Whether a relation holds the alternatives of which a line keeps some."""
        assert isinstance(line.relation, Relation)
        return set(line.relation.options) < set(relation.options)

    def _laid(self, relation: Relation) -> lay.Layout:
        return self._naming.relation(relation)

    def _silent(self, line: Line) -> Iterator[lay.Layout]:
        """That a letter is positive, where a range begins with 0 that nothing else bounds."""
        assert isinstance(line.relation, Relation)
        if line.move.id != "compare":
            return
        match line.relation.options[0]:
            case (Link(left, "<", Letter(name) as letter), Link()) if left == ZERO:
                role = self._roles.get(name)
                if role is None or role.kind != "positive":
                    return
                for ref in line.premises:
                    if _bounds_below(self._shapes.relation_of(ref), letter):
                        return
                yield self._laid(Relation(((Link(letter, ">", ZERO),),)))

    def _cleared(self, line: Line) -> Iterator[lay.Layout]:
        """That the factors are positive by which an inequality is multiplied."""
        cited = [own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None]
        assert isinstance(line.relation, Relation)
        if any(divisor_left_out(relation, line.relation, self._roles) for relation in cited):
            return  # another reason says more
        yield from map(self._laid, cleared_factors(self._derivation, line, self.is_positive))

    def _dropped(self, line: Line) -> Iterator[lay.Layout]:
        """That a sum which was a factor of a product is not zero, or positive."""
        factor = factor_left(self._derivation, line)
        if factor is not None:
            yield self._laid(Relation(((Link(factor, "!=", ZERO),),)))
        positive = positive_factor_left(self._derivation, line, self._roles)
        if positive is not None:
            yield self._laid(Relation(((Link(positive, ">", ZERO),),)))

    def _divided_by(self, line: Line) -> Iterator[lay.Layout]:
        """That a ratio and 1 make something positive, below the value of which a sign is given."""
        assert isinstance(line.relation, Relation)
        match line.relation.options:
            case ((Link(left, sign, right),),) if (
                line.move.id == "put" and sign in (*UP, *DOWN) and right == ZERO
            ):
                standing = set(walk(left))
            case _:
                return
        for ref in line.premises:
            own = self._shapes.relation_of(ref) if isinstance(ref, int) else None
            match None if own is None or len(own.options) > 1 else own.only[-1].right:
                case Binary("/", _, below):
                    for factor in factors(below):
                        gone = isinstance(factor, Binary) and factor not in standing
                        if gone and _is_one_and_more(factor, self.is_positive):
                            yield self._laid(Relation(((Link(factor, ">", ZERO),),)))
                            return

    def _positive(self, line: Line) -> Iterator[Sentence]:
        """The silent reason: the letter stands for something positive, and for no component."""
        assert isinstance(line.relation, Relation)
        left = line.relation.options[0][0].left
        if not isinstance(left, Letter):
            return
        meaning = self._derivation.meanings.get(left.name)
        kind = None if meaning is None else getattr(meaning.quantity, "kind", None)
        component = kind in ("along", "across", "dot")
        if not component and (meaning is not None or self.is_positive(left.name)):
            yield say("derived.positive", letter=self._naming.layout(left))

    def _positive_sum(self, line: Line) -> Iterator[lay.Layout]:
        """The signs of letters by which a reader sees that a sum is positive."""
        cited = [self._shapes.relation_of(ref) for ref in line.premises]
        if line.move.id == "sign" and len(cited) == 1 and cited[0] is not None:
            yield from map(self._laid, signs_in_a_sum(cited[0], self._roles))

    def _positive_ratio(self, line: Line) -> Iterator[lay.Layout]:
        """That a letter is positive, of a ratio of an angle that is so by it."""
        cited = [self._shapes.relation_of(ref) for ref in line.premises]
        match line.relation:
            case Relation(((Link(Apply(), ">", right),),)) if right == ZERO and len(cited) == 1:
                pass
            case _:
                return
        if line.move.id == "sign" and cited[0] is not None:
            for letter in positive_letters(cited[0].options[0][-1].right, self._roles):
                yield self._laid(Relation(((Link(letter, ">", ZERO),),)))

    def _both_squared(self, line: Line) -> Iterator[Sentence]:
        """That both sides of an inequality may be squared."""
        assert isinstance(line.relation, Relation)
        cited = [own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None]
        squared = line.move.id == "compare" and len(cited) == 1
        if squared and are_squares(line.relation, cited[0], self._roles):
            yield say("derived.squared")

    def _given_ranges(self, line: Line) -> Iterator[lay.Layout]:
        """The ranges that the statement gives of the letters in a root, which tell its sign."""
        assert isinstance(line.relation, Relation)
        names = letters(line.relation.only[0].left)
        bounds = [
            link
            for fact in self._derivation.facts
            if fact.kind == "range" and len(fact.relation.options) == 1
            for link in fact.relation.only
            if link.sign in (*UP, *DOWN)
            and any(letters(side) & names for side in (link.left, link.right))
        ]
        yield from (self._laid(relation) for relation in merged(bounds))


def _bounds_below(relation: Relation | None, letter: Letter) -> bool:
    """Whether a relation says that a letter is more than something."""
    return relation is not None and any(
        (link.left == letter and link.sign in DOWN) or (link.right == letter and link.sign in UP)
        for links in relation.options
        for link in links
    )


def _by_its_ends(relation: Relation) -> Relation:
    """A chain of equations as the one of its first and its last side; any other as it is."""
    if len(relation.options) > 1 or any(link.sign != "=" for link in relation.only):
        return relation
    return equality(relation.only[0].left, relation.only[-1].right)


def _is_one_and_more(tree: Expression, is_positive: Callable[[str], bool]) -> bool:
    """Whether a tree is a number and a letter, each positive, added."""
    match tree:
        case Binary("+", Number(), Letter(name)) | Binary("+", Letter(name), Number()):
            return is_positive(name)
    return False


def _is_of_a_sum(line: Line) -> bool:
    """Whether a line says what a sum of angles comes to."""
    match line.relation:
        case Relation(((Link(Binary("+" | "-"), "="), *_),)):
            return True
    return False
