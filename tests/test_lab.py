"""The Lab without its page: scenes to motions, impacts to questions."""

from __future__ import annotations

import json
import math
import re
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import restitution as r
from restitution.export import lab
from restitution.export.lab.question import simple, written
from restitution.problem import Find, Impact

SCENES = Path(__file__).parent.parent / "src/restitution/web/static/lab/scenes.js"


def ball(name="A", **more):
    return {
        "name": name,
        "mass": 1,
        "radius": 0.1,
        "position": [0, 0],
        "velocity": [0, 0],
        **more,
    }


def scene(*spheres, **more):
    return {"spheres": list(spheres), "seconds": 2, **more}


def prepared() -> dict[str, dict]:
    text = SCENES.read_text(encoding="utf-8")
    rows = json.loads(text[text.index("= [") + 2 :].rstrip().removesuffix(";"))
    return {
        row["id"]: {
            "spheres": [
                {"name": n, "mass": m, "radius": a, "position": [x, y], "velocity": [vx, vy]}
                for n, m, a, x, y, vx, vy in row["spheres"]
            ],
            "walls": [
                {"name": n, "start": [x1, y1], "end": [x2, y2], "e": e}
                for n, x1, y1, x2, y2, e in row["walls"]
            ],
            "e": row["e"],
            "seconds": row["seconds"],
        }
        for row in rows
    }


# --- scenes ---------------------------------------------------------------------------------------


def test_a_scene_moves_as_the_law_says():
    """By hand: 2 kg at 2 m/s on 1 kg at rest, e = 1/2: 1 and 2 m/s after 0.4 s."""
    a = ball("A", mass=2, position=[0.5, 0.5], velocity=[2, 0])
    b = ball("B", position=[1.5, 0.5])
    told = lab.simulated(scene(a, b, e=0.5))
    (hit,) = told["motion"]["events"]
    assert hit["time"] == pytest.approx(0.4)
    assert hit["after"] == {"A": pytest.approx([1, 0]), "B": pytest.approx([2, 0])}
    assert hit["lost"] == pytest.approx(1)
    assert told["motion"]["end"] == 2
    assert told["stopped"] is None
    assert json.loads(json.dumps(told)) == told


def test_a_wall_and_a_pair_have_their_own_coefficients():
    balls = [ball("A", velocity=[0, -1]), ball("B", position=[3, 0]), ball("C", position=[5, 0])]
    balls[1]["velocity"] = [1, 0]
    wall = {"name": "W", "start": [-1, -1], "end": [1, -1], "e": 0.25}
    told = lab.simulated(scene(*balls, walls=[wall], e=1, pairs=[["C", "B", 0.5]]))
    found = {(*hit["bodies"], hit["wall"]): hit["e"] for hit in told["motion"]["events"]}
    assert found == {("A", "W"): 0.25, ("B", "C", None): 0.5}


@pytest.mark.parametrize(
    ("told", "what"),
    [
        ([], "a scene is told as an object"),
        ({"spheres": "A"}, "the spheres are a list"),
        (scene(), "there is no sphere"),
        (scene(ball(name="a b")), "named by a capital"),
        (scene(ball(mass="x")), "the mass of A is a number"),
        (scene(ball(mass=math.nan)), "the mass of A is out of bounds"),
        (scene(ball(mass=1e300)), "the mass of A is out of bounds"),
        (scene(ball(mass=True)), "the mass of A is a number"),
        (scene(ball(position=[1])), "the position of A is a pair"),
        (scene(*[ball(f"S{k}") for k in range(61)]), "61 spheres: 60 are the most"),
        (scene(ball(), seconds=1000), "the duration is 1000 s"),
        (scene(ball(), seconds=0), "the duration is 0 s"),
        (scene(ball(), impacts="many"), "number of impacts"),
        (scene(ball(), pairs=[["A"]]), "e of a pair"),
        (scene(ball(), walls=[{"name": "W", "start": [0, 0]}]), "the end of W is a pair"),
    ],
)
def test_what_is_no_scene_is_refused_by_name(told, what):
    with pytest.raises(r.StatementError, match=re.escape(what)):
        lab.simulated(told)


def test_what_cannot_be_is_told_with_the_bodies():
    told = lab.simulated(scene(ball("A"), ball("B", position=[0.15, 0])))
    assert told["motion"] is None
    assert told["error"]["bodies"] == ["A", "B"]
    assert "overlap" in told["error"]["message"]
    through = {"name": "W", "start": [-1, 0.05], "end": [1, 0.05], "e": 1}
    told = lab.simulated(scene(ball("A"), walls=[through]))
    assert told["error"]["bodies"] == ["A", "W"]
    told = lab.simulated(scene(ball("A", mass=-1)))
    assert "the mass of A is -1" in told["error"]["message"]
    told = lab.simulated(scene(ball("A"), e=2))
    assert "[0, 1]" in told["error"]["message"]


def test_rounding_is_no_overlap():
    """A page writes twelve figures: spheres in contact overlap by the thirteenth."""
    third = float(f"{2 / 30:.12g}")
    a, b = ball("A", radius=1 / 30), ball("B", radius=1 / 30, position=[third - 1e-12, 0])
    assert lab.simulated(scene(a, b))["motion"] is not None


def test_impacts_without_end_are_shown_until_then():
    """Three in line with e < 7 − 4√3 = 0.0718 collapse."""
    line = [
        ball("A", position=[-3, 0], velocity=[1, 0], radius=0.5),
        ball("B", position=[0, 0], radius=0.5),
        ball("C", position=[2, 0], velocity=[-1, 0], radius=0.5),
    ]
    told = lab.simulated(scene(*line, e=0.05, seconds=100))
    assert "inelastic collapse" in told["stopped"]
    assert 1 < told["motion"]["end"] < 2
    assert len(told["motion"]["events"]) > 10


def test_a_motion_is_followed_for_so_many_impacts():
    walls = [
        {"name": "L", "start": [0, -1], "end": [0, 1], "e": 1},
        {"name": "R", "start": [0.3, -1], "end": [0.3, 1], "e": 1},
    ]
    fast = ball("A", position=[0.15, 0], velocity=[5, 0])
    told = lab.simulated(scene(fast, walls=walls, seconds=120, impacts=10**9))
    assert len(told["motion"]["events"]) == 1000
    assert "1000 impacts" in told["stopped"]
    told = lab.simulated(scene(fast, walls=walls, seconds=120, impacts=7))
    assert len(told["motion"]["events"]) == 7


# --- prepared scenes ------------------------------------------------------------------------------


@pytest.mark.parametrize("name", prepared())
def test_prepared_scenes_move_until_their_end(name):
    told = lab.simulated(prepared()[name])
    assert told["stopped"] is None
    assert told["motion"]["end"] == prepared()[name]["seconds"]
    assert told["motion"]["events"]


def test_the_scenes_show_what_they_say():
    motions = {name: lab.simulated(told)["motion"] for name, told in prepared().items()}
    (hit,) = motions["snooker"]["events"]
    a, b = hit["after"].values()
    assert a[0] * b[0] + a[1] * b[1] == pytest.approx(0, abs=1e-9)
    first, *_, last = motions["corner"]["spheres"][0]["pieces"]
    assert last[4:] == pytest.approx([-x for x in first[4:]])
    for hit in motions["angles"]["events"]:
        (u,), (v,) = hit["before"].values(), hit["after"].values()
        assert abs(v[1] / v[0]) / abs(u[1] / u[0]) == pytest.approx(0.6)
    line = motions["newton"]["events"][:4]
    assert [hit["bodies"] for hit in line] == [[*"AB"], [*"BC"], [*"CD"], [*"DE"]]
    assert line[-1]["after"] == {"D": pytest.approx([0, 0]), "E": pytest.approx([1.5, 0])}
    assert len(motions["gas"]["spheres"]) == 45
    assert len(motions["break"]["spheres"]) == 16


# --- questions ------------------------------------------------------------------------------------

speeds = st.floats(-5, 5)
masses = st.one_of(st.floats(0.05, 20), st.sampled_from([1, 2, 0.17, 1 / 3]))
coefficients = st.one_of(st.floats(0, 1), st.sampled_from([0, 1, 0.5, 2 / 3, 3 / 7]))


@st.composite
def impacts(draw):
    """What happens when two bodies meet, one after the other towards each other."""
    turn = draw(st.one_of(st.floats(-math.pi, math.pi), st.sampled_from([0, math.pi / 2, 0.6435])))
    line = [math.cos(turn), math.sin(turn)]
    wall = draw(st.booleans())
    names = draw(st.permutations(["A", "B", "P", "Q1", "G12"]))[: 1 if wall else 2]
    spheres = [
        {"name": name, "mass": draw(masses), "velocity": [draw(speeds), draw(speeds)]}
        for name in names
    ]
    if not wall and draw(st.booleans()):
        spheres[1]["velocity"] = [0.0, 0.0]
    other = [0, 0] if wall else spheres[1]["velocity"]
    u = spheres[0]["velocity"]
    toward = sum((x - y) * c for x, y, c in zip(u, other, line, strict=True))
    if abs(toward) < 1e-3:
        u[0] += line[0]
        u[1] += line[1]
        toward = 1
    if toward < 0:
        line = [-x for x in line]
    return {
        "spheres": spheres,
        "wall": "W" if wall else None,
        "line": line,
        "e": draw(coefficients),
    }


@given(impacts())
@settings(max_examples=60, deadline=None)
def test_a_question_is_read_and_solved(impact):
    statement = lab.question(impact)
    problem = r.parse(statement)
    assert r.to_statement(problem) == statement
    solution = r.solve(problem)
    items = [item for _, item in solution.items()]
    assert items
    assert all(item.error is None for item in items), statement
    # One impact of the bodies told, whose numbers are those of the Lab, rounded.
    (hit,) = [step for _, step in problem.steps() if isinstance(step, Impact)]
    names = [each["name"] for each in impact["spheres"]]
    assert {hit.first, hit.second} == {*[*names, impact["wall"]][:2]}
    assert any(isinstance(step, Find) for _, step in problem.steps())
    # Its answers are what was seen in the Lab, but for rounding.
    fastest = max(math.hypot(*each["velocity"]) for each in impact["spheres"])
    found = {item.text: item for item in items}
    for name, velocity in afterwards(impact).items():
        answer = found[f"velocity({name})"].decimal
        assert math.dist(answer, velocity) <= 0.02 * fastest, statement


def afterwards(impact):
    """The velocities after an impact, by conservation of momentum and Newton's law."""
    first, *rest = impact["spheres"]
    u, m = first["velocity"], first["mass"]
    w, share = (
        (rest[0]["velocity"], rest[0]["mass"] / (m + rest[0]["mass"])) if rest else ((0, 0), 1)
    )
    x, y = impact["line"]
    change = (1 + impact["e"]) * ((u[0] - w[0]) * x + (u[1] - w[1]) * y) / (x * x + y * y)
    found = {first["name"]: [u[0] - share * change * x, u[1] - share * change * y]}
    if rest:
        back = (1 - share) * change
        found[rest[0]["name"]] = [w[0] + back * x, w[1] + back * y]
    return found


def test_numbers_are_tidy():
    statement = lab.question(
        {
            "spheres": [
                {"name": "A", "mass": 0.17, "velocity": [1.23456, -0.4]},
                {"name": "B", "mass": 1 / 3, "velocity": [0, 0]},
            ],
            "wall": None,
            "line": [0.8009, -0.5988],
            "e": 0.6000001,
        }
    )
    assert statement == (
        "title A hits B\n"
        "sphere A: mass 0.17, velocity 1.23i - 0.4j\n"
        "sphere B: mass 1/3, at rest\n"
        "A hits B: e = 0.6, along 4i - 3j\n"
        "find velocity(A), velocity(B), impulse, deflection(A), energy_lost\n"
    )


def test_a_sloping_wall():
    statement = lab.question(
        {
            "spheres": [{"name": "P", "mass": 2, "velocity": [3, -4]}],
            "wall": "W",
            "line": [0, -1],
            "e": 0.5,
        }
    )
    solution = r.solve(r.parse(statement))
    found = {item.item.text: item for _, item in solution.items()}
    assert "wall W: along i" in statement
    assert set(found) == {"velocity(P)", "impulse", "deflection(P)", "energy_lost"}
    sloping = lab.question(
        {
            "spheres": [{"name": "P", "mass": 1, "velocity": [2, 0]}],
            "wall": "W",
            "line": [math.cos(0.7), math.sin(0.7)],
            "e": 1,
        }
    )
    (wall,) = r.parse(sloping).walls
    assert wall.along is not None


def test_who_catches_up_is_the_one_that_hits():
    statement = lab.question(
        {
            "spheres": [
                {"name": "A", "mass": 1, "velocity": [0.5, 0]},
                {"name": "B", "mass": 1, "velocity": [1, 0]},
            ],
            "wall": None,
            "line": [-1, 0],
            "e": 0.5,
        }
    )
    assert "B hits A: e = 0.5, along i" in statement


def test_what_stops_dead_has_no_deflection():
    """Equal masses, head on, e = 1: the first stops, the second was at rest."""
    statement = lab.question(
        {
            "spheres": [
                {"name": "A", "mass": 1, "velocity": [2, 0]},
                {"name": "B", "mass": 1, "velocity": [0, 0]},
            ],
            "wall": None,
            "line": [1, 0],
            "e": 1,
        }
    )
    assert "deflection" not in statement


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ({"e": 2}, "e is 2"),
        ({"line": [0, 0]}, "the line of centres has a direction"),
        ({"line": [-1, 0]}, "hardly approach"),
        ({"wall": "w"}, "named by a capital"),
        ({"wall": "A"}, "an impact is that of two spheres"),
        ({"spheres": []}, "an impact is that of two spheres"),
    ],
)
def test_what_is_no_impact_is_refused(change, what):
    impact = {
        "spheres": [{"name": "A", "mass": 1, "velocity": [1, 0]}],
        "wall": "W",
        "line": [1, 0],
        "e": 1,
    }
    with pytest.raises(r.RestitutionError, match=re.escape(what)):
        lab.question({**impact, **change})


@given(st.floats(0.001, 1000))
def test_numbers_are_written_as_they_are_read(x):
    rounded = simple(x)
    assert Fraction(written(rounded)) == rounded
    assert float(rounded) == pytest.approx(x, rel=6e-3)
