"""A claim that is false in words: what is true instead, or numbers for which it fails."""

from __future__ import annotations

import contextlib
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import sympy as sp

from restitution.exact import same, tidy, tidy_angle
from restitution.explain.kept import simplified
from restitution.explain.phrases import answer
from restitution.explain.quantities import _is_angle, evaluated, plain, quantities_in
from restitution.explaining.printing import look
from restitution.explaining.saying import Sentence, say
from restitution.expression.evaluate import Angle
from restitution.expression.tree import Expression, Name, Quantity
from restitution.oracle import BeyondError, compared
from restitution.problem import Aligned, AtRest, Compare, Extremum, Meets, Relation, Show
from restitution.render import layout as lay
from restitution.render.layout import Layout

if TYPE_CHECKING:
    from restitution.explain.working import Working


def refutation(work: Working, item: Show, given: Mapping[str, str], now: int) -> Sentence:
    """A sentence or two; ``given`` are values of letters for which the claim fails."""
    relation: Relation = item.relation
    match relation:
        case Compare() if item.subject is not None:
            return _no_bound(work, item, relation)
        case Compare():
            return _compared(work, relation, given, now)
        case Meets():
            return _meeting(work, relation, given, now)
        case AtRest(body):
            speed = _velocity(work, body.name, now)
            return say("refuted.rest", body=body.name, velocity=speed)
        case Aligned(left, _, right):
            ways = [
                lay.equation(
                    work.layout(tree), look(plain(work, work.model.story.direction(tree, now)))
                )
                for tree in (left, right)
                if quantities_in(work, tree, now)
            ]
            claim = work.aligned(relation, holds=False)
            letters = any(_symbols(work, tree, now) & set(given) for tree in (left, right))
            if ways:
                return say(
                    "refuted.direction-general-as" if letters else "refuted.direction-as",
                    claim=claim,
                    ways=ways,
                )
            return say("refuted.direction-general" if letters else "refuted.direction", claim=claim)
    raise TypeError(relation)  # pragma: no cover - the kinds of relation are all listed


def _no_bound(work: Working, item: Show, relation: Compare) -> Sentence:
    if isinstance(item.subject, Extremum):
        quantity, *_, value = map(work.layout, relation.operands)
        maximum = item.subject.kind == "maximum"
        return say(
            "refuted.maximum" if maximum else "refuted.minimum", quantity=quantity, value=value
        )
    return say("refuted.range", range=_claim(work, relation))


def claim_of(work: Working, item: Show) -> Layout | None:
    """A claim as mathematics, or None where it is no comparison of quantities."""
    relation: Relation = item.relation
    if isinstance(relation, Compare) and item.subject is None and relation.figures is None:
        return _claim(work, relation)
    return None


def _claim(work: Working, relation: Compare) -> Layout:
    operands = tuple(work.layout(each) for each in relation.operands)
    return lay.Relation(operands, tuple(lay.SIGNS.get(op, op) for op in relation.operators))


def _compared(work: Working, relation: Compare, given: Mapping[str, str], now: int) -> Sentence:
    left, op, right = _failing(work, relation, given, now)
    value = evaluated(work, left, now)
    angle = _angled(work, left, value)
    first, last = work.layout(left), work.layout(right)
    if op == "=" and isinstance(left, Quantity) and not quantities_in(work, right, now):
        found = [each.layout for each in answer(value, angle=angle)]
        if relation.figures is not None:
            # Its exact form stands in the line above.
            found = [_rounded(work, value, evaluated(work, right, now)) or found[-1]]
        value_ = found[0] if len(found) == 1 else lay.equation(*found)
        return say(
            "refuted.vector" if isinstance(first, lay.Bold) else "refuted.value",
            quantity=first,
            claimed=last,
            value=value_,
        )
    used = sorted((_symbols(work, left, now) | _symbols(work, right, now)) & set(given))
    values = [
        lay.equation(lay.letter(name), _number_look(given[name]))
        for name in used
        if _number(given[name]) is not None
    ]
    sides: list[Layout] = []
    for tree in (left, right):
        if quantities_in(work, tree, now) or _symbols(work, tree, now):
            there = _value_at(work, tree, now, given)
            if not isinstance(there, tuple) and there.has(sp.nan, sp.zoo, sp.AccumBounds):
                continue
            shown = [each.layout for each in answer(there, angle=angle)]
            sides.append(lay.equation(work.layout(tree), *shown))
    about = any(quantities_in(work, tree, now) for tree in (left, right)) and sides
    if not about and values:
        return say("refuted.instance", claim=_claim(work, relation), values=values)
    if values:
        return say("refuted.general", claim=_claim(work, relation), values=values, sides=sides)
    return say("refuted.claim", claim=_claim(work, relation), sides=sides)


def _rounded(work: Working, value: Any, claimed: Any) -> Layout | None:
    """A value in numbers, times the letters of what is claimed; None if it holds others."""
    letters = list(sp.sympify(claimed, strict=True).free_symbols)
    if set(value.free_symbols) != set(letters):
        return None
    unit = claimed / claimed.xreplace(dict.fromkeys(letters, sp.Integer(1)))
    one = (value / unit).xreplace(dict.fromkeys(letters, sp.Integer(1)))
    if not work.model.decide(value, "=", one * unit):
        return None
    one = sp.N(one, 20)
    return answer(sp.Rational(str(one)) * unit)[-1].layout


def _failing(
    work: Working, relation: Compare, given: Mapping[str, str], now: int
) -> tuple[Expression, str, Expression]:
    """The first pair of a chain for which the claim fails; the only one of most."""
    pairs = list(zip(relation.operands, relation.operators, relation.operands[1:], strict=False))
    for left, op, right in pairs if len(pairs) > 1 else ():
        a, b = (_at(evaluated(work, tree, now), given) for tree in (left, right))
        if isinstance(a, tuple) or isinstance(b, tuple):
            continue
        with contextlib.suppress(BeyondError):
            if work.model.ground.decide(compared(a, op, b)).answer == "refuted":
                return left, op, right
    return pairs[0]


def _value_at(work: Working, tree: Expression, now: int, given: Mapping[str, str]) -> Any:
    """What a tree is worth with the numbers of the counter-example."""
    value = work.value(tree, now)
    general = _at(evaluated(work, tree, now), given)
    if isinstance(value, Angle):
        x, y = (_at(work.model.in_data(work.put(part)), given) for part in (value.x, value.y))
        # What the counter-example does not name is a scale.
        scale = {s: sp.Integer(1) for s in x.free_symbols | y.free_symbols if s.is_positive}
        x, y = (_real(part.xreplace(scale)) for part in (x, y))
        if x.is_number and y.is_number and (x, y) != (0, 0):
            there = tidy_angle(sp.atan2(y, x))  # in the quadrant that is its own there
            return general if same(general, there) else there
    return general


def _real(x: sp.Expr) -> sp.Expr:
    return tidy(sp.sqrtdenest(sp.radsimp(sp.expand(x)))) if x.is_number else x


def _at(value: Any, given: Mapping[str, str]) -> Any:
    """A value with the numbers of the counter-example for its letters."""
    if isinstance(value, tuple):
        return tuple(_at(each, given) for each in value)
    value = sp.sympify(value, strict=True)
    numbers = {
        each: number
        for each in value.free_symbols
        if each.name in given and (number := _number(given[each.name])) is not None
    }
    return simplified(value.xreplace(numbers)) if numbers else value


def _symbols(work: Working, tree: Expression, now: int) -> set[str]:
    value = evaluated(work, tree, now)
    parts = value if isinstance(value, tuple) else (value,)
    return {each.name for part in parts for each in sp.sympify(part, strict=True).free_symbols}


def _number(text: str) -> sp.Expr | None:
    """A number of a counter-example that was chosen: ``9/10``, ``pi/18``; None for a surd."""
    try:
        number = sp.Rational(text.replace("*pi", "").replace("pi", "1"))
    except (TypeError, ValueError):
        return None
    return number * sp.pi if "pi" in text else number


def instances(given: Mapping[str, str]) -> list[Layout]:
    """The numbers of a counter-example, each with its letter: ``α = 10°``, ``e = 9/10``."""
    return [
        lay.equation(
            lay.letter(name),
            lay.from_tree(_read(text)) if _number(text) is None else _number_look(text),
        )
        for name, text in given.items()
    ]


def _read(text: str) -> Expression:
    # It loads the parser, which a working seldom needs.
    from restitution.expression import read_expression

    return read_expression(text)


def _number_look(text: str) -> Layout:
    return look(_number(text), angle="pi" in text)


def _angled(work: Working, tree: Expression, value: Any) -> bool:
    return not isinstance(value, tuple) and _is_angle(work, tree)


def _velocity(work: Working, body: str, now: int) -> Layout:
    tree = Quantity("velocity", (Name(body),))
    return lay.equation(work.layout(tree), look(evaluated(work, tree, now)))


def _meeting(work: Working, relation: Meets, given: Mapping[str, str], now: int) -> Sentence:
    """``B and C do not collide again, as …``: how they move."""
    one, other = relation.first.name, relation.second.name
    again = say("again") if relation.again else ""
    moving = [name for name in (one, other) if name in work.model.story.spheres]
    velocities = [_velocity(work, name, now) for name in moving]
    values = instances(given)
    several, happens = len(moving) == 2, relation.happens
    if not values:
        if several:
            return say(
                "refuted.collide" if happens else "refuted.not-collide",
                one=one,
                other=other,
                again=again,
                velocities=velocities,
            )
        return say(
            "refuted.hit" if happens else "refuted.not-hit",
            body=moving[0],
            wall=other,
            again=again,
            velocities=velocities,
        )
    if several:
        claim = say(
            "claim.will-collide" if happens else "claim.will-not-collide",
            one=one,
            other=other,
            again=again,
        )
        opposite = say("refuted.they-do-not" if happens else "refuted.they-do")
    else:
        claim = say(
            "claim.will-hit" if happens else "claim.will-not-hit",
            body=moving[0],
            wall=other,
            again=again,
        )
        opposite = say("refuted.it-does-not" if happens else "refuted.it-does")
    return say(
        "refuted.meeting",
        claim=claim,
        velocities=velocities,
        values=values,
        opposite=opposite,
    )
