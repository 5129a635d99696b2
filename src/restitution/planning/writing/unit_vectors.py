"""Directions as vectors: of whole numbers over a length, in the shortest form, as trees."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import atoms_in
from restitution.expression.tree import Binary, Expression
from restitution.planning.writing.forms import tree_of, vector
from restitution.planning.writing.polynomials import cancelled, expanded
from restitution.vector import Vector


def whole_direction(direction: Vector) -> tuple[Vector, sp.Expr]:
    """A unit vector as a vector of whole numbers, where there is one, and its length."""
    x, y = direction
    if x == 0 or y == 0 or not sp.sympify(y / x, strict=True).is_Rational:
        return direction, sp.Integer(1)
    ratio = sp.Rational(y / x)
    size = sp.sqrt(ratio.p**2 + ratio.q**2)
    sign = 1 if x.is_positive else -1
    return Vector(sign * sp.Integer(ratio.q), sign * sp.Integer(ratio.p)), size


def plain_direction(direction: Vector) -> Vector:
    """The shortest vector in a direction: of whole numbers, or with one root, if there is one."""
    x, y = (tidy(expanded(component)) for component in direction)
    if y != 0 and sp.sympify(x / y, strict=True).is_Rational:
        ratio = sp.Rational(x / y)
        sign = -1 if y.is_negative else 1
        return Vector(sp.Integer(sign * ratio.p), sp.Integer(sign * ratio.q))
    if y != 0 and (surd := sp.sympify(tidy(x / y), strict=True)).is_number:
        part, root = surd.as_coeff_Mul()
        if root.is_Pow and root.exp == sp.Rational(1, 2) and root.base.is_Integer:
            return _with_a_root(part, root, -1 if y.is_negative else 1)
    if x != 0 and y != 0 and (x.free_symbols | y.free_symbols or has_nested_roots(x, y)):
        by_one_root = _by_one_root(x, y)
        if by_one_root is not None:
            return by_one_root
    if (at_degrees := _at_degrees(x, y)) is not None:
        return at_degrees
    common = _content((x, y))
    return Vector(tidy(x / common), tidy(y / common))


def _at_degrees(x: sp.Expr, y: sp.Expr) -> Vector | None:
    """The cosine and the sine of an angle in degrees, of which a vector has the tangent."""
    if 0 in (x, y) or not (x.is_number and y.is_number and y.has(sp.sin)):
        return None
    factor, quotient = sp.sympify(tidy(y / x), strict=True).as_coeff_Mul()
    above, below = sp.fraction(quotient)
    if abs(factor) != 1 or not (above.func is sp.sin and below == sp.cos(*above.args)):
        return None
    across = 1 if sp.N(x) > 0 else -1
    return Vector(across * below, factor * across * above)


def short_direction(vector: Vector, sign: Callable[[sp.Expr], int]) -> Vector | None:
    """The shortest vector of numbers in the direction of one, in its sense; None of one in letters.

    ``sign`` tells whether a part is positive (1) or negative (-1).
    """
    x, y = vector
    if 0 in vector:
        return (
            Vector(*(sp.Integer(sign(component)) for component in vector)) if any(vector) else None
        )
    ratio = sp.sympify(tidy(y / x), strict=True)
    if not ratio.is_number:
        return None
    short = plain_direction(Vector(sp.Integer(1), ratio))
    short = short if sign(x) == sign(short.x) else -short
    if ratio.is_Rational:
        return short
    # The same without its common number: (6 − √14)i + (6 + √14)j, and not 11i + (25 + 6√14)j.
    parts = [tidy(expanded(part)) for part in vector]
    common = _content(parts)
    return min(short, Vector(*(tidy(part / common) for part in parts)), key=_length_of_numbers)


def _length_of_numbers(direction: Vector) -> sp.Expr:
    """How large the numbers are in the terms of a vector."""
    terms = [t for part in direction for t in sp.Add.make_args(expanded(part))]
    return sp.Add(*(max(sp.fraction(abs(t.as_coeff_Mul()[0]))) for t in terms))


def has_nested_roots(*parts: sp.Expr) -> bool:
    """Whether there are roots below a root."""
    return any(
        inner.exp.q == 2
        for part in parts
        for power in part.atoms(sp.Pow)
        if power.exp.is_Rational and power.exp.q == 2
        for inner in power.base.atoms(sp.Pow)
        if inner.exp.is_Rational
    )


def _by_one_root(x: sp.Expr, y: sp.Expr) -> Vector | None:
    """A vector of whole numbers and one root: (2√2 − 1)i + j; None where that takes more."""
    nested = {
        power.base: sp.Dummy("root", positive=True)
        for part in (x, y)
        for power in part.atoms(sp.Pow)
        if power.base.is_Add and power.base.is_number and abs(power.exp) == sp.S.Half
    }
    if len(nested) > 1 or not all(part.is_extended_real for part in (x, y)):
        return None
    for base, root in nested.items():
        x, y = (
            part.replace(
                lambda own, base=base: own.is_Pow and own.base == base,
                lambda own, root=root: root ** (2 * own.exp),
            )
            for part in (x, y)
        )
    ratio = cancelled(x / y)
    for base, root in nested.items():
        ratio = ratio.subs(root, sp.sqrt(base))
    side = y.subs(dict.fromkeys(nested.values(), 1))
    if not (side.is_positive or side.is_negative):
        return None
    sign = 1 if side.is_positive else -1
    forms = []
    for turned in (False, True):
        surd = sp.radsimp(1 / ratio if turned else ratio)
        terms = sp.Add.make_args(expanded(surd))
        roots = {term.as_coeff_Mul()[1] for term in terms} - {sp.S.One}
        if len(terms) != 2 or len(roots) != 1 or not all(_is_plain_root(e) for e in roots):
            return None
        below = sp.ilcm(*(term.as_coeff_Mul()[0].q for term in terms))
        above = expanded(surd * below)
        size = below + sum(abs(term.as_coeff_Mul()[0]) for term in sp.Add.make_args(above))
        forms.append((size, turned, above, below))
    _, turned, above, below = min(forms, key=lambda form: form[0])
    whole = Vector(sp.Integer(below), above) if turned else Vector(above, sp.Integer(below))
    return whole if (float(whole.y) > 0) == (sign > 0) else -whole


def _is_plain_root(x: sp.Expr) -> bool:
    return bool(x.is_Pow and x.exp == sp.S.Half and x.base.is_Integer)


def _with_a_root(part: sp.Rational, root: sp.Expr, sign: int) -> Vector:
    """A vector with the ratio of a rational number times a root, in its shorter form."""
    p, q = sp.Integer(part.p), sp.Integer(part.q)
    common = sp.gcd(p * root.base, q)
    forms = [(p * root, q), (p * root.base / common, q * root / common)]
    x, y = min(forms, key=lambda form: float(abs(form[0]) + abs(form[1])))
    return Vector(sign * x, sign * y)


def _content(parts: Iterable[sp.Expr]) -> sp.Expr:
    """The rational number that all terms of some numbers are multiples of."""
    terms = [t for part in parts for t in sp.Add.make_args(expanded(part)) if t != 0]
    factors = [abs(term.as_coeff_Mul()[0]) for term in terms]
    return sp.gcd_list(factors) if factors else sp.Integer(1)


def unit_tree(direction: Vector) -> Expression:
    """A unit vector as a whole number of **i** and **j** over its length, or in letters over it."""
    whole, length = over_its_root(direction) or whole_direction(direction)
    tree = vector(*map(tree_of, whole))
    return tree if length == 1 else Binary("/", tree, tree_of(length))


def over_its_root(direction: Vector) -> tuple[Vector, sp.Expr] | None:
    """A vector and the root of letters that both its parts have below; None without such a one."""
    roots = [
        {
            power
            for power in atoms_in(part, sp.Pow)
            if power.exp == -sp.S.Half and power.free_symbols
        }
        for part in direction
    ]
    if len(roots[0]) != 1 or roots[0] != roots[1]:
        return None
    (root,) = roots[0]
    whole = Vector(*(part / root for part in direction))
    return None if any(atoms_in(part, sp.Pow) & roots[0] for part in whole) else (whole, 1 / root)
