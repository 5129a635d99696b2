"""A teacher's own question with other numbers, under the rules of practice.

Data are changed where they stand: masses, velocities, coefficients, angles, tangents. A value that
is given of the motion afterwards, or printed to be shown, follows from the others: it is worked out
again. What cannot be varied stays as it is, and the reason is told.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from math import isqrt
from typing import Any

from restitution.errors import RestitutionError, UnsupportedError
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Negate,
    Number,
    Pair,
    Polar,
    Unit,
    has_quantity,
    is_binary,
    is_function,
    letters,
    walk,
)
from restitution.practice.questions.dice import Dice
from restitution.practice.questions.nice import COEFFICIENTS, TRIPLES, ugly_value
from restitution.problem import (
    Compare,
    Find,
    Given,
    Impact,
    Problem,
    Relation,
    Show,
    Step,
    Value,
    trees_of_step,
)
from restitution.records import dataclass
from restitution.solving.equations.solution import ItemResult, Solution

MOST_DRAWS = 2000
_ANGLES = (30, 45, 60)
_SCREENED = 300  # draws in which values as plain as those of the original are sought,
_SOLVED = 10  # of which so many are solved; then the plainest of them is taken,
_CHOICES = 3  # or the plainest of so many draws, where each takes longer
_ROOTED = 100  # draws that are passed over for roots in values that are given
_SAME = 40  # draws that change nothing tell that there is nothing to be changed


@dataclass(frozen=True)
class Variant:
    """A statement with other numbers. ``notes`` tell what was not varied, and why."""

    statement: str
    seed: int
    notes: tuple[str, ...]
    draws: int = 1


def variant(problem: Problem, seed: int = 1) -> Variant:
    """A question like another, the same for the same seed.

    Raises the error of a question that has no answer, and UnsupportedError where what is to be
    shown is not true, nothing can be varied, or no draw is fit to be set: it names what was most
    often in the way.
    """
    from restitution.practice.questions.diagnosis import clash
    from restitution.solving import solve

    original = solve(problem)
    _require_answers(original)
    _require_truth(original)
    wants_apart = clash(original) is None
    notes = [*_notes(problem)]
    if not wants_apart:
        notes.append("some mistakes lead to the same answer in the question, and may do so here")
    _require_letters(problem, original)
    draws = _Draws(problem, original, seed)

    def fit(drawn: _Drawn) -> bool:
        pair = clash(drawn.solution) if wants_apart else None
        if pair is not None:
            draws.why[f"{pair} lead to the same answers"] += 1
        return pair is None

    solved = _CHOICES if any(True for _ in _followers(problem)) else _SOLVED
    for screened, most, choices in ((True, _SCREENED, solved), (False, MOST_DRAWS, _CHOICES)):
        waiting: list[_Drawn] = []
        for drawn in draws.drawn(most, screened=screened):
            waiting.append(drawn)
            if any(drawn.beyond) and len(waiting) < choices:
                continue
            best = next(
                (candidate for candidate in sorted(waiting, key=_by_excess) if fit(candidate)), None
            )
            if best is not None:
                return _headed(best, seed, notes)
            waiting.clear()
        best = next(
            (candidate for candidate in sorted(waiting, key=_by_excess) if fit(candidate)), None
        )
        if best is not None:
            return _headed(best, seed, notes)
    raise UnsupportedError(
        f"no question like this was found in {MOST_DRAWS} draws: most often "
        f"{draws.why.most_common(1)[0][0]}"
    )


VARIATION = 4
"""The version of what a seed draws here, raised where the same seed gives another variant.

It is none of the generator, whose questions no seed of a variant changes.
"""


@dataclass(frozen=True)
class _Drawn:
    """A draw that is solved. ``beyond`` is by how much it is less plain than the original.

    What is given comes first.
    """

    draw: int
    text: str
    solution: Solution
    beyond: tuple[int, ...]


def _by_excess(drawn: _Drawn) -> tuple[tuple[int, ...], int]:
    return drawn.beyond, drawn.draw


def _headed(drawn: _Drawn, seed: int, notes: Sequence[str]) -> Variant:
    head = f"# like another question, seed {seed}  (version {VARIATION} of variants)\n"
    return Variant(head + drawn.text, seed, tuple(notes), drawn.draw)


class _Draws:
    """The draws of a question, one by one. ``why`` counts what stood in their way."""

    def __init__(self, problem: Problem, original: Solution, seed: int) -> None:
        from restitution.practice.questions.plainness import Screen

        self.problem, self.original, self.seed = problem, original, seed
        self.why: Counter[str] = Counter()
        self._simple = not ugly_value(original)
        self._follows = any(True for _ in _followers(problem))
        self._screen = Screen(original)

    def drawn(self, most: int, *, screened: bool) -> Iterator[_Drawn]:
        """The draws that are alike; with ``screened`` without those seen to be less plain."""
        from restitution.practice.questions.generate import VERSION
        from restitution.practice.questions.plainness import excess

        unchanged = rooted = 0
        for draw in range(1, most + 1):
            dice = Dice(f"{VERSION}/like/{self.seed}/{draw}")
            changed = _redrawn(self.problem, dice)
            if replace(changed, title=self.problem.title) == self.problem:
                unchanged += 1
                if unchanged == draw == _SAME and not self._follows:
                    message = "nothing in this question can be varied: it has no numbers"
                    raise UnsupportedError(message)
                if not self._follows:
                    continue
            try:
                changed = _consistent(changed, self.problem, self.original, dice)
                if screened and not self._screen.passes(changed):
                    continue
                if screened and self._has_new_roots(changed):
                    rooted += 1
                    if rooted < _ROOTED:
                        continue
                text, solution = _solved(changed, self.original)
            except RestitutionError as error:
                self.why[error.message] += 1
                continue
            if self._simple and (ugly := ugly_value(solution)):
                self.why[f"{ugly} is no simple number"] += 1
                continue
            beyond = excess(solution, self.original)
            yield _Drawn(draw, text, solution, (int(self._has_new_roots(changed)), *beyond))

    def _has_new_roots(self, changed: Problem) -> bool:
        """Whether what is given has roots, and has none in the original."""
        return _has_roots_given(changed) and not _has_roots_given(self.problem)


def _has_roots_given(problem: Problem) -> bool:
    return any(
        is_function(node, "sqrt")
        for _, step in problem.steps()
        if isinstance(step, Given)
        for tree in trees_of_step(step)
        for node in walk(tree)
    )


def _solved(changed: Problem, original: Solution) -> tuple[str, Solution]:
    """A changed question as text, and solved; UnsupportedError where it is not alike."""
    from restitution.language import parse, to_statement
    from restitution.solving import solve

    text = to_statement(changed)
    read = parse(text)
    if read.notes and not original.problem.notes:
        raise UnsupportedError("the notation would be doubtful")
    solution = solve(read)
    _require_alike(solution, original)
    return text, solution


def _require_answers(solution: Solution) -> None:
    if solution.error is not None:
        raise solution.error
    for part in solution.parts.values():
        for item in part.items:
            if item.error is not None:
                raise item.error


def _require_truth(solution: Solution) -> None:
    """What is to be shown is true: a value that is worked out again would be."""
    for words, line in solution.refutations():
        raise UnsupportedError(f"this question cannot be varied: {words}", line)


def _require_letters(problem: Problem, solution: Solution) -> None:
    """What is unknown can be given, where facts tell values of the motion afterwards."""
    if not any(True for _ in _followers(problem)):
        return
    for part in solution.parts.values():
        for branch in part.branches[:1]:
            for name in branch.values:
                if name.startswith("_") and not name.startswith("_m_"):
                    raise UnsupportedError(
                        "this question cannot be varied: a line of centres or a velocity is "
                        "unknown, and the values given of the motion afterwards rest on it"
                    )


def _require_alike(solution: Solution, original: Solution) -> None:
    """A variant has as many answers to each item as the question, and what is to be shown holds."""
    _require_answers(solution)
    for one, other in zip(_items(solution), _items(original), strict=True):
        if len(one.distinct) != len(other.distinct):
            raise UnsupportedError(f"{one.text} would have another number of answers")
        if one.kind == "show" and one.holds != other.holds:
            raise UnsupportedError(f"{one.text} would not hold")


def _items(solution: Solution) -> list[ItemResult]:
    return [item for part in solution.parts.values() for item in part.items]


# --- data ---------------------------------------------------------------------------------------


def _redrawn(problem: Problem, dice: Dice) -> Problem:
    """A problem with its data drawn again; values of the motion afterwards are left as they are."""
    parts = tuple(
        replace(part, steps=tuple(_step(step, dice) for step in part.steps))
        for part in problem.parts
    )
    changed = replace(problem, parts=parts)
    old, new = _hypotenuses(problem), _hypotenuses(changed)
    spheres = tuple(
        replace(
            sphere,
            mass=_scaled(sphere.mass, lambda old: _mass(old, dice)),
            velocity=_velocity(sphere.velocity, dice, _fit_to(sphere.velocity, old, new)),
        )
        for sphere in problem.spheres
    )
    title = None if _tells_a_number(problem.title) else problem.title  # it is another one now
    return replace(changed, title=title, spheres=spheres)


def _tells_a_number(title: str | None) -> bool:
    return title is not None and any(character.isdigit() for character in title)


def _hypotenuses(problem: Problem) -> dict[str, int]:
    """The hypotenuse of the triangle of whole sides, for each letter of which facts tell one."""
    sides: dict[str, int] = {}
    for _, step in problem.steps():
        for relation in step.relations if isinstance(step, Given) else ():
            match relation:
                case Compare(
                    (
                        Apply("tan" | "sin" | "cos" as function, Letter(name)),
                        Binary("/", Number(top), Number(under)),
                    ),
                    ("=",),
                ) if under:
                    ratio = top / under
                    if function != "tan":
                        sides[name] = ratio.denominator
                        continue
                    square = ratio.numerator**2 + ratio.denominator**2
                    if isqrt(square) ** 2 == square:
                        sides[name] = isqrt(square)
    return sides


def _fit_to(velocity: Any, old: Mapping[str, int], new: Mapping[str, int]) -> int:
    """The number that divides a new speed, for whole components, where it divides the old one."""
    if isinstance(velocity, Polar):
        sizes = [node.value for node in _nodes(velocity.size) if isinstance(node, Number)]
        for name in letters(velocity.angle):
            if name in old and len(sizes) == 1 and (sizes[0] / old[name]).denominator == 1:
                return new.get(name, 1)
    return 1


def _step(step: Step, dice: Dice) -> Step:
    if isinstance(step, Impact) and step.e is not None and not letters(step.e):
        return replace(step, e=_fraction(dice.of(COEFFICIENTS)))
    if isinstance(step, Given):
        relations = tuple(_relation(relation, dice) for relation in step.relations)
        return replace(step, relations=relations)
    return step


def _relation(relation: Relation, dice: Dice) -> Relation:
    """A fact about letters alone: a tangent, a coefficient."""
    if not isinstance(relation, Compare) or relation.operators != ("=",):
        return relation
    left, right = relation.operands
    if has_quantity(left) or has_quantity(right) or letters(right):
        return relation
    match left:
        case Apply("tan" | "sin" | "cos" as function, Letter()):
            across, along, whole = dice.of(TRIPLES[:4])
            ratios = {"tan": (across, along), "sin": (across, whole), "cos": (along, whole)}
            return replace(relation, operands=(left, _fraction(Fraction(*ratios[function]))))
        case Letter(name) if name.startswith("e"):
            return replace(relation, operands=(left, _fraction(dice.of(COEFFICIENTS))))
    return relation


def _velocity(tree: Any, dice: Dice, unit: int) -> Any:
    """A velocity with other components, or another size and angle; letters stay.

    A size is a multiple of ``unit``.
    """
    match tree:
        case Polar(size, angle):
            return replace(
                tree,
                size=_scaled(
                    size,
                    lambda old: _component(old, dice) if unit == 1 else _multiple(old, unit, dice),
                ),
                angle=_angle(angle, dice),
            )
        case Pair(x, y):
            return Pair(_sized(x, dice), _sized(y, dice))
        case Unit():
            return tree
        case Binary("+" | "-", left, right):
            return replace(tree, left=_velocity(left, dice, 1), right=_velocity(right, dice, 1))
    return _sized(tree, dice) if isinstance(tree, Expression) else tree


def _sized(tree: Any, dice: Dice) -> Any:
    return _scaled(tree, lambda old: _component(old, dice))


def _scaled(tree: Any, draw: Callable[[Fraction], Fraction]) -> Any:
    """A product with its plain number drawn again; a tree of another form stays."""
    match tree:
        case Number(value):
            return replace(tree, value=draw(value)) if value else tree
        case Binary("/", Number(a), Number(b)) if b:
            return _fraction(draw(a / b))
        case Binary("*", left, right):
            if not _numbers(left):
                return replace(tree, right=_scaled(right, draw))
            factor = _scaled(left, draw)
            one = isinstance(factor, Number) and factor.value == 1
            return right if one else replace(tree, left=factor)  # m, and not 1m
        case Binary("/", left, right) if not _numbers(right):
            return replace(tree, left=_scaled(left, draw))
        case Negate(operand):
            return replace(tree, operand=_scaled(operand, draw))
    return tree


def _numbers(tree: Expression) -> bool:
    return any(isinstance(node, Number) for node in walk(tree))


def _angle(tree: Expression, dice: Dice) -> Expression:
    if isinstance(tree, Degrees) and tree.value in _ANGLES:
        return replace(tree, value=Fraction(dice.of(_ANGLES)))
    return tree


def _mass(old: Fraction, dice: Dice) -> Fraction:
    """A mass of the same kind: whole, or in tenths."""
    whole = Fraction(dice.between(1, 6))
    if old.denominator == 1:
        return whole
    return whole / 10 if old.denominator in (5, 10) else whole / old.denominator


def _component(old: Fraction, dice: Dice) -> Fraction:
    """A component or a speed of about the same size."""
    most = max(8, min(int(old) + 4, 30))
    whole = Fraction(dice.between(1, most))
    return whole if old.denominator == 1 else whole / old.denominator


def _multiple(old: Fraction, unit: int, dice: Dice) -> Fraction:
    """A multiple of a hypotenuse, of about the size of a speed."""
    return Fraction(unit * dice.between(1, max(2, int(old) // unit)))


def _fraction(value: Fraction) -> Expression:
    """A fraction as a tree, as people write it."""
    if value.denominator == 1:
        return Number(value)
    return Binary("/", Number(Fraction(value.numerator)), Number(Fraction(value.denominator)))


# --- values that follow -------------------------------------------------------------------------


def _consistent(changed: Problem, problem: Problem, original: Solution, dice: Dice) -> Problem:
    """The problem with what follows from its data worked out again.

    Letters that facts fix are given new values, the facts are asked for instead, and the answers
    are put in their place.
    """
    followers = list(_followers(changed))
    if not followers:
        return _shown_again(changed)
    fixed = {
        name: value
        for part in original.parts.values()
        for branch in part.branches[:1]
        for name, value in branch.values.items()
    }
    values = _answers(_asked_forward(changed, fixed, problem, dice))
    return _shown_again(_put(changed, values))


def _followers(problem: Problem) -> Iterator[Expression]:
    """The quantities of which a fact gives a value in numbers."""
    for part in problem.parts:
        for step in part.steps:
            if isinstance(step, Given):
                for relation in step.relations:
                    if isinstance(relation, Compare) and _is_follower(relation):
                        yield relation.operands[0]


def _is_follower(relation: Compare) -> bool:
    return (
        relation.operators == ("=",)
        and has_quantity(relation.operands[0])
        and not isinstance(relation.operands[1], Degrees)
        and (_numbers(relation.operands[1]) or isinstance(relation.operands[1], Letter))
    )


def _asked_forward(
    problem: Problem, fixed: Mapping[str, Any], original: Problem, dice: Dice
) -> Problem:
    """The problem told forward: letters have values, and what facts gave is asked for."""
    new = tuple(
        Given((Compare((Letter(name), _new(name, original, dice)), ("=",)),))
        for name in fixed
        if not name.startswith("_")
    )
    spheres = tuple(
        replace(sphere, mass=Number(Fraction(dice.between(1, 6))))
        if f"_m_{sphere.name}" in fixed
        else sphere
        for sphere in problem.spheres
    )
    parts = []
    for part in problem.parts:
        steps: list[Step] = []
        for step in part.steps:
            if isinstance(step, Given):
                asked = [
                    relation
                    for relation in step.relations
                    if isinstance(relation, Compare) and _is_follower(relation)
                ]
                kept = tuple(relation for relation in step.relations if relation not in asked)
                if kept:
                    steps.append(replace(step, relations=kept))
                for comparison in asked:
                    steps.append(Find((Value(_subject(comparison)),)))
            elif not isinstance(step, Find | Show):
                steps.append(step)
        parts.append(replace(part, steps=tuple(steps)))
    first = replace(parts[0], steps=(*new, *parts[0].steps))
    return replace(problem, spheres=spheres, parts=(first, *parts[1:]))


def _subject(relation: Compare) -> Expression:
    """What is worked out again: of ``Q = 36% energy(0)`` the share."""
    left, right = relation.operands
    if has_quantity(right) and is_binary(right, "*"):
        return Binary("/", left, right.right)
    return left


def _new(name: str, problem: Problem, dice: Dice) -> Expression:
    """A new value for a letter that the facts fixed, of its kind."""
    from restitution.oracle.roles import ACUTE, COEFFICIENT
    from restitution.solving.story.letters import roles

    role = roles(problem).get(name)
    if role == COEFFICIENT or name.startswith("e"):
        return _fraction(dice.of(COEFFICIENTS))
    if role == ACUTE:
        across, along, _ = dice.of(TRIPLES[:4])
        return Apply("arctan", _fraction(Fraction(across, along)))
    return Number(Fraction(dice.between(2, 6)))


def _answers(problem: Problem) -> list[Expression]:
    """The exact answers to what is asked, as trees, in their order."""
    from restitution.expression import read_expression
    from restitution.solving import solve

    solution = solve(problem)
    _require_answers(solution)
    answers: list[Expression] = []
    for item in _items(solution):
        if len(item.distinct) != 1:
            raise UnsupportedError(f"{item.text} has several values")
        exact = item.distinct[0].exact
        texts = exact if isinstance(exact, tuple) else (exact,)
        trees = [read_expression(text) for text in texts]
        answers.append(trees[0] if len(trees) == 1 else _vector(*trees))
    return answers


def _vector(x: Expression, y: Expression) -> Expression:
    """A vector by its components, with i and j where these are numbers."""
    from restitution.expression import read_expression
    from restitution.expression.writing import write_expression
    from restitution.practice.questions.nice import vector

    try:
        first, second = (Fraction(write_expression(tree)) for tree in (x, y))
        return read_expression(vector(first, second))
    except ValueError:
        return Pair(x, y)


def _put(problem: Problem, values: list[Expression]) -> Problem:
    """Facts with the values that follow, in their order."""
    left_over = iter(values)

    def put(relation: Relation) -> Relation:
        if not (isinstance(relation, Compare) and _is_follower(relation)):
            return relation
        left, right = relation.operands
        value = next(left_over)
        if _subject(relation) != left:
            assert isinstance(right, Binary)
            value = Binary("*", value, right.right)
        return replace(relation, operands=(left, value))

    def step_with(step: Step) -> Step:
        if isinstance(step, Given):
            return replace(step, relations=tuple(map(put, step.relations)))
        return step

    return _with_steps(problem, step_with)


def _shown_again(problem: Problem) -> Problem:
    """Printed results worked out again: of ``show speed(P) = 5`` the 5."""
    if not any(_printed(step) for part in problem.parts for step in part.steps):
        return problem

    def ask(step: Step) -> Step | None:
        relation = _printed(step)
        if relation is not None and isinstance(step, Show):
            return Find((Value(relation.operands[0]),), step.in_terms_of)
        return None if isinstance(step, Find | Show) else step

    left_over = iter(_answers(_with_steps(problem, ask)))

    def put(step: Step) -> Step:
        relation = _printed(step)
        if relation is None or not isinstance(step, Show):
            return step
        value = next(left_over)
        if relation.figures is not None:
            value = _rounded(value, relation.operands[1], relation.figures)
        return replace(step, relation=replace(relation, operands=(relation.operands[0], value)))

    return _with_steps(problem, put)


def _printed(step: Step) -> Compare | None:
    """The relation of a ``show`` that prints a value with numbers in it, of a quantity."""
    if not isinstance(step, Show) or step.subject is not None:
        return None
    relation = step.relation
    if not isinstance(relation, Compare) or relation.operators != ("=",):
        return None
    left, right = relation.operands
    printed = has_quantity(left) and not has_quantity(right) and _numbers(right)
    return relation if printed else None


def _rounded(value: Expression, printed: Expression, figures: int) -> Expression:
    """A printed decimal, times its letters, for another value."""
    import sympy as sp

    from restitution.expression.evaluate import evaluate

    exact = evaluate(value, lambda _: sp.Integer(1))
    decimal = Fraction(f"{float(exact):.{figures}g}")
    rounded: Expression = _scaled(printed, lambda _: decimal)
    return rounded


def _with_steps(problem: Problem, change: Callable[[Step], Step | None]) -> Problem:
    """The problem with each step changed, and without those that become None."""
    parts = (
        replace(part, steps=tuple(new for step in part.steps if (new := change(step)) is not None))
        for part in problem.parts
    )
    return replace(problem, parts=tuple(parts))


# --- what is not varied -------------------------------------------------------------------------


def _notes(problem: Problem) -> Iterator[str]:
    if _tells_a_number(problem.title):
        yield "the title is left out, as it has a number"
    walls = sum(wall.along is not None or bool(wall.lengths) for wall in problem.walls)
    if len(problem.walls) > 1 and walls:
        yield "the walls stay where they are, as the path leads from one to the next"
    elif walls:
        yield "the wall stays as it is, as velocities are told by it"
    lines = sum(isinstance(step, Impact) and step.along is not None for _, step in problem.steps())
    if lines:
        yield (
            "the line of centres stays, as velocities are told by it"
            if lines == 1
            else "the lines of centres stay, as velocities are told by them"
        )
    if any(sphere.position is not None for sphere in problem.spheres) or problem.points:
        yield "places and distances stay, as the events depend on them"
    if any(isinstance(step, Impact) and step.offset is not None for _, step in problem.steps()):
        yield "the offset stays, as it makes the line of centres"
    for angle in _angles(problem):
        yield f"the angle of {angle}° stays, as it is not 30°, 45° or 60°"


def _angles(problem: Problem) -> Iterator[str]:
    seen = set()
    for sphere in problem.spheres:
        for node in _nodes(sphere.velocity):
            if isinstance(node, Degrees) and node.value not in (*_ANGLES, 0, 90, 180):
                seen.add(node.value)
    yield from (f"{float(value):g}" for value in sorted(seen))


def _nodes(tree: Any) -> Iterator[Any]:
    if isinstance(tree, Expression):
        yield from walk(tree)
