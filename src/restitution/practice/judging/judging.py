"""A script judged: a verdict on each line, and the names of the mistakes that begin there.

The lines are judged under the best meaning of the letters. One that is false there, and true or
following under a meaning that explains the script nearly as well, is a question about a letter and
not a mistake.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property
from itertools import chain, islice

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    children,
    has_quantity,
    letters,
    walk,
)
from restitution.practice.judgement import JudgedLine, Judgement, Meaning, Mistake
from restitution.practice.judging.bounds import bounds_of
from restitution.practice.judging.entries import Meanings
from restitution.practice.judging.extremes import worlds_at_extremes
from restitution.practice.judging.judged_link import Question
from restitution.practice.judging.misreading import (
    left_for_lost,
    misread_problems,
    reread_once,
)
from restitution.practice.judging.naming import Names
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.judging.slips import misreadings, read_as_datum
from restitution.practice.judging.support import Wanted, wanted_of
from restitution.practice.judging.verdicts import Judge
from restitution.practice.letters.candidates import is_odd
from restitution.practice.letters.interpretation import Interpretation, Interpretations
from restitution.practice.letters.letters import meanings_of
from restitution.practice.reading.phrases import is_phrase
from restitution.practice.script import Link, Script, ScriptLine
from restitution.practice.worlds.agreement import agrees, numbers_of
from restitution.practice.worlds.sampling import true_worlds
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Extremum, Find, Given, Problem, Range, Show, trees
from restitution.solving.equations.solution import PartSolution, Solution

_RIVALS = 8
_MISREADINGS = 8
_ANGLES = frozenset({"angle", "direction", "deflection"})
_SURE = 3
"""What an angle is taken for is certain with so many true lines that it stands in."""
_PLACES = 3
"""A datum stands in so many places, at most, that are tried."""


def judge(
    question: Problem | Solution,
    script: Script,
    part: str | None = None,
    letters: Mapping[str, Expression | Sequence[Expression]] | None = None,
) -> Judgement:
    """The verdicts on the lines of a script that belong to a part.

    ``letters`` are meanings that the student has declared or agreed to. Raises KeyError for a part
    that is not there, and the error of a question that has no answer.
    """
    bench = bench_of(question, part)
    own = script.of(part)
    if not bench.worlds:
        return Judgement(tuple(JudgedLine(each, "remark") for each in own.lines), ())
    judgement = _judged(bench, own, part, letters)
    literal = own.literal
    if literal is None or not any(line.verdict == "false" for line in judgement.lines):
        return judgement
    # An a that is given a value of its own, and not that of the α of the question, is no α.
    unknown = bench.question.unknown - bench.question.given
    defining = set(_defined_otherwise(judgement.lines, literal, unknown))
    if not defining:
        return judgement
    other = _judged(bench, literal, part, letters)
    true = {line.line.number for line in other.lines if line.verdict == "true"}
    return other if defining <= true else judgement


def _judged(
    bench: Bench,
    script: Script,
    part: str | None,
    letters: Mapping[str, Expression | Sequence[Expression]] | None,
) -> Judgement:
    meanings = meanings_of(
        script, bench.problem, bench.solution, part, dict(letters or {}), bench.worlds
    )
    with np.errstate(all="ignore"):
        return _Sitting(bench, script, meanings).judgement()


def _defined_otherwise(
    lines: Sequence[JudgedLine], literal: Script, unknown: frozenset[str]
) -> Iterator[int]:
    """The false lines that first use a letter for a known angle, and only give it a value."""
    seen: set[str] = set()
    for line, plain in zip(lines, literal.lines, strict=True):
        fresh = _names_in(plain) - _names_in(line.line) - seen
        seen |= fresh
        stands_for = _names_in(line.line) - _names_in(plain)
        if line.verdict != "false" or not fresh or stands_for & unknown:
            continue
        if line.mistake is not None and line.mistake.id == "sine-cosine":
            continue  # sin a is what cos α is
        if any(len(own) == 1 and own <= fresh for own in map(_names_of, plain.links)):
            yield line.line.number


@dataclass(frozen=True, eq=False)
class Bench:
    """A part of a question with everything that judging needs from it, worked out once."""

    solution: Solution
    solved: PartSolution

    @property
    def problem(self) -> Problem:
        """The question."""
        return self.solution.problem

    @cached_property
    def worlds(self) -> tuple[World, ...]:
        """The true worlds, one for each admissible solution."""
        return true_worlds(self.solution, self.solved)

    @cached_property
    def names(self) -> Names:
        """The names of the mistakes."""
        return Names(self.problem)

    @cached_property
    def question(self) -> Question:
        """What the part prints and asks, and which letters are unknown in it."""
        unknown = {
            name
            for branch in self.solved.branches
            for name in (*branch.values, *branch.angles)
            if any(name in world.letters for world in self.worlds)
        }
        bounds = bounds_of(self.problem, self.solved.part, self.solved)
        asked = (
            step.items if isinstance(step, Find) else (step.subject,)
            for step in self.solved.part.steps
            if isinstance(step, Find | Show)
        )
        extreme = any(isinstance(each, Extremum | Range) for items in asked for each in items)
        reached = worlds_at_extremes(self.solution, self.solved, self.worlds) if extreme else ()
        return Question(self.wanted, frozenset(unknown), self.given, bounds, extreme, reached)

    @cached_property
    def wanted(self) -> Wanted:
        """What the part prints and asks for."""
        return wanted_of(self.problem, self.solved.part)

    @cached_property
    def given(self) -> frozenset[str]:
        """The letters that a fact about letters alone gives a value."""
        names: set[str] = set()
        for step, _, _ in self.problem.timeline(self.solved.part):
            if isinstance(step, Given):
                for relation in step.relations:
                    if isinstance(relation, Compare) and "=" in relation.operators:
                        sides = relation.operands
                        inside = frozenset().union(*map(letters, sides))
                        if len(inside) == 1 and not any(map(has_quantity, sides)):
                            names |= inside
        return frozenset(names)

    @cached_property
    def data(self) -> tuple[Fraction, ...]:
        """The numbers of the statement, and its fractions."""
        own = dict.fromkeys(_numbers(trees(self.problem)))
        return (*own, *sorted(set(numbers_of(self.problem)) - own.keys()))


_BENCHES: dict[tuple[int, str | None], Bench] = {}
_KEPT = 8


def bench_of(question: Problem | Solution, part: str | None) -> Bench:
    """The bench for a part; a few are kept, by the question as an object."""
    key = id(question), part
    known = _BENCHES.get(key)
    if known is not None and question in (known.solution, known.problem):
        return known
    if isinstance(question, Problem):
        from restitution.solving.solver import solve

        solution = solve(question)
    else:
        solution = question
    if part not in solution.parts:
        raise KeyError(part)
    bench = Bench(solution, solution.parts[part])
    while len(_BENCHES) >= _KEPT:
        del _BENCHES[next(iter(_BENCHES))]
    _BENCHES[key] = bench
    return bench


def _numbers(expressions: Iterable[Expression]) -> Iterator[Fraction]:
    return (
        node.value
        for tree in expressions
        for node in walk(tree)
        if isinstance(node, Number | Degrees)
    )


@dataclass(frozen=True)
class _Idle:
    """Whether a meaning explains too little: more lines are false, or all that are in doubt."""

    open: Collection[int]
    most: int

    def __call__(self, lines: Sequence[JudgedLine]) -> bool:
        false = {line.line.number for line in lines if line.verdict == "false"}
        return len(false) > self.most or false.issuperset(self.open)


class _Sitting:
    """One script before the bench."""

    def __init__(self, bench: Bench, script: Script, meanings: Interpretations) -> None:
        self.bench = bench
        self.script = script
        self.meanings = meanings

    def judgement(self) -> Judgement:
        judge_, lines = self._judged(self.script, self.meanings.best)
        judge_, lines = self._with_own_letters(judge_, lines)
        lines = self._with_crossed_out(lines)
        asks = set(judge_.unknown)
        if any(line.verdict == "false" for line in lines):
            lines = self._misread(lines)
            lines = self._asked(lines, asks)
            sure = _are_of_one_mistake(lines)
            lines = (
                lines if sure else tuple(self._unless_in_doubt(line, lines, asks) for line in lines)
            )
        return Judgement(lines, tuple(self._shown()), tuple(sorted(asks)))

    def _shown(self) -> Iterator[Meaning]:
        """The meanings of letters, and of the phrases that stand in the first reading of a line."""
        first = {
            name
            for line in self.script.lines
            for link in line.links
            for side in (link.readings[0].left, link.readings[0].right, *link.readings[0].others)
            for name in letters(side)
        }
        for each in self.meanings.best.meanings:
            if each.letter in first or not is_phrase(each.letter):
                yield each

    def _judge(
        self,
        interpretation: Interpretation,
        worlds: Sequence[World] | None = None,
        *,
        names: bool = True,
    ) -> Judge:
        table = {line.number: interpretation.trees(line.number) for line in self.script.lines}
        bench = self.bench
        return Judge(worlds or bench.worlds, table, bench.names, bench.question, names=names)

    def _judged(
        self, script: Script, interpretation: Interpretation, *, names: bool = True
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        judge_ = self._judge(interpretation, names=names)
        return judge_, judge_.judged(script)

    # --- letters below a mistake ------------------------------------------------------------------

    def _with_own_letters(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines with letters that only stand below a mistake: what they mean in his own world.

        Taken if more lines then hold or follow, and none is false that was not before.
        """
        best = self.meanings.best
        unknown = {name for name in judge_.unknown if not is_phrase(name)}
        unknown |= set(self._angles_below(lines))
        false = sum(line.verdict == "false" for line in lines)
        if not unknown or not false or best.fixed_letters or any(m.since for m in best.meanings):
            return judge_, lines
        known = {
            m.letter: m.quantity
            for m in best.meanings
            if not is_phrase(m.letter) and m.letter not in unknown
        }
        bench = self.bench
        for world in islice(judge_.students(), 1):
            own = meanings_of(
                self.script, bench.problem, bench.solution, bench.solved.part.label, known, (world,)
            ).best
            newly_known = tuple(each for each in own.meanings if each.letter in unknown)
            phrases = tuple(each for each in best.meanings if is_phrase(each.letter))
            merged = replace(
                best,
                meanings=(*(m for m in best.meanings if m.letter in known), *phrases, *newly_known),
                unknown=best.unknown - {each.letter for each in newly_known},
            )
            other, again = self._judged(self.script, merged)
            more = sum(line.verdict in ("true", "follows") for line in again)
            less = sum(line.verdict in ("true", "follows") for line in lines)
            if more > less and sum(line.verdict == "false" for line in again) <= false:
                self.meanings = replace(self.meanings, best=merged)
                return other, again
        return judge_, lines

    def _angles_below(self, lines: Sequence[JudgedLine]) -> Iterator[str]:
        """The letters taken for an angle by their look alone, that stand in no line which holds."""
        for each in self.meanings.best.meanings:
            own = [line.verdict for line in lines if each.letter in _names_in(line.line)]
            by_look = each.by == "default" and kind_of(each.quantity) in _ANGLES
            if by_look and not is_phrase(each.letter) and "false" in own and "true" not in own:
                yield each.letter

    # --- letters that are not certain -----------------------------------------------------------

    def _asked(self, lines: tuple[JudgedLine, ...], asks: set[str]) -> tuple[JudgedLine, ...]:
        """False lines that another meaning makes true are questions about a letter.

        A meaning under which more lines are false explains the script less well, and where one
        altered law explains several of them, so does one under which any is.
        """
        tries = iter(range(_RIVALS))
        most = 0 if _are_of_one_mistake(lines) else sum(line.verdict == "false" for line in lines)
        for rival in self.meanings.rivals:
            doubtful = {line.line.number: self._doubtful(rival, line) for line in lines}
            false = [each.line for each in lines if each.verdict == "false"]
            if not any(set(doubtful[line.number]) & _names_in(line) for line in false):
                continue
            if next(tries, None) is None:
                break
            open_ = {line.number for line in false if set(doubtful[line.number]) & _names_in(line)}
            judge_ = self._judge(rival, names=False)
            others = judge_.judged(self.script, _Idle(open_, most))
            if not others:
                continue
            lines = tuple(
                self._doubted(line, other, doubtful[line.line.number], asks)
                for line, other in zip(lines, others, strict=True)
            )
        return lines

    def _doubtful(self, rival: Interpretation, line: JudgedLine) -> tuple[str, ...]:
        """The letters that mean something else in a rival, and were not declared."""
        number = line.line.number
        force = self.meanings.best.at(number)
        return tuple(
            name
            for name in self.meanings.doubtful(rival, number)
            if force[name].by not in ("declared", "agreed")
        )

    def _doubted(
        self, line: JudgedLine, other: JudgedLine, doubtful: Sequence[str], asks: set[str]
    ) -> JudgedLine:
        inside = [name for name in doubtful if name in _names_in_doubt(line)]
        if line.verdict != "false" or not inside or other.verdict not in ("true", "follows"):
            return line
        asks.update(inside)
        return replace(line, verdict="asks", mistake=None, link=None)

    def _unless_in_doubt(
        self, line: JudgedLine, lines: Sequence[JudgedLine], asks: set[str]
    ) -> JudgedLine:
        """A false line is a question if no other line supports what a letter in it is taken for.

        A letter of an odd look for that needs two true lines, others one, or a mistake with a name.
        """
        mistake = line.mistake
        if line.verdict != "false":
            return line
        named = mistake is not None and mistake.kind == "misconception"
        true = [_names_in(each.line) for each in lines if each.verdict == "true"]
        true += [_names_of(link) for link in line.line.links[: line.link or 0]]
        # An angle that is worked out from components is known by them.
        worked = {
            name
            for each in lines
            if each.verdict == "true" and any(use.principle == "angle" for use in each.uses)
            for name in _names_in(each.line)
        }
        # Momentum of two letters tells both, however odd they look, if the line is a law in them.
        momenta = [
            _names_in(each.line)
            for each in lines
            if each.verdict == "true" and each.uses and each.uses[0].principle == "momentum"
        ]
        names = _names_in_doubt(line)
        told = named and any(names <= each for each in momenta)
        doubtful: set[str] = set()
        for name, meaning in self.meanings.best.at(line.line.number).items():
            if name in names and meaning.by == "inferred" and not is_phrase(name):
                support = sum(name in each for each in true) + _SURE * (name in worked or told)
                odd = is_odd(name, meaning.quantity)
                if support < (2 if odd else 0 if named else 1) or (
                    (not support or (support < _SURE and kind_of(meaning.quantity) in _ANGLES))
                    and self._is_true_of_another(line, name, lines)
                ):
                    doubtful.add(name)
        if not doubtful:
            return line
        asks.update(doubtful)
        return replace(line, verdict="asks", mistake=None, link=None)

    def _is_true_of_another(self, line: JudgedLine, name: str, lines: Sequence[JudgedLine]) -> bool:
        """Whether a line is true if a letter means another quantity than it is taken for.

        Beside a component of one sphere a component is one of the other sphere, and what is known
        from the start is only given a value. The other sense of what a letter is taken for has to
        make all false lines true in which it stands.
        """
        known = self.meanings.best.trees(line.line.number)
        own = {known[name], Negate(known[name]), getattr(known[name], "operand", known[name])}
        beside = set(self._beside(line, name))
        defining = _gives(line.line, name)
        candidates = self.bench.names.candidates(self.bench.worlds[0])
        false = [each for each in lines if each.verdict == "false" and name in _names_in(each.line)]
        for each in candidates:
            if beside and (each.kind != "component" or each.body in beside):
                continue
            if each.start and not defining:
                continue
            for meant in (each.quantity, Negate(each.quantity)):
                tried = false if meant in own else [line]
                if all(self._is_true_with_meaning(one, name, meant) for one in tried):
                    return True
        return False

    def _beside(self, line: JudgedLine, name: str) -> Iterator[str]:
        """The spheres of the components beside which a letter for a component stands in a line."""
        meanings = self.meanings.best.at(line.line.number)
        if _sphere_of(meanings[name].quantity) is None:
            return
        for other in _names_in_doubt(line) - {name}:
            sphere = _sphere_of(meanings[other].quantity) if other in meanings else None
            if sphere is not None:
                yield sphere

    def _is_true_with_meaning(self, line: JudgedLine, name: str, meant: Expression) -> bool:
        known = self.meanings.best.trees(line.line.number)
        links = (link for link in line.line.links if name in _names_of(link))
        return all(self._is_so_meant(link, line, {**known, name: meant}) for link in links)

    def _is_so_meant(self, link: Link, line: JudgedLine, meanings: Meanings) -> bool:
        """Whether a link is true where letters have given meanings, to three figures."""
        try:
            grade = agrees(
                link.readings[0], self.bench.worlds[0], meanings, link.decimals, line.line.scope
            )
        except RestitutionError:
            return False
        return grade in ("exact", "rounded")

    # --- lines crossed out ----------------------------------------------------------------------

    def _with_crossed_out(self, lines: tuple[JudgedLine, ...]) -> tuple[JudgedLine, ...]:
        """Lines crossed out are judged where nothing below has their left side."""
        kept = [
            line.number
            for place, line in enumerate(self.script.lines)
            if line.kind == "crossed"
            and line.links
            and not _is_replaced(line, self.script.lines[place + 1 :])
        ]
        if not kept:
            return lines
        script = Script(
            tuple(
                replace(line, kind="relations") if line.number in kept else line
                for line in self.script.lines
            )
        )
        _, again = self._judged(script, self.meanings.best)
        typed = [each.number for each in self.script.lines if each.kind == "relations"]
        return tuple(
            old if _is_withdrawn(old, new, typed) else replace(new, line=old.line)
            for old, new in zip(lines, again, strict=True)
        )

    # --- misread data ---------------------------------------------------------------------------

    def _misread(self, lines: tuple[JudgedLine, ...]) -> tuple[JudgedLine, ...]:
        """If another datum makes all lines true, the first false line is a misread."""
        first = next(line.line for line in lines if line.verdict == "false")
        typed = [value for line in self.script.lines for value in _factors_in(line)]
        pairs = misreadings(typed, self.bench.data)
        near = set(_factors_in(first))
        for value, datum in islice((each for each in pairs if each[0] in near), _MISREADINGS):
            script = Script(tuple(_reread(line, value, datum) for line in self.script.lines))
            if self._judge(self.meanings.best).is_true(script):
                return tuple(_as_misread(lines, str(value)))
        turned = (each for each in left_for_lost(self.bench.problem) if each[0] != each[1])
        instead = chain(turned, self._read_instead(lines))
        for value, datum in islice(instead, _MISREADINGS):
            if self._is_true_with(value, datum):
                return tuple(_as_misread(lines, str(value)))
        return lines

    def _read_instead(self, lines: Sequence[JudgedLine]) -> Iterator[tuple[Fraction, Fraction]]:
        """Numbers with the data that they may misread.

        They stand in one place of two false lines each, or in several of one, or are quoted.
        """
        untrue = [each.line for each in lines if each.verdict in ("false", "follows")]
        judge_ = self._judge(self.meanings.best, names=False)
        for value in dict.fromkeys(_numbers_in(untrue[0])):
            for datum in self.bench.data:
                if not datum or datum == value:
                    continue
                if _is_true_throughout(untrue[0], value, datum, judge_):
                    yield value, datum
                    continue
                twice = (line for line in untrue if _is_true_reread(line, value, datum, judge_))
                least = 1 if _is_quoted(untrue[0], value) else 2
                if len(list(islice(twice, least))) == least:
                    yield value, datum

    def _is_true_with(self, value: Fraction, datum: Fraction) -> bool:
        """Whether all lines are true where the question has a number in place of a datum."""
        from restitution.solving.solver import solve

        label = self.bench.solved.part.label
        for problem in islice(misread_problems(self.bench.problem, datum, value), _PLACES):
            try:
                solution = solve(problem)
                worlds = true_worlds(solution, solution.parts[label])
            except RestitutionError:
                continue
            if worlds and self._judge(self.meanings.best, worlds).is_true(self.script):
                return True
        return False


def _gives(line: ScriptLine, name: str) -> bool:
    """Whether a line gives a letter, its square, or its tangent and the like a value."""
    sides = (
        side for link in line.links for claim in link.readings for side in (claim.left, claim.right)
    )
    return any(
        side == Letter(name)
        or (isinstance(side, Binary) and side.op == "^" and side.left == Letter(name))
        or (isinstance(side, Apply) and side.argument == Letter(name))
        for side in sides
    )


def _sphere_of(tree: Expression) -> str | None:
    """The sphere whose component of velocity a quantity is; None of any other."""
    match tree:
        case Negate(operand):
            return _sphere_of(operand)
        case Quantity("along" | "across", (Quantity("velocity", (Name(body),)), _)):
            return body
    return None


def _are_of_one_mistake(lines: Sequence[JudgedLine]) -> bool:
    """Whether several lines are false, and all of them instances of one altered law."""
    false = [line.mistake for line in lines if line.verdict == "false"]
    variants = [set(each.variants) for each in false if each is not None]
    return len(variants) > 1 and bool(set.intersection(*variants))


def _numbers_in(line: ScriptLine) -> Iterator[Fraction]:
    """The numbers of a line but 0 and 1."""
    for link in line.links:
        claim = link.readings[0]
        yield from (x for x in _numbers((claim.left, claim.right)) if x not in (0, 1))


def _is_quoted(line: ScriptLine, value: Fraction) -> bool:
    """Whether a line quotes a number, or a fraction with it, as a datum: ``e = 1/2``."""

    def is_it(tree: Expression) -> bool:
        match tree:
            case Binary("/", Number(above), Number(below)):
                return value in (above, below)
        return tree == Number(value)

    return any(
        claim.sign == "=" and isinstance(claim.left, Letter) and is_it(claim.right)
        for link in line.links
        for claim in link.readings[:1]
    )


def _is_true_reread(line: ScriptLine, value: Fraction, datum: Fraction, judge_: Judge) -> bool:
    """Whether a line is true with a datum in place of one number that is ``value``."""
    links = tuple(
        replace(
            link,
            readings=tuple(
                new for claim in link.readings for new in reread_once(claim, value, datum)
            ),
        )
        for link in line.links
    )
    false = [k for k, link in enumerate(line.links) if not judge_.is_true(_alone(line, link))]
    return bool(false) and all(judge_.is_true(_alone(line, links[k])) for k in false)


def _is_true_throughout(line: ScriptLine, value: Fraction, datum: Fraction, judge_: Judge) -> bool:
    """Whether a line is true with a datum in place of a number that stands twice in it, or more."""
    claims = [link.readings[0] for link in line.links]
    places = [x for claim in claims for x in _numbers((claim.left, claim.right))]
    if places.count(value) < 2:
        return False
    return judge_.is_true(Script((_reread(line, value, datum),)))


def _alone(line: ScriptLine, link: Link) -> Script:
    return Script((replace(line, links=(link,)),))


def _factors_in(line: ScriptLine) -> Iterator[Fraction]:
    """The numbers of a line, each once, without exponents and without 1 and 2."""
    values: dict[Fraction, None] = {}
    for link in line.links:
        for side in (link.readings[0].left, link.readings[0].right):
            pending = [side]
            while pending:
                each = pending.pop()
                if isinstance(each, Number | Degrees):
                    values[each.value] = None
                elif isinstance(each, Binary) and each.op == "^":
                    pending.append(each.left)
                else:
                    pending.extend(children(each))
    return (value for value in values if value not in (1, 2))


def _as_misread(lines: Sequence[JudgedLine], at: str) -> Iterator[JudgedLine]:
    first: int | None = None
    for line in lines:
        if line.verdict != "false":
            yield line
        elif first is None:
            first = line.line.number
            named = line.mistake
            if named is not None and named.kind == "misconception":
                also = ("misread", *((named.id,) if named.id else named.also))
                yield replace(line, mistake=replace(named, id=None, also=also, sure=False))
            else:
                yield replace(line, mistake=Mistake("misread", "slip", at=at))
        else:
            yield replace(line, verdict="follows", sources=(first,), mistake=None, link=None)


def _reread(line: ScriptLine, typed: Fraction, datum: Fraction) -> ScriptLine:
    links = tuple(
        replace(link, readings=tuple(read_as_datum(claim, typed, datum) for claim in link.readings))
        for link in line.links
    )
    return replace(line, links=links)


def _is_withdrawn(old: JudgedLine, new: JudgedLine, typed: Sequence[int]) -> bool:
    """Whether a line was crossed out for being wrong, and the working went on."""
    crossed = old.line.kind == "crossed" and new.verdict == "false"
    return crossed and any(number > old.line.number for number in typed)


def _is_replaced(line: ScriptLine, below: Sequence[ScriptLine]) -> bool:
    """Whether a line below has the left side of one crossed out, or one of its letters."""
    own, names = {_left(link) for link in line.links}, _names_in(line)
    return any(
        _left(link) in own or not names.isdisjoint(_names_in(each))
        for each in below
        if each.kind == "relations"
        for link in each.links
    )


def _left(link: Link) -> Expression:
    return link.readings[0].left


def _names_in(line: ScriptLine) -> frozenset[str]:
    return frozenset[str]().union(*map(_names_of, line.links))


def _names_in_doubt(line: JudgedLine) -> frozenset[str]:
    """The letters on which it rests that a line is false.

    ``p = 3(3 - 7/4) = 9/2`` is false whatever p means: its numbers do not agree.
    """
    return _names_in(line.line) if line.link is None else _names_of(line.line.links[line.link])


def _names_of(link: Link) -> frozenset[str]:
    return frozenset[str]().union(
        *(
            letters(side)
            for claim in link.readings
            for side in (claim.left, claim.right, *claim.others)
        )
    )
