"""Trees of lines as quotients of polynomials over ℚ, so that two of them can be compared exactly.

A generator stands for each letter, each quantity of the motion that is not put in, and each
component of a vector of which that is true; for each root, with its square beside it; and for
the cosine and the sine of each angle. Sines of different arguments (θ, 2θ, ½θ) are strangers,
and so are the sine and the cosine of one, unless an identity is named that relates them: a line
that uses one has to say so. That tan is sin/cos is free.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction
from math import isqrt, lcm, prod
from typing import Any, Literal, TypeAlias

import sympy as sp
from sympy.polys.domains import QQ
from sympy.polys.rings import PolyElement

from restitution.exact.degrees import cosine as cosine_of
from restitution.exact.degrees import sine as sine_of
from restitution.exact.degrees import turns_of
from restitution.explaining.lines.quotients import (
    CONSTANT,
    MOST_GENERATORS,
    MOST_POWER,
    MOST_TERMS,
    NotComparableError,
    Plane,
    Quotient,
    factors_of,
    lean,
    primes,
    quotient_ring,
    square_part,
)
from restitution.expression.quantities import ANGLES, is_vector_quantity
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Pi,
    Polar,
    Quantity,
    Unit,
    walk,
)
from restitution.oracle.roles import REAL, Role

Identity = Literal["pythagoras", "double-angle", "half-angle", "sum", "complement"]


_TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "cosec"})


_INVERSE = frozenset({"arcsin", "arccos", "arctan"})


def _is_line_of_centres(tree: Expression) -> bool:
    return isinstance(tree, Quantity) and tree.kind == "line_of_centres"


Value = Quotient | Plane

Atom: TypeAlias = Expression | tuple[str, PolyElement, PolyElement]
"""A part of an angle: a letter, an angle of the motion, or an inverse function by its value."""

AngleKey: TypeAlias = tuple[tuple[Any, ...], Fraction]
"""An angle by its parts with their multiples, and degrees; a plain angle has one empty part."""

Key: TypeAlias = tuple[Any, ...]
"""A generator: what it is ("letter", "quantity", "cos", "root", …), and of what."""


@dataclass(frozen=True)
class Turn:
    """An angle: rational multiples of letters, angles of the motion and inverse functions,
    and a number of degrees.
    """

    terms: tuple[tuple[Atom, Fraction], ...] = ()
    degrees: Fraction = Fraction(0)

    def __add__(self, other: Turn) -> Turn:
        total = dict(self.terms)
        for atom, count in other.terms:
            total[atom] = total.get(atom, Fraction(0)) + count
        kept = sorted((item for item in total.items() if item[1]), key=repr)
        return Turn(tuple(kept), self.degrees + other.degrees)

    def __mul__(self, factor: Fraction) -> Turn:
        if not factor:
            return Turn()
        return Turn(tuple((a, n * factor) for a, n in self.terms), self.degrees * factor)


@dataclass
class World:
    """The generators in which some trees are compared.

    ``roles`` says what a letter of the statement may be; ``vectors`` and ``angles`` name letters
    that are such. ``directions`` gives the vector along which an axis, a wall or a vector letter
    points, ``turns`` the value of an angle: what is cited of these. What is ``opaque`` is a
    generator, whatever is known of it. While ``printed`` is set, what stands below a line is kept
    among the ``denominators``, which are not zero; what stands below the ``tangents`` of a
    line counts only where it stays. Letters that are cited as ``nonnegative``, and the
    sines and cosines of such angles up to 90°, are their own size, as are the differences that are
    ``ordered``: what is cited as greater without what is less.
    """

    roles: Mapping[str, Role]
    vectors: frozenset[str] = frozenset()
    angles: frozenset[str] = frozenset()
    directions: Mapping[Expression, Expression] = field(default_factory=dict)
    turns: Mapping[Expression, Expression] = field(default_factory=dict)
    identities: frozenset[Identity] = frozenset()
    opaque: frozenset[Expression] = frozenset()
    nonnegative: frozenset[str] = frozenset()
    ordered: set[PolyElement] = field(default_factory=set)
    printed: bool = True
    squares: dict[int, PolyElement] = field(default_factory=dict)
    denominators: list[PolyElement] = field(default_factory=list)
    tangents: list[PolyElement] = field(default_factory=list)
    _keys: dict[Key, int] = field(default_factory=dict)
    _divisors: dict[Atom, int] = field(default_factory=dict)
    _values: dict[Expression, Value] = field(default_factory=dict)

    # --- generators ------------------------------------------------------------------------------

    def generator(self, key: Key) -> Quotient:
        """The generator of a letter, a quantity, a root or a cosine."""
        if key not in self._keys:
            if len(self._keys) == MOST_GENERATORS:
                raise NotComparableError("lines of too many letters")
            self._keys[key] = len(self._keys)
        return Quotient(quotient_ring().gens[self._keys[key]], quotient_ring().one)

    def keys_by_number(self) -> dict[int, Key]:
        """All generators, by number."""
        return {number: key for key, number in self._keys.items()}

    def keys(self, *polynomials: PolyElement) -> dict[int, Key]:
        """The generators that occur, by number."""
        by_number = self.keys_by_number()
        return {
            n: by_number[n]
            for each in polynomials
            for powers in each
            for n, power in enumerate(powers)
            if power
        }

    def note_tangents(self, line: Value) -> None:
        """Keep the cosines below the tangents of a line, as far as they do not cancel there."""
        parts = (line.x, line.y) if isinstance(line, Plane) else (line,)
        for cosine in self.tangents:
            if any(not part.below.is_ground and not part.below.rem(cosine) for part in parts):
                self.denominators.append(cosine)
        self.tangents.clear()

    # --- values ----------------------------------------------------------------------------------

    def value(self, tree: Expression) -> Value:
        """A tree as a scalar or a vector. Raises NotComparableError."""
        known = self._values.get(tree)
        if known is None:
            known = self._values[tree] = self._value(tree)
        return known

    def scalar(self, tree: Expression) -> Quotient:
        """A tree as a scalar. Raises NotComparableError where it is a vector."""
        value = self.value(tree)
        if isinstance(value, Plane):
            raise NotComparableError("a vector where a number should stand")
        return value

    def _value(self, tree: Expression) -> Value:
        match tree:
            case Number(value):
                return CONSTANT(value)
            case Degrees() | Pi():
                return self._measure(tree)
            case Letter(name):
                if name in self.vectors:
                    return self._plane(tree)
                if name in self.angles:
                    return self._measure(tree)
                return self.generator(("letter", name))
            case Unit(axis):
                one, nothing = CONSTANT(1), CONSTANT(0)
                return Plane(one, nothing) if axis == "i" else Plane(nothing, one)
            case Pair(x, y):
                return Plane(self.scalar(x), self.scalar(y))
            case Polar():
                return self._polar(tree)
            case Negate(operand):
                return _scaled(self.value(operand), CONSTANT(-1))
            case Binary(op, left, right):
                return self._binary(tree, op, left, right)
            case Apply(function, argument):
                return self._apply(tree, function, argument)
            case Quantity():
                return self._quantity(tree)
            case Name():
                return self.direction(tree) or self._plane(tree)
        raise NotComparableError(repr(tree))

    def _plane(self, tree: Expression) -> Plane:
        return Plane(self.generator(("x", tree)), self.generator(("y", tree)))

    def _binary(self, tree: Expression, op: str, left: Expression, right: Expression) -> Value:
        if self.is_angle(tree):
            return self._measure(tree)
        if op == "^":
            return self._power(left, right)
        a, b = self.value(left), self.value(right)
        if op in "+-":
            if op == "-":
                b = _scaled(b, CONSTANT(-1))
            if isinstance(a, Plane) and isinstance(b, Plane):
                return Plane(self.reduced(a.x + b.x), self.reduced(a.y + b.y))
            return self.reduced(_scalar(a) + _scalar(b))
        if op == "*":
            if isinstance(b, Plane):
                a, b = b, a
            return self.reduced_value(_scaled(a, _scalar(b)))
        below = _scalar(b)
        if self.printed:
            self.denominators.append(below.above)
        return self.reduced_value(_scaled(a, CONSTANT(1) / below))

    def _power(self, left: Expression, right: Expression) -> Quotient:
        exponent = self.scalar(right)
        if exponent.above and not (exponent.above.is_ground and exponent.below.is_ground):
            raise NotComparableError("a letter in a power")
        power = Fraction(int(exponent.above.LC.numerator), int(exponent.above.LC.denominator))
        base = self.value(left)
        if isinstance(base, Plane):
            if power != 2:
                raise NotComparableError("a power of a vector")
            return self.reduced(base.x * base.x + base.y * base.y)
        if power.denominator == 2:
            base, power = self.root(base), Fraction(power.numerator)
        if power.denominator != 1:
            raise NotComparableError("a root that is not a square root")
        return self.reduced(base ** int(power))

    def _apply(self, tree: Expression, function: str, argument: Expression) -> Value:
        if function in _TRIGONOMETRIC:
            cosine, sine = self.cos_sin(self.turn(argument))
            if function in ("sin", "cos"):
                return sine if function == "sin" else cosine
            # Who writes a tangent says that there is one.
            below = (cosine if function in ("tan", "sec") else sine).above
            (self.denominators if self.printed else self.tangents).append(below)
            match function:
                case "tan":
                    return self.reduced(sine / cosine)
                case "cot":
                    return self.reduced(cosine / sine)
                case "sec":
                    return CONSTANT(1) / cosine
                case _:
                    return CONSTANT(1) / sine
        if function in _INVERSE:
            return self._measure(tree)
        value = self.value(argument)
        if function == "sqrt":
            return self.root(_scalar(value))
        if isinstance(value, Plane):
            return self.size(value)
        if value.above.is_ground and value.below.is_ground:
            return value if value.above.LC > 0 else -value
        return self.root(value * value)

    def size(self, vector: Plane) -> Quotient:
        """The size of a vector."""
        if self._is_of_an_angle(vector):
            return CONSTANT(1)
        return self.root(self.reduced(vector.x * vector.x + vector.y * vector.y))

    # --- vectors ---------------------------------------------------------------------------------

    def _polar(self, tree: Polar) -> Plane:
        size = self.scalar(tree.size)
        unit = self._at_angle(self.turn(tree.angle))
        cosine, sine = unit.x, unit.y
        if tree.wall is not None:
            along = self.unit(Quantity("direction", (tree.wall,)))
            x, y = along.x * cosine + along.y * sine, along.y * cosine - along.x * sine
        elif tree.origin is None:
            x, y = cosine, sine
        elif self.is_angle(tree.origin):
            turned = self._at_angle(self.turn(tree.angle) + self.turn(tree.origin))
            x, y = turned.x, turned.y
        else:
            from_ = self.unit(tree.origin)
            x, y = from_.x * cosine - from_.y * sine, from_.x * sine + from_.y * cosine
        return Plane(self.reduced(size * x), self.reduced(size * y))

    def unit(self, tree: Expression) -> Plane:
        """The unit vector in a direction, where that is known, or the generators of one."""
        vector = self.direction(tree)
        if vector is None:
            return self._plane(tree)
        if self._is_at_angle(tree):
            return vector
        size = self.size(vector)
        return Plane(self.reduced(vector.x / size), self.reduced(vector.y / size))

    def _is_of_an_angle(self, vector: Plane) -> bool:
        """Whether a vector is written as the cosine and the sine of an angle: its size is 1."""
        keys = [list(self.keys(each.above).values()) for each in (vector.x, vector.y)]
        if any(len(key) != 1 for key in keys):
            return False
        (one,), (other,) = keys
        if {one[0], other[0]} != {"cos", "sin"} or one[1] != other[1]:
            return False
        own = [self.generator(each) for each in (one, other)]
        return all(x in (g, -g) for x, g in zip((vector.x, vector.y), own, strict=True))

    def direction(self, tree: Expression) -> Plane | None:
        """A vector in the direction that a tree tells, or None where none is cited."""
        if tree in self.directions:
            return self.direction(self.directions[tree])
        if isinstance(tree, Negate) and not self.is_angle(tree.operand):
            turned = self.direction(tree.operand)
            return None if turned is None else Plane(-turned.x, -turned.y)
        if isinstance(tree, Name):
            return self.direction(Quantity("direction", (tree,)))
        if isinstance(tree, Quantity) or (isinstance(tree, Letter) and tree.name in self.vectors):
            return None
        if self.is_angle(tree):
            return self._at_angle(self.turn(tree))
        value = self.value(tree)
        return value if isinstance(value, Plane) else None

    def pointing(self, tree: Expression) -> Value:
        """A tree as a direction: what it is cited to point along, else its value."""
        if tree in self.opaque and isinstance(tree, Quantity):
            return self._plane(tree)
        if isinstance(tree, Quantity) and tree in self.directions:
            direction = self.direction(tree)
            if direction is not None:
                return direction
        return self.value(tree)

    def _at_angle(self, turn: Turn) -> Plane:
        """The unit vector at an angle; one at right angles to another is that one turned."""
        if not turn.terms or turn.degrees % 90:
            return Plane(*self.cos_sin(turn))
        x, y = self.cos_sin(Turn(turn.terms))
        for _ in range(int(turn.degrees // 90) % 4):
            x, y = -y, x
        return Plane(x, y)

    def _is_at_angle(self, tree: Expression) -> bool:
        """Whether a direction is told by its angle, so that its vector is a unit vector."""
        seen = 0
        while tree in self.directions and seen < MOST_GENERATORS:
            tree, seen = self.directions[tree], seen + 1
        return self.is_angle(tree) or (isinstance(tree, Polar) and tree.size == Number(Fraction(1)))

    def _quantity(self, tree: Quantity) -> Value:
        match tree.kind:
            case "along" | "across":
                vector, axis = tree.arguments
                return self._component(tree, vector, axis)
            case "dot":
                a, b = (
                    self.unit(argument) if _is_line_of_centres(argument) else self.value(argument)
                    for argument in tree.arguments
                )
                if not (isinstance(a, Plane) and isinstance(b, Plane)):
                    raise NotComparableError("a scalar product of numbers")
                return self.reduced(a.x * b.x + a.y * b.y)
            case kind if kind in ANGLES:
                return self._measure(tree)
        if is_vector_quantity(tree):
            return self._plane(tree)
        return self.generator(("quantity", tree))

    def _component(self, tree: Quantity, vector: Expression, axis: Expression) -> Quotient:
        """The component of a vector along or across a direction.

        Where the direction is not cited, it is a generator of its own.
        """
        if isinstance(axis, Negate):
            return -self.scalar(Quantity(tree.kind, (vector, axis.operand)))
        if tree in self.opaque:
            return self.generator(("quantity", tree))
        direction = self.direction(axis)
        if direction is None:
            if axis in self.directions:  # another axis, or its opposite
                return self.scalar(Quantity(tree.kind, (vector, self.directions[axis])))
            if not isinstance(vector, Quantity):
                return self._of_parts(tree, vector, axis)
            return self.generator(("quantity", tree))
        size = CONSTANT(1) if self._is_at_angle(axis) else self.size(direction)
        value = self.value(vector)
        if not isinstance(value, Plane):
            raise NotComparableError("a component of a number")
        if tree.kind == "across":
            direction = Plane(-direction.y, direction.x)
        return self.reduced((value.x * direction.x + value.y * direction.y) / size)

    def _of_parts(self, tree: Quantity, vector: Expression, axis: Expression) -> Quotient:
        """The component of a sum or a multiple: that of its parts."""
        kind = tree.kind
        match vector:
            case Negate(operand):
                return -self.scalar(Quantity(kind, (operand, axis)))
            case Binary("+" | "-", left, right):
                a, b = (self.scalar(Quantity(kind, (each, axis))) for each in (left, right))
                return a + b if vector.op == "+" else a - b
            case Polar(size, angle, origin, None) if origin == axis:
                cosine, sine = self.cos_sin(self.turn(angle))
                return self.scalar(size) * (cosine if kind == "along" else sine)
        return self.generator(("quantity", tree))

    # --- roots -----------------------------------------------------------------------------------

    def root(self, x: Quotient) -> Quotient:
        """The square root of what is not negative, with square factors taken out."""
        x = self.reduced(x)
        if x.vanishes:
            return x
        return self._root(x.above * x.below) / self._size_of(x.below)

    def _size_of(self, polynomial: PolyElement) -> Quotient:
        """The size of a polynomial, by those of its factors."""
        number, factors = factors_of(polynomial)
        ratio = _fraction(number)
        total = CONSTANT(abs(ratio))
        for factor, times in factors:
            odd = self._positive(factor) if times % 2 else CONSTANT(1)
            total = total * odd * Quotient(factor, quotient_ring().one) ** (times - times % 2)
        return total

    def put_in_order(self, less: Value, greater: Value) -> None:
        """Take up that one number is not less than another."""
        if isinstance(less, Plane) or isinstance(greater, Plane):
            return
        gap = greater - less
        number, factors = factors_of(gap.above) if gap.above else (0, [])
        if len(factors) == 1 and factors[0][1] == 1 and gap.below.is_ground:
            self.ordered.add(factors[0][0] if number > 0 else -factors[0][0])

    def _root(self, inside: PolyElement) -> Quotient:
        number, factors = factors_of(inside)
        outside, rest = CONSTANT(1), quotient_ring().one
        for factor, times in factors:
            if times // 2:
                outside = outside * self._positive(factor) ** (times // 2)
            if times % 2 and self._is_plainly_positive(factor):
                plain = self._denested(factor)
                outside = outside * (self._root_generator(factor) if plain is None else plain)
            elif times % 2:
                rest = rest * factor
        ratio = _fraction(number)
        if rest == 1:
            return outside * self._root_of_number(ratio)
        square, free = square_part(ratio.numerator * ratio.denominator)
        outside = outside * CONSTANT(Fraction(square, ratio.denominator))
        if free < 0:
            rest, free = -rest, -free
        plain = self._denested(rest * free)
        if plain is None:
            plain = self._root_of_number(Fraction(free)) * self._root_generator(rest)
        return outside * plain

    def _denested(self, inside: PolyElement) -> Quotient | None:
        """√(a + b√c) as √((a + d)/2) ± √((a − d)/2), where d² = a² − b²c has a rational d."""
        parts = self._surd(inside)
        if parts is None:
            return self._root_of_two_terms(inside)
        a, b, c = parts
        gap = a * a - b * b * c
        if a <= 0 or gap < 0:
            return None
        above, below = isqrt(gap.numerator), isqrt(gap.denominator)
        if above**2 != gap.numerator or below**2 != gap.denominator:
            return None
        d = Fraction(above, below)
        first, second = (self._root_of_number(each) for each in ((a + d) / 2, (a - d) / 2))
        return first + second if b > 0 else first - second

    def _root_of_two_terms(self, inside: PolyElement) -> Quotient | None:
        """√(ax² + 2√(ab) xy + by²) as √a x + √b y, where all of this is positive."""
        if len(inside) != 3 or not self._is_plainly_positive(inside):
            return None
        ends = [
            (powers, _fraction(value))
            for powers, value in inside.terms()
            if not any(each % 2 for each in powers)
        ]
        if len(ends) != 2:
            return None
        root = CONSTANT(0)
        for powers, value in ends:
            term = quotient_ring().from_dict({tuple(each // 2 for each in powers): QQ(1)})
            root = root + self._root_of_number(value) * Quotient(term, quotient_ring().one)
        difference = self.reduced(root * root - Quotient(inside, quotient_ring().one))
        return root if difference.vanishes else None

    def _surd(self, polynomial: PolyElement) -> tuple[Fraction, Fraction, Fraction] | None:
        """The a, b and c of a number a + b√c; None for anything else."""
        keys = self.keys(polynomial)
        terms = [(powers, _fraction(value)) for powers, value in polynomial.terms()]
        if len(terms) != 2 or any(
            key[0] != "root" or not key[1].is_ground for key in keys.values()
        ):
            return None
        (powers, b), (last, a) = terms if any(terms[0][0]) else reversed(terms)
        if any(last) or any(power > 1 for power in powers):
            return None
        radicands = [key[1].coeff(1) for number, key in keys.items() if powers[number]]
        return a, b, prod(map(_fraction, radicands), start=Fraction(1))

    def _root_of_number(self, ratio: Fraction) -> Quotient:
        square, free = square_part(ratio.numerator * ratio.denominator)
        total = CONSTANT(Fraction(square, ratio.denominator))
        if free < 0:
            raise NotComparableError("the root of a negative number")
        for prime in primes(free):
            total = total * self._root_generator(quotient_ring().ground_new(QQ(prime)))
        return total

    def _root_generator(self, inside: PolyElement) -> Quotient:
        own = self.generator(("root", inside))
        self.squares[self._keys["root", inside]] = inside
        return own

    def _positive(self, factor: PolyElement) -> Quotient:
        """The size of a factor: itself where it is made of positive generators."""
        if self._is_plainly_positive(factor):
            return Quotient(factor, quotient_ring().one)
        for each in (factor, -factor):
            if each in self.ordered or self._is_positive_between_ends(each):
                return Quotient(each, quotient_ring().one)
        surd = self._surd(factor)
        if surd is not None:
            a, b, c = surd
            leading = a if a * a > b * b * c else b  # the larger of the two has the sign
            return Quotient(factor if leading > 0 else -factor, quotient_ring().one)
        own = self.generator(("size", factor))
        self.squares[self._keys["size", factor]] = factor**2
        return own

    def _is_plainly_positive(self, factor: PolyElement) -> bool:
        """Whether a factor is a sum of what is positive, or at least not negative."""
        return all(value > 0 for value in factor.values()) and all(
            self._is_positive(key) for key in self.keys(factor).values()
        )

    def _is_positive_between_ends(self, factor: PolyElement) -> bool:
        """Whether a factor is linear in letters from 0 to 1, and not negative at their ends."""
        one = quotient_ring().one
        bounded = [
            number
            for number, key in self.keys(factor).items()
            if key[0] == "letter"
            and key[1] in self.nonnegative
            and one - self.generator(key).above in self.ordered
        ]
        if not bounded or any(powers[n] > 1 for powers in factor for n in bounded):
            return False
        for ends in itertools.product((0, 1), repeat=len(bounded)):
            there = quotient_ring().zero
            low = [number for number, end in zip(bounded, ends, strict=True) if not end]
            for powers, value in factor.items():
                if not any(powers[n] for n in low):
                    kept = tuple(0 if n in bounded else each for n, each in enumerate(powers))
                    there = there + quotient_ring().from_dict({kept: value})
            if not self._is_plainly_positive(there):
                return False
        return True

    def _is_positive(self, key: Key) -> bool:
        if key[0] == "letter":
            known = key[1] in self.nonnegative
            return known or self.roles.get(key[1], REAL).kind == "positive"
        if key[0] in ("cos", "sin"):
            terms, degrees = key[1]
            if terms and terms[0] == ():
                return True  # a number of degrees, below 45°
            atom, count = terms[0] if len(terms) == 1 and not degrees and terms[0] else ("", 2)
            return getattr(atom, "name", "") in self.nonnegative and 0 < count <= 1
        return key[0] in ("root", "size")

    def reduced(self, x: Quotient) -> Quotient:
        """The quotient with squares of roots (and of sines, where Pythagoras is named) put in."""
        if not self.squares:
            return x
        return lean(self._reduced(x.above), self._reduced(x.below))

    def reduced_value(self, x: Value) -> Value:
        """A scalar or a vector with squares of roots put in."""
        if isinstance(x, Plane):
            return Plane(self.reduced(x.x), self.reduced(x.y))
        return self.reduced(x)

    def _reduced(self, polynomial: PolyElement) -> PolyElement:
        for number in sorted(self.squares, reverse=True):
            square = self.squares[number]
            while any(powers[number] > 1 for powers in polynomial):
                total = quotient_ring().zero
                for powers, value in polynomial.items():
                    half, odd = divmod(powers[number], 2)
                    rest = (*powers[:number], odd, *powers[number + 1 :])
                    total = total + quotient_ring().from_dict({rest: value}) * (
                        square**half if half else quotient_ring().one
                    )
                polynomial = total
                if len(polynomial) > MOST_TERMS:
                    raise NotComparableError("a line of too many terms")
        return polynomial

    # --- angles ----------------------------------------------------------------------------------

    def is_angle(self, tree: Expression) -> bool:
        """Whether a tree is the measure of an angle, as far as its form tells."""
        match tree:
            case Degrees():
                return True
            case Letter(name):
                return name in self.angles
            case Negate(operand):
                return self.is_angle(operand)
            case Binary("+" | "-", left, right):
                return self.is_angle(left) or self.is_angle(right)
            case Binary("*", left, right):
                return self.is_angle(left) or self.is_angle(right)
            case Binary("/", left, _):
                return self.is_angle(left)
            case Apply(function, _):
                return function in _INVERSE
            case Quantity(kind, _):
                return kind in ANGLES and not self._is_wall_direction(tree)
        return False

    @staticmethod
    def _is_wall_direction(tree: Quantity) -> bool:
        return tree.kind == "direction" and tree.stage is None

    def turn(self, tree: Expression) -> Turn:
        """An angle as multiples of its parts. Raises NotComparableError."""
        match tree:
            case Degrees(value):
                return Turn((), value)
            case Pi():
                return Turn((), Fraction(180))
            case Number(value) if not value:
                return Turn()
            case Negate(operand):
                return self.turn(operand) * Fraction(-1)
            case Binary("+", left, right):
                return self.turn(left) + self.turn(right)
            case Binary("-", left, right):
                return self.turn(left) + self.turn(right) * Fraction(-1)
            case Binary("*", left, right):
                if (factor := _rational(left)) is not None:
                    return self.turn(right) * factor
                if (factor := _rational(right)) is not None:
                    return self.turn(left) * factor
            case Binary("/", left, right):
                if (factor := _rational(right)) is not None and factor:
                    return self.turn(left) * (1 / factor)
            case Letter() | Quantity():
                if tree in self.turns:
                    return self.turn(self.turns[tree])
                return Turn(((tree, Fraction(1)),))
        return Turn(((tree, Fraction(1)),))

    def _measure(self, tree: Expression) -> Quotient:
        """An angle as a number: a generator for each part, one for the degree."""
        turn = self.turn(tree)
        total = CONSTANT(turn.degrees) * self.generator(("degree",)) if turn.degrees else None
        for atom, count in turn.terms:
            term = CONSTANT(count) * self.generator(("angle", self._atom(atom)))
            total = term if total is None else total + term
        return CONSTANT(0) if total is None else total

    def _atom(self, atom: Atom) -> Atom:
        """An inverse function by the value inside it, so that equal ones are the same."""
        if isinstance(atom, Apply) and atom.function in _INVERSE:
            inside = self.scalar(atom.argument)
            return (atom.function, inside.above, inside.below)
        return atom

    def cos_sin(self, turn: Turn) -> tuple[Quotient, Quotient]:
        """The cosine and the sine of an angle."""
        plain = turn.degrees
        if not turn.terms:
            return self._plain_angle(plain)
        if "sum" in self.identities or (len(turn.terms) == 1 and self._multiples):
            cosine, sine = self._plain_angle(plain)
            for atom, count in turn.terms:
                c, s = self._multiple(atom, count)
                cosine, sine = cosine * c - sine * s, sine * c + cosine * s
            return self.reduced(cosine), self.reduced(sine)
        if "complement" in self.identities and plain % 90 == 0:
            cosine, sine = self._stranger(Turn(turn.terms))
            for _ in range(int(plain // 90) % 4):
                cosine, sine = -sine, cosine
            return cosine, sine
        return self._stranger(turn)

    @property
    def _multiples(self) -> bool:
        return bool(self.identities & {"double-angle", "half-angle"})

    def _stranger(self, turn: Turn) -> tuple[Quotient, Quotient]:
        """The cosine and the sine of an angle that is no multiple of any other."""
        if len(turn.terms) == 1 and not turn.degrees:
            ((atom, count),) = turn.terms
            if abs(count) == 1 and isinstance(atom, Apply) and atom.function in _INVERSE:
                cosine, sine = self._of_inverse(atom)
                return (cosine, sine) if count == 1 else (cosine, -sine)
        lead = turn.terms[0][1]
        if lead < 0:
            cosine, sine = self._stranger(turn * Fraction(-1))
            return cosine, -sine
        key = tuple((self._atom(atom), count) for atom, count in turn.terms), turn.degrees
        return self._pair(key)

    def _pair(self, key: AngleKey) -> tuple[Quotient, Quotient]:
        cosine, sine = self.generator(("cos", key)), self.generator(("sin", key))
        if self.identities & {"pythagoras", "double-angle", "half-angle", "sum"}:
            self.squares[self._keys["sin", key]] = 1 - cosine.above**2
        return cosine, sine

    def _multiple(self, atom: Atom, count: Fraction) -> tuple[Quotient, Quotient]:
        """The cosine and the sine of a multiple of an angle, in those of its smallest part."""
        divisor = lcm(count.denominator, self._divisors.get(atom, 1))
        times = count * divisor
        if times.denominator != 1 or abs(times) > MOST_POWER:
            raise NotComparableError("a part of an angle")
        c, s = self._stranger(Turn(((atom, Fraction(1, divisor)),)))
        cosine, sine = CONSTANT(1), CONSTANT(0)
        for _ in range(abs(int(times))):
            cosine, sine = self.reduced(cosine * c - sine * s), self.reduced(sine * c + cosine * s)
        return cosine, sine if times > 0 else -sine

    def divide_angles(self, trees: Iterable[Expression]) -> None:
        """Take note of the parts of angles in some trees, before identities relate them."""
        for tree in trees:
            for argument in _arguments(tree):
                for atom, count in self.turn(argument).terms:
                    self._divisors[atom] = lcm(self._divisors.get(atom, 1), count.denominator)

    def _of_inverse(self, atom: Apply) -> tuple[Quotient, Quotient]:
        x = self.scalar(atom.argument)
        acute = self._acute_angle_of(x) if atom.function == "arcsin" else None
        if acute is not None:
            return self._pair(acute)
        other = self.root(self.reduced(CONSTANT(1) - x * x)) if atom.function != "arctan" else None
        if atom.function == "arcsin" and other is not None:
            return other, x
        if other is not None:
            return x, other
        long = self.root(self.reduced(CONSTANT(1) + x * x))
        return CONSTANT(1) / long, x / long

    def _acute_angle_of(self, x: Quotient) -> AngleKey | None:
        """The angle of which an expression is the sine, where that is acute; None without one."""
        keys = self.keys(x.above)
        if len(keys) != 1:
            return None
        ((_, key),) = keys.items()
        if key[0] != "sin" or x != self.generator(key):
            return None
        terms, degrees = key[1]
        if len(terms) != 1 or degrees or not terms[0] or terms[0][1] != 1:
            return None
        role = self.roles.get(getattr(terms[0][0], "name", ""), REAL)
        if role.low is None or role.high is None or role.kind != "angle":
            return None
        return key[1] if role.low >= 0 and bool(role.high <= sp.pi / 2) else None

    def _plain_angle(self, degrees: Fraction) -> tuple[Quotient, Quotient]:
        """The cosine and the sine of a number of degrees: exact where roots have it."""
        turns, rest = divmod(degrees, 90)
        mirrored = rest > 45
        if mirrored:
            rest = 90 - rest
        cosine, sine = self._below_45(rest)
        if mirrored:
            cosine, sine = sine, cosine
        for _ in range(int(turns) % 4):
            cosine, sine = -sine, cosine
        return cosine, sine

    def _below_45(self, degrees: Fraction) -> tuple[Quotient, Quotient]:
        if not degrees:
            return CONSTANT(1), CONSTANT(0)
        if degrees == 30:
            return self._root_of_number(Fraction(3, 4)), CONSTANT(Fraction(1, 2))
        if degrees == 45:
            half = self._root_of_number(Fraction(1, 2))
            return half, half
        if degrees == 15:
            six, two = (self._root_of_number(Fraction(n, 16)) for n in (6, 2))
            return six + two, six - two
        return self._pair((((), Fraction(0)), degrees))

    # --- back to SymPy ---------------------------------------------------------------------------

    def expression(self, x: Quotient, roles: Mapping[str, Role]) -> sp.Expr:
        """A quotient as an expression for the oracle."""
        above, below = (self._expression(each, roles) for each in (x.above, x.below))
        return above / below

    def _expression(self, polynomial: PolyElement, roles: Mapping[str, Role]) -> sp.Expr:
        put = {n: self.symbol(key, roles) for n, key in self.keys(polynomial).items()}
        return sp.Add(
            *(
                sp.Mul(
                    sp.Rational(int(value.numerator), int(value.denominator)),
                    *(put[n] ** power for n, power in enumerate(powers) if power),
                )
                for powers, value in polynomial.items()
            )
        )

    def symbol(self, key: Key, roles: Mapping[str, Role]) -> sp.Expr:
        """What a generator stands for, as an expression for the oracle."""
        match key:
            case ("letter", name):
                return roles.get(name, REAL).symbol(name)
            case ("cos", turn):
                angle = self._radians(turn, roles)
                turns = turns_of(angle)
                return sp.cos(angle) if turns is None else cosine_of(turns)
            case ("sin", turn):
                angle = self._radians(turn, roles)
                turns = turns_of(angle)
                return sp.sin(angle) if turns is None else sine_of(turns)
            case ("root", inside):
                return sp.sqrt(self._expression(inside, roles))
            case ("size", inside):
                return sp.Abs(self._expression(inside, roles))
            case ("degree",):
                return sp.pi / 180
            case ("angle", atom):
                return self._atom_in_radians(atom, roles)
        return sp.Symbol(f"q_{self._keys[key]}", real=True)

    def _radians(self, key: AngleKey, roles: Mapping[str, Role]) -> sp.Expr:
        terms, degrees = key
        if terms and terms[0] == ():
            terms = ()
        total = sp.Rational(degrees.numerator, degrees.denominator) * sp.pi / 180
        for atom, count in terms:
            angle = self._atom_in_radians(atom, roles)
            total += sp.Rational(count.numerator, count.denominator) * angle
        return total

    def _atom_in_radians(self, atom: Atom, roles: Mapping[str, Role]) -> sp.Expr:
        if isinstance(atom, Letter):
            return roles.get(atom.name, REAL).symbol(atom.name)
        if isinstance(atom, tuple):
            function, above, below = atom
            inside = self._expression(above, roles) / self._expression(below, roles)
            return {"arcsin": sp.asin, "arccos": sp.acos, "arctan": sp.atan}[function](inside)
        self.generator(("angle", atom))
        return sp.Symbol(f"q_{self._keys['angle', atom]}", real=True)


def _scalar(x: Value) -> Quotient:
    if isinstance(x, Plane):
        raise NotComparableError("a vector where a number should stand")
    return x


def _scaled(x: Value, factor: Quotient) -> Value:
    if isinstance(x, Plane):
        return Plane(x.x * factor, x.y * factor)
    return x * factor


def _rational(tree: Expression) -> Fraction | None:
    match tree:
        case Number(value):
            return value
        case Negate(operand):
            inner = _rational(operand)
            return None if inner is None else -inner
        case Binary("/", left, right):
            above, below = _rational(left), _rational(right)
            return above / below if above is not None and below else None
        case Binary("*", left, right):
            a, b = _rational(left), _rational(right)
            return None if a is None or b is None else a * b
    return None


def _arguments(tree: Expression) -> Iterable[Expression]:
    for node in walk(tree):
        if isinstance(node, Apply) and node.function in _TRIGONOMETRIC:
            yield node.argument
        elif isinstance(node, Polar):
            yield node.angle


def _fraction(number: Any) -> Fraction:
    return Fraction(int(number.numerator), int(number.denominator))
