"""The facts of a question as equations in components."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explain.geometry import angle_letter
from restitution.explain.phrases import chain
from restitution.explain.quantities import (
    components,
    name_of,
    plain,
    put_in,
    stage_of,
    tangent_of_difference,
)
from restitution.explain.steps import Row, Side, Step, side
from restitution.explain.working import Equation
from restitution.explaining.marks import A1, B1, M1, Marks
from restitution.explaining.printing import look, printed
from restitution.explaining.saying import Sentence, say
from restitution.expression.evaluate import Angle
from restitution.expression.tree import Binary, Expression, Letter, Quantity, has_quantity, letters
from restitution.problem import (
    Aligned,
    AtRest,
    Compare,
    Given,
    Impact,
    Kick,
    Part,
    Problem,
    Relation,
)
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.solve import facts as solve_facts
from restitution.solve.conditions import Equation as StoryEquation
from restitution.solve.quantities import event_of, is_line
from restitution.solve.story import Happening
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.explain.working import Working


def fact_equations(
    work: Working, problem: Problem, part: Part, protected: frozenset[str]
) -> list[Equation]:
    """All facts in force as equations, and the equations that the telling itself asks for."""
    found: list[Equation] = []
    for given, now in solve_facts.givens(problem, part):
        for relation in given.relations:
            found += _of_relation(work, relation, now, given)
    from restitution.solve.story import lets_of

    for name, (let, now) in lets_of(problem, part).items():
        if name in protected:
            relation = Compare((Letter(name), let.expression), ("=",))
            found += _of_relation(work, relation, now, None)
    found += _of_story(work)
    return [replace(each, residual=_essential(work, each.residual)) for each in found]


def _essential(work: Working, residual: sp.Expr) -> sp.Expr:
    """A product without the factors that are not zero."""
    factored = _factored(residual)
    if not factored.is_Mul:
        return residual
    kept = sp.Integer(1)
    for factor in factored.args:
        base = factor.base if factor.is_Pow else factor
        if base.free_symbols and work.model.sign(base) == 0:
            kept *= base
    return residual if kept == 1 else kept


@lru_cache(maxsize=512)
def _factored(x: sp.Expr) -> sp.Expr:
    return sp.factor_terms(x)


def _of_story(work: Working) -> list[Equation]:
    """A sphere that comes to a point it is said to come to, two that meet."""
    from restitution.explain.journeys import meeting_step

    found = []
    after = len(work.model.story.happenings) + 1
    for index, each in enumerate(work.model.story.equations):
        if each.kind != "path":
            continue

        def step(each: StoryEquation = each) -> Step | None:
            return meeting_step(work, each)

        residual = sp.sympify(each.value, strict=True)
        found.append(Equation(residual, "path", after, step, index))
    return found


def _of_relation(
    work: Working, relation: Relation, now: int, given: Given | None
) -> list[Equation]:
    place = given.place if given is not None else None
    try:
        match relation:
            case Compare():
                return _of_compare(work, relation, now)
            case Aligned() | AtRest():
                needs = solve_facts.requirements(relation, work.model.story, now, place)
                return [
                    Equation(
                        sp.sympify(need.value, strict=True),
                        "fact",
                        now,
                        _directions_step(work, relation, now, need),
                        (relation, index),
                    )
                    for index, need in enumerate(needs)
                    if isinstance(need, StoryEquation)
                ]
    except (RestitutionError, AttributeError, TypeError):
        return []
    return []


def _of_compare(work: Working, relation: Compare, now: int) -> list[Equation]:
    found: list[Equation] = []
    for left, op, right in zip(
        relation.operands, relation.operators, relation.operands[1:], strict=False
    ):
        if op != "=":
            continue
        if not has_quantity(left) and not has_quantity(right):
            found += _sum_of_angles(work, left, right, now) or _between_letters(work, left, right)
        else:
            found += _equality(work, left, right, now)
    return found


def _between_letters(work: Working, left: Expression, right: Expression) -> list[Equation]:
    """``tan α = 3/4``; ``e = 1/2`` needs no line."""
    evaluator = work.model.story.evaluator(0)
    a, b = evaluator.value(left), evaluator.value(right)
    if isinstance(a, Vector) or isinstance(b, Vector):
        return []
    a = a.measure() if isinstance(a, Angle) else a
    b = b.measure() if isinstance(b, Angle) else b
    residual = sp.sympify(a - b, strict=True)
    named = letters(left) | letters(right)
    lone = isinstance(left, Letter) or isinstance(right, Letter)

    def step() -> Step | None:
        if lone or not named <= set(work.model.unknowns.roles):
            return None
        row = chain(side(a, work.layout(left)), side(b, work.layout(right)))
        rows = [row]
        if len(named) == 1:
            (name,) = named
            symbol = work.model.unknowns.letter(name)
            if work.is_angle(symbol) and symbol in work.model.final:
                value = work.model.final[symbol]
                rows += [
                    chain(side(f(symbol)), side(tidy(f(value))))
                    for f in (sp.sin, sp.cos)
                    if not isinstance(a, f) and tidy(f(value)).is_algebraic
                ]
        return Step("setting", tuple(rows), sentences=(say("given.data"),))

    return [Equation(residual, "datum", 0, step, ("letters", str(residual)))]


def _sum_of_angles(work: Working, left: Expression, right: Expression, now: int) -> list[Equation]:
    """``α − β = arctan(1/2)``, where β names an angle of the motion: by its tangent."""
    story = work.model.story
    if not isinstance(left, Binary) or left.op not in ("+", "-") or letters(right):
        return []
    first, second = left.left, left.right
    if not (isinstance(first, Letter) and isinstance(second, Letter)):
        return []
    if not {first.name, second.name} & set(story.lets):
        return []
    evaluator = story.evaluator(now)
    a, b = evaluator.value(left), evaluator.value(right)
    if not isinstance(a, Angle) and not isinstance(b, Angle):
        return []
    need = solve_facts.equal(story, a, b, None)[0]
    assert isinstance(need, StoryEquation)

    def step() -> Step:
        tangents = [tidy(sp.tan(plain(work, evaluator.value(each)))) for each in (first, second)]
        p, q = tangents
        sign = 1 if left.op == "+" else -1
        template = "(a + b)/(1 - p)" if sign > 0 else "(a - b)/(1 + p)"
        laid = printed(template, a=p, b=q, p=tidy(p * q))
        made = side((p + sign * q) / (1 - sign * p * q), laid)
        row = _tangent_row(plain(work, b), made)
        return Step("fact", (row,), sentences=(_given(work, left, right),))

    return [Equation(sp.sympify(need.value, strict=True), "fact", now, step, (left, right, now))]


def _fact(work: Working, left: Expression, right: Expression) -> Layout:
    return lay.Relation((work.layout(left), work.layout(right)), ("=",))


def _given(work: Working, left: Expression, right: Expression) -> Sentence:
    return say("given.fact", fact=_fact(work, left, right))


def _equality(work: Working, left: Expression, right: Expression, now: int) -> list[Equation]:
    evaluator = work.model.story.evaluator(now)
    a, b = evaluator.value(left), evaluator.value(right)
    key = (left, right, now)
    if isinstance(a, Vector) or isinstance(b, Vector):
        return _vectors(work, left, right, now, evaluator.vector(left), evaluator.vector(right))
    speed = next(
        (
            (one, other, value)
            for one, other, value in ((left, right, b), (right, left, a))
            if isinstance(one, Quantity) and one.kind == "speed" and not isinstance(value, Angle)
        ),
        None,
    )
    if speed is not None:
        return [_speed(work, *speed, now)]
    if isinstance(a, Angle) or isinstance(b, Angle):
        residual = solve_facts.equal(work.model.story, a, b, None)[0]
        assert isinstance(residual, StoryEquation)
        return [
            Equation(
                sp.sympify(residual.value, strict=True),
                "fact",
                now,
                lambda: _angle_step(work, left, right, now),
                key,
            )
        ]
    residual = sp.sympify(a - b, strict=True)
    return [Equation(residual, "fact", now, lambda: _scalar_step(work, left, right, now), key)]


def _scalar_step(work: Working, left: Expression, right: Expression, now: int) -> Step:
    a, b = put_in(work, left, now), put_in(work, right, now)
    row = chain(a, b, points=(M1, A1))
    return Step("fact", (row,), sentences=(_given(work, left, right),))


def _speed(work: Working, tree: Quantity, other: Expression, value: Any, now: int) -> Equation:
    body = name_of(tree)
    assert body is not None
    stage = stage_of(work, tree, now, body)
    v = work.model.story.velocity(body, stage)
    residual = sp.sympify(v.dot(v) - sp.sympify(value, strict=True) ** 2, strict=True)
    story = work.model.story
    event = story.latest(body, stage)
    if event is not None and event.number in work.model.frames:
        u = event.before[body]
        if story.field.is_zero(u.x) and story.field.is_zero(u.y):
            along = work.model.after(event.number, body)
            return _speed_along(work, tree, other, along, value, now)

    def step() -> Step:
        a, b = components(work, body, stage)
        right = put_in(work, other, now)
        result = sp.sympify(right.value, strict=True) ** 2
        row = chain(
            side(a**2 + b**2, printed("a^2 + b^2", a=a, b=b)),
            side(
                result,
                printed("v^2", v=right.value)
                if not has_quantity(other)
                else _squared(right.layout),
            ),
            points=(M1, A1),
        )
        return Step("fact", (row,), sentences=(_given(work, tree, other),))

    return Equation(residual, "fact", now, step, (tree, other, now))


def _squared(laid: Layout) -> Layout:
    """The square of a root, or of a number of times a root, without the root."""
    two = lay.Number("2")
    if isinstance(laid, lay.Root) and laid.index == 2:
        return laid.inside
    if isinstance(laid, lay.Product) and isinstance(laid.factors[-1], lay.Root):
        inside = laid.factors[-1].inside
        outer = [lay.power(lay.bracketed(each), two) for each in laid.factors[:-1]]
        return lay.Product((*outer, lay.Brackets(inside)), laid.sign)
    return lay.power(lay.bracketed(laid), two)


def _speed_along(
    work: Working, tree: Quantity, other: Expression, w: Any, value: Any, now: int
) -> Equation:
    """A sphere that was at rest moves along the line of centres: its speed is one component."""
    w = tidy(-w) if work.model.sign(w) < 0 else w

    def step() -> Step:
        row = chain(side(work.put(w)), put_in(work, other, now), points=(B1,))
        return Step("fact", (row,), sentences=(_given(work, tree, other),))

    residual = sp.sympify(w - sp.sympify(value, strict=True), strict=True)
    return Equation(residual, "fact", now, step, (tree, other, now))


def _vectors(
    work: Working,
    left: Expression,
    right: Expression,
    now: int,
    a: Vector,
    b: Vector,
) -> list[Equation]:
    """A velocity that is given: its components along the axes of the impact."""
    body = next((name_of(t) for t in (left, right) if isinstance(t, Quantity)), None)
    gap = a - b
    frame = work.model.owner(body, now) if body is not None else None
    if frame is not None and frame.axis is None:
        residuals = [gap.dot(frame.n), gap.dot(frame.t)]
        sides = [(a.dot(d), b.dot(d)) for d in (frame.n, frame.t)]
    elif frame is not None and frame.axis == "j":
        residuals = [gap.y, gap.x]
        sides = [(a.y, b.y), (a.x, b.x)]
    else:
        residuals = [gap.x, gap.y]
        sides = [(a.x, b.x), (a.y, b.y)]
    found = []
    event = work.model.story.latest(body, now) if body is not None else None
    if event is not None and isinstance(event.step, Kick) and body is not None:
        return _after_a_blow(work, event.number, body, (left, right, now), a, b)
    for index, (residual, (one, other)) in enumerate(zip(residuals, sides, strict=True)):

        def step(one: Any = one, other: Any = other, index: int = index) -> Step:
            p, q = work.put(one), work.put(other)
            if sp.sympify(p, strict=True).is_number and not sp.sympify(q, strict=True).is_number:
                p, q = q, p
            return Step(
                "fact",
                (chain(side(p), side(q), points=(B1,) if index == 0 else ()),),
                sentences=(_given(work, left, right),),
            )

        found.append(
            Equation(
                sp.sympify(residual, strict=True), "fact", now, step, (left, right, now, index)
            )
        )
    return found


def _after_a_blow(
    work: Working, number: int, body: str, key: Any, a: Vector, b: Vector
) -> list[Equation]:
    """A velocity given after an impulse from outside: the components of the impulse."""
    event = work.model.happening(number)
    assert event.impulse is not None
    mass = work.model.story.mass(body)
    found = []
    for index, name in enumerate(("x", "y")):
        push = getattr(event.impulse, name)
        gained = mass * (
            getattr(a, name)
            + getattr(b, name)
            - getattr(event.after[body], name)
            - getattr(event.before[body], name)
        )

        def step(push: Any = push, gained: Any = gained) -> Step:
            p, q = work.put(push), work.put(gained)
            return Step(
                "fact", (chain(side(p), side(q), points=(A1,)),), sentences=(say("given.compare"),)
            )

        found.append(
            Equation(sp.sympify(push - gained, strict=True), "fact", number, step, (*key, index))
        )
    return found


def _angle_step(work: Working, left: Expression, right: Expression, now: int) -> Step:
    """An angle that is given: its tangent, or a scalar product where it is a right angle."""
    quantity, other = (left, right) if isinstance(left, Quantity) else (right, left)
    fact = _fact(work, left, right)
    both_move = has_quantity(left) and has_quantity(right)
    sentences: tuple[Sentence, ...] = (
        say("given.tangents" if both_move else "given.fact", fact=fact),
    )
    if isinstance(quantity, Quantity) and quantity.kind in ("angle", "deflection"):
        a, b = _two_directions(work, quantity, now)
        target = plain(work, work.value(other, now))
        cross, dot = work.put(a.cross(b)), work.put(a.dot(b))
        sharp = quantity.kind == "angle" and any(
            is_line(work.model.story, each) for each in quantity.arguments
        )
        if work.model.sign(dot) == 0 or sp.sympify(target, strict=True) == sp.pi / 2:
            row = _zero_dot(work, a, b)
            return Step("fact", (row,), sentences=sentences)
        cross = tidy(-cross) if work.model.sign(cross) < 0 else cross
        if sharp and work.model.sign(dot) < 0:
            dot = tidy(-dot)
        ratio = tidy(cross / dot)
        made: Layout = _ratio(cross, dot)
        ours = {c.symbol for c in work.model.components.values()}
        if sharp and sp.sympify(ratio, strict=True).free_symbols & ours:
            # The angle does not say on which side: the sign of the component is still open.
            above, below = sp.fraction(sp.together(tidy(work.resolved(ratio))))
            if above.could_extract_minus_sign():
                above = -above
            if below.could_extract_minus_sign():
                below = -below
            either = {s for s in ours if _of_either_sign(work, s)}
            both = [
                lay.Brackets(look(x), "||") if x.free_symbols & either else look(x)
                for x in (above, below)
            ]
            made = printed("a/b", a=both[0], b=both[1])
        if quantity.kind == "deflection":
            spread = tangent_of_difference(work, quantity, now)
            if spread is not None:
                intro, made = spread
                sentences = (say("given.and", fact=fact), intro)
        return Step("fact", (_tangent_row(target, side(ratio, made)),), sentences=sentences)
    if isinstance(quantity, Quantity) and quantity.kind == "direction":
        body = name_of(quantity)
        assert body is not None
        stage = stage_of(work, quantity, now, body)
        v = work.model.story.velocity(body, stage)
        x, y = work.put(v.x), work.put(v.y)
        event = work.model.story.latest(body, stage)
        before: tuple[Sentence, ...] = ()
        if event is not None and ("setting", event.number) not in work.done:
            before = _moves_off(work, event, body)
        sentences = (*before, *sentences)
        target = plain(work, work.value(other, now))
        tangent = tidy(sp.tan(target))
        idle = ("y", "j") if tangent == 0 else ("x", "i") if tangent.has(sp.zoo) else None
        if idle is not None:
            total, laid = _component_in(work, body, stage, idle[0])
            zero = say("given.component", fact=fact, axis=lay.Bold(idle[1]))
            row = chain(side(total, laid), side(sp.Integer(0)), points=(M1, A1))
            return Step("fact", (row,), sentences=(*before, zero))
        if x != 0:
            row = _tangent_row(target, side(tidy(y / x), _ratio(y, x)))
            return Step("fact", (row,), sentences=sentences)
    a_, b_ = put_in(work, left, now), put_in(work, right, now)
    tangents = [side(tidy(sp.tan(sp.sympify(each.value, strict=True)))) for each in (a_, b_)]
    if not any(each.value.has(sp.zoo, sp.nan) for each in tangents):
        return Step("fact", (chain(*tangents, points=(M1,)),), sentences=sentences)
    return Step("fact", (chain(a_, b_, points=(M1,)),), sentences=sentences)


def _of_either_sign(work: Working, symbol: sp.Symbol) -> bool:
    """Whether a component may be negative: not away from a wall, nor of what was at rest."""
    story = work.model.story
    for (number, body), each in work.model.components.items():
        if each.symbol == symbol:
            u = work.model.happening(number).before[body]
            still = story.field.is_zero(u.x) and story.field.is_zero(u.y)
            return work.model.frames[number].wall is None and not still
    return False


def _component_in(work: Working, body: str, stage: int, name: str) -> tuple[sp.Expr, Layout]:
    """The component of a velocity in the direction of an axis, by those of its latest impact."""
    v = work.model.story.velocity(body, stage)
    frame = work.model.owner(body, stage)
    if frame is None or frame.axis is not None:
        value = work.put(getattr(v, name))
        return value, look(value)
    a, b = work.put(v.dot(frame.n)), work.put(v.dot(frame.t))
    pairs = [(a, work.put(getattr(frame.n, name))), (b, work.put(getattr(frame.t, name)))]
    total = sum((p * q for p, q in pairs), sp.Integer(0))
    (p, q), (r, s) = pairs
    return total, printed("p*q + r*s", p=p, q=q, r=r, s=s)


def _moves_off(work: Working, event: Happening, body: str) -> tuple[Sentence, ...]:
    """Why the direction of a sphere that was at rest tells the line of centres."""
    u = event.before[body]
    still = work.model.story.field.is_zero(u.x) and work.model.story.field.is_zero(u.y)
    if not still or not isinstance(event.step, Impact) or event.step.offset is None:
        return ()
    theta = angle_letter(work)
    r = work.model.story.radius(body)
    ratio = printed("d/s", d=work.layout(event.step.offset), s=tidy(2 * work.put(r)))
    sine = lay.equation(lay.function("sin", theta), ratio)
    return (say("line.offset", body=body, angle=theta, sine=sine),)


def _tangent_row(target: sp.Expr, made: Side) -> Row:
    """``(3 tan α)/(1 + 4 tan²α) = tan 30° = 1/√3``."""
    tangent = tidy(sp.tan(target))
    sides = [made]
    if not target.has(sp.atan, sp.acos, sp.asin):
        sides.append(side(tangent, lay.function("tan", look(target, angle=True))))
    sides.append(side(tangent))
    return chain(*sides, points=(M1, A1))


def _ratio(above: sp.Expr, below: sp.Expr) -> Layout:
    first, second = look(above), look(below)
    if isinstance(first, lay.Fraction) or isinstance(second, lay.Fraction):
        return look(tidy(above / below))
    common = tidy(above / below)
    if look(common) != first and sp.count_ops(common) < sp.count_ops(above):
        return look(common)
    return printed("a/b", a=first, b=second)


def _two_directions(work: Working, tree: Quantity, now: int) -> tuple[Vector, Vector]:
    story = work.model.story
    if tree.kind == "deflection":
        body = name_of(tree)
        event = event_of(story, tree, now, body)
        assert body is not None
        return event.before[body], event.after[body]
    a, b = (story.direction(each, now) for each in tree.arguments)
    return a, b


def _zero_dot(work: Working, a: Vector, b: Vector, points: Marks = (M1, A1)) -> Row:
    a, b = work.put(a), work.put(b)
    products = [(x, y) for x, y in zip(a, b, strict=True) if x != 0 and y != 0]
    total = sum((x * y for x, y in products), sp.Integer(0))
    if len(products) == 1:
        # One of the two is zero.
        total = next((x for x in products[0] if work.model.sign(x) == 0), total)
        return chain(side(total), side(sp.Integer(0)), points=points)
    laid = printed("a*c + b*d", a=a.x, c=b.x, b=a.y, d=b.y)
    return chain(side(total, laid), side(sp.Integer(0)), points=points)


def _component_row(work: Working, relation: Aligned, now: int, need: StoryEquation) -> Row:
    """A velocity along an axis has no component across it; what that component is made of."""
    for tree in (relation.left, relation.right):
        body = name_of(tree)
        if not isinstance(tree, Quantity) or tree.kind != "velocity" or body is None:
            continue
        stage = stage_of(work, tree, now, body)
        frame = work.model.owner(body, stage)
        if frame is None or frame.axis is not None or frame.by_values:
            continue
        for name in ("x", "y"):
            total, laid = _component_in(work, body, stage, name)
            if work.model.sign(total) == 0:
                return chain(side(total, laid), side(sp.Integer(0)), points=(M1, A1))
    residual = work.numerator(need.value)
    return chain(side(tidy(residual)), side(sp.Integer(0)), points=(M1,))


def _directions_step(work: Working, relation: Relation, now: int, need: StoryEquation) -> Any:
    def step() -> Step | None:
        if isinstance(relation, AtRest):
            residual = work.put(need.value)
            return Step(
                "fact",
                (chain(side(residual), side(sp.Integer(0)), points=(B1,)),),
                sentences=(say("given.rest", body=relation.body.name),),
            )
        assert isinstance(relation, Aligned)
        story = work.model.story
        a, b = story.direction(relation.left, now), story.direction(relation.right, now)
        fact = work.aligned(relation)
        x, y = work.put(b)
        single = x == 0 or y == 0
        if relation.relation == "perpendicular to":
            p, q = work.put(a)
            single = single or p == 0 or q == 0
            if single:
                row = _component_row(work, relation, now, need)
                return Step("fact", (row,), sentences=(say("given.fact", fact=fact),))
            zero = say("given.product", fact=fact)
            return Step("fact", (_zero_dot(work, a, b),), sentences=(zero,))
        if single:
            row = _component_row(work, relation, now, need)
            return Step("fact", (row,), sentences=(say("given.fact", fact=fact),))
        a, b = work.put(a), work.put(b)
        row = chain(
            side(tidy(a.x * b.y), printed("a*b", a=a.x, b=b.y, front=True)),
            side(tidy(a.y * b.x), printed("a*b", a=a.y, b=b.x, front=True)),
            points=(M1, A1),
        )
        return Step("fact", (row,), sentences=(say("given.proportion", fact=fact),))

    return step


__all__ = ["fact_equations"]
