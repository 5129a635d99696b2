"""What is to be shown: forward from the laws to the printed form, which is the last line."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.explaining.derivation import Link, Meaning, Move, MoveId, Ref, Relation
from restitution.explaining.facts import links_of, staged
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    children,
    has_quantity,
    letters,
    walk,
)
from restitution.planning.angle_ratios import write_other_ratio
from restitution.planning.claims import Claims
from restitution.planning.comparisons import Comparison
from restitution.planning.conditions import has_quantity_in
from restitution.planning.deflections import cosine_of_deflection
from restitution.planning.desk import UNPLANNED, NotPlannedError, chain, together
from restitution.planning.extrema import write_extremum
from restitution.planning.forms import (
    ZERO,
    alike,
    is_rational,
    negative,
    product,
    square,
    swept,
    tree_of,
)
from restitution.planning.formulas import Formula
from restitution.planning.items import in_a_frame, is_named
from restitution.planning.order import Solver
from restitution.planning.polynomials import expanded
from restitution.planning.ranges import write_range
from restitution.planning.refuting import write_refutation
from restitution.planning.scene import Scene
from restitution.planning.turning import angle_line, is_angle, write_ratio
from restitution.planning.velocity_formulas import body_and_stage, frame_after
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
from restitution.solving.solution import ItemResult

# By these a line becomes the printed form, in the order in which they are tried.
_TO_CLEAR = (Move("rearrange"), Move("cancel"))
_LAST: tuple[Move, ...] = (
    Move("rearrange"),
    Move("put"),
    Move("cancel"),
    *(Move("identity", each) for each in ("pythagoras", "double-angle", "sum-of-angles")),
)


# What later items take as it is shown, and do not work out again.
_QUOTED = ("speed", "energy", "energy_lost", "total_energy_lost", "impulse")
_TO_FORM = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))
_LAST_LINKS: tuple[MoveId | None, ...] = (None, "rearrange", "identity")


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
    line, relation = _written(scene, solver, item, now)
    _print_form(scene, line, relation)
    scene.desk.end(name, line, relation, shown=True)
    _quotable(scene, line, relation)


def _written(scene: Scene, solver: Solver, item: Show, now: int) -> tuple[int, Relation]:
    """The lines of what is to be shown.

    The letters in which it is printed stand for themselves first, though facts tie them to others;
    then all that facts tie; and then those alone that it names, the others being put in.
    """
    standing = solver.mark()
    printed = _printed_letters(scene, item, now)
    refusal: NotPlannedError | None = None
    for attempt in ("printed", "tied", "named") if printed else ("tied", "named"):
        facts = frozenset[str]()
        with Claims(scene, solver) as claims:
            if attempt == "printed":
                scene.free |= printed
                facts = _facts_about(scene, item, now) - solver.used
            if attempt == "named":
                unnamed = {each for each in scene.free if each.name not in _names(item)}
                if not unnamed:
                    break
                scene.free -= unnamed
            solver.used |= facts
            try:
                line, relation = _line(claims, item, now)
            except NotPlannedError as error:
                refusal = refusal or error
                solver.back(standing)
                continue
            solver.used -= facts
            return line, relation
    assert refusal is not None
    raise refusal


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
    if same and _is_form_of(scene, (right, link.right)):
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
    return frozenset(each for each in scene.model.final if each.name in names)


def _facts_about(scene: Scene, item: Show, now: int) -> frozenset[str]:
    """The given facts that speak of the quantity that is to be shown: it is not shown by these."""
    assert isinstance(item.relation, Compare)
    (link,) = links_of(scene.problem, item.relation, now)
    shown = set(_quantities(scene.opened(link).left))
    return frozenset(
        each.fact.id
        for each in scene.given
        if shown & {q for side in (each.link.left, each.link.right) for q in _quantities(side)}
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
        case Letter(name) if f"let {name}" in scene.facts:
            scene.desk.know(link.left, scene.scalar(link.right), (line,))
        case Apply("tan", Quantity("angle" | "deflection", _, int() | None)):
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
                scene, solver, item.subject.kind, asked, over, None, value, name, shown=True
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
                    return _right_angle(claims, pair, opened, link)
            if isinstance(link.left, Quantity) and _is_angle_in_numbers(link):
                claims.worths.determine(link.left)
                line = angle_line(scene, link.left)
                return line, scene.desk.relation(line)
            if (turned := _turned_by(claims, link)) is not None:
                return turned, scene.desk.relation(turned)
            for shown in (_component_shown, _letter_shown, _inverse_shown):
                if (known := shown(claims, link)) is not None:
                    return known
            return _Equation(claims, link).write(), Relation(((link,),))
        case Compare(operators=operators) if "=" not in operators:
            links = links_of(scene.problem, item.relation, now)
            relation = Relation((links,))
            if len(links) == 1 and _is_of_components(links[0]):
                mark = claims.worths.mark()
                try:
                    return Comparison(claims).write(links[0])
                except NotPlannedError:
                    claims.worths.back(mark)
            return claims.write(relation), relation
        case Meets():
            links = links_of(scene.problem, item.relation, now)
            if not links:
                return _first_meeting(claims, item.relation, now)
            return Comparison(claims).write(links[0])
        case AtRest(body):
            quantity = staged(scene.problem, Quantity("velocity", (body,)), now)
            link = Link(quantity, "=", ZERO)
            return _Equation(claims, link).write(), Relation(((link,),))
        case Aligned():
            return _aligned(claims, item.relation, now)
    raise NotPlannedError("a show of several equations")


def _is_of_components(link: Link) -> bool:
    """Whether two components along one line are compared."""
    match link.left, link.right:
        case Quantity("along", (_, one)), Quantity("along", (_, other)):
            return one == other
    return False


def _component_shown(claims: Claims, link: Link) -> tuple[int, Relation] | None:
    """A component to be shown for which the working has a letter: the line of that."""
    if not isinstance(link.left, Quantity) or link.left.kind not in ("along", "across"):
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
    """An angle that is printed by its tangent: the tangent, and then the angle."""
    match link:
        case Link(Quantity("angle" | "deflection"), "=", Apply("arctan", tangent)):
            pass
        case _:
            return None
    scene, mark = claims.scene, claims.worths.mark()
    try:
        line = claims.worths.angle(link.left)
        own = scene.desk.last_link(line)
        if not isinstance(own.left, Apply):
            raise NotPlannedError("an angle without a tangent")
        if own.right != tangent:
            names = claims.judge.known(letters(own.right) | letters(tangent))
            form = claims.judge.write(_LAST, [line, *names], chain(own.left, (tangent, None)))
            if form is None:
                raise NotPlannedError("another form of a tangent")
            line = form
        line, angle, extent = claims.worths.lettered(line, own.left.argument)
        relation = chain(angle, (link.right, None))
        last = claims.judge.write((Move("inverse"),), [line, *extent], relation)
        if last is not None:
            return last, relation
    except NotPlannedError:
        pass
    claims.worths.back(mark)
    return None


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
    if line is not None and known is not None and not _says(scene, line, link):
        # What was worked out since is put in; then the form is that which is printed.
        pool = [line, *scene.put(known.value)[1], *claims.judge.known(letters(link.right))]
        line = claims.judge.write(_LAST, pool, relation)
    if line is None:
        claims.worths.back(mark)
        return None
    return line, relation


def _says(scene: Scene, line: int, link: Link) -> bool:
    """Whether a line is an equation, but for the order of its factors."""
    if len(scene.desk.relation(line).options) > 1:
        return False
    own = scene.desk.last_link(line)
    same = own.sign == link.sign and own.left == link.left
    return same and _is_form_of(scene, (own.right, link.right))


def _is_form_of(scene: Scene, pair: tuple[Expression, Expression]) -> bool:
    """Whether two expressions are one, but for the order of factors or a decimal point."""
    if all(is_rational(each.operand if isinstance(each, Negate) else each) for each in pair):
        one, other = (sp.sympify(scene.scalar(each), strict=True) for each in pair)
        return bool(one == other)
    return alike(*pair)


def _turned_by(claims: Claims, link: Link) -> int | None:
    """The line of a deflection that is an angle in letters, where it comes in the printed form."""
    if not isinstance(link.left, Quantity) or link.left.kind != "deflection":
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
    relation = Relation(((Link(own.left, "≈", link.right),),))
    line = claims.judge.write((Move("value"),), [exact], relation)
    if line is None:
        raise NotPlannedError("a decimal")
    return line, relation


def _first_meeting(claims: Claims, relation: Meets, now: int) -> tuple[int, Relation]:
    """That a sphere will hit a wall, or will not: the sense of its component towards it."""
    scene = claims.scene
    names = [each.name for each in (relation.first, relation.second)]
    walls = [name for name in names if name in scene.model.story.walls]
    spheres = [name for name in names if name not in walls]
    if len(walls) != 1 or len(spheres) != 1 or relation.again:
        raise NotPlannedError("a first meeting of two spheres")
    (body,) = spheres
    stage = scene.last_event(body, now)
    wall = next(each for each in scene.problem.walls if each.name == walls[0])
    story = scene.model.story
    frame = frame_after(scene, body, stage)
    normal = story.evaluator(scene.events).direction(wall.along).turned_left()
    if expanded(normal.cross(frame.n)) != 0:
        raise NotPlannedError("a wall across the line of centres")
    value = story.velocity(body, stage).dot(frame.n)
    claims.solver.determine([value])
    sign = ">" if scene.model.sign(value) > 0 else "<"
    link = Link(frame.component("along", body, stage), sign, ZERO)  # type: ignore[arg-type]
    return Comparison(claims).write(link)


def _aligned(claims: Claims, relation: Aligned, now: int) -> tuple[int, Relation]:
    """How two directions stand to each other, by their components."""
    scene = claims.scene
    (link,) = links_of(scene.problem, relation, now)
    if relation.relation == "parallel to":
        for own in (link, Link(link.right, link.sign, link.left)):
            match own:
                case Link(Quantity("line_of_centres", (), int(event)), _, right) if not (
                    has_quantity(right) or isinstance(right, Name)
                ):
                    return _axis_shown(claims, event, own)
    if relation.relation != "perpendicular to" and not isinstance(link.right, Name):
        return _common_direction(claims, relation, link)
    record = "perpendicular" if relation.relation == "perpendicular to" else "parallel"
    return _tied(claims, record, (link.left, link.right), Relation(((link,),)))


def _axis_shown(claims: Claims, event: int, link: Link) -> tuple[int, Relation]:
    """A line of centres that is worked out, in the printed direction."""
    relation = Relation(((link,),))
    lines = [ref for ref in claims.scene.frame(event).refs if isinstance(ref, int)]
    if not lines:
        raise NotPlannedError("a line of centres that is given")
    line = claims.judge.write((Move("rearrange"),), lines, relation)
    if line is None:
        raise NotPlannedError("another direction of a line of centres")
    return line, relation


def _right_angle(
    claims: Claims, pair: Sequence[Expression], opened: Link, link: Link
) -> tuple[int, Relation]:
    """That an angle is 90°, and then that a letter of the statement for it is."""
    line, relation = _tied(claims, "perpendicular", pair, Relation(((opened,),)))
    if opened == link:
        return line, relation
    relation = Relation(((link,),))
    named = claims.judge.write((Move("put"),), [line, *claims.scene.lets_in(link)], relation)
    if named is None:
        raise NotPlannedError("a letter for a right angle")
    return named, relation


def _tied(
    claims: Claims, record: str, pair: Sequence[Expression], own_relation: Relation
) -> tuple[int, Relation]:
    """That two directions are parallel, or at right angles, by the components of velocities."""
    scene = claims.scene
    moving = [
        body_and_stage(scene, each)
        for each in pair
        if isinstance(each, Quantity) and each.kind == "velocity"
    ]
    if not moving:
        raise NotPlannedError("directions of no velocity")
    frame = frame_after(scene, *max(moving, key=lambda own: own[1]))
    refs: list[Ref] = []
    for body, stage in moving:
        own = scene.velocity(body, stage)
        claims.solver.determine(list(own))
        for kind in ("along", "across"):
            refs += claims.worths.component(kind, body, stage, frame).whole
    refs += [f"wall {wall.name}" for wall in scene.problem.walls]
    move = Move("define", record, frame.number, tuple(dict.fromkeys(b for b, _ in moving)))
    for pool in (refs, [*frame.refs, *refs]):
        cited = together(r for r in pool if claims.worths.exists(r))
        line = claims.judge.write((move,), cited, own_relation)
        if line is not None:
            return line, own_relation
    raise NotPlannedError("two directions")


def _common_direction(claims: Claims, relation: Aligned, link: Link) -> tuple[int, Relation]:
    """One velocity as a multiple of another, or of a direction: the sign of the factor tells."""
    scene = claims.scene
    left = link.left
    right = link.right.operand if isinstance(link.right, Negate) else link.right
    a, b = (scene.model.story.direction(each, scene.events) for each in (left, right))
    for own in (a, b):
        claims.solver.determine(list(own))
    (ax, ay), (bx, by) = (
        tuple(sp.sympify(scene.put(each)[0], strict=True) for each in (own.x, own.y))
        for own in (a, b)
    )
    factor = tidy(ax / bx) if bx != 0 else tidy(ay / by)
    sign = proved_sign(scene.model.oracle, factor)
    wanted = {"in the direction of": 1, "opposite to": -1}.get(relation.relation, sign)
    if not isinstance(left, Quantity) or sign == 0 or sign != wanted:
        raise NotPlannedError("two directions")
    if sign is None and relation.relation != "parallel to":
        raise NotPlannedError("two directions")  # the factor may vanish, or have either sign
    if isinstance(right, Quantity) and right.kind == "line_of_centres":
        fact = scene.facts.get(f"axis {right.stage}")
        if fact is None:
            raise NotPlannedError("a line of centres that is to be worked out")
        right = fact.relation.only[0].right
    parallel = Link(left, "=", product(tree_of(factor), right))
    return _Equation(claims, parallel).write(), Relation(((parallel,),))


class _Equation:
    """An equation to be shown."""

    def __init__(self, claims: Claims, link: Link) -> None:
        self.claims = claims
        self.scene = claims.scene
        self.judge = claims.judge
        self.link = link
        self.relation = Relation(((link,),))

    def write(self) -> int:
        """Writes the lines, and returns the number of the last."""
        left, right = (
            self.claims.worths.opened(each) for each in (self.link.left, self.link.right)
        )
        if not has_quantity(left) and not has_quantity(right):
            return self._of_letters()
        if isinstance(self.link.left, Letter) and not isinstance(left, Letter | Quantity):
            line = self._of_expression(self.link.left, left)
            if line is not None:
                return line
        quantities = list(dict.fromkeys(_quantities(left, right)))
        subjects = [quantity for quantity in quantities if quantity in set(walk(left))]
        if len(quantities) == 1 and len(subjects) == 1:
            line = self._of_one(quantities[0]) or self._ratio_as_asked(quantities[0])
            if line is not None:
                return line
        line = self._speed_by_an_angle(quantities)
        return self._of_several(quantities) if line is None else line

    def _speed_by_an_angle(self, quantities: Sequence[Quantity]) -> int | None:
        """A speed in terms of the angle of its velocity to a line: a component, by that."""
        scene, claims = self.scene, self.claims
        trees = [node for side in (self.link.left, self.link.right) for node in walk(side)]
        for speed in quantities:
            if speed.kind != "speed" or not isinstance(speed.stage, int):
                continue
            velocity = replace(speed, kind="velocity")
            for ratio in trees:
                match ratio:
                    case Apply("sin" | "cos", Letter() | Quantity("angle") as angle):
                        opened = claims.worths.opened(angle)
                    case _:
                        continue
                if not isinstance(opened, Quantity) or opened.arguments[:1] != (velocity,):
                    continue
                mark = claims.worths.mark()
                claims.worths.determine(velocity)
                body, stage = body_and_stage(scene, velocity)
                frame = frame_after(scene, body, stage)
                lets = scene.lets_in(Link(angle, "=", angle))
                move = Move("define", "speed", frame.number, (body,))
                for kind in ("across", "along"):
                    own = claims.worths.component(kind, body, stage, frame)
                    size = tree_of(own.value)
                    size = negative(size) if scene.model.sign(own.value) < 0 else size
                    pool = together(own.whole, frame.refs, lets)
                    relation = Relation(((Link(product(speed, ratio), "=", size),),))
                    line = self.judge.write((move,), pool, relation)
                    if line is None:
                        continue
                    if relation == self.relation:
                        return line
                    names = letters(self.link.left) | letters(self.link.right)
                    form = self._last([line, *lets, *self._known(names)])
                    if form is not None:
                        return form
                claims.worths.back(mark)
        return None

    def _ratio_as_asked(self, angle: Quantity) -> int | None:
        """A ratio of an angle as it is written where it is asked, then in the printed form."""
        match self.link.left:
            case Apply("sin" | "cos" | "tan" as function, tree) if is_angle(self.scene, tree):
                pass
            case _:
                return None
        mark = self.claims.worths.mark()
        try:
            self.claims.worths.determine(angle)
            line, _ = write_ratio(self.scene, function, tree)
        except NotPlannedError:
            self.claims.worths.back(mark)
            return None
        if _says(self.scene, line, self.link):
            return line
        names = self._known(letters(self.scene.desk.last_link(line).right) | letters(tree))
        printed = self._last([line, *self.claims.worths.name_of(angle), *names])
        if printed is None:
            self.claims.worths.back(mark)
        return printed

    def _of_expression(self, letter: Letter, tree: Expression) -> int | None:
        """A letter of the statement for an expression of quantities."""
        mark = self.claims.worths.mark()
        worth = self.claims.worths.worth(tree)
        if worth is not None:
            known = self.judge.known(letters(self.link.right))
            value = self.scene.desk.last_link(worth).right
            for first in (self.link, Link(letter, "=", value)):
                line = self.judge.write(
                    (Move("put"),), [f"let {letter.name}", worth, *known], Relation(((first,),))
                )
                if line is not None:
                    return line if first == self.link else self._last([line, *known])
        self.claims.worths.back(mark)
        return None

    # --- letters --------------------------------------------------------------------------------

    def _of_letters(self) -> int:
        """A relation of letters: the equation that the facts give, or the letters by themselves."""
        mark = self.claims.worths.mark()
        try:
            return self._of_ties()
        except UNPLANNED:
            self.claims.worths.back(mark)
            line = self._worked_out()
            if line is None:
                raise
            return line

    def _worked_out(self) -> int | None:
        """The letters that the facts fix, worked out as those that are asked."""
        scene = self.scene
        names = letters(self.link.left) | letters(self.link.right)
        fixed = {symbol for symbol in scene.model.final if symbol.name in names}
        free = scene.free & fixed
        scene.free -= free
        try:
            for symbol in sorted(fixed & scene.unknown(sp.Add(*fixed)), key=str):
                self.claims.solver.determine([symbol])
                standing = self._standing() or self._by_its_letter()
                if standing is not None:
                    return standing
            known = (scene.desk.known(Letter(symbol.name)) for symbol in fixed)
            lines = [ref for own in known if own for ref in own.refs]
            return self._last([*lines, *self.judge.known(names)]) if lines else None
        finally:
            scene.free |= free

    def _by_its_letter(self) -> int | None:
        """What the working has a letter for, by the line that says what that is."""
        desk = self.scene.desk
        for let in desk.lines:
            if isinstance(let.relation, Meaning) and let.relation.quantity == self.link.left:
                own = replace(self.link, left=Letter(let.relation.letter))
                line = next((e for e in self._equations() if _says(self.scene, e, own)), None)
                if line is not None:
                    return self.judge.write((Move("put"),), [line, let.number], self.relation)
        return None

    def _equations(self) -> Iterator[int]:
        """The lines in force that are equations."""
        desk = self.scene.desk
        lines = (line.number for line in desk.lines if isinstance(line.relation, Relation))
        return filter(desk.holds, lines)

    def _of_ties(self) -> int:
        """The equation that the facts give, rearranged."""
        lines = self.claims.ties.lines()
        known = self.judge.known(letters(self.link.left) | letters(self.link.right))
        for each in lines:
            cleared = self._cleared(each, known)
            if cleared is not None:
                return cleared
        standing = self._standing()
        if standing is not None:
            return standing
        for each in lines:
            others = [other for other in lines if other != each]
            line = self._last([each, *others, *known])
            if line is not None:
                return line
        for each in lines:
            line = self._rooted(each, [other for other in lines if other != each], known)
            if line is not None:
                return line
        raise NotPlannedError("a relation of letters")

    def _standing(self) -> int | None:
        """The line in force that says what is to be shown already, on the way to something else."""
        return next((e for e in self._equations() if _says(self.scene, e, self.link)), None)

    def _rooted(self, line: int, others: Sequence[int], known: Sequence[Ref]) -> int | None:
        """A letter, or a ratio of one, by its square, of which the root is taken last."""
        left, right = self.link.left, self.link.right
        if not isinstance(left, Letter | Apply):
            return None
        squared = chain(square(left), (tree_of(tidy(self.scene.scalar(right) ** 2)), None))
        mark = self.scene.desk.mark()
        middle = self.judge.write(_LAST, [line, *others, *known], squared)
        if middle is not None:
            root = self.judge.write((Move("rearrange"),), [middle, *known], self.relation)
            if root is not None:
                return root
            both = Relation(((self.link,), (Link(left, "=", negative(right)),)))
            roots = self.judge.write((Move("roots"),), [middle, *known], both)
            if roots is not None:
                root = self.judge.write((Move("reject"),), [roots, *known], self.relation)
            if root is not None:
                return root
        self.scene.desk.back(mark)
        return None

    def _cleared(self, line: int, known: Sequence[Ref]) -> int | None:
        """A square that is a quotient of letters, from a line into which values were put.

        What is divided by stands on the other side first.
        """
        match self.link:
            case Link(Binary("^") as power, "=", Binary("/", above, below)) if letters(below):
                pass
            case _:
                return None
        desk = self.scene.desk
        own = desk.line(line)
        base, *_ = (each for each in (*own.premises, 0) if isinstance(each, int))
        if own.relation != self.relation or own.move.id != "rearrange" or line != len(desk.lines):
            return None
        if not base or desk.line(base).move.id != "put":
            return None
        desk.lines.pop()
        between = chain(swept(product(below, power)), (above, None))
        first = self.judge.write(_TO_CLEAR, [base, *known], between)
        last = None if first is None else self._last([first, *known])
        if last is None:
            del desk.lines[line - 1 :]
            desk.lines.append(own)
            return None
        if desk.known(power) is not None:
            desk.know(power, self.scene.scalar(self.link.right), (last,))
        return last

    def _last(self, pool: Sequence[Ref]) -> int | None:
        line = self.judge.write(_LAST, pool, self.relation)
        if line is not None:
            return line
        # Letters that have values were put in on the way; others are tied by what is given.
        names = letters(self.link.left) | letters(self.link.right)
        trees: list[Expression] = [Letter(name) for name in sorted(names)]
        ratios = [Apply(each, own) for own in trees for each in ("sin", "cos", "tan")]
        known = (self.scene.desk.known(each) for each in (*trees, *ratios))
        refs = [ref for own in known if own is not None for ref in own.refs]
        refs += self._between_letters()
        return self.judge.write((Move("put"),), [*pool, *refs], self.relation) if refs else None

    def _known(self, names: AbstractSet[str]) -> tuple[Ref, ...]:
        """What may be cited of letters: their ranges, and what the statement lets them be."""
        facts = self.scene.facts
        lets = {name: facts[f"let {name}"] for name in sorted(names) if f"let {name}" in facts}
        inside = {
            name for each in lets.values() for name in letters(each.relation.only[0].left)
        } | {name for each in lets.values() for name in letters(each.relation.only[0].right)}
        return (*(let.id for let in lets.values()), *self.judge.known(names | inside))

    def _between_letters(self) -> list[Ref]:
        """The given equations between letters."""
        return [
            each.fact.id
            for each in self.scene.given
            if each.link.sign == "=" and not has_quantity_in(each.fact.relation)
        ]

    # --- one quantity ---------------------------------------------------------------------------

    def _of_one(self, quantity: Quantity) -> int | None:
        claims = self.claims
        line = self._turned(quantity)
        if line is not None:
            return line
        own = claims.worths.formula(quantity)
        match self.link.left:
            case Apply("cos", _) if quantity.kind == "deflection":
                own = cosine_of_deflection(self.scene, quantity)
        left, extra = claims.worths.named(own, quantity)
        for axes in ((), claims.worths.axes(quantity)):
            line = self._by_definition(own, left, extra, together(own.refs, extra, axes))
            if line is not None:
                return line
        return None

    def _turned(self, angle: Quantity) -> int | None:
        """The tangent of an angle between two velocities, by their angles to one line."""
        match self.link.left:
            case Apply("tan", Letter() | Quantity("deflection" | "angle")):
                pass
            case _:
                return None
        mark = self.claims.worths.mark()
        line = self.claims.worths.turned(angle, by_letter=True)
        if line is None:
            return None
        desk, (left, right) = self.scene.desk, (self.link.left, self.link.right)
        own = desk.line(line)
        first = desk.relation(line).only[0].right
        named = self.claims.worths.name_of(angle)
        pool = (*own.premises, *named, *self.judge.known(letters(first) | letters(right)))
        for by in _LAST_LINKS:
            printed = chain(left, (first, None), (right, by))
            refs = self.judge.needed(own.move, pool, printed, own.premises)
            if refs is not None and own.number == len(desk.lines):
                desk.lines.pop()
                return desk.write(own.move, refs, printed)
        names = self.judge.known(letters(first) | letters(right))
        written = self.judge.write(_TO_FORM, [line, *named, *names], self.relation)
        if written is None:
            self.claims.worths.back(mark)
        return written

    def _by_definition(
        self, own: Formula, left: Expression, extra: tuple[Ref, ...], pool: Sequence[Ref]
    ) -> int | None:
        right = swept(own.right)
        squared = own.move.record == "speed" and isinstance(right, Apply)
        for subject, start in (
            (left, right),
            *(((square(left), right.argument),) if squared else ()),  # type: ignore[union-attr]
        ):
            if subject == self.link.left:
                line = self._defined(own, start, pool)
                if line is not None:
                    return line
        # The quantity as it is defined, and then the printed form.
        defined = self.judge.write((own.move,), pool, Relation(((Link(left, "=", right),),)))
        if defined is None:
            return None
        known = self._known(letters(right) | letters(self.link.right))
        return self._last([defined, *extra, *known])

    def _defined(self, own: Formula, start: Expression, pool: Sequence[Ref]) -> int | None:
        """The printed form as the last link of the definition, or as a line under it."""
        left, right = self.link.left, self.link.right
        known = self._known(letters(start) | letters(right))
        if start == right or _is_root_of_a_square(start):
            line = self.judge.write((own.move,), [*pool, *known], self.relation, own.refs)
            if line is not None or start == right:
                return line
        first = Link(left, "=", start)
        mark = self.scene.desk.mark()
        number = self.judge.write((own.move,), pool, Relation(((first,),)), own.refs)
        if number is None:
            return None
        for by in ("rearrange", "identity"):
            relation = Relation(((first, Link(start, "=", right, by)),))
            move = replace(own.move)
            if by == "identity" or self.judge.follows(move, pool, relation):
                refs = self.judge.needed(move, [*pool, *known], relation, own.refs)
                if refs is not None:
                    self.scene.desk.back(mark)
                    return self.scene.desk.write(move, refs, relation)
        if isinstance(own.value, sp.Expr):
            value = own.value if start == swept(own.right) else own.value**2
            simple = tree_of(tidy(value))
            relation = Relation(((first, Link(start, "=", simple, "rearrange")),))
            refs = self.judge.needed(own.move, [*pool, *known], relation, own.refs)
            if refs is not None and number == len(self.scene.desk.lines):
                self.scene.desk.back(mark)
                number = self.scene.desk.write(own.move, refs, relation)
        return self._last([number, *known])

    # --- several --------------------------------------------------------------------------------

    def _of_several(self, quantities: Sequence[Quantity]) -> int:
        scene, claims = self.scene, self.claims
        lines: list[int] = []
        facts: list[Ref] = []
        for quantity in quantities:
            if claims.worths.is_data(quantity):
                facts += claims.worths.data_of(quantity)
                continue
            lines.append(claims.worths.quantity(quantity))
        names = letters(self.link.left) | letters(self.link.right)
        known = self._known(names.union(*(letters(scene.desk.last_link(e).right) for e in lines)))
        if len(lines) == 2 and isinstance(self.link.left, Binary) and self.link.left.op == "/":
            line = self._by_pair(Move("divide"), lines, known)
            if line is not None:
                return line
        for first in lines:
            rest = [each for each in lines if each != first]
            line = self._last([first, *rest, *facts, *known])
            if line is not None:
                return line
        if len(lines) == 2:
            squares = Move("square-add")
            if self.judge.follows(squares, lines, self.relation):
                return scene.desk.write(squares, lines, self.relation)
            for move in (Move("divide"), Move("combine")):
                for pair in (lines, lines[::-1]):
                    line = self._by_pair(move, pair, known)
                    if line is not None:
                        return line
        raise NotPlannedError("an equation of several quantities")

    def _by_pair(self, move: Move, pair: Sequence[int], known: Sequence[Ref]) -> int | None:
        """The quotient, or the sum, of two quantities."""
        scene = self.scene
        values = [scene.desk.last_link(each).right for each in pair]
        op: Any = "/" if move.id == "divide" else "+"
        first = Link(self.link.left, "=", Binary(op, values[0], values[1]))
        middle = Relation(((first,),))
        whole = chain(first.left, (first.right, None), (self.link.right, "rearrange"))
        for each in (whole, self.relation):
            refs = self.judge.enough(move, pair, each, known)
            if refs is not None:
                return scene.desk.write(move, refs, each)
        refs = self.judge.enough(move, pair, middle, known)
        if refs is None:
            return None
        number = scene.desk.write(move, refs, middle)
        return self._last([number, *known])


def _is_root_of_a_square(tree: Expression) -> bool:
    """Whether a root is that of one square, and is what is squared."""
    match tree:
        case Apply("sqrt", Binary("^", _, Number(Fraction(numerator=2, denominator=1)))):
            return True
    return False


def _quantities(*trees: Expression) -> Iterator[Quantity]:
    """The outermost quantities of trees."""
    for tree in trees:
        match tree:
            case Quantity(kind) if kind != "mass":
                yield tree
            case Quantity() | Letter() | Number() | Name():
                continue
            case _:
                yield from _quantities(*children(tree))
