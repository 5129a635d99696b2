"""What is asked, by a result that was shown of it: the values of its letters are put in."""

from __future__ import annotations

from collections.abc import Iterator
from collections.abc import Set as AbstractSet
from contextlib import suppress

import sympy as sp

from restitution.exact import tidy, tidy_angle
from restitution.explaining.lines.derivation import Fact, Link, Move, Ref, Relation, numbers_in
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turning import write_angle
from restitution.planning.closing.shapes import close
from restitution.planning.routes.order import Solver
from restitution.planning.writing.angle_ratios import given_ratio
from restitution.planning.writing.desk import UNPLANNED, chain
from restitution.planning.writing.forms import (
    in_tangents,
    neat,
    negative,
    product_without,
    square,
    swept,
    tree_of,
)
from restitution.planning.writing.polynomials import numerator, polynomial_in
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.records import dataclass

# What stands for the ratio of an angle while the value of that is worked out.
_RATIO = Letter("ratio of the angle")
_RATIOS = {"sin": sp.sin, "cos": sp.cos, "tan": sp.tan}
_INVERSES = {"sin": sp.asin, "cos": sp.acos, "tan": sp.atan}


@dataclass(frozen=True)
class Put:
    """What is put in for a letter or a ratio of an angle, and what gives it."""

    tree: Expression
    by: Expression
    refs: tuple[Ref, ...]


def write_by_a_shown_result(scene: Scene, solver: Solver, asked: Expression, name: str) -> bool:
    """Ends an item by a result in angles of the motion that was shown, where they have values now.

    From *e = 1 − 2 tan α/tan β* it is *e = 1 − 2 tan 30°/tan 60°*: the motion is not worked out
    again. False where no such result is about it.
    """
    if scene.others:
        return False
    line = _by_its_result(scene, solver, asked)
    if line is not None:
        right = scene.desk.last_link(line).right
        scene.desk.end(name, line, chain(asked, (right, None)))
        return True
    if _angle_by_a_result(scene, solver, asked):
        scene.desk.end(name, *write_angle(scene, asked))
        return True
    if isinstance(asked, Letter) and _named(scene, asked.name) is None:
        _close_by_an_angle(scene, solver, asked)
    return False


def _close_by_an_angle(scene: Scene, solver: Solver, asked: Letter) -> None:
    """A letter by a line of a ratio of an angle that has a value: tan 45° = e tan 60°.

    Of an angle that has been found its tangent is written where it is no line.
    """
    symbol = scene.model.unknowns.letter(asked.name)
    if symbol not in scene.unknown(symbol):
        return
    for line in [line.number for line in reversed(scene.desk.lines)]:
        if _closes_with_values(scene, solver, line, symbol):
            return
    for fact in [fact for fact in scene.desk.facts if fact.id.startswith("let ")]:
        quantity = _named(scene, fact.id.removeprefix("let "))
        known = None if quantity is None else scene.desk.known(quantity)
        if quantity is None or known is None or not numbers_in(known.refs):
            continue
        standing = solver.mark()
        tangent = _tangent(scene, solver, quantity, fact, symbol)
        if tangent is not None and _closes_with_values(scene, solver, tangent, symbol):
            return
        solver.back(standing)


def _closes_with_values(scene: Scene, solver: Solver, line: int, symbol: sp.Symbol) -> bool:
    """Whether a line of a ratio of an angle tells a letter, with the values of the others in it."""
    match scene.desk.line(line).relation:
        case Relation(((Link(Apply(_, Letter(angle)) as ratio, "="), *_),)):
            right = scene.desk.last_link(line).right
        case _:
            return False
    if _named(scene, angle) is None or not scene.desk.holds(line):
        return False
    if symbol.name not in letters(right) or has_quantity(right):
        return False
    standing = solver.mark()
    with suppress(*UNPLANNED):
        left, own = _with_values(scene, solver, ratio)
        whole, refs = _with_values(scene, solver, right, symbol.name)
        if left != ratio and letters(whole) == {symbol.name}:
            relation = chain(left, (whole, None))
            put = scene.judge.write((Move("put"),), (line, *own, *refs), relation)
            if put is not None:
                close(scene, put, symbol)
                return True
    solver.back(standing)
    return False


def _tangent(
    scene: Scene, solver: Solver, quantity: Quantity, let: Fact, symbol: sp.Symbol
) -> int | None:
    """The line of the tangent of an angle, in a letter that is sought; None without one."""
    free = set(scene.free)
    scene.free.add(symbol)
    try:
        velocities = [side for side in quantity.arguments if is_quantity(side, "velocity")]
        solver.determine([part for side in velocities for part in scene.vector(side)])
        own = formula(scene, quantity)
        tangent = own.of(let.relation.only[0].right)
        last = tree_of(in_tangents(neat(own.value)))
        relation = chain(tangent, (swept(own.right), None), (last, "rearrange"))
        known = scene.judge.known(letters(own.right))
        return scene.judge.write((own.move,), (*own.refs, let.id, *known), relation, own.refs)
    except UNPLANNED:
        return None
    finally:
        scene.free = free


def _by_its_result(scene: Scene, solver: Solver, asked: Expression) -> int | None:
    """The line of what is asked by its result; None where one of the angles has no value."""
    known = scene.desk.known(asked)
    for number, right in _results(scene, asked):
        if known is not None and number not in known.refs:
            continue  # it has been worked out since
        standing = solver.mark()
        try:
            line = _written(scene, solver, asked, number, right)
        except UNPLANNED:
            line = None
        if line is not None:
            return line
        solver.back(standing)
    return None


def _results(scene: Scene, asked: Expression) -> Iterator[tuple[int, Expression]]:
    """The lines that were to be shown of what is asked, in letters with one of the motion."""
    for line, own in _shown(scene):
        named = any(_named(scene, name) is not None for name in letters(own.right))
        if own.left == asked and named:
            yield line, own.right


def _shown(scene: Scene) -> Iterator[tuple[int, Link]]:
    """The lines of the equations that were to be shown, in letters on the right; the last first."""
    desk = scene.desk
    for end in reversed(desk.ends):
        if not end.shown or not desk.holds(end.line) or len(desk.relation(end.line).options) > 1:
            continue
        own = desk.last_link(end.line)
        if own.sign == "=" and not has_quantity(own.right):
            yield end.line, own


def _named(scene: Scene, name: str) -> Quantity | None:
    """The quantity of the motion for which the statement has a letter."""
    fact = scene.facts.get(f"let {name}")
    quantity = None if fact is None else fact.relation.only[0].left
    return quantity if isinstance(quantity, Quantity) else None


def _written(
    scene: Scene, solver: Solver, asked: Expression, number: int, right: Expression
) -> int | None:
    whole, refs = _with_values(scene, solver, right)
    value = tidy(scene.scalar(whole))
    if scene.unknown(value) or any(_named(scene, name) for name in letters(whole)):
        return None
    relation = chain(asked, (whole, None), (tree_of(value), "rearrange"))
    line = scene.judge.write((Move("put"),), (number, *refs), relation)
    if line is not None:
        scene.desk.know(asked, value, (line,))
    return line


def _with_values(
    scene: Scene, solver: Solver, right: Expression, sought: str | None = None
) -> tuple[Expression, tuple[Ref, ...]]:
    """A result with the values of its letters, but for one that is sought, and what gives them."""
    names = letters(right) - {sought}
    open_ = {
        symbol
        for symbol in map(scene.model.unknowns.letter, names)
        if _named(scene, symbol.name) is None and symbol in scene.unknown(symbol)
    }
    if open_:
        solver.determine(sorted(open_, key=str))
    puts = [put for name in sorted(names) for put in _values(scene, name, right)]
    whole = exchanged(right, {put.tree: put.by for put in puts})
    return whole, tuple(ref for put in puts for ref in put.refs)


def _angle_by_a_result(scene: Scene, solver: Solver, asked: Expression) -> bool:
    """Writes an acute angle that is asked, by a result in it of what is given in numbers.

    From *fraction lost = 1 − cos²α/cos²β* and a loss of a half it is *½ = 1 − cos²60°/cos²β*. False
    where no result has the angle in one ratio, or in the square of one, as the only unknown.
    """
    if not isinstance(asked, Letter):
        return False
    quantity = _named(scene, asked.name)
    if quantity is None or not _is_acute(quantity) or scene.desk.known(quantity) is not None:
        return False
    for given in scene.given:
        for number, share, right in _results_given(scene, given):
            if asked.name not in letters(right):
                continue
            standing = solver.mark()
            try:
                line = _angle(scene, solver, asked, (number, right), (given, share))
            except UNPLANNED:
                line = None
            if line is not None:
                scene.desk.know(quantity, scene.scalar(scene.desk.last_link(line).right), (line,))
                return True
            solver.back(standing)
    return False


def _is_acute(quantity: Quantity) -> bool:
    """Whether it is the angle of a velocity to a wall or to a line of centres."""
    return is_quantity(quantity, "angle") and any(
        isinstance(side, Name) or is_quantity(side, "line_of_centres")
        for side in quantity.arguments
    )


def _results_given(
    scene: Scene, given: GivenEquation
) -> Iterator[tuple[int, Expression, Expression]]:
    """The lines that were to be shown of what a fact gives, its value, and the result."""
    for line, own in _shown(scene):
        share = _share(given.link, own.left)
        if share is not None:
            yield line, share, own.right


def _share(link: Link, subject: Expression) -> Expression | None:
    """What a fact says that a quantity, or the ratio of two, is; None of another fact."""
    if link.sign != "=":
        return None
    value: Expression | None = link.right if link.left == subject else None
    match link.left, subject:
        case Quantity() as one, Binary("/", above, below) if one == above:
            value = product_without(link.right, below)
    return None if value is None or has_quantity(value) else value


def _angle(
    scene: Scene,
    solver: Solver,
    angle: Letter,
    result: tuple[int, Expression],
    fact: tuple[GivenEquation, Expression],
) -> int | None:
    (number, right), (given, share) = result, fact
    whole, refs = _with_values(scene, solver, right, angle.name)
    ratios = {node for node in walk(whole) if isinstance(node, Apply) and node.argument == angle}
    if len(ratios) != 1 or any(_named(scene, name) for name in letters(whole) - {angle.name}):
        return None
    (ratio,) = ratios
    value = _positive_root(scene, exchanged(whole, {ratio: _RATIO}), share)
    if value is None or (value > 1 and ratio.function != "tan"):
        return None
    extent, let = f"0° <= {angle.name} <= 90°", f"let {angle.name}"
    measure = tree_of(tidy_angle(_INVERSES[ratio.function](value)), angle=True)
    if not isinstance(measure, Degrees):
        measure = Apply(f"arc{ratio.function}", tree_of(value))
    first = scene.judge.write(
        (Move("put"),), (number, given.fact.id, *refs), chain(share, (whole, None))
    )
    line = None if first is None else _ratio(scene, first, Link(ratio, "=", tree_of(value)), extent)
    inverse = chain(angle, (measure, None))
    return line and scene.judge.write((Move("inverse"),), (line, extent, let), inverse)


def _positive_root(scene: Scene, whole: Expression, share: Expression) -> sp.Expr | None:
    """The ratio of an angle with which two sides are equal, where its square is told, or itself."""
    symbol = sp.Dummy(_RATIO.name, positive=True)
    gap = numerator(scene.worth(whole, {_RATIO.name: symbol}) - scene.scalar(share))
    if not gap.is_polynomial(symbol):
        return None
    polynomial = polynomial_in(gap, symbol)
    powers = [power for (power,) in polynomial.monoms()]
    if powers not in ([1, 0], [2, 0]):
        return None
    root = tidy(sp.cancel(-polynomial.TC() / polynomial.LC()) ** sp.Rational(1, powers[0]))
    return root if root.is_number and root.is_positive else None


def _ratio(scene: Scene, line: int, own: Link, extent: str) -> int | None:
    """The line of a ratio of an angle by an equation, or by its square, which that tells."""
    whole = Relation(((own,),))
    alone = scene.judge.write((Move("rearrange"),), (line,), whole)
    if alone is not None:
        return alone
    square_ = tidy(scene.scalar(own.right) ** 2)
    squared = chain(square(own.left), (tree_of(square_), None))
    line = scene.judge.write((Move("rearrange"),), (line,), squared) or line
    both = Relation(((own,), (Link(own.left, "=", negative(own.right)),)))
    roots = scene.judge.write((Move("roots"),), (line,), both)
    return roots and scene.judge.write((Move("reject"),), (roots, extent), whole)


def _values(scene: Scene, name: str, tree: Expression) -> Iterator[Put]:
    """The values that are put in for a letter of a result, or for its ratios; none without one."""
    letter = Letter(name)
    ratios = {node for node in walk(tree) if isinstance(node, Apply) and node.argument == letter}
    if name in scene.ratio_facts:
        for ratio in sorted(ratios, key=str):
            own, worth, ref = given_ratio(scene, name)
            value, refs = scene.put(scene.scalar(ratio))
            if own == ratio:
                yield Put(ratio, worth, (ref,))
            elif refs and not value.free_symbols:
                yield Put(ratio, tree_of(value), refs)
        return
    quantity = _named(scene, name)
    for given in scene.given if quantity is not None else ():
        match given.link:
            case Link(left, "=", right) if left == quantity and not has_quantity(right):
                value, refs = scene.put(scene.scalar(right))
                by = tree_of(value, angle=is_quantity(quantity, "angle")) if refs else right
                yield Put(letter, by, (given.fact.id, *refs))
                return
            case Link(Apply() as ratio, "=", right) if ratio.argument == quantity:
                if not letters(right) and not has_quantity(right):
                    own_ratio = Link(Apply(ratio.function, letter), "=", right)
                    yield from _by_a_given_ratio(scene, own_ratio, given.fact.id, ratios)
                return
    symbol = scene.model.unknowns.letter(name)
    known = scene.desk.known(letter if quantity is None else quantity)
    if known is None:
        return
    value, refs = scene.put(symbol if quantity is None else known.value)
    role = scene.model.unknowns.roles.get(name)
    angle = quantity is not None or (role is not None and role.kind == "angle")
    worth = tree_of(value, angle=angle)
    if not letters(worth) and (isinstance(worth, Degrees) or not angle):
        yield Put(letter, worth, refs or known.refs)


def _by_a_given_ratio(
    scene: Scene, own: Link, fact: Ref, ratios: AbstractSet[Apply]
) -> Iterator[Put]:
    """The ratios of an acute angle of which one is given in numbers."""
    assert isinstance(own.left, Apply)
    letter = own.left.argument
    assert isinstance(letter, Letter)
    worth = scene.scalar(own.right)
    angle = _INVERSES[own.left.function](worth)
    for ratio in sorted(ratios, key=str):
        if ratio == own.left:
            yield Put(ratio, own.right, (fact,))
            continue
        value = tree_of(tidy(_RATIOS[ratio.function](angle)))
        pool = (fact, f"let {letter.name}", f"0° <= {letter.name} <= 90°")
        line = scene.judge.write((Move("triangle"),), pool, chain(ratio, (value, None)))
        if line is not None:
            yield Put(ratio, value, (line,))


__all__ = ["write_by_a_shown_result"]
