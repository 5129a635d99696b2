"""Greatest and least values in words, with where they are reached, or that they are not."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.errors import RestitutionError
from restitution.exact import tidy
from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.lines.derivation import (
    Derivation,
    Line,
    Link,
    Meaning,
    Relation,
    equality,
)
from restitution.explaining.lines.saying import Sentence, operand, say
from restitution.explaining.lines.sentences import SentenceId
from restitution.explaining.lines.trees import trees_of
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    Quantity,
    is_function,
    is_zero,
    letters,
    walk,
)
from restitution.planning.writing.forms import tree_of
from restitution.render import layout as lay
from restitution.workings.naming.measured import as_answer
from restitution.workings.naming.quantities import Naming

# The records of the lines in which such a value is the answer.
EXTREMA = frozenset({"greatest", "least", "approached"})


def extreme(
    derivation: Derivation, naming: Naming, line: Line, shown: bool
) -> tuple[lay.Layout, str, tuple[Sentence, ...]]:
    """The left side, the sign and the reasons of a line that answers with an extremum.

    ``shown`` tells that the statement has the value, and calls it the greatest or the least.
    """
    assert isinstance(line.relation, Relation)
    link = line.relation.only[-1]
    greatest = link.sign[0] == "<"
    reached_there = [
        (reached[0], behind)
        for ref in line.premises
        if isinstance(ref, int)
        and (behind := derivation.line(ref)) is not None
        and isinstance(behind.relation, Relation)
        and (reached := value_reached(behind.relation.options)) is not None
    ]
    if line.move.record != "approached":
        called = operand(naming.extreme(link.left, greatest=greatest))
        where = tuple(
            _by_angle(derivation, naming, line, behind, place)
            or _where(naming, place, shown, _square_above(derivation, line, place))
            for place, behind in reached_there
        )
        reasons: tuple[Sentence, ...] = (say("derived.for", places=where),) if where else ()
        bound = _bound_above(derivation, line)
        if bound is not None:
            reasons += (say("derived.as", reasons=(naming.relation(bound),)),)
        return called, "=", reasons
    none: SentenceId = "extremum.no-greatest" if greatest else "extremum.no-least"
    name: SentenceId = "extremum.approached" if shown else none
    return (
        naming.layout(link.left),
        "→",
        tuple(
            _not_reached(naming, name, derivation, place, behind) for place, behind in reached_there
        ),
    )


_BEYOND: Mapping[SentenceId, SentenceId] = {
    "extremum.no-greatest": "extremum.no-greatest-there",
    "extremum.no-least": "extremum.no-least-there",
}

_RIGHT_ANGLE = Degrees(Fraction(90))


def _not_reached(
    naming: Naming, name: SentenceId, derivation: Derivation, place: Link, behind: Line
) -> Sentence:
    """Where a value is approached, and that an acute angle or a mass does not come there."""
    there = _with_another(naming, place, _angle_there(derivation, behind, place))
    match place:
        case Link(Letter(), "=", Degrees(size) | Number(size)) if name in _BEYOND and (
            size == 0 or place.right == _RIGHT_ANGLE
        ):
            short = replace(place, sign=">" if size == 0 else "<")
            bound = naming.relation(Relation(((short,),)))
            return say(_BEYOND[name], place=there, bound=bound)
    return say(name, place=there)


def _where(
    naming: Naming, place: Link, shown: bool, square: Expression | None
) -> Sentence | lay.Layout:
    """Where a value is reached; of the ratio of an angle that is asked, the angle too.

    Where a ``square`` makes the bound, the value is reached where that is zero.
    """
    place_alone = Relation(((place,),))
    relation: Sentence | lay.Layout = naming.relation(place_alone)
    if square is not None:
        zero = naming.relation(equality(square, Number(Fraction(0))))
        relation = say("extremum.at-zero", square=zero, place=relation)
    match place:
        case Link(Apply("tan" | "sin" | "cos" as ratio, Letter() as angle), "=", right) if (
            not shown
        ):
            inverse = Apply(f"arc{ratio}", right)
            worth = None if letters(right) else sp.deg(in_letters(inverse))
            if worth is not None and worth.is_Rational:
                exact = naming.relation(equality(angle, Degrees(Fraction(worth.p, worth.q))))
                if square is None:
                    return exact
                return say("extremum.at-zero", square=zero, place=exact)
            added = as_answer(inverse)
            if len(added) == 1 or letters(right):
                also = naming.relation(equality(angle, Apply(f"arc{ratio}", under_one_root(right))))
                if len(added) == 1:
                    ((value, sign),) = added
                    also = lay.Relation((naming.layout(angle), value), (sign,))
                if square is None:
                    return say("extremum.at-angle", place=relation, angle=also)
                own = naming.relation(place_alone)
                return say("extremum.at-zero-angle", square=zero, place=own, angle=also)
    return relation


def _by_angle(
    derivation: Derivation, naming: Naming, line: Line, behind: Line, place: Link
) -> Sentence | None:
    """Where a value is reached over an offset: the tangent of the angle, its sine, the offset.

    None where the line ``behind`` the value does not rest on such an angle.
    """
    for own in derivation.lines_in(behind.premises):
        match own.move.id, own.relation:
            case "triangle", Relation(((Link(Apply("tan", Letter() as angle), "="),),)):
                lines = derivation.lines_in(own.premises)
            case _:
                continue
        sines = [
            relation.relation for relation in lines if letter_of_offset(relation) == angle.name
        ]
        if not sines or not isinstance(sines[0], Relation):
            continue
        letter, there = (in_letters(side, positive=True) for side in (place.left, place.right))
        sine = in_letters(sines[0].only[0].right, positive=True).subs(letter, there)
        tangent = tidy(sp.sqrt(sp.factor(sine**2 / (1 - sine**2))))
        first, second = (
            equality(Apply(ratio, angle), tree_of(value, as_it_is=True))
            for ratio, value in (("tan", tangent), ("sin", sine))
        )
        square = _square_above(derivation, line, first.only[0])
        if square is None:
            return say("extremum.by-sine", place=naming.relation(second), offset=_of(naming, place))
        return say(
            "extremum.at-zero-sine",
            square=naming.relation(equality(square, Number(Fraction(0)))),
            tangent=naming.relation(first),
            sine=naming.relation(second),
            offset=_of(naming, place),
        )
    return None


def _of(naming: Naming, place: Link) -> lay.Layout:
    """A place as an equation."""
    return naming.relation(Relation(((place,),)))


def under_one_root(tree: Expression) -> Expression:
    """The quotient of two roots as the root of a quotient; any other expression as it is."""
    match tree:
        case Binary("/", Apply("sqrt", above), Apply("sqrt", below)):
            return Apply("sqrt", Binary("/", above, below))
    return tree


def _square_above(derivation: Derivation, line: Line, place: Link) -> Expression | None:
    """A sum whose square is in the lines above, and which is zero at a place; None without one."""
    try:
        left, right = (in_letters(side, positive=True) for side in (place.left, place.right))
        for above in _above(derivation, line):
            for tree in reversed([*trees_of(above)]):  # the last form of a chain is the plainest
                for node in walk(tree):
                    match node:
                        case Binary("^", Binary("+" | "-") as base, Number(power)) if power == 2:
                            own = in_letters(base, positive=True)
                            if own.has(left) and tidy(own.subs(left, right)) == 0:
                                return base
    except RestitutionError:
        return None
    return None


def _above(derivation: Derivation, line: Line) -> Iterator[Relation]:
    """What the lines say on which a line rests, the nearest first."""
    pending, seen = [line], {line.number}
    while pending:
        own = pending.pop(0)
        if isinstance(own.relation, Relation):
            yield own.relation
        for ref in own.premises:
            if isinstance(ref, int) and ref not in seen:
                seen.add(ref)
                above = derivation.line(ref)
                pending += [] if above is None else [above]


def _is_of_the_motion(tree: Expression) -> bool:
    """Whether a quantity, or the tangent of an angle, stands in an expression."""
    return any(isinstance(node, Quantity) or is_function(node, "tan") for node in walk(tree))


def value_compared(derivation: Derivation, naming: Naming, line: Line) -> Sentence | None:
    """Where a value is reached, above the line that has the difference from that value.

    None of a line that is no such difference of an extremum.
    """
    match line.move.id, line.relation:
        case "rearrange", Relation(((Link(Binary("-", left, right), "="),),)):
            pass
        case _:
            return None
    sides = [side for side in (left, right) if _is_of_the_motion(side)]
    if len(sides) != 1:
        return None
    (own,), value = sides, right if sides == [left] else left
    for answer in derivation.lines:
        if answer.move.id != "answer" or answer.move.record not in ("greatest", "least"):
            continue
        if line.relation not in _above(derivation, answer) or _is_asked(answer, line):
            continue
        behind = derivation.lines_in(answer.premises)
        places = [
            naming.relation(Relation(((reached[0],),)))
            for line in behind
            if isinstance(line.relation, Relation)
            and (reached := value_reached(line.relation.options)) is not None
        ]
        if places:
            there = naming.relation(equality(own, value))
            return say("extremum.value", places=tuple(places), value=there)
    return None


def _is_asked(answer: Line, line: Line) -> bool:
    """Whether the difference in a line is itself what an answer bounds."""
    own, bound = line.relation, answer.relation
    if isinstance(own, Meaning) or isinstance(bound, Meaning):
        return False
    return own.options[0][0].left in (bound.options[0][0].left, bound.options[0][-1].right)


def _bound_above(derivation: Derivation, line: Line) -> Relation | None:
    """The bound that a value reaches, where that is the answer of an earlier item."""
    ends = {end.line for end in derivation.items}
    for ref in line.premises:
        own = derivation.line(ref)
        bound = None if own is None or own.number not in ends else own.relation
        if isinstance(bound, Relation) and bound == line.relation:
            return bound
    return None


def value_reached(
    options: tuple[tuple[Link, ...], ...],
) -> tuple[Link, tuple[Link, ...]] | None:
    """A value and where it is reached: ``x ≠ a or y = b`` says y = b when x = a."""
    if len(options) != 2:
        return None
    (where, *_), value = options
    if where.sign != "!=" or len(options[0]) != 1:
        return None
    return Link(where.left, "=", where.right), value


def _with_another(naming: Naming, place: Link, other: Link | None) -> Sentence | lay.Layout:
    """To where a letter goes, and with it another angle."""
    first = _approached(naming, place)
    if other is None:
        return first
    return say("extremum.with", place=first, other=_approached(naming, other))


def _angle_there(derivation: Derivation, line: Line, place: Link) -> Link | None:
    """To 0° or 90°, where an angle goes there whose tangent a line gives by the other."""
    if not isinstance(place.left, Letter):
        return None
    for ref in line.premises:
        own = derivation.line(ref)
        match None if own is None else own.relation:
            case Relation(((Link(Apply("tan", Letter() as angle), "="), *_) as links,)):
                pass
            case _:
                continue
        try:
            end, tangent = in_letters(place.right), in_letters(links[-1].right, positive=True)
        except RestitutionError:
            continue
        symbols = [symbol for symbol in tangent.free_symbols if symbol.name == place.left.name]
        if len(symbols) != 1 or angle == place.left:
            continue
        sense = "+" if end == 0 else "-"
        limit = sp.limit(tangent, symbols[0], end, sense)
        if limit in (0, sp.oo):
            return Link(angle, "=", Degrees(Fraction(0 if limit == 0 else 90)))
    return None


def _approached(naming: Naming, place: Link) -> lay.Layout:
    """To where a letter goes: to an end of its range, or on without limit."""
    match place:
        case Link(Binary("/", Number(), Letter() as letter), _, right) if is_zero(right):
            return lay.Relation((naming.layout(letter), lay.Words("∞")), ("→",))
    return lay.Relation((naming.layout(place.left), naming.layout(place.right)), ("→",))
