"""Trees of lines as quotients of polynomials over ℚ, so that two of them can be compared exactly.

A generator stands for each letter, each quantity of the motion that is not put in, and each
component of a vector of which that is true; for each root, with its square beside it; and for
the cosine and the sine of each angle (`roots`, `angles`).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import field
from fractions import Fraction

import sympy as sp
from sympy.polys.rings import PolyElement

from restitution.exact.degrees import cosine as cosine_of
from restitution.exact.degrees import sine as sine_of
from restitution.exact.degrees import turns_of
from restitution.explaining.lines.angles import INVERSE, TRIGONOMETRIC, Angles, Turn
from restitution.explaining.lines.generators import AngleKey, Atom, Key, Value
from restitution.explaining.lines.quotients import (
    CONSTANT,
    MOST_GENERATORS,
    NotComparableError,
    Plane,
    Quotient,
    factors_of,
    one,
    product,
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
    is_quantity,
)
from restitution.oracle.roles import REAL, Role
from restitution.oracle.scaled import scaled_sign
from restitution.records import dataclass


@dataclass
class World(Angles):
    """The generators in which some trees are compared.

    ``roles`` says what a letter of the statement may be; ``vectors`` and ``angles`` name letters
    that are such. ``directions`` gives the vector along which an axis, a wall or a vector letter
    points: what is cited of these. What is ``opaque`` is a generator, whatever is known of it.
    Vectors are resolved along ``base`` and at right angles to it, where that is not **i**.
    """

    vectors: frozenset[str] = frozenset()
    directions: Mapping[Expression, Expression] = field(default_factory=dict)
    opaque: frozenset[Expression] = frozenset()
    base: Expression | None = None
    _values: dict[Expression, Value] = field(default_factory=dict)

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
                return self._at_angle(Turn((), Fraction(0 if axis == "i" else 90)))
            case Pair(x, y):
                return self._of_components(self.scalar(x), self.scalar(y))
            case Polar():
                return self._polar(tree)
            case Negate(operand):
                return multiplied(self.value(operand), CONSTANT(-1))
            case Binary(op, left, right):
                return self._binary(tree, op, left, right)
            case Apply(function, argument):
                return self._apply(tree, function, argument)
            case Quantity():
                return self._quantity(tree)
            case Name():
                return self.direction(tree) or self._plane(tree)
        raise NotComparableError(repr(tree))

    def _of_components(self, x: Quotient, y: Quotient) -> Plane:
        """The vector of two components along **i** and **j**."""
        if self.base is None:
            return Plane(x, y)
        i, j = (self._at_angle(Turn((), Fraction(degrees))) for degrees in (0, 90))
        return Plane(self.reduced(x * i.x + y * j.x), self.reduced(x * i.y + y * j.y))

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
                b = multiplied(b, CONSTANT(-1))
            if isinstance(a, Plane) and isinstance(b, Plane):
                return Plane(self.reduced(a.x + b.x), self.reduced(a.y + b.y))
            return self.reduced(_scalar(a) + _scalar(b))
        if op == "*":
            if isinstance(b, Plane):
                a, b = b, a
            return self.reduced_value(multiplied(a, _scalar(b)))
        below = _scalar(b)
        if self.printed:
            self.denominators.append(below.above)
        return self.reduced_value(multiplied(a, CONSTANT(1) / below))

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
            base = self.higher_root(base, power.denominator)
            power = Fraction(power.numerator)
        return self.reduced(base ** int(power))

    def _apply(self, tree: Expression, function: str, argument: Expression) -> Value:
        if function in TRIGONOMETRIC:
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
        if function in INVERSE:
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
        turn = self.turn(tree.angle)
        if tree.wall is None and tree.origin is not None and self.is_angle(tree.origin):
            turn += self.turn(tree.origin)
        elif tree.wall is not None or tree.origin is not None:
            turn += self._turn_of_base()  # it is not measured from **i**
        unit = self._at_angle(turn)
        cosine, sine = unit.x, unit.y
        if tree.wall is not None:
            along = self.unit(Quantity("direction", (tree.wall,)))
            x, y = along.x * cosine + along.y * sine, along.y * cosine - along.x * sine
        elif tree.origin is None or self.is_angle(tree.origin):
            x, y = cosine, sine
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
        keys = [list(self.keys(component.above).values()) for component in (vector.x, vector.y)]
        if any(len(key) != 1 for key in keys):
            return False
        (one,), (other,) = keys
        if {one[0], other[0]} != {"cos", "sin"} or one[1] != other[1]:
            return False
        own = [self.generator(key) for key in (one, other)]
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

    def _turn_of_base(self) -> Turn:
        """The angle from **i** of the direction along which vectors are resolved."""
        return Turn() if self.base is None else self.turn(self.base)

    def _at_angle(self, turn: Turn) -> Plane:
        """The unit vector at an angle; one at right angles to another is that one turned."""
        turn += self._turn_of_base() * Fraction(-1)
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
                    self.unit(argument)
                    if is_quantity(argument, "line_of_centres")
                    else self.value(argument)
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
                a, b = (self.scalar(Quantity(kind, (tree, axis))) for tree in (left, right))
                return a + b if vector.op == "+" else a - b
            case Polar(size, angle, origin, None) if origin == axis:
                cosine, sine = self.cos_sin(self.turn(angle))
                return self.scalar(size) * (cosine if kind == "along" else sine)
        return self.generator(("quantity", tree))

    def root(self, x: Quotient) -> Quotient:
        """The square root; of the square of a number, (cos 40° − sin 40°)², as that stands."""
        inside = product(x.above, x.below)
        is_number = bool(inside) and self._is_of_numbers(x)
        if is_number and not any(times % 2 for _, times in factors_of(inside)[1]):
            return self._root(inside) / self._size_of(x.below)
        return super().root(x)

    def _positive(self, factor: PolyElement) -> Quotient:
        """The size of a factor; digits tell the sign of a number with sines of degrees."""
        if self._is_of_numbers(Quotient(factor, one())):
            sign = scaled_sign(self._expression(factor, {}), {})
            if sign:
                return Quotient(factor if sign > 0 else -factor, one())
        return super()._positive(factor)

    def _is_of_numbers(self, x: Quotient) -> bool:
        return all(self._is_number(key) for key in self.keys(x.above, x.below).values())

    def _is_number(self, key: Key) -> bool:
        """Whether a generator is the root of a number, or a ratio of a number of degrees."""
        match key:
            case ("root", inside):
                return all(self._is_number(own) for own in self.keys(inside).values())
            case ("cos" | "sin", ((first, *_), _)):
                return bool(first == ())
        return False

    # --- back to SymPy ---------------------------------------------------------------------------

    def expression(self, x: Quotient, roles: Mapping[str, Role]) -> sp.Expr:
        """A quotient as an expression for the oracle."""
        above, below = (self._expression(side, roles) for side in (x.above, x.below))
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
            case ("odd-root", power, number):
                return sp.Integer(number) ** sp.Rational(1, power)
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


def multiplied(x: Value, factor: Quotient) -> Value:
    """A scalar or a vector times a factor."""
    if isinstance(x, Plane):
        return Plane(x.x * factor, x.y * factor)
    return x * factor
