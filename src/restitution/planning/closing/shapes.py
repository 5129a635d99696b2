"""An equation with one unknown becomes lines, by its shape.

The shapes are a table (``SHAPES``): the first that fits a line takes it. What is known of letters
in the line is put in first, in a line of its own.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import partial

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import in_one_ratio, tidy
from restitution.exact.plain_angles import has_plain_angles
from restitution.exact.symbols import atoms_in, symbol_names, symbols_in
from restitution.explaining.lines.derivation import (
    Move,
    Ref,
    Relation,
    equality,
)
from restitution.explaining.lines.trees import rebuilt, statement_of
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Negate,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.planning.closing.brackets import bracket_alone
from restitution.planning.closing.collecting import multiplied_out
from restitution.planning.closing.common_factors import sums_above, without_common_factor
from restitution.planning.closing.complements import without_complements
from restitution.planning.closing.crossing import multiplied_across
from restitution.planning.closing.doubled_angles import divided_angle, product_of_tangents
from restitution.planning.closing.exact_ratios import by_ratios_as_they_are
from restitution.planning.closing.known_values import (
    is_angle,
    is_ratio,
    unknown_of,
    with_known,
)
from restitution.planning.closing.one_root import alone, in_squares
from restitution.planning.closing.pure_powers import pure_power
from restitution.planning.closing.ratios import (
    by_its_half,
    even,
    inside_functions,
    ratio,
    sum_of_angles,
)
from restitution.planning.closing.roots import by_roots, known_as
from restitution.planning.closing.sines_and_cosines import squared_ratio
from restitution.planning.closing.square_roots import (
    is_product_of_sums,
    is_square_of_sum,
    root_taken,
    sides_but_for_sign,
    squares_collected,
)
from restitution.planning.closing.squares_apart import with_squares_apart
from restitution.planning.closing.tangents_of_sums import tangent_of_a_sum
from restitution.planning.closing.two_roots import squared_apart
from restitution.planning.closing.zeros_of_sums import zero_of_a_sum
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import NotPlannedError, Source, chain
from restitution.planning.writing.forms import (
    ZERO,
    in_tangents,
    product,
    square,
    total,
    tree_of,
)
from restitution.planning.writing.one_tangent import write_by_single_tangents
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factor_powers,
    factored,
    numerator,
    polynomial_in,
    polynomial_without,
)
from restitution.planning.writing.premises import background, conditions, nonzero, not_negative
from restitution.planning.writing.scene import Scene
from restitution.vector import Vector
from restitution.work import remembered

Shape = Callable[[Scene, int, sp.Symbol], Source | None]


# A side is worked out before it is squared where that leaves at most two thirds of it.
_SHORTER = 1.5


def close(scene: Scene, number: int, symbol: sp.Symbol) -> Source:
    """Solves a line for the only unknown in it. Raises NotPlannedError for other shapes."""
    number = with_known(scene, number, symbol)
    symbol = unknown_of(scene, number, symbol)
    if symbol not in symbols_in(residual(scene, number)):
        raise NotPlannedError(f"{symbol} is not in line {number}")
    number = _by_sine_and_cosine(scene, without_complements(scene, number), symbol)
    number = _without_common_sums(scene, root_taken(scene, number, symbol), symbol)
    alone_ = bracket_alone(scene, number, symbol)
    if alone_ is not None:
        number = alone_
    elif not _has_roots_at_sight(scene, number, symbol):
        number = squares_collected(scene, multiplied_across(scene, number, symbol), symbol)
        if sides_but_for_sign(scene, number, symbol) is None:
            number = multiplied_out(scene, number, symbol)
    for shape in SHAPES:
        try:
            source = shape(scene, number, symbol)
        except sp.PolynomialError:
            continue  # no polynomial in what the shape is about
        if source is not None:
            return source
    raise NotPlannedError(f"no way from line {number} to {symbol}")


def _has_roots_at_sight(scene: Scene, number: int, symbol: sp.Symbol) -> bool:
    """Whether the roots of a line are read off its squares, or off its factors."""
    return (
        is_square_of_sum(scene, number, symbol)
        or is_product_of_sums(scene, number, symbol)
        or sides_but_for_sign(scene, number, symbol) is not None
    )


def _by_sine_and_cosine(scene: Scene, number: int, symbol: sp.Symbol) -> int:
    """The line without an angle of which sin² + cos² = 1 leaves a factor alone.

    So 16 = (2 − v)² cos²α + 16 sin²α is 16 = (2 − v)².
    """
    above = numerator(residual(scene, number))
    for sine in sorted(atoms_in(above, sp.sin), key=str):
        cosine = sp.cos(*sine.args)
        if symbol in sine.free_symbols or cosine not in atoms_in(above, sp.cos):
            continue
        if not above.is_polynomial(sine, cosine):
            continue
        if any(m[0] % 2 for m in polynomial_in(above, sine, cosine).monoms()):
            continue
        put = in_one_ratio(above, cosine, sine)
        powers = [(b, n) for b, n in factor_powers(put) if symbol in b.free_symbols]
        whole = expanded(sp.Mul(*(base**power for base, power in powers)))
        if not powers or whole.has(sine, cosine) or not whole.is_polynomial(symbol):
            continue
        if scene.model.sign(polynomial_in(whole, symbol).LC()) < 0:
            whole = -whole
        relation = chain(tree_of(whole), (ZERO, None))
        known = background(scene, symbol_names(above))
        move = Move("identity", "pythagoras")
        refs = scene.judge.enough(move, (number,), relation, known)
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    return number


def _without_common_sums(scene: Scene, number: int, symbol: sp.Symbol) -> int:
    """The line without a sum such as 1 + e, certain not to vanish, that each term has above."""
    link = scene.desk.last_link(number)
    if link.sign == "=" and link.right == ZERO:
        return without_common_factor(scene, number, symbol) or number
    if link.sign != "=":
        return number
    sides = [factored(scene_value(scene, side)) for side in (link.left, link.right)]
    first, second = (sums_above(side) for side in sides)
    common = [
        base ** min(power, second[base])
        for base, power in first.items()
        if base in second and proved_sign(scene.model.ground, base)
    ]
    if not common:
        return number
    whole = sp.Mul(*common)
    if symbol not in numerator((sides[0] - sides[1]) / whole).free_symbols:
        return number  # the sum that goes is all that has the unknown
    left, right = (tree_of(tidy(side / whole)) for side in sides)
    if isinstance(left, Negate) and isinstance(right, Negate):
        left, right = left.operand, right.operand
    relation = chain(left, (right, None))
    names = symbol_names(whole)
    known = (*conditions(scene, names), *background(scene, names))
    refs = scene.judge.enough(Move("cancel"), (number,), relation, known)
    return number if refs is None else scene.desk.write(Move("cancel"), refs, relation)


# --- shapes -------------------------------------------------------------------------------------


def _already(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """The line says what the unknown is."""
    link = scene.desk.last_link(number)
    if link.left != Letter(symbol.name) or link.sign != "=":
        return None
    value, right = scene.final(symbol), scene_value(scene, link.right)
    if right.free_symbols & scene.model.final.keys():
        return None
    if not scene.model.identically_zero(right - value):
        return None
    angle = is_angle(scene, symbol.name)
    forms = [tree_of(value, angle=angle, as_it_is=as_it_is) for as_it_is in (True, False)]
    if link.right not in forms and not isinstance(value, sp.atan):
        relation = chain(link.left, (forms[1], None))
        if has_plain_angles(right) and not scene.judge.follows(
            Move("rearrange"), (number,), relation
        ):
            value = tidy(right)  # in the ratios that stand there, and not in those of the double
            relation = chain(link.left, (tree_of(value), None))
        number = scene.desk.write(Move("rearrange"), (number,), relation)
    return known_as(scene, symbol, value, number)


def _squared(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """Roots on both sides, or one that is a number: both sides are squared."""
    if not any(map(partial(_has_root, symbol=symbol), _sides_of(scene, number))):
        return None
    number = _quotient_worked_out(scene, number)
    sides = _sides_of(scene, number)
    squares = [_square_of(scene, side) for side in sides]
    if any(tree is None for tree in squares):
        return None
    relation = equality(squares[0], squares[1])  # type: ignore[arg-type]
    move = Move("rearrange")
    refs = scene.judge.enough(move, (number,), relation, _background(scene, number))
    if refs is None:
        return None
    return close(scene, scene.desk.write(move, refs, relation), symbol)


def _sides_of(scene: Scene, number: int) -> tuple[Expression, Expression]:
    """The sides of the last equation of a line."""
    link = scene.desk.last_link(number)
    return link.left, link.right


def _quotient_worked_out(scene: Scene, number: int) -> int:
    """The line with a quotient of sums over roots worked out: (4u + v)/(√5√(4u² + v²)).

    The line itself where that is not shorter.
    """
    link = scene.desk.last_link(number)
    if letters(link.left) or not is_binary(link.right, "/"):
        return number
    shorter = tree_of(tidy(scene_value(scene, link.right)))
    if len(walk(shorter)) * _SHORTER > len(walk(link.right)):
        return number
    line = scene.judge.write((Move("rearrange"),), (number,), equality(link.left, shorter))
    return number if line is None else line


def _by_two_roots(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """Two roots in which the unknown stands, and a number: both sides are squared, twice."""
    line = squared_apart(scene, number, symbol)
    return None if line is None else close(scene, line, symbol)


def _by_a_squared_ratio(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """Sine and cosine of one angle and a number: both sides are squared."""
    squared = squared_ratio(scene, number, symbol)
    return None if squared is None else close(scene, squared, symbol)


def _by_one_root(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """One root in which the unknown stands: it is alone on a side, before both are squared."""
    line = alone(scene, number, symbol)
    return None if line is None else _squared(scene, line, symbol)


def _has_root(tree: Expression, symbol: sp.Symbol) -> bool:
    """Whether an unknown stands below a root, or in a vector of which the size is taken."""
    return any(
        is_function(node, "sqrt", "abs")
        and any(isinstance(x, Letter) and x.name == symbol.name for x in walk(node))
        for node in walk(tree)
    )


def _square_of(scene: Scene, tree: Expression) -> Expression | None:
    """A side squared: a number, a root, a size, a product or a quotient with one in it."""
    if not letters(tree):
        return tree_of(tidy(scene_value(scene, tree) ** 2))
    match tree:
        case Apply("sqrt", inside):
            return inside
        case Apply("abs", inside):
            return _square_of_size(scene, inside)
        case Negate(operand):
            return _square_of(scene, operand)
        case Binary("*" | "/" as op, left, right) if any(map(_is_size, walk(tree))):
            squares = [_square_of(scene, tree) for tree in (left, right)]
            if None in squares:
                return None
            return Binary(op, squares[0], squares[1])  # type: ignore[arg-type]
    if any(_is_size(node) for node in walk(tree)):
        return None
    return square(tree)


def _is_size(tree: Expression) -> bool:
    return is_function(tree, "sqrt", "abs")


def _square_of_size(scene: Scene, tree: Expression) -> Expression | None:
    """The square of the size of a vector, by its components."""
    value = scene.value(tree)
    if not isinstance(value, Vector):
        return square(tree)
    parts = [tidy(expanded(other)) for other in value]
    return total(square(tree_of(part)) for part in parts if part != 0)


def _linear(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """Linear in the unknown: it is made the subject."""
    above = numerator(residual(scene, number))
    if symbol in inside_functions(above) or symbol not in symbols_in(above):
        return None
    if sides_but_for_sign(scene, number, symbol) is not None:
        return None  # two equal squares have two roots, of which one may cancel
    if (solved := _by_tangents(scene, number, symbol)) is not None:
        return solved
    line = by_ratios_as_they_are(scene, number, symbol)
    if line is not None:
        return known_as(scene, symbol, scene.scalar(scene.desk.last_link(line).right), line)
    number = with_squares_apart(scene, number, symbol)
    for form in (above, _uncertain(scene, above, symbol)):
        poly = polynomial_in(form, symbol)
        if poly.degree() != 1:
            continue
        value = tidy(-poly.nth(0) / poly.nth(1))
        root = _quotient(symbol, poly, value)
        if is_angle(scene, symbol.name):
            root = chain(Letter(symbol.name), (tree_of(value, angle=True), None))
        line = rearranged(scene, number, root)
        if line is None and (own := _in_its_degrees(scene, number, symbol, poly)) is not None:
            value, line = own
        if line is not None:
            return known_as(scene, symbol, value, line)
    return _by_identity(scene, number, symbol)


def _in_its_degrees(
    scene: Scene, number: int, symbol: sp.Symbol, poly: sp.Poly
) -> tuple[sp.Expr, int] | None:
    """The root of a linear polynomial by the ratios of whole degrees that are in it.

    No formula joins 40° and 70°, though the value may be one in 20° alone, nor 50° and 60°.
    """
    value = -poly.nth(0) / poly.nth(1)
    degrees, shortest = map(_degrees, (value, tidy(value)))
    if len(degrees) < 2 and degrees == shortest:
        return None
    own = in_tangents(value)
    relation = chain(Letter(symbol.name), (tree_of(own, as_it_is=True), None))
    line = rearranged(scene, number, relation)
    return None if line is None else (own, line)


def _degrees(value: sp.Expr) -> set[sp.Expr]:
    """The numbers of degrees of which a value has sines and cosines."""
    return {ratio.args[0] for ratio in value.atoms(sp.sin, sp.cos) if ratio.is_number}


def _by_tangents(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """The unknown of a line that has tangents of other angles alone, in these; None of another."""
    link = scene.desk.last_link(number)
    ratios = {node for side in (link.left, link.right) for node in walk(side) if is_ratio(node)}
    gap = scene_value(scene, link.left) - scene_value(scene, link.right)
    back: dict[Expression, Expression] = {}
    for tangent in ratios:
        match tangent:
            case Apply("tan", Letter(name)):
                angle = scene.model.unknowns.letter(name)
                t = sp.Symbol(f"tan {name}", positive=True)
                gap = gap.xreplace({sp.tan(angle): t, sp.sin(angle): t * sp.cos(angle)})
                back[Letter(t.name)] = tangent
            case _:
                return None
    if not back:
        return None
    halved = write_by_single_tangents(scene, number)
    if halved is not None:
        return _by_tangents(scene, halved, symbol)
    poly = polynomial_in(numerator(cancelled(gap)), symbol)
    functions = poly.as_expr().atoms(sp.Function)
    if poly.degree() != 1 or any(e.free_symbols or isinstance(e, sp.cos) for e in functions):
        return None
    value = tidy(-poly.nth(0) / poly.nth(1))
    tree = rebuilt(tree_of(value), lambda tree: back.get(tree, tree))
    line = rearranged(scene, number, chain(Letter(symbol.name), (tree, None)))
    return None if line is None else known_as(scene, symbol, scene.scalar(tree), line)


def _quotient(symbol: sp.Symbol, poly: sp.Poly, value: sp.Expr) -> Relation:
    """The root of a linear polynomial; below a sum with roots it is first a quotient."""
    letter, last = Letter(symbol.name), tree_of(value)
    below, letters_ = _without_letters(poly.nth(1))
    if not below.is_Add:
        return chain(letter, (last, None))
    above = cancelled(-poly.nth(0) / letters_)
    lowest = sp.ilcm(*(argument.as_coeff_Mul()[0].q for argument in below.args))
    above, below = (expanded(value * lowest) for value in (above, below))
    if below.is_negative:
        above, below = -above, -below
    top, others = _without_letters(above) if above.free_symbols else (above, sp.Integer(1))
    over = product(tree_of(top, as_it_is=True), tree_of(others)) if top.is_Add else tree_of(above)
    first = Binary("/", over, tree_of(below, as_it_is=True))
    return chain(letter, (first, None), (last, "rearrange"))


def without(
    symbol: sp.Symbol, other: sp.Symbol, residuals: Sequence[sp.Expr], value: sp.Expr
) -> Relation:
    """One unknown of two linear equations, once the other is eliminated."""
    one, two = residuals
    return _quotient(symbol, polynomial_without(symbol, other, one, two), value)


@remembered(512)
def is_over_roots(above: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether an unknown, in a linear equation, is divided by a sum with roots."""
    whole = numerator(above)
    if symbol in inside_functions(whole) or sp.degree(whole, symbol) != 1:
        return False
    return bool(_without_letters(polynomial_in(whole, symbol).nth(1))[0].is_Add)


@remembered(1024)
def _without_letters(x: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """A number, and the product of letters that goes with it; 1 and 1 where it is more."""
    number, letters_ = sp.factor_terms(expanded(x)).as_independent(*x.free_symbols, as_Add=False)
    return (expanded(number), letters_) if not letters_.is_Add else (sp.Integer(1), x)


def _by_identity(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """The unknown in the form of its answer, where sin² + cos² = 1 leads to that."""
    value = scene.final(symbol)
    if not value.atoms(sp.sin, sp.cos, sp.tan):
        return None
    relation = chain(Letter(symbol.name), (tree_of(value), None))
    for record in ("pythagoras", "double-angle", "sum-of-angles"):
        move = Move("identity", record)
        refs = scene.judge.enough(move, (number,), relation, _background(scene, number))
        if refs is not None:
            return known_as(scene, symbol, value, scene.desk.write(move, refs, relation))
    return None


def _uncertain(scene: Scene, x: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """An expression without the factors that are certain not to vanish.

    A factor that is linear in the unknown has a root, which is written down and rejected.
    """
    factors = sp.Mul.make_args(factored(x))
    kept = [factor for factor in factors if not proved_sign(scene.model.ground, factor)]
    kept += [factor for factor in factors if factor not in kept and _single(factor, symbol)]
    return expanded(sp.Mul(*kept))


def _single(factor: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether a factor is a polynomial in an unknown alone: it has roots to be looked at.

    So has a sum of two terms of letters, such as d + r, or ut + 10r.
    """
    if not factor.is_polynomial(symbol) or factor == symbol:
        return False
    terms = sp.Add.make_args(factor)
    plain = len(terms) == 2 and all(x.free_symbols and x.is_polynomial() for x in terms)
    return factor.free_symbols == {symbol} or (plain and symbol in factor.free_symbols)


def rearranged(scene: Scene, number: int, relation: Relation) -> int | None:
    """A line in another form, with what makes the factor between them not zero."""
    own = scene.desk.line(number)
    if statement_of(scene.desk.relation(number)) == statement_of(relation):
        if number in scene.desk.shown:
            return number  # it was to be shown as it stands
        # From the other side: the line itself is written so.
        return scene.desk.write(own.move, own.premises, relation)
    return in_another_form(scene, number, relation)


def _background(scene: Scene, number: int) -> tuple[Ref, ...]:
    names = symbol_names(residual(scene, number))
    return background(scene, names)


def _quadratic(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """A quadratic: its roots, and those that are excluded."""
    above = numerator(residual(scene, number))
    if symbol in inside_functions(above):
        return None
    return by_roots(scene, number, above, symbol, Letter(symbol.name), symbol)


def _of_equal_squares(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """Two equal squares: what they are squares of is equal, or opposite."""
    if sides_but_for_sign(scene, number, symbol) is None:
        return None
    return _quadratic(scene, number, symbol)


def _without_a_factor(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """A sine or cosine of the unknown is a factor that is certain not to vanish: it goes."""
    if not is_angle(scene, symbol.name):
        return None
    whole = factored(numerator(residual(scene, number)))
    ratios = {sp.sin(symbol), sp.cos(symbol)}
    common = [
        factor
        for factor in sp.Mul.make_args(whole)
        if factor.as_base_exp()[0] in ratios and proved_sign(scene.model.ground, factor)
    ]
    if not common:
        return None
    link = scene.desk.last_link(number)
    left, right = (
        tree_of(tidy(scene_value(scene, side) / sp.Mul(*common)))
        for side in (link.left, link.right)
    )
    relation = chain(left, (right, None))
    refs = scene.judge.enough(Move("cancel"), (number,), relation, background(scene, {symbol.name}))
    if refs is None:
        return None
    return close(scene, scene.desk.write(Move("cancel"), refs, relation), symbol)


def _without_an_angle(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """An angle of the data goes, as sin² + cos² = 1; what is left is solved."""
    whole = numerator(residual(scene, number))
    angles = {f.args[0] for f in atoms_in(whole, sp.sin, sp.cos)} - {symbol}
    gone = [angle for angle in sorted(angles, key=str) if angle.is_Symbol and _goes(whole, angle)]
    if not gone or symbol in inside_functions(whole):
        return None
    move = Move("identity", "pythagoras")
    link = scene.desk.last_link(number)
    left, right = (
        tree_of(_in_sines(expanded(scene_value(scene, side)), gone))
        for side in (link.left, link.right)
    )
    refs = scene.judge.enough(move, (number,), chain(left, (right, None)), ())
    if refs is None:
        return None
    return close(scene, scene.desk.write(move, refs, chain(left, (right, None))), symbol)


def _without_the_sum_of_squares(scene: Scene, number: int, symbol: sp.Symbol) -> Source | None:
    """A side with the factor sin² + cos² goes on without that: sin²θ cos²θ + cos⁴θ is cos²θ."""
    link = scene.desk.last_link(number)
    s, c = sp.sin(symbol), sp.cos(symbol)
    sides: list[Expression] = []
    for side in (link.left, link.right):
        value = sp.sympify(scene_value(scene, side), strict=True)
        if not value.has(s, c):
            sides.append(side)
            continue
        if not value.is_polynomial(s, c) or symbol in inside_functions(value.subs({s: 1, c: 1})):
            return None
        poly = polynomial_in(value, s, c)
        if poly.domain.is_EX:
            return None  # ratios of degrees among the coefficients
        whole, rest = sp.div(poly, polynomial_in(s**2 + c**2, s, c))
        # A number beside both squares is no factor that stands there already.
        out = rest.is_zero and not whole.is_zero and whole.total_degree() > 0
        sides.append(tree_of(tidy(whole.as_expr())) if out else side)
    if sides == [link.left, link.right]:
        return None
    relation = chain(sides[0], (sides[1], None))
    refs = scene.judge.enough(Move("identity", "pythagoras"), (number,), relation, ())
    if refs is None:
        return None
    return close(scene, scene.desk.write(Move("identity", "pythagoras"), refs, relation), symbol)


def _goes(x: sp.Expr, angle: sp.Symbol) -> bool:
    """Whether an angle is not in an expression any more, once its cosines are sines."""
    return angle in x.free_symbols and angle not in _in_sines(x, [angle]).free_symbols


def _in_sines(x: sp.Expr, angles: Iterable[sp.Symbol]) -> sp.Expr:
    for angle in angles:
        x = in_one_ratio(x, sp.sin(angle), sp.cos(angle))
    return factored(x)


SHAPES: tuple[Shape, ...] = (
    _already,
    _of_equal_squares,
    _without_the_sum_of_squares,
    _without_an_angle,
    _by_two_roots,
    _squared,
    _by_one_root,
    in_squares,
    zero_of_a_sum,
    tangent_of_a_sum,
    sum_of_angles,
    ratio,
    _without_a_factor,
    by_its_half,
    _by_a_squared_ratio,
    even,
    divided_angle,
    product_of_tangents,
    pure_power,
    _linear,
    _quadratic,
)
"""What an equation may look like, in the order in which the shapes are tried."""

__all__ = [
    "SHAPES",
    "close",
    "is_over_roots",
    "nonzero",
    "not_negative",
    "rearranged",
    "with_known",
    "without",
]
