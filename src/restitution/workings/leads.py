"""What stands before the rows of a line: its title, and how it comes from the lines above."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

from restitution.exact import tidy
from restitution.explaining.definitions import past_a_right_angle, tie_of
from restitution.explaining.derivation import (
    FLIPPED,
    Derivation,
    Fact,
    Line,
    Link,
    Meaning,
    Ref,
    Relation,
)
from restitution.explaining.notation import read_tree
from restitution.explaining.principles import RECORDS
from restitution.explaining.saying import Sentence, say, slots_of
from restitution.explaining.sentences import SentenceId
from restitution.explaining.trees import rebuilt, trees_of
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
    is_zero,
    letters,
    walk,
)
from restitution.render import layout as lay
from restitution.workings.factors import factor_cancelled
from restitution.workings.flights import chord_title, distance_title, flight_title
from restitution.workings.grounds import motion_of
from restitution.workings.in_any_case import range_behind
from restitution.workings.measured import worth
from restitution.workings.meetings import condition_of, passing_of
from restitution.workings.naming import Naming
from restitution.workings.offsets import angle_of_offset, is_offset, offset_sentence
from restitution.workings.one_component import vector_resolved
from restitution.workings.reasons import Reasons
from restitution.workings.sources import Source, Sources

TITLED = frozenset({"law", "define"})
_BY = {
    "pythagoras": "derived.pythagoras",
    "double-angle": "derived.double-angle",
    "half-angle": "derived.half-angle",
    "sum-of-angles": "derived.sum-of-angles",
    "complement": "derived.complement",
}


# Components before the impact, or after it: at a wall, and of spheres.
_RESOLVED = {
    (True, True): "resolved-wall.before-units",
    (True, False): "resolved-wall.after-units",
    (False, True): "resolved-spheres.before-units",
    (False, False): "resolved-spheres.after-units",
}


class Leads:
    """The words before the rows of one derivation, written from the top."""

    def __init__(
        self, derivation: Derivation, naming: Naming, sources: Sources, reasons: Reasons
    ) -> None:
        self._derivation = derivation
        self._reasons = reasons
        self._naming = naming
        self._sources = sources
        self._given: set[str] = set()
        self._behind: dict[int, Sentence] = {}

    def given(self, line: Line) -> tuple[Sentence, ...]:
        """The given fact that a definition turns into an equation."""
        if line.move.id != "define":
            return ()
        facts = [
            fact
            for ref in line.premises
            if isinstance(ref, str)
            and (fact := self._derivation.fact(ref)) is not None
            and (fact.kind == "given" or (fact.kind == "range" and ref.startswith("given")))
            and fact.id not in self._given
        ]
        if line.move.record in ("perpendicular", "parallel"):
            # What else is given is a value that is put in.
            facts = [
                each
                for each in facts
                for own in (self._opened(each.relation.only[0]),)
                if tie_of(own) is not None or past_a_right_angle(own) is not None
            ]
        if line.move.record in ("sum", "difference"):
            # An angle of the data is a value too.
            facts = [each for each in facts if any(map(has_quantity, trees_of(each.relation)))]
        if len(facts) != 1:
            return ()
        self._given |= {each.id for each in facts}
        sentence = self._naming.fact(facts[0])
        along = self._moving_along(line)
        if along is not None and line.move.record == "tan":
            return (say("given.fact-along", fact=sentence, body=along),)
        match facts[0].relation.options[0][0]:
            case Link(Quantity("velocity", _, _), "=", right) if isinstance(sentence, lay.Layout):
                if not has_quantity(right):
                    return ()  # a velocity that is given is a datum
                resolved = self.resolved(line) if line.move.record == "component" else None
                if resolved is not None:
                    return (say("given.and", fact=sentence), resolved)
        match facts[0].relation.options[0][0]:
            case Link(Quantity("direction", (Name() as body,), stage), "=", angle) if (
                abs(_degrees(angle)) == 90
            ):
                velocity = self._naming.layout(Quantity("velocity", (body,), stage))
                axis = self._naming.layout(Unit("i"))
                return (say("given.direction", fact=sentence, velocity=velocity, axis=axis),)
        past = past_a_right_angle(self._opened(facts[0].relation.options[0][0]))
        named = isinstance(facts[0].relation.options[0][0].left, Letter)
        if named and line.move.record == "perpendicular" and past is not None:
            if isinstance(past[1], Unit):
                return (say("derived.since", facts=(sentence,)),)
            negative = past[2][0] == "<"
            name = "given.negative-product" if negative else "given.positive-product"
            return (say(name, fact=sentence),)
        if named and not isinstance(sentence, Sentence):
            if self.title(line) is not None:
                self._behind[line.number] = say("derived.as", reasons=(sentence,))
                return ()
            return (say("derived.since", facts=(sentence,)),)
        assert isinstance(line.relation, Relation)
        match facts[0].relation.options[0][0], line.relation.only:
            case Link(Quantity("velocity"), "perpendicular to", Unit() as unit), (link,) if (
                line.move.record == "perpendicular" and is_zero(link.right)
            ):
                return (say("given.component", fact=sentence, axis=self._naming.layout(unit)),)
        if line.move.record in ("sum", "difference") and len(line.move.bodies) == 1:
            turned = self._turned(line)
            if turned is not None:
                return (say("given.and", fact=sentence), turned)
        if isinstance(line.relation.options[0][0].left, Letter):
            return (say("given.fact", fact=sentence),)
        if line.move.record == "perpendicular" and past is not None:
            negative = past[2][0] == "<"
            name = "given.negative-product" if negative else "given.positive-product"
            return (say(name, fact=sentence),)
        nothing = is_zero(line.relation.options[0][-1].right)
        if line.move.record == "perpendicular" and nothing:
            match line.relation.options[0][0].left:
                case Quantity("along" | "across"):
                    pass
                case Binary("*") if (mover := self._on_the_line(line)) is not None:
                    return (say("given.product-along", fact=sentence, body=mover),)
                case _:
                    return (say("given.product", fact=sentence),)
        other = _across(facts[0].relation.options[0][0].right)
        if line.move.record == "parallel" and nothing and other is not None:
            return (say("given.component", fact=sentence, axis=self._naming.layout(other)),)
        if line.move.record == "parallel":
            return (say("given.proportion", fact=sentence),)
        if line.move.record in ("energy-lost", "energy-change"):
            event = self._naming.events.get(line.move.event or 0)
            spheres = line.move.record == "energy-lost" and event is not None and not event.wall
            name = "given.by-those-that-change" if spheres else "given.by-what-changes"
            return (say("given.and", fact=sentence), say(name))
        offset = self._sine_of_an_offset(line)
        return (*offset, self._and_its_sense(line, sentence) or say("given.fact", fact=sentence))

    def _and_its_sense(self, line: Line, fact: Sentence | lay.Layout) -> Sentence | None:
        """A given angle to a line, of which the tangent has a component of a certain sign below."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0]:
            case Link(left, "=", Binary("/", _, below)) if line.move.record == "tan":
                if letters(left):
                    return None
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
        """The given fact that says a velocity by another one, before a law that takes it."""
        for ref in line.premises if line.move.id == "law" else ():
            fact = self._derivation.fact(ref) if isinstance(ref, str) else None
            if fact is None or fact.kind != "given" or fact.id in self._given:
                continue
            match fact.relation.options[0][0]:
                case Link(Quantity("velocity"), "=", right) if has_quantity(right):
                    self._given.add(fact.id)
                    words = self._naming.fact(fact)
                    own = self._component_of_multiple(fact)
                    if own is not None:
                        component, value = map(self._naming.layout, own)
                        slots = {"component": component, "value": value}
                        return (say("given.multiple", fact=words, **slots),)
                    return (say("given.and", fact=words),)
                case Link(Quantity("velocity", (Name(body),)), "=") if _is_rest(fact):
                    self._given.add(fact.id)
                    return (say("given.rest", body=body),)
        return ()

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
            each.relation.only[0].right: each.relation.only[0].left
            for each in self._derivation.facts
            if each.kind == "data" and len(each.relation.options) == 1
        }
        is_named = isinstance(link.left, Letter) and link.left in named
        return replace(link, left=named[link.left]) if is_named else link

    def behind(self, line: Line) -> tuple[Sentence, ...]:
        """The value of a letter that a definition puts in, which stands behind the line."""
        return (self._behind[line.number],) if line.number in self._behind else ()

    def _of_energies(self, line: Line) -> bool:
        """Whether a line rests on kinetic energies that stand above."""
        lines = map(self._derivation.line, (ref for ref in line.premises if isinstance(ref, int)))
        relations = (each.relation for each in lines if each is not None)
        return any(
            isinstance(node, Quantity) and node.kind == "energy"
            for each in relations
            if isinstance(each, Relation)
            for node in walk(each.options[0][0].left)
        )

    def title(self, line: Line) -> Sentence | None:
        """The principle or definition of a line; None where the line speaks for itself."""
        record = RECORDS.get(line.move.record or "")
        if line.move.id not in TITLED or record is None or record.id == "component":
            return None
        if record.id == "parallel" and (_read_off(line) or self._since_nothing(line)) is not None:
            return None
        if self._turned(line) is not None or self._along_the_line(line) is not None:
            return None
        event = self._naming.events.get(line.move.event or 0)
        bodies = line.move.bodies or (() if event is None else event.bodies)
        assert isinstance(line.relation, Relation)
        first, last = line.relation.options[0][0], line.relation.options[0][-1]
        name = record.title(event)
        if record.id == "straight-line" and line.move.bodies:
            return flight_title(self._derivation, self._naming, line)
        if record.id == "chord":
            return chord_title(self._derivation, line, "" if event is None else event.bodies[-1])
        if record.id == "distance":
            return distance_title(line)
        match record.id, first.left:
            case "assemble", Quantity("position", _, _):
                name = "derived-place.title"
            case "energy-lost", _ if not any(isinstance(ref, int) for ref in line.premises):
                name = "derived-energy.title"  # by speeds of the data
            case "energy-lost", _ if self._of_energies(line):
                name = "derived-energy.title"
            case "perpendicular", _ if not is_zero(last.right) or self._squares(line):
                return None
            case "perpendicular", _ if last.sign in FLIPPED:
                return None
            case "speed", Binary("*"):
                return say("derived-speed.resolved", body=bodies[0])
            case "speed", Quantity() if _is_by_an_angle(first.right):
                return say("derived-speed.by-angle", body=bodies[0])
            case "size", _ if not any(map(_under, walk(first.right))):
                return None  # of one component it is read off
        if name is None:
            return None
        if record.id == "along-the-change" and event is not None and not event.wall:
            rested = [body for body in bodies if self._is_given_off(line, body)]
            if rested:
                return say("moves-off.title", body=rested[0])
        if record.id == "tan-direction" and self._moves_along(line):
            return say("moves-along.title", body=bodies[0])
        if record.id == "speed" and (one := self._one_component(line)) is not None:
            return one
        if self._by_products(line):
            return say("restitution.products")
        if record.id in ("restitution", "restitution-wall") and is_zero(last.right):
            return say("restitution.none")
        slots = {"body": bodies[:1], "wall": () if event is None else event.bodies[1:2]}
        return say(name, **{each: slots[each][0] for each in slots_of(name)})

    def _moves_along(self, line: Line) -> bool:
        """Whether a direction is that of the line of centres, as there is no component across."""
        numbers = [ref for ref in line.premises if isinstance(ref, int)]
        lines = [own for ref in numbers if (own := self._derivation.line(ref))]
        event = self._naming.events.get(line.move.event or 0)
        return (
            event is not None
            and not event.wall
            and any(
                isinstance(each.relation, Relation)
                and each.move.record == "unchanged"
                and is_zero(each.relation.options[0][-1].right)
                for each in lines
            )
        )

    def _came_along(self, line: Line) -> Sentence | None:
        """That the angle of deflection is one to an axis, as the body came along that."""
        (body,) = line.move.bodies
        events = [n for n, event in self._naming.events.items() if body in event.bodies]
        if line.move.event != min(events):
            return None
        sense = None
        for ref in line.premises:
            fact = self._derivation.fact(ref) if isinstance(ref, str) else None
            match None if fact is None else fact.relation.options[0][0]:
                case Link(Quantity("velocity", (Name(own),)), "=", right) if own == body:
                    if all(map(self._reasons.is_positive, letters(right))):
                        sense = _sense_of(right)
        if sense is None:
            return None
        late = Quantity("velocity", (Name(body),), line.move.event)
        velocity, axis = map(self._naming.layout, (late, sense))
        return say("turned.from-axis", body=body, axis=axis, velocity=velocity)

    def _one_component(self, line: Line) -> Sentence | None:
        """How a body moves of whose velocity all components but one are zero."""
        assert isinstance(line.relation, Relation)
        numbers = [ref for ref in line.premises if isinstance(ref, int)]
        own = [e for e in map(self._cited, numbers) if e is not None]
        lasting = [e.relation for e in own if isinstance(e.relation, Relation)]
        parts = [e.options[0][0].left for e in lasting if not is_zero(e.options[0][-1].right)]
        right = line.relation.options[0][0].right
        if len(parts) != 1 or any(isinstance(e, Binary) and e.op == "+" for e in _under(right)):
            return None
        part = parts[0]
        if isinstance(part, Letter) and part.name in self._naming.meanings:
            part = self._naming.meanings[part.name].quantity
        match part:
            case Quantity("along" | "across" as kind, (Quantity("velocity", (Name(body),)), axis)):
                event = self._naming.event_of_axis(axis)
                if event is None or event.wall:
                    return say("derived-speed.one", body=body)
                along = kind == "along"
                return say("derived-speed.along" if along else "derived-speed.across", body=body)
        return None

    def _is_given_off(self, line: Line, body: str) -> bool:
        """Whether a line takes the direction that is given of a sphere that was at rest."""
        facts = [self._derivation.fact(ref) for ref in line.premises if isinstance(ref, str)]
        links = [
            fact.relation.options[0][0]
            for fact in facts
            if fact is not None and fact.kind == "given"
        ]
        return any(
            link.sign in ("parallel to", "perpendicular to")
            or (isinstance(link.left, Quantity) and link.left.kind == "direction")
            for link in links
        )

    def _by_products(self, line: Line) -> bool:
        """Whether a law of restitution is written by scalar products with a cited vector."""
        if line.move.record not in ("restitution", "restitution-wall"):
            return False
        numbers = [ref for ref in line.premises if isinstance(ref, int)]
        lines = [own for ref in numbers if (own := self._derivation.line(ref))]
        links = [
            each.relation.only[0]
            for each in lines
            if isinstance(each.relation, Relation) and len(each.relation.options) == 1
        ]
        vectors = any(isinstance(e.left, Quantity) and e.left.kind == "velocity" for e in links)
        axes = any(isinstance(e.left, Quantity) and e.sign == "parallel to" for e in links)
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
            if at is not None:
                yield at
            elif given and isinstance(words := self._naming.fact(given[0]), Sentence):
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
        if line.move.record == "component" and line.move.id == "define":
            title = self.resolved(line)
            if title is not None and title != above:
                yield title
            return
        if self._beside_normal(line):
            yield say("wall.beside-normal")
            return
        bodies = self._from_centre_to_centre(line)
        if bodies is not None:
            yield say("centres.between", one=bodies[0], other=bodies[1])
            return
        if line.move.record == "wall-direction":
            yield say("so")
            return
        body = _read_off(line) if line.move.record == "parallel" else None
        if body is not None:
            assert isinstance(line.relation, Relation)
            angle = line.relation.only[0].right
            size = angle.operand if isinstance(angle, Negate) else angle
            if size not in (Degrees(Fraction(0)), Degrees(Fraction(90)), Degrees(Fraction(180))):
                square = isinstance(angle, Binary) and angle.right == Degrees(Fraction(90))
                which = "derived.across-centres" if square else "derived.along-centres"
                yield say(which, body=body)
                return
            none = Unit("i" if size == Degrees(Fraction(90)) else "j")
            yield say("derived.along-axis", body=body, axis=self._naming.layout(none))
            return
        if line.move.record in ("perpendicular", "parallel") and self.title(line) is None:
            apart = self._apart(line) if line.move.record == "perpendicular" else None
            yield apart or self._none_in(line) or self._since_nothing(line) or say("so")
            return
        turned = self._turned(line) or self._along_the_line(line)
        if turned is not None:
            yield turned
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
                yield say("derived.cancel", factor=formula, reasons=known)
            return
        rearranged = self._angles_given(line) if line.move.id == "rearrange" else None
        if rearranged is not None and line.premises == (rearranged.id,):
            yield say("derived.since", facts=(self._naming.fact(rearranged),))
            return
        divided = self._divided(line)
        if divided is not None:
            yield divided
            return
        needed = self._of_the_story(line)
        if needed is not None:
            yield needed
        elif line.move.id == "identity" and line.move.record in _BY:
            how = say(self._identity(line))
            equations = () if source is None else self._numbers(source)
            sentence = self._angles_given(line)
            if sentence is not None and line.move.record == "complement":
                yield say("derived.since", facts=(self._naming.fact(sentence),))
            elif sentence is not None and sentence.id not in self._given:
                self._given.add(sentence.id)
                yield say("derived.since-by", facts=(self._naming.fact(sentence),), how=how)
            elif equations:
                yield say("derived.by-from", how=how, equations=equations)
            else:
                yield say("derived.by", how=how)
        elif source is not None:
            yield from self._source(source, line)

    def _beside_normal(self, line: Line) -> bool:
        """Whether a line gives the direction of a wall by its normal, which stands above."""
        own = [each for each in map(self._cited, line.premises) if each is not None]
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
        cited = [each for each in map(self._cited, line.premises) if each is not None]
        known = {
            each.relation.options[0][0].left
            for each in cited
            if isinstance(each.relation, Relation)
        }
        angles = [e for e in walk(fact.relation.only[0].right) if isinstance(e, Apply)]
        names = {node for each in angles for node in walk(each) if isinstance(node, Letter)}
        names = names & known or names
        letters = tuple(map(self._naming.layout, sorted(names, key=lambda each: each.name)))
        return say("derived.put", letters=letters) if letters else say("so")

    def _divided(self, line: Line) -> Sentence | None:
        """By what top and bottom of a fraction are divided, where only its form changes."""
        refs = [ref for ref in line.premises if isinstance(ref, int)]
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
        inside = {node.right for node in walk(below) if isinstance(node, Binary) and node.op == "/"}
        for each in inside:
            if isinstance(each, Letter | Apply) and tidy(
                worth(top) - worth(rest) * worth(each)
            ).equals(0):
                return say("derived.divided", factor=self._naming.layout(each))
        return None

    def _of_a_known_offset(self, fact: Fact, line: Line) -> Sentence | None:
        """The angle of an offset that was found, if the line of centres stands in no letters."""
        assert isinstance(line.relation, Relation)
        known: dict[str, Any] = {}
        for each in self._derivation.lines[: line.number - 1]:
            if not isinstance(each.relation, Relation) or len(each.relation.options) != 1:
                continue
            if each.relation.only[0].left == line.relation.only[0].left:
                return None
            left = each.relation.only[0].left
            if each.number in line.premises and isinstance(left, Letter):
                known[left.name] = worth(each.relation.only[-1].right)
        return angle_of_offset(fact, known, self._naming)

    def _sine_of_an_offset(self, line: Line) -> Iterator[Sentence]:
        """How an offset gives the sine of an angle that is given, said the first time."""
        facts = (self._derivation.fact(str(ref)) for ref in line.premises)
        for fact in facts:
            if fact is not None and is_offset(fact) and fact.id not in self._given:
                self._given.add(fact.id)
                yield offset_sentence(fact, self._naming, given=True)

    def _identity(self, line: Line) -> str:
        """The name of an identity: of a tangent that of a sum, or of a difference."""
        name = _BY[line.move.record or ""]
        named = self._angles_given(line) or self._angles_named(line)
        base = next(filter(None, map(self._cited, line.premises)), named)
        if line.move.record != "sum-of-angles" or base is None:
            return name
        assert isinstance(line.relation, Relation)
        link = line.relation.options[0][0]
        nodes = (*walk(link.left), *walk(link.right))
        ratios = {e.function for e in nodes if isinstance(e, Apply)} - {"sqrt"}
        if ratios != {"tan"}:
            return _of_differences(base, name)
        sides: tuple[Expression, ...]
        if isinstance(base.relation, Relation):
            whole = base.relation.options[0][0]
            sides = (whole.right, whole.left)
        else:
            sides = (base.relation.quantity,)
        for side in sides:
            form = _form_of(side) if isinstance(side, Binary) else ""
            if form in _TANGENTS:
                return _TANGENTS[form]
        return name

    def _angles_given(self, line: Line) -> Fact | None:
        """The given sum or difference of angles of which a line is the tangent."""
        facts = (
            self._derivation.fact(premise) for premise in line.premises if isinstance(premise, str)
        )
        for fact in facts:
            if fact is not None and fact.kind == "given" and len(fact.relation.options) == 1:
                match fact.relation.only:
                    case (Link(Binary("+" | "-"), "=") | Link(_, "=", Binary("+" | "-")),):
                        return fact
                    case (Link(left, "=", right),) if line.move.record == "double-angle":
                        if isinstance(left, Binary) or isinstance(right, Binary):
                            return fact
        return None

    def _angles_named(self, line: Line) -> Fact | None:
        """The sum or difference of angles that the statement calls by a letter."""
        for ref in line.premises:
            fact = self._derivation.fact(ref) if isinstance(ref, str) else None
            if fact is not None and fact.id.partition(" ")[0] == "let":
                match fact.relation.only:
                    case (Link(Binary("+" | "-"), "="),):
                        return fact
        return None

    def _turned(self, line: Line) -> Sentence | None:
        """How an angle is made of two others; None of a line that makes none."""
        if line.move.record == "tan-from-axis":
            return self._came_along(line)
        event = self._naming.events.get(line.move.event or 0)
        if line.move.record not in ("sum", "difference") or event is None:
            return None
        assert isinstance(line.relation, Relation)
        first = line.relation.options[0][0]
        if isinstance(first.left, Quantity) and first.left.kind == "energy_lost":
            return None
        body = line.move.bodies[0]
        if self._by_directions(line):
            came = self._came_along(line) if not isinstance(first.right, Binary) else None
            return came or say("turned.directions", body=body)
        same = self._same(first)
        if same is not None:
            return same
        if event.wall:
            name = "turned-wall.sum"
            if line.move.record == "difference":
                straight = first.right == Degrees(Fraction(180))
                name = "turned-wall.straight" if straight else "turned-wall.along"
            return say(name, body=body, wall=event.bodies[1])
        cited = (self._derivation.line(ref) for ref in line.premises if isinstance(ref, int))
        named = [each.relation for each in cited if each and isinstance(each.relation, Meaning)]
        for node in (*walk(first.left), *walk(first.right)):
            if isinstance(node, Letter) and node.name in self._naming.meanings:
                named.append(self._naming.meanings[node.name])
        for each in named:
            match each.quantity:
                case Quantity("angle", (Quantity("velocity"), Unit() as axis)):
                    return say("turned.from", body=body, axis=self._naming.layout(axis))
        form = self._form_of(first)
        alone = len(line.move.bodies) == 1
        if not alone:
            still = self._standing(line).get("along")
            if still is not None and form in _BESIDE:
                (other,) = (each for each in line.move.bodies if each != still)
                return say(_BESIDE[form], one=still, other=other)
            if not isinstance(first.right, Binary | Degrees) and (one := self._on_the_line(line)):
                return say("between.line", body=one)
            return say(_BETWEEN[form], bodies=line.move.bodies)
        if form in _OR_ACROSS and (at := self._reasons.right_angle_among(line)) is not None:
            return say(_OR_ACROSS[form], body=body, at=self._naming.relation(at))
        if form == "square":
            name = "turned.square" if self._ends_square(line) else "turned.from-square"
            return say(name, body=body)
        turn = self._turn_too_wide(line, first) if form == "rest-of-sum" else None
        if turn is not None:
            return say("turned.back-as", body=body, turn=self._naming.layout(turn))
        return say(_TURNED[form], body=body) if form in _TURNED else None

    def _by_directions(self, line: Line) -> bool:
        """Whether a deflection is made of directions alone: one of the data, one that stands."""
        stands = False
        for ref in line.premises:
            own = self._derivation.line(ref) if isinstance(ref, int) else None
            fact = self._derivation.fact(ref) if isinstance(ref, str) else None
            match fact.relation if fact is not None else None if own is None else own.relation:
                case Relation(((Link(Quantity("direction"), "="), *_),)):
                    stands = True
                case Relation(((Link(Letter(name), "="), *_),)) if own is not None:
                    meaning = self._naming.meanings.get(name)
                    if meaning is None or _kind_of(meaning.quantity) != "direction":
                        return False
                    stands = True
                case Meaning() | Relation(((Link(Quantity("velocity"), "="), *_),)):
                    pass
                case _:
                    return False
        return stands

    def _turn_too_wide(self, line: Line, link: Link) -> Expression | None:
        """The given deflection, where a body that keeps its sense is turned through less."""
        facts = (self._derivation.fact(ref) for ref in line.premises if isinstance(ref, str))
        for fact in facts:
            match None if fact is None else fact.relation.options[0][0]:
                case Link(Quantity("deflection"), "=", Degrees(value) as turn):
                    pass
                case _:
                    continue
            degrees = [e.value for e in walk(link.right) if isinstance(e, Degrees)]
            if sorted(degrees)[-1:] != [180] or value not in degrees or len(degrees) != 3:
                return None
            degrees.remove(value)
            first = min(degrees)
            return turn if value >= max(first, 90 - first) else None
        return None

    def _same(self, link: Link) -> Sentence | None:
        """That an angle to a wall, or to an axis, is the one from **i** that has a letter."""
        angles = [
            meaning.quantity
            for side in (link.left, link.right)
            for each in walk(side)
            if isinstance(each, Letter) and (meaning := self._naming.meanings.get(each.name))
        ]
        match angles:
            case [
                Quantity("angle", (one, Quantity("line_of_centres"))),
                Quantity("angle", (other, Name(wall))),
            ] if one == other:
                return say("same.parallel", wall=wall)
            case [one, other] if "direction" in (_kind_of(one), _kind_of(other)):
                pass
            case _:
                return None
        walls = [
            side
            for each in angles
            if isinstance(each, Quantity) and each.kind == "angle"
            for side in each.arguments
            if isinstance(side, Name)
        ]
        moving = [
            side
            for each in angles
            for side in (each.arguments if isinstance(each, Quantity) else ())
            if isinstance(side, Quantity)
        ]
        if not walls and moving:
            velocity, axis = (self._naming.layout(e) for e in (moving[0], Unit("j")))
            return say("same.angle", velocity=velocity, axis=axis)
        if not walls:
            return None
        return say("same.wall", wall=walls[0].name, axis=self._naming.layout(Unit("i")))

    def _form_of(self, link: Link) -> str:
        """How an angle is made of two to the line of centres, of which a line may give one."""
        if isinstance(link.left, Binary):
            return _form_of(link.left)
        meaning = (
            self._naming.meanings.get(link.left.name) if isinstance(link.left, Letter) else None
        )
        match None if meaning is None else meaning.quantity:
            case Quantity("angle", (Quantity("velocity"), Quantity("line_of_centres"))):
                form = _form_of(link.right)
                return "difference" if form == "sum" else form
        return _form_of(link.right)

    def _squares(self, line: Line) -> bool:
        """Whether a line rests on a right angle between a velocity and a fixed direction."""
        lets = (each.relation for each in map(self._cited, line.premises) if each is not None)
        return any(
            isinstance(let, Meaning)
            and isinstance(let.quantity, Quantity)
            and let.quantity.kind == "angle"
            and not all(
                isinstance(e, Quantity) and e.kind == "velocity" for e in let.quantity.arguments
            )
            for let in lets
        )

    def _cited(self, ref: Ref) -> Line | None:
        return self._derivation.line(ref) if isinstance(ref, int) else None

    def _along_the_line(self, line: Line) -> Sentence | None:
        """That a body moves along the line of centres, where an angle to it is one to that."""
        body = self._moving_along(line)
        return None if body is None else say("between.line", body=body)

    def _on_the_line(self, line: Line) -> str | None:
        """The body of a line that moves along the line of centres: by a component, or from rest."""
        for body in line.move.bodies:
            fact = self._derivation.fact(" ".join(("velocity", body)))
            rest = fact is not None and fact.id in line.premises and _is_rest(fact)
            if rest or self._standing(line).get("across") == body:
                return body
        return None

    def _moving_along(self, line: Line) -> str | None:
        """The body that moves along the line of centres, of two between which an angle is."""
        if line.move.record != "tan" or len(line.move.bodies) != 2:
            return None
        for each in filter(None, map(self._cited, line.premises)):
            match each.relation:
                case Relation(((Link(left, "="), *_) as links,)) if is_zero(links[-1].right):
                    match left:
                        case Quantity("along" | "across", (Quantity("velocity", (Name(body),)), _)):
                            return body
        return None

    def _ends_square(self, line: Line) -> bool:
        """Whether a line rests on one by which a component is zero after the impact."""
        relations = (each.relation for each in filter(None, map(self._cited, line.premises)))
        return any(
            isinstance(relation, Relation) and is_zero(relation.options[0][-1].right)
            for relation in relations
        )

    def resolved(self, line: Line) -> Sentence | None:
        """What is said before components: of which time they are."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Quantity("along" | "across", (Quantity("velocity", _, int(stage)), axis)):
                event = self._naming.event_of_axis(axis)
                if event is None and stage < (line.move.event or 0):
                    event = self._naming.events.get(line.move.event or 0)
                if event is None and isinstance(axis, Unit):
                    return say("resolved-axes.title")
                if event is None and isinstance(axis, Name):
                    return say("resolved-axes.wall", wall=axis.name)
            case _:
                return None
        if event is None:
            return None
        bold = self._naming.bold
        direction = None if bold.has_unit(event.number) else bold.direction(event.number, "across")
        if stage < event.number and direction is not None and self._has_across(line, axis):
            if event.wall:
                return say("resolved-wall.before-sense", wall=event.bodies[1], axis=direction)
            return say("resolved-spheres.before-sense", axis=direction)
        if not event.wall and self._is_turned(line, event.number):
            return say("resolved-spheres.before-turned")
        vector = vector_resolved(self._derivation, self._naming, line, event)
        if vector is not None:
            return say("resolved.before-vector", vector=vector)
        return say(_RESOLVED[event.wall, stage < event.number])

    def _has_across(self, line: Line, axis: Expression) -> bool:
        """Whether a component across a line is resolved in the part of a line."""
        parts = self._derivation.asked
        for own in self._derivation.lines:
            match own.relation:
                case Relation(((Link(Quantity("across", (_, other))), *_),)) if other == axis:
                    together = parts.get(own.item or "") == parts.get(line.item or "")
                    if together and own.move.record == line.move.record:
                        return True
        return False

    def _since_nothing(self, line: Line) -> Sentence | None:
        """That a component is zero, by which a direction is what it is."""
        assert isinstance(line.relation, Relation)
        above = [self._derivation.line(ref) for ref in line.premises if isinstance(ref, int)]
        equations = [e.relation.only for e in above if e and isinstance(e.relation, Relation)]
        zero = [links for links in equations if is_zero(links[-1].right)]
        if line.relation.only[0].sign not in ("parallel to", "perpendicular to") or len(zero) != 1:
            return None
        equation = Link(zero[0][0].left, "=", zero[0][-1].right)
        if not isinstance(equation.left, Letter):
            return say("so")
        return say("derived.since", facts=(self._naming.relation(Relation(((equation,),))),))

    def _is_turned(self, line: Line, number: int) -> bool:
        """Whether components are those of an earlier impact, at right angles to this one's line."""
        kinds: set[tuple[str, str]] = set()
        for own in self._derivation.lines:
            if own.move != line.move or not isinstance(own.relation, Relation):
                continue
            match own.relation.options:
                case ((Link(Quantity(kind, (Quantity(), _)), "="),),):
                    pass
                case _:
                    continue
            for each in filter(None, map(self._cited, own.premises)):
                subject = each.relation
                left = subject.only[0].left if isinstance(subject, Relation) else subject.quantity
                meaning = self._naming.meanings.get(left.name) if isinstance(left, Letter) else None
                left = left if meaning is None else meaning.quantity
                match left:
                    case Quantity(other, (Quantity(), Quantity("line_of_centres", _, stage))):
                        if stage != number:
                            kinds.add((kind, other))
        return bool(kinds) and all(kind != other for kind, other in kinds)

    def _none_in(self, line: Line) -> Sentence | None:
        """That a velocity at right angles to a direction has no component in it."""
        assert isinstance(line.relation, Relation)
        if line.move.record != "perpendicular" or not is_zero(line.relation.only[-1].right):
            return None
        meanings = [
            own.relation.quantity
            for own in map(self._cited, line.premises)
            if own is not None and isinstance(own.relation, Meaning)
        ]
        for meaning in meanings:
            match meaning:
                case Quantity("angle", (Quantity("velocity") as velocity, Unit() as axis)):
                    formula, direction = self._naming.layout(velocity), self._naming.layout(axis)
                    return say("given.none-in", velocity=formula, axis=direction)
                case Quantity("angle", (Quantity("velocity") as velocity, Quantity() as axis)) if (
                    axis.kind == "line_of_centres" and self._naming.side(axis) is not None
                ):
                    formula = self._naming.layout(velocity)
                    return say("given.none-along", velocity=formula, line=self._naming.side(axis))
        return None

    def _apart(self, line: Line) -> Sentence | None:
        """Who moves across the line of centres, and who along it, where that is a right angle."""
        still = self._standing(line)
        if set(still) != {"along", "across"}:
            return None
        return say("derived.apart", one=still["along"], other=still["across"])

    def _standing(self, line: Line) -> dict[str, str]:
        """The bodies of which a component is zero by the lines that are cited, by its kind."""
        refs = [ref for ref in line.premises if isinstance(ref, int)]
        cited = [each for ref in refs if (each := self._derivation.line(ref)) is not None]
        meanings = {e.relation.letter: e.relation for e in cited if isinstance(e.relation, Meaning)}
        still: dict[str, str] = {}
        for each in cited:
            match each.relation:
                case Relation(((Link(left, "=", right),),)) if is_zero(right):
                    if isinstance(left, Letter) and left.name in meanings:
                        left = meanings[left.name].quantity
                    match left:
                        case Quantity(kind, (Quantity("velocity", (Name(body),), _), _)):
                            still[kind] = body
        return still

    def _of_the_story(self, line: Line) -> Sentence | None:
        """What has to be for there to be such an impact, where that is what a line says."""
        for ref in line.premises:
            kind, _, number = ref.partition(" ") if isinstance(ref, str) else ("", "", "")
            if kind == "most":
                return say("given.most")
            if kind not in ("within", "approach", "offset"):
                continue
            one, other = self._naming.events[int(number)].bodies
            if kind == "offset":
                return say("given.offset", one=one, other=other)
            if kind == "within":
                return say("given.between", body=one, wall=other)
            return say("given.approach", one=one, other=other)
        return None

    def _source(self, source: Source, line: Line) -> Iterator[Sentence]:
        equations = self._numbers(source)
        match source.kind:
            case "combine":
                letter = self._naming.layout(read_tree(source.eliminated, self._naming.bodies))
                yield say("derived.combine", letter=letter, equations=equations)
            case "compare" if not equations:
                yield say("given.compare")
            case "times":
                yield say("flight.add")
            case "made":
                yield say(self._made(line))
            case "formula":
                yield say("derived.formula")
            case "solve" if equations:
                yield say("derived.solve", equations=equations)
            case "solve":
                yield say("derived.solve-this")
            case "divide":
                first, second = equations
                yield say("derived.divide", first=first, second=second)
            case "square-add":
                yield say("derived.square-add", equations=equations)
            case "put" if not source.facts and _is_multiple(line.relation):
                yield say("derived.multiple")
            case "put":
                facts = tuple(self._fact(fact) for fact in source.facts)
                self._given |= {*source.facts}
                spoken = self._spoken_of(source)
                # What a line says anew of its own letter is not put into it.
                subject = None if isinstance(line.relation, Meaning) else _subject(line.relation)
                letters = tuple(
                    self._named(each)
                    for each in source.letters
                    if spoken.isdisjoint(walk(each)) and each != subject
                )
                is_claim = any(isinstance(e, Sentence) and e.topic == "claim" for e in facts)
                moves = self._moves(source.facts)
                if facts and facts[0] == self._written(line):
                    yield say("given.data")
                elif len(facts) == 1 and is_claim:
                    meeting = self._meeting(source.facts[0], line)
                    yield meeting or say("given.fact", fact=facts[0])
                elif moves is not None and not equations:
                    body, direction, moving = moves
                    if letters and not source.last:
                        yield say(
                            "derived.moves-put",
                            body=body,
                            way=direction,
                            fact=moving,
                            letters=letters,
                        )
                    else:
                        yield say("derived.moves", body=body, way=direction, fact=moving)
                elif facts and letters and not source.last and not equations:
                    yield say("derived.since-put", facts=facts, letters=letters)
                elif facts and equations:
                    yield say("derived.since-in", facts=facts, equation=equations[0])
                elif len(facts) == 1 and isinstance(facts[0], Sentence):
                    yield say("given.fact", fact=facts[0])
                elif facts:
                    yield say("derived.since", facts=facts)
                elif letters and equations and source.last:
                    yield say("derived.put-last", equation=equations[0])
                elif letters and equations:
                    yield say("derived.put-in", letters=letters, equation=equations[0])
                elif letters and not source.last:
                    yield say("derived.put", letters=letters)
                elif equations:
                    yield say("derived.add", equations=equations)
            case _:
                if equations:
                    yield say("derived.add", equations=equations)

    def _written(self, line: Line) -> lay.Layout | None:
        """A line as it is printed."""
        relation = line.relation
        return self._naming.relation(relation) if isinstance(relation, Relation) else None

    @staticmethod
    def _made(line: Line) -> SentenceId:
        """What a line makes of values above it: their ratio, their product, or their difference."""
        assert isinstance(line.relation, Relation)
        match line.relation.options[0][0].left:
            case Binary("/", Quantity("energy_lost" | "total_energy_lost"), Quantity("energy")):
                return "made.fraction-lost"
            case Binary("/", Quantity(), Quantity()):
                return "made.ratio"
            case Binary("*", Quantity(), Quantity()):
                return "made.product"
            case Binary("-", Quantity(), Quantity()):
                return "made.difference"
        return "made.by-these"

    def _named(self, tree: Expression) -> Sentence | lay.Layout:
        """What is put in: a letter, or words with an article."""
        formula = self._naming.layout(tree)
        words = isinstance(formula, lay.Words | lay.Phrase)
        return say("derived.the", quantity=formula) if words else formula

    def _numbers(self, source: Source) -> tuple[Sentence, ...]:
        """The numbers of the equations from which a line comes, in their order."""
        numbers = [self._sources.numbers[each] for each in source.numbered]
        if source.kind != "divide":
            numbers.sort()
        return tuple(say("derived.number", number=str(number)) for number in numbers)

    def _spoken_of(self, source: Source) -> frozenset[Expression]:
        """The quantities of which the given facts speak that are put in: no word more is needed."""
        facts = [fact for each in source.facts if (fact := self._derivation.fact(each))]
        return frozenset(
            node
            for fact in facts
            for tree in trees_of(fact.relation)
            for node in walk(tree)
            if isinstance(node, Quantity)
        )

    def _meeting(self, name: str, line: Line) -> Sentence | None:
        """When bodies meet, where that is what a given fact tells."""
        fact = self._derivation.fact(name)
        relation = None if fact is None else self._naming.meeting(fact)
        if relation is None or fact is None:
            return None
        passing = passing_of(relation, fact, self._naming)
        if passing is not None:
            return passing
        sentence = self._of_letter(line)
        return condition_of(relation, self._naming, inequality=True, written=sentence)

    def _of_letter(self, line: Line) -> lay.Layout | None:
        """``v < 0``, where a line says that of the value of the letter."""
        match line.relation:
            case Relation(((Link(value, sign, right),),)) if is_zero(right):
                pass
            case _:
                return None
        for ref in line.premises:
            own = self._derivation.line(ref) if isinstance(ref, int) else None
            match own.relation if own is not None else None:
                case Relation(((Link(Letter() as letter, "=", tree),),)) if tree == value:
                    return self._naming.relation(Relation(((Link(letter, sign, right),),)))
        return None

    def anyway(self, line: Line) -> Iterator[Sentence]:
        """What is given and holds for all values of the letters, above a range beside others."""
        match line.relation:
            case Relation(((Link(_, _, Letter() as letter), Link()),)) if (
                self._reasons.is_own_range(line)
            ):
                above = [each for each in map(self._cited, line.premises) if each is not None]
                holds = any(each.move.id in ("put", "rearrange", "cancel") for each in above)
                facts = [self._derivation.fact(str(ref)) for ref in line.premises]
                if any(fact is not None and fact.kind == "range" for fact in facts):
                    yield say("given.data")  # what is given of the letter bounds it
                else:
                    before = any(
                        each.item == line.item and each.number < line.number
                        for each in self._derivation.lines
                    )
                    free = "range.every" if before else "range.every-free"
                    name = "range.every-holds" if holds else free
                    yield say(name, letter=self._naming.layout(letter))
        for ref in line.premises if line.move.id == "compare" else ():
            own = self._derivation.line(ref) if isinstance(ref, int) else None
            if own is None or own.shown != "silent" or own.move.id != "put":
                continue
            match own.relation:
                case Relation(((Link(_, "<" | "<=" | ">" | ">="),),)) as relation:
                    words = self._of_letter(own) or self._naming.relation(relation)
                    bounds = range_behind(self._naming, relation)
                    if bounds is None:
                        yield say("derived.anyway", fact=words)
                    else:
                        ground = self._naming.relation(bounds)
                        yield say("derived.anyway-as", fact=words, ground=ground)

    def _moves(
        self, names: tuple[str, ...]
    ) -> tuple[str, lay.Layout, Sentence | lay.Layout] | None:
        """Which way a body moves, where that is given, and so the sign of its component."""
        sense = self._derivation.fact(names[0]) if len(names) == 1 else None
        motion = motion_of(sense)
        if sense is None or motion is None:
            return None
        body, direction = motion
        return body, self._naming.layout(direction), self._naming.fact(sense)

    def _fact(self, name: str) -> Sentence | lay.Layout:
        fact = self._derivation.fact(name)
        assert fact is not None
        return self._naming.fact(fact)


def _of_differences(base: Line | Fact, name: str) -> str:
    """The name of the identity of a sum of angles; of a difference, where all in it are that."""
    if not isinstance(base.relation, Relation):
        return name
    signs = {
        each.argument.op
        for tree in trees_of(base.relation)
        for each in walk(tree)
        if isinstance(each, Apply) and isinstance(each.argument, Binary)
        if each.function in ("sin", "cos", "tan") and each.argument.op in ("+", "-")
    }
    return "derived.difference-of-angles" if signs == {"-"} else name


def _under(tree: Expression) -> tuple[Expression, ...]:
    """What stands under a root, and its size if it is no sum."""
    return (tree.argument,) if isinstance(tree, Apply) and tree.function == "sqrt" else ()


# How an angle is made of two to the line of centres, and what is said of it.
_TANGENTS = {"sum": "derived.tangent-of-sum", "difference": "derived.tangent-of-difference"}
_TURNED = {
    "difference": "turned.on",
    "rest-of-sum": "turned.back",
    "straight": "turned.straight",
}
_OR_ACROSS = {"difference": "turned.on-or-across", "rest-of-sum": "turned.back-or-across"}
_BESIDE = {
    "square": "between.beside-same",
    "square-and-more": "between.beside-opposite",
}
_BETWEEN = {
    "sum": "between.opposite-sides",
    "difference": "between.one-side",
    "rest-of-sum": "between.opposite-senses",
    "rest-of-difference": "between.both-opposite",
    "square": "between.square-same",
    "square-and-more": "between.square-opposite",
    "straight": "between.right",
}


def _is_rest(fact: Fact) -> bool:
    """Whether a velocity is given as that of a body at rest."""
    match fact.relation.only[0].right:
        case Pair(x, y):
            return is_zero(x) and is_zero(y)
    return False


def _is_by_an_angle(speed: Expression) -> bool:
    """Whether a speed is a component over a sine or cosine of an angle in degrees."""
    match speed:
        case Binary("/", _, Apply("sin" | "cos", Degrees())):
            return True
    return False


def _sense_of(velocity: Expression) -> Expression | None:
    """**i** or **j**, or its opposite, along which a velocity is; None of any other."""
    match velocity:
        case Unit():
            return velocity
        case Negate(operand):
            sense = _sense_of(operand)
            return sense.operand if isinstance(sense, Negate) else sense and Negate(sense)
        case Binary("*", Number() | Letter() | Binary("*", Number(), Letter()), Unit() as unit):
            return unit  # numbers carry no sign
    return None


def _kind_of(angle: Expression) -> str:
    return angle.kind if isinstance(angle, Quantity) else ""


def _form_of(angle: Expression) -> str:
    """The form in which an angle is written by others."""
    straight, right = Degrees(Fraction(180)), Degrees(Fraction(90))
    match angle:
        case Degrees():
            return "straight"
        case Binary("+" | "-" as sign, left, other) if right in (left, other):
            return "square" if sign == "-" else "square-and-more"
        case Binary("+", Binary("-", left, _), _) if left == straight:
            return "rest-of-difference"
        case Binary("+"):
            return "sum"
        case Binary("-", Binary("-", left, _), _) if left == straight:
            return "rest-of-sum"
    return "difference"


def _across(axis: Expression) -> Unit | None:
    """The other one of **i** and **j**."""
    return Unit("j" if axis.axis == "i" else "i") if isinstance(axis, Unit) else None


def _degrees(tree: Expression) -> Fraction:
    """An angle that is a number of degrees; 0 for any other."""
    match tree:
        case Negate(operand):
            return -_degrees(operand)
        case Degrees(value):
            return value
    return Fraction(0)


def _has_vector(tree: Expression) -> bool:
    return any(isinstance(node, Unit | Pair | Polar) for node in walk(tree))


def _is_multiple(relation: Relation | Meaning) -> bool:
    """Whether a velocity is a multiple of another."""
    match relation:
        case Relation(((Link(Quantity("velocity") as one, "=", right),),)):
            return any(
                isinstance(node, Quantity) and node.kind == "velocity" and node != one
                for node in walk(right)
            )
    return False


def _subject(relation: Relation) -> Expression | None:
    """The letter of which a line says what it is."""
    left = relation.options[0][0].left
    return left if isinstance(left, Letter) else None


def _read_off(line: Line) -> str | None:
    """The body of which a line says the direction, without a tangent."""
    match line.relation:
        case Relation(((Link(Quantity("direction", (Name(body),), int()), "="), *_),)):
            return body
    return None
