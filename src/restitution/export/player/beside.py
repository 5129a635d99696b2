"""The motion of a mistake beside the true one: two motions of one clock, and what is wrong.

A motion of the data then has ``beside``: ``{"label", "says", "motion"}``, where ``says`` are
sentences on what cannot be in the altered motion. Each is worked out from its numbers.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

from restitution.errors import UnsupportedError
from restitution.explaining.mistakes.consequences import (
    NO_IMPACT,
    AlteredWorld,
    altered_world,
    applying,
)
from restitution.explaining.mistakes.misconceptions import misconception, mistake_id
from restitution.export.player.data import Object, of_motions
from restitution.motion.parts import PartMotion, motions
from restitution.motion.pieces import Piece, Struck
from restitution.solving.equations.solution import Solution
from restitution.vector import Vector

_SMALL = 1e-6
_FEW = 3


def of_mistake(
    solution: Solution, mistake: str, part: str | None = None, seconds: float | None = None
) -> Object:
    """The motions of a solved problem, each with that of a mistake, or of one variant, beside it.

    Raises what `data.of_solution` raises, StatementError for an unknown id, and UnsupportedError
    where the mistake alters no motion here.
    """
    world = world_to_play(solution, mistake)
    true = motions(solution, part)
    altered_ = motions(world.solution, part, true[0].numbers.numbers)
    data = of_motions(true, solution.problem.title, seconds)
    for number, (shown, motion) in enumerate(zip(data["motions"], true, strict=True)):
        alike = _twin(motion, altered_, number)
        if alike is None:
            continue
        twin = _in_place(motion, alike)
        (other,) = of_motions([twin], None, seconds)["motions"]
        _in_step(shown, other)
        shown["beside"] = {
            "label": f"{world.id}: {world.words}",
            "says": list(sentences(twin)),
            "motion": other,
        }
    if not any("beside" in shown for shown in data["motions"]):
        raise UnsupportedError(f"the motion of {world.id} cannot be shown: it has other bodies")
    return data


def world_to_play(solution: Solution, mistake: str) -> AlteredWorld:
    """The first world of a mistake, or that of one variant, in which the motion is altered.

    One that changes an answer is taken before one that does not. Raises UnsupportedError.
    """
    about = misconception(mistake)
    mistake = mistake_id(mistake)
    if not any(variant.laws for variant in about.variants if mistake in (variant.id, about.id)):
        these = [
            applied
            for applied in applying(solution.problem)
            if any(variant.laws for variant in misconception(applied).variants)
        ]
        raise UnsupportedError(
            f"{mistake} changes a result and not the motion, so that there is nothing to play; "
            f"these change the motion: {', '.join(these) or 'none'}"
        )
    unchanged: list[AlteredWorld] = []
    reasons: list[UnsupportedError] = []
    for variant in about.variants:
        if not variant.laws or mistake not in (variant.id, about.id):
            continue
        try:
            world = altered_world(solution, variant)
        except UnsupportedError as error:
            reasons.append(error)
            continue
        if not any(part.branches for part in world.solution.parts.values()):
            reasons.append(UnsupportedError(f"{variant.id} leads to no motion here"))
        elif world.items:
            return world
        else:
            unchanged.append(world)
    if not unchanged:
        raise next((reason for reason in reasons if NO_IMPACT not in reason.message), reasons[0])
    return unchanged[0]


def _twin(motion: PartMotion, others: Sequence[PartMotion], number: int) -> PartMotion | None:
    """The altered motion of the same part and bodies; None where the mistake leaves none."""
    alike = [
        other
        for other in others
        if set(other.labels) & set(motion.labels) and set(other.bodies) == set(motion.bodies)
    ]
    return alike[min(number, len(alike) - 1)] if alike else None


def _in_place(true: PartMotion, other: PartMotion) -> PartMotion:
    """The altered motion with the places and times of the true one, where there is one impact.

    Else lengths that the question leaves open may be others in the two.
    """
    if len(true.events) != 1 or len(other.events) != 1:
        return other
    ((number, event),), ((_, changed),) = true.events, other.events
    if not isinstance(event, Struck) or not isinstance(changed, Struck):
        return other
    struck = replace(event, after=changed.after, impulse=changed.impulse)
    after = dict(zip((event.first, event.second), changed.after, strict=True))
    tracks = tuple(
        replace(
            track,
            pieces=tuple(_turned(piece, event.time, after[track.name]) for piece in track.pieces),
        )
        for track in true.motion.tracks
    )
    motion = replace(true.motion, tracks=tracks, impacts=(struck,))
    return replace(other, motion=motion, events=((number, struck),))


def _turned(piece: Piece, time: float, velocity: Vector) -> Piece:
    """A piece, or one with another velocity where it begins at a time."""
    return replace(piece, velocity=velocity) if piece.start >= time else piece


def _in_step(one: Object, other: Object) -> None:
    """Both from the same time to the same time, by which last flights are made longer."""
    start, end = min(one["start"], other["start"]), max(one["end"], other["end"])
    for motion in (one, other):
        motion["start"], motion["end"] = start, end
        for sphere in motion["spheres"]:
            first, last = sphere["pieces"][0], sphere["pieces"][-1]
            early = first[0] - start
            first[2] -= first[4] * early
            first[3] -= first[5] * early
            first[0] = start
            last[1] = end


# --- what is wrong --------------------------------------------------------------------------------


def sentences(motion: PartMotion) -> tuple[str, ...]:
    """What cannot be in an altered motion, the plainest first; each by its numbers."""
    contradictions = [
        sentence
        for _, event in motion.events
        if isinstance(event, Struck)
        for sentence in _of_impact(event, motion)
    ]
    ranked = sorted(contradictions, key=lambda entry: entry[0])
    return tuple(dict.fromkeys(text for _, text in ranked))[:_FEW]


def _of_impact(event: Struck, motion: PartMotion) -> Iterator[tuple[int, str]]:
    c = event.line_of_centres
    spheres = set(motion.bodies)
    wall = event.second not in spheres
    (u1, u2), (v1, v2) = event.before, event.after
    fastest = max(map(_size, (u1, u2, v1, v2)))
    small = _SMALL * fastest
    separation = float((v2 - v1).dot(c))
    if separation < -small:
        yield (
            0,
            f"{event.first} goes through {event.second}."
            if wall
            else f"{event.first} and {event.second} pass through each other.",
        )
    yield from _of_energy(event, motion, wall, small)
    if not wall:
        yield from _of_momentum(event, motion, small)
    for name, u, v in ((event.first, u1, v1), *(() if wall else ((event.second, u2, v2),))):
        across = float(c.cross(v) - c.cross(u))
        if abs(across) > small:
            line = f"parallel to {event.second}" if wall else "across the line of centres"
            yield 3, f"The component of {name} {line} changes, though nothing pushes it that way."
    wanted = event.e * float((u1 - u2).dot(c))
    if separation >= -small and abs(separation - wanted) > small:
        if separation > small:
            what = f"{event.first} rebounds" if wall else "They separate"
            text = f"{what} at {_figure(separation)}, and e times the approach is"
        else:
            what = f"{event.first} does not leave {event.second}" if wall else "They do not part"
            text = f"{what}, and e times the approach is"
        yield 4, f"{text} {_figure(wanted)}."


def _of_energy(
    event: Struck, motion: PartMotion, wall: bool, small: float
) -> Iterator[tuple[int, str]]:
    (u1, u2), (v1, v2) = event.before, event.after
    if wall:
        if _size(v1) > _size(u1) + small:
            yield (
                1,
                (
                    f"{event.second} speeds {event.first} up, from {_figure(_size(u1))} to "
                    f"{_figure(_size(v1))}: energy from nothing."
                ),
            )
        return
    masses = motion.masses
    if event.first not in masses or event.second not in masses:
        return
    m1, m2 = masses[event.first], masses[event.second]
    before, after = ((m1 * _size(a) ** 2 + m2 * _size(b) ** 2) / 2 for a, b in ((u1, u2), (v1, v2)))
    if after > before * (1 + _SMALL):
        yield (
            1,
            (
                f"The kinetic energy grows from {_figure(before)} to {_figure(after)}: energy from "
                "nothing."
            ),
        )


def _of_momentum(event: Struck, motion: PartMotion, small: float) -> Iterator[tuple[int, str]]:
    masses = motion.masses
    if event.first not in masses or event.second not in masses:
        return
    m1, m2 = masses[event.first], masses[event.second]
    c = event.line_of_centres
    before, after = (float((a * m1 + b * m2).dot(c)) for a, b in (event.before, event.after))
    if abs(after - before) > (m1 + m2) * small:
        yield (
            2,
            (
                f"The momentum along the line of centres changes from {_figure(before)} to "
                f"{_figure(after)}, though nothing acts from outside."
            ),
        )


def _size(v: Vector) -> float:
    return math.hypot(float(v.x), float(v.y))


def _figure(x: float) -> str:
    """A number to three figures, with a true minus sign."""
    return f"{x:.3g}".replace("-", "\N{MINUS SIGN}")


__all__ = ["of_mistake", "sentences", "world_to_play"]
