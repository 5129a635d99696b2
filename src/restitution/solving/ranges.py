"""``range of X``: all values of a letter or of a quantity that the facts and the physics allow."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import product
from typing import Any

import sympy as sp

from restitution import exact
from restitution.errors import (
    ContradictionError,
    MissingError,
    RestitutionError,
    UnsupportedError,
)
from restitution.expression.enclosed import Enclosed, UndefinedError
from restitution.expression.evaluate import Evaluator, Symbolic
from restitution.expression.tree import Expression, Letter, has_quantity, letters
from restitution.oracle import (
    All,
    BeyondError,
    Formula,
    Oracle,
    Point,
    Proof,
    Relation,
    Verdict,
    joined,
    letters_of,
)
from restitution.oracle.roles import REAL, TO_180, Role
from restitution.problem import Compare, Find, Problem, Range, Show
from restitution.render.layout import display_set, from_tree
from restitution.render.text import to_text
from restitution.solving import forms, missing
from restitution.solving.cases import Case, cases
from restitution.solving.letters import is_angle, roles
from restitution.solving.numbers import Sample, at, draw, number_of, sample, sign_at
from restitution.solving.part import Desk, Outcome
from restitution.solving.regions import (
    DRAWS,
    DRAWS_TRIED,
    INFINITE,
    ROUNDS,
    End,
    Piece,
    Region,
    inside_of,
    reconcile,
    to_set,
    zeros,
)
from restitution.solving.setting import Setting, Trial, declared
from restitution.solving.solution import Answer, ItemResult
from restitution.solving.unknowns import Letters
from restitution.solving.validity import (
    Limitation,
    bounds_of,
    range_limitations,
    with_condition,
)

# --- ranges of letters and of quantities -------------------------------------------------------


# Values of what is asked, with what they ask of the other letters.
Form = tuple[sp.Set, tuple[Limitation, ...]]


def find_range(
    desk: Desk, item: Range, now: int, in_terms_of: tuple[str, ...] | None
) -> ItemResult:
    """All values of a letter, or of a quantity, that the facts allow."""
    line = None if item.place is None else item.place.line
    require_stated(desk.problem, item.expression)
    meant = _meant(desk, item, in_terms_of)
    tree = meant.expression
    base = desk.settle(in_terms_of, meant)
    pieces: list[Form]
    if isinstance(tree, Letter) and tree.name not in base.lets:
        pieces, proof = _range_of_letter(desk, tree.name, in_terms_of, base)
        angle = base.roles[tree.name].kind == "angle"
    else:
        pieces, angle, proof = _range_of_quantity(desk, meant, now, in_terms_of)
    answers = []
    for values, limits in pieces:
        if values is sp.S.EmptySet:
            name = item.text.removeprefix("range of ")
            raise ContradictionError(f"no value of {name} is possible")
        layout = display_set(values, from_tree(item.expression), angle=angle)
        text = exact.sympy_text(values)
        answer = Answer(1, values, text, None, to_text(layout), angle=angle, layout=layout)
        answers.append(with_condition(answer, layout, limits))
    return ItemResult(item, line, item.text, "range", tuple(answers), proof=proof)


def require_stated(problem: Problem, tree: Expression) -> None:
    """Raise MissingError for a letter that only questions mention: nothing gives it a meaning."""
    stated = roles(
        replace(
            problem,
            parts=tuple(
                replace(part, steps=tuple(s for s in part.steps if not isinstance(s, Find | Show)))
                for part in problem.parts
            ),
        )
    )
    for name in sorted(letters(tree) - set(stated)):
        if name == "e":
            raise MissingError("no collision has e for its coefficient of restitution")
        raise MissingError(f"nothing is told of {name}")


def _meant(desk: Desk, item: Range, in_terms_of: tuple[str, ...] | None) -> Range:
    """An item with the definition of its letter put in: the range of a ratio, not of its name."""
    lets = desk.settle(in_terms_of, item).lets
    tree = item.expression
    while isinstance(tree, Letter) and tree.name in lets:
        tree = lets[tree.name][0].expression
    return item if has_quantity(tree) else replace(item, expression=tree)


def _range_of_ratio(desk: Desk, item: Range) -> tuple[sp.Set, Proof] | None:
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
            pieces, proof = _range_of_letter(
                desk, name, None, desk.settle(None, item, letters(tree))
            )
        except RestitutionError:
            continue
        values = pieces[0][0]
        if len(pieces) > 1 or not isinstance(values, sp.Interval):
            continue
        ends = [limit(value, symbol, end, end == sp.oo) for end in (values.start, values.end)]
        if any(end is None or (end.free_symbols & value.free_symbols) for end in ends):
            continue
        image = sp.Interval(ends[0], ends[1], values.left_open, values.right_open)
        # It rises with this letter, so what is proved of that is proved of the ratio.
        return image, proof
    return None


def _range_of_letter(
    desk: Desk, name: str, in_terms_of: tuple[str, ...] | None, setting: Setting
) -> tuple[list[Form], Proof]:
    """The values of a letter, each set of them with what it asks of the other letters."""
    try:
        outcome = desk.outcome(setting)
        free = _free(outcome, in_terms_of) - {name}
        region = Region(outcome, name, tuple(sorted(free)))
        values, several = _forms(region)
    except ContradictionError:
        values = _fixed_values(desk, name, setting)
        if values is sp.S.EmptySet:
            raise
        return [(values, ())], "algebra"
    if several:
        return _by_case(several, region.roles)
    if values is sp.S.EmptySet:
        return [(_fixed_values(desk, name, setting), ())], "algebra"  # the facts alone fix it
    return [(values, range_limitations(outcome, region, values))], region.proof


def _by_case(several: Sequence[Case], roles: Mapping[str, Role]) -> tuple[list[Form], Proof]:
    """The values in each case with what it asks of the data, and what they all rest on."""
    forms: list[Form] = [
        (to_set(c.pieces), (bounds_of(c.letter, c.values, roles),)) for c in several
    ]
    proofs: list[Proof] = [each.proof for each in several]
    return forms, next((proof for proof in proofs if proof != "algebra"), proofs[0])


def _forms(region: Region | _Image) -> tuple[sp.Set, list[Case]]:
    """The values in one form; in several, where one is not proved or not to be had."""
    try:
        values = to_set(region.pieces())
    except UnsupportedError:
        several = cases(region)
        if several:
            return sp.S.EmptySet, several
        raise
    if region.proof != "undecided" or values is sp.S.EmptySet:
        return values, []
    return values, cases(region)


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
    values = [trial.root.values[name] for trial in accepted if name in trial.root.values]
    return sp.FiniteSet(*map(exact.tidy, values)) if len(values) == len(accepted) else sp.S.EmptySet


def _free(outcome: Outcome, in_terms_of: tuple[str, ...] | None) -> set[str]:
    """Letters that vary freely: declared unknown, or not listed, and not fixed by the facts."""
    setting = outcome.setting
    solved = {name for trial in outcome.trials for name in trial.root.values}
    free = set(declared(setting.problem, setting.part))
    if in_terms_of is not None:
        free |= set(setting.roles) - set(in_terms_of)
    return free - solved - set(setting.lets)


def _range_of_quantity(
    desk: Desk, item: Range, now: int, in_terms_of: tuple[str, ...] | None
) -> tuple[list[Form], bool, Proof]:
    tree = item.expression
    setting = desk.settle(in_terms_of, item)
    named = letters(tree) - set(setting.lets) if not has_quantity(tree) else frozenset()
    if len(named) > 1 and not letters(tree) & set(setting.lets):
        answer = _range_of_ratio(desk, item)
        if answer is not None:
            return [(answer[0], ())], False, answer[1]
    walls = frozenset(wall.name for wall in desk.problem.walls)
    angles = {name for name, role in setting.roles.items() if role.kind == "angle"}
    angle = is_angle(tree, angles, walls)
    # What varies freely must not be solved for: where the facts fix it, that is found out.
    first = desk.outcome(setting)
    fixed = {name for trial in first.trials for name in trial.root.values}
    outcome = desk.outcome(desk.settle(in_terms_of, item, named)) if named else first
    values = _images(outcome, tree, now)
    present = {s.name for _, value in values for s in value.free_symbols}
    free = ((_free(first, in_terms_of) | named) & present) - (fixed - named)
    free = free or _restricted(outcome) & present
    if not free:
        return [(sp.FiniteSet(*[value for _, value in values]), ())], angle, "algebra"
    if any(name.startswith("_") for name in present):
        hidden = min(name for name in present if name.startswith("_"))
        raise missing.needs("the range", [outcome.letters.phrases.get(hidden, hidden)])
    image, proof = _image(outcome, values, sorted(free), angle)
    return image, angle, proof


def _restricted(outcome: Outcome) -> set[str]:
    """Letters that a fact keeps between bounds, and coefficients: what a range is asked over."""
    setting = outcome.setting
    names = {name for name, role in setting.roles.items() if role.kind == "restitution"}
    for given, _ in setting.facts:
        for relation in given.relations:
            if isinstance(relation, Compare) and set(relation.operators) != {"="}:
                names |= {
                    operand.name for operand in relation.operands if isinstance(operand, Letter)
                }
    return names


def _images(
    outcome: Outcome, tree: Expression, now: int, asked: str = "the range"
) -> list[tuple[Trial, sp.Expr]]:
    images = []
    for trial in outcome.accepted:
        solved_letters = Letters(
            outcome.setting.roles, trial.root.values, trial.root.angles, trial.samples
        )
        story = outcome.setting.tell(solved_letters)
        raw = story.evaluator(now).value(tree)
        phrases = {**outcome.letters.phrases, **solved_letters.phrases}
        needed = [phrases.get(name, name) for name in forms.open_in(raw, trial.samples)]
        if needed:
            raise missing.needs(asked, needed)
        value = forms.plain(raw, outcome.witnesses(trial))
        if isinstance(value, tuple):
            raise UnsupportedError("the range of a vector is not a set of numbers")
        images.append((trial, value))
    if not images:
        raise ContradictionError("no values satisfy all that is told")
    return images


def _image(
    outcome: Outcome, values: list[tuple[Trial, sp.Expr]], free: list[str], angle: bool
) -> tuple[list[Form], Proof]:
    """The values of expressions as letters vary freely within what is allowed."""
    sets: list[sp.Set] = []
    proofs: list[Proof] = []
    for trial, value in values:
        own = replace(outcome, trials=(trial,))
        used = [name for name in free if any(s.name == name for s in value.free_symbols)]
        if not used:
            sets.append(sp.FiniteSet(value))
            proofs.append("algebra")
            continue
        image = _Image(own, value, used, angle)
        one, several = _forms(image)
        if several and len(values) == 1:
            return _by_case(several, image.roles)
        if several:
            raise UnsupportedError("the form of the range depends on the values of the data")
        sets.append(one)
        proofs.append(image.proof)
    return [(sp.Union(*sets), ())], "undecided" if "undecided" in proofs else proofs[0]


@dataclass(frozen=True)
class Candidate:
    """A value that may bound an image, with the letters' values there; reached or approached.

    ``sides`` tells from which side (1 is from above) a letter has to come to its value.
    """

    value: sp.Expr
    where: Mapping[str, sp.Expr]
    sides: Mapping[str, int] = field(default_factory=dict)


class _Image:
    """The values of an expression: one interval, sought at a few values of the data, then proved.

    ``proof`` tells after `pieces` what it rests on.
    """

    def __init__(self, outcome: Outcome, value: sp.Expr, free: list[str], angle: bool) -> None:
        self.value, self.free = value, free
        self.region = Region(outcome, free[0], tuple(free[1:]))
        self.candidates = list(_candidates(outcome, value, free, self.region))
        self.angle = angle
        self.proof: Proof = "undecided"
        self.role, self.roles = REAL, self.region.roles
        self.data, self.given = self.region.data, self.region.given
        self.formula = self.region.formula
        running = {self.roles[name].symbol(name) for name in free}
        ends = (candidate.value for candidate in self.candidates)
        self.critical = [end for end in ends if not end.free_symbols & running]

    def pieces(self) -> list[Piece]:
        """The interval. Raises ContradictionError where nothing is possible."""
        shapes = self.shapes
        if not shapes:
            raise ContradictionError("no values satisfy all that is told")
        for _ in range(ROUNDS):
            pieces = reconcile(shapes)
            verdict = self.proved(pieces)
            self.proof = verdict.proof if verdict else "undecided"
            if verdict.answer != "refuted" or verdict.witness is None:
                break
            shape = self._shape(self.region._drawn(verdict.witness), verdict.witness)
            if shape is None or shape in shapes:
                break
            shapes.append(shape)
        return reconcile(shapes)

    @cached_property
    def shapes(self) -> list[tuple[list[Piece], Sample]]:
        """The interval for some values of the data."""
        data = self.region.data()
        rng = random.Random(23)
        shapes: list[tuple[list[Piece], Sample]] = []
        for _ in range(DRAWS_TRIED if data else 1):
            shape = self._shape(sample(data, self.region.roles, rng), {})
            if shape is not None:
                shapes.append(shape)
            if len(shapes) == DRAWS:
                break
        if shapes or self.region.formula is None:
            return shapes
        possible = Oracle(self.region.roles, (self.region.formula,)).possible
        if possible.witness is None:
            return []
        shape = self._shape(self.region._drawn(possible.witness), possible.witness)
        return [] if shape is None else [shape]

    def pieces_at(self, drawn: Sample) -> list[Piece]:
        """The interval for these values of the data, or none."""
        shape = self._shape(drawn, {})
        return [] if shape is None else shape[0]

    def _shape(self, drawn: Sample, point: Point) -> tuple[list[Piece], Sample] | None:
        """The interval for some values of the data; ``point`` has values that do occur."""
        inside = _seen(self.region, self.value, self.free, drawn, point)
        if not inside:
            return None
        ends = []
        for sign, bound in ((-1, min(inside)), (1, max(inside))):
            best = _bounding(self.region, self.candidates, drawn, sign, bound)
            if best is None:
                raise UnsupportedError(
                    "the ends of this range have no exact form that is found here"
                )
            ends.append(End(best.value, _is_reached(self.region, best, drawn)))
        return [(ends[0], ends[1])], drawn

    def proved(self, pieces: Sequence[Piece], more: Sequence[Formula] = ()) -> Verdict:
        """Whether just these values occur, whatever the data are; ``more`` are facts of them."""
        formula = self.region.formula
        if formula is None:
            return Verdict("undecided", "undecided")
        role = _role_of_angle(pieces) if self.angle else REAL
        roles = {**self.region.roles, _NAME: role}
        symbol = role.symbol(_NAME)
        # What is asked of the data alone holds whether or not a value occurs.
        of_data = tuple(
            each
            for each in (formula.parts if isinstance(formula, All) else (formula,))
            if letters_of(each) and not letters_of(each) & set(self.free)
        )
        try:
            outer = Oracle(roles, (*more, formula)).decide(inside_of(self.value, pieces))
            if not outer:
                return outer
            inner = Oracle(roles, (*more, *of_data, inside_of(symbol, pieces))).decide_some(
                joined((formula, Relation(self.value - symbol, "="))), frozenset(self.free)
            )
        except BeyondError:
            return Verdict("undecided", "undecided")
        return inner


_NAME = "value sought"  # no name that a letter can have


def _role_of_angle(pieces: Sequence[Piece]) -> Role:
    """What an angle may be that lies in some intervals; the narrower, the sooner it is decided."""
    plain = [end.value for piece in pieces for end in piece if end.value.is_number]
    if len(plain) == 2 * len(pieces) and all(0 <= at(x, {}) < at(sp.pi / 2, {}) for x in plain):
        return Role("angle", sp.Integer(0), sp.pi / 2, (True, False))
    return TO_180


def _bounding(
    region: Region, candidates: list[Candidate], drawn: Sample, sign: int, bound: Any
) -> Candidate | None:
    """The candidate next beyond the values seen, above (sign 1) or below (-1) them."""
    best: tuple[Any, Candidate] | None = None
    for candidate in candidates:
        number = _limit_at(candidate.value, drawn)
        if number is None:
            continue
        if sign * number < sign * bound or not _near(region, candidate, drawn):
            continue
        nearer = best is None or sign * number < sign * best[0]
        if nearer or (
            best is not None
            and not (number - best[0]).sign
            and _is_reached(region, candidate, drawn)
        ):
            best = (number, candidate)
    return None if best is None else best[1]


def _seen(
    region: Region, value: sp.Expr, free: list[str], drawn: Sample, known: Point
) -> list[Any]:
    """Values that do occur: at many random points, and at one that is known."""
    rng = random.Random(29)
    seen = []
    points = [{name: draw(region.setting.roles[name], rng) for name in free} for _ in range(60)]
    if known:
        points.append({name: number_of(known[name]) for name in free if name in known})
    for point in points:
        values = {**drawn, **point}
        if not set(free) <= set(values):
            continue
        if region._possible(values):
            try:
                seen.append(at(value, values))
            except (UndefinedError, KeyError):
                continue
    return seen


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
        parts = [_approached(argument, symbol, point, below) for argument in x.args]
        if all(part is not None and part.is_finite is not False for part in parts):
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
    points = [{name: rng.uniform(0.1, 0.9) for name in names} for _ in range(4)]
    sign = sign_at(value * near, points)
    return None if sign in (None, 0) else sign * sp.oo


def _limit_at(value: sp.Expr, drawn: Sample) -> Any | None:
    if value in (sp.oo, -sp.oo):
        return Enclosed.of(INFINITE if value == sp.oo else -INFINITE)
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


def same_value(a: Any, b: Any, roles: Mapping[str, Role]) -> bool | None:
    """Whether two expressions are equal for all that their letters may be; None if that is open."""
    gap = sp.sympify(a - b, strict=True)
    if not gap.free_symbols:
        return exact.is_zero(gap)
    try:
        verdict = Oracle(roles).decide(Relation(gap, "="))
    except BeyondError:
        return None
    return {"proved": True, "refuted": False, "undecided": None}[verdict.answer]


def same_set(claimed: sp.Set, true_set: sp.Set, roles: Mapping[str, Role]) -> bool | None:
    """Whether two sets are equal, None if that is open.

    A claim without a lower end means down to zero.
    """
    if not isinstance(claimed, sp.Interval) or not isinstance(true_set, sp.Interval):
        return bool(claimed == true_set)
    if claimed.start != -sp.oo and claimed.left_open != true_set.left_open:
        return False
    if claimed.right_open != true_set.right_open:
        return False
    open_ = False
    for a, b in ((claimed.start, true_set.start), (claimed.end, true_set.end)):
        if a in (sp.oo, -sp.oo) or b in (sp.oo, -sp.oo):
            if a != b and not (a == -sp.oo and b == 0):
                return False
            continue
        same = same_value(a, b, roles)
        if same is False:
            return False
        open_ = open_ or same is None
    return None if open_ else True
