"""Which move a line is tried by."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from restitution.explaining.data.setting import Cited
from restitution.explaining.definitions.common import ZERO
from restitution.explaining.lines.derivation import FLIPPED, Link, MoveId, Relation, whole_of
from restitution.explaining.lines.opposite_roots import as_squares
from restitution.explaining.lines.quotients import NotComparableError, Plane, Quotient
from restitution.explaining.lines.trees import has_ratio_of_a_sum
from restitution.explaining.moves.angles import in_radians, is_inverse, is_triangle
from restitution.explaining.moves.bases import IDENTITIES, base_of, bases_of, condition, with_base
from restitution.explaining.moves.combining import is_combination, is_quotient, is_sum_of_squares
from restitution.explaining.moves.defining import is_definition
from restitution.explaining.moves.growing import is_monotone
from restitution.explaining.moves.identities import is_identity
from restitution.explaining.moves.inequalities import is_comparison, is_completed
from restitution.explaining.moves.laws import is_law
from restitution.explaining.moves.limits import at_place
from restitution.explaining.moves.putting import is_put, is_rearrangement
from restitution.explaining.moves.roots import are_roots, is_rejection
from restitution.explaining.moves.values import is_attained, is_decimal
from restitution.explaining.steps.solving import solves
from restitution.explaining.steps.step import Step
from restitution.expression.tree import (
    EXACT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    has_quantity,
    is_binary,
    is_function,
    is_quantity,
    letters,
    walk,
)


def follows(step: Step, relation: Relation) -> bool:
    """Whether a relation is what the move makes of what is cited.

    Numbers of degrees are compared by what is left of multiples of 15°, where they have to be.
    Raises NotComparableError where that is beyond what is compared.
    """
    if _follows(step, relation):
        return True
    if step.move.id not in ("law", "define"):
        return False
    by_degrees = frozenset({*step.identities, "degrees"})
    if (
        _gives_a_number(relation)
        and len(set(_plain_degrees(step, relation))) > 1
        and _follows(step.under(identities=by_degrees), relation)
    ):
        return True
    by_sums = frozenset({*step.identities, "sum"})
    return _has_inverses(step) and _follows(step.under(identities=by_sums), relation)


def _has_inverses(step: Step) -> bool:
    """Whether a line that is cited has the ratio of a sum with the inverse of one in it."""
    return any(
        isinstance(node, Apply)
        and is_binary(node.argument, "+", "-")
        and any(is_function(part, "arctan") for part in walk(node.argument))
        for link in step.links
        for node in walk(link.right)
    )


def _gives_a_number(relation: Relation) -> bool:
    """Whether a line is an equation for one number, or for a multiple of one letter.

    A longer one would take minutes by degrees.
    """
    links = relation.options[0]
    return len(relation.options) == 1 and all(
        link.sign == "=" and len(letters(link.right)) <= 1 and not has_quantity(link.right)
        for link in links
    )


def _plain_degrees(step: Step, relation: Relation) -> Iterator[Fraction]:
    """The numbers of degrees in a line and in what it cites, as far as roots do not have them."""
    cited = (own.relation for own in step.cited)
    for own in (relation, *cited):
        for tree in own.trees if isinstance(own, Relation) else ():
            for node in walk(tree):
                if isinstance(node, Degrees) and node.value % EXACT_ANGLE:
                    yield node.value


def _follows(step: Step, relation: Relation) -> bool:
    """Whether a relation is what the move makes of what is cited, as its angles stand."""
    if step.move.record == "either-side":
        return _on_either_side(step, relation)
    if _follows_along(step, relation):
        return True
    return any(_follows_along(own, relation) for own in _along_slanting_lines(step))


def _along_slanting_lines(step: Step) -> Iterator[Step]:
    """The step with all vectors resolved along a line that is cited by its angle.

    A path at 50° makes an angle of 20° with a line at 30°, in degrees and in letters.
    """
    if step.move.id not in ("law", "define") or step.base is not None:
        return
    lefts = [link.left for link in step.links]
    if not any(is_quantity(left, "velocity") and left.stage == 0 for left in lefts):
        return
    angle = step.world.directions.get(Quantity("line_of_centres", (), step.move.event))
    if angle is not None and step.world.is_angle(angle):
        yield step.under(base=angle)


def _follows_along(step: Step, relation: Relation) -> bool:
    """Whether a relation is what the move makes of what is cited, along the axes of a step."""
    if (step.move.id, step.move.record) == ("define", "speed"):
        relation = as_squares(relation) or relation
    if step.move.id == "put" and (case := condition(relation)) is not None:
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
        base = base_of(step)
        if len(step.cited) != 1 or base is None or len(base.options) != 1:
            return False
        own = whole_of(base.only)
    if own is None or own != first or (second.left, second.sign) != (own.left, own.sign):
        return False
    meaning = step.setting.meanings.get(getattr(own.left, "name", ""))
    match own.left if meaning is None else meaning.quantity:
        case Quantity("direction", (Name(),), int()):
            one, other = (in_radians(step, link.right) for link in (first, second))
            return bool(one + other == 0)
        case (
            Quantity("velocity" | "line_of_centres")
            | Quantity("impulse", (Name(),))
            | Quantity("direction", (Name(),), None)
        ):
            a, b = (step.world.value(link.right) for link in (first, second))
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


def _under_condition(step: Step, place: Link, then: Link) -> bool:
    if not _is_beyond_all(step, place):
        chosen = step.under(cited=(*step.cited, Cited("", Relation(((place,),)))))
        try:
            if any(
                _by_links(chosen, Relation(((with_square,),)))
                for with_square in _with_squares(chosen, then)
            ):
                return True
        except NotComparableError:
            pass  # it may still be compared at the place itself
    return at_place(step, place, then)


def _is_beyond_all(step: Step, place: Link) -> bool:
    """Whether a place is none that a letter may have, so that anything would follow there.

    It is an end of its range that does not belong to it, or an angle's, of which ratios are cited.
    """
    match place.left:
        case Letter(name):
            role = step.setting.role(name)
            if name in step.setting.angles:
                return True
            ends = zip((role.low, role.high), role.closed, strict=True)
            there = in_radians(step, place.right)
            return any(end is not None and not closed and end == there for end, closed in ends)
        case Binary("/", Number(), Letter()):
            return place.right == ZERO
    return False


def _with_squares(step: Step, then: Link) -> Iterator[Link]:
    """An equation, and that of the squares of both sides where both are positive."""
    yield then
    sides = [step.world.value(side) for side in (then.left, then.right)]
    if all(isinstance(side, Quotient) and step.signs.of(side) == 1 for side in sides):
        two = Number(Fraction(2))
        yield Link(Binary("^", then.left, two), "=", Binary("^", then.right, two))


def _by_links(step: Step, relation: Relation) -> bool:
    """Each link by itself; a later link of a chain from the one before it."""
    bases = bases_of(step)
    if len(bases) > 1 and len(relation.options) == 1:
        return step.move.id == "put" and all(_is_worth(step, base, relation) for base in bases)
    if len(relation.options) != max(1, len(bases)):
        return False
    for number, links in enumerate(relation.options):
        chosen = step if len(bases) < 2 else with_base(step, bases[number])
        if not _chain(chosen, links):
            return False
    return True


def _is_worth(step: Step, option: tuple[Link, ...], relation: Relation) -> bool:
    """Whether an expression has the value of a line where one of several alternatives holds."""
    whole = whole_of(relation.only)
    if whole is None or whole.sign != "=" or any(link.left == whole.left for link in option):
        return False
    chosen = with_base(step, option)
    value = chosen.residual(whole, chosen.rules())
    return isinstance(value, Quotient) and value.vanishes


def _chain(step: Step, links: tuple[Link, ...]) -> bool:
    before: Link | None = None
    subject: Expression | None = None
    for link in links:
        if before is not None and before.right == link.left and subject is not None:
            base = Relation(((Link(subject, before.sign, before.right),),))
            move = replace(step.move, id=link.by or "put")
            if link.by == "identity" and move.record not in IDENTITIES:
                move = replace(move, record=_identity_in(before.right))
            after = step.under(move=move, cited=(Cited("", base), *step.cited))
            if link.by == "identity":
                # What the component is known to be by others says nothing of how it is rewritten.
                after = after.under(opaque=after.opaque | {subject})
                # Nor do the values that were put into the link before it.
                alone = after.under(cited=after.cited[:1])
                if _is_link(alone, Link(subject, link.sign, link.right)):
                    before = link
                    continue
            own = Link(subject, link.sign, link.right)
        else:
            after, own, subject = step, link, link.left
        if not _is_link(after, own) and not (after is not step and _is_bound(step, link)):
            return False
        before = link
    return True


def _identity_in(tree: Expression) -> str:
    """The identity by which a chain goes on from a form that has no name of one beside it."""
    return "sum-of-angles" if has_ratio_of_a_sum(tree) else "pythagoras"


def _is_link(step: Step, link: Link) -> bool:
    follows_ = _LINKS.get(step.move.id)
    return (
        follows_(step, link)
        if follows_ is not None
        else _WHOLE[step.move.id](step, Relation(((link,),)))
    )


def _is_bound(step: Step, link: Link) -> bool:
    """Whether the upper bound of a range comes of that of the range from which it is made."""
    base = base_of(step)
    between = base is not None and len(base.options) == 1 and len(base.only) == 2
    return between and link.by is None and link.sign in FLIPPED and _is_link(step, link)


_LINKS: dict[MoveId, Callable[[Step, Link], bool]] = {
    "law": is_law,
    "define": is_definition,
    "fact": is_put,
    "put": is_put,
    "rearrange": is_rearrangement,
    "cancel": is_rearrangement,
    "identity": is_identity,
    "combine": is_combination,
    "divide": is_quotient,
    "square-add": is_sum_of_squares,
}


def stands(step: Step, relation: Relation) -> bool:
    """The answer of an item: what the line before it says.

    That a value is the greatest or the least takes two lines: a bound, and where it is reached.
    It may be reached at several places, a line each. One that is only approached may rest on the
    line that says the range of the letter, too. A range that is given of a letter may tell which
    of the angles with one ratio it is.
    """
    base = base_of(step)
    places = [premise for premise in step.cited[1:] if isinstance(premise.ref, int)]
    if base is None or bool(places) != bool(step.move.record):
        return False
    if step.move.record == "approached" and len(places) == 2:
        place, extent = (place.relation for place in places)
        return relation == base and is_attained(step, relation, place, extent)
    if step.move.record:
        return relation == base and all(
            is_attained(step, relation, place.relation) for place in places
        )
    return relation == base or _by_links(step.under(move=replace(step.move, id="put")), relation)


_WHOLE: dict[MoveId, Callable[[Step, Relation], bool]] = {
    "triangle": is_triangle,
    "roots": are_roots,
    "reject": is_rejection,
    "sign": is_comparison,
    "compare": is_comparison,
    "solve": solves,
    "monotone": is_monotone,
    "complete": is_completed,
    "inverse": is_inverse,
    "value": is_decimal,
    "answer": stands,
    "shown": stands,
}
