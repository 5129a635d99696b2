"""Lines of an angle that is made of two others: in numbers, or by the tangents of both."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import sympy as sp

from restitution import exact
from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Line, Meaning, Move, MoveId, Ref, Relation
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    Quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.axes.offsets import angle_of_an_offset
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.named_angles import letter_known, letter_of, tangent_line
from restitution.planning.formulas.turns import NONE, Direction, Form, Turn
from restitution.planning.writing.angle_ratios import given_ratio, range_of, write_other_ratio
from restitution.planning.writing.angles import RIGHT, STRAIGHT
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import (
    ONE,
    TWO,
    ZERO,
    difference,
    in_tangents,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.one_fraction import multiplied_through
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass


@dataclass(frozen=True)
class Term:
    """An angle of which another is made: as lines say it, its tangent, and what that rests on.

    ``same`` says that it is one which has a letter already.
    """

    angle: Expression
    tangent: Expression
    refs: tuple[Ref, ...] = ()
    same: tuple[Ref, ...] = ()


def write_turn(
    scene: Scene,
    turn: Turn,
    angle_line: Callable[[Scene, Quantity], int],
    in_letters: bool = False,
) -> int | None:
    """The line of an angle by two that are worked out.

    None where they have letters, unless it is sought ``in_letters``.
    """
    mark = scene.desk.mark()
    have_angles = turn.first.angle is not None and turn.second.angle is not None
    have_angles = have_angles or in_letters
    trees: list[Expression | None] = []
    refs: list[Ref] = []
    sides: list[Direction] = []
    whole: Any = sp.Integer(0)
    for side, factor in zip((turn.first, turn.second), _SIGNS[turn.form], strict=True):
        own = _in_numbers(scene, turn, side, angle_line, letters_too=have_angles)
        if own is None:
            scene.desk.back(mark)
            return None
        tree, known = own
        side_, known = _by_its_first_letter(scene, side, known, mark.lines)
        sides.append(side_)
        trees.append(tree)
        refs += known
        whole += factor * (0 if tree is None else scene.scalar(tree))
    if turn.form.startswith("rest"):
        whole += sp.pi
    letter, meaning = letter_of(scene, turn.asked)
    right = swept(turn.made_of(*trees))
    value = exact.plain_angle(whole)
    if value is None:
        final = swept(_collected(turn, trees) or _with_one_number(turn, trees) or right)
    else:
        final = tree_of(value, angle=True, as_it_is=True)
    relation = chain(Letter(letter), (right, None), (final, "rearrange"))
    names = [*map(partial(_by_its_name, scene), sides, trees)]
    by_names = chain(
        Letter(letter), (turn.made_of(*names), None), (right, "put"), (final, "rearrange")
    )
    components = (*turn.first.refs, *turn.second.refs)
    pool = dict.fromkeys((meaning, *refs, *components, *_axis(turn), *turn.frame.refs))
    premises = None
    if names != trees and not any(map(_is_arc, names)):
        premises = premises_of(scene, turn, pool, by_names, (meaning,))
    if premises is not None:
        relation = by_names
    else:
        premises = premises_of(scene, turn, pool, relation, (meaning,))
    if premises is None:
        earlier = [*dict.fromkeys((*_before_put(scene, turn), *pool))]
        premises = scene.judge.needed(turn.move, earlier, relation, (meaning,))
    if premises is None:
        scene.desk.back(mark)
        return None
    _without_arcs(scene, premises, mark.lines)
    return scene.desk.write(turn.move, premises, relation)


def _by_its_first_letter(
    scene: Scene, side: Direction, known: tuple[Ref, ...], since: int
) -> tuple[Direction, tuple[Ref, ...]]:
    """A direction by the letter of another angle that its own one is, where a new line says so.

    That line, and the one with the value, are not printed.
    """
    desk = scene.desk
    line = next((ref for ref in known if isinstance(ref, int) and ref > since), None)
    own = None if line is None else desk.line(line)
    if side.angle is not None or own is None or own.move.id != "put" or line is None:
        return side, known
    for ref in own.premises:
        above = desk.line(ref) if isinstance(ref, int) else None
        if above is None or above.move.record != "difference" or above.number <= since:
            continue
        link = desk.last_link(above.number)
        if not isinstance(link.right, Letter):
            continue
        for number in (line, above.number):
            desk.lines[number - 1] = replace(desk.line(number), shown="silent")
        rest = tuple(other for other in own.premises if other != ref)
        return replace(side, angle=link.right), together(rest, (above.number,), known[1:])
    return side, known


def _is_arc(tree: Expression | None) -> bool:
    return tree is not None and any(isinstance(node, Apply) for node in walk(tree))


def _by_its_name(scene: Scene, side: Direction, tree: Expression | None) -> Expression | None:
    """An angle that is an arctangent, or the like, by the letter that it has; else as it is."""
    if tree is None or not _is_arc(tree):
        return tree
    if isinstance(side.angle, Letter):
        return side.angle
    return Letter(letter_of(scene, side.named)[0]) if side.angle is None else tree


def _before_put(scene: Scene, turn: Turn) -> tuple[Ref, ...]:
    """The components of both velocities as they stood before values were put in.

    A coefficient that stands in them tells signs, by what is known of it.
    """
    refs: list[Ref] = []
    names: set[str] = set()
    for ref in (*turn.first.refs, *turn.second.refs):
        if isinstance(ref, int) and scene.desk.line(ref).move.id == "put":
            refs += scene.desk.line(ref).premises
    for ref in (*turn.first.refs, *turn.second.refs, *refs):
        own = scene.desk.line(ref).relation if isinstance(ref, int) else None
        if isinstance(own, Relation) and len(own.options) == 1:
            names |= letters(own.only[-1].right)
    return (*background(scene, names), *refs)


def _without_arcs(scene: Scene, premises: Iterable[Ref], since: int) -> None:
    """Takes the lines ``θ = arctan(2)`` off paper: the tangents say it, and so does the sum."""
    for ref in premises:
        if not isinstance(ref, int) or ref <= since:
            continue
        own = scene.desk.line(ref)
        arcs = isinstance(own.relation, Relation) and any(
            isinstance(node, Apply) and node.function.startswith("arc")
            for node in walk(own.relation.only[-1].right)
        )
        if own.move.id == "inverse" and arcs and not _is_by_data(scene, own):
            scene.desk.lines[ref - 1] = replace(own, shown="silent")


def _is_by_data(scene: Scene, line: Line) -> bool:
    """Whether the ratio behind an angle stands in no line."""
    return not any(
        isinstance(ref, int) and not isinstance(scene.desk.line(ref).relation, Meaning)
        for ref in line.premises
    )


def _terms(tree: Expression) -> list[tuple[int, Expression]]:
    """The terms of a sum of two, each with its sign: 90° − arctan(2) is of 90° and arctan(2)."""
    match tree:
        case Binary("+" | "-" as op, left, right):
            return [(1, left), (1 if op == "+" else -1, right)]
    return [(1, tree)]


def _with_one_number(turn: Turn, trees: Sequence[Expression | None]) -> Expression | None:
    """The angle with what is in degrees added up: 180° − 60° − arctan(2) is 120° − arctan(2)."""
    terms = [
        (sign * own, part)
        for sign, tree in zip(_SIGNS[turn.form], trees, strict=True)
        if tree is not None
        for own, part in _terms(tree)
    ]
    degrees = [Fraction(180 if turn.form.startswith("rest") else 0)]
    degrees += [sign * part.value for sign, part in terms if isinstance(part, Degrees)]
    others = [(sign, part) for sign, part in terms if not isinstance(part, Degrees)]
    if len([number for number in degrees if number]) < 2 or len(others) != 1:
        return None
    total_, ((sign, other),) = sum(degrees, Fraction(0)), others
    if total_ > 0:
        return Binary("+" if sign > 0 else "-", Degrees(total_), other)
    return Binary("-", other, Degrees(-total_)) if total_ and sign > 0 else None


def _collected(turn: Turn, trees: Sequence[Expression | None]) -> Expression | None:
    """The angle by twice another one, where both of which it is made are the same."""
    one, other = trees
    if one is None or one != other or turn.form not in ("sum", "rest of sum"):
        return None
    double = product(TWO, one)
    return double if turn.form == "sum" else Binary("-", STRAIGHT, double)


_SIGNS: Mapping[Form, tuple[int, int]] = {
    "sum": (1, 1),
    "difference": (1, -1),
    "rest of sum": (-1, -1),
    "rest of difference": (-1, 1),
}


def _axis(turn: Turn) -> tuple[Ref, ...]:
    return together(turn.frame.names_axis("along"), turn.frame.names_axis("across"))


def _in_numbers(
    scene: Scene,
    turn: Turn,
    side: Direction,
    angle_line: Callable[[Scene, Quantity], int],
    *,
    letters_too: bool,
) -> tuple[Expression | None, tuple[Ref, ...]] | None:
    """An angle to the line of centres in degrees, or as that of a number; None with letters."""
    if side.angle == NONE:
        return None, ()
    if side.angle is not None:
        own = () if side.angle == RIGHT else (*side.sources, *turn.frame.refs)
        if not letters(side.angle):
            return side.angle, own
        value, more = scene.put(scene.scalar(side.angle))
        if not value.free_symbols:
            return tree_of(value, angle=True), together(own, more)
        match side.angle:
            case Letter(name) if name in scene.ratio_facts:
                line = inverse_of_data(scene, name)
                return scene.desk.last_link(line).right, together(own, (line,))
            case Binary("+" | "-", Degrees(), Letter(name)) if name in scene.ratio_facts:
                line = inverse_of_data(scene, name)
                whole = replace(side.angle, right=scene.desk.last_link(line).right)
                return whole, together(own, (line,))
        return (side.angle, own) if letters_too else None
    ratio = tidy(side.across.value / side.along.value)
    if ratio.free_symbols and not letters_too:
        return None
    line = angle_of_an_offset(scene, side.named) or angle_line(scene, side.named)
    own_ = scene.desk.last_link(line)
    named = () if own_.left == side.named else (letter_of(scene, side.named)[1],)
    return own_.right, (line, *named)


def inverse_of_data(scene: Scene, name: str) -> int:
    """The line of an angle of which a ratio is given, by the inverse of that."""
    own, value, ref = given_ratio(scene, name)
    right: Expression = Apply(f"arc{own.function}", value)
    size = tidy(scene.scalar(right))
    if (size / sp.pi).is_Rational:
        right = tree_of(size, angle=True)  # 45°, and not arctan 1
    return scene.desk.write(
        Move("inverse"), (ref, range_of(scene, name)), chain(Letter(name), (right, None))
    )


def write_turn_tangent(scene: Scene, turn: Turn, subject: Expression) -> int | None:
    """The line of the tangent of an angle, by those of two others; None where they are not known.

    ``subject`` is the angle that is asked, or the letter for it.
    """
    mark = scene.desk.mark()
    terms, tangent = terms_of(scene, turn), None
    if terms is not None:
        relation = chain(subject, (turn.made_of(*(term.angle for term in terms)), None))
        number = made_of_angles(scene, turn, relation, together(*(term.same for term in terms)))
        if number is not None:
            tangent = by_tangents(scene, number, turn.form, terms, Apply("tan", subject))
    if tangent is None:
        scene.desk.back(mark)
    return tangent


def terms_of(scene: Scene, turn: Turn) -> tuple[Term, Term] | None:
    """Both angles with their tangents, which are written; None where one of them has none."""
    if not {turn.first.angle, turn.second.angle}.isdisjoint((RIGHT, NONE)):
        return None
    return _term(scene, turn.first), _term(scene, turn.second)


def made_of_angles(
    scene: Scene, turn: Turn, relation: Relation, given: tuple[Ref, ...]
) -> int | None:
    """The line that makes an angle of two others."""
    named = [
        letter_of(scene, side.named)[1] for side in (turn.first, turn.second) if side.angle is None
    ]
    subject = relation.only[0].left
    if isinstance(subject, Letter):
        named.append(letter_of(scene, turn.asked)[1])
    refs = (*turn.first.sources, *turn.second.sources)
    components = (*turn.first.refs, *turn.second.refs)
    axis = (*_axis(turn), *turn.frame.refs, *meeting(scene))
    pool = dict.fromkeys((*given, *named, *refs, *components, *turn.pushed, *axis))
    premises = premises_of(scene, turn, pool, relation, named)
    return None if premises is None else scene.desk.write(turn.move, premises, relation)


def premises_of(
    scene: Scene, turn: Turn, pool: Iterable[Ref], relation: Relation, sure: Iterable[Ref]
) -> tuple[Ref, ...] | None:
    """What the line of an angle made of two others rests on; None where it does not follow.

    A component with values put in, which nothing else needs, is cited as it stood before, unless it
    comes to 0; if it can be, without the ratios of an angle that were put in.
    """
    pool, sure = tuple(pool), tuple(sure)
    premises = scene.judge.needed(turn.move, pool, relation, sure)
    if premises is not None and not set(premises).isdisjoint(meeting(scene)):
        # Beside a root in a component that is left out it was needed; by itself it may not be.
        premises = scene.judge.needed(turn.move, premises, relation, sure)
    cited = {ref for line in scene.desk.lines for ref in line.premises}
    idle = {
        ref
        for ref in premises or ()
        if isinstance(ref, int) and scene.desk.line(ref).move.id == "put" and ref not in cited
        if scene.desk.last_link(ref).right != ZERO
    }
    if premises is None or not idle:
        return premises
    before = _before_put(scene, turn)
    earlier = (*(ref for ref in premises if ref not in idle), *before)
    plain = [
        ref
        for ref in dict.fromkeys((*pool, *before))
        if not isinstance(ref, int) or scene.desk.line(ref).move.id not in ("put", "triangle")
    ]
    without = scene.judge.needed(turn.move, plain, relation, sure)
    return without or scene.judge.needed(turn.move, earlier, relation, sure) or premises


def meeting(scene: Scene) -> tuple[Ref, ...]:
    """That spheres are not too far beside each other to meet, where the data are lengths."""
    return tuple(ref for ref in scene.facts if ref.startswith("offset "))


def _term(scene: Scene, side: Direction) -> Term:
    """An angle to the line of centres with its tangent."""
    if side.angle is None:
        own = formula(scene, side.named)
        if (same := _by_its_letter(scene, side, own.value)) is not None:
            return same
        own = _of_certain_sense(scene, side, own)
        line, letter = tangent_line(scene, side.named, own, own.move)
        term = Term(Letter(letter), scene.desk.last_link(line).right, (line,))
        return _with_its_first_letter(scene, term, line)
    return term_of_data(scene, side.angle)


def _of_certain_sense(scene: Scene, side: Direction, own: Formula) -> Formula:
    """The tangent of an angle, with what tells its sense where the components do not."""
    if not side.sources:
        return own
    letter, meaning = letter_of(scene, side.named)
    relation = chain(Apply("tan", Letter(letter)), (swept(own.right), None))
    names = {str(symbol) for symbol in sp.sympify(own.value, strict=True).free_symbols}
    refs = together(own.refs, (meaning,))
    if scene.judge.enough(own.move, refs, relation, background(scene, names)) is not None:
        return own
    return replace(own, refs=together(own.refs, side.sources))


def _with_its_first_letter(scene: Scene, term: Term, line: int) -> Term:
    """An angle by the letter that it has already: the lines with a second one are not printed."""
    desk = scene.desk
    for ref in desk.line(line).premises if desk.line(line).move.id == "put" else ():
        own = desk.line(ref) if isinstance(ref, int) else None
        if own is None or own.move.record != "difference" or not isinstance(ref, int):
            continue
        link = desk.last_link(ref)
        if link.left != term.angle or not isinstance(link.right, Letter):
            continue
        for number in (line, ref):
            desk.lines[number - 1] = replace(desk.line(number), shown="silent")
        rest = tuple(other for other in desk.line(line).premises if other != ref)
        return Term(link.right, term.tangent, rest, (ref,))
    return term


def _by_its_letter(scene: Scene, side: Direction, tangent: sp.Expr) -> Term | None:
    """The angle of a path to the line of centres in whose letter the components stand already.

    It has the value of the letter, where that is known.
    """
    known = letter_known(scene, side.named)
    symbol = None if known is None else scene.model.unknowns.letter(known[0])
    worth = None if symbol is None else scene.desk.known(Letter(symbol.name))
    if symbol is not None and worth is not None and worth.value.is_number:
        return Term(Letter(symbol.name), tree_of(tidy(tangent_of_angle(worth.value))), worth.refs)
    is_open = symbol is not None and (symbol in scene.kept or bool(scene.unknown(symbol)))
    if symbol is None or not is_open or tidy(tangent - sp.tan(symbol)) != 0:
        return None
    return Term(Letter(symbol.name), Apply("tan", Letter(symbol.name)))


def term_of_data(scene: Scene, angle: Expression) -> Term:
    """An angle of the data with its tangent: its value, where the angle was worked out."""
    tangent = Apply("tan", angle)
    if not isinstance(angle, Letter):
        value = tangent_of_angle(scene.scalar(angle))
        return Term(angle, tangent if value.free_symbols else tree_of(tidy(value)))
    if angle.name in scene.ratio_facts:
        ratio, worth, ref = given_ratio(scene, angle.name)
        if ratio == tangent:
            return Term(angle, worth, (ref,))
    symbol = scene.model.unknowns.letter(angle.name)
    if symbol not in scene.model.final or symbol in scene.free:
        return Term(angle, tangent)
    if scene.desk.known(tangent) is None:
        write_other_ratio(scene, symbol, "tan")
    known = scene.desk.known(tangent)
    return Term(angle, tangent) if known is None else Term(angle, tree_of(known.value), known.refs)


def by_tangents(
    scene: Scene,
    base: Ref | None,
    form: Form,
    terms: Sequence[Term],
    turned: Expression,
    given: tuple[Expression, tuple[Ref, ...]] | None = None,
) -> int | None:
    """The tangent of an angle that a line, or a fact, makes of two others; None without one.

    There is no ``base`` where the sum or the difference itself stands in the tangent.
    ``turned`` is the tangent that is sought, or the value that is given for it; with ``given`` it
    is a tangent of which the value is given, with what gives it. Of a cotangent that is sought the
    quotients stand the other way up.
    """
    upside_down = is_function(turned, "cot")
    doubled = form == "sum" and terms[0] == terms[1]
    first, second = map(_tangent, terms)
    own = _tangent_of_twice(first) if doubled else tangent_of(form, first, second)
    names = {name for term in terms for name in letters(term.angle)}
    known = (*background(scene, names), *meeting(scene))
    asked = is_function(turned, "tan", "cot")
    own = _turned_over(own) if upside_down else own
    relation = chain(turned, (own, None)) if asked else chain(own, (turned, None))
    bases = () if base is None else (base,)
    move = Move("identity", "double-angle" if doubled else "sum-of-angles")
    refs = scene.judge.enough(move, bases, relation, known)
    if refs is None:
        return None
    number = scene.desk.write(move, refs, relation)
    if given is None and all(_tangent(term) == term.tangent for term in terms):
        return number
    tangents = [term.tangent for term in terms]
    by_one = _by_one_multiple(scene, form, tangents)
    both = scene.scalar(product(*tangents))
    if tidy(both) == (-1 if form.endswith("difference") else 1):
        raise NotPlannedError("a right angle has no tangent")
    both_tree = tree_of(tidy(both)) if both.free_symbols else None
    if by_one is not None:
        both_tree = by_one[0]
    elif both_tree is not None and _has_sine_or_cosine(both_tree):
        own_product = _in_its_tangents(scene, tangents, lambda p, q: p * q)
        both_tree = both_tree if own_product is None else tree_of(own_product, as_it_is=True)
    put = swept(
        _tangent_of_twice(tangents[0], both_tree)
        if doubled
        else tangent_of(form, tangents[0], tangents[1], both_tree)
    )

    def whole(p: sp.Expr, q: sp.Expr) -> sp.Expr:
        value = _tangent_by(form, p, q)
        return 1 / value if upside_down else value

    own_value = _in_its_tangents(scene, tangents, whole)
    put = _turned_over(put) if upside_down else put
    final = tree_of(tidy(scene.scalar(put)))
    if by_one is not None:
        final = _turned_over(by_one[1]) if upside_down else by_one[1]
    elif own_value is not None:
        in_its_tangents = tree_of(own_value, as_it_is=True)
        # A product shows its sign.
        is_shorter = _degree(in_its_tangents) < _degree(final)
        final = in_its_tangents if is_shorter or _has_sine_or_cosine(final) else final
    if not asked and given is None:
        # The value that is given stays where it stands.
        refs = (number, *together(*(term.refs for term in terms)))
        # A product of tangents may be shorter by sin² + cos² = 1 alone.
        plain = swept(tangent_of(form, tangents[0], tangents[1]))
        for tree in (put,) if doubled else dict.fromkeys((put, plain)):
            line = _with_values(scene, refs, known, (tree, final), turned)
            if line is not None:
                return line
        return None
    by: MoveId = "rearrange"
    between = ((tree, by) for tree in multiplied_through(scene, put, final))
    subject = turned if given is None else given[0]
    relation = chain(subject, (put, None), *between, (final, by))
    sources = together(*(term.refs for term in terms), () if given is None else given[1])
    refs = scene.judge.enough(Move("put"), (number, *sources), relation, known)
    return None if refs is None else scene.desk.write(Move("put"), refs, relation)


def _turned_over(tree: Expression) -> Expression:
    """The reciprocal of a quotient, of which top and bottom change places; of another, one over."""
    match tree:
        case Binary("/", above, below):
            return Binary("/", below, above)
    return Binary("/", ONE, tree)


def _by_one_multiple(
    scene: Scene, form: Form, tangents: Sequence[Expression]
) -> tuple[Expression, Expression] | None:
    """The product of two tangents that are multiples of tan 2α, and that of the angle, by that.

    None where no such tangent stands in them, or several.
    """
    nodes = {node for tree in tangents for node in walk(tree) if is_function(node, "tan")}
    if len(nodes) != 1:
        return None
    (ratio,) = nodes
    assert isinstance(ratio, Apply)
    if isinstance(ratio.argument, Letter) or not letters(ratio):
        return None
    t = sp.Symbol("t", positive=True)
    p, q = (scene.worth(exchanged(tree, {ratio: Letter("t")}), {"t": t}) for tree in tangents)
    if (p * q).free_symbols != {t}:
        return None
    whole = tidy(_tangent_by(form, p, q))
    by_letter = (tree_of(tidy(p * q)), tree_of(whole))
    both, own = (exchanged(tree, {Letter("t"): ratio}) for tree in by_letter)
    return both, own


def _tangent_by(form: Form, p: sp.Expr, q: sp.Expr) -> sp.Expr:
    """The tangent of an angle by those of the two of which it is made."""
    both = p * q - 1 if form == "rest of sum" else 1 - p * q if form == "sum" else 1 + p * q
    return ((p + q) if "sum" in form else (p - q) if form == "difference" else (q - p)) / both


def _has_sine_or_cosine(tree: Expression) -> bool:
    """Whether a tree has a sine or a cosine."""
    return any(is_function(node, "sin", "cos") for node in walk(tree))


def _degree(tree: Expression) -> Fraction:
    """The greatest power in a tree."""
    powers = (node.right for node in walk(tree) if is_binary(node, "^"))
    return max((own.value for own in powers if isinstance(own, Number)), default=Fraction(1))


def _in_its_tangents(
    scene: Scene,
    tangents: Sequence[Expression],
    made_of: Callable[[sp.Expr, sp.Expr], sp.Expr],
) -> sp.Expr | None:
    """What is made of two tangents, in the tangents of letters in these; None without."""
    values = [in_tangents(scene.scalar(tangent)) for tangent in tangents]
    own = sorted({ratio for value in values for ratio in value.atoms(sp.tan)}, key=str)
    if not own or any(value.has(sp.sin, sp.cos) for value in values):
        return None
    letters_ = {tangent: sp.Dummy("Dummy", n, positive=True) for n, tangent in enumerate(own)}
    p, q = (value.xreplace(letters_) for value in values)
    back = {letter: tangent for tangent, letter in letters_.items()}
    value = made_of(p, q)
    bars = value.atoms(sp.Abs)
    if len(bars) == 1:
        return _with_one_size(value, *bars).xreplace(back)
    return tidy(value).xreplace(back)


def _with_one_size(value: sp.Expr, bar: sp.Expr) -> sp.Expr:
    """A quotient with one size in it, that stands in the first power: its square has no bars."""
    size = sp.Dummy("size", positive=True)
    rest = sp.cancel(value.xreplace({bar: size}) / size)
    plain = rest.xreplace({size**power: bar.args[0] ** power for power in (2, 4)})
    return tidy(value) if plain.has(size) else tidy(plain) * bar


def _with_values(
    scene: Scene,
    refs: Sequence[Ref],
    known: Sequence[Ref],
    sides: tuple[Expression, Expression],
    value: Expression,
) -> int | None:
    """The equation of a tangent with values put in, and in its shortest form."""
    (put, final), line = sides, None
    mark = scene.desk.mark()
    for tree in dict.fromkeys((put, final)):
        moves = (
            [Move("put")] if line is None else [Move("rearrange"), Move("identity", "pythagoras")]
        )
        relation = chain(tree, (value, None))
        own = refs if line is None else (line,)
        for move in moves:
            premises = scene.judge.enough(move, own, relation, known)
            if premises is not None:
                line = scene.desk.write(move, premises, relation)
                break
        else:
            scene.desk.back(mark)
            return None
    return line


def _tangent(term: Term) -> Expression:
    """The tangent of an angle, as one of which the value is not yet put in."""
    plain = isinstance(term.angle, Letter | Degrees)
    return Apply("tan", term.angle) if plain or letters(term.tangent) else term.tangent


def _tangent_of_twice(p: Expression, squared: Expression | None = None) -> Expression:
    """The tangent of twice an angle, by that of the angle and by its square."""
    return Binary("/", product(TWO, p), difference(ONE, squared or square(p)))


def tangent_of(
    form: Form, p: Expression, q: Expression, both: Expression | None = None
) -> Expression:
    """The tangent of an angle by those of the two of which it is made, and by their product."""
    both = swept(product(p, q)) if both is None else both
    match form:
        case "sum":
            return Binary("/", total((p, q)), difference(ONE, both))
        case "difference":
            return Binary("/", difference(p, q), Binary("+", ONE, both))
        case "rest of sum":
            return Binary("/", total((p, q)), difference(both, ONE))
    return Binary("/", difference(q, p), Binary("+", ONE, both))
