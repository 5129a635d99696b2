"""The moves: what each makes of its premises, and whether a line is that.

A line is right if its residual (left minus right) is k times the expected one, and k is certain
not to be zero; for an inequality, the sign of k must be known. So equations need no prover, and a
step is one move long: that a line is true, or a consequence, does not make it right.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.explaining.algebra import CONSTANT, NotComparableError, Plane, Quotient, Value
from restitution.explaining.definitions import (
    WORKED_OUT,
    ZERO,
    is_no_product,
    nothing,
    places,
    tie_of,
    ties,
)
from restitution.explaining.derivation import Event, Link, Meaning, MoveId, Relation, Sign, whole_of
from restitution.explaining.principles import RECORDS, Record
from restitution.explaining.rules import Rules
from restitution.explaining.senses import oriented
from restitution.explaining.solving import solves
from restitution.explaining.step import Cited, Step, alike
from restitution.explaining.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    letters,
    rational,
    walk,
)
from restitution.oracle import REAL, Oracle, compared
from restitution.oracle import Relation as Claim

FLIPPED: Mapping[str, str] = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "=": "=", "!=": "!="}
_RATIOS = ("sin", "cos", "tan")
_IDENTITIES: Mapping[str, frozenset[Any]] = {
    "pythagoras": frozenset({"pythagoras"}),
    "double-angle": frozenset({"double-angle"}),
    "half-angle": frozenset({"half-angle"}),
    "sum-of-angles": frozenset({"sum"}),
    "complement": frozenset({"complement"}),
}


def follows(step: Step, relation: Relation) -> bool:
    """Whether a relation is what the move makes of what is cited.

    Raises NotComparableError where that is beyond what is compared.
    """
    if step.move.record == "either-side":
        return _on_either_side(step, relation)
    if step.move.id == "put" and (case := _condition(relation)) is not None:
        return _under_condition(step, *case)
    whole = _WHOLE.get(step.move.id)
    if whole is not None:
        return whole(step, relation)
    return _by_links(step, relation)


def _on_either_side(step: Step, relation: Relation) -> bool:
    """What a line says of a direction or a vector, or else the same mirrored along **i**."""
    number = step.move.event
    if number not in step.setting.either or [len(option) for option in relation.options] != [1, 1]:
        return False
    (first,), (second,) = relation.options
    axis = first.left
    if _is_line_of(step, axis, number) and first.sign == "parallel to":
        angle = step.world.directions.get(axis)
        if angle is None or not _is_along(step, first, angle):
            return False
        own: Link | None = first
    else:
        base = _base(step)
        if len(step.cited) != 1 or base is None or len(base.options) != 1:
            return False
        own = whole_of(base.only)
    if own is None or own != first or (second.left, second.sign) != (own.left, own.sign):
        return False
    meaning = step.setting.meanings.get(getattr(own.left, "name", ""))
    match own.left if meaning is None else meaning.quantity:
        case Quantity("direction", (Name(),), int()):
            one, other = (_in_radians(step, each.right) for each in (first, second))
            return bool(one + other == 0)
        case (
            Quantity("velocity" | "line_of_centres")
            | Quantity("impulse", (Name(),))
            | Quantity("direction", (Name(),), None)
        ):
            a, b = (step.world.value(each.right) for each in (first, second))
            return (
                isinstance(a, Plane)
                and isinstance(b, Plane)
                and (a.x - b.x).vanishes
                and (a.y + b.y).vanishes
            )
    return False


def _is_line_of(step: Step, tree: Expression, number: int | None) -> bool:
    """Whether a tree is the line of centres of an event, or its wall."""
    event = step.setting.event(number)
    if event is None:
        return False
    wall = Quantity("direction", (Name(event.bodies[-1]),))
    return tree == (wall if event.wall else Quantity("line_of_centres", (), number))


def _is_along(step: Step, line: Link, angle: Expression) -> bool:
    """Whether a line gives the direction at an angle, with what is cited put in, by a vector."""
    chosen = step.under(opaque=step.opaque | {line.left})
    own = chosen.world.pointing(line.right)
    there = chosen.rules().put_into(chosen.world.unit(angle))
    if not (isinstance(own, Plane) and isinstance(there, Plane)):
        return False
    if not chosen.world.reduced(own.x * there.y - own.y * there.x).vanishes:
        return False
    return not there.x.vanishes and not own.x.vanishes and chosen.signs.of(own.x / there.x) == 1


def _condition(relation: Relation) -> tuple[Link, Link] | None:
    """The place and the value of "x ≠ a or y = b", which says that y is b where x is a."""
    if len(relation.options) != 2 or any(len(links) != 1 for links in relation.options):
        return None
    (unless,), (then,) = relation.options
    if unless.sign != "!=" or then.sign != "=":
        return None
    return Link(unless.left, "=", unless.right), then


def _under_condition(step: Step, place: Link, then: Link) -> bool:
    if not (isinstance(place.left, Letter) and place.left.name in step.setting.angles):
        chosen = step.under(cited=(*step.cited, Cited("", Relation(((place,),)))))
        try:
            if any(
                _by_links(chosen, Relation(((with_square,),)))
                for with_square in _with_squares(chosen, then)
            ):
                return True
        except NotComparableError:
            pass  # it may still be compared at the place itself
    return _at_place(step, place, then)


def _with_squares(step: Step, then: Link) -> Iterator[Link]:
    """An equation, and that of the squares of both sides where both are positive."""
    yield then
    sides = [step.world.value(each) for each in (then.left, then.right)]
    if all(isinstance(side, Quotient) and step.signs.of(side) == 1 for side in sides):
        two = Number(Fraction(2))
        yield Link(Binary("^", then.left, two), "=", Binary("^", then.right, two))


def _at_place(step: Step, place: Link, then: Link) -> bool:
    """Whether an equation has a value where a letter has one, perhaps at an end of its range.

    The place may be told by the tangent of an angle.
    """
    base = _base(step)
    equation = None if base is None or len(base.options) != 1 else _ends(base.only)
    meant: dict[Expression, Expression] = {Letter(e.letter): e.quantity for e in step.lets}
    if equation is None or then.left not in (
        equation.left,
        rebuilt(equation.left, lambda each: meant.get(each, each)),
    ):
        return False
    match place.left:
        case Letter(name):
            at = step.world.expression(step.world.scalar(place.right), step.roles)
        case Binary("/", Number(1), Letter(name)) if place.right == ZERO:
            at = sp.oo
        case Apply("tan", Letter(name)):
            tangent = step.world.expression(step.world.scalar(place.right), step.roles)
            at = sp.atan(tangent)
        case _:
            return False
    value, own = (
        step.world.expression(step.world.scalar(each), step.roles)
        for each in (equation.right, then.right)
    )
    value = value.xreplace(_by_their_tangents(step, value))
    letter = next((symbol for symbol in value.free_symbols if symbol.name == name), None)
    if letter is None:
        return False
    there = _worth_at(value, letter, at)
    if there is None:
        return False
    return _equal_in(step, there, own) or _equal_in(step, there, own, _not_negative(step, there))


def _not_negative(step: Step, value: sp.Expr) -> tuple[Claim, ...]:
    """What is cited of letters of which an expression has the size."""
    symbols = {s for each in value.atoms(sp.Abs) for s in each.free_symbols}
    return tuple(Claim(s, ">=") for s in symbols if s.name in step.world.nonnegative)


def _by_their_tangents(step: Step, value: sp.Expr) -> dict[sp.Symbol, sp.Expr]:
    """The angles of up to 90° in an expression of which the tangents are cited, by these."""
    tangents: dict[sp.Symbol, sp.Expr] = {}
    for symbol in value.free_symbols:
        role = step.setting.role(symbol.name)
        if role.kind != "angle" or role.low != 0 or role.high != sp.pi / 2:
            continue
        for link in step.links:
            if link.sign == "=" and link.left == Apply("tan", Letter(symbol.name)):
                tangents[symbol] = sp.atan(_in_radians(step, _last_side(step, link)))
    return tangents


def _last_side(step: Step, link: Link) -> Expression:
    """The last side of the chain in which a link is cited."""
    for each in step.cited:
        if isinstance(each.relation, Relation) and link in each.relation.options[0]:
            return each.relation.options[0][-1].right
    return link.right


def _worth_at(value: sp.Expr, letter: sp.Symbol, at: Any) -> sp.Expr | None:
    """What an expression is worth where a letter has a value, or beyond all values of it.

    None where it has no value there.
    """
    if at is sp.oo:
        if not value.is_rational_function(letter):
            return None
        small = sp.Dummy("t")
        value = sp.cancel(sp.together(value.subs(letter, 1 / small)), small)
        letter, at = small, sp.Integer(0)
    if at == sp.pi / 2:
        value = _towards_a_right_angle(value, letter)
    there = value.subs(letter, at)
    return None if there.is_finite is False or there.has(sp.nan) else there


def _towards_a_right_angle(value: sp.Expr, letter: sp.Symbol) -> sp.Expr:
    """An expression in which arctan(k tan x) is 90°, as it is where x is, for a positive k."""
    cotangent = sp.cos(letter) / sp.sin(letter)
    return value.replace(
        lambda x: isinstance(x, sp.atan) and sp.cancel(x.args[0] * cotangent).is_positive,
        lambda _: sp.pi / 2,
    )


def _by_links(step: Step, relation: Relation) -> bool:
    """Each link by itself; a later link of a chain from the one before it."""
    bases = _bases(step)
    if len(relation.options) != max(1, len(bases)):
        return False
    for number, links in enumerate(relation.options):
        chosen = step if len(bases) < 2 else _with_base(step, bases[number])
        if not _chain(chosen, links):
            return False
    return True


def _chain(step: Step, links: tuple[Link, ...]) -> bool:
    before: Link | None = None
    subject: Expression | None = None
    for link in links:
        if before is not None and before.right == link.left and subject is not None:
            base = Relation(((Link(subject, before.sign, before.right),),))
            move = replace(step.move, id=link.by or "put")
            if link.by == "identity" and move.record not in _IDENTITIES:
                move = replace(move, record="pythagoras")
            after = step.under(move=move, cited=(Cited("", base), *step.cited))
            own = Link(subject, link.sign, link.right)
        else:
            after, own, subject = step, link, link.left
        follows_ = _LINKS.get(after.move.id)
        if follows_ is not None:
            right = follows_(after, own)
        else:
            right = _WHOLE[after.move.id](after, Relation(((own,),)))
        if not right:
            return False
        before = link
    return True


def _bases(step: Step) -> tuple[tuple[Link, ...], ...]:
    """The alternatives of the line that a move starts from."""
    if step.move.id not in ("put", "rearrange", "cancel", "identity"):
        return ()
    first = _base(step)
    return () if first is None else first.options


def _base(step: Step) -> Relation | None:
    return next((e.relation for e in step.cited if isinstance(e.relation, Relation)), None)


def _with_base(step: Step, links: tuple[Link, ...]) -> Step:
    first = next(e for e in step.cited if isinstance(e.relation, Relation))
    chosen = tuple(
        Cited(each.ref, Relation((links,))) if each is first else each for each in step.cited
    )
    return step.under(cited=chosen)


def _from_base(step: Step) -> Step:
    """The step, in which an angle that the first line gives is not yet put in."""
    base = _base(step)
    own = {
        link.left
        for links in (() if base is None else base.options)
        for link in links
        if link.left in step.world.turns
    }
    return step.under(opaque=step.opaque | own) if own else step


def _without_angles(step: Step) -> Step:
    """The step in which no line beside the first says what an angle is."""
    base = _base(step)
    kept = [
        each
        for each in step.cited
        if each.relation is base
        or isinstance(each.relation, Meaning)
        or not any(link.left in step.world.turns for link in _links(each.relation))
    ]
    return step.under(cited=tuple(kept)) if len(kept) < len(step.cited) else step


def _links(relation: Relation) -> list[Link]:
    return [link for links in relation.options for link in links]


def _rest(step: Step) -> tuple[Cited, ...]:
    """What is cited beside the line that a move starts from."""
    first = next((e for e in step.cited if isinstance(e.relation, Relation)), None)
    return tuple(each for each in step.cited if each is not first)


# --- one residual against another ----------------------------------------------------------------


def _matches(step: Step, line: Link, expected: Value, sign: Sign = "=") -> bool:
    """Whether a line says the expected residual to stand in that relation to zero."""
    if sign in ("parallel to", "perpendicular to"):
        return False
    step.world.printed = False
    own = step.residual(line)
    step.world.note_tangents(own)
    if sign == "≈":
        gap = _plus(own, _times(expected, CONSTANT(-1)))
        return line.sign == sign and isinstance(gap, Quotient) and gap.vanishes
    parted = step.move.id in ("rearrange", "fact")
    if isinstance(expected, Plane) and isinstance(own, Quotient) and parted:
        # What stands with i, or with j, on both sides.
        parts = (expected.x, expected.y)
        return sign == line.sign == "=" and any(
            step.is_multiple(own, part) is not None for part in parts
        )
    if sign == "=" or sign == "!=":
        return line.sign == sign and step.is_multiple(own, expected) is not None
    k = step.is_multiple(own, expected, sign=True)
    return k is not None and line.sign == (sign if k == 1 else FLIPPED[sign])


def _expected(step: Step, link: Link, rules: Rules) -> Value:
    step.world.printed = True
    if link.sign in ("parallel to", "perpendicular to"):
        return CONSTANT(0)
    return step.residual(link, rules)


def _law(step: Step, line: Link) -> bool:
    return any(_is_template(step, line, template) for template in _templates(step, line))


def _templates(step: Step, line: Link) -> Iterator[Link]:
    """What the record of a move says."""
    record = RECORDS.get(step.move.record or "")
    event = step.setting.event(step.move.event)
    if record is None or not record.serves(event) or not _take_part(step, record, event):
        return
    for relation in record.relations(event, step.move.bodies):
        for link in relation.only:
            yield step.setting.settled(link)
    for link in WORKED_OUT.get(record.id, nothing)(step, event):
        yield step.setting.settled(link)
    if record.id in ("straight-line", "distance"):
        for link in places(step, event, line):
            yield step.setting.settled(link)


def _take_part(step: Step, record: Record, event: Event | None) -> bool:
    """Whether the bodies of a move meet in its event, where the record is about who meets."""
    if event is None or (record.kind != "principle" and record.where == "any"):
        return True
    return record.id in WORKED_OUT or set(step.move.bodies) <= set(event.bodies)


def records_of(step: Step) -> Iterator[Link]:
    """What the record of a move says of its event and bodies, form by form."""
    for link in _templates(step, Link(ZERO, "=", ZERO)):
        yield link
        # Of a ratio, one of the two, as the components point.
        if isinstance(link.left, Apply) and _one_signed(step, link) is not None:
            yield replace(link, right=Negate(link.right))


def _is_template(step: Step, line: Link, link: Link) -> bool:
    if step.move.record == "moves-off":
        chosen = step.under(opaque=step.opaque | {link.left})
        return _points_along(chosen, line, link, chosen.rules())
    if link.sign in ("parallel to", "perpendicular to"):
        return _is_tied(step, line, link)
    match link.left:
        case Quantity("position", _, AtTime()):
            # The event of the move is where this way begins, and not where it ends.
            step = step.under(move=replace(step.move, event=None))
    try:
        rules = step.rules()
        part = _one_signed(step, link)
        if step.move.record == "straight-line":
            _note_pace(step, link, rules)
        if part is None:
            expected = _expected(step, link, rules)
            if step.move.id == "law" or step.move.record == "chord":
                # A chain begins with the ratio of an angle, of which it then puts in the value.
                return _matches_with(step, line, expected, rules, link.sign)
            return _matches(step, line, expected, link.sign)
        step.world.printed = True
        left, right, above = (
            rules.put_into(step.world.value(each)) for each in (link.left, link.right, part)
        )
    except NotComparableError:
        return False
    if isinstance(left, Plane) or isinstance(right, Plane) or isinstance(above, Plane):
        return False
    sign = oriented(step, above)
    if sign is None and isinstance(link.left, Quantity):
        sign = 1  # the size of an impulse, where the axis points as bodies approach
    if sign is None:
        return False
    return _matches(step, line, left + right if sign == -1 else left - right)


def _note_pace(step: Step, link: Link, rules: Rules) -> None:
    """What goes some way that is not zero has a speed there that is not zero: it is divided by."""
    match link:
        case Link(way, "=", Binary("*", pace, _)):
            length, speed = (rules.put_into(step.world.value(each)) for each in (way, pace))
            if isinstance(length, Plane) or isinstance(speed, Plane) or length.vanishes:
                return
            if step.signs.of(length, sure=False) is not None:
                step.world.denominators.append(speed.above)


def _one_signed(step: Step, link: Link) -> Expression | None:
    """What of a template's right side is not negative, whatever the sense of components.

    Of an angle of at most 90° it is the ratio; of one of up to 180°, what stands above in its
    tangent.
    """
    match link:
        case Link(Apply("tan" | "cos" | "sin" as ratio_, Quantity() as angle), "=", right):
            role = step.setting.of_angle(angle)
            if role is None or role.low != 0:
                return None
            if role.high == sp.pi / 2:
                return right
            if ratio_ == "tan" and isinstance(right, Binary) and right.op == "/":
                return right.left
        case Link(Quantity("impulse", ()), "=", right) if not isinstance(right, Apply):
            return right
    return None


def _is_tied(step: Step, line: Link, template: Link) -> bool:
    """Of two directions: parallel or perpendicular, by cross or scalar product."""
    if line.sign != template.sign:
        return False
    chosen = step.under(opaque=step.opaque | {template.left})
    rules = chosen.rules()
    template = _from_rest(chosen, template, rules)
    values = []
    for each in (line, template):
        left, right = chosen.world.pointing(each.left), chosen.world.pointing(each.right)
        if each is template:
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
            case Link(left, "parallel to", right) if late in (left, right):
                return replace(template, right=right if left == late else left)
    return template


def _is_tie(step: Step, line: Link) -> bool:
    """Whether two directions stand to each other as a line says, by the components cited."""
    tie = tie_of(line)
    event = step.setting.event(step.move.event)
    if tie is None or tie[2] != step.move.record + " to":  # type: ignore[operator]
        return False
    rules = step.rules()
    if isinstance(line.left, Quantity) and line.left.kind == "direction" and line.sign == "=":
        # An angle tells the sense too.
        along = step.setting.settled(Link(Quantity("dot", tie[:2]), ">", ZERO))
        ahead = step.residual(along, rules)
        if not isinstance(ahead, Quotient) or oriented(step, ahead) != 1 or ahead.vanishes:
            return False
    if tie[2] == "perpendicular to" and is_no_product(step, *tie[:2]):
        return True
    for link in ties(step, event, *tie):
        own = step.setting.settled(link)
        before, after = step.residual(own), step.residual(own, rules)
        if before != after and isinstance(after, Quotient) and after.vanishes:
            return True
    return False


# What is a component, a vector put together, or a product of vectors, by their values.
_RESOLVED: Mapping[str | None, tuple[str, ...]] = {
    "component": ("along", "across"),
    "assemble": ("velocity", "position"),
    "product": ("dot",),
}


def _define(step: Step, line: Link) -> bool:
    if step.move.record == "turned":
        return _is_turned(step, line)
    if step.move.record in _RESOLVED or _is_size(step, line.left):
        return _is_resolved(step, line)
    if step.move.record in ("perpendicular", "parallel") and tie_of(line) is not None:
        return _is_tie(step, line)
    return (step.move.record == "speed" and _is_read_off(step, line)) or _law(step, line)


def _is_turned(step: Step, line: Link) -> bool:
    """A velocity by its size and the angle through which one along **i** has been turned.

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
    if line.left != Quantity("velocity", (body,), event.number) or early is None:
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
                known, right = (step.world.scalar(each) for each in (size, line.right))
                if (known - right).vanishes and step.signs.of(known) == 1:
                    return True
    return False


def _is_size(step: Step, tree: Expression) -> bool:
    """Whether a line gives the size of a vector as such: |**a** − **b**|."""
    return step.move.record == "size" and isinstance(tree, Apply) and tree.function == "abs"


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
    if line.sign != "=" or not (known or _is_size(step, quantity)):
        return False
    others = tuple(
        each
        for each in step.cited
        if not (isinstance(each.relation, Meaning) and each.relation.quantity == quantity)
    )
    rules = step.rules(others)
    value, right = alike(step.world.value(quantity), step.world.value(line.right))
    resolved = rules.put_into(value)
    if resolved == value:
        return False
    if isinstance(resolved, Plane) and isinstance(right, Quotient) and right.vanishes:
        right = Plane(right, right)  # at rest
    if isinstance(resolved, Plane) and isinstance(right, Plane):
        pairs = [(resolved.x, right.x), (resolved.y, right.y)]
    elif isinstance(resolved, Quotient) and isinstance(right, Quotient):
        pairs = [(resolved, right)]
    else:
        return False
    return all(step.world.reduced(a - b).vanishes for a, b in pairs)


# --- from one line -------------------------------------------------------------------------------


def _put(step: Step, line: Link) -> bool:
    step = _from_base(step)
    base = _base(step)
    if base is None or len(base.options) != 1:
        return False
    if step.move.id == "put" and len(step.cited) < 2:
        return False
    if step.move.id == "fact" and line.sign in ("parallel to", "perpendicular to"):
        return line in base.only  # a direction is printed as it is given
    rules = step.rules(_rest(step))
    if line.sign == "parallel to":
        return any(_points_along(step, line, each, rules) for each in base.only)
    alone = _without_angles(step)
    if step.move.id == "put" and any(
        _matches(alone, line, expected, each.sign)
        and (each.sign == "=" or not _is_replaced(alone, line, expected))
        for each in _flat(base.only)
        for expected in (_expected(alone, each, Rules(alone.world)),)
    ):
        return False  # nothing is put in
    # A value may be put in, or its name for it.
    return any(
        _matches_with(step, line, _expected(step, each, rules), rules, each.sign)
        for each in _flat(base.only)
    )


def _points_along(step: Step, line: Link, base: Link, rules: Rules) -> bool:
    """Whether a line gives a direction of its base, with values put in: in the same sense."""
    if base.sign != "parallel to" or line.left != base.left:
        return False
    own, other = step.world.pointing(line.right), step.world.pointing(base.right)
    other = rules.put_into(other)
    if not (isinstance(own, Plane) and isinstance(other, Plane)):
        return False
    if not step.world.reduced(own.x * other.y - own.y * other.x).vanishes:
        return False
    pairs = [(a, b) for a, b in ((own.x, other.x), (own.y, other.y)) if not b.vanishes]
    return bool(pairs) and all(not a.vanishes and step.signs.of(a / b) == 1 for a, b in pairs)


def _is_replaced(step: Step, line: Link, expected: Value) -> bool:
    """Whether a quantity of an inequality stands no more in a line.

    Of two positive values either is the other times what is positive.
    """
    own = step.residual(line)
    if isinstance(own, Plane) or isinstance(expected, Plane):
        return False
    ours, theirs = (set(step.world.keys(each.above).values()) for each in (own, expected))
    return any(key[0] in ("quantity", "x", "y") for key in theirs - ours)


def _flat(links: tuple[Link, ...]) -> Iterator[Link]:
    """The links of a relation, and the first side of a chain with its last."""
    yield from links
    whole = whole_of(links)
    if whole is not None and len(links) > 1:
        yield whole


def _rearrange(step: Step, line: Link) -> bool:
    step = _from_base(step)
    base = _base(step)
    if base is None or len(base.options) != 1:
        return False
    if (
        step.move.id == "rearrange"
        and sum(isinstance(each.relation, Relation) for each in step.cited) > 1
    ):
        return _with_factor_known(step, line)
    return any(
        _same_direction(step, line, each)
        or _is_squared(step, line, each)
        or _matches(step, line, _expected(step, each, Rules(step.world)), each.sign)
        for each in _flat(base.only)
        if each.sign != "≈"
    )


def _is_squared(step: Step, line: Link, base: Link) -> bool:
    """Whether a line has the squares of both sides: of a root, and of what is positive."""
    if line.sign != "=" or base.sign != "=":
        return False
    if not any(map(_is_size_or_root, (*walk(base.left), *walk(base.right)))):
        return False
    values = [step.world.value(each) for link in (base, line) for each in (link.left, link.right)]
    if not all(isinstance(value, Quotient) for value in values):
        return False
    a, b, c, d = values
    if not all(step.world.reduced(x**2 - y).vanishes for x, y in ((a, c), (b, d))):  # type: ignore[operator]
        return False
    return _never_negative(step, base.left) and _never_negative(step, base.right)


def _is_size_or_root(tree: Expression) -> bool:
    return isinstance(tree, Apply) and tree.function in ("sqrt", "abs")


def _never_negative(step: Step, tree: Expression) -> bool:
    """Whether a side is a root or a size, or what is positive, or a product of such."""
    match tree:
        case Binary("*" | "/", left, right):
            return _never_negative(step, left) and _never_negative(step, right)
    return _is_size_or_root(tree) or step.signs.of(step.world.scalar(tree)) == 1


def _same_direction(step: Step, line: Link, base: Link) -> bool:
    """Whether a line gives a direction of its base by another vector."""
    ties = ("parallel to", "perpendicular to")
    if line.sign not in ties or base.sign not in ties or line.left != base.left:
        return False
    own, other = step.world.pointing(line.right), step.world.pointing(base.right)
    if not (isinstance(own, Plane) and isinstance(other, Plane)):
        return False
    if line.sign != base.sign:
        # What is perpendicular to one vector is parallel to it turned.
        other = Plane(CONSTANT(-1) * other.y, other.x)
    if not step.world.reduced(own.x * other.y - own.y * other.x).vanishes:
        return False
    pairs = ((own.x, other.x), (own.y, other.y))
    return any(
        not (a.vanishes or b.vanishes) and step.signs.of(a / b, sure=False) is not None
        for a, b in pairs
    )


def _with_factor_known(step: Step, line: Link) -> bool:
    return _rearrange(step.under(move=replace(step.move, id="cancel")), line)


def _identity(step: Step, line: Link) -> bool:
    names = _IDENTITIES.get(step.move.record or "")
    if names is not None and _is_instance(step, line, names):
        return True
    step = _from_base(step)
    base = _base(step)
    if names is None or base is None or len(base.options) != 1:
        return False
    if _by_values(step, line, base):
        return False  # no identity is used
    chosen = step.under(identities=names)
    trees = [t for each in (line, *base.only) for t in (each.left, each.right)]
    chosen.world.divide_angles([*trees, *(let.quantity for let in step.lets)])
    # Where tan ½α is t, its cosine and sine are known by t: c² = 1/(1 + t²).
    rules = chosen.rules(_rest(step))
    rules.complete()
    return any(
        _of_angle(chosen, line, each, rules)
        if chosen.world.is_angle(each.left)
        else _matches_with(chosen, line, _expected(chosen, each, rules), rules, each.sign)
        for each in base.only
    )


def _is_instance(step: Step, line: Link, names: frozenset[Any]) -> bool:
    """Whether a line is the identity itself, for its angles, or for what letters stand for."""
    if line.sign != "=":
        return False
    named: dict[Expression, Expression] = {
        Letter(let.letter): let.quantity for let in step.lets if isinstance(let.quantity, Binary)
    }
    left, right = (
        rebuilt(each, lambda own: named.get(own, own)) for each in (line.left, line.right)
    )
    line = Link(left, "=", right)
    chosen = step.under(cited=(), known=(), identities=names)
    chosen.world.divide_angles([line.left, line.right])
    own, plain = chosen.residual(line), step.under(cited=(), known=()).residual(line)
    return (
        isinstance(own, Quotient)
        and isinstance(plain, Quotient)
        and own.vanishes
        and not plain.vanishes
    )


def _by_values(step: Step, line: Link, base: Relation) -> bool:
    """Whether a line is its base, with what is cited put in."""
    rules = step.rules(_rest(step))
    try:
        return any(
            _matches_with(step, line, _expected(step, each, rules), rules, each.sign)
            for each in base.only
            if not step.world.is_angle(each.left)
        )
    except NotComparableError:
        return False


def _of_angle(step: Step, line: Link, base: Link, rules: Rules) -> bool:
    """Whether a line is what an identity makes of a ratio of two angles that are equal."""
    for function in _RATIOS:
        ratios = Link(Apply(function, base.left), base.sign, Apply(function, base.right))
        try:
            expected = _expected(step, ratios, rules)
            if base.sign == "=" and _matches_with(step, line, expected, rules, "="):
                return True
        except NotComparableError:
            continue
    return False


def _matches_with(step: Step, line: Link, expected: Value, rules: Rules, sign: Sign) -> bool:
    """As `_matches`, with values put into the line too: an identity may keep either form."""
    if _matches(step, line, expected, sign):
        return True
    if sign not in FLIPPED:
        return False
    own = step.residual(line, rules)
    if sign == "=":
        return line.sign == "=" and step.is_multiple(own, expected) is not None
    k = step.is_multiple(own, expected, sign=True)
    return k is not None and line.sign == (sign if k == 1 else FLIPPED[sign])


# --- from two lines ------------------------------------------------------------------------------


def _pair(step: Step) -> tuple[Link, Link] | None:
    """The two equations that are cited."""
    equations = [e.relation for e in step.cited if isinstance(e.relation, Relation)]
    if len(equations) < 2 or any(len(equation.options) != 1 for equation in equations[:2]):
        return None
    first, second = (_ends(equation.only) for equation in equations[:2])
    return None if first is None or second is None else (first, second)


def _ends(links: tuple[Link, ...]) -> Link | None:
    *_, last = _flat(links)
    return last if last.sign == "=" else None


def _combine(step: Step, line: Link) -> bool:
    pair = _pair(step)
    if pair is None or line.sign != "=":
        return False
    step.world.printed = True
    a, b = (step.residual(each) for each in pair)
    if step.move.eliminated is None:
        for sign in (1, -1):
            other = _times(b, CONSTANT(sign))
            if _matches(step, line, _plus(a, other)):
                return True
        return False
    if isinstance(a, Plane) or isinstance(b, Plane):
        return False
    own = step.world.value(step.setting.tree(step.move.eliminated))
    if not isinstance(own, Quotient):
        return False
    number = (
        next((n for m in own.above for n, power in enumerate(m) if power), None)
        if len(own.above) == 1
        else None
    )
    if number is None:
        return False
    p, q = _coefficient(a, number), _coefficient(b, number)
    if p is None or q is None:
        return False
    return _matches(step, line, step.world.reduced(a * q - b * p))


def _coefficient(x: Quotient, number: int) -> Quotient | None:
    """The factor of a generator in what is linear in it; None where it is not linear, or absent."""
    if any(m[number] for m in x.below) or any(m[number] > 1 for m in x.above):
        return None
    lead = {(*m[:number], 0, *m[number + 1 :]): v for m, v in x.above.items() if m[number]}
    return Quotient(x.above.ring.from_dict(lead), x.below) if lead else None


def _plus(a: Value, b: Value) -> Value:
    if isinstance(a, Plane) and isinstance(b, Plane):
        return Plane(a.x + b.x, a.y + b.y)
    if isinstance(a, Plane) or isinstance(b, Plane):
        raise NotComparableError("a vector beside a number")
    return a + b


def _times(a: Value, factor: Quotient) -> Value:
    if isinstance(a, Plane):
        return Plane(a.x * factor, a.y * factor)
    return a * factor


def _sides(step: Step) -> tuple[Quotient, Quotient, Quotient, Quotient] | None:
    pair = _pair(step)
    if pair is None:
        return None
    step.world.printed = True
    sides = [step.world.value(side) for link in pair for side in (link.left, link.right)]
    if any(isinstance(each, Plane) for each in sides):
        return None
    a, b, c, d = sides
    return a, b, c, d  # type: ignore[return-value]


def _divide(step: Step, line: Link) -> bool:
    sides = _sides(step)
    if sides is None:
        return False
    a, b, c, d = sides
    return line.sign == "=" and _matches(step, line, step.world.reduced(a * d - b * c))


def _square_add(step: Step, line: Link) -> bool:
    chosen = step.under(identities=frozenset({"pythagoras"}))
    sides = _sides(chosen)
    if sides is None:
        return False
    a, b, c, d = sides
    # Sines and cosines become known to each other only where they are squared and added.
    expected = chosen.world.reduced(a * a + c * c - b * b - d * d)
    return line.sign == "=" and _matches(chosen, line, expected)


_LINKS: dict[MoveId, Callable[[Step, Link], bool]] = {
    "law": _law,
    "define": _define,
    "fact": _put,
    "put": _put,
    "rearrange": _rearrange,
    "cancel": _rearrange,
    "identity": _identity,
    "combine": _combine,
    "divide": _divide,
    "square-add": _square_add,
}


# --- whole relations -----------------------------------------------------------------------------


def _triangle(step: Step, relation: Relation) -> bool:
    """The other ratios of an angle, where one is known, and its range."""
    base = _base(step)
    if base is None or len(base.options) != 1 or len(relation.options) != 1 or not step.known:
        return False
    known = {
        link.left.argument
        for link in base.only
        if isinstance(link.left, Apply) and link.left.function in _RATIOS
    }
    return all(
        link.sign == "="
        and isinstance(link.left, Apply)
        and link.left.function in _RATIOS
        and link.left.argument in known
        and not any(
            isinstance(node, Apply) and node.function != "sqrt" for node in walk(link.right)
        )
        for link in relation.only
    ) and _by_oracle(step, relation)


def _roots(step: Step, relation: Relation) -> bool:
    """All roots of an equation in one letter, or in one ratio."""
    base = _base(step)
    if base is None or len(base.options) != 1 or any(len(links) != 1 for links in relation.options):
        return False
    equation = _ends(base.only)
    links = [links[0] for links in relation.options]
    subject = links[0].left
    if equation is None or any(link.left != subject or link.sign != "=" for link in links):
        return False
    rules = step.rules(_rest(step))
    polynomial = _polynomial(step, _expected(step, equation, rules), subject)
    if polynomial is None:
        return False
    for link in links:
        root = step.world.scalar(link.right)
        times = 0
        while len(polynomial) > 1:
            quotient, rest = _divided(step, polynomial, root)
            if not rest.vanishes:
                break
            polynomial, times = quotient, times + 1
        if not times:
            return False
    return _never_zero(step, polynomial)


def _polynomial(step: Step, residual: Value, subject: Expression) -> list[Quotient] | None:
    """The coefficients of an equation in its subject, the constant one first."""
    if isinstance(residual, Plane) or residual.vanishes:
        return None
    world = step.world
    if isinstance(subject, Binary) and subject.op == "/":
        above, below = (world.scalar(each) for each in (subject.left, subject.right))
        if len(above.above) != 1 or len(below.above) != 1:
            return None
    own = world.scalar(subject)
    above = own.above
    if len(above) != 1 or len(own.below) != 1:
        return None
    (monomial,) = above
    (under,) = own.below
    numbers = [n for n, power in enumerate(monomial) if power]
    if len(numbers) != 1:
        return None
    (number,) = numbers
    power = monomial[number]
    # subject = g^p/below: each term c g^(pk) rest is c rest below^k subject^k.
    rest = Quotient(own.below, above.ring.ground_new(above.LC))
    polynomial: dict[int, Quotient] = {}
    others = [n for n, p in enumerate(under) if p]
    for m, value in residual.above.items():
        times, left = divmod(m[number], power)
        if left:
            return None
        term = above.ring.from_dict({(*m[:number], 0, *m[number + 1 :]): value})
        polynomial[times] = (
            polynomial.get(times, CONSTANT(0)) + Quotient(term, above.ring.one) * rest**times
        )
    if not polynomial:
        return None
    coefficients = [
        world.reduced(polynomial.get(n, CONSTANT(0))) for n in range(max(polynomial) + 1)
    ]
    if others:
        # A ratio such as tan θ = sin θ/cos θ: what is left of the denominator is a common factor.
        lead = coefficients[-1]
        coefficients = [world.reduced(coefficient / lead) for coefficient in coefficients]
        if any(
            any(m[n] for n in others) for each in coefficients for m in (*each.above, *each.below)
        ):
            return None
        if step.signs.of(lead) is None:
            return None
    return coefficients


def _divided(
    step: Step, polynomial: list[Quotient], root: Quotient
) -> tuple[list[Quotient], Quotient]:
    """A polynomial divided by x − root: quotient and remainder."""
    result: list[Quotient] = []
    carried = CONSTANT(0)
    for coefficient in reversed(polynomial):
        carried = step.world.reduced(coefficient + carried * root)
        result.append(carried)
    return list(reversed(result[:-1])), result[-1]


def _never_zero(step: Step, polynomial: list[Quotient]) -> bool:
    """Whether what is left of an equation has no root."""
    if len(polynomial) == 1:
        return step.signs.of(polynomial[0]) is not None
    x = sp.Symbol("x_subject", real=True)
    value = sp.Add(
        *(
            step.world.expression(coefficient, step.roles) * x**n
            for n, coefficient in enumerate(polynomial)
        )
    )
    return step.oracle.proves(Claim(value, "!="))


def _reject(step: Step, relation: Relation) -> bool:
    base = _base(step)
    if base is None or len(base.options) < 2:
        return False
    kept = [
        n
        for n, option in enumerate(base.options)
        if any(_same_option(step, option, own) for own in relation.options)
    ]
    if len(kept) != len(relation.options) or len(kept) == len(base.options):
        return False
    rest = step.under(cited=_rest(step))
    moving = [link for link in rest.links if _is_of_vectors(link)]
    for n, option in enumerate(base.options):
        if n in kept:
            continue
        if moving:
            if not any(_is_contradicted(rest, option, each) for each in moving):
                return False
            continue
        dropped = rest.formula(Relation((option,)))
        oracle = Oracle(rest.roles, (*rest.facts, dropped))
        if oracle.possible.answer == "refuted":
            continue
        # Where two roots are one, what is dropped says what remains.
        if not oracle.proves(rest.formula(relation)):
            return False
    return True


def _is_of_vectors(link: Link) -> bool:
    """Whether an inequality is about a scalar product, such as that bodies approach."""
    return (
        link.sign in ("<", "<=", ">", ">=")
        and isinstance(link.left, Quantity)
        and (link.left.kind == "dot")
    )


def _is_contradicted(step: Step, option: tuple[Link, ...], bound: Link) -> bool:
    """Whether an inequality is false, with an option and all else that is cited put in."""
    chosen = step.under(cited=(*step.cited, Cited("", Relation((option,)))))
    try:
        value = chosen.residual(bound, chosen.rules())
    except NotComparableError:
        return False
    if isinstance(value, Plane):
        return False
    if value.vanishes:
        return bound.sign in ("<", ">")
    if any(key[0] in ("quantity", "x", "y") for key in chosen.world.keys(value.above).values()):
        return False
    sign = chosen.signs.of(value)
    return sign is not None and sign != 0 and (sign > 0) == (bound.sign[0] == "<")


def _same_option(step: Step, a: tuple[Link, ...], b: tuple[Link, ...]) -> bool:
    if len(a) != len(b):
        return False
    for one, other in zip(a, b, strict=True):
        if one == other:
            continue
        if one.sign != other.sign or one.sign != "=":
            return False
        if step.is_multiple(step.residual(one), step.residual(other)) is None:
            return False
    return True


def _by_oracle(step: Step, relation: Relation) -> bool:
    """Whether a relation is proved by what is cited, and by that alone.

    Of directions, and of decimals, there is nothing to prove in this way.
    """
    if any(link.sign not in FLIPPED for links in relation.options for link in links):
        return False
    return step.oracle.proves(step.formula(relation))


def _sign(step: Step, relation: Relation) -> bool:
    lines = [each for each in step.cited if isinstance(each.relation, Relation)]
    if len(lines) + len(step.known) > MOST_COMPARED:
        return False
    if any(link.sign in ("≈", "=") for links in relation.options for link in links):
        return False
    return is_certain(step, relation)


def is_certain(step: Step, relation: Relation) -> bool:
    """Whether what is cited proves a relation: of inverse tangents first by the tangents."""
    ways = [_by_oracle, between_tangents]
    if any(
        isinstance(each, Apply) and each.function == "arctan"
        for links in relation.options
        for link in links
        for side in (link.left, link.right)
        for each in walk(side)
    ):
        ways.reverse()
    return any(way(step, relation) for way in ways)


def between_tangents(step: Step, relation: Relation) -> bool:
    """An angle of up to 180° between bounds of which its tangent is between the tangents.

    What bounds it is at least 0 and less than 90°, and the least tangent is not negative: so the
    angle is acute too, and grows with its tangent.
    """
    if len(relation.options) != 1:
        return False
    named: dict[Expression, Expression] = {Letter(e.letter): e.quantity for e in step.lets}
    cited = {named.get(Letter(n), Letter(n)) for n, r in step.roles.items() if r.kind == "angle"}
    ratios = [
        (named.get(side.argument, side.argument), link)
        for each in step.links
        for link in (each, _turned(each))
        for side in (link.left,)
        if isinstance(side, Apply) and side.function == "tan" and link.sign in FLIPPED
    ]
    positive = False
    for link in relation.only:
        for angle, own in (
            (link.left, link),
            (link.right, _turned(link)),
        ):
            role = step.setting.of_angle(named.get(angle, angle))
            if named.get(angle, angle) not in cited:
                continue
            if role is None or role.low != 0 or role.high not in (sp.pi / 2, sp.pi):
                continue
            tangents = [r for a, r in ratios if a == named.get(angle, angle) and r.sign == own.sign]
            if not any(_is_tangent_below_90(step, own.right, r.right) for r in tangents):
                return False
            positive = positive or own.sign[0] == ">" or role.high == sp.pi / 2
            break
        else:
            return False
    return positive


def _turned(link: Link) -> Link:
    """A link with its sides exchanged."""
    sign: Any = FLIPPED.get(link.sign, link.sign)
    return Link(link.right, sign, link.left)


def _is_tangent_below_90(step: Step, angle: Expression, ratio: Expression) -> bool:
    """Whether a ratio is the tangent of an angle that is certain to be acute, or 0."""
    bound, value = (
        step.world.expression(step.world.scalar(each), step.roles) for each in (angle, ratio)
    )
    tangent = sp.tan(bound).replace(sp.cot, lambda x: 1 / sp.tan(x))
    if isinstance(bound, sp.atan):
        inside = step.oracle.proves(Claim(bound.args[0], ">="))
    else:
        inside = step.oracle.proves(Claim(bound, ">=")) and step.oracle.proves(
            Claim(sp.pi / 2 - bound, ">")
        )
    return inside and _equal_in(step, tangent, value)


MOST_COMPARED = 3
"""So many lines and facts at most stand behind an inequality."""


def _monotone(step: Step, relation: Relation) -> bool:
    """The bounds of what only grows, or only falls, with a letter whose range is cited."""
    base = _base(step)
    equation = None if base is None or len(base.options) != 1 else _ends(base.only)
    if equation is None or len(relation.options) != 1:
        return False
    value = step.world.expression(step.world.scalar(equation.right), step.roles)
    ranges = _cited_ranges(step)
    for symbol in value.free_symbols:
        role = step.roles.get(symbol.name)
        if role is not None and role.kind == "positive":
            # That it is positive, and may be as great as you like, is said nowhere.
            own = {"low": (sp.Integer(0), False), "high": (sp.oo, False)}
            ranges[symbol.name] = {**own, **ranges.get(symbol.name, {})}
    return any(
        _grows_between(step, relation.only, equation.left, value, name, ends)
        for name, ends in ranges.items()
    )


_Ends = dict[str, tuple[sp.Expr, bool]]


def _cited_ranges(step: Step) -> dict[str, _Ends]:
    """The ends of the ranges of letters that are cited, and whether they belong to them."""
    ranges: dict[str, _Ends] = {}
    bounds: list[Relation | Meaning] = [
        *(each.relation for each in step.known),
        *(each.relation for each in _rest(step)),
    ]
    for relation in bounds:
        if isinstance(relation, Meaning) or len(relation.options) != 1:
            continue
        for links in relation.options:
            for link in links:
                for side, other, sign in (
                    (link.left, link.right, link.sign),
                    (link.right, link.left, FLIPPED.get(link.sign, "")),
                ):
                    if isinstance(side, Letter) and side.name in letters(other):
                        continue
                    if isinstance(side, Letter) and sign in ("<", "<=", ">", ">="):
                        end = step.world.expression(step.world.scalar(other), step.roles)
                        which = "low" if sign in (">", ">=") else "high"
                        ranges.setdefault(side.name, {})[which] = end, len(sign) == 2
    return ranges


def _grows_between(
    step: Step,
    links: tuple[Link, ...],
    subject: Expression,
    value: sp.Expr,
    name: str,
    ends: _Ends,
) -> bool:
    letter = step.roles.get(name, REAL).symbol(name)
    slope = sp.diff(value, letter)
    if not slope.has(letter) and slope == 0:
        return False
    for direction in (1, -1):
        if step.oracle.proves(Claim(direction * slope, ">=")):
            return all(
                _is_end(step, link, subject, value, letter, ends, direction) for link in links
            )
    return False


def _is_end(
    step: Step,
    link: Link,
    subject: Expression,
    value: sp.Expr,
    letter: sp.Symbol,
    ends: _Ends,
    direction: int,
) -> bool:
    if link.left == subject:
        bound, sign = link.right, str(link.sign)
    elif link.right == subject:
        bound, sign = link.left, FLIPPED.get(link.sign, "")
    else:
        return False
    if sign not in ("<", "<=", ">", ">="):
        return False
    end = ends.get("low" if (sign[0] == ">") == (direction == 1) else "high")
    if end is None or end[1] != (len(sign) == 2):
        return False
    there = _worth_at(value, letter, end[0])
    own = step.world.expression(step.world.scalar(bound), step.roles)
    return there is not None and _equal_in(step, there, own)


def _equal_in(step: Step, a: sp.Expr, b: sp.Expr, facts: tuple[Claim, ...] = ()) -> bool:
    return Oracle(step.roles, facts).proves(Claim(a - b, "="))


def _complete(step: Step, relation: Relation) -> bool:
    """A square and a constant, or a sum of two that is least where they are equal."""
    if all(link.sign == "=" for links in relation.options for link in links):
        if step.links or len(relation.options) != 1:
            return False
        return all(_is_identical(step, link) for link in relation.only)
    return not step.links and _by_oracle(step, relation)


def _is_identical(step: Step, link: Link) -> bool:
    """Whether both sides are one as soon as the letter for them is put in."""
    value = step.residual(link, step.rules())
    return isinstance(value, Quotient) and value.vanishes


def _inverse(step: Step, relation: Relation) -> bool:
    """The angle of a ratio: the only one in the range that is cited."""
    if len(relation.options) != 1:
        return False
    cited = [
        link
        for each in step.cited
        if isinstance(each.relation, Relation) and len(each.relation.options) == 1
        for link in _flat(each.relation.only)
    ]
    if len(relation.only) != 1:
        return False
    (link,) = relation.only
    ratios_ = filter(None, (_ratio_of(step, each) for each in cited))
    ratios = [each for each in ratios_ if _is_multiple_of(step, link, each[0].argument)]
    if not ratios or link.sign != "=":
        return False
    # Of a chain the last side is the shortest.
    ratio_, value = [ratio for ratio in ratios if ratio[0] == ratios[0][0]][-1]
    angle = _in_radians(step, _scaled_angle(step, link, ratio_.argument))
    exact = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan}[ratio_.function](angle)
    low, high, closed = _range_of(step, ratio_.argument)
    if low is None or high is None:
        return False
    if not (
        _only_there(ratio_.function, low, high)
        or _but_straight(step, ratio_, value, high)
        or _in_its_quadrant(step, ratio_, angle)
        or _by_its_other_ratio(step, ratio_, angle, high - low)
    ):
        return False
    if link.left == ratio_.argument and _is_principal(ratio_.function, low, high):
        # Of what stands on paper as the ratio nothing else has to be known.
        values = [each for other, each in ratios if other == ratio_]
        if any(link.right == Apply(f"arc{ratio_.function}", each) for each in values):
            return True
    sign = "<=" if closed else "<"
    return _equal(step, exact, _in_radians(step, value)) and all(
        step.oracle.proves(compared(a, sign, b)) for a, b in _bounds_of(angle, low, high)
    )


def _bounds_of(angle: sp.Expr, low: sp.Expr, high: sp.Expr) -> Iterator[tuple[sp.Expr, sp.Expr]]:
    """What has to be in order for an angle to lie in a range: of arctan x, x and 0 for 0°."""
    plain = isinstance(angle, sp.atan)
    yield (sp.Integer(0), angle.args[0]) if plain and low == 0 else (low, angle)
    if not (plain and bool(high > sp.pi / 2)):
        yield angle, high


def _ratio_of(step: Step, link: Link) -> tuple[Apply, Expression] | None:
    """A sine, cosine or tangent and its value, where a link gives one; also by its letter."""
    left = link.left
    if isinstance(left, Letter):
        left = next((let.quantity for let in step.lets if let.letter == left.name), left)
    if link.sign == "=" and isinstance(left, Apply) and left.function in _RATIOS:
        return left, link.right
    return None


def _is_multiple_of(step: Step, link: Link, argument: Expression) -> bool:
    a, b = step.world.turn(link.left), step.world.turn(argument)
    return bool(a.terms) and len(a.terms) == len(b.terms) == 1 and a.terms[0][0] == b.terms[0][0]


def _scaled_angle(step: Step, link: Link, argument: Expression) -> Expression:
    if link.left == argument:
        return link.right
    a, b = step.world.turn(link.left), step.world.turn(argument)
    factor = b.terms[0][1] / a.terms[0][1]
    scaled = Binary("*", rational(factor), link.right)
    shift = b.degrees - a.degrees * factor
    return scaled if not shift else Binary("+", scaled, Degrees(shift))


def _in_radians(step: Step, tree: Expression) -> sp.Expr:
    value = step.world.scalar(tree)
    return step.world.expression(value, step.setting.roles)


def _equal(step: Step, a: sp.Expr, b: sp.Expr) -> bool:
    oracle = Oracle(step.setting.roles)
    return oracle.proves(Claim(a - b, "="))


def _range_of(step: Step, angle: Expression) -> tuple[Any, Any, bool]:
    """The range of an angle, as it is cited."""
    turn = step.world.turn(angle)
    if turn.degrees or len(turn.terms) != 1:
        return None, None, False
    ((atom, count),) = turn.terms
    for each in step.known:
        if not each.ref.startswith("acute"):
            continue
        own = step.world.turn(each.relation.only[0].left)
        if not own.degrees and len(own.terms) == 1 and own.terms[0][0] == atom:
            part = count / own.terms[0][1]  # of an angle that is acute
            ends = sorted(
                (sp.Integer(0), sp.Rational(part.numerator, part.denominator) * sp.pi / 2)
            )
            return ends[0], ends[1], False
    role = step.setting.role(getattr(atom, "name", ""))
    cited = any(getattr(atom, "name", "") in each.letters for each in step.known)
    if role.low is None or role.high is None or not cited:
        return None, None, False
    factor = sp.Rational(count.numerator, count.denominator)
    ends = sorted((role.low * factor, role.high * factor))
    return ends[0], ends[1], any(role.closed)


def _is_principal(function: str, low: sp.Expr, high: sp.Expr) -> bool:
    """Whether a range lies within that of the inverse of a ratio."""
    if function == "cos":
        return bool(low >= 0 and high <= sp.pi)
    return bool(low >= -sp.pi / 2 and high <= sp.pi / 2)


def _only_there(function: str, low: sp.Expr, high: sp.Expr) -> bool:
    """Whether a ratio has no more than one angle in a range: it is monotone, or tan in less."""
    if function == "tan" and bool(high - low < sp.pi):
        return True
    # As far as the range is turned by half turns, the ratio is that of the inverse or its opposite.
    start = sp.Integer(0) if function == "cos" else -sp.pi / 2
    turns = sp.floor((low - start) / sp.pi)
    return _is_principal(function, low - turns * sp.pi, high - turns * sp.pi)


def _by_its_other_ratio(step: Step, ratio_: Apply, angle: sp.Expr, width: sp.Expr) -> bool:
    """Whether a line tells the quadrant of an angle with a tangent, within one turn.

    It says that a positive multiple of the sine or the cosine of the angle has some value.
    """
    if ratio_.function != "tan" or not bool(width <= 2 * sp.pi):
        return False
    own = _in_radians(step, ratio_.argument)
    for link in step.links:
        if link.sign != "=":
            continue
        try:
            left, right = (_in_radians(step, each) for each in (link.left, link.right))
        except NotComparableError:
            continue
        for function in (sp.sin, sp.cos):
            share = sp.cancel(left / function(own))
            if own.free_symbols & share.free_symbols or not step.oracle.proves(Claim(share, ">")):
                continue
            if step.oracle.proves(Claim(right * function(angle), ">")):
                return True
    return False


def _but_straight(step: Step, ratio_: Apply, value: Expression, high: sp.Expr) -> bool:
    """Whether an angle of up to 180° has a tangent that is not zero: there is one such angle."""
    number = _in_radians(step, value)
    low = _range_of(step, ratio_.argument)[0]
    if ratio_.function != "tan" or low != 0 or not bool(high <= sp.pi):
        return False
    return Oracle(step.setting.roles).proves(Claim(number, "!="))


def _in_its_quadrant(step: Step, ratio_: Apply, angle: sp.Expr) -> bool:
    """Whether the direction of a velocity lies on the side to which its component points.

    Of the two directions with one tangent, the component in the direction of **i** tells which; of
    the two with one cosine, that in the direction of **j**.
    """
    meaning = step.setting.meanings.get(getattr(ratio_.argument, "name", ""))
    match meaning.quantity if meaning is not None else None:
        case Quantity("direction", (Name() as body,), int(stage)) if ratio_.function != "sin":
            velocity = step.world.value(Quantity("velocity", (body,), stage))
        case _:
            return False
    known = step.rules().put_into(velocity)
    if not (isinstance(velocity, Plane) and isinstance(known, Plane)):
        return False
    if ratio_.function == "tan":
        before, after, side = velocity.x, known.x, sp.cos(angle)
    else:
        before, after, side = velocity.y, known.y, sp.sin(angle)
    if before == after:
        return False
    share = step.world.expression(after, step.roles)
    return step.oracle.proves(Claim(share * side, ">"))


def _value(step: Step, relation: Relation) -> bool:
    """A decimal of what is exact: within half a unit of its last place."""
    base = _base(step)
    if base is None or len(base.options) != 1:
        return False
    if len(relation.options) != 1 or len(relation.only) != 1:
        return False
    (link,) = relation.only
    exact = _ends(base.only)
    if link.sign != "≈" or exact is None or link.left != exact.left:
        return False
    decimal, letters_ = _parted(link.right)
    printed = _decimal(decimal)
    value = _in_radians(step, exact.right)
    if letters_ is not None:
        value = sp.expand(value / _in_radians(step, letters_))
    if printed is None or value.free_symbols:
        return False
    number, unit = printed
    if isinstance(_unsigned(link.right), Degrees):
        value = value * 180 / sp.pi
    gap = sp.Abs(value - sp.Rational(number.numerator, number.denominator))
    half = sp.Rational(unit.numerator, unit.denominator * 2)
    return Oracle({}).proves(compared(gap, "<=", half))


def _unsigned(tree: Expression) -> Expression:
    return tree.operand if isinstance(tree, Negate) else tree


def _parted(tree: Expression) -> tuple[Expression, Expression | None]:
    """A decimal, and the letters that it is multiplied by, as in 0.634 u."""
    match tree:
        case Binary("*", left, right) if not any(isinstance(e, Number) for e in walk(right)):
            decimal, others = _parted(left)
            return decimal, right if others is None else Binary("*", others, right)
        case Binary("*", left, Binary("^", Letter(), _) as power):
            decimal, others = _parted(left)
            return decimal, power if others is None else Binary("*", others, power)
    return tree, None


def _decimal(tree: Expression) -> tuple[Fraction, Fraction] | None:
    """A decimal and the unit of its last place."""
    negative = isinstance(tree, Negate)
    own = _unsigned(tree)
    if not isinstance(own, Number | Degrees):
        return None
    value, places = own.value, 0
    while (value * 10**places).denominator != 1:
        places += 1
        if places > 30:
            return None
    return (-value if negative else value), Fraction(1, 10**places)


def _as_it_stands(step: Step, relation: Relation) -> bool:
    """The answer of an item: what the line before it says.

    That a value is the greatest or the least takes two lines: a bound, and where it is reached.
    """
    base = _base(step)
    if base is None or len(step.cited) != (2 if step.move.record else 1):
        return False
    if step.move.record:
        return relation == base and _is_attained(step, relation, step.cited[1].relation)
    return relation == base or _by_links(step.under(move=replace(step.move, id="put")), relation)


def _is_attained(step: Step, bound: Relation, where: Relation | Meaning) -> bool:
    """Whether a greatest or least value is reached, at a place that there is."""
    case = None if isinstance(where, Meaning) else _condition(where)
    if case is None or len(bound.options) != 1 or len(bound.only) != 1:
        return False
    (place, value), (end,) = case, bound.only
    if step.move.record == "approached":
        return end.sign in ("<", ">") and _is_approached(step, place, value, end)
    least = step.move.record == "least"
    if end.sign != (">=" if least else "<="):
        return False
    if value != Link(end.left, "=", end.right) and not _is_tangent_of(step, value, end):
        return False
    free = step.under(cited=(), known=())
    there = free.formula(Relation(((place,),)))
    return Oracle(step.setting.roles, (there,)).possible.answer == "proved"


def _is_approached(step: Step, place: Link, value: Link, end: Link) -> bool:
    """Whether a value belongs to an end of the range of a letter that is not in the range."""
    if value != Link(end.left, "=", end.right) and not _is_tangent_of(step, value, end):
        return False
    match place.left:
        case Binary("/", Number(1), Letter(name)) if place.right == ZERO:
            return step.setting.role(name).high is None  # as it grows without limit
        case Letter(name):
            role = step.setting.role(name)
        case _:
            return False
    there = _in_radians(step, place.right)
    ends = ((role.low, role.closed[0]), (role.high, role.closed[1]))
    return any(own is not None and not closed and own == there for own, closed in ends)


def _is_tangent_of(step: Step, value: Link, end: Link) -> bool:
    """Whether a tangent tells that an angle of up to 180° has a value: the only one with it."""
    if value.left != Apply("tan", end.left):
        return False
    angle, ratio_ = _in_radians(step, end.right), _in_radians(step, value.right)
    oracle = Oracle(step.setting.roles)
    role = step.setting.of_angle(end.left)
    if isinstance(end.left, Letter):
        role = role or step.setting.role(end.left.name)
    if role is None or role.low is None or role.high is None:
        return False
    if role.low >= -sp.pi / 2 and role.high <= sp.pi / 2 and isinstance(angle, sp.atan):
        return _equal(step, sp.tan(angle), ratio_)
    if role.low != 0:
        return False
    inside = (compared(angle, ">", sp.Integer(0)), compared(angle, "<", sp.pi))
    return _equal(step, sp.tan(angle), ratio_) and all(map(oracle.proves, inside))


_WHOLE: dict[MoveId, Callable[[Step, Relation], bool]] = {
    "triangle": _triangle,
    "roots": _roots,
    "reject": _reject,
    "sign": _sign,
    "compare": _sign,
    "solve": solves,
    "monotone": _monotone,
    "complete": _complete,
    "inverse": _inverse,
    "value": _value,
    "answer": _as_it_stands,
    "shown": _as_it_stands,
}

__all__ = ["FLIPPED", "MOST_COMPARED", "follows", "is_certain", "records_of"]
