"""A claim that is not true: what its sides are worth, and numbers for which it fails."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.exact import rationalised, tidy, tidy_angle
from restitution.exact.symbols import symbol_names
from restitution.explaining.data.facts import links_of, staged
from restitution.explaining.lines.derivation import Link, Note, Ref, Relation
from restitution.expression.evaluate import Angle, in_letters
from restitution.expression.quantities import ANGLES
from restitution.expression.reading import read_number
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Polar,
    Quantity,
    has_quantity,
    is_binary,
    letters,
)
from restitution.oracle.roles import REAL
from restitution.planning.angles.turning import angle_line
from restitution.planning.inequalities.claims import Claims
from restitution.planning.inequalities.coming_back import write_meeting_again
from restitution.planning.inequalities.extrema import write_extremum
from restitution.planning.inequalities.ranges import only_answer, relation_of, write_range
from restitution.planning.routes.order import Solver
from restitution.planning.writing.desk import NotPlannedError, together
from restitution.planning.writing.forms import UnwrittenError, product, tree_of
from restitution.planning.writing.polynomials import expanded
from restitution.planning.writing.scene import Scene
from restitution.problem import Aligned, AtRest, Compare, Extremum, Meets, Range, Show
from restitution.solving.equations.solution import ItemResult
from restitution.solving.story.letters import roles
from restitution.vector import Vector

_SIGNS: Mapping[str, Callable[[float, float], bool]] = {
    "=": lambda a, b: abs(a - b) <= _NEAR * max(abs(a), abs(b)),
    "<": lambda a, b: a < b,
    "<=": lambda a, b: a <= b,
    ">": lambda a, b: a > b,
    ">=": lambda a, b: a >= b,
}
# An angle is printed to so many figures; to no more than the other number where that is too few.
_FIGURES, _MOST_FIGURES = 3, 16
_NEAR = 1e-9


def _body(velocity: Quantity) -> str:
    (body,) = velocity.arguments
    assert isinstance(body, Name)
    return body.name


def write_refutation(
    scene: Scene, solver: Solver, item: Show, result: ItemResult, now: int, name: str
) -> None:
    """Writes the quantities in a claim, and a note that it is not true, or is not decided."""
    if result.holds is None:
        scene.desk.note(name, "undecided")
        return
    refutation = _Refutation(scene, solver, item, result, now, name)
    standing = solver.mark()
    if not scene.others:
        try:
            refutation.write()
        except (NotPlannedError, UnwrittenError):
            solver.back(standing)
        else:
            return
    refutation.note(())


class _Refutation:
    """One claim that is not true, and the numbers that show it."""

    def __init__(
        self, scene: Scene, solver: Solver, item: Show, result: ItemResult, now: int, name: str
    ) -> None:
        self.scene = scene
        self.solver = solver
        self.item = item
        self.result = result
        self.now = now
        self.name = name
        self.links = links_of(scene.problem, item.relation, now)
        self.numbers = dict(_numbers(scene, result.counterexample or {}))

    def write(self) -> None:
        """Writes the lines of the quantities in the claim, and the note."""
        if self.item.subject is not None:
            self._write_subject(self.item.subject)
            return
        relation = self.item.relation
        with Claims(self.scene, self.solver) as claims:
            if isinstance(relation, Meets) and not self.numbers:
                other = replace(relation, happens=not relation.happens)
                true = write_meeting_again(claims, other, self.now)
                if true is not None:
                    self.note((true[0],))
                    return
            trees = list(self._trees())
            lines: list[int] = []
            rest = list(trees)
            for tree in trees:
                quotient = is_binary(tree, "/")
                worth = claims.worths.worth(tree) if quotient else None
                if worth is not None:
                    lines.append(worth)
                    rest.remove(tree)
            for quantity in dict.fromkeys(
                q for tree in rest for q in claims.worths.quantities(tree)
            ):
                if not claims.worths.is_data(quantity) or self._has_an_angle(quantity):
                    lines.append(self._worth(claims, quantity))
            lines += self._letters_worked_out(trees)
        self.note(tuple(dict.fromkeys(lines)), trees)

    def _worth(self, claims: Claims, quantity: Quantity) -> int:
        """The line that says what a quantity is; of a right angle, which has no tangent, itself."""
        value = self.scene.value(quantity)
        if isinstance(value, Angle) and self._square(value) is not None:
            velocities = [
                argument for argument in quantity.arguments if isinstance(argument, Quantity)
            ]
            for velocity in velocities:
                claims.worths.determine(velocity)
            if not velocities:
                claims.worths.determine_angle(quantity)
            return angle_line(self.scene, quantity)
        return claims.worths.angle_by_letter(quantity) or claims.worths.quantity(quantity)

    def _has_an_angle(self, velocity: Quantity) -> bool:
        """Whether a velocity of the data is told by its size and direction, and is claimed one."""
        fact = self.scene.facts.get(f"velocity {_body(velocity)}")
        if fact is None or not isinstance(self.item.relation, Aligned):
            return False
        return isinstance(fact.relation.only[-1].right, Polar)

    def _write_subject(self, subject: Range | Extremum) -> None:
        """The range, or the greatest or least value, that is the true one."""
        scene, solver, name = self.scene, self.solver, self.name
        asked = staged(scene.problem, subject.expression, self.now)
        match subject:
            case Range():
                sides = relation_of(asked, self.result).options[0]
                write_range(scene, solver, asked, relation_of(asked, self.result), name)
            case Extremum():
                true = only_answer(self.result, always=True)
                sides = (Link(asked, "=", tree_of(true.value, angle=true.angle)),)
                write_extremum(
                    scene, solver, subject.kind, asked, subject.over, true, true.value, name
                )
        self.note((scene.desk.ends.pop().line,), sides=sides)

    def _letters_worked_out(self, trees: Iterable[Expression]) -> Iterator[int]:
        """The lines that say what letters are that are worked out."""
        scene = self.scene
        for name in sorted({name for tree in trees for name in letters(tree)}):
            symbol = scene.model.unknowns.letter(name)
            if symbol not in scene.model.final:
                continue
            self.solver.determine([symbol])
            known = scene.desk.known(Letter(name))
            yield from (ref for ref in (known.refs if known else ()) if isinstance(ref, int))

    def _trees(self) -> Iterator[Expression]:
        """What the claim compares, with its letters for quantities opened."""
        relation = self.item.relation
        match relation:
            case Compare():
                failing = self._failing()
                yield from (failing.left, failing.right)
            case AtRest(body):
                yield self._staged(Quantity("velocity", (body,)))
            case Aligned(left, _, right):
                yield from (self._staged(e) for e in (left, right) if has_quantity(e))
            case Meets(first, second):
                for name in (first, second):
                    if name.name in self.scene.model.story.spheres:
                        yield self._staged(Quantity("velocity", (name,)))

    def _staged(self, tree: Expression) -> Expression:
        return staged(self.scene.problem, tree, self.now)

    def _failing(self) -> Link:
        """The link of a chain that fails; the only one of most."""
        for link in self.links[:-1]:
            left, right = (self._number(side) for side in (link.left, link.right))
            if left is not None and right is not None and not _SIGNS[link.sign](left, right):
                return link
        return self.links[-1]

    # --- the note -------------------------------------------------------------------------------

    def note(
        self,
        lines: Sequence[int],
        trees: Iterable[Expression] = (),
        sides: tuple[Link, ...] = (),
    ) -> None:
        """The note, with the premises that it needs and no more letters than these."""
        claim = Relation((self.links,)) if self.links else None
        trees = list(trees)
        used = {letter for tree in trees for letter in self._letters(tree)}
        used |= {name for name, value in self.numbers.items() if self._is_negative(name, value)}
        numbers = {name: value for name, value in self.numbers.items() if name in used}
        if not trees:
            numbers = dict(self.numbers)
        desk = self.scene.desk
        note = desk.new_note(self.name, "refuted", claim=claim)
        note = replace(note, premises=self._premises(note, lines, numbers))
        scales = [name for name, value in numbers.items() if value == 1 and self._is_scale(name)]
        for scale in scales:
            fewer = {other: value for other, value in numbers.items() if other != scale}
            if self._excluded(self._at(note, fewer)):
                numbers = fewer
        if isinstance(self.item.relation, Meets):
            plainer = {**numbers, **dict.fromkeys(self._ratios(trees, numbers), sp.Integer(2))}
            numbers = plainer if self._excluded(self._at(note, plainer)) else numbers
        note = self._at(note, numbers)
        if trees and (note.premises or not lines):
            sides = tuple(self._sides(trees, numbers))
        if sides and sides == note.instance:
            sides = (*sides, *self._beside(numbers))
        desk.notes.append(replace(note, sides=sides))

    def _beside(self, numbers: Mapping[str, sp.Expr]) -> Iterator[Link]:
        """What the letters are that are found in the letters of the numbers."""
        known = roles(self.scene.problem)
        for symbol, value in self.scene.model.final.items():
            own = sp.sympify(value, strict=True)
            if symbol.name in known and symbol_names(own) <= set(numbers):
                put = {symbol: numbers[symbol.name] for symbol in own.free_symbols}
                angle = known[symbol.name].kind == "angle"
                there = tree_of(_plain(own.xreplace(put)), angle=angle)
                yield Link(Letter(symbol.name), "=", there)

    def _ratios(self, trees: Sequence[Expression], numbers: Mapping[str, sp.Expr]) -> Iterator[str]:
        """The letters without a number on which the ratio of two velocities depends."""
        values = [self._value(tree, numbers) for tree in trees]
        if len(values) == 2 and all(isinstance(value, Vector) for value in values):
            for one, other in zip(*values, strict=True):
                if one != 0 != other:
                    free = tidy(one / other).free_symbols
                    yield from sorted(value.name for value in free)

    def _premises(
        self, note: Note, lines: Sequence[int], numbers: Mapping[str, sp.Expr]
    ) -> tuple[Ref, ...]:
        """Lines and facts that exclude the claim; nothing where they do not."""
        plain = self._at(replace(note, premises=tuple(lines)), numbers)
        if self._excluded(plain, quickly=True):
            for line in lines:
                fewer = replace(plain, premises=tuple(e for e in plain.premises if e != line))
                if self._excluded(fewer, quickly=True):
                    plain = fewer
            return plain.premises
        named = together(lines, self.scene.desk.meanings(lines))
        axes = together(named, self._data("axis ", "wall "))
        data = together(axes, self._data("velocity "))
        for pool in dict.fromkeys((tuple(lines), named, axes, data)):
            own = self._at(replace(note, premises=pool), numbers)
            if not self._excluded(own):
                continue
            for ref in pool:
                fewer = replace(own, premises=tuple(e for e in own.premises if e != ref))
                if self._excluded(fewer):
                    own = fewer
            return own.premises
        beyond = self._at(replace(note, premises=tuple(lines)), numbers)
        return beyond.premises if self._excluded(beyond, unknown=True) else ()

    def _data(self, *kinds: str) -> Iterator[str]:
        """The facts of some kinds."""
        for fact in self.scene.desk.facts:
            if fact.id.startswith(kinds):
                yield fact.id

    def _excluded(self, note: Note, unknown: bool = False, *, quickly: bool = False) -> bool:
        return self.scene.judge.excludes(note, unknown, quickly=quickly)

    def _at(self, note: Note, numbers: Mapping[str, sp.Expr]) -> Note:
        known = roles(self.scene.problem)
        instance = tuple(
            Link(Letter(name), "=", tree_of(value, angle=known[name].kind == "angle"))
            for name, value in numbers.items()
        )
        return replace(note, instance=instance)

    def _is_negative(self, letter: str, value: sp.Expr) -> bool:
        """Whether a letter of either sign is not positive: a given fact may rest on its sign."""
        return roles(self.scene.problem)[letter] == REAL and not value.is_positive

    def _is_scale(self, letter: str) -> bool:
        return roles(self.scene.problem)[letter].kind == "positive"

    # --- values where it fails ------------------------------------------------------------------

    def _sides(self, trees: Iterable[Expression], numbers: Mapping[str, sp.Expr]) -> Iterator[Link]:
        """What the sides are worth with the numbers; those that are numbers are not said.

        Of a value that is claimed to some figures, as a decimal; so an angle that is near a bound.
        """
        trees = tuple(dict.fromkeys(trees))
        figures = getattr(self.item.relation, "figures", None)
        bounds = [tree for tree in trees if not letters(tree) and not has_quantity(tree)]
        for tree in trees:
            if tree in bounds:
                continue
            if figures is not None:
                yield Link(tree, "≈", self._rounded(tree, figures, {}))
                return
            value = self._value(tree, numbers)
            if not has_quantity(tree) and value == self.scene.value(tree):
                yield Link(tree, "=", tree)
                continue
            angle = isinstance(value, sp.Basic) and self._is_angle(tree)
            apart = _figures_apart(value, self._value(bounds[0], {})) if angle and bounds else None
            if apart is not None:
                yield Link(tree, "≈", self._rounded(tree, apart, numbers))
            else:
                yield Link(tree, "=", tree_of(value, angle=angle))

    def _rounded(
        self, tree: Expression, figures: int, numbers: Mapping[str, sp.Expr]
    ) -> Expression:
        """What a side is worth, its number to some figures."""
        value = self._value(tree, numbers)
        if isinstance(value, Vector):
            raise NotPlannedError("a vector to some figures")
        angle = self._is_angle(tree)
        value = sp.deg(value) if angle else value
        units = dict.fromkeys(value.free_symbols, sp.Integer(1))
        number = sp.Rational(str(sp.N(value.xreplace(units), figures)))
        number_ = Fraction(number.p, number.q)
        if angle:
            return Degrees(number_)
        scale = tidy(value / value.xreplace(units))
        return product(Number(number_), tree_of(scale))

    def _is_angle(self, tree: Expression) -> bool:
        """Whether a side is an angle, which is printed in degrees."""
        match tree:
            case Letter(name):
                known = roles(self.scene.problem).get(name)
                return known is not None and known.kind == "angle"
            case Quantity(kind):
                return kind in ANGLES
            case Negate(operand):
                return self._is_angle(operand)
            case Binary(op, left, right) if op != "^":
                return self._is_angle(left) or self._is_angle(right)
        return False

    def _letters(self, tree: Expression) -> frozenset[str]:
        value = self.scene.value(tree)
        parts: Iterable[Any] = value if isinstance(value, Vector) else (value,)
        if isinstance(value, Angle):
            parts = () if self._square(value) is not None else (value.x, value.y)
        return symbol_names(*(self._in_data(part) for part in parts))

    def _in_data(self, value: Any) -> sp.Expr:
        return sp.sympify(self.scene.model.in_data(sp.sympify(value, strict=True)), strict=True)

    def _value(self, tree: Expression, numbers: Mapping[str, sp.Expr]) -> Any:
        value = self.scene.value(tree)
        if isinstance(value, Vector):
            return Vector(*(self._there(component, numbers) for component in value))
        if isinstance(value, Angle) and (square := self._square(value)) is not None:
            return square
        if isinstance(value, Angle):
            x, y = (self._there(component, numbers) for component in (value.x, value.y))
            scale = {s: sp.Integer(1) for s in x.free_symbols | y.free_symbols if s.is_positive}
            x, y = (_plain(value.xreplace(scale)) for value in (x, y))
            if x.free_symbols | y.free_symbols or (x, y) == (0, 0):
                raise NotPlannedError("an angle that numbers do not fix")
            return tidy_angle(sp.atan2(y, x))
        return self._there(value, numbers)

    def _square(self, angle: Angle) -> sp.Expr | None:
        """The value of an angle that is a right angle for all that the letters may be."""
        if tidy(self._in_data(angle.x)) != 0:
            return None
        sign = self.scene.model.proved_sign(angle.y)
        return None if not sign else sign * sp.pi / 2

    def _there(self, value: Any, numbers: Mapping[str, sp.Expr]) -> sp.Expr:
        own = self._in_data(value)
        put = {
            symbol: numbers[symbol.name] for symbol in own.free_symbols if symbol.name in numbers
        }
        return _plain(own.xreplace(put))

    def _number(self, tree: Expression) -> float | None:
        """What a side is worth, as a float; None for a vector."""
        value = self._value(tree, self.numbers)
        if isinstance(value, Vector):
            return None
        value = sp.sympify(value, strict=True)
        return float(value.xreplace(dict.fromkeys(value.free_symbols, sp.Integer(1))))


def _figures_apart(angle: sp.Expr, bound: sp.Expr) -> int | None:
    """How many figures tell an angle in degrees from a bound; None where the usual ones do."""
    if not (angle.is_number and bound.is_number) or sp.deg(angle).is_Rational:
        return None
    for figures in range(_FIGURES, _MOST_FIGURES):
        if str(sp.N(sp.deg(angle), figures)) != str(sp.N(sp.deg(bound), figures)):
            return figures if figures > _FIGURES else None
    return None


def _plain(x: sp.Expr) -> sp.Expr:
    if not x.is_number:
        return tidy(x)
    plain = rationalised(x)
    return tidy(sp.sqrtdenest(sp.radsimp(expanded(x))) if plain is None else plain)


def _numbers(scene: Scene, given: Mapping[str, str]) -> Iterator[tuple[str, sp.Expr]]:
    """The numbers for which a claim fails, by the letters of the statement."""
    known = roles(scene.problem)
    for name, text in given.items():
        if name in known:
            value: Any = in_letters(read_number(text))
            yield name, sp.sympify(value, strict=True)
