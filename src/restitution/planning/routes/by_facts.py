"""Given facts as the next step of a route: velocities, coefficients, what a fact ties."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names, symbols_in
from restitution.explaining.lines.derivation import Link, Move
from restitution.expression.tree import Degrees, Letter, Name, Quantity, has_quantity, letters, walk
from restitution.planning.angles.unknown_blows import take_blow
from restitution.planning.axes.by_changes import take_impulse, take_opposite
from restitution.planning.axes.given_momenta import (
    take_mass,
    take_momentum,
    write_velocity_by_momentum,
)
from restitution.planning.closing.excluded_roots import senses, written_law
from restitution.planning.formulas.impacts import _given_after, after, named, residual
from restitution.planning.formulas.ties import tied
from restitution.planning.routes.course import Course
from restitution.planning.routes.given_directions import wall_of, write_resolved
from restitution.planning.routes.givens import candidate_of, write_given
from restitution.planning.routes.off_from_rest import write_speed_from_rest
from restitution.planning.routes.standing_components import is_compared
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.desk import NotPlannedError, chain, together
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.polynomials import derivative, expanded, factored, one_fraction
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation
from restitution.planning.writing.vectors import common_velocity, velocity_given


class ByFacts(Course):
    """Steps that given facts offer."""

    def _vanishing(self, symbols: frozenset[sp.Symbol], own: Candidate) -> frozenset[sp.Symbol]:
        """Those that are zero in the solution, where an equation holds by that alone."""
        model = self.scene.model
        put = [self.scene.with_values(difference)[0] for difference in own.residuals]
        return frozenset(
            symbol
            for symbol in symbols
            if model.sign(model.in_data(symbol)) == 0
            and all(model.identically_zero(x.subs(symbol, 0)) for x in put)
        )

    def _velocity_given(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A velocity that is given is known at once."""
        for own in left:
            given = self.equations.givens.get(own.id)
            if given is None or given.link.sign != "=":
                continue
            if common_velocity(given) is not None:
                if self._take_common(given):
                    return (own,)
                continue
            match given.link.left:
                case Quantity("velocity", _, int(event)) if (
                    event and event not in self.scene.model.frames and self._open(own)
                ):
                    (body,) = given.link.left.arguments
                    if not self._is_blow_to_take(body.name, event):  # type: ignore[union-attr]
                        continue
                    take_blow(self.scene, body.name, event)  # type: ignore[union-attr]
                    return (own,)
                case Quantity("velocity", _, stage):
                    if is_compared(self.scene, given):
                        continue
                    if (
                        isinstance(stage, int)
                        and self._open(own)
                        and write_velocity_by_momentum(self.scene, stage)
                    ):
                        return self._velocities_given(left, stage)
                    if not self._component_is_given(given):
                        self._take_velocity(given)
                    return (own,)
                case Quantity("speed" | "direction" | "deflection", (Name(body),), int(event)):
                    known = velocity_given(self.scene, body, event)
                    if known is not None and (event, body) in self.scene.model.components:
                        self._take_components(body, event)
                        return tuple(candidate for candidate in left if candidate.id in known[2])
                    if known is not None and self._is_blow_to_take(body, event):
                        take_blow(self.scene, body, event)
                        under = self.scene.desk.under(*known[2])
                        return tuple(candidate for candidate in left if candidate.id in under)
                case Quantity("momentum"):
                    if take_momentum(self.scene, given):
                        self._take_all_components()
                        return (own,)
                case Quantity("impulse", (Name(body),), int(event)):
                    if self.scene.unknown(self.scene.mass(body).value):
                        if not take_mass(self.scene, given):
                            used = tuple(self._by_opposite_impulses(given, left, event))
                            if used:
                                return used
                            continue
                    else:
                        take_impulse(self.scene, given)
                    self._take_components(body, event)
                    return (own, *self._by_opposite_impulses(given, left, event))
        return None

    def _by_opposite_impulses(
        self, given: GivenEquation, left: Sequence[Candidate], event: int
    ) -> Iterator[Candidate]:
        """Momentum, where the impulse on the other sphere tells all that it does."""
        for own in left:
            if own.id == f"momentum {event}" and (other := take_opposite(self.scene, given)):
                self._take_components(other, event)
                yield own

    def _is_blow_to_take(self, body: str, event: int) -> bool:
        """Whether the velocity after a blow tells the impulse, or the velocity before it."""
        fact = self.scene.facts.get(f"impulse {event}")
        if fact is None or event in self.scene.model.frames:
            return False
        before = self.scene.velocity(body, event - 1)
        blow = self.scene.value(fact.relation.only[0].right)
        return any(map(self.scene.unknown, before)) != bool(self.scene.unknown(blow))

    def _coefficient_given(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A coefficient that is given as a number is known before a law takes it."""
        for own in left:
            given, open_ = self.equations.givens.get(own.id), self._open(own)
            if given is None or not self._is_value(given):
                continue
            # So is an angle: its letter does not go through the laws.
            is_angle = isinstance(given.link.right, Degrees) and len(open_) == 1
            if is_angle and self._take_value(given, *open_):
                return (own,)
            if not self._are_coefficients(open_):
                continue
            if len(open_) == 2 and self._take_equal(given, open_):
                return (own,)
            if len(open_) == 1 and self._take_value(given, *open_):
                return (own,)
        return None

    def _are_coefficients(self, symbols: frozenset[sp.Symbol]) -> bool:
        """Whether letters are coefficients of restitution."""
        known = self.scene.model.unknowns.roles
        kinds = (known[symbol.name].kind for symbol in symbols if symbol.name in known)
        return [*kinds] == ["restitution"] * len(symbols)

    def _take_equal(self, given: GivenEquation, open_: frozenset[sp.Symbol]) -> bool:
        """Takes one of two letters that are equal for the other, which is wanted, from here on."""
        if given.link.sign != "=" or not isinstance(given.link.right, Letter):
            return False
        kept, other = sorted(open_, key=self._wanted_later, reverse=True)
        relation = chain(Letter(other.name), (Letter(kept.name), None))
        line = self.scene.judge.write((Move("fact"),), (given.fact.id,), relation)
        if line is not None:
            self.scene.desk.know(Letter(other.name), kept, (line,))
        return line is not None

    def _fact_expresses(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A fact with one unknown, which is a component, or a letter that it names."""
        for own in left:
            given = self.equations.givens.get(own.id)
            if given is None:
                continue
            if self._is_off_from_rest(given):
                return (own,)
            open_ = self._open(own)
            if len(open_) == 2 and tied(given.link) is not None:
                open_ = self._vanishing(open_, own)
            if len(open_) != 1:
                continue
            (symbol,) = open_
            if self._is_of_either_sense(own, symbol, left) or self._waits(symbol, left):
                continue
            if self._is_value(given) and self._take_value(given, symbol):
                return (own,)
            if symbol in self._letters or self._is_value(given):
                number = self._line(own)
                if number is not None and self._closes(number, symbol):
                    return (own,)
        return None

    def _take_zeros(self) -> set[int]:
        """The lines of components that are 0 by facts of which an earlier part used the equations.

        What these say of letters stands there: from then on such a component is 0, and not what
        the laws made of it in these letters.
        """
        lines = map(self._zero, self.scene.given)
        return {line for line in lines if line is not None}

    def _zero(self, given: GivenEquation) -> int | None:
        """The line in which a fact says that a component is 0; None where it is no such fact."""
        scene, own = self.scene, candidate_of(given)
        if given.link.sign != "=" or len(own.residuals) != 1 or scene.others:
            return None
        symbols = symbols_in(own.residuals[0]) & self._letters.keys()
        if len(symbols) != 1:
            return None
        (symbol,) = symbols
        letter, slope = Letter(symbol.name), derivative(own.residuals[0], symbol)
        known = scene.desk.known(letter)
        linear = expanded(own.residuals[0] - slope * symbol) == 0
        if known is None or known.value == 0 or symbol in symbols_in(slope) or not linear:
            return None
        used = (e.number for e in scene.desk.lines if given.fact.id in e.premises)
        if not any(not scene.desk.is_of_this_part(n) and scene.desk.holds(n) for n in used):
            return None
        standing = self.mark()
        scene.desk.forget_value(letter, known)
        try:
            link = scene.desk.last_link(line := write_given(scene, given))
        except NotPlannedError:
            self.back(standing)
            return None
        if (link.left, link.right) != (letter, ZERO):
            self.back(standing)
            return None
        scene.desk.know(letter, sp.Integer(0), (line,))
        self.equations.used.add(own.id)
        return line

    def _letters_tied(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A fact that has one unknown letter by another, where both stand in one other equation.

        It is that which is not asked, where either is: of α = β, to find α, it is β.
        """
        asked = {name for tree in self.scene.asked_alone for name in letters(tree)}
        for own in left:
            given, open_ = self.equations.givens.get(own.id), self._open(own)
            if given is None or len(open_) != 2 or open_ & self._letters.keys():
                continue
            if not any(self._open(other) == open_ for other in left if other is not own):
                continue
            pairs = ((given.link.left, given.link.right), (given.link.right, given.link.left))
            for one, other in pairs:
                symbol = next((s for s in open_ if one == Letter(s.name)), None)
                if symbol is None or has_quantity(other) or symbol.name in asked:
                    continue
                line, value = write_given(self.scene, given), self.scene.scalar(other)
                self.scene.desk.know(Letter(symbol.name), value, (line,))
                return (own,)
        return None

    def _fact_ties(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A fact that says how many times one component after an impact the other one is."""
        ids = {candidate.id for candidate in left}
        for own in left:
            given, open_ = self.equations.givens.get(own.id), self._open(own)
            if given is None or len(open_) != 2 or len(own.residuals) != 1:
                continue
            number, _ = self._letters.get(min(open_, key=str), (0, ""))
            laws = {f"momentum {number}", f"restitution {number}"}
            if open_ != self._after(number).keys():
                continue
            if not laws <= ids and not self._closes_a_law(laws, open_, left):
                continue
            gap = self.scene.with_values(own.residuals[0])[0]
            slopes = [derivative(gap, value).expand() for value in open_]
            if any(slope == 0 or slope.free_symbols & open_ for slope in slopes):
                continue
            if gap.subs(dict.fromkeys(open_, 0)).expand() == 0 and self._tie(given, open_, gap):
                return (own,)
        return None

    def _closes_a_law(
        self, laws: AbstractSet[str], open_: frozenset[sp.Symbol], left: Sequence[Candidate]
    ) -> bool:
        """Whether with a fact about both components one law alone tells another letter."""
        own = [candidate for candidate in left if candidate.id in laws]
        return len(own) == 1 and len(self._open(own[0]) - open_) == 1

    def _tie(self, given: GivenEquation, open_: frozenset[sp.Symbol], gap: sp.Expr) -> bool:
        """Takes one of two components as a multiple of the other, as a fact says it.

        ``gap`` is what the fact says to be zero, in both of them.
        """
        scene, standing = self.scene, self.mark()
        try:
            line = write_given(scene, given)
        except NotPlannedError as error:
            self.reasons.append(error)
            return False
        link = scene.desk.last_link(line)
        alone = [s for s in open_ if Letter(s.name) in (link.left, link.right)]
        first = min(alone or open_, key=lambda s: s.name)
        value = tidy(factored(_solved(gap, first)))
        if not alone:
            relation = chain(Letter(first.name), (tree_of(value), None))
            names = symbol_names(residual(scene, line))
            known = background(scene, names)
            premises = scene.judge.enough(Move("rearrange"), (line,), relation, known)
            if premises is None:
                self.back(standing)
                return False
            line = scene.desk.write(Move("rearrange"), premises, relation)
        scene.desk.know(Letter(first.name), value, (line,))
        return True

    def _waits(self, symbol: sp.Symbol, left: Sequence[Candidate]) -> bool:
        """Whether it is the component after a wall that a sphere reaches as it is still to come."""
        number, _ = self._letters.get(symbol, (0, ""))
        laws = (self.equations.law(own) for own in left if own.id == f"wall {number}")
        return any(law is not None and self._earlier(law) for law in laws)

    def _is_of_either_sense(
        self, own: Candidate, symbol: sp.Symbol, left: Sequence[Candidate]
    ) -> bool:
        """Whether a fact gives the square of a component for which both laws are still to come.

        By the laws its sense is known, or shown in letters. They exclude a sense of one value, or
        of a letter; where that is a sum, or a root of letters, the component comes from them.
        """
        link = self.equations.givens[own.id].link
        kinds = {
            node.kind
            for side in (link.left, link.right)
            for node in walk(side)
            if isinstance(node, Quantity)
        }
        if symbol not in self._letters or not kinds & {"speed", "energy", "angle"}:
            return False
        facts = self.scene.facts
        for ref in senses(self.scene, symbol):
            is_sense = ref in facts and facts[ref].relation.only[0].sign in ("<", "<=", ">", ">=")
            if is_sense or str(ref).startswith("sense"):
                return False
        number, _ = self._letters[symbol]
        laws = {f"momentum {number}", f"restitution {number}"}
        ids = {candidate.id for candidate in left}
        # One that an earlier part has used is there too.
        standing = {law for law in laws - ids if written_law(self.scene, law.split()[0], number)}
        if not laws & ids or not laws <= ids | standing:
            return False
        if self._comes_by_the_coefficient(number, left):
            return True
        put = [expanded(self.scene.with_values(difference)[0]) for difference in own.residuals]
        squared = [value for value in put if sp.diff(value, symbol, 2) != 0]
        if not squared:
            return False
        # Of several solutions each would need the laws anew: that is worth it where they part in
        # the sense, and the laws would leave two letters in one equation.
        signs = {model.sign(model.in_data(symbol)) for model in self.scene.others}
        unknowns = {x for candidate in left for x in self._open(candidate)} - self._letters.keys()
        parted = signs >= {-1, 1} and len(unknowns) > 1
        by_angle = "angle" in kinds and not kinds & {"speed", "energy"}
        root_of = _size_by_an_angle if by_angle else _root_of_square
        roots = [root_of(value, symbol) for value in squared]
        if all(root is not None and _needs_a_calculator(root) for root in roots):
            return False  # with its figures the laws are short, in each of several solutions
        if by_angle and all(root is not None and _is_product(root) for root in roots):
            return False  # the component of each sense is read off
        plain = all(root is not None and _is_plain(root) for root in roots)
        return not plain or (bool(signs) and not parted)

    def _is_off_from_rest(self, given: GivenEquation) -> bool:
        """Whether a fact gives the speed of a sphere that was at rest, and no law tells it yet.

        That is its component, which has the sense from the first sphere to it. Its line is written.
        """
        match given.link.left:
            case Quantity("speed", (Name(body),), int(number)):
                component = self.scene.model.components.get((number, body))
            case _:
                return False
        if component is None or component.symbol in self.waiting:
            return False
        if component.symbol not in self.scene.unknown(component.symbol):
            return False
        unknown = self.scene.unknown(self.scene.coefficient(number).value)
        if any(
            unknown & self.scene.unknown(self.scene.coefficient(other).value)
            for other in self.scene.model.frames
            if other < number
        ):
            return False  # by the laws it is a power of that
        return write_speed_from_rest(self.scene, given, component.symbol) is not None

    def _comes_by_the_coefficient(self, number: int, left: Sequence[Candidate]) -> bool:
        """Whether what comes to an impact has the coefficient of that in it, which is unknown.

        Then the laws tell the components after it by powers of that: w = (1 + e)²u/4.
        """
        unknown = self.scene.unknown(self.scene.coefficient(number).value)
        laws = (candidate for candidate in left if candidate.id == f"momentum {number}")
        put = (self.scene.with_values(x)[0] for law in laws for x in law.residuals)
        symbols = {symbol for value in put for symbol in value.free_symbols}
        # A component after an earlier impact has the coefficient of that in it.
        early = {self._letters[symbol][0] for symbol in symbols if symbol in self._letters}
        behind = (self.scene.coefficient(other).value for other in early if other < number)
        return bool(unknown & symbols) or any(unknown & self.scene.unknown(x) for x in behind)

    def _is_value(self, given: GivenEquation) -> bool:
        return isinstance(given.link.left, Letter)

    def _take_value(self, given: GivenEquation, symbol: sp.Symbol) -> bool:
        """A letter that is given as a number is known at once."""
        scene = self.scene
        if given.link.sign != "=" or given.link.left != Letter(symbol.name):
            return False
        value, refs = scene.put(scene.scalar(given.link.right))
        if scene.unknown(value):
            return False
        scene.desk.know(given.link.left, value, together(given.refs, refs))
        return True

    def _take_common(self, given: GivenEquation) -> bool:
        """Two bodies go on with one velocity: their components are one letter from now on."""
        scene = self.scene
        common = common_velocity(given)
        assert common is not None
        first, second, number = common
        if (number, first) not in scene.model.components:
            return False
        frame = scene.frame(number)
        one, other = (after(scene, "along", body, frame) for body in (first, second))
        letters = [scene.model.components[number, body].symbol for body in (first, second)]
        if [one.value, other.value] != letters or not scene.unknown(one.value):
            return False
        line = scene.desk.write(
            Move("define", "component", number, (first,)),
            together(given.refs, frame.refs, one.refs, other.refs),
            chain(Letter(letters[0].name), (Letter(letters[1].name), None)),
        )
        scene.desk.know(Letter(letters[0].name), letters[1], (line,))
        return True

    def _component_is_given(self, given: GivenEquation) -> bool:
        """A component that stands by the laws is what is given: an equation for a letter in it."""
        scene = self.scene
        for (number, body), component in scene.model.components.items():
            if given.link.left != Quantity("velocity", (Name(body),), number):
                continue
            known = scene.desk.known(Letter(component.symbol.name))
            source = _given_after(scene, "along", body, scene.frame(number))
            if known is None or source is None:
                return False
            value, refs = scene.put(known.value)
            other = scene.put(scene.frame(number).letter_sign * source.value)[0]
            open_ = scene.unknown(value - other)
            if len(open_) != 1:
                return False
            frame, letter = scene.frame(number), Letter(component.symbol.name)
            lets = scene.desk.introducing({letter.name})
            read = scene.judge.write(
                (Move("define", "component", number, (body,)),),
                (*source.whole, *frame.refs, *lets),
                chain(letter, (tree_of(other), None)),
            )
            if read is None:
                return False
            relation = chain(tree_of(value), (tree_of(other), None))
            line = scene.judge.write((Move("put"),), (*known.refs, read, *refs), relation)
            return line is not None and self._closes(line, *open_)
        return False

    def _velocities_given(self, left: Sequence[Candidate], stage: int) -> tuple[Candidate, ...]:
        """All velocities that are given after an impact, and the laws in which nothing is open."""
        own: list[Candidate] = []
        for candidate in left:
            given = self.equations.givens.get(candidate.id)
            match given.link if given is not None else None:
                case Link(Quantity("velocity", _, int(number)), "=") if number == stage:
                    assert given is not None
                    self._take_velocity(given)
                    own.append(candidate)
        return (*own, *(x for x in left if x not in own and not self._open(x)))

    def _take_velocity(self, given: GivenEquation) -> None:
        """The components of a velocity that is given are known from now on."""
        scene = self.scene
        for (number, body), component in scene.model.components.items():
            if given.link.left != Quantity("velocity", (Name(body),), number):
                continue
            frame = scene.frame(number)
            source = _given_after(scene, "along", body, frame)
            if source is not None:
                value = frame.letter_sign * source.value
                scene.desk.know(Letter(component.symbol.name), value, source.refs)

    def _impulse_at_a_wall(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """The component after a wall that an impulse tells, where no coefficient is wanted.

        It is the one before, less the impulse over the mass.
        """
        scene, ids = self.scene, {candidate.id for candidate in left}
        for own in left:
            given = self.equations.givens.get(own.id)
            match given.link if given is not None else None:
                case Link(Quantity("impulse", (), int(event)), "=") if (
                    self._open(own) == self._after(event).keys() and f"wall {event}" not in ids
                ):
                    frame = scene.frame(event)
                case _:
                    continue
            if frame.wall is None:
                continue
            ((symbol, body),) = self._after(event).items()
            standing = self.mark()
            named(scene, body, frame)
            if given is not None and self._closes(write_given(scene, given), symbol):
                return (own,)
            self.back(standing)
        return None

    def _direction_given(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A velocity after a wall of which the direction is given, and the law of that wall."""
        for own in left:
            given = self.equations.givens.get(own.id)
            number = None if given is None else wall_of(self.scene, given)
            law = next((x for x in self.equations.laws if x.candidate.id == f"wall {number}"), None)
            if number is None or law is None or law.candidate.id in self.equations.used:
                continue
            used = tuple(candidate for candidate in left if candidate in (own, law.candidate))
            open_ = {s for candidate in used for s in self._open(candidate)} - self._letters.keys()
            if self._earlier(law) or len(open_) >= len(used):
                continue
            if write_resolved(self.scene, number, next(iter(open_), None)):
                return used
        return None


def _root_of_square(equation: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """The size of a letter of which an equation gives the square; None where it gives more."""
    own = [power for power in equation.atoms(sp.Pow) if power.exp == sp.S.Half]
    own = [value for value in own if symbol in value.free_symbols]
    if own:
        # A speed is the root of such a sum.
        part = equation.coeff(own[0])
        other = (equation - part * own[0]).expand()
        equation = (own[0].base - (other / part) ** 2).expand()
    slope = sp.diff(equation, symbol, 2) / 2
    rest = (equation - slope * symbol**2).expand()
    if symbol in slope.free_symbols or symbol in rest.free_symbols:
        return None
    return tidy(sp.sqrt(factored(-rest / slope)))


def _size_by_an_angle(equation: sp.Expr, symbol: sp.Symbol) -> sp.Expr | None:
    """The size of a component that an angle to a line gives; None where it gives none."""
    size = sp.Abs(symbol)
    equation = sp.fraction(one_fraction(equation))[0].expand()
    part = equation.coeff(size)
    other = (equation - part * size).expand()
    return None if part == 0 or other.has(symbol) else tidy(factored(-other / part))


def _needs_a_calculator(root: sp.Expr) -> bool:
    """Whether a root is that of a number with sines such as that of 35°, times plain letters."""
    number, letters = root.as_independent(*root.free_symbols, as_Add=False)
    if not number.has(sp.sin, sp.cos) or not number.has(sp.Pow):
        return False
    return not letters.has(sp.Add, sp.sin, sp.cos) and not _has_root_of_letters(letters)


def _is_plain(root: sp.Expr) -> bool:
    """Whether a root is a number or a product, and no root of letters."""
    return not root.has(sp.sin, sp.cos) and _is_product(root)


def _is_product(root: sp.Expr) -> bool:
    """Whether a value has no sums, and no root of letters."""
    return not root.has(sp.Add) and not _has_root_of_letters(root)


def _has_root_of_letters(root: sp.Expr) -> bool:
    """Whether letters stand below a root."""
    powers = (power for power in root.atoms(sp.Pow) if power.free_symbols)
    return any(not power.exp.is_Integer for power in powers)


def _solved(residual_: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    slope = derivative(residual_, symbol)
    return -residual_.subs(symbol, 0) / slope
