"""The lines of a script judged one after another, under one meaning of its letters.

A line is true if one reading of it holds in one admissible solution. After a first false line it is
judged in the student's own world as well. The truth of a line never depends on the lines above.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import chain

import numpy as np

from restitution.errors import RestitutionError
from restitution.explaining.mistakes.misconceptions import MISCONCEPTIONS
from restitution.expression.evaluate import Angle
from restitution.expression.tree import (
    STRAIGHT_ANGLE,
    Apply,
    Binary,
    Expression,
    Letter,
    Name,
    Negate,
    Quantity,
    is_binary,
    letters,
)
from restitution.practice.judgement import JudgedLine, Mistake, Use, Verdict
from restitution.practice.judging.alike_readings import in_one_reading
from restitution.practice.judging.angles import is_sum_of_angles, unnamed_in
from restitution.practice.judging.certain_letters import is_root_of_a_sum
from restitution.practice.judging.deciding import decided
from restitution.practice.judging.entries import (
    Entry,
    Meanings,
    is_monomial,
    is_numeric,
)
from restitution.practice.judging.explained import Explained, signs_alone
from restitution.practice.judging.extremes import speaks_of_any_value
from restitution.practice.judging.following import COEFFICIENT, NAMED
from restitution.practice.judging.judged_link import (
    COARSE,
    GRADES,
    JudgedLink,
    Question,
    as_decided,
    goes_on,
)
from restitution.practice.judging.listed import as_components
from restitution.practice.judging.other_forms import (
    is_to_a_line,
    kind_of,
    label_in,
    of_natures,
    of_vectors,
    without_divisors,
)
from restitution.practice.judging.own_values import Naming
from restitution.practice.judging.plain_laws import cannot_be
from restitution.practice.judging.support import Support
from restitution.practice.judging.supposing import (
    answer_in,
    cases_in,
    changes_of_sizes,
    speaks_of_an_extreme,
    supposed_in,
)
from restitution.practice.judging.typed_energies import is_halved, is_loss_of_known
from restitution.practice.judging.unlabelled import Unlabelled, followed
from restitution.practice.judging.uses import (
    as_labelled,
    is_bare_value,
    is_e_times,
    of_mistake,
    with_variants,
)
from restitution.practice.letters.candidates import suffix
from restitution.practice.reading.lines import lines_of_letters, read_as
from restitution.practice.reading.phrase_names import is_phrase, names_time, tells_after
from restitution.practice.reading.quoted import beyond_formula, has_data, is_of_impulse, is_quoted
from restitution.practice.script import Claim, Link, Script, ScriptLine
from restitution.practice.worlds.agreement import agrees
from restitution.practice.worlds.world import World
from restitution.problem import Impact

_WORST: tuple[Verdict, ...] = ("false", "unread", "asks", "unsupported", "follows", "true")
# A cosine below this, turned, is that of an obtuse angle whatever the rounding.
_OBTUSE = 1e-6
_SAME_RATIO = 1e-9


class Judge(Unlabelled):
    """Judges a script under one meaning of its letters."""

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
        self.unknown: set[str] = set()
        self._lines_of: Mapping[str, set[int]] = {}

    # --- a script ---------------------------------------------------------------------------------

    def judged(
        self, script: Script, idle: Callable[[Sequence[JudgedLine]], bool] | None = None
    ) -> tuple[JudgedLine, ...]:
        """Every line with its verdict; none where ``idle`` says of the first lines that all is in
        vain.
        """
        self._base = self._likeliest(script)
        self._take_acute(script)
        question = self.question
        self._support = Support(self._base, question.wanted, question.unknown, question.given)
        self._lines_of = lines_of_letters(script)
        lines: list[JudgedLine] = []
        for line in script.lines:
            lines.append(self._judged(line))
            self._event_above = line.scope.event
            if idle is not None and idle(lines):
                return ()
        named = tuple(self._named(line) for line in lines)
        return self._with_end_in_numbers(named) if self._names else named

    def _with_end_in_numbers(self, lines: tuple[JudgedLine, ...]) -> tuple[JudgedLine, ...]:
        """The lines, of which the numbers at the end are false if their mistake has a name."""
        for line, link, last in self._ends_in_numbers(lines):
            entry = self._entry(line, link, JudgedLink("false", link.readings[0]))
            explained = self.naming.explained(entry, self)
            if self.naming.named(explained, self.stated(), frozenset()).kind != "misconception":
                continue
            self._explain(line.number, explained)
            claimed = replace(line, kind="relations", links=(link,), values=())
            false = self._named(JudgedLine(claimed, "false", link=0))
            if false.mistake is not None and false.mistake.id is not None:
                return followed(lines, false, last)
        return lines

    def _named(self, line: JudgedLine) -> JudgedLine:
        """A false line with the name of its mistake, in the light of all lines."""
        if line.verdict != "false":
            return line
        explained = self._explained.get(line.line.number)
        if explained is None:
            return replace(line, mistake=Mistake(None))
        confirmed = frozenset(self._confirmed.get(line.line.number, ()))
        mistake = self.naming.named(explained, self.stated(), confirmed)
        mistake = decided(mistake, explained.variants, line.line.number, self)
        if mistake.kind == "misconception" and not mistake.variants:
            named = MISCONCEPTIONS.get(mistake.id or "")
            if named is not None and explained.of_impulse:
                impulse = Use("impulse", None, (), f"{mistake.id}/1")
                return replace(line, mistake=mistake, uses=(impulse,))
            if mistake.id == "restitution-omitted":
                law = Use("restitution", None, (), f"{mistake.id}/1")
                return replace(line, mistake=mistake, uses=(law,))
            if named is not None and named.mark_of("energy"):
                energy = Use("energy", None, (), f"{mistake.id}/1")
                return replace(line, mistake=mistake, uses=(energy,))
        idle = all(use.principle == "arithmetic" for use in line.uses)
        uses = (explained.near or line.uses) if idle else line.uses
        if mistake.variants and not any(use.altered in mistake.variants for use in uses):
            uses = with_variants(uses, explained.variants, mistake)
        if mistake.kind == "misconception" and explained.is_by_itself(mistake):
            uses = tuple(use if use.altered is None else of_mistake(mistake, use) for use in uses)
        if mistake.id == "energy-fraction-of-line" and all(x.principle != "energy" for x in uses):
            uses = (Use("energy", None, (), f"{mistake.id}/1"), *uses)
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
        """Takes another angle for a letter that means one to a line, if more is true so.

        A line has two directions, and students measure from either, and in either sense.
        """
        for name in {name for known in self._meanings.values() for name in known}:
            tree = next(known[name] for known in self._meanings.values() if name in known)
            if not is_to_a_line(tree):
                continue
            most, own = self._held(script, name), self._meanings
            best = own
            for other in self._other_angles(tree):
                self._meanings = {
                    number: {**known, name: other} if known.get(name) == tree else known
                    for number, known in own.items()
                }
                true = self._held(script, name)
                # Nobody takes an angle as negative in one line, and as positive in another.
                if true > most if isinstance(other, Negate) else len(true) > len(most):
                    most, best = true, self._meanings
            self._meanings = best

    def _other_angles(self, tree: Expression) -> Iterator[Expression]:
        """The acute angle for an obtuse one, and angles in the other sense."""
        if self._is_obtuse(tree):
            yield Binary("-", STRAIGHT_ANGLE, tree)
            yield Binary("-", tree, STRAIGHT_ANGLE)
        yield Negate(tree)

    def _is_obtuse(self, tree: Expression) -> bool:
        try:
            value = self._base.value(tree)
        except RestitutionError:
            return False
        return isinstance(value, Angle) and bool(np.all(np.cos(value.measure()) < -_OBTUSE))

    def _held(self, script: Script, name: str) -> frozenset[tuple[int, int]]:
        """Which relations with a letter are true, by their lines and places."""
        return frozenset(
            (line.number, place)
            for line in script.lines
            for place, link in enumerate(line.links)
            if name in letters(link.readings[0].left) | letters(link.readings[0].right)
            and self._holds(link, line, self.worlds) is not None
        )

    def _judged(self, line: ScriptLine) -> JudgedLine:
        if line.kind == "unread":
            return JudgedLine(line, "unread")
        if line.kind == "remark" and len(line.values) == 2:
            worlds = (self._base, *(self.students() if self.wrong else ()))
            line = as_components(line, worlds, self.meanings(line.number))
        line = self._with_supposed_answer(line)
        if line.kind in ("remark", "heading", "crossed") or not line.links:
            seen = dict.fromkeys(self._seen(line))
            self._stated.update((use.principle, use.event, use.bodies) for use, _ in seen)
            stating = (use for use, value in seen if self._has_coefficient(value, line))
            return JudgedLine(line, "remark", uses=tuple(dict.fromkeys(stating)))
        line = self._with_sizes(self._with_axes(line))
        links = self._links(line)
        if (equation := self._without_title(line, links)) is not None:
            line, links = equation, links[1:]
        verdict = next(worse for worse in _WORST if any(link.verdict == worse for link in links))
        place = next(k for k, link in enumerate(links) if link.verdict == verdict)
        worst = links[place]
        if verdict == "false" and self._is_only_supposed(line):
            return JudgedLine(line, "remark")
        timed = bool(worst.letters) and all(map(names_time, worst.letters))  # since when?
        if verdict == "asks" and (timed or self._is_of_the_book(line, worst.letters)):
            return JudgedLine(line, "remark")
        if verdict in ("asks", "false") and is_of_impulse(line):
            return JudgedLine(line, "remark")
        if verdict == "false" and self._names and len(self._explained) < NAMED:
            explained = self._explained_in(line, links, place)
            others = (k for k, link in enumerate(links) if link.verdict == "false" and k != place)
            for other in others if len(explained.variants) > 1 else ():
                entry = self._entry(line, line.links[other], links[other])
                explained = explained.shared_with(self.naming.explained(entry, self))
            variants = as_labelled(explained.variants, line.text)
            self._explain(line.number, replace(explained, variants=variants))
        for name in worst.letters:
            self.unknown.add(name)
        accuracies = [link.accuracy for link in links if link.accuracy is not None]
        uses, stated = self._uses(line, links) if self._names else ((), ())
        known = all(self._is_known(link.claim) for link in links)
        if verdict == "true" and (not known or is_e_times(links[0].claim, uses)):
            # A value rests on laws, and states none; nor does what is data alone.
            self._stated |= {
                (use.principle, use.event, use.bodies)
                for use in uses[:1]
                if not (use.altered or is_bare_value(links[0].claim, uses))
                and (use.principle != "unchanged" or self._speaks_of_after(line, links))
            }
        self._remember(line, links)
        return JudgedLine(
            as_decided(line, links),
            verdict,
            accuracy=next((grade for grade in GRADES if grade in accuracies), None)
            if verdict in ("true", "follows")
            else None,
            uses=uses,
            stated=stated,
            read_as=read_as(tuple(link.claim for link in links)),
            link=place if verdict == "false" else None,
            sources=tuple(
                dict.fromkeys(n for link in links for n in link.sources if n != line.number)
            ),
            remark=next((link.remark for link in links if link.remark), None),
            grounded=all(link.grounded for link in links),
            his_own=all(link.grounded or link.his_own for link in links),
            meant={**self._meant, **dict(pair for link in links for pair in link.meant)},
            before=self._uses_before(line, links, place) if verdict == "false" else (),
        )

    def _with_supposed_answer(self, line: ScriptLine) -> ScriptLine:
        """A remark with a true bound behind *when* as an answer, where a range is asked."""
        answer = answer_in(line) if self.question.extreme else None
        if answer is None or self._holds(answer, line, self.worlds) is None:
            return line
        return replace(line, kind="relations", links=(answer,), supposed=())

    def _is_of_the_book(self, line: ScriptLine, unknown: frozenset[str]) -> bool:
        """Whether a line only quotes a formula, ``I = m(v - u)``, of which some letters are idle.

        Those are of unknown meaning, and no other line has them.
        """
        own = {name: self._lines_of[name] for name in unknown if name in self._lines_of}
        alone = bool(own) and all(numbers == {line.number} for numbers in own.values())
        return alone and not has_data(line)

    def _speaks_of_after(self, line: ScriptLine, links: Sequence[JudgedLink]) -> bool:
        """Whether a line does more than work out a component, ``along: (12 - 15)/5``, of before."""
        label = label_in(line.links[0].readings[0].left)
        worked = is_numeric(links[0].claim.right)
        return not worked or label is None or tells_after(label.name, self._base.problem)

    def _is_only_supposed(self, line: ScriptLine) -> bool:
        """Whether a line tells what holds under a condition, or at most, and claims nothing."""
        if speaks_of_an_extreme(line) and not self.question.extreme:
            return True
        unequal = any(claim.sign != "=" for claim in line.supposed)
        cases = [link for link in line.links if link.supposed and not self._misquoted(line, link)]
        if any(self._supposing(line, case) == () for case in cases):
            return True
        worlds = self._supposing(line)
        return worlds == () or (unequal and worlds is not None)

    def _supposing(self, line: ScriptLine, link: Link | None = None) -> tuple[World, ...] | None:
        supposed = link.supposed if link is not None and link.supposed else line.supposed
        meanings = self.meanings(line.number)
        return supposed_in(supposed, line, self._base, meanings, self.question.unknown)

    def _under_condition(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A relation that holds where the equation behind its *if* or *when* does."""
        worlds = self._supposing(line, link)
        held = self._holds(link, line, worlds) if worlds else None
        return None if held is None else JudgedLink("true", held[1], held[0])

    def _at_an_extreme(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """An equation that holds where what is asked is greatest or least: ``5 - 30t² = 0``."""
        equal = all(claim.sign == "=" for claim in link.readings)
        worlds = self.question.at_extremes if equal else ()
        held = self._holds(link, line, worlds) if worlds else None
        if held is None or speaks_of_any_value(held[1], self._base, worlds):
            return None
        return JudgedLink("true", held[1], held[0])

    def _becoming(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A component that changes its size, or a vector: ``4 becomes 2``."""
        claim = link.readings[0]
        if next(changes_of_sizes(claim, line, self._base), None) is None:
            return None
        true: Iterator[tuple[Verdict, World]] = (("true", world) for world in self.worlds)
        own: Iterator[tuple[Verdict, World]] = (
            ("follows", world) for world in (self.students() if self.wrong else ())
        )
        wrong: JudgedLink | None = None
        for verdict, world in chain(true, own):
            for *pair, stated in changes_of_sizes(claim, line, world):
                first, second = (self.accuracy(claim, world, line, link) for claim in pair)
                if first is not None and second is not None:
                    return JudgedLink(verdict, stated, second)
                if first is not None and stated != claim:
                    wrong = wrong or JudgedLink("false", stated)
        return wrong

    def _explained_in(self, line: ScriptLine, links: Sequence[JudgedLink], place: int) -> Explained:
        """What explains a link that is false, also as one of what its chain begins with.

        In ``I = m(v - u) = 2(5 - 3)`` the formula is quoted, and I has the wrong value.
        """
        entry = self._entry(line, line.links[place], links[place])
        beside = [
            self._entry(line, link, judged)
            for link, judged in zip(line.links, links, strict=True)
            if judged.verdict == "true"
        ]
        if is_loss_of_known(entry, [*self.entries, *beside]):
            return Explained(slip="arithmetic", near=(Use("energy"),))
        explained = self.naming.explained(entry, self)
        if (other := self._explained_otherwise(entry, explained, beside[:place])) is not None:
            return other
        start = end = place
        while start and goes_on(links[start - 1], links[start]):
            start -= 1
        while end + 1 < len(links) and links[end].claim.right == links[end + 1].claim.left:
            end += 1
        first = links[start].claim.left
        worked = is_numeric(entry.claim.left) and is_numeric(entry.claim.right)
        worked = worked or self._is_worked_out(entry)
        if start == end or worked or not isinstance(first, Letter | Quantity):
            return explained
        plain = is_sum_of_angles(entry) or is_root_of_a_sum(links[place].claim.right)
        shown = start == place and (explained.plain or "").startswith(("energy", "mass"))
        quoted = (not explained.variants or start < place) and not (plain or shown)
        halved = is_halved(entry, self._base)
        for link in links[place : end + 1] if quoted else ():
            whole = replace(entry, claim=replace(entry.claim, left=first, right=link.claim.right))
            other = signs_alone(self.naming.explained(whole, self), explained)
            if halved:
                other = other.without("energy-no-half")
            if any(not cannot_be(variant, entry, self._base) for variant in other.variants):
                return other
        return explained

    def _is_worked_out(self, entry: Entry) -> bool:
        """Whether a claim adds up terms with the same letters: ``½mu² - ⅙mu² = ¼mu²``.

        What is false there is the sum, whatever value comes out.
        """
        left, right = entry.claim.left, entry.claim.right
        own = letters(left) | letters(right)
        if letters(left) != letters(right) or own & self.question.unknown or not own:
            return False
        if not own <= self._base.letters.keys() or not is_monomial(right):
            return False
        try:
            ratio = self._base.scalar(left) / self._base.scalar(right)
        except (RestitutionError, ZeroDivisionError):
            return False
        return is_binary(left, "+", "-") and bool(np.ptp(ratio) < _SAME_RATIO)

    def _explain(self, number: int, explained: Explained) -> None:
        """Keep what explains a false line; altered laws of which two lines are instances stand."""
        for other, earlier in self._explained.items():
            same = {variant.id for variant in earlier.variants} & {
                variant.id for variant in explained.variants
            }
            for line in (other, number) if same else ():
                self._confirmed.setdefault(line, set()).update(same)
        self._explained[number] = explained

    def _has_coefficient(self, value: Expression, line: ScriptLine) -> bool:
        """Whether a value is written with e: ``12e``."""
        meanings = self.meanings(line.number)
        return any(
            COEFFICIENT.fullmatch(name)
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

    # --- a link -----------------------------------------------------------------------------------

    def _links(self, line: ScriptLine) -> list[JudgedLink]:
        """The links of a line with their verdicts; one may follow from those before it."""
        judged: list[JudgedLink] = []
        known = len(self.entries)
        for link in line.links:
            judged_link = self._link(line, link)
            if (
                judged_link.verdict in ("unread", "false")
                and judged
                and self._is_of_unlike(line, link)
            ):
                judged_link = self._from_start(line, link, judged) or judged_link
            alike = in_one_reading(line, judged, judged_link)
            if alike is not None and self._link(line, alike[1]).verdict != "true":
                judged[-1] = self._link(line, alike[0])  # in v = 2 ÷ 1/2 = 4 it is v that is 4
            judged.append(judged_link)
            numeric = is_numeric(judged_link.claim.left) and is_numeric(judged_link.claim.right)
            if judged_link.verdict in ("false", "follows") and not numeric:
                self.entries.append(self._entry(line, link, judged_link))
        if len(self.entries) > known:
            del self.entries[known:]
            self._own = -1, ()
        judged = self._beyond_formulas(line, judged)
        return self._in_a_case(line, judged) or judged

    def _beyond_formulas(self, line: ScriptLine, judged: list[JudgedLink]) -> list[JudgedLink]:
        """The links of a chain, those to and from a formula by what the formula is the worth of.

        In ``I = mv - mu = 0.5(5.2 + 6.9)`` the middle is quoted: its letters are those of the
        book, whatever the student calls by them.
        """
        known = self._base.letters.keys()
        for place in range(len(judged) - 1):
            before, behind = line.links[place : place + 2]
            verdicts = {link.verdict for link in judged[place : place + 2]}
            if verdicts <= {"true", "follows"} or not is_quoted(before, behind, known):
                continue
            other = self._link(line, beyond_formula(before, behind))
            of_mass = bool(letters(before.readings[0].right) & {"m", "M"})
            sound = other.verdict in ("true", "follows")
            if "false" not in verdicts or (of_mass and sound):
                judged[place] = judged[place + 1] = other
        return judged

    def _in_a_case(self, line: ScriptLine, judged: Sequence[JudgedLink]) -> list[JudgedLink] | None:
        """The links of ``e = 0, v = u/2`` where what e is, is left open: cases, and what holds."""
        if len(judged) < 2 or speaks_of_an_extreme(line):
            return None
        opening = [
            self._letter_of_case(link.claim) if link.verdict == "false" else None for link in judged
        ]
        held: dict[int, JudgedLink] = {}
        for place, inside in cases_in(opening, line):
            case = judged[place].claim
            meanings = self.meanings(line.number)
            worlds = supposed_in((case,), line, self._base, meanings, self.question.unknown) or ()
            held[place] = JudgedLink("true", case, "exact")
            for number in inside:
                if (holding := self._holds(line.links[number], line, worlds)) is not None:
                    held[number] = JudgedLink("true", holding[1], holding[0])
        return [held[place] for place in sorted(held)] if len(held) == len(judged) else None

    def _letter_of_case(self, claim: Claim) -> str | None:
        """The letter of the statement, not asked for, to which a claim gives a number at will."""
        match claim:
            case Claim(Letter(name), "=", value, ()) if is_numeric(value):
                own = self._base.letters.get(name)
            case _:
                return None
        asked = any(tree == Letter(name) for tree, _ in self.question.wanted.asked)
        if own is None or (asked and name in self._base.determined):
            return None
        return name if np.ptp(self._base.spread(own)) > 0 else None

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
        while start and goes_on(before[start - 1], before[start]):
            start -= 1
        first = before[start].claim.left
        if not isinstance(first, Letter | Quantity):
            return None
        readings = tuple(dict.fromkeys(replace(reading, left=first) for reading in link.readings))
        other = self._link(line, replace(link, readings=readings))
        return None if other.verdict in ("unread", "false") else other

    def _misquoted(self, line: ScriptLine, link: Link) -> JudgedLink | None:
        """A case that is none, as the question gives the letter another value: ``e = 1/3: …``."""
        for claim in link.supposed:
            match claim:
                case Claim(Letter(name), "=", value, ()) if (
                    is_numeric(value) and name in self.question.given
                ):
                    if agrees(claim, self._base, self.meanings(line.number), ()) is None:
                        return JudgedLink("false", claim)
        return None

    def _link(self, line: ScriptLine, link: Link) -> JudgedLink:
        misquoted = self._misquoted(line, link) if link.supposed else None
        if misquoted is not None:
            return misquoted
        held = self._holds(link, line, self.worlds)
        if held is not None:
            if (later := self._at_a_later_moment(line, link)) is not None:
                return later
            then = self._at_event_of_heading(line, link)
            accuracy, claim = held if then is None else (then.accuracy or held[0], then.claim)
            if claim.sign != "=" and claim != link.readings[0] and self.wrong:
                # An inequality may be true by chance, in a reading that nobody means.
                plainly = self._bounded(line, replace(link, readings=link.readings[:1]))
                if plainly is not None:
                    return plainly
            remark = COARSE if accuracy == "coarse" else None
            verdict: Verdict = "true"
            entry = self._entry_of(line, link, claim)
            students = self.students() if self.wrong else ()
            if len(line.links) == 1 and self._is_without_support(entry, students):
                verdict = "unsupported"
            grounded = self._is_grounded(entry)
            his_own = False
            if not grounded:
                self._groundless.add(line.number)
                his_own = bool(students) and self._holds(link, line, students) is not None
            meant = () if then is None else then.meant
            return JudgedLink(
                verdict,
                claim,
                accuracy,
                remark=remark,
                grounded=grounded,
                his_own=his_own,
                meant=meant,
            )
        return (
            self._root(line, link)
            or (self._in_own_worlds(line, link) if self._is_of_asked_angle(line, link) else None)
            or self._relabelled(line, link, self.worlds, "true")
            or self._at_event_of_heading(line, link)
            or self._of_unnamed_angle(line, link, self.worlds, "true")
            or self._of_other_root(line, link)
            or self._nearly(line, link)
            or self._in_units(line, link, self.worlds, "true")
            or self._by_vectors(line, link, self.worlds, "true")
            or self._in_other_sense(line, link)
            or self._under_condition(line, link)
            or self._at_an_extreme(line, link)
            or self._adopted_at_an_extreme(line, link)
            or self._becoming(line, link)
            or self._by_rounded_equation(line, link)
            or self._by_rounded_lines(line, link)
            or self._at_another_time(line, link)
            or self._following(line, link)
            or self._mistimed(line, link)
            or self._refused(line, link)
        )

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
        forms = (
            x
            for reading in link.readings
            for x in (
                reading,
                *of_natures(reading, named),
                *of_vectors(reading, meanings, self._base),
                *without_divisors(reading, meanings, self._base),
            )
        )
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
                elif (
                    isinstance(claim.left, Letter)
                    and is_phrase(claim.left.name)
                    and names_time(claim.left.name)
                ):
                    missing.add(claim.left.name)  # since when it counts, nobody knows
                elif not missing:
                    own = self._in_unit_of_vector(claim, line)
                    there = self._at_heading(own, line)
                    if there.left == own.left or not isinstance(own.left, Letter):
                        return JudgedLink("false", there)
                    return JudgedLink("false", there, meant=((own.left.name, there.left),))
        first = link.readings[0]
        if missing:
            return JudgedLink("asks", first, letters=frozenset(missing))
        return JudgedLink("unread", first, remark=fault)
