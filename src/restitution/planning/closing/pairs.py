"""Two equations with two unknowns: one unknown is left out, or expressed and put in.

The shapes are a table (``SHAPES``), tried in order: both linear; V cos θ and V sin θ; one that
gives an unknown, or the square of a ratio, by the other.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from itertools import permutations
from typing import Any

import sympy as sp

from restitution.exact import in_one_ratio, tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move, Relation, equality, numbers_in
from restitution.explaining.lines.trees import statement_of
from restitution.expression.tree import Apply, Binary, Expression, Letter, Number, is_binary
from restitution.planning.closing.collecting import multiplied_out
from restitution.planning.closing.known_values import with_known
from restitution.planning.closing.ratios import inside_functions, inverse
from restitution.planning.closing.shapes import close
from restitution.planning.formulas.impacts import residual, scene_value
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import ONE, product, square, swept, total, tree_of
from restitution.planning.writing.polynomials import (
    cancelled,
    expanded,
    factored,
    numerator,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene

Pair = tuple[int, int]
Unknowns = tuple[sp.Symbol, sp.Symbol]
_PAIR = 2


def close_two(scene: Scene, lines: Pair, unknowns: Unknowns) -> None:
    """Solves two lines for the two unknowns in them. Raises NotPlannedError for other shapes."""
    first, second = (multiplied_out(scene, with_known(scene, line), *unknowns) for line in lines)
    for x, y in permutations(unknowns):
        for shape in SHAPES:
            for a, b in ((first, second), (second, first)):
                try:
                    if shape(scene, (a, b), (x, y)):
                        return
                except (sp.PolynomialError, NotPlannedError):
                    continue
    names = ", ".join(str(unknown) for unknown in unknowns)
    raise NotPlannedError(f"no way from lines {first} and {second} to {names}")


def _above(scene: Scene, line: int) -> sp.Expr:
    return numerator(residual(scene, line))


def _background(scene: Scene, lines: Iterable[int]) -> tuple[Any, ...]:
    names = symbol_names(*(residual(scene, line) for line in lines))
    facts = (ref for ref in scene.judge.known(names) if ref in scene.facts)
    return (*background(scene, names), *facts)


def _write(scene: Scene, move: Move, lines: Sequence[int], relation: Relation) -> int | None:
    if move.id == "rearrange" and statement_of(scene.desk.relation(lines[0])) == statement_of(
        relation
    ):
        own = scene.desk.line(lines[0])
        return scene.desk.write(own.move, own.premises, relation)
    refs = scene.judge.enough(move, lines, relation, _background(scene, lines))
    return None if refs is None else scene.desk.write(move, refs, relation)


# --- linear in both -----------------------------------------------------------------------------


def _linear(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """One unknown is left out of two linear equations; then the other follows from one of them."""
    x, y = unknowns
    rows = [_above(scene, number) for number in lines]
    if any(inside_functions(row) & set(unknowns) for row in rows):
        return False
    polys = [polynomial_in(row, x, y) for row in rows]
    if any(poly.total_degree() != 1 for poly in polys):
        return False
    if any(set(poly.gens) & poly.free_symbols_in_domain for poly in polys):
        return False
    (a, b), (c, d) = ([p.coeff_monomial(g) for g in (x, y)] for p in polys)
    e, f = (p.coeff_monomial(1) for p in polys)
    if b == 0 or d == 0:
        return False
    value = tidy((b * f - d * e) / (a * d - b * c))
    relation = chain(Letter(x.name), (tree_of(value), None))
    line = _write(scene, Move("combine", eliminated=y.name), lines, relation)
    if line is None:
        return False
    scene.desk.know(Letter(x.name), value, (line,))
    close(scene, lines[0], y)
    return True


# --- a size and its direction -------------------------------------------------------------------


def _polar(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """V cos θ = A and V sin θ = B: divided for the angle, squared and added for V."""
    v, theta = unknowns
    role = scene.model.unknowns.roles.get(theta.name)
    if role is None or role.kind != "angle":
        return False
    lines = _parted(scene, lines, v, theta)
    parts = []
    for line, ratio in zip(lines, (sp.cos(theta), sp.sin(theta)), strict=True):
        poly = polynomial_in(_above(scene, line), v, ratio)
        if set(poly.monoms()) - {(1, 1), (0, 0)} or (1, 1) not in poly.monoms():
            return False
        if poly.free_symbols_in_domain & {v, theta}:
            return False
        parts.append(tidy(-poly.coeff_monomial(1) / poly.coeff_monomial(v * ratio)))
    first, second = (
        _as_product(scene, line, v, theta, kind, value)
        for line, kind, value in zip(lines, ("cos", "sin"), parts, strict=True)
    )
    if first is None or second is None or parts[0] == 0:
        return False
    for line, kind, value in zip((first, second), ("cos", "sin"), parts, strict=True):
        scene.desk.know(_product(v, theta, kind), value, (line,))
    tangent = tidy(parts[1] / parts[0])
    subject = Apply("tan", Letter(theta.name))
    quotient = chain(subject, (tree_of(tangent), None))
    divided = _write(scene, Move("divide"), (second, first), quotient)
    if divided is None:
        return False
    scene.desk.know(subject, tangent, (divided,))
    if role.low == 0 and role.high == sp.pi / 2:
        close(scene, divided, theta)
    else:
        inverse(scene, divided, theta, (first, second))
    squares = total(square(tree_of(-x if x.could_extract_minus_sign() else x)) for x in parts)
    added = chain(
        square(Letter(v.name)),
        (squares, None),
        (tree_of(tidy(parts[0] ** 2 + parts[1] ** 2)), "rearrange"),
    )
    whole = _write(scene, Move("square-add"), (first, second), added)
    if whole is None:
        return False
    close(scene, whole, v)
    return True


def _parted(scene: Scene, lines: Pair, v: sp.Symbol, theta: sp.Symbol) -> Pair:
    """Two lines in V cos θ and V sin θ, each with both, as one for each of them."""
    ratios = sp.cos(theta), sp.sin(theta)
    polys = [sp.Poly(_above(scene, line), v, *ratios) for line in lines]
    places = [(1, 1, 0), (1, 0, 1)]
    plain = all(set(poly.monoms()) <= {*places, (0, 0, 0)} for poly in polys)
    if not plain or any(poly.free_symbols_in_domain & {v, theta} for poly in polys):
        return lines
    (a, b), (c, d) = ([p.as_expr().coeff(v).coeff(r) for r in ratios] for p in polys)
    if 0 in (a, b, c, d):
        return lines
    e, f = (p.coeff_monomial(1) for p in polys)
    whole = a * d - b * c
    parts = []
    for value, name, other in (
        ((b * f - d * e) / whole, "cos", "sin"),
        ((c * e - a * f) / whole, "sin", "cos"),
    ):
        tree = _product(v, theta, name)
        move = Move("combine", eliminated=f"{other}({theta.name})")
        parts.append(_write(scene, move, lines, chain(tree, (tree_of(tidy(value)), None))))
    first, second = parts
    return lines if first is None or second is None else (first, second)


def _as_product(
    scene: Scene, line: int, v: sp.Symbol, theta: sp.Symbol, kind: str, value: sp.Expr
) -> int | None:
    """The line as ``V cos θ = A``."""
    tree = _product(v, theta, kind)
    relation = chain(tree, (tree_of(value), None))
    link = scene.desk.last_link(line)
    if tree == link.left:
        return line
    return _write(scene, Move("rearrange"), (line,), relation)


def _product(v: sp.Symbol, theta: sp.Symbol, kind: str) -> Expression:
    return product(Letter(v.name), Apply(kind, Letter(theta.name)))


def _divided(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """V sin θ = a cos θ and V cos θ = b sin θ: divided, V is left out."""
    v, theta = unknowns
    rows = [_above(scene, line) for line in lines]
    if v in set().union(*map(inside_functions, rows)):
        return False
    polys = [polynomial_in(row, v) for row in rows]
    if any(poly.degree() != 1 for poly in polys):
        return False
    (a, b), (c, d) = ((poly.nth(1), -poly.nth(0)) for poly in polys)
    t = sp.Dummy()
    left, right = (
        tidy((x / y).subs(sp.sin(theta), t * sp.cos(theta))) if y != 0 else sp.Integer(0)
        for x, y in ((a, c), (b, d))
    )
    # Each side is a number, or that times the tangent, or over it.
    share = tidy(left / t)
    if theta in left.free_symbols | right.free_symbols or not share.is_number or right == 0:
        return False
    if t in tidy(right * t).free_symbols and t in right.free_symbols:
        return False
    subject = Apply("tan", Letter(theta.name))
    value = tidy(right / share).subs(t, sp.tan(theta))
    divided = _write(scene, Move("divide"), lines, chain(subject, (tree_of(value), None)))
    if divided is None:
        return False
    close(scene, divided, theta)
    close(scene, lines[0], v)
    return True


# --- one expressed by the other -----------------------------------------------------------------


def _expressed(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """An unknown that stands linearly in one equation is put into the other."""
    x, _ = unknowns
    own = _above(scene, lines[0])
    if x in inside_functions(own) or x not in own.free_symbols:
        return False
    poly = polynomial_in(own, x)
    if poly.degree() != 1 or x in inside_functions(_with_roots_undone(_above(scene, lines[1]))):
        return False
    value = tidy(-poly.nth(0) / poly.nth(1))
    return _put_in(scene, lines, unknowns, Letter(x.name), value, Move("rearrange"))


def _with_roots_undone(x: sp.Expr) -> sp.Expr:
    """An expression in which no square root of a polynomial is a function of the letters there."""
    roots = [p for p in x.atoms(sp.Pow) if p.exp == sp.S.Half and p.base.is_polynomial()]
    return x.xreplace({root: root.base for root in roots})


def _square_of_unknown(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """An unknown of which only the square stands in both: that is put into the other."""
    x, _ = unknowns
    own, other = (_above(scene, line) for line in lines)
    if x in inside_functions(own) | inside_functions(other) or x not in own.free_symbols:
        return False
    poly = polynomial_in(own, x)
    if set(poly.monoms()) != {(2,), (0,)} or any(
        n % 2 for (n,) in polynomial_in(other, x).monoms()
    ):
        return False
    value = tidy(-poly.nth(0) / poly.nth(2))
    return _put_in(scene, lines, unknowns, square(Letter(x.name)), value, Move("rearrange"))


def _ratio_expressed(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """A sine, cosine or tangent that stands alone and linearly in one equation."""
    x, _ = unknowns
    own, other = (_above(scene, line) for line in lines)
    functions = {atom for atom in own.atoms(sp.sin, sp.cos, sp.tan) if atom.args == (x,)}
    if len(functions) != 1:
        return False
    (ratio,) = functions
    poly = polynomial_in(own, ratio)
    if poly.degree() != 1 or x in inside_functions(other.subs(ratio, sp.Dummy())):
        return False
    value = tidy(-poly.nth(0) / poly.nth(1))
    subject = Apply(type(ratio).__name__, Letter(x.name))
    return _put_in(scene, lines, unknowns, subject, value, Move("rearrange"))


def _ratio_with_squares(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """A sine or cosine that one equation ties to the other angle; the other has it in squares too.

    With cos α = 2 cos β the sines go by sin² + cos² = 1, in one line for both angles.
    """
    x, y = unknowns
    own, other = (_above(scene, line) for line in lines)
    tied = [atom for atom in own.atoms(sp.sin, sp.cos) if atom.args in ((x,), (y,))]
    if len(tied) != _PAIR or {atom.args[0] for atom in tied} != {x, y}:
        return False
    whole = other
    for ratio in tied:
        rest = (sp.cos if isinstance(ratio, sp.sin) else sp.sin)(*ratio.args)
        if not whole.is_polynomial(ratio, rest):
            return False
        if any(n % 2 for (n,) in polynomial_in(whole, rest).monoms()):
            return False
        whole = expanded(in_one_ratio(whole, ratio, rest))
    if whole == other or inside_functions(sp.Poly(whole, *tied).as_expr().subs(_dummies(tied))):
        return False
    constant = sp.Poly(whole, *tied).coeff_monomial(1)
    sign = -1 if scene.model.sign(constant) > 0 else 1
    relation = chain(tree_of(sign * (whole - constant)), (tree_of(-sign * constant), None))
    alone = _write(scene, Move("identity", "pythagoras"), lines[1:], relation)
    return alone is not None and _ratio_expressed(scene, (lines[0], alone), unknowns)


def _dummies(ratios: Sequence[sp.Expr]) -> dict[sp.Expr, sp.Symbol]:
    return {ratio: sp.Dummy() for ratio in ratios}


def _square_expressed(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """A square of sine or cosine, by sin² + cos² = 1 from one equation, put into the other."""
    x, _ = unknowns
    s, c = sp.sin(x), sp.cos(x)
    own, other = (polynomial_in(_above(scene, line), s, c) for line in lines)
    if set(own.monoms()) - {(2, 0), (0, 2), (0, 0)}:
        return False
    if any(x in poly.free_symbols_in_domain for poly in (own, other)):
        return False
    a, b, k = (own.coeff_monomial(monomial) for monomial in (s**2, c**2, 1))
    if a - b == 0:
        return False
    sine = tidy(-(b + k) / (a - b))
    for ratio, value, place in ((s, sine, 1), (c, tidy(1 - sine), 0)):
        if any(m[place] or m[1 - place] % 2 for m in other.monoms()):
            continue
        subject = square(Apply(type(ratio).__name__, Letter(x.name)))
        move = Move("identity", "pythagoras")
        whole = _as_multiple(scene, lines[1], other, 1 - place, subject)
        # Of squares alone the equation itself gives the tangent.
        last = lines[0] if k == 0 else None
        if _put_in(scene, (lines[0], whole), unknowns, subject, value, move, last):
            return True
    return False


def _square_by_a_tangent(scene: Scene, lines: Pair, unknowns: Unknowns) -> bool:
    """A square of sine or cosine, where one equation is of squares alone: cos²α = e sin²α."""
    for angle, other in (unknowns, unknowns[::-1]):
        own = polynomial_in(_above(scene, lines[0]), sp.sin(angle), sp.cos(angle))
        if set(own.monoms()) == {(2, 0), (0, 2)}:
            return _square_expressed(scene, lines, (angle, other))
    return False


def _as_multiple(scene: Scene, line: int, own: sp.Poly, place: int, subject: Expression) -> int:
    """An equation of one square of a ratio as a multiple of that, in factors; else as it stands.

    It is written from the line that was multiplied out, where that was done.
    """
    above = own.coeff_monomial(own.gens[place] ** 2)
    rest = own.coeff_monomial(1)
    factor = sp.factor(above)
    if len(own.monoms()) != 2 or rest == 0 or not factor.is_Mul or not above.is_Add:
        return line
    size = sp.factor_list(above)[0]
    size = -size if scene.model.sign(-rest / size) < 0 else size
    multiple = expanded(above / size)
    tree = product(tree_of(multiple), subject)
    relation = chain(tree, (tree_of(tidy(-rest / size)), None))
    source = scene.desk.line(line)
    first = numbers_in(source.premises)
    start = first[0] if source.move.id in ("rearrange", "cancel") and len(first) == 1 else line
    for number in (start, line):
        for move in (Move("rearrange"), Move("cancel")):
            written = _write(scene, move, (number,), relation)
            if written is not None:
                return written
    return line


def _put_in(
    scene: Scene,
    lines: Pair,
    unknowns: Unknowns,
    subject: Expression,
    value: sp.Expr,
    move: Move,
    last: int | None = None,
) -> bool:
    """A line for the first unknown, put into the other line, which is solved for the second.

    The first is then found from that line, or from the line ``last``.
    """
    x, y = unknowns
    expressed = _write(scene, move, lines[:1], chain(subject, (tree_of(value), None)))
    if expressed is None:
        return False
    link = scene.desk.last_link(lines[1])
    left, right = (swept(_with(side, subject, tree_of(value))) for side in (link.left, link.right))
    relation = equality(left, right)
    put = _write(scene, Move("put"), (lines[1], expressed), relation)
    if put is None:
        return False
    close(scene, _reduced(scene, put), y)
    close(scene, expressed if last is None else last, x)
    return True


def _reduced(scene: Scene, line: int) -> int:
    """An equation without a factor that stands above and below a line on one side of it."""
    link = scene.desk.last_link(line)
    sides = [sp.sympify(scene_value(scene, side), strict=True) for side in (link.left, link.right)]
    if not all(side.is_rational_function() for side in sides):
        return line
    plain = [factored(cancelled(side)) for side in sides]
    if not any(_degree_below(a) > _degree_below(b) for a, b in zip(sides, plain, strict=True)):
        return line
    relation = equality(tree_of(tidy(plain[0])), tree_of(tidy(plain[1])))
    for move in (Move("rearrange"), Move("cancel")):
        written = _write(scene, move, (line,), relation)
        if written is not None:
            return written
    return line


def _degree_below(value: sp.Expr) -> int:
    """The degree of what stands below the line of a quotient in letters."""
    below = sp.fraction(one_fraction(value))[1]
    return 0 if below.is_number else int(sp.Poly(below, *below.free_symbols).total_degree())


def _with(tree: Expression, subject: Expression, value: Expression) -> Expression:
    """A tree in which a value stands for a subject, also for the square of a product of it.

    With a² its fourth power goes too, as the square of that.
    """
    from restitution.explaining.lines.trees import rebuilt

    base = subject.left if is_binary(subject, "^") else None

    def change(tree: Expression) -> Expression:
        if tree == subject:
            return value
        match tree:
            case Binary("*", left, Binary("/", above, below)) if above == ONE:
                return Binary("/", left, below)
            case Binary("^", own, Number(power)) if own == base and power % _PAIR == 0:
                return Binary("^", value, Number(power / _PAIR))
            case Binary("^", inside, _) if base is not None:
                rest = _without(inside, base)
                if rest is not None:
                    return product(square(rest), value)
        return tree

    return rebuilt(tree, change)


def _without(tree: Expression, factor: Expression) -> Expression | None:
    match tree:
        case Binary("*", left, right):
            if right == factor:
                return left
            if left == factor:
                return right
            rest = _without(left, factor)
            return None if rest is None else product(rest, right)
    return None


SHAPES: tuple[Callable[[Scene, Pair, Unknowns], bool], ...] = (
    _linear,
    _polar,
    _divided,
    _square_by_a_tangent,
    _expressed,
    _square_of_unknown,
    _ratio_expressed,
    _ratio_with_squares,
    _square_expressed,
)
"""What two equations may look like, in the order in which the shapes are tried."""
