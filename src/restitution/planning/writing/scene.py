"""One part of a question, ready to be written: values in letters, frames, facts as equations."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import Any, Literal

import sympy as sp

from restitution.components.models import Model
from restitution.exact.symbols import atoms_in, expression_of, substituted, symbol_names, symbols_in
from restitution.explaining.data.facts import staged
from restitution.explaining.lines.derivation import Fact, Link, Meaning, Move, Ref, Relation
from restitution.explaining.lines.trees import rebuilt, trees_of
from restitution.expression.evaluate import Angle, Evaluator
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    AtTime,
    Expression,
    Letter,
    Name,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    letter_nodes,
    plain_letter,
    walk,
)
from restitution.planning.writing.angle_ratios import (
    letter_of_a_ratio,
    ratio_of_a_multiple,
    ratios_and_letters,
    write_complement,
    write_other_ratio,
    write_ratios,
)
from restitution.planning.writing.changes import by_a_multiple, by_its_change
from restitution.planning.writing.desk import Desk, NotPlannedError, Source, is_value_of, together
from restitution.planning.writing.forms import neat, tree_of
from restitution.planning.writing.frames import Frame, frame_of
from restitution.planning.writing.judging import Judge
from restitution.planning.writing.polynomials import expanded
from restitution.problem import Arrival, Find, Part, Problem, Show, trees, trees_of_step
from restitution.records import dataclass
from restitution.solving.algebra.forms import bars_of
from restitution.solving.equations import facts as solve_facts
from restitution.solving.equations.solution import PartSolution
from restitution.solving.story.conditions import Equation
from restitution.vector import Vector

# A letter is put in so often, since what is put in for others may hold it.
_MOST = 4


@dataclass(frozen=True)
class GivenEquation:
    """A given fact as an equation: ``residuals`` are zero.

    In ``link`` letters stand no more for what the statement lets them be; ``lets`` says so.
    """

    fact: Fact
    link: Link
    residuals: tuple[sp.Expr, ...]
    lets: tuple[Ref, ...] = ()

    @property
    def refs(self) -> tuple[Ref, ...]:
        """What the letters of the fact are, and the fact."""
        return (*self.lets, self.fact.id)


@dataclass
class Scene:
    """A part, its story in the letters of components, and the desk on which it is written.

    ``others`` are the models of all solutions of the part, where there are several.
    """

    problem: Problem
    part: Part
    solution: PartSolution
    model: Model
    desk: Desk
    others: tuple[Model, ...] = ()
    frames: dict[int, Frame] = field(default_factory=dict)
    free: set[sp.Symbol] = field(default_factory=set)
    """Letters that an item leaves open, though facts tie them to others."""
    sided: int = 0
    """How many solutions there are beside **j**, where each has one mirrored along **i**."""
    turned: bool = False
    """Whether letters are told by those in which the answers are to be given."""
    ties: dict[str, Relation] = field(default_factory=dict)
    """What the facts say of such letters, by the id of the fact, as lines say it."""
    find_frame: Callable[[Scene, int], Frame] | None = None
    of_offsets: tuple[GivenEquation, ...] = ()
    """What offsets say of angles of lines of centres that have letters."""
    kept: frozenset[sp.Symbol] = frozenset()
    """Angles of which no ratio is put in for now."""
    out_of_range: bool = False
    """Whether the values that are written are such as a letter cannot have."""
    _initial: dict[str, Source] = field(default_factory=dict)
    _put: dict[sp.Expr, tuple[sp.Expr, tuple[Ref, ...]]] = field(default_factory=dict)
    _unknown: dict[sp.Expr, frozenset[sp.Symbol]] = field(default_factory=dict)
    _turned: dict[int, tuple[Frame, Frame]] = field(default_factory=dict)
    """Frames as they are with what is known put in, each beside what it was."""
    _at: tuple[object, ...] | None = None
    _names: tuple[int, Mapping[str, sp.Symbol]] | None = None
    _worths: dict[Expression, sp.Expr] = field(default_factory=dict)
    _gaps: dict[tuple[Expression, Expression], sp.Expr] = field(default_factory=dict)
    _values: defaultdict[str, dict[Expression, Any]] = field(
        default_factory=lambda: defaultdict(dict)
    )

    # --- the story ------------------------------------------------------------------------------

    @cached_property
    def facts(self) -> dict[str, Fact]:
        """The facts of the question by id."""
        return {fact.id: fact for fact in self.desk.facts}

    @cached_property
    def judge(self) -> Judge:
        """Who reads the lines as the follower does."""
        return Judge(self.problem, self.desk)

    @cached_property
    def speaks_of_times(self) -> bool:
        """Whether the question asks or tells when something happens."""
        return any(
            isinstance(node, Quantity) and (node.kind == "time" or isinstance(node.stage, AtTime))
            for tree in trees(self.problem)
            for node in walk(tree)
        )

    @cached_property
    def asked(self) -> frozenset[Expression]:
        """Everything in what the part asks and what it is to show."""
        return frozenset(
            node
            for item, now in self.problem.asked(self.part)
            for tree in trees_of_step(item if isinstance(item, Show) else Find((item,)))
            for node in walk(staged(self.problem, tree, now))
        )

    @cached_property
    def asked_alone(self) -> frozenset[Expression]:
        """What the part asks for by itself, as lines say it."""
        return frozenset(
            staged(self.problem, tree, now)
            for item, now in self._answered()
            if not isinstance(item, Show)
            for tree in trees_of_step(Find((item,)))
        )

    @cached_property
    def _tied(self) -> frozenset[sp.Symbol]:
        """Angles known by a ratio of another angle that the part does not ask for: sin α stays."""
        names = {node.name for node in self.asked if isinstance(node, Letter)}
        for answer in (answer for result in self.solution.items for answer in result.answers):
            pair = isinstance(answer.value, tuple | Vector)
            names |= symbol_names(*(answer.value if pair else (answer.value,)))
        tied = set()
        for symbol, value in self.model.final.items():
            own = atoms_in(value, sp.sin, sp.cos, sp.tan) if isinstance(value, sp.Expr) else ()
            others = symbol_names(*own)
            if self._is_angle(symbol) and others and not names & others:
                tied.add(symbol)
        return frozenset(tied)

    def _is_angle(self, symbol: sp.Symbol) -> bool:
        role = self.model.unknowns.roles.get(symbol.name)
        return role is not None and role.kind == "angle"

    def _answered(self) -> Iterator[tuple[Any, Any]]:
        """The items of the part that have an answer, each with the event at which it is asked."""
        without = {n for n, result in enumerate(self.solution.items) if result.error is not None}
        for n, own in enumerate(self.problem.asked(self.part)):
            if n not in without:
                yield own

    @property
    def events(self) -> int:
        """How many events are told."""
        return len(self.model.story.happenings)

    def frame(self, number: int) -> Frame:
        """The frame of an impact; of directions in letters, with what is known of these."""
        if number not in self.frames:
            if self.find_frame is not None:
                self.frames[number] = self.find_frame(self, number)
            else:
                self.frames[number] = frame_of(self.model, self.facts, number)
        own = self.frames[number]
        if not own.has_letters:
            return own
        state = self.state()
        kept, put = self._turned.get(number, (None, own))
        if kept is own:
            return put
        (n, n_refs), (t, t_refs) = self.put(own.n), self.put(own.t)
        if own.write is not None:
            put = replace(own, n=n, t=t)  # the line is written with what is known
        else:
            put = replace(own, n=n, t=t, sources=together(own.sources, n_refs, t_refs))
        if state == self.state():  # to put values in may write lines
            self._turned[number] = own, put
        return put

    def bodies(self, number: int) -> tuple[str, ...]:
        """The bodies in an event."""
        return self.model.happening(number).bodies

    def spheres(self, number: int) -> tuple[str, ...]:
        """The spheres in an event."""
        return tuple(body for body in self.bodies(number) if body in self.model.story.spheres)

    def last_event(self, body: str, stage: int) -> int:
        """The latest event of a body up to a stage that changed its velocity; 0 without one."""
        latest = self.model.story.latest(body, stage)
        while latest is not None and isinstance(latest.step, Arrival):
            latest = self.model.story.latest(body, latest.number - 1)
        return 0 if latest is None else latest.number

    def value(self, tree: Expression) -> Any:
        """What a tree is worth, in letters: a number, a Vector or an Angle."""
        return self._worth_as("value", tree)

    def vector(self, tree: Expression) -> Vector:
        """What a tree is worth, as a vector; 0 is the one of no length."""
        return self._worth_as("vector", tree)  # type: ignore[no-any-return]

    def scalar(self, tree: Expression) -> sp.Expr:
        """What a tree is worth, as a number; angles in radians."""
        worth = self._worth_as("scalar", tree)
        return expression_of(worth)

    def _worth_as(self, kind: Literal["value", "vector", "scalar"], tree: Expression) -> Any:
        """What a tree is worth as one kind of value; it is kept while letters are the same."""
        self._named_letters()
        values = self._values[kind]
        if tree not in values:
            own = self.model.story.evaluator(self.events)
            values[tree] = getattr(own, kind)(tree)
        return values[tree]

    @property
    def first(self) -> Model:
        """The model by whose signs lines are turned: solutions share it until they part."""
        return self.others[0] if self.others else self.model

    def worth(self, tree: Expression, others: Mapping[str, sp.Symbol] | None = None) -> sp.Expr:
        """What a tree of a line is worth; components, and ``others``, are letters.

        Raises NotPlannedError for a vector.
        """
        if others:
            return self._worth_of(tree, {**self._named_letters(), **others})
        names = self._named_letters()
        worth = self._worths.get(tree)
        if worth is None:
            worth = self._worths[tree] = self._worth_of(tree, names)
        return worth

    def _worth_of(self, tree: Expression, names: Mapping[str, sp.Symbol]) -> sp.Expr:
        letter = self.model.unknowns.letter
        evaluator = Evaluator(
            self.model.story.field, lambda name: names[name] if name in names else letter(name)
        )
        value = evaluator.value(tree)
        if isinstance(value, Vector | tuple):
            raise NotPlannedError("a vector where a number is put in")
        return sp.sympify(value.measure() if isinstance(value, Angle) else value, strict=True)

    def _named_letters(self) -> Mapping[str, sp.Symbol]:
        """The unknowns and the letters of components by name; what rests on fewer is dropped."""
        final = self.model.final
        if self._names is None or self._names[0] != len(final):
            self._worths.clear()
            self._gaps.clear()
            self._values.clear()
            names = {value.name: value for value in final}
            names |= {e.symbol.name: e.symbol for e in self.model.components.values()}
            self._names = len(final), names
        return self._names[1]

    def gap(self, left: Expression, right: Expression) -> sp.Expr:
        """What one side of a line is worth more than the other."""
        one, other = self.worth(left), self.worth(right)
        gap = self._gaps.get((left, right))
        if gap is None:
            gap = self._gaps[left, right] = one - other
        return gap

    def velocity(self, body: str, stage: int) -> Vector:
        """A velocity, in letters."""
        return self.model.story.velocity(body, stage)

    # --- what is unknown ------------------------------------------------------------------------

    def final(self, symbol: sp.Symbol) -> sp.Expr:
        """The value of an unknown in the data, without bars around what has a known sign."""
        value = sp.sympify(self.model.final[symbol], strict=True)
        return value.xreplace(bars_of(value, self.model.oracle)) if value.has(sp.Abs) else value

    def unknown(self, value: Any) -> frozenset[sp.Symbol]:
        """The unknowns in a value that have no value on the desk yet."""
        if isinstance(value, Vector):
            return self.unknown(value.x) | self.unknown(value.y)
        own = expression_of(value)
        if not symbols_in(own):
            return frozenset()
        state = self.state()
        open_ = self._unknown.get(own)
        if open_ is not None:
            return open_
        open_ = self._unknown_in(self.with_values(own)[0])
        if state == self.state():  # to put values in may write lines
            self._unknown[own] = open_
        return open_

    def _unknown_in(self, put: sp.Expr) -> frozenset[sp.Symbol]:
        """The unknowns of an expression in which the rest is put in."""
        open_ = frozenset(filter(self._is_unknown, symbols_in(put)))
        if not open_ or put.is_Symbol:
            return open_
        return open_ & symbols_in(expanded(put))  # some may cancel

    def _is_unknown(self, symbol: sp.Symbol) -> bool:
        return (
            symbol in self.model.final and symbol not in self.free and not self._by_ratios(symbol)
        )

    def state(self) -> tuple[object, ...]:
        """On what it depends what is unknown; what was kept in another state is dropped."""
        state = (
            self.desk.version,
            self.desk.part,
            len(self.model.final),
            frozenset(self.free),
            self.kept,
        )
        if self._at != state:
            self._at = state
            self._put.clear()
            self._unknown.clear()
            self._turned.clear()
        return state

    def _by_ratios(self, symbol: sp.Symbol) -> bool:
        """Whether an angle is known by the ratios that the data give, or as a complement."""
        return self._ratio_fact(symbol) is not None or symbol.name in self.complements

    def put(self, value: Any) -> tuple[Any, tuple[Ref, ...]]:
        """A value with everything put in that stands on the desk, and what that rests on."""
        if isinstance(value, Vector):
            x, y = (self.put(other) for other in value)
            return Vector(x[0], y[0]), together(x[1], y[1])
        own = expression_of(value)
        changed, refs = self.with_values(own)
        return (own, ()) if changed is own else (neat(changed), refs)

    def with_values(self, value: Any) -> tuple[sp.Expr, tuple[Ref, ...]]:
        """The same of a number, as it comes, without a search for its usual form.

        It is the same object where nothing is put in.
        """
        own = expression_of(value)
        if not symbols_in(own):
            return own, ()
        state = self.state()
        put = self._put.get(own)
        if put is None:
            put = self._with_values(own)
            if state == self.state():  # to put them in may write lines
                self._put[own] = put
        return put

    def _with_values(self, own: sp.Expr) -> tuple[sp.Expr, tuple[Ref, ...]]:
        refs: list[Ref] = []
        times: dict[sp.Basic, int] = {}
        own, whole = self._with_components(own)
        refs += whole
        for _ in range(12):
            changes: dict[sp.Basic, sp.Expr] = {}
            ratios, bare = ratios_and_letters(own)
            if times and any(times.get(value, 0) >= _MOST for value in bare):
                raise NotPlannedError("letters that are known by each other")
            for symbol in bare:
                source = (
                    None if self._is_basic(symbol) else self.desk.known(plain_letter(symbol.name))
                )
                if source is not None:
                    changes[symbol] = source.value
                    refs += source.refs
            if changes:
                for change in changes:
                    times[change] = times.get(change, 0) + 1
                own = substituted(own, changes)
                continue
            for ratio in ratios:
                if symbols_in(ratio) & self.kept:
                    continue
                source = self._ratio(ratio) or self._angle(ratio)
                if source is not None:
                    changes[ratio] = source.value
                    refs += source.refs
            if not changes:
                break
            own = substituted(own, changes)
        return own, together(refs)

    def _with_components(self, own: sp.Expr) -> tuple[sp.Expr, Sequence[Ref]]:
        """With the products v cos θ that are known put in whole, where nothing else has v and θ."""
        refs: list[Ref] = []
        for tree, source in self.desk.components():
            component = self.scalar(tree)
            put = own.subs(component, source.value)
            if put != own and not component.free_symbols & put.free_symbols:
                own, refs = put, [*refs, *source.refs]
        return own, refs

    def _is_basic(self, symbol: sp.Basic) -> bool:
        """Whether a part says everything in terms of a letter, whatever other parts find it is."""
        return symbol.name in self.model.unknowns.roles and symbol not in self.model.final

    def _ratio(self, ratio: sp.Expr) -> Source | None:
        """The number that a sine, cosine or tangent is by the data, written down when wanted."""
        (argument,) = ratio.args
        if not argument.is_Symbol:
            return ratio_of_a_multiple(self, ratio)
        if self._is_basic(argument) and self._ratio_fact(argument) is None:
            return None
        tree = Apply(type(ratio).__name__, plain_letter(argument.name))
        known = self.desk.known(tree)
        if known is None and self._ratio_fact(argument) is not None:
            write_ratios(self, argument)
            known = self.desk.known(tree)
        if known is None and argument.name in self.complements:
            write_complement(self, tree, *self.complements[argument.name])
            known = self.desk.known(tree)
        if argument in self._tied:
            return known
        if (known is None and self._by_an_inverse(argument)) or self._is_number_now(known):
            write_other_ratio(self, argument, type(ratio).__name__)
            known = self.desk.known(tree)
        return known

    def _is_number_now(self, known: Source | None) -> bool:
        """Whether the letters in a ratio of an angle all have numbers in this part."""
        if known is None or not symbols_in(known.value):
            return False
        letters_ = [self.desk.known(plain_letter(own.name)) for own in symbols_in(known.value)]
        return all(own is not None and own.value.is_number for own in letters_)

    def _by_an_inverse(self, symbol: sp.Basic) -> bool:
        """Whether an angle is known as the inverse of a ratio only, in letters that are known."""
        known = self.desk.known(plain_letter(symbol.name))
        value = None if known is None else sp.sympify(known.value, strict=True)
        is_inverse = value is not None and atoms_in(value, sp.atan, sp.asin, sp.acos)
        return bool(is_inverse) and not self.unknown(value)

    def _angle(self, ratio: sp.Expr) -> Source | None:
        """A ratio of angles that are known, as numbers or by others."""
        changes = {}
        refs: list[Ref] = []
        for symbol in symbols_in(ratio):
            is_open = self._is_basic(symbol) or symbol in self._tied
            source = None if is_open else self.desk.known(plain_letter(symbol.name))
            if source is not None:
                changes[symbol] = source.value
                refs += source.refs
        return Source(substituted(ratio, changes), tuple(refs)) if changes else None

    def _ratio_fact(self, symbol: sp.Basic) -> Fact | None:
        """The fact that gives a sine, cosine or tangent of an angle as a number."""
        return self.ratio_facts.get(symbol.name)

    @cached_property
    def ratio_facts(self) -> Mapping[str, Fact]:
        """Facts such as tan α = 3/4, by the letter."""
        facts: dict[str, Fact] = {}
        for fact in self.desk.facts:
            if fact.kind != "given" or not self.desk.holds(fact.id):
                continue
            match fact.relation.options:
                case (((Link(Apply(kind, angle), "=", right)),),):
                    name = letter_of_a_ratio(kind, angle)
                    if name and f"let {name}" not in self.facts:
                        facts |= {} if self.scalar(right).free_symbols else {name: fact}
        return facts

    @cached_property
    def complements(self) -> Mapping[str, tuple[Fact, str]]:
        """Facts such as α + β = 90° between letters of the data.

        They stand by the letter that the solution has in terms of the other one.
        """
        facts: dict[str, tuple[Fact, str]] = {}
        for fact in self.desk.facts:
            match fact.relation.options:
                case ((Link(left, "=", right),),) if (
                    fact.kind == "given"
                    and self.desk.holds(fact.id)
                    and not any(map(has_quantity, trees_of(fact.relation)))
                ):
                    gap = expanded(self.scalar(left) - self.scalar(right))
                case _:
                    continue
            for symbol in gap.free_symbols:
                other = expanded(sp.pi / 2 - self.model.final.get(symbol, symbol))
                if (
                    other.is_Symbol
                    and self._is_basic(other)
                    and f"let {symbol.name}" not in self.facts
                    and f"let {other.name}" not in self.facts
                    and gap.subs(symbol, sp.pi / 2 - other) == 0
                ):
                    facts[symbol.name] = fact, other.name
        return facts

    # --- facts ----------------------------------------------------------------------------------

    @cached_property
    def given(self) -> tuple[GivenEquation, ...]:
        """The given equations in force, but for ratios of angles in numbers, and complements."""
        equations: list[GivenEquation] = []
        ratios = {ratio_fact.id for ratio_fact in self.ratio_facts.values()}
        ratios |= {fact.id for fact, _ in self.complements.values()}
        for fact in self.desk.facts:
            if fact.kind != "given" or fact.id in ratios or not self.desk.holds(fact.id):
                continue
            if len(fact.relation.options) > 1 or len(fact.relation.only) > 1:
                continue  # an inequality
            (link,) = fact.relation.only
            residuals = tuple(self._residuals(link))
            if residuals:
                lets = self.lets_in(link)
                own = by_a_multiple(by_its_change(self.opened(link)))
                equations.append(GivenEquation(fact, own, residuals, lets))
        return (*equations, *self.of_offsets)

    def lets_in(self, link: Link) -> tuple[Ref, ...]:
        """The facts that let letters of a link stand for something."""
        names = [letter.name for side in (link.left, link.right) for letter in letter_nodes(side)]
        nodes = [node for side in (link.left, link.right) for node in walk(side)]
        return tuple(
            f"let {name}"
            for name in dict.fromkeys(names)
            if self._stands_for(name, names, names.count(name) == nodes.count(_tangent_of(name)))
        )

    def _stands_for(self, name: str, names: Sequence[str], in_tangents: bool) -> bool:
        """Whether a letter of a fact is replaced: an angle is not, where others are beside it.

        It is where it stands in its tangent alone. A letter of a component after an impact is the
        unknown itself.
        """
        fact = self.facts.get(f"let {name}")
        if fact is None or name in {e.symbol.name for e in self.model.components.values()}:
            return False
        quantity = fact.relation.only[0].left
        angle = isinstance(quantity, Quantity) and quantity.kind in ANGLES
        return not angle or in_tangents or set(names) == {name}

    def opened(self, link: Link) -> Link:
        """A link in which each letter of the statement for something is replaced by that."""
        lets = self.lets_in(link)

        def change(tree: Expression) -> Expression:
            name = f"let {tree.name}" if isinstance(tree, Letter) else ""
            fact = self.facts[name] if name in lets else None
            return tree if fact is None else rebuilt(fact.relation.only[0].left, change)

        left, right = (rebuilt(side, change) for side in (link.left, link.right))
        return Link(left, link.sign, right, link.by)

    def _residuals(self, link: Link) -> Iterable[sp.Expr]:
        story = self.model.story
        if link.sign == "=":
            left, right = self.value(link.left), self.value(link.right)
            for condition in solve_facts.equal(story, left, right, None):
                if isinstance(condition, Equation):
                    yield sp.sympify(condition.value, strict=True)
        elif link.sign in ("perpendicular to", "parallel to"):
            a, b = (story.direction(side, self.events) for side in (link.left, link.right))
            yield a.dot(b) if link.sign == "perpendicular to" else a.cross(b)

    # --- data -----------------------------------------------------------------------------------

    def data(self, name: str) -> Source:
        """A fact of the statement as a value: ``mass A``, ``e 1``."""
        fact = self.facts.get(name)
        if fact is None:
            raise NotPlannedError(f"{name} is not given")
        (link,) = fact.relation.only
        value = self.value(link.right)
        put, refs = self.put(value)
        return Source(put, together((name,), refs))

    def mass(self, body: str) -> Source:
        """The mass of a sphere; a letter of its own, where it is not given."""
        tree = Quantity("mass", (Name(body),))
        given = next((own for own in self.given if is_value_of(own.link, tree)), None)
        data = self.facts.get(f"mass {body}")
        if given is not None and (data is None or isinstance(data.relation.only[0].right, Letter)):
            value, refs = self.put(self.scalar(given.link.right))
            return Source(value, together(given.refs, refs))
        if data is not None:
            return self.data(data.id)
        known = self.desk.known(tree)
        if known is None:
            symbol = sp.sympify(self.model.story.mass(body), strict=True)
            let = self.desk.write(Move("let"), (), Meaning(symbol.name, tree))
            known = self.desk.know(tree, symbol, (let,))
        value, refs = self.put(known.value)
        return Source(value, together(known.refs, refs))

    def coefficient(self, number: int) -> Source:
        """The coefficient of restitution of an event."""
        return self.data(f"e {number}")

    def initial(self, body: str) -> Source:
        """The velocity of a sphere at the start."""
        if f"velocity {body}" not in self.facts:
            return self._sought(body)
        if body not in self._initial:
            self._initial[body] = self._initial_of(body)
        return self._initial[body]

    def _sought(self, body: str) -> Source:
        """A velocity at the start that is to be found: by its line, or in letters."""
        known = self.desk.known(Quantity("velocity", (Name(body),), 0))
        if known is not None:
            return known
        x, y = (self.sought(body, axis) for axis in ("i", "j"))
        return Source(Vector(x.value, y.value), together(x.refs, y.refs))

    def sought(self, body: str, axis: Literal["i", "j"]) -> Source:
        """The letter for a component of a velocity at the start that is to be found, or its line.

        Raises NotPlannedError where the component is no letter.
        """
        velocity = self.velocity(body, 0)
        value = sp.sympify(velocity.x if axis == "i" else velocity.y, strict=True)
        if not value.is_Symbol:
            raise NotPlannedError(f"the velocity of {body} at the start is not given")
        quantity = Quantity("along", (Quantity("velocity", (Name(body),), 0), Unit(axis)))
        known = self.desk.known(quantity)
        if known is not None:
            return known
        line = self.desk.write(Move("let"), (), Meaning(value.name, quantity))
        return Source(value, (line,))

    def _initial_of(self, body: str) -> Source:
        name = f"velocity {body}"
        (link,) = self.facts[name].relation.only
        walls = [
            f"wall {node.name}"
            for node in walk(link.right)
            if isinstance(node, Name) and f"wall {node.name}" in self.facts
        ]
        velocity = self.velocity(body, 0)
        if isinstance(link.right, Polar):
            velocity = self._by_multiple(link.right, velocity)
        return Source(velocity, (name, *walls))

    def _by_multiple(self, polar: Polar, velocity: Vector) -> Vector:
        """Components of a velocity at 2θ, or 180° − 2θ, by the sine and cosine of 2θ, as given."""
        angle, size = (self.scalar(tree) for tree in (polar.angle, polar.size))
        right_angles, multiple = angle.as_independent(*angle.free_symbols, as_Add=True)
        count, letter = multiple.as_coeff_Mul()
        if not letter.is_Symbol or abs(count) == 1 or not (2 * right_angles / sp.pi).is_Integer:
            return velocity
        forms = [sign * size * f(multiple) for f in (sp.cos, sp.sin) for sign in (1, -1)]

        def of(component: sp.Expr) -> sp.Expr:
            for form in forms:
                if self.model.identically_zero(sp.expand_trig(form) - component):
                    return form
            return component

        return Vector(*(of(sp.sympify(component, strict=True)) for component in velocity))

    def tree(self, value: Any) -> Expression:
        """The tree of a value."""
        return tree_of(value)


def _tangent_of(name: str) -> Expression:
    return Apply("tan", Letter(name))
