"""A picture of an impact in words: its title, and sentences for those who do not see it.

The sentences tell what is drawn: how fast each sphere moves, at which angle to the line of centres
or to the wall and on which side, as it is at the values that the letters are drawn at.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from fractions import Fraction

from restitution.counting import listed, ordinal
from restitution.drawing.sayings import Sayings, has_letters, state_after
from restitution.exact import significant
from restitution.problem import Impact, Kick
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.render.text import to_text
from restitution.shapes import Circle
from restitution.staging.values import Chosen, PartInNumbers, When, axes, drawn_for, unit_of_speed
from restitution.vector import Vector

IMPOSSIBLE = "This impact is not possible: e would not lie in [0, 1]."
_NEAR = 1e-9


def is_possible(motion: PartInNumbers, number: int) -> bool:
    """Whether the coefficient of restitution that is found for an event lies in [0, 1]."""
    e = motion.story.happenings[number - 1].e
    return e is None or -_NEAR <= float(e) <= 1 + _NEAR


def title(motion: PartInNumbers, number: int, panels: Sequence[When]) -> str:
    """``Before and after: A hits B``; of several alike, which of them: ``for the second time``."""
    step = motion.story.happenings[number - 1].step
    if isinstance(step, Kick):
        heading = f"{step.body} receives an impulse"
    else:
        assert isinstance(step, Impact)
        heading = f"{step.first} hits {step.second}"
        alike = [
            happening.number
            for happening in motion.story.happenings
            if isinstance(happening.step, Impact)
            and {happening.step.first, happening.step.second} == {step.first, step.second}
        ]
        if len(alike) > 1:
            heading += f" for the {ordinal(alike.index(number) + 1)} time"
    return f"{' and '.join(panels).capitalize()}: {heading}"


def description(motion: PartInNumbers, number: int, panels: Sequence[When]) -> str:
    """The picture of one event in sentences.

    Speeds are to three significant figures, as multiples of a letter where they all are, else in
    m s⁻¹; angles are in degrees.
    """
    step = motion.story.happenings[number - 1].step
    chosen = drawn_for(motion, (number,), panels)
    sentences = [_setting(motion, number)]
    for when in panels:
        bodies = _bodies(motion, number)
        moving = [_moving(motion, number, body, when) for body in bodies]
        sentences.append(f"{when.capitalize()}: {'; '.join(moving)}.")
    happening = motion.story.happenings[number - 1]
    if (
        isinstance(step, Impact)
        and "after" in panels
        and not happening.altered
        and any(float(x) for x in happening.impulse or (0.0, 0.0))
    ):
        if step.second in motion.story.walls:
            sentences.append(f"The impulse on {step.first} is perpendicular to {step.second}.")
        else:
            sentences.append(
                f"The impulses on {step.first} and {step.second} are equal and opposite, "
                "along the line of centres."
            )
    if not is_possible(motion, number):
        sentences.append(IMPOSSIBLE)
    elif chosen:
        sentences.append(f"Drawn for {listed([to_text(_equal(choice)) for choice in chosen])}.")
    return " ".join(sentences)


def question(motion: PartInNumbers, number: int, sayings: Sayings, *, to_scale: bool) -> str:
    """What the statement gives of one event, and nothing that follows from it."""
    sentences = [_setting(motion, number)]
    for body in _bodies(motion, number):
        words = sayings.of(body, state_after(motion, body, number - 1))
        if math.hypot(*motion.before(number, body)) < _NEAR:
            sentences.append(f"{body} is at rest.")
        elif words.size is not None:
            unit = "" if has_letters(words.size) else " m s⁻¹"
            sentences.append(f"{body} moves at {to_text(words.size)}{unit}.")
        elif words.vector is not None:
            sentences.append(f"{body} moves with velocity {to_text(words.vector)}.")
    return " ".join(sentences if to_scale else [*sentences, "Not to scale."])


def _value_of(chosen: Chosen) -> Layout:
    """The value at which a letter is drawn; a decimal is rounded to three figures."""
    exact = isinstance(chosen.value, Fraction)
    value = lay.from_sympy(chosen.value) if exact else lay.decimal_number(chosen.value)
    return lay.Degrees(value) if chosen.angle else value


def values_of(chosen: Sequence[Chosen]) -> tuple[Layout, ...]:
    """``Drawn for α = 40° and e = ½.``, as words of a note; none where nothing was chosen."""
    if not chosen:
        return ()
    ends = [*("," for _ in chosen[2:]), *(" and" for _ in chosen[:1] if len(chosen) > 1), "."]
    return (
        lay.Words("Drawn for"),
        *(lay.Phrase((_equal(choice), lay.Words(end)), "") for choice, end in zip(chosen, ends)),
    )


def _equal(chosen: Chosen) -> Layout:
    return lay.Relation((lay.letter(chosen.name), _value_of(chosen)), ("=",))


def _bodies(motion: PartInNumbers, number: int) -> list[str]:
    happening = motion.story.happenings[number - 1]
    return [name for name in happening.bodies if name in motion.story.spheres]


def _setting(motion: PartInNumbers, number: int) -> str:
    """What strikes what, and how the line of centres or the wall lies on paper."""
    happening = motion.story.happenings[number - 1]
    step = happening.step
    if isinstance(step, Kick):
        assert happening.impulse is not None
        heading = _heading(Vector(*(float(x) for x in happening.impulse)))
        return f"{step.body} receives an impulse {heading}."
    assert isinstance(step, Impact)
    frame = motion.model.frames[number]
    n, _ = axes(motion, number)
    if frame.wall is not None:
        wall = motion.story.walls[frame.wall]
        lies = _inclination(n.turned_left())
        if isinstance(wall.shape, Circle):
            return (
                f"{step.first} touches the circular wall {wall.name}, whose tangent there {lies}."
            )
        return f"{step.first} touches the wall {wall.name}, which {lies}."
    lies = _inclination(n)
    return f"{step.first} and {step.second} touch; their line of centres {lies}."


def _inclination(v: Vector) -> str:
    angle = math.degrees(math.atan2(v.y, v.x)) % 180.0
    if min(angle, 180.0 - angle) < _NEAR:
        return "is horizontal"
    if abs(angle - 90.0) < _NEAR:
        return "is vertical"
    side, rise = ("right", angle) if angle < 90 else ("left", 180.0 - angle)
    return f"rises to the {side} at {_degrees(rise)}"


def _sense(v: Vector) -> str:
    """The nearest of four directions on paper."""
    if abs(v.x) > abs(v.y):
        return "to the right" if v.x > 0 else "to the left"
    return "upwards" if v.y > 0 else "downwards"


def _heading(v: Vector) -> str:
    """``to the right``, ``at 37° above the right``: the direction of an arrow on paper."""
    angle = math.degrees(math.atan2(v.y, v.x))
    for name, at in (("to the right", 0.0), ("upwards", 90.0), ("downwards", -90.0)):
        if abs(angle - at) < 1e-7:
            return name
    if abs(abs(angle) - 180.0) < 1e-7:
        return "to the left"
    side = "right" if abs(angle) < 90 else "left"
    tilt = min(abs(angle), 180.0 - abs(angle))
    return f"to the {side}, {_degrees(tilt)} {'above' if angle > 0 else 'below'} the horizontal"


def _moving(motion: PartInNumbers, number: int, body: str, when: When) -> str:
    """``A moves at 5 m s⁻¹ at 53.1° to the line of centres, towards B``."""
    get = motion.before if when == "before" else motion.after
    v = get(number, body)
    size = math.hypot(*v)
    if size < _NEAR:
        return f"{body} is at rest"
    moves = f"{body} moves at {_speed(motion, number, size)}"
    happening = motion.story.happenings[number - 1]
    step = happening.step
    if isinstance(step, Kick):
        return f"{moves} {_heading(v)}"
    assert isinstance(step, Impact)
    frame = motion.model.frames[number]
    n, _ = axes(motion, number)
    along = n * (v.dot(n) / n.dot(n))
    across = v - along
    angle = math.degrees(math.atan2(math.hypot(*across), math.hypot(*along)))
    if frame.wall is not None:
        sense = "away from" if v.dot(n) > 0 else "towards"
        if angle > 90.0 - 1e-7:
            return f"{moves} along {frame.wall}, {_sense(v)}"
        if angle < 1e-7:
            return f"{moves} perpendicular to {frame.wall}, {sense} it"
        return f"{moves} at {_degrees(90 - angle)} to {frame.wall}, {sense} it and {_sense(across)}"
    if angle > 90.0 - 1e-7:
        return f"{moves} perpendicular to the line of centres, {_sense(v)}"
    c = happening.oriented()
    other = step.second if body == step.first else step.first
    side = 1.0 if body == step.first else -1.0
    near = v.dot(Vector(float(c.x), float(c.y))) * side > 0
    sense = f"towards {other}" if near else f"away from {other}"
    if angle < 1e-7:
        return f"{moves} along the line of centres, {sense}"
    return f"{moves} at {_degrees(angle)} to the line of centres, {sense} and {_sense(across)}"


def _speed(motion: PartInNumbers, number: int, size: float) -> str:
    letter = unit_of_speed(motion, (number,))
    if letter is None:
        return f"{_figures(size)} m s⁻¹"
    share = size / float(motion.numbers[letter])
    name = to_text(lay.letter(letter))
    return name if abs(share - 1) < 1e-9 else f"{_figures(share)}{name}"


def _degrees(angle: float) -> str:
    return f"{_figures(angle)}°"


def _figures(value: float) -> str:
    """A number to three significant figures, without idle zeros."""
    near = round(value)
    if near and abs(value - near) < 1e-9 * abs(near):
        return str(near)
    return significant(value)
