"""A problem as a value: bodies, the story of events, what is given and what is asked.

Everything here is frozen; a change is a new value. Text given for a quantity is read by the
grammar of expressions when a body is made, so that ``Sphere("A", velocity="3i - 4j")`` and the
line ``sphere A: velocity 3i - 4j`` of a statement are the same.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import field, replace
from fractions import Fraction
from functools import cached_property, lru_cache, wraps
from typing import Any, Literal, NamedTuple, TypeVar

from restitution.errors import StatementError
from restitution.expression.tree import Expression, Letter, Name, Pair, Place, letters, rational
from restitution.mending import Note
from restitution.records import dataclass
from restitution.shapes import Circle, Line, Segment, Shape

_Result = TypeVar("_Result")

_NAME = re.compile(r"[A-Z][A-Za-z0-9]*")
_TO_A_WALL = re.compile(r"\bto\s+([A-Z][A-Za-z0-9]*)")


def _exact(value: Any, *, place: bool = False) -> Any:
    """What a user gives for a quantity: text, whole numbers, fractions and pairs of these as an
    expression; anything else (floats, arrays, SymPy's objects) as it is.

    The names that a text may hold are not known here: a wall follows ``to``, and where a place
    is wanted a name alone is that of a point. Raises StatementError for a text that is no
    expression.
    """
    if isinstance(value, str):
        from restitution.expression import read_expression

        names = set(_TO_A_WALL.findall(value))
        if place and _NAME.fullmatch(value.strip()):
            names.add(value.strip())
        return read_expression(value, names=names)
    if isinstance(value, int | Fraction) and not isinstance(value, bool):
        return rational(Fraction(value))
    if type(value) is tuple and len(value) == 2:
        x, y = _exact(value[0]), _exact(value[1])
        if isinstance(x, Expression) and isinstance(y, Expression):
            return Pair(x, y)
    return value


def _convert(body: Any, quantities: tuple[str, ...], places: tuple[str, ...]) -> None:
    for quantity in (*quantities, *places):
        value = getattr(body, quantity)
        if isinstance(value, Expression):
            continue
        try:
            exact = _exact(value, place=quantity in places)
        except StatementError as error:
            where = "" if error.column is None else f" (column {error.column})"
            message = f"the {quantity} of {body.name}{where}: {error.message}"
            raise StatementError(message) from error
        object.__setattr__(body, quantity, exact)


# --- bodies -----------------------------------------------------------------------------------


@dataclass(frozen=True)
class Sphere:
    """A smooth uniform sphere.

    Each of ``mass``, ``velocity``, ``position`` (of its centre at time 0) and ``radius`` is None
    where nothing is known. Units are SI.
    """

    name: str
    mass: Any = None
    velocity: Any = None
    position: Any = None
    radius: Any = None
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)

    def __post_init__(self) -> None:
        _convert(self, ("mass", "velocity", "radius"), ("position",))


@dataclass(frozen=True)
class Wall:
    """A fixed smooth vertical wall.

    Straight (``along`` a vector or an angle, ``through`` a point), a segment (``start``,
    ``end``), or a circle (``centre``, ``radius``).
    """

    name: str
    along: Any = None
    through: Any = None
    start: Any = None
    end: Any = None
    centre: Any = None
    radius: Any = None
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)

    def __post_init__(self) -> None:
        _convert(self, ("along", "radius"), ("through", "start", "end", "centre"))

    @property
    def shape(self) -> Shape:
        """Where it is: a whole line, also where nothing is given of it, a segment or a circle."""
        if self.centre is not None or self.radius is not None:
            return Circle(self.centre, self.radius)
        if self.start is not None or self.end is not None:
            return Segment(self.start, self.end)
        return Line(self.along, self.through)

    @property
    def lengths(self) -> tuple[Any, ...]:
        """Its places and its radius, as far as they are given."""
        values = (self.through, self.start, self.end, self.centre, self.radius)
        return tuple(value for value in values if value is not None)


@dataclass(frozen=True)
class Point:
    """A named point of the plane."""

    name: str
    position: Any
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)

    def __post_init__(self) -> None:
        _convert(self, (), ("position",))


# --- relations --------------------------------------------------------------------------------


@dataclass(frozen=True)
class Compare:
    """A chain such as ``0 < e <= 1``; ``figures`` is the 3 of ``to 3 s.f.`` (in ``show`` only)."""

    operands: tuple[Expression, ...]
    operators: tuple[Literal["=", "<", "<=", ">", ">="], ...]
    figures: int | None = None


@dataclass(frozen=True)
class Aligned:
    """A relation between two directions: vectors, angles, walls or lines of centres."""

    left: Expression
    relation: Literal["perpendicular to", "parallel to", "in the direction of", "opposite to"]
    right: Expression


@dataclass(frozen=True)
class AtRest:
    """``A at rest``, now."""

    body: Name


@dataclass(frozen=True)
class Meets:
    """``A and B collide again``, ``A does not hit W again``, ``A will hit W`` and their kin."""

    first: Name
    second: Name
    again: bool
    happens: bool


Relation = Compare | Aligned | AtRest | Meets

# --- items ------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Value:
    """``find X``, perhaps ``as a percentage``."""

    expression: Expression
    percentage: bool = False
    text: str = field(default="", compare=False)
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Range:
    """``range of X``: all values that the facts allow."""

    expression: Expression
    percentage: bool = False
    text: str = field(default="", compare=False)
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Extremum:
    """``maximum of Q over X`` or ``minimum of Q over X``."""

    kind: Literal["maximum", "minimum"]
    expression: Expression
    over: Expression
    percentage: bool = False
    text: str = field(default="", compare=False)
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


Item = Value | Range | Extremum

# --- steps of the story -----------------------------------------------------------------------


@dataclass(frozen=True)
class Impact:
    """``A hits B``: the next event. ``e`` None is the letter e; ``along`` the line of centres."""

    first: str
    second: str
    e: Expression | None = None
    along: Expression | None = None
    offset: Expression | None = None
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Kick:
    """``A receives J``: an impulse given to A from outside."""

    body: str
    impulse: Expression
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Arrival:
    """``A reaches X``: A's centre comes to a point, or A comes to a wall."""

    body: str
    target: Expression
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


Event = Impact | Kick | Arrival


def bodies_of(event: Event) -> tuple[str, ...]:
    """The names of the bodies of an event, walls among them."""
    return (event.first, event.second) if isinstance(event, Impact) else (event.body,)


@dataclass(frozen=True)
class Let:
    """``let beta = …``: a name for a quantity or for an expression of quantities."""

    letter: str
    expression: Expression
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Given:
    """Facts about the motion or about the letters."""

    relations: tuple[Relation, ...]
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Unknown:
    """Letters that are neither data nor asked for: to be eliminated."""

    letters: tuple[str, ...]
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Find:
    """What is asked; ``in_terms_of`` lists letters, or is None where nothing was said."""

    items: tuple[Item, ...]
    in_terms_of: tuple[str, ...] | None = None
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True)
class Show:
    """A result to be derived: a relation, or what a range or an extremum is.

    ``show RELATION`` has ``subject`` None; ``show range of e: 0 < e < 1/2`` has the Range as
    subject and the chain as relation; ``show maximum of Q over X = V`` has the Extremum as
    subject, and as relation a Compare of Q and V.
    """

    relation: Relation
    subject: Range | Extremum | None = None
    in_terms_of: tuple[str, ...] | None = None
    text: str = field(default="", compare=False)
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


Step = Event | Let | Given | Unknown | Find | Show


@dataclass(frozen=True)
class Part:
    """A part of the question; the steps before the first ``part`` line have the label None."""

    label: str | None
    steps: tuple[Step, ...]
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)

    @property
    def events(self) -> tuple[Event, ...]:
        """The events of this part alone."""
        return tuple(step for step in self.steps if isinstance(step, Event))


class Moment(NamedTuple):
    """A step of the story, the number of events up to it, and the part in which it stands."""

    step: Step
    events: int
    part: Part


class AlteredEquation(NamedTuple):
    """``left = right``, which holds at an impact in place of a law, of some bodies."""

    law: Literal["momentum", "restitution", "unchanged"]
    bodies: tuple[str, ...]
    left: Expression
    right: Expression


@dataclass(frozen=True)
class AlteredImpact:
    """The equations that hold in place of laws at the impact with this number.

    ``senses`` are scalars that must not be negative, or nobody would take these equations.
    """

    number: int
    equations: tuple[AlteredEquation, ...]
    senses: tuple[Expression, ...] = ()


@dataclass(frozen=True)
class Problem:
    """A whole question. ``parts[0]`` holds what stands before the first ``part`` line.

    ``notes`` tell how doubtful notation was read. Spheres, walls and points stand in the
    order of their first declaration, each with everything said of it anywhere. ``altered`` are
    the impacts at which other laws hold: the world of a mistake.
    """

    title: str | None = None
    spheres: tuple[Sphere, ...] = ()
    walls: tuple[Wall, ...] = ()
    points: tuple[Point, ...] = ()
    parts: tuple[Part, ...] = (Part(None, ()),)
    notes: tuple[Note, ...] = field(default=(), compare=False)
    altered: tuple[AlteredImpact, ...] = ()

    def __hash__(self) -> int:
        return self._hash

    @cached_property
    def _hash(self) -> int:
        # What is worked out once for a problem is found by it.
        return hash((self.title, self.spheres, self.walls, self.points, self.parts, self.altered))

    def __getstate__(self) -> dict[str, Any]:
        # The hash of a text is another one in each process.
        return {name: own for name, own in self.__dict__.items() if name != "_hash"}

    @property
    def warnings(self) -> tuple[str, ...]:
        """The notes as texts, each with its place."""
        return tuple(map(str, self.notes))

    @property
    def events(self) -> tuple[Event, ...]:
        """Every event of the story, in order."""
        return tuple(event for part in self.parts for event in part.events)

    def altered_at(self, number: int) -> AlteredImpact | None:
        """What is altered at an impact; None where the laws hold."""
        return next(
            (alteration for alteration in self.altered if alteration.number == number), None
        )

    def steps(self) -> Iterator[tuple[Part, Step]]:
        """Every step of the story with its part, in order."""
        for part in self.parts:
            for step in part.steps:
                yield part, step

    def timeline(self, part: Part | None = None) -> Iterator[Moment]:
        """Every step of the story with the number of events up to it, that event included.

        With a part, only what concerns it: the events of the parts up to it, the facts, names
        and unknown letters in force in it, which are its own and those before the first ``part``
        line, the names of earlier parts that it uses, and its own questions. Raises ValueError
        for a part of another problem.
        """
        last = len(self.parts) - 1 if part is None else self.parts.index(part)
        earlier = () if part is None else self._names_used(last)
        events = 0
        for number, current in enumerate(self.parts[: last + 1]):
            own = part is None or number == last
            for step in current.steps:
                if isinstance(step, Event):
                    events += 1
                elif own or any(step is name for name in earlier):
                    pass
                elif current.label is not None or isinstance(step, Find | Show):
                    continue
                yield Moment(step, events, current)

    def _names_used(self, last: int) -> tuple[Let, ...]:
        """The names that earlier labelled parts gave and this one uses, without naming anew."""
        named: dict[str, Let] = {}
        for part in self.parts[:last]:
            if part.label is not None:
                named |= {step.letter: step for step in part.steps if isinstance(step, Let)}
        if not named:
            return ()
        own = self.parts[last].steps
        anew = {step.letter for step in own if isinstance(step, Let)}
        anew |= {letter for step in own if isinstance(step, Unknown) for letter in step.letters}
        pending = [tree for step in own for tree in trees_of_step(step)]
        used: dict[str, Let] = {}
        while pending:
            for letter in letters(pending.pop()) - anew - set(used):
                if letter in named:
                    used[letter] = named[letter]
                    pending.append(named[letter].expression)
        return tuple(used.values())

    def asked(self, part: Part) -> Iterator[tuple[Item | Show, int]]:
        """The items and shows of a part, each with the number of events before it."""
        for step, events, _ in self.timeline(part):
            if isinstance(step, Find):
                for item in step.items:
                    yield item, events
            elif isinstance(step, Show):
                yield step, events

    def letters_asked(self) -> Iterator[Letter]:
        """The letters of which the value is asked, in their order."""
        for _, step in self.steps():
            for item in step.items if isinstance(step, Find) else ():
                if isinstance(item, Value) and isinstance(item.expression, Letter):
                    yield item.expression


# --- what a problem speaks of ------------------------------------------------------------------


def count_of_items(step: Step) -> int:
    """How many items a step asks for: those of a ``find``, and one of a ``show``."""
    return len(step.items) if isinstance(step, Find) else int(isinstance(step, Show))


def require_part(problem: Problem, label: str | None) -> None:
    """Raises StatementError where the problem has no part of this label; None asks for none."""
    labels = [part.label for part in problem.parts if part.label is not None]
    if label is not None and label not in labels:
        known = f"its parts are {', '.join(labels)}" if labels else "the statement has no parts"
        raise StatementError(f"there is no part {label!r}: {known}")


def with_facts(problem: Problem, *relations: Relation) -> Problem:
    """The problem with further facts, in force in all its parts."""
    first, *others = problem.parts
    facts = Given(relations)
    return replace(problem, parts=(replace(first, steps=(facts, *first.steps)), *others))


def trees(problem: Problem) -> Iterator[Expression]:
    """Every expression of a problem."""
    yield from trees_of_bodies(problem)
    for _, step in problem.steps():
        yield from trees_of_step(step)


def trees_of_bodies(problem: Problem) -> Iterator[Expression]:
    """Every expression of the spheres, the walls and the points of a problem."""
    for sphere in problem.spheres:
        for value in (sphere.mass, sphere.velocity, sphere.position, sphere.radius):
            if isinstance(value, Expression):
                yield value
    for wall in problem.walls:
        for value in (wall.along, *wall.lengths):
            if isinstance(value, Expression):
                yield value
    for point in problem.points:
        yield point.position


def trees_of_step(step: Step) -> Iterator[Expression]:
    """Every expression of one step."""
    match step:
        case Impact():
            yield from (tree for tree in (step.e, step.along, step.offset) if tree is not None)
        case Kick():
            yield step.impulse
        case Let():
            yield step.expression
        case Given():
            for relation in step.relations:
                yield from trees_of_relation(relation)
        case Find():
            for item in step.items:
                yield item.expression
                if isinstance(item, Extremum):
                    yield item.over
        case Show():
            yield from trees_of_relation(step.relation)
            if isinstance(step.subject, Range | Extremum):
                yield step.subject.expression
                if isinstance(step.subject, Extremum):
                    yield step.subject.over
        case _:
            target = getattr(step, "target", None)
            if isinstance(target, Expression):
                yield target


def comparisons(problem: Problem) -> Iterator[Compare]:
    """The equations and inequalities that a problem gives, or has to be shown."""
    for _, step in problem.steps():
        match step:
            case Given():
                yield from (
                    relation for relation in step.relations if isinstance(relation, Compare)
                )
            case Show(Compare() as relation):
                yield relation


def trees_of_relation(relation: Relation) -> Iterator[Expression]:
    """The expressions of a relation."""
    if isinstance(relation, Compare):
        yield from relation.operands
    elif isinstance(relation, Aligned):
        yield relation.left
        yield relation.right


def once_a_problem(function: Callable[[Problem], _Result]) -> Callable[[Problem], _Result]:
    """A function whose results for the last problems are kept: nobody may change them.

    Equal problems have the same result, wherever their parts were said. One into which Python has
    put what has no hash, such as a list, cannot be remembered by it.
    """
    kept = lru_cache(maxsize=64)(function)

    @wraps(function)
    def own(problem: Problem) -> _Result:
        try:
            hash(problem)
        except TypeError:
            return function(problem)
        return kept(problem)

    return own
