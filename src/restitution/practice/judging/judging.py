"""A script judged: a verdict on each line, and the names of the mistakes that begin there.

The lines are judged under the best meaning of the letters. One that is false there, and true or
following under a meaning that explains the script nearly as well, is a question about a letter and
not a mistake.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import nullcontext, suppress
from dataclasses import replace
from fractions import Fraction
from itertools import chain, islice

import numpy as np

from restitution.errors import RestitutionError
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Number,
    Quantity,
    children,
    has_quantity,
    is_binary,
    letters,
    negated,
    unsigned,
    walk,
)
from restitution.practice.judgement import JudgedLine, Judgement, Meaning, Mistake
from restitution.practice.judging.asked_letters import AskedLetters
from restitution.practice.judging.bench import Bench, bench_of, numbers
from restitution.practice.judging.doubts import (
    are_of_one_mistake,
    is_named,
    names_in,
    names_of,
)
from restitution.practice.judging.entries import has_time_or_place
from restitution.practice.judging.misreading import (
    left_for_lost,
    misread_problems,
    reread_once,
)
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.judging.scaling import sizes_taken
from restitution.practice.judging.slips import misreadings, read_as_datum
from restitution.practice.judging.typed_energies import of_energies_along, of_whole_energies
from restitution.practice.judging.verdicts import Judge
from restitution.practice.letters.interpretation import Interpretation, Interpretations
from restitution.practice.letters.letters import meanings_of
from restitution.practice.letters.surroundings import all_fixed, letters_of
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.script import Link, Script, ScriptLine
from restitution.practice.worlds.effort import ExhaustedError, effort
from restitution.practice.worlds.sampling import true_worlds
from restitution.problem import Problem
from restitution.solving.equations.solution import Solution

NOT_JUDGED = "This was not judged: there is too much above it. Hand in fewer lines at a time."
_EFFORT = 200_000
"""So many evaluations are spent on the lines of a script, at most."""
_EFFORT_OF_MISREADINGS = 40_000
_SHORTER = 3
"""Of a script that takes more, this fraction is judged."""
_MISREADINGS = 8
_ALIKE = 0.05
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
    fixed = all_fixed(own, letters_of(bench.problem, bench.solved.part))
    bench = bench.taking({**sizes_taken(own, bench), **fixed})
    if not bench.worlds:
        return Judgement(tuple(JudgedLine(line, "remark") for line in own.lines), ())
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
    with np.errstate(all="ignore"):
        return _judged_first(bench, script, len(script.lines), part, letters)


def _judged_first(
    bench: Bench,
    script: Script,
    most: int,
    part: str | None,
    letters: Mapping[str, Expression | Sequence[Expression]] | None,
) -> Judgement:
    """The first lines of a script judged, as many of ``most`` as the effort suffices for."""
    own = Script(script.lines[:most])
    later = [JudgedLine(line, "unread", remark=NOT_JUDGED) for line in script.lines[most:]]
    try:
        with effort(_EFFORT) if most else nullcontext():
            meanings = meanings_of(
                own, bench.problem, bench.solution, part, dict(letters or {}), bench.worlds
            )
            sitting = _Sitting(bench, own, meanings)
            judge_, lines = sitting.first_lines()
    except ExhaustedError:
        return _judged_first(bench, script, most // _SHORTER, part, letters)
    judgement = sitting.judgement(judge_, lines)
    return replace(judgement, lines=(*judgement.lines, *later))


def _defined_otherwise(
    lines: Sequence[JudgedLine], literal: Script, unknown: frozenset[str]
) -> Iterator[int]:
    """The false lines that first use a letter for a known angle, and only give it a value."""
    seen: set[str] = set()
    for line, plain in zip(lines, literal.lines, strict=True):
        fresh = names_in(plain) - names_in(line.line) - seen
        seen |= fresh
        stands_for = names_in(line.line) - names_in(plain)
        if line.verdict != "false" or not fresh or stands_for & unknown:
            continue
        if line.mistake is not None and line.mistake.id == "sine-cosine":
            continue  # sin a is what cos α is
        if any(len(own) == 1 and own <= fresh for own in map(names_of, plain.links)):
            yield line.line.number


class _Sitting(AskedLetters):
    """One script before the bench."""

    def first_lines(self) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines under the likeliest meanings of the letters."""
        judge_, lines = self._judged(self.script, self.meanings.best)
        judge_, lines = self._with_asked_angle(judge_, lines)
        judge_, lines = self._with_angle_in_words(judge_, lines)
        judge_, lines = self._with_asked_letters(judge_, lines)
        return self._with_letters_kept(*self._with_fewest_false(judge_, lines))

    def judgement(self, judge_: Judge, lines: tuple[JudgedLine, ...]) -> Judgement:
        """The lines with all that is looked into once they stand."""
        with suppress(ExhaustedError), effort(_EFFORT):
            judge_, lines = self._with_whole_energies(judge_, lines)
        with suppress(ExhaustedError), effort(_EFFORT):
            judge_, lines = self._with_own_letters(judge_, lines)
        with suppress(ExhaustedError), effort(_EFFORT):
            lines = self._with_crossed_out(lines)
        asks = set(judge_.unknown)
        lines = self.with_idle_definitions(lines, asks)
        if any(line.verdict == "false" for line in lines):
            with suppress(ExhaustedError), effort(_EFFORT_OF_MISREADINGS):
                lines = self._misread(lines)
            lines = self.asked(lines, asks)
            sure = are_of_one_mistake(lines)
            lines = (
                lines if sure else tuple(self.unless_in_doubt(line, lines, asks) for line in lines)
            )
        return Judgement(lines, tuple(self._shown()), tuple(sorted(asks)))

    def _with_whole_energies(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines with energies of one kind, before and after: whole ones, or along a line."""
        script = of_whole_energies(lines)
        along = None if script else of_energies_along(lines, judge_.base.problem)
        if along is not None:
            best = self.meanings.best
            best = replace(best, meanings=(*best.meanings, *along[1]))
            other, new = self._judged(along[0], best)
            if not any(line.verdict == "false" for line in new):
                self.script, self.meanings = along[0], replace(self.meanings, best=best)
                return other, new
        if script is None:
            return judge_, lines
        self.script = script
        return self._judged(script, self.meanings.best)

    def _shown(self) -> Iterator[Meaning]:
        """The meanings of letters, and of the phrases that stand in the first reading of a line."""
        first = {
            name
            for line in self.script.lines
            for link in line.links
            for side in (link.readings[0].left, link.readings[0].right, *link.readings[0].others)
            for name in letters(side)
        }
        for meaning in self.meanings.best.meanings:
            if meaning.letter in first or not is_phrase(meaning.letter):
                yield meaning

    def _with_fewest_false(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines where two letters may be those of the other bodies, if less is false so.

        One mistake from which all else follows is likelier than several. Of one each way b is of B.
        """
        false = sum(line.verdict == "false" for line in lines)
        odd = _is_named_otherwise(self.meanings.best)
        for other in _exchanged(self.meanings.best) if false else ():
            with suppress(ExhaustedError):
                judge_too, again = self._judged(self.script, other)
                less = sum(line.verdict == "false" for line in again)
                if 0 < less < false or (odd and less == false):
                    self.meanings = replace(self.meanings, best=other)
                    return judge_too, again
        return judge_, lines

    # --- letters that keep their meanings -------------------------------------------------------

    def _with_letters_kept(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines where letters keep their meanings, if that gives the first mistake a name.

        Behind the second wall the angle at the first one is a misconception, and no new angle.
        """
        best = self.meanings.best
        first = next((line for line in lines if line.verdict == "false"), None)
        kept = replace(best, meanings=tuple(_kept(best.meanings)))
        if first is None or is_named(first) or kept == best:
            return judge_, lines
        other, again = self._judged(self.script, kept)
        false = sum(line.verdict == "false" for line in lines)
        begins = next((line for line in again if line.verdict == "false"), None)
        if begins is None or not is_named(begins) or begins.line.number > first.line.number:
            return judge_, lines
        if sum(line.verdict == "false" for line in again) > false:
            return judge_, lines
        self.meanings = replace(self.meanings, best=kept)
        return other, again

    # --- letters below a mistake ------------------------------------------------------------------

    def _with_own_letters(
        self, judge_: Judge, lines: tuple[JudgedLine, ...]
    ) -> tuple[Judge, tuple[JudgedLine, ...]]:
        """The lines with letters that only stand below a mistake: what they mean in his own world.

        Taken if more lines then hold or follow, and none is false that was not before.
        """
        best = self.meanings.best
        false = sum(line.verdict == "false" for line in lines)
        below = set(self._below(lines)) if false else set()
        unknown = {name for name in judge_.unknown if not is_phrase(name)}
        unknown |= {*self._doubtful_below(lines), *below}
        if not unknown or not false or best.fixed_letters or any(m.since for m in best.meanings):
            return judge_, lines
        known = {
            m.letter: m.quantity
            for m in best.meanings
            if not is_phrase(m.letter) and m.letter not in unknown
        }
        bench = self.bench
        worlds = (judge_.students(), judge_.students_without(unknown))
        for world in chain.from_iterable(islice(own, 1) for own in worlds):
            every = meanings_of(
                self.script, bench.problem, bench.solution, bench.solved.part.label, known, (world,)
            )
            own = self._with_asked(every, below)
            newly_known = tuple(meaning for meaning in own.meanings if meaning.letter in unknown)
            phrases = tuple(meaning for meaning in best.meanings if is_phrase(meaning.letter))
            merged = replace(
                best,
                meanings=(*(m for m in best.meanings if m.letter in known), *phrases, *newly_known),
                unknown=best.unknown - {meaning.letter for meaning in newly_known},
            )
            other, again = self._judged(self.script, merged)
            more = sum(line.verdict in ("true", "follows") for line in again)
            less = sum(line.verdict in ("true", "follows") for line in lines)
            tells = any(self._is_asked(meaning.quantity) for meaning in newly_known)
            more += more == less and tells and bool(below)  # what is asked decides between equals
            if more > less and sum(line.verdict == "false" for line in again) <= false:
                self.meanings = replace(self.meanings, best=merged)
                return other, again
        return judge_, lines

    def _with_asked(self, every: Interpretations, names: Collection[str]) -> Interpretation:
        """The likeliest meanings; of those as likely that in which a letter is what is asked."""
        alike = (x for x in (every.best, *every.rivals) if x.score >= every.best.score - _ALIKE)
        return next(
            (
                reading
                for reading in alike
                if any(m.letter in names and self._is_asked(m.quantity) for m in reading.meanings)
            ),
            every.best,
        )

    def _below(self, lines: Sequence[JudgedLine]) -> Iterator[str]:
        """The letters that stand below a mistake alone, and mean nothing that is asked.

        Times and places there are those of his own world, whatever true value a number may have.
        """
        if not any(map(has_time_or_place, (tree for tree, _ in self.bench.wanted.asked))):
            return
        first = next(line.line.number for line in lines if line.verdict == "false")
        above = {
            name for line in lines if line.line.number <= first for name in names_in(line.line)
        }
        for meaning in self.meanings.best.meanings:
            timed = meaning.letter[:1] in "tT" and meaning.by == "declared"
            open_ = meaning.by == "inferred" or (timed and not has_quantity(meaning.quantity))
            if not open_ or is_phrase(meaning.letter) or meaning.letter in above:
                continue
            if not self._is_asked(meaning.quantity):
                yield meaning.letter

    def _is_asked(self, quantity: Expression) -> bool:
        """Whether a quantity is a time or a place that the part asks for."""
        asked = (tree for tree, _ in self.bench.wanted.asked)
        return has_time_or_place(quantity) and quantity in asked

    def _doubtful_below(self, lines: Sequence[JudgedLine]) -> Iterator[str]:
        """The letters of which nobody said what they are, that stand in no line which holds.

        None of the line in which the mistake begins.
        """
        false = (names_in(line.line) for line in lines if line.verdict == "false")
        first = next(false, frozenset())
        for meaning in self.meanings.best.meanings:
            own = [line.verdict for line in lines if meaning.letter in names_in(line.line)]
            by_look = meaning.by == "default" and kind_of(meaning.quantity) in ANGLES
            by_look = by_look and meaning.quantity not in self._asked_angles()
            by_look = by_look or (meaning.by == "inferred" and meaning.letter not in first)
            if by_look and not is_phrase(meaning.letter) and "false" in own and "true" not in own:
                yield meaning.letter

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
        typed = [line.number for line in self.script.lines if line.kind == "relations"]
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
        near = set(_factors_in(first)) - set(_of_two_data(self.script.lines))
        for value, datum in islice((pair for pair in pairs if pair[0] in near), _MISREADINGS):
            script = Script(tuple(_reread(line, value, datum) for line in self.script.lines))
            if self._judge(self.meanings.best).is_true(script):
                return tuple(_as_misread(lines, str(value)))
        turned = (pair for pair in left_for_lost(self.bench.problem) if pair[0] != pair[1])
        instead = chain(turned, self._read_instead(lines))
        for value, datum in islice(instead, _MISREADINGS):
            if self._is_true_with(value, datum):
                return tuple(_as_misread(lines, str(value)))
        return lines

    def _read_instead(self, lines: Sequence[JudgedLine]) -> Iterator[tuple[Fraction, Fraction]]:
        """Numbers with the data that they may misread.

        They stand in one place of two false lines each, or in several of one, or are quoted.
        """
        untrue = [line.line for line in lines if line.verdict in ("false", "follows")]
        judge_ = self._judge(self.meanings.best, names=False)
        for value in dict.fromkeys(_numbers_in(untrue[0])):
            for datum in self.bench.data:
                if not datum or datum == value:
                    continue
                if _is_true_throughout(untrue[0], value, datum, judge_):
                    yield value, datum
                    continue
                twice = (line for line in untrue if _is_true_reread(line, value, datum, judge_))
                quoted = _is_quoted(untrue[0], value, self.bench.question.unknown)
                least = 1 if quoted else 2
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


def _of_one_line(best: Interpretation) -> tuple[Meaning, ...]:
    """The two letters that are components of two bodies along one line, where nobody told so."""
    own = tuple(
        meaning
        for meaning in best.meanings
        if meaning.by == "inferred" and not is_phrase(meaning.letter)
    )
    axes = {_parts_of(meaning.quantity)[1:] for meaning in own}
    bodies = {_parts_of(meaning.quantity)[0] for meaning in own}
    return own if len(own) == len(bodies) == 2 and len(axes) == 1 and None not in bodies else ()


def _parts_of(tree: Expression) -> tuple[str | None, Expression | None, object]:
    """The body, the axis and the moment of a component along a line; None of anything else."""
    match unsigned(tree):
        case Quantity("along", (Quantity("velocity", (Name(body),), stage), axis)):
            return body, axis, stage
    return None, None, None


def _is_named_otherwise(best: Interpretation) -> bool:
    """Whether such a letter has the name of another body: the b of A and B for A."""
    pair = _of_one_line(best)
    bodies = {meaning.letter: _parts_of(meaning.quantity)[0] for meaning in pair}
    named = {letter for letter in bodies if letter.upper() in bodies.values() and letter.islower()}
    return any(bodies[letter] != letter.upper() for letter in named)


def _exchanged(best: Interpretation) -> Iterator[Interpretation]:
    """The meanings with two such letters for the other bodies, in either sense."""
    pair = _of_one_line(best)
    if not pair:
        return
    one, other = pair
    for turned in (False, True):
        put = {
            a.letter: negated(b.quantity) if turned else b.quantity
            for a, b in ((one, other), (other, one))
        }
        yield replace(
            best,
            meanings=tuple(
                replace(meaning, quantity=put.get(meaning.letter, meaning.quantity))
                for meaning in best.meanings
            ),
        )


def _kept(meanings: Sequence[Meaning]) -> Iterator[Meaning]:
    """The first meaning of each letter, and those that are the student's own word."""
    first: dict[str, Expression] = {}
    for meaning in sorted(meanings, key=lambda meaning: meaning.since):
        known = first.setdefault(meaning.letter, meaning.quantity)
        if known == meaning.quantity or meaning.by != "inferred":
            yield meaning


def _numbers_in(line: ScriptLine) -> Iterator[Fraction]:
    """The numbers of a line but 0 and 1."""
    for link in line.links:
        claim = link.readings[0]
        yield from (x for x in numbers((claim.left, claim.right)) if x not in (0, 1))


def _is_quoted(line: ScriptLine, value: Fraction, unknown: Collection[str]) -> bool:
    """Whether a line quotes a number, or a fraction with it, as a datum: ``e = 1/2``.

    What is ``unknown`` is worked out, and no datum.
    """

    def is_it(tree: Expression) -> bool:
        match tree:
            case Binary("/", Number(above), Number(below)):
                return value in (above, below)
        return tree == Number(value)

    return any(
        claim.sign == "="
        and isinstance(claim.left, Letter)
        and claim.left.name not in unknown
        and is_it(claim.right)
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
    places = [x for claim in claims for x in numbers((claim.left, claim.right))]
    if places.count(value) < 2:
        return False
    return judge_.is_true(Script((_reread(line, value, datum),)))


def _alone(line: ScriptLine, link: Link) -> Script:
    return Script((replace(line, links=(link,)),))


def _of_two_data(lines: Sequence[ScriptLine]) -> Iterator[Fraction]:
    """Numbers that stand alone, and in a fraction of two numbers as well: they are of two data."""
    sides = [
        side
        for line in lines
        for link in line.links
        for side in (link.readings[0].left, link.readings[0].right)
    ]
    fractions = [
        tree
        for side in sides
        for tree in walk(side)
        if is_binary(tree, "/") and isinstance(tree.left, Number) and isinstance(tree.right, Number)
    ]
    inside = Counter(numbers(fractions))
    everywhere = Counter(numbers(sides))
    return (value for value, count in inside.items() if count < everywhere[value])


def _factors_in(line: ScriptLine) -> Iterator[Fraction]:
    """The numbers of a line, each once, without exponents and without 1 and 2."""
    values: dict[Fraction, None] = {}
    for link in line.links:
        for side in (link.readings[0].left, link.readings[0].right):
            pending = [side]
            while pending:
                node = pending.pop()
                if isinstance(node, Number | Degrees):
                    values[node.value] = None
                elif is_binary(node, "^"):
                    pending.append(node.left)
                else:
                    pending.extend(children(node))
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
    own, names = {_left(link) for link in line.links}, names_in(line)
    return any(
        _left(link) in own or not names.isdisjoint(names_in(line))
        for line in below
        if line.kind == "relations"
        for link in line.links
    )


def _left(link: Link) -> Expression:
    return link.readings[0].left
