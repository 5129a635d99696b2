"""Components of velocities of the data: as the data have them, by a size and an angle."""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import atoms_in, symbol_names
from restitution.expression.tree import Apply, Expression, Polar, letters, walk
from restitution.planning.writing.degrees import by_degrees
from restitution.planning.writing.desk import Source
from restitution.planning.writing.forms import neat, negative, product, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene

_RATIOS = ("sin", "cos", "tan")


def is_polar(scene: Scene, body: str) -> bool:
    """Whether a velocity at the start is given by its size and an angle."""
    fact = scene.facts.get(f"velocity {body}")
    if fact is None:
        return False
    (link,) = fact.relation.only
    return any(isinstance(node, Polar) for node in walk(link.right))


def with_its_ratio(value: sp.Expr, put: sp.Expr, frame: Frame) -> Expression | None:
    """A component as a speed times the number of its cosine, ``(5u/4)(4/5)``, ``5 × 0.8``.

    None where one sees that in what it comes to, as the speed is letters alone (``4u/5``), and at a
    wall where the speed is in letters and no fraction: its law has the ratio (``5u sin α``).
    """
    ratios = atoms_in(value, sp.sin, sp.cos)
    if len(ratios) != 1 or value.is_Add or put.has(*ratios):
        return None
    size = tidy(value / next(iter(ratios)))
    share = tidy(put / size)
    number, rest = size.as_coeff_Mul()
    seen = number.is_Integer if frame.wall else abs(number) == 1
    if not share.is_Rational or not number.is_Rational or (seen and rest != 1):
        return None
    own = product(tree_of(abs(number) * rest), tree_of(abs(share)))
    return negative(own) if (number < 0) != (share < 0) else own


def has_a_speed_put_in(scene: Scene, body: str, frame: Frame, source: Source) -> bool:
    """Whether a component along the line of centres has the value of a speed that was found."""
    if scene.last_event(body, frame.number - 1) or not is_polar(scene, body):
        return False
    if scene.desk.known(frame.component("along", body, 0)) is not None:
        return False
    own = neat(scene.initial(body).value.dot(frame.direction("along")))
    ratios = atoms_in(own, sp.sin, sp.cos)
    size = own.xreplace(dict.fromkeys(ratios, sp.Integer(1)))
    return bool(ratios) and not size.free_symbols <= source.value.free_symbols


def by_its_ratio(
    scene: Scene, kind: str, body: str, frame: Frame, source: Source
) -> Expression | None:
    """A component at the start by what has a value in it: ``5 sin α``, ``u sin 60°``.

    None where the velocity is not given by its size and an angle, or where the component keeps
    the ratio, or stands in a line of its own.
    """
    if scene.last_event(body, frame.number - 1) or not is_polar(scene, body):
        return None
    if source.form is not None or scene.desk.known(frame.component(kind, body, 0)) is not None:
        return None
    value = neat(scene.initial(body).value.dot(frame.direction(kind)))
    form = by_degrees(scene, kind, body, frame, value)
    if form is not None:
        # The angle is a number, and the speed has been found.
        own = symbol_names(source.value)
        return form if letters(form) - own else None
    ratios = atoms_in(value, sp.sin, sp.cos)
    if value.is_Add or len(ratios) != 1 or not any(ratio.free_symbols for ratio in ratios):
        return None
    return None if source.value.has(*ratios) else tree_of(value)


def as_in_the_data(scene: Scene, body: str, frame: Frame, source: Source) -> Expression | None:
    """A component along the line of an impact as the data have it, where no line has its value."""
    return before_a_wall(scene, body, frame, source) or by_its_angle(scene, body, frame, source)


def by_its_angle(scene: Scene, body: str, frame: Frame, source: Source) -> Expression | None:
    """A component along the line of centres by a number of degrees: ``2√2 cos 45°``.

    None where a line has what it is worth, and of any other.
    """
    form = source.form
    if form is None or frame.wall is not None or scene.last_event(body, frame.number - 1):
        return None
    if scene.desk.known(frame.component("along", body, 0)) is not None:
        return None
    return form if has_ratios(form) else None


def has_ratios(tree: Expression) -> bool:
    """Whether a ratio of an angle stands in a tree."""
    return any(isinstance(node, Apply) and node.function in _RATIOS for node in walk(tree))


def before_a_wall(scene: Scene, body: str, frame: Frame, source: Source) -> Expression | None:
    """A component towards a wall as the data have it, ``√5 u sin α``, where that comes to u.

    It is used once more after the law at the wall, and no line has what it is worth. None where
    one sees that from a speed without a root.
    """
    tree = by_its_ratio(scene, "along", body, frame, source) if frame.wall else None
    lost = set() if tree is None else _roots(scene.scalar(tree)) - _roots(source.value)
    return tree if lost else None


def _roots(value: sp.Expr) -> set[sp.Basic]:
    """The roots of numbers in a value."""
    powers = sp.sympify(value, strict=True).atoms(sp.Pow)
    return {e for e in powers if e.is_number and e.exp.is_Rational and e.exp.q == 2}
