"""What stands before the rows of a line, beside its title: how it comes from the lines above."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import takewhile
from typing import Any

from restitution.exact import tidy
from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Line,
    Link,
    Relation,
    is_same_identity,
    numbers_in,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import trees_of
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
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_binary,
    unsigned,
    walk,
)
from restitution.render import layout as lay
from restitution.workings.leads.extremes import value_compared
from restitution.workings.leads.offsets import (
    angle_of_offset,
    is_offset,
    offset_sentence,
    turned_sentence,
)
from restitution.workings.leads.one_component import went_from_rest
from restitution.workings.leads.rearranged import step_of
from restitution.workings.leads.scalar_products import slope_title
from restitution.workings.leads.senses import (
    sense_of_a_change,
    sense_of_a_given_line,
    sense_of_a_normal,
)
from restitution.workings.leads.shapes_of_lines import (
    body_read_off,
    read_off_lines,
)
from restitution.workings.leads.titles import Titles
from restitution.workings.leads.touching import touching_beside
from restitution.workings.leads.turn_leads import BY
from restitution.workings.naming.contacts import at_contact
from restitution.workings.naming.facts import fact_in_words
from restitution.workings.naming.measured import worth
from restitution.workings.naming.sources import Source
from restitution.workings.reasons.factors import cosine_divided, factor_cancelled
from restitution.workings.reasons.in_any_case import bounds_behind, range_behind


class Leads(Titles):
    """The words before the rows of one derivation, written from the top."""

    def behind(self, line: Line) -> tuple[Sentence, ...]:
        """The value of a letter that a definition puts in, which stands behind the line."""
        return (self._behind[line.number],) if line.number in self._behind else ()

    def of(self, line: Line, above: Sentence | None) -> Iterator[Sentence]:
        """What is said before the rows of a line, under a title ``above``."""
        if line.move.id == "fact":
            yield from self._before_a_fact(line)
            return
        source = self._sources.of(line)
        sentences = self._by_what_it_is(line, above)
        if sentences is None:
            sentences = self._by_its_direction(line)
        if sentences is None:
            sentences = self._by_its_step(line, source)
        if sentences is not None:
            yield from sentences
        elif source is not None:
            yield from self._source(source, line)

    def _before_a_fact(self, line: Line) -> Iterator[Sentence]:
        """What is said before a line that takes a fact of the data."""
        given = [fact for ref in line.premises if (fact := self._derivation.fact(str(ref)))]
        needed = self._of_the_story(line)
        if needed is not None:
            yield needed
            return
        if given and given[0].relation == line.relation and given[0].kind == "geometry":
            return  # a direction of the data, which the row says in words
        at = at_contact(self._naming, given[0]) if given else None
        beside = touching_beside(self._derivation, self._naming, given[0], line) if given else None
        if at is not None:
            yield beside or at
        elif given and isinstance(words := fact_in_words(self._naming, given[0]), Sentence):
            yield say("given.fact", fact=words)
        elif (offset := next(filter(is_offset, given), None)) is not None:
            assert isinstance(line.relation, Relation)
            # Once the offset is known, the same fact gives the line in numbers.
            if (turned := turned_sentence(offset, self._naming, line.relation)) is not None:
                yield turned
            elif offset.id in self._given:
                yield self._of_a_known_offset(offset, line) or self._worked_out(offset, line)
            else:
                yield offset_sentence(offset, self._naming, given=False)
            self._given.add(offset.id)
        else:
            yield say("given.data")

    def _by_what_it_is(self, line: Line, above: Sentence | None) -> tuple[Sentence, ...] | None:
        """What is said of signs, of a letter for an angle, of a component or a unit vector.

        None of any other line.
        """
        signs = self._by_signs(line)
        if signs is not None:
            return (signs,)
        letter = letter_of_offset(line)
        if letter is not None:
            offset = next(e for ref in line.premises if (e := self._derivation.fact(str(ref))))
            again = offset.id in self._given
            self._given.add(offset.id)
            return (offset_sentence(offset, self._naming, given=again, letter=letter),)
        if self.resolves(line) and line.move.id == "define":
            title = self.resolved(line)
            return () if title is None or title == above else (title,)
        if self._beside_normal(line):
            return (say("wall.beside-normal"),)
        chords = self._round_by_one_angle(line)
        if chords is not None:
            return (chords,)
        for sense_of in (sense_of_a_normal, sense_of_a_change, sense_of_a_given_line):
            sense = sense_of(self._derivation, self._naming, line)
            if sense is not None:
                return (sense,)
        moving = self._along_a_velocity(line)
        if moving is not None:
            return (say("centres.along", velocity=self._naming.layout(moving)),)
        struck = self._by_its_impulse(line)
        if struck is not None:
            return (say("given.impulse-turned", body=struck),)
        bodies = self._from_centre_to_centre(line)
        if bodies is not None:
            return (say("centres.between", one=bodies[0], other=bodies[1]),)
        start = _velocity_of_data(line)
        if start is not None:
            return (say("derived-assembled.at-start", body=start),)
        return (say("so"),) if line.move.record == "wall-direction" else None

    def _round_by_one_angle(self, line: Line) -> Sentence | None:
        """Why three chords that close make one angle with the radii, and what they subtend."""
        match line.relation if line.move.record == "round" else None:
            case Relation(((Link(Binary("*", right=Binary("-", right=turn) as span)),),)):
                assert isinstance(turn, Binary)
                layout = self._naming.layout
                return say("round.same", angle=layout(turn.right), span=layout(span))
        return None

    def _by_its_direction(self, line: Line) -> tuple[Sentence, ...] | None:
        """What is said of a line that a body moves along, and of an angle; None of any other."""
        body = body_read_off(line) if line.move.record == "parallel" else None
        if body is not None:
            return (self._read_off(line, body),)
        if line.move.record in ("perpendicular", "parallel") and self.title(line) is None:
            right = line.move.record == "perpendicular"
            apart = self._apart(line) if right else slope_title(self._naming, line)
            return (
                apart
                or self._along_axes(line)
                or self._along_its_line(line)
                or self._seen(line)
                or self._none_in(line)
                or self._direction_again(line)
                or self._since_nothing(line)
                or self._along_a_multiple(line)
                or say("so"),
            )
        if line.move.record == "speed" and self._by_a_multiple(line):
            return (say("so"),)
        directed = self._about_directions(line)
        if directed is None and self.title(line) is None:
            directed = self._by_its_component(line)
        return None if directed is None else (directed,)

    def _read_off(self, line: Line, body: str) -> Sentence:
        """The line along which a body moves, from which its direction is read off."""
        assert isinstance(line.relation, Relation)
        angle = line.relation.only[0].right
        size = unsigned(angle)
        if size not in (Degrees(Fraction(0)), RIGHT_ANGLE, STRAIGHT_ANGLE):
            square = isinstance(angle, Binary) and angle.right == RIGHT_ANGLE
            which = "derived.across-centres" if square else self._along_centres(line, body)
            across = self._across_of(line, body) if square else None
            if across is not None:
                return say("derived.across-centres-with", body=body, value=across)
            return say(which, body=body)
        axis: Expression = Unit("j" if size == RIGHT_ANGLE else "i")
        back = size != angle or size == STRAIGHT_ANGLE
        stage = getattr(line.relation.only[0].left, "stage", None)
        return self._along_axis(line, body, stage, Negate(axis) if back else axis)

    def _by_its_step(self, line: Line, source: Source | None) -> tuple[Sentence, ...] | None:
        """What is said of a factor that goes, and of an identity; None of any other step."""
        factor = factor_cancelled(self._derivation, line) if line.move.id == "cancel" else None
        known = self._reasons.known(line) if factor is not None else ()
        if factor is not None and known:
            return (self._cancelled(factor, known, line, source),)
        rearranges = line.move.id == "rearrange"
        angle_divided = cosine_divided(self._derivation, line) if rearranges else None
        if angle_divided is not None:
            return (self._by_cosine(angle_divided),)
        rearranged = self._angles_given(line) if rearranges else None
        if rearranged is not None and line.premises == (rearranged.id,):
            return (say("derived.since", facts=(fact_in_words(self._naming, rearranged),)),)
        own = self._divided(line) or self._of_the_story(line) or self._of_a_sense(line)
        own = own or step_of(self._derivation, self._naming, line)
        if own is not None:
            return (own,)
        if line.move.id == "identity" and line.move.record in BY:
            return (self._by_an_identity(line, source),)
        return None

    def _as_it_stands(self, factor: Expression, line: Line) -> Expression:
        """A factor in the sense in which it stands above: 2 − e, and not e − 2."""
        match factor:
            case Binary("-", left, right):
                other = Binary("-", right, left)
            case _:
                return factor
        cited = self._derivation.lines_in(line.premises)
        nodes = {node for own in cited for tree in trees_of(own.relation) for node in walk(tree)}
        return other if other in nodes and factor not in nodes else factor

    def _cancelled(
        self,
        factor: Expression,
        known: tuple[Sentence | lay.Layout, ...],
        line: Line,
        source: Source | None,
    ) -> Sentence:
        """Which factor is cancelled, and by what it is known not to be zero."""
        formula = self._naming.layout(self._as_it_stands(factor, line))
        equations = () if source is None else self._numbers(source)
        if len(equations) > 1:
            first, *rest = equations
            return say(
                "derived.cancel-by", factor=formula, reasons=known, first=first, equations=rest
            )
        assert isinstance(line.relation, Relation)
        ordered = line.relation.options[0][0].sign in FLIPPED
        name: SentenceId = "derived.cancel-positive" if ordered else "derived.cancel"
        return say(name, factor=formula, reasons=known)

    def _by_an_identity(self, line: Line, source: Source | None) -> Sentence:
        """By which identity a line comes, from which equation or from which given angles."""
        how = self._by_the_half(line) or self._by_squares(line) or say(self._identity(line))
        equations = self._numbered(self._alike(line)) if source is not None else ()
        fact = self._angles_given(line)
        if fact is not None and line.move.record == "complement":
            return say("derived.since", facts=(fact_in_words(self._naming, fact),))
        if fact is not None and fact.id not in self._given:
            self._given.add(fact.id)
            return say("derived.since-by", facts=(fact_in_words(self._naming, fact),), how=how)
        if equations:
            return say("derived.by-from", how=how, equations=equations)
        return say("derived.by", how=how)

    def _alike(self, line: Line) -> list[int]:
        """The numbers of equations to which one identity is applied, line by line, as here."""
        lines = [own for own in self._derivation.lines if own.shown != "silent"]
        place = lines.index(line)
        above = takewhile(lambda own: is_same_identity(own, line), reversed(lines[:place]))
        below = takewhile(lambda own: is_same_identity(own, line), lines[place:])
        sources = [self._sources.of(own) for own in (*above, *below)]
        return [number for source in sources if source for number in source.numbered]

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
            rested = [went_from_rest(self._derivation, self._naming, *state) for state in moving]
            bodies = tuple(body for body, _ in moving)
            name: SentenceId = "derived.each-along" if not all(rested) else "derived.each-from-rest"
            return say(name, bodies=bodies)
        return None

    def _of_a_sense(self, line: Line) -> Sentence | None:
        """The given direction that tells which way a component points."""
        given = [fact for ref in line.premises if (fact := self._derivation.fact(str(ref)))]
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

    def _along_a_velocity(self, line: Line) -> Quantity | None:
        """The velocity along which the data have the line of centres that a line works out."""
        for ref in line.premises if line.move.id == "put" else ():
            fact = self._derivation.fact(str(ref))
            match None if fact is None else fact.relation.options:
                case ((Link(Quantity("line_of_centres"), _, Quantity("velocity") as velocity),),):
                    return velocity
        return None

    def _by_its_impulse(self, line: Line) -> str | None:
        """The body of which a line has the impulse by its size and its angle, above its value."""
        for ref in line.premises if line.move.id == "put" else ():
            fact = self._derivation.fact(str(ref))
            match None if fact is None else fact.relation.options:
                case ((Link(Quantity("impulse", (Name(body),)), "=", Polar()),),) if (
                    isinstance(line.relation, Relation) and line.relation.only[0].sign == "="
                ):
                    return body
        return None

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
        facts = [given for ref in line.premises if (given := self._derivation.fact(str(ref)))]
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

    def _every_value(self, line: Line, letter: Letter, worked: Sequence[Line]) -> Sentence:
        """That a letter may have every value, as what was worked out above always holds."""
        name, own = self._naming.layout(letter), [other.relation for other in worked]
        if len(own) == 1 and isinstance(own[0], Relation):
            bounds = tuple(map(self._naming.relation, bounds_behind(self._naming, own[0])))
            if bounds:
                return say("range.every-holds-as", bounds=bounds, letter=name)
        if worked:
            return say("range.every-holds", letter=name)
        before = any(
            other.item == line.item and other.number < line.number
            for other in self._derivation.lines
        )
        return say("range.every" if before else "range.every-free", letter=name)

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
                worked = [o for o in above if o.move.id in ("put", "rearrange", "cancel")]
                facts = [self._derivation.fact(str(ref)) for ref in line.premises]
                lines = [own.relation for own in above]
                agreed = [fact for fact in facts if fact is not None and fact.relation in lines]
                if any(fact is not None and fact.kind == "range" for fact in facts):
                    yield say("given.data")  # what is given of the letter bounds it
                elif agreed:
                    given = tuple(fact_in_words(self._naming, fact) for fact in agreed)
                    yield say("range.every-given", facts=given, letter=self._naming.layout(letter))
                else:
                    yield self._every_value(line, letter, worked)
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


def _velocity_of_data(line: Line) -> str | None:
    """Who has the velocity at the start that a line only writes by components; None of others."""
    match line.relation:
        case Relation(((Link(Quantity("velocity", (Name(body),), 0), "="),),)) if (
            line.move.id == "rearrange"
            and f"velocity {body}" in line.premises
            and all(isinstance(ref, str) for ref in line.premises)
        ):
            return body
    return None
