"""The conditions of mark rules: what has to be true of a line and of what stands above it."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from fractions import Fraction

from restitution.explaining.awarding.mark_rules import ENERGIES, PAIR
from restitution.explaining.awarding.place_conditions import (
    another_chord,
    at_another_time,
    between_at_rest,
    between_places,
    goes_on,
    open_place,
    put_together,
    restated,
)
from restitution.explaining.awarding.work import (
    Work,
    is_another_assembled,
    is_identity_again,
    is_like_one_above,
    is_settled,
    is_sum_that_is_positive,
    length,
    says_a_quantity_is_positive,
    says_a_value_again,
    subject_of,
    tells_a_quadrant,
)
from restitution.explaining.data.offset_angles import letter_of_offset
from restitution.explaining.data.resting import is_of_a_body_at_rest
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Line,
    Link,
    Meaning,
    Relation,
)
from restitution.explaining.lines.trees import is_share_of_energy, trees_of
from restitution.expression.quantities import LOSSES, UNSIGNED_ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    Unit,
    has_operator,
    has_quantity,
    is_binary,
    is_component,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.expression.writing import write_expression


def aligned(line: Line) -> tuple[Expression, str] | None:
    """What a line says the direction of, and how; None for any other relation."""
    if isinstance(line.relation, Meaning) or len(line.relation.options) != 1:
        return None
    link = line.relation.only[0]
    return (link.left, link.sign) if link.sign.endswith(" to") else None


def letters_of_line(line: Line) -> frozenset[str]:
    """The letters in what a line says."""
    return frozenset(name for tree in trees_of(line.relation) for name in letters(tree))


def says_again(work: Work, line: Line) -> bool:
    """Whether a line only puts together what stands already: a component, a velocity, a speed."""
    if line.move.id != "define":
        return False
    if line.move.record == "component":
        return _by_its_letter(work, line)
    return line.move.record in ("assemble", "speed", "size")


def _unequal(line: Line) -> bool:
    """Whether a line is an inequality, or says only that something is not zero."""
    if not isinstance(line.relation, Relation):
        return False
    signs = [link.sign for links in line.relation.options for link in links]
    return signs == ["!="] or any(sign in ("<", "<=", ">", ">=") for sign in signs)


def _is_law(line: Line, records: Collection[str], event: int | None) -> bool:
    return line.move.id == "law" and line.move.record in records and line.move.event == event


def _repeated(work: Work, line: Line) -> bool:
    """An earlier part has the same principle for the same bodies at the same event."""
    move, part = line.move, work.part(line)
    return any(
        _is_law(other, (move.record or "",), move.event)
        and set(other.move.bodies) == set(move.bodies)
        and work.part(other) != part
        for other in work.above(line)
    )


def _first_at_event(work: Work, line: Line) -> bool:
    return not any(
        _is_law(e, ("unchanged",), line.move.event) and not _zero(work, e) for e in work.above(line)
    )


def _zero(work: Work, line: Line) -> bool:
    """A component of a body that has none: nothing is to be worked out."""
    sides = line.relation.sides
    return sides is not None and sides[1] == Number(Fraction(0))


_GROUPS: Mapping[str, str] = {
    **dict.fromkeys(PAIR, "direction"),
    **dict.fromkeys(ENERGIES, "energy"),
    "component": "component",
}


def _place_of_facts(work: Work, line: Line) -> bool:
    """A coordinate by the way in the other direction, from the data alone."""
    match subject_of(line):
        case Quantity("along", (Quantity("position"), _)):
            return rests_on_facts(work, line) and any("contact" in str(e) for e in line.premises)
    return False


def _alike(work: Work, line: Line) -> list[Line]:
    """The lines that make one step together, in order.

    They are the two principles along the centres of an event, the components in its directions at
    one time, the energies of an item.
    """
    move, group = line.move, _GROUPS[line.move.record or ""]

    def same(other: Line) -> bool:
        if other.move.id != move.id or _GROUPS.get(other.move.record or "") != group:
            return False
        if group == "energy":
            own = not rests_on_facts(work, other) and not _of_angles(work, other)
            return own and other.item == line.item
        if work.part(other) != work.part(line) or other.move.event != move.event:
            return False
        if group == "direction":
            return True
        plain = not _zero(work, other) and not _by_its_letter(work, other)
        return plain and _is_late(other) == _is_late(line)

    return [line for line in work.derivation.lines if same(line)]


def _is_late(line: Line) -> bool:
    """Whether a component is that of a velocity after the event of its line."""
    subject = subject_of(line)
    vector = subject.arguments[0] if isinstance(subject, Quantity) and subject.arguments else None
    return isinstance(vector, Quantity) and vector.stage == line.move.event


def _read_off(work: Work, line: Line) -> bool:
    """None of the components that stand together is a sum of products."""
    return not any(
        is_binary(node, "+", "-")
        for other in _alike(work, line)
        if isinstance(other.relation, Relation)
        for node in walk(other.relation.only[0].right)
    )


def _resolved_again(work: Work, line: Line) -> bool:
    """A component is two terms of a velocity that was found, at an impact that asks no other."""
    match line.relation:
        case Relation(((Link(_, _, Binary("+" | "-")), *_),)) if not rests_on_facts(work, line):
            lines = {ref for ref in line.premises if isinstance(ref, int)}
            own = (line for line in work.derivation.lines if line.move.record == "component")
            others = [e for e in own if e.move.event == line.move.event and e != line]
            return bool(lines) and not others
    return False


def _origins(work: Work, line: Line) -> frozenset[int | None]:
    """The events of the principles along the centres that a line says in other words."""
    if line.move.id == "law":
        direction = _GROUPS.get(line.move.record or "") == "direction"
        return frozenset((line.move.event,)) if direction else frozenset()
    if line.move.id not in ("put", "rearrange", "cancel"):
        return frozenset()
    return frozenset(event for other in work.cited(line) for event in _origins(work, other))


def events_solved(work: Work, line: Line) -> frozenset[int | None]:
    """The events whose principles a line solves: two of them joined, or an unknown put in."""
    if line.number not in work.solved:
        work.solved[line.number] = _events_solved(work, line)
    return work.solved[line.number]


def _events_solved(work: Work, line: Line) -> frozenset[int | None]:
    cited = [other for other in work.cited(line) if isinstance(other.relation, Relation)]
    events = [_origins(work, line) for line in cited]
    if line.move.id == "combine":
        return frozenset.intersection(*events) if len(events) == 2 else frozenset()
    if line.move.id != "put" or len(cited) < 2:
        return frozenset()
    own = work.new & letters_of_line(line)
    return frozenset(
        event
        for source, those in zip(cited, events, strict=True)
        for event in those
        if not is_settled(work, source)
        and work.new & letters_of_line(source) - own
        and any(
            e != source and work.new & letters_of_line(e) & letters_of_line(source) for e in cited
        )
    )


def _solved_before(work: Work, line: Line) -> list[Line]:
    """The lines above, in the same part, that solve the same principles."""
    events = events_solved(work, line)
    return [
        other
        for other in work.above(line)
        if (line.move.id == "put" or work.part(other) == work.part(line))
        and events_solved(work, other) & events
    ]


def _of_one_letter(work: Work, line: Line) -> bool:
    """Two lines say what one letter is: what they say is equal; none solves two principles."""
    subjects = [subject_of(e) for e in work.cited(line) if isinstance(e.relation, Relation)]
    equal = len(subjects) >= 2 and isinstance(subjects[0], Letter) and subjects[0] == subjects[1]
    return equal and not events_solved(work, line)


def _sought(work: Work, line: Line) -> bool:
    """The part asks for the coefficient that the line holds, or the line is to be solved.

    It is where it has scalar products with a change of velocity that holds a letter, and where it
    is an equation for a letter of the data.
    """
    own = line.relation.options[0][0].left if isinstance(line.relation, Relation) else None
    axes = any(
        isinstance(other.relation, Relation) and other.relation.options[0][0].sign == "parallel to"
        for other in work.cited(line)
    )
    if axes and own is not None and not isinstance(own, Quantity):
        return True
    asked = {
        tree
        for end in work.derivation.items
        if end.part == work.part(line)
        for link in end.answer.options[0]
        for tree in ((link.left,) if link.sign == "=" else (link.left, link.right))
        if isinstance(tree, Letter)
    }
    equation = own is not None and not isinstance(own, Quantity | Letter)
    resolved = [other for other in work.cited(line) if other.move.record == "component"]
    return any(
        node in asked
        for value in (line, *(resolved if equation else ()))
        for fact in work.facts(value)
        if fact.id.startswith("e ") or (equation and fact.kind == "data")
        for tree in trees_of(fact.relation)
        for node in walk(tree)
    )


def rests_on_facts(work: Work, line: Line) -> bool:
    """It rests on the statement alone, and on what letters stand for.

    The energy of all may rest on that of each that the statement tells.
    """
    whole = line.move.record == "total"
    return all(
        isinstance(other.relation, Meaning)
        or (whole and other.move.record == "energy" and rests_on_facts(work, other))
        for other in work.cited(line)
    )


def _is_share_of_the_data(work: Work, line: Line) -> bool:
    """It is the share of an energy that is lost, where the loss is given and needs no line."""
    match line.relation:
        case Relation(((Link(Binary("/", Quantity(kind), Quantity("energy")), "="), *_),)):
            cited = list(work.cited(line))
            lost = any(other.shown == "silent" for other in cited) or len(cited) == 1
            return kind in LOSSES and lost and all(rests_on_facts(work, e) for e in cited)
    return False


def _of_shares(work: Work, line: Line) -> bool:
    """It is made of lines that say which shares of an energy are lost, or kept."""
    cited = list(work.cited(line))
    return bool(cited) and all(map(is_share_of_energy, cited))


def _of_one_body(work: Work, line: Line) -> bool:
    """It is about one body alone."""
    return len(line.move.bodies) == 1


def _at_sight(work: Work, line: Line) -> bool:
    """It rests on the statement alone; a right angle also on a component that stays zero."""
    square = line.move.record == "perpendicular"
    return all(
        isinstance(other.relation, Meaning)
        or (square and other.move.id == "law" and _zero(work, other))
        for other in work.cited(line)
    )


def _an_angle_to_a_line(work: Work, line: Line) -> bool:
    """It is seen how a velocity lies to a line, along which it is or perpendicular to it.

    Or how it lies to a velocity of which it is a multiple.
    """
    match subject_of(line):
        case Quantity("angle", (Quantity("velocity"), Quantity("velocity"))):
            return line.move.record == "parallel"
        case Quantity("angle", (Quantity("velocity"), Unit() | Name())):
            return True
        case Quantity("angle", (Quantity("velocity"), Quantity("line_of_centres"))):
            return True
    return False


def _of_one_component(work: Work, line: Line) -> bool:
    """It is one component, or the letter for it, as a line above has that."""
    sides = line.relation.sides
    above = [e.relation for e in work.cited(line) if isinstance(e.relation, Relation)]
    values = [own.sides for own in above if own.sides is not None]
    return sides is not None and [right for _, right in values] == [sides[1]]


def _of_a_product(work: Work, line: Line) -> bool:
    """It rests on a scalar product of the same item, or on velocities that stand as vectors.

    Or on an angle of that item, which is a right one.
    """
    cited = tuple(work.cited(line))
    if any(_of_angles(work, e) and e.item == line.item for e in cited):
        return True
    further = [own for line in cited if line.move.id == "put" for own in work.cited(line)]
    if any(own.move.record == "product" and own.item == line.item for own in (*cited, *further)):
        return True
    lefts = [
        line.relation.options[0][0].left for line in cited if isinstance(line.relation, Relation)
    ]
    whole = bool(lefts) and all(is_quantity(e, "velocity") for e in lefts)
    return whole and line.number in work.ends


def _in_letters(work: Work, line: Line) -> bool:
    """Whether what a line comes to has letters in it."""
    relation = line.relation
    return isinstance(relation, Relation) and bool(letters(relation.options[0][-1].right))


def _of_angles(work: Work, line: Line) -> bool:
    """Whether a line is about an angle, or about how much two of them differ: β − α = 30°."""
    if isinstance(line.relation, Meaning):
        return False
    subject = line.relation.options[0][0].left
    while isinstance(subject, Binary):
        subject = subject.left
    if isinstance(subject, Letter):
        meaning = work.derivation.meanings.get(subject.name)
        subject = subject if meaning is None else meaning.quantity
    return is_quantity(subject, *UNSIGNED_ANGLES)


def _is_another_angle(work: Work, line: Line) -> bool:
    """Whether a line says that one angle with a letter of the working is another one."""
    if not isinstance(line.relation, Relation):
        return False
    link, meanings = line.relation.options[0][0], work.derivation.meanings
    return all(isinstance(e, Letter) and e.name in meanings for e in (link.left, link.right))


def _of_one_term(work: Work, line: Line) -> bool:
    """There is nothing to put together: only one component is not zero."""
    nodes = [node for tree in trees_of(line.relation) for node in walk(tree)]
    squares = any(is_binary(node, "+", "-") and has_operator(node, "^") for node in nodes)
    rooted = any(
        is_function(node, "sqrt", "abs") and is_binary(node.argument, "+", "-") for node in nodes
    )
    angled = any(_is_over_a_ratio(node) for node in nodes)
    axes = {node.axis for node in nodes if isinstance(node, Unit)}
    return not (squares or rooted or angled or len(axes) > 1)


def _is_over_a_ratio(tree: Expression) -> bool:
    """Whether a tree is a quotient by the sine or the cosine of an angle in degrees."""
    match tree:
        case Binary("/", _, Apply("sin" | "cos", Degrees())):
            return True
    return False


def is_given(work: Work, line: Line) -> bool:
    """Whether a line only says what the statement gives."""
    return line.move.id == "fact" and not list(work.cited(line)) and line.number not in work.shown


def _is_open_on_the_left(line: Line) -> bool:
    """Whether a line is an equation for a square that is given, or a speed times a ratio."""
    if isinstance(line.relation, Meaning):
        return False
    match left := line.relation.options[0][0].left:
        case Binary("*", Quantity("speed"), Apply("sin" | "cos")):
            return True
    return has_operator(left, "^") and not has_quantity(left)


def _closes_a_given(work: Work, line: Line) -> bool:
    """Whether a line makes an equation of a given fact, with what is given on the left."""
    if isinstance(line.relation, Meaning):
        return False
    given = any(fact.kind == "given" for fact in work.facts(line))
    return given and not has_quantity(line.relation.options[0][0].left)


def works_out(work: Work, line: Line) -> bool:
    """Whether a line says what a quantity is, or the tangent of an angle, by its definition.

    Not one that closes what is given into an equation.
    """
    if line.move.id != "define" or isinstance(line.relation, Meaning):
        return False
    if any(fact.kind == "given" for fact in work.facts(line)):
        return False
    left = line.relation.options[0][0].left
    while isinstance(left, Binary | Apply):
        left = left.left if isinstance(left, Binary) else left.argument
    return isinstance(left, Letter | Quantity)


def _of_a_number(work: Work, line: Line) -> bool:
    """Whether the value is read off the data as a number, with nothing to work out."""
    sides = line.relation.sides
    if sides is None or not isinstance(sides[0], Apply):
        return False
    return length(line) == 1 and not letters(sides[1])


def is_opposite(work: Work, line: Line) -> bool:
    """The roots are two opposite ones: nothing had to be factorised."""
    if isinstance(line.relation, Meaning):
        return False
    roots = [write_expression(options[-1].right) for options in line.relation.options]
    return len(roots) == 2 and any(a == f"-{b}" for a, b in (roots, roots[::-1]))


def _new_inequality(work: Work, line: Line) -> bool:
    """An inequality that comes of none; a comparison by a place, a given bound, or a quadrant."""
    bounded = any(e.id.startswith("within ") or _bounds_a_quantity(e) for e in work.facts(line))
    bounded |= any(tells_a_quadrant(own.relation) for own in work.cited(line))
    if tells_a_quadrant(line.relation) or (line.move.id == "compare" and not bounded):
        return False
    if line.move.id == "sign" and is_sum_that_is_positive(line) and not [*work.cited(line)]:
        return False
    return _unequal(line) and not any(
        _unequal(other)
        and work.part(other) == work.part(line)
        and not tells_a_quadrant(other.relation)
        and not says_a_quantity_is_positive(other)
        for other in work.cited(line)
    )


def _of_a_sum(work: Work, line: Line) -> bool:
    """Whether a line is the tangent of an angle that is made of two, of which bounds are sought."""
    sides = line.relation.sides
    ends = [end for end in work.derivation.items if end.item == line.item]
    return (
        sides is not None
        and is_function(sides[0], "tan")
        and any(other.move.record == "sum-of-angles" for other in work.cited(line))
        and any(link.sign in FLIPPED for end in ends for link in end.answer.options[0])
    )


def _claim_without_method(work: Work, line: Line) -> bool:
    """A claim is settled by comparing what stands: nothing else in its item is a method.

    What holds of a letter anyway is nothing that stands.
    """
    nothing = not any(True for _ in (*work.cited(line), *work.facts(line)))
    if nothing or says_a_value_again(work, line):
        return False
    end = work.ends.get(line.number)
    if line.number not in work.ends or (end is not None and line.number not in work.shown):
        return False
    own = [other for other in work.above(line) if other.item == line.item]
    rules = (work.rule(line) for line in own)
    return not any(rule is not None and "M" in rule.earned(work.style) for rule in rules)


def _approached(work: Work, line: Line) -> bool:
    """Whether a line bounds what only comes close to that bound, and no other line does."""
    bounded = [own for own in work.cited(line) if own.move.id in ("monotone", "complete", "sign")]
    below = (own for own in work.derivation.lines if line.number in own.premises)
    return not bounded and any(own.move.record == "approached" for own in below)


def _bounds_a_quantity(fact: Fact) -> bool:
    """Whether it is given between what bounds a quantity of the motion is."""
    links = [link for option in fact.relation.options for link in option]
    unequal = all(link.sign in ("<", "<=", ">", ">=") for link in links)
    return fact.kind == "given" and unequal and any(map(has_quantity, trees_of(fact.relation)))


def _fact_of_motion(work: Work, line: Line) -> bool:
    """A given equation about the motion is used, and for the first time.

    One that only gives a letter its value is put in like any datum. A value that is only copied is
    used where it is put in.
    """
    if _is_copied(work, line):
        return False
    used = {
        fact.id
        for other in work.above(line)
        if other.move.id in ("put", "fact", "law") and other.shown != "silent"
        for fact in _facts_used(work, other)
    }
    lets = (fact for fact in work.derivation.facts if fact.id.startswith("let "))
    named = {e.id[4:] for e in lets if has_quantity(e.relation.only[0].left)}
    return any(
        fact.kind == "given"
        and fact.id not in used
        and fact.relation.sides is not None
        and any(has_quantity(tree) or letters(tree) & named for tree in trees_of(fact.relation))
        for fact in _facts_used(work, line)
    )


def _facts_used(work: Work, line: Line) -> Iterator[Fact]:
    """The facts that a line cites, or that a line which it cites only copies."""
    if not _is_copied(work, line):
        yield from work.facts(line)
    for other in work.cited(line):
        if _is_copied(work, other):
            yield from work.facts(other)


def _is_copied(work: Work, line: Line) -> bool:
    """Whether a line only says which value is given of a quantity, or of a ratio of an angle."""
    sides = line.relation.sides
    return (
        line.move.id == "fact"
        and sides is not None
        and not any(isinstance(other.relation, Relation) for other in work.cited(line))
        and line.number not in work.ends
        and _is_named(sides[0])
        and not has_quantity(sides[1])
        and not letters(sides[1]) & work.new
    )


def _is_named(tree: Expression) -> bool:
    """Whether a side is a letter or a quantity, or a ratio of an angle that has a letter."""
    if is_function(tree, "sin", "cos", "tan"):
        tree = tree.argument
    return isinstance(tree, Letter | Quantity)


def _by_its_letter(work: Work, line: Line) -> bool:
    """A letter stands for the component already: nothing is read off."""
    cited = list(work.cited(line))
    return len(cited) <= 2 and any(
        isinstance(line.relation, Meaning) and is_component(line.relation.quantity)
        for line in cited
    )


def _of_an_offset(work: Work, line: Line) -> bool:
    """A line of centres by the sine of its angle to a path, for the first time."""
    facts = [fact for fact in work.facts(line) if fact.id.startswith("axis ")]
    above = {
        fact.id
        for other in work.above(line)
        for fact in work.facts(other)
        if other.move.id == "fact" or letter_of_offset(other) is not None
    }
    return any(
        fact.id not in above and any(is_function(node, "arcsin") for node in walk(tree))
        for fact in facts
        for tree in trees_of(fact.relation)
    )


def _of_an_impulse(work: Work, line: Line) -> bool:
    """An impulse by one that stands above, or that is given."""
    relations = [other.relation for other in work.cited(line)]
    relations += [fact.relation for fact in work.facts(line)]
    return any(
        isinstance(relation, Relation)
        and getattr(relation.options[0][0].left, "kind", None) == "impulse"
        for relation in relations
    )


def _for_an_angle(work: Work, line: Line) -> bool:
    """A speed of which only the cosine of an angle is made, by a scalar product."""
    users = [other for other in work.derivation.lines if line.number in other.premises]
    return bool(users) and all(other.move.record == "scalar-angle" for other in users)


CONDITIONS: Mapping[str, Callable[[Work, Line], bool]] = {
    "repeated": _repeated,
    "sought": _sought,
    "zero": _zero,
    "given-as-asked": lambda work, line: is_given(work, line) and line.number in work.ends,
    "wall": lambda work, line: work.walls.get(line.move.event or 0, False),
    "first-at-event": _first_at_event,
    "read-off": _read_off,
    "resolved-again": _resolved_again,
    "alone": lambda work, line: len(_alike(work, line)) == 1,
    "first-of-several": lambda work, line: _alike(work, line)[:1] == [line],
    "second-of-several": lambda work, line: _alike(work, line)[1:2] == [line],
    "last-of-several": lambda work, line: _alike(work, line)[1:][-1:] == [line],
    "by-its-letter": _by_its_letter,
    "of-facts": rests_on_facts,
    "at-sight": _at_sight,
    "of-one-component": _of_one_component,
    "inline": lambda work, line: line.shown == "inline",
    "of-angles": _of_angles,
    "in-letters": _in_letters,
    "at-once": lambda work, line: (
        isinstance(line.relation, Relation)
        and not any(isinstance(tree, Binary) for tree in line.relation.trees[:2])
    ),
    "place-of-facts": _place_of_facts,
    "another-chord": another_chord,
    "another-time": at_another_time,
    "time": lambda work, line: getattr(subject_of(line), "kind", None) == "time",
    "a-place": lambda work, line: (
        line.number not in work.ends and isinstance(subject_of(line), Quantity)
    ),
    "a-direction": lambda work, line: getattr(subject_of(line), "kind", None) == "direction",
    "an-angle-for-another": _is_another_angle,
    "an-angle-to-a-line": _an_angle_to_a_line,
    "of-one-term": _of_one_term,
    "for-an-angle": _for_an_angle,
    "another-assembled": is_another_assembled,
    "identity-again": is_identity_again,
    "like-one-above": is_like_one_above,
    "asked": lambda work, line: (
        subject_of(line) in [end.answer.options[0][0].left for end in work.derivation.items]
    ),
    "an-equation": lambda work, line: (
        line.number not in work.ends and (_is_open_on_the_left(line) or _closes_a_given(work, line))
    ),
    "of-a-number": _of_a_number,
    "product-above": _of_a_product,
    "opposite": is_opposite,
    "of-laws": lambda work, line: bool(events_solved(work, line)),
    "first": lambda work, line: not _solved_before(work, line),
    "of-one-letter": _of_one_letter,
    "of-a-letter": lambda work, line: isinstance(subject_of(line), Letter),
    "unknowns": lambda work, line: not subject_of(line) and bool(work.new & letters_of_line(line)),
    "another": lambda work, line: len(_solved_before(work, line)) == 1,
    "of-an-earlier-part": lambda work, line: (
        not any(work.part(other) == work.part(line) for other in _solved_before(work, line))
    ),
    "on-the-way": lambda work, line: line.number not in work.ends,
    "justified": lambda work, line: line.item in work.justify,
    "new-inequality": _new_inequality,
    "of-a-sum": _of_a_sum,
    "fact-of-motion": _fact_of_motion,
    "claim-without-method": _claim_without_method,
    "share-of-the-data": _is_share_of_the_data,
    "of-shares": _of_shares,
    "of-one-body": _of_one_body,
    "of-an-offset": _of_an_offset,
    "restated": restated,
    "distance-at-rest": between_at_rest,
    "of-an-impulse": _of_an_impulse,
    "of-a-contact": lambda work, line: any(e.id.startswith("contact ") for e in work.facts(line)),
    "approached": _approached,
    "open-place": open_place,
    "between-places": between_places,
    "times-together": put_together,
    "goes-on": goes_on,
    "at-rest": lambda work, line: is_of_a_body_at_rest(work.derivation, line),
}
"""What a rule may ask of a line, and of the lines about it."""
