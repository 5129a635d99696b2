"""Equations in which an unknown angle stands in its sines, cosines and tangents."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from restitution.exact import in_sines, tidy, tidy_angle
from restitution.exact.symbols import atoms_in, symbol_names, symbols_in
from restitution.explaining.lines.derivation import Link, Move, Relation, equality
from restitution.explaining.lines.trees import exchanged
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
from restitution.planning.closing.common_factors import sums_above
from restitution.planning.closing.in_tangents import write_in_tangents
from restitution.planning.closing.roots import by_roots, known_as
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.writing.angle_ratios import range_of
from restitution.planning.writing.desk import NotPlannedError, Source, chain
from restitution.planning.writing.forms import (
    ONE,
    ZERO,
    difference,
    is_in_degrees,
    number,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factored,
    numerator,
    polynomial_in,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.problem import Find, Value
from restitution.solving.algebra.forms import acute_angle
from restitution.work import remembered

_RATIOS = (sp.sin, sp.cos, sp.tan)


def inside_functions(x: sp.Expr) -> set[Any]:
    """The letters that stand in functions, or under roots."""
    roots = (power for power in atoms_in(x, sp.Pow) if not power.exp.is_Integer)
    return {s for value in (*atoms_in(x, sp.Function), *roots) for s in symbols_in(value)}


def functions_of(scene: Scene, own: sp.Expr, symbol: sp.Symbol) -> frozenset[sp.Expr] | None:
    """The ratios of an unknown angle in an equation; None where it is no such equation."""
    role = scene.model.unknowns.roles.get(symbol.name)
    if role is None or role.kind != "angle":
        return None
    return _functions_of(own, symbol)


@remembered(512)
def _functions_of(own: sp.Expr, symbol: sp.Symbol) -> frozenset[sp.Expr] | None:
    """The functions in which a letter stands; None where it stands in none, or outside of them."""
    functions = {atom for atom in own.atoms(sp.Function) if symbol in atom.free_symbols}
    if not functions:
        return None
    bare = own.subs({function: sp.Dummy() for function in functions})
    return None if symbol in bare.free_symbols else frozenset(functions)


def asked_ratio(scene: Scene, symbol: sp.Symbol) -> Any:
    """The ratio of an angle for which a part asks; None without one."""
    for step in scene.part.steps:
        if isinstance(step, Find):
            for item in step.items:
                match item:
                    case Value(expression=Apply("sin" | "cos" | "tan" as kind, Letter(name))):
                        if name == symbol.name:
                            return getattr(sp, kind)
    return None


def ratio(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """An angle that stands in one ratio, or in its sine and cosine of one degree."""
    own = residual(scene, line)
    functions = functions_of(scene, own, symbol)
    if functions is None or any(function.args != (symbol,) for function in functions):
        return None
    kinds = {type(function) for function in functions}
    if len(kinds) == 1:
        (kind,) = kinds
        return _by_one(scene, line, numerator(own), kind, symbol)
    above = numerator(in_sines(own, symbol))
    mixed = polynomial_in(above, sp.sin(symbol), sp.cos(symbol))
    degrees = {sum(monom) for monom in mixed.monoms()}
    if len(degrees) != 1:
        return None
    line = _one_term_a_side(scene, line, symbol)
    return _by_one(scene, line, _over_cosines(above, symbol), sp.tan, symbol)


def _one_term_a_side(scene: Scene, line: int, symbol: sp.Symbol) -> int:
    """``a sin²θ + b cos²θ = c cos²θ`` with a term of each on a side: the difference as it is."""
    link = scene.desk.last_link(line)
    ratios = sp.sin(symbol), sp.cos(symbol)
    values = [sp.sympify(scene_value(scene, side), strict=True) for side in (link.left, link.right)]
    if not all(value.is_polynomial(*ratios) for value in values):
        return line
    sides = [sp.Poly(value, *ratios) for value in values]
    powers = [(2, 0), (0, 2)]
    if any(set(side.monoms()) - set(powers) for side in sides):
        return line
    for one, other in (powers, powers[::-1]):
        for near, far in (sides, sides[::-1]):
            a, b, c = (
                near.coeff_monomial(one),
                near.coeff_monomial(other),
                far.coeff_monomial(other),
            )
            if far.coeff_monomial(one) != 0 or 0 in (a, b, c) or not (b - c).free_symbols:
                continue
            rest = difference(tree_of(tidy(c)), tree_of(tidy(b)))
            names = {one: Apply("sin" if one == (2, 0) else "cos", Letter(symbol.name))}
            names[other] = Apply("cos" if one == (2, 0) else "sin", Letter(symbol.name))
            left = product(rest, square(names[other]))
            relation = chain(left, (product(tree_of(tidy(a)), square(names[one])), None))
            refs = scene.judge.enough(Move("rearrange"), (line,), relation, ())
            return line if refs is None else scene.desk.write(Move("rearrange"), refs, relation)
    return line


def _over_cosines(above: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """A form in sine and cosine of one degree, divided by cosines until tangents are left."""
    mixed = polynomial_in(above, sp.sin(symbol), sp.cos(symbol))
    least = min(m[1] for m in mixed.monoms())
    top = max(sum(m) for m in mixed.monoms()) - least
    return sum((c * sp.tan(symbol) ** m[0] for m, c in mixed.terms() if m[0] <= top), sp.Integer(0))


def by_its_half(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """``a sin θ = b (1 + cos θ)``: the tangent of half the angle."""
    own = residual(scene, line)
    functions = functions_of(scene, own, symbol)
    s, c = sp.sin(symbol), sp.cos(symbol)
    if functions is None or functions != {s, c}:
        return None
    poly = polynomial_in(numerator(own), s, c)
    if poly.total_degree() != 1 or poly.nth(0, 1) != poly.nth(0, 0) or poly.nth(1, 0) == 0:
        return None
    value = tidy(-poly.nth(0, 1) / poly.nth(1, 0))
    letter = Letter(symbol.name)
    relation = chain(Apply("tan", Binary("/", letter, number(2))), (tree_of(value), None))
    known = _background(scene, line)
    refs = scene.judge.enough(Move("identity", "half-angle"), (line,), relation, known)
    if refs is None:
        return None
    half = scene.desk.write(Move("identity", "half-angle"), refs, relation)
    angle = scene.final(symbol)
    whole = chain(letter, (tree_of(angle, angle=True), None))
    refs = scene.judge.enough(Move("inverse"), (half,), whole, scene.judge.known([symbol.name]))
    if refs is None:
        return None
    return known_as(scene, symbol, angle, scene.desk.write(Move("inverse"), refs, whole))


def with_tangents(scene: Scene, number: int) -> int:
    """A line with a sine on one side and the cosine on the other, divided by the cosine.

    It is so where a line gives the tangent of the angle; else it is the line as it stands.
    """
    link = scene.desk.last_link(number)
    for side, other in ((link.left, link.right), (link.right, link.left)):
        sines = {e for e in walk(side) if is_function(e, "sin")}
        if link.sign != "=" or len(sines) != 1:
            continue
        (sine,) = sines
        cosine, tangent = (Apply(function, sine.argument) for function in ("cos", "tan"))
        known = scene.desk.known(tangent)
        if known is None or not any(isinstance(ref, int) for ref in known.refs):
            continue
        if any(map(scene.desk.known, (sine, cosine))) or _has_ratio_of(other, sine.argument, "sin"):
            continue
        divided = _without_factor(other, cosine)
        if divided is None or _has_ratio_of(side, sine.argument, "cos"):
            continue
        multiple = _without_factor(side, sine)
        if multiple is None:
            continue
        relation = chain(product(multiple, tangent), (divided, None))
        move = Move("rearrange")
        refs = scene.judge.enough(move, (number,), relation, _background(scene, number))
        if refs is not None:
            return scene.desk.write(move, refs, relation)
    return number


def _has_ratio_of(tree: Expression, angle: Expression, *kinds: str) -> bool:
    """Whether one of some ratios of an angle stands in a tree."""
    return any(
        isinstance(e, Apply) and e.function in kinds and e.argument == angle for e in walk(tree)
    )


def _without_factor(tree: Expression, factor: Apply) -> Expression | None:
    """A product without a ratio of an angle that is one of its factors; None of another tree."""
    if tree == factor:
        return ONE
    match tree:
        case Binary("*", left, right):
            for own, rest in ((left, right), (right, left)):
                inside = _without_factor(own, factor)
                if inside is not None and not _has_ratio_of(rest, factor.argument, *_KINDS):
                    return product(*((inside, rest) if own is left else (rest, inside)))
    return None


_KINDS = ("sin", "cos", "tan")


def _by_one(scene: Scene, line: int, above: sp.Expr, kind: Any, symbol: sp.Symbol) -> Source | None:
    """An equation in one ratio: linear, or by its roots; then the angle."""
    subject = Apply(kind.__name__, Letter(symbol.name))
    generator = kind(symbol)
    poly = polynomial_in(above, generator)
    if any(symbol in coeff.free_symbols for coeff in poly.coeffs()):
        return None
    by_tangent = _by_its_tangent(scene, line, poly, kind, symbol)
    if by_tangent is not None:
        return by_tangent
    if poly.degree() == 1:
        line = _collected(scene, line, poly, subject)
        value = tidy(-poly.nth(0) / poly.nth(1))
        relation = chain(subject, (tree_of(value), None))
        move, above = Move("rearrange"), scene.desk.line(line)
        link, pool = scene.desk.last_link(line), (line,)
        if (link.right, link.left) == (subject, tree_of(value)) and above.move == move:
            pool = above.premises  # 1 = tan α need not stand above tan α = 1
        refs = scene.judge.enough(move, pool, relation, _background(scene, line))
        if refs is None:
            return None
        known = scene.desk.write(move, refs, relation)
        scene.desk.know(subject, value, (known,))
    else:
        source = by_roots(scene, line, above, generator, subject, symbol)
        if source is None:
            return None
        (known,) = source.refs  # type: ignore[assignment]
    return inverse(scene, known, symbol)


def _collected(scene: Scene, line: int, poly: sp.Poly, subject: Expression) -> int:
    """The line with a sum that cancels as a factor of both sides: ``(1 + e)a = (1 + e)b tan α``.

    The line itself where no sum such as 1 + e does, or where both sides are products already.
    """
    rest, slope = factored(-poly.nth(0)), factored(poly.nth(1))
    common = sums_above(rest).keys() & sums_above(slope).keys()
    link = scene.desk.last_link(line)
    if not common or not any(is_binary(side, "+", "-") for side in (link.left, link.right)):
        return line
    left, right = tree_of(rest), tree_of(slope)
    if isinstance(left, Negate) and isinstance(right, Negate):
        left, right = left.operand, right.operand
    relation = equality(left, product(right, subject))
    written = scene.judge.write((Move("rearrange"),), (line,), relation, _background(scene, line))
    return written or line


def _by_its_tangent(
    scene: Scene, line: int, poly: sp.Poly, kind: Any, symbol: sp.Symbol
) -> Source | None:
    """An angle of which the square of a sine, or of a cosine, is a number without a root of it.

    It goes by the square of its tangent, where that is asked, or is the square of a number.
    """
    if kind is sp.tan or poly.monoms() != [(2,), (0,)]:
        return None
    share, asked = tidy(-poly.nth(0) / poly.nth(2)), asked_ratio(scene, symbol)
    if not share.is_Rational or not 0 < share < 1 or sp.sqrt(share).is_Rational:
        return None
    squared = (1 - share) / share if kind is sp.cos else share / (1 - share)
    plain = asked is None and squared != 1 and sp.sqrt(squared).is_Rational
    if asked is not sp.tan and not plain:
        return None
    own, tangent = (Apply(name, Letter(symbol.name)) for name in (kind.__name__, "tan"))
    mark = scene.desk.mark()
    alone = chain(square(own), (tree_of(share), None))
    known = scene.judge.write((Move("rearrange"),), (line,), alone, _background(scene, line))
    relation = chain(square(tangent), (tree_of(squared), None))
    moves = (Move("identity", "pythagoras"),)
    number_ = known and scene.judge.write(moves, (known,), relation)
    if not number_:
        scene.desk.back(mark)
        return None
    return _by_one(scene, number_, sp.tan(symbol) ** 2 - squared, sp.tan, symbol)


def _background(scene: Scene, line: int) -> tuple[Any, ...]:
    return background(scene, symbol_names(residual(scene, line)))


def even(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """Squares of sine and cosine beside numbers: sin² + cos² = 1 leaves one of them."""
    own = _of_one_angle(scene, line, symbol)
    if own is None:
        return None
    if (written := write_in_tangents(scene, line, symbol)) is not None:
        return _by_one(scene, *written, sp.tan, symbol)
    mixed = _in_both_ratios(own, symbol)
    monomials = mixed.monoms()
    asked = asked_ratio(scene, symbol)
    whole = all(sum(m) % 2 == 0 for m in monomials)
    single = [
        kind
        for kind, place in ((sp.cos, 0), (sp.sin, 1))
        if all(m[place] % 2 == 0 for m in monomials)
    ]
    if whole and (asked is sp.tan or not single):
        return _homogeneous(scene, line, mixed, symbol)
    if not single:
        return None
    kind = asked if asked in single else single[0]
    return _in_one_square(scene, line, mixed, kind, symbol)


def _homogeneous(scene: Scene, line: int, mixed: sp.Poly, symbol: sp.Symbol) -> Source | None:
    """Numbers become multiples of sin² + cos², and cos² is divided out."""
    s, c = sp.sin(symbol), sp.cos(symbol)
    top = max(sum(m) for m in mixed.monoms())
    above = sum(
        (
            coefficient * s ** m[0] * c ** m[1] * (s**2 + c**2) ** ((top - sum(m)) // 2)
            for m, coefficient in mixed.terms()
        ),
        sp.Integer(0),
    )
    again = polynomial_in(expanded(above), s, c)
    common = sp.gcd_list(again.coeffs())
    terms = {m: cancelled(k / common) for m, k in again.terms()}
    left = [(m, k) for m, k in terms.items() if scene.model.sign(k) > 0]
    right = [(m, -k) for m, k in terms.items() if scene.model.sign(k) < 0]
    relation = equality(_form(left, symbol), _form(right, symbol))
    between = _with_the_sum_of_squares(scene, line, mixed, symbol)
    own = None
    if between is not None:
        own = scene.judge.write((Move("rearrange"),), (between,), relation)
    if own is None:
        own = write_identity(scene, line, "pythagoras", relation)
    if own is None:
        return None
    form = sum((k * s ** m[0] * c ** m[1] for m, k in terms.items()), sp.Integer(0))
    return _by_one(scene, own, _over_cosines(form, symbol), sp.tan, symbol)


def with_the_sum_of_squares(scene: Scene, line: int, symbol: sp.Symbol) -> int | None:
    """The line in which a number beside squares of both ratios is a multiple of sin² + cos².

    None of another equation, and where it stands so.
    """
    own = _of_one_angle(scene, line, symbol)
    if own is None:
        return None
    mixed = _in_both_ratios(own, symbol)
    # A common factor of letters is cancelled.
    mixed = sp.Poly(mixed.primitive()[1].as_expr(), *mixed.gens)
    return _with_the_sum_of_squares(scene, line, mixed, symbol)


def _of_one_angle(scene: Scene, line: int, symbol: sp.Symbol) -> sp.Expr | None:
    """The residual of an equation of the ratios of one angle; None of another equation."""
    own = residual(scene, line)
    functions = functions_of(scene, own, symbol)
    if functions is None or any(function.args != (symbol,) for function in functions):
        return None
    return own


def _in_both_ratios(own: sp.Expr, symbol: sp.Symbol) -> sp.Poly:
    """A residual as a polynomial in the sine and the cosine of an angle."""
    s, c = sp.sin(symbol), sp.cos(symbol)
    mixed = polynomial_in(numerator(in_sines(own, symbol)), s, c)
    whole = mixed.primitive()[1] if mixed.domain.is_QQ else mixed
    return polynomial_in(whole.as_expr(), s, c)


def _with_the_sum_of_squares(
    scene: Scene, line: int, mixed: sp.Poly, symbol: sp.Symbol
) -> int | None:
    """The line ``4(sin²α + cos²α) = sin²α + 16 cos²α``, of a number beside squares of both ratios.

    None of another equation.
    """
    terms = dict(mixed.terms())
    number_ = terms.pop((0, 0), sp.Integer(0))
    if number_ == 0 or not terms.keys() >= {(2, 0), (0, 2)} or max(map(sum, terms)) > 2:
        return None
    sign = scene.model.sign(number_)
    sides: tuple[list[Expression], list[Expression]] = ([], [])
    squares = [square(Apply(function, Letter(symbol.name))) for function in ("sin", "cos")]
    sides[0].append(product(tree_of(sign * number_), total(squares)))
    for m, k in terms.items():
        negative = sign * scene.model.sign(k) < 0
        part = [(m, -sign * k if negative else sign * k)]
        sides[negative].append(_form(part, symbol))
    relation = equality(total(sides[0]), total(sides[1]))
    return write_identity(scene, line, "pythagoras", relation)


def _form(terms: list[tuple[tuple[int, int], sp.Expr]], symbol: sp.Symbol) -> Expression:
    sine, cosine = (Apply(function, Letter(symbol.name)) for function in ("sin", "cos"))
    return total(
        product(tree_of(k), *_power(sine, m[0]), *_power(cosine, m[1]))
        for m, k in sorted(terms, key=lambda term: -term[0][0])
    )


def _power(tree: Expression, exponent: int) -> tuple[Expression, ...]:
    if exponent == 0:
        return ()
    if exponent == 1:
        return (tree,)
    return (square(tree),) if exponent == 2 else (Binary("^", tree, number(exponent)),)


def _in_one_square(
    scene: Scene, line: int, mixed: sp.Poly, kind: Any, symbol: sp.Symbol
) -> Source | None:
    """The square of the other ratio is one less that of this."""
    letter = Letter(symbol.name)
    own = Apply(kind.__name__, letter)
    place = 0 if kind is sp.cos else 1
    common = sp.gcd_list(mixed.coeffs())
    sides: tuple[list[Expression], list[Expression]] = ([], [])
    above = sp.Integer(0)
    for m, k in _together(mixed):
        k = cancelled(k / common)
        other, same = m[place], m[1 - place]
        above += k * (1 - kind(symbol) ** 2) ** (other // 2) * kind(symbol) ** same
        factors: list[Expression] = []
        if other == 2:
            factors.append(difference(ONE, square(own)))
        elif other:
            factors.append(Binary("^", difference(ONE, square(own)), number(other // 2)))
        negative = scene.model.sign(k) < 0
        sides[negative].append(
            product(tree_of(-k if negative else k), *factors, *_power(own, same))
        )
    relation = equality(total(sides[0]), total(sides[1]))
    written = write_identity(scene, line, "pythagoras", relation)
    if written is None:
        return None
    return _by_one(scene, written, expanded(above), kind, symbol)


def _together(mixed: sp.Poly) -> Iterator[tuple[tuple[int, ...], sp.Expr]]:
    """The terms of a form in sine and cosine, with k sin² + k cos² as k."""
    terms = dict(mixed.terms())
    both = terms.get((2, 0))
    if both is not None and both == terms.get((0, 2)):
        del terms[2, 0], terms[0, 2]
        terms[0, 0] = terms.get((0, 0), 0) + both
    yield from ((m, k) for m, k in terms.items() if k != 0)


def write_identity(
    scene: Scene, line: int, record: str, relation: Relation, *others: int
) -> int | None:
    """Writes an equation by a named identity; None where it does not follow."""
    move = Move("identity", record)
    refs = scene.judge.enough(move, (line, *others), relation, _background(scene, line))
    return None if refs is None else scene.desk.write(move, refs, relation)


# --- sums of angles -----------------------------------------------------------------------------


def sum_of_angles(scene: Scene, line: int, symbol: sp.Symbol) -> Source | None:
    """Sines and cosines of an angle and a number: by the formulae for sums."""
    written = without_sums(scene, line, symbol)
    if written is None:
        return None
    return ratio(scene, written, symbol) or even(scene, written, symbol)


def without_sums(scene: Scene, line: int, symbol: sp.Symbol) -> int | None:
    """The line with ratios of a sum of angles by those of an angle; None where it has none."""
    link = scene.desk.last_link(line)
    sums = [
        node
        for side in (link.left, link.right)
        for node in walk(side)
        if is_function(node, "sin", "cos", "tan")
        and is_binary(node.argument, "+", "-")
        and symbol.name in letters(node.argument)
    ]
    if not sums:
        return None
    mixed = polynomial_in(
        numerator(in_sines(sp.expand_trig(residual(scene, line)), symbol)),
        sp.sin(symbol),
        sp.cos(symbol),
    )
    whole = factored(mixed.as_expr())
    common = sp.Mul(
        *(x for x in sp.Mul.make_args(whole) if x.is_number or (x.is_Symbol and x.is_positive))
    )
    terms = [(m, cancelled(k / common)) for m, k in mixed.terms()]
    left = [(m, tidy(k)) for m, k in terms if scene.model.sign(k) > 0]
    right = [(m, tidy(-k)) for m, k in terms if scene.model.sign(k) < 0]
    relation = equality(_form(left, symbol) if left else ZERO, _form(right, symbol))
    between = _expanded(scene, line, sums, symbol)
    if between is not None and between != relation:
        # How the terms are gathered is seen where their sine and cosine have come in.
        between_line = write_identity(scene, line, "sum-of-angles", between)
        if between_line is not None:
            gathered = _rearranged(scene, between_line, relation)
            if gathered is not None:
                return gathered
    return write_identity(scene, line, "sum-of-angles", relation)


def _rearranged(scene: Scene, line: int, relation: Relation) -> int | None:
    """A line in another form, where it follows."""
    move = Move("rearrange")
    refs = scene.judge.enough(move, (line,), relation, _background(scene, line))
    return None if refs is None else scene.desk.write(move, refs, relation)


def _expanded(scene: Scene, line: int, sums: Sequence[Apply], symbol: sp.Symbol) -> Relation | None:
    """An equation with the ratios of sums of angles by the formulae, and exact values in them.

    None where a ratio is no sum of sine and cosine of one angle.
    """
    expansions: dict[Expression, Expression] = {}
    sine, cosine = sp.sin(symbol), sp.cos(symbol)
    for function in sums:
        value = expanded(sp.expand_trig(scene.scalar(function)))
        rest = value - value.coeff(sine) * sine - value.coeff(cosine) * cosine
        if function.function == "tan" or rest != 0:
            return None
        parts = [(cosine, "cos"), (sine, "sin")] if function.function == "cos" else []
        parts = parts or [(sine, "sin"), (cosine, "cos")]
        shares = [(tidy(value.coeff(ratio)), name) for ratio, name in parts]
        shares.sort(key=lambda own: scene.model.sign(own[0]) < 0)
        expansions[function] = total(
            product(tree_of(share), Apply(name, Letter(symbol.name)))
            for share, name in shares
            if share != 0
        )
    link = scene.desk.last_link(line)
    sides = (swept(exchanged(side, expansions)) for side in (link.left, link.right))
    left, right = sides
    return Relation(((Link(left, link.sign, right),),))


def _as_written(scene: Scene, line: int, symbol: sp.Symbol) -> sp.Expr:
    """An acute angle as the inverse of the ratio that a line gives."""
    final = acute_angle(tidy_angle(scene.final(symbol)), scene.model.sign)
    if len(scene.desk.relation(line).options) > 1:
        return final
    plain = _of_its_ratio(scene, line, symbol)
    # The direction of a vector in letters has no other form that a line could have.
    if plain is not None and (not plain.free_symbols or scene.final(symbol).atoms(sp.atan2)):
        return plain
    link = scene.desk.last_link(line)
    match link.left:
        case Apply("tan", Letter(name)) if name == symbol.name:
            ratio_ = scene.scalar(link.right)
            if is_in_degrees(ratio_) or isinstance(final, sp.asin | sp.acos):
                return sp.atan(ratio_)
    return final


def _of_its_ratio(scene: Scene, line: int, symbol: sp.Symbol) -> sp.Expr | None:
    """An angle as the inverse cosine, or sine, that a line gives; None of another line."""
    if len(scene.desk.relation(line).options) > 1:
        return None
    link = scene.desk.last_link(line)
    match link.left:
        case Apply("cos" | "sin" as kind, Letter(name)) if name == symbol.name:
            return (sp.acos if kind == "cos" else sp.asin)(scene.scalar(link.right))
    return None


def inverse(scene: Scene, line: int, symbol: sp.Symbol, sides: Sequence[int] = ()) -> Source:
    """The angle by its ratio; ``sides`` are lines that may tell its quadrant."""
    value = scene.final(symbol)
    if value.atoms(sp.atan, sp.atan2):
        value = _as_written(scene, line, symbol)
    move, known = Move("inverse"), range_of(scene, symbol.name)
    relation = chain(Letter(symbol.name), (tree_of(value, angle=True, as_it_is=True), None))
    if known.startswith("acute"):
        others = background(scene, symbol_names(value)) if value.free_symbols else ()
        refs = scene.judge.enough(move, (line, known), relation, others)
        plain = _of_its_ratio(scene, line, symbol) if refs is None else None
        if plain is not None:
            # Its tangent is shorter, but no line says it.
            own = chain(Letter(symbol.name), (tree_of(plain, angle=True, as_it_is=True), None))
            refs = scene.judge.enough(move, (line, known), own, others)
            value, relation = (value, relation) if refs is None else (plain, own)
        written = scene.desk.write(move, refs or (line, known), relation)
        return known_as(scene, symbol, value, written)
    for more in ((), *((side,) for side in sides)):
        if scene.judge.follows(move, (line, known, *more), relation):
            written = scene.desk.write(move, (line, known, *more), relation)
            break
    else:
        raise NotPlannedError(f"{symbol} is not the only angle of its ratio")
    return known_as(scene, symbol, value, written)
