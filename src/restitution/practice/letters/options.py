"""The candidates of one letter or phrase: by its look, by where it stands, by its suffix."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Literal

from restitution.expression.quantities import ENERGIES, KINDS
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Name,
    Negate,
    Pair,
    Quantity,
    Stage,
    Unit,
    is_component,
    is_quantity,
    unsigned,
    walk,
)
from restitution.practice.letters.candidates import (
    Candidate,
    Kind,
    earlier,
    kinds_of,
    suffix,
)
from restitution.practice.script import ANYWHERE, Scope
from restitution.problem import Event, Impact, Kick, Part, Problem
from restitution.records import dataclass

_OF_VELOCITIES = frozenset("uvwUVW")
# Of another kind than the look of a letter tells: only where numbers cannot agree by chance.
_AXES: Mapping[str, Literal["i", "j"]] = {"x": "i", "y": "j"}
_ODD, _RARE, _STRANGE = 0.15, 0.5, 0.6
# Of another kind, but what the part asks for: people give that any letter.
_WANTED = 0.3
# What quantities of the start cost more than later ones; not for u.
_LATE = 0.3


@dataclass(frozen=True)
class Usage:
    """How a letter is used: inside a trigonometric function, and under which heading.

    ``defined`` tells that its first line gives it, or a function of it, a known value, ``dotted``
    that it stands in a scalar product with a direction, as in ``u_A . n``.
    """

    letter: str
    in_angle: bool = False
    scope: Scope = ANYWHERE
    defined: bool = False
    dotted: bool = False


def options(usage: Usage, candidates: Iterable[Candidate], problem: Problem) -> Iterator[Candidate]:
    """The candidates of a letter, with what each costs for it."""
    candidates = tuple(candidates)
    kinds: tuple[Kind, ...] = kinds_of(usage.letter, usage.in_angle)
    if kinds[0] == "time" and any(
        candidate.kind == "time" and candidate.asked for candidate in candidates
    ):
        kinds = ("time",)
    if usage.dotted:
        kinds = ("direction",) if is_direction(usage.letter) else ("velocity",)
    struck = _events_of_the_impulse(usage, candidates)
    for candidate in candidates:
        if barred(usage, candidate):
            continue
        if struck and candidate.kind == "impulse" and candidate.event not in struck:
            continue
        strange = candidate.kind not in kinds
        if strange and (usage.in_angle or not (candidate.varies or candidate.asked)):
            continue
        if strange and not candidate.asked and _is_never(usage.letter, candidate):
            continue
        extra = _by_suffix(usage.letter, candidate, problem)
        if extra is None:
            continue
        place = kinds.index(candidate.kind) * 0.05 if len(kinds) > 2 and not strange else 0.0
        place += (_WANTED if candidate.asked else _STRANGE) if strange else 0.0
        if candidate.kind == "place" and candidate.asked:
            place = -candidate.cost  # where two meet both are: the one that is asked is meant
        extra += place + _by_scope(usage.scope, candidate) + _by_axis(usage.letter, candidate)
        yield replace(candidate, cost=max(0.0, min(1.0, candidate.cost + extra)))


def _events_of_the_impulse(usage: Usage, candidates: Iterable[Candidate]) -> set[int | None]:
    """The events of the impulses that are asked, where I without a suffix stands for one."""
    if usage.letter not in ("I", "J") or usage.scope.event is not None:
        return set()
    return {x.event for x in candidates if x.kind == "impulse" and x.asked}


def _is_of_velocities(letter: str) -> bool:
    """Whether a letter is one of those that formulas have for velocities: v_A, w."""
    return letter.partition("_")[0].rstrip("'") in _OF_VELOCITIES


def _is_never(letter: str, candidate: Candidate) -> bool:
    """Whether nobody gives a letter to a quantity of another kind: m is a mass alone.

    So u, v and w are velocities, e is a coefficient, and I an impulse.
    """
    base = letter.partition("_")[0].rstrip("'")
    return candidate.kind == "mass" or _is_of_velocities(letter) or base in ("e", "I", "J")


def is_impulse(letter: str) -> bool:
    """Whether a letter is one for an impulse, of which no component that vanishes is spoken."""
    return letter.partition("_")[0] in ("I", "J")


def is_direction(letter: str) -> bool:
    """Whether a letter is one for the unit vectors along and across the line of centres: n, t."""
    return letter.partition("_")[0] in ("n", "t")


def directions(problem: Problem, events: Sequence[Event], letter: str) -> Iterator[Candidate]:
    """The unit vectors along (n) or across (t) the lines of centres that a letter may be."""
    for number, event in enumerate(events, 1):
        if not isinstance(event, Impact):
            continue
        line = Quantity("line_of_centres", (), number)
        across = Pair(
            Negate(Quantity("along", (line, Unit("j")))), Quantity("along", (line, Unit("i")))
        )
        tree: Expression = across if letter.startswith("t") else line
        yield Candidate(tree, "direction", "vector", None, number)


def barred(usage: Usage, candidate: Candidate) -> bool:
    """Whether a letter cannot mean a known quantity: of the start, or of a velocity that is given.

    Only u, u_A and angles may that have a known value from their first line, or stand in a sine
    for an angle that the statement gives; t may be a tangent.
    Of a velocity after, letters of formulas may, and those that their first line gives a value.
    """
    if candidate.given and not (usage.defined or _is_of_velocities(usage.letter)):
        return True
    if not candidate.start or earlier(usage.letter):
        return False
    if candidate.kind == "tangent" and usage.letter in ("t", "T"):
        return False
    known = usage.defined or (usage.in_angle and not candidate.varies)
    return candidate.kind != "angle" or not known


def _by_scope(scope: Scope, candidate: Candidate) -> float:
    cost = 0.0
    if scope.event is not None and candidate.event not in (None, scope.event):
        cost += _ODD
    if scope.body is not None and candidate.body not in (None, scope.body):
        cost += _ODD
    return cost


def _by_axis(letter: str, candidate: Candidate) -> float:
    """As components, x and y are components along i and j before anything else."""
    if letter not in _AXES or candidate.kind != "component":
        return 0.0
    return 0.0 if candidate.axis == Unit(_AXES[letter]) else 0.1


def _by_suffix(letter: str, candidate: Candidate, problem: Problem) -> float | None:
    """What a suffix adds to the cost of a candidate; None where it contradicts it."""
    below = suffix(letter)
    cost = 0.0
    if earlier(letter):
        cost = -_LATE if candidate.start or candidate.event == 0 else _RARE
    spheres = [sphere.name for sphere in problem.spheres]
    for name in sorted(spheres, key=len, reverse=True):
        if below.startswith(name):
            if candidate.body not in (None, name):
                return None
            below = below[len(name) :]
            if candidate.kind == "relative" and below not in spheres:
                return None  # v_B is no velocity of A relative to B
            break
    named = len(letter) == 1 and letter.islower() and letter.upper() in spheres
    if named and candidate.body not in (None, letter.upper()):
        cost += _RARE  # b is of B
    if below[:1] in ("x", "y", "i", "j"):
        extra = _axis_cost(below[0], candidate, problem)
        return None if extra is None else cost + extra
    if below.isdigit():
        return cost + _number_cost(int(below), candidate, spheres)
    return cost


def _axis_cost(axis: str, candidate: Candidate, problem: Problem) -> float | None:
    """What an x or a y below adds; None where it contradicts the vectors of the question."""
    wanted = Unit("i" if axis in "xi" else "j")
    if candidate.axis == wanted:
        return 0.0
    own = _unit_of(candidate, problem)
    if own in (None, wanted):
        return _RARE
    contradicts = candidate.kind == "component" and _has_vectors(problem)
    return None if contradicts else _RARE


def _has_vectors(problem: Problem) -> bool:
    """Whether the question gives a velocity by its components along i and j."""
    return any(
        isinstance(node, Unit)
        for sphere in problem.spheres
        if sphere.velocity is not None
        for node in walk(sphere.velocity)
    )


def _unit_of(candidate: Candidate, problem: Problem) -> Unit | None:
    """The unit vector along which a component is, where it is one by i or j or by a wall."""
    if isinstance(candidate.axis, Unit):
        return candidate.axis
    walls = {wall.name: wall.along for wall in problem.walls}
    along = walls.get(candidate.axis.name) if isinstance(candidate.axis, Name) else None
    if not isinstance(along, Unit):
        return None
    across = getattr(candidate.quantity, "kind", "") == "across"
    return Unit("j" if (along.axis == "i") == across else "i")


def _number_cost(number: int, candidate: Candidate, spheres: Sequence[str]) -> float:
    """v_1 is of the first sphere, or after the first event."""
    of_sphere = number <= len(spheres) and candidate.body == spheres[number - 1]
    return 0.0 if of_sphere or candidate.event == number else _ODD


# --- what a letter usually means ------------------------------------------------------------------


def usual(
    usage: Usage, candidates: Sequence[Candidate], problem: Problem, events: Sequence[Event]
) -> Candidate | None:
    """What a letter means where nothing else is known of it: v_A, u_A, e, m; else None."""
    letter, below = usage.letter, suffix(usage.letter)
    base = letter.partition("_")[0].rstrip("'")
    impacts = [n for n, event in enumerate(events, 1) if isinstance(event, Impact)]
    match base:
        case "e" | "epsilon":
            number = int(below) if below.isdigit() else usage.scope.event or impacts[-1:]
            number = number[0] if isinstance(number, list) and number else number
            if len(impacts) == 1 or below.isdigit() or usage.scope.event:
                return _first(candidates, "coefficient", None, number)
        case "I" | "J" if not below:
            struck = [n for n, event in enumerate(events, 1) if isinstance(event, Impact | Kick)]
            struck = struck if len(struck) == 1 else impacts  # that of a kick is known
            only = struck[0] if len(struck) == 1 else usage.scope.event
            return _first(candidates, "impulse", None, only) if only else None
        case "I" | "J" if below in _AXES and _has_vectors(problem) and len(problem.spheres) == 1:
            return _usual_component(candidates, _AXES[below], usage.scope, "impulse")
        case "t" | "T" if below == "1" and any(_is_time(x) and x.asked for x in candidates):
            return next((x for x in candidates if _is_time(x)), None)
        case "t" if not below and any(_is_time(x) and x.asked for x in candidates):
            times = [x for x in candidates if x.kind == "time"]
            return times[0] if len(times) == 1 else None
        case "m" | "M":
            return _mass(candidates, below, problem)
        case "v" | "u" | "V" | "U" if any(sphere.name == below for sphere in problem.spheres):
            return _usual_velocity(candidates, base in "uU", below, usage.scope)
        case "v" | "V" if below in _AXES and _has_vectors(problem) and len(problem.spheres) == 1:
            return _usual_component(candidates, _AXES[below], usage.scope)
        case _ if usage.in_angle:
            return _usual_angle(candidates, events)
    return None


def _is_time(candidate: Candidate) -> bool:
    """Whether a quantity is the time of the first event."""
    return candidate.kind == "time" and candidate.quantity == Quantity("time", (), 1)


def _usual_component(
    candidates: Iterable[Candidate],
    axis: Literal["i", "j"],
    scope: Scope,
    kind: Kind = "component",
) -> Candidate | None:
    """The component along i or j after the latest event, or after that of the heading.

    Of an impulse it is the component of that in the event.
    """
    own = [
        candidate
        for candidate in candidates
        if candidate.kind == kind and candidate.axis == Unit(axis)
    ]
    later = [
        candidate for candidate in own if candidate.event and scope.event in (None, candidate.event)
    ]
    return max(later, key=lambda candidate: candidate.event or 0, default=None)


def _first(
    candidates: Iterable[Candidate], kind: Kind, body: str | None, event: object
) -> Candidate | None:
    alike = [
        candidate for candidate in candidates if candidate.kind == kind and candidate.body == body
    ]
    return next(
        (candidate for candidate in alike if candidate.event == event or event is None), None
    )


def _mass(candidates: Iterable[Candidate], below: str, problem: Problem) -> Candidate | None:
    spheres = [sphere.name for sphere in problem.spheres]
    if below in spheres:
        return _first(candidates, "mass", below, None)
    if below.isdigit() and 0 < int(below) <= len(spheres):
        return _first(candidates, "mass", spheres[int(below) - 1], None)
    open_ = [sphere.name for sphere in problem.spheres if sphere.mass is None]
    return _first(candidates, "mass", open_[0], None) if len(open_) == 1 and not below else None


def _usual_velocity(
    candidates: Iterable[Candidate], before: bool, body: str, scope: Scope
) -> Candidate | None:
    """The component along the line of centres of the latest event, or of that of the heading."""
    own = [
        candidate
        for candidate in candidates
        if candidate.kind == "component" and candidate.body == body
    ]
    if before:
        return next((candidate for candidate in own if candidate.event == 0), None)
    later = [candidate for candidate in own if candidate.event]
    wanted = [candidate for candidate in later if candidate.event == scope.event] or later
    last = max((candidate.event or 0 for candidate in wanted), default=0)
    return next((candidate for candidate in wanted if candidate.event == last), None)


def _usual_angle(candidates: Iterable[Candidate], events: Sequence[Event]) -> Candidate | None:
    """The angle of the line of centres of spheres that meet off centre."""
    offset = [
        number
        for number, event in enumerate(events, 1)
        if isinstance(event, Impact) and event.offset is not None
    ]
    line = Quantity("line_of_centres", (), offset[0] if offset else 0)
    angles = (candidate for candidate in candidates if candidate.kind == "angle" and offset)
    return next((angle for angle in angles if line in walk(angle.quantity)), None)


# --- trees of phrases and declarations ------------------------------------------------------------


def of_trees(trees: Iterable[Expression], sensed: bool = True) -> Iterator[Candidate]:
    """Candidates of trees in the order given, the most natural first."""
    for place, tree in enumerate(trees):
        candidate = _of_tree(tree, min(0.05 * place, 0.5))
        yield candidate if sensed else replace(candidate, kind="definition")


_MULTIPLE = 0.05


def scaled(
    candidates: Iterable[Candidate], directions: Sequence[Expression]
) -> Iterator[Candidate]:
    """Components and relative velocities times the length of a direction.

    ``(5i + 2j).(2i - j)`` is one: in a ratio, the factor goes.
    """
    for candidate in candidates if directions else ():
        if candidate.nature == "scalar" and _is_component(candidate.quantity):
            for direction in directions[:3]:
                quantity = Binary("*", Apply("abs", direction), candidate.quantity)
                yield replace(candidate, quantity=quantity, cost=min(1.0, candidate.cost + _RARE))


def multiples(
    candidates: Iterable[Candidate], direction: Expression, problem: Problem
) -> Iterator[Candidate]:
    """What is multiplied by a direction of any length: an impulse, or what it changes, a velocity.

    In ``2(v_A - 6i - 2j) = -k(3i + 4j)`` the size of the impulse is 5k; a change of velocity may
    be told in the same way.
    """
    size = Apply("abs", direction)
    for candidate in candidates:
        if not candidate.start and _is_component(candidate.quantity):
            # The velocity of a sphere that was at rest: v_B = k(3i + 4j).
            share = Binary("/", candidate.quantity, size)
            yield replace(candidate, quantity=share, cost=candidate.cost + _MULTIPLE)
        if (
            candidate.kind != "impulse"
            or candidate.nature != "scalar"
            or candidate.body is not None
        ):
            continue
        quotients: list[Expression] = [Binary("/", candidate.quantity, size)]
        for sphere in problem.spheres:
            mass = Quantity("mass", (Name(sphere.name),))
            quotients.append(Binary("/", candidate.quantity, Binary("*", mass, size)))
        for place, quotient in enumerate(quotients):
            own = replace(candidate, quantity=quotient, cost=_MULTIPLE + (_RARE if place else 0.0))
            yield own
            yield own.turned()


def _is_component(tree: Expression) -> bool:
    inner = unsigned(tree)
    if not is_component(inner):
        return False
    axis = inner.arguments[1]
    return is_quantity(axis, "line_of_centres")


_MOMENTS = frozenset(
    ["after", "before", "final", "initial", "initially", "finally", "original", "new", "start"]
)


def elsewhen(words: str, trees: Iterable[Expression], stages: Iterable[int]) -> Iterator[Candidate]:
    """Candidates of trees at other stages, for words that name no moment."""
    if _MOMENTS & set(words.split()):
        return
    for tree in trees:
        for stage in stages:
            moved = _moved(tree, stage)
            if moved != tree:
                yield replace(_of_tree(moved, 0.5), cost=0.6)


def is_angle_to_a_wall(tree: Expression, problem: Problem) -> bool:
    """Whether a quantity is an angle to a wall that has a name."""
    walls = {wall.name for wall in problem.walls}
    return is_quantity(tree, "angle") and any(
        isinstance(argument, Name) and argument.name in walls for argument in tree.arguments
    )


def _moved(tree: Expression, stage: int) -> Expression:
    """A tree in which velocities, speeds and energies are those after another event."""
    match tree:
        case Quantity("velocity" | "speed" | "energy" as kind, arguments):
            return Quantity(kind, arguments, stage)
        case Quantity(kind, arguments, own):
            return Quantity(kind, tuple(_moved(argument, stage) for argument in arguments), own)
        case Binary(op, left, right) if not is_quantity(left, "energy"):
            return Binary(op, _moved(left, stage), _moved(right, stage))
        case Apply(function, argument):
            return Apply(function, _moved(argument, stage))
        case Negate(operand):
            return Negate(_moved(operand, stage))
    return tree


def _of_tree(tree: Expression, cost: float) -> Candidate:
    inner = unsigned(tree)
    kind: Kind = "definition"
    body = next((n.name for n in walk(inner) if isinstance(n, Name)), None)
    event = next(
        (n.stage for n in walk(inner) if isinstance(n, Quantity) and isinstance(n.stage, int)), None
    )
    axis = None
    nature = "scalar"
    if isinstance(inner, Quantity):
        kind = _KIND_OF_QUANTITY.get(inner.kind, "definition")
        nature = KINDS[inner.kind].nature_of(inner.arguments)
        axis = inner.arguments[1] if kind == "component" else None
    return Candidate(tree, kind, nature, body, event, axis, False, cost)  # type: ignore[arg-type]


_KIND_OF_QUANTITY: dict[str, Kind] = {
    "along": "component",
    "across": "component",
    "speed": "speed",
    "velocity": "velocity",
    "angle": "angle",
    "direction": "angle",
    "deflection": "deflection",
    "impulse": "impulse",
    **dict.fromkeys(ENERGIES, "energy"),
    "mass": "mass",
    "restitution": "coefficient",
    "time": "time",
    "distance": "distance",
    "line_of_centres": "direction",
}


def staged(tree: Expression, problem: Problem, part: Part | None, now: int) -> Expression:
    """A tree in which every quantity tells the number of its event, after ``now`` events."""
    events = [step for step, _, _ in problem.timeline(part) if isinstance(step, Event)]
    return _staged(tree, events, now)


def _staged(tree: Expression, events: Sequence[Event], now: int) -> Expression:
    match tree:
        case Quantity(kind, arguments):
            inside = tuple(_staged(argument, events, now) for argument in arguments)
            return Quantity(kind, inside, _stage(tree, events, now), place=tree.place)
        case Binary(op, left, right):
            return Binary(op, _staged(left, events, now), _staged(right, events, now))
        case Apply(function, argument):
            return Apply(function, _staged(argument, events, now))
        case Negate(operand):
            return Negate(_staged(operand, events, now))
        case Pair(x, y):
            return Pair(_staged(x, events, now), _staged(y, events, now))
    return tree


def _stage(tree: Quantity, events: Sequence[Event], now: int) -> Stage:
    record = KINDS.get(tree.kind)
    if record is None or not record.staged or not (tree.stage is None or tree.stage == "before"):
        return tree.stage
    body = (
        tree.arguments[0].name if tree.arguments and isinstance(tree.arguments[0], Name) else None
    )
    own = [
        n
        for n, event in enumerate(events[:now], 1)
        if body is None
        or body in ((event.first, event.second) if isinstance(event, Impact) else (event.body,))
    ]
    if tree.stage == "before":
        return own[-1] - 1 if own else 0
    if record.of_an_event:
        return own[-1] if own else tree.stage
    return now
