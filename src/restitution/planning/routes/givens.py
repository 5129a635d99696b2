"""A given fact becomes an equation in letters: a definition closed by what is given."""

from __future__ import annotations

from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ANGLES, ENERGIES, UNSIGNED_ANGLES
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    has_quantity,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.oracle import Oracle, compared
from restitution.oracle.roles import POSITIVE
from restitution.planning.angles.along_lines import given_along_the_centres
from restitution.planning.angles.angle_sums import is_sum, stated, write_sum, write_sum_with
from restitution.planning.angles.deflections import cosine_of_deflection, write_deflection
from restitution.planning.angles.equal_angles import write_equal_angles
from restitution.planning.angles.expressions import outermost, size_of
from restitution.planning.angles.given_turns import given_turn
from restitution.planning.angles.lines_between import (
    angle_of_lines,
    has_angle,
    is_moving,
    sine_of_the_offset,
)
from restitution.planning.angles.paths_to_centres import write_to_centres
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.related_tangents import write_by_tangent, write_tangents
from restitution.planning.angles.wall_turns import given_tangent_at_a_wall, related_at_a_wall
from restitution.planning.axes.given_momenta import write_impulse
from restitution.planning.axes.offsets import is_sine_of_an_offset, write_sine
from restitution.planning.closing.excluded_roots import senses
from restitution.planning.closing.losses_by_products import write_loss_by_products
from restitution.planning.closing.square_roots import is_not_negative, without_equal_squares
from restitution.planning.formulas.definitions import Formula, write_formula
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.impulse_formulas import impulse_in_sense, impulse_on
from restitution.planning.formulas.named_angles import tangent_line
from restitution.planning.formulas.separations import relative_speed
from restitution.planning.formulas.ties import write_tie
from restitution.planning.journeys import journeys
from restitution.planning.journeys.given_places import write_given_place
from restitution.planning.routes.energies_compared import energies_in_squares
from restitution.planning.routes.given_energies import write_share_of_energy
from restitution.planning.routes.given_times import write_time_since
from restitution.planning.routes.open_tangents import is_of_open_sense, write_squared_tangent
from restitution.planning.routes.quoted import (
    QUOTED,
    has_root,
    quoted,
    quoted_as,
    quoted_ratio,
    quoted_sum,
)
from restitution.planning.routes.sizes_resolved import write_resolved_speed
from restitution.planning.routes.standing_components import write_component_given
from restitution.planning.writing import place_trees
from restitution.planning.writing.between import terms_between
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.desk import NotPlannedError, chain, link, together
from restitution.planning.writing.forms import (
    ONE,
    TWO,
    ZERO,
    in_tangents,
    neat,
    negative,
    product,
    product_without,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import (
    expanded,
    factor_powers,
    is_factored_quadratic,
    numerator,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.vector import Vector

_COSTS = {"along": 1.0, "across": 1.0, "angle": 1.0, "speed": 1.5, "impulse": 2.0, "energy": 2.4}


def candidate_of(equation: GivenEquation) -> Candidate:
    """A given fact as an equation of which routes are made."""
    kinds = [
        node.kind
        for side in (equation.link.left, equation.link.right)
        for node in walk(side)
        if isinstance(node, Quantity) and node.kind not in ("mass", "position")
    ]
    cost = sum(_COSTS.get(kind, 1.5) for kind in kinds) or 0.5
    return Candidate(equation.fact.id, cost, equation.residuals)


def move_of(equation: GivenEquation) -> Move:
    """The definition by which a fact becomes an equation, as far as its kind tells it."""
    kinds = [
        node.kind
        for side in (equation.link.left, equation.link.right)
        for node in walk(side)
        if isinstance(node, Quantity)
    ]
    if equation.link.sign != "=":
        return Move("define", equation.link.sign.removesuffix(" to"))
    record = next((_RECORDS[kind] for kind in kinds if kind in _RECORDS), None)
    return Move("fact") if record is None else Move("define", record)


_RECORDS = {
    "angle": "tan",
    "speed": "speed",
    "impulse": "impulse",
    "energy": "total",
    "energy_lost": "energy-lost",
    "total_energy_lost": "total-lost",
    "deflection": "sum",
}


def write_given(scene: Scene, given: GivenEquation) -> int:
    """Writes the line in which a fact becomes an equation, and returns its number."""
    own = given.link
    if is_sine_of_an_offset(given):
        return write_sine(scene, given)
    standing = _with_its_letter(scene, given)
    if standing is not None:
        return standing
    if own.sign in ("perpendicular to", "parallel to") or _is_right(scene, own):
        return write_tie(scene, given)
    if is_sum(scene, given):
        return write_sum(scene, given)
    if not has_quantity(own.left) and not has_quantity(own.right):
        return _between_letters(scene, given)
    ratio = quoted_ratio(scene, given) or quoted_sum(scene, given)
    if ratio is not None:
        return ratio
    if isinstance(own.left, Quantity):
        write_loss_by_products(scene, own.left)
        standing = quoted(scene, given, own.left)
        if standing is not None:
            return standing
    line = given_along_the_centres(scene, given)
    line = write_resolved_speed(scene, given) if line is None else line
    if line is None and isinstance(own.left, Quantity):
        line = _of_one_quantity(scene, given, own.left)
    if line is None:
        line = _of_an_angle(scene, given)
    return _of_several(scene, given) if line is None else line


def _with_its_letter(scene: Scene, given: GivenEquation) -> int | None:
    """A value that has a letter by the question, or its tangent, as it is quoted."""
    subject = given.fact.relation.only[0].left
    subjects: tuple[Expression, ...] = ()
    match subject:
        case Letter(name) if f"let {name}" in scene.facts:
            subjects = (subject, Apply("tan", subject))
        case Apply("tan", Letter() | Quantity()):
            subjects = (subject,)
    for own in subjects:
        standing = quoted_as(scene, given, own)
        if standing is not None:
            return standing
    return None


def _of_one_quantity(scene: Scene, given: GivenEquation, own: Quantity) -> int | None:
    """The line of what is given of one quantity, by its definition."""
    in_letters = not has_quantity(given.link.right)
    if own.kind == "mass" and in_letters:
        return _mass(scene, given, own)
    if own.kind == "angle" and not is_moving(own.arguments[0]):
        line = sine_of_the_offset(scene, given)
        if line is not None:
            return line
        return _tangent(scene, _in_cosines(given), angle_of_lines(scene, own))
    if own.kind == "deflection" and in_letters:
        return write_deflection(scene, given)
    if own.kind == "angle" and in_letters:
        line = given_turn(scene, given)
        if line is not None:
            return line
    if own.kind == "velocity":
        return write_component_given(scene, given)
    if own.kind == "direction" and in_letters:
        line = write_to_centres(scene, given, own)
        if line is not None:
            return line
    if own.kind in COMPONENTS and in_letters:
        if any(is_quantity(e, "position") for e in walk(own)):
            return write_given_place(scene, given)
        return _component(scene, given)
    if own.kind == "impulse" and own.arguments:
        return write_impulse(scene, given)
    if own.kind == "deflection":
        line = related_at_a_wall(scene, given)
        if line is not None:
            return line
        _decided(scene, own)
    if in_letters and not place_trees.serves(own):
        return _closed(scene, given, formula(scene, own))
    return None


def _of_an_angle(scene: Scene, given: GivenEquation) -> int | None:
    """The line of what is given of a vector's size, or of an angle, by its ratios."""
    own = given.link
    match own.left:
        case Apply("abs", inside) if isinstance(scene.value(inside), Vector):
            return _size(scene, given, own.left)
        case Apply("tan", Quantity(kind) as angle) if kind in UNSIGNED_ANGLES and not has_quantity(
            own.right
        ):
            line = given_turn(scene, given) or given_tangent_at_a_wall(scene, given)
            if line is not None:
                return line
            if angle.kind == "deflection":
                _decided(scene, angle)
            formula_ = formula(scene, angle)
            if formula_.move.record == "tan" and is_of_open_sense(scene, formula_):
                value, refs = scene.put(scene.scalar(own.right))
                return write_squared_tangent(scene, given, formula_, tree_of(value), refs)
            return _tangent(scene, given, formula_)
        case Apply("tan", Quantity("direction", (Name(),)) as angle) if not has_quantity(own.right):
            return _tangent(scene, given, formula(scene, angle))
        case Apply("sin" | "cos", Quantity("angle")) if not has_quantity(own.right):
            return write_by_tangent(scene, given, own.left)
        case Apply("cos", Quantity("deflection") as angle) if not has_quantity(own.right):
            return _tangent(scene, given, cosine_of_deflection(scene, angle))
        case Quantity(kind) if kind in UNSIGNED_ANGLES:
            if is_quantity(own.right, *UNSIGNED_ANGLES):
                return write_equal_angles(scene, given)
    return None


def _mass(scene: Scene, given: GivenEquation, own: Quantity) -> int | None:
    """What is given of a mass that the data have in letters: ``3m = 6``."""
    (body,) = own.arguments
    data = scene.facts.get(f"mass {body.name}") if isinstance(body, Name) else None
    if data is None:
        return None
    relation = chain(data.relation.only[0].right, (given.link.right, None))
    return scene.judge.write((Move("put"),), (*given.refs, data.id), relation)


_LOSSES = ("energy-lost", "total-lost", "energy", "total")


def _in_cosines(equation: GivenEquation) -> GivenEquation:
    """The same of the cosines of two angles that are equal."""
    left, right = (Apply("cos", side) for side in (equation.link.left, equation.link.right))
    return replace(equation, link=Link(left, "=", right))


def _tangent(scene: Scene, equation: GivenEquation, own: Formula) -> int:
    """A ratio of an angle, by its definition, with its value on the left."""
    value, refs = scene.put(scene.scalar(equation.link.right))
    left = (
        equation.link.right if not refs and not has_angle(equation.link.right) else tree_of(value)
    )
    premises = together(equation.refs, refs, own.refs)
    relation = chain(left, (swept(own.right), None))
    components = {component.symbol for component in scene.model.components.values()}
    backwards = any(scene.model.sign(x) < 0 for x in scene.unknown(own.value) & components)
    if own.move.record in ("tan-deflection", "tan-from-axis") and (
        backwards or not scene.judge.follows(own.move, premises, relation)
    ):
        raise NotPlannedError("to which side a sphere turns is open")
    if own.move.record == "scalar-angle":
        premises = scene.judge.needed(own.move, premises, relation, equation.refs) or premises
    return scene.desk.write(own.move, premises, relation)


def _size(scene: Scene, equation: GivenEquation, size: Apply) -> int:
    """The size of a vector that is given, by its components; perhaps as a multiple of another."""
    root, refs = _root_of_size(scene, size)
    right = equation.link.right
    if has_quantity(right):
        others = [node for node in walk(right) if is_function(node, "abs")]
        factor = product_without(right, others[0]) if len(others) == 1 else None
        if factor is None or has_quantity(factor):
            raise NotPlannedError("a size as a multiple of another quantity")
        other, more = _root_of_size(scene, others[0])
        refs = together(refs, more)
        right = other if factor == ONE else product(factor, other)
    relation = chain(swept(root), (swept(right), None))
    return scene.desk.write(Move("put"), together(equation.refs, refs), relation)


def _root_of_size(scene: Scene, size: Apply) -> tuple[Expression, tuple[Ref, ...]]:
    """The size of a vector as the root of the squares of its components, and their lines."""
    value = scene.value(size.argument)
    if not isinstance(value, Vector):
        raise NotPlannedError("the size of what is no vector")
    apart = relative_speed(scene, size.argument)
    if apart is not None:
        parts, refs = apart
    else:
        refs, values = size_of(scene, size, value)
        parts = [(tree_of(value), value) for value in values]
    return Apply("sqrt", total(square(tree) for tree, value in parts if value != 0)), refs


def _is_right(scene: Scene, own: Link) -> bool:
    """Whether a right angle is given, or a straight one, or a direction along a line."""
    match own.left:
        case Quantity("direction", _, int()):
            return bool(tidy(sp.sin(2 * scene.scalar(own.right))) == 0)
        case Quantity(kind) if kind in UNSIGNED_ANGLES:
            straight = isinstance(own.right, Degrees) and own.right.value in (0, 180)
            return straight or bool(scene.scalar(own.right) == sp.pi / 2)
    return False


def _decided(scene: Scene, deflection: Quantity) -> None:
    """Raises NotPlannedError where it is open to which side a sphere turns."""
    (above, _), roles = _sides(formula(scene, deflection).right), dict(scene.model.unknowns.roles)
    for component in scene.model.components.values():
        roles[component.symbol.name] = POSITIVE
    value = scene_value(scene, above)
    if not Oracle(roles).proves(compared(value, ">=", sp.Integer(0))):
        raise NotPlannedError("to which side a sphere turns is open")


def _sides(tree: Expression) -> tuple[Expression, Expression]:
    assert isinstance(tree, Binary)
    return tree.left, tree.right


def _between_letters(scene: Scene, equation: GivenEquation) -> int:
    line = stated(scene, equation)
    return _of_named_angle(scene, equation, line) or line


def _of_named_angle(scene: Scene, equation: GivenEquation, line: int) -> int | None:
    """An angle of the motion that is a multiple of one of the data, by its tangent."""
    match equation.link:
        case Link(Letter(name), "=", right) if f"let {name}" in scene.facts:
            quantity = scene.facts[f"let {name}"].relation.only[0].left
        case _:
            return None
    if not is_quantity(quantity, "angle") or not letters(right):
        return None
    own = formula(scene, quantity)
    if own.move.record != "tan":
        return None
    tangent, _ = tangent_line(scene, quantity, own, own.move)
    relation = chain(Apply("tan", right), (tree_of(own.value), None))
    known = background(scene, letters(right))
    refs = scene.judge.enough(Move("put"), (tangent, line), relation, known)
    return None if refs is None else scene.desk.write(Move("put"), refs, relation)


def _closed(scene: Scene, equation: GivenEquation, own: Formula) -> int:
    """The definition of what is given, with its value on the left."""
    if isinstance(own.value, Vector):
        raise NotPlannedError("a vector that is given")
    value, refs = scene.put(scene.scalar(equation.link.right))
    angle = isinstance(equation.link.left, Quantity) and equation.link.left.kind in ANGLES
    left = equation.link.right if not refs else tree_of(value, angle=angle)
    if own.move.record == "tan" and value == sp.pi / 2:
        return _right_angle(scene, equation, own)
    if own.move.record == "tan" and is_of_open_sense(scene, own):
        between = is_quantity(own.quantity, "angle") and is_moving(own.quantity.arguments[1])
        as_it_is = isinstance(left, Degrees) or between
        tangent = own.of(left) if as_it_is else tree_of(tidy(sp.tan(value)))
        return write_squared_tangent(scene, equation, own, tangent, refs)
    plain = is_function(left, "arctan")
    if plain and own.move.record == "tan-direction":
        relation = chain(left.argument, (swept(own.right), None))  # type: ignore[union-attr]
    elif own.move.record == "tan":
        # First the quotient, then what is left of it.
        first = left.argument if plain else own.of(left)  # type: ignore[union-attr]
        last = tree_of(in_tangents(neat(own.value)))
        relation = chain(first, (swept(own.right), None), (last, "rearrange"))
    elif own.move.record == "product":
        return _scalar_product(scene, equation, own, left, refs)
    elif own.move.record == "speed":
        number = _of_one_component(scene, equation, own, left, refs)
        if number is not None:
            return number
        match own.right:
            case Apply("sqrt", right):
                relation = chain(square(left), (swept(right), None))
            case right:
                relation = chain(left, (swept(right), None))
    elif own.move.record == "impulse" and _turns_round(scene, own.value):
        # All solutions share one line, in the sense of the first of them.
        own = impulse_in_sense(scene, own)
        right = square(swept(own.right))
        whole = tree_of(tidy(own.value**2))
        relation = chain(square(left), (right, None), (whole, "rearrange"))
    else:
        relation = chain(own.of(left), (swept(own.right), None))
        if own.move.record in _LOSSES and not has_root(own.value):
            right, final = swept(own.right), tree_of(own.value)
            if left != ZERO and is_factored_quadratic(own.value, scene.unknown(own.value)):
                # Its factors are no roots, but a square keeps its root.
                is_square = any(n > 1 for _, n in factor_powers(numerator(own.value)))
                final = tree_of(expanded(own.value), as_it_is=not is_square)
            steps = (*terms_between(scene, right, final), final)
            worth = chain(own.of(left), (right, None), *((step, "rearrange") for step in steps))
            premises = together(equation.refs, refs, own.refs)
            if scene.judge.follows(own.move, premises, worth):
                return scene.desk.write(own.move, premises, worth)
    premises = together(equation.refs, refs, own.refs)
    if own.move.record == "tan" and own.value.atoms(sp.sin, sp.cos, sp.tan):
        # Which sense a component has may rest on what is told of an angle.
        known = scene.judge.known(letters(relation.only[0].right))
        premises = scene.judge.enough(own.move, premises, relation, known) or premises
    return scene.desk.write(own.move, premises, relation)


def _turns_round(scene: Scene, value: sp.Expr) -> bool:
    """Whether what is positive in this solution is negative in another one."""
    return any(model.sign(model.in_data(value)) < 0 for model in scene.others)


def write_impulse_on(scene: Scene, equation: GivenEquation, body: str) -> int | None:
    """The size of an impulse that is given, as the change of momentum of a body; None of others."""
    match equation.link:
        case Link(Quantity("impulse", (), int(event)) as impulse, "=", right):
            if event in scene.model.frames and not has_quantity(right):
                return _closed(scene, equation, impulse_on(scene, impulse, body, event))
    return None


def _scalar_product(
    scene: Scene, equation: GivenEquation, own: Formula, left: Expression, refs: tuple[Ref, ...]
) -> int:
    """A scalar product that is given: the velocities are put into it."""
    pool = together(equation.refs, refs, own.refs)
    relation = chain(swept(own.right), (left, None))
    premises = scene.judge.enough(Move("put"), (equation.fact.id, *pool), relation)
    if premises is None:
        raise NotPlannedError("a scalar product that is given")
    return scene.desk.write(Move("put"), premises, relation)


def _of_one_component(
    scene: Scene, equation: GivenEquation, own: Formula, left: Expression, refs: tuple[Ref, ...]
) -> int | None:
    """A speed that is given, where only one component is not zero and its sense is certain."""
    base = _one_component(own)
    if base is None or not _is_of_sure_sense(scene, base):
        return None
    relation = chain(left, (base, None))
    names = letters(base) | letters(left)
    premises = scene.judge.enough(
        own.move, together(equation.refs, refs, own.refs), relation, background(scene, names)
    )
    if premises is None:
        return _of_a_given_sense(scene, equation, own, base, left)
    return scene.desk.write(own.move, premises, relation)


def _of_a_given_sense(
    scene: Scene, equation: GivenEquation, own: Formula, base: Expression, left: Expression
) -> int | None:
    """A speed that is given, of a component whose sense is given too: the component itself."""
    letters_ = {
        component.symbol.name: component.symbol for component in scene.model.components.values()
    }
    symbol = letters_.get(base.name) if isinstance(base, Letter) else None
    if symbol is None:
        return None
    size = negative(base) if scene.model.sign(scene.model.in_data(symbol)) < 0 else base
    relation = chain(left, (size, None))
    pool = (*own.refs, *senses(scene, symbol))
    premises = scene.judge.needed(
        own.move, (equation.fact.id, *pool), relation, (equation.fact.id,)
    )
    return None if premises is None else scene.desk.write(own.move, premises, relation)


def _one_component(own: Formula) -> Expression | None:
    """The component that is the speed; None where there are two."""
    match own.right:
        case Apply("sqrt", Binary("^", base, exponent)) if exponent == TWO:
            return swept(base)
    return None


def _is_of_sure_sense(scene: Scene, component: Expression) -> bool:
    """Whether a component is not negative whatever is given of it, or is a letter that is open."""
    open_ = {component.symbol.name for component in scene.model.components.values()}
    return bool(letters(component) & open_) or is_not_negative(scene, component)


def _right_angle(scene: Scene, equation: GivenEquation, own: Formula) -> int:
    """An angle of 90°: the component in the direction of the line is zero."""
    assert isinstance(own.right, Binary)
    move = replace(own.move, record="perpendicular")
    relation = Relation(((link(own.right.right, ZERO),),))
    refs = scene.judge.enough(move, (equation.fact.id,), relation, own.refs)
    if refs is None:
        raise NotPlannedError("a right angle")
    return scene.desk.write(move, refs, relation)


def _component(scene: Scene, equation: GivenEquation) -> int:
    """A component that is given: the law or the letter that it is."""
    quantity = equation.link.left
    assert isinstance(quantity, Quantity)
    own = formula(scene, quantity)
    value, refs = scene.put(scene.scalar(equation.link.right))
    left, right = tree_of(own.value), tree_of(value)
    if own.move.record == "momentum-of":
        refs = together(equation.refs, refs, own.refs)
        return scene.desk.write(own.move, refs, chain(swept(own.right), (right, None)))
    named = scene.desk.known(quantity)
    of_it = own.refs if named is None or named.value != own.value else named.refs
    return scene.desk.write(
        Move("put"), together(equation.refs, refs, of_it), chain(left, (right, None))
    )


def _of_two_speeds(scene: Scene, equation: GivenEquation, left: Quantity) -> int | None:
    """A speed as a multiple of another, in their squares."""
    others = [
        node
        for node in walk(equation.link.right)
        if is_quantity(node, "speed") and isinstance(node.stage, int)
    ]
    if len(others) != 1 or not isinstance(left.stage, int):
        return None
    (other,) = others
    factor = product_without(equation.link.right, other)
    if factor is None:
        return None
    a, b = (formula(scene, one) for one in (left, other))
    if not all(isinstance(own.right, Apply) for own in (a, b)):
        return None
    number = _of_two_components(scene, equation, (a, b), other, factor)
    if number is not None:
        return number
    inside = [swept(own.right.argument) for own in (a, b)]  # type: ignore[union-attr]
    right = inside[1] if factor == ONE else swept(product(square(factor), inside[1]))
    relation = chain(right, (inside[0], None))
    whole = together(equation.refs, a.refs, b.refs)
    if not scene.judge.follows(a.move, whole, relation):
        # The second speed stands in the line of the first: it has none that is printed.
        own = chain(square(other), (inside[1], None))
        known = scene.desk.write(b.move, b.refs, own, "silent")
        whole = together(equation.refs, a.refs, (known,))
    return without_equal_squares(scene, scene.desk.write(a.move, whole, relation))


def _of_two_components(
    scene: Scene,
    equation: GivenEquation,
    pair: tuple[Formula, Formula],
    other: Quantity,
    factor: Expression,
) -> int | None:
    """Two speeds of one component each, of which the senses are certain."""
    bases = [_one_component(own) for own in pair]
    if bases[0] is None or bases[1] is None:
        return None
    if not all(_is_of_sure_sense(scene, base) for base in bases if base is not None):
        return None
    names = letters(bases[0]) | letters(bases[1])
    mark, (a, b) = scene.desk.mark(), pair
    known = background(scene, names)
    relation = chain(other, (bases[1], None))
    refs = scene.judge.enough(b.move, b.refs, relation, known)
    if refs is None:
        return None
    second = scene.desk.write(b.move, refs, relation, "silent")
    right = bases[1] if factor == ONE else swept(product(factor, bases[1]))
    relation = chain(right, (bases[0], None))
    refs = scene.judge.enough(a.move, together(equation.refs, a.refs, (second,)), relation, known)
    if refs is not None:
        return scene.desk.write(a.move, refs, relation)
    # One at the start is read off.
    own = chain(equation.link.left, (bases[0], None))
    first = scene.judge.write((a.move,), (*a.refs, *known), own, a.refs, "silent")
    pool = None if first is None else (*equation.refs, first, second)
    number = None if pool is None else scene.judge.write((Move("put"),), pool, relation)
    if number is None:
        scene.desk.back(mark)
    return number


def _of_several(scene: Scene, equation: GivenEquation) -> int:
    """A relation between quantities: each is defined, and put into what is given."""
    own = equation.link
    for special in (write_time_since, write_sum_with):
        number = special(scene, equation)
        if number is not None:
            return number
    if isinstance(own.left, Quantity):
        write = _of_two_speeds if own.left.kind == "speed" else write_share_of_energy
        number = write(scene, equation, own.left)
        if number is not None:
            return number
    values, refs = write_tangents(scene, own)
    squares_kept = energies_in_squares(scene, equation)
    for side in (exchanged(side, values) for side in (own.left, own.right)):
        for node in outermost(side):
            if place_trees.is_duration(node) and node not in values:
                number, value = journeys.write(scene, node)
                values[node] = tree_of(value)
                refs.append(number)
                continue
            if (
                not isinstance(node, Quantity)
                or node.kind in ("mass", "position")
                or node in values
            ):
                continue
            if node.kind in COMPONENTS:
                component = formula(scene, node)
                values[node] = tree_of(component.value)
                refs += component.refs
                continue
            if place_trees.serves(node):
                number, value = journeys.write(scene, node)
                values[node] = tree_of(value)
                refs.append(number)
                continue
            if not isinstance(node.stage, int):
                if node.kind == "angle":
                    raise NotPlannedError("a relation with angles")
                continue
            known = scene.desk.known(node) if node.kind in QUOTED else None
            if known is not None and not isinstance(known.value, Vector):
                value, more = scene.with_values(known.value)
                values[node] = tree_of(value)
                refs += [*known.refs, *more]
                continue
            formula_ = formula(scene, node)
            if formula_.left != node:
                raise NotPlannedError(f"a relation with {node.kind}s")
            if node.kind in ENERGIES and not has_root(formula_.value):
                # What an energy comes to is compared, and not how it is made.
                if node in squares_kept:
                    number, values[node] = squares_kept[node].write(scene)
                    refs.append(number)
                    continue
                refs.append(write_formula(scene, formula_))
                values[node] = tree_of(formula_.value)
                continue
            number = scene.desk.write(
                formula_.move, formula_.refs, chain(formula_.left, (swept(formula_.right), None))
            )
            values[node] = formula_.right
            refs.append(number)

    left, right = (swept(exchanged(side, values)) for side in (own.left, own.right))
    if any(is_quantity(node, "position") for node in walk(left)):
        return write_given_place(scene, equation)
    relation = chain(left, (right, None))
    whole = together(equation.refs, refs)
    first: list[Ref] = [equation.fact.id, *(ref for ref in whole if isinstance(ref, int))]
    premises = scene.judge.enough(Move("put"), first, relation, whole)
    return scene.desk.write(Move("put"), premises or whole, relation)
