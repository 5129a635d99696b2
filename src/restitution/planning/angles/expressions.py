"""Expressions of several quantities: each is worked out, and its value takes its place."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from typing import Any

import sympy as sp

from restitution.exact import plain_angle, tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import (
    Link,
    Meaning,
    Move,
    Ref,
    Relation,
    numbers_in,
)
from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import ANGLES, LOSSES
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    children,
    has_quantity,
    is_binary,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.decimal_angles import write_decimal
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turning import angle_line, is_angle, quantity_of, write_ratio
from restitution.planning.closing.losses_by_products import write_loss_by_products
from restitution.planning.closing.squared_ratios import write_by_squares
from restitution.planning.formulas.definitions import Formula, write_formula
from restitution.planning.formulas.energy_formulas import energy_change
from restitution.planning.formulas.fractions_lost import fraction_lost, ratio_of_energies
from restitution.planning.formulas.given_values import given_energy
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.separations import relative_speed, relative_velocity
from restitution.planning.formulas.velocity_formulas import squared_speed, velocity_source
from restitution.planning.journeys import distances, journeys
from restitution.planning.writing.desk import NotPlannedError, Source, chain, together
from restitution.planning.writing.forms import ONE, outer_terms, square, swept, total, tree_of
from restitution.planning.writing.place_trees import is_duration
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.roots_below import in_shorter_form
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.vectors import velocity_given
from restitution.vector import Vector

_DATA = ("mass", "restitution")
_ARCS = ("arctan", "arccos", "arcsin")


def _has_degrees(tree: Expression) -> bool:
    """Whether an expression is an angle of the motion, or a sum with such an angle."""
    match tree:
        case Quantity(kind):
            return kind in ANGLES
        case Negate(operand):
            return _has_degrees(operand)
        case Binary("*", factor, operand) | Binary("/", operand, factor):
            return not (has_quantity(factor) or letters(factor)) and _has_degrees(operand)
        case Binary("+" | "-", left, right):
            return _has_degrees(left) or _has_degrees(right)
    return False


def write_expression(scene: Scene, asked: Expression) -> tuple[int, Any]:
    """The line in which an expression comes to its value, with the value.

    Raises NotPlannedError where something in it is open.
    """
    if is_angle_sum(asked) and isinstance(asked, Binary):
        return _angle_sum(scene, asked)
    if is_function(asked, "abs"):
        inside = scene.value(asked.argument)
        if isinstance(inside, Vector):
            return _write_size(scene, asked, inside)
    squares = write_by_squares(scene, asked, formula_of_squares)
    if squares is not None:
        return squares, scene.desk.last_link(squares).right
    own = _of_squares(scene, asked) or relative_velocity(scene, asked)
    if own is not None:
        return write_formula(scene, own), tree_of(own.value)
    values: dict[Expression, Expression] = {}
    refs: list[Ref] = []
    ranges: list[Ref] = []
    for known_sum, (number, worth) in _standing_sums(scene, asked).items():
        values[known_sum] = worth
        refs.append(number)
    rest = exchanged(asked, dict.fromkeys(values, ONE))
    sources = {node: _value_of(scene, node) for node in _in_order(rest)}
    for node in _parts(rest):
        source = sources[node]
        if source is None:
            continue
        angle = isinstance(node, Quantity) and node.kind in ANGLES
        values[node] = _angle_tree(scene, source) if angle else tree_of(source.value)
        refs += source.refs
        if not isinstance(source.value, Vector):
            ranges += distances.ranges(scene, sp.sympify(source.value, strict=True))
    if not refs:
        raise NotPlannedError("an expression of data")
    value = _worth(scene, asked, values)
    final = tree_of(value, angle=_has_degrees(asked))
    if value == 0 and is_binary(asked, "/"):
        nothing = chain(asked, (final, None))
        quotient = (Move("rearrange"), Move("put"), Move("divide"))
        line = scene.judge.write(quotient, together(refs), nothing)
        if line is None:
            raise NotPlannedError("a quotient that is zero")
        return line, final
    right = swept(exchanged(asked, values))
    if isinstance(value, Vector):
        if Counter(outer_terms(right)) == Counter(outer_terms(final)):
            right = final  # the component along i first
        line = scene.desk.write(Move("put"), together(refs), chain(asked, (right, None)))
        if right != final:
            line = scene.desk.write(Move("rearrange"), (line,), chain(asked, (final, None)))
        return line, final
    final = in_shorter_form(scene, right, final)
    if len(set(refs)) == 1 or _is_of_one_line(scene, refs):
        # Of one line there is nothing to put in.
        if is_function(asked, "abs"):
            return _size_of_a_number(scene, asked, refs[0], final), final
        own_form = chain(asked, (final, None))
        # A ratio of an angle that is multiplied by may have to be none that vanishes.
        known = scene.judge.known(letters(asked))
        premises_ = scene.judge.enough(Move("rearrange"), tuple(refs), own_form, known)
        # By letters for quantities, the ratio of these is put in.
        by_letters = premises_ is None and scene.judge.follows(Move("put"), refs, own_form)
        move = Move("put" if by_letters else "rearrange")
        line = scene.desk.write(move, premises_ or refs, own_form)
        return line, final
    # What stands first is where the line starts from: of a quotient what is above.
    premises = sorted(dict.fromkeys((*refs, *ranges)), key=lambda ref: isinstance(ref, str))
    whole = chain(asked, (right, None), (final, "rearrange"))
    apart = _roots_apart(scene, right)
    if apart is not None and not scene.judge.follows(Move("put"), premises, whole):
        final = apart
        whole = chain(asked, (right, None), (final, "rearrange"))
    if _is_of_both(right) and not scene.judge.follows(Move("put"), premises, whole):
        # Squares of a sine and a cosine come together by the identity, on a line of its own.
        line = scene.desk.write(Move("put"), premises, chain(asked, (right, None)))
        moves = (Move("rearrange"), Move("identity", "pythagoras"))
        last = scene.judge.write(moves, [line, *ranges], chain(asked, (final, None)))
        if last is None and not letters(final):
            return line, right  # a number, of which a calculator has the decimals as it stands
        if last is None:
            raise NotPlannedError("an expression of sines and cosines")
        return last, final
    return scene.desk.write(Move("put"), premises, whole), final


def _standing_sums(scene: Scene, asked: Expression) -> dict[Expression, tuple[int, Expression]]:
    """The sums of quantities in an expression of which lines in force say the values.

    With each the line and the value: a loss that a part shows is not worked out again.
    """
    sums = {node for node in walk(asked) if is_binary(node, "+", "-") and has_quantity(node)}
    standing: dict[Expression, tuple[int, Expression]] = {}
    for line in scene.desk.lines if sums - {asked} else ():
        match line.relation:
            case Relation(((Link(left, "="), *_) as links,)) if left in sums and left != asked:
                worth = links[-1].right
                if scene.desk.holds(line.number) and not has_quantity(worth):
                    standing[left] = line.number, worth
    return {
        own: source
        for own, source in standing.items()
        if not scene.unknown(scene.scalar(source[1]))
    }


def _is_of_one_line(scene: Scene, refs: Sequence[Ref]) -> bool:
    """Whether what a value rests on is one line, and what letters stand for."""
    lines = [scene.desk.line(ref) for ref in numbers_in(dict.fromkeys(refs))]
    relations = [line for line in lines if not isinstance(line.relation, Meaning)]
    return len(relations) == 1 and len(lines) == len(set(refs))


def formula_of_squares(scene: Scene, asked: Expression) -> Formula | None:
    """What an energy, its change, a fraction of it or the square of a speed is by definition."""
    return formula(scene, asked) if isinstance(asked, Quantity) else _of_squares(scene, asked)


def _of_squares(scene: Scene, asked: Expression) -> Formula | None:
    """The change of an energy, a fraction of it or the square of a speed; None of another tree."""
    own = energy_change(scene, asked) or fraction_lost(scene, asked)
    own = own or ratio_of_energies(scene, asked)
    return own or squared_speed(scene, asked)


def _in_order(asked: Expression) -> list[Expression]:
    """The quantities of an expression in their order: an energy before what is lost of it."""
    nodes = _parts(asked)
    match asked:
        case Binary("/", Quantity(kind), Quantity("energy")) if kind in LOSSES:
            return nodes[::-1]
    return nodes


def _parts(asked: Expression) -> list[Expression]:
    """The quantities and letters in an expression; of an angle of the motion its one ratio."""
    nodes, ratios = list(walk(asked)), dict[Expression, set[Expression]]()
    for node in nodes:
        match node:
            case Apply("sin" | "cos" | "tan", Quantity(kind) as angle) if kind in ANGLES:
                ratios.setdefault(angle, set()).add(node)
    alone = {
        angle: next(iter(own))
        for angle, own in ratios.items()
        if len(own) == 1 and nodes.count(angle) == nodes.count(next(iter(own)))
    }
    return [alone.get(node, node) for node in outermost(asked)]


def _roots_apart(scene: Scene, tree: Expression) -> Expression | None:
    """A quotient of two roots of sums with letters, with what else there is over its own.

    None of another quotient.
    """
    if not is_binary(tree, "/"):
        return None
    roots: list[sp.Expr] = []
    rest: list[sp.Expr] = []
    for side in (tree.left, tree.right):
        factors = sp.Mul.make_args(sp.sympify(scene.scalar(side), strict=True))
        own = [e for e in factors if e.is_Pow and e.exp == sp.S.Half and e.free_symbols]
        if len(own) != 1:
            return None
        roots += own
        rest.append(sp.Mul(*(factor for factor in factors if factor is not own[0])))
    above, below = tidy(rest[0] / rest[1]).as_numer_denom()
    return swept(Binary("/", *(tree_of(a * b) for a, b in zip((above, below), roots, strict=True))))


def _is_of_both(tree: Expression) -> bool:
    """Whether the sine and the cosine of one angle stand in an expression."""
    sines, cosines = (
        {e.argument for e in walk(tree) if is_function(e, ratio)} for ratio in ("sin", "cos")
    )
    return bool(sines & cosines)


def _angle_sum(scene: Scene, asked: Binary) -> tuple[int, Any]:
    """A sum of angles of the motion, each of which is a line; with its decimal."""
    quantities = [tree for tree in outermost(asked) if isinstance(tree, Quantity)]
    lines = [angle_line(scene, quantity) for quantity in quantities]
    values: dict[Expression, Expression] = {
        quantity: scene.desk.last_link(line).right
        for quantity, line in zip(quantities, lines, strict=True)
    }
    right = swept(exchanged(asked, values))
    relation = chain(asked, (right, None))
    named = [
        letter_of(scene, quantity)[1]
        for quantity, line in zip(quantities, lines, strict=True)
        if isinstance(scene.desk.last_link(line).left, Letter)
    ]
    # An angle by the letters of others is a number by what these are.
    arcs = [ref for line in lines for ref in scene.desk.line(line).premises if isinstance(ref, int)]
    arcs = [ref for ref in arcs if scene.desk.line(ref).move.id == "inverse"]
    # Of one angle of the motion there is nothing to put in.
    move = Move("put" if len(lines) > 1 else "rearrange")
    refs = scene.judge.needed(move, (*lines, *named, *arcs), relation, lines)
    if refs is None:
        raise NotPlannedError("a sum of angles of the motion")
    line = scene.desk.write(move, refs, relation)
    short = _without_opposites(scene, right)
    if short is not None:
        shorter = chain(asked, (short, None))
        line = scene.judge.write((Move("rearrange"),), (line,), shorter) or line
    plain = plain_angle(sp.sympify(scene.scalar(right), strict=True))
    if plain is not None:
        degrees = chain(asked, (tree_of(plain, angle=True), None))
        line = scene.judge.write((Move("rearrange"),), (line,), degrees) or line
    line, answer = write_decimal(scene, line)
    return line, answer.only[0].right


def _without_opposites(scene: Scene, tree: Expression) -> Expression | None:
    """A sum of angles without the inverse ratios of which it has the opposite too, if any."""
    value = sp.sympify(scene.scalar(tree), strict=True)
    arcs = [node for node in walk(tree) if isinstance(node, Apply) and node.function in _ARCS]
    if len(value.atoms(sp.atan, sp.acos, sp.asin)) >= len(set(arcs)):
        return None
    return tree_of(expanded(value), angle=True, as_it_is=True)


def size_of(scene: Scene, asked: Apply, inside: Vector) -> tuple[tuple[Ref, ...], list[sp.Expr]]:
    """The components of a vector of which the size is taken, and the line that says the vector."""
    if isinstance(asked.argument, Quantity):
        source = _value_of(scene, asked.argument)
        refs = () if source is None else source.refs
    else:
        refs = (write_expression(scene, asked.argument)[0],)
    put, _ = scene.put(inside)
    return refs, [tidy(expanded(value)) for value in put]


def _size_of_a_number(scene: Scene, asked: Apply, ref: Ref, final: Expression) -> int:
    """The size of a component or a coordinate, which is a line: its sign is certain."""
    known = scene.judge.known(symbol_names(scene.scalar(final)))
    relation = chain(asked, (final, None))
    line = scene.judge.write((Move("rearrange"),), [ref, *known], relation)
    if line is None:
        raise NotPlannedError("the size of what may have either sign")
    return line


def _write_size(scene: Scene, asked: Apply, inside: Vector) -> tuple[int, Any]:
    """The size of a vector, by its components."""
    apart = relative_speed(scene, asked.argument)
    if apart is not None:
        parts, refs = apart
    else:
        refs, values = size_of(scene, asked, inside)
        parts = [(tree_of(value), value) for value in values]
    final = tree_of(tidy(sp.sqrt(expanded(sum(value**2 for _, value in parts)))))
    moving = [tree for tree, value in parts if value != 0]
    if len(moving) < 2:
        relation = chain(asked, (final, None))
    else:
        root = Apply("sqrt", total(square(tree) for tree in moving))
        relation = chain(asked, (root, None), (final, "rearrange"))
    return scene.desk.write(Move("define", "size"), refs, relation), final


def is_angle_sum(tree: Expression) -> bool:
    """Whether angles of the motion are added, or taken from each other, or from those of data."""
    return _is_of_angles(tree) and any(is_quantity(node, *ANGLES) for node in walk(tree))


def _is_of_angles(tree: Expression) -> bool:
    match tree:
        case Binary("+" | "-", left, right):
            return _is_of_angles(left) and _is_of_angles(right)
        case Quantity(kind):
            return kind in ANGLES
    return isinstance(tree, Letter | Degrees)


def outermost(tree: Expression) -> list[Expression]:
    """The quantities and letters in an expression, but for what stands inside a quantity.

    The time between two events is one of them.
    """
    ratios = {
        node.argument
        for node in walk(tree)
        if isinstance(node, Apply) and isinstance(node.argument, Letter)
    }

    def unknowns(node: Expression) -> Iterator[Expression]:
        if isinstance(node, Quantity) or is_duration(node):
            yield node
        elif isinstance(node, Letter):
            if node not in ratios:
                yield node
        elif isinstance(node, Apply) and node.argument in ratios:
            yield node
        else:
            for child in children(node):
                yield from unknowns(child)

    return list(dict.fromkeys(unknowns(tree)))


def _value_of(scene: Scene, node: Expression) -> Source | None:
    """What a quantity or a letter is worth, by a line; one is written where there is none."""
    known = scene.desk.known(node)
    if known is not None:
        value, more = scene.put(known.value)
        return Source(value, together(known.refs, more))
    match node:
        case Quantity("dot", (Quantity("position") as place, Unit() as axis)) | Quantity(
            "dot", (Unit() as axis, Quantity("position") as place)
        ):
            return _value_of(scene, Quantity("along", (place, axis)))
        case Apply("sin" | "cos" | "tan" as ratio, Quantity() | Letter() as angle) if is_angle(
            scene, angle
        ):
            quantity = quantity_of(scene, angle)
            number, own_ratio = write_ratio(scene, ratio, quantity)
            value = scene.scalar(own_ratio.only[-1].right)
            named = () if isinstance(angle, Letter) else (letter_of(scene, quantity)[1],)
            return Source(value, (number, *named))
    if isinstance(node, Quantity) and node.kind in ANGLES:
        line = angle_line(scene, node)
        return Source(scene.scalar(scene.desk.last_link(line).right), (line,))
    if isinstance(node, Quantity) and node.kind in _DATA:
        return _datum(scene, node)
    match node:
        case Quantity("velocity", (Name(body),), int(stage)) if not scene.last_event(body, stage):
            return velocity_source(scene, body, 0)
        case Quantity("velocity", (Name(body),), int(stage)) if (
            given := velocity_given(scene, body, stage)
        ) is not None and not any(map(scene.unknown, given[1])):
            return Source(given[1], given[2])
    if is_duration(node):
        number, value = journeys.write(scene, node)
        return Source(value, (number,))
    if (known := given_energy(scene, node) or _given_in_all(scene, node)) is not None:
        return known
    if isinstance(node, Quantity):
        if write_by_squares(scene, node, formula_of_squares) is not None:
            return scene.desk.known(node)
        if write_loss_by_products(scene, node) is not None:
            return scene.desk.known(node)
        own = formula(scene, node)
        return Source(own.value, (write_formula(scene, own),))
    return None


def _given_in_all(scene: Scene, node: Expression) -> Source | None:
    """What the only impact takes, as it is given of that impact; None of another quantity."""
    if not is_quantity(node, "total_energy_lost") or node.stage != 1:
        return None
    known = given_energy(scene, Quantity("energy_lost", (), 1))
    if known is None or 1 not in scene.model.frames:
        return None
    equal = chain(node, (tree_of(known.value), None))
    line = scene.judge.write((Move("define", "total-lost", 1),), known.refs, equal, shown="silent")
    return None if line is None else Source(known.value, (line,))


def _datum(scene: Scene, node: Quantity) -> Source:
    match node:
        case Quantity("mass", (Name(body),)):
            return scene.mass(body)
    return scene.data(f"e {node.stage}")


def _angle_tree(scene: Scene, source: Source) -> Expression:
    lines = numbers_in(source.refs)
    if len(lines) != 1:
        raise NotPlannedError("an angle by several lines")
    return scene.desk.last_link(lines[0]).right


def _worth(scene: Scene, asked: Expression, values: dict[Expression, Expression]) -> Any:
    put = exchanged(asked, values)
    value = scene.value(put)
    if isinstance(value, Vector):
        return Vector(*(tidy(expanded(component)) for component in value))
    return tidy(scene.scalar(put))
