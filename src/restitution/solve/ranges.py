"""``range of X``: all values that the facts and the physics allow.

Where a condition can change from true to false, one of the expressions in it vanishes, or has no
value. Those points are found exactly; between them one trial by numbers decides. Data letters are
tried at several random values: the range must have the same form, in these letters, for all.
"""

from __future__ import annotations

import random
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise, product
from typing import Any

import sympy as sp
from mpmath.libmp import NoConvergence

from restitution import exact
from restitution.errors import (
    ContradictionError,
    MissingError,
    RestitutionError,
    UnsupportedError,
)
from restitution.expression.evaluate import Evaluator, Symbolic
from restitution.expression.tree import Expression, Letter, has_quantity, letters
from restitution.oracle.roles import Role
from restitution.problem import Compare, Find, Problem, Range, Show
from restitution.render.layout import display_set, from_tree
from restitution.render.text import to_text
from restitution.solve import forms
from restitution.solve.algebra import solve_system
from restitution.solve.conditions import AnyOf, Condition
from restitution.solve.letters import is_angle, roles
from restitution.solve.numbers import (
    DIGITS,
    FIELD,
    TINY,
    Sample,
    UndefinedError,
    at,
    draw,
    sample,
    sign_at,
)
from restitution.solve.part import Desk, Letters, Outcome, Setting, Trial, declared
from restitution.solve.solution import Answer, ItemResult

DRAWS = 4
DRAWS_TRIED = 60
INFINITE = 10**30
# So near that even a root of it is not seen, and far above rounding.
ASIDE = TINY**2 / 10**6


@dataclass(frozen=True)
class End:
    """One end of an interval, exact, and whether it belongs to it."""

    value: sp.Expr
    closed: bool


Piece = tuple[End, End]


@dataclass
class Region:
    """The values that one letter can take, in the setting of a part.

    ``free`` letters may have any admissible value; all others are data.
    """

    outcome: Outcome
    letter: str
    free: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        self.setting: Setting = self.outcome.setting
        self.role: Role = self.setting.roles[self.letter]
        self.symbol = self.role.symbol(self.letter)
        self.trials = [t for t in self.outcome.trials if t.kind != "equation"]
        self._kept_atoms = self._atoms()
        matter = {s.name for each in self._kept_atoms for s in each.free_symbols}
        self.free = tuple(name for name in self.free if name in matter)
        self.points = self._critical()

    # --- where truth can change --------------------------------------------------------------

    def _atoms(self) -> list[sp.Expr]:
        """The expressions whose signs decide, with what was solved put in."""
        found: list[sp.Expr] = []
        for trial in self.trials:
            told = Letters(self.setting.roles, trial.found.values, trial.found.angles)
            story = self.setting.tell(told)
            needs = [*story.conditions, *self.setting.requirements(story)]
            for need in needs:
                if isinstance(need, Condition):
                    found.append(sp.sympify(need.value, strict=True))
                elif isinstance(need, AnyOf):
                    found += [sp.sympify(option.value, strict=True) for option in need.options]
            for name, value in trial.found.values.items():
                role = self.setting.roles.get(name) or told.hidden_roles.get(name)
                if role is None:
                    continue
                if role.kind == "angle":
                    if name in trial.found.angles:
                        found += list(trial.found.angles[name])
                    continue
                if role.low is not None:
                    found.append(value - role.low)
                if role.high is not None:
                    found.append(value - role.high)
        for name in self.free:
            role, symbol = self.setting.roles[name], self.setting.roles[name].symbol(name)
            for bound in (role.low, role.high):
                if bound is not None and name in {
                    s.name for each in found for s in each.free_symbols
                }:
                    found.append(symbol - bound)
        unique: list[sp.Expr] = []
        for each in found:
            for part in _signs(each):
                for factor in _essential(part):
                    if factor not in unique:
                        unique.append(factor)
        return unique

    def _critical(self) -> list[sp.Expr]:
        atoms = self._kept_atoms
        points: list[sp.Expr] = [x for x in (self.role.low, self.role.high) if x is not None]
        free = {self.setting.roles[name].symbol(name) for name in self.free}
        plain = [each for each in atoms if not each.free_symbols & free]
        mixed = [each for each in atoms if each.free_symbols & free]
        for atom in plain:
            if atom.has(self.symbol):
                points += self._zeros([atom], [self.symbol])
        if mixed:
            symbols = sorted(free, key=lambda s: s.name)
            for i, one in enumerate(mixed):
                own = [s for s in symbols if one.has(s)]
                if len(own) == 1 and one.has(self.symbol):
                    points += self._zeros([one, sp.diff(one, own[0])], [*own, self.symbol])
                for other in mixed[i + 1 :]:
                    if one.has(self.symbol) or other.has(self.symbol):
                        points += self._zeros([one, other], [*symbols, self.symbol])
        unique: list[sp.Expr] = []
        for point in points:
            if not any(point == each for each in unique):
                unique.append(point)
        return unique

    def _zeros(self, equations: list[sp.Expr], unknowns: list[sp.Symbol]) -> list[sp.Expr]:
        return zeros(equations, unknowns, self.setting.roles, self.letter)

    # --- deciding ----------------------------------------------------------------------------

    def data(self) -> list[str]:
        """The letters that stay data."""
        solved = {name for trial in self.trials for name in trial.found.values}
        hidden = set(self.outcome.letters.hidden_roles)
        return sorted(
            (set(self.setting.roles) | hidden)
            - solved
            - set(self.setting.lets)
            - {self.letter, *self.free}
        )

    def allowed(self, value: Any, drawn: Mapping[str, Any]) -> bool:
        """Whether the letter may have this numerical value, the data being as drawn."""
        if not self.free:
            return self._possible({**drawn, self.letter: value})
        return any(
            self._possible({**drawn, self.letter: value, **extra})
            for extra in self._choices(value, drawn)
        )

    def _choices(self, value: Any, drawn: Mapping[str, Any]) -> list[Sample]:
        """Values of the free letters that stand for all: between and at the critical ones."""
        chosen: list[Sample] = [{}]
        for name in self.free:
            inner = Region.__new__(Region)
            inner.outcome, inner.letter, inner.free = self.outcome, name, ()
            inner.setting, inner.role = self.setting, self.setting.roles[name]
            inner.symbol = inner.role.symbol(name)
            inner.trials = self.trials
            extended: list[Sample] = []
            for known in chosen:
                values = {**drawn, self.letter: value, **known}
                numbers = _numeric_zeros(self._kept_atoms, inner.symbol, values)
                role = inner.role
                for bound in (role.low, role.high):
                    if bound is not None:
                        numbers.append(at(bound, {}))
                extended += [{**known, name: x} for x in _representatives(sorted(numbers), role)]
            chosen = extended[:200]
        return chosen

    def _solved(self, trial: Trial, values: Sample) -> Sample:
        """These values with all that was solved.

        Where a formula has none (0/0 where a quadratic equation becomes a linear one), what it
        comes near to is taken; whether that is a solution is for the facts to say.
        """
        try:
            return _with_solved(trial, values)
        except UndefinedError as error:
            for name in (self.letter, *self.free):
                for step in (ASIDE, -ASIDE):
                    try:
                        aside = _with_solved(trial, {**values, name: values[name] + step})
                    except UndefinedError:
                        continue
                    return {**aside, **values}
            raise error

    def _possible(self, values: Sample) -> bool:
        for trial in self.trials:
            try:
                numbers = self._solved(trial, values)
                solved = [n for n in trial.found.values if not n.startswith("_")]
                known = self.outcome.letters.hidden_roles
                if any(
                    numbers[n] <= 0
                    for n in trial.found.values
                    if n in known and known[n].low is not None
                ):
                    continue
                if self.setting.examine(numbers, [*solved, self.letter, *self.free]) is None:
                    return True
            except (UndefinedError, ArithmeticError, KeyError):
                continue
            except RestitutionError:
                continue
        return False

    # --- the set -------------------------------------------------------------------------------

    def pieces(self) -> list[Piece]:
        """The allowed values as intervals with exact ends, in order."""
        shapes: list[tuple[list[Piece], Sample]] = []
        data = self.data()
        roles = {**self.setting.roles, **self.outcome.letters.hidden_roles}
        rng = random.Random(17)
        for _ in range(DRAWS_TRIED if data else 1):
            drawn = sample(data, roles, rng)
            found = self._pieces_for(drawn)
            if found:
                shapes.append((found, drawn))
            if len(shapes) == DRAWS:
                break
        if not shapes:
            return []
        return _reconcile(shapes)

    def _pieces_for(self, drawn: Sample) -> list[Piece]:
        numbered: list[tuple[Any, sp.Expr]] = []
        for point in self.points:
            try:
                value = at(point, drawn)
            except (UndefinedError, KeyError):
                continue
            if not any(abs(value - other) < TINY * 10**3 for other, _ in numbered):
                numbered.append((value, point))
        low = None if self.role.low is None else at(self.role.low, {})
        high = None if self.role.high is None else at(self.role.high, {})
        numbered = sorted(
            (
                pair
                for pair in numbered
                if (low is None or pair[0] >= low - TINY)
                and (high is None or pair[0] <= high + TINY)
            ),
            key=lambda pair: pair[0],
        )
        cells: list[tuple[sp.Expr | None, bool]] = []  # alternating: gap, point, gap, …
        edges = [None, *numbered, None]
        for left, right in pairwise(edges):
            beyond = (left is None and low is not None) or (right is None and high is not None)
            inside = False if beyond else self._gap(left, right, drawn)
            cells.append((None, inside))
            if right is not None:
                cells.append((right[1], self.allowed(right[0], drawn)))
        return _joined(cells)

    def _gap(self, left: Any, right: Any, drawn: Sample) -> bool:
        if left is None and right is None:
            points = [-7, 1, 11]
        elif left is None:
            points = [right[0] - 1, right[0] - 5]
        elif right is None:
            points = [left[0] + abs(left[0]) + 1, left[0] + 17]
        else:
            width = right[0] - left[0]
            points = [left[0] + width / 2, left[0] + width / 7, right[0] - width / 9]
        truths = {self.allowed(x, drawn) for x in points}
        if len(truths) > 1:
            raise UnsupportedError(
                f"the ends of the range of {self.letter} have no exact form that is found here"
            )
        return truths.pop()


def zeros(
    equations: Sequence[sp.Expr],
    unknowns: Sequence[sp.Symbol],
    roles: Mapping[str, Role],
    wanted: str,
) -> list[sp.Expr]:
    """The values of one letter at which expressions vanish together."""
    angles = frozenset(s for s in unknowns if s.name in roles and roles[s.name].kind == "angle")
    acute = frozenset(
        s
        for s in angles
        if roles[s.name].low == 0
        and roles[s.name].high is not None
        and bool(roles[s.name].high <= sp.pi / 2)
    )
    bare = any(
        each.xreplace({f: sp.Integer(1) for f in each.atoms(sp.Function)}).has(s)
        for s in angles
        for each in equations
    )
    if bare:
        angles = acute = frozenset()
    found = []
    try:
        for solution in solve_system(list(equations), list(unknowns), angles, acute, roles):
            value = solution.values.get(wanted)
            if value is not None:
                found.append(exact.tidy_angle(value) if value.has(sp.atan, sp.atan2) else value)
    except (UnsupportedError, sp.PolynomialError, NotImplementedError):
        return []
    return found


def _signs(x: sp.Expr) -> list[sp.Expr]:
    """An expression's numerator and denominator, and what stands under its roots and bars."""
    top, bottom = sp.together(x).as_numer_denom()
    parts = [top, bottom]
    for node in sp.preorder_traversal(x):
        if node.is_Pow and node.exp.is_Rational and not node.exp.is_Integer:
            parts.append(sp.together(node.base).as_numer_denom()[0])
        elif isinstance(node, sp.Abs):
            parts.append(sp.together(node.args[0]).as_numer_denom()[0])
    return [each for each in parts if each.free_symbols]


def _essential(x: sp.Expr) -> list[sp.Expr]:
    """The factors of an expression that can change sign."""
    try:
        factors = [f for f, _ in sp.factor_list(x)[1]] if sp.count_ops(x) < 400 else [x]
    except (sp.PolynomialError, NotImplementedError):
        factors = [x]
    return [f for f in factors if f.free_symbols and not f.is_positive and not f.is_negative]


def _numeric_zeros(atoms: Sequence[sp.Expr], x: sp.Symbol, values: Mapping[str, Any]) -> list[Any]:
    """Where expressions vanish, in numbers, as one letter varies and the others are put in."""
    found = []
    for atom in atoms:
        if not atom.has(x):
            continue
        others = {
            s: sp.Float(str(values[s.name]), DIGITS)
            for s in atom.free_symbols
            if s != x and s.name in values
        }
        if len(others) != len(atom.free_symbols) - 1:
            continue
        expression = atom.xreplace(others)
        angle = expression.has(sp.sin, sp.cos, sp.tan)
        if angle:
            t = sp.Dummy("t")
            expression = expression.xreplace(
                {
                    sp.sin(x): 2 * t / (1 + t**2),
                    sp.cos(x): (1 - t**2) / (1 + t**2),
                    sp.tan(x): 2 * t / (1 - t**2),
                }
            )
            variable = t
        else:
            variable = x
        try:
            poly = sp.Poly(sp.together(expression).as_numer_denom()[0], variable)
            roots_ = poly.nroots(n=35, maxsteps=200)
        except (
            sp.PolynomialError,
            sp.GeneratorsNeeded,
            ValueError,
            NotImplementedError,
            NoConvergence,
        ):
            continue
        for root in roots_:
            if abs(sp.im(root)) < 1e-18:
                value = at(sp.re(root), {})
                found.append(2 * at(sp.atan(sp.re(root)), {}) if angle else value)
    return found


def _representatives(numbers: list[Any], role: Role) -> list[Any]:
    """Numbers, points between them and points beyond them."""
    if not numbers:
        return [at(sp.Rational(1, 3), {})]
    found = [numbers[0] - 1, numbers[-1] + 1, numbers[-1] * 2 + 3]
    for a, b in pairwise(numbers):
        found += [a, (a + b) / 2]
    found.append(numbers[-1])
    low = None if role.low is None else at(role.low, {})
    high = None if role.high is None else at(role.high, {})
    return [
        x for x in found if (low is None or x >= low - TINY) and (high is None or x <= high + TINY)
    ]


def _joined(cells: list[tuple[sp.Expr | None, bool]]) -> list[Piece]:
    """Alternating gaps and points, true or false, as intervals."""
    pieces: list[Piece] = []
    start: End | None = None
    for index, (point, inside) in enumerate(cells):
        if point is None:  # a gap between points
            if inside and start is None:
                before = cells[index - 1][0] if index else None
                start = End(-sp.oo if before is None else before, False)
            continue
        if inside:
            if start is None:
                start = End(point, True)
            after = cells[index + 1][1] if index + 1 < len(cells) else False
            if not after:
                pieces.append((start, End(point, True)))
                start = None
        elif start is not None:
            pieces.append((start, End(point, False)))
            start = None
    if start is not None:
        pieces.append((start, End(sp.oo, False)))
    return pieces


def _reconcile(shapes: list[tuple[list[Piece], Sample]]) -> list[Piece]:
    """One form for all the trials; ends that change places become the larger or the smaller."""
    counts = Counter(tuple(pieces) for pieces, _ in shapes)
    if len(counts) == 1:
        return shapes[0][0]
    sizes = {len(pieces) for pieces, _ in shapes}
    if sizes != {1}:
        raise UnsupportedError("the form of the range depends on the values of the data")
    lows = {pieces[0][0] for pieces, _ in shapes}
    highs = {pieces[0][1] for pieces, _ in shapes}
    low = _extreme(lows, [(p[0][0], d) for p, d in shapes], sp.Max, max)
    high = _extreme(highs, [(p[0][1], d) for p, d in shapes], sp.Min, min)
    return [(low, high)]


def _extreme(ends: set[End], seen: list[tuple[End, Sample]], form: Any, pick: Any) -> End:
    if len(ends) == 1:
        return next(iter(ends))
    for end, drawn in seen:
        values = [_end_at(each, drawn) for each in ends]
        if abs(_end_at(end, drawn) - pick(values)) > TINY:
            raise UnsupportedError("the form of the range depends on the values of the data")
    return End(form(*[each.value for each in ends]), all(each.closed for each in ends))


def _end_at(end: End, drawn: Sample) -> Any:
    if end.value in (sp.oo, -sp.oo):
        return INFINITE if end.value == sp.oo else -INFINITE
    return at(end.value, drawn)


def to_set(pieces: Sequence[Piece]) -> sp.Set:
    """Intervals as one SymPy set, the ends in textbook form."""
    made = []
    for low, high in pieces:
        a, b = (forms.bound(each.value) for each in (low, high))
        if a == b:
            made.append(sp.FiniteSet(a))
        else:
            made.append(sp.Interval(a, b, not low.closed, not high.closed))
    return sp.Union(*made) if made else sp.S.EmptySet


# --- ranges of letters and of quantities -------------------------------------------------------


def find_range(
    desk: Desk, item: Range, now: int, in_terms_of: tuple[str, ...] | None
) -> ItemResult:
    """All values of a letter, or of a quantity, that the facts allow."""
    line = None if item.place is None else item.place.line
    require_told(desk.problem, item.expression)
    meant = _meant(desk, item, in_terms_of)
    tree = meant.expression
    base = desk.settle(in_terms_of, meant)
    if isinstance(tree, Letter) and tree.name not in base.lets:
        values = _range_of_letter(desk, tree.name, in_terms_of, base)
        angle = base.roles[tree.name].kind == "angle"
    else:
        values, angle = _range_of_quantity(desk, meant, now, in_terms_of)
    if values is sp.S.EmptySet:
        raise ContradictionError(f"no value of {item.text.removeprefix('range of ')} is possible")
    layout = display_set(values, from_tree(item.expression), angle=angle)
    told = exact.sympy_text(values)
    answer = Answer(1, values, told, None, to_text(layout), angle=angle, layout=layout)
    return ItemResult(item, line, item.text, "range", (answer,))


def require_told(problem: Problem, tree: Expression) -> None:
    """Raise MissingError for a letter of which only questions speak: it stands for nothing."""
    told = roles(
        replace(
            problem,
            parts=tuple(
                replace(part, steps=tuple(s for s in part.steps if not isinstance(s, Find | Show)))
                for part in problem.parts
            ),
        )
    )
    for name in sorted(letters(tree) - set(told)):
        if name == "e":
            raise MissingError("no collision has e for its coefficient of restitution")
        raise MissingError(f"nothing is told of {name}")


def _meant(desk: Desk, item: Range, in_terms_of: tuple[str, ...] | None) -> Range:
    """An item with what its letter was let to be: the range of a ratio, not of its name."""
    lets = desk.settle(in_terms_of, item).lets
    tree = item.expression
    while isinstance(tree, Letter) and tree.name in lets:
        tree = lets[tree.name][0].expression
    return item if has_quantity(tree) else replace(item, expression=tree)


def _range_of_ratio(desk: Desk, item: Range) -> sp.Set | None:
    """The range of q/p from that of q, where it does not depend on p but through q/p."""
    tree = item.expression
    roles = desk.settle(None, item).roles
    value = Evaluator(Symbolic(), Letters(roles).letter).scalar(tree)
    for name in sorted(letters(tree)):
        symbol = roles[name].symbol(name)
        slope = sp.diff(value, symbol)
        if not slope.is_positive:
            continue  # rising with this letter, whatever the others are
        try:
            values = _range_of_letter(desk, name, None, desk.settle(None, item, letters(tree)))
        except RestitutionError:
            continue
        if not isinstance(values, sp.Interval):
            continue
        ends = [limit(value, symbol, end, end == sp.oo) for end in (values.start, values.end)]
        if any(end is None or (end.free_symbols & value.free_symbols) for end in ends):
            continue
        return sp.Interval(ends[0], ends[1], values.left_open, values.right_open)
    return None


def _range_of_letter(
    desk: Desk, name: str, in_terms_of: tuple[str, ...] | None, setting: Setting
) -> sp.Set:
    try:
        outcome = desk.outcome(setting)
        free = _free(outcome, in_terms_of) - {name}
        region = Region(outcome, name, tuple(sorted(free)))
        values = to_set(region.pieces())
    except ContradictionError:
        values = _fixed_values(desk, name, setting)
        if values is sp.S.EmptySet:
            raise
    return values or _fixed_values(desk, name, setting)


def _fixed_values(desk: Desk, name: str, setting: Setting) -> sp.Set:
    """The values of a letter that the facts fix, though it was to run over a range."""
    own = frozenset({name})
    sought = replace(
        setting,
        protected=setting.protected - own,
        fixed=setting.fixed - own,
        asked=setting.asked | own,
    )
    try:
        accepted = desk.outcome(sought).accepted
    except RestitutionError:
        return sp.S.EmptySet
    values = [trial.found.values[name] for trial in accepted if name in trial.found.values]
    return sp.FiniteSet(*map(exact.tidy, values)) if len(values) == len(accepted) else sp.S.EmptySet


def _free(outcome: Outcome, in_terms_of: tuple[str, ...] | None) -> set[str]:
    """Letters that vary freely: declared unknown, or not listed, and not fixed by the facts."""
    setting = outcome.setting
    solved = {name for trial in outcome.trials for name in trial.found.values}
    free = set(declared(setting.problem, setting.part))
    if in_terms_of is not None:
        free |= set(setting.roles) - set(in_terms_of)
    return free - solved - set(setting.lets)


def _range_of_quantity(
    desk: Desk, item: Range, now: int, in_terms_of: tuple[str, ...] | None
) -> tuple[sp.Set, bool]:
    tree = item.expression
    setting = desk.settle(in_terms_of, item)
    named = letters(tree) - set(setting.lets) if not has_quantity(tree) else frozenset()
    if len(named) > 1 and not letters(tree) & set(setting.lets):
        found = _range_of_ratio(desk, item)
        if found is not None:
            return found, False
    walls = frozenset(wall.name for wall in desk.problem.walls)
    angles = {name for name, role in setting.roles.items() if role.kind == "angle"}
    angle = is_angle(tree, angles, walls)
    # What varies freely must not be solved for: where the facts fix it, that is found out.
    first = desk.outcome(setting)
    fixed = {name for trial in first.trials for name in trial.found.values}
    outcome = desk.outcome(desk.settle(in_terms_of, item, named)) if named else first
    values = _images(outcome, tree, now)
    present = {s.name for _, value in values for s in value.free_symbols}
    free = ((_free(first, in_terms_of) | named) & present) - (fixed - named)
    free = free or _restricted(outcome) & present
    if not free:
        return sp.FiniteSet(*[value for _, value in values]), angle
    if any(name.startswith("_") for name in present):
        hidden = min(name for name in present if name.startswith("_"))
        raise MissingError(f"the range needs {outcome.letters.phrases.get(hidden, hidden)}")
    return _image(outcome, values, sorted(free)), angle


def _restricted(outcome: Outcome) -> set[str]:
    """Letters that a fact keeps between bounds, and coefficients: what a range is asked over."""
    setting = outcome.setting
    found = {name for name, role in setting.roles.items() if role.kind == "restitution"}
    for given, _ in setting.facts:
        for relation in given.relations:
            if isinstance(relation, Compare) and set(relation.operators) != {"="}:
                found |= {each.name for each in relation.operands if isinstance(each, Letter)}
    return found


def _images(outcome: Outcome, tree: Expression, now: int) -> list[tuple[Trial, sp.Expr]]:
    found = []
    for trial in outcome.accepted:
        told = Letters(outcome.setting.roles, trial.found.values, trial.found.angles, trial.samples)
        story = outcome.setting.tell(told)
        value = forms.plain(story.evaluator(now).value(tree), outcome.witnesses(trial))
        if isinstance(value, tuple):
            raise UnsupportedError("the range of a vector is not a set of numbers")
        found.append((trial, value))
    if not found:
        raise ContradictionError("no values satisfy all that is told")
    return found


def _image(outcome: Outcome, values: list[tuple[Trial, sp.Expr]], free: list[str]) -> sp.Set:
    """The values of expressions as letters vary freely within what is allowed."""
    sets = []
    for trial, value in values:
        own = replace(outcome, trials=(trial,))
        used = [name for name in free if any(s.name == name for s in value.free_symbols)]
        if not used:
            sets.append(sp.FiniteSet(value))
            continue
        sets.append(_image_of(own, value, used))
    return sp.Union(*sets)


@dataclass(frozen=True)
class Candidate:
    """A value that may bound an image, with the letters' values there; reached or approached.

    ``sides`` tells from which side (1 is from above) a letter has to come to its value.
    """

    value: sp.Expr
    where: Mapping[str, sp.Expr]
    sides: Mapping[str, int] = field(default_factory=dict)


def _image_of(outcome: Outcome, value: sp.Expr, free: list[str]) -> sp.Set:
    region = Region(outcome, free[0], tuple(free[1:]))
    data = region.data()
    roles = {**outcome.setting.roles, **outcome.letters.hidden_roles}
    candidates = list(_candidates(outcome, value, free, region))
    rng = random.Random(23)
    shapes: list[tuple[list[Piece], Sample]] = []
    for _ in range(DRAWS_TRIED if data else 1):
        drawn = sample(data, roles, rng)
        inside = _seen(region, value, free, drawn)
        if not inside:
            continue
        ends = []
        for sign, bound in ((-1, min(inside)), (1, max(inside))):
            best = _bounding(region, candidates, drawn, sign, bound)
            if best is None:
                raise UnsupportedError(
                    "the ends of this range have no exact form that is found here"
                )
            ends.append(End(best.value, _is_reached(region, best, drawn)))
        shapes.append(([(ends[0], ends[1])], drawn))
        if len(shapes) == DRAWS:
            break
    if not shapes:
        raise ContradictionError("no values satisfy all that is told")
    return to_set(_reconcile(shapes))


def _bounding(
    region: Region, candidates: list[Candidate], drawn: Sample, sign: int, bound: Any
) -> Candidate | None:
    """The candidate next beyond the values seen, above (sign 1) or below (-1) them."""
    best: tuple[Any, Candidate] | None = None
    for candidate in candidates:
        number = _limit_at(candidate.value, drawn)
        if number is None:
            continue
        slack = TINY * 10**5 * (1 + abs(number))
        if sign * number < sign * bound - slack or not _near(region, candidate, drawn):
            continue
        nearer = best is None or sign * number < sign * best[0] - slack
        if nearer or (
            best is not None
            and abs(number - best[0]) <= slack
            and _is_reached(region, candidate, drawn)
        ):
            best = (number, candidate)
    return None if best is None else best[1]


def _seen(region: Region, value: sp.Expr, free: list[str], drawn: Sample) -> list[Any]:
    """Values that do occur, at many random points."""
    rng = random.Random(29)
    found = []
    for _ in range(60):
        point = {name: draw(region.setting.roles[name], rng) for name in free}
        values = {**drawn, **point}
        if region._possible(values):
            try:
                found.append(at(value, values))
            except (UndefinedError, KeyError):
                continue
    return found


def _with_solved(trial: Trial, values: Sample) -> Sample:
    numbers = dict(values)
    for name, each in trial.found.values.items():
        numbers[name] = at(each, numbers)
    return numbers


def _candidates(
    outcome: Outcome, value: sp.Expr, free: list[str], region: Region
) -> list[Candidate]:
    """Stationary points and ends, letter by letter."""
    roles = outcome.setting.roles
    atoms = region._kept_atoms
    open_: list[Candidate] = [Candidate(value, {})]
    for name in free:
        symbol = roles[name].symbol(name)
        after: list[Candidate] = []
        for candidate in open_:
            expression = candidate.value
            if not expression.has(symbol):
                after.append(candidate)
                continue
            points = turning(expression, symbol, roles)
            role = roles[name]
            points += [-sp.oo if role.low is None else role.low]
            points += [sp.oo if role.high is None else role.high]
            for atom in atoms:
                put = {roles[n].symbol(n): v for n, v in candidate.where.items()}
                try:
                    own = atom.xreplace(put)
                except (TypeError, ZeroDivisionError):
                    continue
                if own.has(symbol):
                    points += zeros([own], [symbol], roles, name)
            for point in dict.fromkeys(points):
                where = {
                    n: sp.sympify(v, strict=True).xreplace({symbol: point})
                    for n, v in candidate.where.items()
                }
                for reduced, sides in limits(expression, symbol, point, role):
                    after.append(
                        Candidate(reduced, {**where, name: point}, {**candidate.sides, **sides})
                    )
        open_ = after[:80]
    return open_


def turning(expression: sp.Expr, symbol: sp.Symbol, roles: Mapping[str, Role]) -> list[sp.Expr]:
    """Where an expression can turn: its stationary points, and the kinks where a bar vanishes."""
    bars = sorted((bar for bar in expression.atoms(sp.Abs) if bar.has(symbol)), key=str)
    points: list[sp.Expr] = []
    for bar in bars:
        points += zeros(
            [sp.together(bar.args[0]).as_numer_denom()[0]], [symbol], roles, symbol.name
        )
    for signs in product((1, -1), repeat=len(bars)):
        put = {bar: sign * bar.args[0] for bar, sign in zip(bars, signs, strict=True)}
        slope = _derivative(expression.xreplace(put), symbol)
        points += zeros([slope], [symbol], roles, symbol.name)
    return list(dict.fromkeys(points))


def _derivative(expression: sp.Expr, symbol: sp.Symbol) -> sp.Expr:
    """The numerator of the derivative, which vanishes at stationary points."""
    core = expression
    if isinstance(core, sp.Pow) and core.exp == sp.S.Half:
        core = core.base
    return sp.together(sp.diff(core, symbol)).as_numer_denom()[0]


def limit(
    expression: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool = False
) -> sp.Expr | None:
    """The value of an expression at a point, or its limit there (from below if so asked)."""
    quick = _approached(_in_sines(expression), symbol, sp.sympify(point, strict=True), below)
    if quick is not None:
        return quick if quick in (sp.oo, -sp.oo) else exact.tidy(quick)
    try:
        side = "-" if below or point == sp.oo else "+"
        value = sp.limit(expression, symbol, point, side)
    except (NotImplementedError, ValueError, TypeError, RecursionError):
        return None
    if value.has(sp.nan, sp.zoo) or isinstance(value, sp.Limit):
        return None
    return value


def limits(
    expression: sp.Expr, symbol: sp.Symbol, point: sp.Expr, role: Role
) -> list[tuple[sp.Expr, dict[str, int]]]:
    """The limit at a point, or one for each side of a pole, with the side that it belongs to."""
    value = limit(expression, symbol, point, point == role.high)
    if value is None:
        return []
    if value not in (sp.oo, -sp.oo) or point in (sp.oo, -sp.oo, role.low, role.high):
        return [(value, {})]
    both = ((limit(expression, symbol, point, side < 0), side) for side in (1, -1))
    return [(each, {symbol.name: side}) for each, side in both if each is not None]


def _in_sines(x: sp.Expr) -> sp.Expr:
    """Tangents as sine over cosine: they have values where a tangent has none."""
    return x.replace(sp.tan, lambda a: sp.sin(a) / sp.cos(a))


def _approached(x: sp.Expr, symbol: sp.Symbol, point: sp.Expr, below: bool) -> sp.Expr | None:
    """The limit where it can be had by putting in; None where it takes more."""
    if not x.has(symbol):
        return x
    if point in (sp.oo, -sp.oo):
        return None
    if x.is_Add or (x.is_Mul and x.args[0].is_number and not x.args[0].has(symbol)):
        parts = [_approached(each, symbol, point, below) for each in x.args]
        if all(each is not None and each.is_finite is not False for each in parts):
            return x.func(*parts)
    if isinstance(x, sp.atan):
        inner = _approached(x.args[0], symbol, point, below)
        if inner in (sp.oo, -sp.oo):
            return sp.pi / 2 if inner == sp.oo else -sp.pi / 2
        return None if inner is None else sp.atan(inner)
    top, bottom = sp.together(x).as_numer_denom()
    try:
        value, under = (each.xreplace({symbol: point}) for each in (top, bottom))
        value, under = sp.expand(value), sp.expand(under)
    except (ZeroDivisionError, TypeError):
        return None
    if any(each.has(sp.nan, sp.zoo, sp.oo) for each in (value, under)):
        return None
    if under != 0:
        return value / under
    if value == 0:
        return None
    step = sp.Rational(-1 if below else 1, 10**8)
    near = bottom.xreplace({symbol: point + step})
    rng = random.Random(47)
    names = sorted(s.name for s in (value * near).free_symbols)
    points = [{name: FIELD.context.mpf(rng.uniform(0.1, 0.9)) for name in names} for _ in range(4)]
    sign = sign_at(value * near, points)
    return None if sign in (None, 0) else sign * sp.oo


def _limit_at(value: sp.Expr, drawn: Sample) -> Any | None:
    if value in (sp.oo, -sp.oo):
        return INFINITE if value == sp.oo else -INFINITE
    try:
        return at(value, drawn)
    except (UndefinedError, KeyError):
        return None


def _numbers(region: Region, candidate: Candidate, drawn: Sample) -> Sample | None:
    values = dict(drawn)
    try:
        for name, point in candidate.where.items():
            if point in (sp.oo, -sp.oo):
                return None
            values[name] = at(point, values)
    except (UndefinedError, KeyError):
        return None
    return values


def _is_reached(region: Region, candidate: Candidate, drawn: Sample) -> bool:
    """Whether the letters may have the values at which a candidate lies."""
    if candidate.value in (sp.oo, -sp.oo):
        return False
    values = _numbers(region, candidate, drawn)
    return values is not None and region._possible(values)


def _near(region: Region, candidate: Candidate, drawn: Sample) -> bool:
    """Whether allowed values come as near to a candidate's place as one likes."""
    if _is_reached(region, candidate, drawn):
        return True
    values: Sample = dict(drawn)
    names = list(candidate.where)
    for step in (at(sp.Rational(1, 10**7), {}),):
        for n in range(3 ** len(names)):
            trial = dict(values)
            code = n
            ok = True
            for name in names:
                shift = (code % 3) - 1
                code //= 3
                ok = ok and shift == candidate.sides.get(name, shift)
                point = candidate.where[name]
                if point == sp.oo:
                    trial[name] = at(sp.Integer(10**7), {}) * (1 + shift * step)
                elif point == -sp.oo:
                    trial[name] = -at(sp.Integer(10**7), {}) * (1 + shift * step)
                else:
                    try:
                        trial[name] = at(point, trial) + shift * step
                    except (UndefinedError, KeyError):
                        ok = False
                        break
            if ok and region._possible(trial):
                return True
    return False


# --- claimed ranges ----------------------------------------------------------------------------


def claimed_set(relation: Compare, subject: Range, evaluator: Evaluator) -> sp.Set:
    """The set that a chain such as ``0 < e < 1/2`` describes."""
    operands, operators = relation.operands, relation.operators
    where = next((i for i, tree in enumerate(operands) if tree == subject.expression), None)
    if where is None:
        raise UnsupportedError("the chain does not hold the quantity whose range is claimed")
    low, high = -sp.oo, sp.oo
    low_open = high_open = True
    for index, other, op in (
        (where - 1, where - 1, where - 1),
        (where + 1, where + 1, where),
    ):
        if not 0 <= index < len(operands):
            continue
        sign = operators[op]
        bound = evaluator.scalar(operands[other])
        if sign == "=":
            return sp.FiniteSet(bound)
        below = (sign.startswith("<")) == (index < where)
        if below:
            low, low_open = bound, not sign.endswith("=")
        else:
            high, high_open = bound, not sign.endswith("=")
    return sp.Interval(low, high, low_open, high_open)


def same_set(claimed: sp.Set, found: sp.Set, roles: Mapping[str, Role]) -> bool:
    """Whether two sets are equal; a claim without a lower end means down to zero."""
    if not isinstance(claimed, sp.Interval) or not isinstance(found, sp.Interval):
        return bool(claimed == found)
    ends: list[Callable[[Any], Any]] = [lambda s: s.start, lambda s: s.end]
    for end in ends:
        a, b = end(claimed), end(found)
        if a in (sp.oo, -sp.oo) or b in (sp.oo, -sp.oo):
            if a != b and not (a == -sp.oo and b == 0):
                return False
        elif not exact.same(a, b):
            return False
    low_matters = claimed.start not in (-sp.oo,)
    return bool(
        (not low_matters or claimed.left_open == found.left_open)
        and claimed.right_open == found.right_open
    )
