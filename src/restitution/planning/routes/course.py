"""What is written so far of a route, what waits for its value, and how a component is expressed."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

import sympy as sp

from restitution.components.models import Model
from restitution.exact import tidy
from restitution.exact.symbols import symbol_names, symbols_in
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Apply, Letter, Name, Quantity, plain_letter
from restitution.planning.closing.bounded_speeds import bounded_speeds
from restitution.planning.closing.doubled_angles import without_doubles
from restitution.planning.closing.excluded_roots import written_law
from restitution.planning.closing.known_values import with_known
from restitution.planning.closing.shapes import close, without
from restitution.planning.formulas import separations
from restitution.planning.formulas.definitions import write_formula
from restitution.planning.formulas.impacts import (
    after,
    closing_at_wall,
    momentum,
    residual,
    restitution,
)
from restitution.planning.formulas.settled import settled
from restitution.planning.formulas.velocity_formulas import body_and_stage, speed_formula
from restitution.planning.journeys import paths, rounds
from restitution.planning.routes.closed_before import closed_before
from restitution.planning.routes.equations import SHOWN, Equations, Law
from restitution.planning.routes.givens import write_given
from restitution.planning.routes.laws_solved import put_into_restitution
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.desk import (
    UNPLANNED,
    Mark,
    NotPlannedError,
    Source,
    chain,
    is_value_of,
    together,
)
from restitution.planning.writing.forms import tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.polynomials import derivative, expanded, one_fraction
from restitution.planning.writing.premises import background
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass
from restitution.work import remembered

LAWS = {"momentum": momentum, "restitution": restitution}
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


def is_root_in_figures(value: sp.Expr | None) -> bool:
    """Whether a value is made of the root of a cubic, or of more, that has no exact form."""
    return value is not None and bool(value.has(sp.CRootOf))


class EquationLeftOpenError(Exception):
    """An equation of one unknown stands as the last line, and its root has no exact form."""


class Course:
    """How far the writing of a goal is: what is known, what is open, and what waits."""

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
        # Whether an equation is left as it stands where its root is that of a cubic or more.
        self.leaves_open = False
        self._open_at: tuple[object, ...] | None = None
        self._open_then: dict[tuple[sp.Expr, ...], frozenset[sp.Symbol]] = {}
        self._loosen_ties()
        self._forget_turned()
        self._take_given_masses()

    def _forget_turned(self) -> None:
        """What another part has for letters that are data here, by letters that are not, is open.

        Where α is to be found in terms of e, that e is made of α says nothing.
        """
        scene = self.scene
        for name in scene.model.unknowns.roles if scene.turned else ():
            valued = scene.model.unknowns.letter(name) in scene.model.final
            if valued or f"let {name}" in scene.facts:
                continue
            known = scene.desk.known(Letter(name))
            value = None if known is None else sp.sympify(known.value, strict=True)
            if known is not None and value is not None and scene.unknown(value):
                scene.desk.forget_value(Letter(name), known)

    def _take_given_masses(self) -> None:
        """Masses that facts give have these values wherever they stand in laws."""
        for body in self.scene.model.story.spheres:
            symbol = sp.sympify(self.scene.model.story.mass(body), strict=True)
            data = [ref for ref in (f"mass {body}",) if ref in self.scene.facts]
            for given in self.scene.given if symbol.is_Symbol else ():
                if is_value_of(given.link, Quantity("mass", (Name(body),))):
                    value = self.scene.scalar(given.link.right)
                    self.scene.desk.know(Letter(symbol.name), value, (*given.refs, *data))

    def _loosen_ties(self) -> None:
        """Letters that another part has by others, and that are numbers here, are open again.

        What ties them is an equation for one of them, once the other is known.
        """
        scene = self.scene
        for symbol, value in scene.model.final.items():
            known = scene.desk.known(plain_letter(symbol.name))
            if known is None or symbol in self._letters or len(known.refs) != 1:
                continue
            if sp.sympify(known.value, strict=True).has(sp.Function):
                self._loosen_ratio(symbol, value, known)
                continue
            open_ = scene.unknown(known.value)
            if value.free_symbols & scene.model.final.keys() or not open_:
                continue
            if all(self._has_given_value(other) for other in open_):
                continue
            scene.desk.loosen(Letter(symbol.name), known)

    def _has_given_value(self, symbol: sp.Symbol) -> bool:
        """Whether a fact is the value of a letter, which is put in wherever the letter stands."""
        letter = Letter(symbol.name)
        return any(is_value_of(given.link, letter) for given in self.scene.given)

    def _loosen_ratio(self, angle: sp.Symbol, value: sp.Expr, known: Source) -> None:
        """The ratio by which an angle is known is an equation, where that is degrees here."""
        desk = self.scene.desk
        if value.free_symbols or not (value * 180 / sp.pi).is_Integer:
            return
        for kind in ("sin", "cos", "tan"):
            ratio = Apply(kind, Letter(angle.name))
            own = desk.known(ratio)
            if own is not None and len(own.refs) == 1 and self.scene.unknown(own.value):
                desk.forget_value(Letter(angle.name), known)
                desk.loosen(ratio, own)
                return

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

    def _open(self, own: Candidate) -> frozenset[sp.Symbol]:
        """The unknowns of an equation; they are kept while nothing new is known."""
        state = self.scene.state(), len(self.scene.frames)
        if self._open_at != state:
            self._open_at = state
            self._open_then.clear()
        if own.residuals in self._open_then:
            return self._open_then[own.residuals]
        apart = self._separating()
        put = [self._by_separation(x) if apart else x for x in own.residuals]
        open_ = frozenset(s for x in put for s in self.scene.unknown(x))
        if state == (self.scene.state(), len(self.scene.frames)):  # it may write lines
            self._open_then[own.residuals] = open_
        return open_

    def _by_separation(self, value: sp.Expr) -> sp.Expr:
        """A value with the speed of separation put in, where that is all of its two components."""
        for number, frame in self.scene.model.frames.items():
            if frame.wall is not None or number not in self.scene.frames:
                continue  # a separation that is a line has its frame
            if self._only_apart(value, number):
                value = separations.with_separation(self.scene, self.scene.frame(number), value)
        return value

    @property
    def _letters(self) -> dict[sp.Symbol, tuple[int, str]]:
        return {
            component.symbol: (component.number, component.body)
            for component in self.scene.model.components.values()
        }

    def _closes(self, number: int, symbol: sp.Symbol) -> bool:
        """Solves a line for its unknown, if there is a way now; there may be one later."""
        try:
            close(self.scene, number, symbol)
        except NotPlannedError as error:
            if self._closes_by_a_bound(number, symbol):
                return True
            if self.leaves_open and is_root_in_figures(self.scene.model.final.get(symbol)):
                raise EquationLeftOpenError(str(symbol)) from error
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
        own = scene.desk.known(Letter(component.symbol.name))
        if own is not None and not scene.unknown(own.value):
            return  # the vector was made of it
        frame = scene.frame(event)
        velocity = scene.desk.known(Quantity("velocity", (Name(body),), event))
        if velocity is not None and frame.is_slanted:
            # Its scalar product is written where a law needs it.
            source = Source(velocity.value.dot(frame.n), together(velocity.refs, frame.refs))
        else:
            source = after(scene, "along", body, frame)
        value = frame.letter_sign * source.value
        if value != component.symbol:
            scene.desk.know(Letter(component.symbol.name), value, source.refs)

    def _earlier(self, law: Law) -> bool:
        """Whether a component before an impact is still to be worked out."""
        return any(
            number < law.number
            for symbol, (number, _) in self._letters.items()
            if symbol in self._open(law.candidate)
        )

    def _after(self, number: int) -> dict[sp.Symbol, str]:
        return {s: body for s, (n, body) in self._letters.items() if n == number}

    def _express_waiting(self, values: Sequence[sp.Expr]) -> None:
        """Expresses the components in some values of which the laws are written."""
        wanted = [symbol for value in values for symbol in self.scene.unknown(value)]
        for symbol in [value for value in self.waiting if value in wanted]:
            self._express(symbol, {s for value in values for s in symbols_in(value)})
        self._settle_tied(values)

    def _settle_tied(self, values: Sequence[sp.Expr]) -> None:
        """A component in some values that is known by another one, which is known, is a line."""
        scene, free = self.scene, {s for value in values for s in symbols_in(value)}
        for symbol in sorted(self._letters.keys() & free, key=lambda symbol: symbol.name):
            tied = scene.desk.known(plain_letter(symbol.name))
            others = set() if tied is None else symbols_in(tied.value) & self._letters.keys()
            if tied is None or others != symbols_in(tied.value) or len(others) != 1:
                continue
            if tied.value.is_Symbol:
                continue  # both go on together
            (other,) = others
            source = scene.desk.known(plain_letter(other.name))
            if source is None or symbols_in(source.value) & self._letters.keys():
                continue
            value = tidy(tied.value.subs(other, source.value))
            relation = chain(Letter(symbol.name), (tree_of(value), None))
            line = scene.judge.write((Move("put"),), (*tied.refs, *source.refs), relation)
            if line is not None:
                scene.desk.know(Letter(symbol.name), value, (line,))

    def _express(self, symbol: sp.Symbol, wanted: Iterable[sp.Basic]) -> None:
        """A component from both laws: by leaving out the other, or by putting in what that is.

        It is put in where it is no sum, or where that is wanted too and is none any more.
        """
        scene = self.scene
        _frame, lines, symbols = self.waiting.pop(symbol)
        residuals = [residual(scene, number) for number in lines]
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
        names = symbol_names(*residuals) if value == 0 else set()
        enough = scene.judge.enough(move, lines, relation, background(scene, names))
        if enough is None:
            one, two = lines
            lines = without_doubles(scene, one), without_doubles(scene, two)
            enough = scene.judge.enough(move, lines, relation, background(scene, names))
        line = scene.desk.write(move, enough or lines, relation)
        scene.desk.know(letter, value, (line,))

    def _beside(
        self, symbol: sp.Symbol, symbols: Iterable[sp.Symbol], residuals: Sequence[sp.Expr]
    ) -> sp.Symbol:
        """The unknown that is eliminated from both laws for a component.

        It is the other component, or a letter where that stands in both laws with its value.
        """
        (other,) = (other for other in symbols if other != symbol)
        if any(other in symbols_in(difference) for difference in residuals):
            return other
        both = set.intersection(*(set(self.scene.unknown(difference)) for difference in residuals))
        others = [value for value in both if value != symbol]
        if len(others) != 1:
            raise NotPlannedError(f"{symbol} is not expressed")
        return others[0]

    def _is_settled(self, *values: sp.Expr) -> bool:
        """Whether values in letters have come to numbers, since these have been found."""
        scene = self.scene
        put = [scene.put(value)[0] for value in values]
        return all(value.free_symbols & scene.model.final.keys() for value in values) and not any(
            value.free_symbols & scene.model.final.keys() or value.has(sp.Add) for value in put
        )

    def _only_apart(self, value: sp.Expr, number: int) -> bool:
        """Whether a value has only the difference of the components after an impact in it."""
        put = self.scene.with_values(value)[0]
        components = self._after(number).keys() & symbols_in(put)
        return not components or not sum(derivative(put, symbol) for symbol in components).expand()

    def _line(self, own: Candidate) -> int | None:
        """The line of an equation that closes, with what is known put in."""
        given = self.equations.givens.get(own.id)
        law = self.equations.law(own)
        if given is not None:
            before = closed_before(self.scene, given, self._open(own))
            if before is not None:
                return before
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
        if law.kind in LAWS:
            return self._law_line(law)
        body = law.body or self.scene.spheres(law.number)[0]
        kind = "along" if law.kind == "wall" else "across"
        return closing_at_wall(self.scene, body, self.scene.frame(law.number), kind)

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
        return LAWS[kind](self.scene, self.scene.frame(event))


@remembered(512)
def _two_by_two(
    residuals: tuple[sp.Expr, ...], symbols: tuple[sp.Symbol, ...]
) -> dict[sp.Symbol, sp.Expr]:
    """Two linear equations in two unknowns, by determinants."""
    rows = [[derivative(difference, s) for s in symbols] for difference in residuals]
    rest = [expanded(-difference.subs(dict.fromkeys(symbols, 0))) for difference in residuals]
    (a, b), (c, d) = rows
    whole = expanded(a * d - b * c)
    return {
        symbols[0]: one_fraction(expanded(rest[0] * d - b * rest[1]) / whole),
        symbols[1]: one_fraction(expanded(a * rest[1] - rest[0] * c) / whole),
    }
