"""What is known of letters on which a line rests: their ranges, signs and angles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction

import sympy as sp

from restitution.explaining.lines.derivation import (
    BEARINGS,
    Derivation,
    Fact,
    Line,
    Link,
    Ref,
    Relation,
    Sign,
    equality,
    turned,
)
from restitution.explaining.lines.notation import read_relation, read_tree
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Polar,
    Quantity,
    is_binary,
    walk,
)
from restitution.planning.writing.forms import factors
from restitution.problem import Problem
from restitution.render import layout as lay
from restitution.solving.story.letters import roles
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.quantities import Naming
from restitution.workings.reasons.before_walls import wall_reached
from restitution.workings.reasons.excluded_zeros import excludes_zero, is_divided_by
from restitution.workings.reasons.grounds import (
    acute_by_its_tangent,
    angle_acute_by,
    compared_quantities,
    motion_of,
)
from restitution.workings.reasons.half_angles import half_of_an_acute
from restitution.workings.reasons.pushed import pushed_away
from restitution.workings.reasons.rejected_roots import root_on_a_rim
from restitution.workings.reasons.shape_reasons import DOWN, UP, ZERO, ShapeReasons
from restitution.workings.reasons.together import merged

_BY_TANGENT = "derived.acute-by-tangent"


class Known:
    """What is known of letters, as a reader would say it behind the lines of one derivation."""

    def __init__(self, derivation: Derivation, naming: Naming, problem: Problem) -> None:
        self._derivation = derivation
        self._naming = naming
        self._roles = roles(problem)
        self._shapes = ShapeReasons(derivation, naming, self._roles)

    def is_positive(self, name: str) -> bool:
        """Whether a letter of the statement is positive for all that it may be."""
        role = self._roles.get(name)
        return role is not None and role.symbol(name).is_positive is True

    def is_of_a_line(self, letter: Expression) -> bool:
        """Whether a letter tells where a line of centres, a wall or an impulse lies, and no speed.

        Which of several such lines is meant is then taken. The size of an impulse tells no line.
        """
        kinds: set[str] = set()
        for fact in self._derivation.facts:
            nodes = [node for tree in trees_of(fact.relation) for node in walk(tree)]
            if any(isinstance(node, Polar) and node.size == letter for node in nodes):
                return False
            if letter in nodes:
                kinds.add(fact.id.partition(" ")[0])
        return not kinds.isdisjoint({"axis", "wall", "impulse"}) and "velocity" not in kinds

    def known(self, line: Line) -> tuple[Sentence | lay.Layout, ...]:
        """What is known of letters on which a line rests."""
        reasons: list[Sentence | lay.Layout] = []
        bounds: list[Link] = []
        own = [self._reason(ref, line) for ref in line.premises]
        cited = [e for ref in line.premises if (e := self._shapes.relation_of(ref)) is not None]
        for reason in (self._without_a_pole(line, bound) for bound in self._narrowed(own)):
            match reason:
                case Relation() as relation if half := half_of_an_acute(relation, cited):
                    slots = self._layout(half[0]), self._naming.layout(half[1])
                    reasons.append(say("derived.half-acute", bound=slots[0], angle=slots[1]))
                case Relation(options=((link,),)) if link.sign in (*UP, *DOWN):
                    bounds.append(link)
                case Relation() as relation:
                    reasons.append(self._layout(relation))
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
                positive = self._layout(Relation(((bound,),)))
                reasons.append(say("derived.reached", body=body, wall=wall, bound=positive))
        whole = (self._layout(relation) for relation in merged(strict))
        if any(isinstance(reason, Sentence) and reason.id == _BY_TANGENT for reason in reasons):
            # By the sign of that tangent the other angles have been used.
            reasons = [e for e in reasons if getattr(e, "id", "") != "derived.acute"]
        return (*reasons, *whole, *self._below(line, bounds))

    def _narrowed(
        self, reasons: Sequence[Sentence | Relation | None]
    ) -> Iterator[Sentence | Relation | None]:
        """Reasons in which a range of an angle ends at a closer bound of it: 90° < δ ≤ 180°."""
        rest = [own for own in reasons if not any(self._is_within(e, own) for e in reasons)]
        for reason in tuple(rest):
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
                    case Relation(((Link(left, ">" | ">=" as sign, Degrees(bound)),),)):
                        if self._naming.layout(left) == name and bound < end:
                            rest.remove(other)
                            up = Link(Degrees(bound), "<" if sign == ">" else "<=", angle)
                            high = Link(angle, "<=", Degrees(end))
                            rest[rest.index(reason)] = Relation(((up, high),))
                            break
        yield from rest

    def _is_within(self, own: Sentence | Relation | None, other: object) -> bool:
        """Whether a range of an angle is that of another reason without its ends."""
        match own, other:
            case (
                Relation(((Link(low, "<", angle), Link(_, "<", high)),)),
                Relation(((Link(first, "<=", same), Link(_, "<=", last)),)),
            ):
                alike = self._naming.layout(angle) == self._naming.layout(same)
                return alike and (low, high) == (first, last)
        return False

    def _without_a_pole(
        self, line: Line, reason: Sentence | Relation | None
    ) -> Sentence | Relation | None:
        """A range of an angle up to 90°, which is less where a line that is cited has its tangent.

        A line that ends at 90° itself keeps the range as it is. A cotangent has no value at either
        end of a range from 0° to 180°.
        """

        def stands(ratio: Apply) -> bool:
            cited = (self._shapes.relation_of(ref) for ref in line.premises)
            trees = (tree for own in cited if own is not None for tree in trees_of(own))
            return any(node == ratio for tree in trees for node in walk(tree))

        match reason:
            case Relation(((low, Link(angle, "<=", Degrees(Fraction(numerator=90)) as end)),)):
                tangent = Apply("tan", angle)
            case Relation(((Link(low_, "<=", angle), Link(same, "<=", end)),)) if (
                low_,
                same,
                end,
            ) == (Degrees(Fraction(0)), angle, STRAIGHT_ANGLE) and stands(Apply("cot", angle)):
                return Relation(((Link(low_, "<", angle), Link(angle, "<", end)),))
            case _:
                return reason
        if not stands(tangent) or end in set(self._ends_of(line)):
            return reason
        return Relation(((low, Link(angle, "<", end)),))

    @staticmethod
    def _ends_of(line: Line) -> Iterator[Expression]:
        """The sides of a line that compares."""
        assert isinstance(line.relation, Relation)
        for link in line.relation.options[0]:
            yield from (link.left, link.right)

    def _where_it_divides(self, line: Line, bound: Link) -> Link:
        """A bound of a letter that is divided by in what a line compares: it is not zero there.

        Nor is a letter by which the line divides an inequality that would not hold where it is.
        """
        if bound.sign != ">=" or bound.right != ZERO:
            return bound
        cited = [own for ref in line.premises if (own := self._shapes.relation_of(ref)) is not None]
        if line.move.id == "monotone":
            divides = is_divided_by(bound.left, [own.only[-1].right for own in cited])
        else:
            divides = (
                line.move.id == "compare"
                and isinstance(bound.left, Letter)
                and isinstance(line.relation, Relation)
                and is_divided_by(bound.left, line.relation.trees)
                and excludes_zero(bound.left, cited, self._roles)
            )
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
                        slots = self._naming.layout(subject), self._layout(zero_)
                        yield say("derived.no-value", letter=slots[0], bound=slots[1])
                    else:
                        yield self._layout(Relation(((Link(letter, "!=", ZERO),),)))
                    return

    def _reason(self, ref: Ref, line: Line) -> Sentence | Relation | None:
        """What is known of a letter, as a reader would say it."""
        if isinstance(ref, int):
            own = self._derivation.line(ref)
            if line.move.id != "reject" or own is None or not isinstance(own.relation, Relation):
                return None
            # A law stands above: that a root contradicts it is told by what bounds the root.
            known = own.move.id == "law" or self._offers(own.relation, line)
            # That bodies approach is a reason by itself, and so is that one has a direction.
            approach = any(str(premise).startswith("towards") for premise in line.premises)
            bearing = any(
                _signs(fact) & BEARINGS for fact in self._derivation.facts_in(line.premises)
            )
            return None if known or approach or bearing else _by_its_ends(own.relation)
        fact = self._derivation.fact(ref)
        if fact is not None:
            return self._of_a_fact(fact, line)
        head, colon, text = ref.partition(":")
        if colon and head.strip() == "acute":
            tree = read_tree(text, self._naming.bodies)
            if line.move.id == "reject" and self.is_of_a_line(tree):
                return say("derived.taken-acute", angle=self._naming.layout(tree))
            return self._acute(tree)
        relation = read_relation(ref, self._naming.bodies)
        acute = acute_by_its_tangent(line, relation, map(self._shapes.relation_of, line.premises))
        if acute is None:
            return relation
        if any(angle_acute_by(self._derivation, other) == acute for other in self._cited(line)):
            return None  # the line with its tangent says it
        tangent = Relation(((Link(Apply("tan", acute), ">", ZERO),),))
        angle = self._naming.layout(acute)
        return say(_BY_TANGENT, bound=self._layout(tangent), angle=angle)

    def _not_at_rest(self, fact: Fact, line: Line) -> Sentence | None:
        """Who is not at rest as its velocity has a direction, of those whose velocity is cited."""
        cited = {
            own.relation.options[0][0].left
            for own in self._cited(line)
            if isinstance(own.relation, Relation)
        }
        for link in fact.relation.only:
            for side in (link.left, link.right):
                match side:
                    case Quantity("velocity", (Name(body),)) if side in cited:
                        return say("derived.not-at-rest", body=body)
        return None

    def _of_a_fact(self, fact: Fact, line: Line) -> Sentence | Relation | None:
        """What a fact of the statement tells; None where the words before the line say it."""
        if line.move.id == "put" or fact == compared_quantities(self._derivation, line):
            return None
        same = line.move.id == "compare" and fact.kind == "given"
        if same and any(own.relation == fact.relation for own in self._cited(line)):
            return None  # a line says that it holds anyway
        signs = _signs(fact)
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
        if line.move.id == "reject" and kind == "approach":
            one, other = self._naming.events[int(number)].bodies
            spheres = self._naming.bodies.get(other) == "sphere"
            return say("derived.approach" if spheres else "derived.comes", one=one, other=other)
        if line.move.id == "reject" and kind == "velocity":
            return pushed_away(self._derivation, self._naming, line, fact)
        if line.move.id == "reject" and signs & BEARINGS:
            return self._not_at_rest(fact, line)
        if line.move.id == "reject" and fact.kind == "given" and signs == {"="}:
            return say("derived.given")
        ordered = bool(signs) and signs <= {*UP, *DOWN, "!="}
        if not ordered or fact.kind not in ("given", "range", "case"):
            return None
        match fact.relation:
            case Relation(((Link(Number(), _, Quantity() as quantity),),)) | Relation(
                ((Link(Quantity() as quantity),),)
            ):
                if self._is_in_words(quantity):
                    words = fact_in_words(self._naming, fact)
                    return words if isinstance(words, Sentence) else fact.relation
        match fact.relation:
            case Relation(((Link(Number(), _, Quantity()) as link,),)):
                return Relation(((turned(link),),))
        return fact.relation

    def _is_in_words(self, quantity: Quantity) -> bool:
        """Whether a quantity has no letter: the speed of A."""
        return isinstance(self._naming.side(quantity), lay.Words | lay.Phrase)

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
        """That an angle is acute, in words."""
        return say("derived.acute", angle=self._naming.layout(angle))

    @staticmethod
    def _offers(relation: Relation, line: Line) -> bool:
        """Whether a relation holds the alternatives of which a line keeps some."""
        assert isinstance(line.relation, Relation)
        return set(line.relation.options) < set(relation.options)

    def _layout(self, relation: Relation) -> lay.Layout:
        """A relation as the working writes it."""
        return self._naming.relation(relation)


def _by_its_ends(relation: Relation) -> Relation:
    """A chain of equations as the one of its first and its last side; any other as it is."""
    if len(relation.options) > 1 or any(link.sign != "=" for link in relation.only):
        return relation
    return equality(relation.only[0].left, relation.only[-1].right)


def _signs(fact: Fact) -> set[Sign]:
    """The signs of the links of a fact."""
    return {link.sign for links in fact.relation.options for link in links}
