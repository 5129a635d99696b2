"""What is asked: the last lines of each item, once everything in it is known."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    Fact,
    Link,
    Meaning,
    Move,
    Ref,
    Relation,
    numbers_in,
    whole_of,
)
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    children,
    has_quantity,
    is_function,
    letters,
    walk,
)
from restitution.planning.angles.angle_sums import write_tangent_of_sum, write_tangent_of_two
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.ratios_by_speeds import write_ratio_of_path
from restitution.planning.angles.sums_of_angles import (
    angles_in,
    made_of_angles,
    write_sum_of_angles,
)
from restitution.planning.angles.turning import is_angle, write_angle
from restitution.planning.axes.by_changes import write_axis, write_wall
from restitution.planning.axes.momenta import write_by_momentum, write_total_kept
from restitution.planning.axes.opposite_impulses import is_by_vectors
from restitution.planning.closing.losses_by_products import write_loss_by_products
from restitution.planning.closing.ratios import inverse
from restitution.planning.closing.squared_ratios import (
    write_by_squares,
)
from restitution.planning.formulas.definitions import Formula, write_formula
from restitution.planning.formulas.energy_formulas import loss_by_given_speeds
from restitution.planning.formulas.fractions_lost import share_by_given_speed
from restitution.planning.formulas.impacts import after
from restitution.planning.formulas.next_walls import speed_kept
from restitution.planning.formulas.related_velocities import write_related
from restitution.planning.formulas.shares_left import speed_by_a_fact
from restitution.planning.formulas.speeds_by_energies import speed_by_its_energy
from restitution.planning.journeys import journeys
from restitution.planning.journeys.aimed_velocities import write_by_its_way
from restitution.planning.routes.closed_before import write_from_above
from restitution.planning.routes.determining import (
    determine,
    determine_by_squares,
    determine_velocities,
    write_determined,
)
from restitution.planning.routes.given_shares import write_given_share, write_given_value
from restitution.planning.routes.named_expressions import end_named_expression
from restitution.planning.routes.order import Solver
from restitution.planning.writing import place_trees
from restitution.planning.writing.angle_ratios import (
    given_ratio,
    range_of,
    ratio_of_degrees,
    write_other_ratio,
)
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.either_side import write_sides
from restitution.planning.writing.forms import ONE, difference, product, square, tree_of
from restitution.planning.writing.scene import Scene
from restitution.solving.story.letters import roles
from restitution.vector import Vector


def write_item(scene: Scene, solver: Solver, asked: Expression, name: str) -> None:
    """Writes the lines of a value that is asked.

    Raises NotPlannedError where there is no plan for it.
    """
    velocity = write_by_momentum(scene, asked)
    if velocity is not None:
        solver.take_velocity(velocity)
    at_once = _at_once(scene, asked)
    if at_once is not None:
        _end(scene, asked, name, at_once)
        return
    placed = place_trees.serves(asked) or place_trees.is_duration(asked)
    _determine(scene, solver, asked, placed=placed)
    write_related(scene, asked)
    named = scene.facts.get(f"let {asked.name}") if isinstance(asked, Letter) else None
    asked = in_a_frame(scene, asked, write=True)
    match asked:
        case Letter() | Quantity() if is_angle(scene, asked) and not _is_wall(scene, asked):
            scene.desk.end(name, *write_angle(scene, asked))
        case Apply("sin" | "cos" | "tan" as function, angle) if is_angle(scene, angle):
            scene.desk.end(name, *write_ratio_of_path(scene, function, angle))
        case Letter() | Binary() if (summed := _of_angles(scene, solver, asked)) is not None:
            scene.desk.end(name, *summed)
        case Letter() if named is not None:
            _named(scene, solver, asked, named, name)
        case Letter():
            _letter_asked(scene, asked, name)
        case _ if placed:
            line, value = journeys.write(scene, asked)
            link = scene.desk.last_link(line)
            right = link.right if link.left == asked else tree_of(value)
            scene.desk.end(name, line, chain(asked, (right, None)))
        case Apply("sin" | "cos" | "tan" as kind, Letter(letter)):
            _ratio(scene, asked, kind, letter, name)
        case Quantity():
            _quantity(scene, solver, asked, name)
        case Apply("tan") if (two := write_tangent_of_two(scene, asked)) is not None:
            _end(scene, asked, name, two)
        case Binary("*" | "/") if any(map(partial(_is_of_the_motion, scene), walk(asked))):
            _expression(scene, solver, asked, name)
        case _ if not has_quantity(asked):
            _of_letters(scene, solver, asked, name)
        case _:
            _expression(scene, solver, asked, name)


def _at_once(scene: Scene, asked: Expression) -> int | None:
    """The line of what given speeds, energies and shares tell, before anything is determined."""
    if not isinstance(asked, Quantity):
        return share_by_given_speed(scene, asked)
    loss = write_given_value(scene, asked) or loss_by_given_speeds(scene, asked)
    speed = speed_by_a_fact(scene, asked) or speed_kept(scene, asked)
    return loss or speed or write_given_share(scene, asked)


def _determine(scene: Scene, solver: Solver, asked: Expression, *, placed: bool) -> None:
    """What has to be known for an item, by what tells it at once, or by the laws.

    An impact of two spheres does not change a total, a change of momentum tells a velocity, and so
    do its size and direction.
    """
    if isinstance(asked, Quantity) and (
        write_total_kept(scene, asked)
        or is_by_vectors(scene, asked)
        or write_by_its_way(scene, asked)
    ):
        return
    if placed:
        solver.determine(journeys.goals(scene, asked))
    elif not _by_a_line_above(scene, solver, asked):
        determine_by_squares(scene, solver, asked)
        determine_velocities(scene, solver, asked)
        _determine_what_stands(scene, solver, asked)


def _end(scene: Scene, asked: Expression, name: str, line: int) -> None:
    """Ends an item with what a line has on its right."""
    scene.desk.end(name, line, chain(asked, (_right(scene, line), None)))


def _letter_asked(scene: Scene, asked: Letter, name: str) -> None:
    """A letter: by the expression that it is, by its line, or by a ratio that is given of it."""
    defining = _defining(scene, asked)
    if defining is not None:
        expression = defining.relation.only[0].right
        end_named_expression(scene, asked, defining, expression, name)
        return
    known = scene.desk.known(asked) or _by_its_given_ratio(scene, asked.name)
    if known is None:
        raise NotPlannedError(f"{asked.name} is open")
    line = _closed(scene, asked, _line_of(scene, asked, known), known.value)
    scene.desk.end(name, line, _as_solved(scene, asked, line))


def _quantity(scene: Scene, solver: Solver, asked: Quantity, name: str) -> None:
    """A quantity: by the line that has it, by what is known of it, or by its formula."""
    match asked:
        case Quantity("line_of_centres", (), int(number)):
            _axis(scene, number, name)
        case Quantity("direction", (Name(wall),), None):
            number = write_wall(scene, wall)
            scene.desk.end(name, number, scene.desk.relation(number))
        case Quantity("mass", (Name(body),)) if f"mass {body}" not in scene.facts:
            _letter(scene, asked, sp.sympify(scene.scalar(asked), strict=True), name)
        case Quantity("mass" | "restitution") | Quantity(
            "dot", (Quantity("position"), _) | (_, Quantity("position"))
        ):
            _expression(scene, solver, asked, name)
        case Quantity("along" | "across") if is_named(scene, asked):
            known = scene.desk.known(asked)
            assert known is not None
            _letter(scene, asked, next(iter(known.value.free_symbols)), name)
        case Quantity("speed") if (line := _by_its_letter(scene, asked)) is not None:
            _end(scene, scene.desk.last_link(line).left, name, line)
        case _:
            line = _line_of_a_quantity(scene, asked)
            if line is None:
                line = write_formula(scene, _determined(scene, solver, asked))
            _end(scene, asked, name, line)


def _line_of_a_quantity(scene: Scene, asked: Quantity) -> int | None:
    """The line of a quantity by what is known of it; None where only its formula gives it."""
    line = _written(scene, asked)
    if line is None and asked.kind == "speed":
        line = speed_by_its_energy(scene, asked)
    if line is None:
        line = write_by_squares(scene, asked, formula)
    if line is None and asked.kind == "energy_lost":
        line = write_loss_by_products(scene, asked)
    return line


def _determined(scene: Scene, solver: Solver, asked: Quantity) -> Formula:
    """The formula of a quantity, once everything in it is known.

    Of an impulse any of the bodies tells the size; where something is greatest or least, no
    gradient has told of its letters.
    """
    own = formula(scene, asked)
    if not scene.unknown(own.value):
        return own
    solver.determine(sorted(scene.unknown(own.value), key=str))
    return formula(scene, asked)


def _determine_what_stands(scene: Scene, solver: Solver, asked: Expression) -> None:
    """Finds the letters in the line that gives what is asked.

    Where it is greatest or least no gradient tells of them.
    """
    known = scene.desk.known(asked)
    if known is None or isinstance(known.value, Vector) or scene.others:
        return
    open_ = sorted(scene.unknown(known.value) & scene.model.final.keys(), key=str)
    if open_:
        standing = solver.mark()
        try:
            solver.determine(open_)
        except NotPlannedError:
            solver.back(standing)


def _by_a_line_above(scene: Scene, solver: Solver, asked: Expression) -> bool:
    """Whether a line above gives a letter in terms of letters that are known by now.

    It is then known by that line.
    """
    if not isinstance(asked, Letter) or scene.desk.known(asked) is not None or scene.others:
        return False
    symbol = scene.model.unknowns.letter(asked.name)
    known = scene.model.final.get(symbol)
    for line in reversed(scene.desk.lines) if known is not None else ():
        relation = line.relation
        if not isinstance(relation, Relation) or len(relation.options) != 1:
            continue
        links = relation.only
        if links[0].left != asked or any(link.sign != "=" for link in links):
            continue
        value = scene.scalar(links[-1].right)
        if value.has(sp.sin, sp.cos, sp.tan) or not value.free_symbols & scene.model.final.keys():
            continue
        if symbol in value.free_symbols or not scene.desk.holds(line.number):
            continue
        standing = solver.mark()
        with suppress(NotPlannedError):
            # Where it is greatest or least no gradient tells of its letters.
            solver.determine(sorted(value.free_symbols & scene.model.final.keys(), key=str))
            put, refs = scene.put(value)
            if refs and not scene.unknown(put) and scene.model.identically_zero(put - known):
                scene.desk.know(asked, value, (line.number,))
                return True
        solver.back(standing)
    return False


def _closed(scene: Scene, asked: Expression, line: int, value: sp.Expr) -> int:
    """The line of a value, with the letters put in that have been worked out since."""
    put, refs = scene.put(value)
    if put == value:
        return line
    if (own := _closed_angle(scene, asked, line, value)) is not None:
        return own
    right = tree_of(put, angle=_is_letter_of_angle(scene, asked))
    return scene.desk.write(Move("put"), (line, *refs), chain(asked, (right, None)))


def _is_letter_of_angle(scene: Scene, asked: Expression) -> bool:
    """Whether a letter is an angle, which is printed in degrees."""
    role = roles(scene.problem).get(asked.name) if isinstance(asked, Letter) else None
    return role is not None and role.kind == "angle"


def _closed_angle(scene: Scene, asked: Expression, line: int, angle: sp.Expr) -> int | None:
    """The line of an angle that is known by its ratio: what is known is put into that first."""
    own = scene.desk.line(line)
    ratios = numbers_in(own.premises)
    if own.move.id != "inverse" or not isinstance(asked, Letter) or len(ratios) != 1:
        return None
    link = scene.desk.last_link(ratios[0])
    functions = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan}
    ratio = next((f(angle) for n, f in functions.items() if link.left == Apply(n, asked)), None)
    if ratio is None:
        return None
    put, refs = scene.put(ratio)
    known = chain(link.left, (tree_of(put), None))
    number = scene.desk.write(Move("put"), (ratios[0], *refs), known)
    (written,) = inverse(scene, number, scene.model.unknowns.letter(asked.name)).refs
    return written if isinstance(written, int) else None


def _is_wall(scene: Scene, asked: Expression) -> bool:
    """Whether the direction of a wall is asked."""
    match asked:
        case Quantity("direction", (Name(name),), None):
            return name in scene.model.story.walls
    return False


def _expression(scene: Scene, solver: Solver, asked: Expression, name: str) -> None:
    line, value = write_determined(scene, solver, asked)
    sign = scene.desk.last_link(line).sign
    answer = chain(asked, (value, None))
    if sign == "≈":
        answer = Relation(((Link(asked, sign, value),),))
    scene.desk.end(name, line, answer)


def _is_of_the_motion(scene: Scene, tree: Expression) -> bool:
    """Whether a tree is a ratio of an angle of the motion, which the statement has as a letter."""
    match tree:
        case Apply("sin" | "cos" | "tan", Letter() as angle):
            return is_angle(scene, angle)
    return False


def _ratio(scene: Scene, asked: Apply, kind: str, letter: str, name: str) -> None:
    """A ratio of an angle that is a letter."""
    known = scene.desk.known(asked)
    if known is None and kind == "tan":
        line_ = write_tangent_of_sum(scene, Letter(letter))
        if line_ is not None:
            right = _right(scene, line_)
            scene.desk.know(asked, scene.scalar(right), (line_,))
            scene.desk.end(name, line_, chain(asked, (right, None)))
            return
    if known is None:
        symbol = scene.model.unknowns.letter(letter)
        if symbol not in scene.model.final:
            raise NotPlannedError(f"{letter} is open")
        write_other_ratio(scene, symbol, kind)
        known = scene.desk.known(asked) or ratio_of_degrees(scene, asked)
    if known is None:
        raise NotPlannedError(f"{kind} {letter} is open")
    line = _line_of(scene, asked, known)
    relation = scene.desk.relation(line)
    if len(relation.options) == 1:
        whole = whole_of(relation.only)
        stands = whole is not None and (whole.left, whole.sign) == (asked, "=")
        right = relation.only[-1].right if stands else tree_of(known.value)
        relation = chain(asked, (right, None))
    scene.desk.end(name, line, relation)


def _of_angles(scene: Scene, solver: Solver, asked: Expression) -> tuple[int, Relation] | None:
    """The line of a sum or a difference of angles of numbers, and the answer; None of another."""
    whole = made_of_angles(scene, asked)
    if whole is None:
        return None
    standing = solver.mark()
    with suppress(NotPlannedError):
        for angle in angles_in(scene, whole):
            determine(scene, solver, angle)
        symbols = scene.scalar(whole).free_symbols & scene.model.final.keys()
        solver.determine(sorted(scene.unknown(sp.Add(*symbols)), key=str))
        written = write_sum_of_angles(scene, asked)
        if written is not None:
            return written
    solver.back(standing)
    return None


def _named(scene: Scene, solver: Solver, asked: Letter, fact: Fact, name: str) -> None:
    """A letter by which the statement calls a quantity."""
    quantity = fact.relation.only[0].left
    if not isinstance(quantity, Quantity):
        end_named_expression(scene, asked, fact, quantity, name)
        return
    known = scene.desk.known(asked)
    if known is not None:
        line = _closed(scene, asked, _line_of(scene, asked, known), known.value)
        scene.desk.end(name, line, chain(asked, (_right(scene, line), None)))
        return
    if place_trees.serves(quantity):
        line, value = journeys.write(scene, quantity)
        relation = chain(asked, (tree_of(value), None))
        scene.desk.end(name, scene.desk.write(Move("put"), (line, fact.id), relation), relation)
        return
    own = _determined(scene, solver, quantity)
    if asked.name in letters(tree_of(own.value)):
        raise NotPlannedError(f"{asked.name} by itself")
    own = replace(own, quantity=asked, refs=together((fact.id,), own.refs))
    scene.desk.end(name, write_formula(scene, own), chain(asked, (tree_of(own.value), None)))


def _defining(scene: Scene, asked: Letter) -> Fact | None:
    """The given fact that a letter is an expression of quantities, where no one line has it yet."""
    known = scene.desk.known(asked)
    if known is not None and sum(isinstance(ref, int) for ref in known.refs) == 1:
        return None
    for fact in scene.desk.facts:
        if fact.kind != "given" or not scene.desk.holds(fact.id):
            continue
        match fact.relation.options:
            case ((Link(left, "=", right),),) if left == asked and has_quantity(right):
                return None if asked.name in letters(right) else fact
    return None


def _by_its_given_ratio(scene: Scene, letter: str) -> Source | None:
    """An angle of which the data give the sine, the cosine or the tangent, or those of half."""
    if letter not in scene.ratio_facts:
        return None
    own, worth, ref = given_ratio(scene, letter)
    value = scene.final(scene.model.unknowns.letter(letter))
    right = tree_of(value, angle=True, as_it_is=True)
    if isinstance(ref, int) and not (value / sp.pi).is_Rational:
        right = Apply(f"arc{own.function}", worth)
    relation = chain(Letter(letter), (right, None))
    line = scene.judge.write((Move("inverse"),), (ref, range_of(scene, letter)), relation)
    known = scene.scalar(right)
    return None if line is None else scene.desk.know(Letter(letter), known, (line,))


def _line_of(scene: Scene, asked: Expression, known: Source) -> int:
    """The line that gives a value; what is asked though it is given has one of its own."""
    lines = numbers_in(known.refs)
    if len(lines) == 1:
        return lines[0]
    relation = chain(asked, (tree_of(known.value), None))
    line = None if lines else scene.judge.write((Move("fact"),), known.refs, relation)
    if line is None:
        raise NotPlannedError("a value that rests on several lines")
    return line


def _of_letters(scene: Scene, solver: Solver, asked: Expression, name: str) -> None:
    """A ratio of an angle, or another expression of letters: it stands in a line, or is made."""
    known = scene.desk.known(asked)
    if known is not None:
        line = _line_of(scene, asked, known)
        scene.desk.end(name, line, scene.desk.relation(line))
        return
    value, refs = scene.put(scene.scalar(asked))
    if scene.unknown(value) or not any(isinstance(ref, int) for ref in refs):
        raise NotPlannedError("an expression of letters that are open")
    straight = _from_its_equation(scene, solver, asked, value, refs, name)
    if straight is not None:
        scene.desk.end(name, straight, scene.desk.relation(straight))
        return
    doubled = _of_double_angle(asked)
    if doubled is not None:
        values: dict[Expression, Expression] = {
            ratio: tree_of(scene.put(scene.scalar(ratio))[0]) for ratio in _ratios_in(doubled)
        }
        doubled_values = rebuilt(doubled, lambda tree: values.get(tree, tree))
        steps = ((doubled, None), (doubled_values, "put"), (tree_of(value), "rearrange"))
        relation = chain(asked, *steps)  # type: ignore[arg-type]
        move = Move("identity", "double-angle")
        premises = scene.judge.needed(move, refs, relation)
        if premises is not None:
            line = scene.desk.write(move, premises, relation)
            scene.desk.end(name, line, chain(asked, (tree_of(value), None)))
            return
    relation = chain(asked, (tree_of(value), None))
    lines = numbers_in(refs)
    first, *rest = lines
    several = len(scene.desk.relation(first).options) > 1
    move = Move("put") if rest or several else Move("rearrange")
    if rest or len(lines) != len(refs):
        values = {
            letter: tree_of(scene.put(scene.scalar(letter))[0]) for letter in _letters_in(asked)
        }
        whole = rebuilt(asked, lambda tree: values.get(tree, tree))
        relation = chain(asked, (whole, None), (tree_of(value), "rearrange"))
        premises = scene.judge.enough(Move("put"), refs, relation)
        if premises is None:
            raise NotPlannedError("an expression of several letters")
        line = scene.desk.write(Move("put"), premises, relation)
        scene.desk.end(name, line, chain(asked, (tree_of(value), None)))
        return
    is_size = is_function(asked, "abs")
    can_be_moved = several and not rest and not is_size
    if can_be_moved and scene.judge.follows(Move("rearrange"), (first,), relation):
        move = Move("rearrange")
    line_ = write_from_above(scene, move, first, relation)
    if line_ is None:
        line_ = scene.desk.write(move, (first,), relation)
    scene.desk.end(name, line_, relation)


def _letters_in(tree: Expression) -> Iterator[Expression]:
    """The letters of an expression, and its ratios of angles as one."""
    match tree:
        case Letter() | Apply("sin" | "cos" | "tan", Letter()):
            yield tree
        case _:
            for node in children(tree):
                yield from _letters_in(node)


def _from_its_equation(
    scene: Scene, solver: Solver, asked: Expression, value: sp.Expr, refs: Sequence[Ref], name: str
) -> int | None:
    """The line of a ratio or product of letters, by the equation that was solved for one of them.

    That letter follows from it for the items that come; after the last it is open again. None
    where the equation is not enough.
    """
    match asked:
        case Binary("*" | "/", Letter() | Apply(), Letter() | Apply()):
            lines = numbers_in(refs)
        case _:
            return None
    if len(lines) != 1 or lines[0] != len(scene.desk.lines):
        return None
    own = scene.desk.line(lines[0])
    if len(scene.desk.relation(lines[0]).options) > 1:
        return None
    known = scene.desk.last_link(lines[0])
    if own.move.id != "rearrange" or not isinstance(known.left, Letter):
        return None
    relation = chain(asked, (tree_of(value), None))
    premises = scene.judge.enough(own.move, own.premises, relation)
    if premises is None:
        return None
    letter = scene.desk.known(known.left)
    assert letter is not None
    scene.desk.take_last()
    line = scene.desk.write(own.move, premises, relation)
    scene.desk.know(asked, value, (line,))
    if name.endswith(str(len(scene.solution.items))):
        solver.reopen()
        scene.desk.shown.append(line)  # the shortest equation for either letter
        return line
    further = scene.desk.write(own.move, (line,), chain(known.left, (known.right, None)))
    scene.desk.know(known.left, letter.value, (further,))
    return line


def _of_double_angle(asked: Expression) -> Expression | None:
    """The sine, the cosine or the tangent of 2θ by those of θ; None of anything else."""
    match asked:
        case Apply(kind, Binary("*", Number() as two, Letter() as angle)) if two.value == 2:
            sine, cosine, tangent = (Apply(ratio, angle) for ratio in ("sin", "cos", "tan"))
        case _:
            return None
    doubled: dict[str, Expression] = {
        "sin": product(two, sine, cosine),
        "cos": difference(square(cosine), square(sine)),
        "tan": Binary("/", product(two, tangent), difference(ONE, square(tangent))),
    }
    return doubled.get(kind)


def _ratios_in(tree: Expression) -> set[Apply]:
    return {node for node in walk(tree) if isinstance(node, Apply)}


def _written(scene: Scene, asked: Quantity) -> int | None:
    """The line that says what a quantity is; with the letters put in that are known since.

    None where something is open in it.
    """
    known = scene.desk.known(asked)
    if known is None or len(known.refs) != 1 or not isinstance(known.refs[0], int):
        return None
    line = known.refs[0]
    if isinstance(scene.desk.line(line).relation, Meaning):
        return None  # its letter is counted against the line of centres
    if scene.desk.last_link(line).left != asked:
        return None
    put, refs = scene.put(known.value)
    if put == known.value:
        return line
    if isinstance(put, Vector):
        return None
    above = (ref for ref in scene.desk.line(line).premises if isinstance(ref, int))
    read_off = any(
        isinstance(own := scene.desk.line(ref).relation, Relation)
        and len(own.options) == 1
        and isinstance(own.only[0].left, Letter)
        and scene.model.identically_zero(scene.scalar(own.only[-1].right) - known.value)
        for ref in above
    )
    if read_off or scene.unknown(put):
        return None
    relation = chain(asked, (tree_of(tidy(put)), None))
    return scene.judge.write((Move("put"),), (line, *refs), relation)


def _by_its_letter(scene: Scene, asked: Quantity) -> int | None:
    """The line of the letter that the working has for a quantity, with nothing open in it."""
    for line in scene.desk.lines:
        if isinstance(line.relation, Meaning) and line.relation.quantity == asked:
            known = scene.desk.known(Letter(line.relation.letter))
            if known is not None and len(known.refs) == 1 and isinstance(known.refs[0], int):
                return known.refs[0]
    return None


def _axis(scene: Scene, number: int, name: str) -> None:
    """A line of centres that is asked: the line that finds it."""
    if (sides := write_sides(scene, number)) is not None:
        scene.desk.end(name, sides, scene.desk.relation(sides))
        return
    named = scene.model.frames[number].angle is not None
    lines = () if named else numbers_in(scene.frame(number).refs)
    line = lines[0] if lines else write_axis(scene, number)
    relation = scene.desk.relation(line)
    if named:
        axis = Quantity("line_of_centres", (), number)
        relation = Relation(((replace(relation.only[-1], left=axis, by=None),),))
    scene.desk.end(name, line, relation)


def in_a_frame(scene: Scene, asked: Expression, *, write: bool = False) -> Expression:
    """A component that is asked as lines say it, where its direction is one of its impact.

    With ``write`` one that does not change has its line written, where it has none.
    """
    match asked:
        case Quantity("along" | "across" as kind, (Quantity("velocity", (Name(body),), at), axis)):
            stage = scene.last_event(body, at) if isinstance(at, int) else 0
            if stage not in scene.model.frames:
                return asked
            frame = scene.frame(stage)
            own = scene.model.story.direction(axis, scene.events)
            own = own if kind == "along" else own.turned_left()
            for own_kind in COMPONENTS:
                named, direction = frame.component(own_kind, body, stage), frame.direction(own_kind)
                if tidy(own.cross(direction)) != 0 or scene.model.sign(own.dot(direction)) <= 0:
                    continue
                known = scene.desk.known(named)
                if known is None and write and own_kind == "across":
                    known = after(scene, own_kind, body, frame)
                if known is not None and len(known.refs) == 1:
                    return named
    return asked


def is_named(scene: Scene, asked: Quantity) -> bool:
    """Whether a component that is asked is one for which the working has a letter."""
    known = scene.desk.known(asked)
    components = {component.symbol for component in scene.model.components.values()}
    return known is not None and known.value in components


def _letter(scene: Scene, asked: Expression, letter: sp.Symbol, name: str) -> None:
    """A component that a letter stands for: by the line that says what the letter is."""
    tree = Letter(letter.name)
    known = scene.desk.known(tree)
    if known is None:
        raise NotPlannedError(f"{letter} is open")
    if not scene.model.identically_zero(scene.scalar(asked) - letter):
        # The axis of a working points as it was typed, the line of centres to the second sphere.
        raise NotPlannedError("a component against the line of centres")
    (line,) = (ref for ref in known.refs if isinstance(ref, int))
    relation = _as_solved(scene, tree, line)
    if len(relation.options) > 1:
        raise NotPlannedError("an answer that is one of several")
    scene.desk.end(name, line, relation)


def _right(scene: Scene, line: int) -> Expression:
    if len(scene.desk.relation(line).options) > 1:
        raise NotPlannedError("an answer that is one of several")
    return scene.desk.last_link(line).right


def _as_solved(scene: Scene, asked: Expression, line: int) -> Relation:
    """What a line says of an unknown; of several solutions, of those that are still open."""
    relation = scene.desk.relation(line)
    if scene.desk.line(line).move.id == "solve":
        options = (tuple(e for e in links if e.left == asked) for links in relation.options)
        return Relation(tuple(dict.fromkeys(options)))
    if len(relation.options) == 1:
        return chain(asked, (_right(scene, line), None))
    return relation
