"""Lines that say a law, or that two directions stand in some way to each other."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.explaining.definitions.at_events import WORKED_OUT, nothing
from restitution.explaining.definitions.common import ZERO, axis_of
from restitution.explaining.definitions.journeys import places
from restitution.explaining.definitions.senses import oriented
from restitution.explaining.definitions.ties import is_no_product, is_right_angle, tie_of, ties
from restitution.explaining.definitions.turnings import goes_on_by_its_deflection
from restitution.explaining.laws.principles import RECORDS, Record
from restitution.explaining.lines.derivation import BEARINGS, Event, Link, Relation
from restitution.explaining.lines.quotients import NotComparableError, Plane, Quotient
from restitution.explaining.lines.trees import has_ratio_of_a_sum, settled
from restitution.explaining.moves.bases import expected_residual, matches, may_match
from restitution.explaining.moves.putting import matches_with, points_along
from restitution.explaining.steps.rules import Rules
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Expression,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    Unit,
    is_binary,
    is_function,
    is_quantity,
    quantities_in,
)


def is_law(step: Step, line: Link) -> bool:
    """Whether a line is an instance of the law that its move names.

    The angle between two directions that are given by angles is the difference of these.
    """
    if any(_is_template(step, line, template) for template in _templates(step, line)):
        return True
    if not any(map(has_ratio_of_a_sum, (line.left, line.right))):
        return False
    resolved = step.under(identities=step.identities | {"sum"})
    return any(_is_template(resolved, line, template) for template in _templates(resolved, line))


def _templates(step: Step, line: Link) -> Iterator[Link]:
    """What the record of a move says.

    A ratio of two energies has dozens of forms: those of energies of which the line, or what is
    cited, speaks.
    """
    forms = _forms(step, line)
    if step.move.record == "energy-ratio":
        spoken = _quantities(step, line)
        forms = (
            link
            for link in forms
            if spoken.issuperset(quantities_in(step.setting.quantity(link.left)))
        )
    return map(step.setting.settled, forms)


def _forms(step: Step, line: Link) -> Iterator[Link]:
    """What the record of a move says, in each of its forms."""
    record = RECORDS.get(step.move.record or "")
    event = step.setting.event(step.move.event)
    if record is None or not record.serves(event) or not _take_part(step, record, event):
        return
    for relation in record.relations(event, step.move.bodies):
        for link in relation.only:
            yield _upside_down(link, line) or link
    yield from WORKED_OUT.get(record.id, nothing)(step, event)
    if record.id in ("straight-line", "distance"):
        yield from places(step, event, line)


def _quantities(step: Step, line: Link) -> frozenset[Expression]:
    """The quantities of which a line, or what is cited, speaks."""
    links = [step.setting.settled(link) for link in (line, *step.links)]
    return frozenset(
        quantity
        for link in links
        for side in (link.left, link.right)
        for quantity in quantities_in(side)
    )


def _upside_down(link: Link, line: Link) -> Link | None:
    """The cotangent of an angle by the definition of its tangent, where a line has that."""
    match link, line.left:
        case (
            Link(Apply("tan", angle), "=", Binary("/", above, below)),
            Apply("cot"),
        ):
            return Link(Apply("cot", angle), "=", Binary("/", below, above))
    return None


def _take_part(step: Step, record: Record, event: Event | None) -> bool:
    """Whether the bodies of a move meet in its event, where the record is about who meets."""
    if event is None or (record.kind != "principle" and record.where == "any"):
        return True
    return record.id in WORKED_OUT or set(step.move.bodies) <= set(event.bodies)


def records_of(step: Step) -> Iterator[Link]:
    """What the record of a move says of its event and bodies, form by form."""
    for link in map(step.setting.settled, _forms(step, Link(ZERO, "=", ZERO))):
        yield link
        # Of a ratio, one of the two, as the components point.
        if isinstance(link.left, Apply) and _one_signed(step, link) is not None:
            yield replace(link, right=Negate(link.right))


# Definitions in which components stand as the data have them.
_OF_COMPONENTS = frozenset({"chord", "energy-lost", "energy-change"})


def _is_template(step: Step, line: Link, link: Link) -> bool:
    if step.move.record == "moves-off":
        chosen = step.under(opaque=step.opaque | {link.left})
        return points_along(chosen, line, link, chosen.rules())
    if link.sign in BEARINGS:
        return _is_tied(step, line, link)
    match link.left:
        case Quantity("position", _, AtTime()):
            # The event of the move is where this way begins, and not where it ends.
            step = step.under(move=replace(step.move, event=None))
    try:
        rules = step.rules()
        part = _one_signed(step, link)
        if step.move.record in ("straight-line", "chord"):
            _note_pace(step, link, rules)
        if step.move.record == "straight-line":
            _note_approach(step, rules)
        if part is None:
            expected = expected_residual(step, link, rules)
            if step.move.id == "law" or step.move.record in _OF_COMPONENTS:
                # A chain begins with the ratio of an angle, of which it then puts in the value.
                return matches_with(step, line, expected, rules, link.sign)
            return matches(step, line, expected, link.sign)
        step.world.printed = True
        left, right, above = (
            rules.put_into(step.world.value(tree)) for tree in (link.left, link.right, part)
        )
    except NotComparableError:
        return False
    if isinstance(left, Plane) or isinstance(right, Plane) or isinstance(above, Plane):
        return False
    if isinstance(link.left, Quantity):
        if _is_size_of(step, line, link.left, right):
            return True
        squares = left * left - right * right
        if may_match(step, line, (squares,)) and matches(step, line, squares):
            return True  # the size of an impulse, in whichever sense
    # A sense takes long to decide: it is asked only where either would make the line.
    if not may_match(step, line, (left - right, left + right)):
        worth = step.residual(line, rules)  # with the ratio of an angle, whose value is cited too
        if all(
            step.multiple(worth, difference) is None for difference in (left - right, left + right)
        ):
            return False
    sign = oriented(step, above) or _by_a_deflection(step, link)
    if sign is None and isinstance(link.left, Quantity):
        sign = 1  # the size of an impulse, where the axis points as bodies approach
    if sign is None:
        return False
    return matches_with(step, line, left + right if sign == -1 else left - right, rules, "=")


def _by_a_deflection(step: Step, link: Link) -> int | None:
    """The sign of a tangent's quotient of components, where a deflection that is cited tells it."""
    event = step.setting.event(step.move.event)
    match link:
        case Link(
            Apply("tan", Quantity("angle", (Quantity("velocity", (Name(body),), stage), line))),
            "=",
            Binary("/", across, Quantity("along")),
        ) if event is not None and not event.wall and stage == event.number:
            pass
        case _:
            return None
    if line != axis_of(event):
        return None
    onward = goes_on_by_its_deflection(step, event, body)
    early = Quantity("along", (Quantity("velocity", (Name(body),), event.number - 1), line))
    both = Binary("*", across, step.setting.quantity(early))
    value = step.rules().put_into(step.world.value(both))
    sign = None if onward is None or isinstance(value, Plane) else oriented(step, value)
    return None if sign is None or onward is None else sign * onward


def _is_size_of(step: Step, line: Link, quantity: Quantity, value: Quotient) -> bool:
    """Whether a line says a size to be the one of a value: ``|m(a + ea)|`` of either sign."""
    if (line.left, line.sign) != (quantity, "="):
        return False
    if not is_function(line.right, "abs"):
        return False
    inside = step.rules().put_into(step.world.value(line.right.argument))
    if isinstance(inside, Plane):
        return False
    return step.world.reduced(inside * inside - value * value).vanishes


def _note_pace(step: Step, link: Link, rules: Rules) -> None:
    """What goes some way that is not zero has a speed there that is not zero: it is divided by."""
    match link:
        case Link(distance, "=", Binary("*", pace, _)):
            length, speed = (rules.put_into(step.world.value(tree)) for tree in (distance, pace))
            if isinstance(length, Plane) or isinstance(speed, Plane) or length.vanishes:
                return
            if step.signs.of(length, sure=False) is not None:
                step.world.denominators.append(speed.above)


def _note_approach(step: Step, rules: Rules) -> None:
    """Who comes to a wall along **i** or **j** moves towards it: that component is not zero."""
    event = step.setting.event(step.move.event)
    if event is None or event.kind != "impact" or not event.wall:
        return
    body = Name(event.bodies[0])
    for premise in step.cited:
        if premise.ref != f"contact {event.number}" or not isinstance(premise.relation, Relation):
            continue
        match premise.relation.only[0].left:
            case Quantity("along", (_, Unit() as unit)):
                velocity = Quantity("velocity", (body,), event.number - 1)
                pace = settled(Quantity("along", (velocity, unit)), step.setting.events)
                speed = rules.put_into(step.world.value(pace))
                if isinstance(speed, Quotient) and not speed.vanishes:
                    step.world.denominators.append(speed.above)


def _one_signed(step: Step, link: Link) -> Expression | None:
    """What of a template's right side is not negative, whatever the sense of components.

    Of an angle of at most 90° it is the ratio; of one of up to 180°, what stands above in its
    tangent.
    """
    match link:
        case Link(Apply("tan" | "cot" | "cos" | "sin" as ratio_, Quantity() as angle), "=", right):
            role = step.setting.of_angle(angle)
            if role is None or role.low != 0:
                return None
            if role.high == sp.pi / 2:
                return right
            if ratio_ in ("tan", "cot") and is_binary(right, "/"):
                return right.left if ratio_ == "tan" else right.right
        case Link(Quantity("impulse", ()), "=", right) if not isinstance(right, Apply):
            return right
    return None


def _is_tied(step: Step, line: Link, template: Link) -> bool:
    """Whether two directions are parallel or perpendicular, by their cross or scalar product."""
    chosen = step.under(opaque=step.opaque | {template.left})
    rules = chosen.rules()
    template = _from_rest(chosen, template, rules)
    if line.sign != template.sign:
        return False
    values = []
    for link in (line, template):
        left, right = chosen.world.pointing(link.left), chosen.world.pointing(link.right)
        if link is template:
            right = rules.put_into(right)
        if not (isinstance(left, Plane) and isinstance(right, Plane)):
            return False
        if template.sign == "parallel to":
            values.append(left.x * right.y - left.y * right.x)
        else:
            values.append(left.x * right.x + left.y * right.y)
    own, expected = values
    return chosen.is_multiple(own, expected) is not None


def _from_rest(step: Step, template: Link, rules: Rules) -> Link:
    """The change of a velocity by the direction after it, where that is cited, of who rested."""
    match template.right:
        case Binary("-", Quantity("velocity", (Name() as body,), int(stage)) as late, early):
            before = rules.put_into(step.world.value(early))
            if not (isinstance(before, Plane) and before.x.vanishes and before.y.vanishes):
                return template
        case _:
            return template
    for link in step.links:
        match link:
            case Link(Quantity("direction", (own,), int(event)), "=", angle):
                if (own, event) == (body, stage):
                    return replace(template, right=Polar(Number(Fraction(1)), angle))
            case Link(left, "parallel to" | "perpendicular to" as sign, right) if late in (
                left,
                right,
            ):
                return Link(template.left, sign, right if left == late else left)
    return template


def is_tie(step: Step, line: Link) -> bool:
    """Whether two directions stand to each other as a line says, by the components cited."""
    tie = tie_of(line)
    if tie is None or tie[2] != step.move.record + " to":  # type: ignore[operator]
        return False
    return stands(step, line, step.setting.event(step.move.event))


def stands(step: Step, line: Link, event: Event | None) -> bool:
    """Whether two directions are parallel, or perpendicular, by components at an event."""
    tie = tie_of(line)
    if tie is None:
        return False
    rules = step.rules()
    if is_quantity(line.left, "direction") and line.sign == "=":
        # An angle tells the sense too.
        along = step.setting.settled(Link(Quantity("dot", tie[:2]), ">", ZERO))
        ahead = step.residual(along, rules)
        if not isinstance(ahead, Quotient) or oriented(step, ahead) != 1 or ahead.vanishes:
            return False
    if tie[2] == "perpendicular to" and (
        is_no_product(step, *tie[:2]) or is_right_angle(step, *tie[:2])
    ):
        return True
    for link in ties(step, event, *tie):
        own = step.setting.settled(link)
        before, after = step.residual(own), step.residual(own, rules)
        if before != after and isinstance(after, Quotient) and after.vanishes:
            return True
    return False
