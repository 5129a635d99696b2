"""The lines of a script judged one after another, under one meaning of its letters.

A line is true if one reading of it holds in one admissible solution. After a first false line it is
judged in the student's own world as well. The truth of a line never depends on the lines above.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from fractions import Fraction
from itertools import chain
from typing import Protocol

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.misconceptions import VariantAt
from restitution.explaining.trees import exchanged
from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    Apply,
    Binary,
    Degrees,
    Expression,
    Letter,
    Name,
    Negate,
    Pair,
    Quantity,
    letters,
)
from restitution.practice.judgement import Accuracy, JudgedLine, Mistake, Use, Verdict
from restitution.practice.judging.angles import unnamed_in, with_angles
from restitution.practice.judging.bounds import Bounds, bounded_by, conditions_of
from restitution.practice.judging.deduction import deduced_from
from restitution.practice.judging.entries import (
    Entry,
    Meanings,
    is_numeric,
    is_root_of,
    sources_of,
)
from restitution.practice.judging.naming import Explained, Stated
from restitution.practice.judging.other_forms import (
    are_alike,
    energies_between,
    is_oblique,
    is_signed,
    is_to_a_line,
    kind_of,
    label_in,
    lines_of,
    of_components,
    of_natures,
    of_sizes,
    of_vectors,
    same_left,
    shares_of_energy,
    times_sizes,
)
from restitution.practice.judging.own_numbers import OwnNumbers
from restitution.practice.judging.support import Support, Wanted
from restitution.practice.judging.supposing import (
    changes_of_sizes,
    speaks_of_an_extreme,
    supposed_in,
)
from restitution.practice.letters.candidates import Candidate, suffix
from restitution.practice.letters.options import Usage, options, staged
from restitution.practice.letters.trial import inside_angles
from restitution.practice.reading.lines import read_as
from restitution.practice.reading.phrases import (
    is_phrase,
    is_relative,
    is_vague,
    names_axis,
    read_phrase,
)
from restitution.practice.script import Claim, Link, Script, ScriptLine
from restitution.practice.worlds.agreement import agrees, difference
from restitution.practice.worlds.arrays import UnvaluedError
from restitution.practice.worlds.principles import uses_of
from restitution.practice.worlds.student import altered_world, facts_of, student_world
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_WORST: tuple[Verdict, ...] = ("false", "unread", "asks", "unsupported", "follows", "true")
_GRADES: tuple[Accuracy, ...] = ("coarse", "rounded", "exact")
# How far a student's own rounding to three figures may move his values.
_OWN_ROUNDING = 0.006
# A cosine below this, turned, is that of an obtuse angle whatever the rounding.
_OBTUSE = 1e-6
_USUAL = 0.3
"""A letter takes a meaning of at most this cost from lines below a mistake."""
_ALTERED = 3
_PHRASED = 6
_NAMED = 10
"""So many mistakes are looked into; of more the first tell enough."""
COARSE = "coarse"
OTHER_ROOT = "other-root"
IMPOSSIBLE_ANGLE = "A sine or a cosine is at most 1, so this cannot be."
IMPOSSIBLE_COEFFICIENT = "A coefficient of restitution lies between 0 and 1, so this cannot be."
# What a result is, as the principle of a line.
_PRINCIPLES = {
    "impulse": "impulse",
    "energy_lost": "energy",
    "energy": "energy",
    "speed": "speed",
    "deflection": "deflection",
}
_COEFFICIENT = re.compile(r"e(_\w+)?'*")


class Naming(Protocol):
    """The interface of what names mistakes."""

    worlds: dict[tuple[str, int, int], World | None]

    def explained(self, entry: Entry, judge: Judge) -> Explained:
        """What explains a claim that is false."""

    def candidates(self, world: World) -> Sequence[Candidate]:
        """The quantities that a letter may mean."""

    def named(self, explained: Explained, stated: Stated, confirmed: frozenset[str]) -> Mistake:
        """The mistake by its name."""


@dataclass(frozen=True)
class Question:
    """What a part prints and asks, the letters that it has to find, and those that it gives.

    ``bounds`` are what it says of sizes; ``extreme`` tells that it asks for a greatest or least
    value.
    """

    wanted: Wanted
    unknown: frozenset[str] = frozenset()
    given: frozenset[str] = frozenset()
    bounds: Bounds = field(default_factory=Bounds)
    extreme: bool = False


@dataclass(frozen=True)
class JudgedLink:
    """A link with its verdict: the reading that decided, and what is said of it.

    ``right`` is a claim that follows, as it would be without the wrong numbers above it.
    """

    verdict: Verdict
    claim: Claim
    accuracy: Accuracy | None = None
    sources: tuple[int, ...] = ()
    remark: str | None = None
    letters: frozenset[str] = frozenset()
    right: Claim | None = None
    meant: tuple[tuple[str, Expression], ...] = ()
    grounded: bool = True


class Judge:
    """Judges a script under one meaning of its letters.

    ``worlds`` are those of the admissible solutions, ``meanings`` those of the letters in each
    line, by its number.
    """

    def __init__(
        self,
        worlds: Sequence[World],
        meanings: Mapping[int, Meanings],
        naming: Naming,
        question: Question,
        *,
        names: bool = True,
    ) -> None:
        self._names = names
        self._explained: dict[int, Explained] = {}
        self._confirmed: dict[int, set[str]] = {}
        self.worlds = tuple(worlds)
        self.naming = naming
        self.question = question
        self.entries: list[Entry] = []
        self.unknown: set[str] = set()
        self._meanings = meanings
        self._own: tuple[int, tuple[World, ...]] = (-1, ())
        self._base = self.worlds[0]
        self._stated: set[tuple[str, int | None]] = set()
        self._meant: dict[str, Expression] = {}
        self._phrases: dict[tuple[str, int | None], tuple[Expression, ...]] = {}
        self._own_numbers = OwnNumbers()
        self._event_above: int | None = None
        self._groundless: set[int] = set()
        self._roots: list[Entry] = []
        self._rooted: tuple[tuple[int, int], list[World]] = ((-1, -1), [])
        self._known_uses: dict[tuple[Claim, int, bool], tuple[Use, ...]] = {}

    # --- a script -----------------------------------------------------------------------------

    def judged(self, script: Script) -> tuple[JudgedLine, ...]:
        """Every line with its verdict."""
        self._base = self._likeliest(script)
        self._take_acute(script)
        question = self.question
        self._support = Support(self._base, question.wanted, question.unknown, question.given)
        lines: list[JudgedLine] = []
        for line in script.lines:
            lines.append(self._judged(line))
            self._event_above = line.scope.event
        return tuple(self._named(line) for line in lines)

    def _named(self, line: JudgedLine) -> JudgedLine:
        """A false line with the name of its mistake, in the light of all lines."""
        if line.verdict != "false":
            return line
        explained = self._explained.get(line.line.number)
        if explained is None:
            return replace(line, mistake=Mistake(None))
        confirmed = frozenset(self._confirmed.get(line.line.number, ()))
        mistake = self.naming.named(explained, self.stated(), confirmed)
        idle = all(use.principle == "arithmetic" for use in line.uses)
        uses = (explained.near or line.uses) if idle else line.uses
        if mistake.variants and not any(use.altered in mistake.variants for use in uses):
            uses = tuple(dict.fromkeys((*_uses_of_variants(explained.variants, mistake), *uses)))
        mended = explained.mended if mistake.kind == "slip" else None
        return replace(line, mistake=mistake, uses=uses, mended=mended)

    def is_true(self, script: Script) -> bool:
        """Whether every relation of a script holds in one of the solutions."""
        return all(
            self._holds(link, line, self.worlds) is not None
            for line in script.lines
            if line.kind not in ("remark", "heading", "crossed", "unread")
            for link in line.links
        )

    def meanings(self, number: int) -> Meanings:
        """What letters and phrases mean in a line."""
        known = self._meanings.get(number, {})
        return {**self._meant, **known} if self._meant else known

    @property
    def base(self) -> World:
        """The solution in which most lines are true."""
        return self._base

    @property
    def wrong(self) -> bool:
        """Whether a line so far is false."""
        return bool(self._own_numbers) or any(entry.wrong for entry in self.entries)

    def _likeliest(self, script: Script) -> World:
        if len(self.worlds) == 1:
            return self.worlds[0]
        links = [(line, link) for line in script.lines for link in line.links]
        return max(
            self.worlds,
            key=lambda world: sum(
                self._holds(link, line, (world,)) is not None for line, link in links
            ),
        )

    def _take_acute(self, script: Script) -> None:
        """Take another angle for a letter that means one to a line, if more is true so.

        A line has two directions, and students measure from either, and in either sense.
        """
        for name in {name for known in self._meanings.values() for name in known}:
            tree = next(known[name] for known in self._meanings.values() if name in known)
            if not is_to_a_line(tree):
                continue
            most, own = self._count(script, name), self._meanings
            best = own
            for other in self._other_angles(tree):
                self._meanings = {
                    number: {**known, name: other} if known.get(name) == tree else known
                    for number, known in own.items()
                }
                true = self._count(script, name)
                if true > most:
                    most, best = true, self._meanings
            self._meanings = best

    def _other_angles(self, tree: Expression) -> Iterator[Expression]:
        """The acute angle for an obtuse one, and angles in the other sense."""
        if self._is_obtuse(tree):
            straight = Degrees(Fraction(180))
            yield Binary("-", straight, tree)
            yield Binary("-", tree, straight)
        yield Negate(tree)

    def _is_obtuse(self, tree: Expression) -> bool:
        try:
            value = self._base.value(tree)
        except RestitutionError:
            return False
        return isinstance(value, Angle) and bool(np.all(np.cos(value.measure()) < -_OBTUSE))

    def _count(self, script: Script, name: str) -> int:
        """How many relations with a letter are true."""
        return sum(
            self._holds(link, line, self.worlds) is not None
            for line in script.lines
            for link in line.links
            if name in letters(link.readings[0].left) | letters(link.readings[0].right)
        )

    def _judged(self, line: ScriptLine) -> JudgedLine:
        if line.kind == "unread":
            return JudgedLine(line, "unread")
        if line.kind in ("remark", "heading", "crossed") or not line.links:
            seen = dict.fromkeys(self._seen(line))
            self._stated.update((use.principle, use.event) for use, _ in seen)
            stating = (use for use, value in seen if self._has_coefficient(value, line))
            return JudgedLine(line, "remark", uses=tuple(dict.fromkeys(stating)))
        line = self._with_axes(line)
        links = self._links(line)
        verdict = next(each for each in _WORST if any(link.verdict == each for link in links))
        place = next(k for k, link in enumerate(links) if link.verdict == verdict)
        worst = links[place]
        if verdict == "false" and self._is_only_supposed(line):
            return JudgedLine(line, "remark")
        if verdict == "false" and self._names and len(self._explained) < _NAMED:
            self._explain(line.number, self._explained_in(line, links, place))
        for name in worst.letters:
            self.unknown.add(name)
        accuracies = [link.accuracy for link in links if link.accuracy is not None]
        uses = self._uses(line, links)
        if verdict == "true":
            # A value rests on laws, and states none.
            self._stated |= {(use.principle, use.event) for use in uses[:1] if not use.altered}
        self._remember(line, links)
        return JudgedLine(
            line,
            verdict,
            accuracy=next((each for each in _GRADES if each in accuracies), None)
            if verdict in ("true", "follows")
            else None,
            uses=uses,
            read_as=read_as(tuple(link.claim for link in links)),
            link=place if verdict == "false" else None,
            sources=tuple(
                dict.fromkeys(n for link in links for n in link.sources if n != line.number)
            ),
            remark=next((link.remark for link in links if link.remark), None),
            grounded=all(link.grounded for link in links),
            meant={**self._meant, **dict(pair for link in links for pair in link.meant)},
        )

    def _is_only_supposed(self, line: ScriptLine) -> bool:
        """Whether a line tells what holds under a condition, or at most, and claims nothing."""
        if speaks_of_an_extreme(line) and not self.question.extreme:
            return True
        unequal = any(claim.sign != "=" for claim in line.supposed)
        return unequal and self._supposing(line) is not None

    def _supposing(self, line: ScriptLine) -> tuple[World, ...] | None:
        return supposed_in(line, self._base, self.meanings(line.number), self.question.unknown)

    def _under_condition(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A relation that holds where the equation behind its *if* or *when* does."""
        worlds = self._supposing(line)
        held = self._holds(link, line, worlds) if worlds else None
        return None if held is None else JudgedLink("true", held[1], held[0])

    def _becoming(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A component that changes its size: ``4 becomes 2``."""
        claim = link.readings[0]
        tried: list[tuple[Verdict, World]] = [("true", world) for world in self.worlds]
        tried += [("follows", world) for world in (self.students() if self.wrong else ())]
        for verdict, world in tried:
            for pair in changes_of_sizes(claim, line, world):
                first, second = (self.accuracy(each, world, line, link) for each in pair)
                if first is not None and second is not None:
                    return JudgedLink(verdict, claim, second)
        return None

    def _explained_in(self, line: ScriptLine, links: Sequence[JudgedLink], place: int) -> Explained:
        """What explains a link that is false, also as one of what its chain begins with.

        In ``I = m(v - u) = 2(5 - 3)`` the formula is quoted, and I has the wrong value.
        """
        entry = self._entry(line, line.links[place], links[place])
        explained = self.naming.explained(entry, self)
        start = end = place
        while start and _goes_on(links[start - 1], links[start]):
            start -= 1
        while end + 1 < len(links) and links[end].claim.right == links[end + 1].claim.left:
            end += 1
        first = links[start].claim.left
        worked = is_numeric(entry.claim.left) and is_numeric(entry.claim.right)
        if start == end or worked or not isinstance(first, Letter | Quantity):
            return explained
        quoted = not explained.variants or start < place
        for link in links[place : end + 1] if quoted else ():
            whole = replace(entry, claim=replace(entry.claim, left=first, right=link.claim.right))
            other = self.naming.explained(whole, self)
            if other.variants:
                return other
        return explained

    def _explain(self, number: int, explained: Explained) -> None:
        """Keep what explains a false line; altered laws of which two lines are instances stand."""
        for other, earlier in self._explained.items():
            same = {each.id for each in earlier.variants} & {each.id for each in explained.variants}
            for line in (other, number) if same else ():
                self._confirmed.setdefault(line, set()).update(same)
        self._explained[number] = explained

    def _has_coefficient(self, value: Expression, line: ScriptLine) -> bool:
        """Whether a value is written with e: ``12e``."""
        meanings = self.meanings(line.number)
        return any(
            _COEFFICIENT.fullmatch(name)
            and getattr(meanings.get(name), "kind", "restitution") == "restitution"
            for name in letters(value)
        )

    def _seen(self, line: ScriptLine) -> Iterator[tuple[Use, Expression]]:
        """The laws of which a value in a remark, ``1.5u``, is the component after a wall."""
        world = self._base
        for number, step in enumerate(world.events, 1):
            if not isinstance(step, Impact) or step.second not in world.walls:
                continue
            velocity = Quantity("velocity", (Name(step.first),), number)
            wall = Quantity("line_of_centres", (), number)
            for kind, law in (("along", "restitution"), ("across", "unchanged")):
                part = Apply("abs", Quantity(kind, (velocity, wall)))
                for value in line.values:
                    try:
                        if agrees(Claim(part, "=", value), world, self.meanings(line.number), ()):
                            yield Use(law, number, (step.first,)), value
                    except RestitutionError:
                        continue

    # --- a link -------------------------------------------------------------------------------

    def _links(self, line: ScriptLine) -> list[JudgedLink]:
        """The links of a line with their verdicts; one may follow from those before it."""
        judged: list[JudgedLink] = []
        known = len(self.entries)
        for link in line.links:
            each = self._link(line, link)
            if each.verdict in ("unread", "false") and judged and self._is_of_unlike(line, link):
                each = self._from_start(line, link, judged) or each
            judged.append(each)
            numeric = is_numeric(each.claim.left) and is_numeric(each.claim.right)
            if each.verdict in ("false", "follows") and not numeric:
                self.entries.append(self._entry(line, link, each))
        if len(self.entries) > known:
            del self.entries[known:]
            self._own = -1, ()
        return judged

    def _is_of_unlike(self, line: ScriptLine, link: Link) -> bool:
        """Whether a link compares a vector with a number."""
        try:
            agrees(link.readings[0], self._base, self.meanings(line.number), (), line.scope)
        except RestitutionError as error:
            return getattr(error, "letter", None) is None
        return False

    def _from_start(
        self, line: ScriptLine, link: Link, before: Sequence[JudgedLink]
    ) -> JudgedLink | None:
        """A link that compares unlike things, as one of what its chain begins with.

        In ``I = m(v - u) = 0.5(4 + 2)`` the middle is a vector, and the end its size. Where that
        is not true either, nobody knows what was meant: it is no mistake by that.
        """
        start = len(before) - 1
        if link.readings[0].left != before[start].claim.right:
            return None
        while start and _goes_on(before[start - 1], before[start]):
            start -= 1
        first = before[start].claim.left
        if not isinstance(first, Letter | Quantity):
            return None
        readings = tuple(dict.fromkeys(replace(each, left=first) for each in link.readings))
        other = self._link(line, replace(link, readings=readings))
        return None if other.verdict in ("unread", "false") else other

    def _link(self, line: ScriptLine, link: Link) -> JudgedLink:
        held = self._holds(link, line, self.worlds)
        if held is not None:
            accuracy, claim = held
            remark = COARSE if accuracy == "coarse" else None
            verdict: Verdict = "true"
            entry = self._entry_of(line, link, claim)
            students = self.students() if self.wrong else ()
            if len(line.links) == 1 and self._support.is_missing(entry, self.entries, students):
                verdict = "unsupported"
            firm = [each for each in self.entries if each.number not in self._groundless]
            grounded = self._support.is_grounded(entry, firm, self._forgone())
            if not grounded:
                self._groundless.add(line.number)
            return JudgedLink(verdict, claim, accuracy, remark=remark, grounded=grounded)
        return (
            self._root(line, link)
            or self._relabelled(line, link, self.worlds, "true")
            or self._of_unnamed_angle(line, link, self.worlds, "true")
            or self._of_other_root(line, link)
            or self._nearly(line, link)
            or self._under_condition(line, link)
            or self._becoming(line, link)
            or self._following(line, link)
            or self._refused(line, link)
        )

    def _relabelled(
        self, line: ScriptLine, link: Link, worlds: Sequence[World], verdict: Verdict
    ) -> JudgedLink | None:
        """A label that names its quantity at another moment, or in the other sense.

        A meaning that fits to a figure or two only is taken where none fits better.
        """
        best: JudgedLink | None = None
        for claim in link.readings:
            label = label_in(claim.left)
            if label is None:
                continue
            for meant in self._meanings_under(label.name, line):
                senses = (meant, Negate(meant)) if is_signed(meant) else (meant,)
                alone = claim.left == label
                further = (
                    (*times_sizes(senses, claim.right), *shares_of_energy(meant, claim.right))
                    if alone
                    else ()
                )
                for each in (*senses, *further):
                    other = replace(claim, left=exchanged(claim.left, {label: each}))
                    grade = self._best_accuracy(other, worlds, line, link)
                    if grade is None or (grade == "coarse" and best is not None):
                        continue
                    sources = sources_of(claim, self.entries) if verdict == "follows" else ()
                    meant_here = ((label.name, each),)
                    best = JudgedLink(verdict, other, grade, sources, meant=meant_here)
                    if grade != "coarse":
                        return best
        return best

    def _of_unnamed_angle(
        self, line: ScriptLine, link: Link, worlds: Sequence[World], verdict: Verdict
    ) -> JudgedLink | None:
        """A sine, cosine or tangent without its angle, as that of one angle of the story."""
        for claim in filter(unnamed_in, link.readings):
            for world in worlds:
                known = iter(self.naming.candidates(self._base))
                for angle, each in with_angles(claim, world, known):
                    grade = self.accuracy(each, world, line, link)
                    if grade is not None:
                        sources = sources_of(claim, self.entries) if verdict == "follows" else ()
                        meant = tuple((name, angle) for name in unnamed_in(claim))
                        return JudgedLink(verdict, each, grade, sources, meant=meant)
        return None

    def _meanings_under(self, phrase: str, line: ScriptLine) -> Iterator[Expression]:
        """The quantities that a phrase may name: of the body that labels its line as well.

        A line below the heading of one event may have come to another.
        """
        event, body = line.scope.event, line.scope.body
        yield from self._meanings_of(phrase, event)
        if body is not None and body not in phrase.split():
            yield from self._meanings_of(f"{phrase} of {body}", event)
        if event is not None and event == self._event_above:
            yield from self._meanings_of(phrase, None)

    def _meanings_of(self, phrase: str, event: int | None) -> tuple[Expression, ...]:
        """The quantities that a phrase may name, at every stage where it tells none."""
        key = phrase, event
        if key not in self._phrases:
            world = self._base
            first = 1 if is_relative(phrase) else 0
            every = range(first, len(world.events) + 1)
            stages = list(every) if event is None else [event, event - 1][: 2 - first]
            trees = read_phrase(phrase, world.problem, event, world.now())
            meanings = [
                staged(tree, world.problem, world.part, now)
                for tree in trees
                if is_vague(phrase) or are_alike(tree, trees[0])
                for now in stages
            ]
            self._phrases[key] = tuple(dict.fromkeys(meanings))
        return self._phrases[key]

    def _holds(
        self, link: Link, line: ScriptLine, worlds: Iterable[World]
    ) -> tuple[Accuracy, Claim] | None:
        """How exactly the best reading of a link holds in one of some worlds, and that reading."""
        best: tuple[Accuracy, Claim] | None = None
        for world in worlds:
            for claim in link.readings:
                grade = self.accuracy(claim, world, line, link)
                if grade == "exact":
                    return grade, claim
                if grade is not None and (best is None or best[0] == "coarse"):
                    best = grade, claim
        return best

    def _with_axes(self, line: ScriptLine) -> ScriptLine:
        """A line in which a negative component by its axis, *the j component*, has that sense.

        A positive one may be a size, whatever its sense.
        """
        known = self.meanings(line.number)

        def put(claim: Claim) -> Claim:
            if not isinstance(claim.left, Letter) or not names_axis(claim.left.name):
                return claim
            meant = known.get(claim.left.name)
            if not isinstance(meant, Negate):
                return claim
            try:
                negative = bool(np.all(self._base.scalar(claim.right) < 0))
            except RestitutionError:
                return claim
            return replace(claim, left=meant.operand) if negative else claim

        if not any(map(names_axis, known)):
            return line
        links = (replace(each, readings=tuple(map(put, each.readings))) for each in line.links)
        return replace(line, links=tuple(links))

    def accuracy(self, claim: Claim, world: World, line: ScriptLine, link: Link) -> Accuracy | None:
        """How exactly a claim holds in a world; None where it does not, or has no value there."""
        if not self.question.bounds.allows(claim):
            return None
        meanings = self.meanings(line.number)
        forms = (
            claim,
            *of_sizes(claim, meanings),
            *of_vectors(claim, meanings, world),
            *of_components(claim),
        )
        unlike = False
        for place, each in enumerate(forms):
            try:
                grade = agrees(each, world, meanings, link.decimals, line.scope)
            except RestitutionError:
                unlike = unlike or not place
                continue
            if grade is not None:
                return grade
        for each in of_natures(claim, meanings) if unlike else ():
            try:
                grade = agrees(each, world, meanings, link.decimals, line.scope)
            except RestitutionError:
                continue
            if grade is not None:
                return grade
        return self._in_turned_axes(claim, world, line, link)

    def _best_accuracy(
        self, claim: Claim, worlds: Iterable[World], line: ScriptLine, link: Link
    ) -> Accuracy | None:
        """How exactly a claim holds in that of several worlds in which it holds best."""
        grades = [self.accuracy(claim, world, line, link) for world in worlds]
        return next((each for each in reversed(_GRADES) if each in grades), None)

    def _in_turned_axes(
        self, claim: Claim, world: World, line: ScriptLine, link: Link
    ) -> Accuracy | None:
        """How exactly a pair holds as components along a wall or line of centres, and across it.

        Only where these are along neither i nor j: else a wrong sign would pass for a sense.
        """
        pair = claim.right
        if claim.sign != "=" or claim.others or not isinstance(pair, Pair):
            return None
        meanings = self.meanings(line.number)
        for axis in lines_of(world):
            if not is_oblique(axis, world):
                continue
            for along, across in ((pair.x, pair.y), (pair.y, pair.x)):
                grades = [
                    self._of_component(kind, claim.left, axis, value, world, meanings, line, link)
                    for kind, value in (("along", along), ("across", across))
                ]
                if None not in grades:
                    return next(each for each in _GRADES if each in grades)
        return None

    def _of_component(
        self,
        kind: str,
        whole: Expression,
        axis: Expression,
        value: Expression,
        world: World,
        meanings: Meanings,
        line: ScriptLine,
        link: Link,
    ) -> Accuracy | None:
        """How exactly the component of a vector is a value, in either sense of its axis."""
        if isinstance(whole, Letter):
            whole = meanings.get(whole.name, whole)
        for side in (value, Negate(value)):
            claim = Claim(Quantity(kind, (whole, axis)), "=", side)
            try:
                grade = agrees(claim, world, meanings, link.decimals, line.scope)
            except RestitutionError:
                return None
            if grade is not None:
                return grade
        return None

    def _root(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A value that is another root of the student's own equation, beside the right one."""
        for claim in link.readings:
            single = [
                replace(claim, right=right, others=()) for right in (claim.right, *claim.others)
            ]
            entries = [e for e in reversed(self.entries) if e.right]
            for entry in entries:
                roots = [is_root_of(each, entry) for each in single]
                if all(r is not None and self._valid(r, entry) for r in roots):
                    right = any(
                        self.accuracy(each, w, line, link) for each in single for w in self.worlds
                    )
                    if right or any(
                        same_left(e.claim, claim) and e.right and e.is_value for e in entries
                    ):
                        for each in single:
                            other = replace(self._entry_of(line, link, each), right=False)
                            if not any(self.accuracy(each, w, line, link) for w in self.worlds):
                                self._roots.append(other)
                        return JudgedLink("true", claim, "exact", remark=OTHER_ROOT)
        return None

    def _of_other_root(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """What another root of the student's own equation leads to: it is tried, and rejected."""
        if not self._roots:
            return None
        known = len(self.entries), len(self._roots)
        if self._rooted[0] != known:
            tried = [
                student_world(self._base, [*self.entries, root], self.question.unknown)
                for root in self._roots
            ]
            self._rooted = known, [world for world in tried if world is not None]
        for claim in link.readings:
            for world in self._rooted[1]:
                grade = self.accuracy(claim, world, line, link)
                if grade is not None:
                    return JudgedLink("true", claim, grade, remark=OTHER_ROOT)
        return None

    def _nearly(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that is true but for what the student's own rounding may have moved."""
        above = any(entry.decimals for entry in self.entries)
        beside = any(each.decimals for each in line.links if each is not link)
        if self.wrong or not link.decimals or not (above or beside):
            return None
        for claim in link.readings:
            if is_numeric(claim.left):
                continue
            for world in self.worlds:
                if self._loosely(claim, world, line, link) is not None:
                    return JudgedLink("true", claim, "coarse", remark=COARSE)
        return None

    def _valid(self, claim: Claim, entry: Entry) -> bool:
        try:
            return any(
                agrees(claim, world, entry.meanings, entry.decimals, entry.scope)
                for world in self.worlds
            )
        except RestitutionError:
            return False

    def _following(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        if not self.wrong and not any(entry.coarse for entry in self.entries):
            return None
        for claim in link.readings:
            for world in self.students():
                grade = self.accuracy(claim, world, line, link) or self._loosely(
                    claim, world, line, link
                )
                if grade is not None:
                    sources = sources_of(claim, self.entries)
                    return JudgedLink("follows", claim, grade, sources, self._impossible(claim))
        relabelled = (
            self._relabelled(line, link, self.students(), "follows")
            or self._of_unnamed_angle(line, link, self.students(), "follows")
            or self._with_own_numbers(line, link)
            or self._with_own_energies(line, link)
            or self._adopted(line, link)
            or self._consistent(line, link)
        )
        if relabelled is not None:
            return relabelled
        for claim in link.readings:
            entry = self._entry_of(line, link, claim)
            if (number := self._own_root(entry)) is not None:
                return JudgedLink("follows", claim, "exact", (number,), self._impossible(claim))
            if sum(each.wrong for each in self.entries) > _NAMED:
                break
            places = deduced_from(entry, self.entries, self._base, self.question.given)
            if places:
                numbers = tuple(self.entries[place].number for place in places)
                return JudgedLink("follows", claim, "exact", numbers, self._impossible(claim))
        return self._bounded(line, link)

    def _bounded(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """An inequality that comes from his own value and a condition on it."""
        bounds = self.question.bounds
        for claim in link.readings:
            if claim.sign == "=":
                continue
            entry = self._entry_of(line, link, claim)
            conditions = list(conditions_of(bounds.given, self._letters_worth(line)))
            known = {name: float(x.flat[0]) for name, x in self._base.letters.items()}
            entries = [each for each in self.entries if each.number <= line.number]
            source = bounded_by(entry, entries, conditions, known, bounds.coefficients)
            if source is not None:
                return JudgedLink("follows", claim, "exact", (source,))
        return None

    def _letters_worth(self, line: ScriptLine) -> Callable[[Expression], Iterator[tuple[str, int]]]:
        """The letters of a line that are worth a quantity, or its opposite."""

        def worth(tree: Expression) -> Iterator[tuple[str, int]]:
            for name, meant in self.meanings(line.number).items():
                for sense, claim in (
                    (1, Claim(meant, "=", tree)),
                    (-1, Claim(meant, "=", Negate(tree))),
                ):
                    try:
                        if agrees(claim, self._base, {}, (), line.scope):
                            yield name, sense
                            break
                    except RestitutionError:
                        continue

        return worth

    def _with_own_numbers(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that is true with what the student's wrong numbers stand for."""
        for claim in self._in_all_meanings(link, line):
            for each, numbers in self._own_numbers.put_back(claim):
                grade = next(
                    (g for w in self.worlds if (g := self.accuracy(each, w, line, link))), None
                )
                if grade is not None:
                    return JudgedLink("follows", claim, grade, numbers, right=each)
        return None

    def _with_own_energies(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """An energy lost that is the difference of the energies which the student has."""
        meanings = self.meanings(line.number)
        for claim in link.readings:
            pair = energies_between(claim.left, meanings)
            own = [self._own_value(each) for each in pair or ()]
            if len(own) != 2 or None in own:
                continue
            before, after = (each for each in own if each is not None)
            lost = Binary("-", before.claim.right, after.claim.right)
            other = replace(claim, left=lost)
            for world in self.worlds:
                grade = self.accuracy(other, world, line, link)
                if grade is not None:
                    return JudgedLink("follows", claim, grade, (before.number, after.number))
        return None

    def _own_value(self, quantity: Expression) -> Entry | None:
        """The last line that gives a quantity a value."""
        for entry in reversed(self.entries):
            left = entry.claim.left
            meant = entry.meanings.get(left.name, left) if isinstance(left, Letter) else left
            if meant == quantity and entry.claim.sign == "=":
                return entry
        return None

    def _in_all_meanings(self, link: Link, line: ScriptLine) -> Iterator[Claim]:
        """The readings of a link; one that begins with a phrase in each of its meanings as well."""
        yield from link.readings
        first = link.readings[0]
        if isinstance(first.left, Letter) and is_phrase(first.left.name):
            for meant in self._meanings_of(first.left.name, line.scope.event)[:_PHRASED]:
                yield replace(first, left=meant)

    def _adopted(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line with a letter that has no meaning yet, and holds with one in his own world.

        A letter whose lines are all below a mistake cannot be known from true values.
        """
        claim = link.readings[0]
        names_in_claim = letters(claim.left) | letters(claim.right)
        known = self.meanings(line.number).keys() | self._base.letters.keys()
        names = [name for name in names_in_claim if name not in known]
        if len(names) != 1 or claim.sign != "=" or not self.wrong or is_phrase(names[0]):
            return None
        (name,) = names
        usage = Usage(name, name in inside_angles(claim.left) | inside_angles(claim.right))
        usual = sorted(
            options(usage, self.naming.candidates(self._base), self._base.problem),
            key=lambda each: each.cost,
        )
        for each in usual:
            if each.start or each.cost > _USUAL or each.nature == "vector":
                continue
            self._meant[name] = each.quantity
            for reading in link.readings:
                for world in self.students():
                    grade = self.accuracy(reading, world, line, link) or self._loosely(
                        reading, world, line, link
                    )
                    if grade is not None:
                        sources = sources_of(reading, self.entries)
                        return JudgedLink("follows", reading, grade, sources)
            del self._meant[name]
        return None

    def _consistent(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that holds where the altered law of a mistake above stands, and all else is true.

        One that is an instance of an altered law itself is no consequence.
        """
        if not self._names or not self._explained:
            return None
        entry = replace(self._entry_of(line, link, link.readings[0]), right=False, wrong=True)
        again = {_family(use.altered) for use in self.uses_of_entry(entry) if use.altered}
        for number, mistake in self._explained.items():
            if again & {_family(each.id) for each in mistake.variants}:
                continue
            for variant in mistake.variants[:_ALTERED]:
                world = self.altered(variant)
                if world is None:
                    continue
                for claim in link.readings:
                    grade = self.accuracy(claim, world, line, link)
                    if grade is not None:
                        self._confirmed.setdefault(number, set()).add(variant.id)
                        return JudgedLink("follows", claim, grade, (number,))
        return None

    def _impossible(self, claim: Claim) -> str | None:
        """The remark on a coefficient, a sine or a cosine that cannot have its value."""
        left = claim.left
        if claim.sign != "=" or not is_numeric(claim.right):
            return None
        try:
            value = self._base.scalar(claim.right)
        except UnvaluedError:
            return None
        if isinstance(left, Apply) and left.function in ("sin", "cos"):
            return IMPOSSIBLE_ANGLE if np.any(np.abs(value) > 1 + _OWN_ROUNDING) else None
        if isinstance(left, Letter) and _COEFFICIENT.fullmatch(left.name):
            outside = (value > 1 + _OWN_ROUNDING) | (value < -_OWN_ROUNDING)
            return IMPOSSIBLE_COEFFICIENT if np.any(outside) else None
        return None

    def _own_root(self, entry: Entry) -> int | None:
        """The line that is not true and of which a value is a root."""
        for other in reversed(self.entries):
            root = None if other.right else is_root_of(entry.claim, other)
            if root is not None and self._valid(root, other):
                return other.number
        return None

    def _loosely(self, claim: Claim, world: World, line: ScriptLine, link: Link) -> Accuracy | None:
        """Whether a claim holds within what the student's own rounding may have moved."""
        rounded = any(entry.decimals for entry in self.entries)
        if claim.sign != "=" or not (link.decimals or rounded):
            return None
        try:
            apart, size = difference(claim, world, self.meanings(line.number), line.scope)
        except RestitutionError:
            return None
        close = np.all(np.abs(apart) <= _OWN_ROUNDING * size)
        return "rounded" if close and np.all(size > 0) else None

    def _refused(self, line: ScriptLine, link: Link) -> JudgedLink:
        """A link that neither holds nor follows: false, or not to be decided."""
        missing: set[str] = set()
        fault: str | None = None
        meanings = self.meanings(line.number)
        # v_A is of A whatever its nature, and a vector has a size; else a letter may be doubtful.
        named = {
            name: tree
            for name, tree in meanings.items()
            if suffix(name) in self._base.start or kind_of(tree) in ("velocity", "impulse")
        }
        forms = (x for each in link.readings for x in (each, *of_natures(each, named)))
        for claim in chain(forms, self._in_all_meanings(link, line)):
            try:
                agrees(claim, self._base, meanings, link.decimals, line.scope)
            except RestitutionError as error:
                letter = getattr(error, "letter", None)
                if letter is None:
                    fault = fault or str(error)
                else:
                    missing.add(letter)
            else:
                if unnamed := unnamed_in(claim):
                    missing.update(unnamed)
                elif not missing:
                    return JudgedLink("false", claim)
        first = link.readings[0]
        if missing:
            return JudgedLink("asks", first, letters=frozenset(missing))
        return JudgedLink("unread", first, remark=fault)

    # --- the student's own values -------------------------------------------------------------

    def students(self) -> tuple[World, ...]:
        """The worlds in which the lines so far hold, as far as they can hold together."""
        if self._own[0] != len(self.entries):
            self._own = len(self.entries), tuple(self._worlds_of_student())
        return self._own[1]

    def _worlds_of_student(self) -> Iterator[World]:
        broken = self._broken()
        facts = any(fact.law for fact in facts_of(self._base))
        for latest, laws_first in ((True, False), (False, False), (True, True)):
            if laws_first and not facts:
                continue
            world = student_world(
                self._base,
                self.entries,
                self.question.unknown,
                latest=latest,
                broken=() if laws_first else broken,
                laws_first=laws_first,
            )
            if world is not None:
                yield world
        # A quantity wrongly worked out need not be what its components make of it.
        own = [each for each in self.entries if not (each.wrong and label_in(each.claim.left))]
        if own and len(own) < len(self.entries):
            world = student_world(self._base, own, self.question.unknown, laws_first=facts)
            if world is not None:
                yield world

    def _broken(self) -> frozenset[tuple[str, int | None]]:
        """The laws in whose place the student has an altered one."""
        return frozenset(
            (use.principle, use.event)
            for entry in self.entries
            if entry.wrong
            for use in self.uses_of_entry(entry)
            if use.altered is not None
        )

    def _forgone(self) -> frozenset[tuple[str, int | None]]:
        """The laws that a mistake above stands in place of, as far as mistakes have names."""
        if not self._names or not self.wrong:
            return frozenset()
        named = (
            (law.law, variant.event.number)
            for mistake in self._explained.values()
            for variant in mistake.variants[:_ALTERED]
            for law in variant.laws
        )
        return self._broken().union(named)

    def altered(self, variant: VariantAt) -> World | None:
        """The world of an altered law, all else being right."""
        key = variant.id, variant.event.number, self._base.solution
        if key not in self.naming.worlds:
            self.naming.worlds[key] = altered_world(self._base, variant, self.question.unknown)
        return self.naming.worlds[key]

    def stated(self) -> frozenset[tuple[str, int | None]]:
        """The laws that a line above states rightly, each with its event."""
        return frozenset(self._stated)

    def _remember(self, line: ScriptLine, links: Sequence[JudgedLink]) -> None:
        start: Expression | None = None
        last: Expression | None = None
        first, untrue = len(self.entries), False
        for link, judged in zip(line.links, links, strict=True):
            claim = judged.claim
            if start is None or claim.left != last:
                start, first, untrue = claim.left, len(self.entries), False
            last = claim.right
            if untrue and judged.verdict == "true":
                self._note_number(line, judged, start)  # β = 60 - 10.9 = 49.1
            untrue = untrue or judged.verdict in ("false", "follows")
            if judged.verdict not in ("true", "follows", "false", "unsupported"):
                continue
            if judged.verdict in ("false", "follows"):
                self._note_number(line, judged, start)
            if not is_numeric(claim.left) or not is_numeric(claim.right):
                self.entries.append(self._entry(line, link, judged))
            elif judged.verdict == "false" and not is_numeric(start):
                # A chain that ends in another number gives that number to what it begins with.
                del self.entries[first:]
                whole = replace(judged, claim=replace(claim, left=start))
                self.entries.append(self._entry(line, link, whole))

    def _note_number(self, line: ScriptLine, judged: JudgedLink, start: Expression) -> None:
        """Keep a number that is wrong, with what is right in its place."""
        claim = judged.right or judged.claim
        named = isinstance(start, Letter | Quantity | Apply)
        if claim.sign == "=" and (named or is_numeric(start)):
            meant = start if named else claim.left
            meanings = self.meanings(line.number)
            others: tuple[Expression, ...] = ()
            if isinstance(meant, Letter) and is_phrase(meant.name):
                others = self._meanings_of(meant.name, line.scope.event)
            self._own_numbers.note(judged.claim.right, meant, meanings, line.number, others)

    def _entry(self, line: ScriptLine, link: Link, judged: JudgedLink) -> Entry:
        entry = self._entry_of(line, link, judged.claim)
        return replace(
            entry,
            right=judged.verdict in ("true", "unsupported"),
            wrong=judged.verdict == "false",
            coarse=judged.accuracy == "coarse",
        )

    def _entry_of(self, line: ScriptLine, link: Link, claim: Claim) -> Entry:
        meanings = self.meanings(line.number)
        return Entry(line.number, claim, meanings, line.scope, link.decimals)

    # --- laws ---------------------------------------------------------------------------------

    def _uses(self, line: ScriptLine, links: Sequence[JudgedLink]) -> tuple[Use, ...]:
        uses: dict[Use, None] = {}
        for link, judged in zip(line.links, links, strict=True):
            if judged.verdict in ("true", "follows", "false", "unsupported"):
                entry = self._entry(line, link, judged)
                if judged.right is not None:  # of a law, with wrong numbers in it
                    entry = replace(entry, claim=judged.right, right=True)
                uses.update(dict.fromkeys(self.uses_of_entry(entry)))
        if len(uses) > 1:
            uses.pop(Use("arithmetic"), None)
        return tuple(uses)

    def uses_of_entry(self, entry: Entry) -> tuple[Use, ...]:
        """The laws of which an entry is an instance; altered ones where it is false."""
        key = entry.claim, entry.number, entry.wrong
        if key not in self._known_uses:
            self._known_uses[key] = self._first_uses(entry)
        return self._known_uses[key]

    def _first_uses(self, entry: Entry) -> tuple[Use, ...]:
        students = () if entry.right or entry.wrong else self.students()
        for world in (self._base, *students):
            try:
                uses = uses_of(
                    entry.claim,
                    world,
                    entry.meanings,
                    entry.decimals,
                    entry.scope,
                    altered=not entry.right,
                )
            except RestitutionError:
                continue
            if uses:
                return uses
        return ()


def _uses_of_variants(variants: Sequence[VariantAt], mistake: Mistake) -> Iterator[Use]:
    """The altered laws and results of a named mistake in a line with numbers put in."""
    for variant in variants:
        if variant.id in mistake.variants:
            for law in variant.laws:
                yield Use(law.law, variant.event.number, law.bodies, variant.id)
            for result in variant.results:
                kind = _PRINCIPLES.get(str(kind_of(result.quantity)))
                if kind is not None:
                    yield Use(kind, variant.event.number, (), variant.id)


def _goes_on(before: JudgedLink, link: JudgedLink) -> bool:
    """Whether a link goes on from a true one as a chain."""
    return before.verdict == "true" and before.claim.right == link.claim.left


def _family(variant: str) -> str:
    """The misconception of which an altered law is a variant."""
    return variant.partition("/")[0]
