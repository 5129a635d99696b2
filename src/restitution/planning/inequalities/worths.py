"""What quantities and expressions of them are worth: a line each, in letters of the statement."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import Link, Meaning, Move, Ref, Relation, equality
from restitution.explaining.lines.trees import exchanged, rebuilt
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    children,
    has_quantity,
    is_binary,
    is_function,
    is_quantity,
    letters,
    walk,
)
from restitution.planning.angles.expressions import write_expression
from restitution.planning.angles.quantities import formula
from restitution.planning.angles.turn_lines import write_turn_tangent
from restitution.planning.angles.turning import is_angle
from restitution.planning.angles.wall_turns import tangent_at_a_wall
from restitution.planning.closing.losses_by_products import write_loss_by_products
from restitution.planning.formulas.definitions import Formula
from restitution.planning.formulas.impacts import in_direction, scene_value
from restitution.planning.formulas.named_angles import letter_known, letter_of
from restitution.planning.formulas.turns import turns_of, velocities_of
from restitution.planning.formulas.velocity_formulas import body_and_stage, frame_after
from restitution.planning.journeys import journeys
from restitution.planning.routes.items import in_a_frame, is_named
from restitution.planning.routes.order import Solver, Standing
from restitution.planning.writing import place_trees
from restitution.planning.writing.between import terms_between
from restitution.planning.writing.desk import NotPlannedError, Source, together
from restitution.planning.writing.forms import outer_terms, square, swept, tree_of
from restitution.planning.writing.frames import Frame
from restitution.planning.writing.scene import Scene
from restitution.records import dataclass
from restitution.solving.story.letters import roles
from restitution.vector import Vector

_ANGLES = {
    "deflection": ("delta", "phi", "psi", "theta"),
    "angle": ("beta", "theta", "phi", "psi"),
    "direction": ("theta", "phi", "beta", "psi"),
}
_FURTHER_ANGLES = ("gamma", "omega", "chi", "eta", "delta")
# The moves by which a letter takes the place of what it stands for.
NAMED = (Move("put"), Move("rearrange"), Move("compare"))


@dataclass
class Worths:
    """The lines of a part that say what something is worth."""

    scene: Scene
    solver: Solver

    def __post_init__(self) -> None:
        self.judge = self.scene.judge

    def mark(self) -> Standing:
        """What stands, and which equations are used."""
        return self.solver.mark()

    def back(self, standing: Standing) -> None:
        """Takes away what was written since."""
        self.solver.back(standing)

    def exists(self, ref: Ref) -> bool:
        """Whether a fact is given."""
        return isinstance(ref, int) or ref in self.scene.facts

    def opened(self, tree: Expression) -> Expression:
        """A tree with each letter for a quantity replaced by the quantity."""

        def change(tree: Expression) -> Expression:
            if isinstance(tree, Letter):
                fact = self.scene.facts.get(f"let {tree.name}")
                inside = None if fact is None else self.opened(fact.relation.only[0].left)
                if inside is not None and has_quantity(inside):
                    return inside
            return tree

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
        if isinstance(angle, Letter):
            if self.is_of_statement(angle):
                return line, angle, self.judge.bounds(angle.name)
            quantity = self.scene.desk.meant(angle)
            if not isinstance(quantity, Quantity):
                return line, angle, ()
            name, let = self.letter_for(quantity)
            return line, angle, (self._extent(name, quantity), let)
        if not isinstance(angle, Quantity):
            return line, angle, ()
        name, let = self.letter_for(angle)
        tangent = Apply("tan", Letter(name))
        relation = equality(tangent, desk.last_link(line).right)
        # The line above is printed with the letter, too.
        number = self.judge.write(NAMED, [line, let], relation, shown="silent")
        if number is None:
            raise NotPlannedError("a letter for an angle")
        return number, Letter(name), (self._extent(name, angle), let)

    def is_of_statement(self, tree: Expression) -> bool:
        """Whether the statement has a letter for a quantity."""
        return isinstance(tree, Letter) and f"let {tree.name}" in self.scene.facts

    @staticmethod
    def _extent(name: str, angle: Quantity) -> str:
        """What is known of an angle of the motion, as a premise says it."""
        lined = angle.kind == "angle" and any(
            isinstance(argument, Name) or is_quantity(argument, "line_of_centres")
            for argument in angle.arguments
        )
        return f"0° <= {name} <= {90 if lined else 180}°"

    def is_lettered(self, angle: Quantity) -> bool:
        """Whether a letter stands for an angle of the motion."""
        named = (line.relation for line in self.scene.desk.lines)
        return any(isinstance(meaning, Meaning) and meaning.quantity == angle for meaning in named)

    def letter_for(self, angle: Quantity) -> tuple[str, int]:
        """The letter that stands for an angle of the motion, and the line that introduces it."""
        desk = self.scene.desk
        taken = set(roles(self.scene.problem))
        for line in desk.lines:
            if isinstance(line.relation, Meaning):
                if line.relation.quantity == angle:
                    return line.relation.letter, line.number
                taken.add(line.relation.letter)
        names = (*_ANGLES[angle.kind], *_FURTHER_ANGLES)
        name = next((name for name in names if name not in taken), None)
        if name is None:
            raise NotPlannedError("no letter is left for an angle")
        return name, desk.write(Move("let"), (), Meaning(name, angle))

    def axes(self, tree: Expression) -> tuple[Ref, ...]:
        """The lines of centres of the impacts in which a quantity is known."""
        refs: list[Ref] = []
        for node in walk(tree):
            match node:
                case Quantity("velocity" | "speed" | "energy", (Name(),), int()):
                    velocity = replace(node, kind="velocity")
                    body, stage = body_and_stage(self.scene, velocity)
                    refs += frame_after(self.scene, body, stage).refs
        return together(refs)

    def determine(self, tree: Expression) -> None:
        """Writes the lines by which all components in a tree are known."""
        value = self.scene.value(tree)
        parts: Iterable[Any] = value if isinstance(value, Vector) else (value,)
        if hasattr(value, "measure"):
            parts = (value.y / value.x,)
        self.solver.determine([sp.sympify(part, strict=True) for part in parts])

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
        self.determine_angle(quantity)
        return formula(self.scene, quantity)

    def angle(self, angle: Quantity) -> int:
        """Writes the tangent of an angle, with a letter that is introduced before it."""
        named, own = letter_known(self.scene, angle), self._tangent(Apply("tan", angle))
        # It may have a letter, and a line may say the tangent of that.
        if named is not None and (own is None or isinstance(named[1], str)):
            lettered = self._tangent(Apply("tan", Letter(named[0])))
            if lettered is not None:
                return self.tangent_closed(lettered)
        if own is not None or angle.kind not in _ANGLES:
            return self.quantity(angle)
        mark = self.mark()
        try:
            return self.quantity(angle, by_letter=True)
        except NotPlannedError:
            self.back(mark)
            return self.quantity(angle)

    def _tangent(self, tangent: Expression) -> int | None:
        """The line in force that says what a tangent is: the last, if there are several.

        One with a letter for an expression, S for a/t + b t, says less than the line above it, and
        so does that line, in which top and bottom of the one before are divided by a tangent.
        """
        desk = self.scene.desk
        aside = {
            line.relation.letter
            for line in desk.lines
            if isinstance(line.relation, Meaning) and not has_quantity(line.relation.quantity)
        }
        return next(
            (
                line.number
                for line in reversed(desk.lines)
                if isinstance(line.relation, Relation)
                and len(line.relation.options) == 1
                and line.relation.only[0].sign == "="
                and line.relation.only[0].left == tangent
                and not letters(line.relation.only[-1].right) & aside
                and not _is_divided(line.relation.only[-1].right)
                and desk.holds(line.number)
            ),
            None,
        )

    def angle_by_letter(self, angle: Quantity) -> int | None:
        """The line that tells the tangent of the letter for an angle, if there is one."""
        for line in self.scene.desk.lines:
            if isinstance(line.relation, Meaning) and line.relation.quantity == angle:
                tangent = self._tangent(Apply("tan", Letter(line.relation.letter)))
                return None if tangent is None else self.tangent_closed(tangent)
        return None

    def _of_letter(self, angle: Quantity) -> int | None:
        """The tangent of an angle, where a line tells that of the letter for it."""
        for other in self.scene.desk.lines:
            own = other.relation
            if isinstance(own, Meaning) and own.quantity == angle:
                line = self._tangent(Apply("tan", Letter(own.letter)))
                if line is not None:
                    value = self.scene.desk.last_link(line).right
                    relation = equality(Apply("tan", angle), value)
                    return self.judge.write(NAMED, [line, other.number], relation)
        return None

    def turned(self, angle: Quantity, by_letter: bool) -> int | None:
        """The tangent of an angle between two velocities, by their angles to one line.

        The line is the line of centres, or the wall.

        None where it is no such angle, or these are not told.
        """
        if velocities_of(self.scene, angle) is None:
            return None
        self.determine_angle(angle)
        if angle.kind == "deflection" and angle.stage in self.scene.model.frames:
            frame = self.scene.frame(angle.stage)
            line = None if frame.wall is None else tangent_at_a_wall(self.scene, angle, frame)
            if line is not None:
                return line
        for turn in turns_of(self.scene, angle):
            if by_letter and not self.name_of(angle):
                self.letter_for(angle)
            named = self.name_of(angle)
            subject: Expression = Letter(letter_of(self.scene, angle)[0]) if named else angle
            line = write_turn_tangent(self.scene, turn, subject)
            if line is not None:
                return line
        return None

    def name_of(self, angle: Quantity) -> tuple[Ref, ...]:
        """What gives an angle its letter: a fact, or a line; () where it has none."""
        for fact in self.scene.desk.facts:
            if fact.id.startswith("let ") and fact.relation.only[0].left == angle:
                return (fact.id,)
        lets = (e for e in self.scene.desk.lines if isinstance(e.relation, Meaning))
        return tuple(e.number for e in lets if e.relation.quantity == angle)[:1]  # type: ignore[union-attr]

    def determine_angle(self, angle: Quantity) -> None:
        """Writes the lines by which the components are known that make an angle."""
        if angle.kind == "deflection" and isinstance(angle.stage, int):
            (body,) = angle.arguments
            for stage in (angle.stage - 1, angle.stage):
                self.determine(Quantity("velocity", (body,), stage))
        else:
            self.determine(angle)

    def quantity(self, quantity: Quantity, by_letter: bool = False) -> int:
        """Writes what a quantity is worth, and returns the number of the line.

        ``by_letter`` gives an angle a letter, unless the statement has one for it.
        """
        scene = self.scene
        known = scene.desk.known(quantity)
        if known is not None and len(known.refs) == 1 and isinstance(known.refs[0], int):
            return self._closed(quantity, known) or known.refs[0]
        if quantity.kind in _ANGLES:
            tangent = self._tangent(Apply("tan", quantity)) or self._of_letter(quantity)
            if tangent is not None:
                return self.tangent_closed(tangent)
            line = self.turned(quantity, by_letter)
            if line is not None:
                return line
        own = self.formula(quantity)
        lost = write_loss_by_products(scene, quantity)
        if lost is not None:
            return lost
        left, extra = self.named(own, quantity)
        if by_letter and not extra:
            name, let = self.letter_for(quantity)
            left, extra = own.of(Letter(name)), (let,)
        right, final = swept(own.right), tree_of(own.value)
        match right:
            case Apply("sqrt", Binary("^", base, _)) if base == final:
                right = final
        links = [Link(left, "=", right)]
        chains = [Relation((tuple(links),))]
        if right != final:
            middle = right
            for terms in terms_between(scene, right, final):
                links.append(Link(middle, "=", terms, "rearrange"))
                middle = terms
            for by in ("rearrange", "identity"):
                chains.insert(-1, Relation(((*links, Link(middle, "=", final, by)),)))
        known_ = self.judge.known(letters(right))
        plain = together(own.refs, extra)
        wider = together(own.refs, extra, self.axes(quantity))
        pools = (plain, (*plain, *known_), wider, (*wider, *known_))
        # Of what is zero one factor is enough.
        sure = () if own.value == 0 else plain
        shown: Any = "silent" if self._is_its_letter(quantity, own) else "line"
        for relation in chains:
            for pool in dict.fromkeys(pools):
                number_ = self.judge.write((own.move,), pool, relation, sure, shown)
                if number_ is not None:
                    if own.left == quantity:
                        scene.desk.know(quantity, own.value, (number_,))
                    return number_
        raise NotPlannedError(f"a line for {quantity.kind}")

    def _closed(self, quantity: Quantity, known: Source) -> int | None:
        """The line of a known quantity in which letters that have values since are put in."""
        line, value = self._put_into(quantity, known.value, known.refs)
        if line is not None:
            self.scene.desk.know(quantity, value, (line,))
        return line

    def tangent_closed(self, line: int) -> int:
        """The line of a tangent in which letters that have values since are put in."""
        link = self.scene.desk.last_link(line)
        if has_quantity(link.right):
            return line
        return self._put_into(link.left, self.scene.scalar(link.right), (line,))[0] or line

    def _put_into(
        self, left: Expression, known: Any, refs: Sequence[Ref]
    ) -> tuple[int | None, Any]:
        """The line of a value in which letters that have values since are put in, and that value.

        None where there are no such letters.
        """
        parts = known if isinstance(known, Vector) else (known,)
        open_ = {s for part in parts for s in sp.sympify(part, strict=True).free_symbols}
        self.solver.determine(sorted(open_ & self.scene.model.final.keys(), key=str))
        value, more = self.scene.put(known)
        if value == known:
            return None, known
        own = tree_of(value, angle=not isinstance(value, Vector) and is_angle(self.scene, left))
        relation = equality(left, own)
        return self.judge.write((Move("put"),), [*refs, *more], relation), value

    def _is_its_letter(self, quantity: Quantity, own: Formula) -> bool:
        """Whether a component is what the working has a letter for, with the value of that."""
        named = in_a_frame(self.scene, quantity)
        if not isinstance(named, Quantity) or not is_named(self.scene, named):
            return False
        known = self.scene.desk.known(named)
        letter = None if known is None else self.scene.desk.known(tree_of(known.value))
        return letter is not None and letter.value == own.value

    def worth(self, tree: Expression) -> int | None:
        """The line that says what an expression of quantities is worth; None without one."""
        match tree:
            case Quantity() if place_trees.serves(tree):
                return self._of_place(tree)
            case Quantity():
                return self.quantity(tree)
            case Apply("tan", Quantity(kind) as angle) if kind in ANGLES:
                return self.quantity(angle)
            case Binary("^", Quantity("speed") as speed, Number(Fraction(numerator=2))):
                return self.squared(speed)
            case Binary("/", above, below) if has_quantity(above) and has_quantity(below):
                pair = [self.worth(above), self.worth(below)]
                if None in pair:
                    return None
                return self.valued(tree, Move("divide"), pair)  # type: ignore[arg-type]
            case Binary("/", above, below) if has_quantity(above):
                line = self.worth(above)
                return None if line is None else self.valued(tree, Move("rearrange"), [line])
            case Binary("*" | "+" | "-", _, _) if has_quantity(tree):
                mark = self.mark()
                try:
                    for quantity in self.quantities(tree):
                        self.determine(quantity)
                    return write_expression(self.scene, tree)[0]
                except NotPlannedError:
                    self.back(mark)
        return None

    def _of_place(self, tree: Quantity) -> int:
        """The line of a time, a place or a distance."""
        self.solver.determine(journeys.goals(self.scene, tree))
        return journeys.write(self.scene, tree)[0]

    def valued(self, tree: Expression, move: Move, refs: Sequence[int]) -> int | None:
        """An expression and its value, by a move from the lines of its quantities, if so."""
        value = tidy(sp.sympify(self.scene.put(self.scene.scalar(tree))[0], strict=True))
        names = symbol_names(value) & set(roles(self.scene.problem))
        relation = equality(tree, tree_of(value))
        line = self.judge.write((move,), [*refs, *self.judge.known(names)], relation)
        if line is not None:
            return line
        values = [self.scene.desk.last_link(ref).right for ref in refs]
        if move.id != "divide":
            return None
        middle = equality(tree, Binary("/", *values))
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
        standing = self._worked_out(speed)
        if standing is not None:
            relation = equality(left, final)
            known = self.judge.known(letters(right))
            line = self.judge.write((Move("rearrange"),), (standing, *known), relation)
            if line is not None:
                return line
        first = Link(left, "=", right.argument)
        known = self.judge.known(letters(right))
        for by in ("rearrange", "identity"):
            relation = Relation(((first, Link(right.argument, "=", final, by)),))
            line = self.judge.write((own.move,), [*pool, *known], relation, pool)
            if line is not None:
                return line
        return self.judge.write((own.move,), pool, Relation(((first,),)), pool)

    def _worked_out(self, speed: Quantity) -> int | None:
        """The line that says a speed and works it out; None without one."""
        desk = self.scene.desk
        for line in reversed(desk.lines):
            match line.relation:
                case Relation(((Link(left, "=", _), _, *_),)) if left == speed:
                    return line.number if desk.holds(line.number) else None
        return None

    def quantities(self, tree: Expression) -> Iterator[Quantity]:
        """The outermost quantities of a tree."""
        match tree:
            case Quantity(kind) if kind not in ("mass", "line_of_centres"):
                yield tree
            case _:
                for child in children(tree):
                    yield from self.quantities(child)

    def known_in(self, x: sp.Expr) -> tuple[Ref, ...]:
        names = symbol_names(x)
        return self.judge.known(names & set(roles(self.scene.problem)))

    def of_side(self, side: Expression) -> sp.Expr:
        """A side of an inequality in letters; a speed in one line has the sign that stands."""
        value = sp.sympify(self.scene.put(self.scene.scalar(side))[0], strict=True)
        if not value.has(sp.Abs):
            return value
        speeds = {node for node in walk(side) if is_quantity(node, "speed")}
        known = ((speed, self.scene.desk.known(speed)) for speed in speeds)
        trees: dict[Expression, Expression] = {
            speed: tree_of(source.value) for speed, source in known if source is not None
        }
        own = self.scene.put(self.scene.scalar(exchanged(side, trees)))[0]
        return sp.sympify(own, strict=True)

    def value(self, tree: Expression) -> sp.Expr:
        """What a tree of a line is worth, in letters."""
        return scene_value(self.scene, tree)


def _is_divided(tree: Expression) -> bool:
    """Whether it is a quotient whose bottom is a sum with a term over a tangent."""
    match tree:
        case Binary("/", _, below):
            return any(
                is_binary(term, "/") and is_function(term.right, "tan")
                for term in outer_terms(below)
            )
    return False
