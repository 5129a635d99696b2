"""For which values of the letters an answer holds, where it does not hold for all of them.

What the statement itself asks of its letters (bodies approach, a given inequality) goes without
saying. What a solution asks beyond that, such as 0 ≤ e ≤ 1 of an e that was found, is put as bounds
of one letter, with ends in the others.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import product

import sympy as sp

from restitution import exact
from restitution.errors import RestitutionError, UnsupportedError
from restitution.exact.symbols import atoms_in, operations_in, symbol_names, symbols_in
from restitution.expression.enclosed import UndefinedError
from restitution.expression.tree import Expression, is_quantity
from restitution.oracle import (
    BeyondError,
    Formula,
    Oracle,
    Relation,
    Some,
    joined,
    letters_of,
    relations,
)
from restitution.oracle.roles import POSITIVE, REAL, Role
from restitution.records import dataclass
from restitution.render.layout import Layout, Phrase, Words, from_set, relation
from restitution.render.text import to_text
from restitution.solving.algebra import forms
from restitution.solving.algebra.clearing import polynomial_of
from restitution.solving.algebra.intervals import existence, inside_of, to_set
from restitution.solving.algebra.numbers import at, sample
from restitution.solving.algebra.polynomials import factors
from restitution.solving.equations.part import Outcome
from restitution.solving.equations.setting import Trial
from restitution.solving.equations.solution import Answer
from restitution.solving.ranges.cases import KINDS
from restitution.solving.ranges.images import Image
from restitution.solving.ranges.regions import Region
from restitution.solving.ranges.strictness import strict
from restitution.solving.story.admission import Demand, demands_for
from restitution.solving.story.conditions import Condition

MOST_LETTERS = 6
TRIED = 24
# Of more letters of either sign the senses are not gone through.
MOST_SENSES = 2
# What is longer is not factorised.
LONGEST_EQUATION = 400
_SIGNS = {">": ">", ">=": "≥", "<": "<", "<=": "≤", "!=": "≠", "=": "="}
_TURNED = {">": "<", ">=": "<="}


@dataclass(frozen=True)
class Limitation:
    """A condition on the letters: ``text`` as a relation to be read again, and as mathematics.

    Where it bounds what was found for a ``letter``, ``own`` says so by the letter itself.
    """

    text: str
    layout: Layout
    letter: str | None = None
    own: Layout | None = None


def limitations(outcome: Outcome, trial: Trial) -> tuple[Limitation, ...]:
    """What an accepted solution asks of the letters beyond what the statement does.

    Where `are_all_known` is false it may ask more.
    """
    admission = trial.admission
    if admission is None and (unwieldy := tuple(_of_unwieldy(outcome, trial))):
        return unwieldy
    roles = outcome.letters.all_roles() if admission is None else admission.roles
    demands = _at_contacts(outcome, trial) if admission is None else admission.demands
    demands = (*demands, *_at_equations(outcome, trial))
    base = Oracle(roles, presupposed(outcome)) if demands else Oracle(roles)
    demands = (*demands, *_of_senses(base, trial))
    rest = [
        demand
        for demand in dict.fromkeys(demands)
        if _is_of_visible_letters(demand) and not base.decide(demand.formula)
    ]
    return tuple(_limits(outcome, trial, base, _needed(base, rest)))


def of_a_time(
    outcome: Outcome, trial: Trial, asked: Expression, time: sp.Expr
) -> tuple[Limitation, ...]:
    """For which values of a coordinate a time is positive that looks negative: −a/u, for a < 0.

    That a body comes to a wall asks for it; but who sees the letter for a place thinks of a
    positive one, from where the body would move away.
    """
    roles = outcome.letters.all_roles()
    names = symbol_names(time) if is_quantity(asked, "time") else set()
    real = [name for name in names if roles.get(name) == REAL]
    if len(real) != 1 or not names <= roles.keys():
        return ()
    (name,) = real
    needs = demands_for(outcome.setting.requirements(outcome.open_story))[0]
    facts = tuple(demand.formula for demand in needs if _is_of_visible_letters(demand))
    put = {x: roles[x.name].symbol(x.name) for x in time.free_symbols}
    plain = {x: POSITIVE.symbol(x.name) if x.name == name else own for x, own in put.items()}
    if not Oracle({**roles, name: POSITIVE}).decide(Relation(-time.xreplace(plain), ">")):
        return ()  # of d/p, or (d − a)/p, it is seen
    base, claim = Oracle(roles, facts), Relation(time.xreplace(put), ">")
    demand = Demand(claim, "", "time")
    region = None if base.decide(claim) else _region(outcome, trial, base, [demand], name)
    if not isinstance(region, sp.Interval) or not _is_everywhere(base, region):
        return ()
    return (bounds_of(name, region, base.roles),)


def _at_equations(outcome: Outcome, trial: Trial) -> Iterator[Demand]:
    """That no equation holds whatever the unknowns are: no factor of data alone is zero."""
    sought = trial.root.values.keys()
    if not sought or len(outcome.equations) > len(sought):
        return
    for equation in outcome.equations:
        unknowns = {x for x in symbols_in(equation) if x.name in sought}
        if not unknowns or operations_in(equation) > LONGEST_EQUATION:
            continue
        try:
            equation_factors = factors(polynomial_of(equation, unknowns))
        except (sp.PolynomialError, UnsupportedError):
            continue
        for factor in equation_factors:
            if not symbols_in(factor) & unknowns:
                yield Demand(Relation(factor, "!="), "", "fact")


def _of_unwieldy(outcome: Outcome, trial: Trial) -> Iterator[Limitation]:
    """That what is found is in its range, where its value is too unwieldy to be bounded in letters.

    Nothing, where it is at all values of the letters that are tried.
    """
    roles = outcome.letters.all_roles()
    for name, value in trial.root.values.items():
        role = outcome.setting.roles.get(name)
        if role is None or not value.free_symbols:
            continue
        bounded = _bounded(name, role, value, trial.root.angles.get(name))
        names = sorted(symbol_names(value))
        if bounded is None or any(name.startswith("_") or name not in roles for name in names):
            continue
        inside, (low, high), limit = bounded
        rng = random.Random(53)
        for _ in range(TRIED):
            try:
                number = at(inside, sample(names, roles, rng))
            except UndefinedError:
                continue
            if number < low or (high is not None and number > high):
                yield limit
                break


def _bounded(
    name: str, role: Role, value: sp.Expr, angle: tuple[sp.Expr, sp.Expr] | None
) -> tuple[sp.Expr, tuple[int, int | None], Limitation] | None:
    """An expression, between which numbers it lies, and this as a limitation of what was found.

    It is a coefficient or a positive letter itself; of an acute angle its cosine, sine or tangent.
    """
    own: sp.Expr = sp.Symbol(name)
    if role.kind == "restitution":
        limit = _chain(name, Relation(value, ">="), Relation(1 - value, ">="))
        return value, (0, 1), replace(limit, layout=limit.own or limit.layout)
    if role.low != 0 or role.closed[0]:
        return None
    high: int | None = None
    if role.kind == "angle" and role.high == sp.pi / 2:
        function = _FUNCTIONS.get(value.func)
        if function is not None:
            value = value.args[0]
        elif angle is not None:
            function, value = sp.cos, forms.tidy(angle[0])
        else:
            return None
        own = function(role.symbol(name))
        high = None if function is sp.tan else 1
    elif role.high is not None:
        return None
    text = f"0 < {exact.sympy_text(value)}" + ("" if high is None else f" < {high}")
    if high is None:
        layout = relation(own, ">", sp.Integer(0))
    else:
        layout = relation(sp.Integer(0), "<", own, "<", sp.Integer(high))
    return value, (0, high), Limitation(text, layout, name)


_FUNCTIONS = {sp.acos: sp.cos, sp.asin: sp.sin, sp.atan: sp.tan}
"""An inverse function, and the one of the angle."""


def are_all_known(outcome: Outcome, trial: Trial) -> bool:
    """Whether all is known that a solution asks of the letters.

    It is not where this is too unwieldy for formulas, rests on signs that are seen and not proved,
    or hangs on an equation that is not decided for some senses of the letters.
    """
    values = trial.root.values.values()
    if not any(role in outcome.setting.roles for role in symbol_names(*values)):
        return True
    if trial.admission is None:
        return bool(_at_contacts(outcome, trial))
    if trial.admission.assumed:
        return False
    base = Oracle(trial.admission.roles, presupposed(outcome))
    return all(senses is not None for senses in _senses(base, trial))


def _of_senses(base: Oracle, trial: Trial) -> Iterator[Demand]:
    """For which signs of letters that may have either the equations of a solution hold.

    What was squared on the way to it is true for both signs of a letter, and the fact for one.
    """
    for senses in _senses(base, trial):
        if senses:
            either = senses[0] if len(senses) == 1 else Some(tuple(senses))
            yield Demand(either, "", "fact")


def _senses(base: Oracle, trial: Trial) -> Iterator[list[Formula] | None]:
    """The senses of letters in which each equation holds, none if in all; None if undecided."""
    for equation in () if trial.admission is None else trial.admission.equations:
        inside = {s for bar in atoms_in(equation, sp.Abs) for s in bar.free_symbols}
        letters = sorted(
            (s for s in inside if base.roles.get(s.name) == REAL), key=lambda s: s.name
        )
        if not 0 < len(letters) <= MOST_SENSES:
            continue
        claim = Relation(equation, "=")
        senses: list[Formula] = []
        every = list(product((1, -1), repeat=len(letters)))
        for signs in every:
            sense = joined(Relation(s * x, ">") for s, x in zip(signs, letters, strict=True))
            verdict = base.with_facts([sense]).decide(claim)
            if verdict.answer == "proved":
                senses.append(sense)
            elif verdict.answer == "undecided":
                yield None
                break
        else:
            yield senses if len(senses) < len(every) else []


def _at_contacts(outcome: Outcome, trial: Trial) -> tuple[Demand, ...]:
    """What the motion asks of places of contact, where the story is not told again with them.

    A time of flight and a size that are sought are positive, and so of no account in a product.
    """
    places = {name: x for name, x in trial.root.values.items() if name.startswith("_c_")}
    if not places:
        return ()
    roles = outcome.letters.all_roles()
    put = {roles[name].symbol(name): value for name, value in places.items()}
    demands: list[Demand] = []
    for need in outcome.open_story.conditions:
        if not isinstance(need, Condition):
            continue
        value = sp.together(sp.sympify(need.value, strict=True))
        if not value.free_symbols & put.keys():
            continue
        hidden = {other for other in value.free_symbols - put.keys() if other.name.startswith("_")}
        positive = [value for value in hidden if value.is_positive]
        value = sp.Mul(*(x for x in sp.Mul.make_args(value) if x.as_base_exp()[0] not in positive))
        value = forms.tidy(sp.together(value.xreplace(put)))
        demands.append(Demand(Relation(value, need.relation), need.reason, need.kind))
    return tuple(demands)


def range_limitations(outcome: Outcome, region: Region, values: sp.Set) -> tuple[Limitation, ...]:
    """For which of the other letters a range of one is not empty."""
    if not isinstance(values, sp.Interval) or region.proof == "undecided":
        return ()
    gap = _gap(values)
    if not region.trials:
        return ()
    facts = [
        formula for formula in presupposed(outcome) if region.letter not in letters_of(formula)
    ]
    base = Oracle(region.roles, tuple(facts))
    if gap is None or base.decide(gap.formula):
        return _defined(outcome, region.trials[0], base, values.args[:2])
    return tuple(_limits(outcome, region.trials[0], base, [gap]))


def half_limitations(
    outcome: Outcome,
    trial: Trial,
    region: Region | Image,
    relation: Relation,
    values: sp.Set,
) -> tuple[Limitation, ...]:
    """That a relation between data holds, and for which of these a range is not empty."""
    data = set(region.data())
    facts = [fact for fact in presupposed(outcome) if letters_of(fact) <= data]
    base = Oracle(region.roles, tuple(facts))
    demands = [Demand(relation, "", "fact")]
    gap = _gap(values) if isinstance(values, sp.Interval) else None
    if gap is not None and not base.with_facts([relation]).decide(gap.formula):
        demands.append(gap)
    return tuple(_plainly(base, trial, demands))


def defined(outcome: Outcome, trial: Trial, values: Iterable[sp.Expr]) -> tuple[Limitation, ...]:
    """For which letters values exist: no divisor is zero, and no root is that of less than zero."""
    if trial.admission is None:
        return ()
    base = Oracle(trial.admission.roles, presupposed(outcome))
    return _defined(outcome, trial, base, values)


def _defined(
    outcome: Outcome, trial: Trial, base: Oracle, values: Iterable[sp.Expr]
) -> tuple[Limitation, ...]:
    rest = [
        demand
        for demand in (Demand(relation, "", "fact") for relation in existence(values))
        if _is_of_visible_letters(demand)
        and letters_of(demand.formula) <= base.roles.keys()
        and not base.decide(demand.formula)
    ]
    return tuple(_limits(outcome, trial, base, _needed(base, rest))) if rest else ()


def always_exist(values: sp.Set, base: Oracle) -> bool:
    """Whether the ends of a range have values for all that the other letters may be."""
    ends = values.args[:2] if isinstance(values, sp.Interval) else ()
    return all(base.decide(demand) for demand in existence(ends))


def _gap(values: sp.Interval) -> Demand | None:
    """The demand that an interval is not empty."""
    if values.start.is_infinite or values.end.is_infinite:
        return None
    width = values.end - values.start
    if not width.free_symbols:
        return None
    lows = values.start.args if isinstance(values.start, sp.Max) else (values.start,)
    highs = values.end.args if isinstance(values.end, sp.Min) else (values.end,)
    open_ = bool(values.left_open or values.right_open)
    widths = [high - low for low, high in product(lows, highs) if (high - low).free_symbols]
    return Demand(joined(Relation(x, ">" if open_ else ">=") for x in widths), "", "fact")


def with_condition(
    answer: Answer, plain: Layout, limits: Sequence[Limitation], letter: str | None = None
) -> Answer:
    """An answer, perhaps for a letter, with the condition under which it holds."""
    if not limits:
        return answer
    condition = _listed(
        [
            limit.own if limit.own is not None and limit.letter == letter else limit.layout
            for limit in limits
        ]
    )
    layout = Phrase((plain, Phrase((Words("for"), condition))), ", ")
    return replace(
        answer,
        layout=layout,
        display=to_text(layout),
        condition=tuple(limit.text for limit in limits),
        condition_layout=condition,
    )


def _listed(conditions: Sequence[Layout]) -> Layout:
    """Conditions that all have to hold: ``u > v, k ≥ 1 and m ≤ M``."""
    *others, last = conditions
    if not others:
        return last
    split = any(isinstance(condition, Phrase) for condition in conditions)
    return Phrase((Phrase(tuple(others), ", "), last), ", and " if split else " and ")


def presupposed(outcome: Outcome) -> tuple[Formula, ...]:
    """What the statement asks of its letters before anything is solved."""
    story = outcome.open_story
    try:
        needs = [*story.conditions, *outcome.setting.requirements(story)]
    except RestitutionError:
        return ()
    sought = {name for trial in outcome.trials for name in trial.root.values}
    demands, _ = demands_for(needs)
    return tuple(
        dict.fromkeys(
            demand.formula
            for demand in demands
            if _is_of_visible_letters(demand) and not letters_of(demand.formula) & sought
        )
    )


def _is_of_visible_letters(demand: Demand) -> bool:
    """Whether a demand is one of the letters that people see."""
    names = letters_of(demand.formula)
    return bool(names) and not any(name.startswith("_") for name in names)


def _needed(base: Oracle, demands: list[Demand]) -> list[Demand]:
    """Demands of which none follows from the others, the shortest of them kept."""
    kept = sorted(demands, key=_size)
    for demand in reversed(list(kept)):
        others = [other for other in kept if other is not demand]
        if _follows(base, demand.formula, [other.formula for other in others]):
            kept = others
    return kept


def _follows(base: Oracle, formula: Formula, others: Sequence[Formula]) -> bool:
    """Whether a demand follows from others, by what they say where each of them has a value.

    That a root has a value follows from no relation in which it stands: of this the root may be
    left out when it is printed, as a factor whose sign is known.
    """
    rooted = [other for other in others if _roots_in(other)]
    plain = base.with_facts(other for other in others if other not in rooted)
    facts = [*plain.facts, *(x for x in rooted if all(map(plain.proves, _roots_in(x))))]
    return len(facts) > len(base.facts) and bool(Oracle(base.roles, tuple(facts)).decide(formula))


def _roots_in(formula: Formula) -> list[Relation]:
    """That what stands under the roots of a formula is not negative."""
    values = [relation.value for relation in relations(formula)]
    return [demand for demand in existence(values) if demand.operator != "!="]


def _size(demand: Demand) -> int:
    return sum(int(sp.count_ops(inequality.value)) for inequality in relations(demand.formula))


def _limits(
    outcome: Outcome, trial: Trial, base: Oracle, demands: list[Demand]
) -> Iterator[Limitation]:
    if not demands:
        return
    names = sorted(
        {name for demand in demands for name in letters_of(demand.formula)},
        key=lambda name: (KINDS.index(_role(base, name).kind), -_share(name, demands), name),
    )
    for name in names if len(names) <= MOST_LETTERS else []:
        region = _region(outcome, trial, base, demands, name)
        if region is None:
            continue
        gap = _gap(region) if isinstance(region, sp.Interval) else None
        proved = gap is None or base.decide(gap.formula)
        if not proved and not _is_everywhere(base, region):
            continue  # where an end has no value, nothing is said of the letter
        bounds = bounds_of(name, region, base.roles)
        if _has_roots(region):
            plain = list(_plainly(base, trial, demands))
            if sum(len(limitation.text) for limitation in plain) < len(bounds.text):
                yield from plain
                return
        yield bounds
        # For which of the other letters there are such values at all.
        if gap is not None and not proved:
            yield from _limits(outcome, trial, base, [gap])
        return
    yield from _plainly(base, trial, demands)


def _is_everywhere(base: Oracle, values: sp.Interval) -> bool:
    """Whether the ends of an interval have values for all values of the other letters."""
    for end in values.args[:2]:
        below = sp.fraction(sp.together(end))[1]
        if not below.is_number and not base.decide(Relation(below, "!=")):
            return False
    return True


def _has_roots(values: sp.Set) -> bool:
    """Whether letters stand under roots in the ends of some intervals."""
    parts = values.args if isinstance(values, sp.Union) else (values,)
    ends = [end for part in parts if isinstance(part, sp.Interval) for end in part.args[:2]]
    return any(
        x.base.free_symbols for end in ends for x in end.atoms(sp.Pow) if not x.exp.is_Integer
    )


def _plainly(base: Oracle, trial: Trial, demands: Sequence[Demand]) -> Iterator[Limitation]:
    """The inequalities themselves, without those that follow from the others."""
    facts = list(dict.fromkeys(inequality for d in demands for inequality in relations(d.formula)))
    for fact in facts:
        others = [other for other in facts if other != fact]
        if base.decide(fact) or _follows(base, fact, others):
            facts = others
    yield from _inequalities(base, trial, facts)


def _inequalities(base: Oracle, trial: Trial, facts: Sequence[Relation]) -> Iterator[Limitation]:
    """Inequalities themselves; two that bound what was found for a letter as one, if shorter.

    Of a product that is not zero no factor is.
    """
    left = [part for fact in facts for part in _factors_apart(base, fact)]
    for name, root in trial.root.values.items():
        for low in [inequality for inequality in left if inequality.value == root]:
            high = next(
                (inequality for inequality in left if (inequality.value + root).is_number), None
            )
            if high is None or not {low.operator, high.operator} <= {">", ">="}:
                continue
            plain = [_stated(own) for own in _simplified(base, (low, high))]
            chain = _chain(name, low, high)
            if len(chain.text) < sum(len(limitation.text) for limitation in plain):
                left = [inequality for inequality in left if inequality not in (low, high)]
                yield chain
    yield from map(_stated, _simplified(base, left))


def _factors_apart(base: Oracle, inequality: Relation) -> Iterator[Relation]:
    """That no factor of a product is zero, and so each positive that is not negative anyway.

    A product that is positive stays one where some of its factors may be negative.
    """
    sides = sp.together(inequality.value).as_numer_denom()
    bases = [x for side in sides for x in _bases(side) if not x.is_number]
    positive = [bool(base.decide(Relation(factor, ">="))) for factor in bases]
    strict = inequality.operator == ">" and all(positive)
    if len(bases) < 2 or not (strict or inequality.operator == "!="):
        yield inequality
        return
    for factor, sign in zip(bases, positive, strict=True):
        yield Relation(factor, ">" if sign else "!=")


def _bases(side: sp.Expr) -> Iterator[sp.Expr]:
    """What stands in the factors of a product, without powers and roots."""
    for factor in sp.Mul.make_args(sp.factor(side)):
        if factor.is_Pow or factor.is_Mul:
            yield from _bases(factor.base if factor.is_Pow else factor)
        else:
            yield factor


def _chain(name: str, low: Relation, high: Relation) -> Limitation:
    """The limitation 0 ≤ e ≤ 1 for the value of e."""
    value, top = forms.tidy(low.value), high.value + low.value
    (before, shown_before), (after, shown_after) = (
        ("<", "<") if bound.operator == ">" else ("<=", "≤") for bound in (low, high)
    )
    layout, own = (
        relation(sp.Integer(0), shown_before, x, shown_after, top) for x in (value, sp.Symbol(name))
    )
    text = f"0 {before} {exact.sympy_text(value)} {after} {exact.sympy_text(top)}"
    return Limitation(text, layout, name, own)


def _role(base: Oracle, name: str) -> Role:
    return base.roles[name]


def _share(name: str, demands: list[Demand]) -> int:
    return sum(name in letters_of(demand.formula) for demand in demands)


def _region(
    outcome: Outcome, trial: Trial, base: Oracle, demands: list[Demand], name: str
) -> sp.Set | None:
    """The values of one letter that the demands allow."""
    own = replace(outcome, trials=(trial,))
    try:
        region = Region(own, name, (), base, tuple(demands))
        pieces = region.pieces()
    except (RestitutionError, BeyondError):
        return None
    if not pieces or region.proof == "undecided":
        return None
    if len(pieces) > 1:
        # Values that the statement itself excludes need not be told apart.
        pieces = [
            piece
            for piece in pieces
            if base.with_facts([inside_of(region.symbol, [piece])]).possible.answer != "refuted"
        ]
    return to_set(pieces) if pieces else None


def bounds_of(name: str, values: sp.Set, roles: Mapping[str, Role]) -> Limitation:
    """The limitation of a letter to these values, without what its role implies."""
    role = roles[name]
    symbol = role.symbol(name)
    if isinstance(values, sp.Interval):
        # An end that holds of the letter anyway need not be said.
        low, high = values.start, values.end
        if isinstance(low, sp.Max) and role.low in low.args:
            low = sp.Max(*(end for end in low.args if end != role.low))
        if isinstance(high, sp.Min) and role.high in high.args:
            high = sp.Min(*(end for end in high.args if end != role.high))
        if role.low is not None and low == role.low and values.left_open != role.closed[0]:
            low = -sp.oo
        if role.high is not None and high == role.high and values.right_open != role.closed[1]:
            high = sp.oo
        values = sp.Interval(low, high, values.left_open, values.right_open)
    layout = from_set(values, symbol, degrees=role.kind == "angle")
    holes = sp.Complement(sp.S.Reals, values, evaluate=True)
    if isinstance(holes, sp.FiniteSet) and len(holes) == 1:
        layout = relation(symbol, "≠", *holes)  # and not *for all real v, v ≠ 0*
    return Limitation(" or ".join(_chains(name, values)), layout)


def _chains(name: str, values: sp.Set) -> Iterator[str]:
    if isinstance(values, sp.FiniteSet):
        yield from (f"{name} = {exact.sympy_text(argument)}" for argument in values.args)
    elif isinstance(values, sp.Union):
        for part in values.args:
            yield from _chains(name, part)
    elif isinstance(values, sp.Interval):
        text = name
        if values.start != -sp.oo:
            sign = "<" if values.left_open else "<="
            text = f"{exact.sympy_text(values.start)} {sign} {text}"
        if values.end != sp.oo:
            sign = "<" if values.right_open else "<="
            text = f"{text} {sign} {exact.sympy_text(values.end)}"
        yield text


def _simplified(base: Oracle, inequalities: Sequence[Relation]) -> list[Relation]:
    """Inequalities without factors whose sign is known, and without those that follow."""
    own = list(dict.fromkeys(filter(None, (_simpler(base, other) for other in inequalities))))
    own = strict(own)
    for inequality in list(own):
        others = [other for other in own if other != inequality]
        if _follows(base, inequality, others):
            own = others
    return own


def _simpler(base: Oracle, inequality: Relation) -> Relation | None:
    """An inequality without the factors whose sign is known; None if all are."""
    above, below = (_of_open_sign(base, x) for x in sp.together(inequality.value).as_numer_denom())
    operator = inequality.operator
    if operator == ">=" and above.is_number:
        operator = ">"  # what divides is not zero
    quotient = above / below if operator == ">=" else above * below
    bars = {
        node: sign * node.args[0]
        for node in quotient.atoms(sp.Abs)
        if (sign := base.sign(node.args[0])) is not None
    }
    value = sp.Integer(1)
    for factor in sp.Mul.make_args(forms.tidy(quotient.xreplace(bars))):
        sign = base.sign(factor)
        value *= factor if sign is None else sign
    if value.is_number and value.is_positive:
        return None
    for root in [x for x in sp.Mul.make_args(value) if x.is_Pow and x.exp == sp.S.Half]:
        # A root is positive where the rest is, unless what stands below it may be zero there.
        rest = value / root
        if operator == ">" and rest == 1:
            value = root.base
        elif operator == ">" and _follows(base, Relation(root.base, ">"), [Relation(rest, ">")]):
            value = rest
    return Relation(value, operator)


def _stated(inequality: Relation) -> Limitation:
    """An inequality as it is read: with what is taken away, or a number, on the right."""
    left, right = inequality.value, sp.Integer(0)
    operator: str = inequality.operator
    if left.is_Add and len(left.args) == 2:
        minus = [x for x in left.args if x.could_extract_minus_sign()]
        if len(minus) == 1:
            left, right = left - minus[0], -minus[0]
    if left.is_number and operator in _TURNED:
        left, right, operator = right, left, _TURNED[operator]
    text = f"{exact.sympy_text(left)} {operator} {exact.sympy_text(right)}"
    return Limitation(text, relation(left, _SIGNS[operator], right))


def _of_open_sign(base: Oracle, side: sp.Expr) -> sp.Expr:
    """An expression without the factors whose sign is known, but for the sign itself."""
    try:
        parts = factors(sp.expand(side))
    except sp.PolynomialError:
        parts = (side,)
    content = sp.cancel(sp.expand(side) / sp.Mul(*parts)) if parts else side
    if not content.is_number:
        content, parts = sp.Integer(1), (side,)
    product = sp.sign(content)
    for factor in parts:
        sign = base.sign(factor)
        product *= factor if sign is None else sign
    return product
