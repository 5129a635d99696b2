"""A plan of paths in words: the values that it is drawn for, and sentences that tell it."""

from __future__ import annotations

from collections.abc import Sequence

from restitution.counting import listed
from restitution.drawing.describe import values_of
from restitution.drawing.known import Known
from restitution.render import layout as lay
from restitution.render.layout import Layout
from restitution.render.text import to_text
from restitution.solving.story.forward import Story
from restitution.staging.flights import given_places
from restitution.staging.geometry import floats, length
from restitution.staging.plan import Plan
from restitution.staging.values import Chosen, PartInNumbers, drawn_for

_NEAR = 1e-6
_SAME = 1e-9


def note(plan: Plan, numbers: PartInNumbers) -> Layout | None:
    """The values by which letters are drawn."""
    chosen: list[Chosen] = []
    for events in _together(plan):
        chosen += [choice for choice in drawn_for(numbers, events) if choice not in chosen]
    if plan.scale is not None:
        places = _places(numbers.story)
        chosen += [
            choice
            for choice, moved in numbers.free
            if choice not in chosen
            and (moved is None or not _in_proportion(places, _places(moved)))
        ]
    words = values_of(chosen)
    return lay.Phrase(words) if words else None


def _together(plan: Plan) -> list[list[int]]:
    """The numbers of the events, in groups without a sphere in common."""
    groups: list[tuple[set[str], list[int]]] = []
    for stop in plan.stops:
        names, numbers = set(stop.centres), [stop.number]
        for group in [group for group in groups if group[0] & names]:
            groups.remove(group)
            names, numbers = names | group[0], group[1] + numbers
        groups.append((names, numbers))
    return [sorted(numbers) for _, numbers in groups]


def _places(story: Story) -> list[float]:
    """Everything that is known of places, as numbers in a fixed order."""
    given = given_places(story)
    known = [*given.starts.values(), *given.origins.values(), *given.points.values()]
    known += [end for ends in given.segments.values() for end in ends]
    known += [centre for centre, _ in given.circles.values()]
    known += [
        floats(where)
        for track in story.tracks.values()
        for _, where, _ in track.places
        if where is not None
    ]
    sizes = [radius for _, radius in given.circles.values()]
    return [x for place in known for x in place] + sizes + [given.radius or 0.0]


def _in_proportion(one: Sequence[float], other: Sequence[float]) -> bool:
    """Whether the second places are the first on another scale."""
    largest = max(map(abs, one), default=0.0)
    if len(one) != len(other) or not largest:
        return one == other
    k = next(k for k, x in enumerate(one) if abs(x) == largest)
    ratio = other[k] / one[k]
    return all(abs(y - ratio * x) < _SAME * largest * abs(ratio) for x, y in zip(one, other))


# --- in words -------------------------------------------------------------------------------------


def description(plan: Plan, values: Known) -> str:
    """The picture in sentences, for those who do not see it."""
    sentences = ["Plan view"]
    for stop in plan.stops:
        names = list(stop.centres)
        if stop.kind == "spheres":
            sentence = f"{names[0]} strikes {names[1]}"
        elif stop.kind == "kick":
            sentence = f"{names[0]} receives an impulse"
        elif stop.kind == "arrival":
            point = next(
                (n for n, p in plan.points.items() if length(p - stop.contact) < _NEAR), stop.wall
            )
            sentence = f"{names[0]} comes to {point or 'a point'}"
        else:
            sentence = f"{names[0]} strikes the wall {stop.wall}"
        sentence = f"{stop.number}: {sentence}"
        if stop.kind == "wall":
            before = values.angle(names[0], stop, before=True)
            after = values.angle(names[0], stop, before=False)
            if before is not None:
                sentence += f" at {to_text(before)} to it"
            if after is not None:
                sentence += f" and leaves at {to_text(after)} to it"
        speeds = [
            f"{name} moves at {to_text(speed)}"
            for name in names
            if stop.kind != "arrival" and (speed := values.speed(name, stop.number)) is not None
        ]
        if speeds:
            sentence += f"; afterwards {listed(speeds)}"
        sentences.append(sentence)
    if plan.scale is None:
        sentences.append("Angles are true, lengths are free")
    if plan.side_by_side:
        sentences.append("Paths along one line are drawn side by side")
    return ". ".join(sentences) + "."
