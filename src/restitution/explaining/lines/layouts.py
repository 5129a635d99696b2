"""What a line says, laid out: its relation as chains, alternatives joined by *or*."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import fields, replace
from fractions import Fraction as Ratio
from functools import lru_cache, reduce
from itertools import pairwise
from math import isqrt
from typing import Any, TypeGuard

from restitution.explaining.lines.derivation import Link, Relation
from restitution.explaining.lines.trees import compounds_rebuilt
from restitution.expression.defined import quantity_of
from restitution.expression.quantities import ENERGIES, LOSSES
from restitution.expression.tree import (
    PARTS,
    Apply,
    AtTime,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pi,
    Quantity,
    Rounded,
    Unit,
    has_quantity,
    is_binary,
    is_function,
    walk,
)
from restitution.render import layout as lay

_SIGNS = {
    "<=": "≤",
    ">=": "≥",
    "!=": "≠",
    "parallel to": "is parallel to",
    "perpendicular to": "is perpendicular to",
}


Names = Callable[[Quantity | Binary], lay.Layout | None]
"""How a working calls a quantity of the motion; None where it is written as in a statement.

It is asked too of what is lost over an energy, as that is a fraction lost.
"""


def of_tree(
    tree: Expression,
    vectors: AbstractSet[str] = frozenset(),
    names: Names | None = None,
    forms: Forms | None = None,
) -> lay.Layout:
    """A tree as it is printed; the letters that are ``vectors`` stand in bold type."""
    called: dict[str, lay.Layout] = {}
    forms = forms or Forms()
    printed, tree = forms.printed, forms.with_whole_fractions(tree, vectors)
    if names is None or not has_quantity(tree):
        return _laid_out(printed(tree), frozenset(vectors), ())

    def change(node: Expression) -> Expression | None:
        own = quantity_of(node) or node
        name = names(own) if isinstance(own, Quantity) or _may_be_named(own) else None
        if name is None:
            return None
        called[f"q_{len(called)}"] = name
        return Letter(f"q_{len(called) - 1}")

    plain = printed(_renamed(tree, change))
    return _laid_out(plain, frozenset(vectors), tuple(called.items()))


def _may_be_named(node: Expression) -> TypeGuard[Binary]:
    """Whether a tree is a loss of energy over an energy, or what one body loses of its energy."""
    match node:
        case Binary("/", Quantity(kind), Quantity("energy")) if kind in LOSSES:
            return True
        case Binary("-", Quantity("energy", (body,)), Quantity("energy", (other,))):
            return body == other
    return False


@lru_cache(maxsize=4096)
def _laid_out(
    tree: Expression, vectors: frozenset[str], called: tuple[tuple[str, lay.Layout], ...]
) -> lay.Layout:
    """A tree in which quantities are letters for the names by which they are ``called``."""
    own = lay.from_tree(tree)
    return _shaped(_put(own, vectors, dict(called)) if vectors or called else own)  # type: ignore[no-any-return]


def _renamed(tree: Any, change: Callable[[Expression], Expression | None]) -> Any:
    """A tree with quantities replaced, outermost first: what is inside of a replaced one goes."""
    if type(tree) in PARTS:
        if not has_quantity(tree):
            return tree
        new = change(tree)
        if new is not None:
            return new
        if type(tree) is Binary:
            left, right = _renamed(tree.left, change), _renamed(tree.right, change)
            same = left is tree.left and right is tree.right
            return tree if same else Binary(tree.op, left, right, place=tree.place)
        put = {}
        for name in PARTS[type(tree)]:
            value = getattr(tree, name)
            own = _renamed(value, change)
            if own is not value and own != value:
                put[name] = own
        return replace(tree, **put) if put else tree
    if isinstance(tree, tuple):
        return tuple(_renamed(value, change) for value in tree)
    if isinstance(tree, AtTime):
        return AtTime(_renamed(tree.time, change))
    return tree


class Forms:
    """The one form in which a number is printed: no root below a line, unless it was typed so.

    A long root stays where it is, as in 93/√28249, and the length of a direction by which a sum is
    divided, as in (3 + 4)/√2.

    ``typed`` are trees of the statement: a number that stands there with a root below a line is
    printed like that everywhere, and where there are decimals, a fraction is a decimal if it has an
    end and was not typed itself. A half that is that of an energy stays one. A product or a sum of
    two letters that is to be ``shown`` is printed in that order: Me, M + m. A part of an energy is
    a fraction where others are typed: ¼ for 25%; else it stays a decimal.
    """

    def __init__(self, typed: Iterable[Expression] = (), shown: Iterable[Expression] = ()) -> None:
        self._pairs = {
            (node.op, node.right, node.left): node
            for tree in shown
            for node in walk(tree)
            if isinstance(node, Binary) and _is_a_pair(node)
        }
        self._typed: dict[tuple[Ratio, int], Expression] = {}
        self._printed: dict[Expression, Expression] = {}
        self._decimal = False
        self._fractions = {Ratio(1, 2)}
        #: Whether the statement tells an angle by a fraction, arctan(3/4): then ratios are those.
        self.angles_by_fractions = False
        # Parts of an energy that are printed as fractions.
        self._shares: set[Ratio] = set()
        among_fractions = False
        decimals: set[Ratio] = set()
        for tree in typed:
            # A percentage of a quantity makes no decimals of other numbers.
            shares = [node.left for node in walk(tree) if _is_share_of_a_quantity(node)]
            for node in walk(tree):
                match node:
                    case Number(value) if node in shares:
                        shares.remove(node)
                        self._shares.add(value)
                    case Number(value) if value.denominator > 1:
                        self._decimal = True
                        decimals.add(value)
                    case Binary("/", Number(a), Number(b)) if b:
                        self._fractions.add(a / b)
                        among_fractions = True
                    case Apply("arctan" | "arcsin" | "arccos", Binary("/", Number(), Number())):
                        self.angles_by_fractions = True
                if is_binary(node, "/") and _root_below(node.right):
                    parts = _parts(node)
                    if parts is not None and not parts[2]:
                        self._typed.setdefault(parts[:2], node)
        if self._decimal or not among_fractions:
            self._shares.clear()
        self._fractions -= decimals  # what was typed in both forms is a decimal
        self._decimals = frozenset(decimals)

    def printed(self, tree: Expression) -> Expression:
        """The tree in which each number has its form, and no component is nothing."""
        own = self._printed.get(tree)
        if own is None:
            own = self._printed[tree] = compounds_rebuilt(tree, self._node)
        return own

    def with_whole_fractions(self, tree: Expression, vectors: AbstractSet[str]) -> Expression:
        """A tree in which a part of letters is one fraction, unless more factors follow: 3u²/5.

        Of a letter for a vector a part stands before it: ⅔**v**.
        """
        whole: dict[Expression, Expression] = {}

        def is_letter(node: Expression) -> bool:
            match node:
                case Letter(name) | Binary("^", Letter(name), Number()):
                    return name not in vectors
            return False

        def change(node: Expression) -> Expression:
            match node:
                case Binary("*", Binary("/", Number(a), Number(b)) as part, letter) if (
                    a > 1 and is_letter(letter) and not self._is_decimal(a, b)
                ):
                    own = Binary("/", Binary("*", part.left, letter), part.right)
                case Binary("*", left, right) if left in whole and is_letter(right):
                    assert isinstance(left, Binary)
                    own = Binary("/", Binary("*", left.left, right), left.right)
                case Binary("*", left, right) if left in whole and not isinstance(right, Unit):
                    return Binary("*", whole[left], right)
                case _:
                    return node
            whole[own] = Binary("*", whole.get(node.left, node.left), node.right)
            return own

        return compounds_rebuilt(tree, change)

    def _node(self, node: Expression) -> Expression:
        match node:
            case Binary(op, left, right) if (op, left, right) in self._pairs:
                return self._pairs[op, left, right]
            case Binary("+" | "-", left, Binary("*", Number(nothing), Unit())) if nothing == 0:
                return left
            case Binary("*", Number(value), whole) if value in self._shares:
                above, below = map(Ratio, value.as_integer_ratio())
                return Binary("*", Binary("/", Number(above), Number(below)), whole)
            case Binary(
                "+" | "-" as op, Binary("/") as left, Binary("*", Binary("/"), Apply()) as right
            ):
                return self._known(Binary(op, left, _under_one_line(left, right)))
            case Binary("/", Rounded(), Number()) | Binary("/", Number(), Rounded()):
                return node  # a quotient of what is carried has other figures
            case Binary("/", Number(a), Number(b)) if self._is_decimal(a, b):
                return Number(a / b)
            case Apply("arctan" | "arcsin" | "arccos" as inverse, Number(value)) if (
                self.angles_by_fractions and value.denominator > 1 and value not in self._decimals
            ):
                above, below = map(Ratio, value.as_integer_ratio())
                return Apply(inverse, Binary("/", Number(above), Number(below)))
            case Binary("*", Number(factor) as half, squares) if factor == _HALF and _has_a_square(
                squares
            ):
                return Binary("*", _halved(half), squares)
            case Binary("*", Binary("*", Number(factor) as half, mass), squares) if (
                factor == _HALF
                and (isinstance(mass, Number) or (_is_a_mass(mass) and _is_of_squares(squares)))
                and _has_a_square(squares)
            ):
                return Binary("*", Binary("*", _halved(half), mass), squares)
            case Binary(
                "/",
                Binary("+" | "-"),
                Apply("sqrt")
                | Binary("*", Number() | Apply("sqrt"), Apply("sqrt"))
                | Binary("*", Binary("*", Number(), Apply("sqrt")), Apply("sqrt")),
            ):
                return node  # a scalar product by the lengths of vectors, a vector by its own
            case Binary("/", left, right) if _root_below(right):
                own = self._rational(left, right) or node
                # Of two components with roots the quotient stands, and then what it is worth.
                return node if _roots(left) & _roots(right) and not _roots(own) else own
            case Binary("*", Apply("sqrt", Binary("+" | "-")) as root, Letter() as letter):
                return Binary("*", letter, root)  # u√(…), as √(…)u may be read as a longer root
            case Binary("*", Binary("*", first, Apply("tan") as one), Apply("tan") as other) if (
                one == other
            ):
                return Binary("*", first, Binary("^", one, Number(Ratio(2))))
            case Binary("/", Binary("*", first, Number() as a), Number() as b) if not _whole(first):
                return Binary("*", first, Binary("/", a, b))
        return self._known(node)

    def _is_decimal(self, above: Ratio, below: Ratio) -> bool:
        """Whether a fraction is printed as a decimal: one with an end, that was not typed."""
        if not self._decimal or not below or above / below in self._fractions:
            return False
        return below != 1 and 1000 % (above / below).denominator == 0

    def _known(self, node: Expression) -> Expression:
        """A number with a root as it was typed in the statement."""
        if not self._typed or not isinstance(node, Binary):
            return node
        parts = _parts(node)
        return self._typed.get(parts[:2], node) if parts is not None and not parts[2] else node

    def _rational(self, left: Expression, right: Expression) -> Expression | None:
        above, below = _parts(left), _parts(right)
        if above is None or below is None:
            return None
        (p, n, first), (q, m, second) = above, below
        if n == 1 and m >= lay.LONG_SURD:
            return None
        size = p / (q * m)
        root, radicand = _square_free(n * m)
        known = None if first else self._typed.get((size * root, radicand))
        number = known or _number(size * root, radicand)
        whole = reduce(lambda a, b: Binary("*", a, b), first, number)
        match number:
            case Binary("/", above_, below_) if (
                (first or second) and known is None and radicand > 1
            ):
                up = reduce(lambda a, b: Binary("*", a, b), first, above_)
                return Binary("/", up, reduce(lambda a, b: Binary("*", a, b), second, below_))
        if first and number == Number(Ratio(1)):
            whole = reduce(lambda a, b: Binary("*", a, b), first)
        return (
            whole
            if not second
            else Binary("/", whole, reduce(lambda a, b: Binary("*", a, b), second))
        )


def _under_one_line(one: Expression, other: Binary) -> Expression:
    """A multiple of a root as a quotient, beside one of the same root: √3/2 − √3/2."""
    match one, other:
        case (
            Binary("/", Apply("sqrt", Number(first)), Number()),
            Binary(
                "*",
                Binary("/", Number(above) as factor, below),
                Apply("sqrt", Number(second)) as root,
            ),
        ) if first == second:
            return Binary("/", root if above == 1 else Binary("*", factor, root), below)
    return other


def _is_a_pair(node: Binary) -> bool:
    """Whether a node is a product of two letters, none of them a speed, or a sum of two terms."""
    sides = node.left, node.right
    if node.op == "*":
        return all(isinstance(e, Letter) and e.name[0].lower() not in _SPEEDS for e in sides)
    return node.op == "+" and all(isinstance(e, Letter | Number) for e in sides)


_SPEEDS = frozenset("uvw")
_HALF, _TWO = Ratio(1, 2), Number(Ratio(2))


def _halved(half: Number) -> Expression:
    """A half as a fraction."""
    return Binary("/", Number(Ratio(half.value.numerator)), Number(Ratio(half.value.denominator)))


def _has_a_square(tree: Expression) -> bool:
    """Whether there is a square in a tree."""
    return any(is_binary(e, "^") and e.right == _TWO for e in walk(tree))


def _is_a_mass(tree: Expression) -> bool:
    """Whether a tree is a letter, or a multiple of one: 3m, km."""
    match tree:
        case Letter():
            return True
        case Binary("*", left, right):
            return _is_a_mass(right) and (isinstance(left, Number) or _is_a_mass(left))
    return False


def _is_of_squares(tree: Expression) -> bool:
    """Whether a tree is a square, or a sum or difference of them: ½m(u² − v²) is an energy."""
    match tree:
        case Binary("+" | "-", left, right):
            return _is_of_squares(left) and _is_of_squares(right)
        case Binary("^", _, exponent):
            return exponent == _TWO
    return False


def _is_share_of_a_quantity(node: Expression) -> TypeGuard[Binary]:
    """Whether a part of a quantity is typed in decimals, or as a percentage: 0.25 energy(0)."""
    match node:
        case Binary("*", Number(value), Quantity(kind)) if kind in ENERGIES:
            return 0 < value < 1
    return False


def shares_in(operands: Sequence[Expression]) -> Iterator[Expression]:
    """The parts of a whole with which a ratio of two energies is compared: they are shares too."""
    ratios = [
        operand
        for operand in operands
        if is_binary(operand, "/")
        and all(
            isinstance(e, Quantity) and e.kind in ENERGIES for e in (operand.left, operand.right)
        )
    ]
    if ratios:
        yield from (
            operand for operand in operands if isinstance(operand, Number) and 0 < operand.value < 1
        )


class AsTyped(Forms):
    """The form in which a tree was typed, whatever form its numbers have elsewhere."""

    def printed(self, tree: Expression) -> Expression:
        """The tree itself."""
        return tree

    def with_whole_fractions(self, tree: Expression, vectors: AbstractSet[str]) -> Expression:
        """The tree itself."""
        return tree


_Parts = tuple[Ratio, int, tuple[Expression, ...]]


def _parts(tree: Expression) -> _Parts | None:
    """A product as a rational number, what stands under a root, and its other factors.

    None where a factor that is divided by is no number, or a number was typed with decimals.
    """
    match tree:
        case Number(value):
            return None if value.denominator != 1 or value == 0 else (value, 1, ())
        case Apply("sqrt", Number(value)) if value.denominator == 1 and value > 0:
            root, inside = _square_free(int(value))
            return Ratio(root), inside, ()
        case Binary("*", left, right):
            first, second = _parts(left), _parts(right)
            if first is None or second is None:
                return None
            root, inside = _square_free(first[1] * second[1])
            return first[0] * second[0] * root, inside, (*first[2], *second[2])
        case Binary("/", left, right):
            first, second = _parts(left), _parts(right)
            if first is None or second is None or second[2]:
                return None
            root, inside = _square_free(first[1] * second[1])
            return first[0] * root / (second[0] * second[1]), inside, first[2]
        case Negate() | Degrees() | Pi():
            return None
    return Ratio(1), 1, (tree,)


def _square_free(value: int) -> tuple[int, int]:
    """The root of the greatest square in a whole number, and what is left."""
    root = max((k for k in range(1, isqrt(value) + 1) if value % (k * k) == 0), default=1)
    return root, value // (root * root)


def _number(size: Ratio, radicand: int) -> Expression:
    """``a√n/b``: a number with at most one root, which stands above the line."""
    above: Expression = Number(Ratio(size.numerator))
    if radicand > 1:
        root = Apply("sqrt", Number(Ratio(radicand)))
        above = root if size.numerator == 1 else Binary("*", above, root)
    if size.denominator == 1:
        return above
    return Binary("/", above, Number(Ratio(size.denominator)))


def _root_below(tree: Expression) -> bool:
    """Whether a root of a number is a factor of what stands below a line."""
    match tree:
        case Apply("sqrt", Number()):
            return True
        case Binary("*", left, right):
            return _root_below(left) or _root_below(right)
    return False


def _roots(tree: Expression) -> set[Expression]:
    """What stands under the roots in a tree."""
    return {e.argument for e in walk(tree) if is_function(e, "sqrt")}


def _whole(tree: Expression) -> bool:
    """Whether a tree is a product of whole numbers: 2 × 3/5 stands on one line."""
    match tree:
        case Number(value):
            return value.denominator == 1
        case Binary("*", left, right):
            return _whole(left) and _whole(right)
    return False


def _put(layout: Any, vectors: AbstractSet[str], called: Mapping[str, lay.Layout]) -> Any:
    if isinstance(layout, lay.Letter):
        name = f"{layout.name}_{layout.subscript}" if layout.subscript else layout.name
        if name in called:
            return called[name]
        return lay.Bold(layout.name, layout.subscript) if name in vectors else layout
    if isinstance(layout, tuple):
        return tuple(_put(value, vectors, called) for value in layout)
    if isinstance(layout, lay.Function):
        inside = _put(layout.argument, vectors, called)
        words = isinstance(inside, lay.Phrase | lay.Words)
        return replace(layout, argument=lay.Brackets(inside) if words else inside)
    if isinstance(layout, lay.Power):
        base, exponent = (_put(part, vectors, called) for part in (layout.base, layout.exponent))
        return lay.Power(_worded(base), exponent)
    if isinstance(layout, lay.Fraction) and called:
        above, below = (_put(side, vectors, called) for side in (layout.above, layout.below))
        return lay.Fraction(_worded(above), _worded(below))
    if isinstance(layout, lay.Power) and called:
        return replace(layout, base=_worded(_put(layout.base, vectors, called)))
    if isinstance(layout, lay.Product) and called:
        put = tuple(_put(factor, vectors, called) for factor in layout.factors)
        named = [value for value in put if isinstance(value, lay.Phrase | lay.Words)]
        others = tuple(value for value in put if value not in named)
        if len(named) != 1 or not others or layout.sign:
            return replace(layout, factors=tuple(map(_worded, put)))
        if all(isinstance(value, lay.Function) for value in others):
            return replace(layout, factors=(_worded(named[0]), *others))  # (speed of P) cos β
        rest = others[0] if len(others) == 1 else replace(layout, factors=others)
        return lay.Product((rest, named[0]), "×")
    if isinstance(layout, lay.Layout):
        changed = {e.name: _put(getattr(layout, e.name), vectors, called) for e in fields(layout)}
        return replace(layout, **changed)
    return layout


def _worded(layout: lay.Layout) -> lay.Layout:
    """A factor that is a name of several words, in brackets."""
    return lay.Brackets(layout) if isinstance(layout, lay.Phrase | lay.Words) else layout


def _shaped(layout: Any) -> Any:
    """A layout in which no product runs into the next: ``(u cos α)v``, ``⅔ × ⅗u``."""
    if isinstance(layout, tuple):
        return tuple(_shaped(value) for value in layout)
    if not isinstance(layout, lay.Layout):
        return layout
    put = {field.name: _shaped(getattr(layout, field.name)) for field in fields(layout)}
    layout = replace(layout, **put)
    return _grouped(layout) if isinstance(layout, lay.Product) else layout


def _roots_first(product: lay.Product) -> lay.Product:
    """A product in which roots of numbers stand before letters and brackets: ``√3(1 + e)u``."""
    if product.sign:
        return product
    numbers = [factor for factor in product.factors if _numeric(factor)]
    roots = [factor for factor in product.factors if _is_surd(factor)]
    if not roots or product.factors[: len(numbers)] != tuple(numbers):
        return product
    rest = [factor for factor in product.factors if not (_numeric(factor) or _is_surd(factor))]
    return replace(product, factors=(*numbers, *roots, *rest))


def _is_surd(factor: lay.Layout) -> bool:
    """Whether a factor is a root of a number."""
    return isinstance(factor, lay.Root) and isinstance(factor.inside, lay.Number)


def _is_quotient_with_a_root(factor: lay.Layout) -> bool:
    """Whether a factor is a quotient of numbers with a root: ``1/√3``."""
    match factor:
        case lay.Fraction(above, below):
            sides = (above, below)
            return any(map(_is_surd, sides)) and all(_is_surd(e) or _numeric(e) for e in sides)
    return False


def _grouped(product: lay.Product) -> lay.Layout:
    if len(product.factors) > 2 and not product.sign:
        one, other, *more = product.factors
        if _is_quotient_with_a_root(one) and _is_surd(other):
            return lay.Product((one, lay.Brackets(lay.product(other, *more))))  # (1/√3)(√3 u)
    product = _roots_first(product)
    first, *rest = product.factors
    if isinstance(first, lay.Product) and first.sign == "×":
        if product.sign:
            return lay.Product((*first.factors, *rest), product.sign)
        *head, last = first.factors
        joined = lay.product(last, *rest)
        own = _grouped(joined) if isinstance(joined, lay.Product) else joined
        if isinstance(own, lay.Product) and own.sign == "×":
            return lay.Product((*head, *own.factors), "×")
        return lay.Product((*head, own), "×")
    if product.sign:
        return product
    power = _power_of_a_number(product.factors)
    if power:
        sides = product.factors[:power], product.factors[power:]
        return lay.Product(tuple(lay.product(*side) for side in sides), "×")  # ½m × 8²
    again = _repeated(product.factors)
    if again is not None:
        sides = product.factors[:again], product.factors[again:]
        whole = [lay.product(*side) for side in sides]
        later = [
            _grouped(layout) if isinstance(layout, lay.Product) else layout for layout in whole[1:]
        ]
        return lay.Product((whole[0], *later), "×")  # 4u × u, km × ku, e × e²u
    if _numeric(rest[0]) and not _numeric(first):
        return _grouped(lay.Product((rest[0], first, *rest[1:])))
    groups: list[list[lay.Layout]] = [[]]
    for factor in product.factors:
        before = groups[-1][-1:]
        if before and isinstance(before[0], lay.Function) and not _ends(factor):
            groups.append([])
        groups[-1].append(factor)
    if len(groups) == 1:
        return product
    whole = [
        lay.Brackets(lay.Product(tuple(group)) if len(group) > 1 else group[0])
        if isinstance(group[-1], lay.Function)
        else lay.Product(tuple(group))
        if len(group) > 1
        else group[0]
        for group in groups
    ]
    return lay.Product(tuple(whole))


def _power_of_a_number(factors: Sequence[lay.Layout]) -> int:
    """Where the power of a number stands behind a letter; 0 where none does."""
    for index, (before, factor) in enumerate(pairwise(factors), 1):
        of_number = isinstance(factor, lay.Power) and isinstance(factor.base, lay.Number)
        if of_number and isinstance(before, lay.Letter):
            return index
    return 0


def _repeated(factors: Sequence[lay.Layout]) -> int | None:
    """Where a letter stands for the second time, perhaps as a power; None where none does.

    Where a sine, a root or a bracket stands between them, that parts them.
    """
    letters: set[lay.Letter] = set()
    for index, factor in enumerate(factors):
        if not isinstance(factor, lay.Letter | lay.Number | lay.Power):
            return None
        base = factor.base if isinstance(factor, lay.Power) else factor
        if isinstance(base, lay.Letter):
            if base in letters:
                return index
            letters.add(base)
    return None


def _numeric(factor: lay.Layout) -> bool:
    if isinstance(factor, lay.Fraction):
        return _numeric(factor.above) and _numeric(factor.below)
    return isinstance(factor, lay.Number)


def _ends(factor: lay.Layout) -> bool:
    """Whether a factor stands behind a sine without being taken for its angle."""
    return isinstance(factor, lay.Function | lay.Bold)


def chains(links: tuple[Link, ...]) -> list[tuple[Link, ...]]:
    """Links that hold together, as chains: each goes on where the one before it ends."""
    chains_: list[list[Link]] = []
    for link in links:
        if chains_ and chains_[-1][-1].right == link.left:
            chains_[-1].append(link)
        else:
            chains_.append([link])
    return [tuple(chain) for chain in chains_]


def of_chain(
    links: tuple[Link, ...],
    vectors: AbstractSet[str] = frozenset(),
    names: Names | None = None,
    forms: Forms | None = None,
) -> lay.Relation:
    """A chain: operands with signs between them."""
    operands = [links[0].left, *(link.right for link in links)]
    return lay.Relation(
        tuple(of_tree(operand, vectors, names, forms) for operand in operands),
        tuple(_SIGNS.get(link.sign, link.sign) for link in links),
    )


def of_relation(
    relation: Relation,
    vectors: AbstractSet[str] = frozenset(),
    names: Names | None = None,
    forms: Forms | None = None,
) -> lay.Layout:
    """A whole relation in one line."""
    options = [
        _joined([of_chain(chain, vectors, names, forms) for chain in chains(links)], ", ")
        for links in relation.options
    ]
    return _joined(options, " or ")


def _joined(layouts: list[Any], separator: str) -> lay.Layout:
    return layouts[0] if len(layouts) == 1 else lay.Phrase(tuple(layouts), separator)
