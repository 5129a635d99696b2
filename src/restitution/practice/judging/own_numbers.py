"""Numbers, and terms with letters, that a student worked out wrongly and goes on with.

A line with one of these in it follows where it is true with what stands for it rightly.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import islice, product

from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    children,
    is_binary,
    letters,
    quantities_in,
    unsigned,
    unsigned_terms,
    walk,
)
from restitution.practice.judging.entries import Meanings, is_monomial
from restitution.practice.script import Claim

_MOST = 3
"""So many of the numbers in a line are put back at once: each may have either sign."""
_MEANT = 4
_TRIED = 24
_FEWEST = 2
_SMALL = frozenset(map(Fraction, (0, 1)))
_TWO = Number(Fraction(2))
_FACTORS = (Fraction(2), Fraction(3), Fraction(1, 2))
_ROUNDED = Fraction(3, 1000)


Meant = tuple[tuple[Expression, ...], tuple[Fraction, ...]]
"""What a number may stand for, and the wrong numbers of which it is made."""
Put = tuple[Claim, tuple[int, ...]]


def _is_one(tree: Expression) -> bool:
    """Whether a number stands over itself."""
    return is_binary(tree, "/") and tree.left == tree.right


class OwnNumbers:
    """The wrong numbers of a script so far, each with what it stands for and its line.

    ``factors`` are data by which a student multiplies: masses and coefficients of restitution,
    ``names`` the letters of the question.
    """

    def __init__(self, factors: Iterable[Fraction] = (), names: Collection[str] = ()) -> None:
        self._names = frozenset(names)
        own = tuple(factor for factor in factors if factor not in _SMALL)
        self._factors = (*_FACTORS, *own)
        self._data = frozenset(factor for factor in own if factor.denominator > 1)
        self._known: dict[Fraction, tuple[tuple[Expression, ...], int]] = {}
        self._behind: dict[Fraction, Expression | None] = {}
        self._terms: dict[Expression, tuple[tuple[Expression, ...], int]] = {}
        self._shares: dict[Expression, tuple[Expression, int]] = {}

    def __bool__(self) -> bool:
        return bool(self._known or self._terms or self._shares)

    def note(
        self,
        value: Expression,
        meant: Expression,
        meanings: Meanings,
        line: int,
        others: Sequence[Expression] = (),
    ) -> None:
        """Note that ``value``, a number or a product, stands where ``meant`` would be right.

        ``others`` are what a phrase that was meant may mean as well.
        """
        data = letters(value) <= self._names
        if data and is_monomial(value) and _marks_of(value):
            right = _in_meanings(meant, meanings)
            self._shares[value] = Binary("/", right, value), line
        if data and isinstance(value, Binary) and letters(value):  # 3 - 2e, u/2
            own = _in_meanings(meant, meanings)
            self._terms[value] = tuple(dict.fromkeys((own, *others)))[:_MEANT], line
        value, meant = _without_root(value, meant)
        whole = _with_fractions(value)
        behind = whole.right if is_binary(whole, "*") else None
        others = tuple(_without_letters(whole, other)[1] for other in others)
        value, meant = _without_letters(whole, meant)
        size = _size(value)
        if not size:
            return
        self._behind[size] = behind
        trees = dict.fromkeys((_in_meanings(meant, meanings), *others))
        negative = _is_negative(value)
        known = tuple(Negate(tree) if negative else tree for tree in trees)
        if negative and all(map(_is_of_energy, trees)):
            known += tuple(trees)  # what has the sign of a gain may be put right below
        self._known[size] = known[:_MEANT], line

    def worked(self) -> Iterator[tuple[Fraction, int]]:
        """The numbers that are worked out of wrong ones by a quotient, each with its line."""
        for value, (meant, line) in self._known.items():
            if any(is_binary(unsigned(tree), "/") for tree in meant):
                yield value, line

    def put_back(self, claim: Claim) -> Iterator[Put]:
        """A claim with what its wrong numbers stand for, and the lines that these are from.

        A fraction is one number: 49/256 is the square of 7/16, and ¾ is e.
        """
        claim = replace(claim, left=self._with_data(claim.left), right=self._with_data(claim.right))
        yield from self._put_back(claim)
        whole = replace(claim, left=_with_fractions(claim.left), right=_with_fractions(claim.right))
        if whole != claim:
            yield from self._put_back(whole)

    def _with_data(self, tree: Expression) -> Expression:
        """A tree with fractions that are data as one number each: of these no figure is his own."""

        def change(node: Expression) -> Expression:
            whole = _as_fraction(node)
            data = isinstance(whole, Number) and whole.value in self._data
            return whole if data and whole is not node else node

        return rebuilt(tree, change)

    def _put_back(self, claim: Claim) -> Iterator[Put]:
        yield from self._with_terms(claim)
        yield from self._with_shares(claim)
        sizes = {size for side in (claim.left, claim.right) for size in _sizes(side)}
        if claim.others:
            return
        own = [size for size in self._known if size in sizes][-_MOST:]
        yield from self._put(claim, {size: (self._known[size][0], (size,)) for size in own})
        for size in own:
            yield from self._put_once(claim, size)
        sums = {size: trees for size in sizes if (trees := self._made_of(size))}
        if sums:
            known = {size: (self._known[size][0], (size,)) for size in own}
            yield from self._put(claim, dict(islice(({**sums, **known} | sums).items(), _MOST)))

    def _with_terms(self, claim: Claim) -> Iterator[Put]:
        """A claim with what its wrong terms with letters stand for."""
        parts = {part for side in (claim.left, claim.right) for part in walk(side)}
        own = [term for term in self._terms if term in parts][-_MOST:]
        if not own or claim.others:
            return
        lines = tuple(dict.fromkeys(self._terms[term][1] for term in own))
        for trees in islice(product(*(self._terms[term][0] for term in own)), _TRIED):
            put = dict(zip(own, trees, strict=True))
            left, right = (exchanged(side, put) for side in (claim.left, claim.right))
            yield replace(claim, left=left, right=right), lines

    def _with_shares(self, claim: Claim) -> Iterator[Put]:
        """A claim with a term that is a multiple of a wrong product as the same of what is right.

        Below ``8 cos 60 = 4√3`` that is ``2 × 4√3``, which has the same roots and letters.
        """
        if claim.others:
            return
        sides = claim.left, claim.right
        terms = dict.fromkeys(term for side in sides for term in unsigned_terms(side))
        for value, (share, line) in [*self._shares.items()][-_MOST:]:
            own = [x for x in terms if _is_multiple(x, value)]
            for some in dict.fromkeys(((*own,), *((term,) for term in own))) if own else ():
                put: dict[Expression, Expression] = {x: Binary("*", x, share) for x in some}
                left, right = (exchanged(side, put) for side in sides)
                yield replace(claim, left=left, right=right), (line,)

    def _put(self, claim: Claim, meant: Mapping[Fraction, Meant]) -> Iterator[Put]:
        if not meant:
            return
        sources = [size for _, sizes in meant.values() for size in sizes]
        lines = tuple(dict.fromkeys(self._known[size][1] for size in sources))
        forms = [
            [signed for tree in trees for signed in _in_either_sense(tree)]
            for trees, _ in meant.values()
        ]
        for trees in islice(product(*forms), _TRIED):
            put = dict(zip(meant, trees, strict=True))
            left, right = (_with(side, put) for side in (claim.left, claim.right))
            yield replace(claim, left=left, right=right), lines

    def _put_once(self, claim: Claim, size: Fraction) -> Iterator[Put]:
        """A claim with what a number stands for in one of its places: it is right in another.

        Before the same letter, or before none, as it was worked out.
        """
        trees, line = self._known[size]
        behind = self._behind.get(size)
        places = [*_places(claim.left, size), *_places(claim.right, size)]
        if len(places) < _FEWEST or any(map(_is_one, (claim.left, claim.right))):
            return  # of 5/5 no figure is another number than its other one
        for tree in (own for meant in trees for own in _in_either_sense(meant)):
            for left in _with_one(claim.left, size, tree, behind):
                yield replace(claim, left=left), (line,)
            for right in _with_one(claim.right, size, tree, behind):
                yield replace(claim, right=right), (line,)

    def _made_of(self, number: Fraction) -> Meant | None:
        """What a number stands for that is the square of a wrong one, or a multiple."""
        for size, (trees, _) in self._known.items():
            if number == size or size in _SMALL:
                continue
            if _is_near(number, size * size):
                return tuple(Binary("^", tree, _TWO) for tree in trees), (size,)
            # Of a whole number only a share that is given is no chance: ¾ × 8 = 6.
            factors = self._factors if size.denominator > 1 else sorted(self._data)
            for factor in factors:
                if _is_near(number, factor * size):
                    return tuple(Binary("*", Number(factor), tree) for tree in trees), (size,)
        return None


def _in_either_sense(tree: Expression) -> Iterator[Expression]:
    """A tree and what it is with the other sign; energies have one sense: a gain is no loss."""
    yield tree
    if not _is_of_energy(tree):
        yield Negate(tree)


def _marks_of(tree: Expression) -> frozenset[Expression]:
    """The letters of a product, and its roots and other functions, by which it is known."""
    return frozenset(node for node in walk(tree) if isinstance(node, Letter | Apply))


def _is_multiple(term: Expression, value: Expression) -> bool:
    """Whether a product may be a multiple of another one: it has no other function."""
    own, others = _marks_of(term), _marks_of(value)
    functions = {node for node in own if isinstance(node, Apply)}
    return is_monomial(term) and others <= own and functions <= others


def _is_of_energy(tree: Expression) -> bool:
    """Whether a tree is made of energies, or of losses of them, alone."""
    kinds = [quantity.kind for quantity in quantities_in(tree)]
    return bool(kinds) and all("energy" in kind for kind in kinds)


def _in_meanings(tree: Expression, meanings: Meanings) -> Expression:
    """A tree with what its letters mean in their places."""
    names: dict[Expression, Expression] = {
        node: meanings[node.name]
        for node in walk(tree)
        if isinstance(node, Letter) and node.name in meanings
    }
    return exchanged(tree, names)


def _without_root(value: Expression, meant: Expression) -> tuple[Expression, Expression]:
    """A number above a root, which cancels later, and what is right in its place."""
    turned = isinstance(value, Negate)
    inside = unsigned(value)
    if not (is_binary(inside, "/") and _size(inside.right) is None):
        return value, meant
    above = Negate(inside.left) if turned else inside.left
    return above, Binary("*", meant, inside.right)


def _without_letters(value: Expression, meant: Expression) -> tuple[Expression, Expression]:
    """A number before a letter, which cancels later, and what is right in its place."""
    if not (is_binary(value, "*") and isinstance(value.right, Letter)):
        return value, meant
    if _size(value.left) is None:
        return value, meant
    return value.left, Binary("/", meant, value.right)


def _with_fractions(tree: Expression) -> Expression:
    """A tree with fractions of two numbers as one number each: u/8 is ⅛ of u."""
    return rebuilt(tree, _as_fraction)


def _as_fraction(node: Expression) -> Expression:
    match node:
        case Binary("/", Number(above), Number(below)) if below:
            return Number(above / below)
        case Binary("/", Letter() as letter, Number(below)) if below:
            return Binary("*", Number(1 / below), letter)
        case Binary("/", Binary("*") as above, Number(below)) if below:
            return _divided(above, below) or node
    return node


def _divided(product: Binary, below: Fraction) -> Expression | None:
    """A product of letters that a number leads, ``3eu``, with that number divided."""
    match product:
        case Binary("*", Number(above), Letter()):
            return replace(product, left=Number(above / below))
        case Binary("*", Binary("*") as left, Letter()):
            own = _divided(left, below)
            return None if own is None else replace(product, left=own)
    return None


def _is_near(number: Fraction, other: Fraction) -> bool:
    """Whether a number is another one, or that rounded."""
    whole = number.denominator == 1 == other.denominator
    return number == other if whole else abs(number - other) <= _ROUNDED * abs(other)


def _size(tree: Expression) -> Fraction | None:
    """The size of a number as it stands; None for any other tree."""
    inside = unsigned(tree)
    return inside.value if isinstance(inside, Number | Degrees) else None


def _is_negative(tree: Expression) -> bool:
    return isinstance(tree, Negate)


def _sizes(tree: Expression) -> Iterator[Fraction]:
    """The numbers of a tree, without exponents."""
    if isinstance(tree, Number | Degrees):
        yield tree.value
    elif is_binary(tree, "^"):
        yield from _sizes(tree.left)
    else:
        for child in children(tree):
            yield from _sizes(child)


def _places(tree: Expression, size: Fraction) -> Iterator[Fraction]:
    """A number as often as it stands in a tree, without exponents."""
    return (number for number in _sizes(tree) if number == size)


def _with_one(
    tree: Expression, size: Fraction, other: Expression, behind: Expression | None
) -> Iterator[Expression]:
    """A tree with another one in a single place of a number; exponents and factors stay.

    ``behind`` is the letter that stands behind the number there.
    """
    if isinstance(tree, Number | Degrees):
        if tree.value == size and behind is None:
            yield other
    elif is_binary(tree, "*") and _size(tree.left) == size:
        if tree.right == behind:
            yield replace(tree, left=other)
    elif isinstance(tree, Binary):
        for left in _with_one(tree.left, size, other, behind):
            yield replace(tree, left=left)
        if tree.op != "^":
            for right in _with_one(tree.right, size, other, behind):
                yield replace(tree, right=right)
    elif isinstance(tree, Negate):
        for operand in _with_one(tree.operand, size, other, behind):
            yield Negate(operand)


def _with(tree: Expression, put: dict[Fraction, Expression]) -> Expression:
    """A tree with other trees in place of some numbers; exponents stay."""
    if isinstance(tree, Number | Degrees):
        return put.get(tree.value, tree)
    if is_binary(tree, "^"):
        return replace(tree, left=_with(tree.left, put))
    return exchanged(tree, {child: _with(child, put) for child in children(tree)})
