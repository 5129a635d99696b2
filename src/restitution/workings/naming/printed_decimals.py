"""Fractions that an answer has printed as decimals, and that are decimals from then."""

from __future__ import annotations

from fractions import Fraction

from restitution.explaining.lines.derivation import Derivation, Link
from restitution.explaining.lines.trees import exchanged, rebuilt, trees_of
from restitution.expression.tree import (
    Binary,
    Expression,
    Negate,
    Number,
    Unit,
    is_binary,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.render import layout as lay
from restitution.render.text import to_text
from restitution.workings.naming.measured import as_decimal
from restitution.workings.naming.row_sides import is_vector_of_short_decimals

_TEN = 10


class PrintedDecimals:
    """The fractions of a working that stand as decimals in an answer: 2.2𝐢 + 5.35𝐣.

    A fraction that was typed stays as it was typed.
    """

    def __init__(self, derivation: Derivation, among_decimals: bool) -> None:
        # Where the data are decimals a number is one, too: 5.8.
        self._numbers = among_decimals
        relations = [fact.relation for fact in derivation.facts]
        self._typed = {
            abs(value)
            for relation in relations
            for tree in trees_of(relation)
            for value in _fractions(tree)
        }
        self._printed: set[Fraction] = set()
        # Those that rows have as fractions: 11/5.
        self._as_fractions: set[Fraction] = set()
        # What stands below those of quantities that have a unit: the 5 of 7/5 m s⁻¹.
        self._parts: set[int] = set()
        # Whether they are the components of a vector.
        self._has_a_vector = False
        # Vectors that stand as decimals: there a typed fraction is one as well.
        self._vectors: dict[Expression, Expression] = {}
        # Their components.
        self._components: set[Fraction] = set()

    def put(
        self, trees: list[Expression], *, measured: bool = False, of_vectors: bool = False
    ) -> list[Expression]:
        """The sides of a chain with these decimals; what they come to is a decimal too.

        So is what any ``measured`` quantity comes to, which has a unit, where no fraction stands.
        Where all numbers are components ``of_vectors``, and in a sum of two squares, those are
        decimals that a vector above has so, though they were typed as fractions elsewhere.
        """
        if not self._printed:
            return trees
        if measured and not self._as_fractions and self._is_short(trees[-1]):
            self._note(trees[-1])
        own = [rebuilt(exchanged(tree, self._vectors), self._decimal) for tree in trees]
        component = self._component if of_vectors else self._squared
        own = [rebuilt(tree, component) for tree in own]
        if own == trees:
            return trees
        if own[-1] == trees[-1]:
            own[-1] = as_decimal(own[-1])
            self._note(trees[-1])
        return own

    def _is_short(self, tree: Expression) -> bool:
        """Whether a value is a fraction of at most two decimals, or a vector of such."""
        own = unsigned(tree)
        if _is_in_components(own):
            values = _fractions(own)
            return bool(values) and all(100 % value.denominator == 0 for value in values)
        values = _fractions(own)[:1] if is_binary(own, "/") else []
        return any(100 % value.denominator == 0 for value in values)

    def keeps_fractions(self, tree: Expression) -> bool:
        """Whether a vector has fractions, and rows above have all of them, or such, or one like it.

        Where components are fifths, the vector that is made of them has fifths too.
        """
        own = set(map(abs, _fractions(tree)))
        beside = self._has_a_vector and not self._printed
        alike = {value.denominator for value in own} <= self._parts and not self._printed
        return bool(own) and (beside or alike or own <= self._as_fractions)

    def note(
        self, link: Link, tree: Expression, side: lay.Layout, sign: str, *, measured: bool = False
    ) -> None:
        """Notes the components of a vector, or a number, that a row has as decimals now.

        Or the fractions that it has, of a ``measured`` quantity or of a ratio.
        """
        match side:
            case lay.Phrase((lay.Brackets(inside) | inside, lay.Words()), _):
                side = inside
        number = self._numbers and isinstance(unsigned(tree), Number)
        vector = not number and is_vector_of_short_decimals(side)
        if sign == "=" and (number or vector):
            self._note(link.right)
            if vector:
                self._vectors[link.right] = rebuilt(link.right, as_decimal)
                self._components |= set(map(abs, _fractions(link.right)))
        elif sign == "=" and "." not in to_text(side) and not letters(link.right):
            own = unsigned(link.right)
            fractions = {abs(value) for value in _fractions(own) if value.denominator > 2}
            self._as_fractions |= fractions
            velocity = not is_quantity(link.left, "line_of_centres", "direction")
            self._has_a_vector |= velocity and bool(fractions) and _is_in_components(link.right)
            if measured and is_binary(own, "/"):
                parts = {value.denominator for value in fractions}
                self._parts |= {part for part in parts if part < _TEN}

    def in_decimals(self, tree: Expression) -> Expression:
        """A tree with decimals for its fractions, but for those that were typed."""
        return rebuilt(tree, self._untyped)

    def _untyped(self, tree: Expression) -> Expression:
        match tree:
            case Binary("/", Number(above), Number(below)) if above / below not in self._typed:
                return as_decimal(tree)
        return tree

    def _note(self, tree: Expression) -> None:
        self._printed |= {abs(value) for value in _fractions(tree)} - self._typed

    def _decimal(self, tree: Expression) -> Expression:
        match tree:
            case Binary("/", Number(above), Number(below)) if above / below in self._printed:
                return Number(above / below)
        return tree

    def _component(self, tree: Expression) -> Expression:
        match tree:
            case Binary("/", Number(above), Number(below)) if above / below in self._components:
                return Number(above / below)
        return tree

    def _squared(self, tree: Expression) -> Expression:
        match tree:
            case Binary("+", Binary("^", one, Number(2)), Binary("^", other, Number(2) as power)):
                squares = (Binary("^", self._component(base), power) for base in (one, other))
                return Binary("+", *squares)
        return tree


def _is_in_components(tree: Expression) -> bool:
    """Whether a vector is written by its two components, or by one: (22/5)𝐢 + 5𝐣."""
    match tree:
        case Binary("+" | "-", left, right):
            return _is_in_components(left) and _is_in_components(right)
        case Negate(operand):
            return _is_in_components(operand)
        case Binary("*", component, Unit()):
            return not letters(component)
    return isinstance(tree, Unit)


def _fractions(tree: Expression) -> list[Fraction]:
    """The fractions of two numbers in a tree that are decimals with an end."""
    return [
        node.left.value / node.right.value
        for node in walk(tree)
        if isinstance(node, Binary)
        and isinstance(node.left, Number)
        and isinstance(node.right, Number)
        and node.op == "/"
        and as_decimal(node) != node
    ]


__all__ = ["PrintedDecimals"]
