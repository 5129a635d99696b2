"""Inequalities: conditions in components, solved, and joined with what holds anyway."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any, Self

import sympy as sp

from restitution.components import proved_sign
from restitution.exact import tidy
from restitution.explaining.derivation import Fact, Link, Meaning, Move, Ref, Relation, Sign
from restitution.explaining.trees import of_relation, rebuilt
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    Unit,
    children,
    has_quantity,
    letters,
    walk,
)
from restitution.planning.desk import Mark, NotPlannedError, Source, together
from restitution.planning.forms import ZERO, square, swept, tree_of
from restitution.planning.frames import Frame
from restitution.planning.givens import write_given
from restitution.planning.impacts import in_direction, residual, scene_value
from restitution.planning.judging import Judge
from restitution.planning.order import Solver
from restitution.planning.quantities import Formula, body_and_stage, formula, frame_after
from restitution.planning.scene import GivenEquation, Scene
from restitution.planning.tangents import cosine_of_deflection, tangent_of_deflection
from restitution.solve.letters import roles
from restitution.vector import Vector

FLIPPED: dict[str, Sign] = {"<": ">", "<=": ">=", ">": "<", ">=": "<="}
_ANGLES = {
    "deflection": ("delta", "phi", "psi", "theta"),
    "angle": ("beta", "theta", "phi", "psi"),
    "direction": ("theta", "phi", "beta", "psi"),
}
# The moves by which a letter takes the place of what it stands for.
_NAMED = (Move("put"), Move("rearrange"), Move("compare"))
_BOUNDED = ("<", "<=", ">", ">=")


@dataclass
class Claims:
    """What a part says of its letters: equations that tie them, and conditions on them."""

    scene: Scene
    solver: Solver
    judge: Judge = field(init=False)
    _ties: list[int] | None = None
    _conditions: list[int] | None = None

    def __post_init__(self) -> None:
        self.judge = self.scene.judge

    def __enter__(self) -> Self:
        self.scene.free |= self._tied_letters()
        return self

    def __exit__(self, *_: object) -> None:
        self.scene.free.clear()

    def _tied_letters(self) -> set[sp.Symbol]:
        """The letters of the statement that the facts tie to others."""
        model = self.scene.model
        components = {each.symbol for each in model.components.values()}
        return {
            symbol
            for symbol, value in model.final.items()
            if symbol not in components
            and symbol.name in model.unknowns.roles
            and sp.sympify(value, strict=True).free_symbols
        }

    # --- trials ---------------------------------------------------------------------------------

    def mark(self) -> tuple[Mark, frozenset[str]]:
        """What stands, and which equations are used."""
        return self.scene.desk.mark(), frozenset(self.solver.used)

    def back(self, mark: tuple[Mark, frozenset[str]]) -> None:
        """Takes away what was written since a mark."""
        desk, used = mark
        self.scene.desk.back(desk)
        self.solver.used.clear()
        self.solver.used |= used

    # --- trees ----------------------------------------------------------------------------------

    def exists(self, ref: Ref) -> bool:
        """Whether a fact is given."""
        return isinstance(ref, int) or ref in self.scene.facts

    def opened(self, tree: Expression) -> Expression:
        """A tree with each letter for a quantity replaced by the quantity."""

        def change(each: Expression) -> Expression:
            if isinstance(each, Letter):
                fact = self.scene.facts.get(f"let {each.name}")
                if fact is not None and has_quantity(fact.relation.only[0].left):
                    return self.opened(fact.relation.only[0].left)
            return each

        return rebuilt(tree, change)

    def named(self, own: Formula, quantity: Expression) -> tuple[Expression, tuple[Ref, ...]]:
        """The left side of a definition, with the letter that the statement has for it."""
        for fact in self.scene.desk.facts:
            if fact.id.startswith("let ") and fact.relation.only[0].left == quantity:
                return own.of(fact.relation.only[0].right), (fact.id,)
        return own.left, ()

    def lettered(self, line: int, angle: Expression) -> tuple[int, Expression, tuple[Ref, ...]]:
        """The tangent of an angle by a letter for it: the line, the letter, and its range."""
        desk = self.scene.desk
        if not isinstance(angle, Quantity):
            return line, angle, ()
        name, let = self._letter_for(angle)
        high = 90 if angle.kind == "angle" and not isinstance(angle.arguments[1], Unit) else 180
        tangent = Apply("tan", Letter(name))
        relation = Relation(((Link(tangent, "=", desk.last_link(line).right),),))
        number = self.judge.write(_NAMED, [line, let], relation)
        if number is None:
            raise NotPlannedError("a letter for an angle")
        return number, Letter(name), (f"0° <= {name} <= {high}°", let)

    def axes(self, tree: Expression) -> tuple[Ref, ...]:
        """The lines of centres of the impacts in which a quantity is known."""
        refs: list[Ref] = []
        for each in walk(tree):
            match each:
                case Quantity("velocity" | "speed" | "energy", (Name(),), int()):
                    velocity = replace(each, kind="velocity")
                    body, stage = body_and_stage(self.scene, velocity)
                    refs += frame_after(self.scene, body, stage).refs
        return together(refs)

    # --- quantities -----------------------------------------------------------------------------

    def determine(self, tree: Expression) -> None:
        """Writes the lines by which all components in a tree are known."""
        value = self.scene.value(tree)
        parts: Iterable[Any] = value if isinstance(value, Vector) else (value,)
        if hasattr(value, "measure"):
            parts = (value.y / value.x,)
        self.solver.determine([sp.sympify(each, strict=True) for each in parts])

    def component(self, kind: str, body: str, stage: int, frame: Frame) -> Source:
        """A component, with what it rests on."""
        return in_direction(self.scene, kind, body, stage, frame)

    def is_data(self, quantity: Quantity) -> bool:
        """Whether a quantity is a velocity of the data."""
        return quantity.kind == "velocity" and quantity.stage == 0

    def data_of(self, quantity: Quantity) -> tuple[Ref, ...]:
        """The facts that give a velocity."""
        (body,) = quantity.arguments
        assert isinstance(body, Name)
        return self.scene.initial(body.name).refs

    def formula(self, quantity: Quantity) -> Formula:
        """The definition of a quantity, with the components in it known."""
        if quantity.kind == "deflection" and isinstance(quantity.stage, int):
            (body,) = quantity.arguments
            stages = (quantity.stage - 1, quantity.stage)
            for stage in stages:
                self.determine(Quantity("velocity", (body,), stage))
            return tangent_of_deflection(self.scene, quantity)
        self.determine(quantity)
        return formula(self.scene, quantity)

    def quantity(self, quantity: Quantity) -> int:
        """Writes what a quantity is worth, and returns the number of the line."""
        scene = self.scene
        known = scene.desk.known(quantity)
        if known is not None and len(known.refs) == 1 and isinstance(known.refs[0], int):
            return known.refs[0]
        own = self.formula(quantity)
        left, extra = self.named(own, quantity)
        right, final = swept(own.right), tree_of(own.value)
        match right:
            case Apply("sqrt", Binary("^", base, _)) if base == final:
                right = final
        links = [Link(left, "=", right)]
        chains = [Relation((tuple(links),))]
        if right != final:
            for by in ("rearrange", "identity"):
                chains.insert(-1, Relation(((*links, Link(right, "=", final, by)),)))
        known_ = self.judge.known(letters(right))
        plain = together(own.refs, extra)
        wider = together(own.refs, extra, self.axes(quantity))
        pools = (plain, (*plain, *known_), wider, (*wider, *known_))
        for relation in chains:
            for pool in dict.fromkeys(pools):
                number_ = self.judge.write((own.move,), pool, relation, plain)
                if number_ is not None:
                    if own.left == quantity:
                        scene.desk.know(quantity, own.value, (number_,))
                    return number_
        raise NotPlannedError(f"a line for {quantity.kind}")

    def worth(self, tree: Expression) -> int | None:
        """The line that says what an expression of quantities is worth; None without one."""
        match tree:
            case Quantity():
                return self.quantity(tree)
            case Apply("tan", Quantity("angle" | "deflection" | "direction") as angle):
                return self.quantity(angle)
            case Binary("^", Quantity("speed") as speed, Number(Fraction(numerator=2))):
                return self.squared(speed)
            case Binary("/", above, below) if has_quantity(above) and has_quantity(below):
                pair = [self.worth(above), self.worth(below)]
                if None in pair:
                    return None
                return self._valued(tree, Move("divide"), pair)  # type: ignore[arg-type]
            case Binary("/", above, below) if has_quantity(above):
                line = self.worth(above)
                return None if line is None else self._valued(tree, Move("rearrange"), [line])
        return None

    def _valued(self, tree: Expression, move: Move, refs: Sequence[int]) -> int | None:
        """An expression and its value, by a move from the lines of its quantities."""
        value = tidy(sp.sympify(self.scene.put(self.scene.scalar(tree))[0], strict=True))
        names = {s.name for s in value.free_symbols} & set(roles(self.scene.problem))
        relation = Relation(((Link(tree, "=", tree_of(value)),),))
        line = self.judge.write((move,), [*refs, *self.judge.known(names)], relation)
        if line is not None:
            return line
        values = [self.scene.desk.last_link(each).right for each in refs]
        if move.id != "divide":
            return None
        middle = Relation(((Link(tree, "=", Binary("/", *values)),),))
        line = self.judge.write((move,), refs, middle)
        if line is None:
            return None
        moves = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))
        return self.judge.write(moves, [line, *self.judge.known(names)], relation)

    def squared(self, speed: Quantity) -> int | None:
        """The square of a speed, without its root."""
        self.determine(speed)
        own = formula(self.scene, speed)
        right = swept(own.right)
        if not isinstance(right, Apply):
            return None
        left = square(own.left)
        pool = own.refs
        final = tree_of(tidy(own.value**2))
        first = Link(left, "=", right.argument)
        known = self.judge.known(letters(right))
        for by in ("rearrange", "identity"):
            relation = Relation(((first, Link(right.argument, "=", final, by)),))
            line = self.judge.write((own.move,), [*pool, *known], relation, pool)
            if line is not None:
                return line
        return self.judge.write((own.move,), pool, Relation(((first,),)), pool)

    # --- ties -----------------------------------------------------------------------------------

    def ties(self) -> list[int]:
        """The equations between letters that the facts give, as lines."""
        if self._ties is None:
            self._ties = list(self._written_ties())
        return self._ties

    def _written_ties(self) -> Iterator[int]:
        scene = self.scene
        known = [scene.desk.known(Letter(each.name)) for each in self._linked()]
        lines = [ref for own in known if own for ref in own.refs if isinstance(ref, int)]
        if lines:
            yield from dict.fromkeys(self._without_roots(each) for each in lines)
            return
        none = True
        for each in scene.given:
            line = self._trial(lambda each=each: self._tie(each))  # type: ignore[misc]
            if line is not None:
                none = False
                yield line
        if none:
            for symbol in self._linked():
                line = self._trial(lambda symbol=symbol: self._closed(symbol))  # type: ignore[misc]
                if line is not None:
                    yield line

    def _without_roots(self, line: int) -> int:
        """An equation, or the one above it of which it gives a root."""
        desk = self.scene.desk
        number = line
        while _has_root(desk.relation(number)):
            above = [
                ref
                for ref in desk.line(number).premises
                if isinstance(ref, int) and isinstance(desk.line(ref).relation, Relation)
            ]
            if not above:
                return line
            number = above[0]
        own = desk.relation(number)
        said = {n for e in own.options[0] for side in (e.left, e.right) for n in letters(side)}
        known = set(roles(self.scene.problem))
        plain = len(own.options) == 1 and said <= known and not has_quantity_in(own)
        if not plain or number == line:
            return line
        return self._neat(number)

    def _linked(self) -> list[sp.Symbol]:
        return sorted(self.scene.free, key=lambda each: each.name)

    def _trial(self, attempt: Callable[[], int | None]) -> int | None:
        """What an attempt writes; nothing stays of one that leads nowhere."""
        mark = self.mark()
        try:
            line = attempt()
        except NotPlannedError:
            line = None
        if line is None:
            self.back(mark)
        return line

    def _tie(self, each: GivenEquation) -> int | None:
        """A given fact as an equation between letters of the statement."""
        scene = self.scene
        components = {own.symbol for own in scene.model.components.values()}
        inside = {s for x in each.residuals for s in sp.sympify(x, strict=True).free_symbols}
        written = self._standing(scene.ties.get(each.fact.id))
        if written is not None:
            return written
        if each.fact.id in self.solver.used:
            return None
        self.solver.used.add(each.fact.id)
        self.solver.determine(sorted(inside & components, key=str))
        self.solver.used.discard(each.fact.id)
        open_ = [scene.put(x)[0] for x in each.residuals]
        if all(x == 0 for x in open_):
            return None
        line = self._neat(write_given(scene, _as_right_angle(each)))
        scene.ties[each.fact.id] = scene.desk.relation(line)
        return line

    def _standing(self, relation: Relation | None) -> int | None:
        """The line that says a relation, if it stands."""
        return next(
            (each.number for each in self.scene.desk.lines if each.relation == relation), None
        )

    def _closed(self, symbol: sp.Symbol) -> int | None:
        """The line that says what a letter is by others."""
        scene = self.scene
        scene.free.discard(symbol)
        try:
            self.solver.determine([symbol])
        finally:
            scene.free.add(symbol)
        known = scene.desk.known(Letter(symbol.name))
        lines = () if known is None else known.refs
        return next((each for each in lines if isinstance(each, int)), None)

    def _neat(self, line: int) -> int:
        """The equation without common factors, where it stands as one that is zero."""
        scene = self.scene
        whole = sp.factor(sp.together(residual(scene, line)))
        above = sp.fraction(whole)[0]
        kept = sp.Mul(*(x for x in sp.Mul.make_args(above) if not self._certain(x)))
        symbols = [s for s in kept.free_symbols if s.name in roles(scene.problem)]
        for symbol in sorted(symbols, key=self._rank):
            form = self.isolated(kept, symbol)
            if form is None:
                continue
            generator, value = form
            relation = Relation(((Link(generator, "=", tree_of(value)),),))
            if scene.desk.relation(line) == relation:
                return line
            pool = [line, *self.judge.known(s.name for s in whole.free_symbols)]
            moves = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))
            neat = self.judge.write(moves, pool, relation)
            if neat is not None:
                return neat
        return line

    def _rank(self, symbol: sp.Symbol) -> tuple[int, str]:
        kind = roles(self.scene.problem)[symbol.name].kind
        return ({"angle": 0, "positive": 1, "restitution": 2}.get(kind, 3), symbol.name)

    def _certain(self, x: sp.Expr) -> int | None:
        """The sign of a factor, where the letters alone make it certain; None where it is open."""
        sign = proved_sign(self.scene.model.ground, x)
        return sign or None

    # --- one letter -----------------------------------------------------------------------------

    def isolated(self, x: sp.Expr, symbol: sp.Symbol) -> tuple[Expression, sp.Expr] | None:
        """Of ``x = 0``: a letter, a ratio of it or a square of one, and what it is equal to."""
        form = linear_in(x, symbol, roles(self.scene.problem)[symbol.name].kind == "angle")
        if form is None:
            return None
        tree, _, a, b = form
        return tree, tidy(sp.factor(-b / a))

    def subject(self, line: int, letter: str) -> int | None:
        """An equation with a letter as its subject; None where it is not linear in it."""
        link = self.scene.desk.last_link(line)
        if link.left == Letter(letter):
            return line
        x = sp.fraction(sp.together(self._value(link.left) - self._value(link.right)))[0]
        symbol = roles(self.scene.problem)[letter].symbol(letter)
        form = self.isolated(sp.expand(x), symbol)
        if form is None or form[0] != Letter(letter):
            return None
        relation = Relation(((Link(form[0], "=", tree_of(form[1])),),))
        pool = [line, *self._known_in(x)]
        return self.judge.write((Move("rearrange"), Move("cancel")), pool, relation)

    def derived(self, line: int, gone: sp.Symbol) -> list[tuple[Sign, sp.Expr, Sign]]:
        """What the range of one letter says of the others in an equation: ``P sign 0``."""
        link = self.scene.desk.last_link(line)
        x = sp.fraction(sp.together(self._value(link.left) - self._value(link.right)))[0]
        role = roles(self.scene.problem)[gone.name]
        form = linear_in(sp.expand(x), gone, role.kind == "angle")
        if form is None:
            return []
        _, generator, a, b = form
        found: list[tuple[Sign, sp.Expr, Sign]] = []
        for sign, bound in _bounds(role, generator, gone):
            gap = sp.factor(sp.together(-b / a - bound))
            own = self.stripped(gap, sign)
            if own is not None and own[1].free_symbols:
                found.append((*own, sign))
        return found

    def bounded(self, line: int, gone: sp.Symbol, sign: Sign) -> Link | None:
        """An equation of which one side only holds a letter, with its bound put in there."""
        link = self.scene.desk.last_link(line)
        sides = [(link.left, link.right), (link.right, link.left)]
        for kept, other in sides:
            x = self._value(other)
            if gone.name in letters(kept) or gone not in x.free_symbols or not letters(kept):
                continue
            role = roles(self.scene.problem)[gone.name]
            above, below = sp.fraction(sp.together(x))
            form = linear_in(sp.expand(above), gone, role.kind == "angle")
            if form is None or gone in below.free_symbols:
                return None
            _, generator, a, b = form
            slope = self._certain(a / below)
            ends = [bound for own, bound in _bounds(role, generator, gone) if own == sign]
            if slope is None or not ends:
                return None
            value = tidy(sp.factor((a * ends[0] + b) / below))
            return Link(kept, sign if slope > 0 else FLIPPED[sign], tree_of(value))
        return None

    def stripped(self, gap: sp.Expr, sign: Sign) -> tuple[Sign, sp.Expr] | None:
        """``gap sign 0`` without the factors whose signs are certain; None if nothing is left."""
        above, below = sp.fraction(sp.factor(sp.together(gap)))
        kept: list[sp.Expr] = []
        turned = False
        for each in (*sp.Mul.make_args(above), *sp.Mul.make_args(below)):
            base, power = each.as_base_exp()
            if power.is_Integer and power % 2 == 0 and each in sp.Mul.make_args(below):
                continue
            own = self._certain(each)
            if own is None:
                if each in sp.Mul.make_args(below):
                    return None
                kept.append(base if power.is_Integer and power % 2 else each)
            elif own < 0:
                turned = not turned
        if not kept:
            return None
        if len(kept) > 1:
            return (FLIPPED[sign] if turned else sign), sp.Mul(*kept)
        # The sense of the inequality is kept, and the terms take the sign.
        return sign, sp.expand(-kept[0] if turned else kept[0])

    def _value(self, tree: Expression) -> sp.Expr:
        return scene_value(self.scene, tree)

    def value_of(self, tree: Expression) -> sp.Expr:
        """What a tree of a line is worth, in letters."""
        return self._value(tree)

    def solved(self, sign: Sign, x: sp.Expr, wanted: Expression | None = None) -> Link | None:
        """``P sign 0`` solved for the letter or the ratio in it, where it is linear in one."""
        symbols = sorted(x.free_symbols, key=lambda s: s.name)
        names = None if wanted is None else letters(wanted)
        for symbol in symbols:
            if names is not None and symbol.name not in names:
                continue
            if names is None and len(symbols) > 1:
                continue
            role = roles(self.scene.problem).get(symbol.name)
            if role is None:
                continue
            form = linear_in(x, symbol, role.kind == "angle")
            if form is None:
                continue
            tree, _, a, b = form
            slope = self._certain(a)
            if slope is None:
                continue
            own = sign if slope > 0 else FLIPPED[sign]
            return Link(tree, own, tree_of(tidy(sp.factor(-b / a))))
        return None

    # --- conditions -----------------------------------------------------------------------------

    def conditions(self, wanted: Expression | None = None) -> list[int]:
        """The given inequalities, in letters and solved as far as one line does it."""
        if self._conditions is None:
            self._conditions = [
                line
                for fact in self._inequalities()
                for line in (self._condition(fact, wanted),)
                if line is not None
            ]
        return self._conditions

    def _inequalities(self) -> Iterator[Fact]:
        desk = self.scene.desk
        for fact in desk.facts:
            if fact.kind not in ("given", "range") or not desk.holds(fact.id):
                continue
            (link, *_) = fact.relation.only
            if link.sign in _BOUNDED and has_quantity_in(fact.relation):
                yield fact

    def _condition(self, fact: Fact, wanted: Expression | None) -> int | None:
        (link,) = fact.relation.only
        match self.opened(link.left), link.right:
            case Quantity("deflection", _, int()) as angle, Degrees(value) if value == 90:
                return self._obtuse(fact, link, angle, wanted)
        gap = self.gap(link)
        own = self.stripped(gap, link.sign)
        if own is None:
            return None
        sign, x = own
        pool = [fact.id, *self.sources(link), *self._known_in(gap)]
        relation = Relation(((Link(tree_of(x), sign, ZERO),),))
        if x.has(sp.sin) and x.has(sp.cos):
            solved = self.solved(sign, x, wanted) or self.solved(sign, x)
            relation = relation if solved is None else Relation(((solved,),))
        line = self._by_steps(link, fact.id, pool, relation, x, sign)
        if line is None:
            return None
        return self.finished(line, sign, x, wanted)

    def _obtuse(
        self, fact: Fact, link: Link, angle: Quantity, wanted: Expression | None
    ) -> int | None:
        """A deflection of more than 90°, or of less, by the sign of its cosine."""
        (body,) = angle.arguments
        assert isinstance(angle.stage, int)
        for stage in (angle.stage - 1, angle.stage):
            self.determine(Quantity("velocity", (body,), stage))
        own = cosine_of_deflection(self.scene, angle)
        line = self.judge.write(
            (own.move,), own.refs, Relation(((Link(own.left, "=", swept(own.right)),),)), own.refs
        )
        stripped = self.stripped(sp.expand(own.value), FLIPPED[link.sign])
        if line is None or stripped is None:
            return None
        sign, x = stripped
        name, let = self._letter_for(angle)
        pool: list[Ref] = [fact.id, line, f"0° <= {name} <= 180°", let]
        assert isinstance(own.right, Binary)
        known = self._known_in(sp.expand(own.value))
        first = Relation(((Link(swept(own.right.left), FLIPPED[link.sign], ZERO),),))
        number = self.judge.write((Move("compare"),), [*pool, *known], first)
        if number is None:
            return None
        solved = self.solved(sign, x, wanted) or self.solved(sign, x)
        after = self.judge.write(
            (Move("rearrange"), Move("cancel"), Move("compare")),
            [number, *known],
            Relation(((solved or Link(tree_of(x), sign, ZERO),),)),
        )
        return number if after is None else after

    def _letter_for(self, angle: Quantity) -> tuple[str, int]:
        """The letter that stands for an angle of the motion, and the line that introduces it."""
        desk = self.scene.desk
        taken = set(roles(self.scene.problem))
        for each in desk.lines:
            if isinstance(each.relation, Meaning):
                if each.relation.quantity == angle:
                    return each.relation.letter, each.number
                taken.add(each.relation.letter)
        name = next(each for each in _ANGLES[angle.kind] if each not in taken)
        return name, desk.write(Move("let"), (), Meaning(name, angle))

    def _known_in(self, x: sp.Expr) -> tuple[Ref, ...]:
        names = {s.name for s in x.free_symbols}
        return self.judge.known(names & set(roles(self.scene.problem)))

    def gap(self, link: Link) -> sp.Expr:
        """Left minus right of an inequality of quantities, in letters; of sizes, their squares."""
        for side in (link.left, link.right):
            if has_quantity(side):
                self.determine(side)
        left, right = (
            sp.sympify(self.scene.put(self.scene.scalar(side))[0], strict=True)
            for side in (link.left, link.right)
        )
        if left.atoms(sp.Pow) | right.atoms(sp.Pow) and any(
            p.exp == sp.Rational(1, 2) and p.base.free_symbols
            for p in left.atoms(sp.Pow) | right.atoms(sp.Pow)
        ):
            return sp.expand(left**2 - right**2)
        return sp.expand(left - right)

    def sources(self, link: Link) -> tuple[Ref, ...]:
        """The lines of the components and the quantities in an inequality."""
        refs: list[Ref] = []
        for side in (link.left, link.right):
            for each in walk(side):
                match each:
                    case Quantity("along" | "across" | "dot"):
                        for velocity in each.arguments:
                            refs += self._components_of(velocity)
                            refs += self._axis_named(velocity)
                        refs += self.axes(each)
                    case Quantity("velocity"):
                        continue
                    case Quantity(kind) if kind not in ("mass", "line_of_centres"):
                        refs.append(self.quantity(each))
        return together(refs)

    def _axis_named(self, tree: Expression) -> tuple[Ref, ...]:
        """The fact that gives the line of centres by which a component is named."""
        match tree:
            case Quantity("line_of_centres", (), int(event)):
                return tuple(r for r in (f"axis {event}",) if self.exists(r))
        return ()

    def _components_of(self, tree: Expression) -> list[Ref]:
        refs: list[Ref] = []
        for each in walk(tree):
            match each:
                case Quantity("velocity", (Name(),), int()):
                    body, stage = body_and_stage(self.scene, each)
                    frame = frame_after(self.scene, body, stage)
                    for kind in ("along", "across"):
                        refs += self._with_letter(kind, body, stage, frame)
        return refs

    def _with_letter(self, kind: str, body: str, stage: int, frame: Frame) -> list[Ref]:
        desk = self.scene.desk
        direct = desk.known(frame.component(kind, body, stage))
        mark = self.mark()
        source = self.component(kind, body, stage, frame)
        if len(desk.lines) > mark[0].lines and kind == "across":
            self.back(mark)
            return []
        return [*(direct.whole if direct else ()), *source.whole]

    def _by_steps(
        self,
        link: Link,
        fact: Ref,
        pool: Sequence[Ref],
        relation: Relation,
        x: sp.Expr,
        sign: Sign,
    ) -> int | None:
        """A condition with values put in: at once where it is short, else in two lines."""
        put = (Move("put"),)
        if not _is_zero(link.right):
            values = [
                sp.sympify(self.scene.put(self.scene.scalar(side))[0], strict=True)
                for side in (link.left, link.right)
            ]
            trees = [tree_of(each) for each in values]
            first = Relation(((Link(trees[0], link.sign, trees[1]),),))
            if first != relation:
                line = self.judge.write(put, pool, first)
                if line is not None:
                    solved = self.solved(sign, x)
                    for each in (solved, relation.only[0]):
                        if each is None:
                            continue
                        known = self._known_in(x)
                        after = self.judge.write(
                            (
                                Move("rearrange"),
                                Move("cancel"),
                                Move("identity", "pythagoras"),
                                Move("compare"),
                            ),
                            [line, *known],
                            Relation(((each,),)),
                        )
                        if after is not None:
                            return after
        line = self.judge.write(put, pool, relation)
        if line is not None:
            return line
        return self.judge.write((Move("compare"),), pool, relation)

    def _is_monic(self, x: sp.Expr) -> bool:
        """Whether a condition is solved by moving a term to the other side."""
        if len(x.free_symbols) != 1:
            return False
        (symbol,) = x.free_symbols
        role = roles(self.scene.problem).get(symbol.name)
        form = linear_in(x, symbol, role is not None and role.kind == "angle")
        return form is not None and abs(form[2]) == 1

    def finished(self, line: int, sign: Sign, x: sp.Expr, wanted: Expression | None) -> int:
        """A condition solved for its letter by one more line, where it is linear in it."""
        solved = self.solved(sign, x, wanted)
        if solved is None:
            return line
        relation = Relation(((solved,),))
        if relation == self.scene.desk.relation(line):
            return line
        after = self.judge.write((Move("rearrange"),), [line, *self._known_in(x)], relation)
        return line if after is None else after

    # --- claims ---------------------------------------------------------------------------------

    def write(self, relation: Relation) -> int:
        """Writes the lines of an inequality that holds; the last says it."""
        trees = [side for link in relation.only for side in (link.left, link.right)]
        quantities = list(
            dict.fromkeys(q for tree in trees for q in self.quantities(self.opened(tree)))
        )
        lets = [
            fact.id
            for tree in trees
            for name in sorted(letters(tree))
            for fact in (self.scene.facts.get(f"let {name}"),)
            if fact is not None
        ]
        lines = self._worths(trees, quantities)
        facts = [ref for each in quantities if self.is_data(each) for ref in self.data_of(each)]
        target = {name for tree in trees for name in letters(tree)}
        base = [*lines, *facts, *lets]
        if base:
            for each in lines:
                line = self.monotone(each, relation)
                if line is not None:
                    return line
            line = self._compared(base, relation)
            if line is not None:
                return line
            line = self._by_tangents(base, lines, relation)
            if line is not None:
                return line
            line = self._by_stages(lines, relation)
            if line is not None:
                return line
            line = self._by_squares(quantities, relation)
            if line is not None:
                return line
        mark = self.mark()
        for attempt in self._attempts(target, relation):
            line = attempt(base, relation)
            if line is not None:
                return line
            self.back(mark)
            self._ties = self._conditions = None
        raise NotPlannedError("an inequality")

    def _worths(self, trees: Sequence[Expression], quantities: Sequence[Quantity]) -> list[int]:
        """The lines of what stands in a claim: of its sides, or of the quantities in them."""
        lines: list[int] = []
        left = [each for each in quantities if not self.is_data(each)]
        for tree in trees:
            opened = self.opened(tree)
            inside = list(self.quantities(opened))
            if not inside or not all(each in left for each in inside):
                continue
            mark = self.mark()
            line = self.worth(opened)
            if line is None:
                self.back(mark)
                continue
            lines.append(line)
            left = [each for each in left if each not in inside]
        return [*dict.fromkeys(lines), *(self.quantity(each) for each in left)]

    def _by_tangents(
        self, base: Sequence[Ref], lines: Sequence[int], relation: Relation
    ) -> int | None:
        """Angles compared by their tangents, which grow with them."""
        if len(lines) != 1:
            return None
        match self.scene.desk.last_link(lines[0]).left:
            case Apply("tan", angle):
                pass
            case _:
                return None
        mark = self.mark()
        quantity, number = angle, lines[0]
        number, angle, extent = self.lettered(number, angle)
        tangent = Apply("tan", angle)
        asked = relation
        relation = of_relation(relation, lambda each: angle if each == quantity else each)
        lines = [number]
        links: list[Link] = []
        for link in relation.only:
            sides = [
                tangent if side == angle else self._tangent_of(side)
                for side in (link.left, link.right)
            ]
            if None not in sides:
                links.append(Link(sides[0], link.sign, sides[1]))  # type: ignore[arg-type]
        if not links or len(links) < len(relation.only) - 1:
            self.back(mark)
            return None
        found = self._by_ends(links, number, extent, relation, base)
        if found is not None and asked != relation:
            found = self.judge.write(_NAMED, [found, extent[-1]], asked)
        if found is None:
            self.back(mark)
        return found

    def _by_ends(
        self,
        links: Sequence[Link],
        tangent: int,
        extent: Sequence[Ref],
        relation: Relation,
        base: Sequence[Ref],
    ) -> int | None:
        """Bounds of an angle by those of its tangent, one after the other."""
        if len(links) == 1:
            own = Relation((tuple(links),))
            line = self.monotone(tangent, own) or self._compared([tangent], own)
            return None if line is None else self.angle_of(line, tangent, extent, relation, base)
        ends: list[Ref] = []
        for link, asked in zip(links, relation.only, strict=False):
            line = self._compared([tangent], Relation(((link,),)))
            if line is None:
                return None
            end = self.angle_of(line, tangent, extent, Relation(((asked,),)), base)
            if end is None:
                return None
            ends.append(end)
        return self._compared(ends, relation)

    def angle_of(
        self,
        line: int,
        tangent: int,
        extent: Sequence[Ref],
        relation: Relation,
        base: Sequence[Ref] = (),
        support: Sequence[Ref] = (),
    ) -> int | None:
        """An angle compared by bounds of its tangent, of which another line tells the sign."""
        rest = [each for each in base if isinstance(each, str)]
        ranges = [each for each in extent if isinstance(each, str)]
        found = self._compared([line, *rest, *ranges], relation)
        if found is not None:
            return found
        own = self.scene.desk.last_link(tangent)
        bounded = Relation(((Link(own.left, ">", ZERO),),))
        positive = self._compared([tangent], bounded)
        if positive is None and support:
            positive = self._compared(support, bounded)
        if positive is None:
            return None
        return self._compared([line, positive, *rest, *ranges], relation)

    def _tangent_of(self, tree: Expression) -> Expression | None:
        value = sp.sympify(self.scene.scalar(tree), strict=True)
        if value.free_symbols:
            return Apply("tan", tree)
        there = tidy(sp.tan(value))
        return None if there.has(sp.zoo) else tree_of(there)

    def _by_stages(self, lines: Sequence[int], relation: Relation) -> int | None:
        """One end at a time, and one letter at a time: at its end first, then the others."""
        if len(lines) != 1:
            return None
        mark = self.mark()
        written: list[int] = []
        for link in relation.only:
            own = Relation(((link,),))
            line = self._compared(lines, own)
            if line is None:
                line = self._staged(lines[0], own)
            if line is None:
                self.back(mark)
                return None
            written.append(line)
        if len(written) == 1:
            return written[0]
        line = self._compared(written, relation)
        if line is None:
            self.back(mark)
        return line

    def _staged(self, line: int, relation: Relation) -> int | None:
        """A bound by a bound of what a line gives, with the end of one letter put in."""
        whole = self.scene.desk.last_link(line)
        value = self._value(whole.right)
        (link,) = relation.only
        turned = not has_quantity(link.left)
        sign = FLIPPED[link.sign] if turned else link.sign
        for symbol in sorted(value.free_symbols, key=lambda s: s.name):
            role = roles(self.scene.problem).get(symbol.name)
            if role is None or role.kind == "positive":
                continue
            for end in (role.low, role.high):
                if end is None:
                    continue
                there = value.subs(symbol, end)
                if there.has(sp.zoo, sp.oo, sp.nan):
                    continue
                weak: Sign = ">=" if sign[0] == ">" else "<="
                own = Relation(((Link(whole.left, weak, tree_of(tidy(there))),),))
                mark = self.mark()
                pool = [line, *self.judge.known([symbol.name])]
                first = self.judge.write((Move("monotone"), Move("sign")), pool, own)
                if first is None:
                    continue
                found = self._compared([first], relation)
                if found is not None:
                    return found
                self.back(mark)
        return None

    def _by_squares(self, quantities: Sequence[Quantity], relation: Relation) -> int | None:
        """A speed compared by its square."""
        if not all(each.kind == "speed" for each in quantities):
            return None
        mark = self.mark()
        lines = [self.squared(each) for each in quantities]
        if None not in lines:
            line = self._compared(lines, relation)  # type: ignore[arg-type]
            if line is None:
                line = self._by_stages(lines, relation)  # type: ignore[arg-type]
            if line is not None:
                return line
        self.back(mark)
        return None

    def _attempts(
        self, target: set[str], relation: Relation
    ) -> Iterator[Callable[[list[Ref], Relation], int | None]]:
        wanted = subject_of(relation)

        def by_conditions(base: list[Ref], relation: Relation) -> int | None:
            return self._compared([*base, *self.conditions(wanted)], relation, base)

        def by_ties(base: list[Ref], relation: Relation) -> int | None:
            for line in self.ties():
                found = self.monotone(line, relation)
                if found is not None:
                    return found
            for line in self.ties():
                found = self._eliminated(line, base, relation, target)
                if found is not None:
                    return found
            return None

        def by_all(base: list[Ref], relation: Relation) -> int | None:
            return self._compared([*base, *self.ties(), *self.conditions(wanted)], relation)

        yield by_conditions
        yield by_ties
        yield by_all

    def monotone(self, line: int, relation: Relation) -> int | None:
        """The ends of what only grows, or only falls, with the one letter that has a range."""
        if len(relation.only) != 2:
            return None
        for name in sorted(letters(self.scene.desk.last_link(line).right)):
            role = roles(self.scene.problem).get(name)
            if role is None or role.kind == "positive":
                continue
            pool = [line, *self.judge.known([name])]
            number_ = self.judge.write((Move("monotone"),), pool, relation)
            if number_ is not None:
                return number_
        return None

    def _eliminated(
        self, line: int, base: Sequence[Ref], relation: Relation, target: set[str]
    ) -> int | None:
        """By the range of a letter in an equation of which the claim does not speak."""
        scene = self.scene
        link = scene.desk.last_link(line)
        inside = {s for side in (link.left, link.right) for s in self._value(side).free_symbols}
        known_roles = roles(scene.problem)
        gone = [s for s in inside if s.name in known_roles and s.name not in target]
        wanted = subject_of(relation)
        written: list[int] = []
        for symbol in sorted(gone, key=self._rank):
            for sign, x, bound in self.derived(line, symbol):
                mark = self.mark()
                short = Link(tree_of(x), sign, ZERO)
                solved = self.solved(sign, x, wanted)
                if x.atoms(sp.sin, sp.cos, sp.tan):
                    short = self.bounded(line, symbol, bound) or short
                    solved = short
                if solved is not None and self._is_monic(x):
                    short = solved
                ends = self.judge.known([symbol.name])
                first = [ref for ref in ends if any(e in str(ref) for e in _near(bound))]
                pool = [line, *first, *self._known_in(x), *ends]
                number_ = self.judge.write((Move("sign"),), pool, Relation(((short,),)))
                if number_ is None:
                    self.back(mark)
                    continue
                if short != solved:
                    number_ = self.finished(number_, sign, x, wanted)
                if same(scene.desk.relation(number_), relation):
                    return number_
                found = self._compared([*base, number_], relation)
                if found is not None:
                    return found
                written.append(number_)
        if written:
            return self._compared([*base, *written], relation)
        return None

    def _compared(
        self, refs: Sequence[Ref], relation: Relation, known_only: Sequence[Ref] = ()
    ) -> int | None:
        """A line by what is cited, and the ranges of letters."""
        for each in refs:
            if isinstance(each, int) and each not in known_only:
                said = self.scene.desk.line(each).relation
                if isinstance(said, Relation) and same(said, relation):
                    return each
        names: set[str] = set()
        for ref in refs:
            own = (
                self.scene.desk.line(ref).relation
                if isinstance(ref, int)
                else self.scene.facts[ref].relation
                if ref in self.scene.facts
                else None
            )
            if isinstance(own, Relation):
                names |= {n for e in own.only for side in (e.left, e.right) for n in letters(side)}
        names |= {n for e in relation.only for side in (e.left, e.right) for n in letters(side)}
        pool = [*refs, *self.judge.known(n for n in names if n in roles(self.scene.problem))]
        rooted = self._rooted(refs, relation, pool)
        if rooted is not None:
            pool = [rooted, *pool]
        conditions = [
            each
            for each in refs
            if isinstance(each, int)
            and isinstance(own := self.scene.desk.line(each).relation, Relation)
            and own.only[0].sign != "="
        ]
        for each in conditions:
            line = self.judge.write((Move("rearrange"),), [each], relation)
            if line is not None:
                return line
        kind = "compare" if conditions else "sign"
        return self.judge.write((Move(kind),), pool, relation)  # type: ignore[arg-type]

    def _rooted(self, refs: Sequence[Ref], relation: Relation, pool: Sequence[Ref]) -> int | None:
        """Of a bound of the square of a ratio, that of the ratio, where its angle is asked."""
        subject = subject_of(relation)
        if not isinstance(subject, Letter):
            return None
        for ref in refs:
            own = self.scene.desk.line(ref).relation if isinstance(ref, int) else None
            if not isinstance(own, Relation) or len(own.only) != 1:
                continue
            match own.only[0]:
                case Link(
                    Binary("^", Apply(name, Letter() as letter) as ratio, power), sign, right
                ):
                    if (
                        letter != subject
                        or sign not in FLIPPED
                        or name not in ("sin", "cos", "tan")
                    ):
                        continue
                    if power != Number(Fraction(2)):
                        continue
                    root = tree_of(tidy(sp.sqrt(self._value(right))))
                    links = (
                        (Link(ZERO, "<", ratio), Link(ratio, sign, root))
                        if sign[0] == "<"
                        else (Link(ratio, sign, root),)
                    )
                    return self.judge.write((Move("compare"),), pool, Relation((links,)))
        return None

    def quantities(self, tree: Expression) -> Iterator[Quantity]:
        """The outermost quantities of a tree."""
        match tree:
            case Quantity(kind) if kind not in ("mass", "line_of_centres"):
                yield tree
            case _:
                for each in children(tree):
                    yield from self.quantities(each)

    def write_components(self, link: Link) -> tuple[int, Relation]:
        """An inequality between components along one line, as letters say it."""
        sides: list[Expression] = []
        values: list[sp.Expr] = []
        lines: list[Ref] = []
        for side in (link.left, link.right):
            tree, refs, value = self._named_component(side)
            sides.append(tree)
            values.append(value)
            lines += refs
        relation = Relation(((Link(sides[0], link.sign, sides[1]),),))
        line = self._compared(list(dict.fromkeys(lines)), relation)
        if line is not None:
            return line, relation
        numbers = [each for each in dict.fromkeys(lines) if isinstance(each, int)]
        if len(numbers) == 2:
            turn = 1 if link.sign[0] == ">" else -1
            value = tidy(sp.factor(values[::turn][0] - values[::turn][1]))
            told = Link(Binary("-", *sides[::turn]), "=", tree_of(value))
            line = self._difference(Relation(((told,),)), numbers)
            if line is not None:
                number_ = self._compared([line], relation)
                if number_ is not None:
                    return number_, relation
        raise NotPlannedError("who is the faster")

    def _difference(self, relation: Relation, lines: Sequence[int]) -> int | None:
        for pair in (lines, lines[::-1]):
            line = self.judge.write((Move("combine"),), pair, relation)
            if line is not None:
                return line
        return None

    def _named_component(self, side: Expression) -> tuple[Expression, tuple[Ref, ...], sp.Expr]:
        """A component by the letter for it, and the line that says what it is."""
        scene = self.scene
        match side:
            case Quantity("along", (Quantity("velocity", (Name(body),), int(stage)), axis)):
                self.determine(side)
                last = scene.last_event(body, stage)
                frame = frame_after(scene, body, last)
                quantity = frame.component("along", body, last)
                known = scene.desk.known(quantity)
                source = self.component("along", body, last, frame)
                wanted = scene.model.story.direction(axis, scene.events)
                sense = scene.model.sign(wanted.dot(frame.n))
                if tidy(wanted.cross(frame.n)) != 0:
                    raise NotPlannedError("components along different lines")
                value = sense * source.value
                own = sp.sympify(0 if known is None else known.value, strict=True)
                symbol = own if own.is_Symbol else -own
                if symbol not in {each.symbol for each in scene.model.components.values()}:
                    tree = quantity if sense == 1 else side
                    refs = (*source.whole, *frame.refs, *self._axis_named(axis))
                    return tree, tuple(dict.fromkeys(refs)), value
                return tree_of(sense * own), self._explicit(symbol, source), value
        return side, (), sp.sympify(scene.scalar(side), strict=True)

    def _explicit(self, symbol: sp.Symbol, source: Source) -> tuple[Ref, ...]:
        """The line that says what a letter of a component is, in letters of the statement."""
        desk = self.scene.desk
        own = desk.known(Letter(symbol.name))
        if own is None:
            return source.refs
        value, refs = self.scene.put(own.value)
        if value == own.value:
            return own.refs
        relation = Relation(((Link(Letter(symbol.name), "=", tree_of(value)),),))
        line = self.judge.write((Move("put"),), (*own.refs, *refs), relation)
        return source.refs if line is None else (line,)


def _as_right_angle(each: GivenEquation) -> GivenEquation:
    """A deflection of 90° as a right angle between the velocities before and after."""
    match each.link:
        case Link(Quantity("deflection", (Name(),) as body, int(stage)), "=", Degrees(value)):
            if value == 90:
                later, early = (Quantity("velocity", body, k) for k in (stage, stage - 1))
                return replace(each, link=Link(later, "perpendicular to", early))
    return each


def _has_root(relation: Relation) -> bool:
    return any(
        isinstance(each, Apply) and each.function == "sqrt"
        for links in relation.options
        for link in links
        for side in (link.left, link.right)
        for each in walk(side)
    )


def has_quantity_in(relation: Relation) -> bool:
    """Whether a relation speaks of a quantity of the motion."""
    return any(has_quantity(side) for link in relation.only for side in (link.left, link.right))


def subject_of(relation: Relation) -> Expression | None:
    """Of what a relation is: between two bounds, what stands between them; else a side."""
    links = relation.only
    if len(links) == 2 and links[0].right == links[1].left:
        return links[0].right
    sides = (links[0].left, links[0].right)
    return next((side for side in sides if letters(side)), None)


def _is_zero(tree: Expression) -> bool:
    return isinstance(tree, Number) and not tree.value


def _near(sign: Sign) -> tuple[str, ...]:
    """How premises about that end of a range are written."""
    return ("acute", "°", f" {sign[0]}")


def same(a: Relation, b: Relation) -> bool:
    """Whether two relations say the same, whichever way round they are written."""
    return told(a) == told(b)


def told(relation: Relation) -> frozenset[object]:
    """What a relation without alternatives says."""
    return frozenset(
        (FLIPPED[e.sign], e.right, e.left) if e.sign in (">", ">=") else (e.sign, e.left, e.right)
        for e in relation.only
    )


def linear_in(
    x: sp.Expr, symbol: sp.Symbol, angle: bool
) -> tuple[Expression, sp.Expr, sp.Expr, sp.Expr] | None:
    """A generator in which ``x = 0`` is linear: its tree, its value, its factor and the rest.

    A letter, its square, or a ratio of an angle or the square of one.
    """
    x = sp.expand(x)
    letter = Letter(symbol.name)
    if not angle:
        if symbol in {s for f in x.atoms(sp.Function) for s in f.free_symbols}:
            return None
        return _linear_poly(x, symbol, symbol, letter)
    functions = {f for f in x.atoms(sp.sin, sp.cos, sp.tan) if symbol in f.free_symbols}
    if any(f.args != (symbol,) for f in functions) or not functions:
        return None
    kinds = {type(f) for f in functions}
    t = sp.Dummy("t")
    if kinds == {sp.tan} or kinds == {sp.sin} or kinds == {sp.cos}:
        (kind,) = kinds
        put = sp.expand(x.subs(kind(symbol), t))
        return _linear_poly(put, t, kind(symbol), Apply(kind.__name__, letter))
    if kinds != {sp.sin, sp.cos}:
        return None
    try:
        mixed = sp.Poly(x, sp.sin(symbol), sp.cos(symbol))
    except sp.PolynomialError:
        return None
    most = max(sum(each) for each in mixed.monoms())
    if any((most - sum(each)) % 2 for each in mixed.monoms()):
        return None
    # Each term takes powers of sin² + cos², until all are of one degree.
    put = sum(c * t**a * (1 + t**2) ** ((most - a - b) // 2) for (a, b), c in mixed.terms())
    return _linear_poly(sp.expand(put), t, sp.tan(symbol), Apply("tan", letter))


def _linear_poly(
    x: sp.Expr, t: sp.Symbol, value: sp.Expr, tree: Expression
) -> tuple[Expression, sp.Expr, sp.Expr, sp.Expr] | None:
    try:
        poly = sp.Poly(x, t)
    except sp.PolynomialError:
        return None
    powers = {m for (m,) in poly.monoms()}
    if powers <= {0, 1} and 1 in powers:
        return tree, value, poly.nth(1), poly.nth(0)
    if powers <= {0, 2} and 2 in powers:
        return square(tree), value**2, poly.nth(2), poly.nth(0)
    return None


def _bounds(role: Any, generator: sp.Expr, symbol: sp.Symbol) -> list[tuple[Sign, sp.Expr]]:
    """The bounds of a letter, or of a ratio of it, by its role."""
    base, power = generator.as_base_exp()
    low, high = role.low, role.high
    ends: list[tuple[Sign, sp.Expr]] = []
    falling = isinstance(base, sp.cos)
    if role.kind == "angle" and (
        low is None or high is None or low < 0 or high > (sp.pi if falling else sp.pi / 2)
    ):
        return []
    if power == 2 and (low is None or low < 0 or (falling and high > sp.pi / 2)):
        return []
    for end, sign, closed in ((low, ">", role.closed[0]), (high, "<", role.closed[1])):
        if end is None:
            continue
        value = base.subs(symbol, end) ** power
        if not value.is_finite:
            continue
        own: Any = sign + ("=" if closed else "")
        ends.append((FLIPPED[own] if falling else own, value))
    return ends
