"""The title of a line: the principle or the definition by which it is made."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from fractions import Fraction

import sympy as sp

from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.laws.principles import RECORDS, Record
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Event,
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
from restitution.explaining.lines.trees import is_share_of_energy, trees_of
from restitution.expression.quantities import LOSSES
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    Unit,
    children,
    is_binary,
    is_quantity,
    is_zero,
    letters,
    unsigned,
    walk,
)
from restitution.workings.leads.component_leads import ComponentLeads
from restitution.workings.leads.flights import chord_title, distance_title, flight_title
from restitution.workings.leads.scalar_products import product_title, slope_title
from restitution.workings.leads.shapes_of_lines import (
    body_read_off,
    has_sum_of_squares,
    ratio_below,
    read_off_lines,
    under_a_root,
)
from restitution.workings.leads.source_leads import SourceLeads
from restitution.workings.leads.turn_leads import TurnLeads
from restitution.workings.naming.measured import vector_worth

TITLED = frozenset({"law", "define"})

_BY_RATIO: Mapping[str, SentenceId] = {
    "cos": "derived-speed.by-cos",
    "sin": "derived-speed.by-sin",
}
# That a body moves along the line of centres; with the reason, where it was at rest.
_ALONG = {False: "derived-speed.along", True: "derived-speed.along-from-rest"}


def _values(line: Line, own: Collection[str]) -> Iterator[tuple[Link, ...]]:
    """What a line says, as chains; of letters that are solved together some."""
    if not isinstance(line.relation, Relation):
        return
    if line.move.id != "solve":
        yield line.relation.options[0]
        return
    for link in line.relation.options[0]:
        if isinstance(link.left, Letter) and link.left.name in own:
            yield (link,)


def _is_oblique(fact: Fact) -> bool:
    """Whether a fact gives a velocity with a component along **i** and one along **j**."""
    link = fact.relation.options[0][-1]
    if not is_quantity(fact.relation.options[0][0].left, "velocity"):
        return False
    vector = vector_worth(link.right)
    return vector is not None and vector.x != 0 and vector.y != 0


def _has_one_component(value: Expression) -> bool:
    """Whether a vector is zero, or has a component along **i** or **j** alone."""
    return is_zero(value) or len([node for node in walk(value) if isinstance(node, Unit)]) == 1


class Titles(SourceLeads, TurnLeads, ComponentLeads):
    """The titles of the lines of one derivation: the principles and definitions that they use."""

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
        """Whether a speed or an angle is read off a velocity that is a multiple of another."""
        above = [own.relation for own in map(self._cited, line.premises) if own is not None]
        return any(
            is_quantity(node, "velocity")
            for own in above
            if isinstance(own, Relation)
            for links in own.options
            for node in walk(links[-1].right)
        )

    def _along_a_multiple(self, line: Line) -> Sentence | None:
        """That a velocity is in the direction of another, or opposite: a multiple of that."""
        match line.relation:
            case Relation(((Link(Quantity("angle", (one, other)), "=", size),),)) if (
                self._by_a_multiple(line)
            ):
                back = size == STRAIGHT_ANGLE
                name: SentenceId = "between.negative-multiples" if back else "between.multiples"
                return say(name, left=self._naming.layout(one), right=self._naming.layout(other))
        return None

    def _about_directions(self, line: Line) -> Sentence | None:
        """How an angle is made, between what it is, or along which line a body moves.

        And with which vector the scalar products of a law are.
        """
        if line.move.record == "scalar-angle":
            return product_title(self._derivation, self._naming, line)
        if (vector := self._by_products_with(line)) is not None:
            return say("restitution.products-with", vector=self._naming.layout(vector))
        if (vector := self._vector_of_products(line)) is not None:
            return say("restitution.length", vector=self._naming.layout(vector))
        slope = slope_title(self._naming, line)
        return slope or self._turned(line) or self._along_the_line(line)

    def _by_speeds(self, line: Line) -> bool:
        """Whether a line rests on speeds or kinetic energies that are given or stand above."""
        lines = map(self._derivation.line, (ref for ref in line.premises if isinstance(ref, int)))
        facts = map(self._derivation.fact, (ref for ref in line.premises if isinstance(ref, str)))
        relations = (premise.relation for premise in (*lines, *facts) if premise is not None)
        kinds = {
            node.kind
            for relation in relations
            if isinstance(relation, Relation)
            for node in walk(relation.options[0][0].left)
            if isinstance(node, Quantity)
        }
        whole = isinstance(line.relation, Relation) and any(
            has_sum_of_squares(link.right) for link in line.relation.options[0]
        )
        if "velocity" in kinds and (whole or self._naming.bold.has_unit(line.move.event or 0)):
            # By velocities alone, along a line that slants, there is no component.
            return kinds <= {"velocity", "mass", "speed", "energy"}
        return not kinds.isdisjoint({"energy", "speed"})

    #: The line of which a title was asked last, and that: it is asked for what stands below it too.
    _last: tuple[Line, Sentence | None] | None = None

    def title(self, line: Line) -> Sentence | None:
        """The principle or definition of a line; None where the line speaks for itself."""
        if self._last is None or self._last[0] is not line:
            self._last = line, self._title(line)
        return self._last[1]

    def _title(self, line: Line) -> Sentence | None:
        record = RECORDS.get(line.move.record or "")
        if record is None or self._speaks_for_itself(line, record):
            return None
        event = self._naming.events.get(line.move.event or 0)
        bodies = line.move.bodies or (() if event is None else event.bodies)
        if (kept := self.kept_speed(line, event)) is not None:
            return kept
        if record.id == "straight-line" and line.move.bodies:
            return flight_title(self._derivation, self._naming, line)
        if record.id == "chord":
            return chord_title(self._derivation, line, "" if event is None else event.bodies[-1])
        if record.id == "distance":
            return distance_title(self._derivation, self._naming, line)
        name = self._name(record, line, event, bodies)
        if name is None or isinstance(name, Sentence):
            return name
        return self._sentence(name, line, event, bodies)

    def _speaks_for_itself(self, line: Line, record: Record) -> bool:
        """Whether a line has no title, whatever its principle is called."""
        if line.move.id not in TITLED or self.resolves(line):
            return True
        if letter_of_offset(line) is not None:
            return True
        if record.id == "parallel" and (
            body_read_off(line)
            or read_off_lines(self._derivation, line)
            or self._seen(line)
            or self._since_nothing(line)
            or self._along_a_multiple(line)
        ):
            return True
        return self._direction_again(line) is not None or self._about_directions(line) is not None

    def _name(
        self, record: Record, line: Line, event: Event | None, bodies: tuple[str, ...]
    ) -> SentenceId | Sentence | None:
        """What the principle is called on a line: the id of its title, or all that is said."""
        assert isinstance(line.relation, Relation)
        first, last = line.relation.options[0][0], line.relation.options[0][-1]
        match record.id, first.left:
            case "momentum", _ if all(map(self._is_of_one, bodies)):
                return "momentum.of-one"
            case "assemble", _:
                return self._assembled(record, line, event, bodies)
            case "impulse-vector", _ if (
                event is not None
                and event.kind == "impact"
                and self._by_components(line)
                and not _is_of_whole_velocities(last.right, first.right)
            ):
                return RECORDS["impulse"].title(event)  # a component times its unit vector
            case "impulse", _ if event is not None and not event.wall and self._decreases(line):
                return "impulse-spheres.decrease"
            case "product", _ if wall := self._along_which(line):
                return say("derived-product.along", wall=wall)
            case "opposite-impulses", Quantity("impulse", (Name(body),)) if self._weighs(line):
                (other,) = (other for other in bodies if other != body)
                return say("derived-opposite.change", one=body, other=other)
            case "energy-ratio" | "energy-lost" | "total-lost", _:
                return self._of_energy(record, line, event)
            case "total", _ if line.move.bodies:
                return self._of_all(*line.move.bodies)
            case "energy" | "total", Binary("^", Quantity("speed")):
                return "derived-energy.speed"
            case "tan-deflection", Apply("tan", Quantity("deflection")) if is_zero(last.right):
                return say("turned.on-one-line", body=bodies[0])
            case "tan-deflection", Apply("cot"):
                return "turned.products-over"
            case "perpendicular", _ if not is_zero(last.right) or self._squares(line):
                return None
            case "perpendicular", _ if last.sign in FLIPPED:
                return None
            case "round", Binary("*"):
                return None  # its lead names the angle
            case (
                "energy-change",
                Binary("-", Quantity("energy", _, int(early)), Quantity("energy", _, int(late))),
            ) if early < late:
                return "loss-wall.title"
            case "speed", _ if is_zero(last.right):
                return None  # the component just above it is zero
            case "speed", Binary("*"):
                return say("derived-speed.resolved", body=bodies[0])
            case "speed", _ if self._by_a_multiple(line):
                return None
            case "speed", Quantity() if self._is_read_off(line, first.right):
                return None  # it is given
            case "speed", Quantity() | Letter() if (
                ratio := ratio_below(first.right)
            ) and not self._is_of_a_line(line, first.right):
                return say(_BY_RATIO[ratio], body=bodies[0])
            case "size", _ if not any(map(under_a_root, walk(first.right))):
                return None  # of one component it is read off
        return record.title(event)

    def _assembled(
        self, record: Record, line: Line, event: Event | None, bodies: tuple[str, ...]
    ) -> SentenceId | Sentence | None:
        """What is said of a vector that is put together of its components."""
        assert isinstance(line.relation, Relation)
        if self._under_a_tie(line):
            return None  # the given fact says so
        if self._goes_off(line):
            return say("derived-speed.along-from-rest", body=bodies[0])
        if self._is_of_the_component_above(line):
            return None
        match line.relation.options[0][0].left:
            case Quantity("velocity", (Name(body),), _) if self._is_out_of_it(body):
                now = self._naming.events[self._naming.now or 0]
                return say("derived-assembled.still", body=body, event=self._naming.called(now))
            case Quantity("velocity") if one := self._one_component(line):
                return None if self._in_one_line(event) else one
            case Quantity("position", (Name(body),), _):
                if (level := self._stays_on(line, body)) is not None:
                    return level
                return None if self._is_below_its_coordinate(line) else "derived-place.title"
        return record.title(event)

    def _stays_on(self, line: Line, body: str) -> Sentence | None:
        """The axes on which bodies stay until they are in a place: no line says so.

        None where the body itself does not, nor the one that it meets there.
        """
        axes: dict[str, str] = {}
        for own in map(self._cited, line.premises):
            if own is None or own.marks or own.move.record != "straight-line":
                continue
            match own.relation:
                case Relation(
                    (
                        (
                            Link(
                                Quantity("along", (Quantity(_, (Name(name),)), Unit(axis))),
                                "=",
                                end,
                            ),
                        ),
                    )
                ) if is_zero(end):
                    axes[name] = "y" if axis == "i" else "x"
        own_axis, others = axes.pop(body, None), list(axes.items())
        if not others:
            return say("flight.level", body=body, axis=own_axis) if own_axis else None
        other, second = others[0]
        if own_axis is None:
            return say("flight.meets-level", body=body, other=other, axis=second)
        return say("flight.both-level", body=body, axis=own_axis, other=other, second=second)

    def _of_a_share(self, record: Record, line: Line, event: Event | None) -> SentenceId | None:
        """What is said of an energy, or of a loss, as a share of an energy before."""
        assert isinstance(line.relation, Relation)
        cited = map(self._cited, line.premises)
        shares = sum(own is not None and is_share_of_energy(own) for own in cited)
        own = line.relation.options[0][0].left
        match own:
            case Binary("/", Quantity(kind, _, int(stage))) if kind in LOSSES:
                if shares:
                    return "fraction-lost.left" if shares == 1 else "fraction-lost.together"
                by_component = kind == "energy_lost" or stage == 1
                at_a_wall = event is not None and event.wall and not self._by_speeds(line)
                return (
                    "fraction-lost.at-a-wall"
                    if at_a_wall and by_component
                    else "fraction-lost.title"
                )
        return "fraction-lost.kept" if shares else record.title(event)

    def _of_energy(self, record: Record, line: Line, event: Event | None) -> SentenceId | None:
        """What is lost, and whether it is lost along the line of centres alone."""
        assert isinstance(line.relation, Relation)
        if len(line.premises) == 1 and self._derivation.facts_in(line.premises):
            return None  # it is given
        match record.id, line.relation.options[0][0].left:
            case "energy-ratio", _:
                return self._of_a_share(record, line, event)
        if self._is_direct(event):
            return "derived-energy.title"
        by_speeds = self._by_speeds(line)
        if record.id == "total-lost":
            # What is lost in all is lost in the one impact.
            one_impact = not self._naming.several and not by_speeds
            return (RECORDS["energy-lost"] if one_impact else record).title(event)
        of_the_data = not any(isinstance(ref, int) for ref in line.premises) and not any(
            _is_oblique(fact) for fact in self._derivation.facts_in(line.premises)
        )
        kicked = event is not None and event.kind == "kick"
        return "derived-energy.title" if of_the_data or by_speeds or kicked else record.title(event)

    def _of_all(self, body: str) -> Sentence:
        """That the kinetic energy of one sphere is all that there is."""
        spheres = (e.id.partition(" ")[2] for e in self._derivation.facts)
        others = [
            name
            for name in dict.fromkeys(spheres)
            if self._naming.bodies.get(name) == "sphere" and name != body
        ]
        if len(others) == 1:
            return say("derived-energy.other-at-rest", other=others[0], body=body)
        return say("derived-energy.others-at-rest", others=tuple(others), body=body)

    def _sentence(
        self, name: SentenceId, line: Line, event: Event | None, bodies: tuple[str, ...]
    ) -> Sentence | None:
        """The title with an id, and what is said in its place of bodies that move along a line."""
        assert isinstance(line.relation, Relation)
        first, last = line.relation.options[0][0], line.relation.options[0][-1]
        record = line.move.record
        if record == "difference" and event is None:
            of_the_data = is_quantity(first.left, "direction") or _is_to_a_line(first.left)
            return None if of_the_data else say("turned.by-directions")
        if record == "along-the-change" and event is not None and not event.wall:
            rested = [body for body in bodies if self._is_given_off(line, body)]
            if rested:
                return say("moves-off.title", body=rested[0])
        if record in ("tan", "tan-direction") and event is not None and self._moves_along(line):
            rested_ = self.tells_of_rest(bodies[0], event.number, line)
            return say("moves-along.from-rest" if rested_ else "moves-along.title", body=bodies[0])
        if record == "speed" and (one := self._one_component(line)) is not None:
            return None if self._in_one_line(event) else one
        if self._by_products(line):
            return say("restitution.products")
        if record in ("restitution", "restitution-wall") and is_zero(last.right):
            return say("restitution.none")
        if name == "derived-speed.title" and self._naming.has_letter_of_the_question(first.left):
            name = "derived-speed.title-of"
        slots = {"body": bodies[:1], "wall": () if event is None else event.bodies[1:2]}
        return say(name, **{slot: slots[slot][0] for slot in slots_of(name)})

    def _is_of_a_line(self, line: Line, value: Expression) -> bool:
        """Whether a line takes a value, or its size, as it stands on a line that it cites."""
        cited = (own.relation for own in map(self._cited, line.premises) if own is not None)
        ends = (own.options[0][-1].right for own in cited if isinstance(own, Relation))
        return any(unsigned(end) == unsigned(value) for end in ends)

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
        fact = self._derivation.fact(f"mass {body}")
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
        still_open = [e.relation for e in own if isinstance(e.relation, Meaning)]
        lasting = [
            links for e in own for links in _values(e, {meaning.letter for meaning in still_open})
        ]
        lasting = [links for links in lasting if links[0].sign == "="]  # a bound is no component
        parts = [links[0].left for links in lasting if not is_zero(links[-1].right)]
        # A component that is still a letter may be anything.
        known = {links[0].left for links in lasting}
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

    def _is_given_off(self, line: Line, body: str) -> bool:
        """Whether a line takes the direction of a sphere from rest, as it is given or stands."""
        cited = [
            own.relation.options[0][0].left
            for number in numbers_in(line.premises)
            if (own := self._derivation.line(number)) and isinstance(own.relation, Relation)
        ]
        if Quantity("velocity", (Name(body),), line.move.event) in cited:
            return self.tells_of_rest(body, line.move.event or 0, line)
        facts = self._derivation.facts_in(line.premises)
        links = [fact.relation.options[0][0] for fact in facts if fact.kind == "given"]
        return any(
            link.sign in ("parallel to", "perpendicular to") or is_quantity(link.left, "direction")
            for link in links
        )

    def _decreases(self, line: Line) -> bool:
        """Whether the component after an impact, which is unknown, is less than the one before."""
        assert isinstance(line.relation, Relation)
        for tree in trees_of(line.relation):
            for node in walk(tree):
                match node:
                    case Binary("-", _, Letter(name)) if name in self._naming.meanings:
                        return True
        return False

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

    def _by_products_with(self, line: Line) -> Expression | None:
        """The vector in numbers, of two components, with which a law of restitution is multiplied.

        None where components along it stand before the law.
        """
        if line.move.record not in ("restitution", "restitution-wall") or self._by_products(line):
            return None
        cited = [self._cited(ref) for ref in numbers_in(line.premises)]
        relations = [e.relation for e in cited if e and isinstance(e.relation, Relation)]
        own = [relation.only for relation in relations if len(relation.options) == 1]
        if self._by_components(line) or not any(is_quantity(e[0].left, "velocity") for e in own):
            return None
        vectors = [links[-1].right for links in own if links[-1].sign == "parallel to"]
        return next((e for e in vectors if not _has_one_component(e)), None)

    def _vector_of_products(self, line: Line) -> Expression | None:
        """The vector of which scalar products stand in a law of restitution; None without these.

        It is no unit vector, and its length is in every term.
        """
        if line.move.record not in ("restitution", "restitution-wall"):
            return None
        cited = [self._cited(ref) for ref in numbers_in(line.premises)]
        relations = [own.relation for own in cited if own and isinstance(own.relation, Relation)]
        for relation in relations:
            match relation.only[0].left if len(relation.options) == 1 else None:
                case Quantity("dot", (Quantity("velocity"), vector)):
                    return vector
        return None

    def _squares(self, line: Line) -> bool:
        """Whether a line rests on a right angle between a velocity and a fixed direction."""
        lets = (other.relation for other in map(self._cited, line.premises) if other is not None)
        return any(
            isinstance(let, Meaning)
            and is_quantity(let.quantity, "angle")
            and not all(is_quantity(e, "velocity") for e in let.quantity.arguments)
            for let in lets
        )


def _is_to_a_line(tree: Expression) -> bool:
    """Whether a quantity is the angle of one velocity, to a line."""
    velocities = [is_quantity(side, "velocity") for side in children(tree)]
    return is_quantity(tree, "angle") and velocities.count(True) == 1


def _is_of_whole_velocities(impulse: Expression, change: Expression) -> bool:
    """Whether a change of momentum has a velocity that is not along the impulse."""
    whole = vector_worth(impulse)
    for node in walk(change) if whole is not None else ():
        if not isinstance(node, Binary) or node.op != "-":
            continue
        ends = vector_worth(node.left), vector_worth(node.right)
        if whole is not None and None not in ends:
            return any(end is not None and sp.expand(end.cross(whole)) != 0 for end in ends)
    return False
