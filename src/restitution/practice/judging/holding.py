"""Whether a relation holds in a world: in one of its forms, in one meaning of its phrases."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, product

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged
from restitution.expression.quantities import KINDS
from restitution.expression.tree import (
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Pair,
    Quantity,
    has_unit_vector,
    is_quantity,
    unsigned,
)
from restitution.practice.judgement import Accuracy, Verdict
from restitution.practice.judging.along_vectors import by_vectors
from restitution.practice.judging.entries import (
    Entry,
    Meanings,
    sources_of,
)
from restitution.practice.judging.judged_link import (
    GRADES,
    JudgedLink,
    Question,
)
from restitution.practice.judging.other_forms import (
    after_earlier_event,
    are_alike,
    as_vectors,
    has_bars,
    is_oblique,
    is_signed,
    label_in,
    lines_of,
    of_components,
    of_known_speeds,
    of_natures,
    of_sizes,
    of_vectors,
    shares_of_energy,
    times_directions,
    times_sizes,
    with_units,
)
from restitution.practice.letters.options import is_angle_to_a_wall, staged
from restitution.practice.reading.phrase_names import (
    event_of,
    is_phrase,
    is_relative,
    is_vague,
    names_axis,
    speaks_of_the_end,
    tells_after,
)
from restitution.practice.reading.phrases import read_phrase
from restitution.practice.script import Claim, Link, ScriptLine
from restitution.practice.worlds.agreement import agrees, difference, is_angular
from restitution.practice.worlds.world import World

# How far a student's own rounding to three figures may move his values.
OWN_ROUNDING = 0.006
_PHRASED = 6
_PAIRS = 40


def _is_of_an_event(tree: Expression) -> bool:
    """Whether a quantity is one of an event, as a deflection is, and not of a moment."""
    inside = unsigned(tree)
    record = KINDS.get(inside.kind) if isinstance(inside, Quantity) else None
    return record is not None and record.of_an_event


class Holding:
    """How the relations of a script hold, under one meaning of its letters.

    ``worlds`` are those of the admissible solutions, ``meanings`` those of the letters in each
    line, by its number; ``entries`` what the lines so far state.
    """

    def __init__(
        self, worlds: Sequence[World], meanings: Mapping[int, Meanings], question: Question
    ) -> None:
        self.worlds = tuple(worlds)
        self.question = question
        self.entries: list[Entry] = []
        self._meanings = meanings
        self._base = self.worlds[0]
        self._meant: dict[str, Expression] = {}
        self._phrases: dict[tuple[str, int | None], tuple[Expression, ...]] = {}
        self._event_above: int | None = None
        self._by_a_vector = False

    def meanings(self, number: int) -> Meanings:
        """What letters and phrases mean in a line."""
        known = self._meanings.get(number, {})
        return {**self._meant, **known} if self._meant else known

    @property
    def base(self) -> World:
        """The solution in which most lines are true."""
        return self._base

    # --- in a world ---------------------------------------------------------------------------

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

    def accuracy(self, claim: Claim, world: World, line: ScriptLine, link: Link) -> Accuracy | None:
        """How exactly a claim holds in a world; None where it does not, or has no value there."""
        if not self.question.bounds.allows(claim, link.decimals):
            return None
        meanings = self.meanings(line.number)
        forms = (
            claim,
            *of_sizes(claim, meanings),
            *of_vectors(claim, meanings, world),
            *of_components(claim),
        )
        unlike = False
        for place, form in enumerate(forms):
            try:
                grade = agrees(form, world, meanings, link.decimals, line.scope)
            except RestitutionError:
                unlike = unlike or not place
                continue
            if grade is not None:
                return grade
        others = (*of_natures(claim, meanings), *of_known_speeds(claim, world)) if unlike else ()
        for other in others:
            try:
                grade = agrees(other, world, meanings, link.decimals, line.scope)
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
        return next((grade for grade in reversed(GRADES) if grade in grades), None)

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
                    return next(grade for grade in GRADES if grade in grades)
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

    def _loosely(self, claim: Claim, world: World, line: ScriptLine, link: Link) -> Accuracy | None:
        """Whether a claim holds within what the student's own rounding may have moved."""
        rounded = any(entry.decimals for entry in self.entries)
        if claim.sign != "=" or not (link.decimals or rounded):
            return None
        try:
            apart, size = difference(claim, world, self.meanings(line.number), line.scope)
        except RestitutionError:
            return None
        close = np.all(np.abs(apart) <= OWN_ROUNDING * size)
        return "rounded" if close and np.all(size > 0) else None

    def _valid(self, claim: Claim, entry: Entry) -> bool:
        try:
            return any(
                agrees(claim, world, entry.meanings, entry.decimals, entry.scope)
                for world in self.worlds
            )
        except RestitutionError:
            return False

    # --- phrases ------------------------------------------------------------------------------

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
        links = (replace(link, readings=tuple(map(put, link.readings))) for link in line.links)
        return replace(line, links=tuple(links))

    def _with_sizes(self, line: ScriptLine) -> ScriptLine:
        """A line with letters of components for velocities: ``v_A = 3i + 2j``, ``|v_A| = 4``.

        The letter of a component and that of the velocity are often one.
        """
        meanings = self.meanings(line.number)
        links = (
            replace(link, readings=tuple(as_vectors(claim, meanings) for claim in link.readings))
            for link in line.links
        )
        line = replace(line, links=tuple(links))
        if not any(has_bars(claim) for link in line.links for claim in link.readings):
            return line

        def put(link: Link) -> Link:
            plain = any(
                self.accuracy(claim, world, line, link)
                for claim in link.readings
                for world in self.worlds
            )
            others = (x for claim in link.readings for x in of_natures(claim, meanings))
            readings = link.readings if plain else (*others, *link.readings)
            return replace(link, readings=tuple(dict.fromkeys(readings)))

        return replace(line, links=tuple(map(put, line.links)))

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
                quotient = self._relabelled_quotient(claim, line, link, worlds, verdict)
                if quotient is not None:
                    return quotient
                continue
            for meant in self._meanings_under(label.name, line):
                if self._is_asked_otherwise(meant, label):
                    continue
                senses = (meant, Negate(meant)) if is_signed(meant) else (meant,)
                alone = claim.left == label
                further = (
                    (
                        *times_sizes(senses, claim.right),
                        *times_directions(senses, self._claims_above(line), self._base),
                        *shares_of_energy(meant, claim.right),
                    )
                    if alone
                    else ()
                )
                for label_tree in (*senses, *further):
                    other = replace(claim, left=exchanged(claim.left, {label: label_tree}))
                    grade = self._best_accuracy(other, worlds, line, link)
                    if grade is None or (grade == "coarse" and best is not None):
                        continue
                    sources = sources_of(claim, self.entries) if verdict == "follows" else ()
                    meant_here = ((label.name, label_tree),)
                    best = JudgedLink(verdict, other, grade, sources, meant=meant_here)
                    if grade != "coarse":
                        return best
        return best

    def _at_event_of_heading(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A letter of what is at the end, as it is at an earlier event: ``after W: x = 9``."""
        event = line.scope.event
        if event is None:
            return None
        for claim in link.readings:
            if not isinstance(claim.left, Letter) or claim.sign != "=":
                continue
            own = self.meanings(line.number).get(claim.left.name)
            meant = after_earlier_event(own, event) if own is not None else None
            if meant is None:
                continue
            other = replace(claim, left=meant)
            grade = self._best_accuracy(other, self.worlds, line, link)
            if grade is not None:
                return JudgedLink("true", other, grade, meant=((claim.left.name, meant),))
        return None

    def _is_asked_otherwise(self, meant: Expression, label: Letter) -> bool:
        """Whether a label names the impulse on a body, which is asked as a vector, by its size."""
        inside = unsigned(meant)
        if not is_quantity(inside, "impulse") or inside.arguments:
            return False
        words = label.name.split()
        asked = {
            tree.arguments[0].name
            for tree, _ in self.question.wanted.asked
            if is_quantity(tree, "impulse") and tree.arguments
            if isinstance(tree.arguments[0], Name)
        }
        return "on" in words and not asked.isdisjoint(words)

    def _claims_above(self, line: ScriptLine) -> Iterator[Claim]:
        """The claims of the lines above, and of a line itself as it is read first."""
        yield from (entry.claim for entry in self.entries if entry.claim.sign == "=")
        yield from (link.readings[0] for link in line.links)

    def _in_units(
        self, line: ScriptLine, link: Link, worlds: Sequence[World], verdict: Verdict
    ) -> JudgedLink | None:
        """Numbers that count in letters of the statement, which are left out."""
        for claim in link.readings:
            try:
                self._base.scalar(claim.left, self.meanings(line.number), scope=line.scope)
                angular = is_angular(claim, self._base, self.meanings(line.number), line.scope)
            except RestitutionError:
                continue
            if angular:
                continue
            for unit in with_units(claim, self._base):
                grade = self._best_accuracy(unit, worlds, line, link)
                if grade is not None:
                    sources = sources_of(claim, self.entries) if verdict == "follows" else ()
                    return JudgedLink(verdict, claim, grade, sources)
        return None

    def _by_vectors(
        self, line: ScriptLine, link: Link, worlds: Sequence[World], verdict: Verdict
    ) -> JudgedLink | None:
        """A component in words by a scalar product with a vector that is no unit vector.

        Where a wrong vector stands above it is along another line.
        """
        if any(entry.wrong and has_unit_vector(entry.claim.right) for entry in self.entries):
            return None
        for claim in link.readings:
            left = claim.left
            meant = self.meanings(line.number).get(left.name) if isinstance(left, Letter) else None
            for own in by_vectors(claim, meant, self._base):
                grade = self._best_accuracy(own, worlds, line, link)
                if grade is not None:
                    self._by_a_vector = True
                    sources = sources_of(claim, self.entries) if verdict == "follows" else ()
                    return JudgedLink(verdict, own, grade, sources)
        return None

    def _in_unit_of_vector(self, claim: Claim, line: ScriptLine) -> Claim:
        """A claim about a component by a vector, if one above was so as well."""
        if not self._by_a_vector or not isinstance(claim.left, Letter):
            return claim
        meant = self.meanings(line.number).get(claim.left.name)
        return next(by_vectors(claim, meant, self._base), claim)

    def _relabelled_quotient(
        self,
        claim: Claim,
        line: ScriptLine,
        link: Link,
        worlds: Sequence[World],
        verdict: Verdict,
    ) -> JudgedLink | None:
        """Two labels, one over the other, that name their quantities at other moments."""
        match claim.left:
            case Binary("/", Letter(above), Letter(below)) if is_phrase(above) and is_phrase(below):
                pairs = product(*(self._meanings_under(part, line) for part in (above, below)))
            case _:
                return None
        for one, other in islice(pairs, _PAIRS):
            own = replace(claim, left=Binary("/", one, other))
            grade = self._best_accuracy(own, worlds, line, link)
            if grade is not None and grade != "coarse":
                sources = sources_of(claim, self.entries) if verdict == "follows" else ()
                meant = ((above, one), (below, other))
                return JudgedLink(verdict, own, grade, sources, meant=meant)
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
            first = 1 if is_relative(phrase) or tells_after(phrase, world.problem) else 0
            event = event or event_of(phrase, world.problem)
            if event is None and speaks_of_the_end(phrase):
                event = len(world.events)
            trees = read_phrase(phrase, world.problem, event, world.now())
            if event is not None and trees and _is_of_an_event(trees[0]):
                first = 1  # no deflection of the second impact is that of the first
            if event is None and trees and is_angle_to_a_wall(trees[0], world.problem):
                first = max(first, world.first_stage)  # what is before is another part's
            every = range(first, world.now() + 1)
            stages = list(every) if event is None else [event, event - 1][: 2 - first]
            meanings = [
                staged(tree, world.problem, world.part, now)
                for tree in trees
                if is_vague(phrase) or is_relative(phrase) or are_alike(tree, trees[0])
                for now in stages
            ]
            self._phrases[key] = tuple(dict.fromkeys(meanings))
        return self._phrases[key]

    def _in_all_meanings(self, link: Link, line: ScriptLine) -> Iterator[Claim]:
        """The readings of a link; one that begins with a phrase in each of its meanings as well."""
        yield from link.readings
        first = link.readings[0]
        if isinstance(first.left, Letter) and is_phrase(first.left.name):
            for meant in self._meanings_of(first.left.name, line.scope.event)[:_PHRASED]:
                yield replace(first, left=meant)

    # --- entries ------------------------------------------------------------------------------

    def _entry(self, line: ScriptLine, link: Link, judged: JudgedLink) -> Entry:
        entry = self._entry_of(line, link, judged.claim)
        exact = judged.verdict == "true" and judged.accuracy == "exact"
        return replace(
            entry,
            decimals=() if exact else entry.decimals,  # 0.6 and 0.8 are what they are
            right=judged.verdict in ("true", "unsupported"),
            wrong=judged.verdict == "false",
            coarse=judged.accuracy == "coarse",
        )

    def _entry_of(self, line: ScriptLine, link: Link, claim: Claim) -> Entry:
        meanings = self.meanings(line.number)
        return Entry(line.number, claim, meanings, line.scope, link.decimals)
