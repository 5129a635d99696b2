"""The letters of the lines of a script: how they are used, and what they usually mean."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

import numpy as np

from restitution.expression.quantities import ANGLES
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Quantity,
    Unit,
    is_binary,
    is_quantity,
    letters,
    unsigned,
    walk,
)
from restitution.practice.letters.candidates import Candidate, earlier, suffix
from restitution.practice.letters.named_vectors import (
    vector_letters,
)
from restitution.practice.letters.options import (
    Usage,
    is_direction,
    of_trees,
    usual,
)
from restitution.practice.letters.shapes import (
    EquationInLetters,
    components_by_shape,
    is_of_squares,
)
from restitution.practice.letters.surroundings import (
    DeclaredLetter,
    Surroundings,
)
from restitution.practice.letters.trial import NOWHERE, Frame, inside_angles, resolved_in
from restitution.practice.reading.angles import is_angle
from restitution.practice.reading.phrase_names import is_vague, is_whole_loss
from restitution.practice.script import Claim, Link, Scope, Script
from restitution.problem import Event, Impact, Kick
from restitution.vector import Vector

_VELOCITIES = frozenset("vVwW")
_EARLIER = frozenset("uU")
_IMPULSES = frozenset("IJ")
_TINY = 1e-9
_OF_TURNS = frozenset({"delta", "x"})
_OF_ANGLES = frozenset({"beta", "phi", "theta"})


class LettersOfLines:
    """The letters of a script in one world: where they stand, and what they usually mean."""

    def __init__(
        self, script: Script, around: Surroundings, declared: Sequence[DeclaredLetter]
    ) -> None:
        self.lines = [line for line in script.lines if line.kind in ("relations", "declaration")]
        self.around = around
        self.declared = declared
        self.angular = self._angular()
        self.items: dict[int, list[tuple[Link, frozenset[str]]]] = {}
        for line in self.lines:
            links = [(link, self._open(link, line.number)) for link in line.links]
            self.items[line.number] = [(link, names) for link, names in links if names]
        self.certain = {
            letter.letter: letter
            for letter in declared
            if len(letter.trees) == 1 and not letter.since
        }
        self.defined: set[str] = set()
        self.definitions = dict(self._definitions())
        self.dotted = self._dotted()
        self.vanishing = frozenset(self._vanishing())

    # --- where they stand -------------------------------------------------------------------------

    def _angular(self) -> frozenset[str]:
        """The letters that stand inside a trigonometric function, or are equated with an angle."""
        claims = [
            claim for line in self.lines for link in line.links for claim in link.readings[:1]
        ]
        angular = frozenset[str]().union(
            *(inside_angles(side) for claim in claims for side in (claim.left, claim.right))
        )
        for claim in claims:
            known = angular | self.around.world.angles
            for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
                angle = is_angle(other, known) and letters(other) <= known
                if isinstance(one, Letter) and angle:
                    angular |= {one.name}
        return angular

    def meanings(self, number: int) -> dict[str, Expression]:
        """The trees of letters whose declaration is certain, in a line."""
        force: dict[str, Expression] = {}
        for letter in sorted(self.declared, key=lambda letter: letter.since):
            if letter.since <= number and len(letter.trees) == 1:
                force[letter.letter] = letter.trees[0]
        return force

    def _open(self, link: Link, number: int) -> frozenset[str]:
        """The letters of a link whose meaning is not certain, those inside meanings included."""
        force = self.meanings(number)
        names: set[str] = set()
        for claim in link.readings:
            for side in (claim.left, claim.right, *claim.others):
                names |= letters(side)
        pending, seen = list(names), set[str]()
        while pending:
            name = pending.pop()
            if name not in seen:
                seen.add(name)
                pending.extend(letters(force[name]) if name in force else ())
        return frozenset(seen - force.keys() - self.around.letters)

    def _definitions(self) -> Iterator[tuple[str, tuple[int, Expression]]]:
        """Letters whose first line gives them a known value."""
        seen: set[str] = set()
        for line in self.lines:
            for link, names in self.items[line.number]:
                fresh = names - seen
                seen |= names
                if len(names) == 1 and fresh and not any(" " in name for name in names):
                    (name,) = names
                    self.defined.add(name)
                    for claim in () if link.supposed else link.readings[:1]:
                        tree = _defining(claim, name)
                        if tree is not None:
                            yield name, (line.number, tree)

    def becoming_vectors(self) -> Iterator[int]:
        """The lines that give a vector to a letter which had a number: ``v_B = 2``, then ``3i``."""
        natures: dict[str, bool] = {}
        for line in self.lines:
            frame = Frame(None, self.meanings(line.number))
            for link, names in self.items[line.number]:
                defined = _defining(link.readings[0], next(iter(names)))
                if len(names) > 1 or defined is None or link.supposed:
                    continue
                (name,) = names
                value = self.around.tester.value(defined, {}, frame)
                if value is not None and " " not in name:
                    vector = isinstance(value, Vector)
                    if vector and natures.get(name) is False:
                        yield line.number
                    natures[name] = vector

    def _vanishing(self) -> Iterator[str]:
        """Letters of which a line says that they are zero: ``v = 0``, ``2(-w) = 2 × 0``."""
        for line in self.lines:
            frame = Frame(None, self.meanings(line.number))
            for link, names in self.items[line.number]:
                claim = link.readings[0]
                if len(names) == 1 and claim.sign == "=":
                    (name,) = names
                    zero, one = (self._holds_at(claim, name, x, frame) for x in (0.0, 1.0))
                    if zero and not one:
                        yield name

    def _holds_at(self, claim: Claim, name: str, number: float, frame: Frame) -> bool:
        """Whether a claim holds at all samples where its letter is a number."""
        value = np.full(self.around.world.samples, number)
        held = self.around.tester.holds(claim, {name: value}, (), frame)
        return held is not None and bool(np.all(held))

    def _dotted(self) -> frozenset[str]:
        """The letters in scalar products with n or t, these among them, that no line defines."""
        factors: set[str] = set()
        for line in self.lines:
            for link in line.links:
                for claim in link.readings:
                    for side in (claim.left, claim.right):
                        for tree in walk(side):
                            factors |= self._factors(tree)
        return frozenset(factors - self.definitions.keys() - self.certain.keys())

    def _factors(self, tree: Expression) -> frozenset[str]:
        """The letters of a scalar product of which one stands alone and is a direction."""
        if not is_quantity(tree, "dot"):
            return frozenset()
        alone = {argument.name for argument in tree.arguments if isinstance(argument, Letter)}
        named = any(is_direction(name) and name not in self.around.letters for name in alone)
        return frozenset(alone) if named else frozenset()

    # --- slots

    # --- what they usually mean -------------------------------------------------------------------

    def _event_numbered(self, name: str) -> int | None:
        """The event of which a velocity has the number: v₂ behind the second, or the first of v₁.

        Velocities are counted from that at the start where the first of them is that one.
        """
        base, _, number = name.partition("_")
        if not number.isdigit():
            return None
        line, tree = self.definitions.get(f"{base}_1", (0, None))
        first = None
        if tree is not None:
            first = self.around.tester.value(tree, {}, Frame(None, self.meanings(line)))
        at_start = first is not None and self.around.of_the_start(first)
        return int(number) - at_start

    def _is_velocity(self, name: str) -> bool:
        """Whether a letter is one for velocities, and a vector by its first line: v = 3i + 2j."""
        base = name.partition("_")[0]
        if base not in _VELOCITIES | _EARLIER:
            return False
        if name not in self.definitions:
            return name in self.vectors
        if base in "wW" and any(sphere.position for sphere in self.around.problem.spheres):
            return False  # it may be a place
        number, tree = self.definitions[name]
        value = self.around.tester.value(tree, {}, Frame(None, self.meanings(number)))
        return isinstance(value, Vector) and not self.around.of_the_start(value)

    @cached_property
    def vectors(self) -> frozenset[str]:
        """The letters that are vectors in an equation of vectors: ``I = 2(v - 3i + 5j)``.

        So is v in ``v = 7/10 n`` below ``n = (-3i + 4j)/5``.
        """
        vectors: set[str] = set()
        for line in self.lines:
            frame = Frame(None, self.meanings(line.number))
            for link, names in self.items[line.number]:
                known = {name for name in names if is_direction(name) and self._points(name)}
                tester = self.around.tester
                vectors.update(vector_letters(link.readings[0], names, tester, frame, known))
        return frozenset(vectors)

    @cached_property
    def vector_phrases(self) -> frozenset[str]:
        """The phrases that lines equate with vectors: ``momentum = 2(3, 1) + (1, 2) = (7, 4)``."""
        phrases: set[str] = set()
        for line in self.lines:
            frame = Frame(None, self.meanings(line.number))
            for link, _ in self.items[line.number]:
                claim = link.readings[0]
                if isinstance(claim.left, Letter) and " " in claim.left.name:
                    value = self.around.tester.value(claim.right, {}, frame)
                    phrases |= {claim.left.name} if isinstance(value, Vector) else set()
        return frozenset(phrases)

    def _points(self, name: str) -> bool:
        """Whether the first line of a letter gives it a vector as its value."""
        number, tree = self.definitions.get(name, (0, None))
        frame = Frame(None, self.meanings(number))
        value = None if tree is None else self.around.tester.value(tree, {}, frame)
        return isinstance(value, Vector)

    def usual(self, name: str, scope: Scope) -> Candidate | None:
        """What a letter or phrase means where no line tells."""
        phrase = self.around.phrase(name, scope.event)
        if phrase:
            meant = list(of_trees(self.staged(name, phrase, scope)))
            if name in self.vector_phrases:
                meant = [candidate for candidate in meant if candidate.nature == "vector"] or meant
            return meant[0]
        if self._is_velocity(name):
            moving = [
                candidate for candidate in self.around.candidates if candidate.kind == "velocity"
            ]
            after = [
                candidate
                for candidate in moving
                if candidate.event and scope.event in (None, candidate.event)
            ]
            changed = [x for x in after if isinstance(self._event_of(x), Impact | Kick)]
            after = changed or after  # where a body only arrives, it moves as before
            if earlier(name):
                after = [candidate for candidate in moving if candidate.event == 0]
            own = [candidate for candidate in after if candidate.body == suffix(name)]
            if not own:
                own = [
                    candidate
                    for candidate in after
                    if candidate.event == self._event_numbered(name)
                ]
                own = own if len(own) == 1 else []
            if not own and len(after) > 1:
                own = self._asked_velocities(after)
            return own[-1] if own else after[0] if len(after) == 1 else None
        if name.partition("_")[0] in _IMPULSES and (self._points(name) or name in self.vectors):
            return self._vector_impulse(name, scope)
        by_squares = self._speed_of_a_body(name, scope)
        if by_squares is not None:
            return by_squares
        usage = Usage(name, name in self.angular, scope)
        known = usual(usage, self.around.candidates, self.around.problem, self.around.events)
        known = known or self._resolved_speed(name, scope) or self._asked_speed(name)
        known = known or self._asked_coordinate(name)
        return known or self._by_shape(name) or self._only_speed(name) or self._only_angle(name)

    def staged(self, name: str, trees: Iterable[Expression], scope: Scope) -> list[Expression]:
        """What a phrase may mean in a scope; an angle, or a loss, is that which is asked first."""
        own = [self.around.staged(tree, scope) for tree in trees]
        whole = scope.event is None and is_whole_loss(name, self.around.problem)
        if is_vague(name) or whole:
            own.sort(key=lambda tree: tree not in self.around.asked)
        return own

    def _asked_velocities(self, after: Sequence[Candidate]) -> list[Candidate]:
        """The velocity that the part asks for, or whose size it does, of one body that is struck.

        Behind several impacts only a velocity that is asked itself is known to be meant.
        """
        impacts = sum(isinstance(event, Impact) for event in self.around.events)
        kinds = ("velocity", "speed") if impacts == 1 else ("velocity",)
        asked = [quantity for quantity in self.around.asked if isinstance(quantity, Quantity)]
        stages = {(x.arguments[0], x.stage) for x in asked if x.kind in kinds}
        own = [x for x in after if (Name(x.body or ""), x.event) in stages]
        open_ = {x.body for x in after if not x.given}
        return own if len(own) == 1 and len(open_) == 1 else []

    def _event_of(self, candidate: Candidate) -> Event | None:
        """The event after which a quantity is taken."""
        return self.around.events[candidate.event - 1] if candidate.event else None

    def _vector_impulse(self, name: str, scope: Scope) -> Candidate | None:
        """The impulse in the only impact, or in that of a heading, that a vector is."""
        numbers = [n for n, e in enumerate(self.around.events, 1) if isinstance(e, Impact)]
        wanted = {scope.event} if scope.event is not None else set(numbers)
        own = [
            candidate
            for candidate in self.around.candidates
            if candidate.kind == "impulse"
            and candidate.nature == "vector"
            and candidate.event in wanted
            if suffix(name) in ("", candidate.body)
        ]
        return own[0] if len(own) == 1 else None

    def _asked_coordinate(self, name: str) -> Candidate | None:
        """The coordinate of the place that is asked, for ``x = 6 + 3 × 5`` with the 6 of a place.

        A product alone may be the way from there.
        """
        axis = {"x": Unit("i"), "y": Unit("j")}.get(name)
        _, tree = self.definitions.get(name, (0, None))
        if axis is None or not is_binary(tree, "+", "-"):
            return None
        asked = [x for x in self.around.asked if is_quantity(x, "position")]
        places = [x for x in self.around.candidates if x.kind == "place" and x.axis == axis]
        wanted = [Quantity("along", (place, axis)) for place in asked]
        own = [x for x in places if [x.quantity] == wanted]
        if not own:
            return None
        tester = self.around.tester
        known = [tester.value(x.quantity, {}, NOWHERE) for x in places if x not in own]
        terms = [tester.value(term, {}, NOWHERE) for term in (tree.left, tree.right)]
        from_there = any(
            isinstance(a, np.ndarray | float) and np.all(a) and bool(np.all(np.abs(a - b) < _TINY))
            for a in known
            for b in terms
            if isinstance(b, np.ndarray | float)
        )
        return own[0] if from_there else None

    def _asked_speed(self, name: str) -> Candidate | None:
        """The one speed that is asked, for ``v = √(4² + 5²)`` and ``v² = 16 + 25``.

        A value that is no quantity at all is a mistake, and no letter of the student's own, where
        no line has the letter beside others.
        """
        if name not in _VELOCITIES or not self._is_of_squares_alone(name):
            return None
        asked = [candidate for candidate in self.around.candidates if candidate.asked]
        speeds = [
            candidate for candidate in asked if getattr(candidate.quantity, "kind", "") == "speed"
        ]
        return speeds[0] if len(speeds) == 1 else None

    def _is_of_squares_alone(self, name: str) -> bool:
        """Whether a letter is given by squares, and no line has it beside others."""
        links = [pair for own in self.items.values() for pair in own if name in pair[1]]
        alone = all(names == {name} for _, names in links)
        return alone and any(is_of_squares(link.readings[0], name) for link, _ in links)

    def _speed_of_a_body(self, name: str, scope: Scope) -> Candidate | None:
        """The last speed of a sphere, for ``vB = √(4² + 5²)``."""
        if name.partition("_")[0] not in ("v", "V") or not self._is_of_squares_alone(name):
            return None
        spheres = self.around.problem.spheres
        single = len(spheres) == len(self.around.events) == 1 and not suffix(name)
        body = spheres[0].name if single else suffix(name)
        own = [
            candidate
            for candidate in self.around.candidates
            if candidate.kind == "speed" and candidate.event and candidate.body == body
            if scope.event in (None, candidate.event)
        ]
        return max(own, key=lambda candidate: candidate.event or 0, default=None)

    def _only_speed(self, name: str) -> Candidate | None:
        """The speed after the only impact of the only sphere, for ``v = 7/16 u``, ``v² = 9/16 u²``.

        No line has the letter beside others, and no quantity has its value.
        """
        if name not in ("v", "V") or len(self.around.problem.spheres) != 1:
            return None
        if len(self.around.events) != 1 or self._points(name) or name in self.angular:
            return None
        if any(names != {name} for own in self.items.values() for _, names in own if name in names):
            return None
        speeds = (x for x in self.around.candidates if x.kind == "speed" and x.event == 1)
        return next(speeds, None)

    def _only_angle(self, name: str) -> Candidate | None:
        """The deflection or angle that the part alone asks for, or prints: of ``tan δ = …``.

        Behind several impacts an angle may be any of several.
        """
        impacts = sum(isinstance(event, Impact) for event in self.around.events)
        if name not in self.angular or impacts > 1:
            return None
        angles = {
            node
            for tree in (*self.around.asked, *self.around.printed)
            for node in walk(tree)
            if isinstance(node, Quantity) and node.kind in ANGLES
        }
        if len(angles) != 1:
            return None
        (angle,) = angles
        usual_names = _OF_TURNS if angle.kind == "deflection" else _OF_ANGLES
        return next(of_trees([angle]), None) if name in usual_names else None

    def _by_shape(self, name: str) -> Candidate | None:
        """The component that a letter is by the shapes of two laws, right or wrong."""
        quantity = self.shapes.get(name)
        alike = (
            candidate for candidate in self.around.candidates if candidate.quantity == quantity
        )
        return None if quantity is None else next(alike, None)

    @cached_property
    def shapes(self) -> dict[str, Expression]:
        """The components along the line of centres that letters are by the shapes of laws."""
        equations = (
            EquationInLetters(
                link.readings[0],
                (one, other),
                line.scope,
                Frame(self.around.world.now(line.scope), self.meanings(line.number)),
            )
            for line in self.lines
            for link, names in self.items[line.number]
            if len(names) == 2
            for one, other in (sorted(names),)
        )
        return components_by_shape(equations, self.around.events, self.around.tester)

    def _resolved_speed(self, name: str, scope: Scope) -> Candidate | None:
        """The speed after the impact of the only body there is, for the v of ``v cos 45``."""
        if name not in _VELOCITIES or name not in self.resolved:
            return None
        events = len(self.around.events)
        number = scope.event or (events if events == 1 else None)
        after = [
            candidate
            for candidate in self.around.candidates
            if candidate.kind == "speed" and candidate.event == number
        ]
        return after[0] if len(after) == 1 and number else None

    @cached_property
    def resolved(self) -> frozenset[str]:
        """The letters that stand before sines and cosines."""
        claims = [
            claim for line in self.lines for link in line.links for claim in link.readings[:1]
        ]
        return frozenset[str]().union(
            *(resolved_in(side) for claim in claims for side in (claim.left, claim.right))
        )

    @cached_property
    def turned_speeds(self) -> frozenset[str]:
        """The letters that an angle of the student's own resolves, alone on a side: ``V cos β``."""
        alone = (
            unsigned(side)
            for line in self.lines
            for link in line.links
            for side in (link.readings[0].left, link.readings[0].right)
        )
        return frozenset(
            name
            for side in alone
            if is_binary(side, "*")
            if inside_angles(side) and not inside_angles(side) & self.around.letters
            for name in resolved_in(side) - self.around.letters
        )

    # --- searching


def _defining(claim: Claim, name: str) -> Expression | None:
    """The value that a claim gives a letter: ``n = (-3i + 4j)/5``."""
    if claim.sign != "=" or claim.others:
        return None
    for one, other in ((claim.left, claim.right), (claim.right, claim.left)):
        if isinstance(one, Letter) and one.name == name and name not in letters(other):
            return other
    return None
