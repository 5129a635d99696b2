"""Directions: where the line of centres lies, and velocities resolved along it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Literal

import sympy as sp

from restitution.components import Frame
from restitution.exact import tidy
from restitution.explain.phrases import (
    chain,
    direction_words,
)
from restitution.explain.steps import Row, Side, shown, side
from restitution.explaining.marks import A1, B1, M1
from restitution.explaining.printing import look, printed, scalar_product
from restitution.explaining.saying import Sentence, operand, say
from restitution.expression.tree import Expression, Name, Negate, Quantity, walk
from restitution.problem import Aligned, AtRest, Compare, Impact, Relation, trees_of_relation
from restitution.render import layout as lay
from restitution.render.layout import Bold, Layout, Letter, Number
from restitution.solve.facts import givens
from restitution.solve.quantities import event_of, stage_number
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.explain.working import Working


def resolved(work: Working, frame: Frame) -> list[Row]:
    """Components before an impact, where they are not simply the given ones."""
    rows: list[Row] = []
    happening = work.model.happening(frame.number)
    for body in work.model.spheres(frame.number):
        u = happening.before[body]
        raw_n, raw_t = work.model.before(frame.number, body)
        if work.model.on_a_chord(frame.number, body):
            continue
        if frame.wall is not None:
            raw_n = tidy(-raw_n)
        opened = work.open(raw_n) | work.open(raw_t)
        if opened and (frame.axis is not None or not opened <= work.letters()):
            continue
        un, ut = work.put(raw_n), work.put(raw_t)
        if un == 0 and ut == 0:
            continue
        looks = _by_angle(work, frame, un, ut) or _split(work, un, ut, work.put(Vector(*u)), frame)
        if looks is None and (raw_n != un or raw_t != ut) and _has_angle(raw_n, raw_t):
            looks = look(raw_n), look(raw_t)
        if looks is None:
            continue
        names = say("operand.along", body=body), say("operand.across", body=body)
        if frame.wall is not None:
            names = (
                say("operand.towards", wall=frame.wall),
                say("operand.parallel", wall=frame.wall),
            )
        for name, made, value in zip(names, looks, (un, ut), strict=True):
            if value == 0 and name == names[1]:
                continue
            rows.append(chain(shown(operand(name)), Side(made, value), side(value)))
    return rows


def _by_angle(
    work: Working, frame: Frame, un: sp.Expr, ut: sp.Expr
) -> tuple[Layout, Layout] | None:
    """``u cos θ`` and ``u sin θ``, with the angle that an offset fixes."""
    step = work.model.happening(frame.number).step
    if not isinstance(step, Impact) or step.offset is None:
        return None
    happening = work.model.happening(frame.number)
    w = happening.before[step.first] - happening.before[step.second]
    along, across = work.put(w.dot(frame.n)), work.put(w.dot(frame.t))
    if work.sign(along * ut - across * un) != 0:
        return None
    size = tidy(work.resolved(sp.sqrt(tidy(sp.expand(un**2 + ut**2)))))
    theta = angle_letter(work)
    made = []
    for value, function in ((un, "cos"), (ut, "sin")):
        laid = lay.product(look(size), lay.function(function, theta))
        made.append(lay.negative(laid) if work.sign(value) < 0 else laid)
    return made[0], made[1]


def angle_letter(work: Working) -> Layout:
    """A letter for an angle that the problem does not use."""
    used = work.model.unknowns.roles
    return Letter(next(n for n in ("theta", "phi", "psi", "delta") if n not in used))


def _has_angle(*values: sp.Expr) -> bool:
    return any(value.has(sp.cos, sp.sin, sp.tan) for value in values)


def _split(
    work: Working, un: sp.Expr, ut: sp.Expr, u: Vector, frame: Frame
) -> tuple[Layout, Layout] | None:
    """``u cos 60°`` and ``u sin 60°``, or scalar products."""
    size = tidy(sp.sqrt(tidy(sp.expand(un**2 + ut**2))))
    first, second = tidy(un / size), tidy(ut / size)
    if first == 0 or second == 0:
        return None
    if frame.axis is not None and _surd(size):
        return None
    plain = frame.axis is None and all(sp.sympify(x, strict=True).is_Rational for x in u)
    if not plain and not first.free_symbols and not second.free_symbols:
        # The angle with the line of centres, but with the wall itself.
        wall = work.model.story.walls.get(frame.wall or "")
        to_wall = wall is not None and wall.centre is None
        opposite, adjacent = (first, second) if to_wall else (second, first)
        degrees = float(sp.N(sp.atan2(abs(opposite), abs(adjacent)) * 180 / sp.pi, 20))
        nearest = round(degrees / 15) * 15
        share = sp.cos(nearest * sp.pi / 180) ** 2
        if abs(degrees - nearest) < 1 and work.model.decide(adjacent**2, "=", share):
            angle = lay.Degrees(Number(str(nearest)))
            functions = ("sin", "cos") if to_wall else ("cos", "sin")
            laid, other = (lay.product(look(size), lay.function(each, angle)) for each in functions)
            return (
                lay.negative(laid) if sp.N(first) < 0 else laid,
                lay.negative(other) if sp.N(second) < 0 else other,
            )
    if frame.axis is not None:
        return None
    sign = -1 if frame.wall is not None else 1
    return _scalar(u, frame.n * sign), _scalar(u, frame.t)


def _surd(value: sp.Expr) -> bool:
    return any(
        isinstance(node, sp.Pow) and node.exp == sp.S.Half and not node.base.free_symbols
        for node in sp.preorder_traversal(value)
    )


def _scalar(u: Vector, n: Vector) -> Layout:
    """``(6**i** − 5**j**)·(3**i** + 4**j**)/5``."""
    x, y = sp.sympify(n.x, strict=True), sp.sympify(n.y, strict=True)
    ratio = tidy(sp.radsimp(y / x)) if x != 0 else None
    if isinstance(ratio, sp.Rational):
        sign = 1 if sp.N(x) > 0 else -1
        way = (sign * ratio.q, sign * ratio.p)
        size = tidy(sp.sqrt(sp.Integer(way[0] ** 2 + way[1] ** 2)))
        return printed("a/s", a=scalar_product(tuple(u), way), s=size)
    return scalar_product(tuple(u), tuple(n))


def line_of_centres(work: Working, frame: Frame) -> None:
    """How the line of centres, or the normal of a wall, comes to be known."""
    happening = work.model.happening(frame.number)
    step = happening.step
    assert isinstance(step, Impact)
    story = work.model.story
    if frame.angle is not None:
        axis, angle = Bold("i"), look(frame.angle)
        sentence = (
            say("let.line-angle", axis=axis, angle=angle)
            if frame.wall is None
            else say("let.wall-angle", wall=frame.wall, axis=axis, angle=angle)
        )
        work.write("setting", sentences=(sentence,))
        return
    if frame.wall is not None:
        wall = story.walls[frame.wall]
        if wall.centre is not None:
            work.write(
                "principle",
                sentences=(
                    say(
                        "line.radius",
                        wall=frame.wall,
                        way=direction_words(frame.n.x, frame.n.y),
                    ),
                ),
            )
        else:
            known = {step.first: given_after(work, step.first, frame.number)}
            if _told_directly(work, frame, known):
                return
            how = _better(work, known, frame.number)
            _by_change(work, frame, *how)
        return
    if step.offset is not None:
        _by_offset(work, frame, step)
        return
    if step.along is not None:
        angle = story.evaluator(frame.number - 1).value(step.along)
        if not isinstance(angle, Vector) and isinstance(angle, sp.Expr):
            given = look(work.put(angle), angle=True)
            sentence = say("line.angle", angle=given, axis=Bold("i"))
            work.write("setting", sentences=(sentence,))
            return
        x, y = work.put(frame.n)
        way = direction_words(x, y)
        work.write("setting", sentences=(say("line.direction", way=way),))
        return
    places = [
        work.model.branch.story.place(name, frame.number) for name in (step.first, step.second)
    ]
    if all(places) and not work.model.seeks_line(frame.number):
        one, other = (Vector(tidy(p[0].x), tidy(p[0].y)) for p in places if p is not None)
        work.write(
            "principle",
            [
                chain(
                    side(
                        (tidy(other.x - one.x), tidy(other.y - one.y)),
                        printed("s - r", s=Bold("r", step.second), r=Bold("r", step.first)),
                    ),
                    side(
                        (other.x - one.x, other.y - one.y),
                        printed("s - r", s=tuple(other), r=tuple(one)),
                    ),
                    side((tidy(other.x - one.x), tidy(other.y - one.y))),
                )
            ],
            sentences=(say("joins-centres.places"),),
        )
        return
    known = {name: given_after(work, name, frame.number) for name in (step.first, step.second)}
    if _told_directly(work, frame, known):
        return
    _by_change(work, frame, *_better(work, known, frame.number))


def given_after(work: Working, body: str, number: int) -> frozenset[str]:
    """What the facts tell of a sphere just after an impact: ``velocity``, ``speed``, …"""
    story = work.model.story
    found: set[str] = set()
    for given, now in givens(work.model.problem, work.model.part):
        for relation in given.relations:
            trees: tuple[Expression, ...]
            if isinstance(relation, AtRest):
                latest = story.latest(body, now)
                if relation.body.name == body and latest and latest.number == number:
                    found.add("velocity")
                continue
            if isinstance(relation, Compare) and "=" in relation.operators:
                trees = relation.operands
            elif isinstance(relation, Aligned) and relation.relation != "perpendicular to":
                # The direction of an impulse is all that is wanted of it; of a velocity it is not.
                trees = tuple(
                    each
                    for each in (relation.left, relation.right)
                    if isinstance(each, Quantity) and each.kind == "impulse"
                )
            else:
                continue
            for tree in trees:
                if not isinstance(tree, Quantity) or not tree.arguments:
                    continue
                name = tree.arguments[0]
                if not isinstance(name, Name) or name.name != body:
                    continue
                if tree.kind in ("deflection", "impulse"):
                    when = event_of(story, tree, now, body).number
                else:
                    latest = story.latest(body, stage_number(story, tree, now, body))
                    when = latest.number if latest is not None else 0
                if when == number:
                    found.add(tree.kind)
    return frozenset(found)


def _better(
    work: Working, known: Mapping[str, frozenset[str]], number: int
) -> tuple[str, Literal["given", "made", "still", "open"]]:
    """The sphere by whose change of velocity the line is found, and how that change is known."""
    final = work.model.branch.story

    def cost(name: str) -> tuple[int, int]:
        v, u = final.velocity(name, number), final.velocity(name, number - 1)
        told = known[name]
        turned = bool(told & {"deflection", "direction"})
        still = (u.x, u.y) == (0, 0)
        how = 3
        if "velocity" in told or (still and turned):
            how = 0 if still else 1
        elif "speed" in told and turned:
            how = 2
        return how, int(sum(sp.count_ops(x) for x in (*v, *u)))

    name = min(known, key=cost)
    how = cost(name)[0]
    return name, ("still", "given", "made", "open")[how]


def to_be_found(work: Working, frame: Frame) -> bool:
    """Whether a line of centres, or a wall, follows from nothing but all the equations at once."""
    step = work.model.happening(frame.number).step
    if not frame.by_values or not isinstance(step, Impact):
        return False
    wall = work.model.story.walls.get(frame.wall or "")
    if step.offset is not None or step.along is not None or (wall and wall.centre is not None):
        return False
    bodies = work.model.spheres(frame.number)
    places = [work.model.branch.story.place(name, frame.number) for name in bodies]
    sought = work.model.seeks_line(frame.number)
    if wall is None and all(places) and not sought:
        return False
    known = {name: given_after(work, name, frame.number) for name in bodies}
    if _direct(work, frame, known) is not None:
        return False
    return _better(work, known, frame.number)[1] == "open"


def _direct(
    work: Working, frame: Frame, known: Mapping[str, frozenset[str]]
) -> str | Relation | None:
    """The sphere whose impulse tells the line, or the fact that does."""
    for name, kinds in known.items():
        if "impulse" in kinds:
            return name
    return next(
        (
            relation
            for given, now in givens(work.model.problem, work.model.part)
            for relation in given.relations
            if _of_the_line(work, frame, relation, now)
        ),
        None,
    )


def _told_directly(work: Working, frame: Frame, known: Mapping[str, frozenset[str]]) -> bool:
    """Writes how the data tell a line of centres, or a wall, without what comes after."""
    direct = _direct(work, frame, known)
    if isinstance(direct, str):
        _by_impulse(work, frame, direct)
    elif direct is not None:
        fact, way = _fact(work, direct), _way(frame)
        sentence = (
            say("given.line", fact=fact, way=way)
            if frame.wall is None
            else say("given.wall", fact=fact, wall=frame.wall, way=way)
        )
        work.write(
            "setting",
            sentences=(sentence,),
            points=(B1,),
        )
    return direct is not None


def _of_the_line(work: Working, frame: Frame, relation: Relation, now: int) -> bool:
    """Whether a fact speaks of the line itself and of nothing that comes after the impact."""
    if isinstance(relation, Compare) and "=" not in relation.operators:
        return False
    nodes = [node for tree in trees_of_relation(relation) for node in walk(tree)]
    if frame.wall is not None:
        spoken = any(isinstance(node, Name) and node.name == frame.wall for node in nodes)
    else:
        spoken = any(isinstance(n, Quantity) and n.kind == "line_of_centres" for n in nodes)
    story = work.model.story
    later = any(
        isinstance(node, Quantity)
        and node.kind not in ("line_of_centres", "angle", "direction")
        and not (node.kind == "velocity" and stage_number(story, node, now, None) < frame.number)
        for node in nodes
    )
    return spoken and not later


def _fact(work: Working, relation: Relation) -> Sentence | Layout:
    if isinstance(relation, Aligned):
        return work.aligned(relation)
    assert isinstance(relation, Compare)
    signs = tuple(lay.SIGNS.get(op, op) for op in relation.operators)
    return lay.Relation(tuple(work.layout(each) for each in relation.operands), signs)


def _way(frame: Frame) -> Layout:
    along = frame.n if frame.wall is None else frame.t
    return direction_words(along.x, along.y)


def _by_impulse(work: Working, frame: Frame, body: str) -> None:
    """An impulse whose direction is given acts along the line of centres."""
    event = work.model.branch.story.happenings[frame.number - 1]
    assert event.impulse is not None
    assert isinstance(event.step, Impact)
    sign = 1 if body == event.step.second else -1
    push = work.put(event.impulse * sign)
    parallel, way = direction_words(push.x, push.y), _way(frame)
    sentence = (
        say("impulse-line.parallel", body=body, impulse=parallel, way=way)
        if frame.wall is None
        else say("impulse-normal.parallel", body=body, wall=frame.wall, impulse=parallel, way=way)
    )
    work.write("principle", sentences=(sentence,), points=(M1, A1))


def _by_change(
    work: Working,
    frame: Frame,
    body: str,
    how: Literal["given", "made", "still", "open"],
) -> None:
    """The change of a sphere's velocity is parallel to the impulse."""
    final = work.model.branch.story
    v, u = (final.velocity(body, frame.number - k) for k in (0, 1))
    v, u = Vector(tidy(v.x), tidy(v.y)), Vector(tidy(u.x), tidy(u.y))
    change = Vector(tidy(v.x - u.x), tidy(v.y - u.y))
    if how == "open":
        _line_together(work, frame)
        return
    if how == "made":
        work.write(
            "fact",
            [chain(side((v.x, v.y), Bold("v", body)), side((v.x, v.y)), points=(M1,))],
            sentences=(say("given.velocity", body=body),),
        )
    row = chain(
        side(
            (change.x, change.y),
            operand(say("operand.change", body=body)),
        ),
        side(
            (change.x, change.y),
            printed("v - u", v=tuple(v), u=tuple(u)),
        ),
        side((change.x, change.y)),
        points=(M1,),
    )
    if how == "still":
        way = direction_words(*(frame.n if work.sign(v.dot(frame.n)) > 0 else -frame.n))
        moves_off = say("moves-off.line", body=body, way=way)
        work.write("principle", sentences=(moves_off,), points=(M1,))
        return
    along = direction_words(frame.n.x, frame.n.y)
    if frame.wall is None:
        changes = say("impulse-line.change", body=body)
        so = say("line.so", way=along)
    else:
        changes = say("impulse-normal.change", body=body, wall=frame.wall)
        way = direction_words(frame.t.x, frame.t.y)
        so = say("line.wall", wall=frame.wall, normal=along, way=way)
    work.write("principle", [row], sentences=(changes,))
    work.write("setting", sentences=(so,), points=(A1,))


def _line_together(work: Working, frame: Frame) -> None:
    """A line of centres, or a wall, that follows from all the equations at once."""
    way = _way(frame)
    sentence = (
        say("line.together", way=way)
        if frame.wall is None
        else say("line.wall-together", wall=frame.wall, way=way)
    )
    work.write("setting", sentences=(sentence,), points=(M1, A1))


def _size_of(work: Working, offset: Expression) -> Layout:
    """An offset as it was written, without its sign."""
    return work.layout(offset.operand if isinstance(offset, Negate) else offset)


def _by_offset(work: Working, frame: Frame, step: Impact) -> None:
    """Sin θ = d/2r for the angle θ between the line of centres and the relative path."""
    story = work.model.story
    assert step.offset is not None
    raw = story.evaluator(frame.number - 1).scalar(step.offset)
    r = story.radius(step.first)
    if r is None:
        return
    d = work.put(raw)
    happening = work.model.happening(frame.number)
    theta = angle_letter(work)
    d = d if work.sign(d) >= 0 else tidy(-d)
    ratio = tidy(d / (2 * work.put(r)))
    cosine = tidy(work.resolved(sp.sqrt(tidy(1 - ratio**2))))
    rows = [
        chain(
            shown(lay.function("sin", theta)),
            side(ratio, printed("d/s", d=_size_of(work, step.offset), s=tidy(2 * work.put(r)))),
            side(ratio),
            points=(M1,),
        ),
        chain(shown(lay.function("cos", theta)), side(cosine), points=(A1,)),
    ]
    still = happening.before[step.second]
    sentence = say("offset.path", angle=theta, body=step.first)
    if not (story.field.is_zero(still.x) and story.field.is_zero(still.y)):
        sentence = say("offset.relative-path", angle=theta, body=step.first, other=step.second)
    work.write("principle", rows, sentences=(sentence,))
