"""Ratios of the angle between two vectors, by their scalar product or the cosine rule."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move, Ref
from restitution.explaining.lines.trees import trees_of
from restitution.expression.tree import (
    Apply,
    Expression,
    Letter,
    Polar,
    Quantity,
    walk,
)
from restitution.planning.angles.lines_between import (
    cosine_of,
)
from restitution.planning.angles.scalar_angles import (
    is_long,
    write_cosine,
    write_right_angle,
)
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.named_angles import (
    letter_of,
    ratio_line,
)
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    swept,
    tree_of,
)
from restitution.planning.writing.premises import background, sign_known
from restitution.planning.writing.ratio_of_an_angle import RANGES, Ratio
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import short_direction
from restitution.vector import Vector


def is_vector_in_numbers(scene: Scene, body: str) -> bool:
    """Whether a velocity at the start is given as a vector of numbers with **i** and **j**."""
    fact = scene.facts.get(f"velocity {body}")
    if fact is None or isinstance(fact.relation.only[0].right, Polar):
        return False
    return not any(value.free_symbols for value in scene.initial(body).value)


def is_right_angle(scene: Scene, own: Formula) -> bool:
    """Whether what stands below in a tangent vanishes, or the angle is none."""
    return bool(own.value.is_number and (own.value.is_infinite or own.value == 0))


def by_scalar(
    scene: Scene,
    move: Move,
    sources: list[Source],
    asked: Quantity,
    sizes: tuple[Expression | None, Expression | None] = (None, None),
) -> Ratio | int:
    """An angle between two vectors that are known, by their scalar product.

    ``sizes`` are those of the vectors, where they are known too.
    """
    a, b = (source.value for source in sources)
    pairs = [(tree_of(p), tree_of(q)) for p, q in zip(a, b, strict=True)]
    right, value = cosine_of(pairs, a, b, sizes)
    if not has_its_product(scene, asked):
        own = _by_directions(scene, move, sources, asked, right)
        if own is not None:
            return own
    if is_long(right) or has_its_product(scene, asked):
        if value == 0 and (line := write_right_angle(scene, asked)) is not None:
            return line
        own = by_cosine(scene, asked)
        if own is not None:
            return own
    letter, meaning = letter_of(scene, asked)
    refs = together((meaning,), *(source.whole for source in sources))
    line = ratio_line(scene, move, refs, Apply("cos", Letter(letter)), right, value)
    return Ratio(line, letter, "cos", value, RANGES["deflection"].format(letter))


def _by_directions(
    scene: Scene, move: Move, sources: list[Source], asked: Quantity, right: Expression
) -> Ratio | None:
    """The cosine by short vectors of numbers in the directions of both: their sizes cancel.

    None of vectors of numbers that are short themselves, of a direction with letters or along **i**
    or **j**, of one that the data give by an angle, and at right angles.
    """
    by_angles = {
        fact.id
        for fact in scene.desk.facts
        if any(isinstance(e, Polar) for tree in trees_of(fact.relation) for e in walk(tree))
    }
    if any(by_angles & set(source.refs) for source in sources):
        return None
    vectors = [
        Vector(*(tidy(scene.put(component)[0]) for component in source.value)) for source in sources
    ]
    if not is_long(right) and not all(_has_letters(vector) for vector in vectors):
        return None
    a, b = (short_direction(vector, scene.model.sign) for vector in vectors)
    if a is None or b is None or 0 in (*a, *b) or tidy(a.dot(b)) == 0 or tidy(a.cross(b)) == 0:
        return None
    pairs = [(tree_of(p), tree_of(q)) for p, q in zip(a, b, strict=True)]
    shorter, value = cosine_of(pairs, a, b)
    if is_long(shorter):
        return None
    mark = scene.desk.mark()
    letter, meaning = letter_of(scene, asked)
    ratio = Apply("cos", Letter(letter))
    more = (ref for source in sources for part in source.value for ref in scene.put(part)[1])
    pool = together((meaning,), *(source.whole for source in sources), more)
    names = {name for vector in vectors for part in vector for name in symbol_names(part)}
    relation = chain(ratio, (swept(shorter), None))
    refs = scene.judge.enough(move, pool, relation, background(scene, names))
    if refs is None:
        scene.desk.back(mark)
        return None
    line = ratio_line(scene, move, refs, ratio, shorter, value)
    return Ratio(line, letter, "cos", value, RANGES["deflection"].format(letter))


def _has_letters(vector: Vector) -> bool:
    return any(sp.sympify(component, strict=True).free_symbols for component in vector)


def has_its_product(scene: Scene, asked: Quantity) -> bool:
    """Whether a line gives the scalar product of the velocities of an angle."""
    pair = asked.arguments
    products = (Quantity("dot", factors) for factors in (pair, pair[::-1]) if len(factors) == 2)
    return any(scene.desk.known(product) is not None for product in products)


def by_cosine(scene: Scene, asked: Quantity) -> Ratio | None:
    """The cosine of an angle between two velocities by lines for their product and both speeds."""
    line = write_cosine(scene, asked)
    if line is None:
        return None
    letter, _ = letter_of(scene, asked)
    value = tidy(scene.scalar(scene.desk.last_link(line).right))
    return Ratio(line, letter, "cos", value, RANGES["deflection"].format(letter))


def is_nested(square_: sp.Expr) -> bool:
    """Whether the square of a cosine has a root in it: the tangent is plainer then."""
    return not tidy(square_).is_Rational


def own_size(scene: Scene, vector: Vector) -> tuple[Ref, ...]:
    """What has to be known for the only component of a vector to be its size."""
    parts = [component for component in vector if component != 0]
    return sign_known(scene, parts[0]) if len(parts) == 1 else ()


def vectors_in_numbers(scene: Scene, body: str, event: int, a: Vector, b: Vector) -> bool:
    """Whether both velocities are vectors of numbers with **i** and **j**."""
    if any(sp.sympify(value, strict=True).free_symbols for value in (*a, *b)):
        return False
    fact = scene.facts.get(f"velocity {body}")
    if scene.last_event(body, event - 1) or fact is None:
        return False
    return not any(isinstance(side, Polar) for side in (fact.relation.only[0].right,))
