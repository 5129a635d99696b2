"""Expressions as immutable trees: what a statement says, before any algebra is done with it.

A tree remembers how it was written (``1/2 u`` is not ``u/2``) and where (line and column);
two trees are equal when they say the same, wherever they stood. No number library is needed
to hold one.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import field, fields
from fractions import Fraction
from functools import lru_cache
from typing import Any, Literal, TypeGuard, TypeVar, get_args, overload

from restitution.records import compared, dataclass

_Kind = TypeVar("_Kind")


@dataclass(frozen=True, slots=True)
class Place:
    """Where something was said: line and column, both counted from 1."""

    line: int
    column: int


def line_and_column(place: Place | None) -> tuple[int | None, int | None]:
    """A place as the two numbers that an error takes; both None where nothing is known."""
    return (None, None) if place is None else (place.line, place.column)


class Node:
    """A node of a tree; it keeps what is asked for often: its hash, its inside, its letters."""

    __slots__ = ("_functions", "_hash", "_inside", "_letters", "_quantity")


def keeps_hash(kind: type[_Kind]) -> type[_Kind]:
    """A frozen dataclass of which the hash is worked out once, and compared before what is inside.

    It is not pickled: strings have another hash in another process.
    """
    get = compared(kind)

    def kept(node: Any) -> int:
        try:
            return node._hash  # type: ignore[no-any-return]
        except AttributeError:
            value = hash(get(node))
            object.__setattr__(node, "_hash", value)
            return value

    def same(node: Any, other: Any) -> Any:
        if node is other:
            return True
        if type(other) is not type(node):
            return NotImplemented
        try:
            if node._hash != other._hash:
                return False
        except AttributeError:  # one has not been asked for its hash, which an array has not
            pass
        own, others = get(node), get(other)
        return own is others or own == others

    setattr(kind, "__hash__", kept)  # noqa: B010 - a type has no place for it that mypy knows
    setattr(kind, "__eq__", same)  # noqa: B010
    if not hasattr(kind, "__slots__"):
        setattr(kind, "__getstate__", _without_hash)  # noqa: B010
    return kind


def _without_hash(value: object) -> dict[str, Any]:
    return {name: state for name, state in vars(value).items() if name != "_hash"}


@keeps_hash
@dataclass(frozen=True, slots=True)
class Number(Node):
    """An exact number as typed: ``3``, ``0.6``, ``60%``; never negative."""

    value: Fraction
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Rounded(Number):
    """A number that is carried to so many significant figures, zeros at its end among them."""

    figures: int


@keeps_hash
@dataclass(frozen=True, slots=True)
class Degrees(Node):
    """A number of degrees: ``60°``."""

    value: Fraction
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class RoundedDegrees(Degrees):
    """A number of degrees that is carried to so many significant figures."""

    figures: int


RIGHT_ANGLE, STRAIGHT_ANGLE = Degrees(Fraction(90)), Degrees(Fraction(180))


@keeps_hash
@dataclass(frozen=True, slots=True)
class Pi(Node):
    """The number π."""

    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Letter(Node):
    """A letter, by its canonical name: ``u``, ``alpha``, ``e_1``, ``v_A``."""

    name: str
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@lru_cache(maxsize=1024)
def plain_letter(name: str) -> Letter:
    """A letter that stands in no text: always the same object, which is found without comparing."""
    return Letter(name)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Unit(Node):
    """A unit vector, **i** or **j**."""

    axis: Literal["i", "j"]
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Name(Node):
    """The name of a sphere, a wall or a point of the statement."""

    name: str
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Pair(Node):
    """Components or coordinates: ``(3, -4)``."""

    x: Expression
    y: Expression
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Polar(Node):
    """A vector by size and direction: ``5 at 60°``.

    The angle is measured anticlockwise from ``origin`` (**i** if None), or, where ``wall`` is
    given instead, towards that wall from its left.
    """

    size: Expression
    angle: Expression
    origin: Expression | None = None
    wall: Expression | None = None
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Negate(Node):
    """``-x``."""

    operand: Expression
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Binary(Node):
    """``left op right``; multiplication left out is ``*`` all the same."""

    op: Literal["+", "-", "*", "/", "^"]
    left: Expression
    right: Expression
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Apply(Node):
    """A function of one argument: ``sqrt sin cos tan cot sec cosec arcsin arccos arctan abs``."""

    function: str
    argument: Expression
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@keeps_hash
@dataclass(frozen=True, slots=True)
class Measured(Node):
    """A value with its unit, as typed: ``5 m/s``.

    It lives only while a text is read: a Problem is in SI, and holds none. ``stretch`` is the
    line and column at which the unit begins, blanks before it included, and at which it ends.
    """

    operand: Expression
    unit: str
    stretch: tuple[int, int, int, int] = (1, 1, 1, 1)
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


@dataclass(frozen=True, slots=True)
class AtTime:
    """The stage ``at t`` of ``position(A, at t)``."""

    time: Expression


Stage = int | Literal["before"] | AtTime | None


@keeps_hash
@dataclass(frozen=True, slots=True)
class Quantity(Node):
    """A quantity of the motion: ``speed(P, 2)`` is ``Quantity("speed", (Name("P"),), 2)``.

    ``stage`` None means *now*: after the events told where the quantity stands.
    """

    kind: str
    arguments: tuple[Expression, ...] = ()
    stage: Stage = None
    place: Place | None = field(default=None, compare=False, repr=False, kw_only=True)


Expression = (
    Number | Degrees | Pi | Letter | Unit | Name | Pair | Polar | Negate | Binary | Apply | Quantity
)

FUNCTIONS = (
    "sqrt",
    "sin",
    "cos",
    "tan",
    "cot",
    "sec",
    "cosec",
    "arcsin",
    "arccos",
    "arctan",
    "abs",
)

GREEK = (
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "zeta",
    "eta",
    "theta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "rho",
    "sigma",
    "tau",
    "upsilon",
    "phi",
    "chi",
    "psi",
    "omega",
)


def rational(value: Fraction) -> Expression:
    """A rational number as people type it: a sign, a whole number, or one over another."""
    if value < 0:
        return Negate(rational(-value))
    whole = Number(Fraction(value.numerator))
    return (
        whole if value.denominator == 1 else Binary("/", whole, Number(Fraction(value.denominator)))
    )


def children(node: Expression) -> tuple[Expression, ...]:
    """The expressions directly inside a node, in the order written."""
    match node:
        case Binary(_, left, right):
            return left, right
        case Apply(_, inside) | Negate(inside):
            return (inside,)
    if type(node) in LEAVES:
        return ()
    branches: list[Expression] = []
    for name in PARTS[type(node)]:
        value = getattr(node, name)
        if type(value) in PARTS:
            branches.append(value)
        elif isinstance(value, AtTime):
            branches.append(value.time)
        elif isinstance(value, tuple):
            branches.extend(item for item in value if type(item) in PARTS)
    return tuple(branches)


# Trees are walked often: the fields of a node in which there may be others, by its kind.
PARTS: dict[type, tuple[str, ...]] = {
    kind: tuple(
        field_of_kind.name for field_of_kind in fields(kind) if field_of_kind.name != "place"
    )
    for kind in (*get_args(Expression), Measured, Rounded, RoundedDegrees)
}
LEAVES: frozenset[type] = frozenset(
    {Number, Rounded, Degrees, RoundedDegrees, Pi, Letter, Unit, Name}
)


def walk(node: Expression) -> tuple[Expression, ...]:
    """A node and all that stands inside it, outermost first."""
    try:
        return node, *node._inside  # type: ignore[union-attr]
    except AttributeError:
        return node, *_inside(node)


def _inside(node: Expression) -> tuple[Expression, ...]:
    """All nodes inside of one, which keeps them: not itself, so that no circle arises."""
    nodes: list[Expression] = []
    pending = list(reversed(children(node)))
    while pending:  # a long sum is a deep tree: no recursion
        current = pending.pop()
        nodes.append(current)
        kind = type(current)
        if kind is Binary:
            pending += (current.right, current.left)  # type: ignore[union-attr]
        elif kind not in LEAVES:
            pending.extend(reversed(children(current)))
    inside = tuple(nodes)
    object.__setattr__(node, "_inside", inside)
    return inside


def letters(node: Expression) -> frozenset[str]:
    """The names of the letters in an expression."""
    try:
        return node._letters  # type: ignore[no-any-return, union-attr]
    except AttributeError:
        names: set[str] = {node.name} if type(node) is Letter else set()
        pending = list(children(node))
        while pending:  # what is put together of others knows theirs
            current = pending.pop()
            known = getattr(current, "_letters", None)
            if known is not None:
                names |= known
            elif type(current) is Letter:
                names.add(current.name)
            else:
                pending += children(current)
        kept = frozenset(names)
        object.__setattr__(node, "_letters", kept)
        return kept


def functions_in(node: Expression) -> frozenset[str]:
    """The names of the functions in an expression."""
    try:
        return node._functions  # type: ignore[no-any-return, union-attr]
    except AttributeError:
        names: set[str] = {node.function} if type(node) is Apply else set()
        pending = list(children(node))
        while pending:  # what is put together of others knows theirs
            current = pending.pop()
            known = getattr(current, "_functions", None)
            if known is not None:
                names |= known
                continue
            if type(current) is Apply:
                names.add(current.function)
            pending += children(current)
        kept = frozenset(names)
        object.__setattr__(node, "_functions", kept)
        return kept


def has_quantity(node: Expression) -> bool:
    """Whether an expression speaks of the motion, not of letters and numbers alone."""
    try:
        return node._quantity  # type: ignore[no-any-return, union-attr]
    except AttributeError:
        has_one = type(node) is Quantity
        pending = [] if has_one else list(children(node))
        while pending and not has_one:
            current = pending.pop()
            known = getattr(current, "_quantity", None)
            has_one = type(current) is Quantity if known is None else known
            pending += children(current) if known is None else ()
        object.__setattr__(node, "_quantity", has_one)
        return has_one


@overload
def unsigned(tree: Expression) -> Expression: ...
@overload
def unsigned(tree: None) -> None: ...
def unsigned(tree: Expression | None) -> Expression | None:
    """A tree without the minus sign in front of it."""
    return tree.operand if isinstance(tree, Negate) else tree


def negated(tree: Expression) -> Expression:
    """A tree with the other sign; no sign stands twice."""
    return tree.operand if isinstance(tree, Negate) else Negate(tree)


def is_quantity(node: object, *kinds: str) -> TypeGuard[Quantity]:
    """Whether a node is a quantity of one of the kinds."""
    return isinstance(node, Quantity) and node.kind in kinds


COMPONENTS = ("along", "across")
"""The kinds of components of a vector: in a direction, and perpendicular to it."""


def is_component(node: object) -> TypeGuard[Quantity]:
    """Whether a node is a component of a vector."""
    return is_quantity(node, *COMPONENTS)


def is_vector(tree: Expression) -> bool:
    """Whether an expression is a vector, from the way it is written."""
    return any(isinstance(node, Unit | Pair) for node in walk(tree))


def terms_of(tree: Expression) -> Iterator[Expression]:
    """The terms of a sum, or of a difference; a minus before the first of them stays with it."""
    if is_binary(tree, "+", "-"):
        yield from terms_of(tree.left)
        yield from terms_of(tree.right)
    else:
        yield tree


def unsigned_terms(tree: Expression) -> Iterator[Expression]:
    """The terms of a sum, or of a difference, without any sign."""
    if isinstance(tree, Negate):
        yield from unsigned_terms(tree.operand)
    elif is_binary(tree, "+", "-"):
        yield from unsigned_terms(tree.left)
        yield from unsigned_terms(tree.right)
    else:
        yield tree


def has_unit_vector(tree: Expression) -> bool:
    """Whether **i** or **j** stands in an expression."""
    return any(isinstance(node, Unit) for node in walk(tree))


EXACT_ANGLE = 15
"""Degrees: multiples of it have ratios made of roots."""


def has_standard_ratios(degrees: Fraction) -> bool:
    """Whether pupils know the ratios of an angle by heart: those of 30° and 45°, not of 15°."""
    return not degrees % 30 or not degrees % 45


def quantities_in(tree: Expression) -> Iterator[Quantity]:
    """The quantities in an expression, outer ones first, as often as they stand in it."""
    return (node for node in walk(tree) if isinstance(node, Quantity))


def is_rest(velocity: object) -> bool:
    """Whether a velocity is that of a body at rest."""
    return isinstance(velocity, Pair) and is_zero(velocity.x) and is_zero(velocity.y)


def name_of(tree: Expression) -> str | None:
    """The name that an expression is, if it is one."""
    return tree.name if isinstance(tree, Name) else None


def letter_nodes(tree: Expression) -> Iterator[Letter]:
    """The letters in an expression, as often as they stand in it."""
    return (node for node in walk(tree) if isinstance(node, Letter))


def has_operator(tree: Expression, *signs: str) -> bool:
    """Whether a sum, product or power with one of the signs stands in an expression."""
    return any(is_binary(node, *signs) for node in walk(tree))


def has_root(tree: Expression) -> bool:
    """Whether a square root stands in an expression."""
    try:
        return "sqrt" in tree._functions  # type: ignore[union-attr]
    except AttributeError:
        return "sqrt" in functions_in(tree)


def is_binary(node: object, *signs: str) -> TypeGuard[Binary]:
    """Whether a node is two trees with one of the signs between them."""
    return isinstance(node, Binary) and node.op in signs


def is_function(node: object, *names: str) -> TypeGuard[Apply]:
    """Whether a node is one of the functions, of whatever argument."""
    return isinstance(node, Apply) and node.function in names


def is_zero(node: Expression) -> bool:
    """Whether a node is the number 0, perhaps of a vector."""
    return isinstance(node, Number) and not node.value
