"""Whether a relation that is not true follows: from own values or equations."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain, islice

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.lines.trees import exchanged
from restitution.expression.tree import (
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Quantity,
    has_quantity,
    is_component,
    is_function,
    is_quantity,
    letters,
    quantities_in,
    unsigned,
    walk,
)
from restitution.practice.judgement import Accuracy, Use, Verdict
from restitution.practice.judging.angles import unnamed_in, with_angles
from restitution.practice.judging.assembling import assembled_from
from restitution.practice.judging.bounds import bounded_by, conditions_of, rearranged_from
from restitution.practice.judging.claimed import meant_by
from restitution.practice.judging.deduction import deduced_from
from restitution.practice.judging.entries import (
    Entry,
    Meanings,
    is_numeric,
    names_of,
    sources_of,
)
from restitution.practice.judging.exchanged_components import is_exchanged_as_well
from restitution.practice.judging.holding import OWN_ROUNDING
from restitution.practice.judging.judged_link import (
    REPEATED,
    JudgedLink,
    Question,
)
from restitution.practice.judging.nearly_true import NearlyTrue
from restitution.practice.judging.other_forms import (
    after_later_events,
    by_components,
    by_energies,
    is_difference_of_tangents,
    kind_of,
    with_across_exchanged,
)
from restitution.practice.judging.own_values import ALTERED, Naming
from restitution.practice.judging.own_vectors import square_of_own, with_vectors_put_back
from restitution.practice.judging.plain_energies import is_turned_loss
from restitution.practice.judging.plain_mistakes import is_of_energy
from restitution.practice.judging.support import Support
from restitution.practice.judging.uses import repeated_in
from restitution.practice.letters.options import Usage, options
from restitution.practice.letters.trial import inside_angles
from restitution.practice.reading.phrase_names import is_phrase
from restitution.practice.reading.vocabulary import HEADS
from restitution.practice.script import Claim, Link, ScriptLine
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.arrays import UnvaluedError
from restitution.practice.worlds.student import student_world
from restitution.practice.worlds.world import World
from restitution.vector import Vector

_USUAL = 0.3
"""A letter takes a meaning of at most this cost from lines below a mistake."""
NAMED = 10
"""So many mistakes are looked into; of more the first tell enough."""
_OF_COMPONENTS = frozenset({"momentum", "restitution", "unchanged"})
"""The laws that tell the components after an impact."""
_OF_ENERGIES = frozenset({"energy-no-half", "mass-omitted"})
"""What whoever leaves it out of one energy leaves out of the other."""
_OF_OTHER_ANGLE = ("sine-cosine", "angle-from-normal")
_OF_SPHERES = frozenset({"momentum", "restitution"})
"""The laws along a line of centres."""
IMPOSSIBLE_ANGLE = "A sine or a cosine is at most 1, so this cannot be."
IMPOSSIBLE_COEFFICIENT = "A coefficient of restitution lies between 0 and 1, so this cannot be."
COEFFICIENT = re.compile(r"e(_\w+)?'*")


class Following(NearlyTrue):
    """What follows from the lines above, where it does not hold."""

    _support: Support

    def __init__(
        self,
        worlds: Sequence[World],
        meanings: Mapping[int, Meanings],
        naming: Naming,
        question: Question,
        *,
        names: bool = True,
    ) -> None:
        super().__init__(worlds, meanings, naming, question, names=names)
        self._confirmed: dict[int, set[str]] = {}
        self._groundless: set[int] = set()

    def _following(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        if not self.wrong and not any(entry.coarse for entry in self.entries):
            return None
        relabelled = (
            self._in_own_worlds(line, link)
            or self._relabelled(line, link, self.students(), "follows")
            or self._of_unnamed_angle(line, link, self.students(), "follows")
            or self._with_own_numbers(line, link)
            or self._with_own_vectors(line, link)
            or self._with_own_fixed(line, link)
            or self._of_own_direction(line, link)
            or self._with_own_energies(line, link)
            or self._with_own_components(line, link)
            or self._with_across_exchanged(line, link)
            or self._in_units(line, link, self.students(), "follows")
            or self._under_own_condition(line, link)
            or self._of_own_speeds(line, link)
            or self._by_opposite_impulse(line, link)
            or self._by_momentum_of_vectors(line, link)
            or self._of_later_event(line, link)
            or self._adopted(line, link)
            or self._consistent(line, link)
        )
        if relabelled is not None:
            return relabelled
        for claim in link.readings:
            entry = self._entry_of(line, link, claim)
            if (number := self._own_root(entry)) is not None:
                return JudgedLink("follows", claim, "exact", (number,), self._impossible(claim))
            if lines := assembled_from(claim, entry.meanings, self.entries):
                return JudgedLink("follows", claim, "rounded", lines)
            if sum(entry.wrong for entry in self.entries) > NAMED:
                break
            places = deduced_from(entry, self.entries, self._base, self.question.given)
            if places:
                numbers = tuple(self.entries[place].number for place in places)
                return JudgedLink("follows", claim, "exact", numbers, self._impossible(claim))
        return self._bounded(line, link)

    def _in_own_worlds(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """What holds in one of the student's own worlds."""
        for claim in link.readings:
            for world in self.students():
                grade = self.accuracy(claim, world, line, link) or self._loosely(
                    claim, world, line, link
                )
                if grade is not None:
                    sources = sources_of(claim, self.entries)
                    return JudgedLink("follows", claim, grade, sources, self._impossible(claim))
        return None

    def _of_unnamed_angle(
        self, line: ScriptLine, link: Link, worlds: Sequence[World], verdict: Verdict
    ) -> JudgedLink | None:
        """A sine, cosine or tangent without its angle, as that of one angle of the story."""
        for claim in filter(unnamed_in, link.readings):
            for world in worlds:
                known = iter(self.naming.candidates(self._base))
                for angle, own in with_angles(claim, world, known):
                    grade = self.accuracy(own, world, line, link)
                    if grade is not None:
                        sources = sources_of(claim, self.entries) if verdict == "follows" else ()
                        meant = tuple((name, angle) for name in unnamed_in(claim))
                        return JudgedLink(verdict, own, grade, sources, meant=meant)
        return None

    def _with_own_vectors(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that is true with what the student's wrong vectors stand for."""
        for claim in link.readings:
            if (number := square_of_own(claim, self.entries, self._base)) is not None:
                return JudgedLink("follows", claim, "exact", (number,))
            for own, number in with_vectors_put_back(claim, self.entries, self._base):
                grade = self._best_accuracy(own, self.worlds, line, link)
                if grade is not None:
                    return JudgedLink("follows", claim, grade, (number,), right=own)
        return None

    def _with_own_numbers(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that is true, or follows, with what the student's wrong numbers stand for."""
        for claim in self._in_all_meanings(link, line):
            for own, numbers in self._own_numbers.put_back(claim):
                if self._becomes_zero(claim, own):
                    continue  # any other number would follow as well
                worlds: Sequence[World] = self.worlds
                if _quantities_of(own) <= _quantities_of(claim):
                    # A product of data is in his world what it is in the true one.
                    worlds = (*worlds, *islice(self.students(), 1))
                # What was rounded above the wrong number is no decimal of this line.
                grade = self._best_accuracy(own, worlds, line, link) or next(
                    (g for w in worlds if (g := self._loosely(own, w, line, link))), None
                )
                if grade is not None:
                    return JudgedLink("follows", claim, grade, numbers, right=own)
        return None

    def _becomes_zero(self, claim: Claim, own: Claim) -> bool:
        """Whether a side is zero with what wrong numbers stand for, and is not as it is written."""
        for written, side in ((claim.left, own.left), (claim.right, own.right)):
            if written == side:
                continue
            try:
                before, after = (np.abs(self._base.scalar(x)) for x in (written, side))
            except UnvaluedError:
                continue
            if np.all(after <= OWN_ROUNDING) and np.any(before > OWN_ROUNDING):
                return True
        return False

    def _with_own_fixed(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that holds with the student's own value of what the question fixes.

        A wrong angle of the line of centres is no part of his world, which has his velocities.
        """
        meanings = self.meanings(line.number)
        own: dict[Letter, Expression] = {}
        numbers: dict[Letter, int] = {}
        for entry in self.entries:
            left = entry.claim.left
            if entry.right or not entry.is_value or not isinstance(left, Letter):
                continue
            meant = meanings.get(left.name)
            if meant is not None and self._is_fixed(meant):
                own[left], numbers[left] = entry.claim.right, entry.number
        for claim in link.readings if own else ():
            inside = [
                letter
                for letter in own
                if letter.name in letters(claim.left) | letters(claim.right)
            ]
            if not inside or isinstance(claim.left, Letter):
                continue
            put: dict[Expression, Expression] = dict(own.items())
            left, right = (exchanged(side, put) for side in (claim.left, claim.right))
            other = replace(claim, left=left, right=right)
            for world in chain(self.worlds, self.students()):
                grade = self.accuracy(other, world, line, link)
                if grade is not None:
                    lines = tuple(dict.fromkeys(numbers[letter] for letter in inside))
                    return JudgedLink("follows", claim, grade, lines)
        return None

    def _of_own_direction(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A vector along, or across, the wrong direction that a line above gives a wall."""
        for claim in link.readings:
            own = self._line_along(claim)
            if own is None:
                continue
            for entry in self.entries:
                above = None if entry.right else self._line_along(entry.claim)
                if above is not None and _are_parallel(above, own):
                    return JudgedLink("follows", claim, "exact", (entry.number,))
        return None

    def _line_along(self, claim: Claim) -> Vector | None:
        """The line of centres by a vector in numbers of which no part is along it, or across."""
        match claim:
            case Claim(Number(0), "=", Quantity("along" | "across" as kind, (vector, line))):
                pass
            case _:
                return None
        if not is_quantity(line, "line_of_centres") or not is_numeric(vector):
            return None
        value = self._base.value(vector)
        if not isinstance(value, Vector):
            return None
        x, y = (float(np.ravel(self._base.spread(part))[0]) for part in (value.x, value.y))
        return Vector(x, y) if kind == "across" else Vector(-y, x)

    def _with_own_energies(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """An energy lost, or a ratio of energies, by the energies which the student has."""
        meanings = self.meanings(line.number)
        for claim in self._in_all_meanings(link, line):
            for form in by_energies(claim.left, meanings):
                own: dict[Expression, Entry] = {
                    node: entry
                    for node in walk(form)
                    if isinstance(node, Quantity) and (entry := self._own_value(node)) is not None
                }
                if all(entry.right for entry in own.values()):
                    continue
                put = {tree: entry.claim.right for tree, entry in own.items()}
                other = replace(claim, left=exchanged(form, put))
                for world in self.worlds:
                    grade = self.accuracy(other, world, line, link)
                    if grade is not None:
                        numbers = tuple(dict.fromkeys(entry.number for entry in own.values()))
                        return JudgedLink("follows", claim, grade, numbers)
        return None

    def _with_own_components(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """An impulse by the component along the line that the student has, before and after.

        Where his component across changes, it is no part of that impulse.
        """
        if not any(law in _OF_COMPONENTS for law, _ in self._forgone()):
            return None
        for claim in self._in_all_meanings(link, line):
            for other in by_components(claim, self.meanings(line.number), self._base):
                for world in self.students():
                    grade = self.accuracy(other, world, line, link)
                    if grade is not None:
                        sources = sources_of(claim, self.entries)
                        return JudgedLink("follows", claim, grade, sources)
        return None

    def _with_across_exchanged(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A speed with sine and cosine exchanged across the line as well, where they are along."""
        numbers = tuple(
            number
            for number, one in self._explained.items()
            if any(variant.mistake in _OF_OTHER_ANGLE for variant in one.variants)
        )
        for claim in self._in_all_meanings(link, line) if numbers else ():
            left = claim.left
            meant = self.meanings(line.number).get(left.name) if isinstance(left, Letter) else left
            other = None if meant is None else with_across_exchanged(meant)
            if other is None or other == meant:
                continue
            for world in self.students():
                grade = self.accuracy(replace(claim, left=other), world, line, link)
                if grade is not None:
                    sources = sources_of(claim, self.entries)
                    return JudgedLink("follows", claim, grade, sources or numbers)
        return None

    def _under_own_condition(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A relation that holds with his own lines where a letter has the value of its case."""
        supposed = [claim for claim in link.supposed or line.supposed if claim.sign == "="]
        if not supposed or not self.wrong:
            return None
        case = [replace(self._entry_of(line, link, claim), right=False) for claim in supposed]
        names = {name for claim in supposed for name in letters(claim.left) | letters(claim.right)}
        unknown = {*self.question.unknown, *names & self._base.letters.keys()}
        world = student_world(
            self._base, [*self.entries, *case], unknown, broken=self._broken(self.entries)
        )
        for claim in link.readings:
            grade = None if world is None else self.accuracy(claim, world, line, link)
            if grade is not None:
                sources = sources_of(claim, self.entries)
                return JudgedLink("follows", claim, grade, sources)
        return None

    def _of_own_speeds(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A coefficient by the separation and the approach that lines above work out."""
        relative: dict[str, Entry] = {}
        for entry in self.entries:
            left = entry.claim.left
            heads = {HEADS.get(x) for x in left.name.split()} if isinstance(left, Letter) else set()
            for head in ("approach", "separation"):
                if head in heads and entry.claim.sign == "=":
                    relative[head] = entry
        if len(relative) < 2 or all(entry.right for entry in relative.values()):
            return None
        before, after = (relative[head].claim.right for head in ("approach", "separation"))
        for claim in link.readings:
            if not (isinstance(claim.left, Letter) and COEFFICIENT.fullmatch(claim.left.name)):
                continue
            quotient = replace(claim, left=Apply("abs", Binary("/", after, before)))
            grade = self.accuracy(quotient, self._base, line, link)
            if grade is not None:
                numbers = tuple(entry.number for entry in relative.values())
                return JudgedLink("follows", claim, grade, numbers, self._impossible(claim))
        return None

    def _by_opposite_impulse(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A velocity after by the student's own impulse on the other sphere, turned round."""
        meanings = self.meanings(line.number)
        for claim in link.readings:
            left = claim.left
            meant = meanings.get(left.name) if isinstance(left, Letter) else left
            match meant:
                case Quantity("velocity", (Name(body),), int(stage)) if stage and not claim.others:
                    before = Quantity("velocity", (Name(body),), stage - 1)
                case _:
                    continue
            for other in self._base.start:
                own = self._own_value(Quantity("impulse", (Name(other),), stage))
                if own is None or own.right or other == body:
                    continue
                change = Binary("-", claim.right, before)
                gain = Binary("*", Quantity("mass", (Name(body),)), change)
                turned = replace(claim, left=gain, right=Negate(own.claim.right))
                grade = self.accuracy(turned, self._base, line, link)
                if grade is not None:
                    return JudgedLink("follows", claim, grade, (own.number,))
        return None

    def _of_later_event(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A letter that has a value, and is given another: its quantity after a later event."""
        for claim in link.readings if self.wrong else ():
            left = claim.left
            if (
                not isinstance(left, Letter)
                or claim.sign != "="
                or left.name in letters(claim.right)
            ):
                continue
            meant = self.meanings(line.number).get(left.name)
            if meant is None or is_phrase(left.name) or not self._has_value(left, line):
                continue
            for later in after_later_events(meant, len(self._base.events)):
                other = replace(claim, left=later)
                for world in self.students():
                    grade = self.accuracy(other, world, line, link)
                    if grade is not None:
                        sources, own = sources_of(other, self.entries), ((left.name, later),)
                        return JudgedLink("follows", claim, grade, sources, meant=own)
        return None

    def _at_heading(self, claim: Claim, line: ScriptLine) -> Claim:
        """A false claim, its label at the event of the heading, if it is taken for another's.

        So is a letter that has a value from before that event: ``kick: v = i - j``.
        """
        event = line.scope.event
        if event is None or not isinstance(claim.left, Letter):
            return claim
        own = self.meanings(line.number).get(claim.left.name)
        if not is_phrase(claim.left.name):
            again = own is not None and self._has_value(claim.left, line)
            later = after_later_events(own, event) if own is not None and again else ()
            return replace(claim, left=next(reversed(list(later)), claim.left))
        meant = self._meanings_of(claim.left.name, event)
        same = tuple(tree for tree in meant if own is None or kind_of(tree) == kind_of(own))
        return claim if own in meant or not same else replace(claim, left=same[0])

    def _has_value(self, letter: Letter, line: ScriptLine) -> bool:
        """Whether a line above gives a letter its value."""
        return any(
            entry.is_value and entry.claim.left == letter and entry.number < line.number
            for entry in self.entries
        )

    def _adopted(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line with a letter that has no meaning yet, and holds with one in his own world.

        A letter whose lines are all below a mistake cannot be known from true values.
        """
        adopted = self._adopted_in(self.students(), line, link) if self.wrong else None
        if adopted is None:
            return None
        claim, grade, _ = adopted
        return JudgedLink("follows", claim, grade, sources_of(claim, self.entries))

    def _adopted_at_an_extreme(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line with a letter without a meaning, of what is greatest or least: ``6t² = 2``."""
        worlds = () if self.wrong else self.question.at_extremes
        adopted = self._adopted_in(worlds, line, link) if worlds else None
        if adopted is None:
            return None
        claim, grade, pair = adopted
        return JudgedLink("true", claim, grade, meant=(pair,))

    def _adopted_in(
        self, worlds: Sequence[World], line: ScriptLine, link: Link
    ) -> tuple[Claim, Accuracy, tuple[str, Expression]] | None:
        """The reading that holds with a meaning of the only letter that has none, if one does."""
        claim = link.readings[0]
        names_in_claim = letters(claim.left) | letters(claim.right)
        known = self.meanings(line.number).keys() | self._base.letters.keys()
        names = [name for name in names_in_claim if name not in known]
        if len(names) != 1 or claim.sign != "=" or is_phrase(names[0]):
            return None
        (name,) = names
        usage = Usage(name, name in inside_angles(claim.left) | inside_angles(claim.right))
        usual = sorted(
            options(usage, self.naming.candidates(self._base), self._base.problem),
            key=lambda option: option.cost,
        )
        for candidate in usual:
            if candidate.nature == "vector":
                continue
            if candidate.kind != "tangent" and (candidate.start or candidate.cost > _USUAL):
                continue
            self._meant[name] = candidate.quantity
            for reading in link.readings:
                for world in worlds:
                    grade = self.accuracy(reading, world, line, link) or self._loosely(
                        reading, world, line, link
                    )
                    if grade is not None:
                        return reading, grade, (name, candidate.quantity)
            del self._meant[name]
        return None

    def _consistent(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A line that holds where the altered law of a mistake above stands, and all else is true.

        One that is an instance of an altered law itself is no consequence.
        """
        if not self._names or not self._explained:
            return None
        entry = replace(self._entry_of(line, link, link.readings[0]), right=False, wrong=True)
        if (number := self._once_more(entry)) is not None:
            return JudgedLink("follows", link.readings[0], "exact", (number,), REPEATED)
        for other in self.entries:
            if not other.right and is_exchanged_as_well(entry, other, self._base):
                return JudgedLink("follows", entry.claim, "exact", (other.number,), REPEATED)
        uses = [use for use in self.uses_of_entry(entry) if use.altered]
        again = {_family(use.altered) for use in uses if use.altered}
        for number, mistake in self._explained.items():
            if again & {_family(variant.id) for variant in mistake.variants}:
                repeated = repeated_in(mistake.variants, uses)
                if repeated and not self._is_in_another_law(number, uses):
                    self._confirmed.setdefault(number, set()).update(repeated)
                    first = link.readings[0]
                    return JudgedLink("follows", first, "exact", (number,), REPEATED)
                continue
            for variant in mistake.variants[:ALTERED]:
                world = self.altered(variant)
                if world is None:
                    continue
                for claim in link.readings:
                    grade = self.accuracy(claim, world, line, link)
                    if grade is not None:
                        self._confirmed.setdefault(number, set()).add(variant.id)
                        return JudgedLink("follows", claim, grade, (number,))
        return None

    def _is_in_another_law(self, number: int, uses: Sequence[Use]) -> bool:
        """Whether whole speeds stand in another law than in the line above: each is unresolved."""
        if not all(_family(use.altered or "") == "speed-for-component" for use in uses):
            return False
        above = {
            use.principle
            for entry in self.entries
            if entry.number == number
            for use in self.uses_of_entry(entry)
            if use.altered
        }
        return bool(above) and above.isdisjoint(use.principle for use in uses)

    def _once_more(self, entry: Entry) -> int | None:
        """The line above that defines an energy wrongly, where a claim does so in the same way."""
        defined = {
            variant.id: number
            for number, mistake in self._explained.items()
            for variant in mistake.variants
            if not variant.laws and variant.mistake in _OF_ENERGIES
        }
        if not defined or not is_of_energy(entry):
            return None
        again = (variant.id for variant in self.naming.explained(entry, self).variants)
        return next((defined[name] for name in again if name in defined), None)

    def _is_without_support(self, entry: Entry, students: Sequence[World]) -> bool:
        """Whether a true line is what is to be shown, and nothing leads to it.

        That a component stays is a law itself, and needs no other line.
        """
        if any(is_turned_loss(other, self._base) for other in self.entries):
            return False  # behind KE lost = 18 - 27 = -9 it is 9 J that are lost
        if self._is_fudged(entry):
            return True
        if not self._support.is_missing(entry, self.entries, students):
            return False
        uses = self.uses_of_entry(entry) if self._names else ()
        return not uses or any(use.altered or use.principle != "unchanged" for use in uses)

    def _is_fudged(self, entry: Entry) -> bool:
        """Whether a true value stands below his own equation for it, of another: ``e² = -4/9``.

        It may be the value of a true equation above: of ``v cos 40 = 6 cos 55``.
        """
        above = self.entries[-1] if self.entries else None
        if above is None or above.right or above.claim.sign != "=" or not entry.is_value:
            return False
        name = entry.claim.left
        if not isinstance(name, Letter) or names_of(above.claim) != {name.name}:
            return False
        alone = [x for x in self.entries if x.right and names_of(x.claim) == {name.name}]
        return not any(self._support.leads_to(entry, [other]) for other in alone)

    def _is_grounded(self, entry: Entry) -> bool:
        """Whether a true line follows from true lines and laws that are not broken, or is a law.

        An equation that is a law, though a mistake above may stand in its place, needs no other,
        nor does the speed of a body of which a line above gives the component as large, nor a
        deflection with the tangents of which it comes: δ = tan⁻¹(9/2) − tan⁻¹(3/4).
        """
        firm = [other for other in self.entries if other.number not in self._groundless]
        if self._support.is_grounded(entry, firm, self._forgone()):
            return True
        if self._is_known_component(entry, firm) or is_difference_of_tangents(entry.claim):
            return True
        uses = () if entry.is_value else self.uses_of_entry(entry)[:1]
        return any(use.altered is None and use.principle in _OF_SPHERES for use in uses)

    def _is_known_component(self, entry: Entry, above: Sequence[Entry]) -> bool:
        """Whether a speed has the value of a component of the same velocity, given above."""
        speed = meant_by(entry)
        if not isinstance(speed, Quantity) or speed.kind != "speed":
            return False
        velocity = replace(speed, kind="velocity")
        return any(
            other.right
            and other.claim.right == entry.claim.right
            and is_component(own := unsigned(meant_by(other)))
            and own.arguments[0] == velocity
            for other in above
        )

    def _impossible(self, claim: Claim) -> str | None:
        """The remark on a coefficient, a sine or a cosine that cannot have its value."""
        left = claim.left
        if claim.sign != "=" or not is_numeric(claim.right):
            return None
        try:
            value = self._base.scalar(claim.right)
        except UnvaluedError:
            return None
        if is_function(left, "sin", "cos"):
            return IMPOSSIBLE_ANGLE if np.any(np.abs(value) > 1 + OWN_ROUNDING) else None
        if isinstance(left, Letter) and COEFFICIENT.fullmatch(left.name):
            outside = (value > 1 + OWN_ROUNDING) | (value < -OWN_ROUNDING)
            return IMPOSSIBLE_COEFFICIENT if np.any(outside) else None
        return None

    # --- inequalities -------------------------------------------------------------------------

    def _bounded(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """An inequality that comes from his own value and a condition on it."""
        bounds = self.question.bounds
        for claim in link.readings:
            if claim.sign == "=":
                continue
            entry = self._entry_of(line, link, claim)
            conditions = list(conditions_of(bounds.given, self._letters_worth(line)))
            conditions += [
                claim
                for claim in bounds.given
                if not any(map(has_quantity, (claim.left, claim.right)))
            ]
            known = {name: float(x.flat[0]) for name, x in self._base.letters.items()}
            entries = [entry for entry in self.entries if entry.number <= line.number]
            source = bounded_by(entry, entries, conditions, known, bounds.coefficients)
            if source is None:
                source = rearranged_from(entry, entries, known, bounds.coefficients)
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


def _quantities_of(claim: Claim) -> frozenset[Quantity]:
    """The quantities of a story that a claim names."""
    return frozenset(x for side in (claim.left, claim.right) for x in quantities_in(side))


def _are_parallel(one: Vector, other: Vector) -> bool:
    return bool(abs(one.x * other.y - one.y * other.x) <= OWN_ROUNDING * abs(one.dot(other)))


def _family(variant: str) -> str:
    """The misconception of which an altered law is a variant."""
    return variant.partition("/")[0]
