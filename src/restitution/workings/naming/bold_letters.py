"""Letters in bold type: the velocities of bodies, and unit vectors along slanting lines.

A velocity is **v** with the name of its body, and **u** before anything happens. Where a working
speaks of several velocities of one body, each has the number of its impact. Along a slanting line
of which the direction is known there are unit vectors, **n** along the line of centres or towards
the wall and **t** at right angles to it, so that a component is a scalar product with its sense.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import field

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.data.paths_and_lines import turn_of_line, turn_of_path
from restitution.explaining.following.trials import on_either_side
from restitution.explaining.lines.angles import INVERSE
from restitution.explaining.lines.derivation import (
    Derivation,
    Event,
    Fact,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.lines.saying import Sentence, say
from restitution.explaining.lines.sentences import SENTENCES
from restitution.expression.evaluate import evaluate, in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    is_function,
    is_quantity,
    is_zero,
    walk,
)
from restitution.oracle import REAL, Oracle, Role, compared
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.vector import Vector
from restitution.workings.naming.in_force import inequalities
from restitution.workings.naming.towards_walls import normal_towards

# What introduces unit vectors, at a wall and elsewhere: along its normal, across it, or both.
_UNITS = {
    (False, "both"): "units.both-spheres",
    (False, "along"): "units.along-spheres",
    (False, "across"): "units.across-spheres",
    (True, "both"): "units.both-wall",
    (True, "along"): "units.along-wall",
    (True, "across"): "units.across-wall",
}
# The letters of unit vectors, along a line and across it.
_LETTERS = {"along": ("n", "p", "q"), "across": ("t", "s", "r")}
_FROM_THE_FIRST = {"both": "units.both-from", "along": "units.along-from"}
# Where a line says already what the unit vector along a line of centres is.
_OF_A_LINE = {
    (False, "both"): "units.both-above",
    (False, "along"): "units.along-above",
    (True, "both"): "units.both-wall-above",
    (True, "along"): "units.along-wall-above",
}
_RADIAL = {
    "both": "units.both-circle",
    "along": "units.along-circle",
    "across": "units.across-circle",
}
_EITHER_WAY = {"both": "units.both-normal", "along": "units.along-normal"}


@dataclass(frozen=True)
class Used:
    """The bold letters of a working: bodies and events of velocities, events of unit vectors.

    ``velocities`` are with the part in which each is used first.
    """

    velocities: Mapping[tuple[str, int], str | None] = field(default_factory=dict)
    units: frozenset[tuple[int, str]] = frozenset()


@dataclass
class BoldLetters:
    """The bold letters of one working.

    ``used`` are those that it turns out to need, where that is known: then each is introduced with
    those of its time. ``taken`` are letters that stand for something else, ``when`` says a time,
    ``layout`` lays a tree out, ``circles`` are the walls that are circular, and ``roles`` tell what
    letters may be. ``directions`` are those of the lines of events, where they are known; across
    them components count to the right at the ``turned`` events, and to the left at others.
    """

    derivation: Derivation
    taken: set[str]
    when: Callable[[int], Sentence]
    layout: Callable[[Expression], lay.Layout]
    used: Used | None = None
    circles: frozenset[str] = frozenset()
    roles: Mapping[str, Role] = field(default_factory=dict)
    part: str | None = None
    directions: Mapping[int, Vector | None] | None = None
    turned: frozenset[int] = frozenset()
    _velocities: dict[tuple[str, int], lay.Bold] = field(default_factory=dict)
    _wanted: dict[tuple[str, int], str | None] = field(default_factory=dict)
    _wanted_units: set[tuple[int, str]] = field(default_factory=set)
    _units: dict[tuple[int, str], lay.Bold] = field(default_factory=dict)
    _pending: list[Sentence] = field(default_factory=list)
    _now: int = 0

    def __post_init__(self) -> None:
        events = self.derivation.events
        self._events = {event.number: event for event in events}
        self._movers = {
            body
            for event in events
            for place, body in enumerate(event.bodies)
            if not (place and event.wall)
        }
        if self.directions is None:
            self.directions = {n: direction_of_event(self.derivation, n) for n in self._events}
        self._directions = self.directions

    @property
    def wanted(self) -> Used:
        """The letters that have been asked for so far, each in the part that asked first."""
        return Used(dict(self._wanted), frozenset(self._wanted_units))

    def introduced(self) -> tuple[Sentence, ...]:
        """What letters stand for that have come into use since this was last asked."""
        pending, self._pending = tuple(self._pending), []
        return pending

    # --- velocities -----------------------------------------------------------------------------

    def velocity(self, body: str, number: int) -> lay.Bold:
        """The letter for a velocity after an event, or for the initial one (0)."""
        self._wanted.setdefault((body, number), self.part)
        return self._velocity(body, number)

    def _velocity(self, body: str, number: int) -> lay.Bold:
        if (body, number) not in self._velocities:
            used = {} if self.used is None else self.used.velocities
            part = used.get((body, number), self.part)
            others = (e for (e, event), own in used.items() if (event, own) == (number, part))
            new = sorted(e for e in {body, *others} if (e, number) not in self._velocities)
            for sphere in new:
                self._velocities[sphere, number] = self._letter(sphere, number)
            letters = tuple(self._velocities[sphere, number] for sphere in new)
            name = "derived.velocity" if len(new) == 1 else "derived.velocities"
            words = say(name, bodies=tuple(new))
            late_ = say("derived.when", quantity=words, when=self.when(number))
            meaning = say("derived.meanings", letters=letters, quantity=late_)
            self._pending.append(say("derived.let", meanings=(meaning,)))
        return self._velocities[body, number]

    def gather(self, number: int) -> None:
        """Introduces the velocities at an event that the part is going to use."""
        self._now = number
        if self.used is None:
            return
        bodies = self._events[number].bodies
        early = {
            body
            for body in bodies
            if not any(n < number and body in e.bodies for n, e in self._events.items())
        }
        for (body, event), part in sorted(self.used.velocities.items(), key=lambda e: e[0][::-1]):
            now = event == number or (event == 0 and body in early)
            if now and part == self.part and body in bodies:
                self._velocity(body, event)

    def _letter(self, body: str, number: int) -> lay.Bold:
        """**u** or **v** with the name of the body, and a number where there are several."""
        several = self._several(body)
        alone = len(self._movers) == 1
        if not number:
            return lay.Bold("u", "" if alone and several else body)
        if not several and f"v_{body}" not in self.taken:
            return lay.Bold("v", body)
        impacts = [n for n, event in self._events.items() if event.kind != "arrival"]
        order = str(1 + sorted(impacts).index(number)) if number in impacts else str(number)
        if alone:
            return lay.Bold("v", order)
        return lay.Bold("v", f"{body},{order}" if body[-1].isdigit() else f"{body}{order}")

    def _several(self, body: str) -> bool:
        """Whether a working speaks of several velocities of a body after impacts."""
        if self.used is None:
            return False
        return sum(bool(n) for own, n in self.used.velocities if own == body) > 1

    # --- unit vectors ---------------------------------------------------------------------------

    def has_unit(self, number: int) -> bool:
        """Whether the line of an event has unit vectors."""
        if self._directions.get(number) is None or None in map(self._free, _LETTERS):
            return False
        event = self._events[number]
        if self.is_read_off(number):
            return False
        if not event.wall or not self._is_told_by_the_wall(event.bodies[0]):
            return True
        # Components are written in one way in the whole working.
        return any(
            self._is_vector(body, other.number)
            for other in self._events.values()
            if other.wall and self._directions.get(other.number) is not None
            for body in other.bodies
        )

    def is_read_off(self, number: int) -> bool:
        """Whether components at a slanting line come of angles with it, and no vector is put
        together of them: nobody needs a direction for them.

        Of spheres one alone has a component across the line.
        """
        event = self._events.get(number)
        lines = [line for line in self.derivation.lines if line.move.event == number]
        if event is None or any(map(self._is_by_vectors, lines)):
            return False
        if event.wall and any(line.move.record == "component" for line in lines):
            return True
        if event.wall and self._is_told_by_the_wall(event.bodies[0]):
            return all(number <= other for other, own in self._events.items() if own.wall)
        if not event.wall and any(
            body in own.bodies
            for other, own in self._events.items()
            for body in event.bodies
            if other != number
        ):
            return False
        stay = [
            line.relation.only[-1].right
            for line in lines
            if line.move.record == "unchanged" and isinstance(line.relation, Relation)
        ]
        moving = [component for component in stay if not is_zero(component)]
        if not event.wall and len(moving) > 1:
            return False
        return any(self._is_told_by_its_angle(body, event) for body in event.bodies) and all(
            self._is_at_rest(body) or self._is_told_by_its_angle(body, event)
            for body in event.bodies
            if body in self._movers
        )

    def _is_by_vectors(self, line: Line) -> bool:
        """Whether a vector is put together, or resolved otherwise than by its angle with a line.

        Who strikes a wall at right angles has its speed as the component, and nothing is resolved.
        """
        if line.move.record != "component":
            return line.move.record == "assemble"
        above = [self.derivation.line(ref) for ref in line.premises if isinstance(ref, int)]
        return not any(
            is_quantity(own.relation.only[0].left, "angle", "speed")
            for own in above
            if own is not None
            and isinstance(own.relation, Relation)
            and own.relation.options[1:] == ()
        )

    def _is_told_by_its_angle(self, body: str, event: Event) -> bool:
        """Whether a body comes to its first event by an angle, as the line of that has one."""
        if any(n < event.number and body in own.bodies for n, own in self._events.items()):
            return False
        own = f"wall {event.bodies[1]}" if event.wall else f"axis {event.number}"
        path = turn_of_path(self.derivation.fact(f"velocity {body}"))
        return path is not None and turn_of_line(self.derivation.fact(own)) is not None

    def _is_at_rest(self, body: str) -> bool:
        fact = self.derivation.fact(f"velocity {body}")
        right = None if fact is None else fact.relation.only[-1].right
        return isinstance(right, Pair) and is_zero(right.x) and is_zero(right.y)

    def is_radius_with_a_unit(self, number: int) -> bool:
        """Whether the line of an event is a radius of a circle that has a unit vector."""
        event, units = self._events[number], frozenset() if self.used is None else self.used.units
        return event.wall and event.bodies[1] in self.circles and (number, "along") in units

    def _free(self, kind: str) -> str | None:
        """The letter of a unit vector: another one where the first stands for a time."""
        return next((letter for letter in _LETTERS[kind] if letter not in self.taken), None)

    def _is_told_by_the_wall(self, body: str) -> bool:
        """Whether a velocity at the start is given by its angle with a wall."""
        fact = self.derivation.fact(f"velocity {body}")
        nodes = () if fact is None else walk(fact.relation.only[-1].right)
        return any(isinstance(node, Polar) and node.wall is not None for node in nodes)

    def _is_vector(self, body: str, number: int) -> bool:
        """Whether a body comes to an event with a velocity of two components."""
        if body not in self._movers:
            return False
        if any(n < number and body in event.bodies for n, event in self._events.items()):
            return True
        fact = self.derivation.fact(f"velocity {body}")
        if fact is None:
            return True
        nodes = list(walk(fact.relation.only[-1].right))
        units = {node.axis for node in nodes if isinstance(node, Unit)}
        return len(units) == 2 and not any(isinstance(node, Polar) for node in nodes)

    def direction(self, number: int, kind: str) -> lay.Layout | None:
        """The direction of the line of an event, or across it, as a vector; None without one."""
        direction = self._directions.get(number)
        if direction is None:
            return None
        whole, _ = _whole(self._axis(number, kind, direction))
        return self.layout(tree_of(whole))

    def _axis(self, number: int, kind: str, along: Vector) -> Vector:
        """The direction in which components along the line of an event, or across it, count."""
        if kind == "along":
            return along
        return -along.turned_left() if number in self.turned else along.turned_left()

    def across_wall(self, wall: str) -> lay.Layout | None:
        """The direction of a wall turned to the left, as a vector; None where it is not told."""
        fact = self.derivation.fact(f"wall {wall}")
        direction = None if fact is None else direction_in_numbers(fact.relation.only[-1].right)
        if direction is None:
            return None
        return self.layout(tree_of(whole_direction(direction.turned_left())[0]))

    def unit(self, number: int, kind: str) -> lay.Bold | None:
        """The unit vector along the line of an event, or across it; None where there is none."""
        direction = self._directions.get(number)
        if direction is None or not self.has_unit(number):
            return None
        self._wanted_units.add((number, kind))
        if (number, kind) not in self._units:
            units = frozenset() if self.used is None else self.used.units
            # Both together, where both will be needed.
            new = [e for e in _LETTERS if e == kind or (number, e) in units]
            kinds = [e for e in new if (number, e) not in self._units]
            self._introduce(number, kinds, direction)
        return self._units[number, kind]

    def unit_of_the_line(self, number: int) -> lay.Layout | None:
        """The unit vector along a line of centres, where lines above have a letter for it."""
        event = self._events.get(number)
        if event is None or event.wall:
            return None
        return self._units.get((number, "along"))

    def has_letter(self, number: int) -> bool:
        """Whether the unit vector along the line of an event has its letter already."""
        return (number, "along") in self._units

    def leads_into(self, event: Event) -> bool:
        """Whether the axis at a wall is certain to be the direction into it.

        A fact says so, or the components along it: one that is nothing, as after an impact whose
        coefficient is 0, says nothing of that.
        """
        axis = Quantity("line_of_centres", (), event.number)
        coming = self.derivation.fact(f"approach {event.number}")
        match None if coming is None else coming.relation.only:
            case (Link(Quantity("along", (_, direction)), ">"),) if direction == axis:
                return True
        values = _values_of_letters(self.derivation)
        given = inequalities(self.derivation, self.part, lambda side: _value(side, self.roles, {}))
        oracle = Oracle(self.roles, tuple(given))
        components = []
        for line in self.derivation.lines:
            match line.relation:
                case Relation(
                    (
                        (
                            Link(
                                Quantity("along", (Quantity("velocity", _, int(stage)), direction))
                            ),
                            *_,
                        ),
                    )
                ) if direction == axis:
                    value = _value(line.relation.only[-1].right, self.roles, values)
                    components.append(-value if stage == event.number else value)
        return any(component != 0 for component in components) and all(
            component.is_nonnegative or oracle.proves(compared(component, ">=", sp.Integer(0)))
            for component in components
        )

    def _introduce(self, number: int, kinds: list[str], direction: Vector) -> None:
        events = {n for n, _ in self.used.units} if self.used is not None else {number}
        subscript = str(number) if len(events) > 1 else ""
        equations: list[lay.Layout] = []
        for kind in kinds:
            letter = lay.Bold(self._free(kind) or "", subscript)
            self._units[number, kind] = letter
            axis = self._axis(number, kind, direction)
            sides = [letter, self.layout(_tree_of_unit(axis))]
            put = _with_ratios(axis, self._ratios(number))
            if put != axis:
                sides.append(self.layout(_tree_of_unit(put)))
            equations.append(lay.Relation(tuple(sides), ("=",) * (len(sides) - 1)))
        event = self._events[number]
        which = kinds[0] if len(kinds) == 1 else "both"
        slots: dict[str, lay.Layout | str] = dict(zip(kinds, equations, strict=True))
        name = _UNITS[event.wall, which]
        if event.wall:
            slots["wall"] = event.bodies[1]
            if event.bodies[1] in self.circles:
                name = _RADIAL[which]
            elif not self.leads_into(event):
                name = _EITHER_WAY.get(which, name)
        elif which != "across" and self.derivation.fact(f"axis {number}") is None:
            # A line of centres that is worked out leads from the first sphere to the second.
            name = _FROM_THE_FIRST[which]
            slots |= {"first": event.bodies[0], "second": event.bodies[1]}
        order = 1 + sum(n < number and event.kind != "kick" for n, event in self._events.items())
        earlier = number < self._now and f"ordinal.{order}" in SENTENCES
        if name == "units.along-spheres" and earlier:
            impact = say("event.impact", order=say(f"ordinal.{order}"))
            self._pending.append(say("units.along-earlier", impact=impact, **slots))
            return
        into = not event.wall or name == _UNITS[True, which]
        if "along" in kinds and into and self._is_a_line(number, direction):
            name = _OF_A_LINE[event.wall, which]
            kept = (*kinds, "wall") if event.wall else kinds
            slots = {slot: own for slot, own in slots.items() if slot in kept}
            slots["along"] = self._units[number, "along"]
        if event.wall and name == _UNITS[True, which] and "along" in kinds:
            normal = _whole(direction)[0]
            towards = normal_towards(self.derivation, event, normal, self.layout)
            self._pending += [] if towards is None else [towards]
        self._pending.append(say(name, **slots))

    def _is_a_line(self, number: int, direction: Vector) -> bool:
        """Whether the line just above the components at an event says what a unit vector is.

        Letters may be introduced between the two.
        """
        axis = Quantity("line_of_centres", (), number)
        asked = {end.line for end in self.derivation.items}
        above: Line | None = None
        for line in self.derivation.lines:
            if line.move.record == "component" and line.move.event == number:
                break
            if not isinstance(line.relation, Meaning):
                above = line
        match None if above is None else above.relation:
            case Relation(((Link(left, "=" | "parallel to" as sign), *_),)) as own if left == axis:
                # What is asked as a direction is answered by the unit vector.
                if above is not None and (sign == "=" or above.number in asked):
                    return direction_in_numbers(own.only[-1].right) == direction
        return False

    def _ratios(self, number: int) -> dict[sp.Expr, sp.Expr]:
        """The sines and cosines that have a number above the components at an event."""
        lines = self.derivation.lines
        resolved = [e.move.record == "component" and e.move.event == number for e in lines]
        above = lines[: resolved.index(True)] if True in resolved else ()
        ratios: dict[sp.Expr, sp.Expr] = {}
        for relation in (
            *(e.relation for e in self.derivation.facts),
            *(e.relation for e in above),
        ):
            match relation:
                case Relation(((Link(Apply("sin" | "cos", Letter()) as ratio, "="), *_),)):
                    value = _value(relation.only[-1].right, {}, {})
                    if value.is_number:
                        ratios[sp.sympify(in_letters(ratio), strict=True)] = value
        return ratios


def _with_ratios(direction: Vector, ratios: Mapping[sp.Expr, sp.Expr]) -> Vector:
    """A direction with the numbers of its sines and cosines, where all are known."""
    put = Vector(
        *(
            tidy(sp.sympify(component, strict=True).xreplace(dict(ratios)))
            for component in direction
        )
    )
    return put if all(value.is_number for value in put) else direction


def _values_of_letters(derivation: Derivation) -> dict[str, sp.Expr]:
    """The numbers that lines find for letters."""
    values: dict[str, sp.Expr] = {}
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(Letter(name)), *_),)) if line.relation.only[-1].sign == "=":
                value = _value(line.relation.only[-1].right, {}, {})
                if value.is_number:
                    values[name] = value
    return values


def direction_of_event(derivation: Derivation, number: int) -> Vector | None:
    """The direction of the line of an event, where it is told by **i** and **j** and slants."""
    if any(e.move.record == "chord" and e.move.event == number for e in derivation.lines):
        return None  # components on a chord are known before that direction is
    axis = Quantity("line_of_centres", (), number)
    beside = _beside_a_path(derivation, axis)
    if beside is not None:
        return beside  # with the letter for the angle, which is known only later
    # Components are taken in the sense of the line that they cite, or of the last above them;
    # below them it may stand again, with a letter put in that was sought.
    apart = {own for case in derivation.cases for own in case.lines}
    if any(_gives(line, axis) for line in derivation.lines if line.number in apart):
        return None  # it is another one in each case
    lines = [line for line in derivation.lines if line.number not in apart]
    resolved = [e.move.record == "component" and e.move.event == number for e in lines]
    first = resolved.index(True) if True in resolved else len(lines)
    cited = lines[first].premises if first < len(lines) else ()
    above = sorted(lines[:first], key=lambda line: (line.number not in cited, -line.number))
    sources: list[Line | Fact] = [
        line
        for line in (*above, *reversed(lines[first:]))
        if not isinstance(line.relation, Meaning)
    ]
    fact = derivation.fact(f"axis {number}")
    for value in (*sources, *(() if fact is None else (fact,))):
        assert isinstance(value.relation, Relation)
        match value.relation.options:
            case ((Link(left, "=" | "parallel to"), *_),) if left == axis:
                direction = direction_in_numbers(value.relation.only[-1].right)
                if direction is not None:
                    return direction
    return _beside_i(derivation, axis)


def _beside_a_path(derivation: Derivation, axis: Quantity) -> Vector | None:
    """The direction of a line of centres by the letter for its angle with a path.

    None where no velocity is put together in it, and no line has it as a vector.
    """
    in_the_line = _letter_in_the_line(derivation, axis)
    letter = in_the_line or next(filter(None, map(letter_of_offset, derivation.lines)), None)
    fact = derivation.fact(f"axis {axis.stage}")
    put_together = in_the_line is not None or any(
        line.move.record in ("assemble", "changed-velocity") and line.move.event == axis.stage
        for line in derivation.lines
    )
    match fact and fact.relation.only[0].right:
        case Polar(_, Apply(_, Binary("/", beside)), path) if letter and put_together and path:
            angle = in_letters(Letter(letter))
            own = in_letters(path, positive=True)
        case _:
            return None
    own = own / sp.sqrt(tidy(sp.expand(own.dot(own))))
    side = -own.turned_left() if isinstance(beside, Negate) else own.turned_left()
    return Vector(*(tidy(x * sp.cos(angle) + y * sp.sin(angle)) for x, y in zip(own, side)))


def _letter_in_the_line(derivation: Derivation, axis: Quantity) -> str | None:
    """The letter for the angle with a path by which a line has the unit vector of an axis."""
    for line in derivation.lines:
        match line.relation:
            case Relation(((Link(left, "=", unit), Link()),)) if left == axis:
                for node in walk(unit):
                    if isinstance(node, Apply) and isinstance(node.argument, Letter):
                        return node.argument.name
    return None


def _gives(line: Line, axis: Quantity) -> bool:
    """Whether a line says what the direction of a line of centres is."""
    return not isinstance(line.relation, Meaning) and any(
        link.left == axis and link.sign in ("=", "parallel to")
        for links in line.relation.options
        for link in links
    )


def _beside_i(derivation: Derivation, axis: Quantity) -> Vector | None:
    """The direction of a line of centres of which the angle with **i** is named, or given.

    It may be on either side of **i**, of which a working takes that of **j**.
    """
    if axis.stage not in on_either_side(derivation):
        return None
    relations = [line.relation for line in derivation.lines]
    relations += [fact.relation for fact in derivation.facts]
    for relation in relations:
        match relation:
            case Meaning(letter, Quantity("angle", sides), angle="acute") if axis in sides:
                return direction_in_numbers(Letter(letter)) if Unit("i") in sides else None
            case Relation(((Link(Quantity("angle", sides), "=", angle),),)) if axis in sides:
                return direction_in_numbers(angle) if Unit("i") in sides else None
    return None


def direction_in_numbers(tree: Expression) -> Vector | None:
    """A direction with both components, in numbers or of length 1; None of any other."""
    nodes = list(walk(tree))
    if all(
        isinstance(node, Degrees | Number | Letter | Negate | Binary) or _is_inverse(node)
        for node in nodes
    ):
        is_turn = any(isinstance(node, Degrees | Letter) or _is_inverse(node) for node in nodes)
        return _at(tree) if is_turn else None
    if not any(isinstance(node, Unit | Pair) for node in nodes):
        return None
    if any(isinstance(node, Quantity | Polar | Degrees) for node in nodes):
        return None
    try:
        value = in_letters(tree, positive=True)
    except RestitutionError:
        return None
    if not isinstance(value, Vector) or not all(value):
        return None
    size = sp.sqrt(tidy(sp.expand(value.dot(value))))
    return Vector(*(tidy(component / size) for component in value))


def _is_inverse(tree: Expression) -> bool:
    """Whether an angle is told by a ratio in numbers."""
    match tree:
        case Apply(function, argument):
            numbers = all(isinstance(node, Number | Negate | Binary) for node in walk(argument))
            return function in INVERSE and numbers
    return False


def _at(tree: Expression) -> Vector | None:
    """The direction at an angle from **i**, where its sine and its cosine are roots, or letters.

    Nobody writes out the sums of roots that those of 15° and 75° are.
    """
    try:
        angle = in_letters(tree)
    except RestitutionError:
        return None
    unit_vector = Vector(*(tidy(component) for component in (sp.cos(angle), sp.sin(angle))))
    plain = angle.free_symbols or not any(
        value.has(sp.Add, sp.sin, sp.cos, sp.pi) for value in unit_vector
    )
    return unit_vector if plain and all(unit_vector) else None


def _value(tree: Expression, known: Mapping[str, Role], values: Mapping[str, sp.Expr]) -> sp.Expr:
    """A value in letters that know their sign; those that have a value have that."""

    def symbol(name: str) -> sp.Expr:
        return values[name] if name in values else known.get(name, REAL).symbol(name)

    return sp.sympify(evaluate(tree, symbol), strict=True)


def unit_vector(tree: Expression) -> Expression | None:
    """A unit vector as multiples of **i** and **j** over its length; None of what is no vector."""
    direction = direction_in_numbers(tree)
    if direction is None:
        return None
    unit = _tree_of_unit(direction)
    if not any(map(_is_nested, walk(unit))):
        return unit
    value = in_letters(tree, positive=True)
    assert isinstance(value, Vector)
    return Binary("/", tree, Apply("sqrt", tree_of(tidy(sp.expand(value.dot(value))))))


def _is_nested(tree: Expression) -> bool:
    """Whether a root stands in a root."""
    if not is_function(tree, "sqrt"):
        return False
    return any(isinstance(node, Apply) for node in walk(tree.argument))


def _tree_of_unit(direction: Vector) -> Expression:
    """A unit vector as whole numbers of **i** and **j** over its length, where it is one."""
    whole, length = _whole(direction)
    tree = tree_of(whole)
    return tree if length == 1 else Binary("/", tree, tree_of(length))


def _whole(direction: Vector) -> tuple[Vector, sp.Expr]:
    """A unit vector as one without a denominator, where there is one, and its length."""
    length = sp.fraction(sp.together(direction.x))[1]
    if not length.free_symbols or sp.fraction(sp.together(direction.y))[1] != length:
        return whole_direction(direction)
    return Vector(*(tidy(component * length) for component in direction)), length


__all__ = ["BoldLetters", "Used", "direction_in_numbers", "direction_of_event", "unit_vector"]
