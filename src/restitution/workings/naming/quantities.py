"""How a working calls the quantities of the motion: letters that a reader knows, or plain words.

What is vectors has letters in bold type (`bold_letters`). When something is so is told only where
it is not plain from what stands above: the heading of an impact, or the end of the motion.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import field, replace
from functools import cached_property

from restitution.errors import RestitutionError
from restitution.explaining.lines.derivation import Derivation, Event, Link, Meaning, Relation
from restitution.explaining.lines.layouts import AsTyped, of_relation, of_tree
from restitution.explaining.lines.saying import Sentence, operand, say
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.quantities import ANGLES, KINDS
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Stage,
    Unit,
    is_quantity,
    unsigned,
    walk,
)
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.shapes import Circle
from restitution.solving.story.letters import roles
from restitution.wording.telling import has_axes, letters_of_formulas
from restitution.workings.naming.bold_letters import BoldLetters, Used
from restitution.workings.naming.foreseen import foreseen
from restitution.workings.naming.moments import Moments
from restitution.workings.naming.slanting_walls import are_slanting
from restitution.workings.naming.terms import Terms, terms_of

# Components at a wall, by their sense.
_PARALLEL = "derived.component-parallel"
_TOWARDS, _AWAY = "derived.component-towards", "derived.component-away"
# Letters for angles between two directions.
_ANGLES = ("beta", "theta", "phi", "psi", "gamma")


@dataclass
class Naming(Moments):
    """The names of one working; ``now`` is the event under whose heading the next line stands.

    ``used`` are the bold letters that it needs, where that is known; ``shared`` the names of the
    same working without them, of which those are taken over that no bold letter changes. One that
    ``foresees`` takes those that its lines are likely to need. At ``turned`` events components
    across the normal of a wall count to its right.
    """

    used: Used | None = None
    shared: Naming | None = None
    foresees: bool = False
    turned: frozenset[int] = frozenset()
    _own: dict[Expression, lay.Layout] = field(default_factory=dict)
    _pending: list[Sentence] = field(default_factory=list)

    def __post_init__(self) -> None:
        super().__post_init__()
        self.vectors = frozenset(name for name, meaning in self.meanings.items() if meaning.vector)
        shared = self.shared
        self.terms: Terms = shared.terms if shared else terms_of(self.derivation, self.problem)
        self._used = set(self.terms.letters)
        self.bold: BoldLetters = BoldLetters(
            self.derivation,
            self._used,
            self._plain_when,
            self.layout,
            self.used,
            frozenset(self.circles),
            roles(self.problem),
            directions=shared.bold.directions if shared else None,
            turned=self.turned,
        )
        if self.foresees:
            self.bold.used = foreseen(self.derivation, self.bold.has_unit)
        times = {
            quantity for quantity in self.terms.often if quantity.kind == "time" and quantity.stage
        }
        #: The letters by which the statement calls times.
        self._of_the_statement = dict(_named_times(self.derivation))
        #: The letters by which the question calls speeds and times.
        self._of_the_question: Mapping[Quantity | Binary, str] = (
            shared._of_the_question if shared else letters_of_formulas(self.problem)
        )
        #: Whether the times of events have numbers: where there are several.
        self._numbered_times = self.several or len(times) > 1
        self.introduced_early: set[str] = set()
        self._letters = {
            meaning.quantity: name
            for name, meaning in self.meanings.items()
            if isinstance(meaning.quantity, Quantity) and meaning.quantity in self.terms.inside
        }

    # --- for the writer -------------------------------------------------------------------------

    def layout(self, tree: Expression) -> lay.Layout:
        """A tree as it stands in a line."""
        for node in walk(tree):
            match node:
                case Binary("-", Quantity("time", (), int()), Quantity("time", (), int()) as early):
                    self.name(early)  # it is introduced before the later one
        named = self._displacement(tree) or self._lost_by_one(tree)
        return named or of_tree(tree, self.vectors, self._in_a_row, self.terms.forms)

    def _in_a_row(self, tree: Quantity | Binary) -> lay.Layout | None:
        """What a quantity is called, and the share of the energy that the one impact takes."""
        match tree:
            case Binary("/", _, Quantity("energy", bodies, 0)) if (
                not self.several and len(self.impacts) == 1
            ):
                (impact,) = self.impacts
                if not bodies or (impact.wall and bodies == (Name(impact.bodies[0]),)):
                    return operand(say("derived.fraction-lost"))
        return self._lost_by_one(tree) or self.name(tree)

    def _displacement(self, tree: Expression) -> lay.Layout | None:
        """How far a body comes along **i** or **j** from one event to another, in words."""
        match tree:
            case Binary(
                "-",
                Quantity("along", (Quantity("position", (Name(body),), int(late)), Unit() as axis)),
                Quantity(
                    "along", (Quantity("position", (Name(other),), int(early)), Unit() as same)
                ),
            ) if body == other and axis == same:
                first, last = self._started(early), self._started(late)
                sides = {"body": body, "axis": self.layout(axis), "early": first, "late": last}
                return operand(say("derived.displacement", **sides))
        return None

    def _lost_by_one(self, tree: Expression) -> lay.Layout | None:
        """What one body loses, or gains, in an impact, in words: a difference of two energies."""
        match tree:
            case Binary(
                "-",
                Quantity("energy", (Name(body),), int(first)),
                Quantity("energy", (Name(other),), int(second)),
            ) if body == other and max(first, second) in self.events:
                early, late = sorted((first, second))
                words = say("derived.energy-gained-by", body=body)
                if first == early:
                    words = say("derived.energy-lost-by", body=body)
                own = (event.number for event in self.events.values() if body in event.bodies)
                if early == max((number for number in own if number < late), default=0):
                    return operand(self._during(words, Quantity("energy_lost", (), late)))
        return None

    def in_fractions(self, tree: Expression) -> bool:
        """Whether a tree is a tangent where angles are told by fractions, also beside decimals."""
        return isinstance(tree, Apply) and self.terms.forms.angles_by_fractions

    def as_typed(self, tree: Expression) -> lay.Layout:
        """A tree of the statement in the form in which it stands there."""
        return of_tree(tree, self.vectors, self.name, AsTyped())

    def relation(self, relation: Relation) -> lay.Layout:
        """A whole relation in one line."""
        return of_relation(relation, self.vectors, self.name, self.terms.forms)

    @property
    def bodies(self) -> dict[str, str]:
        """The bodies of the story, and what each is; and walls that may be struck after it."""
        return {wall.name: "wall" for wall in self.problem.walls} | {
            body: "wall" if event.wall and n else "sphere"
            for event in self.events.values()
            for n, body in enumerate(event.bodies)
        }

    def introduced(self) -> tuple[Sentence, ...]:
        """What letters stand for that have come into use since this was last asked."""
        pending, self._pending = tuple(self._pending), []
        return (*self.bold.introduced(), *pending)

    @property
    def letters(self) -> dict[Expression, str]:
        """The letters that are in use by now, by the quantities for which they stand."""
        return {
            tree: f"{symbol.name}_{symbol.subscript}" if symbol.subscript else symbol.name
            for tree, symbol in self._own.items()
            if isinstance(symbol, lay.Letter)
        }

    def knows(self, tree: Expression, letter: str) -> None:
        """A quantity has a letter from now on, and is called by it."""
        if not isinstance(tree, Quantity):
            return
        if tree.kind in ANGLES or tree.kind == "time":
            self._own[tree] = lay.letter(letter)
        meaning = self.meanings.get(letter)
        if (
            tree.kind == "along"
            and meaning is not None
            and meaning.sense in (None, tree.arguments[1])
        ):
            vector, axis = tree.arguments
            axes = [axis]
            event = self.event_of_axis(axis)
            name = "" if event is None else f"axis {event.number}"
            fact = self.derivation.fact(name)
            if fact is not None and fact.relation.only[0].sign == "=":
                axes.append(fact.relation.only[0].right)
            for other in axes:
                self._own[replace(tree, arguments=(vector, other))] = lay.letter(letter)

    def name(self, tree: Quantity | Binary) -> lay.Layout | None:
        """What a quantity is called among letters; a quotient has no name."""
        if isinstance(tree, Binary):
            return None
        if tree in self._own:
            return self._own[tree]
        terms = self.terms
        match tree:
            case Quantity("velocity", (Name(body),), _):
                return self._velocity(tree, body)
            case Quantity("along" | "across" as kind, (Quantity("velocity", (Name(),)) as v, axis)):
                return self._scalar_product(kind, v, axis) or operand(self.quantity(tree))
            case Quantity("time", (), int(stage)) if stage in self.events:
                if tree in self._of_the_statement:
                    return lay.letter(self._of_the_statement[tree])
                return self._lettered(tree, "t", str(stage) if self._numbered_times else "")
            case Quantity(kind) if kind in ANGLES and tree in self._letters:
                return self._early(tree)
            case Quantity("deflection", _, _) if tree in terms.inside or terms.often[tree] > 1:
                turns = {quantity for quantity in terms.often if quantity.kind == "deflection"}
                turns -= {meaning.quantity for meaning in self.meanings.values()}
                return self._lettered(tree, "delta", str(tree.stage) if len(turns) > 1 else "")
            case Quantity("angle", _, _) if tree in terms.inside:
                free = (angle for angle in _ANGLES if angle not in self._used)
                return self._lettered(tree, next(free, _ANGLES[0]))
            case Quantity("dot", (vector, Quantity("line_of_centres", (), int(stage)))):
                unit = self.bold.unit_of_the_line(stage)
                return None if unit is None else lay.product(self.layout(vector), unit, sign="·")
            case Quantity("dot", _, _):
                return None
        if tree in self._of_the_question:
            name = self._of_the_question[tree]
            if name in self._used:
                return operand(self.quantity(tree))
            self._used.add(name)
            noun, number = self._noun(tree), self._settled(tree)
            words = self.quantity(tree)
            if noun is not None and number is not None:
                words = say("derived.when", quantity=noun, when=self._plain_when(number))
            return self._introduced(tree, lay.letter(name), words)
        return operand(self.quantity(tree))

    def has_taken(self, letter: str) -> bool:
        """Whether a letter stands for something by now."""
        return letter in self._used

    def has_letter_of_the_question(self, tree: Expression) -> bool:
        """Whether a speed is called by the letter that the question has for it."""
        if not isinstance(tree, Quantity) or tree not in self._of_the_question:
            return False
        return isinstance(self.name(tree), lay.Letter)

    def times_of_the_question(self) -> Mapping[Expression, str]:
        """The letters that the question has for times, and the working for nothing else."""
        own = self._of_the_question.items()
        return {
            e: name for e, name in own if not is_quantity(e, "speed") and name not in self._used
        }

    def _early(self, tree: Quantity) -> lay.Layout:
        """The letter that a later line has for an angle of which a sine or the like stands here."""
        letter = self._letters[tree]
        self.introduced_early.add(letter)
        return self._introduced(tree, lay.letter(letter), self.quantity(tree))

    def _introduced(self, tree: Quantity, symbol: lay.Layout, words: Sentence) -> lay.Layout:
        """A letter that stands for a quantity from here on, which is said before the line."""
        meaning = say("derived.meaning", letter=symbol, quantity=words)
        self._own[tree] = symbol
        self._pending.append(say("derived.let", meanings=(meaning,)))
        return symbol

    def _lettered(self, tree: Quantity, letter: str, subscript: str = "") -> lay.Layout:
        """A letter for a quantity without a short name; words where the letter is taken."""
        name = f"{letter}_{subscript}" if subscript else letter
        if name in self._used:
            return operand(self.quantity(tree))
        words = self.quantity(tree)
        self._used.add(name)
        symbol = lay.letter(name)
        self._own[tree] = symbol
        meaning = say("derived.meaning", letter=symbol, quantity=words)
        self._pending.append(say("derived.let", meanings=(meaning,)))
        return symbol

    def _velocity(self, tree: Quantity, body: str) -> lay.Layout:
        number = self._settled(tree)
        if number is None or (number == 0 and "u" in self.vectors):
            own = lay.Bold("v", body)
            when = self._when(number, body)
            return own if when is None else operand(say("derived.when", quantity=own, when=when))
        return self.bold.velocity(body, number)

    def _scalar_product(self, kind: str, vector: Quantity, axis: Expression) -> lay.Layout | None:
        """A component along a slanting line, or across it: by the unit vector in its direction."""
        event = None if isinstance(axis, Negate) else self.event_of_axis(axis)
        if event is None or not self.bold.has_unit(event.number):
            return None
        velocity = self.layout(vector)
        unit = self.bold.unit(event.number, kind)
        return None if unit is None else lay.product(velocity, unit, sign="·")

    # --- words ----------------------------------------------------------------------------------

    def quantity(self, tree: Expression) -> Sentence:
        """A quantity in words, with the time where it is not plain."""
        match tree:
            case Quantity("along" | "across" as kind, (vector, axis)):
                return self._component(kind, vector, axis)
            case Quantity("restitution", (), _):
                return self._during(say("derived.coefficient"), tree)
            case Quantity("impulse", (), _):
                given = self.events.get(_number(tree.stage) or 0)
                if given is not None and given.kind == "kick" and self.several:
                    return say("derived.kick-size", event=self._event(given))
                return self._during(say("derived.impulse-size"), tree)
            case Quantity("impulse", (Name(body),), int(number)) if (
                number in self.events and self.events[number].kind == "kick"
            ):
                return say("derived.impulse-given", of=(body,))
            case Quantity("energy", bodies, stage):
                words = self._energy(bodies)
                if (
                    isinstance(stage, int)
                    and stage
                    and (self._is_beside_other_times(tree) or self._changes_later(bodies, stage))
                ):
                    return say("derived.when", quantity=words, when=self._plain_when(stage))
                return self._after(words, tree, None)
            case Quantity("total_energy_lost", _, _):
                return say("derived.energy-lost-all" if self.several else "derived.energy-lost")
            case Quantity("angle", arguments, _):
                return say("derived.angle", of=tuple(self.side(argument) for argument in arguments))
            case Quantity("time", (), int(stage)) if stage in self.events:
                return say("derived.time", event=self._moment(stage, of=True))
            case Quantity("position", (Name(body),), stage):
                return self._at(say("derived.position", body=body), stage)
            case Quantity("distance") if tree in self._chords:
                return say("derived.chord")
            case Quantity("distance", arguments, stage):
                between = self._between_places(arguments)
                if between is not None:
                    return between
                arguments, stage = _at_one_time(arguments, stage)
                return self._at(say("derived.distance", of=tuple(map(self._end, arguments))), stage)
            case Quantity("line_of_centres", _, stage):
                is_bold = isinstance(stage, int) and self.bold.direction(stage, "along") is not None
                return say("derived.line-unit") if is_bold else say("derived.line")
            case Quantity("direction", (Name(),), int()):
                velocity = Quantity("velocity", tree.arguments, tree.stage)
                unit = self.layout(Unit("i"))
                return say("derived.direction", velocity=self.layout(velocity), unit=unit)
            case Quantity() if (noun := self._noun(tree)) is not None:
                if KINDS[tree.kind].of_an_event:
                    return self._during(noun, tree)
                after = isinstance(tree.stage, int) and tree.stage
                if after and tree.kind == "momentum" and self._is_beside_other_times(tree):
                    return say("derived.when", quantity=noun, when=self._plain_when(after))
                return self._after(noun, tree, next(iter(names_of(tree)), None))
            case Quantity(_, _, stage) if stage is not None:
                words = say("derived.value", value=lay.from_tree(self._timeless(tree)))
                return self._at(words, stage)
        return say("derived.value", value=lay.from_tree(self._timeless(tree)))

    def _noun(self, tree: Quantity) -> Sentence | None:
        """What the record of a quantity calls it, of spheres or of all; None of any other."""
        record, names = KINDS[tree.kind], names_of(tree)
        if not tree.arguments:
            return say("derived.of-all", noun=record.called_of_all) if record.of_all else None
        if tree.kind == "velocity" or len(names) < len(tree.arguments) or not record.staged:
            return None  # a velocity has its letter
        if any(self.bodies.get(name) == "wall" for name in names):
            return None
        return say("derived.of-bodies", noun=record.in_formulas, of=names)

    def when(self, tree: Expression) -> Sentence | None:
        """When a quantity is as a line says, in words; None of what has no time."""
        match tree:
            case Quantity("distance", arguments, stage):
                return self._when_at(_at_one_time(arguments, stage)[1])
            case Quantity(_, _, int(stage)):
                return self._when_at(stage)
        return None

    def _between_places(self, ends: tuple[Expression, ...]) -> Sentence | None:
        """A distance between two places of one body; None of another distance."""
        match ends:
            case (
                Quantity("position", (Name(body),), first),
                Quantity("position", (Name(other),), second),
            ) if body == other:
                early, late = self._when_at(first), self._when_at(second)
                if early is not None and late is not None:
                    return say("derived.distance-of", body=body, early=early, late=late)
        return None

    def _of_other_times(self, tree: Quantity) -> bool:
        """Whether the working speaks of the same quantity at another time."""
        return any(
            quantity.arguments == tree.arguments
            and (
                quantity.kind == f"total_{tree.kind}"
                or (quantity.kind == tree.kind and quantity.stage != tree.stage)
            )
            for quantity in self.terms.often
        )

    def _changes_later(self, bodies: tuple[Expression, ...], stage: int) -> bool:
        """Whether a later impact changes the energy of some bodies, or of all without any."""
        names: list[str | None] = [body.name for body in bodies if isinstance(body, Name)]
        return any(stage < self.last(name) for name in names or [None])

    def _is_beside_other_times(self, tree: Quantity) -> bool:
        """Whether the working speaks of an energy at another time, or so of one of another body."""
        return self._of_other_times(tree) or any(
            self._of_other_times(quantity)
            for quantity in (() if self.several else self.terms.often)
            if (quantity.kind, quantity.stage) == (tree.kind, tree.stage)
            and bool(quantity.arguments) == bool(tree.arguments)
        )

    def of_letter(self, meaning: Meaning) -> Sentence:
        """What a letter stands for."""
        match meaning.quantity:
            case Quantity("speed", (Name(body),), _) as tree if not self.several:
                late = self._plain_when(self._settled(tree))
                return say("derived.when", quantity=say("derived.speed", of=(body,)), when=late)
            case Quantity("angle", sides) if meaning.angle == "acute" or are_slanting(
                self.derivation, sides
            ):
                return say("derived.acute-angle", of=tuple(map(self.side, sides)))
        return self.quantity(meaning.quantity)

    def extreme(self, tree: Expression, *, greatest: bool) -> Sentence:
        """The greatest or the least value of a quantity."""
        formula = self.layout(tree)
        if isinstance(formula, lay.Words | lay.Phrase):
            name = "derived.greatest-named" if greatest else "derived.least-named"
        else:
            name = "derived.greatest" if greatest else "derived.least"
        return say(name, quantity=formula)

    def _end(self, tree: Expression) -> Sentence | lay.Layout | str:
        """What a distance is measured from."""
        match tree:
            case Name(name):
                return name
            case Quantity():
                return say("derived.the", quantity=self.quantity(tree))
        return self.layout(tree)

    def side(self, tree: Expression) -> Sentence | lay.Layout | str:
        """A direction or a vector among words."""
        match tree:
            case Name(name):
                return name
            case Quantity("direction", (Name(name),)) if self.bodies.get(name) == "wall":
                return name
            case Quantity("line_of_centres", _, stage):
                return self._centres(stage)
        return self.layout(tree)

    def _centres(self, stage: Stage) -> Sentence:
        """The line of centres of an event: at a wall the normal, at a circular one the radius."""
        event = self.events.get(stage) if isinstance(stage, int) else None
        if event is None or not event.wall:
            return say("derived.centres")
        if event.bodies[1] in self.circles:
            return say("derived.radius", body=event.bodies[0])
        return say("derived.normal", wall=event.bodies[1])

    def unit_vector(self, event: Event) -> Sentence:
        """The unit vector along the line of centres of an event, or into its wall."""
        if not event.wall or event.bodies[1] in self.circles:
            return say("derived.line-unit")
        return say("derived.normal-unit", wall=event.bodies[1])

    @property
    def circles(self) -> set[str]:
        """The walls that are circular."""
        return {wall.name for wall in self.problem.walls if isinstance(wall.shape, Circle)}

    @cached_property
    def _chords(self) -> frozenset[Expression]:
        """The distances that lines call chords of a circular wall."""
        return frozenset(
            line.relation.options[0][0].left
            for line in self.derivation.lines
            if line.move.record == "chord" and isinstance(line.relation, Relation)
        )

    def _energy(self, bodies: tuple[Expression, ...]) -> Sentence:
        names = tuple(body.name for body in bodies if isinstance(body, Name))
        if names:
            return say("derived.energy-of", bodies=names)
        return say("derived.energy-all") if self.movers > 1 else say("derived.energy")

    @property
    def movers(self) -> int:
        """How many bodies move."""
        return sum(body == "sphere" for body in self.bodies.values())

    def _component(self, kind: str, vector: Expression, axis: Expression) -> Sentence:
        of: Sentence | lay.Layout
        match vector:
            case Quantity("velocity", (Name(),), _):
                of = self.layout(vector)
            case Quantity("position", (Name(body),), stage) if isinstance(axis, Unit):
                words = (
                    say("derived.coordinate-x", body=body)
                    if axis.axis == "i"
                    else say("derived.coordinate-y", body=body)
                )
                return self._at(words, stage)
            case Quantity("momentum"):
                of = say("derived.the", quantity=self.layout(vector))
            case _:
                of = self.layout(vector)
        sense = self.at_the_wall(axis) if kind == "along" else None
        if sense is not None:
            name, wall = sense
            return say(name, of=of, wall=wall)
        event = self.event_of_axis(axis)
        unit = None if isinstance(axis, Negate) else self.unit_of(event, kind)
        if unit is not None and event is not None and not event.wall:
            return say("derived.component-unit", axis=self.layout(unit), of=of)
        if event is None:
            if isinstance(axis, Unit):
                own = axis if kind == "along" else _turned_left(axis)
                return say("derived.component-unit", axis=self.layout(own), of=of)
            if kind == "along":
                return say("derived.component-along-vector", axis=self.layout(axis), of=of)
            direction = self.bold.across_wall(axis.name) if isinstance(axis, Name) else None
            if direction is not None:
                surface = self.layout(axis)
                return say("derived.component-across-sense", axis=surface, way=direction, of=of)
            return say("derived.component-across-vector", axis=self.layout(axis), of=of)
        if event.wall and kind == "along":
            wall = event.bodies[1]
            if wall not in self.circles and not self.bold.leads_into(event):
                if unit is not None:
                    return say("derived.component-unit", axis=self.layout(unit), of=of)
                return say("derived.component-across-vector", axis=wall, of=of)
            return say("derived.component-towards", of=of, wall=wall)
        if event.wall and event.bodies[1] in self.circles:
            return say("derived.component-tangent", of=of, wall=event.bodies[1])
        if event.wall:
            return say("derived.component-parallel", of=of, wall=event.bodies[1])
        if kind == "along":
            return say("derived.component-along", of=of)
        return say("derived.component-across", of=of)

    @cached_property
    def has_axes(self) -> bool:
        """Whether the question in words has **i** and **j**, so that a working may have them."""
        try:
            return has_axes(self.problem)
        except RestitutionError:
            return True

    def at_the_wall(self, axis: Expression) -> tuple[str, str] | None:
        """What a component along **i** or **j** is at the only wall, and the name of that.

        The phrase is that of a component parallel to it, towards it or away from it. None where the
        question has **i** and **j**, and of any other axis.
        """
        back = isinstance(axis, Negate)
        own = unsigned(axis)
        if not isinstance(own, Unit) or self.has_axes:
            return None
        walls = [event for event in self.impacts if event.wall]
        if not walls or len({event.bodies[1] for event in walls}) > 1:
            return None
        normal, wall = self.unit_of(walls[0], "along"), walls[0].bodies[1]
        if normal is None:
            return None
        into = unsigned(normal)
        if own != into:
            return _PARALLEL, wall
        return (_AWAY if back != isinstance(normal, Negate) else _TOWARDS), wall

    def event_of_axis(self, axis: Expression) -> Event | None:
        """The event along whose axis a component is taken."""
        own = unsigned(axis)
        if is_quantity(own, "line_of_centres"):
            return self.events.get(own.stage) if isinstance(own.stage, int) else None
        return None

    def unit_of(self, event: Event | None, kind: str) -> Expression | None:
        """**i** or **j**, perhaps reversed, where that is along the line of an event, or across."""
        fact = None if event is None else self.derivation.fact(f"axis {event.number}")
        if fact is None or len(fact.relation.options) != 1:
            return None
        axis = fact.relation.only[-1].right
        back = isinstance(axis, Negate)
        own = unsigned(axis)
        if not isinstance(own, Unit):
            return None
        if kind == "across":
            back = back != (own.axis == "j")
            own = Unit("j" if own.axis == "i" else "i")
        return Negate(own) if back else own

    # --- times ----------------------------------------------------------------------------------

    def _after(self, words: Sentence, tree: Quantity, body: str | None) -> Sentence:
        number = self._settled(tree) if body else _number(tree.stage)
        when = self._when(number, body)
        if when is None and number and self.several and self._of_other_times(tree):
            when = self._plain_when(number)
        return words if when is None else say("derived.when", quantity=words, when=when)

    def _during(self, words: Sentence, tree: Quantity) -> Sentence:
        """What belongs to one event."""
        number = _number(tree.stage)
        if number not in self.events or not self.several:
            return words
        # Of several impacts, the angle through which a body turns could be that of them all.
        whole = tree.kind == "deflection"
        if number == self.heading_in_part and not (whole or self._of_other_times(tree)):
            return words
        event = self.events[number]
        name = "event.due" if event.kind == "kick" else "event.during"
        during = say(name, event=self._event(event))
        return say("derived.when", quantity=words, when=during)

    def _at(self, words: Sentence, stage: Stage) -> Sentence:
        when = self._when_at(stage)
        return words if when is None else say("derived.when", quantity=words, when=when)

    @staticmethod
    def _timeless(tree: Expression) -> Expression:
        return rebuilt(
            tree, lambda tree: replace(tree, stage=None) if isinstance(tree, Quantity) else tree
        )


def _turned_left(axis: Unit) -> Expression:
    """The unit vector at 90° anticlockwise from **i** or **j**."""
    return Unit("j") if axis.axis == "i" else Negate(Unit("i"))


def _at_one_time(
    ends: tuple[Expression, ...], stage: Stage
) -> tuple[tuple[Expression, ...], Stage]:
    """The ends of a distance, and when it is so: from a point, that is when the body is there."""
    places = [end for end in ends if is_quantity(end, "position")]
    if stage is not None or len(places) != 1:
        return ends, stage
    (place,) = places
    return tuple(end.arguments[0] if end is place else end for end in ends), place.stage


def _number(stage: Stage) -> int | None:
    return stage if isinstance(stage, int) else None


def names_of(tree: Quantity) -> tuple[str, ...]:
    """The names among the arguments of a quantity."""
    return tuple(argument.name for argument in tree.arguments if isinstance(argument, Name))


def letter_of(tree: Expression) -> str | None:
    """The name of a letter that stands alone."""
    return tree.name if isinstance(tree, Letter) else None


def _named_times(derivation: Derivation) -> Iterator[tuple[Quantity, str]]:
    """The times for which the statement has letters, each with its letter."""
    for fact in derivation.facts:
        match fact.relation.options:
            case ((Link(Quantity("time", (), int()) as time, "=", Letter(name)),),) if (
                fact.id == f"let {name}"
            ):
                yield time, name


def with_article(formula: lay.Layout) -> Sentence | lay.Layout:
    """The name of a quantity as it stands among other words: words have their article."""
    words = isinstance(formula, lay.Words | lay.Phrase)
    return say("derived.the", quantity=formula) if words else formula
