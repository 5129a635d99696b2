"""Formulas of the second degree in the sine and the cosine of an angle with a known tangent.

Where sine and cosine are roots and their squares are not, the squares are put in: the speed that
comes of ``u cos α`` and ``½u sin α`` needs no component with a root in it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.data.facts import staged
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    is_binary,
    is_function,
    quantities_in,
    walk,
)
from restitution.planning.formulas.definitions import Formula
from restitution.planning.writing.angle_ratios import range_of, square_of_cosine
from restitution.planning.writing.between import root_of_a_square
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import square, swept, tree_of
from restitution.planning.writing.polynomials import expanded, one_fraction
from restitution.planning.writing.premises import background, not_negative
from restitution.planning.writing.scene import Scene
from restitution.problem import Find, Problem, Show, once_a_problem, trees_of_step

# The quantities that are sums of squares of components.
KINDS = ("speed", "energy", "energy_lost")


def write_by_squares(
    scene: Scene,
    asked: Expression,
    formula: Callable[[Scene, Any], Formula | None],
    printed: Expression | None = None,
) -> int | None:
    """The line of a quantity by squares of ratios of an angle; None where that gains nothing.

    What is asked may be the square of a speed, or a fraction of energies; ``printed`` is the form
    that a claim has for it.
    """
    kinds = {node.kind for node in quantities_in(asked)}
    if not kinds <= {*KINDS} or scene.desk.known(asked) is not None:
        return None
    if not _is_last(scene):
        return None
    for symbol in angles_by_squares(scene):
        mark = scene.desk.mark()
        line = _write(scene, asked, symbol, formula, printed)
        if line is not None:
            return line
        scene.desk.back(mark)
    return None


def kept_for(scene: Scene, asked: Expression) -> Iterator[sp.Symbol]:
    """The angles whose squared ratios serve what is asked, so that no ratio is put in."""
    kinds = {node.kind for node in quantities_in(asked)}
    if kinds and kinds <= {*KINDS} and _is_last(scene):
        yield from angles_by_squares(scene)


def angles_that_cancel(scene: Scene, asked: Expression) -> Iterator[sp.Symbol]:
    """The angles of which a ratio is given, and that may cancel where a letter is worked out."""
    if not isinstance(asked, Letter) or scene.others or asked.name in scene.ratio_facts:
        return
    symbol = scene.model.unknowns.letter(asked.name)
    if symbol in scene.unknown(symbol):
        yield from map(scene.model.unknowns.letter, sorted(scene.ratio_facts))


def is_without(scene: Scene, letter: Letter, symbol: sp.Symbol) -> bool:
    """Whether what a letter is known to be has no angle in it."""
    known = scene.desk.known(letter)
    return known is not None and symbol not in sp.sympify(known.value, strict=True).free_symbols


@contextmanager
def keeping(scene: Scene, symbol: sp.Symbol) -> Iterator[None]:
    """For a while no ratio of an angle is put in."""
    scene.kept = frozenset((symbol,))
    try:
        yield
    finally:
        scene.kept = frozenset()


def _write(
    scene: Scene,
    asked: Expression,
    symbol: sp.Symbol,
    formula: Callable[[Scene, Any], Formula | None],
    printed: Expression | None,
) -> int | None:
    """The line in which the squares of one angle are put in; None where something is left of it."""
    try:
        with keeping(scene, symbol):
            own = formula(scene, asked)
    except NotPlannedError:
        return None
    right = None if own is None else swept(own.right)
    if own is None or right is None or own.left != asked:
        return None
    if symbol not in scene.scalar(right).free_symbols:
        return None
    put = squares_put(scene, right, symbol)
    if put is None:
        return None
    value = tidy(scene.scalar(put))
    lines = squares_lines(scene, symbol)
    first = chain(own.left, (right, None))
    end = printed or tree_of(value)
    squares = root_of_a_square(scene, end) if _is_root_of_roots(scene, put) else ()
    last = chain(own.left, (put, None), *((tree, "rearrange") for tree in (*squares, end)))
    names = symbol_names(value)
    known = together(not_negative(scene, value), background(scene, names))
    premises = scene.judge.enough(own.move, own.refs, first, known)
    if premises is None:
        return None
    # Of several solutions, all have it, above the lines in which they part.
    number = scene.desk.write(own.move, premises, first, shown="line" if scene.others else "inline")
    # A loss of energy may have the square of one of both alone.
    refs = scene.judge.needed(Move("put"), (number, *lines, *known), last, (number,))
    if refs is None:
        return None
    number = scene.desk.write(Move("put"), refs, last)
    scene.desk.know(asked, value, (number,))
    return number


def _is_last(scene: Scene) -> bool:
    """Whether nothing that is asked needs a component itself: no vector, and no other body."""
    asked = {tree for tree in _asked(scene.problem) if not _is_square(scene, tree)}
    speeds = {quantity for quantity in asked if quantity.kind == "speed" and quantity.stage}
    return (
        all(quantity.kind in KINDS for quantity in asked)
        and len(speeds) <= 1
        and all(speed.stage == scene.events for speed in speeds)
    )


@once_a_problem
def _asked(problem: Problem) -> frozenset[Quantity]:
    """The quantities in what all parts ask."""
    return frozenset(
        node
        for part in problem.parts
        for item, now in problem.asked(part)
        for tree in trees_of_step(item if isinstance(item, Show) else Find((item,)))
        for node in walk(staged(problem, tree, now))
        if isinstance(node, Quantity)
    )


def _is_square(scene: Scene, quantity: Quantity) -> bool:
    """Whether a deflection is a right angle, which the scalar product tells."""
    match quantity:
        case Quantity("deflection", (Name(body),), int(event)) if event > 0:
            early, late = (scene.velocity(body, number) for number in (event - 1, event))
            return scene.model.identically_zero(scene.model.in_data(early.dot(late)))
    return False


def angles_by_squares(scene: Scene) -> Iterator[sp.Symbol]:
    """The angles of which a tangent is known, and of which the squares have a root less.

    So √(5 + √13)/4 is not put in for a cosine, where (5 + √13)/16 is its square.
    """
    for symbol in scene.model.final:
        role = scene.model.unknowns.roles.get(symbol.name)
        if role is None or role.kind != "angle" or (scene.final(symbol) / sp.pi).is_Rational:
            continue
        letter = Letter(symbol.name)
        others = [scene.desk.known(Apply(ratio, letter)) for ratio in ("sin", "cos")]
        if _squared_tangent(scene, letter) is None:
            continue
        if any(_is_used(scene, source) for source in others if source is not None):
            continue
        squares = _squares(scene, symbol).values()
        roots = (tidy(sp.sqrt(squared)) for squared in squares)
        if max(map(_depth_of_roots, roots)) > max(map(_depth_of_roots, squares)):
            yield symbol


def _is_used(scene: Scene, source: Source) -> bool:
    """Whether a ratio is put in somewhere, or does not come of another one."""
    (line, *rest) = source.refs
    if rest or not isinstance(line, int) or scene.desk.line(line).move.id != "triangle":
        return True
    return any(line in other.premises for other in scene.desk.lines)


def _is_root_of_roots(scene: Scene, tree: Expression) -> bool:
    """Whether a tree is the root of what has a root in it."""
    if not is_function(tree, "sqrt"):
        return False
    return _depth_of_roots(sp.sympify(scene.scalar(tree.argument), strict=True)) > 0


def _depth_of_roots(value: sp.Basic) -> int:
    """How many roots stand in one another in a value."""
    below = max(map(_depth_of_roots, value.args), default=0)
    return below + (isinstance(value, sp.Pow) and value.exp.is_Rational and value.exp.q != 1)


def _squares(scene: Scene, symbol: sp.Symbol) -> dict[type[sp.Function], sp.Expr]:
    """The squares of the sine and the cosine of an angle, by its tangent."""
    known = _squared_tangent(scene, Letter(symbol.name))
    assert known is not None
    tangent = tidy(scene.put(known.value)[0])
    if tangent.is_number:
        return {sp.sin: tidy(tangent / (1 + tangent)), sp.cos: tidy(1 / (1 + tangent))}
    # In letters both have one denominator, which is no longer than it has to be.
    above, below = sp.fraction(one_fraction(tangent))
    whole = min(expanded(above + below), sp.factor(above + below), key=lambda x: x.count_ops())
    return {sp.sin: above / whole, sp.cos: below / whole}


def _squared_tangent(scene: Scene, angle: Letter) -> Source | None:
    """The square of the tangent of an angle, by the line of that or of its square."""
    tangent = Apply("tan", angle)
    known = scene.desk.known(tangent)
    if known is not None:
        plain = len(known.refs) == 1 and isinstance(known.refs[0], int)
        return Source(known.value**2, known.refs) if plain else None
    line = _square_above(scene, tangent)
    if line is None:
        return None
    value = scene.scalar(scene.desk.last_link(line).right)
    return None if scene.unknown(value) else Source(value, (line,))


def squares_lines(scene: Scene, symbol: sp.Symbol) -> tuple[int, ...]:
    """``sin²α = 4/5 and cos²α = 1/5``, by the tangent; it is written once.

    With a sum of roots that of the cosine comes first, by 1 + tan²α.
    """
    letter = Letter(symbol.name)
    known = _squared_tangent(scene, letter)
    assert known is not None
    links = tuple(
        Link(square(Apply(kind.__name__, letter)), "=", tree_of(value))
        for kind, value in _squares(scene, symbol).items()
    )
    relation = Relation((links,))
    lines = [scene.judge.standing(Relation((own,))) for own in (links, links[1:], links[:1])]
    standing = lines[:1] if lines[0] is not None else lines[1:]
    if None not in standing:
        return tuple(filter(None, standing))
    extent, move = range_of(scene, symbol.name), Move("triangle")
    squared = _square_above(scene, Apply("tan", letter))
    if squared is not None and scene.judge.follows(move, (squared, extent), relation):
        return (scene.desk.write(move, (squared, extent), relation),)
    tangent = scene.desk.known(Apply("tan", letter))
    if tangent is not None and expanded(tangent.value**2).is_Add and tangent.value.is_number:
        cosine = square_of_cosine(scene, letter, tangent)
        own = scene.desk.last_link(cosine)
        sine = Relation((links[:1],))
        if own == links[1] and scene.judge.follows(move, (cosine, extent), sine):
            return cosine, scene.desk.write(move, (cosine, extent), sine)
    premises: tuple[Ref, ...] = (*known.refs, extent)
    return (scene.desk.write(move, premises, relation),)


def _square_above(scene: Scene, tangent: Apply) -> int | None:
    """The line that gives the square of a tangent, of which the root was taken."""
    for line in reversed(scene.desk.lines):
        match line.relation:
            case Relation(((Link(left, "="),),)) if left == square(tangent):
                return line.number if scene.desk.holds(line.number) else None
    return None


def squares_put(scene: Scene, tree: Expression, symbol: sp.Symbol) -> Expression | None:
    """A tree with the squares of the ratios of an angle put in, product by product.

    None where something is left of the angle.
    """
    squares = {kind(symbol) ** 2: value for kind, value in _squares(scene, symbol).items()}
    return _with_squares(scene, tree, symbol, squares)


def _with_squares(
    scene: Scene, tree: Expression, symbol: sp.Symbol, squares: dict[sp.Expr, sp.Expr]
) -> Expression | None:
    """The same of a part of it."""
    value = sp.sympify(scene.scalar(tree), strict=True)
    if symbol not in value.free_symbols:
        return tree
    match tree:
        case Apply("sqrt", inside):
            put = _with_squares(scene, inside, symbol, squares)
            return None if put is None else Apply("sqrt", put)
        case Negate(operand):
            put = _with_squares(scene, operand, symbol, squares)
            return None if put is None else Negate(put)
        case Binary(op, left, right) if op in "+-" or (
            op in "*/" and (is_binary(left, "+", "-") or is_binary(right, "+", "-"))
        ):
            parts = [_with_squares(scene, tree, symbol, squares) for tree in (left, right)]
            return None if None in parts else Binary(op, *parts)  # type: ignore[arg-type]
    put_in = expanded(expanded(value).xreplace(squares))
    return None if symbol in put_in.free_symbols else tree_of(tidy(put_in))
