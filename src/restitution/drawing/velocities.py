"""The velocities at an event as arrows, with their components and their labels."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from restitution.drawing.angles import has_room, put_angle, put_deflection
from restitution.drawing.event import (
    LONGEST_LABEL,
    RADIUS,
    UP,
    ZERO,
    Body,
    Drawing,
    View,
    beside,
    is_on_axes,
    room_beside,
)
from restitution.drawing.geometry import sides_towards
from restitution.drawing.sayings import has_letters
from restitution.drawing.scene import Arrow, Label, RightAngle
from restitution.exact import tidy
from restitution.exact.symbols import multiple_of_a_symbol, substituted, symbol_names, symbols_in
from restitution.expression.tree import Letter
from restitution.problem import Impact, Let
from restitution.render import layout as lay
from restitution.render.glyphs import outline
from restitution.render.layout import Layout
from restitution.render.short import is_short
from restitution.render.text import to_text
from restitution.staging.geometry import direction
from restitution.staging.values import When
from restitution.vector import Vector

TINY = 1.5  # no arrow is shorter, or it could not be seen
_SEEN = 0.6  # a component that is shorter has no label
_NARROW = 2.7  # a triangle with a shorter side is not drawn
_MARK = 0.28  # of the shorter side of a triangle is the mark of its right angle
_WIDEST = 5.6  # of a label of a component, in em


def _arrives(body_towards: Vector | None, velocity: Vector, when: When) -> bool:
    """Whether an arrow is drawn as ending at the circle rather than as starting from it.

    Before an impact it is, where it would run through what the sphere strikes.
    """
    if when == "after" or body_towards is None:
        return False
    return bool(velocity.dot(body_towards) > ZERO * math.hypot(*velocity))


def put_velocity(view: View, body: Body, when: When, scale: float, drawing: Drawing) -> None:
    """A velocity as an arrow, with all that is said of it; ``scale`` is in mm for 1 m/s."""
    v = view.velocity(body.name, when)
    words = view.words(body.name, when)
    size = math.hypot(*v)
    if size * scale < 1e-6:
        drawing.labels.append(
            Label(lay.Words("at rest"), body.centre, sides_towards(-UP), RADIUS + 0.8, 2.6)
        )
        _sense_of_nothing(view, body, when, body.centre + UP * RADIUS, drawing)
        return
    course, length = v / size, max(TINY, size * scale)
    arriving = _arrives(body.towards, v, when)
    tail = body.centre - course * (RADIUS + length) if arriving else body.centre + course * RADIUS
    lifted = None if arriving else _lifted(view, body, course, length)
    tail = tail if lifted is None else lifted
    tip = tail + course * length
    drawing.shapes.append(Arrow("velocity", tail, tip))
    along, across = v.dot(view.n) * scale, v.dot(view.t) * scale
    rim, far = (tip, tail) if arriving else (tail, tip)
    corner = rim + view.t * (far - rim).dot(view.t)
    turned = not all(
        has_room(angle, rim, far, corner, index) for index, angle in enumerate(words.angles)
    )
    if view.question:
        _as_given(view, body, when, (tail, tip), drawing)
    elif abs(along) < 1e-6 or abs(across) < 1e-6:
        _in_one_direction(view, body, when, tail, tip, drawing)
        if abs(along) < 1e-6 and size * scale >= TINY:
            end = tail if arriving else tip
            _sense_of_nothing(view, body, when, end, drawing)
    else:
        _triangle(view, body, when, (tail, tip), Vector(along, across), drawing, turned=turned)
    for index, angle in enumerate(words.angles):
        hidden = view.question or _is_narrow(Vector(along, across))
        leg = 0.0 if hidden or turned else abs(across)
        put_angle(view, body, angle, (tail, tip), arriving, leg, index, drawing)
    if when == "after":
        put_deflection(view, body, tail, length, len(words.angles), drawing)


def _as_given(
    view: View, body: Body, when: When, arrow: tuple[Vector, Vector], drawing: Drawing
) -> None:
    """The label of a velocity as the statement gives it, if it does."""
    words = view.words(body.name, when)
    label = words.size or words.vector
    if label is not None:
        tail, tip = arrow
        drawing.labels.append(beside(label, tail, tip, _clear_side(body, direction(tip - tail))))


def _in_one_direction(
    view: View, body: Body, when: When, tail: Vector, tip: Vector, drawing: Drawing
) -> None:
    """The label of a velocity along the line of centres, or across it."""
    words = view.words(body.name, when)
    parts = _components(view, body, when)
    course = direction(tip - tail)
    along = abs(course.dot(view.n)) > abs(course.dot(view.t))
    axis, part = (view.n, parts[0]) if along else (view.t, parts[1])
    outward = _clear_side(body, course)
    label = words.size
    if label is None and view.kind == "blow":
        label = words.vector
    if label is None and part is not None:
        value = (tip - tail).dot(axis)
        label = _directed(part, axis, value, (tail + tip) / 2, outward, drawing)
    elif label is None:
        label = words.vector
    if label is not None:
        drawing.labels.append(beside(label, tail, tip, outward))


def _triangle(
    view: View,
    body: Body,
    when: When,
    arrow: tuple[Vector, Vector],
    parts: Vector,
    drawing: Drawing,
    *,
    turned: bool,
) -> None:
    """The components of a velocity, from its tail to its tip, with their labels and its own.

    Next to the sphere stands the component across, so that no other lies on the line of centres;
    the other if they are ``turned``, to leave room for an angle.
    """
    tail, tip = arrow
    along, across = parts
    labels = _components(view, body, when)
    if _is_narrow(parts):
        _beside_narrow(view, body, (tail, tip), parts, labels, drawing)
        _own_label(view, body, when, (tail, tip), tail + view.t * across, drawing)
        return
    legs = [(view.t, across, labels[1]), (view.n, along, labels[0])]
    if turned != (math.hypot(*(tip - body.centre)) < math.hypot(*(tail - body.centre))):
        legs.reverse()
    corner = tail + legs[0][0] * legs[0][1]
    ends = (tail, corner), (corner, tip)
    seen = [math.hypot(*(end - start)) >= _SEEN for start, end in ends]
    unlabelled = [part is None or _layout(part) is None for _, _, part in legs]
    if all(unlabelled):  # lines without a word
        _own_label(view, body, when, (tail, tip), corner, drawing)
        return
    drawing.shapes += [Arrow("component", *leg) for leg in ends]
    inside = (tail + tip + corner) / 3
    for (start, end), (axis, value, part), long in zip(ends, legs, seen):
        middle = (start + end) / 2
        outward = axis.turned_left()
        outward = outward if outward.dot(middle - inside) > 0 else -outward
        if not long:  # or its label would seem to name the velocity
            continue
        label = None if part is None else _directed(part, axis, value, middle, outward, drawing)
        if label is not None:
            drawing.labels.append(beside(label, start, end, outward))
    sides = direction(tail - corner), direction(tip - corner)
    size = min(1.3, _MARK * min(abs(along), abs(across)))
    drawing.shapes.append(RightAngle(corner, *sides, size))
    _own_label(view, body, when, (tail, tip), corner, drawing)


def _is_narrow(parts: Vector) -> bool:
    """Whether a triangle of components would lie under the arrow of the velocity itself."""
    return bool(min(abs(parts.x), abs(parts.y)) < _NARROW)


def _beside_narrow(
    view: View,
    body: Body,
    arrow: tuple[Vector, Vector],
    parts: Vector,
    labels: tuple[Any, Any],
    drawing: Drawing,
) -> None:
    """The components of a velocity as small arrows of their senses, beside it and at its end.

    The end is the one away from the sphere.
    """
    tail, tip = arrow
    end = max(arrow, key=lambda vector: math.hypot(*(vector - body.centre)))
    beyond = 1.0 if end is tip else -1.0
    legs = [(view.t, parts.y, labels[1]), (view.n, parts.x, labels[0])]
    for (axis, value, part), (other, across, _) in zip(legs, reversed(legs), strict=True):
        if part is None:
            continue
        if abs(value) > abs(across):
            at, outward = (tail + tip) / 2, other * (-1.0 if across > 0 else 1.0)
        else:
            at, outward = end, other * (beyond if across > 0 else -beyond)
        label = _directed(part, axis, value, at, outward, drawing)
        if label is not None:
            _sense(label, axis * (1.0 if value > 0 else -1.0), at, outward, drawing)


def _own_label(
    view: View,
    body: Body,
    when: When,
    arrow: tuple[Vector, Vector],
    corner: Vector,
    drawing: Drawing,
) -> None:
    """The label of a velocity itself, on the side away from its components."""
    words = view.words(body.name, when)
    label = words.size
    if label is None and not is_on_axes(view):
        label = words.vector
    if label is None and view.kind == "blow":
        label = words.vector or lay.Bold("u" if when == "before" else "v")
    if label is not None:
        tail, tip = arrow
        drawing.labels.append(beside(label, tail, tip, direction((tail + tip) / 2 - corner)))


def _clear_side(body: Body, course: Vector) -> Vector:
    """The side of an arrow on which its label has room: above, or away from what is struck."""
    left = course.turned_left()
    if body.towards is not None and abs(left.dot(body.towards)) > 0.3:
        return left if left.dot(body.towards) < 0 else -left
    return left if left.y > 0 or (abs(left.y) < ZERO and left.x < 0) else -left


def _lifted(view: View, body: Body, course: Vector, length: float) -> Vector | None:
    """Where an arrow starts that would else run over the other sphere: beside its own."""
    if view.kind != "spheres" or body.towards is None:
        return None
    start, other = body.centre + course * RADIUS, body.centre + body.towards * (2 * RADIUS)
    share = min(length, max(0.0, (other - start).dot(course)))
    if math.hypot(*(start + course * share - other)) > RADIUS + 0.5:
        return None
    side = body.towards.turned_left()
    if abs(side.dot(course)) > 1e-6:
        side = side if side.dot(course) > 0 else -side
    else:
        side = side if side.y > 0 or (abs(side.y) < ZERO and side.x < 0) else -side
    return body.centre + side * (RADIUS + 1.5)


def _components(view: View, body: Body, when: When) -> tuple[Any, Any]:
    """The components along and across in the letters of the working, or by their values.

    A velocity that the statement gives has components as given.
    """
    model, number, name = view.motion.model, view.number, body.name
    given = _given(view, body, when)
    if view.kind == "blow":
        v = model.happening(number).before[name] if given is None else given
        if given is None and when == "after":
            return None, None
        return _in_letters(view, _by_now(view, v.x)), _in_letters(view, _by_now(view, v.y))
    frame = model.frames[number]
    along, across = model.before(number, name)
    if when == "after" and model.problem.altered_at(number) is not None:
        along = model.components[number, name].symbol
        across = model.altered_across(number, name)
    elif given is not None and (when == "after" or _is_hidden(view, along)):
        along = tidy(given.dot(frame.n))
        across = tidy(given.dot(frame.t)) if _is_hidden(view, across) else across
    elif when == "after":
        step = model.happening(number).step
        assert isinstance(step, Impact)
        rebound = -model.happening(number).e * along
        along = model.components[number, name].symbol
        if view.kind == "wall" and (step.e is None or isinstance(step.e, Letter)):
            e = model.happening(number).e
            along = rebound if symbol_names(e) and _layout(rebound) is not None else along
    return _in_letters(view, _by_now(view, along)), _in_letters(view, _by_now(view, across))


def has_numbers(view: View, panels: Sequence[When]) -> bool:
    """Whether speeds are shown as numbers, which have units that letters have with them."""
    for body in view.bodies:
        for when in panels:
            v, words = view.velocity(body.name, when), view.words(body.name, when)
            if words.size is not None and not has_letters(words.size):
                return True
            shown = zip(_components(view, body, when), (v.dot(view.n), v.dot(view.t)), strict=True)
            if any(getattr(x, "is_number", False) and abs(y) > 1e-6 for x, y in shown):
                return True
    return False


def _in_letters(view: View, x: Any) -> Any:
    """The same without letters of components that the working does not introduce.

    It introduces those of two spheres where it is not known, and calls what a wall changes by name.
    """
    model = view.motion.model
    own = {component.symbol: component for component in model.components.values()}
    given = {step.letter for _, step in model.problem.steps() if isinstance(step, Let)}
    known = given if view.letters is None else given | {*view.letters.values()}
    present = symbols_in(x)
    foreign = {
        symbol: component.value
        for symbol, component in own.items()
        if symbol in present and symbol.name not in known
        if view.letters is not None or model.frames[component.number].wall is not None
    }
    return tidy(substituted(x, foreign)) if foreign else x


def _by_now(view: View, x: Any) -> Any:
    """What letters of earlier impacts add up to; one that stands alone is still the clearest."""
    components = {
        component.symbol: component.value
        for (number, _), component in view.motion.model.components.items()
        if number < view.number
    }
    earlier = symbols_in(x) & set(components)
    if not earlier or x in earlier or -x in earlier:
        return x
    value = tidy(substituted(x, components))
    return x if _layout(value) is None else value


def _given(view: View, body: Body, when: When) -> Vector | None:
    """A velocity in letters, if the statement gives it."""
    given = view.words(body.name, when).given
    if given is None:
        return None
    tree, now = given
    v = view.motion.model.story.evaluator(now).vector(tree)
    return Vector(tidy(v.x), tidy(v.y))


def _is_hidden(view: View, x: Any) -> bool:
    """Whether this is a letter for what the statement does not name: a component at the start."""
    return getattr(x, "name", "") in view.motion.model.unknowns.names.values()


def _layout(x: Any) -> Layout | None:
    if any(not name[:1].isalpha() for name in symbol_names(x)):
        return None  # what has no letter, such as a radius that is not given
    if not is_short(x):
        return _decimal_size(x)
    layout = lay.from_sympy(x)
    if len(to_text(layout)) > LONGEST_LABEL:
        return None
    left, _, right, _ = outline(layout).box
    return layout if right - left <= _WIDEST else None


def _decimal_size(x: Any) -> Layout | None:
    """The size of a multiple of a positive letter of which the exact form is long: ``0.634u``."""
    multiple = multiple_of_a_symbol(x)
    if multiple is None:
        return None
    number, letter = multiple
    size = lay.decimal_number(abs(number))
    if letter is None:
        return size
    return lay.product(size, lay.from_sympy(letter)) if letter.is_positive else None


def _directed(
    part: Any, axis: Vector, value: float, at: Vector, outward: Vector, drawing: Drawing
) -> Layout | None:
    """The label of a component whose arrow is drawn: its size, if that is short.

    A letter counted positive the other way gets a small arrow for its sense instead.
    """
    if not is_short(part):
        return _layout(part)
    sign, size = lay.split_sign(lay.from_sympy(part))
    sense = axis if sign == "+" else -axis
    if sense.dot(axis * value) >= 0:
        return size if _layout(part) is not None else None
    if isinstance(size, lay.Letter):
        _sense(size, sense, at, outward, drawing)
        return None
    return _layout(tidy(-part) if sign == "+" else part)


def _sense(label: Layout, sense: Vector, at: Vector, outward: Vector, drawing: Drawing) -> None:
    """A small arrow for the sense in which a letter is positive, beside a point."""
    best: tuple[float, Arrow] | None = None
    pieces = list(drawing.ink())
    for off in (1.6, 3.2, -1.6, 4.8, -3.2):
        for along in (0.0, 3.0, -3.0):
            middle = at + outward * off + sense * along
            arrow = Arrow("sense", middle - sense * 2.2, middle + sense * 2.2)
            room = min(room_beside(arrow, pieces), 1.4)
            if best is None or room > best[0] + 0.1:
                best = room, arrow
    assert best is not None
    _, arrow = best
    drawing.shapes.append(arrow)
    drawing.labels.append(beside(label, arrow.start, arrow.end, outward))


def _sense_of_nothing(view: View, body: Body, when: When, at: Vector, drawing: Drawing) -> None:
    """The letter of a component that is found to be zero, with its sense."""
    if when == "before" or view.kind == "blow" or view.words(body.name, when).given is not None:
        return
    part = _components(view, body, when)[0]
    sign, size = lay.split_sign(lay.from_sympy(part))
    if isinstance(size, lay.Letter):
        _sense(size, view.n if sign == "+" else -view.n, at, direction(at - body.centre), drawing)
