"""From what is asked to steps: one item of ``find`` or one ``show`` after another."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import sympy as sp

from restitution.components import Model
from restitution.errors import ImpossibleError
from restitution.exact import tidy
from restitution.explain.marks import without_method
from restitution.explain.phrases import answer, chain
from restitution.explain.quantities import (
    WHOLE,
    Asked,
    _laid,
    derive,
    evaluated,
    inside,
    name_of,
    put_in,
    quantities_in,
    stage_of,
)
from restitution.explain.steps import REQUIRED, Origin, Row, Side, shown, side
from restitution.explaining.marks import A1, A1_STAR, M1
from restitution.explaining.printing import look, printed, scalar_product
from restitution.explaining.saying import Sentence, say
from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    AtTime,
    Expression,
    Letter,
    Name,
    Quantity,
    has_quantity,
    walk,
)
from restitution.oracle import BeyondError, Formula, Oracle
from restitution.oracle import Relation as Claim
from restitution.problem import (
    Aligned,
    AtRest,
    Compare,
    Extremum,
    Find,
    Given,
    Kick,
    Meets,
    Part,
    Problem,
    Range,
    Relation,
    Show,
    Value,
    trees_of_relation,
)
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.solve.quantities import event_of
from restitution.solve.solution import Answer, ItemResult
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.explain.working import Working


def trees_of(item: Any) -> list[Expression]:
    """The expressions of an item."""
    if isinstance(item, Show):
        found = list(trees_of_relation(item.relation))
        if item.subject is not None:
            found.append(item.subject.expression)
        return found
    return [item.expression]


def speaks_across(problem: Problem, part: Part) -> bool:
    """Whether anything asked or given rests on more than components along lines of centres."""
    pending: list[Expression] = []
    for step, _, _ in problem.timeline(part):
        if isinstance(step, Given):
            for relation in step.relations:
                pending += trees_of_relation(relation)
                if isinstance(relation, Aligned):
                    return True
        elif isinstance(step, Find | Show):
            if isinstance(step, Show) and isinstance(step.relation, Aligned):
                return True
            items = step.items if isinstance(step, Find) else (step,)
            for item in items:
                pending += trees_of(item)
    for tree in pending:
        for node in walk(tree):
            if not isinstance(node, Quantity) or node.kind not in WHOLE:
                continue
            if node.kind == "energy" or node.stage != 0:
                return True
    return False


def explain_item(work: Working, result: ItemResult, now: int, number: int) -> None:
    """Writes the working of one item, for one solution."""
    if result.error is not None:
        message = result.error.message
        # What leads to it; of several solutions, none of which can be, that would be too much.
        impossible = isinstance(result.error, ImpossibleError) and not work.alternatives
        if impossible and isinstance(result.item, Value):
            prepare(work, result.item.expression, now)
        work.write("note", sentences=(say("answer.none", item=result.text, reason=message),))
        return
    item = result.item
    mine = [a for a in result.answers if a.solution == number] or list(result.answers)
    answer_ = mine[0] if mine else None
    if isinstance(item, Value) and answer_ is not None:
        _value(work, item, answer_, now)
    elif isinstance(item, Range) and answer_ is not None:
        from restitution.explain.bounds import explain_range

        explain_range(work, item.expression, mine, now)
    elif isinstance(item, Extremum) and answer_ is not None:
        from restitution.explain.bounds import explain_extremum

        explain_extremum(work, item, answer_, now)
    elif isinstance(item, Show):
        _show(work, item, result, now)
    by_case = isinstance(item, Range) and len(mine) > 1  # each stands with its condition
    if answer_ is not None and answer_.condition_layout is not None and not by_case:
        condition = answer_.condition_layout
        reasons = coefficients_that_bind(work.model, work.known)
        sentence = (
            say("answer.only-as", reasons=reasons, condition=condition)
            if reasons and condition not in reasons
            else say("answer.only", condition=condition)
        )
        work.write("note", sentences=(sentence,))


def coefficients_that_bind(model: Model, found: Collection[sp.Symbol]) -> list[Layout]:
    """``e ≤ 1``: the bounds of coefficients that were found, if a solution's condition is theirs.

    Empty where it rests on anything else, or on a coefficient that is not yet known.
    """
    if model.branch.oracle is None:
        return []
    bounds: dict[tuple[sp.Symbol, bool], Formula] = {}
    for symbol, value in model.final.items():
        role = model.unknowns.roles.get(symbol.name)
        if role is None or role.kind != "restitution" or (role.low, role.high) != (0, 1):
            continue
        for upper, gap in ((False, value), (True, 1 - value)):
            claim = Claim(gap, ">=" if role.closed[upper] else ">")
            if not _follows(model.ground, claim):
                bounds[symbol, upper] = claim
    for each in list(bounds):
        fewer = {key: claim for key, claim in bounds.items() if key != each}
        if all(_follows(model.ground.with_facts(fewer.values()), x) for x in model.oracle.facts):
            bounds = fewer
    known = all(symbol in found for symbol, _ in bounds)
    enough = model.ground.with_facts(bounds.values())
    if not bounds or not known or not all(_follows(enough, each) for each in model.oracle.facts):
        return []
    return [_coefficient_range(model, s, bounds) for s in dict.fromkeys(s for s, _ in bounds)]


def _follows(oracle: Oracle, claim: Formula) -> bool:
    try:
        return bool(oracle.decide(claim))
    except BeyondError:
        return False


def _coefficient_range(
    model: Model, symbol: sp.Symbol, bounds: Collection[tuple[sp.Symbol, bool]]
) -> Layout:
    """``0 ≤ e``, ``e ≤ 1`` or both at once."""
    at_low, at_high = (
        "≤" if closed else "<" for closed in model.unknowns.roles[symbol.name].closed
    )
    name, low, high = look(symbol), lay.Number("0"), lay.Number("1")
    if (symbol, True) not in bounds:
        return lay.Relation((name, low), ("≥" if at_low == "≤" else ">",))
    if (symbol, False) not in bounds:
        return lay.Relation((name, high), (at_high,))
    return lay.Relation((low, name, high), (at_low, at_high))


# --- values --------------------------------------------------------------------------------------


def prepare(work: Working, tree: Expression, now: int) -> None:
    """Everything on which a tree rests."""
    asked = quantities_in(work, tree, now)
    for each in asked:
        _events_of(work, each.tree, each.now)
    work.reach(inside(work, tree, now))
    for each in asked:
        _settings_of(work, each.tree, each.now)


def _events_of(work: Working, tree: Quantity, now: int) -> None:
    """Blows that came before the quantity is taken."""
    from restitution.explain.blows import kick

    body = name_of(tree)
    story = work.model.story
    if isinstance(tree.stage, int):
        upto = tree.stage
    elif tree.stage == "before":
        upto = stage_of(work, tree, now, body)
    else:
        upto = now
    for event in story.happenings[:upto]:
        if isinstance(event.step, Kick) and (body is None or body == event.step.body):
            kick(work, event.number)
    for argument in tree.arguments:
        for inner in quantities_in(work, argument, now):
            _events_of(work, inner.tree, inner.now)


def _settings_of(work: Working, tree: Quantity, now: int) -> None:
    """The axes of the impact that a quantity speaks of, even if nothing had to be found."""
    story = work.model.story
    body = name_of(tree)
    if tree.kind == "direction" and body in story.walls:
        for number, frame in work.model.frames.items():
            if frame.wall == body and frame.by_values:
                work.setting(number)
                break
    if tree.kind in ("line_of_centres",) and work.model.frames:
        event = event_of(story, tree, now)
        if event.number in work.model.frames:
            frame = work.model.frames[event.number]
            if frame.by_values or frame.axis is None:
                work.setting(event.number)
    if body in story.spheres and tree.kind in ("velocity", "speed", "direction", "deflection"):
        stage = stage_of(work, tree, now, body) if tree.kind != "deflection" else now
        latest = story.latest(body, stage) if stage else None
        if latest is not None and latest.number in work.model.frames:
            work.setting(latest.number)
    for argument in tree.arguments:
        for inner in quantities_in(work, argument, now):
            _settings_of(work, inner.tree, inner.now)


def _value(work: Working, item: Value, answer_: Answer, now: int) -> None:
    tree = item.expression
    key = ("item", str(item.text), now)
    if key in work.done:
        return
    work.done.add(key)
    prepare(work, tree, now)
    found = answer_.value
    if isinstance(tree, Quantity):
        derived = derive(work, tree, now, percentage=item.percentage)
        rows = _ending(work, derived.rows, work.layout(tree), derived.value, answer_, item)
        rows = _once(work, tree, rows)
        uses = found_before(work, tree, now)
        work.write("result", rows, derived.title, derived.sentences, uses=uses)
        return
    for quantity in quantities_in(work, tree, now):
        sub_result(work, quantity)
    _final(work, tree, found, answer_, now, item.percentage)


def found_before(work: Working, tree: Expression, now: int) -> dict[str, Origin]:
    """The values on which a tree rests that had to be found."""
    body = name_of(tree) if isinstance(tree, Quantity) else None
    event = None
    timed = isinstance(tree, Quantity) and isinstance(tree.stage, AtTime)
    if isinstance(tree, Quantity) and body in work.model.story.spheres and not timed:
        latest = work.model.story.latest(body, stage_of(work, tree, now, body))
        event = latest.number if latest is not None else None
    value = work.value(tree, now)
    return work.uses((value.x, value.y) if isinstance(value, Angle) else value, event)


def _once(work: Working, tree: Quantity, rows: list[Row]) -> list[Row]:
    """The same method for another body earns no second M."""
    key = ("method", tree.kind)
    if tree.kind not in ("speed", "energy", "momentum") or not rows or M1 not in rows[-1].points:
        return rows
    if key in work.done:
        rows = [*rows[:-1], replace(rows[-1], points=without_method(rows[-1].points))]
    work.done.add(key)
    return rows


def _same(work: Working, a: Any, b: Any) -> bool:
    if isinstance(a, tuple) or isinstance(b, tuple):
        return (
            isinstance(a, tuple)
            and isinstance(b, tuple)
            and all(_same(work, x, y) for x, y in zip(a, b, strict=True))
        )
    return work.model.sign(sp.sympify(a, strict=True) - sp.sympify(b, strict=True)) == 0


def _ending(
    work: Working,
    rows: tuple[Row, ...],
    name: Layout,
    value: Any,
    answer_: Answer,
    item: Value,
) -> list[Row]:
    """The rows, with the solution's own form of the result where it looks different."""
    made = list(rows)
    target = answer_.value
    if isinstance(item.expression, Quantity) and item.expression.kind in ("position", "time"):
        return made
    if isinstance(target, sp.Set) or not _same(work, target, value):
        return made
    wanted = look(tuple(target) if isinstance(target, tuple) else target, angle=answer_.angle)
    shown_ = {operand for row in made for operand in row.operands}
    if wanted in shown_ or any(
        side_.layout in shown_
        for side_ in answer(
            tuple(target) if isinstance(target, tuple) else target,
            angle=answer_.angle,
            percentage=item.percentage,
        )
    ):
        return made
    pair = tuple(target) if isinstance(target, tuple) else target
    ending = answer(pair, angle=answer_.angle, percentage=item.percentage)
    if not made and _stated(work, name, ending):
        return made  # an impulse from outside has told it
    made.append(chain(Side(name, pair), *ending, points=(A1,)))
    return made


def sub_result(work: Working, asked: Asked) -> None:
    """A quantity inside an expression: derived once, then known."""
    tree, now = asked.tree, asked.now
    key = ("quantity", tree, now if tree.stage is None else None)
    if key in work.done:
        return
    work.done.add(key)
    if tree.kind in ("mass", "speed", "line_of_centres") and tree.stage == 0:
        return
    derived = derive(
        work, tree, now, name=work.layout(asked.letter) if asked.letter is not None else None
    )
    if not derived.rows:
        return
    uses = found_before(work, tree, now)
    work.write("result", derived.rows, derived.title, derived.sentences, uses=uses)


def _final(
    work: Working, tree: Expression, found: Any, answer_: Answer, now: int, percentage: bool
) -> None:
    value = tuple(found) if isinstance(found, tuple) else found
    ending = answer(value, angle=answer_.angle, percentage=percentage)
    name = work.layout(tree)
    if _stated(work, name, ending):
        return
    if not quantities_in(work, tree, now):
        if isinstance(tree, Letter) and _stated(work, look(name), ending):
            return
        last = work.steps[-1] if work.steps else None
        if last is not None and last.rows and last.rows[-1].operands[0] == name:
            # The line just written says the same in another form.
            neat = chain(Side(name, value), *ending, points=(A1,))
            work.steps[-1] = replace(last, rows=(*last.rows[:-1], neat))
            return
        own = side(evaluated(work, tree, now), name)
        sides = [Side(name, own.value), *ending]
        work.write("result", [chain(*sides, points=(A1,))])
        return
    made = Side(_values_in(work, tree, now), value)
    work.write("result", [chain(Side(name, value), made, *ending, points=(A1,))])


def _values_in(work: Working, tree: Expression, now: int) -> Layout:
    """The expression with the worked-out values of its quantities."""
    from restitution.explain.quantities import _combined
    from restitution.expression.tree import Apply, Binary, Negate

    match tree:
        case Quantity():
            value = evaluated(work, tree, now)
            return look(
                value,
                angle=not isinstance(value, tuple)
                and tree.kind in ("angle", "deflection", "direction"),
            )
        case Negate(operand):
            return lay.negative(_values_in(work, operand, now))
        case Binary(op, left, right):
            return _combined(op, _values_in(work, left, now), _values_in(work, right, now))
        case Apply(function, argument) if function not in ("sqrt", "abs"):
            return lay.function(function, _values_in(work, argument, now))
    return _laid(work, tree, now)


def _stated(work: Working, name: Layout, ending: list[Side]) -> bool:
    """Whether the last lines already say so."""
    looks = {each.layout for each in ending}
    return any(
        row.alternatives or any(operand in looks for operand in row.operands[1:])
        for step in work.steps
        for row in step.rows
        if row.operands and row.operands[0] == name
    )


# --- shows ---------------------------------------------------------------------------------------


def _show(work: Working, item: Show, result: ItemResult, now: int) -> None:
    if result.holds is False:
        _refute(work, item, result, now)
        return
    if result.undecided:
        from restitution.explain.refuting import claim_of

        claim = claim_of(work, item) or say("quoted", text=result.text)
        work.write("note", sentences=(say("undecided.claim", claim=claim),))
        return
    if item.subject is not None:
        from restitution.explain.bounds import explain_shown_bound

        explain_shown_bound(work, item, result, now)
        return
    relation = item.relation
    for tree in trees_of_relation(relation):
        for quantity in quantities_in(work, tree, now):
            _events_of(work, quantity.tree, quantity.now)
    if isinstance(relation, Compare):
        _show_compare(work, relation, now)
    elif isinstance(relation, Aligned):
        _show_aligned(work, relation, now)
    elif isinstance(relation, AtRest):
        _show_rest(work, relation, now)
    elif isinstance(relation, Meets):
        from restitution.explain.bounds import explain_meets

        explain_meets(work, relation, now)


def _show_compare(work: Working, relation: Compare, now: int) -> None:
    for left, op, right in zip(
        relation.operands, relation.operators, relation.operands[1:], strict=False
    ):
        for tree in (left, right):
            prepare(work, tree, now)
        lone = isinstance(left, Quantity) and op == "=" and relation.figures is None
        if lone and not quantities_in(work, right, now):
            _show_quantity(work, left, right, now)
            continue
        for tree in (left, right):
            for quantity in quantities_in(work, tree, now):
                sub_result(work, quantity)
        a, b = evaluated(work, left, now), evaluated(work, right, now)
        if op == "=":
            _show_equal(work, left, right, a, b, now, relation.figures)
        else:
            _show_ordered(work, left, op, right, a, b, now)


def _show_equal(
    work: Working,
    left: Expression,
    right: Expression,
    a: Any,
    b: Any,
    now: int,
    figures: int | None,
) -> None:
    first, last = work.layout(left), work.layout(right)
    rows: list[Row] = []
    if figures is not None:
        exact = answer(a)
        rows.append(
            chain(
                Side(first, a),
                *exact[:1],
                shown(last),
                points=(A1_STAR,),
                asides=(say("shown.figures", figures=figures),),
            )
        )
    else:
        left_middle = Side(_values_in(work, left, now), a)
        right_middle = Side(_values_in(work, right, now), b)
        angle = not isinstance(a, tuple) and _angle_tree(work, left)
        plain_value = side(a, look(a, angle=angle))
        if quantities_in(work, right, now):
            rows.append(chain(Side(first, a), left_middle, plain_value))
            rows.append(chain(Side(last, b), right_middle, side(b, look(b, angle=angle))))
            rows.append(chain(Side(first, a), Side(last, b), points=(A1_STAR,), asides=REQUIRED))
        elif _stated(work, first, [plain_value]):
            rows.append(chain(Side(first, a), Side(last, b), points=(A1_STAR,), asides=REQUIRED))
        else:
            rows.append(
                chain(
                    Side(first, a),
                    left_middle,
                    plain_value,
                    Side(last, b),
                    points=(A1_STAR,),
                    asides=REQUIRED,
                )
            )
    work.write("result", rows)


def _show_quantity(work: Working, left: Expression, right: Expression, now: int) -> None:
    """A printed result for one quantity: its own lines, ending with what is printed."""
    assert isinstance(left, Quantity)
    derived = derive(work, left, now, last=A1_STAR)
    work.done.add(("quantity", left, now if left.stage is None else None))
    rows = list(derived.rows)
    value = derived.value
    last = Side(work.layout(right), evaluated(work, right, now))
    uses = found_before(work, left, now)
    if rows:
        final = rows[-1]
        if final.operands[0] != work.layout(left):
            rows.append(
                chain(Side(work.layout(left), value), last, points=(A1_STAR,), asides=REQUIRED)
            )
            work.write("result", rows, derived.title, derived.sentences, uses=uses)
            return
        sides = [
            Side(o, v)
            for o, v in zip(final.operands, final.values, strict=True)
            if o is not None and v is not None
        ]
        points = tuple(A1_STAR if each.kind == "A" else each for each in final.points)
        rows[-1] = chain(*sides, last, points=points, asides=REQUIRED)
    else:
        rows = [chain(Side(work.layout(left), value), last, points=(A1_STAR,), asides=REQUIRED)]
    work.write("result", rows, derived.title, derived.sentences, uses=uses)


def _angle_tree(work: Working, tree: Expression) -> bool:
    from restitution.explain.quantities import _is_angle

    return _is_angle(work, tree)


def _show_ordered(
    work: Working,
    left: Expression,
    op: str,
    right: Expression,
    a: Any,
    b: Any,
    now: int,
) -> None:
    sign = lay.SIGNS.get(op, op)
    first, last = work.layout(left), work.layout(right)
    angle = _angle_tree(work, left)
    rows: list[Row] = []
    for tree, name, value in ((left, first, a), (right, last, b)):
        found = side(value, look(value, angle=angle))
        if quantities_in(work, tree, now) and not _stated(work, name, [found]):
            rows.append(chain(Side(name, value), found))
    letters_only = not has_quantity(left) and not has_quantity(right)
    if isinstance(left, Letter) and not has_quantity(right):
        from restitution.explain.bounds import explain_conditions

        explain_conditions(work, left, now)
    if not angle:
        gap = (
            tidy(sp.sympify(b - a, strict=True))
            if op.startswith("<")
            else tidy(sp.sympify(a - b, strict=True))
        )
        big, small = (last, first) if op.startswith("<") else (first, last)
        whole = lay.Sum((("+", big), ("-", lay.bracketed(small))))
        if gap.free_symbols and not (letters_only and whole == look(gap)):
            rows.append(
                Row(
                    (
                        whole,
                        look(gap),
                        lay.Number("0"),
                    ),
                    ("=", ">" if "=" not in op else "≥"),
                    (gap, gap, sp.Integer(0)),
                    (M1,),
                )
            )
    rows.append(Row((first, last), (sign,), (a, b), (A1_STAR,), REQUIRED))
    work.write("result", rows)


def _show_aligned(work: Working, relation: Aligned, now: int) -> None:
    story = work.model.story
    ways = []
    for tree in (relation.left, relation.right):
        work.reach(work.open(tuple(story.direction(tree, now))))
        for quantity in quantities_in(work, tree, now):
            _settings_of(work, quantity.tree, quantity.now)
            if quantity.tree.kind in ("velocity", "momentum"):
                sub_result(work, quantity)
        ways.append(Vector(*work.put(story.direction(tree, now))))
    a, b = ways
    first, last = work.layout(relation.left), work.layout(relation.right)
    if relation.relation == "perpendicular to":
        products = [(x, y) for x, y in zip(a, b, strict=True) if x != 0 and y != 0]
        if products:
            total = sum((x * y for x, y in products), sp.Integer(0))
            row = chain(
                side(total, scalar_product(first, last)),
                side(total, printed("a*c + b*d", a=a.x, c=b.x, b=a.y, d=b.y)),
                side(sp.Integer(0)),
                points=(M1, A1),
            )
            work.write("result", [row], sentences=(say("product.is"),))
    else:
        pick = "x" if a.x != 0 else "y"
        if getattr(b, pick) != 0:
            ratio = tidy(getattr(a, pick) / getattr(b, pick))
            row = chain(
                side((a.x, a.y), first),
                side((a.x, a.y)),
                side((a.x, a.y), _multiple(ratio, (b.x, b.y))),
                points=(M1,),
            )
            work.write("result", [row])
    sentence = say("shown.claim", claim=work.aligned(relation))
    work.write("result", sentences=(sentence,), points=(A1_STAR,))


def _multiple(ratio: sp.Expr, vector: tuple[sp.Expr, sp.Expr]) -> Layout:
    """A vector times a number; that of −1 has only its sign."""
    if abs(ratio) == 1:
        return printed("v", v=vector) if ratio == 1 else printed("-v", v=vector)
    return printed("k*v", k=ratio, v=vector)


def _show_rest(work: Working, relation: AtRest, now: int) -> None:
    velocity = Quantity("velocity", (Name(relation.body.name),))
    prepare(work, velocity, now)
    value = evaluated(work, velocity, now)
    row = chain(side(value, work.layout(velocity)), side(value), points=(A1_STAR,))
    work.write("result", [row])
    claim = say("claim.rest", body=relation.body.name)
    work.write("result", sentences=(say("shown.claim", claim=claim),))


def _refute(work: Working, item: Show, result: ItemResult, now: int) -> None:
    """A false statement: what is true instead, and numbers that show it."""
    relation: Relation = item.relation
    if isinstance(relation, Compare) and item.subject is None:
        for tree in relation.operands:
            prepare(work, tree, now)
            for quantity in quantities_in(work, tree, now):
                sub_result(work, quantity)
    from restitution.explain.refuting import refutation

    if item.subject is not None and result.answers:
        truths: list[Layout | Sentence] = []
        for true in result.answers:
            bound = _true_bound(work, item, true)
            truths.append(
                say("refuted.reached" if true.reached else "refuted.approached", value=bound)
                if isinstance(item.subject, Extremum)
                else bound
            )
        work.write("note", sentences=(say("refuted.false", item=result.text, truths=truths),))
        return
    if item.subject is None:
        for body in work.model.story.spheres.keys() & set(_bodies(relation)):
            prepare(work, Quantity("velocity", (Name(body),)), now)
        if isinstance(relation, Aligned):
            for tree in (relation.left, relation.right):
                work.reach(work.open(tuple(work.model.story.direction(tree, now))))
    work.write("note", sentences=(refutation(work, item, result.counterexample or {}, now),))


def _bodies(relation: Relation) -> list[str]:
    """The spheres of whose motion a claim speaks that is no comparison."""
    match relation:
        case AtRest(body):
            return [body.name]
        case Meets(first, second):
            return [first.name, second.name]
    return []


def _true_bound(work: Working, item: Show, true: Answer) -> Layout:
    assert item.subject is not None
    asked = work.layout(item.subject.expression)
    if isinstance(item.subject, Range):
        return lay.display_set(true.value, asked, angle=true.angle)
    return look(true.value, angle=true.angle)


__all__ = ["explain_item", "put_in", "speaks_across", "trees_of"]
