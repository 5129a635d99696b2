"""What is to be shown: forward from the laws to the printed form, which is the last line."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import sympy as sp

from restitution.exact.symbols import symbol_names
from restitution.explaining.data.facts import links_of, staged
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, equality
from restitution.explaining.lines.trees import exchanged, has_ratio_of_a_sum
from restitution.expression.quantities import ENERGIES, UNSIGNED_ANGLES
from restitution.expression.tree import (
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
    is_component,
    is_quantity,
    letters,
)
from restitution.planning.angles.expressions import is_angle_sum, write_expression
from restitution.planning.angles.turning import angle_line, is_angle, quantity_of
from restitution.planning.formulas.next_walls import speed_kept
from restitution.planning.formulas.velocity_formulas import frame_after
from restitution.planning.inequalities.angles_at_ends import write_at_ends
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.coming_back import write_meeting_again
from restitution.planning.inequalities.comparisons import Comparison
from restitution.planning.inequalities.extrema import write_extremum
from restitution.planning.inequalities.extrema_above import write_by_a_bound_above
from restitution.planning.inequalities.ranges import write_range
from restitution.planning.routes.determining import determine
from restitution.planning.routes.items import in_a_frame, is_named
from restitution.planning.routes.order import Solver
from restitution.planning.shows.refuting import write_refutation
from restitution.planning.shows.shown_angles import is_form_of, says
from restitution.planning.shows.shown_directions import write_aligned, write_right_angle
from restitution.planning.shows.shown_equations import (
    LAST,
    ShownEquation,
    outermost_quantities,
)
from restitution.planning.writing.angle_ratios import write_other_ratio
from restitution.planning.writing.desk import UNPLANNED, NotPlannedError, chain
from restitution.planning.writing.forms import (
    ONE,
    ZERO,
    swept,
)
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.problem import (
    Aligned,
    AtRest,
    Compare,
    Extremum,
    Meets,
    Range,
    Show,
    trees_of_relation,
)
from restitution.solving.equations.solution import ItemResult
from restitution.vector import Vector

# What later items take as it is shown, and do not work out again.
_QUOTED = ENERGIES | {"speed", "impulse"}


def write_show(
    scene: Scene, solver: Solver, item: Show, result: ItemResult, now: int, name: str
) -> None:
    """Writes the lines of what is to be shown. Raises NotPlannedError where there is no plan."""
    if result.holds is not True:
        write_refutation(scene, solver, item, result, now, name)
        return
    if item.subject is not None:
        _of_subject(scene, solver, item, now, name)
        return
    line, relation = (
        _angle_shown(scene, solver, item, now)
        or _speed_kept(scene, item, now)
        or _written(scene, solver, item, now)
    )
    _print_form(scene, line, relation)
    scene.desk.end(name, line, relation, shown=True)
    _quotable(scene, line, relation)
    _forget_turned(scene, relation)


def _forget_turned(scene: Scene, relation: Relation) -> None:
    """Forgets the letters by which something is shown, where they had been found from that.

    Where ``tan θ = 3e/(2 + e)`` comes of ``e = 2 tan θ/(3 − tan θ)``, e is what θ goes by now.
    """
    link = relation.ends
    if link is None or has_quantity(link.left) or has_quantity(link.right):
        return
    for letter in map(Letter, sorted(letters(link.right) - letters(link.left))):
        source = scene.desk.known(letter)
        if source and symbol_names(source.value) & letters(link.left):
            scene.desk.forget_value(letter, source)


def _angle_shown(scene: Scene, solver: Solver, item: Show, now: int) -> tuple[int, Relation] | None:
    """The line of an angle that is to be shown: as degrees, or as a letter of the data."""
    match item.relation:
        case Compare((Binary() as shown, Degrees()), ("=",), None) if is_angle_sum(shown):
            (link,) = links_of(scene.problem, item.relation, now)
        case Compare((Quantity("direction", (Name(),)), Degrees()), ("=",), None):
            (link,) = links_of(scene.problem, item.relation, now)
        case Compare((shown, Letter()), ("=",), None) if is_angle(scene, shown):
            (link,) = links_of(scene.problem, item.relation, now)
        case _:
            return None
    standing = solver.mark()
    try:
        for quantity in outermost_quantities(scene.opened(link).left):
            determine(scene, solver, quantity)
        if is_angle(scene, link.left):
            line = angle_line(scene, quantity_of(scene, link.left))
        else:
            line, _ = write_expression(scene, link.left)
    except NotPlannedError:
        solver.back(standing)
        return None
    if scene.desk.last_link(line) != link:
        solver.back(standing)
        return None
    return line, Relation(((link,),))


def _speed_kept(scene: Scene, item: Show, now: int) -> tuple[int, Relation] | None:
    """The line of a speed after walls with e = 1 that is to be shown; None of all else."""
    match item.relation:
        case Compare((Quantity("speed", (Name(),)), _), ("=",), None):
            (link,) = links_of(scene.problem, item.relation, now)
        case _:
            return None
    mark = scene.desk.mark()
    line = speed_kept(scene, link.left) if isinstance(link.left, Quantity) else None
    if line is None or scene.desk.relation(line) != Relation(((link,),)):
        scene.desk.back(mark)
        return None
    return line, Relation(((link,),))


def _written(scene: Scene, solver: Solver, item: Show, now: int) -> tuple[int, Relation]:
    """The lines of what is to be shown.

    The letters in which it is printed stand for themselves first, though facts tie them to others;
    then all that facts tie; and then those alone that it names, the others being put in.
    """
    standing = solver.mark()
    by_zero = _by_a_zero(scene, solver, item, now)
    if by_zero is not None:
        return by_zero
    printed = _printed_letters(scene, item, now)
    refusal: NotPlannedError | None = None
    for attempt in ("printed", "tied", "named") if printed else ("tied", "named"):
        facts = frozenset[str]()
        with Claims(scene, solver) as claims:
            if attempt == "printed":
                scene.free |= printed
                facts = _facts_about(scene, item, now) - solver.equations.used
            if attempt == "named":
                unnamed = {value for value in scene.free if value.name not in _names(item)}
                if not unnamed:
                    break
                scene.free -= unnamed
            solver.equations.used |= facts
            try:
                line, relation = _line(claims, item, now)
            except NotPlannedError as error:
                refusal = refusal or error
                solver.back(standing)
                continue
            solver.equations.used -= facts
            return line, relation
    assert refusal is not None
    by_shown = _by_what_was_shown(scene, solver, item, now)
    if by_shown is None:
        solver.back(standing)
        raise refusal
    return by_shown


def _equation_of_a_quantity(
    scene: Scene, item: Show, now: int, beside_data: bool = False
) -> Link | None:
    """The claim that a quantity has a value without quantities; None where it is another.

    ``beside_data`` also that it is a multiple of one at the start.
    """
    match item.relation:
        case Compare(operators=("=",), figures=None):
            (link,) = links_of(scene.problem, item.relation, now)
        case _:
            return None
    others = [] if beside_data and _is_of_the_start(scene.opened(link).right) else [link.right]
    return None if any(map(has_quantity, others)) or not has_quantity(link.left) else link


def _is_of_the_start(tree: Expression) -> bool:
    """Whether the quantities in a tree are those of bodies before anything happens to them."""
    return all(quantity.stage == 0 for quantity in outermost_quantities(tree))


def _by_a_zero(scene: Scene, solver: Solver, item: Show, now: int) -> tuple[int, Relation] | None:
    """A quantity by the one law that is in the letters of the claim, as a component is zero."""
    if _equation_of_a_quantity(scene, item, now) is None:
        return None
    standing = solver.mark()
    with Claims(scene, solver) as claims:
        if any(solver.express_by_zero(given, _names(item)) for given in scene.given):
            with suppress(NotPlannedError):
                return _line(claims, item, now)
    solver.back(standing)
    return None


def _by_what_was_shown(
    scene: Scene, solver: Solver, item: Show, now: int
) -> tuple[int, Relation] | None:
    """A quantity worked out without a letter that is tied, which an equation puts in last.

    That was to be shown, or is what the facts say of these letters.
    """
    link = _equation_of_a_quantity(scene, item, now, beside_data=True)
    if link is None:
        return None
    shown = [number for number in scene.desk.shown if scene.desk.holds(number)]
    relation = Relation(((link,),))
    with Claims(scene, solver) as claims:
        shown = shown or claims.ties.lines()
        if not shown:
            return None
        scene.free.clear()
        try:
            worth = claims.worths.worth(claims.worths.opened(link.left))
            right = claims.worths.opened(link.right)
            data = [claims.worths.quantity(own) for own in outermost_quantities(right)]
        except NotPlannedError:
            return None
        known = claims.judge.known(letters(link.right))
        if worth is None:
            return None
        for number in shown:
            pool: list[Ref] = [worth, *data, number, *known]
            line = claims.judge.write((Move("put"), Move("rearrange")), pool, relation)
            if line is not None:
                return line, relation
    return None


def _names(item: Show) -> frozenset[str]:
    """The letters in what is to be shown."""
    return frozenset(name for tree in trees_of_relation(item.relation) for name in letters(tree))


def _print_form(scene: Scene, line: int, relation: Relation) -> None:
    """Gives a line that says what is to be shown, in another order of factors, the printed form."""
    own = scene.desk.relation(line)
    if len(own.options) != 1 or len(relation.only) != 1 or relation.only[0].sign != "=":
        return
    (link,), links = relation.only, own.only
    right = links[-1].right
    same = links[0].left == link.left and right != link.right
    if same and is_form_of(scene, (right, link.right)):
        scene.desk.reword(line, link.right)


def _printed_letters(scene: Scene, item: Show, now: int) -> frozenset[sp.Symbol]:
    """Letters in which a quantity is to be shown, though facts of the part say what they are."""
    match item.relation:
        case Compare(operators=("=",), figures=None):
            (link,) = links_of(scene.problem, item.relation, now)
        case _:
            return frozenset()
    left, right = scene.opened(link).left, scene.opened(link).right
    if not has_quantity(left) or has_quantity(right):
        return frozenset()
    names = letters(right)
    return frozenset(value for value in scene.model.final if value.name in names)


def _facts_about(scene: Scene, item: Show, now: int) -> frozenset[str]:
    """The given facts that speak of the quantity that is to be shown: it is not shown by these."""
    assert isinstance(item.relation, Compare)
    (link,) = links_of(scene.problem, item.relation, now)
    shown = set(outermost_quantities(scene.opened(link).left))
    return frozenset(
        equation.fact.id
        for equation in scene.given
        if shown & set(outermost_quantities(equation.link.left, equation.link.right))
    )


def _quotable(scene: Scene, line: int, relation: Relation) -> None:
    """What is shown is known from here on: the value of a quantity, or an equation of letters."""
    if len(relation.options) != 1 or len(relation.only) != 1 or relation.only[0].sign != "=":
        return
    (link,) = relation.only
    if has_quantity(link.right) or scene.desk.last_link(line) != link:
        return
    match link.left:
        case Quantity(kind, whom, int()) if kind in _QUOTED and not (kind == "impulse" and whom):
            scene.desk.know(link.left, scene.scalar(link.right), (line,))
        case Quantity("distance", (_, _)):
            scene.desk.know(link.left, scene.scalar(link.right), (line,))
        case Quantity("velocity", (Name(),), int()) if isinstance(
            vector := scene.value(link.right), Vector
        ):
            scene.desk.know(link.left, vector, (line,))
        case Letter(name) if f"let {name}" in scene.facts:
            scene.desk.know(link.left, scene.scalar(link.right), (line,))
        case Apply("tan", Letter(name)) if f"let {name}" in scene.facts:
            scene.desk.know(link.left, scene.scalar(link.right), (line,))
        case Apply("tan", Quantity(kind, _, int() | None)) if kind in UNSIGNED_ANGLES:
            scene.desk.know(link.left, scene.scalar(link.right), (line,))
        case Letter() as own if is_quantity(scene.desk.meant(own), *UNSIGNED_ANGLES):
            scene.desk.know(own, scene.scalar(link.right), (line,))
        case Binary("^", Quantity("speed", _, int()), Number(2)):
            scene.desk.know(link.left, scene.scalar(link.right), (line,))
        case left if not has_quantity(left) and not scene.lets_in(link):
            scene.desk.shown.append(line)


def _of_subject(scene: Scene, solver: Solver, item: Show, now: int, name: str) -> None:
    assert item.subject is not None
    assert isinstance(item.relation, Compare)
    asked = staged(scene.problem, item.subject.expression, now)
    links = links_of(scene.problem, item.relation, now)
    match item.subject:
        case Range():
            write_range(scene, solver, asked, Relation((links,)), name, shown=True)
        case Extremum():
            (link,) = links
            value = sp.sympify(scene.scalar(link.right), strict=True)
            over = item.subject.over
            write_extremum(
                scene, solver, item.subject.kind, asked, over, None, value, name, link.right
            )


def _line(claims: Claims, item: Show, now: int) -> tuple[int, Relation]:
    scene = claims.scene
    match item.relation:
        case Compare(operators=("=",), figures=int()):
            return _to_figures(claims, links_of(scene.problem, item.relation, now)[0])
        case Compare(operators=("=",)):
            (link,) = links_of(scene.problem, item.relation, now)
            opened = scene.opened(link)
            match opened:
                case Link(Quantity("angle", pair), _, Degrees(value)) if value == 90:
                    return write_right_angle(claims, pair, opened, link)
            if isinstance(link.left, Quantity) and _is_angle_in_numbers(link):
                claims.worths.determine(link.left)
                for velocity in link.left.arguments if _is_common(link) else ():
                    claims.worths.determine(velocity)  # its sense, which no ratio has
                line = angle_line(scene, link.left)
                return line, scene.desk.relation(line)
            if (turned := _turned_by(claims, link)) is not None:
                return turned, scene.desk.relation(turned)
            for shown in (_again, _component_shown, _letter_shown, _inverse_shown):
                if (known := shown(claims, link)) is not None:
                    return known
            return ShownEquation(claims, link).write(), Relation(((link,),))
        case Compare(operators=operators) if "=" not in operators:
            links = links_of(scene.problem, item.relation, now)
            relation = Relation((links,))
            if len(links) == 1 and _is_of_components(links[0]):
                mark = claims.worths.mark()
                try:
                    return Comparison(claims).write(links[0])
                except NotPlannedError:
                    claims.worths.back(mark)
            above = write_by_a_bound_above(claims, links[0]) if len(links) == 1 else None
            if above is not None:
                return above, relation
            mark = claims.worths.mark()
            try:
                return claims.write(relation), relation
            except UNPLANNED:
                claims.worths.back(mark)
                return write_at_ends(claims, claims.solver, relation), relation
        case Meets():
            again = write_meeting_again(claims, item.relation, now)
            return again or _first_meeting(claims, item.relation, now)
        case AtRest(body):
            quantity = staged(scene.problem, Quantity("velocity", (body,)), now)
            link = Link(quantity, "=", ZERO)
            return ShownEquation(claims, link).write(), Relation(((link,),))
        case Aligned():
            return write_aligned(claims, item.relation, now)
    raise NotPlannedError("a show of several equations")


def _is_of_components(link: Link) -> bool:
    """Whether two components along one line are compared."""
    match link.left, link.right:
        case Quantity("along", (_, one)), Quantity("along", (_, other)):
            return one == other
    return False


def _again(claims: Claims, link: Link) -> tuple[int, Relation] | None:
    """What the end of an item says already, in another form."""
    desk, relation = claims.scene.desk, Relation(((link,),))
    for number in sorted({end.line for end in desk.ends}, reverse=True):
        if desk.holds(number) and len(desk.relation(number).options) == 1:
            first, last = desk.relation(number).only[0], desk.last_link(number)
            if (first.left, first.sign) == (link.left, "=") and last.right != link.right:
                line = claims.judge.write((Move("rearrange"),), [number], relation)
                if line is not None:
                    return line, relation
    return None


def _component_shown(claims: Claims, link: Link) -> tuple[int, Relation] | None:
    """A component to be shown for which the working has a letter: the line of that."""
    if not is_component(link.left):
        return None
    scene, mark = claims.scene, claims.worths.mark()
    if has_quantity(link.right):
        return None
    claims.worths.determine(link.left)
    asked = in_a_frame(scene, link.left)
    named = scene.desk.known(asked)
    letter = None
    if isinstance(asked, Quantity) and named is not None and is_named(scene, asked):
        letter = Letter(str(named.value))
    known = None if letter is None else scene.desk.known(letter)
    line = next((ref for ref in known.refs if isinstance(ref, int)), None) if known else None
    if letter is not None and line is not None:
        relation = chain(letter, (link.right, None))
        if scene.desk.last_link(line).right != link.right:
            names = claims.judge.known(letters(link.right))
            line = claims.judge.write((Move("rearrange"),), [line, *names], relation)
        if line is not None:
            return line, relation
    claims.worths.back(mark)
    return None


def _inverse_shown(claims: Claims, link: Link) -> tuple[int, Relation] | None:
    """An angle that is printed by its tangent, in degrees or letters: its tangent comes first."""
    tangent: Expression | None = None
    match link:
        case Link(Quantity(kind) as quantity, "=", Apply("arctan", tangent)) if (
            kind in UNSIGNED_ANGLES
        ):
            pass
        case Link(Quantity("angle") as quantity, "=", right) if not has_quantity(right):
            pass
        case _:
            return None
    scene, mark = claims.scene, claims.worths.mark()
    try:
        line = claims.worths.angle(quantity)
        own = scene.desk.last_link(line)
        if not isinstance(own.left, Apply):
            raise NotPlannedError("an angle without a tangent")
        if tangent is not None and own.right != tangent:
            names = claims.judge.known(letters(own.right) | letters(tangent))
            form = claims.judge.write(LAST, [line, *names], chain(own.left, (tangent, None)))
            if form is None:
                raise NotPlannedError("another form of a tangent")
            line = form
        line, angle, extent = claims.worths.lettered(line, own.left.argument)
        line = _by_ratio_of(claims, line, link.right)
        relation = chain(angle, (link.right, None))
        bounds = () if tangent is not None else claims.judge.known(letters(link.right))
        last = claims.judge.write((Move("inverse"),), [line, *extent, *bounds], relation)
        if last is not None:
            return last, relation
    except NotPlannedError:
        pass
    claims.worths.back(mark)
    return None


def _by_ratio_of(claims: Claims, line: int, angle: Expression) -> int:
    """The line of a ratio as that of an angle in letters: cos β = cos 2φ, by the formulae.

    The line itself where no formula says so.
    """
    scene, own = claims.scene, claims.scene.desk.last_link(line)
    if not letters(angle) or not isinstance(own.left, Apply):
        return line
    whole, first = Apply(own.left.function, angle), line
    written = scene.desk.line(line)
    links = scene.desk.relation(line).only
    if links[-1].by == "identity" and has_ratio_of_a_sum(links[0].right):
        # Its value takes both identities: the quotient stands, and each of them has a line.
        own = links[0]
        scene.desk.rewrite(replace(written, relation=Relation(((own,),))))
    known = claims.judge.known(letters(own.right) | letters(angle))
    if is_binary(own.right, "/"):
        sizes = sp.trigsimp(scene.scalar(own.right.right)).free_symbols
        ones: dict[Expression, Expression] = {Letter(s.name): ONE for s in sizes}
        plain = swept(exchanged(own.right.left, ones))  # the speeds of both cancel
        pythagoras = (Move("identity", "pythagoras"),)
        relation = chain(own.left, (plain, None))
        first = claims.judge.write(pythagoras, [line, *known], relation) or line
    relation = chain(own.left, (whole, None))
    moves = (Move("identity", "sum-of-angles"), Move("identity", "double-angle"))
    last = claims.judge.write(moves, [first, *known], relation)
    if last is None:
        scene.desk.rewrite(written)
        return line
    return last


def _letter_shown(claims: Claims, link: Link) -> tuple[int, Relation] | None:
    """A letter that the facts fix, or a ratio of it, worked out as one that is asked.

    It is then brought into the printed form.
    """
    scene, mark = claims.scene, claims.worths.mark()
    match link.left:
        case Letter(name) | Apply("sin" | "cos" | "tan", Letter(name)):
            pass
        case _:
            return None
    if f"let {name}" in scene.facts or has_quantity(link.right) or name in letters(link.right):
        return None
    symbol = scene.model.unknowns.letter(name)
    if symbol not in scene.unknown(symbol):
        return None
    try:
        claims.solver.determine([symbol])
    except NotPlannedError:
        claims.worths.back(mark)
        return None
    if isinstance(link.left, Apply) and scene.desk.known(link.left) is None:
        write_other_ratio(scene, symbol, link.left.function)
    known = scene.desk.known(link.left)
    line = next((ref for ref in known.refs if isinstance(ref, int)), None) if known else None
    relation = chain(link.left, (link.right, None))
    if line is not None and known is not None and not says(scene, line, link):
        # What was worked out since is put in; then the form is that which is printed.
        pool = [line, *scene.put(known.value)[1], *claims.judge.known(letters(link.right))]
        line = claims.judge.write(LAST, pool, relation)
    if line is None:
        claims.worths.back(mark)
        return None
    return line, relation


def _turned_by(claims: Claims, link: Link) -> int | None:
    """The line of a deflection that is an angle in letters, where it comes in the printed form."""
    if not is_quantity(link.left, "deflection"):
        return None
    if has_quantity(link.right) or not isinstance(link.left.stage, int):
        return None
    scene, mark = claims.scene, claims.worths.mark()
    (body,) = link.left.arguments
    try:
        for stage in (link.left.stage - 1, link.left.stage):
            claims.worths.determine(Quantity("velocity", (body,), stage))
        line = angle_line(scene, link.left)
    except NotPlannedError:
        claims.worths.back(mark)
        return None
    if scene.desk.last_link(line).right == link.right:
        return line
    claims.worths.back(mark)
    return None


def _is_angle_in_numbers(link: Link) -> bool:
    """Whether an angle between two velocities is to be shown, as a number of degrees."""
    match link.left:
        case Quantity("angle", (Quantity("velocity"), Quantity("velocity"))):
            return isinstance(link.right, Degrees) and link.right.value != 90
    return False


def _is_common(link: Link) -> bool:
    """Whether an angle is 0° or 180°, so that the two directions are one but for their sense."""
    return isinstance(link.right, Degrees) and link.right.value % 180 == 0


def _to_figures(claims: Claims, link: Link) -> tuple[int, Relation]:
    """A value that is printed to some figures: exact first, then its decimal."""
    worths = claims.worths
    if isinstance(link.left, Quantity) and is_angle(claims.scene, link.left):
        worths.determine(link.left)
        exact: int | None = angle_line(claims.scene, link.left)
    else:
        exact = worths.worth(worths.opened(link.left))
    if exact is None:
        raise NotPlannedError("an expression of several quantities to some figures")
    own = claims.scene.desk.last_link(exact)
    equal = equality(own.left, link.right)
    if claims.judge.follows(Move("rearrange"), [exact], equal):
        return claims.scene.desk.write(Move("rearrange"), [exact], equal), equal
    relation = Relation(((Link(own.left, "≈", link.right),),))
    line = claims.judge.write((Move("value"),), [exact], relation)
    if line is None:
        raise NotPlannedError("a decimal")
    return line, relation


def _first_meeting(claims: Claims, relation: Meets, now: int) -> tuple[int, Relation]:
    """That a sphere will hit a wall, or will not: the sense of its component towards it."""
    scene = claims.scene
    names = [name.name for name in (relation.first, relation.second)]
    walls = [name for name in names if name in scene.model.story.walls]
    spheres = [name for name in names if name not in walls]
    if len(walls) != 1 or len(spheres) != 1 or relation.again:
        raise NotPlannedError("a first meeting of two spheres")
    (body,) = spheres
    stage = scene.last_event(body, now)
    wall = next(wall for wall in scene.problem.walls if wall.name == walls[0])
    story = scene.model.story
    frame = frame_after(scene, body, stage)
    normal = story.evaluator(scene.events).direction(wall.along).turned_left()
    if expanded(normal.cross(frame.n)) != 0:
        raise NotPlannedError("a wall across the line of centres")
    value = story.velocity(body, stage).dot(frame.n)
    claims.solver.determine([value])
    # Who is at rest moves towards nothing, on whichever side of the wall.
    sign = {1: ">", 0: ">=", -1: "<"}[scene.model.sign(value)]
    link = Link(frame.component("along", body, stage), sign, ZERO)  # type: ignore[arg-type]
    return Comparison(claims).write(link)
