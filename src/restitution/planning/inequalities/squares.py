"""Speeds compared by their squares: no root stands in a condition that is to be solved."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import in_one_ratio, tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    equality,
)
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    has_quantity,
    is_function,
    letters,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.closing.square_roots import as_square
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.forms import (
    ZERO,
    difference,
    is_rational,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.inequalities import solve_linear, without_signs
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factored,
    numerator,
    one_fraction,
    polynomial_in,
)
from restitution.solving.story.letters import roles

_SOLVING = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"), Move("compare"))


def write_speeds(worths: Worths, fact: Fact, link: Link, sign: Sign, x: sp.Expr) -> int | None:
    """A given inequality of speeds, by the squares of their components; None without a root.

    ``x sign 0`` is what it comes to. A speed that stands already is put in as it stands.
    """
    mark = worths.mark()
    lines: list[Ref] = []
    trees: list[Expression] = []
    rooted = needed = False
    for whole in (worths.opened(link.left), worths.opened(link.right)):
        factor, side = _multiple_of_speed(worths, whole)
        times = partial(product, tree_of(factor**2)) if factor != 1 else swept
        match side:
            case Quantity("speed", _, int()) if not worths.is_data(side):
                if worths.scene.desk.known(side) is not None:
                    worths.back(mark)
                    return None
                worths.determine(side)
                above = _standing_square(worths, side)
                if above is not None:
                    lines.append(above)
                    trees.append(times(worths.scene.desk.relation(above).only[-1].right))
                    rooted = needed = True
                    continue
                own = formula(worths.scene, side)
                right = swept(own.right)
                root = is_function(right, "sqrt")
                needed |= root and not _is_size_of_one(worths, right)
                subject = square(own.left) if root else own.left
                radicand = right.argument if isinstance(right, Apply) and root else right
                relation = equality(subject, radicand)
                line = worths.judge.write((own.move,), own.refs, relation, own.refs)
                if line is None:
                    worths.back(mark)
                    return None
                lines.append(line)
                trees.append(times(radicand if root else square(radicand)))
                rooted |= root
            case _ if not has_quantity(side):
                trees.append(tree_of(tidy(worths.scene.scalar(side) ** 2)))
            case _:
                worths.back(mark)
                return None
    if not rooted or not needed:
        worths.back(mark)
        return None  # of one component whose sign is certain no square is taken
    names = set().union(*(letters(tree) for tree in trees))
    known = worths.judge.known(names & set(worths.scene.model.unknowns.roles))
    first = Relation(((Link(trees[0], link.sign, trees[1]),),))
    number = worths.judge.write((Move("compare"),), [fact.id, *lines, *known], first)
    solved = None if number is None else solve_squares(worths, number, sign, x, known)
    if solved is None:
        worths.back(mark)
    return solved


def _multiple_of_speed(worths: Worths, tree: Expression) -> tuple[sp.Expr, Expression]:
    """A speed with the positive number that stands before it, 1 of anything else."""
    match tree:
        case Binary("*", before, Quantity("speed") as speed) if is_rational(before):
            return worths.value(before), speed
        case Binary("/", Quantity("speed") as speed, below) if is_rational(below):
            return 1 / worths.value(below), speed
    return sp.Integer(1), tree


def _is_size_of_one(worths: Worths, root: Expression) -> bool:
    """Whether a root is that of the square of one component whose sign is certain."""
    match root:
        case Apply("sqrt", Binary("^", base, Number())):
            return proved_sign(worths.scene.model.ground, worths.value(base)) is not None
    return False


def _standing_square(worths: Worths, speed: Quantity) -> int | None:
    """The line in force that says the square of a speed; None without one."""
    desk = worths.scene.desk
    for line in reversed(desk.lines):
        match line.relation:
            case Relation(((Link(left, "="), *_),)) if left == square(speed):
                return line.number if desk.holds(line.number) else None
    return None


def square_and_solve(
    worths: Worths, line: int, sign: Sign, x: sp.Expr, known: Sequence[Ref]
) -> int | None:
    """An inequality of two sizes with a root: both sides squared, and solved."""
    own = worths.scene.desk.last_link(line)
    values = [worths.value(side) for side in (own.left, own.right)]
    roots = [p for value in values for p in value.atoms(sp.Pow) if p.exp == sp.Rational(1, 2)]
    if not any(root.base.free_symbols for root in roots):
        return None
    mark = worths.mark()
    trees = [tree_of(tidy(value**2)) for value in values]
    squared = Relation(((Link(trees[0], own.sign, trees[1]),),))
    number = worths.judge.write((Move("compare"),), [line, *known], squared)
    solved = None if number is None else solve_squares(worths, number, sign, x, known)
    if solved is None:
        worths.back(mark)
    return solved


def both_squared(worths: Worths, line: int, sign: Sign, x: sp.Expr) -> tuple[int, Sign, sp.Expr]:
    """An inequality ``x sign 0`` with a root of letters as that of the squares of both sides.

    As it is, where that is not plain, or there is no such root.
    """
    own = worths.scene.desk.last_link(line)
    sides = [worths.value(side) for side in (own.left, own.right)]
    half = sp.Rational(1, 2)
    if not any(p.exp == half and p.base.free_symbols for v in sides for p in v.atoms(sp.Pow)):
        return line, sign, x
    left, right = (tidy(value**2) for value in sides)
    stripped = without_signs(worths.scene, expanded(left - right), own.sign)
    relation = Relation(((Link(tree_of(left), own.sign, tree_of(right)),),))
    pool = [line, *worths.known_in(x)]
    squared = worths.judge.write((Move("compare"),), pool, relation)
    return (line, sign, x) if squared is None or stripped is None else (squared, *stripped)


def without_roots(worths: Worths, line: int, sign: Sign, x: sp.Expr) -> tuple[Sign, sp.Expr]:
    """``x sign 0`` as a line has it in which the sizes are squared: no root is left."""
    if not x.has(sp.Abs):
        return sign, x
    own = worths.scene.desk.last_link(line)
    gap = expanded(worths.value(own.left) - worths.value(own.right))
    return without_signs(worths.scene, gap, own.sign) or (sign, x)


def solve_squares(
    worths: Worths, line: int, sign: Sign, x: sp.Expr, known: Sequence[Ref]
) -> int | None:
    """An inequality without roots, solved: a quadratic by its factors."""
    scene, judge = worths.scene, worths.judge
    own = scene.desk.last_link(line)
    sign, x = without_roots(worths, line, sign, x)
    solved = solve_linear(scene, sign, x)
    pool = [line, *known]
    whole = _without_denominators(worths, own)
    if whole is not None:
        left, right = whole
        steps = [Link(tree_of(left), own.sign, tree_of(right))]
        gap = worths.value(own.left) - worths.value(own.right)
        if solved is not None and scene.model.identically_zero(left - right - gap):
            steps = []  # nothing was multiplied
        if solved is not None:
            steps += _second_degree(own, left - right)
        for step in steps:
            number = judge.write(_SOLVING[:2], pool, Relation(((step,),)))
            if number is None:
                break
            pool = [number, *known]
    link = solved or _in_one_ratio(sign, x) or Link(tree_of(x), sign, ZERO)
    last = judge.write(_SOLVING, pool, Relation(((link,),)))
    if last is None or solved is not None:
        return last
    return solve_quadratic(worths, last, sign, x, known)


def in_its_square(worths: Worths, line: int, solved: Link) -> int | None:
    """``e² < ¼`` for e < ½, where an inequality has the square of its letter alone."""
    match solved:
        case Link(Letter(name) as letter, sign, bound):
            symbol = worths.scene.model.unknowns.letter(name)
        case _:
            return None
    own = worths.scene.desk.last_link(line)
    if own.left == square(letter):
        return line
    gap = numerator(worths.value(own.left) - worths.value(own.right))
    if not gap.is_polynomial(symbol) or own.left == letter:
        return None
    if {power for (power,) in polynomial_in(gap, symbol).monoms()} != {0, 2}:
        return None
    squared = Link(square(letter), sign, tree_of(tidy(worths.value(bound) ** 2)))
    pool = [line, *worths.known_in(gap)]
    return worths.judge.write(_SOLVING[:2], pool, Relation(((squared,),)))


def _in_one_ratio(sign: Sign, x: sp.Expr) -> Link | None:
    """``x sign 0`` with squares of sines by the cosine, where that stands alone too: a quadratic.

    So is one with squares of cosines by the sine. None of another one.
    """
    angles = {sine.args[0] for sine in x.atoms(sp.sin, sp.cos)}
    if len(angles) != 1 or not (x.has(sp.sin) and x.has(sp.cos)):
        return None
    (angle,) = angles
    for kept, other in ((sp.cos(angle), sp.sin(angle)), (sp.sin(angle), sp.cos(angle))):
        odd, even = sp.Dummy(), sp.Dummy()
        plain = x.xreplace({kept: odd, other: even})
        if not plain.is_polynomial(odd, even):
            return None
        powers = polynomial_in(plain, odd, even).monoms()
        if all(n in (0, 2) for _, n in powers) and any(n % 2 for n, _ in powers):
            poly = polynomial_in(in_one_ratio(plain, odd, even), odd)
            turned_ = poly.LC().could_extract_minus_sign()
            poly = -poly if turned_ else poly
            left = total(tree_of(size * kept**n) for (n,), size in poly.terms())
            return Link(swept(left), FLIPPED[sign] if turned_ else sign, ZERO)
    return None


def solve_quadratic(worths: Worths, line: int, sign: Sign, x: sp.Expr, known: Sequence[Ref]) -> int:
    """``x sign 0`` of the second degree in its one letter, solved: in factors, or as a square.

    The line itself where it is none.
    """
    if len(x.free_symbols) != 1:
        return line
    (symbol,) = x.free_symbols
    try:
        poly = polynomial_in(expanded(x), symbol)
    except sp.PolynomialError:
        return line
    if poly.degree() != 2 or poly.nth(1) == 0 or not all(c.is_Rational for c in poly.coeffs()):
        return line
    a, b, c = (poly.nth(n) for n in (2, 1, 0))
    gap = (b**2 - 4 * a * c) / (4 * a**2)
    if gap <= 0:
        return line
    own = sign if a > 0 else FLIPPED[sign]
    if len(polynomial_in(poly / sp.Integer(1), symbol).factor_list()[1]) > 1:
        link = Link(tree_of(sp.factor(poly.as_expr() / sp.sign(a)), as_it_is=True), own, ZERO)
    else:
        shift, letter = b / (2 * a), tree_of(symbol)
        inner = total((letter, tree_of(shift)))
        if shift < 0:
            inner = difference(letter, tree_of(-shift))
        link = Link(square(inner), own, tree_of(gap))
    relation, solved = Relation(((link,),)), line
    start = worths.mark()
    if worths.scene.desk.relation(line) != relation:
        solved = worths.judge.write(_SOLVING[:2], [line], relation) or 0
    if not solved:
        return line
    low, high = (tidy(-b / (2 * a) + sign * sp.sqrt(gap)) for sign in (-1, 1))
    letter = tree_of(symbol)
    inside: Sign = "<" if len(own) == 1 else "<="
    between = (Link(tree_of(low), inside, letter), Link(letter, inside, tree_of(high)))
    beyond = Link(letter, own, tree_of(high))
    for links in (between,) if own[0] == "<" else ((beyond,),):
        chosen = [links, links[1:]] if own[0] == "<" else [links]
        for chain in chosen:
            mark = worths.mark()
            after = worths.judge.write((Move("compare"),), [solved, *known], Relation((chain,)))
            if after is not None and (len(chain) == 1 or _may_be_low(worths, symbol, low)):
                return after
            worths.back(mark)
    if own[0] == ">" and link.right != ZERO:
        below = _below(worths, solved, (letter, tree_of(-b / (2 * a)), own, gap), known)
        if below is None:
            worths.back(start)  # on both sides the roots tell as much without the square
        return below or line
    return solved


def _below(
    worths: Worths,
    line: int,
    square_: tuple[Expression, Expression, Sign, sp.Expr],
    known: Sequence[Ref],
) -> int | None:
    """``1 − e > 2√6/5`` of ``(e − 1)² > 24/25``, and what e is less than by that.

    None where the letter may be beyond the greater root too.
    """
    letter, middle, sign, gap = square_
    mark = worths.mark()
    size = Link(difference(middle, letter), sign, tree_of(tidy(sp.sqrt(gap))))
    first = worths.judge.write((Move("compare"),), [line, *known], Relation(((size,),)))
    low = Link(letter, FLIPPED[sign], tree_of(tidy(worths.value(middle) - sp.sqrt(gap))))
    last = first and worths.judge.write((Move("rearrange"),), [first], Relation(((low,),)))
    if not last:
        worths.back(mark)
        return None
    return last


def solve_in_squares(
    worths: Worths, line: int, sign: Sign, x: sp.Expr, wanted: Expression, known: Sequence[Ref]
) -> int:
    """``x sign 0`` of the fourth degree in a letter, in even powers alone: by the square of it.

    The line itself where it is none, or not between two bounds.
    """
    if not isinstance(wanted, Letter) or not x.is_polynomial(*x.free_symbols):
        return line
    symbols = [symbol for symbol in x.free_symbols if symbol.name == wanted.name]
    poly = sp.Poly(x, *symbols) if symbols else None
    if poly is None or poly.degree() != 4 or poly.nth(3) != 0 or poly.nth(1) != 0:
        return line
    a, b, c = (poly.nth(n) for n in (4, 2, 0))
    lead = proved_sign(worths.scene.model.ground, a)
    own = sign if lead == 1 else FLIPPED[sign]
    root = tidy(sp.sqrt(factored(b**2 - 4 * a * c)))
    if lead is None or own[0] != "<" or root.has(sp.Abs):
        return line
    low, high = (tidy(sp.factor((-b + sign * root) / (2 * a))) for sign in (-1, 1))
    squared = square(wanted)
    standard = Link(tree_of(expanded(lead * x)), own, ZERO)
    between = (Link(tree_of(low), own, squared), Link(squared, own, tree_of(high)))
    cleared = _multiplied_by_denominators(worths, line, known) or line
    number = worths.judge.write(_SOLVING, [cleared, *known], Relation(((standard,),)))
    if number is None:
        return cleared
    last = worths.judge.write((Move("compare"),), [number, *known], Relation((between,)))
    ends = [as_square(value) for value in (low, high)]
    if last is None or None in ends:
        return number if last is None else last
    squares = Link(ends[0], own, squared), Link(squared, own, ends[1])  # type: ignore[arg-type]
    return worths.judge.write((Move("rearrange"),), [last], Relation((squares,))) or last


def _multiplied_by_denominators(worths: Worths, line: int, known: Sequence[Ref]) -> int | None:
    """An inequality of quotients without them, and not yet multiplied out."""
    own = worths.scene.desk.last_link(line)
    sides = [sp.fraction(factored(worths.value(side))) for side in (own.left, own.right)]
    (above, below), (other, under) = sides
    if not (below * under).free_symbols:
        return None
    link = Link(tree_of(above * under), own.sign, tree_of(other * below))
    return worths.judge.write(_SOLVING[:2], [line, *known], Relation(((link,),)))


def _may_be_low(worths: Worths, symbol: sp.Symbol, low: sp.Expr) -> bool:
    """Whether a letter may be as small as that."""
    role = roles(worths.scene.problem).get(symbol.name)
    return role is None or role.low is None or bool(low > role.low)


def _second_degree(own: Link, gap: sp.Expr) -> list[Link]:
    """A quadratic in one letter by its square, or in factors; nothing of what is no quadratic."""
    (symbol,) = gap.free_symbols
    poly = polynomial_in(expanded(gap), symbol)
    if poly.degree() != 2:
        return []
    sign: Sign = FLIPPED[own.sign] if poly.LC() < 0 else own.sign
    a, b, c = (poly.nth(n) for n in (2, 1, 0))
    if b == 0:
        return [Link(square(tree_of(symbol)), sign, tree_of(tidy(-c / a)))]
    parts = factored(poly.as_expr() / sp.sign(a))
    return [Link(tree_of(parts, as_it_is=True), sign, ZERO)]


def _without_denominators(worths: Worths, own: Link) -> tuple[sp.Expr, sp.Expr] | None:
    """Both sides multiplied by what stands below, and without their common factors.

    None where sines and cosines stand in them, or more than one letter is left.
    """
    sides = [one_fraction(worths.value(side)) for side in (own.left, own.right)]
    if any(side.has(sp.sin, sp.cos, sp.tan) for side in sides):
        return None
    common = sp.lcm([sp.fraction(side)[1] for side in sides])
    above = [expanded(cancelled(side * common)) for side in sides]
    shared = sp.gcd(*above)
    left, right = (expanded(cancelled(value / shared)) for value in above)
    if len(left.free_symbols | right.free_symbols) != 1:
        return None
    return left, right
