"""A quantity by its definition, as data, and the lines that write it."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import sympy as sp

from restitution.errors import StatementError
from restitution.exact import tidy
from restitution.exact.symbols import atoms_in
from restitution.explaining.lines.derivation import Move, MoveId, Ref
from restitution.explaining.lines.trees import has_ratio_of_a_sum
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Quantity,
    children,
    is_function,
    letters,
    walk,
)
from restitution.planning.writing.between import root_of_a_square, terms_between
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import (
    outer_terms,
    swept,
    total,
    tree_of,
    vector,
)
from restitution.planning.writing.polynomials import expanded, one_fraction
from restitution.planning.writing.premises import background, not_negative, sign_known
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass
from restitution.vector import Vector


@dataclass(frozen=True)
class Formula:
    """A definition with values put in: ``left`` is the quantity, a power or a ratio of it.

    ``value`` is what the right side is worth; ``of`` makes the left side of any tree that stands
    for the quantity. ``between`` is a form on the way from one to the other: of a vector, or that
    of a number in which ratios of angles have their values.
    """

    move: Move
    of: Callable[[Expression], Expression]
    quantity: Expression
    right: Expression
    value: Any
    refs: tuple[Ref, ...]
    between: Expression | None = None

    @property
    def left(self) -> Expression:
        """The left side, of the quantity itself."""
        return self.of(self.quantity)


def itself(tree: Expression) -> Expression:
    """The left side that is the quantity itself."""
    return tree


def formula_of_line(scene: Scene, quantity: Quantity, number_: int, value: Any) -> Formula:
    """What a line says that stands, as a definition."""
    line = scene.desk.line(number_)
    right = scene.desk.relation(number_).only[0].right
    return Formula(line.move, itself, quantity, right, value, line.premises)


# A speed from components with roots is a line that people write; deeper roots are not.
_MOST_ROOTS = 2
_PAIR = 2
_RATIOS = ("sin", "cos", "tan")


def write_formula(scene: Scene, own: Formula) -> int:
    """A quantity by its definition, and what that comes to."""
    final = tree_of(own.value)
    right = swept(own.right)
    between: tuple[tuple[Expression, MoveId | None], ...] = ()
    if _depth_of_roots(right) > _MOST_ROOTS and not _trivial(own.right, final):
        squared = _with_squares(scene, right)
        if squared is not None:
            roots = (squared, *root_of_a_square(scene, final))
            between = tuple((root, "rearrange") for root in roots)
        elif getattr(own.value, "is_number", False):
            # A decimal comes next: nobody multiplies such sums out.
            right = final = final if _is_root_of_one_square(right) else right
        else:
            raise NotPlannedError("a root of sums of roots")
    else:
        between = tuple((term, "rearrange") for term in terms_between(scene, right, final))
    if isinstance(own.value, Vector):
        number = scene.desk.write(own.move, own.refs, chain(own.left, (right, None)))
        if right != final:
            parted = own.between or _by_coordinates(scene, right)
            steps: list[tuple[Expression, MoveId | None]] = [(final, None)]
            if parted is not None:
                steps = [(parted, None), (final, "rearrange")]
            link = chain(own.left, *steps)
            move = Move("rearrange")
            ratios = any(
                atoms_in(sp.sympify(value, strict=True), sp.sin, sp.cos) for value in own.value
            )
            if ratios and not scene.judge.follows(move, (number,), link):
                by = (Move("identity", name) for name in ("pythagoras", "sum-of-angles"))
                fitting = next((m for m in by if scene.judge.follows(m, (number,), link)), None)
                if fitting is None and any(map(_has_ratio_of_degrees, own.value)):
                    # No formula joins 40° and 20°: the sum is multiplied out, and no more.
                    parts = (sp.factor_terms(expanded(e)) for e in scene.value(right))
                    coordinates = (tree_of(part, as_it_is=True) for part in parts)
                    link = chain(own.left, (vector(*coordinates), None))
                move = fitting or move
            number = scene.desk.write(move, (number,), link)
    else:
        refs = own.refs
        if _is_root(right):
            refs = together(
                refs, not_negative(scene, own.value), sign_known(scene, _before_root(own.value))
            )
        if _trivial(own.right, final):
            right = final
        elif _is_figure(own.value) and isinstance(right, Apply):
            final = right  # what follows is its decimal: no other form of it is plainer
        if own.between is not None:
            # Ratios of numbers of degrees have their values by themselves.
            plain = all(node in walk(own.between) for node in _ratios_of_letters(own.right))
            between = ((swept(own.between), "rearrange" if plain else "put"), *between)
        relation = chain(own.left, (right, None), *between, (final, "rearrange"))
        if _by_pythagoras(scene, own) and not scene.judge.follows(own.move, refs, relation):
            relation = chain(own.left, (right, None), *between, (final, "identity"))
            if own.value.is_number and not scene.judge.follows(own.move, refs, relation):
                # No formula joins 40° and 20°, though it may be shorter in 20° alone.
                relation = chain(own.left, (right, None))
        elif _has_figures(own.value) and not scene.judge.follows(own.move, refs, relation):
            # Nobody shows that both forms are one: a decimal comes next.
            relation = chain(own.left, (right, None))
        if _has_roots_of_letters(own.right):
            known = background(scene, letters(right))
            refs = scene.judge.enough(own.move, refs, relation, known) or refs
        number = scene.desk.write(own.move, refs, relation)
    scene.desk.know(own.quantity, own.value, (number,))
    return number


def _by_coordinates(scene: Scene, right: Expression) -> Expression | None:
    """A sum of two vectors by their coordinates, each still a sum of two.

    None where these are added in the head: where no part of them is a sum itself, but for that in
    the sine or the cosine of a difference of angles.
    """
    terms = list(outer_terms(right))
    if len(terms) != _PAIR or has_ratio_of_a_sum(right):
        return None
    parts: list[list[sp.Expr]] = [[], []]
    kept = False
    for term in terms:
        value = scene.value(term)
        if not isinstance(value, Vector):
            return None
        for part, size in zip(parts, value, strict=True):
            part.append(tidy(size))
            # A product of sums of sines and cosines stays one, without tan θ cos²θ.
            if part[-1].has(sp.tan) and not size.has(sp.tan):
                part[-1], kept = size, True
    sums = [size for part in parts for size in part if size.has(sp.Add)]
    if not sums or any(size == 0 for part in parts for size in part):
        return None
    return vector(*(total(tree_of(e, as_it_is=kept) for e in part) for part in parts))


def _with_squares(scene: Scene, root: Expression) -> Expression | None:
    """The root of a sum of squares in which what is squared holds roots, with the squares.

    None of another one, and where roots of sums of roots would be left.
    """
    match root:
        case Apply("sqrt", Binary("+", Binary("^"), Binary("^")) as sum_):
            terms = (sum_.left, sum_.right)
        case _:
            return None
    squares = [tidy(expanded(scene.scalar(term))) for term in terms]
    tree = Apply("sqrt", Binary("+", *map(tree_of, squares)))
    return tree if _depth_of_roots(tree) <= _MOST_ROOTS else None


def _has_roots_of_letters(tree: Expression) -> bool:
    """Whether a root of letters stands in it, below the root of the whole if it is one."""
    inside = tree.argument if isinstance(tree, Apply) else tree
    return any(is_function(node, "sqrt") and letters(node.argument) for node in walk(inside))


def _is_figure(value: Any) -> bool:
    """Whether a number is made of sines and cosines of degrees that have no exact values."""
    own = sp.sympify(value, strict=True)
    return bool(own.is_number and atoms_in(own, sp.sin, sp.cos, sp.tan))


def _ratios_of_letters(tree: Expression) -> Iterator[Apply]:
    """The sines, cosines and tangents of letters in a tree."""
    for node in walk(tree):
        if isinstance(node, Apply) and node.function in _RATIOS and letters(node):
            yield node


def _has_ratio_of_degrees(value: Any) -> bool:
    """Whether a value has a sine or a cosine of degrees that has no exact value."""
    ratios = atoms_in(sp.sympify(value, strict=True), sp.sin, sp.cos, sp.tan)
    return any(not ratio.free_symbols for ratio in ratios)


def _has_figures(value: Any) -> bool:
    """Whether ratios of degrees that have no exact values stand below a root."""
    roots = atoms_in(sp.sympify(value, strict=True), sp.Pow)
    return any(
        not root.exp.is_Integer
        and any(not ratio.free_symbols for ratio in atoms_in(root.base, sp.sin, sp.cos, sp.tan))
        for root in roots
    )


def _is_root(tree: Expression) -> bool:
    """Whether a tree is a root, or a product that ends in the root of a number."""
    match tree:
        case Apply("sqrt"):
            return True
        case Binary("*", _, Apply("sqrt", inner)):
            return not letters(inner)
    return False


def _trivial(right: Expression, final: Expression) -> bool:
    """Whether a root is that of one square."""
    match right:
        case Apply("sqrt", Binary("^", base, _)):
            return base == final
    return False


def _is_root_of_one_square(tree: Expression) -> bool:
    match tree:
        case Apply("sqrt", Binary("^")):
            return True
    return False


def _before_root(value: sp.Expr) -> sp.Expr:
    """The factors of a value that are not roots."""
    return sp.Mul(
        *(
            factor
            for factor in sp.Mul.make_args(value)
            if not (factor.is_Pow and factor.exp.is_Rational and factor.exp.q == 2)
        )
    )


def _by_pythagoras(scene: Scene, own: Formula) -> bool:
    """Whether a value may come of its formula by sin² + cos² = 1 alone.

    Roots of factors, and the root of their product, differ in form only and look so too.
    """
    value = sp.sympify(own.value, strict=True)
    try:
        right = scene.scalar(own.right)
    except StatementError:
        return False
    ratios = atoms_in(right, sp.sin, sp.cos) | atoms_in(value, sp.sin, sp.cos, sp.tan)
    angles = {ratio.args[0] for ratio in ratios}
    if len(ratios) == len(angles):
        return False
    put: dict[sp.Basic, sp.Expr] = {}
    for n, angle in enumerate(angles):  # by their numbers letters are the same each time
        s, c = sp.Dummy("s", n, positive=True), sp.Dummy("c", n, positive=True)
        put |= {sp.sin(angle): s, sp.cos(angle): c, sp.tan(angle): s / c}
    gap = right.xreplace(put) ** 2 - value.xreplace(put) ** 2
    return bool(expanded(sp.fraction(one_fraction(expanded(gap)))[0]) != 0)


def _depth_of_roots(tree: Expression) -> int:
    """How many roots stand in one another in a tree."""
    below = max(map(_depth_of_roots, children(tree)), default=0)
    return below + is_function(tree, "sqrt")
