"""A part told in components: each impact gets its frame, its letters and its principles."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping, Sequence
from dataclasses import field, replace
from typing import Literal

import sympy as sp

from restitution.components.frames import Component, Frame, Law, component
from restitution.components.hidden import NamedUnknowns
from restitution.components.letters import allocated_letters, letters_in_use
from restitution.components.models import Model
from restitution.components.verdicts import proved_sign
from restitution.exact import tidy, tidy_angle
from restitution.exact.symbols import symbols_in
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Symbolic
from restitution.oracle.roles import ACUTE, DIRECTION, Role
from restitution.problem import Impact, Part, Problem
from restitution.records import dataclass
from restitution.shapes import Circle
from restitution.solving.algebra.numbers import at
from restitution.solving.equations.solution import Branch
from restitution.solving.story.forward import Story, lets_of
from restitution.solving.story.happenings import Happening, Standing
from restitution.vector import Vector


def model(
    problem: Problem,
    part: Part,
    branch: Branch,
    roles: Mapping[str, Role],
    protected: frozenset[str] = frozenset(),
    turned: frozenset[int] = frozenset(),
    acute: bool = False,
    question: Problem | None = None,
    paths: Mapping[int, Vector] | None = None,
) -> Model:
    """Tells a part in components, by the values of one branch.

    Letters are chosen for the whole ``question``, of which ``problem`` may leave something out. In
    the impacts ``turned`` the direction of the line of centres is an unknown angle, which is
    ``acute`` where that is known. It is measured from **i**; in the impacts ``paths``, from the
    direction of the path of the first sphere, to the side on which the other one lies.
    Raises what the telling of a story raises.
    """
    sample = dict(branch.sample)
    question = question or problem
    taken = letters_in_use(question)
    names = allocated_letters(question, taken)
    final: dict[sp.Symbol, sp.Expr] = {}
    unknowns = NamedUnknowns(roles, branch, sample, final, set(taken) | set(names.values()))
    lets = {k: v for k, v in lets_of(problem, part).items() if k not in protected}
    built = Model(problem, part, branch, unknowns, {}, {}, [], final, sample)
    _letter_values(built)
    frames = _Frames(built, names, turned, ACUTE if acute else DIRECTION, paths or {})
    built.story = Story(problem, part, Symbolic(), unknowns, lets, frames)
    return built


@dataclass(frozen=True)
class _Frames:
    """The frames of a model, by which its story is told."""

    model: Model
    names: Mapping[tuple[int, str], str]
    turned: frozenset[int]
    angle: Role = DIRECTION
    paths: Mapping[int, Vector] = field(default_factory=dict)

    def standing(self, story: Story, number: int, step: Impact) -> Mapping[str, Standing]:
        self.model.story = story  # it is asked while it is being told
        return _by_values(self.model, number, step)

    def resolved(self, story: Story, happening: Happening) -> Happening:
        self.model.story = story
        return _in_letters(self.model, happening, self.names, self)


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
            own = tidy(sp.sympify(value, strict=True))
            model.final[model.unknowns.letter(name)] = without_bars(model, own)


def without_bars(model: Model, value: sp.Expr) -> sp.Expr:
    """A value without the bars of sizes whose sense the ranges of the letters tell.

    So |cos α| is cos α, and √(1 − sin²α) too, where α is acute.
    """
    if not value.has(sp.Abs):
        return value
    known = {bar: proved_sign(model.inside, bar.args[0]) for bar in value.atoms(sp.Abs)}
    put = {bar: sign * bar.args[0] for bar, sign in known.items() if sign}
    if not put:
        return value
    cosines: dict[sp.Expr, sp.Expr] = {}
    for root in value.atoms(sp.Pow):
        for angle in {sine.args[0] for sine in root.base.atoms(sp.sin)}:
            is_cosine = root.exp == sp.S.Half and sp.expand(root.base + sp.sin(angle) ** 2 - 1) == 0
            if is_cosine and proved_sign(model.inside, sp.cos(angle)) == 1:
                cosines[root] = sp.cos(angle)
    return tidy(value.xreplace(cosines).xreplace(put))


def _in_letters(
    model: Model,
    happening: Happening,
    names: Mapping[tuple[int, str], str],
    frames: _Frames,
) -> Happening:
    """An impact with letters for the components after it that it changes."""
    story, put = model.story, model.final
    number, step = happening.number, happening.step
    assert isinstance(step, Impact)
    frame = _frame(model, number, step, happening, put)
    if number in frames.paths:
        frame = _beside_a_path(model, frame, frames.paths[number])
    elif number in frames.turned and frame.axis is None:
        frame = _at_an_angle(model, frame, frames.angle)
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
        not (symbols_in(sp.sympify(c.x, strict=True)) | symbols_in(sp.sympify(c.y, strict=True)))
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
        if step.along is not None:
            ratio = sp.sympify(tidy(c.y / c.x), strict=True)
            if ratio.is_number:
                c = Vector(one, ratio) * model.sign(c.x)  # whichever sign the letters have
        size = tidy(sp.sqrt(tidy(sp.expand(c.dot(c)))))
        n = Vector(tidy(c.x / size), tidy(c.y / size))
        t = Vector(-n.y, n.x)
    u = happening.before[step.first]
    if wall is not None:
        if model.sign(u.dot(n)) > 0:
            n = -n
        if model.sign(u.dot(t)) < 0 and not _of_either_sign(tidy(u.dot(t))):
            t = -t
    elif (
        # A direction that is given is taken in the sense in which it is given.
        axis is None
        and step.along is None
        and model.sign((u - happening.before[step.second]).dot(n)) < 0
    ):
        n, t = -n, -t
    return Frame(number, wall, n, t, axis, by_values)


def _at_an_angle(model: Model, frame: Frame, role: Role) -> Frame:
    """The same frame with a letter for the angle between its line, or the wall, and **i**."""
    line = frame.n if frame.wall is None else frame.t
    value = sp.atan(tidy(line.y / line.x))
    if model.sign(line.x) < 0:
        value += sp.pi if model.sign(line.y) >= 0 else -sp.pi
    theta = _letter_of_an_angle(model, role, ("theta", "phi", "psi", "delta", "beta"), value)
    along = Vector(sp.cos(theta), sp.sin(theta))
    across = Vector(-along.y, along.x)
    if frame.wall is None:
        return replace(frame, n=along, t=across, by_values=False, angle=theta)
    side = model.sign(frame.n.dot(Vector(-line.y, line.x)))
    n = across if side > 0 else -across
    return replace(frame, n=n, t=along, by_values=False, angle=theta)


def _beside_a_path(model: Model, frame: Frame, path: Vector) -> Frame:
    """The same frame with a letter for the acute angle between its line and a path."""
    side = path.turned_left()
    if model.sign(frame.n.dot(side)) < 0:
        side = -side
    value = sp.asin(tidy(sp.sympify(frame.n.dot(side), strict=True).xreplace(model.final)))
    phi = _letter_of_an_angle(model, ACUTE, ("phi", "theta", "psi", "beta"), value)
    along = path * sp.cos(phi) + side * sp.sin(phi)
    return replace(frame, n=along, t=along.turned_left(), by_values=False, angle=phi)


def _letter_of_an_angle(
    model: Model, role: Role, names: Sequence[str], value: sp.Expr
) -> sp.Symbol:
    """A letter that the question does not use, for an angle with that value."""
    unknowns = model.unknowns
    name = next(name for name in names if name not in unknowns.roles)
    unknowns.roles = {**unknowns.roles, name: role}
    letter = role.symbol(name)
    model.final[letter] = tidy_angle(value)
    model.sample[name] = model.number(value)
    return letter


def _of_either_sign(component: sp.Expr) -> bool:
    """Whether a component is a letter that may be negative: then no case is to be made of it."""
    return component.is_Symbol and component.is_positive is None
