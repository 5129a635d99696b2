"""In which order the equations of a route are written: laws express, known facts express, the rest
closes.

A law expresses the components after an impact. A fact expresses one only where that is its only
unknown and it holds no letter that is asked; else it is the last equation of its block.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from itertools import chain as chained
from itertools import combinations

import sympy as sp

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.explaining.lines.derivation import Move, Route
from restitution.expression.tree import Letter, Name, Quantity, walk
from restitution.planning.angles.deflections import turned_at_a_wall
from restitution.planning.angles.unknown_blows import take_blow
from restitution.planning.axes.by_changes import take_impulse, take_opposite
from restitution.planning.axes.given_momenta import take_mass, take_momentum, write_masses
from restitution.planning.closing.bounded_speeds import bounded_speeds
from restitution.planning.closing.pairs import close_two
from restitution.planning.closing.roots import senses, written_law
from restitution.planning.closing.shapes import close, is_over_roots, with_known, without
from restitution.planning.closing.systems import solve_together
from restitution.planning.formulas import separations
from restitution.planning.formulas.blows import write_blows
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.impacts import (
    _given_after,
    after,
    closing_at_wall,
    momentum,
    rebound,
    residual,
    restitution,
    settled,
)
from restitution.planning.formulas.ties import tied
from restitution.planning.formulas.velocity_formulas import body_and_stage, speed_formula
from restitution.planning.journeys import paths, rounds
from restitution.planning.routes.equations import SHOWN, Equations, Law
from restitution.planning.routes.given_directions import wall_of, write_resolved
from restitution.planning.routes.givens import candidate, write_given, write_impulse_on
from restitution.planning.routes.laws_solved import put_into_restitution, tidied_law
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.checking import require_true
from restitution.planning.writing.desk import (
    UNPLANNED,
    Mark,
    NotPlannedError,
    Source,
    chain,
    together,
)
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import expanded, factor_powers, factored, one_fraction
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import GivenEquation, Scene
from restitution.planning.writing.vectors import common_velocity, velocity_given
from restitution.work import remembered

_LAWS = {"momentum": momentum, "restitution": restitution}


Waiting = tuple[Frame, tuple[int, int], tuple[sp.Symbol, ...]]
"""The impact of a component, the lines of its laws, and the components in these."""


@dataclass(frozen=True)
class Standing:
    """How far a solver is: what is written, which equations are used, what waits for its value."""

    desk: Mark
    used: frozenset[str]
    waiting: Mapping[sp.Symbol, Waiting]
    frames: Mapping[int, Frame]
    others: tuple[Model, ...]


class Solver:
    """Writes what a goal needs: the equations of its route, in the order of a teacher."""

    def __init__(self, scene: Scene) -> None:
        self.scene = scene
        self.equations = Equations(scene)
        # Components of which the laws are written, and which nothing has asked for yet.
        self.waiting: dict[sp.Symbol, Waiting] = {}
        self.goals: Sequence[sp.Expr] = ()
        # Why a line could not be solved for its unknown.
        self.reasons: list[NotPlannedError] = []
        # Whether equations that no shape fits are solved together.
        self.resort = False
        self._loosen_ties()

    def _loosen_ties(self) -> None:
        """Letters that another part has by others, and that are numbers here, are open again.

        What ties them is an equation for one of them, once the other is known.
        """
        scene = self.scene
        for symbol, value in scene.model.final.items():
            known = scene.desk.known(Letter(symbol.name))
            if known is None or symbol in self._letters or len(known.refs) != 1:
                continue
            if sp.sympify(known.value, strict=True).has(sp.Function):
                continue  # an angle goes by its ratio
            open_ = scene.unknown(known.value)
            if value.free_symbols & scene.model.final.keys() or not open_:
                continue
            scene.desk.loosen(Letter(symbol.name), known)

    def resume(self, waiting: Mapping[sp.Symbol, Waiting]) -> None:
        """Takes up the components of which another solver of the part has written the laws."""
        for symbol, (frame, lines, components) in waiting.items():
            self.waiting[symbol] = self.scene.frame(frame.number), lines, components

    def mark(self) -> Standing:
        """How far the solver is, to which ``back`` returns."""
        scene = self.scene
        return Standing(
            scene.desk.mark(),
            frozenset(self.equations.used),
            dict(self.waiting),
            dict(scene.frames),
            scene.others,
        )

    def back(self, standing: Standing) -> None:
        """Takes back what was written and used since."""
        scene = self.scene
        scene.desk.back(standing.desk)
        self.equations.used, self.waiting = set(standing.used), dict(standing.waiting)
        scene.frames, scene.others = dict(standing.frames), standing.others

    def reopen(self) -> None:
        """Equations that were used may be used again, where something in them is open by now."""
        own = [*(each.candidate for each in self.equations.laws), *map(candidate, self.scene.given)]
        self.equations.used -= {each.id for each in own if self._open(each)}

    # --- routes ---------------------------------------------------------------------------------

    def determine(self, goals: Sequence[sp.Expr]) -> None:
        """Writes lines until everything in some values is known.

        The cheapest equations are tried first. Raises NotPlannedError where none of them can be
        written in an order, or solved.
        """
        self.goals = goals
        self._express_waiting(goals)
        write_blows(self.scene)
        if not any(self.scene.unknown(self._by_separation(goal)) for goal in goals):
            return
        scene = self.scene
        first: NotPlannedError | None = None
        routes = self.equations.routes(goals, self.waiting)
        whole = filter(None, map(self._with_both_laws, routes))
        for n, route in enumerate(chained(routes, whole)):
            standing = self.mark()
            try:
                self._take(route, goals)
                lines = scene.desk.lines
                require_true(scene.model, lines[standing.desk.lines :], lines, scene.desk.facts)
            except NotPlannedError as error:
                first = first or error
                self.back(standing)
                self.goals = goals
            else:
                item = scene.desk.item or ""
                scene.desk.others += [
                    Route(item, tuple(self.equations.move(own) for own in each))
                    for each in routes[n + 1 :]
                ]
                return
        assert first is not None
        raise first

    def _take(self, route: Sequence[Candidate], goals: Sequence[sp.Expr]) -> None:
        """Writes the equations of a route, in an order in which each tells something new."""
        scene = self.scene
        left = list(route)
        self._express_waiting([x for each in left for x in each.residuals])
        while left:
            self.reasons.clear()
            step = self._step(left)
            if step is None and (self._separation(left, goals) or self._widened(left)):
                continue
            if step is None and self.resort:
                step = self._together(left, goals)
            if step is None and self.reasons:
                raise self.reasons[0]
            if step is None:
                raise NotPlannedError(f"no order of {[each.id for each in left]}")
            for each in step:
                left.remove(each)
            # What was written on the way to another equation is used too.
            done = [each for each in left if not self._open(each)]
            self.equations.used |= {each.id for each in done}
            left = [each for each in left if each not in done]
            self._express_waiting([*goals, *(x for each in left for x in each.residuals)])
            write_blows(scene)
        rest = {symbol for each in goals for symbol in scene.unknown(each)}
        rest -= self._separating()
        if rest & self._letters.keys() and list(rest) != list(goals):
            # Where a goal is greatest or least in what is open, no gradient tells of that.
            self.determine(sorted(rest & self._letters.keys(), key=str))
            return
        if rest & {component.symbol for component in scene.model.components.values()}:
            raise NotPlannedError(f"{rest} are open")

    def _widened(self, left: list[Candidate]) -> bool:
        """Takes up the laws of components that stand in a route and that it leaves open.

        A fact may tell what is asked without them, and yet be written by them.
        """
        open_ = [
            s for each in left for s in sorted(self._open(each), key=str) if s in self._letters
        ]
        taken = {each.id for each in left}
        for symbol in open_:
            try:
                route = self.equations.routes([symbol], self.waiting)[0]
            except NotPlannedError:
                continue
            more = [each for each in route if each.id not in taken]
            if more:
                left += more
                return True
        return False

    def _with_both_laws(self, route: Sequence[Candidate]) -> tuple[Candidate, ...]:
        """A route with momentum where it has restitution alone, and the other way round.

        Both solve together, though one may be enough to tell what is asked. Empty without such.
        """
        ids = {each.id for each in route}
        more = [
            own.candidate
            for own in self.equations.laws
            for other in ("momentum", "restitution")
            if own.kind in _LAWS
            and own.candidate.id not in ids | self.equations.used
            and f"{other} {own.number}" in ids
            and self._after(own.number).keys() <= {s for each in route for s in self._open(each)}
        ]
        return (*route, *more) if more else ()

    def _separating(self) -> frozenset[sp.Symbol]:
        """The components of which only the difference is known."""
        return frozenset(
            symbol
            for number, frame in self.scene.model.frames.items()
            if frame.wall is None
            and number in self.scene.frames
            and separations.separation_known(self.scene, self.scene.frame(number)) is not None
            for symbol in self._after(number)
        )

    # --- order ----------------------------------------------------------------------------------

    def _next(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """Writes the next equation or block; returns what was used."""
        for test in (
            self._velocity_given,
            self._coefficient_given,
            self._direction_given,
            self._wall,
            self._fact_expresses,
            self._fact_ties,
            self._law_ties,
            self._block,
            self._single,
            self._closing,
            self._two,
        ):
            used = test(left)
            if used:
                self.equations.used |= {each.id for each in used}
                return used
        return None

    def _step(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """The next equation or block; as a last resort, none where one of them has no line."""
        try:
            return self._next(left)
        except NotPlannedError as error:
            if not self.resort:
                raise
            self.reasons.append(error)
            return None

    def _together(
        self, left: Sequence[Candidate], goals: Sequence[sp.Expr]
    ) -> tuple[Candidate, ...] | None:
        """All equations that are left, solved in one line."""
        asked = frozenset(symbol for each in goals for symbol in self.scene.unknown(each))
        lines = [self._line(each) for each in left]
        try:
            solve_together(self.scene, [line for line in lines if line is not None], asked)
        except NotPlannedError as error:
            self.reasons.append(error)
            return None
        return tuple(left)

    def _open(self, own: Candidate) -> frozenset[sp.Symbol]:
        apart = self._separating()
        put = [self._by_separation(x) if apart else x for x in own.residuals]
        return frozenset(s for x in put for s in self.scene.unknown(x))

    def _by_separation(self, value: sp.Expr) -> sp.Expr:
        """A value with the speed of separation put in, where that is all of its two components."""
        for number, frame in self.scene.model.frames.items():
            if frame.wall is not None or number not in self.scene.frames:
                continue  # a separation that is a line has its frame
            if self._only_apart(value, number):
                value = separations.with_separation(self.scene, self.scene.frame(number), value)
        return value

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
        put = put.replace(sp.tan, lambda x: sp.sin(x) / sp.cos(x))
        above = sp.fraction(one_fraction(put))[0]
        factors = [base for base, _ in factor_powers(above)]
        zero = [factor for factor in factors if model.sign(model.in_data(factor)) == 0]
        return frozenset(s for each in zero or [put] for s in self.scene.unknown(each))

    def _vanishing(self, symbols: frozenset[sp.Symbol], own: Candidate) -> frozenset[sp.Symbol]:
        """Those that are zero in the solution, where an equation holds by that alone."""
        model = self.scene.model
        put = [self.scene.with_values(each)[0] for each in own.residuals]
        return frozenset(
            each
            for each in symbols
            if model.sign(model.in_data(each)) == 0
            and all(model.identically_zero(x.subs(each, 0)) for x in put)
        )

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
        return frozenset(each for each in factors if each.is_Symbol and each.is_positive)

    @property
    def _letters(self) -> dict[sp.Symbol, tuple[int, str]]:
        return {
            component.symbol: (component.number, component.body)
            for component in self.scene.model.components.values()
        }

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
                case Quantity("velocity"):
                    if not self._component_is_given(given):
                        self._take_velocity(given)
                    return (own,)
                case Quantity("speed" | "direction" | "deflection", (Name(body),), int(event)):
                    known = velocity_given(self.scene, body, event)
                    if known is not None and (event, body) in self.scene.model.components:
                        self._take_components(body, event)
                        return tuple(each for each in left if each.id in known[2])
                    if known is not None and self._is_blow_to_take(body, event):
                        take_blow(self.scene, body, event)
                        desk = self.scene.desk
                        under = {
                            e for ref in known[2] if isinstance(ref, int) for e in desk.under(ref)
                        }
                        return tuple(each for each in left if each.id in {*known[2], *under})
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
            if given is None or not self._is_value(given) or not self._are_coefficients(open_):
                continue
            if len(open_) == 2 and self._take_equal(given, open_):
                return (own,)
            if len(open_) == 1 and self._take_value(given, *open_):
                return (own,)
        return None

    def _are_coefficients(self, symbols: frozenset[sp.Symbol]) -> bool:
        """Whether letters are coefficients of restitution."""
        known = self.scene.model.unknowns.roles
        kinds = (known[each.name].kind for each in symbols if each.name in known)
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

    def _fact_ties(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A fact that says how many times one component after an impact the other one is."""
        ids = {each.id for each in left}
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
            slopes = [sp.diff(gap, each).expand() for each in open_]
            if any(slope == 0 or slope.free_symbols & open_ for slope in slopes):
                continue
            if gap.subs(dict.fromkeys(open_, 0)).expand() == 0 and self._tie(given, open_):
                return (own,)
        return None

    def _closes_a_law(
        self, laws: AbstractSet[str], open_: frozenset[sp.Symbol], left: Sequence[Candidate]
    ) -> bool:
        """Whether with a fact about both components one law alone tells another letter."""
        own = [each for each in left if each.id in laws]
        return len(own) == 1 and len(self._open(own[0]) - open_) == 1

    def _tie(self, given: GivenEquation, open_: frozenset[sp.Symbol]) -> bool:
        """Takes one of two components as a multiple of the other, as a fact says it."""
        scene = self.scene
        try:
            line = write_given(scene, given)
        except NotPlannedError as error:
            self.reasons.append(error)
            return False
        gap, link = residual(scene, line), scene.desk.last_link(line)
        alone = [s for s in open_ if Letter(s.name) in (link.left, link.right)]
        first = min(alone or open_, key=lambda s: s.name)
        value = tidy(_solved(gap, first))
        if not alone:
            relation = chain(Letter(first.name), (tree_of(value), None))
            line = scene.desk.write(Move("rearrange"), (line,), relation)
        scene.desk.know(Letter(first.name), value, (line,))
        return True

    def _law_ties(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """The law of restitution alone, where it says that both spheres go on together along it."""
        ids = {each.id for each in left}
        for own in left:
            law = self.equations.law(own)
            if law is None or law.kind != "restitution" or f"momentum {law.number}" in ids:
                continue
            open_ = self._open(own)
            if self._earlier(law) or open_ != self._after(law.number).keys():
                continue
            gap = self.scene.with_values(own.residuals[0])[0]
            if gap.subs(dict.fromkeys(open_, 0)).expand() != 0:
                continue
            one, other = sorted(open_, key=lambda s: s.name)
            number = self._law_line(law)
            relation = chain(Letter(other.name), (Letter(one.name), None))
            line = self.scene.judge.write((Move("rearrange"),), (number,), relation)
            if line is not None:
                self.scene.desk.know(Letter(other.name), one, (line,))
                return (own,)
        return None

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
            each.kind
            for side in (link.left, link.right)
            for each in walk(side)
            if isinstance(each, Quantity)
        }
        if symbol not in self._letters or not kinds & {"speed", "energy", "angle"}:
            return False
        facts = self.scene.facts
        for ref in senses(self.scene, symbol):
            is_sense = ref in facts and facts[ref].relation.only[0].sign in ("<", "<=", ">", ">=")
            if is_sense or str(ref).startswith("sense"):
                return False
        number, _ = self._letters[symbol]
        ids = {each.id for each in left}
        if not {f"momentum {number}", f"restitution {number}"} <= ids:
            return False
        put = [sp.expand(self.scene.with_values(each)[0]) for each in own.residuals]
        squared = [each for each in put if sp.diff(each, symbol, 2) != 0]
        if not squared:
            return False
        # Of several solutions each would need the laws anew: that is worth it where they part in
        # the sense, and the laws would leave two letters in one equation.
        signs = {each.sign(each.in_data(symbol)) for each in self.scene.others}
        unknowns = {x for each in left for x in self._open(each)} - self._letters.keys()
        parted = signs >= {-1, 1} and len(unknowns) > 1
        plain = all(_is_plain_square(each, symbol) for each in squared)
        return not plain or (bool(signs) and not parted)

    def _closes(self, number: int, symbol: sp.Symbol) -> bool:
        """Solves a line for its unknown, if there is a way now; there may be one later."""
        try:
            close(self.scene, number, symbol)
        except NotPlannedError as error:
            if self._closes_by_a_bound(number, symbol):
                return True
            self.reasons.append(error)
            return False
        return True

    def _closes_by_a_bound(self, number: int, symbol: sp.Symbol) -> bool:
        """Solves a line of which a speed that is given as more, or as less, excludes a root.

        The speed stands before the roots, in the unknown.
        """
        scene, standing = self.scene, self.mark()
        bounded = [speed for _, speed in bounded_speeds(scene) if scene.desk.known(speed) is None]
        try:
            for speed in bounded:
                self._express_waiting([*scene.velocity(*body_and_stage(scene, speed))])
                write_formula(scene, speed_formula(scene, speed))
            if bounded:
                close(self.scene, number, symbol)
                return True
        except UNPLANNED:
            self.back(standing)
        return False

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
        one, other = (after(scene, "along", each, frame) for each in (first, second))
        letters = [scene.model.components[number, each].symbol for each in (first, second)]
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

    def take_velocity(self, velocity: Quantity) -> None:
        """The components are known, once both velocities are, where the laws do not stand yet."""
        (body,) = velocity.arguments
        assert isinstance(body, Name)
        assert isinstance(velocity.stage, int)
        event = self.scene.last_event(body.name, velocity.stage)
        if written_law(self.scene, "momentum", event) is None:
            for sphere in self.scene.spheres(event):
                self._take_components(sphere, event)

    def _take_all_components(self) -> None:
        """The components of velocities that are lines are known from now on."""
        for number, body in self.scene.model.components:
            if self.scene.desk.known(Quantity("velocity", (Name(body),), number)) is not None:
                self._take_components(body, number)

    def _take_components(self, body: str, event: int) -> None:
        """The component of a velocity that is a line is known from now on."""
        scene = self.scene
        component = scene.model.components.get((event, body))
        if component is None:
            return
        frame = scene.frame(event)
        velocity = scene.desk.known(Quantity("velocity", (Name(body),), event))
        if velocity is not None and frame.is_slanted:
            # Its scalar product is written where a law needs it.
            source = Source(velocity.value.dot(frame.n), together(velocity.refs, frame.refs))
        else:
            source = after(scene, "along", body, frame)
        value = frame.letter_sign * source.value
        scene.desk.know(Letter(component.symbol.name), value, source.refs)

    def _direction_given(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A velocity after a wall of which the direction is given, and the law of that wall."""
        for own in left:
            given = self.equations.givens.get(own.id)
            number = None if given is None else wall_of(self.scene, given)
            law = next((x for x in self.equations.laws if x.candidate.id == f"wall {number}"), None)
            if number is None or law is None or law.candidate.id in self.equations.used:
                continue
            used = tuple(each for each in left if each in (own, law.candidate))
            open_ = {s for each in used for s in self._open(each)} - self._letters.keys()
            if self._earlier(law) or len(open_) >= len(used):
                continue
            if write_resolved(self.scene, number, next(iter(open_), None)):
                return used
        return None

    def _wall(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """At a wall the component after follows at once."""
        for own in left:
            law = self.equations.law(own)
            if law is None or law.kind != "wall":
                continue
            frame = self.scene.frame(law.number)
            (body,) = self.scene.spheres(law.number)
            symbol = self.scene.model.components[law.number, body].symbol
            if symbol in self._open(own) and not self._earlier(law):
                rebound(self.scene, body, frame)
                return (own,)
        return None

    def _earlier(self, law: Law) -> bool:
        """Whether a component before an impact is still to be worked out."""
        return any(
            number < law.number
            for symbol, (number, _) in self._letters.items()
            if symbol in self._open(law.candidate)
        )

    def _block(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """Momentum with restitution: two lines, from which the components follow."""
        for own in left:
            law = self.equations.law(own)
            if law is None or law.kind != "momentum" or self._earlier(law):
                continue
            other = next((each for each in left if each.id == f"restitution {law.number}"), None)
            if other is None:
                continue
            after_ = self._after(law.number)
            every = self._open(own) | self._open(other)
            open_ = every & after_.keys()
            if len(open_) == 2:
                self._pair(law.number, after_)
                return (own, other)
            shared = self._open(own) & self._open(other)
            if len(every) == len(shared) == 2 and self._is_linear((own, other), every):
                self._pair(law.number, dict.fromkeys(sorted(every, key=str), ""))
                return (own, other)
        return None

    def _is_linear(self, laws: Sequence[Candidate], symbols: Iterable[sp.Symbol]) -> bool:
        """Whether laws are linear in some letters, with what is known put in."""
        rows = [self.scene.put(each)[0] for own in laws for each in own.residuals]
        slopes = [sp.diff(row, each) for row in rows for each in symbols]
        # A cosine that is divided by would have to be cited as not zero.
        return not any(
            slope.has(sp.sin, sp.cos) or slope.free_symbols & set(symbols) for slope in slopes
        )

    def _after(self, number: int) -> dict[sp.Symbol, str]:
        return {s: body for s, (n, body) in self._letters.items() if n == number}

    def _pair(self, number: int, bodies: dict[sp.Symbol, str]) -> None:
        scene = self.scene
        frame = scene.frame(number)
        for body in scene.spheres(number):
            after(scene, "along", body, frame)
        laws = [
            tidied_law(scene, self._law_of(kind, number), tuple(bodies))
            for kind in ("momentum", "restitution")
        ]
        lines = laws[0], laws[1]
        for symbol in bodies:
            self.waiting[symbol] = frame, lines, tuple(bodies)

    def _express_waiting(self, values: Sequence[sp.Expr]) -> None:
        """Expresses the components in some values of which the laws are written."""
        if not self.waiting:
            return
        wanted = [symbol for each in values for symbol in self.scene.unknown(each)]
        for symbol in [each for each in self.waiting if each in wanted]:
            self._express(symbol, {s for each in values for s in each.free_symbols})

    def _express(self, symbol: sp.Symbol, wanted: Iterable[sp.Basic]) -> None:
        """A component from both laws: by leaving out the other, or by putting in what that is.

        It is put in where it is no sum, or where that is wanted too and is none any more.
        """
        scene = self.scene
        _frame, lines, symbols = self.waiting.pop(symbol)
        residuals = [residual(scene, each) for each in lines]
        other = self._beside(symbol, symbols, residuals)
        value = tidy(_two_by_two(tuple(residuals), (symbol, other))[symbol])
        letter, tree = Letter(symbol.name), Letter(other.name)
        known = scene.desk.known(tree)
        now, _ = (value, ()) if known is None else scene.put(known.value)
        if known is not None and not (now.has(sp.Add) and now.free_symbols):
            # What letters have come to since is put into the law that has none of them.
            later = not scene.others and self._is_settled(known.value, value)
            plain = not known.value.has(sp.Add) or not value.free_symbols or other in wanted
            laws = [(law, True) for law in lines if later]
            laws += [(law, False) for law in lines[1:] if plain]
            source = (settled(scene, tree) or known) if laws else known
            put, more = scene.put(value)
            relation = chain(letter, (tree_of(put), None))
            for law, alone in laws:
                refs = scene.judge.enough(Move("put"), (law, *source.refs), relation, more)
                if refs is not None and not (alone and len(refs) > 2):
                    line = scene.desk.write(Move("put"), refs, relation)
                    scene.desk.know(letter, put, (line,))
                    return
        if (
            known is not None
            and not scene.others
            and put_into_restitution(scene, symbol, other, known, lines[1])
        ):
            return
        move = Move("combine", eliminated=other.name)
        relation = without(symbol, other, residuals, value)
        # Of what is zero no denominator says what was divided by.
        names = {each.name for x in residuals for each in x.free_symbols} if value == 0 else set()
        enough = scene.judge.enough(move, lines, relation, background(scene, names))
        line = scene.desk.write(move, enough or lines, relation)
        scene.desk.know(letter, value, (line,))

    def _beside(
        self, symbol: sp.Symbol, symbols: Iterable[sp.Symbol], residuals: Sequence[sp.Expr]
    ) -> sp.Symbol:
        """The unknown that is eliminated from both laws for a component.

        It is the other component, or a letter where that stands in both laws with its value.
        """
        (other,) = (each for each in symbols if each != symbol)
        if any(other in each.free_symbols for each in residuals):
            return other
        both = set.intersection(*(set(self.scene.unknown(each)) for each in residuals))
        others = [each for each in both if each != symbol]
        if len(others) != 1:
            raise NotPlannedError(f"{symbol} is not expressed")
        return others[0]

    def _is_settled(self, *values: sp.Expr) -> bool:
        """Whether values in letters have come to numbers, since these have been found."""
        scene = self.scene
        put = [scene.put(each)[0] for each in values]
        return all(each.free_symbols & scene.model.final.keys() for each in values) and not any(
            each.free_symbols & scene.model.final.keys() or each.has(sp.Add) for each in put
        )

    def _single(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A law of two spheres with one component open after it: that is expressed."""
        for own in sorted(left, key=lambda each: len(self._open(each))):
            law = self.equations.law(own)
            if law is None or law.kind not in _LAWS or self._earlier(law):
                continue
            open_ = self._open(own)
            later = [s for s in open_ if s in self._after(law.number)]
            if len(later) != 1:
                continue
            (symbol,) = later
            number = self._shorter_law(law, symbol) or self._law_line(law)
            own_residual = residual(self.scene, number)
            if symbol not in own_residual.free_symbols:
                continue  # it is known by now
            if is_over_roots(own_residual, symbol):
                close(self.scene, number, symbol)
                return (own,)
            value = tidy(_solved(own_residual, symbol))
            line = self.scene.desk.write(
                Move("rearrange"), (number,), chain(Letter(symbol.name), (tree_of(value), None))
            )
            self.scene.desk.know(Letter(symbol.name), value, (line,))
            return (own,)
        return None

    def _shorter_law(self, law: Law, symbol: sp.Symbol) -> int | None:
        """The law of restitution with what is known, where both laws stand and it is enough."""
        if law.kind != "momentum" or written_law(self.scene, law.kind, law.number) is None:
            return None
        other = written_law(self.scene, "restitution", law.number)
        if other is None or set(self.scene.unknown(residual(self.scene, other))) != {symbol}:
            return None
        return with_known(self.scene, other)

    def _separation(self, left: list[Candidate], goals: Sequence[sp.Expr]) -> bool:
        """Writes the law of restitution alone, where only the speed of separation is wanted."""
        ids = {each.id for each in left}
        for own in left:
            law = self.equations.law(own)
            if law is None or law.kind != "restitution" or f"momentum {law.number}" in ids:
                continue
            pair = self._after(law.number).keys()
            rest = [x for each in left if each != own for x in each.residuals]
            if self._earlier(law) or not pair <= {
                s for x in own.residuals for s in self.scene.unknown(x)
            }:
                continue
            if all(self._only_apart(x, law.number) for x in [*rest, *goals]):
                if not pair <= self._separating():
                    separations.write_separation(self.scene, self.scene.frame(law.number))
                left.remove(own)
                return True
        return False

    def _only_apart(self, value: sp.Expr, number: int) -> bool:
        """Whether a value has only the difference of the components after an impact in it."""
        put = self.scene.with_values(value)[0]
        return not sum(sp.diff(put, each) for each in self._after(number)).expand()

    def _closing(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """An equation with one unknown letter."""
        for own in left:
            open_ = self._essential(own)
            if len(open_) != 1:
                continue
            (symbol,) = open_
            if self._mass_by_impulse(own, symbol) or self._mass_by_vectors(own, symbol):
                return (own,)
            number = self._line(own)
            if number is not None and self._closes(number, symbol):
                return (own,)
        return None

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

    def _line(self, own: Candidate) -> int | None:
        """The line of an equation that closes, with what is known put in."""
        given = self.equations.givens.get(own.id)
        law = self.equations.law(own)
        if given is not None:
            try:
                return write_given(self.scene, given)
            except NotPlannedError as error:
                self.reasons.append(error)
                return None
        if own.id in self.equations.paths:
            return paths.write_path(self.scene, self.equations.paths[own.id])
        if own.id in self.equations.rounds:
            return rounds.write_round(self.scene, self.equations.rounds[own.id])
        if own.id.startswith(SHOWN):
            return int(own.id.removeprefix(SHOWN))
        if law is None:
            return None
        if law.kind in _LAWS:
            return self._law_line(law)
        body = law.body or self.scene.spheres(law.number)[0]
        kind = "along" if law.kind == "wall" else "across"
        return closing_at_wall(self.scene, body, self.scene.frame(law.number), kind)

    def _two(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """Two equations with the same two unknowns."""
        for first, second in combinations(left, 2):
            unknowns = self._open(first) | self._open(second)
            if len(unknowns) != 2:
                continue
            if self._turned(first, second) or self._turned(second, first):
                return first, second
            lines = [self._line(each) for each in (first, second)]
            if None in lines:
                continue
            x, y = sorted(unknowns, key=self._wanted_later)
            try:
                close_two(self.scene, (lines[0], lines[1]), (x, y))  # type: ignore[arg-type]
            except NotPlannedError as error:
                self.reasons.append(error)
                continue
            return first, second
        return None

    def _turned(self, turned: Candidate, fast: Candidate) -> bool:
        """A deflection at a wall with the speed after it: by the angle that is left to the wall."""
        pair = self.equations.givens.get(turned.id), self.equations.givens.get(fast.id)
        if pair[0] is None or pair[1] is None:
            return False
        lines = turned_at_a_wall(self.scene, pair[0], pair[1])
        if lines is None:
            return False
        for number, line in enumerate(lines):
            own = self.scene.unknown(residual(self.scene, with_known(self.scene, line)))
            if len(own) != 1:
                return False
            (symbol,) = own
            if not self._closes(line, symbol):
                return number > 0
        return True

    def _wanted_later(self, symbol: sp.Symbol) -> tuple[bool, str]:
        """What is not asked comes first: it is left out, or put in."""
        asked = any(symbol in goal.free_symbols for goal in self.goals)
        return asked, symbol.name

    def _law_line(self, law: Law) -> int:
        return self._law_of(law.kind, law.number)

    def _law_of(self, kind: str, event: int) -> int:
        """The line of a law; where it stands already, with what is known by now put in."""
        number = written_law(self.scene, kind, event)
        if number is not None:
            return with_known(self.scene, number)
        return _LAWS[kind](self.scene, self.scene.frame(event))


def _of_equal_roots(equation: sp.Expr) -> sp.Expr | None:
    """The difference of what stands below two roots that are equal; None of another equation."""
    terms = sp.Add.make_args(equation)
    if len(terms) != 2 or not all(each.atoms(sp.Pow) and _is_root(each) for each in terms):
        return None
    one, other = (tidy(each**2) for each in terms)
    return sp.expand(one - other)


def _is_root(term: sp.Expr) -> bool:
    """Whether a term is a root of letters, times what has none."""
    roots = [each for each in sp.Mul.make_args(term) if not each.is_rational_function()]
    return any(each.is_Pow and each.exp == sp.S.Half and each.free_symbols for each in roots)


def _is_plain_square(equation: sp.Expr, symbol: sp.Symbol) -> bool:
    """Whether an equation says that the square of a letter is that of a number or a product."""
    own = [each for each in equation.atoms(sp.Pow) if each.exp == sp.S.Half]
    own = [each for each in own if symbol in each.free_symbols]
    if own:
        # A speed is the root of such a sum.
        part = equation.coeff(own[0])
        other = (equation - part * own[0]).expand()
        equation = (own[0].base - (other / part) ** 2).expand()
    slope = sp.diff(equation, symbol, 2) / 2
    rest = (equation - slope * symbol**2).expand()
    if symbol in slope.free_symbols or symbol in rest.free_symbols:
        return False
    root = tidy(sp.sqrt(factored(-rest / slope)))
    roots = (power for power in root.atoms(sp.Pow) if power.exp.is_Rational and power.exp.q != 1)
    return not root.has(sp.Add, sp.sin, sp.cos) and not any(each.free_symbols for each in roots)


@remembered(512)
def _two_by_two(
    residuals: tuple[sp.Expr, ...], symbols: tuple[sp.Symbol, ...]
) -> dict[sp.Symbol, sp.Expr]:
    """Two linear equations in two unknowns, by determinants."""
    rows = [[sp.diff(each, s) for s in symbols] for each in residuals]
    rest = [expanded(-each.subs(dict.fromkeys(symbols, 0))) for each in residuals]
    (a, b), (c, d) = rows
    whole = expanded(a * d - b * c)
    return {
        symbols[0]: one_fraction(expanded(rest[0] * d - b * rest[1]) / whole),
        symbols[1]: one_fraction(expanded(a * rest[1] - rest[0] * c) / whole),
    }


def _solved(residual_: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    slope = sp.diff(residual_, symbol)
    return -residual_.subs(symbol, 0) / slope
