"""Trees of a statement laid out as they are written there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from fractions import Fraction as Ratio
from functools import lru_cache

from restitution.expression import tree as trees
from restitution.expression.quantities import KINDS
from restitution.records import dataclass
from restitution.render.layout.algebra import decimal_number, plain_number
from restitution.render.layout.builders import (
    bracketed,
    function,
    letter,
    power,
    product,
    root,
    total,
)
from restitution.render.layout.nodes import (
    Bold,
    Brackets,
    Coordinates,
    Degrees,
    Fraction,
    Layout,
    Letter,
    Number,
    Phrase,
    Power,
    Product,
    Root,
    Sum,
    Words,
)


@dataclass(frozen=True)
class EventNames:
    """How the events of a story are called, by number; those that are not there keep theirs.

    ``after`` and ``during`` are words for when a quantity is taken, ``times`` stand for the times
    of events.
    """

    after: Mapping[int, str] = field(default_factory=dict)
    during: Mapping[int, str] = field(default_factory=dict)
    times: Mapping[int, Layout] = field(default_factory=dict)


_NUMBERED = EventNames()


def from_tree(node: trees.Expression, events: EventNames = _NUMBERED) -> Layout:
    """The layout of an expression as it was written in a statement."""
    match node:
        case trees.Rounded(value, figures):
            return decimal_number(value, figures)
        case trees.Number(value):
            return _typed_number(value)
        case trees.RoundedDegrees(value, figures):
            return Degrees(decimal_number(value, figures))
        case trees.Degrees(value):
            return Degrees(_typed_number(value))
        case trees.Pi():
            return Letter("pi")
        case trees.Letter(name):
            return letter(name)
        case trees.Unit(axis):
            return Bold(axis)
        case trees.Name(name):
            return Words(name)
        case trees.Pair(x, y):
            return Coordinates((from_tree(x, events), from_tree(y, events)))
        case trees.Polar():
            return _from_polar(node, events)
        case trees.Negate(operand):
            inner = from_tree(operand, events)
            return Sum((("-", bracketed(inner)),))
        case trees.Apply(name, argument):
            return _from_apply(name, from_tree(argument, events))
        case trees.Binary():
            return _from_binary(node, events)
        case trees.Quantity():
            return _from_quantity(node, events)


@lru_cache(maxsize=1024)
def _typed_number(value: Ratio) -> Layout:
    """A number with all the decimals with which it was typed; one without end as a fraction."""
    for places in range(4, 13):
        scaled = value * 10**places
        if scaled.denominator == 1 and 1000 % value.denominator:
            digits = f"{scaled.numerator:0{places + 1}}"
            return Number(f"{digits[:-places]}.{digits[-places:]}".rstrip("0"))
    return plain_number(value)


def _from_apply(name: str, argument: Layout) -> Layout:
    if name == "sqrt":
        return Root(argument)
    if name == "abs":
        return Brackets(argument, "||")
    return function(name, argument)


def _from_binary(node: trees.Binary, events: EventNames) -> Layout:
    match node:
        case trees.Binary(
            "/", trees.Binary("*", factor, trees.Number() as top), trees.Number()
        ) if node.place is not None:
            # 0.9 * 1/2 as it is typed is read from the left, and meant as 0.9 × ½.
            node = trees.Binary("*", factor, trees.Binary("/", top, node.right))
    left, right = from_tree(node.left, events), from_tree(node.right, events)
    match node.op:
        case "+":
            # Two vectors, such as an old position and a change of it.
            if _has_terms(left) and _is_vector(node.left) and trees.has_unit_vector(node.right):
                left = Brackets(left)
            if _has_terms(right) and _is_vector(node.right) and trees.has_unit_vector(node.left):
                right = Brackets(right)
            return total([left, bracketed(right) if _is_negation(right) else right])
        case "-":
            several = _has_terms(right) or _is_vector(node.left)
            if _has_terms(left) and several and trees.has_unit_vector(node.right):
                left = Brackets(left)  # a change of velocity: one vector minus another
            parts = left.terms if isinstance(left, Sum) else (("+", left),)
            return Sum((*parts, ("-", bracketed(right))))
        case "*":
            if _ends_in_number(left) and _begins_with_digit(right):
                return product(left, right, sign="×")
            if not isinstance(left, Number) and _begins_with_number(right):
                return product(left, right, sign="×")
            if isinstance(left, Letter | Root | Product) and _is_fraction_of_numbers(right):
                return product(left, right, sign="×")  # 2m × ⅘, not 2m⅘
            if isinstance(right, Product) and _begins_with_digit(right):
                return product(left, Brackets(right))  # 2m(3u), not 2m3u
            if _has_a_root(left) and _has_a_root(right):
                return product(left, Brackets(right))  # √2 eu(√2 u), and no √2√2
            return product(left, right)
        case "/":
            return Fraction(left, right)
        case "^":
            match right:
                case Fraction(Number("1"), Number(index)) if index.isdigit():
                    return root(left, int(index))
            return power(left, right)


def _has_a_root(layout: Layout) -> bool:
    """Whether a root is a factor of a product, beside letters."""
    return isinstance(layout, Product) and any(isinstance(e, Root) for e in layout.factors)


def _has_terms(layout: Layout) -> bool:
    return isinstance(layout, Sum) and len(layout.terms) > 1


def _is_vector(node: trees.Expression) -> bool:
    """Whether a tree is a multiple of **i** and one of **j**."""
    if not isinstance(node, trees.Binary) or node.op not in ("+", "-"):
        return False
    left, right = (
        {node for node in trees.walk(side) if isinstance(node, trees.Unit)}
        for side in (node.left, node.right)
    )
    return left == {trees.Unit("i")} and right == {trees.Unit("j")}


def _is_negation(layout: Layout) -> bool:
    return isinstance(layout, Sum) and len(layout.terms) == 1


def _ends_in_number(layout: Layout) -> bool:
    if isinstance(layout, Product):
        return _ends_in_number(layout.factors[-1])
    return isinstance(layout, Number | Fraction | Power) and (
        not isinstance(layout, Power) or isinstance(layout.base, Number)
    )


def _begins_with_number(layout: Layout) -> bool:
    """Whether a factor is a number, or a product that begins with one: ``u × 2v``."""
    if isinstance(layout, Product) and layout.sign == "":
        layout = layout.factors[0]
    return isinstance(layout, Number)


def _is_fraction_of_numbers(layout: Layout) -> bool:
    match layout:
        case Fraction(Number(), Number()):
            return True
    return False


def _begins_with_digit(layout: Layout) -> bool:
    while isinstance(layout, Product | Power):
        layout = layout.factors[0] if isinstance(layout, Product) else layout.base
    return isinstance(layout, Number | Degrees) or (
        isinstance(layout, Fraction) and _begins_with_digit(layout.above)
    )


def _from_polar(node: trees.Polar, events: EventNames) -> Layout:
    parts: list[Layout] = [from_tree(node.size, events), Words("at"), from_tree(node.angle, events)]
    if node.wall is not None:
        parts += [Words("to"), from_tree(node.wall, events)]
    elif node.origin is not None:
        parts += [Words("from"), from_tree(node.origin, events)]
    return Phrase(tuple(parts))


def _from_quantity(node: trees.Quantity, events: EventNames) -> Layout:
    arguments = [from_tree(argument, events) for argument in node.arguments]
    if node.kind == "time" and isinstance(node.stage, int) and node.stage in events.times:
        return events.times[node.stage]
    main = _quantity(node.kind, node.arguments, arguments)
    when = _stage(node, events)
    return main if when is None else Phrase((*_opened(main), *when))


def _opened(layout: Layout) -> tuple[Layout, ...]:
    if isinstance(layout, Phrase) and layout.separator == " ":
        return layout.items
    return (layout,)


def _quantity(kind: str, written: tuple[trees.Expression, ...], arguments: list[Layout]) -> Layout:
    named = len(written) == 1 and isinstance(written[0], trees.Name)
    if kind == "velocity" and named:
        return Bold("v", _name(written[0]))
    if kind == "line_of_centres" or not arguments:
        return Words(KINDS[kind].called_of_all)
    if kind == "abs":
        return Brackets(arguments[0], "||")
    if kind == "dot":
        return product(*arguments, sign="·")
    if kind == "along":
        return Phrase((Words("component of"), arguments[0], Words("along"), arguments[1]))
    if kind == "across":
        return Phrase(
            (
                Words("component of"),
                arguments[0],
                Words("perpendicular to"),
                arguments[1],
            )
        )
    between = [item for argument in arguments for item in (argument, Words("and"))][:-1]
    return Phrase((Words(KINDS[kind].in_formulas), *between))


def _name(node: trees.Expression) -> str:
    return node.name if isinstance(node, trees.Name) else ""


def _stage(node: trees.Quantity, events: EventNames) -> tuple[Layout, ...] | None:
    match node.stage:
        case None:
            return None
        case "before":
            return (Words("before the impact"),)
        case trees.AtTime(time):
            return (Words("at time"), from_tree(time, events))
        case 0:
            return (Words("at the start"),)
        case number:
            names, word = events.during, "in event"
            if KINDS[node.kind].before:
                names, word = events.after, "after event"
            elif node.kind == "time":
                names, word = {}, "of event"
            return (Words(names.get(number, f"{word} {number}")),)
