"""Lines that say a definition: components, speeds, vectors by these."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.definitions.common import ZERO, axis_of
from restitution.explaining.definitions.senses import oriented
from restitution.explaining.definitions.ties import has_product, past_a_right_angle, tie_of
from restitution.explaining.definitions.turnings import is_given_angle
from restitution.explaining.lines.derivation import Event, Link, Meaning
from restitution.explaining.lines.quotients import CONSTANT, Plane, Quotient
from restitution.explaining.moves.angles_of_lines import (
    is_angle_of_a_multiple,
    is_angle_of_lines,
    is_tangent_of_a_line,
)
from restitution.explaining.moves.bases import FLIPPED
from restitution.explaining.moves.laws import is_law, is_tie
from restitution.explaining.steps.step import Step, alike
from restitution.expression.tree import (
    COMPONENTS,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Polar,
    Quantity,
    has_quantity,
    is_function,
)

# What is a component, a vector put together, or a product of vectors, by their values.
_RESOLVED: Mapping[str | None, tuple[str, ...]] = {
    "component": ("along", "across", "dot"),
    "assemble": ("velocity", "position"),
    "relative-velocity": (),
    "product": ("dot",),
}


def is_definition(step: Step, line: Link) -> bool:
    """Whether a line says the definition that its move names."""
    if step.move.record == "turned":
        return _is_turned(step, line) or _is_aimed(step, line)
    if step.move.record == "component" and _is_whole_speed(step, line):
        return True
    if step.move.record in _RESOLVED or _is_size(step, line.left):
        return _is_resolved(step, line)
    if step.move.record in ("perpendicular", "parallel") and is_angle_of_lines(step, line):
        return True
    past = past_a_right_angle(line) if step.move.record == "perpendicular" else None
    if past is not None and has_product(step, *past):
        return True
    if step.move.record == "parallel" and (
        is_tangent_of_a_line(step, line) or is_angle_of_a_multiple(step, line)
    ):
        return True
    if step.move.record in ("perpendicular", "parallel") and tie_of(line) is not None:
        return is_tie(step, line)
    if step.move.record == "speed" and (_is_read_off(step, line) or _is_component(step, line)):
        return True
    if step.move.record == "difference" and is_given_angle(step, line):
        return True
    return is_law(step, line)


def _is_turned(step: Step, line: Link) -> bool:
    """A velocity by its size and direction, or the angle through which one along **i** is turned.

    To which side, a cited inequality tells. Where a line may be on either side of **i**, it is on
    that of **j**: there the first sphere is turned away from it, and so is not who hits a wall.
    """
    event = step.setting.event(step.move.event)
    if event is None or line.sign != "=" or len(step.move.bodies) != 1:
        return False
    body = Name(step.move.bodies[0])
    values = {link.left: link.right for link in step.links if link.sign == "="}
    early = values.get(step.setting.quantity(Quantity("velocity", (body,), event.number - 1)))
    size = values.get(Quantity("speed", (body,), event.number))
    angle = values.get(Quantity("deflection", (body,), event.number))
    if line.left != Quantity("velocity", (body,), event.number):
        return False
    if angle is None and size is not None:
        pointed = Quantity("direction", (body,), event.number) in values
        resolved = step.under(move=replace(step.move, record="assemble"))
        return pointed and _is_resolved(resolved, line)
    if early is None:
        return False
    if size is None or angle is None:
        return False
    before, after = step.world.value(early), step.world.value(line.right)
    if not (isinstance(before, Plane) and isinstance(after, Plane) and before.y.vanishes):
        return False
    if before.x.vanishes or step.signs.of(before.x) != 1:
        return False
    side = _side_of(step, event, body)
    if side is None:
        return False
    there = step.world.value(Polar(size, angle))
    if not isinstance(there, Plane):
        return False
    y = there.y if side > 0 else CONSTANT(0) - there.y
    return (
        step.world.reduced(there.x - after.x).vanishes and step.world.reduced(y - after.y).vanishes
    )


def _is_aimed(step: Step, line: Link) -> bool:
    """A velocity by its size and the way from one place to another, which no event is between."""
    match line.left:
        case Quantity("velocity", (Name() as body,), int(stage)) if line.sign == "=":
            pass
        case _:
            return False
    number = step.move.event
    values = {link.left: link.right for link in step.links if link.sign == "="}
    size = values.get(Quantity("speed", (body,), stage))
    ends = [values.get(Quantity("position", (body,), at)) for at in (stage, number)]
    if size is None or None in ends or number is None or number <= stage:
        return False
    between = (step.setting.event(index) for index in range(stage + 1, number))
    if any(event is None or body.name in event.bodies for event in between):
        return False
    here, there, after = (step.world.value(tree) for tree in (*ends, line.right) if tree)
    fast = step.world.value(size)
    if not (isinstance(here, Plane) and isinstance(there, Plane) and isinstance(after, Plane)):
        return False
    if not isinstance(fast, Quotient):
        return False
    x, y = there.x - here.x, there.y - here.y
    beside = after.x * y - after.y * x
    square = after.x * after.x + after.y * after.y - fast * fast
    ahead = step.world.reduced(after.x * x + after.y * y)
    return (
        step.world.reduced(beside).vanishes
        and step.world.reduced(square).vanishes
        and not ahead.vanishes
        and step.signs.of(ahead, sure=True) == 1
    )


def _side_of(step: Step, event: Event, body: Name) -> int | None:
    """1 where a velocity after an event is on the side of **j**, −1 on the other, None if open."""
    direction = Quantity("direction", (body,), event.number)
    for link in step.links:
        for side, other, sign in (
            (link.left, link.right, link.sign),
            (link.right, link.left, FLIPPED.get(link.sign, "")),
        ):
            if side == direction and other in (ZERO, Degrees(Fraction(0))) and sign in ("<", ">"):
                return 1 if sign == ">" else -1
            if side == Quantity("impulse", (body,), event.number) and sign == "=":
                # Across its path it had no velocity before: the impulse alone gives it one.
                push = step.world.value(other)
                if isinstance(push, Plane) and (own := step.signs.of(push.y, sure=True)):
                    return own
    if not event.wall:
        # The impulse on the second sphere is along the line of centres, on the first it is back.
        along = step.world.direction(Quantity("line_of_centres", (), event.number))
        own = None if along is None else step.signs.of(along.y, sure=True)
        if own:
            return -own if body.name == event.bodies[0] else own
    if event.number in step.setting.either:
        return 1 if event.wall or body.name != event.bodies[0] else -1
    return None


def _is_read_off(step: Step, line: Link) -> bool:
    """A speed by a velocity that is given by its size and an angle."""
    for link in step.links:
        match link:
            case Link(Quantity("velocity", arguments, stage), "=", Polar(size)):
                if line.sign != "=" or line.left != Quantity("speed", arguments, stage):
                    continue
                known, right = (step.world.scalar(tree) for tree in (size, line.right))
                if (known - right).vanishes and step.signs.of(known) == 1:
                    return True
    return _is_of_a_multiple(step, line)


def _is_of_a_multiple(step: Step, line: Link) -> bool:
    """A speed by a velocity that is a multiple of another one, which is given by its size."""
    sizes = {link.left: link.right.size for link in step.links if isinstance(link.right, Polar)}
    for link in step.links:
        match link:
            case Link(Quantity("velocity") as own, "=", Negate(Binary("*", factor, other))) | Link(
                Quantity("velocity") as own, "=", Binary("*", factor, other)
            ) if other in sizes and line.sign == "=" and line.left == replace(own, kind="speed"):
                size, right = Binary("*", factor, sizes[other]), line.right
                known, value = (step.world.scalar(tree) for tree in (size, right))
                same = (known - value).vanishes or (known + value).vanishes
                if same and (value.vanishes or oriented(step, value) == 1):
                    return True
    return False


def _is_component(step: Step, line: Link) -> bool:
    """A speed as the size of one component of certain sign, where the other is zero.

    With roots of letters in it the component is not seen in the root of its square.
    """
    event = step.setting.event(step.move.event)
    if event is None or line.sign != "=" or len(step.move.bodies) != 1:
        return False
    velocity = Quantity("velocity", (Name(step.move.bodies[0]),), event.number)
    if line.left != replace(velocity, kind="speed"):
        return False
    rules = step.rules()
    parts = [
        rules.put_into(step.world.value(Quantity(kind, (velocity, axis_of(event)))))
        for kind in COMPONENTS
    ]
    right = step.world.value(line.right)
    for own, other in (parts, parts[::-1]):
        match own, other, right:
            case Quotient(), Quotient(), Quotient() if other.vanishes:
                pass
            case _:
                continue
        for size in (right - own, right + own):
            if step.world.reduced(size).vanishes and step.signs.of(right) == 1:
                return True
    return False


def _is_whole_speed(step: Step, line: Link) -> bool:
    """A component as a speed: of what strikes a wall at right angles, or goes off from rest.

    The second sphere of an impact, if it was at rest, moves in the sense from the first one to it.
    """
    event = step.setting.event(step.move.event)
    own = next((e.quantity for e in step.lets if Letter(e.letter) == line.left), line.left)
    match own:
        case Quantity(
            "along", (Quantity("velocity", (Name(body),) as sphere, int(stage)) as velocity, axis)
        ):
            pass
        case _:
            return False
    if event is None or line.sign != "=" or axis != axis_of(event):
        return False
    values = {link.left: link.right for link in step.links if link.sign == "="}
    before = step.setting.quantity(Quantity("velocity", sphere, event.number - 1))
    if event.wall:
        if body != event.bodies[0] or velocity != before:
            return False
    elif body != event.bodies[-1] or stage != event.number or not _is_rest(step, values, before):
        return False
    beside = values.get(Quantity("across", (velocity, axis)))
    speed = values.get(Quantity("speed", sphere, stage))
    if beside is None or speed is None:
        return False
    if not step.world.reduced(step.world.scalar(beside)).vanishes:
        return False
    forms = [speed]
    while forms[-1] in values and len(forms) <= len(step.links):
        forms.append(values[forms[-1]])  # what a chain comes to
    right = step.world.scalar(line.right)
    return any(step.world.reduced(step.world.scalar(form) - right).vanishes for form in forms)


def _is_rest(step: Step, values: Mapping[Expression, Expression], velocity: Expression) -> bool:
    """Whether a velocity is cited as zero."""
    known = step.world.value(values[velocity]) if velocity in values else None
    return isinstance(known, Plane) and known.x.vanishes and known.y.vanishes


def _is_size(step: Step, tree: Expression) -> bool:
    """Whether a line gives the size of a vector as such: |**a** − **b**|."""
    return step.move.record == "size" and is_function(tree, "abs")


def _is_relative(tree: Expression) -> bool:
    """Whether a tree is the velocity of one body relative to another."""
    match tree:
        case Binary("-", Quantity("velocity", (Name(),)), Quantity("velocity", (Name(),))):
            return True
    return False


def _is_resolved(step: Step, line: Link) -> bool:
    """A component by a vector, or a vector by its components: the value is what is cited."""
    quantity = line.left
    if isinstance(quantity, Letter):
        meaning = next((let for let in step.lets if let.letter == quantity.name), None)
        if meaning is None or meaning.sense is not None:
            return False
        quantity = meaning.quantity
    kinds = _RESOLVED.get(step.move.record, ())
    known = isinstance(quantity, Quantity) and quantity.kind in kinds
    known = known or (step.move.record == "relative-velocity" and _is_relative(quantity))
    if line.sign != "=" or not (known or _is_size(step, quantity)):
        return False
    others = tuple(
        premise
        for premise in step.cited
        if not (
            isinstance(premise.relation, Meaning)
            and premise.relation.quantity == quantity
            and (premise.relation.sense is None or quantity != line.left)
        )
    )
    rules = step.rules(others)
    value, right = alike(step.world.value(quantity), step.world.value(line.right))
    resolved = rules.put_into(value)
    if resolved == value:
        return False
    if not has_quantity(line.right):
        right = rules.put_into(right)
    if isinstance(resolved, Plane) and isinstance(right, Quotient) and right.vanishes:
        right = Plane(right, right)  # at rest
    if isinstance(resolved, Plane) and isinstance(right, Plane):
        pairs = [(resolved.x, right.x), (resolved.y, right.y)]
    elif isinstance(resolved, Quotient) and isinstance(right, Quotient):
        pairs = [(resolved, right)]
    else:
        return False
    return all(step.world.reduced(a - b).vanishes for a, b in pairs)
