"""Equations that tie letters of the statement to each other, by what is given."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from fractions import Fraction

import sympy as sp

from restitution.components.verdicts import proved_sign
from restitution.exact import tidy
from restitution.exact.symbols import symbol_names
from restitution.explaining.lines.derivation import (
    FLIPPED,
    Link,
    Move,
    Ref,
    Relation,
    Sign,
    equality,
)
from restitution.explaining.lines.trees import has_quantity_in
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    has_quantity,
    is_function,
    letters,
    walk,
)
from restitution.planning.closing.collecting import multiplied_out
from restitution.planning.closing.complements import without_complements
from restitution.planning.closing.gathered_squares import one_square_a_side
from restitution.planning.closing.letters_cleared import written_by_clearing
from restitution.planning.closing.ratios import with_the_sum_of_squares
from restitution.planning.formulas.impacts import residual
from restitution.planning.inequalities.worths import Worths
from restitution.planning.routes.givens import write_given
from restitution.planning.writing.desk import UNPLANNED, Source, chain
from restitution.planning.writing.forms import ZERO, product, square, total, tree_of
from restitution.planning.writing.inequalities import (
    bounds,
    certain,
    isolated,
    linear_in,
    without_signs,
)
from restitution.planning.writing.one_tangent import write_by_single_tangents
from restitution.planning.writing.polynomials import (
    cancelled,
    derivative,
    expanded,
    factored,
    one_fraction,
    polynomial_in,
)
from restitution.planning.writing.scene import GivenEquation
from restitution.solving.story.letters import roles


class Ties:
    """The equations between letters that a part gives."""

    def __init__(self, worths: Worths) -> None:
        self.worths = worths
        self.scene = worths.scene
        self.solver = worths.solver
        self.judge = worths.judge
        self._lines: list[int] | None = None

    def clear(self) -> None:
        """Forgets what has been taken away again."""
        self._lines = None

    def lines(self) -> list[int]:
        """The equations between letters that the facts give, as lines."""
        if self._lines is None:
            # Alternatives tie no letters: which of them holds is said by another line.
            own = list(self._written_ties())
            self._lines = [e for e in own if len(self.scene.desk.relation(e).options) == 1]
        return self._lines

    def _written_ties(self) -> Iterator[int]:
        scene = self.scene
        known = [scene.desk.known(Letter(value.name)) for value in self._linked()]
        # A number ties a letter to no other.
        tied = [own for own in known if own and sp.sympify(own.value, strict=True).free_symbols]
        lines = [ref for own in tied for ref in own.refs if isinstance(ref, int)]
        if lines:
            plain = dict.fromkeys(self._without_roots(number) for number in lines)
            yield from map(self._with_complements, plain)
            return
        none = True
        for given in scene.given:
            line = self._trial(lambda equation=given: self._tie(equation))  # type: ignore[misc]
            if line is not None:
                none = False
                yield self._with_values(self._without_complement(line))
        if none:
            for symbol in self._linked():
                line = self._trial(lambda symbol=symbol: self._closed(symbol))  # type: ignore[misc]
                if line is not None:
                    yield line

    def _without_roots(self, line: int) -> int:
        """An equation, or the one above it of which it gives a root, or the angle."""
        desk = self.scene.desk
        number = line
        while desk.line(number).move.id == "inverse" or _has_root(desk.relation(number)):
            above = [
                ref
                for ref in desk.line(number).premises
                if isinstance(ref, int) and isinstance(desk.line(ref).relation, Relation)
            ]
            if not above:
                return line
            number = above[0]
        own = desk.relation(number)
        names = {n for e in own.options[0] for side in (e.left, e.right) for n in letters(side)}
        known = set(roles(self.scene.problem))
        plain = len(own.options) == 1 and names <= known and not has_quantity_in(own)
        if not plain or number == line:
            return line
        return self._neat(number)

    def _linked(self) -> list[sp.Symbol]:
        return sorted(self.scene.free, key=lambda value: value.name)

    def _trial(self, attempt: Callable[[], int | None]) -> int | None:
        """What an attempt writes; nothing stays of one that leads nowhere."""
        mark = self.worths.mark()
        try:
            line = attempt()
        except UNPLANNED:
            line = None
        if line is None:
            self.worths.back(mark)
        return line

    def _tie(self, equation: GivenEquation) -> int | None:
        """A given fact as an equation between letters of the statement."""
        scene = self.scene
        components = {own.symbol for own in scene.model.components.values()}
        inside = {s for x in equation.residuals for s in sp.sympify(x, strict=True).free_symbols}
        relation = scene.ties.get(equation.fact.id)
        written = None if relation is None else self.judge.standing(relation)
        shown = self.shown_by(equation.fact.id)
        if written is not None:
            return written if shown is None else self._without_roots(self._neat(shown))
        if equation.fact.id in self.solver.equations.used:
            return self._of_fact(equation.fact.id)
        law = None if shown else self.solver.tie_by_zero(equation)
        if law is not None:
            line = self._without_roots(self._neat(law))
            scene.ties[equation.fact.id] = scene.desk.relation(line)
            return line
        self.solver.equations.used.add(equation.fact.id)
        self.solver.determine(sorted(inside & components, key=str))
        self.solver.equations.used.discard(equation.fact.id)
        open_ = [scene.put(x)[0] for x in equation.residuals]
        if all(x == 0 for x in open_):
            return self._of_fact(equation.fact.id)
        given = (shown and self.with_numbers(shown)) or shown or self._of_fact(equation.fact.id)
        if given is None:
            given = self._as_found(write_given(scene, _as_right_angle(equation)))
        line = self._without_roots(self._neat(given))
        scene.ties[equation.fact.id] = scene.desk.relation(line)
        return line

    def _without_complement(self, line: int) -> int:
        """An equation of tan(90° − α) as one of tan² α, where that stands alone; else as it is."""
        scene, plain = self.scene, without_complements(self.scene, line)
        if plain == line:
            return line
        own = residual(scene, plain)
        angles = {function.args[0] for function in own.atoms(sp.sin, sp.cos, sp.tan)}
        if len(angles) != 1:
            return plain
        (angle,) = angles
        tangent, cosine = sp.Dummy("t", positive=True), sp.Dummy("c", positive=True)
        put = {sp.sin(angle): tangent * cosine, sp.cos(angle): cosine, sp.tan(angle): tangent}
        above = sp.fraction(cancelled(one_fraction(own.xreplace(put))))[0]
        if cosine in above.free_symbols or set(polynomial_in(above, tangent).monoms()) != {
            (2,),
            (0,),
        }:
            return plain
        factors = polynomial_in(above, tangent)
        value = tidy(-factors.nth(0) / factors.nth(2))
        relation = chain(square(Apply("tan", tree_of(angle))), (tree_of(value), None))
        known = self.judge.known(letters(relation.only[0].right))
        return self.judge.write((Move("rearrange"),), [plain, *known], relation) or plain

    def _with_complements(self, line: int) -> int:
        """An equation for a letter, in which an angle is put in that is given as a complement.

        It is the same equation where it has no such angle.
        """
        scene, link = self.scene, self.scene.desk.last_link(line)
        if has_quantity(link.right) or not letters(link.right) & scene.complements.keys():
            return line
        mark, known = self.worths.mark(), scene.desk.known(link.left)
        if known is None or line not in known.refs:
            known = Source(scene.scalar(link.right))
        put, refs = scene.put(known.value)  # in tangents, where its line was written so
        relation = equality(link.left, tree_of(put))
        number = self.judge.write((Move("put"),), [line, *refs], relation)
        if number is None:
            self.worths.back(mark)
            return line
        return number

    def _with_values(self, line: int) -> int:
        """An equation for a letter with values put in that are known since; else as it is."""
        scene = self.scene
        link = scene.desk.last_link(line)
        if has_quantity(link.right):
            return line
        right = sp.sympify(scene.scalar(link.right), strict=True)
        numbers, refs = self._numbers(right, letters(link.left))
        if not numbers:
            return line
        put = tree_of(tidy(right.xreplace(numbers)))
        relation = equality(link.left, put)
        return self.judge.write((Move("put"),), [line, *refs], relation) or line

    def with_numbers(self, line: int) -> int | None:
        """An equation with the numbers put in on both sides that are given for letters of it."""
        link = self.scene.desk.last_link(line)
        if has_quantity(link.left) or has_quantity(link.right):
            return None
        sides = [sp.sympify(self.scene.scalar(e), strict=True) for e in (link.left, link.right)]
        numbers, refs = self._numbers(sp.Add(*sides, evaluate=False), frozenset())
        left, right = (tidy(side.xreplace(numbers)) for side in sides)
        if not numbers or not left.free_symbols | right.free_symbols:
            return None
        relation = equality(tree_of(left), tree_of(right))
        return self.judge.write((Move("put"),), [line, *refs], relation)

    def _numbers(
        self, value: sp.Expr, apart: frozenset[str]
    ) -> tuple[dict[sp.Symbol, sp.Expr], list[Ref]]:
        """The numbers that are given for letters of a value, but for some, and by what facts."""
        scene = self.scene
        numbers: dict[sp.Symbol, sp.Expr] = {}
        refs: list[Ref] = []
        for given in scene.given:
            match given.link:
                case Link(Letter(name), "=", right) if not letters(right) and not has_quantity(
                    right
                ):
                    symbol = scene.model.unknowns.letter(name)
                    if symbol in value.free_symbols and name not in apart:
                        numbers[symbol] = sp.sympify(scene.scalar(right), strict=True)
                        refs.append(given.fact.id)
        return numbers, refs

    def shown_by(self, ref: Ref) -> int | None:
        """The equation between letters of the statement that an earlier item shows by a fact.

        Another part may be given the same in its own words.
        """
        desk, fact = self.scene.desk, self.scene.facts.get(str(ref))
        known = set(roles(self.scene.problem))
        same = {ref, *(own.id for own in desk.facts if fact and own.relation == fact.relation)}
        free = {value.name for value in self.scene.free}
        for number in desk.shown:
            own = desk.relation(number)
            if not desk.holds(number) or len(own.options) > 1 or not same & desk.under(number):
                continue
            link = own.only[-1]
            names = letters(link.left) | letters(link.right)
            plain = names <= known and not has_quantity_in(own)
            if len(own.only) == 1 and link.sign == "=" and plain and names & free:
                return number
        return None

    def _as_found(self, line: int) -> int:
        """An equation as a line below it has it that an item ends with; else as it is."""
        desk = self.scene.desk
        for number in desk.shown:
            if desk.holds(number) and line in desk.under(number):
                if not (own := residual(self.scene, line)):
                    continue
                share = tidy(residual(self.scene, number) / own)
                if share.is_number and share.is_nonzero:
                    return number
        return line

    def _of_fact(self, ref: Ref) -> int | None:
        """The first equation between letters alone that stands below a given fact."""
        desk = self.scene.desk
        known = set(roles(self.scene.problem))
        free = {value.name for value in self.scene.free}
        below: set[Ref] = {ref}
        for line in desk.lines:
            own = line.relation
            if not isinstance(own, Relation) or not below & set(line.premises):
                continue
            below.add(line.number)
            if len(own.options) > 1 or len(own.only) > 1 or own.only[0].sign != "=":
                continue
            names = {n for side in (own.only[0].left, own.only[0].right) for n in letters(side)}
            plain = names <= known and not has_quantity_in(own) and not _has_root(own)
            if plain and names & free and desk.holds(line.number):
                return self._neat(line.number)
        return None

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
        return next((line for line in lines if isinstance(line, int)), None)

    def _neat(self, line: int) -> int:
        """The equation without common factors, where it stands as one that is zero."""
        scene = self.scene
        if _has_two_tangents(scene.desk.last_link(line)):
            line = write_by_single_tangents(scene, line) or line
        own = scene.desk.last_link(line)
        if is_letter_or_square(own.left) and not letters(own.left) & letters(own.right):
            return line
        whole = factored(one_fraction(residual(scene, line)))
        above = sp.fraction(whole)[0]
        kept = sp.Mul(*(x for x in sp.Mul.make_args(above) if not certain(self.scene, x)))
        symbols = [s for s in kept.free_symbols if s.name in roles(scene.problem)]
        beside = _beside_the_path(own)
        for symbol in sorted(symbols, key=lambda own: (own.name not in beside, *self.rank(own))):
            form = isolated(self.scene, kept, symbol)
            if form is None:
                continue
            generator, value = form
            relation = equality(generator, tree_of(value))
            if scene.desk.relation(line) == relation:
                return line
            known = self.judge.known(symbol_names(whole))
            moves = (Move("rearrange"), Move("cancel"), Move("identity", "pythagoras"))
            mark = self.worths.mark()
            for between in (self._in_factors, self._gathered, lambda own, _: own):
                start = between(line, symbol)
                neat = None if start is None else self.judge.write(moves, [start, *known], relation)
                if neat is not None:
                    return neat
                self.worths.back(mark)
        return line

    def _in_factors(self, line: int, symbol: sp.Symbol) -> int | None:
        """A quadratic in a letter, multiplied out and as a product with a positive factor.

        None of another equation.
        """
        start = multiplied_out(self.scene, line, symbol)
        whole = sp.fraction(factored(one_fraction(residual(self.scene, start))))[0]
        factors = [x for x in sp.Mul.make_args(whole) if symbol in x.free_symbols]
        linear = [x.is_polynomial(symbol) and sp.degree(x, symbol) == 1 for x in factors]
        signed = [certain(self.scene, x) is not None for x in factors]
        if start == line or not all(linear) or sorted(signed) != [False, True]:
            return None
        polynomials = [polynomial_in(x, symbol) for x in factors]
        trees = [
            total((product(tree_of(x.nth(1)), Letter(symbol.name)), tree_of(expanded(x.nth(0)))))
            for x in polynomials
        ]
        known = self.judge.known(symbol_names(whole))
        moves = (Move("rearrange"), Move("cancel"))
        standard = self.judge.write(moves, [start, *known], _standard_form(polynomials, symbol))
        relation = equality(product(*trees), ZERO)
        return self.judge.write(moves, [standard or start, *known], relation)

    def _gathered(self, line: int, symbol: sp.Symbol) -> int:
        """The equation with like terms put together: squares of ratios of an angle, or brackets."""
        if roles(self.scene.problem)[symbol.name].kind == "angle":
            whole = with_the_sum_of_squares(self.scene, line, symbol) or line
            known = self.judge.known([symbol.name])
            squares = one_square_a_side(self.scene, whole, symbol, known)
            if squares != line or not self._is_linear_in_ratios(line, symbol):
                return squares
        return multiplied_out(self.scene, line, symbol)

    def _is_linear_in_ratios(self, line: int, symbol: sp.Symbol) -> bool:
        """Whether both sides are sums of multiples of the sine and the cosine of an angle.

        Of products of them, what both sides share is divided out first.
        """
        link = self.scene.desk.last_link(line)
        whole = sp.expand(self.scene.scalar(link.left) - self.scene.scalar(link.right))
        ratios = (sp.sin(symbol), sp.cos(symbol))
        if symbol in whole.xreplace(dict.fromkeys(ratios, sp.S.One)).free_symbols:
            return False
        return bool(whole.is_polynomial(*ratios)) and sp.Poly(whole, *ratios).total_degree() == 1

    def rank(self, symbol: sp.Symbol) -> tuple[int, str]:
        kind = roles(self.scene.problem)[symbol.name].kind
        return ({"angle": 0, "positive": 1, "restitution": 2}.get(kind, 3), symbol.name)

    def subject(self, line: int, letter: str, ratio: Expression | None = None) -> int | None:
        """An equation with a letter, or a ratio of it, as its subject.

        None where it is not linear in it.
        """
        link, wanted = self.scene.desk.last_link(line), ratio or Letter(letter)
        if link.left == wanted:
            return line
        own = self.scene.desk.line(line)
        if isinstance(link.left, Letter) and own.move.id == "rearrange" and len(own.premises) == 1:
            # The other letter need not stand alone first.
            (above,) = own.premises
            if isinstance(above, int) and self._ties_letters(above):
                line, link = above, self.scene.desk.last_link(above)
        x = sp.fraction(one_fraction(self.worths.value(link.left) - self.worths.value(link.right)))[
            0
        ]
        symbol = roles(self.scene.problem)[letter].symbol(letter)
        form = isolated(self.scene, expanded(x), symbol)
        if form is None or form[0] != wanted:
            return None
        alone = Link(form[0], "=", tree_of(form[1]))
        pool = [line, *self.worths.known_in(x)]
        cleared = written_by_clearing(self.scene, self.judge, pool, alone)
        moves = (Move("rearrange"), Move("cancel"))
        return cleared or self.judge.write(moves, pool, equality(alone.left, alone.right))

    def _ties_letters(self, line: int) -> bool:
        """Whether a line is an equation between letters, and no choice of several."""
        relation = self.scene.desk.relation(line)
        return len(relation.options) == 1 and not has_quantity_in(relation)

    def _gap(self, link: Link) -> sp.Expr:
        """Left minus right of an equation, without its denominators."""
        left, right = (self.worths.value(side) for side in (link.left, link.right))
        return sp.fraction(one_fraction(left - right))[0]

    def derived(self, line: int, gone: sp.Symbol) -> list[tuple[Sign, sp.Expr, Sign]]:
        """What the range of one letter says of the others in an equation: ``P sign 0``."""
        link = self.scene.desk.last_link(line)
        x = sp.fraction(one_fraction(self.worths.value(link.left) - self.worths.value(link.right)))[
            0
        ]
        role = roles(self.scene.problem)[gone.name]
        form = linear_in(expanded(x), gone, role.kind == "angle")
        if form is None:
            return []
        _, generator, a, b = form
        ties: list[tuple[Sign, sp.Expr, Sign]] = []
        for sign, bound in bounds(role, generator, gone):
            gap = factored(one_fraction(-b / a - bound))
            own = without_signs(self.scene, gap, sign)
            if own is not None and own[1].free_symbols:
                ties.append((*own, sign))
        return ties

    def _slope(self, x: sp.Expr, symbol: sp.Symbol) -> int | None:
        """Whether an expression grows with a letter, or falls; None where that is open."""
        above, below = sp.fraction(factored(one_fraction(derivative(x, symbol))))
        odd = [factor for factor in sp.Mul.make_args(below) if not factor.as_base_exp()[1].is_even]
        # At an end of its range the slope may be zero, as that of a square is.
        return proved_sign(self.scene.model.inside, above / sp.Mul(*odd)) or None

    def put_in(self, line: int, gone: sp.Symbol, sign: Sign) -> Link | None:
        """An equation of which one side is a letter, or a ratio of it, with its bound in place.

        A bound of zero is told by the sign of the other side; that has a line of its own where it
        is a quotient with letters below.
        """
        link = self.scene.desk.last_link(line)
        role = roles(self.scene.problem)[gone.name]
        for side, other in ((link.left, link.right), (link.right, link.left)):
            generator = _ratio_of(side, gone)
            form = linear_in(expanded(self.worths.value(side)), gone, role.kind == "angle")
            if generator is None and form is not None and form[2] == 1 and form[3] == 0:
                generator = form[1]
            if generator is None or gone.name in letters(other):
                continue
            ends = [bound for own, bound in bounds(role, generator, gone) if own == sign]
            if ends and letters(other) and (ends[0] != 0 or _has_letters_below(other)):
                return Link(other, sign, tree_of(ends[0]))
        return None

    def bounded(self, line: int, gone: sp.Symbol, sign: Sign) -> Link | None:
        """An equation of which one side only holds a letter, with its bound put in there."""
        link = self.scene.desk.last_link(line)
        sides = [(link.left, link.right), (link.right, link.left)]
        for kept, other in sides:
            x = self.worths.value(other)
            if gone.name in letters(kept) or gone not in x.free_symbols or not letters(kept):
                continue
            role = roles(self.scene.problem)[gone.name]
            above, below = sp.fraction(one_fraction(x))
            form = None
            if gone not in below.free_symbols:
                form = linear_in(expanded(above), gone, role.kind == "angle")
            if form is not None:
                generator, slope = form[1], certain(self.scene, form[2] / below)
            elif role.kind != "angle":
                generator, slope = gone, self._slope(x, gone)
            elif (ratio := _one_ratio_in(x, gone)) is not None:
                t = sp.Dummy("t", positive=True)
                of_ratio = derivative(x.subs(ratio, t), t).subs(t, ratio)
                generator, slope = ratio, certain(self.scene, factored(one_fraction(of_ratio)))
            else:
                return None
            ends = [bound for own, bound in bounds(role, generator, gone) if own == sign]
            if slope is None or not ends:
                return None
            t = sp.Dummy("t")
            at_end = one_fraction(x).subs(generator, t).subs(t, ends[0])
            if at_end.has(sp.zoo, sp.oo, sp.nan) or gone in at_end.free_symbols:
                return None
            value = tidy(factored(at_end))
            if is_square(kept) and value.is_number and value.is_negative:
                return None  # that holds of every square
            return Link(kept, sign if slope > 0 else FLIPPED[sign], tree_of(value))
        return None


def _beside_the_path(link: Link) -> AbstractSet[str]:
    """The letters of an offset, in the sine of the angle that it tells; none of another equation.

    The offset is told by the distance of the centres, and not the other way round.
    """
    match link:
        case Link(Apply("sin", Letter()), "=", Binary("/", beside, _)):
            return letters(beside)
    return frozenset()


def _as_right_angle(equation: GivenEquation) -> GivenEquation:
    """A deflection of 90° as a right angle between the velocities before and after."""
    match equation.link:
        case Link(Quantity("deflection", (Name(),) as body, int(stage)), "=", Degrees(value)):
            if value == 90:
                later, early = (Quantity("velocity", body, k) for k in (stage, stage - 1))
                return replace(equation, link=Link(early, "perpendicular to", later))
    return equation


def _one_ratio_in(x: sp.Expr, angle: sp.Symbol) -> sp.Expr | None:
    """The one ratio of an angle in an expression, or its square; None where there are others."""
    ratios = {f for f in x.atoms(sp.Function) if angle in f.free_symbols}
    if len(ratios) != 1:
        return None
    (ratio,) = ratios
    if ratio.args != (angle,) or not isinstance(ratio, sp.sin | sp.cos | sp.tan):
        return None
    t = sp.Dummy("t", positive=True)
    put = x.subs(ratio, t)
    if not put.is_rational_function(t):
        return None
    powers = {p.exp for p in put.atoms(sp.Pow) if p.base == t}
    return (
        ratio**2
        if powers
        and all(p % 2 == 0 for p in powers)
        and t not in (put.subs({t**p: sp.Dummy() for p in powers}).free_symbols)
        else ratio
    )


def is_square(tree: Expression) -> bool:
    """Whether a side is the square of something."""
    match tree:
        case Binary("^", _, Number(Fraction(numerator=2, denominator=1))):
            return True
    return False


def _has_two_tangents(link: Link) -> bool:
    """Whether in an equation there are the tangents of an angle and of twice it."""
    tangents = {
        node.argument
        for side in (link.left, link.right)
        for node in walk(side)
        if is_function(node, "tan")
    }
    return any(product(Number(Fraction(2)), angle) in tangents for angle in tangents)


def _ratio_of(tree: Expression, angle: sp.Symbol) -> sp.Expr | None:
    """The tangent of an angle, or its square, which stands alone on a side; None of another one."""
    match tree:
        case Apply("tan", Letter(name)) if name == angle.name:
            return sp.tan(angle)
        case Binary("^", Apply("tan", Letter(name)), Number(power)) if name == angle.name:
            return sp.tan(angle) ** power.numerator if power == 2 else None
    return None


def _has_letters_below(tree: Expression) -> bool:
    """Whether a side is a quotient with letters in its denominator."""
    match tree:
        case Binary("/", _, below):
            return bool(letters(below))
    return False


def is_letter_or_square(tree: Expression) -> bool:
    """Whether a side is a letter, or the square of one."""
    match tree:
        case Letter() | Binary("^", Letter(), Number()):
            return True
    return False


def _has_root(relation: Relation) -> bool:
    return any(
        is_function(node, "sqrt") and bool(letters(node))
        for links in relation.options
        for link in links
        for side in (link.left, link.right)
        for node in walk(side)
    )


def _standard_form(factors: Sequence[sp.Poly], symbol: sp.Symbol) -> Relation:
    """``a k² + b k + c = 0`` of a product of two factors."""
    a, b, c = (expanded(coefficient) for coefficient in (factors[0] * factors[1]).all_coeffs())
    letter = Letter(symbol.name)
    powers = (product(tree_of(a), square(letter)), product(tree_of(b), letter), tree_of(c))
    return equality(total(powers), ZERO)
