"""Given inequalities: with values put in, without their positive factors, and solved."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Literal

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Fact,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    turned,
)
from restitution.explaining.lines.trees import has_quantity_in
from restitution.expression.quantities import ANGLES, UNSIGNED_ANGLES
from restitution.expression.tree import (
    COMPONENTS,
    Apply,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    Unit,
    has_quantity,
    is_binary,
    is_zero,
    letters,
    walk,
)
from restitution.planning.angles.deflections import scalar_product
from restitution.planning.axes.offsets import sine_of, write_sine
from restitution.planning.closing.squares_apart import squares_apart
from restitution.planning.formulas.turns import velocities_of
from restitution.planning.formulas.velocity_formulas import body_and_stage, frame_after
from restitution.planning.inequalities.angles_bounded import Bounded, write_bounded
from restitution.planning.inequalities.bounds_by_cotangents import write_by_cotangent
from restitution.planning.inequalities.bounds_with_roots import collected
from restitution.planning.inequalities.coming_to_walls import (
    is_of_a_wall,
    solved_at_walls,
    write_towards,
)
from restitution.planning.inequalities.conditions_shown import write_shown
from restitution.planning.inequalities.given_products import (
    product_with_an_axis,
    write_given_product,
)
from restitution.planning.inequalities.multiplied_out import multiplied_out, sides_expanded
from restitution.planning.inequalities.oblique_components import is_oblique
from restitution.planning.inequalities.obtuse_by_tangents import write_by_a_tangent
from restitution.planning.inequalities.sides_put import write_quotient, write_sum
from restitution.planning.inequalities.squares import (
    both_squared,
    in_its_square,
    solve_in_squares,
    solve_quadratic,
    square_and_solve,
    without_roots,
    write_speeds,
)
from restitution.planning.inequalities.standard_conditions import (
    as_quadratic,
    in_factors,
    is_linear,
)
from restitution.planning.inequalities.standing_ratios import write_by_a_ratio
from restitution.planning.inequalities.turns_bounded import write_other_angle
from restitution.planning.inequalities.wall_ends import is_of_a_path, write_between, write_first_hit
from restitution.planning.inequalities.worths import Worths
from restitution.planning.writing.desk import together
from restitution.planning.writing.forms import ZERO, square, swept, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.inequalities import completed_square, solve_linear, without_signs
from restitution.planning.writing.polynomials import expanded, factored, one_fraction
from restitution.problem import Given, Meets
from restitution.vector import Vector

_BOUNDED = ("<", "<=", ">", ">=")
_OF_THE_STORY = ("most ", "approach ", "offset ")

Product = tuple[Sequence[tuple[str, int]], Expression, sp.Expr, tuple[Ref, ...]]
"""A scalar product: of which velocities, as a tree, as a value, and what it rests on."""


class Conditions:
    """The inequalities that a part gives."""

    def __init__(self, worths: Worths) -> None:
        self.worths = worths
        self.scene = worths.scene
        self.solver = worths.solver
        self.judge = worths.judge
        self._lines: dict[int, Relation] | None = None
        self._story: dict[int, Relation] | None = None

    def clear(self) -> None:
        """Forgets what has been taken away again."""
        self._lines = self._story = None

    def story(self, wanted: Expression | None = None) -> list[int]:
        """What has to be, or there are no such impacts, in letters."""
        if not self._stand(self._story):
            facts = (fact for fact in self.scene.desk.facts if fact.id.startswith(_OF_THE_STORY))
            own = (e for e in facts if self.scene.desk.holds(e.id) and not self._is_of_later(e))
            self._story = self._written(own, wanted)
        return [*(self._story or ())]

    def lines(self, wanted: Expression | None = None) -> list[int]:
        """The given inequalities, in letters and solved as far as one line does it."""
        if not self._stand(self._lines):
            self._lines = self._written(self.inequalities(), wanted)
        return [*(self._lines or ())]

    def _written(self, facts: Iterable[Fact], wanted: Expression | None) -> dict[int, Relation]:
        numbers = (self.condition(fact, wanted) for fact in facts)
        return {n: self.scene.desk.relation(n) for n in numbers if n is not None}

    def _stand(self, lines: Mapping[int, Relation] | None) -> bool:
        """Whether lines stand on the desk still: who went back has taken them away."""
        known = self.scene.desk.lines
        return lines is not None and all(
            number <= len(known) and known[number - 1].relation == relation
            for number, relation in lines.items()
        )

    def inequalities(self) -> Iterator[Fact]:
        """The given inequalities that speak of the motion."""
        desk = self.scene.desk
        # A sense that is given goes first: a speed is a component, or what is opposite to it.
        for fact in sorted(desk.facts, key=lambda fact: not fact.id.startswith("sense ")):
            if not desk.holds(fact.id) or self._is_of_later(fact):
                continue
            if fact.kind not in ("given", "range") and not fact.id.startswith("within "):
                continue
            link = fact.relation.options[0][0]
            if (link.sign in _BOUNDED and self._speaks_of_motion(fact)) or _is_a_sense(fact):
                yield fact

    def _is_of_later(self, fact: Fact) -> bool:
        """Whether a fact of the story is of an event that comes after what is asked now."""
        word, _, number = fact.id.rpartition(" ")
        return f"{word} " in (*_OF_THE_STORY, "within ") and int(number) > self.scene.events

    def _speaks_of_motion(self, fact: Fact) -> bool:
        """Whether a relation is about a quantity, or a letter for an angle of the motion."""
        link = fact.relation.options[0][0]
        named = [self.worths.opened(side) for side in (link.left, link.right)]
        angles = [tree for tree in named if isinstance(tree, Quantity)]
        is_angle = any(angle.kind in ANGLES for angle in angles)
        return is_angle or has_quantity_in(fact.relation)

    def condition(self, fact: Fact, wanted: Expression | None) -> int | None:
        """The line of one of them, in letters, and solved as far as one line does it."""
        if fact.id.startswith("within "):
            return write_between(self.worths, fact, wanted)
        if is_of_a_path(fact.relation):
            return write_first_hit(self.worths, fact, wanted)
        if (shown := write_shown(self.worths, fact)) is not None:
            return shown
        (link,) = fact.relation.only
        if not has_quantity(link.left) and has_quantity(self.worths.opened(link.right)):
            link = turned(link)
        if fact.id.startswith(("most ", "offset ")):
            x = expanded(self.scene.scalar(link.left) - self.scene.scalar(link.right))
            solved = solve_linear(self.scene, link.sign, x, wanted)
            if solved is None:
                return None
            first = self.judge.write((Move("fact"),), [fact.id], fact.relation)
            pool = [fact.id if first is None else first, *self.worths.known_in(x)]
            return self.judge.write((Move("rearrange"),), pool, Relation(((solved,),)))
        if link.sign == "=":
            return self._by_sense(fact, link, wanted)
        if is_of_a_wall(self.worths, fact):
            towards = write_towards(self.worths, fact, wanted)
            if towards is None:
                return None
            of_a_product = is_binary(wanted, "*")
            # A product that is to be shown is bounded as it stands.
            done = towards[1] == "!=" or of_a_product
            return towards[0] if done else self.finished(*towards, wanted)
        match self.worths.opened(link.left), link.right:
            case Quantity(kind) as angle, Degrees(value) if kind in UNSIGNED_ANGLES and value == 90:
                signed = write_by_a_tangent(self.worths, fact, link, angle)
                if signed is not None:
                    return self.finished(*signed, wanted)
                return self._past_a_right_angle(fact, link, angle, wanted)
            case Quantity("direction", (Name() as body,), int(stage)), Degrees(value) if (
                value == 90 and link.sign[0] == ">"
            ):
                to_axis = Quantity("angle", (Quantity("velocity", (body,), stage), Unit("i")))
                behind = self._past_a_right_angle(fact, link, to_axis, wanted)
                if behind is not None:
                    return behind
            case Quantity(kind) as angle, Degrees(value) if (
                kind in UNSIGNED_ANGLES and 0 < value < 90
            ):
                bounded = write_other_angle(self.worths, fact, link, angle)
                bounded = bounded or write_bounded(self.worths, fact, link, angle)
                if bounded is not None and self._is_solved(bounded[0]):
                    return bounded[0]
                if bounded is not None:
                    condition = both_squared(self.worths, *bounded)
                    number = self.finished(*condition, wanted)
                    # What divides in the tangent may have either sign: then it is no answer yet.
                    falling = self._by_cotangent(fact, link) if number == condition[0] else None
                    return number if falling is None else self.finished(*falling, wanted)
            case Quantity("deflection") as angle, Degrees():
                if (beside := write_other_angle(self.worths, fact, link, angle)) is not None:
                    done = self._is_solved(beside[0])
                    return beside[0] if done else self.finished(*beside, wanted)
        bounded = self._by_cotangent(fact, link) or write_given_product(self.worths, fact, link)
        if bounded is not None:
            return self.finished(*bounded, wanted)
        if (ratio := write_by_a_ratio(self.worths, fact, link)) is not None:
            bound = self.scene.desk.last_link(ratio)
            gap = expanded(self.worths.value(bound.left) - self.worths.value(bound.right))
            return self.finished(ratio, bound.sign, gap, wanted)
        gap = self.gap(link)
        if gap.has(sp.Abs):
            mark = self.worths.mark()
            self.sources(link)  # a line may tell the sense of who moves along the line of centres
            gap = self.gap(link)
            if gap.has(sp.Abs):
                self.worths.back(mark)
        own = without_signs(self.scene, gap, link.sign)
        if own is None or own[1].has(sp.atan2):
            return None  # an angle that no line bounds
        sign, x = own
        squared = write_speeds(self.worths, fact, link, sign, x)
        if squared is not None:
            return self.finished(squared, *without_roots(self.worths, squared, sign, x), wanted)
        pool = [fact.id, *self.sources(link), *self.worths.known_in(gap)]
        relation = Relation(((Link(tree_of(x), sign, ZERO),),))
        if x.has(sp.sin) and x.has(sp.cos):
            solved = solve_linear(self.scene, sign, x, wanted) or solve_linear(self.scene, sign, x)
            relation = relation if solved is None else Relation(((solved,),))
        line = self._by_steps(link, fact.id, pool, relation, x, sign)
        if line is None:
            return None
        if self._is_one_factor(line):
            bound = self.scene.desk.last_link(line)
            sign, x = bound.sign, expanded(self.worths.value(bound.left))
        return self.finished(line, sign, x, wanted)

    def _by_cotangent(self, fact: Fact, link: Link) -> Bounded | None:
        """A bound in degrees of a deflection, or of a direction, by the cotangent."""
        match self.worths.opened(link.left), link.right:
            case Quantity("deflection" | "direction", (Name(),), int()) as angle, (
                Degrees() | Negate(Degrees())
            ):
                return write_by_cotangent(self.worths, fact, link, angle)
            case Quantity("angle", (Quantity("velocity"), _)) as angle, Degrees():
                return write_by_cotangent(self.worths, fact, link, angle)
        return None

    def _by_sense(self, fact: Fact, link: Link, wanted: Expression | None) -> int | None:
        """A direction that is given of who moves along the line of centres: which way it goes."""
        scene = self.scene
        match link:
            case Link(Quantity("direction", (Name(body),), int(stage)), "=", angle):
                event = scene.last_event(body, stage)
            case _:
                return None
        component = scene.model.components.get((event, body))
        if component is None or event not in scene.model.frames:
            return None
        frame = frame_after(scene, body, event)
        if scene.put(scene.velocity(body, event).dot(frame.t))[0] != 0:
            return None
        turn = scene.scalar(angle)
        ahead = scene.model.sign(Vector(sp.cos(turn), sp.sin(turn)).dot(frame.n))
        self.worths.determine(Quantity("velocity", (Name(body),), event))
        own = self.worths.component("along", body, event, frame)
        sign: Sign = ">" if ahead * frame.letter_sign > 0 else "<"
        value = scene.put(component.symbol)[0]
        stripped = without_signs(scene, expanded(value), sign)
        if not ahead or stripped is None:
            return None
        letter = Letter(component.symbol.name)
        lets = scene.desk.introducing({letter.name})
        first = Relation(((Link(letter, sign, ZERO),),))
        line = self.judge.write((Move("compare"),), [fact.id, *lets, *frame.refs], first)
        if line is None:
            return None
        put = Relation(((Link(tree_of(value), sign, ZERO),),))
        known = self.worths.known_in(value)
        pool = [line, *own.whole, *known]
        after = self.judge.write((Move("put"), Move("compare")), pool, put)
        return None if after is None else self.finished(after, *stripped, wanted)

    def stated(
        self,
        fact: Fact,
        wanted: Expression | None,
        shown: Literal["line", "silent"] = "silent",
    ) -> int | None:
        """The line of one of them; where it holds of itself, a silent one that says it in letters.

        No range comes of that: a working only says that it holds.
        """
        line = self.condition(fact, wanted)
        if line is not None:
            return line
        (link,) = fact.relation.only
        if link.sign == "=":
            return None
        gap = self.gap(link)
        if gap.has(sp.atan2):
            return None
        pool = [fact.id, *self.sources(link), *self.worths.known_in(gap)]
        trees = [
            tree_of(self.scene.put(self.scene.scalar(side))[0]) for side in (link.left, link.right)
        ]
        relation = Relation(((Link(trees[0], link.sign, trees[1]),),))
        return self.judge.write((Move("put"),), pool, relation, shown=shown)

    def holding(self, fact: Fact) -> int | None:
        """The line of one that holds of itself, without its positive factors.

        None of one that does not, or that no line says.
        """
        if len(fact.relation.only) > 1:
            return None
        (link,) = fact.relation.only
        mark = self.worths.mark()
        first = self.stated(fact, None, shown="line")
        if first is None or self.scene.desk.line(first).move.id != "put":
            self.worths.back(mark)
            return None
        gap = self.gap(link)
        above, _ = sp.fraction(factored(one_fraction(gap)))
        sums = [factor for factor in sp.Mul.make_args(above) if factor.as_base_exp()[0].is_Add]
        sign = link.sign if link.sign[0] == ">" else FLIPPED[link.sign]
        rest = expanded(sp.Mul(*sums))
        positive = proved_sign(self.scene.model.inside, rest)
        if not sums or not positive:
            return first
        inequality = Relation(((Link(tree_of(positive * rest), sign, ZERO),),))
        moves = (Move("rearrange"), Move("cancel"))
        start = sides_expanded(self.worths, first)
        last = self.judge.write(moves, [start, *self.worths.known_in(gap)], inequality)
        completed = None if last is None else completed_square(self.scene, positive * rest)
        if last is None or completed is None:
            return first if last is None else last
        inequality = Relation(((Link(completed, sign, ZERO),),))
        return self.judge.write((Move("rearrange"),), [last], inequality) or last

    def _past_a_right_angle(
        self, fact: Fact, link: Link, angle: Quantity, wanted: Expression | None
    ) -> int | None:
        """An angle of more than 90°, or of less, by the sign of the scalar product."""
        own = self._of_velocities(angle) or self._with_a_direction(angle)
        if (product := own or product_with_an_axis(self.worths, angle)) is None:
            return None
        pair, tree, value, refs = product
        event = max(frame_after(self.scene, *state).number for state in pair)
        opposite = FLIPPED[link.sign]
        stripped = without_signs(self.scene, expanded(value), opposite)
        if stripped is None:
            return None
        sign, x = stripped
        move = Move("define", "perpendicular", event, tuple(dict.fromkeys(b for b, _ in pair)))
        known = self.worths.known_in(expanded(value))
        first = Relation(((Link(tree, opposite, ZERO),),))
        lets = self.scene.lets_in(link)
        pool = [fact.id, *lets, *refs, *known]
        axis = self.scene.frame(event).refs
        number = self.judge.write((move,), [*pool, *axis], first)
        if number is None:
            number = self.judge.write((move,), pool, first)  # of components by a letter's angle
        if number is None:
            return None
        solved = solve_linear(self.scene, sign, x, wanted) or solve_linear(self.scene, sign, x)
        moves = (Move("rearrange"), Move("cancel"), Move("compare"))
        both = x.has(sp.sin) and x.has(sp.cos)
        short = squares_apart(x, sign) if both else Link(tree_of(x), sign, ZERO)
        for form in (short, solved):
            if form is None:
                continue
            after = self.judge.write(moves, [number, *known], Relation(((form,),)))
            number = number if after is None else after
        return number if wanted is None else self._by_the_offset(number, x, sign, wanted)

    def _by_the_offset(self, line: int, x: sp.Expr, sign: Sign, wanted: Expression) -> int:
        """A bound of tan²φ, where an offset tells sin φ, as one of what that is; else the line."""
        angles = {ratio.args[0] for ratio in x.atoms(sp.sin, sp.cos)}
        if len(angles) != 1 or not all(angle.is_Symbol for angle in angles):
            return line
        (symbol,) = angles
        own = sine_of(self.scene, symbol.name)
        if own is None or not letters(wanted) & letters(own.link.right):
            return line
        square_ = sp.Dummy()
        of_sine = expanded(x).xreplace(
            {sp.cos(symbol) ** 2: 1 - square_, sp.sin(symbol) ** 2: square_}
        )
        slope, rest = of_sine.diff(square_), of_sine.subs(square_, 0)
        if not slope.is_Rational or not rest.is_Rational or slope == 0:
            return line
        bound = -rest / slope
        turned_ = sign if slope > 0 else FLIPPED[sign]
        acute = f"acute: {symbol.name}"
        for ratio, value in (("tan", bound / (1 - bound)), ("sin", bound)):
            power = square(Apply(ratio, Letter(symbol.name)))
            relation = Relation(((Link(power, turned_, tree_of(tidy(value))),),))
            moves = (Move("rearrange"), Move("cancel"), Move("compare"))
            line = self.judge.write(moves, [line, acute], relation) or line
        put = square(own.link.right)
        relation = Relation(((Link(put, turned_, tree_of(tidy(bound))),),))
        after = self.judge.write((Move("put"),), [line, write_sine(self.scene, own)], relation)
        if after is None:
            return line
        return self.finished(after, turned_, expanded(self.worths.value(put) - bound), wanted)

    def _of_velocities(self, angle: Quantity) -> Product | None:
        """The scalar product of two velocities."""
        pair = velocities_of(self.scene, angle)
        if pair is None:
            return None
        for body, stage in pair:
            self.worths.determine(Quantity("velocity", (Name(body),), stage))
        event = max(frame_after(self.scene, *state).number for state in pair)
        return pair, *scalar_product(self.scene, pair, event, signed=True)

    def _with_a_direction(self, angle: Quantity) -> Product | None:
        """The component of a velocity in a direction along the line of centres, or across it."""
        match angle:
            case Quantity("angle", (Quantity("velocity") as velocity, Unit() as line)):
                pass
            case _:
                return None
        self.worths.determine(velocity)
        own = body_and_stage(self.scene, velocity)
        frame = frame_after(self.scene, *own)
        direction = self.scene.model.story.direction(line, self.scene.events)
        for kind, axis in (("along", frame.n), ("across", frame.t)):
            if tidy(direction.cross(axis)) == 0:
                component = self.worths.component(kind, *own, frame)
                value = component.value * tidy(direction.dot(axis))
                return (own,), swept(tree_of(value)), value, component.whole
        return None

    def gap(self, link: Link) -> sp.Expr:
        """Left minus right of an inequality of quantities, in letters; of sizes, their squares."""
        for side in (link.left, link.right):
            if has_quantity(side):
                self.worths.determine(side)
        left, right = map(self.worths.of_side, (link.left, link.right))
        if left.atoms(sp.Pow) | right.atoms(sp.Pow) and any(
            p.exp == sp.Rational(1, 2) and p.base.free_symbols
            for p in left.atoms(sp.Pow) | right.atoms(sp.Pow)
        ):
            return expanded(left**2 - right**2)
        return expanded(left - right)

    def sources(self, link: Link) -> tuple[Ref, ...]:
        """The lines of the components and the quantities in an inequality."""
        refs: list[Ref] = []
        for side in (link.left, link.right):
            for node in walk(side):
                match node:
                    case Quantity("along") if is_oblique(self.scene, node):
                        refs.append(self.worths.quantity(node))
                    case Quantity("along" | "across" | "dot"):
                        for velocity in node.arguments:
                            refs += self._components_of(velocity)
                            refs += self.axis_named(velocity)
                        refs += self.worths.axes(node)
                    case Quantity("velocity"):
                        continue
                    case Quantity(kind) if kind not in ("mass", "line_of_centres"):
                        refs.append(self.worths.quantity(node))
        return together(refs)

    def axis_named(self, tree: Expression) -> tuple[Ref, ...]:
        """The fact that gives the line of centres by which a component is named."""
        match tree:
            case Quantity("line_of_centres", (), int(event)):
                return tuple(r for r in (f"axis {event}",) if self.worths.exists(r))
        return ()

    def _components_of(self, tree: Expression) -> list[Ref]:
        refs: list[Ref] = []
        for node in walk(tree):
            match node:
                case Quantity("velocity", (Name(),), int()):
                    body, stage = body_and_stage(self.scene, node)
                    frame = frame_after(self.scene, body, stage)
                    for kind in COMPONENTS:
                        refs += self._with_letter(kind, body, stage, frame)
        return refs

    def _with_letter(self, kind: str, body: str, stage: int, frame: Frame) -> list[Ref]:
        desk = self.scene.desk
        direct = desk.known(frame.component(kind, body, stage))
        mark = self.worths.mark()
        source = self.worths.component(kind, body, stage, frame)
        if len(desk.lines) > mark.desk.lines and kind == "across":
            self.worths.back(mark)
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
        if not is_zero(link.right) or self._is_meeting(fact):
            values = [self.worths.of_side(side) for side in (link.left, link.right)]
            relation_sign = link.sign
            if values[1] == 0 and self._stands_turned(pool, values[0]):
                # As it stands above: the sense turns, and not the terms.
                relation_sign, values[0] = FLIPPED[relation_sign], tidy(-values[0])
            trees = [tree_of(value) for value in values]
            first = Relation(((Link(trees[0], relation_sign, trees[1]),),))
            if first != relation:
                line = write_quotient(self.worths, link, pool, first)
                line = line or write_sum(self.worths, link, pool, first, x)
                line = self.judge.write(put, pool, first) if line is None else line
                if line is not None:
                    known = self.worths.known_in(x)
                    squared = square_and_solve(self.worths, line, sign, x, known)
                    if squared is not None:
                        return squared
                    solved = solve_linear(self.scene, sign, x)
                    if x.has(sp.sin) and x.has(sp.cos):
                        line = self._square_of_ratio(line)
                    if solved is None:
                        line = sides_expanded(self.worths, line)
                    line = in_factors(self.worths, line, known)
                    if solved is None and self._is_one_factor(line):
                        return line
                    if solved is not None:
                        line = multiplied_out(self.worths, line, relation_sign, values, solved)
                        squared = in_its_square(self.worths, line, solved)
                        if squared is not None:
                            return squared
                    for form in (solved, relation.only[0]):
                        if form is None:
                            continue
                        known = self.worths.known_in(x)
                        after = self.judge.write(
                            (
                                Move("rearrange"),
                                Move("cancel"),
                                Move("identity", "pythagoras"),
                                Move("compare"),
                            ),
                            [line, *known],
                            Relation(((form,),)),
                        )
                        if after is not None:
                            return after
                    after = self._with_a_ratio_cancelled(line, link, relation)
                    if after is not None:
                        return after
        line = self.judge.write(put, pool, relation)
        if line is not None:
            return line
        return self.judge.write((Move("compare"),), pool, relation)

    def _is_solved(self, line: int) -> bool:
        """Whether a line bounds a letter by a number."""
        link = self.scene.desk.last_link(line)
        return isinstance(link.left, Letter) and not letters(link.right)

    def _is_one_factor(self, line: int) -> bool:
        """Whether a line says the sign of what is linear in a letter, or of its square."""
        link = self.scene.desk.last_link(line)
        base, _ = self.worths.value(link.left).as_base_exp()
        return is_zero(link.right) and is_linear(base)

    def _with_a_ratio_cancelled(self, line: int, link: Link, relation: Relation) -> int | None:
        """A condition in which sin² + cos² = 1 leaves a ratio of an angle as a factor of all."""
        gap = self.gap(link)
        factors = [factor.as_base_exp() for factor in sp.Mul.make_args(factored(gap))]
        ratios = [base**power for base, power in factors if base.func in (sp.sin, sp.cos)]
        rest = [base**power for base, power in factors if base.is_Add]
        sign = sp.Mul(*(base**power for base, power in factors if base.is_number))
        if not ratios or not rest or any(value.has(sp.sin, sp.cos) for value in rest):
            return None
        mark, known = self.worths.mark(), self.worths.known_in(gap)
        x = expanded(sp.Mul(1 if sign > 0 else -1, *rest))
        for move, left in (
            (Move("identity", "pythagoras"), sp.Mul(x, *ratios)),
            (Move("cancel"), x),
        ):
            bound = Relation(((Link(tree_of(left), link.sign, ZERO),),))
            number = self.judge.write((move,), [line, *known], bound)
            if number is None:
                self.worths.back(mark)
                return None
            line = number
        solved = solve_linear(self.scene, link.sign, x)
        last = relation if solved is None else Relation(((solved,),))
        return self.judge.write((Move("rearrange"), Move("cancel")), [line, *known], last) or line

    def _square_of_ratio(self, line: int) -> int:
        """A condition on the square of a sine or of a cosine alone, solved for it first."""
        link = self.scene.desk.last_link(line)
        gap = expanded(self.worths.value(link.left) - self.worths.value(link.right))
        own = without_signs(self.scene, gap, link.sign)
        if own is None or (own[1].has(sp.sin) and own[1].has(sp.cos)):
            return line
        solved = solve_linear(self.scene, *own)
        if solved is None:
            return line
        known = self.worths.known_in(gap)
        moves = (Move("rearrange"), Move("cancel"))
        after = self.judge.write(moves, [line, *known], Relation(((solved,),)))
        return line if after is None else after

    def _stands_turned(self, pool: Sequence[Ref], value: sp.Expr) -> bool:
        """Whether a line above says what a letter for a component is, in the opposite sense."""
        desk = self.scene.desk
        for ref in pool:
            if not isinstance(ref, int) or not isinstance(desk.line(ref).relation, Relation):
                continue
            own = desk.relation(ref)
            if len(own.options) == 1 and isinstance(own.only[0].left, Letter):
                x = self.worths.value(own.only[-1].right)
                if self.scene.model.identically_zero(x + value):
                    return True
        return False

    def _is_meeting(self, ref: Ref) -> bool:
        """Whether a given fact is that two bodies meet, or do not: it is told in words."""
        fact = self.scene.facts.get(str(ref))
        return fact is not None and any(
            isinstance(step, Given)
            and step.place == fact.place
            and any(isinstance(relation, Meets) for relation in step.relations)
            for _, step in self.scene.problem.steps()
        )

    def finished(self, line: int, sign: Sign, x: sp.Expr, wanted: Expression | None) -> int:
        """A condition solved for its letter by one more line, where it is linear in it."""
        if (at_walls := solved_at_walls(self.worths, (line, sign, x), wanted)) is not None:
            return at_walls
        solved = solve_linear(self.scene, sign, x, wanted)
        if solved is None:
            if self._is_one_factor(line):
                return line
            known = self.worths.known_in(x)
            if wanted is not None and len(x.free_symbols) > 1:
                last = solve_in_squares(self.worths, line, sign, x, wanted, known)
            else:
                last = solve_quadratic(self.worths, line, sign, x, known)
            return last if last != line else as_quadratic(self.worths, last, sign, x, wanted, known)
        relation = Relation(((solved,),))
        if relation == self.scene.desk.relation(line):
            return line
        squared = in_its_square(self.worths, line, solved)
        if squared is not None:
            return squared
        line = collected(self.worths, line, sign, x, solved)
        after = self.judge.write((Move("rearrange"),), [line, *self.worths.known_in(x)], relation)
        return line if after is None else after


def _is_a_sense(fact: Fact) -> bool:
    """Whether a fact gives the direction of a sphere."""
    if fact.kind != "given" or len(fact.relation.options) > 1:
        return False
    match fact.relation.only:
        case (Link(Quantity("direction", (Name(),), int()), "=", Degrees()),):
            return True
    return False
