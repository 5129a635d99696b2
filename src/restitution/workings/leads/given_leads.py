"""The words before what is given: the fact, and what it says of a component or an angle."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.data.arrangement import turned
from restitution.explaining.data.offset_angles import offset_angle
from restitution.explaining.data.paths_and_lines import angle_between, turn_of_line
from restitution.explaining.definitions.ties import past_a_right_angle, tie_of
from restitution.explaining.lines.derivation import (
    Fact,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
    equality,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import rebuilt, trees_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_binary,
    is_component,
    is_quantity,
    is_zero,
    letters,
    unsigned,
    walk,
)
from restitution.render import layout as lay
from restitution.shapes import Circle
from restitution.solving.story.letters import roles
from restitution.workings.leads.component_leads import is_square
from restitution.workings.leads.leads import Leads
from restitution.workings.leads.lines_around import is_at_rest
from restitution.workings.leads.scalar_products import slope_title
from restitution.workings.leads.shapes_of_lines import is_over_a_ratio
from restitution.workings.naming.bold_letters import unit_vector
from restitution.workings.naming.facts import fact_in_words, velocity_given
from restitution.workings.naming.multiples import multiple_of
from restitution.workings.naming.sources import is_vector
from restitution.workings.reasons.later_times import between_impacts

# The sign of a component along **i**, of a direction beyond 90°.
_BEHIND: Mapping[str, SentenceId] = {"<": "given.behind", "<=": "given.not-ahead"}

# The sign of a component, by that with which its line compares it with zero.
_PARTS: Mapping[str, SentenceId] = {
    ">": "derived.positive-part",
    "<": "derived.negative-part",
}

# The sign of a scalar product, by that with which its line compares it with zero.
_PRODUCTS: Mapping[str, SentenceId] = {
    ">": "given.positive-product",
    "<": "given.negative-product",
    ">=": "given.no-negative-product",
    "<=": "given.no-positive-product",
}


# A fact with a body that moves along a line: whether it was at rest, and what the fact gives.
_FROM_REST: Mapping[tuple[bool, str], SentenceId] = {
    (True, "along"): "given.fact-from-rest",
    (False, "along"): "given.fact-along",
    (True, "square"): "given.square-to-from-rest",
    (False, "square"): "given.square-to",
    (True, "product"): "given.product-from-rest",
    (False, "product"): "given.product-along",
}


def _is_without_component(line: Line) -> bool:
    """Whether a line says that the component across a given direction is zero."""
    assert isinstance(line.relation, Relation)
    return line.move.record == "parallel" and is_zero(line.relation.options[0][-1].right)


def _tells_a_turn(fact: Fact) -> bool:
    """Whether a fact gives an angle of deflection."""
    return is_quantity(fact.relation.options[0][0].left, "deflection")


class GivenLeads(Leads):
    """All words before lines, those that take what is given among them."""

    def given(self, line: Line) -> tuple[Sentence, ...]:
        """The given fact that a definition turns into an equation."""
        facts = self._facts_turned(line) if line.move.id == "define" else []
        if line.move.record == "turned" and any(_tells_a_turn(fact) for fact in facts):
            self._given.update(fact.id for fact in facts)
            values = [fact for fact in facts if fact.relation.options[0][0].sign == "="]
            words = tuple(fact_in_words(self._naming, fact) for fact in values)
            side = slope_title(self._naming, line)
            if side is not None:
                return (say("given.facts", facts=words), side)
            return (say("given.turned", facts=words),)
        if len(facts) > 1 and line.move.record == "speed":
            self._given.update(fact.id for fact in facts)
            return (say("given.facts", facts=tuple(fact_in_words(self._naming, f) for f in facts)),)
        if len(facts) != 1:
            return ()
        (fact,) = facts
        if fact.id in self._given and is_over_a_ratio(line):
            return ()  # the title says what is divided by what
        self._given.add(fact.id)
        sentence = fact_in_words(self._naming, fact)
        # The first that fits is said: what comes before says more of a line than what comes after.
        for lead in (
            self._of_a_multiple,
            self._with_its_path,
            self._of_a_given_vector,
            self._of_a_sense_past,
            self._of_a_letter,
            self._of_a_component,
            self._of_a_product,
            self._along_a_line,
            self._of_energies,
            self._of_an_angle,
        ):
            sentences = lead(line, fact, sentence)
            if sentences is not None:
                return sentences
        offset = self._sine_of_an_offset(line)
        return (*offset, self._and_its_sense(line, sentence) or say("given.fact", fact=sentence))

    def _facts_turned(self, line: Line) -> list[Fact]:
        """The given facts that a line turns into an equation, without the values put in."""
        facts = [
            fact
            for ref in (*line.premises, *self._under_a_tie(line))
            if isinstance(ref, str)
            and (fact := self._derivation.fact(ref)) is not None
            and (fact.kind == "given" or (fact.kind == "range" and ref.startswith("given")))
            and (fact.id not in self._given or self._is_of_a_later_part(line, fact))
            and not _gives_a_mass(fact)
        ]
        if line.move.record in ("perpendicular", "parallel"):
            # What else is given is a value that is put in.
            facts = [
                fact
                for fact in facts
                for own in (self._opened(fact.relation.only[0]),)
                if tie_of(own) is not None or past_a_right_angle(own) is not None
            ]
        if line.move.record in ("sum", "difference", "energy-ratio", "fraction-lost"):
            # An angle of the data is a value too.
            facts = [fact for fact in facts if any(map(has_quantity, trees_of(fact.relation)))]
        return facts

    def _is_of_a_later_part(self, line: Line, fact: Fact) -> bool:
        """Whether a speed, or a share of an energy, is put in anew in a part: it is said again."""
        part = self._derivation.asked.get(line.item or "")
        return line.move.record in ("speed", "energy-ratio") and all(
            self._derivation.asked.get(own.item or "") != part
            for own in self._derivation.lines[: line.number - 1]
            if fact.id in own.premises
        )

    def _of_a_multiple(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """That a velocity is a number times a vector."""
        multiple = multiple_of(line)
        if multiple is None:
            return None
        letter = self._naming.layout(Letter(multiple))
        return (say("given.some-multiple", fact=sentence, letter=letter),)

    def _with_its_path(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """A turn with the slope of the path, a tangent with the body that moves along a line."""
        if (path := slope_title(self._naming, line)) is not None and line.move.record == "turned":
            return (say("given.and", fact=sentence), path)
        along = self._moving_along(line)
        if along is None or line.move.record != "tan":
            return None
        rested = self._rested(line, along)
        return (say(_FROM_REST[rested, "along"], fact=sentence, body=along),)

    def _rested(self, line: Line, body: str) -> bool:
        """Whether it is said on a line that a body was at rest before the event."""
        return self.tells_of_rest(body, line.move.event or 0, line)

    def _of_a_given_vector(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """A velocity that is given, and a direction at right angles to **i**."""
        match fact.relation.options[0][0]:
            case Link(Quantity("velocity", _, _), "=", right) if isinstance(sentence, lay.Layout):
                if not has_quantity(right):
                    return ()  # a velocity that is given is a datum
                resolved = self.resolved(line) if line.move.record == "component" else None
                if resolved is not None:
                    return (say("given.and", fact=sentence), resolved)
            case Link(Quantity("direction", (Name() as body,), stage), "=", angle) if is_square(
                angle
            ):
                velocity = self._naming.layout(Quantity("velocity", (body,), stage))
                axis = self._naming.layout(Unit("i"))
                return (say("given.direction", fact=sentence, velocity=velocity, axis=axis),)
        return None

    def _of_a_sense_past(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """The sign of a component or of a product, from an angle that is acute or obtuse."""
        first = fact.relation.options[0][0]
        opened = self._opened(first)
        past = past_a_right_angle(opened) if line.move.record == "perpendicular" else None
        if past is None:
            return None
        if is_quantity(opened.left, "direction"):
            velocity, axis = map(self._naming.layout, past[:2])
            return (say(_BEHIND[past[2]], fact=sentence, velocity=velocity, axis=axis),)
        if not isinstance(first.left, Letter):
            return None
        if not isinstance(past[1], Unit):
            return (say(_PRODUCTS[past[2]], fact=sentence, product=self._product_of(fact)),)
        part = _PARTS.get(past[2])
        if part is None:
            return (say("derived.since", facts=(sentence,)),)
        velocity, axis = map(self._naming.layout, past[:2])
        signed = say(part, velocity=velocity, axis=axis)
        return (say("given.so-signed", fact=sentence, sign=signed),)

    def _of_a_letter(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """The value of a letter, which stands behind a line that has a title."""
        own = fact.relation.options[0][0].left
        if not isinstance(own, Letter) or isinstance(sentence, Sentence):
            return None
        if self.title(line) is None:
            return (say("derived.since", facts=(sentence,)),)
        of_the_motion = {
            fact.relation.only[0].right
            for fact in self._derivation.facts
            if fact.id.partition(" ")[0] == "let"
        }
        if own in of_the_motion or any(own in walk(tree) for tree in trees_of(line.relation)):
            self._behind[line.number] = say("derived.as", reasons=(sentence,))
        return ()  # any other is a value of the data, which is put in

    def _of_a_component(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """A component that a fact gives by its letter, by a right angle or by a turn."""
        assert isinstance(line.relation, Relation)
        record = line.move.record
        match fact.relation.options[0][0], line.relation.options[0]:
            case Link(Quantity("velocity"), "perpendicular to", Unit() as unit), (link,) if (
                record == "perpendicular" and is_zero(link.right)
            ):
                return (say("given.component", fact=sentence, axis=self._naming.layout(unit)),)
        by_angles = record in ("sum", "difference", "tan-from-axis")
        if by_angles and len(line.move.bodies) == 1:
            turned = self._turned(line)
            if turned is not None:
                return (say("given.and", fact=sentence), turned)
        if record == "perpendicular" and (pair := self._square_to_the_line(line)):
            name = _FROM_REST[self._rested(line, pair[0]), "square"]
            return (say(name, fact=sentence, one=pair[0], other=pair[1]),)
        left = line.relation.options[0][0].left
        if not isinstance(left, Letter) or _is_without_component(line):
            return None
        off = line.move.bodies[0] if record == "component" else None
        if off is not None and self._rested(line, off):
            return (say("given.fact-from-rest", fact=sentence, body=off),)
        return (say("given.fact", fact=sentence),)

    def _of_a_product(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """The scalar product of velocities at right angles, or past one."""
        if line.move.record != "perpendicular":
            return None
        assert isinstance(line.relation, Relation)
        first, last = line.relation.options[0][0], line.relation.options[0][-1]
        past = past_a_right_angle(self._opened(fact.relation.options[0][0]))
        if past is not None:
            return (say(_PRODUCTS[past[2]], fact=sentence, product=self._product_of(fact)),)
        if not is_zero(last.right) or is_component(first.left):
            return None
        mover = self._on_the_line(line) if is_binary(first.left, "*") else None
        if mover is None:
            return (self._product_is_zero(line, fact),)
        return (say(_FROM_REST[self._rested(line, mover), "product"], fact=sentence, body=mover),)

    def _along_a_line(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """A direction that is given: no component across it, or components in proportion."""
        if line.move.record != "parallel":
            return None
        assert isinstance(line.relation, Relation)
        nothing = _is_without_component(line)
        direction = fact.relation.options[0][0].right
        slants = is_binary(line.relation.options[0][0].left, "+", "-")
        other = _across(self._of_a_wall(direction)) or (turned(direction) if slants else None)
        if nothing and other is not None:
            return (say("given.component", fact=sentence, axis=self._naming.layout(other)),)
        if nothing and isinstance(direction, Name) and self._is_wall(direction.name):
            return (say("given.component-off", fact=sentence, wall=direction.name),)
        if nothing and is_quantity(line.relation.options[0][0].left, "along"):
            return (say("given.fact", fact=sentence),)
        straight = self._straight_on(line, sentence) if nothing else None
        return straight or (say("given.proportion", fact=sentence),)

    def _of_energies(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """What is given of energies, with the components or the mass that are left out."""
        if line.move.record in ("energy-lost", "energy-change") and not self._by_speeds(line):
            event = self._naming.events.get(line.move.event or 0)
            spheres = line.move.record == "energy-lost" and event is not None and not event.wall
            name: SentenceId = "given.by-those-that-change" if spheres else "given.by-what-changes"
            return (say("given.and", fact=sentence), say(name))
        if line.move.record not in ("energy-ratio", "fraction-lost"):
            return None
        if self._changes_by_one_component(line):
            return (say("given.fact-across-wall", fact=sentence),)
        return (say("given.fact-without-mass", fact=sentence),)

    def _of_an_angle(
        self, line: Line, fact: Fact, sentence: Sentence | lay.Layout
    ) -> tuple[Sentence, ...] | None:
        """An angle by its cosine or its tangent, with the body that moves along one line."""
        record = line.move.record
        if record == "round":
            chords = self._round_by_one_angle(line) or say("round.three")
            return (say("given.and", fact=sentence), chords)
        if record == "scalar-angle" and (lead := self._cosine_told(line, fact)):
            return lead
        if record not in ("tan", "tan-direction"):
            return None
        if record == "tan-direction" and (turned := self._turn_to_centres(line, fact)):
            velocity = self._naming.layout(
                Quantity("velocity", (Name(line.move.bodies[0]),), line.move.event)
            )
            return (say("given.turned-to-centres", fact=sentence, velocity=velocity, angle=turned),)
        if still := self._standing(line).get("along"):
            return (say("given.fact-across", fact=sentence, body=still),)
        along = record == "tan-direction" or self._moves_along(line)
        if along and self._rested(line, line.move.bodies[0]):
            return (say("given.fact-from-rest", fact=sentence, body=line.move.bodies[0]),)
        return None

    def _turn_to_centres(self, line: Line, fact: Fact) -> lay.Layout | None:
        """The angle of a path to a line of centres that slants, as it is worked out in degrees.

        ``30° + 45° = 75°`` of a path at 30° and a line at −45°. None where the line is by **i**.
        """
        axis = self._derivation.fact(f"axis {line.move.event}")
        turn = turn_of_line(axis) or self._turn_by_its_letter(line, axis)
        match line.relation, fact.relation:
            case (
                Relation(((Link(Apply("tan", Degrees() as angle), "="), *_),)),
                Relation(((Link(Quantity("direction"), "=", path),),)),
            ) if turn is not None:
                between = angle_between(path, turn)
            case _:
                return None
        if between is None:
            return self._naming.layout(angle)
        return self._naming.relation(equality(between, angle))

    def _turn_by_its_letter(self, line: Line, axis: Fact | None) -> Expression | None:
        """The angle from **i** of a line of centres by an offset, of which a line has the angle."""
        known = roles(self._naming.problem)
        own = None if axis is None else offset_angle(axis.relation.only[0], known)
        for cited in self._derivation.lines_in(line.premises):
            match cited.relation:
                case Relation(((Link(Letter(), "=", Degrees() as size),),)) if own is not None:
                    turn = own.turn(size)
                    if turn is not None:
                        return Degrees(turn) if turn >= 0 else Negate(Degrees(-turn))
        return None

    def _is_of_both_velocities(self, ref: Ref) -> bool:
        """Whether a fact is about two velocities, as those before and after an impact."""
        fact = self._derivation.fact(ref)
        trees = () if fact is None else trees_of(fact.relation)
        nodes = {node for tree in trees for node in walk(tree)}
        return sum(is_quantity(e, "velocity") for e in nodes) > 1

    def _straight_on(self, line: Line, fact: Sentence | lay.Layout) -> tuple[Sentence, ...] | None:
        """That a body keeps to one line in an impact, so that it has no component across."""
        event = self._naming.events.get(line.move.event or 0)
        if event is None or len(line.move.bodies) != 1:
            return None
        (body,) = line.move.bodies
        if event.wall:
            both = any(self._is_of_both_velocities(ref) for ref in line.premises)
            straight = say("given.straight-on", fact=fact, body=body, wall=event.bodies[-1])
            return (straight,) if both else None
        assert isinstance(line.relation, Relation)
        inside = letters(line.relation.only[0].left)
        along = any(
            isinstance(let := other.relation, Meaning)
            and let.letter in inside
            and is_quantity(let.quantity, "along")
            for other in self._derivation.lines
        )
        name: SentenceId = "given.off-the-line" if along else "given.along-the-line"
        return (say(name, fact=fact, body=body),)

    def _changes_by_one_component(self, line: Line) -> bool:
        """Whether energies at a straight wall differ by one component, the other has no line."""
        event = self._naming.events.get(line.move.event or 0)
        if event is None or not event.wall:
            return False
        above = (other for other in self._derivation.lines if other.number < line.number)
        stays = any(
            (line.move.record, line.move.event) == ("unchanged", event.number) for line in above
        )
        match line.relation:
            case Relation(((Link(Binary("-") as change, "="), *_),)) if not stays and not any(
                is_quantity(node, "speed") for node in walk(change)
            ):
                walls = {wall.name: wall for wall in self._naming.problem.walls}
                return not isinstance(walls[event.bodies[-1]].shape, Circle)
        return False

    def _product_of(self, fact: Fact) -> Sentence:
        """Which scalar product the sign of an angle tells: of a deflection, that of two times."""
        turn = getattr(self._opened(fact.relation.options[0][0]).left, "kind", None)
        return say("product.of-a-turn" if turn == "deflection" else "product.plain")

    def _product_is_zero(self, line: Line, given: Fact) -> Sentence:
        """That a scalar product is zero; of a wall that an angle gives, the vector along it too."""
        fact = fact_in_words(self._naming, given)
        for ref in line.premises:
            wall = self._derivation.fact(ref)
            match None if wall is None else wall.relation.options[0][0]:
                case Link(Quantity("direction", (Name(name),)), _, right) if not _has_vector(right):
                    along = unit_vector(right)
                case _:
                    continue
            if along is not None:
                whole = along.left if is_binary(along, "/") else along
                vector = self._naming.layout(whole)
                return say("given.product-by-wall", fact=fact, wall=name, vector=vector)
        return say("given.product", fact=fact, product=self._product_of(given))

    def _cosine_told(self, line: Line, fact: Fact) -> tuple[Sentence, ...]:
        """What is said before the cosine of a given angle between two velocities; else nothing."""
        assert isinstance(line.relation, Relation)
        match fact.relation.options[0][0].left:
            case Quantity("angle", (Quantity("velocity"), Quantity("velocity"))):
                sentence, cosine = (
                    fact_in_words(self._naming, fact),
                    line.relation.options[0][0].left,
                )
            case _:
                return ()
        if isinstance(cosine, Apply):
            return say("given.and", fact=sentence), say("given.by-the-product")
        if letters(cosine) or has_quantity(cosine):
            return ()
        worth = self._naming.layout(cosine)
        return (
            say("given.of-cosine", fact=sentence, cosine=worth),
            say("given.by-the-product"),
        )

    def _is_wall(self, name: str) -> bool:
        return self._naming.bodies.get(name) == "wall"

    def _of_a_wall(self, axis: Expression) -> Expression:
        """The direction that the statement gives a wall; any other direction as it is."""
        links = (fact.relation.options[0][0] for fact in self._derivation.facts)
        own = Quantity("direction", (axis,))
        return next((link.right for link in links if link.left == own), axis)

    def _and_its_sense(self, line: Line, fact: Sentence | lay.Layout) -> Sentence | None:
        """A given angle to a line, of which the tangent has a component of a certain sign below.

        Or a given speed of what has one component, which has a certain sign.
        """
        assert isinstance(line.relation, Relation)
        match line.relation.options[0]:
            case (Link(left, "=", Binary("/", _, below)), *_) if line.move.record == "tan":
                if letters(left):
                    return None
            case (Link(left, "=", below),) if line.move.record == "speed":
                pass
            case _:
                return None
        for own in map(self._cited, line.premises):
            match None if own is None else own.relation:
                case Relation((((Link(Letter(), "=") as first), *_),)) as relation:
                    known = self._reasons.sign_by_a_bound(below)
                    if relation.only[-1].right != below or known is None:
                        continue
                    sense = Relation(((Link(first.left, known[0], Number(Fraction(0))),),))
                    bound = self._naming.relation(Relation(((known[1],),)))
                    return say(
                        "given.fact-sense",
                        fact=fact,
                        sense=self._naming.relation(sense),
                        bound=bound,
                    )
        return None

    def given_before(self, line: Line) -> tuple[Sentence, ...]:
        """The given fact that says a velocity, before a law or components that take it.

        Before a place at a time, between which impacts that is.
        """
        between = between_impacts(self._derivation, self._naming, line)
        if between is not None:
            return (between,)
        velocities = self._velocities_read(line)
        if velocities:
            self._given |= {fact.id for fact in velocities}
            facts = tuple(velocity_given(self._naming, fact) for fact in velocities)
            return (say("given.facts", facts=facts),)
        put = self._lengths_put(line) if line.move.record == "straight-line" else []
        if put:
            self._given |= {fact.id for fact in put}
            return tuple(say("given.and", fact=fact_in_words(self._naming, fact)) for fact in put)
        for ref in line.premises if line.move.id == "law" else ():
            fact = self._derivation.fact(ref)
            if fact is None or fact.kind != "given" or fact.id in self._given:
                continue
            match fact.relation.options[0][0]:
                case Link(Quantity("velocity"), "=", right) if has_quantity(right):
                    self._given.add(fact.id)
                    words = fact_in_words(self._naming, fact)
                    own = self._component_of_multiple(fact)
                    if own is not None:
                        component, value = map(self._naming.layout, own)
                        slots = {"component": component, "value": value}
                        return (say("given.multiple", fact=words, **slots),)
                    return (say("given.and", fact=words),)
                case Link(Apply("sin" | "cos" | "tan", Letter()) as ratio, "=") if any(
                    ratio in walk(tree) for tree in trees_of(line.relation)
                ):
                    if isinstance(line.relation, Relation) and ratio not in walk(
                        line.relation.options[0][-1].right
                    ):
                        self._given.add(fact.id)  # its number is put in before the reader's eyes
                case Link(Apply("sin" | "cos" | "tan", Letter()), "="):
                    # Its number stands in the law, and no line says where that is from.
                    ratios = self._ratios_put(line)
                    self._given |= {given.id for given in ratios}
                    in_words = tuple(fact_in_words(self._naming, given) for given in ratios)
                    return (say("given.facts", facts=in_words),)
                case Link(Quantity("velocity", (Name(body),)), "=") if is_at_rest(fact):
                    self._given.add(fact.id)
                    return (say("given.rest", body=body),)
        return ()

    def _ratios_put(self, line: Line) -> list[Fact]:
        """The given ratios of angles of which a law has the numbers instead, unsaid so far."""
        put = []
        for fact in self._derivation.facts_in(line.premises):
            match fact.relation.options[0][0]:
                case Link(Apply("sin" | "cos" | "tan", Letter()) as ratio, "=") if not any(
                    ratio in walk(tree) for tree in trees_of(line.relation)
                ):
                    if fact.kind == "given" and fact.id not in self._given:
                        put.append(fact)
        return put

    def _lengths_put(self, line: Line) -> list[Fact]:
        """The given facts of which a line has the value of a letter in its place, unsaid so far."""
        facts = self._derivation.facts_in(line.premises)
        return [
            fact
            for fact in facts
            if fact.kind == "given" and fact.id not in self._given
            if isinstance(fact.relation.options[0][0].left, Letter)
            and fact.relation.options[0][0].sign == "="
        ]

    def _velocities_read(self, line: Line) -> list[Fact]:
        """The velocities that are given as vectors, of which lines of an impact read components.

        Where the vector stands in a line itself nothing is said of it.
        """
        own = self._velocities_in(line)
        if _has_vectors(line):
            self._given |= {fact.id for fact in own}
            return []
        stages = _stages(line)
        if not own and not stages:
            return []
        part = self._derivation.asked.get(line.item or "")
        together = [
            fact
            for other in self._derivation.lines
            if other.move.event == line.move.event
            and self._derivation.asked.get(other.item or "") == part
            and not _has_vectors(other)
            for fact in self._velocities_in(other)
            if own or _stage(fact) in stages
        ]
        read = {fact.id: fact for fact in (*own, *together)}
        return [read[name] for name in sorted(read)]

    def _velocities_in(self, line: Line) -> list[Fact]:
        """The velocities given as vectors from which a law takes components, not yet said."""
        if line.move.id != "law" and line.move.record != "component":
            return []
        read: list[Fact] = []
        for ref in line.premises:
            fact = self._derivation.fact(ref)
            if fact is None or fact.kind != "given" or fact.id in self._given or is_at_rest(fact):
                continue
            match fact.relation.options:
                case ((Link(Quantity("velocity"), "=", right),),) if not (
                    has_quantity(right) or any(isinstance(node, Polar) for node in walk(right))
                ):
                    read.append(fact)
        return read

    def _component_of_multiple(self, fact: Fact) -> tuple[Expression, Expression] | None:
        """A component along the line of centres and its value, of a multiple of a velocity."""
        link = fact.relation.options[0][0]
        for letter, meaning in self._naming.meanings.items():
            match meaning.quantity:
                case Quantity("along", (Quantity("velocity") as velocity, line)) if (
                    velocity in walk(link.right) and meaning.sense is None
                ):
                    own = rebuilt(
                        link.right,
                        lambda e: Letter(letter) if e == velocity else e,  # noqa: B023
                    )
                    if not has_quantity(own) and not _has_vector(own):
                        return Quantity("along", (link.left, line)), own
        return None

    def _opened(self, link: Link) -> Link:
        """A relation of a letter that the statement has for a quantity, said of the quantity."""
        named = {
            fact.relation.only[0].right: fact.relation.only[0].left
            for fact in self._derivation.facts
            if fact.kind == "data" and len(fact.relation.options) == 1
        }
        is_named = isinstance(link.left, Letter) and link.left in named
        return replace(link, left=named[link.left]) if is_named else link


def _gives_a_mass(fact: Fact) -> bool:
    """Whether a fact gives a mass, as those do that are data: it is put in without a word."""
    link = fact.relation.options[0][0]
    return is_quantity(link.left, "mass") and not has_quantity(link.right)


def _across(axis: Expression) -> Unit | None:
    """The other one of **i** and **j**."""
    own = unsigned(axis)
    return Unit("j" if own.axis == "i" else "i") if isinstance(own, Unit) else None


def _has_vector(tree: Expression) -> bool:
    return any(isinstance(node, Unit | Pair | Polar) for node in walk(tree))


def _has_vectors(line: Line) -> bool:
    """Whether vectors stand in a line."""
    return isinstance(line.relation, Relation) and any(map(is_vector, trees_of(line.relation)))


def _stage(fact: Fact) -> object:
    velocity = fact.relation.only[0].left
    return velocity.stage if isinstance(velocity, Quantity) else None


def _stages(line: Line) -> set[object]:
    """When the velocity is taken of which a line is a component; nothing of any other line."""
    if line.move.record != "component" or not isinstance(line.relation, Relation):
        return set()
    return {
        node.stage
        for node in walk(line.relation.options[0][0].left)
        if is_quantity(node, "velocity")
    }
