"""Equations that close: which one a last unknown is found by, and which two."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

import sympy as sp

from restitution.exact import in_sines, tidy
from restitution.exact.symbols import symbol_names
from restitution.expression.tree import Letter, Name, Quantity, is_quantity, walk
from restitution.planning.angles.speeds_at_walls import resolved_at_a_wall, start_by_what_follows
from restitution.planning.axes.given_momenta import write_masses
from restitution.planning.closing.known_values import with_known
from restitution.planning.closing.pairs import close_two
from restitution.planning.closing.systems import solve_together
from restitution.planning.formulas.impacts import residual
from restitution.planning.formulas.shares_left import speed_compared
from restitution.planning.routes.by_laws import ByLaws
from restitution.planning.routes.givens import candidate_of, write_impulse_on
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.desk import NotPlannedError
from restitution.planning.writing.polynomials import expanded, factor_powers, factored, one_fraction
from restitution.planning.writing.scene import GivenEquation


class Closing(ByLaws):
    """Steps that close an equation, or two, or all that are left."""

    def _together(
        self, left: Sequence[Candidate], goals: Sequence[sp.Expr]
    ) -> tuple[Candidate, ...] | None:
        """All equations that are left, solved in one line."""
        asked = frozenset(symbol for goal in goals for symbol in self.scene.unknown(goal))
        lines = [self._line(candidate) for candidate in left]
        try:
            solve_together(self.scene, [line for line in lines if line is not None], asked)
        except NotPlannedError as error:
            self.reasons.append(error)
            return None
        return tuple(left)

    def _essential(self, own: Candidate) -> frozenset[sp.Symbol]:
        """The unknowns of an equation without factors that do not vanish."""
        open_ = self._open(own)
        if len(open_) < 2 or len(own.residuals) != 1:
            return open_
        model = self.scene.model
        put, _ = self.scene.put(own.residuals[0])
        squares = _of_equal_roots(put)
        if squares is not None:
            put, open_ = squares, open_ & self.scene.unknown(squares)
        if open_ & self._letters.keys() and not self._is_of_direction(own):
            return open_ - self._cancelling(own, put)
        put = put.replace(sp.Abs, lambda x: x * model.sign(model.in_data(x)))
        put = in_sines(put)
        above = sp.fraction(one_fraction(put))[0]
        factors = [base for base, _ in factor_powers(above)]
        zero = [factor for factor in factors if model.sign(model.in_data(factor)) == 0]
        return frozenset(s for value in zero or [put] for s in self.scene.unknown(value))

    def _is_of_direction(self, own: Candidate) -> bool:
        """Whether a fact tells the direction of a body that moves along the line of centres."""
        given = self.equations.givens.get(own.id)
        match given and given.link.left:
            case Quantity("direction", (Name(body),), int(number)):
                frame = self.scene.model.frames.get(number)
                if frame is None or frame.wall is not None:
                    return False
                return bool(tidy(self.scene.velocity(body, number - 1).dot(frame.t)) == 0)
        return False

    def _cancelling(self, own: Candidate, put: sp.Expr) -> frozenset[sp.Symbol]:
        """The masses that are a factor of a given fact: it holds without them."""
        if own.id not in self.equations.givens:
            return frozenset()
        factors = sp.Mul.make_args(factored(sp.fraction(one_fraction(put))[0]))
        return frozenset(factor for factor in factors if factor.is_Symbol and factor.is_positive)

    def _closing(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """An equation with one unknown letter."""
        for own in left:
            open_ = self._essential(own)
            if len(open_) > 1 and self._is_place(own):
                # The laws at walls are written on the way to a place.
                open_ -= self._after_walls()
            if len(open_) != 1:
                continue
            (symbol,) = open_
            if self._mass_by_impulse(own, symbol) or self._mass_by_vectors(own, symbol):
                return (own,)
            number = self._line(own)
            if number is not None and self._closes(number, symbol):
                return (own,)
        return None

    def _speed_compared(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A given speed in one unknown, which an energy that is given tells without the laws."""
        for own in left:
            given = self.equations.givens.get(own.id)
            standing = self.mark()
            compared = None if given is None else speed_compared(self.scene, given)
            if compared is not None and self._closes(*compared):
                return (own,)
            self.back(standing)
        return None

    def _is_place(self, own: Candidate) -> bool:
        """Whether a fact gives the place of a body."""
        given = self.equations.givens.get(own.id)
        return given is not None and any(
            is_quantity(node, "position") for node in walk(given.link.left)
        )

    def _after_walls(self) -> frozenset[sp.Symbol]:
        """The components after impacts with walls."""
        frames = self.scene.model.frames
        return frozenset(
            symbol for symbol, (number, _) in self._letters.items() if frames[number].wall
        )

    def _mass_by_impulse(self, own: Candidate, symbol: sp.Symbol) -> bool:
        """Whether an impulse that is given closes for the mass of the sphere it was not used of."""
        law = self.equations.law(own)
        if law is None or law.kind != "momentum" or symbol in self._letters:
            return False
        scene = self.scene
        bodies = [
            e for e in scene.bodies(law.number) if symbol in scene.unknown(scene.mass(e).value)
        ]
        for given in self.equations.givens.values():
            if len(bodies) != 1 or given.fact.id not in self.equations.used:
                continue
            line = write_impulse_on(scene, given, bodies[0])
            if line is not None:
                return self._closes(line, symbol)
        return False

    def _mass_by_vectors(self, own: Candidate, symbol: sp.Symbol) -> bool:
        """Whether momentum closes for a mass, with the velocities as vectors."""
        law = self.equations.law(own)
        if law is None or law.kind != "momentum" or symbol in self._letters:
            return False
        return write_masses(self.scene, law.number, symbol) is not None

    def _two(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """Two equations with the same two unknowns."""
        for first, second in combinations(left, 2):
            unknowns = self._open(first) | self._open(second)
            if len(unknowns) != 2:
                continue
            lines = [self._line(candidate) for candidate in (first, second)]
            if None in lines:
                continue
            pair: tuple[int, int] = (lines[0], lines[1])  # type: ignore[assignment]
            # A component may stand in the lines as a law expresses it.
            own = set[sp.Symbol]().union(
                *(self.scene.unknown(residual(self.scene, number)) for number in pair)
            )
            x, y = sorted(own if len(own) == len(pair) else unknowns, key=self._wanted_later)
            if self._close_both(pair, (x, y)):
                return first, second
        return None

    def _resolved(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A speed after a wall and its angle to that are given: both laws of its components.

        Where the part asks for what the speed tells too, it need not be on the route.
        """
        givens = self.equations.givens
        for turned in (own for own in left if own.id in givens):
            for fast in self._with_what_is_asked(left):
                if fast.id == turned.id or fast.id not in givens:
                    continue
                standing, pair = self.mark(), (givens[turned.id], givens[fast.id])
                if start_by_what_follows(self.scene, *pair):
                    return tuple(own for own in (turned, fast) if own in left)
                lines = resolved_at_a_wall(self.scene, *pair)
                if lines is None:
                    continue
                closed = [turned, fast] if self._both_close(lines) else None
                if closed is None:
                    third = self._with_a_third(left, (turned, fast), lines)
                    closed = None if third is None else [turned, fast, third]
                if closed is not None:
                    laws = (own for own in left if own.id == f"wall {self._wall_of(lines)}")
                    self.equations.used.add(fast.id)
                    return tuple(own for own in (*closed, *laws) if own in left)
                self.back(standing)
        return None

    def _with_a_third(
        self, left: Sequence[Candidate], pair: tuple[Candidate, Candidate], lines: tuple[int, int]
    ) -> Candidate | None:
        """The fact by which both laws of components tell three unknowns: it has two of them.

        With the component along the wall it tells speed and direction before; the coefficient is
        in the other law.
        """
        givens = self.equations.givens
        for own in left:
            if own.id not in givens or own in pair:
                continue
            standing = self.mark()
            fast = givens[pair[1].id]
            self.scene.desk.know(fast.link.left, self.scene.scalar(fast.link.right), fast.refs)
            number = self._line(own)
            if number is None:
                self.back(standing)
                continue
            number = with_known(self.scene, number)
            opened = [self.scene.unknown(residual(self.scene, n)) for n in (number, lines[0])]
            if len(opened[0]) == 1:
                if self._closes(number, *opened[0]) and self._both_close(lines):
                    return own
            elif opened[0] == opened[1] and len(opened[0]) == len(lines):
                x, y = sorted(opened[0], key=self._wanted_later)
                last = self.scene.unknown(residual(self.scene, lines[1])) - opened[0]
                both = len(last) == 1 and self._close_both((lines[0], number), (x, y))
                if both and self._closes(with_known(self.scene, lines[1]), *last):
                    return own
            self.back(standing)
        return None

    def _squares_with_momentum(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """Momentum and what is given of the energy: both components, before the coefficient.

        So it is where angles such as 35° make long sums of what both laws say of them.
        """
        for own in left:
            given = self.equations.givens.get(own.id)
            if given is None or not _is_of_squares(given):
                continue
            numbers = {
                number for symbol, (number, _) in self._letters.items() if symbol in self._open(own)
            }
            law = next((e for e in left if e.id in {f"momentum {n}" for n in numbers}), None)
            if (
                law is None
                or len(numbers) != 1
                or not self._open(own) == self._open(law) == self._after(*numbers).keys()
            ):
                continue
            if not all(map(self._is_by_calculator, (own, law))):
                continue
            standing = self.mark()
            x, y = sorted(self._open(own), key=lambda symbol: symbol.name, reverse=True)
            momentum, other = (self._line(candidate) for candidate in (law, own))
            if momentum and other and self._close_both((momentum, other), (x, y)):
                return law, own
            self.back(standing)
        return None

    def _is_by_calculator(self, own: Candidate) -> bool:
        """Whether an equation has sums with ratios of angles such as 35°."""
        return any(self.scene.with_values(x)[0].has(sp.sin, sp.cos) for x in own.residuals)

    def _wall_of(self, lines: tuple[int, int]) -> int | None:
        """The impact of two laws at a wall."""
        return self.scene.desk.line(lines[0]).move.event

    def _with_what_is_asked(self, left: Sequence[Candidate]) -> list[Candidate]:
        """What is left of a route, and the other facts that are about letters that are asked."""
        asked = {node.name for node in self.scene.asked if isinstance(node, Letter)}
        others = [
            own
            for own in map(candidate_of, self.scene.given)
            if own not in left
            and own.id not in self.equations.used
            and asked & symbol_names(*self._open(own))
        ]
        return [*left, *others]

    def _both_close(self, lines: tuple[int, int]) -> bool:
        """Whether two equations tell two unknowns: that with one of them first, or both at once."""
        scene = self.scene
        unknowns = [scene.unknown(residual(scene, with_known(scene, line))) for line in lines]
        if len(unknowns[0] | unknowns[1]) != len(lines):
            return False
        if all(len(own) == len(lines) for own in unknowns):
            x, y = sorted(unknowns[0], key=self._wanted_later)
            return self._close_both(lines, (x, y))
        for line, _ in sorted(zip(lines, unknowns, strict=True), key=lambda own: len(own[1])):
            number = with_known(scene, line)
            left = scene.unknown(residual(scene, number))
            if len(left) != 1 or not self._closes(number, *left):
                return False
        return True

    def _close_both(self, lines: tuple[int, int], pair: tuple[sp.Symbol, sp.Symbol]) -> bool:
        """Solves two equations for their two unknowns, if there is a way."""
        try:
            close_two(self.scene, lines, pair)
        except NotPlannedError as error:
            self.reasons.append(error)
            return False
        return True


def _is_of_squares(given: GivenEquation) -> bool:
    """Whether a fact is about speeds and energies alone, by which components are squared."""
    nodes = (node for side in (given.link.left, given.link.right) for node in walk(side))
    quantities = [node for node in nodes if isinstance(node, Quantity)]
    return bool(quantities) and all(
        is_quantity(node, "speed", "energy", "energy_lost") for node in quantities
    )


def _of_equal_roots(equation: sp.Expr) -> sp.Expr | None:
    """The difference of what stands below two roots that are equal; None of another equation."""
    terms = sp.Add.make_args(equation)
    if len(terms) != 2 or not all(term.atoms(sp.Pow) and _is_root(term) for term in terms):
        return None
    one, other = (tidy(term**2) for term in terms)
    return expanded(one - other)


def _is_root(term: sp.Expr) -> bool:
    """Whether a term is a root of letters, times what has none."""
    roots = [factor for factor in sp.Mul.make_args(term) if not factor.is_rational_function()]
    return any(root.is_Pow and root.exp == sp.S.Half and root.free_symbols for root in roots)
