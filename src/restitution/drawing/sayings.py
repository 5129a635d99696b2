"""What a statement says of each velocity, each impulse and each deflection, for their labels.

A velocity is known by its sphere and by the latest event that changed it (0 is the start).
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import field, replace
from fractions import Fraction

from restitution.errors import RestitutionError
from restitution.expression.tree import (
    Expression,
    Letter,
    Name,
    Negate,
    Number,
    Pair,
    Polar,
    Quantity,
    Unit,
    has_quantity,
    is_quantity,
    walk,
)
from restitution.problem import (
    Aligned,
    Arrival,
    AtRest,
    Compare,
    Extremum,
    Find,
    Given,
    Impact,
    Kick,
    Let,
    Problem,
    Show,
    Sphere,
    Step,
    trees_of_relation,
    trees_of_step,
)
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.render.short import angle_label
from restitution.render.text import to_text
from restitution.staging.values import PartInNumbers
from restitution.vector import Vector
from restitution.wording.values import layout_of

_GREEK = ("beta", "theta", "phi", "psi", "gamma", "omega")
_UNREADABLE = (RestitutionError, ArithmeticError, LookupError, TypeError, ValueError)


@dataclass(frozen=True)
class LabelledAngle:
    """An angle between a velocity and a reference, with its label.

    ``reference`` is a vector in numbers. It is a line (``line``) where either sense of it will
    do; otherwise the angle is from the direction of the vector itself. ``tree`` is the angle as it
    is given, and ``value`` what it is in the picture, in radians; None where it is only named.
    """

    reference: Vector
    line: bool
    label: Layout
    tree: Expression | None = None
    value: float | None = None

    def shown(self, drawn: float, *, turned: bool = False) -> Layout | None:
        """The label of an arc of that size, in radians; ``turned``, from the other end of a line.

        None where no label is certain.
        """
        if self.tree is None or self.value is None:
            return supplement(self.label) if turned else self.label
        return angle_label(self.tree, self.value, drawn, self.label)


@dataclass
class VelocityLabels:
    """What is said of one velocity: its size, itself as a vector, its angles.

    ``given`` is the expression by which it is known, with the events told before that.
    """

    size: Layout | None = None
    vector: Layout | None = None
    given: tuple[Expression, int] | None = None
    angles: list[LabelledAngle] = field(default_factory=list)


Key = tuple[str, int]


@dataclass
class Sayings:
    """What a statement says, by velocity and by event.

    ``deflections`` and ``impulses`` are those that are given or asked for, ``blows`` the angles
    of impulses from outside, ``lines`` those that walls and lines of centres make with **i**.
    """

    velocities: dict[Key, VelocityLabels]
    deflections: dict[tuple[int, str], Layout]
    impulses: dict[int, Layout]
    blows: dict[int, LabelledAngle]
    lines: dict[int, LabelledAngle]

    def of(self, body: str, state: int) -> VelocityLabels:
        """What is said of a velocity; nothing, where nothing is."""
        return self.velocities.get((body, state), VelocityLabels())


def state_after(motion: PartInNumbers, body: str, stage: int) -> int:
    """The latest event up to a stage that changed the velocity of a sphere."""
    for happening in reversed(motion.story.happenings[:stage]):
        if body in happening.bodies and not isinstance(happening.step, Arrival):
            return happening.number
    return 0


def sayings(motion: PartInNumbers, letters: Mapping[Expression, str] | None = None) -> Sayings:
    """Everything that is said, read once for a part of a problem.

    ``letters`` are those that the working introduces, by the quantities for which they stand: what
    is asked for is called by them, or has no letter. None where no working is at hand.
    """
    reader = _Reader(motion, letters)
    for sphere in motion.model.problem.spheres:
        reader.start(sphere)
    asked: list[tuple[Expression, int]] = []
    for trees, now, fact in _lines(motion):
        if fact and len(trees) == 2:
            reader.equal(trees[0], trees[1], now)
            reader.equal(trees[1], trees[0], now)
        asked += [(tree, now) for tree in trees]
    for tree, now in asked:
        for node in walk(tree):
            if isinstance(node, Quantity):
                reader.asked(node, now)
    for happening in motion.story.happenings:
        if isinstance(happening.step, Kick):
            reader.kick(happening.number, happening.step)
        elif isinstance(happening.step, Impact):
            reader.line(happening.number, happening.step)
    reader.name_what_is_asked()
    return reader.sayings


def _lines(motion: PartInNumbers) -> Iterator[tuple[tuple[Expression, ...], int, bool]]:
    """Expressions of facts (equal ones together) and of questions, with the events told before."""
    problem, part = motion.model.problem, motion.model.part
    for step, now, _ in problem.timeline(part):
        if isinstance(step, Given):
            for relation in step.relations:
                if isinstance(relation, Compare) and set(relation.operators) == {"="}:
                    for pair in zip(relation.operands, relation.operands[1:]):
                        yield pair, now, True
                elif isinstance(relation, AtRest):
                    velocity = Quantity("velocity", (relation.body,))
                    yield (velocity, Number(Fraction(0))), now, True
                elif isinstance(relation, Compare | Aligned):
                    yield tuple(trees_of_relation(relation)), now, False
        elif isinstance(step, Let):
            yield (Letter(step.letter), step.expression), now, True
        elif isinstance(step, Find):
            for item in step.items:
                yield (item.expression,), now, False
        elif isinstance(step, Show):
            yield tuple(trees_of_relation(step.relation)), now, False
            if isinstance(step.subject, Extremum):
                yield (step.subject.expression,), now, False


class _Reader:
    def __init__(self, motion: PartInNumbers, letters: Mapping[Expression, str] | None) -> None:
        self.motion = motion
        self.letters = letters
        self.sayings = Sayings({}, {}, {}, {}, {})
        self.taken = set(motion.model.unknowns.taken)
        self.deflections: list[tuple[int, str]] = []

    def words(self, key: Key) -> VelocityLabels:
        return self.sayings.velocities.setdefault(key, VelocityLabels())

    # --- what is given ----------------------------------------------------------------------

    def start(self, sphere: Sphere) -> None:
        if isinstance(sphere.velocity, Expression):
            self.velocity((sphere.name, 0), sphere.velocity, 0)

    def velocity(self, key: Key, tree: Expression, now: int) -> None:
        """A velocity given by a tree: by size and direction, or by components."""
        words = self.words(key)
        words.given = tree, now
        if isinstance(tree, Polar):
            words.size = lay.from_tree(tree.size)
            angle = self.polar(tree, now)
            words.angles += [angle] if angle is not None else []
        elif any(isinstance(node, Unit | Pair) for node in walk(tree)):
            words.vector = layout_of(tree)

    def polar(self, tree: Polar, now: int) -> LabelledAngle | None:
        """The angle of a vector given by size and direction."""
        if tree.wall is not None:
            reference = self.number_vector(Quantity("direction", (tree.wall,)), now)
        elif tree.origin is not None:
            reference = self.number_vector(tree.origin, now)
        else:
            reference = Vector(1.0, 0.0)
        if reference is None:
            return None
        return self.known_angle(reference, tree.angle, now)

    def known_angle(self, reference: Vector, tree: Expression, now: int) -> LabelledAngle:
        """An angle from the direction of a vector that is given."""
        return LabelledAngle(reference, False, _measure(tree), tree, self.number(tree, now))

    def number(self, tree: Expression, now: int) -> float | None:
        """An angle as it is in the picture, in radians."""
        try:
            value = self.motion.story.evaluator(now).value(tree)
            return float(value.measure() if hasattr(value, "measure") else value)
        except _UNREADABLE:
            return None

    def equal(self, left: Expression, right: Expression, now: int) -> None:
        """``left = right``, where left speaks of the motion and right is known."""
        if not isinstance(left, Quantity) or has_quantity(right):
            return
        key = self.key(left, now)
        match left.kind:
            case "velocity" if key is not None:
                self.velocity(key, right, now)
            case "speed" if key is not None and not (isinstance(right, Number) and not right.value):
                self.words(key).size = self.words(key).size or lay.from_tree(right)
            case "direction" if key is not None:
                self.words(key).angles.append(self.known_angle(Vector(1.0, 0.0), right, now))
            case "deflection":
                event = self.event(left, now)
                if event is not None:
                    self.sayings.deflections[event] = _measure(right)
            case "impulse" if not left.arguments:
                number = left.stage if isinstance(left.stage, int) else self.latest_event(now)
                if number:
                    self.sayings.impulses[number] = lay.from_tree(right)
            case "angle":
                self.angle(left, now, _measure(right))

    def kick(self, number: int, step: Kick) -> None:
        tree = step.impulse
        size = tree.size if isinstance(tree, Polar) else tree
        self.sayings.impulses[number] = layout_of(size)
        angle = self.polar(tree, number - 1) if isinstance(tree, Polar) else None
        if angle is not None:
            self.sayings.blows[number] = angle

    def line(self, number: int, step: Impact) -> None:
        """The angle at which a wall or a line of centres is given to run."""
        wall = self.motion.story.walls.get(step.second)
        tree = step.along if wall is None else wall.along
        if isinstance(tree, Expression) and is_angle(tree):
            self.sayings.lines[number] = self.known_angle(Vector(1.0, 0.0), tree, number - 1)

    # --- what is asked ----------------------------------------------------------------------

    def asked(self, node: Quantity, now: int) -> None:
        match node.kind:
            case "deflection":
                event = self.event(node, now)
                if event is not None and event not in self.sayings.deflections:
                    self.deflections.append(event)
            case "angle":
                self.angle(node, now, None)

    def angle(self, node: Quantity, now: int, label: Layout | None) -> None:
        """The angle between a velocity and a wall, a line of centres or a vector."""
        place = self.place_of_angle(node, now)
        if place is None:
            return
        key, reference, line = place
        angles = self.words(key).angles
        if any(_alike(angle.reference, reference) for angle in angles):
            return
        label = self.letter_of_angle(key, reference) if label is None else label
        if label is not None:
            angles.append(LabelledAngle(reference, line, label))

    def letter_of_angle(self, key: Key, reference: Vector) -> lay.Letter | None:
        """The letter of an angle that is asked for."""
        if self.letters is None:
            return self.letter(_GREEK)
        now = len(self.motion.story.happenings)
        for quantity, letter in self.letters.items():
            if is_quantity(quantity, "angle"):
                place = self.place_of_angle(quantity, now)
                if place is not None and place[0] == key and _alike(place[1], reference):
                    return lay.letter(letter)
        return None

    def place_of_angle(self, node: Quantity, now: int) -> tuple[Key, Vector, bool] | None:
        """The velocity that has an angle, what it is measured from, and whether that is a line."""
        for one, other in (node.arguments, node.arguments[::-1]):
            key = self.key(one, now) if isinstance(one, Quantity) else None
            if key is None or not is_quantity(one, "velocity"):
                continue
            if any(isinstance(x, Quantity) and x.kind != "line_of_centres" for x in walk(other)):
                continue
            line = isinstance(other, Name | Quantity)
            wall = isinstance(other, Name)
            tree = Quantity("direction", (other,)) if wall else other
            reference = self.number_vector(tree, now)
            if reference is not None:
                return key, reference, line
        return None

    def name_what_is_asked(self) -> None:
        """The letters of angles of deflection: those of the working, else one for all.

        Where an event turns two spheres, their names tell the angles apart.
        """
        if self.letters is not None:
            now = len(self.motion.story.happenings)
            for quantity, name in self.letters.items():
                if is_quantity(quantity, "deflection"):
                    key = self.event(quantity, now)
                    if key in self.deflections:
                        self.sayings.deflections.setdefault(key, lay.letter(name))
            return
        turned = [
            deflection
            for deflection in self.deflections
            if deflection not in self.sayings.deflections
        ]
        letter = self.letter(("delta", *_GREEK)) if turned else None
        for event, body in turned:
            if letter is not None:
                both = any(e == event and b != body for e, b in turned)
                self.sayings.deflections[event, body] = replace(
                    letter, subscript=body if both else ""
                )

    def letter(self, names: Iterable[str]) -> lay.Letter | None:
        """A letter that the statement and the working do not use."""
        name = next((name for name in names if name not in self.taken), None)
        if name is None:
            return None
        self.taken.add(name)
        return lay.letter(name)

    # --- whose, and when --------------------------------------------------------------------

    def latest_event(self, now: int, node: Quantity | None = None) -> int:
        """The latest impact or blow, of the body named if one is."""
        body = node.arguments[0].name if node and node.arguments else None  # type: ignore[union-attr]
        for happening in reversed(self.motion.story.happenings[:now]):
            if not isinstance(happening.step, Arrival) and body in (None, *happening.bodies):
                return happening.number
        return 0

    def event(self, node: Quantity, now: int) -> tuple[int, str] | None:
        name = node.arguments[0]
        if not isinstance(name, Name):
            return None
        number = node.stage if isinstance(node.stage, int) else self.latest_event(now, node)
        return (number, name.name) if number else None

    def key(self, node: Quantity, now: int) -> Key | None:
        """The velocity that a quantity of one sphere speaks of."""
        name = node.arguments[0] if node.arguments else None
        if not isinstance(name, Name) or name.name not in self.motion.story.spheres:
            return None
        stage = node.stage if isinstance(node.stage, int) else now
        state = state_after(self.motion, name.name, stage)
        if node.stage == "before":
            state = state_after(self.motion, name.name, state - 1) if state else 0
        return name.name, state

    def number_vector(self, tree: Expression, now: int) -> Vector | None:
        try:
            x, y = self.motion.story.evaluator(now).direction(tree)
            size = math.hypot(float(x), float(y))
            return Vector(float(x) / size, float(y) / size)
        except _UNREADABLE:
            return None


def is_angle(tree: Expression) -> bool:
    """Whether a direction is given by its angle with **i**, and not by a vector."""
    return not any(isinstance(node, Unit | Pair | Polar | Name | Quantity) for node in walk(tree))


def _alike(a: Vector, b: Vector) -> bool:
    return bool(abs(a.cross(b)) < 1e-9)


def _measure(tree: Expression) -> Layout:
    """An angle without its sign."""
    while isinstance(tree, Negate):
        tree = tree.operand
    return lay.from_tree(tree)


def has_letters(layout: Layout) -> bool:
    """Whether a label has letters in it, and so its unit with them."""
    return any(character.isalpha() for character in to_text(layout))


def supplement(label: Layout) -> Layout:
    """180° less an angle: α for 180° − α and for π − α, 60° for 120°."""
    half_turn = lay.Degrees(lay.Number("180"))
    straight = ("+", half_turn), ("+", lay.letter("pi"))
    if isinstance(label, lay.Sum) and label.terms[0] in straight and len(label.terms) == 2:
        sign, rest = label.terms[1]
        if sign == "-":
            return rest
    if isinstance(label, lay.Degrees) and isinstance(label.inside, lay.Number):
        digits = f"{180 - float(label.inside.digits):g}"
        return lay.Degrees(lay.Number(digits))
    return lay.Sum((("+", half_turn), ("-", lay.bracketed(label))))


def speaks_of_vectors(problem: Problem, apart_from: tuple[type[Step], ...] = ()) -> bool:
    """Whether velocities or events are told by **i** and **j**, or such an answer is sought.

    ``apart_from`` are kinds of steps that do not count.
    """
    rest = Pair(Number(Fraction(0)), Number(Fraction(0)))
    directions = [sphere.velocity for sphere in problem.spheres if sphere.velocity != rest]
    for _, step in problem.steps():
        if not isinstance(step, apart_from):
            directions += trees_of_step(step)
        if isinstance(step, Find) and any(
            is_quantity(item.expression, "velocity", "direction", "momentum") for item in step.items
        ):
            return True
    nodes = [node for tree in directions if isinstance(tree, Expression) for node in walk(tree)]
    return any(isinstance(node, Pair) or node == Unit("j") for node in nodes)
