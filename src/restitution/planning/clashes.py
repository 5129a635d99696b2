"""Data that contradict each other: what follows of a quantity from the others, against its datum.

One fact is left out of the part, which then has a solution. In that the lines are written that say
what the fact speaks of, and a note that the fact cannot hold with them.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import replace
from functools import partial
from itertools import product

import sympy as sp

from restitution.components.letters import protected_letters
from restitution.components.telling import model
from restitution.errors import ContradictionError, RestitutionError
from restitution.exact import in_one_ratio, tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.data.facts import facts_of, links_of
from restitution.explaining.lines.derivation import (
    FLIPPED,
    OPPOSITE,
    Link,
    Move,
    Note,
    Ref,
    Relation,
    equality,
    numbers_in,
)
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import Letter, Name, Quantity, has_quantity, letters, walk
from restitution.planning.axes.by_changes import frame_at
from restitution.planning.closing.collecting import multiplied_out
from restitution.planning.closing.ratios import inside_functions
from restitution.planning.closing.squares_in_degrees import square_in_degrees
from restitution.planning.formulas.impacts import after, residual
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.inequalities.claims import Claims
from restitution.planning.routes.determining import goals
from restitution.planning.routes.givens import write_given
from restitution.planning.routes.order import Solver
from restitution.planning.unfinished import require_followed
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import UNPLANNED, Desk, together
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.polynomials import expanded, factored, numerator, polynomial_in
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.problem import (
    Aligned,
    AtRest,
    Compare,
    Extremum,
    Given,
    Meets,
    Part,
    Problem,
    Range,
    Show,
    Step,
)
from restitution.problem import Relation as Said
from restitution.solving import solve
from restitution.solving.equations.solution import PartSolution, Solution

_SEVERAL = 2


def write_clash(
    solution: Solution, part: PartSolution, desk: Desk, names: list[str]
) -> Desk | None:
    """The desk with a fact of a part refuted by the others, and a note of that for each item.

    None where no item has such a reason, and where no fact is refuted in lines.
    """
    ranges = all(isinstance(item.item, Range | Extremum) for item in part.items)
    if (part.branches and not ranges) or not names:
        return None
    if not all(isinstance(item.error, ContradictionError) for item in part.items):
        return None
    for given, relation, events in reversed(list(_facts(solution.problem, part.part))):
        note = None
        for worked_out in (True, False):
            fork = desk.fork()
            own = partial(_refuted, solution.problem, part.part, fork, given, relation, events)
            try:
                other = own(names[0], worked_out)
            except (*UNPLANNED, RestitutionError):
                break
            if other is not None:
                draft, note = fork, other
            if note is None or not _is_in_letters_asked(part, draft, note):
                break
        if note is not None:
            for name in names:
                draft.note(name, note.kind, note.reason, premises=note.premises)
            draft.withheld = frozenset()
            return draft
    return None


def _is_in_letters_asked(part: PartSolution, desk: Desk, note: Note) -> bool:
    """Whether the last line of a contradiction still has a letter of which the value is asked."""
    asked = {
        item.item.expression.name
        for item in part.items
        if not isinstance(item.item, Show) and isinstance(item.item.expression, Letter)
    }
    lines = note.lines if note.kind == "contradiction" else ()
    return any(asked & letters(tree) for e in lines for tree in trees_of(desk.relation(e)))


def _facts(problem: Problem, part: Part) -> Iterator[tuple[Given, Said, int]]:
    """What is given of the motion in a part: equations with quantities, directions, who is at rest.

    Each has the number of events before it.
    """
    for step, events, _ in problem.timeline(part):
        if not isinstance(step, Given):
            continue
        for relation in step.relations:
            match relation:
                case AtRest() | Aligned() | Meets():
                    yield step, relation, events
                case Compare(operators=("=" | "<" | "<=" | ">" | ">=",)) if any(
                    map(has_quantity, relation.operands)
                ):
                    yield step, relation, events


def _refuted(
    problem: Problem,
    part: Part,
    desk: Desk,
    given: Given,
    relation: Said,
    events: int,
    name: str,
    worked_out: bool = True,
) -> Note | None:
    """The lines that a fact contradicts, and that it cannot hold with them.

    Unless what it speaks of is to be ``worked_out``, the fact becomes an equation.
    """
    without = _without(problem, given, relation)
    solved = solve(without)
    own = next(other for other in solved.parts.values() if other.part.label == part.label)
    if len(own.branches) != 1:
        return None
    scene = scene_without(problem, part, without, own, desk, name)
    claim = Relation((links_of(problem, relation, events),))
    from restitution.solving.equations.clash import clause_of

    note = desk.new_note(name, "contradiction", clause_of(problem, given, relation))
    late = tuple(sorted(desk.withheld))
    solver = Solver(scene)
    if worked_out and isinstance(relation, Compare) and relation.operators != ("=",):
        # With the inequality put in one sees why; a bound of the quantity alone says less.
        standing, withheld = solver.mark(), desk.withheld
        bounded = _without_a_value(replace(scene), note, late)
        if bounded is not None and _is_plain(scene, bounded):
            return bounded
        desk.withheld = withheld
        solver.back(standing)
    for write in (_across, write_worths) if worked_out else ():
        standing, start = solver.mark(), len(desk.lines)
        try:
            refs = together(write(scene, solver, claim))
            require_true(scene.model, desk.lines[start:], desk.lines, desk.facts)
            require_followed(scene, desk.lines[start:])
        except UNPLANNED:
            solver.back(standing)
            continue
        whole = replace(note, premises=together(late, refs))
        if refs and scene.judge.excludes(whole):
            bounded = _by_a_bound(scene, solver, claim, note, late)
            needed = bounded or with_what_is_needed(scene, whole)
            # As an angle is acute, a component is not zero: of another value that says nothing.
            of_a_value = isinstance(relation, Compare) and not _is_told_in_degrees(claim)
            if not (of_a_value and _rests_on_an_angle(needed)):
                return needed
        solver.back(standing)
    # A new scene, in which the fact is given again; what the letters are does not rest on it.
    if isinstance(relation, Meets | Aligned) or (
        isinstance(relation, Compare) and relation.operators != ("=",)
    ):
        bounded = _without_a_value(replace(scene), note, late)
        if bounded is not None or not isinstance(relation, Aligned):
            return bounded
    withheld = desk.withheld
    for hidden in (frozenset[str](), withheld):
        desk.withheld = hidden
        other = _without_a_root(replace(scene), note, late)
        if other is not None:
            return other
    return None


def _rests_on_an_angle(note: Note) -> bool:
    """Whether facts contradict lines only as an angle is acute."""
    return any(isinstance(ref, str) and ref.startswith("acute:") for ref in note.premises)


def _by_a_bound(
    scene: Scene, solver: Solver, claim: Relation, note: Note, late: tuple[str, ...]
) -> Note | None:
    """The bound of a quantity that a given inequality contradicts; None where it is a number."""
    link = claim.only[0]
    if link.sign not in OPPOSITE or len(claim.only) > 1 or not isinstance(link.left, Quantity):
        return None
    worth = scene.desk.known(link.left)
    lines = [] if worth is None else numbers_in(worth.refs)
    if worth is None or len(lines) != 1 or not scene.scalar(link.right).free_symbols:
        return None
    bound = Relation(((Link(link.left, OPPOSITE[link.sign], link.right),),))
    standing, start = solver.mark(), len(scene.desk.lines)
    try:
        with Claims(scene, solver) as claims:
            line = claims.monotone(lines[0], bound) or claims.compared(lines, bound)
        require_followed(scene, scene.desk.lines[start:])
    except UNPLANNED:
        line = None
    whole = None if line is None else replace(note, premises=(*late, line))
    if whole is not None and scene.judge.excludes(whole):
        return whole
    solver.back(standing)
    return None


def _is_plain(scene: Scene, note: Note) -> bool:
    """Whether one sees that the inequality of a note does not hold.

    It has one letter, or all its terms have the same sign.
    """
    (line,) = note.lines
    gap = expanded(residual(scene, line))
    if len(gap.free_symbols) < _SEVERAL:
        return True
    signs = {term.as_coeff_Mul()[0].is_negative for term in sp.Add.make_args(gap)}
    return len(signs) == 1 and not gap.atoms(sp.sin, sp.cos, sp.tan)


def _without_a_value(scene: Scene, note: Note, facts: Collection[str]) -> Note | None:
    """The bound of a letter that an inequality becomes, which no value of the letter satisfies."""
    solver = Solver(scene)
    scene.desk.withheld = frozenset()
    senses = [ref.replace("given", "sense") for ref in facts]
    own = [scene.facts[fact] for fact in (*facts, *senses) if fact in scene.facts]
    for fact in own:
        if any(link.sign not in FLIPPED for links in fact.relation.options for link in links):
            continue
        standing, start = solver.mark(), len(scene.desk.lines)
        try:
            with Claims(scene, solver) as claims:
                line = claims.conditions.condition(fact, None)
            require_followed(scene, scene.desk.lines[start:])
        except UNPLANNED:
            line = None
        if line is not None:
            trees = trees_of(scene.desk.relation(line))
            names = {name for tree in trees for name in letters(tree)}
            given = [ref for name in sorted(names) for ref in scene.judge.ranges_given(name)]
            known = (line, *given, *background(scene, names))
            whole = replace(note, kind="impossible", premises=known, claim=None)
            if scene.judge.excludes(whole):
                return with_what_is_needed(scene, whole)
        solver.back(standing)
    return None


def scene_without(
    problem: Problem, part: Part, without: Problem, own: PartSolution, desk: Desk, name: str
) -> Scene:
    """The scene of an item in a part that is solved without some of its steps.

    The facts among these are withheld from the desk. The part has one solution.
    """
    given = (fact for fact in facts_of(without) if fact.id.startswith("given "))
    kept = [(fact.relation, fact.part) for fact in given]
    desk.withheld = frozenset(
        fact.id
        for fact in facts_of(problem)
        if fact.id.startswith("given ") and (fact.relation, fact.part) not in kept
    )
    desk.item = name
    protected = protected_letters(own.part)
    story = model(
        without, own.part, own.branches[0], own.roles, protected, question=problem, paths=desk.paths
    )
    return Scene(problem, part, own, story, desk, find_frame=frame_at)


def _without_a_root(scene: Scene, note: Note, facts: Collection[str]) -> Note | None:
    """The equation that facts become, which no values of its letters satisfy."""
    solver, withheld = Solver(scene), scene.desk.withheld
    scene.desk.withheld = frozenset()
    late = [given for given in replace(scene).given if given.fact.id in facts]
    # A component may have no value by the fact alone.
    for given, by_laws in product(late, (False, True)):
        standing, start = solver.mark(), len(scene.desk.lines)
        scene.desk.withheld = withheld
        try:
            for side in (given.link.left, given.link.right) if by_laws else ():
                for goal in goals(scene, side):
                    solver.determine([goal])
            scene.desk.withheld = frozenset()
            line = write_given(scene, given)
            own = {component.symbol for component in scene.model.components.values()}
            symbols = sorted(
                residual(scene, line).free_symbols, key=lambda s: (s not in own, str(s))
            )
            names = [symbol.name for symbol in symbols]
            # What is seen from the line in a shorter form is better than what is decided of it.
            for shorter, symbol in product((True, False), symbols):
                mark = solver.mark()
                last = _of_one_ratio(scene, multiplied_out(scene, line, symbol), symbol)
                last = _of_a_square(scene, last, symbol)
                if shorter and last == line:
                    solver.back(mark)
                    continue
                require_followed(scene, scene.desk.lines[start:])
                for bounds in ((), background(scene, names)):
                    whole = replace(note, kind="impossible", premises=(last, *bounds))
                    if scene.judge.excludes(whole):
                        return with_what_is_needed(scene, whole)
                solver.back(mark)
        except UNPLANNED:
            pass
        solver.back(standing)
    return None


def _of_one_ratio(scene: Scene, line: int, angle: sp.Symbol) -> int:
    """The square of the cosine or the sine of an angle, where the line has both; or the line."""
    above = residual(scene, line)
    if not {sp.sin(angle), sp.cos(angle)} <= above.atoms(sp.sin, sp.cos):
        return line
    for kept, other in ((sp.cos(angle), sp.sin(angle)), (sp.sin(angle), sp.cos(angle))):
        square = sp.Dummy()
        alone = in_one_ratio(above, kept, other)
        if not alone.has(other) and alone.is_polynomial(kept) and sp.degree(alone, kept) == 1:
            return _of_no_square(scene, line, kept, alone)
        plain = expanded(above).xreplace({other**2: 1 - square, kept**2: square})
        if plain.has(angle) or sp.degree(plain, square) != 1:
            continue
        (value,) = sp.roots(polynomial_in(plain, square))
        relation = equality(tree_of(kept**2), tree_of(tidy(value)))
        move = Move("identity", "pythagoras")
        refs = scene.judge.enough(move, (line,), relation, background(scene, {angle.name}))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    return line


def _of_no_square(scene: Scene, line: int, ratio: sp.Expr, above: sp.Expr) -> int:
    """The cosine or the sine of an angle, where sin² + cos² = 1 leaves no square of it."""
    link = scene.desk.last_link(line)
    own = polynomial_in(above, ratio)
    other = {sp.sin: sp.cos, sp.cos: sp.sin}[ratio.func](*ratio.args)
    sides = (tree_of(in_one_ratio(scene.scalar(e), ratio, other)) for e in (link.left, link.right))
    value = tree_of(tidy(-own.nth(0) / own.nth(1)))
    known = background(scene, {str(symbol) for symbol in ratio.free_symbols})
    for move, relation in (
        (Move("identity", "pythagoras"), equality(*sides)),
        (Move("rearrange"), equality(tree_of(ratio), value)),
    ):
        refs = scene.judge.enough(move, (line,), relation, known)
        if refs is None:
            return line
        line = scene.desk.write(move, refs, relation)
    return line


def _of_a_square(scene: Scene, line: int, symbol: sp.Symbol) -> int:
    """The square of a letter, where the line is solved for that; or the line."""
    above = numerator(residual(scene, line))
    if symbol in inside_functions(above):
        return line
    poly = polynomial_in(above, symbol)
    if poly.degree() != 2 or poly.nth(1) != 0:
        return line
    in_degrees = square_in_degrees(scene, line, symbol)
    if in_degrees is None:
        value = tree_of(tidy(factored(-poly.nth(0) / poly.nth(2))))
    else:
        value = tree_of(in_degrees, as_it_is=True)
    relation = equality(tree_of(symbol**2), value)
    return in_another_form(scene, line, relation) or line


def with_what_is_needed(scene: Scene, note: Note) -> Note:
    """A note without the premises that it can do without."""
    for other in note.premises:
        less = replace(note, premises=tuple(ref for ref in note.premises if ref != other))
        if less.lines and scene.judge.excludes(less):
            note = less
    return note


def _without(problem: Problem, given: Given, relation: Said) -> Problem:
    """The problem without one relation of a step of facts."""

    def steps(part: Part) -> Iterator[Step]:
        for step in part.steps:
            if step is not given:
                yield step
                continue
            left = tuple(other for other in given.relations if other is not relation)
            if left:
                yield replace(given, relations=left)

    return replace(
        problem, parts=tuple(replace(part, steps=tuple(steps(part))) for part in problem.parts)
    )


def _across(scene: Scene, solver: Solver, claim: Relation) -> Iterator[Ref]:
    """The components across the line of centres of the velocities in a fact."""
    for body, stage in _velocities(claim):
        if stage in scene.model.frames:
            frame = scene.frame(stage)
            source = after(scene, "across", body, frame)
            names = symbol_names(source.value)
            yield from (*source.refs, *frame.refs, *background(scene, names))


def _velocities(claim: Relation) -> Iterator[tuple[str, int]]:
    for link in claim.only:
        for side in (link.left, link.right):
            for node in walk(side):
                match node:
                    case Quantity("velocity" | "direction", (Name(body),), int(stage)) if stage:
                        yield body, stage


def _is_told_in_degrees(claim: Relation) -> bool:
    """Whether a fact tells a direction by its angle."""
    left = claim.only[0].left
    return isinstance(left, Quantity) and left.kind in ("angle", "direction")


def write_worths(scene: Scene, solver: Solver, claim: Relation) -> Iterator[Ref]:
    """What the quantities of a fact are worth."""
    with Claims(scene, solver) as claims:
        for link in claim.only:
            for side in (link.left, link.right):
                for quantity in claims.worths.quantities(side):
                    if not claims.worths.is_data(quantity):
                        yield claims.worths.angle_by_letter(quantity) or claims.worths.quantity(
                            quantity
                        )
