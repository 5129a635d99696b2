"""The motion of every solved statement: against the principles, the answers and plain geometry."""

from __future__ import annotations

import math
import re

import pytest
import strategies
from hypothesis import HealthCheck, assume, given, settings
from laws_of_motions import CHECKS, extent, size
from test_properties import tell

import restitution as r
from restitution import examples
from restitution.errors import UnsupportedError
from restitution.motion.overlap import overlaps
from restitution.motion.parts import PartMotion, motions
from restitution.motion.pieces import Motion, Piece, Struck, Track, WallLine
from restitution.solving import Solution
from restitution.vector import Vector


def solved(text: str) -> Solution:
    return r.solve(r.parse(text))


# --- all statements -----------------------------------------------------------------------------


@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.filter_too_much])
@given(strategies.tales())
def test_chains_of_impacts_have_motions(tale):
    """Or there are no places for them: they may be told to meet where they cannot."""
    happens = tell(tale)
    assume(happens is not None)
    try:
        found = motions(solved(happens.tale.statement("find speed(A)")))
    except UnsupportedError as error:
        assert re.match("no motion can be shown: (no places fit|. comes to )", error.message)
        return
    for each in found:
        for check in CHECKS:
            check(each)


# --- single ones --------------------------------------------------------------------------------


def only(text: str) -> PartMotion:
    (found,) = motions(solved(text))
    return found


def test_a_distance_at_a_time_is_seen():
    """Two seconds after: by hand, A has −2i + 3j and B i + j, so they are √13 · 2 apart."""
    text = (
        "sphere A: mass 1, velocity 4i + 3j\nsphere B: mass 2, velocity -2i + j\n"
        "A hits B: along i, e = 1/2\nfind distance(A, B, at 2)\n"
    )
    motion = only(text).motion
    assert motion.end > 2
    assert motion.impacts[0].time == pytest.approx(0, abs=1e-12)
    (a, _), (b, _) = motion.at(2.0).values()
    assert size(a - b) == pytest.approx(2 * math.sqrt(13))


def test_given_places_and_times_are_kept():
    motion = only(examples.text("meeting-again")).motion
    assert [hit.time for hit in motion.impacts] == pytest.approx([1, 7 / 3, 19 / 3])
    assert motion.at(3.0)["B"][0] == pytest.approx((10 - 2 / 3, 0))


def test_the_radius_that_is_given_is_kept():
    text = (
        "sphere A, B: mass m, radius 1\nsphere A: at (0, 0), velocity 5i\n"
        "sphere B: at (6.6, 1.2), at rest\nA hits B: e = 1/2\nfind time(1)\n"
    )
    motion = only(text).motion
    assert {one.radius for one in motion.tracks} == {1.0}
    # The centres are 2 apart, 1.2 across the path and so 1.6 along it: 5 m at 5 m/s.
    assert motion.impacts[0].time == pytest.approx(1)


def test_it_ends_before_an_impact_that_is_not_told():
    text = (
        "sphere A, B: mass 1\nsphere A: velocity 3i\nsphere B: at rest\nwall W: along j\n"
        "A hits B: along i, e = 1/2\nB hits W: e = 1\nfind velocity(B)\n"
    )
    motion = only(text).motion
    # By hand: A goes on with 3/4 m/s, and B comes back to it with 9/4 m/s.
    assert motion.notes[-1] == "It ends before A comes to B, which the question does not tell."
    assert overlaps(motion, extent(motion)) == []


def test_a_blow_from_outside_has_its_impulse():
    text = "sphere P: mass 2, at rest\nP receives 4i - 6j\nfind velocity(P)\n"
    (blow,) = only(text).motion.blows
    assert (blow.before, blow.after, blow.impulse) == ((0, 0), (2, -3), (4, -6))


def test_spheres_that_have_nothing_to_do_with_one_another_are_shown_apart():
    text = (
        "wall V: along i\nwall W: along j\nsphere P: velocity i - j\nsphere Q: velocity i + j\n"
        "P hits V: e = 1\nQ hits W: e = 1\nfind velocity(P), velocity(Q)\n"
    )
    assert [each.bodies for each in motions(solved(text))] == [("P",), ("Q",)]


def test_solutions_and_parts_have_motions_of_their_own():
    text = (
        "wall W: along i\nsphere P: mass 1, velocity 4i - 3j\npart a\nP hits W: e = 1/3\n"
        "find speed(P)\npart b\nsphere Q: mass 1, at rest\nP hits Q: along i, e = 1\n"
        "find velocity(P)\n"
    )
    first, second = motions(solved(text))
    assert (first.labels, len(first.motion.impacts)) == (("a",), 1)
    assert (second.labels, len(second.motion.impacts)) == (("b",), 2)
    assert motions(solved(text), "a")[0].labels == ("a",)
    with pytest.raises(KeyError):
        motions(solved(text), "c")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("sphere A: mass 1, velocity 2i\nfind energy(A)\n", "no event is told"),
        (
            (
                "wall W: along i\nsphere P: velocity 3i - 4j\nP hits W\n"
                "given velocity(P) = 3i + 8j\nfind e\n"
            ),
            "e would be 2",
        ),
    ],
)
def test_why_there_is_none(text, reason):
    with pytest.raises(UnsupportedError, match=f"no motion can be shown: {reason}"):
        motions(solved(text))


# --- overlaps -----------------------------------------------------------------------------------


def straight(name: str, place: Vector, velocity: Vector, radius: float = 0.5) -> Track:
    return Track(name, radius, 1.0, (Piece(0.0, 10.0, place, velocity),))


def test_an_overlap_of_spheres_has_its_times():
    """Centres 6 apart close at 2 m/s: 1 m apart after 2.5 s, and again after 3.5 s."""
    tracks = (
        straight("A", Vector(0.0, 0.0), Vector(1.0, 0.0)),
        straight("B", Vector(6.0, 0.0), Vector(-1.0, 0.0)),
    )
    (found,) = overlaps(Motion(tracks, (), (), 0.0, 10.0), 10.0)
    assert (found.first, found.second) == ("A", "B")
    assert (found.start, found.end) == pytest.approx((2.5, 3.5), abs=1e-5)


@pytest.mark.parametrize(
    ("place", "expected"),
    [
        ((0.0, -3.0), (2.5, 3.5)),  # through the middle of the wall
        ((1.0, -3.0), (2.5, 3.5)),  # past its very end
        ((1.3, -3.0), (2.6, 3.4)),  # its end is 0.3 from the path
        ((1.6, -3.0), None),
    ],
)
def test_an_overlap_with_a_wall_knows_its_ends(place, expected):
    wall = WallLine("W", (Vector(-1.0, 0.0), Vector(1.0, 0.0)))
    sphere = straight("P", Vector(*place), Vector(0.0, 1.0))
    found = overlaps(Motion((sphere,), (), (wall,), 0.0, 10.0), 10.0)
    times = [(each.start, each.end) for each in found]
    assert times == ([] if expected is None else [pytest.approx(expected, abs=1e-5)])


def test_points_overlap_where_they_pass_through_a_wall():
    wall = WallLine("W", (Vector(-1.0, 0.0), Vector(1.0, 0.0)))
    sphere = straight("P", Vector(0.0, -3.0), Vector(0.0, 1.0), 0.0)
    (found,) = overlaps(Motion((sphere,), (), (wall,), 0.0, 10.0), 10.0)
    assert found.start <= 3 <= found.end


def test_an_impact_that_is_told_is_no_overlap():
    wall = WallLine("W", (Vector(-1.0, 0.0), Vector(1.0, 0.0)))
    pieces = (
        Piece(0.0, 3.0, Vector(0.0, -3.0), Vector(0.0, 1.0)),
        Piece(3.0, 10.0, Vector(0.0, 0.0), Vector(0.0, -0.5)),
    )
    up, still = Vector(0.0, 1.0), Vector(0.0, 0.0)
    hit = Struck(3.0, "P", "W", still, up, 0.5, up * 1.5, (up, still), (up * -0.5, still))
    motion = Motion((Track("P", 0.0, 1.0, pieces),), (hit,), (wall,), 0.0, 10.0)
    assert overlaps(motion, 10.0) == []
