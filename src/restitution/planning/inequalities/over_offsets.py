"""What is greatest or least over an offset: worked out by the angle of the line of centres."""

from __future__ import annotations

from collections.abc import Iterator

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move, equality
from restitution.expression.tree import Apply, Letter
from restitution.oracle.roles import Role
from restitution.planning.axes.offsets import ratios_by_offsets, write_sine
from restitution.planning.writing.checking import measured
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.records import dataclass
from restitution.solving.story.letters import roles
from restitution.vector import Vector


def role_of(scene: Scene, symbol: sp.Symbol) -> Role:
    """What a letter of the statement, or of the working, may be."""
    own = roles(scene.problem).get(symbol.name)
    return scene.model.unknowns.roles[symbol.name] if own is None else own


@dataclass(frozen=True)
class OffsetOver:
    """The letter of an offset, and the angle of which the offset tells the sine."""

    scene: Scene
    offset: sp.Symbol
    angle: sp.Symbol
    equation: GivenEquation

    def place(self, place: Link) -> Link | None:
        """The offset at which the tangent of the angle has a value; None of any other place."""
        if place.left != Apply("tan", Letter(self.angle.name)):
            return None
        tangent = self.scene.scalar(place.right)
        own = sp.solve(self._sine - tangent / sp.sqrt(1 + tangent**2), self.offset)
        if len(own) != 1:
            return None
        return Link(Letter(self.offset.name), "=", tree_of(tidy(own[0])))

    def ratios(self) -> tuple[int, ...]:
        """The lines of the ratios of the angle by the offset."""
        sine = write_sine(self.scene, self.equation)
        tangent = self.scene.desk.write(
            Move("triangle"),
            (sine, f"acute: {self.angle.name}"),
            equality(
                Apply("tan", Letter(self.angle.name)),
                tree_of(tidy(self._sine / sp.sqrt(1 - self._sine**2))),
            ),
            "silent",
        )
        return (tangent, sine)

    @property
    def _sine(self) -> sp.Expr:
        return self.scene.scalar(self.equation.link.right)


def write_by_offset(scene: Scene, name: str) -> None:
    """The answer of an item in which the ratios of such an angle are put in by the offset."""
    end = scene.desk.ends[-1]
    if len(end.answer.options) > 1:
        return  # of several values each stands as it is
    link = end.answer.only[-1]
    value = measured(scene.value(link.right))
    if value in scene.kept:
        _write_angle_by_offset(scene, name, value)
        return
    parts = tuple(value) if isinstance(value, Vector) else (value,)
    if not all(isinstance(part, sp.Expr) for part in parts):
        return
    angles = {symbol for part in parts for symbol in part.free_symbols} & scene.kept
    if not angles:
        return
    ratios, refs = ratios_by_offsets(scene, *parts)
    put = [tidy(part.xreplace(ratios)) for part in parts]
    relation = equality(link.left, tree_of(put[0] if len(put) == 1 else Vector(*put)))
    line = scene.judge.write((Move("put"),), [end.line, *refs], relation)
    if line is not None:
        scene.desk.ends.pop()
        scene.desk.end(name, line, relation)


def _write_angle_by_offset(scene: Scene, name: str, angle: sp.Symbol) -> None:
    """The answer that is such an angle itself, by its sine."""
    end = scene.desk.ends[-1]
    equation = next(equation for own, equation in _open(scene) if own == angle)
    sine = write_sine(scene, equation)
    value = Apply("arcsin", equation.link.right)
    relation = equality(Letter(angle.name), value)
    line = scene.desk.write(Move("inverse"), (sine, f"acute: {angle.name}"), relation)
    final = equality(end.answer.only[-1].left, value)
    line = scene.judge.write((Move("put"),), [end.line, line], final) or line
    scene.desk.ends.pop()
    scene.desk.end(name, line, final)


def offset_over(scene: Scene, symbol: sp.Symbol) -> OffsetOver | None:
    """The angle that serves for an offset that is left open; None of any other letter."""
    for angle, equation in _open(scene):
        if symbol in equation.residuals[0].free_symbols:
            return OffsetOver(scene, symbol, angle, equation)
    return None


def _open(scene: Scene) -> Iterator[tuple[sp.Symbol, GivenEquation]]:
    """The angles of which no ratio is put in, with the equations of their sines."""
    for equation in scene.of_offsets:
        for angle in equation.residuals[0].free_symbols & scene.kept:
            yield angle, equation


__all__ = ["OffsetOver", "offset_over", "role_of", "write_by_offset"]
