"""Laws of impacts as the next step of a route: at a wall, both at once, or one alone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from contextlib import suppress

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names, symbols_in
from restitution.explaining.lines.derivation import Move
from restitution.expression.tree import Letter
from restitution.planning.closing.excluded_roots import written_law
from restitution.planning.closing.known_values import with_known
from restitution.planning.closing.shapes import close, is_over_roots
from restitution.planning.formulas import separations
from restitution.planning.formulas.impacts import after, rebound, residual
from restitution.planning.routes.by_facts import ByFacts, _solved
from restitution.planning.routes.course import LAWS
from restitution.planning.routes.equations import Law
from restitution.planning.routes.givens import candidate_of, write_given
from restitution.planning.routes.laws_solved import tidied_law
from restitution.planning.writing.candidates import Candidate
from restitution.planning.writing.desk import NotPlannedError, chain
from restitution.planning.writing.forms import ZERO, tree_of
from restitution.planning.writing.polynomials import derivative, expanded
from restitution.planning.writing.scene import GivenEquation

_PAIR = 2
# The signs of facts that may say that a component is zero.
_TIES = frozenset({"=", "perpendicular to", "parallel to"})


class ByLaws(ByFacts):
    """Steps that the laws offer."""

    def _law_ties(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """The law of restitution alone, where it says that both spheres go on together along it."""
        ids = {candidate.id for candidate in left}
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

    def _block(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """Momentum with restitution: two lines, from which the components follow."""
        for own in left:
            law = self.equations.law(own)
            if law is None or law.kind != "momentum" or self._earlier(law):
                continue
            other = next(
                (candidate for candidate in left if candidate.id == f"restitution {law.number}"),
                None,
            )
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
        rows = [self.scene.put(difference)[0] for own in laws for difference in own.residuals]
        slopes = [derivative(row, symbol) for row in rows for symbol in symbols]
        # A cosine that is divided by would have to be cited as not zero.
        return not any(
            slope.has(sp.sin, sp.cos) or slope.free_symbols & set(symbols) for slope in slopes
        )

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
        # With vectors momentum tells the second velocity at once.
        plain = not frame.is_slanted
        tied = self._tied_by_no_momentum(lines[0], tuple(bodies)) if plain else None
        for symbol in bodies:
            if symbol != tied:
                self.waiting[symbol] = frame, lines, tuple(bodies)

    def _tied_by_no_momentum(self, momentum: int, pair: Sequence[sp.Symbol]) -> sp.Symbol | None:
        """The second component where it is that of the other sphere turned round: w = −v.

        So it is where equal masses have no momentum in all; that is a line. None elsewhere.
        """
        scene, own = self.scene, residual(self.scene, momentum)
        if scene.others or len(pair) != _PAIR or not self._letters.keys() >= set(pair):
            return None
        one, other = pair
        apart = own.subs(dict.fromkeys(pair, 0)), derivative(own, one) - derivative(own, other)
        if any(expanded(value) != 0 for value in apart):
            return None
        relation = chain(Letter(other.name), (tree_of(-one), None))
        line = scene.judge.write((Move("rearrange"),), (momentum,), relation)
        if line is None:
            return None
        scene.desk.know(Letter(other.name), -one, (line,))
        return other

    def _single(self, left: Sequence[Candidate]) -> tuple[Candidate, ...] | None:
        """A law of two spheres with one component open after it: that is expressed."""
        for own in sorted(left, key=lambda candidate: len(self._open(candidate))):
            law = self.equations.law(own)
            if law is None or law.kind not in LAWS or self._earlier(law):
                continue
            open_ = self._open(own)
            later = [s for s in open_ if s in self._after(law.number)]
            if len(later) != 1:
                continue
            (symbol,) = later
            number = self._shorter_law(law, symbol) or self._law_line(law)
            own_residual = residual(self.scene, number)
            if symbol not in symbols_in(own_residual):
                continue  # it is known by now
            if is_over_roots(own_residual, symbol):
                close(self.scene, number, symbol)
                return (own,)
            value = tidy(_solved(own_residual, symbol))
            subject = chain(Letter(symbol.name), (tree_of(value), None))
            moves = (Move("rearrange"), Move("identity", "pythagoras"))
            line = self.scene.judge.write(moves, (number,), subject)
            if line is None:
                # No formula joins 50° and 25°, though the value may be one in 25° alone.
                plain = sp.factor_terms(_solved(own_residual, symbol))
                apart = chain(Letter(symbol.name), (tree_of(plain), None))
                line = self.scene.judge.write(moves, (number,), apart)
                value = value if line is None else plain
            if line is None:
                line = self.scene.desk.write(Move("rearrange"), (number,), subject)
            self.scene.desk.know(Letter(symbol.name), value, (line,))
            return (own,)
        return None

    def tie_by_zero(self, given: GivenEquation) -> int | None:
        """The law that ties letters, once a fact has made a component zero and the other is used.

        What both laws make of that component in these letters is not worked out. None where the
        fact says of no component alone that it is zero, and where one of the laws stands.
        """
        standing = self.mark()
        with suppress(NotPlannedError):
            laws = self._laws_with_zero(given)
            if laws and self.scene.coefficient(laws[0].number).value.is_number:
                laws.reverse()
            line = self._second_law(laws) if laws else None
            if line is not None:
                return line
        self.back(standing)
        return None

    def express_by_zero(self, given: GivenEquation, names: frozenset[str]) -> bool:
        """Expresses a component by the one law in these letters, as a fact makes the other zero.

        False where the fact says no such thing, and where none or both of the laws are such.
        """
        standing = self.mark()
        with suppress(NotPlannedError):
            laws = [e for e in self._laws_with_zero(given) if self._is_in_letters(e, names)]
            if len(laws) == 1 and self._single([laws[0].candidate]) is not None:
                return True
        self.back(standing)
        return False

    def _laws_with_zero(self, given: GivenEquation) -> list[Law]:
        """The two laws of an impact after which a fact makes a component zero, as a line says now.

        None where it does not, and where one of the laws stands.
        """
        own, desk = candidate_of(given), self.scene.desk
        open_ = self._open(own) & self._letters.keys()
        if given.link.sign not in _TIES or len(own.residuals) != 1:
            return []
        zeros = self._vanishing(open_, own) if len(open_) > 1 else open_
        if len(zeros) != 1:
            return []
        (symbol,) = zeros
        number, _ = self._letters[symbol]
        laws = [law for law in self.equations.laws if law.number == number and law.kind in LAWS]
        if len(laws) != len(LAWS) or any(map(self._earlier, laws)):
            return []
        if any(written_law(self.scene, law.kind, number) for law in laws):
            return []
        zero = write_given(self.scene, given)
        link = desk.last_link(zero)
        if (link.left, link.right) != (Letter(symbol.name), ZERO):
            return []
        desk.know(link.left, sp.Integer(0), (zero,))
        return laws

    def _second_law(self, laws: Sequence[Law]) -> int | None:
        """The second of two laws with the component put in that the first one gives."""
        first, second = laws
        if self._single([first.candidate]) is None:
            return None
        line = self._law_line(second)
        if self.scene.unknown(residual(self.scene, line)) & self._letters.keys():
            return None
        self.equations.used |= {law.candidate.id for law in laws}
        return line

    def _is_in_letters(self, law: Law, names: frozenset[str]) -> bool:
        """Whether a law has no other letters than these, but for a component and common factors."""
        (value,) = (self.scene.with_values(x)[0] for x in law.candidate.residuals)
        factors = sp.Mul.make_args(sp.factor(value))
        inside = {s for x in factors for s in x.free_symbols if x.has(*self._letters)}
        return symbol_names(*(inside - self._letters.keys())) <= names

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
        ids = {candidate.id for candidate in left}
        for own in left:
            law = self.equations.law(own)
            if law is None or law.kind != "restitution" or f"momentum {law.number}" in ids:
                continue
            pair = self._after(law.number).keys()
            rest = [x for candidate in left if candidate != own for x in candidate.residuals]
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
