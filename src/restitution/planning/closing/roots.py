"""Equations of the second degree: their roots, and by what some of them are excluded."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any

import sympy as sp
from sympy.polys.polyerrors import PolynomialError

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation, equality
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    is_binary,
    letters,
    walk,
)
from restitution.planning.closing.excluded_roots import (
    option,
    rejected,
)
from restitution.planning.closing.polynomial_trees import doubled_power, polynomial_tree
from restitution.planning.closing.roots_in_order import put_in_order_last
from restitution.planning.closing.square_roots import (
    is_product_of_sums,
    is_square_of_sum,
    linear_factors,
    root_of_squares,
    sides_but_for_sign,
    speed_of_one_component,
)
from restitution.planning.closing.squares_in_degrees import square_in_degrees
from restitution.planning.formulas.impacts import (
    residual,
    scene_value,
)
from restitution.planning.writing.desk import NotPlannedError, Source, chain
from restitution.planning.writing.forms import (
    ZERO,
    negative,
    outer_terms,
    product,
    square,
    swept,
    tree_of,
)
from restitution.planning.writing.polynomials import (
    expanded,
    factor_powers,
    factored,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.solving.algebra.polynomials import without_cos_squared

_ROOTS = Move("roots")


def known_as(scene: Scene, symbol: sp.Symbol, value: Any, number: int) -> Source:
    """From here on a letter has the value that a line says."""
    return scene.desk.know(Letter(symbol.name), value, (number,))


def by_roots(
    scene: Scene,
    number: int,
    above: sp.Expr,
    generator: sp.Expr,
    subject: Expression,
    symbol: sp.Symbol,
    of: Of | None = None,
) -> Source | None:
    """The roots of a polynomial in a letter, or in a ratio of an angle, and what is left of them.

    ``of`` makes what the polynomial is in of the letter, where that is neither. None where the
    roots cannot be written, or are none of the solution.
    """
    if of is None:
        of = itself if generator == symbol else generator.func
    factors = [(base, power) for base, power in factor_powers(above) if base.has(generator)]
    linear = linear_factors(scene, number, symbol) if generator == symbol else []
    sides = sides_but_for_sign(scene, number, symbol) if generator == symbol else None
    if sides is not None:
        linear = [expanded(sides[0] - sides[1]), expanded(sides[0] + sides[1])]
    if sides is not None or (len(linear) > 1 and any(value.atoms(sp.Pow) for value in linear)):
        factors = [(value, 1) for value in linear]  # with roots of numbers they are not found again
    polynomials = [_without_root_in_front(polynomial_in(base, generator)) for base, _ in factors]
    if not factors or any(
        polynomial.degree() > 2
        or symbol in (c for x in polynomial.coeffs() for c in x.free_symbols)
        for polynomial in polynomials
    ):
        return None
    roots: list[sp.Expr] = []
    for polynomial in polynomials:
        roots += _real_roots(scene, number, polynomial)
    roots = list(dict.fromkeys(roots))
    if scene.kept and any(
        power.exp == sp.S.Half and power.free_symbols & scene.kept
        for root in roots
        for power in root.atoms(sp.Pow)
    ):
        return None  # where an angle stays below a root, its ratios are put in first
    kept = [root for root in roots if is_reached(scene, root, of, symbol)]
    wanted = [value for value in kept if is_value(scene.model, value, of, symbol)]
    if len(wanted) != 1:
        return None
    (value,) = wanted
    kept.sort(key=lambda value: _first_reached(scene, value, of, symbol))
    roots = [*kept, *(root for root in roots if root not in kept)]
    dropped = [root for root in roots if root not in kept]
    whole = expanded(sp.Mul(*(base**power for base, power in factors)))
    if generator != symbol or not (
        sides
        or is_square_of_sum(scene, number, symbol)
        or is_product_of_sums(scene, number, symbol)
    ):
        number = in_standard_form(scene, number, whole, generator, subject)
        parts = [base for base, _ in factors] if len(factors) > 1 else [sp.Pow(*factors[0])]
        number = _in_factors(scene, number, parts, generator, subject)
    alternatives = Relation(tuple(option(subject, root) for root in roots))
    names = symbol_names(above)
    known = background(scene, names)
    of_squares = scene.desk.line(number)
    signed = None if sides is None else _but_for_sign(scene, number, sides, roots, symbol)
    move = Move("roots" if signed is None else "rearrange")
    number = number if signed is None else signed
    refs = scene.judge.enough(move, (number,), alternatives, known)
    line: int | None
    if signed is not None and _says_roots(scene, number, symbol, alternatives):
        line = number
    elif refs is not None:
        line = None
        if signed is None:
            line = _by_the_formula(scene, number, polynomials, alternatives, known)
        line = line or _by_linear_factors(scene, number, polynomials, alternatives, known, move)
        line = line or scene.desk.write(move, refs, alternatives)
    elif len(polynomials) == 1:
        line = _by_pythagoras(scene, number, polynomials[0], alternatives, known)
    else:
        line = None
    if line is None:
        scene.desk.lines[of_squares.number - 1] = of_squares
        return None
    if dropped:
        standing = line
        try:
            line = rejected(scene, line, symbol, subject, kept)
        except NotPlannedError:
            scene.desk.lines[of_squares.number - 1] = of_squares  # another way may begin there
            raise
        if signed is None:
            put_in_order_last(scene, standing, line)
    if len(kept) > 1:
        scene.desk.splits += ((line, kept.index(value)),)
        scene.others = tuple(other for other in scene.others if is_value(other, value, of, symbol))
    if generator == symbol:
        return known_as(scene, symbol, value, line)
    return scene.desk.know(subject, value, (line,))


def _but_for_sign(
    scene: Scene,
    number: int,
    sides: tuple[sp.Expr, sp.Expr],
    roots: Sequence[sp.Expr],
    symbol: sp.Symbol,
) -> int | None:
    """The line that two values with equal squares are equal or opposite.

    The two equations stand in the order of the roots that they have.
    """
    one, other = sides if symbol in sides[0].free_symbols else sides[::-1]
    ends = [other if tidy((one - other).subs(symbol, e)) == 0 else -other for e in roots]
    if len(ends) != 2 or ends[0] == ends[1]:
        return None
    left, right = (tree_of(sp.factor_terms(side)) for side in (one, other))
    relation = Relation(
        tuple((Link(left, "=", right if end == other else negative(right)),) for end in ends)
    )
    known = background(scene, symbol_names(residual(scene, number)))
    move = Move("rearrange") if _of_one_component(scene, number, symbol, roots) else _ROOTS
    standing = scene.desk.relation(number)
    if standing == relation or _is_solved(standing, symbol):
        return number
    if move == _ROOTS and (quotients := _roots_of_quotients(scene, number, relation)) is not None:
        number, move = quotients, Move("rearrange")
    refs = scene.judge.enough(move, (number,), relation, known)
    return None if refs is None else scene.desk.write(move, refs, relation)


def _roots_of_quotients(scene: Scene, number: int, relation: Relation) -> int | None:
    """The line with the roots of two quotients of squares, in the order of a ``relation``.

    They are not multiplied across yet. None of other sides.
    """
    link = scene.desk.last_link(number)
    left, right = root_of_squares(link.left), root_of_squares(link.right)
    if left is None or right is None or not all(is_binary(e, "/") for e in (left, right)):
        return None
    for ends in ((right, negative(right)), (negative(right), right)):
        roots = Relation(tuple((Link(left, "=", end),) for end in ends))
        mark = scene.desk.mark()
        line = scene.judge.write((_ROOTS,), (number,), roots)
        if line is not None and scene.judge.follows(Move("rearrange"), (line,), relation):
            return line
        scene.desk.back(mark)
    return None


def _says_roots(scene: Scene, number: int, symbol: sp.Symbol, alternatives: Relation) -> bool:
    """Whether a line says already what an unknown is; it then has the roots as they are used."""
    own = scene.desk.line(number)
    if not _is_solved(scene.desk.relation(number), symbol):
        return False
    if not scene.judge.follows(own.move, own.premises, alternatives):
        return False
    scene.desk.lines[number - 1] = replace(own, relation=alternatives)
    return True


def _is_solved(relation: Relation, symbol: sp.Symbol) -> bool:
    """Whether alternatives say already what an unknown is."""
    own = Letter(symbol.name)
    links = [links for links in relation.options if len(links) == 1]
    return len(links) == len(relation.options) > 1 and all(link.left == own for (link,) in links)


def _of_one_component(
    scene: Scene, number: int, symbol: sp.Symbol, roots: Sequence[sp.Expr]
) -> bool:
    """Whether a speed is that of one component: ``v = ±u/3`` stands in the place of squares."""
    pair = speed_of_one_component(scene, number, symbol)
    if pair is None:
        return False
    component, speed = pair
    value = scene_value(scene, component) - scene_value(scene, speed)
    ends = [speed if tidy(value.subs(symbol, e)) == 0 else negative(speed) for e in roots]
    relation = Relation(tuple((Link(component, "=", end),) for end in ends))
    line = scene.desk.line(number)
    if not scene.judge.follows(line.move, line.premises, relation):
        return False
    scene.desk.lines[number - 1] = replace(line, relation=relation)
    return True


def _by_the_formula(
    scene: Scene,
    number: int,
    polynomials: Sequence[sp.Poly],
    roots: Relation,
    known: Iterable[Ref],
) -> int | None:
    """The roots of a quadratic in numbers with roots, as the formula gives them, before they are
    put in order. None of another one.
    """
    letter = polynomials[0].gen
    match scene.desk.last_link(number):
        case Link(Binary("^", base, _), "=", right) if letter.is_Symbol and is_square_of_sum(
            scene, number, letter
        ):
            return _of_a_square(scene, number, (base, right), roots, known)
    if len(polynomials) != 1 or polynomials[0].degree() != 2:
        return None
    coefficients = polynomials[0].all_coeffs()
    if not all(coefficient.is_number for coefficient in coefficients) or all(
        coefficient.is_Rational for coefficient in coefficients
    ):
        return None
    if coefficients[1] == 0 or len(roots.options) < 2:
        return None  # of a double root there is nothing to put in order
    return _in_two_lines(scene, number, polynomials[0], roots, known, Move("rearrange"))


def _by_linear_factors(
    scene: Scene,
    number: int,
    polynomials: Sequence[sp.Poly],
    roots: Relation,
    known: Iterable[Ref],
    move: Move,
) -> int | None:
    """The roots of linear factors in numbers with roots as quotients, and then put in order.

    None of other factors.
    """
    if len(polynomials) < 2 or any(polynomial.degree() != 1 for polynomial in polynomials):
        return None
    if not all(c.is_number for polynomial in polynomials for c in polynomial.all_coeffs()):
        return None
    quotients: dict[sp.Expr, Expression] = {}
    for polynomial in polynomials:
        slope, rest = (expanded(c) for c in polynomial.all_coeffs())
        shared = sp.gcd(*(sp.factor_terms(c).as_coeff_Mul()[0] for c in (slope, rest)))
        if scene.model.sign(slope) < 0:
            shared = -shared
        parts = (tree_of(expanded(x / shared), as_it_is=True) for x in (-rest, slope))
        if slope.is_Add:
            quotients[tidy(-rest / slope)] = Binary("/", *parts)
    options = tuple(
        (Link(links[0].left, "=", quotients.get(scene.scalar(links[0].right), links[0].right)),)
        for links in roots.options
    )
    return _then(scene, number, Relation(options), roots, known, Move("rearrange"), move)


def _of_a_square(
    scene: Scene,
    number: int,
    sides: tuple[Expression, Expression],
    roots: Relation,
    known: Iterable[Ref],
) -> int | None:
    """The roots of (px + q)² = c, of a p that is a sum of roots of numbers, as quotients."""
    subject = roots.options[0][0].left
    base, right = (sp.sympify(scene_value(scene, side), strict=True) for side in sides)
    symbols = [symbol for symbol in base.free_symbols if Letter(symbol.name) == subject]
    if len(symbols) != 1 or len(base.free_symbols) != 1 or not right.is_number:
        return None
    (symbol,) = symbols
    slope, rest = expanded(base).coeff(symbol, 1), expanded(base).coeff(symbol, 0)
    if not slope.is_Add:
        return None
    options: list[tuple[Link, ...]] = []
    for links in roots.options:
        value = scene.scalar(links[0].right)
        root = sp.sqrt(right) if scene.model.sign(slope * value + rest) > 0 else -sp.sqrt(right)
        trees = (tree_of(value, as_it_is=True) for value in (expanded(root - rest), slope))
        tree = tree_of(value) if value.is_Rational else Binary("/", *trees)
        options.append((Link(subject, "=", tree),))
    return _then(scene, number, Relation(tuple(options)), roots, known, Move("rearrange"))


def _by_pythagoras(
    scene: Scene, number: int, polynomial: sp.Poly, roots: Relation, known: Iterable[Ref]
) -> int | None:
    """The roots of a quadratic by the formula, where sin² + cos² = 1 makes its root a number.

    None of another one.
    """
    if polynomial.degree() != 2:
        return None
    a, b, c = (polynomial.nth(n) for n in (2, 1, 0))
    inside = b**2 / 4 - a * c
    if not inside.has(sp.sin, sp.cos) or varies_with_angles(inside):
        return None
    inside = expanded(inside)
    plain = in_sines(inside) if inside.free_symbols else tidy(inside)
    if plain is None or expanded(plain).has(sp.sin, sp.cos):
        return None
    return _in_two_lines(scene, number, polynomial, roots, known, Move("identity", "pythagoras"))


def varies_with_angles(value: sp.Expr) -> bool:
    """Whether two angles in the place of each one in letters give two values: a number is one."""
    turned = {s for ratio in value.atoms(sp.sin, sp.cos) for s in ratio.args[0].free_symbols}
    others = sorted(value.free_symbols - turned, key=str)
    sizes = {letter: sp.Rational(n + 7, n + 5) for n, letter in enumerate(others)}
    one, other = (
        value.evalf(20, subs=sizes | {s: sp.Rational(n, 9) for n, s in enumerate(turned, first)})
        for first in (2, 3)
    )
    return bool(abs(one - other) > abs(one) * sp.Float("1e-12"))


def in_sines(value: sp.Expr) -> sp.Expr | None:
    """A value with cos² = 1 − sin² of each angle; None where ratios stand in another function."""
    sides = sp.fraction(one_fraction(value))
    ratios = sorted(value.atoms(sp.sin, sp.cos), key=sp.default_sort_key)
    try:
        for angle in dict.fromkeys(ratio.args[0] for ratio in ratios):
            sides = tuple(without_cos_squared(side, angle) for side in sides)
    except PolynomialError:
        return None
    return sides[0] / sides[1]


def _in_two_lines(
    scene: Scene,
    number: int,
    polynomial: sp.Poly,
    roots: Relation,
    known: Iterable[Ref],
    move: Move,
) -> int | None:
    """Roots as the formula gives them, and then, by a move, as they are."""
    turned = scene.model.sign(polynomial.LC()) < 0
    a, b, c = (-polynomial.nth(n) if turned else polynomial.nth(n) for n in (2, 1, 0))
    half = expanded(b / 2)
    if any(not term.as_coeff_Mul()[0].is_Integer for term in sp.Add.make_args(half)):
        a, half, c = 2 * a, b, 2 * c  # (−7 ± √193)/6, and not (−7/2 ± √(193/4))/3
    inside = expanded(half**2 - a * c)
    own = expanded(tidy(sp.sqrt(inside)))
    plain = own.is_Add and not any(p.base.has(sp.Pow) for p in own.atoms(sp.Pow))
    root: Expression = Apply(
        "sqrt", square(tree_of(own, as_it_is=True)) if plain else tree_of(inside, as_it_is=True)
    )
    if own.is_Rational:
        root = tree_of(own)
    subject = roots.options[0][0].left
    by_formula: list[tuple[Link, ...]] = []
    for links in roots.options:
        plus = scene.model.sign(a * scene.scalar(links[0].right) + half) > 0
        above = Binary("+" if plus else "-", tree_of(-half), root)
        by_formula.append((Link(subject, "=", swept(Binary("/", above, tree_of(a)))),))
    if all(
        _leaves(one[0].right) == _leaves(other[0].right)
        for one, other in zip(by_formula, roots.options, strict=True)
    ):
        return None  # only the terms are in another order
    return _then(scene, number, Relation(tuple(by_formula)), roots, known, move)


def _leaves(tree: Expression) -> list[str]:
    """The numbers and letters of a tree, without the order in which they stand."""
    return sorted(repr(node) for node in walk(tree) if isinstance(node, Letter | Number))


def _then(
    scene: Scene,
    number: int,
    first: Relation,
    roots: Relation,
    known: Iterable[Ref],
    move: Move,
    before: Move = _ROOTS,
) -> int | None:
    """Roots in a first form, and then, by a move, in their own; None where they have that."""
    if first == roots:
        return None
    refs = scene.judge.enough(before, (number,), first, known)
    if refs is None:
        return None
    mark = scene.desk.mark()
    line = scene.desk.write(before, refs, first)
    refs = scene.judge.enough(move, (line,), roots, known)
    if refs is None:
        scene.desk.back(mark)
        return None
    return scene.desk.write(move, refs, roots)


def _real_roots(scene: Scene, number: int, polynomial: sp.Poly) -> list[sp.Expr]:
    """The roots of a factor that are real at the numbers of the solution."""
    if polynomial.degree() == 2:
        a, b, c = (polynomial.nth(n) for n in (2, 1, 0))
        if b == 0 and (own := square_in_degrees(scene, number, polynomial.gen)) is not None:
            return [] if scene.model.sign(own) < 0 else [sp.sqrt(own), -sp.sqrt(own)]
        if b == 0 and (own := _quotient_root(scene, -c / a)) is not None:
            return [own, -own]
        inside = factored(b**2 - 4 * a * c)
        if scene.model.sign(inside) < 0:
            return []
        root = tidy(sp.sqrt(inside))
        root = root.replace(sp.Abs, lambda x: x if scene.model.sign(x) >= 0 else -x)
        return [tidy((-b + sign * root) / (2 * a)) for sign in (1, -1)]
    slope, rest = polynomial.nth(1), polynomial.nth(0)
    return [tidy(-rest / slope)]


def _quotient_root(scene: Scene, square_: sp.Expr) -> sp.Expr | None:
    """The root of a quotient with a sum below, in one root; None of another."""
    factors = sp.factor_list(one_fraction(square_).as_numer_denom()[1])[1]
    if not any(base.is_Add and power % 2 for base, power in factors):
        return None
    (above, left_above), (below, left_below) = map(
        _squares_out, one_fraction(square_).as_numer_denom()
    )
    if scene.model.sign(scene.model.in_data(left_below)) < 0:
        left_above, left_below = expanded(-left_above), expanded(-left_below)
    outside, inside = above / below, left_above / left_below
    if scene.model.sign(scene.model.in_data(inside)) <= 0:
        return None
    back = scene.model.sign(scene.model.in_data(outside)) < 0
    return sp.sympify((-outside if back else outside) * sp.sqrt(inside), strict=True)


def _squares_out(whole: sp.Expr) -> tuple[sp.Expr, sp.Expr]:
    """The root of the squares in a product, and the rest: u² − v², and not (u + v)(u − v)."""
    number, factors = sp.factor_list(whole)
    outside = sp.Mul(*(base ** (power // 2) for base, power in factors))
    rest = number * sp.Mul(*(base ** (power % 2) for base, power in factors))
    open_ = expanded(rest)
    return outside, open_ if len(sp.Add.make_args(open_)) <= 2 else rest


def in_standard_form(
    scene: Scene, number: int, above: sp.Expr, generator: sp.Expr, subject: Expression
) -> int:
    """The equation as ``x² = c`` or ``ax² + bx + c = 0``, where it does not stand so already."""
    polynomial = polynomial_in(above, generator)
    higher = polynomial.degree() > 2 and all(c.is_number for c in polynomial.all_coeffs())
    fourth = polynomial.degree() == 4 and not polynomial.nth(3) and not polynomial.nth(1)
    if polynomial.degree() != 2 and not fourth and not higher:
        return number
    link = scene.desk.last_link(number)
    squared = doubled_power(subject)
    if squared in (link.left, link.right) or _is_in_powers(scene, link, generator):
        return number
    pure = polynomial.degree() == 2 and polynomial.nth(1) == 0
    if pure:
        value = square_in_degrees(scene, number, generator)
        by_degrees = value is not None
        if value is None:
            value = tidy(-polynomial.nth(0) / polynomial.nth(2))
        relation = chain(squared, (tree_of(value, as_it_is=by_degrees), None))
    else:
        tree = polynomial_tree(_plain(scene, above, generator), subject)
        relation = equality(tree, ZERO)
    if scene.desk.relation(number) == relation:
        return number
    own = scene.desk.line(number)
    if higher and own.move.id == "rearrange" and link.right == ZERO:
        return scene.desk.write(own.move, own.premises, relation)  # the highest power first
    move = Move("rearrange")
    names_ = symbol_names(residual(scene, number))
    refs = scene.judge.enough(move, (number,), relation, background(scene, names_))
    if refs is None and pure and not by_degrees:
        line = _square_by_pythagoras(scene, number, squared, polynomial)
        if line is not None:
            return line
    if refs is None and pure:
        # A given fact may tell that what it is divided by is not zero.
        given = [ref for ref in scene.judge.known(names_) if ref in scene.facts]
        given += [ref for ref in scene.facts if ref.startswith(("approach ", "velocity "))]
        refs = scene.judge.enough(Move("cancel"), (number,), relation, given) if given else None
        if refs is not None:
            return scene.desk.write(Move("cancel"), refs, relation)
    if refs is None and pure:
        # What it is divided by may be zero: that stands on the side of the square.
        sides = (polynomial.nth(2), -polynomial.nth(0))
        minus = scene.model.sign(scene.model.in_data(sides[1])) < 0
        lead, rest = (tidy(factored(-side if minus else side)) for side in sides)
        plain = tree_of(lead * generator**2) if squared == tree_of(generator**2) else None
        left = plain or product(tree_of(lead), squared)
        relation = chain(left, (tree_of(rest), None))
        if relation != scene.desk.relation(number):
            refs = scene.judge.enough(move, (number,), relation, background(scene, names_))
    return number if refs is None else scene.desk.write(move, refs, relation)


def _square_by_pythagoras(
    scene: Scene, number: int, squared: Expression, polynomial: sp.Poly
) -> int | None:
    """The square of an unknown as the equation has it, and then as sin² + cos² = 1 has it.

    The last is the square of the root that follows. None where no such line follows.
    """
    value = one_fraction(-polynomial.nth(0) / polynomial.nth(2))
    roots = _real_roots(scene, number, polynomial)
    if not roots or not value.has(sp.sin) or not value.has(sp.cos):
        return None
    of_root = one_fraction(roots[0] ** 2)
    first, last = (equality(squared, tree_of(own, as_it_is=True)) for own in (value, of_root))
    known = background(scene, symbol_names(residual(scene, number)))
    refs = scene.judge.enough(Move("rearrange"), (number,), first, known)
    if refs is None:
        return None
    standing = scene.desk.mark()
    line = scene.desk.write(Move("rearrange"), refs, first)
    if first == last:
        return line
    by = Move("identity", "pythagoras")
    refs = scene.judge.enough(by, (line,), last, known)
    if refs is None:
        scene.desk.back(standing)
        return None
    return scene.desk.write(by, refs, last)


def _is_in_powers(scene: Scene, link: Link, letter: sp.Expr) -> bool:
    """Whether a sum of powers of a letter, with letters beside it, is zero: the highest first."""
    if not letter.is_Symbol or link.right != ZERO:
        return False
    values = [scene_value(scene, tree) for tree in outer_terms(link.left)]
    if len(letters(link.left)) < 2 or not all(value.is_polynomial(letter) for value in values):
        return False
    polynomials = [polynomial_in(value, letter) for value in values]
    powers = [polynomial.degree() for polynomial in polynomials]
    return all(polynomial.is_monomial for polynomial in polynomials) and powers == [2, 1, 0]


def _plain(scene: Scene, above: sp.Expr, generator: sp.Expr) -> sp.Poly:
    """A polynomial without a common factor, and with what is positive in front."""
    x = sp.Dummy(real=True)
    _, rest = _without_root_in_front(polynomial_in(above.xreplace({generator: x}), x)).primitive()
    return -rest if scene.model.sign(rest.LC()) < 0 else rest


def _without_root_in_front(polynomial: sp.Poly) -> sp.Poly:
    """A quadratic divided by the root of a number in its first term, where roots go by that and
    no fractions come.

    ``2√3 x² − 3(1 + e)x + √3(1 − e)`` is √3 times ``2x² − √3(1 + e)x + 1 − e``.
    """
    if polynomial.degree() != 2:
        return polynomial
    lead = polynomial.LC()
    _, root = lead.as_independent(*lead.free_symbols)[0].as_coeff_Mul()
    if not (root.is_Pow and root.base.is_Integer and root.exp == sp.Rational(1, 2)):
        return polynomial
    divided = sp.Poly(
        [expanded(coefficient / root) for coefficient in polynomial.all_coeffs()], polynomial.gen
    )
    before, after = (sum(c.has(root) for c in e.all_coeffs()) for e in (polynomial, divided))
    whole = all(
        sp.fraction(one_fraction(coefficient))[1] == 1 for coefficient in divided.all_coeffs()
    )
    return divided if after < before and whole else polynomial


def _in_factors(
    scene: Scene,
    number: int,
    factors: Sequence[sp.Expr],
    generator: sp.Expr,
    subject: Expression,
) -> int:
    """A quadratic as the product of two linear factors, or as a square, where it is one.

    What is of a higher degree is the product of all its factors.
    """
    if scene.desk.last_link(number).right != ZERO:
        return number
    degrees = [polynomial_in(factor, generator).degree() for factor in factors]
    root = _double_root(factors, generator)
    if root is not None:
        above, below = sp.fraction(root)
        once = _plain(scene, below * generator - above, generator)
        relation = equality(square(polynomial_tree(once, subject)), ZERO)
    elif degrees in ([1, 1], [2, 2]) or (len(degrees) > 1 and sum(degrees) > 2):
        plain = [_plain(scene, factor, generator) for factor in factors]
        plain.sort(key=_in_order)
        trees = [polynomial_tree(value, subject) for value in plain]
        relation = equality(product(*trees), ZERO)
    else:
        return number
    names = symbol_names(residual(scene, number))
    refs = scene.judge.enough(Move("rearrange"), (number,), relation, background(scene, names))
    return number if refs is None else scene.desk.write(Move("rearrange"), refs, relation)


def _in_order(factor: sp.Poly) -> tuple[int, bool, bool, str]:
    """Where a factor stands: what is linear first, and of that the unknown itself."""
    rest = factor.nth(0)
    return factor.degree(), rest != 0, factor.LC() == 1, str(rest)


def _double_root(factors: Sequence[sp.Expr], generator: sp.Expr) -> sp.Expr | None:
    """The only root of a quadratic in numbers that is a square; None of any other."""
    polynomials = [polynomial_in(factor, generator) for factor in factors]
    if len(polynomials) != 1 or polynomials[0].degree() != 2:
        return None
    a, b, c = polynomials[0].all_coeffs()
    if not (a.is_number and b.is_number and c.is_number) or b == 0:
        return None
    return tidy(-b / (2 * a)) if tidy(b**2 - 4 * a * c) == 0 else None


def itself(value: sp.Expr) -> sp.Expr:
    """What an equation for the unknown itself is solved for."""
    return value


Of = Callable[[sp.Expr], sp.Expr]
"""What an equation is solved for, made of the unknown: the sine of an angle, a square."""


def is_value(model: Model, root: sp.Expr, of: Of, symbol: sp.Symbol) -> bool:
    """Whether a root is what the unknown is by a solution."""
    return model.sign(model.in_data(root) - of(model.final[symbol])) == 0


def is_reached(scene: Scene, root: sp.Expr, of: Of, symbol: sp.Symbol) -> bool:
    """Whether a root is that of some solution of the part."""
    return any(is_value(model, root, of, symbol) for model in scene.others or (scene.model,))


def _first_reached(scene: Scene, root: sp.Expr, of: Of, symbol: sp.Symbol) -> int:
    """Which of the solutions is the first with a root: in that order they are written."""
    return next(
        n
        for n, model in enumerate(scene.others or (scene.model,))
        if is_value(model, root, of, symbol)
    )


# --- what excludes a root -----------------------------------------------------------------------
