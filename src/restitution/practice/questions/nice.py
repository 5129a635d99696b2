"""Numbers as examination papers choose them: angles, coefficients, masses, velocities as text."""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from itertools import combinations
from typing import TYPE_CHECKING, Any

import sympy as sp

from restitution import law
from restitution.expression.tree import Binary, Number, has_unit_vector, is_binary, walk
from restitution.expression.writing import write_expression
from restitution.practice.questions.dice import Dice
from restitution.problem import Problem, trees
from restitution.records import dataclass
from restitution.vector import Vector

if TYPE_CHECKING:
    from restitution.solving.equations.solution import Solution

MOST_DENOMINATOR = 60
_MOST_NUMERATOR = 2500

COEFFICIENTS = tuple(
    map(
        Fraction,
        ("1/5", "1/4", "1/3", "2/5", "3/7", "1/2", "4/7", "3/5", "2/3", "3/4", "4/5", "9/10"),
    )
)
TRIPLES = ((3, 4, 5), (4, 3, 5), (5, 12, 13), (12, 5, 13), (8, 15, 17), (15, 8, 17), (7, 24, 25))
"""Opposite, adjacent and hypotenuse."""


@dataclass(frozen=True)
class Acute:
    """An acute angle: its tangent as text, or its degrees, and its cosine and sine as squares.

    ``hypotenuse`` is by what a speed is divided in its components, for whole ones.
    """

    across: int
    along: int
    hypotenuse: int

    @property
    def tangent(self) -> Fraction:
        """The tangent of the angle."""
        return Fraction(self.across, self.along)

    @property
    def fact(self) -> tuple[str, str, str]:
        """What a question may say of the angle alpha: its tangent, sine or cosine."""
        return (
            f"tan(alpha) = {self.across}/{self.along}",
            f"sin(alpha) = {self.across}/{self.hypotenuse}",
            f"cos(alpha) = {self.along}/{self.hypotenuse}",
        )


def unlike_numbers(d: Dice, first: range, second: range) -> tuple[int, int]:
    """Two whole numbers that differ, each out of its range."""
    return d.of([(a, b) for a in first for b in second if a != b])


def acute(d: Dice, most: int = 13) -> Acute:
    """A Pythagorean angle, with a hypotenuse up to ``most``."""
    return Acute(*d.of([triple for triple in TRIPLES if triple[2] <= most]))


def coefficient(d: Dice, *sizes: Fraction | int) -> Fraction:
    """A coefficient of restitution with which products with some sizes are simple."""
    best = [e for e in COEFFICIENTS if all((e * Fraction(x)).denominator <= 2 for x in sizes)]
    return d.of(best or COEFFICIENTS)


def mass(d: Dice) -> str:
    """A mass: 1 to 6, or in tenths."""
    if d.below(4) == 0:
        return f"0.{d.of((2, 3, 4, 5, 6, 8))}"
    return d.of(("2", "3", "4", "5", "1.5", "0.5", "6"))


def masses(d: Dice) -> tuple[Fraction, Fraction]:
    """Two masses that differ: whole, or in tenths."""
    one, other = unlike_numbers(d, range(1, 7), range(1, 7))
    unit = Fraction(1, 10) if d.below(4) == 0 else Fraction(1)
    return one * unit, other * unit


def number(x: Fraction | int) -> str:
    """A fraction as text: whole, as a decimal of one place in tenths, or as a/b."""
    x = Fraction(x)
    if x.denominator in (10, 5, 2) and abs(x) < 1:
        return f"{float(x):g}"
    return f"{x}"


def ratio(x: Fraction | int) -> str:
    """A fraction as text, never as a decimal."""
    return f"{Fraction(x)}"


def times(x: Fraction | int, letter: str) -> str:
    """A number times a letter, as people write it: ``3u``, ``u``, ``1/2 u``."""
    x = Fraction(x)
    if x == 1:
        return letter
    return f"{x}{letter}" if x.denominator == 1 else f"{x} {letter}"


def vector(x: Fraction | int, y: Fraction | int, letter: str = "") -> str:
    """A vector as text, its components times a letter: ``3u i - 4u j``."""
    text = ""
    for value, axis in ((Fraction(x), "i"), (Fraction(y), "j")):
        if not value:
            continue
        sign = "-" if value < 0 else "+" if text else ""
        space = " " if text else ""
        size = abs(value)
        factor = times(size, letter) + " " if letter else ("" if size == 1 else _factor(size))
        text += f"{space}{sign}{space}{factor}{axis}"
    return text or "0i"


def _factor(size: Fraction) -> str:
    return f"{size}" if size.denominator == 1 else f"{size} "


def sphere(name: str, motion: str, weight: str = "") -> str:
    """The line of a sphere: ``motion`` is its velocity, or ``at rest``; without a mass if empty."""
    return f"sphere {name}: " + (f"mass {weight}, {motion}" if weight else motion)


def lines_of(*lines: str) -> str:
    """A statement of some lines; empty ones are left out."""
    return "\n".join(line for line in lines if line) + "\n"


# --- two spheres along their line ---------------------------------------------------------------


@dataclass(frozen=True)
class Pair:
    """Two spheres that collide: masses, components along and across before, e, along after."""

    m1: Fraction
    m2: Fraction
    p1: Fraction
    s1: Fraction
    p2: Fraction
    s2: Fraction
    e: Fraction
    q1: Fraction
    q2: Fraction


def pair(
    d: Dice,
    *,
    at_rest: bool = False,
    both_across: bool = True,
    denominators: int = 6,
    reach: int = 6,
    equal: bool = False,
) -> Pair:
    """Components of a collision with simple values, all of unlike size.

    ``denominators`` bounds those of the components after, ``reach`` the components before.
    """
    while True:
        m1, m2 = (Fraction(1), Fraction(1)) if equal else masses(d)
        p1, s1 = Fraction(d.between(1, reach)), Fraction(d.between(1, reach) * d.sign())
        p2, s2 = Fraction(0), Fraction(0)
        if not at_rest:
            p2 = Fraction(d.between(1, reach) * d.sign())
            s2 = Fraction(d.between(1, reach) * d.sign()) if both_across else Fraction(0)
        given = [p1, s1, *((p2,) if p2 else ()), *((s2,) if s2 else ())]
        if p2 >= p1 or not unlike(given):
            continue
        options = []
        for e in COEFFICIENTS:
            q1, q2 = along_after(m1, m2, p1, p2, e)
            simple = q1.denominator <= denominators and q2.denominator <= denominators
            if simple and unlike([*given, q1, q2]):
                options.append(Pair(m1, m2, p1, s1, p2, s2, e, q1, q2))
        if options:
            return d.of(options)


@dataclass(frozen=True)
class Slanted:
    """A collision with the line of centres not along an axis: velocities by components."""

    m1: Fraction
    m2: Fraction
    line: tuple[int, int]
    e: Fraction
    u1: Vector
    u2: Vector
    v1: Vector
    v2: Vector


LINES = ((3, 4), (4, 3), (4, -3), (3, -4), (1, 1), (1, -1), (2, 1), (1, 2), (2, -1), (1, -2))


def slanted(d: Dice, *, at_rest: bool = False, denominators: int = 3, reach: int = 8) -> Slanted:
    """A collision along a slanting line, of small whole components before and simple ones after."""
    while True:
        m1, m2 = masses(d)
        x, y = d.of(LINES)
        c = Vector(Fraction(x), Fraction(y))
        u1, u2 = (
            Vector(Fraction(d.between(-reach, reach)), Fraction(d.between(-reach, reach)))
            for _ in range(2)
        )
        if at_rest:
            u2 = Vector(Fraction(0), Fraction(0))
        sizes = [u1.dot(c), c.cross(u1), *(() if at_rest else (u2.dot(c), c.cross(u2)))]
        if not unlike(sizes) or u1.dot(c) <= max(u2.dot(c), 0):
            continue
        options = []
        for e in COEFFICIENTS:
            v1, v2 = law.impact(u1, u2, m2, m1, c, e)
            parts = (*v1, *v2)
            simple = all(part.denominator <= denominators for part in parts)
            if simple and unlike([*sizes, v1.dot(c), v2.dot(c)]):
                options.append(Slanted(m1, m2, (x, y), e, u1, u2, v1, v2))
        if options:
            return d.of(options)


def along_after(
    m1: Fraction, m2: Fraction, p1: Fraction, p2: Fraction, e: Fraction
) -> tuple[Fraction, Fraction]:
    """The components along the line of centres after a collision."""
    c = Vector(Fraction(1), Fraction(0))
    u1, u2 = Vector(p1, Fraction(0)), Vector(p2, Fraction(0))
    v1, v2 = law.impact(u1, u2, m2, m1, c, e)
    return v1.x, v2.x


def masses_of(c: Pair, letter: str = "") -> tuple[str, str]:
    """Both masses as text, times a letter if one is given: then they are whole."""
    if letter:
        scale = Fraction(1) if c.m1.denominator == c.m2.denominator == 1 else Fraction(10)
        return times(c.m1 * scale, letter), times(c.m2 * scale, letter)
    return number(c.m1), number(c.m2)


def unlike(sizes: list[Fraction]) -> bool:
    """Whether no two numbers are equal in size, and none is zero."""
    return all(sizes) and all(abs(a) != abs(b) for a, b in combinations(sizes, 2))


# --- nice values --------------------------------------------------------------------------------


def is_nice(value: Any) -> bool:
    """Whether an exact value is a fraction, or holds one square root, of small numbers.

    Letters may stand beside them. An angle is judged by its tangent.
    """
    parts = value if isinstance(value, tuple | list) else (value,)
    return all(_is_nice(sp.sympify(part, strict=True)) for part in parts)


@cache
def _is_nice(x: sp.Expr) -> bool:
    roots = set()
    for node in sp.preorder_traversal(x):
        if isinstance(node, sp.Rational) and not _is_small(node):
            return False
        if node.is_Pow and node.exp.is_Rational and node.exp.q != 1 and node.base.is_number:
            if node.exp.q != 2 or not node.base.is_Rational:
                return False
            roots.add(node.base)
    return len(roots) <= 1


def _is_small(x: sp.Rational) -> bool:
    return bool(x.q <= MOST_DENOMINATOR and abs(x.p) <= _MOST_NUMERATOR)


def too_large(problem: Problem) -> bool:
    """Whether a component of a velocity that a statement gives is larger than people choose."""
    return any(
        isinstance(node, Number) and node.value > MOST_COMPONENT
        for sphere in problem.spheres
        if sphere.velocity is not None and has_unit_vector(sphere.velocity)
        for node in walk(sphere.velocity)
    )


MOST_COMPONENT = 15


def ugly_value(solution: Solution) -> str:
    """A value of the route that is not nice, in words, or nothing.

    The route holds the numbers of the statement, components along and across each line of
    centres, and the answers.
    """
    for tree in trees(solution.problem):
        for node in walk(tree):
            if isinstance(node, Number) and node.value.denominator > MOST_DENOMINATOR:
                return write_expression(node)
            if is_binary(node, "/") and _is_large(node):
                return write_expression(node)
    for part in solution.parts.values():
        for branch in part.branches[:1]:
            for happening in branch.story.happenings:
                for velocity in happening.after.values():
                    if not is_nice(tuple(velocity)):
                        return "a velocity"
    for item in (item for part in solution.parts.values() for item in part.items):
        for answer in item.answers[:1]:
            if item.kind in ("value", "vector") and not is_nice(answer.value):
                return item.text
    return ""


def _is_large(node: Binary) -> bool:
    return isinstance(node.right, Number) and node.right.value > MOST_DENOMINATOR
