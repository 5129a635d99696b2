"""The grammar of expressions in a student's working: one reading of the tokens of a side.

It is wider than that of statements and shares its trees. Where people mean different things
(``3u/2m``, ``1/2mv^2``, ``sin a/x``), it asks which reading is wanted (`Cursor.choose`). It never
looks ahead more than a few tokens and never backtracks, so that a run takes a time in proportion
to the length of the text.
"""

from __future__ import annotations

from fractions import Fraction

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
    Quantity,
    Unit,
    is_binary,
    walk,
)
from restitution.practice.reading.angles import angular, radians
from restitution.practice.reading.cursor import Cursor, UnreadableError
from restitution.practice.reading.phrase_names import UNNAMED_ANGLE
from restitution.practice.reading.tokens import Token
from restitution.practice.reading.vocabulary import INVERSES
from restitution.practice.script import column_of

MAX_DEPTH = 30

_OPERANDS = frozenset(
    ("number", "letter", "name", "unit", "pi", "phrase", "function", "(", "vector")
)
_TRIGONOMETRIC = frozenset(("sin", "cos", "tan", "cot", "sec", "cosec"))


def is_vector(tree: Expression, vectors: frozenset[str]) -> bool:
    """Whether a tree is a vector, as far as its form tells; ``vectors`` are letters that are."""
    match tree:
        case Unit() | Pair():
            return True
        case Letter(name):
            return name in vectors
        case Negate(operand):
            return is_vector(operand, vectors)
        case Binary("+" | "-", left, right):
            return is_vector(left, vectors) or is_vector(right, vectors)
        case Binary("*", left, right):
            return is_vector(left, vectors) != is_vector(right, vectors)
        case Binary("/", left, _):
            return is_vector(left, vectors)
        case Quantity("velocity" | "momentum" | "line_of_centres"):
            return True
        case Quantity("impulse", arguments):
            return bool(arguments)
    return False


class Parser(Cursor):
    """Reads the tokens of a side as an expression."""

    # -- sums and products --------------------------------------------------------------------

    def side(self) -> Expression:
        """The whole side."""
        tree = self.sum()
        if self.position < len(self.tokens):
            closing = self.kind() == ")"
            raise self.fail("a '(' before this ')'" if closing else "an operation such as + or ×")
        return tree

    def sum(self) -> Expression:
        """Terms with their signs."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.fail("fewer brackets within brackets")
        tree = self.signed()
        while self.kind() in ("+", "-", "±"):
            sign = self.take()
            right = self.signed() if self.kind() in ("+", "-", "±") else self.product()
            minus = sign.kind == "-" or (sign.kind == "±" and self.lower)
            tree = Binary("-" if minus else "+", tree, right, place=self.place(sign))
        self.depth -= 1
        return tree

    def signed(self) -> Expression:
        """A term with a sign of its own, or several: ``--1``."""
        negative, first = False, self.position
        while self.kind() in ("+", "-", "±"):
            if self.position - first > 6:
                raise self.fail("a number or a letter")
            sign = self.take()
            bullet = sign.kind == "-" and not sign.start and self.kind() and self.token().gap
            if bullet and self.choose("bullet"):
                continue
            negative ^= sign.kind == "-" or (sign.kind == "±" and self.lower)
        tree = self.product()
        return Negate(tree) if negative else tree

    def product(self) -> Expression:
        """Factors, with or without a sign between them, and quotients."""
        tree = self.factor()
        while True:
            kind = self.kind()
            if kind in ("*", "times", "dot"):
                sign = self.take()
                if sign.value and self.choose("x") == (sign.value == 2):
                    tree = Binary("*", tree, Letter("x", place=self.place(sign)))
                    continue
                tree = self.multiplied(tree, self.signed_factor(), sign)
            elif kind in ("/", ":"):
                sign = self.take()
                tree = self.quotient(tree, sign)
            elif self.begins_factor():
                tree = self.multiplied(tree, self.factor(), None)
            elif kind == "measure":
                tree = self.measure(tree)
            else:
                return tree

    def measure(self, tree: Expression) -> Expression:
        """A value with its unit, which adds nothing; a J may be the letter of an impulse."""
        token = self.take()
        if token.value and self.choose("unit") == (token.value == 1):
            return Binary("*", tree, Letter("J", place=self.place(token)))
        return tree

    def begins_factor(self) -> bool:
        """Whether a factor stands next without a sign before it."""
        kind = self.kind()
        if kind == "number":
            return self.position > 0 and self.may_multiply_numbers()
        if kind == "|":
            return not self.bars
        return kind in _OPERANDS

    def may_multiply_numbers(self) -> bool:
        """Whether a number may stand behind what is there: ``1/2 3m``, but not ``3 4``."""
        if self.kind(-1) == "number":
            fraction = self.position > 1 and self.kind(-2) == "/"
            return fraction and self.token().gap > 0
        return self.kind(-1) not in ("percent", "degrees")

    def multiplied(self, left: Expression, right: Expression, sign: Token | None) -> Expression:
        """The product of two factors; of two vectors the scalar product."""
        vectors = self.usage.vectors
        both = is_vector(left, vectors) and is_vector(right, vectors)
        if sign is None and (isinstance(left, Letter | Unit) or isinstance(right, Letter | Unit)):
            both = False  # v i is a component along i
        symbols = sign is not None and sign.kind == "dot" and _may_be_vectors(left, right)
        moving = [self.is_sphere(tree) for tree in (left, right)]
        if symbols and any(moving) and any(is_vector(tree, vectors) for tree in (left, right)):
            both = True  # A.n is of the velocity of A, before or after
            if self.choose("velocity before"):
                left, right = (
                    Quantity("velocity", (tree,), 0) if is_name else tree
                    for tree, is_name in zip((left, right), moving, strict=True)
                )
        if both or (symbols and self.choose("scalar product")):
            return Quantity("dot", (left, right))
        return Binary("*", left, right)

    def is_sphere(self, tree: Expression) -> bool:
        """Whether a factor is the name of a sphere."""
        return isinstance(tree, Name) and tree.name in self.usage.spheres

    def signed_factor(self) -> Expression:
        """A factor behind × or /, perhaps with a sign."""
        if self.kind() in ("-", "+", "±"):
            sign = self.take()
            inside = self.signed_factor()
            minus = sign.kind == "-" or (sign.kind == "±" and self.lower)
            return Negate(inside) if minus else inside
        return self.factor()

    def quotient(self, above: Expression, sign: Token) -> Expression:
        """A quotient by one factor, or by the whole product that stands behind the line."""
        first = self.position
        wide = sign.text == "÷" or (sign.gap > 0 and bool(self.kind()) and self.token().gap > 0)
        below = self.signed_factor()
        if wide and self.is_within() and not self.choose("division"):
            inner = self.take()
            below = Binary("/", below, self.signed_factor(), place=self.place(inner))
        elif self.is_over_fraction(above, below) and self.choose("fraction below a number"):
            inner = self.take()
            below = Binary("/", below, self.factor(), place=self.place(inner))
        if self.begins_factor() and self.kind() not in ("unit", "phrase"):
            whole = self.wants_whole(above, first)
            if self.choose("quotient") ^ whole:
                glued = False
                while self.begins_factor() and self.kind() not in ("unit", "phrase"):
                    if self.kind() == "(" and self.choose("brackets behind a denominator"):
                        break
                    if glued and self.token().gap and self.choose("space behind a denominator"):
                        break  # 8u/3m n
                    glued = not self.token().gap
                    below = self.multiplied(below, self.factor(), None)
                if wide and self.is_within() and not self.choose("division"):
                    inner = self.take()
                    below = Binary("/", below, self.signed_factor(), place=self.place(inner))
        return Binary("/", above, below, place=self.place(sign))

    def is_over_fraction(self, above: Expression, below: Expression) -> bool:
        """Whether three numbers stand below each other: ``4/95/16`` may be 4 by 95/16."""
        numbers = isinstance(above, Number) and isinstance(below, Number)
        return numbers and self.is_within() and self.kind(1) == "number"

    def is_within(self) -> bool:
        """Whether a line of a quotient stands next that belongs to a denominator: ``¼ / 1/2``."""
        return self.kind() == "/" and self.token().text == "/" and not self.token().gap

    def wants_whole(self, above: Expression, first: int) -> bool:
        """Whether people mean the whole product behind the line: ``3u/2m``, not ``1/2mv²``."""
        if _is_number(above):
            return False
        next_one = self.token()
        if self.tokens[first].kind in ("letter", "function"):
            return next_one.kind in ("letter", "function", "(")
        return next_one.kind == "letter" and next_one.gap == 0

    # -- factors ------------------------------------------------------------------------------

    def factor(self) -> Expression:
        """A primary with its powers."""
        if self.kind() == "function":
            return self.powers(self.function())
        tree = self.primary()
        return self.powers(tree)

    def powers(self, tree: Expression) -> Expression:
        """A tree raised to the powers behind it."""
        count = 0
        while self.kind() == "^" and count < 4:
            sign = self.take()
            tree = Binary("^", tree, self.exponent(), place=self.place(sign))
            count += 1
        return tree

    def exponent(self) -> Expression:
        """What stands behind ^: a number, a letter, or brackets, perhaps with a sign."""
        if self.kind() in ("-", "+"):
            minus = self.take().kind == "-"
            inside = self.exponent()
            return Negate(inside) if minus else inside
        if self.kind() not in ("number", "letter", "("):
            raise self.fail("a power")
        tree = self.primary()
        if any(isinstance(node, Number) and node.value > 20 for node in walk(tree)):
            raise self.fail("a power of at most 20")
        return tree

    def primary(self) -> Expression:
        """A number, a letter, a name, brackets or bars."""
        kind = self.kind()
        if kind == "number":
            return self.number()
        if kind == "letter":
            return self.behind_angle(self.letter())
        if kind == "phrase":
            token = self.take()
            return Letter(token.name, place=self.place(token))
        if kind == "name":
            token = self.take()
            return Name(token.name, place=self.place(token))
        if kind == "unit":
            token = self.take()
            return Unit("i" if token.name == "i" else "j", place=self.place(token))
        if kind == "pi":
            return Pi(place=self.place(self.take()))
        if kind == "(":
            return self.behind_angle(self.brackets())
        if kind == "|" and not self.bars:
            return self.size()
        raise self.fail("a number or a letter")

    def letter(self) -> Expression:
        """A letter; ``v2`` may be the square of v."""
        token = self.take()
        head, _, subscript = token.name.partition("_")
        typed = subscript == "2" and token.text == f"{head}2"
        if typed and head in self.usage.squares and not self.choose("square"):
            return Binary("^", Letter(head, place=self.place(token)), Number(Fraction(2)))
        return Letter(token.name, place=self.place(token))

    def number(self) -> Expression:
        """A number with its percent or degree sign."""
        token = self.take()
        place = self.place(token)
        if self.kind() == "percent":
            self.take()
            whole = self.choose("percent")
            return Number(token.value if whole else token.value / 100, place=place)
        if self.kind() == "degrees":
            self.take()
            return Degrees(token.value, place=place)
        if self.kind() == "radians":
            self.take()
            self.radians.add(token.column)
            return radians(Number(token.value, place=place))
        return Number(token.value, place=place)

    def behind_angle(self, tree: Expression) -> Expression:
        """A letter or brackets with a degree sign behind, which adds nothing to a letter."""
        if self.kind() == "degrees":
            self.take()
            return angular(tree, self.usage.angles)
        if self.kind() == "radians":
            self.take()
        return tree

    def brackets(self) -> Expression:
        """A group, or a pair of components; a bracket missing at the end is put there."""
        opening = self.take()
        bars, self.bars = self.bars, 0
        first = self.position
        tree = self.sum()
        if self.kind() in (",", ";"):
            self.take()
            tree = Pair(tree, self.sum(), place=self.place(opening))
        elif self.kind() == "number" and self.token().gap:
            tree = Pair(tree, self.sum(), place=self.place(opening))
        elif self.is_column(tree, first) and self.choose("column"):
            assert isinstance(tree, Binary)
            right = Negate(tree.right) if tree.op == "-" else tree.right
            tree = Pair(tree.left, right, place=self.place(opening))
        self.bars = bars
        if self.kind() == ")":
            self.take()
        elif self.position < len(self.tokens):
            raise self.fail("a ')'")
        return tree

    def is_column(self, tree: Expression, first: int) -> bool:
        """Whether brackets hold ``3 -4``: a difference, or a column on one line."""
        if not (is_binary(tree, "+", "-") and self.position - first == 3):
            return False
        sign, right = self.tokens[first + 1], self.tokens[first + 2]
        return sign.gap > 0 and right.gap == 0

    def size(self) -> Expression:
        """What stands between two bars; of a body, its speed."""
        opening = self.take()
        self.bars += 1
        inside = self.sum()
        self.bars -= 1
        if self.kind() == "|":
            self.take()
        elif self.position < len(self.tokens):
            raise self.fail("a second '|'")
        if isinstance(inside, Name):
            return Letter(f"speed of {inside.name}", place=self.place(opening))
        return Apply("abs", inside, place=self.place(opening))

    # -- functions ------------------------------------------------------------------------------

    def function(self) -> Expression:
        """A function with its power and its argument."""
        token = self.take()
        name, power = self.function_power(token.name)
        if self.kind() == "(":
            argument = self.share_of_angle(name, self.brackets())
        else:
            argument = self.bare(name)
        if name in _TRIGONOMETRIC:
            if isinstance(argument, Pair):
                raise UnreadableError("one angle", token.column)
            argument = self.angle(argument)
        if name == "abs" and isinstance(argument, Name):
            return Letter(f"speed of {argument.name}", place=self.place(token))
        tree: Expression = Apply(name, argument, place=self.place(token))
        return tree if power is None else Binary("^", tree, power)

    def share_of_angle(self, name: str, tree: Expression) -> Expression:
        """An argument in brackets; ``tan(1/2)α``, as of ``tan½α``, is that of half the angle."""
        half = is_binary(tree, "/") and _is_number(tree)
        angle = self.kind() == "letter" and self.token().name in self.usage.angles
        if half and angle and name in _TRIGONOMETRIC:
            return Binary("*", tree, self.primary())
        return tree

    def angle(self, argument: Expression) -> Expression:
        """The argument of a sine: bare numbers in it are degrees, but behind ``rad``."""
        columns = {column_of(node) for node in walk(argument) if isinstance(node, Number)}
        if columns & self.radians:
            return argument
        turned = angular(argument, self.usage.angles)
        if turned != argument and _may_be_radians(argument) and self.choose("radians"):
            return argument
        return turned

    def function_power(self, name: str) -> tuple[str, Expression | None]:
        """The inverse function, or the power between a function and its argument."""
        if self.kind() == "word":  # pragma: no cover - words are taken out before
            self.take()
        if self.kind() == "^":
            self.take()
            exponent = self.exponent()
            if exponent == Negate(Number(Fraction(1))) and name in INVERSES:
                return INVERSES[name], None
            return name, exponent
        if name in INVERSES and self.is_inverse():
            self.take()
            self.take()
            return INVERSES[name], None
        powered = name in _TRIGONOMETRIC and self.is_typed_power()
        if powered and not self.choose("power of a function"):
            token = self.take()
            return name, Number(token.value, place=self.place(token))
        return name, None

    def is_inverse(self) -> bool:
        """Whether ``-1`` stands between a function and its argument: ``tan-1(3/4)``."""
        if self.kind() != "-" or self.kind(1) != "number" or self.token(1).value != 1:
            return False
        return self.token(1).gap == 0 and self.kind(2) in ("(", "number", "letter", "function", "-")

    def is_typed_power(self) -> bool:
        """Whether a 2 is a power without its sign: ``sin2(a)``, ``sin2 30``."""
        if self.kind() != "number" or self.token().value not in (2, 3) or self.token().gap:
            return False
        if self.kind(1) == "number":
            return True
        behind = self.kind(1) in ("letter", "(")
        return behind and (self.usage.powers or self.kind(1) == "(" or self.token(1).gap > 0)

    def bare(self, name: str) -> Expression:
        """The argument of a function without brackets."""
        self.depth += 1
        if self.depth > MAX_DEPTH:
            raise self.fail("fewer functions of functions")
        negative = False
        while self.kind() in ("-", "+") and self.kind(1) in ("number", "letter", "(", "-"):
            negative ^= self.take().kind == "-"
        if self.kind() == "function":
            tree = self.function()
        elif self.kind() in ("number", "letter", "pi", "name", "|", "phrase"):
            tree = self.bare_multiple(name)
        elif self.kind() == "(":
            tree = self.brackets()
        elif not self.kind() and name in _TRIGONOMETRIC:
            tree = Letter(UNNAMED_ANGLE)
        else:
            raise self.fail("the angle" if name in _TRIGONOMETRIC else "a number or a letter")
        tree = self.bare_quotient(name, tree)
        if name in _TRIGONOMETRIC:
            tree = self.bare_angles(tree)
        elif name == "sqrt":
            tree = self.bare_radicand(tree)
        self.depth -= 1
        return Negate(tree) if negative else tree

    def bare_multiple(self, name: str) -> Expression:
        """A number, a letter, or a number times a letter that is an angle."""
        number = self.kind() == "number"
        tree = self.primary()
        if name in ("sqrt", "abs") or name.startswith("arc"):
            tree = self.powers(tree)
        if not number or isinstance(tree, Degrees):
            return tree
        usual = self.kind() == "pi" or (
            self.kind() == "letter" and self.token().name in self.usage.angles
        )
        angle = usual and name in _TRIGONOMETRIC
        if angle or (self.kind() in ("letter", "pi") and not self.token().gap):
            usual = usual and name != "sqrt"
            if angle or self.choose("multiple") ^ usual:
                return Binary("*", tree, self.primary())
        return tree

    def bare_quotient(self, name: str, tree: Expression) -> Expression:
        """An argument that is a quotient: ``tan^-1 3/4``; ``sin a/2`` in one of its readings."""
        if self.kind() != "/" or self.kind(1) not in ("number", "letter"):
            return tree
        usual = name.startswith("arc") or isinstance(tree, Pi)
        if self.choose("argument") ^ usual:
            sign = self.take()
            return Binary("/", tree, self.factor(), place=self.place(sign))
        return tree

    def bare_angles(self, tree: Expression) -> Expression:
        """A sum of angles without brackets: ``sin 90 - a``."""
        while self.kind() in ("+", "-") and self.kind(1) in ("letter", "number"):
            behind = self.token(1)
            letter = behind.kind == "letter" and behind.name in self.usage.angles
            degrees = behind.kind == "number" and self.kind(2) == "degrees"
            if not (letter or degrees) or self.kind(2) in ("^", "*", "times", "function"):
                return tree
            if self.choose("sum of angles"):
                return tree
            op = self.take().kind
            tree = Binary("-" if op == "-" else "+", tree, self.primary())
        return tree

    def bare_radicand(self, tree: Expression) -> Expression:
        """A root over a sum without brackets: ``√3^2 + 4^2``."""
        if self.kind() not in ("+", "-"):
            return tree
        usual = is_binary(tree, "^")
        last = self.kind(1) == "number" and self.kind(2) == ""
        if not usual and not (last and isinstance(tree, Number) and self.position == 2):
            return tree
        if self.choose("radicand") ^ usual:
            while self.kind() in ("+", "-"):
                sign = self.take()
                op = "-" if sign.kind == "-" else "+"
                tree = Binary("-" if op == "-" else "+", tree, self.product())
        return tree


def _is_number(tree: Expression) -> bool:
    """Whether a numerator is a number, perhaps with a sign or a root."""
    return not any(isinstance(node, Letter | Name | Quantity) for node in walk(tree))


def _may_be_vectors(left: Expression, right: Expression) -> bool:
    return all(
        isinstance(tree, Letter | Name) or is_vector(tree, frozenset()) for tree in (left, right)
    )


def _may_be_radians(tree: Expression) -> bool:
    """Whether a number in an argument may be one of radians: a decimal below 2π."""
    return any(
        isinstance(node, Number) and node.value.denominator != 1 and node.value < 7
        for node in walk(tree)
    )
