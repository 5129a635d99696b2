"""The equations of a part: which unknowns they determine, and the roots of these."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import permutations

import sympy as sp

from restitution.errors import StatementError, UnsupportedError
from restitution.exact.symbols import operations_in, symbol_names, symbols_in
from restitution.expression.enclosed import UndefinedError
from restitution.expression.evaluate import Angle, Evaluator
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Number,
    Quantity,
    has_quantity,
    letters,
)
from restitution.oracle import Oracle, Some, compared
from restitution.oracle.roles import REAL, Role
from restitution.problem import Compare, Find, Impact, Show
from restitution.records import dataclass
from restitution.solving.algebra.numbers import at
from restitution.solving.algebra.systems import Root, solve_system
from restitution.solving.equations.setting import Setting, out_of_range
from restitution.solving.equations.stages import fixed_besides, solve_in_stages
from restitution.solving.story import missing
from restitution.solving.story.conditions import AnyOf, Condition
from restitution.solving.story.unknowns import SYMBOLIC, Letters

# The letters of which a fact mostly ties one to another.
_TIED = ("angle", "restitution")


@dataclass(frozen=True)
class Decision:
    """The choice of one letter that the left-over facts are taken to fix."""

    present: frozenset[str]
    chosen: frozenset[str]
    letter: str | None


def equations_of_letters(setting: Setting) -> list[tuple[Expression, Expression]]:
    """The sides of what the facts say of letters alone."""
    return [
        (left, right)
        for given, _ in setting.facts
        for relation in given.relations
        if isinstance(relation, Compare)
        for left, op, right in zip(
            relation.operands, relation.operators, relation.operands[1:], strict=False
        )
        if op == "="
        and not has_quantity(left)
        and not has_quantity(right)
        and not letters_of_pair((left, right)) & set(setting.lets)
    ]


def letters_of_pair(pair: tuple[Expression, Expression]) -> frozenset[str]:
    """The letters of both sides of an equation."""
    return letters(pair[0]) | letters(pair[1])


def letter_branches(
    setting: Setting,
) -> list[tuple[dict[str, sp.Expr], dict[str, tuple[sp.Expr, sp.Expr]]]]:
    """Values of letters that facts between letters alone give, before the story is told."""
    symbols = Letters(setting.roles)
    equations = equations_of_letters(setting)
    branches: list[tuple[dict[str, sp.Expr], dict[str, tuple[sp.Expr, sp.Expr]]]] = [({}, {})]
    if not equations:
        return branches
    evaluator = Evaluator(SYMBOLIC, symbols.letter)
    pending: list[sp.Expr] = []
    for left, right in equations:
        try:
            a, b = evaluator.value(left), evaluator.value(right)
        except StatementError:
            continue
        if isinstance(a, tuple) or isinstance(b, tuple):
            continue
        a = a.measure() if isinstance(a, Angle) else a
        b = b.measure() if isinstance(b, Angle) else b
        pending.append(sp.sympify(a - b, strict=True))
    taken: set[str] = set()
    # A letter alone on one side stands for the other side.
    substitutions: dict[sp.Symbol, sp.Expr] = {}
    for left, right in equations:
        for lone, other in ((left, right), (right, left)):
            if not isinstance(lone, Letter) or lone.name in setting.protected | setting.spared:
                continue
            if lone.name in letters(other) or lone.name in taken or not letters(other):
                continue
            if lone.name in setting.asked:
                continue
            value = evaluator.scalar(other).xreplace(substitutions)
            symbol = setting.roles[lone.name].symbol(lone.name)
            if symbol in symbols_in(value):
                continue
            substitutions = {k: v.xreplace({symbol: value}) for k, v in substitutions.items()}
            substitutions[symbol] = value
            taken.add(lone.name)
            break
    for equation in pending:
        _substitute_linear(setting, equation, substitutions)
    branches = [({s.name: v for s, v in substitutions.items()}, {})]
    progress = True
    while progress:
        progress = False
        for equation in list(pending):
            new = []
            for values, angles in branches:
                put = {setting.roles[n].symbol(n): v for n, v in values.items()}
                current = sp.sympify(equation.xreplace(put), strict=True)
                current = current.doit() if symbols_in(current) else current
                free = symbols_in(current)
                if len(free) != 1:
                    new.append((values, angles))
                    continue
                (x,) = free
                progress = True
                for assignment in _one_letter(setting, current, x):
                    value = assignment.values[x.name]
                    deeper = {n: v.xreplace({x: value}) for n, v in values.items()}
                    new.append(({**deeper, **assignment.values}, {**angles, **assignment.angles}))
            if any(len(b[0]) != len(a[0]) for a, b in zip(branches, new, strict=False)) or len(
                new
            ) != len(branches):
                pending.remove(equation)
            branches = new
    return branches


def _substitute_linear(
    setting: Setting, equation: sp.Expr, substitutions: dict[sp.Symbol, sp.Expr]
) -> None:
    """β = 90° − α from α + β = 90°: angles that stand as themselves are not left under a sine."""
    current = sp.expand(equation.xreplace(substitutions))
    if len(current.free_symbols) < 2:
        return
    terms = _wanted_in_answers(setting)

    def rank(symbol: sp.Symbol) -> tuple[bool, bool]:
        return symbol.name in setting.asked, symbol.name in terms

    # Of two angles alike the first letter stays.
    names = sorted(current.free_symbols, key=lambda symbol: symbol.name, reverse=True)
    for symbol in sorted(names, key=rank):
        coefficient = current.coeff(symbol)
        rest = sp.expand(current - coefficient * symbol)
        if (
            setting.roles[symbol.name].kind != "angle"
            or symbol.name in setting.protected | setting.spared
            or not coefficient.is_Rational
            or coefficient == 0
            or rest.has(symbol)
        ):
            continue
        value = sp.expand(-rest / coefficient)
        for key, old in substitutions.items():
            substitutions[key] = old.xreplace({symbol: value})
        substitutions[symbol] = value
        return


def _one_letter(setting: Setting, equation: sp.Expr, x: sp.Symbol) -> list[Root]:
    role = setting.roles[x.name]
    is_angle = role.kind == "angle"
    if is_angle and not equation.has(sp.sin, sp.cos, sp.tan, sp.cot):
        is_angle = False
    acute = frozenset({x}) if _acute(role) else frozenset()
    kept = []
    for assignment in solve_system(
        [equation], [x], frozenset({x}) if is_angle else frozenset(), acute, setting.roles
    ):
        if x.name not in assignment.values:
            continue
        try:
            value = at(assignment.values[x.name], {})
        except (UndefinedError, KeyError):
            continue
        wrong = out_of_range(x.name, value, role)
        if wrong is None or wrong[1] == "coefficient":  # which is refused with its reason, later
            kept.append(assignment)
    return kept


def _acute(role: Role) -> bool:
    return bool(
        role.kind == "angle"
        and role.low is not None
        and role.high is not None
        and role.low >= 0
        and role.high <= sp.pi / 2
    )


def solve_equations(
    setting: Setting,
    letters_: Letters,
    equations: Sequence[sp.Expr],
    decisions: list[Decision],
    conditions: Sequence[Condition | AnyOf] = (),
) -> list[Root]:
    """Solutions for hidden unknowns, for letters asked for, and for letters the facts fix."""
    values = [equation for equation in equations if equation != 0]
    known = letters_.all_roles()
    chosen = setting.unknown - set(letters_.values)
    for _ in range(8):
        unknowns = _ranked(setting, letters_, values, chosen)
        angles = frozenset(s for s in unknowns if setting.roles.get(s.name, REAL).kind == "angle")
        acute = frozenset(s for s in angles if _acute(setting.roles[s.name]))
        letter = None
        present = fixed_besides(values, unknowns)
        if present:
            letter = to_fix(setting, present, chosen)
            decisions.append(Decision(present, chosen, letter))
        if letter is not None:
            chosen = chosen | {letter}
            continue
        try:
            assignments = solve_in_stages(values, unknowns, angles, acute, known, conditions)
        except UnsupportedError as error:
            if len(unknowns) <= len(values):
                raise
            raise missing.too_many(
                letters_.phrases.get(s.name, s.name) for s in unknowns
            ) from error
        assignments = _without_contradictions(assignments, known)
        leftover = [value for one in assignments for value in one.leftover]
        if assignments and all(_is_undefined(values, one) for one in assignments):
            leftover = values  # of a direction in two letters only their ratio can be found
        if not leftover:
            return assignments
        present = symbol_names(*leftover)
        letter = to_fix(setting, present, chosen)
        decisions.append(Decision(present, chosen, letter))
        if letter is None:
            kept = [one for one in assignments if not one.leftover]
            return kept
        chosen = chosen | {letter}
    raise UnsupportedError("the facts fix more letters than can be sorted out")


# A longer equation that is left over is not looked at by itself.
_SHORT = 12


def _without_contradictions(roots: list[Root], known: Mapping[str, Role]) -> list[Root]:
    """The roots without those that leave over equations which cannot all hold.

    No angle has a sine and a cosine of zero. Where all roots leave something over they are all
    kept.
    """
    if all(root.leftover for root in roots) or not any(root.leftover for root in roots):
        return roots
    return [root for root in roots if not _is_contradictory(root.leftover, known)]


def _is_contradictory(equations: Sequence[sp.Expr], known: Mapping[str, Role]) -> bool:
    """Whether certainly not all of some short expressions are zero."""
    plain = [value for value in equations if operations_in(value) <= _SHORT]
    plain = [value for value in plain if symbol_names(value) <= set(known)]
    claim = Some(tuple(compared(value, "!=", sp.Integer(0)) for value in plain))
    return bool(plain) and Oracle(known).proves(claim)


def _is_undefined(equations: Sequence[sp.Expr], root: Root) -> bool:
    """Whether equations have no value at a root, as it makes a vector of no length a direction."""
    at = {s: root.values[s.name] for e in equations for s in symbols_in(e) if s.name in root.values}
    if list(at.values()).count(sp.Integer(0)) < _PARTS:
        return False
    return any(equation.subs(at, simultaneous=True).has(sp.nan, sp.zoo) for equation in equations)


_PARTS = 2


def _ranked(
    setting: Setting,
    letters_: Letters,
    equations: Sequence[sp.Expr],
    chosen: frozenset[str],
) -> list[sp.Symbol]:
    """The unknowns in these equations, in the order in which to eliminate them."""
    present = {s for equation in equations for s in symbols_in(equation)}

    def rank(symbol: sp.Symbol) -> tuple[int, str]:
        name = symbol.name
        if name.startswith("_"):
            return 0, name
        if name in setting.asked:
            return 2, name
        return 1, name

    return sorted((s for s in present if s.name.startswith("_") or s.name in chosen), key=rank)


def to_fix(setting: Setting, present: frozenset[str], chosen: frozenset[str]) -> str | None:
    """Which of the letters in left-over facts they are taken to fix."""
    # What is to be eliminated is fixed by no fact: it stays where these contradict each other.
    present = frozenset(name for name in present if not name.startswith("_"))
    candidates = present - chosen - setting.protected
    candidates = candidates - setting.spared or candidates
    if not candidates:
        # Facts may fix a letter that answers were to be in terms of: then they need not be.
        candidates = present - chosen - setting.fixed
    if not candidates:
        return None
    left_out = any(
        isinstance(step, Impact) and step.e is None for _, step in setting.problem.steps()
    )
    subjects = [own for step in setting.shows for own in _subjects(step)]
    shown = {own.name for own, _ in subjects if isinstance(own, Letter)}
    of_ratios = {name for own, _ in subjects for name in letters(own)} - shown
    equated = {
        operand.name
        for given, _ in setting.facts
        for relation in given.relations
        if isinstance(relation, Compare) and any(has_quantity(t) for t in relation.operands)
        for operand in relation.operands
        if isinstance(operand, Letter)
    }
    in_shows = {
        name
        for step in setting.shows
        if isinstance(step.relation, Compare)
        for tree in step.relation.operands
        if not has_quantity(tree)
        for name in letters(tree)
    }
    terms = _wanted_in_answers(setting)
    stated = _stated_of_quantities(setting)
    if not any(setting.roles[name].kind in _TIED for name in candidates - stated):
        stated = set()

    def priority(name: str) -> tuple[int, str]:
        role = setting.roles[name]
        if name in shown:
            return 0, name
        if name in of_ratios:
            return 1, name
        if name in stated:
            return 9, name
        if name == "e" and left_out:
            return 2, name
        if name in equated:
            return 3, name
        if role.kind == "restitution":
            return 4, name
        if name in terms:
            return 9, name
        if name in in_shows:
            return 5, name
        if role.kind == "angle":
            return 6, name
        if role.kind == "real":
            return 7, name
        return 8, name

    chosen_letter: str = min(candidates, key=priority)
    return chosen_letter


def _wanted_in_answers(setting: Setting) -> set[str]:
    """The letters in which answers are to be written, or a claim says what a letter is."""
    listed = {
        name
        for step in setting.part.steps
        if isinstance(step, Find | Show)
        for name in step.in_terms_of or ()
    }
    return listed | {
        name
        for step in setting.shows
        for _, tree in _subjects(step)
        if not isinstance(tree, Letter) and not has_quantity(tree)
        for name in letters(tree)
    }


def _subjects(step: Show) -> Iterator[tuple[Expression, Expression]]:
    """What a claim says something of, a letter or a ratio of it, with a side that says it.

    A ratio of an angle, or a power of one, speaks of the angle: ``tan^2 alpha = e^3``.
    """
    if not isinstance(step.relation, Compare):
        return
    for own, other in permutations(step.relation.operands, 2):
        match own:
            case Letter():
                yield own, other
            case Apply("sin" | "cos" | "tan", Letter(name)) | Binary(
                "^", Apply("sin" | "cos" | "tan", Letter(name)), Number()
            ) if step.relation.operators == ("=",) and name not in letters(other):
                yield own, other


def _stated_of_quantities(setting: Setting) -> set[str]:
    """The letters in which claims say what a quantity is: e in ``energy_lost = 1/2 m u^2 (1 - e)``.

    So a fact that ties such a letter to another is taken to fix the other one. The quantity may
    have a letter of the statement, as in ``v^2 = e u^2``; that of an angle is sought itself.
    """
    named = {
        name
        for name, (let, _) in setting.lets.items()
        if isinstance(let.expression, Quantity) and let.expression.kind not in ANGLES
    }
    return {
        name
        for step in setting.shows
        if isinstance(step.relation, Compare) and step.relation.operators == ("=",)
        for own, other in permutations(step.relation.operands, 2)
        if (has_quantity(own) or letters(own) & named) and not has_quantity(other)
        for name in letters(other) - named
    }


def put_back(
    values: Mapping[str, sp.Expr], angles: Mapping[str, tuple[sp.Expr, sp.Expr]], assignment: Root
) -> Root:
    """The root with the values and angles of `letter_branches`, its own values put in."""
    put: dict[sp.Symbol, sp.Expr] = {}
    combined = dict(assignment.values)
    pairs = dict(assignment.angles)
    for name, value in values.items():
        symbols = {s for s in value.free_symbols if s.name in assignment.values}
        put = {s: assignment.values[s.name] for s in symbols}
        combined[name] = value.xreplace(put) if put else value
        if name in angles and not put:
            pairs[name] = angles[name]
    return Root(combined, pairs, assignment.leftover)
