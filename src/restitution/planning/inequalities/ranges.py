"""The range of a letter or of a quantity, as one relation with its ends."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace
from typing import Any

import sympy as sp

from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    turned,
)
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Quantity,
    has_quantity,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.turning import turn_in_letters
from restitution.planning.formulas.named_angles import letter_known
from restitution.planning.inequalities.angles_at_ends import (
    AngleAtEnds,
    is_angle_of_motion,
    write_at_ends,
)
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.ends_in_degrees import with_ends_of_lines
from restitution.planning.routes.determining import determine
from restitution.planning.routes.order import Solver
from restitution.planning.writing.angles import RIGHT
from restitution.planning.writing.desk import UNPLANNED, NotPlannedError
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.inequalities import solve_linear, without_signs
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.solving.equations.solution import Answer, ItemResult


def write_range(
    scene: Scene,
    solver: Solver,
    asked: Expression,
    relation: Relation,
    name: str,
    shown: bool = False,
) -> None:
    """Writes the lines of a range, of which the last says all its ends."""
    with Claims(scene, solver) as claims:
        if not shown:
            relation = with_ends_of_lines(claims, asked, relation) or relation
        standing = None if shown else claims.standing_of_letter(relation)
        if standing is not None:
            line, _ = standing
            relation = scene.desk.relation(line)
        elif (earlier := _by_an_earlier_one(scene, solver, relation)) is not None:
            line = earlier
        elif not shown and (bounded := _by_what_stands(claims, relation)) is not None:
            line = bounded
        elif len(relation.options) > 1:
            line = claims.write_parts(asked, relation)
        elif not shown and (own := _of_a_turn(claims, solver, asked, relation)) is not None:
            line, relation = own
        else:
            mark = claims.worths.mark()
            try:
                line = claims.join_the_rest(claims.write(relation), relation)
                line = _with_what_holds(claims, line, relation)
                if not shown:
                    relation = _by_its_ratio(claims, asked, line, relation)
            except NotPlannedError:
                claims.worths.back(mark)
                without = None if shown else _without_a_tied_letter(claims, relation)
                if without is not None:
                    line = without
                else:
                    line, relation = _at_ends(claims, solver, asked, relation, shown)
    scene.desk.end(name, line, relation, shown=shown)


def _without_a_tied_letter(claims: Claims, relation: Relation) -> int | None:
    """The range of a quantity, worked out without a letter that the facts tie to others.

    None where no letter is, or where that leads to no range.
    """
    scene, mark = claims.scene, claims.worths.mark()
    free, shown = set(scene.free), list(scene.desk.shown)
    for symbol in sorted(free - set(scene.kept), key=str):
        scene.free.discard(symbol)
        # Where an earlier range has its equation, that is where it is worked out.
        scene.desk.shown += _equations_of(scene, symbol)
        with suppress(*UNPLANNED):
            return claims.join_the_rest(claims.write(relation), relation)
        claims.worths.back(mark)
        claims.ties.clear()
        claims.conditions.clear()
        scene.free |= free
        scene.desk.shown[:] = shown
    return None


def _equations_of(scene: Scene, symbol: sp.Symbol) -> list[int]:
    """The lines in force that say what a letter is, or its square, by other letters."""
    own = Letter(symbol.name)
    lines: list[int] = []
    for line in scene.desk.lines:
        match line.relation:
            case Relation(((Link(left, "=", right),),)) if own in (left, right):
                if not has_quantity(left) and not has_quantity(right):
                    lines.append(line.number)
    return [number for number in lines if scene.desk.holds(number)]


def _at_ends(
    claims: Claims, solver: Solver, asked: Expression, relation: Relation, shown: bool
) -> tuple[int, Relation]:
    """The range of an angle, or a bound of one that is shown, by what it is at ends of a letter.

    Raises NotPlannedError for what is no such angle.
    """
    if shown:
        return write_at_ends(claims, solver, relation), relation
    if not isinstance(asked, Quantity) or not is_angle_of_motion(asked):
        raise NotPlannedError("an inequality")
    own = AngleAtEnds(claims, solver, asked)
    for whole, bounds in own.ranges():
        line = own.bounded(whole, bounds)
        if line is not None and same(claims, whole, relation):
            return line, whole
    raise NotPlannedError("a range of an angle")


def _of_a_turn(
    claims: Claims, solver: Solver, asked: Expression, relation: Relation
) -> tuple[int, Relation] | None:
    """The range of a deflection by that of the one angle of which it is made that is not given.

    ``δ = 120° − arctan(√3/e)`` needs no tangent of a sum. None of another range, and where the
    tangent is asked too, or stands, or is that of a line of centres with a tangent at the ends that
    has no root.
    """
    scene = claims.scene
    if not is_quantity(asked, "deflection"):
        return None
    nodes = {n for link in relation.only for e in (link.left, link.right) for n in walk(e)}
    rooted = any(is_function(node, "sqrt") for node in nodes)
    is_new = _is_at_a_wall(scene, asked) and scene.desk.known(asked) is None
    beyond = is_new and _is_beyond_a_right_angle(claims, relation)
    if not (
        rooted or beyond or _ends_at_a_right_angle(relation) or _is_at_a_slanting_wall(scene, asked)
    ):
        return None
    if Apply("tan", asked) in scene.asked or _has_its_tangent(scene, asked):
        return None
    mark = claims.worths.mark()
    with suppress(*UNPLANNED):
        determine(scene, solver, asked)
        turned_ = turn_in_letters(scene, asked)
        if turned_ is not None:
            angle = AngleAtEnds(claims, solver, asked, turned_)
            for whole, bounds in angle.ranges():
                line = angle.bounded(whole, bounds)
                if line is not None and same(claims, whole, relation):
                    return line, whole
    claims.worths.back(mark)
    return None


def _ends_at_a_right_angle(relation: Relation) -> bool:
    """Whether an end of a range that is reached is 90°, where there is no tangent."""
    return any(
        link.sign in ("<=", ">=") and RIGHT in (link.left, link.right) for link in relation.only
    )


def _is_beyond_a_right_angle(claims: Claims, relation: Relation) -> bool:
    """Whether 90°, where there is no tangent, lies between the ends of a range in numbers."""
    ends = [side for link in relation.only for side in (link.left, link.right)]
    values = [
        claims.worths.value(end) for end in ends if not letters(end) and not has_quantity(end)
    ]
    return any(x < sp.pi / 2 for x in values if x.is_number) and any(
        x > sp.pi / 2 for x in values if x.is_number
    )


def _is_at_a_slanting_wall(scene: Scene, deflection: Quantity) -> bool:
    """Whether a deflection is at a wall that is along neither axis: both angles are to that."""
    stage = deflection.stage
    return _is_at_a_wall(scene, deflection) and scene.frame(int(str(stage))).is_slanted


def _is_at_a_wall(scene: Scene, deflection: Quantity) -> bool:
    number = deflection.stage
    known = isinstance(number, int) and number in scene.model.frames
    return known and scene.frame(int(str(number))).wall is not None


def _has_its_tangent(scene: Scene, asked: Quantity) -> bool:
    """Whether a line says the tangent of an angle."""
    known = letter_known(scene, asked)
    names: list[Expression] = [asked]
    names += [] if known is None else [Letter(known[0])]
    return any(
        isinstance(line.relation, Relation)
        and any(
            link.left == Apply("tan", name) for link in line.relation.options[0] for name in names
        )
        for line in scene.desk.lines
        if scene.desk.holds(line.number)
    )


def same(claims: Claims, own: Relation, other: Relation) -> bool:
    """Whether two relations have the same ends in other forms."""
    pairs = list(zip(own.only, other.only, strict=False))
    if len(own.only) != len(other.only) or any(a.sign != b.sign for a, b in pairs):
        return False
    sides = [(a.left, b.left) for a, b in pairs] + [(a.right, b.right) for a, b in pairs]
    scene = claims.scene
    return all(
        a == b or scene.model.identically_zero(scene.scalar(a) - scene.scalar(b)) for a, b in sides
    )


def _by_an_earlier_one(scene: Scene, solver: Solver, relation: Relation) -> int | None:
    """The line of a range that an item has in letters, with the values put in that they have now.

    None where there is no such item, or it does not come to the range.
    """
    desk = scene.desk
    if len(relation.options) != 1:
        return None
    for end in reversed(desk.ends):
        own = desk.line(end.line).relation
        if not isinstance(own, Relation) or not _is_range_like(own, relation):
            continue
        if own == relation or not desk.holds(end.line):
            continue
        standing = solver.mark()
        line = _with_values(scene, solver, end.line, relation)
        if line is not None:
            return line
        solver.back(standing)
    return None


def _by_what_stands(claims: Claims, relation: Relation) -> int | None:
    """A range by a bound that stands above, where no condition is left that is not under that."""
    for attempt in (_by_a_bound_above, _by_an_earlier_bound):
        mark = claims.worths.mark()
        line = attempt(claims, relation)
        if line is not None and not any(_further_conditions(claims, line)):
            return line
        claims.worths.back(mark)
    return None


def _further_conditions(claims: Claims, line: int) -> Iterator[Fact]:
    """The inequalities that are given and do not lie under a line, nor others that say the same."""
    facts = claims.scene.facts
    under = claims.scene.desk.under(line)
    cited = [facts[ref].relation for ref in under if isinstance(ref, str) and ref in facts]
    for fact in claims.conditions.inequalities():
        if fact.kind in ("given", "range") and fact.relation not in cited:
            yield fact


def _by_a_bound_above(claims: Claims, relation: Relation) -> int | None:
    """A range of which a line above says one end, and what may be known of letters the other.

    None of another range, and where more is needed.
    """
    if len(relation.options) > 1 or len(relation.only) != 2:
        return None
    ends = {*relation.only, *map(turned, relation.only)}
    for line in reversed(claims.scene.desk.lines):
        own = line.relation
        if not isinstance(own, Relation) or len(own.options) != 1 or len(own.only) != 1:
            continue
        if own.only[0] in ends and claims.scene.desk.holds(line.number):
            sides = (Binary("-", end.left, end.right) for end in relation.only)
            names = {name for side in sides for name in letters(side)}
            pool = (line.number, *claims.judge.known(names))
            written = claims.judge.write((Move("compare"),), pool, relation)
            if written is not None:
                return written
    return None


def _by_an_earlier_bound(claims: Claims, relation: Relation) -> int | None:
    """A range by a bound of letters that leads to the answer of an item above.

    What these letters have come to since is put into it, and it is solved for the letter that is
    asked: ``e > 1/k`` with e = ⅖ gives k > 5/2. None where it does not come to the range.
    """
    scene, desk = claims.scene, claims.scene.desk
    if len(relation.options) > 1 or any(link.sign not in FLIPPED for link in relation.only):
        return None
    ends = {*relation.only, *map(turned, relation.only)}
    wanted = next((s for end in ends for s in (end.left, end.right) if letters(s)), None)
    above = {ref for end in desk.ends if desk.holds(end.line) for ref in desk.under(end.line)}
    for number in sorted((e for e in above if isinstance(e, int)), reverse=True):
        own = desk.line(number).relation
        if not isinstance(own, Relation) or len(own.options) != 1 or len(own.only) != 1:
            continue
        (bound,) = own.only
        names = letters(bound.left) | letters(bound.right)
        if not isinstance(wanted, Letter) or wanted.name not in names or len(names) < 2:
            continue
        if bound.sign not in ("<", "<=", ">", ">=") or has_quantity(bound.left):
            continue
        if has_quantity(bound.right) or not desk.holds(number):
            continue
        mark, values = claims.worths.mark(), [scene.scalar(e) for e in (bound.left, bound.right)]
        with suppress(NotPlannedError):
            claims.solver.determine(values)
        sides = [scene.put(value) for value in values]
        refs = [ref for _, own_refs in sides for ref in own_refs]
        stripped = without_signs(scene, expanded(sides[0][0] - sides[1][0]), bound.sign)
        solved = None if stripped is None else solve_linear(scene, *stripped, wanted)
        if not refs or solved not in ends:
            claims.worths.back(mark)
            continue
        put = Link(tree_of(sides[0][0]), bound.sign, tree_of(sides[1][0]))
        line = claims.judge.write((Move("put"),), (number, *refs), Relation(((put,),)))
        moves, known = (Move("rearrange"), Move("compare")), claims.judge.known(names)
        for last in (Relation(((solved,),)), relation) if line is not None else ():
            line = line and claims.judge.write(moves, (line, *known), last)
        if line is not None:
            return line
        claims.worths.back(mark)
    return None


def _with_values(scene: Scene, solver: Solver, number: int, relation: Relation) -> int | None:
    """A range as a line has it in letters, with the values of these put in."""
    same = {side for link in relation.only for side in (link.left, link.right)}
    ends = [
        scene.scalar(side)
        for link in scene.desk.relation(number).only
        for side in (link.left, link.right)
        if side not in same and not has_quantity(side)
    ]
    try:
        solver.determine(ends)
        refs = [ref for end in ends for ref in scene.put(end)[1]]
    except NotPlannedError:
        return None
    return scene.judge.write((Move("put"),), (number, *refs), relation) if refs else None


def _is_range_like(own: Relation, relation: Relation) -> bool:
    """Whether two relations bound the same thing from the same sides."""
    if len(own.options) != 1 or len(own.only) != len(relation.only):
        return False
    if any(link.sign == "=" for link in own.only):
        return False
    pairs = list(zip(own.only, relation.only, strict=True))
    return all(a.sign == b.sign and (a.left == b.left or a.right == b.right) for a, b in pairs)


def _with_what_holds(claims: Claims, line: int, relation: Relation) -> int:
    """A range that is that of a letter anyway, below the given conditions: each always holds."""
    desk = claims.scene.desk
    own = desk.line(line)
    if line != len(desk.lines) or not claims.is_own_range(own.premises):
        return line
    desk.lines.pop()
    conditions = claims.conditions
    held = [ref for fact in conditions.inequalities() for ref in _held_anyway(claims, fact)]
    move = Move("compare") if held else own.move
    return desk.write(move, (*held, *own.premises), relation)


def _held_anyway(claims: Claims, fact: Fact) -> list[Ref]:
    """The line by which a condition always holds: of itself, or derived without the fact.

    Below the latter the fact is cited as well, as that line does not rest on it.
    """
    desk = claims.scene.desk
    line = claims.conditions.holding(fact)
    if line is not None or fact.kind != "given":
        return [] if line is None else [line]
    mark, withheld = claims.worths.mark(), desk.withheld
    desk.withheld = withheld | {fact.id}
    try:
        return [claims.write(fact.relation), fact.id]
    except NotPlannedError:
        claims.worths.back(mark)
        return []
    finally:
        desk.withheld = withheld


def _by_its_ratio(claims: Claims, asked: Expression, line: int, relation: Relation) -> Relation:
    """The range of an angle with its ends by the ratio that the line above bounds.

    From ``cos θ ≥ 1/3`` comes ``θ ≤ arccos(1/3)``, and not an inverse tangent.
    """
    desk = claims.scene.desk
    own = desk.line(line)
    if own.relation != relation:
        other = own.relation
        return other if isinstance(other, Relation) and _but_for_arcs(other, relation) else relation
    for ref in own.premises:
        match desk.line(ref).relation if isinstance(ref, int) else None:
            case Relation((links,)):
                bounds = [link for link in links if link.left == Apply("cos", asked)]
                bounds += [link for link in links if link.left == Apply("sin", asked)]
            case _:
                continue
        for bound in bounds:
            ratio = bound.left.function  # type: ignore[union-attr]
            inverse = Apply(f"arc{ratio}", bound.right)
            links = tuple(
                Link(_as(claims, inverse, link.left), link.sign, _as(claims, inverse, link.right))
                for link in relation.only
            )
            if links != relation.only:
                range_of_ratio = Relation((links,))
                desk.lines[line - 1] = replace(own, relation=range_of_ratio)
                return range_of_ratio
    return relation


def _but_for_arcs(own: Relation, relation: Relation) -> bool:
    """Whether a line says a range with its ends by other inverse ratios."""
    if len(own.options) != 1 or len(own.only) != len(relation.only):
        return False
    pairs = list(zip(own.only, relation.only, strict=True))
    sides = [pair for a, b in pairs for pair in ((a.left, b.left), (a.right, b.right))]
    arcs = [(a, b) for a, b in sides if a != b]
    return all(a.sign == b.sign for a, b in pairs) and all(
        isinstance(a, Apply) and isinstance(b, Apply) and {a.function, b.function} <= _ARCS
        for a, b in arcs
    )


_ARCS = {"arcsin", "arccos", "arctan"}


def _as(claims: Claims, inverse: Apply, side: Expression) -> Expression:
    """An end of a range that is an inverse tangent as the other inverse ratio that it is."""
    if not is_function(side, "arctan"):
        return side
    tangent, ratio = (claims.worths.value(tree) for tree in (side.argument, inverse.argument))
    hypotenuse = sp.sqrt(1 + tangent**2)
    own = (1 if inverse.function == "arccos" else tangent) / hypotenuse
    return inverse if claims.scene.model.identically_zero(own - ratio) else side


def relation_of(asked: Expression, result: ItemResult) -> Relation:
    """The range as a relation: ``a < x <= b``, perhaps with alternatives.

    Raises NotPlannedError for what is no interval, and no union of them.
    """
    answer = general_answer(result)
    if answer is None:
        raise NotPlannedError("a range in cases")
    own = answer.value
    assert not isinstance(own, tuple), "a range is a set"
    parts = [
        part
        for value in (own.args if isinstance(own, sp.Union) else (own,))
        for part in (map(sp.FiniteSet, value) if isinstance(value, sp.FiniteSet) else (value,))
    ]
    if not all(isinstance(part, sp.Interval | sp.FiniteSet) for part in parts):
        raise NotPlannedError("a range that is no interval")
    ends = [part.inf for part in parts]
    if len(parts) > 1 and not all((a < b) in (sp.true, sp.false) for a in ends for b in ends):
        raise NotPlannedError("a range in pieces whose order rests on letters")
    ordered = sorted(parts, key=lambda part: part.inf) if len(parts) > 1 else parts
    return Relation(tuple(_links_of(asked, value, answer.angle) for value in ordered))


def only_answer(result: ItemResult, *, always: bool = False) -> Answer:
    """The one answer of an item, which is one ``always``, for all letters, if so wanted.

    Raises NotPlannedError where there is none.
    """
    if len(result.distinct) != 1 or (always and result.distinct[0].condition):
        raise NotPlannedError("an answer in cases")
    return result.distinct[0]


def general_answer(result: ItemResult) -> Answer | None:
    """The range, or of several the one from which the others come.

    Its ends have letters, or it is not for a single value of a letter of the data alone. None where
    there are several such forms.
    """
    forms = result.distinct
    lettered = [form for form in forms if getattr(form.value, "free_symbols", None)]
    wide = [form for form in forms if any(set(text) & {"<", ">"} for text in form.condition)]
    own = next((form for form in (forms, lettered, wide) if len(form) == 1), None)
    return None if own is None else own[0]


def _links_of(asked: Expression, own: sp.Interval | sp.FiniteSet, angle: bool) -> tuple[Link, ...]:
    if isinstance(own, sp.FiniteSet):
        (value,) = own
        return (Link(asked, "=", tree_of(value, angle=angle, as_it_is=angle)),)
    links: list[Link] = []
    low, high = (_end(end, angle) for end in (own.start, own.end))
    if low is not None and high is not None:
        left: Sign = "<" if own.left_open else "<="
        right: Sign = "<" if own.right_open else "<="
        return Link(low, left, asked), Link(asked, right, high)
    if low is not None:
        links.append(Link(asked, ">" if own.left_open else ">=", low))
    if high is not None:
        links.append(Link(asked, "<" if own.right_open else "<=", high))
    if not links:
        raise NotPlannedError("a range without ends")
    return tuple(links)


def _end(value: Any, angle: bool) -> Expression | None:
    if value in (sp.oo, -sp.oo):
        return None
    return tree_of(value, angle=angle, as_it_is=angle)
