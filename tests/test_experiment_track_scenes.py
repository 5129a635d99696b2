"""Pictures of tracks: to scale, with the angles that the velocities make."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from restitution.drawing.ink import arc_span
from restitution.drawing.labels import place
from restitution.drawing.scene import Arc, Disc, Dot, Line, Scene, StraightWall
from restitution.drawing.svg import to_svg
from restitution.experiments.records import Position, Table, Track
from restitution.experiments.results import ClassValues, FittedTrack, Interval, StraightLine
from restitution.experiments.track_scenes import MOST_DOTS, track_scene, track_scenes
from restitution.experiments.whole import Experiment
from restitution.vector import Vector

Pair = tuple[float, float]


def track(
    body: str, at: Pair, u: Pair, v: Pair, wall: float, count: int = 8, trial: str = "1"
) -> tuple[Track, FittedTrack]:
    """Positions of a body that moves along two straight lines, and these lines."""
    rng = np.random.default_rng(count)
    positions = []
    for index in range(2 * count):
        t = 0.05 * (index + 0.5 - count)
        x, y = (p + (a if t < 0 else b) * t for p, a, b in zip(at, u, v))
        noise = rng.normal(0, 0.002, 2)
        positions.append(Position(index + 2, t, x + noise[0], y + noise[1]))
    lines = (StraightLine(0, *at, *velocity, 0.01) for velocity in (u, v))
    fit = FittedTrack(trial, body, *lines, 0.0, *at, 0.001, wall)
    return Track(trial, body, tuple(positions)), fit


def experiment_of(*pairs: tuple[Track, FittedTrack]) -> Experiment:
    tracks, fits = zip(*pairs)
    return Experiment(
        "tracks",
        Table("tracks", tracks=tracks, units={"x": "m", "t": "s"}),
        0.7,
        0.01,
        Interval(0.68, 0.72, 0.95, ""),
        "given",
        None,
        ClassValues(0.7, None, 0.7, ""),
        (),
        (),
        tracks=fits,
    )


def at_a_wall(alpha: float, e: float, wall: float, count: int = 8) -> Experiment:
    u = (math.cos(math.radians(alpha)), -math.sin(math.radians(alpha)))
    turn = math.radians(wall)
    turned = [
        (x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn))
        for x, y in (u, (u[0], -e * u[1]))
    ]
    return experiment_of(track("", (0.3, 0.1), *turned, wall, count))


def of_two(theta: float, u_a: Pair, u_b: Pair, e: float = 0.7) -> Experiment:
    n = Vector(math.cos(theta), math.sin(theta))
    blow = n * ((1 + e) * (Vector(*u_a) - Vector(*u_b)).dot(n) / 1.5)
    v_a, v_b = Vector(*u_a) - blow, Vector(*u_b) + blow * 0.5
    beside, tangent = Vector(0.3, 0.2) + n * 0.1, math.degrees(theta) + 90
    return experiment_of(
        track("A", (0.3, 0.2), u_a, tuple(v_a), tangent),
        track("B", tuple(beside), u_b, tuple(v_b), tangent),
    )


def arcs(scene: Scene) -> list[float]:
    return [
        math.degrees(arc_span(each.start, each.end))
        for each in scene.shapes
        if isinstance(each, Arc)
    ]


@pytest.mark.parametrize("wall", [0, 60, 90, 135, 180, -30, 271])
def test_angles_to_the_wall_are_marked(wall):
    (scene,) = track_scenes(at_a_wall(50, 0.7, wall))
    beta = math.degrees(math.atan(0.7 * math.tan(math.radians(50))))
    assert arcs(scene) == pytest.approx([50, beta])
    assert "at 50.0° to the wall" in scene.description
    assert f"at {beta:.1f}° to the wall" in scene.description


def test_positions_are_to_scale_and_the_wall_is_behind_the_impact():
    result = at_a_wall(40, 0.6, 20)
    (scene,) = track_scenes(result)
    dots = [each.centre for each in scene.shapes if isinstance(each, Dot)]
    positions = [Vector(each.x, each.y) for each in result.table.tracks[0].positions]
    assert len(dots) == len(positions)
    scales = [
        math.hypot(*(a - dots[0])) / math.hypot(*(b - positions[0]))
        for a, b in zip(dots[1:], positions[1:])
    ]
    assert scales == pytest.approx([scales[0]] * len(scales))
    (wall,) = (each for each in scene.shapes if isinstance(each, StraightWall))
    along = wall.end - wall.start
    assert math.degrees(math.atan2(along.y, along.x)) == pytest.approx(20)
    for dot in (dots[0], dots[-1]):
        assert (dot - wall.start).dot(wall.far) < 0


def test_line_of_centres_is_drawn_with_the_angles_of_both():
    result = of_two(0.6, (1.0, 0.2), (-0.5, 0.4))
    scene = track_scene(result, "1")
    (line,) = (
        each for each in scene.shapes if isinstance(each, Line) and each.role == "line_of_centres"
    )
    along = line.end - line.start
    assert math.atan2(along.y, along.x) % math.pi == pytest.approx(0.6)
    expected = []
    for fit in result.tracks:
        for each in (fit.before, fit.after):
            turn = math.atan2(each.velocity_y, each.velocity_x) - 0.6
            expected.append(math.degrees(math.acos(abs(math.cos(turn)))))
    assert arcs(scene) == pytest.approx(expected)
    radii = {each.radius for each in scene.shapes if isinstance(each, Disc)}
    assert len(radii) == 1  # discs that touch


def test_a_body_at_rest_has_no_angle():
    scene = track_scene(of_two(0.5, (1.0, 0.2), (0.0, 0.0)), "1")
    assert scene.description.count("B is at") == 1
    assert "After, B is at 0.0° to the line of centres" in scene.description


def test_of_many_positions_some_are_drawn():
    (scene,) = track_scenes(at_a_wall(50, 0.7, 0, count=500))
    assert sum(isinstance(each, Dot) for each in scene.shapes) <= MOST_DOTS
    assert "1000 positions" in scene.description


def test_each_trial_has_a_picture():
    pairs = [track("", (0.3, 0.1), (1, -1), (1, 0.7), 0, trial=name) for name in ("b", "a")]
    result = experiment_of(*pairs)
    assert [each.title for each in track_scenes(result)] == [
        "Tracks of trial b",
        "Tracks of trial a",
    ]
    with pytest.raises(KeyError, match="trials: b, a"):
        track_scene(result, "c")


@given(st.floats(0.5, 89.5), st.floats(0, 1), st.floats(0, 360), st.integers(2, 20))
@settings(max_examples=60)
def test_labels_find_room(alpha, e, wall, count):
    (scene,) = track_scenes(at_a_wall(alpha, e, wall, count))
    placed = place(scene)
    left, bottom, right, top = placed.box
    for label in placed.labels:
        assert left <= label.box[0] and label.box[2] <= right
        assert bottom <= label.box[1] and label.box[3] <= top
    assert to_svg(scene) == to_svg(scene)
