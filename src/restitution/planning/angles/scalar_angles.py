"""Angles between two velocities by their scalar product: the product, both speeds, the cosine."""

from __future__ import annotations

from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move, Ref
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    has_quantity,
    letters,
)
from restitution.expression.writing import write_expression
from restitution.planning.angles.lines_between import whole_velocity
from restitution.planning.angles.quantities import formula
from restitution.planning.closing.squared_ratios import (
    angles_by_squares,
    keeping,
    squares_lines,
    squares_put,
)
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.standing_vectors import stand_as_vectors, stand_at_right_angles
from restitution.planning.formulas.turns import Moving, impact_of, velocities_of
from restitution.planning.formulas.velocity_formulas import squares
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import ZERO, outer_terms, product, swept, total, tree_of
from restitution.planning.writing.polynomials import expanded, factored, one_fraction
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.vector import Vector


def write_right_angle(scene: Scene, asked: Quantity, *, by_squares: bool = False) -> int | None:
    """The line of a right angle between two velocities, by their product, which is zero.

    With ``by_squares`` only of an angle of which the squares of the ratios are put in.
    """
    pair = velocities_of(scene, asked)
    if pair is None:
        return None
    mark = scene.desk.mark()
    number = (_product_by_squares if by_squares else _product)(scene, pair)
    if number is not None:
        event = _event(pair)
        move = Move("define", "perpendicular", event, _bodies(pair))
        relation = chain(asked, (tree_of(sp.pi / 2, angle=True), None))
        if scene.judge.follows(move, (number,), relation):
            return scene.desk.write(move, (number,), relation)
    scene.desk.back(mark)
    return None


def write_right_angle_of_two(scene: Scene, asked: Quantity) -> int | None:
    """The line of a right angle between two velocities of which neither is along an axis."""
    pair = velocities_of(scene, asked)
    if pair is None:
        return None
    _, tree, value, _ = _terms(scene, pair)
    oblique = len(list(outer_terms(tree))) == len(pair)
    return write_right_angle(scene, asked) if oblique and value == 0 else None


def write_product_as_it_stands(scene: Scene, pair: tuple[Moving, Moving]) -> int | None:
    """The line of the scalar product of two velocities by its terms: their signs are seen.

    Where one is negative and the other is not, the sign is that of the product in factors.
    """
    subject, tree, value, refs = _terms(scene, pair)
    terms = list(outer_terms(tree))
    if len(terms) < len(pair) or scene.desk.known(subject) is not None:
        return None
    move = Move("define", "product", _event(pair), _bodies(pair))
    relation = chain(subject, (tree, None))
    signs = {scene.scalar(term).could_extract_minus_sign() for term in terms}
    in_factors = tidy(factored(value))
    if len(signs) == 2 and in_factors.is_Mul:
        relation = chain(subject, (tree, None), (tree_of(in_factors), "rearrange"))
    premises = scene.judge.needed(move, refs, relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def write_product_of_two(scene: Scene, pair: tuple[Moving, Moving]) -> int | None:
    """The line of the scalar product of two velocities, where both its terms are other than 0."""
    subject, tree, _, _ = _terms(scene, pair)
    if len(list(outer_terms(tree))) < len(pair) or scene.desk.known(subject) is not None:
        return None
    return _product(scene, pair)


def write_right_angle_of_axes(scene: Scene, asked: Quantity) -> int | None:
    """The line of a right angle between a velocity along **i** and one along **j**.

    None where one of them does not stand as such a vector.
    """
    pair = velocities_of(scene, asked)
    if pair is None:
        return None
    refs: list[Ref] = []
    axes: list[str] = []
    for body, stage in pair:
        last = scene.last_event(body, stage)
        known = scene.desk.known(Quantity("velocity", (Name(body),), last))
        source = scene.initial(body) if not last else known
        if source is None or not isinstance(source.value, Vector):
            return None
        zero = [scene.model.identically_zero(value) for value in source.value]
        if zero[0] == zero[1]:
            return None
        axes.append("j" if zero[0] else "i")
        refs += source.refs
    if axes[0] == axes[1]:
        return None
    move = Move("define", "perpendicular", _event(pair), _bodies(pair))
    relation = chain(asked, (tree_of(sp.pi / 2, angle=True), None))
    premises = scene.judge.needed(move, refs, relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def write_cosine(scene: Scene, asked: Quantity) -> int | None:
    """The line ``cos(β) = …`` of an angle between two velocities, by lines for what is in it.

    None where it does not follow from these.
    """
    pair = velocities_of(scene, asked)
    if pair is None:
        return None
    mark = scene.desk.mark()
    number = _product(scene, pair)
    for as_given in (True, False) if number is not None else ():
        assert number is not None
        before = scene.desk.mark()
        sizes = [_speed(scene, state, as_given=as_given) for state in pair]
        if None in sizes:
            break
        letter, meaning = letter_of(scene, asked)
        values = [_value(scene, ref) for ref in (number, *sizes) if ref is not None]
        right = swept(Binary("/", values[0], product(*values[1:])))
        final = tree_of(tidy(scene.scalar(right)))
        relation = chain(Apply("cos", Letter(letter)), (right, None), (final, "rearrange"))
        move = Move("define", "scalar-angle", _event(pair), _bodies(pair))
        refs = [size for size in (meaning, number, *sizes) if size is not None]
        known = background(scene, {name for value in values for name in letters(value)})
        # A velocity may be given by its angle to a wall, of which the data tell the direction.
        walls = (fact.id for fact in scene.desk.facts if fact.id.startswith("wall "))
        premises = scene.judge.enough(move, refs, relation, (*known, *walls))
        if premises is not None:
            return scene.desk.write(move, premises, relation)
        scene.desk.back(before)
    scene.desk.back(mark)
    return None


def write_given_cosine(scene: Scene, given: GivenEquation, asked: Quantity) -> int | None:
    """The equation that the cosine of a given angle between two velocities makes of their product.

    None where a root of what is sought would be left below the line, or a component is zero.
    """
    pair = velocities_of(scene, asked)
    if pair is None or has_quantity(given.link.right):
        return None
    angle, more = scene.put(scene.scalar(given.link.right))
    cosine = tidy(sp.expand_trig(sp.cos(angle)))
    _, tree, value, refs = _terms(scene, pair)
    sizes = [_squares(scene, state) for state in pair]
    open_ = scene.unknown(value)
    if len(open_) != 1 or not cosine.is_Rational or len(list(outer_terms(tree))) < len(pair):
        return None
    size = tidy(sp.sqrt(sp.factor(sizes[0][1] * sizes[1][1])))
    if not size.is_rational_function(*open_):
        return None
    below = [Apply("sqrt", own) for own, _, _ in sizes]
    whole = sizes[0][0] if sizes[0][1] == sizes[1][1] else product(*below)
    left = tree_of(cosine)
    if isinstance(given.link.right, Degrees):
        left = Apply("cos", given.link.right)
    last = tree_of(one_fraction(tidy(value / size)))
    steps = ((swept(Binary("/", tree, whole)), None), (last, "rearrange"))
    relation = chain(left, *steps)  # type: ignore[arg-type]
    move = Move("define", "scalar-angle", _event(pair), _bodies(pair))
    pool = together(given.refs, more, refs, *(line for _, _, line in sizes))
    names = symbol_names(value)
    premises = scene.judge.enough(move, pool, relation, background(scene, names))
    return None if premises is None else scene.desk.write(move, premises, relation)


def _squares(scene: Scene, moving: Moving) -> tuple[Expression, sp.Expr, tuple[Ref, ...]]:
    """The square of a speed by components: the tree, its value, and what it rests on."""
    body, stage = moving
    tree, value, refs = squares(scene, body, scene.last_event(body, stage))
    return tree, tidy(expanded(value)), refs


def is_long(right: Expression) -> bool:
    """Whether the cosine of an angle is too long to be written at once."""
    return len(write_expression(right)) > _LONGEST


_LONGEST = 80


def _event(pair: tuple[Moving, Moving]) -> int | None:
    return max(stage for _, stage in pair) or None


def _bodies(pair: tuple[Moving, Moving]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(body for body, _ in pair))


def _velocity(scene: Scene, moving: Moving) -> Quantity:
    body, stage = moving
    return Quantity("velocity", (Name(body),), scene.last_event(body, stage))


def _terms(
    scene: Scene, pair: tuple[Moving, Moving]
) -> tuple[Expression, Expression, sp.Expr, tuple[Ref, ...]]:
    """The scalar product of two velocities, its terms, what it is worth, and what it rests on."""
    components: list[list[Any]] = []
    impact = impact_of(scene, *sorted(pair, key=lambda state: state[1]))
    if impact is not None and scene.frame(impact).is_slanted:
        standing = stand_as_vectors(scene, pair) or stand_at_right_angles(scene, pair)
        impact = None if standing else impact
    if impact is not None:
        frame = scene.frame(impact)
        sources = [
            in_direction(scene, kind, body, impact - (stage != impact), frame)
            for body, stage in pair
            for kind in COMPONENTS
        ]
        refs = together(*(source.whole for source in sources))
        refs = together(refs, frame.names_axis("along"), frame.names_axis("across"), frame.refs)
        components = [[source.value for source in own] for own in (sources[:2], sources[2:])]
    else:
        vectors: list[Source] = [whole_velocity(scene, *state) for state in pair]
        refs = together(*(vector.whole for vector in vectors))
        components = [list(vector.value) for vector in vectors]
    (a, b), (c, d) = components
    tree = total((product(tree_of(a), tree_of(c)), product(tree_of(b), tree_of(d))))
    subject = Quantity("dot", tuple(_velocity(scene, state) for state in pair))
    return subject, swept(tree), tidy(expanded(a * c + b * d)), refs


def _product(scene: Scene, pair: tuple[Moving, Moving]) -> int | None:
    """The line of the scalar product of two velocities."""
    subject, tree, value, refs = _terms(scene, pair)
    relation = chain(subject, (tree, None), (tree_of(value), "rearrange"))
    move = Move("define", "product", _event(pair), _bodies(pair))
    premises = scene.judge.needed(move, refs, relation)
    return None if premises is None else scene.desk.write(move, premises, relation)


def _product_by_squares(scene: Scene, pair: tuple[Moving, Moving]) -> int | None:
    """The same of a product that is zero, by the squares of the ratios of an angle.

    None where sine and cosine are put in as they are.
    """
    move = Move("define", "product", _event(pair), _bodies(pair))
    for symbol in angles_by_squares(scene):
        mark = scene.desk.mark()
        with keeping(scene, symbol):
            subject, tree, _, refs = _terms(scene, pair)
        put = squares_put(scene, tree, symbol)
        first = chain(subject, (tree, None))
        premises = scene.judge.needed(move, refs, first)
        if put is not None and premises is not None and tidy(scene.scalar(put)) == 0:
            lines = squares_lines(scene, symbol)
            number = scene.desk.write(move, premises, first, shown="inline")
            last = chain(subject, (put, None), (ZERO, "rearrange"))
            if scene.judge.follows(Move("put"), (number, *lines), last):
                return scene.desk.write(Move("put"), (number, *lines), last)
        scene.desk.back(mark)
    return None


def _value(scene: Scene, ref: Ref) -> Expression:
    """What a line comes to, or the size of a velocity that is given by it."""
    if isinstance(ref, int):
        return scene.desk.last_link(ref).right
    size = _given_size(scene, ref)
    assert size is not None
    return size


def _given_size(scene: Scene, ref: str) -> Expression | None:
    """The size of a velocity that is given by its size and its direction; None of another."""
    right = scene.facts[ref].relation.only[0].right if ref in scene.facts else None
    return right.size if isinstance(right, Polar) else None


def _speed(scene: Scene, moving: Moving, *, as_given: bool) -> Ref | None:
    """The line of a speed, which may stand already, or, ``as_given``, the fact that gives it."""
    velocity = _velocity(scene, moving)
    if as_given and not velocity.stage and _given_size(scene, f"velocity {moving[0]}") is not None:
        return f"velocity {moving[0]}"
    speed = Quantity("speed", velocity.arguments, velocity.stage)
    known = scene.desk.known(speed)
    line = known.refs[0] if known is not None and len(known.refs) == 1 else None
    if isinstance(line, int) and scene.desk.last_link(line).left == speed:
        return line
    own = formula(scene, speed)
    if own.value == 0:
        return None
    return write_formula(scene, own)
