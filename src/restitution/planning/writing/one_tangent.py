"""A quotient of tangents of multiples of one angle, by the tangent of the smallest alone.

``tan ⅓α/tan α`` is ``(1 − 3t²)/(3 − t²)`` with t = tan ⅓α: only so are its bounds seen.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Binary, letters
from restitution.planning.writing.desk import chain
from restitution.planning.writing.forms import swept, tangents_opened, tree_of
from restitution.planning.writing.polynomials import cancelled
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene

# Multiples of an angle whose tangents people know, or may look up.
_MOST = 3


def write_in_one_tangent(scene: Scene, line: int) -> int | None:
    """The line of an equation's right side in the tangent of the smallest part of an angle.

    None of a right side in which there are not the tangents of two multiples of one angle.
    """
    link = scene.desk.last_link(line)
    own = scene.scalar(link.right)
    value = in_one_tangent(own)
    if value is None or len(_angles(own)) < 2:
        return None
    above, below = sp.fraction(value)
    if scene.model.sign(below) < 0:
        above, below = -above, -below
    relation = chain(link.left, (swept(Binary("/", tree_of(above), tree_of(below))), None))
    known = background(scene, symbol_names(value))
    return scene.judge.write((Move("identity", "double-angle"),), (line, *known), relation)


def write_by_single_tangents(scene: Scene, line: int) -> int | None:
    """A line of the tangents of θ and of 2θ in that of θ alone; None of another line."""
    link = scene.desk.last_link(line)
    left, right = tangents_opened(link.left, link.right)
    if (left, right) == (link.left, link.right):
        return None
    names = letters(link.left) | letters(link.right)
    move, relation = Move("identity", "double-angle"), chain(left, (right, None))
    refs = scene.judge.enough(move, (line,), relation, background(scene, names))
    return None if refs is None else scene.desk.write(move, refs, relation)


def in_one_tangent(value: sp.Expr) -> sp.Expr | None:
    """A function of multiples of one angle in the tangent of the smallest; None of another."""
    ratios, arguments = value.atoms(sp.sin, sp.cos, sp.tan), _angles(value)
    symbols = {symbol for argument in arguments for symbol in argument.free_symbols}
    if len(symbols) != 1:
        return None
    shares = {argument: argument / next(iter(symbols)) for argument in arguments}
    if not all(share.is_Rational and share.is_positive for share in shares.values()):
        return None
    smallest = min(arguments, key=lambda argument: shares[argument])
    times = {argument: shares[argument] / shares[smallest] for argument in arguments}
    if not all(value.is_Integer and value <= _MOST for value in times.values()):
        return None
    angle = sp.Symbol("angle")
    c, t = sp.symbols("c t", positive=True)
    put = {
        ratio: sp.expand_trig(ratio.func(times[ratio.args[0]] * angle)).subs(
            {sp.sin(angle): c * t, sp.cos(angle): c, sp.tan(angle): t}
        )
        for ratio in ratios
    }
    own = cancelled(value.xreplace(put).subs(c, 1 / sp.sqrt(1 + t**2)))
    if own.free_symbols != {t} or not own.is_rational_function(t):
        return None
    return own.xreplace({t: sp.tan(smallest)})


def _angles(value: sp.Expr) -> set[sp.Expr]:
    """The angles of which an expression has ratios."""
    return {sine.args[0] for sine in value.atoms(sp.sin, sp.cos, sp.tan)}
