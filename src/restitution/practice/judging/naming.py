"""The name of a mistake: which altered law a false line is an instance of, or which slip it is.

A misconception is named where random states single out one altered law, or, where numbers are put
in already, where the line holds in one altered world and no slip explains it as well. In doubt a
mistake has no name.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import cached_property
from itertools import permutations

from restitution.explaining.data.arrangement import events_of
from restitution.explaining.mistakes.misconceptions import (
    VariantAt,
    variants_at,
)
from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Binary,
    Degrees,
    Expression,
    Letter,
    Number,
    Quantity,
    is_function,
    is_vector,
    letters,
    unsigned,
    walk,
)
from restitution.practice.judgement import Mistake, Use
from restitution.practice.judging.altered_laws import (
    contradicts,
    family_beside,
    family_of,
    is_stated,
    kinds_of,
    replaces,
)
from restitution.practice.judging.angles import adds_two_angles, is_sum_of_angles
from restitution.practice.judging.certain_letters import is_root_of_a_sum
from restitution.practice.judging.claimed import has_value, holds_in
from restitution.practice.judging.coefficients import with_its_coefficient
from restitution.practice.judging.entries import Entry, is_numeric, is_of_a_journey
from restitution.practice.judging.exchanged_components import (
    is_kept_by_sines,
    is_sine_for_cosine,
    is_speed_in_other_ratio,
)
from restitution.practice.judging.explained import Explained, JudgedSoFar, Stated
from restitution.practice.judging.mending import kind_of_slip, mending, worked_out
from restitution.practice.judging.more_usual import more_usual_than
from restitution.practice.judging.named_results import (
    is_deflection,
    is_impulse,
    is_loss,
    is_result,
    is_worked_angle,
)
from restitution.practice.judging.other_forms import kind_of
from restitution.practice.judging.partial_energies import (
    adds_known_numbers,
    of_a_part,
)
from restitution.practice.judging.plain_deflections import (
    is_deflection_as_angle,
    is_given_deflection,
)
from restitution.practice.judging.plain_energies import has_half_in_all, is_turned_loss
from restitution.practice.judging.plain_impulses import of_given_impulse
from restitution.practice.judging.plain_laws import cannot_be
from restitution.practice.judging.plain_mistakes import (
    has_coefficient,
    is_coefficient,
    is_direct,
    is_energetic,
    is_law_of_speeds,
    is_momentum_of_speeds,
    is_of_energy,
    is_sought_angle,
    is_speed_by_energies,
    is_whole_speed,
    is_zero,
    leaves_out_across,
    not_negative,
    plainly,
    sign_of_a_component,
)
from restitution.practice.judging.signs import (
    OF_SIGNS,
    is_inverse_of_the_opposite,
    is_opposite_impulse,
    is_slip_of_sign,
    is_turned_as_a_whole,
    plainer_signs,
)
from restitution.practice.judging.sizes import numbers_in, varying_size
from restitution.practice.judging.slips import Correction, in_datum
from restitution.practice.judging.solved_values import (
    goes_on_from_true_line,
    has_kept_across,
    is_along_alone,
    is_decided,
    is_over,
    of_this_part,
)
from restitution.practice.judging.squares import is_worth
from restitution.practice.judging.typed_energies import are_energies, is_halved, is_what_is_left
from restitution.practice.judging.written_laws import (
    has_terms_of_other_sizes,
    is_written_momentum,
    leaves_out_one_mass,
)
from restitution.practice.letters.candidates import Candidate, candidates
from restitution.practice.reading.lines import text_of
from restitution.practice.reading.phrase_names import is_phrase, is_relative
from restitution.practice.worlds.agreement import numbers_of
from restitution.practice.worlds.arrays import Array
from restitution.practice.worlds.student import altered_world
from restitution.practice.worlds.world import World
from restitution.problem import Compare, Given, Problem

# A sign that is turned undoes these, and so is no slip beside them.
_OF_SIGNS = frozenset(
    {"momentum-sign", "restitution-sign", "impulse-sign", "deflection-difference"}
)
_OF_SPEEDS = frozenset({"restitution-whole-speed", "speed-for-component", "impulse-of-speeds"})
# Where a speed is the size of a component, these are what they are called.
_PLAINER = frozenset({"momentum-sign", "restitution-sign", "impulse-sign", "restitution-inverted"})
_OF_DEFLECTION = frozenset({"deflection-is-after", "deflection-difference"})
_OF_ANGLES = frozenset({"sine-cosine", "angle-from-normal"})
_OF_POWERS = frozenset({"square-not-taken", "energy-ratio-as-speed"})
_OF_FACTORS = frozenset({"mass-omitted", "restitution-omitted", "energy-no-half", "across-changed"})
_OF_A_KEPT_SIZE = frozenset({"restitution-omitted", "restitution-parallel"})
_OF_ACROSS = frozenset({"across-changed", "across-exchanged"})
_WITHOUT_COEFFICIENT = frozenset({"energy-conserved", "restitution-omitted"})
_LAWS = frozenset({"momentum", "restitution", "unchanged", "impulse", "energy", "deflection"})
_OF_ENERGY = frozenset({"energy", "speed", "fact", "fraction"})
_TRIED = 6
NO_NAME = Mistake(None)


class Names:
    """Names the mistakes in the lines of one problem."""

    def __init__(self, problem: Problem) -> None:
        self._altered: dict[tuple[str, int, int, frozenset[str]], World | None] = {}
        self.problem = problem
        events = events_of(problem)
        self.variants = tuple(variant for event in events for variant in variants_at(event, events))
        self._familiar: dict[int, tuple[float, ...]] = {}
        self._varying: dict[int, tuple[Array, ...]] = {}

    def explained(self, entry: Entry, judge: JudgedSoFar) -> Explained:
        """What explains a claim that is false."""
        mended = tuple(mending(entry, judge))
        parts = {text_of(correction.part) for correction in mended}
        at = parts.pop() if len(parts) == 1 else None  # else it is not certain where
        exchanged = is_speed_in_other_ratio(entry, judge.base)
        whole = not exchanged and is_whole_speed(entry, judge.base)
        squares = any(map(is_root_of_a_sum, walk(entry.claim.right)))
        squares = squares and not is_coefficient(entry)  # e may be taken for a ratio of speeds
        law = not squares and is_law_of_speeds(entry, judge.base)
        unresolved = not self._is_of_impulse(entry, judge.base) and is_momentum_of_speeds(
            entry, judge.base
        )
        of_deflection = is_deflection_as_angle(entry, judge.base)
        of_deflection = of_deflection or is_given_deflection(entry, judge.base)
        alone = whole or law or of_deflection or is_sought_angle(entry, judge.base)
        alone = alone or is_turned_loss(entry, judge.base)
        of_part = of_a_part(entry, judge.base)
        alone = alone or of_part is not None
        variants = () if alone else self._explaining(entry, judge, mended)
        variants = tuple(v for v in variants if not cannot_be(v, entry, judge.base))
        slip = kind_of_slip(entry, judge, mended)
        worlds = (judge.base, *judge.students()) if variants or slip == "sign" else ()
        unlike = bool(worlds) and all(has_terms_of_other_sizes(entry, x) for x in worlds)
        if unlike:
            variants = tuple(x for x in variants if x.mistake != "momentum-sign")
        of_signs = {variant.mistake for variant in variants} - _OF_SPEEDS
        at_wall = any(variant.event.wall for variant in variants)  # there a sign is the law
        if (
            of_signs
            and of_signs <= OF_SIGNS
            and not (at_wall or self._is_of_impulse(entry, judge.base))
        ):
            variants = () if is_slip_of_sign(entry, mended, judge.base) else variants
        if of_signs == {"momentum-sign"} and is_turned_as_a_whole(entry, mended):
            variants = ()  # 4(v - j) = -4i + 8j: which impulse it is of, is not said
        if is_halved(entry, judge.base):
            variants = tuple(variant for variant in variants if variant.mistake != "energy-no-half")
        if unresolved:
            # Where the law with speeds explains it as well, it tells of the letters.
            variants = tuple(
                variant for variant in variants if variant.mistake == "speed-for-component"
            )
        plainer = whole or law or (unresolved and not variants)
        if slip == "arithmetic" and is_sum_of_angles(entry) and not is_deflection(entry):
            slip = None  # which angles they are is wrong, and not their sum
        if is_inverse_of_the_opposite(entry, judge.entries):
            return Explained(slip="sign", at=at)
        uses = judge.uses_of_entry(entry)
        idle = all(use.principle == "arithmetic" for use in uses)
        nearest, near = _near(entry, judge, mended) if idle or slip else (None, ())
        # One figure for another may make any equation true.
        sure = nearest is not None and nearest.change != "figure"
        claim = (nearest.claim, near) if nearest is not None and sure else None
        if slip == "arithmetic":
            claim = worked_out(entry, judge, mended) or claim
        plain = plainly(entry, judge.base, judge.entries, mended)
        if plain == "restitution-inverted" and _is_solved_wrongly(entry, judge):
            plain = None
        if plain == "sine-cosine" and is_worked_angle(entry) and slip == "sign":
            plain = None  # cos δ = (8 + 16)/(√20√32), which is sin δ by chance
        if {variant.mistake for variant in variants} == _OF_A_KEPT_SIZE:
            omitted = tuple(v for v in variants if v.mistake == "restitution-omitted")
            variants = omitted if has_kept_across(variants[0].event.number, judge) else variants
        families = {variant.mistake for variant in variants}
        if len(families) > 1 and plain in families and "across-exchanged" not in families:
            # What the line shows by itself decides between laws that give one value.
            variants = tuple(variant for variant in variants if variant.mistake == plain)
        if families == _OF_DEFLECTION and adds_two_angles(entry.claim.right):
            variants = tuple(v for v in variants if v.mistake == "deflection-difference")
        by_form = ("energy-of-difference", "energy-no-half", "second-wall-angle")
        if plain in by_form and plain not in families:
            variants = ()  # a square of a difference is no energy of one sphere
        if is_numeric(entry.claim.right) and not is_of_a_journey(entry):
            variants = of_this_part(variants, judge.base)
        squared = families == {"deflection-is-after"} and any(x.change == "square" for x in mended)
        kept = is_what_is_left(entry, judge.base)
        if unlike and not variants and leaves_out_one_mass(entry, judge.base):
            plain = "mass-omitted"
        solved = goes_on_from_true_line(entry, judge)
        if squared or kept or solved:
            variants, plain = (), None
        if plain in _OF_SPEEDS and squares:
            plain = None
        if not self._by_states(entry, judge) and is_decided(entry, judge):
            variants, plain = (), None
        if is_coefficient(entry) and families == {"speed-for-component"}:
            variants, plain = (), "restitution-whole-speed"  # the law of no other components
        plain = of_part or (None if variants else plain)
        if plain == "energy-component-missing" and adds_known_numbers(entry, judge.entries):
            plain = None  # which of them is taken away, and which not, is a sign
        if (blown := of_given_impulse(entry, judge.base)) is not None:
            variants, plain = (), blown
        exchanged = exchanged or is_sine_for_cosine(entry, judge.base)
        if families != {"sine-cosine"} and exchanged:
            variants = tuple(variant for variant in variants if variant.mistake in _OF_ANGLES)
            plain = None if variants else "sine-cosine"
        vectors = any(map(is_vector, (entry.claim.left, entry.claim.right)))
        if plain == "impulse-sign" and vectors and not isinstance(entry.claim.left, Letter):
            # A vector has no size of which the sense is lost: a sign is another.
            plain, slip, near = None, "sign", near or (Use("impulse"),)
        if "impulse-sign" in {plain, *families} and is_opposite_impulse(entry, judge.base):
            variants, plain, slip, near = (), None, "sign", (Use("impulse"),)
        if of_deflection:
            plain = "deflection-is-after"
        if plainer:
            plain = "restitution-whole-speed" if law else "speed-for-component"
        if variants and all(_is_of_a_whole_speed(variant, judge.base) for variant in variants):
            variants, plain = (), "speed-for-component"
        if variants and all(leaves_out_across(x, entry, judge.base) for x in variants):
            variants, plain = (), "across-changed"
        if not variants and not plain and slip == "sign" and not (solved or unlike):
            plain = sign_of_a_component(entry, judge.base, mended, near)
            known = letters(entry.claim.right) <= judge.base.letters.keys()
            solved_for = isinstance(entry.claim.left, Letter | Quantity) and known
            if plain is not None and solved_for and is_stated(near[0], judge.stated()):
                plain = None  # what is wrong is a sign in what is put into that law
            left, right = entry.claim.left, entry.claim.right
            within = any(correction.part not in (left, right) for correction in mended)
            within = within and len(judge.base.start) > 1  # of one sphere it is a scalar product
            relative = isinstance(left, Letter) and is_phrase(left.name) and is_relative(left.name)
            if relative and within:
                plain = "restitution-sign"
            if is_sum_of_angles(entry) and is_deflection(entry):
                plain = "deflection-difference"
        signs = any(correction.change == "sign" for correction in mended)
        signs = signs or any(replaces(variant, "restitution") for variant in variants)
        if not (plain or plainer or signs) and not any(use.principle in _LAWS for use in uses):
            corrected = with_its_coefficient(entry, judge.base, judge.uses_of_entry)
            if corrected is not None:
                # The number of a datum is another: of what happens nothing is taken wrongly.
                return Explained(slip="misread", near=corrected[1], mended=corrected)
        alone = {*map(family_of, variants)} <= _OF_ACROSS and is_along_alone(entry)
        direct = all(is_direct(variant.event.number, judge.base) for variant in variants)
        blow = plain == "mass-omitted" and not is_of_energy(entry)
        impulse = blow or blown is not None or is_impulse(entry.claim.left, entry)
        beside = near if idle else ()
        shadowed = {variant.id for variant in variants}
        shadowed -= {variant.id for variant in plainer_signs(variants, entry, judge.base)}
        over = is_of_a_journey(entry) and all(
            is_over(variant.event.number, judge.base) for variant in variants
        )
        return Explained(
            *(variants, slip, at, beside, claim, plain),
            direct=direct,
            of_impulse=impulse,
            along=alone,
            over=over,
            by_sines=is_kept_by_sines(entry, judge.base),
            shadowed=frozenset(shadowed),
        )

    def named(self, explained: Explained, stated: Stated, confirmed: frozenset[str]) -> Mistake:
        """The mistake by its name.

        Of several altered laws those stay that a line below is an instance of too (``confirmed``
        are their ids), and those that contradict no law which is stated rightly.
        """
        every = [own for own in explained.variants if own.id not in explained.shadowed]
        variants = [variant for variant in every if variant.id in confirmed]
        plainer = [variant for variant in every if family_of(variant) in _PLAINER]
        speeds = variants and all(family_of(variant) in _OF_SPEEDS for variant in variants)
        if speeds:
            # What the speeds of a direct impact are taken for has a plainer name.
            variants += plainer
        open_ = bool(speeds and plainer) and not explained.direct
        variants = variants or [variant for variant in every if not contradicts(variant, stated)]
        if not variants and {*map(family_of, every)} == {"restitution-whole-speed"}:
            variants = list(every)  # who has the component may take e × speed as well
        variants.sort(key=lambda variant: 0 if variant.event.wall else len(variant.laws))
        ids = tuple(dict.fromkeys(variant.id for variant in variants))
        families = tuple(dict.fromkeys(family_beside(variant, stated) for variant in variants))
        if not families and explained.plain:
            return Mistake(explained.plain, "misconception", at=explained.at)
        if not families:
            return Mistake(explained.slip, "slip", at=explained.at) if explained.slip else NO_NAME
        if explained.over:
            return Mistake(None, "misconception", ids, at=explained.at, sure=False)
        if explained.along:
            also = (*families, "speed-for-component")
            return Mistake(None, "misconception", ids, also, explained.at, sure=False)
        wall = variants[0].event.wall
        before = {family: more_usual_than(family, wall) for family in families}
        likely = [family for family in families if not set(families) & before[family]]
        name = likely[0] if len(likely) == 1 and not open_ else None
        if name == "angle-from-normal" and any(own.mistake == "sine-cosine" for own in every):
            # That in every line is sine for cosine in each.
            name, families = "sine-cosine", ("sine-cosine", *families)
        if name == "restitution-parallel" and explained.by_sines:
            return Mistake("sine-cosine", "misconception", ids, at=explained.at)
        dull = _OF_SPEEDS if name in _PLAINER else frozenset()
        also = tuple(family for family in families if family != name and family not in dull)
        return Mistake(name, "misconception", ids, also, explained.at, sure=not also)

    def altered(
        self, base: World, variant: VariantAt, unknown: frozenset[str] = frozenset()
    ) -> World | None:
        """The world of an altered law, all else being right."""
        key = variant.id, variant.event.number, base.solution, unknown
        if key not in self._altered:
            self._altered[key] = altered_world(base, variant, unknown)
        return self._altered[key]

    def candidates(self, world: World) -> Sequence[Candidate]:
        """The quantities that a letter may mean."""
        return candidates(self.problem, world.part)

    # --- misconceptions -----------------------------------------------------------------------

    def _explaining(
        self, entry: Entry, judge: JudgedSoFar, mended: Sequence[Correction]
    ) -> tuple[VariantAt, ...]:
        """The altered laws that explain a claim where no slip does."""
        if entry.claim.sign != "=" or entry.claim.others:
            return ()
        by_states = list(self._without_energy(self._by_states(entry, judge), entry, judge.base))
        if self._is_of_impulse(entry, judge.base):
            # 3 = 0.5(4 - 4e): the sign is lost in the change of momentum, not in a law.
            by_states = [state for state in by_states if "impulse" in kinds_of(state)]
        if is_coefficient(entry):
            by_states = [state for state in by_states if replaces(state, "restitution")]
        if is_worked_angle(entry):
            # A sign within a scalar product, or a tangent, is none of a law.
            by_states = [state for state in by_states if state.mistake not in _OF_SIGNS]
        if is_of_energy(entry):
            # The values of two mistakes may be one: a line of energy has a mistake of energy.
            by_states = [state for state in by_states if kinds_of(state) & _OF_ENERGY - {"speed"}]
        if has_half_in_all(entry, judge.base):
            by_states = [state for state in by_states if state.mistake != "energy-no-half"]
        if is_loss(entry):
            # Who works out what is lost does not take all for kept.
            by_states = [state for state in by_states if state.mistake != "energy-conserved"]
        by_states = list(self._of_masses(entry, by_states))
        parallel = {state.mistake for state in by_states} == {"restitution-parallel"}
        if parallel and is_written_momentum(entry, judge.base):
            worlds = self._worlds(entry, judge)
            by_states = [state for state in worlds if replaces(state, "momentum")] or by_states
        quoted = "e" in letters(entry.claim.right)
        known = any(map(has_coefficient, self.problem.events)) or quoted
        if not known and is_speed_by_energies(entry, judge.base):
            # Of a coefficient that is still to be found nobody knows the number.
            by_states = [state for state in by_states if not replaces(state, "restitution")]
        if is_sum_of_angles(entry):
            by_states = [state for state in by_states if kinds_of(state) & ANGLES]
        if (
            by_states
            and _is_bare(entry)
            and any(correction.change == "figure" for correction in mended)
            and not self._is_kept(entry, by_states, mended, judge)
        ):
            # A number alone may be another by its figure, but not twice for one reason.
            return tuple(state for state in by_states if state.id in judge.suspected())
        if by_states:
            if is_function(entry.claim.left, "tan", "cot") and any(
                correction.change == "turned" for correction in mended
            ):
                return ()  # a quotient upside down
            lawful = [(own, law) for own in mended for law in _laws_of(own, entry, judge)]
            return tuple(
                state
                for state in by_states
                if _stands(state, [own for own, law in lawful if replaces(state, law)])
            )
        if is_numeric(entry.claim.left) and is_numeric(entry.claim.right):
            return ()
        blocking = [
            correction for correction in mended if not self._is_familiar(correction, entry, judge)
        ]
        variants = list(self._results(entry, judge)) or list(self._worlds(entry, judge))
        variants = list(self._of_masses(entry, variants))
        if is_loss(entry):
            variants = [state for state in variants if state.mistake != "energy-conserved"]
        if is_worked_angle(entry):
            variants = [state for state in variants if state.mistake not in _OF_SIGNS]
        if is_of_a_journey(entry):
            # A time tells of one component alone: that it is not smaller says all.
            omitted = [state for state in variants if state.mistake == "restitution-omitted"]
            variants = omitted or variants
        if is_coefficient(entry):
            variants = [variant for variant in variants if replaces(variant, "restitution")]
        last = max((variant.event.number for variant in variants), default=0)
        if any(not variant.event.wall for variant in variants):
            # Behind a later wall it is that wall, and not the spheres' impact before it.
            at_walls = [v for v in variants if v.event.wall and v.event.number == last]
            variants = at_walls or variants
        return tuple(dict.fromkeys(variant for variant in variants if _stands(variant, blocking)))

    def _by_states(self, entry: Entry, judge: JudgedSoFar) -> Sequence[VariantAt]:
        """The altered laws of which a claim is an instance by random states."""
        altered = {(use.altered, use.event) for use in judge.uses_of_entry(entry)}
        return [
            variant
            for variant in self.variants
            if not altered.isdisjoint(((variant.id, variant.event.number), (variant.id, None)))
        ]

    def _is_kept(
        self,
        entry: Entry,
        states: Sequence[VariantAt],
        mended: Sequence[Correction],
        judge: JudgedSoFar,
    ) -> bool:
        """Whether a number is that of the speed before a wall, and so no other by its figure."""
        omitted = {state.mistake for state in states} <= _OF_A_KEPT_SIZE
        figures = (x for x in mended if x.change == "figure")
        return omitted and all(self._is_familiar(x, entry, judge) for x in figures)

    def _without_energy(
        self, states: Sequence[VariantAt], entry: Entry, world: World
    ) -> Iterator[VariantAt]:
        """Altered laws, of which a speed kept at a wall by its components leaves e out."""
        squares = any(map(is_root_of_a_sum, walk(entry.claim.right)))
        for state in states:
            kept = state.mistake == "energy-conserved" and state.event.wall
            if not (kept and (squares or is_direct(state.event.number, world))):
                yield state
                continue
            for other in self.variants:
                if other.event == state.event and other.mistake == "restitution-omitted":
                    yield other

    def _is_of_impulse(self, entry: Entry, world: World) -> bool:
        """Whether a side of a claim is an impulse, or one that the question gives."""
        sides = (entry.claim.left, entry.claim.right)
        given = [value for quantity, value in self.given if quantity.kind == "impulse"]
        meant = entry.meanings.get(sides[0].name) if isinstance(sides[0], Letter) else None
        if given and meant is not None and kind_of(meant) == "velocity":
            # The velocity of one body, from its own and the impulse that is given.
            return letters(sides[1]).isdisjoint(entry.meanings)
        if any(is_impulse(side, entry) for side in sides) or any(map(sides.__contains__, given)):
            return True
        impulses = [quantity for quantity, _ in self.given if quantity.kind == "impulse"]
        vectors = [side for side in sides if is_vector(side)]  # (-2, -1) for -2i - j
        return any(has_value(x, side, entry, world) for x in impulses for side in vectors)

    def _of_masses(self, entry: Entry, variants: Sequence[VariantAt]) -> Sequence[VariantAt]:
        """The altered laws of a line: of one with masses in it none of restitution, if others fit.

        So it is with ``4mu - kmu = mu + 2kmu``.
        """
        names = letters(entry.claim.left) | letters(entry.claim.right)
        if self._masses.isdisjoint(names):
            return variants
        kept = [
            variant
            for variant in variants
            if replaces(variant, "momentum") or not replaces(variant, "restitution")
        ]
        return kept or variants

    @cached_property
    def _masses(self) -> frozenset[str]:
        """The letters of masses in the statement."""
        masses = (sphere.mass for sphere in self.problem.spheres)
        return frozenset[str]().union(
            *(letters(mass) for mass in masses if isinstance(mass, Expression))
        )

    @cached_property
    def given(self) -> tuple[tuple[Quantity, Expression], ...]:
        """The quantities that the question gives, with their values."""
        return tuple(
            (one, other)
            for _, step in self.problem.steps()
            if isinstance(step, Given)
            for relation in step.relations
            if isinstance(relation, Compare)
            for one, other in permutations(relation.operands, 2)
            if isinstance(one, Quantity)
        )

    def _results(self, entry: Entry, judge: JudgedSoFar) -> Iterator[VariantAt]:
        """By a result: the claim gives a quantity the value that an altered definition gives it."""
        forms = (entry, *self._with_given(entry))
        for variant in self.variants:
            for result in variant.results:
                for world in (judge.base, *judge.students()):
                    if any(is_result(form, result, world) for form in forms):
                        yield variant

    def _with_given(self, entry: Entry) -> Iterator[Entry]:
        """A claim in which a side that the question gives stands for its quantity, on the left."""
        for one, other in permutations((entry.claim.left, entry.claim.right), 2):
            for quantity, value in self.given:
                if one == value:
                    yield replace(entry, claim=replace(entry.claim, left=quantity, right=other))

    def _worlds(self, entry: Entry, judge: JudgedSoFar) -> Iterator[VariantAt]:
        """By altered worlds: the claim holds where one law is altered, and all else is right."""
        energetic = is_energetic(entry)
        angular, impulsive = is_sum_of_angles(entry), self._is_of_impulse(entry, judge.base)
        of_energy = is_of_energy(entry) or are_energies(entry)
        fitting = _OF_ENERGY - {"speed"} if of_energy else _OF_ENERGY
        names = letters(entry.claim.left) | letters(entry.claim.right)
        with_coefficient = "e" in names and len(judge.base.lines) == 1
        for variant in self.variants:
            if not variant.laws or not variant.alteration.solvable:
                continue
            kinds = kinds_of(variant)
            if angular and not kinds & ANGLES:
                continue
            if impulsive and not ("impulse" in kinds or variant.mistake in _OF_ANGLES):
                continue
            if not (kinds & fitting if energetic else kinds - _OF_ENERGY):
                continue
            if contradicts(variant, judge.stated()):
                continue
            if with_coefficient and variant.mistake in _WITHOUT_COEFFICIENT:
                continue
            if not _plausible(variant, judge.base):
                continue
            world = judge.altered(variant)
            if world is not None and holds_in(entry, world):
                yield variant

    def _is_familiar(self, correction: Correction, entry: Entry, judge: JudgedSoFar) -> bool:
        """Whether a correction changes a figure of a number that the story itself has."""
        if correction.change not in ("figure", "factor"):
            return False
        part = correction.part
        if not isinstance(part, Number | Degrees):
            return correction.change == "factor"
        if self._is_in_a_quantity(part, entry, judge):
            return True
        value = float(part.value)
        if in_datum(part, entry, numbers_of(self.problem)):
            return True
        return any(abs(value - other) <= 0.005 * abs(other) for other in self._values(judge))

    def _is_in_a_quantity(self, part: Expression, entry: Entry, judge: JudgedSoFar) -> bool:
        """Whether a number stands in a term, with letters, that a quantity of the story is worth.

        What is right in a line is not where its slip is.
        """
        terms = [
            node
            for side in (entry.claim.left, entry.claim.right)
            for node in walk(side)
            if node != side and isinstance(node, Binary) and part in walk(node)
        ]
        worth = self._sizes(judge.base) if terms else ()
        return any(is_worth(term, entry, judge.base, worth) for term in terms)

    def _sizes(self, world: World) -> tuple[Array, ...]:
        """The sizes of components, speeds and energies of the story that differ between samples."""
        if world.solution not in self._varying:
            kinds = ("along", "across", "speed", "energy")
            trees = (candidate.quantity for candidate in candidates(self.problem, world.part))
            spreads = [varying_size(x, world) for x in trees if getattr(x, "kind", "") in kinds]
            self._varying[world.solution] = tuple(x for x in spreads if x is not None)
        return self._varying[world.solution]

    def _values(self, judge: JudgedSoFar) -> tuple[float, ...]:
        """The numbers of the story: those of the statement, and its quantities."""
        world = judge.base
        if world.solution not in self._familiar:
            values = [float(value) for value in numbers_of(self.problem)]
            for candidate in candidates(self.problem, world.part):
                own = list(numbers_in(world, candidate.quantity))
                values += own
                if candidate.kind in ("component", "speed"):
                    values += [value**2 for value in own]
            self._familiar[world.solution] = tuple(
                dict.fromkeys(value for value in values if value)
            )
        return self._familiar[world.solution]


def _is_bare(entry: Entry) -> bool:
    """Whether a claim gives a letter one number: ``-v = -5``."""
    one, other = (unsigned(side) for side in (entry.claim.left, entry.claim.right))
    return isinstance(one, Letter | Quantity) and isinstance(other, Number)


def _is_solved_wrongly(entry: Entry, judge: JudgedSoFar) -> bool:
    """Whether a value of a letter stands below a true equation with it, and is solved wrongly."""
    name = entry.claim.left
    return isinstance(name, Letter) and any(
        other.right and name.name in letters(other.claim.left) | letters(other.claim.right)
        for other in judge.entries
        if not other.is_value
    )


def _near(
    entry: Entry, judge: JudgedSoFar, mended: Sequence[Correction]
) -> tuple[Correction | None, tuple[Use, ...]]:
    """The first correction that makes a claim an instance of a law, and what it then uses."""
    best: tuple[Correction | None, tuple[Use, ...]] = None, ()
    for correction in mended[:_TRIED]:
        uses = judge.uses_of_entry(replace(entry, claim=correction.claim, wrong=False, right=True))
        if uses and uses[0].principle in _LAWS:
            return correction, uses
        if uses and (not best[1] or best[1][0].principle == "arithmetic"):
            best = correction, uses
    return best


def _laws_of(correction: Correction, entry: Entry, judge: JudgedSoFar) -> Iterator[str]:
    """The laws of which a corrected claim is an instance, and not true by its numbers alone."""
    whole = correction.part in (entry.claim.left, entry.claim.right)
    if correction.change != "sign" or whole:
        return
    mended = Entry(entry.number, correction.claim, entry.meanings, entry.scope, entry.decimals)
    # Of a law that stands above already a line is no second attempt.
    stated = {(principle, event) for principle, event, _ in judge.stated()}
    for use in judge.uses_of_entry(mended):
        if use.principle in _LAWS and (use.principle, use.event) not in stated:
            yield use.principle


def _stands(variant: VariantAt, mended: Sequence[Correction]) -> bool:
    """Whether no slip explains a line as well as an altered law does."""
    undone = {"square", "radians"} if variant.mistake == "sine-cosine" else {"square"}
    if variant.mistake in _OF_SIGNS | _OF_SPEEDS:
        undone |= {"sign"}
    if variant.mistake in _OF_POWERS | _OF_SIGNS:
        undone |= {"power"}  # no square is missing in a law without squares
    if variant.mistake in _OF_FACTORS:
        undone |= {"factor"}
    if variant.mistake == "restitution-inverted":
        undone |= {"turned"}
    return all(correction.change in undone for correction in mended)


def _plausible(variant: VariantAt, world: World) -> bool:
    """Whether the signs that a variant puts in by hand are those of the components."""
    return all(not_negative(sense, world) for sense in variant.senses)


def _is_of_a_whole_speed(variant: VariantAt, world: World) -> bool:
    """Whether sine and cosine are exchanged of spheres that move across the line of centres alone.

    Their components along the line, zero, are their speeds then.
    """
    zero = [is_zero(x, world) for x in variant.senses]
    return variant.mistake in _OF_ANGLES and bool(zero) and all(zero)
