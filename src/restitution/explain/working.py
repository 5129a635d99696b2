"""The working of one part: principles as equations, in an order in which each line follows.

Nothing is solved here that the solution does not say already. The equations of the textbook are
put in an order, written with the values put in that are known so far, and what they give is taken
from the solution. Small linear steps (two components from two equations) are done with letters
still in them, as a teacher would.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from typing import Any, Literal

import sympy as sp

from restitution.components import Component, Frame, Law, Model
from restitution.errors import UnsupportedError
from restitution.exact import tidy, tidy_angle
from restitution.explain.checking import holds, refuted
from restitution.explain.events import names_of
from restitution.explain.kept import above as above_bar
from restitution.explain.kept import factored
from restitution.explain.order import blocks, needed
from restitution.explain.phrases import (
    OR,
    answer,
    chain,
    ordinal,
    relation,
    same_term,
)
from restitution.explain.steps import Origin, Row, Side, Step, StepKind, side
from restitution.explaining.marks import A1, B1, DM1, M1, Marks
from restitution.explaining.printing import look, printed
from restitution.explaining.saying import Sentence, say
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Value
from restitution.expression.tree import Expression
from restitution.problem import Aligned, Impact, Kick
from restitution.render import layout as lay
from restitution.render.layout import Bold, Layout
from restitution.solve.forms import signed
from restitution.solve.neat import linear_solution
from restitution.solve.numbers import at
from restitution.solve.polynomials import factors
from restitution.solve.solution import RejectedBranch
from restitution.vector import Vector
from restitution.work import spend

# What two directions are, or are not, to each other.
ALIGNED = {
    "perpendicular to": ("claim.perpendicular", "claim.not-perpendicular"),
    "parallel to": ("claim.parallel", "claim.not-parallel"),
    "in the direction of": ("claim.same-direction", "claim.not-same-direction"),
    "opposite to": ("claim.opposite", "claim.not-opposite"),
}

# Characters in a line of mathematics beyond which it is left out: it would help no one.
_LONGEST = 260


@dataclass(frozen=True)
class Equation:
    """An equation to be used: its residual, and how its step is written when it is.

    A ``datum`` ties letters of the statement together, a ``fact`` is given, and a ``path`` leads a
    sphere where it is told to come; ``carried`` is a result of an earlier part. ``number`` counts
    the events before it; data and carried results are there from the start.
    """

    residual: sp.Expr
    kind: Literal["carried", "datum", "momentum", "restitution", "fact", "path"]
    number: int
    step: Callable[[], Step | None]
    key: Any = None


# Equations from which an unknown is eliminated first.
_RANKS = {"carried": 0, "momentum": 1, "restitution": 2, "datum": 3, "fact": 3, "path": 3}


@dataclass
class Working:
    """Steps as they are written down, and what is known so far."""

    model: Model
    facts: list[Equation] = field(default_factory=list)
    alternatives: Sequence[Mapping[sp.Symbol, sp.Expr]] = ()
    rejected: Sequence[tuple[RejectedBranch, Mapping[sp.Symbol, sp.Expr]]] = ()
    steps: list[Step] = field(default_factory=list)
    known: dict[sp.Symbol, sp.Expr] = field(default_factory=dict)
    carried: dict[sp.Symbol, tuple[str, sp.Expr]] = field(default_factory=dict)
    wanted: set[sp.Symbol] = field(default_factory=set)
    across: bool = True
    done: set[Any] = field(default_factory=set)
    dropped: list[str] = field(default_factory=list)
    silent: set[sp.Symbol] = field(default_factory=set)
    read_off: set[sp.Symbol] = field(default_factory=set)
    asked: set[sp.Symbol] = field(default_factory=set)
    answered: set[sp.Symbol] = field(default_factory=set)
    item: int | None = None
    # What trees are worth in the story, by tree and event.
    _values: dict[tuple[Expression, int], Value] = field(default_factory=dict)

    @cached_property
    def events(self) -> lay.EventNames:
        """How the events of the story are called."""
        return names_of(self.model.story)

    def layout(self, tree: Expression) -> Layout:
        """The layout of a tree as it was written, with its events called by what they are."""
        return lay.from_tree(tree, self.events)

    def aligned(self, relation: Aligned, *, holds: bool = True) -> Sentence:
        """``**v**_A is perpendicular to **v**_B``, or that it is not."""
        left, right = self.layout(relation.left), self.layout(relation.right)
        claim, denial = ALIGNED[relation.relation]
        return say(claim if holds else denial, left=left, right=right)

    # --- values ---------------------------------------------------------------------------

    def value(self, tree: Expression, now: int) -> Value:
        """What a tree is worth after ``now`` events, in components and letters."""
        if (tree, now) not in self._values:
            self._values[tree, now] = self.model.story.evaluator(now).value(tree)
        return self._values[tree, now]

    def put(self, x: Any) -> Any:
        """An expression with everything put in that is known so far."""
        if isinstance(x, Vector):
            return Vector(self.put(x.x), self.put(x.y))
        x = self._known(sp.sympify(x, strict=True))
        return tidy(self.resolved(x))

    def _known(self, x: sp.Expr) -> sp.Expr:
        for _ in range(6):
            inside = tuple((s, self.known[s]) for s in _symbols(x) if s in self.known)
            if not inside:
                break
            x = _replaced(x, inside)
        return x

    def resolved(self, x: sp.Expr) -> sp.Expr:
        """Sizes |x| without bars where the sign of x is proved."""
        return signed(x, self.model.witnesses(x)) if x.has(sp.Abs) else x

    def open(self, x: Any) -> frozenset[sp.Symbol]:
        """The unknowns in an expression that are not known yet."""
        if isinstance(x, tuple):
            return self.open(x[0]) | self.open(x[1])
        return frozenset(
            s for s in _symbols(self._known(sp.sympify(x, strict=True))) if s in self.model.final
        )

    def uses(self, x: Any, event: int | None = None) -> dict[str, Origin]:
        """The values in an expression that had to be found, and where that was."""
        if isinstance(x, tuple):
            return {**self.uses(x[0], event), **self.uses(x[1], event)}
        found: dict[str, Origin] = {}
        numbers = {c.symbol: c.number for c in self.model.components.values()}
        data = self.silent | self.read_off
        for symbol in sp.sympify(x, strict=True).free_symbols & set(self.known) - data:
            if ("carried", 0, symbol) in self.done:
                found[symbol.name] = "part"
            elif symbol in self.answered:
                found[symbol.name] = "item"
            elif event is not None and numbers.get(symbol, event) < event:
                found[symbol.name] = "impact"
            else:
                found[symbol.name] = "method"
        return found

    def size(self, x: Any) -> sp.Expr:
        """|x|, without bars where the sign of x is proved."""
        return tidy(self.resolved(sp.Abs(sp.sympify(x, strict=True))))

    def sign(self, x: Any) -> int:
        return self.model.sign(self._known(sp.sympify(x, strict=True)))

    # --- writing down ---------------------------------------------------------------------

    def write(
        self,
        kind: StepKind,
        rows: Iterable[Row] = (),
        title: Sentence | None = None,
        sentences: Sequence[Sentence] = (),
        points: Marks = (),
        values: Mapping[str, Any] | None = None,
        uses: Mapping[str, Origin] | None = None,
        event: int | None = None,
    ) -> None:
        """Adds a step; lines that are not true for all letters are left out and noted."""
        checked = []
        rows = tuple(rows)
        for row in rows:
            spend()
            if too_long(row):
                continue  # true, but no one would write it
            if len(row.operands) > 1 and len(set(row.operands)) == 1:
                continue  # 0 = 0
            if holds(row, self.model.number) and not refuted(row, self.model):
                checked.append(row)
            else:
                self.dropped.append(_plain(row))
        sentences = tuple(sentences)
        if not checked and not sentences and not (title and points):
            return
        if not checked and rows and kind == "solve":
            return  # "So" would stand alone
        step = Step(
            kind,
            tuple(checked),
            title,
            sentences,
            points,
            dict(values or {}),
            dict(uses or {}),
            self.item,
            event,
        )
        if step in self.steps or (checked and any(_says(each, step) for each in self.steps)):
            return
        last = self.steps[-1] if self.steps else None
        if (
            last is not None
            and sentences
            and checked
            and last.sentences == sentences
            and last.rows
            and ((last.kind, last.title, last.points) == (kind, title, points))
        ):
            rows_ = tuple(r for r in checked if r not in last.rows)
            self.steps[-1] = replace(
                last,
                rows=last.rows + rows_,
                values={**last.values, **step.values},
                uses={**last.uses, **step.uses},
            )
            return
        self.steps.append(step)

    def add(self, step: Step | None) -> None:
        """Adds a step that is ready, after the same check."""
        if step is not None:
            self.write(
                step.kind,
                step.rows,
                step.title,
                step.sentences,
                step.points,
                step.values,
                step.uses,
            )

    def determine(self, symbol: sp.Symbol, value: Any | None = None) -> None:
        """From here on an unknown has its value."""
        self.known[symbol] = self.model.final[symbol] if value is None else value

    # --- reaching what is wanted --------------------------------------------------------------

    def reach(self, wanted: Iterable[sp.Symbol]) -> None:
        """Writes the working that determines these unknowns."""
        goal = {s for s in wanted if s in self.model.final} - set(self.known)
        if not goal:
            return
        equations = self._equations()
        sets = [self.open(each.residual) for each in equations]

        def left_in(index: int, known: Collection[sp.Symbol]) -> frozenset[sp.Symbol]:
            residual = self._known(sp.sympify(equations[index].residual, strict=True))
            put = ((s, self.model.final[s]) for s in _symbols(residual) if s in known)
            residual = _replaced(residual, tuple(put))
            if residual.free_symbols and self.model.identically_zero(residual):
                return frozenset()
            return self.open(residual)

        ordered = blocks(sets, left_in)
        ahead = needed(ordered, goal | (self.wanted & set(self.model.final)) - set(self.known))
        for block in needed(ordered, goal):
            group = [equations[index] for index in block.equations]
            elsewhere = {
                s for other in ahead if other is not block for i in other.equations for s in sets[i]
            }
            self._block(group, set(block.unknowns), self.wanted | elsewhere)
        left = sorted(goal - set(self.known), key=lambda s: s.name)
        if left:
            self._state(left)

    def _carried(self) -> list[Equation]:
        """Results of earlier parts, as equations that serve here."""
        return [
            Equation(symbol - value, "carried", 0, self._carried_step(symbol, label, value), symbol)
            for symbol, (label, value) in self.carried.items()
        ]

    def _carried_step(
        self, symbol: sp.Symbol, label: str, value: sp.Expr
    ) -> Callable[[], Step | None]:
        def step() -> Step | None:
            self._told_about(symbol)
            where = say("carried.part", label=label) if label else say("carried.above")
            return Step("result", (self._carried_row(symbol, value),), sentences=(where,))

        return step

    def _carried_row(self, symbol: sp.Symbol, value: sp.Expr) -> Row:
        name: Any = symbol
        if self.is_angle(symbol) and value.free_symbols:
            name, value = sp.tan(symbol), tidy(sp.tan(value))
        if self.is_angle(symbol) and name is symbol:
            return self.value_row(symbol, value=value)
        if value.free_symbols & set(self.known):
            return chain(side(name), side(value), side(self.put(value)), points=(M1,))
        if symbol in self.known:
            return chain(side(name), side(value), side(self.known[symbol]), points=(M1,))
        return chain(side(name), side(value))

    def _told_about(self, symbol: sp.Symbol) -> None:
        for number, body in self.model.components:
            if self.model.components[number, body].symbol == symbol:
                self.done.add(("setting", number))

    def _state(self, symbols: Sequence[sp.Symbol]) -> None:
        """What could not be derived line by line is stated, so that the rest can go on."""
        rows = []
        for symbol in symbols:
            self.determine(symbol)
            rows.append(self.value_row(symbol, points=self._points_of(symbol)))
        self.write("solve", rows, sentences=(say("solve.stated"),))
        self._confirm()

    def _confirm(self) -> None:
        """That a value which could only be stated satisfies what is given."""
        self.reach({c.symbol for c in self.model.components.values()})
        for fact in self.facts:
            if fact.kind != "datum" and fact.number > 0 and not self.open(fact.residual):
                self._use(fact)

    def _equations(self) -> list[Equation]:
        laws = [self._law(each) for each in self.model.laws]
        ordered = [each for each in self.facts if each.kind == "datum"]
        facts = [each for each in self.facts if each.kind != "datum"]
        for number in sorted({each.number for each in (*laws, *facts)}):
            ordered += [each for each in laws if each.number == number]
            ordered += [each for each in facts if each.number == number]
        if not self.carried:
            return ordered
        # What led to the results of earlier parts says nothing new beside them.
        put = {symbol: value for symbol, (_, value) in self.carried.items()}
        return self._carried() + [
            each for each in ordered if not self._spent(sp.sympify(each.residual, strict=True), put)
        ]

    def _spent(self, residual: sp.Expr, put: Mapping[sp.Symbol, sp.Expr]) -> bool:
        if not residual.free_symbols & set(put):
            return False
        for _ in range(3):
            residual = residual.xreplace(dict(put))
        return self.model.identically_zero(residual)

    def _law(self, law: Law) -> Equation:
        return Equation(
            law.residual,
            law.kind,
            law.number,
            lambda: (
                self._momentum(law.number)
                if law.kind == "momentum"
                else self._restitution(law.number)
            ),
        )

    def _block(
        self, group: list[Equation], unknowns: set[sp.Symbol], of_use: Collection[sp.Symbol]
    ) -> None:
        """Determines unknowns; those ``of_use``, here or in what follows, are written down."""
        if len(group) == 1:
            method = self._use(group[0])
            (x,) = unknowns
            if not method:
                self.read_off.add(x)
            self._root(x, group[0])
            return
        kinds = {(each.kind, each.number) for each in group}
        if kinds == {("momentum", group[0].number), ("restitution", group[0].number)}:
            self._pair(group, unknowns, of_use)
            return
        self._system(group, unknowns, of_use)

    def _speaks_of(self, group: Sequence[Equation]) -> list[int]:
        """The impacts whose components stand in these equations."""
        symbols = {s for each in group for s in sp.sympify(each.residual, strict=True).free_symbols}
        hidden = self.model.hidden_velocities
        of_before = {
            each.number
            for each in group
            if each.number in self.model.frames
            and any(s.name in hidden for s in sp.sympify(each.residual, strict=True).free_symbols)
        }
        lines = {
            number
            for number, frame in self.model.frames.items()
            for each in group
            if frame.by_values and each.kind in ("fact", "path") and each.number >= number
            if symbols & self.open(tuple(frame.n))
        }
        return sorted(
            {each.number for each in group if each.kind in ("momentum", "restitution")}
            | lines
            | {c.number for c in self.model.components.values() if c.symbol in symbols}
            | of_before
        )

    def _use(self, equation: Equation) -> bool:
        """Writes an equation down; tells whether that was a method, and no datum read off."""
        key = (equation.kind, equation.number, equation.key)
        if key in self.done:
            return True
        self.done.add(key)
        if equation.kind != "carried":
            for number in self._speaks_of([equation]):
                self.setting(number)
        if equation.kind in ("fact", "path") and equation.number > 0:
            self.blows(equation.number)
        step = equation.step()
        if step is not None:
            self.add(replace(step, uses=self.uses(equation.residual, equation.number)))
        return equation.kind == "carried" or (
            step is not None and any(M1 in row.points for row in step.rows)
        )

    def _pair(
        self, group: list[Equation], unknowns: set[sp.Symbol], of_use: Collection[sp.Symbol]
    ) -> None:
        for each in group:
            self._use(each)
        ordered = self._ordered(unknowns)
        chosen = [x for x in ordered if x in of_use] or ordered
        for x in ordered:
            self.determine(x)
        self._solved(say("solve.pair"), chosen)

    def _solved(self, sentence: Sentence, symbols: Sequence[sp.Symbol]) -> None:
        """What several equations give together."""
        rows = [self.value_row(x, points=self._points_of(x)) for x in symbols]
        self.write("solve", rows, sentences=(sentence,), points=(DM1,))

    def _points_of(self, x: sp.Symbol) -> Marks:
        """A value is worth a mark if it is asked for; on the way to another it is not."""
        return (A1,) if x in self.asked else ()

    def _ordered(self, symbols: Iterable[sp.Symbol]) -> list[sp.Symbol]:
        order = [each.symbol for each in self.model.components.values()]
        return sorted(symbols, key=lambda s: (order.index(s) if s in order else len(order), s.name))

    def value_row(self, x: sp.Symbol, points: Marks = (), value: Any = None) -> Row:
        """``v = 2``."""
        found = self.put(x) if value is None else value
        if self.is_angle(x):
            return chain(side(x), *answer(tidy_angle(found), angle=True), points=points)
        if x.name in self.model.unknowns.roles:
            return chain(side(x), *answer(found), points=points)
        return chain(side(x), side(found), points=points)

    def is_angle(self, x: sp.Symbol) -> bool:
        role = self.model.unknowns.roles.get(x.name)
        return role is not None and role.kind == "angle"

    # --- systems ----------------------------------------------------------------------------------

    def _system(
        self, group: list[Equation], unknowns: set[sp.Symbol], of_use: Collection[sp.Symbol]
    ) -> None:
        left = list(group)
        local: list[sp.Symbol] = []
        self._take_carried(left, local)
        laws = ("momentum", "restitution")
        for number in sorted({each.number for each in group if each.kind in laws}):
            pair = [e for e in left if e.number == number and e.kind in laws]
            parts = [
                c.symbol
                for (n, _), c in self.model.components.items()
                if n == number and c.symbol in unknowns and c.symbol not in self.known
            ]
            if not pair or len(pair) != len(parts):
                continue
            found = self._linear(pair, parts)
            if found is None:
                continue
            for each in pair:
                self._use(each)
                left.remove(each)
            for symbol in parts:
                self.known[symbol] = found[symbol]
                local.append(symbol)
            needed_later = {
                s for e in left for s in sp.sympify(e.residual, strict=True).free_symbols
            }.union(of_use)
            chosen = [x for x in parts if x in needed_later] or parts
            if len(pair) > 1:
                self._solved(say("solve.pair"), chosen)
        self._finish(left, unknowns - set(local), local)
        rows = []
        for symbol in [x for x in self._ordered(local) if x in self.wanted]:
            before = tidy(sp.sympify(self.known[symbol], strict=True))
            final = self.model.final[symbol]
            if look(before) != look(final):
                rows.append(chain(side(symbol), side(final)))
        for symbol in unknowns:
            self.determine(symbol)
        if rows:
            self.write("solve", rows, sentences=(say("so"),))

    def _take_carried(self, left: list[Equation], local: list[sp.Symbol]) -> None:
        """Results of earlier parts that hold letters still to be found."""
        for each in [e for e in left if e.kind == "carried"]:
            symbol = each.key
            if symbol in self.known or symbol in {
                s
                for x in left
                for s in self.open(x.residual)
                if x.kind == "carried" and x is not each and s == symbol
            }:
                continue
            if self.is_angle(symbol):
                continue
            self._use(each)
            left.remove(each)
            self.known[symbol] = self.carried[symbol][1]
            local.append(symbol)

    def _linear(
        self, pair: Sequence[Equation], parts: Sequence[sp.Symbol]
    ) -> dict[sp.Symbol, sp.Expr] | None:
        found = linear_solution(
            tuple(self._known(sp.sympify(e.residual, strict=True)) for e in pair), tuple(parts)
        )
        if found is None:
            return None
        values = dict(zip(parts, (tidy(each) for each in found), strict=True))
        if any(v.free_symbols & set(parts) for v in values.values()):
            return None
        return values

    def _finish(
        self, left: list[Equation], unknowns: set[sp.Symbol], local: list[sp.Symbol]
    ) -> None:
        """Facts that fix the letters left: one at a time where that can be."""
        left = list(left)
        while left:
            opened = [(each, self.open(each.residual)) for each in left]
            opened = [(each, inside) for each, inside in opened if inside]
            if not opened:
                return
            left = [each for each, _ in opened]
            single = next(((e, u) for e, u in opened if len(u) == 1), None)
            if single is not None:
                equation, inside = single
                self._use(equation)
                (x,) = inside
                self._root(x, equation)
                left.remove(equation)
                continue
            choice = self._eliminable(opened, {s for _, u in opened for s in u})
            if choice is None:
                break
            equation, x, value = choice
            self._use(equation)
            left.remove(equation)
            self.known[x] = value
            rows = [self.value_row(x, value=value)]
            if not self._already(rows):
                self.write("solve", rows)
            local.append(x)
        rest = {s for each in left for s in self.open(each.residual)}
        if rest:
            for each in left:
                self._use(each)
            for x in rest:
                self.determine(x)
            self._solved(say("solve.together"), self._ordered(rest))

    def _eliminable(
        self, opened: Sequence[tuple[Equation, frozenset[sp.Symbol]]], among: set[sp.Symbol]
    ) -> tuple[Equation, sp.Symbol, sp.Expr] | None:
        """An equation that is linear in one of its unknowns, and what it gives."""
        best: tuple[tuple[float, ...], Equation, sp.Symbol, sp.Expr] | None = None
        order = self._ordered(among)
        for position, (equation, inside) in enumerate(opened):
            numerator = self.numerator(equation.residual)
            for x in inside:
                if self.is_angle(x) or not numerator.is_polynomial(x):
                    continue
                poly = sp.Poly(numerator, x)
                if poly.degree() != 1:
                    continue
                a, b = poly.all_coeffs()
                if self.model.sign(a) == 0:
                    continue
                value = tidy(-b / a)
                component = any(x == c.symbol for c in self.model.components.values())
                rank = _RANKS[equation.kind]
                key = (
                    0.0 if component else 1.0,
                    float(rank),
                    float(sp.count_ops(value)),
                    position,
                    order.index(x),
                )
                if best is None or key < best[0]:
                    best = (key, equation, x, value)
        return None if best is None else best[1:]

    def numerator(
        self, residual: Any, x: sp.Symbol | None = None, others: Sequence[sp.Expr] = ()
    ) -> sp.Expr:
        """What has to vanish: the factors of the numerator that are zero.

        With other roots for ``x``, those that are zero there are kept as well.
        """
        own = x
        x = self.resolved(self._known(sp.sympify(residual, strict=True)))
        above = above_bar(x)
        try:
            parts = factors(sp.expand(above))
        except (sp.PolynomialError, UnsupportedError):
            return sp.expand(above)
        kept = sp.Integer(1)
        for factor in parts:
            if self.model.sign(factor) == 0 or (
                own is not None
                and factor.has(own)
                and any(self._satisfies(own, value, factor) for value in others)
            ):
                kept *= factor
        if own is not None and kept.has(own):
            mirrored = kept.xreplace({own: -own})
            for factor in parts:
                same = 0 in (sp.expand(factor - mirrored), sp.expand(factor + mirrored))
                if factor.has(own) and same and sp.expand(kept - factor) != 0:
                    kept *= factor
                    break
        return sp.expand(above) if kept == 1 else kept

    # --- one equation for one unknown ------------------------------------------------------------

    def _root(self, x: sp.Symbol, equation: Equation) -> None:
        """The lines from an equation to the value of its only unknown."""
        if equation.kind == "datum" and self.is_angle(x):
            self.determine(x)  # its sine and cosine have just been written
            return
        others = self._other_roots(x, equation.residual)
        value = self.model.final[x]
        rows: list[Row] = []
        if self.is_angle(x) or not self._linear_in(x, equation.residual):
            numerator = self.numerator(
                equation.residual, x, [*others, *self._refused(x, equation.residual)]
            )
            self.determine(x)
            if self.is_angle(x):
                rows = self._angle_rows(x, numerator, value, others)
            elif numerator.is_polynomial(x):
                rows = self._polynomial_rows(x, numerator, value, others)
        self.determine(x)
        if not rows:
            rows = [self._roots_row(x, value, others)]
        if not rows or too_long(rows[0]):
            rows = [self._roots_row(x, value, others)]
        note = self._why_rejected(x, equation.residual)
        if note:
            last = rows[-1]
            rows[-1] = replace(last, asides=note)
        if self._already(rows):
            return
        last = rows[-1]
        if not last.points:
            rows[-1] = replace(last, points=self._points_of(x))
        self.write("solve", rows, values={x.name: value})

    def _linear_in(self, x: sp.Symbol, residual: sp.Expr) -> bool:
        """Whether an equation is plainly linear in an unknown, so that its root is all to say."""
        here = self._known(sp.sympify(residual, strict=True))
        return not here.has(sp.Abs) and here.is_polynomial(x) and not here.diff(x).has(x)

    def _already(self, rows: Sequence[Row]) -> bool:
        """Whether the step just written says the same."""
        if len(rows) != 1 or not self.steps or not self.steps[-1].rows or rows[0].asides:
            return False
        last, new = self.steps[-1].rows[-1].operands, rows[0].operands
        if last[0] != new[0] or last[-1] is None:
            return False
        ends = [each for each in (new[1], new[-1]) if each is not None]
        return any(last[-1] == each or same_term(last[-1], each) for each in ends)

    def _roots_row(self, x: sp.Symbol, value: sp.Expr, others: Sequence[sp.Expr]) -> Row:
        first = self.value_row(x, value=value)
        if not others:
            return first
        values = sorted([value, *others], key=lambda v: float(self.model.number(v)))
        rows = [self.value_row(x, value=each) for each in values]
        cases = [lay.Relation(tuple(o for o in r.operands if o is not None), r.signs) for r in rows]
        tail: list[Layout] = []
        for index, case in enumerate(cases):
            if index:
                tail.append(case)
        body = (
            lay.Phrase((lay.Relation(cases[0].operands[1:], cases[0].signs[1:]), *tail), OR)
            if len(cases[0].operands) > 2
            else lay.Phrase((cases[0].operands[1], *tail), OR)
        )
        return Row((look(x), body), ("=",), (None, None), alternatives=True)

    def _other_roots(self, x: sp.Symbol, residual: Any) -> list[sp.Expr]:
        """Values in other solutions that satisfy the same equation."""
        found: list[sp.Expr] = []
        own = self.model.final[x]
        for final in self.alternatives:
            value = final.get(x)
            if value is None or any(self._equal(value, each) for each in (own, *found)):
                continue
            if self._satisfies(x, value, residual):
                found.append(value)
        return found

    def _equal(self, a: Any, b: Any) -> bool:
        return self.model.sign(sp.sympify(a, strict=True) - sp.sympify(b, strict=True)) == 0

    def _satisfies(self, x: sp.Symbol, value: Any, residual: Any) -> bool:
        try:
            number = self.model.number(value)
            here = self._known(sp.sympify(residual, strict=True))
            found = at(here, {**self.model.sample, x.name: number})
        except (UndefinedError, KeyError, ArithmeticError):
            return False
        if found.sign:
            return False
        return self.model.decide(here.xreplace({x: value}), "=", 0).answer != "refuted"

    def _refused(self, x: sp.Symbol, residual: Any) -> list[sp.Expr]:
        """Values that satisfy the equation and were rejected."""
        found = []
        for _, values in self.rejected:
            value = values.get(x)
            if value is not None and self._satisfies(x, value, residual):
                found.append(sp.sympify(value, strict=True))
        return found

    def _why_rejected(self, x: sp.Symbol, residual: Any) -> tuple[Sentence, ...]:
        reasons: list[Sentence] = []
        seen: list[Any] = []
        known = self.known.pop(x, None)
        for branch, values in self.rejected:
            value = values.get(x)
            if value is None or any(self._equal(value, each) for each in seen):
                continue
            role = self.model.unknowns.roles.get(x.name)
            if branch.kind == "range" and role is not None and role.kind == "angle":
                continue  # an acute angle was meant from the start
            value = sp.sympify(value, strict=True)
            if self._equal(value, self.model.final[x]) or not self._satisfies(x, value, residual):
                continue
            seen.append(value)
            shown_ = self.value_row(x, value=tidy(value))
            layout = lay.Relation(tuple(o for o in shown_.operands if o is not None)[:2], ("=",))
            blamed = self._blamed(x, branch)
            if blamed is None:
                reasons.append(say("rejected.reason", case=layout, reason=branch.reason))
            else:
                reasons.append(
                    say(
                        "rejected.coefficient",
                        case=layout,
                        coefficient=blamed,
                        reason=branch.reason,
                    )
                )
        if known is not None:
            self.known[x] = known
        return tuple(reasons)

    def _blamed(self, x: sp.Symbol, branch: RejectedBranch) -> Layout | None:
        """The impossible coefficient to which a rejected value of something else leads."""
        if branch.kind != "coefficient":
            return None
        for name, value in branch.values.items():
            role = self.model.unknowns.roles.get(name)
            if role is not None and role.kind == "restitution" and name != x.name:
                return lay.equation(
                    self.model.unknowns.letter(name), tidy(sp.sympify(value, strict=True))
                )
        return None

    def _polynomial_rows(
        self, x: sp.Symbol, numerator: sp.Expr, value: sp.Expr, others: Sequence[sp.Expr]
    ) -> list[Row]:
        poly = sp.Poly(numerator, x)
        final = self._roots_row(x, value, others)
        if poly.degree() == 1:
            return [final]
        rows: list[Row] = []
        if poly.degree() == 2 and poly.coeff_monomial(x) == 0:
            a, c = poly.coeff_monomial(x**2), poly.coeff_monomial(1)
            rows.append(chain(side(x**2), side(tidy(-c / a))))
            return [*rows, final]
        expanded = self._cleared(poly.as_expr())
        rows.append(relation(side(expanded), "=", side(sp.Integer(0))))
        product = factored(expanded)
        if product.is_Mul and sum(f.has(x) for f in product.args) > 1:
            rows.append(relation(side(product), "=", side(sp.Integer(0))))
        return [*rows, final]

    def _cleared(self, expression: sp.Expr) -> sp.Expr:
        """Whole coefficients without a common factor, the highest power positive."""
        try:
            _, cleared = sp.expand(expression).as_content_primitive()
            cleared = sp.expand(sp.fraction(sp.together(cleared))[0])
        except (AttributeError, sp.PolynomialError):
            cleared = expression
        return -cleared if cleared.could_extract_minus_sign() else cleared

    def _angle_rows(
        self, x: sp.Symbol, numerator: sp.Expr, value: sp.Expr, others: Sequence[sp.Expr] = ()
    ) -> list[Row]:
        """From sines and cosines to the tangent, and to the angle."""
        t = TANGENT
        tangent = sp.tan(x)
        poly = by_tangent(numerator, x, t)
        angle = self._roots_row(x, value, others)
        if poly is None:
            return [angle]
        own = tidy(sp.tan(value))
        tangents = [own, *(tidy(sp.tan(each)) for each in others)]
        rows: list[Row] = []
        parts = [f for f in factors(poly) if f.has(t)]
        kept = [f for f in parts if any(self._vanishes(f, t, each) for each in tangents)] or parts
        p = sp.Poly(sp.Mul(*kept), t)
        if p.degree() == 1:
            rows.append(chain(side(tangent), side(tidy(-p.coeff_monomial(1) / p.LC()))))
        elif p.degree() == 2 and p.coeff_monomial(t) == 0:
            square = tidy(-p.coeff_monomial(1) / p.LC())
            rows.append(chain(side(tangent**2), side(square)))
            rows.append(self._either(tangent, tangents))
        else:
            whole = self._cleared(p.as_expr())
            rows.append(relation(side(whole.xreplace({t: tangent})), "=", side(sp.Integer(0))))
            product = factored(whole)
            if product.is_Mul and sum(f.has(t) for f in product.args) > 1:
                rows.append(
                    relation(side(product.xreplace({t: tangent})), "=", side(sp.Integer(0)))
                )
            rows.append(self._either(tangent, tangents))
        if not value.free_symbols:
            rows.append(angle)
        return rows

    def _either(self, name: sp.Expr, values: Sequence[sp.Expr]) -> Row:
        """``tan α = 1 or tan α = ¼``."""
        if len(values) == 1:
            return chain(side(name), side(values[0]))
        ordered = sorted(values, key=lambda v: float(self.model.number(v)))
        tail = [lay.Relation((look(name), look(v)), ("=",)) for v in ordered[1:]]
        body = lay.Phrase((look(ordered[0]), *tail), OR)
        return Row((look(name), body), ("=",), (None, None), alternatives=True)

    def _vanishes(self, factor: sp.Expr, t: sp.Symbol, own: sp.Expr) -> bool:
        return self.model.sign(factor.xreplace({t: own})) == 0

    # --- the principles ------------------------------------------------------------------------

    def setting(self, number: int) -> None:
        """Sets the axes of an impact, names the unknown components, and what does not change."""
        if ("setting", number) in self.done:
            return
        self.done.add(("setting", number))
        frame = self.model.frames[number]
        self._before(number)
        self._heading(number)
        unknown = [c for (n, _), c in self.model.components.items() if n == number]
        self._named_before(number)
        if frame.wall is None:
            self._setting_of_spheres(frame, unknown)
        else:
            self._setting_of_wall(frame, unknown)
        self._unchanged(number)

    def _before(self, number: int) -> None:
        """What the velocities before and the line of centres rest on is found first."""
        happening = self.model.happening(number)
        inside: set[sp.Symbol] = set()
        for body in happening.bodies:
            if body in happening.before:
                inside |= {
                    s
                    for part in happening.before[body]
                    for s in sp.sympify(part, strict=True).free_symbols
                    if any(s == c.symbol for c in self.model.components.values())
                }
        self.reach({s for s in inside if s not in self.known and self._reachable(s, number)})
        self.blows(number - 1)

    def _reachable(self, symbol: sp.Symbol, number: int) -> bool:
        """Whether earlier impacts alone fix a component."""
        laws = [self._law(each) for each in self.model.laws if each.number < number]
        sets = [self.open(each.residual) for each in laws]
        return any(symbol in block.unknowns for block in blocks(sets))

    def blows(self, upto: int) -> None:
        """Impulses from outside up to an event."""
        from restitution.explain.blows import kick

        for each in self.model.story.happenings[:upto]:
            if isinstance(each.step, Kick):
                kick(self, each.number)

    def _heading(self, number: int) -> None:
        impacts = [h for h in self.model.story.happenings if isinstance(h.step, Impact)]
        if len(impacts) < 2:
            return
        happening = self.model.happening(number)
        order = 1 + impacts.index(happening) if happening in impacts else number
        first, second = happening.bodies
        spoken = ordinal(order)
        heading = (
            say("heading.impact-number", number=order, first=first, second=second)
            if spoken is None
            else say("heading.impact", order=spoken, first=first, second=second)
        )
        self.write("heading", sentences=(heading,), event=number)

    def _named_before(self, number: int) -> None:
        """Letters for velocities before that are not given."""
        story = self.model.story
        for body in self.model.spheres(number):
            if (
                story.latest(body, number - 1) is not None
                or body not in self.model.hidden_velocities.values()
            ):
                continue
            u = story.velocity(body, 0)
            letters = look((u.x, u.y))
            self.write("setting", sentences=(say("let.velocity", letters=letters, body=body),))

    def _setting_of_spheres(self, frame: Frame, unknown: Sequence[Component]) -> None:
        sentences: list[Sentence] = []
        if frame.axis is not None:
            sentences.append(say("line.axis", axis=Bold(frame.axis)))
        else:
            self.line_of_centres(frame)
        open_ = [c for c in unknown if c.symbol not in self.known]
        letters, bodies = [look(c.symbol) for c in open_], [c.body for c in open_]
        first, second = self.model.happening(frame.number).bodies
        if open_ and frame.axis is not None:
            axis = Bold(frame.axis)
            sentences.append(
                say("let.components", letters=letters, bodies=bodies, axis=axis)
                if len(open_) > 1
                else say("let.component", letter=letters[0], body=bodies[0], axis=axis)
            )
        elif len(open_) > 1:
            sentences.append(
                say(
                    "let.components-centres",
                    letters=letters,
                    bodies=bodies,
                    first=first,
                    second=second,
                )
            )
        elif open_:
            sentences.append(
                say(
                    "let.component-centres",
                    letter=letters[0],
                    body=bodies[0],
                    first=first,
                    second=second,
                )
            )
        self.write("setting", sentences=sentences)
        self._resolved(frame)

    def line_of_centres(self, frame: Frame) -> None:
        """How the line of centres is known where it is along no axis (see ``geometry``)."""
        from restitution.explain.geometry import line_of_centres

        line_of_centres(self, frame)

    def _setting_of_wall(self, frame: Frame, unknown: Sequence[Component]) -> None:
        (component,) = unknown
        chord = self.model.on_a_chord(frame.number, component.body)
        if chord:
            un, ut = (self.put(x) for x in self.model.before(frame.number, component.body))
            self.write(
                "principle",
                sentences=(
                    say(
                        "chord.components",
                        body=component.body,
                        wall=frame.wall or "",
                        towards=look(tidy(-un)),
                        along=look(ut),
                    ),
                ),
                points=(M1,),
            )
        elif frame.by_values or frame.angle is not None:
            self.line_of_centres(frame)
        wall, body = frame.wall or "", component.body
        if component.symbol in self.known:
            sentence = say("resolve.known", body=body, wall=wall)
        else:
            sentence = say("resolve.let", wall=wall, letter=look(component.symbol), body=body)
        self.write("setting", sentences=(sentence,))
        self._resolved(frame)

    def _resolved(self, frame: Frame) -> None:
        """The components before, where they have to be worked out."""
        from restitution.explain.geometry import resolved

        rows = resolved(self, frame)
        if rows:
            sentence = say("resolved-spheres.before")
            if frame.wall is not None:
                sentence = say("resolved-wall.before", wall=frame.wall)
            self.write("principle", rows, sentences=(sentence,))

    def _unchanged(self, number: int) -> None:
        if not self.across:
            return
        frame = self.model.frames[number]
        parts: list[tuple[Layout, str]] = []
        for body in self.model.spheres(number):
            _, t = self.model.before(number, body)
            value = self.put(t)
            if self.open(value) & {c.symbol for c in self.model.components.values()}:
                continue
            parts.append((look(value), body))
        if not parts:
            return
        if all(part[0] == lay.Number("0") for part in parts):
            if frame.wall is None and len(parts) == 2:
                return
            if frame.wall is not None:
                return
        if frame.wall is not None:
            self.write(
                "principle",
                title=say("unchanged-wall.title", wall=frame.wall),
                sentences=(say("unchanged-wall.component", value=parts[0][0]),),
                points=(B1,),
            )
            return
        self.write(
            "principle",
            title=say("unchanged.title"),
            sentences=(
                say(
                    "unchanged.components",
                    components=[
                        say("unchanged.component", value=value, body=body) for value, body in parts
                    ],
                ),
            ),
            points=(B1,),
        )

    def letters(self) -> set[sp.Symbol]:
        """The letters of the statement, as against components and hidden unknowns."""
        return {self.model.unknowns.letter(name) for name in self.model.unknowns.roles}

    def _momentum(self, number: int) -> Step:
        story = self.model.story
        first, second = self.model.happening(number).bodies
        masses = [self.put(story.mass(name)) for name in (first, second)]
        before = [self.put(self.model.before(number, name)[0]) for name in (first, second)]
        after = [self.put(self.model.after(number, name)) for name in (first, second)]
        left = side(tidy(_total(masses, before)), _momenta(masses, before))
        right = side(_total(masses, after), _momenta(masses, after))
        rows = [chain(left, right, points=(M1, A1))]
        rows += self._simpler(masses, before, after, rows[0])
        return Step("principle", tuple(rows), say("momentum.title"))

    def _simpler(
        self,
        masses: Sequence[sp.Expr],
        before: Sequence[sp.Expr],
        after: Sequence[sp.Expr],
        first: Row,
    ) -> list[Row]:
        common = _common(masses)
        if common == 1 and not any(self.open(v) for v in after):
            return []
        ratios = [tidy(m / common) for m in masses]
        total = tidy(_total([m / common for m in masses], before))
        row = chain(side(total), side(_total(ratios, after), _momenta(ratios, after)))
        return [] if row.operands == first.operands else [row]

    def _restitution(self, number: int) -> Step:
        frame = self.model.frames[number]
        happening = self.model.happening(number)
        e = self.put(happening.e)
        if frame.wall is not None:
            body = happening.bodies[0]
            w = self.put(self.model.after(number, body))
            approach = self.put(-self.model.before(number, body)[0])
            value = tidy(e * approach)
            made = printed("e*u", e=e, u=approach, zeros=True)
            sides = [side(w), side(value, made)]
            if not same_term(made, look(value)):
                sides.append(side(value))
            return Step("principle", (chain(*sides, points=(M1, A1)),), say("restitution.title"))
        first, second = happening.bodies
        u1, u2 = (self.put(self.model.before(number, name)[0]) for name in (first, second))
        v, w = (self.put(self.model.after(number, name)) for name in (first, second))
        approach = tidy(u1 - u2)
        separation = side(w - v, printed("w - v", w=w, v=v))
        sides = [separation]
        if self.model.sign(approach) < 0 and not approach.free_symbols:
            sides = [side(v - w, printed("v - w", v=v, w=w))]
            u1, u2, approach = u2, u1, -approach
        sides.append(side(e * approach, printed("e*(u - v)", e=e, u=u1, v=u2)))
        if not same_term(sides[-1].layout, look(tidy(e * approach))):
            sides.append(side(tidy(e * approach)))
        return Step("principle", (chain(*sides, points=(M1, A1)),), say("restitution.title"))


# The same few expressions are looked at again and again while a working grows.
@lru_cache(maxsize=4096)
def _symbols(x: sp.Expr) -> tuple[sp.Symbol, ...]:
    return tuple(x.free_symbols)


@lru_cache(maxsize=4096)
def _replaced(x: sp.Expr, put: tuple[tuple[sp.Symbol, sp.Expr], ...]) -> sp.Expr:
    return x.xreplace(dict(put))


def _says(earlier: Step, step: Step) -> bool:
    """Whether a step, with its words, stands in an earlier one."""
    same = (earlier.kind, earlier.title, earlier.sentences) == (
        step.kind,
        step.title,
        step.sentences,
    )
    return same and bool(step.sentences) and set(step.rows) <= set(earlier.rows)


def _momenta(masses: Sequence[sp.Expr], components: Sequence[sp.Expr]) -> Layout:
    """The momentum of two spheres, with the values put in."""
    (m, n), (u, v) = masses, components
    return printed("m*u + n*v", m=m, u=u, n=n, v=v)


def _total(masses: Sequence[sp.Expr], components: Sequence[sp.Expr]) -> sp.Expr:
    return sum((m * u for m, u in zip(masses, components, strict=True)), sp.Integer(0))


def _common(masses: Sequence[sp.Expr]) -> sp.Expr:
    """The common factor of the masses."""
    common = masses[0]
    for each in masses[1:]:
        common = sp.gcd(common, each)
    if common.is_number and not common.is_Rational:
        return sp.Integer(1)
    denominators = [sp.fraction(m / common)[1] for m in masses]
    scale = sp.Integer(1)
    for each in denominators:
        if each.is_Integer:
            scale = sp.ilcm(scale, each)
    return common / scale if common != 0 else sp.Integer(1)


TANGENT = sp.Dummy("t", positive=True)
"""The tangent of an angle, while something is worked out in it."""


@lru_cache(maxsize=512)
def by_tangent(x: sp.Expr, angle: sp.Symbol, t: sp.Symbol) -> sp.Expr | None:
    """A polynomial in the sine and cosine of an angle as one in its tangent, if it can be."""
    c, s = sp.Symbol("_c", positive=True), sp.Symbol("_s", positive=True)
    rewritten = sp.expand_trig(x) if x.has(sp.sin, sp.cos) else x
    rewritten = rewritten.subs(sp.tan(angle), s / c)
    rewritten = rewritten.subs({sp.sin(angle): s, sp.cos(angle): c})
    if rewritten.has(angle):
        return None
    rewritten = sp.expand(sp.fraction(sp.together(rewritten))[0])
    if not rewritten.is_polynomial(c, s) or not rewritten.has(c, s):
        return None
    poly = sp.Poly(rewritten, c, s)
    sums = {sum(m) for m in poly.monoms()}
    if len({m % 2 for m in sums}) > 1:
        return None
    top = max(sums)
    total = sp.Integer(0)
    for (a, b), coefficient in poly.terms():
        total += coefficient * t**b * (1 + t**2) ** ((top - a - b) // 2)
    return sp.expand(total)


def too_long(row: Row) -> bool:
    """Whether a line is longer than anyone would write."""
    from restitution.render.text import to_text

    return sum(len(to_text(each)) for each in row.operands if each is not None) > _LONGEST


def _plain(row: Row) -> str:
    from restitution.render.text import to_text

    parts = [to_text(row.operands[0]) if row.operands[0] is not None else ""]
    for sign, operand in zip(row.signs, row.operands[1:], strict=True):
        parts += [sign, to_text(operand) if operand is not None else ""]
    return " ".join(parts)


__all__ = ["Equation", "Side", "Working", "by_tangent"]
