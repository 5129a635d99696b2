"""Relations as clauses: ``A is at rest immediately after the collision``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from fractions import Fraction
from typing import TypeGuard

from restitution.counting import counted
from restitution.expression.dimensions import SPEED, Dimension
from restitution.expression.quantities import LOSSES, dimension_of_any
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    has_quantity,
    is_quantity,
    is_rest,
)
from restitution.problem import Aligned, AtRest, Compare, Meets, Relation
from restitution.render import layout as lay
from restitution.wording import values
from restitution.wording.event_nouns import lost_where
from restitution.wording.formulas import cost, formula, noun_phrase, plain
from restitution.wording.moments import same_event
from restitution.wording.noun_phrases import Noun, of_bodies
from restitution.wording.nouns import (
    ends,
    line,
    moment,
    noun,
    place,
    sensed_line,
    somewhere,
    whole_energy,
)
from restitution.wording.scene import INITIALLY, Scene, after, leading
from restitution.wording.setting import moving
from restitution.wording.structure import Emphasis, Words
from restitution.wording.words import listed, words

# What both sides of a relation together may cost in words.
_MOST_OF_TWO = 5.5
# And what stands in words before a formula: a quantity, or its square.
_MOST_BEFORE_A_FORMULA = 2
# With a quantity on the left, in words.
_VERBS = {
    "=": "is ",
    "<": "is less than ",
    "<=": "is at most ",
    ">": "is greater than ",
    ">=": "is at least ",
}
_TURNED: Mapping[str, str] = {"=": "=", "<": ">", "<=": ">=", ">": "<", ">=": "<="}
_ALIGNED = {
    "perpendicular to": " is perpendicular to ",
    "parallel to": " is parallel to ",
    "in the direction of": " is in the direction of ",
    "opposite to": " is in the opposite direction to ",
}


def clause(scene: Scene, relation: Relation) -> Words:
    """A relation as a clause that can follow "that"."""
    match relation:
        case Compare():
            return _compare(scene, relation)
        case Aligned():
            return _aligned(scene, relation)
        case AtRest(body):
            return words(Emphasis(body.name), " is at rest ", after(scene, scene.now, body.name))
        case Meets(first, second, again, happens):
            return _meets(scene, first.name, second.name, again, happens)


def clauses(scene: Scene, relations: Sequence[Relation]) -> list[Words]:
    """Relations as clauses; the velocities of two bodies at one moment are told together."""
    out: list[Words] = []
    rest = list(relations)
    while rest:
        taken = _velocities(scene, rest)
        if len(taken) > 1:
            bodies = [subject.body for subject, _ in taken]
            values_ = listed([value for _, value in taken])
            both = words(of_bodies(taken[0][0].kind, bodies), " ", taken[0][0].when)
            out.append(words(both, " are ", values_, " respectively"))
            rest = rest[len(taken) :]
        else:
            out.append(clause(scene, rest.pop(0)))
    return out


def _velocities(scene: Scene, relations: Sequence[Relation]) -> list[tuple[Noun, Words]]:
    """The first relations, as far as each gives another body's velocity at the same moment."""
    clauses_: list[tuple[Noun, Words]] = []
    for relation in relations:
        match relation:
            case Compare((Quantity("velocity") as moving, value), ("=",)) if not (
                has_quantity(value) or isinstance(value, Polar)
            ):
                subject = noun(scene, moving)
                if clauses_ and (subject.kind, subject.when) != (
                    clauses_[0][0].kind,
                    clauses_[0][0].when,
                ):
                    break
                if not subject.when or subject.body in [one.body for one, _ in clauses_]:
                    break
                clauses_.append((subject, values.value(scene.style, value, SPEED)))
            case _:
                break
    return clauses_


def mathematics(relation: Compare) -> lay.Layout:
    """A relation of letters as one line of mathematics."""
    sides = [values.layout_of(operand) for operand in relation.operands]
    signs = tuple(lay.SIGNS.get(operator, operator) for operator in relation.operators)
    return lay.Relation(tuple(sides), signs)


def to_figures(figures: int | None) -> str:
    """``, correct to 3 significant figures``, or nothing."""
    if figures is None:
        return ""
    return f", correct to {counted(figures, 'significant figure')}"


def _compare(scene: Scene, relation: Compare) -> Words:
    relation = _without_zero(relation)
    operands, operators = relation.operands, relation.operators
    figures = to_figures(relation.figures)
    if not any(has_quantity(operand) for operand in operands):
        return words(mathematics(relation), figures)
    if len(operands) == 2:
        left, right = operands
        sign: str = operators[0]
        if not has_quantity(left) or (sign == "=" and _is_product(left) and _is_quantity(right)):
            left, right, sign = right, left, _TURNED[sign]
        if cost(scene, left) <= _MOST_BEFORE_A_FORMULA and not plain(scene, right):
            (shown,), where = formula(scene, (right,))
            value = values.with_unit(scene.style, shown, dimension_of_any((left,)))
            return words(noun(scene, left).words(), f" {_VERBS[sign]}", value, figures, ", ", where)
        if plain(scene, left, right) and cost(scene, left) + cost(scene, right) <= _MOST_OF_TWO:
            return words(_two(scene, left, sign, right), figures)
    elif plain(scene, *operands):
        return words(_chain(scene, relation), figures)
    formulas, where = formula(scene, operands)
    signs = tuple(lay.SIGNS.get(operator, operator) for operator in operators)
    return words(lay.Relation(tuple(formulas), signs), figures, ", ", where)


def _without_zero(relation: Compare) -> Compare:
    """A difference that is compared with nothing as two things compared."""
    match relation:
        case Compare((Binary("-", left, right), zero), operators, figures) if (
            values.is_zero(zero) or is_rest(zero)
        ) and figures is None:
            return Compare((left, right), operators)
    return relation


def _is_quantity(tree: Expression) -> bool:
    return isinstance(tree, Quantity)


def _is_opposite(tree: Expression) -> TypeGuard[Negate]:
    """Whether an expression is a vector of the motion turned round."""
    return isinstance(tree, Negate) and _is_quantity(tree.operand) and values.is_vector(tree)


def _is_product(tree: Expression) -> bool:
    return isinstance(tree, Binary) and has_quantity(tree)


def _chain(scene: Scene, relation: Compare) -> Words:
    """``the speed of P is at least 5 m s⁻¹ and at most 6 m s⁻¹``."""
    left, middle, right, *more = relation.operands
    if not more and has_quantity(middle) and not (has_quantity(left) or has_quantity(right)):
        return words(noun(scene, middle).words(), " is ", bounds(scene, relation, middle))
    pairs = zip(relation.operands, relation.operators, relation.operands[1:], strict=False)
    sentences = [clause(scene, Compare((one, other), (sign,))) for one, sign, other in pairs]
    return listed(sentences, ", and")


def bounds(scene: Scene, relation: Compare, subject: Expression) -> Words:
    """The other sides of a chain as limits of its subject: ``at least 5 and at most 6``."""
    dimension = dimension_of_any((subject,))
    limits: list[Words] = []
    pairs = zip(relation.operands, relation.operators, relation.operands[1:], strict=False)
    for left, sign, right in pairs:
        other, turned = (right, sign) if left == subject else (left, _TURNED[sign])
        limit = (
            words(noun(scene, other).words())
            if has_quantity(other)
            else _value(scene, other, dimension)
        )
        limits.append(words(_VERBS[turned].removeprefix("is ") or "equal to ", limit))
    return listed(limits)


def _two(scene: Scene, left: Expression, sign: str, right: Expression) -> Words:
    if not has_quantity(left):
        return words(mathematics(Compare((left, right), (sign,))))  # type: ignore[arg-type]
    special = _special(scene, left, sign, right)
    if special is not None:
        return special
    subject = noun(scene, left)
    verb = _VERBS[sign]
    if has_quantity(right):
        if sign == "=" and _is_opposite(right):
            verb, right = "is equal in magnitude and opposite in direction to ", right.operand
        elif sign == "=" and isinstance(right, Quantity):
            verb = "is equal to "
        other = noun(scene, right)
        if subject.when == other.when and subject.when:
            if not subject.kind:
                return words(subject.head, " ", subject.when, f" {verb}", other.head)
            return words(leading(subject.when), subject.head, f" {verb}", other.head)
        return words(subject.words(), f" {verb}", other.words())
    if values.is_zero(right) and sign in "<>":
        return words(subject.words(), " is negative" if sign == "<" else " is positive")
    return words(subject.words(), f" {verb}", _value(scene, right, dimension_of_any((left,))))


def _value(scene: Scene, tree: Expression, dimension: Dimension | None) -> Words:
    if isinstance(tree, Name):
        return (Emphasis(tree.name),)
    return values.value(scene.style, tree, dimension)


def _special(scene: Scene, left: Expression, sign: str, right: Expression) -> Words | None:
    """The clause of a relation that has a phrase of its own."""
    if sign != "=":
        return None
    if has_quantity(right):
        return _share_lost(scene, left, right)
    match left:
        case Quantity("velocity", (Name(body),)) if isinstance(right, Polar):
            when = moment(scene, left, body)
            return words(leading(when), Emphasis(body), " is ", moving(scene, right))
        case Quantity("position", (Name(),)):
            at = place(scene, left)
            if at.when == INITIALLY:
                return words(leading(at.when), at.head, " is at ", values.point(right))
            return words(at.head, " is at ", values.point(right), " ", at.when)
        case Quantity("deflection", (Name(body),)):
            where = noun(scene, left).when
            through = _through(right)
            return words(
                Emphasis(body), " is deflected through ", through, " " if where else "", where
            )
        case Quantity("direction", (Name(body),)) if not scene.is_wall(body):
            when = leading(moment(scene, left, body))
            return words(when, Emphasis(body), " is moving ", values.turned(scene.style, right))
        case Quantity("angle", (Quantity("velocity", (Name(body),)) as velocity, other)) if (
            not is_quantity(other, "velocity")
        ):
            when = moment(scene, velocity, body)
            direction = line(scene, other)
            angle = words("at an angle " if _is_letter(right) else "at an angle of ")
            to = direction.head if same_event(when, direction.when) else direction.words()
            phrase = words(" is moving ", angle, values.layout_of(right), " to ", to)
            return words(leading(when), Emphasis(body), phrase)
    return None


def _share_lost(scene: Scene, left: Expression, right: Expression) -> Words | None:
    """``¼ of the total kinetic energy is lost in the collision``."""
    match left, right:
        case (
            Quantity(kind) as lost,
            Binary("*", factor, Quantity("energy") as whole),
        ) if kind in LOSSES and not has_quantity(factor):
            share = values.times(factor)
            if _is_letter(factor):
                share = words("a fraction ", values.layout_of(factor), " of ")
            base = whole_energy(scene, lost, whole)
            return words(share, base, " is lost", lost_where(scene, lost))
        case Quantity(), Binary("/", Quantity("energy") as whole, Number() as parts):
            one = Number(Fraction(1))
            return _share_lost(scene, left, Binary("*", Binary("/", one, parts), whole))
    return None


def _is_letter(tree: Expression) -> bool:
    return isinstance(tree, Letter)


def _through(angle: Expression) -> Words:
    if _is_letter(angle):
        return words("an angle ", values.layout_of(angle))
    return words("an angle of ", values.layout_of(angle))


def _aligned(scene: Scene, relation: Aligned) -> Words:
    sensed = relation.relation in ("in the direction of", "opposite to")
    if sensed:
        for moving_one, direction in (
            (relation.left, relation.right),
            (relation.right, relation.left),
        ):
            course = _towards(
                scene, moving_one, direction, opposite=relation.relation == "opposite to"
            )
            if course is not None:
                return course
    one, other = (
        _direction_noun(scene, relation.left, sensed),
        _direction_noun(scene, relation.right, sensed),
    )
    verb = _ALIGNED[relation.relation]
    if one.kind == other.kind == "velocity":
        if one.body != other.body and one.when == other.when:
            if relation.relation in ("perpendicular to", "parallel to"):
                how = relation.relation.removesuffix(" to")
                both = of_bodies("velocity", (one.body, other.body))
                return words(both, " ", one.when, f" are {how}")
            return words(one.words(), verb, other.head)
        if one.body == other.body and one.when != other.when:
            return words(one.words(), verb, "its velocity ", other.when)
    if (one.kind, other.kind) == ("velocity", "initial velocity") and one.body == other.body:
        return words(one.words(), verb, "its initial velocity")
    if not one.kind and other.kind and relation.relation in ("perpendicular to", "parallel to"):
        one, other = other, one
    return words(one.words(), verb, other.words())


def _towards(
    scene: Scene, moving_one: Expression, direction: Expression, *, opposite: bool
) -> Words | None:
    """``immediately after the impact S is moving directly towards O``, where that is meant."""
    between = ends(scene, direction)
    match moving_one:
        case Quantity("velocity", (Name(body),), stage) if between is not None and (
            isinstance(stage, int | None)
        ):
            own = [_is_own_place(scene, tree, body, scene.stage(stage, body)) for tree in between]
            if own[0] == own[1]:
                return None
            other = between[1] if own[0] else between[0]
            verb = "towards " if own[0] != opposite else "away from "
            when = leading(moment(scene, moving_one, body))
            to = somewhere(scene, other)
            return words(when, Emphasis(body), f" is moving directly {verb}", to)
    return None


def _is_own_place(scene: Scene, tree: Expression, body: str, number: int) -> bool:
    """Whether a place is that of a body at an event."""
    match tree:
        case Quantity("position", (Name(name),), int() | None as stage):
            return name == body and scene.stage(stage, body) == number
    return False


def _direction_noun(scene: Scene, tree: Expression, sensed: bool) -> Noun:
    if is_quantity(tree, "line_of_centres") and sensed:
        return sensed_line(scene, tree)
    if is_quantity(tree, "velocity"):
        return noun(scene, tree)
    if is_quantity(tree, "impulse") and tree.arguments:
        return noun(scene, tree)
    return line(scene, tree) if plain(scene, tree) else noun_phrase(scene, tree)


def _meets(scene: Scene, first: str, second: str, again: bool, happens: bool) -> Words:
    wall = scene.is_wall(second)
    if not again:
        return words(
            Emphasis(first), " will hit " if happens else " will not hit ", Emphasis(second)
        )
    if wall:
        verb = " hits " if happens else " does not hit "
        return words(Emphasis(first), verb, Emphasis(second), " again")
    verb = " collide again" if happens else " do not collide again"
    return words(Emphasis(first), " and ", Emphasis(second), verb)
