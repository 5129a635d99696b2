"""What stands before the rows of a line: its title, and how it comes from the lines above."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import Any

from restitution.exact import tidy
from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.laws.principles import RECORDS
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.saying import Sentence, say, slots_of
from restitution.explaining.lines.sentences import SentenceId
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    RIGHT_ANGLE,
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    Unit,
    has_quantity,
    is_binary,
    is_quantity,
    is_zero,
    letters,
    unsigned,
    walk,
)
from restitution.workings.leads.component_leads import ComponentLeads
from restitution.workings.leads.extremes import value_compared
from restitution.workings.leads.flights import chord_title, distance_title, flight_title
from restitution.workings.leads.offsets import (
    angle_of_offset,
    is_offset,
    offset_sentence,
)
from restitution.workings.leads.one_component import went_from_rest
from restitution.workings.leads.scalar_products import product_title, slope_title
from restitution.workings.leads.senses import sense_of_a_change, sense_of_a_normal
from restitution.workings.leads.shapes_of_lines import (
    body_read_off,
    ratio_below,
    read_off_lines,
    under_a_root,
)
from restitution.workings.leads.source_leads import SourceLeads
from restitution.workings.leads.touching import touching_beside
from restitution.workings.leads.turn_leads import BY, TurnLeads
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import worth
from restitution.workings.reasons.factors import cosine_divided, factor_cancelled
from restitution.workings.reasons.in_any_case import range_behind

TITLED = frozenset({"law", "define"})

_BY_RATIO: Mapping[str, SentenceId] = {
    "cos": "derived-speed.by-cos",
    "sin": "derived-speed.by-sin",
}
# That a body moves along the line of centres; with the reason, where it was at rest.
_ALONG = {False: "derived-speed.along", True: "derived-speed.along-from-rest"}


def _has_one_component(value: Expression) -> bool:
    """Whether a vector is zero, or has a component along **i** or **j** alone."""
    return is_zero(value) or len([node for node in walk(value) if isinstance(node, Unit)]) == 1


class Leads(SourceLeads, TurnLeads, ComponentLeads):
    """The words before the rows of one derivation, written from the top."""

    def _under_a_tie(self, line: Line) -> tuple[Ref, ...]:
        """What a velocity along a line rests on, where no line says what it has across that."""
        if line.move.record != "assemble":
            return ()
        above = [other for other in map(self._cited, line.premises) if other is not None]
        return tuple(
            ref
            for line in above
            if line.shown == "silent" and line.move.record in ("parallel", "perpendicular")
            for ref in line.premises
        )

    def behind(self, line: Line) -> tuple[Sentence, ...]:
        """The value of a letter that a definition puts in, which stands behind the line."""
        return (self._behind[line.number],) if line.number in self._behind else ()

    def _is_of_the_component_above(self, line: Line) -> bool:
        """Whether a velocity along **i** or **j** has the component that the line above says."""
        assert isinstance(line.relation, Relation)
        own = line.relation.options[0][0]
        above = self._printed_above(line)
        if above is None or not self._is_just_below(line) or not isinstance(own.left, Quantity):
            return False
        return (
            own.left.kind == "velocity"
            and _has_one_component(own.right)
            and isinstance(above.relation, Relation)
            and len(above.relation.options) == 1
            and isinstance(above.relation.only[0].left, Letter | Quantity)
        )

    def _by_a_multiple(self, line: Line) -> bool:
        """Whether a speed is read off a velocity that is a multiple of another."""
        above = [own.relation for own in map(self._cited, line.premises) if own is not None]
        return any(
            is_quantity(node, "velocity")
            for own in above
            if isinstance(own, Relation)
            for links in own.options
            for node in walk(links[-1].right)
        )

    def _about_directions(self, line: Line) -> Sentence | None:
        """How an angle is made, between what it is, or along which line a body moves."""
        if line.move.record == "scalar-angle":
            return product_title(self._derivation, self._naming, line)
        slope = slope_title(self._naming, line)
        return slope or self._turned(line) or self._along_the_line(line)

    def _by_speeds(self, line: Line) -> bool:
        """Whether a line rests on speeds or kinetic energies that are given or stand above."""
        lines = map(self._derivation.line, (ref for ref in line.premises if isinstance(ref, int)))
        facts = map(self._derivation.fact, (ref for ref in line.premises if isinstance(ref, str)))
        relations = (each.relation for each in (*lines, *facts) if each is not None)
        kinds = {
            node.kind
            for relation in relations
            if isinstance(relation, Relation)
            for node in walk(relation.options[0][0].left)
            if isinstance(node, Quantity)
        }
        if self._naming.bold.has_unit(line.move.event or 0) and "velocity" in kinds:
            # By velocities alone, along a line that slants, there is no component.
            return kinds <= {"velocity", "mass", "speed", "energy"}
        return not kinds.isdisjoint({"energy", "speed"})

    def title(self, line: Line) -> Sentence | None:
        """The principle or definition of a line; None where the line speaks for itself."""
        record = RECORDS.get(line.move.record or "")
        if line.move.id not in TITLED or record is None or self.resolves(line):
            return None
        if letter_of_offset(line) is not None:
            return None
        if record.id == "parallel" and (
            body_read_off(line)
            or read_off_lines(self._derivation, line)
            or self._seen(line)
            or self._since_nothing(line)
        ):
            return None
        if self._direction_again(line) is not None:
            return None
        if self._about_directions(line) is not None:
            return None
        event = self._naming.events.get(line.move.event or 0)
        bodies = line.move.bodies or (() if event is None else event.bodies)
        assert isinstance(line.relation, Relation)
        first, last = line.relation.options[0][0], line.relation.options[0][-1]
        if (kept := self.kept_speed(line, event)) is not None:
            return kept
        # What is lost in all is lost in the one impact.
        lost = record.id == "total-lost" and not self._naming.several and not self._by_speeds(line)
        name = (RECORDS["energy-lost"] if lost else record).title(event)
        if record.id == "straight-line" and line.move.bodies:
            return flight_title(self._derivation, self._naming, line)
        if record.id == "chord":
            return chord_title(self._derivation, line, "" if event is None else event.bodies[-1])
        if record.id == "distance":
            return distance_title(self._derivation, line)
        match record.id, first.left:
            case "momentum", _ if all(map(self._is_of_one, bodies)):
                name = "momentum.of-one"
            case "assemble", _ if self._under_a_tie(line):
                return None  # the given fact says so
            case "assemble", _ if self._goes_off(line):
                return say("derived-speed.along-from-rest", body=bodies[0])
            case "assemble", _ if self._is_of_the_component_above(line):
                return None
            case "assemble", Quantity("velocity", (Name(body),), _) if self._is_out_of_it(body):
                now = self._naming.events[self._naming.now or 0]
                return say("derived-assembled.still", body=body, event=self._naming.called(now))
            case "assemble", Quantity("velocity") if one := self._one_component(line):
                return None if self._in_one_line(event) else one
            case "assemble", Quantity("position", _, _) if self._is_below_its_coordinate(line):
                return None
            case "assemble", Quantity("position", _, _):
                name = "derived-place.title"
            case "impulse-vector", _ if (
                event is not None and event.kind == "impact" and self._by_components(line)
            ):
                name = RECORDS["impulse"].title(event)  # a component times its unit vector
            case "product", _ if wall := self._along_which(line):
                return say("derived-product.along", wall=wall)
            case "opposite-impulses", Quantity("impulse", (Name(body),)) if self._weighs(line):
                (other,) = (other for other in bodies if other != body)
                return say("derived-opposite.change", one=body, other=other)
            case "energy-ratio", Binary("/", Quantity(kind)) if kind in LOSSES:
                at_a_wall = event is not None and event.wall and not self._by_speeds(line)
                name = "fraction-lost.at-a-wall" if at_a_wall else "fraction-lost.title"
            case "energy-lost", _ if not any(isinstance(ref, int) for ref in line.premises):
                name = "derived-energy.title"  # by speeds of the data
            case "energy-lost", _ if self._by_speeds(line):
                name = "derived-energy.title"
            case "energy-lost", _ if event is not None and event.kind == "kick":
                name = "derived-energy.title"
            case "energy-lost" | "total-lost", _ if self._is_direct(event):
                name = "derived-energy.title"
            case "tan-deflection", Apply("cot"):
                name = "turned.products-over"
            case "perpendicular", _ if not is_zero(last.right) or self._squares(line):
                return None
            case "perpendicular", _ if last.sign in FLIPPED:
                return None
            case "round", Binary("*"):
                return say("round.title-same")
            case "speed", Binary("*"):
                return say("derived-speed.resolved", body=bodies[0])
            case "speed", _ if self._by_a_multiple(line):
                return None
            case "speed", Quantity() if self._is_read_off(line, first.right):
                return None  # it is given
            case "speed", Quantity() | Letter() if ratio := ratio_below(first.right):
                return say(_BY_RATIO[ratio], body=bodies[0])
            case "size", _ if not any(map(under_a_root, walk(first.right))):
                return None  # of one component it is read off
        if name is None:
            return None
        if record.id == "difference" and event is None:
            return say("turned.by-directions")
        if record.id == "along-the-change" and event is not None and not event.wall:
            rested = [body for body in bodies if self._is_given_off(line, body)]
            if rested:
                return say("moves-off.title", body=rested[0])
        if record.id in ("tan", "tan-direction") and event is not None and self._moves_along(line):
            rested_ = self.tells_of_rest(bodies[0], event.number, line)
            return say("moves-along.from-rest" if rested_ else "moves-along.title", body=bodies[0])
        if record.id == "speed" and (one := self._one_component(line)) is not None:
            return None if self._in_one_line(event) else one
        if self._by_products(line):
            return say("restitution.products")
        if record.id in ("restitution", "restitution-wall") and is_zero(last.right):
            return say("restitution.none")
        if name == "derived-speed.title" and self._naming.has_letter_of_the_question(first.left):
            name = "derived-speed.title-of"
        slots = {"body": bodies[:1], "wall": () if event is None else event.bodies[1:2]}
        return say(name, **{slot: slots[slot][0] for slot in slots_of(name)})

    def _by_components(self, line: Line) -> bool:
        """Whether a line rests on a component along the line of its impact."""
        for cited in map(self._cited, line.premises):
            match None if cited is None else cited.relation:
                case Meaning(_, Quantity("along", (_, Quantity("line_of_centres")))):
                    return True
                case Relation(
                    ((Link(Quantity("along", (_, Quantity("line_of_centres")))), *_), *_)
                ):
                    return True
        return False

    def _along_which(self, line: Line) -> str | None:
        """The wall to which a velocity is at right angles by a scalar product; None of another."""
        for other in self._derivation.lines:
            if line.number in other.premises and other.move.record == "perpendicular":
                walls = [ref.split() for ref in other.premises if isinstance(ref, str)]
                names = [name for kind, name in walls if kind == "wall"]
                if len(names) == 1:
                    return names[0]
        return None

    def _weighs(self, line: Line) -> bool:
        """Whether a mass of the data is under a line itself."""
        return any(isinstance(ref, str) and ref.split()[0] == "mass" for ref in line.premises)

    def _is_of_one(self, body: str) -> bool:
        """Whether a mass is the number 1, which no line writes."""
        fact = self._derivation.fact(" ".join(("mass", body)))
        return fact is not None and fact.relation.only[-1].right == Number(Fraction(1))

    def _moves_along(self, line: Line) -> bool:
        """Whether a direction is that of the line of centres, as there is no component across."""
        numbers = numbers_in(line.premises)
        lines = [own for ref in numbers if (own := self._derivation.line(ref))]
        event = self._naming.events.get(line.move.event or 0)
        relations = [line for line in lines if isinstance(line.relation, Relation)]
        if line.move.record == "tan" and len(relations) > 1:
            return False  # its components are put in
        return (
            event is not None
            and not event.wall
            and any(
                isinstance(relation.relation, Relation)
                and relation.move.record == "unchanged"
                and is_zero(relation.relation.options[0][-1].right)
                for relation in relations
            )
        )

    def _one_component(self, line: Line) -> Sentence | None:
        """How a body moves whose velocity has one component that is not zero."""
        assert isinstance(line.relation, Relation)
        numbers = numbers_in(line.premises)
        own = [e for e in map(self._cited, numbers) if e is not None]
        lasting = [e.relation.options[0] for e in own if isinstance(e.relation, Relation)]
        parts = [links[0].left for links in lasting if not is_zero(links[-1].right)]
        # A component that is still a letter may be anything.
        known = {links[0].left for links in lasting}
        still_open = [e.relation for e in own if isinstance(e.relation, Meaning)]
        parts += [e.quantity for e in still_open if Letter(e.letter) not in known]
        if len(parts) > 1:
            # Beside the velocity along **i** or **j** there is the letter for its component.
            whole = {links[0].left for links in lasting if _has_one_component(links[-1].right)}
            parts = [part for part in parts if part not in whole]
        right = line.relation.options[0][0].right
        if len(parts) != 1 or any(is_binary(e, "+") for e in under_a_root(right)):
            return None
        part = parts[0]
        if isinstance(part, Letter) and part.name in self._naming.meanings:
            part = self._naming.meanings[part.name].quantity
        match part:
            case Quantity(
                "along" | "across" as kind, (Quantity("velocity", (Name(body),), stage), axis)
            ):
                event = self._naming.event_of_axis(axis)
                if event is None or event.wall:
                    return say("derived-speed.one", body=body)
                if kind == "across":
                    return say("derived-speed.across", body=body)
                rested = isinstance(stage, int) and self.tells_of_rest(body, stage, line)
                return say(_ALONG[rested], body=body)
        return None

    def _along_centres(self, line: Line, body: str) -> SentenceId:
        """What is said of a body that moves along the line of centres: why, where it is new."""
        assert isinstance(line.relation, Relation)
        own = line.relation.only[0].left
        stage = own.stage if isinstance(own, Quantity) else None
        return self._from_rest(line, body, stage)

    def _from_rest(self, line: Line, body: str, stage: object) -> SentenceId:
        rested = isinstance(stage, int) and self.tells_of_rest(body, stage, line)
        return "derived.along-centres-from-rest" if rested else "derived.along-centres"

    def _along_its_line(self, line: Line) -> Sentence | None:
        """That spheres move along lines of centres, where an angle is read off these."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Quantity("angle", (Quantity("velocity"), Quantity("line_of_centres", (), n))) if (
                n != line.move.event
            ):
                event = self._naming.called(self._naming.events[line.move.event or 0])
                return say("derived.along-earlier-centres", body=line.move.bodies[0], event=event)
        moving = read_off_lines(self._derivation, line)
        if len(moving) == 1:
            ((body, stage),) = moving
            return say(self._from_rest(line, body, stage), body=body)
        if moving:
            rested = [went_from_rest(self._derivation, self._naming, *each) for each in moving]
            bodies = tuple(body for body, _ in moving)
            name: SentenceId = "derived.each-along" if not all(rested) else "derived.each-from-rest"
            return say(name, bodies=bodies)
        return None

    def _is_given_off(self, line: Line, body: str) -> bool:
        """Whether a line takes the direction that is given of a sphere that was at rest."""
        facts = self._derivation.facts_in(line.premises)
        links = [fact.relation.options[0][0] for fact in facts if fact.kind == "given"]
        return any(
            link.sign in ("parallel to", "perpendicular to") or is_quantity(link.left, "direction")
            for link in links
        )

    def _by_products(self, line: Line) -> bool:
        """Whether a law of restitution is written by scalar products with a cited vector."""
        if line.move.record not in ("restitution", "restitution-wall"):
            return False
        numbers = numbers_in(line.premises)
        lines = [own for ref in numbers if (own := self._derivation.line(ref))]
        links = [
            line.relation.only[0]
            for line in lines
            if isinstance(line.relation, Relation) and len(line.relation.options) == 1
        ]
        vectors = any(is_quantity(e.left, "velocity") for e in links)
        # The vector holds a letter: along one that is known the components are numbers.
        axes = any(
            isinstance(e.left, Quantity) and e.sign == "parallel to" and letters(e.right)
            for e in links
        )
        return vectors and axes

    def of(self, line: Line, above: Sentence | None) -> Iterator[Sentence]:
        """What is said before the rows of a line, under a title ``above``."""
        source = self._sources.of(line)
        if line.move.id == "fact":
            given = [each for ref in line.premises if (each := self._derivation.fact(str(ref)))]
            needed = self._of_the_story(line)
            if needed is not None:
                yield needed
                return
            if given and given[0].relation == line.relation and given[0].kind == "geometry":
                return  # a direction of the data, which the row says in words
            at = self._naming.at_contact(given[0]) if given else None
            beside = (
                touching_beside(self._derivation, self._naming, given[0], line) if given else None
            )
            if at is not None:
                yield beside or at
            elif given and isinstance(words := fact_in_words(self._naming, given[0]), Sentence):
                yield say("given.fact", fact=words)
            elif (offset := next(filter(is_offset, given), None)) is not None:
                # Once the offset is known, the same fact gives the line in numbers.
                if offset.id in self._given:
                    yield self._of_a_known_offset(offset, line) or self._worked_out(offset, line)
                else:
                    yield offset_sentence(offset, self._naming, given=False)
                self._given.add(offset.id)
            else:
                yield say("given.data")
            return
        signs = self._by_signs(line)
        if signs is not None:
            yield signs
            return
        letter = letter_of_offset(line)
        if letter is not None:
            offset = next(e for ref in line.premises if (e := self._derivation.fact(str(ref))))
            self._given.add(offset.id)
            yield offset_sentence(offset, self._naming, given=True, letter=letter)
            return
        if self.resolves(line) and line.move.id == "define":
            title = self.resolved(line)
            if title is not None and title != above:
                yield title
            return
        if self._beside_normal(line):
            yield say("wall.beside-normal")
            return
        sense = sense_of_a_normal(self._derivation, self._naming, line) or sense_of_a_change(
            self._derivation, self._naming, line
        )
        if sense is not None:
            yield sense
            return
        bodies = self._from_centre_to_centre(line)
        if bodies is not None:
            yield say("centres.between", one=bodies[0], other=bodies[1])
            return
        if line.move.record == "wall-direction":
            yield say("so")
            return
        body = body_read_off(line) if line.move.record == "parallel" else None
        if body is not None:
            assert isinstance(line.relation, Relation)
            angle = line.relation.only[0].right
            size = unsigned(angle)
            if size not in (Degrees(Fraction(0)), RIGHT_ANGLE, STRAIGHT_ANGLE):
                square = isinstance(angle, Binary) and angle.right == RIGHT_ANGLE
                which = "derived.across-centres" if square else self._along_centres(line, body)
                across = self._across_of(line, body) if square else None
                if across is not None:
                    yield say("derived.across-centres-with", body=body, value=across)
                else:
                    yield say(which, body=body)
                return
            axis: Expression = Unit("j" if size == RIGHT_ANGLE else "i")
            back = size != angle or size == STRAIGHT_ANGLE
            along = self._naming.layout(Negate(axis) if back else axis)
            yield say("derived.along-axis", body=body, axis=along)
            return
        if line.move.record in ("perpendicular", "parallel") and self.title(line) is None:
            right = line.move.record == "perpendicular"
            apart = self._apart(line) if right else slope_title(self._naming, line)
            yield (
                apart
                or self._along_axes(line)
                or self._along_its_line(line)
                or self._seen(line)
                or self._none_in(line)
                or self._direction_again(line)
                or self._since_nothing(line)
                or say("so")
            )
            return
        if line.move.record == "speed" and self._by_a_multiple(line):
            yield say("so")
            return
        directed = self._about_directions(line)
        if directed is None and self.title(line) is None:
            directed = self._by_its_component(line)
        if directed is not None:
            yield directed
            return
        factor = factor_cancelled(self._derivation, line) if line.move.id == "cancel" else None
        known = self._reasons.known(line) if factor is not None else ()
        if factor is not None and known:
            formula = self._naming.layout(factor)
            equations = () if source is None else self._numbers(source)
            if len(equations) > 1:
                yield say(
                    "derived.cancel-by",
                    factor=formula,
                    reasons=known,
                    first=equations[0],
                    equations=equations[1:],
                )
            else:
                assert isinstance(line.relation, Relation)
                ordered = line.relation.options[0][0].sign in FLIPPED
                name = "derived.cancel-positive" if ordered else "derived.cancel"
                yield say(name, factor=formula, reasons=known)
            return
        rearranges = line.move.id == "rearrange"
        angle_divided = cosine_divided(self._derivation, line) if rearranges else None
        if angle_divided is not None:
            yield self._by_cosine(angle_divided)
            return
        rearranged = self._angles_given(line) if rearranges else None
        if rearranged is not None and line.premises == (rearranged.id,):
            yield say("derived.since", facts=(fact_in_words(self._naming, rearranged),))
            return
        divided = self._divided(line)
        if divided is not None:
            yield divided
            return
        needed = self._of_the_story(line) or self._of_a_sense(line)
        if needed is not None:
            yield needed
        elif line.move.id == "identity" and line.move.record in BY:
            how = self._by_the_half(line) or self._by_squares(line) or say(self._identity(line))
            equations = () if source is None else self._numbers(source)
            sentence = self._angles_given(line)
            if sentence is not None and line.move.record == "complement":
                yield say("derived.since", facts=(fact_in_words(self._naming, sentence),))
            elif sentence is not None and sentence.id not in self._given:
                self._given.add(sentence.id)
                yield say(
                    "derived.since-by", facts=(fact_in_words(self._naming, sentence),), how=how
                )
            elif equations:
                yield say("derived.by-from", how=how, equations=equations)
            else:
                yield say("derived.by", how=how)
        elif source is not None:
            yield from self._source(source, line)

    def _of_a_sense(self, line: Line) -> Sentence | None:
        """The given direction that tells which way a component points."""
        given = [each for ref in line.premises if (each := self._derivation.fact(str(ref)))]
        for fact in given if line.move.id == "compare" else ():
            match fact.relation.options[0][0]:
                case Link(Quantity("direction", (Name(),), int()), "=", Degrees()) if (
                    fact.kind == "given"
                ):
                    return say("given.fact", fact=fact_in_words(self._naming, fact))
        return None

    def _beside_normal(self, line: Line) -> bool:
        """Whether a line gives the direction of a wall by its normal, which stands above."""
        own = [other for other in map(self._cited, line.premises) if other is not None]
        return any(e.move.record == "wall-direction" and e.shown == "silent" for e in own)

    def _from_centre_to_centre(self, line: Line) -> tuple[str, ...] | None:
        """The spheres of which a line gives the line of centres by both places."""
        match line.relation:
            case Relation(((Link(Quantity("line_of_centres", (), int(number)), "parallel to"),),)):
                event = self._naming.events.get(number)
            case _:
                return None
        facts = (ref.partition(" ") for ref in line.premises if isinstance(ref, str))
        by_places = line.move.id == "put" and any(kind == "axis" for kind, _, _ in facts)
        return event.bodies if by_places and event is not None and not event.wall else None

    def _worked_out(self, fact: Fact, line: Line) -> Sentence:
        """That an offset is known by now, from which the line of centres follows."""
        cited = [other for other in map(self._cited, line.premises) if other is not None]
        known = {
            line.relation.options[0][0].left
            for line in cited
            if isinstance(line.relation, Relation)
        }
        facts = [each for ref in line.premises if (each := self._derivation.fact(str(ref)))]
        values = tuple(
            self._naming.relation(fact.relation)
            for fact in facts
            if fact.kind == "given" and len(fact.relation.options) == 1
            if isinstance(fact.relation.only[0].left, Letter)
        )
        if values:
            return say("derived.since", facts=values)
        angles = [e for e in walk(fact.relation.only[0].right) if isinstance(e, Apply)]
        names = {node for angle in angles for node in walk(angle) if isinstance(node, Letter)}
        names = names & known or names
        letters = tuple(map(self._naming.layout, sorted(names, key=lambda name: name.name)))
        return say("derived.put", letters=letters) if letters else say("so")

    def _by_cosine(self, angle: Letter) -> Sentence:
        """By which squared cosine an equation is divided, and why that is not zero."""
        squared = self._naming.layout(Binary("^", Apply("cos", angle), Number(Fraction(2))))
        acute = self._reasons.acute(angle)
        if acute is None:
            return say("derived.divided-by", factor=squared)
        return say("derived.cancel", factor=squared, reasons=(acute,))

    def _divided(self, line: Line) -> Sentence | None:
        """By what top and bottom of a fraction are divided, where only its form changes."""
        refs = numbers_in(line.premises)
        own = self._derivation.line(refs[0]) if line.move.id == "rearrange" and refs else None
        if own is None or not isinstance(own.relation, Relation):
            return None
        match own.relation.options[0][-1].right, line.relation:
            case Binary("/", top, _), Relation(((Link(left, "=", Binary("/", rest, below)),),)):
                if left != own.relation.options[0][0].left:
                    return None
                if any(map(has_quantity, (top, rest, below))):
                    return None
            case _:
                return None
        inside = {node.right for node in walk(below) if is_binary(node, "/")}
        for tree in inside:
            if isinstance(tree, Letter | Apply) and tidy(
                worth(top) - worth(rest) * worth(tree)
            ).equals(0):
                return say("derived.divided", factor=self._naming.layout(tree))
        return None

    def _of_a_known_offset(self, fact: Fact, line: Line) -> Sentence | None:
        """The angle of an offset that was found, if the line of centres stands in no letters."""
        assert isinstance(line.relation, Relation)
        known: dict[str, Any] = {}
        for other in self._derivation.lines[: line.number - 1]:
            if not isinstance(other.relation, Relation) or len(other.relation.options) != 1:
                continue
            if other.relation.only[0].left == line.relation.only[0].left:
                return None
            left = other.relation.only[0].left
            if other.number in line.premises and isinstance(left, Letter):
                known[left.name] = worth(other.relation.only[-1].right)
        return angle_of_offset(fact, known, self._naming)

    def _sine_of_an_offset(self, line: Line) -> Iterator[Sentence]:
        """How an offset gives the sine of an angle that is given, said the first time."""
        facts = (self._derivation.fact(str(ref)) for ref in line.premises)
        for fact in facts:
            if fact is not None and is_offset(fact) and fact.id not in self._given:
                self._given.add(fact.id)
                yield offset_sentence(fact, self._naming, given=True)

    def _squares(self, line: Line) -> bool:
        """Whether a line rests on a right angle between a velocity and a fixed direction."""
        lets = (other.relation for other in map(self._cited, line.premises) if other is not None)
        return any(
            isinstance(let, Meaning)
            and is_quantity(let.quantity, "angle")
            and not all(is_quantity(e, "velocity") for e in let.quantity.arguments)
            for let in lets
        )

    def anyway(self, line: Line) -> Iterator[Sentence]:
        """What is given and holds for all values of the letters, above a range beside others.

        Above the difference from a greatest or least value, where that is reached.
        """
        compared = value_compared(self._derivation, self._naming, line)
        if compared is not None:
            yield compared
        match line.relation:
            case Relation(((Link(_, _, Letter() as letter), Link()),)) if (
                self._reasons.is_own_range(line)
            ):
                above = [other for other in map(self._cited, line.premises) if other is not None]
                holds = any(line.move.id in ("put", "rearrange", "cancel") for line in above)
                facts = [self._derivation.fact(str(ref)) for ref in line.premises]
                if any(fact is not None and fact.kind == "range" for fact in facts):
                    yield say("given.data")  # what is given of the letter bounds it
                else:
                    before = any(
                        other.item == line.item and other.number < line.number
                        for other in self._derivation.lines
                    )
                    free = "range.every" if before else "range.every-free"
                    name = "range.every-holds" if holds else free
                    yield say(name, letter=self._naming.layout(letter))
        for ref in line.premises if line.move.id == "compare" else ():
            own = self._derivation.line(ref)
            if own is None or own.shown != "silent" or own.move.id != "put":
                continue
            match own.relation:
                case Relation(((Link(_, "<" | "<=" | ">" | ">="),),)) as relation:
                    words = self._of_letter(own) or self._naming.relation(relation)
                    meeting = self._meeting_behind(own)
                    if meeting is not None:
                        yield meeting
                    bounds = range_behind(self._naming, relation)
                    if bounds is None:
                        yield say("derived.anyway", fact=words)
                    else:
                        ground = self._naming.relation(bounds)
                        yield say("derived.anyway-as", fact=words, ground=ground)
