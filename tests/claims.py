"""The claims of ``tests/claims``: how a file is read, and what follows from each of its lines.

The head of ``tests/claims/walls.claims`` says how the lines are written.
"""

from __future__ import annotations

import random
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import mpmath as mp
import plain_physics as physics
import sympy as sp

from restitution import problem as p
from restitution.errors import RestitutionError
from restitution.expression import tree as t
from restitution.language import parse
from restitution.solving import solve

FOLDER = Path(__file__).parent / "claims"
SCALES = ("10^-12", "10^-3", "1", "10^3", "10^12")
# What a verdict may rest on.
PROOFS = {
    True: {"algebra", "decision", "intervals"},
    False: {"algebra", "decision", "intervals", "witness"},
    None: {"undecided"},
}
BELOW, ABOVE = "(1 - 10^-9)", "(1 + 10^-9)"


@dataclass(frozen=True)
class Shown:
    """One ``show``, with its truth. ``base`` is where the claim that it comes from stands."""

    group: str
    base: str
    story: str
    claim: str
    holds: bool


@dataclass(frozen=True)
class Asked:
    """One ``find``, the lines before it included, with what its answer is."""

    group: str
    base: str
    story: str
    lines: tuple[str, ...]
    outcome: str


Concrete = Shown | Asked


@dataclass(frozen=True)
class Base:
    """One line of a file below its story."""

    group: str
    place: str
    story: str
    line: str
    reason: str


def bases() -> Iterator[Base]:
    for path in sorted(FOLDER.glob("*.claims")):
        yield from _bases(path)


def _bases(path: Path) -> Iterator[Base]:
    group, story, telling = "", [], False
    for n, raw in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        line, _, comment = raw.partition("#")
        line, reason = line.strip(), comment.strip()
        if raw.startswith("=="):
            group = f"{path.stem}: {raw.strip('= ')}"
        elif line == "story":
            story, telling = [], True
        elif line == "claims":
            telling = False
        elif line and telling:
            story.append(line)
        elif line:
            assert reason, f"{path.name}:{n}: a claim without a reason"
            yield Base(group, f"{path.name}:{n}", "\n".join(story), line, reason)


def concrete() -> list[Concrete]:
    """All that follows from the files, in their order."""
    return [each for base in bases() for each in expanded(base)]


def expanded(base: Base) -> Iterator[Concrete]:
    """A line at every scale and threshold."""
    line, choices = base.line, {"": [""]}
    while found := re.match(r"for (\w) in ([^:]*):\s*(.*)", line):
        choices[found[1]] = [each.strip() for each in found[2].split(",")]
        line = found[3]
    if "{s}" in base.story or ("{s}" in line and "s" not in choices):
        choices["s"] = list(SCALES)
    for put in _products(choices):
        story, words = _put(base.story, put), _put(line, put)
        kind, _, rest = words.partition(" ")
        if kind == "ask":
            lines, outcome = rest.split("->")
            yield Asked(
                base.group,
                base.place,
                story,
                tuple(each.strip() for each in lines.split(";")),
                outcome.strip(),
            )
        else:
            for claim, holds in _claims(kind, rest):
                yield Shown(base.group, base.place, story, claim, holds)


def _products(choices: Mapping[str, list[str]]) -> Iterator[dict[str, str]]:
    if not choices:
        yield {}
        return
    (name, values), *others = choices.items()
    for value in values:
        for put in _products(dict(others)):
            yield {name: value, **put}


def _put(text: str, put: Mapping[str, str]) -> str:
    for name, value in put.items():
        if name:
            text = text.replace("{" + name + "}", f"({value})")
    return text


def _claims(kind: str, rest: str) -> Iterator[tuple[str, bool]]:
    match kind:
        case "true":
            yield rest, True
        case "false":
            yield rest, False
        case "same":
            left, right = rest.split(" = ")
            yield f"{left} = {right}", True
            for factor in (BELOW, ABOVE, "(1 + 10^-30)", *SCALES):
                if factor != "1":
                    yield f"{left} = {factor}*({right})", False
        case "bounds":
            yield from _thresholds(rest)
        case _:
            raise AssertionError(f"what is {kind!r}?")


def _thresholds(text: str) -> Iterator[tuple[str, bool]]:
    """Each end of a set of values moved a little, and thresholds far from both."""
    text, _, unit = text.rpartition(" in ")
    words = re.split(r" (<=|<) ", f" {text}")
    words = [each.strip() for each in words]
    low = high = None
    if len(words) == 5:
        low, first, quantity, last, high = words
    elif _is_number(words[0]):
        low, first, quantity = words
    else:
        quantity, last, high = words
    scale = _size(low, high)
    if low is not None:
        end = physics.value_of(low)
        for threshold in _near(low, scale):
            value = physics.value_of(threshold)
            yield f"{quantity} > {threshold}*{unit}", value < end or (value == end and first == "<")
            yield f"{quantity} >= {threshold}*{unit}", value <= end
    if high is not None:
        end = physics.value_of(high)
        for threshold in _near(high, scale):
            value = physics.value_of(threshold)
            yield f"{quantity} < {threshold}*{unit}", value > end or (value == end and last == "<")
            yield f"{quantity} <= {threshold}*{unit}", value >= end
    top = mp.inf if high is None else physics.value_of(high)
    bottom = -mp.inf if low is None else physics.value_of(low)
    for factor in SCALES:
        threshold = f"{factor}*({scale})"
        value = physics.value_of(threshold)
        above = value < bottom or (value == bottom and first == "<" and low is not None)
        below = value > top or (value == top and high is not None and last == "<")
        yield f"{quantity} < {threshold}*{unit}", bool(below)
        yield f"{quantity} > {threshold}*{unit}", bool(above)
        yield f"{quantity} = {threshold}*{unit}", False


def _is_number(text: str) -> bool:
    try:
        return not isinstance(physics.value_of(text), tuple)
    except (KeyError, RestitutionError):
        return False


def _size(low: str | None, high: str | None) -> str:
    """The natural size of a quantity: the end of its values that is farther from 0."""
    ends = [each for each in (low, high) if each is not None and physics.value_of(each) != 0]
    return max(ends, key=lambda each: abs(physics.value_of(each)), default="1")


def _near(end: str, scale: str) -> tuple[str, ...]:
    if physics.value_of(end) == 0:
        return "0", f"10^-9*({scale})", f"(-10^-9)*({scale})"
    return f"({end})", f"{BELOW}*({end})", f"{ABOVE}*({end})"


# --- numbers for letters -------------------------------------------------------------------------

GREEK = set(t.GREEK)


def letters_of(problem: p.Problem) -> set[str]:
    names = {name for tree in p.trees(problem) for name in t.letters(tree)}
    names -= {step.letter for _, step in problem.steps() if isinstance(step, p.Let)}
    if any(isinstance(step, p.Impact) and step.e is None for _, step in problem.steps()):
        names.add("e")
    return names


def kind_of(name: str, problem: p.Problem | None = None) -> str:
    """What a letter may be, as `tests/claims/README.md` says."""
    if problem is not None and any(
        isinstance(each.velocity, t.Pair) and t.Letter(name) in (each.velocity.x, each.velocity.y)
        for each in problem.spheres
    ):
        return "real"
    if name == "e" or name.startswith("e_"):
        return "coefficient"
    if name in GREEK:
        return "angle"
    return "real" if name in "pqxy" else "positive"


def allowed(name: str, value: Any, problem: p.Problem) -> bool:
    """Whether a number is one that a letter may be, before the facts about it are asked."""
    match kind_of(name, problem):
        case "coefficient":
            return bool(-physics.NONE <= value <= 1 + physics.NONE)
        case "angle":
            return bool(0 < value < (mp.pi if _obtuse(name, problem) else mp.pi / 2))
        case "positive":
            return bool(value > 0)
    return True


@cache
def _obtuse(name: str, problem: p.Problem) -> bool:
    """Whether a fact speaks of an angle alone: then that fact says what it may be."""
    return any(
        isinstance(relation, p.Compare)
        and set(relation.operators) != {"="}
        and any(isinstance(each, t.Letter) and each.name == name for each in relation.operands)
        for _, step in problem.steps()
        if isinstance(step, p.Given)
        for relation in step.relations
    )


def drawn(names: set[str], problem: p.Problem, rng: random.Random) -> dict[str, Any]:
    """Numbers over many orders of magnitude and near every end."""
    values: dict[str, Any] = {}
    tame = rng.random() < 0.5
    for name in sorted(names):
        kind = kind_of(name, problem)
        near = mp.mpf(10) ** -rng.choice((1, 3, 6, 9, 12))
        any_ = physics.number(Fraction(rng.randint(1, 999), 1000))
        if kind == "coefficient":
            values[name] = rng.choice((mp.mpf(0), mp.mpf(1), any_, any_, any_, near, 1 - near))
        elif kind == "angle":
            share = rng.choice((any_, any_, any_, near, 1 - near))
            half = 1 + _obtuse(name, problem) * rng.choice((0, 1))
            values[name] = (share + half - 1) * mp.pi / 2
        else:
            power = 0 if tame else rng.choice((-12, -6, -3, 0, 0, 0, 3, 6, 12))
            sign = rng.choice((1, -1)) if kind == "real" else 1
            values[name] = sign * 4 * any_ * mp.mpf(10) ** power
    return values


def completed(values: dict[str, Any], free: set[str], problem: p.Problem) -> dict[str, Any]:
    """Numbers, with one of the free letters of each equation between letters put right.

    Only equations that are linear in a free letter are (k v = u, e k = 1).
    """
    values = dict(values)
    for _, step in problem.steps():
        for relation in step.relations if isinstance(step, p.Given) else ():
            if not isinstance(relation, p.Compare) or relation.operators != ("=",):
                continue
            if any(t.has_quantity(tree) for tree in relation.operands):
                continue
            names = {name for tree in relation.operands for name in t.letters(tree)}
            for name in sorted(names & free):

                def gap(x: Any, name: str = name, relation: p.Compare = relation) -> Any:
                    world = physics.World(physics.EMPTY, {**values, name: x})
                    left, right = (world.scalar(each, 0) for each in relation.operands)
                    return left - right

                at_0, at_1, at_2 = (gap(mp.mpf(n)) for n in (0, 1, 2))
                if at_1 != at_0 and abs(at_2 - 2 * at_1 + at_0) <= physics.NONE:
                    values[name] = at_0 / (at_0 - at_1)
                    break
    return values


def refutes(statement: str, n: int, counterexample: Mapping[str, str]) -> str | None:
    """None if a counterexample refutes the n-th claim of a statement; else what is wrong.

    Letters that it leaves out do not matter: whatever they are, the claim must fail.
    """
    problem = parse(statement)
    try:
        chosen = {name: number_of(text, {}) for name, text in counterexample.items()}
    except Exception as error:  # noqa: BLE001 whatever it is, a reader could not use it
        return f"the counterexample cannot be read: {error}"
    for name, value in chosen.items():
        if not allowed(name, value, problem):
            return f"{name} may not be {mp.nstr(value, 15)}"
    left = letters_of(problem) - set(chosen)
    rng = random.Random(8)
    possible, why = 0, "no numbers make the story possible"
    for _ in range(60 if left else 1):
        try:
            values = {**chosen, **drawn(left, problem, rng)}
            values = completed(values, left, problem)
            if not all(allowed(*each, problem) for each in values.items()):
                continue
            world = physics.World(problem, values)
            if not world.possible():
                why = "the facts do not hold"
                continue
            show, now = world.claims[n]
            if world.holds(show.relation, now):
                return "the claim holds there"
        except physics.ImpossibleWorldError as error:
            why = str(error)
            continue
        possible += 1
        if possible == 5:
            break
    return None if possible else f"the story cannot happen there: {why}"


# --- what is asked, against its outcome --------------------------------------------------------


def refused(error: Any) -> bool:
    """Whether an error says that nothing satisfies all that was said."""
    return error is not None and error.kind in ("impossible", "contradiction")


def undecided(error: Any) -> bool:
    return error is not None and error.kind in ("unsupported", "time limit")


def disagreement(asked: Asked, item: Any, outcome: str, seed: int = 1) -> str | None:
    """None if the answer to an item is the outcome; else what is wrong, beginning with
    ``undecided`` where nothing wrong is claimed but nothing is answered either.
    """
    if outcome in ("impossible", "clash"):
        if undecided(item.error):
            return f"undecided: {item.error}"
        shown = [each.display for each in item.answers]
        return None if refused(item.error) else f"answered {shown or item.error!r}"
    if outcome == "missing":
        kind = None if item.error is None else item.error.kind
        return None if kind == "missing" else f"answered {kind or item.display}"
    if item.error is not None:
        word = "undecided" if undecided(item.error) else "refused"
        return f"{word}: {item.error.kind}: {item.error.message}"
    problem = parse("\n".join((asked.story, *asked.lines)))
    if item.kind == "range":
        return _range_disagreement(problem, item, outcome, seed)
    for letters in _points(problem, outcome, seed):
        wanted = _outcomes(outcome, letters)
        try:
            given = answered(item, letters)
        except Exception as error:  # noqa: BLE001 an answer must have a value wherever it holds
            return f"no value at {_shown(letters)}: {error!r}"
        if item.kind == "extremum":
            reached = outcome.split()[-1] == "reached"
            if any(each.reached is not reached for each in item.answers):
                return f"reached should be {reached}"
        if not same_sets(wanted, given):
            return f"{numbers(given)} instead of {numbers(wanted)} at {_shown(letters)}"
    return None


def _holds(condition: str, letters: Mapping[str, Any]) -> bool:
    """Whether one of the cases of a condition holds; where a root is not real, it does not."""
    try:
        return any(physics.true_of(each, letters) for each in condition.split(" or "))
    except physics.ImpossibleWorldError:
        return False


def answered(item: Any, letters: Mapping[str, Any]) -> list[Any]:
    """The values of those answers whose conditions hold."""
    values = []
    for answer in item.answers:
        if all(_holds(each, letters) for each in answer.condition):
            texts = (answer.exact,) if isinstance(answer.exact, str) else answer.exact
            try:
                values.append(tuple(number_of(text, letters) for text in texts))
            except physics.ImpossibleWorldError:
                values.append((mp.nan,))  # no real number: it is like no value that is wanted
    return values


def number_of(text: str, letters: Mapping[str, Any]) -> Any:
    """The number that an exact text is; SymPy's names of functions are understood too."""
    for sympy_name, name in (("atan", "arctan"), ("asin", "arcsin"), ("acos", "arccos")):
        text = re.sub(rf"\b{sympy_name}\(", f"{name}(", text)
    return physics.value_of(text.replace("**", "^"), letters)


def _alternatives(outcome: str) -> list[str]:
    """The values of an outcome, each with its condition."""
    return re.sub(r" (reached|approached)$", "", outcome).split(" or ")


def _outcomes(outcome: str, letters: Mapping[str, Any]) -> list[Any]:
    values = []
    for each in _alternatives(outcome):
        value, _, condition = each.partition(" when ")
        if not condition or physics.true_of(condition, letters):
            values.append((physics.value_of(value, letters),))
    return values


def same_sets(a: list[Any], b: list[Any]) -> bool:
    return all(any(_near_to(x, y) for y in b) for x in a) and all(
        any(_near_to(x, y) for y in a) for x in b
    )


def _near_to(a: Any, b: Any) -> bool:
    return len(a) == len(b) and all(
        abs(x - y) <= mp.mpf(10) ** -40 * (abs(x) + abs(y)) + mp.mpf(10) ** -60
        for x, y in zip(a, b)
    )


def numbers(values: list[Any]) -> str:
    return str([tuple(mp.nstr(x, 15) for x in each) for each in values])


def _shown(letters: Mapping[str, Any]) -> str:
    return ", ".join(f"{name} = {mp.nstr(value, 20)}" for name, value in letters.items())


def _between(condition: str, rng: random.Random) -> dict[str, Any]:
    """A number for the letter of ``20 <= u <= 40/sqrt(3)``: chance alone hardly finds one."""
    chain = re.fullmatch(r"(\S+) <=? (\w+) <=? (\S+)", condition)
    if chain is None or re.search(r"[a-z]", re.sub(r"sqrt|pi", "", chain[1] + chain[3])):
        return {}
    low, high = physics.value_of(chain[1]), physics.value_of(chain[3])
    return {chain[2]: low + (high - low) * mp.mpf(rng.uniform(0.01, 0.99))}


def _points(problem: p.Problem, outcome: str, seed: int) -> list[dict[str, Any]]:
    """Numbers for the letters that are data: at large, and on both sides of each border of the
    condition, a billionth away.
    """
    conditions = [each.partition(" when ")[2] for each in _alternatives(outcome)]
    names = letters_of(problem) - _sought(problem)
    if not names:
        return [{}]
    rng = random.Random(seed)
    points = [drawn(names, problem, rng) for _ in range(60)]
    points = [each for each in points if _may_be(problem, each)]
    if not any(conditions):
        return [each for each in points if _can_happen(problem, outcome, each)][:20]
    (condition, *_) = conditions
    inside = [each for each in points if physics.true_of(condition, each)]
    for _ in range(4000):
        if len(inside) >= 8:
            break
        point = drawn(names, problem, rng) | _between(condition, rng)
        if physics.true_of(condition, point):
            inside.append(point)
    outside = [each for each in points if not physics.true_of(condition, each)]
    assert inside, f"no numbers are inside the condition {condition!r}"
    chosen = inside[:8] + outside[:8]
    for a, b in zip(inside * 3, outside):
        chosen += _borders(condition, a, b)
    return chosen


def _borders(condition: str, a: dict[str, Any], b: dict[str, Any]) -> list[dict[str, Any]]:
    """Two points a billionth of the way on either side of a border between a and b."""

    logs = {n: (mp.log(a[n]), mp.log(b[n])) for n in a if a[n] > 0 and b[n] > 0}

    def between(share: Any) -> dict[str, Any]:
        return {
            name: mp.exp((1 - share) * logs[name][0] + share * logs[name][1])
            if name in logs
            else (1 - share) * a[name] + share * b[name]
            for name in a
        }

    low, high = mp.mpf(0), mp.mpf(1)
    for _ in range(50):  # a millionth of the step below
        middle = (low + high) / 2
        if physics.true_of(condition, between(middle)):
            low = middle
        else:
            high = middle
    step = mp.mpf(10) ** -9
    return [between(share) for share in (low - step, low + step) if 0 < share < 1]


def _sought(problem: p.Problem) -> set[str]:
    """The letters that are asked for, or unknown."""
    names: set[str] = set()
    for _, step in problem.steps():
        if isinstance(step, p.Unknown):
            names |= set(step.letters)
        elif isinstance(step, p.Find):
            for item in step.items:
                tree = item.over if isinstance(item, p.Extremum) else item.expression
                if isinstance(tree, t.Letter):
                    names.add(tree.name)
    return names


def _may_be(problem: p.Problem, letters: Mapping[str, Any]) -> bool:
    """Whether numbers satisfy the inequalities that are given between letters alone."""
    world = physics.World(physics.EMPTY, letters)
    return all(
        world.holds(relation, 0)
        for _, step in problem.steps()
        if isinstance(step, p.Given)
        for relation in step.relations
        if isinstance(relation, p.Compare)
        and "=" not in relation.operators
        and not any(
            t.has_quantity(tree) or t.letters(tree) - set(letters) for tree in relation.operands
        )
    )


def _can_happen(problem: p.Problem, outcome: str, letters: Mapping[str, Any]) -> bool:
    """Whether a story can happen with these numbers, as far as that can be told without more."""
    try:
        return physics.World(problem, letters).possible()
    except physics.ImpossibleWorldError:
        return False
    except (KeyError, NotImplementedError):
        return True


def _range_disagreement(problem: p.Problem, item: Any, outcome: str, seed: int) -> str | None:
    words = [each.strip() for each in re.split(r" (<=|<|>=|>) ", f" {outcome}")]
    if len(words) == 5:
        low, first, _, last, high = words
    elif words[1].startswith("<"):
        (_, last, high), low, first = words, "0", "<"
    else:
        (_, first, low), high, last = words, None, "<"
    names = letters_of(problem) - _sought(problem)
    rng = random.Random(seed)
    value = sp.Union(*(each.value for each in item.answers))
    if not isinstance(value, sp.Interval):
        return f"answered {item.display}"
    if (bool(value.left_open), bool(value.right_open)) != ("=" not in first, "=" not in last):
        return f"an end belongs to the range, or does not: answered {item.display}"
    for _ in range(3):
        letters = drawn(names, problem, rng)
        wanted = [physics.value_of(low, letters), mp.inf]
        if high is not None:
            wanted[1] = physics.value_of(high, letters)
        ends = [_evaluated(each, letters) for each in (value.start, value.end)]
        for a, b in zip(wanted, ends):
            if a != b and not _near_to((a,), (b,)):
                return f"answered {item.display}"
    return None


def _evaluated(value: Any, letters: Mapping[str, Any]) -> Any:
    if value in (sp.oo, -sp.oo):
        return mp.inf if value == sp.oo else -mp.inf
    put = {each: sp.Float(mp.nstr(letters[each.name], 90), 90) for each in value.free_symbols}
    return mp.mpf(str(sp.N(value.xreplace(put), 80)))


def possible_worlds(
    story: str, chosen: list[Shown], rng: random.Random, wanted: int
) -> list[physics.World]:
    """A story with its claims, told with numbers for which it can happen."""
    problem = parse("\n".join((story, *(f"show {each.claim}" for each in chosen))))
    names = letters_of(problem)
    worlds: list[physics.World] = []
    for _ in range(80 * wanted if names else 1):
        if len(worlds) == wanted:
            break
        try:
            values = completed(drawn(names, problem, rng), names, problem)
            if not all(allowed(*each, problem) for each in values.items()):
                continue
            world = physics.World(problem, values)
            if world.possible():
                worlds.append(world)
        except physics.ImpossibleWorldError:
            continue
    return worlds


# --- verdicts ------------------------------------------------------------------------------------


def judged(chosen: Sequence[Concrete]) -> tuple[list[str], list[str]]:
    """What is wrong, and what is undecided, among the verdicts on some

    All ``show`` of one story are put into one statement.
    """
    wrong: list[str] = []
    open_: list[str] = []
    shown = defaultdict(list)
    for each in chosen:
        if isinstance(each, Shown):
            shown[each.story].append(each)
        else:
            _judge_asked(each, wrong, open_)
    for story, of_story in shown.items():
        _judge_shown(story, of_story, wrong, open_)
    return wrong, open_


def _judge_shown(story: str, chosen: list[Shown], wrong: list[str], open_: list[str]) -> None:
    statement = "\n".join((story, *(f"show {each.claim}" for each in chosen)))
    try:
        items = [item for _, item in solve(parse(statement)).items()]
    except RestitutionError as error:
        wrong += [f"{each.base}: show {each.claim}: {error!r}" for each in chosen]
        return
    for n, (each, item) in enumerate(zip(chosen, items, strict=True)):
        name = f"{each.base}: show {each.claim} is {str(each.holds).lower()}"
        if item.error is not None:
            where = open_ if undecided(item.error) else wrong
            where.append(f"{name}: {item.error!r}")
        elif item.holds is None:
            open_.append(name)
        elif item.holds is not each.holds:
            wrong.append(f"{name}; answered {item.holds}, {item.counterexample}")
        elif item.proof not in PROOFS[item.holds]:
            wrong.append(f"{name}; proof is {item.proof!r}")
        elif item.holds is False:
            doubt = (
                "no counterexample"
                if item.counterexample is None
                else refutes(statement, n, item.counterexample)
            )
            if doubt is not None:
                wrong.append(f"{name}; refuted by {item.counterexample}: {doubt}")


def _judge_asked(each: Asked, wrong: list[str], open_: list[str]) -> None:
    statement = "\n".join((each.story, *each.lines))
    name = f"{each.base}: {'; '.join(each.lines)} -> {each.outcome}"
    outcomes = each.outcome.split(" & ")
    try:
        items = [item for _, item in solve(parse(statement)).items()][-len(outcomes) :]
    except RestitutionError as error:
        if not (each.outcome in ("impossible", "clash") and refused(error)):
            (open_ if undecided(error) else wrong).append(f"{name}: {error!r}")
        return
    for outcome, item in zip(outcomes, items, strict=True):
        doubt = disagreement(each, item, outcome)
        if doubt is not None:
            (open_ if doubt.startswith("undecided") else wrong).append(f"{name}: {doubt}")
