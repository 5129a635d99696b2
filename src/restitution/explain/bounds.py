"""Ranges, extrema and inequalities: the conditions that bound, and where a greatest value lies."""

from __future__ import annotations

from collections.abc import Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from fractions import Fraction
from typing import TYPE_CHECKING, Any, Literal

import sympy as sp

from restitution.components import proved_sign
from restitution.errors import RestitutionError
from restitution.exact import tidy, tidy_angle
from restitution.explain.asked import found_before, prepare, sub_result
from restitution.explain.checking import related
from restitution.explain.kept import above, factored, simplified
from restitution.explain.phrases import answer, chain
from restitution.explain.quantities import derive, evaluated, put_in, quantities_in
from restitution.explain.steps import REQUIRED, Row, Side, side
from restitution.explain.working import TANGENT, by_tangent
from restitution.explaining.marks import A1, A1_STAR, DM1, M1, Marks
from restitution.explaining.printing import look, printed
from restitution.explaining.saying import Sentence, operand, say
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Angle
from restitution.expression.tree import Degrees, Expression, Letter, Name, Quantity, has_quantity
from restitution.oracle import BeyondError, Formula, compared
from restitution.oracle import Relation as Claim
from restitution.oracle.roles import Role
from restitution.problem import Aligned, Compare, Extremum, Impact, Meets, Range, Relation, Show
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.solve import algebra, forms
from restitution.solve import facts as solve_facts
from restitution.solve.conditions import AnyOf, Condition
from restitution.solve.numbers import at
from restitution.solve.solution import Answer, ItemResult

if TYPE_CHECKING:
    from restitution.explain.working import Working

_STEP = 1e-12
_PLAIN = {"≤": "<=", "≥": ">=", "≠": "!="}
_SIGNS = {">": ">", ">=": "≥", "!=": "≠"}
_FLIPPED = {">": "<", "≥": "≤", "<": ">", "≤": "≥", "≠": "≠"}


@dataclass(frozen=True)
class Bound:
    """A condition that excludes something: ``left`` and ``right`` as first written."""

    sentence: Sentence
    left: Any
    sign: str
    right: Any
    value: sp.Expr  # left − right, or what has to be positive
    asks: str  # the sign that ``value`` has to have against 0
    bare: bool = False  # written at once without the factors that are positive anyway
    among: Literal["alone", "all", "any"] = "alone"  # of several, all or any of which must hold


# --- what is proved -----------------------------------------------------------------------------


def _ever_fails(work: Working, value: sp.Expr, asks: str, told: Sequence[Formula] = ()) -> bool:
    """Whether a condition is not proved for all that its letters may be.

    That is what their roles say, and the conditions told before.
    """
    oracle = work.model.ground.with_facts(told) if told else work.model.ground
    try:
        return not all(oracle.decide(each) for each in _claims(value, asks))
    except BeyondError:
        return True


def _claims(value: sp.Expr, asks: str) -> list[Formula]:
    """A condition, and that it has a value."""
    return [*_real(value), compared(value, _PLAIN.get(asks, asks), sp.Integer(0))]


def _real(value: sp.Expr) -> list[Formula]:
    """What makes an expression a real number: of what is under roots, and of divisors."""
    found: list[Formula] = []
    for node in sp.preorder_traversal(value):
        if isinstance(node, sp.Pow) and node.free_symbols:
            if node.exp.is_Rational and node.exp.q % 2 == 0:
                found.append(Claim(node.base, ">" if node.exp.is_negative else ">="))
            elif node.exp.is_negative:
                found.append(Claim(node.base, "!="))
        elif isinstance(node, sp.asin | sp.acos):
            found += [Claim(1 - node.args[0], ">="), Claim(1 + node.args[0], ">=")]
    return found


def _constant_sign(work: Working, value: sp.Expr) -> int:
    """+1 or −1 if an expression is proved to have one sign for all that letters may be, else 0."""
    return proved_sign(work.model.ground, work.model.in_data(value)) or 0


def _weak_sign(work: Working, value: sp.Expr) -> int:
    """+1 or −1 if an expression is proved never to have the other sign, else 0."""
    for sign in (1, -1):
        try:
            if work.model.ground.decide(Claim(sign * value, ">=")):
                return sign
        except BeyondError:
            break
    return 0


def _inner_sign(work: Working, value: sp.Expr) -> int:
    """The same but at the ends of the letters' ranges, where it may be 0: a slope."""
    value = work.model.in_data(value)
    return proved_sign(work.model.ground, value) or proved_sign(work.model.inside, value) or 0


# --- conditions ---------------------------------------------------------------------------------


def _bounds(work: Working) -> list[Bound]:
    """Everything in the story and the facts that excludes something."""
    found: list[Bound] = []
    found += _from_facts(work)
    on_walls, ended = _on_the_walls(work)
    found += on_walls
    found += _from_story(work, ended)
    found += _from_solved(work)
    return found


def _from_facts(work: Working) -> list[Bound]:
    found: list[Bound] = []
    problem, part = work.model.problem, work.model.part
    for given, now in solve_facts.givens(problem, part):
        for relation in given.relations:
            try:
                found += _of_relation(work, relation, now)
            except (RestitutionError, TypeError, AttributeError):
                continue
    return found


def _of_relation(work: Working, relation: Relation, now: int) -> list[Bound]:
    story = work.model.story
    found: list[Bound] = []
    if isinstance(relation, Meets):
        needs = solve_facts.requirements(relation, story, now)
        single = [each for each in needs if isinstance(each, Condition)]
        if len(needs) == 1 and single:
            found.append(_meeting(work, relation, single[0], now))
        else:
            found += _passing(work, relation, needs, now)
    elif isinstance(relation, Compare):
        for left, op, right in zip(
            relation.operands, relation.operators, relation.operands[1:], strict=False
        ):
            if op == "=" or not (has_quantity(left) or has_quantity(right)):
                continue
            prepare(work, left, now)
            prepare(work, right, now)
            sign = lay.SIGNS.get(op, op)
            if any(isinstance(story.evaluator(now).value(t), Angle) for t in (left, right)):
                found += _of_angles(work, left, op, right, now)
                continue
            a, b = put_in(work, left, now), put_in(work, right, now)
            fact = lay.relation(work.layout(left), sign, work.layout(right))
            found.append(
                Bound(
                    say("given.fact", fact=fact),
                    a,
                    sign,
                    b,
                    sp.sympify(a.value, strict=True) - sp.sympify(b.value, strict=True),
                    sign,
                )
            )
    elif isinstance(relation, Aligned):
        for need in solve_facts.requirements(relation, story, now):
            if isinstance(need, Condition):
                value = _smaller(work, sp.sympify(need.value, strict=True))
                found.append(
                    Bound(
                        say("given.fact", fact=work.aligned(relation)),
                        value,
                        _SIGNS[need.relation],
                        sp.Integer(0),
                        value,
                        _SIGNS[need.relation],
                    )
                )
    return found


def _smaller(work: Working, value: sp.Expr) -> sp.Expr:
    """A condition on a product with the positive parts left out."""
    return value


def _of_angles(
    work: Working, left: Expression, op: Any, right: Expression, now: int
) -> list[Bound]:
    """Angles are compared by the sine of their difference; with 90°, by the scalar product."""
    (need,) = solve_facts.requirements(Compare((left, right), (op,)), work.model.story, now)
    if not isinstance(need, Condition):
        return []
    sign = lay.SIGNS.get(op, op)
    fact = lay.relation(work.layout(left), sign, work.layout(right))
    sentence = say("given.fact", fact=fact)
    if right == Degrees(Fraction(90)):
        obtuse = op.startswith(">")
        sentence = say("given.negative-product" if obtuse else "given.positive-product", fact=fact)
    value = sp.sympify(need.value, strict=True)
    asks = _SIGNS[need.relation]
    if op.startswith(">") and right == Degrees(Fraction(90)):
        shown = -value
        return [Bound(sentence, shown, "<" if asks == ">" else "≤", sp.Integer(0), value, asks)]
    return [Bound(sentence, value, asks, sp.Integer(0), value, asks)]


def _passing(work: Working, relation: Meets, needs: Sequence[Any], now: int) -> list[Bound]:
    """Whether a sphere comes to a wall with ends: where it crosses the line of the wall."""
    options = [
        option
        for need in needs
        for option in (need.options if isinstance(need, AnyOf) else (need,))
        if isinstance(option, Condition)
    ]
    one, other = relation.first.name, relation.second.name
    if work.model.story.walls[other].start is not None:
        _crossing(work, relation, now, (M1, A1))
    happens = relation.happens
    sentence = say("condition.both" if happens else "condition.either", body=one, wall=other)
    among: Literal["all", "any"] = "all" if happens else "any"
    found = []
    for option in options:
        value = sp.sympify(option.value, strict=True)
        sign = _SIGNS[option.relation]
        found.append(Bound(sentence, value, sign, sp.Integer(0), value, sign, among=among))
    return found


def _crossing(work: Working, relation: Meets, now: int, points: Marks) -> Any:
    """The point where a sphere comes to the line of a wall, written down; None if that is open."""
    one, other = relation.first.name, relation.second.name
    story = work.model.story
    known = story.place(one, now)
    if known is None:
        return None
    through = story.read_vector(story.walls[other].start, "the end of a wall")
    normal = story.wall_direction(relation.second).turned_left()
    v = story.velocity(one, now)
    work.reach(work.open(tuple(v)))
    point = work.put(known[0] + v * (normal.dot(through - known[0]) / normal.dot(v)))
    laid = lay.Coordinates((look(point.x), look(point.y)))
    sentence = say("crossing.point", body=one, wall=other, point=laid)
    work.write("result", sentences=(sentence,), points=points)
    return point


def _meeting(work: Working, relation: Meets, need: Condition, now: int) -> Bound:
    one, other = relation.first.name, relation.second.name
    story = work.model.story
    if other in story.spheres:
        event = next(h for h in reversed(story.happenings[:now]) if {one, other} == set(h.bodies))
        frame = work.model.frames[event.number]
        first, second = event.bodies
        a, b = (work.model.story.velocity(name, now).dot(frame.n) for name in (first, second))
        work.reach(work.open((a, b)))
        a, b = work.put(a), work.put(b)
        if work.model.sign(event.oriented().dot(frame.n)) < 0:
            a, b, first, second = b, a, second, first
        sentence = say(
            "collide-again.if" if relation.happens else "collide-again.unless",
            one=one,
            other=other,
            first=first,
            second=second,
        )
        sign = ">" if relation.happens else "≤"
        return Bound(
            sentence, a, sign, b, sp.sympify(a, strict=True) - sp.sympify(b, strict=True), sign
        )
    value = sp.sympify(need.value, strict=True)
    work.reach(work.open(value))
    again = say("again") if relation.again else ""
    happens = relation.happens
    sentence = say(
        "condition.towards" if happens else "condition.away", body=one, wall=other, again=again
    )
    shown = work.put(value)
    return Bound(
        sentence, shown, _SIGNS[need.relation], sp.Integer(0), shown, _SIGNS[need.relation]
    )


def _on_the_walls(work: Working) -> tuple[list[Bound], set[str]]:
    """A wall with ends is struck between them: where that is, and where the ends are.

    With the names of the walls of which that is told so.
    """
    story = work.model.story
    found: list[Bound] = []
    told: set[str] = set()
    for event in story.happenings:
        step = event.step
        wall = story.walls.get(step.second) if isinstance(step, Impact) else None
        if wall is None or wall.start is None or wall.end is None:
            continue
        assert isinstance(step, Impact)
        known = story.place(step.first, event.number)
        if known is None:
            continue
        one, other = (story.read_vector(end, "the end") for end in (wall.start, wall.end))
        one, other = work.put(one), work.put(other)
        way = other - one
        straight = way.x == 0 or way.y == 0
        if straight:
            name = "x" if way.y == 0 else "y"
            low, high, place = (getattr(each, name) for each in (one, other, known[0]))
            order = work.model.proved_sign(high - low)
            if not order:
                continue
            if order < 0:
                low, high = high, low
            ends = {"letter": lay.Letter(name), "low": look(low), "high": look(high)}
        else:
            size = tidy(sp.sqrt(tidy(way.dot(way))))
            low, high, place = sp.Integer(0), size, (known[0] - one).dot(way) / size
            corner = lay.Coordinates((look(one.x), look(one.y)))
            ends = {"end": corner, "length": look(size)}
        work.reach(work.open(place))
        sentence = say(
            "condition.coordinate" if straight else "condition.distance",
            body=step.first,
            wall=wall.name,
            place=look(work.put(place)),
            **ends,
        )
        told.add(wall.name)
        found.append(Bound(sentence, place, ">", low, sp.sympify(place - low, strict=True), ">"))
        found.append(Bound(sentence, place, "<", high, sp.sympify(place - high, strict=True), "<"))
    return found, told


def _from_story(work: Working, ended: AbstractSet[str]) -> list[Bound]:
    found = []
    for need in work.model.story.conditions:
        if isinstance(need, AnyOf) or need.kind == "sign":
            continue
        if need.end_of in ended:
            continue  # told by where the wall is struck
        value = sp.sympify(need.value, strict=True)
        sign = _SIGNS[need.relation]
        if need.kind == "coefficient":
            if value.is_Symbol or (1 - value).is_Symbol:
                continue  # told by what the letter may be
            found.append(Bound(say("coefficient.range"), value, sign, sp.Integer(0), value, sign))
            continue
        if sign == "≠":
            # The story tells the sense of approach, where there is but one.
            sense = work.model.proved_sign(value)
            if sense:
                sign, value = ">", sense * value
        sentence = say("condition.else", reason=need.reason)
        found.append(Bound(sentence, value, sign, sp.Integer(0), value, sign, bare=True))
    return found


def _from_solved(work: Working) -> list[Bound]:
    """Letters that the facts fix have to lie where they may."""
    found = []
    for symbol, value in work.model.final.items():
        role = work.model.unknowns.roles.get(symbol.name)
        if role is None or not value.free_symbols:
            continue
        if role.kind == "restitution":
            low = role.low if role.low is not None else sp.Integer(0)
            high = role.high if role.high is not None else sp.Integer(1)
            sentence = say("coefficient.letter", letter=look(symbol))
            found.append(
                Bound(
                    sentence,
                    symbol,
                    "≤" if role.closed[1] else "<",
                    high,
                    symbol - high,
                    "≤" if role.closed[1] else "<",
                )
            )
            found.append(
                Bound(
                    sentence,
                    symbol,
                    "≥" if role.closed[0] else ">",
                    low,
                    symbol - low,
                    "≥" if role.closed[0] else ">",
                )
            )
        elif role.kind == "angle" and _arctangent(value) is not None:
            tangent = tidy(_arctangent(value))
            power = 2 if tangent.is_Pow and tangent.exp == sp.S.Half else 1
            name = sp.tan(symbol) ** power
            sentence = say("condition.positive", quantity=look(name))
            found.append(Bound(sentence, name, ">", sp.Integer(0), name, ">"))
        elif role.kind == "positive":
            sentence = say("condition.positive", quantity=look(symbol))
            found.append(Bound(sentence, symbol, ">", sp.Integer(0), symbol, ">"))
    return found


def _arctangent(angle: sp.Expr) -> sp.Expr | None:
    """X of arctan x or −arctan(−x)."""
    sign, rest = angle.as_coeff_Mul()
    return sign * rest.args[0] if isinstance(rest, sp.atan) and abs(sign) == 1 else None


def _told(work: Working, bound: Bound, x: sp.Symbol | None) -> None:
    """Writes a bound: as first put, with the values, and solved for the letter if that is easy."""
    work.reach(work.open(bound.value))
    left = _final_side(work, bound.left)
    right = _final_side(work, bound.right)
    several = bound.among != "alone"
    checked = () if several else (left.value, right.value)
    rows = [Row((left.layout, right.layout), (bound.sign,), checked or (None, None), (M1,))]
    value = work.put(bound.value)
    simple, sign = _reduced(work, value, bound.asks, x)
    if bound.bare and simple.free_symbols:
        rows = [Row((look(factored(simple)), right.layout), (sign,), (simple, right.value), (M1,))]
    if simple.free_symbols and several:
        # Where only one of them need hold, none can be checked by itself.
        alone = bound.among == "all"
        rows = [
            Row(each.operands, each.signs, each.values if alone else (None, None), (M1, A1))
            for each in _solved(work, simple, sign, x, rows[0])
        ]
    elif simple.free_symbols:
        rows += [
            each
            for each in _solved(work, simple, sign, x, rows[0])
            if (each.operands, each.signs) != (rows[0].operands, rows[0].signs)
        ]
    if not several and rows[-1].operands != rows[0].operands:
        last = rows[-1]
        rows[-1] = Row(last.operands, last.signs, last.values, (A1,), last.asides)
    work.write("fact", rows, sentences=(bound.sentence,), uses=work.uses(bound.value))


def _final_side(work: Working, given: Any) -> Side:
    if isinstance(given, Side):
        if given.value is None or not work.open(given.value):
            return given
        return side(work.put(given.value))
    return side(work.put(given))


def _reduced(
    work: Working, value: sp.Expr, sign: str, x: sp.Symbol | None = None
) -> tuple[sp.Expr, str]:
    """An inequality without the factors that are positive anyway; one that is x itself is kept."""
    value = factored(sp.together(value))
    kept = sp.Integer(1)
    divisors = sp.Integer(1)
    for factor, power in value.as_powers_dict().items():
        if not factor.free_symbols:
            if factor.is_negative and int(power) % 2:
                sign = _FLIPPED[sign]
            continue
        if power.is_Integer and int(power) % 2 == 0:
            continue
        constant = _constant_sign(work, factor)
        if constant == 0 and power.is_negative:
            # What is divided by is not 0.
            constant = _weak_sign(work, factor)
            divisors *= factor if constant else 1
        if constant == 0:
            kept *= factor
        elif constant < 0 and (not power.is_Integer or int(power) % 2):
            sign = _FLIPPED[sign]
    if not kept.free_symbols and x is not None and divisors.has(x):
        return divisors, ">" if sign in ">≥" else "<"
    kept = sp.expand(kept) if kept.is_Mul or kept.is_Pow else kept
    squared = _squares_compared(work, kept)
    return (kept, sign) if squared is None else _reduced(work, squared, sign, x)


def _squares_compared(work: Working, value: sp.Expr) -> sp.Expr | None:
    """``a² − b`` for ``a − √b``, which has the same sign where ``a`` is positive."""
    roots = {
        node
        for node in sp.preorder_traversal(value)
        if isinstance(node, sp.Pow) and node.exp == sp.S.Half and node.base.free_symbols
    }
    if len(roots) != 1:
        return None
    (root,) = roots
    other = value.xreplace({root: -root})
    constant = _constant_sign(work, other)
    product = sp.expand(value * other)
    return None if constant == 0 or product.has(root) else constant * product


def _solved(
    work: Working, simple: sp.Expr, sign: str, x: sp.Symbol | None, first: Row
) -> list[Row]:
    del first
    if x is not None and simple.has(x):
        if work.is_angle(x):
            t = TANGENT
            poly = by_tangent(simple, x, t)
            if poly is not None and sp.degree(poly, t) in (1, 2):
                p = sp.Poly(poly, t)
                if p.degree() == 1 or p.coeff_monomial(t) == 0:
                    bound = tidy(-p.coeff_monomial(1) / p.LC())
                    turned = _by_sign(work, p.LC(), sign)
                    if turned is not None:
                        power = sp.tan(x) ** p.degree()
                        return [Row((look(power), look(bound)), (turned,), (power, bound))]
        elif simple.is_polynomial(x) and sp.degree(simple, x) == 1:
            a, b = sp.Poly(simple, x).all_coeffs()
            turned = _by_sign(work, a, sign)
            if turned is not None:
                bound = tidy(-b / a)
                return [Row((look(x), look(bound)), (turned,), (x, bound))]
        apart = _apart(simple, x) if simple.is_polynomial(x) else None
        if apart is not None:
            left, right, swapped = apart
            way = _FLIPPED[sign] if swapped else sign
            return [Row((look(left), look(right)), (way,), (left, right))]
    tidied = factored(simple)
    return [Row((look(tidied), lay.Number("0")), (sign,), (tidied, sp.Integer(0)))]


def _apart(simple: sp.Expr, x: sp.Symbol) -> tuple[sp.Expr, sp.Expr, bool] | None:
    """``a xⁿ`` and ``b`` for a xⁿ − b, or turned round for b − a xⁿ; None for what has more."""
    terms = sp.Poly(simple, x).terms()
    if len(terms) != 2 or terms[1][0] != (0,):
        return None
    ((power,), a), (_, b) = terms
    left, right = tidy(factored(a) * x**power), tidy(factored(-b))
    turned = bool(right.could_extract_minus_sign())
    return (tidy(-left), tidy(-right), True) if turned else (left, right, False)


def _by_sign(work: Working, factor: sp.Expr, sign: str) -> str | None:
    # What is not 0 where the conditions hold may be divided by.
    constant = _constant_sign(work, factor) or work.model.proved_sign(factor)
    if not constant:
        return None
    return sign if constant > 0 else _FLIPPED[sign]


# --- ranges -------------------------------------------------------------------------------------


def explain_range(work: Working, tree: Expression, answers: Sequence[Answer], now: int) -> None:
    """The conditions that bound a letter or a quantity, then its range.

    A range whose form depends on the data has an answer for each form, with its condition.
    """
    name = work.layout(tree)
    before = len(work.steps)
    values = [each.value for each in answers]
    _range_working(work, tree, now, frozenset().union(*(each.free_symbols for each in values)))
    sentence = say("range.is")
    if isinstance(tree, Letter) and len(work.steps) == before:
        role = work.model.unknowns.roles.get(tree.name)
        if role is not None and all(_whole(role, each) for each in values):
            sentence = say("range.whole")
    rows = []
    for each in answers:
        laid: lay.Layout = lay.display_set(each.value, name, angle=each.angle)
        if len(answers) > 1 and each.condition_layout is not None:
            case = operand(say("range.for", condition=each.condition_layout))
            laid = lay.Phrase((laid, case), ", ")
        rows.append(Row((laid,), (), (None,), (A1,)))
    work.write("result", rows, sentences=(sentence,))


def _whole(role: Role, values: Any) -> bool:
    """Whether a range is everything that a letter of this role may be."""
    low = -sp.oo if role.low is None else role.low
    high = sp.oo if role.high is None else role.high
    return isinstance(values, sp.Interval) and (values.start, values.end) == (low, high)


def explain_conditions(work: Working, tree: Expression, now: int) -> None:
    """The conditions that bound a letter, where an inequality for it has to be shown."""
    _range_working(work, tree, now)


def _range_working(
    work: Working, tree: Expression, now: int, kept: AbstractSet[sp.Basic] = frozenset()
) -> None:
    x = work.model.unknowns.letter(tree.name) if isinstance(tree, Letter) else None
    found = x is not None and x in work.model.final
    if x is None or found:
        prepare(work, tree, now)
        for asked in quantities_in(work, tree, now):
            sub_result(work, asked)
    told: list[tuple[sp.Expr, str]] = []
    facts: list[Formula] = []
    for bound in _bounds(work):
        value = _final(work, bound.value)
        if (
            x is not None
            and x not in value.free_symbols
            and not (
                value.free_symbols
                & {work.model.unknowns.letter(n) for n in work.model.unknowns.roles}
            )
        ):
            continue
        said = _upwards(*_reduced(work, value, bound.asks, x))
        if not said[0].free_symbols or said in told:
            continue
        if _ever_fails(work, value, bound.asks, () if bound.among == "any" else facts):
            told.append(said)
            _told(work, bound, x)
            facts += _printed(work)
    if x is None or found:
        _ends(work, tree, now, kept, alone=not told)


def _printed(work: Working) -> list[Formula]:
    """The inequalities of the step just written, in the data alone."""
    return [
        compared(work.model.in_data(left), _PLAIN.get(sign, sign), work.model.in_data(right))
        for row in work.steps[-1].rows
        for left, sign, right in related(row)
        if sign != "=" and not isinstance(left, tuple)
    ]


def _upwards(value: sp.Expr, sign: str) -> tuple[sp.Expr, str]:
    """A condition with the sign > or ≥, so that equal ones look equal."""
    return (sp.expand(-value), _FLIPPED[sign]) if sign in "<≤" else (sp.expand(value), sign)


def _final(work: Working, value: Any) -> sp.Expr:
    """An expression in the data alone."""
    x = sp.sympify(value, strict=True)
    for _ in range(6):
        inside = {s: work.model.final[s] for s in x.free_symbols if s in work.model.final}
        if not inside:
            break
        x = x.xreplace(inside)
    return work.resolved(x)


def _ends(
    work: Working,
    tree: Expression,
    now: int,
    kept: AbstractSet[sp.Basic] = frozenset(),
    *,
    alone: bool = True,
) -> None:
    """How a quantity changes as one letter runs through its range, where it always grows.

    The letters that are kept stand in the range itself, and do not run. Ends at infinity say
    nothing beside other conditions: they are told only where this is ``alone``.
    """
    value = evaluated(work, tree, now)
    if isinstance(value, tuple):
        return
    value = sp.sympify(value, strict=True)
    rows: list[Row] = []
    for symbol in sorted(value.free_symbols, key=lambda s: str(s.name)):
        role = work.model.unknowns.roles.get(symbol.name)
        if role is None or role.low is None or symbol in kept:
            continue
        slope = _inner_sign(work, sp.diff(value, symbol))
        if slope == 0:
            continue
        if _turns_back(work, tree, value, symbol):
            continue
        angle = work.is_angle(symbol)
        is_angle = isinstance(tree, Quantity) and tree.kind in ("angle", "deflection")
        is_angle = is_angle or (
            isinstance(tree, Letter) and work.is_angle(work.model.unknowns.letter(tree.name))
        )
        name = work.layout(tree)
        ends = []
        high = sp.oo if role.high is None else role.high
        for end in (role.low, high):
            near = _near(work, tree, now, symbol, end, value)
            try:
                limit = sp.limit(near, symbol, end, "+" if end == role.low else "-")
            except (NotImplementedError, ValueError):
                limit = near.subs(symbol, end)
            if limit.is_finite is False:
                ends.append(limit)
                continue
            ends.append(_unwound(work, tidy_angle(limit)) if is_angle else tidy(limit))
        if not alone and (sp.oo in ends or high == sp.oo):
            continue
        if not all(
            _is_limit(work, _near(work, tree, now, symbol, at_, value), symbol, at_, end)
            for at_, end in zip((role.low, high), ends, strict=True)
        ):
            continue
        sentence = say(
            "range.runs",
            letter=look(symbol),
            change=_from_to(role.low, high, angle),
            quantity=name,
            effect=_from_to(ends[0], ends[1], is_angle, grows=slope > 0),
        )
        work.write("result", rows, sentences=(sentence,), points=(M1,))


def _from_to(first: sp.Expr, last: sp.Expr, angle: bool, *, grows: bool = True) -> Sentence:
    """``increases from 0 to 1``, ``increases from 0 without limit``."""
    start, end = look(first, angle=angle), look(last, angle=angle)
    if first.is_infinite and last.is_infinite:
        return say("increases.always" if grows else "decreases.always")
    if first.is_infinite:
        return say("increases.to" if grows else "decreases.to", end=end)
    if last.is_infinite:
        return say("increases.from" if grows else "decreases.from", start=start)
    return say("increases.between" if grows else "decreases.between", start=start, end=end)


def _beside(work: Working, end: sp.Expr) -> Any:
    """A number inside an interval, beside its end."""
    if end == sp.oo:
        return work.model.number(sp.Integer(10) ** 12)
    place = work.model.number(end)
    return _STEP if end == 0 else place * (1 - _STEP)


def _near(
    work: Working, tree: Expression, now: int, symbol: sp.Symbol, end: sp.Expr, value: sp.Expr
) -> sp.Expr:
    """A value as it is written near an end: the same angle may need another half turn there."""
    raw = work.model.story.evaluator(now).value(tree)
    if not isinstance(raw, Angle):
        return value
    there = {**work.model.sample, symbol.name: _beside(work, end)}
    own = Angle(work.put(raw.x), work.put(raw.y), raw.measure)
    return sp.sympify(forms.angle(own, [there]), strict=True)


def _unwound(work: Working, angle: sp.Expr) -> sp.Expr:
    """Without arctan(tan x): x itself, less the half turns between them."""
    for inner in angle.atoms(sp.atan):
        x = inner.args[0].args[0] if isinstance(inner.args[0], sp.tan) else None
        if x is None:
            continue
        turns = round(float((work.model.number(x) - work.model.number(inner)) / sp.pi))
        angle = angle.xreplace({inner: x - turns * sp.pi})
    return sp.expand(angle)


def _is_limit(
    work: Working, value: sp.Expr, symbol: sp.Symbol, place: sp.Expr, limit: sp.Expr
) -> bool:
    """Whether an expression comes near a limit, by numbers."""
    try:
        there = _beside(work, place)
        near = at(value, {**work.model.sample, symbol.name: there})
        usual = abs(work.model.number(value))
        if limit == sp.oo:
            return bool(near > 1000 * usual)
        far = at(limit, {**work.model.sample, symbol.name: there})
    except (UndefinedError, KeyError, ArithmeticError, TypeError):
        return False
    return bool(abs(near - far) <= (abs(far) + usual) * 1e-6)


def _turns_back(work: Working, tree: Expression, value: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether a speed |x| has an x of either sign as a letter runs through its range."""
    role = work.model.unknowns.roles.get(symbol.name)
    if role is None or not isinstance(tree, Quantity) or tree.kind != "speed":
        return False
    ends = [x for x in (role.low, sp.oo if role.high is None else role.high) if x is not None]
    for size in sorted(value.atoms(sp.Abs), key=sp.default_sort_key):
        signs = set()
        for place in ends:
            there = {**work.model.sample, symbol.name: _beside(work, place)}
            try:
                signs.add(at(size.args[0], there) > 0)
            except (UndefinedError, KeyError, ArithmeticError, TypeError):
                continue
        if len(signs) == 2:
            return True
    return False


def explain_shown_bound(work: Working, item: Show, result: ItemResult, now: int) -> None:
    """A range or an extremum that is printed and has to be shown."""
    del result
    subject = item.subject
    relation = item.relation
    assert isinstance(relation, Compare)
    if isinstance(subject, Range):
        _range_working(work, subject.expression, now)
        operands = tuple(work.layout(each) for each in relation.operands)
        signs = tuple(lay.SIGNS.get(op, op) for op in relation.operators)
        work.write(
            "result",
            [Row(operands, signs, (None,) * len(operands), (A1_STAR,), REQUIRED)],
            sentences=(say("so"),),
        )
    elif isinstance(subject, Extremum):
        target = evaluated(work, relation.operands[-1], 0)
        _extremum(work, subject, sp.sympify(target, strict=True), now)
        operands = tuple(work.layout(each) for each in relation.operands)
        name = _extreme(subject, operands[0])
        work.write(
            "result",
            [
                Row(
                    (name, *operands[1:]),
                    ("=",) * (len(operands) - 1),
                    (None,) * len(operands),
                    (A1_STAR,),
                    REQUIRED,
                )
            ],
        )


def _extreme(item: Extremum, quantity: Layout) -> Layout:
    """``maximum of v``, as the left side of a line."""
    maximum = item.kind == "maximum"
    return operand(say("extremum.maximum" if maximum else "extremum.minimum", quantity=quantity))


# --- extrema ------------------------------------------------------------------------------------


def explain_extremum(work: Working, item: Extremum, answer_: Answer, now: int) -> None:
    """The quantity as a function, its derivative, where it is zero or which end counts."""
    _extremum(work, item, sp.sympify(answer_.value, strict=True), now)
    name = _extreme(item, work.layout(item.expression))
    sides = answer(answer_.value, angle=answer_.angle, percentage=item.percentage)
    work.write(
        "result",
        [
            Row(
                (name, *(s.layout for s in sides)),
                ("=",) * len(sides),
                (None,) * (len(sides) + 1),
                (A1,),
                () if answer_.reached else (say("extremum.approached"),),
            )
        ],
    )


def _extremum(work: Working, item: Extremum, target: sp.Expr, now: int) -> None:
    tree = item.expression
    assert isinstance(item.over, Letter)
    x = work.model.unknowns.letter(item.over.name)
    prepare(work, tree, now)
    for asked in quantities_in(work, tree, now):
        if asked.tree.kind == "deflection":
            derived = derive(work, asked.tree, asked.now)
            own = work.layout(asked.tree)
            rows = [row for row in derived.rows if row.operands[0] != own] or derived.rows
            uses = found_before(work, asked.tree, asked.now)
            work.write("result", rows, derived.title, derived.sentences, uses=uses)
        else:
            sub_result(work, asked)
    value = sp.sympify(evaluated(work, tree, now), strict=True)
    if _turns_back(work, tree, value, x):
        work.write("result", sentences=(say("extremum.size"),))
        return
    function, target_, name = _as_function(value, target, work.layout(tree))
    if not isinstance(tree, Quantity) and function == value:
        work.write("result", [chain(Side(work.layout(tree), value), side(value))])
    variable: Any = x
    shown_x: sp.Expr = x
    if work.is_angle(x):
        t = TANGENT
        replaced = _in_tangent(function, x, t)
        if replaced is not None:
            function, variable, shown_x = replaced, t, sp.tan(x)
    if not function.has(variable):
        # What is given ties it to the letter: it is greatest or least at an end of its own range.
        _range_working(work, tree, now)
        return
    slope = tidy(factored(sp.diff(function, variable)))
    back = {variable: shown_x}
    root = _stationary(work, slope, function, target_, variable)
    letter: Any = x
    sentence = say("extremum.differentiate")
    if variable is not x:
        letter = _parameter(work)
        sentence = say("extremum.with", letter=look(letter), value=look(shown_x))
    put = {variable: letter}
    rate = lay.Fraction(lay.Words("d"), lay.Product((lay.Words("d"), look(letter))))
    own_slope = slope.xreplace(back)
    row = Row(
        (
            lay.product(rate, name if isinstance(name, lay.Letter) else lay.Brackets(name)),
            look(slope.xreplace(put)),
        ),
        ("=",),
        (None, own_slope),
        (M1, A1),
    )
    lines: list[Row] = []
    if variable is not x:
        own = function.xreplace(back)
        angle = isinstance(own, sp.Add) and own.has(sp.atan)  # 180° − arctan …
        lines.append(Row((name, look(function.xreplace(put), angle=angle)), ("=",), (own, own)))
    if root is None or _inner_sign(work, tidy(own_slope)):
        _at_an_end(
            work, item, sentence, [*lines, row], x, own_slope, (name, function.xreplace(back))
        )
        return
    factor, place = root
    lines += [
        row,
        Row(
            (look(factor.xreplace(put)), lay.Number("0")),
            ("=",),
            (None, None),
            (DM1,),
            (say("extremum.stationary"),),
        ),
        Row((look(letter), look(place)), ("=",), (None, None), (A1,)),
    ]
    work.write("result", lines, sentences=(sentence,))


def _parameter(work: Working) -> sp.Symbol:
    """A letter for the tangent of an angle that the problem does not use."""
    taken = set(work.model.unknowns.roles) | {c.symbol.name for c in work.model.components.values()}
    return sp.Symbol(next(c for c in ("t", "s", "z", "q", "p", "T") if c not in taken))


def _as_function(value: sp.Expr, target: sp.Expr, name: Layout) -> tuple[sp.Expr, sp.Expr, Layout]:
    """An angle by its tangent, a root by its square: they are greatest together."""
    if isinstance(value, sp.atan):
        return value.args[0], tidy(sp.tan(target)), lay.function("tan", lay.Brackets(name))
    if value.is_Pow and value.exp == sp.S.Half:
        return value.base, tidy(target**2), lay.power(lay.Brackets(name), lay.Number("2"))
    return value, target, name


def _in_tangent(function: sp.Expr, x: sp.Symbol, t: sp.Symbol) -> sp.Expr | None:
    c = 1 / sp.sqrt(1 + t**2)
    replaced = function.subs(sp.tan(x), t).subs({sp.sin(x): t * c, sp.cos(x): c})
    if replaced.has(x):
        return None
    replaced = tidy(simplified(replaced))
    return None if replaced.has(sp.sqrt(1 + t**2)) else replaced


def _stationary(
    work: Working,
    slope: sp.Expr,
    function: sp.Expr,
    target: sp.Expr,
    variable: sp.Symbol,
) -> tuple[sp.Expr, sp.Expr] | None:
    """The factor of the derivative that vanishes at the extremum, and its root there."""
    numerator = above(slope)
    try:
        factors = [f for f, _ in sp.factor_list(numerator)[1] if f.has(variable)]
    except sp.PolynomialError:
        return None
    for factor in factors:
        if not factor.is_polynomial(variable):
            continue
        try:
            roots = algebra.roots(factor, variable)
        except (RestitutionError, sp.PolynomialError, NotImplementedError):
            continue
        for root in roots:
            place = tidy(root)
            if work.model.sign(place) < 0:
                continue
            reached = function.xreplace({variable: place})
            if work.model.sign(reached - target) == 0 and _defined(work, reached):
                return factor if not factor.could_extract_minus_sign() else -factor, place
    return None


def _defined(work: Working, value: sp.Expr) -> bool:
    try:
        work.model.number(value)
    except (UndefinedError, KeyError, ArithmeticError):
        return False
    return True


def _at_an_end(
    work: Working,
    item: Extremum,
    intro: Sentence,
    rows: Sequence[Row],
    x: sp.Symbol,
    slope: sp.Expr,
    told: tuple[Layout, sp.Expr],
) -> None:
    """The quantity always grows, or always falls: an end of the interval counts.

    Where it does both, its values at the two ends are compared.
    """
    constant = _inner_sign(work, tidy(slope))
    greatest = item.kind == "maximum"
    work.write("result", rows, sentences=(intro,))
    if not constant:
        compared = _both_ends(work, x, *told)
        if compared:
            sentence = say(
                "extremum.end-maximum" if greatest else "extremum.end-minimum", letter=look(x)
            )
            work.write("result", compared, sentences=(sentence,))
    else:
        role = work.model.unknowns.roles.get(x.name)
        grows = constant > 0
        upper = grows == greatest
        end = None if role is None else (role.high if upper else role.low)
        slots = {"quantity": work.layout(item.expression), "letter": look(x)}
        if end is None:
            sentence = say("slope.positive" if grows else "slope.negative", **slots)
        else:
            slots["end"] = look(end, angle=work.is_angle(x))
            if grows:
                sentence = say(
                    "slope.positive-maximum" if greatest else "slope.positive-minimum", **slots
                )
            else:
                sentence = say(
                    "slope.negative-maximum" if greatest else "slope.negative-minimum", **slots
                )
        work.write("result", sentences=(sentence,), points=(DM1,))


def _both_ends(work: Working, x: sp.Symbol, name: Layout, function: sp.Expr) -> list[Row]:
    """A quantity at both ends of the range of a letter."""
    role = work.model.unknowns.roles.get(x.name)
    if role is None or role.low is None or role.high is None:
        return []
    rows = []
    for end, side_ in ((role.low, "+"), (role.high, "-")):
        try:
            value = tidy(sp.limit(function, x, end, side_))
        except (NotImplementedError, ValueError):
            return []
        if value.is_finite is False or not _is_limit(work, function, x, end, value):
            return []
        place = lay.Relation((look(x), look(end, angle=work.is_angle(x))), ("=",))
        sides = answer(value)
        # A value at an end is not that of the letter as it is: nothing to check by the sample.
        rows.append(
            Row(
                (name, *(each.layout for each in sides)),
                ("=",) * len(sides),
                (None,) * (len(sides) + 1),
                (M1,) if end == role.low else (),
                (say("extremum.when", place=place),),
            )
        )
    return rows


def explain_meets(work: Working, relation: Meets, now: int) -> None:
    """``show A and B collide again``: their components along the line compared."""
    story = work.model.story
    needs = solve_facts.requirements(relation, story, now)
    need, *more = needs
    wall = story.walls.get(relation.second.name)
    if wall is not None and wall.start is not None and wall.end is not None:
        _show_passing(work, relation, needs, now)
        return
    if not isinstance(need, Condition) or more:
        return
    bound = _meeting(work, relation, need, now)
    left, right = _final_side(work, bound.left), _final_side(work, bound.right)
    rows = []
    if bound.right != 0:
        gap = tidy(sp.sympify(left.value, strict=True) - sp.sympify(right.value, strict=True))
        rows.append(
            Row(
                (printed("a - b", a=left.layout, b=right.layout), look(gap), lay.Number("0")),
                ("=", bound.sign),
                (gap, gap, sp.Integer(0)),
                (M1, A1),
            )
        )
    else:
        rows.append(
            Row((left.layout, right.layout), (bound.sign,), (left.value, right.value), (M1, A1))
        )
    work.write("result", rows, sentences=(bound.sentence,))
    _write_meeting(work, relation)


def _show_passing(work: Working, relation: Meets, needs: Sequence[Any], now: int) -> None:
    """Whether a sphere comes to a wall with ends: its way, and where it crosses the wall's line."""
    story = work.model.story
    one, other = relation.first.name, relation.second.name
    wall = story.walls[other]
    assert wall.start is not None
    assert wall.end is not None
    first = needs[0].options[0] if isinstance(needs[0], AnyOf) else needs[0]
    towards = sp.sympify(first.value, strict=True)
    work.reach(work.open(tuple(story.velocity(one, now))))
    if not relation.happens and work.model.decide(towards, ">=", 0):
        velocity = Quantity("velocity", (Name(one),))
        laid = lay.equation(work.layout(velocity), look(evaluated(work, velocity, now)))
        away = say("crossing.away", body=one, wall=other, velocity=laid)
        work.write("result", sentences=(away,), points=(M1, A1))
    elif (point := _crossing(work, relation, now, (M1,))) is not None:
        start, end = (
            work.put(story.read_vector(each, "the end of a wall"))
            for each in (wall.start, wall.end)
        )
        row = _between_ends(work, relation, point, start, end)
        if row is not None:
            ends = [lay.Coordinates((look(each.x), look(each.y))) for each in (start, end)]
            extent = say("crossing.extent", wall=other, start=ends[0], end=ends[1])
            work.write("result", [row], sentences=(extent,))
    _write_meeting(work, relation)


def _between_ends(work: Working, relation: Meets, point: Any, start: Any, end: Any) -> Row | None:
    """The coordinate of a point on the line of a wall against those of its ends."""
    way = end - start
    name = "y" if way.x == 0 else "x"
    low, high, place = (getattr(each, name) for each in (start, end, point))
    order = work.model.proved_sign(high - low)
    if not order:
        return None
    if order < 0:
        low, high = high, low
    if relation.happens:
        values = (sp.sympify(each, strict=True) for each in (low, place, high))
        low, place, high = values
        return Row((look(low), look(place), look(high)), ("<", "<"), (low, place, high), (A1,))
    for sign, border in (("≤", low), ("≥", high)):
        if work.model.decide(place, sign, border):
            strict = {"≤": "<", "≥": ">"}[sign]
            sign = strict if work.model.decide(place, strict, border) else sign
            return Row((look(place), look(border)), (sign,), (place, border), (A1,))
    return None


def _write_meeting(work: Working, relation: Meets) -> None:
    one, other, happens = relation.first.name, relation.second.name, relation.happens
    again = say("again") if relation.again else ""
    if other in work.model.story.spheres:
        claim = say(
            "claim.collide" if happens else "claim.not-collide", one=one, other=other, again=again
        )
    else:
        claim = say(
            "claim.will-hit" if happens else "claim.will-not-hit",
            body=one,
            wall=other,
            again=again,
        )
    work.write("result", sentences=(say("shown.claim", claim=claim),), points=(A1_STAR,))


__all__ = ["explain_extremum", "explain_meets", "explain_range", "explain_shown_bound"]
