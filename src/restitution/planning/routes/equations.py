"""The equations that may be used: laws, facts, paths, what was shown; and the cheapest sets."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import Link, Move
from restitution.expression.tree import (
    Apply,
    Binary,
    Letter,
    Name,
    Quantity,
    has_quantity,
    letters,
)
from restitution.planning.formulas.impacts import residual
from restitution.planning.formulas.impulse_formulas import body_of_impulse
from restitution.planning.journeys import paths, rounds
from restitution.planning.routes.choice import Point, Routes, points
from restitution.planning.routes.givens import candidate_of, move_of
from restitution.planning.writing import place_trees
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.polynomials import expanded, factor_powers, one_fraction
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.records import dataclass

_OF_WHAT_IS_SHOWN, _OF_A_NUMBER = 0.3, 0.2

SHOWN = "shown "
"""How the ids of lines that were to be shown begin."""


@dataclass(frozen=True)
class Law:
    """A law of an impact as an equation of a route."""

    kind: str
    number: int
    candidate: Candidate
    body: str | None = None


class Equations:
    """The equations of a scene, and which of them have been used."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.laws = [*self._laws(), *self._across()]
        self.givens = {equation.fact.id: equation for equation in scene.given}
        self.paths = {path.candidate.id: path for path in paths.paths(scene)}
        self.rounds = {way_round.candidate.id: way_round for way_round in rounds.rounds(scene)}
        self.used: set[str] = set()
        self._taken_at: tuple[tuple[int, int], tuple[Point, ...]] | None = None

    def _laws(self) -> Iterable[Law]:
        model = self.scene.model
        for law in model.laws:
            wall = model.frames[law.number].wall is not None
            kind = "wall" if wall else law.kind
            cost = 1.0 if wall else 2.0
            own = Candidate(f"{kind} {law.number}", cost, (law.residual,))
            yield Law(kind, law.number, own)

    def _across(self) -> Iterable[Law]:
        """Components across that are given after an impact: they tie letters of the data."""
        model = self.scene.model
        for number, frame in model.frames.items():
            for body in self.scene.spheres(number):
                given = self._given_velocity(body, number)
                if given is None:
                    continue
                after_ = self.scene.vector(given.link.right).dot(frame.t)
                before_ = self.scene.velocity(body, number - 1).dot(frame.t)
                residual_ = tidy(after_ - before_)
                if residual_ != 0:
                    id_ = f"unchanged {number} {body}"
                    yield Law("unchanged", number, Candidate(id_, 1.0, (residual_,)), body)

    def _given_velocity(self, body: str, number: int) -> GivenEquation | None:
        velocity = Quantity("velocity", (Name(body),), number)
        for equation in self.scene.given:
            if equation.link.sign == "=" and equation.link.left == velocity:
                return equation
        return None

    def routes(
        self, goals: Sequence[sp.Expr], expressed: Collection[sp.Symbol] = ()
    ) -> list[tuple[Candidate, ...]]:
        """The cheapest sets of equations that determine some values, that to be taken first.

        What is only to be ``expressed`` is as good as known.

        Raises NotPlannedError where nothing determines them.
        """
        scene = self.scene
        candidates = [
            Candidate(
                own.id,
                own.cost,
                tuple(scene.with_values(difference)[0] for difference in own.residuals),
            )
            for own in (
                *(law.candidate for law in self.laws),
                *(self._of_given(equation) for equation in scene.given),
                *(path.candidate for path in self.paths.values()),
                *(way_round.candidate for way_round in self.rounds.values()),
                *self._shown(),
            )
            if own.id not in self.used and not self._holds(own)
        ]
        put = [scene.with_values(goal)[0] for goal in goals]
        unknowns = frozenset(
            s for candidate in candidates for x in candidate.residuals for s in scene.unknown(x)
        ) | frozenset(s for x in put for s in scene.unknown(x))
        unknowns -= set(expressed)
        routes = Routes(candidates, self._points(), unknowns).cheapest(put)
        if not routes:
            # A square has no slope where it is zero; what is squared has one.
            plain = [replace(own, residuals=self._without_powers(own)) for own in candidates]
            routes = Routes(plain, self._points(), unknowns).cheapest(put)
        if not routes:
            raise NotPlannedError(f"nothing determines {goals}")
        chosen = min(scene.desk.route, len(routes)) - 1
        return [routes[chosen], *routes[:chosen], *routes[chosen + 1 :]]

    def _without_powers(self, own: Candidate) -> tuple[sp.Expr, ...]:
        """The residuals of an equation, each without powers of factors that vanish."""
        model = self.scene.model
        plain: list[sp.Expr] = []
        for difference in own.residuals:
            factors = factor_powers(sp.fraction(one_fraction(_without_root(difference)))[0])
            zero = [base for base, _ in factors if model.sign(model.in_data(base)) == 0]
            is_power = any(power > 1 and base in zero for base, power in factors)
            plain.append(sp.Mul(*zero) if is_power else difference)
        return tuple(plain)

    def _points(self) -> tuple[Point, ...]:
        """The points at which gradients are taken; a hidden unknown may be new among them."""
        known = len(self.scene.model.final), len(self.scene.model.sample)
        if self._taken_at is None or self._taken_at[0] != known:
            self._taken_at = known, points(self.scene.model)
        return self._taken_at[1]

    def _shown(self) -> Iterator[Candidate]:
        """The equations that were to be shown: they cost less than what they come of.

        That of the tangent of a sum is none: with numbers put in, it is no equation to solve.
        """
        for number in self.scene.desk.shown:
            if self.scene.desk.holds(number) and not _is_of_a_sum(self.scene, number):
                gap = residual(self.scene, number)
                yield Candidate(f"{SHOWN}{number}", _OF_WHAT_IS_SHOWN, (gap,))

    def _holds(self, own: Candidate) -> bool:
        """Whether an equation tells nothing new: with what is known it holds of itself."""
        put = [self.scene.with_values(difference)[0] for difference in own.residuals]
        changed = all(a is not b for a, b in zip(put, own.residuals, strict=True))
        return changed and all(expanded(value) == 0 or _is_nothing(value) for value in put)

    def _of_given(self, equation: GivenEquation) -> Candidate:
        """A given fact; of a velocity only the component along the line of centres."""
        own = candidate_of(equation)
        if equation.link.sign == "=" and place_trees.is_about_times(equation.link):
            return replace(own, residuals=paths.residuals(self.scene, equation.link))
        match equation.link:
            case Link(Letter(), "=", right) if not (letters(right) or has_quantity(right)):
                # What is given as a number is not worked out from what was shown.
                return replace(own, cost=min(own.cost, _OF_A_NUMBER))
            case Link(Quantity("velocity", (Name(body),), int(stage)), "=", right):
                if stage in self.scene.model.frames:
                    frame = self.scene.model.frames[stage]
                    gap = self.scene.velocity(body, stage) - self.scene.vector(right)
                    return replace(own, residuals=(tidy(gap.dot(frame.n)),))
            case Link(Quantity("impulse", (), int(event)), "=", right):
                if event in self.scene.model.frames and len(self.scene.spheres(event)) > 1:
                    size = self._impulse(event)
                    return replace(own, residuals=(size - self.scene.scalar(right),))
        return own

    def _impulse(self, event: int) -> sp.Expr:
        """The size of an impulse by the change of momentum of the body that a line takes."""
        scene = self.scene
        spheres, body = scene.spheres(event), body_of_impulse(scene, event)
        change = scene.velocity(body, event) - scene.velocity(body, event - 1)
        towards = 1 if body == spheres[1] else -1  # the axis leads from the first to the second
        mass = scene.model.story.mass(body)
        return expanded(towards * mass * change.dot(scene.model.frames[event].n))

    def move(self, own: Candidate) -> Move:
        """The principle, or the definition, that an equation of a route is."""
        law = self.law(own)
        if own.id.startswith(SHOWN):
            return Move("put")
        if own.id in self.paths:
            return paths.move_of(self.paths[own.id])
        if own.id in self.rounds:
            return rounds.move_of(self.rounds[own.id])
        if law is None:
            return move_of(self.givens[own.id])
        record = "restitution-wall" if law.kind == "wall" else law.kind
        bodies = (law.body,) if law.body else self.scene.bodies(law.number)
        return Move("law", record, law.number, bodies)

    def law(self, own: Candidate) -> Law | None:
        """The law that an equation of a route is; None of another."""
        return next((law for law in self.laws if law.candidate.id == own.id), None)


def _is_of_a_sum(scene: Scene, number: int) -> bool:
    """Whether a line says what a tangent of a sum or a difference of angles is."""
    left = scene.desk.relation(number).options[0][0].left
    return isinstance(left, Apply) and isinstance(left.argument, Binary)


def _is_nothing(x: sp.Expr) -> bool:
    """Whether a quotient has nothing above, once it is one fraction."""
    above, below = sp.fraction(one_fraction(x))
    return bool(below.free_symbols) and expanded(above) == 0


def _without_root(x: sp.Expr) -> sp.Expr:
    """A sum with one root of letters, times the one with that root of the other sign."""
    roots = [p for p in x.atoms(sp.Pow) if p.exp == sp.Rational(1, 2) and p.free_symbols]
    if len(roots) != 1:
        return x
    (root,) = roots
    rest = x.xreplace({root: sp.Integer(0)})
    share = expanded((x - rest) / root)
    return x if share.has(root) else expanded(rest**2 - share**2 * root.base)
