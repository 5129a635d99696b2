"""Quantities with their values put in: kinetic energies, impulses, speeds, angles, times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import sympy as sp

from restitution.exact import tidy, tidy_angle
from restitution.explain.marks import without_method
from restitution.explain.phrases import (
    answer,
    chain,
)
from restitution.explain.steps import Row, Side, shown, side
from restitution.explaining.marks import A1, M1, Mark, Marks
from restitution.explaining.printing import look, printed, scalar_product
from restitution.explaining.saying import Sentence, say
from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    has_quantity,
)
from restitution.problem import Impact, Kick
from restitution.render import layout as lay
from restitution.render.layout import Brackets, Layout, Number
from restitution.solve import forms
from restitution.solve.quantities import event_of, is_line, stage_number
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.explain.working import Working

# What a quantity rests on across the line of centres as well as along it.
WHOLE = frozenset(
    {
        "velocity",
        "speed",
        "direction",
        "across",
        "along",
        "angle",
        "deflection",
        "energy",
        "momentum",
        "position",
        "distance",
        "dot",
        "time",
    }
)


@dataclass(frozen=True)
class Derived:
    """How a quantity is found: lines with the values put in, and the value."""

    rows: tuple[Row, ...]
    value: Any
    sentences: tuple[Sentence, ...] = ()
    title: Sentence | None = None


def stage_of(work: Working, tree: Quantity, now: int, body: str | None) -> int:
    """After how many events a quantity is meant."""
    return stage_number(work.model.story, tree, now, body)


def name_of(tree: Expression) -> str | None:
    """The sphere that a quantity is of."""
    if isinstance(tree, Quantity) and tree.arguments and isinstance(tree.arguments[0], Name):
        return tree.arguments[0].name
    return None


def components(work: Working, body: str, stage: int) -> tuple[sp.Expr, sp.Expr]:
    """The components in which a velocity is best known: those of its latest impact."""
    v = work.model.story.velocity(body, stage)
    frame = work.model.owner(body, stage)
    if frame is None or frame.axis is not None:
        return work.put(v.x), work.put(v.y)
    return work.put(v.dot(frame.n)), work.put(v.dot(frame.t))


def evaluated(work: Working, tree: Expression, now: int) -> Any:
    """The value of a tree with all that is known put in: an expression, a pair or an angle."""
    value = work.value(tree, now)
    return plain(work, value)


def plain(work: Working, value: Any) -> Any:
    """A value of the story with all that is known put in."""
    if isinstance(value, Vector):
        return (work.put(value.x), work.put(value.y))
    if isinstance(value, Angle):
        own = Angle(work.put(value.x), work.put(value.y), value.measure)
        return forms.angle(own, work.model.witnesses(own.x, own.y))
    return work.put(value)


def inside(work: Working, tree: Expression, now: int) -> frozenset[sp.Symbol]:
    """The unknowns on which a tree rests."""
    value = work.value(tree, now)
    if isinstance(value, Angle):
        return work.open(value.x) | work.open(value.y)
    return work.open(tuple(value) if isinstance(value, Vector) else value)


# --- expressions with values put in -------------------------------------------------------------


def put_in(work: Working, tree: Expression, now: int) -> Side:
    """An expression with the values of its quantities put in, not worked out."""
    value = evaluated(work, tree, now)
    return Side(_laid(work, tree, now), value)


def _laid(work: Working, tree: Expression, now: int) -> Layout:
    match tree:
        case Quantity():
            return formula(work, tree, now).layout
        case Negate(operand):
            return lay.negative(_laid(work, operand, now))
        case Binary(op, left, right) if has_quantity(tree):
            a, b = _laid(work, left, now), _laid(work, right, now)
            return _combined(op, a, b)
        case Apply("abs", argument):
            return Brackets(_laid(work, argument, now), "||")
    if isinstance(tree, Letter) or not has_quantity(tree):
        value = evaluated(work, tree, now)
        angle = isinstance(tree, Letter) and _is_angle(work, tree)
        return look(value, angle=angle)
    return work.layout(tree)


def _is_angle(work: Working, tree: Expression) -> bool:
    from restitution.solve.letters import is_angle

    walls = frozenset(wall.name for wall in work.model.problem.walls)
    angles = {n for n, role in work.model.unknowns.roles.items() if role.kind == "angle"}
    return is_angle(tree, angles, walls)


def _combined(op: str, a: Layout, b: Layout) -> Layout:
    if op == "+":
        return printed("a + b", a=a, b=b)
    if op == "-":
        return printed("a - b", a=a, b=b)
    if op == "*":
        return printed("a*b", a=a, b=b)
    if op == "/":
        return printed("a/b", a=a, b=b)
    return lay.power(lay.bracketed(a), b)


def formula(work: Working, tree: Quantity, now: int) -> Side:
    """A quantity in components, with the values put in."""
    value = evaluated(work, tree, now)
    body = name_of(tree)
    made: Layout | None = None
    kind = tree.kind
    if kind == "speed" and body is not None:
        made = _speed(work, *components(work, body, stage_of(work, tree, now, body)))
    elif kind == "energy":
        stage = stage_of(work, tree, now, body)
        names = [body] if body is not None else list(work.model.story.spheres)
        parts = [_energy(work, name, stage) for name in names]
        made = _sum(parts)
    elif kind == "energy_lost":
        made = energy_lost(work, event_of(work.model.story, tree, now).number)
    elif kind == "total_energy_lost":
        made = _total_loss(work, tree, now)
    elif kind == "impulse" and body is None:
        made = impulse(work, event_of(work.model.story, tree, now).number)
    elif kind == "angle" or kind == "deflection" or kind == "direction":
        return Side(look(value, angle=not isinstance(value, tuple)), value)
    return Side(made if made is not None else look(value), value)


def _speed(work: Working, a: sp.Expr, b: sp.Expr) -> Layout:
    if a == 0 or b == 0:
        rest = b if a == 0 else a
        laid = look(rest)
        if work.size(rest).has(sp.Abs):
            return Brackets(laid, "||")
        sign, size = lay.split_sign(laid)
        return size if sign == "-" else laid
    return printed("sqrt(a^2 + b^2)", a=a, b=b)


def _energy(work: Working, name: str, stage: int) -> Layout:
    mass = work.put(work.model.story.mass(name))
    a, b = components(work, name, stage)
    return printed("1/2*m*(a^2 + b^2)", m=mass, a=a, b=b)


def energy_lost(work: Working, number: int) -> Layout:
    """½m(u² − v²) of each sphere, along the line of centres."""
    event = work.model.happening(number)
    if number not in work.model.frames:
        total: Layout = Number("0")
        for name in event.bodies:
            lost = _energy(work, name, number - 1), _energy(work, name, number)
            total = printed("a - b", a=lost[0], b=lost[1])
        return total
    before: list[Layout] = []
    after: list[Layout] = []
    for name in work.model.spheres(number):
        mass = work.put(work.model.story.mass(name))
        u = work.put(work.model.before(number, name)[0])
        v = work.put(work.model.after(number, name))
        before.append(printed("1/2*m*u^2", m=mass, u=u))
        after.append(printed("1/2*m*v^2", m=mass, v=v))
    return printed("a - b", a=_sum(before), b=_sum(after))


def _sum(parts: Sequence[Layout]) -> Layout:
    """A sum without what is zero."""
    return lay.total([each for each in parts if each != Number("0")])


def impulse(work: Working, number: int) -> Layout | None:
    """m(v − u) along the line of centres, so that it is positive."""
    if number not in work.model.frames:
        return None
    name = _impulse_body(work, number)
    mass = work.put(work.model.story.mass(name))
    u = work.put(work.model.before(number, name)[0])
    v = work.put(work.model.after(number, name))
    if work.sign(v - u) < 0:
        u, v = v, u
    return printed("m*(v - u)", m=mass, v=v, u=u)


def _impulse_body(work: Working, number: int) -> str:
    """The sphere whose change of momentum is the shortest to write: one at rest before."""
    names = work.model.spheres(number)

    def cost(name: str) -> tuple[int, float]:
        u, _ = work.model.before(number, name)
        v = work.model.after(number, name)
        still = 0 if work.put(u) == 0 else 1
        idle = 0 if v in work.wanted else 1
        return len(work.open(v)), idle + still / 2 + float(sp.count_ops(work.put(v))) / 100

    return min(names, key=cost)


# --- how a quantity is derived --------------------------------------------------------------------


def derive(
    work: Working,
    tree: Quantity,
    now: int,
    *,
    percentage: bool = False,
    last: Mark = A1,
    name: Layout | None = None,
) -> Derived:
    """The lines by which a quantity is found once the components are known.

    ``name`` is what they call it, where a letter stands for it.
    """
    body = name_of(tree)
    value = evaluated(work, tree, now)
    name = work.layout(tree) if name is None else name
    kind = tree.kind
    if kind == "velocity" and body is not None:
        return _derive_velocity(work, name, tree, body, now, last)
    if kind == "deflection" and body is not None:
        return _derive_deflection(work, name, tree, body, now)
    if kind == "angle":
        return _derive_angle(work, name, tree, now)
    if kind == "direction" and not isinstance(value, tuple):
        return _derive_direction(work, name, tree, body, now, value)
    if kind in ("along", "across"):
        return _derive_component(work, name, tree, now)
    if kind == "energy_lost":
        event = event_of(work.model.story, tree, now)
        sentences: tuple[Sentence, ...] = ()
        if event.number in work.model.frames:
            frame = work.model.frames[event.number]
            across = any(
                work.put(work.model.before(event.number, b)[1]) != 0
                for b in work.model.spheres(event.number)
            )
            if across:
                sentence = say("loss-spheres.unchanged")
                if frame.wall is not None:
                    sentence = say("loss-wall.unchanged", wall=frame.wall)
                sentences = (sentence,)
        made = formula(work, tree, now)
        row = _result(name, made, value, points=(M1, last), principle=bool(sentences))
        return Derived((row,), value, sentences)
    if kind == "impulse":
        return _derive_impulse(work, name, tree, body, now, last)
    if kind == "line_of_centres":
        return _derive_line(work, name, tree, now, value)
    if kind in ("position", "time", "distance"):
        from restitution.explain.journeys import derive_place

        return derive_place(work, name, tree, now)
    if kind == "momentum":
        return _derive_momentum(work, name, tree, body, now, value)
    if kind == "dot":
        a, b = (evaluated(work, each, now) for each in tree.arguments)
        made = Side(printed("dot(a, b)", zeros=True, a=a, b=b), value)
        return Derived((_result(name, made, value, points=(last,)),), value)
    if kind == "total_energy_lost":
        return _derive_total_loss(work, name, tree, now, value)
    made = formula(work, tree, now)
    return Derived(
        (
            _result(
                name,
                made,
                value,
                percentage=percentage,
                points=(M1, last) if kind != "mass" else (last,),
            ),
        ),
        value,
    )


def _result(
    name: Any,
    made: Side | None,
    value: Any,
    *,
    angle: bool = False,
    percentage: bool = False,
    points: Marks = (A1,),
    principle: bool = False,
) -> Row:
    sides: list[Any] = [name if isinstance(name, Side) else Side(lay.as_layout(name), value)]
    if made is not None and made.layout != look(value, angle=angle):
        sides.append(made)
    elif not principle:
        points = without_method(points)  # the value alone shows no method
    sides += answer(value, angle=angle, percentage=percentage)
    return chain(*sides, points=points)


def _derive_velocity(
    work: Working, name: Layout, tree: Quantity, body: str, now: int, last: Mark
) -> Derived:
    stage = stage_of(work, tree, now, body)
    value = evaluated(work, tree, now)
    frame = work.model.owner(body, stage)
    event = work.model.story.latest(body, stage)
    rows: list[Row] = []
    made: Side | None = None
    if event is not None and isinstance(event.step, Kick) and stage >= event.number:
        return (
            Derived((), value)
            if ("kick", event.number) in work.done and _told(work, body, stage)
            else Derived((_result(name, None, value, points=(last,)),), value)
        )
    if frame is not None and frame.axis is None and value != (0, 0):
        v = work.model.story.velocity(body, stage)
        a, b = work.put(v.dot(frame.n)), work.put(v.dot(frame.t))
        n, t = (tuple(work.put(way)) for way in (frame.n, frame.t))
        made = Side(printed("a*n + b*t", a=a, n=n, b=b, t=t), value)
    rows.append(_result(name, made, value, points=(last,)))
    return Derived(tuple(rows), value)


def _told(work: Working, body: str, stage: int) -> bool:
    return ("velocity", body, stage) in work.done


def _derive_component(work: Working, name: Layout, tree: Quantity, now: int) -> Derived:
    value = evaluated(work, tree, now)
    v = evaluated(work, tree.arguments[0], now)
    d = work.model.story.direction(tree.arguments[1], now)
    d = Vector(work.put(d.x), work.put(d.y))
    if tree.kind == "across":
        d = d.turned_left()
    if d.x == 0 or d.y == 0:
        return Derived((_result(name, None, value),), value)
    size = tidy(sp.sqrt(tidy(d.dot(d))))
    above = scalar_product(v, (d.x, d.y))
    made = Side(printed("a/b", a=above, b=size), value)
    return Derived((_result(name, made, value, points=(M1, A1)),), value)


def _derive_direction(
    work: Working, name: Layout, tree: Quantity, body: str | None, now: int, value: Any
) -> Derived:
    assert body is not None
    v = work.model.story.velocity(body, stage_of(work, tree, now, body))
    x, y = work.put(v.x), work.put(v.y)
    row = _result(name, None, value, angle=True)
    if x == 0 or y == 0:
        return Derived((row,), value)
    tangent = tidy(y / x)
    plain_ratio = isinstance(look(y), lay.Fraction) or isinstance(look(x), lay.Fraction)
    made = side(tangent) if plain_ratio else side(tangent, printed("a/b", a=y, b=x))
    first = chain(side(tangent, lay.function("tan", name)), made, side(tangent), points=(M1,))
    return Derived((first, row), value)


def _lines(work: Working, tree: Quantity, now: int) -> tuple[Vector, Vector]:
    made = [work.model.story.direction(each, now) for each in tree.arguments]
    return tuple(Vector(work.put(d.x), work.put(d.y)) for d in made)  # type: ignore[return-value]


def _derive_angle(work: Working, name: Layout, tree: Quantity, now: int) -> Derived:
    value = evaluated(work, tree, now)
    story = work.model.story
    a, b = _lines(work, tree, now)
    sharp = any(is_line(story, each) for each in tree.arguments)
    dot = tidy(a.dot(b))
    final = _result(name, None, value, angle=True)
    if work.sign(dot) == 0:
        row = chain(shown(_dot_layout(a, b)), side(sp.Integer(0)), points=(M1,))
        return Derived((row, final), value, (say("product.zero"),))
    frame = _frame_along(work, tree, now)
    if sharp and frame is not None:
        u, v = frame
        u, v = (work.size(x) for x in (u, v))
        if u == 0:
            return Derived((final,), value)
        tangent = tidy(v / u)
        rows = (
            chain(
                side(tangent, _tangent(name)),
                side(tangent, printed("a/b", a=v, b=u)),
                side(tangent),
                points=(M1,),
            ),
            final,
        )
        return Derived(rows, value)
    if not sharp and not _numeric_angle(a, b):
        for one, other in ((a, b), (b, a)):
            if one.x == 0 or one.y == 0:
                return Derived((_tangent_to(work, name, one, other), final), value)
    return Derived((*_cosine_rows(work, a, b, value, sharp), final), value)


def _tangent_to(work: Working, name: Layout, axis: Vector, v: Vector) -> Row:
    """The tangent of the angle between a vector and one that is parallel to an axis."""
    along, across = (v.x, v.y) if axis.y == 0 else (v.y, v.x)
    way = axis.x if axis.y == 0 else axis.y
    along = tidy(-along) if work.sign(way) < 0 else along
    across = work.size(across)
    tangent = tidy(across / along)
    return chain(
        side(tangent, _tangent(name)),
        side(tangent, printed("a/b", a=across, b=along)),
        side(tangent),
        points=(M1,),
    )


def _tangent(name: Layout) -> Layout:
    """The tangent of an angle by its name."""
    return lay.function("tan", name if isinstance(name, lay.Letter) else Brackets(name))


def _frame_along(work: Working, tree: Quantity, now: int) -> tuple[sp.Expr, sp.Expr] | None:
    """Components of the first direction along and across the second, if these are known."""
    vector, line = tree.arguments
    if is_line(work.model.story, vector):
        vector, line = line, vector
    if not isinstance(vector, Quantity) or vector.kind != "velocity":
        return None
    v = work.model.story.evaluator(now).vector(vector)
    d = work.model.story.direction(line, now)
    size = tidy(sp.sqrt(tidy(sp.expand(work.put(d.dot(d))))))
    along = work.put(v.dot(d) / size)
    across = work.put(v.dot(d.turned_left()) / size)
    return along, across


def _cosine_rows(work: Working, a: Vector, b: Vector, value: Any, sharp: bool = False) -> list[Row]:
    """Cos θ from the scalar product, with the values put in."""
    theta = _theta(work)
    dot = tidy(a.dot(b))
    cosine = tidy(sp.cos(value))
    if cosine.has(sp.atan, sp.atan2) or sp.count_ops(cosine) > 12:
        cosine = tidy(dot / (sp.sqrt(tidy(a.dot(a))) * sp.sqrt(tidy(b.dot(b)))))
    above = printed("dot(a, b)", a=tuple(a), b=tuple(b))
    sizes = [
        look(tidy(work.resolved(tidy(sp.sqrt(tidy(sp.expand(each.dot(each)))))))) for each in (a, b)
    ]
    below = sizes[0]
    if sizes[1] != Number("1"):
        below = printed("a*b", a=sizes[0], b=sizes[1])
    if sharp and work.sign(dot) < 0:
        above = Brackets(above, "||")
    return [
        chain(
            side(cosine, lay.function("cos", theta)),
            side(cosine, printed("a/b", a=above, b=below)),
            side(cosine),
            points=(M1,),
        )
    ]


def _theta(work: Working) -> Layout:
    used = work.model.unknowns.roles
    return lay.Letter(next(n for n in ("theta", "phi", "psi", "delta") if n not in used))


def _derive_deflection(work: Working, name: Layout, tree: Quantity, body: str, now: int) -> Derived:
    event = event_of(work.model.story, tree, now, body)
    value = evaluated(work, tree, now)
    before = work.put(event.before[body])
    after = work.put(event.after[body])
    final = _result(name, None, value, angle=True)
    frame = work.model.frames.get(event.number)
    if frame is None or not _numeric_angle(before, after):
        return _deflection_by_tangents(work, event.number, body, value, name)
    dot = tidy(before.dot(after))
    if work.sign(dot) == 0:
        return Derived(
            (chain(shown(_dot_layout(before, after)), side(sp.Integer(0)), points=(M1,)), final),
            value,
            (say("product.velocities"),),
        )
    if frame.wall is not None:
        return _deflection_at_wall(work, event.number, body, value, name)
    if work.sign(before.cross(after)) == 0:
        way = say("motion.same" if work.sign(dot) > 0 else "motion.reversed", body=body)
        return Derived((final,), value, (way,))
    rows = _cosine_rows(work, _scaled(before), _scaled(after), value)
    return Derived((*rows, final), value, (say("turned.between", body=body),))


def _scaled(v: Vector) -> Vector:
    """A vector without the letters common to its components."""
    x, y = v
    letters = sp.sympify(x, strict=True).free_symbols | sp.sympify(y, strict=True).free_symbols
    if not letters:
        return v
    common = sp.sympify(x if x != 0 else y, strict=True)
    number, rest = common.as_independent(*letters, as_Add=False)
    del number
    return Vector(tidy(x / rest), tidy(y / rest))


def _dot_layout(a: Vector, b: Vector) -> Layout:
    return scalar_product((a.x, a.y), (b.x, b.y))


def _numeric_angle(*vectors: Vector) -> bool:
    """Whether the directions are free of letters, as in 3u i − 4u j."""
    for v in vectors:
        x, y = v
        if x == 0 or y == 0:
            continue
        if tidy(y / x).free_symbols:
            return False
    return True


def _deflection_at_wall(work: Working, number: int, body: str, value: Any, name: Layout) -> Derived:
    """α + β: the angles to the wall before and after."""
    un, ut = (work.put(x) for x in work.model.before(number, body))
    v = work.put(work.model.after(number, body))
    wall = work.model.frames[number].wall
    first = _angle_of(work, tidy(-un), ut)
    second = _angle_of(work, v, ut)
    if ut == 0:
        return Derived(
            (_result(name, None, value, angle=True),), value, (say("motion.back", body=body),)
        )
    made = Side(
        lay.total([look(each, angle=True) for each in (first, second) if each != 0]),
        tidy(first + second),
    )
    return Derived(
        (_result(name, made, value, angle=True, points=(M1, A1)),),
        value,
        (say("turned-wall.angles", body=body, wall=wall or ""),),
    )


def _angle_of(work: Working, above: sp.Expr, below: sp.Expr) -> sp.Expr:
    if below == 0:
        return sp.pi / 2
    return tidy_angle(sp.atan(tidy(work.resolved(above / below))))


def _deflection_by_tangents(
    work: Working, number: int, body: str, value: Any, name: Layout
) -> Derived:
    """tan(β − α) or tan(α + β) from the tangents of the angles to the line."""
    final = _result(name, None, value, angle=True)
    if number not in work.model.frames:
        event = work.model.happening(number)
        rows = _cosine_rows(work, work.put(event.before[body]), work.put(event.after[body]), value)
        return Derived((*rows, final), value)
    un, ut, v = _parts(work, number, body)
    tangent = tidy(work.resolved(sp.Abs(ut * (un - v)) / (un * v + ut**2)))
    if work.model.frames[number].wall is None and 0 in (work.sign(v), work.sign(un)):
        sentences = (say("motion.across", body=body),) if work.sign(v) == 0 else ()
        return Derived((final,), value, sentences)
    sentence, laid = _spread(work, number, body, tangent)
    if sp.sympify(tangent, strict=True).has(sp.zoo, sp.nan):
        return Derived((final,), value)
    rows = [
        chain(
            side(tangent, _tangent(name)),
            side(tangent, laid),
            side(tangent),
            points=(M1, A1),
        )
    ]
    if sp.sympify(value, strict=True).is_number or not sp.sympify(value, strict=True).has(
        sp.atan, sp.atan2
    ):
        rows.append(final)
    return Derived(tuple(rows), value, (sentence,))


def _parts(work: Working, number: int, body: str) -> tuple[sp.Expr, sp.Expr, sp.Expr]:
    """Components along before, across (made positive), and along after."""
    un, ut = (work.put(x) for x in work.model.before(number, body))
    v = work.put(work.model.after(number, body))
    return un, work.size(ut), v


def _spread(work: Working, number: int, body: str, tangent: sp.Expr) -> tuple[Sentence, Layout]:
    """tan(α + β) at a wall, tan(β − α) between spheres, from the tangents."""
    un, ut, v = _parts(work, number, body)
    frame = work.model.frames[number]
    if frame.wall is not None:
        a, b = tidy(-un / ut), tidy(v / ut)
        sentence = say("turned-wall.sum", body=body, wall=frame.wall)
        return sentence, printed("(a + b)/(1 - p)", a=a, b=b, p=_times(a, b))
    a, b = tidy(ut / un), tidy(ut / v)
    first = work.sign((b - a) / (1 + a * b)) * work.sign(tangent) > 0
    big, small = (b, a) if first else (a, b)
    laid = printed("(a - b)/(1 + p)", a=big, b=small, p=_times(a, b))
    return say("turned.difference", body=body), laid


def tangent_of_difference(
    work: Working, tree: Quantity, now: int
) -> tuple[Sentence, Layout] | None:
    """How the tangent of an angle of deflection is made up, where tangents serve."""
    body = name_of(tree)
    assert body is not None
    event = event_of(work.model.story, tree, now, body)
    if event.number not in work.model.frames:
        return None
    un, ut, v = _parts(work, event.number, body)
    if 0 in (work.sign(un), work.sign(ut), work.sign(v)):
        return None
    tangent = tidy(work.resolved(sp.Abs(ut * (un - v)) / (un * v + ut**2)))
    if sp.sympify(tangent, strict=True).has(sp.zoo, sp.nan):
        return None
    return _spread(work, event.number, body, tangent)


def _times(a: sp.Expr, b: sp.Expr) -> Layout:
    """A product with the values put in; one with letters worked out."""
    return printed("a*b", a=a, b=b) if a.is_number and b.is_number else look(tidy(a * b))


def _derive_impulse(
    work: Working, name: Layout, tree: Quantity, body: str | None, now: int, last: Mark
) -> Derived:
    value = evaluated(work, tree, now)
    story = work.model.story
    event = event_of(story, tree, now, body)
    if body is not None:
        if isinstance(event.step, Impact) and event.number in work.model.frames:
            v, u = work.put(event.after[body]), work.put(event.before[body])
            mass = work.put(story.mass(body))
            change = printed("m*(v - u)", m=mass, v=tuple(v), u=tuple(u))
            made = Side(change, value)
            return Derived(
                (_result(name, made, value, points=(M1, last), principle=True),),
                value,
                title=say("impulse.title"),
            )
        return Derived((_result(name, None, value, points=(last,)),), value)
    made_ = formula(work, tree, now)
    title = None
    if event.number in work.model.frames:
        which = _impulse_body(work, event.number)
        frame = work.model.frames[event.number]
        title = say("impulse-spheres.title", body=which)
        if frame.wall is not None:
            title = say("impulse-wall.title", body=which, wall=frame.wall)
    rows = (_result(name, made_, value, points=(M1, last), principle=True),)
    return Derived(rows, value, title=title)


def _derive_line(work: Working, name: Layout, tree: Quantity, now: int, value: Any) -> Derived:
    return Derived((_result(name, None, value),), value)


def _derive_momentum(
    work: Working, name: Layout, tree: Quantity, body: str | None, now: int, value: Any
) -> Derived:
    story = work.model.story
    stage = stage_of(work, tree, now, body)
    names = [body] if body is not None else list(story.spheres)
    terms = []
    for each in names:
        v = work.put(story.velocity(each, stage))
        if v == (0, 0):
            continue
        terms.append(printed("m*v", m=work.put(story.mass(each)), v=(v.x, v.y)))
    laid = lay.total(terms)
    laid = laid.inside if isinstance(laid, Brackets) else laid  # of mass 1, and alone
    made = Side(laid, value) if terms else None
    return Derived((_result(name, made, value, points=(M1, A1)),), value)


def _derive_total_loss(
    work: Working, name: Layout, tree: Quantity, now: int, value: Any
) -> Derived:
    laid = _total_loss(work, tree, now)
    made = None if laid is None else Side(laid, value)
    return Derived((_result(name, made, value, points=(M1, A1)),), value)


def _total_loss(work: Working, tree: Quantity, now: int) -> Layout | None:
    """Kinetic energy at the start less that after the events told."""
    upto = stage_of(work, tree, now, None)
    story = work.model.story
    if any(isinstance(h.step, Kick) for h in story.happenings[:upto]):
        return None
    before, after = (_sum([_energy(work, n, at) for n in story.spheres]) for at in (0, upto))
    return printed("a - b", a=before, b=after)


@dataclass(frozen=True)
class Asked:
    """A quantity that an expression speaks of, with the letter that names it, if any."""

    tree: Quantity
    now: int
    letter: Letter | None = None


def quantities_in(work: Working, tree: Expression, now: int) -> Sequence[Asked]:
    """The quantities of an expression that are not inside another, in order.

    A letter that names a quantity (``let beta = …``) counts as that quantity.
    """
    if isinstance(tree, Quantity):
        return (Asked(tree, now),)
    if isinstance(tree, Letter):
        let = work.model.story.lets.get(tree.name)
        if let is None:
            return ()
        step, then = let
        if isinstance(step.expression, Quantity):
            return (Asked(step.expression, then, tree),)
        return quantities_in(work, step.expression, then)
    from restitution.expression.tree import children

    return tuple(q for each in children(tree) for q in quantities_in(work, each, now))
