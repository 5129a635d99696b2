"""Components by scalar products with the direction in which they are."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import atoms_in
from restitution.explaining.lines.derivation import (
    Link,
    Move,
    MoveId,
    Relation,
    Showing,
)
from restitution.expression.evaluate import in_letters
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    is_binary,
    letters,
    unsigned,
)
from restitution.planning.writing.circles import circle_of
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    neat,
    product,
    reordered,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene
from restitution.planning.writing.unit_vectors import whole_direction
from restitution.vector import Vector


def by_scalar_product(
    scene: Scene,
    quantity: Quantity,
    source: Source,
    frame: Frame,
    direction: Vector,
    form: Expression | None = None,
    exact: sp.Expr | None = None,
) -> Source:
    """A component of a vector of numbers in a direction that is one: a line of its own.

    ``form`` is how the component is written, where it is no scalar product; ``exact`` what it is
    worth before values are put in, where that is known.
    """
    (body,) = body_of(quantity)
    exact = neat(source.value.dot(direction)) if exact is None else exact
    value, more = scene.put(exact)
    value, refs = tidy(value), together(source.refs, more, frame.refs)
    move = Move("define", "component", frame.number, (body,))
    last = tree_of(value)
    if form is None and not more and circle_of(scene, frame.number) is not None:
        # Elsewhere the line stands among scalar products with a unit vector, and is one of them.
        form = _whole_size(source.value, direction)
    if form is None and frame.number in scene.desk.paths:
        form = _with_a_ratio(exact)  # by the angle with the path
    if form is None and more and not scene.last_event(body, frame.number - 1):
        form = _with_a_ratio(exact)
    by: MoveId = "rearrange" if form is None or letters(form) == letters(last) else "define"
    written = form or scalar_product(scene.put(source.value)[0], direction)
    if any(ratio.args[0].is_Add for ratio in atoms_in(value, sp.sin, sp.cos)):
        number = scene.desk.write(move, refs, chain(quantity, (written, None)))
        refs, move, written = (number,), Move("identity", "sum-of-angles"), last
    if reordered(written, last):
        links: tuple[Link, ...] = (Link(quantity, "=", written),)
    elif _is_over_a_root(written):
        links = (Link(quantity, "=", written), Link(written, "=", last, by))
    else:
        links = chain(quantity, (written, None), (last, by)).only
    # What is at rest has no component in any direction: nobody writes that down.
    shown: Showing = "line" if any(source.value) else "silent"
    number = scene.desk.write(move, refs, Relation((links,)), shown)
    return scene.desk.know(quantity, value, (number,))


def _whole_size(vector: Vector, direction: Vector) -> Expression | None:
    """The size of a vector of numbers that is along a direction, by its components.

    None of any other vector, and of one along **i** or **j**.
    """
    if not all(part.is_Rational and part for part in vector) or vector.cross(direction) != 0:
        return None
    size = Apply("sqrt", total(square(tree_of(abs(part))) for part in vector))
    return size if vector.dot(direction) > 0 else Negate(size)


def by_the_angle_of_the_line(scene: Scene, kind: str, body: str, frame: Frame) -> Expression | None:
    """A component by the letter of the angle of a line of centres, of which a ratio is given."""
    fact = scene.facts.get(f"axis {frame.number}")
    if fact is None or not frame.is_slanted or frame.direction(kind).x.free_symbols:
        return None
    if fact.id not in frame.refs:
        return None  # the line stands as that of a vector
    match fact.relation.only:
        case (Link(_, "=" | "parallel to", Letter() as angle),):
            turn = in_letters(angle)
        case _:
            return None
    along = Vector(sp.cos(turn), sp.sin(turn))
    direction = along if kind == "along" else along.turned_left()
    return _with_a_ratio(neat(scene.initial(body).value.dot(direction)))


def _with_a_ratio(value: sp.Expr) -> Expression | None:
    """A component as a speed times a sine or a cosine; None of any other."""
    ratios = value.atoms(sp.sin, sp.cos)
    return tree_of(value) if len(ratios) == 1 and not value.has(sp.Add) else None


def _is_over_a_root(tree: Expression) -> bool:
    """Whether a product is over the root that is the length of a direction: ``u/√2``."""
    own = unsigned(tree)
    return is_binary(own, "/") and isinstance(own.right, Apply)


def scalar_product(vector: Vector, direction: Vector) -> Expression:
    """The scalar product with a unit vector as a line has it: of whole numbers over a length."""
    whole, length = whole_direction(direction)
    terms = total(product(tree_of(a), tree_of(b)) for a, b in zip(whole, vector, strict=True))
    return swept(terms if length == 1 else Binary("/", terms, tree_of(length)))


def body_of(component: Quantity) -> tuple[str, ...]:
    """The body of which a quantity is a component of the velocity."""
    return tuple(
        argument.arguments[0].name
        for argument in component.arguments
        if isinstance(argument, Quantity)
        and argument.arguments
        and isinstance(argument.arguments[0], Name)
    )
