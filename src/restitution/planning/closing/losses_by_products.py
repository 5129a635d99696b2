"""The kinetic energy lost where both spheres move and the components after are long sums.

The squares of these are not multiplied out. Each difference of squares is a product, of which one
factor is a change of momentum: by the one law that is the same for both, by the other the rest is
what the speeds of approach and separation differ by.
"""

from __future__ import annotations

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Move, Ref, Relation
from restitution.expression.tree import Binary, Expression, Letter, Quantity
from restitution.planning.closing.excluded_roots import written_law
from restitution.planning.formulas.energy_formulas import half
from restitution.planning.formulas.impacts import in_direction
from restitution.planning.writing.desk import Source, chain, together
from restitution.planning.writing.forms import (
    ONE,
    TWO,
    difference,
    negative,
    product,
    square,
    swept,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import expanded, one_fraction
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene

# A sum of so many terms is squared.
_SQUARED = 2
_SPHERES = 2
_HALF = Binary("/", ONE, TWO)


def write_loss_by_products(scene: Scene, quantity: Quantity) -> int | None:
    """The line of the energy that an impact takes; None where the squares are plain enough."""
    event = quantity.stage
    if quantity.kind != "energy_lost" or not isinstance(event, int) or scene.others:
        return None
    if event not in scene.model.frames or len(scene.spheres(event)) != _SPHERES:
        return None
    if scene.desk.known(quantity) is not None:
        return None
    mark = scene.desk.mark()
    line = _Loss(scene, quantity, event).write()
    if line is None:
        scene.desk.back(mark)
    return line


class _Loss:
    """The energy that one impact of two spheres takes."""

    def __init__(self, scene: Scene, quantity: Quantity, event: int) -> None:
        self.scene = scene
        self.quantity = quantity
        self.event = event
        self.frame = scene.frame(event)
        self.bodies = tuple(scene.spheres(event))

    def write(self) -> int | None:
        """The lines, of which the last is returned."""
        scene, event = self.scene, self.event
        early = [in_direction(scene, "along", b, event - 1, self.frame) for b in self.bodies]
        letters = [self._letter(body) for body in self.bodies]
        laws = [written_law(scene, record, event) for record in ("momentum", "restitution")]
        if None in letters or None in laws or any(source.value == 0 for source in early):
            return None
        values = [scene.desk.known(Letter(letter.name)) for letter in letters if letter is not None]
        known = [value for value in values if value is not None]
        if len(known) != len(letters) or not any(_is_long(source.value) for source in known):
            return None
        if any(scene.put(source.value)[1] for source in known):
            return None
        w, x = (Letter(letter.name) for letter in letters if letter is not None)
        return self._products(early, w, x, known[1], [law for law in laws if law is not None])

    def _letter(self, body: str) -> sp.Symbol | None:
        """The letter for the component of a sphere after the impact."""
        own = self.scene.desk.known(self.frame.component("along", body, self.event))
        return own.value if own is not None and own.value.is_Symbol else None

    def _products(
        self, early: list[Source], w: Letter, x: Letter, known: Source, laws: list[int]
    ) -> int | None:
        scene = self.scene
        a, b = (source.value for source in early)
        masses = [scene.mass(body) for body in self.bodies]
        one, other = (tree_of(mass.value) for mass in masses)
        first, second = tree_of(a), tree_of(b)
        change = total((x, negative(second)))
        approach = tidy(a - b)
        squares = [
            half(mass, difference(square(u), square(v)))
            for mass, u, v in ((one, first, w), (other, second, x))
        ]
        parts = (
            product(half(one, difference(first, w)), total((first, w))),
            negative(product(half(other, change), total((x, second)))),
        )
        move = Move("define", "energy-lost", self.event, self.bodies)
        refs = together(
            *(mass.refs for mass in masses),
            *(source.whole for source in early),
            self.frame.names_axis("along"),
            scene.desk.meanings(laws),
        )
        start = chain(self.quantity, (swept(total(squares)), None), (total(parts), "rearrange"))
        line = self._written((move,), refs, start)
        by_momentum = chain(product(one, difference(first, w)), (product(other, change), None))
        rest = difference(total((first, w)), total((x, second)))
        line = self._put(line, laws[0], by_momentum, product(half(other, change), rest))
        e = scene.coefficient(self.event).value
        less = tree_of(tidy(1 - e))
        by_restitution = chain(rest, (product(less, tree_of(approach)), None))
        share = product(_HALF, less, other, change, tree_of(approach))
        line = self._put(line, laws[1], by_restitution, share)
        if line is None:
            return None
        changed = tidy(one_fraction(expanded(known.value - b)))
        sums = chain(change, (tree_of(changed), None))
        factor = self._written((Move("rearrange"),), known.refs, sums)
        if factor is None:
            return None
        value = tidy(masses[1].value * (1 - e) * changed * approach / 2)
        last = chain(self.quantity, (tree_of(value), None))
        line = self._written((Move("put", "factors"),), (line, factor), last)
        if line is not None:
            scene.desk.know(self.quantity, value, (line,))
        return line

    def _put(self, line: int | None, law: int, relation: Relation, right: Expression) -> int | None:
        """The loss with a factor put in, as a law gives it."""
        factor = None if line is None else self._written((Move("rearrange"),), (law,), relation)
        if line is None or factor is None:
            return None
        put = chain(self.quantity, (right, None))
        return self._written((Move("put", "factors"),), (line, factor), put)

    def _written(
        self, moves: tuple[Move, ...], refs: tuple[Ref, ...], relation: Relation
    ) -> int | None:
        names = symbol_names(self.scene.scalar(relation.only[-1].right))
        return self.scene.judge.write(
            moves, (*refs, *background(self.scene, names)), relation, refs
        )


def _is_long(value: sp.Expr) -> bool:
    """Whether the square of a component would be multiplied out in many terms."""
    above = sp.fraction(one_fraction(value))[0]
    return len(sp.Add.make_args(expanded(above))) > _SQUARED


__all__ = ["write_loss_by_products"]
