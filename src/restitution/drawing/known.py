"""What is known of speeds and angles along a path, as people write it."""

from __future__ import annotations

import math
from dataclasses import field

from restitution.drawing.sayings import Sayings, has_letters
from restitution.errors import RestitutionError
from restitution.exact.simplicity import operations
from restitution.exact.symbols import multiple_of_a_symbol, symbol_names
from restitution.expression.tree import Letter as TreeLetter
from restitution.records import dataclass
from restitution.render import layout as lay
from restitution.render.layout import Degrees, Layout, Number, Words
from restitution.render.short import is_short
from restitution.render.text import to_text
from restitution.solving.algebra.forms import plain
from restitution.solving.equations.solution import Branch, PartSolution, Solution
from restitution.solving.story.forward import Story
from restitution.staging.geometry import floats, still
from restitution.staging.plan import Stop
from restitution.staging.values import PartInNumbers
from restitution.vector import Vector

# Longer expressions (in characters on one line) say less beside a path than they hide.
_SHORT = 9
# Velocities of more operations than this have no short size.
_LONG = 30
_SAME = 1e-9


@dataclass
class Known:
    """What is known of angles and speeds, as people write it."""

    solution: Solution
    part: PartSolution
    branch: Branch
    motion: PartInNumbers
    sayings: Sayings | None = None  # where only what the question says may be shown
    speeds: dict[tuple[str, int], Layout | None] = field(default_factory=dict)

    def speed(self, body: str, after: int) -> Layout | None:
        """The speed of a sphere after an event, if it is short."""
        if (body, after) not in self.speeds:
            self.speeds[body, after] = self._speed(body, after)
        return self.speeds[body, after]

    def _speed(self, body: str, after: int) -> Layout | None:
        if self.sayings is not None:
            words = self.sayings.of(body, after)
            if words.size is None or has_letters(words.size):
                return words.size or words.vector
            return lay.Phrase((words.size, Words("m s⁻¹")))
        if still(floats(self.motion.story.velocity(body, after))):
            return None
        try:
            story = self.branch.story
            velocity = story.velocity(body, after)
            if sum(map(operations, velocity)) > _LONG:
                return None
            value = plain(story.size(velocity), [self.branch.sample])
        except (RestitutionError, ArithmeticError):
            return None
        names = symbol_names(value)
        if any(name.startswith("_") for name in names):
            return None
        layout = lay.from_sympy(value)
        if names:
            if not is_short(value):  # 0.634u, where its exact form is long
                multiple = multiple_of_a_symbol(value)
                if multiple is None:
                    return None
                number, letter = multiple
                layout = lay.product(lay.decimal_number(number), lay.from_sympy(letter))
            return layout if len(to_text(layout)) <= _SHORT else None
        if len(to_text(layout)) > 4:
            layout = lay.decimal_number(value)
        return lay.Phrase((layout, Words("m s⁻¹")))

    def angle(self, body: str, stop: Stop, *, before: bool) -> Layout | None:
        """The angle of a velocity with a wall (with a round one: with the radius), if it is short.

        A letter that has this value, or the value itself where it is the same for all letters.
        """
        if self.sayings is not None:
            normal = stop.normal.turned_left() if stop.normal is not None else Vector(0.0, 0.0)
            angles = self.sayings.of(body, stop.number - 1).angles if before else []
            given = [angle for angle in angles if abs(angle.reference.cross(normal)) < _SAME]
            if not given or stop.kind != "wall":
                return None
            size = _angle(self.motion.story, body, stop, before)
            return None if size is None else given[0].shown(size)
        known = [
            self.motion.story,
            self.branch.numbers,
            *(moved for _, moved in self.motion.free if moved is not None),
        ]
        sizes = [size for story in known if (size := _angle(story, body, stop, before)) is not None]
        if len(sizes) < len(known) or sizes[0] < _SAME:
            return None
        letters = [name for name, role in self.part.roles.items() if role.kind == "angle"]
        for turned in (False, True):
            wanted = [math.pi / 2 - size if turned else size for size in sizes]
            for name in letters:
                values = [_letter(story, name, stop.number) for story in known]
                if all(v is not None and abs(v - w) < _SAME for v, w in zip(values, wanted)):
                    layout = lay.letter(name)
                    rest = lay.total([Degrees(Number("90")), lay.negative(layout)])
                    return rest if turned else layout
            if all(abs(size - sizes[0]) < _SAME for size in sizes):
                # The same for all letters, if any could be varied.
                varied = len(sizes) > 2 or self.branch.sample != self.motion.numbers
                return _degrees(sizes[0]) if varied or not self.motion.free else None
        return None


def _angle(story: Story, body: str, stop: Stop, before: bool) -> float | None:
    happening = story.happenings[stop.number - 1]
    if happening.centres is None:
        return None
    normal = floats(happening.centres)
    velocity = floats((happening.before if before else happening.after)[body])
    if still(velocity):
        return None
    across, along = abs(velocity.dot(normal)), abs(velocity.cross(normal))
    return math.atan2(along, across) if stop.kind == "circle" else math.atan2(across, along)


def _letter(story: Story, name: str, now: int) -> float | None:
    """A letter, or what a name of the statement stands for, in radians."""
    try:
        value = story.evaluator(now).value(TreeLetter(name))
        return float(value.measure() if hasattr(value, "measure") else value)
    except (RestitutionError, ArithmeticError, LookupError, TypeError, ValueError):
        return None


def _degrees(radians: float) -> Layout:
    size = math.degrees(radians)
    near = round(2 * size) / 2
    return Degrees(Number(f"{near:g}") if abs(near - size) < 1e-9 else lay.decimal_number(size))
