"""Items without a plan: what of them can be written, and a note with the answer."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from fractions import Fraction
from functools import partial

import sympy as sp

from restitution import exact
from restitution.explaining.data.facts import links_of, staged
from restitution.explaining.lines.derivation import Line, Link, Meaning, Move, Ref, Relation
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    has_quantity,
    letters,
    walk,
)
from restitution.planning.angles.expressions import write_expression
from restitution.planning.closing.excluded_roots import written_law
from restitution.planning.formulas.impacts import (
    momentum,
    rebound,
    residual,
    restitution,
    unchanged,
)
from restitution.planning.inequalities.ranges import relation_of
from restitution.planning.routes.course import EquationLeftOpenError, is_root_in_figures
from restitution.planning.routes.determining import determine, goals
from restitution.planning.routes.givens import write_given
from restitution.planning.routes.order import Solver
from restitution.planning.routes.refusals import note_of
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import UNPLANNED, Desk, NotPlannedError, Source
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import numerator, polynomial_in
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.problem import Item, Meets, Problem, Range, Show, Value, trees_of_relation
from restitution.solving.equations.solution import Answer, ItemResult


def write_unfinished(
    scene: Scene, solver: Solver, item: Item | Show, result: ItemResult, now: int, name: str
) -> None:
    """Writes the quantities in an item, as far as there is a plan, and notes its answer."""
    trees = [staged(scene.problem, tree, now) for tree in _trees(item)]
    premises: list[int] = []
    # Of several solutions only the equations are the same.
    ways = (_open_equations, _values, _components, _equations)
    for attempts in (_equations,) if scene.others else ways:
        for attempt in attempts(scene, solver, trees):
            premises += _tried(scene, solver, attempt)
        if premises:
            break
    claim = answer_of(scene.problem, item, result, now)
    note_unwritten(scene.desk, result, name, tuple(dict.fromkeys(premises)), claim)


Attempt = Callable[[], Iterable[int]]
"""Writes lines, and gives the last of them. Raises NotPlannedError where there is no plan."""


def _tried(scene: Scene, solver: Solver, write: Attempt) -> list[int]:
    """The lines of a way in which each line follows; none of one that fails."""
    standing, start = solver.mark(), len(scene.desk.lines)
    try:
        numbers = list(write())
        lines = scene.desk.lines
        require_true(scene.model, lines[start:], lines, scene.desk.facts)
        require_followed(scene, lines[start:])
    except UNPLANNED:
        solver.back(standing)
        return []
    return numbers


def require_followed(scene: Scene, lines: Iterable[Line]) -> None:
    """Raises NotPlannedError for a line that does not follow by its move."""
    for line in lines:
        if isinstance(line.relation, Meaning):
            continue
        if not scene.judge.follows(line.move, line.premises, line.relation):
            raise NotPlannedError(f"line {line.number} does not follow")


def note_unwritten(
    desk: Desk,
    result: ItemResult,
    name: str,
    premises: Sequence[int] = (),
    claim: Relation | None = None,
) -> None:
    """Notes that the way to an item is not written out: its answer, or why it has none.

    ``premises`` are the lines from which the way would go on; ``claim`` is the answer as lines say
    it, where they can.
    """
    if result.error is not None:
        note_of(desk, result, name, premises)
        return
    outcome = {True: "shown", False: "not true", None: "not decided"}[result.holds]
    # What holds under conditions is no choice.
    between = "; " if any(answer.condition for answer in result.distinct) else " or "
    answers = between.join(answer.display for answer in result.distinct)
    reason = outcome if result.kind == "show" else answers
    desk.note(name, "unwritten", reason, premises=tuple(premises), claim=claim)


def end_where_standing(desk: Desk, names: Collection[str]) -> None:
    """Ends items whose steps were not written out at the line that a later one has written."""
    for note in [note for note in desk.notes if note.kind == "unwritten" and note.item in names]:
        if note.claim is None or len(note.claim.options) != 1:
            continue
        ends = note.claim.only[0].left, note.claim.only[-1].right
        for line in desk.lines:
            match line.relation:
                case Relation((links,)) if (links[0].left, links[-1].right) == ends:
                    if all(link.sign == "=" for link in (*links, *note.claim.only)):
                        desk.notes.remove(note)
                        desk.end(note.item, line.number, note.claim)
                        break


def answer_of(problem: Problem, item: Item | Show, result: ItemResult, now: int) -> Relation | None:
    """The answer of an item as a relation; None where no line could say it."""
    if any(answer.condition for answer in result.distinct):
        return None
    try:
        match item:
            case Show(Meets(Name(one), Name(other)), None) if not {one, other} & {
                wall.name for wall in problem.walls
            }:
                # What was not written out of a meeting may be by way of a wall: words say it.
                return None
            case Show(relation, None) if result.holds:
                links = links_of(problem, relation, now)
                return Relation((links,)) if links else None
            case Range(expression):
                return relation_of(staged(problem, expression, now), result)
            case Value(expression):
                asked = staged(problem, expression, now)
                return Relation(tuple((_stated(asked, own),) for own in result.distinct))
    except UNPLANNED:
        pass
    return None


def _stated(asked: Expression, answer: Answer) -> Link:
    """A value as a line says it; the root of a cubic, which has no exact form, in figures."""
    value = answer.value
    if isinstance(value, sp.Expr) and is_root_in_figures(value) and not answer.angle:
        number = Number(Fraction(exact.significant(abs(value))))
        return Link(asked, "≈", Negate(number) if value.is_negative else number)
    return Link(asked, "=", tree_of(value, angle=answer.angle, as_it_is=answer.angle))


def _trees(item: Item | Show) -> Iterator[Expression]:
    """The trees in an item."""
    if not isinstance(item, Show):
        yield item.expression
        return
    yield from trees_of_relation(item.relation)
    if item.subject is not None:
        yield item.subject.expression


def _open_equations(scene: Scene, solver: Solver, trees: Sequence[Expression]) -> Iterator[Attempt]:
    """The equations of which letters are roots that have no exact form."""
    for name in sorted({name for tree in trees for name in letters(tree)}):
        symbol = scene.model.unknowns.letter(name)
        if is_root_in_figures(scene.model.final.get(symbol)):
            yield partial(_open_equation, scene, solver, symbol)


def _open_equation(scene: Scene, solver: Solver, symbol: sp.Symbol) -> Iterator[int]:
    """The equation as it comes of the laws, and as a polynomial that is zero."""
    solver.leaves_open = True
    try:
        solver.determine([symbol])
    except EquationLeftOpenError:
        number = len(scene.desk.lines)
        above = numerator(residual(scene, number))
        if symbol not in above.free_symbols or not above.is_polynomial(symbol):
            raise NotPlannedError(f"no polynomial in {symbol}") from None
        own = polynomial_in(above, symbol).primitive()[1].as_expr()
        relation = Relation(((Link(tree_of(own), "=", ZERO),),))
        yield scene.judge.write((Move("rearrange"),), (number,), relation) or number
    finally:
        solver.leaves_open = False


def _values(scene: Scene, solver: Solver, trees: Sequence[Expression]) -> Iterator[Attempt]:
    """What the expressions come to."""
    for tree in trees:
        if has_quantity(tree):
            yield partial(_value, scene, solver, tree)


def _value(scene: Scene, solver: Solver, tree: Expression) -> Iterator[int]:
    determine(scene, solver, tree)
    yield write_expression(scene, tree)[0]


def _components(scene: Scene, solver: Solver, trees: Sequence[Expression]) -> Iterator[Attempt]:
    """What letters are, and everything of which the quantities are made."""
    for tree in trees:
        for name in sorted(letters(tree)):
            symbol = scene.model.unknowns.letter(name)
            if symbol in scene.model.final:
                yield partial(_goals, scene, solver, Letter(name))
        yield from (
            partial(_goals, scene, solver, e) for e in walk(tree) if isinstance(e, Quantity)
        )


def _goals(scene: Scene, solver: Solver, tree: Expression) -> Iterator[int]:
    for goal in goals(scene, tree):
        solver.determine([goal])
        yield from _lines(scene, scene.put(goal)[1])


def _lines(scene: Scene, refs: Iterable[Ref]) -> Iterator[int]:
    for ref in refs:
        if isinstance(ref, int) and not isinstance(scene.desk.line(ref).relation, Meaning):
            yield ref


def _equations(scene: Scene, solver: Solver, trees: Sequence[Expression]) -> Iterator[Attempt]:
    """The principles of each impact, and what is given."""
    del solver, trees
    for number, own in sorted(scene.model.frames.items()):
        if own.wall is None:
            yield partial(_law, scene, number, "momentum", momentum)
            yield partial(_law, scene, number, "restitution", restitution)
        else:
            for body in scene.spheres(number):
                for write in (unchanged, rebound):
                    yield partial(_at_a_wall, scene, number, body, write)
    for equation in scene.given:
        yield partial(_given, scene, equation)


def _law(
    scene: Scene, number: int, record: str, write: Callable[[Scene, Frame], int]
) -> Iterator[int]:
    yield written_law(scene, record, number) or write(scene, scene.frame(number))


def _at_a_wall(
    scene: Scene, number: int, body: str, write: Callable[[Scene, str, Frame], Source]
) -> Iterator[int]:
    yield from _lines(scene, write(scene, body, scene.frame(number)).refs)


def _given(scene: Scene, given: GivenEquation) -> Iterator[int]:
    yield write_given(scene, given)


__all__ = ["end_where_standing", "note_unwritten", "require_followed", "write_unfinished"]
