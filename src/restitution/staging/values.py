"""Numbers to draw by: every letter at a pleasant value that the facts admit.

A picture to scale needs a number for every letter. Letters without values get such as a teacher
would take (40°, ½, 2), tried in a fixed order; what is solved for follows from them. Numbers that
show by chance what is not so in general (a sphere brought to rest by just this e) are passed over.
"""

from __future__ import annotations

import math
import random
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal

from restitution.components.letters import protected_letters
from restitution.components.models import Model
from restitution.components.telling import model
from restitution.errors import RestitutionError
from restitution.expression.enclosed import UndefinedError
from restitution.oracle.roles import Role
from restitution.problem import Impact, Kick
from restitution.records import dataclass
from restitution.solving.algebra.numbers import FIELD, at
from restitution.solving.equations.solution import Branch, PartSolution, Solution
from restitution.solving.story.forward import Story, lets_of
from restitution.solving.story.unknowns import Numbers
from restitution.staging.geometry import floats
from restitution.vector import Vector

# Pleasant values by kind, the best first. Angles are in degrees.
_ANGLES = (40, 55, 30, 50, 35, 60, 25, 65, 20, 70, 15, 75)
_COEFFICIENTS = ("1/2", "3/5", "2/5", "3/4", "1/4", "4/5", "1/5", "9/10", "1/10")
_POSITIVE = ("2", "3", "3/2", "1", "4", "1/2", "5/2", "5", "6", "2/3", "1/4", "8")
_REAL = ("2", "1", "3", "-1", "-2", "1/2", "4", "-3", "-1/2")

_TRIES = 40
# A velocity shorter than this share of the longest is hard to see.
_VISIBLE = 0.12
_SAME = 1e-9
# How much more of a letter shows what depends on it.
_MORE = Fraction(11, 10)

When = Literal["before", "after"]

_FAILURES = (RestitutionError, UndefinedError, ArithmeticError, KeyError)


@dataclass(frozen=True)
class Chosen:
    """A letter drawn at a value, which is exact where it was chosen for being pleasant.

    Angles are in degrees.
    """

    name: str
    value: Fraction | float
    angle: bool


@dataclass(frozen=True)
class PartInNumbers:
    """One part of a problem in numbers.

    ``model`` has its expressions, in the letters of the working, ``numbers`` a number for each of
    these letters, and ``story`` the motion itself. ``free`` are the letters without a value of
    their own, each with the motion that a little more of it would give (None where there is none).
    ``solved`` are the letters whose values differ between the solutions; empty where there is one.
    """

    model: Model
    numbers: Mapping[str, Any]
    story: Story
    free: tuple[tuple[Chosen, Story | None], ...]
    solved: tuple[Chosen, ...]

    def number(self, x: Any) -> float:
        """An expression as a number. Raises UndefinedError or KeyError where it has none."""
        return float(at(x, self.numbers))

    def vector(self, v: Vector) -> Vector:
        """A vector of expressions in numbers."""
        return Vector(self.number(v.x), self.number(v.y))

    def before(self, number: int, body: str) -> Vector:
        """A velocity just before an event."""
        return floats(self.story.happenings[number - 1].before[body])

    def after(self, number: int, body: str) -> Vector:
        """A velocity just after an event."""
        return floats(self.story.happenings[number - 1].after[body])


def motion(
    solution: Solution,
    part: PartSolution,
    branch: Branch,
    wanted: Mapping[str, Any] | None = None,
) -> PartInNumbers:
    """One part by one of its solutions, in numbers that satisfy all that is given.

    ``wanted`` are values for the free letters that are taken where they are possible.
    """
    model_ = model(solution.problem, part.part, branch, part.roles, protected_letters(part.part))
    named = frozenset(lets_of(solution.problem, part.part)) - protected_letters(part.part)
    roles = {name: role for name, role in part.roles.items() if name not in named}
    chosen_values = None if wanted is None else _as_wanted(branch, roles, wanted)
    pleasant, values, story = chosen_values or _representative(branch, roles)
    numbers = dict(values)
    for key, name in model_.unknowns.names.items():
        numbers[name] = values.get(f"_{key}", model_.sample.get(name))
    for (number, body), component in model_.components.items():
        n = model_.frames[number].n
        try:
            direction = Vector(at(n.x, numbers), at(n.y, numbers))
            numbers[component.symbol.name] = story.happenings[number - 1].after[body].dot(direction)
        except (UndefinedError, KeyError):
            continue
    free = tuple(
        (_chosen(name, pleasant.get(name), values[name], roles[name]), moved)
        for name, moved in _varied(branch, roles, values)
    )
    chosen = tuple(
        _chosen(name, None, values[name], roles[name])
        for name in branch.values
        if len(part.branches) > 1 and name in roles and not name.startswith("_")
    )
    return PartInNumbers(model_, numbers, story, free, chosen)


def drawn_for(
    motion: PartInNumbers, events: Sequence[int], panels: Sequence[When] = ("before", "after")
) -> tuple[Chosen, ...]:
    """The letters by whose values a picture of these events has its shape.

    Where a question has several solutions, what is found counts as well: one of them is drawn.
    """
    shaping = [
        chosen
        for chosen, moved in motion.free
        if moved is None
        or not _same_lines(motion.story, moved, events)
        or _ratio(*(velocities(story, events, panels) for story in (motion.story, moved))) is None
    ]
    return (*shaping, *motion.solved)


def unit_of_speed(motion: PartInNumbers, events: Sequence[int]) -> str | None:
    """The letter that all speeds in these events are multiples of."""
    for chosen, moved in motion.free:
        if moved is None or chosen.angle:
            continue
        ratio = _ratio(velocities(motion.story, events), velocities(moved, events))
        if ratio is not None and math.isclose(ratio, float(_MORE)):
            return chosen.name
    return None


def axes(motion: PartInNumbers, number: int) -> tuple[Vector, Vector]:
    """Unit vectors along the line of centres and across it, as the working resolves by them."""
    frame = motion.model.frames[number]
    try:
        n, t = motion.vector(frame.n), motion.vector(frame.t)
    except _FAILURES:  # no value in letters: by the motion itself
        centres = motion.story.happenings[number - 1].oriented()
        n = floats(centres if frame.wall is None else -centres)
        t = n.turned_left()
    return n / math.hypot(*n), t / math.hypot(*t)


def _chosen(name: str, pleasant: Fraction | None, value: Any, role: Role) -> Chosen:
    angle = role.kind == "angle"
    if pleasant is not None and pleasant.denominator <= 20:
        return Chosen(name, pleasant, angle)
    number = math.degrees(float(value)) if angle else float(value)
    near = Fraction(number).limit_denominator(1 if angle else 60)
    return Chosen(name, near if abs(number - near) < 1e-9 else number, angle)


# --- representative values ------------------------------------------------------------------------


def _as_wanted(
    branch: Branch, roles: Mapping[str, Role], wanted: Mapping[str, Any]
) -> tuple[dict[str, Fraction], dict[str, Any], Story] | None:
    """The story at some values of the free letters; None where they are not possible."""
    free = [name for name in roles if name not in branch.values]
    if not wanted.keys() >= set(free):
        return None
    values = {name: wanted[name] for name in free}
    try:
        values |= {name: at(value, values) for name, value in branch.values.items()}
        return {}, values, branch.tell(Numbers(values))
    except _FAILURES:
        return None


def _representative(
    branch: Branch, roles: Mapping[str, Role]
) -> tuple[dict[str, Fraction], dict[str, Any], Story]:
    """Pleasant numbers for the free letters, with all that follows; else those of the solution."""
    free = sorted(name for name in roles if name not in branch.values)
    if not free:
        return {}, dict(branch.sample), branch.numbers
    pattern = _pattern(branch.numbers)
    best: tuple[float, dict[str, Fraction], dict[str, Any], Story] | None = None
    for picked in (*_tries(free, roles), *_rounded(free, roles, branch.sample)):
        values: dict[str, Any] = {
            name: _radians(x) if roles[name].kind == "angle" else FIELD.number(x)
            for name, x in picked.items()
        }
        try:
            for name, value in branch.values.items():
                values[name] = at(value, values)
            if any(_impossible(name, values[name], roles.get(name)) for name in values):
                continue
            if branch.objection(values) is not None:
                continue
            story = branch.tell(Numbers(values))
        except _FAILURES:
            continue
        score = _legibility(story) if _pattern(story) == pattern else 0.0
        if best is None or score > best[0]:
            best = score, picked, values, story
        if score >= _VISIBLE:
            break
    if best is None or best[0] == 0.0:
        return {}, dict(branch.sample), branch.numbers
    return best[1:]


def _radians(degrees: Fraction) -> Any:
    return FIELD.number(degrees / 180) * FIELD.pi


def _impossible(name: str, value: Any, role: Role | None) -> bool:
    """Whether a hidden unknown that is positive by its nature would not be."""
    positive = role is not None and role.kind == "positive"
    return name.startswith("_") and positive and not float(value) > 0


def _tries(free: Sequence[str], roles: Mapping[str, Role]) -> Iterator[dict[str, Fraction]]:
    """Pleasant values for all letters together: the best of each first, then mixtures."""
    lists = [_pleasant(roles[name]) for name in free]
    kinds = [roles[name].kind for name in free]
    # Letters of one kind begin at different values: two equal angles would mean something.
    first = [
        kinds[:k].count(kind) if kind in ("angle", "restitution") else 0
        for k, kind in enumerate(kinds)
    ]
    yield {n: values[k % len(values)] for n, values, k in zip(free, lists, first)}
    rng = random.Random(2)
    for attempt in range(1, _TRIES):
        reach = 2 + attempt / 4
        yield {
            name: values[min(len(values) - 1, int(rng.random() * min(reach, len(values))))]
            for name, values in zip(free, lists)
        }


def _rounded(
    free: Sequence[str], roles: Mapping[str, Role], sample: Mapping[str, Any]
) -> Iterator[dict[str, Fraction]]:
    """The numbers by which the solution was found, with few figures (angles in degrees)."""
    for figures in (1, 2, 3):
        yield {
            name: Fraction(f"{math.degrees(x) if roles[name].kind == 'angle' else x:.{figures}g}")
            for name, x in ((name, float(sample[name])) for name in free)
        }


def _pleasant(role: Role) -> list[Fraction]:
    """Pleasant values within the range of a letter; for an angle in degrees."""
    low = None if role.low is None else float(at(role.low, {}))
    high = None if role.high is None else float(at(role.high, {}))
    if role.kind == "angle":
        low, high = math.degrees(low or 0), math.degrees(math.pi / 2 if high is None else high)
        listed = [Fraction(x) for x in _ANGLES]
        spread: tuple[float, ...] = (0.45, 0.6, 0.35, 0.5, 0.4, 0.65, 0.25)
    else:
        words = {"restitution": _COEFFICIENTS, "real": _REAL}.get(role.kind, _POSITIVE)
        listed = [Fraction(x) for x in words]
        spread = (0.5, 0.6, 0.4, 0.75, 0.25)
    inside = [x for x in listed if (low is None or x > low) and (high is None or x < high)]
    if low is not None and high is not None:
        between = [Fraction(round((low + (high - low) * s) * 100), 100) for s in spread]
        inside += [x for x in between if low < x < high and x not in inside]
    elif low is not None and low != 0:
        inside += [Fraction(round((low + 1) * 10), 10), Fraction(round((low + 3) * 10), 10)]
    elif high is not None:
        inside += [Fraction(round((high - 1) * 10), 10), Fraction(round((high - 3) * 10), 10)]
    return inside or [Fraction(1)]


# --- what numbers show ----------------------------------------------------------------------------


def velocities(
    story: Story, events: Sequence[int] | None = None, panels: Sequence[When] = ("before", "after")
) -> list[Vector]:
    """The velocities before and after some events, or all."""
    return [
        floats(v)
        for number in (range(1, len(story.happenings) + 1) if events is None else events)
        for when in panels
        for v in getattr(story.happenings[number - 1], when).values()
    ]


def _components(story: Story) -> list[float]:
    """Every component of every velocity, along and across the line of centres."""
    components = []
    for happening in story.happenings:
        c = happening.centres if happening.centres is not None else happening.impulse
        if c is None:
            continue
        n = floats(c)
        size = math.hypot(*n) or 1.0
        for v in (*happening.before.values(), *happening.after.values()):
            u = floats(v)
            components += [u.dot(n) / size, u.cross(n) / size, math.hypot(*u)]
    return components


def _pattern(story: Story) -> tuple[bool, ...]:
    """Which components vanish: what is zero in general, and no more, may be zero in a picture."""
    values = _components(story)
    largest = max(map(abs, values), default=0.0)
    return tuple(abs(x) <= 1e-12 * (largest or 1.0) for x in values)


def _legibility(story: Story) -> float:
    """The shortest velocity of an event as a share of the longest, for the worst of the events."""
    worst = 1.0
    for happening in story.happenings:
        if not isinstance(happening.step, Impact | Kick):
            continue
        sizes = [
            math.hypot(*floats(v)) for v in (*happening.before.values(), *happening.after.values())
        ]
        largest = max(sizes, default=0.0)
        moving = [x for x in sizes if x > 1e-12 * (largest or 1.0)]
        if moving:
            worst = min(worst, min(moving) / largest)
    return worst


def _varied(
    branch: Branch, roles: Mapping[str, Role], values: Mapping[str, Any]
) -> Iterator[tuple[str, Story | None]]:
    """Every free letter with the motion for a little more of it."""
    for name in sorted(name for name in roles if name not in branch.values):
        if name.startswith("_"):
            continue
        changed = {**values, name: values[name] * FIELD.number(_MORE)}
        try:
            for other, value in branch.values.items():
                changed[other] = at(value, changed)
            yield name, branch.tell(Numbers(changed))
        except _FAILURES:
            yield name, None


def _ratio(first: Sequence[Vector], second: Sequence[Vector]) -> float | None:
    """The number by which all vectors are multiplied, if there is one."""
    largest = max(first, key=lambda v: math.hypot(*v), default=Vector(0.0, 0.0))
    size = math.hypot(*largest)
    if size == 0:
        return 1.0
    factor = math.hypot(*second[first.index(largest)]) / size
    close = all(math.hypot(*(w - v * factor)) <= _SAME * size for v, w in zip(first, second))
    return factor if close else None


def _same_lines(first: Story, second: Story, events: Sequence[int]) -> bool:
    """Whether the lines of centres are the same lines."""
    for number in events:
        a, b = first.happenings[number - 1].centres, second.happenings[number - 1].centres
        if a is None or b is None:
            continue
        one, other = floats(a), floats(b)
        if abs(one.cross(other)) > _SAME * math.hypot(*one) * math.hypot(*other):
            return False
    return True
