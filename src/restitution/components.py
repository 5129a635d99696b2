"""The story of a problem in components: simple letters for what the textbook would call v and w.

Each impact gets a frame, along the line of centres (for a wall: perpendicular to it) and across
it, and a letter for every component that the impact changes. The principles are short equations in
these letters, and every quantity of the problem is an expression in them.
"""

from __future__ import annotations

import contextlib
import random
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Literal

import sympy as sp

from restitution.exact import is_zero, tidy, tidy_angle
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Symbolic
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    walk,
)
from restitution.oracle import (
    All,
    BeyondError,
    Formula,
    Oracle,
    Point,
    Relation,
    Some,
    Verdict,
    compared,
)
from restitution.oracle.roles import ACUTE, DIRECTION, POSITIVE, REAL, Role
from restitution.problem import Find, Impact, Let, Part, Problem, Show, trees
from restitution.shapes import Circle
from restitution.solving.happenings import Happening, Standing
from restitution.solving.numbers import FIELD, at, number_of, plain_sign
from restitution.solving.solution import Branch
from restitution.solving.state import Sign
from restitution.solving.story import Story, lets_of
from restitution.vector import Vector
from restitution.work import remembered

# Letters for unknown components, in the order in which textbooks take them.
_COMPONENTS = ("v", "w", "x", "z", "q", "s", "f", "g", "h", "b", "c", "d", "l", "n", "y", "p")
_BEFORE = ("a", "b", "c", "d", "p", "q", "f", "g", "x", "y")


PROVED = Verdict("proved", "algebra")
UNDECIDED = Verdict("undecided", "undecided")
REFUTED = Verdict("refuted", "witness")
_ARCS = (sp.atan, sp.asin, sp.acos, sp.atan2)
_POINTS = 12
_LONG = 80
_PLAIN_SIGNS = {"≤": "<=", "≥": ">=", "≠": "!="}


def proved_sign(oracle: Oracle, x: sp.Expr) -> int | None:
    """The sign of an expression wherever some facts hold; None if that is open."""
    plain = plain_sign(x)
    if plain is not None:
        return plain
    try:
        return oracle.sign(x)
    except BeyondError:
        return None


@remembered(256)
def _admitted(
    roles: tuple[tuple[str, Role], ...], facts: tuple[Formula, ...], names: frozenset[str]
) -> tuple[tuple[Point, Mapping[str, Any]], ...]:
    """A few points at which facts hold, with each as numbers of many digits."""
    return tuple(
        (point, {name: number_of(value) for name, value in point.items()})
        for point in Oracle(dict(roles), facts).points(names, _POINTS)
    )


def _less_than_a_turn(angle: sp.Expr, oracle: Oracle) -> bool:
    """Whether a sum of angles is certain to be between −360° and 360°."""
    low = high = sp.Integer(0)
    for term in sp.Add.make_args(sp.expand(angle)):
        coefficient, atom = term.as_coeff_Mul()
        if isinstance(atom, sp.atan | sp.asin):
            ends = (-sp.pi / 2, sp.pi / 2)
        elif isinstance(atom, sp.acos):
            ends = (sp.Integer(0), sp.pi)
        elif isinstance(atom, sp.atan2):
            ends = (-sp.pi, sp.pi)
        elif atom.is_Symbol:
            role = oracle.roles.get(atom.name)
            if role is None or role.low is None or role.high is None:
                return False
            ends = (role.low, role.high)
        elif not term.free_symbols:
            ends = (atom, atom)
        else:
            return False
        if not coefficient.is_Rational:
            return False
        if proved_sign(oracle, atom) == 1:
            ends = (sp.Max(ends[0], 0), ends[1])
        elif proved_sign(oracle, atom) == -1:
            ends = (ends[0], sp.Min(ends[1], 0))
        products = [coefficient * end for end in ends]
        low, high = low + min(products), high + max(products)
    return bool(-2 * sp.pi < low) and bool(high < 2 * sp.pi)


def _renamed(formula: Formula, put: Mapping[sp.Symbol, sp.Symbol]) -> Formula:
    match formula:
        case Relation(value, operator):
            return Relation(value.xreplace(put), operator)
        case All(parts):
            return All(tuple(_renamed(part, put) for part in parts))
        case Some(parts):
            return Some(tuple(_renamed(part, put) for part in parts))


@dataclass(frozen=True)
class Frame:
    """The directions in which the velocities of one impact are resolved.

    ``n`` is the unit vector along the line of centres, or perpendicular to a wall and away from
    it; ``t`` the one across, or along the wall. ``by_values`` tells that the line of centres is
    known only from the solution, not from the data. Where it has to be worked out, ``angle`` is the
    letter for the angle that it, or the wall, makes with **i**.
    """

    number: int
    wall: str | None
    n: Vector
    t: Vector
    axis: Literal["i", "j"] | None
    by_values: bool = False
    angle: sp.Symbol | None = None


def component(v: Vector, direction: Vector) -> sp.Expr:
    """The component of a vector in the direction of a unit vector, which mostly is i or j."""
    terms = [
        x if way is sp.S.One else -x if way is sp.S.NegativeOne else x * way
        for x, way in zip(v, direction, strict=True)
        if way is not sp.S.Zero
    ]
    return sp.sympify(sum(terms[1:], terms[0]) if terms else sp.S.Zero, strict=True)


@dataclass(frozen=True)
class Component:
    """An unknown component of a velocity after an impact."""

    symbol: sp.Symbol
    body: str
    number: int
    value: sp.Expr


@dataclass(frozen=True)
class Law:
    """A principle as an equation: ``residual`` = 0. ``unknowns`` are found when it is used."""

    kind: Literal["momentum", "restitution"]
    number: int
    residual: sp.Expr


@dataclass
class _Named:
    """Letters as symbols, and hidden unknowns as symbols with presentable names.

    What a hidden unknown is worth goes to ``final`` and ``sample`` when it first turns up.
    """

    roles: Mapping[str, Role]
    branch: Branch
    sample: dict[str, Any]
    final: dict[sp.Symbol, sp.Expr]
    taken: set[str]
    names: dict[str, str] = field(default_factory=dict)
    phrases: dict[str, str] = field(default_factory=dict)
    hidden_roles: dict[str, Role] = field(default_factory=dict)

    def letter(self, name: str) -> sp.Expr:
        return self.roles.get(name, POSITIVE).symbol(name)

    def hidden(self, key: str, phrase: str, sign: Sign) -> sp.Expr:
        if key.startswith(("c_", "w_")) and f"_{key}" in self.branch.values:
            return tidy(sp.sympify(self.branch.values[f"_{key}"], strict=True))
        role = POSITIVE if sign == "positive" else REAL
        if key in self.names:
            return role.symbol(self.names[key])
        name = self._name(key)
        self.names[key] = name
        self.taken.add(name)
        self.phrases[name] = phrase
        self.hidden_roles[name] = role
        symbol = role.symbol(name)
        value = self.branch.values.get(f"_{key}")
        known = self.sample.get(f"_{key}")
        if value is not None:
            self.final[symbol] = tidy(sp.sympify(value, strict=True))
            if known is None:
                try:
                    known = at(sp.sympify(value, strict=True), self.sample)
                except (UndefinedError, KeyError, ArithmeticError):
                    known = None
        # What the answers do not depend on may be anything.
        self.sample[name] = known if known is not None else FIELD.number(Fraction(137, 100))
        return symbol

    def seeks_contact(self, number: int, values: Iterable[sp.Expr]) -> bool:
        """Whether the place of an event was found as an unknown of its own."""
        return f"_c_{number}x" in self.branch.values

    def _name(self, key: str) -> str:
        if key.startswith(("m_", "t_")):
            return key
        if key.startswith("u_"):
            free = next((c for c in _BEFORE if c not in self.taken), None)
            if free is not None:
                return free
        return key

    def sign(self, x: sp.Expr, given: Sequence[object] = ()) -> int | None:
        x = sp.sympify(x, strict=True)
        plain = plain_sign(x)
        if plain is not None:
            return plain
        try:
            return at(x, self.sample).sign
        except (UndefinedError, KeyError, ArithmeticError):
            return None


@dataclass
class Model:
    """One part of a problem told in components.

    ``final`` gives the value of every unknown symbol in the data; ``sample`` a number for
    every symbol, satisfying all facts.
    """

    problem: Problem
    part: Part
    branch: Branch
    unknowns: _Named
    frames: dict[int, Frame]
    components: dict[tuple[int, str], Component]
    laws: list[Law]
    final: dict[sp.Symbol, sp.Expr]
    sample: dict[str, Any]
    story: Story = field(init=False)
    _across: dict[tuple[int, str], sp.Expr] = field(default_factory=dict)
    _oracles_of_names: dict[tuple[int, int], tuple[Oracle, Oracle]] = field(
        default_factory=dict, repr=False
    )
    _inside: dict[int, Oracle] = field(default_factory=dict, repr=False)
    _verdicts: dict[tuple[sp.Expr, str], Verdict] = field(default_factory=dict, repr=False)
    _numbers: dict[sp.Expr, Any] = field(default_factory=dict, repr=False)
    floats: dict[Expression, Any] = field(default_factory=dict, repr=False)
    """What quantities without letters are worth at the sample in floats, as lines are tried."""

    # --- what is proved -----------------------------------------------------------------------

    @property
    def ground(self) -> Oracle:
        """What every letter may be by its role alone, whatever is given and asked."""
        return self._oracles[0]

    @property
    def oracle(self) -> Oracle:
        """What the letters may be wherever this solution is one."""
        return self._oracles[1]

    @property
    def _oracles(self) -> tuple[Oracle, Oracle]:
        """The oracles for the letters, renewed when the story meets a new hidden unknown."""
        names = len(self.unknowns.roles), len(self.unknowns.hidden_roles)
        if names not in self._oracles_of_names:
            ground = Oracle({**self.unknowns.roles, **self.unknowns.hidden_roles})
            known = self.branch.oracle
            self._oracles_of_names[names] = (
                ground,
                ground if known is None else self._renamed(known),
            )
        return self._oracles_of_names[names]

    @property
    def inside(self) -> Oracle:
        """What every letter may be by its role, but for the ends of its range."""
        ground = self.ground
        if id(ground) not in self._inside:
            roles = {
                name: replace(role, closed=(False, False)) for name, role in ground.roles.items()
            }
            self._inside[id(ground)] = Oracle(roles)
        return self._inside[id(ground)]

    def _renamed(self, known: Oracle) -> Oracle:
        put = self._presented(known)
        if not put:
            return known
        names = {old.name: new.name for old, new in put.items()}
        roles = {names.get(name, name): role for name, role in known.roles.items()}
        return Oracle(roles, tuple(_renamed(fact, put) for fact in known.facts))

    def _presented(self, known: Oracle) -> dict[sp.Symbol, sp.Symbol]:
        """Hidden unknowns by the names that people see."""
        return {
            role.symbol(name): role.symbol(self.unknowns.names[name[1:]])
            for name, role in known.roles.items()
            if name.startswith("_") and name[1:] in self.unknowns.names
        }

    def in_data(self, x: Any) -> sp.Expr:
        """An expression with the final value of every unknown put in."""
        x = sp.sympify(x, strict=True)
        for _ in range(6):
            inside = {s: self.final[s] for s in x.free_symbols if s in self.final}
            if not inside:
                break
            x = x.xreplace(inside)
        return self.presentable(x)

    def decide(self, left: Any, sign: str, right: Any) -> Verdict:
        """Whether ``left sign right`` holds for all letters that the solution admits."""
        gap = self.in_data(left) - self.in_data(right)
        if (gap, sign) not in self._verdicts:
            self._verdicts[gap, sign] = self._decide(gap, sign)
        return self._verdicts[gap, sign]

    def _decide(self, gap: sp.Expr, sign: str) -> Verdict:
        operator = _PLAIN_SIGNS.get(sign, sign)
        if operator == "=" and not gap.free_symbols:
            if self._is_not_zero(gap):
                return REFUTED
            if sp.count_ops(gap) > _LONG:
                return UNDECIDED
            return PROVED if is_zero(gap) else REFUTED
        try:
            if operator == "=" and gap.has(*_ARCS):
                verdict = self._no_angle(gap)
            else:
                verdict = self.oracle.decide(compared(gap, operator, sp.Integer(0)))
        except BeyondError:
            return UNDECIDED
        # Where it is not known what the solution admits, other letters refute nothing.
        open_ = self.branch.oracle is None and bool(gap.free_symbols)
        return UNDECIDED if open_ and not verdict else verdict

    def _is_not_zero(self, constant: sp.Expr) -> bool:
        """Whether a constant is seen not to vanish, in numbers of many digits."""
        try:
            return bool(self.number(constant).sign)
        except (UndefinedError, ArithmeticError):
            return False

    def _points(self, names: frozenset[str]) -> Sequence[tuple[Point, Mapping[str, Any]]]:
        """Points that the solution admits, with each as numbers of many digits."""
        oracle = self.oracle
        return _admitted(tuple(oracle.roles.items()), oracle.facts, names)

    def _no_angle(self, angle: sp.Expr) -> Verdict:
        """Whether an angle is 0: its sine vanishes, its cosine is positive, and it is no turn."""
        with contextlib.suppress(UndefinedError, KeyError, ArithmeticError):
            if abs(self.number(angle)) > 1:
                return REFUTED
        sine, cosine = (sp.expand_trig(f(angle)) for f in (sp.sin, sp.cos))
        upright = self.oracle.decide(All((Relation(sine, "="), Relation(cosine, ">"))))
        return upright if not upright or _less_than_a_turn(angle, self.oracle) else UNDECIDED

    def proved_sign(self, x: Any) -> int | None:
        """The sign of an expression for all letters that the solution admits; None if open."""
        return proved_sign(self.oracle, self.in_data(x))

    def witnesses(self, *parts: Any) -> list[Mapping[str, Any]]:
        """The sample, with another for every part of which the sign may be the opposite.

        So whoever looks at the signs of the parts, and of the sizes in them, at all of these sees
        those that are proved; a part may vanish at an end of what is admitted.
        """
        points: list[Mapping[str, Any]] = [self.sample]
        whole = [self.in_data(part) for part in parts]
        sizes = {each.args[0] for x in whole for each in x.atoms(sp.Abs)}
        for x in (*whole, *sorted(sizes, key=sp.default_sort_key)):
            sign = self.sign(x)
            if x.is_positive or x.is_negative or not x.free_symbols:
                continue
            witness = self.decide(sign * x if sign else x, ">=" if sign else "=", 0).witness
            if witness is not None:
                with contextlib.suppress(UndefinedError, KeyError, ArithmeticError, TypeError):
                    points.append(self._completed(witness))
        return points

    def _completed(self, witness: Point) -> dict[str, Any]:
        """A point with the numbers of all that follows from the letters there."""
        there = {**self.sample, **{name: number_of(value) for name, value in witness.items()}}
        values = {symbol.name: at(self.in_data(symbol), there) for symbol in self.final}
        return {**there, **values}

    # --- the parts of the story ---------------------------------------------------------------

    def happening(self, number: int) -> Happening:
        return self.story.happenings[number - 1]

    def before(self, number: int, body: str) -> tuple[sp.Expr, sp.Expr]:
        """The components of a velocity just before an impact, along and across."""
        chord = self._chord(number, body)
        if chord is not None:
            return chord
        frame = self.frames[number]
        u = self.happening(number).before[body]
        return tidy(component(u, frame.n)), tidy(component(u, frame.t))

    def altered_across(self, number: int, body: str) -> sp.Expr:
        """The component across just after an impact at which other laws hold."""
        t = self.frames[number].t
        side = Vector(t.x.xreplace(self.final), t.y.xreplace(self.final))
        return self.presentable(tidy(component(self.branch.story.velocity(body, number), side)))

    def _chord(self, number: int, body: str) -> tuple[sp.Expr, sp.Expr] | None:
        """Components at the far end of a chord of a circular wall: those at its near end.

        A chord makes equal angles with the radii at its ends.
        """
        frame = self.frames[number]
        wall = self.story.walls.get(frame.wall or "")
        if wall is None or not isinstance(wall.shape, Circle):
            return None
        latest = self.story.latest(body, number - 1)
        if latest is not None:
            earlier = self.frames.get(latest.number)
            if earlier is None or earlier.wall != frame.wall:
                return None
            if self.sign(latest.after[body].dot(earlier.n)) <= 0:
                return None
            across = tidy(latest.before[body].dot(earlier.t))
            if (latest.number, body) in self._across:
                across = self._across[latest.number, body]
            self._across[number, body] = across
            return -self.components[latest.number, body].symbol, across
        start = self.story.place(body, 0)
        if start is None or self.story.radius(body) is not None:
            return None
        circle = self.story.circle(wall.name)
        inwards, size = circle.centre - start[0], circle.radius
        u = self.happening(number).before[body]
        if tidy(inwards.dot(inwards) - size**2) != 0 or self.sign(u.dot(inwards)) <= 0:
            return None
        across = tidy(u.cross(inwards) / size)
        across = -across if self.sign(across) < 0 else across
        self._across[number, body] = across
        return tidy(-u.dot(inwards) / size), across

    def after(self, number: int, body: str) -> sp.Expr:
        """The component along the line of centres just after."""
        return self.components[number, body].symbol

    def spheres(self, number: int) -> list[str]:
        return [name for name in self.happening(number).bodies if name in self.story.spheres]

    def number(self, x: Any) -> Any:
        """A numerical value by the sample; raises UndefinedError where there is none."""
        x = sp.sympify(x, strict=True)
        # A letter may still come to the sample; one that is there keeps its number.
        if x not in self._numbers:
            self._numbers[x] = at(x, self.sample)
        return self._numbers[x]

    def sign(self, x: Any) -> int:
        """The sign of an expression at the sample (0 where it has no value)."""
        try:
            return int(self.number(x).sign)
        except (UndefinedError, KeyError, ArithmeticError):
            return 0

    def presentable(self, x: sp.Expr) -> sp.Expr:
        """An expression of the solution with the names of hidden unknowns that people see."""
        put = {}
        for symbol in x.free_symbols:
            key = symbol.name[1:]
            if symbol.name.startswith("_") and key in self.unknowns.names:
                put[symbol] = self.unknowns.hidden(
                    key, "", "positive" if symbol.is_positive else "real"
                )
        return x.xreplace(put) if put else x

    def identically_zero(self, x: sp.Expr) -> bool:
        """Whether an expression is proved to vanish whatever its letters and unknowns are."""
        rng = random.Random(41)
        names = sorted({s.name for s in x.free_symbols} & set(self.sample))
        for _ in range(2):
            point = {
                name: self.sample[name] * (1 + rng.random()) + rng.random() / 16 for name in names
            }
            try:
                if at(x, point).sign:
                    return False
            except (UndefinedError, KeyError, ArithmeticError):
                return False
        try:
            return self.ground.vanishes(x)
        except BeyondError:
            return False


def model(
    problem: Problem,
    part: Part,
    branch: Branch,
    roles: Mapping[str, Role],
    protected: frozenset[str] = frozenset(),
    turned: frozenset[int] = frozenset(),
    acute: bool = False,
) -> Model:
    """Tells a part in components, by the values of one branch.

    In the impacts ``turned`` the direction of the line of centres is an unknown angle, which is
    ``acute`` where that is known.
    Raises what the telling of a story raises.
    """
    sample = dict(branch.sample)
    taken = _letters_of(problem)
    names = _allocated(problem, taken)
    final: dict[sp.Symbol, sp.Expr] = {}
    unknowns = _Named(roles, branch, sample, final, set(taken) | set(names.values()))
    lets = {k: v for k, v in lets_of(problem, part).items() if k not in protected}
    built = Model(problem, part, branch, unknowns, {}, {}, [], final, sample)
    _letter_values(built)
    frames = _Frames(built, names, turned, ACUTE if acute else DIRECTION)
    built.story = Story(problem, part, Symbolic(), unknowns, lets, frames)
    return built


@dataclass(frozen=True)
class _Frames:
    """The frames of a model, by which its story is told."""

    model: Model
    names: Mapping[tuple[int, str], str]
    turned: frozenset[int]
    angle: Role = DIRECTION

    def standing(self, story: Story, number: int, step: Impact) -> Mapping[str, Standing]:
        self.model.story = story  # it is asked while it is being told
        return _by_values(self.model, number, step)

    def resolved(self, story: Story, happening: Happening) -> Happening:
        self.model.story = story
        return _in_letters(self.model, happening, self.names, self.turned, self.angle)


def protected_letters(part: Part) -> frozenset[str]:
    """Letters that the answers of a part are to be written in."""
    names: set[str] = set()
    for step in part.steps:
        if isinstance(step, Find | Show) and step.in_terms_of:
            names |= set(step.in_terms_of)
    return frozenset(names)


def _by_values(model: Model, number: int, step: Impact) -> dict[str, Standing]:
    """Values for letters where a place on a circle is to be found: roots of roots else."""
    story = model.story
    wall = story.walls.get(step.second)
    bodies = [b for b in (step.first, step.second) if b in story.spheres]
    if wall is not None:
        if not isinstance(wall.shape, Circle):
            return {}
    elif step.along is not None or not all(story.tracks[b].places for b in bodies):
        return {}
    final = model.branch.story
    if all(_in_asked_letters(model, body) for body in bodies):
        return {}  # the place itself is sought
    return {
        body: Standing(
            _tidied(final.velocity(body, number - 1)),
            None if known is None else (_tidied(known[0]), tidy(known[1])),
        )
        for body in bodies
        for known in (final.place(body, number - 1),)
    }


def _tidied(v: Vector) -> Vector:
    return Vector(tidy(v.x), tidy(v.y))


def _in_asked_letters(model: Model, body: str) -> bool:
    """Whether a sphere is still on its first path, with a length to be found in its place."""
    track = model.story.tracks[body]
    if len(track.velocities) > 1 or not track.places:
        return False
    letters = {model.unknowns.letter(name) for name in model.unknowns.roles}
    _, where, _ = track.places[-1]
    inside = {s for x in where for s in sp.sympify(x, strict=True).free_symbols}
    return inside <= letters and bool(inside & set(model.final))


def _letter_values(model: Model) -> None:
    """What the solution says of the letters."""
    for name, value in model.branch.values.items():
        if not name.startswith("_"):
            model.final[model.unknowns.letter(name)] = tidy(sp.sympify(value, strict=True))


def _in_letters(
    model: Model,
    happening: Happening,
    names: Mapping[tuple[int, str], str],
    turned: frozenset[int],
    angle: Role,
) -> Happening:
    """An impact with letters for the components after it that it changes."""
    story, put = model.story, model.final
    number, step = happening.number, happening.step
    assert isinstance(step, Impact)
    frame = _frame(model, number, step, happening, put)
    if number in turned and frame.axis is None:
        frame = _at_an_angle(model, frame, angle)
    model.frames[number] = frame
    after: dict[str, Vector] = {}
    for body in (step.first, step.second):
        if body not in story.spheres:
            continue
        symbol = sp.Symbol(names[number, body], real=True)
        final = model.branch.story.velocity(body, number)
        direction = Vector(frame.n.x.xreplace(put), frame.n.y.xreplace(put))
        value = model.presentable(tidy(component(final, direction)))
        model.components[number, body] = Component(symbol, body, number, value)
        model.final[symbol] = value
        with contextlib.suppress(UndefinedError, KeyError, ArithmeticError):
            model.sample[symbol.name] = at(value, model.sample)
        across = model.before(number, body)[1]
        if story.problem.altered_at(number) is not None:
            across = model.altered_across(number, body)
        after[body] = Vector(
            component(Vector(symbol, across), Vector(frame.n.x, frame.t.x)),
            component(Vector(symbol, across), Vector(frame.n.y, frame.t.y)),
        )
    e = sp.sympify(happening.e, strict=True)
    u1 = model.before(number, step.first)[0]
    v = model.components[number, step.first].symbol
    from_values = frame.by_values or frame.angle is not None
    if from_values and frame.wall is not None and story.has_derived_normal(frame.wall):
        # A wall at an angle has the direction by which that angle is measured.
        normal = frame.n if frame.angle is None else -frame.t.turned_left()
        story.turn_wall(frame.wall, normal)
    if step.second in story.walls:
        model.laws.append(Law("restitution", number, v + e * u1))
        push = -(frame.n * (v - u1))
        mass: str | None = step.first
        oriented = -frame.n
    else:
        u2 = tidy(component(happening.before[step.second], frame.n))
        w = model.components[number, step.second].symbol
        m1, m2 = story.mass(step.first), story.mass(step.second)
        model.laws.append(Law("momentum", number, m1 * u1 + m2 * u2 - m1 * v - m2 * w))
        model.laws.append(Law("restitution", number, w - v - e * (u1 - u2)))
        push = frame.n * (m2 * (w - u2))
        mass = None
        oriented = frame.n if model.sign(u1 - u2) >= 0 else -frame.n
    return replace(
        happening,
        after=after,
        centres=oriented,
        closing=sp.Integer(1),
        impulse=push,
        impulse_mass=mass,
        unknown_line=True,  # energies and impulses are then those of the components
    )


def _frame(
    model: Model, number: int, step: Impact, happening: Happening, put: Mapping[sp.Symbol, sp.Expr]
) -> Frame:
    wall = step.second if step.second in model.story.walls else None
    c = happening.centres
    assert c is not None
    letters = {model.unknowns.letter(name) for name in model.unknowns.roles}
    by_values = False
    final = model.branch.story.happenings[number - 1]
    if (
        not (sp.sympify(c.x, strict=True).free_symbols | sp.sympify(c.y, strict=True).free_symbols)
        <= letters
    ):
        assert final.centres is not None
        c, by_values = final.centres, True
    if sp.sympify(c.y, strict=True).is_zero or sp.sympify(tidy(c.y), strict=True) == 0:
        axis: Literal["i", "j"] | None = "i"
    elif sp.sympify(c.x, strict=True).is_zero or sp.sympify(tidy(c.x), strict=True) == 0:
        axis = "j"
    else:
        axis = None
    one, zero = sp.Integer(1), sp.Integer(0)
    if axis == "i":
        n, t = Vector(one, zero), Vector(zero, one)
    elif axis == "j":
        n, t = Vector(zero, one), Vector(one, zero)
    else:
        size = tidy(sp.sqrt(tidy(sp.expand(c.dot(c)))))
        n = Vector(tidy(c.x / size), tidy(c.y / size))
        t = Vector(-n.y, n.x)
    u = happening.before[step.first]
    if wall is not None:
        if model.sign(u.dot(n)) > 0:
            n = -n
        if model.sign(u.dot(t)) < 0 and not _of_either_sign(tidy(u.dot(t))):
            t = -t
    elif axis is None and model.sign((u - happening.before[step.second]).dot(n)) < 0:
        n, t = -n, -t
    return Frame(number, wall, n, t, axis, by_values)


def _at_an_angle(model: Model, frame: Frame, role: Role) -> Frame:
    """The same frame with a letter for the angle between its line, or the wall, and **i**."""
    unknowns = model.unknowns
    name = next(n for n in ("theta", "phi", "psi", "delta", "beta") if n not in unknowns.roles)
    unknowns.roles = {**unknowns.roles, name: role}
    theta = role.symbol(name)
    line = frame.n if frame.wall is None else frame.t
    value = sp.atan(tidy(line.y / line.x))
    if model.sign(line.x) < 0:
        value += sp.pi if model.sign(line.y) >= 0 else -sp.pi
    model.final[theta] = tidy_angle(value)
    model.sample[name] = model.number(value)
    along = Vector(sp.cos(theta), sp.sin(theta))
    across = Vector(-along.y, along.x)
    if frame.wall is None:
        return replace(frame, n=along, t=across, by_values=False, angle=theta)
    side = model.sign(frame.n.dot(Vector(-line.y, line.x)))
    n = across if side > 0 else -across
    return replace(frame, n=n, t=along, by_values=False, angle=theta)


def _of_either_sign(component: sp.Expr) -> bool:
    """Whether a component is a letter that may be negative: then no case is to be made of it."""
    return component.is_Symbol and component.is_positive is None


def _letters_of(problem: Problem) -> set[str]:
    """The letters that the problem uses, and those that could be taken for something else."""
    names = {"e", "i", "j"}
    for tree in trees(problem):
        for node in walk(tree):
            if isinstance(node, Letter):
                names.add(node.name.partition("_")[0])
    for _, step in problem.steps():
        if isinstance(step, Let):
            names.add(step.letter)
    return names


def _allocated(problem: Problem, taken: set[str]) -> dict[tuple[int, str], str]:
    """A letter for each component that an impact changes, the same in all parts."""
    spheres = {sphere.name for sphere in problem.spheres}
    given = _named_by_let(problem, spheres)
    impacts = [(n, each) for n, each in enumerate(problem.events, 1) if isinstance(each, Impact)]
    struck = [(n, tuple(b for b in (e.first, e.second) if b in spheres)) for n, e in impacts]
    of_spheres = [each for each in struck if len(each[1]) > 1]
    pool = [c for c in _COMPONENTS if c not in taken]
    names: dict[tuple[int, str], str] = dict(given)
    if len(of_spheres) > 1:
        # The same two letters at every impact of two spheres, with its number.
        for order, (number, bodies) in enumerate(of_spheres, 1):
            for letter, body in zip(pool[:2], bodies, strict=False):
                names.setdefault((number, body), f"{letter}_{order}")
        del pool[:2]
    free = (c for c in pool if c not in names.values())
    for number, bodies in (*of_spheres, *(each for each in struck if len(each[1]) < 2)):
        for body in bodies:
            if (number, body) not in names:
                plain = f"v_{number}" if len(bodies) == 1 else f"{body.lower()}_{number}"
                names[number, body] = next(free, plain)
    return names


def _named_by_let(problem: Problem, spheres: set[str]) -> dict[tuple[int, str], str]:
    """Components that the statement names itself: ``let v = along(velocity(A), i)``."""
    letters_by_component: dict[tuple[int, str], str] = {}
    latest: dict[str, tuple[int, Impact]] = {}
    for step, number, _ in problem.timeline():
        if isinstance(step, Impact):
            for body in (step.first, step.second):
                latest[body] = number, step
        elif isinstance(step, Let):
            tree = step.expression
            if not isinstance(tree, Quantity) or tree.kind != "along":
                continue
            inner, axis = tree.arguments
            if (
                isinstance(inner, Quantity)
                and inner.kind == "velocity"
                and inner.stage is None
                and isinstance(inner.arguments[0], Name)
                and isinstance(axis, Unit)
                and inner.arguments[0].name in latest
            ):
                body = inner.arguments[0].name
                event, impact = latest[body]
                if impact.along == axis and (event, body) not in letters_by_component:
                    letters_by_component[event, body] = step.letter
    return letters_by_component
