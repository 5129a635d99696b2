"""Lines of centres, and walls, that are found with a velocity of which only the direction is known.

The velocity after the impact is a letter times a vector. Where the speed is given, that letter is
known but for its sign, and so is the change of velocity, which is along the line. Else the law of
restitution, by scalar products with that change, is an equation for the letter.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.definitions.ties import tie_of
from restitution.explaining.lines.derivation import Link, Meaning, Move, Ref, Relation, Showing
from restitution.expression.tree import Apply, Binary, Expression, Letter, Name, Quantity, Unit
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.planning.axes.vector_laws import (
    by_momentum,
    line_of_change,
    restitution_along,
    vector_tree,
)
from restitution.planning.closing.shapes import close
from restitution.planning.formulas.impacts import residual
from restitution.planning.formulas.named_angles import letters_taken
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import (
    ZERO,
    UnwrittenError,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import derivative, expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.unit_vectors import has_nested_roots, plain_direction
from restitution.planning.writing.vectors import velocity_given
from restitution.records import dataclass
from restitution.solving.algebra.numbers import number_of
from restitution.solving.story.letters import roles
from restitution.vector import Vector

_LETTERS = ("s", "k", "b", "c", "q", "r")
_MULTIPLES = ("k", "q", "r", "s", "b", "c")


@dataclass(frozen=True)
class Ray:
    """What is known of a velocity: a letter for ``quantity`` times a vector, by a given fact.

    A ``letter`` of the statement stands for no quantity, and ``rest`` is the velocity without it.
    """

    body: str
    quantity: Expression
    direction: Vector
    given: GivenEquation
    role: Role
    letter: sp.Symbol | None = None
    rest: Vector = Vector(sp.Integer(0), sp.Integer(0))


def write_open_lines(scene: Scene) -> None:
    """Finds the lines of centres for which there is no other way, with the velocities after."""
    for number, own in scene.model.frames.items():
        known = f"axis {number}" in scene.facts or not own.by_values or own.angle is not None
        if (angle := _open_angle(scene, number)) is not None:
            tried(scene, partial(_by_a_velocity, scene, number, angle))
        if known or number in scene.frames:
            continue
        standing = scene.desk.mark()
        if has_nested_roots(*own.n) and tried(scene, partial(_by_a_velocity, scene, number)):
            continue
        try:
            scene.frame(number)
        except NotPlannedError:
            scene.desk.back(standing)
            ways = (_by_a_ray, _by_a_letter_before)
            if not any(tried(scene, partial(write, scene, number)) for write in ways):
                scene.frames.pop(number, None)


def tried(scene: Scene, write: Callable[[], bool]) -> bool:
    """Whether lines could be written; if not, none of them stands, nor a letter of theirs."""
    standing, others, roles = scene.desk.mark(), scene.others, scene.model.unknowns.roles
    try:
        if write():
            return True
    except (NotPlannedError, UnwrittenError):
        pass
    new = scene.model.unknowns.roles.keys() - roles.keys()
    for model in {id(model): model for model in (scene.model, *others)}.values():
        for name in new:
            model.final.pop(scene.model.unknowns.roles[name].symbol(name), None)
            model.sample.pop(name, None)
    scene.model.unknowns.roles = roles
    scene.desk.back(standing)
    scene.others = others
    return False


def _by_a_ray(scene: Scene, number: int) -> bool:
    """Whether a velocity whose direction is given leads to the line: its lines are written."""
    rays = _rays(scene, number)
    fast = next(
        (candidate for candidate in rays if _speed(scene, candidate, number) is not None), None
    )
    are_known = _are_masses_known(scene, number)
    if not rays or (fast is None and not (are_known and _is_coefficient_known(scene, number))):
        return False
    ray = fast or rays[0]
    if fast is not None and tried(scene, partial(_in_either_sense, scene, number, fast)):
        return True
    if not are_known:
        return False
    own = _law_along_the_change(scene, number, ray)
    if fast is None:
        close(scene, own.shortened(scene), own.symbol)
    else:
        # One of the two senses contradicts the law.
        _by_speed(scene, number, as_a_multiple(ray), own.symbol, own.lines, own.law)
    _settle(scene, number, own.late, own.lines, own.change, own.axis)
    return True


def _rays(scene: Scene, number: int) -> list[Ray]:
    """What is known of velocities after an impact that is the first of its spheres."""
    spheres = scene.spheres(number)
    if any(scene.last_event(sphere, number - 1) for sphere in spheres):
        return []
    early = [value for sphere in spheres for value in scene.initial(sphere).value]
    if any(map(scene.unknown, early)):
        return []
    return [own for sphere in spheres if (own := ray_of(scene, sphere, number)) is not None]


def _are_masses_known(scene: Scene, number: int) -> bool:
    spheres = scene.spheres(number)
    masses = [scene.mass(sphere).value for sphere in spheres] if len(spheres) > 1 else []
    return not any(map(scene.unknown, masses))


def _is_coefficient_known(scene: Scene, number: int) -> bool:
    return not scene.unknown(scene.coefficient(number).value)


def _by_a_letter_before(scene: Scene, number: int) -> bool:
    """Whether a velocity that is given leads to the line where one before it has a letter.

    Newton's law, by scalar products with the change of velocity, is an equation for the letter.
    """
    spheres = scene.spheres(number)
    if any(scene.last_event(sphere, number - 1) for sphere in spheres):
        return False
    if not (_are_masses_known(scene, number) and _is_coefficient_known(scene, number)):
        return False
    early = [value for sphere in spheres for value in scene.initial(sphere).value]
    names = frozenset().union(*map(scene.unknown, early))
    for body in spheres:
        own = velocity_given(scene, body, number)
        if own is None or len(own[2]) != 1 or len(names) != 1 or set(scene.unknown(own[1])) - names:
            continue
        (symbol,) = names
        late, lines = {body: own[1]}, {body: own[2][0]}
        _add_others(scene, number, body, late, lines)
        change, axis = line_of_change(scene, number, late, lines)
        law, short = restitution_along(scene, number, late, lines, change, axis)
        close(scene, _shortened(scene, law, short), symbol)
        _settle(scene, number, late, lines, change, axis)
        return True
    return False


@dataclass(frozen=True)
class _Law:
    """Newton's law along a change of velocity in a letter, and what it is made of."""

    symbol: sp.Symbol
    late: dict[str, Vector]
    lines: dict[str, Ref]
    change: Vector
    axis: int
    law: int
    short: Relation

    def shortened(self, scene: Scene) -> int:
        """The law with the relative velocities worked out, as a line."""
        return _shortened(scene, self.law, self.short)


def _shortened(scene: Scene, law: int, short: Relation) -> int:
    """A law with the relative velocities worked out, as a line."""
    if scene.desk.relation(law) == short:
        return law
    return scene.desk.write(Move("rearrange"), (law,), short)


def _law_along_the_change(scene: Scene, number: int, ray: Ray) -> _Law:
    ray = as_a_multiple(ray)
    symbol, late, lines = _ray_line(scene, number, ray)
    _add_others(scene, number, ray.body, late, lines)
    change, axis = line_of_change(scene, number, late, lines)
    law, short = restitution_along(scene, number, late, lines, change, axis)
    return _Law(symbol, late, lines, change, axis, law, short)


def write_open_law(scene: Scene, number: int) -> tuple[int, sp.Symbol] | None:
    """Newton's law by a velocity that is given in an unknown letter, and that letter.

    None where no velocity is given so, or something else is unknown.
    """
    rays = [ray for ray in _rays(scene, number) if ray.letter is not None]
    if not (rays and _are_masses_known(scene, number) and _is_coefficient_known(scene, number)):
        return None
    own = _law_along_the_change(scene, number, rays[0])
    return own.shortened(scene), own.symbol


def _open_angle(scene: Scene, number: int) -> sp.Symbol | None:
    """The unknown letter by which the data give the angle of a line of centres from **i**."""
    fact = scene.facts.get(f"axis {number}")
    match None if fact is None else fact.relation.only:
        case (Link(_, "parallel to", Letter(name)),):
            names = scene.unknown(scene.model.frames[number].n.x)
            return next((symbol for symbol in names if symbol.name == name), None)
    return None


def _by_a_velocity(scene: Scene, number: int, angle: sp.Symbol | None = None) -> bool:
    """Whether a velocity that is given leads to the line, and e to scalar products along it.

    So the ``angle`` of the line has a tangent, and its sine and cosine are not needed; nor is the
    length of a change of velocity with roots below roots.
    """
    spheres = scene.spheres(number)
    if len(spheres) < 2 or any(scene.last_event(sphere, number - 1) for sphere in spheres):
        return False
    masses = [scene.mass(sphere).value for sphere in spheres]
    early = [value for sphere in spheres for value in scene.initial(sphere).value]
    names = scene.unknown(scene.coefficient(number).value)
    if any(map(scene.unknown, (*early, *masses))) or len(names) != 1:
        return False
    for body in spheres:
        own = velocity_given(scene, body, number)
        if own is None or len(own[2]) != 1 or any(map(scene.unknown, own[1])):
            continue
        if not any(own[1]) or not any(a != b for a, b in zip(own[1], scene.initial(body).value)):
            continue
        late, lines = {body: own[1]}, {body: own[2][0]}
        change, axis = line_of_change(scene, number, late, lines)
        if angle is not None and not _tangent(scene, number, angle, change, axis):
            return False
        (other,) = (sphere for sphere in spheres if sphere != body)
        late[other], lines[other] = by_momentum(scene, number, body, late, lines, other)
        law, _ = restitution_along(scene, number, late, lines, plain_direction(change), axis)
        (symbol,) = names
        close(scene, law, symbol)
        _settle(scene, number, late, lines, change, axis)
        return True
    return False


def _tangent(scene: Scene, number: int, angle: sp.Symbol, change: Vector, axis: int) -> bool:
    """Whether the angle of a line of centres comes of the vector to which it is parallel."""
    x, y = plain_direction(change)
    if x == 0 or y == 0:
        return False
    tangent = Apply("tan", Letter(angle.name))
    value = tidy(sp.radsimp(y / x))
    move = Move("define", "parallel", number)
    if scene.model.sign(x) < 0:
        x, y = -x, -y
    # A quotient of whole numbers is one itself.
    quotient = tree_of(value) if value.is_Rational else swept(Binary("/", tree_of(y), tree_of(x)))
    relation = chain(tangent, (quotient, None), (tree_of(value), "rearrange"))
    line = scene.judge.write((move,), (axis, f"axis {number}"), relation)
    if line is None:
        return False
    scene.desk.know(tangent, value, (line,))
    close(scene, line, angle)
    return True


def _in_either_sense(scene: Scene, number: int, ray: Ray) -> bool:
    """Whether a velocity comes of its speed, and what follows of it: its lines are written."""
    symbol, late, lines = _ray_line(scene, number, ray)
    late[ray.body], lines[ray.body] = _by_speed(scene, number, ray, symbol, lines)
    if not any(scene.unknown(scene.mass(sphere).value) for sphere in scene.spheres(number)):
        _add_others(scene, number, ray.body, late, lines)
    _settle(scene, number, late, lines, *line_of_change(scene, number, late, lines))
    return True


def as_a_multiple(ray: Ray) -> Ray:
    """A velocity along a slanting line as a number times the vector that is given: k(3i + 2j)."""
    if 0 in ray.direction or ray.role is not REAL or ray.letter is not None:
        return ray
    direction = plain_direction(ray.direction)
    if sp.sympify(direction.dot(ray.direction), strict=True).is_negative:
        direction = -direction
    whole = [(axis, part) for axis, part in zip("ij", direction) if part.is_Rational]
    axis, part = next((own for own in whole if own[1] == 1), whole[0])
    assert isinstance(ray.quantity, Quantity)
    velocity = ray.quantity.arguments[0]
    own: Expression = Quantity("along", (velocity, Unit("i" if axis == "i" else "j")))
    if part != 1:
        own = swept(Binary("/", own, tree_of(part)))
    return replace(ray, quantity=own, direction=direction)


def _ray_line(
    scene: Scene, number: int, ray: Ray
) -> tuple[sp.Symbol, dict[str, Vector], dict[str, Ref]]:
    """The letter of a velocity, that velocity, and its line."""
    symbol, line = write_ray(scene, number, ray)
    return symbol, {ray.body: ray.direction * symbol + ray.rest}, {ray.body: line}


def _add_others(
    scene: Scene, number: int, body: str, late: dict[str, Vector], lines: dict[str, Ref]
) -> None:
    """Adds the velocity of the other sphere, by the momentum of both."""
    for other in scene.spheres(number):
        if other != body:
            late[other], lines[other] = by_momentum(scene, number, body, late, lines, other)


def ray_of(scene: Scene, body: str, number: int) -> Ray | None:
    """The direction of a velocity after an impact, as far as it is given."""
    velocity = Quantity("velocity", (Name(body),), number)
    for equation in scene.given:
        match equation.link:
            case Link(Quantity("direction", (Name(name),), event), "=", angle) if (
                name == body and event == number
            ):
                turn = scene.scalar(angle)
                if turn.free_symbols:
                    continue
                direction = Vector(tidy(sp.cos(turn)), tidy(sp.sin(turn)))
                return Ray(
                    body, Quantity("speed", (Name(body),), number), direction, equation, POSITIVE
                )
        multiple = _multiple(scene, body, velocity, equation)
        if multiple is not None:
            return multiple
        tie = tie_of(equation.link)
        beside = None if tie is None else _beside(scene, velocity, *tie)
        if beside is None:
            continue
        # Along i and j the letter is a component.
        if beside.x == 0 or beside.y == 0:
            unit: Expression = Unit("j" if beside.x == 0 else "i")
            along = Vector(*(sp.Integer(0 if x == 0 else 1) for x in beside))
            return Ray(body, Quantity("along", (velocity, unit)), along, equation, REAL)
        size = scene.model.story.size(beside)
        along = Vector(*(tidy(x / size) for x in beside))
        axis = tree_of(beside)
        return Ray(body, Quantity("along", (velocity, axis)), along, equation, REAL)
    return None


def _multiple(scene: Scene, body: str, velocity: Quantity, equation: GivenEquation) -> Ray | None:
    """A velocity that is given as an unknown letter times a vector, and more; None of another."""
    if equation.link.left != velocity or equation.link.sign != "=":
        return None
    value = scene.vector(equation.link.right)
    names = scene.unknown(value)
    if len(names) != 1:
        return None
    (symbol,) = names
    role = roles(scene.problem).get(symbol.name)
    direction = Vector(*(tidy(derivative(x, symbol)) for x in value))
    if role is None or any(map(scene.unknown, direction)):
        return None
    rest = Vector(*(tidy(expanded(x.subs(symbol, 0))) for x in value))
    return Ray(body, velocity, direction, equation, role, symbol, rest)


def _beside(
    scene: Scene, velocity: Quantity, left: Expression, right: Expression, relation: str
) -> Vector | None:
    """The direction, or its opposite, of a velocity that is parallel or perpendicular to another.

    None where that is not known.
    """
    for one, other in ((left, right), (right, left)):
        if one != velocity or other == velocity:
            continue
        try:
            direction = scene.model.story.direction(other, scene.events)
        except (ArithmeticError, ValueError):
            return None
        if any(scene.unknown(x) for x in direction):
            return None
        if relation == "perpendicular to":
            direction = direction.turned_left()
        plain = plain_direction(direction)
        if not all(value.is_number for value in plain):
            return None
        # A perpendicular has no sense of its own.
        ahead = plain.x if relation == "perpendicular to" else plain.dot(direction)
        return -plain if scene.model.sign(ahead) < 0 else plain
    return None


def _speed(scene: Scene, ray: Ray, number: int) -> GivenEquation | None:
    """The fact that gives the speed along a line, in either sense, by what is known."""
    if ray.role is not REAL or ray.letter is not None:
        return None
    speed = Quantity("speed", (Name(ray.body),), number)
    for equation in scene.given:
        if equation.link.left == speed and equation.link.sign == "=":
            value = scene.scalar(equation.link.right)
            return None if scene.unknown(value) else equation
    return None


def _by_speed(
    scene: Scene,
    number: int,
    ray: Ray,
    symbol: sp.Symbol,
    lines: dict[str, Ref],
    law: int | None = None,
) -> tuple[Vector, Ref]:
    """The velocity along a line by the speed that is given: in either sense.

    With a ``law`` one of the senses contradicts that.
    """
    given = _speed(scene, ray, number)
    assert given is not None
    line = lines[ray.body]
    speed, refs = scene.put(scene.scalar(given.link.right))
    subject = tree_of(symbol)
    parts = [tidy(x * symbol) for x in ray.direction if x != 0]
    if scene.model.identically_zero(ray.direction.dot(ray.direction) - 1):
        parts = [symbol]
    own = chain(total(square(tree_of(x)) for x in parts), (square(tree_of(speed)), None))
    move = Move("define", "speed", number, (ray.body,))
    premises = scene.judge.needed(move, together(given.refs, refs, (line,)), own)
    if premises is None:
        raise NotPlannedError("a speed along a line")
    squared = scene.desk.write(move, premises, own)
    if law is None:
        close(scene, squared, symbol)
    else:
        value = scene.final(symbol)
        roots = Relation(tuple(chain(subject, (tree_of(x), None)).only for x in (value, -value)))
        both = scene.desk.write(Move("roots"), (squared,), roots)
        kept = chain(subject, (tree_of(value), None))
        names = symbol_names(residual(scene, law))
        left = scene.judge.enough(Move("reject"), (both, law), kept, background(scene, names))
        if left is None:
            raise NotPlannedError("a sense that the law does not exclude")
        scene.desk.know(subject, value, (scene.desk.write(Move("reject"), left, kept),))
        return ray.direction * symbol, line
    value, more = scene.put(ray.direction * symbol)
    velocity = Quantity("velocity", (Name(ray.body),), number)
    relation = chain(velocity, (tree_of(value), None))
    return value, scene.desk.write(Move("put"), (line, *more), relation)


def write_ray(
    scene: Scene,
    number: int,
    ray: Ray,
    names: Sequence[str] = _LETTERS,
    nothing_shown: Showing = "line",
) -> tuple[sp.Symbol, int]:
    """The letter of such a velocity, and the line that gives the velocity by it.

    That it has no component across its direction is a line that may be silent.
    """
    if ray.letter is not None:
        return ray.letter, scene.desk.write(
            Move("fact"), ray.given.refs, Relation(((ray.given.link,),))
        )
    taken = letters_taken(scene)
    plain = plain_direction(ray.direction)
    is_slanting = ray.role is REAL and 0 not in ray.direction
    is_multiple = is_slanting and plain.x in (ray.direction.x, -ray.direction.x)
    if is_multiple:
        names, nothing_shown = _MULTIPLES, "silent"
    name = next(name for name in names if name not in taken)
    symbol = ray.role.symbol(name)
    scene.model.unknowns.roles = {**scene.model.unknowns.roles, name: ray.role}
    for model in {id(model): model for model in (scene.model, *scene.others)}.values():
        final = model.branch.story.velocity(ray.body, number)
        value = tidy(final.dot(ray.direction) / ray.direction.dot(ray.direction))
        model.final[symbol] = value
        model.sample[name] = number_of(model.number(value))
    let = scene.desk.write(Move("let"), (), Meaning(name, ray.quantity))
    velocity = Quantity("velocity", (Name(ray.body),), number)
    refs: tuple[Ref, ...] = (*ray.given.refs, let)
    if ray.role is REAL:
        other: Expression = Unit("i" if ray.direction.x == 0 else "j")
        if 0 not in ray.direction:
            across = plain.turned_left()
            other = tree_of(across if scene.model.sign(across.x) > 0 else -across)
        move = Move("define", _record(ray.given), number)
        none = chain(Quantity("along", (velocity, other)), (ZERO, None))
        early = [scene.initial(sphere) for sphere in scene.spheres(number)]
        pool = together(
            ray.given.refs, *(source.refs for source in early), scene.mass(ray.body).refs
        )
        premises = scene.judge.needed(move, pool, none)
        if premises is None:
            raise NotPlannedError("a line that is not told")
        nothing = scene.desk.write(move, premises, none, nothing_shown)
        refs = (let, nothing)
    value = vector_tree(ray.direction * symbol)
    if is_multiple:
        value = product(Letter(name), tree_of(ray.direction))
    elif is_slanting:
        size = tree_of(tidy(plain.x / ray.direction.x))
        value = product(Letter(name), Binary("/", tree_of(plain), size))
    line = scene.desk.write(
        Move("define", "assemble", number, (ray.body,)), refs, chain(velocity, (value, None))
    )
    return symbol, line


def _record(given: GivenEquation) -> str:
    """What a fact says of two directions: that they are parallel, or perpendicular."""
    tie = tie_of(given.link)
    assert tie is not None
    return tie[2].removesuffix(" to")


def _settle(
    scene: Scene,
    number: int,
    late: dict[str, Vector],
    lines: dict[str, Ref],
    change: Vector,
    axis: int,
) -> None:
    """The velocities and the line with what has been found."""
    known: dict[str, Ref] = {}
    for body, value in late.items():
        put, refs = scene.put(value)
        velocity = Quantity("velocity", (Name(body),), number)
        line: Ref = lines[body]
        if refs:
            line = scene.desk.write(
                Move("put"), (line, *refs), chain(velocity, (vector_tree(put), None))
            )
        scene.desk.know(
            velocity, Vector(*(tidy(expanded(component)) for component in put)), (line,)
        )
        known[body] = line
    put, refs = scene.put(change)
    centres = Quantity("line_of_centres", (), number)
    own = scene.model.frames[number]
    plain = plain_direction(put)
    n = own.n if scene.model.sign(plain.dot(own.n)) > 0 else -own.n
    if any(x.free_symbols for x in n):
        size = scene.model.story.size(plain)
        n = Vector(*(tidy(x / size) for x in plain))  # the angle is that of the line
    line = axis
    if refs:
        line = scene.desk.write(
            Move("put"),
            (axis, *refs),
            Relation(((Link(centres, "parallel to", vector_tree(put)),),)),
        )
    if vector_tree(put) != vector_tree(plain):
        line = scene.desk.write(
            Move("rearrange"),
            (line,),
            Relation(((Link(centres, "parallel to", vector_tree(plain)),),)),
        )
    scene.desk.know(centres, plain, (line,))
    sign = 1 if scene.model.sign(n.dot(own.n)) > 0 else -1
    scene.frames[number] = Frame(number, own.wall, centres, None, n, n.turned_left(), (line,), sign)
    for body, ref in known.items():
        symbol = scene.model.components[number, body].symbol
        scene.desk.know(Letter(symbol.name), scene.model.final[symbol], (ref, line))
