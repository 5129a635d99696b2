"""Angles by their parts, and the cosine and the sine of each.

Sines of different arguments (θ, 2θ, ½θ) are strangers, and so are the sine and the cosine of one,
unless an identity is named that relates them: a line that uses one has to say so. That tan is
sin/cos is free.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import field
from fractions import Fraction
from math import lcm
from typing import Literal

import sympy as sp

from restitution.explaining.lines.generators import AngleKey, Atom
from restitution.explaining.lines.quotients import (
    CONSTANT,
    MOST_POWER,
    NotComparableError,
    Quotient,
)
from restitution.explaining.lines.roots import Roots
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    EXACT_ANGLE,
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pi,
    Polar,
    Quantity,
    is_function,
    walk,
)
from restitution.oracle.roles import REAL
from restitution.records import dataclass

Identity = Literal["pythagoras", "double-angle", "half-angle", "sum", "complement", "degrees"]
"""What relates sines and cosines; "degrees" those of numbers of degrees, by multiples of 15°."""


TRIGONOMETRIC = frozenset({"sin", "cos", "tan", "cot", "sec", "cosec"})

INVERSE = frozenset({"arcsin", "arccos", "arctan"})


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
class Angles(Roots):
    """Generators, roots and angles.

    ``angles`` names letters that are such; ``turns`` gives the value of an angle that is cited.
    """

    angles: frozenset[str] = frozenset()
    turns: Mapping[Expression, Expression] = field(default_factory=dict)
    identities: frozenset[Identity] = frozenset()
    _divisors: dict[Atom, int] = field(default_factory=dict)

    def scalar(self, tree: Expression) -> Quotient:
        """A tree as a scalar. Raises NotComparableError."""
        raise NotImplementedError

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
                return function in INVERSE
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
        """An angle as a number: a generator for each part, one for the degree.

        The inverse tangent of a number above 1 is what that of its reciprocal leaves of 90°.
        """
        turn = self.turn(tree)
        for atom, count in turn.terms:
            if is_function(atom, "arctan") and (_rational(atom.argument) or 0) > 1:
                other = Apply("arctan", Binary("/", Number(Fraction(1)), atom.argument))
                turn += Turn(((atom, -count), (other, -count)), 90 * count)
        total = CONSTANT(turn.degrees) * self.generator(("degree",)) if turn.degrees else None
        for atom, count in turn.terms:
            term = CONSTANT(count) * self.generator(("angle", self._atom(atom)))
            total = term if total is None else total + term
        return CONSTANT(0) if total is None else total

    def _atom(self, atom: Atom) -> Atom:
        """An inverse function by the value inside it, so that equal ones are the same."""
        if isinstance(atom, Apply) and atom.function in INVERSE:
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
        """The cosine and the sine of an angle that is not a multiple of any other."""
        if len(turn.terms) == 1 and not turn.degrees:
            ((atom, count),) = turn.terms
            if abs(count) == 1 and isinstance(atom, Apply) and atom.function in INVERSE:
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
        """Takes note of the parts of angles in some trees, before identities relate them."""
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
        if degrees == EXACT_ANGLE:
            six, two = (self._root_of_number(Fraction(n, 16)) for n in (6, 2))
            return six + two, six - two
        times = round(degrees / EXACT_ANGLE)
        if times and "degrees" in self.identities and degrees % EXACT_ANGLE:
            exact = Fraction(times * EXACT_ANGLE)
            (c, s), (near, beside) = map(self._plain_angle, (exact, degrees - exact))
            return self.reduced(c * near - s * beside), self.reduced(s * near + c * beside)
        key: AngleKey = (((), Fraction(0)), degrees)
        cosine, sine = self._pair(key)
        self.squares[self._keys["sin", key]] = 1 - cosine.above**2
        return cosine, sine


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
        if isinstance(node, Apply) and node.function in TRIGONOMETRIC:
            yield node.argument
        elif isinstance(node, Polar):
            yield node.angle
