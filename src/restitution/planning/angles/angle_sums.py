"""A sum or difference of angles that is given: by the tangents of both, or as a complement."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.degrees import tangent as tangent_of_angle
from restitution.explaining.lines.derivation import Link, Move, Ref, Relation
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    has_quantity,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turn_lines import Term, by_tangents, tangent_of
from restitution.planning.formulas.impacts import scene_value
from restitution.planning.formulas.named_angles import letter_of
from restitution.planning.formulas.turns import Form
from restitution.planning.writing.angles import RIGHT
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import (
    ONE,
    difference,
    in_tangents,
    product,
    square,
    swept,
    tree_of,
)
from restitution.planning.writing.polynomials import derivative, expanded
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene


def is_sum(scene: Scene, equation: GivenEquation) -> bool:
    """Whether a fact ties two angles by their sum or difference, one of which has a letter."""
    return _terms(scene, equation) is not None


def write_sum_with(scene: Scene, equation: GivenEquation) -> int | None:
    """The same of an angle of the motion that has no letter in the statement: it is given one.

    None of another fact, and where there is no equation.
    """
    sides = (equation.link.left, equation.link.right)
    nodes = (node for side in sides for node in walk(side))
    angles = {node for node in nodes if isinstance(node, Quantity) and _is_to_a_line(node)}
    if len(angles) != 1:
        return None
    (angle,) = angles
    mark = scene.desk.mark()
    name, meaning = letter_of(scene, angle)
    left, right = (exchanged(side, {angle: Letter(name)}) for side in sides)
    line = scene.judge.write(
        (Move("fact"),), (equation.fact.id, meaning), chain(left, (right, None))
    )
    own = replace(equation, link=Link(left, equation.link.sign, right))
    try:
        if line is not None and is_sum(scene, own):
            return write_sum(scene, own, line)
    except NotPlannedError:
        pass
    scene.desk.back(mark)
    return None


def _is_to_a_line(quantity: Quantity) -> bool:
    """Whether a quantity is the angle of a velocity to a line."""
    match quantity:
        case Quantity("angle", (Quantity("velocity"), other)):
            return not is_quantity(other, "velocity")
    return False


def _terms(scene: Scene, equation: GivenEquation) -> tuple[str, str, int, sp.Expr] | None:
    """Two letters, the sign of the second (the first has +), and what the sum is worth.

    The sign is 2 where the first is twice the second.
    """
    sides = _sides(equation)
    names = list(dict.fromkeys(name for side in sides for name in sorted(letters(side))))
    if len(names) != 2 or any(has_quantity(side) for side in sides):
        return None
    if not any(_quantity(scene, own) is not None for own in names):
        return None
    first, second = (scene.model.unknowns.letter(own) for own in names)
    if not (isinstance(first, sp.Symbol) and isinstance(second, sp.Symbol)):
        return None
    left, right = (scene_value(scene, side) for side in sides)
    gap = expanded(left - right)
    a, b = (derivative(gap, own) for own in (first, second))
    if {abs(a), abs(b)} == {1, 2} and a * b < 0 and gap.subs({first: 0, second: 0}) == 0:
        twice, once = names if abs(a) == 1 else names[::-1]
        # Where the statement gives the smaller angle, its double is put in for the other.
        moved = _quantity(scene, once) is not None
        return (twice, once, 2, sp.Integer(0)) if moved else None
    if abs(a) != 1 or abs(b) != 1:
        return None
    rest = gap.subs({first: 0, second: 0})
    if a == -1 and b == 1:
        names, a, b = names[::-1], b, a
    return names[0], names[1], int(a * b), tidy(-a * rest)


def _sides(equation: GivenEquation) -> tuple[Expression, Expression]:
    """The sides of a fact about angles; of one about the tangent of a sum, the angles."""
    match equation.link:
        case Link(Apply("tan", Binary("+" | "-") as angles), "=", right) if not (
            letters(right) or has_quantity(right)
        ):
            return angles, Apply("arctan", right)
    return equation.link.left, equation.link.right


def _quantity(scene: Scene, name: str) -> Quantity | None:
    """The angle for which a letter stands, or which is given as that letter."""
    fact = scene.facts.get(f"let {name}")
    own = scene.desk.meant(Letter(name)) if fact is None else fact.relation.only[0].left
    if not isinstance(own, Quantity):
        own = next(
            (
                equation.link.left
                for equation in scene.given
                if (equation.link.sign, equation.link.right) == ("=", Letter(name))
            ),
            own,
        )
    return own if is_quantity(own, "angle", "direction") else None


def stated(scene: Scene, equation: GivenEquation) -> int:
    """A fact about letters as a line; what a letter in it stands for is put in by another one."""
    line = scene.desk.write(Move("fact"), (equation.fact.id,), equation.fact.relation)
    if not equation.lets:
        return line
    opened = Relation(((equation.link,),))
    put = scene.judge.write((Move("put"), Move("rearrange")), (*equation.lets, line), opened)
    if put is None:
        raise NotPlannedError("what a letter stands for is not put in")
    return put


def write_sum(scene: Scene, equation: GivenEquation, line: int | None = None) -> int:
    """The equation in tangents, perhaps from a line of the fact in letters.

    Raises NotPlannedError where there is none.
    """
    terms = _terms(scene, equation)
    assert terms is not None
    *names, sign, angle = terms
    if (alone := _of_one_that_is_known(scene, names)) is not None:
        return alone
    tangents: list[Expression] = []
    refs: list[Ref] = []
    for name in names:
        tree, own = _tangent(scene, Letter(name))
        tangents.append(tree)
        refs += own
    form: Form = "sum" if sign == 1 else "difference"
    base: Ref = line or (stated(scene, equation) if equation.lets else equation.fact.id)
    ranges = background(scene, names)
    subjects = [Apply("tan", Letter(name)) for name in names]
    if sign == -1 and angle == 0:
        return _write_same(scene, base, subjects, tangents, refs)
    if sign == 2:
        below = difference(ONE, square(subjects[1]))
        doubled = Binary("/", product(Number(Fraction(2)), subjects[1]), below)
        relation: Relation = chain(subjects[0], (doubled, None))
        move = Move("identity", "double-angle")
    elif angle == sp.pi / 2 and sign == 1:
        relation = chain(product(*subjects), (ONE, None))
        move = Move("identity", "complement")
    else:
        value = tree_of(tidy(tangent_of_angle(angle)))
        relation = chain(tangent_of(form, subjects[0], subjects[1]), (value, None))
        move = Move("identity", "sum-of-angles")
    own_refs = scene.judge.enough(move, (base,), relation, ranges)
    if own_refs is None and move.record == "complement":
        own_refs = _by_the_other(scene, base, names, relation, ranges)
    if own_refs is None:
        raise NotPlannedError("a sum of angles")
    number = scene.desk.write(move, own_refs, relation)
    values = dict(zip(subjects, tangents, strict=True))
    link = scene.desk.last_link(number)
    left = _with(link.left, values)
    both = scene.scalar(product(*tangents))
    if move.record == "sum-of-angles" and both.free_symbols:
        # The product of both is one term: 3 tan²α.
        left = swept(tangent_of(form, tangents[0], tangents[1], tree_of(tidy(both))))
    put = chain(left, (_with(link.right, values), None))
    premises = scene.judge.enough(Move("put"), (number, *together(refs)), put, ranges)
    if premises is None:
        raise NotPlannedError("a sum of angles")
    return scene.desk.write(Move("put"), premises, put)


def _of_one_that_is_known(scene: Scene, names: Sequence[str]) -> int | None:
    """The tangent of an angle of the motion of which a line gives the number of degrees."""
    for name in names:
        known = scene.desk.known(Letter(name))
        if known is None or _quantity(scene, name) is None or not known.value.is_number:
            continue
        _, (line,) = _tangent(scene, Letter(name))
        assert isinstance(line, int)
        tangent = Apply("tan", tree_of(known.value, angle=True))
        relation = chain(tangent, (scene.desk.last_link(line).right, None))
        return scene.judge.write((Move("put"),), (line, *known.refs), relation)
    return None


def write_tangent_of_sum(scene: Scene, letter: Letter) -> int | None:
    """The line of the tangent of an angle that the statement makes of two others; None of another.

    Both are letters, for angles of the data or of the motion.
    """
    fact = scene.facts.get(f"let {letter.name}")
    if fact is None:
        return None
    return _of_two_letters(scene, fact.relation.only[0].left, letter, fact.id)


def write_tangent_of_two(scene: Scene, asked: Expression) -> int | None:
    """The line of a tangent of which two letters for angles are the sum or difference."""
    match asked:
        case Apply("tan", Binary("+" | "-", Letter(), Letter()) as angle):
            return _of_two_letters(scene, angle, angle)
    return None


def _of_two_letters(
    scene: Scene, angle: Expression, called: Expression, base: Ref | None = None
) -> int | None:
    """The line of the tangent of a sum or difference of two letters; None of another angle."""
    match angle:
        case Binary("+" | "-" as sign, Letter() as first, Letter() as second):
            pass
        case _:
            return None
    mark = scene.desk.mark()
    form: Form = "sum" if sign == "+" else "difference"
    try:
        terms = [Term(letter, *_tangent(scene, letter)) for letter in (first, second)]
    except NotPlannedError:
        scene.desk.back(mark)
        return None
    line = by_tangents(scene, base, form, terms, Apply("tan", called))
    if line is None:
        scene.desk.back(mark)
    return line


def _write_same(
    scene: Scene,
    base: Ref,
    subjects: Sequence[Expression],
    tangents: Sequence[Expression],
    refs: Sequence[Ref],
) -> int:
    """Two angles that are the same: the tangent of one is put in for that of the other."""
    move = Move("put")
    if len(refs) < 2:
        # The other one is of the data.
        last = chain(tangents[0], (tangents[1], None))
        line = scene.judge.write((move,), (*refs, base), last)
    else:
        first = chain(subjects[1], (tangents[0], None))
        middle = scene.judge.write((move,), (refs[0], base), first)
        last = chain(tangents[0], (tangents[1], None))
        line = None if middle is None else scene.judge.write((move,), (middle, refs[1]), last)
    if line is None:
        raise NotPlannedError("two angles that are the same")
    return line


def _by_the_other(
    scene: Scene,
    base: Ref,
    names: Sequence[str],
    relation: Relation,
    ranges: Sequence[Ref],
) -> tuple[Ref, ...] | None:
    """What two complements rest on, of which the sum is given: one of them by the other."""
    moved = [name for name in names if _quantity(scene, name) is not None]
    for name in moved:
        (other,) = (own for own in names if own != name)
        alone = chain(Letter(name), (Binary("-", RIGHT, Letter(other)), None))
        if scene.judge.follows(Move("rearrange"), (base,), alone):
            line = scene.desk.write(Move("rearrange"), (base,), alone)
            return scene.judge.enough(Move("identity", "complement"), (line,), relation, ranges)
    return None


def _with(tree: Expression, values: Mapping[Any, Expression]) -> Expression:
    return swept(rebuilt(tree, lambda tree: values.get(tree, tree)))


def _tangent(scene: Scene, letter: Letter) -> tuple[Expression, tuple[Ref, ...]]:
    """The tangent of an angle, by components where the letter stands for one of the motion."""
    quantity = _quantity(scene, letter.name)
    if quantity is None:
        return Apply("tan", letter), ()
    standing = _standing_tangent(scene, letter)
    if standing is not None:
        return scene.desk.last_link(standing).right, (standing,)
    own = formula(scene, quantity)
    _, meaning = letter_of(scene, quantity)
    own = replace(own, quantity=letter, refs=together((meaning,), own.refs))
    value: Any = tidy(own.value)
    final = tree_of(in_tangents(value))
    number = scene.desk.write(
        own.move, own.refs, chain(own.left, (swept(own.right), None), (final, "rearrange"))
    )
    return final, (number,)


def _standing_tangent(scene: Scene, letter: Letter) -> int | None:
    """The line of a tangent that stands, with the letters put in that are known since."""
    tangent = Apply("tan", letter)
    for line in reversed(scene.desk.lines):
        own = line.relation
        if not isinstance(own, Relation) or len(own.options) != 1 or own.only[0].left != tangent:
            continue
        if scene.desk.holds(line.number) and all(link.sign == "=" for link in own.only):
            put, refs = scene.put(scene.scalar(own.only[-1].right))
            if not refs:
                return line.number
            relation = chain(tangent, (tree_of(in_tangents(tidy(put))), None))
            return scene.judge.write((Move("put"),), (line.number, *refs), relation)
    return None


__all__ = ["is_sum", "stated", "write_sum", "write_sum_with", "write_tangent_of_sum"]
