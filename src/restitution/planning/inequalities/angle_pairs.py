"""Angles that are made of two others: lines that say of which, their tangents, and their ranges."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

from restitution.explaining.lines.derivation import Link, Meaning, Move, Ref, Relation, numbers_in
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Quantity,
    Unit,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.angle_sums import write_tangent_of_sum, write_tangent_of_two
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turn_lines import (
    Term,
    by_tangents,
    made_of_angles,
    term_of_data,
    terms_of,
    write_turn,
)
from restitution.planning.angles.turning import angle_line
from restitution.planning.angles.wall_turns import sum_at_a_wall
from restitution.planning.formulas.named_angles import ANGLES, free_letter, letter_of, tangent_line
from restitution.planning.formulas.turns import turns_of
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.solving.story.letters import roles

if TYPE_CHECKING:
    from restitution.planning.inequalities.worths import Worths
    from restitution.planning.writing.scene import Scene


def is_of_two_angles(tree: Expression) -> bool:
    """Whether an expression is a sum or a difference of two angles, of which one moves."""
    match tree:
        case Binary("+" | "-", left, right):
            sides = (left, right)
            moving = [e for e in sides if is_quantity(e, "angle")]
            return bool(moving) and all(
                isinstance(e, Letter | Degrees) or e in moving for e in sides
            )
    return False


def is_beside_degrees(tree: Expression) -> bool:
    """Whether an expression is an angle that moves beside one of the data in degrees."""
    match tree:
        case Binary("+" | "-", Degrees(), _) | Binary("+" | "-", _, Degrees()):
            return is_of_two_angles(tree)
    return False


def made_of_two(scene: Scene, asked: Quantity) -> tuple[int, tuple[int, ...]] | None:
    """The line that makes an angle of two others, and those of their tangents; None without one."""
    mark = scene.desk.mark()
    frame = scene.frame(asked.stage) if asked.stage in scene.model.frames else None
    if asked.kind == "deflection" and frame is not None and frame.wall is not None:
        own = sum_at_a_wall(scene, asked, frame)
        return None if own is None else (own[0], own[1][1].refs)  # type: ignore[return-value]
    for turn in turns_of(scene, asked):
        line = write_turn(scene, turn, angle_line)
        if line is not None:
            return line, ()
        terms = terms_of(scene, turn)
        if terms is not None:
            letter, _ = letter_of(scene, asked)
            angle = turn.made_of(*(term.angle for term in terms))
            line = made_of_angles(scene, turn, chain(Letter(letter), (angle, None)), ())
            if line is not None:
                refs = (ref for term in terms for ref in term.refs)
                return line, tuple(numbers_in(refs))
        scene.desk.back(mark)
    return None


def tangent_of_two(
    scene: Scene, worths: Worths, asked: Expression
) -> tuple[int, Letter, tuple[Ref, ...]] | None:
    """The line of the tangent of a sum or a difference of two angles; None where it has none.

    With the letter for the angle, and what is known of that.
    """
    match asked:
        case Binary("+" | "-" as sign, left, right):
            pass
        case _:
            return None
    extent = "-90° < {} < 90°" if sign == "-" else "0° < {} < 180°"
    if sign == "-":
        low, high = (180 if _may_be_obtuse(side) else 90 for side in (right, left))
        extent = f"-{low}° < {{}} < {high}°"
    if (named := _named_in_the_statement(scene, worths, asked)) is not None:
        standing, called, fact = named
        return standing, called, (extent.format(called.name), fact)
    terms: list[Term] = []
    for side in (left, right):
        if isinstance(side, Quantity):
            worths.determine(side)
            own = formula(scene, side)
            if own.move.record != "tan":
                raise NotPlannedError("an angle without a tangent")
            line, letter = tangent_line(scene, side, own, own.move)
            terms.append(Term(Letter(letter), scene.desk.last_link(line).right, (line,)))
        else:
            terms.append(term_of_data(scene, side))
    whole = Binary(sign, *(term.angle for term in terms))
    name = free_letter(scene, "deflection")
    let = scene.desk.write(Move("let"), (), Meaning(name, whole, angle="signed"))
    again = _standing_tangent(scene, whole, Letter(name), let)
    if again is not None:
        return again, Letter(name), (extent.format(name), let)
    form = "sum" if sign == "+" else "difference"
    number = by_tangents(scene, let, form, terms, Apply("tan", Letter(name)))  # type: ignore[arg-type]
    return None if number is None else (number, Letter(name), (extent.format(name), let))


def tangent_with_letter(
    scene: Scene, worths: Worths, asked: Expression
) -> tuple[int, Expression, tuple[Ref, ...]]:
    """The line of the tangent of an angle, or of two, by a letter, with the letter and its range.

    Raises NotPlannedError where there is none.
    """
    if is_of_two_angles(asked):
        written = tangent_of_two(scene, worths, asked)
        if written is None:
            raise NotPlannedError("a sum or a difference of angles")
        return written
    assert isinstance(asked, Quantity)
    first = worths.angle(asked)
    tangent = scene.desk.last_link(first).left
    called = tangent.argument if isinstance(tangent, Apply) else asked
    return worths.lettered(first, called)


def _standing_tangent(scene: Scene, whole: Expression, letter: Letter, let: int) -> int | None:
    """The tangent of two angles by the letter for both, where a line gives it by these already."""
    for line in reversed(scene.desk.lines):
        match line.relation:
            case Relation(((Link(left, "="), *_),)) if left == Apply("tan", whole):
                value = scene.desk.last_link(line.number).right
                if scene.desk.holds(line.number) and letters(value) <= set(roles(scene.problem)):
                    relation = chain(Apply("tan", letter), (value, None))
                    return scene.judge.write((Move("put"),), (line.number, let), relation)
    return None


def _named_in_the_statement(
    scene: Scene, worths: Worths, asked: Expression
) -> tuple[int, Letter, Ref] | None:
    """The line of the tangent of two angles by the letter that the statement has for both.

    With the letter, and the fact that says what it is. None without such a letter.
    """
    for fact in scene.desk.facts:
        match fact.relation.options:
            case ((Link(whole, "=", Letter() as letter),),) if fact.id.startswith("let "):
                if worths.opened(whole) != asked:
                    continue
                mark = scene.desk.mark()
                line = tangent_as_asked(scene, worths, Apply("tan", letter))
                if line is not None:
                    return line, letter, fact.id
                scene.desk.back(mark)
    return None


def _may_be_obtuse(angle: Expression) -> bool:
    """Whether an angle is one to **i** or **j**, of up to 180°."""
    match angle:
        case Quantity("angle", sides):
            return any(isinstance(side, Unit | Negate) for side in sides)
    return False


def is_tangent_of_letters(tree: Expression) -> bool:
    """Whether an expression is the tangent of a sum or a difference of two letters."""
    match tree:
        case Apply("tan", Binary("+" | "-", Letter(), Letter())):
            return True
    return False


def tangent_as_asked(scene: Scene, worths: Worths, asked: Expression) -> int | None:
    """The line of such a tangent that stands, or a new one; None where it has none."""
    for line in reversed(scene.desk.lines):
        match line.relation:
            case Relation(((Link(left, "="), *_),)) if left == asked:
                own = scene.desk.last_link(line.number)
                named = {name for name in letters(own.right) if f"let {name}" in scene.facts}
                known = letters(own.right) <= set(roles(scene.problem)) - named
                if known and own.sign == "=" and scene.desk.holds(line.number):
                    return line.number
    for node in walk(worths.opened(asked)):
        if isinstance(node, Quantity) and node.kind in ANGLES:
            worths.determine(node)
    match asked:
        case Apply("tan", Letter() as letter):
            return write_tangent_of_sum(scene, letter)
    return write_tangent_of_two(scene, asked)


def extents(scene: Scene, names: Iterable[str]) -> tuple[Ref, ...]:
    """What is known of the ranges of angles of the motion, by their letters."""
    refs: list[Ref] = []
    for line in scene.desk.lines:
        meaning = line.relation
        if not isinstance(meaning, Meaning) or meaning.letter not in names:
            continue
        if isinstance(meaning.quantity, Quantity) and meaning.quantity.kind in ANGLES:
            refs += [*_texts(meaning.letter), line.number]
    for fact in scene.desk.facts:
        match fact.relation.options:
            case ((link,),) if fact.id.startswith("let ") and isinstance(link.right, Letter):
                if link.right.name in names:
                    refs += [*_texts(link.right.name), fact.id]
    return tuple(refs)


def _texts(name: str) -> tuple[str, ...]:
    """The ranges that an angle may have, as premises say them."""
    return f"0° <= {name} <= 90°", f"0° <= {name} <= 180°"


def letters_under(scene: Scene, ref: Ref) -> frozenset[str]:
    """The letters in a line."""
    if isinstance(ref, str) or isinstance(scene.desk.line(ref).relation, Meaning):
        return frozenset()
    link = scene.desk.last_link(ref)
    return letters(link.left) | letters(link.right)
