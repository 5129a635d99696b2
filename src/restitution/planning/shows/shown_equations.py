"""An equation to be shown: of letters, of one quantity or of several."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from collections.abc import Set as AbstractSet
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial
from typing import Any

import sympy as sp

from restitution.exact import tidy
from restitution.explaining.lines.derivation import (
    Link,
    Meaning,
    Move,
    MoveId,
    Ref,
    Relation,
    equality,
)
from restitution.explaining.lines.trees import has_quantity_in, trees_of
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
    letters,
    walk,
)
from restitution.planning.angles.deflections import cosine_of_deflection
from restitution.planning.closing.complements import has_complement, without_complements
from restitution.planning.closing.letters_cleared import written_by_clearing
from restitution.planning.closing.losses_by_products import write_loss_by_products
from restitution.planning.formulas.definitions import Formula
from restitution.planning.inequalities.claims import Claims
from restitution.planning.journeys import journeys
from restitution.planning.shows.shown_angles import ShownAngles, says
from restitution.planning.shows.shown_laws import write_shown_law
from restitution.planning.shows.shown_ratios import (
    in_one_ratio,
    ratio_by_a_tangent,
    shown_by_squares,
    tangent_by_squares,
)
from restitution.planning.shows.shown_speeds import (
    components_of_data,
    multiple_of_data,
    speed_by_a_tie,
)
from restitution.planning.shows.speeds_of_angles import shown_by_speeds
from restitution.planning.shows.straight import (
    is_turned,
    shown_by_a_multiple,
    turned_round,
    without_a_detour,
)
from restitution.planning.shows.sums_expanded import with_sums_expanded
from restitution.planning.shows.values_put_in import (
    by_numbers,
    by_values_written_out,
    with_values,
)
from restitution.planning.writing import place_trees
from restitution.planning.writing.between import terms_between, with_squares_out
from restitution.planning.writing.desk import UNPLANNED, NotPlannedError, chain, together
from restitution.planning.writing.forms import (
    negative,
    product,
    square,
    swept,
    tangents_opened,
    total,
    tree_of,
)
from restitution.planning.writing.polynomials import expanded

# By these a line becomes the printed form, in the order in which they are tried.
_TO_CLEAR = (Move("rearrange"), Move("cancel"))
LAST: tuple[Move, ...] = (
    Move("rearrange"),
    Move("put"),
    Move("cancel"),
    *(Move("identity", identity) for identity in ("pythagoras", "double-angle", "sum-of-angles")),
)

_ONE, _TWO = (Number(Fraction(n)) for n in (1, 2))


class ShownEquation(ShownAngles):
    """An equation to be shown."""

    def __init__(self, claims: Claims, link: Link) -> None:
        self.claims = claims
        self.scene = claims.scene
        self.judge = claims.judge
        self.link = link
        self.relation = Relation(((link,),))

    def write(self) -> int:
        """Writes the lines, and returns the number of the last."""
        law = write_shown_law(self.scene, self.link)
        return law or without_a_detour(self.scene, self.link, self._written())

    def _written(self) -> int:
        left, right = (
            self.claims.worths.opened(side) for side in (self.link.left, self.link.right)
        )
        if not has_quantity(left) and not has_quantity(right):
            return self._of_letters()
        if isinstance(self.link.left, Letter) and not isinstance(left, Letter | Quantity):
            line = self._of_expression(self.link.left, left)
            if line is not None:
                return line
        if (line := self._of_two_angles()) is not None:
            return line
        quantities = list(dict.fromkeys(outermost_quantities(left, right)))
        subjects = [quantity for quantity in quantities if quantity in set(walk(left))]
        if subjects == quantities:
            line = shown_by_squares(self.claims.worths, self.link, quantities)
            if line is not None:
                return line
        by_speeds = shown_by_speeds(self.claims, self.link, subjects)
        if by_speeds is not None:
            return by_speeds
        if len(quantities) == 1 and len(subjects) == 1:
            line = self._of_one(quantities[0]) or self._ratio_as_asked(quantities[0])
            line = line or speed_by_a_tie(self.claims, self.link)
            if line is not None:
                return line
        line = self._speed_by_an_angle(quantities) or self._of_durations(quantities)
        if line is not None:
            return line
        standing = self.claims.worths.mark()
        try:
            return self._of_several(quantities)
        except NotPlannedError:
            self.claims.worths.back(standing)
            line = self._of_equal_angles(left, right)
            if line is None:
                raise
            return line

    def _of_durations(self, quantities: Sequence[Quantity]) -> int | None:
        """An equation of times between events, by these alone."""
        trees = [node for side in (self.link.left, self.link.right) for node in walk(side)]
        between = [tree for tree in trees if place_trees.is_duration(tree)]
        inside = [node for tree in between for node in walk(tree) if isinstance(node, Quantity)]
        if not between or sorted(map(str, inside)) != sorted(
            str(node) for node in trees if isinstance(node, Quantity)
        ):
            return None
        if any(quantity.kind != "time" for quantity in quantities):
            return None
        mark = self.claims.worths.mark()
        lines: list[int] = []
        try:
            for tree in dict.fromkeys(between):
                self.claims.worths.solver.determine(journeys.goals(self.scene, tree))
                lines.append(journeys.write(self.scene, tree)[0])
        except NotPlannedError:
            self.claims.worths.back(mark)
            return None
        if len(lines) == 1 and says(self.scene, lines[0], self.link):
            return lines[0]
        names = self._known(letters(self.link.left) | letters(self.link.right))
        moves = (Move("put"), Move("rearrange"))
        line = self.judge.write(moves, [*lines, *names], self.relation)
        if line is None:
            self.claims.worths.back(mark)
        return line

    def _of_expression(self, letter: Letter, tree: Expression) -> int | None:
        """A letter of the statement for an expression of quantities."""
        mark = self.claims.worths.mark()
        worth = self.claims.worths.worth(tree)
        if worth is not None:
            known = self.judge.known(letters(self.link.right))
            value = self.scene.desk.last_link(worth).right
            for first in (self.link, Link(letter, "=", value)):
                line = self.judge.write(
                    (Move("put"),), [f"let {letter.name}", worth, *known], Relation(((first,),))
                )
                if line is not None:
                    return line if first == self.link else self._last([line, *known])
        self.claims.worths.back(mark)
        return None

    # --- letters --------------------------------------------------------------------------------

    def _of_letters(self) -> int:
        """A relation of letters: the equation that the facts give, or the letters by themselves."""
        mark = self.claims.worths.mark()
        if self._has_component_given():
            with suppress(*UNPLANNED):
                line = self._worked_out()
                if line is not None:
                    return line
            self.claims.worths.back(mark)
        try:
            return self._of_ties()
        except UNPLANNED:
            self.claims.worths.back(mark)
            line = self._worked_out()
            if line is None:
                raise
            return line

    def _has_component_given(self) -> bool:
        """Whether a given fact says by itself what a component after an impact of spheres is."""
        scene = self.scene
        components = {own.symbol for own in scene.model.components.values()}
        for equation in scene.given:
            symbols = {s for residual in equation.residuals for s in residual.free_symbols}
            if len(symbols) == 1 and symbols <= components & scene.unknown(sp.Add(*symbols)):
                return True
        return False

    def _worked_out(self) -> int | None:
        """The letters that the facts fix, worked out as those that are asked."""
        scene = self.scene
        names = letters(self.link.left) | letters(self.link.right)
        fixed = {symbol for symbol in scene.model.final if symbol.name in names}
        free = scene.free & fixed
        scene.free -= free
        above = len(scene.desk.lines)
        try:
            for symbol in sorted(fixed & scene.unknown(sp.Add(*fixed)), key=str):
                self.claims.solver.determine([symbol])
                standing = self._standing() or self._by_its_letter() or self._on_the_way(above)
                if standing is not None:
                    return standing
            known = (scene.desk.known(Letter(symbol.name)) for symbol in fixed)
            lines = [ref for own in known if own for ref in own.refs]
            return self._last([*lines, *self.judge.known(names)]) if lines else None
        finally:
            scene.free |= free

    def _on_the_way(self, above: int) -> int | None:
        """What is to be shown, by a line on the way to a letter of it, before that is solved."""
        numbers = [equation for equation in self._equations() if equation > above]
        multiples = (shown_by_a_multiple(self.scene, self.link, n) for n in numbers)
        if (line := next(filter(None, multiples), None)) is not None:
            return line
        for number in reversed(numbers):
            relation = self.scene.desk.relation(number)
            if len(relation.options) > 1 or isinstance(relation.only[0].left, Letter):
                continue
            own = self.scene.desk.last_link(number)
            if is_turned(own, self.link):
                continue
            known = self.judge.known(letters(own.left) | letters(own.right))
            line = self.judge.write(_TO_CLEAR, [number, *known], self.relation)
            if line is not None:
                return line
        return None

    def _by_its_letter(self) -> int | None:
        """What the working has a letter for, by the line that says what that is."""
        desk = self.scene.desk
        for let in desk.lines:
            if isinstance(let.relation, Meaning) and let.relation.quantity == self.link.left:
                own = replace(self.link, left=Letter(let.relation.letter))
                line = next((e for e in self._equations() if says(self.scene, e, own)), None)
                if line is not None:
                    return self.judge.write((Move("put"),), [line, let.number], self.relation)
        return None

    def _equations(self) -> Iterator[int]:
        """The lines in force that are equations."""
        desk = self.scene.desk
        lines = (line.number for line in desk.lines if isinstance(line.relation, Relation))
        return filter(desk.holds, lines)

    def _of_ties(self) -> int:
        """The equation that the facts give, rearranged."""
        above = len(self.scene.desk.lines)
        lines = self.claims.ties.lines()
        known = self.judge.known(letters(self.link.left) | letters(self.link.right))
        standing = self._standing() or turned_round(self.scene, self.link, above)
        standing = standing or self._on_the_way(above)
        if standing is None:
            written = [number for number in self._equations() if number > above]
            standing = in_one_ratio(self.scene, written, self.link)
        if standing is not None:
            return standing
        for number in lines:
            cleared = self._cleared(number, known)
            if cleared is not None:
                return cleared
        for number in lines:
            line = by_numbers(self.claims, number, self.link, lambda n: self._last([n, *known]))
            if line is not None:
                return line
        for tie in lines:
            others = [other for other in lines if other != tie]
            line = self._last([tie, *others, *known])
            if line is not None:
                return line
        for tie in lines:
            line = self._rooted(tie, [other for other in lines if other != tie], known)
            if line is not None:
                return line
        raise NotPlannedError("a relation of letters")

    def _standing(self) -> int | None:
        """The line in force that says what is to be shown already, on the way to something else."""
        return next((e for e in self._equations() if says(self.scene, e, self.link)), None)

    def _rooted(self, line: int, others: Sequence[int], known: Sequence[Ref]) -> int | None:
        """A letter, or a ratio of one, by its square, of which the root is taken last."""
        left, right = self.link.left, self.link.right
        if not isinstance(left, Letter | Apply):
            return None
        squared = chain(square(left), (tree_of(tidy(self.scene.scalar(right) ** 2)), None))
        mark = self.scene.desk.mark()
        middle = self.judge.write(LAST, [line, *others, *known], squared)
        if middle is not None:
            root = self.judge.write((Move("rearrange"),), [middle, *known], self.relation)
            if root is not None:
                return root
            both = Relation(((self.link,), (Link(left, "=", negative(right)),)))
            roots = self.judge.write((Move("roots"),), [middle, *known], both)
            if roots is not None:
                root = self.judge.write((Move("reject"),), [roots, *known], self.relation)
            if root is not None:
                return root
        self.scene.desk.back(mark)
        return None

    def _cleared(self, line: int, known: Sequence[Ref]) -> int | None:
        """A square that is a quotient of letters, from a line into which values were put.

        What is divided by stands on the other side first.
        """
        match self.link:
            case Link(Binary("^") as power, "=", Binary("/", above, below)) if letters(below):
                pass
            case _:
                return None
        desk = self.scene.desk
        own = desk.line(line)
        base, *_ = (ref for ref in (*own.premises, 0) if isinstance(ref, int))
        if own.relation != self.relation or own.move.id != "rearrange" or line != len(desk.lines):
            return None
        if not base or desk.line(base).move.id != "put":
            return None
        desk.lines.pop()
        between = chain(swept(product(below, power)), (above, None))
        first = self.judge.write(_TO_CLEAR, [base, *known], between)
        last = None if first is None else self._last([first, *known])
        if last is None:
            del desk.lines[line - 1 :]
            desk.lines.append(own)
            return None
        if desk.known(power) is not None:
            desk.know(power, self.scene.scalar(self.link.right), (last,))
        return last

    def _last(self, pool: Sequence[Ref]) -> int | None:
        if pool and isinstance(pool[0], int) and not has_complement(self.link):
            pool = (without_complements(self.scene, pool[0]), *pool[1:])
        cleared = written_by_clearing(self.scene, self.judge, pool, self.link)
        if cleared is not None:
            return cleared
        if (tangent := tangent_by_squares(self.scene, pool, self.link)) is not None:
            return tangent
        mark = self.claims.worths.mark()
        halves = self._by_double_angle(pool)
        if halves is not None:
            line = self.judge.write((Move("rearrange"),), [halves, *pool[1:]], self.relation)
            if line is not None:
                return line
            self.claims.worths.back(mark)
        line = self._by_tangent_of_double(pool) or self.judge.write(LAST, pool, self.relation)
        if line is not None:
            return with_sums_expanded(self.scene, self.judge, line, self.link)
        # What divides a side may vanish by its role, and not as bodies approach.
        story = [ref for ref in self.scene.facts if ref.startswith(("approach ", "velocity "))]
        line = self.judge.write((Move("rearrange"),), [*pool, *story], self.relation)
        if line is not None:
            return line
        # Letters that have values were put in on the way; others are tied by what is given.
        names = letters(self.link.left) | letters(self.link.right)
        for fact in (self.scene.facts[ref] for ref in pool if ref in self.scene.facts):
            names |= {name for tree in trees_of(fact.relation) for name in letters(tree)}
        trees: list[Expression] = [Letter(name) for name in sorted(names)]
        ratios = [Apply(ratio, own) for own in trees for ratio in ("sin", "cos", "tan")]
        known = (self.scene.desk.known(tree) for tree in (*trees, *ratios))
        refs = [ref for own in known if own is not None for ref in own.refs]
        refs += self._between_letters()
        if not refs:
            return None
        line = by_values_written_out(self.scene, self.judge, pool, refs, self.link)
        return line or self.judge.write((Move("put"),), [*pool, *refs], self.relation)

    def _by_double_angle(self, pool: Sequence[Ref]) -> int | None:
        """The squares of the sine and of the cosine of an angle, by the cosine of twice that."""
        first = pool[0] if pool else None
        doubles = {
            node.argument.right
            for node in walk(self.link.right)
            if is_function(node, "cos")
            and isinstance(node.argument, Binary)
            and (node.argument.op, node.argument.left) == ("*", _TWO)
        }
        if not isinstance(first, int) or len(doubles) != 1:
            return None
        link, (angle,) = self.scene.desk.last_link(first), doubles
        if link.left != self.link.left or has_quantity(link.right):
            return None
        own = expanded(self.scene.scalar(link.right))
        value = self.scene.scalar(angle)
        terms: list[Expression] = []
        twice = Apply("cos", Binary("*", _TWO, angle))
        for ratio, double in (
            (sp.sin(value), Binary("-", _ONE, twice)),
            (sp.cos(value), Binary("+", _ONE, twice)),
        ):
            factor = own.coeff(ratio, 2)
            if factor == 0:
                return None
            own = expanded(own - factor * ratio**2)
            number, rest = tidy(factor / 2).as_coeff_Mul()
            terms.append(product(tree_of(number), tree_of(rest), double))
        if own != 0:
            return None
        middle = chain(self.link.left, (total(terms), None))
        return self.judge.write((Move("identity", "double-angle"),), pool, middle)

    def _by_tangent_of_double(self, pool: Sequence[Ref]) -> int | None:
        """The form by way of a line that has the tangent of a double angle by its formula."""
        first = pool[0] if pool else None
        if not isinstance(first, int) or len(self.scene.desk.relation(first).options) != 1:
            return None
        own = self.scene.desk.last_link(first)
        left, right = tangents_opened(own.left, own.right)
        middle = Link(left, "=", right)
        if own.sign != "=" or (own.left, own.right) == (middle.left, middle.right):
            return None
        mark = self.claims.worths.mark()
        names = self.judge.known(letters(own.left) | letters(own.right))
        identity = (Move("identity", "double-angle"),)
        line = self.judge.write(identity, [first, *names], Relation(((middle,),)))
        if line is None or middle == self.link:
            return line
        last = self.judge.write(_TO_CLEAR, [line, *names, *pool[1:]], self.relation)
        if last is None:
            self.claims.worths.back(mark)
        return last

    def _known(self, names: AbstractSet[str]) -> tuple[Ref, ...]:
        """What may be cited of letters: their ranges, and what the statement lets them be."""
        facts = self.scene.facts
        lets = {name: facts[f"let {name}"] for name in sorted(names) if f"let {name}" in facts}
        inside = {
            name for fact in lets.values() for name in letters(fact.relation.only[0].left)
        } | {name for fact in lets.values() for name in letters(fact.relation.only[0].right)}
        return (*(let.id for let in lets.values()), *self.judge.known(names | inside))

    def _between_letters(self) -> list[Ref]:
        """The given equations between letters."""
        return [
            equation.fact.id
            for equation in self.scene.given
            if equation.link.sign == "=" and not has_quantity_in(equation.fact.relation)
        ]

    # --- one quantity ---------------------------------------------------------------------------

    def _of_one(self, quantity: Quantity) -> int | None:
        claims = self.claims
        line = self._turned(quantity)
        if line is not None:
            return line
        own = claims.worths.formula(quantity)
        if quantity == self.link.left and (line := self._loss(quantity)) is not None:
            return line
        match self.link.left:
            case Apply("cos", _) if quantity.kind == "deflection":
                own = cosine_of_deflection(self.scene, quantity)
        left, extra = claims.worths.named(own, quantity)
        for axes in ((), claims.worths.axes(quantity)):
            line = self._by_definition(own, left, extra, together(own.refs, extra, axes))
            if line is not None:
                return line
        return None

    def _loss(self, quantity: Quantity) -> int | None:
        """The energy that an impact takes, by products where its squares are long."""
        mark = self.claims.worths.mark()
        lost = write_loss_by_products(self.scene, quantity)
        if lost is None or says(self.scene, lost, self.link):
            return lost
        names = self._known(letters(self.link.right))
        line = self._last([lost, *names])
        if line is None:
            self.claims.worths.back(mark)
        return line

    def _by_definition(
        self, own: Formula, left: Expression, extra: tuple[Ref, ...], pool: Sequence[Ref]
    ) -> int | None:
        right = swept(own.right)
        squared = own.move.record == "speed" and isinstance(right, Apply)
        for subject, start in (
            (left, right),
            *(((square(left), right.argument),) if squared else ()),  # type: ignore[union-attr]
        ):
            begin: Expression | None = start if subject == self.link.left else None
            match self.link.left:
                case Binary("/", above, below) if above == subject and not has_quantity(below):
                    begin = Binary("/", start, below)  # v²/u² is worked out at once
            line = None if begin is None else self._defined(own, begin, pool)
            if line is not None:
                return line
        # The quantity as it is defined, and then the printed form.
        defined = self.judge.write((own.move,), pool, equality(left, right))
        if defined is None:
            return None
        known = self._known(letters(right) | letters(self.link.right))
        return self._last([defined, *extra, *known])

    def _defined(self, own: Formula, start: Expression, pool: Sequence[Ref]) -> int | None:
        """The printed form as the last link of the definition, or as a line under it."""
        left, right = self.link.left, self.link.right
        known = self._known(letters(start) | letters(right))
        if start == right or _is_root_of_a_square(start):
            line = self.judge.write((own.move,), [*pool, *known], self.relation, own.refs)
            if line is not None or start == right:
                return line
        first = Link(left, "=", start)
        mark = self.scene.desk.mark()
        number = self.judge.write((own.move,), pool, Relation(((first,),)), own.refs)
        if number is None:
            return None
        between = () if has_quantity(right) else terms_between(self.scene, start, right)
        for by in ("rearrange", "identity"):
            steps: list[tuple[Expression, MoveId]] = [(tree, "rearrange") for tree in between]
            relation = chain(left, (start, None), *steps, (right, by))
            move = replace(own.move)
            if by == "identity" or self.judge.follows(move, pool, relation):
                refs = self.judge.needed(move, [*pool, *known], relation, own.refs)
                if refs is not None:
                    self.scene.desk.back(mark)
                    return self.scene.desk.write(move, refs, relation)
        whole = swept(own.right)
        squared = is_function(whole, "sqrt") and start == whole.argument
        if isinstance(own.value, sp.Expr) and (squared or start == whole):
            value = own.value**2 if squared else own.value
            simple = with_squares_out(tidy(value))
            relation = Relation(((first, Link(start, "=", simple, "rearrange")),))
            refs = self.judge.needed(own.move, [*pool, *known], relation, own.refs)
            if refs is not None and number == len(self.scene.desk.lines):
                self.scene.desk.back(mark)
                number = self.scene.desk.write(own.move, refs, relation)
        return self._last([number, *known])

    # --- several --------------------------------------------------------------------------------

    def _of_several(self, quantities: Sequence[Quantity]) -> int:
        scene, claims = self.scene, self.claims
        lines: list[int] = []
        facts: list[Ref] = []
        for quantity in filter(claims.worths.is_data, quantities):
            own = components_of_data(scene, quantity)
            facts += claims.worths.data_of(quantity) if own is None else own
        for quantity in quantities:
            if not claims.worths.is_data(quantity):
                lines.append(claims.worths.quantity(quantity))
        names = letters(self.link.left) | letters(self.link.right)
        known = self._known(names)
        if len(lines) == 3:
            line = ratio_by_a_tangent(claims.worths, self.link, lines)
            if line is not None:
                last = self._last([line, *known])
                if last is not None:
                    return last
        if len(lines) == 1 and facts:
            between = multiple_of_data(claims, self.link, lines[0])
            last = None if between is None else self._last([between, *facts, *known])
            if last is not None:
                return last
        if len(lines) == 2 and is_binary(self.link.left, "/"):
            line = self._by_pair(Move("divide"), lines, known)
            if line is not None:
                return line
        values = partial(with_values, claims.worths, self.link, quantities, lines)
        for first in lines:
            rest = [number for number in lines if number != first]
            line = self._last([first, *rest, *facts, *known])
            if line is not None:
                return line if facts else values(line)
        if len(lines) == 2:
            squares = Move("square-add")
            if self.judge.follows(squares, lines, self.relation):
                return values(scene.desk.write(squares, lines, self.relation))
            for move in (Move("divide"), Move("combine")):
                for pair in (lines, lines[::-1]):
                    line = self._by_pair(move, pair, known)
                    if line is not None:
                        return line
        raise NotPlannedError("an equation of several quantities")

    def _by_pair(self, move: Move, pair: Sequence[int], known: Sequence[Ref]) -> int | None:
        """The quotient, or the sum, of two quantities."""
        scene = self.scene
        values = [scene.desk.last_link(number).right for number in pair]
        # What is divided by must not vanish, whatever the letters in it are.
        known = together(known, self._known(letters(values[0]) | letters(values[1])))
        op: Any = "/" if move.id == "divide" else "+"
        first = Link(self.link.left, "=", Binary(op, values[0], values[1]))
        middle = Relation(((first,),))
        whole = chain(first.left, (first.right, None), (self.link.right, "rearrange"))
        for relation in (whole, self.relation):
            refs = self.judge.enough(move, pair, relation, known)
            if refs is not None:
                return scene.desk.write(move, refs, relation)
        refs = self.judge.enough(move, pair, middle, known)
        if refs is None:
            return None
        number = scene.desk.write(move, refs, middle)
        return self._last([number, *known])


def _is_root_of_a_square(tree: Expression) -> bool:
    """Whether a root is that of one square, and is what is squared."""
    match tree:
        case Apply("sqrt", Binary("^", _, Number(Fraction(numerator=2, denominator=1)))):
            return True
    return False


def outermost_quantities(*trees: Expression) -> Iterator[Quantity]:
    """The outermost quantities of trees."""
    for tree in trees:
        match tree:
            case Quantity(kind) if kind != "mass":
                yield tree
            case Quantity() | Letter() | Number() | Name():
                continue
            case _:
                yield from outermost_quantities(*children(tree))
