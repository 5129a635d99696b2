"""Equations multiplied out: what is common to all terms is gone, and each side is a polynomial.

A line from which its unknown is read at once stays as it is. One that takes several steps (a
common factor, brackets, an unknown in several terms or below a line) gets a line between.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import permutations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import atoms_in, substituted, symbol_names, symbols_in
from restitution.explaining.lines.derivation import Link, Move
from restitution.explaining.lines.trees import rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    has_standard_ratios,
    is_binary,
    is_zero,
    letters,
    unsigned,
    unsigned_terms,
    walk,
)
from restitution.expression.writing import write_expression
from restitution.planning.closing.plain_quotients import with_plain_quotients
from restitution.planning.closing.products_out import with_products_out
from restitution.planning.closing.square_roots import squares_collected
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.formulas.rewriting import in_another_form
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import (
    ONE,
    alike,
    difference,
    factors,
    number,
    outer_terms,
    product,
    square,
    tree_of,
)
from restitution.planning.writing.polynomials import cancelled, expanded, one_fraction
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.work import remembered

_TRIGONOMETRIC = (sp.sin, sp.cos, sp.tan)
# More steps than this are not made in one line.
_MOST = 1


def multiplied_out(scene: Scene, line: int, *symbols: sp.Symbol) -> int:
    """The line with both sides multiplied out, as a line, where that is a step of its own.

    ``symbols`` are the unknowns in it.
    """
    link = scene.desk.last_link(line)
    if link.sign != "=" or any(_is_plain(link, symbol.name) for symbol in symbols):
        return line
    if len(symbols) == 1 and _is_of_one_bracket(link, symbols[0].name):
        return line
    if len(symbols) == 1 and _is_worked_out(scene, link, symbols[0]):
        return line
    line = _with_plain_squares(scene, line)
    line = with_plain_quotients(scene, line)
    line = with_products_out(scene, line, *symbols)
    line = _squares_cleared(scene, _across(scene, line, symbols), symbols)
    if len(symbols) == 1:
        collected = squares_collected(scene, line, symbols[0])
        if collected != line:
            return collected
    link = scene.desk.last_link(line)
    sides = [sp.sympify(scene_value(scene, side), strict=True) for side in (link.left, link.right)]
    generators = _of_all(sides, symbols)
    if generators is None:
        return line
    tangents = _tangents(link, sides, symbols)
    for angle, t in tangents.items():
        c = sp.cos(angle)
        sides = [cancelled(side.xreplace({sp.sin(angle): t * c})) for side in sides]
    for ratios in (True, False):
        polynomials = _without_common(tuple(sides), generators, ratios)
        own = None if polynomials is None else _written(scene, line, polynomials, symbols, tangents)
        if own is not None:
            return own
    return line


def _tangents(
    link: Link, sides: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]
) -> dict[sp.Expr, sp.Symbol]:
    """Letters for the tangents of other angles, of which no sine and no cosine is written."""
    names: set[str | Fraction] = set()
    others: set[str | Fraction] = set()
    for node in (*walk(link.left), *walk(link.right)):
        match node:
            case Apply(function, Letter(name) | Degrees(name)):
                (names if function == "tan" else others).add(name)
    names -= others
    inside = {symbol for side in sides for symbol in symbols_in(side)} - set(symbols)
    own: list[sp.Expr] = [symbol for symbol in inside if symbol.name in names]
    own += [
        _in_radians(size)
        for size in names
        if isinstance(size, Fraction) and not has_standard_ratios(size)
    ]
    return {angle: sp.Symbol(f"tan {angle}", positive=True) for angle in own}


def _in_radians(degrees: Fraction) -> sp.Expr:
    return sp.Rational(degrees.numerator, degrees.denominator) * sp.pi / 180


def _angle_tree(angle: sp.Expr) -> Expression:
    """An angle as a line has it: a letter, or a number of degrees."""
    if isinstance(angle, sp.Symbol):
        return Letter(angle.name)
    return Degrees(Fraction(*map(int, (180 * angle / sp.pi).as_numer_denom())))


def _with_plain_squares(scene: Scene, line: int) -> int:
    """The line with what is squared in its shortest form, where a quotient was put into it."""
    link = scene.desk.last_link(line)

    def plain(node: Expression) -> Expression:
        if not is_binary(node, "^") or node.right != number(2):
            return node
        if not _has_quotient_in_a_sum(node.left):
            return node
        own = tree_of(tidy(expanded(cancelled(scene_value(scene, node.left)))))
        own = unsigned(own)
        return Binary("^", own, node.right) if len(walk(own)) < len(walk(node.left)) else node

    left, right = (rebuilt(side, plain) for side in (link.left, link.right))
    if (left, right) == (link.left, link.right):
        return line
    names = symbol_names(residual(scene, line))
    relation = chain(left, (right, None))
    refs = scene.judge.enough(Move("rearrange"), (line,), relation, background(scene, names))
    return line if refs is None else scene.desk.write(Move("rearrange"), refs, relation)


def _across(scene: Scene, line: int, symbols: Sequence[sp.Symbol]) -> int:
    """The line without a quotient that has a square with the unknown above, and it below too."""
    link = scene.desk.last_link(line)
    for near, far in ((link.left, link.right), (link.right, link.left)):
        match near:
            case Binary("/", above, below) if all(
                _has(tree, symbol.name) for tree in (above, below) for symbol in symbols
            ):
                pass
            case _:
                continue
        squares = [e for e in walk(above) if is_binary(e, "^")]
        sums = [e for e in squares if is_binary(e.left, "+", "-")]
        if not sums or any(_has(far, symbol.name) for symbol in symbols):
            continue
        top, bottom = (far.left, far.right) if is_binary(far, "/") else (far, ONE)
        relation = chain(product(top, below), (product(bottom, above), None))
        names = symbol_names(residual(scene, line))
        refs = scene.judge.enough(Move("rearrange"), (line,), relation, background(scene, names))
        return line if refs is None else scene.desk.write(Move("rearrange"), refs, relation)
    return line


def _squares_cleared(scene: Scene, line: int, symbols: Sequence[sp.Symbol]) -> int:
    """A sum of squares of quotients without the sum that is below, as a line of squares.

    The same line where not all terms are squares, or no unknown stands in a sum below one.
    """
    link = scene.desk.last_link(line)
    sides = [list(_terms(side)) for side in (link.left, link.right)]
    terms = [term for side in sides for term in side]
    bases = [e.left for e in terms if is_binary(e, "^") and e.right == number(2)]
    if len(bases) < len(terms) or len(terms) < 3 or _has_difference(link):
        return line
    values = [sp.sympify(scene_value(scene, base), strict=True) for base in bases]
    powers = (power for value in values for power in value.atoms(sp.Pow))
    if any(power.free_symbols and not power.exp.is_Integer for power in powers):
        return line
    fractions = [sp.fraction(one_fraction(value)) for value in values]
    below = sp.lcm([d for _, d in fractions])
    if not any(d.is_Add or d.has(sp.Add) for _, d in fractions if d.free_symbols & set(symbols)):
        return line
    parts = [sp.factor_terms(cancelled(n * below / d)) for n, d in fractions]
    common = sp.Mul(*set.intersection(*(set(sp.Mul.make_args(part)) for part in parts)))
    trees: list[Expression] = []
    for part in parts:
        factor, rest = sp.factor_terms(part / common).as_independent(
            *part.free_symbols, as_Add=False
        )
        whole = square(tree_of(rest)) if rest != 1 else ONE
        trees.append(product(tree_of(tidy(factor**2)), whole) if factor**2 != 1 else whole)
    left, right = (_total(trees[: len(sides[0])]), _total(trees[len(sides[0]) :]))
    relation = chain(left, (right, None))
    names = symbol_names(residual(scene, line))
    refs = scene.judge.enough(Move("rearrange"), (line,), relation, background(scene, names))
    return line if refs is None else scene.desk.write(Move("rearrange"), refs, relation)


def _has_difference(link: Link) -> bool:
    """Whether a term of a side is taken off."""
    return any(
        isinstance(node, Negate) or is_binary(node, "-")
        for side in (link.left, link.right)
        for node in _sums_of(side)
    )


def _sums_of(tree: Expression) -> Iterator[Expression]:
    yield tree
    if is_binary(tree, "+", "-"):
        yield from _sums_of(tree.left)
        yield from _sums_of(tree.right)


def _has_quotient_in_a_sum(tree: Expression) -> bool:
    """Whether a quotient with letters below stands in a sum."""
    return any(
        is_binary(node, "+", "-")
        and any(is_binary(e, "/") and letters(e.right) for e in walk(node))
        for node in walk(tree)
    )


def _written(
    scene: Scene,
    line: int,
    polynomials: Polynomials,
    symbols: Sequence[sp.Symbol],
    tangents: Mapping[sp.Expr, sp.Symbol],
) -> int | None:
    """The line with both sides as these polynomials; None where it does not follow.

    ``tangents`` are letters that stand for those of angles.
    """
    link = scene.desk.last_link(line)
    sides = [sp.sympify(scene_value(scene, side), strict=True) for side in (link.left, link.right)]
    generators = polynomials[0].gens
    steps = max(_steps(link, symbol.name) for symbol in symbols) + _has_common(
        sides, polynomials, tangents
    )
    if steps <= _MOST:
        return line
    for angle in symbols:
        if sp.sin(angle) in generators and _is_of_tangents(link, angle.name):
            polynomials = _in_tangents(polynomials, angle) or polynomials
            generators = polynomials[0].gens
    symbol = symbols[0]
    back: dict[Expression, Expression] = {
        Letter(t.name): Apply("tan", _angle_tree(angle)) for angle, t in tangents.items()
    }
    left, right = (
        rebuilt(side, lambda tree: back.get(tree, tree))
        for side in _sides(scene, polynomials, generators)
    )
    relation = chain(left, (right, None))
    if (
        is_zero(left)
        or Letter(symbol.name) in (left, right)
        or (alike(left, link.left) and alike(right, link.right))
    ):
        return line
    return in_another_form(scene, line, relation)


def _is_plain(link: Link, name: str) -> bool:
    """Whether the unknown stands alone on a side."""
    return Letter(name) in (link.left, link.right)


def _is_of_one_bracket(link: Link, name: str) -> bool:
    """Whether a product has the unknown in one sum of two terms, and no other sum is there.

    From ``½mu = m(u − v)`` a reader sees v at once.
    """
    for near, far in ((link.left, link.right), (link.right, link.left)):
        own = [factor for factor in factors(near) if _has(factor, name)]
        if len(own) != 1 or near in own or _has(far, name):
            continue
        terms = [unsigned(e) for e in outer_terms(own[0])]
        others = [e for side in (near, far) for e in walk(side) if e is not own[0]]
        sums = [e for e in others if is_binary(e, "+", "-")]
        if len(terms) == 2 and terms.count(Letter(name)) == 1 and not sums:
            return True
    return False


def _is_worked_out(scene: Scene, link: Link, symbol: sp.Symbol) -> bool:
    """Whether a line is linear in its unknown, with roots of ratios such as sin²35° in figures.

    From 0.8805u = 1.242eu a reader has e at once; other letters are common to all terms.
    """
    sides = [sp.sympify(scene_value(scene, side), strict=True) for side in (link.left, link.right)]
    roots = [
        power for side in sides for power in atoms_in(side, sp.Pow) if not power.exp.is_Integer
    ]
    if not any(root.has(sp.sin, sp.cos) for root in roots) or any(r.free_symbols for r in roots):
        return False
    gap = expanded(sides[0] - sides[1])
    if gap.has(*(f for f in atoms_in(gap, sp.Function) if f.free_symbols)):
        return False
    numbers = [gap.coeff(symbol, n).factor() for n in (0, 1)]
    scales = [x.as_independent(*x.free_symbols, as_Add=False)[1] for x in numbers]
    linear = expanded(gap - numbers[0] - numbers[1] * symbol) == 0
    return linear and scales[0] == scales[1] and not scales[0].is_Add


def _of_all(sides: Sequence[sp.Expr], symbols: Sequence[sp.Symbol]) -> tuple[sp.Expr, ...] | None:
    """The same of several unknowns: the letters before the ratios of angles."""
    terms: list[sp.Expr] = []
    for symbol in symbols:
        if not any(symbol in symbols_in(side) for side in sides):
            continue
        own = _generators(sides, symbol)
        if own is None:
            return None
        terms += own
    return tuple(sorted(terms, key=lambda term: not term.is_Symbol)) or None


# What stands for a function of the unknown.
_FUNCTION = sp.Dummy()


def _generators(sides: Sequence[sp.Expr], symbol: sp.Symbol) -> tuple[sp.Expr, ...] | None:
    """In what the sides are polynomials: the unknown, or its sine and cosine, or its tangent."""
    functions = {
        f for side in sides for f in atoms_in(side, sp.Function) if symbol in symbols_in(f)
    }
    bare = [substituted(side, dict.fromkeys(functions, _FUNCTION)) for side in sides]
    inside = any(symbol in symbols_in(value) for value in bare)
    roots = {p for side in sides for p in atoms_in(side, sp.Pow) if not p.exp.is_Integer}
    if any(symbol in symbols_in(root) for root in roots):
        return None
    if not functions:
        return (symbol,) if inside else None
    if inside or any(not isinstance(f, _TRIGONOMETRIC) or f.args != (symbol,) for f in functions):
        return None
    if all(isinstance(function, sp.tan) for function in functions):
        return (sp.tan(symbol),)
    if any(isinstance(function, sp.tan) for function in functions):
        return None
    return sp.sin(symbol), sp.cos(symbol)


Polynomials = tuple[sp.Poly, sp.Poly]


@remembered(1024)
def _without_common(
    sides: tuple[sp.Expr, ...], generators: tuple[sp.Expr, ...], ratios: bool
) -> Polynomials | None:
    """Both sides as polynomials without denominators, and without letters common to all terms.

    With ``ratios`` sines and cosines of other angles that are common to all terms are gone too.
    """
    whole = [sp.fraction(one_fraction(side)) for side in sides]
    below = sp.lcm(*(value[1] for value in whole))
    if any(isinstance(x, sp.Float) for side in sides for x in side.atoms(sp.Float)):
        return None
    above = [expanded(cancelled(n * below / d)) for n, d in whole]
    if not all(value.is_polynomial(*generators) for value in above):
        return None  # with roots of numbers a common denominator may not be seen
    polynomials = _without_the_same([sp.Poly(value, *generators) for value in above])
    coefficients = [c for polynomial in polynomials for c in polynomial.coeffs() if c != 0]
    if not coefficients or any(
        {*generators, *(g for value in generators for g in value.free_symbols)} & c.free_symbols
        for c in coefficients
    ):
        return None
    common = _common(coefficients, ratios)
    for one, other in permutations(polynomials):
        if other.is_ground and _is_difference(one):
            # 1 - e^2 = 4/5, and not 5 - 5e^2 = 4
            common = _common(one.coeffs(), ratios)
    left, right = (
        sp.Poly.from_dict(
            {m: expanded(cancelled(c / common)) for m, c in polynomial.terms()}
            or {(0,) * len(generators): 0},
            *generators,
        )
        for polynomial in polynomials
    )
    return left, right


def _without_the_same(sides: list[sp.Poly]) -> list[sp.Poly]:
    """Both sides without the terms that stand on both."""
    one, other = (dict(side.terms()) for side in sides)
    for m in one.keys() & other.keys():
        same = set(sp.Add.make_args(one[m])) & set(sp.Add.make_args(other[m]))
        one[m], other[m] = (
            expanded(coefficients[m] - sp.Add(*same)) for coefficients in (one, other)
        )
    gens = sides[0].gens
    of_an_angle = len(gens) > 1 and not any(value.is_Symbol for value in gens)
    for m in one.keys() & other.keys() if of_an_angle else ():
        # Of sines and cosines like terms stand on one side: 2e cos²α, and not e cos²α on both.
        share = cancelled(other[m] / one[m]) if one[m] != 0 else sp.S.One
        if any(m) and share.is_Rational and share != 1:
            near, far = (one, other) if share < 1 else (other, one)
            near[m], far[m] = expanded(near[m] - far[m]), sp.S.Zero
    return [sp.Poly.from_dict(coefficients, *gens) for coefficients in (one, other)]


def _is_difference(polynomial: sp.Poly) -> bool:
    """Whether a polynomial is the difference of two squares, or their sum, times something."""
    (one, *others) = polynomial.coeffs()
    return (
        polynomial.total_degree() > 1
        and len(others) == 1
        and bool(expanded(one**2 - others[0] ** 2) == 0)
    )


def _common(coefficients: Sequence[sp.Expr], ratios: bool) -> sp.Expr:
    """What divides all of some coefficients: positive letters, a root, and fractions of one."""
    common = sp.Integer(1)
    terms = [
        term for coefficient in coefficients for term in sp.Add.make_args(expanded(coefficient))
    ]
    powers = [term.as_powers_dict() for term in terms]
    for base in powers[0]:
        if (base.is_Symbol and base.is_positive) or (ratios and base.func in _TRIGONOMETRIC):
            common *= base ** min(power.get(base, 0) for power in powers)
    root = sp.sqrt(1)
    first = [p for p in sp.Mul.make_args(terms[0]) if p.is_Pow and p.exp == sp.S.Half]
    for value in first:
        if value.base.is_Integer and all(value in sp.Mul.make_args(x) for x in terms):
            root *= value
    numbers = [sp.Mul(*(x for x in sp.Mul.make_args(t) if x.is_Rational)) for t in terms]
    lowest = sp.ilcm(1, *(x.q for x in numbers))
    greatest = sp.igcd(0, *(int(x * lowest) for x in numbers))
    return common * root * sp.Rational(int(greatest), int(lowest))


def _is_of_tangents(link: Link, name: str) -> bool:
    """Whether a line has an angle in tangents alone."""
    kinds = {
        node.function
        for side in (link.left, link.right)
        for node in walk(side)
        if isinstance(node, Apply) and node.argument == Letter(name)
    }
    return kinds == {"tan"}


def _in_tangents(polynomials: Polynomials, angle: sp.Symbol) -> Polynomials | None:
    """Forms of one degree in sine and cosine, divided by the power of the cosine.

    None where they are of several degrees.
    """
    gens = polynomials[0].gens
    sine, cosine = gens.index(sp.sin(angle)), gens.index(sp.cos(angle))
    degrees = {
        m[sine] + m[cosine] for polynomial in polynomials for m, c in polynomial.terms() if c != 0
    }
    if len(degrees) != 1:
        return None
    kept = [sp.tan(angle) if n == sine else g for n, g in enumerate(gens) if n != cosine]
    left, right = (
        sp.Poly.from_dict({m[:cosine] + m[cosine + 1 :]: c for m, c in polynomial.terms()}, *kept)
        for polynomial in polynomials
    )
    return left, right


def _has_common(
    sides: Sequence[sp.Expr], polynomials: Polynomials, tangents: Iterable[sp.Expr]
) -> int:
    """1 where a letter was common to all terms, and is gone."""
    before = {x for side in sides for x in symbols_in(side)}
    after = {x for polynomial in polynomials for x in polynomial.free_symbols_in_domain}
    after |= {x for polynomial in polynomials for g in polynomial.gens for x in symbols_in(g)}
    after |= set(tangents)
    return int(bool(before - after))


def _sides(
    scene: Scene, polynomials: Polynomials, generators: tuple[sp.Expr, ...]
) -> tuple[Expression, Expression]:
    """The sides as trees; of a sum that is zero, what is negative stands on the other side."""
    left, right = ([(m, c) for m, c in polynomial.terms() if c != 0] for polynomial in polynomials)
    alone = [scene.model.sign(side[0][1]) for side in (left, right) if len(side) == 1]
    model = scene.first
    worth = sp.sympify(polynomials[0].as_expr(), strict=True).xreplace(dict(model.final))
    if sum(alone) < 0 or (not alone and model.sign(model.in_data(worth)) < 0):
        # A side that is less than nothing: 2 − 2e = 1, and not 2e − 2 = −1.
        left, right = ([(m, -c) for m, c in side] for side in (left, right))
    linear = len(generators) == 1 and polynomials[0].degree() == 1
    if not right and (len(generators) > 1 or linear):
        signed = [(m, c, scene.model.sign(c)) for m, c in left]
        left = [(m, c) for m, c, sign in signed if sign > 0]
        right = [(m, -c) for m, c, sign in signed if sign < 0]
    if not right and len(generators) == 1 and len(left) == 3:
        # a x² + b x + c = 0
        minus = scene.model.sign(left[0][1]) < 0
        return _descending([(m, -c if minus else c) for m, c in left], generators), number(0)
    falling = len(generators) == 1 and max((m[0] for m, _ in (*left, *right)), default=0) > 1
    highest = [max(side)[1] for side in (left, right) if side]
    falling = falling and all(scene.model.sign(value) > 0 for value in highest)
    falling = falling and not _is_a_coefficient(scene, generators[0])
    return _tree(left, generators, falling), _tree(right, generators, falling)


def _is_a_coefficient(scene: Scene, generator: sp.Expr) -> bool:
    """Whether a letter is a coefficient of restitution, of which powers rise everywhere."""
    role = scene.model.unknowns.roles.get(getattr(generator, "name", ""))
    return role is not None and role.kind == "restitution"


Term = tuple[tuple[int, ...], sp.Expr]
"""Powers of the generators, with their coefficient."""


def _tree(
    terms: Sequence[Term], generators: tuple[sp.Expr, ...], falling: bool = False
) -> Expression:
    """A polynomial: from its highest power in letters of angles, from its lowest in others.

    One letter of an equation with its square is from its highest power (``falling``).
    """
    if len(generators) == 1:
        terms = sorted(terms, key=lambda term: term[0])
    own = [_term(term, generators) for term in terms]
    if falling:
        return _total(reversed(own))
    first = next((n for n, tree in enumerate(own) if not isinstance(tree, Negate)), 0)
    if own:
        own.insert(0, own.pop(first))
    return _total(own)


def _descending(terms: Sequence[Term], generators: tuple[sp.Expr, ...]) -> Expression:
    return _total(_term(term, generators) for term in terms)


def _term(term: Term, generators: tuple[sp.Expr, ...]) -> Expression:
    """A coefficient with its powers; a letter stands before the ratios of another angle."""
    powers, coefficient = term
    if coefficient.has(*_TRIGONOMETRIC) and all(generator.is_Symbol for generator in generators):
        whole = coefficient * sp.Mul(*(g**n for g, n in zip(generators, powers, strict=True)))
        return tree_of(tidy(whole))
    sum_of_roots = coefficient.is_number and coefficient.is_Add
    tree = tree_of(coefficient, as_it_is=True) if sum_of_roots else tree_of(tidy(coefficient))
    return product(tree, *(_power(g, n) for g, n in zip(generators, powers, strict=True) if n))


def _total(terms: Iterable[Expression]) -> Expression:
    whole: Expression = number(0)
    for term in terms:
        whole = term if is_zero(whole) else _added(whole, term)
    return whole


def _added(left: Expression, right: Expression) -> Expression:
    if isinstance(right, Negate):
        return difference(left, right.operand)
    return Binary("+", left, right)


def _power(generator: sp.Expr, exponent: int) -> Expression:
    tree: Expression = tree_of(generator)
    return tree if exponent == 1 else Binary("^", tree, number(exponent))


# --- how far it is to the unknown ---------------------------------------------------------------


def _steps(link: Link, name: str) -> int:
    """How many steps lead to the unknown, beside the last: brackets, terms, what stands below."""
    terms = [term for side in (link.left, link.right) for term in _terms(side)]
    own = [term for term in terms if _has(term, name)]
    several = len(own) > 1
    return (
        min(2, sum(_brackets(term, name) for term in terms))
        + several
        + (several and any(_is_over_letters(term) for term in own))
        + any(_stands_below(term, name) for term in terms)
        + _is_of_several_quotients(terms, name)
    )


def _is_over_letters(term: Expression) -> bool:
    """Whether a term is a quotient with letters below: it is multiplied by these first."""
    return is_binary(term, "/") and bool(letters(term.right))


def _is_of_several_quotients(terms: Sequence[Expression], name: str) -> bool:
    """Whether terms without the unknown are quotients over different letters, one of a sum."""
    quotients = [
        term
        for term in terms
        if is_binary(term, "/") and letters(term.right)
        if not _has(term, name)
    ]
    sums = (node for quotient in quotients for node in walk(quotient.left))
    several = len({write_expression(quotient.right) for quotient in quotients}) > 1
    return several and any(is_binary(tree, "+", "-") for tree in sums)


def _terms(tree: Expression) -> Iterator[Expression]:
    return (term for term in unsigned_terms(tree) if not is_zero(term))


def _has(tree: Expression, name: str) -> bool:
    return any(isinstance(node, Letter) and node.name == name for node in walk(tree))


def _brackets(term: Expression, name: str) -> int:
    """The sums in a product or a power that hold the unknown, or roots of numbers and letters."""
    return sum(
        is_binary(node, "+", "-")
        and (_has(node, name) or (_has(term, name) and _is_no_number(node)))
        for node in walk(term)
    )


def _is_no_number(tree: Expression) -> bool:
    """Whether a sum is more than a number of times the same letter."""
    names = {node.name for node in walk(tree) if isinstance(node, Letter)}
    return len(names) > 1 or any(isinstance(node, Apply) for node in walk(tree))


def _stands_below(term: Expression, name: str) -> bool:
    return any(is_binary(node, "/") and _has(node.right, name) for node in walk(term))


__all__ = ["multiplied_out"]
