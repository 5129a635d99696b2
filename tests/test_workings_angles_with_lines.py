"""Workings at a wall or a line of centres that is told by its angle, and by results shown above."""

from __future__ import annotations

from functools import cache

import pytest

from restitution.explaining.following.follower import follow
from restitution.language import parse
from restitution.oracle import Oracle
from restitution.planning.planner import plan
from restitution.solving import solve
from restitution.solving.story.letters import roles
from restitution.workings import explain

SAYS = {
    "a wall in degrees": (
        "wall W: along 20°\nsphere P: mass 2, velocity 5 at 60°\nP hits W: e = 1/2\nfind speed(P)",
        ("P moves at 60° − 20° = 40° to W.", "the component stays 5 cos 40°", "(5/2) sin 40°"),
    ),
    "a wall in letters": (
        (
            "wall W: along beta\nsphere P: mass m, velocity u at alpha\ngiven alpha > beta\n"
            "P hits W\nfind speed(P), impulse"
        ),
        (
            "P moves at α − β to W.",
            "the component stays u cos(α − β)",
            "component of 𝐯_P away from W = eu sin(α − β)",
        ),
    ),
    "a line of centres in letters": (
        (
            "sphere A: mass m, velocity u at alpha\nsphere B: mass m, at rest\n"
            "A hits B: along beta\ngiven alpha > beta\nfind speed(A)"
        ),
        ("A moves at α − β to the line of centres.", "mu cos(α − β) = mv + mw"),
    ),
    "two spheres in degrees": (
        (
            "sphere A: mass 2, velocity 5 at 70°\nsphere B: mass 3, at rest\n"
            "A hits B: along 30°, e = 1/2\nfind speed(A), speed(B)"
        ),
        ("A moves at 70° − 30° = 40° to the line of centres.", "2 × 5 cos 40° = 2v + 3w"),
    ),
    "a wall at more than 45°": (
        (
            "wall AB: along i\nwall BC: along 70°\nsphere P: velocity 5 at 50° to AB\n"
            "P hits AB: e = 0.7\nP hits BC: e = 0.6\nfind speed(P)"
        ),
        (
            "component of 𝐯₁ towards BC = 5 sin 70° cos 50° − 3.5 sin 50° cos 70°",
            "= 5 cos 50° cos 70° + 3.5 sin 50° sin 70° ≈ 3.619 m s⁻¹",
        ),
    ),
    "a path at right angles to i": (
        "wall W: along 50°\nsphere P: velocity -7j\nP hits W: e = 3/4\nfind speed(P)",
        ("P moves at 180° − (50° + 90°) = 40° to W.", "¾ × 7 sin 40° = (21/4) sin 40°"),
    ),
    "the angle at the next wall with a calculator": (
        (
            "wall AB: along i\nwall BC: along 70°\nsphere P: velocity 8 at 40° to AB\npart a\n"
            "P hits AB: e = 0.5\nfind speed(P), angle(velocity(P), AB)\npart b\n"
            "P hits BC: e = 0.6\nfind speed(P)"
        ),
        (
            "angle between 𝐯₁ and BC ≈ 180° − 110° − 22.76° ≈ 47.24°",
            "component of 𝐯₁ towards BC ≈ 6.646 sin 47.24° ≈ 4.879 m s⁻¹",
            "component of 𝐯₁ parallel to BC ≈ 6.646 cos 47.24° ≈ 4.512 m s⁻¹",
            "does not change: the component stays 4.512 m s⁻¹.",
        ),
    ),
    "the angle at the next wall that is asked": (
        (
            "wall AB: along i\nwall BC: along 80°\nsphere P: velocity 8 at 38° to AB\n"
            "P hits AB: e = 0.7\nfind speed(P), angle(velocity(P), BC)\n"
            "P hits BC: e = 0.7\nfind speed(P)"
        ),
        (
            "tan β = (5.6 sin 38°)/(8 cos 38°) = 0.7 tan 38°",
            "angle between 𝐯₁ and BC ≈ 180° − 100° − 28.67°",
            "component of 𝐯₁ towards BC ≈ 7.185 sin 51.33° ≈ 5.610 m s⁻¹",
        ),
    ),
    "the angle at the next wall by a standard angle": (
        (
            "wall AB: along i\nwall BC: along 60°\nsphere P: velocity u at 60° to AB\n"
            "P hits AB: e = 1/3\nfind angle(velocity(P), BC)"
        ),
        ("tan β = (√3 u/6)/(u/2) = √3/3", "angle between 𝐯_P and BC = 180° − 120° − 30° = 30°"),
    ),
    "a wall that is sought, at right angles to a path": (
        (
            "wall AB: along i\nwall BC: along 180° - theta\nsphere P: velocity 4 at 60° to AB\n"
            "P hits AB: e = 1/sqrt(3)\ngiven velocity(P) perpendicular to BC\nfind theta"
        ),
        (
            "BC is parallel to −cos θ 𝐢 + sin θ 𝐣, so the scalar product is zero:",
            "−2 cos θ + 2 sin θ = 0",
            "tan θ = 1",
        ),
    ),
    "a wall that is sought, parallel to a path": (
        (
            "wall AB: along i\nwall BC: along theta\nsphere P: velocity 4 at 60° to AB\n"
            "P hits AB: e = 1/sqrt(3)\ngiven velocity(P) parallel to BC\nfind theta"
        ),
        ("so their components are in proportion: 2 cos θ = 2 sin θ", "tan θ = 1"),
    ),
    "two paths with a line of centres": (
        (
            "sphere A: mass 1, velocity 6i\nsphere B: mass 2, velocity 4 at 180° - 48°\n"
            "A hits B: along 20°, e = 0.3\nfind speed(B)"
        ),
        (
            "B moves at 180° − (132° − 20°) = 68° to the line of centres.",
            "≈ √(1.594² + (4 sin 68°)²) ≈ 4.04 m s⁻¹",
        ),
    ),
    "the complement of an angle": (
        (
            "sphere A: mass 1, velocity 6i\nsphere B: mass 2, velocity 4j\n"
            "A hits B: along 20°, e = 0.3\nfind speed(B)"
        ),
        ("the component of B stays 4 sin 70° m s⁻¹", "≈ √(3.218² + (4 sin 70°)²) ≈ 4.95 m s⁻¹"),
    ),
    "an angle that was shown": (
        (
            "wall AB: along i\nwall BC: along 75°\nsphere P: mass m, velocity u at 60° to AB\n"
            "P hits AB: e = 1/3\npart a\nshow angle(velocity(P), AB) = 30°\npart b\n"
            "P hits BC: e = 1/2\nfind speed(P)"
        ),
        (
            "with β from part (a): angle between 𝐯₁ and BC = 180° − 105° − 30° = 45°",
            "(u/2)/cos 30° = √3 u/3",
            "(√3 u/3) sin 45° = √6 u/6",
        ),
    ),
    "a speed that was shown": (
        (
            "wall W: along i\nsphere P: mass m, velocity u at alpha to W\ngiven tan(alpha) = 2\n"
            "P hits W\npart a\nshow speed(P) = u sqrt((1 + 4e^2)/5)\npart b\nfind energy_lost"
        ),
        ("with the speed of P from part (a): kinetic energy lost = ½mu² − ½m(u²(1 + 4e²)/5)",),
    ),
    "the square of a speed that was shown": (
        (
            "sphere A: mass m, velocity u at 60°\nsphere B: mass m, at rest\nA hits B: along i\n"
            "part a\nshow speed(A)^2 = u^2 (13 - 2e + e^2)/16\npart b\nfind energy(A)"
        ),
        ("kinetic energy of A = ½m(u²(13 − 2e + e²)/16)",),
    ),
}


@cache
def _working(text: str) -> str:
    """A printed working, every line of which the follower accepts, with single spaces."""
    solution = solve(parse(text))
    assert follow(plan(solution), Oracle(roles(solution.problem))) == ()
    return " ".join(str(explain(solution)).split())


@pytest.mark.parametrize("name", SAYS)
def test_it_begins_from_the_angle_or_the_result(name: str) -> None:
    statement, phrases = SAYS[name]
    working = _working(statement)
    for phrase in phrases:
        assert phrase in working
    assert "𝐧" not in working
